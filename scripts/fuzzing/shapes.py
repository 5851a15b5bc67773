"""Bodies of a random scene: shape, cells and hull. A hull is a set of points and a radius about them."""

import math

import numpy as np

SOLIDS = ("box", "cylinder", "tube", "sphere")
SHELLS = ("shell_plate", "shell_tube", "shell_sphere", "shell_box_tube")


def make_body(random, kind, size, edge):
    """A part of the deck without material and place. size: about its extent; edge: about that of its elements."""
    make = {"box": _make_box, "cylinder": _make_cylinder, "tube": _make_tube, "sphere": _make_sphere,
            "shell_plate": _make_plate, "shell_tube": _make_shell_tube, "shell_sphere": _make_shell_sphere,
            "shell_box_tube": _make_box_tube}[kind]
    part = make(random, size, edge)
    if kind in SHELLS:
        part["thickness"] = rounded(edge * random.uniform(0.05, 0.4))
    axis = [rounded(random.gauss(0, 1)) for _ in range(3)]
    if any(axis) and random.random() < 0.7:
        part["rotate"] = [{"axis": axis, "angle": rounded(random.uniform(0, 180))}]
    return part


def rounded(value, digits=3):
    """So that a deck reads well."""
    return float(f"{value:.{digits}g}")


def _cells(length, edge, least=1):
    return max(least, round(length / edge))


def _make_box(random, size, edge):
    sides = [rounded(size * random.uniform(0.25, 1)) for _ in range(3)]
    return {"box": {"size": sides, "cells": [_cells(side, edge) for side in sides]}}


def _make_cylinder(random, size, edge):
    radius, length = rounded(size * random.uniform(0.2, 0.5)), rounded(size * random.uniform(0.3, 1))
    return {"cylinder": {"radius": radius, "length": length,
                         "cells": [_cells(2 * radius, edge, 3), _cells(length, edge)]}}


def _make_tube(random, size, edge):
    outer = rounded(size * random.uniform(0.3, 0.5))
    inner, length = rounded(outer * random.uniform(0.5, 0.85)), rounded(size * random.uniform(0.3, 1))
    cells = [_cells(outer - inner, edge), _cells(2 * math.pi * outer, edge, 6), _cells(length, edge)]
    return {"tube": {"inner_radius": inner, "outer_radius": outer, "length": length, "cells": cells}}


def _make_sphere(random, size, edge):
    radius = rounded(size * random.uniform(0.25, 0.5))
    return {"sphere": {"radius": radius, "cells": _cells(2 * radius, edge, 4)}}


def _make_plate(random, size, edge):
    sides = [rounded(size * random.uniform(0.4, 1)) for _ in range(2)]
    return {"shell_plate": {"size": sides, "cells": [_cells(side, edge) for side in sides]}}


def _make_shell_tube(random, size, edge):
    radius, length = rounded(size * random.uniform(0.25, 0.5)), rounded(size * random.uniform(0.3, 1))
    return {"shell_tube": {"radius": radius, "length": length,
                           "cells": [_cells(2 * math.pi * radius, edge, 8), _cells(length, edge)]}}


def _make_shell_sphere(random, size, edge):
    radius = rounded(size * random.uniform(0.3, 0.5))
    return {"shell_sphere": {"radius": radius, "cells": _cells(1.57 * radius, edge, 2)}}


def _make_box_tube(random, size, edge):
    sides = [rounded(size * random.uniform(0.3, 0.7)) for _ in range(2)]
    length = rounded(size * random.uniform(0.3, 1))
    return {"shell_box_tube": {"size": sides, "length": length, "cells": [_cells(s, edge) for s in (*sides, length)],
                               "closed": random.choice(["none", "start", "both"])}}


def kind_of(part):
    return next(kind for kind in SOLIDS + SHELLS if kind in part)


def find_hull(part):
    """Points [n][3] and a radius: the hull of the part at its local origin, rotated; of an array that of all copies."""
    kind = kind_of(part)
    shape = part[kind]
    points, radius = _HULLS[kind](shape)
    if "array" in part:
        count, pitch = part["array"]["count"], part["array"]["pitch"]
        reach = [(count[k] - 1) * pitch[k] for k in range(3)]
        along = 1 if count[1] > 1 else 0
        if count[2] > 1:
            reach[along] += part["array"].get("stagger", 0) * pitch[along]
        ends = np.array([[reach[k] * (i >> k & 1) for k in range(3)] for i in range(8)])
        points = (points[:, None, :] + ends[None, :, :]).reshape(-1, 3)
    for turn in part.get("rotate", []):
        points = points @ _find_rotation(turn["axis"], turn["angle"]).T
    return points, radius + part.get("thickness", 0) / 2


def count_bodies(part):
    return int(np.prod(part["array"]["count"])) if "array" in part else 1


def count_elements(part):
    kind = kind_of(part)
    cells = part[kind]["cells"]
    counts = {"cylinder": lambda: cells[0] ** 2 * cells[1], "sphere": lambda: cells**3, "shell_sphere": lambda: 6
              * cells**2, "shell_box_tube": lambda: 2 * (cells[0] + cells[1]) * cells[2] + 2 * cells[0] * cells[1]}
    one = counts[kind]() if kind in counts else int(np.prod(cells))
    return one * count_bodies(part)


def find_shortest_edge(part):
    """About the shortest edge of an element, for the number of steps."""
    kind = kind_of(part)
    shape, cells = part[kind], part[kind]["cells"]
    if kind in ("box", "shell_plate"):
        return min(side / n for side, n in zip(shape["size"], cells))
    if kind == "cylinder":
        return min(1.1 * shape["radius"] / cells[0], shape["length"] / cells[1])
    if kind == "sphere":
        return 0.8 * shape["radius"] / cells
    if kind == "tube":
        wall = shape["outer_radius"] - shape["inner_radius"]
        return min(wall / cells[0], 2 * math.pi * shape["inner_radius"] / cells[1], shape["length"] / cells[2])
    if kind == "shell_tube":
        return min(2 * math.pi * shape["radius"] / cells[0], shape["length"] / cells[1])
    if kind == "shell_sphere":
        return shape["radius"] / cells
    return min(side / n for side, n in zip((*shape["size"], shape["length"]), cells))


def _box_points(low, high):
    return np.array([[(low, high)[i >> k & 1][k] for k in range(3)] for i in range(8)], dtype=float)


def _ring_points(radius, length):
    angle = np.linspace(0, 2 * math.pi, 48, endpoint=False)
    ring = np.column_stack([radius * np.cos(angle), radius * np.sin(angle), np.zeros(48)])
    return np.vstack([ring, ring + [0, 0, length]])


_POINT = np.zeros((1, 3))
_HULLS = {
    "box": lambda s: (_box_points((0, 0, 0), s["size"]), 0.0),
    "cylinder": lambda s: (_ring_points(s["radius"], s["length"]), 0.0),
    "tube": lambda s: (_ring_points(s["outer_radius"], s["length"]), 0.0),
    "sphere": lambda s: (_POINT, s["radius"]),
    "shell_plate": lambda s: (_box_points((0, 0, 0), (*s["size"], 0)), 0.0),
    "shell_tube": lambda s: (_ring_points(s["radius"], s["length"]), 0.0),
    "shell_sphere": lambda s: (_POINT, s["radius"]),
    "shell_box_tube": lambda s: (_box_points((-s["size"][0] / 2, -s["size"][1] / 2, 0),
                                             (s["size"][0] / 2, s["size"][1] / 2, s["length"])), 0.0),
}


def _find_rotation(axis, degrees):
    """Rodrigues."""
    u = np.array(axis, dtype=float) / np.linalg.norm(axis)
    k = np.array([[0, -u[2], u[1]], [u[2], 0, -u[0]], [-u[1], u[0], 0]])
    angle = math.radians(degrees)
    return np.eye(3) + math.sin(angle) * k + (1 - math.cos(angle)) * (k @ k)
