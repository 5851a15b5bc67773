"""What has to be exact to round-off: mass, free fall, uniform strain."""
import numpy as np

import choices
import meshes
from bench import case

MATERIAL = """
materials:
  m: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}
"""

SHAPES = {
    "box": "box: {size: [0.3, 0.2, 0.1], cells: [3, 2, 1]}",
    "turned box": "box: {size: [0.3, 0.2, 0.1], cells: [3, 2, 1]}, rotate: [{axis: [1, 2, 3], angle: 40}]",
    "cylinder": "cylinder: {radius: 0.1, length: 0.3, cells: [8, 6]}",
    "tube": "tube: {inner_radius: 0.1, outer_radius: 0.13, length: 0.3, cells: [2, 24, 6]}",
    "sphere": "sphere: {radius: 0.1, cells: 8}",
}


def distort(bench, size, cells, amount, seed):
    """A block whose inner nodes are moved at random by up to `amount` of a cell."""
    points, corners = meshes.make_box(size, cells)
    inside = meshes.find_interior(points, size)
    random = np.random.default_rng(seed)
    points = points + inside[:, None] * random.uniform(-amount, amount, points.shape) * np.array(size) / np.array(cells)
    return points, corners, inside


@case("mass_and_fall", "exact", "Mass and free fall", quick=True)
def mass_and_fall(bench):
    """The mass of every generated shape, and of a block of distorted elements, is density times the volume of its mesh.
    Under gravity every node falls with exactly g. The volume is integrated independently of percuss (2 x 2 x 2 Gauss
    points are exact for a trilinear element). Mass and speed may differ by round-off."""
    points, corners, _ = distort(bench, (0.3, 0.3, 0.3), (3, 3, 3), 0.25, 1)
    path = meshes.write_exodus(bench.file("distorted.exo"), points, corners)
    for name, shape in (SHAPES | {"distorted hexahedra": f"exodus: {{file: {path}}}"}).items():
        run = bench.run("""
time: {end: 1e-3}
parts: {body: {$shape, material: m}}
loads: {gravity: [0, 0, -9.81]}
output: {fields: {every: 1, write: [velocity, mass]}, history: {every: 1e-3}}
""" + MATERIAL, shape=shape)
        frames = run.frames
        mass = 7850 * meshes.volume(frames.points(0), frames.corners).sum()
        bench.near(f"{name}: mass", frames.node("mass", 0).sum(), mass, relative=1e-13, unit="kg")
        speed, time = frames.node("velocity")[:, 2], run.history.last("time")
        # v(n-1/2), half a step before the end
        time -= 0.5 * run.summary["dt"]["last"]
        worst = speed[np.argmax(np.abs(speed + 9.81 * time))]
        bench.near(f"{name}: speed of the node that differs most", worst, -9.81 * time, relative=1e-11, unit="m/s")


PATCH = """
time: {end: 4e-3}
parts: {body: {exodus: {file: $file}, material: m}}
elements: {$elements, bulk_viscosity: {linear: 0, quadratic: 0}}
initial:
$initial
conditions:
$conditions
output: {fields: {every: 1, write: [stress]}}
""" + MATERIAL


def find_log(a):
    """Logarithm of a symmetric matrix."""
    values, vectors = np.linalg.eigh(a)
    return vectors @ np.diag(np.log(values)) @ vectors.T


@case("patch", "exact", "Patch test", quick=True)
def patch(bench):
    """A block of 3 x 3 x 3 elements has its eight inner nodes at random positions. All nodes start in a linear velocity
    field v = G x; those of the surface keep their velocity, the inner ones are free. Every element must have the same
    stress to round-off, and the inner nodes must follow the field. Since G is symmetric, J times the stress is that of
    the strain ln(1 + G t), J = det(1 + G t). The mid-point rates of a hundred steps leave an error of 1e-9 of strain.
    Viscosity is off because its pressure depends on the element."""
    points, corners, inside = distort(bench, (1, 1, 1), (3, 3, 3), 0.2, 7)
    points -= 0.5
    path = meshes.write_exodus(bench.file("patch.exo"), points, corners)
    g = np.array([[9, 3, -2], [3, -6, 4], [-2, 4, 5]])
    v = points @ g.T
    young, nu, t = 200e9, 0.3, 4e-3
    strain = find_log(np.eye(3) + t * g)
    exact = young / (1 + nu) * (strain + nu / (1 - 2 * nu) * np.trace(strain) * np.eye(3)) / np.linalg.det(
        np.eye(3) + t * g)
    exact = exact[[0, 1, 2, 0, 1, 2], [0, 1, 2, 1, 2, 0]]
    initial = meshes.each_node(points, lambda n: "velocity: " + str([float(c) for c in v[n]]))
    surface = np.flatnonzero(~inside)
    held = meshes.each_node(points[surface], lambda i: "velocity: {%s}" % ", ".join(
        f"{axis}: {float(c)!r}" for axis, c in zip("xyz", v[surface[i]])))
    for name, text in choices.list_elements(bench).items():
        run = bench.run(PATCH, file=path, elements=text, initial=initial, conditions=held)
        frames = run.frames
        stress = frames.element("stress")
        bench.below(f"{name}: spread of the stress over its size",
                    np.ptp(stress, axis=0).max() / np.abs(exact).max(), 1e-11)
        bench.below(f"{name}: stress, largest error over Young's modulus", np.abs(stress - exact).max() / young, 1e-8)
        places = frames.points(0) @ (np.eye(3) + t * g)
        bench.below(f"{name}: places of the nodes, largest error", np.abs(frames.points() - places).max(), 1e-12, "m")
        bench.below(f"{name}: hourglass energy over internal",
                    abs(run.summary["energy"]["hourglass"]) / run.summary["energy"]["internal"], 1e-12)
