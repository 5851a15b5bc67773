"""The surface over time for the interactive view: quantised, packed and compressed.
unpack.js reads it in the same order."""

from __future__ import annotations

import base64
import os
import zlib
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from percuss.render import colors
from percuss.render.skin import are_lines, exterior_faces
from percuss.results.arrays import Array
from percuss.results.fields import Fields
from percuss.results.units import format_time

from .arrows import MOST_ARROWS, describe_arrows
from .coarse import merge_nodes
from .shades import describe_field
from .walls import describe_walls

THREE = os.environ.get("PERCUSS_THREE", "/usr/share/javascript/three")  # Debian's libjs-three
LIBRARY = ("three.min.js", "examples/js/controls/OrbitControls.js")
VIEWER = ("unpack.js", "surface.js", "section.js", "walls.js", "painter.js", "tools.js", "viewer.js")
Packed = tuple[dict[str, Any], bytes]
STEPS = 65535  # of a coordinate over the box of the run
MOST_VOLUMES = 250_000  # hexahedra whose sections a browser finds while the plane is dragged


def read_library() -> list[str] | None:
    """The text of the library, or None where it is not installed."""
    try:
        texts = []
        for name in LIBRARY:
            with open(os.path.join(THREE, name), encoding="utf-8") as file:
                texts.append(file.read())
        return texts
    except OSError:
        return None


def read_text(name: str) -> str:
    """The text of a file beside this one."""
    with open(os.path.join(os.path.dirname(os.path.realpath(__file__)), name), encoding="utf-8") as file:
        return file.read()


def read_viewer() -> str:
    """The text of what shows a surface with the library."""
    return "(function () {\n'use strict';\n" + "\n".join(map(read_text, VIEWER)) + "})();\n"


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


def pack(fields: Fields, content: Content) -> Packed:
    """(description, compressed bytes)."""
    frames, shape = content.frames, Shape(fields, content)
    start = fields.positions(0)[shape.nodes]
    low, scale = _find_box(fields, frames, shape.nodes, start)
    about = {
        "nodes": len(shape.nodes), "faces": len(shape.corners), "elements": len(shape.elements),
        "volumes": len(shape.cells), "frames": len(frames), "low": low.tolist(), "scale": (scale / STEPS).tolist(),
        "erodes": shape.erodes, "parts": fields.part_names,
        "partColors": [colors.PART_COLORS[i % len(colors.PART_COLORS)] for i in range(len(fields.part_names))],
        "times": [format_time(fields.times[f], fields.times[-1], fields.time_unit) for f in frames], "numbers":
        [int(f) for f in frames], "fields": [], "arrows": [], "walls": describe_walls(fields, frames, low, scale),
    }
    pieces = [_difference(shape.corners, np.uint32), _difference(shape.owners, np.uint32),
              fields.part[shape.elements].astype(np.uint16), _difference(fields.element_ids[shape.elements], np.uint32),
              _difference(fields.node_ids[shape.nodes], np.uint32), _difference(shape.cells, np.uint32),
              _difference(shape.cell_owners, np.uint32),
              _find_changes(np.stack([np.round((_place(fields, frame, shape.nodes, start) - low) / scale * STEPS)
                                      .astype(np.uint16) for frame in frames]))]
    for name in content.names:
        described, shades = describe_field(fields, name, shape, content)
        about["fields"].append(described)
        pieces.append(_difference(shades, np.uint8))
    if shape.erodes:
        pieces += [_difference(shape.visible, np.uint8), _difference(shape.alive, np.uint8)]
    for name in content.vectors:
        described, vectors, nodes = describe_arrows(fields, name, shape, content)
        about["arrows"].append(described)
        pieces += [nodes.astype(np.uint32), vectors]
    return about, zlib.compress(b"".join(np.ascontiguousarray(piece).tobytes() for piece in pieces), 7)


def _place(fields: Fields, frame: int, nodes: Array, start: Array) -> Array:
    """Positions of nodes; those that have none stay where they started."""
    places = fields.positions(frame)[nodes]
    return np.where(np.isfinite(places), places, start)


def _find_box(fields: Fields, frames: Array, nodes: Array, start: Array) -> tuple[Array, Array]:
    """(lowest corner, size) of all frames."""
    if not len(nodes):
        return np.zeros(3), np.ones(3)
    ends = [(places.min(axis=0), places.max(axis=0))
            for places in (_place(fields, frame, nodes, start) for frame in frames)]
    low, high = np.min([end[0] for end in ends], axis=0), np.max([end[1] for end in ends], axis=0)
    return low, np.where(high > low, high - low, 1.0)


def encode(packed: Packed) -> tuple[dict[str, Any], str]:
    about, data = packed
    return about, base64.b64encode(data).decode("ascii")


def _difference(values: Any, kind: type[np.unsignedinteger[Any]]) -> Array:
    """Each row less the row before, in the arithmetic of the type: mostly small numbers, which compress well."""
    values = np.asarray(values).astype(kind)
    return np.concatenate([values[:1], values[1:] - values[:-1]])


def _find_changes(whole: Array) -> Array:
    """Bytes of the first frame and of the changes to each next one: all low bytes of a frame, then all high ones, which
    are mostly zeros."""
    flat = _difference(whole, np.uint16).reshape(len(whole), -1)
    return np.concatenate([(flat & 255).astype(np.uint8), (flat >> 8).astype(np.uint8)], axis=1)
