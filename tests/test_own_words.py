"""Visitors word an episode; what cannot be carried out is refused in a sentence."""

from dataclasses import replace

import pytest
from fastapi import FastAPI
from fastapi.testclient import TestClient

from reibench.dialogue import Vagueness
from reibench.episode import TaskType
from reibench.errors import ReibenchError
from reibench.household import room_names
from reibench.own_words import OwnEpisodes, Wording, choices, compose
from reibench.pages.own import OwnPages
from reibench.rollout import Rollout
from reibench.sittings import Sittings
from reibench.worlds.embedded import embedded_world

SAID = Wording(
    room="kitchen-6",
    before="Human: I have eaten nothing since five.\nRobot: There is fruit. Something red, too.",
    request="Then put the round red thing somewhere cold, would you? It is too warm.",
    task_type=str(TaskType.PICK),
    object="Apple",
    destination="Fridge",
    vague="the round red thing, it",
)
FIVE = (
    SAID,
    replace(SAID, before="", request="Get my potato hot and bring it to the counter.",
            task_type=str(TaskType.HEAT), object="Potato", destination="CounterTop", vague=""),
    replace(SAID, request="Wash the thing one stirs with and hide it.",
            task_type=str(TaskType.CLEAN), object="Spoon", destination="Drawer",
            vague="the thing one stirs with"),
    replace(SAID, before="I miss my mother's kitchen.\nWhat did she cook?\nEggs. Always the egg.",
            request="Put that one in the other and both on the table, I mean the counter.",
            task_type=str(TaskType.STACK), object="Egg", movable="Bowl", destination="CounterTop",
            vague="that one"),
    replace(SAID, room="bedroom-1", before="", request="Let me see it in the light.",
            task_type=str(TaskType.EXAMINE), object="Book", destination="DeskLamp", vague="it"),
)  # fmt: skip


@pytest.mark.parametrize("said", FIVE, ids=lambda said: said.object)
def test_five_dialogues_written_on_the_spot_become_episodes(said):
    if said.room == "bedroom-1":  # any room with a lamp and something to look at
        said = next(
            replace(said, room=name, object=there.objects[0], destination=there.lamps[0])
            for name in room_names()
            for there in [choices(name)]
            if there.lamps and there.objects
        )
    episode = compose(said)
    assert episode.dialogue.instruction.text == said.request
    assert episode.task.goal.object == said.object
    assert compose(said).id == episode.id
    assert not Rollout(episode, embedded_world()).start().solved


def test_who_speaks_is_read_or_taken_in_turns():
    told = compose(replace(SAID, before="Robot: Hello.\nMe: Hi.\nYou: Well?"))
    assert [turn.speaker for turn in told.dialogue.context] == ["robot", "human", "robot"]
    turns = compose(replace(SAID, before="Hello.\n\n  Hi.  \nWell?"))
    assert [(t.speaker, t.text) for t in turns.dialogue.context] == [
        ("human", "Hello."), ("robot", "Hi."), ("human", "Well?"),
    ]  # fmt: skip


def test_who_says_nothing_has_no_turn():
    silent = compose(replace(SAID, before="Human:\nRobot: Hi.\nHuman: "))
    assert [turn.text for turn in silent.dialogue.context] == ["Hi."]


def test_the_words_that_mean_the_object_are_marked_and_names_are_found():
    spoken = compose(replace(SAID, before="Human: The apple, Robot.\nRobot: The apple? Pineapple."))
    first, second, last = spoken.dialogue.utterances
    assert [(e.text, e.explicit) for e in first.expressions] == [("apple", True)]
    assert [e.text for e in second.expressions] == ["apple"]
    assert [e.text for e in last.expressions] == ["the round red thing", "It"]
    assert {e.referent for e in last.expressions} == {"Apple"}


def test_of_words_within_others_the_longer_ones_are_marked():
    said = replace(SAID, request="Put the round red thing in there, the red thing.")
    for vague in ("red thing, the round red thing, red thing", "the round red thing, red thing"):
        marked = compose(replace(said, vague=vague)).dialogue.instruction.expressions
        assert [one.text for one in marked] == ["the round red thing", "red thing"]
    nested = compose(replace(said, vague="thing, the red thing")).dialogue.instruction.expressions
    assert [one.text for one in nested] == ["thing", "the red thing"]


def test_who_mends_only_the_words_that_are_meant_sees_them_marked(store):
    own = OwnEpisodes(store)
    first, mended = compose(replace(SAID, vague="")), compose(SAID)
    assert compose(replace(SAID, vague="it, the round red thing")).id == mended.id
    for episode in (first, mended):
        own.keep(episode)
        assert own.find(episode.id) == episode
    kept = store.query("select digest from episodes order by digest")
    linked = store.query("select episode_digest as digest from own_episodes order by digest")
    assert kept == linked


def test_how_vague_it_is_follows_from_where_the_object_is_named():
    assert compose(SAID).vagueness == Vagueness("implicit", "short")
    named = replace(SAID, before="A.\nB.\nThe apple.")
    assert compose(named).vagueness == Vagueness("mixed", "standard")
    clear = replace(SAID, request="Put the apple in the fridge.", vague="")
    assert compose(clear).vagueness.reference == "explicit"


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        ({"room": "../etc/passwd"}, "no room"),
        ({"request": "   "}, "request is empty"),
        ({"request": "x" * 10_000}, "10,000 characters; at most 400"),
        ({"before": "x" * 10_000}, "Turn 1 .* 10,000 characters"),
        ({"before": "a\n" * 50}, "50 turns; at most 20"),
        ({"object": ""}, "object is not chosen yet"),
        ({"object": "Zebra"}, "'zebra' is not in this room"),
        ({"destination": "Bed"}, "'bed' is not in this room"),
        ({"destination": "CoffeeMachine"}, "puts no apple into or onto the coffee machine"),
        ({"task_type": "dance"}, "none of this room's"),
        ({"task_type": str(TaskType.STACK), "movable": ""}, "put it into is not chosen"),
        ({"task_type": str(TaskType.STACK), "object": "Bowl", "movable": "Bowl"}, "into itself"),
        ({"vague": "the blue one"}, "nowhere in what is said"),
    ],
)
def test_what_does_not_work_is_said_in_one_sentence(wrong, words):
    with pytest.raises(ReibenchError, match=words):
        compose(replace(SAID, **wrong))


def test_what_is_so_already_is_no_task():
    there = choices("kitchen-6")
    scene = embedded_world()
    rollout = Rollout(compose(SAID), scene)
    held = {t.type: t for t in rollout.start().scene.objects}
    where = held["Apple"].parents[0].split("|")[0]
    assert where in there.places
    with pytest.raises(ReibenchError, match="so already"):
        compose(replace(SAID, destination=where))


@pytest.fixture
def client(store):
    app = FastAPI()
    app.include_router(OwnPages(OwnEpisodes(store)).router())
    return TestClient(app, follow_redirects=False)


def test_the_form_leads_to_where_planners_try_it(client, store):
    answer = client.post("/own", data=vars(SAID))
    assert answer.status_code == 303
    assert answer.headers["location"].startswith("/?episode=own-")
    assert answer.headers["location"].endswith("&actor=side")
    name = compose(SAID).id
    sittings = Sittings([], store, None, more=OwnEpisodes(store).find)
    assert sittings.knows(name)
    assert sittings.open("ann", name).episode == compose(SAID)
    assert client.post("/own", data=vars(SAID)).headers == answer.headers


def test_a_refused_form_keeps_what_was_written_as_text(client, store):
    evil = "<script>alert(1)</script>"
    answer = client.post("/own", data=vars(replace(SAID, before=evil, request="", vague=evil)))
    assert answer.status_code == 400
    assert "request is empty" in answer.text
    assert evil not in answer.text
    assert "&lt;script&gt;alert(1)&lt;/script&gt;" in answer.text
    assert store.query("select * from own_episodes") == []


def test_markup_in_a_dialogue_is_only_text_of_an_episode(client, store):
    answer = client.post("/own", data=vars(replace(SAID, before="Human: <b>Hi</b> '; drop table")))
    assert answer.status_code == 303
    kept = OwnEpisodes(store).find(answer.headers["location"].split("=")[1].split("&")[0])
    assert kept.dialogue.context[0].text == "<b>Hi</b> '; drop table"


def test_another_room_keeps_the_words(client):
    page = client.get("/own", params={"room": "bathroom-1", "request": "Put it there."}).text
    assert "Put it there.</textarea>" in page
    assert "Bathroom 1, seen from above" in page
    assert client.get("/own?room=nonsense&task_type=x").status_code == 200
