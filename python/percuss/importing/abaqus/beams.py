"""*BEAM SECTION, and the areas of trusses: cross sections of beams."""

from ..ledger import BadInput
from ..model import Block as Part
from ..model import Deck
from .deck import AbaqusDeck
from .lines import Block
from .mesh import Section

LAWS = ("elastic", "j2_plasticity")
DIMENSIONS = {"CIRC": 1, "PIPE": 2, "RECT": 2, "BOX": 6}


def read_beam_section(section: Section, block: Block) -> None:
    """Line 1 has the dimensions, line 2 the direction n1, which is y of percuss."""
    section.shape = block.option("SECTION")
    if block.lines:
        section.sizes = [block.number(block.lines[0], i) for i in range(DIMENSIONS.get(section.shape, 0))]
    if len(block.lines) > 1:
        section.toward = [block.number(block.lines[1], i) for i in range(3)]


def make_section(deck: AbaqusDeck, section: Section) -> Deck | None:
    """The section of a part; None where it is refused."""
    if section.kind == "SOLID":  # of trusses
        if section.area <= 0:
            raise BadInput(section.place, "the area of this truss is not positive: correct it")
        return {"truss": {"area": section.area}}
    sizes = section.sizes
    if section.shape not in DIMENSIONS:
        deck.ledger.refuse("BEAM SECTION.SECTION", section.place, f"a section of type {section.shape or '(none)'}", "it is left out")
        return None
    if not sizes or min(sizes) <= 0:
        raise BadInput(section.place, "a dimension of this beam section is not positive: correct it")
    if section.shape == "CIRC":
        return {"round": {"radius": sizes[0]}}
    if section.shape == "PIPE":
        if sizes[1] >= sizes[0]:
            return {"round": {"radius": sizes[0]}}
        return {"tube": {"outer_radius": sizes[0], "inner_radius": sizes[0] - sizes[1]}}
    if section.shape == "RECT":
        return {"rectangle": {"size": sizes}}
    if len(set(sizes[2:])) > 1:
        deck.ledger.refuse("BEAM SECTION.BOX", section.place, "walls of different thickness", "all have their mean")
    wall = sizes[2] if len(set(sizes[2:])) == 1 else sum(sizes[2:]) / 4
    if 2 * wall >= min(sizes[:2]):
        raise BadInput(section.place, "the walls of this box are thicker than half of its width: correct them")
    return {"box": {"size": sizes[:2], "wall": wall}}


def add_beam_keys(deck: AbaqusDeck, section: Section, part: Part, law: Deck) -> bool:
    """Whether the part can be made."""
    found = make_section(deck, section)
    if found is None:
        return False
    if law["model"] not in LAWS or "equation_of_state" in law:
        deck.ledger.refuse("BEAM SECTION.MATERIAL", section.place, f"beams of the material model {law['model']}", "they are left out")
        return False
    part.keys["section"] = found
    if "rectangle" in found or "box" in found:
        part.keys["toward"] = section.toward
    deck.ledger.approximated(
        f"{section.kind} SECTION", section.place, "percuss has one beam: normal stress in fibres, elastic shear and torque"
    )
    return True
