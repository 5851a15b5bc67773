"""*POROUS METAL PLASTICITY: Gurson's law."""

from ..laws import hardens_isotropically
from ..ledger import BadInput
from ..model import Deck
from .deck import AbaqusDeck, MaterialBlocks
from .lines import Block

KEYWORDS = {"POROUS METAL PLASTICITY", "VOID NUCLEATION", "POROUS FAILURE CRITERIA"}
ROUNDING = 1e-9  # share of a q3 that is meant to be the square of q1


def read_first(deck: AbaqusDeck, block: Block, count: int) -> list[float]:
    """The numbers of the first line; others are for other temperatures."""
    if not block.lines:
        raise BadInput(block.place, f"*{block.keyword} has no data line: add it")
    if len(block.lines) > 1:
        deck.ledger.refuse(f"{block.keyword}.TEMPERATURE", block.place, "constants for several temperatures",
                           "those of the first one are used")
    return [block.number(block.lines[0], i) for i in range(count)]


def add_voids(deck: AbaqusDeck, law: Deck, material: MaterialBlocks) -> set[str]:
    """The law of the metal between the voids becomes that of the metal with them;
    returns the keywords that are done with."""
    blocks = {block.keyword: block for block in material.parts if block.keyword in KEYWORDS}
    porous = blocks.get("POROUS METAL PLASTICITY")
    if porous is None:
        return set()
    if not hardens_isotropically(law) or "equation_of_state" in law:
        deck.ledger.refuse("POROUS METAL PLASTICITY", porous.place,
                           "voids in a metal without a table of isotropic hardening, or with *EOS", "it has no voids")
        return KEYWORDS
    density = porous.number((porous.place.line, [porous.options.get("RELATIVE DENSITY", "")]), 0)
    if "RELATIVE DENSITY" not in porous.options:
        deck.ledger.refuse("POROUS METAL PLASTICITY.RELATIVE DENSITY", porous.place,
                           "a relative density by *INITIAL CONDITIONS", "there are no voids at the start")
        density = 1.0
    if not 0 < density <= 1:
        raise BadInput(porous.place, "RELATIVE DENSITY is not above 0 and at most 1: correct it")
    q1, q2, q3 = read_first(deck, porous, 3)
    if min(q1, q2, q3) <= 0:
        raise BadInput(porous.place, "a constant of *POROUS METAL PLASTICITY is not positive: correct it")
    if q3 > q1 * q1 * (1 + ROUNDING):
        deck.ledger.refuse("POROUS METAL PLASTICITY.q3", porous.place,
                           "q3 above the square of q1", "q3 is the square of q1")
    q3 = min(q3, q1 * q1)
    rows = law.pop("hardening", None) or [[0.0, law["yield_stress"]]]
    for key in ("yield_stress", "hardening_modulus", "kinematic_share"):
        law.pop(key, None)
    law |= {"model": "gurson", "hardening": rows, "q1": q1, "q2": q2, "q3": q3, "void_fraction": 1 - density}
    deck.ledger.translated("POROUS METAL PLASTICITY", porous.place, "gurson")
    add_nucleation(deck, law, blocks.get("VOID NUCLEATION"))
    add_failure(deck, law, blocks.get("POROUS FAILURE CRITERIA"))
    return KEYWORDS


def add_nucleation(deck: AbaqusDeck, law: Deck, block: Block | None) -> None:
    """Mean strain, standard deviation and void fraction."""
    if block is None:
        return
    strain, deviation, fraction = read_first(deck, block, 3)
    if strain < 0 or deviation <= 0 or not 0 <= fraction < 1:
        raise BadInput(block.place,
                       "the strain, deviation or void fraction of *VOID NUCLEATION is out of its range: correct it")
    law |= {"nucleation_strain": strain, "nucleation_deviation": deviation, "nucleation_fraction": fraction}
    deck.ledger.translated("VOID NUCLEATION", block.place, "nucleation of gurson")


def add_failure(deck: AbaqusDeck, law: Deck, block: Block | None) -> None:
    """Void fractions of failure and of coalescence, 1 where they are blank."""
    if block is None:
        return
    failing, critical = (value or 1.0 for value in read_first(deck, block, 2))
    if not law["void_fraction"] < critical <= 1 or not (critical < failing <= 1 or critical == 1):
        raise BadInput(block.place, "the void fractions of *POROUS FAILURE CRITERIA must ascend from that of the "
                                    "start, the critical one, that of failure: correct them")
    law |= {"critical_void_fraction": critical, "failure_void_fraction": failing}
    deck.ledger.translated("POROUS FAILURE CRITERIA", block.place,
                           "critical_void_fraction and failure_void_fraction of gurson")
