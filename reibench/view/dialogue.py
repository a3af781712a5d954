"""The conversation as bubbles, and the pending instruction set apart from it."""

from reibench.dialogue import Dialogue, ReferringExpression, Utterance
from reibench.skill import in_words
from reibench.view.markup import classes, element, text


def conversation(dialogue: Dialogue, *, marked: bool = True) -> str:
    """Return the dialogue: what was said before as bubbles, then the pending instruction.

    Args:
        dialogue: what to show.
        marked: whether referring expressions can be highlighted and say what they stand for;
            without it nothing in the page tells (participants must not see them).
    """
    said = [
        element(
            "div",
            element("span", _speaker(utterance), class_="who"),
            utterance_text(utterance, marked=marked),
            class_=f"msg {'h' if utterance.speaker == 'human' else 'r'}",
        )
        for utterance in dialogue.context
    ]
    bubbles = element("div", *said, class_="talk", tabindex="0", aria_label="What was said before")
    return bubbles + instruction_box(dialogue, marked=marked)


def instruction_box(dialogue: Dialogue, *, marked: bool = True) -> str:
    """Return the pending instruction in the page's only tinted box."""
    unfold = element(
        "button",
        "Dialogue",
        class_="unfold m-only",
        type="button",
        data_do="unfold",
        aria_expanded="false",
    )
    heading = element(
        "div",
        element("h3", "Instruction to carry out"),
        element("span", "Human", class_="hide-m"),
        unfold if dialogue.context else "",
        class_="who",
    )
    said = element("p", utterance_text(dialogue.instruction, marked=marked))
    return element("div", heading, said, class_="ask")


def utterance_text(utterance: Utterance, *, marked: bool = True) -> str:
    """Return the words of `utterance`, its referring expressions marked if wanted."""
    if not marked:
        return text(utterance.text)
    parts, at = [], 0
    for expression in sorted(utterance.expressions, key=lambda each: each.start):
        if expression.start < at:
            continue
        parts.append(text(utterance.text[at : expression.start]))
        parts.append(_expression(expression))
        at = expression.end
    return "".join([*parts, text(utterance.text[at:])])


def _expression(expression: ReferringExpression) -> str:
    stands_for = referent(expression)
    note = element("sup", text(stands_for)) if not expression.explicit else ""
    return element(
        "span",
        text(expression.text),
        note,
        class_=classes("re", ex=expression.explicit, noise=expression.is_noise),
        data_type=None if expression.is_noise else expression.referent,
        title=stands_for,
    )


def referent(expression: ReferringExpression) -> str:
    """Return in words what `expression` stands for."""
    if expression.is_noise:
        return f"{expression.referent.removeprefix('@')}, a name"
    return in_words(expression.referent)


def _speaker(utterance: Utterance) -> str:
    return "Human" if utterance.speaker == "human" else "Robot"
