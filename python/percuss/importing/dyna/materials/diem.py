"""DIEM: *MAT_ADD_DAMAGE_DIEM.
Starts of damage by the stress state, each with a displacement or an energy over which the stress falls."""

from ... import laws
from ...fields import Row
from ...model import Deck
from ..cards import Card
from ..deck import KeywordDeck
from ..dimensions import SAME, scale
from .gissmo import find_curve, make_rows
from .shared import Use, finish_lines, set_layers

MOST_CRITERIA = 5  # NDIEMC
LEFT_OUT = "it is left out"
DUCTILE, SHEAR = 0, 1  # DITYP
BY_DISPLACEMENT, BY_ENERGY = 0, 1  # DETYP
ALONE = -1  # DCTYP: the damage is output alone
LARGEST = 0  # likewise: the largest damage of all counts


def add_diem(deck: KeywordDeck, material: int, law: Deck, use: Use) -> None:
    """Adds what *MAT_ADD_DAMAGE_DIEM gives to the law of the material."""
    card = deck.diems.get(material)
    if card is None:
        return
    reader = card.reader()
    if card.has_title:
        reader.take()
    row = reader.row("MID NDIEMC DINIT DEPS~ NUMFIP=1")
    row.skip("MID")
    pairs = [(reader.row("DITYP P1 P2"), reader.row("DETYP DCTYP Q1"))
             for _ in range(min(row.integer("NDIEMC"), MOST_CRITERIA))]
    failure = read_criteria(deck, card, pairs, find_obstacle(law, use))
    if failure:
        law["failure"] = {**law.get("failure", {}), **failure}
        deck.ledger.translated(card.keyword, card.place, "failure by the damage of the material")
    if failure and use.is_shell:
        set_layers(deck, law, row, use, None)
    for line in (row, *(line for pair in pairs for line in pair)):
        if not failure:
            line.skip("NUMFIP", "DITYP", "P1", "P2", "DETYP", "DCTYP", "Q1")
        line.finish(deck.ledger)
    finish_lines(deck, card, reader)


def find_obstacle(law: Deck, use: Use) -> str:
    """Why a law has no such damage; empty: it may have it."""
    if use.is_beam:
        return "damage of beams"
    if not laws.has(law, "has_plastic_strain"):
        return "damage of a law without plastic strain"
    own = {"plastic_strain", "johnson_cook", "triaxiality", "yield_time"} & law.get("failure", {}).keys()
    return "damage of a law that has a damage of its own" if own else ""


def read_criteria(deck: KeywordDeck, card: Card, pairs: list[tuple[Row, Row]], obstacle: str) -> Deck:
    """Keys of failure; none: refused, or output alone."""
    coupled = [(start, end) for start, end in pairs if end.number("DCTYP") != ALONE]
    if pairs and not coupled:
        deck.ledger.ignored(card.keyword, card.place, "DCTYP of -1: the damage is output alone")
        return {}
    failure: Deck = {}
    for start, end in coupled:
        kind = start.number("DITYP")
        key = "triaxiality" if kind == DUCTILE else "shear"
        if kind not in (DUCTILE, SHEAR):
            obstacle = obstacle or f"damage by the criterion DITYP of {kind:g}"
        elif key in failure:
            obstacle = obstacle or "two criteria of one kind"
        elif find_curve(start, "P1") in deck.tables:
            obstacle = obstacle or "failure strains that depend on the rate"
        elif not obstacle:
            rows = make_rows(deck, start, "P1")
            failure[key] = rows if kind == DUCTILE else {"strain": rows, "pressure_factor": start.number("P2")}
    ends = [read_evolution(end) for _, end in coupled]
    if not obstacle and (None in ends or any(end != ends[0] for end in ends)):
        obstacle = ("several criteria whose damages grow differently, "
                    "or damage that grows by a table or by another quantity")
    if not obstacle and len(coupled) > 1 and any(end.number("DCTYP") != LARGEST for _, end in coupled):
        obstacle = "several damages that multiply"
    if obstacle or not coupled:
        deck.ledger.refuse(card.keyword, card.place, obstacle or "no criterion", LEFT_OUT)
        return {}
    if ends[0]:
        failure["evolution"] = ends[0]
    if "energy" in (ends[0] or {}):
        deck.ledger.approximated(card.keyword, card.place, "failure.evolution: the energy by the stress of each "
                                                           "moment, where LS-DYNA takes that at the start of damage")
    return failure


def read_evolution(row: Row) -> Deck | None:
    """Keys of failure.evolution; empty: failure at the start of damage. None: there are none like it."""
    value, kind = row.number("Q1"), row.number("DETYP")
    if value < 0 or kind not in (BY_DISPLACEMENT, BY_ENERGY):
        return None
    if value == 0:
        return {}
    dimension = "length" if kind == BY_DISPLACEMENT else "stiffness"
    return {"displacement" if kind == BY_DISPLACEMENT
            else "energy": value * scale(dimension, row.change.factors if row.change else SAME)}
