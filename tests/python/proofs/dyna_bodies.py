"""Rigid bodies: their masses, the nodes that belong to them, loads, supports, motions and joints."""

import math

from . import ALL, FIRST, LAST, MAX, MIN, Proof
from .pieces import CUBE_MASS, cube, curve, deck, elastic, hexahedron, node_set, nodes, part, rigid, solid_section, two_cubes, velocity

END = 1e-5
CONSTANT = curve(7, (0, 1.0), (1, 1.0))
OUT = nodes((50, 5.0, 5.0, 25.0))  # above the cube, whose centre is at (5, 5, 5)
NODAL_BODY = OUT + "*SET_NODE_LIST\n4\n1,2,3,4,5,6,7,8\n50\n*CONSTRAINED_NODAL_RIGID_BODY\n77,0,4\n"
EXTRA = OUT + "*CONSTRAINED_EXTRA_NODES_NODE\n1,50\n"
PUSH = "*LOAD_RIGID_BODY\n{id},{dof},7,3.0\n" + CONSTANT
TWO_RIGID = two_cubes(1.0).replace("*MAT_ELASTIC", "*MAT_RIGID").replace("0.3\n", "0.3\n0\n\n")
JOINED = "*CONSTRAINED_EXTRA_NODES_NODE\n1,90\n2,91\n1,92\n2,93\n" + nodes((90, 5.0, 5.0, 10.5), (91, 5.0, 5.0, 10.5), (92, 5.0, 5.0, 12.5), (93, 5.0, 5.0, 12.5))
JOINED_OFF = JOINED + "*CONSTRAINED_EXTRA_NODES_NODE\n1,94\n2,95\n" + nodes((94, 6.0, 5.0, 10.5), (95, 6.0, 5.0, 10.5))
APART = "*CONSTRAINED_EXTRA_NODES_NODE\n2,96\n2,97\n" + nodes((96, 5.0, 5.0, 14.5), (97, 5.0, 5.0, 17.0))
SPIN = CUBE_MASS * 100.0 / 6  # of a cube about its axis
THREAD = 3.0 / (2 * (1 + 2.0**2 * CUBE_MASS / SPIN))  # force of a screw of 2 mm per radian between two cubes, of which 3 N push one
TWIST = "*LOAD_NODE_POINT\n12,{dof},7,2.0\n" + CONSTANT
INERTIA = "5,5,5,2e-5,{ircs},0\n1e-3,0,0,2e-3,0,2.5e-3\n10,20,30,0,0,0\n"
HEAVY = hexahedron() + "*PART_INERTIA\npart_1\n1,1,1\n" + INERTIA.format(ircs=0) + solid_section() + rigid()
PRODUCTS = INERTIA.format(ircs=0).replace("1e-3,0,0,2e-3,0,2.5e-3\n10,20,30,0,0,0", "2e-3,2e-4,3e-4,2.2e-3,4e-4,2.5e-3\n4,0,0,{spin}")
SKEW = {"PART_INERTIA": hexahedron() + "*PART_INERTIA\npart_1\n1,1,1\n" + PRODUCTS + solid_section() + rigid(),
        "CONSTRAINED_NODAL_RIGID_BODY_INERTIA": cube() + NODAL_BODY.replace("_BODY", "_BODY_INERTIA") + PRODUCTS}  # fmt: skip
SOFT = hexahedron(2, 11, (0.0, 0.0, 11.0), of=2) + part(2, 1, 3) + elastic(3)  # a second cube
TURNING = HEAVY.replace("10,20,30,0,0,0", "0,0,0,0,0,0") + "*LOAD_RIGID_BODY\n1,{dof},7,2.0\n" + CONSTANT


def joint(kind, ids, *more):
    """Two rigid cubes of part 1 and 2, the second 1 mm above the first, with a joint between them on the line x = y = 5."""
    return deck(TWO_RIGID, JOINED_OFF, f"*CONSTRAINED_JOINT_{kind}\n{ids}\n", *more)



def held_screw(off: float, moved: str = "") -> str:
    """A screw of PARM 2 in a nut that is held, with a mass centre off its axis; 3 N push it along, or it is moved otherwise."""
    corners = nodes(*((id, 5.0 + off + side, 5.0, z) for id, side, z in ((90, 0, 10.5), (91, 0, 10.5), (92, 0, 12.5), (93, 0, 12.5), (94, 3, 10.5), (95, 3, 10.5))))
    return deck(cube(rigid(1, 1, 7, 7)), hexahedron(2, 11, (0.0, 0.0, 11.0), of=2), part(2, 1, 2), rigid(2, 1, 4, 4), corners, node_set(7, 90, 92, 94), node_set(8, 91, 93, 95),
                "*CONSTRAINED_EXTRA_NODES_SET\n1,7\n2,8\n*CONSTRAINED_JOINT_SCREW\n90,91,92,93,94,95\n2.0\n", moved or PUSH.format(id=2, dof=3), end=END)


STIFF = "CONSTRAINED_JOINT_STIFFNESS_GENERALIZED"
# y, z and x as axes of a system; and those of space turned by -0.25 about y.
SYSTEMS = f"*DEFINE_COORDINATE_VECTOR\n3,0.0,1.0,0.0,0.0,0.0,1.0\n4,{math.cos(0.25)!r},0.0,{math.sin(0.25)!r},0.0,1.0,0.0\n"
TURN_SPEED, TURN_END, TURN_STIFF, TURN_DAMP, HOLD, SLIPS = 100.0, 1e-3, 20.0, 0.065, 1e4, 5.0


def turned(curves="0", holds="0", stops="0", axis=0, speed=TURN_SPEED, bodies="1,2", systems="0,0"):
    """A held cube, part 1, and a free one that turns about its centre."""
    parts = TWO_RIGID.replace("part_1\n1,1,1", "part_1\n1,1,2") + rigid(2, 1, 7, 7)
    spin = ",".join(repr(speed if k == axis else 0.0) for k in range(3))
    laws = curve(7, (-1.0, -TURN_STIFF), (1.0, TURN_STIFF)) + curve(8, (-1.0, -TURN_DAMP), (1.0, TURN_DAMP)) + curve(9, (-1.0, SLIPS), (1.0, SLIPS))
    return deck(parts, f"*INITIAL_VELOCITY_RIGID_BODY\n2,0.0,0.0,0.0,{spin}\n", SYSTEMS, f"*{STIFF}\n5,{bodies},{systems}\n{curves}\n{holds}\n{stops}\n", laws, end=TURN_END)


def place(axis: int, text: str, stride: int = 1) -> str:
    """A line with a field of an angle, whose fields stand so far apart."""
    return "0," * (axis * stride) + text


def angle(axis: int, when, value: float, tolerance: float):
    return [(f"turn_angle_{'xyz'[axis]}:turn_spring_5", when, value, tolerance)]


TURN_RATE = math.sqrt(TURN_STIFF / SPIN)
SPRUNG = TURN_SPEED / TURN_RATE * math.sin(TURN_RATE * TURN_END)
DAMPED = TURN_SPEED * SPIN / TURN_DAMP * (1 - math.exp(-TURN_DAMP * TURN_END / SPIN))
BEYOND = TURN_SPEED * math.sqrt(SPIN / HOLD)  # way into a stop
SLIPPED = TURN_SPEED * TURN_END - 0.5 * SLIPS / SPIN * TURN_END**2
ENDS = ("PH", "T", "PS")
STIFFNESSES = [
    *(row for k, name in enumerate(ENDS) for row in (
        Proof(f"{STIFF}: PIDA PIDB LCID{name}", turned(place(k, "7"), axis=k), angle(k, LAST, SPRUNG, 1e-3), "a torsion pendulum"),
        Proof(f"{STIFF}: DLCID{name}", turned(place(k + 3, "8"), axis=k), angle(k, LAST, DAMPED, 1e-3), "decay by a damper"),
        Proof(f"{STIFF}: ES{name} FM{name}", turned("0", place(k, f"{HOLD},{SLIPS}", 2), axis=k), angle(k, LAST, SLIPPED, 5e-3), "friction slows it down"),
        Proof(f"{STIFF}: FM{name}", turned("0", place(k, f"{HOLD},-9", 2), axis=k), angle(k, LAST, SLIPPED, 5e-3), "friction by a curve over the angle"),
        Proof(f"{STIFF}: PSA{name} ES{name}", turned("0", place(k, str(HOLD), 2), place(k, "3.0,2.0", 2), axis=k), angle(k, MAX, math.radians(2.0) + BEYOND, 1e-3), "the stop is a spring"),
        Proof(f"{STIFF}: NSA{name} ES{name}", turned("0", place(k, str(HOLD), 2), place(k, "3.0,2.0", 2), axis=k, speed=-TURN_SPEED), angle(k, MIN, -math.radians(3.0) - BEYOND, 1e-3), "likewise below"),
        Proof(f"{STIFF}: ES{name}", turned(place(k, "7"), place(k, f"0,{SLIPS}", 2), place(k, "3.0,2.0", 2), axis=k), angle(k, LAST, SPRUNG, 1e-3), "without a stiffness neither acts"),
    )),
    Proof(f"{STIFF}: JSID PIDA PIDB", turned("7", bodies="2,1"), angle(0, LAST, -SPRUNG, 1e-3), "of A against B"),
    Proof(f"{STIFF}: CIDA", turned("7", axis=1, systems="3,0"), angle(0, LAST, SPRUNG, 1e-3), "phi is about y, x of the system of both bodies"),
    Proof(f"{STIFF}: CIDB", turned("0,7", axis=1, speed=0.0, systems="0,4"), angle(1, FIRST, -0.25, 1e-9), "the angle between both systems at the start"),
    Proof(f"{STIFF}: CIDA", turned("7", systems="6,0"), refused="axes of system 6"),
    Proof(f"{STIFF}: PIDB", deck(cube(rigid()), SOFT, f"*{STIFF}\n5,1,2\n7\n0\n0\n", curve(7, (-1.0, -1.0), (1.0, 1.0))), refused="part 2, which is no rigid body"),
    Proof("CONSTRAINED_JOINT_STIFFNESS_TRANSLATIONAL", turned("7").replace("_GENERALIZED", "_TRANSLATIONAL"), refused="CONSTRAINED_JOINT_STIFFNESS_TRANSLATIONAL"),
]  # fmt: skip


def spins(axis: str, inertia: float) -> list:
    """Of a moment of 2 about an axis."""
    return [(f"body_w{axis}:part_1", LAST, 2.0 * END / inertia, 2e-3)]


MERGED = two_cubes(0.02) + "*SET_NODE_LIST\n4\n5,6,7,8,11,12,13,14\n*NODE_MERGE_SET\n4\n"


PROOFS = [
    Proof("NODE_MERGE_SET: NSID; NODE_MERGE_TOLERANCE: TOLR", deck(MERGED, "*NODE_MERGE_TOLERANCE\n0.03\n", velocity(100.0), "*BOUNDARY_SPC_SET\n4,0,1\n"),
          [("summary:nodes", LAST, 12.0, 0.0), ("momentum_x", FIRST, 100.1 * CUBE_MASS, 1e-9)], "four nodes are shared, so that the set holds half of the mass; the upper cube is 0.02 higher"),
    Proof("NODE_MERGE_TOLERANCE: TOLR", deck(MERGED, "*NODE_MERGE_TOLERANCE\n0.01\n"), [("summary:nodes", LAST, 16.0, 0.0)], "they lie farther apart"),
    Proof("NODE_MERGE_SET: NSID", deck(MERGED), [("summary:nodes", LAST, 16.0, 0.0)], "farther than the usual tolerance"),
    Proof("NODE_MERGE_SET: NSID", deck(MERGED.replace("10.02", "10.0")), [("summary:nodes", LAST, 12.0, 0.0)], "at one place"),
    Proof("NODE_MERGE_SET", deck(MERGED, "*NODE_MERGE_TOLERANCE\n0.03\n*LOAD_NODE_POINT\n11,1,7,3.0\n", CONSTANT), refused="node 11"),
    *STIFFNESSES,
    Proof("LOAD_NODE_POINT: ID DOF LCID SF; CONSTRAINED_NODAL_RIGID_BODY: PID NSID",
          deck(cube(), NODAL_BODY, "*LOAD_NODE_POINT\n50,1,7,3.0\n", CONSTANT, end=10 * END),
          [("momentum_x", LAST, 30.0 * END, 1e-2), ("angular_y", LAST, 600.0 * END, 1e-2)],
          "3 N at a node without elements, 20 mm above the centre, push the body and turn it"),
    Proof("CONSTRAINED_NODAL_RIGID_BODY: PNODE", deck(cube(), NODAL_BODY.replace("77,0,4", "77,0,4,50"), "*LOAD_NODE_POINT\n50,1,7,3.0\n", CONSTANT, end=10 * END),
          [("momentum_x", LAST, 30.0 * END, 1e-2), ("angular_y", LAST, 0.0, 1e-12)], "PNODE is moved to the mass centre"),
    Proof("CONSTRAINED_NODAL_RIGID_BODY: DRFLAG", deck(cube(), NODAL_BODY.replace("77,0,4", "77,0,4,0,0,1")), refused="DRFLAG"),
    Proof("CONSTRAINED_NODAL_RIGID_BODY: RRFLAG", deck(cube(), NODAL_BODY.replace("77,0,4", "77,0,4,0,0,0,1")), refused="RRFLAG"),
    Proof("CONSTRAINED_NODAL_RIGID_BODY_SPC: CMO CON1 CON2",
          deck(cube(), NODAL_BODY.replace("_BODY", "_BODY_SPC") + "1,4,7\n", velocity(100.0, 20.0, -30.0)),
          [("momentum_x", LAST, 0.0, 1e-15), ("momentum_y", LAST, 0.0, 1e-15), ("momentum_z", ALL, -30.0 * CUBE_MASS, 1e-9)], "4 holds x and y"),
    Proof("CONSTRAINED_NODAL_RIGID_BODY_INERTIA: XC YC ZC TM IXX IYY IZZ VTX VTY VTZ",
          deck(cube(), NODAL_BODY.replace("_BODY", "_BODY_INERTIA") + INERTIA.format(ircs=0)),
          [("momentum_x", ALL, 10.0 * 2e-5, 1e-9), ("momentum_y", FIRST, 20.0 * 2e-5, 1e-9), ("momentum_z", FIRST, 30.0 * 2e-5, 1e-9)],
          "TM is the mass in place of that of the nodes"),
    Proof("LOAD_NODE_POINT: DOF", deck(cube(rigid()), "*LOAD_NODE_POINT\n3,5,7,2.0\n", CONSTANT), [("angular_x", LAST, 2.0 * END, 2e-3)],
          "a moment on a node of a solid that is rigid"),
    Proof("LOAD_RIGID_BODY: ID DOF LCID SF", deck(cube(rigid()), "*LOAD_RIGID_BODY\n1,2,7,4.0\n", CONSTANT),
          [("momentum_y", LAST, 4.0 * END, 2e-3), ("angular_z", LAST, 0.0, 1e-12)], "at the mass centre"),
    Proof("LOAD_RIGID_BODY: CID; DEFINE_COORDINATE_VECTOR",
          deck(cube(rigid()), "*DEFINE_COORDINATE_VECTOR\n5,3.0,4.0,0.0,-4.0,3.0,0.0\n*LOAD_RIGID_BODY\n1,2,7,5.0,5\n", CONSTANT),
          [("momentum_x", LAST, -4.0 * END, 2e-3), ("momentum_y", LAST, 3.0 * END, 2e-3)], "y of the system is (-0.8, 0.6)"),
    Proof("LOAD_RIGID_BODY", deck(cube(rigid()), "*LOAD_RIGID_BODY\n1,4,7,4.0\n", CONSTANT), refused="follower"),
    Proof("LOAD_NODE_POINT", deck(cube(), OUT, "*LOAD_NODE_POINT\n50,1,7,3.0\n", CONSTANT), refused="node 50, which has no element"),
    Proof("ELEMENT_MASS: ID MASS", deck(cube(), NODAL_BODY, "*ELEMENT_MASS\n1,50,2e-6\n", velocity(100.0)),
          [("momentum_x", ALL, 100.0 * (CUBE_MASS + 2e-6), 1e-9)], "a mass on a node without elements is one of the body"),
    Proof("ELEMENT_MASS", deck(cube(), OUT, "*ELEMENT_MASS\n1,50,2e-6\n"), refused="node 50, which has no element"),
    Proof("BOUNDARY_SPC_NODE: ID X Y Z; CONSTRAINED_EXTRA_NODES_NODE: PID ID",
          deck(cube(rigid()), EXTRA, "*BOUNDARY_SPC_NODE\n50,0,1,1,1,0,0,0\n*LOAD_NODE_POINT\n50,1,7,3.0\n", CONSTANT),
          [("momentum_x", LAST, 0.0, 1e-12), ("angular_y", LAST, 0.0, 1e-10)], "a force on the point that is held moves nothing"),
    Proof("BOUNDARY_SPC_NODE: RX RY RZ", deck(cube(rigid()), EXTRA, "*BOUNDARY_SPC_NODE\n50,0,0,1,1,1,1,1\n*LOAD_NODE_POINT\n50,1,7,3.0\n", CONSTANT, velocity(100.0)),
          [("momentum_x", LAST, 100.0 * CUBE_MASS + 3.0 * END, 2e-3), ("angular_y", LAST, 0.0, 1e-12)], "the body moves along x and does not turn"),
    Proof("BOUNDARY_SPC_SET: ID X", deck(cube(rigid()), "*BOUNDARY_SPC_SET\n4,0,0,1,0,0,0,0\n", node_set(4, 1, 2, 5, 6), velocity(100.0, 20.0)),
          [("momentum_x", LAST, 100.0 * CUBE_MASS, 1e-9), ("momentum_y", LAST, 0.0, 1e-12)], "nodes of a plane of symmetry hold the rigid part"),
    Proof("BOUNDARY_PRESCRIBED_MOTION_NODE: ID DOF VAD LCID SF",
          deck(cube(), NODAL_BODY, "*BOUNDARY_SPC_NODE\n50,0,0,1,1,1,1,1\n*BOUNDARY_PRESCRIBED_MOTION_NODE\n50,1,0,7,40.0\n", CONSTANT),
          [("momentum_x", ALL, 40.0 * CUBE_MASS, 1e-9)], "the motion of a node without elements is that of the body"),
    Proof("BOUNDARY_PRESCRIBED_MOTION_NODE", deck(cube(), NODAL_BODY, "*BOUNDARY_PRESCRIBED_MOTION_NODE\n50,1,0,7,40.0\n", CONSTANT),
          refused="a motion of a point of a rigid body about which it may turn"),
    Proof("BOUNDARY_PRESCRIBED_MOTION_RIGID: ID DOF VAD LCID SF; LOAD_NODE_POINT: DOF",
          deck(cube(rigid()), "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n1,1,0,7,40.0\n*LOAD_NODE_POINT\n3,7,7,2.0\n", CONSTANT),
          [("momentum_x", ALL, 40.0 * CUBE_MASS, 1e-9), ("angular_z", LAST, 2.0 * END, 2e-3)], "driven along x it turns freely"),
    Proof("BOUNDARY_PRESCRIBED_MOTION_RIGID: DEATH",
          deck(cube(rigid()), "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n1,1,0,7,40.0,0,5e-6\n", PUSH.format(id=1, dof=1)),
          [("momentum_x", LAST, 40.0 * CUBE_MASS + 3.0 * 5e-6, 2e-3), ("momentum_x", 4e-6, 40.0 * CUBE_MASS, 1e-6)], "then the force alone acts"),
    Proof("BOUNDARY_PRESCRIBED_MOTION_RIGID: BIRTH",
          deck(cube(rigid()), "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n1,1,0,8,1.0,0,0.0,4e-6\n", curve(8, (0, 0.0), (1e-5, 100.0)), velocity(30.0)),
          [("momentum_x", 3e-6, 30.0 * CUBE_MASS, 1e-6), ("momentum_x", LAST, 60.0 * CUBE_MASS, 5e-3)], "free until BIRTH, then 100 (t - BIRTH) / 1e-5"),
    Proof("BOUNDARY_PRESCRIBED_MOTION_RIGID: BIRTH DEATH",
          deck(cube(rigid()), "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n1,1,0,7,40.0,0,4e-6\n1,1,0,7,-20.0,0,0,4e-6\n", CONSTANT),
          [("momentum_x", 3e-6, 40.0 * CUBE_MASS, 1e-6), ("momentum_x", LAST, -20.0 * CUBE_MASS, 1e-6)], "one motion after the other"),
    Proof("BOUNDARY_PRESCRIBED_MOTION_RIGID: VAD; INITIAL_VELOCITY: VX; MAT_RIGID: CMO CON1 CON2",
          deck(cube(rigid(1, 1, 5, 7)), "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n1,1,1,8,1.0\n", curve(8, (0, -1e8), (5e-6, -1e8)), velocity(1000.0, 50.0)),
          [("momentum_x", FIRST, 1000.0 * CUBE_MASS, 1e-3), ("momentum_x", LAST, 500.0 * CUBE_MASS, 2e-3), ("momentum_y", LAST, 0.0, 1e-12)],
          "an acceleration begins from the initial velocity; behind its end the velocity stays"),
    Proof("BOUNDARY_PRESCRIBED_MOTION_RIGID: VAD",
          deck(cube(rigid()), "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n1,7,2,8,1.0\n", curve(8, (0, 0.0), (1e-5, 0.02))),
          [("body_wz:part_1", LAST, 2000.0, 1e-3)], "an angle of 0.02 in 1e-5 s"),
    Proof("BOUNDARY_PRESCRIBED_MOTION_RIGID: VID; DEFINE_VECTOR: VID XT YT ZT XH YH ZH",
          deck(cube(rigid()), "*DEFINE_VECTOR\n5,1.0,1.0,0.0,4.0,5.0,0.0\n*BOUNDARY_PRESCRIBED_MOTION_RIGID\n1,-4,0,7,50.0,5\n", CONSTANT, velocity(0.0, 0.0, 8.0)),
          [("momentum_x", LAST, 30.0 * CUBE_MASS, 1e-9), ("momentum_y", LAST, 40.0 * CUBE_MASS, 1e-9), ("momentum_z", LAST, 0.0, 1e-12)],
          "-4: along (3, 4, 0), held across it"),
    Proof("DEFINE_VECTOR: VID", deck(cube(rigid()), "*DEFINE_VECTOR\n5,1.0,1.0,0.0,4.0,5.0,0.0\n6,0,0,0,0,0,2.0\n*BOUNDARY_PRESCRIBED_MOTION_RIGID\n1,4,0,7,50.0,6\n", CONSTANT),
          [("momentum_z", LAST, 50.0 * CUBE_MASS, 1e-6)], "the second vector of the card"),
    Proof("BOUNDARY_PRESCRIBED_MOTION_RIGID", deck(cube(rigid()), "*DEFINE_VECTOR\n5,1.0,1.0,0.0,4.0,5.0,0.0\n*BOUNDARY_PRESCRIBED_MOTION_RIGID\n1,4,0,7,50.0,5\n", CONSTANT),
          refused="no axis of space"),
    Proof("BOUNDARY_PRESCRIBED_MOTION_RIGID", deck(cube(rigid()), "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n1,1,3,7,50.0\n", CONSTANT), refused="VAD 3"),
    Proof("CONSTRAINED_RIGID_BODIES: PIDL PIDC; INITIAL_VELOCITY_RIGID_BODY: PID VX VY VZ VZR",
          deck(TWO_RIGID, "*CONSTRAINED_RIGID_BODIES\n1,2\n*INITIAL_VELOCITY_RIGID_BODY\n1,10.0,20.0,30.0,0,0,7.0\n"),
          [("momentum_x", ALL, 20.0 * CUBE_MASS, 1e-9), ("momentum_z", ALL, 60.0 * CUBE_MASS, 1e-9), ("body_wz:part_1", ALL, 7.0, 1e-9)],
          "the velocity of the centre of both, which turn about their axis"),
    Proof("INITIAL_VELOCITY_RIGID_BODY: VXR VYR", deck(cube(rigid()), velocity(9.0), "*INITIAL_VELOCITY_RIGID_BODY\n1,0,0,0,3.0,4.0,0.0\n"),
          [("body_wx:part_1", FIRST, 3.0, 1e-9), ("body_wy:part_1", FIRST, 4.0, 1e-9), ("momentum_x", FIRST, 0.0, 1e-12)], "it counts more than that of nodes"),
    Proof("INITIAL_VELOCITY_RIGID_BODY: ICID",
          deck(cube(rigid()), "*DEFINE_COORDINATE_VECTOR\n5,3.0,4.0,0.0,-4.0,3.0,0.0\n*INITIAL_VELOCITY_RIGID_BODY\n1,10.0,5.0,0,0,0,0,5\n"),
          [("momentum_x", FIRST, 2.0 * CUBE_MASS, 1e-9), ("momentum_y", FIRST, 11.0 * CUBE_MASS, 1e-9)], "10 (0.6, 0.8) + 5 (-0.8, 0.6)"),
    Proof("CONSTRAINED_NODAL_RIGID_BODY; INITIAL_VELOCITY_NODE: NID VX",
          deck(cube(), NODAL_BODY, "*INITIAL_VELOCITY_NODE\n" + "".join(f"{n},80.0\n" for n in (1, 2, 3, 4))),
          [("momentum_x", FIRST, 40.0 * CUBE_MASS, 1e-9), ("angular_y", FIRST, -CUBE_MASS / 8 * 4 * 80.0 * 5.0, 1e-9)],
          "nodes that begin differently give the body their momenta"),
    Proof("PART_INERTIA: TM VTX VTY VTZ XC YC ZC; MAT_RIGID", deck(HEAVY, velocity(100.0)),
          [("momentum_x", ALL, 10.0 * 2e-5, 1e-9), ("momentum_y", FIRST, 20.0 * 2e-5, 1e-9)], "its velocity counts more than that of its nodes"),
    *(Proof("INITIAL_VELOCITY: IRIGID", deck(HEAVY, velocity(100.0).replace("\n0\n", f"\n0,0,0,{flag}\n"), "*SET_PART_LIST\n4\n1\n"),
            [("momentum_x", ALL, 100.0 * 2e-5, 1e-9)], "overwritten") for flag in (-1, -2, 4)),
    Proof("INITIAL_VELOCITY_GENERATION: IRIGID", deck(HEAVY, "*INITIAL_VELOCITY_GENERATION\n1,2,0.0,70.0\n0,0,0,0,0,0,0,1\n"),
          [("momentum_x", ALL, 70.0 * 2e-5, 1e-9)], "overwritten"),
    Proof("PART_INERTIA: IXX", deck(TURNING.format(dof=5)), spins("x", 1e-3), "w = M t / I"),
    Proof("PART_INERTIA: IYY", deck(TURNING.format(dof=6)), spins("y", 2e-3), "w = M t / I"),
    Proof("PART_INERTIA: IZZ", deck(TURNING.format(dof=7)), spins("z", 2.5e-3), "w = M t / I"),
    Proof("PART_INERTIA: IRCS XL YL ZL XLIP YLIP ZLIP",
          deck(TURNING.format(dof=6).replace("2e-5,0,0", "2e-5,1,0").replace("0,0,0,0,0,0\n", "0,0,0,0,0,0\n0,1,0,-1,0,0\n")), spins("y", 1e-3), "the local x is y"),
    Proof("PART_INERTIA: VRX VRY VRZ", deck(HEAVY.replace("10,20,30,0,0,0", "0,0,0,3,4,5")),
          [("body_wx:part_1", FIRST, 3.0, 1e-9), ("body_wy:part_1", FIRST, 4.0, 1e-9), ("body_wz:part_1", FIRST, 5.0, 1e-9)], "its spin"),
    Proof("PART_INERTIA: NODEID", deck(HEAVY.replace("5,5,5,2e-5,0,0", "0,0,0,2e-5,0,50"), OUT), [("body_z:part_1", FIRST, 25.0, 1e-9)], "the centre is node 50"),
    *(Proof(f"{card}: {fields}", deck(SKEW[card].format(spin=spin)), [(f"angular_{axis}", FIRST, value, 1e-6) for axis, value in zip("xyz", values, strict=True)], "I w")
      for card in ("PART_INERTIA", "CONSTRAINED_NODAL_RIGID_BODY_INERTIA")
      for fields, spin, values in (("IXY IXZ VRX", "3,0,0", (6e-3, 6e-4, 9e-4)), ("IXY IYZ VRY", "0,5,0", (1e-3, 1.1e-2, 2e-3)), ("IXZ IYZ VRZ", "0,0,2", (6e-4, 8e-4, 5e-3)))),
    Proof("CONSTRAINED_NODAL_RIGID_BODY_INERTIA: IRCS; CONSTRAINED_NODAL_RIGID_BODY_INERTIA: XL YL ZL XLIP YLIP ZLIP",
          deck(cube(), NODAL_BODY.replace("_BODY", "_BODY_INERTIA") + INERTIA.format(ircs=1).replace("10,20,30,0,0,0\n", "4,0,0,0,5,0\n0,1,0,-1,0,0\n")),
          [("angular_y", FIRST, 5e-3, 1e-6)], "the local x, with 1e-3, is y"),
    Proof("CONSTRAINED_NODAL_RIGID_BODY_INERTIA: NODEID", deck(cube(), NODAL_BODY.replace("_BODY", "_BODY_INERTIA") + INERTIA.format(ircs=0).replace("0,0\n1e-3", "0,50\n1e-3")),
          [("body_z:rigid_77", FIRST, 25.0, 1e-9)], "the centre is node 50"),
    Proof("CONSTRAINED_RIGID_BODIES: IFLAG",
          deck(HEAVY, hexahedron(2, 11, (0.0, 0.0, 11.0), of=2), part(2), "*CONSTRAINED_RIGID_BODIES\n1,2,1\n"), refused="IFLAG"),
    Proof("CONSTRAINED_EXTRA_NODES_SET: PID ID; MAT_RIGID: MID",
          deck(cube(rigid()), SOFT, "*CONSTRAINED_EXTRA_NODES_SET\n1,4\n", node_set(4, *range(11, 19)), PUSH.format(id=1, dof=1), end=10 * END),
          [("body_vx:part_1", LAST, 30.0 * END / (2 * CUBE_MASS), 1e-2)], "the nodes of the second cube are of the body"),
    Proof("CONSTRAINED_EXTRA_NODES_SET: IFLAG",
          deck(HEAVY.replace("10,20,30,", "0,0,0,"), SOFT,
               "*CONSTRAINED_EXTRA_NODES_SET\n1,4,1\n", node_set(4, *range(11, 19)), PUSH.format(id=1, dof=1), end=10 * END),
          [("body_vx:part_1", LAST, 30.0 * END / (2e-5 + CUBE_MASS), 1e-2)], "1: their mass comes on top of TM"),
    Proof("CONSTRAINED_EXTRA_NODES_SET: IFLAG",
          deck(HEAVY.replace("10,20,30,", "0,0,0,"), SOFT,
               "*CONSTRAINED_EXTRA_NODES_SET\n1,4\n", node_set(4, *range(11, 19)), PUSH.format(id=1, dof=1), end=10 * END),
          [("body_vx:part_1", LAST, 30.0 * END / 2e-5, 1e-2)], "0: TM includes it"),
    Proof("CONSTRAINED_JOINT_SPHERICAL: N1 N2", deck(TWO_RIGID, JOINED, "*CONSTRAINED_JOINT_SPHERICAL\n90,91\n", PUSH.format(id=2, dof=3)),
          [("body_vz:part_1", LAST, 3.0 * END / (2 * CUBE_MASS), 2e-3)], "the force on one moves both"),
    Proof("CONSTRAINED_JOINT_REVOLUTE: N1 N2 N3 N4",
          deck(TWO_RIGID, JOINED, "*CONSTRAINED_JOINT_REVOLUTE\n90,91,92,93\n*LOAD_NODE_POINT\n12,7,7,2.0\n", CONSTANT),
          [("body_wz:part_1", LAST, 0.0, 1e-9), ("angular_z", LAST, 2.0 * END, 2e-3)], "a moment about the hinge turns one body alone"),
    Proof("CONSTRAINED_JOINT_CYLINDRICAL: N1 N2 N3 N4", joint("CYLINDRICAL", "90,91,92,93", PUSH.format(id=2, dof=3)),
          [("body_vz:part_1", LAST, 0.0, 1e-9), ("body_vz:part_2", LAST, 3.0 * END / CUBE_MASS, 2e-3)], "a force along the axis moves one body alone"),
    Proof("CONSTRAINED_JOINT_CYLINDRICAL: N1 N2 N3 N4", joint("CYLINDRICAL", "90,91,92,93", TWIST.format(dof=7)),
          [("body_wz:part_1", LAST, 0.0, 1e-9), ("angular_z", LAST, 2.0 * END, 2e-3)], "a moment about it turns one body alone"),
    Proof("CONSTRAINED_JOINT_PLANAR: N1 N2 N3 N4", joint("PLANAR", "90,91,92,93", PUSH.format(id=2, dof=1)),
          [("body_vx:part_1", LAST, 0.0, 1e-9), ("body_vx:part_2", LAST, 3.0 * END / CUBE_MASS, 2e-3)], "a force in the plane moves one body alone"),
    Proof("CONSTRAINED_JOINT_PLANAR: N1 N2 N3 N4", joint("PLANAR", "90,91,92,93", PUSH.format(id=2, dof=3)),
          [("body_vz:part_1", LAST, 3.0 * END / (2 * CUBE_MASS), 2e-3)], "a force across it moves both"),
    Proof("CONSTRAINED_JOINT_TRANSLATIONAL: N1 N2 N3 N4 N5 N6", joint("TRANSLATIONAL", "90,91,92,93,94,95", PUSH.format(id=2, dof=3)),
          [("body_vz:part_1", LAST, 0.0, 1e-9), ("body_vz:part_2", LAST, 3.0 * END / CUBE_MASS, 2e-3)], "a force along the axis moves one body alone"),
    Proof("CONSTRAINED_JOINT_TRANSLATIONAL: N1 N2 N3 N4 N5 N6", joint("TRANSLATIONAL", "90,91,92,93,94,95", TWIST.format(dof=7)),
          [("body_wz:part_1", LAST, 2.0 * END / (2 * SPIN), 2e-3)], "a moment about it turns both"),
    Proof("CONSTRAINED_JOINT_UNIVERSAL: N1 N2 N3 N4", joint("UNIVERSAL", "90,91,92,95", TWIST.format(dof=7)),
          [("body_wz:part_1", LAST, 0.0, 1e-9), ("angular_z", LAST, 2.0 * END, 2e-3)], "a moment about the axis of the first body, z, turns the second alone"),
    Proof("CONSTRAINED_JOINT_UNIVERSAL: N1 N2 N3 N4", joint("UNIVERSAL", "90,91,92,95", TWIST.format(dof=6)),
          [("body_wy:part_1", LAST, 2.0 * END / (2 * (SPIN + CUBE_MASS * 5.5**2)), 2e-3)], "one across both axes, y, turns both as one"),
    Proof("CONSTRAINED_JOINT_UNIVERSAL: N3 N4", joint("UNIVERSAL", "90,91,92,93"), refused="not perpendicular"),
    Proof("CONSTRAINED_JOINT_LOCKING: N1 N2 N3 N4 N5 N6", joint("LOCKING", "90,91,92,93,94,95", TWIST.format(dof=7)),
          [("body_wz:part_1", LAST, 2.0 * END / (2 * SPIN), 2e-3)], "they move as one"),
    Proof("CONSTRAINED_JOINT_SCREW: N1 N2 N3 N4 N5 N6 PARM", joint("SCREW", "90,91,92,93,94,95\n2.0", PUSH.format(id=2, dof=3)),
          [("body_vz:part_1", LAST, THREAD * END / CUBE_MASS, 2e-3), ("body_wz:part_1", LAST, -2.0 * THREAD * END / SPIN, 2e-3), ("angular_z", LAST, 0.0, 1e-12)],
          "the thread pushes with q and turns with PARM q: 2 q - 3 = -2 PARM^2 q m / I, from ways that differ by PARM times the angle"),
    Proof("CONSTRAINED_JOINT_SCREW: N2 N4", joint("SCREW", "90,96,92,97,94,95\n2.0", APART, PUSH.format(id=2, dof=3)),
          [("body_vz:part_1", LAST, THREAD * END / CUBE_MASS, 2e-3), ("body_wz:part_1", LAST, -2.0 * THREAD * END / SPIN, 2e-3)], "nodes that lie apart on the axis are the same screw"),
    Proof("CONSTRAINED_JOINT_CYLINDRICAL: N2 N4", joint("CYLINDRICAL", "90,96,92,97", APART, TWIST.format(dof=6)),
          [("body_wy:part_1", LAST, 2.0 * END / (2 * (SPIN + CUBE_MASS * 5.5**2)), 2e-3)], "and the same cylindrical joint: a moment across it turns both as one"),
    *(Proof("CONSTRAINED_JOINT_SCREW: N1 N2 N3 PARM", held_screw(off),
            [("body_vz:part_2", LAST, 3.0 * END / (CUBE_MASS + SPIN / 4), 2e-3), ("body_wz:part_2", LAST, 1.5 * END / (CUBE_MASS + SPIN / 4), 2e-3)],
            "what is held across the axis turns about its mass centre, which lies on the axis") for off in (0.0, 0.16)),
    Proof("CONSTRAINED_JOINT_SCREW: PARM; BOUNDARY_PRESCRIBED_MOTION_RIGID: ID DOF", held_screw(0.16, "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n2,7,0,7,40.0\n" + CONSTANT),
          [("body_vz:part_2", LAST, 80.0, 2e-3), ("body_wz:part_2", LAST, 40.0, 2e-3)], "one that is driven about the axis turns about its mass centre too, and moves PARM times the angle"),
    Proof("CONSTRAINED_JOINT_SCREW: N1 N3", held_screw(2.0), refused="off the mass centre of 'part_2'", messages=1),
    Proof("CONSTRAINED_JOINT_SCREW: N2", joint("SCREW", "90,95,92,97,94,95\n2.0", APART), refused="not on its axis"),
    Proof("CONSTRAINED_JOINT_SCREW: PARM", joint("SCREW", "90,91,92,93,94,95\n"), refused="PARM"),
    Proof("CONSTRAINED_JOINT_SCREW: LCID", joint("SCREW", "90,91,92,93,94,95\n2.0,7"), refused="LCID"),
    Proof("CONSTRAINED_JOINT_SCREW: TYPE", joint("SCREW", "90,91,92,93,94,95\n2.0,0,1"), refused="TYPE"),
    Proof("CONSTRAINED_JOINT_SCREW: H_ANGLE", joint("SCREW", "90,91,92,93,94,95\n2.0,0,0,0,30.0"), refused="H_ANGLE"),
    Proof("CONSTRAINED_JOINT_GEARS", joint("GEARS", "90,91,92,93,94,95\n2.0"), refused="CONSTRAINED_JOINT_GEARS"),
    Proof("CONSTRAINED_JOINT_SPHERICAL_FAILURE", deck(TWO_RIGID, JOINED, "*CONSTRAINED_JOINT_SPHERICAL_FAILURE\n90,91\n"), refused="CONSTRAINED_JOINT_SPHERICAL_FAILURE"),
    Proof("MAT_RIGID: CMO CON1 CON2",
          deck(cube(rigid(1, -1, 5, 100000)), "*DEFINE_COORDINATE_VECTOR\n5,0.0,1.0,0.0,-1.0,0.0,0.0\n", velocity(3.0, 4.0)),
          [("momentum_x", LAST, 3.0 * CUBE_MASS, 1e-9), ("momentum_y", LAST, 0.0, 1e-12)], "-1: the local x, which is y"),
    Proof("MAT_RIGID: CMO", deck(cube(rigid(1, -1, 5, 100000)), "*DEFINE_COORDINATE_VECTOR\n5,3.0,4.0,0.0,-4.0,3.0,0.0\n"), refused="MAT_RIGID.CMO"),
    Proof("DEFORMABLE_TO_RIGID: PID LRB PTYPE",
          deck(two_cubes(), "*DEFORMABLE_TO_RIGID\n1\n2,1,PART\n", PUSH.format(id=1, dof=1)),
          [("body_vx:part_1", LAST, 3.0 * END / (2 * CUBE_MASS), 5e-3)], "both parts are one rigid body"),
    Proof("DEFORMABLE_TO_RIGID_AUTOMATIC", deck(cube(), "*DEFORMABLE_TO_RIGID_AUTOMATIC\n1,0,1e-3\n"), refused="DEFORMABLE_TO_RIGID_AUTOMATIC"),
    *(Proof(f"MAT_RIGID: {name}", deck(cube(rigid().replace("0.3\n", f"0.3,{fields}\n"))), refused=f"MAT_RIGID.{name}") for name, fields in (("COUPLE", "0,1"),)),
    Proof("MAT_RIGID: RO", deck(cube(rigid()), velocity(3.0)), [("momentum_x", ALL, 3.0 * CUBE_MASS, 1e-9)], "its mass"),
]  # fmt: skip

SPRINGS = "the stiffness of springs between bodies that touch, which contact without springs does not have"
NOT_PHYSICS = {"MAT_RIGID.E": SPRINGS, "MAT_RIGID.PR": SPRINGS}
