"""*MAT_JOHNSON_COOK and *MAT_SIMPLIFIED_JOHNSON_COOK."""

from ...fields import Row
from ...model import Deck
from ..cards import Card
from ..deck import KeywordDeck
from .shared import (
    NEVER,
    Use,
    elastic_from_shear_and_bulk,
    find_bulk_modulus,
    finish_lines,
    limit_tension,
    note_rate,
    read_layers,
    set_failure,
    start_law,
)
from .states import initial_bulk_modulus, translate_state

SMALL = 1e-6  # EFMIN where it is blank
COLD = 70.0  # Kelvin, below which a temperature is that of another scale


def johnson_cook(deck: KeywordDeck, card: Card, use: Use) -> Deck | None:
    reader = card.reader()
    row, flow = reader.row("MID RO G E PR DTF VP RATEOP"), reader.row("A B N C M TM TR EPSO=1")
    # SPALL says what happens at PC; IT, how the return is iterated.
    heat, last = (reader.row("CP PC SPALL~unused IT~solids D1 D2 D3 D4"),
                  reader.row("D5 C2 EROD EFMIN=1e-6 NUMINT K EPS1 DMODEL"))
    row.skip("MID")
    law: Deck = {"model": "johnson_cook", "density": row.positive("RO")}
    if use.is_shell:
        law |= {"youngs_modulus": row.positive("E"), "poissons_ratio": row.number("PR")}
    else:
        state = translate_state(deck, use)
        if state is None:
            deck.ledger.refuse(
                f"{card.keyword}.EOSID",
                use.place,
                "Johnson and Cook's law for solids needs an equation of state",
                "the parts made of it are left out",
            )
            return None
        law |= {**johnson_cook_moduli(row, state, law["density"]), "equation_of_state": state}
    row.skip("E", "PR", "G")
    law |= read_flow(flow)
    if not use.is_shell and law["start_temperature"] < COLD:  # compression heats from there
        law["absolute_zero"] = law["start_temperature"] - 293.15 if law["start_temperature"] == 0 else -273.15
        deck.ledger.approximated(f"{card.keyword}.TR", flow.place,
                                 "temperatures are taken as degrees Celsius; of 0 as room temperature")
    law |= {"specific_heat": heat.number("CP") or NEVER, "heating_share": 1.0}
    limit_tension(deck, heat, law, find_bulk_modulus(law), stays=heat.integer("SPALL") == 1)
    read_damage(deck, card, law, heat, last, flow.number("EPSO") or 1.0)
    set_failure(law, step=row.number("DTF"))
    read_layers(law, last, use)
    note_rate(deck, row)
    for found in (row, flow, heat, last):
        found.finish(deck.ledger)
    finish_lines(deck, card, reader)
    return law


def johnson_cook_moduli(row: Row, state: Deck, density: float) -> Deck:
    """Solids take the shear modulus of the card and the bulk modulus of the equation of state."""
    shear = row.number("G") or row.number("E") / (2 * (1 + row.number("PR")))
    if shear <= 0:
        row.fail("G", "must be positive")
    return elastic_from_shear_and_bulk(shear, initial_bulk_modulus(state, density))


def read_flow(row: Row) -> Deck:
    """Constants of the flow stress."""
    keys: Deck = {
        "a": row.positive("A"),
        "b": row.number("B"),
        "n": row.number("N") or 1.0,
        "c": row.number("C"),
        "m": row.number("M") or 1.0,
    }
    melt, room = row.numbers("TM", "TR")
    if melt <= room:
        melt = room + NEVER
    return keys | {
        "reference_rate": row.number("EPSO") or 1.0,
        "melt_temperature": melt,
        "room_temperature": room,
        "start_temperature": room,
    }


def read_damage(deck: KeywordDeck, card: Card, law: Deck, heat: Row, last: Row, rate: float) -> None:
    """D1 to D5. LS-DYNA's triaxiality is that of pressure, so D3 changes its sign."""
    d1, d2, d3, d4 = heat.numbers("D1", "D2", "D3", "D4")
    d5, keeps = last.number("D5"), last.integer("EROD")
    least = last.number("EFMIN")
    if not (d1 or d2):
        return
    if d2 == d4 == d5 == 0:  # one failure strain
        d1 = max(d1, least)
    elif least > max(d1, SMALL):  # which the formula may fall below
        deck.ledger.refuse(f"{card.keyword}.EFMIN", last.place,
                           f"EFMIN: a lower limit of the failure strain of {least:g}", "there is no limit")
    if keeps:
        deck.ledger.refuse(f"{card.keyword}.EROD", last.place, "failed elements that are not eroded",
                           "failed elements are eroded")
    if d3 < 0:
        deck.ledger.refuse(
            f"{card.keyword}.D3",
            heat.place,
            "D3 below 0 makes the material tougher in tension in LS-DYNA, whose triaxiality is that of pressure",
            "the sign is taken as a mistake: less ductile in tension",
        )
    if d1 < 0 or d2 < 0:
        deck.ledger.refuse(f"{card.keyword}.D1", heat.place, "D1 or D2 below 0", "0 is used")
    damage = {"d1": max(d1, 0.0), "d2": max(d2, 0.0), "d3": -abs(d3), "d4": d4, "d5": d5, "reference_rate": rate}
    law.setdefault("failure", {})["johnson_cook"] = damage
    deck.ledger.approximated(f"{card.keyword}.D1", heat.place, "damage by percuss' form")


def simplified_johnson_cook(deck: KeywordDeck, card: Card, use: Use) -> Deck:
    reader = card.reader()
    row, flow = reader.row("MID RO E PR VP"), reader.row("A B N C PSFAIL SIGMAX SIGSAT EPSO=1")
    note_rate(deck, row)
    law = start_law(row, "johnson_cook")
    law |= {"a": flow.positive("A"), "b": flow.number("B"), "n": flow.number("N") or 1.0, "c": flow.number("C")}
    law |= {"reference_rate": flow.number("EPSO") or 1.0, "melt_temperature": NEVER, "specific_heat": NEVER}
    set_failure(law, plastic_strain=flow.number("PSFAIL"))
    for name in ("SIGMAX", "SIGSAT"):
        if flow.number(name) >= 1e20:
            flow.skip(name)
        elif flow.number(name) > 0:
            deck.ledger.refuse(f"{card.keyword}.{name}", flow.place, "a stress limit", "there is no limit")
    row.finish(deck.ledger)
    flow.finish(deck.ledger)
    finish_lines(deck, card, reader)
    return law


JOHNSON = {"JOHNSON_COOK": johnson_cook, "SIMPLIFIED_JOHNSON_COOK": simplified_johnson_cook}
