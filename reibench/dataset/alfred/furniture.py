"""Furniture that AI2-THOR 5 calls otherwise: a cart in ALFRED's room is a side table now."""

from dataclasses import replace
from math import dist

from reibench.dataset.alfred.trial import PlanAction, Trial
from reibench.scene import SceneObject, Vector

SAME_PLACE = 0.1
"""Metres within which furniture counts as the same piece."""


def in_names_of(objects: tuple[SceneObject, ...], trial: Trial) -> Trial:
    """Return `trial` with the receptacles that its room lacks called as the room calls them.

    Only what stands in the very place that the plan names counts as the same piece.
    """
    there = {thing.type for thing in objects}
    renamed = {
        action.receptacle: name
        for action in trial.plan
        if action.receptacle and action.receptacle not in there
        if (name := _standing_at(objects, action.receptacle_at))
    }
    if not renamed:
        return trial
    goal = trial.goal
    if goal is not None:
        goal = replace(goal, destination=renamed.get(goal.destination, goal.destination))
    return replace(trial, goal=goal, plan=tuple(_renamed(each, renamed) for each in trial.plan))


def same_piece(thing: SceneObject, place: Vector | None) -> bool:
    """Whether `thing` stands where the trial has a receptacle."""
    return place is not None and dist(thing.position, place) <= SAME_PLACE


def _standing_at(objects: tuple[SceneObject, ...], place: Vector | None) -> str:
    found = (o.type for o in objects if o.receptacle and not o.pickupable and same_piece(o, place))
    return next(found, "")


def _renamed(action: PlanAction, names: dict[str, str]) -> PlanAction:
    by_lower = {old.lower(): new.lower() for old, new in names.items()}
    if action.name == "GotoLocation":
        return replace(action, object=by_lower.get(action.object, action.object))
    return replace(action, receptacle=names.get(action.receptacle, action.receptacle))
