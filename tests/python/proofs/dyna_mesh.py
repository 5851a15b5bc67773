"""Nodes, elements and their masses."""

from . import ALL, FIRST, Proof
from .pieces import CUBE_MASS, DENSITY, POISSON, YOUNG, cube, deck, elastic, force, node_set, nodes, part, shell, shell_section, solid_section, square, two_cubes, velocity

CORNERS = (0, 0, 0), (10, 0, 0), (10, 10, 0), (0, 10, 0), (0, 0, 10), (10, 0, 10), (10, 10, 10), (0, 10, 10)
SHELL_MASS = DENSITY * 100.0  # 1 mm thick
HELD = {1: "x", 2: "y", 3: "z", 4: "xy", 5: "yz", 6: "xz", 7: "xyz"}


def solid(lines: str, *more: tuple[float, ...]) -> str:
    """A part of one solid whose lines are given, with the corners of a cube of 10 mm."""
    corners = nodes(*((i, float(x), float(y), float(z)) for i, (x, y, z) in enumerate(CORNERS, 1)), *more)
    return deck(corners, f"*ELEMENT_SOLID\n{lines}", part(), solid_section(), elastic(), velocity(2.0))


def held(code: int) -> str:
    """A cube whose nodes are all held by TC."""
    rows = nodes(*((i, float(x), float(y), float(z), code, 0) for i, (x, y, z) in enumerate(CORNERS, 1)))
    return deck(rows, "*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n", part(), solid_section(), elastic(), "*LOAD_BODY_X\n7,1e8\n*LOAD_BODY_Y\n7,2e8\n"
                "*LOAD_BODY_Z\n7,3e8\n*DEFINE_CURVE\n7\n0,1\n1,1\n")  # fmt: skip


def volume(share: float):
    return [("momentum_x", ALL, 2.0 * share * CUBE_MASS, 1e-9)]


def mass(total: float, v: float = 2.0):
    return [("momentum_x", ALL, v * total, 1e-9)]


def thick(option: str, line: str) -> str:
    rows = square().replace("ELEMENT_SHELL\n", f"ELEMENT_SHELL{option}\n") + line
    return deck(rows, part(), shell_section(), elastic(), velocity(2.0))


def pushed(code: int):
    """Gravity of LOAD_BODY pulls against its axis: -g M (t - dt / 2), where the node is free."""
    rows = []
    for axis, g in zip("xyz", (1e8, 2e8, 3e8)):
        value = 0.0 if axis in HELD[code] else -g * CUBE_MASS
        rows.append((force(axis), ALL, value, 1e-9))
    return rows


PROOFS = [
    Proof("NODE: NID X Y Z; ELEMENT_SOLID: EID PID N1 N2 N3 N4 N5 N6 N7 N8; INITIAL_VELOCITY: VX VY VZ; SECTION_SOLID: SECID; MAT_ELASTIC: MID RO; "
          "PART: PID SECID MID",
          deck(cube(), velocity(100.0, 20.0, -30.0)),
          [("momentum_x", ALL, 100.0 * CUBE_MASS, 1e-9), ("momentum_y", FIRST, 20.0 * CUBE_MASS, 1e-9), ("momentum_z", FIRST, -30.0 * CUBE_MASS, 1e-9)],
          "momentum of 7.8e-6 t"),
    Proof("MAT_ELASTIC: RO; SECTION_SOLID: SECID", deck(two_cubes().replace(elastic(), "").replace(solid_section(), "").replace("part_2\n2,1,1", "part_2\n2,4,3"), velocity(2.0),
                                                        f"*MAT_ELASTIC_TITLE\n\n1,{DENSITY!r},{YOUNG!r},{POISSON!r}\n   \n3,{2 * DENSITY!r},{YOUNG!r},{POISSON!r}\n\n", "*SECTION_SOLID_TITLE\n\n1,1\n\n4,1\n"),
          mass(3.0 * CUBE_MASS), "the line of a title may be blank, for each of two cards behind one keyword"),
    Proof("MAT_ELASTIC: RO", deck(cube(f"*MAT_ELASTIC_TITLE\n1,2\n1,{2 * DENSITY!r},{YOUNG!r},{POISSON!r}\n"), velocity(2.0)), mass(2.0 * CUBE_MASS), "a title of numbers is a title"),
    *(Proof("NODE: TC", held(code), pushed(code), f"TC {code} holds {HELD[code]}") for code in HELD),
    Proof("ELEMENT_SOLID", solid("1,1\n1,2,3,4,5,6,7,8\n"), volume(1.0), "on two lines"),
    Proof("ELEMENT_SOLID", solid("1,1,1,2,3,4,5,5,8,8\n"), volume(1.0 / 2), "a wedge is half the cube: its triangles are 1 2 5 and 4 3 8"),
    Proof("ELEMENT_SOLID", solid("1,1,1,2,3,4,5,5,5,5\n"), volume(1.0 / 3), "a pyramid is a third of the cube"),
    Proof("ELEMENT_SOLID", solid("1,1,1,2,4,5,5,5,5,5\n"), volume(1.0 / 6), "a tetrahedron is a sixth of the cube"),
    Proof("ELEMENT_SOLID", solid("1,1\n1,2,4,5,11,12,13,14,15,16\n", (11, 5.0, 0.0, 0.0), (12, 5.0, 5.0, 0.0), (13, 0.0, 5.0, 0.0),
                                 (14, 0.0, 0.0, 5.0), (15, 5.0, 0.0, 5.0), (16, 0.0, 5.0, 5.0)), volume(1.0 / 6), "of ten nodes likewise"),
    Proof("ELEMENT_SOLID_ORTHO", solid("1,1\n1,2,4,4,5,6,8,8\n0,0,1.0\n1.0,0,0\n").replace("ELEMENT_SOLID", "ELEMENT_SOLID_ORTHO"), volume(1.0 / 2), "axes that an isotropic law does not see, of a wedge"),
    Proof("ELEMENT_SHELL: EID PID N1 N2 N3 N4", deck(shell(), velocity(2.0)), mass(SHELL_MASS), "density, area, thickness 1 mm"),
    Proof("ELEMENT_SHELL", deck(shell().replace("1,1,1,2,3,4\n", "1,1,1,2,3,3\n"), velocity(2.0)), mass(SHELL_MASS / 2), "a triangle is half of it"),
    Proof("ELEMENT_SHELL_THICKNESS: T1 T2 T3 T4 BETA", thick("_THICKNESS", "1.0,2.0,3.0,6.0,30.0\n"), mass(3.0 * SHELL_MASS), "the mean of the corners is 3 mm"),
    Proof("ELEMENT_SHELL_BETA: T1 T2 T3 T4 BETA", thick("_BETA", "2.0,2.0,2.0,2.0,45.0\n"), mass(2.0 * SHELL_MASS), "2 mm; the angle is of laws with axes"),
    Proof("ELEMENT_SHELL_MCID: T1 T2 T3 T4 BETA", thick("_MCID", "2.0,2.0,2.0,2.0,7\n"), mass(2.0 * SHELL_MASS), "2 mm; the system is of laws with axes"),
    Proof("PART_REPOSITION: CMSN MDEP MOVOPT", deck(cube().replace("*PART\npart_1\n1,1,1\n", "*PART_REPOSITION\npart_1\n1,1,1\n3,4,5\n")), refused="PART_REPOSITION.MDEP"),
    Proof("PART_PRINT", deck(cube().replace("*PART\npart_1\n1,1,1\n", "*PART_PRINT\npart_1\n1,1,1\n2\n"), velocity(2.0)), mass(CUBE_MASS), "its line is output"),
    Proof("PART_ATTACHMENT_NODES", deck(cube().replace("*PART\npart_1\n1,1,1\n", "*PART_ATTACHMENT_NODES\npart_1\n1,1,1\n5\n"), velocity(2.0)), mass(CUBE_MASS),
          "nodes of modes, which an explicit run does not need"),
    Proof("ELEMENT_SHELL_OFFSET: OFFSET", thick("_OFFSET", "0.5\n"), refused="ELEMENT_SHELL.OFFSET"),
    Proof("ELEMENT_SHELL_COMPOSITE", thick("_COMPOSITE", "1,1.0,0.0\n"), refused="ELEMENT_SHELL_COMPOSITE"),
    Proof("ELEMENT_PLOTEL", deck(cube(), "*ELEMENT_PLOTEL\n9,1,2\n", velocity(2.0)), mass(CUBE_MASS), "lines for pictures have no mass"),
    Proof("ELEMENT_MASS: ID MASS", deck(cube(), "*ELEMENT_MASS\n1,3,2e-6\n2,5,3e-6\n", velocity(2.0)), mass(CUBE_MASS + 5e-6), "M + 2e-6 + 3e-6"),
    Proof("ELEMENT_MASS_NODE_SET: ID MASS",
          deck(cube(), "*ELEMENT_MASS_NODE_SET\n1,9,4e-6\n", node_set(9, 1, 2, 3, 4), node_set(8, 1, 2), "*INITIAL_VELOCITY\n8\n2.0\n"),
          [("momentum_x", FIRST, 2.0 * (CUBE_MASS / 4 + 2e-6), 1e-9)], "MASS is divided among the four: two of eight nodes have M / 4 + 4e-6 / 2"),
    Proof("ELEMENT_MASS_PART: ID ADDMASS", deck(two_cubes(), "*ELEMENT_MASS_PART\n2,4e-6\n", velocity(2.0)), mass(2 * CUBE_MASS + 4e-6), "2 M + ADDMASS"),
    Proof("ELEMENT_MASS_PART: FINMASS", deck(two_cubes(), "*ELEMENT_MASS_PART\n2,0,9e-6\n", velocity(2.0)), mass(CUBE_MASS + 9e-6), "M + FINMASS"),
    Proof("ELEMENT_MASS_PART: LCID", deck(cube(), "*ELEMENT_MASS_PART\n1,4e-6,0,7\n*DEFINE_CURVE\n7\n0,1\n1,1\n"), refused="ELEMENT_MASS_PART.LCID"),
    Proof("ELEMENT_MASS_PART_SET: ID ADDMASS MWD; SET_PART_LIST: SID",
          deck(two_cubes(), "*SET_PART_LIST\n6\n1,2\n*ELEMENT_MASS_PART_SET\n6,4e-6,0,0,1\n", velocity(2.0)), mass(2 * CUBE_MASS + 4e-6), "2 M + ADDMASS"),
]  # fmt: skip

NOT_PHYSICS = {"TITLE": "a name", "ELEMENT_MASS_PART.MWD": "of one part: its elements have one density"}
