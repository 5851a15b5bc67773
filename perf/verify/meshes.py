"""Meshes that no generator of percuss makes: quarters, graded balls, distorted blocks; as Exodus II files."""
import numpy as np
from scipy.io import netcdf_file


def generate(bench, shape):
    """Nodes (N, 3) and corners (E, 8) of a generated part."""
    run = bench.run("""
time: {end: 1, max_steps: 1}
parts: {a: {$shape, material: m}}
materials: {m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0}}
output: {fields: {every: 1}}
""", shape=shape)
    frames = run.frames
    return frames.points(0), frames.corners


def keep(points, corners, wanted):
    """The elements whose centre is wanted(x, y, z), and their nodes."""
    centers = points[corners].mean(axis=1)
    chosen = corners[wanted(*centers.T)]
    nodes, numbers = np.unique(chosen, return_inverse=True)
    return points[nodes], numbers.reshape(-1, 8)


def make_box(size, cells):
    """A block of equal cells, its lowest corner at the origin: nodes run along x first."""
    axes = [np.linspace(0, length, n + 1) for length, n in zip(size, cells)]
    z, y, x = np.meshgrid(axes[2], axes[1], axes[0], indexing="ij")
    points = np.stack([x.ravel(), y.ravel(), z.ravel()], axis=1)
    nx, ny = cells[0] + 1, cells[1] + 1
    k, j, i = np.meshgrid(*(np.arange(n) for n in reversed(cells)), indexing="ij")
    first = (i + nx * (j + ny * k)).ravel()
    around = np.array([0, 1, 1 + nx, nx])
    return points, (first[:, None] + np.concatenate([around, around + nx * ny])).astype(np.int64)


def find_interior(points, size):
    """Which nodes of a block lie inside it."""
    return np.all((points > 0) & (points < np.asarray(size)), axis=1)


def volume(points, corners):
    """Volume of the elements as their faces' bilinear surfaces enclose it (one point, mean quadrature)."""
    xi = np.array([-1, 1, 1, -1, -1, 1, 1, -1])
    eta = np.array([-1, -1, 1, 1, -1, -1, 1, 1])
    zeta = np.array([-1, -1, -1, -1, 1, 1, 1, 1])
    x = points[corners]
    total = np.zeros(len(corners))
    g = 1 / np.sqrt(3)  # 2 x 2 x 2 points are exact for a trilinear element
    for a in (-g, g):
        for b in (-g, g):
            for c in (-g, g):
                d = 0.125 * np.stack([xi * (1 + b * eta) * (1 + c * zeta), eta * (1 + a * xi) * (1 + c * zeta),
                                      zeta * (1 + a * xi) * (1 + b * eta)])
                total += np.linalg.det(np.einsum("kc,ecj->ekj", d, x))
    return total


def write_exodus(path, points, corners, outer=False):
    """One block of hexahedra, or of shells, as an Exodus II file in classic netCDF; outer: with a side set of that name, the sides of shells that normals come out of."""
    with netcdf_file(path, "w", version=2) as file:
        file.api_version, file.version = np.float32(5.1), np.float32(5.1)
        file.floating_point_word_size, file.file_size, file.title = np.int32(8), np.int32(1), "generated"
        for name, length in (("len_string", 33), ("len_line", 81), ("four", 4), ("num_dim", 3),
                             ("num_nodes", len(points)),
                             ("num_elem", len(corners)), ("num_el_blk", 1), ("num_el_in_blk1", len(corners)),
                             ("num_nod_per_el1", corners.shape[1])):
            file.createDimension(name, length)
        # first, because the Exodus II library takes coordinates in the first variable of a file as missing
        file.createVariable("node_num_map", "i4", ("num_nodes",))[:] = np.arange(1, len(points) + 1)
        for axis, name in enumerate(("coordx", "coordy", "coordz")):
            file.createVariable(name, "f8", ("num_nodes",))[:] = points[:, axis]
        file.createVariable("eb_status", "i4", ("num_el_blk",))[:] = 1
        file.createVariable("eb_prop1", "i4", ("num_el_blk",))[:] = 1
        file.variables["eb_prop1"].name = "ID"
        connect = file.createVariable("connect1", "i4", ("num_el_in_blk1", "num_nod_per_el1"))
        connect.elem_type = "HEX8" if corners.shape[1] == 8 else "SHELL4"
        connect[:] = corners + 1
        if outer:
            file.createDimension("num_side_sets", 1)
            file.createDimension("num_side_ss1", len(corners))
            file.createVariable("ss_status", "i4", ("num_side_sets",))[:] = 1
            file.createVariable("ss_prop1", "i4", ("num_side_sets",))[:] = 1
            file.variables["ss_prop1"].name = "ID"
            file.createVariable("elem_ss1", "i4", ("num_side_ss1",))[:] = np.arange(1, len(corners) + 1)
            file.createVariable("side_ss1", "i4", ("num_side_ss1",))[:] = 1
            file.createVariable("ss_names", "S1", ("num_side_sets", "len_string"))[:] = np.array(
                [list("outer".ljust(33, "\0"))], dtype="S1")
    return path


def make_surface(cells, place, share=0.0, seed=1):
    """Shells on the unit square, each node where place(u, v) puts it; nodes inside are moved by up to a share of a cell both ways. Nodes run along u first."""
    u, v = np.meshgrid(np.linspace(0, 1, cells[0] + 1), np.linspace(0, 1, cells[1] + 1))
    inside = (u > 0) & (u < 1) & (v > 0) & (v < 1)
    moves = share * np.random.default_rng(seed).uniform(-1, 1, (2, *u.shape)) * inside
    points = np.stack(place(u + moves[0] / cells[0], v + moves[1] / cells[1]), axis=-1).reshape(-1, 3)
    j, i = np.meshgrid(np.arange(cells[1]), np.arange(cells[0]), indexing="ij")
    first = (i + (cells[0] + 1) * j).ravel()
    return points, first[:, None] + np.array([0, 1, cells[0] + 2, cells[0] + 1])


def make_quarter_disc(n):
    """Shells on the quarter x, y >= 0 of the unit disc: a core of n x n around the middle and n rings of 2 n around it."""
    i, j = np.meshgrid(np.arange(n + 1), np.arange(n + 1))
    a, b = i.ravel() / n, j.ravel() / n
    core = 0.5 * np.stack([a, b], axis=1) * (1 - 0.15 * a * b)[:, None]  # its corner at 0.85 of that of a square
    border = [n + (n + 1) * k for k in range(n + 1)] + [k + (n + 1) * n for k in range(n - 1, -1, -1)]
    turn = 0.5 * np.pi * np.arange(2 * n + 1) / (2 * n)
    rim = np.stack([np.cos(turn), np.sin(turn)], axis=1)
    rings = [core[border] * (1 - s) + rim * s for s in np.arange(1, n + 1) / n]
    points = np.vstack([core, *rings])
    points[np.abs(points) < 1e-12] = 0
    quads = [[k, k + 1, k + n + 2, k + n + 1] for row in range(n) for k in range(row * (n + 1), row * (n + 1) + n)]
    layers = ([border]
              + [list(range((n + 1)**2 + r * (2 * n + 1), (n + 1)**2 + (r + 1) * (2 * n + 1))) for r in range(n)])
    quads += [[inner[k], outer[k], outer[k + 1], inner[k + 1]] for inner, outer in zip(layers, layers[1:])
              for k in range(2 * n)]
    return np.hstack([points, np.zeros((len(points), 1))]), np.array(quads)


def each_node(points, entry):
    """Lines of a deck, one a node: entry(n, selector) with a selector of this node alone."""

    def select(x):
        place = "[" + ", ".join(repr(float(c)) for c in x) + "]"
        return f"{{inside: [{place}, {place}]}}"

    return "\n".join(f"  - {{nodes: {select(x)}, {entry(n)}}}" for n, x in enumerate(points))


def draw_together(points, share):
    """The Moebius map of the unit ball onto itself that takes (0, 0, share) to the middle: cells near -z shrink."""
    x, y, z = points.T
    square, to_center = x**2 + y**2 + z**2, x**2 + y**2 + (z - share)**2
    scale = 1 / (1 - 2 * share * z + share**2 * square)
    return np.stack([scale * (1 - share**2) * x, scale * (1 - share**2) * y,
                     scale * ((1 - share**2) * (z - share) - share * to_center)], axis=1)


def quarter_ball(bench, radius, across, share):
    """A quarter (x, y >= 0) of a ball, its cells drawn together at the lowest point."""
    points, corners = keep(*generate(bench,
                                     f"sphere: {{radius: 1, cells: {across}}}"), lambda x, y, z: (x > 0) & (y > 0))
    points = radius * draw_together(points, share)
    points[np.abs(points) < 1e-12 * radius] = 0
    return points, corners


def quarter_cylinder(bench, radius, length, across, along):
    """A quarter (x, y >= 0) of a cylinder along z."""
    shape = f"cylinder: {{radius: {radius!r}, length: {length!r}, cells: [{across}, {along}]}}"
    points, corners = keep(*generate(bench, shape), lambda x, y, z: (x > 0) & (y > 0))
    points[np.abs(points) < 1e-12 * radius] = 0
    return points, corners
