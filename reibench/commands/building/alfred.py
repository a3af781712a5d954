"""`build-dataset --alfred`: nine levels around the instructions of ALFRED's annotators."""

from argparse import ArgumentParser, Namespace
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from random import Random

from reibench.backends.opening import open_backend
from reibench.commands.building.realised import UNSAID, kept_lexicon, wanted_levels
from reibench.commands.checking import unsolved
from reibench.commands.output import say, say_json, table, tell
from reibench.dataset.alfred import Trial, find_trials
from reibench.dataset.build.asking import Asker
from reibench.dataset.build.from_alfred import TrialOutcome, chosen_seed, realise_trials
from reibench.dataset.build.pipeline import build
from reibench.dataset.files import stream_episodes
from reibench.dataset.levels import derive
from reibench.dataset.realise.compose import Realiser
from reibench.dataset.scripts import SCRIPTS, read_scripts
from reibench.dialogue import LEVELS
from reibench.episode import Episode, Task
from reibench.errors import ReibenchError


def add(command: ArgumentParser) -> None:
    """Add the option that names the trials."""
    group = command.add_argument_group("from ALFRED, with the realiser or with --model")
    group.add_argument(
        "--alfred",
        type=Path,
        metavar="DIR",
        help="where traj_data.json files are; --seeds N of them",
    )


def build_from_alfred(arguments: Namespace) -> int:
    """Write the episodes of every trial whose words can be built on; report what was dropped."""
    if arguments.out.suffix == ".txt":
        raise ReibenchError(
            "Scripts cannot hold a trial's poses; write episodes, --out FILE.jsonl."
        )
    trials = _chosen(find_trials(arguments.alfred), arguments)
    levels = wanted_levels(arguments.levels)
    outcomes: list[TrialOutcome] = []

    def episodes() -> Iterator[Episode]:
        for found in _outcomes(trials, arguments):
            outcomes.append(found)
            tell(f"[{len(outcomes)}/{len(trials)}] {found.trial.id}: {found.reason or 'kept'}")
            if found.script:
                yield from derive(found.script, levels)

    count = stream_episodes(arguments.out, episodes())
    _report(arguments, outcomes, count)
    return 0


def _chosen(trials: Sequence[Trial], arguments: Namespace) -> Sequence[Trial]:
    """Return all trials, or so many of them as `--seeds` asks for."""
    if arguments.seeds is None:
        return trials
    if not arguments.seeds.isdecimal() or int(arguments.seeds) < 1:
        raise ReibenchError(f"With --alfred, --seeds is a number of trials: {arguments.seeds!r}.")
    number = min(int(arguments.seeds), len(trials))
    return Random(arguments.seed).sample(list(trials), number)


def _outcomes(trials: Sequence[Trial], arguments: Namespace) -> Iterator[TrialOutcome]:
    if arguments.model is None:
        realiser = Realiser(kept_lexicon(arguments))
        yield from realise_trials(trials, realiser, arguments.seed, _why_unsolved)
        return
    backend = open_backend(arguments.model)
    asker = Asker(
        backend, arguments.answers, retries=arguments.retries, max_tokens=arguments.max_tokens
    )
    examples = read_scripts(SCRIPTS / "gold.txt")
    try:
        for trial in trials:
            found, outcome = chosen_seed(trial, _why_unsolved)
            if outcome and not outcome.reason:
                [outcome] = build([outcome.seed], asker, examples)
            yield TrialOutcome(trial, found, outcome)
    finally:
        backend.close()


def _why_unsolved(task: Task) -> str:
    try:
        return unsolved(Episode(replace(task, id="unsaid"), UNSAID, LEVELS[0]))
    except ReibenchError as problem:  # a trial that cannot be set up is dropped like others
        return str(problem)


def _report(arguments: Namespace, outcomes: Sequence[TrialOutcome], episodes: int) -> None:
    kept = sum(found.script is not None for found in outcomes)
    dropped = Counter(found.reason for found in outcomes if not found.script)
    words = Counter(each.reason or "sound" for found in outcomes for each in found.sorted)
    if arguments.json:
        say_json(
            {
                "trials": len(outcomes),
                "kept": kept,
                "episodes": episodes,
                "dropped": dict(dropped.most_common()),
                "instructions": dict(words.most_common()),
            }
        )
        return
    say(table(words.most_common(), ("instructions", "")))
    say()
    if dropped:
        say(table(dropped.most_common(), ("trials dropped because", "")))
    say(f"{kept} of {len(outcomes)} trials kept: {episodes} episodes in {arguments.out}.")
