"""Accelerations of history nodes, rigid bodies and moving walls: means between rows, from the velocities in the rows.

The difference of the velocities of two rows is the integral of the acceleration between them. Divided by the time
between them it is the exact mean: no peak between rows is lost, whatever their distance.
A velocity is half a step earlier than its row.
"""

import re
from collections.abc import Iterable

import numpy as np

from .arrays import Array

_VELOCITIES = ((re.compile(r"(body_)v([xyz]:.+)", re.DOTALL), r"\1a\2"),
               (re.compile(r"(.+_)v([xyz])", re.DOTALL), r"\1a\2"),
               (re.compile(r"wall_speed:(.+)", re.DOTALL), r"wall_acceleration:\1"))


def list_accelerations(names: Iterable[str]) -> dict[str, str]:
    """{acceleration: velocity} of columns: {'tip_ax': 'tip_vx', 'body_ax:ram':
    'body_vx:ram', 'wall_acceleration:lid': 'wall_speed:lid'}."""
    found: dict[str, str] = {}
    names = list(names)
    for name in names:
        acceleration = next((pattern.sub(words, name) for pattern, words in _VELOCITIES if pattern.fullmatch(name)),
                            None)
        # A force or part may have a name that ends as a velocity does: of a node its position stands before it.
        is_of_node = not name.startswith(("body_v", "wall_speed:"))
        if acceleration and acceleration not in names and not (is_of_node and f"{name[:-2]}{name[-1]}" not in names):
            found[acceleration] = name
    return found


def find_acceleration(time: Array, step: Array, velocity: Array) -> Array:
    """[rows]: mean acceleration since the row before; 0 in the first.
    time: of the rows; step: the time step that ended at each."""
    middle = np.asarray(time) - 0.5 * np.asarray(step)
    interval, change = np.diff(middle), np.diff(velocity)
    means = np.divide(change, interval, out=np.zeros_like(change), where=interval > 0)
    return np.concatenate([[0.0], means])[: len(velocity)]


def describe(meaning: str) -> str:
    """'acceleration in x of 'tip', mean since the row before' of 'velocity in x of 'tip''."""
    short = re.sub(r"^(velocity|speed)\b", "acceleration", meaning.partition(", ")[0])
    return f"{short if short.startswith('acceleration') else f'acceleration of {short}'}, mean since the row before"
