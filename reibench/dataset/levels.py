"""The nine levels: what each keeps of a script, and how it mentions things (section 3.2)."""

from collections.abc import Iterator, Sequence

from reibench.dataset.forms import named_form, unnamed_form
from reibench.dataset.scripts import Mention, Passage, Script
from reibench.dialogue import LEVELS, Dialogue, ReferringExpression, Utterance, Vagueness
from reibench.episode import Episode, Task


def derive(script: Script, levels: Sequence[Vagueness] = LEVELS) -> list[Episode]:
    """Return the script's episodes at `levels`: nine, from explicit-standard to implicit-short."""
    task = Task(script.id, script.setup, script.goal)
    episodes = []
    for level in levels:
        left = script.candidates.get(level, ())
        episodes.append(
            Episode(
                task=task,
                dialogue=Dialogue(tuple(_utterances(script, level))),
                vagueness=level,
                candidates=left or (script.goal.object,),
                underdetermined=len(left) > 1,
                origin=script.origin,
            )
        )
    return episodes


def said(script: Script, words: str, level: Vagueness) -> bool:
    """Whether the script's dialogue at `level` holds these words."""
    texts = (utterance.text.lower() for utterance in _utterances(script, level))
    return any(words.lower() in text for text in texts)


def stays(passage: Passage, level: Vagueness) -> bool:
    """Whether a passage is there at `level`: short is noise and omission (reading note 3)."""
    if passage.stay == "noise":
        return level.context != "standard"
    if passage.stay == "cut":
        return level.context != "short"
    if passage.stay == "first":
        return level != ("implicit", "short")
    return True


def _utterances(script: Script, level: Vagueness) -> Iterator[Utterance]:
    fresh = {"object", "movable"}
    last = len(script.turns) - 1
    for number, turn in enumerate(script.turns):
        writer = _Writer(script)
        for passage in turn.passages:
            named = [_is_named(m, level, number == last, fresh) for m in passage.mentions]
            if stays(passage, level):
                writer.write(passage, named)
        yield Utterance(turn.speaker, writer.text, tuple(writer.expressions))


def _is_named(mention: Mention, level: Vagueness, in_instruction: bool, fresh: set[str]) -> bool:
    """Whether `mention` names its thing at `level`; strikes it from those not yet mentioned."""
    whose = set(mention.of.split("+"))
    is_first = bool(whose & fresh)
    fresh -= whose
    if mention.of == "destination" or not mention.unnamed:
        return True
    if level.reference == "mixed":
        return not in_instruction
    return level.reference == "explicit" or is_first


class _Writer:
    """Writes one turn, and notes where its referring expressions stand."""

    def __init__(self, script: Script) -> None:
        self.text = ""
        self.expressions: list[ReferringExpression] = []
        self._script = script

    def write(self, passage: Passage, named: list[bool]) -> None:
        """Write a passage after what stands there, its mentions named or not in turn."""
        if self.text:
            self.text += " "
        choices = iter(named)
        begin = len(self.text)
        for part in passage.parts:
            if isinstance(part, str):
                self.text += part
            else:
                self._mention(part, next(choices))
        if passage.stay == "noise":
            self._note_names(begin)

    def _mention(self, mention: Mention, named: bool) -> None:
        goal = self._script.goal
        types = {
            "object": goal.object,
            "movable": goal.movable_receptacle,
            "object+movable": f"{goal.object}+{goal.movable_receptacle}",
            "destination": goal.destination,
        }
        text = mention.named if named else as_written(mention)
        form = named_form(text, types[mention.of]) if named else unnamed_form(text)
        self._note(text, types[mention.of], form, named)

    def _note(self, text: str, referent: str, form: str, explicit: bool) -> None:
        start = len(self.text)
        self.text += text
        mark = ReferringExpression(start, len(self.text), text, referent, form, explicit)
        self.expressions.append(mark)

    def _note_names(self, begin: int) -> None:
        name = self._script.name
        place = self.text.find(name, begin)
        while place >= 0:
            end = place + len(name)
            self.expressions.append(
                ReferringExpression(place, end, name, f"@{name}", "proper", explicit=True)
            )
            place = self.text.find(name, end)


def as_written(mention: Mention) -> str:
    """Return the unnamed form with a capital where the named one has it at a sentence's start."""
    first, capital = mention.unnamed[0], mention.named[0].isupper()
    return (first.upper() if capital else first) + mention.unnamed[1:]
