"""Assembling a script from what the steps gave, and what its vague request leaves open."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from reibench.dataset.build.generation import things_of
from reibench.dataset.build.marking import as_mention, named_mentions
from reibench.dataset.build.processing import Processed
from reibench.dataset.build.seeding import SeedInstruction
from reibench.dataset.levels import said
from reibench.dataset.lexicon import expressions
from reibench.dataset.realise.wording import said_by
from reibench.dataset.scripts import Mention, Passage, Script, Turn
from reibench.dialogue import Vagueness

IMPLICIT_SHORT = Vagueness("implicit", "short")


def assemble(
    seed: SeedInstruction, processed: Processed, vague: Sequence[Sequence[str]], origin: str
) -> Script:
    """Return the marked script of a seed.

    Args:
        seed: the task and its sentence.
        processed: the sentences of every turn, and when they are there.
        vague: by turn, what takes the place of each counted mention but the first ones.
        origin: how it was made.
    """
    things = things_of(seed)
    fresh = {of for of, _ in things if of != "destination"}
    turns = []
    for number, (sentences, words) in enumerate(zip(processed.turns, vague, strict=True)):
        left = iter(words)
        passages = [
            Passage(
                sentence.stay,
                (sentence.text,)
                if sentence.stay == "noise"
                else tuple(_parts(sentence.text, things, left, fresh)),
            )
            for sentence in sentences
        ]
        turns.append(Turn("robot" if number % 2 else "human", tuple(_merged(passages))))
    script = Script(
        id=seed.task.id,
        goal=seed.task.goal,
        setup=seed.task.setup,
        speaker="Alice",
        name=processed.name.text,
        category=processed.name.category,
        decoy=processed.name.decoy,
        turns=tuple(turns),
        origin=origin,
    )
    return with_rivals(script, seed.present)


def _parts(
    text: str, things: Sequence[tuple[str, str]], left: Iterator[str], fresh: set[str]
) -> Iterator[str | Mention]:
    end = 0
    for named in named_mentions(text, things):
        if named.start > end:
            yield text[end : named.start]
        end = named.end
        if named.of == "destination" or named.of in fresh:
            fresh.discard(named.of)
            yield as_mention(named, "")
        else:
            yield as_mention(named, next(left))
    if end < len(text):
        yield text[end:]


def _merged(passages: Sequence[Passage]) -> Iterator[Passage]:
    """Join neighbours that are always there, as a script that is read has them."""
    waiting: Passage | None = None
    for passage in passages:
        if waiting and waiting.stay == passage.stay == "always":
            joined = [*waiting.parts]
            for part in (" ", *passage.parts):
                if isinstance(part, str) and joined and isinstance(joined[-1], str):
                    joined[-1] += part
                else:
                    joined.append(part)
            waiting = replace(waiting, parts=tuple(joined))
            continue
        if waiting:
            yield waiting
        waiting = passage
    if waiting:
        yield waiting


def with_rivals(script: Script, present: Sequence[str]) -> Script:
    """Note which types of the room the request's words could also mean, as the lexicon knows them.

    Words that the lexicon does not know, and pronouns, are taken to have none.
    """
    last = len(script.turns) - 1
    rivals: dict[str, str] = {}
    for of, name in (("object", script.goal.object), ("movable", script.goal.movable_receptacle)):
        mine = [(number, p.stay, m) for number, p, m in script.mentions if m.of == of]
        if not name or not mine:
            continue
        first = mine[0][2].named
        clues = {
            m.unnamed: fits
            for number, stay, m in mine
            if number < last and stay == "always" and (fits := _fits(name, m.unnamed)) is not None
        }
        asked = [
            fits for n, _, m in mine if n == last and (fits := _fits(name, m.unnamed)) is not None
        ]
        others = (asked[0] if asked else frozenset()) & set(present)
        others -= {script.goal.object, script.goal.movable_receptacle}
        for other in sorted(others):
            rivals[other] = next((text for text, fits in clues.items() if other not in fits), first)
    kept = replace(script, rivals=rivals)
    open_here = [o for o, why in rivals.items() if not said(kept, why, IMPLICIT_SHORT)]
    if not open_here:
        return kept
    return replace(kept, candidates={IMPLICIT_SHORT: (script.goal.object, *open_here)})


def _fits(name: str, text: str) -> frozenset[str] | None:
    """Return what else an expression of the lexicon fits; None if it does not know the words."""
    for each in expressions().get(name, ()):
        if text.lower() in (each.text.lower(), said_by(each.text, "robot").lower()):
            return each.also_fits
    return None
