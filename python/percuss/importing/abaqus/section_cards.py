"""*SOLID SECTION, *SHELL SECTION and their like, *DISTRIBUTION: as they stand in the deck."""

from dataclasses import replace

from ..fields import parse_real
from ..ledger import BadInput, Ledger
from .beams import read_beam_section
from .deck import AbaqusDeck
from .lines import Block
from .mesh import Scope, Section, SectionLayer


def read_layers(section: Section, block: Block) -> None:
    """Thickness, points, material and angle, or the name of an orientation, of each layer from the bottom."""
    for line in [line for line in block.lines if any(line[1])]:
        turn = block.text(line, 3)
        is_angle = parse_real(turn or "0") is not None
        layer = SectionLayer(block.number(line, 0), block.integer(line, 1, 3), block.text(line, 2).strip('"').upper())
        layer = (replace(layer, angle=block.number(line, 3)) if is_angle
                 else replace(layer, orientation=turn.strip('"').upper()))
        if layer.thickness <= 0:
            raise BadInput(block.at(line[0]),
                           f"the thickness of a layer is {layer.thickness:g} (it must be positive): correct it")
        section.layers.append(layer)
    if not section.layers:
        raise BadInput(block.place, f"*{block.keyword}, COMPOSITE has no layers: add them")
    if "SYMMETRIC" in block.options:
        section.layers += section.layers[::-1]
    section.thickness = sum(layer.thickness for layer in section.layers)
    section.points = sum(layer.points for layer in section.layers)
    names = {layer.material for layer in section.layers}
    section.material = section.layers[0].material if len(names) == 1 else ""


def read_section(scope: Scope, block: Block) -> None:
    """*SOLID SECTION, *SHELL SECTION, *BEAM SECTION, *BEAM GENERAL SECTION and *COHESIVE SECTION."""
    section = Section(block.keyword.split()[0], block.option("ELSET"), block.option("MATERIAL"), block.place)
    section.controls, section.orientation = block.option("CONTROLS"), block.option("ORIENTATION")
    if "COMPOSITE" in block.options:
        read_layers(section, block)
    elif section.kind in ("SHELL", "MEMBRANE") and block.lines:
        section.thickness, section.points = block.number(block.lines[0], 0), block.integer(block.lines[0], 1, 5)
    if section.kind in ("SHELL", "MEMBRANE") and block.lines:
        section.stack = block.option("STACK DIRECTION")
        section.is_nodal = "NODAL THICKNESS" in block.options
        section.distribution = block.option("SHELL THICKNESS")
        offset = block.option("OFFSET")
        section.offset = {"SPOS": 0.5, "SNEG": -0.5}.get(offset, 0.0)
        if offset and offset not in ("SPOS", "SNEG"):
            section.offset = block.number((block.place.line, [offset]), 0)
    if section.kind == "SOLID" and block.lines:
        section.area = block.number(block.lines[0], 0)
    if block.keyword == "BEAM GENERAL SECTION":
        section.general, section.material = block, f"general section of line {block.place.line}"
    if section.kind == "BEAM":
        read_beam_section(section, block)
    if section.kind == "COHESIVE":
        section.cohesive = block
    scope.sections.append(section)


def read_distribution(scope: Scope, block: Block, ledger: Ledger) -> None:
    """*DISTRIBUTION of a value of elements; a line without element is that of all others."""
    if block.option("LOCATION") not in ("", "ELEMENT"):
        ledger.ignored("DISTRIBUTION", block.place,
                       "axes of materials, which *ORIENTATION refuses where a law has axes")
        return
    values = scope.distributions.setdefault(block.option("NAME"), {})
    for line in block.lines:
        if len([word for word in line[1] if word]) > 2:
            ledger.ignored("DISTRIBUTION", block.place,
                           "axes of materials, which *ORIENTATION refuses where a law has axes")
            return
        values[block.id(line, 0) if block.text(line, 0) else 0] = block.number(line, 1)
    ledger.translated("DISTRIBUTION", block.place, "thickness of shells, where a section asks for it")


def read_transverse_shear(deck: AbaqusDeck, block: Block) -> None:
    """Stiffness of a section of shells or beams."""
    if any(section.kind in ("SHELL", "BEAM") for section in deck.mesh.sections):
        deck.ledger.refuse(block.keyword, block.place, "a transverse shear stiffness of its own",
                           "it is that of the material")
    else:
        deck.ledger.ignored(block.keyword, block.place, "it is of shells and beams, which the deck has not")
