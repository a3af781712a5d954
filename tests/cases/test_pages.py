"""The case pages and the comparison, through their addresses; and what strangers may try."""

import csv
import html
import io
import json
import re
from dataclasses import replace

import pandas as pd
import pytest
from fastapi import FastAPI, Request
from fastapi.testclient import TestClient

from reibench.cases.comparing import MOST_RUNS, Comparison, Contestant
from reibench.cases.views.case_list import MOST_LISTED
from reibench.cases.views.comparison import look_of
from reibench.pages.cases import CasePages
from reibench.pages.comparison import ComparisonPages
from reibench.run import RunSpec
from tests.cases.conftest import PERSON, SPEC, TOLD


@pytest.fixture
def serve(store):
    """Serve the pages to a researcher, or to anybody."""

    def serve(*, researcher=True):
        app = FastAPI()
        cases = CasePages(store, lambda request: researcher)
        app.include_router(cases.router())
        app.include_router(ComparisonPages(store, cases).router())
        return TestClient(app, base_url="http://here", follow_redirects=False)

    return serve


def copy_record(database, record_id, number):
    """Write a record like this one, of another episode."""
    columns = [row[1] for row in database.execute("pragma table_info(records)")]
    new = {"id": f"copy{number}", "episode": f"e{number}", "episode_digest": f"d{number}"}
    [kept] = database.execute("select * from records where id = ?", [record_id]).fetchall()
    row = dict(zip(columns, kept, strict=True)) | new
    database.execute(
        "insert into episodes select ?, ?, json from episodes where digest = ?",
        [row["episode_digest"], row["episode"], kept[columns.index("episode_digest")]],
    )
    marks = ", ".join("?" * len(row))
    database.execute(f"insert into records ({', '.join(row)}) values ({marks})", [*row.values()])


def listed(page):
    """Return how many cases a page lists."""
    return len(re.findall(r'class="case(?: on)?"', page))


def runs_of(helped):
    return ",".join(record.id for record in helped.values())


def test_the_address_is_the_whole_state(serve, helped):
    client = serve()
    address = f"/cases?runs={runs_of(helped)}&step=2&lane=3&kind=helps"
    first, again = client.get(address), client.get(address)
    assert first.text == again.text
    assert 'data-row="1" data-lane="2"' in first.text
    assert 'aria-current="true"' in first.text


def test_a_case_shows_dialogue_rewrite_steps_verdicts_and_the_chosen_step(serve, helped, episode):
    page = serve().get(f"/cases?runs={runs_of(helped)}").text
    said = next(one for one in episode.dialogue.instruction.expressions if not one.explicit)
    assert f">{said.text}<sup>potato</sup>" in page
    assert "<ins>" in page
    assert "was taken for an apple at step 1; it means the potato." in page
    assert "first divergence" in page
    for lane in ("Person", "SayCan", "SayCan + TOCC"):
        assert lane in page
    assert page.count('class="thumb"') >= 3
    assert "never true" in page


def test_parts_of_the_page_can_be_had_alone(serve, helped):
    client = serve()
    address = f"/cases?runs={runs_of(helped)}&step=3&lane=3"
    whole = client.get(address).text
    for part in ("list", "case", "at"):
        answer = client.get(f"{address}&part={part}")
        assert answer.status_code == 200
        assert "<html" not in answer.text
        assert answer.text in whole


def test_an_address_without_runs_shows_the_same_case_alone_as_in_the_whole_page(serve, helped):
    client = serve()
    for address in ("/cases?", f"/cases?case={helped['plain'].episode.id}&", "/cases?kind=hurts&"):
        alone = client.get(f"{address}part=case")
        assert alone.status_code == 200
        assert alone.text in client.get(address).text


def test_an_odd_step_or_run_is_brought_within_bounds(serve, helped):
    client = serve()
    for odd in ("step=999999999999", "step=-3", "lane=7", "step=x&lane=y", "lane=0", "most=0"):
        assert client.get(f"/cases?runs={runs_of(helped)}&{odd}").status_code == 200


def test_what_is_not_there_is_said_in_a_sentence(serve, helped):
    client = serve()
    for address in (
        "/cases?runs=nonsense",
        "/cases?case=nonsense",
        "/cases/case.html?runs=no",
        "/comparison?runs=nonsense",
        "/cases/case.json?runs=",
    ):
        answer = client.get(address)
        assert answer.status_code == 404, address
        assert 'role="alert"' in answer.text
        assert "Traceback" not in answer.text
    assert client.get(f"/cases/case.exe?runs={runs_of(helped)}").status_code == 404


def test_markup_in_the_address_is_only_text(serve, helped):
    client = serve()
    evil = "<script>alert(1)</script>"
    for name in (
        "words",
        "level",
        "kind",
        "task_type",
        "error",
        "room",
        "planner",
        "model",
        "method",
        "tag",
        "taken",
        "case",
        "runs",
    ):
        answer = client.get("/cases", params={name: evil})
        assert evil not in answer.text, name
        assert answer.status_code in (200, 404)
    assert evil not in client.get("/comparison", params={"runs": evil}).text


def test_participants_trials_are_shown_to_researchers_only(serve, play, episodes, helped):
    trial = play(
        episodes["pick_keys.mixed-short"], PERSON, "find a sofa", origin="study", visitor="SECRET"
    )
    anybody, researcher = serve(researcher=False), serve()
    for address in (
        f"/cases?runs={trial.id}",
        f"/cases/case.json?runs={trial.id}",
        f"/cases?runs={trial.id}&part=at",
    ):
        assert anybody.get(address).status_code == 404
        assert researcher.get(address).status_code == 200
    assert trial.id not in anybody.get("/cases").text + anybody.get("/cases/list.csv").text
    assert trial.id in researcher.get("/cases").text
    assert "SECRET" not in researcher.get(f"/cases?runs={trial.id}").text
    assert "People" not in anybody.get("/comparison").text
    assert "People" in researcher.get("/comparison").text


def test_tags_and_a_note_are_kept_and_found(serve, helped):
    client = serve()
    sent = {
        "runs": runs_of(helped),
        "tags": "odd, <b>fun</b> ,odd",
        "note": "Look & see",
        "back": "/cases?kind=helps",
    }
    answer = client.post("/cases/keep", data=sent, headers={"Origin": "http://here"})
    assert (answer.status_code, answer.headers["location"]) == (303, "/cases?kind=helps")
    page = client.get("/cases?tag=odd").text
    assert "Look &amp; see" in page
    assert "&lt;b&gt;fun&lt;/b&gt;" in page
    assert listed(client.get("/cases?tag=even").text) == 0


def test_notes_are_for_researchers_and_tags_for_everybody(serve, helped):
    sent = {"runs": runs_of(helped), "tags": "odd", "note": "The person in slot 3 was tired."}
    serve().post("/cases/keep", data=sent, headers={"Origin": "http://here"})
    addresses = [
        f"/cases{path}runs={runs_of(helped)}"
        for path in ("?", "?part=case&", "/case.html?", "/case.json?")
    ]
    for address in addresses:
        assert "slot 3" not in serve(researcher=False).get(address).text, address
    anybody, researcher = (serve(researcher=who).get(addresses[0]).text for who in (False, True))
    assert 'class="chip tag">odd<' in anybody
    assert "slot 3" in researcher
    assert "researchers only" in researcher


@pytest.mark.parametrize(
    ("sent", "origin", "status"),
    [
        ({}, "http://here", 422),
        ({"runs": "nonsense"}, "http://here", 400),
        ({"tags": "x" * 99}, "http://here", 400),
        ({"tags": ",".join(map(str, range(50)))}, "http://here", 400),
        ({"note": "x" * 5000}, "http://here", 400),
        ({"tags": "fine"}, "http://elsewhere", 403),
        ({"tags": "fine"}, "", 403),
    ],
)
def test_odd_tags_and_notes_change_nothing(serve, store, helped, sent, origin, status):
    given = {"runs": runs_of(helped)} | sent if sent else {}
    answer = serve().post("/cases/keep", data=given, headers={"Origin": origin})
    assert answer.status_code == status
    assert store.query("select * from tags") == []
    assert store.query("select * from notes") == []


def test_only_researchers_keep_notes_and_nobody_is_led_elsewhere(serve, store, helped):
    sent = {"runs": runs_of(helped), "tags": "x", "back": "//elsewhere/cases"}
    refused = serve(researcher=False).post(
        "/cases/keep", data=sent, headers={"Origin": "http://here"}
    )
    assert refused.status_code == 403
    assert store.query("select * from tags") == []
    kept = serve().post("/cases/keep", data=sent, headers={"Origin": "http://here"})
    assert kept.headers["location"].startswith("/cases?")


def test_a_case_can_be_had_as_data_figure_and_page(serve, helped):
    client = serve()
    had = {
        form: client.get(f"/cases/case.{form}?runs={runs_of(helped)}")
        for form in ("json", "html", "svg", "pdf")
    }
    assert all(answer.status_code == 200 for answer in had.values())
    data = json.loads(had["json"].text)
    assert [len(run["steps"]) for run in data["runs"]] == [
        len(helped[lane].steps) for lane in ("person", "plain", "told")
    ]
    assert had["svg"].text.startswith("<svg")
    assert had["pdf"].content.startswith(b"%PDF")
    page = had["html"].text
    assert not re.search(r'(?:src|href)="(?:https?:)?//', page)
    assert "/web/" not in page
    assert page.count("<template") == 3 * (len(data["rows"]) + 1)


def test_the_list_can_be_had_as_a_table_without_formulas(serve, helped, play, episodes):
    rows = list(csv.DictReader(io.StringIO(serve().get("/cases/list.csv?kind=helps").text)))
    assert [row["plain_id"] for row in rows] == [helped["plain"].id]
    assert not any(cell.startswith(("=", "+", "@")) for row in rows for cell in row.values())


def test_where_the_list_ends_the_way_to_the_others_is_said(serve, store, helped):
    with store.writing() as database:
        for number in range(MOST_LISTED + 39):
            copy_record(database, helped["plain"].id, number)
    client = serve()
    assert "Show 60 more" in client.get("/cases?part=list").text
    last_but_one = client.get(f"/cases?part=list&most={MOST_LISTED - 20}").text
    [link] = re.findall(r'href="([^"]+)">Show 20 more', html.unescape(last_but_one))
    last = client.get(f"{link}&part=list").text
    assert listed(last) == MOST_LISTED
    assert "more</a>" not in last
    assert "The first 2,000 of 2,040 cases are listed." in last
    assert "filters above; the CSV has all" in last
    assert client.get("/cases/list.csv").text.count("\n") == 1 + 2040


def test_the_comparison_counts_what_score_counts(serve, helped, play, episodes):
    play(episodes["pick_keys.mixed-short"], SPEC, "find a sofa")
    play(episodes["pick_keys.mixed-short"], TOLD, "find a sofa")
    client = serve()
    page = client.get("/comparison").text
    assert "SayCan + TOCC, mixed, noised: 100 % (21 to 100), n = 1" in page
    assert "SayCan, mixed, noised: 0 % (0 to 79), n = 1" in page
    assert "+50 points" in page
    assert "potato taken for apple: 1" in page
    rows = list(csv.DictReader(io.StringIO(client.get("/comparison/data.csv").text)))
    told = [row for row in rows if row["title"] == "SayCan + TOCC"]
    assert sum(int(row["success"]) for row in told) == 1
    assert sum(int(row["episodes"]) for row in told) == 2


def test_the_expert_is_no_competitor_and_more_than_fit_cannot_be_added(serve, play, episode):
    play(episode, RunSpec(planner="expert"), "find a sofa")
    runs = [replace(SPEC, model=f"scripted:{number}") for number in range(MOST_RUNS + 1)]
    for run in runs:
        play(episode, run, "find a sofa")
    client = serve()
    five, six = (
        client.get(f"/comparison?runs={','.join(run.id for run in runs[:number])}").text
        for number in (MOST_RUNS - 1, MOST_RUNS)
    )
    assert "Add runs" in five
    assert "Add runs" not in six
    assert "6 at most: leave one out to add another" in six
    assert "xpert" not in five


def test_every_bar_leads_to_its_cases(serve, helped):
    client = serve()
    page = client.get("/comparison").text
    links = {link.replace("&amp;", "&") for link in re.findall(r'href="(/cases\?[^"]+)"', page)}
    assert links
    for link in links:
        assert listed(client.get(f"{link}&part=list").text) >= 1, link


def test_every_cell_of_what_confuses_what_leads_to_its_cases(serve, play, episode, episodes):
    play(episodes["pick_keys.mixed-short"], TOLD, "find a bowl", "pick up the bowl")
    play(episodes["pick_keys.mixed-short"], SPEC)
    play(episode, PERSON, "find an apple", "pick up the apple", origin="study", visitor="P1")
    client = serve()
    for run, words in (
        (TOLD.id, "key chain taken for bowl"),
        (SPEC.id, "key chain taken for none"),
        ("people", "potato taken for apple"),
    ):
        page = html.unescape(client.get(f"/comparison?runs={run}").text)
        [link] = re.findall(rf'href="([^"]+taken=[^"]+)"[^>]+title="{words}: 1"', page)
        assert listed(client.get(f"{link}&part=list").text) == 1, link


def test_one_task_says_nothing_about_others_in_words(serve, helped):
    page = serve().get("/comparison").text
    assert "+100 points (no interval: only one seed task) on 1 episode;" in page
    assert "nan" not in re.findall(r"[\w-]+", page)


def test_people_are_for_researchers_whoever_asks_at_the_same_time(store, play, episodes):
    play(episodes["pick_keys.mixed-short"], PERSON, "find a sofa", origin="study", visitor="P1")
    play(episodes["pick_keys.mixed-short"], SPEC, "find a sofa")
    request = Request({"type": "http", "query_string": b"", "headers": []})

    class Anybody:
        """No researcher; while that is looked at, a researcher's request is answered."""

        def __bool__(self):
            return False

        def __eq__(self, other):
            asking.append(True)
            assert b"People" in pages.table(request).body
            return other is False

        __hash__ = None

    asking = [Anybody(), False]
    pages = ComparisonPages(store, CasePages(store, lambda request: asking.pop()))
    assert b"People" not in pages.table(request).body
    assert b"People" not in pages.table(request).body


def test_the_gallery_does_not_count(serve, store, helped):
    with store.writing() as database:
        database.execute("update records set origin = 'gallery' where origin = 'run'")
    client = serve()
    alone = client.get("/comparison").text
    assert "No run is recorded yet" in alone
    assert "SayCan + TOCC, implicit, noised: published 29.4 %" in alone
    assert alone.count('class="pub"') == 2 * 9
    assert 'class="bar-link"' not in alone
    assert listed(client.get("/cases").text) == 1


def test_the_published_numbers_can_be_left_out(serve, helped):
    client = serve()
    assert client.get("/comparison").text.count('class="pub"') == 1 + 2 * 9
    assert client.get("/comparison?paper=0").text.count('class="pub"') == 1  # in the switch


def test_every_thing_that_was_taken_is_in_the_matrix():
    taken = [f"Thing{number}" for number in range(9)]
    records = pd.DataFrame({"run": "a", "meant": "Potato", "taken": [*taken, "Potato", ""]})
    found = Comparison(records, [Contestant("a", "saycan", "none", "m", "strict", 11)])
    rows, columns, counts = found.confusions("a")
    assert rows == ["Potato"]
    assert sum(counts.get(("Potato", column), 0) for column in columns) == len(records)


def test_blue_is_the_run_with_tocc_whatever_else_is_shown():
    def one(run, method):
        return Contestant(run, "saycan", method, "m", "strict", 1)

    chosen = [one("a", "none"), one("b", "ap"), one("c", "tocc"), one("d", "none"), one("e", "icl")]
    looks = look_of(chosen)
    assert (looks["a"], looks["c"]) == ("c-plain", "c-tocc")
    assert len(set(looks.values())) == len(chosen)
    six = [one(str(number), "ap") for number in range(6)]
    assert len(set(look_of(six).values())) == 6


def test_the_comparison_can_be_had_as_a_figure(serve, helped):
    client = serve()
    assert client.get("/comparison/figure.svg").content.startswith(b"<?xml")
    assert client.get("/comparison/figure.pdf").content.startswith(b"%PDF")
    assert client.get("/comparison/figure.exe").status_code == 404
