"""Axisymmetric elements: rings about y, whose forces, masses and energies are those of the ring over 2 pi; and nodes that follow others."""

import math

from . import FIRST, LAST, Proof
from .abaqus_materials import BULK, NO_VISCOSITY, SHEAR
from .pieces import DENSITY, POISSON, YOUNG, abaqus, abaqus_cube, force

END, SHORT, SHARE = 1e-3, 1e-7, 1 / (2 * math.pi)
STEEL = f"*MATERIAL, NAME=steel\n*DENSITY\n{DENSITY!r}\n*ELASTIC\n{YOUNG!r}, {POISSON!r}\n"
SECTION = "*SOLID SECTION, ELSET=e, MATERIAL=steel\n,\n" + STEEL
SQUARE = "*ELEMENT, TYPE=CAX4R, ELSET=e\n1, 1, 2, 3, 4\n"
TRIANGLES = "*ELEMENT, TYPE=CAX3, ELSET=e\n1, 1, 2, 3\n2, 1, 3, 4\n"
EDGE = "*SURFACE, NAME=s\ne, S2\n*SURFACE, NAME=above\ne, S3\n"
FORCE, PRESSURE, SPEED = 10.0, 3.0, 100.0
STRAIN = 1e-4
LAMBDA = BULK - 2 / 3 * SHEAR
SPREAD = 2 * (LAMBDA + SHEAR) * STRAIN**2  # energy of a volume that is strained alike along the radius and around


def ring(inner: float, outer: float) -> str:
    """Nodes of a square of 10 mm of height."""
    rows = f"1, {inner!r}, 0.\n2, {outer!r}, 0.\n3, {outer!r}, 10.\n4, {inner!r}, 10.\n"
    return f"*NODE, NSET=all\n{rows}*NSET, NSET=inside\n1, 4\n*NSET, NSET=outside\n2, 3\n"


def volume(inner: float, outer: float) -> float:
    return 10.0 * math.pi * (outer**2 - inner**2) * SHARE


DIAMOND = "*NODE, NSET=all\n1, 10., 0.\n2, 20., 5.\n3, 10., 10.\n4, 0., 5.\n"  # one corner on the axis


def spread(nodes: str, elements: str, motion: dict[str, float]) -> str:
    """Radial velocities of sets; nothing moves along the axis."""
    rows = "".join(f"{name}, 1, 1, {way / END!r}\n" for name, way in motion.items())
    return abaqus(nodes, elements, SECTION, "*BOUNDARY\nall, 2\n", end=END, step=f"{NO_VISCOSITY}*BOUNDARY, TYPE=VELOCITY\n{rows}")


def pushed(*cards: str) -> str:
    return abaqus(ring(10.0, 20.0), SQUARE, SECTION, EDGE, end=SHORT, step="".join(cards))


def moving(nodes: str, elements: str, direction: int) -> str:
    return abaqus(nodes, elements, SECTION, f"*INITIAL CONDITIONS, TYPE=VELOCITY\nall, {direction}, {SPEED!r}\n", end=SHORT)


PLATE = "*NODE\n99, 0., -1.\n*SURFACE, TYPE=SEGMENTS, NAME=plate\nSTART, 0., -1.\nLINE, 40., -1.\n*RIGID BODY, ANALYTICAL SURFACE=plate, REF NODE=99\n"
MEETS = "*SURFACE, NAME=below\ne, S1\n*SURFACE INTERACTION, NAME=i\n*FRICTION\n{},\n*BOUNDARY\n99, 1, 6\n*INITIAL CONDITIONS, TYPE=VELOCITY\nall, 2, -2000.\n"
PAIR = "*CONTACT PAIR, INTERACTION=i\nbelow, plate\n"
MASS = volume(10.0, 20.0) * DENSITY
BOUNCED = [(lambda h: float(h["momentum_y"][-1] > 0), LAST, 1.0, 1e-9)]
BODY = "*NODE\n9, 0., 5.\n*RIGID BODY, REF NODE=9, ELSET=e\n"
POINT = "*ELEMENT, TYPE=MASS, ELSET=m\n2, 9\n*MASS, ELSET=m\n1e-5,\n"

# Nodes of a cube that follow node 9, which has no element.
LEADER = "*NODE, NSET=ref\n9, 5., 5., 30.\n*NSET, NSET=upper\n5, 6, 7, 8\n"
EQUAL = LEADER + "*EQUATION\n2\nupper, 3, 1., 9, 3, -1.\n"
COUPLED = LEADER + "*SURFACE, TYPE=NODE, NAME=u\nupper, 1.\n*COUPLING, CONSTRAINT NAME=c, REF NODE=9, SURFACE=u\n*KINEMATIC\n3, 3\n"
HELD = "*BOUNDARY\n9, 4, 6\n"
LIFT = f"{NO_VISCOSITY}*BOUNDARY, TYPE=VELOCITY\n9, 3, 3, {1e-3 / END!r}\n"
CONFINED = "*BOUNDARY\nall, 1, 2\n1, 3\n2, 3\n3, 3\n4, 3\n"
STRETCHED = [("internal", LAST, 1000.0 * 0.5 * 1e-8 * (BULK + 4 / 3 * SHEAR), 1e-2)]
PULL = "*CLOAD\n9, 3, 6.\n*OUTPUT, HISTORY, TIME INTERVAL=1e-8\n*NODE OUTPUT, NSET=upper\nV3\n"


def find_difference(history: dict[str, list[float]]) -> float:
    """Of the speeds of the upper nodes, over their mean."""
    speeds = [history[f"UPPER_{node}_vz"][-1] for node in (5, 6, 7, 8)]
    return (max(speeds) - min(speeds)) / (0.25 * sum(speeds))


def follows(cards: str, step: str, end: float = END) -> str:
    return abaqus(abaqus_cube(), cards, end=end, step=step)


PROOFS = [
    Proof("ELEMENT: TYPE; BOUNDARY: TYPE; SOLID SECTION: MATERIAL", spread(ring(10.0, 20.0), SQUARE, {"inside": 1e-3, "outside": 2e-3}), [("internal", LAST, SPREAD * volume(10.0, 20.0), 1e-2)],
          "a ring whose radii all grow by 1e-4 of themselves"),
    Proof("ELEMENT: TYPE; BOUNDARY: TYPE", spread(ring(10.0, 20.0), SQUARE, {"all": 1.5e-3}), [("internal", LAST, 0.5 * (LAMBDA + 2 * SHEAR) * STRAIN**2 * volume(10.0, 20.0), 1e-2)],
          "radii that grow by the same length: strain around the axis alone, 1e-4 at the mean radius"),
    Proof("ELEMENT: TYPE", spread(ring(0.0, 10.0), SQUARE, {"outside": 1e-3}), [("internal", LAST, SPREAD * volume(0.0, 10.0), 1e-2)], "a disc: an edge on the axis"),
    Proof("ELEMENT: TYPE", spread(ring(10.0, 20.0), TRIANGLES, {"inside": 1e-3, "outside": 2e-3}), [("internal", LAST, SPREAD * volume(10.0, 20.0), 1e-2)], "two triangles"),
    Proof("ELEMENT: TYPE", spread(ring(0.0, 10.0), TRIANGLES, {"outside": 1e-3}), [("internal", LAST, SPREAD * volume(0.0, 10.0), 1e-2)], "triangles with a corner and with an edge on the axis"),
    Proof("ELEMENT: TYPE", spread(DIAMOND, SQUARE, {"1": 1e-3, "2": 2e-3, "3": 1e-3}), [("internal", LAST, SPREAD * 100.0 * 10.0, 1e-2)], "one corner on the axis: an area of 100 mm2 at a mean radius of 10"),
    Proof("INITIAL CONDITIONS: TYPE", moving(DIAMOND, SQUARE, 2), [("momentum_y", LAST, 100.0 * 10.0 * DENSITY * SPEED, 2e-3), ("internal", LAST, 0.0, 1e-9)], "the corner on the axis goes along as one node"),
    Proof("INITIAL CONDITIONS: TYPE", moving(ring(10.0, 20.0), SQUARE, 1), [("kinetic", FIRST, 0.5 * MASS * SPEED**2, 1e-2), ("momentum_x", FIRST, 0.5 * MASS * SPEED, 1e-2), ("momentum_z", FIRST, 0.5 * MASS * SPEED, 1e-2)],
          "all nodes move along their radii: half of them along x, half along z"),
    Proof("CLOAD", pushed(f"*CLOAD\noutside, 1, {FORCE!r}\n"), [(force("x"), LAST, 2 * FORCE * 0.5 * SHARE, 1e-3), (force("z"), LAST, 2 * FORCE * 0.5 * SHARE, 1e-3)], "a radial force on each of two rings of nodes: half of its share at each side of the sector"),
    Proof("CLOAD", pushed(f"*CLOAD\noutside, 2, {FORCE!r}\n"), [(force("y"), LAST, 2 * FORCE * SHARE, 1e-3)], "along the axis"),
    Proof("CLOAD", pushed("*CLOAD\noutside, 3, 1.\n"), refused="a load on direction 3"),
    Proof("DSLOAD; SURFACE: NAME", pushed(f"*DSLOAD\ns, P, {-PRESSURE!r}\n"), [(force("x"), LAST, 0.5 * PRESSURE * 2 * math.pi * 20.0 * 10.0 * SHARE, 1e-3)], "pulled outward: half of the share along x"),
    Proof("DSLOAD; SURFACE: NAME", pushed(f"*DSLOAD\nabove, P, {-PRESSURE!r}\n"), [(force("y"), LAST, PRESSURE * math.pi * 300.0 * SHARE, 1e-3)], "on the ring at the top"),
    Proof("DLOAD", pushed(f"*DLOAD\ne, P3, {-PRESSURE!r}\n"), [(force("y"), LAST, PRESSURE * math.pi * 300.0 * SHARE, 1e-3)], "likewise"),
    Proof("DLOAD", abaqus(ring(10.0, 20.0), TRIANGLES, SECTION, "*ELSET, ELSET=upper\n2,\n", end=SHORT, step=f"*DLOAD\nupper, P2, {-PRESSURE!r}\n"), [(force("y"), LAST, PRESSURE * math.pi * 300.0 * SHARE, 1e-3)], "the second edge of a triangle"),
    Proof("DLOAD", abaqus(ring(10.0, 20.0), TRIANGLES, SECTION, "*ELSET, ELSET=upper\n2,\n", end=SHORT, step=f"*DLOAD\nupper, P3, {-PRESSURE!r}\n"), [(force("x"), LAST, -0.5 * PRESSURE * 2 * math.pi * 10.0 * 10.0 * SHARE, 1e-3)], "the third edge, inside"),
    Proof("DSLOAD", pushed("*DSLOAD\ns, TRVEC, 1., 0., 1., 0.\n"), refused="a traction on faces of axisymmetric elements"),
    Proof("DLOAD", pushed("*DLOAD\n, GRAV, 9810., 1., 0., 0.\n"), refused="an acceleration across the axis"),
    Proof("DLOAD", pushed("*DLOAD\n, GRAV, 9810., 0., -1., 0.\n"), [(force("y"), LAST, -9810.0 * MASS, 1e-3)], "along the axis"),
    Proof("SURFACE: TYPE; RIGID BODY: ANALYTICAL_SURFACE", abaqus(ring(10.0, 20.0), SQUARE, SECTION, PLATE, MEETS.format("0."), end=5e-4 + 2e-5, step=PAIR), BOUNCED, "a ring falls 1 mm onto a plate, which the line is around the axis"),
    Proof("RIGID BODY: REF_NODE ELSET; CLOAD; MASS: ELSET", abaqus(ring(10.0, 20.0), SQUARE, SECTION, BODY, POINT, end=1e-4, step=f"*CLOAD\n9, 2, {FORCE!r}\n"),
          [("momentum_y", LAST, FORCE * SHARE * 1e-4, 1e-2), ("body_vy:E", LAST, FORCE * SHARE * 1e-4 / (MASS + 1e-5 * SHARE), 1e-2)], "a rigid ring of its own mass and a point's"),
    Proof("FRICTION", abaqus(ring(10.0, 20.0), SQUARE, SECTION, MEETS.format("0.1").replace("99, 1, 6", "1, 2"), end=SHORT, step="*CONTACT PAIR, INTERACTION=i\nbelow, below\n"), refused="friction between axisymmetric elements"),
    Proof("ELEMENT: TYPE", abaqus(ring(-10.0, 20.0), SQUARE, SECTION), refused="beyond the axis"),
    Proof("ELEMENT: TYPE", abaqus(ring(10.0, 20.0), SQUARE.replace("1, 1, 2, 3, 4", "1, 1, 2, 3, 9"), SECTION), refused="there is no node 9, of element 1"),
    Proof("ELEMENT: TYPE", abaqus(ring(10.0, 20.0), SQUARE, "*ELEMENT, TYPE=T3D2, ELSET=t\n5, 1, 3\n*SOLID SECTION, ELSET=t, MATERIAL=steel\n1.,\n", SECTION), refused="elements T3D2 beside axisymmetric ones"),
    Proof("INITIAL CONDITIONS: TYPE", abaqus(ring(10.0, 20.0), SQUARE, SECTION, "*INITIAL CONDITIONS, TYPE=STRESS\ne, 1., 1., 1., 0.\n"), refused="of axisymmetric elements"),
    Proof("EQUATION", abaqus(ring(10.0, 20.0), SQUARE, SECTION, "*EQUATION\n2\noutside, 1, 1., inside, 1, -1.\n"), refused="equal radial displacements"),
    Proof("EQUATION; BOUNDARY: TYPE", follows(EQUAL + CONFINED, LIFT), STRETCHED, "the upper nodes have the motion of the node without elements"),
    Proof("COUPLING: REF_NODE SURFACE; KINEMATIC; BOUNDARY", follows(COUPLED + CONFINED + HELD, LIFT), STRETCHED, "along z alone"),
    Proof("KINEMATIC", follows(COUPLED, LIFT), refused="leaves directions free"),
    Proof("EQUATION; CLOAD", follows(EQUAL, PULL, SHORT), [(force("z"), LAST, 6.0, 1e-3), (find_difference, LAST, 0.0, 1e-9)], "a force on the node without elements moves the upper nodes alike"),
    Proof("COUPLING: REF_NODE SURFACE; KINEMATIC; CLOAD", follows(COUPLED + HELD, PULL, SHORT), [(force("z"), LAST, 6.0, 1e-3), (find_difference, LAST, 0.0, 1e-9)], "likewise"),
    Proof("CLOAD", follows(EQUAL, PULL.replace("9, 3", "9, 1"), SHORT), refused="in which no nodes move with it freely"),
    Proof("EQUATION", follows(EQUAL + "*BOUNDARY, TYPE=VELOCITY\n5, 3, 3, 7.\n", LIFT), refused="nodes with a condition of their own"),
    Proof("OUTPUT: HISTORY; NODE OUTPUT: NSET", follows(EQUAL + CONFINED, LIFT + "*OUTPUT, HISTORY, TIME INTERVAL=1e-5\n*NODE OUTPUT, NSET=ref\nRF3, U3\n"), [("fz:force_REF", LAST, 1e-4 * 100.0 * (BULK + 4 / 3 * SHEAR), 3e-2), (lambda h: h["REF_z"][-1], LAST, 10.001, 1e-6)], "the force of what moves them, and the place of one of them"),
]  # fmt: skip
