"""Rigid parts: *PART_INERTIA, *CONSTRAINED_RIGID_BODIES, _EXTRA_NODES, and the motion that is prescribed."""

from ..fields import Row
from ..ledger import BadInput, Place
from ..model import Deck
from .cards import Card, Lines
from .condition_cards import AXES, DIRECTIONS, add_fixed, make_motion
from .deck import KeywordDeck, PartCard

CARD = "BOUNDARY_PRESCRIBED_MOTION_RIGID"


def read_inertia(deck: KeywordDeck, reader: Lines, part: PartCard) -> None:
    """The three lines of *PART_INERTIA: centre and mass, inertia about the centre, velocity."""
    mass = reader.row("XC YC ZC TM IRCS NODEID")
    inertia = reader.row("IXX IXY IXZ IYY IYZ IZZ")
    motion = reader.row("VTX VTY VTZ VRX VRY VRZ")
    if mass.integer("IRCS"):
        reader.take()
        deck.ledger.refuse("PART_INERTIA.IRCS", mass.place, "inertia in a local coordinate system", "the global axes are used")
    xx, xy, xz, yy, yz, zz = inertia.numbers("IXX", "IXY", "IXZ", "IYY", "IYZ", "IZZ")
    node = mass.integer("NODEID")
    if node and node not in deck.nodes:
        mass.fail("NODEID", "there is no such node")
    center = list(deck.nodes[node]) if node else mass.numbers("XC", "YC", "ZC")
    part.inertia = {"mass": mass.positive("TM"), "center": center, "inertia": [xx, yy, zz, xy, yz, xz]}
    part.motion = {"velocity": motion.numbers("VTX", "VTY", "VTZ"), "angular_velocity": motion.numbers("VRX", "VRY", "VRZ")}


def read_merged(deck: KeywordDeck, card: Card) -> None:
    """*CONSTRAINED_RIGID_BODIES: parts that are one body with another."""
    for line in card.lines:
        if line[1].strip():
            row = card.row(line, "PIDL PIDC IFLAG~")
            deck.merged[row.integer("PIDC")] = (row.integer("PIDL"), row.place)


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


def mark_rigid_parts(deck: KeywordDeck) -> None:
    """`rigid` of the parts. The first block of a body says what its parts have in common."""
    leaders: dict[int, list[int]] = {}
    for id in deck.rigid:
        leaders.setdefault(find_lead(deck, id), []).append(id)
    for id, (lead, place) in deck.merged.items():
        if id in deck.rigid and lead in deck.rigid:
            deck.ledger.translated("CONSTRAINED_RIGID_BODIES", place, "rigid.body: parts of one body")
        else:
            deck.ledger.refuse("CONSTRAINED_RIGID_BODIES", place, "a body with a part that is not rigid", "it is left out")
    for lead, members in leaders.items():
        if lead in deck.rigid:
            mark_body(deck, lead, members)
    for part in deck.parts.values():
        if part.inertia and part.id not in deck.rigid:
            deck.ledger.refuse(
                "PART_INERTIA", part.place, "mass and inertia of a part that deforms", "those of the mesh are used"
            )


def mark_body(deck: KeywordDeck, lead: int, members: list[int]) -> None:
    for id in members:
        if id != lead and deck.parts[id].inertia:
            deck.ledger.refuse(
                "PART_INERTIA", deck.parts[id].place, "mass and inertia of a part of another body", "those of the body count"
            )
    blocks = [b for id in sorted(members, key=lambda id: id != lead) for b in deck.model.blocks if b.part == id]
    moved = set(deck.rigid_motions.get(lead, {}))
    held = [d for d in deck.rigid[lead].held if d not in moved]
    for block in blocks:
        keys: Deck = {"body": blocks[0].name} if len(blocks) > 1 else {}
        if block is blocks[0]:
            keys |= deck.parts[lead].inertia or {}
            if held:
                keys["fixed"] = held
        block.keys["rigid"] = keys or True
    if blocks:
        deck.body_names[lead] = blocks[0].name
    if deck.parts[lead].inertia:
        start_body(deck, lead, [block.name for block in blocks])


def start_body(deck: KeywordDeck, lead: int, names: list[str]) -> None:
    """What *PART_INERTIA says of a rigid part: its mass is there already, its motion at the start comes now."""
    part = deck.parts[lead]
    deck.ledger.translated("PART_INERTIA", part.place, "rigid: mass, center, inertia; initial")
    motion = {key: value for key, value in part.motion.items() if any(value)}
    if motion:
        center = {"center": part.inertia["center"]} if "angular_velocity" in motion else {}
        for name in names:
            deck.model.add("initial", {"nodes": name, "velocity": part.motion["velocity"], **motion, **center})


def read_rigid_motion(deck: KeywordDeck, card: Card) -> None:
    """*BOUNDARY_PRESCRIBED_MOTION_RIGID, kept until the bodies are known."""
    reader = card.reader()
    while reader.skip_blank():
        if card.has_id:
            reader.take()
        row = reader.row("ID DOF VAD LCID SF=1 VID DEATH=1e28 BIRTH")
        if abs(row.integer("DOF")) in (4, 8, 9, 10, 11) or row.integer("VAD") == 4:
            reader.take()
        direction = DIRECTIONS.get(row.integer("DOF"))
        if direction:
            deck.rigid_motions.setdefault(row.integer("ID"), {})[direction] = row
        else:
            deck.ledger.refuse(f"{card.keyword}.DOF", row.place, "a direction of a vector, of a rigid part", "it is left out")


def apply_rigid_motions(deck: KeywordDeck) -> None:
    """A condition on all nodes of a body, and on its extra nodes."""
    for id, motions in deck.rigid_motions.items():
        place = next(iter(motions.values())).place
        target = find_moved(deck, id, place)
        if not target:
            deck.ledger.refuse(CARD, place, f"the motion of part {id}, which is no rigid body with elements", "it is left out")
            continue
        check_turns(deck, id, motions)
        for direction, row in motions.items():
            motion = make_motion(deck, row, direction, 1.0)
            if motion:
                deck.model.add("conditions", {"nodes": target, **motion})
                deck.ledger.translated(CARD, row.place, "conditions on the nodes of the body")


def find_moved(deck: KeywordDeck, id: int, place: Place) -> str:
    """The part or the set of nodes that is a body; empty where it has no elements."""
    if id in deck.nodal_bodies and id not in deck.parts:
        return deck.nodal_bodies[id].name
    deck.find_part(id, place)
    body = [part for part in deck.rigid if find_lead(deck, part) == id]
    names = deck.part_names(body)
    extra = [] if is_driven(deck, id) else list_extra_nodes(deck, body)
    if len(names) < 2 and not extra:
        return names[0] if names else ""
    return deck.make_node_set(f"body_{id}", [*deck.model.nodes_of_blocks(deck.blocks_of(body)), *extra], place)


def list_extra_nodes(deck: KeywordDeck, parts: list[int]) -> list[int]:
    """Nodes that cards add to a body."""
    nodes: list[int] = []
    for id in parts:
        for kind, number, place in deck.extra_nodes.get(id, []):
            nodes += [number] if kind == "NODE" else deck.list_members("NODE", number, place)
    return nodes


def check_turns(deck: KeywordDeck, id: int, motions: dict[str, Row]) -> None:
    """A body of which percuss moves all nodes alike along an axis does not turn about the others."""
    held = deck.rigid[id].held if id in deck.rigid else []
    for direction, row in motions.items():
        if direction not in AXES:
            continue
        free = [f"r{axis}" for axis in AXES if axis != direction and f"r{axis}" not in {*held, *motions}]
        if free:
            deck.ledger.refuse(
                f"{CARD}.turns", row.place, f"a rigid part that is moved along {direction} and turns freely",
                f"it does not turn about {' and '.join(axis[1] for axis in free)}",
            )  # fmt: skip


def read_extra_nodes(deck: KeywordDeck, card: Card) -> None:
    """*CONSTRAINED_EXTRA_NODES_NODE and _SET: nodes that move with a rigid part."""
    kind = card.keyword.rsplit("_", 1)[1]
    for line in card.lines:
        if not line[1].strip():
            continue
        row = card.row(line, "PID ID IFLAG~")
        deck.extra_nodes.setdefault(row.integer("PID"), []).append((kind, row.integer("ID"), row.place))


def apply_extra_nodes(deck: KeywordDeck) -> None:
    """They get the motion of the body where it is given, or join the body."""
    for id, entries in deck.extra_nodes.items():
        for kind, number, place in entries:
            deck.find_part(id, place)
            card = f"CONSTRAINED_EXTRA_NODES_{kind}"
            nodes = [number] if kind == "NODE" else deck.list_members("NODE", number, place)
            if is_driven(deck, id):
                move_extra_nodes(deck, id, nodes, place)
                deck.ledger.translated(card, place, "they have the motion of the part")
            else:
                join_extra_nodes(deck, id, nodes, card, place)


def join_extra_nodes(deck: KeywordDeck, id: int, nodes: list[int], card: str, place: Place) -> None:
    """Nodes of other parts that move with a rigid part; those without elements may be of joints."""
    body = deck.body_names.get(find_lead(deck, id)) if id in deck.rigid else None
    if not body:
        deck.ledger.refuse(card, place, f"nodes on part {id}, which is no rigid body with elements", "they are free")
        return
    own = deck.rigid_nodes()
    name = deck.make_node_set(f"extra_{id}", [node for node in nodes if node not in own], place)
    if name:
        deck.model.deck.setdefault("rigid_sets", {})[name] = {"nodes": name, "body": body}
    deck.ledger.translated(card, place, "rigid_sets: nodes of the body" if name else "nodes of the body, without elements")


def is_driven(deck: KeywordDeck, id: int) -> bool:
    """Whether a body cannot turn, and moves along curves or not at all."""
    if id not in deck.rigid:
        return False
    held = set(deck.rigid[id].held)
    return held >= {"rx", "ry", "rz"} and held | set(deck.rigid_motions.get(id, {})) >= set(AXES)


def move_extra_nodes(deck: KeywordDeck, id: int, nodes: list[int], place: Place) -> None:
    name = deck.make_node_set(f"extra_{id}", nodes, place)
    if not name:
        return
    motions = deck.rigid_motions.get(id, {})
    held = [d for d in (*AXES, "rx", "ry", "rz") if d in deck.rigid[id].held and d not in motions]
    add_fixed(deck, name, held, deck.model.node_sets[name])
    for direction, row in motions.items():
        motion = make_motion(deck, row, direction, 1.0)
        if motion:
            deck.model.add("conditions", {"nodes": name, **motion})
