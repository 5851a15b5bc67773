"""Filters of SAE J211 (ISO 6487) and resampling to equal steps."""

import math

import numpy as np

from .arrays import Array

CLASSES = (60, 180, 600, 1000)
FEWEST_SAMPLES_A_PERIOD = 5  # of the cutoff frequency: below it the digital filter no longer resembles the standard's


def find_cutoff(channel_class: int) -> float:
    """The frequency in hertz at which the whole filter, forwards and backwards, takes away 3 dB: 1000 of CFC 600."""
    return channel_class / 0.6


def find_coefficients(channel_class: int, interval: float) -> tuple[tuple[float, float, float], tuple[float, float]]:
    """(a0, a1, a2), (b1, b2) of SAE J211-1, appendix C: a Butterworth filter of two poles,
    y(t) = a0 x(t) + a1 x(t-1) + a2 x(t-2) + b1 y(t-1) + b2 y(t-2), whose corner lies at 2.0775 times the class.

    interval: seconds between samples."""
    corner = 2 * math.pi * channel_class * 2.0775
    warped = math.sin(corner * interval / 2) / math.cos(corner * interval / 2)
    square, root = warped * warped, math.sqrt(2) * warped
    a0 = square / (1 + root + square)
    return (a0, 2 * a0, a0), (-2 * (square - 1) / (1 + root + square), (-1 + root - square) / (1 + root + square))


def filter_cfc(values: Array, interval: float, channel_class: int) -> Array:
    """The signal after the channel frequency class 60, 180, 600 or 1000: forwards, then backwards, so that no phase is
    shifted. values [n], or [n][columns]. interval: seconds between samples, which must be equal (see resample).

    ValueError where the samples are too far apart for the class. Both ends are continued by the signal turned about its
    end points, over ten periods of the cutoff, so that a signal that does not start or end at zero keeps its ends."""
    values = np.asarray(values, dtype=float)
    if channel_class not in CLASSES:
        raise ValueError(f"there is no class CFC {channel_class} (there are {', '.join(map(str, CLASSES))})")
    period = 1 / find_cutoff(channel_class)
    if not 0 < interval <= period / FEWEST_SAMPLES_A_PERIOD:
        raise ValueError(f"samples every {interval:.3g} s are too far apart for CFC {channel_class} "
                         f"(at most {period / FEWEST_SAMPLES_A_PERIOD:.3g} s): write history rows more often")
    if len(values) < 2:
        return values.copy()
    pad = min(len(values) - 1, math.ceil(10 * period / interval))
    before, after = 2 * values[0] - values[pad:0:-1], 2 * values[-1] - values[-2 : -pad - 2 : -1]
    signal = np.concatenate([before, values, after])
    coefficients = find_coefficients(channel_class, interval)
    forwards = _run_filter(signal, *coefficients)
    return _run_filter(forwards[::-1], *coefficients)[::-1][pad : pad + len(values)]


def _run_filter(x: Array, a: tuple[float, float, float], b: tuple[float, float]) -> Array:
    """The recursion of two poles; it starts as if the first value had lasted for ever."""
    fed = a[0] * x
    fed[1:] += a[1] * x[:-1]
    fed[2:] += a[2] * x[:-2]
    fed[0] += (a[1] + a[2]) * x[0]
    fed[1] += a[2] * x[0]
    y = np.empty_like(x)
    last = before = x[0]
    for i, value in enumerate(fed.tolist() if fed.ndim == 1 else fed):
        last, before = value + b[0] * last + b[1] * before, last
        y[i] = last
    return y


def resample(times: Array, values: Array, interval: float | None = None) -> tuple[Array, Array]:
    """The signal at equal steps: (times, values). interval: the step; by default about the mean of those given.
    Linear between samples: history rows fall on steps of the run, so that their distances differ."""
    times, values = np.asarray(times, dtype=float), np.asarray(values, dtype=float)
    if len(times) < 2 or not (np.diff(times) > 0).all():
        raise ValueError("times must rise, and be two at least")
    span = times[-1] - times[0]
    count = max(1, round(span / interval) if interval else len(times) - 1)
    if interval and abs(count * interval - span) > 1e-9 * span:
        count = math.floor(span / interval * (1 + 1e-12))
    equal = times[0] + np.arange(count + 1) * (interval or span / count)
    equal[-1] = min(equal[-1], times[-1])
    if values.ndim == 1:
        return equal, np.interp(equal, times, values)
    return equal, np.column_stack([np.interp(equal, times, column) for column in values.T])
