"""Steps as rows of the database and back: prompts and scenes are kept as what changed."""

import json
import zlib
from collections.abc import Iterable, Mapping
from typing import Any

from reibench.methods import Instruction
from reibench.planners import Decision
from reibench.rollout import Step
from reibench.scene import Scene
from reibench.skill import parse_skill
from reibench.store import codec, thoughts
from reibench.store.schema import now
from reibench.worlds import Event


def step_row(
    step: Step, before: Step | None, start: Event | None, told: Instruction | None
) -> dict[str, object]:
    """Return the columns of a step, but for its record.

    Args:
        step: the one to store.
        before: the step before it; None for the first.
        start: the event of the reset.
        told: what the planner was told, if it was.
    """
    if start is None:
        raise RuntimeError("an episode that was not started has no step to store")
    scene = before.event.scene if before else start.scene
    earlier = before.decision.prompt if before else (told.prompt if told else "")
    prompt = step.decision.prompt
    kept = _common(earlier, prompt)
    return {
        "number": step.number,
        "skill": step.decision.skill.text,
        "success": step.event.success,
        "message": step.event.message,
        "goals": codec.goals_to_json(step.event.goals),
        "changes": codec.dump(codec.changes_to_json(scene, step.event.scene)),
        "prompt_kept": kept,
        "prompt_rest": zlib.compress(prompt[kept:].encode()),
        "usage": thoughts.usage_to_json(step.decision.usage),
        "alternatives": thoughts.alternatives_to_json(step.decision.alternatives),
        "artefacts": thoughts.artefacts_to_json(step.decision.artefacts),
        "seconds": round(step.seconds, 4),
        "created": now(),
    }


def steps_of(rows: Iterable[Mapping[str, Any]], scene: Scene, prompt: str) -> list[Step]:
    """Read a record's steps, in order.

    Args:
        rows: of the steps table.
        scene: the one the episode starts in.
        prompt: the one before the first step's: that of the method.
    """
    steps = []
    for row in rows:
        scene = codec.changes_from_json(scene, json.loads(row["changes"]))
        prompt = prompt[: row["prompt_kept"]] + zlib.decompress(row["prompt_rest"]).decode()
        decision = Decision(
            skill=parse_skill(row["skill"]),
            prompt=prompt,
            usage=thoughts.usage_from_json(row["usage"]),
            alternatives=thoughts.alternatives_from_json(row["alternatives"]),
            artefacts=thoughts.artefacts_from_json(row["artefacts"]),
        )
        goals = codec.goals_from_json(row["goals"])
        event = Event(bool(row["success"]), row["message"], scene, goals)
        steps.append(Step(row["number"], decision, event, row["seconds"]))
    return steps


def _common(first: str, second: str) -> int:
    """Return how many leading characters two texts share."""
    if second.startswith(first):
        return len(first)
    pairs = enumerate(zip(first, second, strict=False))
    return next((place for place, (a, b) in pairs if a != b), min(len(first), len(second)))
