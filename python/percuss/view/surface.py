"""The surface over time for the interactive view: quantised, packed and compressed.
unpack.js reads it in the same order."""

import base64
import os
import zlib
from typing import Any

import numpy as np

from percuss.render import colors
from percuss.results.arrays import Array
from percuss.results.fields import Fields
from percuss.results.units import format_time

from .arrows import describe_arrows
from .shades import describe_field
from .shape import Content, Shape
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
