"""Shells of *MAT_NULL on solids: they have mass and touch, and nothing else."""

from typing import NamedTuple

from ...ledger import Place
from ...model import Block
from ...shapes import measure_block
from ..deck import KeywordDeck


class Skin(NamedTuple):
    """Its nodes, which are those of solids, and the parts of these solids."""

    name: str
    nodes: list[int]
    solids: list[int]
    mass: float
    place: Place


def cover(deck: KeywordDeck, block: Block, density: float) -> bool:
    """Whether the shells of a block lie on solids; the solids have their mass then, and touch in their place."""
    nodes = deck.model.nodes_of_blocks([block.id])
    below = {other.part: deck.model.nodes_of_blocks([other.id]) for other in deck.model.blocks if other.solids}
    solids = sorted(part for part, own in below.items() if own & nodes)
    if not nodes <= set().union(*(below[part] for part in solids)):
        return False
    block.density = density + block.more_density
    deck.skins.setdefault(block.part, []).append(Skin(block.name, sorted(nodes), solids, measure_block(deck.model, block)[0], block.place))
    deck.ledger.approximated("MAT_NULL", block.place, "a skin on solids: its mass is that of its nodes, in equal shares; contact takes the solids, at their own faces")
    return True


def add_skin_masses(deck: KeywordDeck) -> None:
    for skins in deck.skins.values():
        for skin in skins:
            nodes = deck.make_node_set(f"nodes_of_{skin.name}", skin.nodes, skin.place)
            if nodes and skin.mass > 0:
                deck.model.add("added_mass", {"nodes": nodes, "mass": skin.mass, "spread": "evenly"})
