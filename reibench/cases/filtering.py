"""Which cases are shown: a filter, as the page's address says it, and how many each choice leaves.

Beside every choice stands how many cases there would be with it and all the other filters.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from urllib.parse import urlencode

import pandas as pd

from reibench.cases.table import KINDS, LANES
from reibench.dialogue import LEVELS
from reibench.episode import TaskType

MOST_WORDS = 200
"""Characters of a search that are looked at."""


@dataclass(frozen=True)
class CaseFilter:
    """What cases must be; empty means any. Fields are the names of the address's parameters."""

    words: str = ""
    level: str = ""
    """One or more levels, with commas."""
    kind: str = ""
    task_type: str = ""
    error: str = ""
    """A kind of failure, or a finer one, of either run."""
    room: str = ""
    planner: str = ""
    """`person` for cases with one."""
    model: str = ""
    method: str = ""
    taken: str = ""
    """`MEANT/TAKEN/LANE`: what the goal's object was taken for, in the run of that lane; without
    one, in the run without a method."""
    tag: str = ""

    @classmethod
    def read(cls, asked: Mapping[str, str]) -> "CaseFilter":
        """Read an address's parameters; others are ignored."""
        known = {field.name for field in fields(cls)}
        return cls(**{name: asked[name][:MOST_WORDS] for name in known & asked.keys()})

    @property
    def active(self) -> dict[str, str]:
        """The filters that are set, by name."""
        return {f.name: getattr(self, f.name) for f in fields(self) if getattr(self, f.name)}

    @property
    def levels(self) -> tuple[str, ...]:
        """The chosen levels."""
        return tuple(filter(None, self.level.split(",")))

    def query(self, **changes: str) -> str:
        """Return the address's parameters for this filter with some of it changed."""
        return urlencode(replace(self, **changes).active)

    def toggled(self, level: str) -> str:
        """Return the levels with this one added or taken out."""
        chosen = [
            str(each) for each in LEVELS if (str(each) in self.levels) != (str(each) == level)
        ]
        return ",".join(chosen)


@dataclass(frozen=True)
class Found:
    """Cases that pass a filter, and how many each choice would leave."""

    cases: pd.DataFrame
    counts: Mapping[str, Mapping[str, int]]
    """By filter name, then by choice, the most frequent first."""
    emptied_by: str = ""
    """The name of the filter without which there would be some, where there are none."""


@dataclass(frozen=True)
class Kept:
    """What episodes are known by besides their records."""

    words: Mapping[str, str]
    """What is said in each, by its digest."""
    tags: Mapping[str, Sequence[str]]


def find(cases: pd.DataFrame, wanted: CaseFilter, kept: Kept) -> Found:
    """Return the cases that are all that is `wanted`."""
    masks = {name: mask for name, mask in _masks(cases, wanted, kept) if mask is not None}
    everything = pd.Series(True, index=cases.index)
    shown = _all(everything, masks)
    counts = {}
    for name, values in _choices(cases, kept).items():
        rest = _all(everything, {other: mask for other, mask in masks.items() if other != name})
        counts[name] = {
            str(k): int(v) for k, v in values[rest].explode().value_counts().items() if k != ""
        }
    emptied = ""
    if not shown.any() and len(cases):
        emptied = next(
            (
                name
                for name in masks
                if _all(everything, {o: m for o, m in masks.items() if o != name}).any()
            ),
            next(iter(masks), ""),
        )
    return Found(cases[shown], counts, emptied)


def _all(start: pd.Series, masks: Mapping[str, pd.Series]) -> pd.Series:
    for mask in masks.values():
        start = start & mask
    return start


def _masks(
    cases: pd.DataFrame, wanted: CaseFilter, kept: Kept
) -> Iterator[tuple[str, pd.Series | None]]:
    equal = ("kind", "task_type", "room", "model", "method")
    for name in equal:
        if value := getattr(wanted, name):
            yield name, cases[name] == value
    if wanted.levels:
        yield "level", cases["level"].isin(wanted.levels)
    if wanted.planner:
        yield "planner", _among(cases["actors"], wanted.planner)
    if wanted.error:
        yield "error", _among(cases["errors"], wanted.error)
    if wanted.taken:
        meant, instead, lane = taken_parts(wanted.taken)
        there = cases[f"{lane}_taken"] == instead if lane in LANES else False
        yield "taken", (cases["meant"] == meant) & there
    if wanted.tag:
        tagged = [digest for digest, tags in kept.tags.items() if wanted.tag in tags]
        yield "tag", cases["episode_digest"].isin(tagged)
    for place, word in enumerate(wanted.words.lower().split()):
        with_it = {digest for digest, words in kept.words.items() if word in words}
        with_it |= {
            digest for digest, tags in kept.tags.items() if any(word in tag.lower() for tag in tags)
        }
        yield f"words {place}", cases["episode_digest"].isin(with_it)


def taken_parts(taken: str) -> tuple[str, str, str]:
    """Return what was meant, what was taken, and in the run of which lane."""
    meant, _, rest = taken.partition("/")
    instead, _, lane = rest.partition("/")
    return meant, instead, lane or "plain"


def _choices(cases: pd.DataFrame, kept: Kept) -> dict[str, pd.Series]:
    """Return by filter the choices each case counts for, one or a tuple of several."""
    tags = cases["episode_digest"].map(lambda digest: tuple(kept.tags.get(digest, ())))
    single = ("level", "kind", "task_type", "room", "model", "method")
    return {
        **{name: cases[name] for name in single},
        "planner": cases["actors"],
        "error": cases["errors"],
        "tag": tags,
    }


def _among(several: pd.Series, wanted: str) -> pd.Series:
    """Return whether a choice is among those of each case."""
    each = several.explode()
    return pd.Series(several.index.isin(each.index[each == wanted]), index=several.index)


def in_order(name: str, counts: Mapping[str, int]) -> list[str]:
    """Return the choices of a filter in the order a page offers them."""
    order: Sequence[str] = ()
    if name == "kind":
        order = KINDS
    elif name == "task_type":
        order = [str(kind) for kind in TaskType]
    elif name == "level":
        order = [str(level) for level in LEVELS]
    known = [each for each in order if each in counts]
    return known + sorted(set(counts) - set(order))
