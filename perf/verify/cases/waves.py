"""Waves in bars against d'Alembert, and the orders of convergence in space and time."""
import numpy as np

import plots
from bench import case, observed_order, thin

YOUNG, DENSITY = 200e9, 7850
SPEED = np.sqrt(YOUNG / DENSITY)

PUSHED = """
title: A bar whose end is pushed
time: {end: 3.9e-4, max_step: 5e-7}
parts: {bar: {box: {size: [2, 0.02, 0.02], cells: [200, 2, 2]}, material: steel}}
materials: {steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}
conditions:
  - {nodes: bar/x_min, velocity: {x: 1}}
$rollers
output: {history: {every: 5e-7, elements: [{name: a, near: [0.505, 0.015, 0.015]}, {name: b, near: [1.505, 0.015, 0.015]}], nodes: [{name: n, near: [0.5, 0, 0]}]}}
"""


@case("bar_waves", "waves", "Wave speeds: slender bar, bar on rollers", quick=True)
def bar_waves(bench):
    """The end of a bar of 200 x 2 x 2 elements is driven at 1 m/s. In the slender bar the front travels with c = sqrt(E /
    rho); with lateral restraint the speed is c_L = sqrt(E (1 - nu) / ((1 + nu)(1 - 2 nu) rho)). The speed is measured
    between two stations 100 elements apart and may be wrong by a fifth of an element. Behind the front the stress is
    rho c v and the material moves with v. In the slender bar lateral inertia makes the front an integral of Airy's
    function (Skalak, *J. Appl. Mech.* 24, 1957). It passes one third of its height at c t and oscillates for long:
    levels and means are chosen accordingly."""
    nu = 0.3
    dilatational = np.sqrt(YOUNG * (1 - nu) / ((1 + nu) * (1 - 2 * nu) * DENSITY))
    run = bench.run(PUSHED, rollers="  - {nodes: bar, fixed: [y, z]}")
    h, stress = run.history, DENSITY * dilatational
    level = 0.5 * stress * (1 - 2 * nu) / (1 - nu)
    travel = h.time_of_rise("b_von_mises", level) - h.time_of_rise("a_von_mises", level)
    bench.near("on rollers: speed of the front", 1 / travel, dilatational, relative=2e-3, unit="m/s")
    bench.near("on rollers: stress along", h.at(2.8e-4, "a_stress_xx"), -stress, relative=1e-3, unit="Pa")
    bench.near("on rollers: stress across", h.at(2.8e-4, "a_stress_yy"), -stress * nu / (1 - nu),
               relative=1e-3, unit="Pa")
    bench.near("on rollers: speed of the material", h.at(2.8e-4, "n_vx"), 1, relative=1e-3, unit="m/s")
    bench.below("on rollers: energy balance, largest error", h.largest("energy_error"), 1e-3)
    slender = bench.run(PUSHED, rollers="").history
    stress = DENSITY * SPEED
    travel = slender.time_of_rise("b_von_mises", stress / 3) - slender.time_of_rise("a_von_mises", stress / 3)
    bench.near("slender: speed of the front", 1 / travel, SPEED, relative=2e-3, unit="m/s")
    bench.near("slender: mean stress along", slender.mean(1.5e-4, 3.9e-4, "a_stress_xx"), -stress,
               relative=5e-3, unit="Pa")
    bench.near("slender: mean speed of the material", slender.mean(1.5e-4, 3.9e-4, "n_vx"), 1, relative=5e-3,
               unit="m/s")
    bench.below("slender: energy balance, largest error", slender.largest("energy_error"), 1e-3)

    def draw(axes):
        for name, table, speed in (("slender", slender, SPEED), ("rollers", h, dilatational)):
            for station, x in (("a", 0.505), ("b", 1.505)):
                axes.plot(*thin(1e6 * table["time"], -1e-6 * table[f"{station}_stress_xx"], 300),
                          label=f"{name}, x = {x:.1f} m")
                axes.axvline(1e6 * x / speed, **plots.EXACT)
        axes.set(xlabel="time [us]", ylabel="pressure along [MPa]")
        axes.legend(fontsize=7)

    bench.figure("Fronts at two stations of the pushed bar; dashed: when the exact fronts pass.", draw)


VIBRATING = """
title: A fixed bar in motion
time: {end: $end, step_scale: $scale, max_step: $step}
parts: {bar: {box: {size: [1, $width, $width], cells: [$cells, 1, 1]}, material: steel}}
materials: {steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0}}
elements: {bulk_viscosity: {linear: 0, quadratic: 0}}
initial:
$initial
conditions: [{nodes: bar/x_min, fixed: [x, y, z]}]
output: {history: {every: $every, nodes: [{name: end, near: [1, 0, 0]}, {name: middle, near: [0.5, 0, 0]}]}, fields: {every: 1, write: [velocity]}}
"""


def sum_series(x, t, terms=4000):
    """Displacement of a bar of length 1, fixed at x = 0, whose nodes start at 1 m/s."""
    n = 2 * np.arange(1, terms + 1) - 1
    x, t = np.broadcast_arrays(np.asarray(x, dtype=float)[..., None], np.asarray(t, dtype=float)[..., None])
    return np.sum(8 / (SPEED * np.pi**2 * n**2) * np.sin(n * np.pi / 2 * SPEED * t) * np.sin(n * np.pi / 2 * x),
                  axis=-1)


def move_slabs(cells, speed):
    """Initial velocities speed(x) of the planes of nodes."""
    return "\n".join(f"  - {{nodes: {{inside: [[{(i - 0.25) / cells!r}, -1, -1], [{(i + 0.25) / cells!r}, 1, 1]]}}, "
                     f"velocity: [{float(speed(i / cells))!r}, 0, 0]}}" for i in range(1, cells + 1))


@case("velocity_step", "waves", "A fixed bar with a step in velocity")
def velocity_step(bench):
    """A bar of length L moves at V when its end x = 0 is stopped. Its displacement is the series `u = sum 8 L V sqrt(rho /
    E) / ((2n - 1)^2 pi^2) sin(w_n t) sin((2n - 1) pi x / 2L)`, at the free end a triangle of height V L / c. The run
    lasts one period, 4 L / c. The velocity has jumps, which a scheme of second order spreads over a width ~ h^(2/3)
    (dispersion). The L2 error of the displacement, whose derivative jumps, therefore falls with h^(2/3 * 3/2) = h. The
    tolerance is 1 % of V L / c at the end with 200 elements."""
    sizes, norms, last = [], [], None
    period = 4 / SPEED
    for cells in (25, 50, 100, 200):
        run = bench.run(VIBRATING, end=period, scale=0.9, step=1.0, width=1 / cells, cells=cells, every=period / 400,
                        initial="  - {part: bar, velocity: [1, 0, 0]}")
        h = run.history
        exact = sum_series(1.0, h["time"])
        error = h["end_x"] - 1 - exact
        sizes.append(1 / cells)
        norms.append(np.sqrt(np.trapz(error**2, h["time"]) / period) * SPEED)
        last = h, exact
        bench.below(f"{cells} elements: energy balance, largest error", h.largest("energy_error"), 1e-3)
    h, exact = last
    bench.below("200 elements: end, largest error over V L / c", np.abs(h["end_x"] - 1 - exact).max() * SPEED, 0.01)
    bench.below("200 elements: middle, largest error over V L / c",
                np.abs(h["middle_x"] - 0.5 - sum_series(0.5, h["time"])).max() * SPEED, 0.01)
    bench.near("observed order of the L2 error in h (step in proportion)", observed_order(sizes, norms), 1.0,
               absolute=0.25)
    bench.table(["elements", "L2 error of the end over V L / c"],
                [[f"{1 / s:.0f}", f"{n:.2e}"] for s, n in zip(sizes, norms)])

    def draw(axes):
        axes.plot(h["time"] * SPEED, exact * SPEED, label="series", **plots.EXACT)
        axes.plot(h["time"][::8] * SPEED, (h["end_x"][::8] - 1) * SPEED, ".", markersize=3, label="end, 200 elements")
        axes.plot(h["time"] * SPEED, sum_series(0.5, h["time"]) * SPEED, **plots.EXACT)
        axes.plot(h["time"][::8] * SPEED, (h["middle_x"][::8] - 0.5) * SPEED, ".", markersize=3,
                  label="middle, 200 elements")
        axes.set(xlabel="time over L / c", ylabel="displacement over V L / c")
        axes.legend()

    bench.figure("The fixed bar with initial velocity: percuss against the series.", draw)


def discrete_frequency(cells):
    """First frequency of the bar as a chain of lumped masses."""
    return 2 * cells * SPEED * np.sin(np.pi / (4 * cells))


@case("wave_order", "waves", "Orders of convergence in space and time", quick=True)
def wave_order(bench):
    """The same bar in its first mode, u = A sin(pi x / 2) sin(w t), w = pi c / 2, is smooth and shows the order of the
    scheme. In space: the steps are so short that their error is negligible. Meshes of 8 to 64 elements are compared
    with the exact solution; the phase of a chain of lumped masses is off by (pi h / 2)^2 / 24. In time: one mesh of 8
    elements with halved steps is compared with the exact motion of its chain of masses, w_h = (2 c / h) sin(pi h / 4).
    Both errors are of order 2; the error in space makes waves slow and that in time makes them fast. The amplitude is
    1e-6 L, so that the problem is linear."""
    period = 4 / SPEED
    end, speed = 1.25 * period, 1e-6 * SPEED

    def measure(cells, step, frequency):
        run = bench.run(VIBRATING, end=end, scale=0.9, step=step, width=0.125, cells=cells, every=0,
                        initial=move_slabs(cells, lambda x: speed * np.sin(np.pi * x / 2)))
        h = run.history
        error = h["end_x"] - 1 - speed / frequency * np.sin(frequency * h["time"])
        return np.sqrt(np.trapz(error**2, h["time"]) / end) / (speed / frequency)

    meshes = [8, 16, 32] if bench.quick else [8, 16, 32, 64]
    space = [measure(n, 2e-8, np.pi * SPEED / 2) for n in meshes]
    steps = [end / n for n in (80, 160, 320, 640)]
    time = [measure(8, dt, discrete_frequency(8)) for dt in steps]
    bench.near("observed order in space", observed_order([1 / n for n in meshes], space), 2.0, absolute=0.05)
    bench.near("observed order in time", observed_order(steps, time), 2.0, absolute=0.05)
    for name, heading, sizes, errors in (("space", "elements", meshes, space),
                                         ("time", "steps", [end / dt for dt in steps], time)):
        orders = [""] + [f"{np.log(a / b) / np.log(s / r):.3f}"
                         for a, b, r, s in zip(errors, errors[1:], sizes, sizes[1:])]
        bench.table([heading, f"L2 error over the amplitude ({name})", "order"],
                    [[f"{s:.0f}", f"{e:.3e}", o] for s, e, o in zip(sizes, errors, orders)])

    def draw(axes):
        h = 1 / np.array(meshes)
        axes.loglog(h / h[0], space, "o-", label="space: h over that of 8 elements")
        axes.loglog(np.array(steps) / steps[0], time, "s-", label="time: step over that of 80 steps")
        axes.loglog([0.1, 1], [0.5e-2 * 0.1**2 * 2, 0.5e-2 * 2], label="order 2", **plots.EXACT)
        axes.set(xlabel="relative size", ylabel="L2 error over the amplitude")
        axes.legend()

    bench.figure("Errors of the first mode of a bar in space and in time.", draw)
