"""The page where visitors word an episode of their own, and see planners try it."""

from typing import Annotated
from urllib.parse import urlencode

from fastapi import APIRouter, Form, Request
from fastapi.responses import HTMLResponse, RedirectResponse, Response
from pydantic import BaseModel

from reibench.episode import TaskType
from reibench.errors import ReibenchError
from reibench.household import room_names
from reibench.own_words import OwnEpisodes, Wording, choices, compose
from reibench.pages.head import head
from reibench.view.own_words_form import own_words_form
from reibench.view.site import document

HEAD = head("own", "own")
FIRST_ROOM = "kitchen-1"
MOST = 20_000
"""Characters of a field that are read."""


class Filled(BaseModel):
    """The form's fields as they were sent."""

    room: str = ""
    before: str = ""
    request: str = ""
    task_type: str = str(TaskType.PICK)
    object: str = ""
    destination: str = ""
    movable: str = ""
    vague: str = ""

    def wording(self) -> Wording:
        """Return them, none longer than is read."""
        return Wording(**{name: value[:MOST] for name, value in self.model_dump().items()})


class OwnPages:
    """The page over one database's own episodes."""

    def __init__(self, own: OwnEpisodes) -> None:
        self._own = own

    def router(self) -> APIRouter:
        """Return the page's addresses."""
        router = APIRouter()
        router.get("/own")(self.page)
        router.post("/own")(self.made)
        return router

    def page(self, request: Request) -> HTMLResponse:
        """Show the form; the address may fill it in."""
        return self._show(Filled(**dict(request.query_params)).wording())

    def made(self, filled: Annotated[Filled, Form()]) -> Response:
        """Keep the episode and lead to where planners try it; or say what is wrong."""
        said = filled.wording()
        try:
            episode = compose(said)
        except ReibenchError as problem:
            return self._show(said, str(problem), 400)
        self._own.keep(episode)
        query = urlencode({"episode": episode.id, "actor": "side"})
        return RedirectResponse(f"/?{query}", 303)

    def _show(self, said: Wording, trouble: str = "", status: int = 200) -> HTMLResponse:
        room = said.room if said.room in room_names() else FIRST_ROOM
        shown = Wording(**{**vars(said), "room": room})
        content = own_words_form(shown, choices(room), trouble=trouble)
        made = document("Your own words", "/own", content, head=HEAD, page="own")
        return HTMLResponse(made, status)
