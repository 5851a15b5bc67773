"""*SET_...: nodes, parts, segments, shells, solids, beams; and *DEFINE_ boxes, systems and vectors."""

from ..fields import Row, clip, parse_integer
from ..ledger import BadInput, Ledger
from ..model import Vector
from ..shapes import cross, make_vector, normalise, subtract
from .cards import Card, Lines, read_ids
from .deck import SPACE, Box, KeywordDeck, SetCard

KINDS = ("NODE", "PART", "SEGMENT", "SHELL", "SOLID", "BEAM", "DISCRETE", "TSHELL", "BOX")

# names of fields with their ids
FIELDS = {"NODE": "NID", "PART": "PID", "SHELL": "EID", "SOLID": "EID", "BEAM": "EID", "SEGMENT": "NID"}
MOST_STEPS = 1_000_000  # ids of a line


def read_set(deck: KeywordDeck, card: Card) -> None:
    """SET_KIND with _LIST, _GENERATE, _GENERAL, _ADD, _COLUMN, _COLLECT and a title."""
    kind, *options = card.keyword.removeprefix("SET_").split("_")
    form = [word for word in options if word not in ("LIST", "COLLECT")]
    if kind not in KINDS or kind in ("DISCRETE", "TSHELL", "BOX"):
        deck.ledger.ignored(card.keyword, card.place,
                            "a set of what percuss does not have; a card that uses it is refused")
        return
    reader = card.reader()
    title = reader.text() if card.has_title else ""
    row = reader.row("SID DA1~attribute DA2~attribute DA3~attribute DA4~attribute SOLVER~solver ITS~solver")
    found = SetCard(kind, row.integer("SID"), title, row.place)
    if ("COLLECT" in options) and (kind, found.id) in deck.sets:
        found = deck.sets[kind, found.id]
    else:
        deck.ids.claim(f"*SET_{kind}", found.id, row.place)
    deck.sets[kind, found.id] = found
    read_members(deck, card, reader, found, form)
    deck.ledger.translated(card.keyword, card.place, "a set of the mesh, where something uses it")


def read_members(deck: KeywordDeck, card: Card, reader: Lines, found: SetCard, form: list[str]) -> None:
    """The lines of a set by its form."""
    if found.kind == "SEGMENT" and not form:
        found.segments += read_segments(reader)
    elif not form:
        found.ids += read_ids(reader, field=FIELDS[found.kind])
    elif form == ["GENERATE"]:
        pairs = read_ids(reader, field=FIELDS[found.kind])
        if len(pairs) % 2:
            raise BadInput(card.place, f"*{card.keyword} has a first id without a last: add it")
        found.ranges += list(zip(pairs[::2], pairs[1::2]))
    elif form == ["GENERATE", "INCREMENT"]:
        read_steps(card, reader, found)
    elif form == ["ADD"]:
        found.sets += read_ids(reader, field="SID")
    elif form == ["COLUMN"]:
        while reader.skip_blank():
            found.ids.append(reader.row(f"{FIELDS[found.kind]} A1~attribute A2~attribute A3~attribute A4~attribute")
                             .integer(FIELDS[found.kind]))
    elif form == ["GENERAL"]:
        read_general(deck.ledger, card, reader, found)
    else:
        raise BadInput(card.place,
                       f"*{card.keyword} is not read (LIST, GENERATE, GENERATE_INCREMENT, GENERAL, ADD and COLUMN are)")


def read_steps(card: Card, reader: Lines, found: SetCard) -> None:
    """First id, last id and the step from one to the next."""
    while reader.skip_blank():
        row = reader.row("BBEG BEND INCR=1")
        first, last, step = row.integer("BBEG"), row.integer("BEND"), row.integer("INCR") or 1
        if step < 1 or (last - first) // step >= MOST_STEPS:
            row.fail("INCR", f"a positive step, and at most {MOST_STEPS} ids, are expected")
        shift = card.change.shift_of(card.keyword, FIELDS[found.kind])
        found.ids += range(first + shift, last + 1 + shift, step)


def read_segments(reader: Lines) -> list[tuple[int, ...]]:
    segments = []
    while reader.skip_blank():
        row = reader.row("N1 N2 N3 N4 A1~attribute A2~attribute A3~attribute A4~attribute")
        nodes = [row.integer(name) for name in ("N1", "N2", "N3", "N4")]
        segments.append(tuple(nodes[:3] if nodes[3] in (0, nodes[2]) else nodes))
    return segments


def read_general(ledger: Ledger, card: Card, reader: Lines, found: SetCard) -> None:
    """OPTION E1-E7, one after the other."""
    own = {"NODE": "NODE", "PART": "PART", "SEGMENT": "SEG"}.get(found.kind, "ELEM")
    known = {"ALL", own, "PART", *(("SHELL",) if found.kind == "SEGMENT" else ("BOX",))}
    while reader.skip_blank():
        line = reader.take()
        texts = card.split(line, (10,) * 8)
        values, option = [parse_integer(text) for text in texts[1:8] if text], texts[0].upper()
        if option not in known and option.removeprefix("D") not in known - {"ALL"}:
            ledger.refuse(f"{card.keyword}.{clip(option)}", card.at(line[0]),
                          f"the option {clip(option)}", "its line is left out")
        elif None in values:
            raise BadInput(card.at(line[0]), f"an id of *{card.keyword} is not a whole number: correct it")
        elif found.kind == "SEGMENT" and option == "SEG":
            shift = card.change.shift_of(card.keyword, "NID")
            found.segments.append(tuple(dict.fromkeys(v + shift for v in values[:4] if v)))
        else:
            kind = option.removeprefix("D")
            shift = card.change.shift_of(card.keyword, {"PART": "PID", "BOX": "BOXID", "SHELL": "EID",
                                                        "SEG": "NID"}.get(kind, FIELDS[found.kind]))
            found.options.append((option, [v + shift for v in values if v]))


def resolve_segments(deck: KeywordDeck) -> None:
    """Segments that a set names by parts and shells, once all elements are known."""
    for (kind, _), found in deck.sets.items():
        for option, values in found.options if kind == "SEGMENT" else ():
            if option == "DSEG":
                more = [tuple(values[:4])]
            elif option.endswith("SHELL"):
                more = [shell.corners for part in deck.elements.values() for shell in part.shells if shell.id in values]
            else:
                more = [face for part in (values if option != "ALL" else deck.elements)
                        for face in deck.faces_of_part(part)]
            gone = {frozenset(face) for face in more}
            if option.startswith("D"):
                found.segments = [face for face in found.segments if frozenset(face) not in gone]
            else:
                found.segments += more
        if kind == "SEGMENT":
            found.options = []


def read_box(deck: KeywordDeck, card: Card) -> None:
    """*DEFINE_BOX, and _LOCAL with the axes and the origin of its limits."""
    reader = card.reader()
    while reader.next_card():
        if card.has_title:
            reader.take()
        row = reader.row("BOXID XMN XMX YMN YMX ZMN ZMX")
        limits, axes, origin = row.numbers("XMN", "XMX", "YMN", "YMX", "ZMN", "ZMX"), SPACE, (0.0, 0.0, 0.0)
        if card.keyword.endswith("LOCAL"):
            local, center = reader.row("XX YX ZX XV YV ZV"), reader.row("CX CY CZ")
            on_x, in_plane = (make_vector(local.numbers(*names)) for names in (("XX", "YX", "ZX"), ("XV", "YV", "ZV")))
            axes, origin = make_axes(local, on_x, in_plane), make_vector(center.numbers("CX", "CY", "CZ"))
        deck.ids.claim("*DEFINE_BOX", row.integer("BOXID"), row.place)
        deck.boxes[row.integer("BOXID")] = Box(limits, axes, origin)
        deck.ledger.translated(card.keyword, card.place, "limits what uses it")


def read_system(deck: KeywordDeck, card: Card) -> None:
    """*DEFINE_COORDINATE_SYSTEM, _NODES and _VECTOR: three axes that stay as they are at the start."""
    reader = card.reader()
    while reader.next_card(of_lines=True):
        if card.has_title:
            reader.take()
        read_axes(deck, card, reader)


def read_axes(deck: KeywordDeck, card: Card, reader: Lines) -> None:
    """One of them."""
    form = card.keyword.removeprefix("DEFINE_COORDINATE_")
    if form == "SYSTEM":
        row, more = read_system_id(deck, reader, "CID XO YO ZO XL YL ZL CIDL"), reader.row("XP YP ZP")
        origin = tuple(row.numbers("XO", "YO", "ZO"))
        if row.integer("CIDL"):
            deck.ledger.ignored(card.keyword, card.place, "in another system; a card that uses it is refused")
            return
        x = subtract(tuple(row.numbers("XL", "YL", "ZL")), origin)  # type: ignore[arg-type]
        xy = subtract(tuple(more.numbers("XP", "YP", "ZP")), origin)  # type: ignore[arg-type]
    elif form == "VECTOR":
        row = read_system_id(deck, reader, "CID XX YX ZX XV YV ZV NID")
        if row.integer("NID"):
            deck.ledger.ignored(card.keyword, card.place, "its axes move with a node; a card that uses it is refused")
            return
        x, xy = tuple(row.numbers("XX", "YX", "ZX")), tuple(row.numbers("XV", "YV", "ZV"))  # type: ignore[assignment]
    elif form == "NODES":
        row = read_system_id(deck, reader, "CID N1 N2 N3 FLAG DIR")
        points = [deck.nodes.get(row.integer(name)) for name in ("N1", "N2", "N3")]
        is_read = None not in points and row.text("DIR").upper() in ("", "X")
        if is_read and row.integer("FLAG"):
            x, xy = subtract(points[1], points[0]), subtract(points[2], points[0])  # type: ignore[arg-type]
            deck.moving_systems[row.integer("CID")] = make_axes(row, x, xy)
        if not is_read or row.integer("FLAG"):
            deck.ledger.ignored(card.keyword, card.place, "not of fixed axes; a card that uses it is refused")
            return
        x, xy = subtract(points[1], points[0]), subtract(points[2], points[0])  # type: ignore[arg-type]
    else:
        deck.ledger.ignored(card.keyword, card.place, "not read; a card that uses it is refused")
        while reader:
            reader.take()
        return
    deck.systems[row.integer("CID")] = make_axes(row, x, xy)
    deck.ledger.translated(card.keyword, card.place, "axes of what uses it")


def read_system_id(deck: KeywordDeck, reader: Lines, layout: str) -> Row:
    """The first line of a system, whose id no other system has."""
    row = reader.row(layout)
    deck.ids.claim("*DEFINE_COORDINATE", row.integer("CID"), row.place)
    return row


def make_axes(row: Row, x: Vector, xy: Vector) -> tuple[Vector, Vector, Vector]:
    """Axes by x and a vector in the plane of x and y."""
    z = normalise(cross(x, xy))
    if z == (0.0, 0.0, 0.0):
        raise BadInput(row.place,
                       f"the two vectors of *{row.card} are along one line or 0 (they give no axes): correct them")
    return normalise(x), normalise(cross(z, x)), z


def read_vector(deck: KeywordDeck, card: Card) -> None:
    reader = card.reader()
    while reader.next_card():
        if card.has_title:
            reader.take()
        row = reader.row("VID XT YT ZT XH YH ZH CID")
        deck.ids.claim("*DEFINE_VECTOR", row.integer("VID"), row.place)
        tail, head = tuple(row.numbers("XT", "YT", "ZT")), tuple(row.numbers("XH", "YH", "ZH"))
        if row.integer("CID"):
            deck.ledger.ignored(card.keyword, card.place, "in a system; a card that uses it is refused")
            continue
        deck.vectors[row.integer("VID")] = normalise(subtract(head, tail))  # type: ignore[arg-type]
        deck.ledger.translated(card.keyword, card.place, "direction of what uses it")
