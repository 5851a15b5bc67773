"""A cutoff of tension that fails nothing: the pressure as a table over ln(V / V0) that stays level there.

This is exact where the pressure depends on the volume alone, between the rows of the table: max(p(V), cutoff) then does not depend on the way.
"""

import math
from collections.abc import Callable

from ...curves import Points
from ...model import Deck

Pressure = Callable[[float], float]  # over ln(V / V0)
MOST_ROWS = 32
LARGEST, LEAST = 0.5, 1e-3  # of -ln(V / V0) between which rows have a constant ratio
IN_COMPRESSION, IN_TENSION = 22, 6
LEVEL = 1e-9  # share by which the pressure falls behind the cutoff, since tables must fall


def find_pressure(state: Deck, density: float) -> Pressure | None:
    """The pressure of the volume alone; None where the energy changes it, or its table is given."""
    if state["kind"] == "linear":
        return lambda x: state["bulk_modulus"] * math.expm1(-x)
    if state["kind"] == "polynomial" and not any(state.get(f"c{i}") for i in (4, 5, 6)):
        c = [state.get(f"c{i}", 0.0) for i in range(4)]
        return lambda x: c[0] + (c[1] + (c[2] * (x < 0) + c[3] * math.expm1(-x)) * math.expm1(-x)) * math.expm1(-x)
    if state["kind"] == "mie_grueneisen" and not state["grueneisen"] and not state.get("grueneisen_slope"):
        return lambda x: find_hugoniot(state, density, x)
    return None


def find_hugoniot(state: Deck, density: float, x: float) -> float:
    stiffness, share = density * state["sound_speed"] ** 2, -math.expm1(x)
    if x >= 0:
        return stiffness * math.expm1(-x)
    gap = 1 - (state["slope"] + (state.get("slope_2", 0.0) + state.get("slope_3", 0.0) * share) * share) * share
    return stiffness * share / gap**2 if gap > 0 else math.inf


def cut_tension(state: Deck, density: float, cutoff: float) -> tuple[Deck, float] | None:
    """The equation of state with pressures not below a cutoff, which is negative, and the largest error between its rows as a share of the pressure;
    None where it cannot be."""
    if state["kind"] == "tabulated" and not (state.get("gamma") and state.get("heat")):
        return cut_table(state, cutoff)
    pressure = find_pressure(state, density)
    if pressure is None:
        return None
    end = find_place(pressure, cutoff)
    if end is None or pressure(0.0) <= cutoff:
        return None
    places = [-LARGEST * (LEAST / LARGEST) ** (i / (IN_COMPRESSION - 1)) for i in range(IN_COMPRESSION)] + [0.0]
    if end > LEAST:
        places += [LEAST * (end / LEAST) ** (i / IN_TENSION) for i in range(IN_TENSION)]
    rows = [(x, pressure(x)) for x in places] + [(end, cutoff)]
    middles = [0.5 * (a + b) for (a, _), (b, _) in zip(rows, rows[1:])]
    errors = [abs(0.5 * (p + q) / pressure(x) - 1) for x, (_, p), (_, q) in zip(middles, rows, rows[1:]) if pressure(x)]
    return make_state(rows, cutoff, max(errors))


def cut_table(state: Deck, cutoff: float) -> tuple[Deck, float] | None:
    """Rows above the cutoff, and the place where the table or the slope behind it reaches it."""
    rows = [(x, p) for x, p in state["cold"] if p > cutoff]
    behind = [(x, p) for x, p in state["cold"] if p <= cutoff]
    if not rows:
        return None
    (x0, p0), (x1, p1) = (rows[-1], behind[0]) if behind else (rows[-2], rows[-1]) if len(rows) > 1 else (rows[-1], rows[-1])
    if x1 == x0:
        return None
    return make_state([*rows, (x0 + (cutoff - p0) * (x1 - x0) / (p1 - p0), cutoff)], cutoff, 0.0)


def make_state(rows: Points, cutoff: float, error: float) -> tuple[Deck, float] | None:
    rows = [*rows, (rows[-1][0] + 1, cutoff * (1 + LEVEL))]
    falls = all(p > q and math.isfinite(p) for (_, p), (_, q) in zip(rows, rows[1:]))
    return ({"kind": "tabulated", "gamma": 0.0, "cold": [list(row) for row in rows]}, error) if falls and len(rows) <= MOST_ROWS else None


def find_place(pressure: Pressure, cutoff: float) -> float | None:
    """Where the pressure falls to the cutoff; None where it does not."""
    low, high = 0.0, 1e-6
    while pressure(high) > cutoff:
        low, high = high, 2 * high
        if high > 10:
            return None
    for _ in range(200):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if pressure(middle) > cutoff else (low, middle)
    return high
