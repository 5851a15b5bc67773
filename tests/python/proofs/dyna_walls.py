"""Rigid walls. A rigid cube that meets a wall flat stays on it; one that a wall pushes gets its speed."""

from . import ALL, LAST, Proof
from .pieces import CUBE_MASS, cube, curve, deck, node_set, nodes, rigid, velocity

END = 1e-4
CONSTANT = curve(7, (0, 1.0), (1, 1.0))
FLOOR = "*RIGIDWALL_PLANAR\n{set},{exempt},{box},{offset},{birth},{death}\n0,0,-1.0,0,0,9.0,{friction}\n"
FALLING = (cube(rigid()), velocity(0.0, 0.0, -2e4))  # 1 mm in half of the time


def floor(**more: float) -> str:
    return FLOOR.format(**({"set": 0, "exempt": 0, "box": 0, "offset": 0, "birth": 0, "death": 0, "friction": 0} | more))


STOPPED = [("momentum_z", LAST, 0.0, 1e-3 * 2e4 * CUBE_MASS)]  # the contact is solved to 1e-3
BORN = [(lambda h: max(abs(p + 2e4 * CUBE_MASS) for t, p in zip(h["time"], h["momentum_z"]) if t < 6.9e-5), LAST, 0.0, 1e-9 * 2e4 * CUBE_MASS)]
PASSED = [("momentum_z", LAST, -2e4 * CUBE_MASS, 1e-6)]
PUSHED = [("momentum_z", LAST, 3e4 * CUBE_MASS, 1e-3)]
MOTION = "*RIGIDWALL_GEOMETRIC_{shape}_MOTION\n0\n{at}\n{size}\n7,{opt},0,0,1.0\n"
RISING = {"shape": "FLAT", "at": "0,0,-1.0,0,0,9.0", "size": "10.0,0,-1.0,0,0", "opt": 0}

PROOFS = [
    Proof("RIGIDWALL_PLANAR: XT YT ZT XH YH ZH", deck(*FALLING, floor(), end=END), STOPPED, "a plane at z = -1"),
    Proof("RIGIDWALL_PLANAR: ZT", deck(*FALLING, floor().replace("0,0,-1.0", "0,0,-3.0"), end=END), PASSED, "a plane farther away than it comes"),
    Proof("RIGIDWALL_PLANAR: NSID; RIGIDWALL_PLANAR: NSIDEX", deck(*FALLING, node_set(4, 1, 2, 3, 4), floor(exempt=4), end=END), PASSED, "its lower nodes are exempted"),
    Proof("RIGIDWALL_PLANAR: NSID OFFSET", deck(*FALLING, node_set(4, 5, 9999), "*RIGIDWALL_PLANAR\n4,0,0,5.0\n0,0,-1.0,0,0,1.0\n", end=END), refused="there is no node 9999"),
    Proof("RIGIDWALL_PLANAR: NSID", deck(*FALLING, node_set(4, 5, 6, 7, 8), floor(set=4), end=END), PASSED, "the upper nodes alone"),
    Proof("RIGIDWALL_PLANAR: BOXID; DEFINE_BOX", deck(*FALLING, "*DEFINE_BOX\n3,-1.0,11.0,-1.0,11.0,9.0,11.0\n", floor(box=3), end=END), PASSED, "the upper nodes alone"),
    Proof("RIGIDWALL_PLANAR: OFFSET", deck(*FALLING, floor(offset=0.5), end=END), PASSED, "no node is so near"),
    Proof("RIGIDWALL_PLANAR: OFFSET", deck(*FALLING, node_set(4, *range(1, 9)), floor(set=4, offset=0.5), end=END), PASSED, "of a set too"),
    Proof("RIGIDWALL_PLANAR: BIRTH", deck(*FALLING, floor(birth=7e-5), end=END), [*STOPPED, *BORN], "the cube comes to the wall at 5e-5, and is stopped from 7e-5 on"),
    Proof("RIGIDWALL_PLANAR: DEATH", deck(*FALLING, floor(death=1e-5), end=END), PASSED, "it ends before the cube comes"),
    Proof("RIGIDWALL_PLANAR: BIRTH DEATH", deck(*FALLING, floor(birth=1e-5, death=7e-5), end=END), STOPPED, "it acts when the cube comes"),
    Proof("RIGIDWALL_GEOMETRIC_FLAT: BIRTH", deck(*FALLING, "*RIGIDWALL_GEOMETRIC_FLAT\n0,0,0,7e-5\n0,0,-1.0,0,0,9.0\n10.0,0,-1.0,12.0,12.0\n", end=END), [*STOPPED, *BORN], "a rectangle too"),
    Proof("RIGIDWALL_GEOMETRIC_FLAT: DEATH", deck(*FALLING, "*RIGIDWALL_GEOMETRIC_FLAT\n0,0,0,0,1e-5\n0,0,-1.0,0,0,9.0\n10.0,0,-1.0,12.0,12.0\n", end=END), PASSED, "a rectangle too"),
    Proof("RIGIDWALL_GEOMETRIC_FLAT_MOTION: BIRTH", deck(cube(rigid(1, 1, 0, 7)), MOTION.format(**RISING).replace("MOTION\n0\n", "MOTION\n0,0,0,7e-5\n"), curve(7, (0, 3e4), (1, 3e4)), end=END), refused="moves with a birth time"),
    Proof("RIGIDWALL_PLANAR: FRIC", deck(cube(rigid(1, 1, 0, 7)), velocity(1e4, 0.0, -2e4), floor(friction=0.25), end=END),
          [("momentum_x", LAST, 0.5e4 * CUBE_MASS, 1e-2)], "the impulse of the impact times 0.25"),
    Proof("RIGIDWALL_PLANAR: FRIC", deck(cube(rigid(1, 1, 0, 7)), velocity(1e4, 0.0, -2e4), floor(friction=1.0), end=END),
          [("momentum_x", LAST, 0.0, 1e-6 * 1e4 * CUBE_MASS)], "1: no sliding"),
    Proof("RIGIDWALL_PLANAR: FRIC", deck(*FALLING, floor(friction=2.0), end=END), refused="stick to the wall"),
    Proof("RIGIDWALL_PLANAR: WVEL", deck(*FALLING, floor(friction="0,5.0"), end=END), refused="WVEL"),
    Proof("RIGIDWALL_PLANAR_FINITE: XHEV YHEV ZHEV LENL LENM", deck(*FALLING, floor().replace("PLANAR", "PLANAR_FINITE") + "9.0,0,-1.0,12.0,12.0\n", end=END), STOPPED, "from the origin 12 by 12"),
    Proof("RIGIDWALL_PLANAR_FINITE: XHEV", deck(*FALLING, floor().replace("PLANAR", "PLANAR_FINITE").replace("0,0,-1.0,0,0,9.0", "-20.0,0,-1.0,-20.0,0,9.0") + "9.0,0,-1.0,12.0,12.0\n", end=END),
          PASSED, "beside the cube"),
    Proof("RIGIDWALL_PLANAR_FINITE: LENM", deck(*FALLING, floor().replace("PLANAR", "PLANAR_FINITE") + "9.0,0,-1.0,12.0,0\n", end=END), refused="one length"),
    Proof("RIGIDWALL_PLANAR_MOVING: MASS V0",
          deck(cube(), velocity(0.0, 0.0, -2e4), floor().replace("PLANAR", "PLANAR_MOVING") + "2e-5,1e4\n", end=END),
          [(lambda h: h["momentum_z"][-1] + 2e-5 * h["wall_speed:wall_1"][-1], LAST, 2e-5 * 1e4 - 2e4 * CUBE_MASS, 1e-3), (lambda h: abs(h["momentum_z"][-1] + 2e4 * CUBE_MASS) > 0.01, LAST, 1.0, 0.0)],
          "momentum of both is conserved, and the cube has met the wall"),
    Proof("RIGIDWALL_PLANAR_MOVING: MASS", deck(*FALLING, floor().replace("PLANAR", "PLANAR_MOVING") + "2e-5,1e4\n", end=END), refused="beside rigid parts"),
    Proof("RIGIDWALL_PLANAR_ORTHO", deck(*FALLING, floor().replace("PLANAR", "PLANAR_ORTHO") + "0.1,0.2\n0,0,1,0,0\n", end=END), refused="RIGIDWALL_PLANAR_ORTHO"),
    Proof("RIGIDWALL_PLANAR_FORCES", deck(*FALLING, floor().replace("PLANAR", "PLANAR_FORCES") + "3,0,1,2,3,4\n", end=END), STOPPED, "output"),
    Proof("RIGIDWALL_GEOMETRIC_FLAT: XT YT ZT XH YH ZH LENL LENM", deck(*FALLING, "*RIGIDWALL_GEOMETRIC_FLAT\n0\n0,0,-1.0,0,0,9.0\n10.0,0,-1.0,12.0,12.0\n", end=END), STOPPED, "a rectangle"),
    Proof("RIGIDWALL_GEOMETRIC_FLAT_MOTION: LCID OPT VX VY VZ", deck(cube(rigid(1, 1, 0, 7)), MOTION.format(**RISING), curve(7, (0, 3e4), (1, 3e4)), end=END), PUSHED, "it pushes with its speed"),
    Proof("RIGIDWALL_GEOMETRIC_FLAT_MOTION: OPT", deck(cube(rigid(1, 1, 0, 7)), MOTION.format(**(RISING | {"opt": 1})), curve(7, (0, 0.0), (1e-4, 3.0)), end=END),
          PUSHED, "3 mm in 1e-4 s"),
    Proof("RIGIDWALL_GEOMETRIC_FLAT_MOTION: VX", deck(cube(rigid()), MOTION.format(**RISING).replace("0,0,1.0\n", "0,1.0,1.0\n"), CONSTANT, end=END), refused="moves along itself"),
    Proof("RIGIDWALL_GEOMETRIC_SPHERE_MOTION: XT YT ZT RADSPH LCID",
          deck(cube(rigid(1, 1, 4, 7)), nodes((50, 5.0, 5.0, 0.0)), "*CONSTRAINED_EXTRA_NODES_NODE\n1,50\n", MOTION.format(shape="SPHERE", at="0,0,-6.0,0,0,9.0", size="5.0", opt=0), curve(7, (0, 3e4), (1, 3e4)), end=END),
          PUSHED, "a ball below a corner"),
    Proof("RIGIDWALL_GEOMETRIC_CYLINDER_MOTION: XT YT ZT XH YH ZH RADCYL LENCYL LCID",
          deck(cube(rigid(1, 1, 4, 7)), MOTION.format(shape="CYLINDER", at="0,-5.0,-6.0,0,5.0,-6.0", size="5.0,20.0", opt=0), curve(7, (0, 3e4), (1, 3e4)), end=END), PUSHED, "along y below an edge"),
    Proof("RIGIDWALL_GEOMETRIC_CYLINDER_MOTION: LENCYL",
          deck(cube(rigid(1, 1, 4, 7)), MOTION.format(shape="CYLINDER", at="0,-25.0,-6.0,0,5.0,-6.0", size="5.0,20.0", opt=0), curve(7, (0, 3e4), (1, 3e4)), end=END),
          [("momentum_z", ALL, 0.0, 1e-12)], "it ends before the cube"),
    *(Proof(f"RIGIDWALL_GEOMETRIC_FLAT: {name}", deck(*FALLING, cards, f"*RIGIDWALL_GEOMETRIC_FLAT\n{fields}\n0,0,-1.0,0,0,9.0\n10.0,0,-1.0,12.0,12.0\n", end=END), PASSED, "its lower nodes are not stopped")
      for name, fields, cards in (("NSID", "4", node_set(4, 5, 6, 7, 8)), ("NSIDEX", "0,4", node_set(4, 1, 2, 3, 4)), ("BOXID", "0,0,3", "*DEFINE_BOX\n3,-1.0,11.0,-1.0,11.0,9.0,11.0\n"))),
    Proof("RIGIDWALL_GEOMETRIC_FLAT: FRIC", deck(cube(rigid(1, 1, 0, 7)), velocity(1e4, 0.0, -2e4), "*RIGIDWALL_GEOMETRIC_FLAT\n0\n0,0,-1.0,0,0,9.0,0.25\n10.0,0,-1.0,0,0\n", end=END),
          [("momentum_x", LAST, 0.5e4 * CUBE_MASS, 1e-2)], "the impulse of the impact times 0.25"),
    Proof("RIGIDWALL_GEOMETRIC_CYLINDER_MOTION: NSEGS",
          deck(cube(rigid(1, 1, 4, 7)), MOTION.format(shape="CYLINDER", at="0,-5.0,-6.0,0,5.0,-6.0", size="5.0,20.0,1\n2.0,3.0", opt=0), curve(7, (0, 3e4), (1, 3e4)), end=END), PUSHED, "a line of output"),
    Proof("RIGIDWALL_GEOMETRIC_PRISM", deck(*FALLING, "*RIGIDWALL_GEOMETRIC_PRISM\n0\n0,0,-1.0,0,0,9.0\n10.0,0,-1.0,12.0,12.0\n3.0\n", end=END), refused="RIGIDWALL_GEOMETRIC_PRISM"),
]  # fmt: skip
