"""*MAT_FABRIC: membranes of two families of threads."""

from ...model import Block, Deck
from ..cards import Card
from ..deck import KeywordDeck
from .orthotropic import add_axes
from .shared import Use, finish_lines

FORMS = {0, 1, 2, 3}  # linear, with axes at a right angle or of threads that turn
OTHERS = {4: "curves", 12: "a new basis of form 2", 13: "a new basis of form 3", 14: "curves and hysteresis",
          -14: "curves, hysteresis and a coat", 24: "curves and bending"}


def fabric(deck: KeywordDeck, card: Card, use: Use) -> Deck | None:
    """*MAT_034, FORM 0 to 3."""
    reader = card.reader()
    row, shear = (reader.row("MID RO EA EB U1~unused PRBA PRAB"),
                  reader.row("GAB U2~unused U3~unused CSE EL PRL LRATIO DAMP"))
    options = reader.row("AOPT FLC FAC ELA LNRC FORM FVOPT TSRFAC")
    form = options.integer("FORM")
    if form not in FORMS:
        deck.ledger.refuse("MAT_FABRIC.FORM", options.place,
                           f"form {form} of fabrics ({OTHERS.get(form, 'not known')})",
                           "the parts made of it are left out")
        return None
    if options.number("FVOPT") < 0:
        reader.row("L R C1 C2 C3").finish(deck.ledger, "it is left out")
    point, vectors = (reader.row("U4~unused RGBRTH A0REF A1 A2 A3 X0 X1"),
                      reader.row("V1 V2 V3 D1~unused D2~unused D3~unused BETA ISREFG"))
    row.skip("MID")
    warp, ratio = row.positive("EA"), row.number("PRBA")
    weft = row.number("EB") or warp
    law: Deck = {"model": "fabric", "density": row.positive("RO"), "warp_modulus": warp, "weft_modulus": weft,
                 "shear_modulus": shear.number("GAB") or warp / (2 * (1 + ratio)),
                 "warp_poissons_ratio": ratio * warp / weft}  # fmt: skip
    other = row.number("PRAB")
    if other and abs(other - law["warp_poissons_ratio"]) > 0.01 * abs(other):
        deck.ledger.refuse("MAT_FABRIC.PRAB", row.place,
                           f"PRAB is {other:g}, where {law['warp_poissons_ratio']:g} follows from PRBA",
                           "it is taken from PRBA")
    if shear.number("CSE"):
        law["no_compression"] = True
    if not shear.number("EL") and not shear.number("LRATIO"):  # without a liner
        shear.skip("PRL")
        options.skip("LNRC")
    if shear.number("DAMP"):
        deck.ledger.approximated("MAT_FABRIC.DAMP", shear.place,
                                 "no damping of the fabric; damping of its nodes may stand for it")
    add_axes(deck, card, use, law, (options, point, vectors), vectors.number("BETA"))
    if use.turn:
        deck.ledger.refuse("MAT_FABRIC.BETA", vectors.place,
                           "an angle of the warp (BETA, or AOPT = 3)", "the warp is not turned")
        use.turn = 0.0
    for found in (row, shear, options, point, vectors):
        found.finish(deck.ledger, "it is left out")
    text = "threads that follow the membrane, linear in Green's strain from the start; CSE makes it a tension field"
    deck.ledger.approximated("MAT_FABRIC.FORM", options.place, text)
    finish_lines(deck, card, reader)
    return law


def make_membrane(deck: KeywordDeck, block: Block, law: Deck) -> None:
    """Shells of fabric do not bend, whatever their section says."""
    if law["model"] != "fabric" or block.keys.get("integration") == "membrane":
        return
    block.keys["integration"] = "membrane"
    for key in ("points", "reference"):
        block.keys.pop(key, None)
    deck.ledger.approximated("MAT_FABRIC", block.place,
                             "shells of fabric are membranes, whatever ELFORM of their section")


FABRIC = {"FABRIC": fabric}
