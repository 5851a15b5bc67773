"""Forces of a run: their peaks and impulses, and whether impulses and momenta,
and pairs and their sum, are in balance."""

from typing import Any

import numpy as np

from percuss.results.arrays import Array
from percuss.results.deck import Deck
from percuss.results.extremes import find_size, find_top
from percuss.results.history import History
from percuss.results.run import Run
from percuss.results.units import choose_time_unit

from .markup import make_table, show_value

ROUND_OFF = 1e-9  # relative: what the shortest texts of numbers leave is below


def list_forces(history: History) -> list[str]:
    """Names of output.history.forces, in the order of their columns."""
    return [name[3:] for name in history if name.startswith("fx:")]


def find_force(history: History, name: str) -> Array:
    """[rows][3]: means over the time since the row before."""
    return np.stack([np.asarray(history[f"f{axis}:{name}"]) for axis in "xyz"], axis=1)


def find_impulse(history: History, name: str) -> Array:
    """[3]: exactly the momentum exchanged between the first row and the last."""
    force = find_force(history, name)
    return np.asarray((force[1:] * np.diff(history["time"])[:, None]).sum(axis=0))


def describe_kind(run: Run, name: str) -> str:
    """'contact of a with b', as the deck has it; empty where it is not known."""
    for force in run.deck.get_list("output.history.forces"):
        if isinstance(force, dict) and force.get("name") == name:
            for kind in ("contact", "wall", "support", "section"):
                if kind in force:
                    return f"{kind} {_name(force[kind])}"
    return ""


def _name(value: Any) -> str:
    if isinstance(value, dict):
        return ", ".join(f"{key} {_name(item)}" for key, item in value.items())
    if isinstance(value, list):
        return " and ".join(_name(item) for item in value)
    return str(value)


def make_forces_table(run: Run) -> str:
    """A row for each force: largest resultant and its time, impulse, mean, and of contact and walls the largest normal
    force, area and pressure."""
    history = run.history
    names = list_forces(history)
    if not names or len(history) < 2:
        return ""
    force_unit, time_unit = history.unit(f"fx:{names[0]}"), history.unit("time")
    shown_unit, factor = choose_time_unit(time_unit, float(history["time"][-1]))
    rows = []
    for name in names:
        size = np.linalg.norm(find_force(history, name), axis=1)
        size = np.where(np.isfinite(size), size, 0)
        top = int(np.argmax(size))
        impulse = find_impulse(history, name)
        mean = np.linalg.norm(impulse) / (history["time"][-1] - history["time"][0])
        rows.append((name, describe_kind(run, name), show_value(size[top], force_unit),
                     show_value(history["time"][top] * factor, shown_unit),
                     "(" + ", ".join(f"{x:.4g}" for x in impulse) + ")", show_value(mean, force_unit),
                     *(_show_peak(history, f"{quantity}:{name}") for quantity in ("normal", "area", "pressure"))))
    unit = f" [{force_unit} {time_unit}]" if force_unit else ""
    heading = ("force", "of", "largest resultant", "at", f"impulse{unit}", "mean", "largest normal force",
               "largest area", "largest pressure")
    text = "<h3>Forces</h3>" + make_table(heading, rows, (2, 3, 5, 6, 7, 8))
    return text + ("<p class=soft>Means over the time between rows: no impulse is lost, and a peak shorter than that "
                   "time is averaged. The impulse is the momentum exchanged over the whole run. Area and pressure are "
                   "of the nodes that are pushed; the pressure is that of the node with the most.</p>")


def _show_peak(history: History, column: str) -> str:
    """The largest value; nothing where there is no such column, or none in it."""
    if column not in history or not np.any(np.isfinite(history[column])):
        return ""
    return show_value(find_size(history[column]), history.unit(column))


Balance = tuple[str, float, float, float, str]  # the last: a column, or words


def have_sets_masses(deck: Deck) -> bool:
    """Whether rigid_sets bring mass or inertia, which no part has."""
    sets = deck.get("rigid_sets")
    return (isinstance(sets, dict)
            and any(isinstance(one, dict) and (one.get("mass") or one.get("inertia")) for one in sets.values()))


def find_balances(history: History, sets_have_masses: bool = False) -> list[Balance]:
    """[(what, sum of the shares, the whole, difference over the largest magnitude, column)] of what must add up: the
    work of all pairs of contact; energies, momenta of all parts, where there is a column for each. sets_have_masses:
    rigid_sets bring masses, which are in no part."""
    found: list[Balance] = []
    for whole in ("contact", "friction"):
        _add(found, history, whole, f"work of {whole} by all pairs", [n for n in history if n.startswith(f"{whole}:")])
    blocks = {name for name in history if " of block '" in history.meaning(name)}  # of which parts consist
    # Work between parts and from outside is in no part, and removed nodes are in none.
    if "vanished_mass" not in history:
        for whole in ("internal",) if sets_have_masses else ("kinetic", "internal", "momentum_x", "momentum_y",
                                                             "momentum_z"):
            _add(found, history, whole, f"{whole.replace('_', ' ')} of all parts",
                 [n for n in history if n.startswith(f"{whole}:") and n not in blocks])
    return found


def _add(found: list[Balance], history: History, whole: str, what: str, shares: list[str]) -> None:
    """Adds the balance of the row in which they differ most."""
    if not shares or whole not in history:
        return
    total = np.sum([np.asarray(history[name]) for name in shares], axis=0)
    largest = max(find_size(history[name]) for name in [whole, *shares])
    if whole.startswith("momentum"):  # of the vector, so that round-off of a component that is zero does not count
        largest = max([largest] + [find_size(history[f"momentum_{axis}"]) for axis in "xyz"])
    if not largest > 0:
        return
    difference = np.abs(total - history[whole])
    row = find_top(difference)
    found.append((what, float(total[row]), float(history[whole][row]), float(difference[row]) / largest, whole))


def make_balance_table(run: Run) -> str:
    rows = []
    for what, total, whole, difference, column in find_balances(run.history, have_sets_masses(run.deck)):
        unit = run.history.unit(column)
        verdict = "in balance" if difference <= ROUND_OFF else "not the same: not every share has a column"
        rows.append((what, show_value(total, unit), show_value(whole, unit), f"{difference:.2g}", verdict))
    unit = run.history.unit("momentum_x") if "momentum_x" in run.history else ""
    rows += [(f"impulse of {name}", show_value(size, unit), show_value(change, unit), f"{difference:.2g}", verdict)
             for name, size, change, difference, verdict in find_momentum_balances(run)]
    if not rows:
        return ""
    heading = ("sum", "of the shares", "of the whole", "difference", "")
    return "<h3>Balances</h3>" + make_table(heading, rows, (1, 2, 3)) + \
        "<p class=soft>Of the row with the largest difference, which is a share of the largest magnitude.</p>"


def find_momentum_balances(run: Run) -> list[Balance]:
    """[(force, impulse, change of momentum, difference, words)] of each contact force on parts from all others, whose
    momenta are in the history: they are the same where nothing else acts on the parts. Magnitudes of vectors."""
    history, found = run.history, []
    others = "supports, loads and masses of rigid_sets" if have_sets_masses(run.deck) else "supports and loads"
    for name in list_forces(history):
        parts = _list_parts_acted_on(run, name)
        if not parts or not all(f"momentum_x:{part}" in history for part in parts):
            continue
        change = sum(_find_change_of_momentum(history, part) for part in parts)
        impulse = find_impulse(history, name)
        largest = max(np.linalg.norm(impulse), np.linalg.norm(change))
        if not largest > 0:
            continue
        difference = float(np.linalg.norm(impulse - change) / largest)
        verdict = "in balance" if difference <= ROUND_OFF else f"the rest is of {others}"
        found.append((name, float(np.linalg.norm(impulse)), float(np.linalg.norm(change)), difference, verdict))
    return found


def _find_change_of_momentum(history: History, part: str) -> Array:
    """[3] between the first row and the last."""
    columns = [history[f"momentum_{axis}:{part}"] for axis in "xyz"]
    return np.array([column[-1] - column[0] for column in columns])


def _list_parts_acted_on(run: Run, name: str) -> list[str]:
    for force in run.deck.get_list("output.history.forces"):
        if isinstance(force, dict) and force.get("name") == name and "contact" in force:
            pair = force["contact"]
            if isinstance(pair, list) and len(pair) == 2 and pair[1] == "all":
                return pair[0] if isinstance(pair[0], list) else [pair[0]]
    return []
