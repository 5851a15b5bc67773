"""Round bodies that slide until they roll."""
import numpy as np

import plots
from bench import case, thin

G = 9.81

ROLLER = """
title: A cylinder slides until it rolls
time: {end: $end, max_step: $step}
parts: {wheel: {tube: {inner_radius: 0.5, outer_radius: 1, length: 0.5, cells: [1, $faces, 1]}, axis: y, rotate: [{axis: y, angle: $turn}], at: [0, 0, $height], material: m, rigid: {mass: 1, center: [0, 0.25, $height], inertia: [$across, $inertia, $across, 0, 0, 0]}}}
materials: {m: {model: elastic, density: 1000, youngs_modulus: 1e7, poissons_ratio: 0.3}}
initial: [{part: wheel, velocity: [1, 0, 0], angular_velocity: [0, $spin, 0], center: [0, 0, $height]}]
loads: {gravity: [0, 0, -9.81]}
walls: [{normal: z, friction: 0.1}]
contact: {surfaces: none}
output: {history: {every: 2e-3}}
"""


@case("slide_to_roll", "rigid", "From sliding to rolling of a cylinder", quick=True)
def slide_to_roll(bench):
    """A rigid cylinder of radius 1 m comes onto a floor of friction 0.1 at 1 m/s without spin, or with backspin. Friction
    slows it and spins it up, at mu g and mu g / k, k = I / (m R^2), until it rolls. The angular momentum about the floor
    is kept: it rolls at (v - k w R) / (1 + k), w the backspin, from the time (v + w R) / (mu g (1 + 1 / k)) on
    (Coriolis 1835 for balls): a full cylinder (k = 1/2) at 2/3 m/s, a hoop (k = 1) at 1/2 m/s; a full cylinder with
    backspin 3 v / R comes back at -1/3 m/s.

    The cylinder is a prism of 1440 faces. A vertex that comes down ahead of the centre takes 2 w R^2 sin^2(pi / 1440)
    of the angular momentum over the mass: 1 % of v R with the backspin, less than 0.1 % without. Tolerances are 1 % of 1
    m/s for speeds and 1 % for times, with half the faces both are twice as far off."""
    faces, curves = 1440, []
    for name, inertia, spin in (("full cylinder", 0.5, 0.0), ("hoop", 1.0, 0.0),
                                ("full cylinder with backspin", 0.5, 3.0)):
        time = (1 + spin) / (0.1 * G * (1 + 1 / inertia))
        speed = (1 - inertia * spin) / (1 + inertia)
        h = bench.run(ROLLER, end=1.5 * time, step=1e-4, faces=faces, turn=180 / faces,
                      height=float(np.cos(np.pi / faces)), inertia=inertia, across=0.8 * inertia, spin=-spin).history
        slip = h["body_vx:wheel"] - h["body_wy:wheel"]
        late = h["time"] > 1.05 * time
        straight = (slip < 0.9 * slip[0]) & (slip > 0.1 * slip[0])
        found = float(np.roots(np.polyfit(h["time"][straight], slip[straight], 1))[0])
        bench.near(f"{name}: time at which it rolls", found, time, relative=0.01, unit="s")
        bench.near(f"{name}: speed at which it rolls", float(h["body_vx:wheel"][late].mean()), speed, absolute=0.01,
                   unit="m/s")
        bench.near(f"{name}: spin at which it rolls", float(h["body_wy:wheel"][late].mean()), speed, absolute=0.01,
                   unit="rad/s")
        curves.append((name, h, time, speed))

    def draw(axes):
        for name, h, time, speed in curves:
            line, = axes.plot(*thin(h["time"], h["body_vx:wheel"]), label=name)
            axes.plot([0, time, 1.5 * time], [1, speed, speed], **plots.EXACT)
        axes.set(xlabel="time [s]", ylabel="speed [m/s]")
        axes.legend()

    bench.figure("Speed of the cylinders; dashed: exact.", draw)
