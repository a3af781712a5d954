"""Causal language models, chat or base, through transformers, on a processor or an accelerator."""

from collections.abc import Mapping, Sequence
from threading import Lock
from time import perf_counter
from typing import Any

from reibench.backends import Backend, Generation, Prompt, Selection, Usage, backends
from reibench.backends.transformers.constraint import Constraint, guidance_tokenizer
from reibench.backends.transformers.evaluation import Evaluator
from reibench.backends.transformers.loading import Loaded, load
from reibench.backends.transformers.source import Source, parse_source
from reibench.backends.walk import OPTION_ENDS, Node, Walk, grow, inside_line
from reibench.errors import ModelUnavailable

TAIL = 8
"""Tokens of the prompt that are decoded before an answer: how a token reads may hang on them."""


class Transformers:
    """A causal model in this process; calls are taken one at a time, from any thread.

    The last prompts stay evaluated, so only what is new in a prompt costs time, and tokens that
    leave no choice are evaluated together with the next question. `choose` is the same greedy walk
    as llama.cpp's backend takes.
    """

    def __init__(self, source: Source, *, name: str = "") -> None:
        """Load `source`; raises ModelUnavailable."""
        self.name = name or f"hf:{source.name}"
        self._lock = Lock()
        self._loaded: Loaded | None = load(source)
        self._evaluator: Evaluator | None = Evaluator(self._loaded.model, source.slots)
        self._ends = _ends(self._loaded)
        self._roots: dict[tuple[str, ...], Node] = {}
        self._guidance: Any = None

    def generate(
        self, prompt: Prompt, *, max_tokens: int = 128, stop: Sequence[str] = (), grammar: str = ""
    ) -> Generation:
        """Continue `prompt` greedily up to the first of `stop`, within a GBNF `grammar`."""
        with self._lock:
            started = perf_counter()
            evaluator, constraint = self._running(), self._constraint(grammar)
            sent, start = self._begin(prompt)
            before, answer, text = evaluator.evaluated, list[int](), ""
            while len(answer) < max_tokens and not (constraint and constraint.over):
                scores = evaluator.scores((*start, *answer))
                token = int((constraint.allow(scores) if constraint else scores).argmax())
                if token in self._ends:
                    break
                answer.append(token)
                if constraint:
                    constraint.take(token)
                text = self._decoded(start, answer)
                if any(end in text for end in stop):
                    break
            text = text[: min((text.find(end) for end in stop if end in text), default=None)]
            fed = max(0, len(answer) - 1)  # the last one drawn is not evaluated any more
            cached = max(0, len(start) + fed - (evaluator.evaluated - before))
            usage = Usage(len(start), cached, len(answer), perf_counter() - started)
            return Generation(text, usage, sent)

    def choose(self, prompt: Prompt, options: Sequence[str]) -> Selection:
        """Return the option that a greedy walk over `options`' tokens takes after `prompt`."""
        with self._lock:
            started = perf_counter()
            evaluator = self._running()
            root = self._root(tuple(options))
            sent, start = self._begin(prompt)
            before = evaluator.evaluated

            def ask(path: tuple[int, ...], children: Sequence[int]) -> Mapping[int, float]:
                scores = evaluator.scores((*start, *path))
                shares = scores[list(children)].softmax(0).tolist()
                return dict(zip(children, shares, strict=True))

            walk = Walk(ask)
            text = walk.greedy(root)
            alternatives = walk.alternatives(text)
            tokens = len(start) + len(walk.tokens)
            cached = max(0, tokens - (evaluator.evaluated - before))
            usage = Usage(tokens, cached, len(walk.tokens), perf_counter() - started)
            return Selection(text, usage, alternatives, sent)

    def close(self) -> None:
        """Free the model; later calls raise ModelUnavailable."""
        with self._lock:
            self._loaded = self._evaluator = self._guidance = None

    def _running(self) -> Evaluator:
        if self._evaluator is None:
            raise ModelUnavailable(f"{self.name} has been closed; open it again to use it.")
        return self._evaluator

    @property
    def _tokenizer(self) -> Any:
        assert self._loaded is not None
        return self._loaded.tokenizer

    def _begin(self, prompt: Prompt) -> tuple[str, tuple[int, ...]]:
        """Return what is sent, in the chat template if asked for and there is one, and its tokens.

        A template brings its own special tokens; plain text gets those the tokenizer adds.
        """
        chat = prompt.chat and bool(self._tokenizer.chat_template)
        sent = prompt.text
        if chat:
            turns = [{"role": "user", "content": prompt.text}]
            sent = self._tokenizer.apply_chat_template(
                turns, tokenize=False, add_generation_prompt=True
            )
        sent += prompt.begun
        return sent, self._tokens(sent, special=not chat)

    def _tokens(self, text: str, *, special: bool = False) -> tuple[int, ...]:
        return tuple(self._tokenizer(text, add_special_tokens=special).input_ids)

    def _decoded(self, start: tuple[int, ...], answer: list[int]) -> str:
        """Return how `answer` reads after `start`: alone, some tokenizers drop its first space."""
        tail = list(start[-TAIL:])
        as_is = {"skip_special_tokens": False, "clean_up_tokenization_spaces": False}
        before: str = self._tokenizer.decode(tail, **as_is)
        whole: str = self._tokenizer.decode(tail + answer, **as_is)
        return whole[len(before) :]

    def _root(self, options: tuple[str, ...]) -> Node:
        if options not in self._roots:
            ends = tuple(inside_line(end, self._tokens)[0] for end in OPTION_ENDS)
            tokens = {option: inside_line(option, self._tokens) for option in options}
            self._roots[options] = grow(tokens, ends)
        return self._roots[options]

    def _constraint(self, grammar: str) -> Constraint | None:
        if not grammar:
            return None
        if self._guidance is None:
            vocabulary = self._running().model.config.get_text_config().vocab_size
            self._guidance = guidance_tokenizer(self._tokenizer, vocabulary)
        return Constraint(grammar, self._guidance)


def _ends(loaded: Loaded) -> frozenset[int]:
    """Return the tokens that end an answer: those the model is said to end with, and special ones.

    A chat model ends its turn with a special token that not every checkpoint lists.
    """
    listed = loaded.model.generation_config.eos_token_id
    listed = listed if isinstance(listed, list) else [listed]
    added = loaded.tokenizer.added_tokens_decoder.items()
    special = [number for number, token in added if token.special]
    ends = (*listed, loaded.tokenizer.eos_token_id, *special)
    return frozenset(end for end in ends if end is not None)


@backends.register("hf")
def open_checkpoint(source: str) -> Backend:
    """Open a checkpoint of the hub, a folder, a GGUF file or a model of the shelf."""
    return Transformers(parse_source(source), name=f"hf:{source}")
