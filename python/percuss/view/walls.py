"""Rigid walls of the view: the plates of each, and how far it has moved in each frame."""

from typing import Any

import numpy as np

from percuss.render.plates import span_round_wall, span_wall
from percuss.results.arrays import Array
from percuss.results.fields import Fields

AROUND = 32  # plates around a cylinder or a sphere


def describe_walls(fields: Fields, frames: Array, low: Array, size: Array) -> list[dict[str, Any]]:
    """A description of each wall: its plates at the start [12 numbers each], its moves [frames][3], and of a plane the
    normal, which points to the bodies.
    low, size: of the box of all frames, under which a plane without ends is drawn."""
    corners = np.array([low + size * np.array([i & 1, i >> 1 & 1, i >> 2]) for i in range(8)])
    places = [[wall[0] for wall in (*fields.walls_at(frame), *fields.round_walls_at(frame))] for frame in (0, *frames)]
    moves = np.asarray(places[1:]) - np.asarray(places[0])
    found: list[dict[str, Any]] = [{"plates": span_wall(*wall, corners), "normal": round_numbers(wall[1])}
                                   for wall in fields.walls_at(0)]
    found += [{"plates": span_round_wall(*wall, corners, AROUND)} for wall in fields.round_walls_at(0)]
    return [{**wall, "plates": round_numbers(wall["plates"]),
             "moves": [round_numbers(move) for move in moves[:, number]] if moves[:, number].any() else []}
            for number, wall in enumerate(found)]


def round_numbers(values: Array) -> list[float]:
    return [float(f"{x:.7g}") for x in np.reshape(values, -1)]
