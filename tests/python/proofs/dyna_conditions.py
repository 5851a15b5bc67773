"""Damping, supports, motions of nodes, equal displacements."""

import math

from . import ALL, FIRST, LAST, Proof
from .pieces import CUBE_MASS, DENSITY, POISSON, YOUNG, cube, curve, deck, node_set, nodes, shell, two_cubes, velocity

CONSTANT = curve(7, (0, 1.0), (1, 1.0))
EVERYTHING = node_set(4, 1, 2, 3, 4, 5, 6, 7, 8)
# Motions of x, each from the death of the one before on.
TURNS = ("4,1,0,7,40.0,0,3e-6\n", "4,1,0,7,-20.0,0,6e-6,3e-6\n", "4,1,0,7,60.0,0,0,6e-6\n")
IN_TURN = [("momentum_x", when, value * CUBE_MASS, 1e-6) for when, value in ((2e-6, 40.0), (5e-6, -20.0), (8e-6, 60.0))]
MOVE = "*BOUNDARY_PRESCRIBED_MOTION_SET\n4,{dof},{vad},7,{sf}{more}\n"
LARGE = 2 * YOUNG * (1 - POISSON) / ((1 + POISSON) * (1 - 2 * POISSON))  # twice the modulus of uniaxial strain
SQUARE = 2 * LARGE * 10.0 / CUBE_MASS  # of the angular frequency of two halves of the mass of a cube on the stiffness of its middle
SYMMETRY = "*BOUNDARY_SPC_SYMMETRY_PLANE\n"
SHELL_MASS = DENSITY * 100.0  # 10 mm by 10 mm, 1 mm thick
NO_VISCOSITY = "*CONTROL_BULK_VISCOSITY\n1e-20,1e-20\n"


def falls(rate: float, speed: float = 100.0, column: str = "momentum_x") -> list:
    return [(column, LAST, speed * math.exp(-rate * 1e-2) * CUBE_MASS, 1e-3)]


PROOFS = [
    Proof("DAMPING_GLOBAL: LCID VALDMP", deck(cube(), velocity(100.0), "*DAMPING_GLOBAL\n0,50.0\n", end=1e-2), falls(50.0), "v' = -D v: exp(-50 0.01)"),
    Proof("DAMPING_GLOBAL: LCID", deck(cube(), velocity(100.0), "*DAMPING_GLOBAL\n7\n", curve(7, (0, 30.0), (1.0, 30.0)), end=1e-2), falls(30.0), "D from the curve"),
    Proof("DAMPING_GLOBAL: LCID", deck(cube(), velocity(100.0), "*DAMPING_GLOBAL\n7\n", curve(7, (0, 0.0), (5e-3, 0.0), (5e-3, 80.0), (1.0, 80.0)), end=1e-2),
          falls(40.0), "D begins after half of the time"),
    Proof("DAMPING_GLOBAL: STX STY STZ SRX SRY SRZ", deck(cube(), velocity(100.0), "*DAMPING_GLOBAL\n0,50.0,0.5,0.5,0.5\n", end=1e-2), falls(25.0), "half of it; solids have no rotations"),
    Proof("DAMPING_GLOBAL: STX", deck(cube(), "*DAMPING_GLOBAL\n0,50.0,1.0,0.5,0.5\n"), refused="differs by direction"),
    Proof("DAMPING_PART_MASS: ID LCID SF", deck(two_cubes(), "*INITIAL_VELOCITY_GENERATION\n2,2,0,100.0\n0\n*DAMPING_PART_MASS\n2,7,20.0\n", CONSTANT, end=1e-2),
          falls(20.0), "of part 2, which alone moves"),
    Proof("DAMPING_PART_MASS: ID", deck(two_cubes(), "*INITIAL_VELOCITY_GENERATION\n2,2,0,100.0\n0\n*DAMPING_PART_MASS\n1,7,20.0\n", CONSTANT, end=1e-2),
          falls(0.0), "part 2 is not damped"),
    Proof("DAMPING_GLOBAL: VALDMP; DAMPING_PART_MASS: ID", deck(two_cubes(), velocity(100.0), "*DAMPING_PART_MASS\n2,7,20.0\n*DAMPING_GLOBAL\n0,50.0\n", CONSTANT, "*DATABASE_MATSUM\n1e-4\n", end=1e-2),
          [*falls(50.0, column="momentum_x:part_1"), *falls(20.0, column="momentum_x:part_2")], "a part has its own damping in place of that of all"),
    Proof("DAMPING_PART_MASS: FLAG STX STY STZ SRX SRY SRZ", deck(cube(), velocity(100.0), "*DAMPING_PART_MASS\n1,7,20.0,1\n2.0,2.0,2.0\n", CONSTANT, end=1e-2), falls(40.0), "twice"),
    Proof("DAMPING_PART_MASS: STRUC", deck(cube(), velocity(100.0), "*ELEMENT_MASS\n1,1,1e-6\n*DAMPING_PART_MASS\n1,7,20.0,0,1\n", CONSTANT), refused="STRUC"),
    Proof("DAMPING_PART_MASS_SET: ID LCID SF", deck(two_cubes(), velocity(100.0), "*SET_PART_LIST\n6\n1,2\n*DAMPING_PART_MASS_SET\n6,7,20.0\n", CONSTANT, end=1e-2),
          falls(20.0, 200.0), "of both parts"),
    Proof("DAMPING_PART_STIFFNESS: ID COEF",
          deck(cube(), NO_VISCOSITY, "*BOUNDARY_SPC_SET\n4,0,0,1,1\n", EVERYTHING, "*INITIAL_VELOCITY_NODE\n" + "".join(f"{n},{-10.0 if n in (1, 4, 5, 8) else 10.0}\n" for n in range(1, 9)),
               "*DAMPING_PART_STIFFNESS\n1,-1e-8\n", end=1e-4, rows=2000),
          [(lambda h: h["kinetic"][-1] + h["internal"][-1], LAST, 0.5 * CUBE_MASS * 100.0 * math.exp(-1e-8 * SQUARE * 1e-4), 0.03)],
          "two halves of the mass on a spring: the energy falls by exp(-beta w^2 t)"),
    Proof("DAMPING_PART_STIFFNESS: COEF", deck(cube(), "*DAMPING_PART_STIFFNESS\n1,0.1\n"), refused="COEF"),
    Proof("DAMPING_RELATIVE", deck(cube(), "*DAMPING_RELATIVE\n0.1,10.0,1,1\n"), refused="DAMPING_RELATIVE"),
    Proof("BOUNDARY_SPC_SET: ID X Y Z", deck(cube(), EVERYTHING, "*BOUNDARY_SPC_SET\n4,0,1,0,1\n", velocity(100.0, 20.0, -30.0)),
          [("momentum_x", LAST, 0.0, 1e-15), ("momentum_y", ALL, 20.0 * CUBE_MASS, 1e-9), ("momentum_z", LAST, 0.0, 1e-15)], "x and z are held"),
    Proof("BOUNDARY_SPC_NODE: ID Y", deck(cube(), "".join(f"*BOUNDARY_SPC_NODE\n{n},0,0,1\n" for n in range(1, 9)), velocity(100.0, 20.0)),
          [("momentum_x", ALL, 100.0 * CUBE_MASS, 1e-9), ("momentum_y", LAST, 0.0, 1e-15)], "y is held"),
    Proof("BOUNDARY_SPC_SET: CID; DEFINE_COORDINATE_VECTOR",
          deck(cube(), EVERYTHING, "*DEFINE_COORDINATE_VECTOR\n5,0.0,1.0,0.0,-1.0,0.0,0.0\n*BOUNDARY_SPC_SET\n4,5,1\n", velocity(100.0, 20.0)),
          [("momentum_x", ALL, 100.0 * CUBE_MASS, 1e-9), ("momentum_y", LAST, 0.0, 1e-15)], "the local x is y"),
    Proof("BOUNDARY_SPC_SET: CID", deck(cube(), EVERYTHING, "*DEFINE_COORDINATE_VECTOR\n5,3.0,4.0,0.0,-4.0,3.0,0.0\n*BOUNDARY_SPC_SET\n4,5,1\n"), refused="BOUNDARY_SPC.CID"),
    *(Proof(f"BOUNDARY_SPC_SET: R{axis.upper()}",
            deck(shell(), node_set(4, 1, 2, 3, 4), f"*BOUNDARY_SPC_SET\n4,0,1,1,1,{flags}\n*LOAD_NODE_SET\n4,{dof},7,2.0\n", CONSTANT),
            [("kinetic", LAST, 0.0, 1e-12)], "a moment on a rotation that is held")
      for axis, flags, dof in (("x", "1,0,0", 5), ("y", "0,1,0", 6), ("z", "0,0,1", 7))),
    Proof("BOUNDARY_SPC_SET_BIRTH_DEATH: BIRTH DEATH",
          deck(cube(), EVERYTHING, "*BOUNDARY_SPC_SET_BIRTH_DEATH\n4,0,1\n0.0,5e-6\n*LOAD_NODE_SET\n4,1,7,0.5\n", CONSTANT),
          [("momentum_x", 4e-6, 0.0, 1e-15), ("momentum_x", LAST, 4.0 * 5e-6, 0.05)], "eight forces act from the death on"),
    Proof("CONSTRAINED_GLOBAL: TC DIR X Y Z TOL",
          deck(two_cubes(), "*CONSTRAINED_GLOBAL\n4,0,3,0,0,5.0,5.5\n", velocity(100.0, 20.0, -30.0)),
          [("momentum_x", LAST, 100.0 * CUBE_MASS, 1e-9), ("momentum_y", LAST, 20.0 * CUBE_MASS, 1e-9), ("momentum_z", LAST, -60.0 * CUBE_MASS, 1e-9)],
          "4 holds x and y of what is within 5.5 of z = 5: the lower cube"),
    Proof("CONSTRAINED_GLOBAL: RC", deck(shell(), "*CONSTRAINED_GLOBAL\n7,1,3,0,0,0,1.0\n", node_set(4, 1, 2, 3, 4), "*LOAD_NODE_SET\n4,5,7,2.0\n", CONSTANT),
          [("kinetic", LAST, 0.0, 1e-12)], "1 holds the rotation about x"),
    Proof("BOUNDARY_SPC_SYMMETRY_PLANE: ID Z VX VY VZ TOL", deck(two_cubes(), SYMMETRY + "9,1,3.0,4.0,10.4,0,0,-2.0\n0.5\n", velocity(100.0, 20.0, -30.0)),
          [("momentum_x", ALL, 200.0 * CUBE_MASS, 1e-9), ("momentum_y", ALL, 40.0 * CUBE_MASS, 1e-9), ("momentum_z", FIRST, -45.0 * CUBE_MASS, 1e-9)],
          "z of the upper nodes of part 1, 0.4 from the plane"),
    Proof("BOUNDARY_SPC_SYMMETRY_PLANE_SET: ID X VX TOL", deck(two_cubes(), "*SET_PART_LIST\n6\n1,2\n" + SYMMETRY.replace("PLANE", "PLANE_SET") + "9,6,-0.2,50.0,50.0,1.0\n0.3\n", velocity(100.0, 20.0)),
          [("momentum_x", FIRST, 100.0 * CUBE_MASS, 1e-9), ("momentum_y", ALL, 40.0 * CUBE_MASS, 1e-9)], "x of the nodes of both parts at x = 0"),
    Proof("BOUNDARY_SPC_SYMMETRY_PLANE: Y VY TOL", deck(shell(), SYMMETRY + "9,1,0,-0.15,0,0,1.0,0\n\n", velocity(100.0, 20.0)),
          [("momentum_x", ALL, 100.0 * SHELL_MASS, 1e-9), ("momentum_y", FIRST, 10.0 * SHELL_MASS, 1e-9)], "y of two nodes, by the 0.2 that is the default of shells"),
    *(Proof("BOUNDARY_SPC_SYMMETRY_PLANE: ID VY", deck(shell(), SYMMETRY + "9,1,0,0,0,0,1.0,0\n0.1\n", node_set(4, 1, 2), f"*LOAD_NODE_SET\n4,{dof},7,2.0\n", CONSTANT),
            [("kinetic", LAST, 0.0, 1e-12)], "moments about the axes in the plane") for dof in (5, 7)),
    Proof("BOUNDARY_SPC_SYMMETRY_PLANE: ID VY", deck(shell(), SYMMETRY + "9,1,0,0,0,0,1.0,0\n0.1\n", node_set(4, 1, 2), "*LOAD_NODE_SET\n4,6,7,2.0\n", CONSTANT),
          [(lambda h: float(h["kinetic"][-1] > 0), LAST, 1.0, 1e-12)], "a moment about the normal turns them"),
    Proof("BOUNDARY_SPC_SYMMETRY_PLANE: VX", deck(cube(), SYMMETRY + "9,1,0,0,0,1.0,1.0,0\n0.1\n"), refused="across none of the axes"),
    Proof("BOUNDARY_SPC_SYMMETRY_PLANE: TOL", deck(cube(), SYMMETRY + "9,1,0,0,0,1.0\n\n"), refused="SYMMETRY_PLANE.TOL"),
    Proof("BOUNDARY_PRESCRIBED_MOTION_SET: ID DOF VAD LCID SF", deck(cube(), EVERYTHING, MOVE.format(dof=2, vad=0, sf=40.0, more=""), CONSTANT),
          [("momentum_y", ALL, 40.0 * CUBE_MASS, 1e-9)], "a velocity"),
    *(Proof("BOUNDARY_PRESCRIBED_MOTION_SET: LCID; DEFINE_CURVE: SIDR", deck(cube(), EVERYTHING, MOVE.format(dof=dof, vad=0, sf=1.0, more=""), "\n" * (dof > 9), curve(7, (0, 1.0), (1, 1.0), more=",1")),
            refused="of dynamic relaxation alone", messages=1) for dof in (2, 10)),
    Proof("BOUNDARY_PRESCRIBED_MOTION_SET: VAD", deck(cube(), EVERYTHING, MOVE.format(dof=3, vad=2, sf=2.0, more=""), curve(7, (0, 0.0), (1e-5, 0.02))),
          [("momentum_z", LAST, 4000.0 * CUBE_MASS, 1e-6)], "a displacement of 0.04 in 1e-5 s"),
    Proof("BOUNDARY_PRESCRIBED_MOTION_SET: VAD", deck(cube(), EVERYTHING, MOVE.format(dof=1, vad=1, sf=1.0, more=""), curve(7, (0, 1e8), (5e-6, 1e8)), velocity(200.0)),
          [("momentum_x", LAST, 700.0 * CUBE_MASS, 5e-3)], "an acceleration begins from the initial velocity; behind its end the velocity stays"),
    Proof("BOUNDARY_PRESCRIBED_MOTION_SET: VAD",
          deck(two_cubes(), node_set(4, 1, 2, 3, 4, 5, 6, 7, 8).replace("\n1,", "\n11,12,13,14,15,16,17,18\n1,"), "*INITIAL_VELOCITY_GENERATION\n2,2,0,200.0\n0\n",
               MOVE.format(dof=1, vad=1, sf=1.0, more=""), curve(7, (0, 1e7), (1.0, 1e7)), end=1e-4),
          [("momentum_x", LAST, 2200.0 * CUBE_MASS, 5e-3)], "each node from its own velocity"),
    Proof("BOUNDARY_PRESCRIBED_MOTION_SET: DEATH",
          deck(cube(), EVERYTHING, MOVE.format(dof=1, vad=0, sf=40.0, more=",0,5e-6"), "*LOAD_NODE_SET\n4,1,7,0.5\n", CONSTANT),
          [("momentum_x", 4e-6, 40.0 * CUBE_MASS, 1e-9), ("momentum_x", LAST, 40.0 * CUBE_MASS + 4.0 * 5e-6, 5e-3)], "then the forces act"),
    Proof("BOUNDARY_PRESCRIBED_MOTION_SET: BIRTH",
          deck(cube(), EVERYTHING, "*BOUNDARY_PRESCRIBED_MOTION_SET\n4,1,0,7,1.0,0,0.0,4e-5\n", curve(7, (0, 0.0), (1e-4, 100.0)), velocity(30.0), end=1e-4),
          [("momentum_x", 3e-5, 30.0 * CUBE_MASS, 1e-9), ("momentum_x", LAST, 60.0 * CUBE_MASS, 0.02)], "the curve begins at BIRTH"),
    *(Proof("BOUNDARY_PRESCRIBED_MOTION_SET: BIRTH DEATH", deck(cube(), EVERYTHING, "*BOUNDARY_PRESCRIBED_MOTION_SET\n", *rows, CONSTANT), IN_TURN, "one motion after the other")
      for rows in (TURNS, TURNS[::-1], (TURNS[1], TURNS[0], TURNS[2]))),
    Proof("BOUNDARY_PRESCRIBED_MOTION_SET: BIRTH DEATH VAD", deck(cube(), EVERYTHING, "*BOUNDARY_PRESCRIBED_MOTION_SET\n4,1,2,8,2.0,0,3e-6\n", *TURNS[1:], CONSTANT, curve(8, (0, 0.0), (1e-5, 2e-4))),
          IN_TURN, "a displacement of 4e-4 in 1e-5 s, and velocities"),
    Proof("BOUNDARY_PRESCRIBED_MOTION_SET: BIRTH DEATH", deck(cube(), EVERYTHING, "*BOUNDARY_PRESCRIBED_MOTION_SET\n", TURNS[0], TURNS[2], CONSTANT), refused="of which a sensor switches one"),
    Proof("BOUNDARY_PRESCRIBED_MOTION_SET: VID",
          deck(cube(), EVERYTHING, "*DEFINE_COORDINATE_VECTOR\n5,0.0,1.0,0.0,-1.0,0.0,0.0\n", MOVE.format(dof=2, vad=0, sf=40.0, more=",-5"), CONSTANT),
          [("momentum_x", ALL, -40.0 * CUBE_MASS, 1e-9)], "the local y is -x"),
    Proof("BOUNDARY_PRESCRIBED_MOTION_SET: DOF",
          deck(shell(), node_set(4, 1, 2, 3, 4), "*BOUNDARY_SPC_SET\n4,0,1,1,1\n" + MOVE.format(dof=5, vad=0, sf=3.0, more=""), CONSTANT, "*DATABASE_NODOUT\n1e-7\n"),
          [(lambda h: max(h["kinetic"]) > 0, LAST, 1.0, 0.0)], "nodes of shells turn"),
    *(Proof("BOUNDARY_PRESCRIBED_MOTION_SET: DOF OFFSET1 OFFSET2",
            deck(cube(), EVERYTHING, f"*BOUNDARY_PRESCRIBED_MOTION_SET\n4,{dof},0,7,100.0\n2.0,3.0\n", CONSTANT),
            [(f"momentum_{a}", LAST, -100.0 * 2.0 * CUBE_MASS, 5e-3), (f"momentum_{b}", LAST, 100.0 * 3.0 * CUBE_MASS, 5e-3)], "w x (c - p), c - p = (3, 2) across the axis")
      for dof, a, b in ((9, "y", "z"), (10, "z", "x"), (11, "x", "y"))),
    Proof("BOUNDARY_PRESCRIBED_MOTION_SET: DOF VAD BIRTH OFFSET1 OFFSET2",
          deck(cube(), EVERYTHING, "*BOUNDARY_PRESCRIBED_MOTION_SET\n4,11,2,7,0.5,0,0,2e-4\n2.0,3.0\n", curve(7, (0, 0.0), (6e-4, 1.2), (1.0, 1.2)), velocity(5000.0), end=1e-3),
          [("momentum_x", 1e-4, 5000.0 * CUBE_MASS, 1e-9), ("momentum_y", 1e-4, 0.0, 1e-9),
           ("momentum_x", 5e-4, -1e3 * (2.0 * math.cos(0.3) + 4.0 * math.sin(0.3)) * CUBE_MASS, 5e-3),
           ("momentum_y", 5e-4, 1e3 * (4.0 * math.cos(0.3) - 2.0 * math.sin(0.3)) * CUBE_MASS, 5e-3), ("momentum_x", LAST, 0.0, 1e-9)],
          "it flies by 1 mm until BIRTH, has turned from there by 0.3 of 0.6 rad at 5e-4, and stays where the angle does"),
    Proof("BOUNDARY_PRESCRIBED_MOTION_SET: VAD", deck(cube(), EVERYTHING, "*BOUNDARY_PRESCRIBED_MOTION_SET\n4,11,1,7\n2.0,3.0\n", CONSTANT), refused="DOF 11 with VAD 1"),
    Proof("BOUNDARY_PRESCRIBED_MOTION_NODE", deck(cube(), nodes((50, 5.0, 5.0, 25.0)), "*BOUNDARY_PRESCRIBED_MOTION_NODE\n50,1,0,7,40.0\n", CONSTANT),
          refused="node 50, which has no element"),
    Proof("BOUNDARY_SPC_NODE", deck(cube(), nodes((50, 5.0, 5.0, 25.0)), "*BOUNDARY_SPC_NODE\n50,0,1,1,1\n"), refused="node 50, which has no element"),
    Proof("CONSTRAINED_NODE_SET: NSID DOF",
          deck(two_cubes(), "*CONSTRAINED_NODE_SET\n6,1\n*SET_NODE_LIST\n6\n1,2,3,4,5,6,7,8\n11,12,13,14,15,16,17,18\n*INITIAL_VELOCITY_GENERATION\n2,2,0,100.0,20.0\n0\n*DATABASE_MATSUM\n1e-7\n"),
          [("momentum_x:part_1", LAST, 50.0 * CUBE_MASS, 1e-6), ("momentum_y:part_1", LAST, 0.0, 1e-12)], "both have the mean velocity along x"),
    Proof("CONSTRAINED_LINEAR_GLOBAL: LCID NID DOF COEF",
          deck(two_cubes(), *(f"*CONSTRAINED_LINEAR_GLOBAL\n{n}\n{n},1,2.0\n{n + 10},2,1.0\n" for n in range(1, 9)), "*INITIAL_VELOCITY_GENERATION\n2,2,0,100.0,20.0\n0\n*DATABASE_MATSUM\n1e-7\n"),
          [("momentum_x:part_1", LAST, -8.0 * CUBE_MASS, 1e-6), ("momentum_y:part_2", LAST, 16.0 * CUBE_MASS, 1e-6)], "2 u + w = 0: w of 20 becomes 16, u becomes -8, the impulse of a row is shared as 2 to 1"),
    Proof("CONSTRAINED_LINEAR_GLOBAL: DOF", deck(cube(), EVERYTHING, "*CONSTRAINED_LINEAR_GLOBAL\n1\n1,4,1.0\n2,1,1.0\n"), refused="CONSTRAINED_LINEAR_GLOBAL.DOF"),
    Proof("CONSTRAINED_NODE_SET: TF", deck(cube(), EVERYTHING, "*CONSTRAINED_NODE_SET\n4,1,5e-6\n"), refused="CONSTRAINED_NODE_SET.TF"),
]  # fmt: skip

