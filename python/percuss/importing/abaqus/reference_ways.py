"""The way of the mass centre of a body of which all six directions of another point are prescribed."""

import math

from ..curves import Points, interpolate
from ..model import Deck

ROWS, SUBSTEPS = 256, 8  # of a table; of the integration between two rows
AXES = ("x", "y", "z")


def read_value(value: "float | Deck", time: float) -> float:
    """Value of a number or a table of the deck at a time."""
    return interpolate([(t, y) for t, y in value["table"]], time) if isinstance(value, dict) else value


def find_displacement(motion: Deck, way: str, time: float, before: float, step: float) -> float:
    """Displacement of the reference node at a time; velocities continue from the displacement one step before."""
    if way in motion.get("displacement", {}):
        return read_value(motion["displacement"][way], time)
    return before + step * read_value(motion["velocity"][way], time - 0.5 * step)


def turn(vector: list[float], spin: list[float], step: float) -> list[float]:
    """A vector that turns with a spin for a step (Rodrigues)."""
    rate = math.hypot(*spin)
    if rate == 0:
        return vector
    k, angle = [w / rate for w in spin], rate * step
    along = sum(a * b for a, b in zip(k, vector))
    across = [k[1] * vector[2] - k[2] * vector[1], k[2] * vector[0] - k[0] * vector[2],
              k[0] * vector[1] - k[1] * vector[0]]
    return [v * math.cos(angle) + c * math.sin(angle) + a * along * (1 - math.cos(angle))
            for v, c, a in zip(vector, across, k)]


def place_center(motions: list[Deck], arm: list[float], end: float) -> list[Points]:
    """Displacements of the centre over time along x, y and z. motions: of the reference node, of one direction each.
    arm: from it to the centre."""
    by_way = {way: motion for motion in motions for way in next(iter(motion.values()))}
    ways, now = [0.0, 0.0, 0.0], list(arm)
    tables: list[Points] = [[(0.0, 0.0)] for _ in AXES]
    step = end / (ROWS * SUBSTEPS)
    for index in range(1, ROWS * SUBSTEPS + 1):
        time = index * step
        spin = [read_value(by_way[f"r{way}"]["velocity"][f"r{way}"], time - 0.5 * step) if f"r{way}" in by_way else 0.0
                for way in AXES]
        now = turn(now, spin, step)
        ways = [find_displacement(by_way[way], way, time, ways[d], step) if way in by_way else 0.0
                for d, way in enumerate(AXES)]
        if index % SUBSTEPS == 0:
            for d, table in enumerate(tables):
                table.append((time, ways[d] + now[d] - arm[d]))
    return tables
