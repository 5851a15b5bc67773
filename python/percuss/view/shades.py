"""A field of the view: one byte an item and frame, the ends of its bar, and where it is largest."""

from typing import Any

import numpy as np

from percuss.render import colors
from percuss.render.largest import find_largest
from percuss.render.ranges import choose_bar, find_ends, find_typical_ends
from percuss.results.arrays import Array
from percuss.results.fields import Fields
from percuss.results.units import choose_unit

from .shape import Content, Shape
from .walls import round_numbers


def describe_field(fields: Fields, name: str, shape: Shape, content: Content) -> tuple[dict[str, Any], Array]:
    """(description, [frames][items] the field in 254 steps between the ends of the bar; 255: no number). Items are the
    nodes or the elements of the shape. Below and above the bar it is its end."""
    place = fields.names()[name]
    items = shape.elements if place == "element" else shape.nodes
    values = [fields.values(name, frame)[items] for frame in content.frames]
    ends = find_ends(values)
    low, high, labels = choose_bar(find_typical_ends(values) if name not in colors.CATEGORIES else ends)
    unit, factor = choose_unit(fields.unit_of(name), max(abs(low), abs(high)))
    described = {"name": name, "place": place, "title": colors.label_of(name), "unit": unit, "low": low * factor,
                 "high": high * factor, "labels": [f"{x * factor:.4g}" for x in np.linspace(low, high, labels)],
                 "map": colors.MAPS["heat"], "note": ""}
    if ends and (ends[0] < low or ends[1] > high):
        described["note"] = f"data: {ends[0] * factor:.3g} to {ends[1] * factor:.3g}"
    described["largest"] = ([] if name in colors.CATEGORIES
                            else [_tell_largest(fields, name, frame, content, factor) for frame in content.frames])
    share = (np.stack(values) - low) / (high - low)
    return described, np.where(np.isfinite(share), np.round(np.clip(share, 0, 1) * 254), 255).astype(np.uint8)


def _tell_largest(fields: Fields, name: str, frame: int, content: Content, factor: float) -> dict[str, Any] | None:
    """The largest of all elements that are shown and alive, also of those inside:
    value, words, place at the start, place in this frame."""
    item, value = find_largest(fields, name, frame, content.kept & fields.alive(frame))
    if item is None:
        return None
    if fields.names()[name] == "element":
        nodes, words = np.unique(fields.hexahedra[item]), f"element {fields.element_ids[item]}"
    else:
        nodes, words = np.array([item]), f"node {fields.node_ids[item]}"
    places = [fields.positions(f)[nodes].mean(axis=0) for f in (0, frame)]
    if not np.isfinite(places).all():
        return None
    return {"value": f"{value * factor:.4g}", "of": words, "start": round_numbers(places[0]),
            "now": round_numbers(places[1])}
