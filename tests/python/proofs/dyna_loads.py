"""Gravity, forces on nodes, pressures."""

import math

from . import ALL, LAST, Proof, pieces
from .pieces import CUBE_MASS, cube, curve, node_set, nodes, part, rigid, shell, square, two_cubes

END = 1e-3
CONSTANT = curve(7, (0, 1.0), (1, 1.0))


def deck(*cards: str) -> str:
    """Long enough that half a step is nothing: the momentum is that of half a step before."""
    return pieces.deck(*cards, end=END)


SYSTEM = "*DEFINE_COORDINATE_VECTOR\n5,3.0,4.0,0.0,-4.0,3.0,0.0\n"  # x along (0.6, 0.8, 0)
RELAXED = "*CONTROL_DYNAMIC_RELAXATION\n0,0,0,0,0,0,0,1\n"


def momentum(axis: str, value: float) -> list:
    return [(f"momentum_{axis}", LAST, value, 2e-3)]


def blast(charge: str, segments: str, end: float, *, card: str = "_ENHANCED") -> str:
    return pieces.deck(cube(), f"*LOAD_BLAST{card}\n{charge}\n", segments, end=end)


FACE = "1,5,8,4"  # at x = 0, towards the charge
NEAR, FAR = "1,1e-3,-1000.0,5.0,5.0", "1,1e-3,-3000.0,5.0,5.0"  # 1 kg at 1 m and at 3 m
SEGMENT = f"*LOAD_BLAST_SEGMENT\n1,{FACE}\n"
# Kingery and Bulmash, by their polynomials of 1984, of 1 kg on the ground: reflected impulse at 1 m and 3 m, peak and duration at 3 m, in MPa and s.
IMPULSE_1, IMPULSE_3, PEAK_3, DURATION_3 = 884.8e-6, 224.3e-6, 330.7e-3, 2.830e-3
AIR_IMPULSE_1 = 559.03e-6  # likewise in free air


def whole_pulse(peak: float, duration: float, impulse: float) -> float:
    """Impulse of the positive and the negative phase of Friedlander's pulse, whose decay b gives that of the positive one."""
    low, high = 0.1, 100.0
    for _ in range(80):
        b = (low + high) / 2
        low, high = (b, high) if (1 / b - (1 - math.exp(-b)) / b**2) * peak * duration > impulse else (low, b)
    return peak * duration * (1 / b - 1 / b**2)


BLASTS = [
    Proof("LOAD_BLAST_ENHANCED: BID M XBO YBO ZBO UNIT BLAST NEGPHS; LOAD_BLAST_SEGMENT: BID N1 N2 N3 N4",
          blast(NEAR + ",0,7,1\n0,0,0,0,0,0,1", SEGMENT, 2.5e-3), [("momentum_x", LAST, 100.0 * IMPULSE_1, 1.2e-2)], "the impulse of the positive phase on the face"),
    Proof("LOAD_BLAST_ENHANCED: NEGPHS", blast(FAR + ",0,7,1", SEGMENT, 3e-2),
          [("momentum_x", LAST, 100.0 * whole_pulse(PEAK_3, DURATION_3, IMPULSE_3), 2.5e-2)], "0: the pulse goes on with suction"),
    Proof("LOAD_BLAST_ENHANCED: TBO; LOAD_BLAST_SEGMENT_SET: BID SSID", blast(NEAR + ",3e-3,7,1\n0,0,0,0,0,0,1", f"*LOAD_BLAST_SEGMENT_SET\n1,4\n*SET_SEGMENT\n4\n{FACE}\n", 3.4e-3),
          [("momentum_x", LAST, 0.0, 1e-12)], "it arrives at TBO + 0.4675 ms"),
    Proof("LOAD_BLAST: WGT XBO YBO ZBO TBO IUNIT ISURF; LOAD_SEGMENT: LCID", blast("1e-3,-1000.0,5.0,5.0,0,7,1", f"*LOAD_SEGMENT\n-2,1.0,0,{FACE}\n", 2.5e-3, card=""),
          [("momentum_x", LAST, 100.0 * IMPULSE_1, 1.2e-2)], "on the segments of LCID = -2"),
    Proof("LOAD_BLAST: ISURF", blast("1e-3,-1000.0,5.0,5.0,0,7", f"*LOAD_SEGMENT\n-2,1.0,0,{FACE}\n", 2.5e-3, card=""),
          [("momentum_x", LAST, 100.0 * AIR_IMPULSE_1, 1e-2)], "by default a sphere in free air"),
    Proof("LOAD_BLAST: ISURF", blast("1e-3,-1000.0,5.0,5.0,0,7,3", f"*LOAD_SEGMENT\n-2,1.0,0,{FACE}\n", 2.5e-3, card=""), refused="ISURF"),
    *(Proof("LOAD_BLAST_ENHANCED: BLAST", blast(NEAR + kind + "\n0,0,0,0,0,0,1", SEGMENT, 2.5e-3), [("momentum_x", LAST, 100.0 * AIR_IMPULSE_1, 1e-2)], "2, and by default: a sphere in free air")
      for kind in (",0,7,2", ",0,7")),
    Proof("LOAD_BLAST: IUNIT", blast("1e-3,-1000.0,5.0,5.0,0,1,1", SEGMENT, 1e-3, card=""), refused="English"),
    *(Proof("LOAD_BLAST_ENHANCED: BLAST", blast(f"{NEAR},0,7,{kind}", SEGMENT, 1e-3), refused="whose charge moves, or whose wave the ground reflects") for kind in (3, 4)),
    Proof("LOAD_BLAST_ENHANCED: UNIT", blast(NEAR + ",0,3,1", SEGMENT, 1e-3), refused="English"),
    Proof("LOAD_BLAST_ENHANCED: NIDBO DEATH", blast(NEAR + ",0,7,1\n0,0,0,0,9", SEGMENT, 1e-3), refused="NIDBO"),
    Proof("LOAD_BLAST_ENHANCED: DEATH", blast(NEAR + ",0,7,1\n0,0,0,0,0,5e-4", SEGMENT, 1e-3), refused="DEATH"),
    Proof("LOAD_BLAST_SEGMENT: ALEPID SFNRB", blast(NEAR + ",0,7,1", f"*LOAD_BLAST_SEGMENT\n1,{FACE},3\n", 1e-3), refused="ALEPID"),
    Proof("LOAD_BLAST_SEGMENT: SCALEP", blast(NEAR + ",0,7,1", f"*LOAD_BLAST_SEGMENT\n1,{FACE},0,0,0.5\n", 1e-3), refused="scaled"),
    Proof("LOAD_BLAST_SEGMENT_SET: ALEPID SFNRB SCALEP", blast(NEAR + ",0,7,1", f"*LOAD_BLAST_SEGMENT_SET\n1,4,0,0,0.5\n*SET_SEGMENT\n4\n{FACE}\n", 1e-3), refused="scaled"),
    Proof("LOAD_BLAST_SEGMENT: N1 N2 N3 N4", blast(NEAR + ",0,7,1", "*LOAD_BLAST_SEGMENT\n1,4,8,5,1\n", 1e-3), refused="into their solid"),
]  # fmt: skip

PROOFS = BLASTS + [
    *(Proof(f"LOAD_SHELL_{form}: ID LCID SF; MAT_NULL", deck(cube(), f"*ELEMENT_SHELL\n1,2,{corners}\n", part(2, 2, 2), pieces.shell_section(2, 0.1), "*MAT_NULL\n2,1e-12\n", load, CONSTANT),
            momentum("z", sign * 200.0 * END), "a pressure on a skin presses on the solid under it, against the normal of the nodes")
      for form, load in (("ELEMENT", "*LOAD_SHELL_ELEMENT\n1,7,2.0\n"), ("SET", "*SET_SHELL_LIST\n6\n1\n*LOAD_SHELL_SET\n6,7,2.0\n")) for corners, sign in (("5,6,7,8", -1), ("8,7,6,5", 1))),
    Proof("LOAD_BODY_Z: LCID SF", deck(cube(), "*LOAD_BODY_Z\n7,9810.0\n", CONSTANT), momentum("z", -9810.0 * END * CUBE_MASS), "the base accelerates upward"),
    Proof("LOAD_BODY_X: LCID SF", deck(cube(), "*LOAD_BODY_X\n7,-500.0\n", CONSTANT), momentum("x", 500.0 * END * CUBE_MASS), "the opposite"),
    Proof("LOAD_BODY_X: LCID SF; LOAD_BODY_Z: LCID SF", deck(cube(rigid()), "*LOAD_BODY_X\n7,-500.0\n*LOAD_BODY_Z\n7,9810.0\n", CONSTANT),
          [("body_vx:part_1", LAST, 500.0 * END, 1e-2), ("body_vz:part_1", LAST, -9810.0 * END, 1e-2)], "a rigid body falls off the axes: its balance of moments is no round-off"),
    Proof("LOAD_BODY_Z", deck(cube(), "*LOAD_BODY_Z\n7,1.0\n7,2.0\n", CONSTANT), refused="LOAD_BODY_Z.lines", messages=1),
    Proof("LOAD_BODY_Y: CID", deck(cube(), SYSTEM, "*LOAD_BODY_Y\n7,1000.0,0,0,0,0,5\n", CONSTANT),
          momentum("x", 800.0 * END * CUBE_MASS) + momentum("y", -600.0 * END * CUBE_MASS), "y of the system is (-0.8, 0.6)"),
    Proof("LOAD_BODY_Z: LCIDDR", deck(cube(), "*LOAD_BODY_Z\n7,9810.0,8\n", CONSTANT, curve(8, (0, 1.0), (1, 1.0)), RELAXED), refused="LCIDDR"),
    Proof("LOAD_BODY_RX", deck(cube(), "*LOAD_BODY_RX\n7,1.0\n", CONSTANT), refused="LOAD_BODY_RX"),
    Proof("LOAD_BODY_PARTS", deck(cube(), "*LOAD_BODY_PARTS\n4\n*SET_PART_LIST\n4\n1\n"), refused="LOAD_BODY_PARTS"),
    Proof("LOAD_GRAVITY_PART: ID DOF LC ACCEL", deck(two_cubes(), "*LOAD_GRAVITY_PART\n1,3,7,500.0\n2,3,7,500.0\n", curve(7, (0, 2.0), (1, 2.0))),
          momentum("z", -1000.0 * END * 2 * CUBE_MASS), "the same gravity of all parts"),
    Proof("LOAD_GRAVITY_PART_SET: ID DOF ACCEL", deck(two_cubes(), "*LOAD_GRAVITY_PART_SET\n4,2,0,700.0\n*SET_PART_LIST\n4\n1,2\n"),
          momentum("y", -700.0 * END * 2 * CUBE_MASS), "without a curve: constant"),
    Proof("LOAD_GRAVITY_PART", deck(two_cubes(), "*LOAD_GRAVITY_PART\n1,3,7,500.0\n", CONSTANT), refused="part 2 has none"),
    Proof("LOAD_GRAVITY_PART", deck(cube(), "*LOAD_GRAVITY_PART\n1,3,7,500.0,0,2\n", CONSTANT), refused="STGA"),
    Proof("LOAD_NODE_SET: NSID DOF LCID SF; LOAD_NODE_SET: ID", deck(cube(), node_set(4, 5, 6, 7, 8), "*LOAD_NODE_SET\n4,3,7,2.0\n", CONSTANT), momentum("z", 8.0 * END), "the whole load on each node"),
    Proof("LOAD_NODE_POINT: ID DOF LCID SF", deck(cube(), "*LOAD_NODE_POINT\n3,2,7,2.0\n", CONSTANT), momentum("y", 2.0 * END), "one node"),
    Proof("LOAD_NODE_SET: CID", deck(cube(), SYSTEM, node_set(4, 5, 6, 7, 8), "*LOAD_NODE_SET\n4,1,7,5.0,5\n", CONSTANT), momentum("x", 12.0 * END) + momentum("y", 16.0 * END), "along (0.6, 0.8)"),
    Proof("LOAD_NODE_SET: DOF", deck(shell(), node_set(4, 1, 2, 3, 4), "*LOAD_NODE_SET\n4,6,7,2.0\n", CONSTANT), [("angular_y", LAST, 8.0 * END, 5e-3)], "a moment on each node of a shell"),
    Proof("LOAD_NODE_SET", deck(cube(), node_set(4, 5, 6, 7), "*LOAD_NODE_SET\n4,4,7,2.0,0,1,2,3\n", CONSTANT), refused="follower"),
    Proof("LOAD_NODE_SET", deck(cube(), nodes((50, 1.0, 2.0, 3.0)), node_set(4, 5, 50), "*LOAD_NODE_SET\n4,3,7,2.0\n", CONSTANT), refused="node 50, which has no element"),
    Proof("LOAD_SEGMENT: LCID SF N1 N2 N3 N4", deck(cube(), "*LOAD_SEGMENT\n7,2.0,0,5,6,7,8\n", CONSTANT), momentum("z", -200.0 * END), "against the normal +z"),
    Proof("LOAD_SEGMENT: N1 N2 N3 N4", deck(cube(), "*LOAD_SEGMENT\n7,2.0,0,8,7,6,5\n", CONSTANT), momentum("z", 200.0 * END), "against the normal -z, which points into the solid"),
    Proof("LOAD_SEGMENT: AT", deck(cube(), "*LOAD_SEGMENT\n7,2.0,4e-4,5,6,7,8\n", CONSTANT), momentum("z", -200.0 * 6e-4), "from AT on"),
    Proof("LOAD_SEGMENT: N5", deck(cube(), "*LOAD_SEGMENT\n7,2.0,0,5,6,7,8,9\n0,0,0\n", CONSTANT), refused="N5"),
    Proof("LOAD_SEGMENT", deck(two_cubes(), "*LOAD_SEGMENT\n7,2.0,0,5,6,17,18\n", CONSTANT), refused="LOAD_SEGMENT.free"),
    Proof("LOAD_SEGMENT_SET: ID LCID SF AT; SET_SEGMENT: SID", deck(cube(), "*SET_SEGMENT\n4\n2,3,7,6\n", "*LOAD_SEGMENT_SET\n4,7,3.0,5e-4\n", CONSTANT),
          momentum("x", -300.0 * 5e-4), "against +x"),
    Proof("LOAD_SHELL_ELEMENT: ID LCID SF AT", deck(shell(), "*LOAD_SHELL_ELEMENT\n1,7,2.0,5e-4\n", CONSTANT), momentum("z", -200.0 * 5e-4), "against its normal +z"),
    Proof("LOAD_SHELL_SET: ID LCID SF AT; SET_SHELL_LIST: SID",
          deck(shell(), square(2, 11, (20.0, 0.0, 0.0), of=2), part(2), "*SET_SHELL_LIST\n4\n2\n*LOAD_SHELL_SET\n4,7,2.0\n", CONSTANT, "*DATABASE_MATSUM\n1e-5\n"),
          [("momentum_z:part_2", LAST, -200.0 * END, 2e-3), ("momentum_z:part_1", ALL, 0.0, 1e-12)], "of the set alone"),
    Proof("LOAD_SHELL_SET", deck(shell(), "*SET_SHELL_LIST\n4\n1,9\n*LOAD_SHELL_SET\n4,7,2.0\n", CONSTANT), refused="shell 9"),
]  # fmt: skip

