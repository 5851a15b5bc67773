"""Sections, controls, outputs, springs and welds."""

import math

from . import ALL, FIRST, LAST, MAX, Proof
from .dyna_laws import END, FOLLOW, POISSON, SHEAR, STIFF, STRAIN, UP, YOUNG, erosion_time, stretched, stretched_shell
from .pieces import CUBE_MASS, DENSITY, cube, curve, deck, elastic, hexahedron, node_set, nodes, part, rigid, shell, shell_section, solid_section, square, two_cubes, velocity

STEEL = elastic(1, DENSITY, YOUNG, POISSON)
SPEED = math.sqrt(STIFF / DENSITY)
PLATE_MASS = DENSITY * 100.0


def plate(section, more=""):
    return deck(square(), more, part(), section, elastic(), velocity(100.0))


def triangle(section):
    return deck(nodes((1, 0.0, 0.0, 0.0), (2, 10.0, 0.0, 0.0), (3, 0.0, 10.0, 0.0)), "*ELEMENT_SHELL\n1,1,1,2,3,3\n", part(), section, elastic(), velocity(100.0))


def beam(section, *more, law="", end=1e-5):
    """A beam of 10 mm along x, with its third node along z."""
    return deck(nodes((1, 0.0, 0.0, 0.0), (2, 10.0, 0.0, 0.0), (3, 0.0, 0.0, 10.0)), "*ELEMENT_BEAM\n1,1,1,2,3\n", part(), section, law or STEEL, *more, end=end)


FLYING = velocity(100.0)
BEAM_OUT = "*DATABASE_HISTORY_BEAM\n1\n*DATABASE_ELOUT\n1e-5\n"
PULLED = "*BOUNDARY_SPC_NODE\n1,0,1,1,1,1,1,1\n2,0,0,1,1,1,1,1\n*BOUNDARY_PRESCRIBED_MOTION_NODE\n2,1,2,7\n" + curve(7, (0.0, 0.0), (END, 0.1)) + BEAM_OUT
TURN = 0.002  # of each end of the beam, against each other
BENT = ("*BOUNDARY_SPC_NODE\n1,0,1,1,1,1,{y},{z}\n2,0,1,1,1,1,{y},{z}\n*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,{d},0,7,-1.0\n2,{d},0,7,1.0\n"
        + curve(7, (0.0, TURN / END), (1.0, TURN / END)) + BEAM_OUT)  # fmt: skip
ABOUT_Y, ABOUT_Z = BENT.format(y=0, z=1, d=6), BENT.format(y=1, z=0, d=7)


SHEARED = ("*BOUNDARY_SPC_NODE\n1,0,1,1,1,1,1,1\n2,0,1,0,0,1,1,1\n*BOUNDARY_PRESCRIBED_MOTION_NODE\n2,{axis},2,7\n" + curve(7, (0.0, 0.0), (END, 0.01)) + BEAM_OUT)
TWISTED = BENT.format(y=1, z=1, d=5).replace("1,0,1,1,1,1,1,1", "1,0,1,1,1,0,1,1").replace("2,0,1,1,1,1,1,1", "2,0,1,1,1,0,1,1")


def magnitude(name):
    return lambda history: abs(history[name][-1])


def largest_shear(history):
    return max(abs(history[f"element_1_shear_{axis}"][-1]) for axis in "yz")


def largest_moment(history):
    return max(abs(history[f"element_1_moment_{axis}"][-1]) for axis in "yz")


AXIAL = "element_1_axial_force"


# So that something moves: balances are relative.
FLYING_CUBE = hexahedron(3, 31, (50.0, 0.0, 0.0), of=3) + part(3, 3) + solid_section(3) + "*INITIAL_VELOCITY_GENERATION\n3,2,0,1000.0,0,0\n0\n"


def weld(card, direction, *more, keyword="SPOTWELD"):
    """A node of a cube, welded to one of a held cube, is pulled by a force that grows by 1e6 N/s: it does not move, the weld carries it all."""
    load = f"*LOAD_NODE_POINT\n11,{direction},7,1.0\n" + curve(7, (0.0, 0.0), (1.0, 1e6))
    return deck(two_cubes(), FLYING_CUBE, node_set(1, *range(1, 9)), f"*BOUNDARY_SPC_SET\n1,0,1,1,1\n*CONSTRAINED_{keyword}\n{card}\n", load, *more, end=1e-4, rows=1000)


def welded_sheets(card):
    """A node of a sheet, welded to one of a held sheet below, is pulled along the sheets by a force that grows by 1e6 N/s: the weld carries it all."""
    load = "*LOAD_NODE_POINT\n11,1,7,1.0\n" + curve(7, (0.0, 0.0), (1.0, 1e6)) + FLYING_CUBE
    return deck(shell(1.0), square(2, 11, (0.0, 0.0, 1.0), of=2), part(2), node_set(1, 1, 2, 3, 4), f"*BOUNDARY_SPC_SET\n1,0,1,1,1,1,1,1\n*CONSTRAINED_SPOTWELD\n{card}\n", load,
                end=1e-4, rows=1000)  # fmt: skip


def flying_weld(card):
    """Two cubes that fly as one."""
    return deck(two_cubes(), velocity(100.0), f"*CONSTRAINED_{card}\n", end=1e-4, rows=1000)


def failure_time(history):
    return next((time for time, count in zip(history["time"], history["welds_failed"]) if count > 0), 0.0)


def spring(card, material, *more):
    """Two held cubes, 5 mm apart, of which the second moves away by 0.1 mm; a spring between nodes 5 and 11."""
    held = node_set(1, *range(1, 9)) + node_set(2, *range(11, 19)) + "*BOUNDARY_SPC_SET\n1,0,1,1,1\n2,0,1,1,0\n*BOUNDARY_PRESCRIBED_MOTION_SET\n2,3,2,7\n"
    return deck(two_cubes(5.0), held, curve(7, (0.0, 0.0), (END, 0.1)), f"*ELEMENT_DISCRETE\n{card}\n*PART\nspring\n5,5,5\n*SECTION_DISCRETE\n5\n{material}\n*DATABASE_DEFORC\n1e-5\n",
                *more, end=END)  # fmt: skip


FORCE = "spring_force:spring_9"


def impulse_of(column):
    """The impulse of a force over the change of momentum."""

    def find(history):
        steps = [after - before for before, after in zip(history["time"], history["time"][1:])]
        total = sum(force * step for force, step in zip(history[column][1:], steps))
        return total / (history["momentum_z"][-1] - history["momentum_z"][0])

    return find


def thinning_energy(ratio):
    """Work on a shell that is stretched equally by ln(ratio), whose thickness falls by 2 nu / (1 - nu) of the strain."""
    strain, rate = math.log(ratio), 2 - 2 * POISSON / (1 - POISSON)
    modulus = YOUNG / (1 - POISSON)
    return 100.0 * 2 * modulus * ((strain / rate - 1 / rate**2) * math.exp(rate * strain) + 1 / rate**2)


# Width 3, flanges of 0.5, depth 4, webs of 0.2: area, moments of inertia about s and t, torsion.
WALLS = "*SECTION_BEAM\n1,1,1.0,-7,0\n0,0\n*INTEGRATION_BEAM\n7,0,0.0,{shape}\n3.0,0.5,4.0,0.2\n"
WALLED = [
    (1, "an I", 3.6, (3 * 64 - 2.8 * 27) / 12, (2 * 0.5 * 27 + 3 * 0.2**3) / 12, (2 * 3 * 0.5**3 + 3.5 * 0.2**3) / 3),
    (5, "a box", 4.2, (3 * 64 - 2.6 * 27) / 12, (2 * 0.5 * 27 + 3 * (27 - 2.6**3)) / 12, 2 * (2.8 * 3.5) ** 2 / (2.8 / 0.5 + 3.5 / 0.2)),
]


def prove_walls(shape, name, area, about_s, about_t, torsion):
    section, fields = WALLS.format(shape=shape), "INTEGRATION_BEAM: ICST D1 D2 D3 D4"
    return [
        Proof(fields, beam(section, FLYING), [("momentum_x", FIRST, 100.0 * DENSITY * area * 10.0, 1e-9)], f"area of {name}"),
        Proof(fields, beam(section, ABOUT_Y, end=END), [(largest_moment, LAST, YOUNG * about_t * 2 * TURN / 10.0, 1e-2)], "y is t, along the depth"),
        Proof(fields, beam(section, ABOUT_Z, end=END), [(largest_moment, LAST, YOUNG * about_s * 2 * TURN / 10.0, 1e-2)], "z is s, along the width"),
        Proof(fields, beam(section, TWISTED, end=END), [(magnitude("element_1_torque"), LAST, SHEAR * torsion * 2 * TURN / 10.0, 1e-2)], "thin walls"),
    ]


def pulled_flow(flow):
    """Stress of a bar that is pulled by 1 % in END: flow(p, rate of p), by the strain ln(1.01) and its rate at the end."""
    rate, p = 0.01 / END / 1.01, 0.0
    for _ in range(200):
        p = math.log(1.01) - flow(p, rate) / YOUNG
    return flow(p, rate)


BAR = "*SECTION_BEAM\n1,3\n5.0\n"
BILINEAR = f"*MAT_PIECEWISE_LINEAR_PLASTICITY\n1,{DENSITY!r},{YOUNG!r},{POISSON!r},300.0,2000.0\n{{rates}}\n"
MODULUS = YOUNG * 2000.0 / (YOUNG - 2000.0)
CURVED = "*DEFINE_CURVE\n8\n0.0,300.0\n0.004,350.0\n0.02,430.0\n"
COOK = f"*MAT_SIMPLIFIED_JOHNSON_COOK\n1,{DENSITY!r},{YOUNG!r},{POISSON!r}\n300.0,200.0,0.4,0.02,1e17,0,0,1.0\n"


def curved(p, rate):
    return 300.0 + 50.0 * p / 0.004 if p < 0.004 else 350.0 + 80.0 * (p - 0.004) / 0.016


def yields(shape_of_i, plastic_modulus, motion):
    law = f"*MAT_PIECEWISE_LINEAR_PLASTICITY\n1,{DENSITY!r},{YOUNG!r},{POISSON!r},10.0,1.0\n0\n"
    return Proof("INTEGRATION_BEAM: ICST; MAT_PIECEWISE_LINEAR_PLASTICITY: SIGY; SECTION_BEAM: QR", beam(WALLS.format(shape=1), motion, law=law, end=END),
                 [(largest_moment, LAST, 10.0 * plastic_modulus, 1.5e-2)], f"the plastic moment of an I {shape_of_i}")  # fmt: skip


BEAM_LAWS = [
    Proof("MAT_PIECEWISE_LINEAR_PLASTICITY: SIGY ETAN; SECTION_BEAM: ELFORM A", beam(BAR, PULLED, law=BILINEAR.format(rates="0"), end=END),
          [(AXIAL, LAST, 5.0 * pulled_flow(lambda p, rate: 300.0 + MODULUS * p), 2e-3)], "beams of a bilinear law"),
    Proof("MAT_PIECEWISE_LINEAR_PLASTICITY: C P VP; SECTION_BEAM: ELFORM", beam(BAR, PULLED, law=BILINEAR.format(rates="40.0,5.0,0,0,1"), end=END),
          [(AXIAL, LAST, 5.0 * pulled_flow(lambda p, rate: (300.0 + MODULUS * p) * (1 + (rate / 40.0) ** 0.2)), 3e-3)], "with the factor of Cowper and Symonds"),
    Proof("MAT_PIECEWISE_LINEAR_PLASTICITY: LCSS; SECTION_BEAM: ELFORM", beam(BAR, PULLED, law=BILINEAR.format(rates="0,0,8"), end=END).replace("*END\n", CURVED + "*END\n"),
          [(AXIAL, LAST, 5.0 * pulled_flow(curved), 2e-3)], "of a curve"),
    Proof("MAT_SIMPLIFIED_JOHNSON_COOK: A B N C EPSO; SECTION_BEAM: ELFORM", beam(BAR, PULLED, law=COOK, end=END),
          [(AXIAL, LAST, 5.0 * pulled_flow(lambda p, rate: (300.0 + 200.0 * max(p, 0.0) ** 0.4) * (1 + 0.02 * math.log(rate))), 5e-3)], "of Johnson and Cook"),
    # With z_e = 10 / (E k) elastic about the axis: the web lacks 0.2 z_e^2 / 3; the flanges z_e^2 / 3, beside a web that stays elastic.
    yields("about its strong axis", (3 * 16 - 2.8 * 9) / 4 - 0.2 * (10 / YOUNG / 4e-4) ** 2 / 3, ABOUT_Z),
    yields("about its weak axis", 2.25 - (10 / YOUNG / 4e-4) ** 2 / 3 + 0.002 / (10 / YOUNG / 4e-4), ABOUT_Y),
]  # fmt: skip

SECTIONS = [
    Proof("SECTION_SHELL: SECID T1; PART: SECID", plate(shell_section(1, 1.5)), [("momentum_x", FIRST, 150.0 * PLATE_MASS, 1e-9)], "mass of the thickness"),
    Proof("SECTION_SHELL: T1 T2 T3 T4", plate("*SECTION_SHELL\n1,2\n1.0,2.0,3.0,4.0\n"), [("momentum_x", FIRST, 250.0 * PLATE_MASS, 1e-9)], "the mean of the corners"),
    Proof("SECTION_SHELL: T1 T2 T3 T4", triangle("*SECTION_SHELL\n1,2\n1.0,2.0,3.0,4.0\n"), [("momentum_x", FIRST, 200.0 * PLATE_MASS / 2, 1e-9)], "of the three corners"),
    Proof("SECTION_SHELL: MAREA", plate("*SECTION_SHELL\n1,16\n1.0,1.0,1.0,1.0,0,1e-8\n"), [("momentum_x", FIRST, 100.0 * (PLATE_MASS + 1e-6), 1e-9)], "mass per area"),
    Proof("SECTION_SHELL: MAREA", deck(square(), square(2, 11, (50.0, 0.0, 0.0)).replace(",1,11", ",1,11"), part(), "*SECTION_SHELL\n1,2\n1.0,1.0,1.0,3.0,0,1e-8\n", elastic(), velocity(100.0)),
          [("momentum_x", FIRST, 100.0 * (3.0 * PLATE_MASS + 2e-6), 1e-9)], "beside a thickness by corner"),
    Proof("SECTION_SHELL: NIP ICOMP ELFORM SHRF", stretched_shell(STEEL, 1.01).replace("1,2,1.0,2\n1.0,1.0,1.0,1.0", "1,16,0.8333,3,0,0,1\n1.0,1.0,1.0,1.0\n0.0,45.0,90.0"),
          [("element_1_stress_xx", LAST, YOUNG / (1 - POISSON) * math.log(1.01), 2e-3)], "angles of layers turn nothing; their lines are read"),
    Proof("SECTION_SHELL: ELFORM", plate("*SECTION_SHELL\n1,12\n1.0,1.0,1.0,1.0\n"), refused="formulation 12"),
    Proof("SECTION_SHELL_MISC", plate("*SECTION_SHELL_MISC\n1,2\n1.0,1.0,1.0,1.0\n2.0\n"), refused="MISC"),
    Proof("SECTION_BEAM: SECID ELFORM CST TS1 TT1", beam("*SECTION_BEAM\n1,1,1.0,2,0\n2.0,2.0,3.0,3.0\n", FLYING), [("momentum_x", FIRST, 100.0 * DENSITY * 60.0, 1e-9)], "a rectangle of 2 by 3"),
    Proof("SECTION_BEAM: CST TS1 TT1", beam("*SECTION_BEAM\n1,1,1.0,2,1\n4.0,4.0,2.0,2.0\n", FLYING), [("momentum_x", FIRST, 100.0 * DENSITY * 10.0 * math.pi * 3, 1e-9)], "a tube of diameters 4 and 2"),
    Proof("SECTION_BEAM: NSM", beam("*SECTION_BEAM\n1,1,1.0,2,0,0,1e-8\n2.0,2.0,3.0,3.0\n", FLYING), [("momentum_x", FIRST, 100.0 * (DENSITY * 60.0 + 1e-7), 1e-9)], "mass per length"),
    Proof("SECTION_BEAM: ELFORM A", beam("*SECTION_BEAM\n1,3\n5.0\n", PULLED, end=END), [(AXIAL, LAST, YOUNG * 5.0 * math.log(1.01), 1e-2)], "E A ln(1.01)"),
    Proof("SECTION_BEAM: A ITT; ELEMENT_BEAM: EID PID N1 N2 N3",
          beam("*SECTION_BEAM\n1,2\n5.0,7.0,11.0,13.0,4.0\n", ABOUT_Y, end=END), [(largest_moment, LAST, YOUNG * 11.0 * 2 * TURN / 10.0, 1e-2)],
          "s is along z, in the plane of N3: ends that turn about y, which is t, bend it with ITT"),
    Proof("SECTION_BEAM: ISS", beam("*SECTION_BEAM\n1,2\n5.0,7.0,11.0,13.0,4.0\n", ABOUT_Z, end=END),
          [(largest_moment, LAST, YOUNG * 7.0 * 2 * TURN / 10.0, 1e-2)], "about z, which is s"),
    Proof("SECTION_BEAM: J", beam("*SECTION_BEAM\n1,2\n5.0,7.0,11.0,13.0,4.0\n", TWISTED, end=END),
          [(magnitude("element_1_torque"), LAST, SHEAR * 13.0 * 2 * TURN / 10.0, 1e-2)], "G J times the twist"),
    *(row for shape, name, *values in WALLED for row in prove_walls(shape, name, *values)),
    Proof("INTEGRATION_BEAM: ICST D1 D2 D3 D4", beam(WALLS.format(shape=5).replace("0.2\n", "0.5\n"), FLYING), [("momentum_x", FIRST, 100.0 * DENSITY * 60.0, 1e-9)], "a box with walls of one thickness"),
    Proof("INTEGRATION_BEAM: D3", beam(WALLS.format(shape=1).replace("4.0,", "1.0,"), FLYING), refused="a depth above two of them"),
    *(Proof(word, beam("*SECTION_BEAM\n1,2\n2.0,3.0,3.0\n", FLYING).replace("*ELEMENT_BEAM\n1,1,1,2,3\n", f"*{word}\n1,1,1,2,3\n7,8\n{line}"),
            [("momentum_x", FIRST, 100.0 * 2.0 * 10.0 * DENSITY, 1e-6)], "PID1 and PID2 say what a spot weld holds")
      for word, line in (("ELEMENT_BEAM_PID", ""), ("ELEMENT_BEAM_PID_ORIENTATION", "0,0,1.0\n"))),
    Proof("ELEMENT_BEAM_ORIENTATION: VX VY VZ",
          beam("*SECTION_BEAM\n1,1,1.0,2,0\n2.0,2.0,3.0,3.0\n", FLYING).replace("*ELEMENT_BEAM\n1,1,1,2,3\n", "*ELEMENT_BEAM_ORIENTATION\n1,1,1,2\n0,0,1.0\n"),
          [("momentum_x", FIRST, 100.0 * DENSITY * 60.0, 1e-9)], "the vector in place of N3"),
]  # fmt: skip

FLAT = deck(hexahedron(size=(10.0, 10.0, 1.0)), part(), solid_section(), STEEL, node_set(1, 1, 2, 3, 4), node_set(2, 5, 6, 7, 8), "*BOUNDARY_SPC_SET\n1,0,1,1,1\n",
            "*BOUNDARY_SPC_SET\n2,0,1,1,0\n*BOUNDARY_PRESCRIBED_MOTION_SET\n2,3,2,7\n", curve(7, (0.0, 0.0), (END, -0.5)),
            "*CONTROL_BULK_VISCOSITY\n1e-9,1e-9\n*CONTROL_TIMESTEP\n0,0.5,0,0,0,0,1\n", end=END, rows=1000).replace(f"{END!r}\n*DATABASE", f"{END!r},0,0.9\n*DATABASE")  # fmt: skip

FLAT_FLUID = FLAT.replace(STEEL, f"*MAT_NULL\n1,{DENSITY!r}\n*EOS_LINEAR_POLYNOMIAL\n1,0.0,170000.0\n0.0,1.0\n").replace(part(), part(1, 1, 1, ",1"))

LOADED = node_set(9, *range(1, 9)) + "*LOAD_NODE_SET\n9,1,7,2.0\n9,3,7,3.0\n" + curve(7, (0.0, 1.0), (1.0, 1.0))

def weld_beam(limits, motion, time=0.0, yields="1e6,0", more=""):
    """A weld of 4 mm diameter and 10 mm length that is led until the end."""
    law = f"*MAT_SPOTWELD\n1,{DENSITY!r},{YOUNG!r},{POISSON!r},{yields},0,{time!r}\n{limits}\n{more}"
    return beam("*SECTION_BEAM\n1,9,1.0,2,1\n4.0,4.0,0,0\n", motion, law=law, end=END)


WELD_AREA, WELD_INERTIA = 4 * math.pi, 4 * math.pi
PULL_AT_HALF, MOMENT_AT_HALF = YOUNG * WELD_AREA * math.log(1.005), YOUNG * WELD_INERTIA * TURN / 10.0
TORQUE_AT_HALF, SHEAR_AT_HALF = SHEAR * 2 * WELD_INERTIA * TURN / 10.0, 0.9 * SHEAR * WELD_AREA * 0.0005
FIBRE = 2.0 * 0.8873  # of the outermost ring of points of a circle of radius 2
FLOW_AT_HALF, BENT_AT_HALF = (YOUNG * math.log(1.005) - 300.0) / (YOUNG + 2000.0), (YOUNG * FIBRE * TURN / 10.0 - 30.0) / (YOUNG + 2000.0)
AT_HALF = [(erosion_time, LAST, 0.5 * END, 3e-2)]
WELDS = [
    Proof("MAT_SPOTWELD: NRR", weld_beam(f"0,{PULL_AT_HALF!r}", PULLED), AT_HALF, "the tension E A ln(1.005) at half of the time"),
    Proof("MAT_SPOTWELD: NRR", weld_beam(f"0,{0.1 * PULL_AT_HALF!r}", PULLED.replace(f"{END!r},0.1", f"{END!r},-0.1")), [("eroded_elements", LAST, 0.0, 0.0)], "a compression does not count"),
    Proof("MAT_SPOTWELD: NRS NRT", weld_beam(f"0,0,{SHEAR_AT_HALF!r},{SHEAR_AT_HALF!r}", SHEARED.format(axis="2")), AT_HALF, "0.9 G A times the angle at half of the time"),
    Proof("MAT_SPOTWELD: MRR", weld_beam(f"0,0,0,0,{TORQUE_AT_HALF!r}", TWISTED), AT_HALF, "G J times the twist at half of the time"),
    *[Proof("MAT_SPOTWELD: MSS MTT", weld_beam(f"0,0,0,0,0,{MOMENT_AT_HALF!r},{MOMENT_AT_HALF!r}", motion), AT_HALF, "E I times the curvature at half of the time") for motion in (ABOUT_Y, ABOUT_Z)],
    Proof("MAT_SPOTWELD: NRS", weld_beam("0,0,1.0,2.0", PULLED), refused="differ between the axes"),
    Proof("MAT_SPOTWELD: MSS", weld_beam("0,0,0,0,0,1.0,2.0", PULLED), refused="differ between the axes"),
    Proof("MAT_SPOTWELD: TFAIL", weld_beam("0", PULLED, 0.5 * END), AT_HALF, "at TFAIL"),
    Proof("MAT_SPOTWELD: EFAIL SIGY EH", weld_beam(f"{FLOW_AT_HALF!r},", PULLED, yields="300.0,2000.0"), AT_HALF, "E (e - p) = SIGY + EH p in all points at half of the time"),
    Proof("MAT_SPOTWELD: EFAIL", weld_beam(f"{0.5 * BENT_AT_HALF!r},", ABOUT_Y, yields="30.0,2000.0"), [("eroded_elements", LAST, 0.0, 0.0)], "bent: points near the axis never yield"),
    Proof("MAT_ADD_EROSION: EFFEPS NUMFIP", weld_beam("0", ABOUT_Y, yields="30.0,2000.0", more=f"*MAT_ADD_EROSION\n1,0,0,0,{-BENT_AT_HALF!r}\n0\n"),
          [(erosion_time, LAST, 0.5 * END, 5e-2)], "the outermost points reach it at half of the time, and the first ends the beam"),
    Proof("MAT_ADD_EROSION: NUMFIP", weld_beam("0", ABOUT_Y, yields="30.0,2000.0", more="*MAT_ADD_EROSION\n1,0,0,0,-0.1,0,3\n0\n"), refused="NUMFIP"),
    Proof("MAT_ADD_EROSION: SIGP1", weld_beam("0", ABOUT_Y, more="*MAT_ADD_EROSION\n1\n0,100.0\n"), refused="beams that fail by stress"),
]  # fmt: skip

CONTROLS = [
    Proof("CONTROL_TERMINATION: ENDTIM", deck(cube(), velocity(100.0), end=3e-5), [("time", LAST, 3e-5, 1e-12)], "the end"),
    Proof("CONTROL_TERMINATION: ENDCYC", deck(cube(), velocity(100.0)).replace("1e-05\n*DATABASE", "1e-05,4\n*DATABASE"), [("step", LAST, 4.0, 0.0)], "four steps"),
    Proof("CONTROL_TIMESTEP: LCTM", deck(cube(), velocity(100.0), "*CONTROL_TIMESTEP\n0,0.9,0,0,0,7\n", curve(7, (0.0, 3e-7), (1.0, 2e-7))), [("dt", MAX, 2e-7, 1e-9)], "the least value of the curve"),
    Proof("CONTROL_TIMESTEP: DT2MS MS1ST TSSFAC", deck(cube(), velocity(100.0), "*CONTROL_TIMESTEP\n0,0.5,0,0,-9e-6,0,0,1\n", end=9e-5),
          [("dt", MAX, 0.5 * 9e-6, 1e-3)], "TSSFAC of the step that DT2MS asks for"),
    Proof("CONTROL_TIMESTEP: DT2MS; CONTROL_TERMINATION: ENDMAS",
          deck(cube(), velocity(100.0), "*CONTROL_TIMESTEP\n0,0.9,0,0,-9e-6\n").replace("1e-05\n*DATABASE", "1e-05,0,0,0,50.0\n*DATABASE"), refused="max_added"),
    Proof("CONTROL_TIMESTEP: ERODE; CONTROL_TERMINATION: DTMIN", FLAT, [(lambda h: 1 - 0.5 * erosion_time(h) / END, LAST, 0.9, 5e-2)],
          "the step of a flat element is in proportion to its height, and falls to 0.9 of the first one; the bound of percuss is 3 % below height over speed"),
    Proof("CONTROL_TIMESTEP: ERODE; CONTROL_TERMINATION: DTMIN; MAT_NULL: RO; EOS_LINEAR_POLYNOMIAL: C1", FLAT_FLUID, [(lambda h: 1 - 0.5 * erosion_time(h) / END, LAST, 0.9, 5e-2)],
          "of a fluid, whose speed of sound is the root of C1 over the density at all volumes, likewise"),
    *[Proof("CONTROL_TERMINATION: ENDENG", deck(cube(), velocity(0, 0, -1000.0), "*RIGIDWALL_PLANAR_ID\n1,wall\n0\n0,0,-0.001,0,0,1.0\n").replace("1e-05\n*DATABASE", f"1e-05,0,0,{percent}\n*DATABASE"),
            [("time", LAST, 1e-5, 1e-9)] if not words else [], "an impact balances to a percent, and not to 1e-14 of its energy", fails=words)
      for percent, words in (("1.0", ""), ("1e-12", "energy balance is off"))],
    Proof("CONTROL_TIMESTEP: EMSCL", deck(cube(), "*CONTROL_TIMESTEP\n0,0.5,0,0,-9e-6,0,0,1\n0,0,0,0,0,0,1.0\n*LOAD_BODY_Z\n7,1e6\n*DATABASE_HISTORY_NODE\n1\n", curve(7, (0.0, 1.0), (1.0, 1.0)), end=9e-5),
          [("node_1_z", LAST, -0.5 * 1e6 * 9e-5**2, 1e-2)], "gravity acts on all of the mass: free fall"),
    Proof("CONTROL_TIMESTEP: EMSCL", deck(cube(), "*CONTROL_TIMESTEP\n0,0.5,0,0,-9e-6,0,0,1\n0,0,0,0,0,0,0.5\n"), refused="EMSCL"),
    Proof("CONTROL_TIMESTEP: TSLIMT", deck(cube(), "*CONTROL_TIMESTEP\n0,0.9,0,1e-6\n"), refused="TSLIMT"),
    Proof("CONTROL_TIMESTEP: DT2MSF DT2MSLC IMSCL", deck(cube(), "*CONTROL_TIMESTEP\n0,0.9\n0.5\n"), refused="DT2MSF"),
    Proof("CONTROL_BULK_VISCOSITY: Q1 Q2", stretched(STEEL, 1 / UP, "*CONTROL_BULK_VISCOSITY\n0.0,0.3\n"),
          [("viscous", LAST, 0.3 * DENSITY * SPEED * 10.0 * (STRAIN / END) * 1000.0 * (1 - 1 / UP), 5e-2)], "work of the pressure Q2 rho c L rate"),
    Proof("CONTROL_SHELL: ISTUPD", stretched_shell(STEEL, 1.05, "*CONTROL_SHELL\n20.0,0,-1,1\n"), [("internal", LAST, thinning_energy(1.05), 5e-3)], "the thickness follows the strain"),
    Proof("CONTROL_SHELL: W_MODE STRETCH", stretched_shell(STEEL, 1.05, "*CONTROL_SHELL\n\n\n0,0,0,0,0,10.0\n"), refused="W_MODE"),
    Proof("CONTROL_SOLUTION: SOLN", deck(cube(), "*CONTROL_SOLUTION\n2\n"), refused="thermal"),
    Proof("CONTROL_SOLID: PM1", deck(cube(), "*CONTROL_SOLID\n\n2,1,3,4,5,6,7,8,9,10\n"), refused="order of the nodes"),
    Proof("CONTROL_SOLID: COHEQC", deck(cube(), "*CONTROL_SOLID\n\n\n1,1,12\n"), refused="COHEQC"),
    Proof("CONTROL_RIGID: GJADSTF GJADVSC TJADSTF TJADVSC", deck(cube(), "*CONTROL_RIGID\n\n0,1.0\n"), refused="GJADSTF"),
    Proof("CONTROL_FORMING_AUTOPOSITION_PARAMETER", deck(cube(), "*CONTROL_FORMING_AUTOPOSITION_PARAMETER\n1\n"), refused="parts stay where the deck has them"),
    Proof("CONTROL_STAGED_CONSTRUCTION", deck(cube(), "*CONTROL_STAGED_CONSTRUCTION\n1\n"), refused="all parts act"),
    Proof("CONTROL_ADAPTIVE", deck(cube(), velocity(30.0), "*CONTROL_ADAPTIVE\n1e-6,0.2,2,3\n"), [("momentum_x", ALL, 30.0 * CUBE_MASS, 1e-9)], "no part is adaptive"),
    Proof("CONTROL_ADAPTIVE; PART: ADPOPT", deck(cube().replace("part_1\n1,1,1", "part_1\n1,1,1,0,0,0,1"), "*CONTROL_ADAPTIVE\n1e-6,0.2,2,3\n"), refused="CONTROL_ADAPTIVE", messages=1),
    Proof("INITIAL_STRAIN_SOLID", deck(cube(), velocity(30.0), "*INITIAL_STRAIN_SOLID\n1\n0.1,0,0,0,0,0\n"), [("internal", ALL, 0.0, 1e-15), ("momentum_x", ALL, 30.0 * CUBE_MASS, 1e-9)], "strains of an earlier stage give no stress"),
    Proof("RIGIDWALL_FORCE_TRANSDUCER; DEFINE_FILTER", deck(cube(), velocity(30.0), "*RIGIDWALL_FORCE_TRANSDUCER\n1,2\n3\n*DEFINE_FILTER\n1,cfc\n180.0\n"), [("momentum_x", ALL, 30.0 * CUBE_MASS, 1e-9)], "output"),
    Proof("CONTROL_MAT", deck(cube(), "*CONTROL_MAT\n1\n"), refused="the failure of all materials acts"),
    Proof("CONTROL_START", deck(cube(), "*CONTROL_START\n1.0\n"), refused="time 0"),
]  # fmt: skip

OUTPUTS = [
    Proof("DATABASE_CROSS_SECTION_PLANE: PSID XCT YCT ZCT XCH YCH ZCH; DATABASE_SECFORC: DT",
          stretched(STEEL, 1.001, "*DATABASE_CROSS_SECTION_PLANE\n0,5.0,5.0,4.0,5.0,5.0,9.0\n\n*DATABASE_SECFORC\n1e-5\n"),
          [("fz:section_1", LAST, STIFF * 0.001 * 100.0, 1e-2)], "stress times area"),
    Proof("DATABASE_CROSS_SECTION_SET: NSID HSID",
          stretched(STEEL, 1.001, "*SET_SOLID\n7\n1\n*DATABASE_CROSS_SECTION_SET\n1,7\n"), [("fz:section_1", LAST, STIFF * 0.001 * 100.0, 1e-2)], "what the element gives to its lower nodes"),
    Proof("DATABASE_SPCFORC: DT", deck(cube(), node_set(1, *range(1, 9)), "*BOUNDARY_SPC_SET\n1,0,1,1,1\n*LOAD_NODE_SET\n1,3,7,2.0\n*DATABASE_SPCFORC\n1e-7\n", curve(7, (0.0, 1.0), (1.0, 1.0))),
          [("fz:supports", LAST, -16.0, 1e-9)], "what holds eight loads of 2 N"),
    Proof("DATABASE_RWFORC: DT", deck(cube(), velocity(0, 0, -1000.0), "*RIGIDWALL_PLANAR_ID\n1,wall\n0\n0,0,-0.001,0,0,1.0\n*DATABASE_RWFORC\n1e-7\n"), [(impulse_of("fz:force_wall"), LAST, 1.0, 1e-6)], "force and momentum"),
    Proof("DATABASE_HISTORY_NODE; DATABASE_NODOUT: DT", deck(cube(), velocity(100.0), "*DATABASE_HISTORY_NODE\n2\n*DATABASE_NODOUT\n1e-7\n"), [("node_2_x", LAST, 10.0 + 100.0 * 1e-5, 1e-9)], "v t"),
    Proof("DATABASE_HISTORY_NODE_LOCAL: ID", deck(cube(), velocity(100.0), "*DATABASE_HISTORY_NODE_LOCAL\n2,0,0,0\n"), [("node_2_x", LAST, 10.0 + 100.0 * 1e-5, 1e-9)], "v t, along global axes"),
    Proof("DATABASE_HISTORY_BEAM", beam("*SECTION_BEAM\n1,3\n5.0\n", PULLED, end=END), [("element_1_stress_xx", LAST, YOUNG * math.log(1.01), 1e-2)], "E ln(1.01)"),
    Proof("DATABASE_RBDOUT: DT", deck(cube("*MAT_RIGID\n1,7.8e-9,2.1e5,0.3\n0\n\n"), velocity(100.0), "*DATABASE_RBDOUT\n1e-7\n"), [("body_x:part_1", LAST, 5.0 + 100.0 * 1e-5, 1e-9)], "v t"),
    Proof("DATABASE_MATSUM: DT", deck(two_cubes(), "*INITIAL_VELOCITY_GENERATION\n2,2,0,0,0,100.0\n0\n*DATABASE_MATSUM\n1e-7\n"), [("momentum_z:part_2", ALL, 100.0 * CUBE_MASS, 1e-9)], "of one part"),
    Proof("DATABASE_BINARY_D3PLOT: DT", deck(cube(), velocity(100.0), "*DATABASE_BINARY_D3PLOT\n2e-6\n"), [("momentum_x", LAST, 100.0 * CUBE_MASS, 1e-9)], "frames change nothing"),
]  # fmt: skip

SPRINGS = [
    Proof("MAT_SPRING_ELASTIC: MID K; ELEMENT_DISCRETE: EID PID N1 N2 S; DATABASE_DEFORC: DT", spring("9,5,5,11,0,2.0", "*MAT_SPRING_ELASTIC\n5,30.0"), [(FORCE, LAST, 2 * 30.0 * 0.1, 1e-6)], "S K times 0.1"),
    Proof("MAT_DAMPER_VISCOUS: MID DC", spring("9,5,5,11", "*MAT_DAMPER_VISCOUS\n5,0.2"), [(FORCE, LAST, 0.2 * 0.1 / END, 1e-2)], "DC times the speed"),
    Proof("MAT_SPRING_NONLINEAR_ELASTIC: MID LCD", spring("9,5,5,11", "*MAT_SPRING_NONLINEAR_ELASTIC\n5,9", curve(9, (0.0, 0.0), (0.05, 4.0), (0.2, 10.0))), [(FORCE, LAST, 6.0, 1e-6)], "the curve at 0.1"),
    Proof("MAT_SPRING_NONLINEAR_ELASTIC: LCR", spring("9,5,5,11", "*MAT_SPRING_NONLINEAR_ELASTIC\n5,9,8", curve(9, (0.0, 0.0), (0.2, 10.0))), refused="LCR"),
    Proof("ELEMENT_DISCRETE: VID OFFSET", spring("9,5,5,11,3", "*MAT_SPRING_ELASTIC\n5,30.0"), refused="VID"),
    Proof("SECTION_DISCRETE: SECID", spring("9,5,5,11", "*MAT_SPRING_ELASTIC\n5,30.0"), [(FORCE, LAST, 30.0 * 0.1, 1e-6)], "K times 0.1"),
    Proof("SECTION_DISCRETE: DRO KD CL FD", spring("9,5,5,11", "*MAT_SPRING_ELASTIC\n5,30.0").replace("*SECTION_DISCRETE\n5\n", "*SECTION_DISCRETE\n5,1\n"), refused="torsional"),
    Proof("CONSTRAINED_SPOTWELD: N1 N2 SN", weld("5,11,70.0,1e20", 3), [(failure_time, LAST, 7e-5, 3e-2), ("weld_normal:weld_1", MAX, 70.0, 3e-2)], "the force reaches SN"),
    Proof("CONSTRAINED_SPOTWELD: SS", welded_sheets("1,11,1e20,70.0"), [(failure_time, LAST, 7e-5, 3e-2), ("weld_shear:weld_1", MAX, 70.0, 3e-2)], "the force across the line of the nodes reaches SS"),
    Proof("CONSTRAINED_SPOTWELD: N M", weld("5,11,70.0,1e20,1.0,1.0", 3), [(failure_time, LAST, 7e-5, 3e-2)], "alone, exponents change nothing"),
    Proof("CONSTRAINED_SPOTWELD: TF", flying_weld("SPOTWELD\n5,11,0,0,0,0,6e-5"), [(failure_time, LAST, 6e-5, 3e-2)], "it fails at TF"),
    Proof("CONSTRAINED_SPOTWELD: EP", weld("5,11,20.0,30.0,2,2,0,0.1", 3), refused="plastic strain"),
    Proof("CONSTRAINED_RIVET: N1 N2 TF", flying_weld("RIVET\n5,11,6e-5"), [(failure_time, LAST, 6e-5, 3e-2)], "it fails at TF"),
    Proof("CONSTRAINED_GENERALIZED_WELD_SPOT: NSID TFAIL SN SS N M", weld("9\n0,0,70.0,900.0,2.0,2.0", 3, node_set(9, 5, 11), keyword="GENERALIZED_WELD_SPOT"), [(failure_time, LAST, 7e-5, 3e-2)], "as of a spot weld"),
    Proof("CONSTRAINED_GENERALIZED_WELD_SPOT: CID FILTER EPSF", weld("9,3\n", 3, node_set(9, 5, 11), keyword="GENERALIZED_WELD_SPOT"), refused="axes of its own"),
]  # fmt: skip

FOLDED = ("*BOUNDARY_SPC_NODE\n1,0,1,1,1,1,1,1\n2,0,1,1,1,1,1,1\n4,0,1,1,1,1,1,1\n3,0,0,0,1,1,1,1\n*BOUNDARY_PRESCRIBED_MOTION_NODE\n3,1,2,7\n3,2,2,7\n"
          + curve(7, (0.0, 0.0), (END, -9.0)))  # fmt: skip
MORE = [
    *[Proof(f"CONTROL_SHELL: {name}", deck(shell(1.0, STEEL), FOLDED, f"*CONTROL_SHELL\n\n\n\n{line}\n", end=END), [("eroded_elements", LAST, 1.0, 0.0)],
            "a corner that moves behind the diagonal folds the shell") for name, line in (("NFAIL1", "1"), ("NFAIL4", "0,1"))],
    *[Proof(f"CONTROL_SHELL: {name}", deck(shell(1.0, STEEL), f"*CONTROL_SHELL\n{lines}\n"), refused=name)
      for name, lines in (("ROTASCL", "\n2.0"), ("DELFR", "\n\n\n0,0,0,0,1"), ("LISPSID", "\n\n\n\n0,7"), ("STRETCH", "\n\n0,0,0,0,0,0,2.0"))],
    *[Proof("CONTROL_SHELL: PSNFAIL", deck(shell(1.0, STEEL), square(2, 11, (50.0, 0.0, 0.0), of=2), part(2), "*SET_PART_LIST\n9\n", f"{set_part}\n", FOLDED, "*CONTROL_SHELL\n\n\n\n1,0,9\n", end=END),
            [("eroded_elements", LAST, count, 0.0)], "part 1 folds; the set has it or has it not") for set_part, count in ((1, 1.0), (2, 0.0))],
    Proof("CONTROL_SHELL: INTGRD", stretched_shell(STEEL, 1.05, "*CONTROL_SHELL\n20.0,0,-1,1\n0,1\n"), [("internal", LAST, thinning_energy(1.05), 5e-3)], "all rules have the same stress of a membrane"),
    Proof("CONTROL_SHELL: THEORY", deck(square(), part(), "*SECTION_SHELL\n1\n1.0\n", STEEL, "*CONTROL_SHELL\n20.0,0,-1,0,12\n"), refused="formulation 12"),
    Proof("CONTROL_SHELL: CNTCO; SECTION_SHELL: NLOC", deck(square(), part(), "*SECTION_SHELL\n1,2\n1.0,1.0,1.0,1.0,1.0\n", STEEL, "*CONTROL_SHELL\n\n\n0,0,1\n"), refused="CNTCO"),
    Proof("SECTION_SHELL: QR", plate("*SECTION_SHELL\n1,2,0,0,0,-7\n1.0\n"), refused="rule of integration"),
    Proof("SECTION_BEAM: TS2 TT2", beam("*SECTION_BEAM\n1,1,1.0,2,0\n2.0,2.5,3.0,3.0\n"), refused="differ between the ends"),
    Proof("SECTION_BEAM: QR", beam("*SECTION_BEAM\n1,2,1.0,-7,0\n2.0,2.0,3.0,3.0\n"), refused="rule of integration with formulation 2"),
    Proof("SECTION_BEAM: QR", beam("*SECTION_BEAM\n1,1,1.0,-7,0\n0,0\n"), refused="INTEGRATION_BEAM 7", messages=1),
    Proof("SECTION_BEAM: SHRF", beam("*SECTION_BEAM\n1,1,0.8333333333,2,0\n2.0,2.0,3.0,3.0\n", SHEARED.format(axis="2"), end=END),
          [(largest_shear, LAST, SHEAR * 6.0 * 5 / 6 * 0.001, 1e-2)], "of a rectangle it is 5/6"),
    Proof("SECTION_BEAM: SA SAT", beam("*SECTION_BEAM\n1,2\n5.0,7.0,11.0,13.0,4.0,0,0,2.0\n", SHEARED.format(axis="2"), end=END),
          [(largest_shear, LAST, SHEAR * 2.0 * 0.001, 1e-2)], "across the plane of N3: along t, with SAT"),
    Proof("SECTION_BEAM: SA", beam("*SECTION_BEAM\n1,2\n5.0,7.0,11.0,13.0,4.0,0,0,2.0\n", SHEARED.format(axis="3"), end=END),
          [(largest_shear, LAST, SHEAR * 4.0 * 0.001, 1e-2)], "along s, with SA"),
    Proof("DATABASE_CROSS_SECTION_PLANE: RADIUS XHEV YHEV ZHEV LENL LENM ID ITYPE",
          stretched(STEEL, 1.001, "*DATABASE_CROSS_SECTION_PLANE\n0,5.0,5.0,4.0,5.0,5.0,9.0,3.0\n\n"), [("fz:section_1", LAST, STIFF * 0.001 * 100.0, 1e-2)],
          "the element that the plane cuts has its middle within the limits, and counts whole"),
    Proof("DATABASE_CROSS_SECTION_SET: SSID TSID BSID DSID ID ITYPE",
          deck(shell(1.0, STEEL), node_set(1, 1, 2), "*SET_SHELL\n7\n1\n*DATABASE_CROSS_SECTION_SET\n1,0,0,7\n", "*BOUNDARY_SPC_NODE\n1,0,1,1,1\n2,0,1,1,1\n3,0,1,0,1\n4,0,1,0,1\n*BOUNDARY_PRESCRIBED_MOTION_NODE\n3,2,2,7\n4,2,2,7\n",
               curve(7, (0.0, 0.0), (END, 0.01)), end=END),
          [("fy:section_1", LAST, YOUNG / (1 - POISSON**2) * 0.001 * 10.0, 1e-2)], "plane strain of a sheet of 10 mm"),
    Proof("DATABASE_BINARY_D3PLOT: NPLTC", deck(cube(), velocity(100.0), "*DATABASE_BINARY_D3PLOT\n0,0,0,5\n"), [("momentum_x", LAST, 100.0 * CUBE_MASS, 1e-9)], "frames change nothing"),
    Proof("CONTROL_TERMINATION: NOSOL", deck(cube(), velocity(100.0)).replace("1e-05\n*DATABASE", "1e-05,0,0,0,0,1\n*DATABASE"), [("time", LAST, 1e-5, 1e-12)], "percuss run has its own word for it: percuss check"),
]  # fmt: skip

HELD_ENDS = node_set(1, *range(1, 9)) + "*BOUNDARY_SPC_SET\n1,0,1,1,1\n"
PRELOADED = deck(cube(STEEL), hexahedron(2, 11, (20.0, 0.0, 0.0), of=2), part(2), HELD_ENDS, node_set(2, *range(11, 19)), "*BOUNDARY_SPC_SET\n2,0,1,1,1\n*SET_PART_LIST\n9\n1\n",
                 "*DEFINE_VECTOR\n6,0,0,0,{vector}\n*DATABASE_CROSS_SECTION_PLANE_ID\n3,cut\n0,5.0,5.0,4.0,5.0,5.0,9.0\n\n*INITIAL_STRESS_SECTION\n1,3,7,9,6\n",
                 curve(7, (0.0, 0.0), (1e-6, 60.0), (1.0, 60.0)), FOLLOW.replace("1\n", "1,2\n", 1))  # fmt: skip
STARTS = [
    Proof("INITIAL_AXIAL_FORCE_BEAM: BSID LCID SCALE; SET_BEAM: SID",
          beam("*SECTION_BEAM\n1,3\n5.0\n", "*BOUNDARY_SPC_NODE\n1,0,1,1,1\n2,0,1,1,1\n*SET_BEAM\n7\n1\n*INITIAL_AXIAL_FORCE_BEAM\n7,7,2.0\n", curve(7, (0.0, 0.0), (1e-6, 40.0), (1.0, 40.0)), BEAM_OUT,
               nodes((31, 50.0, 0.0, 0.0), (32, 60.0, 0.0, 0.0), (33, 50.0, 0.0, 10.0)), "*ELEMENT_BEAM\n2,1,31,32,33\n"),
          [(AXIAL, FIRST, 80.0, 1e-3)], "SCALE times the curve"),
    Proof("INITIAL_STRESS_SECTION: ISSID CSID LCID",
          deck(cube(STEEL), HELD_ENDS, "*DATABASE_CROSS_SECTION_PLANE_ID\n3,cut\n0,5.0,5.0,4.0,5.0,5.0,9.0\n\n*INITIAL_STRESS_SECTION\n1,3,7\n", curve(7, (0.0, 0.0), (1e-6, 60.0), (1.0, 60.0)), FOLLOW),
          [("element_1_stress_zz", FIRST, 60.0, 1e-3)], "the stress of the section at time 0"),
    Proof("INITIAL_STRESS_SECTION: PSID VID", PRELOADED.format(vector="0,0,3.0"), [("element_1_stress_zz", FIRST, 60.0, 1e-3), ("element_2_stress_zz", FIRST, 0.0, 1e-9)],
          "of the part of the set alone, along the normal of the plane"),
    Proof("INITIAL_STRESS_SECTION: VID", PRELOADED.format(vector="0,3.0,3.0"), refused="VID"),
    Proof("ELEMENT_SEATBELT_ACCELEROMETER: IGRAV", deck(cube(), LOADED, "*LOAD_BODY_Z\n7,1e6\n*ELEMENT_SEATBELT_ACCELEROMETER\n7,1,5,4,1,1\n", end=1e-3),
          [("local_dvx:accelerometer_7", LAST, 24.0 * 1e-3 / CUBE_MASS, 2e-3)], "without the acceleration of gravity"),
    Proof("ELEMENT_SEATBELT_ACCELEROMETER: IGRAV", deck(cube(), LOADED, "*LOAD_BODY_Z\n7,1e6\n*ELEMENT_SEATBELT_ACCELEROMETER\n7,1,5,4,0,1\n", end=1e-3),
          [("local_dvx:accelerometer_7", LAST, (24.0 / CUBE_MASS - 1e6) * 1e-3, 2e-3)], "with it"),
    Proof("ELEMENT_SEATBELT_ACCELEROMETER: INTOPT",
          deck(cube("*MAT_RIGID\n1,7.8e-9,2.1e5,0.3\n0\n\n"), "*INITIAL_VELOCITY_GENERATION\n1,2,1000.0\n5.0,5.0,5.0,0,0,1.0\n*ELEMENT_SEATBELT_ACCELEROMETER\n7,1,2,4,0,1\n", end=1e-3, rows=1000),
          [("local_dvx:accelerometer_7", LAST, 1000.0**2 * 5.0 * 1e-3, 1e-2), ("local_dvy:accelerometer_7", LAST, 1000.0**2 * 5.0 * 1e-3, 1e-2)],
          "of a turning body the integral of the acceleration to its centre along the axes that turn with it"),
    Proof("ELEMENT_SEATBELT_ACCELEROMETER: MASS", deck(cube(), "*INITIAL_VELOCITY_NODE\n1,100.0\n*ELEMENT_SEATBELT_ACCELEROMETER\n7,1,5,4,0,1,6e-6\n"),
          [("momentum_x", FIRST, 100.0 * (CUBE_MASS / 8 + 2e-6), 1e-9)], "a third of it at each of the three nodes"),
    *(Proof(f"{name}: IDRFLG DRTOL",
          deck(cube(elastic(1, DENSITY, YOUNG, 0.0)), node_set(1, 1, 2, 3, 4), node_set(2, 5, 6, 7, 8), "*BOUNDARY_SPC_SET\n1,0,1,1,1\n*LOAD_NODE_SET\n2,3,7,50.0\n", curve(7, (0.0, 1.0), (1.0, 1.0), more=",2"),
               f"*{name}\n250,1e-6,0,0,0,0,0,1\n", FOLLOW),
          [("element_1_stress_zz", FIRST, 2.0, 1e-2), ("element_1_stress_zz", LAST, 2.0, 1e-2)], "four loads of 50 N on 100 mm2, at rest")
      for name in ("CONTROL_DYNAMIC_RELAXATION", "CONTROL_DAMPING")),
    Proof("ELEMENT_SEATBELT_ACCELEROMETER: SBACID NID1 NID2 NID3", deck(cube(), LOADED, "*ELEMENT_SEATBELT_ACCELEROMETER\n7,1,5,4,0,1\n", end=1e-3),
          [("local_dvx:accelerometer_7", LAST, 24.0 * 1e-3 / CUBE_MASS, 2e-3)], "x of its axes is z, along which the loads are 24 N"),
    Proof("MAT_RIGID: CMO CON1 CON2", deck(cube("*MAT_RIGID\n1,7.8e-9,2.1e5,0.3\n1,1,7\n\n"), LOADED),
          [("momentum_x", LAST, 0.0, 1e-12), ("momentum_z", LAST, 24.0 * 1e-5, 1e-3)], "held along x"),
    Proof("HOURGLASS: HGID Q1 Q2; PART: HGID", stretched(STEEL, 1 / UP, "*HOURGLASS\n5,4,0.1,0,1e-9,0.3\n").replace("*PART\npart_1\n1,1,1\n", "*PART\npart_1\n1,1,1,0,5\n"),
          [("viscous", LAST, 0.3 * DENSITY * SPEED * 10.0 * (STRAIN / END) * 1000.0 * (1 - 1 / UP), 5e-2)], "work of the pressure Q2 rho c L rate"),
    Proof("SECTION_SOLID: ELFORM", deck(cube().replace("*SECTION_SOLID\n1,1\n", "*SECTION_SOLID\n1,12\n")), refused="formulation 12"),
]  # fmt: skip

NOT_PHYSICS = {f"SECTION_{kind}": "sections of elements that are refused themselves"
               for kind in ("ALE1D", "ALE2D", "FPD", "POINT_SOURCE", "POINT_SOURCE_MIXTURE", "SEATBELT", "SPH")}  # fmt: skip

FLIES = deck(cube(), velocity(100.0))  # node 2 is at x = 10
BODY = deck(hexahedron() + part() + solid_section() + rigid(), velocity(0.0, -100.0))


def ended(card, scene=FLIES):
    return scene.replace("*END\n", card + "*CONTROL_TIMESTEP\n0,0.05\n*END\n")


LISTENED_TO = "*DEFINE_PLANE\n7,0,0,0,1,0,0\n0,1,0\n*DEFINE_REGION\n7,1\n*DEFINE_SD_ORIENTATION\n7,0,1,0,0\n*DEFINE_FRICTION\n7,0.5,0.5\n*DEFINE_STOCHASTIC_VARIATION\n7,1,1,0,0.1\n"
WRITTEN = "*INTERFACE_SPRINGBACK_LSDYNA\n1,7\n*INTERFACE_COMPONENT_NODE\n1\n*INTERFACE_COMPONENT_SEGMENT\n1\n*CONTROL_NONLOCAL\n7\n*CONTROL_CHECK_SHELL\n0,0,1,0,20.0\n"
SWITCH = "*SENSOR_DEFINE_NODE\n5,2,{second},{axis},0,{what}\n*SENSOR_SWITCH\n6,SENSOR,5,{logic},{value}\n*TERMINATION_SENSOR\n6\n"
TO_THE_END = [("time", LAST, 1e-5, 1e-9)]
ENDS = [
    Proof("CONTROL_CHECK_SHELL", ended(LISTENED_TO + WRITTEN), [("momentum_x", ALL, 100.0 * CUBE_MASS, 1e-9)], "output, storage and what nothing refers to"),
    Proof("CONTROL_CHECK_SHELL: IFAUTO", ended("*CONTROL_CHECK_SHELL\n0,1\n"), refused="IFAUTO"),
    Proof("DEFINE_FRICTION", ended(LISTENED_TO + "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n-2.0\n\n"), refused="friction by a table"),
    Proof("TERMINATION_NODE: NID STOP MAXC", ended("*TERMINATION_NODE\n2,1,10.00062\n"), [("time", LAST, 6.2e-6, 3e-2)], "x of the node reaches MAXC after 6.2 us"),
    Proof("TERMINATION_NODE: MINC", ended("*TERMINATION_NODE\n2,2,0,-0.00041\n", deck(cube(), velocity(0.0, -100.0))), [("time", LAST, 4.1e-6, 3e-2)], "y of the node reaches MINC"),
    Proof("TERMINATION_NODE: STOP", ended("*TERMINATION_NODE\n2,4\n"), TO_THE_END, "it goes on"),
    Proof("TERMINATION_NODE: MAXC MINC", ended("*TERMINATION_NODE\n2,1,10.00062,9.9\n"), [("time", LAST, 6.2e-6, 3e-2)], "the first event of two"),
    Proof("TERMINATION_BODY: PID STOP MINC", ended("*TERMINATION_BODY\n1,2,0,-0.00037\n", BODY), [("time", LAST, 3.7e-6, 3e-2)], "the displacement of the mass centre, which begins at y = 5"),
    Proof("TERMINATION_BODY: MAXC", ended("*TERMINATION_BODY\n1,2,0.00053\n", BODY.replace("-100.0", "100.0")), [("time", LAST, 5.3e-6, 3e-2)], "likewise"),
    Proof("TERMINATION_BODY: STOP", ended("*TERMINATION_BODY\n1,4,1e-6\n", BODY), TO_THE_END, "it goes on"),
    Proof("TERMINATION_BODY: PID", ended("*TERMINATION_BODY\n1,1,1e-6\n"), TO_THE_END, "the part is not rigid: it goes on"),
    Proof("TERMINATION_SENSOR: SWID", ended("*SENSOR_SWITCH\n6,TIME,0,GT,7.3e-6\n*TERMINATION_SENSOR\n6\n"), [("time", LAST, 7.3e-6, 3e-2)], "a switch of the time"),
    Proof("TERMINATION_SENSOR: SWID; SENSOR_DEFINE_NODE: SENSID NODE1 VID CTYPE; SENSOR_SWITCH: SWITID TYPE SENSID LOGIC VALUE",
          ended(SWITCH.format(second=0, axis="X", what="COORD", logic="GT", value=10.00044)), [("time", LAST, 4.4e-6, 3e-2)], "a place of a node"),
    Proof("SENSOR_SWITCH: LOGIC", ended(SWITCH.format(second=0, axis="Y", what="COORD", logic="LT", value=-0.00024), deck(cube(), velocity(0.0, -100.0))), [("time", LAST, 2.4e-6, 3e-2)], "below a value"),
    Proof("SENSOR_DEFINE_NODE: CTYPE", ended(SWITCH.format(second=0, axis="X", what="ACC", logic="GT", value=7.0)), TO_THE_END, "it goes on"),
    *(Proof(f"TERMINATION_{word}", ended(f"*TERMINATION_{word}\n1,1\n"), TO_THE_END, "it goes on")
      for word in ("CONTACT", "CURVE", "DELETED_SHELLS", "DELETED_SHELLS_SET", "DELETED_SOLIDS", "DELETED_SOLIDS_SET")),
    Proof("SENSOR_DEFINE_NODE: NODE2", ended(SWITCH.format(second=3, axis="", what="COORD", logic="LT", value=9.99), deck(cube(), "*INITIAL_VELOCITY_NODE\n2,0,20000.0\n6,0,20000.0\n3,0,-20000.0\n7,0,-20000.0\n", rows=1000)).replace("0,0.05", "0,0.005"),
          [("time", LAST, 2.5e-7, 5e-2)], "the distance of two nodes that approach with 40 m/s"),
    Proof("SENSOR_SWITCH: TIMWIN", ended("*SENSOR_SWITCH\n6,TIME,0,GT,7.3e-6,0,1e-6\n*TERMINATION_SENSOR\n6\n"), refused="TIMWIN"),
]
PROOFS = STARTS + MORE + BEAM_LAWS + SECTIONS + WELDS + CONTROLS + OUTPUTS + SPRINGS + ENDS
