"""Laws of rubber in tension, in two directions and in pure shear."""
import numpy as np
from scipy import optimize

from bench import case

BULK = 100.0
TRELOAR = [(-2.0, -0.01), (1.3, 0.63), (5.0, 0.0012)]  # Ogden (1972): exponents and moduli [MPa] of Treloar's rubber
CHAINS = (1 / 2, 1 / 20, 11 / 1050, 19 / 7000, 519 / 673750)


def ogden(b):
    return sum(mu / a * (np.sum(b**a) - 3) for a, mu in TRELOAR)


def mooney_rivlin(b):
    return 0.16 * (np.sum(b**2) - 3) + 0.03 * (np.sum(b**-2.0) - 3)


def yeoh(b):
    first = np.sum(b**2) - 3
    return 0.17 * first - 1e-3 * first**2 + 3e-5 * first**3


def arruda_boyce(b):
    first = np.sum(b**2)
    return 0.3 * sum(c * 5.0 ** (-2 * i) * (first ** (i + 1) - 3 ** (i + 1)) for i, c in enumerate(CHAINS))


def find_force(energy, stretch, mode, bulk=BULK):
    """Force by the first area along x, where the free sides have none. bulk: of energy(b) + bulk (J - 1)^2 / 2."""

    def whole(stretches):
        j = np.prod(stretches)
        return energy(np.asarray(stretches) / np.cbrt(j)) + bulk / 2 * (j - 1)**2

    def place(free):
        return {"tension": [stretch, free, free], "two directions": [stretch, stretch, free],
                "pure shear": [stretch, 1.0, free]}[mode]

    def slope(free, k):
        low, high, d = place(free), place(free), 1e-5
        low[k] -= d
        high[k] += d
        return (whole(high) - whole(low)) / (2 * d)

    middle = stretch ** {"tension": -0.5, "two directions": -2, "pure shear": -1}[mode]
    free = optimize.brentq(lambda s: slope(s, 2), 0.8 * middle, 1.2 * middle, xtol=1e-13)
    return slope(free, 0)


def pull(bench, law, stretch, mode, density=1e-2, libraries=()):
    grow = '{expression: "' + repr(stretch - 1) + ' * sin(pi * min(t, 20) / 40)^2"}'
    second = {"tension": "", "two directions": f"  - {{nodes: b/y_max, displacement: {{y: {grow}}}}}\n",
              "pure shear": "  - {nodes: b/y_max, fixed: [y]}\n"}[mode]
    return bench.run("""
title: A cube of rubber
units: mm, t, s
time: {end: 25}
parts: {b: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, material: m}}
materials: {m: {density: $density, $law}}
damping: [{coefficient: 2}]
conditions:
  - {nodes: b/x_min, symmetry: x}
  - {nodes: b/y_min, symmetry: y}
  - {nodes: b/z_min, symmetry: z}
  - {nodes: b/x_max, displacement: {x: $grow}}
${second}output: {history: {every: 0.1, forces: [{name: f, support: b/x_max}]}}
silence: [incompressible_solids]
""", density=density, law=law, grow=grow, second=second, libraries=libraries).history.mean(24, 25, "fx:f")


def make_table():
    """The curve of a uniaxial test of Ogden's law, without change of volume."""
    rows = []
    for stretch in np.concatenate([np.linspace(0.35, 0.97, 14), [1.0], np.linspace(1.05, 3.1, 17)]):
        rows.append([float(stretch - 1),
                     float(sum(mu * (stretch ** (a - 1) - stretch ** (-a / 2 - 1)) for a, mu in TRELOAR))])
    return "[" + ", ".join(f"[{e!r}, {s!r}]" for e, s in rows) + "]"


@case("rubber_laws", "exact", "Rubber: laws in tension, in two directions and in pure shear", quick=True)
def rubber_laws(bench):
    """A cube is drawn along one direction, along two, or along one with a second held. The force follows from the stored energy of each law
    with free sides. Ogden's constants are those of Treloar's rubber (Ogden, Proc. R. Soc. A 326, 1972), whose
    shear modulus is 1/240 of the bulk modulus here. The tabulated law gets the uniaxial curve of the same
    rubber in 32 rows, the most it takes: its other forces are then Ogden's too. The tolerance is 0.1 %, of the tabulated law 1 %."""
    ogden_terms = "[" + ", ".join(f"[{a}, {mu}]" for a, mu in TRELOAR) + "]"
    laws = [("ogden", ogden, f"model: ogden, bulk_modulus: {BULK}, terms: {ogden_terms}", 1e-3),
            ("tabulated_rubber", ogden,
             f"model: tabulated_rubber, bulk_modulus: {BULK}, uniaxial: {make_table()}", 1e-2),
            ("mooney_rivlin", mooney_rivlin, f"model: mooney_rivlin, bulk_modulus: {BULK}, c10: 0.16, c01: 0.03", 1e-3),
            ("yeoh", yeoh, f"model: yeoh, bulk_modulus: {BULK}, c10: 0.17, c20: -1e-3, c30: 3e-5", 1e-3),
            ("arruda_boyce", arruda_boyce,
             f"model: arruda_boyce, bulk_modulus: {BULK}, mu: 0.3, locking_stretch: 5", 1e-3)]
    for name, energy, law, within in laws:
        far = name != "tabulated_rubber"
        for mode, stretch in (("tension", 6.0 if far else 3.0), ("tension", 0.5),
                              ("two directions", 3.0 if far else 1.6), ("pure shear", 4.0 if far else 2.4)):
            bench.near(f"{name}: {mode} to {stretch:g}", pull(bench, law, stretch, mode),
                       find_force(energy, stretch, mode), relative=within, unit="MPa")
