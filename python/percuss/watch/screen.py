"""The text of the view: progress, numbers, sparklines."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from percuss.terminal import clean

from .rows import Rows

if TYPE_CHECKING:
    from percuss.results.run import Run

BARS = "\u2581\u2582\u2583\u2584\u2585\u2586\u2587\u2588"
PLAIN_BARS = "_.-~=+*#"  # of terminals without UTF-8
LABEL = 15
SHOWN = [("kinetic", "kinetic"), ("internal", "internal"), ("hourglass", "hourglass"), ("contact", "contact work"),
         ("friction", "friction"), ("external", "external"), ("energy_error", "energy error"), ("dt", "time step"),
         ("contacts", "contacts"), ("eroded_elements", "eroded")]
MOST_FORCES = 4  # of output.history.forces


def make_sparkline(values: list[float], width: int, bars: str = BARS) -> str:
    """One sign for each of at most `width` runs of rows: their value farthest from zero, between the least and the
    largest such value."""
    finite = [value for value in values if math.isfinite(value)]
    if not finite:
        return ""
    count = min(width, len(values))
    pieces = [values[len(values) * i // count : len(values) * (i + 1) // count] for i in range(count)]
    chosen = [max((v for v in piece if math.isfinite(v)), key=abs) if any(map(math.isfinite, piece)) else None
              for piece in pieces]
    low, high = min(v for v in chosen if v is not None), max(v for v in chosen if v is not None)
    scale = (len(bars) - 1) / (high - low) if high > low else 0
    return "".join("x" if v is None else bars[round((v - low) * scale)] for v in chosen)


def make_progress(time: float | None, end: float | None, width: int, plain: bool) -> str:
    if not end or end <= 0 or time is None:
        return ""
    share = min(1.0, max(0.0, time / end))
    full, empty = ("#", "-") if plain else ("\u2588", "\u2591")
    done = int(share * width)
    return f"{full * done}{empty * (width - done)} {100 * share:5.1f} %"


def format_duration(seconds: float) -> str:
    seconds = int(seconds)
    if seconds < 60:
        return f"{seconds} s"
    if seconds < 3600:
        return f"{seconds // 60} min {seconds % 60:02d} s"
    return f"{seconds // 3600} h {seconds % 3600 // 60:02d} min"


def make_line(run: Run, rows: Rows, end: float | None, left: float | None) -> str:
    """One line, where the output is no terminal."""
    time, words = rows.last("time"), [run.status]
    if time is not None:
        if end:
            words.append(f"{100 * min(1, time / end):.1f} %")
        words += [f"t = {time:.4e}", f"step {rows.last('step'):.0f}", f"energy error {rows.last('energy_error'):.2g}",
                  f"contacts {rows.last('contacts'):.0f}"]
    if left is not None and run.status == "running":
        words.append(f"ETA {format_duration(left)}")
    return "  ".join(words)


def name_limit(run: Run, rows: Rows) -> str:
    """What limits the step: a spring, by the column dt_spring, or an element; empty where it is not known."""
    spring = int(rows.last("dt_spring") or 0)
    names = [name.partition(":")[2] for name in rows.names if name.startswith("spring_force:")]
    if 0 < spring <= len(names):
        return f"spring '{names[spring - 1]}' limits the step"
    if spring < 0:  # one of an entry with too many for columns of their own
        entries = list(run.deck.get_map("springs"))
        return (f"a spring of '{entries[-1 - spring]}' limits the step" if -spring <= len(entries)
                else "a spring limits the step")
    element = rows.last("dt_element")
    if element == 0:
        return "the approach of bodies limits the step"
    return "" if element is None else f"element {element:.0f} limits the step"


def make_screen(run: Run, rows: Rows, end: float | None, left: float | None, size: tuple[int, bool]) -> list[str]:
    """Lines of the view. left: seconds to the end, or None. size: (width, plain)."""
    width, plain = size
    unit = f" {run.units.time[0]}" if run.units else ""
    status = f"{run.status}, {run.step_limit}" if run.step_limit else run.status
    lines = [f"{run.title}  [{status}]", run.folder]
    time = rows.last("time")
    if time is not None:
        bar = make_progress(time, end, min(40, max(10, width - 50)), plain)
        goal = f" of {end:.4g}{unit}" if end else ""
        ahead = f", {format_duration(left)} left" if left is not None and run.status == "running" else ""
        lines += [f"{bar}  t = {time:.4g}{goal}, step {rows.last('step'):.0f}{ahead}".strip(), ""]
        lines += _make_curves(rows, width, plain)
        lines.append(name_limit(run, rows))
    else:
        lines.append("no rows yet")
    lines += _list_warnings(run)
    if run.summary.get("error"):
        lines.append("error: " + run.summary["error"])
    lines = [clean(line) for line in lines]
    return [line if len(line) <= width else line[: width - 1] + ("~" if plain else "\u2026") for line in lines]


def list_curves(rows: Rows) -> list[tuple[str, str, list[float]]]:
    """[(name, label, values)]: those of SHOWN, then the magnitude of the first forces."""
    curves = [(name, label, rows.columns.get(name, [])) for name, label in SHOWN]
    for name in [name[len("fx:") :] for name in rows.names if name.startswith("fx:")][:MOST_FORCES]:
        parts = zip(*(rows.columns.get(f"f{axis}:{name}", []) for axis in "xyz"))
        curves.append((f"fx:{name}", f"|f| {name}"[:LABEL], [math.sqrt(sum(x * x for x in part)) for part in parts]))
    return curves


def _make_curves(rows: Rows, width: int, plain: bool) -> list[str]:
    lines = []
    for name, label, values in list_curves(rows):
        if name == "dt" and len(values) > 1 and values[0] == 0:
            values = values[1:]  # no step has led to the start
        if not values or not any(values):
            continue
        room = max(8, width - LABEL - 38)
        line = make_sparkline(values, room, PLAIN_BARS if plain else BARS)
        finite = [v for v in values if math.isfinite(v)] or [math.nan]
        lines.append(f"{label:{LABEL}} {values[-1]:11.4g}  {line:{room}}  {min(finite):.3g} to {max(finite):.3g}")
    return lines


def _list_warnings(run: Run) -> list[str]:
    found = run.warnings
    lines = [f"{len(found)} warning{'s' * (len(found) != 1)}:"] if found else []
    for warning in found[:5]:
        place = f"{warning['place']}: " if warning.get("place") else ""
        lines.append(f"  [{warning['rule']}] {place}{warning['text']}")
    return lines
