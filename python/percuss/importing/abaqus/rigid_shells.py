"""Rigid elements: thin shells of parts that are rigid."""

from ..fields import clip
from ..ledger import BadInput, Place, missing
from ..model import Block as Part
from ..shapes import shell_area
from .deck import AbaqusDeck
from .mesh import RIGID

THIN = 1e-3  # thickness of rigid elements over their mean edge


def build_rigid_parts(deck: AbaqusDeck) -> None:
    """Elements R3D3 and R3D4 of rigid bodies, as thin shells that are rigid."""
    for card in deck.mesh.bodies:
        ids = [id for id in (deck.elements_of(card.elements, card.place) if card.elements else []) if deck.mesh.elements.get(id, ("",))[0] in RIGID]
        ids = [id for id in ids if id not in deck.blocks_of_elements]
        if ids:
            add_rigid_shells(deck, card.elements, card.place, [(id, deck.mesh.elements[id][1]) for id in ids])


def add_rigid_shells(deck: AbaqusDeck, name: str, place: Place, shells: list[tuple[int, tuple[int, ...]]], taken: str = "") -> Part:
    """A part of shells so thin that they touch where their mesh is; its mass is that of *MASS. taken: its name, if it has one."""
    number = 1 + max((part.id for part in deck.model.blocks), default=0)
    wish = name.rpartition(".")[0] or name
    part = Part(number, number, taken or deck.model.names.take(wish, "part"), place, shells=shells, keys={"material": name_rigid_material(deck)})
    for id, corners in shells:
        if len(corners) not in (3, 4) or not deck.mesh.nodes.keys() >= set(corners):
            raise BadInput(place, missing(f"a node of rigid element {id}"))
        deck.blocks_of_elements[id] = len(deck.model.blocks)
    sizes = [shell_area([deck.mesh.nodes[node] for node in corners]) ** 0.5 for _, corners in shells]
    if min(sizes) <= 0:
        raise BadInput(place, f"a rigid element of '{clip(name)}' has no area: correct its nodes")
    part.thickness = float(f"{THIN * sum(sizes) / len(sizes):.6g}")
    part.density = deck.model.materials[part.keys["material"]]["density"]
    part.keys["points"] = 1
    deck.model.blocks.append(part)
    deck.ledger.approximated("ELEMENT.rigid", place, f"rigid elements are shells with the thickness of {THIN:g} of an edge")
    return part


def name_rigid_material(deck: AbaqusDeck) -> str:
    """A law of rigid elements, which gives contact its stiffness: that of the stiffest material."""
    laws = [law for law in deck.model.materials.values() if "youngs_modulus" in law]
    stiffest = max(laws, key=lambda law: law["youngs_modulus"], default={"density": 1.0, "youngs_modulus": 1.0})
    if not deck.rigid_material:
        deck.rigid_material = deck.model.names.take("rigid_surface", "material")
        deck.model.materials[deck.rigid_material] = {
            "model": "elastic", "density": stiffest["density"], "youngs_modulus": stiffest["youngs_modulus"], "poissons_ratio": 0.3,
        }  # fmt: skip
    return deck.rigid_material
