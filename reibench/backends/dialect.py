"""What one server understands: its endpoints, its way to hold to options, fields it refuses."""

import logging
import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from threading import RLock
from typing import Literal, Protocol, get_args

from reibench.backends.answers import Answer
from reibench.backends.constraints import Way, same
from reibench.backends.patience import Exhausted, Refused
from reibench.backends.prices import Price

Endpoint = Literal["chat", "completions"]
ENDPOINTS: tuple[Endpoint, ...] = get_args(Endpoint)
PATHS: dict[Endpoint, str] = {"chat": "/chat/completions", "completions": "/completions"}

ABSENT = {404, 405, 501}
"""Statuses that say that an endpoint, or the model at it, is not there."""
PROBE = (" 7391", " 7392")
"""Options no model would come to by itself."""
THINKING = 4096
"""Tokens a reasoning model gets beside its answer, which its limit includes."""
TOP: dict[Endpoint, int] = {"chat": 20, "completions": 5}
"""How many likely tokens may be asked for at each endpoint."""
DROPPABLE = ("temperature", "seed", "stop", "max_tokens", "top_logprobs", "logprobs")
"""What a request can do without where a server refuses it."""

log = logging.getLogger(__name__)


class Server(Protocol):
    """What is asked; see `openai.Connection`."""

    name: str

    def post(self, path: str, body: Mapping[str, object]) -> Answer:
        """Return the answer; raises Refused, Exhausted or ModelUnavailable."""
        ...

    def close(self) -> None:
        """Close every connection."""
        ...


class Dialect:
    """Asks one model of one server in the words it understands; safe to share among threads.

    What holds the model to options is found out once for each endpoint, by a question only a
    constraint answers right; a field the server says it does not know is left out from then on.
    """

    def __init__(self, server: Server, model: str, price: Price | None = None) -> None:
        self._server = server
        self._model = model
        self._price = price
        self._lock = RLock()
        self._ways: dict[Endpoint, Way | Refused] = {}
        self._dropped: frozenset[str] = frozenset()

    def way(self, endpoint: Endpoint) -> Way | Refused:
        """Return how `endpoint` holds to options, or its refusal if this model is not there."""
        with self._lock:
            if endpoint not in self._ways:
                self._ways[endpoint] = self._detected(endpoint)
                log.info("%s at %s: %s", self._model, endpoint, self._ways[endpoint])
            return self._ways[endpoint]

    def send(
        self, endpoint: Endpoint, turns: Sequence[str], fields: Mapping[str, object]
    ) -> Answer:
        """Ask for what follows `turns` (the user's, the model's, the user's …; one for text).

        Raises:
            Refused: when the server does not accept it.
            ModelUnavailable: when the key is refused, or patience is exhausted.
        """
        asked = {"temperature": 0.0, "seed": 0, **fields}
        while True:
            body = {"model": self._model, **_body(endpoint, turns, asked, self._dropped)}
            try:
                answer = self._server.post(PATHS[endpoint], body)
            except Refused as refusal:
                if refusal.field not in body:
                    raise
                log.info("%s Going on without %s.", refusal, refusal.field)
                with self._lock:
                    self._dropped |= {refusal.field}
                continue
            dollars = self._price.of(answer.usage) if self._price else 0.0
            return replace(answer, usage=replace(answer.usage, dollars=dollars))

    def _detected(self, endpoint: Endpoint) -> Way | Refused:
        refusal: Refused | None = None
        for way in Way:
            if way is Way.SCHEMA and endpoint == "completions":
                continue
            fields = {"max_tokens": 24, **way.holding_to(PROBE)}
            try:
                answer = self.send(endpoint, [f"Name a colour.{way.request}"], fields)
            except Refused as problem:
                refusal = problem
                if problem.status in ABSENT:
                    break
                continue
            except Exhausted as problem:
                if problem.status != 500 or way is Way.FREE:
                    raise
                continue  # some servers break on a field they do not know
            if way is Way.FREE or same(way.said(answer.text), PROBE):
                return way
        return refusal or Refused(f"{self._server.name} offers no {endpoint}.", status=404)


def _body(
    endpoint: Endpoint, turns: Sequence[str], fields: Mapping[str, object], dropped: frozenset[str]
) -> dict[str, object]:
    body = {name: value for name, value in fields.items() if name not in dropped}
    if "max_tokens" in dropped:
        body["max_completion_tokens"] = int(str(fields["max_tokens"])) + THINKING
    if endpoint == "completions":
        if "logprobs" in body:
            body["logprobs"] = TOP[endpoint]
        return body | {"prompt": turns[0]}
    if "logprobs" in body and "top_logprobs" not in dropped:
        body["top_logprobs"] = TOP[endpoint]
    roles = ("user", "assistant") * len(turns)
    said = [{"role": role, "content": text} for role, text in zip(roles, turns, strict=False)]
    return body | {"messages": said}


def unknown_field(text: str, named: object = None) -> str:
    """Return what a server says it does not know, if it can be left out, or nothing."""
    if not re.search(r"(?i)unsupported|not support|unknown|unrecogni|not permitted|extra", text):
        return ""
    found = [name for name in DROPPABLE if name == named or re.search(rf"\b{name}\b", text)]
    return found[0] if found else ""
