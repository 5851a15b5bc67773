"""Curves as they are drawn: in the units that are wanted, filtered, cut to a range of time, thinned."""

from dataclasses import dataclass

import numpy as np
from percuss.filters import filter_cfc, resample

MOST_POINTS = 2000  # of a curve: about two for each pixel of its width


@dataclass
class Options:
    channel_class: int = 0       # of SAE J211; 0: no filter
    units: object = None         # a Units, to convert to
    start: float = -np.inf       # range of time, in the units of the deck
    end: float = np.inf


def prepare_history(run, options):
    """The history of a run in the units that are wanted, with the range of time in them."""
    history = run.history
    if options.units is None:
        return history
    return history.in_units(options.units)


def make_curve(history, name, options):
    """(times, values) of a column; ValueError where it cannot be filtered."""
    time, values = history["time"], history[name]
    if name == "dt" and len(time) > 1 and values[0] == 0:  # no step has led to the start
        time, values = time[1:], values[1:]
    if options.channel_class and name not in ("dt_element", "dt_spring", "step"):
        time, values = resample(time, values)
        seconds = history.units.time[1] if history.units else 1.0
        values = filter_cfc(values, (time[1] - time[0]) * seconds, options.channel_class)
    inside = (time >= options.start) & (time <= options.end)
    return time[inside], values[inside]


def is_too_short(history, channel_class):
    """Whether a filter of this class takes the whole history for less than a period of the frequency that it weakens by 3 dB."""
    seconds = history.units.time[1] if history.units else 1.0
    return len(history) > 1 and (history["time"][-1] - history["time"][0]) * seconds * channel_class / 0.6 < 1


def thin(time, values, most=MOST_POINTS):
    """The curve with fewer points, but each peak: the least and the largest value of runs of rows, in their order."""
    if len(time) <= most:
        return time, values
    size = -(-2 * len(time) // most)
    kept = []
    for first in range(0, len(time), size):
        piece = values[first : first + size]
        if np.isnan(piece).any():
            kept += range(first, first + len(piece))
            continue
        kept += sorted({first + int(np.argmin(piece)), first + int(np.argmax(piece))})
    kept = np.unique([0, *kept, len(time) - 1])
    return time[kept], values[kept]


def find_controlling_parts(run, history):
    """[rows] number of the part whose element controls the step, -1: not known; and the names of the parts. None without
    fields."""
    if "dt_element" not in history or not run.has_fields:
        return None
    fields = run.fields
    ids = fields.element_ids
    order = np.argsort(ids)
    wanted = history["dt_element"].astype(np.int64)
    place = np.clip(np.searchsorted(ids[order], wanted), 0, len(ids) - 1)
    found = order[place]
    return np.where(ids[found] == wanted, fields.part[found], -1), fields.part_names
