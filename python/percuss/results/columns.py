"""columns.json: what the columns of history.csv are. A run writes it; there is no other list of their meanings."""

import os

from ..files import load_json
from .shapes import COLUMNS


def read_sidecar(folder):
    """{column: {name, unit, dimension, meaning}} of columns.json; empty where a run has written none."""
    return {entry["name"]: entry for entry in _read_file(folder).get("columns", [])}


def read_units(folder):
    """The units of the deck as columns.json has them; empty if it has none."""
    return _read_file(folder).get("units") or ""


def has_sensors(folder):
    """Whether the deck has sensors."""
    return any(name.startswith("sensor:") for name in read_sidecar(folder))


def _read_file(folder):
    path = os.path.join(folder, "columns.json")
    return load_json(path, COLUMNS) if os.path.lexists(path) else {}
