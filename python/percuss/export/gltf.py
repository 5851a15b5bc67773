"""glTF 2.0 (.glb): the surface of each part with its name, moving by morph targets, coloured by a field or by part."""

import json
from typing import Any

import numpy as np

from percuss.files import make_mark
from percuss.render.colors import MAPS, part_color, rgb
from percuss.render.skin import exterior_faces
from percuss.results.arrays import Array
from percuss.results.fields import Fields

from .selection import Selection

SECONDS = 5.0  # that the animation takes, whatever the time of the run
GAMMA = 2.2  # glTF takes linear colours
FLOAT, WHOLE = 5126, 5125  # component types of glTF


class _Buffer:
    def __init__(self) -> None:
        self.size, self.pieces = 0, list[bytes]()
        self.views, self.accessors = list[dict[str, Any]](), list[dict[str, Any]]()

    def add(self, values: Array, kind: str, bounds: bool = False) -> int:
        """The number of a new accessor."""
        values = np.ascontiguousarray(values, dtype="<u4" if kind == "INDEX" else "<f4")
        data = values.tobytes()
        self.views.append({"buffer": 0, "byteOffset": self.size, "byteLength": len(data)})
        accessor = {"bufferView": len(self.views) - 1, "componentType": WHOLE if kind == "INDEX" else FLOAT,
                    "count": len(values), "type": "SCALAR" if kind == "INDEX" else kind}
        if bounds:
            rows = values.reshape(len(values), -1)
            accessor["min"], accessor["max"] = rows.min(axis=0).tolist(), rows.max(axis=0).tolist()
        self.accessors.append(accessor)
        self.pieces.append(data)
        self.size += len(data)
        return len(self.accessors) - 1


def write_glb(selection: Selection, field: str | None = None) -> bytes:
    """Bytes of the file. field: the field shown as colour, in the last frame; None for a colour for each part. Only
    elements that are active in the last frame are shown. Lengths are in metres where the deck has units."""
    fields, frames = selection.fields, selection.frames
    scale = _find_scale(fields)
    positions = [fields.positions(frame) * scale for frame in frames]
    faces, owners = exterior_faces(fields.hexahedra, fields.alive(frames[-1]))
    colors = None if field is None else _color_nodes(fields, field, frames[-1])
    buffer, meshes, nodes = _Buffer(), [], []
    for part, name in enumerate(fields.part_names):
        corners = faces[fields.part[owners] == part]
        if not len(corners):
            continue
        used, places = np.unique(corners, return_inverse=True)
        places = places.reshape(-1, 4)
        triangles = np.concatenate([places[:, [0, 1, 2]], places[:, [0, 2, 3]][places[:, 2] != places[:, 3]]])
        primitive: dict[str, Any] = {"attributes": {"POSITION": buffer.add(positions[0][used], "VEC3", True)},
                     "indices": buffer.add(triangles.reshape(-1), "INDEX"), "material": 0 if field else part}
        if colors is not None:
            primitive["attributes"]["COLOR_0"] = buffer.add(colors[used], "VEC3")
        primitive["targets"] = [{"POSITION": buffer.add(moved[used] - positions[0][used], "VEC3", True)}
                                for moved in positions[1:]]
        weights: dict[str, Any] = {"weights": [0.0] * (len(frames) - 1)} if len(frames) > 1 else {}
        meshes.append({"name": name, "primitives": [primitive], **weights})
        nodes.append({"name": name, "mesh": len(meshes) - 1})
    return _pack(_describe(fields, field, frames, meshes, nodes, buffer), buffer)


def _find_scale(fields: Fields) -> float:
    from percuss.results.units import find_units

    units = find_units(fields.units)
    return units.length[1] if units else 1.0


def _color_nodes(fields: Fields, field: str, frame: int) -> Array:
    """[nodes][3] linear red, green, blue; of element fields the mean of the active elements around each node."""
    values = np.asarray(fields.values(field, frame), dtype=float)
    if fields.names()[field] == "element":
        alive = fields.alive(frame)
        corners = fields.hexahedra[alive]
        sums, counts = np.zeros(fields.nodes), np.zeros(fields.nodes)
        np.add.at(sums, corners, values[alive][:, None])
        np.add.at(counts, corners, 1)
        values = sums / np.maximum(counts, 1)
    low, high = np.nanmin(values), np.nanmax(values)
    share = np.nan_to_num((values - low) / (high - low if high > low else 1))
    stops = np.array([rgb(color) for color in MAPS["viridis"]]) ** GAMMA
    return np.column_stack([np.interp(share, np.linspace(0, 1, len(stops)), stop) for stop in stops.T])


def _describe(fields: Fields, field: str | None, frames: list[int], meshes: list[dict[str, Any]],
              nodes: list[dict[str, Any]], buffer: _Buffer) -> dict[str, Any]:
    shades = ([[1.0] * 3] if field
              else [[channel**GAMMA for channel in part_color(part)] for part in range(len(fields.part_names))])
    document = {"asset": {"version": "2.0", "generator": make_mark("export")}, "scene": 0,
                "scenes": [{"name": fields.title or "percuss", "nodes": list(range(len(nodes)))}], "nodes": nodes,
                "meshes": meshes, "materials":
                [{"doubleSided": True, "pbrMetallicRoughness": {"baseColorFactor": [*shade, 1.0], "metallicFactor": 0.1,
                                                                "roughnessFactor": 0.6}} for shade in shades]}
    if len(frames) > 1:
        times = buffer.add(np.linspace(0, SECONDS, len(frames)), "SCALAR", True)
        weights = buffer.add(np.eye(len(frames))[:, 1:].reshape(-1), "SCALAR")
        document["animations"] = [{"name": "motion",
                                   "samplers": [{"input": times, "output": weights, "interpolation": "LINEAR"}],
                                   "channels": [{"sampler": 0, "target": {"node": number, "path": "weights"}}
                                                for number in range(len(nodes))]}]
    document.update(accessors=buffer.accessors, bufferViews=buffer.views, buffers=[{"byteLength": buffer.size}])
    return document


def _pack(document: dict[str, Any], buffer: _Buffer) -> bytes:
    text = json.dumps(document, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    data = b"".join(buffer.pieces)
    data += b"\0" * (-len(data) % 4)
    words = [b"glTF", np.array([2, 12 + 8 + len(text) + 8 + len(data), len(text)], "<u4").tobytes(), b"JSON", text,
             np.array([len(data)], "<u4").tobytes(), b"BIN\0", data]
    return b"".join(words)
