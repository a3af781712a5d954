"""Why an episode failed, in a sentence or two a reader of the record would write.

Which referent was missed, or which condition never came true or was lost, and at which step. It
rests on the same facts as `faults`, the finer kinds of failure, and never on prompts.
"""

from reibench.explanation.execution import execution
from reibench.explanation.omission import omission, taken
from reibench.explanation.words import sentence
from reibench.rollout import Record
from reibench.verdict import omitted

__all__ = ["explain", "taken"]


def explain(record: Record) -> str:
    """Return why `record` failed; of a success, what holds at its end."""
    if record.status == "error":
        return sentence(record.error or "no reason was recorded")
    if record.status == "success":
        goals = record.steps[-1].event.goals if record.steps else ()
        return sentence(goals[-1].text if goals else "the instruction is carried out")
    missing = omitted(record)
    if missing:
        return " ".join(omission(record, missing))
    return execution(record)
