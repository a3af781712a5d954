"""Step 2, context processing: an ambiguous name goes in, sentences go out (appendix B.2)."""

from collections.abc import Sequence
from dataclasses import dataclass
from random import Random

from reibench.dataset.build.asking import Asker, Unfit
from reibench.dataset.build.generation import things_of
from reibench.dataset.build.marking import named_mentions
from reibench.dataset.build.seeding import SeedInstruction
from reibench.dataset.build.speech import in_sentences, read_dialogue, show
from reibench.dataset.forms import names, says
from reibench.dataset.realise.nouns import Name, ambiguous_names
from reibench.dataset.scripts import Stay

NOISE = """\
Here is the dialogue:

{dialogue}

We are now going to adapt the previous dialogue.

Requirements:

1. Please add content only within the dialogue without deleting any existing content or changing \
the order of the dialogue.

2. Please do not change the number of turns in the dialogue. Please do not change the structure of \
the dialogue.

3. Please ensure the fluency of the dialogue.

4. Please add whole sentences only, to the lines of Human, and none to the last line.

Please follow the requirements below for the adaptation.

Associated Name Background:
{background} Please have Alice mention {name} 3 times when discussing anything related to the \
{words}, but without changing the existing meaning of the conversation.

{details}

"""
"""The paper's, but for requirement 4, which is ours: its own example hangs a sentence on the
instruction and others on their neighbours, so that the levels could not be told apart by program.
The paper gives no prompt for leaving sentences out (its example strikes some through), nor for
names that are brands: what goes is chosen by rule, and the background is told by category."""

BACKGROUNDS = {
    "family member": "There is another member (a human) of the family named {name}.",
    "friend": "Alice has a friend (a human) named {name}.",
    "neighbor": "There is a neighbor (a human) named {name}.",
    "colleague": "Alice has a colleague (a human) named {name}.",
    "stranger": "A stranger (a human) named {name} telephoned Alice lately.",
    "electronics brand": "There is an electronics brand called {name}.",
    "restaurant brand": "There is a restaurant called {name}.",
}
DETAILS = """\
Some details of {name}: He is warm-hearted, a bit of a goofball, but deeply caring. He has a \
natural curiosity and a love for teaching, which often spills over into his family life. His humor \
is a bit cheesy, and he often makes corny science jokes, much to his kids' embarrassment. He is a \
dedicated husband and a father of two. He's the peacekeeper in the household and often plays the \
role of the mediator between his kids and his wife when disagreements arise."""
"""The paper's, of a person."""
BRAND_DETAILS = "Some details of {name}: everybody has an opinion on it, and Alice has one, too."

MENTIONS = 3
CUT = 2
"""Sentences that the short context leaves out, at the least; three where there are enough."""


@dataclass(frozen=True)
class Sentence:
    """A sentence of the noised dialogue, and when it is there."""

    text: str
    stay: Stay


@dataclass(frozen=True)
class Processed:
    """A dialogue with its noise and its gaps."""

    name: Name
    turns: tuple[tuple[Sentence, ...], ...]


def process(seed: SeedInstruction, turns: Sequence[str], asker: Asker) -> Processed:
    """Return the dialogue with noise and gaps; raises Unfit."""
    name = _name(seed)
    brand = name.category.endswith("brand")
    prompt = NOISE.format(
        dialogue=show(turns),
        background=BACKGROUNDS[name.category].format(name=name.text),
        name=name.text,
        words=" and the ".join(names()[each].words[-1] for each in seed.counted),
        details=(BRAND_DETAILS if brand else DETAILS).format(name=name.text),
    )

    def read(answer: str) -> list[list[Sentence]]:
        return align(turns, read_dialogue(answer), name.text)

    noisy = asker.ask(prompt, read)
    return Processed(name, tuple(tuple(turn) for turn in leave_out(seed, noisy)))


def _name(seed: SeedInstruction) -> Name:
    """Choose a name that looks like something in the room, the same for the same seed."""
    words = [word for name in seed.counted for word in names()[name].words]
    there = {*seed.present} - {*seed.counted, seed.task.goal.destination}
    fitting = [
        name
        for name in ambiguous_names()
        if name.decoy in there and not any(says(name.text, word) for word in words)
    ]
    if not fitting:
        raise Unfit("no name looks like anything here", "No ambiguous name fits the room.")
    return Random(seed.task.id).choice(fitting)


def align(before: Sequence[str], after: Sequence[str], name: str) -> list[list[Sentence]]:
    """Return the sentences of `after`, those marked as noise that `before` lacks.

    Raises:
        Unfit: when anything else changed, or the name is not said three times where it may be.
    """
    turns: list[list[Sentence]] = []
    said = 0
    for number, (old, new) in enumerate(
        zip(in_sentences(before), in_sentences(after), strict=True)
    ):
        rest = list(old)
        turn: list[Sentence] = []
        for text in new:
            if rest and text == rest[0]:
                turn.append(Sentence(rest.pop(0), "always"))
                continue
            _check_noise(number, text, name, len(before))
            said += text.count(name)
            turn.append(Sentence(text, "noise"))
        if rest:
            raise Unfit(
                "changes what was said",
                f"Every sentence of line {number + 1} must stay as it was: {rest[0]!r} is missing.",
            )
        turns.append(turn)
    if said != MENTIONS:
        raise Unfit("the name is not said three times", f"{name} is said {said} times, not 3.")
    return turns


def _check_noise(number: int, text: str, name: str, turns: int) -> None:
    if name not in text:
        raise Unfit(
            "adds something else", f"Every sentence that is added must mention {name}: {text!r}."
        )
    if number % 2 or number == turns - 1:
        raise Unfit(
            "the name is in the wrong turn",
            f"Only Human may mention {name}, and not in the last line.",
        )


def leave_out(seed: SeedInstruction, turns: list[list[Sentence]]) -> list[list[Sentence]]:
    """Mark what the short contexts leave out: first mentions, and questions before other sentences.

    Raises:
        Unfit: when a turn would be empty, or too little can go.
    """
    things = [pair for pair in things_of(seed) if pair[0] != "destination"]
    fresh = {of for of, _ in things}
    marked = [list(turn) for turn in turns]
    for turn in marked[:-1]:
        for place, sentence in enumerate(turn):
            of = {m.of for m in named_mentions(sentence.text, things)} & fresh
            if of and sentence.stay == "always":
                turn[place] = Sentence(sentence.text, "first")
                fresh -= of
        if all(sentence.stay == "first" for sentence in turn):
            raise Unfit(
                "nothing is left of a turn", "The first mention needs a sentence beside it."
            )
    _cut(marked, things)
    return marked


def _cut(turns: list[list[Sentence]], things: Sequence[tuple[str, str]]) -> None:
    """Mark up to three sentences as left out, so that names and something else are left."""
    options = [
        (number, place)
        for number, turn in enumerate(turns[:-1])
        for place, sentence in enumerate(turn)
        if sentence.stay == "always"
    ]
    options.sort(key=lambda at: (not turns[at[0]][at[1]].text.endswith("?"), at))
    cut: set[tuple[int, int]] = set()
    for number, place in options:
        left = [s for p, s in enumerate(turns[number]) if s.stay == "always" and p != place]
        left = [s for s in left if (number, turns[number].index(s)) not in cut]
        spoken = number not in {n for n, _ in cut}  # one of a turn, so that talk stays talk
        if left and spoken and _still_named(turns, things, cut | {(number, place)}):
            cut.add((number, place))
        if len(cut) > CUT:
            break
    if len(cut) < CUT:
        raise Unfit("too little can be left out", "The lines need more than one sentence each.")
    for number, place in cut:
        turns[number][place] = Sentence(turns[number][place].text, "cut")


def _still_named(
    turns: list[list[Sentence]], things: Sequence[tuple[str, str]], cut: set[tuple[int, int]]
) -> bool:
    """Whether explicit short would still name every task object, apart from first mentions."""
    left = " ".join(
        sentence.text
        for number, turn in enumerate(turns[:-1])
        for place, sentence in enumerate(turn)
        if sentence.stay == "always" and (number, place) not in cut
    )
    found = {mention.of for mention in named_mentions(left, things)}
    return found == {of for of, _ in things}
