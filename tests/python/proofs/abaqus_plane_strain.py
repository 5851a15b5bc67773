"""Elements of plane strain: squares of 10 mm of the thickness that their section says."""

from . import LAST, Proof
from .abaqus_materials import BULK, NO_VISCOSITY, SHEAR
from .pieces import DENSITY, POISSON, YOUNG, abaqus, force

THICKNESS, END = 4.0, 1e-3
STEEL = f"*MATERIAL, NAME=steel\n*DENSITY\n{DENSITY!r}\n*ELASTIC\n{YOUNG!r}, {POISSON!r}\n"
NODES = "*NODE, NSET=all\n1, 0., 0.\n2, 10., 0.\n3, 10., 10.\n4, 0., 10.\n*NSET, NSET=left\n1, 4\n*NSET, NSET=right\n2, 3\n"
SQUARE = "*ELEMENT, TYPE=CPE4R, ELSET=e\n1, 1, 2, 3, 4\n"
TRIANGLES = "*ELEMENT, TYPE=CPE3, ELSET=e\n1, 1, 2, 3\n2, 1, 3, 4\n"
SECTION = f"*SOLID SECTION, ELSET=e, MATERIAL=steel\n{THICKNESS!r},\n" + STEEL
FORCE, SHORT = 10.0, 1e-7
EDGE = "*SURFACE, NAME=s\ne, S2\n"


def pulled(elements: str, held: str = "") -> str:
    """The right edge moves by 1e-4 of the width."""
    return abaqus(NODES, elements, SECTION, f"*BOUNDARY\nleft, 1\n{held}", end=END, step=NO_VISCOSITY + f"*BOUNDARY, TYPE=VELOCITY\nright, 1, 1, {1e-3 / END!r}\n")


def pushed(*cards: str) -> str:
    return abaqus(NODES, SQUARE, SECTION, EDGE, end=SHORT, step="".join(cards))


ENERGY = THICKNESS * 100 * 0.5 * 1e-8
CONFINED = [("internal", LAST, ENERGY * (BULK + 4 / 3 * SHEAR), 1e-2)]
PUSH = [(force("x"), LAST, FORCE, 1e-3)]

PROOFS = [
    Proof("ELEMENT: TYPE; SOLID SECTION", pulled(SQUARE, "all, 2\n"), CONFINED, "lambda + 2 mu: no strain across and along z"),
    Proof("ELEMENT: TYPE; SOLID SECTION", pulled(TRIANGLES, "all, 2\n"), CONFINED, "triangles"),
    Proof("ELEMENT: TYPE; SOLID SECTION", pulled(SQUARE, "1, 2\n2, 2\n"), [("internal", LAST, ENERGY * YOUNG / (1 - POISSON**2), 2e-2)], "E / (1 - nu^2) where the upper edge is free"),
    Proof("SOLID SECTION", pulled(SQUARE, "all, 2\n").replace(f"MATERIAL=steel\n{THICKNESS!r},", "MATERIAL=steel\n,"), [("internal", LAST, CONFINED[0][2] / THICKNESS, 1e-2)], "a thickness of 1"),
    Proof("CLOAD", pushed(f"*CLOAD\nright, 1, {0.5 * FORCE!r}\n"), PUSH, "a force on two nodes of the plane"),
    Proof("DSLOAD; SURFACE: NAME", pushed(f"*DSLOAD\ns, P, {-FORCE / (10 * THICKNESS)!r}\n"), PUSH, "a pressure on the second edge"),
    Proof("DLOAD", pushed(f"*DLOAD\ne, P2, {-FORCE / (10 * THICKNESS)!r}\n"), PUSH, "likewise"),
    Proof("INITIAL CONDITIONS: TYPE", abaqus(NODES, SQUARE, SECTION, "*INITIAL CONDITIONS, TYPE=VELOCITY\nall, 1, 100.\n"), [("momentum_x", LAST, 100 * DENSITY * 100 * THICKNESS, 1e-6)], "all nodes of both planes"),
    Proof("ELEMENT: TYPE", abaqus(NODES, SQUARE.replace("1, 1, 2, 3, 4", "1, 1, 2, 3, 9"), SECTION), refused="there is no node 9, of element 1"),
    Proof("ELEMENT: TYPE", abaqus(NODES, SQUARE, "*ELEMENT, TYPE=T3D2, ELSET=t\n5, 1, 3\n*SOLID SECTION, ELSET=t, MATERIAL=steel\n1.,\n", SECTION), refused="elements T3D2 on nodes of plane strain"),
]  # fmt: skip
