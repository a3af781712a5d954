"""Kinds of argument: which values an action's parameter takes, read off its annotation."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from numbers import Integral, Real
from types import UnionType
from typing import Any, get_args, get_origin


@dataclass(frozen=True)
class Kind:
    """What a parameter takes."""

    name: str
    """Its C# name, as AI2-THOR's error messages have it."""
    plain: frozenset[type]
    """Python types whose every value fits, looked up first because it is quick."""
    tests: tuple[Callable[[Any], bool], ...]

    def takes(self, value: object) -> bool:
        """Whether AI2-THOR would convert `value` to it."""
        return type(value) in self.plain or any(test(value) for test in self.tests)


def kind_of(annotation: Any) -> Kind:
    """Return the kind a parameter so annotated is of."""
    options = get_args(annotation) if isinstance(annotation, UnionType) else (annotation,)
    known = [_KNOWN[option] for option in options if option in _KNOWN]
    others = [option for option in options if option not in _KNOWN]
    plain = frozenset[type]().union(*(types for _, types, _ in known))
    tests = [test for _, _, tests in known for test in tests]
    tests += [_list_or_mapping(option) for option in others]
    names = [name for name, _, _ in known if name]
    return Kind(names[0] if names else "Vector3", plain, tuple(tests))


def _number(value: object) -> bool:
    return isinstance(value, Real) and not isinstance(value, bool)


def _whole(value: object) -> bool:
    return isinstance(value, Integral) and not isinstance(value, bool)


def _coordinates(value: object) -> bool:
    return isinstance(value, Mapping) and all(_number(each) for each in value.values())


def _list_or_mapping(annotation: Any) -> Callable[[Any], bool]:
    wanted = Sequence if get_origin(annotation) is list else Mapping
    return lambda value: isinstance(value, wanted) and not isinstance(value, str)


_KNOWN: dict[Any, tuple[str, frozenset[type], tuple[Callable[[Any], bool], ...]]] = {
    float: ("float", frozenset((float, int)), (_number,)),
    int: ("int", frozenset((int,)), (_whole,)),
    bool: ("Boolean", frozenset((bool,)), ()),
    # In C# a string may be null.
    str: ("String", frozenset((str, type(None))), ()),
    dict[str, float]: ("Vector3", frozenset(), (_coordinates,)),
    type(None): ("", frozenset((type(None),)), ()),
}
