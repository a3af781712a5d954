"""The case pages: plain documents whose address is their whole state, so that any link can be kept.

Nothing here is Gradio's: a page that is only looked at needs no events. The script that comes along
fetches the same addresses and puts the part that changed in its place.
"""

import json
import re
from collections.abc import Callable, Mapping
from typing import Annotated
from urllib.parse import urlencode, urlparse

import pandas as pd
from fastapi import APIRouter, Form, HTTPException, Request
from fastapi.responses import HTMLResponse, RedirectResponse, Response

from reibench.cases.case import Case, Cases
from reibench.cases.exporting.data import case_data, cases_csv
from reibench.cases.exporting.figure import figure
from reibench.cases.exporting.offline import offline_page
from reibench.cases.filtering import CaseFilter, Found, Kept, find
from reibench.cases.keeping import Keeping
from reibench.cases.table import CaseTable, Hidden, Table
from reibench.cases.views.case_list import (
    MOST_LISTED,
    PAGE,
    address,
    filters,
    listing,
    runs_of,
)
from reibench.cases.views.case_page import case_view
from reibench.cases.views.case_step import step_panel
from reibench.cases.views.keeping import kept_view
from reibench.errors import ReibenchError, UnknownName
from reibench.pages.head import head
from reibench.store import Store
from reibench.view.markup import element, text
from reibench.view.site import document, navigation

HEAD = head("cases", "cases")
FILES: Mapping[str, tuple[str, Callable[[Case, int, int], str | bytes]]] = {
    "html": ("text/html", lambda case, row, lane: offline_page(case, row=row, lane=lane)),
    "json": ("application/json", lambda case, _, __: json.dumps(case_data(case), indent=1)),
    "svg": ("image/svg+xml", lambda case, _, __: figure(case, "svg")),
    "pdf": ("application/pdf", lambda case, _, __: figure(case, "pdf")),
}
"""How a case can be had, with the media type."""
Researcher = Callable[[Request], bool]


class CasePages:
    """The case pages over one database."""

    def __init__(self, store: Store, researcher: Researcher, hidden: Hidden = tuple) -> None:
        """Serve `store`.

        Args:
            store: the database.
            researcher: whether somebody may see what participants did, and keep tags and notes.
            hidden: tells the records that say nothing of people.
        """
        self.table = CaseTable(store, hidden)
        self.keeping = Keeping(store)
        self._cases = Cases(store)
        self.researcher = researcher

    def router(self) -> APIRouter:
        """Return the pages' addresses."""
        router = APIRouter()
        router.get("/cases")(self.cases)
        router.get("/cases/list.csv")(self.table_file)
        router.get("/cases/case.{form}")(self.case_file)
        router.post("/cases/keep")(self.keep)
        return router

    # pages

    def cases(self, request: Request) -> HTMLResponse:
        """Show cases, and one of them; of `part`, only that part of the page."""
        asked = dict(request.query_params)
        researcher = self.researcher(request)
        wanted = CaseFilter.read(asked)
        part = asked.get("part", "")
        try:
            if part == "at":
                case = self.opened(asked, researcher=researcher)
                return HTMLResponse(step_panel(case, *_at(case, asked)))
            if part == "case" and asked.get("runs"):
                return HTMLResponse(self._opened(asked, researcher=researcher))
            found = self.found(wanted, researcher=researcher)
            runs = asked.get("runs") or self._first(found, asked, researcher=researcher)
            if part == "case":
                return HTMLResponse(self._opened(asked | {"runs": runs}, researcher=researcher))
            most = _whole(asked.get("most"), PAGE, MOST_LISTED)
            shown = element(
                "section", filters(wanted, found), listing(wanted, found, runs, most),
                class_="panel finder", id="listing", aria_label="Find a case",
            )  # fmt: skip
            if part == "list":
                return HTMLResponse(shown)
            opened = self._opened(asked | {"runs": runs}, researcher=researcher)
        except UnknownName as problem:
            return self._trouble(str(problem), 404)
        except ReibenchError as problem:
            return self._trouble(str(problem), 400)
        content = element("main", shown, opened, class_="cases", id="content")
        return HTMLResponse(
            document("Cases", navigation("/cases"), content, head=HEAD, page="cases")
        )

    def keep(
        self,
        request: Request,
        runs: Annotated[str, Form()],
        tags: Annotated[str, Form()] = "",
        note: Annotated[str, Form()] = "",
        back: Annotated[str, Form()] = "",
    ) -> Response:
        """Keep tags and a note about the episode of these runs."""
        if not self.researcher(request) or not _ours(request):
            raise HTTPException(403, "Only researchers who are signed in here can keep notes.")
        try:
            case = self.opened({"runs": runs}, researcher=True)
            self.keeping.keep(case.digest, tags, note)
        except ReibenchError as problem:
            return self._trouble(str(problem), 400)
        path = urlparse(back)
        local = not path.scheme and not path.netloc and path.path == "/cases"
        return RedirectResponse(back if local else f"/cases?{urlencode({'runs': runs})}", 303)

    def case_file(self, form: str, request: Request) -> Response:
        """Return a case as a file."""
        asked = dict(request.query_params)
        if form not in FILES:
            raise HTTPException(404, f"A case can be had as {', '.join(FILES)}.")
        try:
            case = self.opened(asked, researcher=self.researcher(request))
        except ReibenchError as problem:
            return self._trouble(str(problem), 404)
        kind, make = FILES[form]
        row, lane = _at(case, asked)
        name = re.sub(r"[^\w.-]+", "-", f"{case.episode.id}.{form}")
        headers = {"Content-Disposition": f'attachment; filename="{name}"'}
        return Response(make(case, row, lane), media_type=kind, headers=headers)

    def table_file(self, request: Request) -> Response:
        """Return the cases that pass the filter as a CSV table."""
        wanted = CaseFilter.read(dict(request.query_params))
        found = self.found(wanted, researcher=self.researcher(request))
        headers = {"Content-Disposition": 'attachment; filename="cases.csv"'}
        return Response(cases_csv(found.cases), media_type="text/csv", headers=headers)

    # what the pages show

    def found(self, wanted: CaseFilter, *, researcher: bool) -> Found:
        """Return the cases that are what is wanted, of those somebody may see."""
        table = self.table.now()
        return find(
            _visible(table, researcher=researcher), wanted, Kept(table.words, self.keeping.tags())
        )

    def opened(self, asked: Mapping[str, str], *, researcher: bool) -> Case:
        """Return the case of the runs an address names.

        Raises:
            ReibenchError: when they make up none, or are not to be seen.
        """
        ids = [each for each in asked.get("runs", "").split(",") if each]
        case = self._cases.open(ids)
        if not researcher and any(run.origin == "study" for run in case.runs):
            raise UnknownName("What participants of a study did is shown to researchers only.")
        return case

    def _first(self, found: Found, asked: Mapping[str, str], *, researcher: bool) -> str:
        """Return the runs to show where the address names none."""
        cases = found.cases
        if episode := asked.get("case"):
            cases = _visible(self.table.now(), researcher=researcher)
            cases = cases[cases["episode"] == episode]
            if cases.empty:
                raise UnknownName(f"No finished run is of an episode {episode[:80]!r}.")
        return runs_of(cases.iloc[0].to_dict()) if len(cases) else ""

    def _opened(self, asked: Mapping[str, str], *, researcher: bool) -> str:
        if not asked["runs"]:
            words = "There is no case to show."
            return element(
                "article", element("p", words, class_="empty"), id="case", class_="detail"
            )
        return self._case(self.opened(asked, researcher=researcher), asked, researcher=researcher)

    def _case(self, case: Case, asked: Mapping[str, str], *, researcher: bool) -> str:
        row, lane = _at(case, asked)
        runs = ",".join(run.id for run in case.runs)
        tags = self.keeping.tags().get(case.digest, ())
        # a note may be about a participant, so it is for those who may see what they did
        note = self.keeping.note(case.digest) if researcher else ""
        back = address(CaseFilter.read(asked), case=case.episode.id, runs=runs)
        kept = kept_view(runs, tags, note, back=back, may_change=researcher)
        return case_view(case, row=row, lane=lane, buttons=_buttons(case, runs), kept=kept)

    def _trouble(self, words: str, status: int) -> HTMLResponse:
        """Return a page that says what is wrong, and where to go on."""
        told = element(
            "div", element("h1", "That did not work"), element("p", text(words), role="alert"),
            element("a", "All cases", href="/cases", class_="btn"), class_="detail trouble",
        )  # fmt: skip
        content = element("main", told, id="content", class_="cases one")
        return HTMLResponse(
            document("Cases", navigation("/cases"), content, head=HEAD, page="cases"), status
        )


def _visible(table: Table, *, researcher: bool) -> pd.DataFrame:
    return table.cases if researcher else table.public


def _at(case: Case, asked: Mapping[str, str]) -> tuple[int, int]:
    """Return the row and the run an address shows: the first divergence unless it says."""
    most = len(case.rows) - 1
    usual = most if case.split is None else case.split
    row = min(_whole(asked.get("step"), usual + 1, most + 1, least=0) - 1, most)
    front = next((n for n, run in enumerate(case.runs) if run.lane == "plain"), 0)
    lane = _whole(asked.get("lane"), front + 1, len(case.runs)) - 1
    return row, lane


def _whole(given: str | None, usual: int, most: int, *, least: int = 1) -> int:
    """Return a number of an address, kept within bounds; `usual` if it is none."""
    if given is None or not given.isdecimal():
        return usual
    return max(least, min(int(given[:9]), most))


def _buttons(case: Case, runs: str) -> list[str]:
    export = element(
        "details",
        element("summary", "Export ▾", class_="btn sm"),
        element(
            "ul",
            *(
                element("li", element("a", words, href=f"/cases/case.{ending}?runs={runs}"))
                for ending, words in (
                    ("html", "Page that opens offline"), ("svg", "Figure (SVG)"),
                    ("pdf", "Figure (PDF)"), ("json", "Data (JSON)"),
                )
            ),
            class_="menu",
        ),
        class_="export",
    )  # fmt: skip
    return [
        element("button", "Copy link", type="button", class_="btn sm", data_do="copy"),
        export,
        _again(case),
    ]


def _again(case: Case) -> str:
    """Return the link that runs the same episode again on the demo page."""
    told = next((run for run in case.runs if run.lane == "told"), None)
    shown = told or next((run for run in case.runs if run.lane == "plain"), None)
    asked = {"episode": case.episode.id, "actor": "side"}
    if shown is not None:
        name = shown.model.partition(":")[2] or shown.model
        asked |= {"model": name, "planner": shown.planner}
    if told is not None:
        asked |= {"method": told.method}
    return element("a", "Run again live", href=f"/?{urlencode(asked)}", class_="btn sm")


def _ours(request: Request) -> bool:
    """Whether a form was sent from a page of this server."""
    origin = request.headers.get("origin") or request.headers.get("referer") or ""
    return urlparse(origin).netloc == request.headers.get("host")
