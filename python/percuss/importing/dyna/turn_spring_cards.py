"""*CONSTRAINED_JOINT_STIFFNESS_GENERALIZED: springs, dampers,
friction and stops of the turn between two rigid bodies."""

import math

from ..fields import Row
from ..model import Deck
from .bodies import find_body_name
from .cards import Card
from .deck import SPACE, KeywordDeck, TurnSpringCard

CARD = "CONSTRAINED_JOINT_STIFFNESS_GENERALIZED"
LEFT_OUT = "these springs are left out"
# What the names of the fields of rotations about x, y and z end with.
ANGLES = (("x", "PH"), ("y", "T"), ("z", "PS"))


def read_turn_springs(deck: KeywordDeck, card: Card) -> None:
    """Their curves may come later."""
    reader = card.reader()
    while reader.next_card(of_lines=True):
        title = reader.text() if card.has_title else ""
        row = reader.row("JSID PIDA PIDB CIDA CIDB JID~output")
        curves = reader.row("LCIDPH LCIDT LCIDPS DLCIDPH DLCIDT DLCIDPS")
        holds = reader.row("ESPH FMPH EST FMT ESPS FMPS")
        stops = reader.row("NSAPH PSAPH NSAT PSAT NSAPS PSAPS")
        deck.turn_springs.append(TurnSpringCard(title, row, curves, holds, stops))


def make_law(deck: KeywordDeck, spring: TurnSpringCard, end: str) -> Deck:
    """Keys of one angle; none where nothing resists it."""
    curves, holds, stops = spring.curves, spring.holds, spring.stops
    law: Deck = {}
    for field, key, across in ((f"LCID{end}", "table", "none"), (f"DLCID{end}", "damping_table", "rate")):
        if curves.integer(field):
            law[key] = read_rows(deck, curves, field, curves.integer(field), across)
    stiffness, friction = holds.number(f"ES{end}"), holds.raw(f"FM{end}")
    least, most = (abs(stops.number(f"{sign}SA{end}")) for sign in "NP")
    if not stiffness:
        if friction or least or most:
            deck.ledger.ignored(f"{CARD}.ES{end}", holds.place,
                                f"friction and stops of this angle do not act: ES{end} is 0")
        return law
    held: Deck = {}
    if friction < 0:
        held["friction_table"] = read_rows(deck, holds, f"FM{end}", round(-friction) + shift_of_curves(holds), "none")
    elif friction:
        held["friction"] = holds.number(f"FM{end}")
    held |= {"least": -math.radians(least)} if least else {}
    held |= {"most": math.radians(most)} if most else {}
    return law | held | ({"hold_stiffness": stiffness} if held else {})


def shift_of_curves(row: Row) -> int:
    """What a file with offsets adds to the ids of curves."""
    return int(row.change.shift_of(CARD, "LCIDPH") if row.change else 0)


def read_rows(deck: KeywordDeck, row: Row, field: str, id: int, across: str) -> list[list[float]]:
    if id in deck.tables:
        row.fail(field, f"table {id}, over the force of the joint; a curve is expected")
    points = deck.material_curve(id, row.place, across, "moment")
    if len(points) < 2:
        row.fail(field, "a curve of two points or more is expected")
    return [list(point) for point in points]


def find_axes(deck: KeywordDeck, id: int, spring: TurnSpringCard) -> list[list[float]] | None:
    """x and y of a system at the start; None: refused."""
    axes = deck.systems.get(id) or deck.moving_systems.get(id) if id else SPACE
    if axes is None:
        deck.ledger.refuse(f"{CARD}.CIDA", spring.row.place,
                           f"axes of system {id}, which is not there or is given in another one", LEFT_OUT)
        return None
    return [list(axes[0]), list(axes[1])]


def add_turn_springs(deck: KeywordDeck) -> None:
    """An entry of `turn_springs` for each card."""
    for spring in deck.turn_springs:
        row, place = spring.row, spring.row.place
        parts = row.integer("PIDA"), row.integer("PIDB")
        laws = {axis: law for axis, end in ANGLES if (law := make_law(deck, spring, end))}
        system = row.integer("CIDA")
        axes = find_axes(deck, system, spring), find_axes(deck, row.integer("CIDB") or system, spring)
        row.skip("JSID")
        for line in (row, spring.curves, spring.holds, spring.stops):
            line.finish(deck.ledger)
        names = [find_body_name(deck, id, place) for id in parts]
        if not all(names):
            deck.ledger.refuse(CARD, place,
                               f"part {parts[names.index('')]}, which is no rigid body with elements", LEFT_OUT)
        elif names[0] == names[1]:
            deck.ledger.refuse(CARD, place, "springs within one rigid body", LEFT_OUT)
        elif not laws:
            deck.ledger.ignored(CARD, place, "nothing resists the turn: no curves, friction or stops")
        elif axes[0] and axes[1]:
            entry: Deck = {"bodies": names, "axes": axes[0]} | ({"second_axes": axes[1]} if axes[1] != axes[0] else {})
            add_turn_spring(deck, spring, entry, laws)


def add_turn_spring(deck: KeywordDeck, spring: TurnSpringCard, entry: Deck, laws: dict[str, Deck]) -> None:
    name = deck.model.names.take(spring.title or f"turn_spring_{spring.row.integer('JSID')}", "turn_spring")
    deck.model.deck.setdefault("turn_springs", {})[name] = entry | laws
    if len(laws) == 1:
        deck.ledger.translated(CARD, spring.row.place, "turn_springs: " + ", ".join(*laws.values()))
    else:
        text = "turn_springs: angles about x of A, then y, then z of B, which matters where several are large"
        deck.ledger.approximated(CARD, spring.row.place, text)
