"""What is said: utterances, the referring expressions in them, and how vague they are."""

from dataclasses import dataclass
from typing import Literal, NamedTuple, get_args

from reibench.errors import unknown

Reference = Literal["explicit", "mixed", "implicit"]
Context = Literal["standard", "noised", "short", "alone"]
Speaker = Literal["human", "robot"]
REFERENCES: tuple[Reference, ...] = get_args(Reference)
CONTEXTS: tuple[Context, ...] = ("standard", "noised", "short")
"""Those of the paper; `alone` is an instruction that nothing was said before (ALFRED's)."""


class Vagueness(NamedTuple):
    """One of the nine levels: how objects are named x what surrounds the request (section 3.1)."""

    reference: Reference
    context: Context

    def __str__(self) -> str:
        return f"{self.reference}-{self.context}"

    @classmethod
    def parse(cls, text: str) -> "Vagueness":
        """Read `mixed-noised`; raises UnknownName."""
        for level in (*LEVELS, EXPLICIT_ALONE):
            if str(level) == text:
                return level
        raise unknown("level", text, map(str, (*LEVELS, EXPLICIT_ALONE)))


LEVELS = tuple(Vagueness(reference, context) for reference in REFERENCES for context in CONTEXTS)
"""All nine, from explicit-standard to implicit-short."""
EXPLICIT_ALONE = Vagueness("explicit", "alone")
"""No level of the paper's: a clear instruction without a dialogue, as in ALFRED."""


@dataclass(frozen=True)
class ReferringExpression:
    """A stretch of an utterance that picks something out."""

    start: int
    """Character offsets in the utterance, end exclusive."""
    end: int
    text: str
    referent: str
    """The object type it stands for; `@Mr. Box` for an ambiguous proper name (section 3.1)."""
    form: str
    """Grammatical form: proper, definite, indefinite, plural, pronoun or attributive."""
    explicit: bool
    """Whether it names its object."""

    @property
    def is_noise(self) -> bool:
        """Whether it is an ambiguous name that stands for no object of the room."""
        return self.referent.startswith("@")


@dataclass(frozen=True)
class Utterance:
    """One turn of the dialogue."""

    speaker: Speaker
    text: str
    expressions: tuple[ReferringExpression, ...] = ()


@dataclass(frozen=True)
class Dialogue:
    """What was said before, and the pending instruction as its last utterance."""

    utterances: tuple[Utterance, ...]

    @property
    def context(self) -> tuple[Utterance, ...]:
        """Everything before the pending instruction."""
        return self.utterances[:-1]

    @property
    def instruction(self) -> Utterance:
        """The pending instruction."""
        return self.utterances[-1]
