"""What a frame shows, measured from the positions of the corners alone: inverted corners and depth of penetration."""

import numpy as np

# Neighbours of each corner of a hexahedron along xi, eta and zeta, in an order that makes a right-handed corner.
_CORNERS = np.array([[0, 1, 3, 4], [1, 2, 0, 5], [2, 3, 1, 6], [3, 0, 2, 7], [4, 7, 5, 0], [5, 4, 6, 1], [6, 5, 7, 2],
                     [7, 6, 4, 3]])
_FACES = np.array([[0, 4, 7, 3], [1, 2, 6, 5], [0, 1, 5, 4], [3, 7, 6, 2], [0, 3, 2, 1], [4, 5, 6, 7]])  # outward
SHARP = np.cos(np.radians(30))  # faces that meet at a larger angle have an edge that contact knows


def find_corner_jacobians(x, hexahedra):
    """[n][8] det of the three edges at each corner."""
    at = x[hexahedra]
    first, *others = (at[:, _CORNERS[:, k]] for k in range(4))
    a, b, c = (other - first for other in others)
    return np.einsum("eki,eki->ek", a, np.cross(b, c))


class Surface:
    """The exterior of one body: nodes, faces (a triangle fan each), sharp edges;
    of shells with half their thickness."""

    def __init__(self, x0, cells, half_thickness):
        """cells: corners of each element of the body, all of one kind."""
        self.half_thickness = half_thickness
        self.is_shell = half_thickness > 0
        faces = cells if self.is_shell else _find_exterior_faces(cells)
        self.faces = faces
        self.nodes = np.unique(faces)
        edges, sharp = _find_edges(x0, faces)
        self.edges = edges[sharp]
        lengths = np.linalg.norm(x0[edges[:, 0]] - x0[edges[:, 1]], axis=1)
        self.edge_length = lengths[lengths > 0].min()

    def triangles(self, x):
        """[n][3][3] four for each face, about the mean of its corners."""
        at = x[self.faces]
        middle = at.mean(axis=1)
        fans = [np.stack([at[:, i], at[:, (i + 1) % 4], middle], axis=1) for i in range(4)]
        return np.concatenate(fans)

    def edge_samples(self, x, count=5):
        a, b = x[self.edges[:, 0]], x[self.edges[:, 1]]
        shares = np.arange(1, count + 1) / (count + 1)
        return (a[None] + shares[:, None, None] * (b - a)[None]).reshape(-1, 3)


def _find_exterior_faces(cells):
    faces = cells[:, _FACES].reshape(-1, 4)
    _, inverse, counts = np.unique(np.sort(faces, axis=1), axis=0, return_inverse=True, return_counts=True)
    return faces[counts[inverse.ravel()] == 1]


def _find_edges(x, faces):
    """Edges [n][2] and whether the faces beside each meet at an angle, or there is only one."""
    at = x[faces]
    normals = np.cross(at[:, 2] - at[:, 0], at[:, 3] - at[:, 1])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
    pairs = np.concatenate([faces[:, [i, (i + 1) % 4]] for i in range(4)])
    owners = np.tile(np.arange(len(faces)), 4)
    edges, inverse = np.unique(np.sort(pairs, axis=1), axis=0, return_inverse=True)
    inverse = inverse.ravel()
    sums = np.zeros((len(edges), 3))
    np.add.at(sums, inverse, normals[owners])
    squares, counts = (sums**2).sum(axis=1), np.bincount(inverse)
    sharp = (counts != 2) | (squares / 2 - 1 < SHARP)  # |n1 + n2|^2 = 2 + 2 cos
    return edges, sharp


def find_depths(points, surface, x, extra=0.0):
    """How deep each point lies in a body, 0 outside: its distance from the closest point of the surface; of shells what
    is missing of half the thickness and `extra`."""
    triangles = surface.triangles(x)
    reach = surface.half_thickness + extra
    low, high = triangles.min(axis=(0, 1)) - reach, triangles.max(axis=(0, 1)) + reach
    depths = np.zeros(len(points))
    near = np.flatnonzero(((points > low) & (points < high)).all(axis=1))
    for some in np.array_split(near, max(1, len(near) * len(triangles) // 200000)):
        if not len(some):
            continue
        at = points[some]
        if surface.is_shell:
            depths[some] = np.maximum(reach - find_distances(at, triangles), 0)
            continue
        inside = _find_winding(at, triangles) > 0.5
        if extra > 0:
            distance = find_distances(at, triangles)
            depths[some] = np.where(inside, extra + distance, np.maximum(extra - distance, 0))
        elif inside.any():
            depths[some[inside]] = find_distances(at[inside], triangles)
    return depths


def _find_winding(points, triangles):
    """How often the surface goes around each point (van Oosterom and Strackee 1983)."""
    a, b, c = (triangles[None, :, k] - points[:, None] for k in range(3))
    la, lb, lc = (np.linalg.norm(v, axis=2) for v in (a, b, c))
    top = np.einsum("pti,pti->pt", a, np.cross(b, c))
    dot = lambda u, v: np.einsum("pti,pti->pt", u, v)  # noqa: E731
    bottom = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb
    return np.arctan2(top, bottom).sum(axis=1) / (2 * np.pi)


def find_distances(points, triangles):
    """The distance of each point from the closest triangle: from its plane where the foot lies within, else from its edges."""
    a, b, c = (triangles[:, k] for k in range(3))
    best = np.full(len(points), np.inf)
    for p, q in ((a, b), (b, c), (c, a)):
        along = q - p
        length = np.maximum((along**2).sum(axis=1), 1e-300)
        rel = points[:, None] - p[None]
        share = np.clip(np.einsum("pti,ti->pt", rel, along) / length, 0, 1)
        best = np.minimum(best, np.linalg.norm(rel - share[..., None] * along, axis=2).min(axis=1))
    normal = np.cross(b - a, c - a)
    size = np.maximum(np.linalg.norm(normal, axis=1), 1e-300)
    normal = normal / size[:, None]
    height = np.einsum("pti,ti->pt", points[:, None] - a[None], normal)
    inside = np.ones(height.shape, dtype=bool)
    for p, q in ((a, b), (b, c), (c, a)):
        inside &= np.einsum("pti,ti->pt", points[:, None] - p[None], np.cross(normal, q - p)) >= 0
    return np.minimum(best, np.where(inside & (size > 1e-200), abs(height), np.inf).min(axis=1))


def find_crossings(points_a, points_b, surface, x):
    """[n] whether the segment from a to b goes through the surface (Moeller and Trumbore 1997)."""
    triangles = surface.triangles(x)
    start, way = points_a[:, None], (points_b - points_a)[:, None]
    e1, e2 = triangles[None, :, 1] - triangles[None, :, 0], triangles[None, :, 2] - triangles[None, :, 0]
    h = np.cross(way, e2)
    det = (e1 * h).sum(axis=2)
    with np.errstate(divide="ignore", invalid="ignore"):
        s = start - triangles[None, :, 0]
        u = (s * h).sum(axis=2) / det
        q = np.cross(s, np.broadcast_to(e1, s.shape))
        v = (way * q).sum(axis=2) / det
        t = (e2 * q).sum(axis=2) / det
        return ((u >= 0) & (v >= 0) & (u + v <= 1) & (t > 0) & (t < 1)).any(axis=1)
