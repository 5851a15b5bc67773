"""*DEFINE_CURVE and its like."""

from ..curves import Curve, Points, interpolate, order_points
from ..fields import Row
from ..ledger import BadInput
from .cards import Card
from .deck import KeywordDeck

CURVES = "curves or tables"  # that have ids of one kind


def read_curve(deck: KeywordDeck, card: Card) -> None:
    """Points SF (A + OFF)."""
    reader = card.reader()
    if card.has_title:
        reader.take()
    row = reader.row("LCID SIDR SFA=1 SFO=1 OFFA OFFO DATTYP LCINT~sampling")
    id, offset_a, offset_o = row.integer("LCID"), row.number("OFFA"), row.number("OFFO")
    scale_a, scale_o = row.number("SFA") or 1.0, row.number("SFO") or 1.0
    points: Points = []
    while reader.holds_more():  # a blank line is the point 0, 0
        point = reader.row("A O", (20, 20))
        points.append((scale_a * (point.number("A") + offset_a), scale_o * (point.number("O") + offset_o)))
        check_ascent(point, "A", [x for x, _ in points[-2:]], scale_a)
    if id < 1:
        row.fail("LCID", "an id is expected")
    if not points:
        raise BadInput(row.place, f"curve {id} has no points: add rows, or remove what refers to it")
    deck.ids.claim(CURVES, id, row.place)
    if row.integer("DATTYP") not in (0, 1, -100) or row.integer("DATTYP") == 1 and (offset_a or offset_o):
        deck.ledger.refuse("DEFINE_CURVE.DATTYP", row.place, f"DATTYP is {row.integer('DATTYP')}",
                           "the rows are taken as they are")
    deck.curves[id] = Curve(row.place, order_points(points), relaxation=row.integer("SIDR"), units=card.change.factors,
                            rows=points)
    row.finish(deck.ledger)
    deck.ledger.translated(card.keyword, row.place, "a table where something uses it")
    if deck.waiting_table:
        table, value = deck.waiting_table.pop(0)
        deck.tables.setdefault(table, []).append((value, id))


def check_ascent(row: Row, field: str, values: list[float], factor: float) -> None:
    """The last two abscissae of a curve, or values of a table, as they count."""
    if len(values) > 1 and values[-1] < values[-2]:
        scaled = f" after SFA, which is {factor:g}" if factor < 0 else ""
        row.fail(field, "abscissae of a curve, and values of a table, "
                        f"must ascend{scaled}: {values[-1]:g} follows {values[-2]:g}")


def read_smooth_curve(deck: KeywordDeck, card: Card) -> None:
    """A velocity that rises, stays and falls, with a given distance under it."""
    reader = card.reader()
    if card.has_title:
        reader.take()
    row = reader.row("LCID SIDR DIST TSTART TEND TRISE VMAX")
    distance, start, end, rise, largest = row.numbers("DIST", "TSTART", "TEND", "TRISE", "VMAX")
    if not end and largest:
        end = start + rise + distance / largest
    if end - start - rise <= 0 or rise <= 0:
        row.fail("TEND", "TEND must be above TSTART + TRISE")
    value = largest or distance / (end - start - rise)
    up = f"(1 - cos(pi * (t - {start!r}) / {rise!r})) / 2"
    down = f"(1 - cos(pi * ({end!r} - t) / {rise!r})) / 2"
    inside = f"(t < {start + rise!r} ? {value!r} * {up} : (t > {end - rise!r} ? {value!r} * {down} : {value!r}))"
    text = f"(t <= {start!r} || t >= {end!r}) ? 0 : {inside}"
    deck.ids.claim(CURVES, row.integer("LCID"), row.place)
    deck.curves[row.integer("LCID")] = Curve(row.place, expression=text, relaxation=row.integer("SIDR"))
    deck.ledger.approximated(card.keyword, row.place, "rise and fall by half a cosine")


def check_relaxation(deck: KeywordDeck) -> None:
    """percuss relaxes with the values of all loads at time 0: those of SIDR = 1 are not among them,
    those of SIDR = 0 should not be."""
    if "relaxation" not in deck.model.deck.get("start", {}) or "preload" in deck.model.deck["start"]:
        return
    for curve in (*deck.curves.values(), *deck.converted_curves.values()):
        if not curve.is_of_time or curve.relaxation not in (0, 1):
            continue
        if curve.relaxation == 1:
            deck.ledger.refuse("DEFINE_CURVE.SIDR", curve.place,
                               "a load of dynamic relaxation alone", "it does not act")
        elif curve.expression or interpolate(curve.points, 0.0):
            deck.ledger.refuse("DEFINE_CURVE.SIDR", curve.place, "a load that begins after dynamic relaxation",
                               "its value at time 0 acts in it")


def read_table(deck: KeywordDeck, card: Card) -> None:
    """*DEFINE_TABLE, whose curves stand behind it, and _2D, which names them."""
    reader = card.reader()
    if card.has_title:
        reader.take()
    row = reader.row("TBID SFA=1 OFFA")
    id, scale, offset = row.integer("TBID"), row.number("SFA") or 1.0, row.number("OFFA")
    deck.ids.claim(CURVES, id, row.place)
    deck.waiting_table = []
    values: list[float] = []
    deck.units_of_tables[id] = card.change.factors
    while reader.holds_more():
        point = reader.row("VALUE LCID", (20, 20))
        value = scale * (point.number("VALUE") + offset)
        values.append(value)
        check_ascent(point, "VALUE", values[-2:], scale)
        if point.integer("LCID"):
            deck.tables.setdefault(id, []).append((value, point.integer("LCID")))
        else:
            deck.waiting_table.append((id, value))
    deck.ledger.translated(card.keyword, row.place, "curves for several rates, where a law uses it")


def read_other_curve(deck: KeywordDeck, card: Card) -> None:
    if card.keyword in ("DEFINE_FUNCTION", *(f"DEFINE_CURVE_{kind}"
                                             for kind in ("DUPLICATE", "ENTITY", "FEEDBACK", "FUNCTION", "STRESS"))):
        reader = card.reader()
        if card.has_title:
            reader.take()
        row = reader.row("LCID")
        deck.ids.claim(CURVES, row.integer("LCID"), row.place)
    deck.ledger.ignored(card.keyword, card.place, "not read; a card that uses it is refused")
