"""Outputs of a run in the table of a sweep: columns of its history and expressions of them."""

from ..results.expressions import BadExpression, compute, split_label, split_unit
from ..results.extremes import find_size, find_top

WAYS = ("peak", "mean", "last")


class Output:
    """A column or an expression, with a label or not: 'crush = mean(wall_force_z)', 'peak [kN] = max(fz:hit) / 1000'. What is a number gives one column of the table;
    what has a value in each row gives three: LABEL.peak (of the largest magnitude, with its sign), LABEL.mean (over time), LABEL.last."""

    def __init__(self, text):
        self.label, self.text = split_label(text)
        self.unit = None  # that of the label; None: what follows from the columns
        if self.label != self.text:
            self.label, self.unit = split_unit(self.label)

    def read(self, history):
        """{column: (number, unit)}. BadExpression where it cannot be computed."""
        import numpy as np

        value = compute(history, self.text)
        unit = history.units.name_of_powers(value.powers) if history.units and value.powers and any(value.powers) else ""
        unit = unit if self.unit is None else self.unit
        if np.ndim(value.values) == 0:
            return {self.label: (float(value.values), unit)}
        rows, time = np.asarray(value.values, dtype=float), history["time"]
        if not len(rows):
            raise BadExpression(f"'{self.text}' has no row (the history is empty)")
        span = time[-1] - time[0]
        mean = float(np.sum(0.5 * (rows[1:] + rows[:-1]) * np.diff(time)) / span) if span > 0 else float(np.mean(rows))
        numbers = (float(rows[find_top(np.abs(rows))]) if find_size(rows) else 0.0, mean, float(rows[-1]))
        return {f"{self.label}.{way}": (number, unit) for way, number in zip(WAYS, numbers)}


def list_default_outputs(history):
    """The largest resultant of each force, then the energies at the end."""
    forces = [name.partition(":")[2] for name in history if name.startswith("fx:") and name.replace("fx", "fy", 1) in history]
    found = [Output(f"{name} = max(resultant('{name}'))") for name in forces]
    return found + [Output(f"{name} = last({name})") for name in ("kinetic", "internal") if name in history]


def read_outputs(run, outputs):
    """{column: (number, unit)} of a run. outputs: empty for those by default."""
    history = run.history
    found = {}
    for output in outputs or list_default_outputs(history):
        found.update(output.read(history))
    return found
