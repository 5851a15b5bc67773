"""*RIGID BODY, *COUPLING with *KINEMATIC, *MPC BEAM: nodes that move as one,
with the reference nodes that move them."""

import math
from dataclasses import dataclass, field

from ..ledger import BadInput, Ledger, Place
from ..model import Deck
from .deck import AbaqusDeck, RigidGroup
from .followers import is_partial, note_couplings
from .levers import MOST, find_center, find_lever
from .lines import Block
from .mesh import BodyCard, Scope
from .reference_ways import ROWS, place_center
from .surfaces import add_wall, finish_wall

TURNS = {"rx", "ry", "rz"}
WAYS = ("x", "y", "z")
LEFT_OUT = "its nodes are free"


def read_rigid_body(scope: Scope, block: Block, ledger: Ledger) -> None:
    pinned = [block.option("PIN NSET")] if block.option("PIN NSET") else []
    nodes = [block.option("TIE NSET")] if block.option("TIE NSET") else []
    profile = block.option("ANALYTICAL SURFACE")
    if profile and (nodes or pinned or "ELSET" in block.options):
        ledger.refuse("RIGID BODY.ANALYTICAL SURFACE", block.place,
                      "an analytical surface with nodes or elements", "it is left out")
        profile = ""
    scope.bodies.append(
        BodyCard(block.keyword, block.place, block.option("REF NODE"), block.option("ELSET"), nodes + pinned,
                 profile=profile, pinned=pinned, at_center=block.option("POSITION") == "CENTER OF MASS")
    )  # fmt: skip


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
    card.held = "".join(str(d) for d in sorted(held)) if held and held != set(range(1, 7)) else ""
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
            ledger.refuse(f"MPC.{kind[:20]}", block.at(line[0]),
                          "a constraint other than BEAM, PIN and TIE", "it is left out")


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
    refuse_free(deck, card)
    for name in card.nodes:
        found.nodes |= set(deck.nodes_of(name, card.place))
    if card.surface:
        found.nodes |= deck.nodes_of_surface(card.surface, card.place)
    found.nodes |= found.refs
    return found


def refuse_free(deck: AbaqusDeck, card: BodyCard) -> None:
    """Rotations that a body leaves free, of nodes that have them."""
    turning = deck.model.turning_nodes()
    if any(node in turning for name in card.pinned for node in deck.nodes_of(name, card.place)):
        deck.ledger.refuse("RIGID BODY.PIN NSET", card.place, "nodes whose rotations are free",
                           "their rotations are those of the body")


def merge(found: list[Members]) -> list[list[Members]]:
    """Merges members that share nodes into one body."""
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
    note_couplings(deck)
    for card in (card for card in deck.mesh.bodies if card.profile):
        add_wall(deck, card)
    for together in merge([list_members(deck, card) for card in deck.mesh.bodies
                           if not card.profile and not card.is_constraint and not is_partial(deck, card)]):
        card = together[0].card
        nodes = {node for m in together for node in m.nodes if node in deck.used_nodes()}
        if not nodes:
            deck.ledger.refuse(card.keyword, card.place, "a rigid body of nodes without elements", "it is left out")
            continue
        group = RigidGroup(card.place, nodes, {node for m in together for node in m.refs})
        group.at_center = any(m.card.at_center for m in together)
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
        group.moves_ref = group.at_center and not has_point_mass_alone(deck, group)
        deck.groups.append(group)
        deck.group_of_ref |= dict.fromkeys(group.refs, group)
        for m in together:
            deck.ledger.translated(m.card.keyword, m.card.place, "rigid parts and rigid_sets")


def add_reference_masses(deck: AbaqusDeck, nodes: list[int], keys: Deck, place: Place) -> list[int]:
    """Mass or inertia at reference nodes belongs to their body. The nodes that are left."""
    left = []
    for node in nodes:
        group = deck.group_of_ref.get(node)
        if group is None:
            left.append(node)
            continue
        if group.moves_ref:
            deck.ledger.refuse("RIGID BODY.POSITION", place,
                               "mass or inertia of a reference node that moves to the centre",
                               "it stays at the place of the node")
        if "mass" in keys and "mass" in group.rigid_keys:
            raise BadInput(place, "a rigid body has two masses at its reference node: add them up")
        group.rigid_keys |= {**keys, "center": list(deck.mesh.nodes[node])}
        deck.ledger.translated("MASS" if "mass" in keys else "ROTARY INERTIA", place,
                               "mass and inertia of a rigid body")
    return left


def has_point_mass_alone(deck: AbaqusDeck, group: RigidGroup) -> bool:
    """Whether its elements are rigid ones, which have no mass."""
    blocks = [block for block in deck.model.blocks
              if block.keys.get("rigid") is not None and group.nodes >= deck.model.nodes_of_blocks([block.id])]
    return bool(blocks) and all(block.keys["material"] == deck.rigid_material for block in blocks)


def add_point_mass(deck: AbaqusDeck, group: RigidGroup) -> None:
    """Rigid elements without mass have that of their reference node; to other bodies it is added."""
    if has_point_mass_alone(deck, group):
        group.at_center = True
        center = (group.rigid_keys.get("center")
                  or list(deck.mesh.nodes[min(group.refs)] if group.refs else deck.mesh.nodes[min(group.nodes)]))
        group.keys |= {**group.rigid_keys, "center": center}
    elif group.rigid_keys:
        name = deck.model.add_node_set("point_mass", [min(group.nodes)])
        deck.model.deck.setdefault("rigid_sets", {})[name] = {"nodes": name, "body": group.name, **group.rigid_keys}


def finish_bodies(deck: AbaqusDeck) -> None:
    """What is held of bodies at their reference nodes."""
    for number, group in enumerate(deck.groups, 1):
        if group.wall:
            finish_wall(deck, group)
            if group.wall:
                continue
        add_point_mass(deck, group)
        hold_group(deck, group, number)
        for block in deck.model.blocks:
            if block.keys.get("rigid") is not None and block.name == group.name:
                block.keys["rigid"] = group.keys or True


def hold_group(deck: AbaqusDeck, group: RigidGroup, number: int) -> None:
    """Holds a body: at rest as a whole, a joint to the ground, or motions of the body."""
    rest = {d for d, (_, motion) in group.held.items() if motion is None}
    moved = {d: motion for d, (_, motion) in group.held.items() if motion is not None}
    directions = group.held.keys() | group.spells.keys()
    if not directions:
        return
    joint = make_joint(deck, group, rest) if not moved and not group.spells and not group.at_center else None
    if joint:
        group.joint = deck.model.names.take(f"held_{number}")
        deck.model.deck.setdefault("joints", {})[group.joint] = joint
        return
    if turns_about_reference(group):
        turn_about_reference(deck, group, number, rest, moved)
        return
    if not (TURNS <= rest or group.at_center or not directions & set(WAYS)):
        note_reference(deck, group)
    if rest:
        group.keys["fixed"] = [d for d in (*WAYS, "rx", "ry", "rz") if d in rest]
    for spell in group.spells.values():
        deck.model.add("conditions", {"body": group.name, **spell})
    if not moved:
        return
    which = ({"body": group.name} if moves_body(group)
             else {"nodes": deck.model.add_node_set(f"body_{number}", group.nodes)})
    for motion in moved.values():
        deck.model.add("conditions", {**which, **motion})


def turns_about_reference(group: RigidGroup) -> bool:
    """Whether all six directions of one reference node away from the centre are prescribed,
    and some turn is a motion."""
    refs = {node for node, _ in group.held.values()}
    turns = any(group.held[way][1] is not None for way in TURNS & group.held.keys())
    return len(group.held) == 6 and turns and len(refs) == 1 and not group.at_center and not group.spells


def turn_about_reference(deck: AbaqusDeck, group: RigidGroup, number: int, rest: set[str],
                         moved: dict[str, Deck]) -> None:
    """A spherical joint to the ground where the reference node stays in its place;
    else the way of the mass centre, which follows from all directions."""
    ref = deck.mesh.nodes[next(node for node, _ in group.held.values())]
    turns = [motion for way, motion in moved.items() if way in TURNS]
    if rest & TURNS:
        group.keys["fixed"] = sorted(rest & TURNS)
    for motion in turns:
        deck.model.add("conditions", {"body": group.name, **motion})
    if rest.issuperset(WAYS):
        group.joint = deck.model.names.take(f"held_{number}")
        deck.model.deck.setdefault("joints", {})[group.joint] = {"kind": "spherical", "bodies": [group.name],
                                                                 "at": list(ref)}
        return
    center = group.rigid_keys.get("center") or find_center(deck, group.nodes)
    if center is None:
        note_reference(deck, group)
        return
    tables = place_center(list(moved.values()), [c - r for c, r in zip(center, ref)], deck.end_time)
    deck.model.add("conditions",
                   {"body": group.name, "displacement": {way: {"table": rows} for way, rows in zip(WAYS, tables)}})
    deck.ledger.approximated("BOUNDARY.reference", group.place,
                             f"the way of the mass centre about the reference node, by {ROWS} rows")


def moves_body(group: RigidGroup) -> bool:
    """Whether its motions are those of a body that may turn, not of all its nodes alike."""
    motions = {direction: motion for direction, (_, motion) in group.held.items()}
    return any(motions.values()) and not all(turn in motions and motions[turn] is None for turn in TURNS)


def note_reference(deck: AbaqusDeck, group: RigidGroup) -> None:
    """What acts on a node away from the centre acts on the centre."""
    lever = find_lever(deck, group) if not group.spells else math.inf
    if lever <= MOST:
        text = ("held or moved at the mass centre, "
                f"on the same line within {lever:.1g} of the body's reach: turns change its place to the second order")
        deck.ledger.approximated("BOUNDARY.reference", group.place, text)
        return
    text = "a reference node away from the centre of its body with only some directions held or moved"
    deck.ledger.refuse("BOUNDARY.reference", group.place, text, "they are those of the centre")


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

