"""Welds of a run: which have failed and when, and which came near to it."""

import math
import re
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from percuss.results.arrays import Array
from percuss.results.deck import Deck
from percuss.results.history import History
from percuss.results.run import Run
from percuss.results.units import choose_time_unit

from .markup import make_table

NEAR = 0.5       # share of the criterion of failure: welds that hold and came so near are listed
MOST_ROWS = 30   # of the welds that failed, and of those near to it


@dataclass
class WeldLife:
    """A weld with columns in the history, over its rows."""

    name: str
    entry: str  # of the deck
    failed_at: float  # time of the first row without force, which lasts to the end; infinite: it has a force there
    use: float  # largest value of the criterion in a row, 1 at failure; 0 where the deck gives no strength
    time: float  # of that


def find_entry(deck: Deck, name: str) -> tuple[str, dict[str, Any]]:
    """(name of the entry of welds, its failure) of a weld, which is called as it is, or NAME_1, NAME_2 and so on."""
    entries = deck.get("welds") or {}
    for entry in (name, re.sub(r"_\d+$", "", name)):
        found = entries.get(entry) if isinstance(entries, dict) else None
        if isinstance(found, dict):
            failure = found.get("failure")
            return entry, failure if isinstance(failure, dict) else {}
    return re.sub(r"_\d+$", "", name), {}


def find_use(failure: dict[str, Any], normal: Array, shear: Array) -> Array | None:
    """[rows]: (|Fn| / Sn)^m1 + (|Fs| / Ss)^m2 of docs/deck.md; None without a strength."""
    terms = [np.abs(force / float(failure[key])) ** float(failure.get(f"{key}_exponent", 2))
             for key, force in (("normal", normal), ("shear", shear)) if failure.get(key)]
    return sum(terms) if terms else None


def list_welds(run: Run) -> list[WeldLife]:
    """The lives of all welds that have columns."""
    history, found = getattr(run, "original", run).history, []  # forces in the units of the deck, as its strengths
    time = np.asarray(run.history["time"])
    for name in (column[len("weld_normal:") :] for column in history if column.startswith("weld_normal:")):
        normal, shear = (np.nan_to_num(history[f"weld_{kind}:{name}"]) for kind in ("normal", "shear"))
        entry, failure = find_entry(run.deck, name)
        use = find_use(failure, normal, shear)
        top = 0 if use is None else int(np.argmax(use))
        found.append(WeldLife(name, entry, _find_failure(time, normal, shear), 0.0 if use is None else float(use[top]),
                              float(time[top])))
    return found


def _find_failure(time: Array, normal: Array, shear: Array) -> float:
    """A weld that has failed has no force, to the last bit; one that holds hardly ever has none."""
    loaded = np.flatnonzero((normal != 0) | (shear != 0))
    if not len(loaded) or loaded[-1] == len(time) - 1:
        return math.inf
    return float(time[loaded[-1] + 1])


def count_failed(history: History) -> tuple[int, float]:
    """(how many welds have failed in all, the time of the first row that counts one)."""
    if "welds_failed" not in history or not len(history):
        return 0, 0.0
    counts = np.asarray(history["welds_failed"])
    return int(counts[-1]), float(history["time"][int(np.argmax(counts > 0))])


def sort_out(run: Run) -> tuple[list[WeldLife], list[WeldLife], list[WeldLife]]:
    """(welds that have failed, in the order in which they did;
    those without force at the end that have not; those with one).

    A failed weld has no force from then on, and the count of failures rises in its first row without force, or in the
    row before. One that holds may have no force at the end either. At most as many as the count says have failed: those
    that came nearest to it.
    """
    counts, time = np.asarray(run.history["welds_failed"]), np.asarray(run.history["time"])
    lives = list_welds(run)

    def rises(life: WeldLife) -> bool:
        row = int(np.searchsorted(time, life.failed_at))
        return bool(counts[row] > counts[max(row - 2, 0)])

    still = [life for life in lives if life.failed_at < math.inf]
    likely = sorted(filter(rises, still), key=lambda life: -life.use)[: int(counts[-1])]
    broken = sorted(likely, key=lambda life: life.failed_at)
    return (broken, [life for life in still if life not in broken],
            [life for life in lives if life.failed_at == math.inf])


def describe_welds(run: Run, show_time: Callable[[Run, float], str]) -> list[str]:
    """Sentences: how many welds failed, which first and last, and which of the others came nearest.
    show_time(run, time) -> text."""
    if not run.has_history or "welds_failed" not in run.history or len(run.history) < 2:
        return []
    count, first = count_failed(run.history)
    broken, unloaded, holding = sort_out(run)
    held = sorted((life for life in [*holding, *unloaded] if life.use), key=lambda life: -life.use)
    texts = []
    if count:
        text = f"{count:,} weld{'s' * (count > 1)} failed, the first by t = {show_time(run, first)}"
        if broken:
            text += f" ({broken[0].name})"
            if len(broken) > 1:
                text += f", the last by t = {show_time(run, broken[-1].failed_at)} ({broken[-1].name})"
        texts.append(text + ".")
    elif holding or unloaded:
        texts.append("No weld failed.")
    if held:
        near = [life for life in held if life.use >= NEAR]
        text = (f"Of the welds that hold, {held[0].name} came nearest to its failure: {held[0].use:.2g} of it at t = "
                f"{show_time(run, held[0].time)}")
        texts.append(text + (f"; {len(near)} came to {NEAR:g} of it or more." if len(near) > 1 else "."))
    return texts


def make_welds_table(run: Run) -> str:
    """Welds that have failed, in the order in which they did, then those near to it."""
    if "welds_failed" not in run.history or len(run.history) < 2:
        return ""
    count, _ = count_failed(run.history)
    broken, unloaded, holding = sort_out(run)
    near = sorted((life for life in [*holding, *unloaded] if life.use >= NEAR), key=lambda life: -life.use)
    unit, factor = choose_time_unit(run.history.unit("time"), float(run.history["time"][-1]))

    def clock(time: float) -> str:
        return f"{time * factor:.4g} {unit}".rstrip()

    rows = [(life.name, "failed", clock(life.failed_at), "") for life in broken[:MOST_ROWS]]
    rows += [(life.name, "holds" if life in holding else "without force at the end", "",
              f"{life.use:.2g} at {clock(life.time)}") for life in near[:MOST_ROWS]]
    if not rows:
        return ""
    left_out = max(0, len(broken) - MOST_ROWS) + max(0, len(near) - MOST_ROWS)
    soft = ("Failure: the first row after it. The criterion of failure "
            "(1 at failure) is of the rows, each the forces of one step: between rows it may be larger.")
    soft += f" {left_out} more are not listed." if left_out else ""
    missing = count - len(broken)
    soft += f" {missing} more have failed that have no columns, or never had a force in a row." if missing > 0 else ""
    return ("<h3>Welds</h3>" + make_table(("weld", "", "failed by", "nearest to failure"), rows, (2, 3))
            + f"<p class=soft>{soft}</p>")
