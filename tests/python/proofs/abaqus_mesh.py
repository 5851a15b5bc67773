"""Nodes, elements, sets, instances and sections: the momentum of what moves is its mass."""

from . import ALL, FIRST, LAST, Proof
from .pieces import CORNERS, CUBE_MASS, DENSITY, POISSON, YOUNG, abaqus, abaqus_cube, force

STEEL = f"*MATERIAL, NAME=steel\n*DENSITY\n{DENSITY!r}\n*ELASTIC\n{YOUNG!r}, {POISSON!r}\n"
SOLID = "*SOLID SECTION, ELSET=cube, MATERIAL=steel\n" + STEEL
MOVING = "*INITIAL CONDITIONS, TYPE=VELOCITY\nall, 1, 100.\n"
ALL_MOVE = [("momentum_x", ALL, 100.0 * CUBE_MASS, 1e-9)]
ROWS = "".join(f"{i}, {10.0 * x}, {10.0 * y}, {10.0 * z}\n" for i, (x, y, z) in enumerate(CORNERS, 1))
HEX = "*ELEMENT, TYPE=C3D8R, ELSET=cube\n1, 1, 2, 3, 4, 5, 6, 7, 8\n"
QUAD = "*NODE, NSET=all\n1, 0., 0., 0.\n2, 10., 0., 0.\n3, 10., 10., 0.\n4, 0., 10., 0.\n*ELEMENT, TYPE={}, ELSET=sheet\n1, 1, 2, 3, 4\n"
BEAM = "*NODE, NSET=all\n1, 0., 0., 0.\n2, 10., 0., 0.\n*ELEMENT, TYPE={}, ELSET=bar\n1, 1, 2\n"


def moved(mesh: str, sections: str = SOLID) -> str:
    return abaqus(mesh, sections, MOVING)


def sheet(section: str, kind: str = "S4R", more: str = "", after: str = "") -> str:
    return moved(QUAD.format(kind) + more, section + STEEL + after)


MODULI = f"{YOUNG!r}, {YOUNG / (2 * (1 + POISSON))!r}\n"


def twisted(section: str) -> str:
    """A beam that spins about its axis."""
    return abaqus(BEAM.format("B31"), section, "*INITIAL CONDITIONS, TYPE=ROTATING VELOCITY\nall, 7.\n0., 0., 0., 1., 0., 0.\n")


def of(volume: float) -> list:
    return [("momentum_x", FIRST, 100.0 * DENSITY * volume, 1e-9)]


def instances(sets: str, where: str, second: str = "") -> str:
    """Two instances of a cube, the second one moved by 30 mm and turned by 90 degrees."""
    part = f"*PART, NAME=p\n*NODE, NSET=own\n{ROWS}{HEX}*SOLID SECTION, ELSET=cube, MATERIAL=steel\n*END PART\n"
    assembly = ("*ASSEMBLY, NAME=a\n*INSTANCE, NAME=one, PART=p\n*END INSTANCE\n*INSTANCE, NAME=two, PART=p\n30., 0., 0.\n30., 0., 0., 30., 0., 1., 90.\n*END INSTANCE\n"
                f"{sets}*END ASSEMBLY\n")  # fmt: skip
    return abaqus(part, assembly, STEEL, f"*INITIAL CONDITIONS, TYPE=VELOCITY\n{where}, 1, 100.\n", second)


PLANE = "*SOLID SECTION, ELSET=sheet, MATERIAL=steel\n2.5,\n" + STEEL
EDGE = "*SURFACE, NAME=edge\nsheet, S2\n1, S2\n"


def plane(step: str, *more: str) -> str:
    """A square of plane stress with the edge x = 10 as a surface."""
    return abaqus(QUAD.format("CPS4R"), PLANE, EDGE, *more, step=step)


def strip(ends: str, count: int, *generators: str) -> str:
    """Shells between nodes 1, 2, ... and 11, 12, ..., 1 mm thick, of generated nodes."""
    lines = "".join(f"*NGEN{text}\n" for text in generators)
    return moved(f"*NODE\n{ends}{lines}*ELEMENT, TYPE=S4R\n1, 1, 2, 12, 11\n*ELGEN, ELSET=sheet\n1, {count}, 1, 1\n*NSET, NSET=all, ELSET=sheet\n",
                 "*SHELL SECTION, ELSET=sheet, MATERIAL=steel\n1., 5\n" + STEEL)  # fmt: skip


def twice(*scalings: str) -> str:
    """Two steps, each with its mass scaling."""
    steps = "".join(f"*STEP\n*DYNAMIC, EXPLICIT\n, 1e-5\n*FIXED MASS SCALING, {text}\n*END STEP\n" for text in scalings)
    return f"*HEADING\nproof\n{abaqus_cube()}{MOVING}{steps}"


ARC = ", 5., 53.13010235415598, 0."  # the centre (3, 4, 0) in cylindrical coordinates
PROOFS = [
    Proof("NODE: NSET; ELEMENT: TYPE ELSET; SOLID SECTION: ELSET MATERIAL; MATERIAL: NAME; DENSITY; INITIAL CONDITIONS: TYPE",
          abaqus(abaqus_cube(), "*INITIAL CONDITIONS, TYPE=VELOCITY\nall, 1, 100.\nall, 2, -20.\n"),
          [("momentum_x", ALL, 100.0 * CUBE_MASS, 1e-9), ("momentum_y", ALL, -20.0 * CUBE_MASS, 1e-9)],
          "momentum of 7.8e-6 t"),
    Proof("INITIAL CONDITIONS: TYPE", abaqus(abaqus_cube(), "*INITIAL CONDITIONS, TYPE=ROTATING VELOCITY\nall, 5., 7., 0., 0.\n0., 0., 3., 0., 0., 9.\n"),
          [("momentum_x", FIRST, (7.0 - 5.0 * 5.0) * CUBE_MASS, 1e-6), ("momentum_y", FIRST, 25.0 * CUBE_MASS, 1e-6)], "v + w x r about the edge at x = y = 0"),
    Proof("NODE: INPUT; ELEMENT: INPUT", moved("*NODE, NSET=all, INPUT=n.txt\n*ELEMENT, TYPE=C3D8R, ELSET=cube, INPUT=e.txt\n"), ALL_MOVE, "a cube of 1000 mm3",
          files={"n.txt": ROWS, "e.txt": "1, 1, 2, 3, 4, 5, 6, 7, 8\n"}),
    Proof("INCLUDE", abaqus("*INCLUDE, INPUT=mesh.txt\n", SOLID, MOVING), ALL_MOVE, "a cube of 1000 mm3", files={"mesh.txt": f"*NODE, NSET=all\n{ROWS}{HEX}"}),
    Proof("INCLUDE", moved("*NODE, NSET=all\n*INCLUDE, INPUT=n.txt\n8, 0., 10., 10.\n*ELEMENT, TYPE=C3D8R, ELSET=cube\n*INCLUDE, INPUT=e.txt\n*ELSET, ELSET=again, GENERATE\n*INCLUDE, INPUT=e.txt\n"), ALL_MOVE,
          "data lines in files, the last node behind them, and a file that comes twice", files={"n.txt": "".join(ROWS.splitlines(True)[:7]), "e.txt": "1, 1, 2, 3, 4, 5, 6, 7, 8\n"}),
    Proof("INCLUDE", abaqus("*INCLUDE, INPUT=again.txt\n"), refused="include each other too deeply", files={"again.txt": "*INCLUDE, INPUT=again.txt\n"}),
    Proof("INITIAL CONDITIONS: TYPE", moved("*NODE, NSET=all\n" + ROWS + HEX + "*INITIAL CONDITIONS, TYPE=SOLUTION\ncube, 0.1, 0.2\n"), ALL_MOVE, "state variables of user code change nothing"),
    Proof("PARAMETER", moved("*PARAMETER\nwidth = 5.\nlength = 2*width\n*NODE, NSET=all\n" + ROWS.replace("10.0", "<length>") + HEX), ALL_MOVE, "edges of 2 times 5 mm"),
    Proof("NODE: SYSTEM", moved("*NODE, NSET=all, SYSTEM=C\n1, 0., 0., 0.\n2, 10., 0., 0.\n3, 14.142135624, 45., 0.\n4, 10., 90., 0.\n5, 0., 0., 10.\n6, 10., 0., 10.\n7, 14.142135624, 45., 10.\n"
                                "8, 10., 90., 10.\n" + HEX), ALL_MOVE, "a cube by radius and angle"),
    Proof("NODE: SYSTEM", moved("*NODE, NSET=all, SYSTEM=S\n1, 0., 0., 0.\n2, 10., 0., 0.\n3, 14.142135624, 45., 0.\n4, 10., 90., 0.\n5, 10., 0., 90.\n6, 14.142135624, 0., 45.\n"
                                "7, 17.320508076, 45., 35.26438968\n8, 14.142135624, 90., 45.\n" + HEX), ALL_MOVE, "a cube by radius and two angles"),
    Proof("SYSTEM", abaqus(f"*SYSTEM\n5., 0., 0., 5., 1., 0.\n4., 0., 0.\n*NODE, NSET=all\n{ROWS}*SYSTEM\n*NODE\n9, 0., 0., 0.\n{HEX}", SOLID,
                           "*INITIAL CONDITIONS, TYPE=ROTATING VELOCITY\nall, 5., 0., 0., 0.\n0., 0., 0., 0., 0., 1.\n"),
          [("momentum_x", FIRST, -25.0 * CUBE_MASS, 1e-6), ("momentum_y", FIRST, 0.0, 1e-12)], "moved by 5 and turned by 90 degrees: its centre lies at x = 0, y = 5"),
    Proof("SYSTEM", abaqus(f"*SYSTEM\n5., 0., 0., 5., 1., 7.\n*NODE, NSET=all\n{ROWS}{HEX}", SOLID, "*INITIAL CONDITIONS, TYPE=ROTATING VELOCITY\nall, 5., 0., 0., 0.\n0., 0., 0., 0., 1., 0.\n"),
          [("momentum_x", FIRST, 25.0 * CUBE_MASS, 1e-6), ("momentum_z", FIRST, 0.0, 1e-12)], "without the third point z stays: turned by 90 degrees about it, the centre lies at (0, 5, 5)"),
    Proof("SYSTEM", moved(f"*SYSTEM\n5., 0., 0., 5., 0., 7.\n*NODE, NSET=all\n{ROWS}{HEX}"), refused="lies above the origin"),
    Proof("INITIAL CONDITIONS: TYPE; SOLID SECTION", abaqus(abaqus_cube().replace("*SOLID SECTION", "*SOLID SECT"), "*INITIAL CONDITION, TYPE=VELOCITY\nall, 1, 100.\n"), ALL_MOVE, "keywords that are shortened"),
    Proof("INITIAL CONDITIONS", abaqus(abaqus_cube(), "*CONTA\n"), refused="an unknown keyword"),
    Proof("TRANSVERSE SHEAR; TRANSVERSE SHEAR STIFFNESS", moved(f"*NODE, NSET=all\n{ROWS}{HEX}", SOLID + "*TRANSVERSE SHEAR\n1., 1., 0.\n*TRANSVERSE SHEAR STIFFNESS\n1., 1., 0.\n"), ALL_MOVE, "solids have none"),
    Proof("TRANSVERSE SHEAR STIFFNESS", sheet("*SHELL SECTION, ELSET=sheet, MATERIAL=steel\n2.5, 5\n*TRANSVERSE SHEAR STIFFNESS\n1., 1., 0.\n"), refused="a transverse shear stiffness of its own"),
    Proof("ELEMENT: TYPE; SOLID SECTION", moved(QUAD.format("CPS4R"), PLANE), of(250.0), "plane stress: 100 mm2 of 2.5 mm"),
    Proof("ELEMENT: TYPE; SOLID SECTION", moved(QUAD.format("CPS4R"), PLANE.replace("2.5,\n", ",\n")), of(100.0), "a thickness of 1 by default"),
    Proof("ELEMENT: TYPE", plane("*BULK VISCOSITY\n0., 0.\n*BOUNDARY\nall, 2, 2\n1, 1, 1\n4, 1, 1\n*BOUNDARY, TYPE=VELOCITY\n2, 1, 1, 1000.\n3, 1, 1, 1000.\n"),
          [("internal", LAST, 0.5 * YOUNG / (1 - POISSON**2) * 1e-6 * 250.0, 5e-3)], "E / (1 - nu^2) times a strain of 1e-3 along x"),
    Proof("DSLOAD; ELEMENT: TYPE", plane("*DSLOAD\nedge, TRVEC, 0.1, 3., 4., 0.\n"), [(force("x"), LAST, 1.5, 1e-6), (force("y"), LAST, 2.0, 1e-6)], "0.1 MPa on an edge of 10 x 2.5 mm2"),
    Proof("DSLOAD; AMPLITUDE", plane("*DSLOAD, AMPLITUDE=a\nedge, TRVEC, 0.1, 1., 0., 0.\n", "*AMPLITUDE, NAME=a\n0., 0., 1e-5, 1.\n"), [(lambda h: h["momentum_x"][-1] / (h["time"][-1] - 0.5 * h["dt"][-1]) ** 2, LAST, 0.5 * 2.5 / 1e-5, 1e-2)],
          "half of the impulse of the full force, at the middle of the step"),
    Proof("CLOAD", plane("*CLOAD\nall, 3, 5.\n"), [("momentum_z", ALL, 0.0, 1e-12)], "the nodes stay in their plane"),
    Proof("DSLOAD", plane("*DSLOAD\nedge, P, 0.1\n"), refused="a pressure on edges of plane elements"),
    Proof("CONTACT INCLUSIONS", plane("*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n"), refused="contact of plane elements"),
    Proof("NGEN: NSET; NFILL: NSET; ELGEN: ELSET; ELSET: ELSET GENERATE; NSET: NSET GENERATE",
          abaqus("*NODE\n1, 0., 0., 0.\n3, 20., 0., 0.\n11, 0., 10., 0.\n13, 20., 10., 0.\n101, 0., 0., 20.\n103, 20., 0., 20.\n111, 0., 10., 20.\n113, 20., 10., 20.\n"
                 "*NGEN, NSET=low\n1, 3, 1\n11, 13, 1\n*NGEN, NSET=high\n101, 103, 1\n111, 113, 1\n*NFILL, NSET=every\nlow, high, 2, 50\n"
                 "*ELEMENT, TYPE=C3D8R\n1, 1, 2, 12, 11, 51, 52, 62, 61\n*ELGEN, ELSET=cube\n1, 2, 1, 1, 1, 1, 1, 2, 50, 10\n",
                 "*ELSET, ELSET=some, GENERATE\n1, 12, 1\n*NSET, NSET=all,\nGENERATE\n1, 113, 1\n", SOLID.replace("ELSET=cube", "ELSET=some"), MOVING),
          [("momentum_x", FIRST, 400.0 * CUBE_MASS, 1e-9)], "2 x 1 x 2 cubes"),
    Proof("NGEN: LINE", strip("1, 0., -10.\n5, 8., -10.\n11, 0., 0.\n15, 8., 0.\n9, 4., 4.\n", 4, "\n1, 5, 1", ", LINE=P\n11, 15, 1, 9"), of(100.0), "a parabola: heights of 0, 3, 4, 3, 0"),
    Proof("NGEN: LINE SYSTEM", strip("1, 8., 4.\n4, 3., 9.\n11, 13., 4.\n14, 3., 14.\n", 3, f", LINE=C, SYSTEM=C\n1, 4, 1, {ARC}\n11, 14, 1, {ARC}"), of(3 * 0.5 * 75.0 * 0.5),
          "three pieces of 30 degrees between radii of 5 and 10"),
    Proof("NGEN: LINE", strip("1, 5., 0.\n4, 0., 5.\n11, 10., 0.\n14, 0., 10.\n9, 0., 0.\n", 3, ", LINE=C\n1, 4, 1, 9, , , , 0., 0., -2.\n11, 14, 1, 9, , , , 0., 0., -2."), of(3 * 0.5 * 75.0),
          "three pieces of 90 degrees, the long way round, by the normal"),
    Proof("NGEN: LINE", moved("*NODE, NSET=all\n" + ROWS + "*NGEN, LINE=B\n1, 2, 1\n" + HEX), refused="LINE=B"),
    Proof("ELGEN: ELSET; ELEMENT: ELSET", abaqus("*NODE, NSET=all\n1, 0., 0.\n2, 10., 0.\n3, 20., 0.\n11, 0., 10.\n12, 10., 10.\n13, 20., 10.\n*ELEMENT, TYPE=S4R, ELSET=sheet\n1, 1, 2, 12, 11\n"
          "*ELGEN, ELSET=sheet\n1, 2, 1, 1\n*SHELL SECTION, ELSET=sheet, MATERIAL=steel\n2., 5\n" + STEEL + MOVING, end=1e-4, step="*DLOAD\nsheet, P, 0.05\n"),
          [("momentum_x", FIRST, 100.0 * DENSITY * 400.0, 1e-9), ("momentum_z", LAST, 10.0 * 1e-4, 1e-2)], "element 1 stands in its set twice, and counts once"),
    Proof("NCOPY: CHANGE_NUMBER OLD_SET NEW_SET SHIFT; ELCOPY: ELEMENT_SHIFT OLD_SET SHIFT_NODES NEW_SET",
          abaqus(f"*NODE, NSET=all\n{ROWS}{HEX}*NCOPY, CHANGE NUMBER=100, OLD SET=all, NEW SET=more, SHIFT\n20., 0., 0.\n0., 0., 0., 0., 0., 1., 90.\n"
                 "*ELCOPY, ELEMENT SHIFT=10, OLD SET=cube, SHIFT NODES=100, NEW SET=second\n", "*ELSET, ELSET=both\ncube, second\n", SOLID.replace("ELSET=cube", "ELSET=both"),
                 "*INITIAL CONDITIONS, TYPE=ROTATING VELOCITY\nmore, 5., 0., 0., 0.\n0., 0., 0., 0., 0., 1.\n"),
          [("momentum_x", FIRST, -125.0 * CUBE_MASS, 1e-6), ("momentum_y", FIRST, -25.0 * CUBE_MASS, 1e-6)], "the copy's centre lies at (25, 5), turned to (-5, 25)"),
    Proof("NMAP: NSET TYPE",
          abaqus(f"*NODE, NSET=all\n{ROWS}*NMAP, NSET=all, TYPE=TRANSLATION\n1., 2., 3., 1., 2., 7.\n-5.\n*NMAP, NSET=all, TYPE=TRANSLATION\n0., 0., 0., 9., 0., 0.\n20.\n"
                 f"*NMAP, NSET=all, TYPE=ROTATION\n0., 0., 0., 0., 0., 2.\n20., 5., 4.\n90.\n*NMAP, NSET=all, TYPE=ROTATION\n1., 1., 1., 1., 2., 1.\n0., 0., 3.\n90.\n{HEX}", SOLID,
                 "*INITIAL CONDITIONS, TYPE=ROTATING VELOCITY\nall, 5., 0., 0., 0.\n0., 0., 0., 0., 0., 1.\n"),
          [("momentum_x", FIRST, -50.0 * CUBE_MASS, 1e-6), ("momentum_y", FIRST, -15.0 * CUBE_MASS, 1e-6)],
          "the centre goes from (5, 5, 5) to (5, 5, 0), (25, 5, 0), (20, 10, 0) and (-3, 10, -17)"),
    Proof("NMAP", moved(f"*NODE, NSET=all\n{ROWS}*NMAP, NSET=all, TYPE=CYLINDRICAL\n0., 0., 0., 0., 0., 1.\n1., 0., 0.\n{HEX}"), refused="TYPE=CYLINDRICAL"),
    Proof("NSET: NSET ELSET UNSORTED", abaqus(abaqus_cube(), "*NSET, NSET=of, ELSET=cube\n*NSET, NSET=two, UNSORTED\nof,\n*INITIAL CONDITIONS, TYPE=VELOCITY\ntwo, 1, 100.\n"), ALL_MOVE, "nodes of a set"),
    Proof("PART; END PART; ASSEMBLY; END ASSEMBLY; INSTANCE; END INSTANCE; NSET: INSTANCE", instances("*NSET, NSET=s, INSTANCE=two\nown\n", "s"), ALL_MOVE, "one of two cubes"),
    Proof("INSTANCE; NSET: INSTANCE GENERATE", instances("*NSET, NSET=s, INSTANCE=two, GENERATE\n1, 8, 1\n", "s"), ALL_MOVE, "one of two cubes"),
    Proof("NSET", instances("*NODE\n1, 99., 0., 0.\n*NSET, NSET=s\none.1, two.own\n*NSET, NSET=r\n1,\n", "two.own").replace("two.own, 1, 100.", "two.own, 1, 100.\nr, 1, 7."), ALL_MOVE,
          "a reference point of the assembly is not node 1 of an instance"),
    Proof("INSTANCE", instances("", "two.own").replace("*INITIAL CONDITIONS, TYPE=VELOCITY\ntwo.own, 1, 100.\n", "*INITIAL CONDITIONS, TYPE=ROTATING VELOCITY\ntwo.own, 5., 0., 0., 0.\n0., 0., 0., 0., 0., 1.\n"),
          [("momentum_x", FIRST, -25.0 * CUBE_MASS, 1e-6), ("momentum_y", FIRST, 125.0 * CUBE_MASS, 1e-6)], "its centre lies at (25, 5)"),
    Proof("ASSEMBLY", instances("*NSET, NSET=s, INSTANCE=two\nown\n", "a. s"), ALL_MOVE, "the name of the assembly in front, and a blank"),
    Proof("INSTANCE", instances("", "A.two .own"), ALL_MOVE, "the names of the assembly and of an instance in front"),
    Proof("ELSET: ELSET INSTANCE", instances("*ELSET, ELSET=e, INSTANCE=two\n1,\n*SURFACE, NAME=s\ne, S1\n", "one.own", "").replace("*OUTPUT", "*DSLOAD\ns, P, 0.1\n*OUTPUT"),
          [("momentum_z", 1e-5, 10.0 * 1e-5, 6e-2)], "10 N on the lower face of the second cube"),
    Proof("ELEMENT: TYPE", moved(f"*NODE, NSET=all\n{ROWS}*ELEMENT, TYPE=C3D8, ELSET=cube\n1, 1, 2, 3, 4, 5, 6, 7, 8\n"), ALL_MOVE, "a cube of eight points"),
    Proof("ELEMENT: TYPE", moved(f"*NODE, NSET=all\n{ROWS}*ELEMENT, TYPE=C3D20R, ELSET=cube\n1, 1, 2, 3, 4, 5, 6, 7, 8, 1, 2, 3, 4, 5, 6,\n 7, 8, 1, 2, 3, 4\n"), refused="C3D20R"),
    Proof("SHELL SECTION: ELSET MATERIAL", sheet("*SHELL SECTION, ELSET=sheet, MATERIAL=steel\n2.5, 5\n"), of(250.0), "100 mm2 of 2.5 mm"),
    Proof("SHELL SECTION: OFFSET", abaqus(QUAD.format("S4R"), "*SHELL SECTION, ELSET=sheet, MATERIAL=steel, OFFSET=SPOS\n2.5, 5\n" + STEEL, "*INITIAL CONDITIONS, TYPE=VELOCITY\nall, 1, 100.\n"), of(250.0),
          "the offset does not change the mass"),
    Proof("NODAL THICKNESS; SHELL SECTION: NODAL_THICKNESS", sheet("*SHELL SECTION, ELSET=sheet, MATERIAL=steel, NODAL THICKNESS\n,\n*NODAL THICKNESS\n1, 1.\n2, 1.\n3, 2.\n4, 2.\n"), of(150.0), "the mean of the corners"),
    Proof("DISTRIBUTION: NAME LOCATION TABLE; SHELL SECTION: SHELL_THICKNESS",
          sheet("*SHELL SECTION, ELSET=sheet, MATERIAL=steel, SHELL THICKNESS=d\n1., 5\n*DISTRIBUTION TABLE, NAME=t\nLENGTH,\n*DISTRIBUTION, NAME=d, LOCATION=ELEMENT, TABLE=t\n, 1.\n1, 3.\n"), of(300.0), "3 mm of element 1"),
    Proof("DISTRIBUTION: INPUT", sheet("*SHELL SECTION, ELSET=sheet, MATERIAL=steel, SHELL THICKNESS=d\n1., 5\n*DISTRIBUTION, NAME=d, LOCATION=ELEMENT, TABLE=t, INPUT=d.txt\n"), of(300.0), "3 mm of element 1",
          files={"d.txt": ", 1.\n1, 3.\n"}),
    Proof("MEMBRANE SECTION: ELSET MATERIAL", sheet("*MEMBRANE SECTION, ELSET=sheet, MATERIAL=steel\n0.5,\n", "M3D4R"), of(50.0), "100 mm2 of 0.5 mm"),
    Proof("SHELL SECTION: COMPOSITE", sheet("*SHELL SECTION, ELSET=sheet, COMPOSITE\n0.5, 3, steel, 0., a\n0.75, 3, steel, 90., b\n"), of(125.0), "two layers of one material"),
    Proof("SHELL SECTION: COMPOSITE SYMMETRIC", sheet("*SHELL SECTION, ELSET=sheet, COMPOSITE, SYMMETRIC\n0.5, 3, steel\n0.75, 3, steel\n"), of(250.0), "and the same again"),
    Proof("SHELL SECTION: COMPOSITE", sheet("*SHELL SECTION, ELSET=sheet, COMPOSITE\n"), refused="has no layers"),
    Proof("SHELL SECTION: POISSON", sheet("*SHELL SECTION, ELSET=sheet, MATERIAL=steel, POISSON=0.\n2.5, 5\n"), refused="POISSON=0."),
    Proof("SOLID SECTION: COMPOSITE", moved(f"*NODE, NSET=all\n{ROWS}{HEX}", "*SOLID SECTION, ELSET=cube, COMPOSITE\n1., 1, steel\n" + STEEL), ALL_MOVE, "a layer of one material"),
    Proof("SOLID SECTION: COMPOSITE SYMMETRIC", moved(f"*NODE, NSET=all\n{ROWS}{HEX}", "*SOLID SECTION, ELSET=cube, COMPOSITE, SYMMETRIC\n1., 1, steel\n1., 1, glue\n" + STEEL + STEEL.replace("NAME=steel", "NAME=glue")), refused="layers of several materials"),
    Proof("SHELL SECTION: CONTROLS; SECTION CONTROLS: NAME", sheet("*SHELL SECTION, ELSET=sheet, MATERIAL=steel, CONTROLS=c\n2., 5\n"), refused="there is no *SECTION CONTROLS 'C'"),
    Proof("SECTION CONTROLS: HOURGLASS; SOLID SECTION: CONTROLS",
          abaqus(f"*NODE, NSET=all\n{ROWS}{HEX}", SOLID.replace("ELSET=cube,", "CONTROLS=c, ELSET=cube,"), "*SECTION CONTROLS, NAME=c, HOURGLASS=VISCOUS\n",
                 "".join(f"*INITIAL CONDITIONS, TYPE=VELOCITY\n{n}, 1, {s}\n" for n, s in zip(range(1, 9), (9, -9, 9, -9, 9, -9, 9, -9)))),
          [(lambda h: max(h["internal"]) / h["kinetic"][0], ALL, 0.0, 1e-12)], "viscous control stores nothing: the motion is an hourglass mode"),
    Proof("SECTION CONTROLS: HOURGLASS", abaqus(f"*NODE, NSET=all\n{ROWS}{HEX.replace('C3D8R', 'C3D8')}", SOLID.replace("ELSET=cube,", "CONTROLS=c, ELSET=cube,"),
          "*SECTION CONTROLS, NAME=c, HOURGLASS=ENHANCED\n", MOVING), ALL_MOVE, "eight points have no hourglass modes: the control does nothing"),
    Proof("SECTION CONTROLS: ELEMENT_DELETION", moved(f"*NODE, NSET=all\n{ROWS}{HEX}", "*SECTION CONTROLS, NAME=c, ELEMENT DELETION=NO\n*SOLID SECTION, ELSET=cube, MATERIAL=steel, CONTROLS=c\n" + STEEL
          + "*PLASTIC\n300., 0.\n*SHEAR FAILURE\n0.1, 0.\n"), refused="failed elements that stay"),
    Proof("BEAM SECTION: ELSET MATERIAL SECTION", moved(BEAM.format("B31"), "*BEAM SECTION, ELSET=bar, MATERIAL=steel, SECTION=RECT\n2., 3.\n0., 1., 0.\n" + STEEL), of(60.0), "10 mm of 2 x 3 mm"),
    Proof("BEAM SECTION: SECTION", moved(BEAM.format("B31"), "*BEAM SECTION, ELSET=bar, MATERIAL=steel, SECTION=BOX\n4., 3., 0.5, 0.5, 0.5, 0.5\n0., 1., 0.\n" + STEEL), of(60.0), "12 - 3 x 2 mm2"),
    Proof("BEAM SECTION: SECTION", moved(BEAM.format("B31"), "*BEAM SECTION, ELSET=bar, MATERIAL=steel, SECTION=PIPE\n2., 0.5\n0., 1., 0.\n" + STEEL), of(10 * 3.141592653589793 * 1.75), "pi (4 - 2.25)"),
    Proof("BEAM SECTION: SECTION", moved(BEAM.format("B31"), "*BEAM SECTION, ELSET=bar, MATERIAL=steel, SECTION=I\n2., 4., 3., 3., 0.5, 0.5, 0.2\n0., 1., 0.\n" + STEEL), of(36.0), "2 x 3 x 0.5 + 3 x 0.2 mm2"),
    *(Proof("BEAM SECTION: SECTION", moved(BEAM.format("B31"), f"*BEAM SECTION, ELSET=bar, MATERIAL=steel, SECTION=I\n{sizes}\n0., 1., 0.\n" + STEEL), refused="whose flanges differ")
      for sizes in ("2., 4., 3., 2., 0.5, 0.5, 0.2", "2., 4., 3., 3., 0.5, 0.4, 0.2", "1., 4., 3., 3., 0.5, 0.5, 0.2")),
    Proof("BEAM SECTION: SECTION", moved(BEAM.format("B31"), "*BEAM SECTION, ELSET=bar, MATERIAL=steel, SECTION=L\n2., 2., 0.5, 0.5\n0., 1., 0.\n" + STEEL), refused="a section of type L"),
    *[Proof("BEAM GENERAL SECTION: ELSET SECTION DENSITY", moved(BEAM.format("B31"), f"*BEAM GENERAL SECTION, ELSET=bar{shape}, DENSITY={DENSITY!r}\n{sizes}\n0., 1., 0.\n{MODULI}"),
            of(volume), "area times 10 mm")
      for shape, sizes, volume in (("", "6., 2., 0., 4.5, 5.", 60.0), (", SECTION=GENERAL", "6., 2., 0., 4.5, 5.", 60.0), (", SECTION=RECT", "2., 3.", 60.0))],
    *[Proof("BEAM GENERAL SECTION; BEAM ADDED INERTIA", twisted(f"*BEAM GENERAL SECTION, ELSET=bar, DENSITY={DENSITY!r}\n6., 2., 0., 4.5, {torsion}\n0., 1., 0.\n{moduli}{added}"),
            [("kinetic", FIRST, 0.5 * (DENSITY * 65.0 + turning) * 7.0**2, 1e-6)], "half of (rho (I11 + I22) + I) 10 mm w^2")
      for torsion, moduli, added, turning in ((5.0, MODULI, "", 0.0), (5.0, "2e5, 1e3\n", "", 0.0), (5.0, MODULI, "*BEAM ADDED INERTIA\n0., 0., 0., 0., 2e-9, 3e-9, 0.\n", 5e-8),
                                              (5.0, MODULI, "*BEAM ADDED INERTIA\n1e-8, 0., 0., 0., 2e-9, 3e-9, 0.\n", 5e-8))],
    Proof("BEAM ADDED INERTIA", moved(BEAM.format("B31"), f"*BEAM GENERAL SECTION, ELSET=bar, DENSITY={DENSITY!r}\n6., 2., 0., 4.5, 5.\n0., 1., 0.\n{MODULI}*BEAM ADDED INERTIA\n1e-8, 0., 0., 0., 2e-9, 3e-9, 0.\n"),
          [("momentum_x", FIRST, 100.0 * (DENSITY * 60.0 + 1e-7), 1e-9)], "mass by length times 10 mm"),
    Proof("BEAM ADDED INERTIA", moved(BEAM.format("B31"), f"*BEAM GENERAL SECTION, ELSET=bar, DENSITY={DENSITY!r}\n6., 2., 0., 4.5, 5.\n0., 1., 0.\n{MODULI}*BEAM ADDED INERTIA\n1e-8, 1.\n"), refused="off the axis"),
    Proof("BEAM GENERAL SECTION", moved(BEAM.format("B31"), f"*BEAM GENERAL SECTION, ELSET=bar, DENSITY={DENSITY!r}\n6., 2., 1., 4.5, 5.\n0., 1., 0.\n{MODULI}"), refused="principal"),
    Proof("BEAM GENERAL SECTION", moved(BEAM.format("B31"), f"*BEAM GENERAL SECTION, ELSET=bar\n6., 2., 0., 4.5, 5.\n0., 1., 0.\n{MODULI}"), refused="no positive DENSITY"),
    Proof("SOLID SECTION", moved(BEAM.format("T3D2"), "*SOLID SECTION, ELSET=bar, MATERIAL=steel\n7.,\n" + STEEL), of(70.0), "a truss of 7 mm2"),
    Proof("FIXED MASS SCALING: FACTOR ELSET", abaqus(abaqus_cube(), MOVING, "*ELSET, ELSET=e\ncube\n", step="*FIXED MASS SCALING, ELSET=e, FACTOR=4.\n"), [("momentum_x", FIRST, 400.0 * CUBE_MASS, 1e-9)], "four times the mass"),
    Proof("FIXED MASS SCALING: DT ELSET TYPE", abaqus(abaqus_cube(), MOVING, end=1e-4, step="*FIXED MASS SCALING, ELSET=cube, DT=4e-6, TYPE=BELOW MIN\n"),
          [(lambda h: h["dt"][1], ALL, 0.9 * 4e-6, 6e-2)], "0.9 of the time asked for, in a whole number of steps"),
    Proof("FIXED MASS SCALING: FACTOR", twice("FACTOR=4.", "FACTOR=4."), [("momentum_x", ALL, 400.0 * CUBE_MASS, 1e-9)], "the second step asks for the same: it goes on"),
    Proof("FIXED MASS SCALING: FACTOR", twice("FACTOR=4.", "FACTOR=5."), refused="mass scaling that begins in a later step"),
    Proof("FIXED MASS SCALING: TYPE", abaqus(abaqus_cube(), step="*FIXED MASS SCALING, DT=4e-6, TYPE=SET EQUAL DT\n"), refused="SET EQUAL DT"),
    Proof("VARIABLE MASS SCALING: DT ELSET TYPE FREQUENCY", abaqus(abaqus_cube(), MOVING, end=1e-4, step="*VARIABLE MASS SCALING, ELSET=cube, DT=4e-6, TYPE=BELOW MIN, FREQUENCY=5\n"),
          [(lambda h: h["dt"][1], ALL, 0.9 * 4e-6, 6e-2)], "0.9 of the time asked for, in a whole number of steps"),
]  # fmt: skip

OF_TEMPERATURES = "how temperatures of the section are given, each of which has a card of its own"
NUMERICS = "numerics of elements: percuss has its own"
NOT_PHYSICS = {
    "HEADING": "a title", "NSET.INTERNAL": "hides it in a user interface", "ELSET.INTERNAL": "hides it in a user interface", "ELSET.UNSORTED": "an order",
    "SURFACE.INTERNAL": "hides it in a user interface", 
    "BEAM GENERAL SECTION.POISSON": "how the section shrinks under tension: that of percuss keeps its area", "MEMBRANE SECTION.CONTROLS": "hourglass control of shells is that of percuss", "BEAM SECTION.CONTROLS": "beams have no hourglass modes",
    "SOLID SECTION.STACK DIRECTION": "of layers of solids, which are one material", "SHELL SECTION.TEMPERATURE": OF_TEMPERATURES, "BEAM SECTION.TEMPERATURE": OF_TEMPERATURES,
    "SHELL SECTION.SECTION INTEGRATION": "the report says that percuss has Gauss points",
    "SECTION CONTROLS.DISTORTION CONTROL": NUMERICS, "SECTION CONTROLS.LENGTH RATIO": NUMERICS, "SECTION CONTROLS.KINEMATIC SPLIT": NUMERICS,
    "SECTION CONTROLS.SECOND ORDER ACCURACY": NUMERICS, "VARIABLE MASS SCALING.NUMBER INTERVAL": "how often mass is looked at",
}  # fmt: skip
