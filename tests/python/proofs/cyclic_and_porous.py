"""Chaboche's law and Gurson's: one element whose strain is known, against their rate equations in many small steps."""

import math
from collections.abc import Callable, Sequence

from . import LAST, Proof
from .abaqus_materials import BULK, ELASTIC, SHEAR, driven, strain, stretched
from .dyna_laws import BULK as BULK_OF_CARDS
from .dyna_laws import E_NU, EPS, MISES, PRESSURE, STRAIN, UP
from .dyna_laws import SHEAR as SHEAR_OF_CARDS
from .dyna_laws import stretched as pulled
from .pieces import DENSITY, curve

STEPS = 20000
Terms = Sequence[tuple[float, float]]  # modulus and rate of recovery of each back stress
BACK: Terms = ((150000.0, 1400.0), (6000.0, 50.0))


def cyclic(path: Sequence[float], slope: float, shear: float, back: Terms, size: Callable[[float], float]) -> tuple[float, float, float]:
    """Signed von Mises stress, plastic strain and work of strains one after the other. slope: the elastic stress over the strain."""
    terms, at = [0.0] * len(back), 0.0
    stress = p = work = 0.0
    for end in path:
        de = (end - at) / STEPS
        at = end
        for _ in range(STEPS):
            before = stress
            stress += slope * de
            about = stress - sum(terms)
            way = math.copysign(1.0, about)
            hardening = 1e7 * (size(p + 1e-7) - size(p)) + sum(c - way * g * a for (c, g), a in zip(back, terms))
            flow = max(abs(about) - size(p), 0.0) / (3 * shear + hardening)
            stress -= way * 3 * shear * flow
            terms = [a + (c * way - g * a) * flow for (c, g), a in zip(back, terms)]
            p += flow
            work += 0.5 * (before + stress) * de
    return stress, p, work


def saturating(q: float, b: float) -> Callable[[float], float]:
    return lambda p: 300.0 + q * (1 - math.exp(-b * p))


COMBINED = "*PLASTIC, HARDENING=COMBINED, DATA TYPE=PARAMETERS, NUMBER BACKSTRESSES=2\n300., 150000., 1400., 6000., 50.\n"
AND_BACK = "*AMPLITUDE, NAME=a\n0., 1., 5e-4, 1., 5e-4, -1., 1., -1.\n"


def work_there_and_back(back: Terms, size: Callable[[float], float]) -> float:
    return 1000 * cyclic((strain(0.01), 0.0), 3 * SHEAR, SHEAR, back, size)[2]


def cycled(law: str) -> str:
    return stretched(ELASTIC + law, amplitude=AND_BACK)


class Porous:
    """A metal with voids that is pulled alike in all directions: its mean stress is at the surface, and all plastic strain is of the voids."""

    def __init__(self, end: float, q1: float, q2: float, voids: float, bulk: float, nucleation: tuple[float, float, float] = (0.0, 1.0, 0.0), critical: float = 1.0, failing: float = 1.0, yields: Callable[[float], float] = lambda p: 300.0):
        mean = volume = p = 0.0
        self.voids, self.work, self.failed_at = voids, 0.0, 0.0
        de, last = end / STEPS, 1 / q1  # q3 is the square of q1
        for i in range(STEPS):
            before = mean
            mean += bulk * de
            f = self.voids
            effective = f if f <= critical else critical + (last - critical) / (failing - critical) * (f - critical)
            effective = min(max(effective, 1e-12), 0.999 * last)
            limit = 2 * yields(p) / (3 * q2) * math.acosh((1 + (q1 * effective) ** 2) / (2 * q1 * effective))
            if mean > limit:
                plastic = (mean - limit) / bulk
                mean = limit
                dp = mean * plastic / ((1 - f) * yields(p))
                at, deviation, fraction = nucleation
                self.voids += (1 - f) * plastic + fraction / (deviation * math.sqrt(2 * math.pi)) * math.exp(-0.5 * ((p - at) / deviation) ** 2) * dp
                p += dp
            volume += de
            self.work += 1000 * 0.5 * (before + mean) * math.exp(volume) * de
            if self.voids >= failing and not self.failed_at:
                self.failed_at = volume


def swollen(law: str, stretch: float = 0.02) -> str:
    return driven(ELASTIC + law, stretch, stretch, stretch)


VOLUME = 3 * math.log(1.02)
HOLLOW = "*PLASTIC\n300., 0.\n*POROUS METAL PLASTICITY, RELATIVE DENSITY=0.98\n1.4, 0.9, 1.96\n"
NUCLEATING = "*VOID NUCLEATION\n0.05, 0.03, 0.04\n"
FAILING = "*POROUS FAILURE CRITERIA\n0.06, 0.03\n"


def work(law: str, right: float, stretch: float = 0.02, tolerance: float = 1e-2) -> tuple[str, list]:
    return swollen(law, stretch), [("internal", LAST, right, tolerance)]


def erodes(case: Porous) -> list:
    at = 1e-3 * (math.exp(case.failed_at / 3) - 1) / 0.02
    return [("eroded_elements", 0.95 * at, 0.0, 1e-9), ("eroded_elements", 1.05 * at, 1.0, 1e-9)]


def m153(back: str = "6000.0,50.0,3000.0,0", head: str = "300.0,2000.0,25.0", last: str = "0,0", rest: str = "0") -> str:
    return f"*MAT_DAMAGE_3\n1,{DENSITY!r},{E_NU},{head}\n{back}\n{rest}\n{last}\n"


def pulled_and_pressed(material: str, back: Terms, size: Callable[[float], float], factor: float = 1.0) -> tuple[str, list]:
    """Uniaxial strain, 2 % and back to 0."""
    stress, p, _ = cyclic((STRAIN, 0.0), 2 * SHEAR_OF_CARDS, SHEAR_OF_CARDS, back, lambda q: factor * size(q))
    return pulled(material, 0, path=((0.0, 0.0), (5e-4, 0.2), (1e-3, 0.0))), [(MISES, LAST, abs(stress), 5e-3), (EPS, LAST, p, 5e-3)]


def m120(first: str = "300.0,0,1.4,0.9", second: str = "0,0.02,0,0,0,0,0,0", third: str = "0\n0", last: str = "0,0,0,0,0,0,2") -> str:
    return f"*MAT_GURSON\n1,{DENSITY!r},{E_NU},{first}\n{second}\n{third}\n0\n{last}\n"


def uniaxial(end: float, voids: float, yields: Callable[[float], float]) -> tuple[float, float]:
    """von Mises and mean stress of uniaxial strain, q1 1.4, q2 0.9, by Euler's method with a return along the normal."""
    q1, q2, k, g = 1.4, 0.9, BULK_OF_CARDS, SHEAR_OF_CARDS
    mean = q = p = 0.0
    f, de = voids, end / STEPS
    for _ in range(STEPS):
        mean, q = mean + k * de, q + 2 * g * de
        for _ in range(2):  # Newton's steps back to the surface
            y = yields(p)
            angle = 1.5 * q2 * mean / y
            surface = (q / y) ** 2 + 2 * q1 * f * math.cosh(angle) - 1 - (q1 * f) ** 2
            if surface <= 0:
                break
            by_mean, by_q = 3 * q1 * q2 * f * math.sinh(angle) / y, 2 * q / y**2
            hardening = 1e6 * (yields(p + 1e-6) - y)
            by_yield = -2 * q * q / y**3 - 2 * q1 * f * math.sinh(angle) * angle / y
            by_voids = 2 * q1 * math.cosh(angle) - 2 * q1 * q1 * f
            rate = (mean * by_mean + q * by_q) / ((1 - f) * y)
            flow = surface / (k * by_mean**2 + 3 * g * by_q**2 - by_yield * hardening * rate - by_voids * (1 - f) * by_mean)
            mean, q = mean - k * flow * by_mean, q - 3 * g * flow * by_q
            p, f = p + rate * flow, f + (1 - f) * by_mean * flow
    return q, mean


def strained(material: str, voids: float, yields: Callable[[float], float], *more: str) -> tuple[str, list]:
    q, mean = uniaxial(STRAIN, voids, yields)
    return pulled(material, UP, *more), [(MISES, LAST, q, 5e-3), (PRESSURE, LAST, -mean, 5e-3)]


NUCLEATED = (0.05, 0.03, 0.04)
HARD = 207457.6 * 2000.0 / (207457.6 - 2000.0)
START = 300.0 / 207457.6
FAILED = Porous(VOLUME, 1.4, 0.9, 0.02, BULK, critical=0.03, failing=0.06)

PROOFS = [
    Proof("PLASTIC: HARDENING DATA_TYPE NUMBER_BACKSTRESSES", cycled(COMBINED), [("internal", LAST, work_there_and_back(BACK, saturating(0.0, 1.0)), 1e-2)],
          "da = (2/3) C dep - gamma a dp of two terms, pulled by 1 % and back"),
    Proof("PLASTIC: DATATYPE", cycled(COMBINED.replace("DATA TYPE", "DATATYPE")), [("internal", LAST, work_there_and_back(BACK, saturating(0.0, 1.0)), 1e-2)], "the same"),
    Proof("CYCLIC HARDENING: PARAMETERS", cycled(COMBINED + "*CYCLIC HARDENING, PARAMETERS\n300., 250., 90.\n"),
          [("internal", LAST, work_there_and_back(BACK, saturating(250.0, 90.0)), 1e-2)], "the size grows by Q (1 - exp(-b p))"),
    Proof("CYCLIC HARDENING: PARAMETERS", cycled(COMBINED.replace("300., 150", "500., 150") + "*CYCLIC HARDENING, PARAMETERS\n300., -100., 90.\n"),
          [("internal", LAST, work_there_and_back(BACK, saturating(-100.0, 90.0)), 1e-2)], "it begins at the first number, and falls"),
    Proof("CYCLIC HARDENING", cycled(COMBINED + "*CYCLIC HARDENING\n300., 0.\n400., 0.1\n"), refused="by a table or by user code"),
    Proof("CYCLIC HARDENING", cycled("*PLASTIC\n300., 0.\n*CYCLIC HARDENING, PARAMETERS\n300., 250., 90.\n"), refused="without HARDENING=COMBINED"),
    Proof("PLASTIC: HARDENING", cycled("*PLASTIC, HARDENING=COMBINED\n300., 0.\n"), refused="DATA TYPE=PARAMETERS"),
    Proof("PLASTIC: NUMBER_BACKSTRESSES", cycled(COMBINED.replace("=2", "=5").replace("50.\n", "50., 1., 1., 2.\n2., 3., 3.\n")), refused="5 back stresses of different gamma"),
    Proof("POROUS METAL PLASTICITY: RELATIVE_DENSITY", *work(HOLLOW, Porous(VOLUME, 1.4, 0.9, 0.02, BULK).work),
          "the mean stress of the surface, 2 Y / (3 q2) acosh(...), and df = (1 - f) of the volume"),
    Proof("POROUS METAL PLASTICITY", *work(HOLLOW.replace(", RELATIVE DENSITY=0.98", ""), 0.0), refused="by *INITIAL CONDITIONS"),
    Proof("POROUS METAL PLASTICITY", swollen(HOLLOW.replace("*PLASTIC\n300., 0.\n", "*PLASTIC, HARDENING=KINEMATIC\n300., 0.\n400., 0.1\n")), refused="without a table of isotropic hardening"),
    Proof("VOID NUCLEATION", *work(HOLLOW + NUCLEATING, Porous(VOLUME, 1.4, 0.9, 0.02, BULK, NUCLEATED).work), "voids nucleate by the normal distribution over p"),
    Proof("POROUS FAILURE CRITERIA", swollen(HOLLOW + FAILING), erodes(FAILED), "voids coalesce from 0.03 on; at 0.06 the element is gone"),
    Proof("POROUS FAILURE CRITERIA", swollen(HOLLOW + "*POROUS FAILURE CRITERIA\n0.03, 0.06\n"), refused="must ascend"),
    Proof("MAT_DAMAGE_3: MID RO E PR SIGY HARDI BETA HARDK1 GAMMA1 HARDK2 GAMMA2",
          *pulled_and_pressed(m153(), ((6000.0, 50.0), (3000.0, 0.0)), saturating(2000.0 / 25.0, 25.0)), "HARDI / BETA (1 - exp(-BETA p)) and two back stresses"),
    Proof("MAT_DAMAGE_3: HARDK3 GAMMA3 HARDK4 GAMMA4", *pulled_and_pressed(m153("0,0,0,0,0,0,6000.0,50.0", last="3000.0,5.0"), ((6000.0, 50.0), (3000.0, 5.0)), saturating(2000.0 / 25.0, 25.0)), "two others"),
    Proof("MAT_DAMAGE_3: HARDI", *pulled_and_pressed(m153(head="300.0,2000.0,0"), ((6000.0, 50.0), (3000.0, 0.0)), lambda p: 300.0 + 2000.0 * p), "BETA of 0: linear"),
    Proof("MAT_DAMAGE_3: SRC SRP", *pulled_and_pressed(m153("0,0,0,0,1.0,50.0"), (), saturating(2000.0 / 25.0, 25.0), 1 + (2 / 3 * 2 * STRAIN / 1e-3) ** (1 / 50)), "Cowper and Symonds without back stresses"),
    Proof("MAT_DAMAGE_3: HARDK1", pulled(m153("-7,50.0"), UP), refused="HARDK1"),
    Proof("MAT_DAMAGE_3: IDAMAGE EPSD S T DC", pulled(m153(rest="1,0,0,0.1,2.0,3.0,0.4"), UP), refused="damage by the energy release rate"),
    Proof("MAT_GURSON: MID RO E PR SIGY Q1 Q2 F0", *strained(m120(), 0.02, lambda p: 300.0), "uniaxial strain of a metal with voids that does not harden"),
    Proof("MAT_GURSON: ETAN ATYP", *strained(m120(second="0,0.02,0,0,0,2000.0,2,0"), 0.02, lambda p: 300.0 + HARD * p), "E ETAN / (E - ETAN) over plastic strain"),
    Proof("MAT_GURSON: N", *strained(m120("300.0,5.0,1.4,0.9", "0,0.02,0,0,0,0,1,0"), 0.02, lambda p: 300.0 * ((START + p) / START) ** 0.2), "SIGY ((e0 + p) / e0)^(1/N), e0 = SIGY / E"),
    Proof("MAT_GURSON: A B C D E F G H", *strained(m120(second="0,0.02,0,0,0,0,3,0", third="0.0,0.05\n300.0,400.0"), 0.02, lambda p: 300.0 + 2000.0 * p), "rows of ATYP 3"),
    Proof("MAT_GURSON: LCSS VGTYP", *strained(m120(last="9,0,0,0,0,0,2"), 0.02, lambda p: 300.0 + 2000.0 * p, curve(9, (0.0, 300.0), (0.05, 400.0))), "a curve"),
    Proof("MAT_GURSON: FC EN SN FN FF0", pulled(m120(second="0.03,0.02,0.01,0.005,0.05,0,0,0.06"), UP, rows=1000), [("eroded_elements", LAST, 1.0, 0.0)], "voids that nucleate reach FF0"),
    Proof("MAT_GURSON: L1 L2 L3 L4 FF1 FF2 FF3 FF4", pulled(m120().replace("\n0\n0,0,0,0,0,0,2", "\n1.0,2.0,3.0,4.0,0.1,0.2,0.3,0.4\n0,0,0,0,0,0,2"), UP), refused="L1"),
    Proof("MAT_GURSON: LCFF LCF0 LCFC LCFN", pulled(m120(last="0,9,0,9,9,9,2"), UP, curve(9, (0.0, 300.0), (0.05, 400.0))), refused="LCFF"),
    Proof("MAT_GURSON: LCSS", pulled(m120(last="0,0,0,0,0,0,2").replace("300.0,0,1.4", "300.0,0,0"), UP), refused="Q1 of *MAT_GURSON is '0'"),
]  # fmt: skip
