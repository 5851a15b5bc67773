"""Materials: the energy of an element whose nodes are all driven is the integral of stress over strain."""

import math

from . import LAST, Proof
from .pieces import CORNERS, CUBE_MASS, DENSITY, POISSON, YOUNG, abaqus, abaqus_cube, returned

END = 1e-3
SHEAR, BULK = YOUNG / (2 * (1 + POISSON)), YOUNG / (3 * (1 - 2 * POISSON))
ELASTIC = f"*ELASTIC\n{YOUNG!r}, {POISSON!r}\n"
SIDES = "*NSET, NSET=xp\n2, 3, 6, 7\n*NSET, NSET=yp\n3, 4, 7, 8\n*NSET, NSET=zp\n5, 6, 7, 8\n*NSET, NSET=xm\n1, 4, 5, 8\n*NSET, NSET=ym\n1, 2, 5, 6\n*NSET, NSET=zm\n1, 2, 3, 4\n"
FIXED = "*BOUNDARY\nxm, 1\nym, 2\nzm, 3\n"
TWIST = "*INITIAL CONDITIONS, TYPE=VELOCITY\n" + "".join(f"{i}, 1, {(2.0 * y - 1) * (2.0 * z - 1)!r}\n" for i, (_, y, z) in enumerate(CORNERS, 1))
NO_VISCOSITY = "*BULK VISCOSITY\n0., 0.\n"


def driven(law: str, x: float, y: float, z: float, end: float = END, before: str = "", dynamic: str = "", amplitude: str = "") -> str:
    """A cube of a material whose three faces move by x, y, z until the end."""
    speeds = [10.0 * u / end for u in (x, y, z)]
    option = ", AMPLITUDE=a" if amplitude else ""
    conditions = f"*BOUNDARY, TYPE=VELOCITY{option}\nxp, 1, 1, {speeds[0]!r}\nyp, 2, 2, {speeds[1]!r}\nzp, 3, 3, {speeds[2]!r}\n"
    material = f"*SOLID SECTION, ELSET=cube, MATERIAL=m\n*MATERIAL, NAME=m\n*DENSITY\n{DENSITY!r}\n{law}"
    text = abaqus(abaqus_cube(False), SIDES, FIXED, amplitude, before, material, end=end, step=NO_VISCOSITY + conditions)
    return text.replace("*DYNAMIC, EXPLICIT", f"*DYNAMIC, EXPLICIT{dynamic}")


def stretched(law: str, stretch: float = 0.02, **more) -> str:
    """Volume stays but for the square of the strain."""
    other = (1 + stretch) ** -0.5 - 1
    return driven(law, stretch, other, other, **more)


def strain(stretch: float = 0.02) -> float:
    return math.log(1 + stretch)


def plastic_work(stress: float, slope: float = 0.0, stretch: float = 0.02) -> float:
    """Energy of 1000 mm3 that yield at a stress with a slope over plastic strain."""
    start = stress / (3 * SHEAR)
    rest = strain(stretch) - start
    tangent = slope * 3 * SHEAR / (slope + 3 * SHEAR)
    return 1000 * (0.5 * stress * start + stress * rest + 0.5 * tangent * rest * rest)


PLASTIC = "*PLASTIC\n300., 0.\n"
WARM = "*INITIAL CONDITIONS, TYPE=TEMPERATURE\nall, 40.\n"
RATE = strain() / END
DUCTILE = ELASTIC + PLASTIC + "*DAMAGE INITIATION, CRITERION=DUCTILE\n0.05, 0., 0.\n"
def absorbed(history):
    """By elements that live and by those that are eroded."""
    return history["internal"][-1] + history["eroded_energy"][-1]


UNTIL_ONSET = plastic_work(300.0, 0.0, math.exp(0.05 + 300 / (3 * SHEAR)) - 1)
EVOLUTION = "*DAMAGE EVOLUTION, TYPE=DISPLACEMENT\n0.1,\n"


def time_of(plastic: float, stretch: float = 0.1, end: float = END) -> float:
    """When a plastic strain is reached, of a linear motion."""
    return end * (math.exp(plastic + 300 / (3 * SHEAR)) - 1) / stretch


def erodes(law: str, plastic: float, before: str = "", **more) -> list:
    t = time_of(plastic)
    return [stretched(law, 0.1, before=before, **more), [("eroded_elements", 0.95 * t, 0.0, 1e-9), ("eroded_elements", 1.05 * t, 1.0, 1e-9)]]


def fails(proves: str, law: str, plastic: float, why: str) -> Proof:
    deck, rights = erodes(law, plastic)
    return Proof(proves, deck, rights, why)


def rubber(option: str, line: str) -> str:
    return f"*HYPERELASTIC, {option}\n{line}\n"


LARGE = 1.2
CHAINS = sum(c / 4 ** (i - 1) * ((LARGE**2 + 2 / LARGE) ** i - 3**i) for i, c in enumerate((1 / 2, 1 / 20, 11 / 1050, 19 / 7000, 519 / 673750), 1))
I1, I2 = LARGE**2 + 2 / LARGE - 3, 2 * LARGE + LARGE**-2 - 3


def powers(alpha: float, stretch: float) -> float:
    """l1^alpha + l2^alpha + l3^alpha - 3 where the volume stays."""
    return stretch**alpha + 2 * stretch ** (-alpha / 2) - 3


def foam_energy(terms: list[tuple[float, float]], ratio: float, stretches: tuple[float, ...]) -> float:
    """Of *HYPERFOAM, of 1000 mm3."""
    beta, j = ratio / (1 - 2 * ratio), math.prod(stretches)
    return 2000 * sum(mu / a**2 * (sum(s**a for s in stretches) - 3 + (j ** (-a * beta) - 1) / beta) for mu, a in terms)


PRONY = "*VISCOELASTIC, TIME=PRONY\n0.4, 0., 1e-7\n"

HOT = ELASTIC + "*PLASTIC, HARDENING=JOHNSON COOK\n300., 0., 1., 1., 100., 0.\n*INELASTIC HEAT FRACTION\n1.,\n*SPECIFIC HEAT\n1e7,\n"
HEATED = [("internal", LAST, 1000 * (100 * DENSITY * 1e7) * (1 - math.exp(-300 * (strain() - 150 / (3 * SHEAR)) / (100 * DENSITY * 1e7))), 3e-2)]



def conducting(share: float) -> str:
    """Diffusivity times the time of the run is this share of the square of an edge."""
    return f"*CONDUCTIVITY\n{share * 100 / END * DENSITY * 1e7!r},\n"


# A second cube, which rests.
SECOND = ("*NODE\n" + "".join(f"{i}, {10.0 * x}, {10.0 * y}, {50.0 + 10.0 * z}\n" for i, (x, y, z) in enumerate(CORNERS, 11))
          + "*ELEMENT, TYPE=C3D8R, ELSET=cube\n2, 11, 12, 13, 14, 15, 16, 17, 18\n")  # fmt: skip
EXPANSION = 1e-4
EXPANDING = f"*EXPANSION\n{EXPANSION!r},\n"


def confined_work(yielding: float) -> float:
    """Of 1000 mm3 that are stretched along x alone: K e - 3 K alpha T + 2/3 of von Mises' stress, which heats."""
    steps, start = 2000, yielding / (2 * SHEAR)
    de, work = strain() / steps, 0.0
    for i in range(steps):
        e = (i + 0.5) * de
        warm = yielding * 2 / 3 * max(e - start, 0.0) / (DENSITY * 1e7)
        stress = BULK * e - 3 * BULK * EXPANSION * warm + 2 / 3 * min(2 * SHEAR * e, yielding)
        work += 1000 * stress * math.exp(e) * de
    return work


CONFINED = confined_work(300.0)

PROOFS = [
    Proof("ELASTIC: TYPE", driven(ELASTIC, 1e-4, 0.0, 0.0), [("internal", LAST, 1000 * 0.5 * (BULK + 4 / 3 * SHEAR) * 1e-8, 1e-2)], "half of (lambda + 2 mu) e^2"),
    Proof("ELASTIC: TYPE", driven("*ELASTIC, TYPE=ANISOTROPIC\n1e5, 1e5, 1e5, 0.3, 0.3, 0.3, 4e4, 4e4\n4e4\n", 1e-4, 0.0, 0.0), refused="ANISOTROPIC"),
    Proof("ELASTIC", driven(ELASTIC + ELASTIC, 1e-4, 0.0, 0.0), refused="stands twice"),
    Proof("ELASTIC", driven(ELASTIC + "1e5, 0.3, 100.\n", 1e-4, 0.0, 0.0), [("internal", LAST, 1000 * 0.5 * (BULK + 4 / 3 * SHEAR) * 1e-8, 1e-2)], "without a temperature it is 0, below the table"),
    Proof("ELASTIC; INITIAL CONDITIONS: TYPE", driven(f"*ELASTIC\n{1.4 * YOUNG!r}, {POISSON!r}, 20.\n{0.4 * YOUNG!r}, {POISSON!r}, 70.\n", 1e-4, 0.0, 0.0, before=WARM),
          [("internal", LAST, 1000 * 0.5 * (BULK + 4 / 3 * SHEAR) * 1e-8, 1e-2)], "two fifths of the way between two temperatures"),
    Proof("ELASTIC", driven(ELASTIC + "1e5, 0.3, 100.\n", 1e-4, 0.0, 0.0, before=WARM + "xp, 50.\n"), refused="depend on the temperature"),
    Proof("ELASTIC", driven(f"*ELASTIC\n{YOUNG!r}, {POISSON!r}, 20.\n1e5, 0.3, 20.\n", 1e-4, 0.0, 0.0, before=WARM), refused="depend on the temperature"),
    Proof("DENSITY", driven(ELASTIC, 1e-4, 0.0, 0.0, before=WARM).replace(f"*DENSITY\n{DENSITY!r}\n", f"*DENSITY\n{1.4 * DENSITY!r}, 20.\n{0.4 * DENSITY!r}, 70.\n"),
          [("momentum_x", LAST, 0.5 * 1000 * DENSITY * 1e-3 / END, 1e-2)], "half of the nodes move by 1e-3 mm"),
    Proof("PLASTIC: HARDENING", stretched(ELASTIC + PLASTIC), [("internal", LAST, plastic_work(300.0), 1e-2)], "elastic to 300 MPa, then constant"),
    Proof("PLASTIC: HARDENING", stretched(ELASTIC + "*PLASTIC\n300., 0.\n500., 0.1\n"), [("internal", LAST, plastic_work(300.0, 2000.0), 1e-2)], "a slope of 2000 MPa"),
    Proof("PLASTIC: HARDENING",
          stretched(ELASTIC + "*PLASTIC, HARDENING=KINEMATIC\n300., 0.\n1300., 0.1\n", 0.02, amplitude="*AMPLITUDE, NAME=a\n0., 1., 5e-4, 1., 5e-4, -1., 1., -1.\n"),
          [("internal", LAST, 2 * plastic_work(300.0, 1e4, 0.01) - 1000 * 1e4 * strain(0.01) ** 2, 0.15)], "what moves the surface comes back"),
    Proof("PLASTIC: RATE", stretched(ELASTIC + f"*PLASTIC, RATE=0.\n300., 0.\n*PLASTIC, RATE={2 * RATE!r}\n600., 0.\n"), [("internal", LAST, plastic_work(450.0), 2e-2)],
          "half way between the tables of two rates"),
    Proof("PLASTIC: HARDENING", stretched(ELASTIC + "*PLASTIC, HARDENING=USER\n300., 0.\n"), refused="a subroutine of the user"),
    Proof("PLASTIC: HARDENING", stretched(ELASTIC + "*PLASTIC, HARDENING=JOHNSON COOK\n300., 800., 0.5, 1., 1e5, 0.\n"),
          [("internal", LAST, plastic_work(300.0) + 1000 * 800 * (strain() - 300 / (3 * SHEAR)) ** 1.5 / 1.5, 2e-2)], "300 + 800 p^0.5"),
    Proof("PLASTIC", stretched(ELASTIC + "*PLASTIC\n300., 0.01\n500., 0.1\n"), refused="the first plastic strain is 0.01"),
    Proof("PLASTIC", stretched(ELASTIC + "*PLASTIC\n300., 0.\n500., 0.1\n550., 0.05\n"), refused="do not ascend"),
    Proof("PLASTIC", stretched(ELASTIC + "*PLASTIC\n300., 0.\n200., 0., 400.\n"), [("internal", LAST, plastic_work(300.0), 1e-2)], "without a temperature it is 0"),
    Proof("PLASTIC: HARDENING; INITIAL CONDITIONS: TYPE",
          stretched(ELASTIC + "*PLASTIC\n340., 0., 20.\n540., 0.1, 20.\n240., 0., 70.\n340., 0.05, 70.\n440., 0.1, 70.\n", before=WARM),
          [("internal", LAST, plastic_work(300.0, 2000.0), 1e-2)], "300 MPa and a slope of 2000 MPa at 40 degrees"),
    Proof("PLASTIC: RATE", stretched(ELASTIC + f"*PLASTIC, RATE=0.\n340., 0., 20.\n240., 0., 70.\n*PLASTIC, RATE={2 * RATE!r}\n680., 0., 20.\n480., 0., 70.\n", before=WARM),
          [("internal", LAST, plastic_work(450.0), 2e-2)], "of two rates, each at 40 degrees"),
    Proof("PLASTIC", stretched(ELASTIC + "*PLASTIC\n300., 0.\n200., 0., 400.\n*INELASTIC HEAT FRACTION\n1.,\n*SPECIFIC HEAT\n1e7,\n", dynamic=", ADIABATIC"), refused="several temperatures"),
    Proof("PLASTIC: HARDENING", stretched(ELASTIC + "*PLASTIC, HARDENING=KINEMATIC\n300., 0., 20.\n500., 0.1, 20.\n300., 0., 70.\n"), refused="several temperatures"),
    Proof("RATE DEPENDENT: TYPE", stretched(ELASTIC + PLASTIC + f"*RATE DEPENDENT, TYPE=POWER LAW\n{RATE / 0.25!r}, 2.\n"), [("internal", LAST, plastic_work(450.0), 2e-2)],
          "1 + (rate / D)^(1 / n) = 1.5"),
    Proof("RATE DEPENDENT: TYPE", stretched(ELASTIC + "*PLASTIC, HARDENING=JOHNSON COOK\n300., 0., 1., 1., 1e5, 0.\n" + f"*RATE DEPENDENT, TYPE=JOHNSON COOK\n0.1, {RATE / math.exp(2)!r}\n"),
          [("internal", LAST, plastic_work(360.0), 2e-2)], "1 + 0.1 ln(e^2)"),
    Proof("RATE DEPENDENT: TYPE", stretched(ELASTIC + PLASTIC + f"*RATE DEPENDENT, TYPE=YIELD RATIO\n1., 0.\n1.5, {RATE / 2!r}\n"),
          [("internal", LAST, plastic_work(450.0), 2e-2)], "the last ratio holds beyond its rate"),
    *[Proof("RATE DEPENDENT: TYPE", stretched(ELASTIC + PLASTIC + f"*RATE DEPENDENT\n{row}\n"), refused=f"{name} of *RATE DEPENDENT, TYPE=POWER LAW is {what} (it must be positive", messages=1)
      for row, name, what in (("40.4", "n", "blank"), ("40.4, 0.", "n", "0"), (", 5.", "D", "blank"), ("-1., 5.", "D", "-1"))],
    *[Proof("PLASTIC: HARDENING", stretched(ELASTIC + f"*PLASTIC, HARDENING=JOHNSON COOK\n{row}\n"), refused=words, messages=1)
      for row, words in (("300., 800., , 1., 1e5, 0.", "n of *PLASTIC, HARDENING=JOHNSON COOK is blank"), ("300., 800., 0.5, 0., 1e5, 0.", "m of *PLASTIC, HARDENING=JOHNSON COOK is 0"))],
    Proof("RATE DEPENDENT: TYPE", stretched(ELASTIC + PLASTIC + "*RATE DEPENDENT\n40., 5., 0.\n20., 4., 100.\n"), refused="constants for several temperatures", messages=1),
    *[Proof("RATE DEPENDENT: TYPE", stretched(ELASTIC + "*PLASTIC, HARDENING=JOHNSON COOK\n300., 0., 1., 1., 1e5, 0.\n" + f"*RATE DEPENDENT, TYPE=JOHNSON COOK\n{row}\n"), refused=words, messages=1)
      for row, words in (("0.1", "the reference rate of *RATE DEPENDENT, TYPE=JOHNSON COOK is blank"), (", 1.", "C of *RATE DEPENDENT, TYPE=JOHNSON COOK is blank"))],
    Proof("RATE DEPENDENT: TYPE", stretched(ELASTIC + PLASTIC + "*RATE DEPENDENT, TYPE=USER\n1., 0.\n"), refused="of the kind USER"),
    Proof("DYNAMIC: ADIABATIC; DYNAMIC TEMPERATURE-DISPLACEMENT",
          stretched(HOT, dynamic=", ADIABATIC"),
          HEATED, "sigma = 300 (1 - T / 100) and rho c dT = sigma dp"),
    *[Proof(f"{card}: {field}", stretched(HOT, dynamic=", ADIABATIC").replace(NO_VISCOSITY, NO_VISCOSITY + f"*{card}, {text}\n"), HEATED,
            "the stress of the driven element does not depend on the mass that is added")
      for card, field, text in (("FIXED MASS SCALING", "DT TYPE", "DT=4e-6, TYPE=BELOW MIN"), ("FIXED MASS SCALING", "FACTOR", "FACTOR=5."),
                                ("VARIABLE MASS SCALING", "DT TYPE FREQUENCY", "DT=4e-6, TYPE=BELOW MIN, FREQUENCY=1"))],
    Proof("DYNAMIC TEMPERATURE-DISPLACEMENT; CONDUCTIVITY", stretched(HOT + conducting(0.1), before=SECOND).replace("*DYNAMIC,", "*DYNAMIC TEMPERATURE-DISPLACEMENT,"), refused="moves by 0.32 of the shortest edge"),
    Proof("DYNAMIC TEMPERATURE-DISPLACEMENT; CONDUCTIVITY", stretched(HOT + conducting(0.005), before=SECOND).replace("*DYNAMIC,", "*DYNAMIC TEMPERATURE-DISPLACEMENT,"), HEATED, "heat hardly moves"),
    Proof("DYNAMIC TEMPERATURE-DISPLACEMENT; CONDUCTIVITY", stretched(HOT + conducting(0.1)).replace("*DYNAMIC,", "*DYNAMIC TEMPERATURE-DISPLACEMENT,"), HEATED, "one element has one temperature"),
    Proof("DYNAMIC TEMPERATURE-DISPLACEMENT", stretched(HOT).replace("*DYNAMIC,", "*DYNAMIC TEMPERATURE-DISPLACEMENT,"), HEATED, "nothing conducts"),
    Proof("EXPANSION", driven(HOT.replace("100., 0.", "1e6, 0.") + EXPANDING, 0.02, 0.0, 0.0, dynamic=", ADIABATIC"), [("internal", LAST, CONFINED, 2e-2)], "the work of a body that cannot expand"),
    Proof("EXPANSION: TYPE", stretched(HOT + "*EXPANSION, TYPE=ORTHO\n1e-5, 1e-5, 1e-5\n", dynamic=", ADIABATIC"), refused="by directions"),
    Proof("EXPANSION", stretched(HOT + EXPANDING), [("internal", LAST, plastic_work(300.0), 1e-2)], "a step that does not heat"),
    Proof("HYPERELASTIC: NEO_HOOKE", stretched(rubber("NEO HOOKE", "0.5, 0.02"), LARGE - 1), [("internal", LAST, 500.0 * I1, 3e-2)], "C10 (I1 - 3) of a motion that keeps the volume"),
    Proof("HYPERELASTIC: MOONEY-RIVLIN", stretched(rubber("MOONEY-RIVLIN", "0.5, 0.2, 0.02"), LARGE - 1), [("internal", LAST, 500.0 * I1 + 200.0 * I2, 3e-2)], "C10 (I1 - 3) + C01 (I2 - 3)"),
    Proof("HYPERELASTIC: MOONEY-RIVLIN", stretched(rubber("MOONEY-RIVLIN", "0.5, -0.1, 0.02"), LARGE - 1), [("internal", LAST, 500.0 * I1 - 100.0 * I2, 3e-2)], "a negative C01"),
    Proof("HYPERELASTIC: POLYNOMIAL N", stretched(rubber("POLYNOMIAL, N=1", "0.5, 0.2, 0.02"), LARGE - 1), [("internal", LAST, 500.0 * I1 + 200.0 * I2, 3e-2)], "as MOONEY-RIVLIN"),
    Proof("HYPERELASTIC: N", stretched(rubber("N=1", "0.5, 0.2, 0.02"), LARGE - 1), [("internal", LAST, 500.0 * I1 + 200.0 * I2, 3e-2)], "POLYNOMIAL is the default"),
    Proof("HYPERELASTIC: REDUCED_POLYNOMIAL", stretched(rubber("REDUCED POLYNOMIAL, N=1", "0.5, 0.02"), LARGE - 1), [("internal", LAST, 500.0 * I1, 3e-2)], "as NEO HOOKE"),
    Proof("HYPERELASTIC: NEO_HOOKE", driven(rubber("NEO HOOKE", "0.5, 0.02"), 0.01, 0.01, 0.01), [("internal", LAST, 1000 * 0.5 * 100 * (1.01**3 - 1) ** 2, 3e-2)], "K = 2 / D1 = 100"),
    Proof("HYPERELASTIC: NEO_HOOKE", driven(rubber("NEO HOOKE", "0.5, 0."), 0.01, 0.01, 0.01), [("internal", LAST, 1000 * 0.5 * 20 * (1.01**3 - 1) ** 2, 3e-2)], "without D1 K is 20 shear moduli"),
    Proof("HYPERELASTIC: YEOH", stretched(rubber("YEOH", "0.5, 0.1, 0.05, 0.02"), LARGE - 1), [("internal", LAST, 500.0 * I1 + 100.0 * I1**2 + 50.0 * I1**3, 3e-2)], "C10 (I1 - 3) + C20 (I1 - 3)^2 + C30 (I1 - 3)^3"),
    Proof("HYPERELASTIC: REDUCED_POLYNOMIAL N", stretched(rubber("REDUCED POLYNOMIAL, N=3", "0.5, 0.1, 0.05, 0.02"), LARGE - 1), [("internal", LAST, 500.0 * I1 + 100.0 * I1**2 + 50.0 * I1**3, 3e-2)], "as YEOH"),
    Proof("HYPERELASTIC: REDUCED_POLYNOMIAL N", stretched(rubber("REDUCED POLYNOMIAL, N=2", "0.5, 0.1, 0.02, 0."), LARGE - 1), [("internal", LAST, 500.0 * I1 + 100.0 * I1**2, 3e-2)], "YEOH without C30"),
    Proof("HYPERELASTIC: YEOH", driven(rubber("YEOH", "0.5, 0.1, 0.05, 0.02"), 0.01, 0.01, 0.01), [("internal", LAST, 1000 * 0.5 * 100 * (1.01**3 - 1) ** 2, 3e-2)], "K = 2 / D1 = 100"),
    Proof("HYPERELASTIC: YEOH", stretched(rubber("YEOH", "0.5, 0.1, 0.05, 0.02, 0.1"), LARGE - 1), refused="YEOH"),
    Proof("HYPERELASTIC: ARRUDA-BOYCE", stretched(rubber("ARRUDA-BOYCE", "1.0, 2.0, 0.02"), LARGE - 1), [("internal", LAST, 1000.0 * CHAINS, 3e-2)], "the five terms of the energy of chains"),
    Proof("HYPERELASTIC: ARRUDA-BOYCE", driven(rubber("ARRUDA-BOYCE", "1.0, 2.0, 0.02"), 0.01, 0.01, 0.01), [("internal", LAST, 1000 * 0.5 * 100 * (1.01**3 - 1) ** 2, 3e-2)], "K = 2 / D = 100"),
    Proof("HYPERELASTIC: N", stretched(rubber("POLYNOMIAL, N=2", "0.5, 0.2, 0.1, 0.1, 0.1, 0.02, 0.02"), LARGE - 1), refused="N=2"),
    Proof("HYPERELASTIC: TEST_DATA_INPUT", stretched("*HYPERELASTIC, MOONEY-RIVLIN, TEST DATA INPUT\n*UNIAXIAL TEST DATA\n0.1, 0.1\n", LARGE - 1), refused="fitted to test data"),
    Proof("HYPERELASTIC: OGDEN", stretched(rubber("OGDEN", "0.7, 3., 0.02"), LARGE - 1), [("internal", LAST, 1000 * 2 * 0.7 / 9 * powers(3, LARGE), 3e-2)],
          "2 mu / alpha^2 (sum of l^alpha - 3)"),
    Proof("HYPERELASTIC: OGDEN N", stretched(rubber("OGDEN, N=3", "0.7, 3., 0.2, -2., 0.1, 5., 0.02, 0.\n0."), LARGE - 1),
          [("internal", LAST, 2000 * (0.7 / 9 * powers(3, LARGE) + 0.2 / 4 * powers(-2, LARGE) + 0.1 / 25 * powers(5, LARGE)), 3e-2)], "three terms on two lines"),
    Proof("HYPERELASTIC: OGDEN", driven(rubber("OGDEN", "0.7, 3., 0.02"), 0.01, 0.01, 0.01), [("internal", LAST, 1000 * 0.5 * 100 * (1.01**3 - 1) ** 2, 3e-2)], "K = 2 / D1 = 100"),
    Proof("HYPERELASTIC: OGDEN", stretched(rubber("OGDEN, N=2", "0.7, 3., 0.2, -2., 0.02, 0.1"), LARGE - 1), refused="D1 alone"),
    Proof("HYPERELASTIC: OGDEN", stretched(rubber("OGDEN", "0.7, 3., 0.02") + "*VISCOELASTIC, TIME=PRONY\n0.4, 0., 1e-7\n", LARGE - 1), refused="viscoelasticity of rubber"),
    Proof("HYPERFOAM", driven("*HYPERFOAM\n0.7, 3., 0.2\n", 0.2, -0.1, -0.3), [("internal", LAST, foam_energy([(0.7, 3.0)], 0.2, (1.2, 0.9, 0.7)), 3e-2)],
          "2 mu / alpha^2 (sum of l^alpha - 3 + (J^(-alpha beta) - 1) / beta), beta = nu / (1 - 2 nu)"),
    Proof("HYPERFOAM: N", driven("*HYPERFOAM, N=2\n0.7, 3., 0.2, -2., 0.25, 0.25\n", 0.2, -0.1, -0.3),
          [("internal", LAST, foam_energy([(0.7, 3.0), (0.2, -2.0)], 0.25, (1.2, 0.9, 0.7)), 3e-2)], "two terms"),
    Proof("HYPERFOAM: N", driven("*HYPERFOAM, N=2\n0.7, 3., 0.2, -2., 0.25, 0.1\n", 0.2, -0.1, -0.3), refused="one Poisson's ratio"),
    Proof("HYPERFOAM: POISSON TEST_DATA_INPUT", driven("*HYPERFOAM, TEST DATA INPUT, POISSON=0.2\n*UNIAXIAL TEST DATA\n-1., -0.1\n", 0.2, -0.1, -0.3), refused="fitted to test data"),
    Proof("VISCOELASTIC: TIME; ELASTIC: MODULI", stretched(ELASTIC + PRONY, 1e-3), [("internal", LAST, 1000 * 1.5 * SHEAR * strain(1e-3) ** 2, 3e-2)],
          "slow against 1e-7 s: the long-term modulus, which *ELASTIC gives"),
    Proof("VISCOELASTIC: TIME; ELASTIC: MODULI", stretched(ELASTIC.replace("*ELASTIC", "*ELASTIC, MODULI=INSTANTANEOUS") + PRONY, 1e-3),
          [("internal", LAST, 1000 * 1.5 * 0.6 * SHEAR * strain(1e-3) ** 2, 3e-2)], "0.6 of the instantaneous modulus"),
    Proof("VISCOELASTIC: TIME", driven(ELASTIC.replace("*ELASTIC", "*ELASTIC, MODULI=INSTANTANEOUS") + "*VISCOELASTIC, TIME=PRONY\n0., 0.3, 1e-7\n", 1e-3, 1e-3, 1e-3),
          [("internal", LAST, 1000 * 0.5 * 0.7 * BULK * (3 * strain(1e-3)) ** 2, 3e-2)], "0.7 of the instantaneous bulk modulus"),
    Proof("VISCOELASTIC", stretched(ELASTIC + "*VISCOELASTIC, TIME=CREEP TEST DATA\n1., 1.\n"), refused="viscoelasticity"),
    Proof("EOS: TYPE", driven("*EOS, TYPE=USUP\n4e6, 0., 0.\n", -0.01, -0.01, -0.01), [("internal", LAST, 1000 * 0.5 * DENSITY * 1.6e13 * (1 - 0.99**3) ** 2, 2e-2)],
          "p = rho0 c0^2 (1 - V / V0)"),
    Proof("EOS: TYPE", abaqus(abaqus_cube().replace(ELASTIC, "*EOS, TYPE=USUP\n1.5e6, 0., 0.\n"), TWIST, end=1e-3), [(returned, LAST, 0.0, 1e-9)],
          "a fluid resists no hourglass mode with a stiffness"),
    Proof("EOS: TYPE; ELASTIC: TYPE", stretched("*EOS, TYPE=USUP\n4e6, 0., 0.\n*ELASTIC, TYPE=SHEAR\n8e4,\n", 1e-3), [("internal", LAST, 1000 * 1.5 * 8e4 * strain(1e-3) ** 2, 2e-2)], "3 G e^2 / 2"),
    Proof("EOS: TYPE", driven("*EOS, TYPE=IDEALGAS\n287., 0.\n", -0.01, 0.0, 0.0), refused="IDEALGAS"),
    Proof("DAMPING: ALPHA", abaqus(abaqus_cube().replace("*DENSITY", "*DAMPING, ALPHA=50.\n*DENSITY"), "*INITIAL CONDITIONS, TYPE=VELOCITY\nall, 1, 100.\n", end=1e-2),
          [("momentum_x", LAST, 100 * math.exp(-0.5) * CUBE_MASS, 1e-3)], "v' = -alpha v"),
    Proof("DAMPING: BETA", stretched("*DAMPING, BETA=1e-7\n" + ELASTIC, 1e-3), [("viscous", LAST, 1000 * 3 * SHEAR * 1e-7 * strain(1e-3) ** 2 / END, 2e-2)], "beta 3 G rate^2 over time"),
    fails("DAMAGE INITIATION: CRITERION; DAMAGE EVOLUTION: TYPE SOFTENING", DUCTILE + EVOLUTION, 0.06, "0.05 and 0.1 mm over 10 mm"),
    fails("DAMAGE EVOLUTION: TYPE", DUCTILE + "*DAMAGE EVOLUTION, TYPE=ENERGY\n15.,\n", 0.06, "0.05, and 2 G / stress over 10 mm"),
    Proof("DAMAGE EVOLUTION: TYPE", stretched(DUCTILE + "*DAMAGE EVOLUTION, TYPE=ENERGY\n15.,\n", 0.1), [(absorbed, LAST, UNTIL_ONSET + 100 * 15.0, 2e-2)], "the energy over 100 mm^2 after the onset"),
    Proof("DAMAGE EVOLUTION: TYPE", stretched(DUCTILE + EVOLUTION, 0.1), [(absorbed, LAST, UNTIL_ONSET + 100 * 0.5 * 300.0 * 0.1, 2e-2)], "half of the yield stress over 0.1 mm"),
    *[Proof("DAMAGE EVOLUTION: TYPE SOFTENING", stretched(DUCTILE + f"*DAMAGE EVOLUTION, TYPE={law}\n", 0.1), [(absorbed, LAST, UNTIL_ONSET + 100 * spent, 2e-2)], why)
      for law, spent, why in (
          ("ENERGY, SOFTENING=EXPONENTIAL\n15.,", 15.0, "the energy over 100 mm^2 after the onset"),
          ("DISPLACEMENT, SOFTENING=EXPONENTIAL\n0.3, 3.", 300.0 * 0.3 * (1 / 3 - 1 / math.expm1(3.0)), "the yield stress over 0.3 mm, its share 1 - (1 - exp(-3 p)) / (1 - exp(-3)) is left"),
          ("DISPLACEMENT, SOFTENING=EXPONENTIAL\n0.1, 0.", 0.5 * 300.0 * 0.1, "an exponent of 0 is a straight line"),
          ("DISPLACEMENT, SOFTENING=TABULAR\n0., 0.\n0.6, 0.1\n1., 0.4", 300.0 * (0.1 * 0.7 + 0.3 * 0.2), "the area above the table"))],
    Proof("DAMAGE EVOLUTION: SOFTENING", stretched(DUCTILE + "*DAMAGE EVOLUTION, TYPE=DISPLACEMENT, SOFTENING=EXPONENTIAL\n0.1, -2.\n"), refused="an exponent of softening of -2"),
    fails("DAMAGE INITIATION: CRITERION", ELASTIC + PLASTIC + "*DAMAGE INITIATION, CRITERION=SHEAR\n0.09, 1.5, 0.\n0.05, 2., 0.\n" + EVOLUTION, 0.06, "von Mises stress over the largest shear stress is 2"),
    *[Proof("DAMAGE INITIATION: CRITERION KS", driven(ELASTIC + PLASTIC + f"*DAMAGE INITIATION, CRITERION=SHEAR{factor}\n0.05, -1., 0.\n1., 1., 0.\n" + EVOLUTION, 0.15, 0.0, 0.0),
            [("eroded_elements", 0.6 * END, 0.0, 1e-9), ("eroded_elements", 0.85 * END, gone, 1e-9)], why)
      for factor, gone, why in ((", KS=0.3", 1.0, "a large tension makes the ratio negative"), ("", 0.0, "without KS the ratio is 2"))],
    fails("DAMAGE INITIATION: CRITERION", DUCTILE.replace("0.05", "0.09") + EVOLUTION + "*DAMAGE INITIATION, CRITERION=SHEAR\n0.05, 2., 0.\n" + EVOLUTION, 0.06, "the first of two criteria begins"),
    fails("DAMAGE INITIATION: CRITERION", DUCTILE.replace("0.05, 0., 0.", f"0.025, 0., 0.\n0.075, 0., {2 * math.log(1.1) / END!r}") + EVOLUTION, 0.06, "failure strains of two rates, half of the way between them"),
    Proof("DAMAGE INITIATION", stretched(ELASTIC + PLASTIC + "*DAMAGE INITIATION, CRITERION=DUCTILE\n0.05, 0., 0.\n0.06, 1., 0.\n0.06, 0., 1.\n0.06, 1., 1.\n" + EVOLUTION), refused="not the same everywhere"),
    *[Proof("DAMAGE EVOLUTION: DEGRADATION", stretched(DUCTILE + first + "*DAMAGE INITIATION, CRITERION=SHEAR\n0.05, 2., 0.\n" + second), refused="evolve differently, or whose damages multiply")
      for first, second in ((EVOLUTION, EVOLUTION.replace("0.1", "0.2")), (EVOLUTION.replace("MENT", "MENT, DEGRADATION=MULTIPLICATIVE"), EVOLUTION.replace("MENT", "MENT, DEGRADATION=MULTIPLICATIVE")))],
    Proof("DAMAGE INITIATION", stretched(DUCTILE + EVOLUTION + DUCTILE.partition("*DAMAGE")[1] + DUCTILE.partition("*DAMAGE")[2] + EVOLUTION), refused="both need plastic_strain"),
    Proof("DAMAGE INITIATION", stretched(DUCTILE + EVOLUTION.replace("MENT", "MENT, DEGRADATION=MULTIPLICATIVE"), 0.1), [(absorbed, LAST, UNTIL_ONSET + 100 * 0.5 * 300.0 * 0.1, 2e-2)], "one criterion alone has nothing to multiply with"),
    fails("DAMAGE INITIATION: CRITERION", ELASTIC + PLASTIC + "*DAMAGE INITIATION, CRITERION=DUCTILE\n0.09, -0.9, 0.\n0.05, -0.1, 0.\n0.05, 2., 0.\n" + EVOLUTION, 0.06, "a table by the ratio of stresses, which is above 0"),
    fails("DAMAGE INITIATION: CRITERION", ELASTIC + PLASTIC + "*DAMAGE INITIATION, CRITERION=JOHNSON COOK\n-0.1, 0.15, 0., 0., 0., 1000., 0., 1.\n" + EVOLUTION, 0.06, "d1 below 0: d1 + d2, and 0.1 mm over 10 mm"),
    fails("DAMAGE INITIATION: CRITERION", ELASTIC + PLASTIC + "*DAMAGE INITIATION, CRITERION=JOHNSON COOK\n0.05, 0., 1., 0., 0., 1000., 0., 1.\n" + EVOLUTION, 0.06, "d1 + 0.1 mm over 10 mm"),
    Proof("DAMAGE INITIATION", stretched(DUCTILE, 0.1), [("internal", LAST, plastic_work(300.0, 0.0, 0.1), 2e-2)], "without evolution nothing fails"),
    Proof("DAMAGE INITIATION: CRITERION", stretched(ELASTIC + PLASTIC + "*DAMAGE INITIATION, CRITERION=FLD\n0.1, 0.\n" + EVOLUTION), refused="criterion FLD"),
    Proof("DAMAGE EVOLUTION: SOFTENING", stretched(DUCTILE + "*DAMAGE EVOLUTION, TYPE=DISPLACEMENT, SOFTENING=TABULAR\n0., 0.\n0.9, 0.1\n"), refused="from 0 at no displacement to 1"),
    fails("SHEAR FAILURE: TYPE", ELASTIC + PLASTIC + "*SHEAR FAILURE\n0.04, 0., 0.\n", 0.04, "a plastic strain of 0.04"),
    fails("SHEAR FAILURE: TYPE", ELASTIC + PLASTIC + "*SHEAR FAILURE, TYPE=JOHNSON COOK\n0.04, 0., 1., 0., 0.\n", 0.04, "d1"),
    Proof("SHEAR FAILURE: ELEMENT_DELETION", stretched(ELASTIC + PLASTIC + "*SHEAR FAILURE, ELEMENT DELETION=NO\n0.04, 0., 0.\n"), refused="ELEMENT DELETION"),
    Proof("TENSILE FAILURE", driven(ELASTIC + PLASTIC + "*TENSILE FAILURE\n300.,\n", 1e-3, 1e-3, 1e-3), [("eroded_elements", 0.53e-3, 0.0, 1e-9), ("eroded_elements", 0.62e-3, 1.0, 1e-9)],
          "3 K e = 300 MPa at e = 5.7e-4"),
    Proof("TENSILE FAILURE: ELEMENT_DELETION", stretched(ELASTIC + PLASTIC + "*TENSILE FAILURE, ELEMENT DELETION=NO\n875.,\n"), refused="ELEMENT DELETION"),
    Proof("USER MATERIAL: CONSTANTS TYPE; DEPVAR: DELETE", stretched("*USER MATERIAL, CONST=1, TYPE=MECHANICAL\n1.,\n*DEPVAR, DELETE=2\n3,\n"), refused="user code (no library has it)"),
    Proof("USER MATERIAL", stretched("*USER MATERIAL, CONSTANTS=1\n1.,\n*DEPVAR\n3,\n"), refused="user code (no library has it)"),
]  # fmt: skip

NOT_PHYSICS = {
    "USER MATERIAL.UNSYMM": "a matrix of Abaqus/Standard", "USER MATERIAL.HYBRID FORMULATION": "elements of Abaqus/Standard",
    "HYPERELASTIC.MODULI": "rubber that relaxes is refused", "HYPERFOAM.MODULI": "foam that relaxes is refused",
}  # fmt: skip
