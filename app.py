"""The web app: settings, database, pages and files put together on one FastAPI server."""

import argparse
import os
import sys
from contextlib import suppress
from pathlib import Path
from urllib.parse import urlencode

os.environ.setdefault("GRADIO_ANALYTICS_ENABLED", "False")  # read when gradio is imported

import gradio as gr
import uvicorn
from fastapi import FastAPI, HTTPException, Request
from fastapi.responses import FileResponse, RedirectResponse
from fastapi.staticfiles import StaticFiles

from reibench import gallery, models
from reibench.backends.opening import open_backend
from reibench.commands.options import add_world, default_world
from reibench.dataset.files import shipped_episodes
from reibench.errors import ModelUnavailable, ReibenchError
from reibench.own_words import OwnEpisodes
from reibench.pages import demo
from reibench.pages.cases import CasePages
from reibench.pages.comparison import ComparisonPages
from reibench.pages.head import HEAD, head
from reibench.pages.listening import listen
from reibench.pages.own import OwnPages
from reibench.pages.wiring import MOUNTED
from reibench.run import RunSpec
from reibench.sittings import Sittings
from reibench.store import Store
from reibench.view.site import LINKS
from reibench.worlds import Camera
from reibench.worlds.naming import check_world
from study import admin as study_admin
from study import pages as study_pages
from study.access import is_researcher
from study.enrolment import Enrolment
from study.people import no_trials

WEB = Path(__file__).parent / "assets" / "web"


def make_app(database: str, model: str = "", world: str = "embedded") -> FastAPI:
    """Return the server over the database at this path; `model` overrules the shelf."""
    store = Store(Path(database))
    gallery.load(store)
    own = OwnEpisodes(store)
    spec = RunSpec(world=world)
    sittings = Sittings(shipped_episodes(), store, open_backend, spec=spec, more=own.find)
    app = FastAPI(title="REI-Bench", docs_url=None, redoc_url=None, openapi_url=None)
    app.mount("/web", StaticFiles(directory=WEB), name="web")

    @app.get("/frames/{record}/{step}-{camera}.png")
    def frame(record: str, step: int, camera: Camera) -> FileResponse:
        known = store.entries("id = ?", [record])
        path = store.frames.find(known[0].id, step, camera) if known else None
        if path is None:
            raise HTTPException(404, "There is no such frame.")
        return FileResponse(path, media_type="image/png")

    @app.get("/admin")
    def researchers() -> RedirectResponse:
        return RedirectResponse("/admin/")

    @app.get("/s/{study}")
    def take_part(study: str, request: Request) -> RedirectResponse:
        query = urlencode({"study": study, **request.query_params})
        return RedirectResponse(f"/study/?{query}")

    shown = {"favicon_path": WEB / "favicon.svg", **MOUNTED}
    enrolment = Enrolment(store)
    cases = CasePages(store, is_researcher, lambda: no_trials(store))
    app.include_router(cases.router())
    app.include_router(ComparisonPages(store, cases).router())
    app.include_router(OwnPages(own).router())
    app.mount("/admin", study_admin.build(enrolment))
    taking_part = study_pages.build(enrolment)
    gr.mount_gradio_app(app, taking_part, path="/study", head=head("study", "study"), **MOUNTED)
    # whoever comes first finds the default model ready, or nearly
    with suppress(ModelUnavailable):
        sittings.prepare(model or f"llama-cpp:{models.best_present()}")
    page = demo.build(sittings, links=LINKS, model=model)
    return gr.mount_gradio_app(app, page, path="/", head=HEAD, **shown)


def main() -> int:
    """Serve on the host and port of the arguments or the environment; 2 for a user's mistake."""
    parser = argparse.ArgumentParser(description="Serve the REI-Bench demo.")
    setting = os.environ.get
    parser.add_argument("--host", default=setting("REIBENCH_HOST", "127.0.0.1"))
    parser.add_argument("--port", type=int, default=setting("REIBENCH_PORT", "7860"))
    parser.add_argument("--db", default=setting("REIBENCH_DB", "data/reibench.db"))
    parser.add_argument("--model", default=setting("REIBENCH_MODEL", ""), help="not the best one")
    add_world(parser, default_world())
    given = parser.parse_args()
    try:
        check_world(given.world)
        with listen(given.host, given.port) as listening:
            config = uvicorn.Config(
                make_app(given.db, given.model, given.world), log_level="warning"
            )
            sys.stderr.write(f"REI-Bench is at http://{given.host}:{given.port}\n")
            uvicorn.Server(config).run(sockets=[listening])
    except ReibenchError as problem:
        sys.stderr.write(f"{problem}\n")
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
