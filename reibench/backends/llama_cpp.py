"""GGUF language models through llama.cpp, on the processor or whatever device it was built for."""

import json
import logging
from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import takewhile
from pathlib import Path
from threading import Lock
from time import perf_counter
from typing import Any
from urllib.request import ProxyHandler, Request, build_opener

from reibench import models
from reibench.backends import Backend, Generation, Prompt, Selection, Usage, backends
from reibench.backends.llama_server import (
    has_chat_template,
    open_server,
    processors,
    server_version,
    variants_of,
)
from reibench.backends.prefixes import Prefixes, fingerprint, folder, prepare
from reibench.backends.slots import Slots, Variant
from reibench.backends.walk import OPTION_ENDS, Node, Walk, grow, inside_line
from reibench.errors import ModelUnavailable, ReibenchError, unknown

SLOTS = 8
"""Prompts kept evaluated side by side: six task types' examples and two rewriting prompts."""
BETWEEN = -1
"""Stands between texts that are turned into tokens together; no token is called that."""
BIAS = 200.0
"""Lifts the allowed tokens above all others; the softmax of the rest is then 0 in single floats."""

DIRECT = build_opener(ProxyHandler({}))
"""Speaks to this process's own loopback port, which no proxy of the user's could reach."""

log = logging.getLogger(__name__)


class LlamaCpp:
    """A GGUF model in this process; calls are taken one at a time, from any thread.

    Each fixed prompt prefix has its own slot, where llama.cpp keeps it evaluated, so only what is
    new in a prompt costs time; on disk it outlives the process. `choose` is a greedy walk over the
    options' own tokens: at each token that tells options apart the likeliest is taken, as the
    published planner's `select` does; the likeliest option as a whole may be another.
    """

    def __init__(
        self,
        path: Path,
        *,
        name: str = "",
        threads: int = 0,
        slots: int = SLOTS,
        cache: Path | None = None,
        adapters: Mapping[str, Path] | None = None,
    ) -> None:
        """Open `path`; raises ModelUnavailable.

        Args:
            path: a GGUF file.
            name: what it is called on the command line.
            threads: how many it computes with; 0 for those of the machine.
            slots: prompts kept evaluated side by side.
            cache: where prefixes are kept.
            adapters: GGUF files with adapters, by name; a prompt says which of them it is for.
        """
        self.name = name or f"llama-cpp:{path}"
        self._path = path
        self._lock = Lock()
        self._chat = has_chat_template(path)
        kept = prepare(cache or folder())
        files = dict(adapters or {})
        self.adapters = frozenset(files)
        self._server: Any = open_server(path, threads or processors(), slots, kept, files.values())
        self._variants = variants_of(files)
        prefixes = Prefixes(kept, f"{fingerprint(path)} {server_version()}") if kept else None
        self._slots = Slots(slots, self._complete, self._post, prefixes)
        self._roots: dict[tuple[str, ...], Node] = {}

    def generate(
        self, prompt: Prompt, *, max_tokens: int = 128, stop: Sequence[str] = (), grammar: str = ""
    ) -> Generation:
        """Continue `prompt` greedily up to the first of `stop`, within a GBNF `grammar`."""
        with self._lock:
            started = perf_counter()
            sent = self._formatted(prompt)
            variant = self._variant(prompt)
            slot, before = self._place(prompt, sent, variant)
            request: dict[str, object] = {**variant.request, "prompt": sent, "id_slot": slot}
            request |= {
                "cache_prompt": True,
                "n_predict": max_tokens,
                "temperature": 0.0,
                "stop": list(stop),
            }
            if grammar:
                request["grammar"] = grammar
            answer = self._complete(request)
            usage = _usage(answer, started)
            usage = replace(usage, cached_tokens=max(0, usage.cached_tokens - before))
            return Generation(answer["choices"][0]["text"], usage, sent)

    def choose(self, prompt: Prompt, options: Sequence[str]) -> Selection:
        """Return the option that a greedy walk over `options`' tokens takes after `prompt`."""
        with self._lock:
            started = perf_counter()
            root = self._root(tuple(options))
            sent = self._formatted(prompt)
            variant = self._variant(prompt)
            slot, before = self._place(prompt, sent, variant)
            common = {**variant.request, "id_slot": slot, "cache_prompt": True}
            start = self.tokens(sent)
            asked: list[Usage] = []

            def ask(path: tuple[int, ...], children: Sequence[int]) -> Mapping[int, float]:
                weighing = _weighing((*start, *path), children)
                answer = self._complete({**weighing, **common})
                asked.append(_usage(answer))
                [token] = answer["choices"][0]["logprobs"]["content"]
                return {one["id"]: one["prob"] for one in token["top_probs"]}

            walk = Walk(ask)
            text = walk.greedy(root)
            alternatives = walk.alternatives(text)
            # all questions share the prompt: only what was new in each was evaluated
            evaluated = before + sum(one.prompt_tokens - one.cached_tokens for one in asked)
            tokens = len(start) + len(walk.tokens)
            cached = max(0, tokens - evaluated)
            seconds = perf_counter() - started
            usage = Usage(tokens, cached, len(walk.tokens), seconds)
            return Selection(text, usage, alternatives, sent)

    def close(self) -> None:
        """Free the model; later calls raise ModelUnavailable."""
        with self._lock:
            self._server = None

    def tokens(self, text: str) -> tuple[int, ...]:
        """Return the tokens of a prompt as it is sent."""
        request = {"content": text, "add_special": True, "parse_special": True}
        return tuple(self._post("/tokenize", request)["tokens"])

    def _root(self, options: tuple[str, ...]) -> Node:
        if options not in self._roots:
            texts = (*OPTION_ENDS, *options)
            tokens = self._parts([*texts, *("a" + text for text in texts), "a"])
            inside = {text: inside_line(text, tokens.__getitem__) for text in texts}
            ends = tuple(inside[end][0] for end in OPTION_ENDS)
            self._roots[options] = grow({option: inside[option] for option in options}, ends)
        return self._roots[options]

    def _parts(self, texts: Sequence[str]) -> dict[str, tuple[int, ...]]:
        """Return the tokens of each of `texts`, asking once: a question each takes a second."""
        content = [part for text in texts for part in (text, BETWEEN)]
        request = {"content": content, "add_special": False, "parse_special": False}
        answer = iter(self._post("/tokenize", request)["tokens"])
        return {text: tuple(takewhile(lambda token: token != BETWEEN, answer)) for text in texts}

    def _formatted(self, prompt: Prompt) -> str:
        if not (prompt.chat and self._chat):
            return prompt.text + prompt.begun
        messages = [{"role": "user", "content": prompt.text}]
        template: str = self._post("/apply-template", {"messages": messages})["prompt"]
        return template + prompt.begun

    def _variant(self, prompt: Prompt) -> Variant:
        if prompt.adapter not in self._variants:
            raise unknown(f"adapter of {self.name}", prompt.adapter, self.adapters)
        return self._variants[prompt.adapter]

    def _place(self, prompt: Prompt, sent: str, variant: Variant) -> tuple[int, int]:
        """Return the slot for a prompt, and the tokens evaluated for its fixed prefix just now."""
        begin = sent.find(prompt.text[: prompt.fixed])
        prefix = sent[: begin + prompt.fixed] if begin >= 0 and prompt.fixed else ""

        def shared() -> list[int]:
            # where the prefix ends, its last token may be another than in the prompt
            both = zip(self.tokens(prefix), self.tokens(sent), strict=False)
            return [one for one, _ in takewhile(lambda pair: pair[0] == pair[1], both)]

        return self._slots.place(prefix, shared, variant=variant)

    def _complete(self, request: Mapping[str, object]) -> Mapping[str, Any]:
        answer: dict[str, Any] = self._running().handle_completions(dict(request))
        if "error" in answer:
            raise ReibenchError(f"{self.name} refuses a prompt: {answer['error']['message']}.")
        return answer

    def _post(self, path: str, content: Mapping[str, object]) -> dict[str, Any]:
        body = json.dumps(content).encode()
        address = self._running().listening_address + path
        request = Request(address, body, {"Content-Type": "application/json"})
        with DIRECT.open(request) as response:
            answer: dict[str, Any] = json.load(response)
        return answer

    def _running(self) -> Any:
        if self._server is None:
            raise ModelUnavailable(f"{self.name} has been closed; open it again to use it.")
        return self._server


def _weighing(path: Sequence[int], children: Sequence[int]) -> dict[str, object]:
    """Ask how probable each of `children` is after `path`, and nothing else.

    The one token that is drawn is ignored: what is wanted are the probabilities it is drawn by.
    """
    return {
        "prompt": list(path),
        "n_predict": 1,
        "logit_bias": [[child, BIAS] for child in children],
        "samplers": ["top_k", "temperature"],
        "top_k": len(children),
        "temperature": 1.0,
        "seed": 0,
        "n_probs": len(children),
        "post_sampling_probs": True,
    }


def _usage(answer: Mapping[str, Any], started: float | None = None) -> Usage:
    usage = answer["usage"]
    return Usage(
        prompt_tokens=usage["prompt_tokens"],
        cached_tokens=usage["prompt_tokens_details"]["cached_tokens"],
        completion_tokens=usage["completion_tokens"],
        seconds=0.0 if started is None else perf_counter() - started,
    )


@backends.register("llama-cpp")
def open_model(source: str) -> Backend:
    """Open a model of the shelf by its name, or a GGUF file by its path."""
    if source.lower().endswith(".gguf") or Path(source).is_file():
        return LlamaCpp(Path(source).expanduser())
    names = [model.name for model in models.shelf()]
    if source not in names:
        raise unknown("language model", source, [*names, "PATH.gguf"])
    taught = models.adapters_of(source)
    return LlamaCpp(models.path_of(source), name=f"llama-cpp:{source}", adapters=taught)
