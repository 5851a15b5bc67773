"""*MAT_ADD_EROSION: criteria of failure on top of those of a material."""

import math

from ... import laws
from ...curves import interpolate
from ...fields import Row
from ...model import Deck
from ..deck import KeywordDeck
from .gissmo import add_idam
from .shared import Use, finish_lines, set_failure, set_layers

FIRST_FIBRE = 1e-3  # share of the area of a section: less than any fibre has
MOST_VOLUME_STRAIN = 30.0  # beyond it nothing fails, and the exponential is no sound number


def add_erosion(deck: KeywordDeck, material: int, law: Deck, use: Use) -> None:
    """Adds SIGP1, MXEPS, MNPRES, VOLEPS and a plastic strain; anything else is refused."""
    card = deck.erosions.get(material)
    if card is None:
        return
    reader = card.reader()
    if card.has_title:
        reader.take()
    row = reader.row("MID EXCL MXPRES MNEPS EFFEPS VOLEPS NUMFIP=1 NCS=1")
    more = reader.row("MNPRES SIGP1 SIGVM MXEPS EPSSH SIGTH IMPULSE FAILTM")
    excluded = row.raw("EXCL")
    row.skip("MID")

    def limit(found: Row, name: str) -> float:
        """0 for none, as a value of EXCL is."""
        return 0.0 if found.raw(name) == excluded else found.number(name)

    for found, names in ((row, "MXPRES MNEPS"), (more, "SIGVM EPSSH SIGTH IMPULSE")):
        for name in names.split():
            if limit(found, name):
                deck.ledger.refuse(f"MAT_ADD_EROSION.{name}", found.place, "this failure criterion", "it is left out")
    for name in ("SIGP1", "MXEPS", "MNPRES"):
        value = limit(more, name)
        if value > 0 if name == "MNPRES" else value < 0:
            deck.ledger.refuse(f"MAT_ADD_EROSION.{name}", more.place,
                               f"{name} of {value:g}, a curve or a limit in compression", "it is left out")
    strain = limit(row, "EFFEPS")
    if strain > 0:
        strain = -find_plastic_limit(deck, law, strain, row)
    if 0 < abs(limit(more, "FAILTM")) < deck.end_time:
        deck.ledger.refuse("MAT_ADD_EROSION.FAILTM", more.place, "failure at a time", "it is left out")
    limits = {"principal_stress": limit(more, "SIGP1"), "principal_strain": limit(more, "MXEPS"),
              "pressure": -limit(more, "MNPRES")}
    if strain < 0 and "evolution" in law.get("failure", {}):
        deck.ledger.refuse("MAT_ADD_EROSION.EFFEPS", row.place,
                           "failure by plastic strain beside damage of the law that grows with it", "it is left out")
        strain = 0.0
    if strain < 0:
        limits["plastic_strain"] = -strain
    if strain < 0 and not laws.has(law, "has_plastic_strain"):
        deck.ledger.refuse("MAT_ADD_EROSION.EFFEPS", row.place,
                           "failure by plastic strain of a law without it", "it is left out")
        del limits["plastic_strain"]
    add_volume(deck, limits, limit(row, "VOLEPS"), row, use)
    own = law.get("failure", {}).get("layers", 1.0) if {"plastic_strain", "principal_strain", "johnson_cook",
                                                        "fibre_damage"} & law.get("failure", {}).keys() else None
    set_failure(law, **limits)
    if use.is_shell and any(value > 0 for value in limits.values()):
        set_layers(deck, law, row, use, own)
    if use.is_beam and strain < 0:
        set_first_fibre(deck, law, row)
    row.finish(deck.ledger)
    add_idam(deck, law, reader, use)
    finish_lines(deck, card, reader)
    deck.ledger.translated("MAT_ADD_EROSION", card.place, "failure of the material")


def find_plastic_limit(deck: KeywordDeck, law: Deck, strain: float, row: Row) -> float:
    """The plastic strain at which a metal has an effective strain: less the elastic one, of the yield stress over 3 G.
    0 where it is refused."""
    plastic = strain
    triple = 3 * law.get("youngs_modulus", 1.0)
    for _ in range(50):
        yielding = find_yield_stress(law, max(plastic, 0.0))
        plastic = strain - yielding * 2 * (1 + law.get("poissons_ratio", 0.0)) / triple
    if plastic <= 0:
        deck.ledger.refuse("MAT_ADD_EROSION.EFFEPS", row.place,
                           "failure by the effective strain of a law that does not yield before it", "it is left out")
        return 0.0
    deck.ledger.approximated("MAT_ADD_EROSION.EFFEPS", row.place, f"a plastic strain of {plastic:.6g}: the effective "
                                                                  "strain of a load in one direction, at rest")
    return plastic


def find_yield_stress(law: Deck, plastic: float) -> float:
    """Yield stress at rest, of laws whose constants give it; infinite of others."""
    if law["model"] == "tabulated_plasticity":
        return interpolate([(x, y) for x, y in law["hardening"]], plastic)
    if law["model"] not in ("j2_plasticity", "combined_hardening"):
        return math.inf
    return float(law["yield_stress"] + law.get("hardening_modulus", 0.0) * plastic)


def add_volume(deck: KeywordDeck, limits: dict[str, float], strain: float, row: Row, use: Use) -> None:
    """VOLEPS: the logarithm of the relative volume of a solid, above 0 in tension and below 0 in compression."""
    if not strain:
        return
    if use.is_shell or use.is_beam or abs(strain) > MOST_VOLUME_STRAIN:
        deck.ledger.refuse("MAT_ADD_EROSION.VOLEPS", row.place,
                           "failure by the volume of shells or beams, or at a logarithm of that size", "it is left out")
        return
    limits["volume_above" if strain > 0 else "volume_below"] = math.exp(strain)


def set_first_fibre(deck: KeywordDeck, law: Deck, row: Row) -> None:
    """NUMFIP of beams: with 1 they fail with their first fibre, as a law's own criterion does not."""
    if row.number("NUMFIP") not in (0, 1):
        deck.ledger.refuse("MAT_ADD_EROSION.NUMFIP", row.place, "several points of beams that must fail",
                           "beams fail with the first")
    law["failure"]["layers"] = FIRST_FIBRE
