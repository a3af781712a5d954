"""What visitors choose among, planners and methods, and what the page calls them."""

from reibench.methods import methods
from reibench.models import shelf
from reibench.planners import planners
from reibench.run import needs_model


def method_title(name: str) -> str:
    """Return what the page calls the method registered under `name`."""
    return methods.create(name).title


def offered_methods() -> list[str]:
    """Return the names of the methods a model can be watched with; without one it is anyway."""
    return [name for name in methods.names() if name != "none"]


def adapter_of(method: str) -> str:
    """Return the adapter that the method asks of a model, or nothing."""
    return str(getattr(methods.get(method), "adapter", ""))


def usable_method(chosen: str, model: str) -> str:
    """Return `chosen` if `model` can do it, else what suits the model.

    The paper's free rewrite wants a larger model than those that come along (see the README).
    """
    known = [one.adapters for one in shelf() if f"llama-cpp:{one.name}" == model]
    if not known:
        return chosen or "tocc-span"
    usable = (one for one in (chosen, "tocc-taught") if one and adapter_of(one) in {"", *known[0]})
    return next(usable, "tocc-span")


def offered_planners() -> list[str]:
    """Return the names of the planners that ask a model."""
    return [name for name in planners.names() if needs_model(name)]


def planner_title(name: str) -> str:
    """Return what the page calls the planner registered under `name`."""
    return str(getattr(planners.get(name), "title", name))


def planner_summary(name: str) -> str:
    """Return what that planner does, in a few words."""
    return str(getattr(planners.get(name), "summary", ""))
