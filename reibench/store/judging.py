"""What a finished record is judged as, kept beside it so that lists need not read its steps."""

from sqlite_utils import Database

from reibench.explanation import explain, taken
from reibench.faults import fault_kind
from reibench.rollout import Record
from reibench.verdict import error_kind


def judge(database: Database, record: Record) -> None:
    """Note kind and finer kind of a failure, the sentence about it, and what was taken."""
    kind, fault = error_kind(record), fault_kind(record)
    database.execute(
        "update records set error_kind = ?, fault = ?, reason = ?, taken = ? where id = ?",
        [kind and str(kind), fault and str(fault), explain(record), taken(record), record.id],
    )
