"""What is drawn: beams as lines, outer faces of the elements, cut off at a plane,
and the sections of elements in that plane.

A point of a polygon is a node, or lies on the edge between two nodes: it moves with both, so that a cut stays in the
material.
"""


import numpy as np

from percuss.results.arrays import Array

from .selection import Cut

# Corners of the faces of a hexahedron, outward by the right-hand rule; the order of docs/output.md. And of its edges.
HEX_FACES = np.array([[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [0, 4, 7, 3], [0, 3, 2, 1], [4, 5, 6, 7]])
HEX_EDGES = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]


class Skin:
    """Attributes: ends [points][2], the nodes of each point's edge, twice the same for a node; share [points] of the
    second; corners, the points of line after line, then of polygon after polygon; offsets [lines and polygons + 1] into
    corners; owners [lines and polygons], elements; lines, how many there are."""

    def __init__(self, hexahedra: Array, drawn: Array, cut: Cut | None = None) -> None:
        faces, owners = exterior_faces(hexahedra, drawn)
        polygons = _Polygons()
        beams = np.flatnonzero(drawn & are_lines(hexahedra))
        if cut is not None:
            beams = beams[(cut.height[hexahedra[beams, :2]] <= 0).all(axis=1)]
        self.lines = len(beams)
        polygons.add_lines(hexahedra[beams, :2], beams)
        if cut is None:
            polygons.add_faces(faces, owners)
        else:
            _add_cut_faces(polygons, faces, owners, cut)
            _add_sections(polygons, hexahedra, np.flatnonzero(drawn & cut.parts), cut)
        self.ends, self.corners = np.unique(polygons.points(), axis=0, return_inverse=True)
        self.corners = self.corners.reshape(-1)
        self.offsets = np.concatenate(([0], np.cumsum(np.concatenate(polygons.sizes)))).astype(np.int64)
        self.owners = np.concatenate(polygons.owners)
        self.share = np.zeros(len(self.ends))
        on_edges = self.ends[:, 0] != self.ends[:, 1]
        if cut is not None and on_edges.any():
            first, second = cut.height[self.ends[on_edges]].T
            self.share[on_edges] = first / (first - second)

    def nodes(self) -> Array:
        return np.asarray(np.unique(self.ends))

    def at_points(self, values: Array) -> Array:
        """Values of nodes [nodes] or [nodes][n], at the points."""
        first, second = values[self.ends[:, 0]], values[self.ends[:, 1]]
        share = self.share if values.ndim == 1 else self.share[:, None]
        return np.asarray(first + share * (second - first))

    def highest_of_corners(self, values: Array) -> Array:
        """Values are whole numbers of nodes, between which there is nothing, the highest of each polygon's corners."""
        nearer = np.where(self.share < 0.5, self.ends[:, 0], self.ends[:, 1])
        if not len(self.owners):
            return np.empty(0)
        return np.maximum.reduceat(values[nearer][self.corners], self.offsets[:-1])


Ends = list[tuple[int, int]]  # the nodes of the edges of points


class _Polygons:
    def __init__(self) -> None:
        self.ends: list[Array] = []
        self.sizes, self.owners = [np.empty(0, int)], [np.empty(0, int)]

    def add_lines(self, lines: Array, owners: Array) -> None:
        """Lines [n][2] of nodes."""
        self.ends.append(np.repeat(lines.reshape(-1, 1), 2, axis=1))
        self.sizes.append(np.full(len(lines), 2))
        self.owners.append(owners)

    def add_faces(self, faces: Array, owners: Array) -> None:
        """Faces [n][4] of nodes; a triangle's last corner stands for a fourth."""
        stands = np.ones((len(faces), 4), dtype=bool)
        stands[:, 3] = faces[:, 3] != faces[:, 2]
        self.ends.append(np.repeat(faces[stands][:, None], 2, axis=1))
        self.sizes.append(stands.sum(axis=1))
        self.owners.append(owners)

    def add(self, ends: Ends, owner: int) -> None:
        self.ends.append(np.array(ends).reshape(-1, 2))
        self.sizes.append(np.array([len(ends)]))
        self.owners.append(np.array([owner]))

    def points(self) -> Array:
        return np.concatenate(self.ends) if self.ends else np.empty((0, 2), int)


def are_lines(hexahedra: Array) -> Array:
    """[elements] whether each is a beam: its second corner stands for all others."""
    return np.asarray((hexahedra[:, 1] == hexahedra[:, 2]) & (hexahedra[:, 0] == hexahedra[:, 4]))


def exterior_faces(hexahedra: Array, kept: Array) -> tuple[Array, Array]:
    """Faces that belong to one of the kept elements only, and shells: their corners [faces][4],
    their elements [faces]."""
    elements = np.flatnonzero(kept & ~are_lines(hexahedra))
    shells = elements[hexahedra[elements, 0] == hexahedra[elements, 4]]
    elements = elements[hexahedra[elements, 0] != hexahedra[elements, 4]]
    corners, owners = _close_triangles(hexahedra[elements][:, HEX_FACES].reshape(-1, 4), np.repeat(elements, 6))
    keys = np.where(corners[:, 3:] == corners[:, 2:3], corners * [1, 1, 1, 0] - [0, 0, 0, 1], corners)
    _, first, count = np.unique(np.sort(keys, axis=1), axis=0, return_index=True, return_counts=True)
    single = np.sort(first[count == 1])
    return np.concatenate([corners[single], hexahedra[shells][:, :4]]), np.concatenate([owners[single], shells])


def _close_triangles(faces: Array, owners: Array) -> tuple[Array, Array]:
    """Faces of hexahedra with collapsed edges: those without area left out, triangles with their last corner twice."""
    same = faces == np.roll(faces, -1, axis=1)
    left = same.sum(axis=1) < 2
    faces, owners, same = faces[left], owners[left], same[left]
    shift = np.where(same.any(axis=1), np.argmax(same, axis=1) - 2, 0)
    return np.take_along_axis(faces, (np.arange(4) + shift[:, None]) % 4, axis=1), owners


def _add_cut_faces(polygons: _Polygons, faces: Array, owners: Array, cut: Cut) -> None:
    height = cut.height[faces]
    in_plane = (height == 0).all(axis=1)
    whole = (height <= 0).all(axis=1) & ~(in_plane & cut.parts[owners])
    polygons.add_faces(faces[whole], owners[whole])
    for face in np.flatnonzero((height < 0).any(axis=1) & (height > 0).any(axis=1)):
        corners = faces[face] if faces[face, 3] != faces[face, 2] else faces[face, :3]
        ends = []
        for node, after in zip(corners, np.roll(corners, -1)):
            if cut.height[node] <= 0:
                ends.append((node, node))
            if cut.height[node] * cut.height[after] < 0:
                ends.append((min(node, after), max(node, after)))
        polygons.add(ends, owners[face])


def _add_sections(polygons: _Polygons, hexahedra: Array, elements: Array, cut: Cut) -> None:
    """The section of each hexahedron: its edges' points in the plane, in their order around its middle."""
    right = np.roll(cut.normal, 1)
    up = np.cross(cut.normal, right)
    for element in elements:
        corners = hexahedra[element]
        if corners[0] == corners[4]:
            continue  # a shell has none
        found = {(node, node) for node in corners if cut.height[node] == 0}
        found.update((min(a, b), max(a, b)) for a, b in ((corners[i], corners[j]) for i, j in HEX_EDGES)
                     if cut.height[a] * cut.height[b] < 0)
        ends = sorted(found)
        first, second = cut.start[np.array(ends)].transpose(1, 0, 2)
        heights = cut.height[np.array(ends)]
        share = heights[:, 0] / np.where(heights[:, 0] == heights[:, 1], 1, heights[:, 0] - heights[:, 1])
        places = first + share[:, None] * (second - first)
        places = places - places.mean(axis=0)
        order = np.argsort(np.arctan2(places @ up, places @ right))
        polygons.add([ends[i] for i in order], element)
