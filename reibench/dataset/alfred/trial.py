"""One ALFRED trial: what its `traj_data.json` says of room, goal, expert plan and wording."""

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from reibench.episode import Goal, ObjectPose, SceneSetup, TaskType, Toggle
from reibench.errors import InvalidTrial
from reibench.scene import Pose, Vector

TWO_OBJECTS = "pick_two_obj_and_place"
"""ALFRED's seventh task type, which REI-Bench leaves out."""
NEW_NAMES = {
    "EggShell": "EggCracked",
    "Glassbottle": "Bottle",
    "PaperTowel": "PaperTowelRoll",
    "ToiletPaperRoll": "ToiletPaper",
}
"""AI2-THOR 5's names of the types that ALFRED's AI2-THOR 2.1 calls otherwise."""


@dataclass(frozen=True)
class Ask:
    """How one annotator worded the task."""

    text: str
    steps: tuple[str, ...]
    """Their words for each high-level action."""


@dataclass(frozen=True)
class PlanAction:
    """One high-level action of the expert's plan."""

    name: str
    """ALFRED's: GotoLocation, PickupObject, PutObject, SliceObject, HeatObject …"""
    object: str = ""
    """Type of what is gone to, handled or switched, in AI2-THOR 5's spelling."""
    receptacle: str = ""
    """Type of what it is put into, or taken from as far as the trial tells."""
    at: Vector | None = None
    """Where the object is, as far as the trial tells; None for slices."""
    receptacle_at: Vector | None = None
    """Where the receptacle stands, as far as the trial tells."""


@dataclass(frozen=True)
class Trial:
    """One trial."""

    id: str
    """E.g. `trial_T20190908_102840_789300`."""
    file: Path
    task_type: str
    goal: Goal | None
    """None for the task type with two objects."""
    setup: SceneSetup
    plan: tuple[PlanAction, ...]
    asks: tuple[Ask, ...]

    @property
    def split(self) -> str:
        """The folder of the split, e.g. `valid_seen`."""
        return self.file.parents[2].name


def find_trials(folder: Path) -> list[Trial]:
    """Read every trial below `folder`, sorted by path.

    Raises:
        InvalidTrial: when there is none, or one is not as it should be.
    """
    files = sorted(folder.rglob("traj_data.json"))
    if not files:
        raise InvalidTrial(f"There is no traj_data.json anywhere below {folder}.")
    return [read_trial(file) for file in files]


def read_trial(file: Path) -> Trial:
    """Read one trial; raises InvalidTrial naming the file and what is missing or wrong."""
    try:
        content = json.loads(file.read_text(encoding="utf-8"))
    except (OSError, ValueError) as problem:
        raise InvalidTrial(f"The trial {file} cannot be read: {problem}.") from None
    try:
        return _read(content, file)
    except KeyError as missing:
        raise InvalidTrial(f"The trial {file} has no {missing}.") from None
    except (TypeError, ValueError, AttributeError) as problem:
        raise InvalidTrial(f"The trial {file} has a value of the wrong form: {problem}.") from None


def new_name(name: str) -> str:
    """Return AI2-THOR 5's spelling of a type of ALFRED's, sliced or not."""
    return NEW_NAMES.get(name, name)


def _read(content: Mapping[str, Any], file: Path) -> Trial:
    task_type = content["task_type"]
    anns = content["turk_annotations"]["anns"]
    return Trial(
        id=content["task_id"],
        file=file,
        task_type=task_type,
        goal=None if task_type == TWO_OBJECTS else _goal(task_type, content["pddl_params"]),
        setup=_setup(content["scene"]),
        plan=tuple(_plan_action(each) for each in content["plan"]["high_pddl"]),
        asks=tuple(Ask(a["task_desc"].strip(), tuple(a["high_descs"])) for a in anns),
    )


def _goal(task_type: str, params: Mapping[str, Any]) -> Goal:
    kind = TaskType(task_type)
    where = params["toggle_target"] if kind is TaskType.EXAMINE else params["parent_target"]
    if not where or not params["object_target"]:
        raise ValueError(f"a {task_type} needs an object and a destination, but says {params}")
    return Goal(
        task_type=kind,
        object=new_name(params["object_target"]),
        destination=new_name(where),
        movable_receptacle=new_name(params["mrecep_target"]),
        sliced=bool(params["object_sliced"]),
    )


def _setup(scene: Mapping[str, Any]) -> SceneSetup:
    start = scene["init_action"]
    return SceneSetup(
        room=f"FloorPlan{int(scene['scene_num'])}",
        poses=tuple(_pose(each) for each in scene["object_poses"]),
        toggles=tuple(
            Toggle(new_name(each["objectType"]), bool(each["isOn"]))
            for each in scene["object_toggles"]
        ),
        dirty_and_empty=bool(scene["dirty_and_empty"]),
        start=Pose(_point(start), float(start["rotation"]), float(start["horizon"])),
    )


def _pose(entry: Mapping[str, Any]) -> ObjectPose:
    name, _, _ = entry["objectName"].rpartition("_")
    if not name:
        raise ValueError(f"objectName {entry['objectName']!r} is not TYPE_HASH")
    return ObjectPose(new_name(name), _point(entry["position"]), _point(entry["rotation"]))


def _point(point: Mapping[str, Any]) -> Vector:
    return Vector(*(round(float(point[axis]), 4) for axis in ("x", "y", "z")))


def _plan_action(entry: Mapping[str, Any]) -> PlanAction:
    name, arguments = entry["discrete_action"]["action"], entry["discrete_action"]["args"]
    told = entry["planner_action"]
    if name == "NoOp":
        return PlanAction(name)
    if name == "GotoLocation":
        return PlanAction(name, object=arguments[0])
    object_id, receptacle = told["objectId"], told.get("receptacleObjectId", "")
    kind, at = _type_of(receptacle), _place_of(receptacle)
    if not receptacle and "coordinateReceptacleObjectId" in told:
        kind, coordinates = told["coordinateReceptacleObjectId"]
        # Twice each of x, z and y, in quarters of a metre.
        x, _, z, _, y, _ = (float(number) / 4 for number in coordinates)
        kind, at = new_name(kind), Vector(x, y, z)
    return PlanAction(name, _type_of(object_id), kind, _place_of(object_id), at)


def _type_of(object_id: str) -> str:
    return new_name(object_id.partition("|")[0])


def _place_of(object_id: str) -> Vector | None:
    """Return the place that an id `Type|x|y|z` names; None for those of slices, or of nothing."""
    parts = object_id.split("|")
    if len(parts) < 4 or "Sliced" in parts[-1]:
        return None
    return Vector(*map(float, parts[1:4]))
