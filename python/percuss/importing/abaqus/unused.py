"""Materials, sections and interactions that nothing uses, and those of which their parts say nothing."""

from collections.abc import Iterator

from .deck import AbaqusDeck
from .followers import list_leaders
from .lines import Block
from .timeline import Target


def last_line(block: Block) -> int:
    return block.lines[-1][0] if block.lines else block.place.line


def note_definitions(deck: AbaqusDeck) -> None:
    """An entry for each keyword of them without one."""
    note_sections(deck)
    note_replaced(deck)
    for block, fate in [*list_materials(deck), *list_interactions(deck), *list_controls(deck)]:
        if deck.ledger.tells_of(block.place, last_line(block)):
            continue
        if fate:
            deck.ledger.ignored(block.keyword, block.place, fate)
        else:
            deck.ledger.translated(block.keyword, block.place,
                                   OF_WHAT.get(block.keyword, "of a material or an interaction that the model has"))


OF_WHAT = {"FRICTION": "friction of contact", "SURFACE INTERACTION": "friction and bonds of contact",
           "SECTION CONTROLS": "what its sections say of their elements"}


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


def note_replaced(deck: AbaqusDeck) -> None:
    """Lines of conditions and loads that act in a table with others, and those that others replace before they act."""
    turning = deck.model.turning_nodes() | deck.group_of_ref.keys() | list_leaders(deck).keys() | deck.leaders
    for timeline in (deck.motions, deck.loads):
        acting = {window.action.place: "" for windows in timeline.windows.values() for window in windows}
        acting |= {window.action.place: "acts" for target, windows in timeline.windows.items()
                   for window in windows if not is_idle(target, turning)}
        for place in timeline.lines:
            keyword = deck.keywords_of_lines[place]
            if deck.ledger.tells_of(place, place.line):
                continue
            if acting.get(place):
                deck.ledger.translated(keyword, place,
                                       "acts with those of other steps or lines, whose rows say as what")
            else:
                deck.ledger.ignored(keyword, place, "its nodes have no rotations" if place in acting
                                    else "another one takes its place before it acts")


def is_idle(target: Target, turning: set[int]) -> bool:
    """Whether a target of a timeline is a rotation of a node that has none."""
    return isinstance(target[0], int) and str(target[1]).startswith("r") and target[0] not in turning


def note_sections(deck: AbaqusDeck) -> None:
    made = {part.place for part in deck.model.blocks}
    for section in deck.mesh.sections:
        if deck.ledger.tells_of(section.place, section.place.line):
            continue
        if section.place in made:
            deck.ledger.translated(section.keyword, section.place, "a part with its material")
        elif not deck.elements_of(section.elements, section.place):
            deck.ledger.ignored(section.keyword, section.place, "its element set has no element")
