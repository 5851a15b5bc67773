"""What the user asks a report for: columns and expressions, as curves and as numbers."""

import numpy as np

from percuss.plot.drawing import Plot, write_svg
from percuss.plot.panels import choose_panels, list_panels
from percuss.plot.series import Options, add_expressions, choose_abscissa
from percuss.results.expressions import split_label, split_unit
from percuss.results.history import History
from percuss.results.labels import read_labelled
from percuss.results.run import Run
from percuss.results.units import choose_unit

from .markup import escape, make_table, with_unit


def make_curves(runs: list[Run], labels: list[str], words: list[str], x: str = "time") -> str:
    """words: as percuss plot has them. What is one number in every run is a row of a table; the rest is drawn.
    runs: those with a history."""
    if not words:
        return ""
    units = runs[0].units
    histories = [run.history.in_units(units) if units and run.units and run.units.text != units.text
                 else run.history.copy() for run in runs]
    options = Options()
    numbers = {word: values for word in words if (values := _find_numbers(word, histories, options.notes))}
    heading = ["", *(labels if len(runs) > 1 else ["value"])]
    rows = [[split_unit(split_label(word)[0])[0], *values] for word, values in numbers.items()]
    table = make_table(heading, rows, range(1, 1 + len(runs))) if rows else ""
    drawn = [word for word in words if word not in numbers]
    if not drawn:
        return table + _write_notes(options.notes)
    drawn = add_expressions(drawn, histories, options, list_panels(histories))
    options.x = choose_abscissa(x, histories, options)
    plot = Plot(list(zip(labels, runs, histories)), options)
    figures = "".join(f"<figure>{write_svg(plot.draw_one(panel))}</figure>"
                      for panel in choose_panels(drawn, histories))
    over = f"<p class=soft>Over {escape(x)}.</p>" if options.x != "time" else ""
    return f"{table}{over}{_write_notes(options.notes)}<div class=plots>{figures}</div>"


def _write_notes(notes: list[str]) -> str:
    return "".join(f"<p class=soft>{escape(note)}</p>" for note in notes)


def _find_numbers(word: str, histories: list[History], notes: list[str]) -> list[str]:
    """A text a run of an expression that is one number; empty where it is more, or no expression."""
    text = split_label(word)[1]
    if any(text in history or word in list_panels([history]) for history in histories) or word.startswith("="):
        return []
    found = []
    for history in histories:
        try:
            value = read_labelled(history, word)
        except ValueError:  # a pattern, or wrong: what draws it reports it
            return []
        if np.ndim(value.values):
            return []
        unit = value.unit or ""
        if value.unit is None and history.units and value.powers and any(value.powers):
            unit = history.units.name_of_powers(value.powers)
        shown, factor = (unit, 1.0) if value.unit is not None else choose_unit(unit, abs(float(value.values)))
        found.append(with_unit(float(f"{float(value.values) * factor:.6g}"), shown))
        if value.note and value.note not in notes:
            notes.append(value.note)
    return found
