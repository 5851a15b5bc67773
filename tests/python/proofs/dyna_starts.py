"""Velocities and stresses at time 0."""

from . import ALL, FIRST, Proof
from .pieces import CUBE_MASS, YOUNG, cube, deck, node_set, shell, two_cubes, velocity

SYSTEM = "*DEFINE_COORDINATE_VECTOR\n5,3.0,4.0,0.0,-4.0,3.0,0.0\n"  # x along (0.6, 0.8, 0)
SPIN = "*INITIAL_VELOCITY_GENERATION\n{id},{kind},{omega},{vx},{vy},{vz},{ivatn},{icid}\n{xc},{yc},{zc},{nx},{ny},{nz},{phase},0\n"


def spin(**more: float) -> str:
    keys = dict.fromkeys(("ivatn", "icid", "xc", "yc", "zc", "nx", "ny", "nz", "phase", "omega", "vx", "vy", "vz"), 0) | {"id": 1, "kind": 2}
    return SPIN.format(**(keys | more))


def first(**values: float) -> list:
    """Velocities of the mass of a cube."""
    return [(f"momentum_{axis}", FIRST, value * CUBE_MASS, 1e-9) for axis, value in values.items()]


STRESS = "*INITIAL_STRESS_SOLID\n1,1,0,0\n100.0,0,0,0,0,0,0\n"
LAYERED = "*INITIAL_STRESS_SHELL\n1,1,2\n-0.57735026919,50.0,0,0,0,0,0,0\n0.57735026919,150.0,0,0,0,0,0,0\n"
YIELDING = "*MAT_PLASTIC_KINEMATIC\n1,7.8e-9,2.1e5,0.3,200.0,1000.0,1.0\n0,0,0\n"
WATCHED = "*DATABASE_HISTORY_SOLID\n1\n*DATABASE_ELOUT\n1e-7\n"

PROOFS = [
    Proof("INITIAL_VELOCITY: NSID VX VY VZ", deck(cube(), node_set(4, 1, 2), velocity(80.0, 40.0, 8.0).replace("\n0\n", "\n4\n")), first(x=20.0, y=10.0, z=2.0), "two nodes of eight"),
    Proof("INITIAL_VELOCITY: NSIDEX VXE VYE VZE", deck(cube(), node_set(4, 1, 2), "*INITIAL_VELOCITY\n0,4\n80.0\n0.0,40.0,8.0\n"), first(x=60.0, y=10.0, z=2.0), "six nodes, and two that are exempted"),
    Proof("INITIAL_VELOCITY: BOXID; DEFINE_BOX", deck(two_cubes(), "*DEFINE_BOX\n3,-1.0,11.0,-1.0,11.0,-1.0,0.5\n*INITIAL_VELOCITY\n0,0,3\n80.0\n"), first(x=40.0), "the lower four nodes of one cube"),
    Proof("INITIAL_VELOCITY: ICID", deck(cube(), SYSTEM, "*INITIAL_VELOCITY\n0,0,0,0,5\n10.0,5.0,2.0\n"), first(x=2.0, y=11.0, z=2.0), "10 (0.6, 0.8) + 5 (-0.8, 0.6)"),
    Proof("INITIAL_VELOCITY: VXR", deck(shell(), "*INITIAL_VELOCITY\n0\n0,0,0,3.0\n"), refused="VXR"),
    Proof("INITIAL_VELOCITY_NODE: NID VX VY VZ", deck(cube(), "*INITIAL_VELOCITY_NODE\n1,80.0,0,0\n2,0,40.0,8.0\n"), first(x=10.0, y=5.0, z=1.0), "one node of eight each"),
    Proof("INITIAL_VELOCITY_NODE: ICID", deck(cube(), SYSTEM, "*INITIAL_VELOCITY_NODE\n1,80.0,0,0,0,0,0,5\n"), first(x=6.0, y=8.0), "along (0.6, 0.8)"),
    Proof("INITIAL_VELOCITY_GENERATION: ID STYP VX VY VZ", deck(two_cubes(), spin(id=2, vx=30.0, vy=4.0, vz=5.0)), first(x=30.0, y=4.0, z=5.0), "part 2"),
    Proof("INITIAL_VELOCITY_GENERATION: STYP", deck(two_cubes(), "*SET_PART_LIST\n4\n1,2\n", spin(id=4, kind=1, vx=30.0)), first(x=60.0), "1: a set of parts"),
    Proof("INITIAL_VELOCITY_GENERATION: STYP", deck(cube(), node_set(4, 1, 2), spin(id=4, kind=3, vx=80.0)), first(x=20.0), "3: a set of nodes"),
    Proof("INITIAL_VELOCITY_GENERATION: ID", deck(two_cubes(), spin(id=0, vx=30.0)), first(x=60.0), "0: all"),
    Proof("INITIAL_VELOCITY_GENERATION: OMEGA XC YC ZC NX NY NZ", deck(cube(), spin(omega=10.0, xc=1.0, yc=2.0, zc=3.0, nx=3.0, ny=0.0, nz=4.0)),
          first(x=-8.0 * 3.0, y=8.0 * 4.0 - 6.0 * 2.0, z=6.0 * 3.0), "w x (c - p), w = 10 (0.6, 0, 0.8), c - p = (4, 3, 2)"),
    Proof("INITIAL_VELOCITY_GENERATION: NX", deck(cube(), spin(omega=10.0, nx=-999.0, ny=1, nz=2)), first(y=-50.0, z=50.0), "about the line from node 1 to node 2, which is x"),
    Proof("INITIAL_VELOCITY_GENERATION: ICID", deck(cube(), SYSTEM, spin(omega=10.0, vx=5.0, icid=5, nx=1.0)), first(x=3.0 + 40.0, y=4.0 - 30.0, z=10.0 * (0.6 * 5.0 - 0.8 * 5.0)),
          "w = 10 (0.6, 0.8, 0) about the origin"),
    Proof("INITIAL_VELOCITY_GENERATION: PHASE", deck(cube(), spin(vx=5.0, phase=1), "*CONTROL_DYNAMIC_RELAXATION\n0,0,0,0,0,0,0,1\n"), refused="PHASE"),
    Proof("INITIAL_VELOCITY_GENERATION: PHASE", deck(cube(), spin(vx=5.0, phase=1)), first(x=5.0), "without a relaxation nothing deforms before"),
    Proof("INITIAL_STRESS_SOLID: EID SIGXX", deck(cube(), STRESS), [("internal", FIRST, 1000.0 * 100.0**2 / (2 * YOUNG), 1e-6)], "V s^2 / 2 E"),
    Proof("INITIAL_STRESS_SOLID: SIGYY SIGZZ SIGXY SIGYZ SIGZX", deck(cube(), STRESS.replace("100.0,0,0,0,0,0", "0,20.0,30.0,40.0,50.0,60.0")),
          [("internal", FIRST, 1000.0 / (2 * YOUNG) * (20.0**2 + 30.0**2 - 2 * 0.3 * 600.0 + 2 * 1.3 * (40.0**2 + 50.0**2 + 60.0**2)), 1e-6)], "the energy of the stress"),
    Proof("INITIAL_STRESS_SOLID: EPS; MAT_PLASTIC_KINEMATIC", deck(cube(YIELDING), STRESS.replace("0,0,0,0,0,0\n", "0,0,0,0,0,0.02\n"), WATCHED), [("element_1_eps", FIRST, 0.02, 1e-9)], "its plastic strain"),
    Proof("INITIAL_STRESS_SHELL: EID NTHICK T SIGXX", deck(shell(), LAYERED),
          [("internal", FIRST, 100.0 * (50.0**2 + 150.0**2) / 2 / (2 * YOUNG), 1e-6)], "the mean over the two points of Gauss"),
    Proof("INITIAL_STRESS_SHELL: NPLANE SIGYY SIGXY SIGYZ SIGZX", deck(shell(), "*INITIAL_STRESS_SHELL\n1,2,1\n0,0,20.0,0,30.0,40.0,50.0,0\n0,0,40.0,0,30.0,40.0,50.0,0\n"),
          [("internal", FIRST, 100.0 / (2 * YOUNG) * (30.0**2 + 2 * 1.3 * (30.0**2 + 6 / 5 * (40.0**2 + 50.0**2))), 1e-6)], "the mean of two points; shear across a shell is a parabola: 6/5"),
    Proof("INITIAL_STRESS_SHELL: SIGZZ", deck(shell(), "*INITIAL_STRESS_SHELL\n1,1,1\n0,0,0,50.0\n"), refused="across"),
    Proof("INITIAL_STRESS_SOLID: NINT", deck(cube(), "*INITIAL_STRESS_SOLID\n1,2,0,0\n50.0\n150.0\n"), [("internal", FIRST, 1000.0 * 100.0**2 / (2 * YOUNG), 1e-6)], "the mean of its points"),
    Proof("INITIAL_TEMPERATURE_NODE", deck(cube(), "*INITIAL_TEMPERATURE_NODE\n1,300.0\n", velocity(3.0)), [("momentum_x", ALL, 3.0 * CUBE_MASS, 1e-9)], "no law depends on it"),
    Proof("INITIAL_STRESS_SOLID: LARGE", deck(cube(), STRESS.replace("1,1,0,0", "1,1,0,1")), refused="LARGE"),
    Proof("INITIAL_STRESS_SOLID: EID", deck(cube(), STRESS.replace("1,1,0,0", "9,1,0,0")), refused="EID"),
    Proof("INITIAL_STRESS_SOLID", deck(cube().replace("ELASTIC", "RIGID").replace("0.3\n", "0.3\n0\n\n"), STRESS), refused="rigid parts"),
    Proof("INITIAL_STRESS_BEAM", deck(cube(), "*INITIAL_STRESS_BEAM\n1\n"), refused="INITIAL_STRESS_BEAM"),
    Proof("INITIAL_TEMPERATURE_SET", deck(cube(), node_set(4, 1, 2), "*INITIAL_TEMPERATURE_SET\n4,300.0\n", velocity(3.0)), [("momentum_x", ALL, 3.0 * CUBE_MASS, 1e-9)], "no law depends on it"),
    Proof("INITIAL_DETONATION", deck(cube(), "*INITIAL_DETONATION\n1,0,0,0,1e-6\n"), refused="INITIAL_DETONATION.LT"),
]  # fmt: skip

