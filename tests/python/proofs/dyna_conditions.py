"""Damping, supports and motions."""

import math

from . import LAST, Proof
from .pieces import CUBE_MASS, cube, curve, deck, velocity

PROOFS = [
    Proof("DAMPING_GLOBAL: LCID VALDMP",
          deck(cube(), velocity(100.0), "*DAMPING_GLOBAL\n0,50.0\n", end=1e-2),
          [("momentum_x", LAST, 100.0 * math.exp(-0.5) * CUBE_MASS, 1e-3)],
          "v' = -D v: exp(-50 0.01)"),
    Proof("DAMPING_GLOBAL: LCID",
          deck(cube(), velocity(100.0), "*DAMPING_GLOBAL\n7\n", curve(7, (0, 30.0), (1.0, 30.0)), end=1e-2),
          [("momentum_x", LAST, 100.0 * math.exp(-0.3) * CUBE_MASS, 1e-3)],
          "v' = -D v, D from the curve"),
]  # fmt: skip
