"""Timing SayCan on a real model: seconds and tokens per step, beside the published selection."""

import json
import os
import platform
import subprocess
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise, takewhile
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory
from time import perf_counter, process_time

from reibench import models
from reibench.backends import Backend, Generation, Prompt, Selection
from reibench.backends.llama_cpp import LlamaCpp
from reibench.backends.llama_server import processors
from reibench.bench.published import Chosen, Published, load, missing, versions
from reibench.dataset.files import shipped_episodes
from reibench.dataset.sample import select
from reibench.episode import Episode
from reibench.methods import methods
from reibench.planners.saycan import SayCan
from reibench.rollout import Rollout, drive
from reibench.worlds import worlds

LEVEL = "mixed-standard"
"""At which the dialogues are played: one of each of six task types."""
STEPS = 6
"""Steps played of each."""
RESTARTS = 3


@dataclass(frozen=True)
class Asked:
    """One choice, and what it cost."""

    prompt: Prompt
    selection: Selection
    seconds: float
    processor_seconds: float
    """Seconds of processor time, all threads together: other processes count less in it."""
    kept: Chosen | None = None
    """What the published selection made of the same prompt, right after."""
    afresh: Chosen | None = None
    """The same with nothing kept; as it takes long, only at one step of an episode."""

    @property
    def evaluated(self) -> int:
        """Tokens that were evaluated for it."""
        return self.selection.usage.prompt_tokens - self.selection.usage.cached_tokens


class Timed:
    """A model whose choices are timed, one after the other with the published selection."""

    def __init__(self, model: Backend, published: Published | None) -> None:
        self.name = model.name
        self.asked: list[Asked] = []
        self._model, self._published = model, published

    def generate(
        self, prompt: Prompt, *, max_tokens: int = 128, stop: Sequence[str] = (), grammar: str = ""
    ) -> Generation:
        """Continue `prompt`, untimed."""
        return self._model.generate(prompt, max_tokens=max_tokens, stop=stop, grammar=grammar)

    def choose(self, prompt: Prompt, options: Sequence[str]) -> Selection:
        """Return the model's choice."""
        started, used = perf_counter(), process_time()
        selection = self._model.choose(prompt, options)
        seconds, used = perf_counter() - started, process_time() - used
        asked = Asked(prompt, selection, seconds, used)
        if self._published:
            kept = self._published.choose(selection.prompt, options)
            asked = replace(asked, kept=kept)
        if self._published and len(self.asked) == 1:
            afresh = self._published.choose_afresh(selection.prompt, options)
            asked = replace(asked, afresh=afresh)
        self.asked.append(asked)
        return selection

    def close(self) -> None:
        """Free the model."""
        self._model.close()


@dataclass(frozen=True)
class Start:
    """A model opened in a new process."""

    open_seconds: float
    first_step_seconds: float
    first_step_processor_seconds: float
    evaluated: int
    """Tokens evaluated for the first step."""


def dialogues() -> list[Episode]:
    """Return the episodes that are played."""
    return [one for one in select(shipped_episodes(), "gold") if one.id.endswith(f".{LEVEL}")]


def play(
    model: Backend, numbers: Sequence[int], steps: int, published: Published | None = None
) -> Iterator[list[Asked]]:
    """Play episodes, by their numbers, as the published code does; yield what was asked in each.

    All have the same examples before them.
    """
    episodes = dialogues()
    for number in numbers:
        timed = Timed(model, published)
        told = methods.create("none").instruct(episodes[number].dialogue, timed)
        rollout = Rollout(episodes[number], worlds.create("embedded"), max_steps=steps)
        rollout.start()
        for _ in drive(rollout, SayCan(timed, examples="fixed"), told):
            pass
        yield timed.asked


def start(name: str, threads: int, cache: Path, number: int) -> Start:
    """Open a model and take the first step of an episode."""
    began = perf_counter()
    model = LlamaCpp(models.path_of(name), threads=threads, cache=cache)
    opened = perf_counter() - began
    [[first]] = play(model, [number], steps=1)
    model.close()
    return Start(opened, first.seconds, first.processor_seconds, first.evaluated)


def restart(name: str, threads: int, cache: Path, number: int) -> Start:
    """Do the same in a new process."""
    code = (
        "import json, sys; from dataclasses import astuple; from pathlib import Path;"
        "from reibench.bench.planner import start;"
        "name, threads, cache, number = sys.argv[1:];"
        "print(json.dumps(astuple(start(name, int(threads), Path(cache), int(number)))))"
    )
    command = [sys.executable, "-c", code, name, str(threads), str(cache), str(number)]
    done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True)
    return Start(*json.loads(done.stdout))


def tokens_new(model: LlamaCpp, before: Sequence[Asked], asked: Sequence[Asked]) -> list[int]:
    """Return how many tokens each step's prompt and answer have that nothing before it had.

    `before` is what was asked before the first of them, of which the last counts.
    """
    new = []
    for last, one in pairwise([*before[-1:], *asked]):
        old = model.tokens(last.selection.prompt + last.selection.text)
        both = zip(old, model.tokens(one.selection.prompt), strict=False)
        common = sum(1 for _ in takewhile(lambda pair: pair[0] == pair[1], both))
        new.append(one.selection.usage.prompt_tokens - common)
    return new


def bench_planner(
    name: str, *, threads: int = 0, steps: int = STEPS, restarts: int = RESTARTS
) -> dict[str, object]:
    """Return what `bench planner --json` prints; takes some minutes with the published way."""
    threads, path, lacking = threads or processors(), models.path_of(name), missing()
    warm_numbers = range(1, len(dialogues()))
    with TemporaryDirectory() as folder:
        cache = Path(folder)
        began = perf_counter()
        model = LlamaCpp(path, threads=threads, cache=cache)
        opened = perf_counter() - began
        [first] = play(model, [0], steps)
        starts = [restart(name, threads, cache, 1) for _ in range(restarts)]
        published = None if lacking else load(name, threads)
        if published:
            next(play(model, [0], 1, published))  # its first episode is not counted either
        warm = [one for each in play(model, warm_numbers, steps, published) for one in each]
        new = tokens_new(model, first, warm)
        model.close()
    return {
        "model": name,
        "machine": _machine(threads),
        "options": 215,
        "open_seconds": round(opened, 3),
        "first_step_seconds": round(first[0].seconds, 3),
        "first_episode_seconds_per_step": _mean([one.seconds for one in first]),
        **_beside(warm, lacking),
        **_after_restart(starts),
        "tokens_of_first_prompt": first[0].selection.usage.prompt_tokens,
        "tokens_evaluated_per_step": _mean([one.evaluated for one in warm]),
        "tokens_new_per_step": _mean(new),
        "steps_measured": len(warm),
        "reported": "medians of seconds per warm step, means of tokens",
    }


def _after_restart(starts: Sequence[Start]) -> dict[str, object]:
    """Return what opening the model and a first step cost where prefixes are kept on disk."""
    opened = median(one.open_seconds for one in starts)
    first = median(one.first_step_seconds for one in starts)
    used = median(one.first_step_processor_seconds for one in starts)
    return {
        "open_after_restart_seconds": round(opened, 3),
        "first_step_after_restart_seconds": round(first, 3),
        "first_step_after_restart_processor_seconds": round(used, 3),
        "tokens_evaluated_after_restart": round(median(one.evaluated for one in starts)),
        "restarts_measured": len(starts),
    }


def _beside(warm: Sequence[Asked], lacking: str) -> dict[str, object]:
    """Return what warm steps cost, ours and the published way's on the same prompts."""
    ours = [(one.seconds, one.processor_seconds) for one in warm]
    afresh = [other for one in warm if (other := one.afresh)]
    kept = [other for one in warm if (other := one.kept)]
    same = sum(one.kept.text == one.selection.text for one in warm if one.kept)
    return {
        "warm_seconds_per_step": round(median(seconds for seconds, _ in ours), 4),
        "warm_processor_seconds_per_step": round(median(used for _, used in ours), 4),
        **_their("guidance", "ratio", afresh, ours),
        **_their("guidance_mended", "ratio_mended", kept, ours),
        "guidance_same_choices": same if kept else None,
        "guidance": lacking or versions(),
    }


def _their(
    name: str, ratio: str, theirs: Sequence[Chosen], ours: Sequence[tuple[float, float]]
) -> dict[str, object]:
    """Return the figures of one published way, null where it was not measured."""
    names = (
        f"{name}_seconds_per_step",
        ratio,
        f"{name}_processor_seconds_per_step",
        f"{ratio}_of_processor_seconds",
        f"{name}_tokens_evaluated_per_step",
        f"{name}_steps_measured",
    )
    if not theirs:
        return dict.fromkeys(names)
    seconds = median(one.seconds for one in theirs)
    used = median(one.processor_seconds for one in theirs)
    values = (
        round(seconds, 4),
        round(seconds / median(seconds for seconds, _ in ours), 2),
        round(used, 4),
        round(used / median(used for _, used in ours), 2),
        _mean([one.evaluated for one in theirs]),
        len(theirs),
    )
    return dict(zip(names, values, strict=True))


def _mean(numbers: Sequence[float]) -> float:
    return round(sum(numbers) / len(numbers), 3)


def _machine(threads: int) -> dict[str, object]:
    """Return what the numbers hang on; load above the processors' number means a shared machine."""
    load = os.getloadavg() if hasattr(os, "getloadavg") else (0.0, 0.0, 0.0)
    about = Path("/proc/cpuinfo")
    lines = about.read_text().splitlines() if about.exists() else []
    named = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return {
        "processor": named[0] if named else platform.processor() or platform.machine(),
        "processors": os.cpu_count(),
        "threads": threads,
        "load_average": [round(one, 1) for one in load],
        "system": platform.platform(),
    }
