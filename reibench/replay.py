"""Replaying records: the same skills in a fresh world, and whether everything came out the same."""

from dataclasses import dataclass

from reibench.errors import ReibenchError
from reibench.planners import Decision
from reibench.rollout import Record, Rollout
from reibench.worlds import Event, World


@dataclass(frozen=True)
class Replay:
    """What a replay showed."""

    record_id: str
    episode: str
    actor: str
    steps: int
    differences: tuple[str, ...] = ()
    """One sentence for each thing that came out otherwise; empty if nothing did."""


def replay(record: Record, world: World) -> Replay:
    """Play the record's skills again in `world`, which follows the record's rules, and compare."""
    differences: list[str] = []
    rollout = Rollout(record.episode, world, max_steps=max(len(record.steps), 1))
    if record.start is not None:
        try:
            differences += _differences("the start", record.start, rollout.start())
            for step in record.steps:
                again = rollout.step(Decision(step.decision.skill), seconds=step.seconds)
                name = f"step {step.number} ({step.decision.skill})"
                differences += _differences(name, step.event, again.event)
        except ReibenchError as problem:
            differences.append(f"the replay broke: {problem}")
        else:
            if record.status in ("success", "failure") and rollout.steps:
                solved = rollout.last_event.solved
                if solved != (record.status == "success"):
                    differences.append(f"it ended as {record.status}, now solved is {solved}")
    return Replay(record.id, record.episode.id, record.actor, len(record.steps), tuple(differences))


def _differences(where: str, recorded: Event, now: Event) -> list[str]:
    found = []
    if recorded.success != now.success:
        found.append(f"{where}: success was {recorded.success}, now {now.success}")
    if recorded.message != now.message:
        found.append(f"{where}: the message was {recorded.message!r}, now {now.message!r}")
    if recorded.goals != now.goals:
        held = [goal.text for goal in recorded.goals if goal.holds]
        holds = [goal.text for goal in now.goals if goal.holds]
        found.append(f"{where}: conditions {held} held, now {holds}")
    if recorded.scene != now.scene:
        before, after = recorded.scene.by_id, now.scene.by_id
        changed = [key for key in before.keys() | after.keys() if before.get(key) != after.get(key)]
        what = ", ".join(sorted(changed)) or "the robot's pose or what it sees"
        found.append(f"{where}: the scene differs in {what}")
    return found
