"""The comparison page, and its figure and data as files."""

import csv
import io
from pathlib import Path
from tempfile import TemporaryDirectory

import pandas as pd
from fastapi import APIRouter, HTTPException, Request
from fastapi.responses import HTMLResponse, Response

from reibench.cases.comparing import (
    LEVELS,
    Comparison,
    Contestant,
    choose,
    contestants,
    prepared,
)
from reibench.cases.table import Table
from reibench.cases.views.comparison import comparison_view
from reibench.errors import ReibenchError
from reibench.pages.cases import CasePages
from reibench.pages.head import head
from reibench.score import COUNTED
from reibench.store import Store
from reibench.tally import records_frame
from reibench.view.markup import element, text
from reibench.view.site import document, navigation

HEAD = head("comparison", "comparison")
FORMS = {"svg": "image/svg+xml", "pdf": "application/pdf", "png": "image/png"}


_Prepared = tuple[int, bool, Table, pd.DataFrame, list[Contestant]]
"""Of which table, for whom: its records made ready, and who is among them."""


class ComparisonPages:
    """The comparison over the records of the case pages."""

    def __init__(self, store: Store, cases: CasePages) -> None:
        self._store = store
        self._cases = cases
        self._last: _Prepared | None = None

    def router(self) -> APIRouter:
        """Return the page's addresses."""
        router = APIRouter()
        router.get("/comparison")(self.page)
        router.get("/comparison/figure.{form}")(self.figure)
        router.get("/comparison/data.csv")(self.table)
        return router

    def page(self, request: Request) -> HTMLResponse:
        """Show the runs the address names beside each other."""
        paper = request.query_params.get("paper") != "0"
        status = 200
        try:
            shown, known = self._shown(request)
            inside = comparison_view(shown, known, paper=paper)
        except ReibenchError as problem:
            status = 404
            told = element("p", text(str(problem)), role="alert", class_="empty")
            back = element("a", "All runs", href="/comparison", class_="btn")
            inside = element("section", told, back, class_="panel")
        content = element("main", inside, class_="comparison", id="content")
        made = document(
            "Comparison", navigation("/comparison"), content, head=HEAD, page="comparison"
        )
        return HTMLResponse(made, status)

    def figure(self, form: str, request: Request) -> Response:
        """Return success by level as a figure for print."""
        if form not in FORMS:
            raise HTTPException(404, f"The figure can be had as {', '.join(FORMS)}.")
        from reibench.report.figures import draw_beside_people, draw_figures

        shown = self._or_404(request)
        planners, people = (
            frame[frame["id"].isin(shown.records["id"])] if len(frame) else frame
            for frame in (records_frame(self._store), records_frame(self._store, "study"))
        )
        paper = request.query_params.get("paper") != "0"
        with TemporaryDirectory() as folder:
            try:
                if len(people):
                    files = list(draw_beside_people(people, planners, Path(folder)))
                else:
                    files = list(draw_figures(planners, Path(folder), paper=paper))
            except ReibenchError as problem:
                raise HTTPException(400, str(problem)) from problem
            [made] = [
                file
                for file in files
                if file.suffix == f".{form}" and not file.stem.startswith("success-by-level")
            ]
            content = made.read_bytes()
        return Response(content, media_type=FORMS[form], headers=_named(f"comparison.{form}"))

    def table(self, request: Request) -> Response:
        """Return the numbers behind the page as CSV."""
        shown = self._or_404(request)
        file = io.StringIO()
        writer = csv.writer(file, lineterminator="\n")
        counts = [
            column
            for name in COUNTED
            for column in (name, f"{name}_rate", f"{name}_low", f"{name}_high")
        ]
        writer.writerow(["run", "title", "model", "context", "reference", "episodes", *counts])
        for one in shown.chosen:
            for context, reference in LEVELS:
                row = shown.by_level.get((one.run, context, reference))
                if row is not None:
                    writer.writerow(
                        [
                            one.run,
                            one.title,
                            one.model,
                            context,
                            reference,
                            row["episodes"],
                            *(row[name] for name in counts),
                        ]
                    )
        return Response(file.getvalue(), media_type="text/csv", headers=_named("comparison.csv"))

    def _shown(self, request: Request) -> tuple[Comparison, list[Contestant]]:
        table, researcher = self._cases.table.now(), self._cases.researcher(request)
        last = self._last  # taken once: another request may put something else there meanwhile
        if last is None or last[:2] != (id(table), researcher):
            records = prepared(table, researcher=researcher)
            last = self._last = (id(table), researcher, table, records, contestants(records))
        records, known = last[3:]
        chosen = choose(known, request.query_params.get("runs", ""))
        return Comparison(records, chosen), known

    def _or_404(self, request: Request) -> Comparison:
        try:
            return self._shown(request)[0]
        except ReibenchError as problem:
            raise HTTPException(404, str(problem)) from problem


def _named(name: str) -> dict[str, str]:
    return {"Content-Disposition": f'attachment; filename="{name}"'}
