"""Curves as they are drawn: in the units that are wanted, filtered, cut to a range of time, thinned."""

from collections.abc import Collection, Iterator
from dataclasses import dataclass, field

import numpy as np

from percuss.results.arrays import Array
from percuss.results.expressions import is_expression, split_label, spread
from percuss.results.filters import filter_cfc, resample
from percuss.results.history import History
from percuss.results.labels import Labelled, read_labelled
from percuss.results.run import Run
from percuss.results.units import Units

MOST_POINTS = 2000  # of a curve: about two for each pixel of its width


@dataclass
class Options:
    channel_class: int = 0       # of SAE J211, of the columns; 0: no filter
    class_after: int = 0         # of SAE J211, of computed curves
    x: str = "time"              # the column of the abscissa
    units: Units | None = None         # a Units, to convert to
    start: float = -np.inf       # range of time, in the units of the deck
    end: float = np.inf
    notes: list[str] = field(default_factory=list)  # what the user is told of the units of expressions


def prepare_history(run: Run, options: Options) -> History:
    """The history of a run in the units that are wanted, with the range of time in them."""
    history = run.history
    if options.units is None:
        return history
    return history.in_units(options.units)


UNFILTERED = ("time", "dt_element", "dt_spring", "step")


def make_curve(history: History, name: str, options: Options) -> tuple[Array, Array]:
    """(abscissas, values) of a column; ValueError where it cannot be filtered."""
    time, values = history["time"], history[name]
    if name == "dt" and len(time) > 1 and values[0] == 0:  # no step has led to the start
        time, values = time[1:], values[1:]
    time, values = _filter(history, name, time, values, options)
    inside = (time >= options.start) & (time <= options.end)
    if options.x == "time":
        return time[inside], values[inside]
    across = np.interp(time, *_filter(history, options.x, history["time"], history[options.x], options))
    return across[inside], values[inside]


def _filter(history: History, name: str, time: Array, values: Array, options: Options) -> tuple[Array, Array]:
    channel_class = options.class_after if name in history.computed else options.channel_class
    if not channel_class or name in UNFILTERED:
        return time, values
    time, values = resample(time, values)
    seconds = history.units.time[1] if history.units else 1.0
    return time, filter_cfc(values, (time[1] - time[0]) * seconds, channel_class)


class _Filtered:
    """The columns of a history, each filtered, at its rows: what expressions are computed of."""

    def __init__(self, history: History, options: Options) -> None:
        self._history, self._options = history, options
        self._known: dict[str, Array] = {}
        self.units, self.everything, self.dimension = history.units, history.everything, history.dimension

    def __iter__(self) -> Iterator[str]:
        return iter(self._history)

    def __contains__(self, name: object) -> bool:
        return name in self._history

    def __len__(self) -> int:
        return len(self._history)

    def __getitem__(self, name: str) -> Array:
        if name not in self._known:
            time, values = _filter(self._history, name, self._history["time"], self._history[name], self._options)
            self._known[name] = np.interp(self._history["time"], time, values)
        return self._known[name]


def add_expressions(words: list[str], histories: list[History], options: Options,
                    known: Collection[str] = ()) -> list[str]:
    """The words, with the name of a new column in place of each expression, which may have a label: 'crush =
    integral(fx:a, top_x)', with a unit: 'acceleration [g] = sensor_az'.
    known: what is no expression whatever it looks like. BadExpression where one cannot be computed in any history."""
    named = []
    for word in words:
        label, text = split_label(word)
        names = [name for history in histories for name in history.everything]
        is_column = (label == text
                     and (word in known or all(piece in names or piece in known for piece in word.split(","))))
        if is_column or word.startswith("=") or (label == text and not is_expression(text, names)):
            named.append(word)
            continue
        for history in histories:
            found = add_expression(history, word, options)
        named.append(found.name)
    return named


def add_expression(history: History, word: str, options: Options) -> Labelled:
    """Adds it to the history, and to that in the units of the deck, of which later expressions are computed."""
    deck = history.of_deck
    found = read_labelled(history, word, _Filtered(deck, options) if options.channel_class else None)
    for one, values in {id(deck): (deck, found.deck_values), id(history): (history, found.values)}.values():
        one.add(found.name, spread(values, len(one)), found.powers, found.unit)
    if found.note and found.note not in options.notes:
        options.notes.append(found.note)
    return found


def choose_abscissa(word: str, histories: list[History], options: Options) -> str:
    """The name of the column; that of a new one for an expression."""
    from .panels import choose_columns

    (name,) = add_expressions([word], histories, options)
    if not all(name in history for history in histories):
        choose_columns(name, histories)  # says what there is
        raise ValueError(f"'{name}' is no single column of every run (--x needs one)")
    return name


def is_too_short(history: History, channel_class: int) -> bool:
    """Whether a filter of this class takes the whole history for less than a period of the frequency
    that it weakens by 3 dB."""
    seconds = history.units.time[1] if history.units else 1.0
    return len(history) > 1 and (history["time"][-1] - history["time"][0]) * seconds * channel_class / 0.6 < 1


def thin(time: Array, values: Array, most: int = MOST_POINTS) -> tuple[Array, Array]:
    """The curve with fewer points, but each peak: the least and the largest value of runs of rows, in their order."""
    if len(time) <= most:
        return time, values
    size = -(-2 * len(time) // most)
    kept: list[int] = []
    for first in range(0, len(time), size):
        piece = values[first : first + size]
        if np.isnan(piece).any():
            kept += range(first, first + len(piece))
            continue
        kept += sorted({first + int(np.argmin(piece)), first + int(np.argmax(piece))})
    chosen = np.unique([0, *kept, len(time) - 1])
    return time[chosen], values[chosen]


def find_controlling_parts(run: Run, history: History) -> tuple[Array, list[str]] | None:
    """[rows] number of the part whose element controls the step, -1: not known; and the names of the parts. None
    without fields."""
    if "dt_element" not in history or not run.has_fields:
        return None
    fields = run.fields
    ids = fields.element_ids
    order = np.argsort(ids)
    wanted = history["dt_element"].astype(np.int64)
    place = np.clip(np.searchsorted(ids[order], wanted), 0, len(ids) - 1)
    found = order[place]
    return np.where(ids[found] == wanted, fields.part[found], -1), fields.part_names
