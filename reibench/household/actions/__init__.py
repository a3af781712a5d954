"""Actions: AI2-THOR 5's, by name, each a function of the state and its arguments."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from importlib import import_module
from inspect import Parameter, signature
from typing import Any, TypeVar

from reibench.household.actions.kinds import Kind, kind_of
from reibench.household.state import State
from reibench.scene import SceneObject

Function = TypeVar("Function", bound=Callable[..., object])
FAMILIES = ("moving", "handling", "switching", "altering", "setting", "viewing")
ALWAYS_ALLOWED = frozenset(
    "agentId sequenceId renderImage renderDepthImage renderNormalsImage renderFlowImage"
    " renderInstanceSegmentation renderSemanticSegmentation renderObjectImage renderClassImage"
    " simplifyPhysics".split()
)
"""Arguments every AI2-THOR action takes; they concern frames, of which there are none here."""


class Refused(Exception):
    """An action that could not be carried out, in AI2-THOR's words."""

    def __init__(self, message: str, code: str = "") -> None:
        super().__init__(message)
        self.message = message
        self.code = code


@dataclass(frozen=True)
class Action:
    """One thing a controller can be asked to do."""

    name: str
    function: Callable[..., object]
    """Takes the state and the arguments, returns AI2-THOR's `actionReturn`; raises Refused."""
    changes: bool
    """Whether it may change an object, so that heat, cold and water have to take effect."""
    required: frozenset[str]
    arguments: frozenset[str]
    """Names of those it takes."""
    ignored: frozenset[str]
    """Names of those it lets pass."""
    kinds: dict[str, Kind]
    """What the values of its arguments can be."""
    anything: bool = False
    """Whether it takes arguments of any name."""


_ACTIONS: dict[str, Action] = {}


def action(*names: str, changes: bool = True) -> Callable[[Function], Function]:
    """Make the decorated function the action of those names."""

    def add(function: Function) -> Function:
        parameters = list(signature(function).parameters.values())[1:]
        named = [one for one in parameters if one.kind is not Parameter.VAR_KEYWORD]
        anything = len(named) < len(parameters)
        required = frozenset(one.name for one in named if one.default is Parameter.empty)
        own = frozenset(one.name for one in named)
        kinds = {one.name: kind_of(one.annotation) for one in named}
        for name in names:
            _ACTIONS[name] = Action(
                name, function, changes, required, own, ALWAYS_ALLOWED - own, kinds, anything
            )
        return function

    return add


@lru_cache(maxsize=1)
def known_actions() -> dict[str, Action]:
    """Return every action by name."""
    for family in FAMILIES:
        import_module(f"{__name__}.{family}")
    return dict(_ACTIONS)


def interactable(state: State, name: str, *, force: bool = False) -> SceneObject:
    """Return the object an action is about; raises Refused unless it is seen or `force` is set."""
    thing = state.objects.get(name)
    if thing is None:
        raise Refused(
            f"ArgumentException: objectId: {name} is not the objectId on any object in the scene!"
        )
    if not force and not state.sees(name):
        raise Refused(
            "NullReferenceException: Target object not found within the specified visibility.",
            "ObjectNotVisible",
        )
    return thing


def vector(value: Any) -> tuple[float, float, float]:
    """Read a position given as `{x, y, z}`; raises Refused if it is not one."""
    try:
        return float(value["x"]), float(value["y"]), float(value["z"])
    except (KeyError, TypeError, ValueError):
        raise Refused(
            f"The position {value!r} has not the form {{x, y, z}}.", "InvalidArgument"
        ) from None
