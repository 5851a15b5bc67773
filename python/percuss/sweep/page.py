"""One page about a sweep: table, main effects over the designs, correlation."""

import time
from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib import rc_context
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from percuss.plot.drawing import COLORS, SETTINGS, write_svg
from percuss.report.markup import Markup, escape, format_number, make_table
from percuss.report.page import join_sections, wrap_page
from percuss.sweep.statistics import correlate, find_main_effect, place_inputs, rank
from percuss.sweep.table import name_rules

from .table import Row, Table

MOST_FIGURES, MOST_INPUTS = 24, 8  # outputs and inputs that are drawn; the table and the file have all
MOST_LABELS, LONGEST_LABEL, MOST_NUMBERS = 12, 18, 20


def make_page(deck: str, table: Table, links: dict[int, str]) -> str:
    """links: {number of a design: path of its report}."""
    done = [row for row in table.rows if row.state == "completed"]
    sections = [("table", "Designs", _make_table(table, links)), ("warnings", "Warnings", _list_warnings(table)),
                ("effects", "Designs and main effects", _draw_effects(table, done)),
                ("correlation", "Correlation", _make_correlation(table, done))]
    head = f"<h1>{escape('Sweep of ' + deck)}</h1>" + _tell(table, done)
    return wrap_page(f"Sweep of {deck}", head + join_sections(sections), "sweep")


def _tell(table: Table, done: list[Row]) -> str:
    clock = time.strftime("%Y-%m-%d %H:%M UTC", time.gmtime())
    rest = {state: sum(row.state == state for row in table.rows)
            for state in ("failed", "refused", "interrupted", "elsewhere", "waiting")}
    words = "".join(f", {count} {state}" for state, count in rest.items() if count)
    warned = sum(bool(row.warnings) for row in table.rows)
    if warned:
        words += f", {warned} with warnings"
    return f"<p class=soft>{len(table.rows)} designs: {len(done)} completed{escape(words)}. Written {clock}.</p>"


def _list_warnings(table: Table) -> str:
    """Each rule with its designs, and what it says of the first of them."""
    warned = table.list_warned()
    if not warned:
        return ""
    rows = [[rule, f"{len(numbers)} of {len(table.rows)}", shorten(numbers), text] for rule, numbers, text in warned]
    return make_table(["rule", "count", "designs", "in the first of them"], rows)


def shorten(numbers: Sequence[int]) -> str:
    """The first of many numbers."""
    return ", ".join(map(str, numbers[:MOST_NUMBERS])) + (", ..." if len(numbers) > MOST_NUMBERS else "")


def _make_table(table: Table, links: dict[int, str]) -> str:
    """Numbers are shown with six digits; the file sweep.csv has all."""
    named = [f"{name} [{unit}]" if unit else name for name, unit in table.outputs.items()]
    heading = ["design", *table.inputs, *named, "state", "energy error", "time [s]", "warnings"]
    rows = []
    for row in table.rows:
        name = (Markup(f"<a href='{escape(links[row.number])}'>{row.number}</a>") if row.number in links
                else str(row.number))
        numbers = [format_number(row.outputs[name][0]) if name in row.outputs else "" for name in table.outputs]
        state = f"{row.state}: {row.error}" if row.error else row.state
        rest = ["" if value is None else f"{value:.3g}" for value in (row.energy_error, row.seconds)]
        rows.append([name, *(row.inputs.get(name, "") for name in table.inputs), *numbers, state, *rest,
                     name_rules(row.warnings)])
    first = 1 + len(table.inputs)
    return "<div style='overflow-x:auto'>" + make_table(heading, rows, (*range(1, first + len(named)),)) + "</div>"


def _draw_effects(table: Table, done: list[Row]) -> str:
    if len(done) < 2:
        return "<p class=soft>At least two completed designs are needed.</p>"
    inputs, outputs = _list_varied(table, done)[:MOST_INPUTS], list(table.outputs)[:MOST_FIGURES]
    figures = "".join(f"<figure>{write_svg(_draw_output(name, table.outputs[name], inputs, done))}</figure>"
                      for name in outputs)
    left = len(table.outputs) - len(outputs)
    note = f"<p class=soft>{left} more outputs are not drawn; sweep.csv has them.</p>" if left else ""
    return ("<p>Each point is a design. "
            "The line joins the means of the designs with one value of the input, or of groups of neighbours "
            "where there are more than eight values or one design to most values.</p>"
            f"<div class=plots>{figures}</div>{note}")


def _list_varied(table: Table, done: list[Row]) -> list[str]:
    return [name for name in table.inputs if len({row.inputs[name] for row in done}) > 1]


def _draw_output(name: str, unit: str, inputs: list[str], done: list[Row]) -> Any:
    with rc_context(SETTINGS):
        figure = Figure(figsize=(max(3.2, 2.5 * len(inputs) + 0.7), 2.9), constrained_layout=True)
        FigureCanvasAgg(figure)
        rows = [row for row in done if name in row.outputs and np.isfinite(row.outputs[name][0])]
        y = np.array([row.outputs[name][0] for row in rows])
        first = None
        for place, factor in enumerate(inputs):
            first = axes = figure.add_subplot(1, len(inputs), place + 1, sharey=first)
            x, words = place_inputs([row.inputs[factor] for row in rows])
            axes.plot(x, y, "o", markersize=4, color=COLORS[0], alpha=0.55, markeredgewidth=0)
            effect = [(at, mean) for at, mean, _ in find_main_effect(x, y, len(inputs) == 1)] if len(x) else []
            if len(effect) > 1:
                axes.plot(*zip(*effect), color=COLORS[1], linewidth=1.5)
            if words and len(words) <= MOST_LABELS:
                axes.set_xticks(range(len(words)), [word[:LONGEST_LABEL] for word in words], rotation=30, ha="right")
            axes.set_xlabel(factor if len(factor) <= 2 * LONGEST_LABEL else "\u2026" + factor[-2 * LONGEST_LABEL :],
                            fontsize=8)
            axes.tick_params(labelleft=place == 0)
        if first is not None:
            figure.axes[0].set_ylabel(f"{name} [{unit}]" if unit else name)
    return figure


def _make_correlation(table: Table, done: list[Row]) -> str:
    """Pearson's coefficient, and that of the ranks, of each output with each input."""
    inputs = _list_varied(table, done)
    if len(done) < 3 or not inputs:
        return ""
    rows = []
    for name in table.outputs:
        chosen = [row for row in done if name in row.outputs and np.isfinite(row.outputs[name][0])]
        y, cells = np.array([row.outputs[name][0] for row in chosen]), [name]
        for factor in inputs:
            x, words = place_inputs([row.inputs[factor] for row in chosen])
            cells.append("words" if words else _show(correlate(x, y), correlate(rank(x), rank(y))))
        rows.append(cells)
    return ("<p>1: the output grows in proportion to the input; -1: it falls; 0: no linear dependence. "
            "In brackets the same of the ranks, which does not ask for proportion.</p>"
            + make_table(["output", *inputs], rows, range(1, 1 + len(inputs))))


def _show(of_values: float, of_ranks: float) -> str:
    if not np.isfinite(of_values):
        return "-"
    color = "209,73,91" if of_values > 0 else "31,111,178"
    return Markup(f"<span style='background:rgba({color},{0.45 * abs(of_values):.2f});padding:1px 6px'>{of_values:.2f} "
                  f"({of_ranks:.2f})</span>")
