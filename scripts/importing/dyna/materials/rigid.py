"""*MAT_RIGID: exact where the motion of the part is given, otherwise refused."""

from ...fields import Row
from ...model import Deck
from ..cards import Card
from ..deck import KeywordDeck

DIRECTIONS = {0: "", 1: "x", 2: "y", 3: "z", 4: "xy", 5: "yz", 6: "zx", 7: "xyz"}
INSTEAD = "its parts are elastic bodies with E and PR of the card"


def read_law(row: Row) -> Deck:
    row.skip("MID", "N", "COUPLE", "M", "ALIAS")
    return {
        "model": "elastic",
        "density": row.positive("RO"),
        "youngs_modulus": row.positive("E"),
        "poissons_ratio": row.number("PR"),
    }


def translate_rigid(deck: KeywordDeck, card: Card) -> Deck | None:
    """An elastic law. Parts that cannot turn, and move along given curves only, get their motion at all nodes."""
    reader = card.reader()
    row, limits = reader.row("MID RO E PR N COUPLE M ALIAS"), reader.row("CMO CON1 CON2")
    law = read_law(row)
    id = row.integer("MID")
    parts = [part for part in deck.parts.values() if part.material == id and deck.names_of_parts.get(part.id)]
    fixed = set(DIRECTIONS.get(limits.integer("CON1"), "")) if limits.number("CMO") == 1 else set()
    turns_fixed = limits.number("CMO") == 1 and limits.integer("CON2") == 7
    if limits.number("CMO") == -1:
        fixed, turns_fixed = set(), False
    for part in parts:
        motions = deck.rigid_motions.get(part.id, {})
        if turns_fixed and fixed | set(motions) >= set("xyz"):
            deck.driven[part.id] = fixed - set(motions)
            deck.ledger.translated("MAT_RIGID", card.place, "a part whose motion is given: at all its nodes")
        elif not deck.ledger.refuse(
            "MAT_RIGID", card.place, f"a rigid body that moves freely (part {part.id}), which percuss does not have", INSTEAD
        ):
            return law
    return law
