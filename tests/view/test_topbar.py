"""Choosing an episode, an actor and a model."""

from reibench.dialogue import LEVELS
from reibench.episode import TaskType
from reibench.methods import methods
from reibench.models import overview
from reibench.view.catalogue import Catalogue
from reibench.view.choices import offered_methods
from reibench.view.markup import text
from reibench.view.shelf import Fetching, shelf
from reibench.view.topbar import ModelStatus, room_name, topbar


def test_changing_the_level_keeps_the_task(episodes):
    catalogue = Catalogue.of(episodes.values())
    current = catalogue.first
    for level in LEVELS:
        chosen = catalogue.change(current, level=str(level))
        assert chosen.task.id == current.task.id
        if level in catalogue.levels(current.task.id):
            assert chosen.vagueness == level


def test_changing_the_type_keeps_the_level(episodes):
    catalogue = Catalogue.of(episodes.values())
    current = catalogue.first
    chosen = catalogue.change(current, kind=str(TaskType.CLEAN))
    assert chosen.task.goal.task_type is TaskType.CLEAN
    assert chosen.vagueness == current.vagueness


def test_a_shuffle_leads_to_another_task(episodes):
    catalogue = Catalogue.of(episodes.values())
    for seed in range(20):
        assert catalogue.shuffled(catalogue.first, seed).task.id != catalogue.first.task.id


def test_an_unknown_choice_leaves_one_where_one_was(episodes):
    catalogue = Catalogue.of(episodes.values())
    assert catalogue.change(catalogue.first, task="no-such-task") == catalogue.first


def test_the_nine_levels_are_one_radio_group(episodes, rooms, tags):
    catalogue = Catalogue.of(episodes.values())
    episode = catalogue.first
    scene = rooms[episode.task.setup.room]
    bar = topbar(catalogue, episode, scene, "me", ModelStatus("m", "ready"), [("Demo", "/")])
    cells = [each for each in tags(bar, "button") if each.get("data-level")]
    assert [cell["data-level"] for cell in cells] == [str(level) for level in LEVELS]
    [checked] = [cell for cell in cells if cell["aria-checked"] == "true"]
    assert checked["data-level"] == str(episode.vagueness)
    assert checked["tabindex"] == "0"


def test_rooms_are_called_as_people_would():
    assert room_name("living-room-1") == "Living room 1"


def test_the_shelf_says_what_is_here_and_what_it_takes_to_get_the_rest(tags):
    models = overview()
    absent = next(entry.model.name for entry in models if not entry.present)
    markup = shelf(models, chosen="gemma-3-270m", planner="saycan", method="tocc-span")
    buttons = [each["data-model"] for each in tags(markup, "button") if each.get("data-model")]
    assert absent in buttons
    [span] = [each for each in tags(markup, "input") if each.get("value") == "tocc-span"]
    assert "checked" in span


def test_the_menu_explains_every_method_and_the_bar_names_the_chosen_one(episodes, rooms, tags):
    markup = shelf(overview(), chosen="gemma-3-270m", planner="saycan", method="gated-ap")
    radios = {each["value"]: each for each in tags(markup, "input") if each.get("name") == "method"}
    assert sorted(radios) == offered_methods()
    assert [name for name, each in radios.items() if "checked" in each] == ["gated-ap"]
    for name in offered_methods():
        assert text(methods.create(name).summary) in markup
    catalogue = Catalogue.of(episodes.values())
    scene = rooms[catalogue.first.task.setup.room]
    status = ModelStatus("m", "ready")
    bar = topbar(catalogue, catalogue.first, scene, "me", status, (), method="Gated AP")
    assert bar.count("Model + Gated AP") == 2


def test_a_model_on_its_way_shows_how_far_it_is_or_what_went_wrong():
    models = overview()
    absent = next(entry.model.name for entry in models if not entry.present)
    coming = {absent: Fetching(612_000_000, 1_117_000_000, 180)}
    markup = shelf(models, chosen="gemma-3-270m", planner="saycan", method="tocc", fetching=coming)
    assert "612 MB of 1,117 MB, 3 min left" in markup
    failed = {absent: Fetching(error="The source cannot be reached.")}
    markup = shelf(models, chosen="gemma-3-270m", planner="saycan", method="tocc", fetching=failed)
    assert "The source cannot be reached." in markup
    assert "Try again" in markup
