"""A model as both readers leave it: a mesh with its sets, and the sections of a deck."""

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from typing import Any

from .ledger import Place

Vector = tuple[float, float, float]
Deck = dict[str, Any]

RESERVED = {"all", "top", "bottom"}


@dataclass
class Layer:
    """A ply of shells, before its material is translated."""

    material: int | str
    share: float  # of the thickness
    angle: float = 0.0  # degrees


@dataclass
class Block:
    """Elements of one part: a part of the deck.

    solids, shells and beams: (id, corners). A shell has 3 or 4 corners, a solid as many as solids.py says.
    """

    id: int
    part: int
    name: str
    place: Place
    solids: list[tuple[int, tuple[int, ...]]] = field(default_factory=list)
    shells: list[tuple[int, tuple[int, ...]]] = field(default_factory=list)
    beams: list[tuple[int, tuple[int, ...]]] = field(default_factory=list)
    thickness: float | None = None
    thicknesses: dict[int, float] = field(default_factory=dict)  # of shells, by id, where they differ
    layers: list[Layer] = field(default_factory=list)  # of shells, from the bottom
    angles: set[float] = field(default_factory=set)  # of axes of materials, that shells have themselves; 0: none
    has_systems: bool = False  # some have a system of axes of their own
    keys: Deck = field(default_factory=dict)  # further keys of parts.NAME, such as points
    density: float = 0.0
    more_density: float = 0.0  # mass that is not of the material, over the volume
    is_plane: bool = False  # shells that stay in their plane

    def elements(self) -> list[tuple[int, tuple[int, ...]]]:
        return self.solids + self.shells + self.beams

    def bends(self) -> bool:
        """Whether its nodes have rotations."""
        bends = "truss" not in self.keys.get("section", {}) and self.keys.get("integration") != "membrane"
        return bool(self.shells or self.beams) and not self.is_plane and bends


@dataclass
class StartTable:
    """A file of start.fields: its rows by the ids of elements."""

    heading: str
    rows: dict[int, list[str]] = field(default_factory=dict)


FLUID_HOURGLASS: Deck = {"kind": "viscous", "coefficient": 0.002}  # default of fluids
NESTED = ("loads", "contact", "start", "output", "elements", "time")  # sections whose own entries are lists and maps


class Origins:
    """The card that has made each entry of the deck, by its path there: (section, key or number...).
    It is noted after each card by what is new."""

    def __init__(self) -> None:
        self.cards: dict[tuple[str | int, ...], tuple[str, Place | None]] = {}
        self._counts: dict[tuple[str | int, ...], int] = {}

    def note(self, model: "Model", card: str, place: Place | None) -> None:
        """What is in the model and was not when this was last called is of the card."""
        for path, container in list_containers(model):
            known, count = self._counts.get(path, 0), len(container)
            if count > known:
                new = range(known, count) if isinstance(container, list) else list(container)[known:]
                for key in new:
                    self.cards.setdefault((*path, key), (card, place))
            self._counts[path] = count

    def find(self, path: list[str | int]) -> tuple[str, Place | None] | None:
        """The card of the innermost entry around a path."""
        for length in range(len(path), 0, -1):
            if tuple(path[:length]) in self.cards:
                return self.cards[tuple(path[:length])]
        return None


def list_containers(model: "Model") -> Iterator[tuple[tuple[str | int, ...], Any]]:
    """Maps and lists of the deck whose entries come from cards, with their paths."""
    yield (), model.deck
    yield ("materials",), model.materials
    for block in model.blocks:
        yield ("parts", block.name), block.keys
    for section, value in model.deck.items():
        if isinstance(value, (list, dict)):
            yield (section,), value
        for key, inner in value.items() if section in NESTED and isinstance(value, dict) else ():
            if isinstance(inner, (list, dict)):
                yield (section, key), inner
            for name, more in inner.items() if isinstance(inner, dict) else ():
                if isinstance(more, list):
                    yield (section, key, name), more


@dataclass
class Model:
    """All that is written. Sets are by their names in the deck."""

    title: str = ""
    units: str = ""  # that a card says
    nodes: dict[int, Vector] = field(default_factory=dict)
    blocks: list[Block] = field(default_factory=list)
    node_sets: dict[str, list[int]] = field(default_factory=dict)
    side_sets: dict[str, list[tuple[int, ...]]] = field(default_factory=dict)
    block_sets: dict[str, list[int]] = field(default_factory=dict)
    element_sets: dict[str, tuple[str, list[int]]] = field(default_factory=dict)  # kind "SHELL" or "SOLID", ids
    materials: dict[str, Deck] = field(default_factory=dict)
    deck: Deck = field(default_factory=dict)  # the other sections
    start_tables: dict[str, "StartTable"] = field(default_factory=dict)  # files beside the deck, by name
    files: dict[str, list[str]] = field(default_factory=dict)  # others of them: their lines
    names: "Names" = field(default_factory=lambda: Names())
    origins: Origins = field(default_factory=Origins)

    def used_nodes(self) -> set[int]:
        """Nodes of the elements that are written."""
        used: set[int] = set()
        for block in self.blocks:
            for _, corners in block.elements():
                used.update(corners)
        return used

    def shell_nodes(self) -> set[int]:
        return {node for block in self.blocks for _, corners in block.shells for node in corners}

    def turning_nodes(self) -> set[int]:
        """Nodes that have rotations: those of shells and of beams that bend."""
        blocks = [block for block in self.blocks if block.bends()]
        return {node for block in blocks for _, corners in block.shells + block.beams for node in corners}

    def nodes_of_blocks(self, ids: Iterable[int]) -> set[int]:
        wanted = set(ids)
        return {
            node for block in self.blocks if block.id in wanted for _, corners in block.elements() for node in corners
        }

    def add(self, section: str, entry: Deck) -> None:
        """Appends to a section of the deck that is a list."""
        self.deck.setdefault(section, []).append(entry)

    @property
    def tables(self) -> dict[str, list[str]]:
        """Files beside the deck, by name: their lines."""
        return self.files | {name: [table.heading, *(row for rows in table.rows.values() for row in rows)]
                             for name, table in self.start_tables.items()}

    def add_start_rows(self, name: str, heading: str, rows: dict[int, list[str]]) -> None:
        """Rows of elements, in a file beside the deck with its entry of start.fields.
        Of an element the later ones count."""
        if name not in self.start_tables:
            self.start_tables[name] = StartTable(heading)
            self.deck.setdefault("start", {}).setdefault("fields", []).append({"file": name})
        self.start_tables[name].rows.update(rows)

    def add_node_set(self, wish: str, nodes: Iterable[int]) -> str:
        """A set of nodes under a name of its own."""
        name = self.names.take(wish)
        self.node_sets[name] = sorted(set(nodes))
        return name


class Names:
    """Names of parts, sets, materials and points, each given once: letters, digits, '_' and '-', a letter first."""

    def __init__(self) -> None:
        self._taken: set[str] = set(RESERVED)
        self._numbers: dict[str, int] = {}  # where to go on counting

    def take(self, wish: str, otherwise: str = "set") -> str:
        """A free name like the wish."""
        base = re.sub(r"[^A-Za-z0-9_-]+", "_", wish).strip("_-")[:60] or otherwise
        if not base[0].isalpha():
            base = f"{otherwise}_{base}"
        name, number = base, self._numbers.get(base, 2)
        while name in self._taken:
            name = f"{base}_{number}"
            number += 1
        self._numbers[base] = number
        self._taken.add(name)
        return name
