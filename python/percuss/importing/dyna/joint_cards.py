"""*CONSTRAINED_NODAL_RIGID_BODY, and joints between rigid bodies by their coincident nodes."""

import math
from dataclasses import dataclass

from ..fields import Row
from ..ledger import BadInput, missing
from ..model import Deck, Vector
from .cards import Card, Lines
from .deck import JointCard, KeywordDeck, NodalBody
from .joint_centers import center_bodies
from .materials.rigid import DIRECTIONS, read_local_limits
from .rigid_cards import read_inertia_lines, start_body

LEFT_OUT = "the joint is left out"
# Nodes of a joint are at one place if they are nearer than this share of the extent of the model.
COINCIDENT = 1e-6
# Joints whose bodies move along the axis: their nodes may lie apart on it.
SLIDING = ("cylindrical", "screw")
# Kind of the joint, and how many nodes.
CARDS = {
    "CONSTRAINED_JOINT_SPHERICAL": ("spherical", 2), "CONSTRAINED_JOINT_REVOLUTE": ("revolute", 4),
    "CONSTRAINED_JOINT_CYLINDRICAL": ("cylindrical", 4), "CONSTRAINED_JOINT_PLANAR": ("planar", 4),
    "CONSTRAINED_JOINT_UNIVERSAL": ("universal", 4), "CONSTRAINED_JOINT_TRANSLATIONAL": ("translational", 6),
    "CONSTRAINED_JOINT_LOCKING": ("fixed", 6), "CONSTRAINED_JOINT_SCREW": ("screw", 6),
}  # fmt: skip


OPTIONS = {"SPC", "INERTIA", "OVERRIDE"}


def read_nodal_body(deck: KeywordDeck, card: Card) -> None:
    """Sets of nodes that are rigid bodies by themselves."""
    options = set(card.keyword.removeprefix("CONSTRAINED_NODAL_RIGID_BODY").split("_")) - {""}
    if options - OPTIONS or "OVERRIDE" in options:
        deck.ledger.refuse(card.keyword, card.place, f"options {' '.join(sorted(options))}", "the body is left out")
        return
    reader = card.reader()
    while reader.next_card():
        title = reader.text() if card.has_title else ""
        row = reader.row("PID CID~output NSID PNODE IPRT~output DRFLAG RRFLAG")
        id, nodes, center = row.integer("PID"), row.integer("NSID"), abs(row.integer("PNODE"))
        row.finish(deck.ledger, "its nodes are rigid in all directions")
        held = read_limits(deck, reader.row("CMO CON1 CON2")) if "SPC" in options else []
        body = NodalBody(id, nodes or id, title, held, row.place, card.keyword, center)
        if "INERTIA" in options:
            given = read_inertia_lines(deck, reader, card.keyword)
            body.inertia, body.motion = given.keys, given.motion
        deck.ids.claim("*CONSTRAINED_NODAL_RIGID_BODY", id, row.place)
        deck.nodal_bodies[id] = body
        if center:
            deck.center_nodes.add(center)


def read_limits(deck: KeywordDeck, limits: Row) -> list[str]:
    """Directions that a body is held in: by two codes, or by six digits along the axes of a system."""
    option = limits.number("CMO")
    if option == 1:
        return [*DIRECTIONS.get(limits.integer("CON1"), ""),
                *("r" + d for d in DIRECTIONS.get(limits.integer("CON2"), ""))]
    if option == -1 and (held := read_local_limits(deck, limits)) is not None:
        return held
    if option:
        deck.ledger.refuse(f"{limits.card}.CMO", limits.place,
                           "a rigid body with constraints along axes that are none of space, or at a point",
                           "it is free")
    return []


def add_nodal_bodies(deck: KeywordDeck) -> None:
    """An entry of `rigid_sets` for each that has nodes with elements."""
    for body in deck.nodal_bodies.values():
        members = deck.list_members("NODE", body.nodes, body.place)
        deck.used.add(("NODE", body.nodes))
        name = deck.make_node_set(body.title or f"rigid_{body.id}", members, body.place)
        if not name:
            deck.ledger.refuse(body.card, body.place, "a body of nodes without elements", "it is left out")
            continue
        body.name = name
        deck.held_of_body[name], deck.body_places[name] = body.held, body.place
        keys: Deck = {"nodes": name} | ({"fixed": body.held} if body.held else {})
        if body.inertia:
            keys |= {**body.inertia, "node_masses": "ignore"}
            deck.body_centers[name] = body.inertia["center"]
            start_body(deck, name, body.motion)
        deck.model.deck.setdefault("rigid_sets", {})[name] = keys
        given = ": mass, center, inertia in place of those of its nodes; initial" if body.inertia else ""
        deck.ledger.translated(body.card, body.place, "rigid_sets" + given)


def read_joints(deck: KeywordDeck, card: Card) -> None:
    """Joints by pairs of nodes, of which the first is of one body and the second of the other."""
    if card.keyword not in CARDS:
        deck.ledger.refuse(card.keyword, card.place, "a joint of another kind, or with options", LEFT_OUT)
        return
    reader = card.reader()
    while reader.next_card():
        title, id = "", 0
        if card.has_id:
            head = reader.row("ID TITLE~", (10, 70))
            id, title = head.integer("ID"), head.text("TITLE")
        row = reader.row("N1 N2 N3 N4 N5 N6 RPS~penalty DAMP~penalty")
        nodes = [row.integer(f"N{k}") for k in range(1, 1 + CARDS[card.keyword][1])]
        row.finish(deck.ledger, "it does not count")
        joint = JointCard(card.keyword, id, title, nodes, row.place)
        if card.keyword == "CONSTRAINED_JOINT_SCREW":
            joint.lead = read_lead(deck, reader)
        deck.joints.append(joint)


def read_lead(deck: KeywordDeck, reader: Lines) -> float:
    """The second line of a screw: PARM is the way along the axis over the angle about it, in radians;
    R1 is the radius of gears."""
    row = reader.row("PARM LCID TYPE R1~unused H_ANGLE")
    lead = 2 * math.pi * row.number("PARM")
    if not lead:
        row.fail("PARM", "must be the way along the axis over the angle, and not 0")
    row.finish(deck.ledger, "it does not count")
    return lead


@dataclass
class Pair:
    """Two nodes at one place, or on one axis, of two bodies; an empty name is none. The place is that of the first."""

    place: Vector
    bodies: tuple[str, str]


def find_extent(deck: KeywordDeck) -> float:
    nodes = list(deck.nodes.values())
    return math.dist([min(x[d] for x in nodes) for d in range(3)], [max(x[d] for x in nodes) for d in range(3)])


def add_joints(deck: KeywordDeck) -> None:
    if not deck.joints:
        return
    bodies, extent = deck.bodies_of_nodes, find_extent(deck)
    for joint in deck.joints:
        pairs = [make_pair(deck, joint, joint.nodes[k : k + 2], bodies) for k in range(0, len(joint.nodes), 2)]
        entry = make_entry(deck, joint, pairs, COINCIDENT * extent)
        why = center_bodies(deck, joint, entry, extent) if entry else ""
        if why:
            deck.ledger.refuse(joint.card, joint.place, why, LEFT_OUT)
        elif entry:
            name = deck.model.names.take(joint.title or f"joint_{joint.id or joint.nodes[0]}", "joint")
            deck.model.deck.setdefault("joints", {})[name] = entry
            deck.ledger.translated(joint.card, joint.place, "joints")


def make_pair(deck: KeywordDeck, joint: JointCard, nodes: list[int], bodies: dict[int, str]) -> Pair:
    for node in nodes:
        if node not in deck.nodes:
            raise BadInput(joint.place, missing(f"node {node}"))
    a, b = (deck.nodes[node] for node in nodes)
    is_sliding = CARDS[joint.card][0] in SLIDING
    place = a if is_sliding or math.dist(a, b) == 0 else tuple((x + y) / 2 for x, y in zip(a, b, strict=True))
    return Pair(place, (bodies.get(nodes[0], ""), bodies.get(nodes[1], "")))  # type: ignore[arg-type]


def make_entry(deck: KeywordDeck, joint: JointCard, pairs: list[Pair], near: float) -> Deck | None:
    """The joint in the deck; None where it is left out."""
    why = find_fault(deck, joint, pairs, near)
    if why:
        deck.ledger.refuse(joint.card, joint.place, why, LEFT_OUT)
        return None
    kind, _ = CARDS[joint.card]
    entry: Deck = {"kind": kind, "bodies": list(pairs[0].bodies), "at": list(pairs[0].place)}
    if kind not in ("spherical", "fixed"):
        entry["axis"] = to_node(deck, pairs[0], joint.nodes[2])
    if kind == "universal":
        entry["second_axis"] = to_node(deck, pairs[0], joint.nodes[3])
    if kind == "screw":
        entry["lead"] = joint.lead
    return entry


def to_node(deck: KeywordDeck, pair: Pair, node: int) -> list[float]:
    return [b - a for a, b in zip(pair.place, deck.nodes[node], strict=True)]


def find_fault(deck: KeywordDeck, joint: JointCard, pairs: list[Pair], near: float) -> str:
    """Why it is no joint of two rigid bodies; empty: it is one."""
    kind = CARDS[joint.card][0]
    for k, pair in enumerate(pairs):
        first, second = joint.nodes[2 * k : 2 * k + 2]
        if kind in SLIDING:
            if k < 2 and not is_on_axis(deck, joint, second, near):
                return f"node {second} of the joint is not on its axis, from node {joint.nodes[0]} to {joint.nodes[2]}"
        elif not (k == 1 and kind == "universal") and math.dist(deck.nodes[first], deck.nodes[second]) > near:
            return f"nodes {first} and {second} of the joint are not at one place"
        if not all(pair.bodies):
            return f"node {second if pair.bodies[0] else first} of the joint is on no rigid body"
        if pair.bodies[0] == pair.bodies[1]:
            return "a joint within one rigid body"
        if pair.bodies != pairs[0].bodies:
            return "a joint whose pairs of nodes are on different bodies"
    if len(pairs) > 1 and any(math.dist(pairs[0].place, deck.nodes[node]) <= near
                              for node in (joint.nodes[2:3] if kind in SLIDING else joint.nodes[2:4])):
        return "a joint whose axis has no direction"
    if kind == "universal" and not is_perpendicular(to_node(deck, pairs[0], joint.nodes[2]),
                                                    to_node(deck, pairs[0], joint.nodes[3])):
        return "a universal joint whose axes, from node 1 to 3 and from 2 to 4, are not perpendicular"
    return ""


def is_on_axis(deck: KeywordDeck, joint: JointCard, node: int, near: float) -> bool:
    """Whether a node is on the line through nodes 1 and 3."""
    start, end, x = (deck.nodes[n] for n in (joint.nodes[0], joint.nodes[2], node))
    axis, way = ([b - a for a, b in zip(start, to, strict=True)] for to in (end, x))
    square = sum(d * d for d in axis)
    along = sum(d * w for d, w in zip(axis, way, strict=True)) / square if square else 0.0
    return math.hypot(*(w - along * d for w, d in zip(way, axis, strict=True))) <= near


def is_perpendicular(a: list[float], b: list[float]) -> bool:
    return abs(sum(x * y for x, y in zip(a, b))) <= COINCIDENT * math.hypot(*a) * math.hypot(*b)
