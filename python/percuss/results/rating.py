"""How well a computed signal follows a measured one: the rating of ISO/TS 18571:2014 for signals that do not repeat,
and the share of a corridor.

Four numbers between 0 and 1 make the rating R = 0.4 Z + 0.2 P + 0.2 M + 0.2 S:
  Z  corridor: 1 within 5 % of the largest test value around the test, 0 beyond 50 %, with the square of the way between
  P  phase: by the shift of at most 20 % of the signal for which the cross correlation is largest
  M  magnitude: of both signals after this shift and after dynamic time warping (a window of 10 %), difference over the
  test S  slope: of both signals after the shift, smoothed over nine points, difference over the test
The standard asks for signals at 10 kHz. Here both are resampled to equal steps, at most MOST_POINTS of them."""

import numpy as np

from .arrays import Array

INNER, OUTER, CORRIDOR_POWER = 0.05, 0.5, 2
LARGEST_SHIFT, PHASE_POWER = 0.2, 1
WARP_WINDOW, LARGEST_MAGNITUDE_ERROR, MAGNITUDE_POWER = 0.1, 0.5, 1
SMOOTHED, LARGEST_SLOPE_ERROR, SLOPE_POWER = 9, 2.0, 1
WEIGHTS = {"corridor": 0.4, "phase": 0.2, "magnitude": 0.2, "slope": 0.2}
MOST_POINTS = 2000


def rate(test_time: Array, test: Array, time: Array, values: Array) -> dict[str, float]:
    """{corridor, phase, magnitude, slope, rating} over the time that both signals have.
    ValueError where that is too short."""
    start, end = max(test_time[0], time[0]), min(test_time[-1], time[-1])
    count = min(MOST_POINTS, max(len(test), len(values)))
    if not end > start or count < 2 * SMOOTHED:
        raise ValueError("the test and the run have too few points, or no time together")
    at = np.linspace(start, end, count)
    return rate_signals(np.interp(at, test_time, test), np.interp(at, time, values), at[1] - at[0])


def rate_signals(test: Array, values: Array, step: float) -> dict[str, float]:
    """Rating of two signals at the same times, `step` apart."""
    size = np.abs(test).max()
    if not size > 0:
        raise ValueError("the test is zero throughout")
    found = {"corridor": _rate_corridor(np.abs(test - values), INNER * size, OUTER * size)}
    found["phase"], first, second = _rate_phase(test, values)
    found["magnitude"] = _rate_error(_find_warped_error(first, second), LARGEST_MAGNITUDE_ERROR, MAGNITUDE_POWER)
    of_slope = _find_error(_find_slope(first, step), _find_slope(second, step))
    found["slope"] = _rate_error(of_slope, LARGEST_SLOPE_ERROR, SLOPE_POWER)
    return {**found, "rating": sum(WEIGHTS[name] * score for name, score in found.items())}


def find_share_inside(low: Array, high: Array, values: Array) -> float:
    """The share of points within a corridor."""
    return float(np.mean((values >= low) & (values <= high))) if len(values) else 0.0


def _rate_corridor(distance: Array, inner: float, outer: float) -> float:
    return float(np.mean(np.clip((outer - distance) / (outer - inner), 0, 1) ** CORRIDOR_POWER))


def _rate_phase(test: Array, values: Array) -> tuple[float, Array, Array]:
    """(score, both signals after the shift, where they lie over each other)."""
    count, most = len(test), int(LARGEST_SHIFT * len(test))
    best, shift = -np.inf, 0
    for steps in sorted(range(-most, most + 1), key=abs):  # of equal ones the shortest
        a, b = _shift(test, values, steps)
        a, b = a - a.mean(), b - b.mean()
        scale = np.sqrt((a @ a) * (b @ b))
        correlation = (a @ b) / scale if scale > 0 else 0.0
        if correlation > best + 1e-12:
            best, shift = correlation, steps
    return _rate_error(abs(shift) / count, LARGEST_SHIFT, PHASE_POWER), *_shift(test, values, shift)


def _shift(test: Array, values: Array, steps: int) -> tuple[Array, Array]:
    """steps > 0: the values come later than the test."""
    if steps > 0:
        return test[:-steps], values[steps:]
    return (test[-steps:], values[:steps]) if steps < 0 else (test, values)


def _find_warped_error(test: Array, values: Array) -> float:
    """Error of the two signals along the path that dynamic time warping finds with squared distances in a window."""
    count, window = len(test), max(1, int(np.ceil(WARP_WINDOW * len(test))))
    cost = np.full((count + 1, count + 1), np.inf)
    cost[0, 0] = 0
    for i in range(1, count + 1):
        low, high = max(1, i - window), min(count, i + window)
        row, above = cost[i], cost[i - 1]
        distance = (test[i - 1] - values[low - 1 : high]) ** 2
        reach = np.minimum(above[low : high + 1], above[low - 1 : high])
        last = row[low - 1]
        for j, (d, r) in enumerate(zip(distance.tolist(), reach.tolist()), low):
            last = d + min(last, r)
            row[j] = last
    i = j = count
    path = []
    while i > 0 and j > 0:
        path.append((i - 1, j - 1))
        steps = {(i - 1, j - 1): cost[i - 1, j - 1], (i - 1, j): cost[i - 1, j], (i, j - 1): cost[i, j - 1]}
        i, j = min(steps, key=lambda step: float(steps[step]))
    first, second = np.array(path).T
    return _find_error(test[first], values[second])


def _find_slope(values: Array, step: float) -> Array:
    slopes = np.gradient(values, step)
    kernel = np.ones(SMOOTHED)
    smooth: Array = np.convolve(slopes, kernel, "same") / np.convolve(np.ones(len(slopes)), kernel, "same")
    return smooth


def _find_error(test: Array, values: Array) -> float:
    size = np.abs(test).sum()
    return float(np.abs(test - values).sum() / size) if size > 0 else float(np.abs(values).sum() > 0)


def _rate_error(error: float, largest: float, power: float) -> float:
    return float(np.clip((largest - error) / largest, 0, 1) ** power)
