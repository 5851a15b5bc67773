"""Nodes and elements of a frame as tables of comma-separated values."""

import csv
import io
from collections.abc import Sequence
from typing import Any

import numpy as np

from percuss.results.fields import Fields

from ..files import make_mark
from .selection import Selection, name_components


def write_tables(selection: Selection, frame: int) -> dict[str, str]:
    """{'nodes': text, 'elements': text}. Headings have units in brackets."""
    fields = selection.fields
    heads = {"node": ["node_id", *_name_positions(fields)], "element": ["element_id", "part"]}
    columns = {"node": [fields.node_ids, *fields.positions(frame).T],
               "element": [fields.element_ids, [fields.part_names[part] for part in fields.part]]}
    for name, place in selection.names.items():
        values = np.asarray(selection.data(name, frame))
        values = values.reshape(len(values), -1)
        unit = fields.unit_of(name)
        heads[place] += [f"{word} [{unit}]" if unit else word for word in name_components(name, values.shape[1])]
        columns[place] += list(values.T)
    time = f"# {make_mark('export')}; t = {float(fields.times[frame])!r} {fields.time_unit}".rstrip() + "\n"
    return {"nodes": time + _write(heads["node"], columns["node"]),
            "elements": time + _write(heads["element"], columns["element"])}


def _name_positions(fields: Fields) -> list[str]:
    unit = fields.unit_of("displacement") if "displacement" in fields.names() else ""
    return [f"{axis} [{unit}]" if unit else axis for axis in "xyz"]


def _write(heading: Sequence[str], columns: list[Any]) -> str:
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(heading)
    writer.writerows(zip(*(values if isinstance(values, list) else values.tolist() for values in columns)))
    return stream.getvalue()
