"""The largest value of what a picture shows: where it is, and in words."""

import numpy as np


class Largest:
    """Of a frame. Attributes: value (in the unit of the file; None where nothing is finite), point [3], text ('element 12 of part 'plate'')."""

    def __init__(self, fields, coloring, frame, drawn):
        self.value, self.point, self.text = None, None, ""
        values = fields.values(coloring.name, frame)
        if coloring.place == "element":
            items = np.flatnonzero(drawn)
        else:
            items = np.unique(fields.hexahedra[drawn])
        items = items[np.isfinite(values[items])]
        if not len(items):
            return
        item = int(items[np.argmax(values[items])])
        self.value = float(values[item])
        positions = fields.positions(frame)
        if coloring.place == "element":
            self.point = positions[np.unique(fields.hexahedra[item])].mean(axis=0)
            self.text = f"element {fields.element_ids[item]} of part '{fields.part_names[fields.part[item]]}'"
        else:
            self.point, self.text = positions[item], f"node {fields.node_ids[item]}"


def format_value(value, coloring):
    """'412 MPa'"""
    return f"{value * coloring.factor:.4g} {coloring.unit}".rstrip()
