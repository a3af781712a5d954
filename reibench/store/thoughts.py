"""What methods and planners thought, as JSON and back: usage, alternatives, artefacts."""

import json
from collections.abc import Iterable, Sequence
from dataclasses import astuple
from typing import Any

from reibench.artefact import Artefact
from reibench.backends import Alternative, Usage
from reibench.methods import Instruction
from reibench.planners import Closing
from reibench.store.codec import dump


def alternatives_to_json(alternatives: Iterable[Alternative]) -> str:
    """Return runners-up."""
    return dump([[each.text, round(each.probability, 5)] for each in alternatives])


def alternatives_from_json(text: str) -> tuple[Alternative, ...]:
    """Read runners-up."""
    return tuple(Alternative(*each) for each in json.loads(text))


def usage_to_json(usage: Usage) -> str:
    """Return what a call cost."""
    seconds = round(usage.seconds, 4)
    counted = [usage.prompt_tokens, usage.cached_tokens, usage.completion_tokens, seconds]
    return dump([*counted, round(usage.dollars, 8)] if usage.dollars else counted)


def usage_from_json(text: str) -> Usage:
    """Read what a call cost."""
    return Usage(*json.loads(text))


def instruction_to_json(instruction: Instruction | None) -> str | None:
    """Return what the planner was told."""
    if instruction is None:
        return None
    return dump(
        {
            "text": instruction.text,
            "original": instruction.original,
            "context": instruction.context,
            "demonstrations": instruction.demonstrations,
            "notes": instruction.notes,
            "prompt": instruction.prompt,
            "answer": instruction.answer,
            "usage": usage_to_json(instruction.usage),
            "artefacts": [astuple(each) for each in instruction.artefacts],
        }
    )


def instruction_from_json(text: str | None) -> Instruction | None:
    """Read what the planner was told."""
    if text is None:
        return None
    value = json.loads(text)
    value["context"] = tuple(value["context"])
    value["usage"] = usage_from_json(value["usage"])
    # records made before methods had artefacts say nothing of them
    value["artefacts"] = _artefacts(value.get("artefacts", ()))
    return Instruction(**value)


def artefacts_to_json(artefacts: Iterable[Artefact]) -> str:
    """Return what a planner made on its way."""
    return dump([astuple(each) for each in artefacts])


def artefacts_from_json(text: str) -> tuple[Artefact, ...]:
    """Read what a planner made on its way."""
    return _artefacts(json.loads(text))


def _artefacts(values: Sequence[Sequence[Any]]) -> tuple[Artefact, ...]:
    return tuple(Artefact(*each) for each in values)


def closing_to_json(closing: Closing | None) -> str | None:
    """Return what led to saying done."""
    if closing is None:
        return None
    return dump(
        {
            "prompt": closing.prompt,
            "usage": usage_to_json(closing.usage),
            "alternatives": alternatives_to_json(closing.alternatives),
            "artefacts": artefacts_to_json(closing.artefacts),
        }
    )


def closing_from_json(text: str | None) -> Closing | None:
    """Read what led to saying done."""
    if text is None:
        return None
    value = json.loads(text)
    return Closing(
        prompt=value["prompt"],
        usage=usage_from_json(value["usage"]),
        alternatives=alternatives_from_json(value["alternatives"]),
        artefacts=artefacts_from_json(value["artefacts"]),
    )
