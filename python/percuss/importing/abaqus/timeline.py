"""Several steps one after the other: what acts in each becomes values over the time of the run."""

from dataclasses import dataclass, field
from typing import Any

from ..curves import Curve, Points, differentiate, interpolate, make_time_value, order_points
from ..ledger import Place
from ..model import Deck

Target = tuple[Any, ...]  # what an action acts on, such as a node and a direction
FIXED, VELOCITY, DISPLACEMENT, LOAD = "fixed", "velocity", "displacement", "load"


@dataclass
class StepTime:
    """A step of explicit dynamics in the time of the run."""

    place: Place
    start: float
    length: float = 0.0

    @property
    def end(self) -> float:
        return self.start + self.length


@dataclass(frozen=True)
class Action:
    """What acts in a direction from the start of a step on, until another takes its place."""

    kind: str
    start: float
    points: tuple[tuple[float, float], ...]  # over the time of the run, from the start on; empty: at rest
    place: Place
    is_sampled: bool = False  # from a curve, by straight lines


@dataclass
class Window:
    action: Action
    start: float
    end: float


@dataclass
class Timeline:
    """What acts on each target, such as a node and a direction, one after the other."""

    end: float
    windows: dict[Target, list[Window]] = field(default_factory=dict)
    lines: dict[Place, None] = field(default_factory=dict)  # of all actions, those included that another has replaced

    def act(self, target: Target, action: Action) -> None:
        """Lets an action act from its start on, in place of what acted there."""
        self.lines[action.place] = None
        rows = self.windows.setdefault(target, [])
        if rows and rows[-1].end > action.start:
            rows[-1].end = action.start
        if rows and rows[-1].start >= rows[-1].end:
            rows.pop()
        same = rows and rows[-1].end == action.start and rows[-1].action.kind == FIXED == action.kind
        if same:
            rows[-1].end = self.end
        else:
            rows.append(Window(action, action.start, self.end))

    def stop(self, targets: list[Target], time: float) -> None:
        """OP=NEW: what acted before ends."""
        for target in targets:
            for window in self.windows.get(target, []):
                window.end = min(window.end, time)
            self.windows[target] = [window for window in self.windows.get(target, []) if window.end > window.start]
            if not self.windows[target]:
                del self.windows[target]


def shift_points(points: Points, step: StepTime, is_total: bool, end: float) -> Points:
    """An amplitude in the time of the run: of a step it is cut at its end, where its value stays."""
    if not is_total:
        points = [(x + step.start, y) for x, y in points]
    first = max(step.start, 0.0)
    last = end if is_total else step.end
    inner = [(x, y) for x, y in points if first < x < last]
    value = interpolate_steps(points, last)
    return [(first, interpolate_steps(points, first, after=True)), *inner, (last, value), (end * 1.01, value)]


def interpolate_steps(points: Points, x: float, after: bool = False) -> float:
    """A value where two points may have one time: that before it, or that after it."""
    if after:
        same = [y for t, y in points if t == x]
        return same[-1] if same else interpolate(order_points(points), x)
    return interpolate(order_points(points), x)


def values_of(points: Points, place: Place, end: float) -> "float | Deck":
    """A value of the deck over the whole run."""
    held = [(min(points[0][0], 0.0), points[0][1])] if points[0][0] <= 0 else []
    rows = [*held, *(p for p in points if not held or p[0] > held[0][0])]
    return make_time_value(Curve(place, order_points(rows, end)), 1.0, end)


def join_loads(windows: list[Window], end: float) -> Points:
    """Loads one after the other, 0 between them."""
    rows: Points = [(0.0, 0.0)] if windows[0].start > 0 else []
    for window in windows:
        rows += [(window.start, 0.0)] if window.start > 0 and (not rows or rows[-1][1] == 0) else []
        points = list(window.action.points)
        rows += cut(points, window)
        if window.end < end:
            rows.append((window.end, 0.0))
    return rows


def cut(points: Points, window: Window) -> Points:
    """The part of a curve that lies in a window, with its ends."""
    inner = [(x, y) for x, y in points if window.start < x < window.end]
    return [(window.start, interpolate_steps(points, window.start, after=True)), *inner,
            (window.end, interpolate_steps(points, window.end))]


def join_displacements(windows: list[Window]) -> Points:
    """Displacements one after the other: each goes on from where the one before ended."""
    rows: Points = []
    level = 0.0
    for window in windows:
        points = list(window.action.points)
        piece = cut(points, window) if points else [(window.start, 0.0), (window.end, 0.0)]
        first = piece[0][1]
        rows += [(x, level + y - first) for x, y in piece]
        level = rows[-1][1]
    return rows


def join_velocities(windows: list[Window]) -> Points:
    """Velocities one after the other; of a displacement its slope."""
    rows: Points = []
    for window in windows:
        points = list(window.action.points)
        if window.action.kind == DISPLACEMENT:
            points = differentiate(order_points(points))
        rows += cut(points, window) if points else [(window.start, 0.0), (window.end, 0.0)]
    return rows


def is_whole(windows: list[Window], end: float) -> bool:
    """Whether something acts at each time of the run."""
    return (windows[0].start <= 0 and windows[-1].end >= end
            and all(a.end == b.start for a, b in zip(windows, windows[1:])))


def split_groups(windows: list[Window]) -> list[list[Window]]:
    """Windows that follow each other without a gap."""
    groups: list[list[Window]] = []
    for window in windows:
        if groups and groups[-1][-1].end == window.start:
            groups[-1].append(window)
        else:
            groups.append([window])
    return groups


def make_motion(windows: list[Window], end: float, direction: str) -> Deck:
    """A condition for windows without a gap: at rest, moved, or driven."""
    kinds = {window.action.kind for window in windows}
    place = windows[0].action.place
    if kinds == {FIXED}:
        return {"fixed": [direction]}
    if VELOCITY not in kinds and windows[0].start <= 0 and not direction.startswith("r"):
        return {"displacement": {direction: values_of(join_displacements(windows), place, end)}}
    return {"velocity": {direction: values_of(join_velocities(windows), place, end)}}
