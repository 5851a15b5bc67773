"""*MAT_RIGID: the parts made of it are rigid bodies."""

from ...fields import Row
from ...model import Deck
from ..cards import Card
from ..deck import KeywordDeck, RigidPart

DIRECTIONS = {0: "", 1: "x", 2: "y", 3: "z", 4: "xy", 5: "yz", 6: "zx", 7: "xyz"}


def read_law(row: Row) -> Deck:
    """Density, and the stiffness of contact."""
    row.skip("MID")
    return {
        "model": "elastic",
        "density": row.positive("RO"),
        "youngs_modulus": row.positive("E"),
        "poissons_ratio": row.number("PR"),
    }


def translate_rigid(deck: KeywordDeck, card: Card) -> Deck | None:
    """The law of its elements, of which mass and stiffness count. Notes its parts and what holds them."""
    reader = card.reader()
    row, limits = reader.row("MID RO E PR N~absent COUPLE M~absent ALIAS~label"), reader.row("CMO CON1 CON2")
    law, id = read_law(row), row.integer("MID")
    held: list[str] = []
    if limits.number("CMO") == 1:
        held = [*DIRECTIONS.get(limits.integer("CON1"), ""), *("r" + d for d in DIRECTIONS.get(limits.integer("CON2"), ""))]
    elif limits.number("CMO") == -1:
        deck.ledger.refuse("MAT_RIGID.CMO", limits.place, "a rigid body with constraints along local axes", "it is free")
    for part in deck.parts.values():
        if part.material == id and deck.names_of_parts.get(part.id):
            deck.rigid[part.id] = RigidPart(held)
    row.finish(deck.ledger, "it is not coupled")
    deck.ledger.translated("MAT_RIGID", card.place, "parts.NAME.rigid")
    return law
