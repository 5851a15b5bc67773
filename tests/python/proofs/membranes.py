"""Membranes and fabrics: Green's strain of large deformations, tension fields, and sheets that do not bend."""

import math

from . import FIRST, LAST, Proof
from .pieces import DENSITY, POISSON, YOUNG, abaqus, curve, deck, elastic, part, square, velocity

END = 1e-3
EA, EB, PRBA, GAB = 3000.0, 2000.0, 0.1, 50.0
THICKNESS, AREA = 0.4, 100.0
PULL, SHEAR, SHORT = (0.1, 0.05, 0.2), (0.0, 0.0, 0.2), (0.1, -0.3, 0.0)  # F = [[1 + xx, xy], [0, 1 + yy]]
SHELL = f"*SECTION_SHELL\n1,{{}},1.0,1\n{THICKNESS},{THICKNESS},{THICKNESS},{THICKNESS}\n"


def m34(first=f"{EA},{EB},0,{PRBA}", shear=f"{GAB},0,0,0", options="2.0", point="0,0,0,1.0,0,0", vectors="0"):
    """*MAT_FABRIC; PRBA is nu_ba."""
    return f"*MAT_FABRIC\n2,1.4e-9,{first}\n{shear}\n{options}\n{point}\n{vectors}\n"


def pulled(material, e=PULL, form=5, elements="", identity=2):
    """A membrane of 10 mm that gets the displacements of F."""
    points = {1: (0, 0), 2: (1, 0), 3: (1, 1), 4: (0, 1)}
    moves = [(node, 1, 10 * (e[0] * x + e[2] * y)) for node, (x, y) in points.items()] + [(node, 2, 10 * e[1] * y) for node, (x, y) in points.items()]
    lines = "".join(f"{node},{direction},0,{7 if way else 8},{way or 1.0!r}\n" for node, direction, way in moves)  # a factor of 0 is 1
    return deck(elements or square(), part(1, 1, identity), SHELL.format(form), material, "*BOUNDARY_SPC_NODE\n1,0,0,0,1,1,1,1\n2,0,0,0,1\n3,0,0,0,1\n4,0,0,0,1\n",
                f"*BOUNDARY_PRESCRIBED_MOTION_NODE\n{lines}", curve(7, (0.0, 1 / END), (1.0, 1 / END)), curve(8, (0.0, 0.0), (1.0, 0.0)), end=END)  # fmt: skip


def find_strain(e, angle):
    """Green's, 11, 22 and 12 of a warp at an angle to x."""
    f = ((1 + e[0], e[2]), (0.0, 1 + e[1]))
    c, s = math.cos(angle), math.sin(angle)
    a, b = ([f[i][0] * x + f[i][1] * y for i in (0, 1)] for x, y in ((c, s), (-s, c)))
    return 0.5 * (a[0] ** 2 + a[1] ** 2 - 1), 0.5 * (b[0] ** 2 + b[1] ** 2 - 1), 0.5 * (a[0] * b[0] + a[1] * b[1])


def sheet(e=PULL, angle=0.0, ea=EA, eb=EB, ba=PRBA, gab=GAB):
    """Energy of a sheet that bears compression."""
    e11, e22, e12 = find_strain(e, angle)
    ab = ba * ea / eb
    q = 1 / (1 - ab * ba)
    density = 0.5 * q * (ea * e11**2 + eb * e22**2 + 2 * ab * eb * e11 * e22) + 2 * gab * e12**2
    return [("internal", LAST, THICKNESS * AREA * density, 2e-3)]


def field(e, ea=EA, eb=EB, ba=PRBA, gab=GAB):
    """Energy of a tension field: the largest of a tension along any direction; a thousandth is that of the sheet."""
    e11, e22, e12 = find_strain(e, 0.0)
    largest = 0.0
    for i in range(20000):
        c, s = math.cos(math.pi * i / 20000), math.sin(math.pi * i / 20000)
        strain = c * c * e11 + 2 * c * s * e12 + s * s * e22
        if strain > 0:
            largest = max(largest, 0.5 * strain**2 / (c**4 / ea + s**4 / eb + (1 / gab - 2 * ba / eb) * c * c * s * s))
    whole = sheet(e, 0.0, ea, eb, ba, gab)[0][2] / (THICKNESS * AREA)
    return [("internal", LAST, THICKNESS * AREA * (0.999 * largest + 0.001 * whole), 2e-3)]


def twisted(form, material=""):
    """Corners that fly up and down: a sheet that does not bend flies on."""
    rows = "".join(f"{node},0,0,{100.0 if node % 2 else -100.0}\n" for node in (1, 2, 3, 4))
    return deck(square(), part(), SHELL.format(form), material or elastic(), f"*INITIAL_VELOCITY_NODE\n{rows}", end=1e-5)


FLIES = [("kinetic", LAST, 0.5 * DENSITY * THICKNESS * AREA * 100.0**2, 1e-4)]
WARP = "0,0,0,2.0,1.0,5.0"
ANGLE = math.atan2(1, 2)
QUAD = "*NODE, NSET=all\n1, 0., 0., 0.\n2, 10., 0., 0.\n3, 10., 10., 0.\n4, 0., 10., 0.\n*ELEMENT, TYPE={}, ELSET=sheet\n1, 1, 2, 3, 4\n"
STEEL = f"*MATERIAL, NAME=steel\n*DENSITY\n{DENSITY!r}\n*ELASTIC\n{YOUNG!r}, {POISSON!r}\n"
UP = "*INITIAL CONDITIONS, TYPE=VELOCITY\n1, 3, 100.\n2, 3, -100.\n3, 3, 100.\n4, 3, -100.\n"
STRETCH = math.log(1.01)

PROOFS = [
    Proof("MAT_FABRIC: MID EA EB PRBA GAB AOPT A1 A2 A3", pulled(m34(point=WARP)), sheet(angle=ANGLE), "linear in Green's strain by the threads, of which the warp lies along A"),
    Proof("MAT_FABRIC: RO", deck(square(), part(1, 1, 2), SHELL.format(5), m34(), velocity(100.0)), [("momentum_x", FIRST, 100.0 * 1.4e-9 * THICKNESS * AREA, 1e-9)], "its mass"),
    Proof("MAT_FABRIC: EA EB PRBA GAB", pulled(m34(f"{EA},0,0,0.25", "0")), sheet(eb=EA, ba=0.25, gab=EA / 2.5), "isotropic without EB and GAB"),
    Proof("MAT_FABRIC: PRAB", pulled(m34(f"{EA},{EB},0,{PRBA},{PRBA * EA / EB!r}")), sheet(), "nu_ab that follows from nu_ba"),
    Proof("MAT_FABRIC: PRAB", pulled(m34(f"{EA},0,0,0.25,0.25", "0")), sheet(eb=EA, ba=0.25, gab=EA / 2.5), "isotropic: both are one"),
    Proof("MAT_FABRIC: PRAB", pulled(m34(f"{EA},{EB},0,{PRBA},0.3")), refused="PRAB is 0.3"),
    Proof("MAT_FABRIC: AOPT", pulled(m34(options="0")), sheet(), "the first side is along x"),
    Proof("MAT_FABRIC: AOPT V1 V2 V3", pulled(m34(options="3.0", vectors="1.0,0,0")), refused="an angle of the warp"),
    Proof("MAT_FABRIC: BETA", pulled(m34(options="0", vectors="0,0,0,0,0,0,30.0")), refused="an angle of the warp"),
    Proof("MAT_FABRIC: CSE", pulled(m34(shear=f"{GAB},0,0,1.0"), SHEAR), field(SHEAR), "a tension field"),
    Proof("MAT_FABRIC: CSE", pulled(m34(shear=f"{GAB},0,0,1.0"), SHORT), field(SHORT), "pulled along x and pushed along y"),
    Proof("MAT_FABRIC: CSE", pulled(m34(), SHORT), sheet(SHORT), "a sheet that bears compression"),
    *(Proof("MAT_FABRIC: FORM", pulled(m34(options=f"2.0,0,0,0,0,{form}")), sheet(), "Green's strain of threads that turn") for form in (1, 2, 3)),
    *(Proof("MAT_FABRIC: FORM", pulled(m34(options=f"2.0,0,0,0,0,{form}")), refused=f"form {form} of fabrics") for form in (4, 12, 13, 14, -14, 24)),
    Proof("MAT_FABRIC: DAMP", pulled(m34(shear=f"{GAB},0,0,0,0,0,0,0.05")), sheet(), "damping is told of, and left out"),
    Proof("MAT_FABRIC: EL PRL LRATIO LNRC", pulled(m34(shear=f"{GAB},0,0,0,100.0,0.3,0.2", options="2.0,0,0,0,1.0")), refused="LRATIO"),
    Proof("MAT_FABRIC: PRL LNRC", pulled(m34(shear=f"{GAB},0,0,0,0,0.3", options="2.0,0,0,0,1.0")), sheet(), "without a liner they say nothing"),
    Proof("MAT_FABRIC: FLC FVOPT", pulled(m34(options="2.0,0.1,0,0,0,0,-1\n1.0")), refused="FLC"),
    Proof("MAT_FABRIC", pulled(m34(), form=2), sheet(), "membranes, whatever the section says"),
    Proof("MAT_FABRIC", pulled(m34()).replace("ELEMENT_SHELL", "ELEMENT_SHELL_BETA").replace("1,1,1,2,3,4\n", "1,1,1,2,3,4\n0,0,0,0,20.0\n"), refused="an angle of the warp"),
    *(Proof("SECTION_SHELL: ELFORM", twisted(form), FLIES, "a membrane does not bend") for form in (5, 9)),
    Proof("SECTION_SHELL: ELFORM", pulled(elastic(), (0.01, 0.01, 0.0), 5, identity=1),
          [("internal", LAST, THICKNESS * AREA * YOUNG / (1 - POISSON) * STRETCH**2, 2e-2)], "plane stress, stretched equally"),
    Proof("SECTION_SHELL: NLOC", twisted(5).replace(f"{THICKNESS}\n", f"{THICKNESS},1.0\n", 1), FLIES, "nor about an offset"),
    *(Proof("ELEMENT: TYPE; MEMBRANE SECTION: ELSET MATERIAL", abaqus(QUAD.format(kind), f"*MEMBRANE SECTION, ELSET=sheet, MATERIAL=steel\n{THICKNESS},\n" + STEEL, UP), FLIES, "a membrane does not bend")
      for kind in ("M3D4", "M3D4R")),
    Proof("ELEMENT: TYPE", abaqus(QUAD.format("M3D3").replace("1, 1, 2, 3, 4", "1, 1, 2, 3\n2, 1, 3, 4"), f"*MEMBRANE SECTION, ELSET=sheet, MATERIAL=steel\n{THICKNESS},\n" + STEEL, UP),
          [("internal", LAST, 0.0, 1e-6)], "triangles fold along their common side"),
]  # fmt: skip
