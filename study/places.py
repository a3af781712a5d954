"""Places in a study: who holds them, which is free, and what is played there."""

from collections.abc import Sequence
from datetime import UTC, datetime, timedelta
from functools import lru_cache

from sqlite_utils import Database

from reibench.episode import Episode
from study.config import Study, all_episodes, from_json


def _holding(study: Study, *, simulated: bool) -> tuple[str, list[object]]:
    """Return the condition for participants who hold their place, and its parameters.

    Simulated people take no place from real ones.
    """
    since = datetime.now(UTC) - timedelta(minutes=study.recent_minutes)
    return (
        "study = ? and simulated = ? and (state = 'finished' or (state = 'active' and seen > ?))",
        [study.name, simulated, since.isoformat(timespec="milliseconds")],
    )


def free_slot(database: Database, study: Study, *, simulated: bool) -> int:
    """Return the least slot that nobody holds."""
    where, values = _holding(study, simulated=simulated)
    rows = database.execute(f"select slot from participants where {where}", values).fetchall()
    held = {row[0] for row in rows}
    return next(slot for slot in range(len(held) + 1) if slot not in held)


def filled(database: Database, study: Study, *, simulated: bool) -> dict[str, int]:
    """Return how often each episode is held, by its id."""
    where, values = _holding(study, simulated=simulated)
    rows = database.execute(
        "select episode, count(*) from assignments join participants on participant = code"
        f" where kind = 'trial' and {where} group by episode",
        values,
    ).fetchall()
    return {row[0]: row[1] for row in rows}


def assign(database: Database, code: str, study: Study, chosen: Sequence[Episode]) -> None:
    """Note what somebody is to play: the practice tasks, then what was chosen."""
    shipped = {episode.id: episode for episode in all_episodes()}
    practice = [shipped[name] for name in study.practice]
    for kind, episodes in (("practice", practice), ("trial", chosen)):
        for place, episode in enumerate(episodes):
            database.execute(
                "insert into assignments (participant, kind, place, episode, task, level)"
                " values (?, ?, ?, ?, ?, ?)",
                [code, kind, place, episode.id, episode.task.id, str(episode.vagueness)],
            )


@lru_cache(maxsize=8)
def _pool(text: str) -> tuple[Episode, ...]:
    return tuple(from_json(text).chosen())


def pool_of(study: Study) -> tuple[Episode, ...]:
    """Return the episodes that trials are drawn from, chosen once."""
    return _pool(study.to_json())
