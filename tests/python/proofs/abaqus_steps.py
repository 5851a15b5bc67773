"""Amplitudes, conditions, and several steps one after the other."""

import math

from . import ALL, LAST, Proof
from .pieces import CORNERS, CUBE_MASS, abaqus, abaqus_cube

END = 1e-3
DRIVEN = "*BOUNDARY, TYPE=VELOCITY, AMPLITUDE=a\nall, 1, 1, 30.\nall, 2, 3, 0.\n"


def driven(amplitude: str, condition: str = DRIVEN) -> str:
    """The whole cube moves with an amplitude."""
    return abaqus(abaqus_cube(), amplitude, end=END, step=condition)


def two_steps(before: str, first: str, second: str, lengths: tuple[float, float] = (4e-4, 6e-4)) -> str:
    """Two steps of explicit dynamics."""
    steps = "".join(f"*STEP\n*DYNAMIC, EXPLICIT\n, {length!r}\n{text}*OUTPUT, HISTORY, TIME INTERVAL=1e-5\n*END STEP\n"
                    for length, text in zip(lengths, (first, second)))  # fmt: skip
    return f"*HEADING\ntwo steps\n{abaqus_cube()}{before}{steps}"


PUSHED = "*CLOAD\nall, 1, 0.5\n"
RIGID = "*NODE\n9, 5., 5., 15.\n*RIGID BODY, REF NODE=9, ELSET=cube\n"
ALONG = "*BOUNDARY\n9, 2, 6\n"  # free along x
FREE_X = "*BOUNDARY\nall, 2, 3\n"
RISES = "*BOUNDARY, TYPE=ACCELERATION\nall, 1, 1, {!r}\n"
BODY_RISES = "*BOUNDARY, TYPE=ACCELERATION\n9, 1, 1, {!r}\n"


LED = "*NODE\n9, 5., 5., 35.\n*SURFACE, NAME=skin, TYPE=NODE\nall,\n*COUPLING, CONSTRAINT NAME=c, REF NODE=9, SURFACE=skin\n*KINEMATIC\n1, 2\n"
SECOND = ("*NODE, NSET=second\n" + "".join(f"{i}, {30.0 + 10.0 * x}, {10.0 * y}, {10.0 * z}\n" for i, (x, y, z) in enumerate(CORNERS, 21))
          + "*ELEMENT, TYPE=C3D8R, ELSET=second\n2, 21, 22, 23, 24, 25, 26, 27, 28\n*SOLID SECTION, ELSET=second, MATERIAL=steel\n,\n")  # fmt: skip


def begins(*rows: str) -> str:
    """Velocities at the start."""
    return "*INITIAL CONDITIONS, TYPE=VELOCITY\n" + "".join(row + "\n" for row in rows)


def speeds(*values: float) -> list:
    """Of the cube along x at 2e-4, 4e-4, 7e-4 and the end; momenta are those of half a step before."""
    return [("momentum_x", when, value * CUBE_MASS, 2e-2) for when, value in zip((2e-4, 4e-4, 7e-4, LAST), values, strict=True)]

PROOFS = [
    Proof("AMPLITUDE: NAME; BOUNDARY: TYPE AMPLITUDE; STEP; DYNAMIC: EXPLICIT",
          driven("*AMPLITUDE, NAME=a\n0., 0., 4e-4, 1., 5e-4, 0.2\n"),
          [("momentum_x", 2e-4, 15.0 * CUBE_MASS, 1e-2), ("momentum_x", LAST, 6.0 * CUBE_MASS, 1e-6)],
          "half way up the ramp, and the last value held"),
    Proof("AMPLITUDE: DEFINITION",
          driven("*AMPLITUDE, NAME=a, DEFINITION=SMOOTH STEP\n0., 0., 8e-4, 1.\n"),
          [("momentum_x", 2e-4, 30.0 * 0.103515625 * CUBE_MASS, 2e-2), ("momentum_x", LAST, 30.0 * CUBE_MASS, 1e-6)],
          "10 s^3 - 15 s^4 + 6 s^5 at s = 1/4"),
    Proof("AMPLITUDE: DEFINITION FIXED_INTERVAL BEGIN",
          driven("*AMPLITUDE, NAME=a, DEFINITION=EQUALLY SPACED, FIXED INTERVAL=2e-4, BEGIN=1e-4\n0.1, 0.9, 0.3\n"),
          [("momentum_x", 2e-4, 15.0 * CUBE_MASS, 1e-2), ("momentum_x", 0.5e-4, 3.0 * CUBE_MASS, 1e-6), ("momentum_x", LAST, 9.0 * CUBE_MASS, 1e-6)],
          "values at 1e-4, 3e-4, 5e-4, both ends held"),
    Proof("AMPLITUDE: DEFINITION",
          driven("*AMPLITUDE, NAME=a, DEFINITION=PERIODIC\n1, 6283.1853, 1e-4, 0.25\n0., 0.5\n"),
          [("momentum_x", 3.5e-4, 30.0 * 0.75 * CUBE_MASS, 2e-2), ("momentum_x", 0.5e-4, 30.0 * 0.25 * CUBE_MASS, 1e-6)],
          "0.25 + 0.5 sin w (t - t0), a quarter of a period after t0"),
    Proof("AMPLITUDE: DEFINITION",
          driven("*AMPLITUDE, NAME=a, DEFINITION=MODULATED\n0.25, 0.5, 1e-4, 6283.1853, 3141.59265\n"),
          [("momentum_x", 3.5e-4, 30.0 * (0.25 + 0.5 * math.sqrt(0.5)) * CUBE_MASS, 2e-2)],
          "0.25 + 0.5 sin(pi / 2) sin(pi / 4)"),
    Proof("AMPLITUDE: DEFINITION",
          driven("*AMPLITUDE, NAME=a, DEFINITION=DECAY\n0.25, 0.5, 1e-4, 3e-4\n"),
          [("momentum_x", 4e-4, 30.0 * (0.25 + 0.5 / math.e) * CUBE_MASS, 2e-2), ("momentum_x", 0.5e-4, 7.5 * CUBE_MASS, 1e-6)],
          "0.25 + 0.5 / e, a decay time after t0"),
    Proof("AMPLITUDE: VALUE",
          driven("*AMPLITUDE, NAME=a, VALUE=ABSOLUTE\n0., 7., 1., 7.\n"), [("momentum_x", LAST, 7.0 * CUBE_MASS, 1e-6)], "7 mm/s, whatever the condition says"),
    Proof("AMPLITUDE: INPUT", abaqus(abaqus_cube(), "*AMPLITUDE, NAME=a, INPUT=a.txt\n", end=END, step=DRIVEN), [("momentum_x", LAST, 12.0 * CUBE_MASS, 1e-6)],
          "0.4 of 30 mm/s", files={"a.txt": "0., 0.4, 1., 0.4\n"}),
    Proof("AMPLITUDE: TIME",
          two_steps("*AMPLITUDE, NAME=a, TIME=TOTAL TIME\n0., 0., 1e-3, 1.\n", "", DRIVEN),
          [("momentum_x", LAST, 30.0 * CUBE_MASS, 1e-2), ("momentum_x", 7e-4, 21.0 * CUBE_MASS, 1e-2)], "over the time of the run: 0.7 at 7e-4"),
    Proof("AMPLITUDE: TIME",
          two_steps("*AMPLITUDE, NAME=a\n0., 0., 6e-4, 1.\n", "", DRIVEN),
          [("momentum_x", 7e-4, 15.0 * CUBE_MASS, 1e-2), ("momentum_x", 3e-4, 0.0, 1e-12)], "over the time of the step, which begins at 4e-4"),
    Proof("AMPLITUDE: SMOOTH", driven("*AMPLITUDE, NAME=a, SMOOTH=0.2\n0., 0., 1., 1.\n"), refused="SMOOTH"),
    Proof("AMPLITUDE", driven("*AMPLITUDE, NAME=a\n0., 0., 5e-4, 1., 3e-4, 0.\n"), refused="do not ascend"),
    Proof("AMPLITUDE", driven("*AMPLITUDE, NAME=b\n0., 0., 5e-4, 1.\n"), refused="there is no amplitude"),
    Proof("BOUNDARY: TYPE AMPLITUDE",
          driven("*AMPLITUDE, NAME=a\n0., 0., 1e-3, 1.\n", "*BOUNDARY, AMPLITUDE=a\nall, 1, 1, 0.02\nall, 2, 3\n"),
          [("momentum_x", LAST, 20.0 * CUBE_MASS, 1e-3)], "0.02 mm in 1e-3 s"),
    Proof("BOUNDARY: TYPE",
          driven("*AMPLITUDE, NAME=a\n0., 1., 1., 1.\n", "*INITIAL CONDITIONS, TYPE=VELOCITY\nall, 1, 5.\n*BOUNDARY, TYPE=ACCELERATION, AMPLITUDE=a\nall, 1, 1, 2e4\nall, 2, 3\n"),
          [("momentum_x", LAST, 25.0 * CUBE_MASS, 1e-2)], "5 mm/s and 1e-3 s of 2e4 mm/s^2"),
    *[Proof("BOUNDARY: TYPE; INITIAL CONDITIONS: TYPE", two_steps(RIGID + ALONG + begins(*rows), BODY_RISES.format(-2e4), ""), speeds(11.0, 7.0, 1.0, -5.0), "15 mm/s of a rigid body, and 1e-3 s of -2e4 mm/s^2")
      for rows in (("9, 1, 15.",), ("all, 1, 15.",), ("9, 1, 15.", "all, 1, 15."), ("9, 1, 15.", "all, 1, 3."))],
    Proof("BOUNDARY: TYPE; INITIAL CONDITIONS: TYPE", two_steps(RIGID.replace("cube\n", "cube, POSITION=CENTER OF MASS\n") + "*BOUNDARY\n9, 1, 5\n" + begins("9, 6, 15."), "*BOUNDARY, TYPE=ACCELERATION\n9, 6, 6, -2e4\n", ""),
          [("angular_z", when, (15.0 - 2e4 * when) * CUBE_MASS * 200.0 / 12.0, 2e-2) for when in (2e-4, 4e-4, 1e-3)], "the moment of inertia is m (a^2 + a^2) / 12; 15 rad/s and -2e4 rad/s^2"),
    Proof("BOUNDARY: TYPE; INITIAL CONDITIONS: TYPE", two_steps(RIGID + ALONG + begins("all, 1, 15.", "7, 1, 3."), BODY_RISES.format(-2e4), ""), refused="whose velocity at the start is not known"),
    Proof("BOUNDARY: TYPE", two_steps(FREE_X + begins("all, 1, 15."), RISES.format(-2e4), RISES.format(-4e4)), speeds(11.0, 7.0, -5.0, -17.0), "15, then 15 - 8, then 7 - 24 mm/s"),
    Proof("BOUNDARY: TYPE OP", two_steps(begins("all, 1, 15."), RISES.format(-2e4) + FREE_X.replace("*BOUNDARY\n", ""), RISES.format(-4e4).replace("*BOUNDARY", "*BOUNDARY, OP=NEW") + FREE_X),
          speeds(11.0, 7.0, -5.0, -17.0), "with OP=NEW the velocity of the moment stays"),
    Proof("BOUNDARY: TYPE", two_steps(RIGID + ALONG + begins("9, 1, 15."), BODY_RISES.format(-2e4), BODY_RISES.format(-4e4)), speeds(11.0, 7.0, -5.0, -17.0), "a rigid body likewise"),
    Proof("BOUNDARY: TYPE AMPLITUDE", two_steps(FREE_X + begins("all, 1, 15.") + "*AMPLITUDE, NAME=a\n0., 0., 4e-4, 1.\n", RISES.format(-2e4).replace("ON\n", "ON, AMPLITUDE=a\n"), RISES.format(-4e4)),
          speeds(14.0, 11.0, -1.0, -13.0), "a ramp from 0 to -2e4 mm/s^2 takes 4 mm/s"),
    Proof("BOUNDARY: TYPE AMPLITUDE", two_steps(FREE_X + "*AMPLITUDE, NAME=a\n0., 1., 4e-4, 0.4\n", "*BOUNDARY, TYPE=VELOCITY, AMPLITUDE=a\nall, 1, 1, 30.\n", RISES.format(-4e4)),
          speeds(21.0, 12.0, 0.0, -12.0), "from the 12 mm/s with which the step before ended"),
    Proof("BOUNDARY: TYPE AMPLITUDE", two_steps(FREE_X + "*AMPLITUDE, NAME=a\n0., 0., 3e-4, 0.2, 4e-4, 1.\n", "*BOUNDARY, AMPLITUDE=a\nall, 1, 1, 2e-3\n", RISES.format(-4e4)),
          [("momentum_x", 7e-4, 4.0 * CUBE_MASS, 2e-2), ("momentum_x", LAST, -8.0 * CUBE_MASS, 2e-2)], "a displacement ends with 0.8 of 2e-3 mm in 1e-4 s, 16 mm/s"),
    Proof("BOUNDARY: TYPE", two_steps(FREE_X + "*BOUNDARY\nall, 1\n", "", RISES.format(-4e4)), speeds(0.0, 0.0, -12.0, -24.0)[2:], "held through a step, it begins at rest"),
    Proof("BOUNDARY: TYPE", two_steps("*NSET, NSET=up\n5, 6, 7, 8\n" + FREE_X + begins("all, 1, 5.", "up, 1, 9."), RISES.format(-2e4), RISES.format(-4e4)),
          speeds(3.0, -1.0, -13.0, -25.0), "four nodes begin with 5 mm/s, four with 9"),
    Proof("BOUNDARY: TYPE; INITIAL CONDITIONS: TYPE", two_steps("*INITIAL CONDITIONS, TYPE=ROTATING VELOCITY\nall, 3., 15., 0., 0.\n5., 5., 0., 6., 5., 0.\n", RISES.format(-2e4), ""),
          speeds(11.0, 7.0, 1.0, -5.0), "15 mm/s along the axis about which it turns"),
    Proof("BOUNDARY: TYPE; INITIAL CONDITIONS: TYPE; KINEMATIC", two_steps(LED + begins("all, 1, 15.") + "*BOUNDARY\nall, 3\n9, 2, 6\n", BODY_RISES.format(-2e4), BODY_RISES.format(-4e4)), speeds(11.0, 7.0, -5.0, -17.0),
          "a node without elements begins with the velocity of those that follow it"),
    Proof("INITIAL CONDITIONS: TYPE", two_steps(RIGID + SECOND + begins("second, 1, 15.", "all, 1, 3.", "9, 1, 15."), "", ""), [("momentum_x", ALL, 2 * 15.0 * CUBE_MASS, 1e-9)],
          "that of the reference node is the one of the body, whatever others have"),
    Proof("BOUNDARY: TYPE OP", two_steps(FREE_X + begins("all, 1, 15."), PUSHED, RISES.format(-2e4)), refused="from a velocity that is not known"),
    Proof("BOUNDARY: TYPE OP", two_steps(RIGID + begins("9, 1, 15."), ALONG, BODY_RISES.format(-2e4)), refused="from a velocity that is not known"),
    Proof("BOUNDARY: TYPE AMPLITUDE", two_steps(FREE_X + "*AMPLITUDE, NAME=a, DEFINITION=SMOOTH STEP\n0., 0., 5e-4, 1.\n", "*BOUNDARY, AMPLITUDE=a\nall, 1, 1, 2e-3\n", RISES.format(-4e4)),
          refused="from a velocity that is not known"),
    Proof("BOUNDARY",
          abaqus(abaqus_cube(), "*BOUNDARY\nall, XSYMM\nall, 2, 2\n", PUSHED.replace("*CLOAD", "*INITIAL CONDITIONS, TYPE=VELOCITY").replace("0.5", "3."),
                 step="*CLOAD\nall, 1, 1.\nall, 2, 1.\nall, 3, 1.\n"),
          [("momentum_x", LAST, 0.0, 1e-15), ("momentum_y", LAST, 0.0, 1e-15), ("momentum_z", LAST, 8e-5, 6e-2)], "x by XSYMM and y are held, z is free"),
    Proof("BOUNDARY: OP; CLOAD; STEP; DYNAMIC",
          two_steps("*BOUNDARY\nall, 1, 3\n", PUSHED, "*BOUNDARY, OP=NEW\nall, 2, 3\n"),
          [("momentum_x", 4e-4, 0.0, 1e-12), ("momentum_x", LAST, 8 * 0.5 * 6e-4, 1e-2)], "held for a step, then pushed by 4 N"),
    Proof("BOUNDARY: OP",
          two_steps("", PUSHED, "*BOUNDARY\nall, 1, 3\n"),
          [("momentum_x", 3.9e-4, 8 * 0.5 * 3.9e-4, 1e-2), ("momentum_x", LAST, 0.0, 1e-12)], "pushed by 4 N, then held"),
    Proof("BOUNDARY: OP", two_steps(f"{RIGID}*BOUNDARY\n9, 1, 6\n", "*CLOAD\n9, 1, 4.\n", "*BOUNDARY, OP=NEW\n9, 2, 6\n"),
          [("momentum_x", 4e-4, 0.0, 1e-12), ("momentum_x", LAST, 4.0 * 6e-4, 1e-2)], "a rigid body that is held for a step, then pushed by 4 N"),
    Proof("BOUNDARY: OP TYPE", two_steps(f"{RIGID}{ALONG}", "*BOUNDARY, TYPE=VELOCITY\n9, 1, 1, 30.\n", "*BOUNDARY, OP=NEW\n9, 2, 6\n*CLOAD\n9, 1, 4.\n"),
          [("momentum_x", 2e-4, 30.0 * CUBE_MASS, 1e-6), ("momentum_x", LAST, 30.0 * CUBE_MASS + 4.0 * 6e-4, 1e-2)], "a rigid body that is driven for a step, then pushed by 4 N"),
    Proof("BOUNDARY: OP AMPLITUDE", two_steps(f"{RIGID}{ALONG}*AMPLITUDE, NAME=a\n0., 0., 4e-4, 1.\n", "*BOUNDARY, AMPLITUDE=a\n9, 1, 1, 0.012\n", "*BOUNDARY, OP=NEW\n9, 2, 6\n"),
          [("momentum_x", LAST, 30.0 * CUBE_MASS, 1e-3)], "a rigid body goes on with the speed of its displacement: 0.012 mm in 4e-4 s"),
    Proof("BOUNDARY: OP TYPE", two_steps(f"{RIGID}{ALONG}*INITIAL CONDITIONS, TYPE=VELOCITY\n9, 1, 5.\nall, 1, 5.\n", "", "*BOUNDARY, TYPE=VELOCITY\n9, 1, 1, 30.\n"),
          [("momentum_x", 2e-4, 5.0 * CUBE_MASS, 1e-6), ("momentum_x", LAST, 30.0 * CUBE_MASS, 1e-6)], "a rigid body that is driven from the second step on"),
    Proof("BOUNDARY: OP", two_steps(f"{RIGID}*BOUNDARY\n9, 1, 3\n", "*CLOAD\n9, 1, 4.\n", "*BOUNDARY, OP=NEW\n9, 2, 3\n"), refused="a reference node away from the centre"),
    Proof("CLOAD: OP AMPLITUDE",
          two_steps("*AMPLITUDE, NAME=a\n0., 0., 4e-4, 1.\n", "*CLOAD, AMPLITUDE=a\nall, 1, 0.5\n", ""),
          [("momentum_x", 4e-4, 8 * 0.25 * 4e-4, 2e-2), ("momentum_x", LAST, 8 * (0.25 * 4e-4 + 0.5 * 6e-4), 1e-2)], "a ramp, whose last value goes on"),
    Proof("CLOAD: OP", two_steps("", PUSHED, "*CLOAD, OP=NEW\nall, 2, 0.25\n"),
          [("momentum_x", LAST, 8 * 0.5 * 4e-4, 1e-2), ("momentum_y", LAST, 8 * 0.25 * 6e-4, 1e-2)], "the first load ends with its step"),
    Proof("CLOAD: OP", two_steps("", PUSHED, "*CLOAD\nall, 1, 0.1\n"),
          [("momentum_x", LAST, 8 * (0.5 * 4e-4 + 0.1 * 6e-4), 1e-2)], "the second load takes the place of the first"),
    Proof("CLOAD: FOLLOWER", abaqus(abaqus_cube(), step="*CLOAD, FOLLOWER\nall, 1, 0.5\n"), refused="FOLLOWER"),
    Proof("DLOAD: OP", two_steps("", "*DLOAD\ncube, P1, 0.04\n", "*DLOAD, OP=NEW\n"), [("momentum_z", LAST, 0.04 * 100 * 4e-4, 1e-2)], "4 N on the lower face for a step"),
    Proof("DLOAD: OP", two_steps("", "*DLOAD\n, GRAV, 1e4, 1., 0., 0.\n", "*DLOAD\n, GRAV, 2e4, 0., 1., 0.\n"), refused="gravity along another direction"),
    Proof("DLOAD: OP", two_steps("", "*DLOAD\n, GRAV, 1e4, 1., 0., 0.\n", "*DLOAD\n, GRAV, 2e4, -2., 0., 0.\n"), [("momentum_x", LAST, (1e4 * 4e-4 - 2e4 * 6e-4) * CUBE_MASS, 1e-2)],
          "gravity that turns round in the second step"),
    Proof("DLOAD: OP", two_steps("", "*DLOAD\n, GRAV, 1e4, 1., 0., 0.\n", "*DLOAD, OP=NEW\n, GRAV, 2e4, 0., 1., 0.\n"),
          [("momentum_x", LAST, 1e4 * 4e-4 * CUBE_MASS, 1e-2), ("momentum_y", LAST, 2e4 * 6e-4 * CUBE_MASS, 1e-2)], "one gravity after the other"),
    Proof("DSLOAD: OP", two_steps("*SURFACE, NAME=low\ncube, S1\n", "*DSLOAD\nlow, P, 0.04\n", "*DSLOAD, OP=NEW\n"),
          [("momentum_z", LAST, 0.04 * 100 * 4e-4, 1e-2)], "4 N on the lower face for a step"),
    Proof("STATIC", abaqus(abaqus_cube(), step="*END STEP\n*STEP\n*STATIC\n1., 1.\n"), refused="not explicit dynamics"),
    Proof("FREQUENCY", abaqus(abaqus_cube(), step="*END STEP\n*STEP\n*FREQUENCY\n10,\n"), refused="not explicit dynamics"),
    Proof("DYNAMIC: SCALE_FACTOR", abaqus(abaqus_cube(), "*INITIAL CONDITIONS, TYPE=VELOCITY\nall, 1, 4.\n", end=1e-5).replace("EXPLICIT\n", "EXPLICIT, SCALE FACTOR=0.45\n"),
          [(lambda h: h["step"][-1] / 1e-5 * 10.0 / math.sqrt(2.1e5 * 0.7 / (1.3 * 0.4) / 7.8e-9), LAST, math.sqrt(3) / 0.45, 0.1)], "0.45 of the stable step of a cube, whose volume swings fastest: L / (c sqrt(3))"),
    Proof("RESTART", abaqus(abaqus_cube()).replace("*HEADING", "*RESTART, READ, STEP=1\n*HEADING"), refused="another job"),
    Proof("TRANSFORM: NSET TYPE", abaqus(abaqus_cube(), "*TRANSFORM, NSET=all\n0., 1., 0., -1., 0., 0.\n*BOUNDARY\nall, 1\n"), refused="TRANSFORM"),
    Proof("TRANSFORM: NSET TYPE", abaqus(abaqus_cube(), "*TRANSFORM, NSET=all, TYPE=C\n0., 0., 0., 0., 0., 1.\n*BOUNDARY\nall, 1\n"), refused="TRANSFORM"),
    Proof("ENDSTEP", abaqus(abaqus_cube(), "*INITIALCONDITIONS, TYPE=VELOCITY\nall, 1, 9.\n").replace("*END STEP", "*ENDSTEP"),
          [("momentum_x", ALL, 9.0 * CUBE_MASS, 1e-9)], "blanks in keywords do not count"),
    Proof("END STEP", abaqus(abaqus_cube()).replace("*END STEP", "*EMD STEP"), refused="did you mean *END STEP?"),
]  # fmt: skip

NOT_PHYSICS = {
    **{f"DYNAMIC.{word}": "numerics: percuss chooses its step" for word in ("DIRECT USER CONTROL", "ELEMENT BY ELEMENT", "FIXED TIME INCREMENTATION", "IMPROVED DT METHOD")},
    **{f"DYNAMIC TEMPERATURE-DISPLACEMENT.{word}": "as of *DYNAMIC" for word in ("DIRECT USER CONTROL", "ELEMENT BY ELEMENT", "FIXED TIME INCREMENTATION",
                                                                              "IMPROVED DT METHOD", "EXPLICIT", "SCALE FACTOR")},
    "STEP.NAME": "a name", "STEP.NLGEOM": "the report says that displacements may be large",
}  # fmt: skip
