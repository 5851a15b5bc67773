"""Elastic balls against Hertz."""
import numpy as np

import meshes
import plots
from bench import case, thin

RADIUS, YOUNG, NU, DENSITY = 0.01, 210e9, 0.3, 7850
STEEL = "materials: {steel: {model: elastic, density: 7850, youngs_modulus: 210e9, poissons_ratio: 0.3}}\n"


def find_hertz(modulus, curvature, mass, speed):
    """Largest approach, force and time of contact."""
    depth = (15 * mass * speed**2 / (16 * modulus * np.sqrt(curvature)))**0.4
    return depth, 4 / 3 * modulus * np.sqrt(curvature) * depth**1.5, 2.9433 * depth / speed


def follow_hertz(modulus, curvature, mass, speed, times):
    """Force over time from impact on: m x'' = -k x^(3/2)."""
    from scipy.integrate import solve_ivp
    k = 4 / 3 * modulus * np.sqrt(curvature)
    path = solve_ivp(lambda _, y: [y[1], -k * max(y[0], 0)**1.5 / mass], (0, times[-1]), [0, speed], t_eval=times,
                     rtol=1e-9, atol=1e-15)
    return k * np.maximum(path.y[0], 0)**1.5


def drop_on_wall(bench, across, share, elements=""):
    """A quarter of the ball meets a rigid wall at 1 m/s. elements: what `elements: {...}` says, empty for the default."""
    path = meshes.write_exodus(bench.file(f"ball_{across}.exo"), *meshes.quarter_ball(bench, RADIUS, across, share))
    return bench.run("""
title: Hertz impact on a wall
time: {end: 6.2e-5}
parts: {ball: {exodus: {file: $file}, at: [0, 0, 0.0100001], material: steel}}
$elements
initial: [{part: ball, velocity: [0, 0, -1]}]
conditions:
  - {nodes: {name: ball, inside: [[0, -1, -1], [0, 1, 1]]}, symmetry: x}
  - {nodes: {name: ball, inside: [[-1, 0, -1], [1, 0, 1]]}, symmetry: y}
walls: [{normal: [0, 0, 1]}]
output: {history: {every: 1e-7}}
""" + STEEL, file=path, elements=f"elements: {{{elements}}}" if elements else "")


def find_approach(times, speed, gap):
    """How far two centres of mass come together after the first touch: the integral of the speed at which they near each other, without the gap at the start."""
    return np.max(np.cumsum(0.5 * (speed[1:] + speed[:-1]) * np.diff(times))) - gap


def compare_hertz(which, measured, meshes_own, exact):
    """Rows of a table: approach, force and time of a run, of the formula with the mass of the mesh and with that of the exact ball."""
    rows = []
    for i, (name, scale) in enumerate((("approach [um]", 1e6), ("force [N]", 1), ("time [us]", 1e6))):
        rows.append([which, name, f"{scale * measured[i]:.5g}", f"{scale * meshes_own[i]:.5g}",
                     f"{100 * (measured[i] / meshes_own[i] - 1):+.2f} %", f"{scale * exact[i]:.5g}",
                     f"{100 * (measured[i] / exact[i] - 1):+.1f} %"])
    return rows


HERTZ_TABLE = ["run", "quantity", "measured",
               "Hertz, mass of the mesh", "difference", "Hertz, exact ball", "difference"]


@case("hertz_wall", "impact", "Hertz: a ball on a rigid wall")
def hertz_wall(bench):
    """A steel ball (R = 10 mm, 210 GPa, 0.3, 7850 kg/m^3) hits a rigid wall. Hertz gives, with `E* = E / (1 - nu^2)`, the
    approach `delta = (15 m v^2 / (16 E* sqrt R))^(2/5)`, the force `F = 4/3 E* sqrt(R) delta^(3/2)` and the time
    `2.9433 delta / v`. At 1 m/s they are 17.80 um, 2309.8 N and 52.37 us.

    A quarter of the ball is used, its cells concentrated at the pole by a Moebius map, so that 4 and 10 elements lie
    across the contact radius of 0.42 mm. At least 5 are required, so the second is judged and the first shown. The
    approach is the travel of the centre of mass from the first touch on, the integral of its speed.

    The mass in the formula is that of the mesh, since large facets at the far side cut off a fifth of the ball.
    Approach and time go with m^0.4, the force with m^0.6. The table shows the exact ball too. Approach and time, which
    are proportional to each other, may be 3 % off, the force 5 %: Hertz's half-spaces are the limit of a small contact,
    and a wave needs 3.4 us through the ball. The rebound keeps more than 99 % of the speed (Hunter, *J. Mech. Phys.
    Solids* 5, 1957: vibration takes 0.02 % at this speed)."""
    speed = 1.0
    exact = 4 / 3 * np.pi * RADIUS**3 * DENSITY
    curves, rows = [], []
    for across, share in ((24, 0.8), (28, 0.84)) if bench.quick else ((24, 0.8), (36, 0.86)):
        run = drop_on_wall(bench, across, share)
        h = run.history
        mass = -4 * h.first("momentum_z") / speed
        depth, force, time = find_hertz(YOUNG / (1 - NU**2), RADIUS, mass, speed)
        touching = h["time"][h["contacts"] > 0]
        which = f"{across} across"
        measured = (find_approach(h["time"], -4 * h["momentum_z"] / mass, 1e-7), 4 * h["wall_force_z"].max(),
                    touching[-1] - touching[0])
        rows += compare_hertz(f"{which}, {100 * mass / exact:.1f} % of the mass", measured, (depth, force, time),
                              find_hertz(YOUNG / (1 - NU**2), RADIUS, exact, speed))
        curves.append((which, h, touching[0]))
    bench.near(f"{which}: approach", 1e6 * measured[0], 1e6 * depth, relative=0.03, unit="um")
    bench.near(f"{which}: largest force", measured[1], force, relative=0.05, unit="N")
    bench.near(f"{which}: time of contact", 1e6 * measured[2], 1e6 * time, relative=0.03, unit="us")
    bench.above(f"{which}: restitution", -h.last("momentum_z") / h.first("momentum_z"), 0.99)
    bench.below(f"{which}: energy balance, largest error", h.largest("energy_error"), 1e-3)
    bench.table(HERTZ_TABLE, rows)

    def draw(axes):
        t = np.linspace(0, 1.02 * time, 200)
        axes.plot(1e6 * t, follow_hertz(YOUNG / (1 - NU**2), RADIUS, mass, speed, t), label="Hertz", **plots.EXACT)
        for which, table, start in curves:
            axes.plot(*thin(1e6 * (table["time"] - start), 4 * table["wall_force_z"], 300), label=which)
        axes.set(xlabel="time since impact [us]", ylabel="force [N]")
        axes.legend()

    bench.figure("Force of the wall on the ball.", draw)


@case("hertz_balls", "impact", "Hertz: two balls")
def hertz_balls(bench):
    """Two such balls of different meshes (5 and 6 elements across the contact radius of 0.32 mm) meet at a relative speed
    of 1 m/s. 1 / E* = 2 (1 - nu^2) / E, curvature radius R / 2, reduced mass m / 2: 20.44 um, 1005.4 N, 60.16 us. The
    approach is the integral of the closing speed of the centres of mass, from the first touch on. The force is the rate
    of the momentum of one ball (a mean over 2 us). The formula takes the masses of the meshes, and tolerances are as on
    the wall. Momentum must be conserved to round-off although the meshes do not match."""
    speed = 1.0
    exact = 4 / 3 * np.pi * RADIUS**3 * DENSITY
    low = meshes.write_exodus(bench.file("low.exo"), *meshes.quarter_ball(bench, RADIUS, 28, 0.84))
    high = meshes.write_exodus(bench.file("high.exo"), *meshes.quarter_ball(bench, RADIUS, 32, 0.84))
    run = bench.run("""
title: Hertz impact of two balls
time: {end: 7e-5}
parts:
  low: {exodus: {file: $low}, rotate: [{axis: [1, 1, 0], angle: 180}], at: [0, 0, -0.0100001], material: steel}
  high: {exodus: {file: $high}, at: [0, 0, 0.0100001], material: steel}
initial: [{part: high, velocity: [0, 0, -0.5]}, {part: low, velocity: [0, 0, 0.5]}]
conditions:
  - {nodes: {inside: [[0, -1, -1], [0, 1, 1]]}, symmetry: x}
  - {nodes: {inside: [[-1, 0, -1], [1, 0, 1]]}, symmetry: y}
contact: {surfaces: [[low, high]]}
output: {fields: {every: 1e-6, write: [velocity, mass]}, history: {every: 1e-7}}
""" + STEEL, low=low, high=high)
    frames, h = run.frames, run.history
    nodes = [frames.nodes_of_part(p) for p in (0, 1)]
    mass = frames.node("mass", 0)
    masses = [4 * mass[n].sum() for n in nodes]
    depth, force, time = find_hertz(0.5 * YOUNG / (1 - NU**2), RADIUS / 2, masses[0] * masses[1] / sum(masses), speed)
    pulls = np.array([[4 * (mass[n] * frames.node("velocity", f)[n, 2]).sum() for n in nodes]
                      for f in range(frames.count)])
    rate = (pulls[2:, 1] - pulls[:-2, 1]) / (frames.times[2:] - frames.times[:-2])
    touching = h["time"][h["contacts"] > 0]
    nearing = pulls[:, 0] / masses[0] - pulls[:, 1] / masses[1]
    measured = (find_approach(frames.times, nearing, 2e-7), rate.max(), touching[-1] - touching[0])
    bench.near("approach", 1e6 * measured[0], 1e6 * depth, relative=0.03, unit="um")
    bench.near("largest force", measured[1], force, relative=0.05, unit="N")
    bench.near("time of contact", 1e6 * measured[2], 1e6 * time, relative=0.03, unit="us")
    bench.above("restitution", (pulls[-1, 1] / masses[1] - pulls[-1, 0] / masses[0]) / speed, 0.99)
    bench.below("linear momentum, relative change",
                abs(pulls.sum(axis=1) - pulls[0].sum()).max() / (0.5 * masses[1]), 1e-12)
    bench.below("energy balance, largest error", h.largest("energy_error"), 1e-3)
    bench.table(HERTZ_TABLE,
                compare_hertz(f"{50 * sum(masses) / exact:.1f} % of the mass", measured, (depth, force, time),
                              find_hertz(0.5 * YOUNG / (1 - NU**2), RADIUS / 2, exact / 2, speed)))

    def draw(axes):
        t = np.linspace(0, 1.02 * time, 200)
        axes.plot(1e6 * t, follow_hertz(0.5 * YOUNG / (1 - NU**2), RADIUS / 2, masses[0] * masses[1] / sum(masses),
                                        speed, t), label="Hertz", **plots.EXACT)
        axes.plot(1e6 * (frames.times[1:-1] - touching[0]), rate, ".", label="percuss")
        axes.set(xlabel="time since impact [us]", ylabel="force [N]")
        axes.legend()

    bench.figure("Force between the balls.", draw)


@case("sphere_drop", "impact", "Restitution of an elastic ball", quick=True)
def sphere_drop(bench):
    """The scene `inputs/elastic_sphere_drop` on coarser and finer meshes: a steel ball at 15 m/s on a rigid plane. It
    rebounds with its speed except for two losses. Vibration keeps about 1.04 v^(3/5) c^(-3/5) of the energy, 1 % of the
    speed (Hunter 1957). The layers of nodes that stop lose energy of first order in h. Restitution must be above 0.99
    on the finest mesh."""
    rows = []
    for across in (16, 32) if bench.quick else (16, 32, 48):
        run = bench.run("""
title: sphere drop
time: {end: 4e-5}
parts: {ball: {sphere: {radius: 0.01, cells: $across}, at: [0, 0, 0.010001], material: steel}}
initial: [{part: ball, velocity: [0, 0, -15]}]
walls: [{normal: [0, 0, 1]}]
output: {history: {every: 1e-7}}
""" + STEEL, across=across)
        h = run.history
        back = -h.last("momentum_z") / h.first("momentum_z")
        rows.append([across, run.summary["elements"], f"{back:.5f}",
                     f"{run.summary['energy']['contact'] / h.first('kinetic'):.4f}"])
        bench.below(f"{across} across: energy balance, largest error", h.largest("energy_error"), 1e-3)
    bench.above(f"{rows[-1][0]} across: restitution", back, 0.99)
    bench.table(["across", "elements", "restitution", "contact work over kinetic energy"], rows)
