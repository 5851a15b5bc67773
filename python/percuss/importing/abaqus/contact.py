"""*TIE, *CONTACT PAIR and surfaces in contact."""

from typing import Any

from ..fields import clip, parse_real
from ..ledger import BadInput, Place
from ..model import Deck
from .cohesive import tie_layer
from .deck import AbaqusDeck
from .glue import refuse_glue
from .lines import Block, Line
from .surfaces import is_profile

INSTEAD = "it is left out"


def read_tie(deck: AbaqusDeck, block: Block) -> None:
    """slave, master."""
    for line in block.lines:
        place = block.at(line[0])
        slave, master = block.text(line, 0), block.text(line, 1)
        if deck.layers and tie_layer(deck, slave, master, place):
            continue
        if deck.is_of_nodes(slave):
            nodes = [node for node in sorted(deck.nodes_of_surface(slave, place)) if node in deck.used_nodes()]
            a = deck.model.add_node_set(slave, nodes) if nodes else ""
        else:
            nodes = sorted(deck.nodes_of_surface(slave, place))
            a = deck.surface_name(slave, place, of_contact=True)
        b = deck.surface_name(master, place, of_contact=True)
        if not a or not b:
            deck.ledger.refuse("TIE", place, "a tie with a surface without elements", INSTEAD)
            continue
        entry: Deck = {"a": a, "b": b}
        if block.option("POSITION TOLERANCE"):
            entry["distance"] = block.number((line[0], [block.option("POSITION TOLERANCE")]), 0)
        if "NO ROTATION" not in block.options and ties_rotations(deck, set(nodes), master, place):
            entry["rotations"] = True
        if deck.ledger.allows("TIE.empty"):  # found by the run, which knows the reach
            entry["empty"] = "ignore"
            deck.ledger.approximated("TIE.empty", place,
                                     "a tie in reach of nothing is reported by the run, and ignored")
        deck.model.deck.setdefault("contact", {}).setdefault("ties", []).append(entry)
        deck.ledger.approximated("TIE", place, "contact.ties: gaps stay as they are")


def ties_rotations(deck: AbaqusDeck, slaves: set[int], master: str, place: Place) -> bool:
    """Rotations are equal where both sides have them."""
    turning = deck.model.turning_nodes()
    rigid = {node for group in deck.groups for node in group.nodes}
    return bool((slaves & turning) - rigid) and deck.nodes_of_surface(master, place) <= turning


def refuse_late(deck: AbaqusDeck, block: Block) -> None:
    """Contact that begins in a later step."""
    if block.step > 1:
        deck.ledger.refuse(f"{block.keyword}.step", block.place,
                           "contact that begins in a later step", "it acts from the start")


def read_contact_pair(deck: AbaqusDeck, block: Block) -> None:
    """slave, master; one alone touches itself."""
    if block.option("OP") == "DELETE":
        end_pairs(deck, block)
        return
    if not block.option("INTERACTION"):
        raise BadInput(block.place, "*CONTACT PAIR has no INTERACTION (it says how the surfaces touch): "
                                    "add the name of a *SURFACE INTERACTION")
    friction = deck.friction(block.option("INTERACTION"), block.place)
    refuse_glue(deck, block.option("INTERACTION"), block.place)
    for line in block.lines:
        add_pair(deck, block, line, friction)


def add_pair(deck: AbaqusDeck, block: Block, line: Line, friction: float | None) -> None:
    """friction: none: that of general contact."""
    place = block.at(line[0])
    first, second = block.text(line, 0), block.text(line, 1)
    if is_profile(deck, first):
        first, second = second, first
    if is_profile(deck, second):
        note_wall_pair(deck, block, (first, second), place, friction)
        return
    a = name_side(deck, block, first, place)
    b = name_side(deck, block, second, place) if second else a
    if not a or not b:
        deck.ledger.ignored(block.keyword, place, "one of its surfaces has no element")
        return
    pair: dict[str, Any] = {"a": a, "b": b, **({} if friction is None else {"friction": friction})}
    acting = find_acting(deck, a, b)
    if acting is not None and {key: acting[key] for key in acting if key != "from"} == pair:
        return  # again in a later step
    start = deck.step_of(block).start
    if acting is not None:
        end_pair(deck, acting, start)
    deck.pairs.append(pair | ({"from": deck.sensor_at(start)} if start > 0 else {}))
    deck.contact_names[(first.upper(), (second or first).upper())] = (a, b)
    deck.ledger.translated(block.keyword, place, "contact.surfaces")


def find_acting(deck: AbaqusDeck, a: str, b: str) -> Deck | None:
    """The pair of two surfaces that no later step has ended."""
    return next((pair for pair in deck.pairs if {pair["a"], pair["b"]} == {a, b} and "until" not in pair), None)


def end_pair(deck: AbaqusDeck, pair: Deck, time: float) -> None:
    """Ends a pair with the step before; a pair that no step has is removed."""
    if time > 0 and pair.get("from") != deck.sensor_at(time):
        pair["until"] = deck.sensor_at(time)
    else:
        deck.pairs.remove(pair)


def end_pairs(deck: AbaqusDeck, block: Block) -> None:
    """OP=DELETE: the pairs of the lines end."""
    for line in block.lines:
        place = block.at(line[0])
        names = [block.text(line, 0), block.text(line, 1) or block.text(line, 0)]
        if any(is_profile(deck, name) for name in names):
            deck.ledger.refuse("CONTACT PAIR.OP", place,
                               "contact with an analytical surface that ends with a step", "it goes on")
            continue
        sides = [name_side(deck, block, name, place) for name in names]
        pair = find_acting(deck, *sides)
        if pair is None:
            raise BadInput(place, "*CONTACT PAIR, "
                                  f"OP=DELETE: there is no pair of '{clip(names[0])}' and '{clip(names[1])}' to end")
        end_pair(deck, pair, deck.step_of(block).start)
        deck.ledger.translated("CONTACT PAIR", place, "contact.surfaces.N.until")


def name_side(deck: AbaqusDeck, block: Block, name: str, place: Place) -> str:
    """A surface of contact; one of nodes alone stands for the faces that have them."""
    if not deck.is_of_nodes(name):
        return deck.surface_name(name, place, of_contact=True)
    faces = deck.faces_of_nodes(name, place)
    if not faces:
        deck.ledger.refuse(f"{block.keyword}.nodes", place,
                           f"contact of the nodes of '{clip(name)}', which no face has", INSTEAD)
        return ""
    deck.ledger.approximated(block.keyword, place, "a surface of nodes is that of the faces between them")
    return faces


def note_wall_pair(deck: AbaqusDeck, block: Block, names: tuple[str, str], place: Place,
                   friction: float | None) -> None:
    """A surface before an analytical one."""
    name = deck.surface_name(names[0], place, of_contact=True) if names[0] and not deck.is_of_nodes(names[0]) else ""
    if names[0] and deck.is_of_nodes(names[0]):
        nodes = sorted(deck.nodes_of_surface(names[0], place) & deck.used_nodes())
        name = deck.model.add_node_set(names[0], nodes) if nodes else ""
    if not name:
        deck.ledger.ignored(block.keyword, place, "one of its surfaces has no element")
        return
    pair = (deck.tidy(names[1]), name, friction)
    if pair not in deck.wall_pairs:
        refuse_late(deck, block)
        deck.wall_pairs.append(pair)
    deck.ledger.translated(block.keyword, place, "walls.N.nodes")


def read_surface_property(deck: AbaqusDeck, block: Block) -> None:
    """*SURFACE PROPERTY ASSIGNMENT: thicknesses, offsets and edges of general contact."""
    kind = block.option("PROPERTY")
    if kind == "FEATURE EDGE CRITERIA":
        deck.ledger.approximated(block.keyword, block.place, "percuss chooses the edges that touch: those of more than "
                                                             "30 degrees, and rims of shells")
        return
    plain = {"THICKNESS": ("", "ORIGINAL", "THINNING"), "OFFSET FRACTION": ("", "ORIGINAL")}.get(kind, ())
    for line in block.lines:
        factor = block.number(line, 2, 1.0) if kind == "THICKNESS" else 1.0
        if kind == "OFFSET FRACTION" and not block.text(line, 0):
            deck.contact_ignores_offsets = parse_real(block.text(line, 1)) == 0
            if deck.contact_ignores_offsets:
                continue
        if block.text(line, 1).upper() not in plain or factor != 1:
            text = f"{clip(kind) or 'a property'} {clip(block.text(line, 1))} of a surface in contact"
            deck.ledger.refuse(block.keyword, block.at(line[0]), text, "shells touch at half their thickness")
            return
    deck.ledger.ignored(block.keyword, block.place, "shells touch at half their thickness here too")
