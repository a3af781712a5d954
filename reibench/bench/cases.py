"""How fast the case pages answer, with many records in the database."""

import statistics
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter
from typing import Any

from sqlite_utils import Database

from reibench.cases.table import PERSON
from reibench.dataset.files import digest, episode_to_json, shipped_episodes
from reibench.episode import Episode
from reibench.methods import Instruction
from reibench.planners import Decision
from reibench.planners.expert import Expert
from reibench.rollout import Rollout, drive
from reibench.run import RunSpec, make_world
from reibench.store import Store
from reibench.store.codec import dump

TEMPLATES = 36
"""Episodes that are really played; the others get copies of their records."""
METHODS = ("none", "tocc", "ap", "cot", "icl")
FILTERS = (
    "kind=helps", "kind=hurts", "level=implicit-short", "level=implicit-short,mixed-short",
    "task_type=look_at_obj_in_light", "error=object-omission", "error=wrong-object",
    "words=potato", "words=the+thing+apple", "room=kitchen-6", "planner=person", "method=tocc",
    "model=scripted:2", "kind=helps&level=implicit-noised&method=tocc", "",
)  # fmt: skip


def bench_cases(records: int) -> dict[str, Any]:
    """Fill a database with so many records, and time the pages' answers."""
    with TemporaryDirectory(prefix="reibench-bench-") as folder:
        store = Store(Path(folder) / "many.db")
        began = perf_counter()
        made = _fill(store, records)
        filled = {
            "records": made,
            "steps": store.query("select count(*) as n from steps")[0]["n"],
            "database_mb": round(store.path.stat().st_size / 1e6),
            "filling_s": round(perf_counter() - began, 1),
        }
        return filled | _timed(store)


def _timed(store: Store) -> dict[str, int]:
    """Return how many milliseconds each kind of page takes to be answered."""
    ask = _server(store)
    first = ask("/cases?part=list")
    changes = [ask(f"/cases?{query}&part=list") for query in FILTERS for _ in range(3)]
    runs = _some_runs(store)
    _one_more(store)
    taken = {
        "first_list_ms": first,
        "filter_change_median_ms": statistics.median(changes),
        "filter_change_most_ms": max(changes),
        "after_a_new_record_ms": ask("/cases?kind=helps&part=list"),
        "open_case_ms": ask(f"/cases?runs={runs}&part=case"),
        "step_ms": ask(f"/cases?runs={runs}&part=at&step=2"),
        "comparison_ms": ask("/comparison"),
    }
    return {name: round(milliseconds) for name, milliseconds in taken.items()}


def _server(store: Store) -> Callable[[str], float]:
    """Serve the pages; return what asks for an address and tells the milliseconds it took."""
    from fastapi import FastAPI
    from fastapi.testclient import TestClient

    from reibench.pages.cases import CasePages
    from reibench.pages.comparison import ComparisonPages

    app = FastAPI()
    pages = CasePages(store, lambda request: True)
    app.include_router(pages.router())
    app.include_router(ComparisonPages(store, pages).router())
    client = TestClient(app)

    def ask(address: str) -> float:
        start = perf_counter()
        answer = client.get(address)
        taken = 1000 * (perf_counter() - start)
        answer.raise_for_status()
        return taken

    return ask


def _fill(store: Store, records: int) -> int:
    """Play some episodes, well and badly, and copy their records to all others of many runs."""
    episodes = shipped_episodes()
    templates = list(_played(store, episodes[:: len(episodes) // TEMPLATES]))
    made = len(store.entries())
    with store.writing() as database:
        for episode in episodes:
            database.execute(
                "insert or ignore into episodes values (?, ?, ?)",
                [digest(episode), episode.id, dump(episode_to_json(episode))],
            )
        number = 0
        while made < records:
            spec = _spec(number)
            for place, episode in enumerate(episodes):
                if made >= records:
                    break
                good, bad = templates[(place * 7 + number) % len(templates)]
                solved = (place * 31 + number * 17) % 5 < 2
                _copy(database, good if solved else bad, f"{number}-{place}", spec, episode)
                made += 1
            number += 1
    return made


def _spec(number: int) -> RunSpec:
    if number % 7 == 6:
        return RunSpec(planner=PERSON, method="none", model="", seed=number)
    method = METHODS[number % len(METHODS)]
    return RunSpec(planner="saycan", method=method, model=f"scripted:{number // len(METHODS)}")


def _played(store: Store, episodes: list[Episode]) -> Iterator[tuple[str, str]]:
    """Yield the ids of a record that solves an episode and of one that does not."""
    spec = RunSpec(planner="expert")
    world = make_world(spec)
    for episode in episodes:
        ids = []
        for method, some in (("none", 99), ("tocc", 4)):
            record_id = store.begin(replace(spec, method=method), episode)
            rollout = Rollout(episode, world)
            store.started(record_id, rollout.start())
            for step, _ in zip(
                drive(rollout, Expert(episode.task.goal), Instruction("", "")),
                range(some),
                strict=False,
            ):
                store.add_step(record_id, rollout, step)
            rollout.finish()
            store.finish(record_id, rollout, "expert")
            ids.append(record_id)
        yield ids[0], ids[1]


def _copy(database: Database, template: str, new: str, spec: RunSpec, episode: Episode) -> None:
    """Write a record of another run and episode with the steps of one that was played."""
    run = f"run-{spec.planner}-{spec.method}-{spec.model}-{spec.seed}"
    database.execute(
        "insert or ignore into runs values (?, ?, ?, ?, ?, ?, ?, '2026-01-01')",
        [run, spec.actor, spec.planner, spec.method, spec.model, spec.rules, "{}"],
    )
    columns = [row[1] for row in database.execute("pragma table_info(records)")]
    new_values = {
        "id": new, "run": run, "actor": PERSON if spec.planner == PERSON else spec.actor,
        "episode": episode.id, "episode_digest": digest(episode), "task": episode.task.id,
        "task_type": str(episode.task.goal.task_type), "level": str(episode.vagueness),
        "room": episode.task.setup.room,
    }  # fmt: skip
    chosen = ", ".join("?" if name in new_values else name for name in columns)
    database.execute(
        f"insert into records ({', '.join(columns)}) select {chosen} from records where id = ?",
        [*(new_values[name] for name in columns if name in new_values), template],
    )
    columns = [row[1] for row in database.execute("pragma table_info(steps)")]
    chosen = ", ".join("?" if name == "record" else name for name in columns)
    database.execute(
        f"insert into steps ({', '.join(columns)}) select {chosen} from steps where record = ?",
        [new, template],
    )


def _some_runs(store: Store) -> str:
    """Return the runs of a case with all three lanes."""
    rows = store.query(
        "select group_concat(id) as ids, count(*) as n from (select id, episode_digest, actor,"
        " row_number() over (partition by episode_digest, actor) as nth from records)"
        " where nth = 1 and actor in ('person', 'saycan+none/scripted:0',"
        " 'saycan+tocc/scripted:0') group by episode_digest order by n desc limit 1"
    )
    return str(rows[0]["ids"])


def _one_more(store: Store) -> None:
    """Add a record, as somebody does who plays while others look."""
    spec = RunSpec(planner=PERSON, method="none", model="")
    episode = shipped_episodes()[0]
    record_id = store.begin(spec, episode, actor=PERSON, origin="demo", visitor="v")
    rollout = Rollout(episode, make_world(spec))
    store.started(record_id, rollout.start())
    skill = next(skill for skill in rollout.skills)
    store.add_step(record_id, rollout, rollout.step(Decision(skill)))
    store.finish(record_id, rollout, PERSON)
