"""Elements of rotational symmetry about y: a sector of 90 degrees with one layer of solids.

A node at the radius r stands at (r, y, 0), and its twin at (0, y, r), whose radial direction is z. Each is held across
its plane, so both move along their radii alone. The rates of strain at the middle of such a solid are those of the
ring, also around the axis: it is as exact as the element of Abaqus.
Its mass, its forces and its energies are those of the ring over 2 pi.
"""

import math
from collections.abc import Iterable

from ..fields import clip
from ..ledger import BadInput, Place
from .deck import AbaqusDeck
from .mesh import BEAMS, POINTS, RINGS, SHELLS, SPRINGS, STRAINED

SHARE = 1 / (2 * math.pi)  # of the ring that the sector is
NEAR = 1e-9  # share of the largest radius: on the axis
OFF_AXIS = 0.01  # share of the shortest edge of an element that has one corner on the axis: where the twin of this is
OTHERS = {*BEAMS, *POINTS, *SPRINGS, *SHELLS, *STRAINED}
HELD = ("x", "z", "rx", "ry", "rz")  # of bodies
TOLD = ("a sector of 90 degrees with one layer: its mass, forces and energies are those of the ring over 2 pi; "
        "radial is x of its nodes, and x and z alike of its stresses")


def turn_rings(deck: AbaqusDeck) -> None:
    """Gives each node away from the axis a twin, which all sets and surfaces with the node have too."""
    mesh = deck.mesh
    rings = deck.list_flat(RINGS)
    if not rings:
        return
    deck.is_ring = True
    raised = 10 ** len(str(max(mesh.nodes)))
    place = mesh.place or Place("", 0)
    axis = NEAR * max(abs(mesh.nodes[node][0]) for _, corners in rings.values() for node in corners)
    for id, (kind, corners) in rings.items():
        for node in corners:
            radius, y, z = mesh.nodes[node]
            if radius < -axis or abs(z) > axis:
                raise BadInput(place, f"node {node} of an axisymmetric element is at r = {radius:g}, z = {z:g} "
                                      "(beyond the axis y, or off its plane): correct it")
            if radius > axis or touches_axis(deck, corners, axis):
                deck.twins[node] = node + raised
                mesh.nodes[node + raised] = (0.0, y, max(radius, OFF_AXIS * find_edge(deck, corners)))
            if radius <= axis:
                deck.on_axis |= {node, node + raised}
        deck.ledger.approximated(f"ELEMENT.{kind}", place, TOLD)
    for id, (kind, corners) in rings.items():
        mesh.elements[id] = (kind, add_layer(deck, corners, axis))
    deck.turned = set(deck.twins.values())
    mesh.masses = [(name, mass * SHARE, where) for name, mass, where in mesh.masses]
    for profile in mesh.profiles.values():
        profile.kind = "REVOLUTION" if profile.kind == "SEGMENTS" else profile.kind
    refuse_others(deck, place)


def touches_axis(deck: AbaqusDeck, corners: tuple[int, ...], axis: float) -> bool:
    """Whether a quadrilateral has one corner on the axis: its solid keeps eight corners,
    of which two are nearly at one place."""
    return len(corners) == 4 and sum(deck.mesh.nodes[node][0] <= axis for node in corners) == 1


def find_edge(deck: AbaqusDeck, corners: tuple[int, ...]) -> float:
    """The shortest."""
    points = [deck.mesh.nodes[node] for node in corners]
    return min(math.dist(a[:2], b[:2]) for a, b in zip(points, points[1:] + points[:1]))


def add_layer(deck: AbaqusDeck, corners: tuple[int, ...], axis: float) -> tuple[int, ...]:
    """Eight corners; a node on the axis is its own twin, and the third of a triangle stands twice."""
    near = corners if len(corners) == 4 else (*corners, corners[2])
    keeps = touches_axis(deck, corners, axis)
    return (*near, *(deck.twins.get(node, node) if keeps or node not in deck.on_axis else node for node in near))


def refuse_others(deck: AbaqusDeck, place: Place) -> None:
    """Elements whose part of the ring is not known."""
    kinds = sorted({kind for kind, _ in deck.mesh.elements.values() if kind in OTHERS and kind != "MASS"})
    if kinds or any(kind == "MASS" and corners[0] in deck.twins for kind, corners in deck.mesh.elements.values()):
        deck.ledger.refuse("ELEMENT.axisymmetric", place,
                           f"elements {', '.join(kinds) or 'MASS'} beside axisymmetric ones",
                           "they act on the sector as they are")


def split_turned(deck: AbaqusDeck, nodes: Iterable[int], directions: list[str]) -> list[tuple[list[int], list[str]]]:
    """Nodes with the directions that these have for them: of a twin x is its z.
    Across its plane a node is held anyway."""
    nodes = list(nodes)
    if not deck.is_ring:
        return [(nodes, directions)]
    ways = [direction for direction in directions if direction != "z"]
    twins = [("z" if direction == "x" else direction) for direction in ways]
    near = [node for node in nodes if node not in deck.turned]
    far = [node for node in nodes if node in deck.turned]
    return [(group, found) for group, found in ((near, ways), (far, twins)) if group and found]


def share_force(deck: AbaqusDeck, nodes: list[int], dof: int) -> list[tuple[list[int], str, float]]:
    """Nodes, the direction and the factor of a force on each ring:
    a half of its sector's share at a node and at its twin."""
    on_axis = [node for node in nodes if node not in deck.turned and node not in deck.twins]
    rows = [(on_axis, "y", SHARE)] if dof == 2 else []
    for group, found in split_turned(deck, [node for node in nodes if node not in on_axis], ["x", "y"][dof - 1 : dof]):
        rows.append((group, found[0], 0.5 * SHARE))
    return [row for row in rows if row[0]]


def hold_bodies(deck: AbaqusDeck) -> None:
    """Rigid bodies move along the axis alone."""
    for group in deck.groups if deck.is_ring else ():
        ref = min(group.refs, default=0)
        for direction in HELD:
            group.held[direction] = (ref, None)
            group.spells.pop(direction, None)


def hold_rings(deck: AbaqusDeck) -> None:
    """Each node of a part stays in its plane, and one of the axis on it."""
    for part in deck.model.blocks if deck.is_ring else ():
        if "rigid" in part.keys:
            continue
        nodes = deck.model.nodes_of_blocks([part.id])
        of_axis = nodes & deck.on_axis
        rows = (("z",), nodes - deck.turned - of_axis), (("x",), nodes & deck.turned - of_axis), (("x", "z"), of_axis)
        for directions, members in rows:
            if members:
                name = deck.model.add_node_set(f"{part.name}_{'plane' if len(directions) == 1 else 'axis'}", members)
                deck.model.add("conditions", {"nodes": name, "fixed": list(directions)})
    tie_axis(deck)


def tie_axis(deck: AbaqusDeck) -> None:
    """A node of the axis and its twin are one."""
    used = deck.used_nodes()
    for node in sorted(deck.on_axis & deck.twins.keys() & used):
        if (node, "y") not in deck.motions.windows:
            constraints = deck.model.deck.setdefault("constraints", {})
            constraints[deck.model.names.take(f"axis_{node}")] = {"equal": ["y"],
                                                                  "between": [{"id": node}, {"id": deck.twins[node]}]}


def refuse_in_ring(deck: AbaqusDeck, card: str, place: Place, what: str) -> None:
    """What has another meaning in a sector."""
    if deck.is_ring:
        deck.ledger.refuse(clip(card), place, f"{what} of axisymmetric elements", "it acts along the axes of space")
