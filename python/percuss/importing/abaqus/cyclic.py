"""*PLASTIC, HARDENING=COMBINED and *CYCLIC HARDENING: Chaboche's law."""

from ..ledger import BadInput
from ..model import Deck
from .deck import AbaqusDeck
from .lines import Block

MOST_TERMS = 4  # of percuss
MOST_BACK_STRESSES = 10  # of Abaqus
PER_LINE = 8


def add_combined(deck: AbaqusDeck, law: Deck, block: Block, cyclic: Block | None) -> None:
    """DATA TYPE=PARAMETERS: yield stress, then C and gamma of each back stress, in lines of eight numbers."""
    if (block.option("DATA TYPE") or block.option("DATATYPE")) != "PARAMETERS":
        text = ("combined hardening fitted to a test: give the constants that Abaqus has found, "
                "which its .dat file lists (DATA TYPE=PARAMETERS)")
        deck.ledger.refuse("PLASTIC.DATA TYPE", block.place, text, "the material is elastic")
        return
    count = read_count(block)
    lines = -(-(2 * count + 2) // PER_LINE)
    values = [block.number(line, i) for line in block.lines[:lines] for i in range(PER_LINE)]
    if len(block.lines) > lines:
        deck.ledger.refuse("PLASTIC.TEMPERATURE", block.place, "constants for several temperatures",
                           "those of the first one are used")
    terms: dict[float, float] = {}
    for modulus, gamma in zip(values[1 : 1 + 2 * count : 2], values[2 : 2 + 2 * count : 2]):
        if modulus < 0 or gamma < 0:
            raise BadInput(block.place, "a constant of a back stress of *PLASTIC is negative: correct it")
        if modulus > 0:
            terms[gamma] = terms.get(gamma, 0.0) + modulus
    if values[0] <= 0:
        raise BadInput(block.place, "a yield stress of *PLASTIC is not positive: correct it")
    if len(terms) > MOST_TERMS:
        text = f"{len(terms)} back stresses of different gamma (percuss has {MOST_TERMS})"
        deck.ledger.refuse("PLASTIC.NUMBER BACKSTRESSES", block.place, text, f"the first {MOST_TERMS} are used")
    rows = [[gamma, terms[gamma]] for gamma in sorted(terms)][:MOST_TERMS]
    law |= ({"model": "chaboche", "yield_stress": values[0], "back_stresses": rows} if rows
            else {"model": "voce_plasticity", "yield_stress": values[0]})
    add_cyclic(deck, law, cyclic)


def read_count(block: Block) -> int:
    text = block.option("NUMBER BACKSTRESSES") or "1"
    if not text.isdecimal() or not 1 <= int(text) <= MOST_BACK_STRESSES:
        raise BadInput(block.place, f"NUMBER BACKSTRESSES is not from 1 to {MOST_BACK_STRESSES}: correct it")
    return int(text)


def add_cyclic(deck: AbaqusDeck, law: Deck, block: Block | None) -> None:
    """*CYCLIC HARDENING, PARAMETERS: yield stress at p = 0, Q and b."""
    stress, rate = (("cyclic_stress", "cyclic_rate") if law["model"] == "chaboche"
                    else ("saturation_stress", "saturation_rate"))
    law |= {stress: 0.0, rate: 0.0}
    if block is None:
        return
    if "PARAMETERS" not in block.options:
        deck.ledger.refuse("CYCLIC HARDENING.PARAMETERS", block.place,
                           "the size of the elastic range by a table or by user code", "it stays as it is")
        return
    if not block.lines:
        raise BadInput(block.place, "*CYCLIC HARDENING has no data line: add it")
    start, law[stress], law[rate] = (block.number(block.lines[0], i) for i in range(3))
    if start > 0:
        law["yield_stress"] = start
    if len(block.lines) > 1:
        deck.ledger.refuse("CYCLIC HARDENING.TEMPERATURE", block.place, "constants for several temperatures",
                           "those of the first one are used")
    if law["yield_stress"] + law[stress] <= 0 or law[rate] < 0 or (law["model"] != "chaboche" and law[stress] < 0):
        raise BadInput(block.place, "Q of *CYCLIC HARDENING takes all strength, or b is negative: correct them")
    deck.ledger.translated("CYCLIC HARDENING", block.place, f"{stress} and {rate} of {law['model']}")
