"""The map of the step: bounds and estimates against the largest eigenvalue, over shapes,
Poisson's ratios and damping."""
import itertools
import subprocess

import numpy as np

from scenes import KINDS, write_elements

DENSITY, MODULUS = 1000.0, 1e9
WEDGES = "wedges"  # each element of the lattice cut in two
ASPECTS = (1, 2, 5, 10, 20, 50, 100)
POISSON = (0.0, 0.3, 0.45, 0.499)
DAMPING = {  # linear and quadratic bulk viscosity, velocity jump over a thickness of 1 in wave speeds
    "none": (0.0, 0.0, 0.0),
    "default": (0.06, 0.0, 0.0),
    # at rest the quadratic term has no tangent; its one-sided curvature would disturb the difference
    "shock": (0.06, 1.2, 0.3),
}


# --- shapes: positions of the (n + 1)^3 nodes of n x n x n elements of edge 1

def lattice(cells):
    line = np.arange(cells + 1, dtype=float)
    return np.stack(np.meshgrid(line, line, line, indexing="ij"), axis=-1).reshape(-1, 3)


def stretched(cells, edges):
    return lattice(cells) * edges


def sheared(cells, amount):
    x = lattice(cells)
    x[:, 0] += amount * x[:, 2]
    return x


def trapezoids(cells, tilt):
    """Faces between columns of elements lean alternately to either side: tilt is the shift of an edge's ends."""
    x = lattice(cells)
    side = np.where(np.round(x[:, 0]) % 2 == 0, 1.0, -1.0)
    x[:, 0] += side * tilt * (x[:, 2] / cells - 0.5)
    return x


def distorted(cells, amount, edges, seed):
    """Every node is moved by up to `amount` of each edge; what inverts an element is drawn again."""
    random = np.random.default_rng(seed)
    while True:
        x = lattice(cells) + amount * random.uniform(-1, 1, ((cells + 1) ** 3, 3))
        if all(measure_element(x[corners]).corner_volume > 0.05 for corners in element_corners(cells)):
            return x * edges


def list_shapes(cells, seeds):
    """Family, parameter and nodes of every shape."""
    for a in ASPECTS:
        yield "rods", a, stretched(cells, (a, 1, 1))
        yield "plates", a, stretched(cells, (a, a, 1))
        yield "bricks", a, stretched(cells, (a, a ** 0.5, 1))
    for amount in (0.25, 0.5, 1.0, 2.0):
        yield "sheared", amount, sheared(cells, amount)
    for tilt in (0.2, 0.4, 0.6):
        yield "trapezoids", tilt, trapezoids(cells, tilt)
    for amount, aspect, seed in itertools.product((0.1, 0.2, 0.3), (1, 10, 100), range(seeds)):
        yield "distorted" if aspect == 1 else f"distorted, aspect {aspect}", amount, distorted(
            cells, amount, (aspect, aspect ** 0.5, 1), 1000 * seed + int(10 * amount))


def element_corners(cells):
    """Nodes of each element in the corner order of Exodus II."""
    side = cells + 1
    place = lambda i, j, k: (i * side + j) * side + k  # noqa: E731
    for i, j, k in itertools.product(range(cells), repeat=3):
        yield [place(i, j, k), place(i + 1, j, k), place(i + 1, j + 1, k), place(i, j + 1, k),
               place(i, j, k + 1), place(i + 1, j, k + 1), place(i + 1, j + 1, k + 1), place(i, j + 1, k + 1)]


# --- what other codes take for the step, from the geometry of an element

SIGNS = np.array([[-1, -1, -1], [1, -1, -1], [1, 1, -1], [-1, 1, -1], [-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]])
FACES = ((0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (0, 4, 7, 3), (0, 3, 2, 1), (4, 5, 6, 7))


class ElementMeasure:
    """Lengths of an element: V / sqrt(2 B:B), V / largest face, shortest edge; smallest corner volume."""


def measure_element(x):
    m = ElementMeasure()
    # B_iI by the 2x2x2 rule, which is exact for the mean gradient of a trilinear element
    b, volume = np.zeros((3, 8)), 0.0
    for point in SIGNS / 3 ** 0.5:
        factors = 1 + SIGNS * point
        gradient = np.stack([SIGNS[:, k] * np.prod(np.delete(factors, k, axis=1), axis=1) / 8 for k in range(3)])
        jacobian = gradient @ x
        determinant = np.linalg.det(jacobian)
        b += np.linalg.solve(jacobian, gradient) * determinant
        volume += determinant
    m.guaranteed = volume / np.sqrt(2 * np.sum(b * b))
    areas = [np.linalg.norm(np.cross(x[f[2]] - x[f[0]], x[f[3]] - x[f[1]])) / 2 for f in FACES]
    m.over_face = volume / max(areas)
    edges = [np.linalg.norm(x[f[i]] - x[f[i - 1]]) for f in FACES for i in range(4)]
    m.edge = min(edges)
    corners = []
    for corner in SIGNS:
        gradient = np.stack([SIGNS[:, k] * np.prod(np.delete(1 + SIGNS * corner, k, axis=1), axis=1) / 8
                             for k in range(3)])
        corners.append(8 * np.linalg.det(gradient @ x))
    m.corner_volume = min(corners)
    return m


# --- the tool

def write_deck(path, kind, linear, quadratic, cells, poisson):
    cut, kind = ("elements: wedges, ", "stiffness") if kind == WEDGES else ("", kind)
    parts = "".join(f"  p{i}: {{box: {{size: [1, 1, 1], cells: [{cells}, {cells}, {cells}]}}, "
                    f"{cut}material: m{POISSON.index(nu)}}}\n"
                    for i, nu in enumerate(poisson))
    materials = "".join(f"  m{i}: {{model: elastic, density: {DENSITY}, youngs_modulus: {MODULUS}, "
                        f"poissons_ratio: {nu}}}\n"
                        for i, nu in enumerate(POISSON) if nu in poisson)
    path.write_text("time: {end: 1}\nparts:\n" + parts + "materials:\n" + materials +
                    write_elements(kind, linear, quadratic))


def find_wave_speed(poisson):
    return np.sqrt(MODULUS * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson)) / DENSITY)


def measure_matrices(tool, work, kind, damping, cells, shapes, poisson):
    """Bound, normalised stiffness M^-1/2 K M^-1/2 and damping of each shape, and the largest asymmetry of both."""
    linear, quadratic, jump = DAMPING[damping]
    write_deck(work / "map.yaml", kind, linear, quadratic, cells, poisson)
    with open(work / "shapes.bin", "wb") as file:
        for nodes, nu in zip(shapes, poisson):
            file.write(np.array([jump * find_wave_speed(nu)]).tobytes()
                       + np.ascontiguousarray(nodes, dtype=float).tobytes())
    subprocess.run([*tool, "matrices", str(work / "map.yaml"), str(work / "shapes.bin"), str(work / "matrices.bin")],
                   check=True)
    n = 3 * (cells + 1) ** 3
    raw = np.fromfile(work / "matrices.bin").reshape(len(shapes), 1 + n + 2 * n * n)
    root = 1 / np.sqrt(raw[:, 1:n + 1])
    out, asymmetry = [], 0.0
    for columns in (raw[:, n + 1:n + 1 + n * n], raw[:, n + 1 + n * n:]):
        matrix = columns.reshape(-1, n, n) * root[:, :, None] * root[:, None, :]
        size = np.maximum(np.max(np.abs(matrix), axis=(1, 2)), 1e-300)
        asymmetry = max(asymmetry, np.max(np.max(np.abs(matrix - matrix.transpose(0, 2, 1)), axis=(1, 2)) / size))
        out.append((matrix + matrix.transpose(0, 2, 1)) / 2)
    (work / "matrices.bin").unlink()
    return raw[:, 0], out[0], out[1], asymmetry


def find_critical_steps(stiffness, damping, start):
    """dt with largest eigenvalue of dt^2 A / 4 + dt B / 2 = 1, and the largest residual of its eigenvectors.

    Newton's method with Rayleigh quotients: from any vector the step is an upper bound, and the error is squared by
    each round.
    """
    dt = np.array(start, dtype=float)
    for _ in range(8):
        matrix = dt[:, None, None] ** 2 / 4 * stiffness + dt[:, None, None] / 2 * damping
        values, vectors = np.linalg.eigh(matrix)
        x = vectors[:, :, -1]
        residual = np.max(np.linalg.norm(np.einsum("pij,pj->pi", matrix, x) - values[:, -1:] * x, axis=1)
                          / values[:, -1])
        k = np.einsum("pi,pij,pj->p", x, stiffness, x)
        c = np.einsum("pi,pij,pj->p", x, damping, x)
        new = 2 / (c / 2 + np.sqrt(k + c * c / 4))
        change = np.max(np.abs(new / dt - 1))
        dt = new
        if change < 1e-11:
            break
    return dt, residual


def find_spectral_radius(stiffness, damping, dt):
    """Spectral radius of the step of one shape: v' = v - dt (A x + B v), x' = x + dt v'."""
    n = len(stiffness)
    one = np.eye(n)
    velocity = np.hstack([-dt * stiffness, one - dt * damping])
    step = np.vstack([np.hstack([one, np.zeros((n, n))]) + dt * velocity, velocity])
    return np.max(np.abs(np.linalg.eigvals(step)))


def measure_map(tool, work, cells, seeds, poisson_ratios, dampings, report, kinds=tuple(KINDS)):
    """Rows of the map, and what verifies them."""
    shapes = list(list_shapes(cells, seeds))
    cases = [(family, parameter, nodes, nu) for family, parameter, nodes in shapes for nu in poisson_ratios]
    measures = [min_measures(nodes, cells) for _, _, nodes in shapes for _ in poisson_ratios]
    speeds = [find_wave_speed(nu) for *_, nu in cases]
    rows, checks = [], {"asymmetry": 0.0, "residual": 0.0, "below": 0.0, "above": 9.0}
    for kind, damping in itertools.product(kinds, dampings):
        bound, stiffness, viscosity, asymmetry = measure_matrices(
            tool, work, kind, damping, cells, [nodes for _, _, nodes, _ in cases], [nu for *_, nu in cases])
        true, residual = find_critical_steps(stiffness, viscosity, bound)
        checks["asymmetry"] = max(checks["asymmetry"], asymmetry)
        checks["residual"] = max(checks["residual"], residual)
        if cells == 1:
            for p in range(0, len(cases), 11):
                a = stiffness[p] * bound[p] ** 2  # steps in units of the bound keep the matrix balanced
                b = viscosity[p] * bound[p]
                checks["below"] = max(checks["below"], find_spectral_radius(a, b, 0.999 * true[p] / bound[p]))
                checks["above"] = min(checks["above"], find_spectral_radius(a, b, 1.001 * true[p] / bound[p]))
        for p, (family, parameter, _, nu) in enumerate(cases):
            rows.append({"kind": kind, "damping": damping, "cells": cells, "family": family, "parameter": parameter,
                         "poisson": nu, "bound": bound[p], "true": true[p], "ratio": bound[p] / true[p],
                         **{name: length / speeds[p] / true[p] for name, length in measures[p].items()}})
        worst = max(rows[-len(cases):], key=lambda row: row["ratio"])
        report(f"map, {cells}^3 elements, {kind}, damping {damping}: largest bound / true {worst['ratio']:.6f} "
               f"({worst['family']} {worst['parameter']}, Poisson {worst['poisson']})")
    return rows, checks


def min_measures(nodes, cells):
    measures = [measure_element(nodes[corners]) for corners in element_corners(cells)]
    return {name: min(getattr(m, name) for m in measures) for name in ("guaranteed", "over_face", "edge")}
