"""Composites of keyword decks: plies, axes, criteria of failure."""

import math

from . import FIRST, LAST, MAX, MIN, Proof
from .laminates import Constants, find_energy, find_load
from .pieces import curve, deck, elastic, hexahedron, node_set, part, solid_section, square, velocity

END = 1e-3
CARBON: Constants = (140e3, 10e3, 0.28, 5e3)
GLASS: Constants = (40e3, 12e3, 0.24, 4e3)
METAL: Constants = (7e4, 7e4, 0.25, 7e4 / 2.5)
ALONG = "0,0,0,1.0,0,0\n"  # A1
E, K = (2e-4, -1e-4, 1.5e-4), 3e-4  # strains xx, yy, xy and the curvature xx
TOLERANCE = 2e-3


def m2(id=2, of=CARBON, aopt="2.0", point=ALONG, vectors="0\n", more=""):
    """*MAT_ORTHOTROPIC_ELASTIC; PRBA is nu_ba."""
    return f"*MAT_ORTHOTROPIC_ELASTIC\n{id},1.6e-9,{of[0]!r},{of[1]!r},9000.0,{of[2] * of[1] / of[0]!r},0.01,0.3\n{of[3]!r},3500.0,4500.0,{aopt}{more}\n{point}{vectors}"


def composite(*plies, more="0,0", kind="", word="PART_COMPOSITE"):
    """Part 1 with plies (material, thickness, angle)."""
    fields = [f"{material},{thickness!r},{angle!r},0" for material, thickness, angle in plies]
    lines = fields if "LONG" in word else [",".join(fields[i : i + 2]) for i in range(0, len(fields), 2)]
    return f"*{word}\nlaminate\n1,16,1.0,{more}\n{kind}" + "".join(f"{line}\n" for line in lines)


def strained(*cards, e=E, k=K, shells="", end=END, rows=100):
    """A shell of 10 mm that gets strains and a curvature, all of its nodes moved."""
    points = {2: (1, 0), 3: (1, 1), 4: (0, 1)}
    moves = [(node, 1, 10 * (e[0] * x + e[2] * y)) for node, (x, y) in points.items()]
    moves += [(node, 2, 10 * e[1] * y) for node, (x, y) in points.items()]
    moves += [(node, 6, 5 * k * (1 if node in (2, 3) else -1)) for node in (1, 2, 3, 4)]
    lines = "".join(f"{node},{direction},0,{7 if way else 8},{way or 1.0!r}\n" for node, direction, way in moves)  # a factor of 0 is 1
    return deck(shells or square(), *cards, "*BOUNDARY_SPC_NODE\n1,0,1,1,1,1,0,1\n2,0,0,0,1,1,0,1\n3,0,0,0,1,1,0,1\n4,0,0,0,1,1,0,1\n",
                f"*BOUNDARY_PRESCRIBED_MOTION_NODE\n{lines}", curve(7, (0.0, 1 / end), (1.0, 1 / end)), curve(8, (0.0, 0.0), (1.0, 0.0)), FOLLOW, end=end, rows=rows)  # fmt: skip


FOLLOW = "*DATABASE_HISTORY_SHELL\n1\n*DATABASE_ELOUT\n1e-6\n"


def energy(*plies, e=E, k=K, middle=0.0, area=100.0):
    return [("internal", LAST, find_energy(plies, e, k, area, middle), TOLERANCE)]


THREE = [(2, 0.5, 15.0), (3, 0.25, 90.0), (2, 0.75, -40.0)]
BOTH = m2() + m2(3, GLASS)
THREE_PLIES = [(0.5, 15.0, CARBON), (0.25, 90.0, GLASS), (0.75, -40.0, CARBON)]
ONE = composite((2, 1.0, 15.0))


def one(degrees):
    return energy((1.0, degrees, CARBON))


def sectioned(material, more="", shells=""):
    """A shell of one material, 1 mm thick."""
    return strained(part(1, 1, 2), f"*SECTION_SHELL\n1,2,1.0,3{more}\n", material, shells=shells)


PLAIN = "\n1.0,1.0,1.0,1.0"
GAUSS = [5 / 18, 8 / 18, 5 / 18]
ANGLES = (10.0, 90.0, -30.0)
TURNED = square().replace("1,1,1,2,3,4", "1,1,2,3,4,1")  # its first side is along y
EIGHT = "*ELEMENT_SHELL{}\n1,1,1,2,3,4\n{}"


def with_option(option, line):
    return square().replace("*ELEMENT_SHELL\n", f"*ELEMENT_SHELL_{option}\n") + line


LAYUPS = [
    Proof("PART_COMPOSITE: PID ELFORM MID1 THICK1 B1 MID2 THICK2 B2; MAT_ORTHOTROPIC_ELASTIC: MID EA EB PRBA GAB AOPT A1 A2 A3", strained(composite(*THREE), BOTH), energy(*THREE_PLIES), "laminate theory"),
    Proof("PART_COMPOSITE_LONG: MID1 THICK1 B1", strained(composite(*THREE, word="PART_COMPOSITE_LONG"), BOTH), energy(*THREE_PLIES), "one ply a line"),
    Proof("PART_COMPOSITE_CONTACT: FS OPTT", strained(composite(*THREE, word="PART_COMPOSITE_CONTACT", kind="0.3,0,0,0,0,1.0\n"), BOTH), energy(*THREE_PLIES), "the line of contact is read"),
    Proof("PART_COMPOSITE: NLOC", strained(composite(*THREE, more="1.0"), BOTH), energy(*THREE_PLIES, middle=-0.75), "the mesh is the top"),
    Proof("PART_COMPOSITE: NLOC", strained(composite(*THREE, more="-0.4"), BOTH), energy(*THREE_PLIES, middle=0.3), "the middle lies 0.3 above the mesh"),
    Proof("PART_COMPOSITE: MAREA; MAT_ORTHOTROPIC_ELASTIC: RO", deck(square(), composite(*THREE, more="0,2e-9"), BOTH.replace("3,1.6e-9", "3,2.4e-9"), velocity(100.0)),
          [("momentum_x", FIRST, 100.0 * 100.0 * (1.25 * 1.6e-9 + 0.25 * 2.4e-9 + 2e-9), 1e-9)], "the mean of the plies, and mass per area"),
    Proof("PART_COMPOSITE: MID1", strained(composite((2, 0.5, 15.0), (4, 0.75, 30.0)), m2(), elastic(4, 2.7e-9, METAL[0], METAL[2])), energy((0.5, 15.0, CARBON), (0.75, 0.0, METAL)), "a sheet of metal below"),
    Proof("PART_COMPOSITE: MID1", strained(composite((4, 0.5, 0.0), (5, 0.75, 0.0)), elastic(4, 2.7e-9, METAL[0], METAL[2]), elastic(5, 1e-9, 2e4, 0.3)),
          energy((0.5, 0.0, METAL), (0.75, 0.0, (2e4, 2e4, 0.3, 2e4 / 2.6))), "two metals"),
    Proof("PART_COMPOSITE: MID1", strained(composite((4, 0.5, 0.0), (5, 0.5, 0.0)), elastic(4), "*MAT_PLASTIC_KINEMATIC\n5,7.8e-9,2.1e5,0.3,100.0,0\n0\n", e=(5e-3, 0.0, 0.0), k=0.0),
          [("element_1_stress_xx", LAST, 0.5 * (2.1e5 / 0.91 * math.log(1.005) + 100.0 / math.sqrt(0.75)), 3e-2)], "one ply yields, in plane strain at 2 / sqrt(3) of the yield stress"),
    Proof("PART_COMPOSITE: ELFORM", strained(composite(*THREE).replace("1,16,", "1,12,"), BOTH), refused="formulation 12"),
    Proof("PART_COMPOSITE: PID", strained(composite(*THREE), BOTH, part()), refused="there are two parts 1"),
    Proof("PART_COMPOSITE: THICK1", strained(composite((2, 0.0, 0.0)), m2()), refused="a positive thickness"),
    Proof("PART_COMPOSITE: MID1", strained(composite(*THREE), m2()), refused="material 3"),
    Proof("PART_COMPOSITE: MID1", strained(composite(*THREE), m2(), m2(3, GLASS, point="0,0,0,1.0,1.0,0\n")), refused="plies whose materials differ in their axes"),
    Proof("PART_COMPOSITE: MID1", strained(composite(*[(2, 0.02, float(i)) for i in range(60)]), m2()), refused="60 plies"),
    Proof("PART_COMPOSITE: MID1", strained(composite(*[(2, 0.02, 15.0)] * 60), m2()), energy((1.2, 15.0, CARBON)), "sixty equal plies"),
    Proof("PART_COMPOSITE; ELEMENT_SHELL_THICKNESS", strained(composite(*THREE), BOTH, shells=with_option("THICKNESS", "1.0,1.0,1.0,1.0\n")), refused="another thickness than its plies"),
    Proof("PART_COMPOSITE", strained(composite(*THREE, more="0,0,9").replace("1,16,", "1,2,"), BOTH, "*HOURGLASS\n9,4,0.05\n"), energy(*THREE_PLIES), "no hourglass mode moves"),
    Proof("SECTION_SHELL: ICOMP B1 B2 B3", sectioned(m2(), ",0,0,1" + PLAIN + "\n10.0,90.0,-30.0"), energy(*((t, a, CARBON) for t, a in zip(GAUSS, ANGLES))), "plies as thick as the weights of Gauss"),
    Proof("SECTION_SHELL: ICOMP QR B1 B2 B3", sectioned(m2(), ",0,1,1" + PLAIN + "\n10.0,90.0,-30.0"), energy(*((t, a, CARBON) for t, a in zip((0.25, 0.5, 0.25), ANGLES))), "those of the trapezoidal rule"),
    Proof("SECTION_SHELL: ICOMP NIP B1 B2 B3 B4 B5 B6 B7 B8 QR", sectioned(m2(), ",0,1,1" + PLAIN + "\n10,20,30,40,50,60,70,80\n90").replace("1,2,1.0,3", "1,2,1.0,9"),
          energy(*((0.0625 if i in (0, 8) else 0.125, 10.0 * (i + 1), CARBON) for i in range(9))), "nine angles on two lines"),
    Proof("SECTION_SHELL: ICOMP NLOC", sectioned(m2(), ",0,0,1\n1.0,1.0,1.0,1.0,-1.0\n10.0,90.0,-30.0"), energy(*((t, a, CARBON) for t, a in zip(GAUSS, ANGLES)), middle=0.5), "the mesh is the bottom"),
]  # fmt: skip
AXES = [
    Proof("MAT_ORTHOTROPIC_ELASTIC: AOPT", sectioned(m2(), PLAIN), one(0.0), "fibres along x"),
    Proof("MAT_ORTHOTROPIC_ELASTIC: A1 A2 A3", sectioned(m2(point="0,0,0,1.0,2.0,5.0\n"), PLAIN), one(math.degrees(math.atan2(2, 1))), "what of A lies in the plane"),
    Proof("MAT_ORTHOTROPIC_ELASTIC: AOPT", sectioned(m2(aopt="0.0"), PLAIN), one(0.0), "the first side is along x"),
    Proof("MAT_ORTHOTROPIC_ELASTIC: AOPT", sectioned(m2(aopt="0.0"), PLAIN, TURNED), one(90.0), "the first side is along y"),
    Proof("MAT_ORTHOTROPIC_ELASTIC: AOPT BETA", sectioned(m2(aopt="0.0", vectors="0,0,0,0,0,0,25.0\n"), PLAIN), one(25.0), "turned by BETA"),
    Proof("MAT_ORTHOTROPIC_ELASTIC: AOPT V1 V2 V3 BETA", sectioned(m2(aopt="3.0", vectors="0.6,0.8,0,0,0,0,25.0\n"), PLAIN), one(math.degrees(math.atan2(-0.6, 0.8)) + 25.0), "V x n = (0.8, -0.6), turned by BETA"),
    Proof("MAT_ORTHOTROPIC_ELASTIC: AOPT", sectioned(m2(aopt="-5") + "*DEFINE_COORDINATE_VECTOR\n5,1.0,0.5,0,0,1.0,0\n", PLAIN), one(math.degrees(math.atan2(0.5, 1))), "x of a system"),
    Proof("MAT_ORTHOTROPIC_ELASTIC: BETA", strained(composite((2, 0.5, 10.0), (2, 0.5, -30.0)), m2(aopt="3.0", vectors="0,1.0,0,0,0,0,25.0\n")), energy((0.5, 35.0, CARBON), (0.5, -5.0, CARBON)), "V x n = x; angles of plies on top"),
    Proof("ELEMENT_SHELL_BETA: BETA", sectioned(m2(), PLAIN, with_option("BETA", "1.0,1.0,1.0,1.0,45.0\n")), one(45.0), "turned from A"),
    Proof("ELEMENT_SHELL_BETA: BETA", sectioned(m2(aopt="0.0", vectors="0,0,0,0,0,0,25.0\n"), PLAIN, with_option("BETA", "1.0,1.0,1.0,1.0,45.0\n")), one(45.0), "in place of BETA of the material"),
    Proof("ELEMENT_SHELL_BETA: BETA", strained(ONE, m2(), shells=with_option("BETA", "0,0,0,0,45.0\n")), one(60.0), "and the angle of the ply"),
    Proof("ELEMENT_SHELL_BETA: BETA", deck(with_option("BETA", "0,0,0,0,45.0\n"), square(2, 11, (50.0, 0.0, 0.0)), ONE, m2()), refused="BETA that differs between the shells"),
    Proof("ELEMENT_SHELL_MCID: BETA", sectioned(m2(), PLAIN, with_option("MCID", "1.0,1.0,1.0,1.0,7\n")), refused="systems of axes of their own"),
    Proof("MAT_ORTHOTROPIC_ELASTIC: BETA", sectioned(m2(vectors="0,0,0,0,0,0,25.0\n"), PLAIN), refused="BETA with AOPT = 2"),
    Proof("MAT_ORTHOTROPIC_ELASTIC: BETA", deck(with_option("THICKNESS", "1.0,1.0,1.0,1.0\n"), square(2, 11, (50.0, 0.0, 0.0)), part(1, 1, 2), "*SECTION_SHELL\n1,2\n2.0\n", m2(aopt="3.0", vectors="0,1.0,0\n")),
          refused="shells differ in thickness"),
    Proof("MAT_ORTHOTROPIC_ELASTIC: AOPT", sectioned(m2(aopt="4.0"), PLAIN), refused="AOPT = 4"),
    Proof("MAT_ORTHOTROPIC_ELASTIC: AOPT", sectioned(m2(aopt="-5"), PLAIN), refused="system 5 of axes"),
    Proof("MAT_ORTHOTROPIC_ELASTIC: A1", sectioned(m2(point="0,0,0,0,0,0\n"), PLAIN), refused="the vector of its axis is zero"),
    Proof("MAT_ORTHOTROPIC_ELASTIC: PRBA", sectioned(m2(of=(140e3, 10e3, 4.0, 5e3)), PLAIN), refused="poissons_ratios that no stable material has"),
]  # fmt: skip


def pushed(direction, more, aopt="2.0", point=ALONG, vectors="0,0,0,0,1.0,0\n"):
    """A cube that is strained by 1e-4 along a direction, free to move along no other."""
    material = f"*MAT_ORTHOTROPIC_ELASTIC\n1,1.6e-9,100000.0,20000.0,10000.0,0.05,0.02,0.15\n8000.0,5000.0,6000.0,{aopt}{more}\n{point}{vectors}"
    face = {1: (2, 3, 6, 7), 2: (3, 4, 7, 8), 3: (5, 6, 7, 8)}[direction]
    held = "".join(f"{node},0,{','.join('0' if node in face and d == direction else '1' for d in (1, 2, 3))}\n" for node in range(1, 9))
    return deck(hexahedron(), part(), solid_section(), material, f"*BOUNDARY_SPC_NODE\n{held}", node_set(1, *face), f"*BOUNDARY_PRESCRIBED_MOTION_SET\n1,{direction},0,7,1e-3\n",
                curve(7, (0.0, 1 / END), (1.0, 1 / END)), "*DATABASE_HISTORY_SOLID\n1\n*DATABASE_ELOUT\n1e-5\n", end=END)  # fmt: skip


def make_stiffness():
    """Of the cube: the inverse of its compliance, with nu_ba, nu_ca, nu_cb as the card has them."""
    ea, eb, ec, ba, ca, cb = 100000.0, 20000.0, 10000.0, 0.05, 0.02, 0.15
    s = [[1 / ea, -ba / eb, -ca / ec], [-ba / eb, 1 / eb, -cb / ec], [-ca / ec, -cb / ec, 1 / ec]]
    det = sum(s[0][i] * (s[1][(i + 1) % 3] * s[2][(i + 2) % 3] - s[1][(i + 2) % 3] * s[2][(i + 1) % 3]) for i in range(3))
    return [[(s[(j + 1) % 3][(i + 1) % 3] * s[(j + 2) % 3][(i + 2) % 3] - s[(j + 1) % 3][(i + 2) % 3] * s[(j + 2) % 3][(i + 1) % 3]) / det for j in range(3)] for i in range(3)]


C = make_stiffness()


def answers(column):
    """Stresses for a strain of 1e-4 along the axis of a column, by the axes that x, y and z are."""
    return [(f"element_1_stress_{name}", LAST, C[row][column[0]] * 1e-4, TOLERANCE) for name, row in zip(("xx", "yy", "zz"), column[1])]


def as_card(word, deck_text, last=""):
    """A deck of *MAT_ORTHOTROPIC_ELASTIC with another law, whose AOPT is the fifth of its line."""
    return deck_text.replace("MAT_ORTHOTROPIC_ELASTIC", word).replace("6000.0,2.0\n", "6000.0,0,2.0\n").replace("*BOUNDARY_SPC", last + "*BOUNDARY_SPC")


def lifted(nodes_up, material):
    """A shell of 1 mm of which two nodes move up by 1e-3, none turns: the shear is 1e-4."""
    return deck(square(), part(1, 1, 2), "*SECTION_SHELL\n1,2,1.0,3\n1.0,1.0,1.0,1.0\n", material, "".join(f"*BOUNDARY_SPC_NODE\n{n},0,1,1,{int(n not in nodes_up)},1,1,1\n" for n in (1, 2, 3, 4)),
                node_set(1, *nodes_up), "*BOUNDARY_PRESCRIBED_MOTION_SET\n1,3,0,7,1e-3\n", curve(7, (0.0, 1 / END), (1.0, 1 / END)), end=END)  # fmt: skip


def flying(material):
    return deck(square(), part(1, 1, 2), "*SECTION_SHELL\n1,2,1.0,3\n1.0,1.0,1.0,1.0\n", material, velocity(100.0))


def across(modulus):
    return [("internal", LAST, 100.0 * 5 / 6 * modulus * 1e-8 / 2, TOLERANCE)]


def own_axes(text, lines):
    """A deck with axes of its one solid."""
    first, second = text.split("*ELEMENT_SOLID\n")
    element, rest = second.split("\n", 1)
    return f"{first}*ELEMENT_SOLID_ORTHO\n{element}\n{lines}{rest}"


SOLIDS = [
    Proof("MAT_ORTHOTROPIC_ELASTIC: EA EB EC PRBA PRCA PRCB", pushed(1, ""), answers((0, (0, 1, 2))), "a along x"),
    Proof("MAT_ORTHOTROPIC_ELASTIC: EC PRCA PRCB", pushed(3, ""), answers((2, (0, 1, 2))), "the third axis"),
    Proof("MAT_ORTHOTROPIC_ELASTIC: A1 A2 A3 D1 D2 D3", pushed(1, "", point="0,0,0,0,0,2.0\n", vectors="0,0,0,3.0,0,1.0\n"), answers((1, (1, 2, 0))), "a along z, b along x"),
    Proof("MAT_ORTHOTROPIC_ELASTIC: AOPT", pushed(2, "", aopt="0.0"), answers((1, (0, 1, 2))), "a from node 1 to 2"),
    Proof("MAT_ORTHOTROPIC_ELASTIC: AOPT", pushed(2, "", aopt="-5").replace("*BOUNDARY_SPC", "*DEFINE_COORDINATE_VECTOR\n5,0,1.0,0,0,0,1.0\n*BOUNDARY_SPC"), answers((0, (2, 0, 1))), "x of a system is y"),
    Proof("MAT_ORTHOTROPIC_ELASTIC: AOPT", pushed(1, "", aopt="3.0"), refused="AOPT = 3 of solids"),
    Proof("ELEMENT_SOLID_ORTHO; MAT_ORTHOTROPIC_ELASTIC: AOPT", own_axes(pushed(1, "", aopt="0.0"), "0,0,2.0\n3.0,0,1.0\n"), answers((1, (1, 2, 0))), "a along z, b along x"),
    Proof("ELEMENT_SOLID_ORTHO", own_axes(pushed(1, "", aopt="0.0"), "0,0,2.0\n0,0,1.0\n"), refused="AOPT"),
    Proof("ELEMENT_SOLID_ORTHO", own_axes(pushed(1, ""), "0,0,2.0\n3.0,0,1.0\n"), refused="beside *ELEMENT_SOLID_ORTHO"),
    Proof("MAT_ORTHOTROPIC_ELASTIC: BETA", pushed(1, "", aopt="0.0", vectors="0,0,0,0,0,0,25.0\n"), refused="or of solids"),
    Proof("MAT_ORTHOTROPIC_ELASTIC: MACF", pushed(1, "", point="0,0,0,1.0,0,0,2\n"), refused="MACF"),
    *[row for word, last in (("MAT_COMPOSITE_DAMAGE", "{}\n"), ("MAT_ENHANCED_COMPOSITE_DAMAGE", "0\n{}\n")) for row in (
        Proof(f"{word}: XT", as_card(word, pushed(1, ""), last.format("30.0,200.0")), refused="strengths of orthotropic solids"),
        Proof(f"{word}: EA EB EC PRBA PRCA PRCB AOPT", as_card(word, pushed(1, ""), last.format("0")), answers((0, (0, 1, 2))), "without strengths"),
        Proof(f"{word}: A1 A2 A3 D1 D2 D3", as_card(word, pushed(1, "", point="0,0,0,0,0,2.0\n", vectors="0,0,0,3.0,0,1.0\n"), last.format("0")), answers((1, (1, 2, 0))), "a along z, b along x"))],
]  # fmt: skip
XT, XC, YT, YC, SC = 200.0, 150.0, 20.0, 50.0, 30.0
EA, EB, GAB = 140e3, 10e3, 5e3
TENSION, PRESSURE, ACROSS = 0.003, 0.002, 0.004  # DFAILT, DFAILC, DFAILM


def m22(limits=f"{SC},{XT},{YT},{YC}", vectors="0"):
    return f"*MAT_COMPOSITE_DAMAGE\n2,1.6e-9,{EA!r},{EB!r},9000.0,0\n{GAB!r},3500.0,4500.0,0,2.0\n{ALONG}{vectors}\n{limits}\n"


def m54(failing="0", limits=f"{XC},{XT},{YC},{YT},{SC}", vectors="0", last="", shear="2.0", word="MAT_ENHANCED_COMPOSITE_DAMAGE", point=ALONG):
    return f"*{word}\n2,1.6e-9,{EA!r},{EB!r},9000.0,0\n{GAB!r},3500.0,4500.0,0,{shear}\n{point}{vectors}\n{failing}\n{limits}\n{last}"


def broken(material, xx=0.0, yy=0.0, xy=0.0, more=""):
    """A ply of 1 mm that is strained."""
    return strained(part(1, 1, 2), "*SECTION_SHELL\n1,2,1.0,2\n1.0,1.0,1.0,1.0\n", material, more, e=(xx, yy, xy), k=0.0, rows=1000)


def peaks(name, value, when=MAX):
    return [(f"element_1_stress_{name}", when, value, 1.5e-2)]


def first(s1=0.0, s2=0.0, t=0.0, share=0.0, st=SC):
    return find_load(s1, s2, t, XT, XC, YT, YC, SC, st, share)


def tsai_wu(s2, t):
    """The load at which s2^2 / (YT YC) + (t / SC)^2 + (1 / YT - 1 / YC) s2 is 1."""
    square, linear = s2**2 / (YT * YC) + (t / SC) ** 2, (1 / YT - 1 / YC) * s2
    return (math.sqrt(linear**2 + 4 * square) - linear) / (2 * square)


def crack(strength, modulus, strain, share=1.0):
    """Energy per volume of a stress that stays at a share of the strength until a strain, times 1000 mm3 of the element over its length and width."""
    return 100.0 * (strength**2 / modulus / 2 + share * strength * (strain - strength / modulus))


DAMAGE = f"0,0,0,0,0,{TENSION},{-PRESSURE}"
ACROSS_LINE = f"0,0,0,0,1.0,0,{ACROSS}"
MIXED = first(s1=EA * 1e-3, t=GAB * 4e-3, share=0.5)  # of the strains 1e-3 and 4e-3
FAILURE = [
    *[Proof(f"{word}: {fields}", broken(law(), **strain), peaks(name, value, when), why)
      for word, law in (("MAT_COMPOSITE_DAMAGE", m22), ("MAT_ENHANCED_COMPOSITE_DAMAGE", m54))
      for fields, strain, name, value, when, why in (
          ("XT EA AOPT A1", {"xx": 3e-3}, "xx", XT, MAX, "fibres in tension"), ("YT EB SC", {"yy": 4e-3}, "yy", YT, MAX, "matrix in tension"),
          ("YC", {"yy": -1e-2}, "yy", -YC, MIN, "matrix in compression"), ("SC GAB", {"xy": 2e-2}, "xy", SC, MAX, "shear"),
          ("SC YC", {"yy": -4e-3, "xy": 8e-3}, "xy", GAB * 8e-3 * first(s2=-EB * 4e-3, t=GAB * 8e-3), MAX, "matrix in compression, with shear"))],
    Proof("MAT_COMPOSITE_DAMAGE: XT", broken(m22(), xx=-3e-3), [("element_1_stress_xx", MIN, EA * math.log(1 - 3e-3), 5e-3)], "fibres have no strength in compression"),
    Proof("MAT_COMPOSITE_DAMAGE: XT SC", broken(m22(), xx=2e-3, xy=8e-3), peaks("xx", EA * 2e-3 * first(s1=EA * 2e-3, t=GAB * 8e-3, share=1.0)), "the shear counts for the fibres"),
    Proof("MAT_COMPOSITE_DAMAGE: ALPH", broken(m22(f"{SC},{XT},{YT},{YC},1e-9"), xx=1e-3), refused="ALPH"),
    Proof("MAT_ENHANCED_COMPOSITE_DAMAGE: XC", broken(m54(), xx=-3e-3), peaks("xx", -XC, MIN), "fibres in compression"),
    Proof("MAT_ENHANCED_COMPOSITE_DAMAGE: BETA", broken(m54(limits=f"{XC},{XT},{YC},{YT},2000.0,54,0.5"), xx=2e-3), peaks("xx", XT), "a weight of no shear"),
    Proof("MAT_ENHANCED_COMPOSITE_DAMAGE: BETA", broken(m54(limits=f"{XC},{XT},{YC},{YT},{SC},54,1.0"), xx=4e-3, xy=9e-3),
          peaks("xx", EA * 4e-3 * first(s1=EA * 4e-3, t=GAB * 9e-3, share=1.0)), "the shear counts for the fibres"),
    Proof("MAT_ENHANCED_COMPOSITE_DAMAGE: XT", broken(m54(), xx=3e-3), [("eroded_elements", LAST, 1.0, 0.0)], "all plies have failed"),
    Proof("MAT_ENHANCED_COMPOSITE_DAMAGE: YT", broken(m54(), yy=3e-3), [("eroded_elements", LAST, 0.0, 0.0)], "its fibres hold"),
    Proof("MAT_ENHANCED_COMPOSITE_DAMAGE: DFAILT", broken(m54(DAMAGE), xx=6e-3), [*peaks("xx", XT), ("internal", MAX, crack(XT, EA, TENSION), 1e-2), ("eroded_elements", LAST, 1.0, 0.0)],
          "the energy of a stress that stays until DFAILT"),
    Proof("MAT_ENHANCED_COMPOSITE_DAMAGE: DFAILC", broken(m54(DAMAGE), xx=-4e-3), [*peaks("xx", -XC, MIN), ("internal", MAX, crack(XC, EA, PRESSURE), 1e-2)], "until DFAILC"),
    Proof("MAT_ENHANCED_COMPOSITE_DAMAGE: DFAILM", broken(m54(DAMAGE, vectors=ACROSS_LINE), yy=8e-3), [*peaks("yy", YT), ("internal", LAST, crack(YT, EB, ACROSS), 1e-2)], "until DFAILM"),
    Proof("MAT_ENHANCED_COMPOSITE_DAMAGE: DFAILM", broken(m54(DAMAGE, vectors="0,0,0,0,1.0,0,0.02"), yy=-4.5e-2), [*peaks("yy", -YC, MIN), ("internal", LAST, crack(YC, EB, 0.02), 4e-2)], "likewise in compression"),
    *[Proof(f"MAT_ENHANCED_COMPOSITE_DAMAGE: {name}", broken(m54(DAMAGE, vectors="0,0,0,0,1.0,0,0.02", last="0\n" + ",".join("0.5" if i == place else "0" for i in range(4)) + "\n"), **strain),
            [("internal", MAX, crack(strength, modulus, until, 0.5), 4e-2)], "half of the strength stays")
      for place, name, strain, strength, modulus, until in ((0, "SLIMT1", {"xx": 6e-3}, XT, EA, TENSION), (1, "SLIMC1", {"xx": -4e-3}, XC, EA, PRESSURE),
                                                            (2, "SLIMT2", {"yy": 2.5e-2}, YT, EB, 0.02), (3, "SLIMC2", {"yy": -3.5e-2}, YC, EB, 0.02))],
    Proof("MAT_ENHANCED_COMPOSITE_DAMAGE: TFAIL", broken(m54("1e-4"), xx=1e-4), [("eroded_elements", LAST, 1.0, 0.0)], "its step is less than TFAIL"),
    Proof("MAT_ENHANCED_COMPOSITE_DAMAGE: TFAIL SOFT", broken(m54("0,0,0.7"), xx=3e-3), peaks("xx", XT), "SOFT needs TFAIL"),
    Proof("MAT_ENHANCED_COMPOSITE_DAMAGE: MANGLE AOPT", broken(m54(shear="0.0", point="0,0,0,0,0,0,90.0\n"), yy=3e-3), peaks("yy", XT), "fibres across the first side"),
    Proof("MAT_ENHANCED_COMPOSITE_DAMAGE: V1 V2 V3 AOPT", broken(m54(shear="3.0", vectors="1.0,0,0"), yy=3e-3), peaks("yy", XT), "V x n = -y"),
    Proof("MAT_ENHANCED_COMPOSITE_DAMAGE: XT", broken(m54(word="MAT_054"), xx=3e-3), peaks("xx", XT), "by its number"),
    Proof("MAT_ENHANCED_COMPOSITE_DAMAGE: XT", broken(m54(word="MAT_054-055"), xx=3e-3), peaks("xx", XT), "by its numbers"),
    *[Proof("MAT_ENHANCED_COMPOSITE_DAMAGE: CRIT", broken(m54(limits=f"{XC},{XT},{YC},{YT},{SC},55"), yy=yy, xy=6e-3), peaks("yy", EB * yy * tsai_wu(EB * yy, GAB * 6e-3), when), "Tsai and Wu's criterion")
      for yy, when in ((3e-3, MAX), (-5e-3, MIN))],
    Proof("MAT_ENHANCED_COMPOSITE_DAMAGE: CRIT", broken(m54(limits=f"{XC},{XT},0,{YT},{SC},55"), xx=1e-3), refused="needs YT and YC"),
    Proof("MAT_ENHANCED_COMPOSITE_DAMAGE: CRIT", broken(m54(limits=f"{XC},{XT},{YC},{YT},{SC},56"), xx=1e-3), refused="another criterion"),
    Proof("MAT_ENHANCED_COMPOSITE_DAMAGE: BETA", broken(m54(limits=f"{XC},{XT},{YC},{YT},{SC},54,2.0"), xx=1e-3), refused="a weight of the shear from 0 to 1"),
    Proof("MAT_ENHANCED_COMPOSITE_DAMAGE: TFAIL", broken(m54("0.7"), xx=1e-3), refused="a share of the first step"),
    *[Proof(f"MAT_ENHANCED_COMPOSITE_DAMAGE: {name}", broken(law, xx=1e-3), refused=name)
      for name, law in (("2WAY", m54(shear="2.0,1")), ("ALPH", m54("0,0.3")), ("SOFT", m54("1e-9,0,0.7")), ("FBRT", m54("0,0,0,0.5")), ("EFS", m54("0,0,0,0,0,0,0,0.1")),
                        ("DFAILS", m54(DAMAGE, vectors=ACROSS_LINE + ",0.05")), ("LCXT", m54(last="0\n0\n0,9\n")), ("EPSF", m54(last="0,0.1\n")), ("SLIMS", m54(DAMAGE, last="0\n0,0,0,0,0.5\n")))],
    *[row for word, law in (("MAT_ORTHOTROPIC_ELASTIC", m2()), ("MAT_COMPOSITE_DAMAGE", m22()), ("MAT_ENHANCED_COMPOSITE_DAMAGE", m54())) for row in (
        Proof(f"{word}: GCA", lifted((2, 3), law), across(4500.0), "5/6 of the shear along x"), Proof(f"{word}: GBC", lifted((3, 4), law), across(3500.0), "5/6 of the shear along y"),
        Proof(f"{word}: MID RO", flying(law), [("momentum_x", FIRST, 100.0 * 100.0 * 1.6e-9, 1e-9)], "mass of 100 mm3"))],
    *[row for word, law in (("MAT_COMPOSITE_DAMAGE", m22), ("MAT_ENHANCED_COMPOSITE_DAMAGE", m54)) for row in (
        Proof(f"{word}: A1 A2 A3", broken(law().replace(ALONG, "0,0,0,0,1.0,0.5\n"), yy=3e-3), peaks("yy", XT), "fibres along y"),
        Proof(f"{word}: PRBA", broken(law().replace(",9000.0,0\n", ",9000.0,0.02\n"), xx=1e-3), peaks("yy", 0.02 * EA / (1 - 0.02**2 * EA / EB) * math.log(1.001)), "the stress across is nu_ba times that along"),
        Proof(f"{word}: V1 V2 V3", broken(law(vectors="1.0,0,0").replace(",0,2.0\n", ",0,3.0\n"), yy=3e-3), peaks("yy", XT), "V x n = -y"))],
    Proof("MAT_COMPOSITE_DAMAGE: MACF", broken(m22().replace(",0,2.0\n", ",0,2.0,3\n"), xx=1e-3), refused="MACF"),
    *[Proof(f"MAT_ENHANCED_COMPOSITE_DAMAGE: {name}", broken(m54(last=last), xx=1e-3), refused=name)
      for name, last in (("SOFT2", "0,0,0,0,0.6\n"), ("SOFTG", "0\n0,0,0,0,0,0,0.6\n"), *((f"LCX{c}" if i < 2 else name, "0\n0\n" + "0," * i + "9\n") for i, (c, name) in enumerate((("C", ""), ("T", ""), ("", "LCYC"), ("", "LCYT"), ("", "LCSC")))))],
    Proof("PART_COMPOSITE_LONG: SHRFAC1", strained(composite((2, 1.0, 0.0), word="PART_COMPOSITE_LONG").replace("1.0,0.0,0\n", "1.0,0.0,0,0,0.5\n"), m2()), refused="SHRFAC1"),
    Proof("PART_COMPOSITE: MID1", strained(composite((2, 0.5, 0.0), (3, 0.5, 0.0)), m54(), m54("0,0,0,0,0,0.003").replace("\n2,1.6e-9", "\n3,1.6e-9") + "*MAT_ADD_EROSION\n3,0\n0,500.0\n"), refused="differ in their failure"),
    Proof("PART_COMPOSITE: MID1; CONTROL_SHELL: NFAIL1", strained(composite((2, 0.5, 0.0), (4, 0.5, 0.0)), m54(), elastic(4), "*CONTROL_SHELL\n\n\n\n1\n", e=(1e-4, 0.0, 0.0), k=0.0),
          [("internal", LAST, find_energy(((0.5, 0.0, (EA, EB, 0.0, GAB)), (0.5, 0.0, (2.1e5, 2.1e5, 0.3, 2.1e5 / 2.6))), (1e-4, 0.0, 0.0), 0.0), TOLERANCE)], "a failure of all plies is that of the part"),
    Proof("MAT_ADD_EROSION: NUMFIP", strained(composite((2, 0.5, 0.0), (2, 0.5, 90.0)), m54(), "*MAT_ADD_EROSION\n2,0,0,0,0,0,1\n0,500.0\n"), refused="NUMFIP: 0.5 of the points must fail, and 1"),
    Proof("MAT_LAMINATED_COMPOSITE_FABRIC", broken("*MAT_LAMINATED_COMPOSITE_FABRIC\n2,1.6e-9,140000.0,10000.0,0,0.02\n", xx=1e-3), refused="Matzenmiller"),
]  # fmt: skip
PROOFS = [*LAYUPS, *AXES, *SOLIDS, *FAILURE]
NOT_PHYSICS = {
    "MAT_ENHANCED_COMPOSITE_DAMAGE.YCFAC": "the report says that fibres keep their strength",
    **{f"PART_COMPOSITE{word}.{name}": why for word in ("", "_CONTACT", "_LONG")
       for name, why in (("HGID", "read as HGID of *PART"), ("SHRF", "the report says that transverse shear has the energy of its stresses"), ("SFT", "read as SFT of *PART_CONTACT"))},
}  # fmt: skip
