"""Elements of plane stress: shells with one point through their thickness,
which stay in their plane; loads on their edges."""

from collections.abc import Callable

from ..ledger import Place
from ..model import Block as Part
from ..model import Deck
from .deck import AbaqusDeck
from .mesh import PLANES, Section

NO_EDGE = "a surface of plane elements, whose faces are edges"


def take_plane(deck: AbaqusDeck, section: Section, part: Part, kind: str) -> None:
    """The data line of *SOLID SECTION is the thickness, 1 where it is blank."""
    section.points, section.thickness = 1, section.area or 1.0
    part.is_plane = True
    deck.ledger.approximated(f"ELEMENT.{kind}", section.place,
                             "plane stress: shells with one point through their thickness, which stay in their plane")


def hold_planes(deck: AbaqusDeck) -> None:
    """Nodes of plane elements have two directions. What touches there are edges, which percuss has not."""
    for part in deck.model.blocks:
        if part.is_plane:
            deck.model.add("conditions", {"nodes": part.name, "fixed": ["z"]})
            if deck.generals or deck.pairs:
                deck.ledger.refuse("ELEMENT.contact", part.place, "contact of plane elements",
                                   "their faces touch, not their edges")


def list_edges(deck: AbaqusDeck, name: str, place: Place) -> dict[int, float] | None:
    """Edges of a surface of plane elements: half of the area of its edges at each node.
    None where it is of other elements."""
    sides = deck.resolve(deck.mesh.surfaces, name, place, "surface")
    areas: dict[int, float] = {}
    is_plane, known = False, set()
    for where, label in sides:
        for id in [id for id in deck.elements_of(where, place) if id in deck.blocks_of_elements]:
            kind, corners = deck.mesh.elements[id]
            if kind not in PLANES:
                continue
            is_plane = True
            number = int(label[1:]) if label[:1] == "S" and label[1:].isdigit() else 0
            if not 1 <= number <= len(corners):
                deck.ledger.refuse("SURFACE.plane", place, NO_EDGE, "these have no load")
                continue
            if (id, number) in known:
                continue
            known.add((id, number))
            a, b = corners[number - 1], corners[number % len(corners)]
            (xa, ya, _), (xb, yb, _) = deck.mesh.nodes[a], deck.mesh.nodes[b]
            part = deck.model.blocks[deck.blocks_of_elements[id]]
            for node in (a, b):
                areas[node] = (areas.get(node, 0.0)
                               + 0.5 * ((xb - xa) ** 2 + (yb - ya) ** 2) ** 0.5 * (part.thickness or 1.0))
    return areas if is_plane else None


def write_traction(deck: AbaqusDeck, name: str, areas: dict[int, float], direction: list[float],
                   done: Callable[[], None]) -> Callable[[float | Deck], None]:
    """A traction on edges: forces on their nodes, by the area at the start."""
    length = sum(c * c for c in direction) ** 0.5

    def write(value: "float | Deck") -> None:
        groups: dict[float, list[int]] = {}
        for node, area in areas.items():
            groups.setdefault(float(f"{area:.12g}"), []).append(node)
        for area, nodes in groups.items():
            force = {axis: scale(value, area * c / length) for axis, c in zip("xyz", direction) if c}
            entry = {"nodes": deck.model.add_node_set(name, nodes), "force": force}
            deck.model.deck.setdefault("loads", {}).setdefault("nodal", []).append(entry)
        done()

    return write


def scale(value: "float | Deck", factor: float) -> "float | Deck":
    """A value, or a table of it over time."""
    if not isinstance(value, dict):
        return value * factor
    return {**value, "table": [[time, one * factor] for time, one in value["table"]]}
