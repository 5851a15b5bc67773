"""Rigid bodies, couplings, equations, ties and contact."""

from . import ALL, FIRST, LAST, Proof
from .pieces import CORNERS, CUBE_MASS, DENSITY, POISSON, YOUNG, abaqus, abaqus_cube

T = 1e-4  # velocities are those of half a step before: 0.4 % of it
STEEL = f"*MATERIAL, NAME=steel\n*DENSITY\n{DENSITY!r}\n*ELASTIC\n{YOUNG!r}, {POISSON!r}\n"
REF = "*NODE\n9, 5., 5., 15.\n"
RIGID = f"{REF}*RIGID BODY, REF NODE=9, ELSET=cube\n"
CENTERED = RIGID.replace("REF NODE=9,", "REF NODE=9, POSITION=CENTER OF MASS,")
PLATE = ("*NODE\n1, 0., 0., 0.\n2, 10., 0., 0.\n3, 10., 10., 0.\n4, 0., 10., 0.\n9, 5., 5., 0.\n*ELEMENT, TYPE=R3D4, ELSET=plate\n1, 1, 2, 3, 4\n*RIGID BODY, REF NODE=9, ELSET=plate\n"
         "*ELEMENT, TYPE=MASS, ELSET=m\n2, 9\n*MASS, ELSET=m\n2e-6,\n")
ROTARY = "*ELEMENT, TYPE=ROTARYI, ELSET=r\n3, 9\n*ROTARY INERTIA, ELSET=r\n1e-5, 2e-5, 3e-5\n"
DRIVEN = "*BOUNDARY, TYPE=VELOCITY\n9, 1, 1, 40.\n9, 2, 6, 0.\n"
SKIN = "*SURFACE, NAME=skin, TYPE=NODE\nall,\n"


PULLED = "*NODE, NSET=ref\n9, {}\n*RIGID BODY, REF NODE=9, ELSET=cube\n"
PULL = "*BOUNDARY, TYPE=VELOCITY\n9, 3, 3, 100.\n*CLOAD\n8, 1, 2.\n*OUTPUT, HISTORY, TIME INTERVAL=1e-5\n*NODE OUTPUT, NSET=ref\nRF3\n"


def pushed(bodies: str, step: str = "*CLOAD\n9, 1, 2.\n", end: float = T, **more) -> str:
    return abaqus(abaqus_cube(), bodies, end=end, step=step, **more)


def two(gap: float, second: str = "all", more: str = "") -> str:
    """Two cubes, a and b above it, of steel; sets na and nb, surfaces sa (top of a) and sb (bottom of b)."""
    rows = ["".join(f"{first + i}, {10.0 * x}, {10.0 * y}, {10.0 * z + height}\n" for i, (x, y, z) in enumerate(CORNERS)) for first, height in ((1, 0.0), (11, 10.0 + gap))]
    return (f"*NODE, NSET=na\n{rows[0]}*NODE, NSET=nb\n{rows[1]}*ELEMENT, TYPE=C3D8R, ELSET=a\n1, 1, 2, 3, 4, 5, 6, 7, 8\n"
            f"*ELEMENT, TYPE=C3D8R, ELSET=b\n2, 11, 12, 13, 14, 15, 16, 17, 18\n*SOLID SECTION, ELSET=a, MATERIAL=steel\n*SOLID SECTION, ELSET=b, MATERIAL=steel\n{STEEL}"
            f"*SURFACE, NAME=sa\na, S2\n*SURFACE, NAME=sb\nb, S1\n*SURFACE INTERACTION, NAME=i\n*FRICTION\n0.3,\n*SURFACE INTERACTION, NAME=j\n*FRICTION\n0.1,\n{more}")  # fmt: skip


def sliding(contact: str, more: str = "", before: str = "") -> str:
    """b falls on a, which is held, and slides along x."""
    history = "*OUTPUT, HISTORY, TIME INTERVAL=1e-6\n*ENERGY OUTPUT, ELSET=b\nALLKE\n"
    return abaqus(two(0.01), more, before, "*INITIAL CONDITIONS, TYPE=VELOCITY\nnb, 1, 3000.\nnb, 3, -2000.\n*BOUNDARY\nna, 1, 3\n", end=2e-5, step=contact + history)


def in_two(first: str, second: str, at: float, before: str = "") -> str:
    """The same in two steps; b comes to a at 5e-6."""
    history = "*OUTPUT, HISTORY, TIME INTERVAL=1e-6\n*ENERGY OUTPUT, ELSET=b\nALLKE\n"
    start = "*INITIAL CONDITIONS, TYPE=VELOCITY\nnb, 1, 3000.\nnb, 3, -2000.\n*BOUNDARY\nna, 1, 3\n"
    next_step = f"*END STEP\n*STEP\n*DYNAMIC, EXPLICIT\n, {2e-5 - at!r}\n"
    return abaqus(two(0.01), before, start, end=at, step=first + history + next_step + second + history)


def ratio(history):
    """Change of momentum along the slide over that along the normal, of b."""
    return (history["momentum_x:B"][-1] - history["momentum_x:B"][0]) / (history["momentum_z:B"][-1] - history["momentum_z:B"][0])


def untouched(history):
    """The largest change of the momentum of b in the first 7.5e-6."""
    return max(abs(p - history["momentum_z:B"][0]) for t, p in zip(history["time"], history["momentum_z:B"]) if t < 7.5e-6)


def slides(friction: float) -> list:
    return [(ratio, LAST, -friction, 3e-2)]


QUADS = "*DAMAGE INITIATION, CRITERION=QUADS\n30., 50., 50.\n"
ENERGIES = "*DAMAGE EVOLUTION, TYPE=ENERGY, MIXED MODE BEHAVIOR={}, POWER={}\n0.3, 0.9, 0.9\n"
ORIGINAL = "*COHESIVE BEHAVIOR, ELIGIBILITY=ORIGINAL CONTACTS, TYPE=UNCOUPLED\n2e4, 2e4, 2e4\n"


def bonded(bonds: str, vx: float, vz: float) -> str:
    """b is drawn off a, to which it is bonded."""
    between = "*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n*CONTACT PROPERTY ASSIGNMENT\nsb, sa, i\n"
    moves = f"*BOUNDARY\nna, 1, 3\nnb, 2, 2\n*BOUNDARY, TYPE=VELOCITY\nnb, 1, 1, {vx!r}\nnb, 3, 3, {vz!r}\n"
    return abaqus(two(0.0).replace("*FRICTION\n0.3,\n", bonds), end=1e-3, step=between + moves)


def bond_energy(vx: float, vz: float, bk: float = 0.0, power: float = 0.0) -> float:
    """Times 100 mm^2, of equal stiffnesses."""
    share = vx**2 / (vx**2 + vz**2)
    return 100 * (0.3 + 0.6 * share**bk if bk else ((1 - share) ** power / 0.3**power + (share / 0.9) ** power) ** (-1 / power))


MISSED = [("momentum_z:B", LAST, -2000.0 * CUBE_MASS, 1e-9)]
GENERAL = "*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n*CONTACT PROPERTY ASSIGNMENT\n , , i\n"
PAIR = "*CONTACT PAIR, INTERACTION=i\nsb, sa\n"
TOGETHER = "*OUTPUT, HISTORY, TIME INTERVAL=1e-6\n*ENERGY OUTPUT, ELSET=b\nALLKE\n*CLOAD\nna, {}, 50.\n"


def falling_bar(contact: str) -> str:
    """A bar of radius 0.5 falls by 1 mm/ms on a held cube, 1 mm below its surface; its two nodes have no waves, and stop at once."""
    bar = "*NODE, NSET=ends\n21, 2., 5., 11.5\n22, 8., 5., 11.5\n*ELEMENT, TYPE=B31, ELSET=bar\n9, 21, 22\n*BEAM SECTION, ELSET=bar, MATERIAL=steel, SECTION=CIRC\n0.5,\n0., 1., 0.\n"
    start = "*INITIAL CONDITIONS, TYPE=VELOCITY\nends, 3, -1000.\n*BOUNDARY\nall, 1, 3\n*SURFACE INTERACTION, NAME=i\n*FRICTION\n0.,\n"
    return abaqus(abaqus_cube(), bar, start, contact, end=1.2e-3, step="*OUTPUT, HISTORY, TIME INTERVAL=1e-5\n*NODE OUTPUT, NSET=ends\nU,\n")


def together(*constraints: str, gap: float = 0.0, direction: int = 3) -> str:
    """Eight loads on a, toward b; b is without load."""
    return abaqus(two(gap), *constraints, end=2e-4, step=TOGETHER.format(direction))


def shares(tolerance: float, column: str = "momentum_z") -> list:
    """Half of the impulse is the momentum of b."""
    return [(column, LAST, 400.0 * 2e-4, 1e-2), (lambda h: h[f"{column}:B"][-1] / h[column][-1], LAST, 0.5, tolerance)]


def walled(profile: str, kind: str = "CYLINDER", step: str = "", held: str = "9, 1, 6\n", speed: float = -2000.0, where: str = "5., 5., -1.") -> str:
    """A cube falls on an analytical surface."""
    surface = f"*NODE\n9, {where}\n*SURFACE, TYPE={kind}, NAME=wall\n{profile}*RIGID BODY, REF NODE=9, ANALYTICAL SURFACE=wall\n"
    return abaqus(abaqus_cube(), surface, f"*INITIAL CONDITIONS, TYPE=VELOCITY\nall, 3, {speed!r}\n*BOUNDARY\n{held}", GENERAL.replace(", , i", ", , i"), "", end=2e-5, step=step).replace(
        "*CONTACT\n", "*SURFACE INTERACTION, NAME=i\n*FRICTION\n0.,\n*CONTACT\n"
    )


def swept(profile: str, step: str = "", speed: float = -2000.0) -> str:
    """A cube, and a surface swept along y: y of its part is z of space."""
    cube = abaqus_cube().split("*MATERIAL")
    held = "*BOUNDARY\nw.ref, 1, 6\n" if not step else "*BOUNDARY\nw.ref, 1, 2\nw.ref, 4, 6\n"
    assembly = ("*ASSEMBLY, NAME=a\n*INSTANCE, NAME=c, PART=p\n*END INSTANCE\n*INSTANCE, NAME=w, PART=q\n0., 0., 0.\n0., 0., 0., 1., 0., 0., 90.\n*NODE\n1, 5., -1., 0.\n*NSET, NSET=ref\n1,\n"
                f"*SURFACE, TYPE=CYLINDER, NAME=wall\n{profile}*RIGID BODY, REF NODE=ref, ANALYTICAL SURFACE=wall\n*END INSTANCE\n*END ASSEMBLY\n")  # fmt: skip
    return abaqus(f"*PART, NAME=p\n{cube[0]}*END PART\n*PART, NAME=q\n*END PART\n{assembly}*MATERIAL{cube[1]}", "*SURFACE INTERACTION, NAME=i\n*FRICTION\n0.,\n",
                  f"*INITIAL CONDITIONS, TYPE=VELOCITY\nc.all, 3, {speed!r}\n{held}", end=2e-5, step=GENERAL + step)  # fmt: skip


BOUNCED = [(lambda h: float(h["momentum_z"][-1] > 0.3 * 2000 * CUBE_MASS), LAST, 1.0, 1e-9)]

PROOFS = [
    Proof("BOUNDARY; RIGID BODY: REF_NODE", abaqus(abaqus_cube(), PULLED.format("5., 5., 35."), step=PULL),
          [("momentum_z", LAST, 100.0 * CUBE_MASS, 1e-9), ("momentum_x", LAST, 2.0 * T / 10, 6e-2), ("internal", ALL, 0.0, 1e-15)],
          "a body whose reference node above its centre moves along z at 100 mm/s is free along x"),
    Proof("BOUNDARY; COUPLING: REF_NODE SURFACE; KINEMATIC", abaqus(abaqus_cube(), "*NODE\n9, 5., 5., 35.\n*SURFACE, NAME=s\ncube, S2\n*COUPLING, CONSTRAINT NAME=c, REF NODE=9, SURFACE=s\n*KINEMATIC\n", step=PULL.partition("*CLOAD")[0]),
          [("momentum_z", FIRST, 50.0 * CUBE_MASS, 1e-6)], "the upper face, half of a cube, moves at once"),
    Proof("BOUNDARY", abaqus(abaqus_cube(), PULLED.format("6., 5., 35."), step=PULL), refused="a reference node away from the centre"),
    Proof("RIGID BODY: REF_NODE ELSET; CLOAD", pushed(RIGID), [("momentum_x", LAST, 2.0 * T, 1e-2), ("angular_y", LAST, 2.0 * 10.0 * T, 2e-2), ("internal", ALL, 0.0, 1e-15)],
          "2 N at 10 mm above the centre"),
    Proof("RIGID BODY: REF_NODE; CLOAD", pushed(RIGID, "*CLOAD\n9, 5, 7.\n"), [("angular_y", LAST, 7.0 * T, 1e-2), ("momentum_x", LAST, 0.0, 1e-15)], "a moment of 7 N mm"),
    Proof("RIGID BODY: POSITION; BOUNDARY", pushed(CENTERED, "*BOUNDARY, TYPE=VELOCITY\n9, 1, 1, 40.\n*CLOAD\nall, 2, 0.5\n"),
          [("momentum_x", LAST, 40.0 * CUBE_MASS, 1e-6), ("momentum_y", LAST, 4.0 * T, 1e-2)], "driven along x, free along y"),
    Proof("RIGID BODY: POSITION; CLOAD", pushed(CENTERED), [("momentum_x", LAST, 2.0 * T, 1e-2), ("body_wy:CUBE", LAST, 0.0, 1e-12)], "a load at a reference node that goes to the centre does not turn the body"),
    Proof("RIGID BODY: POSITION; INITIAL CONDITIONS: TYPE", pushed(CENTERED + "*INITIAL CONDITIONS, TYPE=VELOCITY\n9, 1, 100.\n9, 5, 3.\n", ""),
          [("momentum_x", LAST, 100.0 * CUBE_MASS, 1e-9), ("body_wy:CUBE", FIRST, 3.0, 1e-9)], "so are its velocity and spin those of the centre"),
    Proof("RIGID BODY: POSITION", pushed(CENTERED + "*ELEMENT, TYPE=MASS, ELSET=m\n2, 9\n*MASS, ELSET=m\n2e-6,\n"), refused="RIGID BODY.POSITION"),
    Proof("MASS: ELSET; RIGID BODY: ELSET", abaqus(PLATE, STEEL, end=T, step="*CLOAD\n9, 3, 4.\n"), [("body_vz:PLATE", LAST, 4.0 / 2e-6 * T, 1e-2), ("momentum_z", LAST, 4.0 * T, 1e-2)], "4 N on 2e-6 t"),
    Proof("ROTARY INERTIA: ELSET", abaqus(PLATE + ROTARY, STEEL, end=T, step="*CLOAD\n9, 4, 4.\n"), [("body_wx:PLATE", LAST, 4.0 / 1e-5 * 1e-4, 3e-2)], "4 N mm on 1e-5 t mm2"),
    Proof("ROTARY INERTIA: ELSET", abaqus(PLATE + ROTARY, STEEL, end=1e-4, step="*CLOAD\n9, 6, 4.\n"), [("body_wz:PLATE", LAST, 4.0 / 3e-5 * 1e-4, 3e-2)], "4 N mm on 3e-5 t mm2"),
    Proof("RIGID BODY: REF_NODE; BOUNDARY: TYPE", pushed(RIGID, "*BOUNDARY, TYPE=VELOCITY\n9, 1, 1, 40.\n9, 2, 6, 0.\n"), [("momentum_x", LAST, 40.0 * CUBE_MASS, 1e-6)], "the body moves at 40 mm/s"),
    Proof("RIGID BODY: REF_NODE", pushed(RIGID, "*BOUNDARY, TYPE=VELOCITY\n9, 1, 1, 40.\n"), refused="away from the centre"),
    Proof("RIGID BODY: TIE_NSET", pushed(f"{REF}*RIGID BODY, REF NODE=9, TIE NSET=all\n", DRIVEN), [("momentum_x", LAST, 40.0 * CUBE_MASS, 1e-6), ("internal", ALL, 0.0, 1e-12)], "all nodes are one body"),
    Proof("RIGID BODY: PIN_NSET", pushed(f"{REF}*RIGID BODY, REF NODE=9, PIN NSET=all\n", DRIVEN), [("momentum_x", LAST, 40.0 * CUBE_MASS, 1e-6), ("internal", ALL, 0.0, 1e-12)], "nodes without rotations"),
    Proof("RIGID BODY: ISOTHERMAL", pushed(RIGID.replace("ELSET=cube", "ELSET=cube, ISOTHERMAL=YES")), refused="ISOTHERMAL"),
    Proof("INITIAL CONDITIONS: TYPE; MASS: ELSET; ROTARY INERTIA: ELSET; RIGID BODY: ELSET POSITION", abaqus(PLATE + ROTARY, STEEL, "*INITIAL CONDITIONS, TYPE=VELOCITY\n9, 1, 30.\n9, 6, 5.\n"), [("momentum_x", FIRST, 30.0 * 2e-6, 1e-3), ("body_wz:PLATE", FIRST, 5.0, 1e-6), ("body_kinetic:PLATE", FIRST, 0.5 * (900 * 2e-6 + 25 * 3e-5), 1e-2)],
          "of the reference node: translation and spin"),
    Proof("COUPLING: REF_NODE SURFACE; KINEMATIC", pushed(f"{REF}{SKIN}*COUPLING, CONSTRAINT NAME=c, REF NODE=9, SURFACE=skin\n*KINEMATIC\n", DRIVEN),
          [("momentum_x", LAST, 40.0 * CUBE_MASS, 1e-6), ("internal", ALL, 0.0, 1e-12)], "all nodes are coupled"),
    Proof("KINEMATIC", pushed(f"{REF}{SKIN}*COUPLING, CONSTRAINT NAME=c, REF NODE=9, SURFACE=skin\n*KINEMATIC\n1, 3\n", DRIVEN), [("momentum_x", LAST, 40.0 * CUBE_MASS, 1e-6), ("internal", ALL, 0.0, 1e-12)],
          "nodes of solids have no other directions"),
    Proof("KINEMATIC", pushed(f"{REF}{SKIN}*COUPLING, CONSTRAINT NAME=c, REF NODE=9, SURFACE=skin\n*KINEMATIC\n1, 2\n"), refused="leaves directions free"),
    Proof("DISTRIBUTING", pushed(f"{REF}{SKIN}*COUPLING, CONSTRAINT NAME=c, REF NODE=9, SURFACE=skin\n*DISTRIBUTING\n"), refused="*DISTRIBUTING"),
    Proof("MPC", together("".join(f"*MPC\nBEAM, {n}, {n + 10}\n" for n in range(1, 9))), shares(4e-2), "pairs of nodes are one body, pushed along their line"),
    Proof("MPC", together("*MPC\n" + "".join(f"PIN, {n}, {n + 10}\n" for n in range(1, 9))), shares(4e-2), "pairs of nodes move equally"),
    Proof("MPC", together("*MPC\nLINK, 1, 11\n"), refused="MPC.LINK"),
    Proof("EQUATION", together("*EQUATION\n" + "".join(f"2\n{n}, 1, 1.\n{n + 10}, 1, -1.\n" for n in range(1, 9)), direction=1), shares(4e-2, "momentum_x"), "equal along x"),
    Proof("EQUATION", together("*EQUATION\n" + "".join(f"2\n{n}, 3, 1.\n{n + 10}, 1, -2.\n" for n in range(1, 9))),
          [("momentum_x:B", LAST, 400.0 * 2e-4 * 0.5 / 1.25, 1e-2), ("momentum_z", LAST, 400.0 * 2e-4 / 1.25, 1e-2)], "a lever: b moves along x by half of what a moves along z, m a + m a / 4 = f"),
    Proof("EQUATION", together("*NSET, NSET=pa, UNSORTED\n1, 2, 3, 4, 5, 6, 7, 8\n*NSET, NSET=pb, UNSORTED\n11, 12, 13, 14, 15, 16, 17, 18\n*EQUATION\n2\npa, 3, 1.\npb, 1, -2.\n"),
          [("momentum_x:B", LAST, 400.0 * 2e-4 * 0.5 / 1.25, 1e-2)], "the same of two sets"),
    Proof("EQUATION; BOUNDARY: AMPLITUDE", abaqus(two(0.0), "*NODE\n99, 0., 0., 90.\n*EQUATION\n" + "".join(f"3\n{n}, 3, 1., {n + 10}, 3, -1., 99, 3, -2.\n" for n in range(1, 9)), "*AMPLITUDE, NAME=ramp\n0., 0., 1., 1.\n", end=2e-4,
          step="*OUTPUT, HISTORY, TIME INTERVAL=1e-6\n*ENERGY OUTPUT, ELSET=b\nALLKE\n*BOUNDARY, AMPLITUDE=ramp\n99, 3, 3, 50.\n"),
          [(lambda h: h["momentum_z"][-1] - 2 * h["momentum_z:B"][-1], LAST, 100.0 * CUBE_MASS, 1e-6), ("momentum_z", LAST, 0.0, 1e-9)],
          "the bodies part at twice the 50 mm/s of a node without elements"),
    Proof("EQUATION", together("*EQUATION\n2\n1, 4, 1., 11, 1, -2.\n"), refused="an equation of rotations"),
    Proof("EQUATION", together("*NODE\n99, 0., 0., 90.\n*EQUATION\n3\n1, 1, 1., 11, 1, -1., 99, 1, 1.\n"), refused="a node without elements"),
    Proof("TIE: NAME; SURFACE: NAME TYPE", together("*TIE, NAME=t\nsb, sa\n"), shares(0.1), "both swing about half of the impulse each"),
    Proof("TIE: POSITION_TOLERANCE", together("*TIE, NAME=t, POSITION TOLERANCE=2.\nsb, sa\n", gap=1.0), shares(0.1), "a gap of 1 mm is within 2 mm"),
    Proof("TIE: POSITION_TOLERANCE", together("*TIE, NAME=t, POSITION TOLERANCE=0.5\nsb, sa\n", gap=1.0), refused="ties nothing"),
    Proof("CONTACT PAIR: INTERACTION; FRICTION; SURFACE INTERACTION: NAME", sliding(PAIR), slides(0.3), "Coulomb's friction of the pair"),
    Proof("CONTACT PAIR: INTERACTION", sliding(PAIR.replace("=i", "=j")), slides(0.1), "Coulomb's friction of the other interaction"),
    Proof("CONTACT PAIR: INTERACTION", sliding(PAIR.replace("=i", "=none")), refused="there is no *SURFACE INTERACTION"),
    Proof("CONTACT PAIR: INTERACTION", sliding("*CONTACT PAIR\nsb, sa\n"), refused="has no INTERACTION"),
    Proof("CONTACT PAIR: OP", in_two(PAIR, "*CONTACT PAIR, OP=DELETE\nsb, sa\n", 3e-6), MISSED, "it ends before b comes"),
    Proof("CONTACT PAIR: OP", in_two(PAIR, "*CONTACT PAIR, OP=DELETE\nsa, sb\n" + PAIR.replace("=i", "=j"), 3e-6), slides(0.1), "another pair of the same surfaces in its place"),
    Proof("CONTACT PAIR: OP", in_two(PAIR, "*CONTACT PAIR, OP=DELETE\nsa, none\n", 3e-6), refused="NONE"),
    Proof("CONTACT PAIR", in_two("", PAIR, 8e-6), [*slides(0.3), (untouched, LAST, 0.0, 1e-9 * 2000.0 * CUBE_MASS)], "it begins with the second step, where b is in a"),
    Proof("CONTACT PAIR: INTERACTION", in_two(PAIR, PAIR.replace("=i", "=j"), 3e-6), slides(0.1), "another interaction in a later step"),
    Proof("CONTACT; CONTACT INCLUSIONS: ALL_EXTERIOR; CONTACT PROPERTY ASSIGNMENT", sliding(GENERAL), slides(0.3), "Coulomb's friction of all"),
    Proof("CONTACT INCLUSIONS: ALL_EXTERIOR", falling_bar(GENERAL), [("momentum_z", LAST, 0.0, 1e-12), (lambda h: min(h[c][-1] for c in h if c.endswith("_z") and "21" in c), LAST, 10.5, 1e-5)],
          "beams are among all surfaces: the axis rests at its radius"),
    Proof("CONTACT INCLUSIONS: ALL_EXTERIOR", falling_bar(""), [("momentum_z", LAST, -1000.0 * DENSITY * 6.0 * 0.25 * 3.141592653589793, 1e-9)], "without contact it falls on"),
    Proof("CONTACT INCLUSIONS: ALL_EXTERIOR", in_two("", GENERAL, 8e-6), [*slides(0.3), (untouched, LAST, 0.0, 1e-9 * 2000.0 * CUBE_MASS)], "general contact begins with the second step"),
    Proof("CONTACT: OP", in_two(GENERAL, "*CONTACT, OP=NEW\n", 3e-6), MISSED, "general contact ends before b comes"),
    Proof("CONTACT: OP", in_two(GENERAL, "*CONTACT, OP=MOD\n", 3e-6), slides(0.3), "it goes on"),
    Proof("CONTACT: OP", in_two(GENERAL, GENERAL.replace("CONTACT\n", "CONTACT, OP=NEW\n").replace(", i", ", j"), 3e-6), slides(0.1), "another one in its place"),
    Proof("CONTACT: OP", in_two("*CONTACT\n*CONTACT INCLUSIONS\nsb, sa\n", "*CONTACT, OP=NEW\n", 3e-6), MISSED, "a pair of general contact ends"),
    Proof("CONTACT: OP", in_two(GENERAL + "sb, sa, j\n", "*CONTACT, OP=NEW\n", 3e-6), refused="frictions of pairs"),
    Proof("CONTACT PROPERTY ASSIGNMENT", in_two(GENERAL, "*CONTACT\n*CONTACT PROPERTY ASSIGNMENT\n , , j\n", 3e-6), slides(0.1), "another friction in a later step"),
    Proof("CONTACT PROPERTY ASSIGNMENT", in_two(GENERAL, "*CONTACT\n*CONTACT PROPERTY ASSIGNMENT\n , , j\n", 1.9e-5), slides(0.3), "one that comes too late"),
    Proof("CONTACT PROPERTY ASSIGNMENT", in_two("*CONTACT\n*CONTACT INCLUSIONS\nsb, sa\n*CONTACT PROPERTY ASSIGNMENT\n , , i\n", "*CONTACT\n*CONTACT PROPERTY ASSIGNMENT\n , , j\n", 3e-6),
          refused="CONTACT PROPERTY ASSIGNMENT.step"),
    Proof("CONTACT PROPERTY ASSIGNMENT", in_two(GENERAL, "*CONTACT\n*CONTACT PROPERTY ASSIGNMENT\nsb, sa, j\n", 3e-6), refused="friction of two surfaces"),
    Proof("CONTACT EXCLUSIONS", in_two(GENERAL, "*CONTACT\n*CONTACT EXCLUSIONS\nwa, wb\n", 3e-6, "*SURFACE, NAME=wa\na,\n*SURFACE, NAME=wb\nb,\n"), refused="an exclusion that begins"),
    Proof("CONTACT PROPERTY ASSIGNMENT", sliding(GENERAL + "sb, sa, j\n"), slides(0.1), "that of the two surfaces"),
    Proof("CONTACT INCLUSIONS", sliding("*CONTACT, OP=NEW\n*CONTACT INCLUSIONS\nsb, sa\n*CONTACT PROPERTY ASSIGNMENT\n , , i\n"), slides(0.3), "one pair, with the friction of all"),
    Proof("CONTACT EXCLUSIONS", sliding(GENERAL + "*CONTACT EXCLUSIONS\nwa, wb\n", "*SURFACE, NAME=wa\na,\n*SURFACE, NAME=wb\nb,\n"), MISSED, "both bodies pass through each other"),
    Proof("CONTACT INCLUSIONS", sliding("*CONTACT\n*CONTACT INCLUSIONS\nsb,\n"), MISSED, "a surface alone touches itself"),
    Proof("CONTACT EXCLUSIONS", sliding(GENERAL + "*CONTACT EXCLUSIONS\nsa, sb\n"), refused="not whole parts"),
    Proof("SURFACE PROPERTY ASSIGNMENT: PROPERTY", sliding(GENERAL + "*SURFACE PROPERTY ASSIGNMENT, PROPERTY=THICKNESS\n , ORIGINAL, 0.5\n"), refused="in contact"),
    Proof("SURFACE PROPERTY ASSIGNMENT: PROPERTY", sliding(GENERAL + "*SURFACE PROPERTY ASSIGNMENT, PROPERTY=THICKNESS\n , ORIGINAL, 1.\n"), slides(0.3), "the thickness as it is"),
    Proof("COHESIVE BEHAVIOR: ELIGIBILITY TYPE; DAMAGE INITIATION: CRITERION; DAMAGE EVOLUTION: TYPE MIXED_MODE_BEHAVIOR POWER",
          bonded(ORIGINAL + QUADS + ENERGIES.format("BK", 1.7), 40.0, 30.0), [("glue_work", LAST, bond_energy(4.0, 3.0, bk=1.7), 2e-3)],
          "two cubes are drawn apart: the energy of the mix by Benzeggagh and Kenane, times 100 mm^2"),
    Proof("COHESIVE BEHAVIOR; DAMAGE EVOLUTION: MIXED_MODE_BEHAVIOR POWER", bonded(ORIGINAL + QUADS + ENERGIES.format("POWER LAW", 2.0), 40.0, 30.0),
          [("glue_work", LAST, bond_energy(4.0, 3.0, power=2.0), 2e-3)], "likewise by the power law"),
    Proof("COHESIVE BEHAVIOR", bonded(ORIGINAL + QUADS + "*DAMAGE EVOLUTION, TYPE=ENERGY\n0.3,\n", 40.0, 30.0), [("glue_work", LAST, 30.0, 2e-3)], "one energy of all mixes"),
    Proof("COHESIVE BEHAVIOR: ELIGIBILITY", bonded(ORIGINAL.replace("ELIGIBILITY=ORIGINAL CONTACTS, ", "") + QUADS + ENERGIES.format("BK", 1.7), 0.0, 50.0), refused="come into contact later"),
    Proof("COHESIVE BEHAVIOR: REPEATED_CONTACTS", bonded(ORIGINAL.replace("TYPE=UNCOUPLED", "REPEATED CONTACTS") + QUADS + ENERGIES.format("BK", 1.7), 0.0, 50.0), refused="heal at every contact"),
    Proof("COHESIVE BEHAVIOR: TYPE", bonded(ORIGINAL.replace("UNCOUPLED", "COUPLED") + QUADS + ENERGIES.format("BK", 1.7), 0.0, 50.0), refused="TYPE=COUPLED"),
    Proof("COHESIVE BEHAVIOR", bonded("*COHESIVE BEHAVIOR, ELIGIBILITY=ORIGINAL CONTACTS\n" + QUADS + ENERGIES.format("BK", 1.7), 0.0, 50.0), refused="stiffness of the penalty method"),
    Proof("COHESIVE BEHAVIOR", bonded(ORIGINAL.replace("2e4, 2e4, 2e4", "2e4, 1e4, 1e4") + QUADS + ENERGIES.format("BK", 1.7), 0.0, 50.0), refused="stiffnesses in tension and shear differ"),
    Proof("FRICTION: TAUMAX", sliding(PAIR, before="*SURFACE INTERACTION, NAME=k\n*FRICTION, TAUMAX=3.\n0.1,\n"), refused="TAUMAX"),
    Proof("FRICTION: EXPONENTIAL_DECAY", sliding(PAIR, before="*SURFACE INTERACTION, NAME=k\n*FRICTION, EXPONENTIAL DECAY\n0.3, 0.1, 1.\n"), refused="EXPONENTIAL DECAY"),
    Proof("FRICTION", sliding(PAIR, before="*SURFACE INTERACTION, NAME=k\n*FRICTION\n0.3, 0.\n0.1, 5.\n"), refused="depends on speed"),
    Proof("SURFACE BEHAVIOR: PRESSURE-OVERCLOSURE", sliding(PAIR, before="*SURFACE INTERACTION, NAME=k\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n1e4,\n"), refused="PRESSURE-OVERCLOSURE"),
    Proof("SURFACE BEHAVIOR: PRESSURE-OVERCLOSURE", sliding(PAIR, before="*SURFACE INTERACTION, NAME=k\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=HARD, PENALTY\n"), slides(0.3), "hard contact"),
    Proof("CONTACT CLEARANCE", sliding(PAIR, before="*CONTACT CLEARANCE, NAME=c\n"), refused="*CONTACT CLEARANCE"),
    Proof("SURFACE: TYPE; RIGID BODY: ANALYTICAL_SURFACE", walled("0., 0., 0., 1., 0., 0.\n0., 1., 0.\nSTART, -20., -0.01\nLINE, 30., -0.01\n"), refused="define it in a part"),
    Proof("SURFACE: TYPE; RIGID BODY: ANALYTICAL_SURFACE", swept("START, -20., -0.01\nLINE, 30., -0.01\n"), BOUNCED, "the cube comes back from a strip"),
    Proof("SURFACE: TYPE; RIGID BODY: ANALYTICAL_SURFACE", swept("START, -20., -0.01\nLINE, 5., -0.01\nLINE, 30., -0.01\n"), BOUNCED, "the cube comes back from rigid shells"),
    Proof("SURFACE: TYPE; BOUNDARY: TYPE", swept("START, -20., -0.01\nLINE, 30., -0.01\n", "*BOUNDARY, TYPE=VELOCITY\nw.ref, 3, 3, 3000.\n", 0.0),
          [(lambda h: float(h["momentum_z"][-1] > 3000 * CUBE_MASS), LAST, 1.0, 1e-9)], "a strip that rises at 3000 mm/s throws the cube"),
    Proof("SURFACE: TYPE; RIGID BODY: ANALYTICAL_SURFACE", walled("0., 0., 0., 0., 0., 1.\nSTART, 0., -0.01\nLINE, 20., -0.01\n", "REVOLUTION"), BOUNCED, "the cube comes back from a disk of rigid shells"),
    Proof("SURFACE: TYPE", walled("START, 0., 0.\nBEND, 1., 1.\n"), refused="is expected"),
]  # fmt: skip

NOT_PHYSICS = {
    "COUPLING.CONSTRAINT NAME": "a name", "TIE.ADJUST": "the report says that gaps stay", "TIE.TYPE": "how a gap is measured: percuss has one way",
    "TIE.NO ROTATION": "of shells alone: the ties of the tests of contact prove rotations", "CONTACT PAIR.CPSET": "a name", "CONTACT PAIR.TYPE": "contact works both ways",
    "CONTACT.OP": "the first step has nothing before it",
    "FRICTION.ROUGH": "the report says which coefficient stands for it",
    "CONTACT INITIALIZATION DATA": "the report says that overlaps stay", "CONTACT INITIALIZATION DATA.NAME": "a name",
    "CONTACT INITIALIZATION DATA.SEARCH ABOVE": "the report says that overlaps stay", "CONTACT INITIALIZATION DATA.SEARCH BELOW": "the report says that overlaps stay",
}  # fmt: skip
