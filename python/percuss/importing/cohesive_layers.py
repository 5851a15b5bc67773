"""Cohesive elements between solids: cohesive ties of the faces below and above them."""

import math
from collections.abc import Iterable
from dataclasses import dataclass, field

from .ledger import Ledger, Place
from .model import Deck, Model, Vector
from .shapes import cross, dot, mean, subtract
from .solids import FACES

LEFT_OUT = "they are left out"  # what happens to the elements where that is allowed
REACH = 1.01  # share of the thickness of a layer, within which its nodes find the other side
TIED = 0.1  # share of the largest edge or diagonal of its faces: solids within this distance of a layer are tied to it
SAME_AREA = 0.05  # by which the faces of solids at a layer may differ from it
Faces = list[tuple[int, ...]]


@dataclass
class Layer:
    """Cohesive elements of one law, and the faces below and above them:
    their own, or those of solids that are tied to them."""

    wish: str  # what the sides may be called
    place: Place
    law: Deck
    own: tuple[Faces, Faces]
    gap: float  # the largest distance between both sides
    sides: list[Faces] = field(default_factory=lambda: [[], []])  # of solids; empty: there are none so far

    def nodes(self, side: int) -> set[int]:
        return {node for face in self.own[side] for node in face}


def make_layer(model: Model, wish: str, elements: Iterable[tuple[int, tuple[int, ...]]], law: Deck,
               place: Place) -> Layer:
    """elements: (id, corners), those of the face below first; corners that are named more than once are of wedges.
    Sides whose faces are those of solids are known then."""
    below, above, gap = [], [], 0.0
    for _, corners in elements:
        half = len(corners) // 2
        below.append(tuple(dict.fromkeys(corners[:half])))
        above.append(tuple(dict.fromkeys(corners[half:])))
        gap = max([gap, *(math.dist(model.nodes[a], model.nodes[b]) for a, b in zip(corners, corners[half:]))])
    layer = Layer(wish, place, law, (below, above), gap)
    known = {frozenset(corners[i] for i in face) for block in model.blocks for _, corners in block.solids
             for face in FACES[len(corners)]}
    for side, faces in enumerate(layer.own):
        if all(frozenset(face) in known for face in faces):
            layer.sides[side] = faces
    return layer


def add_layer(model: Model, ledger: Ledger, layer: Layer) -> bool:
    """Ties the solids on both sides. Returns whether that is done; else the ledger says why not."""
    fault = find_fault(model, layer)
    if fault:
        ledger.refuse("ELEMENT.cohesive", layer.place, fault, LEFT_OUT)
        return False
    tie: Deck = {}
    finer = 0 if len(layer.sides[0]) >= len(layer.sides[1]) else 1  # its nodes are the points of glue
    for key, side in (("a", finer), ("b", 1 - finer)):
        tie[key] = model.names.take(f"{layer.wish}_{('below', 'above')[side]}")
        model.side_sets[tie[key]] = layer.sides[side]
    reach = (layer.gap
             + sum(find_distance(model, faces, own) for faces, own in zip(layer.sides, layer.own) if faces is not own))
    if reach > 0:
        tie["distance"] = REACH * reach
    model.deck.setdefault("contact", {}).setdefault("ties", []).append(tie | {"cohesive": layer.law})
    text = ("contact.ties with cohesive between the solids on both sides: a point of glue at each node of the finer "
            "one; the mass of the layer is left out")
    ledger.approximated("ELEMENT.cohesive", layer.place, text)
    return True


def find_fault(model: Model, layer: Layer) -> str:
    """Why a layer is no tie of solids; empty: it is."""
    if any(len(face) < 3 for faces in layer.own for face in faces):
        return "cohesive elements without area"
    if not all(layer.sides):
        return "cohesive elements whose faces are not those of solids on both sides"
    if {node for face in layer.sides[0] for node in face} & {node for face in layer.sides[1] for node in face}:
        return "cohesive elements that end in a node of both sides"
    for faces, own in zip(layer.sides, layer.own):
        area, wanted = find_area(model, faces), find_area(model, own)
        if abs(area - wanted) > SAME_AREA * wanted:
            return f"cohesive elements with an area of {wanted:.4g}, which lie at faces of solids with {area:.4g}"
    return ""


def find_energy_fault(law: Deck) -> str:
    """Direction in which the energy of a law is less than what it has stored at its strength; empty: in none."""
    for of in ("normal", "shear"):
        if law[f"{of}_energy"] <= 0.5 * law[f"{of}_strength"] ** 2 / law[f"{of}_stiffness"]:
            return of
    return ""


# --- solids that are tied to a layer


def choose_covered(model: Model, faces: Faces, own: Faces) -> Faces:
    """Faces that lie at a layer.
    The layer's faces are sorted into cells of a grid as wide as the largest of them."""
    if not own or not faces:
        return []
    size = max(math.dist(model.nodes[a], model.nodes[b]) for face in own for a in face for b in face)
    cells: dict[tuple[int, ...], list[list[Vector]]] = {}
    for face in own:
        x = [model.nodes[node] for node in face]
        cells.setdefault(cell_of(mean(x), size), []).append(x)
    found: Faces = []
    for face in faces:
        x = [model.nodes[node] for node in face]
        if any(covers(other, x, TIED * size) for other in near(cells, mean(x), size)):
            found.append(face)
    return found


def cell_of(x: Vector, size: float) -> tuple[int, ...]:
    return tuple(math.floor(c / size) for c in x)


def near(cells: dict[tuple[int, ...], list[list[Vector]]], x: Vector, size: float) -> Iterable[list[Vector]]:
    """Faces in the cell of a point and those around it."""
    i, j, k = cell_of(x, size)
    for a in (i - 1, i, i + 1):
        for b in (j - 1, j, j + 1):
            for c in (k - 1, k, k + 1):
                yield from cells.get((a, b, c), ())


def covers(face: list[Vector], other: list[Vector], far: float) -> bool:
    """Whether the middle of another face lies over a face, not farther than that from its plane, and they are parallel
    within 45 degrees."""
    normal, turned, x = area_vector(face), area_vector(other), mean(other)
    size = math.sqrt(dot(normal, normal)) or 1.0
    if (abs(dot(normal, subtract(x, mean(face)))) > far * size
            or 2 * dot(normal, turned) ** 2 < size**2 * dot(turned, turned)):
        return False
    edges = zip(face, face[1:] + face[:1])
    return all(dot(normal, cross(subtract(b, a), subtract(x, a))) >= -1e-9 * size * size for a, b in edges)


def area_vector(x: list[Vector]) -> Vector:
    """Normal of a face of three or four corners, as long as its area."""
    twice = cross(subtract(x[2], x[0]), subtract(x[-1], x[1 if len(x) == 4 else 0]))
    return (0.5 * twice[0], 0.5 * twice[1], 0.5 * twice[2])


def find_area(model: Model, faces: Faces) -> float:
    vectors = [area_vector([model.nodes[node] for node in face]) for face in faces]
    return sum(math.sqrt(dot(v, v)) for v in vectors)


def find_distance(model: Model, faces: Faces, own: Faces) -> float:
    """The largest distance of a node of faces from the plane of the closest face of a layer."""
    planes = [(mean(x), area_vector(x)) for x in ([model.nodes[node] for node in face] for face in own)]
    largest = 0.0
    for node in {node for face in faces for node in face}:
        x = model.nodes[node]
        middle, normal = min(planes, key=lambda plane: math.dist(plane[0], x))
        largest = max(largest, abs(dot(normal, subtract(x, middle))) / (math.sqrt(dot(normal, normal)) or 1.0))
    return largest
