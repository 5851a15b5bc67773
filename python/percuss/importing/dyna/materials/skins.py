"""Shells of *MAT_NULL on solids, and beams of it on solids or shells: they have mass and touch, and nothing else."""

from typing import NamedTuple

from ...ledger import Place
from ...model import Block
from ...shapes import measure_block
from ..deck import KeywordDeck


class Skin(NamedTuple):
    """Its nodes, which are those of bodies, and the parts of these: of solids, under beams of shells too."""

    name: str
    nodes: list[int]
    solids: list[int]
    mass: float
    place: Place


def cover(deck: KeywordDeck, block: Block, density: float) -> bool:
    """Whether the shells of a block lie on solids, or its beams on solids and shells;
    these have their mass then, and touch in their place."""
    nodes = deck.model.nodes_of_blocks([block.id])
    below = {other.part: deck.model.nodes_of_blocks([other.id])
             for other in deck.model.blocks if other.solids or (block.beams and other.shells)}
    solids = sorted(part for part, own in below.items() if own & nodes)
    if not nodes <= set().union(*(below[part] for part in solids)):
        return False
    block.density = density + block.more_density
    deck.skins.setdefault(block.part, []).append(Skin(block.name, sorted(nodes), solids,
                                                      measure_block(deck.model, block)[0], block.place))
    text = ("a skin on solids: its mass is that of its nodes, in equal shares; "
            "contact takes the solids, at their own faces")
    if block.beams:
        text = ("beams on shells or solids: their mass is that of their nodes, in equal shares; "
                "contact takes the bodies, whose edges touch edges")
    deck.ledger.approximated("MAT_NULL", block.place, text)
    return True


def add_skin_masses(deck: KeywordDeck) -> None:
    for skins in deck.skins.values():
        for skin in skins:
            nodes = deck.make_node_set(f"nodes_of_{skin.name}", skin.nodes, skin.place)
            if nodes and skin.mass > 0:
                deck.model.add("added_mass", {"nodes": nodes, "mass": skin.mass, "spread": "evenly"})
