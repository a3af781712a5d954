"""Episodes: a household task in a room, asked for in one way."""

from dataclasses import dataclass
from enum import StrEnum

from reibench.dialogue import Dialogue, Vagueness
from reibench.scene import Pose, Vector


class TaskType(StrEnum):
    """ALFRED's task types as REI-Bench uses them (section 3.2), under ALFRED's own names."""

    PICK = "pick_and_place_simple"
    STACK = "pick_and_place_with_movable_recep"
    CLEAN = "pick_clean_then_place_in_recep"
    HEAT = "pick_heat_then_place_in_recep"
    COOL = "pick_cool_then_place_in_recep"
    EXAMINE = "look_at_obj_in_light"

    @property
    def label(self) -> str:
        """The paper's name, e.g. `Heat & Place`."""
        return TITLES[self]

    @property
    def short(self) -> str:
        """One word for tables and the command line, e.g. `heat`."""
        return self.name.lower()


TITLES = {
    TaskType.PICK: "Pick & Place",
    TaskType.STACK: "Stack & Place",
    TaskType.CLEAN: "Clean & Place",
    TaskType.HEAT: "Heat & Place",
    TaskType.COOL: "Cool & Place",
    TaskType.EXAMINE: "Examine in Light",
}


@dataclass(frozen=True)
class Goal:
    """What must hold at the end."""

    task_type: TaskType
    object: str
    """Type of what is to be picked up."""
    destination: str
    """Type of the receptacle it ends in, or of the lamp."""
    movable_receptacle: str = ""
    """Stack & Place only: type of what it is put into first."""
    sliced: bool = False

    @property
    def objects(self) -> tuple[str, ...]:
        """The task objects: what a plan must identify (reading note 9)."""
        if self.movable_receptacle:
            return (self.object, self.movable_receptacle)
        if self.task_type is TaskType.EXAMINE:
            return (self.object, self.destination)
        return (self.object,)


@dataclass(frozen=True)
class Placement:
    """An object put somewhere else than where the room has it."""

    object_id: str
    receptacle_id: str


@dataclass(frozen=True)
class ObjectPose:
    """Where some object of a type lies, as an ALFRED trial says it."""

    type: str
    position: Vector
    rotation: Vector
    """Degrees around the three axes."""


@dataclass(frozen=True)
class Toggle:
    """Whether everything of a type starts switched on."""

    type: str
    on: bool


@dataclass(frozen=True)
class SceneSetup:
    """How to set up the room."""

    room: str
    """A room's name, e.g. `kitchen-1`."""
    seed: int = 0
    """Decides where the robot starts."""
    placements: tuple[Placement, ...] = ()
    dirty: tuple[str, ...] = ()
    """Ids of objects that start dirty."""
    poses: tuple[ObjectPose, ...] = ()
    """Where everything that can be picked up lies; what is not named is not there (ALFRED)."""
    toggles: tuple[Toggle, ...] = ()
    dirty_and_empty: bool = False
    """Whether all that can be dirty is, and nothing is filled (ALFRED)."""
    start: Pose | None = None
    """Where the robot starts, or as near as it can stand; None leaves it to the seed."""


@dataclass(frozen=True)
class Task:
    """A goal in a scene; what ALFRED calls a trial."""

    id: str
    setup: SceneSetup
    goal: Goal


@dataclass(frozen=True)
class Episode:
    """A task together with the dialogue that asks for it."""

    task: Task
    dialogue: Dialogue
    vagueness: Vagueness
    candidates: tuple[str, ...] = ()
    """Object types a careful listener is left with; the first is meant."""
    underdetermined: bool = False
    """Whether more than one candidate is left; such episodes are kept apart in every table."""

    @property
    def id(self) -> str:
        """`TASK.LEVEL`, e.g. `pick_keys.mixed-noised`."""
        return f"{self.task.id}.{self.vagueness}"
