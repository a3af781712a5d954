"""The web app: settings, database, pages and files put together on one FastAPI server."""

import argparse
import os
import socket
import sys
from pathlib import Path

os.environ.setdefault("GRADIO_ANALYTICS_ENABLED", "False")  # read when gradio is imported

import gradio as gr
import uvicorn
from fastapi import FastAPI
from fastapi.staticfiles import StaticFiles

from reibench.backends.opening import open_backend
from reibench.dataset.files import shipped_episodes
from reibench.errors import ReibenchError
from reibench.pages import demo
from reibench.pages.head import HEAD
from reibench.sittings import Sittings
from reibench.store import Store

WEB = Path(__file__).parent / "assets" / "web"


def make_app(database: str, model: str = "") -> FastAPI:
    """Return the server over the database at this path; `model` overrules the shelf."""
    sittings = Sittings(shipped_episodes(), Store(Path(database)), open_backend)
    app = FastAPI(title="REI-Bench", docs_url=None, redoc_url=None, openapi_url=None)
    app.mount("/web", StaticFiles(directory=WEB), name="web")
    page = demo.build(sittings, model=model)
    return gr.mount_gradio_app(
        app, page, path="/", head=HEAD, favicon_path=WEB / "favicon.svg", footer_links=[],
        run_history=False, enable_monitoring=False,
    )  # fmt: skip


def listen(host: str, port: int) -> socket.socket:
    """Return a socket bound to the address; raises ReibenchError if that cannot be had."""
    try:
        return socket.create_server((host, port))
    except (OSError, OverflowError) as problem:
        why = getattr(problem, "strerror", "") or problem
        raise ReibenchError(
            f"Cannot serve on {host}, port {port}: {why}. Stop what uses it, or choose another port"
            " with --port."
        ) from problem


def main() -> int:
    """Serve on the host and port of the arguments or the environment; 2 for a user's mistake."""
    parser = argparse.ArgumentParser(description="Serve the REI-Bench demo.")
    setting = os.environ.get
    parser.add_argument("--host", default=setting("REIBENCH_HOST", "127.0.0.1"))
    parser.add_argument("--port", type=int, default=setting("REIBENCH_PORT", "7860"))
    parser.add_argument("--db", default=setting("REIBENCH_DB", "data/reibench.db"))
    parser.add_argument("--model", default=setting("REIBENCH_MODEL", ""), help="not the best one")
    given = parser.parse_args()
    try:
        with listen(given.host, given.port) as listening:
            config = uvicorn.Config(make_app(given.db, given.model), log_level="warning")
            sys.stderr.write(f"REI-Bench is at http://{given.host}:{given.port}\n")
            uvicorn.Server(config).run(sockets=[listening])
    except ReibenchError as problem:
        sys.stderr.write(f"{problem}\n")
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
