"""`sample`: a balanced choice of episodes, frozen in a manifest."""

from argparse import ArgumentParser, Namespace
from pathlib import Path

from reibench.commands.options import add_episodes, chosen_episodes
from reibench.commands.output import say, tell
from reibench.dataset.sample import manifest
from reibench.dataset.stratify import for_people, stratified
from reibench.errors import ReibenchError


def add(command: ArgumentParser) -> None:
    """Add the command's options."""
    add_episodes(command)
    command.add_argument("--n", type=int, default=1000, help="how many (default: %(default)s)")
    command.add_argument("--seed", type=int, default=1)
    command.add_argument("--once", action="store_true", help="a seed task at most once")
    command.add_argument(
        "--people", type=int, help="lists of --n episodes for so many people, no task twice for one"
    )
    command.add_argument("--out", type=Path, help="the manifest (default: stdout)")
    command.set_defaults(command=sample_command)


def sample_command(arguments: Namespace) -> int:
    """Write the manifest of a sample."""
    if arguments.n < 1 or (arguments.people is not None and arguments.people < 1):
        raise ReibenchError("A sample needs at least one episode, and one person.")
    episodes = chosen_episodes(arguments)
    about: dict[str, object] = {"seed": arguments.seed, "n": arguments.n}
    if arguments.people is None:
        chosen = stratified(episodes, arguments.n, arguments.seed, once=arguments.once)
    else:
        lists = for_people(episodes, arguments.people, arguments.n, arguments.seed)
        about["people"] = [[episode.id for episode in mine] for mine in lists]
        chosen = list({episode.id: episode for mine in lists for episode in mine}.values())
    text = manifest(chosen, **about)
    if arguments.out is None:
        say(text.rstrip())
    else:
        arguments.out.write_text(text, encoding="utf-8")
        tell(f"{arguments.out}: {len(chosen)} episodes")
    return 0
