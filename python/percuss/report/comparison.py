"""Two runs or more beside each other: numbers, bits, decks."""

import difflib
import os
import re
from collections.abc import Iterable, Iterator, Sequence
from typing import Any

import numpy as np

from percuss.files import read_text
from percuss.results.converted import OF_SUMMARY
from percuss.results.extremes import find_size, find_top
from percuss.results.history import History
from percuss.results.run import Run

from .markup import Markup, escape, fold, format_number, make_table
from .scene import flatten

MACHINE = ("setup_s", "loop_s", "grind_ns", "phases_s", "earlier", "peak_bytes", "ranks", "threads", "messages",
           "balance", "decomposition", "skipped")
FIRST_DIMENSIONS = ("force", "energy")
ROUND_OFF = 1e-6  # share of the largest column of a dimension: what stays below it is noise
EQUAL_ABOVE = 1e-14  # relative differences below are written as 0


def compare_numbers(values: Sequence[Any], is_name: bool = False) -> list[str]:
    """Text of the differences of each next number from the first: '+1.2 %'; empty where there is none. is_name: the
    number tells things apart, as that of an element does."""
    first = values[0]
    texts = []
    for value in values[1:]:
        if value == first or (value != value and first != first):  # NaN
            texts.append("")
        elif is_name or any(isinstance(x, bool) or not isinstance(x, (int, float)) for x in (first, value)):
            texts.append("differs")
        elif first == 0:
            texts.append(f"{value - first:+.3g}")
        else:
            texts.append(f"{100 * (value - first) / abs(first):+.3g} %")
    return texts


def make_bits_text(runs: list[Run]) -> str:
    """Whether the runs ended in the same state, to the last bit."""
    hashes = [run.summary.get("state_hash") for run in runs]
    if not all(hashes):
        return "<p>Not every run has a state hash (it is written at the end), so that bits cannot be compared.</p>"
    if len(set(hashes)) == 1:
        return (f"<p class=same>Same bits: all runs ended in the state {escape(hashes[0])}.</p>"
                + make_first_difference(runs))
    groups: dict[str | None, list[Run]] = {}
    for run, value in zip(runs, hashes):
        groups.setdefault(value, []).append(run)
    rows = [(value, ", ".join(run.folder for run in found)) for value, found in groups.items()]
    return ("<p class=other>Other bits: the final states differ.</p>" + make_table(("state hash", "runs"), rows) +
            make_first_difference(runs))


def make_first_difference(runs: list[Run]) -> str:
    """Whether the texts of the histories are the same, and where the first row differs.
    Texts read back to the same bits."""
    if not all(run.has_history for run in runs):
        return ""
    first, text = _read_lines(runs[0]), ""
    for run in runs[1:]:
        other = _read_lines(run)
        row = next((n for n, (a, b) in enumerate(zip(first, other)) if a != b), min(len(first), len(other)))
        if row == len(first) == len(other):
            words = "has the same bytes"
        elif row == 0:
            words = "has other columns"
        elif row == min(len(first), len(other)):
            words = f"has the same {row - 1} rows as far as both go ({len(first) - 1} and {len(other) - 1} rows)"
        else:
            words = f"differs first in row {row}, {_name_differences(first, other, row)}"
        text += f"<p>history.csv of {escape(run.folder)} {escape(words)}.</p>"
    return text


def _read_lines(run: Run) -> list[str]:
    return read_text(os.path.join(run.folder, "history.csv")).splitlines()


def _name_differences(first: list[str], other: list[str], row: int, most: int = 6) -> str:
    """'at t = 0.01, in dt, kinetic'"""
    names, a, b = (line.split(",") for line in (first[0], first[row], other[row]))
    changed = [name for name, x, y in zip(names, a, b) if x != y]
    more = f" and {len(changed) - most} more" if len(changed) > most else ""
    return f"at t = {a[0]}, in {', '.join(changed[:most])}{more}"


def make_summary_table(runs: list[Run], labels: list[str]) -> str:
    """Numbers of summary.json that differ; those of the machine and those that are equal are folded."""
    tables = [dict(_split_lists(flatten(run.summary))) for run in runs]
    keys = [key for key in tables[0]
            if all(key in table for table in tables) and not key.startswith(("warnings", "state_hash"))]
    rows, machine, equal = list[list[str]](), list[list[str]](), 0
    for key in keys:
        values = [table[key] for table in tables]
        if all(value == values[0] for value in values):
            equal += 1
            continue
        row = [key + _name_unit(runs, key), format_number(values[0])]
        for value, difference in zip(values[1:], compare_numbers(values, key == "dt.element")):
            row += [format_number(value), difference]
        (machine if key.split(".")[0] in MACHINE else rows).append(row)
    heading = ["key of summary.json", labels[0]] + [text for label in labels[1:] for text in (label, "difference")]
    numbers = range(1, len(heading))
    shown = make_table(heading, rows, numbers) if rows else "<p>All results in summary.json are equal.</p>"
    return (shown + f"<p class=soft>{equal} more keys are equal.</p>" +
            (fold("What depends on the machine: time, memory, messages", make_table(heading, machine, numbers))
             if machine else ""))


def _name_unit(runs: list[Run], key: str) -> str:
    """' [J]' of a key of summary.json with a dimension, where all runs have one system of units."""
    quantity, units = (OF_SUMMARY.get(key) or OF_SUMMARY.get(key.rpartition(".")[0]),
                       {run.units and run.units.text for run in runs})
    return f" [{runs[0].units.name_of(quantity)}]" if quantity and len(units) == 1 and runs[0].units else ""


def _split_lists(rows: Iterable[tuple[str, Any]]) -> Iterator[tuple[str, Any]]:
    for key, value in rows:
        if isinstance(value, list) and value and all(isinstance(item, (int, float)) for item in value):
            for axis, item in zip("xyz", value):
                yield f"{key}.{axis}", item
        else:
            yield key, value


def find_history_differences(first: History, other: History) -> list[tuple[str, float, float, float]]:
    """[(column, largest difference over the largest magnitude, its time, the same at the end)] at the times of the
    first; both in one system of units. Forces and energies come first, then what else has a dimension, then counts,
    errors and the time step; last what is round-off beside others of its dimension.
    Among these the largest difference is first."""
    end = min(first["time"][-1], other["time"][-1])
    time = first["time"][first["time"] <= end * (1 + 1e-12)]
    rows = []
    for name in first:
        if name in ("time", "step", "dt_element", "dt_spring", "candidates") or name not in other:
            continue
        a, b = first[name][: len(time)], np.interp(time, other["time"], other[name])
        size = max(_find_size(history, name) for history in (first, other))
        if size == 0 or not np.isfinite(a - b).any():
            continue
        share = np.abs(a - b) / size
        worst = find_top(share)
        rows.append((name, float(share[worst]), float(time[worst]), float(share[-1])))
    largest: dict[str | None, float] = {}
    for name, *_ in rows:
        dimension = first.dimension(name)
        largest[dimension] = max(largest.get(dimension, 0.0),
                                 *(_find_size(history, name) for history in (first, other)))
    return sorted(rows, key=lambda row: (_rank(first, other, row[0], largest), -row[1]))


def _rank(first: History, other: History, name: str, largest: dict[str | None, float]) -> int:
    """Place of a column's group in the table: the less, the more it matters."""
    dimension = first.dimension(name)
    if dimension in FIRST_DIMENSIONS or dimension not in (None, "-", "time"):
        if max(_find_size(history, name) for history in (first, other)) < ROUND_OFF * largest[dimension]:
            return 3
        return 0 if dimension in FIRST_DIMENSIONS else 1
    return 2


def _find_size(history: History, name: str) -> float:
    """The largest magnitude of a column;
    of a component that of all three, so that round-off of one that is zero does not count."""
    parts = re.fullmatch(r"(momentum_|angular_|wall_force_|f|m)[xyz](:.*)?", name)
    names = [parts[1] + axis + (parts[2] or "") for axis in "xyz"] if parts else [name]
    return max(find_size(history[n]) for n in names if n in history)


def make_history_table(runs: list[Run], histories: list[History], labels: list[str]) -> str:
    text = ""
    for label, history in zip(labels[1:], histories[1:]):
        if not len(histories[0]) or not len(history):
            continue
        unit = histories[0].unit("time")
        rows = [(name, histories[0].label(name), f"{100 * share:.3g} %", f"{time:.4g} {unit}", f"{100 * last:.3g} %")
                for name, share, time, last in find_history_differences(histories[0], history) if share > EQUAL_ABOVE]
        text += f"<h3>History: {escape(label)} against {escape(labels[0])}</h3>"
        if rows:
            heading = ("column", "meaning", "largest difference", "at", "at the end")
            text += make_table(heading, rows[:12], (2, 3, 4))
            if len(rows) > 12:
                text += fold(f"{len(rows) - 12} more columns", make_table(heading, rows[12:], (2, 3, 4)))
        else:
            text += "<p>Every column is equal.</p>"
    return (text + "<p class=soft>Differences are shares of the largest magnitude of the column, "
                   "at the times of the first run.</p>")


def make_deck_difference(runs: list[Run], labels: list[str]) -> str:
    texts = [run.deck.text.splitlines() for run in runs]
    if not all(texts):
        return ""
    text = ""
    for label, other in zip(labels[1:], texts[1:]):
        lines = list(difflib.unified_diff(texts[0], other, labels[0], label, lineterm="", n=1))
        if not lines:
            text += f"<p>{escape(label)} ran the deck of {escape(labels[0])}, --set included.</p>"
            continue
        kinds = {"-": "gone", "+": "new"}
        shown = "\n".join(f"<span class={kinds.get(line[0], 'mono')}>{escape(line)}</span>" for line in lines)
        text += fold(f"Deck of {label} against {labels[0]}", f"<pre>{shown}</pre>")
    return Markup(text)
