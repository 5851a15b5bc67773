"""How far a tie of LS-DYNA reaches."""

from ..model import Block
from ..shapes import dot, subtract
from .deck import KeywordDeck

SHARE_OF_THICKNESS, SHARE_OF_DIAGONAL = 0.6, 0.05
SMALLEST = 1e-3  # share of a reach: what overlaps within the thickness of shells is always tied


def find_reach(deck: KeywordDeck, nodes: set[int], faces: set[int], thicknesses: list[float]) -> float:
    """Nodes are tied within 0.6 of both thicknesses or 0.05 of a diagonal of a face, whichever is larger. thicknesses:
    SST and MST, 0 where those of the shells count; where one is negative these alone count. percuss measures from the
    surfaces of shells, LS-DYNA from their middle. 0: the reach of percuss, which is 0.05 of an edge."""
    own = [find_thickness(deck, side) for side in (nodes, faces)]
    reach = SHARE_OF_THICKNESS * sum(abs(given) or thickness for given, thickness in zip(thicknesses, own))
    if min(thicknesses) < 0:
        reach = SHARE_OF_THICKNESS * sum(abs(given) for given in thicknesses)
    elif any(thicknesses) or reach - sum(own) / 2 > SHARE_OF_DIAGONAL * find_diagonal(deck, faces):
        reach = max(reach, SHARE_OF_DIAGONAL * find_diagonal(deck, faces))
    else:
        return 0.0
    return max(reach - sum(own) / 2, SMALLEST * reach)


def find_thickness(deck: KeywordDeck, nodes: set[int]) -> float:
    """The largest of the shells at these nodes."""
    blocks = [block for block in deck.model.blocks if block.shells]
    return max((thickness_at(block, nodes) for block in blocks), default=0.0)


def thickness_at(block: Block, nodes: set[int]) -> float:
    touching = [id for id, corners in block.shells if not nodes.isdisjoint(corners)]
    if not touching:
        return 0.0
    return max(block.thicknesses[id] for id in touching) if block.thicknesses else block.thickness or 0.0


def find_diagonal(deck: KeywordDeck, nodes: set[int]) -> float:
    """The shortest of the shells whose corners these nodes are; 0 where there is none."""
    corners_of = (corners for block in deck.model.blocks for _, corners in block.shells if nodes.issuperset(corners))
    diagonals = (subtract(deck.nodes[a], deck.nodes[b]) for c in corners_of for a, b in ((c[0], c[2]), (c[1], c[-1])))
    return float(min((dot(d, d) for d in diagonals), default=0.0) ** 0.5)
