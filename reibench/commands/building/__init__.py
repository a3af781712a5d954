"""`build-dataset`: the shipped episodes from their scripts, and what else makes episodes."""

from argparse import ArgumentParser, Namespace
from pathlib import Path

from reibench.commands.building import alfred, modelled, realised
from reibench.commands.output import tell
from reibench.dataset.card import with_figures
from reibench.dataset.files import SHIPPED, write_episodes
from reibench.dataset.levels import derive
from reibench.dataset.scripts import read_scripts, shipped_scripts
from reibench.errors import ReibenchError

EPISODES = SHIPPED / "rei.jsonl.gz"
"""What the shipped scripts make."""
CARD = SHIPPED / "README.md"


def add(command: ArgumentParser) -> None:
    """Add the command's options."""
    command.add_argument(
        "--scripts", action="append", default=[], help="script files (default: the shipped ones)"
    )
    command.add_argument(
        "--out", type=Path, help="of the shipped scripts by default the shipped file"
    )
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
    scripts = shipped_scripts()
    if arguments.scripts:
        _keep_apart(arguments.out)
        scripts = [script for path in arguments.scripts for script in read_scripts(Path(path))]
    episodes = [episode for script in scripts for episode in derive(script)]
    out = arguments.out or EPISODES
    out.parent.mkdir(parents=True, exist_ok=True)
    write_episodes(out, episodes)
    if out == EPISODES:
        CARD.write_text(with_figures(CARD.read_text(encoding="utf-8"), episodes), encoding="utf-8")
    tell(f"{out}: {len(episodes)} episodes from {len(scripts)} scripts")
    return 0


def _keep_apart(out: Path | None) -> None:
    """Refuse to put what does not derive from the shipped scripts among the shipped episodes."""
    if out is None or out.resolve().parent == SHIPPED.resolve():
        raise ReibenchError(
            f"{SHIPPED.name} holds the written episodes, and no others belong there; name another"
            " file with --out."
        )
