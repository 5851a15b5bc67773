"""What of the mesh is drawn: parts by name, and what lies behind a cut."""

import argparse

import numpy as np

from percuss.nearest import suggest
from percuss.results.arrays import Array
from percuss.results.fields import Fields

from .camera import directions

# nodes that are nearer to it, as a share of the size of the mesh, lie on it: no slivers are cut off
ON_THE_PLANE = 1e-6


Clip = tuple[str, int, float]  # side of the plane, axis, value
View = tuple[float, float]  # azimuth and elevation


class BadChoice(ValueError):
    """An argument does not fit the file; str() is a message for the user."""


def check_field(fields: Fields, name: str) -> None:
    """BadChoice with the nearest name where there is no such field."""
    known = fields.names()
    if name not in known:
        raise BadChoice(f"there is no field '{name}' in {fields.path}{suggest(name, known)} "
                        f"(it has {', '.join(sorted(known))})")


class Cut:
    """A plane through the mesh as it starts. Attributes: height [nodes], above the plane on the side that is taken
    away; keeps [elements], whether some of an element stays; parts [elements], whether it goes through an element."""

    def __init__(self, fields: Fields, clip: Clip, view: View) -> None:
        side, axis, value = clip
        self.removes_above = side == "+" if side else faces_camera(axis, view)
        start = fields.positions(0)
        height = start[:, axis] - value if self.removes_above else value - start[:, axis]
        height[np.abs(height) < ON_THE_PLANE * np.linalg.norm(np.ptp(start, axis=0))] = 0
        of_corners = height[fields.hexahedra]
        lowest, highest = of_corners.min(axis=1), of_corners.max(axis=1)
        self.height = height
        self.normal = np.eye(3)[axis] * (1 if self.removes_above else -1)
        self.start = start
        shells = fields.hexahedra[:, 0] == fields.hexahedra[:, 4]
        self.keeps = (lowest < 0) | (shells & (highest <= 0))
        self.parts = (lowest < 0) & (highest > 0)
        self.text = f"{'below' if self.removes_above else 'above'} {'xyz'[axis]} = {value:g}"


def choose_elements(fields: Fields, arguments: argparse.Namespace) -> tuple[Array, Cut | None]:
    """[elements] whether each is drawn, at least in part; and the cut, or None."""
    kept = choose_parts(fields, arguments.part)
    if arguments.clip is None:
        return kept, None
    cut = Cut(fields, arguments.clip, arguments.view)
    if not (kept & cut.keeps).any():
        raise BadChoice(f"nothing is left of the mesh {cut.text}")
    return kept & cut.keeps, cut


def choose_parts(fields: Fields, wanted: list[str] | None) -> Array:
    if not wanted:
        return np.ones(fields.elements, dtype=bool)
    names = [name for words in wanted for name in ([words] if words in fields.part_names else words.split(","))]
    unknown = [name for name in names if name not in fields.part_names]
    if unknown:
        raise BadChoice(f"there is no part '{unknown[0]}' in {fields.path}{suggest(unknown[0], fields.part_names)} "
                        f"(it has {', '.join(fields.part_names)})")
    return np.isin(fields.part, [fields.part_names.index(name) for name in names])


def faces_camera(axis: int, view: View) -> bool:
    """Whether the camera stands at the upper end of the axis;
    where it looks along the cut the upper end is taken away."""
    _, _, forward = directions(*view)
    return bool(forward[axis] < 1e-9)
