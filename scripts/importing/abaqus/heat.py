"""Temperatures: of Johnson and Cook's law alone, heated by plastic work without conduction."""

from ..model import Deck
from .deck import AbaqusDeck
from .lines import Block

CONDUCTING = "DYNAMIC TEMPERATURE-DISPLACEMENT"
KEYWORDS = ("INELASTIC HEAT FRACTION", "SPECIFIC HEAT", "CONDUCTIVITY", "EXPANSION")
NO_STEP = "no temperature changes: the step is not ADIABATIC"


def read_procedure(deck: AbaqusDeck, block: Block) -> None:
    """Whether plastic work heats, and what of the heat is not computed."""
    if block.keyword == CONDUCTING:
        deck.ledger.refuse(CONDUCTING, block.place, "conduction of heat", "plastic work heats each point alone, as with ADIABATIC")
    deck.heats = deck.heats or block.keyword == CONDUCTING or "ADIABATIC" in block.options


def take_heat(deck: AbaqusDeck, law: Deck, blocks: list[Block]) -> set[str]:
    """Keys of heating of a material; returns the keywords that are done with."""
    found = {block.keyword: block for block in blocks if block.keyword in KEYWORDS}
    share, capacity = found.get("INELASTIC HEAT FRACTION"), found.get("SPECIFIC HEAT")
    is_warm = law["model"] == "johnson_cook"
    for keyword, block in found.items():
        if not deck.heats:
            deck.ledger.ignored(keyword, block.place, NO_STEP)
        elif keyword == "CONDUCTIVITY":
            deck.ledger.ignored(keyword, block.place, "the report says of the step that heat is not conducted")
        elif keyword == "EXPANSION":
            deck.ledger.refuse(keyword, block.place, "thermal expansion", "there is none")
        elif is_warm:
            deck.ledger.translated(keyword, block.place, "specific_heat and heating_share of johnson_cook")
        else:
            deck.ledger.ignored(keyword, block.place, "the law does not depend on the temperature")
    if deck.heats and is_warm and share and capacity and share.lines and capacity.lines:
        law |= {"specific_heat": capacity.number(capacity.lines[0], 0), "heating_share": share.number(share.lines[0], 0, 0.9)}
        law["start_temperature"] = 0.0  # of Abaqus, where *INITIAL CONDITIONS gives none
    return set(found)


def read_temperature(deck: AbaqusDeck, block: Block) -> None:
    """*INITIAL CONDITIONS, TYPE=TEMPERATURE: one for all nodes."""
    laws = [law for law in deck.model.materials.values() if law["model"] == "johnson_cook"]
    values = {block.number(line, 1) for line in block.lines}
    nodes = {node for line in block.lines for node in deck.nodes_of(block.text(line, 0), block.at(line[0]))}
    if not laws:
        deck.ledger.ignored("INITIAL CONDITIONS", block.place, "a temperature, on which no law depends")
    elif len(values) != 1 or not nodes >= deck.used_nodes():
        deck.ledger.refuse(
            "INITIAL CONDITIONS", block.place, "a temperature of some nodes alone, or several", "the start is at the reference temperature"
        )
    else:
        for law in laws:
            law["start_temperature"] = values.copy().pop()
        deck.ledger.translated("INITIAL CONDITIONS", block.place, "start_temperature of johnson_cook")
