"""A ball that bounces in a box."""
import numpy as np

from bench import case, thin

BOX = """
title: A ball in a box
time: {end: $end$time}
parts: {ball: {sphere: {radius: 1, cells: 4}, material: m$rigid}}
materials: {m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0.25}}
$viscosity
initial: [{part: ball, velocity: [$vx, $vy, $vz]}]
walls:
  - {normal: x, point: [-2, 0, 0]}
  - {normal: -x, point: [2, 0, 0]}
  - {normal: y, point: [0, -2, 0]}
  - {normal: -y, point: [0, 2, 0]}
  - {normal: z, point: [0, 0, -2]}
  - {normal: -z, point: [0, 0, 2]}
contact: {surfaces: none$enforcement}
output: {history: {every: $every, parts: [ball]}}
"""
NO_VISCOSITY = "elements: {bulk_viscosity: {linear: 0, quadratic: 0}}"


def measure_ball(history):
    """Bounces as changes of sign of the momentum, and the sum of energies over that at the start."""
    signs = np.sign(np.stack([history[f"momentum_{axis}"] for axis in "xyz"]))
    total = history["kinetic"] + history["internal"] + history["hourglass"]
    return int((signs[:, 1:] * signs[:, :-1] < 0).sum()), total / history["kinetic"][0]


@case("ball_in_box", "impact", "Elastic ball between six rigid walls")
def ball_in_box(bench):
    """An elastic ball of 32 elements flies in a box of six rigid walls without friction, at 1.6 % of the speed of a bar
    wave, without any viscosity. Bounces make it vibrate and spin, and nothing but contact may take energy.

    Kinematic and Lagrangian enforcement stop the nodes that touch, and lose their energy at every bounce: contact takes,
    never gives (at most 1e-4 of the energy at the start), and the ball slows down. Springs give back what they take.
    Momentum is that of the walls' impulse to round-off.

    The energy spreads over all modes, also those whose period is hardly longer than two steps. There the central
    difference does not keep it. The balance is closed within 1 %, with springs (where all energy stays in the
    vibration) at a third of the stable step; at 0.9 of it, shown and not judged, the error is twenty times as large (see
    the open points)."""
    start = {"vx": 0.013, "vy": 0.0083, "vz": 0.0047, "every": 7.0, "viscosity": NO_VISCOSITY, "rigid": ""}
    rows, curves = [], []
    for name, end, time in (("kinematic", 92000.0, ""), ("lagrange", 92000.0, ""), ("penalty", 23400.0, ""),
                            ("penalty", 23400.0, ", step_scale: 0.3")):
        run = bench.run(BOX, **start, end=end, time=time, enforcement=f", enforcement: {name}")
        h, (bounces, total) = run.history, measure_ball(run.history)
        label = f"{name}{', a third of the step' if time else ''}"
        given = h["contact"] / h["kinetic"][0]
        if name != "penalty" or time:
            bench.below(f"{label}: energy that contact gives, over that at the start", float(given.max()), 1e-4)
            bench.below(f"{label}: energy balance, largest error", h.largest("energy_error"), 0.01)
        bench.below(f"{label}: linear momentum, relative change without the walls' impulse",
                    run.summary["momentum"]["linear_error"], 1e-12)
        rows.append([label, run.summary["steps"], bounces, f"{total[-1]:.4f}",
                     f"{h['kinetic'][-1] / h['kinetic'][0]:.4f}", f"{given[-1]:+.4f}",
                     f"{h.largest('energy_error'):.1e}"])
        curves.append((label, h["time"], total))
    bench.table(["contact", "steps", "bounces",
                 "energy at the end over that at the start", "kinetic", "contact", "energy error"], rows)

    def draw(axes):
        for name, times, energy in curves:
            axes.plot(*thin(times, energy, 300), label=name)
        axes.set(xlabel="time", ylabel="energy over that at the start")
        axes.legend()

    bench.figure("Energy of the ball, of motion and of deformation.", draw)


@case("rigid_ball_in_box", "impact", "Rigid ball between six rigid walls", quick=True)
def rigid_ball_in_box(bench):
    """The box of `ball_in_box` with a rigid ball that may not turn. Where it meets a wall `contact.restitution` is 1: every
    bounce turns one component of the velocity around. The components keep their size to round-off over more than a thousand
    bounces, and contact gives and takes nothing. With springs of contact, the rule is the same (theory_contact.md, section 5)."""
    for name in ("kinematic", "penalty"):
        h = bench.run(BOX, vx=0.013, vy=0.0083, vz=0.0047, every=7.0, viscosity="",
                      rigid=", rigid: {fixed: [rx, ry, rz]}", end=92000.0, time=", max_step: 4",
                      enforcement=f", enforcement: {name}, restitution: 1").history
        bounces = 0
        for axis in "xyz":
            momentum = h[f"momentum_{axis}"]
            bounces += int((np.diff(np.sign(momentum)) != 0).sum())
            bench.near(f"{name}: size of the momentum along {axis}, end over start",
                       abs(h.last(f"momentum_{axis}")) / h.first(f"momentum_{axis}"), 1, relative=1e-10)
        bench.above(f"{name}: bounces", bounces, 1000)
        bench.below(f"{name}: energy of contact over that at the start, largest",
                    h.largest("contact") / h.first("kinetic"), 1e-10)
