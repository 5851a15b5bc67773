"""Solids by their number of nodes: hexahedra (8), wedges (6), pyramids (5), tetrahedra of four and ten nodes, in the
orders of Exodus. percuss cuts those of ten nodes into eight of four."""

# Faces outward by the right-hand rule; those of hexahedra in LS-DYNA's order of segments.
HEX_FACES = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
FACES = {
    8: HEX_FACES,
    6: ((0, 2, 1), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)),
    5: ((0, 3, 2, 1), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)),
    4: ((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)),
}
MIDDLES = {frozenset(edge): 4 + i for i, edge in enumerate(((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)))}
# Ten-node tetrahedra: the triangles at the corners of each face and between them.
FACES[10] = tuple(
    triangle
    for face in FACES[4]
    for a, b, c in [face]
    for ab, bc, ca in [[MIDDLES[frozenset(edge)] for edge in ((a, b), (b, c), (c, a))]]
    for triangle in ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))
)
# Faces that a segment may name.
SEGMENTS = FACES | {10: FACES[4] + FACES[10]}
HEX_EDGES = ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7))
NAMES = {8: "hexahedra", 10: "tetrahedra of ten nodes", 6: "wedges", 5: "pyramids", 4: "tetrahedra"}
# Corners of a *ELEMENT_SOLID with eight nodes that says the same: n5 = n6 and n7 = n8, n5 = ... = n8, n4 = ... = n8.
OF_EIGHT = {8: (0, 1, 2, 3, 4, 5, 6, 7), 6: (1, 0, 3, 4, 2, 2, 5, 5), 5: (0, 1, 2, 3, 4, 4, 4, 4),
            4: (0, 1, 2, 3, 3, 3, 3, 3)}


def collapse(corners: list[int]) -> tuple[int, ...] | None:
    """What eight corners are that name some nodes more than once, judged by the faces that are left; None: no solid.

    A wedge has two parallel edges of a face collapsed, a pyramid a face, a tetrahedron a face and an edge."""
    faces = []
    for face in HEX_FACES:
        nodes = [corners[i] for i in face]
        cycle = [node for i, node in enumerate(nodes) if node != nodes[i - 1]]
        if len(set(cycle)) < min(len(cycle), 3):
            continue
        if len(set(cycle)) < len(cycle):
            return None
        if len(cycle) >= 3:
            faces.append(cycle)
    triangles = [face for face in faces if len(face) == 3]
    others = [face for face in faces if len(face) == 4]
    count = len(set(corners))
    if count == 6 and len(triangles) == 2 and len(others) == 3:
        low = [triangles[0][i] for i in (0, 2, 1)]
        return (*low, *(find_across(corners, node, triangles[1]) for node in low))
    if count == 5 and len(triangles) == 4 and len(others) == 1:
        return tuple(others[0][i] for i in (0, 3, 2, 1)) + tuple(set(corners) - set(others[0]))
    if count == 4 and len(triangles) >= 2:
        return tuple(triangles[0][i] for i in (0, 2, 1)) + tuple(set(corners) - set(triangles[0]))
    return None


def find_across(corners: list[int], node: int, others: list[int]) -> int:
    """The other end of the edge from a node to one of the others."""
    for a, b in HEX_EDGES:
        for first, second in ((corners[a], corners[b]), (corners[b], corners[a])):
            if first == node and second in others:
                return second
    return node
