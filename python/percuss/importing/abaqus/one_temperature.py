"""Tables of a material over the temperature, in decks whose temperatures do not change:
the rows of the one temperature."""

from dataclasses import replace

from ..curves import Points, interpolate
from .deck import AbaqusDeck, MaterialBlocks
from .lines import Block

CONSTANTS = {"DENSITY": 1, "ELASTIC": 2}  # numbers in front of the temperature


def settle_temperature(deck: AbaqusDeck, name: str, material: MaterialBlocks) -> MaterialBlocks:
    """The material at the one temperature of its elements;
    as it stands where there are several, or where it gets warm."""
    tables = [block for block in material.parts if has_temperatures(block)]
    if deck.heats or not tables:
        return material
    found = find_temperatures(deck, name.upper())
    if len(found) != 1:
        return material
    value = found.pop()
    parts = []
    for block in material.parts:
        settled = settle_block(block, value) if block in tables else None
        parts.append(settled or block)
        if settled:
            deck.ledger.translated(block.keyword, block.place,
                                   f"its values at the temperature {value:g}, which does not change")
    return MaterialBlocks(material.place, parts)


def has_temperatures(block: Block) -> bool:
    """Whether rows stand for several temperatures, in a table that is read here."""
    if block.keyword == "PLASTIC":
        is_read = block.option("HARDENING") in ("", "ISOTROPIC", "KINEMATIC")
        return is_read and len({block.number(line, 2) for line in block.lines}) > 1
    is_read = (block.keyword in CONSTANTS and block.option("TYPE") in ("", "ISOTROPIC")
               and "DEPENDENCIES" not in block.options)
    return is_read and len(block.lines) > 1


def find_temperatures(deck: AbaqusDeck, name: str) -> set[float]:
    """Temperatures of the nodes of a material at the start; 0 in Abaqus where none is given."""
    sections = [s for s in deck.mesh.sections
                if name in (s.material.upper(), *(layer.material.upper() for layer in s.layers))]
    nodes = {node for s in sections for id in deck.elements_of(s.elements, s.place) if id in deck.mesh.elements
             for node in deck.mesh.elements[id][1]}
    return {deck.temperatures.get(node, 0.0) for node in nodes}


def settle_block(block: Block, value: float) -> Block | None:
    """Linear between the temperatures, and constant beyond them; None: one stands twice, or tables do not fit."""
    number = block.lines[0][0]
    if block.keyword == "PLASTIC":
        rows = settle_curves(block, value)
        return (replace(block, lines=[(number, [repr(stress), repr(strain)]) for strain, stress in rows])
                if rows else None)
    count = CONSTANTS[block.keyword]
    columns = [sorted((block.number(line, count), block.number(line, i)) for line in block.lines) for i in range(count)]
    if any(a[0] == b[0] for a, b in zip(columns[0], columns[0][1:])):
        return None
    return replace(block, lines=[(number, [repr(interpolate(column, value)) for column in columns])])


def settle_curves(block: Block, value: float) -> Points:
    """The curve of stress over plastic strain at a temperature, from those at several; empty: they do not fit."""
    curves: dict[float, Points] = {}
    for line in block.lines:
        curves.setdefault(block.number(line, 2), []).append((block.number(line, 1), block.number(line, 0)))
    if any(curve[0][0] != 0 or any(b[0] <= a[0] for a, b in zip(curve, curve[1:])) for curve in curves.values()):
        return []
    strains = sorted({strain for curve in curves.values() for strain, _ in curve})
    if block.option("HARDENING") == "KINEMATIC" and any(len(curve) != len(strains) for curve in curves.values()):
        return []
    return [(strain, interpolate(sorted((t, interpolate(curve, strain)) for t, curve in curves.items()), value))
            for strain in strains]
