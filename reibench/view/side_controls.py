"""What stands above two runs beside each other: their title, and the buttons that move them."""

from reibench.episode import Episode
from reibench.view.markup import classes, element, text
from reibench.view.topbar import episode_chips


def comparison_bar(
    episode: Episode, method: str, *, begun: bool, running: bool, recorded: bool
) -> str:
    """Return the title, what it is of, and what can be done with it now."""
    if running:
        controls = [_button("Stop", "stop", "stop")]
    elif not begun:
        controls = [_button("Watch both", "watch", "primary")]
    else:
        controls = _player()
        if not recorded:
            controls.append(_button("Again", "watch", "quiet"))
    if not recorded:
        controls.append(
            element(
                "button",
                "×",
                type="button",
                class_="btn icon quiet",
                data_do="leave",
                aria_label="Back to acting myself",
                title="Back (Esc)",
            )
        )
    title = element("h2", f"One instruction, without and with {text(method)}")
    chips = episode_chips(episode)
    return element("div", title, chips, element("span", class_="grow"), *controls, class_="head")


def _player() -> list[str]:
    """Return what walks through two runs that are over."""
    return [
        _control("first", "M1 1.500h2v9h-2zM11 1.500v9L4 6z", "First step (Home)"),
        _control("back", "M9.500 1.500v9L2.500 6z", "Back (←)"),
        _button(element("span", "Play"), "play", "primary play", key="Space"),
        _control("forward", "M2.500 1.500v9L9.500 6z", "Forward (→)"),
        _button("To divergence", "split", "", key="V"),
        _button("Present", "present", "hide-m", key="P"),
    ]


def _button(words: str, what: str, look: str, *, key: str = "") -> str:
    hint = element("kbd", key, class_="hide-m") if key else ""
    return element("button", words, hint, type="button", class_=classes("btn", look), data_do=what)


def lead(method: str) -> str:
    """Return what a first visitor should know."""
    words = (
        "A language model plans for a household robot. Left, it takes the vague words as they are;"
        f" right, {method} restates them first. These two runs are recordings."
    )
    live, act = _button("Run live", "watch", "sm"), _button("Act yourself", "leave", "sm")
    more = element("a", "More cases", href="/cases?kind=helps", class_="btn sm")
    return element("div", element("p", text(words)), live, act, more, class_="lead")


def _control(what: str, shape: str, words: str) -> str:
    sign = element("path", d=shape, fill="currentColor")
    return element(
        "button",
        element("svg", sign, viewbox="0 0 12 12", width=14, aria_hidden="true"),
        type="button",
        class_="btn icon",
        data_do=what,
        aria_label=words,
        title=words,
    )
