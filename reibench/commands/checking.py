"""`check-dataset`: are episodes, or the scripts they derive from, sound, and can they be solved?"""

from argparse import ArgumentParser, Namespace
from collections import Counter, defaultdict
from pathlib import Path

from reibench.commands.options import add_episodes, add_json, chosen_episodes
from reibench.commands.output import say, say_json
from reibench.dataset.check import disagreeing_tasks, problems
from reibench.dataset.check_levels import level_problems
from reibench.dataset.script_check import script_problems
from reibench.dataset.script_set import set_problems
from reibench.dataset.scripts import read_scripts
from reibench.episode import Episode, Task
from reibench.rollout import Rollout
from reibench.run import RunSpec, make_world, play

Problems = dict[str, list[str]]


def add(command: ArgumentParser) -> None:
    """Add the command's options."""
    add_episodes(command)
    command.add_argument(
        "--scripts", action="append", default=[], help="check script files (.txt) instead"
    )
    command.add_argument("--single", action="store_true", help="do not compare a task's levels")
    add_json(command)
    command.set_defaults(command=check_command)


def check_command(arguments: Namespace) -> int:
    """Check scripts or episodes, and that the expert solves each; exit 1 if any is unsound."""
    if arguments.scripts:
        return _check_scripts(arguments)
    chosen = chosen_episodes(arguments)
    found: Problems = {each.id: problems(each) for each in chosen}
    for sentence in disagreeing_tasks(chosen):
        found[sentence.split(" ", maxsplit=1)[0]].append(sentence)
    if not arguments.single:
        _compare_levels(chosen, found)
    solved: dict[Task, str] = {}
    for episode in chosen:
        if not found[episode.id] and episode.task not in solved:
            solved[episode.task] = unsolved(episode)
        if reason := solved.get(episode.task, ""):
            found[episode.id].append(reason)
    return _report(arguments, chosen, {name: what for name, what in found.items() if what})


def _compare_levels(chosen: list[Episode], found: Problems) -> None:
    tasks: dict[str, list[Episode]] = defaultdict(list)
    for episode in chosen:
        tasks[episode.task.id].append(episode)
    for episodes in tasks.values():
        for name, sentence in level_problems(episodes):
            found[name].append(sentence)


def _report(arguments: Namespace, chosen: list[Episode], unsound: Problems) -> int:
    if arguments.json:
        say_json(
            {
                "episodes": len(chosen),
                "sound": len(chosen) - len(unsound),
                "tasks": len({episode.task.id for episode in chosen}),
                "levels": Counter(str(episode.vagueness) for episode in chosen),
                "types": Counter(episode.task.goal.task_type.short for episode in chosen),
                "underdetermined": Counter(
                    str(episode.vagueness) for episode in chosen if episode.underdetermined
                ),
                "problems": unsound,
            }
        )
        return 1 if unsound else 0
    for name, sentences in unsound.items():
        for sentence in sentences:
            say(f"{name}: {sentence}.")
    say(f"{len(chosen) - len(unsound)} of {len(chosen)} episodes are sound and solvable.")
    return 1 if unsound else 0


def _check_scripts(arguments: Namespace) -> int:
    scripts = [each for path in arguments.scripts for each in read_scripts(Path(path))]
    lines = [f"{s.id}: {sentence}." for s in scripts for sentence in script_problems(s)]
    lines += [f"together: {sentence}." for sentence in set_problems(scripts)]
    for line in lines:
        say(line)
    say(f"{len(scripts)} scripts read, {len(lines)} problems.")
    return 1 if lines else 0


def unsolved(episode: Episode) -> str:
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
