"""*INITIAL CONDITIONS, TYPE=STRESS and TYPE=HARDENING: tables of start.fields."""

from .deck import AbaqusDeck
from .lines import Block

STRESSES = "stress_xx,stress_yy,stress_zz,stress_xy,stress_yz,stress_zx"


def read_stresses(deck: AbaqusDeck, block: Block) -> None:
    """element or set, S11, S22, S33, S12, S13, S23 of solids, along the axes of space."""
    rows: dict[int, str] = {}
    for line in block.lines:
        values = [block.number(line, i) for i in (1, 2, 3, 4, 6, 5)]
        for id in list_solids(deck, block, line, any(values)):
            rows[id] = ",".join(repr(value) for value in values)
    write(deck, block, "stresses.csv", STRESSES, rows)


def read_hardening(deck: AbaqusDeck, block: Block) -> None:
    """element or set, equivalent plastic strain, components of a back stress."""
    rows: dict[int, str] = {}
    for line in block.lines:
        strain = block.number(line, 1)
        if any(block.number(line, i) for i in range(2, len(line[1]))):
            deck.ledger.refuse("INITIAL CONDITIONS.back_stress", block.at(line[0]), "a back stress at the start", "it starts at zero")
        for id in deck.elements_of(block.text(line, 0), block.at(line[0])):
            if id in deck.blocks_of_elements:
                rows[id] = repr(strain)
    write(deck, block, "plastic_strains.csv", "equivalent_plastic_strain", rows)


def list_solids(deck: AbaqusDeck, block: Block, line: tuple[int, list[str]], counts: bool) -> list[int]:
    """Solids that are written; stresses of others have axes of their own."""
    ids = [id for id in deck.elements_of(block.text(line, 0), block.at(line[0])) if id in deck.blocks_of_elements]
    solids = [id for id in ids if deck.mesh.elements[id][0].startswith("C3D") and len(deck.mesh.elements[id][1]) != 10]
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
        deck.ledger.ignored("INITIAL CONDITIONS", block.place, "what it names has no element")
        return
    deck.model.add_start_table(name, f"element,{heading}", [f"{id},{row}" for id, row in rows.items()])
    deck.ledger.translated("INITIAL CONDITIONS", block.place, f"start.fields: {name}")
