"""Plots the history of percuss runs: PNG and SVG. percuss plot --help says how."""

from __future__ import annotations

import argparse
import os
import sys
from typing import TYPE_CHECKING, NoReturn

from percuss.help_format import HelpFormatter
from percuss.libraries import require
from percuss.terminal import fail as end

if TYPE_CHECKING:
    from percuss.plot.drawing import Drawn, Plot
    from percuss.plot.measured import Measured
    from percuss.plot.panels import Panel
    from percuss.results.run import Run

NEEDS = ("numpy", "h5py", "matplotlib")
ENDINGS = (".png", ".svg", ".csv")
OTHER_ENDINGS = (".pdf", ".eps", ".ps", ".jpg", ".jpeg", ".gif", ".tif", ".tiff", ".bmp", ".webp", ".txt", ".dat",
                 ".xls", ".xlsx", ".html")
EPILOG = """\
WHAT is drawn, a panel for each word. By default these are energies, their
error, momentum, forces, the time step with the part that controls it, contact
and its penetration:
  a panel    energies, energy_error, momentum, forces, step, contact,
             penetration, iterations, contact_pairs, kinetic_by_part,
             internal_by_part, erosion, angular
  a column   of history.csv, such as kinetic; --list names those of a run;
             =contact where a panel has its name
  a pattern  'f?:impact' overlays all columns that match
  several    kinetic,internal overlays both
  an expression of columns, with a label or not, as in
             'crush = integral(wall_force_z, top_z) / 1e3'

An expression may have:
  + - * / ** ( ) abs sqrt exp log sin cos tan min max
  first last change mean norm
  integral(y, x) and derivative(y, x), over time without x
  resultant('hit'), of fx:hit, fy:hit, fz:hit
  distance('a', 'b') of two history nodes
  cfc(y, 600)

Warnings of the run are dashed lines at the time at which they were first found,
with numbers; their names are printed. Curves of several folders are overlaid,
each run in a style of its own.

Examples:
  percuss plot ball                         ball/plot.png and ball/plot.svg
  percuss plot ball ball_fine energies step  two runs overlaid
  percuss plot ball 'f?:impact' --to 1e-4   the start only
  percuss plot can wall_force_z --cfc 600   filtered according to SAE J211
  percuss plot ball --units 'mm, kg, ms'    kN, GPa and J
  percuss plot box wall_force_z --x top_z   force over displacement
  percuss plot ball --list                  columns with their units, meanings

Exit codes:
  0    done
  2    a folder, a column or an option is wrong, or a library is missing

Needs Python 3 with NumPy and Matplotlib, and h5py for units and parts:
scripts/install_dependencies --report installs them.
docs/results.md describes plots, docs/output.md the columns.
"""


def parse_arguments(words: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="percuss plot", epilog=EPILOG, formatter_class=HelpFormatter,
        description="Plot columns of history.csv for one or more runs, to plot.png and plot.svg.")
    add = parser.add_argument
    add("words", metavar="DIR|WHAT", nargs="+",
        help="output folders of runs, complete or under way; any other word says what to plot")
    add("--out", metavar="FILE", help="the picture, .png or .svg, or the curves as .csv; "
                                      "without an ending PNG and SVG (default: plot in the first DIR)")
    add("--x", metavar="COLUMN", default="time", help="the abscissa: a column or an expression (default: time)")
    add("--test", metavar="FILE",
        help="a measured curve (CSV: x, y and, if there is a corridor, low and high) in the units of the deck, "
             "or of --units; runs are rated against it by ISO/TS 18571. For one curve")
    add("--cfc", metavar="CLASS", type=int, choices=(60, 180, 600, 1000), default=0,
        help="filter all columns by a channel frequency class of SAE J211: 60, 180, 600 or 1000 "
             "(without shift of phase)")
    add("--cfc-after", metavar="CLASS", type=int, choices=(60, 180, 600, 1000), default=0,
        help="the same of what expressions give")
    add("--units", metavar="SYSTEM",
        help="convert to a system of units, such as 'mm, kg, ms' (default: that of the deck)")
    add("--from", dest="start", metavar="TIME", type=float, default=float("-inf"),
        help="start of the time range, in these units")
    add("--to", dest="end", metavar="TIME", type=float, default=float("inf"), help="end of the time range")
    add("--size", metavar="WxH", type=parse_size, help="size of the PNG in pixels (default: by the number of panels)")
    add("-f", "--force", action="store_true",
        help="write over a file that percuss plot has not written; never over results of a run")
    add("--list", action="store_true", help="list the columns of each run with unit and meaning; plot nothing")
    return parser.parse_intermixed_args(words)  # options may stand between folders and curves


def parse_size(text: str) -> tuple[float, float]:
    try:
        width, height = (int(word) for word in text.lower().split("x"))
    except ValueError:
        width = height = 0
    if not (200 <= width <= 8192 and 150 <= height <= 8192):
        raise argparse.ArgumentTypeError(f"'{text}' is not a size of 200x150 to 8192x8192")
    return width, height


def fail(message: object) -> NoReturn:
    end("plot", message)


def list_columns(run: Run) -> None:
    from percuss.terminal import print_text

    history = run.history
    names = [*history, *history.derived]
    width = max(map(len, names))
    print_text(f"{run.folder}: {len(history)} rows")
    for name in names:
        print_text(f"  {name:{width}}  {history.unit(name) or '-':10}  {history.meaning(name)}")


def choose_files(out: str | None, run: Run) -> list[str]:
    out = out or os.path.join(run.folder, "plot")
    ending = os.path.splitext(out)[1]
    if ending in ENDINGS:
        return [out]
    if ending.lower() in OTHER_ENDINGS or ending.lower() in ENDINGS:
        raise ValueError(f"plots are written as .png, .svg or .csv, not {ending}: another program converts .svg")
    return [out + ".png", out + ".svg"]


def plot(arguments: argparse.Namespace, runs: list[Run], words: list[str]) -> None:
    from percuss.files import check_target
    from percuss.plot import drawing, table
    from percuss.plot.measured import Measured
    from percuss.plot.panels import choose_panels, list_panels
    from percuss.plot.series import Options, add_expressions, choose_abscissa, prepare_history
    from percuss.results.run import label_runs
    from percuss.results.units import Units
    from percuss.terminal import print_text

    paths = choose_files(arguments.out, runs[0])
    for path in paths:
        check_target(path, "plot", arguments.force)
    options = Options(arguments.cfc, arguments.cfc_after, "time", Units(arguments.units) if arguments.units else None,
                      arguments.start, arguments.end)
    labels = label_runs(runs)
    histories = [prepare_history(run, options) for run in runs]
    known = list_panels(histories)
    words = add_expressions(words, histories, options, known)
    options.x = choose_abscissa(arguments.x, histories, options)
    for note in options.notes:
        print_text(f"plot: {note}", sys.stderr)
    panels = choose_panels(words, histories)
    shown = drawing.Plot(list(zip(labels, runs, histories)), options)
    if arguments.test:
        shown.test = Measured(arguments.test)
        print_ratings(shown.test, shown, panels)
    warn_of_short_signals(shown.runs, arguments.cfc or arguments.cfc_after)
    title = " / ".join(dict.fromkeys(run.title for run in runs)) + (f" (CFC {arguments.cfc})" if arguments.cfc else "")
    size = (arguments.size[0] / 110, arguments.size[1] / 110) if arguments.size else None
    if not paths[0].endswith(".csv"):
        figure = shown.draw_all(panels, size, title)
        for number, (time, text) in enumerate(shown.list_marks(), 1):
            print_text(f"plot: warning {number} at {time:.4g}: {text}")
    for path in paths:
        if path.endswith(".csv"):
            table.save(shown, panels, path, arguments.force)
        else:
            drawing.save(figure, path, arguments.force)
        print_text(f"plot: {path}")


def print_ratings(test: Measured, shown: Plot, panels: list[Panel]) -> None:
    from percuss.plot.series import make_curve
    from percuss.terminal import print_text

    if len(panels) != 1 or len(panels[0].columns) != 1:
        raise ValueError("--test is for one curve: name one column or one expression")
    for label, _, history in shown.runs:
        for text in test.judge(*make_curve(history, panels[0].columns[0], shown.options), shown.options.x == "time"):
            print_text(f"plot: {label} against {test.label}: {text}")


def warn_of_short_signals(shown: list[Drawn], channel_class: int) -> None:
    from percuss.plot.series import is_too_short
    from percuss.terminal import print_text

    for label, _, history in shown if channel_class else ():
        if is_too_short(history, channel_class):
            print_text(f"plot: {label}: the signal is shorter than one period of the cut-off frequency of CFC "
                       f"{channel_class} (the filter hides the event): use a higher class, or none", sys.stderr)


def main(words: list[str]) -> None:
    arguments = parse_arguments(words)
    require("plots need", NEEDS)
    import percuss
    from percuss.plot.panels import BadChoice

    folders = [word for word in arguments.words if os.path.isdir(word)]
    words = [word for word in arguments.words if word not in folders]
    if not folders:
        fail(f"there is no folder among {', '.join(arguments.words)} (the output folder of a run is needed)")
    try:
        runs = [percuss.Run(folder) for folder in folders]
        if arguments.list:
            for run in runs:
                list_columns(run)
        else:
            plot(arguments, runs, words)
    except (percuss.NotResults, BadChoice, ValueError) as error:
        fail(error)
    except OSError as error:
        fail(f"cannot write the plot ({error})")
