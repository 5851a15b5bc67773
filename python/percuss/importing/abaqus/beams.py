"""*BEAM SECTION, *BEAM GENERAL SECTION, and the areas of trusses: cross sections of beams."""

from collections.abc import Iterable

from .. import laws
from ..ledger import BadInput
from ..model import Block as Part
from ..model import Deck
from .deck import AbaqusDeck
from .lines import Block
from .mesh import Section

DIMENSIONS = {"CIRC": 1, "PIPE": 2, "RECT": 2, "BOX": 6, "I": 7}


def read_beam_section(section: Section, block: Block) -> None:
    """Line 1 has the dimensions, line 2 the direction n1, which is y of percuss."""
    section.shape = block.option("SECTION") or ("GENERAL" if section.general else "")
    if block.lines:
        count = 5 if section.shape == "GENERAL" and section.general else DIMENSIONS.get(section.shape, 0)
        section.sizes = [block.number(block.lines[0], i) for i in range(count)]
    if len(block.lines) > 1:
        section.toward = [block.number(block.lines[1], i) for i in range(3)]


def check_sizes(section: Section, which: Iterable[int]) -> None:
    """Numbers of the first line, from 0, that must be positive."""
    if not section.sizes:
        raise BadInput(section.place, "this beam section has no dimensions: add a line with them")
    for i in which:
        if section.sizes[i] <= 0:
            raise BadInput(section.place, f"number {i + 1} of the dimensions of this beam section is "
                                          f"{section.sizes[i]:g} (it must be positive): correct it")


def make_section(deck: AbaqusDeck, section: Section) -> Deck | None:
    """The section of a part; None where it is refused."""
    if section.kind == "SOLID":  # of trusses
        if section.area <= 0:
            raise BadInput(section.place,
                           f"the area of this truss is {section.area:g} (it must be positive): correct it")
        return {"truss": {"area": section.area}}
    sizes = section.sizes
    if section.general and section.shape == "GENERAL":
        return make_general(deck, section)
    if section.shape not in DIMENSIONS:
        deck.ledger.refuse("BEAM SECTION.SECTION", section.place,
                           f"a section of type {section.shape or '(none)'}", "it is left out")
        return None
    check_sizes(section, range(len(sizes)))
    if section.shape == "CIRC":
        return {"round": {"radius": sizes[0]}}
    if section.shape == "PIPE":
        if sizes[1] >= sizes[0]:
            return {"round": {"radius": sizes[0]}}
        return {"tube": {"outer_radius": sizes[0], "inner_radius": sizes[0] - sizes[1]}}
    if section.shape == "RECT":
        return {"rectangle": {"size": sizes}}
    if section.shape == "I":
        return make_i_shape(deck, section)
    if len(set(sizes[2:])) > 1:
        deck.ledger.refuse("BEAM SECTION.BOX", section.place, "walls of different thickness", "all have their mean")
    wall = sizes[2] if len(set(sizes[2:])) == 1 else sum(sizes[2:]) / 4
    if 2 * wall >= min(sizes[:2]):
        raise BadInput(section.place, "the walls of this box are thicker than half of its width: correct them")
    return {"box": {"size": sizes[:2], "wall": wall}}


def make_i_shape(deck: AbaqusDeck, section: Section) -> Deck | None:
    """Where the origin is, the height, widths of both flanges, their thicknesses and that of the web."""
    below, depth, width, top, flange, upper, web = section.sizes
    if top != width or upper != flange or abs(below - depth / 2) > 1e-6 * depth:
        deck.ledger.refuse("BEAM SECTION.I", section.place,
                           "an I whose flanges differ, or whose nodes are not in its middle", "it is left out")
        return None
    if 2 * flange >= depth or web >= width:
        raise BadInput(section.place, "the flanges or the web of this I are thicker than it is: correct them")
    return {"i_shape": {"size": [width, depth], "flange": flange, "web": web}}


def add_beam_keys(deck: AbaqusDeck, section: Section, part: Part, law: Deck) -> bool:
    """Whether the part can be made."""
    found = make_section(deck, section)
    if found is None:
        return False
    if not laws.takes_beams(law):
        deck.ledger.refuse("BEAM SECTION.MATERIAL", section.place,
                           f"beams of the material model {law['model']}", "they are left out")
        return False
    part.keys["section"] = found
    if {"rectangle", "box", "i_shape", "general"} & found.keys():
        part.keys["toward"] = section.toward
    if section.added and "general" not in found:
        deck.ledger.refuse("BEAM ADDED INERTIA", section.added[0].place,
                           "added inertia of sections other than GENERAL", "it is left out")
    deck.ledger.approximated(
        section.keyword, section.place, "percuss has one beam: normal stress in fibres, elastic shear and torque"
    )
    return True


def read_moduli(section: Section) -> tuple[float, float, float]:
    """Young's modulus, shear modulus and density of *BEAM GENERAL SECTION, which stand with the section."""
    block = section.general
    assert block is not None
    line = block.lines[2] if len(block.lines) > 2 else (block.place.line, [])
    young, shear = block.number(line, 0), block.number(line, 1)
    density = block.number((block.place.line, [block.options.get("DENSITY", "")]), 0)
    if min(young, shear) <= 0:
        raise BadInput(block.place,
                       "*BEAM GENERAL SECTION has no positive Young's and shear modulus in its third line: add them")
    if density <= 0:
        raise BadInput(block.place, "*BEAM GENERAL SECTION has no positive DENSITY (a dynamic run needs mass): add it")
    return young, shear, density


def add_inertia(section: Section) -> tuple[float, float]:
    """Mass and rotary inertia about the beam, both by length, of *BEAM ADDED INERTIA:
    with x1 and x2 it lies off the beam."""
    mass = turning = 0.0
    for block in section.added:
        for line in block.lines:
            values = [block.number(line, i) for i in range(7)]
            if values[1] or values[2]:
                raise BadInput(block.at(line[0]), "added inertia off the axis of the beam "
                                                  "(percuss has it on the axis alone): set x1 and x2 to 0")
            mass, turning = mass + values[0], turning + values[4] + values[5]
    return mass, turning


def read_general_law(section: Section) -> Deck:
    """Elastic, with the density of all of the mass. Poisson's ratio is that of both moduli, or 0.3 where none fits."""
    young, shear, density = read_moduli(section)
    poisson = young / (2 * shear) - 1
    mass, _ = add_inertia(section) if section.shape == "GENERAL" else (0.0, 0.0)
    density += mass / section.sizes[0] if mass else 0.0
    return {"model": "elastic", "density": density, "youngs_modulus": young,
            "poissons_ratio": poisson if -0.9 < poisson < 0.49 else 0.3}


def make_general(deck: AbaqusDeck, section: Section) -> Deck | None:
    """A I11 I12 I22 J: n1 is y of percuss, and I11 the moment about it."""
    area, about_y, mixed, about_z, torsion = section.sizes
    check_sizes(section, (0, 1, 3, 4))
    if mixed:
        deck.ledger.refuse("BEAM GENERAL SECTION.I12", section.place,
                           "axes of a section that are not its principal ones", "I12 is left out")
    young, shear, density = read_moduli(section)
    law = read_general_law(section)
    share = shear / (young / (2 * (1 + law["poissons_ratio"])))  # of the shear modulus that the law has
    general = {"area": area, "inertia_y": about_y, "inertia_z": about_z, "torsion": share * torsion,
               "shear_area_y": share * area, "shear_area_z": share * area}
    _, turning = add_inertia(section)
    if section.added:
        general["polar_inertia"] = (density * (about_y + about_z) + turning) / law["density"]
        deck.ledger.translated("BEAM ADDED INERTIA", section.added[0].place,
                               "a higher density, polar_inertia of the section; "
                               "about other axes it has that of the mass")
    deck.ledger.approximated("BEAM GENERAL SECTION", section.place, "the shear areas are the area")
    return {"general": general}
