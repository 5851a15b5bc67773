"""*POTENTIAL of Abaqus decks: rolled sheet, and solids of it."""

import math

from . import LAST, Proof
from .abaqus_composites import AT, ORI, strained
from .pieces import abaqus, abaqus_cube
from .sheets import hill_by_stress, strain

E = (8e-3, -1e-3, 5e-3)
MODULUS, NU = 7e4, 0.33
TOLERANCE = 1e-2  # the strains of the element are nominal ones
RATIOS = "1., 1.1, 0.9, 1.15, 1.05, 0.85\n"
SURFACE = hill_by_stress(1.0, 1.1, 0.9, 1.15)


def metal(potential=RATIOS, plastic="40., 0.\n540., 1.\n", more=""):
    return f"*MATERIAL, NAME=m\n*DENSITY\n2.7e-9\n*ELASTIC\n{MODULUS}, {NU}\n*PLASTIC\n{plastic}{more}*POTENTIAL\n{potential}"


def sheet(material, option="", *more):
    return strained(f"*SHELL SECTION, ELSET=sheet, MATERIAL=m{option}\n1., 5\n", *more, material, e=E, k=0.0)


def work(hardening, degrees=0.0, surface=SURFACE):
    return [("internal", LAST, 100.0 * strain(surface, hardening, MODULUS, NU, E, degrees), TOLERANCE)]


def straight(p):
    return 40 + 500 * p


SHEARS = (1.15, 0.85, 1.05)  # 12, 23, 13


def sheared(plane):
    """A cube in simple shear of 0.02: its stress is R / sqrt(3) times the yield stress."""
    along, across = plane
    high = [i + 1 for i, corner in enumerate(((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))) if corner[across - 1]]
    lines = "".join(f"{node}, {d}, {d}, {200.0 if d == along and node in high else 0.0}\n" for node in range(1, 9) for d in (1, 2, 3))
    text = abaqus(abaqus_cube(False), "*SOLID SECTION, ELSET=cube, MATERIAL=m\n", metal(plastic="40., 0.\n"), end=1e-3, step=f"*BOUNDARY, TYPE=VELOCITY\n{lines}")
    return text


def shear_work(ratio):
    stress, shear = 40.0 * ratio / math.sqrt(3), MODULUS / (2 * (1 + NU))
    return [("internal", LAST, 1000.0 * (stress * 0.02 - 0.5 * stress**2 / shear), TOLERANCE)]


PROOFS = [
    Proof("POTENTIAL", sheet(metal()), work(straight), "axis 1 is x"),
    Proof("POTENTIAL; SHELL SECTION: ORIENTATION", sheet(metal(), ", ORIENTATION=o", ORI), work(straight, AT), "axis 1 is that of the orientation"),
    Proof("POTENTIAL", sheet(metal(plastic="40., 0.\n")), work(lambda p: 40.0), "a yield stress alone"),
    Proof("POTENTIAL", sheet(metal("1., 1., 1., 1., 1., 1.\n")), work(straight, 0.0, hill_by_stress(1.0, 1.0, 1.0, 1.0)), "the yield of von Mises"),
    *(Proof("POTENTIAL", sheared(plane), shear_work(ratio), "a cube in shear") for plane, ratio in zip(((1, 2), (2, 3), (1, 3)), SHEARS)),
    Proof("POTENTIAL", sheet(metal("1., 1., 0., 1., 1., 1.\n")), refused="a ratio of *POTENTIAL is not positive"),
    Proof("POTENTIAL", sheet(metal("")), refused="has no data line"),
    Proof("POTENTIAL", sheet(metal(RATIOS + RATIOS)), refused="depend on the temperature"),
    Proof("POTENTIAL", sheet(metal(more="*RATE DEPENDENT, TYPE=YIELD RATIO\n1., 0.\n2., 10.\n")), refused="ratios of yield stress with another law"),
]  # fmt: skip
