"""What visitors choose among, planners and methods, and what the page calls them."""

from reibench.methods import methods
from reibench.planners import planners
from reibench.run import needs_model


def method_title(name: str) -> str:
    """Return what the page calls the method registered under `name`."""
    return methods.create(name).title


def offered_methods() -> list[str]:
    """Return the names of the methods a model can be watched with; without one it is anyway."""
    return [name for name in methods.names() if name != "none"]


def offered_planners() -> list[str]:
    """Return the names of the planners that ask a model."""
    return [name for name in planners.names() if needs_model(name)]


def planner_title(name: str) -> str:
    """Return what the page calls the planner registered under `name`."""
    return str(getattr(planners.get(name), "title", name))


def planner_summary(name: str) -> str:
    """Return what that planner does, in a few words."""
    return str(getattr(planners.get(name), "summary", ""))
