"""Mirrored copies of a part of a scene that was modelled by symmetry."""

import itertools
from collections.abc import Sequence

import numpy as np

from percuss.results.arrays import Array
from percuss.results.deck import Deck
from percuss.results.fields import Fields

from .selection import BadChoice

Plane = tuple[int, float]  # axis, value
Planes = Sequence[Plane]
ON_THE_PLANE = 1e-6  # share of the size of the mesh


def choose_planes(fields: Fields, wanted: list[Plane | str] | None, deck: Deck) -> list[Plane]:
    """[(axis 0 to 2, value)] of 'y=0', or of 'deck': the conditions of the deck that hold nodes by `symmetry`."""
    planes: list[Plane] = []
    for word in wanted or ():
        planes += [word] if isinstance(word, tuple) else _find_planes(fields, deck)
    axes = [axis for axis, _ in planes]
    if len(set(axes)) < len(axes):
        raise BadChoice("one axis has two mirrors")
    return planes


def _find_planes(fields: Fields, deck: Deck) -> list[Plane]:
    """Such nodes lie in the plane: at the end of the mesh where more of them are."""
    planes = find_symmetry(fields, deck)
    if not planes:
        raise BadChoice("the deck has no condition with `symmetry`: name the plane, such as --mirror y=0")
    return planes


def find_symmetry(fields: Fields, deck: Deck) -> list[Plane]:
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


def list_copies(planes: Planes) -> list[Planes]:
    """The planes of each copy, without the scene itself: two mirrors give three."""
    return [chosen for count in range(1, len(planes) + 1) for chosen in itertools.combinations(planes, count)]


def reflect(points: Array, planes: Planes) -> Array:
    """Points [n][3] with their images in each copy."""
    return np.concatenate([points, *(reflect_once(points, chosen) for chosen in list_copies(planes))])


def reflect_once(points: Array, planes: Planes) -> Array:
    """Points [...][3] as one copy shows them."""
    image = np.array(points, dtype=float)
    for axis, value in planes:
        image[..., axis] = 2 * value - image[..., axis]
    return image
