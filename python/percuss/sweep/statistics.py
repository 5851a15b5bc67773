"""How outputs depend on inputs: correlation and main effects."""

from collections.abc import Sequence

import numpy as np

from percuss.results.arrays import Array

MOST_LEVELS = 8  # of an input whose designs are grouped by its values; others by equal counts
GROUPS, FEWEST_IN_GROUP = 5, 2


def place_inputs(texts: Sequence[str]) -> tuple[Array, list[str] | None]:
    """(numbers [designs], labels): labels None of numbers, else the words whose places the numbers are."""
    try:
        numbers = np.array([float(text) for text in texts])
        if np.isfinite(numbers).all():
            return numbers, None
    except ValueError:
        pass
    words = list(dict.fromkeys(texts))
    return np.array([float(words.index(text)) for text in texts]), words


def correlate(x: Array, y: Array) -> float:
    """Pearson's coefficient; NaN of what does not vary."""
    x, y = x - np.mean(x), y - np.mean(y)
    size = np.sqrt(np.sum(x * x) * np.sum(y * y))
    return float(np.sum(x * y) / size) if len(x) > 1 and size > 0 else float("nan")


def rank(values: Array) -> Array:
    """Ranks from 0; equal values have the mean of theirs."""
    _, inverse, counts = np.unique(values, return_inverse=True, return_counts=True)
    return (np.cumsum(counts) - (counts + 1) / 2)[inverse]


def find_main_effect(x: Array, y: Array, is_alone: bool = False) -> list[tuple[float, float, int]]:
    """(x, mean of y, number of designs) of each level of x, or of groups of neighbours: where there are many levels, or
    where other inputs vary too and most levels have one design, as in samples. is_alone: no other input varies."""
    levels, inverse = np.unique(x, return_inverse=True)
    if len(levels) > MOST_LEVELS or (not is_alone and len(levels) > len(x) / FEWEST_IN_GROUP):
        order = np.argsort(x, kind="stable")
        inverse = np.empty(len(x), dtype=int)
        inverse[order] = np.arange(len(x)) * max(1, min(GROUPS, len(x) // FEWEST_IN_GROUP)) // len(x)
    groups = [inverse == group for group in range(inverse.max() + 1)]
    return [(float(np.mean(x[group])), float(np.mean(y[group])), int(group.sum())) for group in groups]
