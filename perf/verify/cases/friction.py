"""Coulomb friction against the motion of rigid blocks."""
import numpy as np

import choices
import plots
from bench import case, thin

G, MASS = 9.81, 16.0
# 16 kg, soft so that steps are long: weight strains it by 1e-4. The answers are those of a rigid block; one that bends without damping
# flutters while it slides (docs/limits.md), so its bending is damped.
SOFT = ("elements: {hourglass: {kind: viscous}}\nmaterials: {soft: {model: elastic, density: 1000, "
        "youngs_modulus: 1e7, poissons_ratio: 0.3}}\n")
BLOCK = "block: {box: {size: [0.4, 0.4, 0.1], cells: [4, 4, 2]}, material: soft}"


@case("sliding_block", "friction", "Friction: a block slides to rest", quick=True)
def sliding_block(bench):
    """A block at 5 m/s on a floor with mu = 0.3 stops after v^2 / (2 mu g) = 4.2474 m and v / (mu g) = 1.6989 s; friction
    takes m v^2 / 2. It slides on a rigid wall and, at 2 m/s, over the faces of a plate (0.6796 m; their corners must
    not deflect it). The block is elastic, and its weight is applied at once and vibrates for a while; all is still
    within 0.1 %. Its bending is damped (viscous hourglass control), because an undamped one flutters. Contact work and
    viscosity contain the energy of the vibration. Friction alone and the sum are within 0.1 % each."""
    run = bench.run("""
time: {end: 1.9}
parts: {""" + BLOCK + """}
initial: [{part: block, velocity: [5, 0, 0]}]
loads: {gravity: [0, 0, -9.81]}
walls: [{normal: [0, 0, 1], friction: 0.3}]
output: {history: {every: 1e-3, nodes: [{name: n, near: [0.2, 0.2, 0.05]}]}}
""" + SOFT)
    h, energy = run.history, run.summary["energy"]
    bench.near("wall: distance", h.last("n_x") - 0.2, 4.2474, relative=1e-3, unit="m")
    straight = h["momentum_x"] > 0.05 * MASS * 5
    bench.near("wall: time, from the straight line of the momentum", h["time"][straight][-1] / 0.95, 1.6989,
               relative=1e-3, unit="s")
    bench.near("wall: work of friction", energy["friction"], -0.5 * MASS * 25, relative=1e-3, unit="J")
    bench.near("wall: with the ringing that contact and viscosity took",
               energy["friction"] + energy["contact"] - energy["viscous"], -0.5 * MASS * 25, relative=1e-3, unit="J")
    bench.below("wall: energy balance, largest error", h.largest("energy_error"), 1e-3)
    on_wall = h
    for name, text in choices.list_enforcements(bench).items():
        h = bench.run("""
time: {end: 0.8}
parts:
  block: {box: {size: [0.4, 0.4, 0.1], cells: [4, 4, 2]}, at: [0.1, 0.2, 0], material: soft}
  plate: {box: {size: [1.5, 0.8, 0.1], cells: [9, 5, 1]}, at: [0, 0, -0.1], material: soft}
initial: [{part: block, velocity: [2, 0, 0]}]
conditions: [{nodes: plate/z_min, fixed: [x, y, z]}]
loads: {gravity: [0, 0, -9.81]}
contact: {surfaces: all, friction: 0.3$enforcement}
output: {history: {every: 1e-3, nodes: [{name: n, near: [0.3, 0.4, 0.05], part: block}]}}
""" + SOFT, enforcement=text).history
        bench.near(f"plate, {name}: distance", h.last("n_x") - 0.3, 4 / (2 * 0.3 * G), relative=1e-3, unit="m")
        bench.near(f"plate, {name}: distance aside", h.last("n_y") - 0.4, 0, absolute=1e-6, unit="m")
        bench.below(f"plate, {name}: energy balance, largest error", h.largest("energy_error"), 1e-3)

    def draw(axes):
        t = np.linspace(0, 1.9, 200)
        axes.plot(t, np.maximum(0, 5 - 0.3 * G * t), label="exact", **plots.EXACT)
        axes.plot(*thin(on_wall["time"], on_wall["momentum_x"] / MASS, 200), label="percuss, on a wall")
        axes.set(xlabel="time [s]", ylabel="mean speed [m/s]")
        axes.legend()

    bench.figure("The sliding block.", draw)


@case("incline", "friction", "Friction: a block on an incline")
def incline(bench):
    """The slope is 30 degrees. With mu = 0.3 the block slides at a = g (sin - mu cos) = 2.3563 m/s^2; with mu = 0.7 > tan
    it sticks. The weight is applied at once, and during the vibration single nodes slip a little (below 1 mm). After
    that nothing may creep: from 1 to 2 s the mean position stays within 1 um and friction does no work.

    Bending is damped, by viscous hourglass control as above or by `stiffness_damping` of 1e-4 s, a third of the step.
    *Without damping it does not stick*: the block flutters and creeps down. This is no answer but a measurement, limited
    to 2 % of the distance without friction, g sin t^2 / 2 = 9.81 m in 2 s. It is the weight, applied at once, that starts
    the flutter: an undamped block that begins at rest under its weight (`start.relaxation`) sticks."""
    template = """
time: {end: $end}
parts: {""" + BLOCK + """}
loads: {gravity: [$gx, 0, $gz]}
walls: [{normal: [0, 0, 1], friction: $mu}]
output: {history: {every: 1e-3, nodes: [{name: n, near: [0.2, 0.2, 0.05]}]}}
""" + SOFT
    angle = np.pi / 6
    gravity = {"gx": G * np.sin(angle), "gz": -G * np.cos(angle)}
    h = bench.run(template, end=1.0, mu=0.3, **gravity).history
    bench.near("slides: acceleration from the distance", 2 * (h.last("n_x") - 0.2), 2.3563, relative=1e-3, unit="m/s^2")
    bench.near("slides: acceleration from the momentum", h.last("momentum_x") / MASS, 2.3563, relative=1e-3,
               unit="m/s^2")
    default = template.replace("elements: {hourglass: {kind: viscous}}\n", "")
    damped = default + "elements: {stiffness_damping: 1e-4}\n"
    for name, deck in (("sticks", template), ("stiffness damping, sticks", damped),
                       ("at rest at first, sticks", default + "start: {relaxation: {tolerance: 1e-9}}\n")):
        h = bench.run(deck, end=2.0, mu=0.7, **gravity).history
        bench.near(f"{name}: place after the ringing", h.mean(0.9, 1.0, "n_x"), 0.2, absolute=1e-3, unit="m")
        bench.near(f"{name}: creep in a second", h.mean(1.9, 2.0, "n_x") - h.mean(0.9, 1.0, "n_x"), 0,
                   absolute=1e-6, unit="m")
        bench.near(f"{name}: work of friction from 1 to 2 s", h.last("friction") - h.at(1.0, "friction"), 0,
                   absolute=1e-15, unit="J")
    h = bench.run(default, end=2.0, mu=0.7, **gravity).history
    bench.near("default elements, undamped: creep in 2 s", h.last("n_x") - h.first("n_x"), 0,
               absolute=0.02 * 2 * gravity["gx"], unit="m")


@case("oblique_impact", "friction", "Friction: oblique impact with full sliding", quick=True)
def oblique_impact(bench):
    """A ball at 20 m/s along and 2 m/s onto a wall with mu = 0.1 slides throughout. Every contact impulse has mu times its
    normal part along the wall, so that dv_t = mu (1 + e) v_n for any restitution e. The tolerance is round-off of some
    hundred impulses."""
    h = bench.run("""
time: {end: 6e-4}
parts: {ball: {sphere: {radius: 0.05, cells: 6}, at: [0, 0, 0.0501], material: steel}}
materials: {steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}
initial: [{part: ball, velocity: [20, 0, -2]}]
walls: [{normal: [0, 0, 1], friction: 0.1}]
output: {history: {every: 0}}
""")
    run, h = h, h.history
    start = -h.first("momentum_z")
    restitution = h.last("momentum_z") / start
    change = (h.first("momentum_x") - h.last("momentum_x")) / start
    bench.near("change of the tangential speed over mu (1 + e) v_n", change / (0.1 * (1 + restitution)), 1.0,
               relative=1e-9)
    bench.above("it came back: restitution", restitution, 0.8)
    bench.below("angular momentum, change that the wall does not explain",
                run.summary["momentum"]["angular_error"], 1e-12)
