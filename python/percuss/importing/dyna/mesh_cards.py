"""*NODE and *ELEMENT_...: nodes and elements, what they cannot be is refused."""

from ..fields import MOST_ID, Row, clip, parse_integer, parse_real, shift_hint
from ..ledger import BadInput, Place
from ..model import Vector
from ..shapes import make_vector
from ..solids import collapse
from .cards import Card, Lines
from .deck import Element, Elements, KeywordDeck
from .transforms import UNCHANGED, FileChange, apply

NODE_WIDTHS = (8, 16, 16, 16, 8, 8)
NODE_FIELDS, ELEMENT_FIELDS = ("NID", "X", "Y", "Z", "TC", "RC"), ("EID", "PID", *(f"N{i}" for i in range(1, 9)))
EIGHTS = (8,) * 10
SIXTEENS = (16,) * 5
# Seat belts and the like have no law in percuss: what is left of the model without them.
OTHERS = ("SEATBELT", "SPH", "TSHELL_", "PLOTEL", "INERTIA", "GENERALIZED")


def to_id(card: Card, number: int, text: str, what: str, may_be_blank: bool = False) -> int:
    """A positive id of a field; 0 where it may be blank and is."""
    if may_be_blank and text == "":
        return 0
    value = parse_integer(text)
    if value is None or not (0 if may_be_blank else 1) <= value <= MOST_ID:
        raise BadInput(card.at(number), f"{what} of *{card.keyword} is '{clip(text)}' "
                                        f"(an id from 1 to 10^15 is expected{shift_hint(text)})")
    return (value + card.change.shift_of(card.keyword, "NID" if what == "node" else what)
            if value and card.change is not UNCHANGED else value)


def to_real(card: Card, number: int, text: str, what: str) -> float:
    value = parse_real(text) if text else 0.0
    if value is None:
        raise BadInput(card.at(number),
                       f"{what} of *{card.keyword} is '{clip(text)}' (a number is expected{shift_hint(text)})")
    return value


def read_nodes(deck: KeywordDeck, card: Card) -> None:
    """NID X Y Z TC RC."""
    change = card.change
    for line in card.lines:
        if not line[1].strip():
            continue
        texts = card.split(line, NODE_WIDTHS, NODE_FIELDS) + [""] * 6
        id = to_id(card, line[0], texts[0], "NID")
        x = tuple(to_real(card, line[0], texts[i], "XYZ"[i - 1]) for i in (1, 2, 3))
        if change is not UNCHANGED:
            x = change.move(x)  # type: ignore[arg-type]
        if deck.nodes.get(id, x) != x:
            raise BadInput(card.at(line[0]), f"node {id} is defined twice, at different places "
                                             f"(the first is at {deck.node_lines.find(id)}): renumber or remove one")
        deck.nodes[id] = x  # type: ignore[assignment]
        deck.node_lines.note(card.at(line[0]), id)
        code = int(to_real(card, line[0], texts[4], "TC")), int(to_real(card, line[0], texts[5], "RC"))
        if code != (0, 0):
            if not all(0 <= c <= 7 for c in code):
                raise BadInput(card.at(line[0]), f"TC and RC of node {id} are {code} (0 to 7 are expected)")
            deck.fixed_nodes.setdefault(code, []).append(id)
            deck.fixed_place = deck.fixed_place or card.at(line[0])
    deck.ledger.translated("NODE", card.place, "nodes of the mesh, ids kept; TC and RC as fixed directions")


def read_node_transform(deck: KeywordDeck, card: Card) -> None:
    """TRSID NSID IMMED: nodes of a set that are moved, at once or when all are read."""
    reader = card.reader()
    while reader.skip_blank():
        row = reader.row("TRSID NSID IMMED")
        deck.node_transforms.append(row)
        if row.integer("IMMED"):
            move_nodes(deck, deck.node_transforms.pop())


def apply_node_transforms(deck: KeywordDeck) -> None:
    for row in deck.node_transforms:
        move_nodes(deck, row)


def move_nodes(deck: KeywordDeck, row: Row) -> None:
    id = row.integer("TRSID")
    if id not in deck.transformations:
        row.fail("TRSID", "there is no such *DEFINE_TRANSFORMATION")
    transform = deck.transformations[id].find(dict(deck.nodes), deck.ledger)
    if FileChange(transform=transform).mirrors():
        deck.ledger.refuse("NODE_TRANSFORM.MIRROR", row.place,
                           "nodes that are mirrored, with elements that then are inside out", "they stay")
        return
    for node in deck.list_members("NODE", row.integer("NSID"), row.place):
        if node in deck.nodes:
            deck.nodes[node] = apply(transform, deck.nodes[node])
    deck.ledger.translated(row.card, row.place, "nodes are moved")


def elements_of(deck: KeywordDeck, part: int, place: Place) -> Elements:
    if part not in deck.elements:
        deck.elements[part] = Elements(place)
    return deck.elements[part]


def read_solids(deck: KeywordDeck, card: Card) -> None:
    """EID PID N1-N8 on one line, or EID PID and N1-N10 on two. _ORTHO: two more lines with the axes of the material."""
    reader = card.reader()
    while reader.skip_blank():
        line = reader.take()
        texts = card.split(line, EIGHTS, ELEMENT_FIELDS) + [""] * 10
        if parse_integer(texts[2] or "0") == 0:
            texts = texts[:2] + card.split(reader.take(), EIGHTS) + [""] * 10
        id, part = to_id(card, line[0], texts[0], "EID"), to_id(card, line[0], texts[1], "PID")
        corners = [to_id(card, line[0], text, "node", True) for text in texts[2:12]]
        corners = [c for c in corners if c]
        if card.keyword == "ELEMENT_SOLID_ORTHO":
            deck.solid_axes[id] = read_direction(card, reader, "A"), read_direction(card, reader, "D")
        deck.element_lines["solids"].note(card.at(line[0]), id)
        add_solid(deck, card.at(line[0]), part, id, turn_over(corners) if card.change.mirrors() else corners)
    deck.ledger.translated("ELEMENT_SOLID", card.place, "elements of the mesh, ids kept")


def read_thick_shells(deck: KeywordDeck, card: Card) -> None:
    """EID PID N1-N8: the first four nodes are the bottom, the others the top.
    Six nodes make a wedge, which is no thick shell."""
    for line in card.lines:
        if not line[1].strip():
            continue
        texts = card.split(line, EIGHTS, ELEMENT_FIELDS) + [""] * 10
        id, part = to_id(card, line[0], texts[0], "EID"), to_id(card, line[0], texts[1], "PID")
        corners = [to_id(card, line[0], text, "node") for text in texts[2:10]]
        place = card.at(line[0])
        deck.element_lines["thick shells"].note(place, id)
        found = elements_of(deck, part, place)
        if len(set(corners)) == 8:
            found.solids.append((id, tuple(turn_over(corners) if card.change.mirrors() else corners)))
            found.is_thick = True
            continue
        found.others.add("ELEMENT_TSHELL.degenerate")
        text = f"a thick shell with {len(set(corners))} different nodes"
        deck.ledger.refuse("ELEMENT_TSHELL.degenerate", place, text,
                           "these elements are left out, and the body has holes")
    deck.ledger.translated("ELEMENT_TSHELL", card.place, "hexahedra of the mesh, ids kept; they are thick shells")


def read_direction(card: Card, reader: Lines, name: str) -> Vector:
    line = reader.take()
    texts = card.split(line, (16, 16, 16)) + [""] * 3
    return make_vector(to_real(card, line[0], text, f"{name}{i}") for i, text in enumerate(texts[:3], 1))


def turn_over(corners: list[int]) -> list[int]:
    """The corners of a solid whose nodes are mirrored, in an order that keeps its volume positive."""
    if len(corners) == 10:
        return [corners[i] for i in (0, 2, 1, 3, 6, 5, 4, 7, 9, 8)]
    if len(corners) == 8:
        return [corners[i] for i in (0, 3, 2, 1, 4, 7, 6, 5)]
    return [corners[i] for i in (0, 2, 1, *range(3, len(corners)))]


def add_solid(deck: KeywordDeck, place: Place, part: int, id: int, corners: list[int]) -> None:
    """A hexahedron, or what is left of one with collapsed edges; or a refusal by what it is."""
    different = len(set(corners))
    found = elements_of(deck, part, place)
    if len(corners) == 8 and different == 8:
        found.solids.append((id, tuple(corners)))
        return
    if len(corners) == 10 and different == 10:
        found.solids.append((id, tuple(corners)))
        deck.ledger.approximated("ELEMENT_SOLID.ten_nodes", place, "tetrahedra of ten nodes are cut into eight of four")
        return
    first = list(dict.fromkeys(corners))
    if different == 4 and corners in (first, first + first[3:] * 4, [*first[:3], first[2], *first[3:] * 4]):
        found.solids.append((id, tuple(first)))
        return
    solid = collapse(corners) if len(corners) == 8 else None
    if solid is not None:
        found.solids.append((id, solid))
        return
    shape = "quadratic" if different > 8 else "degenerate"
    found.others.add(f"ELEMENT_SOLID.{shape}")
    deck.ledger.refuse(
        f"ELEMENT_SOLID.{shape}",
        place,
        f"a {shape} solid ({different} nodes)",
        "these elements are left out, and the body has holes",
    )


def read_shells(deck: KeywordDeck, card: Card) -> None:
    """EID PID N1-N4, with more lines by the options THICKNESS, BETA, MCID and OFFSET."""
    options = set(card.keyword.removeprefix("ELEMENT_SHELL").split("_")) - {""}
    if options - {"THICKNESS", "BETA", "MCID", "OFFSET"}:
        deck.ledger.refuse(card.keyword, card.place, "this form of shell elements", "these elements are left out")
        return
    reader = card.reader()
    while reader.skip_blank():
        line = reader.take()
        texts = card.split(line, EIGHTS, ELEMENT_FIELDS) + [""] * 10
        id, part = to_id(card, line[0], texts[0], "EID"), to_id(card, line[0], texts[1], "PID")
        deck.element_lines["shells"].note(card.at(line[0]), id)
        nodes = [to_id(card, line[0], text, "node", True) for text in texts[2:10]]
        thickness, turn = read_shell_options(deck, card, reader, options, any(nodes[4:]))
        if any(nodes[4:]):
            deck.ledger.refuse(
                "ELEMENT_SHELL.mid_nodes", card.at(line[0]), "quadratic shells", "the corners alone are used"
            )
        corners = nodes[:3] if nodes[3] in (0, nodes[2]) else nodes[:4]
        if 0 in corners or len(set(corners)) < len(corners):
            raise BadInput(card.at(line[0]), f"shell {id} has fewer than three different corners: correct or remove it")
        elements_of(deck, part, card.at(line[0])).shells.append(
            Element(id, tuple(corners), thickness, *((0.0, int(turn)) if "MCID" in options else (turn, 0))))
    deck.ledger.translated(card.keyword, card.place, "elements of the mesh, ids kept")


def read_shell_options(deck: KeywordDeck, card: Card, reader: Lines, options: set[str],
                       has_mid_nodes: bool) -> tuple[float | None, float]:
    """Thickness of a shell from its further lines: the mean of its corners.
    And the angle of its axes, or the system of MCID."""
    thickness, turn = None, 0.0
    if options & {"THICKNESS", "BETA", "MCID"}:
        row = reader.row("T1 T2 T3 T4 BETA", SIXTEENS)
        values = [value for value in (row.not_negative(f"T{i}") for i in range(1, 5)) if value]
        turn = row.number("BETA")
        if values:
            thickness = sum(values) / len(values) if len(set(values)) > 1 else values[0]
        if len(set(values)) > 1:
            deck.ledger.approximated("ELEMENT_SHELL.THICKNESS", row.place,
                                     "shells have the mean thickness of their corners")
        if has_mid_nodes:
            reader.take()
    if "OFFSET" in options and reader.row("OFFSET", (16,)).number("OFFSET") != 0:
        deck.ledger.refuse("ELEMENT_SHELL.OFFSET", card.place, "shells with offsets of their own",
                           "the mesh is the middle surface")
    return thickness, turn


def read_other_elements(deck: KeywordDeck, card: Card) -> None:
    """Elements that percuss does not have."""
    kind = next((word for word in OTHERS if card.keyword.startswith("ELEMENT_" + word)), "")
    if kind == "PLOTEL":
        deck.ledger.ignored(card.keyword, card.place, "lines for pictures")
        return
    for line in card.lines:
        texts = card.split(line, EIGHTS, ELEMENT_FIELDS)
        part = parse_integer(texts[1]) if len(texts) > 1 and texts[1] else None
        if part and part > 0:
            elements_of(deck, part, card.at(line[0])).others.add(card.keyword)
    deck.ledger.refuse(card.keyword, card.place, "this kind of element", "these elements are left out")
