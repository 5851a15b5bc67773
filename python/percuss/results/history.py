"""history.csv as arrays, one a column, with their units and meanings."""

from __future__ import annotations

import copy
import re
from collections.abc import Iterable, Iterator
from typing import Any

import numpy as np

from ..errors import NotResults
from .accelerations import describe, find_acceleration, list_accelerations
from .arrays import Array
from .columns import read_sidecar
from .table import read_rows
from .units import Powers, Units, find_powers, name_quantity

# Columns of every history.
ALWAYS = ("time", "step", "dt", "kinetic", "internal", "hourglass", "contact", "friction", "external", "energy_error",
          "momentum_x", "momentum_y", "momentum_z")


class History:
    """Columns by name: history["kinetic"]. Attributes: names (those of the file, which are also what a loop over the
    history gives), derived (names of the accelerations that follow from its velocities), computed (those of add()),
    units (a Units, or None where the deck has none)."""

    def __init__(self, names: Iterable[str], table: Any, units: Units | None = None,
                 sidecar: dict[str, dict[str, Any]] | None = None) -> None:
        """table [rows][columns]. sidecar: entries of columns.json by name."""
        self.names = list(names)
        self.units = units
        self._sidecar = sidecar or {}
        self.computed: set[str] = set()
        self._deck: History | None = None
        self._columns: dict[str, Array] = dict(zip(self.names,
                                                   np.asarray(table, dtype=float).reshape(-1, len(self.names)).T))
        self._velocities = (list_accelerations(self._columns)
                            if "time" in self._columns and "dt" in self._columns else {})

    @property
    def derived(self) -> list[str]:
        return list(self._velocities)

    @property
    def of_deck(self) -> History:
        """The history in the units of the deck: itself, or what in_units() has converted."""
        return self._deck or self

    @property
    def everything(self) -> list[str]:
        """Names of all columns: of the file, accelerations, computed."""
        return [*self.names, *self.derived, *sorted(self.computed)]

    def __getitem__(self, name: str) -> Array:
        if name not in self._columns and name in self._velocities:
            self._columns[name] = find_acceleration(self["time"], self["dt"], self[self._velocities[name]])
        try:
            return self._columns[name]
        except KeyError:
            raise KeyError(f"there is no column '{name}' "
                           f"(there are {', '.join([*self.names, *self.derived])})") from None

    def __contains__(self, name: object) -> bool:
        return name in self._columns or name in self._velocities

    def __iter__(self) -> Iterator[str]:
        return iter(self.names)

    def __len__(self) -> int:
        """Rows."""
        return len(self._columns[self.names[0]])

    def keys(self) -> list[str]:
        return list(self.names)

    def dimension(self, name: str) -> str | None:
        """'energy', 'force', '-' ... by columns.json; None if it does not have the column."""
        self[name]
        if name in self._velocities:
            return "acceleration"
        given = "time" if name == "time" else self._sidecar.get(name, {}).get("dimension")
        named = name_quantity(given) if given else None
        if named == "energy" and self.units and self._sidecar[name].get("unit") == self.units.name_of("moment"):
            return "moment"  # of the same dimension, but no energy
        return named

    def unit(self, name: str) -> str:
        """'J'; empty without a dimension, or without units in the deck."""
        if "unit" in self._sidecar.get(name, {}):
            return str(self._sidecar[name]["unit"] or "")
        dimension = self.dimension(name)
        if self.units is None or dimension is None or find_powers(dimension) is None:
            return ""
        return self.units.name_of(dimension)

    def meaning(self, name: str) -> str:
        """What the column is, in words of columns.json; its name where the folder has no such file."""
        self[name]
        if name in self._velocities:
            return describe(self.meaning(self._velocities[name]))
        return str(self._sidecar.get(name, {}).get("meaning") or name)

    def label(self, name: str) -> str:
        """The meaning in few words, as it stands beside a curve."""
        return self.meaning(name) if name in self.computed else self.meaning(name).partition(", ")[0]

    def has_given_unit(self, name: str) -> bool:
        """Whether a user has named the unit of a computed column, which then stands as it is: no kN for N."""
        return bool(self._sidecar.get(name, {}).get("given"))

    def at(self, time: float, name: str) -> float:
        """The value of a column at a time, linear between rows."""
        return float(np.interp(time, self["time"], self[name]))

    def add(self, name: str, values: Any, powers: Powers | None = None, unit: str | None = None) -> None:
        """One more column, computed from others. powers: of length, mass and time; None: the dimension is not known.
        unit: of a user, whose dimension is not known."""
        given = unit is not None
        if given:
            powers = None
        elif self.units and powers and any(powers):
            unit = self.units.name_of_powers(powers)
        self.computed.add(name)
        self._columns[name], self._sidecar = (np.asarray(values, dtype=float),
                                              {**self._sidecar, name: {"unit": unit, "meaning": name, "given": given}})
        if powers:
            words = [f"{base}^{power:g}" for base, power in zip(("length", "mass", "time"), powers) if power]
            self._sidecar[name]["dimension"] = " ".join(words) or "1"

    def copy(self) -> History:
        """A copy of the history, to add() to."""
        copied = copy.copy(self)
        copied._columns, copied.computed = dict(self._columns), set(self.computed)
        copied._deck = self._deck and self._deck.copy()
        return copied

    def in_units(self, units: Units) -> History:
        """The history in another system of units. Columns whose dimension is not known stay as they are."""
        if self.units is None:
            raise ValueError("the deck has no `units`, so that its numbers cannot be turned into others")
        table = np.column_stack([self._convert(name, units) for name in self.names])
        kept = {name: {"dimension": self.dimension(name), "meaning": self.meaning(name)} for name in self.names}
        converted = History(self.names, table, units, kept)
        converted._deck = self.of_deck.copy()
        return converted

    def _convert(self, name: str, units: Units) -> Array:
        dimension = self.dimension(name)
        if self.units is None or dimension is None or not find_powers(dimension):
            return self[name]
        return self[name] * (self.units.in_si(dimension) / units.in_si(dimension))

    def to_pandas(self) -> Any:
        """A pandas.DataFrame of the columns of the file with the time as its index; units in its attribute `attrs`."""
        import pandas

        frame = pandas.DataFrame({name: self[name] for name in self.names}).set_index("time")
        frame.attrs["units"] = {name: self.unit(name) for name in self.names}
        return frame

    def followed_by(self, later: History) -> History:
        """This history up to the first row of a restart in another folder, and then that one. Columns of both."""
        names = [name for name in self.names if name in later]
        kept = self["step"] < later["step"][0] if len(later) else np.ones(len(self), dtype=bool)
        table = [np.concatenate([self[name][kept], later[name]]) for name in names]
        return History(names, np.column_stack(table), self.units, self._sidecar)


def _list_partners(names: Iterable[str]) -> Iterator[str]:
    """Columns that stand beside others in every history: the other components of a vector,
    the other force of a weld."""
    for name in names:
        if part := re.fullmatch(r"((?:wall_force|momentum|angular|equal|body)_|joint_[fm]|local_a|local_dv|body_[vw]|"
                                r"[fm])x(:.*)?|([^:]*_v?)x", name):
            head, tail = part[1] or part[3], part[2] or ""
            yield from (f"{head}{axis}{tail}" for axis in "yz")
        if name.startswith("weld_normal:"):
            yield name.replace("normal", "shear", 1)


def read_history(path: str, units: Units | None = None, folder: str | None = None) -> History:
    """A history.csv, complete or of a run that goes on."""
    names, rows = read_rows(path)
    if missing := [name for name in [*ALWAYS, *_list_partners(names)] if name not in names]:
        raise NotResults(f"{path}: there is no column {', '.join(missing)} (every run writes it; "
                         "the file is damaged, or of another program)")
    return History(names, np.array(rows, dtype=float).reshape(len(rows), len(names)), units,
                   read_sidecar(folder) if folder else None)
