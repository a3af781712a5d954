"""The two bar figures: success by level of every planner and model, and of every method.

The only home of matplotlib.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

import pandas as pd

from reibench.dialogue import CONTEXTS, REFERENCES, Context
from reibench.published import MODEL, PLANNER, published_success
from reibench.report.error_tables import SETTINGS
from reibench.report.labels import (
    distinct,
    each_run,
    method_label,
    model_label,
    model_labels,
    place_of,
    planner_label,
)
from reibench.report.looks import INK, LINE, LOOK, MARKERS, METHOD_LOOKS, OTHER_LOOK
from reibench.report.selecting import contestants
from reibench.score import summarise

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

FORMATS = ("svg", "png", "pdf")
PEOPLE = "people"
CROWDED = 4
"""Of more runs than these the three contexts stand on axes of their own."""


@dataclass(frozen=True)
class Bar:
    """Success at one level, in per cent."""

    rate: float
    said_done: float
    low: float
    high: float
    episodes: int


@dataclass(frozen=True)
class Series:
    """One run's bars."""

    label: str
    fill: str
    hatch: str
    method: str
    bars: dict[tuple[str, str], Bar]
    """By context and reference."""


@dataclass(frozen=True)
class Panel:
    """What is drawn on one pair of axes."""

    title: str
    series: tuple[Series, ...]
    planner: str
    contexts: tuple[Context, ...] = CONTEXTS


def draw_beside_people(
    people: pd.DataFrame, planners: pd.DataFrame, folder: Path
) -> Iterator[Path]:
    """Draw success by level of people, and of planners' runs beside them, and yield the files.

    Args:
        people: finished trials, with the columns of `records_frame`.
        planners: as `records_frame` returns it, of the runs to draw; may be empty.
        folder: made if it is not there.
    """
    folder.mkdir(parents=True, exist_ok=True)
    person = _series(people.assign(run=PEOPLE), PEOPLE, PEOPLE, PEOPLE)
    asked = planners[planners["model"] != ""] if len(planners) else planners
    panels = [
        replace(panel, series=(person, *panel.series))
        for panel in (_panels_of_methods(asked) if len(asked) else ())
    ]
    yield from _draw(
        panels or [Panel("People", (person,), "")], folder / "people-by-level", paper=False
    )


def draw_figures(frame: pd.DataFrame, folder: Path, *, paper: bool = False) -> Iterator[Path]:
    """Draw both figures into `folder`, as SVG, PNG and PDF, and yield the files.

    Args:
        frame: as `records_frame` returns it, of the chosen runs.
        folder: made if it is not there.
        paper: whether to mark the paper's own numbers.
    """
    chosen = contestants(frame)
    folder.mkdir(parents=True, exist_ok=True)
    plain = chosen[chosen["method"] == "none"]
    if len(plain):
        panels = _panels_of_models(plain)
        yield from _draw(
            panels, folder / "success-by-level", columns=min(3, len(panels)), paper=paper
        )
    yield from _draw(_panels_of_methods(chosen), folder / "success-by-method", paper=paper)


def _panels_of_models(plain: pd.DataFrame) -> list[Panel]:
    runs = each_run(plain)
    labels = distinct(runs, model_labels(runs, planners=True))
    return [
        Panel(label, (_series(plain, run, "", "none"),), planner)
        for label, run, planner in zip(labels, runs["run"], runs["planner"], strict=True)
    ]


def _panels_of_methods(records: pd.DataFrame) -> list[Panel]:
    panels = []
    for _, part in records.groupby(SETTINGS, sort=False):
        runs = each_run(part).sort_values("method", key=lambda names: names.map(place_of))
        labels = distinct(runs, [method_label(method) for method in runs["method"]])
        each = zip(labels, runs["run"], runs["method"], strict=True)
        series = tuple(_series(part, run, label, method) for label, run, method in each)
        [model], [planner] = set(runs["model"].map(model_label)), set(runs["planner"])
        panel = Panel(f"{model} + {planner_label(planner)}", series, planner)
        panels += [panel] if len(series) <= CROWDED else _by_context(panel)
    return panels


def _by_context(panel: Panel) -> list[Panel]:
    return [
        replace(panel, title=f"{panel.title}, {context} context", contexts=(context,))
        for context in CONTEXTS
    ]


def _series(records: pd.DataFrame, run: str, label: str, method: str) -> Series:
    fill, hatch = METHOD_LOOKS.get(method, OTHER_LOOK)
    rows = summarise(records[records["run"] == run], ["context", "reference"]).to_dict("records")
    bars = {
        (row["context"], row["reference"]): Bar(
            rate=100 * row["success_rate"],
            said_done=100 * row["success_said_done_rate"],
            low=100 * row["success_low"],
            high=100 * row["success_high"],
            episodes=row["episodes"],
        )
        for row in rows
        if row["episodes"]
    }
    return Series(label, fill, hatch, method, bars)


def _draw(panels: Sequence[Panel], path: Path, *, columns: int = 1, paper: bool) -> Iterator[Path]:
    # matplotlib takes a second or two to import, and most scores are never drawn.
    import matplotlib as mpl
    from matplotlib.figure import Figure

    with mpl.rc_context(LOOK):
        rows = -(-len(panels) // columns)
        most = max(len(panel.series) for panel in panels)
        width = min(14.0, max(4.6 * columns, 7.0 + 1.4 * (most - 1)))
        figure = Figure(figsize=(width, 2.7 * rows + 0.5), layout="constrained")
        grid = figure.subplots(rows, columns, squeeze=False, sharey=True)
        for axes, panel in zip(grid.flat, panels, strict=False):
            _draw_panel(axes, panel, paper=paper)
        for axes in grid[:, 0]:
            axes.set_ylabel("success, %")
        for axes in list(grid.flat)[len(panels) :]:
            axes.set_axis_off()
        _legend(figure, panels, paper=paper)
        for form in FORMATS:
            written = path.with_suffix(f".{form}")
            # no dates: the same scores give the same file
            dated = {"svg": "Date", "pdf": "CreationDate"}.get(form)
            figure.savefig(written, dpi=180, metadata={dated: None} if dated else {})
            yield written


def _draw_panel(axes: "Axes", panel: Panel, *, paper: bool) -> None:
    step = 0.82 / len(panel.series)
    for number, series in enumerate(panel.series):
        for level in series.bars:
            if level[0] not in panel.contexts:
                continue
            centre = _place(level, panel) + (number - (len(panel.series) - 1) / 2) * step
            _draw_bar(axes, (series, level), centre, 0.86 * step)
            if paper and panel.planner == PLANNER:
                _mark_published(axes, series.method, level, centre, step)
    axes.set_title(f"{panel.title}  (n = {_sizes(panel)})")
    axes.set_ylim(0, 104)
    axes.set_yticks(range(0, 101, 25))
    levels = [(context, reference) for context in panel.contexts for reference in REFERENCES]
    axes.set_xlim(-0.6, _place(levels[-1], panel) + 0.6)
    axes.set_xticks(
        [_place(level, panel) for level in levels], [reference for _, reference in levels]
    )
    axes.tick_params(length=0)
    axes.grid(axis="y", color=LINE, linewidth=0.8)
    axes.set_axisbelow(True)
    axes.spines[["top", "right", "left"]].set_visible(False)
    for context in panel.contexts if len(panel.contexts) > 1 else ():
        middle = _place((context, REFERENCES[1]), panel)
        axes.annotate(
            f"{context} context", (middle, 0), (0, -20), ha="center", va="top", weight="bold",
            xycoords="data", textcoords="offset points",
        )  # fmt: skip


def _sizes(panel: Panel) -> str:
    """Return how many episodes a bar stands for."""
    sizes = {bar.episodes for series in panel.series for bar in series.bars.values()} or {0}
    return f"{min(sizes)}" if len(sizes) == 1 else f"{min(sizes)} to {max(sizes)}"


def _place(level: tuple[str, str], panel: Panel) -> float:
    """Return where a level stands on the x axis; contexts stand a little apart."""
    context, reference = level
    number = panel.contexts.index(context)
    return number * (len(REFERENCES) + 0.5) + REFERENCES.index(reference)


def _draw_bar(
    axes: "Axes", drawn: tuple[Series, tuple[str, str]], centre: float, width: float
) -> None:
    """Draw success as a frame, filled up to what was also said to be done, and its interval."""
    series, level = drawn
    bar = series.bars[level]
    for height, colour, hatch in (
        (bar.rate, "none", ""),
        (bar.said_done, series.fill, series.hatch),
    ):
        [patch] = axes.bar(
            centre, height, width, color=colour, hatch=hatch, edgecolor=INK, linewidth=0.7, zorder=2
        )
        reading = "solved" if colour == "none" else "said-done"
        # what the bar stands for, for whoever reads the SVG
        patch.set_gid(f"{series.method} {level[1]}-{level[0]} {reading} {height:.1f}")
    spread = [[bar.rate - bar.low], [bar.high - bar.rate]]
    # a pale line below the dark one, so that it is seen on dark bars
    for colour, thick, order in (("#ffffff", 2.6, 3), (INK, 1.0, 4)):
        axes.errorbar(
            centre, bar.rate, yerr=spread, ecolor=colour, elinewidth=thick, capsize=2.0,
            capthick=thick, fmt="none", zorder=order,
        )  # fmt: skip


def _mark_published(
    axes: "Axes", method: str, level: tuple[str, str], centre: float, step: float
) -> None:
    context, reference = level
    several = step < 0.5
    for model, rates in published_success(method, reference, context).items():
        if several and model != MODEL:
            continue
        for rate in rates:
            [mark] = axes.plot(
                centre + 0.36 * step, rate, marker=MARKERS[model], markersize=4.5,
                markerfacecolor="#ffffff", markeredgecolor=INK, markeredgewidth=1.1, zorder=5,
                clip_on=False,
            )  # fmt: skip
            mark.set_gid(f"paper {model} {method} {reference}-{context} {rate:.1f}")


def _legend(figure: "Figure", panels: Iterable[Panel], *, paper: bool) -> None:
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch

    looks = {s.label: (s.fill, s.hatch) for panel in panels for s in panel.series if s.label}
    entries: list[Patch | Line2D] = [
        Patch(facecolor=fill, hatch=hatch, edgecolor=INK, linewidth=0.7, label=label)
        for label, (fill, hatch) in looks.items()
    ]
    entries.append(Patch(facecolor="none", edgecolor=INK, label="empty: solved, not said done"))
    entries.append(Line2D([], [], color=INK, linewidth=1, label="95 % Wilson interval"))
    if paper:
        shown = [MODEL] if looks else list(MARKERS)
        entries += [
            Line2D(
                [], [], linestyle="none", marker=MARKERS[model], markerfacecolor="#ffffff",
                markeredgecolor=INK, label=f"paper: {model}, SayCan",
            )
            for model in shown
        ]  # fmt: skip
    fitting = int(figure.get_figwidth() / 2.7)
    figure.legend(
        handles=entries,
        loc="outside lower center",
        ncols=min(fitting, len(entries)),
        frameon=False,
    )
