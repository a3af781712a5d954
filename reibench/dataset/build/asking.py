"""Asking a model: again with the complaint, from the cache where it was asked before, at a cost."""

import hashlib
import json
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TypeVar

from reibench.backends import Backend, Prompt, Usage
from reibench.errors import ReibenchError

T = TypeVar("T")


class Unfit(ReibenchError):
    """An answer that is of no use: why, in few words for the report, and as told to the model."""

    def __init__(self, reason: str, complaint: str) -> None:
        super().__init__(complaint)
        self.reason = reason
        self.complaint = complaint


@dataclass(frozen=True)
class Price:
    """What a million tokens cost, in any currency."""

    prompt: float = 0.0
    completion: float = 0.0

    def of(self, usage: Usage) -> float:
        """Return what `usage` cost."""
        return (
            usage.prompt_tokens * self.prompt + usage.completion_tokens * self.completion
        ) / 1_000_000


class Asker:
    """Asks a backend, and keeps every answer in a folder, so that nothing is paid for twice."""

    def __init__(
        self,
        backend: Backend,
        cache: Path | None = None,
        *,
        retries: int = 2,
        max_tokens: int = 900,
    ) -> None:
        """Ask `backend`.

        Args:
            backend: what to ask.
            cache: the folder of answers; None keeps none.
            retries: how often an unfit answer is complained about.
            max_tokens: the longest answer.
        """
        self._backend = backend
        self._cache = cache
        self._retries = retries
        self._max_tokens = max_tokens
        self.usage = Usage()
        """What was spent in this process; answers from the cache are free."""
        self.asked = 0
        self.from_cache = 0

    @property
    def name(self) -> str:
        """What the backend is called."""
        return self._backend.name

    def ask(
        self,
        prompt: str,
        read: Callable[[str], T],
        *,
        stop: Sequence[str] = (),
    ) -> T:
        """Return what `read` makes of the answer; complains and asks again where it is unfit.

        Raises:
            Unfit: when the last answer was still unfit.
        """
        text = prompt
        for left in range(self._retries, -1, -1):
            answer = self._answer(text, stop)
            try:
                return read(answer)
            except Unfit as problem:
                if not left:
                    raise
                text = (
                    f"{prompt}\n\nAn earlier answer was not right: {problem.complaint}"
                    " Please answer again and mend that.\n\n"
                )
        raise AssertionError("unreachable")  # the last answer is returned or raised

    def _answer(self, text: str, stop: Sequence[str]) -> str:
        request = json.dumps([self._backend.name, text, list(stop), self._max_tokens])
        path = self._path(request)
        if path and path.exists():
            self.from_cache += 1
            return str(json.loads(path.read_text(encoding="utf-8"))["answer"])
        prompt = Prompt(text, chat=True)
        made = self._backend.generate(prompt, max_tokens=self._max_tokens, stop=stop)
        self.asked += 1
        self.usage += made.usage
        if path:
            kept = {
                "backend": self._backend.name,
                "prompt": text,
                "answer": made.text,
                "usage": asdict(made.usage),
            }
            path.parent.mkdir(parents=True, exist_ok=True)
            part = path.with_suffix(".part")  # a kill leaves no half of an answer behind
            part.write_text(json.dumps(kept, ensure_ascii=False, indent=1), encoding="utf-8")
            part.replace(path)
        return made.text

    def _path(self, request: str) -> Path | None:
        if self._cache is None:
            return None
        return self._cache / f"{hashlib.sha256(request.encode()).hexdigest()[:32]}.json"
