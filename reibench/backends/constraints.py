"""Ways to hold a server to one of several options, and reading which one it took."""

import json
import re
from collections.abc import Sequence
from difflib import SequenceMatcher
from enum import Enum

SURE = 0.8
"""How like an option an answer must be to be taken for it (ratio of difflib)."""
APART = 0.08
"""How much less like any other option it must be."""


class Way(Enum):
    """How options are given to a server; each by the field it knows."""

    GRAMMAR = "grammar"
    """llama.cpp's GBNF."""
    STRUCTURED = "structured_outputs"
    """vLLM's since 0.11."""
    GUIDED = "guided_choice"
    """vLLM's before 0.12."""
    SCHEMA = "response_format"
    """OpenAI's structured outputs, also Ollama's: a JSON schema whose only field is an enum."""
    FREE = ""
    """Not at all: they are listed in the question, and the answer is whatever it is."""

    def holding_to(self, options: Sequence[str]) -> dict[str, object]:
        """Return the request's fields that allow only `options`."""
        match self:
            case Way.GRAMMAR:
                return {"grammar": "root ::= " + " | ".join(map(_literal, options))}
            case Way.STRUCTURED:
                return {"structured_outputs": {"choice": list(options)}}
            case Way.GUIDED:
                return {"guided_choice": list(options)}
            case Way.SCHEMA:
                return {"response_format": _schema(options)}
        return {}

    def holding_within(self, grammar: str) -> dict[str, object] | None:
        """Return the request's fields that allow only what `grammar` derives, None if none do."""
        match self:
            case Way.GRAMMAR:
                return {"grammar": grammar}
            case Way.STRUCTURED:
                return {"structured_outputs": {"grammar": grammar}}
            case Way.GUIDED:
                return {"guided_grammar": grammar}
        return None

    @property
    def request(self) -> str:
        """What a chat model is told about the form of its answer, beside the fields."""
        if self is Way.SCHEMA:
            return '\n\nAnswer as JSON: {"choice": "…"}'
        return ""

    def said(self, answer: str) -> str:
        """Return the option as the model wrote it, out of its JSON."""
        if self is not Way.SCHEMA:
            return answer
        try:
            parsed = json.loads(answer)
        except ValueError:
            return answer
        choice = parsed.get("choice") if isinstance(parsed, dict) else None
        return choice if isinstance(choice, str) else answer


def listed(options: Sequence[str]) -> str:
    """Return the sentence that asks for one of `options`."""
    return "Answer with exactly one of these: " + "; ".join(one.strip() for one in options) + "."


def same(answer: str, options: Sequence[str]) -> str:
    """Return the option that `answer` is, case, quotes and marks around it aside, or nothing."""
    words = _words(answer)
    return next((option for option in options if _words(option) == words), "") if words else ""


def closest(answer: str, options: Sequence[str]) -> str:
    """Return the only option that `answer` can mean, or nothing.

    That is the only one named in it, longer names before shorter ones, or else the one it is most
    like, if no other is nearly as like.
    """
    words = _words(answer)
    named = [option for option in options if re.search(rf"\b{re.escape(_words(option))}\b", words)]
    whole = [one for one in named if not any(_inside(one, other) for other in named)]
    if whole:
        return whole[0] if len(whole) == 1 else ""
    likeness = {one: SequenceMatcher(None, words, _words(one)).ratio() for one in options}
    best, *others = sorted(options, key=lambda one: -likeness[one])
    clear = not others or likeness[best] - likeness[others[0]] >= APART
    return best if likeness[best] >= SURE and clear else ""


def _inside(one: str, other: str) -> bool:
    return _words(one) != _words(other) and _words(one) in _words(other)


def _words(text: str) -> str:
    return " ".join(re.findall(r"\w+", text.casefold()))


def _literal(text: str) -> str:
    return json.dumps(text, ensure_ascii=False)


def _schema(options: Sequence[str]) -> dict[str, object]:
    choice = {"type": "string", "enum": list(options)}
    schema = {
        "type": "object",
        "properties": {"choice": choice},
        "required": ["choice"],
        "additionalProperties": False,
    }
    named = {"name": "choice", "strict": True, "schema": schema}
    return {"type": "json_schema", "json_schema": named}
