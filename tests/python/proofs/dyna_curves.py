"""Curves over time, by the force on four nodes."""

from . import LAST, Proof
from .pieces import cube, curve, deck, force, node_set

END = 1e-3


def pushed(cards: str, load: str = "*LOAD_NODE_SET\n5,3,7,1.0\n") -> str:
    return deck(cube(), node_set(5, 5, 6, 7, 8), cards, load, end=END)


def impulse(cards: str, value: float, proves: str, why: str) -> Proof:
    """Momentum at the end; the last half step is 0.1 % of the time."""
    return Proof(proves, pushed(cards), [("momentum_z", LAST, value, 2e-3)], why)


PROOFS = [
    Proof("DEFINE_CURVE: LCID SFO OFFO A O; LOAD_NODE_SET: NSID DOF LCID SF", pushed(curve(7, (0, 2.0), (1, 2.0), more=",0,1.0,3.0,0.0,1.0")),
          [(force("z"), LAST, 4 * 9.0, 1e-6)], "SFO (O + OFFO) = 9 N on each of four nodes"),
    impulse(curve(7, (0, 0.0), (0.25, 0.0), (0.25, 8.0), (9, 8.0), more=",0,1e-3,1.0,0.25"), 4 * 8.0 * 0.5e-3, "DEFINE_CURVE: SFA OFFA",
            "SFA (A + OFFA): 8 N from 0.5 ms on"),
    impulse(curve(7, (0, 0.0), (0.5e-3, 0.0), (0.5e-3, 8.0), (1e20, 8.0)), 4 * 8.0 * 0.5e-3, "DEFINE_CURVE: A", "a vertical step stays one, wherever the last row is"),
    *(impulse(curve(7, *first, (0, 0.0), (0, 8.0), (1e10, 8.0)), 4 * 8.0 * 1e-3, "DEFINE_CURVE: A", "a step at time 0 acts from there on, wherever the last row is")
      for first in ([], [(-1.0, 0.0)])),
    impulse(curve(7, (0, 8.0), (0.25e-3, 8.0)), 4 * 8.0 * 0.25e-3, "DEFINE_CURVE: A", "a load is 0 behind its last row"),
    impulse(curve(7, (0.25e-3, 8.0), (1, 8.0)), 4 * 8.0 * 0.75e-3, "DEFINE_CURVE: A", "a load is 0 before its first row"),
    impulse(curve(7, (0, 0.0), (1e-3, 8.0)), 4 * 4.0 * 1e-3, "DEFINE_CURVE: O", "a ramp has half the impulse"),
    impulse(curve(7, (0, 8.0), (1, 8.0), more=",1"), 0.0, "DEFINE_CURVE: SIDR", "SIDR 1 acts in dynamic relaxation alone"),
    impulse(curve(7, (0, 8.0), (1, 8.0), more=",2"), 4 * 8.0 * 1e-3, "DEFINE_CURVE: SIDR", "SIDR 2 acts in the run too"),
    Proof("DEFINE_CURVE: SIDR", pushed(curve(7, (0, 8.0), (1, 8.0), more=",1") + "*CONTROL_DYNAMIC_RELAXATION\n0,0,0,0,0,0,0,1\n"), refused="DEFINE_CURVE.SIDR"),
    Proof("DEFINE_CURVE: SIDR", pushed(curve(7, (0, 8.0), (1, 8.0)) + "*CONTROL_DYNAMIC_RELAXATION\n0,0,0,0,0,0,0,1\n"), refused="DEFINE_CURVE.SIDR"),
    Proof("DEFINE_CURVE: DATTYP", pushed(curve(7, (0, 8.0), (1, 8.0), more=",0,1.0,1.0,0.0,2.0,1")), refused="DEFINE_CURVE.DATTYP"),
    Proof("DEFINE_CURVE: DATTYP", pushed(curve(7, (0, 8.0), (1, 8.0), more=",0,1.0,1.0,0.0,0.0,-2")), refused="DEFINE_CURVE.DATTYP"),
    Proof("DEFINE_CURVE: A", pushed(curve(7, (0, 0.0), (2e-4, 1.0), (1e-4, 2.0))), refused="A of *DEFINE_CURVE is '0.0001'"),
    impulse("*DEFINE_CURVE_SMOOTH\n7,0,4e-3,1e-4,9e-4,2e-4\n", 4 * 4e-3, "DEFINE_CURVE_SMOOTH: LCID DIST TSTART TEND TRISE", "DIST is the area under the curve"),
    impulse("*DEFINE_CURVE_SMOOTH\n7,1,4e-3,1e-4,9e-4,2e-4\n", 0.0, "DEFINE_CURVE_SMOOTH: SIDR", "SIDR 1 acts in dynamic relaxation alone"),
    impulse("*DEFINE_CURVE_SMOOTH\n7,0,4e-3,1e-4,0,2e-4,8.0\n", 4 * 4e-3, "DEFINE_CURVE_SMOOTH: VMAX", "the time at VMAX follows from DIST"),
]  # fmt: skip

NOT_PHYSICS = {"DEFINE_CURVE_": "a card that uses it is refused", "DEFINE_FUNCTION": "a card that uses it is refused"}
