"""GGUF language models through llama.cpp, on the processor or whatever device it was built for."""

import json
import logging
import os
from collections import OrderedDict
from collections.abc import Mapping, Sequence
from pathlib import Path
from threading import Lock
from time import perf_counter
from typing import Any
from urllib.request import ProxyHandler, Request, build_opener

from reibench import models
from reibench.backends import Backend, Generation, Prompt, Selection, Usage, backends
from reibench.backends.walk import OPTION_ENDS, Node, Walk, grow, inside_line
from reibench.errors import ModelUnavailable, ReibenchError, unknown

SLOTS = 8
"""Prompts kept evaluated side by side: six task types' examples and two rewriting prompts."""
CONTEXT = 3072
"""Tokens a prompt and its answer may have together."""
BIAS = 200.0
"""Lifts the allowed tokens above all others; the softmax of the rest is then 0 in single floats."""

DIRECT = build_opener(ProxyHandler({}))
"""Speaks to this process's own loopback port, which no proxy of the user's could reach."""

log = logging.getLogger(__name__)


class LlamaCpp:
    """A GGUF model in this process; calls are taken one at a time, from any thread.

    Each fixed prompt prefix has its own slot, where llama.cpp keeps it evaluated, so only what is
    new in a prompt costs time. `choose` is a greedy walk over the options' own tokens: at each
    token that tells options apart the likeliest is taken, as the published planner's `select`
    does; the likeliest option as a whole may be another.
    """

    def __init__(self, path: Path, *, name: str = "", threads: int = 0, slots: int = SLOTS) -> None:
        """Open `path`; raises ModelUnavailable."""
        self.name = name or f"llama-cpp:{path}"
        self._path = path
        self._lock = Lock()
        self._chat = _has_chat_template(path)
        self._server: Any = _open(path, threads or _processors(), slots)
        self._slot_of: OrderedDict[str, int] = OrderedDict((f"\0{n}", n) for n in range(slots))
        self._tokens_of: dict[str, tuple[int, ...]] = {}
        self._roots: dict[tuple[str, ...], Node] = {}

    def generate(
        self, prompt: Prompt, *, max_tokens: int = 128, stop: Sequence[str] = (), grammar: str = ""
    ) -> Generation:
        """Continue `prompt` greedily up to the first of `stop`, within a GBNF `grammar`."""
        with self._lock:
            started = perf_counter()
            sent = self._formatted(prompt)
            request: dict[str, object] = {"prompt": sent}
            request |= {"n_predict": max_tokens, "temperature": 0.0, "stop": list(stop)}
            if grammar:
                request["grammar"] = grammar
            answer = self._complete(request, prompt)
            return Generation(answer["choices"][0]["text"], _usage(answer, started), sent)

    def choose(self, prompt: Prompt, options: Sequence[str]) -> Selection:
        """Return the option that a greedy walk over `options`' tokens takes after `prompt`."""
        with self._lock:
            started = perf_counter()
            root = self._root(tuple(options))
            sent = self._formatted(prompt)
            start = self._tokenize(sent, special=True)
            asked: list[Usage] = []

            def ask(path: tuple[int, ...], children: Sequence[int]) -> Mapping[int, float]:
                answer = self._complete(_weighing((*start, *path), children), prompt)
                asked.append(_usage(answer))
                [token] = answer["choices"][0]["logprobs"]["content"]
                return {one["id"]: one["prob"] for one in token["top_probs"]}

            walk = Walk(ask)
            text = walk.greedy(root)
            alternatives = walk.alternatives(text)
            # all questions share the prompt: only what was new in each was evaluated
            evaluated = sum(usage.prompt_tokens - usage.cached_tokens for usage in asked)
            tokens = len(start) + len(walk.tokens)
            cached = max(0, tokens - evaluated)
            seconds = perf_counter() - started
            usage = Usage(tokens, cached, len(walk.tokens), seconds)
            return Selection(text, usage, alternatives, sent)

    def close(self) -> None:
        """Free the model; later calls raise ModelUnavailable."""
        with self._lock:
            self._server = None

    def _root(self, options: tuple[str, ...]) -> Node:
        if options not in self._roots:
            ends = tuple(self._after_option(end)[0] for end in OPTION_ENDS)
            self._roots[options] = grow({o: self._after_option(o) for o in options}, ends)
        return self._roots[options]

    def _after_option(self, text: str) -> tuple[int, ...]:
        """Return the tokens of `text` as they are inside a line, not at the start of one."""
        if text not in self._tokens_of:
            self._tokens_of[text] = inside_line(
                text, lambda part: self._tokenize(part, special=False)
            )
        return self._tokens_of[text]

    def _formatted(self, prompt: Prompt) -> str:
        if not (prompt.chat and self._chat):
            return prompt.text + prompt.begun
        messages = [{"role": "user", "content": prompt.text}]
        template: str = self._post("/apply-template", {"messages": messages})["prompt"]
        return template + prompt.begun

    def _tokenize(self, text: str, *, special: bool) -> tuple[int, ...]:
        request = {"content": text, "add_special": special, "parse_special": special}
        return tuple(self._post("/tokenize", request)["tokens"])

    def _slot(self, prompt: Prompt) -> int:
        """Return the slot that keeps this prompt's fixed prefix, or the one unused longest."""
        prefix = prompt.text[: prompt.fixed]
        if prefix not in self._slot_of:
            _, slot = self._slot_of.popitem(last=False)
            self._slot_of[prefix] = slot
        self._slot_of.move_to_end(prefix)
        return self._slot_of[prefix]

    def _complete(self, request: Mapping[str, object], prompt: Prompt) -> dict[str, Any]:
        request = {**request, "id_slot": self._slot(prompt), "cache_prompt": True}
        answer: dict[str, Any] = self._running().handle_completions(request)
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


def _open(path: Path, threads: int, slots: int) -> Any:
    if not path.is_file():
        raise ModelUnavailable(
            f"There is no model file {path}; give the path of a GGUF file, or the name of a model"
            f" on the shelf ({', '.join(model.name for model in models.shelf())})."
        )
    with path.open("rb") as file:
        if file.read(4) != b"GGUF":
            raise ModelUnavailable(
                f"{path} is no GGUF file (it does not begin with 'GGUF'); download it again, or"
                " give another file."
            )
    from xllamacpp import CommonParams, Server  # heavy: only when a model is really opened

    params = CommonParams()
    params.model.path = str(path)
    params.n_parallel = slots
    params.n_ctx = slots * CONTEXT
    params.cpuparams.n_threads = threads
    params.warmup = False
    params.swa_full = True  # a sliding window forgets prefixes, which are then evaluated again
    params.cache_ram_mib = 0  # the slots hold all we reuse
    params.verbosity = -1
    started = perf_counter()
    try:
        server = Server(params)
    except RuntimeError as error:
        raise ModelUnavailable(
            f"llama.cpp cannot open {path} ({path.stat().st_size:,} bytes): the file is damaged or"
            " cut off, of an unknown kind, or too big for the memory; download it again."
        ) from error
    # A server that is let go before its loop has begun waits for ever; an answer proves it runs.
    server.handle_completions({"prompt": "a", "n_predict": 1, "cache_prompt": False})
    log.info("opened %s in %.1f s", path, perf_counter() - started)
    return server


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


def _has_chat_template(path: Path) -> bool:
    # asked for a template, llama.cpp gives a default where the file has none
    if not path.is_file():
        return False
    with path.open("rb") as file:
        return b"tokenizer.chat_template" in file.read(1 << 25)


def _processors() -> int:
    usable = getattr(os, "sched_getaffinity", None)
    return min(8, len(usable(0)) if usable else os.cpu_count() or 1)


@backends.register("llama-cpp")
def open_model(source: str) -> Backend:
    """Open a model of the shelf by its name, or a GGUF file by its path."""
    if source.lower().endswith(".gguf") or Path(source).is_file():
        return LlamaCpp(Path(source).expanduser())
    names = [model.name for model in models.shelf()]
    if source not in names:
        raise unknown("language model", source, [*names, "PATH.gguf"])
    return LlamaCpp(models.path_of(source), name=f"llama-cpp:{source}")
