"""What participants see: nothing of how vague a request is, or whether it was carried out."""

from collections.abc import Sequence

from markdown_it import MarkdownIt

from reibench.rollout import Step
from reibench.view.dialogue import conversation
from reibench.view.markup import classes, element, text
from reibench.view.room_panel import room_panel
from reibench.view.screens import scenes_of
from reibench.view.steps import announcement, budget, step_list
from reibench.watching import Sitting
from study.config import Study
from study.forms import button, form, outcome
from study.stages import Page

STEPS = ("Consent", "Practice", "Quiz", "Tasks", "Questions")
"""What the bar calls the stages; people see no others."""
_AT = {"consent": 0, "tutorial": 1, "practice": 1, "quiz": 2, "trial": 3, "after": 3, "end": 4}
_MARKDOWN = MarkdownIt("commonmark", {"html": False})


def where(page: Page) -> str:
    """Return what tells the page's scripts where the participant is; they see nothing of it."""
    playing = page.sitting is not None
    step = len(page.sitting.steps) + 1 if page.sitting else 0
    return element(
        "i",
        hidden=True,
        id="where",
        data_stage=page.stage,
        data_place=page.place,
        data_step=step,
        data_attempt=page.participant.quiz_tries if page.stage == "quiz" else None,
        data_view="play" if playing else "card",
        data_shows=page.study.shows,
        data_left=None if page.seconds_left is None else round(max(page.seconds_left, 0)) + 1,
        data_limit=round(60 * page.study.trial_minutes) or None,
    )


def header(page: Page) -> str:
    """Return the bar: which study, how far, help, and the way out."""
    title = element("b", text(page.study.title), class_="brand")
    return element(
        "header",
        element(
            "nav",
            title,
            _progress(page),
            element("span", class_="grow"),
            *_ways(page),
            class_="nav",
            aria_label="Study",
        ),
        class_="top",
    )


def _progress(page: Page) -> str:
    if page.stage in ("trial", "after", "outcome"):
        marks = [
            element("i", class_=classes(done=at < page.place, now=at == page.place))
            for at in range(page.study.trials)
        ]
        words = element("b", f"Task {page.place + 1} of {page.study.trials}")
        return element("span", words, element("span", *marks, class_="ticks"), class_="progress")
    now = _AT.get(page.stage, len(STEPS))
    items = [
        element(
            "li",
            element("span", str(at + 1), class_="n"),
            text(name),
            class_=classes("hide-m" if at != now else "", done=at < now, now=at == now),
            aria_current="step" if at == now else None,
        )
        for at, name in enumerate(STEPS)
    ]
    return element("ol", *items, class_="stages")


def _ways(page: Page) -> list[str]:
    if page.stage in ("consent", "over") and not page.stopped:
        return []
    kept = element("span", "Everything is saved", class_="small muted hide-m")
    ways = [kept, button("Help", "help", "btn sm")] if page.stage != "tutorial" else [kept]
    leave = element("span", "Leave") + element("span", "the study", class_="hide-m")
    away = element(
        "button",
        leave,
        type="button",
        class_="btn sm quiet",
        data_do="leave-study",
        aria_label="Leave the study",
    )
    return [*ways, away]


# pages to read and to answer


def card(page: Page, notice: str = "") -> str:
    """Return the page of a stage that is no task."""
    told = element("p", text(notice), class_="notice bad", role="alert") if notice else ""
    if page.sitting:
        return ""
    match page.stage:
        case "consent":
            parts = [_read(page.study, "consent"), _identifiers(page.study), told, _consent()]
        case "tutorial":
            go = button("Continue", "read", "btn primary")
            row = element("div", go, class_="row end")
            parts = [_read(page.study, "tutorial"), _practised(page.study), told, row]
        case "outcome":
            parts = [outcome(page)]
        case "over":
            parts = [_over(page)]
        case _:
            parts = [form(page, told)]
    return element("main", *parts, class_="card", id="card", tabindex="-1")


def leaving() -> str:
    """Return what asks whether somebody really wants to leave."""
    words = element("p", "If you leave, your answers are deleted and you cannot come back.")
    ways = element(
        "div",
        button("Stay", "stay", "btn primary"),
        element("span", class_="grow"),
        button("Leave and delete my answers", "withdraw", "btn"),
        class_="row",
    )
    inside = element("h2", "Leave the study?") + words + ways
    return element(
        "dialog", inside, id="leaving", class_="ask-again", aria_label="Leave the study?"
    )


def helping(study: Study) -> str:
    """Return the instructions to read again."""
    close = element("div", button("Close", "close-help", "btn primary"), class_="row end")
    return element(
        "dialog",
        _read(study, "tutorial"),
        close,
        id="helping",
        class_="ask-again prose",
        aria_label="Instructions",
    )


def _read(study: Study, what: str) -> str:
    """Return one of the study's texts, with its own numbers where the text names them."""
    words = study.texts[what]
    limit = f"{study.trial_minutes:g} minutes" if study.trial_minutes else "as long as you like"
    for name, value in (
        ("max_steps", study.max_steps), ("trials", study.trials), ("time", limit),
    ):  # fmt: skip
        words = words.replace(f"{{{name}}}", str(value))
    return element("div", str(_MARKDOWN.render(words)), class_="read")


def _practised(study: Study) -> str:
    if not study.practice:
        return ""
    return element("p", "First there is a task to practise, with hints. It does not count.")


def _identifiers(study: Study) -> str:
    """Say what of the link is kept, for it may tell who somebody is to whoever sent them."""
    if not study.parameters:
        return ""
    names = ", ".join(study.parameters)
    return element(
        "p",
        text(
            f"Kept beside the code, where your link has it, is what the service that sent you calls"
            f" you ({names}), so that your part can be accepted there. It is deleted if you do not"
            " agree, or leave."
        ),
        class_="small",
    )


def _consent() -> str:
    box = element("input", type="checkbox", id="agree")
    agree = element("label", box, "I am 18 or older and I agree to take part.", class_="answer")
    ways = element(
        "div",
        button("I do not agree", "decline", "btn"),
        element("span", class_="grow"),
        element(
            "button",
            "Continue",
            type="button",
            class_="btn primary",
            data_do="agree",
            disabled=True,
        ),
        class_="row",
    )
    return agree + ways


def _over(page: Page) -> str:
    if page.stopped:
        words = "This study has been stopped. What you have done is kept. Thank you for your time."
        return element("h1", "The study was stopped") + element("p", words, role="status")
    if page.ending == "completed":
        parts = [_read(page.study, "debrief")]
    else:
        said = {
            "no_consent": "You have not agreed to take part, and nothing about you is kept.",
            "failed_check": "The questions about the instructions were not answered as they should"
            " be, so the study ends here. Thank you for your time.",
            "withdrawn": "You have left the study, and your answers are deleted.",
        }
        words = said.get(page.ending or "", "Your part in it has been ended. Thank you.")
        parts = [element("h1", "The study is over"), element("p", words)]
    if page.code:
        code = element("b", text(page.code), class_="code", id="code")
        parts.append(element("p", "Your code: ", code))
    if page.link:
        parts.append(element("a", "Go back", href=page.link, class_="btn primary"))
    return "".join(parts)


# playing


def talk(sitting: Sitting) -> str:
    """Return what was said, nothing in it marked."""
    header = element("header", element("h2", "Read the conversation"))
    said = conversation(sitting.episode.dialogue, marked=False)
    return element("section", header, said, class_="talking", aria_label="Conversation")


def room(sitting: Sitting) -> str:
    """Return the room, without its number."""
    return room_panel(scenes_of(sitting), live=True, called="The room")


def actions(page: Page, sitting: Sitting, notice: str = "") -> str:
    """Return what was done and the button that ends the task."""
    empty = "Nothing done yet. Type an action, or choose a thing in the room."
    if page.study.shows == "text":
        empty = "Nothing done yet. Type an action."
    parts = [budget(len(sitting.steps), sitting.max_steps), step_list(sitting.steps, empty=empty)]
    if page.stage == "practice":
        parts.append(_practice(sitting))
    if page.seconds_left is not None:
        bar = element("span", element("i"), class_="bar", id="time")
        parts.append(
            element("div", element("h3", "Time", class_="label"), bar, class_="row budget")
        )
    if notice:
        parts.append(element("p", text(notice), class_="notice", role="status"))
    hint = element("span", "Press it when you think that the wish is carried out.", class_="small")
    done = element("button", "I'm done", type="button", class_="btn primary done", data_do="done")
    parts.append(element("div", hint, element("span", class_="grow"), done, class_="row buttons"))
    held = sitting.event.scene.held
    return element(
        "section",
        *parts,
        class_="act",
        id="act",
        aria_label="Your actions so far",
        data_sitting=f"{page.stage}-{page.place}",
        data_expected=len(sitting.steps) + 1,
        data_over="false",
        data_running="false",
        data_announce=announcement(sitting.steps[-1]) if sitting.steps else "",
        data_held=held.type if held else "",
    )


def _practice(sitting: Sitting) -> str:
    """Return what helps with the practice task: what to try next, from what is true now."""
    met = [condition.holds for condition in sitting.event.goals]
    words = _next_words(sitting.steps, held=sitting.event.scene.held is not None, done=all(met))
    return element("p", element("b", "Practice. "), text(words), class_="notice", role="status")


def _next_words(steps: Sequence[Step], *, held: bool, done: bool) -> str:
    if done:
        return "That is what was asked for. Press I'm done to go on."
    if steps and not steps[-1].event.success:
        return "That was refused. The list says why: do what is missing first, then try again."
    if not steps:
        return (
            "First go to the thing that is meant: type find and part of its name, choose it in the"
            " list, and press Enter."
        )
    if held:
        return "You hold it. Now find the place where it should go, and put it down there."
    return "Now pick it up. If something is in the way, the list of your actions says what."
