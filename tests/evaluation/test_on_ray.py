"""Playing on a Ray cluster: two real nodes on this machine, one of which is killed half way."""

import os
import sys
from contextlib import suppress

import pytest

from reibench.__main__ import main
from reibench.store import Store

CHOICE = ("--episodes", "mixed-noised", "--limit", "24")


@pytest.fixture
def cluster(troubled, monkeypatch):
    """Start a head and a second node; what plays on them knows the troubled planner."""
    for name, value in troubled("").environment.items():
        monkeypatch.setenv(name, value)
    monkeypatch.setenv("RAY_USAGE_STATS_ENABLED", "0")
    monkeypatch.setenv("TROUBLE", "*=slow")
    from ray.cluster_utils import Cluster

    made = Cluster(initialize_head=True, head_node_args={"num_cpus": 1, "include_dashboard": False})
    made.second = made.add_node(num_cpus=1)
    yield made
    with suppress(Exception):
        made.shutdown()


def test_no_episode_is_lost_or_doubled_when_a_node_is_killed_half_way(cluster, troubled, tmp_path):
    run = troubled("", *CHOICE, "--ray", cluster.address)
    said = []
    for line in run.start():
        said.append(line)
        if line.startswith("[8/"):
            cluster.remove_node(cluster.second, allow_graceful=False)
            break
    out, rest = run.process.communicate(timeout=100)
    said = "".join(said) + rest
    assert run.process.returncode == 0, said
    assert '"episodes": 24' in out
    assert said.count(") is gone (Actor") == 1, said
    assert len(said.splitlines()) == 24 + 3, said  # Ray itself says nothing
    records = run.records
    assert len({record["episode"] for record in records}) == len(records) == 24
    assert {record["status"] for record in records} == {"success"}
    assert sorted(record["attempts"] for record in records) == [1] * 23 + [2]
    kept = Store(run.database).query("select record, count(*) as steps from steps group by record")
    assert {row["record"]: row["steps"] for row in kept} == {r["id"]: r["steps"] for r in records}

    missing = tmp_path / "nowhere.gguf"
    elsewhere = ["--planner", "saycan", "--ray", cluster.address, "--model", f"llama-cpp:{missing}"]
    status, _, err = troubled("", *CHOICE, *elsewhere).whole()
    assert status == 2
    said = err.splitlines()[-1]
    assert said.startswith(f"On node {os.uname().nodename} (")
    assert "There is no model file" in said
    assert "must be on every node" in said


def test_without_ray_one_sentence_says_what_to_install(capsys, monkeypatch, tmp_path):
    monkeypatch.setitem(sys.modules, "ray", None)
    status = main(["run", "--planner", "expert", "--ray", "auto", "--db", str(tmp_path / "a.db")])
    err = capsys.readouterr().err
    assert status == 2
    assert err == (
        "--ray needs Ray, which is not installed: pip install -r requirements-ray.txt.\n"
    )


def test_an_address_where_no_cluster_is_is_a_mistake(troubled):
    status, _, err = troubled("", "--ray", "127.0.0.1:1").whole()
    assert status == 2
    assert "No Ray cluster answers at '127.0.0.1:1'" in err
    assert len(err.splitlines()) == 1
