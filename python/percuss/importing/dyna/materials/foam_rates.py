"""Foam with curves for several rates: *MAT_FU_CHANG_FOAM with a table."""

import math

from ...curves import Points, order_points, thin_rows
from ...fields import Row
from ...ledger import BadInput
from ...model import Deck
from ...rates import MOST_RATES, MOST_ROWS, Curves, thin_curves
from ..cards import Card
from ..deck import KeywordDeck
from ..dimensions import SAME, scale
from .shared import Use, finish_lines, note_viscosity

LEFT_OUT = "the parts made of it are left out"
NEVER = 1e19  # a TC that nothing reaches


def fu_chang_foam(deck: KeywordDeck, card: Card, use: Use) -> Deck | None:
    """Curves of nominal stress, positive in compression. Cards 3 and 4 have the constants of a fit, and SHAPE."""
    reader = card.reader()
    row = reader.row("MID RO E KCON~penalty TC=1e20 FAIL DAMP TBID")
    more = reader.row("BVFLAG~default SFLAG RFLAG TFLAG PVID SRAF~averaging REF~absent HU")
    reader.row(" ".join(f"{name}~unused" for name in "D0 N0 N1 N2 N3 C0 C1 C2".split()))
    shape = reader.row("C3~unused C4~unused C5~unused AIJ~unused SIJ~unused MINR MAXR SHAPE=1")
    release = reader.row("EXPON=1 RIULD~unused")
    row.skip("MID")
    id = row.integer("TBID")
    if id <= 0:
        deck.ledger.refuse(f"{card.keyword}.TBID", row.place, "constants of a fit (TBID not above 0)", LEFT_OUT)
        return None
    pulls = read_tension(more)
    curves, is_log = list_curves(deck, row, id, pulls)
    law: Deck = {"model": "rate_table_foam", "density": row.positive("RO"), "youngs_modulus": row.positive("E"),
                 "compression_at_rates": thin(deck, card, row, curves, is_log)}  # fmt: skip
    if is_log:
        law["rate_interpolation"] = "logarithmic"
    read_rates(deck, card, more, law)
    read_release(more, shape, release, law)
    read_cutoff(deck, card, row, law, pulls)
    note_viscosity(deck, row, "DAMP")
    for name in ("MINR", "MAXR"):
        if shape.number(name):
            deck.ledger.ignored(f"{card.keyword}.{name}", shape.place,
                                "MINR and MAXR: the stress is constant outside the rates of the table")
    for found, instead in ((row, ""), (more, "it does not act"), (shape, ""), (release, "")):
        found.finish(deck.ledger, instead or "it is left out")
    finish_lines(deck, card, reader)
    return law


def read_tension(more: Row) -> bool:
    """Whether the curves have tension."""
    flag = more.integer("TFLAG")
    if flag not in (0, 1):
        more.fail("TFLAG", "0 or 1 is expected")
    return flag == 1


def read_rates(deck: KeywordDeck, card: Card, more: Row, law: Deck) -> None:
    if more.integer("SFLAG") not in (0, 1):
        more.fail("SFLAG", "0 or 1 is expected")
    if more.integer("RFLAG") not in (0, 1, 2):
        more.fail("RFLAG", "0, 1 or 2 is expected")
    if more.integer("SFLAG") == 1:
        law["rate_measure"] = "engineering"
    if more.integer("RFLAG") == 2:
        law["rate_of"] = "volume"
    text = "the rate is not averaged; the stress moves from one curve to another with a slope of at least E"
    if more.integer("RFLAG") == 0:
        text += "; each principal direction has its own rate (RFLAG 0: that of the first)"
    deck.ledger.approximated(card.keyword, card.place, text)


def read_release(more: Row, shape: Row, release: Row, law: Deck) -> None:
    """HU 0 unloads along the curve of the lowest rate."""
    share, exponent = more.number("HU"), release.number("EXPON") or 1.0
    if not 0 <= share <= 1:
        more.fail("HU", "from 0 to 1 is expected")
    if 0 < share < 1:
        if exponent < 1:
            release.fail("EXPON", "1 or more is expected")
        law |= {"hysteretic_unloading": share, "unloading_shape": shape.number("SHAPE") or 1.0}
        if exponent != 1:
            law["unloading_exponent"] = exponent
    shape.skip("SHAPE")


def read_cutoff(deck: KeywordDeck, card: Card, row: Row, law: Deck, pulls: bool) -> None:
    limit, fails = row.number("TC"), row.integer("FAIL")
    if not 0 < limit < NEVER:
        return
    if fails not in (0, 1):
        deck.ledger.refuse(f"{card.keyword}.FAIL", row.place, f"FAIL = {fails}: elements that erode at TC",
                           "the tensile stress stays at TC")
        fails = 0
    if pulls:
        if fails or limit < max(-y for _, rows in law["compression_at_rates"] for _, y in rows):
            deck.ledger.refuse(f"{card.keyword}.TC", row.place,
                               "TC beside curves with tension (TFLAG 1)", "there is no limit")
        return
    law["tension_cutoff"] = limit
    if fails:
        law["after_cutoff"] = "none"


def list_curves(deck: KeywordDeck, row: Row, id: int, pulls: bool) -> tuple[Curves, bool]:
    """The curves by their rates; rates are logarithms where the first is negative. One curve alone is for all rates."""
    table = deck.tables.get(id) or [(0.0, id)]
    is_log, unit = table[0][0] < 0, scale("rate", deck.units_of_tables.get(id, SAME))
    curves = sorted(
        (unit * (math.exp(min(value, 700.0)) if is_log else value), read_curve(deck, row, curve, pulls))
        for value, curve in table
    )
    for (low, _), (high, _) in zip(curves, curves[1:]):
        if low == high:
            raise BadInput(row.place, f"two curves are for the rate {high:g} (rates must differ): remove one")
    if curves[0][0] < 0:
        raise BadInput(row.place, f"a curve is for the rate {curves[0][0]:g} (rates must not be negative): correct it")
    curves[0] = (curves[0][0], raise_falls(deck, row, curves[0][1]))
    return curves, is_log


def read_curve(deck: KeywordDeck, row: Row, id: int, pulls: bool) -> Points:
    """Rows in compression, and those in tension where they count, with [0, 0]."""
    points = order_points(deck.material_curve(id, row.place, "none", "stress"))
    down, up = [p for p in points if p[0] < 0] if pulls else [], [p for p in points if p[0] > 0]
    if not up or (pulls and not down):
        raise BadInput(row.place, f"curve {id} has no strain above 0 "
                                  f"(compression){' or none below it (tension)' if pulls else ''}: complete it")
    if min(y for _, y in up) < 0 or max((y for _, y in down), default=0.0) > 0:
        raise BadInput(row.place, f"a stress of curve {id} has not the sign of its strain: correct its rows")
    return [*down, (0.0, 0.0), *up]


def raise_falls(deck: KeywordDeck, row: Row, points: Points) -> Points:
    """The curve of the lowest rate, whose stress must not fall."""
    rows, highest = [], -math.inf
    for x, y in points:
        highest = max(highest, y)
        rows.append((x, highest))
    if rows != points:
        change = max(abs(a[1] - b[1]) for a, b in zip(rows, points)) / max(abs(y) for _, y in points)
        deck.ledger.approximated(f"{row.card}.curve", row.place, "where the curve of the lowest rate falls it is "
                                                                 f"level, within {change:.2g} of the largest stress")
    return rows


def thin(deck: KeywordDeck, card: Card, row: Row, curves: Curves,
         is_log: bool) -> list[list[float | list[list[float]]]]:
    """At most as many rates and rows as percuss takes; [0, 0] stays."""
    if curves[0][1][0][0] < 0:
        if len(curves) > MOST_RATES:
            raise BadInput(row.place, f"the table has {len(curves)} rates with rows of tension "
                                      f"(percuss takes {MOST_RATES}): remove some")
        side, error = MOST_ROWS // len(curves) // 2, 0.0
        kept = []
        for rate, points in curves:
            middle = points.index((0.0, 0.0))
            (below, first), (above, second) = thin_rows(points[: middle + 1], side), thin_rows(points[middle:], side)
            kept.append((rate, [*below, *above[1:]]))
            error = max(error, first, second)
    else:
        kept, error = thin_curves(curves, is_log)
    if error > 1e-12:
        count = sum(len(rows) for _, rows in kept)
        deck.ledger.approximated(f"{card.keyword}.table", row.place, f"curves become {len(kept)} with {count} rows in "
                                                                     f"all, within {error:.2g} of the largest stress")
    return [[rate, [list(point) for point in rows]] for rate, rows in kept]


FOAM_RATES = {"FU_CHANG_FOAM": fu_chang_foam}
