"""`check-dataset`: are the episodes sound, and can they be solved?"""

from argparse import ArgumentParser, Namespace

from reibench.commands.options import add_episodes, chosen_episodes
from reibench.commands.output import say
from reibench.dataset.check import disagreeing_tasks, problems
from reibench.episode import Episode
from reibench.rollout import Rollout
from reibench.run import RunSpec, make_world, play


def add(command: ArgumentParser) -> None:
    """Add the command's options."""
    add_episodes(command)
    command.set_defaults(command=check_command)


def check_command(arguments: Namespace) -> int:
    """Check episodes, and that the expert solves each; exit 1 if any is unsound."""
    chosen = chosen_episodes(arguments)
    found = {each.id: problems(each) for each in chosen}
    for sentence in disagreeing_tasks(chosen):
        found.setdefault(sentence.split(" ", maxsplit=1)[0], []).append(sentence)
    solved: dict[object, str] = {}
    for episode in chosen:
        if not found[episode.id] and episode.task not in solved:
            solved[episode.task] = _unsolved(episode)
        if reason := solved.get(episode.task, ""):
            found[episode.id].append(reason)
    unsound = {name: sentences for name, sentences in found.items() if sentences}
    for name, sentences in unsound.items():
        for sentence in sentences:
            say(f"{name}: {sentence}.")
    say(f"{len(chosen) - len(unsound)} of {len(chosen)} episodes are sound and solvable.")
    return 1 if unsound else 0


def _unsolved(episode: Episode) -> str:
    """Return a sentence if the expert cannot solve the episode."""
    spec = RunSpec(planner="expert")
    world = make_world(spec)
    rollout = Rollout(episode, world)
    rollout.start()
    failed = [step for step in play(spec, rollout, None) if not step.event.success]
    world.close()
    if rollout.status == "success":
        return ""
    why = f": {failed[-1].decision.skill}: {failed[-1].event.message}" if failed else ""
    return f"the expert does not solve it{why}"
