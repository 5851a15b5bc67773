"""Largest values of columns that may have none that is finite."""

import numpy as np

from .arrays import Array


def find_top(values: Array) -> int:
    """The place of the largest finite value; 0 where there is none."""
    values = np.asarray(values, dtype=float)
    return int(np.argmax(np.where(np.isfinite(values), values, -np.inf)))


def find_size(values: Array) -> float:
    """The largest finite magnitude; 0 where there is none."""
    values = np.abs(np.asarray(values, dtype=float))
    return float(np.max(np.where(np.isfinite(values), values, 0), initial=0))
