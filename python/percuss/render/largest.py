"""The largest value of what a picture shows: where it is, and in words."""

import numpy as np

from percuss.results.arrays import Array
from percuss.results.fields import Fields

from .coloring import Coloring


def find_largest(fields: Fields, name: str, frame: int, drawn: Array) -> tuple[int | None, float]:
    """(item, value) of a field in the elements that are drawn, or their nodes;
    (None, 0) where nothing is finite or all are zero."""
    values = fields.values(name, frame)
    items = np.flatnonzero(drawn) if fields.names()[name] == "element" else np.unique(fields.hexahedra[drawn])
    items = items[np.isfinite(values[items])]
    if not values[items].any():
        return None, 0.0
    item = int(items[np.argmax(values[items])])
    return item, float(values[item])


class Largest:
    """The largest value of a frame. Attributes: value (unit of the file), point [3] (None where find_largest has none),
    text ('element 12 of part 'plate'')."""

    def __init__(self, fields: Fields, coloring: Coloring, frame: int, drawn: Array) -> None:
        self.point: Array | None = None
        self.text = ""
        item, self.value = find_largest(fields, coloring.name, frame, drawn)
        if item is None:
            return
        positions = fields.positions(frame)
        if coloring.place == "element":
            self.point = positions[np.unique(fields.hexahedra[item])].mean(axis=0)
            self.text = f"element {fields.element_ids[item]} of part '{fields.part_names[fields.part[item]]}'"
        else:
            self.point, self.text = positions[item], f"node {fields.node_ids[item]}"


def format_value(value: float, coloring: Coloring) -> str:
    """'412 MPa'"""
    return f"{value * coloring.factor:.4g} {coloring.unit}".rstrip()
