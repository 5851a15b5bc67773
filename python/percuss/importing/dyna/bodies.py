"""The rigid body that a node belongs to: nodes of rigid parts, nodes added to them, nodes of nodal rigid bodies,
with and without elements."""

from collections.abc import Iterable
from dataclasses import dataclass, field

from ..ledger import BadInput, Place, missing
from ..model import Vector
from .deck import KeywordDeck


def find_lead(deck: KeywordDeck, id: int) -> int:
    """The part whose body a part belongs to."""
    seen = {id}
    while id in deck.merged:
        lead, place = deck.merged[id]
        for part in (id, lead):
            deck.find_part(part, place)
        if lead in seen:
            raise BadInput(place, f"part {lead} is merged with itself: correct the ids")
        seen.add(lead)
        id = lead
    return id


def is_driven(deck: KeywordDeck, id: int) -> bool:
    """Whether a rigid part cannot turn, and moves along curves or not at all."""
    if id not in deck.rigid:
        return False
    rows = [row for row in deck.rigid_motions.get(id, [])
            if row.number("BIRTH") <= 0 and not 0 < row.number("DEATH") < deck.end_time]
    held, moved = set(deck.rigid[id].held), {row.integer("DOF") for row in rows}
    return held >= {"rx", "ry", "rz"} and all(axis in held or dof in moved for dof, axis in enumerate("xyz", 1))


def list_extra_nodes(deck: KeywordDeck, parts: Iterable[int]) -> list[int]:
    """Nodes that cards add to a body."""
    nodes: list[int] = []
    for id in parts:
        for entry in deck.extra_nodes.get(id, []):
            nodes += [entry.id] if entry.kind == "NODE" else deck.list_members("NODE", entry.id, entry.place)
    return nodes


def find_bodies(deck: KeywordDeck) -> dict[int, str]:
    """Names of the rigid bodies by node."""
    bodies: dict[int, str] = {}
    for body in deck.nodal_bodies.values():
        if body.name:
            bodies |= dict.fromkeys(deck.list_members("NODE", body.nodes, body.place), body.name)
            if body.center_node:
                bodies[body.center_node] = body.name
    for id in deck.rigid:
        lead = find_lead(deck, id)
        name = deck.body_names.get(lead)
        if not name:
            continue
        extra = list_extra_nodes(deck, [id])
        if is_driven(deck, lead):  # extra nodes with elements move along the same curves
            extra = [node for node in extra if node not in deck.used_nodes()]
        bodies |= dict.fromkeys(extra, name)
        bodies |= dict.fromkeys(deck.nodes_of_part(id), name)
    return bodies


def find_body_name(deck: KeywordDeck, id: int, place: Place) -> str:
    """The body of a rigid part or of a nodal rigid body; empty where it has no elements."""
    if id in deck.nodal_bodies and id not in deck.parts:
        return deck.nodal_bodies[id].name
    deck.find_part(id, place)
    return deck.body_names.get(find_lead(deck, id), "") if id in deck.rigid else ""


def find_point(deck: KeywordDeck, node: int) -> Vector | None:
    """Where a node of a body is; None: at the mass centre, to which LS-DYNA moves PNODE."""
    return None if node in deck.center_nodes else deck.nodes[node]


@dataclass
class Nodes:
    """Nodes of a card."""

    free: list[int] = field(default_factory=list)  # of elements, and of no rigid body
    of_bodies: dict[str, list[int]] = field(default_factory=dict)
    lost: list[int] = field(default_factory=list)  # of neither


def sort_nodes(deck: KeywordDeck, nodes: Iterable[int], place: Place) -> Nodes:
    found, bodies, used = Nodes(), deck.bodies_of_nodes, deck.used_nodes()
    for node in nodes:
        if node not in deck.nodes:
            raise BadInput(place, missing(f"node {node}"))
        if node in bodies:
            found.of_bodies.setdefault(bodies[node], []).append(node)
        elif node in used:
            found.free.append(node)
        else:
            found.lost.append(node)
    return found


def list_card_nodes(deck: KeywordDeck, id: int, is_set: bool, place: Place) -> list[int]:
    """The nodes of a set, or the one node."""
    if not is_set:
        return [id]
    deck.used.add(("NODE", id))
    return deck.list_members("NODE", id, place)


def name_nodes(deck: KeywordDeck, id: int, is_set: bool, free: list[int], place: Place) -> str:
    """Name of the set of a card, or of what of it is no node of rigid bodies."""
    if not is_set:
        name = deck.single_nodes.get(id) or deck.make_node_set(f"node_{id}", [id], place)
        deck.single_nodes[id] = name
        return name
    whole = deck.node_set_name(id, place) or ""
    if len(free) == len(deck.model.node_sets[whole]):
        return whole
    return deck.make_node_set(f"{whole}_free", free, place)
