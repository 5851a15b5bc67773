"""Materials, sections and interactions that nothing uses, and those of which their parts say nothing."""

from collections.abc import Iterator

from .deck import AbaqusDeck
from .lines import Block


def last_line(block: Block) -> int:
    return block.lines[-1][0] if block.lines else block.place.line


def note_definitions(deck: AbaqusDeck) -> None:
    """An entry for each keyword of them without one."""
    note_sections(deck)
    for block, fate in [*list_materials(deck), *list_interactions(deck), *list_controls(deck)]:
        if deck.ledger.tells_of(block.place, last_line(block)):
            continue
        if fate:
            deck.ledger.ignored(block.keyword, block.place, fate)
        else:
            deck.ledger.translated(block.keyword, block.place, OF_WHAT.get(block.keyword, "of a material or an interaction that the model has"))


OF_WHAT = {"FRICTION": "friction of contact", "SURFACE INTERACTION": "friction and bonds of contact", "SECTION CONTROLS": "what its sections say of their elements"}


def list_materials(deck: AbaqusDeck) -> Iterator[tuple[Block, str]]:
    """The keywords of each material, and why they are without effect; empty: the model has it."""
    for name, material in deck.materials.items():
        unused = name not in deck.used_materials
        yield Block("MATERIAL", {}, material.place), "no section with elements uses it" if unused else ""
        for block in material.parts:
            yield block, "of a material that no section with elements uses" if unused else ""


def list_interactions(deck: AbaqusDeck) -> Iterator[tuple[Block, str]]:
    for name, (first, *others) in deck.interactions.items():
        unused = name not in deck.used_interactions
        yield first, "no contact names it" if unused else ""
        for block in others:
            yield block, "of an interaction that no contact names" if unused else ""


def list_controls(deck: AbaqusDeck) -> Iterator[tuple[Block, str]]:
    named = {section.controls for section in deck.mesh.sections}
    for name, block in deck.controls.items():
        yield block, "" if name in named else "no section names it"


def note_sections(deck: AbaqusDeck) -> None:
    made = {part.place for part in deck.model.blocks}
    for section in deck.mesh.sections:
        if deck.ledger.tells_of(section.place, section.place.line):
            continue
        if section.place in made:
            deck.ledger.translated(section.keyword, section.place, "a part with its material")
        elif not deck.elements_of(section.elements, section.place):
            deck.ledger.ignored(section.keyword, section.place, "its element set has no element")
