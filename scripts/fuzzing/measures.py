"""What a run has to show: figures of its summary, history and fields."""

import numpy as np

import percuss

from .geometry import Surface, find_corner_jacobians, find_crossings, find_depths, find_distances


def measure(folder, deck):
    """Figures by name. node_depth, edge_depth: largest of a node, of a point on a sharp edge, in shortest edges of the
    body that it is in; contact_gain: largest work of contact over the initial energy;
    inverted: corners, the most of a frame."""
    run = percuss.read(folder)
    summary, history = run.summary, run.history
    figures = {"time": summary["time"], "steps": summary["steps"], "energy_error": summary["energy"]["error"],
               "momentum": max(summary["momentum"]["linear_error"], summary["momentum"]["angular_error"])}
    initial = summary["energy"]["initial"]
    work = history["contact"] + history["friction"]
    figures["contact_gain"] = float(work.max() / initial) if len(history) and initial > 0 else 0.0
    figures["shortest_step"] = summary["dt"]["min"] / summary["dt"]["max"] if summary["dt"]["max"] else 0.0
    figures["state_hash"] = summary["state_hash"]
    figures.update(_measure_fields(run.fields, deck))
    return figures


def _measure_fields(fields, deck):
    x0 = fields.positions(0)
    is_solid = np.array([len(set(cell)) == 8 for cell in fields.hexahedra])
    hexahedra = fields.hexahedra[is_solid]
    surfaces = _find_surfaces(fields, deck, x0, is_solid)
    inverted, node_depth, edge_depth = 0, 0.0, 0.0
    for frame in range(len(fields.times)):
        x = fields.positions(frame)
        if not np.isfinite(x).all():
            continue
        if len(hexahedra):
            inverted = max(inverted, int((find_corner_jacobians(x, hexahedra) <= 0).sum()))
        nodes, edges = _find_deepest(surfaces, x)
        node_depth, edge_depth = max(node_depth, nodes), max(edge_depth, edges)
    return {"inverted": inverted, "node_depth": node_depth, "edge_depth": edge_depth}


def _find_surfaces(fields, deck, x0, is_solid):
    bodies = fields.data("body", 0).astype(int)
    surfaces = []
    for body in np.unique(bodies):
        of_body = bodies == body
        part = deck["parts"][fields.part_names[fields.part[of_body][0]]]
        cells = fields.hexahedra[of_body]
        solid = is_solid[of_body].all()
        surfaces.append(Surface(x0, cells if solid else cells[:, :4], 0.0 if solid else part["thickness"] / 2))
    return surfaces


def _find_deepest(surfaces, x):
    boxes = [(x[s.nodes].min(axis=0) - s.half_thickness, x[s.nodes].max(axis=0) + s.half_thickness) for s in surfaces]
    deepest_node = deepest_edge = 0.0
    for i, a in enumerate(surfaces):
        for j, b in enumerate(surfaces):
            if i == j or (boxes[i][0] > boxes[j][1]).any() or (boxes[i][1] < boxes[j][0]).any():
                continue
            extra = a.half_thickness
            depth = find_depths(x[a.nodes], b, x, extra).max(initial=0)
            edge = find_depths(a.edge_samples(x), b, x, extra).max(initial=0) if len(a.edges) else 0.0
            if b.is_shell:
                depth = max(depth, _find_depth_behind(a, b, x))
            deepest_node, deepest_edge = (max(deepest_node, depth / b.edge_length),
                                          max(deepest_edge, edge / b.edge_length))
    return deepest_node, deepest_edge


def _find_depth_behind(a, b, x):
    """Depth of the shallower end of an edge of `a` that goes through the middle of shell `b`."""
    edges = np.unique(np.sort(np.concatenate([a.faces[:, [i, (i + 1) % 4]] for i in range(4)]), axis=1), axis=0)
    edges = edges[edges[:, 0] != edges[:, 1]]
    low, high = x[b.nodes].min(axis=0), x[b.nodes].max(axis=0)
    ends = x[edges]
    edges = edges[((ends.max(axis=1) >= low) & (ends.min(axis=1) <= high)).all(axis=1)]
    if not len(edges):
        return 0.0
    crossing = find_crossings(x[edges[:, 0]], x[edges[:, 1]], b, x)
    if not crossing.any():
        return 0.0
    triangles = b.triangles(x)
    ends = [find_distances(x[edges[crossing, k]], triangles) for k in range(2)]
    return float(np.minimum(*ends).max() + a.half_thickness + b.half_thickness)
