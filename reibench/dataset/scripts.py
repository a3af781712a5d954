"""Scripts: one dialogue per seed task, marked so that all nine levels derive from it by program.

A script file holds scripts one after another:

    # pick_keys
    task: pick KeyChain > Drawer
    room: living-room-1, seed 4
    speaker: retired bus driver, 70s
    name: Mr. Box, neighbor, Box
    rivals: Watch (drove the number 14); CellPhone
    underdetermined: implicit-short KeyChain CellPhone

    H {!I can't hold on to [my own house keys].} Tie [the keys|them] to me. {+Mr. Box says so.}
    R A belt would do it. {-A bright ribbon would make [your keys|those things] easier to spot.}
    …
    > Go on, then. Put [the keys|them] away in <the drawer> for me.

`[named|unnamed]` mentions the task object, `[2:named|unnamed]` the movable receptacle, `[1+2:…]`
both; the first mention of each needs no unnamed form. `<…>` names the destination or lamp. `{+…}`
are sentences that only the noised and the short context hold, `{-…}` ones the short context leaves
out, `{!…}` ones that only the implicit short one leaves out (the first mention's). `rivals` are the
types of the room that the instruction's unnamed words, taken alone, could also mean, each with the
words of the context that rule it out.
"""

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal

from reibench.dialogue import LEVELS, Speaker, Vagueness
from reibench.episode import Goal, SceneSetup, TaskType
from reibench.errors import InvalidEpisode, ReibenchError

SCRIPTS = Path(__file__).parents[2] / "assets" / "scripts"
"""Where the project's own scripts are."""
Stay = Literal["always", "noise", "cut", "first"]
"""When a sentence is there: always; only with noise; not in short; not in implicit short."""
_MARKS: Mapping[str, Stay] = {"+": "noise", "-": "cut", "!": "first"}
_SPEAKERS: Mapping[str, Speaker] = {"H": "human", "R": "robot", ">": "human"}
_BLOCK = re.compile(r"\{([+\-!])([^{}]*)\}|([^{}]+)")
_PART = re.compile(r"\[(?:([12](?:\+[12])?):)?([^\[\]|<>]+)(?:\|([^\[\]|<>]+))?\]|<([^<>\[\]]+)>")
_RIVAL = re.compile(r"(\w+)(?: \((.+)\))?")
_TASK = re.compile(r"(\w+) (\w+)(?: in (\w+))? > (\w+)")


@dataclass(frozen=True)
class Mention:
    """A place where a thing of the room is spoken of."""

    named: str
    unnamed: str
    """Empty for a destination, and for a first mention that is never without its name."""
    of: str
    """`object`, `movable`, `object+movable` or `destination`."""


@dataclass(frozen=True)
class Passage:
    """One or more sentences that come and go together."""

    stay: Stay
    parts: tuple[str | Mention, ...]

    @property
    def mentions(self) -> Iterator[Mention]:
        """The mentions in it, in order."""
        return (part for part in self.parts if isinstance(part, Mention))


@dataclass(frozen=True)
class Turn:
    """What one of the two says in one go."""

    speaker: Speaker
    passages: tuple[Passage, ...]


@dataclass(frozen=True)
class Script:
    """A seed task with the dialogue that asks for it, at all levels at once."""

    id: str
    goal: Goal
    setup: SceneSetup
    speaker: str
    """Who speaks: work or family, age."""
    name: str
    """The ambiguous name, e.g. `Mr. Box`."""
    category: str
    """What bears it: neighbor, friend, electronics brand … (appendix B.2)."""
    decoy: str
    """The object type the name looks like."""
    turns: tuple[Turn, ...]
    """Six of context, then the instruction."""
    rivals: Mapping[str, str] = field(default_factory=dict)
    """Types of the room that the instruction's unnamed words alone could also mean, each with the
    words of the context that rule it out; empty words where nothing does."""
    candidates: Mapping[Vagueness, tuple[str, ...]] = field(default_factory=dict)
    """Where a careful listener cannot decide: the types left, the meant one first."""
    origin: str = ""
    """How it was made, unless a person wrote it: `realised`, `model:NAME` …"""

    @property
    def mentions(self) -> Iterator[tuple[int, Passage, Mention]]:
        """Every mention with its passage and the number of its turn, from 0."""
        for number, turn in enumerate(self.turns):
            for passage in turn.passages:
                for mention in passage.mentions:
                    yield number, passage, mention


def read_scripts(path: Path) -> list[Script]:
    """Read a script file; raises InvalidEpisode naming the script and line that is wrong."""
    try:
        lines = path.read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError) as problem:
        raise InvalidEpisode(f"The script file {path} cannot be read: {problem}.") from problem
    found: list[Script] = []
    block: list[tuple[int, str]] = []
    for number, line in enumerate([*lines, "# "], start=1):
        if line.startswith("# "):
            if block:
                found.append(_read(path, block))
            block = []
        if line.strip():
            block.append((number, line.strip()))
    return found


def shipped_scripts() -> list[Script]:
    """Return the project's own scripts: the six that set the standard first, then type by type."""
    paths = sorted(SCRIPTS.glob("*.txt"), key=lambda path: (path.stem != "gold", path.name))
    return [script for path in paths for script in read_scripts(path)]


def _read(path: Path, block: list[tuple[int, str]]) -> Script:
    name = block[0][1].removeprefix("# ")
    head: dict[str, str] = {}
    turns: list[Turn] = []
    for number, line in block[1:]:
        try:
            tag, _, text = line.partition(" ")
            if tag in _SPEAKERS:
                turns.append(Turn(_SPEAKERS[tag], tuple(_passages(text))))
            else:
                key, value = _heading(line, before_turns=not turns)
                head[key] = value
        except ValueError as problem:
            raise InvalidEpisode(f"{path}, line {number}, script {name}: {problem}.") from problem
    try:
        return _script(name, head, tuple(turns))
    except KeyError as missing:
        raise InvalidEpisode(f"{path}, script {name} has no line {missing}.") from missing
    except (ValueError, ReibenchError) as problem:
        raise InvalidEpisode(f"{path}, script {name}: {problem}") from problem


def _heading(line: str, *, before_turns: bool) -> tuple[str, str]:
    key, colon, value = line.partition(":")
    if not colon or not before_turns:
        raise ValueError("a turn begins with 'H ', 'R ' or '> '")
    return key.strip(), value.strip()


def _script(name: str, head: Mapping[str, str], turns: tuple[Turn, ...]) -> Script:
    room, _, seed = head["room"].partition(", seed ")
    bears, category, decoy = (part.strip() for part in head["name"].rsplit(",", 2))
    return Script(
        id=name,
        goal=parse_goal(head["task"]),
        setup=SceneSetup(room=room, seed=int(seed)),
        speaker=head["speaker"],
        name=bears,
        category=category,
        decoy=decoy,
        turns=turns,
        rivals=dict(_rivals(head.get("rivals", ""))),
        candidates=dict(_candidates(head.get("underdetermined", ""))),
        origin=head.get("origin", ""),
    )


def parse_goal(text: str) -> Goal:
    """Read `heat Potato > DiningTable`; raises ValueError."""
    found = _TASK.fullmatch(text)
    kinds = {kind.short: kind for kind in TaskType}
    if found is None or found[1] not in kinds:
        known = ", ".join(kinds)
        raise ValueError(
            f"the task {text!r} is not like 'heat Potato > DiningTable' or"
            f" 'stack Pencil in Mug > Shelf' with one of {known}"
        )
    kind, thing, movable, destination = found.groups()
    return Goal(kinds[kind], thing, destination, movable or "")


def _rivals(text: str) -> Iterator[tuple[str, str]]:
    for entry in filter(None, (part.strip() for part in text.split(";"))):
        found = _RIVAL.fullmatch(entry)
        if found is None:
            raise ValueError(f"the rival {entry!r} is not like 'Tomato (baked me a pie)'")
        yield found[1], found[2] or ""


def _candidates(text: str) -> Iterator[tuple[Vagueness, tuple[str, ...]]]:
    for entry in filter(None, (part.strip() for part in text.split(";"))):
        level, *types = entry.split()
        yield Vagueness.parse(level), tuple(types)


def _passages(text: str) -> Iterator[Passage]:
    end = 0
    for found in _BLOCK.finditer(text):
        if found.start() != end:
            raise ValueError(f"a brace is not closed near {text[end : end + 40]!r}")
        end = found.end()
        mark, marked, plain = found.groups()
        inner = (marked if mark else plain).strip()
        if inner:
            yield Passage(_MARKS[mark] if mark else "always", tuple(_parts(inner)))
    if end != len(text):
        raise ValueError(f"a brace is not closed near {text[end : end + 40]!r}")


def _parts(text: str) -> Iterator[str | Mention]:
    end = 0
    for found in _PART.finditer(text):
        if found.start() > end:
            yield _plain(text[end : found.start()])
        end = found.end()
        which, named, unnamed, place = found.groups()
        if place:
            yield Mention(place, "", "destination")
        else:
            whose = {"1": "object", "2": "movable", "1+2": "object+movable"}
            yield Mention(named, unnamed or "", whose[which or "1"])
    if end < len(text):
        yield _plain(text[end:])


def _plain(text: str) -> str:
    if odd := next((sign for sign in "[]<>|" if sign in text), ""):
        raise ValueError(f"{odd!r} stands alone near {text[:60]!r}")
    return text


def format_script(script: Script) -> str:
    """Return a script as a script file holds it."""
    goal, setup = script.goal, script.setup
    via = f" in {goal.movable_receptacle}" if goal.movable_receptacle else ""
    task = f"{goal.task_type.short} {goal.object}{via} > {goal.destination}"
    lines = [
        f"# {script.id}",
        f"task: {task}",
        f"room: {setup.room}, seed {setup.seed}",
        f"speaker: {script.speaker}",
        f"name: {script.name}, {script.category}, {script.decoy}",
    ]
    if script.rivals:
        known = (f"{name} ({why})" if why else name for name, why in script.rivals.items())
        lines.append(f"rivals: {'; '.join(known)}")
    if script.candidates:
        ordered = [level for level in LEVELS if level in script.candidates]
        entries = (f"{level} {' '.join(script.candidates[level])}" for level in ordered)
        lines.append(f"underdetermined: {'; '.join(entries)}")
    if script.origin:
        lines.append(f"origin: {script.origin}")
    lines.append("")
    last = len(script.turns) - 1
    for number, turn in enumerate(script.turns):
        tag = ">" if number == last else "H" if turn.speaker == "human" else "R"
        lines.append(f"{tag} {' '.join(map(_format_passage, turn.passages))}")
    return "\n".join(lines) + "\n"


def format_scripts(scripts: Iterable[Script]) -> str:
    """Return scripts as the text of a script file."""
    return "\n".join(map(format_script, scripts))


def _format_passage(passage: Passage) -> str:
    text = "".join(part if isinstance(part, str) else _format(part) for part in passage.parts)
    sign = next((sign for sign, stay in _MARKS.items() if stay == passage.stay), "")
    return f"{{{sign}{text}}}" if sign else text


def _format(mention: Mention) -> str:
    if mention.of == "destination":
        return f"<{mention.named}>"
    prefix = {"object": "", "movable": "2:", "object+movable": "1+2:"}[mention.of]
    unnamed = f"|{mention.unnamed}" if mention.unnamed else ""
    return f"[{prefix}{mention.named}{unnamed}]"
