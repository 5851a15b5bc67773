"""*ORIENTATION: the axes of orthotropic materials and of user code."""

import math
from dataclasses import replace

from ..fields import clip
from ..laminates import find_angle, list_normals
from ..ledger import BadInput, missing
from ..model import Deck, Layer, Vector
from ..shapes import cross, normalise, subtract
from .deck import AbaqusDeck
from .lines import Block
from .mesh import RIGID, SHELLS, Orientation, Scope, Section

NORMAL = math.cos(math.radians(0.1))  # of a shell to the x axis: then z gives its axis 1
UNIT: tuple[Vector, Vector, Vector] = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


def read_orientation(scope: Scope, block: Block) -> None:
    """A point a on x and a point b in the plane of x and y, from the origin or c;
    then an axis and an angle about it."""
    name = block.option("NAME")
    if not name:
        raise BadInput(block.place, "*ORIENTATION has no name: add NAME=")
    found = Orientation(block.place, UNIT)
    lines = [line for line in block.lines if any(line[1])]
    if block.option("SYSTEM") not in ("", "RECTANGULAR"):
        found.reason = f"SYSTEM={clip(block.option('SYSTEM'))}"
    elif block.option("DEFINITION") not in ("", "COORDINATES"):
        found.reason = f"DEFINITION={clip(block.option('DEFINITION'))}"
    elif lines and len([word for word in lines[0][1] if word]) < 4:
        found.reason = "axes of a *DISTRIBUTION"
    elif lines:
        a, b, c = (tuple(block.number(lines[0], 3 * i + d) for d in range(3)) for i in range(3))
        x, y = subtract(a, c), subtract(b, c)  # type: ignore[arg-type]
        z = normalise(cross(x, y))
        if not any(z):
            raise BadInput(block.at(lines[0][0]), "the points a and b of *ORIENTATION lie on one line with its origin "
                                                  "(they give no axes): correct them")
        found.axes = normalise(x), normalise(cross(z, x)), z
    if len(lines) > 1:
        found.about, found.angle = block.integer(lines[1], 0, 1), block.number(lines[1], 1)
        if not 1 <= found.about <= 3:
            raise BadInput(block.at(lines[1][0]), "the axis of *ORIENTATION is 1, 2 or 3: correct it")
    scope.orientations[name] = found


def turn_orientation(found: Orientation) -> Orientation:
    """Its axes with the additional rotation."""
    if not found.about or not found.angle:
        return found
    i, j = found.about % 3, (found.about + 1) % 3
    c, s = math.cos(math.radians(found.angle)), math.sin(math.radians(found.angle))
    axes, (a, b) = list(found.axes), (found.axes[i], found.axes[j])
    axes[i] = tuple(c * p + s * q for p, q in zip(a, b))  # type: ignore[assignment]
    axes[j] = tuple(c * q - s * p for p, q in zip(a, b))  # type: ignore[assignment]
    return replace(found, axes=tuple(axes), angle=0.0)


def find_orientation(deck: AbaqusDeck, name: str, section: Section, of_shells: bool) -> Orientation | None:
    """None where it is refused."""
    table = deck.mesh.orientations
    if name not in table:
        raise BadInput(section.place, missing(f"orientation '{clip(name)}'"))
    found = table[name]
    if found.reason:
        deck.ledger.refuse("ORIENTATION", found.place, f"an orientation with {found.reason}",
                           "the axes are those of space")
        return replace(found, axes=UNIT, about=3)
    if of_shells and not found.about:
        deck.ledger.refuse("ORIENTATION.axis", found.place,
                           "an orientation of shells without its second line, so that its first axis is their normal",
                           "it is read as with '3, 0.'")
        return replace(found, about=3)
    return turn_orientation(found)


def list_shells(deck: AbaqusDeck, section: Section) -> list[tuple[int, tuple[int, ...]]]:
    """Shells of a section."""
    elements = deck.mesh.elements
    ids = [id for id in deck.elements_of(section.elements, section.place) if id in elements]
    shells = [(id, elements[id][1]) for id in ids if elements[id][0] in SHELLS and elements[id][0] not in RIGID]
    for id, corners in shells:
        for corner in corners:
            if corner not in deck.mesh.nodes:
                raise BadInput(section.place, missing(f"node {corner}, of element {id}"))
    return shells


def find_axis_of_shells(deck: AbaqusDeck, name: str, section: Section, normals: list[Vector]) -> Vector:
    """The direction that is projected on the shells: the axis behind that of the additional rotation,
    or without orientation x."""
    if name:
        found = find_orientation(deck, name, section, True)
        return found.axes[found.about % 3] if found else UNIT[0]
    along = [abs(normal[0]) > NORMAL for normal in normals]
    if any(along) and not all(along):
        deck.ledger.refuse(f"{section.kind} SECTION.ORIENTATION", section.place,
                           "shells of one section of which some have the normal x, without an orientation",
                           "x is axis 1 of all")
    return UNIT[2] if along and all(along) else UNIT[0]


def orient(deck: AbaqusDeck, section: Section, law: Deck) -> Deck:
    """An orthotropic law with the axes of a section."""
    shells = list_shells(deck, section)
    if shells:
        return {**law, "first_axis": list(find_axis_of_shells(deck, section.orientation, section,
                                                              list_normals(deck.model, shells)))}
    found = find_orientation(deck, section.orientation, section, False) if section.orientation else None
    if found and law["model"] == "user" and found.axes == UNIT:
        return law
    return {**law, "first_axis": list(found.axes[0]), "second_axis": list(found.axes[1])} if found else law


def read_angles(deck: AbaqusDeck, section: Section) -> list[Layer]:
    """The layers of a section with their angles from its own axes; some name an orientation instead."""
    layers: list[Layer] = []
    normals = list_normals(deck.model, list_shells(deck, section))
    total = sum(layer.thickness for layer in section.layers)
    for layer in section.layers:
        angle: float | None = layer.angle
        if layer.orientation:
            main, own = (find_axis_of_shells(deck, name, section, normals)
                         for name in (section.orientation, layer.orientation))
            angle = find_angle(normals, main, own)
        if angle is None:
            deck.ledger.refuse(f"{section.keyword}.COMPOSITE", section.place,
                               f"the orientation {clip(layer.orientation)} of a layer, "
                               "at angles that differ between its shells", "its angle is 0")
        layers.append(Layer(layer.material, layer.thickness / total, angle or 0.0))
    return layers
