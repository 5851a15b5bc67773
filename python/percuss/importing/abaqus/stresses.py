"""*INITIAL CONDITIONS, TYPE=STRESS and TYPE=HARDENING: tables of start.fields."""

from collections.abc import Callable

from ..laws import takes_plastic_strain, takes_stress
from ..model import Block as ModelBlock
from ..model import Model
from .deck import AbaqusDeck
from .lines import Block, Line
from .mesh import SOLIDS

STRESSES = "stress_xx,stress_yy,stress_zz,stress_xy,stress_yz,stress_zx"
MATERIAL = "INITIAL CONDITIONS.material"

Takes = Callable[[Model, ModelBlock], bool]


def read_stresses(deck: AbaqusDeck, block: Block) -> None:
    """element or set, S11, S22, S33, S12, S13, S23 of solids, along the axes of space."""
    rows: dict[int, str] = {}
    for line in block.lines:
        values = [block.number(line, i) for i in (1, 2, 3, 4, 6, 5)]
        solids = list_solids(deck, block, line, any(values))
        taking = list_taking(deck, solids, takes_stress)
        if any(values) and len(taking) < len(solids):
            deck.ledger.refuse(
                MATERIAL, block.at(line[0]),
                "stresses of rigid bodies, or of a law whose stress does not grow in increments",
                "they begin without stress"
            )
        rows |= {id: ",".join(repr(value) for value in values) for id in taking}
    write(deck, block, "stresses.csv", STRESSES, rows)


def read_hardening(deck: AbaqusDeck, block: Block) -> None:
    """element or set, equivalent plastic strain, components of a back stress."""
    rows: dict[int, str] = {}
    for line in block.lines:
        strain = block.number(line, 1)
        if any(block.number(line, i) for i in range(2, len(line[1]))):
            deck.ledger.refuse("INITIAL CONDITIONS.back_stress", block.at(line[0]),
                               "a back stress at the start", "it starts at zero")
        ids = [id for id in deck.elements_of(block.text(line, 0), block.at(line[0])) if id in deck.blocks_of_elements]
        taking = list_taking(deck, [id for id in ids if not is_beam(deck, id) and not has_ten_nodes(deck, id)],
                             takes_plastic_strain)
        if strain and len(taking) < len(ids):
            deck.ledger.refuse(
                MATERIAL, block.at(line[0]),
                "plastic strains of rigid bodies, of beams, of tetrahedra of ten nodes, or of a law without them",
                "they begin without plastic strain"
            )
        rows |= dict.fromkeys(taking, repr(strain))
    write(deck, block, "plastic_strains.csv", "equivalent_plastic_strain", rows)


def list_taking(deck: AbaqusDeck, ids: list[int], takes: Takes) -> list[int]:
    """Elements of blocks that may begin with it."""
    blocks = deck.model.blocks
    taking = {index for index in {deck.blocks_of_elements[id] for id in ids} if takes(deck.model, blocks[index])}
    return [id for id in ids if deck.blocks_of_elements[id] in taking]


def is_beam(deck: AbaqusDeck, id: int) -> bool:
    return deck.mesh.elements[id][0].startswith(("B", "T"))


def has_ten_nodes(deck: AbaqusDeck, id: int) -> bool:
    kind, corners = deck.mesh.elements[id]
    return kind.startswith("C3D") and len(corners) == 10


def list_solids(deck: AbaqusDeck, block: Block, line: Line, counts: bool) -> list[int]:
    """Solids that are written; stresses of others have axes of their own."""
    ids = [id for id in deck.elements_of(block.text(line, 0), block.at(line[0])) if id in deck.blocks_of_elements]
    solids = [id for id in ids if deck.mesh.elements[id][0] in SOLIDS and not has_ten_nodes(deck, id)]
    if counts and len(solids) < len(ids):
        deck.ledger.refuse(
            "INITIAL CONDITIONS.elements",
            block.at(line[0]),
            "stresses of shells, beams or tetrahedra of ten nodes",
            "they begin without stress",
        )
    return solids


def write(deck: AbaqusDeck, block: Block, name: str, heading: str, rows: dict[int, str]) -> None:
    if not rows:
        deck.ledger.ignored("INITIAL CONDITIONS", block.place, "no element that it names may begin with it")
        return
    deck.model.add_start_rows(name, f"element,{heading}", {id: [f"{id},{row}"] for id, row in rows.items()})
    deck.ledger.translated("INITIAL CONDITIONS", block.place, f"start.fields: {name}")
