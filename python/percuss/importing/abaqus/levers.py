"""Whether what holds or moves a reference node may act on the mass centre of its body instead:
where both lie on one line of action."""

import math

from ..model import Vector
from ..shapes import shell_area, solid_volume, subtract
from .deck import AbaqusDeck, RigidGroup

MOST = 0.02  # share of the reach of a body: a lever that is left out
AXES = ("x", "y", "z")


def find_center(deck: AbaqusDeck, nodes: set[int]) -> Vector | None:
    """The mass centre of nodes, each with its share of the elements around it; None where these have no mass."""
    mass, moment = 0.0, [0.0, 0.0, 0.0]
    for block in deck.model.blocks:
        for id, corners in block.solids + block.shells:
            inside = [node for node in corners if node in nodes]
            if not inside:
                continue
            x = [deck.mesh.nodes[node] for node in corners]
            volume = (shell_area(x) * block.thicknesses.get(id, block.thickness or 0.0) if block.shells
                      else solid_volume(x))
            share = volume * block.density / len(corners)
            mass += share * len(inside)
            for d in range(3):
                moment[d] += share * sum(deck.mesh.nodes[node][d] for node in inside)
    return (moment[0] / mass, moment[1] / mass, moment[2] / mass) if mass > 0 else None


def find_lever(deck: AbaqusDeck, group: RigidGroup) -> float:
    """The largest lever of a direction that is held or moved, about an axis about which the body may turn,
    over the reach of the body."""
    refs = {node for node, _ in group.held.values()}
    center = find_center(deck, group.nodes)
    turns = {direction for direction in group.held if direction.startswith("r")}
    if center is None or len(refs) != 1 or any(group.held[direction][1] is not None for direction in turns):
        return math.inf
    offset = subtract(deck.mesh.nodes[refs.pop()], center)
    reach = max(sum(c * c for c in subtract(deck.mesh.nodes[node], center)) ** 0.5 for node in group.nodes)
    pairs = [(d, a) for d in range(3)
             for a in range(3) if a != d and AXES[d] in group.held and f"r{AXES[3 - d - a]}" not in turns]
    return max((abs(offset[a]) / reach for _, a in pairs), default=0.0) if reach > 0 else math.inf
