"""Nodes, elements, sections."""

from . import ALL, Proof
from .pieces import CUBE_MASS, abaqus, abaqus_cube

PROOFS = [
    Proof("NODE: NSET; ELEMENT: TYPE ELSET; SOLID SECTION: ELSET MATERIAL; MATERIAL: NAME; DENSITY; INITIAL CONDITIONS: TYPE",
          abaqus(abaqus_cube(), "*INITIAL CONDITIONS, TYPE=VELOCITY\nall, 1, 100.\nall, 2, -20.\n"),
          [("momentum_x", ALL, 100.0 * CUBE_MASS, 1e-9), ("momentum_y", ALL, -20.0 * CUBE_MASS, 1e-9)],
          "momentum of 7.8e-6 t"),
]  # fmt: skip

NOT_PHYSICS = {"HEADING": "a title"}
