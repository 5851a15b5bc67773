"""Velocities at time 0 as the entries of `initial` give them,
for what is accelerated from them and for bodies whose nodes disagree."""

import math
from typing import Any

from ..model import Block, Deck, Vector
from ..shapes import cross, make_vector, section_area, shell_area, solid_volume, subtract
from .deck import KeywordDeck

AXES = ("x", "y", "z")
ROUND_OFF = 1e-9  # share of the largest speed
REST: Vector = (0.0, 0.0, 0.0)
Start = tuple[Vector, Vector]  # velocity, spin


def list_members(deck: KeywordDeck, name: str) -> set[int]:
    """Nodes of a set or a part of the deck."""
    if name not in deck.start_members:
        nodes = deck.model.node_sets.get(name)
        blocks = [block.id for block in deck.model.blocks if block.name == name
                  or block.id in deck.model.block_sets.get(name, [])]
        deck.start_members[name] = set(nodes) if nodes is not None else deck.model.nodes_of_blocks(blocks)
    return deck.start_members[name]


def read_start(entry: dict[str, Any]) -> Start:
    """Velocity and spin of an entry of `initial`."""
    return make_vector(entry.get("velocity", REST)), make_vector(entry.get("angular_velocity", REST))


def find_start(deck: KeywordDeck, node: int) -> Start | None:
    """Velocity and spin of a node; None: a spin about a centre that is not known here."""
    for entry in reversed(deck.model.deck.get("initial", [])):
        if "body" in entry or (entry.get("nodes") and node not in list_members(deck, entry["nodes"])):
            continue
        velocity, spin = read_start(entry)
        if not any(spin):
            return velocity, spin
        if "center" not in entry:
            return None
        turned = cross(spin, subtract(deck.nodes[node], make_vector(entry["center"])))
        return make_vector([a + b for a, b in zip(velocity, turned, strict=True)]), spin
    return REST, REST


def by_direction(start: Start | None) -> dict[str, float] | None:
    if start is None:
        return None
    return {axis: start[0][d] for d, axis in enumerate(AXES)} | {f"r{axis}": start[1][d] for d, axis in enumerate(AXES)}


def find_node_start(deck: KeywordDeck, node: int) -> dict[str, float] | None:
    """Initial velocity by direction, as conditions name them."""
    return by_direction(find_start(deck, node))


def list_own_nodes(deck: KeywordDeck, body: str) -> list[int]:
    """Nodes of a body that say how it begins to move: those of rigid elements, or of its set."""
    blocks = [block.id for block in deck.model.blocks if (rigid := block.keys.get("rigid"))
              and body in (block.name, isinstance(rigid, dict) and rigid.get("body"))]
    nodes = deck.model.nodes_of_blocks(blocks) if blocks else set(deck.model.node_sets.get(body, []))
    return sorted(nodes)


def find_body_start(deck: KeywordDeck, body: str) -> dict[str, float] | None:
    """Initial velocity of its mass centre; None where it rotates, so that this is not known here."""
    for entry in reversed(deck.model.deck.get("initial", [])):
        if entry.get("body") == body:
            return by_direction(read_start(entry))
    starts = {find_start(deck, node) for node in list_own_nodes(deck, body)}
    start = starts.pop() if len(starts) == 1 else None
    return by_direction(start) if start is None or not any(start[1]) else None


def balance_bodies(deck: KeywordDeck) -> None:
    """Bodies whose nodes do not begin to move as one: they have the momenta of their nodes, as in LS-DYNA."""
    if "initial" not in deck.model.deck:
        return
    given = {entry["body"] for entry in deck.model.deck["initial"] if "body" in entry}
    bodies = [name for name in dict.fromkeys(deck.bodies_of_nodes.values()) if name not in given]
    masses = find_masses(deck) if bodies else {}
    for body in bodies:
        nodes = list_own_nodes(deck, body)
        starts = [find_start(deck, node) for node in nodes]
        if None in starts or len(set(starts)) < 2:
            continue
        motion = find_mean_motion([(masses.get(node, 0.0), deck.nodes[node], start[0])
                                   for node, start in zip(nodes, starts, strict=True) if start])
        if motion is None:
            continue
        deck.model.add("initial", {"body": body, **motion})
        deck.ledger.approximated("INITIAL_VELOCITY.body", deck.body_places[body],
                                 "a rigid body whose nodes have different velocities has their momenta")


def find_masses(deck: KeywordDeck) -> dict[int, float]:
    """Masses of nodes: equal shares of their elements."""
    masses: dict[int, float] = {}
    for block in deck.model.blocks:
        for id, corners in block.elements():
            share = measure(deck, block, id, corners) / len(corners)
            for node in corners:
                masses[node] = masses.get(node, 0.0) + share
    return masses


def measure(deck: KeywordDeck, block: Block, id: int, corners: tuple[int, ...]) -> float:
    """The mass of an element."""
    x = [deck.nodes[node] for node in corners]
    if len(corners) == 2:
        return math.dist(*x) * section_area(block.keys.get("section", {})) * block.density
    if block.shells and not block.solids:
        return shell_area(x) * block.thicknesses.get(id, block.thickness or 0.0) * block.density
    return solid_volume(x) * block.density


def find_mean_motion(points: list[tuple[float, Vector, Vector]]) -> Deck | None:
    """Velocity of the centre and spin with the momenta of masses at points;
    None: they move as one already, or have no inertia."""
    total = math.fsum(m for m, _, _ in points)
    if total <= 0:
        return None
    center = [math.fsum(m * x[d] for m, x, _ in points) / total for d in range(3)]
    velocity = [math.fsum(m * v[d] for m, _, v in points) / total for d in range(3)]
    inertia = [[0.0] * 3 for _ in range(3)]
    angular = [0.0] * 3
    for m, x, v in points:
        r: Vector = tuple(x[d] - center[d] for d in range(3))  # type: ignore[assignment]
        moment = cross(r, tuple(v[d] - velocity[d] for d in range(3)))  # type: ignore[arg-type]
        square = sum(a * a for a in r)
        for i in range(3):
            angular[i] += m * moment[i]
            for j in range(3):
                inertia[i][j] += m * ((square if i == j else 0.0) - r[i] * r[j])
    spin = solve(inertia, angular)
    if spin is None:
        return None
    largest = max(math.hypot(*v) for _, _, v in points)
    for _, x, v in points:
        turned = cross(spin, tuple(x[d] - center[d] for d in range(3)))  # type: ignore[arg-type]
        if math.dist(v, [velocity[d] + turned[d] for d in range(3)]) > ROUND_OFF * largest:
            return {"velocity": velocity, "angular_velocity": list(spin)}
    return None


def solve(a: list[list[float]], b: list[float]) -> Vector | None:
    """Solution of three equations; None without a solution."""
    rows = [[*a[i], b[i]] for i in range(3)]
    size = max(abs(value) for row in a for value in row) or 1.0
    for k in range(3):
        pivot = max(range(k, 3), key=lambda i: abs(rows[i][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        if abs(rows[k][k]) < 1e-12 * size:
            return None
        for i in range(3):
            if i != k:
                factor = rows[i][k] / rows[k][k]
                rows[i] = [x - factor * y for x, y in zip(rows[i], rows[k], strict=True)]
    return tuple(rows[k][3] / rows[k][k] for k in range(3))  # type: ignore[return-value]
