"""The curves of a plot as a table, with the numbers that are drawn, in the units of the histories."""

import csv
import io
from itertools import zip_longest

from percuss.files import make_mark, write_file

from .drawing import Plot
from .panels import Panel
from .series import make_curve


def save(plot: Plot, panels: list[Panel], path: str, force: bool = False) -> None:
    """CSV: for each curve its abscissas and its values, side by side."""
    columns = []
    for label, _, history in plot.runs:
        for name in dict.fromkeys(name for panel in panels for name in panel.columns):
            if name not in history:
                continue
            run = f" ({label})" if len(plot.runs) > 1 else ""
            for head, values in zip((plot.options.x, name), make_curve(history, name, plot.options)):
                unit = history.unit(head)
                columns.append([f"{head}{f' [{unit}]' if unit else ''}{run}",
                                *(repr(float(value)) for value in values)])
    stream = io.StringIO()
    stream.write(f"# {make_mark('plot')}\n")
    csv.writer(stream, lineterminator="\n").writerows(zip_longest(*columns, fillvalue=""))
    write_file(path, stream.getvalue(), "plot", force)
