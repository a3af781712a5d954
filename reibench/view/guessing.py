"""Guessing which object is meant, before the planners try: for an audience that is asked."""

from reibench.episode import Episode
from reibench.scene import Scene
from reibench.skill import PICKABLE, in_words
from reibench.view.dialogue import conversation
from reibench.view.icons import icon_of_type, inline
from reibench.view.markup import element, text
from reibench.view.plan import floor_plan
from reibench.view.plan_geometry import WIDE


def guessing(episode: Episode, scene: Scene) -> str:
    """Return the things of a room to choose among; votes are counted in the browser only.

    Nothing in it tells which is meant.
    """
    types = sorted({thing.type for thing in scene.objects} & set(PICKABLE), key=str.lower)
    buttons = [
        element(
            "button",
            inline(icon_of_type(name), 22),
            element("span", text(in_words(name))),
            element("b", class_="votes num"),
            type="button",
            class_="btn",
            data_guess=name,
        )
        for name in types
    ]
    again = element("button", "Clear", type="button", class_="btn sm quiet", data_do="unguess")
    head = element(
        "div",
        element("h2", "Which object is meant? Guess first."),
        element("span", "One click a vote.", class_="muted grow"),
        again,
        class_="row",
    )
    plan = floor_plan(scene, size=WIDE, label="The room before anybody does anything")
    return element(
        "section",
        element("div", plan, class_="pl show-names"),
        element("div", head, element("div", *buttons, class_="guesses"), _said(episode)),
        class_="guess",
        data_of=episode.id,
    )


def revealed(episode: Episode) -> str:
    """Return what was meant, with room for how the audience had guessed."""
    meant = episode.task.goal.object
    return element(
        "section",
        element("span", "Meant was the ", element("b", text(in_words(meant))), "."),
        element("span", class_="tally"),
        class_="guess over",
        data_of=episode.id,
        data_meant=meant,
        data_word=in_words(meant),
        hidden=True,
    )


def _said(episode: Episode) -> str:
    """Return what was said before the request, nothing in it marked."""
    if not episode.dialogue.context:
        return ""
    title = element("h3", "Said before", class_="label")
    return element("div", title, conversation(episode.dialogue, marked=False), class_="said")
