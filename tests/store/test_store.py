"""The store keeps what happened, whatever happens to it."""

import sqlite3
import threading

import pytest

from reibench.errors import StoreUnavailable
from reibench.replay import replay
from reibench.run import RunSpec, evaluate
from reibench.store import Store
from reibench.worlds import worlds

SPEC = RunSpec(planner="expert")


def run(store, episodes, spec=SPEC):
    return list(evaluate(spec, episodes, None, worlds.create(spec.world), store))


def test_a_record_comes_back_as_it_was(store, episode):
    [record] = run(store, [episode])
    again = store.record(record.id)
    assert again.episode == record.episode
    assert again.status == record.status == "success"
    assert again.start == record.start
    assert [s.event for s in again.steps] == [s.event for s in record.steps]
    assert [s.decision for s in again.steps] == [s.decision for s in record.steps]
    assert again.instruction == record.instruction


def test_prompts_usage_and_runners_up_come_back_too(store, episode, script):
    spec = RunSpec(model="scripted:x", method="tocc")
    backend = script("Heat the potato.", " find a potato", " pick up the potato", " done")
    [record] = evaluate(spec, [episode], backend, worlds.create("embedded"), store)
    again = store.record(record.id)
    assert [s.decision for s in again.steps] == [s.decision for s in record.steps]
    assert "pick up the potato" not in again.steps[1].decision.prompt.splitlines()[-1]
    assert again.instruction == record.instruction
    assert again.instruction.text.startswith("Heat the potato")


def test_a_run_goes_on_where_it_was_killed(store, episodes):
    chosen = [each for each in episodes.values() if each.task.id == "heat_potato"][:4]
    half = evaluate(SPEC, chosen, None, worlds.create("embedded"), store)
    next(half), next(half)
    half.close()
    assert len(store.finished(SPEC)) == 2
    assert [each.episode.id for each in run(store, chosen)] == [each.id for each in chosen[2:]]
    assert len(store.entries()) == 4


def test_an_episode_cut_short_is_played_again_under_the_same_record(store, episode):
    record_id = store.begin(SPEC, episode)
    [record] = run(store, [episode])
    assert record.id == record_id
    [row] = store.query("select attempts, status from records")
    assert row == {"attempts": 2, "status": "success"}


def test_another_spec_is_another_run(store, episode):
    run(store, [episode])
    assert len(run(store, [episode], RunSpec(planner="expert", seed=5))) == 1
    assert len(run(store, [episode])) == 0


def test_a_replay_confirms_a_record_and_notices_a_forged_one(store, episode):
    [record] = run(store, [episode])
    assert replay(store.record(record.id), worlds.create("embedded")).differences == ()
    store.query("update steps set message = 'forged', success = 0 where number = 3")
    found = replay(store.record(record.id), worlds.create("embedded")).differences
    assert found[0].startswith("step 3 (find a microwave): success was False, now True")


def test_several_threads_write_at_once_and_lose_nothing(store, episodes):
    chosen = list(episodes.values())[:8]
    problems = []

    def work(part):
        try:
            run(store, part)
        except StoreUnavailable as problem:
            problems.append(problem)

    threads = [threading.Thread(target=work, args=(chosen[i::4],)) for i in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert problems == []
    assert len(store.finished(SPEC)) == 8


def test_a_file_that_is_no_database_is_refused_and_left_alone(tmp_path):
    path = tmp_path / "notes.db"
    path.write_text("my notes, not a database" * 100)
    with pytest.raises(StoreUnavailable, match=r"notes\.db: file is not a database\. It is no"):
        Store(path)
    assert path.read_text().startswith("my notes")


def test_a_damaged_database_is_refused_in_one_sentence(tmp_path, episode):
    path = tmp_path / "damaged.db"
    first = Store(path)
    run(first, [episode])
    first.query("pragma wal_checkpoint(truncate)")
    whole = bytearray(path.read_bytes())
    whole[4096 : len(whole) // 2] = b"\xff" * (len(whole) // 2 - 4096)
    path.write_bytes(whole)

    def use_it():
        damaged = Store(path)
        damaged.record(damaged.entries()[0].id)

    with pytest.raises(StoreUnavailable, match=r"damaged\.db"):
        use_it()


def test_a_full_disk_refuses_the_step_and_keeps_the_rest(tmp_path, episodes):
    store = Store(tmp_path / "full.db")
    chosen = list(episodes.values())
    run(store, chosen[:1])
    [pages] = store.query("pragma page_count")
    # SQLite's own page limit answers exactly as a full disk does: SQLITE_FULL.
    store.query(f"pragma max_page_count = {pages['page_count'] + 3}")
    with pytest.raises(StoreUnavailable, match=r"full\. Free some space"):
        run(store, chosen[1:])
    kept = sqlite3.connect(store.path)
    assert kept.execute("pragma integrity_check").fetchone() == ("ok",)
    assert kept.execute("select count(*) from records where status = 'success'").fetchone()[0] >= 1


def test_a_folder_that_cannot_be_made_is_one_sentence(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(StoreUnavailable, match="Cannot open the database"):
        Store(tmp_path / "file" / "records.db")
