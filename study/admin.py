"""The researchers' page: a server of its own, closed to whoever has not the password."""

import io
import secrets
import zipfile
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Annotated, get_args

from fastapi import Depends, FastAPI, Form, HTTPException, Query, Request
from fastapi.responses import HTMLResponse, RedirectResponse, Response
from fastapi.security import HTTPBasic, HTTPBasicCredentials

from reibench.errors import ReibenchError, UnknownName
from study.access import COOKIE, LEAST, PASSWORD, password, signed
from study.enrolment import RUN_STATES, Enrolment
from study.exporting import export
from study.people import (
    Judgement,
    Person,
    answers_of,
    history_of,
    judge,
    people_of,
    trials_of,
)
from study.researchers import dashboard, results, studies
from study.researchers.frame import trouble
from study.researchers.person import person as person_page
from study.researchers.trial import LATEST, trial
from study.status import overview, status_of

Guard = Callable[..., None]


def build(enrolment: Enrolment) -> FastAPI:
    """Return the researchers' server; every address of it asks for the password."""
    app = FastAPI(
        docs_url=None, redoc_url=None, openapi_url=None, dependencies=[Depends(_admitted)]
    )

    @app.exception_handler(ReibenchError)
    def told(request: Request, problem: ReibenchError) -> Response:
        status = 404 if isinstance(problem, UnknownName) else 400
        return HTMLResponse(trouble(str(problem)), status)

    _serve_studies(app, enrolment)
    _serve_results(app, enrolment)
    _serve_people(app, enrolment)
    return app


def _serve_studies(app: FastAPI, enrolment: Enrolment) -> None:
    @app.get("/")
    def all_studies() -> HTMLResponse:
        return HTMLResponse(studies.studies(overview(enrolment)))

    @app.get("/-/cases")
    def cases(runs: Annotated[str, Query(pattern="^[0-9a-f]*$")] = "") -> Response:
        shown = RedirectResponse(f"/cases?runs={runs}" if runs else "/cases", 303)
        shown.set_cookie(COOKIE, signed(COOKIE), httponly=True, samesite="strict")
        return shown

    @app.get("/{name}")
    def study(name: str, who: str = "") -> HTMLResponse:
        about, people = enrolment.study(name), people_of(enrolment, name)
        # a study that is only being tried has nobody else to show
        tried = bool(people) and all(one.simulated for one in people)
        simulated = who == "simulated" or (who != "real" and tried)
        status = status_of(enrolment, name, simulated=simulated)
        return HTMLResponse(
            dashboard.study(about, status, people, _token(name), simulated=simulated)
        )

    @app.post("/{name}/state")
    def state(
        name: str,
        state: Annotated[str, Form()],
        token: Annotated[str, Form()],
        reason: Annotated[str, Form()] = "",
    ) -> Response:
        _ours(name, token)
        wanted = next((one for one in RUN_STATES if one == state), None)
        if wanted is None:
            raise HTTPException(400, "There is no such state.")
        enrolment.set_state(name, wanted, reason[:500])
        return RedirectResponse(f"../{name}", 303)


def _serve_results(app: FastAPI, enrolment: Enrolment) -> None:
    @app.get("/{name}/analysis")
    def analysis(name: str, everybody: bool = False) -> HTMLResponse:
        from study.analysis import analyse, draw  # pandas takes a second to import

        found = analyse(enrolment, name, everybody=everybody)
        with TemporaryDirectory() as folder:
            drawn = draw(enrolment, name, Path(folder), everybody=everybody)
            [picture] = [file.read_text() for file in drawn if file.suffix == ".svg"]
        title = enrolment.study(name).title
        return HTMLResponse(results.results(name, title, found, picture, everybody=everybody))

    @app.get("/{name}/export.zip")
    def download(name: str, everybody: bool = False) -> Response:
        with TemporaryDirectory() as folder:
            files = export(enrolment, name, Path(folder), everybody=everybody)
            kept = io.BytesIO()
            with zipfile.ZipFile(kept, "w", zipfile.ZIP_DEFLATED) as archive:
                for file in files:
                    archive.write(file, file.name)
        headers = {"Content-Disposition": f'attachment; filename="{name}.zip"'}
        return Response(kept.getvalue(), media_type="application/zip", headers=headers)


def _serve_people(app: FastAPI, enrolment: Enrolment) -> None:
    @app.get("/{name}/people/{code}")
    def person(name: str, code: str) -> HTMLResponse:
        found = _of_code(enrolment, name, code)
        about = enrolment.study(name, found.version)
        trials, answers = trials_of(enrolment, name, code), answers_of(enrolment, name, code)
        history = history_of(enrolment, name, code)
        return HTMLResponse(person_page(about, found, trials, answers, history, _token(name)))

    @app.post("/{name}/people/{code}")
    def decide(
        name: str,
        code: str,
        judgement: Annotated[str, Form()],
        token: Annotated[str, Form()],
        reason: Annotated[str, Form()] = "",
    ) -> Response:
        _ours(name, token)
        wanted = next((one for one in get_args(Judgement) if one == judgement), None)
        if wanted is None:
            raise HTTPException(400, "There is no such decision.")
        judge(enrolment, name, code, wanted, reason)
        return RedirectResponse(code, 303)

    @app.get("/{name}/people/{code}/{record}")
    def replay(name: str, code: str, record: str, step: int = LATEST) -> HTMLResponse:
        found = _of_code(enrolment, name, code)
        trials = {one["record"]: one for one in trials_of(enrolment, name, code)}
        if record not in trials:
            raise HTTPException(404, "There is no such task of theirs.")
        about = enrolment.study(name, found.version)
        played = enrolment.store.record(record)
        return HTMLResponse(trial(about, found, played, trials[record]["status"], step))


def _of_code(enrolment: Enrolment, name: str, code: str) -> Person:
    found = next((one for one in people_of(enrolment, name) if one.code == code), None)
    if found is None:
        raise HTTPException(404, "There is nobody of that code.")
    return found


def _admitted(
    credentials: Annotated[HTTPBasicCredentials | None, Depends(HTTPBasic(auto_error=False))],
) -> None:
    """Let in who knows the password of the environment; there is none by default."""
    kept = password()
    if not kept:
        raise HTTPException(
            403,
            f"The researchers' page is closed: set {PASSWORD} to a password of {LEAST} characters"
            " or more, and start the app again.",
        )
    given = credentials.password if credentials else ""
    if not secrets.compare_digest(given.encode(), kept.encode()):
        raise HTTPException(
            401, "The password is not right.", {"WWW-Authenticate": 'Basic realm="researchers"'}
        )


def _token(name: str) -> str:
    """Return what proves that a form came from this page: browsers send the password anywhere."""
    return signed(name)


def _ours(name: str, token: str) -> None:
    if not secrets.compare_digest(token.encode(), _token(name).encode()):
        raise HTTPException(403, "This form is not of this page; load it again.")
