"""Composites of Abaqus decks: orthotropic elasticity, orientations, layers, Hashin's criteria."""

import math

from . import FIRST, LAST, MAX, MIN, Proof
from .laminates import Constants, find_energy, find_load
from .pieces import abaqus, abaqus_cube

END = 1e-3
CARBON: Constants = (140e3, 10e3, 0.28, 5e3)
METAL: Constants = (7e4, 7e4, 0.25, 7e4 / 2.5)
E, K = (2e-4, -1e-4, 1.5e-4), 3e-4  # strains xx, yy, xy and the curvature xx
TOLERANCE = 2e-3
CORNERS = ((0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0))
PLY = "*MATERIAL, NAME=ply\n*DENSITY\n1.6e-9\n*ELASTIC, TYPE=LAMINA\n140e3, 10e3, 0.28, 5e3, 4500., 3500.\n"
CORE = "*MATERIAL, NAME=core\n*DENSITY\n2.7e-9\n*ELASTIC\n7e4, 0.25\n"
PLAIN = "*SHELL SECTION, ELSET=sheet, MATERIAL=ply{}\n1., 3\n"


def place(points, axes=(0, 1)):
    """Nodes in a plane, as (x, y, z)."""
    rows = [[0.0, 0.0, 0.0] for _ in points]
    for row, point in zip(rows, points):
        row[axes[0]], row[axes[1]] = point
    return rows


def strained(*keywords, e=E, k=K, points=CORNERS, axes=(0, 1), before="", prefix="", kind="S4R", rows=100, own=CORNERS):
    """A shell of 10 mm that gets strains and a curvature, all of its nodes moved. own: nodes of the part, where an instance is elsewhere."""
    nodes = "".join(f"{i}, {', '.join(map(repr, row))}\n" for i, row in enumerate(place(own, axes), 1))
    middle = sum(point[0] for point in points) / 4
    lines = "".join(f"{prefix}{i}, {axes[0] + 1}, , {(e[0] * x + e[2] * y) / END!r}\n{prefix}{i}, {axes[1] + 1}, , {e[1] * y / END!r}\n" for i, (x, y) in enumerate(points, 1))
    lines += "".join(f"{prefix}{i}, {d}, , {k * (x - middle) / END if d == 5 and axes == (0, 1) else 0.0!r}\n" for i, (x, y) in enumerate(points, 1) for d in (4, 5, 6))
    held = "".join(f"{prefix}{i}, {6 - sum(axes) - 2}\n" for i in (1, 2, 3, 4))
    mesh = f"*NODE, NSET=all\n{nodes}*ELEMENT, TYPE={kind}, ELSET=sheet\n1, 1, 2, 3, 4\n"
    step = f"*BOUNDARY\n{held}*BOUNDARY, TYPE=VELOCITY\n{lines}"
    output = f"*OUTPUT, HISTORY, TIME INTERVAL={END / rows!r}\n*ELEMENT OUTPUT, ELSET=sheet\nS\n"
    text = abaqus(before, mesh, *keywords, end=END, step=step)
    return text.replace(f"*OUTPUT, HISTORY, TIME INTERVAL={END / 100!r}\n", output)


def energy(*plies, e=E, k=K, middle=0.0):
    return [("internal", LAST, find_energy(plies, e, k, 100.0, middle), TOLERANCE)]


def one(degrees, k=K):
    return energy((1.0, degrees, CARBON), k=k)


def oriented(lines, option="", **more):
    return strained(PLAIN.format(", ORIENTATION=o"), f"*ORIENTATION, NAME=o{option}\n{lines}", PLY, **more)


def layered(lines, option="", *more, **keys):
    return strained(f"*SHELL SECTION, ELSET=sheet, COMPOSITE{option}\n{lines}", PLY, CORE, *more, **keys)


ORI = "*ORIENTATION, NAME=o\n0.8, 0.6, 0., -0.6, 0.8, 0.\n3, 0.\n"
AT = math.degrees(math.atan2(0.6, 0.8))
LAYERS = [
    Proof("ELASTIC: TYPE", strained(PLAIN.format(""), PLY), one(0.0), "without an orientation fibres lie along x"),
    Proof("ELASTIC: TYPE", strained(PLAIN.format(""), PLY, k=0.0, axes=(1, 2)), one(90.0, 0.0), "and along z where x is the normal"),
    Proof("ELASTIC: TYPE", strained(PLAIN.format(""), PLY.replace("LAMINA\n140e3, 10e3, 0.28, 5e3, 4500., 3500.", "ENGINEERING CONSTANTS\n140e3, 10e3, 9e3, 0.28, 0.2, 0.3, 5e3, 4500.,\n3500.")), one(0.0), "of three directions"),
    Proof("SHELL SECTION: COMPOSITE LAYUP", layered("0.5, 3, ply, 15., p1\n0.25, 3, core, , p2\n0.75, 3, ply, -40., p3\n", ", LAYUP=x"),
          energy((0.5, 15.0, CARBON), (0.25, 0.0, METAL), (0.75, -40.0, CARBON)), "laminate theory"),
    Proof("SHELL SECTION: COMPOSITE SYMMETRIC", layered("0.5, 3, ply, 15.\n0.25, 3, ply, -40.\n", ", SYMMETRIC"),
          energy((0.5, 15.0, CARBON), (0.25, -40.0, CARBON), (0.25, -40.0, CARBON), (0.5, 15.0, CARBON)), "and the same from above"),
    Proof("SHELL SECTION: COMPOSITE OFFSET", layered("0.5, 3, ply, 15.\n0.25, 3, ply, -40.\n", ", OFFSET=SPOS"), energy((0.5, 15.0, CARBON), (0.25, -40.0, CARBON), middle=-0.375), "the mesh is the top"),
    Proof("SHELL SECTION: COMPOSITE", layered("0.5, 3, ply, 0.\n0.25, 3, ply\n"), energy((0.75, 0.0, CARBON)), "layers without angles"),
    Proof("SHELL SECTION: COMPOSITE ORIENTATION", layered("0.5, 3, ply, 15.\n0.25, 3, core\n0.25, 3, ply, -40.\n", ", ORIENTATION=o", ORI),
          energy((0.5, 15.0 + AT, CARBON), (0.25, 0.0, METAL), (0.25, AT - 40.0, CARBON)), "angles from the orientation"),
    Proof("SHELL SECTION: COMPOSITE ORIENTATION", layered("0.5, 3, ply, q\n0.25, 3, ply, 20.\n", ", ORIENTATION=o", ORI, "*ORIENTATION, NAME=q\n0., 1., 0., -1., 0., 0.\n3, -15.\n"),
          energy((0.5, 75.0, CARBON), (0.25, AT + 20.0, CARBON)), "a layer with its own orientation"),
    Proof("SHELL SECTION: COMPOSITE", layered("0.5, 3, core\n0.25, 3, glue\n", "", CORE.replace("core", "glue").replace("7e4", "2e4")), energy((0.5, 0.0, METAL), (0.25, 0.0, (2e4, 2e4, 0.25, 8e3))), "two isotropic layers"),
    Proof("SHELL SECTION: COMPOSITE; DENSITY", layered("0.5, 3, ply, 15.\n0.25, 3, core\n", "", "*INITIAL CONDITIONS, TYPE=VELOCITY\nall, 1, 100.\n", e=(0.0, 0.0, 0.0), k=0.0).replace("*BOUNDARY", "*BOUNDARY, OP=MOD").split("*STEP")[0]
          + "*STEP\n*DYNAMIC, EXPLICIT\n, 1e-5\n*OUTPUT, HISTORY, TIME INTERVAL=1e-7\n*END STEP\n", [("momentum_x", FIRST, 100.0 * 100.0 * (0.5 * 1.6e-9 + 0.25 * 2.7e-9), 1e-9)], "the mass of the layers"),
    Proof("SHELL SECTION: COMPOSITE; FIXED MASS SCALING: FACTOR", layered("0.5, 3, ply, 15.\n0.25, 3, core\n", "", "*INITIAL CONDITIONS, TYPE=VELOCITY\nall, 1, 100.\n").split("*STEP")[0]
          + "*STEP\n*DYNAMIC, EXPLICIT\n, 1e-5\n*FIXED MASS SCALING, FACTOR=3.\n*OUTPUT, HISTORY, TIME INTERVAL=1e-7\n*END STEP\n", [("momentum_x", FIRST, 300.0 * 100.0 * (0.5 * 1.6e-9 + 0.25 * 2.7e-9), 1e-9)], "three times the mass of each layer"),
    Proof("SHELL SECTION: COMPOSITE", layered("0., 3, ply\n"), refused="the thickness of a layer"),
    Proof("SHELL SECTION", strained(PLAIN.format(""), PLY).replace("1, 1, 2, 3, 4\n", "1, 1, 2, 3, 9\n"), refused="there is no node 9, of element 1"),
    Proof("SHELL SECTION: COMPOSITE", layered("0.5, 3, ply, q\n0.25, 3, ply\n"), refused="orientation 'Q'"),
    Proof("SHELL SECTION: COMPOSITE; DAMPING", layered("0.5, 3, ply, 15.\n0.25, 3, ply\n").replace("*ELASTIC, TYPE=LAMINA", "*DAMPING, ALPHA=20.\n*ELASTIC, TYPE=LAMINA"), refused="damping of a layer"),
    Proof("SOLID SECTION: COMPOSITE", abaqus(abaqus_cube(False), "*SOLID SECTION, ELSET=cube, COMPOSITE\n1., 1, ply, 0.\n1., 1, ply, 90.\n", PLY.replace("LAMINA\n140e3, 10e3, 0.28, 5e3, 4500., 3500.", "ENGINEERING CONSTANTS\n140e3, 10e3, 9e3, 0.28, 0.2, 0.3, 5e3, 4500.,\n3500.")),
          refused="layers of several materials or angles"),
    Proof("MEMBRANE SECTION: ORIENTATION", strained("*MEMBRANE SECTION, ELSET=sheet, MATERIAL=ply, ORIENTATION=o\n1.\n", ORI, PLY, k=0.0, kind="M3D4R"), one(AT, 0.0), "axes of a membrane"),
]  # fmt: skip
ORIENTATIONS = [
    Proof("ORIENTATION: NAME; SHELL SECTION: ORIENTATION", oriented("0.8, 0.6, 0., -0.6, 0.8, 0.\n3, 25.\n"), one(AT + 25.0), "x' at atan 3/4, turned by 25 degrees about z'"),
    Proof("ORIENTATION: SYSTEM DEFINITION", oriented("5.8, 5.6, 9., 4.4, 5.8, 9., 5., 5., 9.\n3, 25.\n", ", SYSTEM=RECTANGULAR, DEFINITION=COORDINATES"), one(AT + 25.0), "from an origin c"),
    Proof("ORIENTATION", oriented("0., 0., 1., 0.8, 0.6, 0.\n1, 0.\n"), one(AT), "x' is the normal, y' the first axis"),
    Proof("ORIENTATION", oriented("-0.6, 0.8, 0., 0., 0., 1.\n2, 0.\n"), one(AT), "y' is the normal, z' the first axis"),
    Proof("ORIENTATION", oriented("-0.6, 0.8, 0., 0., 0., 1.\n2, 30.\n"), one(AT + 30.0), "turned about y'"),
    Proof("ORIENTATION", oriented("1., 0., 0., 0., 1., 0.\n"), refused="without its second line"),
    Proof("ORIENTATION: SYSTEM", oriented("0., 0., 0., 0., 0., 1.\n3, 0.\n", ", SYSTEM=CYLINDRICAL"), refused="SYSTEM=CYLINDRICAL"),
    Proof("ORIENTATION: DEFINITION", oriented("1, 2, 3\n3, 0.\n", ", DEFINITION=NODES"), refused="DEFINITION=NODES"),
    Proof("ORIENTATION; DISTRIBUTION", oriented("d\n3, 0.\n*DISTRIBUTION, NAME=d, LOCATION=ELEMENT, TABLE=t\n, 1., 0., 0., 0., 1., 0.\n1, 0., 1., 0., -1., 0., 0.\n"), refused="axes of a *DISTRIBUTION"),
    Proof("ORIENTATION", oriented("1., 0., 0., 2., 0., 0.\n3, 0.\n"), refused="lie on one line"),
    Proof("ORIENTATION; INSTANCE", strained("*SHELL SECTION, ELSET=sheet, MATERIAL=ply, ORIENTATION=o\n1., 3\n", ORI, "*END PART\n*ASSEMBLY, NAME=a\n*INSTANCE, NAME=one, PART=p\n0., 0., 0.\n0., 0., 0., 0., 0., 1., 90.\n*END INSTANCE\n*END ASSEMBLY\n", PLY,
          before="*PART, NAME=p\n", prefix="one.", points=tuple((-y, x) for x, y in CORNERS)), one(AT + 90.0), "the axes turn with the instance"),
]  # fmt: skip
CONSTANTS = (100e3, 20e3, 10e3, 0.25, 0.2, 0.3, 8e3, 6e3, 5e3)


def invert_compliance():
    e1, e2, e3, n12, n13, n23, *_ = CONSTANTS
    s = [[1 / e1, -n12 / e1, -n13 / e1], [-n12 / e1, 1 / e2, -n23 / e2], [-n13 / e1, -n23 / e2, 1 / e3]]
    det = sum(s[0][i] * (s[1][(i + 1) % 3] * s[2][(i + 2) % 3] - s[1][(i + 2) % 3] * s[2][(i + 1) % 3]) for i in range(3))
    return [[(s[(j + 1) % 3][(i + 1) % 3] * s[(j + 2) % 3][(i + 2) % 3] - s[(j + 1) % 3][(i + 2) % 3] * s[(j + 2) % 3][(i + 1) % 3]) / det for j in range(3)] for i in range(3)]


C = invert_compliance()
ENGINEERING = "*ELASTIC, TYPE=ENGINEERING CONSTANTS\n" + ", ".join(map(repr, CONSTANTS[:8])) + f"\n{CONSTANTS[8]!r}\n"
STIFFNESS = f"*ELASTIC, TYPE=ORTHOTROPIC\n{C[0][0]!r}, {C[0][1]!r}, {C[1][1]!r}, {C[0][2]!r}, {C[1][2]!r}, {C[2][2]!r}, {CONSTANTS[6]!r}, {CONSTANTS[7]!r}\n{CONSTANTS[8]!r}\n"


def driven(elastic, x=0.0, y=0.0, z=0.0, shear=(), orientation="", lines=""):
    """A cube whose nodes all move: strains along the axes of space; shear: the plane and the angle."""
    grid = {i: (bool(i in (2, 3, 6, 7)), bool(i in (3, 4, 7, 8)), bool(i > 4)) for i in range(1, 9)}
    speeds = {i: [10 * u * a / END for u, a in zip((x, y, z), at)] for i, at in grid.items()}
    for i in grid if shear else ():
        speeds[i][shear[0]] += 10 * shear[2] * grid[i][shear[1]] / END
    rows = "".join(f"{i}, {d + 1}, , {value!r}\n" for i, values in speeds.items() for d, value in enumerate(values))
    section = f"*SOLID SECTION, ELSET=cube, MATERIAL=ply{orientation}\n*MATERIAL, NAME=ply\n*DENSITY\n1.6e-9\n{elastic}{lines}"
    return abaqus(abaqus_cube(False), section, end=END, step=f"*BULK VISCOSITY\n0., 0.\n*BOUNDARY, TYPE=VELOCITY\n{rows}")


def work(*strains):
    return [("internal", LAST, 500.0 * sum(C[i][j] * strains[i] * strains[j] for i in range(3) for j in range(3)), TOLERANCE)]


SWAPPED = "*ORIENTATION, NAME=o\n0., 0., 1., 1., 0., 0.\n"  # 1 is z, 2 is x
SOLIDS = [
    *[row for elastic in (ENGINEERING, STIFFNESS) for row in (
        Proof("ELASTIC: TYPE", driven(elastic, 2e-4, -1e-4, 3e-4), work(2e-4, -1e-4, 3e-4), "half of e C e of 1000 mm3"),
        *[Proof("ELASTIC: TYPE", driven(elastic, shear=(i, j, 2e-4)), [("internal", LAST, 500.0 * CONSTANTS[k] * 4e-8, TOLERANCE)], "half of G g^2") for i, j, k in ((0, 1, 6), (0, 2, 7), (1, 2, 8))])],
    Proof("SOLID SECTION: ORIENTATION; ORIENTATION", driven(ENGINEERING, 2e-4, -1e-4, 3e-4, (), ", ORIENTATION=o", SWAPPED), work(3e-4, 2e-4, -1e-4), "z is axis 1, x axis 2"),
    Proof("ORIENTATION", driven(ENGINEERING, 2e-4, -1e-4, 3e-4, (), ", ORIENTATION=o", SWAPPED.replace("\n0.", "\n0.", 1) + "3, 90.\n"), work(2e-4, 3e-4, -1e-4), "turned by 90 degrees about axis 3: 1 is x, 2 is -z"),
    Proof("ELASTIC: TYPE", driven(PLY[PLY.index("*ELASTIC"):], 1e-4), refused="solids with the elasticity of a plane"),
    Proof("ELASTIC: TYPE", driven("*ELASTIC, TYPE=ORTHOTROPIC\n1., 2., 1., 0., 0., 1., 1., 1.\n1.\n", 1e-4), refused="no stable material"),
    Proof("ELASTIC: TYPE", driven("*ELASTIC, TYPE=ENGINEERING CONSTANTS\n1., 2., 1.\n", 1e-4), refused="needs 9 constants"),
    Proof("ELASTIC: TYPE", driven(ENGINEERING + "*PLASTIC\n300., 0.\n", 1e-4), refused="*PLASTIC with orthotropic elasticity"),
]  # fmt: skip
XT, XC, YT, YC, SL, ST = 200.0, 150.0, 20.0, 50.0, 30.0, 20.0
ENERGIES = (3.0, 2.0, 0.4, 2.5)
EA, EB, GAB = 140e3, 10e3, 5e3
UNCOUPLED = PLY.replace("0.28", "0.")


def hashin(alpha="", energies=ENERGIES):
    return f"*DAMAGE INITIATION, CRITERION=HASHIN{alpha}\n{XT}, {XC}, {YT}, {YC}, {SL}, {ST}\n*DAMAGE EVOLUTION, TYPE=ENERGY\n{', '.join(map(repr, energies))}\n"


def broken(damage, xx=0.0, yy=0.0, xy=0.0, section=PLAIN.format("")):
    return strained(section, UNCOUPLED + damage, e=(xx, yy, xy), k=0.0, rows=1000)


def peak(name, value, when=MAX):
    return (f"SHEET_2_stress_{name}", when, value, 1.5e-2)


def first(s1=0.0, s2=0.0, t=0.0, share=0.0):
    return find_load(s1, s2, t, XT, XC, YT, YC, SL, ST, share)


FAILURE = [
    *[Proof("DAMAGE INITIATION: CRITERION; DAMAGE EVOLUTION: TYPE", broken(hashin(), **strain), [peak(name, value, when), ("internal", MAX, 10.0 * crack, 1.5e-2)], "the strength, and the energy of a crack of 10 mm2")
      for strain, name, value, when, crack in (({"xx": 5e-3}, "xx", XT, MAX, ENERGIES[0]), ({"xx": -5e-3}, "xx", -XC, MIN, ENERGIES[1]), ({"yy": 8e-3}, "yy", YT, MAX, ENERGIES[2]), ({"yy": -2e-2}, "yy", -YC, MIN, ENERGIES[3]))],
    Proof("DAMAGE INITIATION: CRITERION", broken(hashin(), xy=1e-2), [peak("xy", SL)], "shear"),
    Proof("DAMAGE INITIATION: CRITERION", broken(hashin(), yy=-4e-3, xy=8e-3), [peak("xy", GAB * 8e-3 * first(s2=-EB * 4e-3, t=GAB * 8e-3))], "ST counts in compression across the fibres"),
    Proof("DAMAGE INITIATION: ALPHA", broken(hashin(", ALPHA=0.7", (0.0, 0.0, 0.0, 0.0)), xx=4e-3, xy=9e-3), [peak("xx", EA * 4e-3 * first(s1=EA * 4e-3, t=GAB * 9e-3, share=0.7))], "the shear counts for the fibres"),
    Proof("DAMAGE EVOLUTION: TYPE", broken(hashin(), xx=5e-3), [("eroded_elements", LAST, 1.0, 0.0)], "without fibres the element is removed"),
    Proof("DAMAGE INITIATION: CRITERION", broken(hashin().partition("*DAMAGE EVOLUTION")[0], xx=5e-3), [peak("xx", EA * math.log(1.005))], "without evolution nothing fails"),
    Proof("DAMAGE EVOLUTION: TYPE", broken(hashin().replace("TYPE=ENERGY\n3.0, 2.0, 0.4, 2.5", "TYPE=DISPLACEMENT\n0.1"), xx=1e-3), refused="other than by four energies"),
    Proof("DAMAGE INITIATION: CRITERION", broken(hashin().replace("200.0, ", "0., "), xx=1e-3), refused="a strength of Hashin's criteria is not positive"),
    Proof("DAMAGE INITIATION: CRITERION", driven(ENGINEERING + hashin(), 1e-4), refused="Hashin's criteria of solids"),
    Proof("DAMAGE INITIATION: CRITERION", strained("*SHELL SECTION, ELSET=sheet, MATERIAL=core\n1.\n", CORE + hashin()), refused="need an *ELASTIC with fibres"),
    Proof("SECTION CONTROLS: ELEMENT_DELETION", broken(hashin(), xx=1e-3, section="*SECTION CONTROLS, NAME=c, ELEMENT DELETION=NO\n" + PLAIN.format(", CONTROLS=c")), refused="failed elements that stay"),
    Proof("SECTION CONTROLS: MAX_DEGRADATION", broken(hashin(), xx=1e-3, section="*SECTION CONTROLS, NAME=c, MAX DEGRADATION=0.5\n" + PLAIN.format(", CONTROLS=c")), refused="keep a part of their stiffness"),
]  # fmt: skip
PROOFS = [*LAYERS, *ORIENTATIONS, *SOLIDS, *FAILURE]
NOT_PHYSICS = {"SHELL SECTION.LAYUP": "a name", "SOLID SECTION.LAYUP": "a name", "ORIENTATION.LOCAL DIRECTIONS": "of layers of solids, which are refused"}
