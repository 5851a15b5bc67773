"""A measured curve from a CSV file, with its corridor: drawn beside those of runs, which are rated against it."""

import re
from typing import Any

import numpy as np

from percuss.errors import NotResults
from percuss.files import read_text
from percuss.results.arrays import Array
from percuss.results.rating import find_share_inside, rate

INK, FILL = "#111111", "#d5d9de"


class Measured:
    """Attributes: label, x, y, low, high (the last two None without a corridor), in the units of the histories."""

    def __init__(self, path: str) -> None:
        """The first two columns of the file, or those of a heading x, y, low, high;
        with four the others are the corridor."""
        self.label = re.sub(r".*/", "", path)
        names, table = _read_table(path)
        order = [names.index(name) for name in ("x", "y", "low", "high") if name in names]
        if order[:2] == [] or "x" not in names or "y" not in names:
            order = list(range(min(4, table.shape[1])))
        if len(order) not in (2, 4):
            raise NotResults(f"{path}: a test has two columns, abscissa and value, or four: x, y, low, high "
                             f"({table.shape[1]} were found)")
        self.x, self.y = table[:, order[0]], table[:, order[1]]
        self.low, self.high = (table[:, order[2]], table[:, order[3]]) if len(order) == 4 else (None, None)

    def draw(self, axes: Any, x_factor: float, factor: float) -> None:
        if self.low is not None and self.high is not None:
            axes.fill_between(self.x * x_factor, self.low * factor, self.high * factor, color=FILL, linewidth=0,
                              label="corridor")
        axes.plot(self.x * x_factor, self.y * factor, color=INK, linewidth=1.6, label=self.label)

    def judge(self, x: Array, values: Array, is_of_time: bool) -> list[str]:
        """Sentences about a curve."""
        texts = []
        if is_of_time:
            found = rate(self.x, self.y, x, values)
            parts = ", ".join(f"{name} {found[name]:.3f}" for name in ("corridor", "phase", "magnitude", "slope"))
            texts.append(f"rating {found['rating']:.3f} of 1 by ISO/TS 18571 ({parts})")
        if self.low is not None and self.high is not None:
            inside = (x >= self.x.min()) & (x <= self.x.max())
            order = np.argsort(self.x, kind="stable")
            low, high = (np.interp(x[inside], self.x[order], side[order]) for side in (self.low, self.high))
            texts.append(f"{100 * find_share_inside(low, high, values[inside]):.3g} % of its points are within the "
                         "corridor of the test")
        if not texts:
            texts.append("there is no rating (ISO/TS 18571 is for signals over time, and the test has no corridor)")
        return texts


def _read_table(path: str) -> tuple[list[str], Array]:
    """(names of the columns, or [], [rows][columns]). Columns are separated by commas, semicolons, tabs or blanks."""
    names: list[str] = []
    rows: list[list[float]] = []
    for number, line in enumerate(read_text(path).lstrip("\ufeff").splitlines(), 1):
        words = [word.strip().strip('"') for word in re.split(r"[;,\t]|\s+", line.strip()) if word.strip()]
        if not words or words[0].startswith("#"):
            continue
        try:
            rows.append([float(word) for word in words])
        except ValueError:
            if rows or names:
                raise NotResults(f"{path}:{number}: this is no row of numbers: '{line[:60]}'") from None
            names = [word.lower() for word in words]
            continue
        if len(rows[-1]) != len(rows[0]) or not np.isfinite(rows[-1]).all():
            raise NotResults(f"{path}:{number}: this row has not {len(rows[0])} finite numbers, "
                             f"as those before: '{line[:60]}'")
    if len(rows) < 2:
        raise NotResults(f"{path}: a test needs two rows of numbers at least")
    return names, np.array(rows)
