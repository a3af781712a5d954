"""LLM+P (Liu et al. 2023; appendix A.1): the model writes a PDDL goal, a classical planner plans.

The model turns the instruction into a goal over the objects of the room; Fast Downward finds the
plan, whose actions are skills; a rule says the plan in words again. A goal that cannot be read or
reached goes back to the model with the complaint. As LLM+P presupposes a symbolic problem, the
planner is told what is in the room and what is shut in: knowledge that SayCan does not have.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import ClassVar

from reibench.artefact import Artefact
from reibench.backends import Backend, Prompt, Usage
from reibench.errors import InvalidGoal
from reibench.methods import Instruction
from reibench.planners import Closing, Decision, Plan, planners
from reibench.planners.goal_examples import goal_examples
from reibench.planners.pddl import SECONDS, Action, solve
from reibench.planners.pddl_goals import Fact, Role, Vocabulary, grammar, in_pddl, read_goal
from reibench.planners.pddl_problem import brought_about, problem, skill_of, vocabulary
from reibench.planners.telling import PENDING, told
from reibench.scene import Scene
from reibench.skill import Skill, Verb
from reibench.worlds import Event

HEADER = """\
What a human asks of a household robot is written as a goal in PDDL: the conditions that hold when \
it is done, and no others. The conditions are:
(in THING PLACE): the thing is in or on the place
(hot THING): it has been heated
(cold THING): it has been cooled
(clean THING): it has been washed
(sliced THING): it has been cut
(lit THING LAMP): the robot holds it in the light of the lamp
(holding THING): the robot holds it
"""
BEGUN = "(:goal (and"
RETRIES = 2
"""How often a complaint goes back to the model."""
REPLANS = 2
"""How often it is planned anew after a skill failed."""
LONGEST = 120
"""Tokens of a goal."""


@dataclass(frozen=True)
class Translation:
    """What came of asking the model for a goal."""

    prompt: str
    usage: Usage
    artefacts: tuple[Artefact, ...]
    goal: tuple[Fact, ...] = ()
    actions: tuple[Action, ...] = ()


@planners.register("llm-p")
class LlmP:
    """Let the model write the goal and Fast Downward the plan."""

    title = "LLM+P"
    summary = "a goal in PDDL, which a classical planner turns into steps"

    reads_scene: ClassVar[bool] = True
    """Whether it is told what is in the room beside what the human says."""

    def __init__(self, backend: Backend, *, seconds: float = SECONDS) -> None:
        """Ask `backend` for goals, and give Fast Downward so many `seconds` a plan."""
        self._backend = backend
        self._seconds = seconds

    def plan(self, instruction: Instruction, start: Event, skills: tuple[Skill, ...]) -> Plan:
        """Yield the plan's skills; plans again from what is known when one fails."""
        asked = self._translate(instruction, start.scene)
        prompt, usage, artefacts = asked.prompt, asked.usage, asked.artefacts
        actions, done, failed = asked.actions, list[Skill](), list[Skill]()
        event = start
        while actions:
            for skill in map(skill_of, actions):
                event = yield Decision(skill, prompt, usage, artefacts=artefacts)
                prompt, usage, artefacts = "", Usage(), ()
                if event.success:
                    done.append(skill)
                elif not _is_so(skill, event.scene):
                    failed.append(skill)
                    artefacts = (_failure(skill, event),)
                    break
            else:
                return None
            if len(failed) > REPLANS:
                break
            if skill.verb is Verb.PUT_DOWN:
                # What is full or too small stays so: each find in a row leads to the next place.
                for _ in failed:
                    place = next(one for one in reversed(done) if one.verb is Verb.FIND)
                    event = yield Decision(place, artefacts=artefacts)
                    artefacts = ()
            actions, made = self._replan(event.scene, done, asked.goal)
            artefacts += made
        return Closing(prompt, usage, artefacts=artefacts)

    def _translate(self, instruction: Instruction, scene: Scene) -> Translation:
        """Ask for a goal until one can be read and reached, or the retries are spent."""
        words = vocabulary(scene)
        prefix = introduction()
        text = f"{prefix}{inventory(words)}{told(instruction)}"
        usage, artefacts, first = Usage(), list[Artefact](), ""
        for attempt in range(RETRIES + 1):
            prompt = Prompt(text, fixed=len(prefix), begun=BEGUN)
            answer = self._backend.generate(
                prompt, max_tokens=LONGEST, stop=("\n\n", "Human"), grammar=grammar(words)
            )
            usage += answer.usage
            sent = answer.prompt or prompt.text + prompt.begun
            first = first or sent
            if attempt:
                artefacts.append(Artefact("prompt", f"Question {attempt + 1}", sent))
            artefacts.append(Artefact("answer", f"Answer {attempt + 1}", answer.text))
            said = answer.text if "(:goal" in answer.text else BEGUN + answer.text
            try:
                goal = read_goal(said, words)
                stated = problem(scene, (), goal)
                artefacts.append(Artefact("pddl", "The problem", stated))
                actions = solve(stated, seconds=self._seconds)
            except InvalidGoal as complaint:
                artefacts.append(Artefact("note", "What is wrong with it", str(complaint)))
                text += f"{said.strip()}\nThis is wrong: {complaint} The right goal:\n"
                continue
            artefacts += described(actions)
            return Translation(first, usage, tuple(artefacts), goal, actions)
        artefacts.append(Artefact("note", "Given up", "No goal could be planned for."))
        return Translation(first, usage, tuple(artefacts))

    def _replan(
        self, scene: Scene, done: list[Skill], goal: tuple[Fact, ...]
    ) -> tuple[tuple[Action, ...], tuple[Artefact, ...]]:
        """Plan from what the room is like now and what the skills that worked brought about."""
        stated = problem(scene, brought_about(done), goal)
        asked = Artefact("pddl", "The problem now", stated)
        try:
            actions = solve(stated, seconds=self._seconds)
        except InvalidGoal as complaint:
            return (), (asked, Artefact("note", "Given up", str(complaint)))
        return actions, (asked, *described(actions))


def introduction() -> str:
    """Return what every question begins with."""
    solved = (f"{PENDING}{asked}\n{in_pddl(goal)}\n" for asked, goal in goal_examples())
    return "\n".join((HEADER, *solved, ""))


def inventory(words: Vocabulary) -> str:
    """Return the objects of the room as the model is told them."""
    kinds: tuple[tuple[str, Role], ...] = (("Things", "thing"), ("Places", "place"))
    kinds += (("Lamps", "lamp"),) if words.objects["lamp"] else ()
    return "".join(f"{title}: {', '.join(words.objects[role])}\n" for title, role in kinds)


def described(actions: Iterable[Action]) -> list[Artefact]:
    """Return a plan as the classical planner made it, and in words."""
    actions = tuple(actions)
    skills = ", ".join(str(skill_of(action)) for action in actions)
    words = f"The robot will {skills}." if actions else "There is nothing to do."
    return [
        Artefact("plan", "The plan", "\n".join(map(str, actions))),
        Artefact("note", "The plan in words", words),
    ]


def _failure(skill: Skill, event: Event) -> Artefact:
    return Artefact("note", "A skill failed", f"{skill}: {event.message}")


def _is_so(skill: Skill, scene: Scene) -> bool:
    """Whether what a refused skill is for is the case already, as far as the robot sees."""
    seen = [one for one in scene.of_type(skill.object) if one.id in scene.visible]
    match skill.verb:
        case Verb.OPEN | Verb.CLOSE:
            return bool(seen) and all(one.open is (skill.verb is Verb.OPEN) for one in seen)
        case Verb.TURN_ON | Verb.TURN_OFF:
            return bool(seen) and all(one.on is (skill.verb is Verb.TURN_ON) for one in seen)
        case _:
            return False
