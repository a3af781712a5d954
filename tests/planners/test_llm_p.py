"""LLM+P: the model writes a goal, Fast Downward plans, and what fails is told or planned anew."""

import pytest

from reibench.backends.scripted import ScriptedBackend
from reibench.dataset.files import shipped_episodes
from reibench.dataset.sample import select
from reibench.episode import Episode, Goal, SceneSetup, Task, TaskType
from reibench.household import load_room, room_names
from reibench.methods import Instruction
from reibench.planners.llm_p import LlmP
from reibench.planners.pddl_goals import Fact, in_pddl
from reibench.planners.pddl_problem import symbol
from reibench.rollout import Rollout, drive
from reibench.scene import Scene
from reibench.skill import Skill, Verb
from reibench.worlds import Event

NOTHING_SAID = Instruction("Please.", "Please.")
TREATMENTS = {TaskType.HEAT: "hot", TaskType.COOL: "cold", TaskType.CLEAN: "clean"}


def in_goal_language(goal: Goal) -> str:
    """Return what a model that understands perfectly writes."""
    thing, place, carrier = map(symbol, (goal.object, goal.destination, goal.movable_receptacle))
    facts = [Fact("sliced", (thing,))] if goal.sliced else []
    match goal.task_type:
        case TaskType.EXAMINE:
            facts.append(Fact("lit", (thing, place)))
        case TaskType.STACK:
            facts += [Fact("in", (thing, carrier)), Fact("in", (carrier, place))]
        case TaskType.PICK:
            facts.append(Fact("in", (thing, place)))
        case treated:
            facts += [Fact(TREATMENTS[treated], (thing,)), Fact("in", (thing, place))]
    return in_pddl(facts)


@pytest.fixture
def play(world):
    """Play an episode with a script for a model; returns rollout and script."""

    def played(episode: Episode, *answers: str) -> tuple[Rollout, ScriptedBackend]:
        backend = ScriptedBackend(answers)
        rollout = Rollout(episode, world)
        rollout.start()
        list(drive(rollout, LlmP(backend), NOTHING_SAID))
        return rollout, backend

    return played


def in_room(room: str, goal: Goal, episode: Episode) -> Episode:
    return Episode(Task("any", SceneSetup(room, seed=3), goal), episode.dialogue, episode.vagueness)


def artefacts(rollout: Rollout, kind: str) -> list[str]:
    made = [one for step in rollout.steps for one in step.decision.artefacts]
    made += rollout.closing.artefacts if rollout.closing else ()
    return [one.text for one in made if one.kind == kind]


TASKS = {episode.task.id: episode for episode in shipped_episodes()}
GOLD = {episode.task.id for episode in select(shipped_episodes(), "gold")}
SOME = [TASKS[name] for name in sorted({*GOLD, *sorted(TASKS)[::10]})]
"""The six gold tasks, and every tenth of all."""


@pytest.mark.parametrize("episode", SOME, ids=lambda episode: episode.task.id)
def test_the_right_goal_solves_a_task_without_one_refused_skill(episode, play):
    rollout, _ = play(episode, in_goal_language(episode.task.goal))
    assert rollout.status == "success"
    assert rollout.said_done
    assert all(step.event.success for step in rollout.steps)


@pytest.mark.parametrize(
    ("room", "goal"),
    [
        ("kitchen-2", Goal(TaskType.HEAT, "Potato", "DiningTable", sliced=True)),
        ("kitchen-2", Goal(TaskType.HEAT, "Egg", "CounterTop")),
        ("kitchen-5", Goal(TaskType.PICK, "Tomato", "Plate", sliced=True)),
        ("kitchen-9", Goal(TaskType.STACK, "Spoon", "CounterTop", "Bowl")),
        ("bathroom-3", Goal(TaskType.CLEAN, "Cloth", "Toilet")),
        ("bedroom-4", Goal(TaskType.EXAMINE, "CD", "DeskLamp")),
    ],
    ids=str,
)
def test_the_right_goal_solves_tasks_with_slices_and_shut_in_things_too(room, goal, episode, play):
    rollout, _ = play(in_room(room, goal, episode), in_goal_language(goal))
    assert rollout.status == "success", [str(step.decision.skill) for step in rollout.steps]


def test_the_first_decision_carries_problem_plan_and_the_plan_in_words(episode, play):
    rollout, _ = play(episode, in_goal_language(episode.task.goal))
    [problem], [plan] = artefacts(rollout, "pddl"), artefacts(rollout, "plan")
    assert "(:goal (and (hot potato) (in potato dining-table)))" in problem
    assert "(heats microwave)" in problem
    assert plan.splitlines()[:2] == ["(find potato)", "(pick-up potato)"]
    assert len(plan.splitlines()) == len(rollout.steps)
    assert artefacts(rollout, "note")[0].startswith("The robot will find a potato, pick up the")


def test_a_goal_that_cannot_be_read_goes_back_twice_with_the_complaint(episode, play):
    good = in_goal_language(episode.task.goal)
    rollout, backend = play(
        episode, "(:goal (and (hot potato)", "(:goal (and (in potatoe sink)))", good
    )
    assert rollout.status == "success"
    first, second, third = (prompt.text for prompt in backend.prompts)
    assert "breaks off: 2 closing parentheses are missing" in second
    assert "Did you mean 'potato'?" in third
    assert third.startswith(first)
    assert len(artefacts(rollout, "prompt")) == 2
    assert artefacts(rollout, "answer")[-1] == good


def test_after_three_goals_that_cannot_be_read_it_says_done_and_why(episode, play):
    rollout, backend = play(
        episode, "I would heat it.", "(:goal", "(:goal (and (hot sink)))", "left"
    )
    assert rollout.said_done
    assert not rollout.steps
    assert len(backend.prompts) == 3
    notes = artefacts(rollout, "note")
    assert len(notes) == 4
    assert "sink is not a thing that can be heated here; such are: apple, bowl, " in notes[2]
    assert rollout.closing.prompt.startswith(backend.prompts[0].text)


def test_a_goal_for_which_no_plan_is_found_goes_back_too(episode, world):
    [room, *_] = (name for name in room_names() if {"DeskLamp", "FloorLamp"} <= types_in(name))
    goal = Goal(TaskType.EXAMINE, "Pillow", "FloorLamp")
    backend = ScriptedBackend(
        ["(:goal (and (lit pillow desk-lamp) (lit pillow floor-lamp)))", in_goal_language(goal)]
    )
    rollout = Rollout(in_room(room, goal, episode), world)
    rollout.start()
    list(drive(rollout, LlmP(backend, seconds=2.0), NOTHING_SAID))
    assert "This is wrong: No" in backend.prompts[1].text


def types_in(room: str) -> set[str]:
    return {thing.type for thing in load_room(room).objects}


@pytest.mark.parametrize(
    ("said", "complaint"),
    [
        ("(:goal (and (heated potato)))", "No predicate called 'heated'"),
        ("(:goal (and (in potato)))", "should read like (in ?thing ?place)"),
        ("(:goal (and))", "1 to 5 conditions, not 0"),
        ("(:goal (and (in bowl bowl)))", "says something of bowl and itself"),
        ("(:goal (or (hot potato) (hot apple)))", "No predicate called 'or'"),
        (
            "(:goal (and (in mug bowl) (in bowl mug)))",
            "bowl does not go in or on mug; it goes to: ",
        ),
        ("(:goal (and (in egg sink) (in egg fridge)))", "cannot both hold; keep the one asked for"),
        ("(:goal (and (holding egg) (holding fork)))", "cannot both hold: the robot has one hand"),
        ("(:goal (in potato cup))", "potato does not go in or on cup; it goes to: "),
        ("(:goal (hot bowl) (hot fork))", "must hold one condition, or (and ...); not 2"),
        ("(:goal (hot fork))", "fork is not a thing that can be heated here; such are: "),
        ("(:goal potato)", "potato is no condition"),
        ("(:goal (lit potato desk-lamp))", "No object called 'desk-lamp'"),
    ],
)
def test_the_complaint_says_what_is_wrong(said, complaint, episode, play):
    _, backend = play(episode, said, in_goal_language(episode.task.goal))
    assert complaint in backend.prompts[1].text


def test_an_answer_that_goes_on_from_what_was_begun_is_understood(episode, play):
    rollout, backend = play(episode, " (hot Potato)\n  (in potato dining-table))) ; done")
    assert rollout.status == "success"
    assert backend.prompts[0].begun == "(:goal (and"


def test_the_room_is_told_after_what_all_questions_share(episodes, play):
    fixed = set()
    for name in ("heat_potato.mixed-noised", "pick_keys.mixed-noised"):
        _, backend = play(episodes[name], in_goal_language(episodes[name].task.goal))
        [prompt] = backend.prompts
        fixed.add(prompt.text[: prompt.fixed])
        assert "Human pending instruction: Please." in prompt.text[prompt.fixed :]
        assert "Things: " in prompt.text[prompt.fixed :]
    assert len(fixed) == 1


class Refusing:
    """The embedded world, but some skills are refused though they are carried out or not."""

    def __init__(self, world, refuses, *, carried_out):
        self._world, self._refuses, self._carried_out = world, refuses, carried_out
        self.skills = world.skills
        self.refused = 0

    def reset(self, task):
        self.event = self._world.reset(task)
        return self.event

    def step(self, skill):
        refused = self._refuses(skill, self.event.scene)
        if self._carried_out or not refused:
            self.event = self._world.step(skill)
        if not refused:
            return self.event
        self.refused += 1
        return Event(False, "there is no room left", self.event.scene, self.event.goals)


def driven(episode: Episode, world: Refusing) -> Rollout:
    rollout = Rollout(episode, world)
    rollout.start()
    planner = LlmP(ScriptedBackend([in_goal_language(episode.task.goal)]))
    list(drive(rollout, planner, NOTHING_SAID))
    return rollout


def test_what_holds_already_is_no_reason_to_plan_anew(episode, world):
    refusing = Refusing(world, lambda skill, scene: skill.verb is Verb.TURN_OFF, carried_out=True)
    rollout = driven(episode, refusing)
    assert rollout.status == "success"
    assert refusing.refused == 1
    assert len(artefacts(rollout, "plan")) == 1


def into_microwave(skill: Skill, scene: Scene) -> bool:
    return skill.verb is Verb.PUT_DOWN and any(one.open for one in scene.of_type("Microwave"))


def test_it_plans_anew_from_what_is_known_when_a_skill_fails_and_then_gives_up(episode, world):
    refusing = Refusing(world, into_microwave, carried_out=False)
    rollout = driven(episode, refusing)
    assert rollout.said_done
    assert refusing.refused == 3
    first, *later = artefacts(rollout, "pddl")
    assert "(hand-empty)" in first
    assert len(later) == 2
    assert all("(holding potato)" in each and "(opened microwave)" in each for each in later)
    assert "put down the potato: there is no room left" in rollout.closing.artefacts[0].text


def test_where_one_place_is_full_it_tries_the_next(episodes, world):
    episode = episodes["pick_keys.mixed-noised"]
    refusing = Refusing(
        world,
        lambda skill, scene: skill.verb is Verb.PUT_DOWN and not refusing.refused,
        carried_out=False,
    )
    rollout = driven(episode, refusing)
    assert rollout.status == "success"
    assert refusing.refused == 1
    texts = [step.decision.skill.text for step in rollout.steps]
    assert texts[5:7] == ["find a drawer", "find a drawer"]
