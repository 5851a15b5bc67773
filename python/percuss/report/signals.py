"""Accelerometers as a test reports them: peaks of the signals after the filter CFC 180 of SAE J211."""

import math

import numpy as np

from percuss.results.arrays import Array
from percuss.results.extremes import find_size
from percuss.results.filters import filter_cfc, find_cutoff, resample
from percuss.results.history import History
from percuss.results.run import Run
from percuss.results.units import choose_time_unit

from .markup import make_table, show_value

CLASS = 180
PERIODS_AT_REST = 10  # of the cut-off frequency, before and after the signal
GRAVITY = 9.80665  # standard, in m/s2: peaks are given in g, too


def list_accelerometers(history: History) -> list[str]:
    """Names of output.history.accelerometers, in the order of their columns."""
    return [name[len("local_ax:") :] for name in history if name.startswith("local_ax:")]


def find_accelerations(history: History, name: str) -> Array:
    """[rows][3], along the moving axes: means over the time since the row before."""
    return np.stack([np.asarray(history[f"local_a{axis}:{name}"]) for axis in "xyz"], axis=1)


def find_filtered_peak(history: History, name: str) -> tuple[float, float, Array]:
    """(largest resultant of the filtered components, its time, largest magnitude of each component). Before the first
    row and after the last one nothing acts: an end within a vibration gives no peak, and an impact at time 0 keeps its
    own. ValueError where rows are too far apart, or the deck names no units: the filter is one of seconds."""
    if history.units is None:
        raise ValueError("the deck names no units, and the filter is one of seconds: add units to the deck")
    time, values = resample(history["time"], find_accelerations(history, name))
    interval = (time[1] - time[0]) * history.units.time[1]
    rest = np.zeros((math.ceil(PERIODS_AT_REST / find_cutoff(CLASS) / interval), 3))
    filtered = filter_cfc(np.concatenate([rest, values, rest]), interval, CLASS)[len(rest) : len(rest) + len(values)]
    size = np.linalg.norm(filtered, axis=1)
    top = int(np.argmax(size))
    return float(size[top]), float(time[top]), np.abs(filtered).max(axis=0)


def make_accelerometers_table(run: Run) -> str:
    """A row for each accelerometer: the peak of the filtered resultant and its time, components,
    and the peak without filter."""
    history = run.history
    names = list_accelerometers(history)
    if not names or len(history) < 2:
        return ""
    unit, (shown_unit, factor) = (history.unit(f"local_ax:{names[0]}"),
                                  choose_time_unit(history.unit("time"), float(history["time"][-1])))
    in_si = history.units.in_si("acceleration") if history.units else 1.0
    rows, troubles = [], []
    for name in names:
        raw = np.linalg.norm(find_accelerations(history, name), axis=1)
        cells = [""] * 6
        try:
            peak, time, parts = find_filtered_peak(history, name)
            cells = [show_value(peak, unit), f"{peak * in_si / GRAVITY:.4g}",
                     show_value(time * factor, shown_unit), *(show_value(part, unit) for part in parts)]
        except ValueError as error:
            troubles.append(f"{name}: {error}.")
        rows.append((name, *cells, show_value(find_size(raw), unit)))
    heading = ("accelerometer", f"largest resultant, CFC {CLASS}", "in g", "at", "largest x", "largest y", "largest z",
               "resultant without filter")
    text = "<h3>Accelerometers</h3>" + make_table(heading, rows, range(1, 8))
    soft = (f"Signals along the moving axes after the filter CFC {CLASS} of SAE J211, then their resultant; "
            "x, y and z are magnitudes. Nothing "
            "acts before the first row and after the last one. Without filter: of the means between rows.")
    span = float(history["time"][-1] - history["time"][0]) * (history.units.time[1] if history.units else 0)
    if history.units and span * find_cutoff(CLASS) < 1:
        soft += (" The run is shorter than a period of the filter, "
                 f"{1e3 / find_cutoff(CLASS):.3g} ms: it takes most of the peaks away.")
    return text + f"<p class=soft>{' '.join([soft, *dict.fromkeys(troubles)])}</p>"
