"""Laws of rolled sheet: yield stress and strain ratio by direction."""

from ...fields import Row
from ...model import Deck
from ..cards import Card
from ..deck import KeywordDeck
from ..dimensions import scale
from .orthotropic import POINT, add_axes
from .shared import FAR, Use, add_rate, finish_lines, make_hardening, tangent_to_hardening

VECTORS = "V1 V2 V3 D1~unused D2~unused D3~unused"  # D is of solids
SWIFT_ROWS, SWIFT_END = 4000, 2.0  # of a power law as a table, up to this plastic strain
MOST_SPI = 0.02  # a SPI above is a stress


def start_law(row: Row) -> Deck:
    row.skip("MID")
    return {"model": "anisotropic_plasticity", "density": row.positive("RO"), "youngs_modulus": row.positive("E"),
            "poissons_ratio": row.number("PR")}


def refuse_solids(deck: KeywordDeck, card: Card, use: Use) -> bool:
    if use.is_shell:
        return False
    deck.ledger.refuse(f"{card.keyword}.solids", use.place,
                       "elements other than shells of this law (LS-DYNA has it for shells)",
                       "the parts made of it are left out")
    return True


def list_straight(stress: float, slope: float) -> list[list[float]]:
    """A straight hardening curve."""
    return [[0.0, stress], [2 * FAR, stress + 2 * FAR * slope]] if slope else [[0.0, stress]]


def find_swift_strain(card: Card, row: Row, more: Row, k: float, n: float) -> float:
    """The strain of the first yield: E0, or by SPI."""
    given, spi = more.numbers("E0", "SPI") if card.keyword.startswith("MAT_3") else (more.number("E0"), 0.0)
    if given > 0:
        return given
    if spi > MOST_SPI:
        return float((spi * scale("stress", card.change.factors) / k) ** (1 / n))
    return float(spi if spi > 0 else (row.positive("E") / k) ** (1 / (n - 1)))


def add_swift(deck: KeywordDeck, card: Card, row: Row, more: Row, law: Deck) -> None:
    """HR = 2: k (e0 + p)^n."""
    k, n = row.positive("P1"), row.positive("P2")
    if n >= 1:
        row.fail("P2", "an exponent below 1 is expected")
    first = find_swift_strain(card, row, more, k, n)
    points = [(SWIFT_END * (i / SWIFT_ROWS) ** 2, k * (first + SWIFT_END * (i / SWIFT_ROWS) ** 2) ** n)
              for i in range(SWIFT_ROWS + 1)]
    law["hardening"] = make_hardening(deck, points, card.keyword, more.place)


def add_hardening(deck: KeywordDeck, card: Card, row: Row, more: Row, law: Deck) -> bool:
    """HR: a straight line of the slope P1 from P2 on, a power law or a curve; whether it is one of these."""
    kind = row.number("HR") or 1.0
    if kind == 2:
        add_swift(deck, card, row, more, law)
    elif kind == 1:
        stress = row.positive("P2") * scale("stress", card.change.factors)
        law["hardening"] = list_straight(stress, tangent_to_hardening(row, law["youngs_modulus"], row.number("P1")))
    elif kind == 3 and more.integer("LCID") not in deck.tables:
        law["hardening"] = make_hardening(deck, deck.material_curve(more.integer("LCID"), more.place, "none", "stress"),
                                          card.keyword, more.place)
    else:
        what = f"hardening of the kind HR = {kind:g}" if kind != 3 else "a table of hardening curves"
        deck.ledger.refuse(f"{card.keyword}.HR", row.place, f"{what} (percuss takes a line, a power law and a curve)",
                           "the parts made of it are left out")
        return False
    if kind != 2:
        more.skip(*(name for name in ("E0", "SPI") if name == "E0" or card.keyword.startswith("MAT_3")))
    if kind != 3:
        more.skip("LCID")
    row.skip("P1", "P2")
    return True


def add_ratios(row: Row, law: Deck) -> None:
    ratios = row.numbers("R00", "R45", "R90")
    if min(ratios) < 0:
        row.fail("R00", "ratios of strain from 0 on are expected (a negative one is a curve)")
    law["r_values"] = [ratio or 1.0 for ratio in ratios]


def barlat(deck: KeywordDeck, card: Card, use: Use) -> Deck | None:
    """*MAT_036, with M = 2 Hill's surface."""
    reader = card.reader()
    row, more = reader.row("MID RO E PR HR=1 P1 P2 ITER~solver"), reader.row("M R00 R45 R90 LCID E0 SPI P3")
    options = reader.row("AOPT C P VLCID NONE PB HTA HTB")
    point, vectors = reader.row(f"{POINT} HTC HTD"), reader.row(f"{VECTORS} BETA HTFLAG")
    law = start_law(row)
    if refuse_solids(deck, card, use) or not add_hardening(deck, card, row, more, law):
        return None
    law["exponent"] = abs(more.number("M"))
    if not 2 <= law["exponent"] <= 40:
        more.fail("M", "an exponent from 2 to 40 is expected")
    if options.number("PB") > 0:
        a, c, h = more.numbers("R00", "R45", "R90")
        if abs(a + c - 2) > 1e-6:
            deck.ledger.refuse(f"{card.keyword}.AB", more.place,
                               f"AB + CB = {a + c:g} (2, so that the curve is that of the rolling direction)",
                               "AB is 2 - CB")
        law["barlat"] = [c, h, options.number("PB")]
    else:
        add_ratios(more, law)
    if add_rate(law, deck, options, ("C", "P")):
        deck.ledger.approximated(f"{card.keyword}.C", options.place, "the rate of plastic strain counts")
    add_axes(deck, card, use, law, (options, point, vectors), vectors.number("BETA"))
    for found in (row, more, options, point, vectors):
        found.finish(deck.ledger, "it is left out")
    finish_lines(deck, card, reader)
    return law


def hill(deck: KeywordDeck, card: Card, use: Use) -> Deck | None:
    """*MAT_122."""
    reader = card.reader()
    row, more, options = reader.row("MID RO E PR HR=1 P1 P2"), reader.row("R00 R45 R90 LCID E0"), reader.row("AOPT")
    point, vectors = reader.row(POINT), reader.row(f"{VECTORS} BETA")
    law = start_law(row)
    if refuse_solids(deck, card, use) or not add_hardening(deck, card, row, more, law):
        return None
    add_ratios(more, law)
    add_axes(deck, card, use, law, (options, point, vectors), vectors.number("BETA"))
    for found in (row, more, options, point, vectors):
        found.finish(deck.ledger, "it is left out")
    finish_lines(deck, card, reader)
    return law


def transversely_anisotropic(deck: KeywordDeck, card: Card, use: Use) -> Deck | None:
    """*MAT_037: the same ratio in all directions of the sheet. ETAN is a slope over plastic strain."""
    reader = card.reader()
    row = reader.row("MID RO E PR SIGY ETAN R HLCID")
    law = start_law(row)
    if refuse_solids(deck, card, use):
        return None
    if row.number("R") < 0:
        deck.ledger.refuse(f"{card.keyword}.R", row.place, "R below 0", "its magnitude is used")
    if row.number("ETAN") < 0:
        deck.ledger.refuse(f"{card.keyword}.ETAN", row.place,
                           "ETAN below 0: normal stresses on shells", "there are none")
    law["r_values"] = [abs(row.number("R")) or 1.0] * 3
    law["axes"] = "elements"
    id = row.integer("HLCID")
    if id:
        row.skip("SIGY", "ETAN")
        law["hardening"] = make_hardening(deck, deck.material_curve(id, row.place, "none", "stress"),
                                          card.keyword, row.place)
    else:
        law["hardening"] = list_straight(row.positive("SIGY"), abs(row.number("ETAN")))
    row.finish(deck.ledger)
    finish_lines(deck, card, reader)
    return law


ROLLED = {"3-PARAMETER_BARLAT": barlat, "HILL_3R": hill,
          "TRANSVERSELY_ANISOTROPIC_ELASTIC_PLASTIC": transversely_anisotropic}
