"""Contacts and ties, with the friction of parts and controls."""

import math

from . import ALL, FIRST, LARGEST, LAST, MAX, MIN, Proof
from .pieces import CUBE_MASS, cube, curve, deck, elastic, hexahedron, node_set, nodes, part, rigid, shell, shell_section, solid_section, square, two_cubes, velocity

OUTPUTS = "*DATABASE_RCFORC\n2e-7\n*DATABASE_MATSUM\n2e-7\n"
MOVES = "*INITIAL_VELOCITY_GENERATION\n1,2,0,2000.0,0,-1000.0\n0\n"


def slide(contact, *more, parts=("*PART", "")):
    """A cube that falls on a held rigid floor and slides. parts: the keyword of both parts and lines behind them."""
    word, line = parts
    floor = hexahedron(2, 11, (-25.0, -25.0, -5.0), (60.0, 60.0, 4.99), 2) + f"{word}\nfloor\n2,1,2\n{line}" + rigid(2, 1, 7, 7)
    return deck(hexahedron() + f"{word}\ncube\n1,1,1\n{line}" + solid_section() + elastic(), floor, MOVES, contact, OUTPUTS, *more, end=2e-5)


def friction(history):
    """Ratio of the changes of momentum along and across the floor."""
    change = {axis: history[f"momentum_{axis}"][-1] - history[f"momentum_{axis}"][0] for axis in "xz"}
    return change["x"] / change["z"] if change["z"] > 0.5 * CUBE_MASS * 1000.0 else 9.0


def untouched(until):
    """The largest change of the momentum toward the floor before a time."""
    return lambda h: max(abs(p - h["momentum_z"][0]) for t, p in zip(h["time"], h["momentum_z"]) if t < until)


def impulse(history):
    """Of the first force of the history, over the change of momentum that it makes."""
    column = history[next(name for name in history if name.startswith("fz:"))]
    steps = [after - before for before, after in zip(history["time"], history["time"][1:])]
    total = sum(force * step for force, step in zip(column[1:], steps))
    return total / (history["momentum_z"][-1] - history["momentum_z"][0])


def tied(contact, *more, gap=0.0, poisson=0.0):
    """A cube above a held one begins to move away: if it is tied, its upper half swings."""
    text = two_cubes(gap).replace(elastic(), elastic(poisson=poisson))
    moves = "*INITIAL_VELOCITY_GENERATION\n2,2,0,0,0,100.0\n0\n*CONTROL_BULK_VISCOSITY\n0.0,0.0\n*CONTROL_TIMESTEP\n0,0.1\n"
    return deck(text, node_set(1, *range(1, 9)), "*BOUNDARY_SPC_SET\n1,0,1,1,1\n", moves, contact, *more, end=2e-5, rows=200)


def velocity_of_two(x):
    return f"*INITIAL_VELOCITY_GENERATION\n2,2,0,{x!r},0,0\n0\n"


PULL = "*LOAD_RIGID_BODY\n2,{dof},7,{of}\n*DEFINE_CURVE\n7\n0,1.0\n1.0,1.0\n"


def coupled(contact, *more):
    """A rigid cube on another, both free."""
    return deck(two_cubes(0.0).replace(elastic(), rigid()), "*CONTACT_TIED_SURFACE_TO_SURFACE\n", contact, *more, end=1e-5)


def fallen(options):
    """A rigid cube falls 0.01 mm on a held one, in 1e-5 s, and is pulled off it from 2e-5 s on, with 400 N at 6e-5 s."""
    pull = "*LOAD_RIGID_BODY\n2,3,7,400.0\n*DEFINE_CURVE\n7\n0,0\n2e-5,0\n6e-5,1.0\n"
    floor = hexahedron(1, 1, (-5.0, -5.0, 0.0), (20.0, 20.0, 10.0)) + part() + solid_section() + rigid(1, 1, 7, 7)
    cube_above = hexahedron(2, 11, (0.0, 0.0, 10.01), of=2) + part(2, 1, 2) + rigid(2) + "*INITIAL_VELOCITY_GENERATION\n2,2,0,0,0,-1000.0\n0\n"
    contact = f"*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK\n2,1,3,3\n\n0,0,-1e-3,-1e-3\n{options}\n"
    return deck(floor, cube_above, contact, pull, end=6e-5, rows=600)


GLUE_AREA, GLUE_N, GLUE_S, CN, CT2CN = 100.0, 0.3, 0.9, 2e4, 0.5


def glued(options, vx, vz, margin=5.0):
    """A rigid cube is moved off a held one that it is glued to, 0.05 mm at most. margin: how far that reaches beyond it."""
    floor = hexahedron(1, 1, (-margin, -margin, 0.0), (10.0 + 2 * margin, 10.0 + 2 * margin, 10.0)) + part() + solid_section() + rigid(1, 1, 7, 7)
    moves = "".join(f"*BOUNDARY_PRESCRIBED_MOTION_RIGID\n2,{dof},0,{curve},1.0\n*DEFINE_CURVE\n{curve}\n0,{v!r}\n1.0,{v!r}\n"
                    for dof, curve, v in ((1, 7, vx), (3, 8, vz)))  # fmt: skip
    contact = f"*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK\n2,1,3,3\n\n\n{options}\n"
    return deck(floor, hexahedron(2, 11, (0.0, 0.0, 10.0), of=2) + part(2, 1, 2) + rigid(2, 1, 0, 7), moves, contact, "*CONTROL_TIMESTEP\n0,0.9,0,0,0,9\n*DEFINE_CURVE\n9\n0,2e-8\n1.0,2e-8\n", end=1e-5, rows=200)


def glue_energy(vx, vz, bk=0.0, power=0.0):
    """Of the glue of glued(), by Benzeggagh and Kenane or by the power law."""
    normal, shear = CN * vz**2, CT2CN * CN * vx**2
    share = shear / (normal + shear)
    if bk:
        return GLUE_AREA * (GLUE_N + (GLUE_S - GLUE_N) * share**bk)
    return GLUE_AREA * ((1 - share) ** power / GLUE_N**power + (share / GLUE_S) ** power) ** (-1 / power)


def release_time(history):
    """When the last tie lets go; 0: none does."""
    return next((time for time, count in zip(history["time"], history["failed_ties"]) if count > 3), 0.0)


def sheets(gap, scale=""):
    """A sheet of 1 mm above a held one begins to move away; its nodes are tied to the other."""
    lower = square() + part() + shell_section() + elastic() + node_set(1, 1, 2, 3, 4) + "*BOUNDARY_SPC_SET\n1,0,1,1,1,1,1,1\n"
    upper = square(2, 11, (1.0, 1.0, gap), 8.0, of=2) + part(2) + node_set(7, 11, 12, 13, 14) + "*INITIAL_VELOCITY_GENERATION\n2,2,0,0,0,1.0\n0\n"
    return deck(lower, upper, f"*CONTACT_TIED_NODES_TO_SURFACE\n7,1,4,3\n\n{scale}\n", end=1e-5)


# A weld of four beams stands on a held sheet, and is pushed along x at its end, which has a mass.
WELD_INERTIA = math.pi * 4.0**4 / 64
WELD_SAG = 10.0 * (20.0**3 / (3 * 2.1e5 * WELD_INERTIA) + 20.0 / (0.9 * 2.1e5 / 2.6 * math.pi * 4.0))
WELDED = deck(square(), part(), shell_section(), elastic(), node_set(1, 1, 2, 3, 4), "*BOUNDARY_SPC_SET\n1,0,1,1,1,1,1,1\n",
              nodes(*((11 + i, 5.0, 5.0, 5.0 * i) for i in range(5))), "*ELEMENT_BEAM\n" + "".join(f"{11 + i},2,{11 + i},{12 + i},0\n" for i in range(4)),
              part(2, 2, 2), "*SECTION_BEAM\n2,9,1.0,2,1\n4.0,4.0,0,0\n", "*MAT_SPOTWELD\n2,7.8e-9,2.1e5,0.3,1e5,0\n0\n", "*ELEMENT_MASS\n1,15,1e-4\n",
              "*LOAD_NODE_POINT\n15,1,7,10.0\n*DEFINE_CURVE\n7\n0,1.0\n1.0,1.0\n*DATABASE_HISTORY_NODE\n15\n", "{}", end=1.5e-3, rows=300)  # fmt: skip


GLUE = "CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK; CONTACT: OPTION NFLS SFLS PARAM ERATEN ERATES CT2CN CN"
BORN = [(friction, LAST, -0.3, 5e-2), (untouched(1.45e-5), LAST, 0.0, 1e-9 * 1000.0 * CUBE_MASS)]
PASSED = [("momentum_z", LAST, -1000.0 * CUBE_MASS, 1e-6)]
HALF = 100.0 * CUBE_MASS / 2
SETS = "*SET_PART_LIST\n1\n1\n*SET_PART_LIST\n2\n2\n"
LIST = node_set(1, 1, 2, 3, 4) + "*SET_SEGMENT\n5\n1,2,3,4\n"
REFUSED = {"BT DT": ("0.3,0,0,0,0,0,7,-9999\n\n", "births and deaths by a table"), "VC": ("0.3,0,0,9.0\n\n", "limit on the friction")}
PAIR = "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n1,2,3,3\n"

PAIRS = ("SURFACE_TO_SURFACE", "ONE_WAY_SURFACE_TO_SURFACE", "FORMING_SURFACE_TO_SURFACE", "FORMING_ONE_WAY_SURFACE_TO_SURFACE")
WITH_NODES = ("NODES_TO_SURFACE", "FORMING_NODES_TO_SURFACE")
FOURTH_CARD = ("ERODING_NODES_TO_SURFACE", "CONSTRAINT_NODES_TO_SURFACE")
SHEET = square(3, 21, (0.0, 0.0, 30.0), of=3) + part(3, 3) + shell_section(3, 0.5) + "*INITIAL_VELOCITY_GENERATION\n3,2,0,0,0,-1000.0\n0\n"

SKIN = 3e-9 * 100.0 * 0.5  # density, area, thickness


FLOOR_HELD = node_set(1, *range(1, 9)) + "*BOUNDARY_SPC_SET\n1,0,1,1,1\n"
FLYING_SKIN = node_set(6, 31, 32, 33, 34) + "*INITIAL_VELOCITY\n6\n100.0,0,0\n"
FALLING = node_set(6, 31, 32, 33, 34) + "*INITIAL_VELOCITY\n6\n0,0,-1000.0\n"


def skinned(contact):
    """The sliding cube with a skin below, which alone is in contact with the floor."""
    sheet = "*ELEMENT_SHELL\n3,3,1,2,3,4\n" + part(3, 3, 3) + shell_section(3, 0.5) + "*MAT_NULL\n3,3e-9\n"
    return slide(contact, sheet)


FAMILIES = [
    *[Proof(f"CONTACT_{word}", slide(f"*CONTACT_{word}\n1,2,3,3\n0.2\n\n"), [(friction, LAST, -0.2, 5e-2)], "a pair") for word in PAIRS],
    Proof("CONTACT_CONSTRAINT_SURFACE_TO_SURFACE", slide("*CONTACT_CONSTRAINT_SURFACE_TO_SURFACE\n1,2,3,3\n0.2\n\n\n"), [(friction, LAST, -0.2, 5e-2)], "a pair, with a fourth card"),
    *[Proof(f"CONTACT_{word}", slide(f"*CONTACT_{word}\n1,2,4,3\n0.2\n\n", LIST), [(friction, LAST, -0.2, 5e-2)], "nodes and a surface") for word in WITH_NODES],
    *[Proof(f"CONTACT_{word}", slide(f"*CONTACT_{word}\n1,2,4,3\n0.2\n\n\n", LIST), [(friction, LAST, -0.2, 5e-2)], "nodes and a surface, with a fourth card") for word in FOURTH_CARD],
    *[Proof(f"CONTACT_{word}", slide(f"*CONTACT_{word}\n0\n0.2\n\n"), [(friction, LAST, -0.2, 5e-2)], "everything") for word in ("SINGLE_SURFACE", "AIRBAG_SINGLE_SURFACE")],
    Proof("CONTACT_ERODING_SINGLE_SURFACE", slide("*CONTACT_ERODING_SINGLE_SURFACE\n0,0,5\n0.2\n\n\n"), [(friction, LAST, -0.2, 5e-2)], "everything, with a fourth card"),
    Proof("CONTACT: SST MST", slide("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n0\n0,0,0.3\n", SHEET), refused="thickness of contact other than"),
    Proof("CONTACT: SST MST", slide("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n0.2\n0,0,0.3\n"), [(friction, LAST, -0.2, 5e-2)], "without shells it does nothing"),
    Proof("PART_CONTACT: FD DC", slide(PAIR + "-1.0\n\n", parts=("*PART_CONTACT", "0.35,0.2,0.0\n")), [(friction, LAST, -0.35, 5e-2)], "FS of the parts, where DC is 0"),
    Proof("MAT_NULL: RO", skinned("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n3,2,3,3\n0.2\n\n"), [("momentum_x", FIRST, 2000.0 * (CUBE_MASS + SKIN), 1e-9), (friction, LAST, -0.2, 5e-2)],
          "shells of no strength below the cube: their mass counts, and they touch"),
    Proof("MAT_NULL", skinned("*SET_PART_LIST\n8\n2,3\n*CONTACT_AUTOMATIC_SINGLE_SURFACE\n8,0,2\n0.2\n\n"), [(friction, LAST, -0.2, 5e-2)], "likewise, as one of a set of parts"),
    Proof("MAT_NULL", skinned("*SET_SHELL_LIST\n8\n3\n*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n8,2,1,3\n0.2\n\n"), refused="a set of shells of *MAT_NULL on solids"),
    Proof("MAT_NULL: RO", deck(cube(), square(3, 31, (0.0, 0.0, 30.0), of=3) + part(3, 3, 3) + shell_section(3, 1.0) + "*MAT_NULL\n3,3e-9\n", FLYING_SKIN,
                               "*LOAD_SHELL_ELEMENT\n3,7,2.0\n", curve(7, (0, 1.0), (1, 1.0)), end=1e-4),
          [("momentum_x", LAST, 100.0 * 3e-9 * 100.0, 1e-9), ("momentum_z", LAST, -200.0 * 1e-4, 1e-2), ("internal", LARGEST, 0.0, 1e-12)],
          "shells on nothing are a skin: mass, the pressure on them, and no stress"),
    Proof("MAT_NULL: RO", deck(cube(), FLOOR_HELD, square(3, 31, (2.0, 2.0, 12.0), 6.0, of=3) + part(3, 3, 3) + shell_section(3, 0.5) + "*MAT_NULL\n3,3e-9\n", FALLING,
                               "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n3,1,3,3\n\n\n", "*DATABASE_HISTORY_NODE\n31,33\n", end=3e-3),
          [("momentum_z", FIRST, -1000.0 * 3e-9 * 36.0 * 0.5, 1e-9), ("node_31_z", LAST, 10.25, 1e-3), ("node_33_z", LAST, 10.25, 1e-3)], "a skin touches with half its thickness"),
    Proof("MAT_NULL", deck(shell(material="*MAT_NULL\n1,3e-9\n*MAT_ADD_EROSION\n1\n0,0,0,0.1\n")), refused="shells without strength that fail"),
    *(Proof(f"MAT_NULL: {name}", deck(shell(material=f"*MAT_NULL\n1,3e-9,0,0,{values}\n")), refused=name) for name, values in (("TEROD", "1.2"), ("CEROD", "0,0.5"))),
    Proof("PART_CONTACT: OPTT", slide(PAIR + "0.2\n\n", parts=("*PART_CONTACT", "0,0,0,0,0.7\n")), refused="a thickness of contact of 0.7"),
    Proof("PART_CONTACT: OPTT", slide("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n0.2\n", SHEET.replace("*PART\npart_3\n3,3,1\n", "*PART_CONTACT\nsheet\n3,3,1\n0,0,0,0,0.5\n")), [(friction, LAST, -0.2, 5e-2)], "that of its shells changes nothing"),
    Proof("CONTROL_CONTACT: TH_SF SHLTRW", slide("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n0\n\n*CONTROL_CONTACT\n0.1\n\n0,0,0,0,0,0.5\n"), refused="TH_SF"),
    Proof("CONTROL_CONTACT: SHLTRW", slide("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n0\n\n*CONTROL_CONTACT\n0.1\n\n\n\n\n0,0,0,0,0,0,0.5\n"), refused="SHLTRW"),
    Proof("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MORTAR_TIED", tied("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MORTAR_TIED\n2,1,3,3\n\n\n"), [("momentum_z", MIN, -HALF, 5e-2)], "a tie"),
    Proof("CONTACT_SPOTWELD", tied("*CONTACT_SPOTWELD\n7,1,4,3\n\n\n", node_set(7, 11, 12, 13, 14)), [("momentum_z", MIN, -HALF, 5e-2)], "a tie of nodes"),
    Proof("CONTACT_SPOTWELD; SECTION_BEAM: ELFORM TS1 TT1", WELDED.format("*CONTACT_SPOTWELD\n2,1,3,3\n\n\n"), [("node_15_x", MAX, 5.0 + 2 * WELD_SAG, 2e-2)],
          "a clamped beam of diameter 4, pushed at its end: twice F L^3 / 3 E I + F L / 0.9 G A, which a hinge at the sheet would not hold"),
    Proof("SECTION_BEAM: ITOFF", WELDED.format("").replace("4.0,4.0,0,0", "4.0,4.0,0,0,0,0,1"), refused="turn freely"),
    Proof("CONTACT_TIED_NODES_TO_SURFACE; CONTACT_TIED: SST", sheets(1.1, "0,0,1.0,1.0"), [("momentum_z", LAST, 0.0, 1e-12)], "within 0.6 of both thicknesses they are tied, to a sheet that is held"),
    Proof("CONTACT_TIED_NODES_TO_SURFACE; CONTACT_TIED: SST", sheets(1.8, "0,0,1.0,1.0"), [("momentum_z", LAST, 64.0 * 7.8e-9, 1e-9)], "beyond it they fly on", allow="CONTACT_TIED.empty"),
    Proof("CONTACT_TIED_NODES_TO_SURFACE; CONTACT_TIED: SST MST", sheets(1.1, "0,0,-0.8,-0.9"), [("momentum_z", LAST, 64.0 * 7.8e-9, 1e-9)], "of negative values 0.6 of their sum alone", allow="CONTACT_TIED.empty"),
    *[Proof(f"CONTACT_TIED_SHELL_EDGE_TO_{word}", tied(f"*CONTACT_TIED_SHELL_EDGE_TO_{word}\n7,1,4,3\n\n\n", node_set(7, 11, 12, 13, 14)), [("momentum_z", MIN, -HALF, 5e-2)],
            "a tie of nodes; those of solids have no rotations") for word in ("SURFACE", "SOLID")],
]  # fmt: skip

NOT_PHYSICS = {"CONTACT_INTERIOR": "elements.resist_folding, which acts without it too"}

PROOFS = FAMILIES + [
    Proof("CONTACT_AUTOMATIC_SINGLE_SURFACE; CONTACT: FS FD DC; CONTACT: SSID SSTYP",
          slide("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n0.3,0.1\n\n"), [(friction, LAST, -0.3, 5e-2)], "friction over the normal impulse; FS, where DC is 0"),
    Proof("CONTACT_AUTOMATIC_GENERAL_INTERIOR; CONTACT: FS", slide("*CONTACT_AUTOMATIC_GENERAL_INTERIOR\n0\n0.25\n\n"), [(friction, LAST, -0.25, 5e-2)], "as a single surface"),
    Proof("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE; CONTACT: SSID MSID SSTYP MSTYP FS FSF SFST SFMT",
          slide(PAIR + "0.4\n0,0,0,0,0,0,0.5\n"), [(friction, LAST, -0.2, 5e-2)], "0.5 of 0.4; factors on thickness do nothing to solids"),
    Proof("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE; CONTACT: SSTYP MSTYP", slide("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n1,2,2,2\n0.2\n\n", SETS), [(friction, LAST, -0.2, 5e-2)], "sets of parts"),
    Proof("CONTACT_AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE; CONTACT: SSTYP", slide("*CONTACT_AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE\n5,2,0,3\n0.2\n\n", LIST), [(friction, LAST, -0.2, 5e-2)], "a set of segments"),
    Proof("CONTACT_AUTOMATIC_NODES_TO_SURFACE; CONTACT: SSTYP FS", slide("*CONTACT_AUTOMATIC_NODES_TO_SURFACE\n1,2,4,3\n0.2\n\n", LIST), [(friction, LAST, -0.2, 5e-2)], "a set of nodes"),
    Proof("CONTACT_ERODING_SURFACE_TO_SURFACE; CONTACT: FS", slide("*CONTACT_ERODING_SURFACE_TO_SURFACE\n1,2,3,3\n0.2\n\n\n"), [(friction, LAST, -0.2, 5e-2)], "its fourth card is read"),
    Proof("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MORTAR; CONTACT: FS", slide("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_MORTAR\n1,2,3,3\n0.2\n\n"), [(friction, LAST, -0.2, 5e-2)], "as without the option"),
    Proof("CONTACT_AUTOMATIC_SINGLE_SURFACE; CONTACT: SSID SSTYP", slide("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n1,0,3\n0.3\n\n"),
          [("momentum_z", LAST, -1000.0 * CUBE_MASS, 1e-6)], "part 1 with itself alone: it falls through the floor"),
    Proof("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE; CONTACT: FS; PART_CONTACT: FS",
          slide(PAIR + "-1.0\n\n", parts=("*PART_CONTACT", "0.35\n")), [(friction, LAST, -0.35, 5e-2)], "FS of the parts"),
    Proof("CONTROL_CONTACT: SFRIC DFRIC EDC",
          slide("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n-1.0\n\n*CONTROL_CONTACT\n0.1\n\n0.15,0.1\n"), [(friction, LAST, -0.15, 5e-2)], "SFRIC of parts without *PART_CONTACT"),
    Proof("CONTROL_CONTACT: SFRIC; PART_CONTACT: FS",
          slide("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n-1.0\n\n*CONTROL_CONTACT\n0.1\n\n0.3\n", parts=("*PART_CONTACT", "0.1\n")), [(friction, LAST, -0.1, 5e-2)],
          "parts with a smaller FS keep it among each other"),
    Proof("CONTACT_FORCE_TRANSDUCER: SSID SSTYP", slide(PAIR + "\n\n*CONTACT_FORCE_TRANSDUCER\n1,0,3\n\n\n"), [(impulse, LAST, 1.0, 1e-6)], "the force makes the change of momentum"),
    Proof("CONTACT_FORCE_TRANSDUCER: MSID MSTYP", slide(PAIR + "\n\n*CONTACT_FORCE_TRANSDUCER\n1,2,3,3\n\n\n"), [(impulse, LAST, 1.0, 1e-6)], "the floor makes all of the force"),
    Proof("CONTACT_FORCE_TRANSDUCER: MSID MSTYP", slide(PAIR + "\n\n*CONTACT_FORCE_TRANSDUCER\n1,3,3,3\n\n\n", SHEET), [("fz:force", LARGEST, 0.0, 1e-12)], "a sheet that touches nothing"),
    Proof("CONTACT_FORCE_TRANSDUCER: SBOXID MBOXID", slide(PAIR + "\n\n*CONTACT_FORCE_TRANSDUCER\n1,0,3,0,7\n\n\n"), refused="a force in a box"),
    Proof("PART_CONTACT: SFT", slide(PAIR + "\n\n", parts=("*PART_CONTACT", "0.35,0,0,0,0,2.0\n")), refused="SFT"),
    Proof("CONTROL_CONTACT: SPOTDEL SPOTHIN",
          deck(square(), part(), square(2, 11, (0.0, 0.0, 0.8), of=2), part(2), shell_section(), elastic(), velocity(100.0), "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n0.2\n\n*CONTROL_CONTACT\n0.1\n\n\n0,0,0,0,0,1,0.8\n"),
          [("momentum_x", ALL, 100.0 * 2 * 7.8e-7, 1e-9), ("internal", MAX, 0.0, 1e-12)], "sheets of a weld, closer than their thickness, do not press each other apart"),
    Proof("DATABASE_RCFORC: DT", slide(PAIR + "\n\n"), [(impulse, LAST, 1.0, 1e-6)], "the force makes the change of momentum"),
    Proof("CONTACT: BT", slide(PAIR + "0.3,0,0,0,0,0,1.5e-5\n\n"), BORN, "the cube comes to the floor at 1e-5, and is stopped from 1.5e-5 on"),
    Proof("CONTACT: BT", slide(PAIR + "0.3,0,0,0,0,0,-1.5e-5\n\n"), BORN, "of a negative time the size counts"),
    Proof("CONTACT: BT", slide("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n0.3,0,0,0,0,0,1.5e-5\n\n"), BORN, "everything too"),
    Proof("CONTACT: DT", slide(PAIR + "0.3,0,0,0,0,0,0,5e-6\n\n"), PASSED, "it ends before the cube comes"),
    Proof("CONTACT: DT", slide(PAIR + "0.3,0,0,0,0,0,0,-5e-6\n\n"), PASSED, "of a negative time the size counts"),
    Proof("CONTACT: DT", slide(PAIR + "0.3,0,0,0,0,0,0,5e-6\n\n" + PAIR + "0.3,0,0,0,0,0,1.5e-5\n\n"), BORN, "two contacts of the same parts, one after the other"),
    *[Proof(f"CONTACT: {name}", slide(PAIR + lines), refused=words) for name, (lines, words) in REFUSED.items()],
    Proof("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE; CONTACT: SBOXID MBOXID", slide("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n1,2,3,3,7\n\n\n"), refused="contact in a box"),
    Proof("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_ORTHO_FRICTION", slide(PAIR.replace("FACE\n", "FACE_ORTHO_FRICTION\n") + "0.2\n\n0.1\n0.2\n0.1\n0.2\n"), refused="depends on the direction"),
    Proof("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_ORTHO_FRICTION; CONTACT: FS",
          slide("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_ORTHO_FRICTION\n1,2,3,3\n0.2\n\n0.1\n0.2\n0.1\n0.2\n"), [(friction, LAST, -0.2, 5e-2)], "FS in all directions", allow="CONTACT*"),
    Proof("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_LUBRICATION", slide("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_LUBRICATION\n1,2,3,3\n0.2\n\n\n"), refused="lubrication"),
    Proof("CONTACT_SLIDING_ONLY", slide("*CONTACT_SLIDING_ONLY\n1,2,3,3\n0.2\n\n"), refused="this kind of contact"),
    Proof("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE; CONTACT: REGION", slide(PAIR + "0.2\n\n\n\n\n\n0,0,0,0,1.0,0,0,3\n"), refused="REGION"),
    Proof("CONTROL_CONTACT: ENMASS", slide(PAIR + "\n\n").replace("*END", "*MAT_ADD_EROSION\n1\n0,0,0,1e-9\n*END"),
          [("vanished_mass", LAST, CUBE_MASS, 1e-6)], "a cube that breaks at once: its nodes go out of the calculation"),
    Proof("CONTROL_CONTACT: ENMASS", slide(PAIR + "\n\n*CONTROL_CONTACT\n0.1,0,1,0,1,0,1,2\n").replace("*END", "*MAT_ADD_EROSION\n1\n0,0,0,1e-9\n*END"),
          [("eroded_mass", LAST, CUBE_MASS, 1e-6), (lambda h: float("vanished_mass" in h), LAST, 0.0, 0.0)], "with ENMASS 2 they stay"),
    Proof("CONTACT_TIED_SURFACE_TO_SURFACE; CONTACT_TIED: SSID MSID SSTYP MSTYP", tied("*CONTACT_TIED_SURFACE_TO_SURFACE\n2,1,3,3\n\n\n"), [("momentum_z", MIN, -HALF, 5e-2)],
          "four tied nodes are at rest, the others swing"),
    Proof("CONTACT_TIED_NODES_TO_SURFACE_OFFSET; CONTACT_TIED: SSID SSTYP SST MST",
          tied("*CONTACT_TIED_NODES_TO_SURFACE_OFFSET\n7,1,4,3\n\n0,0,1.0,1.0\n", node_set(7, 11, 12, 13, 14), gap=1.0), [("momentum_z", MIN, -HALF, 5e-2)],
          "nodes within 0.6 (SST + MST)"),
    Proof("CONTACT_TIED_SURFACE_TO_SURFACE; CONTACT_TIED: BT", coupled("2,1,3,3\n0,0,0,0,0,0,4e-6\n\n", velocity_of_two(100.0)),
          [("body_vx:part_1", 3.9e-6, 0.0, 1e-12), ("body_vx:part_1", LAST, 20.0, 2e-3), ("body_vx:part_2", LAST, 80.0, 2e-3), ("body_wy:part_1", LAST, 6.0, 2e-3)],
          "rigid cubes, m and I = m 100 / 6, are one from BT on: v / 2, and the spin 5 m v / (2 I + 50 m), keep both momenta"),
    Proof("CONTACT_TIED_SURFACE_TO_SURFACE; CONTACT_TIED: DT", coupled("2,1,3,3\n0,0,0,0,0,0,0,4e-6\n\n", PULL.format(dof=1, of=3.0)),
          [("body_vx:part_1", LAST, 0.2 * 3.0 * 4e-6 / CUBE_MASS, 2e-2), ("body_vx:part_2", LAST, (0.8 * 4e-6 + 6e-6) * 3.0 / CUBE_MASS, 1e-2)],
          "3 N on the upper one, which shares 1/2 - 3/10 of them until DT"),
    Proof("CONTACT_TIED_SURFACE_TO_SURFACE_FAILURE", tied("*CONTACT_TIED_SURFACE_TO_SURFACE_FAILURE\n2,1,3,3\n\n\n1.0,1.0\n"), refused="ties that fail"),
    Proof("CONTACT_TIEBREAK_SURFACE_TO_SURFACE; CONTACT_TIED: NFLS SFLS", tied("*CONTACT_TIEBREAK_SURFACE_TO_SURFACE\n2,1,3,3\n\n\n1.0,1.0\n"), [("failed_ties", LAST, 4.0, 0.0)],
          "the stress of the start, rho c v of 4 MPa, breaks it"),
    Proof("CONTACT_TIEBREAK_SURFACE_TO_SURFACE; CONTACT_TIED: NFLS SFLS", tied("*CONTACT_TIEBREAK_SURFACE_TO_SURFACE\n2,1,3,3\n\n\n90.0,90.0\n"), [("momentum_z", MIN, -HALF, 5e-2)],
          "it holds"),
    Proof("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK; CONTACT: OPTION NFLS SFLS",
          tied("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK\n2,1,3,3\n\n\n2,90.0,90.0\n"), [("momentum_z", MIN, -HALF, 5e-2)], "it holds"),
    Proof("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK; CONTACT: OPTION", tied("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK\n2,1,3,3\n\n\n7,90.0,90.0\n"), refused="ties that fail by the rule of OPTION 7"),
    Proof(GLUE, glued(f"9,30.0,50.0,-1.7,{GLUE_N},{GLUE_S},{CT2CN},{CN}", 4000.0, 3000.0), [("glue_work", LAST, glue_energy(4.0, 3.0, bk=1.7), 2e-3)],
          "two rigid cubes are drawn apart: the energy of the mix by Benzeggagh and Kenane, times 100 mm^2"),
    Proof(GLUE, glued(f"11,30.0,50.0,2.0,{GLUE_N},{GLUE_S},{CT2CN},{CN}", 4000.0, 3000.0), [("glue_work", LAST, glue_energy(4.0, 3.0, power=2.0), 2e-3)],
          "likewise by the power law"),
    Proof(GLUE, glued(f"9,30.0,50.0,1.0,{GLUE_N},{GLUE_S},0,{CN}", 0.0, 5000.0), [("glue_work", LAST, GLUE_AREA * GLUE_N, 2e-3)], "opening alone"),
    *(Proof(GLUE, glued("9,30.0,50.0,1.0,0.3,0.9,0.5,2e4", vx, vz, margin=0.0), [("glue_work", LAST, GLUE_AREA * energy, 2e-3)],
            "cubes that lie flush: the glue looks at the face below, not at sides that meet it at the rim")
      for vx, vz, energy in ((0.0, 5000.0, GLUE_N), (5000.0, 0.0, GLUE_S))),
    Proof("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK; CONTACT: CN", glued("9,30.0,50.0,1.0,0.3,0.9", 0.0, 5000.0), refused="OPTION 9 without CN"),
    Proof("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK; CONTACT: ERATEN", glued("9,30.0,50.0,1.0,-3,0.9,0,2e4", 0.0, 5000.0), refused="OPTION 9 with ERATEN that is not positive"),
    Proof("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK; CONTACT: OPTION", fallen("1,2.0,2.0"),
          [("momentum_z", LAST, 0.0, 1e-9)], "a cube that has fallen on a floor is held against 400 N: with OPTION 1 it never lets go"),
    Proof("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK; CONTACT: OPTION NFLS SFLS", fallen("3,2.0,90.0"),
          [(release_time, LAST, 4e-5, 5e-3), ("failed_ties", LAST, 4.0, 0.0), ("momentum_z", LAST, 300.0 * 2e-5, 1e-2)],
          "with OPTION 3 it comes off as the pull, 1e7 N/s from 2e-5 s on, is NFLS times 100 mm^2; then it moves freely"),
    Proof("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK; CONTACT: OPTION", fallen("2,2.0,90.0"),
          [("momentum_z", LAST, 0.5 * 400.0 * 4e-5, 1e-2)],
          "with OPTION 2 what comes later does not stick", allow="CONTACT_TIED.empty"),
    Proof("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK; CONTACT: OPTION", tied("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK\n2,1,3,3\n\n\n4,90.0,90.0\n"),
          refused="OPTION 4: nodes that are held along the normal and slide"),
    Proof("CONTACT_TIEBREAK_NODES_TO_SURFACE", tied("*CONTACT_TIEBREAK_NODES_TO_SURFACE\n7,1,4,3\n\n\n90.0,90.0\n", node_set(7, 11, 12, 13, 14)), refused="ties that fail"),
]  # fmt: skip
