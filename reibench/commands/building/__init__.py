"""`build-dataset`: the shipped episodes from their scripts, and what else makes episodes."""

from argparse import ArgumentParser, Namespace
from pathlib import Path

from reibench.commands.building import alfred, modelled, realised
from reibench.commands.output import tell
from reibench.dataset.files import SHIPPED, write_episodes
from reibench.dataset.levels import derive
from reibench.dataset.scripts import SCRIPTS, read_scripts
from reibench.errors import ReibenchError

EPISODES = Path("data") / "rei.jsonl.gz"
"""Beside the shipped episodes it would be read with them, and six tasks are in both."""


def add(command: ArgumentParser) -> None:
    """Add the command's options."""
    command.add_argument(
        "--scripts", action="append", default=[], help="script files (default: the shipped ones)"
    )
    command.add_argument("--out", type=Path, help=f"of written scripts by default {EPISODES}")
    command.add_argument("--seed", type=int, default=1, help="decides whatever is left to chance")
    realised.add(command)
    modelled.add(command)
    alfred.add(command)
    command.set_defaults(command=build_command)


def build_command(arguments: Namespace) -> int:
    """Write episodes: of written scripts, unless something else is to make them."""
    if arguments.realise is not None:
        _keep_apart(arguments.out)
        return realised.build(arguments)
    if arguments.alfred is not None:
        _keep_apart(arguments.out)
        return alfred.build_from_alfred(arguments)
    if arguments.model is not None:
        _keep_apart(arguments.out)
        return modelled.build_modelled(arguments)
    paths = [Path(path) for path in arguments.scripts] or sorted(SCRIPTS.glob("*.txt"))
    scripts = [script for path in paths for script in read_scripts(path)]
    episodes = [episode for script in scripts for episode in derive(script)]
    out = arguments.out or EPISODES
    out.parent.mkdir(parents=True, exist_ok=True)
    write_episodes(out, episodes)
    tell(f"{out}: {len(episodes)} episodes from {len(scripts)} scripts")
    return 0


def _keep_apart(out: Path | None) -> None:
    """Refuse to put what nobody wrote among the shipped episodes."""
    if out is None or out.resolve().parent == SHIPPED.resolve():
        raise ReibenchError(
            f"{SHIPPED.name} holds the written episodes, and no others belong there; name another"
            " file with --out."
        )
