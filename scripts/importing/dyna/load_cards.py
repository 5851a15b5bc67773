"""*LOAD_...: gravity, forces on nodes, pressures."""

from ..curves import interpolate, is_constant, make_time_value
from ..fields import Row
from ..ledger import Place
from ..model import Deck
from .cards import Card
from .condition_cards import AXES, DIRECTIONS, nodes_of
from .deck import KeywordDeck


def read_body_load(deck: KeywordDeck, card: Card) -> None:
    """*LOAD_BODY_X, _Y, _Z: the base accelerates, so bodies feel the opposite."""
    form = card.keyword.removeprefix("LOAD_BODY_")
    if form not in ("X", "Y", "Z"):
        instead = "gravity acts on all parts" if form == "PARTS" else "it is left out"
        deck.ledger.refuse(card.keyword, card.place, "this form of body loads is not in percuss", instead)
        return
    row = card.reader().row("LCID SF=1 LCIDDR~ XC~ YC~ ZC~ CID")
    scale = row.number("SF") or 1.0
    curve = deck.curve(row.integer("LCID"), row.place)
    row.finish(deck.ledger, "the axes of space are used")
    if curve.expression or not is_constant(curve.points, deck.end_time):
        if not deck.ledger.refuse("LOAD_BODY.LCID", row.place, "gravity that changes in time", "its value at the end is used"):
            return
    value = -scale * (interpolate(curve.points, deck.end_time) if curve.points else 0.0)
    gravity = deck.model.deck.setdefault("loads", {}).setdefault("gravity", [0.0, 0.0, 0.0])
    gravity["XYZ".index(form)] += value
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
            deck.ledger.refuse(f"{card.keyword}.DOF", row.place, "a force that follows the nodes", "it is left out")
            continue
        name = nodes_of(deck, row.integer("ID"), is_set, row.place)
        value = make_time_value(deck.curve(row.integer("LCID"), row.place), row.number("SF") or 1.0, deck.end_time)
        row.finish(deck.ledger, "the axes of space are used")
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
        deck.ledger.refuse(card.keyword, card.place, "this form of pressure is not in percuss", "it is left out")
        return
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
            faces = list_faces(deck, card, row)
        apply_pressure(deck, card, row, faces)


def list_faces(deck: KeywordDeck, card: Card, row: Row) -> list[tuple[int, ...]]:
    """Faces of a set of segments or shells."""
    id = row.integer("ID")
    if card.keyword == "LOAD_SEGMENT_SET":
        deck.used.add(("SEGMENT", id))
        return deck.find_set("SEGMENT", id, row.place).segments
    wanted = set(deck.list_members("SHELL", id, row.place)) if card.keyword == "LOAD_SHELL_SET" else {id + deck.shell_shift}
    return [corners for block in deck.model.blocks for shell, corners in block.shells if shell in wanted]


def apply_pressure(deck: KeywordDeck, card: Card, row: Row, faces: list[tuple[int, ...]]) -> None:
    """Pressures by side: percuss pushes into a solid, whatever the order of the nodes."""
    owners = deck.find_owners()
    groups: dict[float, list[tuple[int, ...]]] = {}
    lost: Place | None = None
    for face in faces:
        sign = owners.find_sign(face)
        if sign is None:
            lost = row.place
        else:
            groups.setdefault(sign, []).append(face)
    if lost:
        deck.ledger.refuse(f"{card.keyword}.free", lost, "segments that are no face of an element", "they are left out")
    curve, scale, shift = deck.curve(row.integer("LCID"), row.place), row.number("SF") or 1.0, row.number("AT")
    for sign, members in groups.items():
        name = deck.model.names.take(f"pressed_{card.keyword.lower().removeprefix('load_')}")
        deck.model.side_sets[name] = members
        add_pressure(deck, name, make_time_value(curve, scale * sign, deck.end_time, shift))
    if groups:
        deck.ledger.translated(card.keyword, row.place, "loads.pressure")
