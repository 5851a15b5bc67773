"""Meshes by rule: *NGEN, *NFILL, *NCOPY, *NMAP, *ELGEN, *ELCOPY, and the systems of *NODE and *SYSTEM."""

import math
from collections.abc import Callable, Iterable
from operator import mul

from ..fields import MOST_ID, clip
from ..ledger import BadInput, Place, missing
from ..model import Vector
from ..shapes import cross, make_vector, normalise, subtract
from .lines import Block, Line
from .mesh import MOST_MEMBERS, Scope, keep_once, rotate

Axes = tuple[Vector, Vector, Vector]
SAME_PLACE = 1e-6  # share of the largest coordinate: what files round


def read_system(scope: Scope, block: Block) -> None:
    """*SYSTEM: origin, a point of x, and a point of the plane of x and y, without which z is that of space;
    without data the axes of space."""
    values = [block.number(line, i) for line in block.lines for i in range(len(line[1])) if line[1][i]]
    if not values:
        scope.origin, scope.axes = (0.0, 0.0, 0.0), None
        return
    if len(values) not in (3, 6, 9):
        raise BadInput(block.place,
                       "*SYSTEM has neither 3, 6 nor 9 numbers (an origin, and one or two points): correct it")
    scope.origin, scope.axes = (values[0], values[1], values[2]), None
    if len(values) == 6:  # z stays, and the axis x lies in the plane of x and y
        x, y = values[3] - values[0], values[4] - values[1]
        if not math.hypot(x, y) > 0:
            raise BadInput(block.place,
                           "the second point of *SYSTEM lies above the origin: correct it, or add a third point")
        first = normalise((x, y, 0.0))
        scope.axes = first, (-first[1], first[0], 0.0), (0.0, 0.0, 1.0)
    if len(values) == 9:
        scope.axes = make_axes(scope.origin, make_vector(values[3:6]), make_vector(values[6:9]), block.place)


def make_axes(origin: Vector, on_x: Vector, in_plane: Vector, place: Place) -> Axes:
    """Axes from three points."""
    first, second = subtract(on_x, origin), subtract(in_plane, origin)
    third = cross(first, second)
    if math.hypot(*third) <= 1e-12 * math.hypot(*first) * math.hypot(*second):
        raise BadInput(place, "three points of axes are on a line: correct them")
    x, z = normalise(first), normalise(third)
    return x, cross(z, x), z


def place_node(scope: Scope, kind: str, v: Vector) -> Vector:
    """Coordinates in a rectangular, cylindrical (r, angle, z) or spherical (r, angle,
    angle from the plane) system, in space."""
    if kind == "C":
        v = (v[0] * math.cos(math.radians(v[1])), v[0] * math.sin(math.radians(v[1])), v[2])
    elif kind == "S":
        around, up = math.radians(v[1]), math.radians(v[2])
        v = (v[0] * math.cos(up) * math.cos(around), v[0] * math.cos(up) * math.sin(around), v[0] * math.sin(up))
    if scope.axes:
        v = tuple(sum(v[i] * scope.axes[i][d] for i in range(3)) for d in range(3))  # type: ignore[assignment]
    o = scope.origin
    return (o[0] + v[0], o[1] + v[1], o[2] + v[2])


def read_nodes(scope: Scope, block: Block) -> None:
    """Coordinates are those of the option SYSTEM, in the axes of the last *SYSTEM."""
    kind = block.option("SYSTEM") or "R"
    if kind not in ("R", "C", "S"):
        raise BadInput(block.place, f"*NODE, SYSTEM={clip(kind)} (R, C or S is expected): correct it")
    for line in block.lines:
        id = block.id(line, 0)
        x = place_node(scope, kind, (block.number(line, 1), block.number(line, 2), block.number(line, 3)))
        keep_once(scope.nodes, scope.node_lines, "node", id, x, block.at(line[0]))
        add_set(scope.node_sets, block.option("NSET"), [id])


def add_node(scope: Scope, block: Block, id: int, x: Vector) -> None:
    if not 1 <= id <= MOST_ID or len(scope.nodes) >= MOST_MEMBERS:
        raise BadInput(block.place, f"*{block.keyword} makes node {id}, or too many of them: correct it")
    if (math.dist(scope.nodes.get(id, x), x) > SAME_PLACE * max(abs(c) for c in x)
            and (first := scope.node_lines.find(id))):
        raise BadInput(block.place, f"*{block.keyword} makes node {id} at another place (the first is at {first}): "
                                    "renumber or remove one")
    scope.nodes[id] = x


def find_node(scope: Scope, block: Block, line: Line, id: int) -> Vector:
    if id not in scope.nodes:
        raise BadInput(block.at(line[0]), missing(f"node {id}"))
    return scope.nodes[id]


def add_set(sets: dict[str, list[int]], name: str, ids: Iterable[int]) -> None:
    if name:
        sets.setdefault(name, []).extend(ids)


def read_ngen(scope: Scope, block: Block) -> None:
    """Nodes on a line between two: first, last, increment of the ids; of a curve its extra point."""
    for line in block.lines:
        first, last, step = block.id(line, 0), block.id(line, 1), abs(block.integer(line, 2, 1)) or 1
        a, b = find_node(scope, block, line, first), find_node(scope, block, line, last)
        count = abs(last - first) // step
        if abs(last - first) % step or not count:
            raise BadInput(block.at(line[0]),
                           f"ids {first} to {last} are not a whole number of increments of {step}: correct it")
        ids = [first + (step if last > first else -step) * i for i in range(min(count, MOST_MEMBERS) + 1)]
        curve = choose_curve(scope, block, line, a, b)
        for i, id in enumerate(ids[1:-1], 1):
            add_node(scope, block, id, curve(i / count))
        add_set(scope.node_sets, block.option("NSET"), ids)


def choose_curve(scope: Scope, block: Block, line: Line, a: Vector,
                 b: Vector) -> Callable[[float], Vector]:
    """Places by their share of a straight line, a parabola (P, its midpoint is given) or an arc (C, its centre)."""
    kind, system = block.option("LINE"), block.option("SYSTEM") or "R"
    if not kind:
        return lambda share: between(a, b, share)
    if kind not in ("P", "C") or system not in ("R", "RC", "C", "S"):
        raise BadInput(block.place, f"*NGEN, LINE={clip(kind)}, SYSTEM={clip(system)} "
                                    "(P or C, and RC, C or S are expected): correct it")
    values = (block.number(line, 4), block.number(line, 5), block.number(line, 6))
    extra = (find_node(scope, block, line, block.id(line, 3)) if block.text(line, 3)
             else place_node(scope, system[0], values))
    if kind == "P":
        return lambda s: make_vector((1 - s) * (1 - 2 * s) * p + 4 * s * (1 - s) * m + s * (2 * s - 1) * q
                                     for p, m, q in zip(a, extra, b))
    return turn_about(extra, a, b, (block.number(line, 7), block.number(line, 8), block.number(line, 9)),
                      block.at(line[0]))


def turn_about(center: Vector, a: Vector, b: Vector, normal: Vector, place: Place) -> Callable[[float], Vector]:
    """An arc from a to b; with a normal around it, else the shorter way."""
    first, last = subtract(a, center), subtract(b, center)
    sizes = math.hypot(*first), math.hypot(*last)
    axis = normalise(normal if any(normal) else cross(first, last))
    if min(sizes) <= 0 or not any(axis) or not math.isclose(*sizes, rel_tol=1e-3):
        raise BadInput(place, "this arc has no centre at one distance from both of its ends, or no normal: correct it")
    third = cross(axis, first)
    angle = math.degrees(math.atan2(sum(map(mul, last, third)), sum(map(mul, last, first)))) % 360
    tip: Vector = (center[0] + axis[0], center[1] + axis[1], center[2] + axis[2])
    return lambda share: rotate(a, center, tip, angle * share)


def between(a: Vector, b: Vector, share: float) -> Vector:
    return (a[0] + (b[0] - a[0]) * share, a[1] + (b[1] - a[1]) * share, a[2] + (b[2] - a[2]) * share)


def read_nfill(scope: Scope, block: Block) -> None:
    """Nodes between two sets: both sets, number of intervals, increment of the ids from line to line."""
    for line in block.lines:
        sides = [scope.node_sets.get(block.text(line, i).upper()) for i in (0, 1)]
        if sides[0] is None or sides[1] is None:
            raise BadInput(block.at(line[0]),
                           missing(f"node set '{clip(block.text(line, 0))}' or '{clip(block.text(line, 1))}'"))
        count, step = block.integer(line, 2, 1), block.integer(line, 3, 1)
        first, last = (sorted(set(side or [])) for side in sides)
        if len(first) != len(last) or not 1 <= count <= MOST_MEMBERS:
            raise BadInput(block.at(line[0]),
                           "the two sets of *NFILL differ in size, or there is no interval: correct it")
        for a, b in zip(first, last):
            ids = [a + step * i for i in range(1, count)]
            x, y = find_node(scope, block, line, a), find_node(scope, block, line, b)
            for i, id in enumerate(ids, 1):
                add_node(scope, block, id, between(x, y, i / count))
            add_set(scope.node_sets, block.option("NSET"), [a, *ids, b])


def read_ncopy(scope: Scope, block: Block) -> None:
    """A set of nodes moved, then turned about an axis."""
    raise_ids = block.integer((block.place.line, [block.options.get("CHANGE NUMBER", "")]), 0)
    old = scope.node_sets.get(block.option("OLD SET"))
    if old is None or "SHIFT" not in block.options:
        raise BadInput(block.place,
                       "*NCOPY has no set that is there, or no SHIFT (other copies are not read): write the nodes out")
    line = block.lines[0] if block.lines else (block.place.line, [])
    move = [block.number(line, i) for i in range(3)]
    turn = [block.number(block.lines[1], i) for i in range(7)] if len(block.lines) > 1 else []
    for id in old:
        x = find_node(scope, block, line, id)
        moved: Vector = (x[0] + move[0], x[1] + move[1], x[2] + move[2])
        if turn:
            moved = rotate(moved, (turn[0], turn[1], turn[2]), (turn[3], turn[4], turn[5]), turn[6])
        add_node(scope, block, id + raise_ids, moved)
    add_set(scope.node_sets, block.option("NEW SET"), [id + raise_ids for id in old])


def read_nmap(scope: Scope, block: Block) -> None:
    """Nodes that are in a set by now, moved along an axis by a length, or turned about it by an angle."""
    kind = block.option("TYPE")
    if kind not in ("TRANSLATION", "ROTATION"):
        raise BadInput(block.place,
                       f"*NMAP, TYPE={clip(kind)} (TRANSLATION or ROTATION is expected): write the nodes out")
    nodes = scope.node_sets.get(block.option("NSET"))
    if nodes is None:
        raise BadInput(block.place, missing(f"node set '{clip(block.option('NSET'))}'"))
    count = 2 if kind == "TRANSLATION" else 3
    if len(block.lines) < count:
        raise BadInput(block.place, f"*NMAP, TYPE={kind} has less than {count} lines: correct it")
    ends = [block.number(block.lines[0], i) for i in range(6)]
    axis = normalise((ends[3] - ends[0], ends[4] - ends[1], ends[5] - ends[2]))
    if not any(axis):
        raise BadInput(block.at(block.lines[0][0]), "the axis of *NMAP has no length: correct its two points")
    amount = block.number(block.lines[count - 1], 0)
    origin: Vector = (0.0, 0.0, 0.0)
    if kind == "ROTATION":
        origin = (block.number(block.lines[1], 0), block.number(block.lines[1], 1), block.number(block.lines[1], 2))
    tip: Vector = (origin[0] + axis[0], origin[1] + axis[1], origin[2] + axis[2])
    for id in dict.fromkeys(nodes):
        x = find_node(scope, block, block.lines[0], id)
        moved: Vector = (x[0] + amount * axis[0], x[1] + amount * axis[1], x[2] + amount * axis[2])
        scope.nodes[id] = rotate(x, origin, tip, amount) if kind == "ROTATION" else moved


def add_element(scope: Scope, block: Block, id: int, kind: str, corners: tuple[int, ...]) -> None:
    if not 1 <= id <= MOST_ID or len(scope.elements) >= MOST_MEMBERS:
        raise BadInput(block.place, f"*{block.keyword} makes element {id}, or too many of them: correct it")
    scope.elements[id] = (kind, corners)


def read_elgen(scope: Scope, block: Block) -> None:
    """Copies of an element in up to three directions: of each the number, the increment of nodes, that of elements."""
    for line in block.lines:
        master = block.id(line, 0)
        if master not in scope.elements:
            raise BadInput(block.at(line[0]), missing(f"element {master}"))
        kind, corners = scope.elements[master]
        counts = [max(block.integer(line, i, 1), 1) for i in (1, 4, 7)]
        nodes = [block.integer(line, i, default) for i, default in ((2, 1), (5, 0), (8, 0))]
        elements = [block.integer(line, i, default) for i, default in ((3, 1), (6, 0), (9, 0))]
        if math.prod(counts) > MOST_MEMBERS:
            raise BadInput(block.at(line[0]), f"*ELGEN makes more than {MOST_MEMBERS} elements: correct it")
        steps = [(i, j, k) for k in range(counts[2]) for j in range(counts[1]) for i in range(counts[0])]
        ids = []
        for step in steps:
            ids.append(master + sum(a * b for a, b in zip(step, elements)))
            shift = sum(a * b for a, b in zip(step, nodes))
            add_element(scope, block, ids[-1], kind, tuple(corner + shift for corner in corners))
        add_set(scope.element_sets, block.option("ELSET"), ids)


def read_elcopy(scope: Scope, block: Block) -> None:
    """A set of elements with other ids and nodes."""
    old = scope.element_sets.get(block.option("OLD SET"))
    if old is None or "REFLECT" in block.options:
        raise BadInput(block.place,
                       "*ELCOPY has no set that is there, or reflects (which is not read): write the elements out")
    raise_ids, raise_nodes = (block.integer((block.place.line, [block.options.get(name, "")]), 0)
                              for name in ("ELEMENT SHIFT", "SHIFT NODES"))
    for id in old:
        if id in scope.elements:
            kind, corners = scope.elements[id]
            add_element(scope, block, id + raise_ids, kind, tuple(corner + raise_nodes for corner in corners))
    add_set(scope.element_sets, block.option("NEW SET"), [id + raise_ids for id in old])


GENERATORS = {"SYSTEM": read_system, "NGEN": read_ngen, "NFILL": read_nfill, "NCOPY": read_ncopy, "NMAP": read_nmap,
              "ELGEN": read_elgen, "ELCOPY": read_elcopy}
