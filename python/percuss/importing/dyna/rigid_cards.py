"""Rigid parts: *PART_INERTIA, *CONSTRAINED_RIGID_BODIES, _EXTRA_NODES, and the motion that is prescribed."""

from dataclasses import dataclass

from ..fields import Row
from ..ledger import BadInput, Place
from ..model import Deck, Vector
from ..shapes import cross, normalise
from .bodies import find_bodies, find_body_name, find_lead, is_driven
from .body_holds import hold_points
from .cards import Card, Lines
from .condition_cards import AXES, DIRECTIONS, add_fixed
from .deck import ExtraNodes, KeywordDeck, PartCard, RigidPart
from .motion_cards import LAYOUT, MORE, list_motions
from .starting import find_body_start
from .windows import add_motion

CARD = "BOUNDARY_PRESCRIBED_MOTION_RIGID"


@dataclass
class Inertia:
    """What cards give of the mass of a body, and of its motion at the start."""

    keys: Deck  # mass, center, inertia
    motion: Deck  # velocity, angular_velocity


def read_inertia_lines(deck: KeywordDeck, reader: Lines, card: str) -> Inertia:
    """Centre and mass, inertia about the centre, velocity; the latter two in the system that the flag IRCS says."""
    mass = reader.row("XC YC ZC TM IRCS NODEID")
    inertia = reader.row("IXX IXY IXZ IYY IYZ IZZ")
    motion = reader.row("VTX VTY VTZ VRX VRY VRZ")
    xx, xy, xz, yy, yz, zz = inertia.numbers("IXX", "IXY", "IXZ", "IYY", "IYZ", "IZZ")
    tensor: tuple[Vector, ...] = ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))
    if mass.integer("IRCS"):
        tensor = turn_tensor(tensor, read_axes(deck, reader.row("XL YL ZL XLIP YLIP ZLIP CID")))
    center = mass.numbers("XC", "YC", "ZC")
    if node := mass.integer("NODEID"):
        deck.center_rows.append((node, mass, center))
    keys = {"mass": mass.positive("TM"), "center": center,
            "inertia": [tensor[0][0], tensor[1][1], tensor[2][2], tensor[0][1], tensor[1][2],
                        tensor[0][2]]}  # fmt: skip
    return Inertia(keys, {"velocity": motion.numbers("VTX", "VTY", "VTZ"),
                          "angular_velocity": motion.numbers("VRX", "VRY", "VRZ")})


def find_centers(deck: KeywordDeck) -> None:
    """NODEID: mass centres at nodes, which may stand behind the cards that name them."""
    for node, row, center in deck.center_rows:
        if node not in deck.nodes:
            row.fail("NODEID", "there is no such node")
        center[:] = deck.nodes[node]


def read_axes(deck: KeywordDeck, row: Row) -> tuple[Vector, Vector, Vector]:
    """Axes of the local tensor: by two vectors from the origin, or a coordinate system."""
    if id := row.integer("CID"):
        if id not in deck.systems:
            row.fail("CID", "there is no such system of fixed axes before it")
        return deck.systems[id]
    x, plane = tuple(row.numbers("XL", "YL", "ZL")), tuple(row.numbers("XLIP", "YLIP", "ZLIP"))
    axes = make_axes(x, plane)  # type: ignore[arg-type]
    if axes is None:
        row.fail("XL", "two directions that differ are expected")
    return axes


def make_axes(x: Vector, plane: Vector) -> tuple[Vector, Vector, Vector] | None:
    first, third = normalise(x), normalise(cross(x, plane))
    if not any(first) or not any(third):
        return None
    return first, cross(third, first), third


def turn_tensor(tensor: tuple[Vector, ...], axes: tuple[Vector, Vector, Vector]) -> tuple[Vector, ...]:
    """A tensor of local axes in those of space."""
    rows = [[sum(axes[a][i] * tensor[a][b] * axes[b][j] for a in range(3) for b in range(3)) for j in range(3)]
            for i in range(3)]
    return tuple((row[0], row[1], row[2]) for row in rows)


def read_inertia(deck: KeywordDeck, reader: Lines, part: PartCard) -> None:
    """The lines of *PART_INERTIA behind the first."""
    found = read_inertia_lines(deck, reader, "PART_INERTIA")
    part.inertia, part.motion = found.keys, found.motion


def merge_part(deck: KeywordDeck, part: int, lead: int, place: Place) -> None:
    """A part becomes one body with another."""
    other, first = deck.merged.setdefault(part, (lead, place))
    if other != lead:
        raise BadInput(place, f"part {part} is merged with part {lead} and with part {other} (at {first}; "
                              "it can follow one): remove one, or merge these parts")


def read_merged(deck: KeywordDeck, card: Card) -> None:
    """*CONSTRAINED_RIGID_BODIES: parts that are one body with another."""
    for line in card.lines:
        if line[1].strip():
            row = card.row(line, "PIDL PIDC IFLAG")
            merge_part(deck, row.integer("PIDC"), row.integer("PIDL"), row.place)
            if row.integer("IFLAG"):
                deck.updated_bodies[row.integer("PIDL")] = row.place


def read_switched(deck: KeywordDeck, card: Card) -> None:
    """*DEFORMABLE_TO_RIGID: parts that are rigid from the start of the run on."""
    for line in card.lines:
        if not line[1].strip():
            continue
        row = card.row(line, "PID LRB PTYPE")
        id, lead, kind = row.integer("PID"), row.integer("LRB"), row.text("PTYPE").upper()
        if kind not in ("", "PART", "PSET"):
            row.fail("PTYPE", "PART or PSET is expected")
        deck.switched.append((id, kind == "PSET", lead, row.place))


def switch_parts(deck: KeywordDeck) -> None:
    """Parts of *DEFORMABLE_TO_RIGID are rigid bodies, or parts of one."""
    for id, is_set, lead, place in deck.switched:
        for part in deck.list_members("PART", id, place) if is_set else [id]:
            deck.find_part(part, place)
            if deck.names_of_parts.get(part) and part not in deck.rigid:
                deck.rigid[part] = RigidPart([])
            if lead and lead != part:
                merge_part(deck, part, lead, place)
        deck.ledger.translated("DEFORMABLE_TO_RIGID", place, "parts.NAME.rigid")


def mark_rigid_parts(deck: KeywordDeck) -> None:
    """`rigid` of the parts. The first block of a body says what its parts have in common."""
    find_centers(deck)
    switch_parts(deck)
    leaders: dict[int, list[int]] = {}
    for id in deck.rigid:
        leaders.setdefault(find_lead(deck, id), []).append(id)
    switched = {place for *_, place in deck.switched}
    for id, (lead, place) in deck.merged.items():
        card = "DEFORMABLE_TO_RIGID.LRB" if place in switched else "CONSTRAINED_RIGID_BODIES"
        if id in deck.rigid and lead in deck.rigid:
            deck.ledger.translated(card, place, "rigid.body: parts of one body")
        else:
            deck.ledger.refuse(card, place, "a body with a part that is not rigid", "it is left out")
    for lead, members in leaders.items():
        if lead in deck.rigid:
            mark_body(deck, lead, members)
    for part in deck.parts.values():
        if part.inertia and part.id not in deck.rigid:
            deck.ledger.refuse(
                "PART_INERTIA", part.place, "mass and inertia of a part that deforms", "those of the mesh are used"
            )
    for lead, place in deck.updated_bodies.items():
        if lead in deck.parts and deck.parts[lead].inertia:
            deck.ledger.refuse(
                "CONSTRAINED_RIGID_BODIES.IFLAG", place,
                "IFLAG is 1: the masses of merged parts beside a *PART_INERTIA",
                "those of *PART_INERTIA are of the whole body"
            )


def mark_body(deck: KeywordDeck, lead: int, members: list[int]) -> None:
    for id in members:
        if id != lead and deck.parts[id].inertia:
            deck.ledger.refuse(
                "PART_INERTIA", deck.parts[id].place, "mass and inertia of a part of another body",
                "those of the body count"
            )
    blocks = [b for id in sorted(members, key=lambda id: id != lead) for b in deck.model.blocks if b.part == id]
    moved = {DIRECTIONS.get(row.integer("DOF")) for row in deck.rigid_motions.get(lead, [])}
    held = [d for d in deck.rigid[lead].held if d not in moved]
    for block in blocks:
        keys: Deck = {"body": blocks[0].name} if len(blocks) > 1 else {}
        if block is blocks[0]:
            keys |= deck.parts[lead].inertia or {}
            if held:
                keys["fixed"] = held
        block.keys["rigid"] = keys or True
    if blocks:
        deck.body_names[lead] = name = blocks[0].name
        deck.held_of_body[name] = held
        deck.body_places[name] = deck.parts[lead].place
    if deck.parts[lead].inertia and blocks:
        deck.body_centers[blocks[0].name] = deck.parts[lead].inertia["center"]  # type: ignore[index]
        start_body(deck, blocks[0].name, deck.parts[lead].motion)
        deck.ledger.translated("PART_INERTIA", deck.parts[lead].place, "rigid: mass, center, inertia; initial")


def start_body(deck: KeywordDeck, body: str, motion: Deck) -> None:
    """The velocity that a card with the inertia of a body gives to it.
    It counts, also where it is 0, unless IRIGID of others says no."""
    entry: Deck = {"body": body, "velocity": motion["velocity"]}
    if any(motion["angular_velocity"]):
        entry["angular_velocity"] = motion["angular_velocity"]
    deck.started_bodies[body] = entry
    deck.model.add("initial", entry)


def read_rigid_motion(deck: KeywordDeck, card: Card) -> None:
    """*BOUNDARY_PRESCRIBED_MOTION_RIGID, kept until the bodies are known."""
    if card.keyword != CARD:
        deck.ledger.refuse(card.keyword, card.place, "this form of the card", "it is left out")
        return
    reader = card.reader()
    while reader.next_card():
        if card.has_id:
            reader.take()
        row = reader.row(LAYOUT)
        if abs(row.integer("DOF")) in (9, 10, 11) or row.integer("VAD") == 4:
            reader.row(MORE)
            deck.ledger.refuse(f"{CARD}.DOF", row.place,
                               f"DOF {row.integer('DOF')} with VAD {row.integer('VAD')}, of a rigid part",
                               "it is left out")
            continue
        deck.rigid_motions.setdefault(row.integer("ID"), []).append(row)


def apply_rigid_motions(deck: KeywordDeck) -> None:
    """Conditions of the mass centres of bodies and of their turns about them."""
    for id, rows in deck.rigid_motions.items():
        body = find_body_name(deck, id, rows[0].place)
        if not body:
            deck.ledger.refuse(CARD, rows[0].place,
                               f"the motion of part {id}, which is no rigid body with elements", "it is left out")
            continue
        for row in rows:
            for direction, motion in list_motions(deck, row, find_body_start(deck, body)):
                hold_points(deck, body, [None], {direction: motion}, row.place, CARD)


def read_extra_nodes(deck: KeywordDeck, card: Card) -> None:
    """*CONSTRAINED_EXTRA_NODES_NODE and _SET: nodes that move with a rigid part."""
    kind = card.keyword.rsplit("_", 1)[1]
    if kind not in ("NODE", "SET"):
        deck.ledger.refuse(card.keyword, card.place, "this form of the card", "it is left out")
        return
    for line in card.lines:
        if not line[1].strip():
            continue
        row = card.row(line, "PID ID IFLAG")
        entry = ExtraNodes(kind, row.integer("ID"), bool(row.integer("IFLAG")), row.place)
        deck.extra_nodes.setdefault(row.integer("PID"), []).append(entry)


def apply_extra_nodes(deck: KeywordDeck) -> None:
    """They get the motion of the body where it is given, or join the body."""
    for id, entries in deck.extra_nodes.items():
        for entry in entries:
            deck.find_part(id, entry.place)
            card = f"CONSTRAINED_EXTRA_NODES_{entry.kind}"
            nodes = [entry.id] if entry.kind == "NODE" else deck.list_members("NODE", entry.id, entry.place)
            if is_driven(deck, id):
                move_extra_nodes(deck, id, nodes, entry.place)
                deck.ledger.translated(card, entry.place, "they have the motion of the part")
            else:
                join_extra_nodes(deck, id, nodes, card, entry)


def join_extra_nodes(deck: KeywordDeck, id: int, nodes: list[int], card: str, entry: ExtraNodes) -> None:
    """Nodes of other parts that move with a rigid part; those without elements carry loads, masses and joints to it."""
    lead = find_lead(deck, id)
    body = deck.body_names.get(lead) if id in deck.rigid else None
    if not body:
        deck.ledger.refuse(card, entry.place,
                           f"nodes on part {id}, which is no rigid body with elements", "they are free")
        return
    own = deck.rigid_nodes()
    name = deck.make_node_set(f"extra_{id}", [node for node in nodes if node not in own], entry.place)
    if name:
        keys: Deck = {"nodes": name, "body": body}
        if deck.parts[lead].inertia and not entry.adds_mass:
            keys["node_masses"] = "ignore"  # those of *PART_INERTIA include them
        deck.model.deck.setdefault("rigid_sets", {})[name] = keys
    deck.ledger.translated(card, entry.place,
                           "rigid_sets: nodes of the body" if name else "nodes of the body, without elements")


def move_extra_nodes(deck: KeywordDeck, id: int, nodes: list[int], place: Place) -> None:
    name = deck.make_node_set(f"extra_{id}", nodes, place)
    if not name:
        return
    rows = deck.rigid_motions.get(id, [])
    moved = {DIRECTIONS.get(row.integer("DOF")) for row in rows}
    held = [d for d in (*AXES, "rx", "ry", "rz") if d in deck.rigid[id].held and d not in moved]
    add_fixed(deck, name, held, deck.model.node_sets[name])
    for row in rows:
        for _, motion in list_motions(deck, row, find_body_start(deck, deck.body_names[find_lead(deck, id)])):
            add_motion(deck, {"nodes": name}, motion)


def find_all_bodies(deck: KeywordDeck) -> None:
    """Once rigid parts and nodal bodies are known."""
    deck.bodies_of_nodes = find_bodies(deck)
