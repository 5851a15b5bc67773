"""The ends of the colour bar: from the numbers that are drawn to round ones around them."""

import math
from collections.abc import Iterable

import numpy as np

from percuss.results.arrays import Array

STEPS = (1.0, 2.0, 2.5, 5.0, 10.0)  # distances of the labels, times a power of ten
FEWEST, MOST = 4, 7                 # distances between labels on a bar
Ends = tuple[float, float]
ZERO_BELOW = 0.3  # a bar whose low end is less than this share of the high one starts at 0,
CENTRED_ABOVE = 0.2  # and one with both signs, the lesser above this share of the other, has 0 in the middle
# Small: a share of the largest number. Typical: the share of those above it. A bar is cut where the largest is so far.
SMALL, TYPICAL, FAR = 0.01, 0.99, 1.5
CONSTANT_BELOW = 1e-6  # numbers that differ by a smaller share are one number and its round-off


def find_ends(frames: Iterable[Array]) -> Ends | None:
    """The least and the largest finite number of arrays; None if there is none."""
    low, high = math.inf, -math.inf
    for values in frames:
        finite = values[(values > -math.inf) & (values < math.inf)]
        if finite.size:
            low, high = min(low, float(finite.min())), max(high, float(finite.max()))
    return (low, high) if low <= high else None


def find_typical_ends(frames: Iterable[Array], percentile: float | None = None) -> Ends | None:
    """The same without the largest numbers: up to a percentile of the frame in which that is largest. None: without
    what is far above 99 percent of the numbers that are more than small,
    so that one corner does not leave all else pale."""
    ends: Ends | None = None
    high = -math.inf
    for values in frames:
        finite = values[(values > -math.inf) & (values < math.inf)]
        if not finite.size:
            continue
        low, top = float(finite.min()), float(finite.max())
        ends = (min(low, ends[0]), max(top, ends[1])) if ends else (low, top)
        if percentile is not None:
            high = max(high, float(np.quantile(finite, percentile / 100)))
        elif top > 0:
            high = max(high, float(np.quantile(finite[finite > SMALL * top], TYPICAL)))
    if ends is None or not ends[0] < high < ends[1] or (percentile is None and ends[1] < FAR * high):
        return ends
    return ends[0], high


def choose_bar(ends: Ends | None) -> tuple[float, float, int]:
    """From the ends of the data those of the bar, and how many labels it has, all of them round: (0, 0.035, 8)."""
    if ends is None:
        return 0.0, 1.0, 5
    low, high = ends
    size = max(abs(low), abs(high))
    if size == 0:
        return 0.0, 1.0, 5
    if high - low <= CONSTANT_BELOW * size:
        low, high = min(low, 0.0), max(high, 0.0)
    elif 0 <= low < ZERO_BELOW * high:
        low = 0.0
    elif high <= 0 and high > ZERO_BELOW * low:
        high = 0.0
    elif low < 0 < high and min(-low, high) > CENTRED_ABOVE * size:
        low, high = -size, size
    return _round_outward(low, high)


def _round_outward(low: float, high: float) -> tuple[float, float, int]:
    """The least range with ends and labels at multiples of a round step; of equal ones that with the fewest labels."""
    power = 10.0 ** math.floor(math.log10((high - low) / FEWEST))
    found = []
    for factor in (*STEPS, *(10 * s for s in STEPS)):
        step = factor * power
        first, last = math.floor(low / step + 1e-9), math.ceil(high / step - 1e-9)
        if FEWEST <= last - first <= MOST:
            found.append((round((last - first) * factor, 6), last - first, first * step, last * step))
    if not found:  # numbers far from zero that hardly differ
        return low, high, FEWEST + 1
    _, count, lowest, highest = min(found)
    return lowest, highest, count + 1
