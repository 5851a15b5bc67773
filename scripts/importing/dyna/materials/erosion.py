"""*MAT_ADD_EROSION: criteria of failure on top of those of a material."""

from ...model import Deck
from ..deck import KeywordDeck
from .shared import Use, set_failure


def add_erosion(deck: KeywordDeck, material: int, law: Deck, use: Use) -> None:
    """Adds SIGP1, MXEPS and MNPRES; anything else is refused."""
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
    for found, names in ((row, "MXPRES MNEPS EFFEPS VOLEPS"), (more, "SIGVM EPSSH SIGTH IMPULSE FAILTM")):
        for name in names.split():
            if found.number(name) not in (0.0, excluded):
                deck.ledger.refuse(
                    f"MAT_ADD_EROSION.{name}", found.place, "this failure criterion", "it is left out"
                )
    values = {key: more.number(name) for key, name in (("principal_stress", "SIGP1"), ("principal_strain", "MXEPS"))}
    values["pressure"] = -more.number("MNPRES")
    set_failure(law, **{key: value for key, value in values.items() if value not in (excluded, -excluded)})
    layers = row.number("NUMFIP")
    if use.is_shell and "failure" in law and layers != 1:
        law["failure"]["layers"] = min(layers / use.points, 1.0) if layers > 0 else min(-layers / 100, 1.0)
    row.finish(deck.ledger)
    deck.ledger.translated("MAT_ADD_EROSION", card.place, "failure of the material")
