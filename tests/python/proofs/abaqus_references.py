"""Reference nodes: their reactions, and what is prescribed there; options that are numerics; gravity that leaves masses out."""

import math

from . import ALL, LAST, Proof
from .pieces import CUBE_MASS, POISSON, YOUNG, abaqus, abaqus_cube

END = 1e-3
FALL = 9810.0
WEIGHT = CUBE_MASS * FALL
GRAVITY = f"*DLOAD\ncube, GRAV, {FALL}, 0., 0., -1.\n"
STIFF = YOUNG * (1 - POISSON) / ((1 + POISSON) * (1 - 2 * POISSON))
SQUEEZED = "*BOUNDARY\nall, 1, 2\nlow, 3, 3\n9, 1, 2\n9, 4, 6\n*BOUNDARY, AMPLITUDE=a\n9, 3, 3, -0.01\n"
COUPLED = ("*NSET, NSET=low\n1, 2, 3, 4\n*NODE, NSET=ref\n9, 5., 5., 30.\n*SURFACE, NAME=top\ncube, S2\n*COUPLING, CONSTRAINT NAME=c, REF NODE=9, SURFACE=top\n*KINEMATIC\n"
           f"*AMPLITUDE, NAME=a, DEFINITION=SMOOTH STEP\n0., 0., {END!r}, 1.\n")  # fmt: skip


def asks(words: str, name: str = "ref") -> str:
    return f"*OUTPUT, HISTORY, TIME INTERVAL=1e-5\n*NODE OUTPUT, NSET={name}\n{words}\n"


def referred(place: str, step: str, words: str = "RF1, RF3, RM2, CF3, U3", end: float = END) -> str:
    """A rigid cube with a reference node."""
    return abaqus(abaqus_cube(), f"*NODE, NSET=ref\n9, {place}\n*RIGID BODY, REF NODE=9, ELSET=cube\n", end=end, step=step + asks(words))


def spun(first: str, reference: str = "25., 5., 5.") -> str:
    """It turns about its reference node, 20 mm from its centre, with 100 rad/s about z."""
    return referred(reference, f"*BOUNDARY, TYPE=VELOCITY\n{first}9, 2, 5, 0.\n9, 6, 6, 100.\n", "U, RF")


def weighed(set_of_load: str, more: str = "") -> str:
    """A cube, and a mass as large at its node 7."""
    mass = f"*ELEMENT, TYPE=MASS, ELSET=point\n99, 7\n*MASS, ELSET=point\n{CUBE_MASS!r},\n*ELSET, ELSET=both\ncube, point\n"
    return abaqus(abaqus_cube(), mass, more, end=END, step=f"*DLOAD{', AMPLITUDE=a' if more else ''}\n{set_of_load}, GRAV, {FALL}, 0., 0., -1.\n")


def pushed(step_options: str = "", cards: str = "") -> str:
    return abaqus(abaqus_cube(), cards, end=END, step="*CLOAD\nall, 1, 0.5\n").replace("*STEP\n", f"*STEP{step_options}\n")


ANGLE = 100.0 * END  # by the end
PUSHED = [("momentum_x", LAST, 4.0 * END, 1e-2)]
DRIVEN = "*BOUNDARY\n9, 2, 6\n*BOUNDARY, TYPE=ACCELERATION\n9, 1, 1, 1e6\n"
UNTURNED = "*BOUNDARY\nall, 4, 6\n*INITIAL CONDITIONS, TYPE=VELOCITY\nall, 1, 30.\n"

PROOFS = [
    Proof("NODE OUTPUT: NSET; COUPLING: REF_NODE SURFACE; KINEMATIC", abaqus(abaqus_cube(), COUPLED, end=2 * END, step=SQUEEZED + asks("RF3, RM1, U3, CF3")),
          [("fz:force_REF", LAST, STIFF * math.log(0.999) * 100.0, 1e-2)], "what moves the coupled face carries the strain across: (lambda + 2 mu) ln(0.999) A"),
    Proof("NODE OUTPUT: NSET; RIGID BODY: REF_NODE; BOUNDARY: TYPE", referred("5., 5., 15.", DRIVEN), [("fx:force_REF", LAST, CUBE_MASS * 1e6, 1e-3)], "mass times acceleration"),
    Proof("NODE OUTPUT: NSET; RIGID BODY: REF_NODE; BOUNDARY", referred("8., 5., 15.", GRAVITY + "*BOUNDARY\n9, 1, 6\n"),
          [("fz:force_REF", LAST, WEIGHT, 1e-6), ("my:force_REF", LAST, 3.0 * WEIGHT, 1e-6)], "the weight, and its moment about the reference node"),
    Proof("NODE OUTPUT: NSET; RIGID BODY: POSITION", referred("8., 5., 15.", GRAVITY + "*BOUNDARY, TYPE=VELOCITY\n9, 3, 3, 100.\n", end=1e-4).replace("REF NODE=9,", "REF NODE=9, POSITION=CENTER OF MASS,"),
          [("fz:force_REF", LAST, WEIGHT, 1e-6)], "a body that moves along z alone and may turn"),
    Proof("NODE OUTPUT: NSET; RIGID BODY: REF_NODE; BOUNDARY", referred("5., 5., 15.", GRAVITY + "*BOUNDARY\n9, 1, 3\n"), [("joint_fz:held_1", LAST, WEIGHT, 1e-3)], "it hangs at a joint"),
    Proof("NODE OUTPUT: NSET; RIGID BODY: REF_NODE; CLOAD", referred("5., 5., 5.", "*CLOAD\n9, 3, 2.\n", "RF3, RM1, CF3", 1e-4), [("momentum_z", LAST, 2.0 * 1e-4, 1e-2)], "nothing holds it: no force is written"),
    Proof("NODE OUTPUT: NSET; BOUNDARY", abaqus(abaqus_cube(), UNTURNED, end=END, step=asks("RF1, RM1", "all")), [("momentum_x", ALL, 30.0 * CUBE_MASS, 1e-9)], "nodes of solids have no rotations to hold: no force is written"),
    Proof("BOUNDARY: TYPE; RIGID BODY: REF_NODE", spun("9, 1, 1, 0.\n"),
          [("momentum_y", LAST, -2000.0 * math.cos(ANGLE) * CUBE_MASS, 1e-3), ("momentum_x", LAST, 2000.0 * math.sin(ANGLE - 0.05e-3) * CUBE_MASS, 1e-2),
           (lambda h: math.hypot(h["joint_fx:held_1"][-1], h["joint_fy:held_1"][-1]), LAST, CUBE_MASS * 100.0**2 * 20.0, 1e-2)], "all six directions of a node beside the centre: m w^2 r holds it there"),
    Proof("BOUNDARY: TYPE; RIGID BODY: REF_NODE", spun("9, 1, 1, 50.\n"),
          [("momentum_y", LAST, -2000.0 * math.cos(ANGLE) * CUBE_MASS, 2e-3), ("body_x:CUBE", LAST, 25.0 + 50.0 * END - 20.0 * math.cos(ANGLE), 1e-6)], "the node moves along x meanwhile"),
    Proof("DLOAD; MASS: ELSET", weighed("cube"), [("momentum_z", LAST, -WEIGHT * END, 1e-2)], "gravity on the cube alone"),
    Proof("DLOAD: AMPLITUDE; MASS: ELSET", weighed("cube", "*AMPLITUDE, NAME=a\n0., 0., 1e-3, 1.\n"), [("momentum_z", LAST, -WEIGHT * END / 2, 1e-2)], "gravity that rises"),
    Proof("DLOAD; MASS: ELSET", weighed("both"), [("momentum_z", LAST, -2 * WEIGHT * END, 1e-2)], "on both"),
    Proof("DLOAD; MASS: ELSET", weighed(""), [("momentum_z", LAST, -2 * WEIGHT * END, 1e-2)], "on all"),
    Proof("STEP", pushed(", NLGEOM=YES, INC=100000, EXTRAPOLATION=NO, UNSYMM=YES, CONVERT SDI=NO"), PUSHED, "numerics of implicit steps change nothing"),
    Proof("STEP", pushed(", PERTURBATION"), refused="STEP.PERTURBATION"),
    Proof("DYNAMIC: EXPLICIT", pushed().replace("*DYNAMIC, EXPLICIT", "*DYNAMIC, EXPLICIT, ELEMENT BY ELEMENT, IMPROVED DT METHOD=NO"), PUSHED, "nor do those of the step"),
    Proof("MATERIAL: NAME", pushed().replace("NAME=steel", "NAME=steel, SRATE FACTOR=0.9, RTOL=0.03"), PUSHED, "nor does how rates are smoothed"),
    Proof("STEP", pushed(", INC=9").replace("*CLOAD", "*CLOAD, REGION TYPE=LAGRANGIAN"), PUSHED, "nor do adaptive meshes"),
]  # fmt: skip
