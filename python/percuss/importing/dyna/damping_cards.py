"""*DAMPING_GLOBAL and _PART_MASS: damping in proportion to mass; _PART_STIFFNESS: to stiffness."""

from ..curves import make_time_value
from ..fields import Row
from ..laws import NOT_DAMPED, takes_stiffness_damping
from ..ledger import BadInput, Place
from .cards import Card
from .deck import KeywordDeck

MASS_CARDS = ("DAMPING_GLOBAL", "DAMPING_PART_MASS", "DAMPING_PART_MASS_SET")
STIFFNESS_CARDS = ("DAMPING_PART_STIFFNESS", "DAMPING_PART_STIFFNESS_SET")
FACTORS = ("STX", "STY", "STZ", "SRX", "SRY", "SRZ")


def read_damping(deck: KeywordDeck, card: Card) -> None:
    """Entries of `damping`. Those of all come first, since the last one that names a node holds."""
    if card.keyword in STIFFNESS_CARDS:
        read_stiffness_damping(deck, card)
    elif card.keyword not in MASS_CARDS:
        deck.ledger.refuse(card.keyword, card.place,
                           "damping other than in proportion to mass or stiffness", "it is left out")
    elif card.keyword == "DAMPING_GLOBAL":
        row = card.reader().row("LCID VALDMP STX STY STZ SRX SRY SRZ")
        deck.ids.claim_only("*DAMPING_GLOBAL", row.place)
        factor = read_factors(deck, row)
        if factor is not None:
            add_damping(deck, "", row, row.integer("LCID"), factor, row.number("VALDMP"))
            deck.ledger.translated(card.keyword, row.place, "damping of all nodes")
    else:
        read_part_damping(deck, card)


def read_factors(deck: KeywordDeck, row: Row) -> float | None:
    """Factors by direction; none at all means 1 for each. None: refused."""
    values = row.numbers(*FACTORS)
    moves, turns = values[:3], values[3:]
    if not any(values):
        return 1.0
    if len(set(moves)) == 1 and (set(turns) == set(moves)
                                 or not (deck.turning_nodes() or deck.rigid or deck.nodal_bodies)):
        return moves[0]
    is_allowed = deck.ledger.refuse(f"{row.card}.STX", row.place, "STX to SRZ, damping that differs by direction",
                                    "all directions are damped alike")
    return 1.0 if is_allowed else None


def read_part_damping(deck: KeywordDeck, card: Card) -> None:
    reader = card.reader()
    while reader.skip_blank():
        row = reader.row("ID LCID SF=1 FLAG STRUC")
        factor = read_factors(deck, reader.row("STX STY STZ SRX SRY SRZ")) if row.integer("FLAG") else 1.0
        if factor is None:
            continue
        id = row.integer("ID")
        if row.integer("STRUC") and deck.masses:
            deck.ledger.refuse(f"{card.keyword}.STRUC", row.place,
                               "STRUC is 1: masses of *ELEMENT_MASS are not damped", "they are damped too")
        parts = deck.list_members("PART", id, row.place) if card.keyword.endswith("SET") else [id]
        for part in parts:
            deck.find_part(part, row.place)
        names = deck.part_names(parts)
        for name in names:
            add_damping(deck, name, row, row.integer("LCID"), factor * (row.number("SF") or 1.0), 0.0)
        if names:
            deck.ledger.translated(card.keyword, row.place, "damping of the nodes of the part")
        else:
            deck.ledger.ignored(card.keyword, row.place, "its parts have no elements, and nothing to damp")


def read_stiffness_damping(deck: KeywordDeck, card: Card) -> None:
    """PID COEF: a negative COEF is Rayleigh's beta. What a positive one does at which frequency depends on the step."""
    reader = card.reader()
    while reader.skip_blank():
        row = reader.row("ID COEF")
        id, value = row.integer("ID"), row.number("COEF")
        row.finish(deck.ledger)
        if value == 0:
            continue
        if value > 0:
            deck.ledger.refuse(
                f"{card.keyword}.COEF", row.place,
                "a share of the damping at high frequencies, which is that of LS-DYNA's own step",
                "there is none: a negative COEF is beta"
            )
            continue
        parts = deck.list_members("PART", id, row.place) if card.keyword.endswith("SET") else [id]
        for part in parts:
            deck.find_part(part, row.place)
        for block in deck.model.blocks:
            if block.part not in parts or block.part in deck.rigid:
                continue
            if not takes_stiffness_damping(block, deck.model.materials[block.keys["material"]]):
                deck.ledger.refuse(f"{card.keyword}.part", row.place, NOT_DAMPED, "their part is not damped")
                continue
            block.keys["stiffness_damping"] = -value
            deck.ledger.translated(card.keyword, row.place, "stiffness_damping of the part")


def add_damping(deck: KeywordDeck, name: str, row: Row, curve: int, scale: float, otherwise: float) -> None:
    """An entry; an empty name means all, and stands before those of parts.
    otherwise: the coefficient without a curve."""
    value = (make_time_value(deck.curve(curve, row.place, "time", "rate"), scale, deck.end_time) if curve
             else scale * otherwise)
    check_sign(value, row.place)
    entry = {"nodes": name, "coefficient": value} if name else {"coefficient": value}
    entries = deck.model.deck.setdefault("damping", [])
    if entries and not (name and all("nodes" in known for known in entries)):
        deck.ledger.approximated(f"{row.card}.two", row.place,
                                 "nodes have one damping: that of their part in place of that of *DAMPING_GLOBAL")
    entries.insert(0 if not name else len(entries), entry)


def check_sign(value: object, place: Place) -> None:
    """Negative damping would add energy. An expression is judged by percuss itself."""
    rows = value.get("table", []) if isinstance(value, dict) else [[0.0, value]]
    if any(row[1] < 0 for row in rows):
        raise BadInput(place, "the damping is negative (it would add energy): reverse its sign")
