"""The gallery comes along as it was recorded."""

import pytest

from reibench import gallery
from reibench.errors import ReibenchError
from reibench.gallery import FILE, GalleryCase
from reibench.replay import replay
from reibench.run import RunSpec, make_world
from reibench.store import Store
from tests.cases.conftest import SPEC, helped, play  # noqa: F401 - fixtures


@pytest.fixture
def shown(helped):  # noqa: F811
    return GalleryCase("heat_potato.mixed-noised", helped["plain"].id, helped["told"].id)


def test_runs_are_the_same_after_a_way_through_the_file(store, tmp_path, helped, shown):  # noqa: F811
    file, other = tmp_path / "runs.jsonl.gz", Store(tmp_path / "other.db")
    assert gallery.save([(store, shown)], file) == file.stat().st_size
    assert gallery.cases(file) == (shown,)
    assert gallery.load(other, file) == 2
    assert gallery.load(other, file) == 0
    for lane in ("plain", "told"):
        assert other.record(helped[lane].id) == store.record(helped[lane].id)
    assert {entry.origin for entry in other.entries()} == {"gallery"}


def test_the_same_runs_give_the_same_file(store, tmp_path, shown):
    one, other = tmp_path / "one.gz", tmp_path / "other.gz"
    gallery.save([(store, shown)], one)
    gallery.save([(store, shown)], other)
    assert one.read_bytes() == other.read_bytes()


def test_what_is_not_there_is_not_saved(store, tmp_path, shown):
    with pytest.raises(ReibenchError, match="no finished record 'nonsense'"):
        gallery.save([(store, GalleryCase("x", "nonsense", shown.told))], tmp_path / "x.gz")
    assert gallery.matching(store, "nowhere", "m", "tocc") is None


def test_runs_are_found_by_episode_model_and_method(store, shown):
    model = store.query("select model from runs where planner = 'saycan' limit 1")[0]["model"]
    assert gallery.matching(store, shown.episode, model, "tocc") == shown
    assert SPEC.model == model


def test_no_gallery_is_an_empty_one(store, tmp_path):
    assert gallery.cases(tmp_path / "none.gz") == ()
    assert gallery.load(store, tmp_path / "none.gz") == 0


@pytest.fixture(scope="module")
def shipped_gallery(tmp_path_factory):
    store = Store(tmp_path_factory.mktemp("gallery") / "gallery.db")
    gallery.load(store, FILE)
    return store


def outcomes(store):
    status = {entry.id: entry.status for entry in store.entries()}
    return [
        (status[case.plain] == "success", status[case.told] == "success")
        for case in gallery.cases()
    ]


def test_the_shipped_one_shows_gains_and_reversals_as_they_were(shipped_gallery):
    found = outcomes(shipped_gallery)
    assert found[0] == (False, True)
    assert sum(pair == (False, True) for pair in found) >= 12
    assert sum(pair != (False, True) for pair in found) >= 6
    assert sum(pair == (True, False) for pair in found) >= 2


def test_the_shipped_one_is_spread_over_levels_types_and_models(shipped_gallery):
    rows = shipped_gallery.query(
        "select level, task_type, model from records join runs on runs.id = run"
    )
    assert len({row["level"] for row in rows}) >= 6
    assert len({row["task_type"] for row in rows}) == 6
    assert len({row["model"] for row in rows}) >= 2


def test_every_shipped_run_comes_out_the_same_when_it_is_replayed(shipped_gallery):
    entries = shipped_gallery.entries()
    assert entries
    for entry in entries:
        world = make_world(RunSpec(rules=entry.rules, world=entry.world))
        assert replay(shipped_gallery.record(entry.id), world).differences == ()
