"""ALFRED trials as episodes: each annotator's words are one explicit instruction."""

from collections.abc import Iterator

from reibench.dataset.alfred.trial import Trial
from reibench.dialogue import EXPLICIT_ALONE, Dialogue, Utterance
from reibench.episode import Episode, Task


def task_of(trial: Trial, number: int) -> Task:
    """Return the task as the annotator of that number words it; two-object trials have none."""
    if trial.goal is None:
        raise ValueError(f"{trial.id} is about two objects, which no goal of ours is")
    return Task(f"{trial.id}-r{number}", trial.setup, trial.goal)


def episodes_of(trial: Trial) -> Iterator[Episode]:
    """Yield an episode for each annotator; none for a trial about two objects.

    Where an annotator wrote nothing there is none either, but the numbers stay.
    """
    for number, ask in enumerate(trial.asks if trial.goal else ()):
        if ask.text:
            said = Dialogue((Utterance("human", ask.text),))
            yield Episode(task_of(trial, number), said, EXPLICIT_ALONE)
