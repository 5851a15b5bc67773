"""What a view shows of a run: which faces are seen in some frame."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from percuss.render.skin import are_lines, exterior_faces
from percuss.results.arrays import Array
from percuss.results.fields import Fields

from .coarse import merge_nodes

MOST_ARROWS, FEWER_ARROWS = 1500, 300  # FEWER: where all does not fit


@dataclass
class Content:
    """What is packed. names: fields, the first of which is shown at first; vectors: fields of arrows; frames: their
    numbers; kept [elements]: which are shown; volumes: whether solids come whole, so that a cut shows their inside;
    merge: the length within which nodes become one (0: none); arrows: how many at most."""

    names: list[str]
    frames: Array
    kept: Array
    vectors: tuple[str, ...] = ()
    volumes: bool = False
    merge: float = 0.0
    arrows: int = MOST_ARROWS

    def but(self, **changes: Any) -> Content:
        return replace(self, **changes)


class Shape:
    """The faces that are seen in some frame: corners [faces][4] (nodes; of a triangle the last stands twice, of a beam
    both do), elements, owners [faces] (places in elements), visible [frames][faces];
    cells [volumes][8], their cell_owners, and alive [frames][volumes]."""

    def __init__(self, fields: Fields, content: Content) -> None:
        corners, owners, self.visible = _find_faces(fields, content)
        if content.merge:
            corners, owners, self.visible = merge_nodes(fields.positions(0), content.merge, corners, owners,
                                                        fields.part, self.visible)
        hexahedra = fields.hexahedra
        inside = (content.kept & ~are_lines(hexahedra) & (hexahedra[:, 0] != hexahedra[:, 4]) if content.volumes
                  else np.zeros(fields.elements, dtype=bool))
        solids = np.flatnonzero(inside)
        self.elements = np.unique(np.concatenate([owners, solids]))
        self.owners = np.searchsorted(self.elements, owners)
        self.cell_owners = np.searchsorted(self.elements, solids)
        self.nodes = np.unique(np.concatenate([corners.reshape(-1), hexahedra[solids].reshape(-1)]))
        self.corners = np.searchsorted(self.nodes, corners)
        self.cells = np.searchsorted(self.nodes, hexahedra[solids])
        self.alive = np.stack([fields.alive(frame)[solids] for frame in content.frames]).astype(np.uint8)
        self.erodes = bool((self.visible != self.visible[0]).any() or (self.alive != self.alive[0]).any())


def _find_faces(fields: Fields, content: Content) -> tuple[Array, Array, Array]:
    """Every face that is outside in some frame [faces][4], its element, and [frames][faces] whether it is seen then."""
    faces, owners, seen = list[list[int]](), list[int](), list[list[int]]()
    numbers: dict[tuple[int, ...], int] = {}
    last, now = None, list[int]()
    lines = are_lines(fields.hexahedra)
    for frame in content.frames:
        alive = fields.alive(frame) & content.kept
        if last is None or not np.array_equal(alive, last):
            last = alive
            found, elements = exterior_faces(fields.hexahedra, alive)
            beams = np.flatnonzero(alive & lines)
            found = np.concatenate([found, fields.hexahedra[beams][:, [0, 1, 1, 0]]])
            now = []
            for corners, element in zip(found.tolist(), np.concatenate([elements, beams]).tolist()):
                key = (*corners, element)
                if key not in numbers:
                    numbers[key] = len(faces)
                    faces.append(corners)
                    owners.append(element)
                now.append(numbers[key])
        seen.append(now)
    visible = np.zeros((len(content.frames), len(faces)), dtype=np.uint8)
    for row, now in enumerate(seen):
        visible[row, now] = 1
    return np.array(faces, dtype=np.int64).reshape(-1, 4), np.array(owners, dtype=int), visible
