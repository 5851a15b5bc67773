"""Thick shells: a cube of 10 mm that is bent far beyond its yield stress, as a wide plate. Its energy tells how many points are across."""

import math

from . import FIRST, LAST, Proof
from .pieces import CORNERS, CUBE_MASS, DENSITY, POISSON, YOUNG, abaqus, curve, deck, hexahedron, part, solid_section, velocity

D = 0.1  # how far top and bottom move apart
END = 1e-4
YIELD = 100.0
SECTION = "*SECTION_TSHELL\n1,{}\n"
POINTS = {3: ((5 / 9, math.sqrt(0.6)), (8 / 9, 0.0)), 5: ((0.2369268850561891, 0.906179845938664), (0.4786286704993665, 0.5384693101056831), (128 / 225, 0.0))}


def energy(points: int, axis_length: float = 10.0):
    """Of points that yield ideally in plane strain: the stress 2 / sqrt(3) YIELD times the strain, less the elastic part that is not reached."""
    stress, modulus = 2 / math.sqrt(3) * YIELD, YOUNG / (1 - POISSON**2)
    total = 0.0
    for weight, place in POINTS[points]:
        strain = place * 2 * D / axis_length  # D over half of the length is the angle of the end; the surface strains by half of the thickness times the curvature
        total += weight * (stress * strain - stress**2 / (2 * modulus) if place else 0.0)
    return [("internal", LAST, 1000.0 * total, 3e-2)]


def bend(across: int = 2) -> list[tuple[int, int, float]]:
    """Node, direction and displacement at the end. Along: the direction after the one across; the ends there turn against each other."""
    along, still = (across + 1) % 3, (across + 2) % 3
    rows = []
    for id, corner in enumerate(CORNERS, 1):
        rows += [(id, along, D * (2 * corner[across] - 1) * (2 * corner[along] - 1)), (id, across, 0.0), (id, still, 0.0)]
    return rows


BENT = "*BOUNDARY_PRESCRIBED_MOTION_NODE\n" + "".join(f"{id},{dof + 1},2,7,{d!r}\n" for id, dof, d in bend()) + curve(7, (0.0, 0.0), (END, 1.0))
IDEAL = f"*MAT_PIECEWISE_LINEAR_PLASTICITY\n1,{DENSITY!r},{YOUNG!r},{POISSON!r},{YIELD!r},0.0,0\n0\n0\n0\n"
THICK = hexahedron().replace("ELEMENT_SOLID", "ELEMENT_TSHELL")


def bent(section: str, elements: str = THICK) -> str:
    return deck(elements, part(), SECTION.format(section), IDEAL, BENT, end=END)


STEEL = f"*MATERIAL, NAME=steel\n*DENSITY\n{DENSITY!r}\n*ELASTIC\n{YOUNG!r}, {POISSON!r}\n*PLASTIC\n{YIELD!r}, 0.\n"
ROWS = "".join(f"{i}, {10.0 * x}, {10.0 * y}, {10.0 * z}\n" for i, (x, y, z) in enumerate(CORNERS, 1))
HEX = "*ELEMENT, TYPE=SC8R, ELSET=cube\n1, 1, 2, 3, 4, 5, 6, 7, 8\n"


def bent_sc8r(section: str, across: int = 2, more: str = STEEL) -> str:
    moves = "".join(f"{id}, {dof + 1}, {dof + 1}, {d!r}\n" for id, dof, d in bend(across))
    step = f"*BOUNDARY, AMPLITUDE=ramp\n{moves}"
    return abaqus(f"*NODE, NSET=all\n{ROWS}{HEX}", section, more, f"*AMPLITUDE, NAME=ramp\n0., 0., {END!r}, 1.\n", end=END, step=step)


PROOFS = [
    Proof("ELEMENT_TSHELL: EID PID N1 N2 N3 N4 N5 N6 N7 N8; SECTION_TSHELL: SECID", deck(THICK, part(), SECTION.format("1"), IDEAL, velocity(2.0)), [("momentum_x", FIRST, 2.0 * CUBE_MASS, 1e-9)], "the mass of the cube"),
    Proof("SECTION_TSHELL: NIP", bent("2,1.0,3"), energy(3), "three points across"),
    Proof("SECTION_TSHELL: NIP", bent("2,1.0,5"), energy(5), "five points across"),
    Proof("SECTION_TSHELL: NIP", bent("2,1.0,7"), energy(5), "five points are the most"),
    Proof("SECTION_TSHELL: SHRF PROPT TSHEAR", bent("2,0.8333,3,1.0,0,0,1"), energy(3), "bending has no transverse shear; printing is output"),
    *(Proof("SECTION_TSHELL: ELFORM", bent(f"{form},1.0,3"), energy(3), "each formulation of solids is that of percuss") for form in (0, 1, 2, 3, 5, 6, 7)),
    Proof("SECTION_TSHELL: ELFORM", bent("4,1.0,3"), refused="formulation 4 of thick shells"),
    Proof("SECTION_TSHELL: QR", bent("2,1.0,3,0,-7"), refused="rule of integration"),
    Proof("SECTION_TSHELL: QR", bent("2,1.0,3,0,1"), energy(3), "rules of LS-DYNA are Gauss points here"),
    Proof("SECTION_TSHELL: ICOMP", bent("2,1.0,3,0,0,1\n30.0,0.0,30.0"), refused="angles of plies"),
    Proof("ELEMENT_TSHELL", bent("2", "*ELEMENT_TSHELL\n9,1,1,2,3,3,5,6,7,7\n" + hexahedron().replace("ELEMENT_SOLID", "ELEMENT_TSHELL")), refused="6 different nodes"),
    Proof("ELEMENT_TSHELL", deck(THICK, part(), solid_section(), IDEAL), refused="section of another kind", messages=1),
    Proof("SECTION_TSHELL", deck(hexahedron(), part(), SECTION.format("1"), IDEAL), refused="section of another kind", messages=1),
    Proof("SHELL SECTION: ELSET MATERIAL", bent_sc8r("*SHELL SECTION, ELSET=cube, MATERIAL=steel\n10., 3\n"), energy(3), "SC8R with three points across"),
    Proof("SHELL SECTION: ELSET MATERIAL", bent_sc8r("*SHELL SECTION, ELSET=cube, MATERIAL=steel\n10., 5\n"), energy(5), "SC8R with five points across"),
    *(Proof("SHELL SECTION: STACK_DIRECTION", bent_sc8r(f"*SHELL SECTION, ELSET=cube, MATERIAL=steel, STACK DIRECTION={i}\n10., 5\n", i - 1), energy(5), "the direction across") for i in (1, 2, 3)),
    Proof("SHELL SECTION: STACK_DIRECTION", bent_sc8r("*SHELL SECTION, ELSET=cube, MATERIAL=steel, STACK DIRECTION=ORIENTATION\n10., 5\n"), refused="stack direction ORIENTATION"),
    Proof("SHELL SECTION: OFFSET", bent_sc8r("*SHELL SECTION, ELSET=cube, MATERIAL=steel, OFFSET=SPOS\n10., 5\n"), refused="an offset of SC8R"),
    Proof("SHELL SECTION: COMPOSITE", bent_sc8r("*SHELL SECTION, ELSET=cube, COMPOSITE\n5., 3, steel\n5., 3, copper\n", more=STEEL + STEEL.replace("steel", "copper")), refused="layers of several materials"),
    Proof("SOLID SECTION", bent_sc8r("*SOLID SECTION, ELSET=cube, MATERIAL=steel\n"), refused="another section than one of shells"),
]  # fmt: skip
