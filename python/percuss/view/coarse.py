"""A coarser surface: nodes within a cube of a grid become one (Rossignac and Borrel,
Multi-resolution 3D approximations, 1993)."""

import numpy as np

from percuss.results.arrays import Array


def merge_nodes(places: Array, side: float, corners: Array, owners: Array, parts: Array,
                visible: Array) -> tuple[Array, Array, Array]:
    """(corners, owners, visible) without faces that have lost their area, and each face once. side: of the cubes. Nodes
    stay where they are: that which is nearest to the middle of its cube's stands for them;
    those of different parts stay apart."""
    nodes = np.unique(corners)
    part = np.zeros(len(places), dtype=np.int64)
    part[corners.reshape(-1)] = np.repeat(parts[owners], 4)
    cubes = np.column_stack([part[nodes],
                             np.floor((places[nodes] - places[nodes].min(axis=0)) / side).astype(np.int64)])
    _, cube = np.unique(cubes, axis=0, return_inverse=True)
    cube = cube.reshape(-1)
    count = np.bincount(cube)
    middle = np.stack([np.bincount(cube, places[nodes, axis]) for axis in range(3)], axis=1) / count[:, None]
    away = np.linalg.norm(places[nodes] - middle[cube], axis=1)
    order = np.lexsort((nodes, away, cube))
    stands = nodes[order[np.r_[0, np.flatnonzero(np.diff(cube[order])) + 1]]]
    target = np.zeros(len(places), dtype=np.int64)
    target[nodes] = stands[cube]
    return _drop_flat_and_double(target[corners], owners, visible, corners[:, 1] == corners[:, 2])


def _drop_flat_and_double(corners: Array, owners: Array, visible: Array, beams: Array) -> tuple[Array, Array, Array]:
    """Beams keep both ends; a face that has two equal corners is a triangle, with its last corner twice."""
    a, b, c, d = corners.T
    flat = np.where(beams, a == b, (a == c) | (b == d) | ((a == b) & (c == d)) | ((b == c) & (a == d))
                    | ((a == b) & (b == c)) | ((c == d) & (d == a)))
    corners, owners, visible, beams = corners[~flat], owners[~flat], visible[:, ~flat], beams[~flat]
    same = (corners == np.roll(corners, -1, axis=1)) & ~beams[:, None]
    shift = np.where(same.any(axis=1), np.argmax(same, axis=1) - 2, 0)
    corners = np.take_along_axis(corners, (np.arange(4) + shift[:, None]) % 4, axis=1)
    _, first, group = np.unique(np.sort(corners, axis=1), axis=0, return_index=True, return_inverse=True)
    seen = np.zeros((len(visible), len(first)), dtype=np.uint8)
    for row, now in enumerate(visible):
        seen[row] = np.bincount(group.reshape(-1), now, len(first)) > 0
    order = np.argsort(first)
    return corners[first[order]], owners[first[order]], seen[:, order]
