"""Closed scenes with contact: nothing from outside, so momentum stays to round-off and energy to what contact books."""
import numpy as np

import choices
from bench import case

MATERIALS = """
materials:
  steel: {model: j2_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: 400e6, hardening_modulus: 1e9}
  brick: {model: elastic, density: 2000, youngs_modulus: 15e9, poissons_ratio: 0.2}
"""


PUSHED = {"wall": 0.02, "blocks": 2e-3, "cradle": 2e-3}  # at least this way [m]: a quarter of what was measured or more


@case("closed_scenes", "closed", "Momentum and energy of closed scenes", quick=True)
def closed_scenes(bench):
    """*Wall*: loose bricks face to face, hit obliquely by an elastic-plastic rod at 200 m/s, friction 0.3. *Blocks*:
    elastic blocks and a ball collide edge first, corner first and spinning. *Cradle*: four elastic balls in a row, at
    the origin and 1000 m from it.

    Linear and angular momentum stay within 1e-12 (round-off of 1e4 impulses and sums of 1e3 nodes). The energy balance
    closes within 0.1 % of the largest energy where all is elastic, at default settings, and 1 % otherwise. Contact may
    take energy, never give it, and friction does no positive work. All of this would hold without contact as well. So
    every scene must have interactions, the wall's friction must take energy, and the far brick, the first block and the
    last ball must be moved."""
    for name, text in choices.list_enforcements(bench).items():
        wall = bench.run("""
time: {end: 8e-4}
parts:
  rod: {cylinder: {radius: 0.03, length: 0.2, cells: [3, 12]}, at: [-0.203, 0.31, 0.14], axis: [1, 0.05, 0.02], material: steel}
  bricks: {box: {size: [0.1, 0.2, 0.06], cells: [2, 4, 2]}, array: {count: [1, 3, 5], pitch: [0.1, 0.2, 0.06], stagger: 0.5}, material: brick}
initial: [{part: rod, velocity: [200, 10, 4]}]
contact: {surfaces: all, friction: 0.3$enforcement}
output: {history: {every: 1e-5, nodes: [{name: pushed, near: [0.05, 0.3, 0.15], part: bricks}]}}
""" + MATERIALS, enforcement=text)
        blocks = bench.run("""
time: {end: 4e-3}
parts:
  a: {box: {size: [0.1, 0.1, 0.1], cells: [3, 3, 3]}, material: brick}
  b: {box: {size: [0.1, 0.1, 0.1], cells: [4, 4, 4]}, rotate: [{axis: [1, 0, 0], angle: 45}], at: [0.02, 0.05, 0.11], material: brick}
  c: {box: {size: [0.1, 0.1, 0.1], cells: [3, 3, 3]}, rotate: [{axis: [0, 0, 1], angle: 45}, {axis: [1, 0, 0], angle: 54.7}], at: [0.05, 0.05, -0.2], material: brick}
  d: {sphere: {radius: 0.05, cells: 6}, at: [0.16, 0.05, 0.05], material: brick}
initial:
  - {part: b, velocity: [0, 0, -20]}
  - {part: c, velocity: [0, 0, 25], angular_velocity: [0, 0, 50]}
  - {part: d, velocity: [-15, 0, 3]}
contact: {surfaces: all$enforcement}
output: {history: {every: 2e-5, nodes: [{name: pushed, near: [0.05, 0.05, 0.05], part: a}]}}
""" + MATERIALS, enforcement=text)
        scenes = [("wall", wall, 0.01, "x"), ("blocks", blocks, 1e-3, "z")]
        for x in 0.0, 1000.0:
            cradle = bench.run("""
time: {end: 1.6e-3}
parts:
  first: {sphere: {radius: 0.05, cells: 6}, at: [$x, 0, 0], material: brick}
  row: {sphere: {radius: 0.05, cells: 6}, array: {count: [3, 1, 1], pitch: [0.1001, 0, 0]}, at: [$second, 0, 0], material: brick}
initial: [{part: first, velocity: [5, 0, 0]}]
contact: {surfaces: all$enforcement}
output: {history: {every: 1e-5, nodes: [{name: pushed, near: [$last, 0, 0]}]}}
""" + MATERIALS, enforcement=text, x=x, second=x + 0.1001, last=x + 0.3003)
            scenes.append((f"cradle at {x:.0f} m", cradle, 1e-3, "x"))
        for scene, run, energy, axis in scenes:
            which, h = f"{name}, {scene}", run.history
            bench.closed(run, energy, which)
            bench.below(f"{which}: energy that contact gives over the kinetic energy",
                        h["contact"].max() / h["kinetic"][0], energy)
            bench.above(f"{which}: interactions", h.largest("contacts"), 0)
            bench.above(f"{which}: way of what is pushed", abs(h.last(f"pushed_{axis}") - h.first(f"pushed_{axis}")),
                        PUSHED[scene.split()[0]], "m")
            if scene == "wall":
                bench.below(f"{which}: work of friction", h.last("friction"), 0, "J")
                bench.near(f"{which}: largest rise of the work of friction", max(np.diff(h["friction"]).max(), 0), 0,
                           absolute=0.0, unit="J")
            else:
                bench.near(f"{which}: work of friction", h.largest("friction"), 0, absolute=0.0, unit="J")


PILE = """
title: A pile of bricks that rests
time: {end: 1e3, max_steps: $steps}
parts:
  bricks: {box: {size: [0.2, 0.1, 0.06], cells: [2, 2, 1]}, array: {count: [1, 2, 3], pitch: [0.2, 0.1, 0.06], stagger: 0.25}, material: brick}
loads: {gravity: [0, 0, -9.81]}
walls: [{normal: z, friction: 0.5}]
contact: {surfaces: all, friction: 0.5$enforcement}
materials: {brick: {model: elastic, density: 2000, youngs_modulus: 15e6, poissons_ratio: 0.2}}
output: {history: {every: $every, nodes: [{name: n, near: [0.1, 0.1, 0.18]}, {name: m, near: [0, 0, 0.18]}]}}
"""


@case("resting_pile", "hard", "Stacked bricks at rest for a million steps")
def resting_pile(bench):
    """Six soft bricks in three layers, each layer shifted by a quarter of a brick, rest on a floor under gravity, friction
    0.5, at rest and without gaps at the start. The weight is applied at once. The bricks are elastic, and nothing damps
    their bending and shear. A vibration remains, which may neither grow nor move anything.

    Three quantities are measured from a tenth of the run on. The first is the mean position of two nodes of the upper
    layer in the second and in the last tenth of it over a brick's height. The second is kinetic energy over m g H of
    the pile. The third is its largest value in the last third over that in the middle third. The balance is relative to
    the work of the weight on the pile, 1e-4 of m g H; springs miss some of it at the start, and none later.

    The kinematic iteration is run with its default tolerance as well, which leaves more vibration: there the limit is a
    seventh of the initial vibration (7e-5). Lagrange runs 20 000 steps only: a step takes six times as long and more,
    two hours for a million, and the vibration still decays at their end."""
    runs = {name: (text, 1e-6) for name, text in choices.list_enforcements(bench).items()}
    runs["kinematic"] = runs["kinematic"][0], 1e-5
    runs["kinematic, tolerance 1e-5"] = runs["kinematic"][0] + ", tolerance: 1e-5", 1e-6
    for name, (text, hum) in runs.items():
        steps = ((3_000 if name == "lagrange" else 20_000) if bench.quick else 20_000 if name == "lagrange"
                 else 1_000_000)
        run = bench.run(PILE, steps=steps, every=0.01 * steps * 1e-6, enforcement=text)
        h = run.history
        share = h["time"] / h["time"][-1]
        late, middle, last = share > 0.1, (share > 1 / 3) & (share < 2 / 3), share > 2 / 3
        scale = 6 * 2000 * 0.2 * 0.1 * 0.06 * 9.81 * 0.09
        early, end = (share > 0.1) & (share < 0.2), share > 0.9
        drift = max(abs(h[f"{n}_{x}"][end].mean() - h[f"{n}_{x}"][early].mean()) for n in "nm" for x in "xyz")
        bench.equal(f"{name}: steps", run.summary["steps"], steps)
        bench.below(f"{name}: drift over a brick's height", drift / 0.06, 1e-5)
        bench.below(f"{name}: largest kinetic energy after a tenth of the run over m g H",
                    h["kinetic"][late].max() / scale, hum)
        bench.below(f"{name}: the same of the last third over the middle third",
                    h["kinetic"][last].max() / h["kinetic"][middle].max(), 1.1)
        bench.below(f"{name}: energy balance, largest error", h.largest("energy_error"),
                    1e-2 if name == "penalty" else 1e-3)


@case("pile_on_ranks", "hard", "Stacked bricks on four ranks", quick=True)
def pile_on_ranks(bench):
    """The pile above by every enforcement for 3000 steps (Lagrange: 300, of a sixth of the speed), in which its weight is
    applied and it vibrates, on one rank and on four: the same bits."""
    for name, text in choices.list_enforcements(bench).items():
        steps = 300 if name == "lagrange" or bench.quick else 3_000
        one, four = (bench.run(PILE, ranks=ranks, steps=steps, every=1e-4, enforcement=text) for ranks in (1, 4))
        bench.equal(f"{name}: steps", one.summary["steps"], steps)
        bench.above(f"{name}: interactions, most at once", one.history["contacts"].max(), 0)
        bench.equal(f"{name}: state_hash on 4 ranks and on 1", four.summary["state_hash"], one.summary["state_hash"])
        bench.equal(f"{name}: history.csv on 4 ranks, every byte",
                    "same" if one.history_bytes == four.history_bytes else "other", "same")
