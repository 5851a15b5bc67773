"""Points of detonation."""

from . import ALL, LAST, Proof
from .pieces import deck, hexahedron, part, solid_section

JWL = "*EOS_JWL\n1,371000.0,3230.0,4.15,0.95,0.3,7000.0,1.0\n"
LAWS = "".join(f"*MAT_HIGH_EXPLOSIVE_BURN\n{id},1.6e-9,7.0e6,2e4,2\n" for id in (1, 2)) + JWL
CUBES = hexahedron() + hexahedron(2, 11, (0.0, 0.0, 100.0), of=2) + part(1, 1, 1, ",1") + part(2, 1, 2, ",1") + solid_section() + LAWS
SUMS = "*DATABASE_MATSUM\n1e-8\n"


def lit(cards: str) -> str:
    return deck(CUBES, SUMS, cards, end=1e-6)


PROOFS = [
    Proof("INITIAL_DETONATION: PID X Y Z", lit("*INITIAL_DETONATION\n1,5.0,5.0,5.0\n*INITIAL_DETONATION\n2,5.0,5.0,5.0\n"),
          [("kinetic:part_2", ALL, 0.0, 1e-12), (lambda h: float(h["kinetic:part_1"][-1] > 1.0), LAST, 1.0, 0.0)],
          "7 m/ms: the burn is in the cube around its point, and would need 0.014 ms to the other"),
    Proof("INITIAL_DETONATION: PID", lit("*INITIAL_DETONATION\n0,5.0,5.0,5.0\n*INITIAL_DETONATION\n2,5.0,5.0,5.0\n"), refused="2 points of detonation"),
    Proof("INITIAL_DETONATION: PID", lit("*INITIAL_DETONATION\n-1,5.0,5.0,5.0\n"), refused="INITIAL_DETONATION.PID"),
    Proof("INITIAL_DETONATION: PID", lit("*INITIAL_DETONATION\n1,5.0,5.0,5.0\n").replace("part_2\n2,1,2,1", "part_2\n2,1,1,1"), refused="INITIAL_DETONATION.PID"),
    Proof("INITIAL_DETONATION: LT", lit("*INITIAL_DETONATION\n1,5.0,5.0,5.0,1e-5\n"), refused="INITIAL_DETONATION.LT"),
]  # fmt: skip
