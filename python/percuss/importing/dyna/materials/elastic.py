"""Laws without yield: elastic, rubber, relaxation, fluids and explosives."""

from ...fields import Row
from ...laws import make_mooney_rivlin
from ...model import Deck, Vector
from ..cards import Card
from ..deck import KeywordDeck
from .shared import Use, finish_lines, limit_tension, set_failure
from .states import initial_bulk_modulus, translate_state


def elastic(deck: KeywordDeck, card: Card, use: Use) -> Deck:
    reader = card.reader()
    row = reader.row("MID RO E PR DA DB K~unused")  # K is that of a fluid
    row.skip("MID", *([] if use.is_beam else ["DA", "DB"]))
    law = {
        "model": "elastic",
        "density": row.positive("RO"),
        "youngs_modulus": row.positive("E"),
        "poissons_ratio": row.number("PR"),
    }
    row.finish(deck.ledger, "beams have no damping")
    finish_lines(deck, card, reader)
    return law


def elastic_fluid(deck: KeywordDeck, card: Card, use: Use) -> Deck:
    reader = card.reader()
    row, more = reader.row("MID RO E PR DA~absent DB~absent K"), reader.row("VC CP=1e20")
    row.skip("MID")
    bulk = row.number("K") or row.positive("E") / (3 * (1 - 2 * row.number("PR")))
    if bulk <= 0:
        row.fail("K", "must be positive")
    row.skip("E", "PR")
    law: Deck = {"model": "fluid", "density": row.positive("RO"),
                 "equation_of_state": {"kind": "linear", "bulk_modulus": bulk}}
    if more.number("CP") < bulk:
        law["equation_of_state"]["least_pressure"] = -max(more.number("CP"), 0.0)
    row.finish(deck.ledger)
    more.finish(deck.ledger, "there is none")
    finish_lines(deck, card, reader)
    return law


def null(deck: KeywordDeck, card: Card, use: Use) -> Deck | None:
    """A fluid with an equation of state. Shells without one are a skin."""
    reader = card.reader()
    row = reader.row("MID RO PC MU TEROD CEROD YM~absent PR~absent")
    row.skip("MID")
    state = translate_state(deck, use)
    if state is None and use.state:  # which is refused
        return None
    if state is None and use.is_shell:
        skin: Deck = {"model": "skin", "density": row.positive("RO")}
        row.skip("PC", "MU")
        row.finish(deck.ledger, "they do not fail")
        finish_lines(deck, card, reader)
        return skin
    if state is None:
        deck.ledger.refuse(
            f"{card.keyword}.skin",
            card.place,
            "a material without strength and without an equation of state, of other elements than shells",
            "the parts made of it are left out",
        )
        return None
    law: Deck = {"model": "fluid", "density": row.positive("RO"), "equation_of_state": state}
    if row.number("MU"):
        law["viscosity"] = row.number("MU")
    limit_tension(deck, row, law, initial_bulk_modulus(state, law["density"]))
    limit_volume(row, law)
    row.finish(deck.ledger)
    finish_lines(deck, card, reader)
    return law


def limit_volume(row: Row, law: Deck) -> None:
    """TEROD and CEROD: relative volumes beyond which the element is eroded; 0 is none."""
    most, least = row.number("TEROD"), row.number("CEROD")
    if most and most <= 1:
        row.fail("TEROD", "must be above 1, a relative volume in tension, or 0")
    if least < 0 or least >= 1:
        row.fail("CEROD", "must be between 0 and 1, a relative volume in compression")
    set_failure(law, volume_above=most, volume_below=least)


def viscoelastic(deck: KeywordDeck, card: Card, use: Use) -> Deck:
    row = card.reader().row("MID RO BULK G0 GI BETA")
    row.skip("MID")
    start, end, decay = row.numbers("G0", "GI", "BETA")
    law: Deck = {
        "model": "viscoelastic",
        "density": row.positive("RO"),
        "bulk_modulus": row.positive("BULK"),
        "long_term_shear_modulus": end,
    }
    if decay <= 0 or start <= end:
        row.fail("BETA", "a decay above 0 and G0 above GI are expected")
    law["relaxation"] = [[1 / decay, start - end]]
    return law


def blatz_ko(deck: KeywordDeck, card: Card, use: Use) -> Deck:
    row = card.reader().row("MID RO G REF~absent")
    row.skip("MID")
    deck.ledger.approximated(card.keyword, card.place,
                             "neo-Hookean rubber with the same shear modulus and Poisson's ratio 0.463")
    law = {
        "model": "neo_hookean",
        "density": row.positive("RO"),
        "youngs_modulus": 2 * 1.463 * row.positive("G"),
        "poissons_ratio": 0.463,
    }
    row.finish(deck.ledger)
    return law


def mooney_rivlin(deck: KeywordDeck, card: Card, use: Use) -> Deck | None:
    reader = card.reader()
    row, more = reader.row("MID RO PR A B REF~absent"), reader.row("SGL~unused SW~unused ST~unused LCID")
    row.skip("MID")
    ratio, a, b = row.numbers("PR", "A", "B")
    if not more.integer("LCID") and not 0 < ratio < 0.5:
        row.fail("PR", "between 0 and 0.5 is expected")
    if more.integer("LCID") or a <= 0 or a + b <= 0:
        deck.ledger.refuse(
            f"{card.keyword}.LCID",
            card.place,
            "rubber fitted to a curve, or without A and A + B above 0",
            "the parts made of it are left out",
        )
        return None
    deck.ledger.approximated(card.keyword, card.place, "the same constants, with percuss' term of volume")
    law = make_mooney_rivlin(a, b)
    law |= {"density": row.positive("RO"), "bulk_modulus": 4 * (a + b) * (1 + ratio) / (3 * (1 - 2 * ratio))}
    row.finish(deck.ledger)
    return law


def arruda_boyce(deck: KeywordDeck, card: Card, use: Use) -> Deck | None:
    """N links of a chain: it is straight at a stretch of their square root."""
    reader = card.reader()
    row, more = reader.row("MID RO K G N"), reader.row("LCID TRAMP~unused NT")
    row.skip("MID")
    if more.integer("LCID") or more.integer("NT"):
        deck.ledger.refuse(f"{card.keyword}.LCID", card.place, "a rubber chain that relaxes",
                           "the parts made of it are left out")
        return None
    links = row.positive("N")
    if links <= 1:
        row.fail("N", "more than 1 link is expected")
    law = {
        "model": "arruda_boyce",
        "density": row.positive("RO"),
        "mu": row.positive("G"),
        "locking_stretch": links**0.5,
        "bulk_modulus": row.positive("K"),
    }
    row.finish(deck.ledger)
    more.finish(deck.ledger)
    return law


def find_detonations(deck: KeywordDeck, material: int) -> list[Vector]:
    """Points for the parts of an explosive: those of all parts, and those of the one part that is made of it."""
    parts = {part.id for part in deck.parts.values() if part.material == material}
    points = []
    for part, point, place in deck.detonations:
        if part in parts and len(parts) > 1:
            deck.ledger.refuse("INITIAL_DETONATION.PID", place, "a point of one of several parts of an explosive",
                               "all of them detonate from it")
        if part == 0 or part in parts:
            points.append(point)
    return points


def explosive(deck: KeywordDeck, card: Card, use: Use) -> Deck | None:
    """*MAT_HIGH_EXPLOSIVE_BURN with *EOS_JWL and one *INITIAL_DETONATION."""
    row = card.reader().row("MID RO D PCJ BETA K G SIGY")
    row.skip("MID", "PCJ")
    if row.number("BETA") == 0:
        deck.ledger.approximated(f"{card.keyword}.BETA", row.place,
                                 "programmed burn alone: compression does not ignite")
    elif row.number("BETA") == 1:
        deck.ledger.refuse(f"{card.keyword}.BETA", row.place, "BETA: burning by compression alone",
                           "it burns from the point of detonation")
    points = find_detonations(deck, row.integer("MID"))
    if len(points) != 1:
        deck.ledger.refuse(
            "INITIAL_DETONATION",
            card.place,
            f"{len(points)} points of detonation (percuss takes one at time 0)",
            "the parts made of it are left out",
        )
        return None
    state = translate_state(deck, use)
    if state is None or state.get("kind") != "jwl":
        deck.ledger.refuse(
            f"{card.keyword}.EOSID", card.place, "an explosive without *EOS_JWL", "the parts made of it are left out"
        )
        return None
    state |= {"detonation_velocity": row.positive("D"), "detonation_point": list(points[0])}
    law: Deck = {"model": "fluid", "density": row.positive("RO"), "equation_of_state": state}
    row.finish(deck.ledger)
    return law


ELASTIC = {
    "ELASTIC": elastic, "ELASTIC_FLUID": elastic_fluid, "NULL": null, "VISCOELASTIC": viscoelastic, "BLATZ-KO_RUBBER":
    blatz_ko, "MOONEY-RIVLIN_RUBBER": mooney_rivlin, "ARRUDA_BOYCE": arruda_boyce, "HIGH_EXPLOSIVE_BURN": explosive,
}  # fmt: skip
