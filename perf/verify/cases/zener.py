"""A ball that strikes a plate, which carries the energy away."""
import numpy as np

import meshes
import plots
from bench import case, thin
from cases.balls import NU, RADIUS, STEEL, YOUNG

ZENER = """
title: A ball strikes a plate
time: {end: $end}
parts:
  ball: {exodus: {file: $ball}, at: [0, 0, $height], material: steel}
  plate: {shell_plate: {size: [$size, $size], cells: [$cells, $cells]}, thickness: $thickness, material: steel}
initial: [{part: ball, velocity: [0, 0, -3]}]
conditions:
  - {nodes: {inside: [[-1e-9, -1, -1], [1e-9, 1, 1]]}, symmetry: x}
  - {nodes: {inside: [[-1, -1e-9, -1], [1, 1e-9, 1]]}, symmetry: y}
contact: {surfaces: [[ball, plate]], edges: false}
output: {history: {every: 2e-7, parts: [ball], forces: [{name: joint, contact: [ball, plate]}]}}
""" + STEEL


def follow_zener(stiffness, mass, mobility, speed, end):
    """Times, force and speed of a ball on a plate that moves away at mobility times the force."""
    from scipy.integrate import solve_ivp

    def rates(_, y):
        force = stiffness * max(y[0], 0)**1.5
        return [y[1] - mobility * force, -force / mass]

    path = solve_ivp(rates, (0, end), [0, speed], rtol=1e-9, atol=1e-14, max_step=end / 2000)
    return path.t, stiffness * np.maximum(path.y[0], 0)**1.5, path.y[1]


@case("zener_plate", "impact", "Impact of a ball on a large plate")
def zener_plate(bench):
    """A steel ball of radius 10 mm strikes large plates of steel at 3 m/s. Bending waves carry the energy away, and
    nothing comes back while ball and plate touch. Zener (*Phys. Rev.* 59, 1941): the plate yields at the speed F / (8
    sqrt(D rho h)) under the ball, whatever the history of the force (Boussinesq), and Hertz gives the force from the
    approach. The restitution is a function of one number, the inelasticity; here the equations are integrated.

    The plates are shells, which do not dent: the ball alone does, as on a rigid plane. A quarter of ball and plate, 5
    elements of the ball across the radius of contact. Zener leaves out shear, by which the plate yields some tenth of
    the approach besides. The energy of the nodes that contact stops is lost (`sphere_drop`: 1 % of the speed). The
    tolerance is 0.04 for the restitution and 5 % for the largest force."""
    rows, curves = [], []
    for thickness, size in ((0.005, 0.08), (0.012, 0.12)):
        ball = meshes.write_exodus(bench.file("ball.exo"), *meshes.quarter_ball(bench, RADIUS, 12, 0.85))
        h = bench.run(ZENER, end=9e-5, ball=ball, height=RADIUS + 0.5 * thickness + 1e-7, size=size, cells=24,
                      thickness=thickness).history
        momentum = h["momentum_z:ball"]
        mass = -4 * momentum[0] / 3
        stiffness = 4 / 3 * YOUNG / (1 - NU**2) * np.sqrt(RADIUS)
        bending = YOUNG * thickness**3 / (12 * (1 - NU**2))
        times, force, speed = follow_zener(stiffness, mass, 1 / (8 * np.sqrt(bending * 7850 * thickness)), 3.0, 9e-5)
        rows.append((thickness, -float(speed[-1]) / 3, float(momentum[-1] / -momentum[0]), float(force.max()),
                     4 * float(h["fz:joint"].max())))
        name = f"{1e3 * thickness:g} mm"
        bench.near(f"{name}: restitution", rows[-1][2], rows[-1][1], absolute=0.04)
        bench.near(f"{name}: largest force", rows[-1][4], rows[-1][3], relative=0.05, unit="N")
        curves.append((name, times, force, h))

    def draw(axes):
        for name, times, force, h in curves:
            axes.plot(1e6 * times, force, **plots.EXACT)
            axes.plot(*thin(1e6 * h["time"], 4 * h["fz:joint"], 250), label=name)
        axes.set(xlabel="time [us]", ylabel="force [N]")
        axes.legend()

    bench.figure("Force between ball and plate; dashed: Zener.", draw)
