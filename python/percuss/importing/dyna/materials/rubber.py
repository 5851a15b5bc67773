"""Rubber by principal stretches, and relaxation in shear and volume."""

from ...curves import Points, interpolate, order_points, thin_rows
from ...fields import Row
from ...laws import make_mooney_rivlin
from ...ledger import BadInput
from ...model import Deck
from ..cards import Card, Lines
from ..deck import KeywordDeck
from .shared import Use, finish_lines, note_viscosity

LEFT_OUT = "the parts made of it are left out"
EIGHT = range(1, 9)
MOST_RELAXATIONS = 6
ROUND_OFF = 1e-9  # share of the largest strain of a curve
MOST_SIDE = 16  # rows of a curve in compression, and in tension


def ogden(deck: KeywordDeck, card: Card, use: Use) -> Deck | None:
    """Constants, not test data. K follows from Poisson's ratio and the shear modulus, half the sum of mu alpha."""
    reader = card.reader()
    row = reader.row("MID RO PR N NV~unused G SIGF REF~absent")
    row.skip("MID")
    if row.integer("N"):
        deck.ledger.refuse(f"{card.keyword}.N", card.place, "rubber fitted to test data (N above 0)", LEFT_OUT)
        return None
    moduli, exponents = reader.row(" ".join(f"MU{i}" for i in EIGHT)), reader.row(" ".join(f"ALPHA{i}" for i in EIGHT))
    terms: dict[float, float] = {}
    for i in EIGHT:
        mu, alpha = moduli.number(f"MU{i}"), exponents.number(f"ALPHA{i}")
        if mu and not alpha:
            exponents.fail(f"ALPHA{i}", "an exponent other than 0 is expected beside a modulus")
        if mu:
            terms[alpha] = terms.get(alpha, 0.0) + mu
    shear, ratio = 0.5 * sum(alpha * mu for alpha, mu in terms.items()), row.number("PR")
    if shear <= 0:
        moduli.fail("MU1", "constants with a shear modulus, half the sum of mu alpha, above 0 are expected")
    if not 0 < ratio < 0.5:
        row.fail("PR", "between 0 and 0.5 is expected")
    refuse_relaxing(deck, card, reader)
    deck.ledger.approximated(card.keyword, card.place, "the same constants, with percuss' term of volume")
    law: Deck = {"model": "ogden", "density": row.positive("RO"),
                 "terms": [[alpha, terms[alpha]] for alpha in sorted(terms)],
                 "bulk_modulus": 2 * shear * (1 + ratio) / (3 * (1 - 2 * ratio))}  # fmt: skip
    row.finish(deck.ledger)
    finish_lines(deck, card, reader)
    return law


def hyperelastic(deck: KeywordDeck, card: Card, use: Use) -> Deck | None:
    """A polynomial of I1 - 3 and I2 - 3, where it is that of Mooney and Rivlin or of Yeoh."""
    reader = card.reader()
    row = reader.row("MID RO PR N NV~unused G SIGF REF~absent")
    row.skip("MID")
    if row.integer("N"):
        deck.ledger.refuse(f"{card.keyword}.N", card.place, "rubber fitted to test data (N above 0)", LEFT_OUT)
        return None
    more = reader.row("C10 C01 C11 C20 C02 C30 THERML~thermal")
    c10, c01, c11, c20, c02, c30 = more.numbers("C10", "C01", "C11", "C20", "C02", "C30")
    ratio, shear = row.number("PR"), 2 * (c10 + c01)
    if c11 or c02 or (c01 and (c20 or c30)):
        text = ("products and squares of I2 - 3, or I2 beside powers of I1 - 3 "
                "(percuss has C10 and C01, or C10, C20 and C30)")
        deck.ledger.refuse(f"{card.keyword}.C11", more.place, text, LEFT_OUT)
        return None
    if shear <= 0:
        more.fail("C10", "constants with a shear modulus, 2 (C10 + C01), above 0 are expected")
    if not 0 < ratio < 0.5:
        row.fail("PR", "between 0 and 0.5 is expected")
    refuse_relaxing(deck, card, reader)
    deck.ledger.approximated(card.keyword, card.place, "the same constants, with percuss' term of volume")
    law: Deck = {"model": "yeoh", "c10": c10, "c20": c20, "c30": c30} if c20 or c30 else make_mooney_rivlin(c10, c01)
    law |= {"density": row.positive("RO"), "bulk_modulus": 2 * shear * (1 + ratio) / (3 * (1 - 2 * ratio))}
    row.finish(deck.ledger)
    more.finish(deck.ledger)
    finish_lines(deck, card, reader)
    return law


def refuse_relaxing(deck: KeywordDeck, card: Card, reader: Lines) -> None:
    """Prony terms below rubber."""
    while reader.holds_more():
        row = reader.row("GI BETAI VFLAG~unused")
        if row.number("GI") and row.number("BETAI") >= 0:
            deck.ledger.refuse(f"{card.keyword}.GI", row.place, "rubber that relaxes", "it does not relax")


def simplified_rubber(deck: KeywordDeck, card: Card, use: Use) -> Deck | None:
    """One curve of force over the change of a gauge length, for rubber (PR 0)."""
    reader = card.reader()
    row, more = (reader.row("MID RO KM MU G SIGF REF~absent PRTEN"),
                 reader.row("SGL=1 SW=1 ST=1 TBID TENSION~unused RTYPE~unused AVGOPT~unused PR"))
    row.skip("MID")
    if more.integer("TBID") in deck.tables:
        deck.ledger.refuse(f"{card.keyword}.TBID", more.place, "curves for several rates", LEFT_OUT)
        return None
    if more.number("PR"):
        deck.ledger.refuse(f"{card.keyword}.PR", more.place,
                           "PR: a compressible foam, or rubber with a viscous stress", LEFT_OUT)
        return None
    length, area = more.positive("SGL"), more.positive("SW") * more.positive("ST")
    points = [(x / length, y / area)
              for x, y in order_points(deck.material_curve(more.integer("TBID"), more.place, "length", "force"))]
    rows = make_uniaxial(deck, card, more, points)
    note_viscosity(deck, row, "MU")
    deck.ledger.approximated(card.keyword, card.place, "the same curve and bulk modulus, with percuss' term of volume")
    law: Deck = {"model": "tabulated_rubber", "density": row.positive("RO"),
                 "uniaxial": [list(point) for point in rows], "bulk_modulus": row.positive("KM")}
    if reader.holds_more():
        refuse_unloading(deck, card, reader)
    row.finish(deck.ledger)
    more.finish(deck.ledger)
    finish_lines(deck, card, reader)
    return law


def refuse_unloading(deck: KeywordDeck, card: Card, reader: Lines) -> None:
    row = reader.row("LCUNLD HU=1 SHAPE=1 STOL~unused VISCO~unused HISOUT~output")
    if row.integer("LCUNLD") or row.number("HU") != 1 or row.number("SHAPE") != 1:
        deck.ledger.refuse(f"{card.keyword}.LCUNLD", row.place, "LCUNLD, HU, SHAPE: another curve of unloading",
                           "it unloads on the curve of loading")


def make_uniaxial(deck: KeywordDeck, card: Card, row: Row, points: Points) -> Points:
    """Rows in compression and tension with [0, 0] between them; a strain that is 0 but for round-off is that row."""
    least = ROUND_OFF * max((abs(x) for x, _ in points), default=0.0)
    down, up = [p for p in points if p[0] < -least], [p for p in points if p[0] > least]
    if not down or not up or min(y for _, y in up) <= 0 or max(y for _, y in down) >= 0 or down[0][0] <= -1:
        raise BadInput(row.place, "the curve of rubber must be in compression "
                                  "(both negative, strains above -1) and in tension (both positive): complete it")
    if abs(interpolate(points, 0.0)) > 1e-6 * max(abs(y) for _, y in points):
        raise BadInput(row.place, "the curve of rubber has a stress without a strain: let it go through 0")
    (below, first), (above, second) = thin_rows([*down, (0.0, 0.0)], MOST_SIDE), thin_rows([(0.0, 0.0), *up], MOST_SIDE)
    if max(first, second) > 1e-12:
        text = f"the curve has {len(below) + len(above) - 1} rows, within {max(first, second):.2g}"
        deck.ledger.approximated(f"{card.keyword}.curve", row.place, text)
    return [*below, *above[1:]]


def general_viscoelastic(deck: KeywordDeck, card: Card, use: Use) -> Deck | None:
    """Prony terms of shear and volume; a term without decay is the long-term modulus."""
    reader = card.reader()
    row, fit = (reader.row("MID RO BULK PCF EF TREF~thermal A B"),
                reader.row("LCID NT~unused BSTART~unused TRAMP~unused LCIDK NTK~unused BSTARTK~unused TRAMPK~unused"))
    row.skip("MID")
    if fit.integer("LCID") or fit.integer("LCIDK"):
        deck.ledger.refuse(f"{card.keyword}.LCID", fit.place, "LCID, LCIDK: relaxation fitted to a curve", LEFT_OUT)
        return None
    shear: dict[float, float] = {}
    bulk: dict[float, float] = {}
    while reader.skip_blank():
        add_terms(reader.row("GI BETAI KI BETAKI"), shear, bulk)
    law: Deck = {"model": "viscoelastic", "density": row.positive("RO"), "bulk_modulus": bulk.pop(0.0, 0.0) if bulk
                 else row.positive("BULK"), "long_term_shear_modulus": shear.pop(0.0, 0.0)}  # fmt: skip
    row.skip("BULK")
    if max(len(shear), len(bulk)) > MOST_RELAXATIONS or (not shear and not bulk) or law["bulk_modulus"] <= 0:
        text = (f"{len(shear)} terms of shear and {len(bulk)} of volume that decay "
                f"(percuss has 1 to {MOST_RELAXATIONS}, and a bulk modulus that stays)")
        deck.ledger.refuse(f"{card.keyword}.GI", card.place, text, LEFT_OUT)
        return None
    for name, terms in (("relaxation", shear), ("bulk_relaxation", bulk)):
        if terms:
            law[name] = sorted([1 / decay, modulus] for decay, modulus in terms.items())
    if bulk and row.number("BULK"):
        deck.ledger.approximated(f"{card.keyword}.BULK", row.place, "the sum of the terms KI in place of BULK")
    row.finish(deck.ledger)
    return law


def add_terms(row: Row, shear: dict[float, float], bulk: dict[float, float]) -> None:
    """Moduli by their decay; those of one decay are one."""
    for modulus, decay, terms in (("GI", "BETAI", shear), ("KI", "BETAKI", bulk)):
        if row.number(modulus) < 0 or row.number(decay) < 0:
            row.fail(modulus, "a modulus and a decay that are not below 0 are expected")
        if row.number(modulus):
            terms[row.number(decay)] = terms.get(row.number(decay), 0.0) + row.number(modulus)


RUBBER = {"OGDEN_RUBBER": ogden, "HYPERELASTIC_RUBBER": hyperelastic, "SIMPLIFIED_RUBBER/FOAM": simplified_rubber,
          "GENERAL_VISCOELASTIC": general_viscoelastic}
