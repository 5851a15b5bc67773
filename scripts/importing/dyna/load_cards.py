"""*LOAD_...: gravity, forces on nodes, pressures."""

from ..curves import make_time_value
from ..fields import Row
from ..model import Deck
from ..shapes import FaceOwners
from .cards import Card
from .condition_cards import AXES, DIRECTIONS, nodes_of, turn_direction
from .deck import KeywordDeck

Face = tuple[int, ...]


def read_body_load(deck: KeywordDeck, card: Card) -> None:
    """*LOAD_BODY_X, _Y, _Z: the base accelerates, so bodies feel the opposite."""
    form = card.keyword.removeprefix("LOAD_BODY_")
    if form not in ("X", "Y", "Z"):
        instead = "gravity acts on all parts" if form == "PARTS" else "it is left out"
        deck.ledger.refuse(card.keyword, card.place, "this form of body load", instead)
        return
    row = card.reader().row("LCID SF=1 LCIDDR~ XC~ YC~ ZC~ CID")
    direction, sign = turn_direction(deck, row, form.lower())
    scale = (row.number("SF") or 1.0) * sign
    curve = deck.curve(row.integer("LCID"), row.place)
    row.finish(deck.ledger)
    value = make_time_value(curve, -scale, deck.end_time)
    gravity = deck.model.deck.setdefault("loads", {}).setdefault("gravity", [0.0, 0.0, 0.0])
    axis = AXES.index(direction)
    if isinstance(value, float) and isinstance(gravity[axis], float):
        gravity[axis] += value
    elif gravity[axis] == 0.0:
        gravity[axis] = value
    elif not deck.ledger.refuse(card.keyword, row.place, "a second acceleration along the same axis", "the first one holds"):
        return
    deck.ledger.translated(card.keyword, row.place, "loads.gravity, with the opposite sign")


def read_node_load(deck: KeywordDeck, card: Card) -> None:
    """*LOAD_NODE_SET and _POINT."""
    is_set = card.keyword.endswith("SET")
    reader = card.reader()
    while reader.skip_blank():
        if card.has_id:
            reader.take()
        row = reader.row("ID DOF LCID SF=1 CID M1~ M2~ M3~")
        direction = DIRECTIONS.get(row.integer("DOF"))
        if direction is None:
            deck.ledger.refuse(f"{card.keyword}.DOF", row.place, "a follower force", "it is left out")
            continue
        name = nodes_of(deck, row.integer("ID"), is_set, row.place)
        direction, sign = turn_direction(deck, row, direction)
        scale = (row.number("SF") or 1.0) * sign
        value = make_time_value(deck.curve(row.integer("LCID"), row.place), scale, deck.end_time)
        row.finish(deck.ledger)
        kind = "force" if direction in AXES else "moment"
        if name:
            deck.model.deck.setdefault("loads", {}).setdefault("nodal", []).append({"nodes": name, kind: {direction[-1]: value}})
            deck.ledger.translated(card.keyword, row.place, "loads.nodal: the whole load on each node")
        else:
            deck.ledger.ignored(card.keyword, row.place, "its nodes have no element")


def add_pressure(deck: KeywordDeck, faces: str, value: "float | Deck") -> None:
    deck.model.deck.setdefault("loads", {}).setdefault("pressure", []).append({"faces": faces, "value": value})


def read_segment_load(deck: KeywordDeck, card: Card) -> None:
    """*LOAD_SEGMENT and _SET, *LOAD_SHELL_SET and _ELEMENT: positive against the normal of the nodes."""
    if card.keyword not in ("LOAD_SEGMENT", "LOAD_SEGMENT_SET", "LOAD_SHELL_SET", "LOAD_SHELL_ELEMENT"):
        deck.ledger.refuse(card.keyword, card.place, "this form of pressure", "it is left out")
        return
    groups: dict[tuple[int, float, float], list[Face]] = {}
    shells = {id: corners for block in deck.model.blocks for id, corners in block.shells} if "SHELL" in card.keyword else {}
    reader = card.reader()
    while reader.skip_blank():
        if card.has_id:
            reader.take()
        if card.keyword == "LOAD_SEGMENT":
            row = reader.row("LCID SF=1 AT N1 N2 N3 N4")
            nodes = [row.integer(name) for name in ("N1", "N2", "N3", "N4")]
            faces = [tuple(nodes[:3] if nodes[3] in (0, nodes[2]) else nodes)]
        else:
            row = reader.row("ID LCID SF=1 AT")
            faces = list_faces(deck, card, row, shells)
        key = (row.integer("LCID"), row.number("SF") or 1.0, row.number("AT"))
        groups.setdefault(key, []).extend(faces)
    apply_pressures(deck, card, groups)


def list_faces(deck: KeywordDeck, card: Card, row: Row, shells: dict[int, Face]) -> list[Face]:
    """Faces of a set of segments or shells."""
    id = row.integer("ID")
    if card.keyword == "LOAD_SEGMENT_SET":
        deck.used.add(("SEGMENT", id))
        return deck.find_set("SEGMENT", id, row.place).segments
    wanted = deck.list_members("SHELL", id, row.place) if card.keyword == "LOAD_SHELL_SET" else [id + deck.shell_shift]
    return [shells[shell] for shell in wanted if shell in shells]


def apply_pressures(deck: KeywordDeck, card: Card, groups: dict[tuple[int, float, float], list[Face]]) -> None:
    """Pressures by curve and side: percuss pushes into a solid, whatever the order of the nodes."""
    owners = FaceOwners(deck.model, {node for faces in groups.values() for face in faces for node in face})
    is_lost = False
    for (curve_id, scale, shift), faces in groups.items():
        by_sign: dict[float, list[Face]] = {}
        for face in faces:
            sign = owners.find_sign(face)
            is_lost = is_lost or sign is None
            if sign is not None:
                by_sign.setdefault(sign, []).append(face)
        curve = deck.curve(curve_id, card.place)
        for sign, members in by_sign.items():
            name = deck.model.names.take(f"pressed_{card.keyword.lower().removeprefix('load_')}")
            deck.model.side_sets[name] = members
            add_pressure(deck, name, make_time_value(curve, scale * sign, deck.end_time, shift))
            deck.ledger.translated(card.keyword, card.place, "loads.pressure")
    if is_lost:
        deck.ledger.refuse(f"{card.keyword}.free", card.place, "segments that are not a face of any element", "they are left out")
