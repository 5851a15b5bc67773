"""Bending: frequencies of a free bar for every choice of elements."""
import numpy as np
from scipy.optimize import brentq

import choices
import meshes
import plots
from bench import case

YOUNG, NU, DENSITY = 200e9, 0.3, 7850


def find_timoshenko(slenderness):
    """First frequency of a free-free bar of length 1 and square section 1 / slenderness, over that of Euler and Bernoulli
    (Timoshenko's beam, shear coefficient 10 (1 + nu) / (12 + 11 nu) of Cowper 1966; symmetric modes in x of cosh and cos)."""
    h = 1 / slenderness
    area, inertia = h * h, h**4 / 12
    kappa = 10 * (1 + NU) / (12 + 11 * NU)
    shear = YOUNG / (2 * (1 + NU))
    euler = 4.730040744862704**2 * np.sqrt(YOUNG * inertia / (DENSITY * area))

    def determinant(w):
        b2 = DENSITY * area * w**2 / (YOUNG * inertia)
        r2, s2 = inertia / area, YOUNG * inertia / (kappa * shear * area)
        root = np.sqrt((r2 - s2)**2 + 4 / b2)
        alpha = np.sqrt(b2 * (-(r2 + s2) + root) / 2)
        beta = np.sqrt(b2 * (r2 + s2 + root) / 2)
        # w = A cosh(alpha x) + B cos(beta x), slope of the section psi from the shear equation
        ca, cb = (alpha**2 + b2 * s2) / alpha, -(beta**2 - b2 * s2) / beta
        x = 0.5
        moment = [ca * alpha * np.cosh(alpha * x), cb * beta * np.cos(beta * x)]
        force = [(alpha - ca) * np.sinh(alpha * x), (-beta - cb) * np.sin(beta * x)]
        return moment[0] * force[1] - moment[1] * force[0]

    return brentq(determinant, 0.8 * euler, 1.0 * euler) / euler, euler


def make_bar(through, along, slenderness, angle):
    """A bar of length 1 along x; angle: of trapezoids, alternately to either side, in the plane of bending (x, z) [degrees]."""
    h = 1 / slenderness
    points, corners = meshes.make_box((1, h, h), (along, through, through))
    column = np.rint(points[:, 0] * along)
    lean = np.where((column > 0) & (column < along), (-1)**column, 0)
    points[:, 0] += lean * np.tan(np.radians(angle)) * (points[:, 2] - 0.5 * h)
    return points - [0.5, 0.5 * h, 0.5 * h], corners


def measure_frequency(bench, path, elements, slenderness, along, frequency):
    """First bending frequency from the motion of an end, over five periods."""
    h, period = 1 / slenderness, 2 * np.pi / frequency
    k = 4.730040744862704
    x = np.arange(along + 1) / along - 0.5
    shape = np.cosh(k * x) / np.cosh(k / 2) + np.cos(k * x) / np.cos(k / 2)
    speed = 1e-5 * h * frequency * shape / np.abs(shape).max()
    initial = "\n".join(f"  - {{nodes: {{inside: [[{a - 0.5 / along!r}, -1, -1], [{a + 0.5 / along!r}, 1, 1]]}}, velocity: [0, 0, {v!r}]}}"
                        for a, v in zip(x.tolist(), speed.tolist()))
    run = bench.run("""
title: free bar in bending
time: {end: $end}
parts: {bar: {exodus: {file: $file}, material: steel}}
materials: {steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}
elements: {$elements, bulk_viscosity: {linear: 0, quadratic: 0}}
initial:
$initial
output: {history: {every: $every, nodes: [{name: first, near: [-0.5, 0, 0]}, {name: middle, near: [0, 0, 0]}, {name: last, near: [0.5, 0, 0]}]}}
""", end=6 * period, every=period / 200, file=path, elements=elements, initial=initial)
    table = run.history
    z = 0.5 * (table["first_vz"] + table["last_vz"]) - table["middle_vz"]
    return find_peak(table["time"], z, frequency)


def find_peak(t, y, expected):
    """Frequency of the strongest line between 0.2 and 4 times the expected one: a scan of the windowed transform."""
    window = np.hanning(len(t)) * (y - y.mean())

    def power(w):
        return abs(np.sum(window * np.exp(-1j * w * t)))

    w = np.linspace(0.2 * expected, 4 * expected, 800)
    best, step = w[np.argmax([power(v) for v in w])], w[1] - w[0]
    w = np.linspace(best - step, best + step, 201)
    return w[np.argmax([power(v) for v in w])]


# name, elements through the thickness, their length over their height, angle of trapezoids, errors of the four choices that a prototype
# reached (assumed strain, stiffness, full), of which a choice may not be worse
MESHES = [
    ("1 through, cubes", 1, 1, 0.0),
    ("2 through, cubes", 2, 1, 0.0),
    ("1 through, 4 times as long", 1, 4, 0.0),
    ("2 through, 4 times as long", 2, 4, 0.0),
    ("1 through, trapezoids of 20 degrees", 1, 1, 20.0),
]
LIMITS = {"assumed strain": [0.02, 0.01, 0.10, 0.03, 0.07], "full": [0.11, 0.01, 1.3, 0.55, 0.05]}


@case("free_bar", "bending", "First bending frequency of a free bar", quick=True)
def free_bar(bench):
    """A free steel bar of square section, 20 times as long as high, starts with the speeds of its first bending mode (those of Euler and Bernoulli's beam) at
    amplitudes of 1e-5 of its height. The frequency is the strongest line of six periods of the motion of its ends, within 0.2 %; exact is Timoshenko's beam with Cowper's shear
    coefficient. One and two elements through the height, cubes, elements four times as long as high, and trapezoids. What the tolerance is: figures of
    a prototype of the assumed-strain and of the fully integrated element rounded up; hourglass stiffness and viscosity have no bending stiffness of their own in an element, their
    coefficient decides: shown, not judged."""
    slenderness = 20
    ratio, euler = find_timoshenko(slenderness)
    exact = ratio * euler
    known = choices.list_elements(bench)
    rows = []
    for i, (name, through, aspect, angle) in enumerate(MESHES):
        along = slenderness * through // aspect
        path = meshes.write_exodus(bench.file(f"bar_{i}.exo"), *make_bar(through, along, slenderness, angle))
        row = [name, f"{through} x {through} x {along}"]
        for choice, text in known.items():
            error = measure_frequency(bench, path, text, slenderness, along, exact) / exact - 1
            row.append(f"{100 * error:+.1f} %")
            if choice in LIMITS:
                bench.near(f"{choice}, {name}: frequency", (1 + error) * exact / 2 / np.pi, exact / 2 / np.pi, relative=LIMITS[choice][i], unit="Hz")
        rows.append(row)
    bench.near("Timoshenko's over Euler and Bernoulli's frequency (formula)", ratio, 1 - 0.0109, absolute=5e-3)
    bench.table(["mesh", "elements"] + list(known), rows, "Error of the frequency:")

    def draw(axes):
        width = 0.8 / len(known)
        for j, choice in enumerate(known):
            axes.bar(np.arange(len(rows)) + j * width, [min(60, float(row[2 + j].split()[0])) for row in rows], width, label=choice)
        axes.set_xticks(np.arange(len(rows)) + 0.4, ["1, cubes", "2, cubes", "1, long", "2, long", "1, trapezoids"])
        axes.axhline(0, **plots.EXACT)
        axes.set(ylabel="error of the frequency [%]", ylim=(-60, 62))
        axes.legend(fontsize=7)

    bench.figure("Error of the first bending frequency (bars cut at 60 %).", draw)
