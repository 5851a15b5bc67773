"""A camera that goes with what moves."""

from collections.abc import Sequence

import numpy as np

from percuss.results.arrays import Array
from percuss.results.fields import Fields

from .selection import BadChoice, choose_parts

MOVING = 0.5  # share of the largest displacement: nodes that go as far are what moves


class Following:
    """The shift [3] of the camera at each frame, from the first one that is drawn."""

    def __init__(self, fields: Fields, wanted: str | None, nodes: Array, frames: Sequence[int]) -> None:
        """wanted: 'moving', names of parts, or None. nodes: those that are drawn."""
        self._fields, self._nodes = fields, None
        if wanted is None:
            return
        if wanted == "moving":
            way = np.linalg.norm(fields.positions(frames[-1])[nodes] - fields.positions(frames[0])[nodes], axis=1)
            way = np.where(np.isfinite(way), way, 0)
            self._nodes = nodes[way >= MOVING * way.max()]
        else:
            self._nodes = np.intersect1d(nodes, np.unique(fields.hexahedra[choose_parts(fields, [wanted])]))
            if not len(self._nodes):
                raise BadChoice(f"the part '{wanted}' that the camera is to follow is not drawn")
        self._start = self._find_middle(frames[0])

    def _find_middle(self, frame: int) -> Array:
        """The median: what flies off does not count."""
        return np.asarray(np.nanmedian(self._fields.positions(frame)[self._nodes], axis=0))

    def shift(self, frame: int) -> Array:
        return np.zeros(3) if self._nodes is None else self._find_middle(frame) - self._start

    @property
    def is_on(self) -> bool:
        return self._nodes is not None
