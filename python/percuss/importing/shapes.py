"""Geometry of elements: volumes, areas, faces."""

import math
from collections.abc import Iterable

from .model import Block, Deck, Model, Vector
from .solids import FACES, SEGMENTS


def make_vector(values: Iterable[float]) -> Vector:
    x, y, z = values
    return x, y, z


def subtract(a: Vector, b: Vector) -> Vector:
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def cross(a: Vector, b: Vector) -> Vector:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a: Vector, b: Vector) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def normalise(a: Vector) -> Vector:
    length = dot(a, a) ** 0.5
    return (a[0] / length, a[1] / length, a[2] / length) if length > 0 else (0.0, 0.0, 0.0)


def mean(points: list[Vector]) -> Vector:
    n = len(points)
    return (sum(p[0] for p in points) / n, sum(p[1] for p in points) / n, sum(p[2] for p in points) / n)


def tet_volume(a: Vector, b: Vector, c: Vector, d: Vector) -> float:
    return dot(subtract(b, a), cross(subtract(c, a), subtract(d, a))) / 6


def solid_volume(x: list[Vector]) -> float:
    """Volume of a solid with bilinear or flat faces: the mean of the two ways to cut each face into triangles."""
    center, volume = mean(x), 0.0
    for face in FACES[len(x)]:
        p, q, r, s = (x[i] for i in (*face, face[-1])[:4])
        volume += (tet_volume(center, p, q, r) + tet_volume(center, p, r, s) + tet_volume(center, p, q, s)
                   + tet_volume(center, q, r, s))
    return abs(0.5 * volume)


def shell_area(x: list[Vector]) -> float:
    """Half the cross product of the diagonals, or of two edges."""
    normal = (cross(subtract(x[2], x[0]), subtract(x[3], x[1])) if len(x) == 4
              else cross(subtract(x[1], x[0]), subtract(x[2], x[0])))
    return float(0.5 * dot(normal, normal) ** 0.5)


def section_area(section: Deck) -> float:
    """Area of a section as the deck gives it."""
    for kind, keys in section.items():
        if kind == "round":
            return float(math.pi * keys["radius"] ** 2)
        if kind == "tube":
            return float(math.pi * (keys["outer_radius"] ** 2 - keys["inner_radius"] ** 2))
        if kind == "rectangle":
            return float(keys["size"][0] * keys["size"][1])
        if kind == "box":
            (y, z), wall = keys["size"], keys["wall"]
            return float(y * z - (y - 2 * wall) * (z - 2 * wall))
        if kind == "i_shape":
            (y, z), flange, web = keys["size"], keys["flange"], keys["web"]
            return float(2 * y * flange + web * (z - 2 * flange))
        return float(keys["area"])
    return 0.0


def measure_block(model: Model, block: Block) -> tuple[float, Vector]:
    """Mass, and mass times centre."""
    mass, moment = 0.0, [0.0, 0.0, 0.0]
    for is_shell, elements in ((False, block.solids), (True, block.shells)):
        for id, corners in elements:
            x = [model.nodes[node] for node in corners]
            if is_shell:
                volume = shell_area(x) * block.thicknesses.get(id, block.thickness or 0.0)
            else:
                volume = solid_volume(x)
            center = mean(x)
            mass += volume * block.density
            for d in range(3):
                moment[d] += volume * block.density * center[d]
    area = section_area(block.keys.get("section", {}))
    for _, corners in block.beams:
        a, b = (model.nodes[node] for node in corners)
        weight = dot(subtract(b, a), subtract(b, a)) ** 0.5 * area * block.density
        mass += weight
        for d in range(3):
            moment[d] += 0.5 * weight * (a[d] + b[d])
    return mass, (moment[0], moment[1], moment[2])


def is_crossed(x: list[Vector]) -> bool:
    """Whether the edges of a quadrilateral cross: its corners are not in order around it."""
    if len(x) != 4:
        return False
    first = cross(subtract(x[1], x[0]), subtract(x[2], x[0]))
    return (dot(first, cross(subtract(x[2], x[1]), subtract(x[3], x[1]))) < 0
            and dot(first, cross(subtract(x[3], x[2]), subtract(x[0], x[2]))) < 0)


class FaceOwners:
    """The element that a face of some nodes belongs to, to know which way its nodes run."""

    def __init__(self, model: Model, nodes: set[int]):
        self._model = model
        self._solids: dict[frozenset[int], tuple[int, ...]] = {}
        self._shells: set[frozenset[int]] = set()
        for block in model.blocks:
            for _, corners in block.solids:
                if nodes.isdisjoint(corners):
                    continue
                for face in SEGMENTS[len(corners)]:
                    self._solids[frozenset(corners[i] for i in face)] = corners
            self._shells.update(frozenset(corners) for _, corners in block.shells if nodes.issuperset(corners))

    def find_sign(self, face: tuple[int, ...]) -> float | None:
        """1 if a pressure against the normal of the nodes pushes into the body, -1 if out of it,
        None without an element."""
        key = frozenset(face)
        if key in self._shells:
            return 1.0
        corners = self._solids.get(key)
        if corners is None:
            return None
        x = [self._model.nodes[node] for node in face]
        normal = cross(subtract(x[-2], x[-3]), subtract(x[-1], x[-3]))
        outward = subtract(mean(x), mean([self._model.nodes[node] for node in corners]))
        return 1.0 if dot(normal, outward) >= 0 else -1.0
