"""*MAT_ADD_EROSION: criteria of failure on top of those of a material."""

from ...model import Deck
from ..deck import KeywordDeck
from .shared import Use, finish_lines, set_failure

YIELDING = {"j2_plasticity", "power_law_plasticity", "voce_plasticity", "tabulated_plasticity", "combined_hardening", "johnson_cook"}


def add_erosion(deck: KeywordDeck, material: int, law: Deck, use: Use) -> None:
    """Adds SIGP1, MXEPS, MNPRES and a plastic strain; anything else is refused."""
    card = deck.erosions.get(material)
    if card is None:
        return
    reader = card.reader()
    if card.has_title:
        reader.take()
    row = reader.row("MID EXCL MXPRES MNEPS EFFEPS VOLEPS NUMFIP=1 NCS=1")
    more = reader.row("MNPRES SIGP1 SIGVM MXEPS EPSSH SIGTH IMPULSE FAILTM")
    excluded = row.number("EXCL")
    row.skip("MID", "EXCL")
    for found, names in ((row, "MXPRES MNEPS VOLEPS"), (more, "SIGVM EPSSH SIGTH IMPULSE")):
        for name in names.split():
            if found.number(name) not in (0.0, excluded):
                deck.ledger.refuse(f"MAT_ADD_EROSION.{name}", found.place, "this failure criterion", "it is left out")
    for name in ("SIGP1", "MXEPS", "MNPRES"):
        wrong = more.number(name) > 0 if name == "MNPRES" else more.number(name) < 0
        if wrong and more.number(name) != excluded:
            deck.ledger.refuse(f"MAT_ADD_EROSION.{name}", more.place, f"{name} of {more.number(name):g}, a curve or a limit in compression", "it is left out")
    strain = row.number("EFFEPS")
    if strain > 0 and strain != excluded:
        deck.ledger.refuse("MAT_ADD_EROSION.EFFEPS", row.place, "failure by the effective strain", "it is left out")
    if 0 < abs(more.number("FAILTM")) < deck.end_time and more.number("FAILTM") != excluded:
        deck.ledger.refuse("MAT_ADD_EROSION.FAILTM", more.place, "failure at a time", "it is left out")
    limits = {"principal_stress": more.number("SIGP1"), "principal_strain": more.number("MXEPS"), "pressure": -more.number("MNPRES")}
    if strain < 0:
        limits["plastic_strain"] = -strain
    if strain < 0 and law["model"] not in YIELDING and strain != excluded:
        deck.ledger.refuse("MAT_ADD_EROSION.EFFEPS", row.place, "failure by plastic strain of a law without it", "it is left out")
        del limits["plastic_strain"]
    set_failure(law, **{key: value for key, value in limits.items() if value not in (excluded, -excluded)})
    layers = row.number("NUMFIP")
    if use.is_shell and "failure" in law and layers != 1:
        law["failure"]["layers"] = min(layers / use.points, 1.0) if layers > 0 else min(-layers / 100, 1.0)
    row.finish(deck.ledger)
    finish_lines(deck, card, reader)
    deck.ledger.translated("MAT_ADD_EROSION", card.place, "failure of the material")
