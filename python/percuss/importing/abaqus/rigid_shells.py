"""Rigid elements: thin shells of parts that are rigid."""

from ..fields import clip
from ..ledger import BadInput, Place, missing
from ..model import Block as Part
from ..model import Deck
from ..shapes import shell_area
from .deck import AbaqusDeck
from .mesh import RIGID

THIN = 1e-3  # thickness of rigid elements over their mean edge
STEEL = (7850.0, 2.1e11)  # density and Young's modulus in SI units


def build_rigid_parts(deck: AbaqusDeck) -> None:
    """Elements R3D3 and R3D4 of rigid bodies, as thin shells that are rigid."""
    for card in deck.mesh.bodies:
        ids = [id for id in (deck.elements_of(card.elements, card.place) if card.elements else [])
               if deck.mesh.elements.get(id, ("",))[0] in RIGID]
        ids = [id for id in ids if id not in deck.blocks_of_elements]
        if ids:
            add_rigid_shells(deck, card.elements, card.place, [(id, deck.mesh.elements[id][1]) for id in ids])


def add_rigid_shells(deck: AbaqusDeck, name: str, place: Place, shells: list[tuple[int, tuple[int, ...]]],
                     taken: str = "") -> Part:
    """A part of shells so thin that they touch where their mesh is; its mass is that of *MASS.
    taken: its name, if it has one."""
    number = 1 + max((part.id for part in deck.model.blocks), default=0)
    wish = name.rpartition(".")[0] or name
    part = Part(number, number, taken or deck.model.names.take(wish, "part"), place, shells=shells,
                keys={"material": name_rigid_material(deck)})
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
    deck.ledger.approximated("ELEMENT.rigid", place,
                             f"rigid elements are shells with the thickness of {THIN:g} of an edge")
    return part


def find_stiffness(law: Deck) -> float:
    """A modulus of a law; 0 where it has none of its own, such as one of the user's."""
    speed = law.get("equation_of_state", {}).get("sound_speed", 0.0)
    return float(law.get("youngs_modulus")
                 or max(law.get("bulk_modulus", 0.0), law.get("c10", 0.0), law["density"] * speed**2))


def name_rigid_material(deck: AbaqusDeck) -> str:
    """A law of rigid elements, which gives contact its stiffness: that of the stiffest material;
    of a model without any that of steel in SI units."""
    density, stiffness = max(((law["density"], find_stiffness(law)) for law in deck.model.materials.values()),
                             key=lambda pair: pair[1], default=STEEL)
    if not deck.rigid_material:
        deck.rigid_material = deck.model.names.take("rigid_surface", "material")
        deck.model.materials[deck.rigid_material] = {
            "model": "elastic", "density": density, "youngs_modulus": stiffness or density, "poissons_ratio": 0.3,
        }  # fmt: skip
    return deck.rigid_material
