"""What a study says: people by level and type, beside planners on the very same episodes."""

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from importlib.util import find_spec
from itertools import combinations
from pathlib import Path
from statistics import median
from typing import Any

import pandas as pd

from reibench.dialogue import REFERENCES
from reibench.errors import ReibenchError
from reibench.household.objects import object_types
from reibench.methods import Instruction
from reibench.planners.expert import Expert
from reibench.report.figures import draw_beside_people
from reibench.rollout import Rollout, drive
from reibench.score import bootstrap, sign_test, summarise, wilson
from reibench.tally import records_frame
from reibench.worlds.embedded import embedded_world
from reibench.worlds.rules import rules_called
from study.config import all_episodes
from study.enrolment import Enrolment
from study.exporting import KEPT

PERSON = "person"
INSTALL = "pip install -r requirements-study.txt"


@dataclass(frozen=True)
class Versus:
    """People against one planner's run, trial by trial on the same episodes."""

    run: str
    planner: str
    trials: int
    """People's trials on episodes that the run finished too."""
    episodes: int
    tasks: int
    person: float
    """Success of people on them, from 0 to 1."""
    other: float
    """Success of the planner, each episode as often as people played it."""
    only_person: int
    only_other: int
    p: float
    """Two-sided exact McNemar test over trials; those of one task or person are not independent."""
    difference: float
    """Person less planner, in -1…1."""
    low: float
    high: float
    """95 % percentile interval of it, of a bootstrap over whole seed tasks."""


def trials_frame(enrolment: Enrolment, name: str, *, everybody: bool = False) -> pd.DataFrame:
    """Return one row a finished trial, with the columns of `records_frame` and `participant`.

    Raises:
        ReibenchError: when nobody has finished a trial.
    """
    enrolment.study(name)
    kept = "" if everybody else KEPT
    rows = enrolment.store.query(
        "select a.record as id, participant from assignments as a join participants as p"
        " on participant = p.code where p.study = ? and kind = 'trial' and a.record not null"
        f" {kept}",
        [name],
    )
    records = records_frame(enrolment.store, "study")
    if not rows or records.empty:
        raise ReibenchError(_nobody(name, everybody=everybody))
    frame = records.merge(pd.DataFrame(rows), on="id")
    frame = frame[frame["status"].notna()]
    if frame.empty:
        raise ReibenchError(_nobody(name, everybody=everybody))
    return frame


def _nobody(name: str, *, everybody: bool) -> str:
    hint = "" if everybody else " Simulated people are left out; --everybody counts them in."
    return f"Nobody has finished a trial of the study {name!r}.{hint}"


def analyse(
    enrolment: Enrolment, name: str, runs: Sequence[str] = (), *, everybody: bool = False
) -> dict[str, Any]:
    """Return every number there is; see the README for what each is.

    Args:
        enrolment: the database.
        name: of the study.
        runs: ids of planners' runs to compare with; all of the database if none are named.
        everybody: whether simulated and rejected people count.
    """
    frame = trials_frame(enrolment, name, everybody=everybody)
    planners = records_frame(enrolment.store)
    found: dict[str, Any] = {
        "study": name,
        "people": frame["participant"].nunique(),
        "trials": len(frame),
        "states": _states(enrolment, frame),
        "overall": _summary(frame.assign(all="people"), ["all"]),
        "by_level": _summary(frame, ["level"]),
        "by_task_type": _summary(frame, ["task_type"]),
        "seconds_a_step": _spread(_pace(frame)),
        "steps_per_expert_step": _spread(pd.Series(_to_the_expert(frame, enrolment, name))),
        "agreement": agreement(frame),
        "meant": meant(enrolment, frame),
    }
    compared = _runs(planners, runs)
    found["versus"] = [asdict(versus(frame, planners, run)) for run in compared]
    found["model"] = [mixed_model(frame, planners, run) for run in compared]
    return found


def draw(
    enrolment: Enrolment,
    name: str,
    folder: Path,
    runs: Sequence[str] = (),
    *,
    everybody: bool = False,
) -> list[Path]:
    """Draw success by level of people beside planners' runs; return the files."""
    people = trials_frame(enrolment, name, everybody=everybody)
    planners = records_frame(enrolment.store)
    wanted = _runs(planners, runs)
    chosen = planners[planners["run"].isin(wanted)] if len(planners) else planners
    try:
        return list(draw_beside_people(people, chosen, folder))
    except OSError as problem:
        raise ReibenchError(f"No figure can be drawn in {folder}: {problem.strerror}.") from None


def _runs(planners: pd.DataFrame, wanted: Sequence[str]) -> list[str]:
    known = list(dict.fromkeys(planners["run"])) if len(planners) else []
    if missing := [run for run in wanted if run not in known]:
        raise ReibenchError(
            f"There is no run {missing[0]!r} in this database; it has {', '.join(known) or 'none'}."
        )
    return list(wanted) or known


def _summary(frame: pd.DataFrame, by: Sequence[str]) -> list[dict[str, Any]]:
    return [
        {str(name): value for name, value in row.items()}
        for row in summarise(frame, by).to_dict("records")
    ]


def versus(frame: pd.DataFrame, planners: pd.DataFrame, run: str) -> Versus:
    """Compare people's trials with a run's outcomes on the same episodes, by content."""
    other = planners[(planners["run"] == run) & planners["status"].notna()]
    solved = (other.set_index("episode_digest")["status"] == "success").rename("other")
    both = frame.merge(solved, left_on="episode_digest", right_index=True)
    mine, theirs = both["status"] == "success", both["other"].astype(bool)
    only_person, only_other = int((mine & ~theirs).sum()), int((~mine & theirs).sum())
    gains = mine.astype(int) - theirs.astype(int)
    low, high = bootstrap(gains, both["task"]) if len(both) else (float("nan"), float("nan"))
    return Versus(
        run=run,
        planner=str(other["actor"].iloc[0]) if len(other) else run,
        trials=len(both),
        episodes=both["episode_digest"].nunique(),
        tasks=both["task"].nunique(),
        person=float(mine.mean()) if len(both) else float("nan"),
        other=float(theirs.mean()) if len(both) else float("nan"),
        only_person=only_person,
        only_other=only_other,
        p=sign_test(only_person, only_other),
        difference=float(gains.mean()) if len(both) else float("nan"),
        low=low,
        high=high,
    )


def mixed_model(frame: pd.DataFrame, planners: pd.DataFrame, run: str) -> dict[str, Any]:
    """Fit success by who acts, with intercepts that vary by person and by seed task.

    A Bayesian mixed-effects logistic regression by statsmodels, variational fit. Returns the log
    odds of a person against the planner with its standard deviation, or why there is none.
    """
    if find_spec("statsmodels") is None:
        return {"run": run, "note": f"needs statsmodels: {INSTALL}"}
    other = planners[(planners["run"] == run) & planners["status"].notna()]
    shared = set(frame["episode_digest"]) & set(other["episode_digest"])
    people = frame[frame["episode_digest"].isin(shared)]
    other = other[other["episode_digest"].isin(shared)].assign(participant=run)
    columns = ["participant", "task", "status"]
    rows = pd.concat([people[columns].assign(person=1), other[columns].assign(person=0)])
    rows = rows.assign(solved=(rows["status"] == "success").astype(int))
    if rows["task"].nunique() < 2 or rows["solved"].nunique() < 2:
        return {"run": run, "note": "too few tasks, or nothing but successes or failures"}
    from statsmodels.genmod.bayes_mixed_glm import BinomialBayesMixedGLM  # heavy

    varying = {"people": "0 + C(participant)", "tasks": "0 + C(task)"}
    fit = BinomialBayesMixedGLM.from_formula("solved ~ person", varying, rows).fit_vb()
    effect, spread = float(fit.fe_mean[1]), float(fit.fe_sd[1])
    return {
        "run": run,
        "trials": len(rows),
        "person_log_odds": effect,
        "standard_deviation": spread,
        "low": effect - 1.96 * spread,
        "high": effect + 1.96 * spread,
    }


def _states(enrolment: Enrolment, frame: pd.DataFrame) -> dict[str, int]:
    """Count the people whose trials are in `frame`: by state, and who missed an attention check."""
    counted = set(frame["participant"])
    rows = enrolment.store.query(
        "select code, state, exists (select 1 from answers where participant = code and right = 0"
        " and stage != 'quiz') as missed from participants"
    )
    here = [row for row in rows if row["code"] in counted]
    found = dict(Counter(row["state"] for row in here))
    return found | {"missed a check": sum(row["missed"] for row in here)}


def agreement(frame: pd.DataFrame) -> dict[str, Any]:
    """Say how often two people who played the same episode came out the same."""
    pairs = same = 0
    for _, found in frame.groupby("episode_digest"):
        solved = (found["status"] == "success").tolist()
        pairs += len(list(combinations(solved, 2)))
        same += sum(one == other for one, other in combinations(solved, 2))
    return {"pairs": pairs, "same": same, "share": same / pairs if pairs else None}


def meant(enrolment: Enrolment, frame: pd.DataFrame) -> list[dict[str, Any]]:
    """Say how often people named the object that was meant, where a question asks for it.

    Returns one row for each level of reference with `right` of `asked` and a 95 % Wilson interval.
    """
    rows = enrolment.store.query(
        "select a.record as id, answer, question from answers as w join assignments as a"
        " on a.participant = w.participant and a.place = w.place and a.kind = 'trial'"
        " where w.stage = 'after' and a.record not null"
    )
    said = pd.DataFrame(rows, columns=["id", "answer", "question"])
    said = said[said["answer"].isin(object_types())].drop_duplicates(["id", "question"])
    both = frame.merge(said, on="id")
    objects = {episode.task.id: episode.task.goal.object for episode in all_episodes()}
    found = []
    for reference in REFERENCES:
        here = both[both["level"].str.startswith(f"{reference}-")]
        right = int((here["task"].map(objects) == here["answer"]).sum())
        if len(here):
            low, high = wilson(right, len(here))
            found.append(
                {"reference": reference, "right": right, "asked": len(here), "low": low,
                 "high": high}
            )  # fmt: skip
    return found


def _to_the_expert(frame: pd.DataFrame, enrolment: Enrolment, name: str) -> list[float]:
    """Return how many times the expert's steps each solved trial took."""
    rules = rules_called(enrolment.study(name).rules)
    world = embedded_world(rules)
    shipped = {episode.id: episode for episode in all_episodes()}
    solved = frame[frame["status"] == "success"]
    needed: dict[str, int] = {}
    for task, episode in dict(zip(solved["task"], solved["episode"], strict=True)).items():
        rollout = Rollout(shipped[episode], world)
        rollout.start()
        expert = Expert(shipped[episode].task.goal)
        needed[task] = len(list(drive(rollout, expert, Instruction("", ""))))
    return [
        steps / needed[task]
        for task, steps in zip(solved["task"], solved["steps"], strict=True)
        if needed[task]
    ]


def _pace(frame: pd.DataFrame) -> "pd.Series[float]":
    acted = frame[frame["steps"] > 0]  # saying done has no time of its own for people
    return acted["seconds"] / acted["steps"]


def _spread(values: "pd.Series[float]") -> Mapping[str, float | int | None]:
    kept = [float(value) for value in values]
    if not kept:
        return {"number": 0, "median": None, "low": None, "high": None}
    low, high = pd.Series(kept).quantile([0.25, 0.75])
    return {"number": len(kept), "median": median(kept), "low": float(low), "high": float(high)}
