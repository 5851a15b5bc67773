"""Soil, foam and honeycomb."""

import math

from ...curves import Points, order_points, thin_rows
from ...fields import Row
from ...ledger import BadInput
from ...model import Deck
from ..cards import Card, Lines
from ..deck import KeywordDeck
from .shared import Use, finish_lines, note_viscosity, scale_stresses

NO_TENSION = 1e-9  # share of Young's modulus: TSC of 0
LINE = 64  # rows of a line over a logarithm, before they are thinned
EIGHT, TWO = " ".join("ABCDEFGH"), "I J"


def soil_and_foam(deck: KeywordDeck, card: Card, use: Use) -> Deck | None:
    """J2 = A0 + A1 p + A2 p^2 in LS-DYNA, von Mises stress = a0 + a1 p + a2 p^2 in percuss."""
    reader = card.reader()
    row, more = reader.row("MID RO G BULK A0 A1 A2 PC"), reader.row("VCR REF~absent LCID")
    row.skip("MID")
    points = [(x, y) for x, y in read_soil_points(reader)]
    if more.integer("LCID"):
        points = deck.material_curve(more.integer("LCID"), more.place, "none", "stress")
    a0, a1, a2 = row.numbers("A0", "A1", "A2")
    law: Deck = {
        "model": "soil_and_foam",
        "density": row.positive("RO"),
        "shear_modulus": row.positive("G"),
        "unloading_bulk_modulus": row.positive("BULK"),
    }
    if a1 == 0 and a2 == 0 and a0 >= 0:
        law["a0"] = (3 * a0) ** 0.5
    elif a0 == 0 and a1 == 0 and a2 > 0:
        law |= {"a0": 0.0, "a1": (3 * a2) ** 0.5}
    else:
        deck.ledger.refuse(
            f"{card.keyword}.A1", row.place, "J2 = A0 + A1 p + A2 p^2 with several terms",
            "the parts made of it are left out"
        )
        return None
    law["tension_limit"] = max(-row.number("PC"), 0.0)
    law["compaction"] = make_compaction(deck, card, row, points)
    row.finish(deck.ledger)
    more.finish(deck.ledger)
    return law


def read_soil_points(reader: Lines) -> Points:
    """Ten strains on two lines, ten pressures on two lines."""
    xs = reader.row(EIGHT).numbers(*EIGHT.split()) + reader.row(TWO).numbers(*TWO.split())
    ys = reader.row(EIGHT).numbers(*EIGHT.split()) + reader.row(TWO).numbers(*TWO.split())
    points = list(zip(xs, scale_stresses(reader, ys)))
    while points and points[-1] == (0.0, 0.0):
        points.pop()
    return points


def make_compaction(deck: KeywordDeck, card: Card, row: Row, points: Points) -> list[list[float]]:
    """Pressure over -ln V; LS-DYNA has ln V, below 0 in compression, and takes positive strains too."""
    is_negative = any(x < 0 for x, _ in points)
    points = order_points([(-x if is_negative else x, y) for x, y in points])
    if not points or points[0][0] > 0:
        points = [(0.0, 0.0), *points]
    if len(points) < 2:
        row.fail("BULK", "a curve of pressure is expected below it")
    rows, error = thin_rows(points)
    if error > 1e-12:
        deck.ledger.approximated(f"{card.keyword}.curve", row.place,
                                 f"the curve has {len(rows)} rows, within {error:.2g}")
    return [list(point) for point in rows]


def low_density_foam(deck: KeywordDeck, card: Card, use: Use) -> Deck:
    reader = card.reader()
    row, more = (reader.row("MID RO E LCID TC=1e20 HU=1 BETA DAMP"),
                 reader.row("SHAPE=1 FAIL BVFLAG~default ED BETA1 KCON~penalty REF~absent"))
    row.skip("MID")
    points = [point for point in order_points(deck.material_curve(row.integer("LCID"), row.place, "none", "stress"))
              if point[0] > 0]
    if not points:
        row.fail("LCID", "a curve over strains above 0 is expected")
    points = [(0.0, 0.0), *points]
    rows, error = thin_rows(points)
    if error > 1e-12:
        deck.ledger.approximated(f"{card.keyword}.curve", row.place,
                                 f"the curve has {len(rows)} rows, within {error:.2g}")
    law: Deck = {
        "model": "low_density_foam",
        "density": row.positive("RO"),
        "youngs_modulus": row.positive("E"),
        "compression": [list(r) for r in rows],
    }
    if row.number("HU") != 1:
        law |= {"hysteretic_unloading": row.number("HU"), "unloading_shape": more.number("SHAPE") or 1.0}
    more.skip("SHAPE")
    note_viscosity(deck, row, "DAMP")
    if 0 < row.number("TC") < law["youngs_modulus"]:
        limit_foam(deck, card, row, more, law)
    more.skip("FAIL")  # what happens at TC
    row.finish(deck.ledger)
    more.finish(deck.ledger)
    finish_lines(deck, card, reader)
    return law


def limit_foam(deck: KeywordDeck, card: Card, row: Row, more: Row, law: Deck) -> None:
    """TC limits the tensile stress, in the law with rates, whose one curve is for all; FAIL says what is left."""
    law |= {"model": "rate_table_foam", "compression_at_rates": [[0.0, law.pop("compression")]],
            "tension_cutoff": row.number("TC")}
    fails = more.integer("FAIL")
    if fails == 1:
        law["after_cutoff"] = "none"
    elif fails:
        deck.ledger.refuse(f"{card.keyword}.FAIL", more.place, f"FAIL = {fails}: elements that erode at TC",
                           "the tensile stress stays at TC")


def crushable_foam(deck: KeywordDeck, card: Card, use: Use) -> Deck:
    """Stress over the volumetric strain 1 - V, the same in all directions: a honeycomb with equal curves."""
    row = card.reader().row("MID RO E PR LCID TSC DAMP")
    row.skip("MID")
    youngs = row.positive("E")
    points = [(x, y) for x, y in order_points(deck.material_curve(row.integer("LCID"), row.place, "none", "stress"))
              if y > 0 and x >= 0]
    if not points:
        row.fail("LCID", "a curve with stresses above 0 is expected")
    rows = [list(point) for point in thin_rows(points)[0]]
    deck.ledger.approximated(
        card.keyword,
        row.place,
        "a honeycomb with the same curve in all directions, compacted at the end of the curve; "
        "pulled back it is elastic up to TSC",
    )
    crush = {f"crush_{name}": rows for name in ("xx", "yy", "zz", "xy", "yz", "zx")}
    law = {"model": "honeycomb", "density": row.positive("RO"), "youngs_modulus": youngs, "poissons_ratio": 0.0,
           "yield_stress": max(y for _, y in points), "compacted_volume": min(max(1 - points[-1][0], 0.01), 0.99),
           "crush_moduli": [youngs] * 3, "shear_moduli": [youngs / 2] * 3, **crush,
           "tension_cutoff": row.not_negative("TSC") or NO_TENSION * youngs}  # fmt: skip
    row.skip("PR")
    note_viscosity(deck, row, "DAMP")
    return law


def honeycomb(deck: KeywordDeck, card: Card, use: Use) -> Deck | None:
    """*MAT_HONEYCOMB and _MODIFIED_HONEYCOMB: six curves over the crush or the strain;
    the axes of percuss are those of space."""
    reader = card.reader()
    row, curves = reader.row("MID RO E PR SIGY VF MU BULK~default"), reader.row("LCA LCB LCC LCS LCAB LCBC LCCA LCSR")
    moduli, axes, plane = (reader.row("EAAU EBBU ECCU GABU GBCU GCAU AOPT MACF=1"),
                           reader.row("XP YP ZP A1 A2 A3 RFAC~unused PRU"),
                           reader.row("D1 D2 D3 TSEF SSEF VREF TREF SHDFLG~unused"))
    row.skip("MID")
    first, second, third, shear = (curves.integer(name) for name in ("LCA", "LCB", "LCC", "LCS"))
    ids = [first, second or first, third or first,
           *(curves.integer(name) or shear or first for name in ("LCAB", "LCBC", "LCCA"))]
    is_along = axes.numbers("A1", "A2", "A3") == [1, 0, 0] and plane.numbers("D1", "D2", "D3") == [0, 1, 0]
    if moduli.number("AOPT") != 2 or not is_along or any(id in deck.solid_axes for id, _ in use.solids):
        deck.ledger.refuse(
            f"{card.keyword}.AOPT", moduli.place, "material axes other than the global axes", "the global axes are used"
        )
    law: Deck = {
        "model": "honeycomb",
        "density": row.positive("RO"),
        "youngs_modulus": row.positive("E"),
        "poissons_ratio": row.number("PR"),
    }
    law |= {"yield_stress": row.positive("SIGY"), "compacted_volume": row.positive("VF")}
    law |= {"crush_moduli": moduli.numbers("EAAU", "EBBU", "ECCU"),
            "shear_moduli": moduli.numbers("GABU", "GBCU", "GCAU")}
    read = read_strains if card.keyword == "MAT_MODIFIED_HONEYCOMB" else read_crush
    for name, id in zip(("xx", "yy", "zz", "xy", "yz", "zx"), ids):
        law[f"crush_{name}"] = read(deck, card, curves, id, use, name)
    note_viscosity(deck, row, "MU")
    for found, instead in ((row, ""), (curves, "the strength does not depend on it"), (moduli, ""), (axes, ""),
                           (plane, "nothing fails")):
        found.finish(deck.ledger, instead or "it is left out")
    finish_lines(deck, card, reader)
    return law


def read_strains(deck: KeywordDeck, card: Card, row: Row, id: int, use: Use, name: str) -> list[list[float]]:
    """Strength of *MAT_126 over the strain of its own direction, positive in compression: engineering strains where the
    element is corotational, else logarithms. Where one direction crushes alone, its strain gives the crush 1 - V;
    a shear strain does not."""
    if id < 0:
        deck.ledger.refuse(f"{card.keyword}.angle", row.place, "curves below 0: strength by the angle off the axis",
                           "the curve of that id is used over the strain")
    points = order_points(deck.material_curve(abs(id), row.place, "none", "stress"))
    if name in ("xy", "yz", "zx"):
        if len({y for _, y in points}) > 1:
            deck.ledger.refuse(f"{card.keyword}.LCS", row.place, "a shear strength that changes with the shear strain",
                               "it changes with the crush")
    else:
        text = "the strain of a direction is taken as the crush 1 - V: right where one direction crushes at a time"
        deck.ledger.approximated(f"{card.keyword}.LCA", row.place, text)
        if not use.is_corotational:
            points = [(1 - math.exp(-x), y) for x, y in refine(points)]
    return make_crush(deck, card, row, id, [point for point in points if point[0] >= 0] or points[-1:])


def refine(points: Points) -> Points:
    """More rows on the same lines."""
    between = [(a[0] + i / LINE * (b[0] - a[0]), a[1] + i / LINE * (b[1] - a[1])) for a, b in zip(points, points[1:])
               for i in range(LINE)]
    return [*between, points[-1]]


def read_crush(deck: KeywordDeck, card: Card, row: Row, id: int, use: Use, name: str) -> list[list[float]]:
    """Strength over the crush 1 - V; a curve over V ends at 1 and falls."""
    points = order_points(deck.material_curve(id, row.place, "none", "stress"))
    if points[-1][0] == 1.0 and points[0][1] > points[-1][1]:
        points = order_points([(1 - x, y) for x, y in points])
    return make_crush(deck, card, row, id, points)


def make_crush(deck: KeywordDeck, card: Card, row: Row, id: int, points: Points) -> list[list[float]]:
    """Rows of a deck."""
    points = [(x, y) for x, y in points if y > 0]
    if not points:
        raise BadInput(row.place, f"curve {id} has no strength above 0: correct its rows")
    rows, error = thin_rows(points)
    if error > 1e-12:
        deck.ledger.approximated(f"{card.keyword}.curve", row.place,
                                 f"the curve has {len(rows)} rows, within {error:.2g}")
    return [list(point) for point in rows]


CRUSHABLE = {
    "HONEYCOMB": honeycomb,
    "MODIFIED_HONEYCOMB": honeycomb,
    "SOIL_AND_FOAM": soil_and_foam,
    "SOIL_AND_FOAM_FAILURE": soil_and_foam,
    "LOW_DENSITY_FOAM": low_density_foam,
    "CRUSHABLE_FOAM": crushable_foam,
}
