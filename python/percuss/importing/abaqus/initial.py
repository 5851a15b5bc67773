"""*INITIAL CONDITIONS: velocities at the start, and what else a run begins with."""

from ..fields import clip
from ..ledger import BadInput
from ..model import Deck
from ..shapes import normalise, subtract
from .axisymmetric import refuse_in_ring
from .conditions import refuse_other_axes
from .deck import AbaqusDeck, Rotation
from .heat import read_temperature
from .lines import Block
from .stresses import read_hardening, read_stresses
from .user_code import read_field, read_solution

INSTEAD = "it is left out"


def read_initial(deck: AbaqusDeck, block: Block) -> None:
    kind = block.option("TYPE")
    if kind in ("STRESS", "ROTATING VELOCITY"):
        refuse_in_ring(deck, f"INITIAL CONDITIONS.{kind}", block.place, "stresses or turns at the start")
    if kind in READERS:
        READERS[kind](deck, block)
    elif kind == "SOLUTION" and "USER" not in block.options:
        read_solution(deck, block)
    else:
        deck.ledger.refuse("INITIAL CONDITIONS", block.place, f"initial conditions of type {clip(kind)}", INSTEAD)


def read_velocity(deck: AbaqusDeck, block: Block) -> None:
    """set, dof, velocity."""
    for line in block.lines:
        place, dof, value = block.at(line[0]), block.integer(line, 1), block.number(line, 2)
        nodes = deck.nodes_of(block.text(line, 0), place)
        refuse_other_axes(deck, nodes, place)
        if not 1 <= dof <= 6 or dof > 3 and not all(node in deck.group_of_ref for node in nodes):
            deck.ledger.refuse("INITIAL CONDITIONS.dof", place, "an initial rotational velocity of nodes", INSTEAD)
            continue
        for node in nodes:
            if node in deck.group_of_ref:
                deck.body_velocities.setdefault(node, [0.0] * 6)[dof - 1] = value
            else:
                deck.velocities.setdefault(node,
                                           [0.0, 0.0, 0.0])[2 if node in deck.turned and dof == 1 else dof - 1] = value
    deck.ledger.translated("INITIAL CONDITIONS", block.place, "initial: velocity")


def read_rotation(deck: AbaqusDeck, block: Block) -> None:
    """set, spin, velocity; then two points of the axis."""
    lines = iter(block.lines)
    for line in lines:
        ends = next(lines, None)
        if ends is None:
            raise BadInput(block.at(line[0]), "a rotating velocity has no axis: add the line with its two points")
        a, b = (tuple(block.number(ends, i) for i in range(k, k + 3)) for k in (0, 3))
        axis = normalise(subtract(b, a))  # type: ignore[arg-type]
        if not any(axis):
            raise BadInput(block.at(ends[0]), "the two points of an axis are one: correct them")
        nodes = deck.nodes_of(block.text(line, 0), block.at(line[0]))
        members = {n for node in nodes
                   for n in (deck.group_of_ref[node].nodes if node in deck.group_of_ref else [node])}
        used = sorted(members & deck.used_nodes())
        if not used:
            deck.ledger.ignored("INITIAL CONDITIONS", block.at(line[0]), "its nodes have no element")
            continue
        spin = [block.number(line, 1) * c for c in axis]
        velocity = [block.number(line, i) for i in (2, 3, 4)]
        entry: Deck = {"nodes": name_nodes(deck, used, "turning"), "velocity": velocity, "angular_velocity": spin,
                       "center": list(a)}
        deck.model.add("initial", entry)
        deck.rotations.append(Rotation(set(used), tuple(velocity), tuple(spin), a))  # type: ignore[arg-type]
        deck.ledger.translated("INITIAL CONDITIONS", block.at(line[0]), "initial: velocity and spin")


def add_velocities(deck: AbaqusDeck) -> None:
    """A node set for each velocity; bodies come last."""
    turning = deck.model.deck.pop("initial", [])
    groups: dict[tuple[float, ...], list[int]] = {}
    of_bodies = {node for ref in deck.body_velocities for node in deck.group_of_ref[ref].nodes}
    for node, velocity in deck.velocities.items():
        if node in deck.used_nodes() and node not in of_bodies:
            groups.setdefault(tuple(velocity), []).append(node)
    for node, velocity in deck.body_velocities.items():
        group = deck.group_of_ref[node]
        if not any(velocity[3:]):
            groups.setdefault(tuple(velocity[:3]), []).extend(sorted(group.nodes))
        elif group.moves_ref:
            turning.append({"body": group.name, "velocity": velocity[:3], "angular_velocity": velocity[3:]})
        elif group.nodes:
            name = name_nodes(deck, sorted(group.nodes), "turning")
            turning.append({"nodes": name, "velocity": velocity[:3], "angular_velocity": velocity[3:],
                            "center": list(deck.mesh.nodes[node])})
    for index, (of_group, members) in enumerate(groups.items(), 1):
        nodes = list(dict.fromkeys(members))
        if not nodes:
            continue
        is_all = len(nodes) == len(deck.used_nodes())
        entry: Deck = {} if is_all else {"nodes": name_nodes(deck, nodes, f"moving_{index}")}
        deck.model.add("initial", {**entry, "velocity": list(of_group)})
    for entry in turning:
        deck.model.add("initial", entry)


def name_nodes(deck: AbaqusDeck, nodes: list[int], wish: str) -> str:
    """The part that has just these nodes, or a set."""
    wanted = set(nodes)
    for block in deck.model.blocks:
        if deck.model.nodes_of_blocks([block.id]) == wanted:
            return block.name
    return deck.model.add_node_set(wish, nodes)


READERS = {
    "VELOCITY": read_velocity, "ROTATING VELOCITY": read_rotation, "TEMPERATURE": read_temperature,
    "STRESS": read_stresses, "FIELD": read_field, "HARDENING": read_hardening,
}  # fmt: skip
