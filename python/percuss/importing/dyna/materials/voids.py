"""*MAT_GURSON: metals with voids."""

from ...curves import Points
from ...fields import Row
from ...ledger import BadInput
from ...model import Deck
from ..cards import Card
from ..deck import KeywordDeck
from .metals import EIGHT
from .shared import Use, extend_curve, finish_lines, make_hardening, read_points, start_law, tangent_to_hardening

POWER_ROWS = 31
MOST_STRAIN = 2.0


def gurson(deck: KeywordDeck, card: Card, use: Use) -> Deck:
    reader = card.reader()
    row, more = reader.row("MID RO E PR SIGY N Q1 Q2"), reader.row("FC F0 EN SN FN ETAN ATYP FF0")
    points = read_points(reader, EIGHT, EIGHT)
    sizes, last = (reader.row("L1 L2 L3 L4 FF1 FF2 FF3 FF4"),
                   reader.row("LCSS LCFF NUMINT~output LCF0 LCFC LCFN VGTYP DEXP~output"))
    law = start_law(row, "gurson")
    id, kind = last.integer("LCSS"), more.integer("ATYP")
    if id in deck.tables:
        deck.ledger.refuse(f"{card.keyword}.LCSS", last.place, "a table of curves", "its first curve is used")
        id = deck.tables[id][0][1]
    law["hardening"] = make_hardening(deck, deck.material_curve(id, last.place, "none", "stress"), card.keyword,
                                      last.place) if id else []
    law["hardening"] = law["hardening"] or harden(deck, card, row, more, kind, points if kind == 3 else [])
    for name in ("SIGY", "N"):
        row.skip(name)
    more.skip("ETAN")
    q1, q2 = row.positive("Q1"), row.positive("Q2")
    law |= {"q1": q1, "q2": q2, "q3": q1 * q1, "void_fraction": more.number("F0")}
    add_limits(law, more)
    if law["void_fraction"] > 0 and last.integer("VGTYP") != 2:
        deck.ledger.approximated(f"{card.keyword}.VGTYP", last.place,
                                 "in compression voids close below F0, as with VGTYP of 2")
    last.skip("VGTYP")
    for line in (row, more, sizes, last):
        line.finish(deck.ledger, "it is left out")
    finish_lines(deck, card, reader)
    return law


def harden(deck: KeywordDeck, card: Card, row: Row, more: Row, kind: int, points: Points) -> list[list[float]]:
    """ATYP: 0 none, 1 a power law, 2 a tangent modulus, 3 rows."""
    stress, e = row.positive("SIGY"), row.positive("E")
    if kind == 1:
        start, exponent = stress / e, 1 / row.positive("N")
        deck.ledger.approximated(f"{card.keyword}.N", row.place,
                                 f"the power law by {POWER_ROWS} rows up to a plastic strain of {MOST_STRAIN:g}")
        strains = [MOST_STRAIN * (i / (POWER_ROWS - 1)) ** 3 for i in range(POWER_ROWS)]
        return [[p, stress * ((start + p) / start) ** exponent] for p in strains]
    if kind == 2:
        slope = tangent_to_hardening(row, e, more.number("ETAN"))
        return [list(point) for point in extend_curve([(0.0, stress), (1.0, stress + slope)])]
    if kind not in (0, 3):
        deck.ledger.refuse(f"{card.keyword}.ATYP", more.place, f"ATYP of {kind}", "there is no hardening")
    return make_hardening(deck, points, card.keyword, more.place) or [[0.0, stress]]


def add_limits(law: Deck, more: Row) -> None:
    """Nucleation, the critical void fraction and that of failure."""
    strain, deviation, fraction = more.numbers("EN", "SN", "FN")
    if fraction:
        if deviation <= 0 or strain < 0 or not 0 < fraction < 1:
            more.fail("FN", "with EN and SN is not a normal distribution of voids")
        law |= {"nucleation_strain": strain, "nucleation_deviation": deviation, "nucleation_fraction": fraction}
    critical, failing = more.number("FC") or 1.0, more.number("FF0") or 1.0
    if not law["void_fraction"] < critical <= 1 or not (critical < failing <= 1 or critical == 1):
        raise BadInput(more.place, "F0, FC and FF0 must ascend, up to 1: correct them")
    law |= {"critical_void_fraction": critical, "failure_void_fraction": failing}


VOIDS = {"GURSON": gurson}
