"""Which elements are drawn: parts by name, and those behind a cut."""

import numpy as np

from .camera import directions


class BadChoice(Exception):
    """An argument does not fit the file; str() is a message for the user."""


def choose_elements(fields, arguments):
    """[elements] whether each is drawn."""
    kept = choose_parts(fields, arguments.part)
    if arguments.clip is not None:
        kept &= cut(fields, kept, arguments.clip, arguments.view)
    return kept


def choose_parts(fields, wanted):
    if not wanted:
        return np.ones(fields.elements, dtype=bool)
    names = [name for words in wanted for name in ([words] if words in fields.part_names else words.split(","))]
    unknown = [name for name in names if name not in fields.part_names]
    if unknown:
        raise BadChoice(f"there is no part '{unknown[0]}' in {fields.path} (it has {', '.join(fields.part_names)})")
    return np.isin(fields.part, [fields.part_names.index(name) for name in names])


def cut(fields, kept, clip, view):
    """[elements] whether the centre of each, at the start, lies on the side of the cut that stays."""
    side, axis, value = clip
    centers = fields.positions(0)[fields.hexahedra, axis].mean(axis=1)
    removed_above = side == "+" if side else faces_camera(axis, view)
    stays = centers <= value if removed_above else centers >= value
    if not (stays & kept).any():
        where = "below" if removed_above else "above"
        raise BadChoice(f"nothing is left of the mesh {where} {'xyz'[axis]} = {value:g} "
                        f"(its elements are from {centers[kept].min():g} to {centers[kept].max():g})")
    return stays


def faces_camera(axis, view):
    """Whether the camera stands at the upper end of the axis; where it looks along the cut the upper end is taken away."""
    _, _, forward = directions(*view)
    return forward[axis] < 1e-9
