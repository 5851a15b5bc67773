"""*COHESIVE SECTION with RESPONSE=TRACTION SEPARATION:
cohesive ties of the solids on both sides of COH3D8 and COH3D6."""

from ..cohesive_layers import LEFT_OUT, Layer, add_layer, choose_covered, make_layer
from ..fields import clip
from ..ledger import BadInput, Place, missing
from .damage import LEAST_DEGRADATION
from .deck import AbaqusDeck
from .glue import Bonds, read_law
from .lines import Block
from .mesh import COHESIVE, Section

READ = ("DENSITY", "ELASTIC", "DAMAGE INITIATION", "DAMAGE EVOLUTION")


def bond_solids(deck: AbaqusDeck, section: Section, block: Block) -> None:
    """A cohesive tie in place of the elements of a section. All parts are in the model."""
    ids = list(dict.fromkeys(deck.elements_of(section.elements, section.place)))
    deck.left_elements |= set(ids)
    elements = [(id, *deck.mesh.elements[id]) for id in ids if id in deck.mesh.elements]
    if any(kind not in COHESIVE for _, kind, _ in elements):
        deck.ledger.refuse("COHESIVE SECTION.ELSET", section.place,
                           "a cohesive section of elements other than COH3D8 and COH3D6", LEFT_OUT)
        return
    if block.option("RESPONSE") != "TRACTION SEPARATION":
        text = f"a cohesive section with RESPONSE={clip(block.option('RESPONSE'))} (TRACTION SEPARATION is read)"
        deck.ledger.refuse("COHESIVE SECTION.RESPONSE", section.place, text, LEFT_OUT)
        return
    bonds = find_bonds(deck, section, block) if deletes(deck, section) else None
    law = read_law(deck, bonds) if bonds else {}
    corners = [(id, nodes) for id, _, nodes in elements]
    for _, nodes in corners:
        for node in nodes:
            if node not in deck.mesh.nodes:
                raise BadInput(section.place, missing(f"node {node}"))
    wish = section.elements.rpartition(".")[0] or section.elements
    if law:
        deck.layers.append(make_layer(deck.model, wish, corners, law, section.place))


def tie_layer(deck: AbaqusDeck, slave: str, master: str, place: Place) -> bool:
    """Notes the solids that *TIE holds at a side of cohesive elements. Returns whether it is such a tie."""
    for mine, other in ((slave, master), (master, slave)):
        for layer in deck.layers:
            side = find_side(deck, layer, mine, place)
            if side is not None:
                layer.sides[side] = choose_covered(deck.model, deck.list_faces(other, place), layer.own[side])
                deck.ledger.translated("TIE", place, "a side of cohesive elements")
                return True
    return False


def find_side(deck: AbaqusDeck, layer: Layer, name: str, place: Place) -> int | None:
    """The side of a layer that a surface is: 0 below, 1 above; None: neither."""
    nodes = deck.all_nodes_of_surface(name, place)
    return next((side for side in (0, 1) if nodes and nodes <= layer.nodes(side)), None)


def add_layers(deck: AbaqusDeck) -> None:
    """Ties of all cohesive elements, when those that hold solids at them are known."""
    for layer in deck.layers:
        if add_layer(deck.model, deck.ledger, layer):
            deck.ledger.translated("COHESIVE SECTION", layer.place, "contact.ties with cohesive")


def find_bonds(deck: AbaqusDeck, section: Section, block: Block) -> Bonds | None:
    """What the section and its material say; None: refused."""
    found = deck.materials.get(section.material.upper())
    if found is None:
        raise BadInput(section.place, missing(f"material '{clip(section.material)}'"))
    deck.used_materials.add(section.material.upper())
    lines = [line for line in block.lines if any(line[1])]
    thickness = (block.number(lines[0], 0) if lines else 0.0) or 1.0
    if thickness < 0:
        raise BadInput(block.place, "the thickness of this cohesive section is negative: correct it")
    if block.option("THICKNESS") not in ("", "SPECIFIED"):
        text = f"a cohesive section with THICKNESS={clip(block.option('THICKNESS'))} (the moduli over that of the mesh)"
        deck.ledger.refuse("COHESIVE SECTION.THICKNESS", section.place, text, LEFT_OUT)
        return None
    for other in found.parts:
        if (other.keyword not in READ
                and not deck.ledger.refuse(f"COHESIVE SECTION.{other.keyword}", other.place,
                                           f"*{other.keyword} of the material of cohesive elements", "it is left out")):
            return None
    return Bonds("COHESIVE SECTION", section.place, found.parts, "ELASTIC", LEFT_OUT, thickness)


def deletes(deck: AbaqusDeck, section: Section) -> bool:
    """Whether elements go when their energy is spent, or the user lets them go."""
    controls = deck.controls.get(section.controls)
    if controls is None:
        return True
    most = controls.option("MAX DEGRADATION")
    stays = (controls.option("ELEMENT DELETION") == "NO"
             or most and controls.number((controls.place.line, [most]), 0) < LEAST_DEGRADATION)
    return not stays or deck.ledger.refuse("SECTION CONTROLS.ELEMENT DELETION", controls.place,
                                           "cohesive elements that stay when their energy is spent",
                                           "their nodes let go")
