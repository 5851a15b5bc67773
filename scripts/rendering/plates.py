"""Where rigid walls are drawn: each a plate in the plane of the wall, as large as it is, or under and a little around the bodies."""

import numpy as np

MARGIN = 0.08  # of the plate around the bodies, as a share of the size of the scene
GAP = 5e-4     # by which the plate lies behind the wall, likewise: faces that lie on the wall are seen


def span_wall(point, normal, edges, points):
    """Four corners of a plate in the wall's plane: of its rectangle, or under all points [n][3], as seen along the normal."""
    size = float(np.linalg.norm(np.ptp(points, axis=0)))
    if edges is not None:
        corner = point - GAP * size * normal
        return np.array([corner, corner + edges[0], corner + edges[0] + edges[1], corner + edges[1]])
    first = np.eye(3)[np.argmin(np.abs(normal))]
    first = first - (first @ normal) * normal
    first /= np.linalg.norm(first)
    second = np.cross(normal, first)
    along, across = points @ first, points @ second
    a = along.min() - MARGIN * size, along.max() + MARGIN * size
    b = across.min() - MARGIN * size, across.max() + MARGIN * size
    height = point @ normal - GAP * size
    return np.array([height * normal + u * first + v * second for u, v in
                     ((a[0], b[0]), (a[1], b[0]), (a[1], b[1]), (a[0], b[1]))])
