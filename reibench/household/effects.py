"""What happens by itself: fridges cool, burners heat, faucets wash, hot things cool down."""

from collections.abc import Callable, Iterable

from reibench.household.state import State
from reibench.scene import SceneObject, Temperature

LASTS = 100
"""Actions after which what is hot or cold is at room temperature again; AI2-THOR counts seconds."""
FAUCET_REACH = 1.0
"""Metres from a faucet to its basin."""


def take_effect(state: State) -> None:
    """Let every fridge, heater and faucet act on what is in or on it now."""
    for name in state.sources:
        thing = state.objects[name]
        _EFFECTS[thing.type](state, thing)
    if state.warmth:
        _fade(state)


def _cool(state: State, fridge: SceneObject) -> None:
    _bring_to(state, state.inside(fridge.id), "Cold")


def _heat(state: State, heater: SceneObject) -> None:
    if heater.on:
        _bring_to(state, state.inside(heater.id), "Hot")


def _brew(state: State, machine: SceneObject) -> None:
    if not machine.on:
        return
    for mug in tuple(state.inside(machine.id)):
        if mug.fillable and not mug.filled:
            state.change(mug.id, filled=True, liquid="coffee", temperature="Hot")
            state.warmth[mug.id] = state.time


def _wash(state: State, faucet: SceneObject) -> None:
    if not faucet.on:
        return
    x, _, z = faucet.box.center
    basins = state.of_type("SinkBasin") + state.of_type("BathtubBasin")
    near = [(state.footprints[basin.id].distance(x, z), basin.id) for basin in basins]
    near = [pair for pair in near if pair[0] <= FAUCET_REACH]
    for thing in tuple(state.inside(min(near)[1])) if near else ():
        if thing.dirty:
            state.change(thing.id, dirty=False)
        if thing.fillable and not thing.filled and not thing.broken:
            state.change(thing.id, filled=True, liquid="water")


def _bring_to(state: State, things: Iterable[SceneObject], temperature: Temperature) -> None:
    for thing in tuple(things):
        state.warmth[thing.id] = state.time
        cooked = thing.cooked or (temperature == "Hot" and thing.cookable)
        if thing.temperature != temperature or thing.cooked != cooked:
            state.change(thing.id, temperature=temperature, cooked=cooked)


def _fade(state: State) -> None:
    for name, since in tuple(state.warmth.items()):
        if state.time - since > LASTS:
            del state.warmth[name]
            state.change(name, temperature="RoomTemp")


# The keys are the `SOURCES` of `objects.py`.
_EFFECTS: dict[str, Callable[[State, SceneObject], None]] = {
    "Fridge": _cool,
    "Microwave": _heat,
    "StoveBurner": _heat,
    "Toaster": _heat,
    "CoffeeMachine": _brew,
    "Faucet": _wash,
}
