"""Tables of energies and forces for the terminal: percuss info DIR --energies --forces."""

from collections.abc import Iterator, Sequence

import numpy as np

from percuss.results.arrays import Array
from percuss.results.extremes import find_top
from percuss.results.history import History
from percuss.results.run import Run

from .forces import describe_kind, find_force, find_impulse, list_forces

Rows = tuple[tuple[str, ...], list[tuple[str, ...]]]  # heading, rows
ENERGIES = ("kinetic", "internal", "hourglass", "viscous", "folding", "contact", "friction", "damping", "external",
            "eroded_energy", "contact_stored", "added_energy", "spring_work", "damper_work", "glue_work",
            "glue_dissipated", "weld_work", "equal_work")
OF_PARTS = ("kinetic", "internal", "hourglass", "viscous", "folding", "eroded_energy")


def list_energies(run: Run, history: History) -> Rows:
    """(heading, rows): of the scene, then of parts and blocks."""
    names = [name for name in ENERGIES if name in history]
    names += [name for name in history if name.partition(":")[0] in OF_PARTS and ":" in name]
    names += [name for name in history if name.startswith(("contact:", "friction:", "body_kinetic:"))]
    rows: list[tuple[str, ...]] = []
    for name in names:
        values = history[name]
        if not np.isfinite(values).any():
            continue
        least, most = find_top(-values), find_top(values)
        rows.append((name, _show(values[0]), _show(values[-1]), _show(values[least]), _show(history["time"][least]),
                     _show(values[most]), _show(history["time"][most]), history.unit(name)))
    if "energy_error" in history and np.isfinite(history["energy_error"]).any():
        error = history["energy_error"]
        least, most = find_top(-error), find_top(error)
        rows.append(("energy_error", _show(error[0]), _show(error[-1]), _show(error[least]),
                     _show(history["time"][least]), _show(error[most]), _show(history["time"][most]), ""))
    return ("energy", "first", "last", "smallest", "at time", "largest", "at time", "unit"), rows


def list_forces_in_rows(run: Run, history: History) -> Rows:
    """(heading, rows). Forces of output.history.forces are means between rows, whose impulse is exact; of the others it
    is the integral of values of single steps, and marked."""
    rows = []
    for name in list_forces(history):
        force = find_force(history, name)
        rows.append(_row(history, name, describe_kind(run, name), force, find_impulse(history, name), ""))
    for name, kind, force in _list_vectors(history):
        rows.append(_row(history, name, kind, force, _integrate(history["time"], force), "~"))
    unit = history.unit(next((name for name in history if history.dimension(name) == "force"), "time")) if rows else ""
    heading = ("force", "of", f"largest{f' [{unit}]' if unit else ''}", "at time", "impulse x", "y", "z",
               "mean", "last")
    return heading, rows


def _list_vectors(history: History) -> Iterator[tuple[str, str, Array]]:
    """[(name, kind, [rows][3 or 1])] of what has a value of each step alone."""
    if "wall_force_x" in history:
        yield "wall_force", "all walls", _stack(history, "wall_force_{}")
    for head, kind in (("joint_f{}:", "joint"), ("equal_{}:", "constraint")):
        start = head.format("x")
        for name in [column[len(start):] for column in history if column.startswith(start)]:
            yield name, kind, _stack(history, head + name)
    for start, kind in (("spring_force:", "spring"), ("equation:", "equation"), ("weld_normal:", "weld, normal"),
                        ("weld_shear:", "weld, shear")):
        for name in [column[len(start):] for column in history if column.startswith(start)]:
            yield name, kind, history[start + name][:, None]


def _stack(history: History, pattern: str) -> Array:
    return np.stack([history[pattern.format(axis)] if pattern.format(axis) in history else np.zeros(len(history))
                     for axis in "xyz"], axis=1)


def _integrate(time: Array, force: Array) -> Array:
    return np.asarray((0.5 * (force[1:] + force[:-1]) * np.diff(time)[:, None]).sum(axis=0))


def _row(history: History, name: str, kind: str, force: Array, impulse: Array, mark: str) -> tuple[str, ...]:
    size = np.linalg.norm(force, axis=1)
    size = np.where(np.isfinite(size), size, 0)
    top, span = int(np.argmax(size)), history["time"][-1] - history["time"][0]
    mean = np.linalg.norm(impulse) / span if span > 0 else 0.0
    shown = [mark + _show(value) for value in impulse] + [""] * (3 - len(impulse))
    return name, kind, _show(size[top]), _show(history["time"][top]), *shown, _show(mean), _show(size[-1])


def _show(value: float) -> str:
    return f"{value:.5g}"


def write_table(heading: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Columns of equal width; the first two and the last at the left where they are words."""
    cells = [heading, *rows]
    widths = [max(len(str(row[column])) for row in cells) for column in range(len(heading))]

    def is_word(column: int) -> bool:
        return column == 0 or heading[column] in ("of", "unit")

    lines = ["  ".join(str(cell).ljust(width) if is_word(column) else str(cell).rjust(width)
                       for column, (cell, width) in enumerate(zip(row, widths))).rstrip() for row in cells]
    return "\n".join("  " + line for line in lines)
