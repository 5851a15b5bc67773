"""A run whose numbers are in another system of units than those of its deck."""

from __future__ import annotations

import copy
import itertools
from functools import cached_property
from typing import Any

from .arrays import Array
from .fields import Fields, to_scalar
from .history import History
from .run import Run, describe_limit
from .units import DIMENSIONS, BadUnits, Units, find_units

# Keys of summary.json that have a dimension.
OF_SUMMARY = {"time": "time", "end_time": "time", "dt.min": "time", "dt.max": "time", "dt.last": "time",
              "mass.added": "mass", "mass.in_run": "mass", "mass.energy": "energy", "relaxation.scale": "energy",
              "relaxation.frequency": "frequency", "relaxation.energy": "energy", "relaxation.contact_stored": "energy",
              "energy.initial": "energy", "energy.kinetic": "energy", "energy.internal": "energy",
              "energy.hourglass": "energy", "energy.viscous": "energy", "energy.folding": "energy",
              "energy.contact": "energy", "energy.contact_taken": "energy", "energy.largest": "energy",
              "energy.friction": "energy", "energy.damping": "energy", "energy.external": "energy",
              "momentum.linear": "momentum", "momentum.angular": "angular momentum", "eroded.mass": "mass",
              "eroded.energy": "energy", "eroded.vanished_mass": "mass"}
MOST_POWER = 4  # of length, mass and time in the unit of a field


class Scale:
    """Conversion from one system of units to another."""

    def __init__(self, old: Units, new: Units) -> None:
        self.old, self.new = old, new

    def factor(self, quantity: str) -> float:
        return self.old.in_si(quantity) / self.new.in_si(quantity)

    @cached_property
    def _units(self) -> dict[str, tuple[float, str]]:
        """Units by that in the old system: the factor and the unit in the new one. Names of quantities come first."""
        found: dict[str, tuple[float, str]] = {}
        for quantity in DIMENSIONS:
            if quantity not in ("-", "temperature"):
                found.setdefault(self.old.name_of(quantity), (self.factor(quantity), self.new.name_of(quantity)))
        for powers in itertools.product(range(-MOST_POWER, MOST_POWER + 1), repeat=3):
            if any(powers):
                quantity = f"length^{powers[0]} mass^{powers[1]} time^{powers[2]}"
                found.setdefault(self.old.name_of_powers(powers),
                                 (self.factor(quantity), self.new.name_of_powers(powers)))
        return found

    def convert_unit(self, unit: str) -> tuple[float, str]:
        """(factor, unit of the new system); one that is not known, such as that of a temperature, stays."""
        return self._units.get(unit, (1.0, unit))


class ConvertedFields:
    """The fields of a run in other units; what has none is that of `original`."""

    def __init__(self, original: Fields, scale: Scale) -> None:
        self.original, self._scale = original, scale
        self._length = scale.factor("length")
        self.times = original.times * scale.factor("time")
        self.time_unit = scale.new.name_of("time") if original.time_unit else ""
        self.units = scale.new.text

    def __getattr__(self, name: str) -> Any:
        return getattr(self.original, name)

    def positions(self, frame: int) -> Array:
        return self.original.positions(frame) * self._length

    def data(self, name: str, frame: int) -> Array:
        values = self.original.data(name, frame)
        factor, _ = self._scale.convert_unit(self.original.unit_of(name))
        return values if factor == 1 else values * factor

    def values(self, name: str, frame: int) -> Array:
        return to_scalar(self.data(name, frame))

    def unit_of(self, name: str) -> str:
        return self._scale.convert_unit(self.original.unit_of(name))[1]

    def walls_at(self, frame: int) -> list[tuple[Array, Array, Array | None]]:
        return [(point * self._length, normal, None if edges is None else edges * self._length)
                for point, normal, edges in self.original.walls_at(frame)]

    def round_walls_at(self, frame: int) -> list[tuple[Array, Array | None, float, float | None]]:
        return [(point * self._length, axis, radius * self._length, None if length is None else length * self._length)
                for point, axis, radius, length in self.original.round_walls_at(frame)]


class ConvertedRun:
    """The run in other units. The deck, and texts that the run has written, stay in those of the deck."""

    def __init__(self, original: Run, units: Units) -> None:
        if original.units is None:
            raise _refuse(original.folder)
        self.original, self.units = original, units
        self._scale = Scale(original.units, units)

    def __getattr__(self, name: str) -> Any:
        return getattr(self.original, name)

    @cached_property
    def history(self) -> History:
        return self.original.history.in_units(self.units)

    @cached_property
    def fields(self) -> ConvertedFields:
        return ConvertedFields(self.original.fields, self._scale)

    @cached_property
    def summary(self) -> dict[str, Any]:
        converted = copy.deepcopy(self.original.summary)
        for key, quantity in OF_SUMMARY.items():
            *groups, last = key.split(".")
            place = converted
            for group in groups:
                place = place.get(group, {})
            value, factor = place.get(last), self._scale.factor(quantity)
            if isinstance(value, list):
                place[last] = [x * factor if isinstance(x, (int, float)) else x for x in value]
            elif isinstance(value, (int, float)) and not isinstance(value, bool):
                place[last] = value * factor
        for entry in [*converted.get("warnings", []), *converted.get("sensors", [])]:
            if isinstance(entry.get("time"), (int, float)):
                entry["time"] *= self._scale.factor("time")
        return converted

    @property
    def step_limit(self) -> str:
        return describe_limit(self.original.status, self.summary)

    @property
    def warnings(self) -> list[dict[str, Any]]:
        return list(self.summary.get("warnings", []))


def _refuse(path: str) -> BadUnits:
    return BadUnits(f"{path}: the deck names no units, and its numbers cannot be converted (--units): "
                    "add `units` to the deck and run it again")


def convert_run(run: Run, system: str | None) -> Any:
    """The run in a system of units such as 'mm, kg, ms'; the run itself if its deck has these or none are given."""
    units = Units(system) if system else None
    if units is None or run.units and run.units.text == units.text:
        return run
    return ConvertedRun(run, units)


def convert_fields(fields: Fields, system: str | None) -> Any:
    """As convert_run(), of fields alone."""
    old, new = find_units(fields.units), Units(system) if system else None
    if new is None or old and old.text == new.text:
        return fields
    if old is None:
        raise _refuse(fields.path)
    return ConvertedFields(fields, Scale(old, new))
