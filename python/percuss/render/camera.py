"""Where the camera stands: the whole scene over all frames in view, a few flying bits ignored."""

import math
from collections.abc import Callable, Sequence

import numpy as np

from percuss.results.arrays import Array
from percuss.results.fields import Fields

VIEW_ANGLE = 24.0  # degrees, vertical: like a short telephoto lens, which keeps shapes true


def directions(azimuth: float, elevation: float) -> tuple[Array, Array, Array]:
    """Unit vectors right, up and forward of a camera that looks at the scene from azimuth (from +x towards +y, about z)
    and elevation (above the xy plane), both in degrees; z is up in the picture."""
    a, e = math.radians(azimuth), math.radians(elevation)
    forward = -np.array([math.cos(e) * math.cos(a), math.cos(e) * math.sin(a), math.sin(e)])
    right = np.array([-math.sin(a), math.cos(a), 0.0])
    return right, np.cross(right, forward), forward


def sample_positions(fields: Fields, nodes: Array, frames: Sequence[int], limit: int = 400_000,
                     shift: Callable[[int], Array] | None = None) -> Array:
    """Positions of nodes over the frames, thinned evenly to about `limit`: [n][3], finite ones only. shift(frame) [3]:
    what is taken away, as a camera sees them that goes along."""
    stride = max(1, len(nodes) * len(frames) // limit)
    samples = np.concatenate([fields.positions(f)[nodes[f % stride :: stride]] - (0 if shift is None else shift(f))
                              for f in frames])
    return np.asarray(samples[np.isfinite(samples).all(axis=1)])


def place_camera(points: Array, azimuth: float, elevation: float, aspect: float,
                 margins: tuple[float, float, float, float],
                 look_at: Sequence[float] | None = None) -> tuple[Array, Array, Array]:
    """The position of the camera, the point it looks at, and its up direction.

    With look_at [3] the camera keeps its direction and its distance from the scene and has this point in the middle.
    points: what shall be in view [n][3]; half a per mille of them may stick out on each side. margins: shares of the
    picture to leave free at left, right, bottom, top. Each side of the view is a plane through the camera: for the one
    at the right p.right - t p.forward <= c.right - t c.forward for all points p;
    the two of an axis give its place and the distance.
    """
    right, up, forward = directions(azimuth, elevation)
    tangent = math.tan(math.radians(VIEW_ANGLE) / 2)
    depth = points @ forward
    found = []
    for axis, full, (before, after) in ((right, tangent * aspect, margins[:2]), (up, tangent, margins[2:])):
        along = points @ axis
        high_slope, low_slope = full * (1 - 2 * after), full * (1 - 2 * before)
        high = np.quantile(along - high_slope * depth, 0.9995)
        low = np.quantile(-along - low_slope * depth, 0.9995)
        found.append((high, low, high_slope, low_slope))
    nearest = min(-(high + low) / (hs + ls) for high, low, hs, ls in found)
    # The middle of what is left free when the other axis decides the distance.
    place = [(high + hs * nearest - low - ls * nearest) / 2 for high, low, hs, ls in found]
    middle = float(np.median(depth))
    if look_at is not None:
        target = np.asarray(look_at, dtype=float)
        return target - (middle - nearest) * forward, target, up
    position = place[0] * right + place[1] * up + nearest * forward
    return position, position + (middle - nearest) * forward, up


def narrow_view(zoom: float) -> float:
    """The vertical view angle in degrees in which things are `zoom` times as large as in VIEW_ANGLE."""
    return 2 * math.degrees(math.atan(math.tan(math.radians(VIEW_ANGLE) / 2) / zoom))
