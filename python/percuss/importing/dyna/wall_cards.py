"""*RIGIDWALL_...: planes, cylinders and spheres."""

from ..curves import Curve, differentiate, make_time_value, order_points
from ..fields import Row
from ..ledger import BadInput, missing
from ..model import Deck
from ..shapes import dot, normalise, subtract
from .cards import Card, Lines
from .deck import KeywordDeck
from .windows import Window, switch

OPTIONS = ("ORTHO", "FINITE", "MOVING", "FORCES", "DISPLAY")
STICK = 100.0  # a coefficient of friction that no node slips under


def read_wall(deck: KeywordDeck, card: Card) -> None:
    if card.keyword.startswith("RIGIDWALL_GEOMETRIC"):
        read_geometric_wall(deck, card)
    else:
        read_plane_wall(deck, card)


def read_plane_wall(deck: KeywordDeck, card: Card) -> None:
    """*RIGIDWALL_PLANAR with _ID, _FINITE, _MOVING, _FORCES, and others that are refused."""
    words = card.keyword.removeprefix("RIGIDWALL_PLANAR").split("_")[1:]
    if not card.keyword.startswith("RIGIDWALL_PLANAR") or set(words) - set(OPTIONS):
        deck.ledger.refuse(card.keyword, card.place, "a rigid wall that is not a plane", "it is left out")
        return
    reader = card.reader()
    while reader.next_card(of_lines=True):
        name = read_name(deck, card, reader)
        row = reader.row("NSID NSIDEX BOXID OFFSET BIRTH DEATH=1e20 RWKSF~penalty")
        plane = reader.row("XT YT ZT XH YH ZH FRIC WVEL")
        wall = make_wall(deck, plane, name)
        read_wall_options(deck, reader, words, wall)
        if choose_nodes(deck, row, wall, row.number("OFFSET")):
            deck.model.add("walls", wall)
            deck.ledger.translated(card.keyword, row.place, "walls")


def read_name(deck: KeywordDeck, card: Card, reader: Lines) -> str:
    name = ""
    if card.has_id:
        head = reader.row("ID~label TITLE~label", (10, 70))
        name, id = head.text("TITLE"), head.integer("ID")
        name = name or (f"wall_{id}" if id else "")
    return name or f"wall_{len(deck.model.deck.get('walls', [])) + 1}"


def read_geometric_wall(deck: KeywordDeck, card: Card) -> None:
    """*RIGIDWALL_GEOMETRIC_FLAT, _CYLINDER and _SPHERE with _ID, _MOTION and _DISPLAY."""
    shape, *options = card.keyword.removeprefix("RIGIDWALL_GEOMETRIC").split("_")[1:] or [""]
    if shape not in ("FLAT", "CYLINDER", "SPHERE") or set(options) - {"MOTION", "DISPLAY"}:
        deck.ledger.refuse(card.keyword, card.place,
                           "a rigid wall that is a prism, hollow, or deforms", "it is left out")
        return
    reader = card.reader()
    while reader.next_card(of_lines=True):
        name = read_name(deck, card, reader)
        row = reader.row("NSID NSIDEX BOXID BIRTH DEATH=1e20")
        wall = make_wall(deck, reader.row("XT YT ZT XH YH ZH FRIC"), name, shape)
        if shape == "FLAT":
            end_wall(deck, reader.row("XHEV YHEV ZHEV LENL LENM"), wall, card.keyword)
        else:
            round_wall(deck, reader, wall, shape)
        moves = "MOTION" not in options or read_wall_motion(deck, card, reader, wall)
        if "DISPLAY" in options:
            reader.row("PID~output RO~output E~output PR~output")
        if moves and choose_nodes(deck, row, wall, 0.0):
            deck.model.add("walls", wall)
            deck.ledger.translated(card.keyword, row.place, "walls")


def round_wall(deck: KeywordDeck, reader: Lines, wall: Deck, shape: str) -> None:
    """A cylinder begins at the tail; without a length it goes on both ways."""
    axis = wall.pop("normal")
    if shape == "SPHERE":
        row = reader.row("RADSPH")
        wall["sphere"] = {"radius": row.positive("RADSPH")}
    else:
        row = reader.row("RADCYL LENCYL NSEGS")
        wall["cylinder"] = {"axis": axis, "radius": row.positive("RADCYL")}
        if row.number("LENCYL") > 0:
            wall["cylinder"]["length"] = row.number("LENCYL")
        for _ in range(min(row.integer("NSEGS"), 1000)):
            reader.row("VL~output HEIGHT~output")
        if row.integer("NSEGS") > 0:
            deck.ledger.ignored("RIGIDWALL_GEOMETRIC_CYLINDER.NSEGS", row.place,
                                "output; percuss writes the force of the wall")
    row.finish(deck.ledger)


def read_wall_motion(deck: KeywordDeck, card: Card, reader: Lines, wall: Deck) -> bool:
    """Speed or way over time along a direction; False if it has none."""
    row = reader.row("LCID OPT VX VY VZ")
    way = normalise(tuple(row.numbers("VX", "VY", "VZ")))  # type: ignore[arg-type]
    kind = row.integer("OPT")
    curve = deck.curve(row.integer("LCID"), row.place, "time", "length" if kind else "speed")
    row.finish(deck.ledger)
    if way == (0.0, 0.0, 0.0) or kind not in (0, 1) or (kind == 1 and len(curve.points) < 2):
        deck.ledger.refuse(f"{card.keyword}.MOTION", row.place,
                           "a motion without a direction or a table", "the wall is left out")
        return False
    if kind == 1:
        curve = Curve(curve.place, differentiate(order_points(curve.points)))
        deck.ledger.approximated(f"{card.keyword}.OPT", row.place, "the slope of the way as a speed")
    scale = 1.0
    if "normal" in wall:
        scale = dot(way, tuple(wall["normal"]))  # type: ignore[arg-type]
        if abs(abs(scale) - 1) > 1e-9:
            deck.ledger.refuse(f"{card.keyword}.VX", row.place, "a plane that moves along itself too",
                               "its way along the normal alone")
    else:
        wall["direction"] = list(way)
    wall["speed"] = make_time_value(curve, scale, deck.end_time)
    return True


def make_wall(deck: KeywordDeck, plane: Row, name: str, shape: str = "FLAT") -> Deck:
    point = tuple(plane.numbers("XT", "YT", "ZT"))
    normal = normalise(subtract(tuple(plane.numbers("XH", "YH", "ZH")), point))  # type: ignore[arg-type]
    if normal == (0.0, 0.0, 0.0) and shape != "SPHERE":
        plane.fail("XH", "the head must not be the tail")
    friction = plane.number("FRIC")
    wall: Deck = {"name": deck.model.names.take(name, "wall"), "point": list(point), "normal": list(normal)}
    if friction >= 2:
        deck.ledger.refuse(
            "RIGIDWALL_PLANAR.FRIC", plane.place, "nodes that stick to the wall",
            "friction holds them, and they may separate"
        )
    if friction >= 1:
        deck.ledger.approximated("RIGIDWALL_PLANAR.FRIC", plane.place, f"sticking is a friction of {STICK:g}")
        friction = STICK
    if friction:
        wall["friction"] = friction
    plane.finish(deck.ledger)
    return wall


def read_wall_options(deck: KeywordDeck, reader: Lines, words: list[str], wall: Deck) -> None:
    """Further lines, in the order of the manual."""
    for option in (word for word in OPTIONS if word in words):
        if option == "DISPLAY":
            continue
        if option == "FINITE":
            end_wall(deck, reader.row("XHEV YHEV ZHEV LENL LENM"), wall)
            continue
        if option == "MOVING":
            move_wall(deck, reader.row("MASS V0"), wall)
            continue
        if option == "ORTHO":
            first = reader.row("SFRICA SFRICB DFRICA DFRICB DECAYA DECAYB")
            reader.row("NODE1 NODE2 D1 D2 D3")
            deck.ledger.refuse(
                "RIGIDWALL_PLANAR_ORTHO", first.place, "friction that depends on the direction",
                "FRIC acts in all directions"
            )
        else:
            first = reader.row("SOFT~penalty SSID~output N1~output N2~output N3~output N4~output")
            deck.ledger.ignored("RIGIDWALL_PLANAR_FORCES", first.place, "output; percuss writes the force of each wall")


def end_wall(deck: KeywordDeck, row: Row, wall: Deck, name: str = "RIGIDWALL_PLANAR_FINITE") -> None:
    """A rectangle from the tail on: LENL towards the head of the edge, LENM across."""
    edge = subtract(tuple(row.numbers("XHEV", "YHEV", "ZHEV")), tuple(wall["point"]))  # type: ignore[arg-type]
    sizes, normal = row.numbers("LENL", "LENM"), tuple(wall["normal"])
    out = dot(edge, normal)  # type: ignore[arg-type]
    along = normalise(tuple(e - out * n for e, n in zip(edge, normal)))  # type: ignore[arg-type]
    row.finish(deck.ledger)
    if not any(sizes):
        deck.ledger.approximated(name, row.place, "without lengths the plane goes on without end")
    elif min(sizes) <= 0 or along == (0.0, 0.0, 0.0):
        deck.ledger.refuse(name, row.place, "a wall of one length", "the plane is infinite")
    else:
        wall["rectangle"] = {"along": list(along), "size": sizes}


def move_wall(deck: KeywordDeck, row: Row, wall: Deck) -> None:
    """A mass that bodies push along the normal."""
    mass, speed = row.numbers("MASS", "V0")
    row.finish(deck.ledger)
    if deck.rigid or mass <= 0:
        why = "a wall with a mass beside rigid parts" if mass > 0 else "a moving wall without mass"
        deck.ledger.refuse("RIGIDWALL_PLANAR_MOVING", row.place, why, "it keeps its speed")
        if speed:
            wall["speed"] = speed
        return
    wall["mass"] = mass
    if speed:
        wall["start_speed"] = speed


def choose_nodes(deck: KeywordDeck, row: Row, wall: Deck, offset: float) -> bool:
    """The nodes that the wall stops; False if none has an element."""
    id, exempt, box = row.integer("NSID"), row.integer("NSIDEX"), row.integer("BOXID")
    birth, death = row.numbers("BIRTH", "DEATH")
    if birth > 0 and wall.keys() & {"speed", "mass"}:
        deck.ledger.refuse("RIGIDWALL_PLANAR.BIRTH", row.place, "a wall that moves with a birth time",
                           "it moves from time 0 on")
    wall |= switch(deck, Window(max(birth, 0.0), death if 0 < death < deck.end_time else None))
    row.finish(deck.ledger)
    if not (id or exempt or box or offset):
        return True
    if not id and not exempt and not box and is_everything_near(deck, wall, offset, row):
        return True
    members = deck.list_members("NODE", id, row.place) if id else sorted(deck.used_nodes())
    if exempt:
        gone = set(deck.list_members("NODE", exempt, row.place))
        members = [node for node in members if node not in gone]
    if box:
        inside = set(deck.nodes_of_box(box, row.place))
        members = [node for node in members if node in inside]
    if offset > 0:
        members = [node for node in members if node_height(deck, wall, node, row) <= offset]
    name = deck.make_node_set(f"{wall['name']}_nodes", members, row.place)
    wall["nodes"] = name
    if not name:
        deck.ledger.ignored("RIGIDWALL_PLANAR", row.place, "it stops only nodes without elements, which have no mass")
    return bool(name)


def node_height(deck: KeywordDeck, wall: Deck, node: int, row: Row) -> float:
    if node not in deck.nodes:
        raise BadInput(row.place, missing(f"node {node}"))
    return dot(subtract(deck.nodes[node], tuple(wall["point"])), tuple(wall["normal"]))  # type: ignore[arg-type]


def is_everything_near(deck: KeywordDeck, wall: Deck, offset: float, row: Row) -> bool:
    return offset <= 0 or all(node_height(deck, wall, node, row) <= offset for node in deck.used_nodes())
