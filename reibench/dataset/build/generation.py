"""Step 1, context generation: from a seed instruction to an explicit dialogue (appendix B.1)."""

from collections.abc import Sequence

from reibench.dataset.build.asking import Asker, Unfit
from reibench.dataset.build.marking import named_mentions, stray_pronoun
from reibench.dataset.build.seeding import SeedInstruction
from reibench.dataset.build.speech import (
    check_lengths,
    read_dialogue,
    show,
)
from reibench.dataset.forms import names, says
from reibench.dataset.levels import derive
from reibench.dataset.script_check import NAMED_IN_CONTEXT
from reibench.dataset.scripts import Script

IDENTIFYING = """\
I will input a task, and you should output only the task objects mentioned in the task. There may \
be multiple task objects. If so, please separate them with commas.

Here are some examples:

Task: Place a vase on a coffee table

Referring Expressions: vase

Task: Put the chilled sliced tomato in the microwave

Referring Expressions: tomato

Task: Pick up a pillow and turn a lamp on

Referring Expressions: pillow, lamp

Task: {seed}

Referring Expressions:"""
"""The paper's, as it stands."""

GENERATION = """\
Please integrate this sentence into a script as dialogue: {seed}

Scene description:

Alice and her home robot are at home, with only the following items in the environment: {scene}.

Please do not mention any requirements outside the list.

Requirements:

1. The dialogue content of "{seed}" should be included in Alice's final instruction. Please have \
Alice state the request mentioned above only in the last sentence and refrain from making any \
other requests.

2. Before making this request, Alice should mention some other requirements related to the {words}.

3. There should be six rounds of dialogue before this request. Each character's lines should \
contain no fewer than 20 words, and no actions should be included for any character.

4. Please do not output anything other than the dialogue.

5. Please try to retain the words of {words} themselves in the conversation, rather than replacing \
them with pronouns like "it."

Below, I will give you an example:

{example}

The dialogue for: {seed}

"""
"""The paper's. Its gaps: the scene there is one fixed list, here it is the seed's own room; the
example is not said to be the one shown below the prompt, which breaks requirement 5 itself ("with
them"), so ours is one of the written dialogues; `six rounds` are six turns, as in that example; and
what the dialogue is to be written as (`Human:`, `Robot:`) is only seen there."""


def generate(seed: SeedInstruction, asker: Asker, examples: Sequence[Script]) -> tuple[str, ...]:
    """Return an explicit dialogue of six turns and the request; raises Unfit."""
    words = identify(seed, asker)
    prompt = GENERATION.format(
        seed=seed.text,
        scene=", ".join(seed.present),
        words=" and the ".join(words),
        example=_example(seed, examples),
    )

    def read(answer: str) -> tuple[str, ...]:
        turns = read_dialogue(answer)
        check_lengths(turns)
        check_explicit(seed, turns)
        return turns

    return asker.ask(prompt, read, stop=("\n\nHuman:", "\nTask:"))


def identify(seed: SeedInstruction, asker: Asker) -> list[str]:
    """Return the words of the seed that name its task objects; raises Unfit."""

    def read(answer: str) -> list[str]:
        given = [part.strip(" .\"'*").lower() for part in answer.strip().split("\n")[0].split(",")]
        found = []
        for name in seed.counted:
            mine = [part for part in given if any(says(part, word) for word in names()[name].words)]
            if not mine or not says(seed.text, mine[0]):
                raise Unfit(
                    "a task object is not identified",
                    f"{answer.strip()[:80]!r} does not give the task objects in {seed.text!r}.",
                )
            found.append(mine[0])
        return found

    return asker.ask(IDENTIFYING.format(seed=seed.text), read, stop=("\n\n", "\nTask:"))


def things_of(seed: SeedInstruction) -> list[tuple[str, str]]:
    """Return what mentions may be of, with the types."""
    goal = seed.task.goal
    pairs = [("object", goal.object), ("movable", goal.movable_receptacle)]
    return [*filter(lambda pair: pair[1], pairs), ("destination", goal.destination)]


def check_explicit(seed: SeedInstruction, turns: Sequence[str]) -> None:
    """Raise Unfit when a dialogue does not obey the counting rule of the explicit level (B.4)."""
    things = things_of(seed)
    marks = [named_mentions(text, things) for text in turns]
    for of, name in things:
        word = names()[name].words[-1] if name in names() else name
        context = sum(mention.of == of for mine in marks[:-1] for mention in mine)
        request = sum(mention.of == of for mention in marks[-1])
        if of != "destination" and context < NAMED_IN_CONTEXT:
            raise Unfit(
                "too few named mentions",
                f"The {word} must be named at least {NAMED_IN_CONTEXT} times before the last line;"
                f" it is named {context} times.",
            )
        if not request:
            raise Unfit(f"the request lacks the {of}", f"The last line must name the {word}.")
    for text, mine in zip(turns, marks, strict=True):
        if pronoun := stray_pronoun(text, mine, things):
            raise Unfit(
                "a pronoun at the explicit level",
                f"Say the thing's name instead of {pronoun!r} in {text[:90]!r}.",
            )


def _example(seed: SeedInstruction, examples: Sequence[Script]) -> str:
    """Return a written dialogue about something else, of the same type where there is one."""
    others = [script for script in examples if script.goal.object not in seed.counted]
    alike = [s for s in others if s.goal.task_type is seed.task.goal.task_type]
    explicit = derive((alike or others)[0])[0]
    return show([utterance.text for utterance in explicit.dialogue.utterances])
