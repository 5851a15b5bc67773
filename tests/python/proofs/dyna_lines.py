"""Lines of cards: blank ones, cut numbers; two limits of one kind; forces of supports, of spot welds and of sections with limits."""

import math

from . import FIRST, LAST, Proof
from .dyna_laws import BULK, END, HARDENING, SHEAR, STIFF, STRAIN, UP, YOUNG, erosion_time, m24, plastic_strain, stretched, time_of
from .pieces import CUBE_MASS, cube, curve, deck, elastic, hexahedron, node_set, part, rigid, solid_section, two_cubes, velocity

ONES = curve(7, (0.0, 1.0), (1.0, 1.0))
RISES = curve(7, (0.0, 0.0), (END, 1.0), (2.0 * END, 2.0))
EROSION = "*MAT_ADD_EROSION\n1,0,0,0,{!r}\n0\n"
HELD = node_set(4, 1, 2, 3, 4) + node_set(5, 5, 6, 7, 8) + "*BOUNDARY_SPC_SET\n4,0,1,1,1\n5,0,1,1,0\n"
PULLED = "*BOUNDARY_PRESCRIBED_MOTION_SET\n5,3,2,7,0.01\n"
FORCE = STIFF * math.log(1.001) * 100.0
BLANK = " " * 40
TWICE = "*DEFINE_TRANSFORMATION\n5\nTRANSL,0,0,30\n*INCLUDE_TRANSFORM\npart.k\n{}\n1,1,1\n5\n*INCLUDE_TRANSFORM\npart.k\n{}\n1,1,1\n0\n"
PART = "*KEYWORD\n" + hexahedron() + part() + solid_section() + elastic() + "*END\n"
OFFSETS, NONE = "100,100,100,100,100,100,100\n100", "0\n0"


def fails_at(strain: float) -> list:
    """Plastic strain at which the stretched cube of m24() fails."""
    low, high = 0.0, STRAIN
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if plastic_strain(middle, 300.0, HARDENING) < strain else (low, middle)
    return [(erosion_time, LAST, time_of(UP, low), 2e-2)]


def kinematic(limit: float) -> str:
    return f"*MAT_PLASTIC_KINEMATIC\n1,7.8e-9,{YOUNG!r},{(3 * BULK - 2 * SHEAR) / (6 * BULK + 2 * SHEAR)!r},300.0,2000.0,1.0\n0,0,{limit!r}\n"


def supported(*more: str) -> str:
    """A cube that is pulled along z, confined across."""
    return deck(cube(elastic(1, 7.8e-9, YOUNG, (3 * BULK - 2 * SHEAR) / (6 * BULK + 2 * SHEAR))), HELD, PULLED, RISES, *more, end=END)


def limited(limits: str) -> str:
    """Two cubes side by side along x, each pulled as supported(); a plane across both."""
    second = hexahedron(2, 11, (10.0, 0.0, 0.0))
    sets = node_set(4, 1, 2, 3, 4, 11, 12, 13, 14) + node_set(5, 5, 6, 7, 8, 15, 16, 17, 18)
    return deck(cube(elastic(1, 7.8e-9, YOUNG, (3 * BULK - 2 * SHEAR) / (6 * BULK + 2 * SHEAR))), second, sets, "*BOUNDARY_SPC_SET\n4,0,1,1,1\n5,0,1,1,0\n", PULLED, RISES,
                f"*DATABASE_CROSS_SECTION_PLANE\n0,5.0,0.0,4.0,5.0,0.0,9.0{limits}\n*DATABASE_SECFORC\n1e-5\n", end=END)  # fmt: skip


DRIVEN_BODY = deck(cube(rigid(1)), "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n1,1,1,7,1e6\n*DATABASE_BNDOUT\n1e-5\n", ONES, end=1e-3)
SECTION = "DATABASE_CROSS_SECTION_PLANE"

PROOFS = [
    Proof("MAT_PIECEWISE_LINEAR_PLASTICITY: FAIL; MAT_ADD_EROSION: EFFEPS", stretched(m24(fail="0.006") + EROSION.format(-0.011), UP, rows=1000), fails_at(0.006), "each criterion acts by itself: the law's own comes first"),
    Proof("MAT_PIECEWISE_LINEAR_PLASTICITY: FAIL; MAT_ADD_EROSION: EFFEPS", stretched(m24(fail="0.011") + EROSION.format(-0.006), UP, rows=1000), fails_at(0.006), "or that of the addition does"),
    Proof("MAT_PLASTIC_KINEMATIC: FS; MAT_ADD_EROSION: EFFEPS", stretched(kinematic(0.006) + EROSION.format(-0.011), UP, rows=1000), fails_at(0.006), "FS beside it"),
    Proof("INITIAL_VELOCITY: NSID VX", deck(cube(), f"*INITIAL_VELOCITY\n{BLANK}\n     100.0       0.0\n"), [("momentum_x", FIRST, 100.0 * CUBE_MASS, 1e-9)], "a blank line is one of defaults: all nodes"),
    Proof("DEFINE_CURVE: LCID", supported("*DATABASE_SPCFORC\n1e-5\n").replace("*DEFINE_CURVE\n7\n0.0,0.0\n", f"*DEFINE_CURVE\n7\n{BLANK}\n"), [("fz:supports", LAST, -FORCE, 1e-2)], "a blank row is the point 0, 0"),
    Proof("CONTACT_AUTOMATIC_SINGLE_SURFACE", deck(two_cubes(0.01), "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n\n\n\n*INITIAL_VELOCITY_GENERATION\n2,2,0,0,0,-2000.0\n0\n", end=2e-5),
          [(lambda h: float(h["contact"][-1] != 0), LAST, 1.0, 1e-9)], "three blank lines: everything touches"),
    Proof("CONTROL_TERMINATION", deck(cube()).replace("*CONTROL_TERMINATION\n1e-05", "*CONTROL_TERMINATION\n7.708989925407158e-05"), refused="ENDTIM of *CONTROL_TERMINATION is cut (column 10 ends a field of 10 and cuts '7.708989925407158e-05')"),
    Proof("MAT_ELASTIC", deck(cube("*MAT_ELASTIC\n         1   7850.0 210000000000       0.3\n")), refused="E of *MAT_ELASTIC is cut (column 30"),
    Proof("NODE", deck(cube(), "*NODE\n      21      1.000000000000001      1.0             2.0\n"), refused="X of *NODE is cut (column 24"),
    Proof("DATABASE_SPCFORC: DT", supported("*DATABASE_SPCFORC\n1e-5\n"), [("fz:supports", LAST, -FORCE, 1e-2)], "the held nodes alone: those that are driven would cancel them"),
    Proof("DATABASE_BNDOUT: DT", supported("*DATABASE_BNDOUT\n1e-5\n"), [("fz:driven", LAST, FORCE, 1e-2)], "the driven nodes"),
    Proof("DATABASE_BNDOUT: DT; BOUNDARY_PRESCRIBED_MOTION_RIGID: PID DOF VAD LCID SF", DRIVEN_BODY, [("fx:driven_part_1", LAST, CUBE_MASS * 1e6, 1e-3)], "mass times acceleration of a driven body"),
    Proof(f"{SECTION}: RADIUS; DATABASE_SECFORC: DT", limited(",6.0\n0"), [("fz:section_1", LAST, FORCE, 1e-2)], "of one of the two cubes"),
    Proof(f"{SECTION}: XHEV YHEV ZHEV LENL LENM", limited("\n30.0,0.0,4.0,20.0,12.0").replace("0,5.0,0.0,4.0,5.0,0.0,9.0", "0,0.0,0.0,4.0,0.0,0.0,9.0"), [("fz:section_1", LAST, 2 * FORCE, 1e-2)], "a rectangle of 20 by 12 has both"),
    Proof(f"{SECTION}: LENL", limited("\n30.0,0.0,4.0,9.0,12.0").replace("0,5.0,0.0,4.0,5.0,0.0,9.0", "0,0.0,0.0,4.0,0.0,0.0,9.0"), [("fz:section_1", LAST, FORCE, 1e-2)], "one of 9 by 12 has one"),
    Proof("CONSTRAINED_LINEAR: NUM NID DOFX DOFY DOFZ COEF",
          deck(two_cubes(), "*CONSTRAINED_LINEAR\n", *(f"2\n{n},1,0,0,0,0,0,2.0\n{n + 10},0,1,0,0,0,0,1.0\n" for n in range(1, 9)), "*INITIAL_VELOCITY_GENERATION\n2,2,0,100.0,20.0\n0\n*DATABASE_MATSUM\n1e-7\n"),
          [("momentum_x:part_1", LAST, -8.0 * CUBE_MASS, 1e-6), ("momentum_y:part_2", LAST, 16.0 * CUBE_MASS, 1e-6)], "2 u + w = 0, as *CONSTRAINED_LINEAR_GLOBAL"),
    Proof("CONSTRAINED_LINEAR: DOFRX DOFRY DOFRZ", deck(cube(), "*CONSTRAINED_LINEAR\n2\n1,0,0,0,1,0,0,1.0\n2,1,0,0,0,0,0,1.0\n"), refused="an equation of rotations"),
    Proof("CONSTRAINED_LINEAR: NUM", deck(cube(), "*CONSTRAINED_LINEAR\n3\n1,1,0,0,0,0,0,1.0\n2,1,0,0,0,0,0,1.0\n"), refused="there are fewer lines of nodes"),
    Proof("INCLUDE_TRANSFORM: IDNOFF IDEOFF IDPOFF", deck(TWICE.format(OFFSETS, NONE), velocity(3.0)), [("momentum_x", FIRST, 2 * 3.0 * CUBE_MASS, 1e-9)], "one file with offsets of 100 and of 0", files={"part.k": PART}),
    Proof("INCLUDE_TRANSFORM: IDNOFF IDEOFF IDPOFF", deck(TWICE.format(NONE, OFFSETS), velocity(3.0)), [("momentum_x", FIRST, 2 * 3.0 * CUBE_MASS, 1e-9)], "in the other order", files={"part.k": PART}),
    Proof("INCLUDE_TRANSFORM: IDNOFF", deck(TWICE.format(OFFSETS, OFFSETS)), refused="is included twice", files={"part.k": PART}),
]  # fmt: skip
