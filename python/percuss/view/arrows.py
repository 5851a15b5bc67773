"""Vectors of the view: arrows at some nodes of the surface."""

from typing import Any

import numpy as np

from percuss.results.arrays import Array
from percuss.results.fields import Fields
from percuss.results.units import choose_unit

from .shape import Content, Shape

SMALL = 0.01  # of the longest one: nodes that never come to that get no arrow
STEPS = 32767


def list_vectors(fields: Fields) -> list[str]:
    """Names of the fields of nodes that have three components."""
    return [name for name, place in fields.names().items()
            if place == "node" and fields.data(name, 0).shape[1:] == (3,)]


def describe_arrows(fields: Fields, name: str, shape: Shape, content: Content) -> tuple[dict[str, Any], Array, Array]:
    """(description, [frames][arrows][3] of 16 bits, nodes [arrows] as places in those of the shape)."""
    values = np.stack([np.nan_to_num(fields.data(name, frame)[shape.nodes]) for frame in content.frames]).astype(float)
    size = np.linalg.norm(values, axis=2).max(axis=0)
    longest = float(size.max()) if size.size else 0.0
    used = np.flatnonzero(size > SMALL * longest) if longest > 0 else np.empty(0, int)
    nodes = _spread(fields.positions(0)[shape.nodes], used, content.arrows)
    unit, factor = choose_unit(fields.unit_of(name), longest)
    described = {"name": name, "title": name.replace("_", " "), "unit": unit, "longest": longest * factor,
                 "count": len(nodes), "of": len(used)}
    return described, np.round(values[:, nodes] / (longest or 1) * STEPS).astype(np.int16), nodes


def _spread(places: Array, used: Array, most: int) -> Array:
    """At most so many of these nodes, evenly over space: one of each cube of a grid."""
    if len(used) <= most:
        return used
    low, size = places[used].min(axis=0), np.ptp(places[used], axis=0)
    side = size.max() / 200
    while True:
        _, first = np.unique(np.floor((places[used] - low) / side).astype(np.int64), axis=0, return_index=True)
        if len(first) <= most:
            return np.asarray(used[np.sort(first)])
        side *= 1.1
