"""Workers that are processes: the same records as one alone leaves, also when some of them die."""

import pytest

from reibench.store import Store

CHOICE = ("--episodes", "mixed-noised", "--limit", "24")


def deeds(database):
    """Return every record's steps, by run and episode."""
    store = Store(database)
    rows = store.query(
        "select episode, number, skill, success, changes from steps"
        " join records on records.id = record order by episode, number"
    )
    return [tuple(row.values()) for row in rows]


def test_processes_leave_the_same_records_as_one_alone(troubled, tmp_path):
    run = troubled("", *CHOICE)
    status, [alone], _ = run.whole()
    assert status == 0
    before = deeds(run.database)
    # with what SQLite keeps beside it, which the next database would take for its own
    for file in list(run.database.parent.glob(f"{run.database.name}*")):
        file.rename(tmp_path / f"alone-{file.name}")
    status, [together], _ = troubled("", *CHOICE, "--workers", "2").whole()
    assert status == 0
    seconds = together.pop("cost"), alone.pop("cost")  # the one thing that may differ
    assert [cost["decisions"] for cost in seconds] == [len(before) + 24] * 2  # and done, each
    assert together == alone
    assert before == deeds(run.database)
    assert len(before) > 100


def test_an_episode_whose_worker_dies_is_given_to_another_once(troubled):
    run = troubled("Mug=dies-once", *CHOICE, "--workers", "2")
    status, [row], err = run.whole()
    assert status == 0
    assert (row["episodes"], row["success"], row["unfinished"]) == (24, 24, 0)
    assert err.count("exit code -9") == 1
    assert sorted(record["attempts"] for record in run.records) == [1] * 23 + [2]


def test_an_episode_that_kills_its_workers_is_an_error_and_the_rest_goes_on(troubled):
    run = troubled("Mug=dies,Pot=raises", *CHOICE, "--workers", "2")
    _, [row], err = run.whole()
    kinds = {r["episode"]: r["error"] for r in run.records if r["status"] == "error"}
    deadly = [error for error in kinds.values() if "exit code -9" in error]
    raising = [error for error in kinds.values() if "ValueError: this planner" in error]
    assert deadly
    assert raising
    assert len(kinds) == len(deadly) + len(raising) == row["breakdown"]
    assert err.count("exit code -9") == 2 * len(deadly)
    assert row["success"] == row["episodes"] - len(kinds)
    assert (row["episodes"], row["unfinished"]) == (24, 0)
    assert "Traceback" not in err


def test_workers_that_only_die_end_the_run_before_all_is_recorded_as_broken(troubled):
    run = troubled("*=dies", *CHOICE, "--workers", "2")
    status, _, err = run.whole()
    assert status == 2
    assert "workers died without finishing an episode" in err
    assert "Traceback" not in err
    assert len(run.records) < 6
    status, [row], _ = run.whole("")
    assert (status, row["episodes"], row["unfinished"]) == (0, 24, 0)


@pytest.mark.parametrize("workers", ["-1"])
def test_fewer_than_one_worker_is_a_mistake(troubled, workers):
    status, _, err = troubled("", "--workers", workers).whole()
    assert status == 2
    assert "must be at least 1" in err
