"""*MAT_COHESIVE_MIXED_MODE of cohesive elements (ELFORM 19 and 21): cohesive ties of the solids on both sides."""

from ...cohesive_layers import LEFT_OUT, add_layer, find_energy_fault, make_layer
from ...fields import Row
from ...ledger import BadInput, missing
from ...model import Block, Deck
from ..cards import Card
from ..deck import KeywordDeck, PartCard
from .names import name_law

FORMS = {19, 20, 21, 22}  # ELFORM; of 20 and 22 the sides are shells
LAW = "COHESIVE_MIXED_MODE"


def bond_solids(deck: KeywordDeck, part: PartCard, block: Block) -> None:
    """A cohesive tie in place of the elements of a part. All other parts are in the model."""
    card = deck.materials.get(part.material)
    if card is None:
        raise BadInput(part.place, missing(f"material {part.material}, of part {part.id}"))
    deck.used.add(("material", part.material))
    if name_law(card.keyword) != LAW:
        deck.ledger.refuse("SECTION_SOLID.ELFORM", part.place,
                           f"cohesive elements of *{card.keyword} (MAT_138 is read)", LEFT_OUT)
        return
    law = read_law(deck, card)
    if law and add_layer(deck.model, deck.ledger, make_layer(deck.model, block.name, block.solids, law, part.place)):
        deck.ledger.translated(card.keyword, card.place, "the law of a cohesive tie")


def read_law(deck: KeywordDeck, card: Card) -> Deck:
    """Keys of a cohesive tie; empty: refused."""
    reader = card.reader()
    row = reader.row("MID RO ROFLG INTFAIL EN ET GIC GIIC")
    more = reader.row("XMU T S UND UTD GAMMA=1")
    fault = find_fault(row, more)
    if fault:
        deck.ledger.refuse(f"{card.keyword}.law", card.place, fault, LEFT_OUT)
        return {}
    row.skip("MID", "RO", "ROFLG")
    if row.number("INTFAIL") != 1:
        deck.ledger.approximated(f"{card.keyword}.INTFAIL", row.place,
                                 "each node of the layer lets go when its own energy is spent")
    power = more.number("XMU")
    law: Deck = {"normal_stiffness": row.number("EN"), "shear_stiffness": row.number("ET")}
    for of, strength, end, energy in (("normal", "T", "UND", "GIC"), ("shear", "S", "UTD", "GIIC")):
        spent = row.number(energy)
        law[f"{of}_strength"] = more.number(strength) or 2 * spent / more.number(end)
        law[f"{of}_energy"] = spent
    law |= {"mix": "power_law" if power > 0 else "benzeggagh_kenane", "exponent": abs(power)}
    of = find_energy_fault(law)
    if of:
        text = f"a layer that has stored more than its energy in {of} direction when it reaches its strength"
        deck.ledger.refuse(f"{card.keyword}.energy", card.place, text, LEFT_OUT)
        return {}
    for line in (row, more):
        line.finish(deck.ledger)
    return law


def find_fault(row: Row, more: Row) -> str:
    """What of the law percuss lacks; empty: nothing."""
    for name in ("EN", "ET", "GIC", "GIIC"):
        row.positive(name)
    for strength, end in (("T", "UND"), ("S", "UTD")):
        if more.number(strength) < 0:
            return f"{strength} below 0: a strength that depends on the size of elements"
        if more.number(strength) == 0 and more.number(end) <= 0:
            more.fail(strength, f"a strength is expected, or {end}")
    if more.number("XMU") == 0:
        more.fail("XMU",
                  "the exponent of the mix is expected: above 0 of the power law, below 0 of Benzeggagh and Kenane")
    if more.number("XMU") < 0 and more.number("GAMMA") not in (0, 1):
        return f"GAMMA = {more.number('GAMMA'):g}: another effective stiffness of mixes"
    return ""
