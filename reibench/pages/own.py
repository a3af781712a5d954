"""The page where visitors word an episode of their own, and see planners try it."""

from collections.abc import Mapping
from dataclasses import fields, replace
from typing import Annotated
from urllib.parse import urlencode

from fastapi import APIRouter, Depends, Request
from fastapi.responses import HTMLResponse, RedirectResponse, Response

from reibench.errors import ReibenchError
from reibench.household import room_names
from reibench.own_words import OwnEpisodes, Wording, choices, compose
from reibench.pages.head import head
from reibench.view.own_words_form import own_words_form
from reibench.view.site import document, navigation

HEAD = head("own", "own")
FIRST_ROOM = "kitchen-1"
MOST = 20_000
"""Characters of a field that are read."""


FIELDS = tuple(field.name for field in fields(Wording))


def wording(sent: Mapping[str, object]) -> Wording:
    """Return what was filled in, none of it longer than is read; files and the like are nothing."""
    known = {name: sent[name] for name in FIELDS if name in sent}
    kept = {name: value[:MOST] for name, value in known.items() if isinstance(value, str)}
    return Wording(**({"room": ""} | kept))


async def _filled(request: Request) -> Wording:
    return wording(await request.form())


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
        return self._show(wording(request.query_params))

    def made(self, said: Annotated[Wording, Depends(_filled)]) -> Response:
        """Keep the episode and lead to where planners try it; or say what is wrong."""
        try:
            episode = compose(said)
        except ReibenchError as problem:
            return self._show(said, str(problem), 400)
        self._own.keep(episode)
        query = urlencode({"episode": episode.id, "actor": "side"})
        return RedirectResponse(f"/?{query}", 303)

    def _show(self, said: Wording, trouble: str = "", status: int = 200) -> HTMLResponse:
        room = said.room if said.room in room_names() else FIRST_ROOM
        content = own_words_form(replace(said, room=room), choices(room), trouble=trouble)
        made = document("Your own words", navigation("/own"), content, head=HEAD, page="own")
        return HTMLResponse(made, status)
