"""Reads fields.vtkhdf: the mesh once, then frame after frame."""

from __future__ import annotations

import functools
import os
import re
from collections.abc import Callable
from typing import Any, TypeVar

import h5py
import numpy as np

from ..errors import NoFrames, NotResults
from .arrays import Array

T = TypeVar("T")

# What h5py raises at a damaged file, here or in a later call.
_DAMAGE = (OSError, KeyError, ValueError, RuntimeError, TypeError, IndexError, AttributeError, OverflowError,
           MemoryError)


def _reads(method: Callable[..., T]) -> Callable[..., T]:
    """What a damaged file raises becomes NotResults."""

    @functools.wraps(method)
    def read(self: Any, *arguments: Any) -> T:
        try:
            return method(self, *arguments)
        except _DAMAGE as error:
            raise NotResults(f"{self.path}: this is no fields file of percuss, or it is damaged ({error})") from error

    return read


# Files of the entries of output.field_outputs: fields_NAME.vtkhdf.
_NAMED = re.compile(r"fields_([A-Za-z0-9_-]+)\.vtkhdf")


def list_outputs(folder: str) -> list[str]:
    """Names of the field outputs that a folder has files of, ascending."""
    try:
        found = [_NAMED.fullmatch(file) for file in os.listdir(folder)]
    except OSError:
        return []
    return sorted(match[1] for match in found if match)


class Fields:
    """One fields.vtkhdf, of a run that has ended or goes on; with a name fields_NAME.vtkhdf, that of an entry of
    output.field_outputs. Frames are numbered from 0; -1 is the last.

    Attributes: times [frames], steps [frames], time_unit, title, units (the deck's text), part_names, walls [walls][6]
    (a point and the unit normal of each that does not move), part [elements], element_ids, node_ids, nodes and elements
    (counts), kinds [elements] (VTK's types of cells), hexahedra [elements][8]. Wedges, pyramids and tetrahedra stand
    there as hexahedra with collapsed edges. The four corners of a shell stand twice, so that its faces 4 and 5 are its
    two surfaces. Of a beam the second node stands for the others too."""

    def __init__(self, folder: str | os.PathLike[str], name: str | None = None) -> None:
        stem = f"fields_{name}" if name else "fields"
        self.path = os.path.join(folder, f"{stem}.vtkhdf") if os.path.isdir(folder) else os.fspath(folder)
        if not os.path.exists(self.path):
            beside, key = os.path.dirname(self.path), f"output.field_outputs.{name}" if name else "output.fields"
            if os.path.exists(os.path.join(beside, f"{stem}.exo")):
                raise NotResults(f"{self.path}: there is no such file (the run wrote {stem}.exo, which ParaView opens; "
                                 f"with {key}.format: [vtkhdf, exodus] it writes both)")
            there = [other for other in list_outputs(beside) if other != name]
            others = f"; there are field outputs {', '.join(there)}: choose one by its name" if there else ""
            raise NotResults(f"{self.path}: there is no such file (a run writes it where its deck has {key}{others})")
        if not os.path.isfile(self.path):
            raise NotResults(f"{self.path}: this is no regular file")
        try:
            # A run that goes on may be looked at: percuss takes no lock, and none is needed here.
            os.environ.setdefault("HDF5_USE_FILE_LOCKING", "FALSE")
            self.file = h5py.File(self.path, "r")
        except OSError as error:
            raise NotResults(f"{self.path}: this is no fields file of percuss ({error})") from error
        self._read_mesh()
        if not len(self.times):
            raise NoFrames(f"{self.path}: there is no frame in it (the run ended before its first output)")

    @_reads
    def _read_mesh(self) -> None:
        root, own = self.file["VTKHDF"], self.file["percuss"]
        self.root = root
        count = int(root["Steps"].attrs["NSteps"])
        self.times = root["Steps/Values"][:count]
        self.steps = own["step"][:count] if "step" in own else np.arange(count)
        self.nodes = int(root["NumberOfPoints"][0])
        self.elements = int(root["NumberOfCells"][0])
        self.kinds = root["Types"][: self.elements]
        self.hexahedra = _pad_cells(root["Connectivity"][:], root["Offsets"][: self.elements], self.kinds)
        self.part = root["CellData/part"][: self.elements]
        self.part_names = [_text(name) for name in own["part_names"][:]]
        self.title = _text(own.attrs["title"])
        self.units = _text(own.attrs.get("units", ""))
        self.time_unit = _text(root["Steps/Values"].attrs.get("unit", ""))  # files of older versions have none
        self.walls = own["walls"][:] if "walls" in own else np.empty((0, 6))
        self._wall_edges = own["wall_edges"][:] if "wall_edges" in own else np.zeros((len(self.walls), 6))
        self._moving = own["moving_walls"][:] if "moving_walls" in own else np.empty((0, 6))
        self._moving_edges = (own["moving_wall_edges"][:] if "moving_wall_edges" in own
                              else np.zeros((len(self._moving), 6)))
        self._round, self._moving_round = (own[name][:] if name in own else np.empty((0, 11))
                                           for name in ("round_walls", "moving_round_walls"))
        self._wall_displacements = (own["wall_displacements"][:count] if "wall_displacements" in own
                                    else np.empty((count, 0)))
        self._check_mesh()

    def _check_mesh(self) -> None:
        """What later calls rely on."""
        if (self.hexahedra.shape != (self.elements, 8)
                or (self.hexahedra.size and not 0 <= self.hexahedra.min() <= self.hexahedra.max() < self.nodes)):
            raise ValueError("elements have nodes that are not there")
        if (len(self.part) != self.elements
                or (self.elements and not 0 <= self.part.min() <= self.part.max() < len(self.part_names))):
            raise ValueError("elements are of parts that are not there")
        if not len(self.times) == len(self.steps) == len(self._wall_displacements) or not np.isfinite(self.times).all():
            raise ValueError("frames without a time or a step")

    @_reads
    def walls_at(self, frame: int) -> list[tuple[Array, Array, Array | None]]:
        """[(point, normal, edges)] of all rigid planes at the time of a frame, those that move last. edges: two vectors
        from the point, which is a corner then; None of a wall that does not end."""
        planes, edges = (np.concatenate([self.walls, self._moving]),
                         np.concatenate([self._wall_edges, self._moving_edges]))
        moved = np.concatenate([np.zeros(len(self.walls)), self._wall_displacements[frame][: len(self._moving)]])
        return [(plane[:3] + by * plane[3:], plane[3:], vectors.reshape(2, 3) if vectors.any() else None)
                for plane, vectors, by in zip(planes, edges, moved)]

    @_reads
    def round_walls_at(self, frame: int) -> list[tuple[Array, Array | None, float, float | None]]:
        """[(point, axis, radius, length)] of all rigid cylinders and spheres at the time of a frame, those that move
        last. The point is an end of the axis, or the centre. axis: a unit vector; None of a sphere.
        length: None of a cylinder without ends."""
        moved = np.concatenate([np.zeros(len(self._round)), self._wall_displacements[frame][len(self._moving) :]])
        return [(wall[:3] + by * wall[8:], wall[3:6] if wall[3:6].any() else None, wall[6], wall[7] or None)
                for wall, by in zip(np.concatenate([self._round, self._moving_round]), moved)]

    @property
    @_reads
    def element_ids(self) -> Array:
        return _expect(self.root["CellData/element_id"][: self.elements], self.elements)

    @property
    @_reads
    def node_ids(self) -> Array:
        return _expect(self.root["PointData/node_id"][: self.nodes], self.nodes)

    @_reads
    def cells(self) -> list[Array]:
        """Corners of each element, an array each, in VTK's order: eight, six of a wedge, five of a pyramid, four of a
        tetrahedron or a shell, three of a triangle, two of a beam. Indexes of nodes from 0."""
        corners, offsets = self.root["Connectivity"][:], self.root["Offsets"][:]
        return np.split(corners, offsets[1:-1])

    @_reads
    def names(self) -> dict[str, str]:
        """Names of the fields that a surface can be coloured by, with the place (node or element) of each."""
        steps = self.root["Steps"]
        fixed = {"node_id", "element_id"}
        found = {name: "node" for name in steps["PointDataOffsets"] if name not in fixed}
        found.update({name: "element" for name in steps["CellDataOffsets"] if name not in fixed})
        return found

    @_reads
    def unit_of(self, name: str) -> str:
        """The unit of a field as the file has it; empty if it has none, or the deck's units have no known names."""
        group = "PointData" if self.names()[name] == "node" else "CellData"
        return _text(self.root[f"{group}/{name}"].attrs.get("unit", ""))

    def positions(self, frame: int) -> Array:
        """[nodes][3]"""
        return self._rows("Points", "PointOffsets", frame, self.nodes)

    def data(self, name: str, frame: int) -> Array:
        """A field as the file has it: [n] or [n][components], n nodes or elements."""
        if name not in self.names():
            raise KeyError(f"there is no field '{name}' in {self.path} (it has {', '.join(sorted(self.names()))})")
        group, items = ("PointData", self.nodes) if self.names()[name] == "node" else ("CellData", self.elements)
        return self._rows(f"{group}/{name}", f"{group}Offsets/{name}", frame, items)

    def values(self, name: str, frame: int) -> Array:
        """A field as one number an item: the magnitude of a vector, von Mises' value of a stress."""
        return to_scalar(self.data(name, frame))

    @_reads
    def _rows(self, dataset: str, offsets: str, frame: int, items: int) -> Array:
        first = int(self.root[f"Steps/{offsets}"][range(len(self.times))[frame]])
        values: Array = self.root[dataset][first : first + items]
        if len(values) != items or values.dtype.kind not in "fiu":
            raise ValueError(f"{dataset} has {len(values)} numbers of a frame, not {items}")
        return values

    def alive(self, frame: int) -> Array:
        """[elements] whether each has not died; all of a run without the field."""
        if "alive" not in self.names():
            return np.ones(self.elements, dtype=bool)
        alive: Array = self.values("alive", frame) > 0
        return alive


def _expect(values: Array, count: int) -> Array:
    if len(values) != count:
        raise ValueError(f"{len(values)} ids of {count}")
    return values


def _text(value: object) -> str:
    return value.decode("utf-8", "replace") if isinstance(value, bytes) else str(value)


# Eight corners of each of VTK's cells, by its type: lines, triangles, quadrilaterals, tetrahedra,
# hexahedra, wedges, pyramids.
_EIGHT = {3: (0, 1, 1, 1, 0, 1, 1, 1), 5: (0, 1, 2, 2, 0, 1, 2, 2), 9: (0, 1, 2, 3, 0, 1, 2, 3),
          10: (0, 1, 2, 2, 3, 3, 3, 3), 12: (0, 1, 2, 3, 4, 5, 6, 7), 13: (0, 2, 1, 1, 3, 5, 4, 4),
          14: (0, 1, 2, 3, 4, 4, 4, 4)}  # fmt: skip


def _pad_cells(connectivity: Array, first: Array, types: Array) -> Array:
    places = np.zeros((256, 8), dtype=np.int64)
    for kind, corners in _EIGHT.items():
        places[kind] = corners
    padded: Array = connectivity[first[:, None] + places[types]]
    return padded


def to_scalar(values: Any) -> Array:
    """values: [n], [n][3] or [n][6] (xx, yy, zz, xy, yz, zx)."""
    array: Array = np.asarray(values, dtype=float)
    if array.ndim == 1:
        return array
    if array.shape[1] == 3:
        return np.asarray(np.linalg.norm(array, axis=1))
    xx, yy, zz, xy, yz, zx = array.T
    return np.asarray(np.sqrt(0.5 * ((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) + 3 * (xy**2 + yz**2 + zx**2)))
