"""Nodes, elements and their masses."""

from . import ALL, FIRST, Proof
from .pieces import CUBE_MASS, cube, deck, velocity

PROOFS = [
    Proof("NODE: NID X Y Z; ELEMENT_SOLID: EID PID N1 N2 N3 N4 N5 N6 N7 N8; INITIAL_VELOCITY: VX VY VZ; TITLE; SECTION_SOLID; MAT_ELASTIC: RO",
          deck(cube(), velocity(100.0, 20.0, -30.0)),
          [("momentum_x", ALL, 100.0 * CUBE_MASS, 1e-9), ("momentum_y", FIRST, 20.0 * CUBE_MASS, 1e-9), ("momentum_z", FIRST, -30.0 * CUBE_MASS, 1e-9)],
          "momentum of 7.8e-6 t"),
]  # fmt: skip

NOT_PHYSICS = {"TITLE": "a name"}
