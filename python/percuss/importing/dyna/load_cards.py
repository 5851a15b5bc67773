"""*LOAD_...: gravity, forces on nodes, pressures."""

from dataclasses import dataclass

from ..curves import make_time_value
from ..fields import Row
from ..ledger import BadInput, Place, missing
from ..model import Deck
from ..shapes import FaceOwners, is_crossed
from .bodies import find_body_name, find_point, list_card_nodes, name_nodes, sort_nodes
from .cards import Card
from .condition_cards import AXES, DIRECTIONS, find_factors, refuse_lost
from .deck import KeywordDeck, PartGravity

Face = tuple[int, ...]


def read_body_load(deck: KeywordDeck, card: Card) -> None:
    """*LOAD_BODY_X, _Y, _Z: the base accelerates, so bodies feel the opposite."""
    form = card.keyword.removeprefix("LOAD_BODY_")
    if form not in ("X", "Y", "Z"):
        instead = "gravity acts on all parts" if form == "PARTS" else "it is left out"
        deck.ledger.refuse(card.keyword, card.place, "this form of body load", instead)
        return
    row = card.reader().row("LCID SF=1 LCIDDR XC~unused YC~unused ZC~unused CID")
    factors, scale = find_factors(deck, row, form.lower()), row.number("SF") or 1.0
    curve = deck.curve(row.integer("LCID"), row.place, "time", "acceleration")
    if row.integer("LCIDDR") and "relaxation" in deck.model.deck.get("start", {}):
        deck.ledger.refuse(f"{card.keyword}.LCIDDR", row.place, "LCIDDR, a load of the relaxation alone",
                           "the relaxation has LCID at time 0")
    row.skip("LCIDDR")
    row.finish(deck.ledger)
    for direction, factor in factors.items():
        add_gravity(deck, card, direction, make_time_value(curve, -scale * factor, deck.end_time), row.place)
    deck.ledger.translated(card.keyword, row.place, "loads.gravity, with the opposite sign")


def add_gravity(deck: KeywordDeck, card: Card, direction: str, value: "float | Deck", place: Place) -> None:
    """Adds to the acceleration along an axis."""
    gravity = deck.model.deck.setdefault("loads", {}).setdefault("gravity", [0.0, 0.0, 0.0])
    axis = AXES.index(direction)
    if isinstance(value, float) and isinstance(gravity[axis], float):
        gravity[axis] += value
    elif gravity[axis] == 0.0:
        gravity[axis] = value
    else:
        deck.ledger.refuse(card.keyword, place, "a second acceleration along the same axis", "the first one holds")


def read_part_gravity(deck: KeywordDeck, card: Card) -> None:
    """*LOAD_GRAVITY_PART, _SET: percuss has one gravity, so all parts must have the same."""
    reader = card.reader()
    while reader.skip_blank():
        row = reader.row("ID DOF LC ACCEL LCDR~relaxation STGA STGR")
        id, dof, acceleration = row.integer("ID"), row.integer("DOF"), row.number("ACCEL")
        if dof not in (1, 2, 3):
            row.fail("DOF", "1, 2 or 3 is expected")
        parts = deck.list_members("PART", id, row.place) if "SET" in card.keyword else [id]
        for part in parts:
            deck.find_part(part, row.place)
        deck.part_gravity.append(PartGravity(card, row.place, set(parts), AXES[dof - 1], row.integer("LC"),
                                             acceleration))
        row.finish(deck.ledger, "it acts during the whole run")


def apply_part_gravity(deck: KeywordDeck) -> None:
    """Gravity of all parts where each has the same; else refused."""
    groups: dict[tuple[str, int, float], list[PartGravity]] = {}
    for entry in deck.part_gravity:
        groups.setdefault((entry.axis, entry.curve, entry.acceleration), []).append(entry)
    everything = {block.part for block in deck.model.blocks}
    for (axis, curve, acceleration), entries in groups.items():
        first = entries[0]
        missed = everything - {part for entry in entries for part in entry.parts}
        if missed:
            problem = f"gravity of some parts (part {min(missed)} has none along {axis})"
            if not deck.ledger.refuse(first.card.keyword, first.place, problem, "gravity acts on all parts"):
                continue
        value = (make_time_value(deck.curve(curve, first.place, "time", "none"), -acceleration, deck.end_time) if curve
                 else -acceleration)
        add_gravity(deck, first.card, axis, value, first.place)
        for entry in entries:
            deck.ledger.translated(entry.card.keyword, entry.place,
                                   "loads.gravity of all parts, with the opposite sign")


def read_node_load(deck: KeywordDeck, card: Card) -> None:
    """*LOAD_NODE_SET and _POINT."""
    form = card.keyword.removeprefix("LOAD_NODE_")
    if form not in ("SET", "POINT"):
        deck.ledger.refuse(card.keyword, card.place,
                           "a load whose function is evaluated once, or another form of loads on nodes",
                           "it is left out")
        return
    reader = card.reader()
    while reader.next_card():
        if card.has_id:
            reader.take()
        row = reader.row("ID DOF LCID SF=1 CID M1~unused M2~unused M3~unused")
        direction = DIRECTIONS.get(row.integer("DOF"))
        if direction is None:
            deck.ledger.refuse(f"{card.keyword}.DOF", row.place,
                               f"DOF {row.integer('DOF')}, a follower force", "it is left out")
            continue
        load, id = make_load(deck, row, direction), row.integer("ID")
        row.finish(deck.ledger)
        apply_node_load(deck, card, Target(id, form == "SET", row.place), load)


def make_load(deck: KeywordDeck, row: Row, direction: str) -> Deck:
    """force or moment of a row, along the axes of space."""
    kind = "force" if direction in AXES else "moment"
    curve, scale = deck.curve(row.integer("LCID"), row.place, "time", kind), row.number("SF") or 1.0
    factors = find_factors(deck, row, direction)
    return {kind: {d[-1]: make_time_value(curve, scale * factor, deck.end_time) for d, factor in factors.items()}}


def add_load(deck: KeywordDeck, entry: Deck) -> None:
    deck.model.deck.setdefault("loads", {}).setdefault("nodal", []).append(entry)


@dataclass
class Target:
    """A node or a set of a card."""

    id: int
    is_set: bool
    place: Place


def apply_node_load(deck: KeywordDeck, card: Card, on: Target, load: Deck) -> None:
    """Applies a load to each node. On a rigid body act moments on its nodes, and forces on nodes without elements."""
    found = sort_nodes(deck, list_card_nodes(deck, on.id, on.is_set, on.place), on.place)
    refuse_lost(deck, card.keyword, found.lost, on.place, "a load")
    nodes, used = list(found.free), deck.used_nodes()
    for body, members in found.of_bodies.items():
        for node in members:
            if node in used and "force" in load:
                nodes.append(node)
                continue
            point = find_point(deck, node)
            at: Deck = {"at": list(point)} if point and "force" in load else {}
            add_load(deck, {"body": body, **at, **load})
            deck.ledger.translated(card.keyword, on.place, "loads.nodal of the rigid body")
    if nodes:
        add_load(deck, {"nodes": name_nodes(deck, on.id, on.is_set, nodes, on.place), **load})
        deck.ledger.translated(card.keyword, on.place, "loads.nodal: the whole load on each node")


def read_body_force(deck: KeywordDeck, card: Card) -> None:
    """*LOAD_RIGID_BODY: at the mass centre of a rigid part or a nodal rigid body."""
    reader = card.reader()
    while reader.skip_blank():
        row = reader.row("ID DOF LCID SF=1 CID M1~unused M2~unused M3~unused")
        direction, id = DIRECTIONS.get(row.integer("DOF")), row.integer("ID")
        if direction is None:
            deck.ledger.refuse(f"{card.keyword}.DOF", row.place,
                               f"DOF {row.integer('DOF')}, a follower force", "it is left out")
            continue
        load = make_load(deck, row, direction)
        row.finish(deck.ledger)
        body = find_body_name(deck, id, row.place)
        if not body:
            deck.ledger.refuse(card.keyword, row.place,
                               f"a load on part {id}, which is no rigid body with elements", "it is left out")
            continue
        add_load(deck, {"body": body, **load})
        deck.ledger.translated(card.keyword, row.place, "loads.nodal of the rigid body")


def add_pressure(deck: KeywordDeck, faces: str, load: Deck) -> None:
    deck.model.deck.setdefault("loads", {}).setdefault("pressure", []).append({"faces": faces, **load})


def read_segment_load(deck: KeywordDeck, card: Card) -> None:
    """*LOAD_SEGMENT and _SET, *LOAD_SHELL_SET and _ELEMENT: positive against the normal of the nodes."""
    if card.keyword not in ("LOAD_SEGMENT", "LOAD_SEGMENT_SET", "LOAD_SHELL_SET", "LOAD_SHELL_ELEMENT"):
        deck.ledger.refuse(card.keyword, card.place, "this form of pressure", "it is left out")
        return
    groups: dict[tuple[int, float, float], list[Face]] = {}
    shells = list_shells(deck) if "SHELL" in card.keyword else {}
    reader = card.reader()
    while reader.next_card():
        if card.has_id:
            reader.take()
        if card.keyword == "LOAD_SEGMENT":
            row = reader.row("LCID SF=1 AT N1 N2 N3 N4 N5")
            nodes = [row.integer(name) for name in ("N1", "N2", "N3", "N4")]
            faces = [tuple(nodes[:3] if nodes[3] in (0, nodes[2]) else nodes)]
            if row.integer("N5"):
                deck.ledger.refuse(f"{card.keyword}.N5", row.place, "N5 to N8, a face with nodes on its edges",
                                   "the corners alone count")
                reader.take()
        else:
            row = reader.row("ID LCID SF=1 AT")
            faces = list_faces(deck, card, row, shells)
        note_crossed(deck, card, faces, row.place)
        key = (row.integer("LCID"), row.number("SF") or 1.0, row.number("AT"))
        groups.setdefault(key, []).extend(faces)
    apply_pressures(deck, card, groups)


def list_shells(deck: KeywordDeck) -> dict[int, Face]:
    """Shells of the mesh, and skins of *MAT_NULL, under which are faces of solids."""
    skins = {shell.id: shell.corners for part in deck.skins for shell in deck.elements[part].shells}
    return skins | {id: corners for block in deck.model.blocks for id, corners in block.shells}


def list_faces(deck: KeywordDeck, card: Card, row: Row, shells: dict[int, Face]) -> list[Face]:
    """Faces of a set of segments or shells."""
    id = row.integer("ID")
    if card.keyword == "LOAD_SEGMENT_SET":
        deck.used.add(("SEGMENT", id))
        return deck.find_set("SEGMENT", id, row.place).segments
    wanted = deck.list_members("SHELL", id, row.place) if card.keyword == "LOAD_SHELL_SET" else [id + deck.shell_shift]
    lost = [shell for shell in wanted if shell not in shells]
    if lost:
        deck.ledger.refuse(f"{card.keyword}.free", row.place,
                           f"a pressure on shell {lost[0] - deck.shell_shift}, which is not in the mesh",
                           "it is left out")
    return [shells[shell] for shell in wanted if shell in shells]


def note_crossed(deck: KeywordDeck, card: Card, faces: list[Face], place: Place) -> None:
    """Tells of faces whose nodes are not in order around them."""
    for face in faces:
        if all(node in deck.nodes for node in face) and is_crossed([deck.nodes[node] for node in face]):
            deck.ledger.approximated(f"{card.keyword}.crossed", place, "nodes that are not in order around their face: "
                                                                       "their normal is that of the last three")


def apply_pressures(deck: KeywordDeck, card: Card, groups: dict[tuple[int, float, float], list[Face]]) -> None:
    """Pressures by curve and side: percuss pushes into a solid, whatever the order of the nodes,
    LS-DYNA against their normal."""
    owners = FaceOwners(deck.model, {node for faces in groups.values() for face in faces for node in face})
    for (curve_id, scale, shift), faces in groups.items():
        if curve_id == BLAST_CURVE:
            apply_blast(deck, card, find_blast(deck, card, 0), scale, faces, owners)
            continue
        curve = deck.curve(curve_id, card.place, "time", "stress")
        for sign, members in split_by_sign(deck, card, faces, owners).items():
            press_on(deck, card, members, {"value": make_time_value(curve, scale * sign, deck.end_time, shift)})


def split_by_sign(deck: KeywordDeck, card: Card, faces: list[Face], owners: FaceOwners) -> dict[float, list[Face]]:
    """Faces whose normal points out of their element, 1, and into it, -1."""
    by_sign: dict[float, list[Face]] = {}
    for face in faces:
        sign = owners.find_sign(face)
        if sign is None:
            deck.ledger.refuse(f"{card.keyword}.free", card.place,
                               "segments that are not a face of any element", "they are left out")
        else:
            by_sign.setdefault(sign, []).append(face)
    return by_sign


def press_on(deck: KeywordDeck, card: Card, faces: list[Face], load: Deck) -> None:
    name = deck.model.names.take(f"pressed_{card.keyword.lower().removeprefix('load_')}")
    deck.model.side_sets[name] = faces
    add_pressure(deck, name, load)
    deck.ledger.translated(card.keyword, card.place, "loads.pressure")


# --- blasts

BLAST_CURVE = -2  # of *LOAD_SEGMENT: the pressure of *LOAD_BLAST
# Systems of units by the code of the cards. Others are English, or need factors.
BLAST_UNITS = {2: "m, kg, s", 4: "cm, g, us", 6: "mm, kg, ms", 7: "mm, t, s", 8: "mm, g, ms"}
BURSTS = {1: "ground", 2: "air"}  # a hemisphere, a sphere


def read_blast(deck: KeywordDeck, card: Card) -> None:
    """*LOAD_BLAST and *LOAD_BLAST_ENHANCED: a charge of TNT. Segments name it by its number, 0 of the former."""
    reader = card.reader()
    is_old = card.keyword == "LOAD_BLAST"
    if is_old:
        row = reader.row("WGT XBO YBO ZBO TBO IUNIT=2 ISURF=2")
        id, charge, units, kind = 0, row.positive("WGT"), row.integer("IUNIT") or 2, row.integer("ISURF") or 2
        more = reader.row("CFM~unused CFL~unused CFT~unused CFP~unused")
    else:
        row = reader.row("BID M XBO YBO ZBO TBO UNIT=2 BLAST=2")
        id, charge, units, kind = (row.integer("BID"), row.positive("M"), row.integer("UNIT") or 2,
                                   row.integer("BLAST") or 2)
        more = reader.row("CFM~unused CFL~unused CFT~unused CFP~unused NIDBO DEATH NEGPHS")
        if 0 < more.number("DEATH") < deck.end_time:
            deck.ledger.refuse(f"{card.keyword}.DEATH", more.place, "a blast that ends before the run", "it acts on")
        else:
            more.skip("DEATH")
    deck.ids.claim("*LOAD_BLAST" if is_old else "*LOAD_BLAST_ENHANCED", id, row.place)
    entry: Deck = {"charge": charge, "center": row.numbers("XBO", "YBO", "ZBO")}
    if not is_old and not more.integer("NEGPHS"):
        entry["negative_phase"] = True
    if row.number("TBO"):
        entry["time"] = row.number("TBO")
    row.finish(deck.ledger)
    more.finish(deck.ledger, "the charge stays at its place")
    if kind not in BURSTS:
        deck.ledger.refuse(f"{card.keyword}.{'ISURF' if is_old else 'BLAST'}", row.place,
                           "a burst whose charge moves, or whose wave the ground reflects (percuss knows a sphere in "
                           "free air, and a hemisphere on the ground)", "it is taken as one in free air")
    if BURSTS.get(kind) != "ground":
        entry["burst"] = "air"
    if units not in BLAST_UNITS:
        deck.ledger.refuse(f"{card.keyword}.{'IUNIT' if is_old else 'UNIT'}", row.place,
                           "a blast in English units, or with factors of its own", "the blast is left out")
        return
    deck.blasts[id] = entry
    deck.model.units = BLAST_UNITS[units]
    deck.ledger.translated(card.keyword, card.place, "loads.pressure with blast, where segments name it")


def find_blast(deck: KeywordDeck, card: Card, id: int) -> Deck:
    if id not in deck.blasts:
        raise BadInput(card.place, missing(f"*LOAD_BLAST_ENHANCED {id}" if id else "*LOAD_BLAST"))
    return deck.blasts[id]


def apply_blast(deck: KeywordDeck, card: Card, blast: Deck, scale: float, faces: list[Face],
                owners: FaceOwners) -> None:
    if scale != 1:
        deck.ledger.refuse(f"{card.keyword}.scale", card.place, "a blast that is scaled", "it is taken as it is")
    for sign, members in split_by_sign(deck, card, faces, owners).items():
        if sign > 0:
            press_on(deck, card, members, {"blast": dict(blast)})
        else:
            deck.ledger.refuse(f"{card.keyword}.inside", card.place,
                               "a blast on segments whose normal points into their solid", "they are left out")


def read_blast_segments(deck: KeywordDeck, card: Card) -> None:
    reader = card.reader()
    groups: dict[tuple[int, float], list[Face]] = {}
    while reader.skip_blank():
        if card.keyword == "LOAD_BLAST_SEGMENT":
            row = reader.row("BID N1 N2 N3 N4 ALEPID SFNRB SCALEP=1")
            nodes = [row.integer(name) for name in ("N1", "N2", "N3", "N4")]
            faces: list[Face] = [tuple(nodes[:3] if nodes[3] in (0, nodes[2]) else nodes)]
        else:
            row = reader.row("BID SSID ALEPID SFNRB SCALEP=1")
            deck.used.add(("SEGMENT", row.integer("SSID")))
            faces = deck.find_set("SEGMENT", row.integer("SSID"), row.place).segments
        note_crossed(deck, card, faces, row.place)
        groups.setdefault((row.integer("BID"), row.number("SCALEP") or 1.0), []).extend(faces)
        row.finish(deck.ledger)
    owners = FaceOwners(deck.model, {node for faces in groups.values() for face in faces for node in face})
    for (id, scale), faces in groups.items():
        apply_blast(deck, card, find_blast(deck, card, id), scale, faces, owners)
