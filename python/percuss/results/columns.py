"""columns.json: what the columns of history.csv are. A run writes it; there is no other list of their meanings."""

import os
from typing import Any

from ..files import load_json
from .shapes import COLUMNS


def read_sidecar(folder: str) -> dict[str, dict[str, Any]]:
    """{column: {name, unit, dimension, meaning}} of columns.json; empty where a run has written none."""
    return {entry["name"]: entry for entry in _read_file(folder).get("columns", [])}


def read_units(folder: str) -> str:
    """The units of the deck as columns.json has them; empty if it has none."""
    return str(_read_file(folder).get("units") or "")


def has_sensors(folder: str) -> bool:
    """Whether the deck has sensors."""
    return any(name.startswith("sensor:") for name in read_sidecar(folder))


def _read_file(folder: str) -> dict[str, Any]:
    path = os.path.join(folder, "columns.json")
    found: dict[str, Any] = load_json(path, COLUMNS) if os.path.lexists(path) else {}
    return found
