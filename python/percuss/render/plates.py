"""Where rigid walls are drawn, as plates of four corners: a plane as one, as large as it is, or under and a little
around the bodies; a cylinder or a sphere as many."""

import numpy as np

from percuss.results.arrays import Array
from percuss.results.fields import Fields

from .mirrors import Planes, list_copies, reflect_once

Wall = tuple[Array, tuple[Array, Array] | None]  # plates; point and normal of a plane
Image = tuple[Array | None, tuple[Array, Array] | None]
MARGIN = 0.08  # of the plate around the bodies, as a share of the size of the scene
GAP = 5e-4     # by which the plate lies behind the wall, likewise: faces that lie on the wall are seen
AROUND = 96    # plates around a cylinder or a sphere
SAME = 1e-6    # share of the size of the scene: where the plates of two walls are alike


def span_walls(fields: Fields, frame: int, points: Array) -> list[Wall]:
    """[(plates [k][4][3], plane)] of all walls at the time of a frame.
    plane: its point and normal; None of a round wall."""
    return [(span_wall(*wall, points)[np.newaxis], wall[:2]) for wall in fields.walls_at(frame)] + [
        (span_round_wall(*wall, points), None) for wall in fields.round_walls_at(frame)]


def mirror_walls(walls: list[Wall], planes: Planes) -> list[Image]:
    """The walls of span_walls with their images in each mirrored copy of the scene; (None, None) for an image that lies
    where a wall is already, such as that of a floor. There are as many at each time."""
    images: list[Image] = list(walls)
    for chosen in list_copies(planes):
        for plates, plane in walls:
            image = reflect_once(plates, chosen)
            there = any(_are_alike(image, other) for other, _ in images if other is not None)
            images.append((None, None) if there
                          else (image, plane and (reflect_once(plane[0], chosen), _turn(plane[1], chosen))))
    return images


def _are_alike(one: Array, two: Array) -> bool:
    """Whether plates lie at the same places: they may begin at other corners."""
    one, two = (np.reshape(plates, (-1, 3)) for plates in (one, two))
    near = SAME * max(find_size(one), find_size(two))
    return bool(np.allclose(one.mean(axis=0), two.mean(axis=0), rtol=0, atol=near)
                and np.allclose(np.cov(one.T), np.cov(two.T), rtol=0, atol=near * find_size(two)))


def _turn(normal: Array, planes: Planes) -> Array:
    image = np.array(normal, dtype=float)
    image[[axis for axis, _ in planes]] *= -1
    return image


def span_wall(point: Array, normal: Array, edges: Array | None, points: Array) -> Array:
    """Four corners of a plate in the wall's plane: of its rectangle, or under all points [n][3],
    as seen along the normal."""
    size = find_size(points)
    if edges is not None:
        corner = point - GAP * size * normal
        return np.array([corner, corner + edges[0], corner + edges[0] + edges[1], corner + edges[1]])
    first, second = find_axes(normal)
    along, across = points @ first, points @ second
    a = along.min() - MARGIN * size, along.max() + MARGIN * size
    b = across.min() - MARGIN * size, across.max() + MARGIN * size
    height = point @ normal - GAP * size
    return np.array([height * normal + u * first + v * second for u, v in
                     ((a[0], b[0]), (a[1], b[0]), (a[1], b[1]), (a[0], b[1]))])


def span_round_wall(point: Array, axis: Array | None, radius: float, length: float | None, points: Array,
                    around: int = AROUND) -> Array:
    """Plates [k][4][3] around a cylinder, which are as long as it is or as the bodies beside it,
    or on a sphere (axis: None)."""
    size = find_size(points)
    pole = np.array([0.0, 0.0, 1.0]) if axis is None else axis
    first, second = find_axes(pole)
    turns = np.linspace(0, 2 * np.pi, around + 1)
    circle = np.cos(turns)[:, np.newaxis] * first + np.sin(turns)[:, np.newaxis] * second
    drawn = max(radius - GAP * size, 0.5 * radius)
    if axis is None:
        angles = np.linspace(0, np.pi, around // 2 + 1)
        rings = [point + drawn * (np.sin(angle) * circle + np.cos(angle) * pole) for angle in angles]
    else:
        along = (points - point) @ axis
        ends = (0, length) if length else (along.min() - MARGIN * size, along.max() + MARGIN * size)
        rings = [point + end * axis + drawn * circle for end in ends]
    return np.concatenate([np.stack([low[:-1], low[1:], high[1:], high[:-1]], axis=1)
                           for low, high in zip(rings, rings[1:])])


def find_size(points: Array) -> float:
    return float(np.linalg.norm(np.ptp(points, axis=0)))


def find_axes(normal: Array) -> tuple[Array, Array]:
    """Two unit vectors that are perpendicular to a unit vector and to each other."""
    first = np.eye(3)[np.argmin(np.abs(normal))]
    first = first - (first @ normal) * normal
    first /= np.linalg.norm(first)
    return first, np.cross(normal, first)
