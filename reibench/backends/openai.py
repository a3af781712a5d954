"""Models behind an OpenAI-compatible server: OpenAI, vLLM, Ollama, llama.cpp's own.

Keys come from the environment and go nowhere but into requests.
"""

import json
import logging
import os
import re
from collections.abc import Mapping
from ipaddress import ip_address
from time import perf_counter
from typing import TYPE_CHECKING, Any
from urllib.parse import parse_qsl, urlsplit

from reibench.backends import Backend, backends
from reibench.backends.answers import Answer, read_answer
from reibench.backends.dialect import ENDPOINTS, unknown_field
from reibench.backends.patience import Patience, Refused, Trouble, asked_wait, spent_for
from reibench.backends.prices import price_of
from reibench.backends.remote import RemoteModel
from reibench.errors import ModelUnavailable, ReibenchError, UnknownName, unknown

if TYPE_CHECKING:
    from openai import APIStatusError

OPENAI = "https://api.openai.com/v1"
SECONDS = 120.0
"""How long an answer may take, unless `REIBENCH_OPENAI_SECONDS` says otherwise."""
PASSING = {408, 409, 425, 429, *range(500, 505), 529}
"""Statuses after which asking again may help."""

log = logging.getLogger(__name__)


class Connection:
    """Requests to one server, from any thread; what it refuses or lacks becomes one clear error."""

    def __init__(
        self, address: str, key: str, *, seconds: float = SECONDS, patience: Patience | None = None
    ) -> None:
        """Prepare to speak to `address`, which a proxy is not asked for if it is on this machine.

        Raises:
            ModelUnavailable: when it needs a key, and there is none.
        """
        from openai import DefaultHttpxClient, OpenAI  # heavy, and only servers need it

        parts = urlsplit(address)
        self.host = parts.hostname or ""
        self.name = f"{parts.scheme}://{self.host}" + (f":{parts.port}" if parts.port else "")
        if not key and not _loopback(self.host):
            raise ModelUnavailable(
                f"{self.name} needs a key and OPENAI_API_KEY is not set; set it, or"
                " OPENAI_BASE_URL to a server on this machine, e.g. http://127.0.0.1:8000/v1."
            )
        self._key = key
        self._seconds = seconds
        self._patience = patience or Patience()
        self._client = OpenAI(
            base_url=address,
            api_key=key or "none",
            timeout=seconds,
            max_retries=0,
            http_client=DefaultHttpxClient(trust_env=not _loopback(self.host)),
        )

    def post(self, path: str, body: Mapping[str, object]) -> Answer:
        """Send `body` until it is answered.

        Raises:
            Refused: when it never will be.
            ModelUnavailable: when the key is refused, or patience is exhausted.
        """
        return self._patience.persist(lambda: self._ask(path, body))

    def models(self) -> list[str]:
        """Return the models the server lists, none where it lists nothing; raises like `post`."""

        def ask() -> list[str]:
            content, _ = self._exchange("/models", None)
            entries = content.get("data") if isinstance(content, dict) else None
            return [entry["id"] for entry in entries or () if "id" in entry]

        try:
            return Patience(tries=2, first=0.1).persist(ask)
        except Refused:
            return []

    def close(self) -> None:
        """Close every connection."""
        self._client.close()

    def _ask(self, path: str, body: Mapping[str, object]) -> Answer:
        started = perf_counter()
        content, headers = self._exchange(path, body)
        try:
            answer = read_answer(content, perf_counter() - started)
        except ValueError as error:
            raise Trouble(f"{self.name} sent {error}") from None
        usage = answer.usage
        self._patience.pause(spent_for(headers, usage.prompt_tokens + usage.completion_tokens))
        return answer

    def _exchange(
        self, path: str, body: Mapping[str, object] | None
    ) -> tuple[Any, Mapping[str, str]]:
        import httpx2
        from openai import APIConnectionError, APIStatusError, APITimeoutError

        # What the client raises may quote the key: none of it is chained to our errors.
        problem: Exception
        try:
            if body is None:
                response = self._client.get(path, cast_to=httpx2.Response)
            else:
                response = self._client.post(path, body=dict(body), cast_to=httpx2.Response)
            return json.loads(response.content), response.headers
        except APITimeoutError:
            problem = Trouble(f"{self.name} did not answer within {self._seconds:g} s")
        except APIConnectionError as error:
            cause = f" ({self._hide(str(error.__cause__))})" if error.__cause__ else ""
            problem = Trouble(f"{self.name} cannot be reached, or broke off{cause}")
        except APIStatusError as error:
            problem = self._refusal(error)
        except ValueError:
            problem = Trouble(f"{self.name} sent half an answer, or none in JSON")
        raise problem

    def _refusal(self, error: "APIStatusError") -> Exception:
        status, code = error.status_code, str(error.code or "")
        text = self._hide(_message(error))
        said = f"{self.name} says (HTTP {status}): {text}"
        if status in PASSING and code != "insufficient_quota":
            return Trouble(said, wait=asked_wait(error.response.headers), status=status)
        if status in (401, 403):
            return ModelUnavailable(f"{said}; check OPENAI_API_KEY and OPENAI_BASE_URL.")
        return Refused(f"{said}.", status=status, field=unknown_field(text, error.param))

    def _hide(self, text: str) -> str:
        """Take the key out of `text`, also where the server quotes it in part."""
        whole = text.replace(self._key, "(key)") if self._key else text
        return re.sub(r"\bsk-[\w*-]+", "(key)", whole)


def _message(error: "APIStatusError") -> str:
    body = error.body
    text = body.get("message") if isinstance(body, dict) else body
    return str(text or error.message)[:400].rstrip(".")


def _loopback(host: str) -> bool:
    try:
        return ip_address(host).is_loopback
    except ValueError:
        return host == "localhost"


@backends.register("openai")
def open_remote(source: str) -> Backend:
    """Open a model of the server that `OPENAI_BASE_URL` names, `NAME` or `NAME?endpoint=…`."""
    model, _, query = source.partition("?")
    options = dict(parse_qsl(query, keep_blank_values=True))
    wanted = options.pop("endpoint", None)
    endpoint = next((one for one in ENDPOINTS if one == wanted), None)
    if wanted is not None and endpoint is None:
        raise unknown("endpoint", wanted, ENDPOINTS)
    if options or not model:
        raise UnknownName(
            f"'openai:{source}' names no model; it should read openai:NAME, or"
            " openai:NAME?endpoint=completions."
        )
    patience = Patience(per_minute=_number("REIBENCH_OPENAI_PER_MINUTE", 0.0))
    connection = Connection(
        os.environ.get("OPENAI_BASE_URL") or OPENAI,
        os.environ.get("OPENAI_API_KEY", ""),
        seconds=_number("REIBENCH_OPENAI_SECONDS", SECONDS),
        patience=patience,
    )
    connection.models()  # a server that is not there, or a wrong key, is said before a run begins
    price = price_of(model) if connection.host == urlsplit(OPENAI).hostname else None
    if connection.host == urlsplit(OPENAI).hostname and price is None:
        log.warning("no price of %s is known: its cost is counted as 0", model)
    return RemoteModel(model, connection, endpoint=endpoint, price=price)


def _number(variable: str, default: float) -> float:
    text = os.environ.get(variable) or str(default)
    try:
        return float(text)
    except ValueError:
        raise ReibenchError(f"{variable} is {text!r}; it should be a number.") from None
