"""Plies of shells, and what orthotropic laws need of elements: axes in their plane, sizes."""

import math
from collections.abc import Callable, Iterable, Sequence

from .laws import has_axes
from .ledger import Ledger, Place
from .model import Block, Deck, Layer, Model, Vector
from .shapes import cross, dot, normalise, shell_area, subtract

MOST_POINTS = 48  # of all plies
SAME_ANGLE = 1e-3  # degrees: round-off of coordinates with seven digits
SAME_AXIS = 1e-6


def gauss_shares(count: int) -> list[float]:
    """Weights of Gauss' rule, from one end to the other, as shares of the whole."""
    weights: list[float] = []
    for i in range(count):
        x = math.cos(math.pi * (count - i - 0.25) / (count + 0.5))
        slope = 1.0
        for _ in range(50):
            before, value = 1.0, x
            for n in range(2, count + 1):
                before, value = value, ((2 * n - 1) * x * value - (n - 1) * before) / n
            slope = count * (x * value - before) / (x * x - 1) if count > 1 else 1.0
            step = value / slope
            x -= step
            if abs(step) < 1e-15:
                break
        weights.append(1 / ((1 - x * x) * slope * slope))
    return weights


def join_equal(layers: Sequence[Layer]) -> list[Layer]:
    """Neighbours of one material and angle as one layer."""
    joined: list[Layer] = []
    for layer in layers:
        if joined and (joined[-1].material, joined[-1].angle) == (layer.material, layer.angle):
            joined[-1] = Layer(layer.material, joined[-1].share + layer.share, layer.angle)
        else:
            joined.append(layer)
    return joined


def add_plies(block: Block, layers: Sequence[Layer], laws: "dict[int | str, tuple[str, Deck]]",
              turns: "dict[int | str, float]") -> "tuple[str, Deck]":
    """Gives a block its plies; returns the name and the law of its own material, from whose axes the angles count.

    laws: name and law of each material. turns: angle between the axes of a law and those of its material.
    """
    main = find_main(layers, laws)
    name = laws[main][0]
    plies: list[Deck] = []
    for layer in layers:
        law_name, law = laws[layer.material]
        ply: Deck = {"thickness": layer.share * (block.thickness or 0.0)}
        angle = layer.angle + turns.get(layer.material, 0.0) if has_axes(law) else 0.0
        if angle:
            ply["angle"] = angle
        if law_name != name:
            ply["material"] = law_name
        plies.append(ply)
    block.keys["plies"] = plies
    block.density = math.fsum(layer.share * laws[layer.material][1]["density"] for layer in layers)
    return laws[main]


def find_main(layers: Sequence[Layer], laws: "dict[int | str, tuple[str, Deck]]") -> int | str:
    """The material whose axes and failure count for a part: the first that has axes, and failure before others."""
    order = sorted(layers,
                   key=lambda layer: ("failure" not in laws[layer.material][1], not has_axes(laws[layer.material][1])))
    with_axes = [layer for layer in order if has_axes(laws[layer.material][1])]
    return (with_axes or order)[0].material


def find_difference(layers: Sequence[Layer], laws: "dict[int | str, tuple[str, Deck]]") -> str:
    """What plies of one part cannot have each for itself: axes, failure. Empty: they have the same."""
    main = laws[find_main(layers, laws)][1]
    for layer in layers:
        law = laws[layer.material][1]
        if has_axes(law) and not have_same_axes(law, main):
            return "axes"
        if any(main.get("failure", {}).get(key) != value for key, value in law.get("failure", {}).items()):
            return "failure"
    return ""


def have_same_axes(a: Deck, b: Deck) -> bool:
    if a.get("axes") != b.get("axes"):
        return False
    x, y = (normalise(law.get("first_axis", (1.0, 0.0, 0.0))) for law in (a, b))
    return max(abs(p - q) for p, q in zip(x, y)) <= SAME_AXIS


def find_size(model: Model, shells: Sequence[tuple[int, tuple[int, ...]]]) -> float:
    """The mean edge of shells."""
    sizes = [shell_area([model.nodes[node] for node in corners]) ** 0.5 for _, corners in shells]
    return math.fsum(sizes) / len(sizes) if sizes else 0.0


def find_crack_energy(strength: float, modulus: float, strain: float, share: float, size: float) -> float:
    """Energy per area of a stress that stays at a share of its strength up to a strain, over the size of an element;
    0 where it falls at once."""
    first = strength / modulus
    return (0.5 * strength * first + share * strength * (strain - first)) * size if strain > first else 0.0


def list_normals(model: Model, shells: Iterable[tuple[int, tuple[int, ...]]]) -> list[Vector]:
    normals = []
    for _, corners in shells:
        x = [model.nodes[node] for node in corners]
        normals.append(normalise(cross(subtract(x[2], x[0]), subtract(x[-1], x[1])) if len(x) == 4
                                 else cross(subtract(x[1], x[0]), subtract(x[2], x[0]))))
    return normals


def project(axis: Vector, normal: Vector) -> Vector:
    """What of an axis lies across a normal."""
    along = dot(axis, normal)
    return (axis[0] - along * normal[0], axis[1] - along * normal[1], axis[2] - along * normal[2])


def find_angle(normals: Sequence[Vector], main: Vector, axis: Vector) -> float | None:
    """Degrees from one axis to another about the normals of shells, where they are the same on all of them."""
    angles = []
    for normal in normals:
        a, b = project(main, normal), project(axis, normal)
        angles.append(math.degrees(math.atan2(dot(normal, cross(a, b)), dot(a, b))))
    return (angles[0]
            if angles and all(abs(math.remainder(angle - angles[0], 360)) <= SAME_ANGLE for angle in angles) else None)


def reduce_points(ledger: Ledger, card: str, place: Place, layers: list[Layer]) -> list[Layer]:
    """As many layers as a part may have."""
    if len(layers) <= MOST_POINTS:
        return layers
    joined = join_equal(layers)
    if len(joined) > MOST_POINTS:
        ledger.refuse(card, place, f"{len(joined)} plies (percuss takes {MOST_POINTS})")
        return joined[:MOST_POINTS]
    ledger.approximated(card, place,
                        f"{len(layers)} plies become {len(joined)}: neighbours of one material and angle are one")
    return joined


def find_element_axes(model: Model, solids: Iterable[tuple[int, tuple[int, ...]]]) -> "tuple[Vector, Vector] | None":
    """Axes 1 and 2 by the corners 1, 2 and 4 of solids, where all have the same."""
    pick: Callable[[int], Vector] = model.nodes.__getitem__
    found: tuple[Vector, Vector] | None = None
    for _, corners in solids:
        if len(corners) != 8:
            return None
        x = normalise(subtract(pick(corners[1]), pick(corners[0])))
        y = normalise(project(subtract(pick(corners[3]), pick(corners[0])), x))
        found = found or (x, y)
        if max(abs(p - q) for a, b in zip(found, (x, y)) for p, q in zip(a, b)) > SAME_AXIS:
            return None
    return found
