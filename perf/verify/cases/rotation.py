"""Bodies that turn."""
import numpy as np
from scipy.integrate import solve_ivp

import choices
import meshes
import plots
from bench import case, observed_order, thin
from cases.exact import distort

YOUNG, DENSITY = 200e9, 7850
SPEED = np.sqrt(YOUNG / DENSITY)  # of waves in bars
STEEL = """
materials:
  steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}
"""


def turn_nodes(points, w, stretch):
    """Conditions that stretch along x by `stretch` up to t = 1 ms and then turn about z with w; no stretch: from the start."""
    lines = []
    for x, y, z in points:
        if stretch == 0:
            a, turn = f"{x!r}", f"{w!r} * t"
        else:
            a = f"{x!r} * (1 + {stretch!r} * (t < 1e-3 ? sin(pi * t / 2e-3) ^ 2 : 1))"
            turn = f"(t < 1e-3 ? 0 : {w!r} * (t - 1e-3))"
        lines.append(f"  - {{nodes: {{inside: [[{x!r}, {y!r}, {z!r}], [{x!r}, {y!r}, {z!r}]]}}, displacement: {{"
                     f"x: {{expression: \"{a} * cos({turn}) - {y!r} * sin({turn}) - {x!r}\"}}, "
                     f"y: {{expression: \"{a} * sin({turn}) + {y!r} * cos({turn}) - {y!r}\"}}, z: 0}}}}")
    return "\n".join(lines)


IMPOSED = """
time: {end: $end, max_step: $step}
parts: {body: {exodus: {file: $file}, material: steel}}
elements: {$elements}
conditions:
$conditions
output: {history: {every: $every, elements: [{name: a, id: 1}, {name: b, id: 2}, {name: c, id: 7}, {name: d, id: 8}]}}
""" + STEEL
COMPONENTS = ("xx", "yy", "zz", "xy", "yz", "zx")


@case("imposed_turns", "exact", "Rigid rotation: a hundred imposed turns", quick=True)
def imposed_turns(bench):
    """Every node of eight distorted elements is rotated around an axis for a hundred turns. Stress must stay 0 within
    1e-12 of Young's modulus, and so must the energy of hourglass control (1e-13 J: strains of 1e-12 in a cubic metre of
    steel). For central differences a rotation is a sequence of chords, of 2 degrees a step."""
    points, corners, _ = distort(bench, (1, 1, 1), (2, 2, 2), 0.15, 3)
    points -= 0.5
    path = meshes.write_exodus(bench.file("turns.exo"), points, corners)
    w = 500.0
    for name, text in choices.list_elements(bench).items():
        run = bench.run(IMPOSED, end=100 * 2 * np.pi / w, step=6e-5, every=1e-2, file=path, elements=text,
                        conditions=turn_nodes(points.tolist(), w, 0))
        stress = max(run.history.largest(f"{e}_stress_{c}") for e in "abcd" for c in COMPONENTS)
        bench.below(f"{name}: largest stress over Young's modulus", stress / YOUNG, 1e-12)
        bench.below(f"{name}: hourglass energy", run.history.largest("hourglass"), 1e-13, "J")


@case("prestressed_turn", "exact", "Rigid rotation of a stretched body")
def prestressed_turn(bench):
    """The same elements are stretched by 0.1 % and then rotated 10 times. The stress must only rotate with the body, sigma
    = R sigma0 R^T. J = 1.001 times sigma0 is the E-modulus times ln(1.001) of uniaxial strain. Round-off of 1 m over
    elements of half a metre in 2e4 steps is 1e-12 of Young's modulus. The stretch itself is off by the mid-point rule,
    1e-9 of strain."""
    points, corners, _ = distort(bench, (1, 1, 1), (2, 2, 2), 0.15, 3)
    points -= 0.5
    path = meshes.write_exodus(bench.file("turn.exo"), points, corners)
    w, stretch, nu = 500.0, 1e-3, 0.3
    end = 1e-3 + 10.125 * 2 * np.pi / w
    for name, text in choices.list_elements(bench).items():
        run = bench.run(IMPOSED, end=end, step=3e-5, every=1e-3, file=path,
                        elements=text + ", bulk_viscosity: {linear: 0, quadratic: 0}",
                        conditions=turn_nodes(points.tolist(), w, stretch))
        h = run.history
        factor = YOUNG / ((1 + nu) * (1 - 2 * nu)) * np.log(1 + stretch) / (1 + stretch)
        sigma0 = factor * np.diag([1 - nu, nu, nu])
        worst = 0.0
        for i in np.flatnonzero(h["time"] > 1.1e-3):
            angle = w * (h["time"][i] - 1e-3)
            r = np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0], [0, 0, 1]])
            sigma = r @ sigma0 @ r.T
            for e in "abcd":
                got = np.array([h[f"{e}_stress_{c}"][i] for c in COMPONENTS])
                worst = max(worst, np.abs(got - sigma[[0, 1, 2, 0, 1, 2], [0, 1, 2, 1, 2, 0]]).max())
        bench.below(f"{name}: stress, largest error over that of the start", worst / sigma0[0, 0], 1e-8)
        after = h["time"] > 1.1e-3
        bench.below(f"{name}: internal energy while it turns, largest change",
                    np.ptp(h["internal"][after]) / h.last("internal"), 1e-6)


@case("free_turns", "exact", "Free rotation: a hundred turns")
def free_turns(bench):
    """A free block of 4 x 2 x 1 elements spins so fast that its ends move at 1 % of the speed of sound. Angular momentum
    must be conserved to round-off and kinetic energy to 1e-6. The energy of hourglass control must not grow. (A code
    that rotates rates with the rotation at the end of the step gains energy exponentially.) The block starts without
    its centrifugal stress and vibrates with 1e-4 of its energy until viscosity has damped it: the measurement begins
    after ten turns."""
    a = 0.2
    w = 0.01 * SPEED / a
    turn = 2 * np.pi / w
    curves = {}
    for name, text in choices.list_elements(bench).items():
        run = bench.run("""
time: {end: $end}
parts: {body: {box: {size: [0.4, 0.2, 0.1], cells: [4, 2, 1]}, at: [-0.2, -0.1, 0], material: steel}}
elements: {$elements}
initial: [{part: body, angular_velocity: [0, 0, $w]}]
output: {history: {every: $every}}
""" + STEEL, end=100 * turn, w=w, every=turn / 8, elements=text)
        h = run.history
        late = (h["time"] > 10 * turn) & (h["time"] < 99.9 * turn)
        bench.below(f"{name}: linear momentum, relative change", run.summary["momentum"]["linear_error"], 1e-12)
        bench.below(f"{name}: angular momentum, relative change", run.summary["momentum"]["angular_error"], 1e-12)
        bench.below(f"{name}: kinetic energy after ten turns, relative change",
                    np.ptp(h["kinetic"][late]) / h["kinetic"][0], 1e-6)
        early = np.abs(h["hourglass"][h["time"] < 10 * turn]).max()
        if early > 0:  # full integration has none
            bench.below(f"{name}: hourglass energy of the last ten turns over that of the first ten",
                        np.abs(h["hourglass"][h["time"] > 90 * turn]).max() / early, 1.001)
        bench.below(f"{name}: energy balance, largest error", h.largest("energy_error"), 1e-5)
        curves[name] = h["time"] / turn, h["kinetic"] / h["kinetic"][0] - 1

    def draw(axes):
        for name, (t, y) in curves.items():
            axes.plot(*thin(t, y, 200), label=name)
        axes.set(xlabel="turns", ylabel="change of kinetic energy")
        axes.legend()

    bench.figure("Kinetic energy of the spinning block: it vibrates until viscosity has damped the initial imbalance, "
                 "then stays constant.", draw)


@case("dzhanibekov", "exact", "Free rotation about the unstable axis")
def dzhanibekov(bench):
    """A free block spins about its middle axis, disturbed by 5 %, and flips over repeatedly. Euler's equations of the
    rigid body are solved independently, with the moments of inertia of masses lumped to nodes (L^2 / 12 (1 + 2 / n^2)
    for n elements along L). Positions of two nodes are compared for 12 turns. Elasticity changes the inertia by (w a /
    c)^2 = 4e-6, magnified as orbits separate near the unstable axis. Viscous hourglass control is left out. It damps
    the bending of a block one element thick, which takes 1e-3 of the energy here and turns the body to its stable axis,
    as damping does in nature."""
    size, cells, a = np.array([0.4, 0.2, 0.1]), np.array([4, 2, 1]), 0.2
    w = 0.002 * SPEED / a
    end = 12 * 2 * np.pi / w
    second = size**2 / 12 * (1 + 2 / cells**2)
    inertia = second.sum() - second

    def rate(_, y):
        omega, (s, *q) = y[:3], y[3:]
        spin = np.cross(inertia * omega, omega) / inertia
        return np.concatenate([spin, [-0.5 * np.dot(q, omega)], 0.5 * (s * omega + np.cross(q, omega))])

    for name, text in choices.list_elements(bench).items():
        if name == "viscous":
            continue
        used = name
        run = bench.run("""
time: {end: $end}
parts: {body: {box: {size: [0.4, 0.2, 0.1], cells: [4, 2, 1]}, at: [-0.2, -0.1, -0.05], material: steel}}
elements: {$elements}
initial: [{part: body, angular_velocity: [$small, $w, 0]}]
output: {history: {every: $every, nodes: [{name: corner, near: [0.2, 0.1, 0.05]}, {name: side, near: [0, -0.1, -0.05]}]}}
""" + STEEL, end=end, small=0.05 * w, w=w, every=end / 400, elements=text)
        h = run.history
        rigid = solve_ivp(rate, (0, end), [0.05 * w, w, 0, 1, 0, 0, 0], t_eval=h["time"], rtol=1e-11, atol=1e-12)
        s, q = rigid.y[3], rigid.y[4:7].T

        def turned(p):
            c = np.cross(q, p)
            return p + 2 * (s[:, None] * c + np.cross(q, c))

        worst = max(np.abs(h[f"{node}_{axis}"] - turned(np.array(p))[:, k]).max()
                    for node, p in (("corner", (0.2, 0.1, 0.05)), ("side", (0, -0.1, -0.05)))
                    for k, axis in enumerate("xyz"))
        upright = turned(np.array([0, 1, 0.0]))[:, 1]
        bench.below(f"{name}: places of two nodes, largest error over the half length", worst / a, 0.01)
        bench.below(f"{name}: angular momentum, relative change", run.summary["momentum"]["angular_error"], 1e-12)
        bench.below(f"{name}: kinetic energy, relative change", np.ptp(h["kinetic"]) / h["kinetic"][0], 1e-5)
    bench.above("flips in the exact motion", int(np.sum(np.diff(np.sign(upright)) != 0)), 1)

    def draw(axes):
        axes.plot(rigid.t * w / 2 / np.pi, turned(np.array([0.2, 0.1, 0.05]))[:, 1], label="Euler's equations",
                  **plots.EXACT)
        axes.plot(h["time"][::5] * w / 2 / np.pi, h["corner_y"][::5], ".", markersize=3, label=f"percuss ({used})")
        axes.set(xlabel="turns", ylabel="y of a corner [m]")
        axes.legend(loc="lower left")

    bench.figure("A corner of the tumbling block against Euler's equations.", draw)


@case("spinning_bar", "exact", "Centrifugal stress of a spinning bar")
def spinning_bar(bench):
    """A free bar of half length a spins about its middle: sigma(x) = rho w^2 (a^2 - x^2) / 2. Between two planes of lumped
    masses, h apart, the force is that of the continuum with a^2 + h^2 / 4: an error of order 2, which the three meshes
    must show. Poisson's ratio is 0, so that the bar does not contract. It is one element wide, and masses at its sides
    pull it apart with rho w^2 b^2, b its half width. That is part of the exact von Mises stress used here. Linear
    viscosity of 1 damps the initial vibration; means over the last 75 of its periods (a Hann window) remove the rest."""
    a, b = 0.5, 0.0125
    w = 0.001 * SPEED / a
    sizes, errors, curves = [], [], []
    for cells in (20, 40, 80):
        points = [(i + 0.5) * a / (cells // 2) for i in range(cells // 2)]
        elements = ", ".join(f"{{name: s{i}, near: [{x!r}, 0, 0]}}" for i, x in enumerate(points))
        run = bench.run("""
time: {end: 0.04}
parts: {bar: {box: {size: [1, 0.025, 0.025], cells: [$cells, 1, 1]}, at: [-0.5, -0.0125, -0.0125], material: steel}}
elements: {bulk_viscosity: {linear: 1}}
initial: [{part: bar, angular_velocity: [0, 0, $w]}]
output: {history: {every: 2e-5, elements: [$elements]}}
materials: {steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0}}
""", cells=cells, w=w, elements=elements)
        x, middle, h = np.array(points), DENSITY * w**2 * a**2 / 2, 1 / cells
        # the bar turns: von Mises' stress does not, and the stress along follows from it and the stress across
        mises = np.array([run.history.steady(0.01, 0.04, f"s{i}_von_mises") for i in range(len(points))])
        across = DENSITY * w**2 * b**2
        along = 0.5 * across + np.sqrt(mises**2 - 0.75 * across**2)
        exact = DENSITY * w**2 * (a**2 - x**2) / 2
        inner = x < 0.7 * a
        sizes.append(h)
        errors.append(np.abs(along - exact)[inner].max() / middle)
        curves.append((cells, x, along / middle))
        lumped = DENSITY * w**2 * (a**2 - x**2 + h**2 / 4) / 2
        # what the sides do to the stress along dies out from the free end inwards
        bench.below(f"{cells} elements: stress less that of lumped masses, over that in the middle",
                    np.abs(along - lumped)[inner].max() / middle, 1e-3)
    bench.near("observed order in the size of the elements", observed_order(sizes, errors), 2.0, absolute=0.15)
    bench.below("error of 80 elements over the stress in the middle", errors[-1], 1e-3)

    def draw(axes):
        x = np.linspace(0, a, 100)
        axes.plot(x, 1 - (x / a)**2, label="exact", **plots.EXACT)
        for cells, place, stress in curves:
            axes.plot(place, stress, "o", markersize=3, label=f"{cells} elements")
        axes.set(xlabel="x [m]", ylabel="stress over $\\rho w^2 a^2 / 2$")
        axes.legend()

    bench.figure("Stress along the spinning bar.", draw)
