"""Charts as SVG: bars with intervals by level, and differences with intervals."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from reibench.dialogue import CONTEXTS, REFERENCES
from reibench.view.markup import element, number, text

WIDTH, HEIGHT = 1232.0, 308.0
_LEFT, _TOP, _FLOOR = 46.0, 12.0, 252.0


@dataclass(frozen=True)
class Bar:
    """Success of one contestant at one level, in per cent."""

    rate: float
    low: float
    high: float
    episodes: int
    href: str


@dataclass(frozen=True)
class Series:
    """One contestant's bars."""

    title: str
    look: str
    """Class of its colour and pattern."""
    bars: dict[tuple[str, str], Bar]
    """By context and reference."""
    published: dict[tuple[str, str], tuple[float, ...]] = field(default_factory=dict)
    """What the paper has at each level, in per cent; drawn whether or not there is a bar."""


def bars(series: Sequence[Series]) -> str:
    """Return success by level: contexts side by side, in each the three kinds of reference."""
    parts = [_grid(share) for share in (0, 25, 50, 75, 100)]
    group = (WIDTH - _LEFT) / len(CONTEXTS)
    cell = group / len(REFERENCES)
    wide = min(34.0, (cell - 18) / max(len(series), 1))
    for at, context in enumerate(CONTEXTS):
        left = _LEFT + at * group
        if at:
            parts.append(element("path", d=f"M{number(left)} 8V296", class_="sep"))
        parts.append(
            element(
                "text",
                f"{context} context",
                x=left + group / 2,
                y=298.0,
                class_="axb",
                text_anchor="middle",
            )
        )
        for place, reference in enumerate(REFERENCES):
            middle = left + (place + 0.5) * cell
            parts.append(
                element("text", reference, x=middle, y=272.0, class_="ax", text_anchor="middle")
            )
            start = middle - wide * len(series) / 2
            for index, one in enumerate(series):
                level, left_edge = f"{reference}, {context}", start + index * wide
                if bar := one.bars.get((context, reference)):
                    parts.append(_bar(one, bar, left_edge, wide, level))
                parts += [
                    _published(one, rate, left_edge + wide * 0.86, level)
                    for rate in one.published.get((context, reference), ())
                ]
    return element(
        "svg", *parts, class_="chart", viewbox=f"0 0 {WIDTH:.0f} {HEIGHT:.0f}", role="group",
        aria_label="Success by level, in per cent",
    )  # fmt: skip


def _y(share: float) -> float:
    return _FLOOR - (_FLOOR - _TOP) * share / 100


def _grid(share: int) -> str:
    y = number(_y(share))
    line = element("path", d=f"M{number(_LEFT)} {y}H{number(WIDTH)}", class_="grid")
    return line + element(
        "text", str(share), x=_LEFT - 8, y=_y(share) + 4, class_="ax", text_anchor="end"
    )


def _bar(one: Series, bar: Bar, x: float, wide: float, level: str) -> str:
    inner = wide * 0.82
    middle = x + wide / 2
    words = (
        f"{one.title}, {level}: {bar.rate:.0f} % ({bar.low:.0f} to {bar.high:.0f}),"
        f" n = {bar.episodes}"
    )
    top = _y(bar.rate)
    body = element(
        "rect", x=x + (wide - inner) / 2, y=top, width=inner, height=max(_FLOOR - top, 1.0), rx=2.5,
        class_=one.look,
    )  # fmt: skip
    low, high = number(_y(bar.low)), number(_y(bar.high))
    cap = number(min(4.0, inner / 3))
    m = number(middle)
    whisker = f"M{m} {high}V{low}M{number(middle - float(cap))} {high}h{number(2 * float(cap))}" + (
        f"M{number(middle - float(cap))} {low}h{number(2 * float(cap))}"
    )
    title = element("title", text(words))
    hit = element(
        "rect", x=x, y=_TOP, width=wide, height=_FLOOR - _TOP, class_="hit", fill="transparent"
    )
    return element(
        "a", title, hit, body, element("path", d=whisker, class_="case"),
        element("path", d=whisker, class_="ci"), href=bar.href, class_="bar-link",
        aria_label=words,
    )  # fmt: skip


def _published(one: Series, rate: float, x: float, level: str) -> str:
    """Return the paper's number as a hollow diamond."""
    shape = f"M{number(x)} {number(_y(rate) - 5.5)}l5.500 5.500l-5.500 5.500l-5.500 -5.500z"
    title = element("title", text(f"{one.title}, {level}: published {rate:.1f} %"))
    return element("g", title, element("path", d=shape, class_="pub"))


@dataclass(frozen=True)
class Point:
    """A difference in percentage points, with its interval."""

    label: str
    value: float
    low: float
    high: float
    title: str


def differences(groups: Sequence[tuple[str, str, Sequence[Point]]]) -> str:
    """Return differences as points with intervals; each group has a title and a look."""
    points = [point for _, _, group in groups for point in group]
    most = max((abs(v) for p in points for v in (p.low, p.high, p.value) if v == v), default=10.0)
    reach = max(20.0, -(-most // 20) * 20)
    left, right = 92.0, 352.0
    zero = _scale(0.0, reach, left, right)
    parts, y = [], 14.0
    for title, look, group in groups:
        parts.append(element("text", text(title), x=0.0, y=y, class_="axb"))
        for point in group:
            y += 21
            parts.append(_point(point, look, y, lambda v: _scale(v, reach, left, right)))
        y += 28
    bottom = y - 14
    step = 20 if reach <= 60 else 40
    axis = [element("path", d=f"M{number(zero)} 20V{number(bottom)}", class_="zero")]
    for value in range(-int(reach), int(reach) + 1, step):
        x = _scale(float(value), reach, left, right)
        if value:
            axis.append(element("path", d=f"M{number(x)} 20V{number(bottom)}", class_="grid"))
        axis.append(
            element(
                "text",
                f"{value:+d}" if value else "0",
                x=x,
                y=bottom + 15,
                class_="ax",
                text_anchor="middle",
            )
        )
    return element(
        "svg", *axis, *parts, class_="chart", viewbox=f"0 0 368 {bottom + 22:.0f}", role="group",
        aria_label="Paired differences in percentage points",
    )  # fmt: skip


def _scale(value: float, reach: float, left: float, right: float) -> float:
    return left + (value + reach) / (2 * reach) * (right - left)


def _point(point: Point, look: str, y: float, scale: Callable[[float], float]) -> str:
    label = element("text", text(point.label), x=84.0, y=y + 4, class_="ax", text_anchor="end")
    drawn = [element("title", text(point.title)), label]
    if point.low == point.low:  # nan where one task says nothing about others
        span = f"M{number(scale(point.low))} {number(y)}H{number(scale(point.high))}"
        drawn.append(element("path", d=span, class_=f"fl {look}"))
    drawn.append(element("circle", cx=scale(point.value), cy=y, r=5.0, class_=look))
    return element("g", *drawn)
