"""Outputs of a run in the table of a sweep: columns of its history and expressions of them."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from percuss.results.run import Run

from ..errors import NotResults
from ..results.expressions import BadExpression, split_label, split_unit
from ..results.extremes import find_size, find_top
from ..results.history import History
from ..results.labels import read_labelled
from ..results.units import find_units

WAYS = ("peak", "mean", "last")
TRIAL_ROWS, TRIAL_STEP = 512, 1e-5  # rows that an output is tried with before a run [s]: time goes up, the rest is 1


class Output:
    """A column or an expression, with a label or not: 'crush = mean(wall_force_z)', 'peak [kN] = max(fz:hit)'. What is
    a number gives one column of the table; what has a value in each row gives three: LABEL.peak (of the largest
    magnitude, with its sign), LABEL.mean (over time), LABEL.last."""

    def __init__(self, text: str) -> None:
        self.word = text
        self.label, self.text = split_label(text)
        self.note = ""  # what the user is told of its unit, when it has been read
        if self.label != self.text:
            self.label = split_unit(self.label)[0]

    def read(self, history: History) -> dict[str, tuple[float, str]]:
        """{column: (number, unit)}. BadExpression where it cannot be computed."""
        value = read_labelled(history, self.word)
        self.note = value.note
        unit = (history.units.name_of_powers(value.powers)
                if history.units and value.powers and any(value.powers) else "")
        unit = unit if value.unit is None else value.unit
        if np.ndim(value.values) == 0:
            return {self.label: (float(value.values), unit)}
        rows, time = np.asarray(value.values, dtype=float), history["time"]
        if not len(rows):
            raise BadExpression(f"'{self.text}' has no row (the history is empty)")
        span = time[-1] - time[0]
        mean = float(np.sum(0.5 * (rows[1:] + rows[:-1]) * np.diff(time)) / span) if span > 0 else float(np.mean(rows))
        numbers = (float(rows[find_top(np.abs(rows))]) if find_size(rows) else 0.0, mean, float(rows[-1]))
        return {f"{self.label}.{way}": (number, unit) for way, number in zip(WAYS, numbers)}


def list_default_outputs(history: History) -> list[Output]:
    """The largest resultant of each force, then the energies at the end."""
    forces = [name.partition(":")[2]
              for name in history if name.startswith("fx:") and name.replace("fx", "fy", 1) in history]
    found = [Output(f"{name} = max(resultant('{name}'))") for name in forces]
    return found + [Output(f"{name} = last({name})") for name in ("kinetic", "internal") if name in history]


def read_outputs(run: Run, outputs: Sequence[Output]) -> dict[str, tuple[float, str]]:
    """{column: (number, unit)} of a run. outputs: empty for those by default."""
    history = run.history
    found = {}
    for output in outputs or list_default_outputs(history):
        found.update(output.read(history))
    return found


def judge_outputs(outputs: Sequence[Output], scene: dict[str, Any]) -> None:
    """BadExpression or NotResults where outputs cannot be computed of the history that a run will write.
    scene: percuss check --json."""
    columns = scene["columns"]
    if not columns:
        raise NotResults(f"{scene['deck']}: runs will write no history.csv to compute outputs from "
                         "(the deck has no output.history): add it")
    table = np.ones((TRIAL_ROWS, len(columns)))
    units, sidecar = find_units(scene["units"]), {column["name"]: column for column in columns}
    table[:, 0] = TRIAL_STEP / (units.time[1] if units else 1) * np.arange(TRIAL_ROWS)
    history = History(sidecar, table, units, sidecar)
    for output in outputs:
        output.read(history)
