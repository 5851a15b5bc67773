"""Panels as figures of Matplotlib: PNG and SVG."""

import io
import math
import os
from typing import Any

import numpy as np
from matplotlib import rc_context
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import MaxNLocator, ScalarFormatter

from percuss.files import make_mark, write_file
from percuss.results.extremes import find_size
from percuss.results.history import History
from percuss.results.run import Run
from percuss.results.units import choose_time_unit, choose_unit

from .measured import Measured
from .panels import Panel
from .series import Options, find_controlling_parts, make_curve, thin

COLORS = ("#1f6fb2", "#d1495b", "#3a8f4d", "#b3701f", "#7b5ea7", "#2a9d9d", "#8a5a44", "#c05fa0", "#6b7280", "#a3a300",
          "#444444", "#0f4c5c")  # those of curves; told apart by colour-blind readers together with the styles of runs
STYLES = ("-", (0, (5, 2)), (0, (1.5, 1.5)), (0, (5, 1.5, 1, 1.5)))
SMALL_NUMBER = 1e-2  # numbers without a unit below it are shown in thousandths, millionths ...
SUPERSCRIPTS = str.maketrans("-0123456789", "\u207b\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079")
ROUND_OFF, FLAT_MARGIN = 1e-9, 0.1  # shares of the largest value: curves below are constant; their margin
SAME_CURVE = 1e-9  # share of the largest value: curves that differ by less are one
MOST_TICKS = 7  # intervals of the abscissa: labels of a narrow panel do not touch
CLOSE_MARKS = 0.02  # share of the width of a panel
INK, GRID, MARK = "#2b2f36", "#e3e6ea", "#b45309"
SETTINGS = {"font.family": ["DejaVu Sans", "sans-serif"], "font.size": 9, "axes.edgecolor": "#9aa1a8",
            "axes.labelcolor": INK, "text.color": INK, "xtick.color": INK, "ytick.color": INK, "axes.grid": True,
            "grid.color": GRID, "svg.fonttype": "none", "svg.hashsalt": "percuss", "axes.spines.top": False,
            "axes.spines.right": False, "legend.frameon": False, "path.simplify": True}


def _coincide(history: History, one: str, other: str) -> bool:
    """Whether two columns have the same values but for round-off, and are not zero."""
    if one not in history or other not in history:
        return one not in history and other not in history
    a, b = history[one], history[other]
    size = max(find_size(a), find_size(b))
    return size > 0 and bool(np.all(np.abs(a - b) <= SAME_CURVE * size))


Drawn = tuple[str, Run, History]  # label, run, history in the units that are wanted


class Plot:
    """Runs over each other. runs: [(label, run, history in the units that are wanted)]."""

    def __init__(self, runs: list[Drawn], options: Options) -> None:
        self.runs, self.options = runs, options
        history = runs[0][2]
        self.test: Measured | None = None  # a measured curve (measured.py), in the units of the histories
        if options.x == "time":
            ends = [h["time"][-1] for _, _, h in runs if len(h)]
            self.x_unit, self.x_factor = choose_time_unit(history.unit("time"), min(max(ends, default=0), options.end))
        else:
            largest = max((find_size(h[options.x]) for _, _, h in runs), default=0)
            unit = history.unit(options.x)
            self.x_unit, self.x_factor = ((unit, 1.0) if history.has_given_unit(options.x)
                                          else choose_unit(unit, largest))

    def draw_all(self, panels: list[Panel], size: tuple[float, float] | None, title: str = "") -> Any:
        """One figure of all panels, in two columns where there are more than two.
        size: (width, height) in inches or None."""
        columns = 1 if len(panels) <= 2 else 2
        rows = -(-len(panels) // columns)
        with rc_context(SETTINGS):
            figure = self._make_figure(size or (7.5 * columns, 3.1 * rows + 0.4))
            for place, panel in enumerate(panels):
                self._draw(figure.add_subplot(rows, columns, place + 1), panel)
            if title:
                figure.suptitle(title, fontsize=12, x=0.01, ha="left")
        return figure

    def draw_one(self, panel: Panel, size: tuple[float, float] = (6.4, 3.0)) -> Any:
        with rc_context(SETTINGS):
            figure = self._make_figure(size)
            self._draw(figure.add_subplot(1, 1, 1), panel)
        return figure

    def _make_figure(self, size: tuple[float, float]) -> Any:
        figure = Figure(figsize=size, constrained_layout=True)
        FigureCanvasAgg(figure)
        return figure

    def _draw(self, axes: Any, panel: Panel) -> None:
        unit, factor = self._choose_unit(panel)
        hidden = self._find_copies(panel)
        several = len(self.runs) > 1
        for number, (label, run, history) in enumerate(self.runs):
            for curve, name in enumerate(panel.columns):
                if name not in history or name in hidden:
                    continue
                time, values = make_curve(history, name, self.options)
                time, values = thin(time, values)
                color = COLORS[(number if len(panel.columns) == 1 else curve) % len(COLORS)]
                axes.plot(time * self.x_factor, values * factor, color=color, linestyle=STYLES[number % len(STYLES)],
                          linewidth=1.3)
            if panel.colored_by_part and not several and self.options.x == "time":
                self._color_by_part(axes, run, history, factor)
        if self.test is not None:
            self.test.draw(axes, self.x_factor, factor)
        self._add_legend(axes, panel, hidden)
        self._finish(axes, panel, unit)

    def _find_copies(self, panel: Panel) -> dict[str, str]:
        """{column: an earlier one of the panel that has the same curve in every run}: it is drawn once."""
        copies = {}
        for place, name in enumerate(panel.columns):
            for earlier in panel.columns[:place]:
                if earlier not in copies and all(_coincide(history, earlier, name) for _, _, history in self.runs):
                    copies[name] = earlier
                    break
        return copies

    def _add_legend(self, axes: Any, panel: Panel, hidden: dict[str, str]) -> None:
        """Columns by their colours and runs by their styles: not a line for each pair of them.
        Curves that coincide have one line."""
        entries = list(axes.get_legend_handles_labels()[0])
        if len(panel.columns) > 1:
            for curve, name in enumerate(panel.columns):
                if name in hidden:
                    continue
                owner = next(history for _, _, history in self.runs if name in history)
                label = " =\n".join([owner.label(name),
                                     *(owner.label(copy) for copy, shown in hidden.items() if shown == name)])
                entries.append(Line2D([], [], color=COLORS[curve % len(COLORS)], label=label))
        if len(self.runs) > 1 or self.test is not None:
            for number, (label, _, _) in enumerate(self.runs):
                color = COLORS[number % len(COLORS)] if len(panel.columns) == 1 else INK
                entries.append(Line2D([], [], color=color, linestyle=STYLES[number % len(STYLES)], label=label))
        if entries:
            axes.legend(handles=entries, loc="center left", bbox_to_anchor=(1.0, 0.5), fontsize=8, handlelength=2.2)

    def _choose_unit(self, panel: Panel) -> tuple[str, float]:
        """The unit of a panel, and its factor; 'J, N' where columns of several are drawn over each other."""
        units, largest = set(), 0.0
        for _, _, history in self.runs:
            for name in panel.columns:
                if name in history and len(history):
                    units.add(history.unit(name))
                    finite = history[name][np.isfinite(history[name])]
                    largest = max(largest, float(np.abs(finite).max(initial=0)))
        if units == {self.runs[0][2].unit("time")} and panel.columns == ["dt"]:
            return choose_time_unit(self.runs[0][2].unit("time"), largest)
        if units == {""} and 0 < largest < SMALL_NUMBER:
            power = 3 * math.floor(math.log10(largest) / 3)
            return "10" + str(power).translate(SUPERSCRIPTS), 10.0**-power
        is_given = any(history.has_given_unit(name) for _, _, history in self.runs for name in panel.columns)
        return (choose_unit(units.pop(), largest) if len(units) == 1 and not is_given
                else (", ".join(sorted(u or "-" for u in units)), 1.0))

    def _color_by_part(self, axes: Any, run: Run, history: History, factor: float) -> None:
        """Dots on the curve of the step, in the colour of the part whose element controls it."""
        found = find_controlling_parts(run, history)
        if found is None:
            return
        parts, names = found
        chosen = np.unique(np.linspace(0, len(history) - 1, min(len(history), 400)).astype(int))
        time = history["time"][chosen]
        chosen = chosen[(history["dt"][chosen] > 0) & (time >= self.options.start) & (time <= self.options.end)]
        for part in np.unique(parts[chosen]):
            rows = chosen[parts[chosen] == part]
            axes.plot(history["time"][rows] * self.x_factor, history["dt"][rows] * factor, ".", markersize=4,
                      color=COLORS[(part + 1) % len(COLORS)] if part >= 0 else GRID,
                      label=f"controlled by {names[part]}" if part >= 0 else "controlling element not known")

    def _finish(self, axes: Any, panel: Panel, unit: str) -> None:
        history = next((h for _, _, h in self.runs if panel.columns[0] in h), self.runs[0][2])
        single = len(panel.columns) == 1
        meaning = history.label(panel.columns[0])
        title = (panel.title if panel.title and not (single and panel.title == panel.columns[0])
                 else meaning if single else "")
        title = title if "(" in title else title[:1].upper() + title[1:]
        axes.set_title(title, loc="left", fontsize=10, fontweight="bold")
        words = "time" if self.options.x == "time" else self.runs[0][2].label(self.options.x)
        axes.set_xlabel(f"{words} [{self.x_unit}]" if self.x_unit else words)
        axes.set_ylabel(f"[{unit}]" if unit else "")
        self._widen_constants(axes)
        for axis in (axes.xaxis, axes.yaxis):
            formatter = ScalarFormatter(useMathText=True)
            formatter.set_powerlimits((-3, 5))
            axis.set_major_formatter(formatter)
        axes.xaxis.set_major_locator(MaxNLocator(MOST_TICKS, steps=[1, 2, 2.5, 5, 10]))
        self._mark_warnings(axes)

    @staticmethod
    def _widen_constants(axes: Any) -> None:
        """Curves that are constant but for round-off are drawn flat, not as noise with an offset at the axis."""
        ends = [(values.min(), values.max()) for line in axes.get_lines()
                if len(values := np.asarray(line.get_ydata(), dtype=float)) and np.isfinite(values).all()]
        if not ends:
            return
        low, high = min(low for low, _ in ends), max(high for _, high in ends)
        size = max(abs(low), abs(high))
        if size > 0 and high - low < ROUND_OFF * size:
            axes.set_ylim(low - FLAT_MARGIN * size, high + FLAT_MARGIN * size)

    def _mark_warnings(self, axes: Any) -> None:
        """A line at the time at which each rule was first found, numbered as in list_marks."""
        if self.options.x != "time":
            return
        low, high = axes.get_xlim()
        groups: list[tuple[float, list[str]]] = []  # numbers that would lie over each other share one label
        for number, (time, _) in enumerate(self.list_marks(), 1):
            place = time * self.x_factor
            if not low <= place <= high:
                continue
            axes.axvline(place, color=MARK, linewidth=0.8, linestyle=(0, (3, 3)))
            if not groups or place - groups[-1][0] > CLOSE_MARKS * (high - low):
                groups.append((place, []))
            groups[-1][1].append(str(number))
        for place, numbers in groups:
            axes.annotate(",".join(numbers), (place, 0.99), xycoords=("data", "axes fraction"), fontsize=7, color=MARK,
                          ha="left", va="top", xytext=(2, 0), textcoords="offset points")

    def list_marks(self) -> list[tuple[float, str]]:
        """[(time, text)] of the warnings that were found in steps, all runs, the first in time first."""
        marks = []
        for label, run, history in self.runs:
            factor = run.units.time[1] / history.units.time[1] if run.units and history.units else 1.0
            for warning in run.warnings:
                if warning.get("time", 0) > 0:
                    where = f" {warning['place']}" if warning.get("place") else ""
                    owner = f" ({label})" if len(self.runs) > 1 else ""
                    marks.append((warning["time"] * factor, f"{warning['rule']}{where}{owner}"))
        return sorted(marks)[:20]


def write_svg(figure: Any) -> str:
    """The figure as the text of an SVG element, to stand in a page."""
    stream = io.StringIO()
    with rc_context(SETTINGS):
        figure.savefig(stream, format="svg", metadata={"Date": None})
    text = stream.getvalue()
    return text[text.index("<svg") :]


def save(figure: Any, path: str, force: bool = False, dpi: int = 110) -> None:
    """Writes a PNG or an SVG, with the mark of percuss plot."""
    form, stream = os.path.splitext(path)[1][1:].lower(), io.BytesIO()
    mark = make_mark("plot")
    with rc_context(SETTINGS):
        figure.savefig(stream, format=form, dpi=dpi,
                       metadata={"Date": None, "Creator": mark} if form == "svg" else {"Software": mark})
    write_file(path, stream.getvalue(), "plot", force)
