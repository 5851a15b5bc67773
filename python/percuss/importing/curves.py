"""Curves of other programs as tables of percuss."""

import math
from dataclasses import dataclass, field
from itertools import groupby

from .ledger import Place
from .model import Deck

Points = list[tuple[float, float]]
MOST_MATERIAL_ROWS = 32
STEP = 1e-6  # width of a vertical step, over the distance to the nearer of its neighbours
MOST_COMPARED_ROWS = 1000  # thinning takes the square of it


@dataclass
class Curve:
    """Straight lines through points, abscissae ascending; or an expression of t."""

    place: Place
    points: Points = field(default_factory=list)
    expression: str = ""
    relaxation: int = 0  # SIDR: 0 in the run, 1 in the dynamic relaxation before it, 2 in both
    is_of_time: bool = False  # something takes its value over time
    units: tuple[float, float, float] = (1.0, 1.0, 1.0)  # factors of mass, length and time of its file
    rows: Points = field(default_factory=list)  # the points as they are given: a vertical step is two at one place


def order_points(points: Points, span: float = math.inf) -> Points:
    """Ascending abscissae: a vertical step becomes one of a millionth of the way to the next point,
    or of the span that counts if that is less."""
    rows: Points = []
    for x, members in groupby(sorted(points, key=lambda point: point[0]), key=lambda point: point[0]):
        values = [y for _, y in members]
        rows.append((x, values[0]))
        if values[-1] != values[0]:
            rows.append((x, values[-1]))
    return widen_steps(rows, span)


def widen_steps(rows: Points, span: float) -> Points:
    """Moves the second of two rows at one place a little later."""
    widened = list(rows)
    for i in range(1, len(rows)):
        x = rows[i][0]
        if x == rows[i - 1][0]:
            ways = [abs(other - x)
                    for other in (rows[i - 2][0] if i > 1 else x, rows[i + 1][0] if i + 1 < len(rows) else x)
                    if other != x]
            gap = max(STEP * min(span, min(ways, default=abs(x) or 1.0)), 4 * math.ulp(x))
            widened[i] = (x + gap, rows[i][1])
    return widened


def interpolate(points: Points, x: float) -> float:
    """Value at x; the end values beyond the ends."""
    if x <= points[0][0]:
        return points[0][1]
    for (x0, y0), (x1, y1) in zip(points, points[1:]):
        if x <= x1:
            return y0 + (y1 - y0) * (x - x0) / (x1 - x0)
    return points[-1][1]


def is_constant(points: Points, end: float) -> bool:
    """Whether the curve has one value from 0 to the end."""
    inner = [y for x, y in points if 0 < x < end]
    values = {interpolate(points, 0.0), interpolate(points, end), *inner}
    return len(values) == 1 and points[0][0] <= 0 and points[-1][0] >= end


def make_time_value(curve: Curve, scale: float, end: float, shift: float = 0.0) -> "float | Deck":
    """A value of the deck over time. Before and behind the points it is 0, as in LS-DYNA;
    so is a curve of dynamic relaxation alone."""
    curve.is_of_time = True
    if curve.relaxation == 1:
        return 0.0
    if curve.expression:
        return {"expression": f"{scale!r} * ({curve.expression})"}
    points = [(x + shift, y * scale) for x, y in curve.points]
    if is_constant(points, end):
        return points[0][1]
    gap = 1e-6 * end
    if points[0][0] > gap and points[0][1] != 0:
        points = [(0.0, 0.0), (points[0][0] - gap, 0.0), *points]
    if points[-1][0] < end and points[-1][1] != 0:
        points.append((points[-1][0] + gap, 0.0))
    return {"table": [list(point) for point in clip_to_run(points, end)]}


def clip_to_run(points: Points, end: float) -> Points:
    """The part of a table from 0 to the end."""
    inner = [point for point in points if 0 < point[0] < end]
    return [(0.0, interpolate(points, 0.0)), *inner, (end, interpolate(points, end))]


def integrate(points: Points, pieces: int = 16) -> Points:
    """The integral of straight lines from the first point, sampled."""
    rows: Points = [(points[0][0], 0.0)]
    for (x0, y0), (x1, y1) in zip(points, points[1:]):
        start = rows[-1][1]
        for piece in range(1, pieces + 1):
            s = (x1 - x0) * piece / pieces
            rows.append((x0 + s, start + y0 * s + 0.5 * (y1 - y0) / (x1 - x0) * s * s))
    return rows


def differentiate(points: Points) -> Points:
    """The slopes of straight lines, with a step at each point."""
    rows: Points = []
    for (x0, y0), (x1, y1) in zip(points, points[1:]):
        slope = (y1 - y0) / (x1 - x0)
        rows += [(x0, slope), (x1, slope)]
    return order_points(rows)


def thin_rows(points: Points, most: int = MOST_MATERIAL_ROWS) -> tuple[Points, float]:
    """At most `most` of the rows, and the largest error of the rest as a share of the largest value.

    The row whose absence changes the curve least is removed first (Visvalingam and Whyatt 1993).
    """
    stride = -(-len(points) // MOST_COMPARED_ROWS)
    rows = points[:-1:stride] + points[-1:]
    while len(rows) > most:
        changes = [abs(interpolate([rows[i - 1], rows[i + 1]], rows[i][0]) - rows[i][1])
                   for i in range(1, len(rows) - 1)]
        del rows[1 + changes.index(min(changes))]
    largest = max((abs(y) for _, y in points), default=0.0) or 1.0
    return rows, max((abs(interpolate(rows, x) - y) for x, y in points), default=0.0) / largest
