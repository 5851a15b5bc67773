"""Mirrored copies of a part of a scene that was modelled by symmetry."""

import itertools

import numpy as np

from .selection import BadChoice

ON_THE_PLANE = 1e-6  # of the size of the mesh


def choose_planes(fields, wanted, deck):
    """[(axis 0 to 2, value)] of 'y=0', or of 'deck': the conditions of the deck that hold nodes by `symmetry`."""
    planes = []
    for word in wanted or ():
        planes += _find_planes(fields, deck) if word == "deck" else [word]
    axes = [axis for axis, _ in planes]
    if len(set(axes)) < len(axes):
        raise BadChoice("one axis has two mirrors")
    return planes


def _find_planes(fields, deck):
    """Such nodes lie in the plane: at the end of the mesh where more of them are."""
    planes = find_symmetry(fields, deck)
    if not planes:
        raise BadChoice("the deck has no condition with `symmetry`: name the plane, such as --mirror y=0")
    return planes


def find_symmetry(fields, deck):
    """[(axis, value)] of the planes of symmetry of a deck; none where it has none."""
    axes = {str(entry["symmetry"]).strip("-+")
            for entry in deck.get_list("conditions") if isinstance(entry, dict) and entry.get("symmetry")}
    start = fields.positions(0)
    near = ON_THE_PLANE * np.linalg.norm(np.ptp(start, axis=0))
    planes = []
    for axis in (number for number, name in enumerate("xyz") if name in axes):
        values = start[:, axis]
        low, high = values.min(), values.max()
        at_low = np.count_nonzero(values <= low + near) >= np.count_nonzero(values >= high - near)
        planes.append((axis, float(low if at_low else high)))
    return planes


def list_copies(planes):
    """The planes of each copy, without the scene itself: two mirrors give three."""
    return [chosen for count in range(1, len(planes) + 1) for chosen in itertools.combinations(planes, count)]


def reflect(points, planes):
    """Points [n][3] with their images in each copy."""
    return np.concatenate([points, *(reflect_once(points, chosen) for chosen in list_copies(planes))])


def reflect_once(points, planes):
    """Points [...][3] as one copy shows them."""
    image = np.array(points, dtype=float)
    for axis, value in planes:
        image[..., axis] = 2 * value - image[..., axis]
    return image
