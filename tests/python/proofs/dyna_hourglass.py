"""Hourglass control of shells: the share of the stiffness of the material that their hourglass modes keep. Of fluids: none."""

import math

from . import LAST, Proof
from .pieces import CORNERS, DENSITY, YOUNG, deck, elastic, hexahedron, part, returned, shell_section, solid_section, square

# A square shell of edge a bends in its plane by u_x = X h, h = 1, -1, 1, -1. By beam theory it stores E t (4/3) X^2 / 2, its nodes hold
# rho a^2 t X'^2 / 2: the square of its angular frequency is 4 E / (3 rho a^2), and QM times that with *HOURGLASS.
SHARE = 0.02
# An eighth of a period, when half of the energy is still kinetic, in a field of ten columns.
EIGHTH = float(f"{math.pi / 4 / math.sqrt(SHARE * 4 * YOUNG / (3 * DENSITY * 10.0**2)):.4g}")
MODE = "*INITIAL_VELOCITY_NODE\n" + "".join(f"{i},{1.0 if i % 2 else -1.0}\n" for i in range(1, 5))
KEPT = [(lambda h: h["kinetic"][-1] / h["kinetic"][0], LAST, 0.5, 1e-2)]


def hourglass(card: str, id: int = 0) -> str:
    return deck(square(), part(1, 1, 1, f",0,{id}"), shell_section(), elastic(), MODE, card, end=EIGHTH)


# Water in the shape of an hourglass: u_x = y z about its centre. A spring of 1 % of the bulk modulus would give the motion back within the run.
WATER = "*MAT_NULL\n1,1e-9\n*EOS_LINEAR_POLYNOMIAL\n1,0.0,2250.0\n0.0,1.0\n"
TWIST = "*INITIAL_VELOCITY_NODE\n" + "".join(f"{i},{(2.0 * y - 1) * (2.0 * z - 1)}\n" for i, (_, y, z) in enumerate(CORNERS, 1))


PROOFS = [
    Proof("MAT_NULL: RO; EOS_LINEAR_POLYNOMIAL: C1", deck(hexahedron(), part(1, 1, 1, ",1"), solid_section(), WATER, TWIST, end=1e-3), [(returned, LAST, 0.0, 1e-9)],
          "a fluid resists no hourglass mode with a stiffness"),
    Proof("HOURGLASS: HGID IHQ QM", hourglass(f"*HOURGLASS\n7,4,{SHARE}\n", 7), KEPT, "an eighth of a period after its start the mode has half of its energy left"),
    Proof("CONTROL_HOURGLASS_936: IHQ QH", hourglass(f"*CONTROL_HOURGLASS_936\n4,{SHARE}\n"), KEPT, "likewise, of all parts"),
    Proof("CONTROL_HOURGLASS: IHQ QH", hourglass(f"*CONTROL_HOURGLASS\n4,{SHARE}\n"), KEPT, "likewise, of all parts"),
]  # fmt: skip
