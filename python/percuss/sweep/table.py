"""The table of a sweep: a row for each design."""

import csv
import io
import os
from collections.abc import Iterable
from typing import Any

from ..errors import NotResults
from ..files import make_mark
from .outputs import Output, read_outputs
from .study import Result


def name_rules(warnings: Iterable[dict[str, Any]]) -> str:
    """'deep_overlap, part_size': the rules of warnings, each once."""
    return ", ".join(dict.fromkeys(warning["rule"] for warning in warnings))


class Row:
    """inputs {factor: text}, outputs {column: (number, unit)}, and of the run: state, error, warnings (as summary.json
    has them), energy_error, seconds, folder."""

    def __init__(self, result: Result, outputs: list[Output], base: str) -> None:
        self.number, self.inputs, self.state, self.error = (result.design.number, result.design.inputs, result.state,
                                                            result.error)
        self.outputs: dict[str, tuple[float, str]] = {}
        self.energy_error: float | None = None
        self.seconds: float | None = None
        run = result.run
        self.warnings = result.warnings
        self.folder = os.path.relpath(result.folder, base) if result.folder else ""
        if run is None or not run.summary:
            return
        self.energy_error = run.summary["energy"]["error"]
        self.seconds = run.summary["setup_s"] + run.summary["loop_s"]
        if self.state != "completed":
            return
        if not run.has_history:
            raise NotResults(f"{result.folder}: there is no history.csv to compute outputs from "
                             "(output.history of the deck)")
        self.outputs = read_outputs(run, outputs)


class Table:
    """Attributes: rows, inputs (names), outputs {column: unit}."""

    def __init__(self, results: list[Result], outputs: list[Output], base: str) -> None:
        self.rows = [Row(result, outputs, base) for result in results]
        self.inputs = list(dict.fromkeys(name for row in self.rows for name in row.inputs))
        self.outputs = {name: unit for row in self.rows for name, (_, unit) in row.outputs.items()}

    def heading(self) -> list[str]:
        named = [f"{name} [{unit}]" if unit else name for name, unit in self.outputs.items()]
        return ["design", *self.inputs, *named, "state", "energy_error", "seconds", "folder", "error", "warnings"]

    def cells(self, row: Row) -> list[str]:
        """Texts; empty where there is no value."""
        values = [row.outputs[name][0] if name in row.outputs else None for name in self.outputs]
        numbers = ["" if value is None else f"{value:.10g}" for value in values]
        rest = [row.state, *("" if value is None else f"{value:.4g}" for value in (row.energy_error, row.seconds)),
                row.folder, row.error, name_rules(row.warnings)]
        return [str(row.number), *(row.inputs.get(name, "") for name in self.inputs), *numbers, *rest]

    def list_warned(self) -> list[tuple[str, list[int], str]]:
        """[(rule, numbers of the designs that it warns of, text of the first)]."""
        found: dict[str, tuple[list[int], str]] = {}
        for row in self.rows:
            for warning in row.warnings:
                numbers, _ = found.setdefault(warning["rule"], ([], warning["text"]))
                if row.number not in numbers:
                    numbers.append(row.number)
        return [(rule, numbers, text) for rule, (numbers, text) in found.items()]

    def write_csv(self) -> str:
        stream = io.StringIO()
        stream.write(f"# {make_mark('sweep')}\n")
        csv.writer(stream, lineterminator="\n").writerows([self.heading(), *(self.cells(row) for row in self.rows)])
        return stream.getvalue()
