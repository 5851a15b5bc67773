"""Yield stress over the rate of plastic strain: a cube that is pulled at a constant rate, and held when it is long enough."""

import math

from . import LAST, Proof
from .pieces import DENSITY, POISSON, curve, deck, hexahedron, node_set, part, solid_section

YOUNG = 2.1e5
STRAIN = 0.05
LOW, HIGH = ((0.0, 250.0), (0.1, 320.0)), ((0.0, 350.0), (0.1, 448.0))
CURVES = curve(51, *LOW) + curve(52, *HIGH)


def metal(card: str, rows: str) -> str:
    return f"*MAT_{card}\n1,{DENSITY!r},{YOUNG!r},{POISSON!r},{rows}"


def pull(rate: float, material: str, proves: str, stress: float, why: str) -> Proof:
    """Pulls by displacement 10 (exp(rate t) - 1) along z; the stress in the cube at the end."""
    end = STRAIN / rate
    rows = [(end * i / 200, 10.0 * math.expm1(STRAIN * i / 200)) for i in range(201)] + [(9 * end, 10.0 * math.expm1(STRAIN))]
    held = "*BOUNDARY_SPC_SET\n1,0,0,0,1\n2,0,0,1,0\n3,0,1,0,0\n"
    # slow beside sound: the mass of the cube is scaled so that it takes some thousand steps
    cards = (
        hexahedron() + part() + solid_section() + material.replace(repr(DENSITY), repr(YOUNG * (end / 2e4) ** 2), 1)
        + node_set(1, 1, 2, 3, 4) + node_set(2, 1, 2, 5, 6) + node_set(3, 1, 4, 5, 8) + node_set(4, 5, 6, 7, 8) + held
        + "*BOUNDARY_PRESCRIBED_MOTION_SET\n4,3,2,9\n" + curve(9, *rows) + f"*DAMPING_GLOBAL\n0,{100 / end!r}\n"
        + f"*DATABASE_ELOUT\n{end / 50:.6g}\n*DATABASE_HISTORY_SOLID\n1\n"
    )  # fmt: skip
    column = next_stress
    return Proof(proves, deck(cards, end=end, rows=50), [(column, LAST, stress, 2e-3)], why)


def next_stress(h: dict[str, list[float]]) -> float:
    """The stress along z of the only element."""
    return next(values[-1] for name, values in h.items() if name.endswith("_stress_zz"))


def flow(share: float, slow: float = 1.0, fast: float = 1.0) -> float:
    """The stress at the end between both curves: sigma = Y(p), p = strain - sigma / E."""
    start = slow * 250.0 * (1 - share) + fast * 350.0 * share
    slope = slow * 700.0 * (1 - share) + fast * 980.0 * share
    return (start + slope * STRAIN) / (1 + slope / YOUNG)


def table(*rows: tuple[float, int]) -> str:
    return "*DEFINE_TABLE_2D\n50\n" + "".join(f"{value!r},{id}\n" for value, id in rows)


MAT = "MAT_PIECEWISE_LINEAR_PLASTICITY"
BY_TABLE = "0,0,1e21\n0,0,50,0,1.0\n0\n0\n"
PROOFS = [
    pull(10.0, metal("024", BY_TABLE) + table((0.0, 51), (100.0, 52)) + CURVES, f"{MAT}: LCSS VP; DEFINE_TABLE_2D: VALUE LCID",
         flow(0.1 / (1 + 728 / YOUNG)), "a tenth of the way between the curves of 0 and 100 / s"),
    pull(1000.0, metal("024", BY_TABLE) + table((0.0, 51), (100.0, 52)) + CURVES, f"{MAT}: LCSS", flow(1.0), "constant beyond the highest rate"),
    pull(1.0, metal("024", BY_TABLE) + table((math.log(0.01), 51), (math.log(100.0), 52)) + CURVES, "DEFINE_TABLE_2D: VALUE",
         flow(0.5), "rates whose first is negative are logarithms; half way between 0.01 and 100 / s"),
    pull(1.0, metal("PIECEWISE_LINEAR_PLASTICITY_LOG_INTERPOLATION", BY_TABLE) + table((0.01, 51), (100.0, 52)) + CURVES,
         f"{MAT}: LCSS", flow(0.5), "linear in the logarithm of the rate"),
    pull(10.0, metal("024", BY_TABLE) + "*DEFINE_TABLE\n50,2.0,5.0\n-5\n45\n" + CURVES, "DEFINE_TABLE: TBID SFA OFFA VALUE",
         flow(0.1 / (1 + 728 / YOUNG)), "SFA (VALUE + OFFA) = 0 and 100 / s"),
    pull(50.0, metal("024", "250.0,697.6744186\n0,0,0,53,1.0\n0\n0\n") + curve(53, (0.0, 1.0), (100.0, 1.4)), f"{MAT}: LCSR SIGY ETAN",
         flow(0.0, 1.2), "the factor half way between 1 and 1.4"),
    *[pull(50.0, metal(number, f"250.0,697.6744186\n0,0,0,53,{vp}\n0\n0\n") + curve(53, (0.0, 1.0), (100.0, 1.4)), f"{word}: LCSR", flow(0.0, 1.2), "the factor half way between 1 and 1.4")
      for number, word, vp in (("123", "MAT_MODIFIED_PIECEWISE_LINEAR_PLASTICITY", "1.0"), ("081", "MAT_PLASTICITY_WITH_DAMAGE", ",1.0"))],
    pull(10.0, metal("123", BY_TABLE) + table((0.0, 51), (100.0, 52)) + CURVES, "MAT_MODIFIED_PIECEWISE_LINEAR_PLASTICITY: LCSS",
         flow(0.1 / (1 + 728 / YOUNG)), "as *MAT_024"),
]  # fmt: skip
