"""`build-dataset --model`: scripts from seeds with a language model, in the paper's three steps."""

from argparse import ArgumentParser, Namespace
from collections.abc import Iterable
from pathlib import Path

from reibench.backends.opening import open_backend
from reibench.commands.building.realised import solvable
from reibench.commands.output import say, say_json, table, tell
from reibench.dataset.build.asking import Asker, Price
from reibench.dataset.build.pipeline import Report, build
from reibench.dataset.build.seeding import SeedInstruction, in_a_sentence, read_seeds
from reibench.dataset.files import stream_episodes
from reibench.dataset.levels import derive
from reibench.dataset.scripts import SCRIPTS, Script, format_scripts, read_scripts
from reibench.dataset.seeds import choose_seeds
from reibench.errors import ReibenchError
from reibench.household import load_room, room_names

ANSWERS = Path("data/answers")


def add(command: ArgumentParser) -> None:
    """Add the options of the three steps."""
    group = command.add_argument_group("the three steps with a language model (appendix B)")
    group.add_argument("--model", metavar="KIND:NAME", help="e.g. llama-cpp:gemma-3-270m")
    group.add_argument("--seeds", metavar="N|FILE", help="so many seed tasks, or those of a file")
    group.add_argument("--retries", type=int, default=2, help="complaints about an unfit answer")
    group.add_argument("--max-tokens", type=int, default=900, help="of an answer")
    group.add_argument(
        "--answers", type=Path, default=ANSWERS, help="where answers are kept: %(default)s"
    )
    group.add_argument(
        "--price", type=float, nargs=2, metavar=("IN", "OUT"), help="of a million tokens"
    )
    group.add_argument("--json", action="store_true", help="print the report as JSON")


def build_modelled(arguments: Namespace) -> int:
    """Write what the model's answers make, and report what was dropped and why."""
    if arguments.seeds is None:
        raise ReibenchError("--model needs --seeds: how many seed tasks, or a file of them.")
    seeds = list(wanted_seeds(arguments.seeds, arguments.seed))
    backend = open_backend(arguments.model)
    asker = Asker(
        backend, arguments.answers, retries=arguments.retries, max_tokens=arguments.max_tokens
    )
    examples = read_scripts(SCRIPTS / "gold.txt")
    report = Report()
    scripts: list[Script] = []
    try:
        for outcome in build(seeds, asker, examples):
            report.note(outcome)
            name = outcome.seed.task.id
            if outcome.script:
                scripts.append(outcome.script)
                tell(f"[{report.seeds}/{len(seeds)}] {name}: kept")
            else:
                tell(f"[{report.seeds}/{len(seeds)}] {name}: {outcome.step}: {outcome.detail}")
    finally:
        backend.close()
    write_scripts(arguments.out, scripts)
    price = Price(*arguments.price) if arguments.price else Price()
    found = report.as_json(asker.usage, asker.asked, asker.from_cache, price)
    if arguments.json:
        say_json(found)
    else:
        _print(report, found)
    return 0


def wanted_seeds(text: str, seed: int) -> Iterable[SeedInstruction]:
    """Return the seeds of a file, or so many chosen ones.

    Raises:
        ReibenchError: for a number below 1, or a file that cannot be read.
    """
    if not text.isdecimal():
        return read_seeds(Path(text))
    if int(text) < 1:
        raise ReibenchError(f"--seeds {text} leaves nothing to do; ask for at least 1.")
    rooms = [load_room(name) for name in room_names()]
    return map(in_a_sentence, choose_seeds(rooms, int(text), seed, solvable))


def write_scripts(out: Path, scripts: list[Script]) -> None:
    """Write scripts, as such to a `.txt` file, as their nine episodes each to any other."""
    if out.suffix == ".txt":
        out.write_text(format_scripts(scripts), encoding="utf-8")
        return
    stream_episodes(out, (episode for script in scripts for episode in derive(script)))


def _print(report: Report, found: dict[str, object]) -> None:
    if rows := report.rows():
        say(table(rows, ("dropped at", "because", "seeds")))
    say(f"{report.kept} of {report.seeds} seeds kept.")
    say(
        f"{found['asked']} questions asked ({found['from_cache']} answers were there already),"
        f" {found['prompt_tokens']} + {found['completion_tokens']} tokens, {found['seconds']} s,"
        f" cost {found['cost']}."
    )
