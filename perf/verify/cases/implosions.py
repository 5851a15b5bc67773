"""Noh's problem with cylindrical and spherical symmetry: cold gas that runs together in an axis or a point."""
import numpy as np

import meshes
import plots
from bench import case

GAS = """
title: Noh's problem, $kind
time: {end: 0.6}
parts: {gas: {exodus: {file: $mesh}, material: gas}}
materials:
  gas: {model: fluid, density: 1, equation_of_state: {kind: ideal_gas, gamma: 1.6666666666666667, start_energy: 1e-6}}
elements: {hourglass: viscous}
initial:
  - {radial_velocity: {speed: -1, center: [0, 0, 0]$axis}}
$rests
conditions:
$planes
$walls
output: {fields: {every: 0.6, write: [pressure]}, history: {every: 0.01}}
"""
WALL = 0.06  # radius inside of which viscosity has heated the gas that met first too much, for good
SHOCK = 0.2  # at the end


class Gas:
    """The elements at the end: radius, volume, density, pressure."""

    def __init__(self, frames, from_axis):
        centers = frames.points()[frames.corners].mean(axis=1)
        if from_axis:
            centers[:, 2] = 0
        self.r = np.linalg.norm(centers, axis=1)
        self.volume = meshes.volume(frames.points(), frames.corners)
        self.density = meshes.volume(frames.points(0), frames.corners) / self.volume
        self.pressure = frames.element("pressure")

    def behind_shock(self):
        """Mean density and pressure of the volume behind the shock."""
        there = (self.r > WALL) & (self.r < SHOCK - 0.04)
        return tuple(float(np.average(field[there], weights=self.volume[there]))
                     for field in (self.density, self.pressure))


def run_together(bench, kind, points, corners, planes, walls=()):
    """The gas at the end. Nodes at the least radius, on a rod or a ball that stands for what no hexahedron can fill, stay."""
    directions = points * (np.array([1, 1, 0]) if kind == "cylinder" else 1)
    radius = np.linalg.norm(directions, axis=1)
    on_core = radius < radius.min() * (1 + 1e-9)
    mesh = meshes.write_exodus(bench.file(f"{kind}.exo"), points, corners)

    def each_of_core(what):
        return "\n".join(f"  - {{nodes: {{name: gas, inside: [{x}, {x}]}}, {what}}}" for x in points[on_core].tolist())

    held = "\n".join(f"  - {{nodes: {{name: gas, inside: [{low}, {high}]}}, symmetry: {axis}}}"
                     for axis, low, high in planes)
    run = bench.run(GAS, kind=kind, mesh=mesh, axis=", axis: z" if kind == "cylinder" else "",
                    rests=each_of_core("velocity: [0, 0, 0]"), planes=held + "\n" + each_of_core("fixed: [x, y, z]"),
                    walls="walls: [" + ", ".join(f"{{normal: {list(normal)}}}" for normal in walls) + "]"
                    if walls else "")
    bench.below("energy balance, largest error", run.history.largest("energy_error"), 0.01)
    return Gas(run.frames, kind == "cylinder")


def compare_ahead(bench, gas, power):
    """Ahead of the shock: what has run together so far."""
    ahead = (gas.r > SHOCK + 0.06) & (gas.r < 0.35)
    bench.near("density ahead of the shock over the exact one, (1 + t / r)^n",
               float(np.mean(gas.density[ahead] / (1 + 0.6 / gas.r[ahead])**power)), 1.0, relative=0.02)


def draw_density(bench, kind, gas, power):
    def draw(axes):
        x = np.linspace(0.01, 0.4, 500)
        axes.plot(x, np.where(x < SHOCK, 4.0**(power + 1), (1 + 0.6 / x)**power), **plots.EXACT)
        shown = np.flatnonzero(gas.r < 0.4)
        shown = shown[::1 + len(shown) // 1500]
        axes.plot(gas.r[shown], gas.density[shown], ".", markersize=2)
        axes.set(xlabel="radius", ylabel="density", xlim=(0, 0.4))

    bench.figure(f"Density of elements of the {kind} at t = 0.6; dashed: exact.", draw)


PLANES = (("x", [0, -9, -9], [0, 9, 9]), ("y", [-9, 0, -9], [9, 0, 9]), ("z", [-9, -9, 0], [9, 9, 0]))


def make_rays(directions, quads, shells):
    """Layers of elements between copies of a surface: quads of unit directions, times the radii of the shells."""
    points = (shells[:, None, None] * directions[None]).reshape(-1, 3)
    lower = (np.arange(len(shells) - 1) * len(directions))[:, None, None] + quads[None]
    return points, np.concatenate([lower, lower + len(directions)], axis=2).reshape(-1, 8)


def weld(directions, quads):
    """Nodes at the same place made one."""
    _, first, numbers = np.unique(np.round(directions, 9), axis=0, return_index=True, return_inverse=True)
    return directions[first], numbers.reshape(-1)[quads]


def octant(cells):
    """Directions of the octant of a sphere, three patches of cells x cells quadrilaterals that look outward."""
    v, u = np.meshgrid(*(2 * (np.tan(np.linspace(0, np.pi / 4, cells + 1)),)), indexing="ij")
    ray = np.stack([u.ravel(), v.ravel(), np.ones(u.size)], axis=1)
    ray /= np.linalg.norm(ray, axis=1)[:, None]
    j, i = (n.ravel() for n in np.meshgrid(np.arange(cells), np.arange(cells), indexing="ij"))
    quads = (i + (cells + 1) * j)[:, None] + np.array([0, 1, cells + 2, cells + 1])
    return weld(np.concatenate([np.roll(ray, k, axis=1) for k in range(3)]),
                np.concatenate([quads + k * len(ray) for k in range(3)]))


@case("noh_cylinder", "shocks", "Noh's problem in the cylinder")
def noh_cylinder(bench):
    """Cold gas, gamma 5/3, runs to the axis at speed 1. Behind a shock that leaves it at 1/3 its density is 16 and its
    pressure 16/3; ahead of it the density is 1 + t / r (Noh, *J. Comput. Phys.* 72, 1987). A quarter of a disc is
    meshed in rays, 180 x 16 elements around a rod of radius 0.01 (a hexahedron has no edge without length). Results are
    within 5 % from r = 0.06 on, the outer edge of the gas that viscosity permanently overheats where it first meets
    itself. Ahead of the shock they are within 2 %."""
    points, corners = meshes.make_box([1, 0.5 * np.pi, 0.01], [180, 16, 1])
    r = 0.01 + 0.99 * points[:, 0]
    points = np.stack([r * np.cos(points[:, 1]), r * np.sin(points[:, 1]), points[:, 2]], axis=1)
    points[np.abs(points) < 1e-12] = 0
    planes = (*PLANES, ("z", [-9, -9, 0.01], [9, 9, 0.01]))
    gas = run_together(bench, "cylinder", points, corners, planes)
    density, pressure = gas.behind_shock()
    bench.near(f"density behind the shock, r from {WALL} to {SHOCK - 0.04:.2f}", density, 16, relative=0.05)
    bench.near("pressure behind the shock", pressure, 16 / 3, relative=0.05)
    compare_ahead(bench, gas, 1)
    draw_density(bench, "cylinder", gas, 1)


@case("noh_ball", "shocks", "Noh's problem in the ball")
def noh_ball(bench):
    """The same to a point: 64 times the density and a pressure of 64/3, ahead of the shock (1 + t / r)^2. An octant is
    meshed in rays, 27 elements a layer around a ball of radius 0.02. The viscosity of a converging shock overheats by
    the first order of the layers' thickness. A one-dimensional code with the same viscosity and energy equation has a
    density of 48.4, 56.6 and 60.2 with 150, 300 and 600 layers. The density is therefore extrapolated by the straight
    line through both meshes, and must be within 5 %; ahead of the shock within 2 %. The front does not stay round on
    thin, wide elements, which run ahead along some rays and keep motion across them. This explains the low pressure."""
    means = []
    for layers in (150, 300):
        points, corners = make_rays(*octant(3), np.linspace(0.02, 1, layers + 1))
        points[np.abs(points) < 1e-12] = 0
        gas = run_together(bench, "ball", points, corners, PLANES)
        means.append(gas.behind_shock())
    limit = [2 * fine - coarse for coarse, fine in zip(*means)]
    bench.table(["mean behind the shock", "150 layers", "300 layers", "line through both", "exact"],
                [[name, *(f"{mean[i]:.2f}" for mean in (*means, limit)), f"{exact:.2f}"]
                 for i, (name, exact) in enumerate((("density", 64), ("pressure", 64 / 3)))])
    bench.near(f"density behind the shock, r from {WALL} to {SHOCK - 0.04:.2f}, where it goes with the layers",
               limit[0], 64, relative=0.05)
    compare_ahead(bench, gas, 2)
    draw_density(bench, "ball", gas, 2)


@case("noh_ray", "shocks", "Noh's problem in a ray of the ball")
def noh_ray(bench):
    """The ball again, as one ray of 900 elements between two planes of symmetry and two rigid walls that lean by 0.02,
    around a core of radius 0.01: a fixed direction needs no round front. Density and pressure behind the shock are
    within 5 %, ahead of it within 2 %. On wider rays elements become ten times as wide as thick, and tangle."""
    lean, layers = 0.02, 900
    t = np.tan(lean)
    directions = np.array([[0, 0, 1], [t, 0, 1], [t, t, 1], [0, t, 1]])
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    points, corners = make_rays(directions, np.arange(4)[None], np.linspace(0.01, 1, layers + 1))
    inward = (-float(np.cos(lean)), float(np.sin(lean)))
    gas = run_together(bench, "ray", points, corners, PLANES[:2], [(inward[0], 0, inward[1]), (0, *inward)])
    density, pressure = gas.behind_shock()
    bench.near(f"density behind the shock, r from {WALL} to {SHOCK - 0.04:.2f}", density, 64, relative=0.05)
    bench.near("pressure behind the shock", pressure, 64 / 3, relative=0.05)
    compare_ahead(bench, gas, 2)
    draw_density(bench, "ray", gas, 2)
