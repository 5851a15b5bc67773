"""The largest value of what a picture shows: where it is, and in words."""

import numpy as np


def find_largest(fields, name, frame, drawn):
    """(item, value) of a field in the elements that are drawn, or their nodes;
    (None, None) where nothing is finite or all are zero."""
    values = fields.values(name, frame)
    items = np.flatnonzero(drawn) if fields.names()[name] == "element" else np.unique(fields.hexahedra[drawn])
    items = items[np.isfinite(values[items])]
    if not values[items].any():
        return None, None
    item = int(items[np.argmax(values[items])])
    return item, float(values[item])


class Largest:
    """Of a frame. Attributes: value (in the unit of the file;
    None where find_largest finds none), point [3], text ('element 12 of part 'plate'')."""

    def __init__(self, fields, coloring, frame, drawn):
        self.value, self.point, self.text = None, None, ""
        item, value = find_largest(fields, coloring.name, frame, drawn)
        if item is None:
            return
        self.value = value
        positions = fields.positions(frame)
        if coloring.place == "element":
            self.point = positions[np.unique(fields.hexahedra[item])].mean(axis=0)
            self.text = f"element {fields.element_ids[item]} of part '{fields.part_names[fields.part[item]]}'"
        else:
            self.point, self.text = positions[item], f"node {fields.node_ids[item]}"


def format_value(value, coloring):
    """'412 MPa'"""
    return f"{value * coloring.factor:.4g} {coloring.unit}".rstrip()
