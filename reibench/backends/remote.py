"""A language model behind a server, which any number of threads may ask at once."""

import logging
from collections.abc import Sequence
from typing import ClassVar

from reibench.backends import Generation, Prompt, Selection, Usage
from reibench.backends.answers import alternatives
from reibench.backends.constraints import Way, closest, listed, same
from reibench.backends.dialect import ENDPOINTS, Dialect, Endpoint, Server
from reibench.backends.patience import Refused
from reibench.backends.prices import Price
from reibench.errors import ModelUnavailable, ReibenchError

ASKS = 3
"""How often a model that names no option is asked."""
ENDS = (",", ".", "\n")
"""What may follow an option in running text."""
CONTINUE = "Continue the text below from where it ends; answer with what comes next only.\n\n"
BEGUN = "\n\nThis is how the answer begins; answer with how it goes on: "

log = logging.getLogger(__name__)


class RemoteModel:
    """A model behind a server, asked in the server's dialect.

    Plain prompts go to the completions endpoint where the server has it for this model, those for
    chat to the chat endpoint; otherwise to the other one, with words that say what is wanted.
    """

    concurrent: ClassVar[bool] = True

    def __init__(
        self,
        model: str,
        server: Server,
        *,
        endpoint: Endpoint | None = None,
        price: Price | None = None,
    ) -> None:
        """Ask `model` of `server`, always at `endpoint` if one is given."""
        self.name = f"openai:{model}" + (f"?endpoint={endpoint}" if endpoint else "")
        self._server = server
        self._endpoints = (endpoint,) if endpoint else ENDPOINTS
        self._dialect = Dialect(server, model, price)
        self._closed = False

    def generate(
        self, prompt: Prompt, *, max_tokens: int = 128, stop: Sequence[str] = (), grammar: str = ""
    ) -> Generation:
        """Continue `prompt` greedily up to the first of `stop`.

        A `grammar` is kept to where the server takes one (llama.cpp, vLLM); elsewhere the model
        answers freely, and whoever asks must read the answer as it comes.
        """
        endpoint, way = self._route(prompt)
        sent = _question(endpoint, prompt)
        fields = way.holding_within(grammar) if grammar else {}
        if fields is None:
            log.info("%s takes no grammar: %s answers freely", self._server.name, self.name)
        limits: dict[str, object] = {"max_tokens": max_tokens}
        limits |= {"stop": list(stop)[:4]} if stop else {}
        answer = self._dialect.send(endpoint, [sent], limits | (fields or {}))
        text = answer.text
        if endpoint == "chat" and prompt.begun:
            text = text.lstrip().removeprefix(prompt.begun.strip())
        ends = [text.index(one) for one in stop if one in text]
        return Generation(text[: min(ends, default=None)], answer.usage, sent)

    def choose(self, prompt: Prompt, options: Sequence[str]) -> Selection:
        """Return the option the model takes, held to them by what the server offers for that.

        An answer that is no option is asked for again; at last the only option that one of the
        answers can mean is taken. Alternatives are empty where the server gives no probabilities.

        Raises:
            ReibenchError: when no answer means an option.
        """
        endpoint, way = self._route(prompt, choosing=True)
        chat = endpoint == "chat"
        written = {option.strip() if chat else option: option for option in options}
        again = listed(options)
        question = _question(endpoint, prompt) + (way.request if chat else "")
        question += f"\n\n{again}" if chat and way is Way.FREE else ""
        fields = _holding(way, list(written), chat=chat)
        turns, answers, spent = [question], list[str](), Usage()
        while len(answers) < ASKS:
            answer = self._dialect.send(endpoint, turns, fields)
            spent += answer.usage
            answers.append(way.said(answer.text))
            chosen = same(answers[-1], list(written))
            if chosen:
                likely = tuple(alternatives(answer, chosen, written))
                return Selection(written[chosen], spent, likely, "\n\n".join(turns))
            log.info("%s answers %r, which is no option", self.name, answers[-1])
            if chat:
                turns = [question, answer.text or "…", f"That is none of them. {again}"]
        meant = self._meant(answers, list(written))
        return Selection(written[meant], spent, prompt="\n\n".join(turns))

    def close(self) -> None:
        """Close the connections; later calls raise ModelUnavailable."""
        self._closed = True
        self._server.close()

    def _meant(self, answers: Sequence[str], options: Sequence[str]) -> str:
        for answer in reversed(answers):
            if meant := closest(answer, options):
                return meant
        raise ReibenchError(
            f"{self.name} was asked {len(answers)} times for one of {len(options)} options, which"
            f" read like {options[0]!r}, and answered {answers[-1]!r}."
        )

    def _route(self, prompt: Prompt, *, choosing: bool = False) -> tuple[Endpoint, Way]:
        """Return the endpoint for `prompt`, and how it holds to options.

        A choice goes where the model can be held to it, if only one of the two endpoints can.
        """
        if self._closed:
            raise ModelUnavailable(f"{self.name} has been closed; open it again to use it.")
        loose: tuple[Endpoint, Way] | None = None
        refusals = []
        for endpoint in self._endpoints if prompt.chat else reversed(self._endpoints):
            way = self._dialect.way(endpoint)
            if isinstance(way, Refused):
                refusals.append(way)
            elif choosing and way is Way.FREE:
                loose = loose or (endpoint, way)
            else:
                return endpoint, way
        if loose is None:
            raise refusals[0]
        return loose


def _question(endpoint: Endpoint, prompt: Prompt) -> str:
    """Return what is sent as the text, or as the one user turn."""
    if endpoint == "completions":
        return prompt.text + prompt.begun
    text = prompt.text if prompt.chat else CONTINUE + prompt.text
    return text + (BEGUN + prompt.begun if prompt.begun else "")


def _holding(way: Way, options: Sequence[str], *, chat: bool) -> dict[str, object]:
    longest = max(map(len, options))  # a token is at least a character
    fields: dict[str, object] = {"max_tokens": longest + 24, "logprobs": True}
    if way is Way.FREE and not chat:
        fields["stop"] = list(ENDS)
    return fields | way.holding_to(options)
