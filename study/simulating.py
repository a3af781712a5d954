"""Simulated participants: they go through the real page's handlers, err, reload and come back.

What they leave behind is marked, and exports leave it out unless asked.
"""

import sys
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from math import log
from random import Random
from time import perf_counter, sleep, time
from types import SimpleNamespace
from typing import Any, Protocol

from reibench.episode import Episode
from reibench.errors import ReibenchError
from reibench.methods import Instruction
from reibench.planners.expert import Expert
from reibench.rollout import Rollout, drive
from reibench.skill import SKILLS
from reibench.worlds.embedded import embedded_world
from reibench.worlds.rules import rules_called
from study.config import Question, all_episodes
from study.enrolment import Enrolment
from study.pages import TakingPart
from study.places import pool_of
from study.stages import Page

Tell = Callable[[str], object]
PATIENT = 20
"""How often somebody tries in vain to get on before the simulation says so."""


@dataclass(frozen=True)
class Character:
    """How simulated people behave; each a share of occasions, from 0 to 1."""

    skill: float = 0.8
    """How often a trial is done as it should be."""
    hesitation: float = 0.15
    """How often something needless is tried before a step."""
    reload: float = 0.05
    """How often the page is loaded anew after a step."""
    leave: float = 0.0
    """How often somebody leaves the study, at the start of a trial."""
    quiz: float = 0.9
    """How often a quiz question is answered rightly at the first try."""
    pause: float = 0.0
    """Seconds on average from one answer of the page to the next click; each is drawn anew."""


@dataclass
class Outcome:
    """What became of one of them."""

    code: str
    state: str
    seconds: list[float] = field(default_factory=list)
    """How long each step took to be answered."""


class Simulation:
    """People who take part in one study of a database."""

    def __init__(self, enrolment: Enrolment, name: str, character: Character, seed: int) -> None:
        self._enrolment = enrolment
        self._study = enrolment.study(name)
        self._character = character
        self._seed = seed
        self._page = TakingPart(enrolment, simulated=True)
        self._flow = self._page.flow
        self._episodes = {episode.id: episode for episode in all_episodes()}
        self._solutions: dict[str, list[str]] = {}

    def prepare(self) -> None:
        """Solve every task of the study ahead, as those who know it will."""
        for episode in pool_of(self._study):
            self._solution(episode)

    def in_a_browser(self, number: int, *, tell: Tell) -> list[Outcome]:
        """Let so many people take part in a real Chromium, one after another.

        Raises:
            ReibenchError: when Playwright or Chromium is not there.
        """
        from study.browsing import Browsing

        outcomes = []
        with Browsing(self._enrolment, self._study.name) as browsing:
            for place in range(number):
                choose = Random(f"{self._seed}/{place}")
                visitor = browsing.visitor()
                outcome = self._through(visitor, choose)
                outcomes.append(outcome)
                tell(f"[{len(outcomes)}/{number}] {outcome.code}: {outcome.state}")
        return outcomes

    def run(self, number: int, *, together: int, tell: Tell) -> list[Outcome]:
        """Let so many people take part, some at a time, and return what became of each."""
        with ThreadPoolExecutor(together) as pool:
            outcomes = []
            for outcome in pool.map(self._person, range(number)):
                outcomes.append(outcome)
                tell(f"[{len(outcomes)}/{number}] {outcome.code}: {outcome.state}")
        return outcomes

    def _person(self, number: int) -> Outcome:
        choose = Random(f"{self._seed}/{number}")
        return self._through(_Visitor(self._page, self._study.name), choose)

    def _through(self, visitor: "Visitor", choose: Random) -> Outcome:
        """Lead a visitor through the whole study."""
        visitor.load()
        outcome = Outcome("", "")
        before, refused = None, 0
        while (page := self._flow.page(visitor.token)).stage != "over":
            here = (page.stage, page.place, page.participant.quiz_tries)
            before, refused = here, refused + 1 if here == before else 0
            if refused > PATIENT:
                raise ReibenchError(
                    f"{page.participant.code} cannot get on: whatever they do at the stage"
                    f" {page.stage} is refused."
                )
            outcome.code = page.participant.code
            if page.sitting is None:
                self._think(choose)  # and read
            if page.stage == "trial" and choose.random() < self._character.leave:
                visitor.send("withdraw", page)
            else:
                self._act(visitor, page, choose, outcome)
        outcome.state = self._flow.page(visitor.token).participant.state
        return outcome

    def _act(self, visitor: "Visitor", page: Page, choose: Random, outcome: Outcome) -> None:
        match page.stage:
            case "consent":
                visitor.send("consent", page, agreed=True)
            case "tutorial" | "outcome":
                visitor.send("read", page)
            case "practice" | "trial":
                self._play(visitor, page, choose, outcome)
            case _:
                answers = {one.name: self._answer(one, page, choose) for one in page.questions}
                visitor.send("answer", page, answers=answers)

    def _play(self, visitor: "Visitor", page: Page, choose: Random, outcome: Outcome) -> None:
        """Play a task to its end: as the expert does, or short of it."""
        assert page.sitting is not None
        skills = list(self._solution(page.sitting.episode))
        if page.stage == "trial" and choose.random() >= self._character.skill:
            skills = skills[: choose.randrange(len(skills))]
        done = [str(step.decision.skill) for step in page.sitting.steps]
        for skill in skills[len(done) :]:
            tried = [skill]
            room = page.sitting.max_steps - len(done) - len(skills) > 4
            if room and choose.random() < self._character.hesitation:
                tried.insert(0, str(choose.choice(_HARMLESS)))
            for text in tried:
                seconds = self._think(choose)
                started = perf_counter()
                visitor.send("step", page, skill=text, expected=len(done) + 1, seconds=seconds)
                outcome.seconds.append(perf_counter() - started)
                done.append(text)
            if choose.random() < self._character.reload:
                visitor.load()
        visitor.send("done", page, expected=len(done) + 1)

    def _think(self, choose: Random) -> float:
        """Pause as long as somebody thinks, and return how long they say it was."""
        if not self._character.pause:
            return 2.5
        # quick clicks and long looks: the shape of response times
        seconds = min(choose.lognormvariate(log(self._character.pause) - 0.125, 0.5), 60.0)
        sleep(seconds)
        return seconds

    def _solution(self, episode: Episode) -> Sequence[str]:
        if episode.id not in self._solutions:
            world = embedded_world(rules_called(self._study.rules))
            rollout = Rollout(episode, world, max_steps=self._study.max_steps)
            rollout.start()
            told = Instruction("", "")
            steps = list(drive(rollout, Expert(episode.task.goal), told))
            self._solutions[episode.id] = [str(step.decision.skill) for step in steps]
        return self._solutions[episode.id]

    def _answer(self, question: Question, page: Page, choose: Random) -> str:
        if question.right:
            wrong = [option for option in question.options if option != question.right]
            first = page.participant.quiz_tries == 0
            sure = choose.random() < self._character.quiz or not first or not wrong
            return question.right if sure else choose.choice(wrong)
        if question.kind == "scale":
            return str(choose.randint(1, question.points))
        if question.kind == "object":
            given = self._enrolment.assignments(page.participant.code)[page.place]
            return self._episodes[given.episode].task.goal.object
        return choose.choice(question.options) if question.options else "A remark."


_HARMLESS = [skill for skill in SKILLS if str(skill).startswith("slice")]
"""What changes nothing without a knife in hand, and leads nowhere."""


class Visitor(Protocol):
    """Somebody at the page."""

    @property
    def token(self) -> str:
        """What the server knows them by."""
        ...

    def load(self) -> None:
        """Load the page."""
        ...

    def send(self, name: str, page: Page, **data: Any) -> None:
        """Do on the page what sends this event."""
        ...


class _Visitor:
    """A browser: what it remembers, and the events it sends."""

    def __init__(self, page: TakingPart, study: str) -> None:
        self._page = page
        self._study = study
        self._known: dict[str, str] = {}

    @property
    def token(self) -> str:
        """What the server knows it by."""
        return self._known[self._study]

    def load(self) -> None:
        """Load the page."""
        request: Any = SimpleNamespace(query_params={"study": self._study})
        known = self._page.arrive(self._known, request)[0]
        if isinstance(known, dict) and self._study in known:
            self._known = known

    def send(self, name: str, page: Page, **data: Any) -> None:
        """Send an event as the page would."""
        now = 1000 * time()
        carried = {
            "seq": 1, "study": self._study, "stage": page.stage, "place": page.place,
            "attempt": page.participant.quiz_tries,
            "shown": now - 2500, "left": now, "hidden": 0, **data,
        }  # fmt: skip
        event: Any = SimpleNamespace(_data=carried)
        getattr(self._page, name)(self._known, event)


def bench(
    enrolment: Enrolment, name: str, participants: int, pause: float, tell: Tell
) -> dict[str, Any]:
    """Let participants take part all at once, and return how fast the page answers their steps.

    `pause` is how many seconds they think before each click, on average.
    """
    character = Character(leave=0.02, pause=pause)
    # solving the tasks beforehand is not what is measured
    simulation = Simulation(enrolment, name, character, 1)
    simulation.prepare()
    outcomes = simulation.run(participants, together=participants, tell=tell)
    seconds = sorted(second for outcome in outcomes for second in outcome.seconds)
    return {
        "participants": participants,
        "pause_s": pause,
        "finished": sum(outcome.state == "finished" for outcome in outcomes),
        "accounted_for": sum(outcome.state != "active" for outcome in outcomes),
        "steps": len(seconds),
        "step_p50_ms": round(1000 * _quantile(seconds, 0.5), 1),
        "step_p99_ms": round(1000 * _quantile(seconds, 0.99), 1),
        "memory_mb": _peak_megabytes(),
    }


def _peak_megabytes() -> int | None:
    """Return the most memory this process has had; None where the system does not tell."""
    try:
        import resource  # Windows has none
    except ImportError:
        return None
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return round(peak / (1 << 20 if sys.platform == "darwin" else 1 << 10))


def _quantile(ordered: Sequence[float], part: float) -> float:
    return ordered[min(len(ordered) - 1, int(part * len(ordered)))]
