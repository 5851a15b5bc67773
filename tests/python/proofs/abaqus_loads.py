"""Loads, masses, springs and outputs."""

import math

from . import ALL, FIRST, LAST, Proof
from .pieces import CUBE_MASS, DENSITY, POISSON, YOUNG, abaqus, abaqus_cube

T = 1e-4  # velocities are those of half a step before: 0.4 % of it
MODULUS = YOUNG * (1 - POISSON) / ((1 + POISSON) * (1 - 2 * POISSON))


def loaded(step: str, *before: str, end: float = T) -> str:
    return abaqus(abaqus_cube(), *before, end=end, step=step)


FACES = ((1, "momentum_z", 1), (2, "momentum_z", -1), (3, "momentum_y", 1), (4, "momentum_x", -1), (5, "momentum_y", -1), (6, "momentum_x", 1))
SHELL = ("*NODE, NSET=all\n1, 0., 0., 0.\n2, 10., 0., 0.\n3, 10., 10., 0.\n4, 0., 10., 0.\n*ELEMENT, TYPE=S4R, ELSET=sheet\n1, 1, 2, 3, 4\n"
         f"*SHELL SECTION, ELSET=sheet, MATERIAL=steel\n2., 5\n*MATERIAL, NAME=steel\n*DENSITY\n{DENSITY!r}\n*ELASTIC\n{YOUNG!r}, {POISSON!r}\n")
SPRUNG = "*ELEMENT, TYPE={0}A, ELSET=s\n2, 1, 5\n*{0}, ELSET=s{1}\n"
HELD = "*BOUNDARY\nall, 1, 2\n{}, 3, 3\n"

PROOFS = [
    Proof("CLOAD: AMPLITUDE", loaded("*CLOAD\n7, 1, 2.\n7, 2, -3.\n"), [("momentum_x", LAST, 2.0 * T, 1e-2), ("momentum_y", LAST, -3.0 * T, 1e-2)], "2 N and -3 N on one node"),
    Proof("CLOAD", abaqus(SHELL, end=T, step="*CLOAD\nall, 4, 2.\n"), [("angular_x", LAST, 8.0 * T, 1e-2)], "four moments of 2 N mm"),
    Proof("CLOAD", loaded("*CLOAD\nall, 4, 2.\n"), refused="no rotations"),
    *(Proof("DLOAD: AMPLITUDE", loaded(f"*DLOAD\ncube, P{face}, 0.05\n"), [(column, LAST, sign * 5.0 * T, 1e-2)], "0.05 MPa push 100 mm2 into the face") for face, column, sign in FACES),
    Proof("DLOAD: AMPLITUDE", loaded("*DLOAD, AMPLITUDE=a\ncube, P1, 0.05\n", "*AMPLITUDE, NAME=a\n0., 0., 1e-4, 1.\n", end=T), [("momentum_z", LAST, 2.5 * T, 5e-2)], "a ramp of 5 N"),
    Proof("DLOAD", loaded("*DLOAD\ncube, BY, 0.002\n"), [("momentum_y", LAST, 0.002 * 1000 * T, 1e-2)], "0.002 N/mm3 on 1000 mm3"),
    Proof("DLOAD", loaded("*DLOAD\ncube, GRAV, 9810., 0., 3., -4.\n"), [("momentum_y", LAST, 0.6 * 9810 * T * CUBE_MASS, 1e-2), ("momentum_z", LAST, -0.8 * 9810 * T * CUBE_MASS, 1e-2)],
          "the direction has no length"),
    Proof("DLOAD: AMPLITUDE", loaded("*DLOAD, AMPLITUDE=a\n, GRAV, 9810., 1., 0., 0.\n", "*AMPLITUDE, NAME=a\n0., 0.5, 1., 0.5\n"), [("momentum_x", LAST, 0.5 * 9810 * T * CUBE_MASS, 1e-2)],
          "half of gravity"),
    Proof("DLOAD", abaqus(SHELL, end=T, step="*DLOAD\nsheet, P, 0.05\n"), [("momentum_z", LAST, 5.0 * T, 1e-2)], "P of a shell pushes along its normal"),
    Proof("DLOAD", loaded("*DLOAD\ncube, VP, 1.\n"), refused="a distributed load VP"),
    Proof("DLOAD: FOLLOWER CONSTANT_RESULTANT", loaded("*DLOAD, FOLLOWER=NO, CONSTANT RESULTANT=YES\ncube, TRVEC6, 0.05, 0., 2., 0.\n"), [("momentum_y", LAST, 5.0 * T, 1e-2), ("momentum_x", LAST, 0.0, 1e-9)],
          "a traction along y on the face at x = 0"),
    Proof("DLOAD", abaqus(SHELL, end=T, step="*DLOAD\nsheet, TRVEC, 0.05, 3., 4., 0.\n"), [("momentum_x", LAST, 3.0 * T, 1e-2), ("momentum_y", LAST, 4.0 * T, 1e-2)], "a traction in the plane of a shell"),
    Proof("DLOAD", loaded("*DLOAD\ncube, TRVEC1, 0.05, 0., 0., 0.\n"), refused="the direction of the traction is zero"),
    Proof("DSLOAD: CONSTANT_RESULTANT", loaded("*DSLOAD, CONSTANT RESULTANT=YES\nside, TRVEC, 0.05, 0., 2., 0.\n", "*SURFACE, NAME=side\ncube, S4\n*SURFACE, NAME=more\ncube, S4\n"),
          [("momentum_y", LAST, 5.0 * T, 1e-2)], "a traction along y"),
    Proof("DSLOAD", loaded("*DSLOAD\nside, P, 0.05\n", "*SURFACE, NAME=side\ncube, S4\n1, S4\n"), [("momentum_x", LAST, -5.0 * T, 1e-2)], "a face that a surface names twice counts once"),
    Proof("DSLOAD: AMPLITUDE; SURFACE: NAME TYPE", loaded("*DSLOAD, AMPLITUDE=a\nside, P, 0.05\n", "*SURFACE, NAME=side, TYPE=ELEMENT\ncube, S4\n*AMPLITUDE, NAME=a\n0., 0.4, 1., 0.4\n"),
          [("momentum_x", LAST, -2.0 * T, 1e-2)], "0.4 of 5 N against the outward normal"),
    Proof("DSLOAD", abaqus(SHELL, "*SURFACE, NAME=up\nsheet, SPOS\n", end=T, step="*DSLOAD\nup, P, 0.05\n"), [("momentum_z", LAST, -5.0 * T, 1e-2)], "against the normal of SPOS"),
    Proof("DSLOAD: FOLLOWER", loaded("*DSLOAD, FOLLOWER=NO\nside, TRVEC, 0.05, 0., 2., 0.\n", "*SURFACE, NAME=side\ncube, S4\n"), [("momentum_y", LAST, 5.0 * T, 1e-2)], "a traction along y"),
    Proof("MASS: ELSET", loaded("", "*ELEMENT, TYPE=MASS, ELSET=m\n9, 7\n*MASS, ELSET=m\n2e-6,\n", "*INITIAL CONDITIONS, TYPE=VELOCITY\nall, 1, 10.\n"),
          [("momentum_x", FIRST, 10.0 * (CUBE_MASS + 2e-6), 1e-9)], "momentum of both masses"),
    Proof("SPRING: ELSET", loaded("*BOUNDARY, TYPE=VELOCITY\n5, 3, 3, 100.\n", SPRUNG.format("SPRING", "") + "\n3e4,\n", HELD.format("all")),
          [("spring_work", LAST, 0.5 * 3e4 * 1e-4, 2e-2)], "half of k u^2, u = 100 mm/s for 1e-4 s"),
    Proof("SPRING: NONLINEAR", loaded("*BOUNDARY, TYPE=VELOCITY\n5, 3, 3, 100.\n", SPRUNG.format("SPRING", ", NONLINEAR") + "\n-6., -2e-2\n40., 2e-2\n", HELD.format("all")),
          [("spring_work", LAST, (17.0 + 0.5 * 11.5) * 1e-2, 2e-2)], "17 N at 0, 28.5 N at 1e-2 mm"),
    Proof("DASHPOT: ELSET", loaded("*BOUNDARY, TYPE=VELOCITY\n5, 3, 3, 100.\n", SPRUNG.format("DASHPOT", "") + "\n0.3,\n", HELD.format("all")),
          [("damper_work", LAST, 0.3 * 100 * 100 * T, 5e-2)], "c v^2 t"),
    Proof("DASHPOT: NONLINEAR", loaded("", SPRUNG.format("DASHPOT", ", NONLINEAR") + "\n0., 0.\n1., 1.\n"), refused="nonlinear dampers"),
    Proof("BULK VISCOSITY", loaded("*BULK VISCOSITY\n0., 0.\n*BOUNDARY, TYPE=VELOCITY\n5, 3, 3, -100.\n", HELD.format("all")), [("viscous", ALL, 0.0, 1e-12)], "no coefficient, no work"),
    Proof("BULK VISCOSITY", loaded("*BULK VISCOSITY\n0.5, 0.\n*BOUNDARY, TYPE=VELOCITY\nup, 3, 3, -1000.\n", "*NSET, NSET=up\n5, 6, 7, 8\n*BOUNDARY\nall, 1, 2\n1, 3\n2, 3\n3, 3\n4, 3\n"),
          [("viscous", LAST, 0.5 * DENSITY * math.sqrt(MODULUS / DENSITY) * 10.0 * 100.0**2 * T * 1000, 5e-2)], "b rho c L (rate of volume)^2 over volume and time"),
    Proof("OUTPUT", abaqus(abaqus_cube(), "*NSET, NSET=tip\n7\n*INITIAL CONDITIONS, TYPE=VELOCITY\nall, 2, 30.\n*NSET, NSET=foot\n1\n*BOUNDARY\nall, 3\n", end=T,
                           step="*OUTPUT, HISTORY, TIME INTERVAL=1e-6\n*NODE OUTPUT, NSET=tip\nU2, V2\n*ENERGY OUTPUT, ELSET=cube\nALLKE\n*CLOAD\n1, 3, 4.\n"
                                "*OUTPUT, HISTORY\n*NODE OUTPUT, NSET=foot\nRF3\n"),
          [("TIP_vy", LAST, 30.0, 0.2), ("TIP_y", LAST, 10.0 + 30.0 * T, 1e-4), ("kinetic:CUBE", FIRST, 0.5 * 900 * CUBE_MASS, 1e-6), ("fz:force_FOOT", LAST, -4.0, 1e-2)],
          "a node, a part, and the support that takes 4 N"),
]  # fmt: skip
