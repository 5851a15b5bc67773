"""*RIGID BODY, *COUPLING with *KINEMATIC, *MPC BEAM: nodes that move as one, with the reference nodes that move them."""

from collections.abc import Iterable
from dataclasses import dataclass, field

from ..ledger import Ledger
from ..model import Deck
from .deck import AbaqusDeck, RigidGroup
from .lines import Block
from .mesh import BodyCard, Scope
from .surfaces import add_wall, finish_wall

TURNS = {"rx", "ry", "rz"}
WAYS = ("x", "y", "z")
LEFT_OUT = "its nodes are free"


def read_rigid_body(scope: Scope, block: Block, ledger: Ledger) -> None:
    if "PIN NSET" in block.options:
        ledger.refuse("RIGID BODY.PIN NSET", block.place, "nodes whose rotations are free", "their rotations are those of the body")
    nodes = [block.option(name) for name in ("TIE NSET", "PIN NSET") if block.option(name)]
    profile = block.option("ANALYTICAL SURFACE")
    if profile and (nodes or "ELSET" in block.options):
        ledger.refuse("RIGID BODY.ANALYTICAL SURFACE", block.place, "an analytical surface with nodes or elements", "it is left out")
        profile = ""
    scope.bodies.append(
        BodyCard(block.keyword, block.place, block.option("REF NODE"), block.option("ELSET"), nodes, profile=profile)
    )


def read_coupling(block: Block) -> BodyCard:
    return BodyCard(block.keyword, block.place, block.option("REF NODE"), surface=block.option("SURFACE"))


def read_kinematic(scope: Scope, card: BodyCard | None, block: Block, ledger: Ledger) -> None:
    """Lines of the first and the last direction; none: all of them."""
    if card is None:
        ledger.refuse(block.keyword, block.place, "a coupling type without *COUPLING", "it is left out")
        return
    held: set[int] = set()
    for line in block.lines:
        first = block.integer(line, 0, 1)
        held |= set(range(first, (block.integer(line, 1, first) or first) + 1))
    if held and held != set(range(1, 7)):
        ledger.refuse("KINEMATIC.free", block.place, "a coupling that leaves directions free", "it couples all directions")
    scope.bodies.append(card)


def read_constraints(scope: Scope, block: Block, ledger: Ledger) -> None:
    """*MPC: lines of a kind and two nodes, or sets of them."""
    for line in block.lines:
        kind = block.text(line, 0).upper()
        if kind in ("BEAM", "PIN", "TIE") and len(line[1]) == 3:
            names = [block.text(line, 1), block.text(line, 2)]
            equal = "" if kind == "BEAM" else "xyz"
            keyword = "MPC" if kind == "BEAM" else f"MPC.{kind}"
            scope.bodies.append(BodyCard(keyword, block.at(line[0]), names[1], nodes=names[:1], equal=equal))
        else:
            ledger.refuse(f"MPC.{kind[:20]}", block.at(line[0]), "a constraint other than BEAM, PIN and TIE", "it is left out")


@dataclass
class Members:
    """What a card makes rigid."""

    card: BodyCard
    nodes: set[int] = field(default_factory=set)
    blocks: set[int] = field(default_factory=set)  # indices of whole parts
    refs: set[int] = field(default_factory=set)


def list_members(deck: AbaqusDeck, card: BodyCard) -> Members:
    found = Members(card)
    if card.ref:
        found.refs = set(deck.nodes_of(card.ref, card.place))
    if card.elements:
        ids = {id for id in deck.elements_of(card.elements, card.place) if id in deck.blocks_of_elements}
        for index in {deck.blocks_of_elements[id] for id in ids}:
            if {id for id, _ in deck.model.blocks[index].elements()} <= ids:
                found.blocks.add(index)
        found.nodes |= {node for id in ids for node in deck.mesh.elements[id][1]}
    for name in card.nodes:
        found.nodes |= set(deck.nodes_of(name, card.place))
    if card.surface:
        found.nodes |= deck.nodes_of_surface(card.surface, card.place)
    found.nodes |= found.refs
    return found


def merge(found: list[Members]) -> list[list[Members]]:
    """Those that share nodes are one body."""
    groups: list[tuple[set[int], list[Members]]] = []
    for members in found:
        nodes, together = set(members.nodes), [members]
        for other in [g for g in groups if g[0] & nodes]:
            groups.remove(other)
            nodes |= other[0]
            together = other[1] + together
        groups.append((nodes, together))
    return [together for _, together in groups]


def build_bodies(deck: AbaqusDeck) -> None:
    """Parts that are rigid, and `rigid_sets` of what they do not have."""
    for card in (card for card in deck.mesh.bodies if card.profile):
        add_wall(deck, card)
    for together in merge([list_members(deck, card) for card in deck.mesh.bodies if not card.profile and not card.equal]):
        card = together[0].card
        nodes = {node for m in together for node in m.nodes if node in deck.used_nodes()}
        if not nodes:
            deck.ledger.refuse(card.keyword, card.place, "a rigid body of nodes without elements", "it is left out")
            continue
        group = RigidGroup(card.place, nodes, {node for m in together for node in m.refs})
        blocks = [deck.model.blocks[index] for index in sorted({index for m in together for index in m.blocks})]
        for block in blocks:
            group.keys = group.keys if group.name else {"body": block.name} if len(blocks) > 1 else {}
            group.name = group.name or block.name
            block.keys["rigid"] = (group.keys or True) if block is blocks[0] else {"body": group.name}
        rest = nodes - deck.model.nodes_of_blocks([block.id for block in blocks])
        if rest:
            name = deck.model.add_node_set(f"rigid_{len(deck.groups) + 1}", rest)
            entry: Deck = {"nodes": name, **({"body": group.name} if blocks else {})}
            deck.model.deck.setdefault("rigid_sets", {})[name] = entry
            group.keys = group.keys if blocks else entry
            group.name = group.name or name
        deck.groups.append(group)
        deck.group_of_ref |= dict.fromkeys(group.refs, group)
        for m in together:
            deck.ledger.translated(m.card.keyword, m.card.place, "rigid parts and rigid_sets")


def hold_reference(deck: AbaqusDeck, nodes: Iterable[int], directions: list[str], motion: Deck | None) -> bool:
    """Notes what a condition does to reference nodes. motion: none: at rest. Whether it acts on such nodes alone."""
    nodes = list(nodes)
    for node in nodes:
        if node in deck.group_of_ref:
            group = deck.group_of_ref[node]
            group.held |= {d: (node, motion) for d in directions}
    return all(node in deck.group_of_ref for node in nodes)


def add_reference_masses(deck: AbaqusDeck, nodes: list[int], mass: float) -> list[int]:
    """Masses at reference nodes without elements belong to their body. The nodes that are left."""
    left = []
    for node in nodes:
        group = deck.group_of_ref.get(node)
        if group is not None and group.wall:
            continue  # a wall is held or moved, whatever its mass
        if group is None or node in deck.used_nodes():
            left.append(node)
            continue
        name = deck.model.add_node_set(f"mass_{node}", [min(group.nodes)])
        entry = {"nodes": name, "body": group.name, "mass": mass, "center": list(deck.mesh.nodes[node])}
        deck.model.deck.setdefault("rigid_sets", {})[name] = entry
    return left


def finish_bodies(deck: AbaqusDeck) -> None:
    """What is held of bodies at their reference nodes."""
    for number, group in enumerate(deck.groups, 1):
        rest = {d for d, (_, motion) in group.held.items() if motion is None}
        moved = {d: motion for d, (_, motion) in group.held.items() if motion is not None}
        if group.wall:
            finish_wall(deck, group)
            continue
        if not group.held:
            continue
        if TURNS <= rest:
            hold_whole(deck, group, number, rest, moved)
        elif not moved and (joint := make_joint(deck, group, rest)):
            deck.model.deck.setdefault("joints", {})[deck.model.names.take(f"held_{number}")] = joint
        elif not moved and not rest & set(WAYS):
            hold_whole(deck, group, number, rest, {})
        else:
            deck.ledger.refuse("BOUNDARY.reference", group.place, "a reference node with only some directions held or moved", "its body is free")


def hold_whole(deck: AbaqusDeck, group: RigidGroup, number: int, rest: set[str], moved: dict[str, Deck]) -> None:
    """Without turns every point of a body moves as its centre does."""
    group.keys["fixed"] = [d for d in (*WAYS, "rx", "ry", "rz") if d in rest]
    for block in deck.model.blocks:
        if block.keys.get("rigid") is not None and block.name == group.name:
            block.keys["rigid"] = group.keys
    if moved:
        name = deck.model.add_node_set(f"body_{number}", group.nodes)
        for motion in moved.values():
            deck.model.add("conditions", {"nodes": name, **motion})


def make_joint(deck: AbaqusDeck, group: RigidGroup, rest: set[str]) -> Deck | None:
    """A reference node that stays in its place is a joint to the ground."""
    turns = TURNS - rest
    nodes = {node for node, _ in group.held.values()}
    if not rest.issuperset(WAYS) or len(turns) not in (1, 3) or len(nodes) > 1:
        return None
    joint: Deck = {"kind": "spherical" if len(turns) == 3 else "revolute", "bodies": [group.name]}
    joint["at"] = list(deck.mesh.nodes[nodes.pop()])
    if len(turns) == 1:
        joint["axis"] = turns.pop()[1]
    return joint

