"""columns.json: what the columns of history.csv are. A run writes it; there is no other list of their meanings."""

import json
import os


def read_sidecar(folder):
    """{column: {name, unit, dimension, meaning}} of columns.json; empty where a run has written none."""
    return {entry["name"]: entry for entry in _read_file(folder).get("columns", []) if "name" in entry}


def read_units(folder):
    """The units of the deck as columns.json has them; empty if it has none."""
    return _read_file(folder).get("units") or ""


def _read_file(folder):
    try:
        with open(os.path.join(folder, "columns.json"), encoding="utf-8") as file:
            found = json.load(file)
    except (OSError, ValueError):
        return {}
    return found if isinstance(found, dict) else {"columns": found}
