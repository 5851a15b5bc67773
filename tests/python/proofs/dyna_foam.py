"""Foam with curves for several rates: a cube of 10 mm whose faces are led, with the stress of its curves at the end."""

from . import LAST, Proof
from .pieces import CORNERS, cube, curve, deck, node_set

END = 1e-3
DENSITY = 7.8e-11  # light, so that the run has some hundred steps
XX, ZZ = "element_1_stress_xx", "element_1_stress_zz"
SLOW, MIDDLE, FAST = ((0.0, 0.0), (0.1, 2.0), (0.6, 3.0), (0.9, 20.0)), ((0.0, 0.0), (0.1, 4.0), (0.6, 5.0), (0.9, 25.0)), ((0.0, 0.0), (0.2, 7.0), (0.9, 9.0))
PULLED = (((-0.5, -4.0), (-0.1, -3.0), (0.0, 0.0), (0.9, 9.0)), ((-0.5, -9.0), (0.0, 0.0), (0.9, 12.0)), ((-0.5, -12.0), (0.0, 0.0), (0.9, 15.0)))
TABLE = "*DEFINE_TABLE_2D\n20\n0.1,31\n100.0,32\n600.0,33\n"
# at the strain 0.35
AT_SLOW, AT_MIDDLE, AT_FAST = 2.5, 4.5, 7.0 + 0.15 / 0.7 * 2.0


def foam(first="0,0,0,20", flags="0,1,1,0,0,0,0,0", more="", table=TABLE, curves=(SLOW, MIDDLE, FAST), path=((0.0, 0.0), (END, -3.5)), side=0.0):
    """first: TC, FAIL, DAMP, TBID; path: of the top along z; side: motion of the face x+ at the end."""
    material = f"*MAT_FU_CHANG_FOAM\n1,{DENSITY!r},20.0,0,{first}\n{flags}\n{more}"
    sets = "".join(node_set(d + 1, *(i for i, corner in enumerate(CORNERS, 1) if corner[d] == 1)) for d in range(3))
    sets += "".join(node_set(d + 4, *(i for i, corner in enumerate(CORNERS, 1) if corner[d] == 0)) for d in range(3))
    held = "*BOUNDARY_SPC_SET\n4,0,1,0,0\n5,0,0,1,0\n6,0,0,0,1\n2,0,0,1,0\n"
    moves = "*BOUNDARY_PRESCRIBED_MOTION_SET\n3,3,2,7\n1,1,2,8\n" + curve(7, *path) + curve(8, (0.0, 0.0), (END, side))
    tables = table + "".join(curve(31 + k, *rows) for k, rows in enumerate(curves))
    return deck(cube(material), tables, sets, held, moves, "*DATABASE_HISTORY_SOLID\n1\n*DATABASE_ELOUT\n1e-5\n", end=END)  # fmt: skip


def at(rate, low=AT_MIDDLE, high=AT_FAST):
    return low + (rate - 100.0) / 500.0 * (high - low)


SHAPE = "0\n0,0,0,0,0,0,0,2.0\n"
BACK = ((0.0, 0.0), (END / 2, -6.0), (END, -3.0))  # strains of 0.6 and 0.3: stored 1.35 and 0.54
LOSS = 0.8 * (1 - 0.4**2.0)
UP = ((0.0, 0.0), (END, 3.0))

PROOFS = [
    Proof("MAT_FU_CHANG_FOAM: MID RO E TBID SFLAG", foam(), [(ZZ, LAST, -at(350.0), 5e-3)], "a nominal rate of 350, half way between the curves of 100 and 600"),
    Proof("MAT_FU_CHANG_FOAM: SFLAG RFLAG SRAF", foam(flags="0,0,0,0,0,1"), [(ZZ, LAST, -at(350.0 / 0.65), 5e-3)],
          "the same in the rate of the logarithm; RFLAG 0 as 1 where one direction strains"),
    Proof("MAT_FU_CHANG_FOAM: RFLAG", foam(flags="0,0,2", side=-0.2), [(ZZ, LAST, -at(350.0 / 0.65 + 20.0 / 0.98) / 0.98, 6e-3)],
          "the rate of the volume is the sum of both; the face has 0.98 of its area"),
    Proof("DEFINE_TABLE_2D: VALUE", foam(table=f"*DEFINE_TABLE_2D\n20\n{-2.302585092994046!r},31\n{4.605170185988092!r},32\n{6.396929655216146!r},33\n"),
          [(ZZ, LAST, -(AT_MIDDLE + 0.6991731351 * (AT_FAST - AT_MIDDLE)), 5e-3)], "logarithms: ln(350 / 100) / ln 6 of the way"),
    Proof("MAT_FU_CHANG_FOAM: HU", foam(path=BACK), [(ZZ, LAST, -2.4, 5e-3)], "unloading follows the curve of the lowest rate"),
    Proof("MAT_FU_CHANG_FOAM: HU SHAPE", foam(flags="0,1,1,0,0,0,0,0.2", more=SHAPE, path=BACK), [(ZZ, LAST, -2.4 * (1 - LOSS), 1e-2)], "1 - 0.8 (1 - 0.4^2) of the slow curve"),
    Proof("MAT_FU_CHANG_FOAM: EXPON", foam(flags="0,1,1,0,0,0,0,0.2", more=SHAPE + "1.5\n", path=BACK), [(ZZ, LAST, -2.4 * (1 - 0.8 * 0.84**1.5), 1e-2)], "1 - 0.8 (1 - 0.4^2)^1.5 of it"),
    Proof("MAT_FU_CHANG_FOAM: TC FAIL TFLAG", foam(first="1.5,0,0,20", path=UP), [(ZZ, LAST, 1.5, 5e-3)], "E times the strain is 6, above TC"),
    Proof("MAT_FU_CHANG_FOAM: TFLAG E", foam(path=UP), [(ZZ, LAST, 6.0, 5e-3)], "without TC, E times the strain"),
    Proof("MAT_FU_CHANG_FOAM: FAIL", foam(first="1.5,1,0,20", path=UP), [(ZZ, LAST, 0.0, 1e-2)], "no tension after TC"),
    Proof("MAT_FU_CHANG_FOAM: TFLAG", foam(flags="0,1,1,1", curves=PULLED, path=UP), [(ZZ, LAST, 5.4 + 0.4 * (7.2 - 5.4), 5e-3)], "the curves in tension at a rate of 300"),
    Proof("MAT_FU_CHANG_FOAM: DAMP BVFLAG MINR MAXR", foam(first="0,0,0.1,20", more="0\n0,0,0,0,0,1.0,50.0\n"), [(ZZ, LAST, -at(350.0), 5e-3)],
          "a viscosity, which does nothing here; the rates of the table are their own limits"),
    Proof("MAT_FU_CHANG_FOAM: PVID", foam(flags="0,1,1,0,31"), refused="PVID"),
    Proof("MAT_FU_CHANG_FOAM: TBID", foam(first="0,0,0,-20"), refused="TBID"),
    Proof("MAT_FU_CHANG_FOAM: TC TFLAG", foam(first="1.5,0,0,20", flags="0,1,1,1", curves=PULLED, path=UP), refused="TC"),
    Proof("MAT_FU_CHANG_FOAM: TC FAIL", foam(first="1.5,2,0,20", path=UP), refused="FAIL"),
]
