"""Nodes, elements and sets of parts, and instances of them in one mesh."""

import math
from bisect import bisect_left, bisect_right
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import TypeVar

from ..fields import clip, parse_integer
from ..ledger import BadInput, Ledger, Place, missing
from ..model import Deck, Vector
from ..unique import Lines
from .lines import Block, Line

# Type: corners, kind; what percuss does not have has no kind.
STRAINED = {"CPE4R": 4, "CPE3": 3}  # of plane strain: corners in their plane, of which extrude() makes solids
RINGS = {"CAX4R": 4, "CAX3": 3}  # of rotational symmetry, of which turn_rings() makes solids of eight corners
THICK_SHELL = "SC8R"  # a solid with a section of shells
SOLIDS = {"C3D8": 8, "C3D8R": 8, THICK_SHELL: 8, "C3D6": 6, "C3D6R": 6, "C3D5": 5, "C3D4": 4, "C3D10": 10, "C3D10M": 10,
          **{kind: 2 * count for kind, count in STRAINED.items()}, **dict.fromkeys(RINGS, 8)}
MEMBRANES = {"M3D4": 4, "M3D4R": 4, "M3D3": 3}
PLANES = {"CPS4R": 4, "CPS3": 3}  # of plane stress
RIGID = {"R3D4": 4, "R3D3": 3}  # of rigid bodies, without a section
SHELLS = {"S4": 4, "S4R": 4, "S4RS": 4, "S4RSW": 4, "S3": 3, "S3R": 3, "S3RS": 3, **MEMBRANES, **PLANES, **RIGID}
COHESIVE = {"COH3D8": 8, "COH3D6": 6}
BEAMS = {"B31": 2, "PIPE31": 2, "T3D2": 2}
POINTS = {"MASS": 1, "ROTARYI": 1}
SPRINGS = {"SPRINGA": 2, "DASHPOTA": 2}
# Coupled elements: the temperatures of their nodes are left out with the conduction of heat.
WITH_TEMPERATURE = {f"{kind}T": kind for kind in (*SOLIDS, *SHELLS)}
NODES_OF_OTHERS = {"C3D20": 20, "C3D20R": 20, "C3D15": 15, "C3D27": 27}
# Faces S1, S2, ... by the number of corners.
SIDES = {
    8: ((0, 1, 2, 3), (4, 7, 6, 5), (0, 4, 5, 1), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 4, 0)),
    6: ((0, 1, 2), (3, 5, 4), (0, 3, 4, 1), (1, 4, 5, 2), (2, 5, 3, 0)),
    5: ((0, 1, 2, 3), (0, 4, 1), (1, 4, 2), (2, 4, 3), (3, 4, 0)),
    4: ((0, 1, 2), (0, 3, 1), (1, 3, 2), (2, 3, 0)),
}
SIDES[10] = SIDES[4]  # percuss takes the four triangles of a face by its corners
MOST_MEMBERS = 20_000_000
T = TypeVar("T")
Side = tuple[str, str]  # an element or a set of elements, the label of a face


@dataclass
class Orientation:
    """*ORIENTATION: three axes, and a rotation about one of them."""

    place: Place
    axes: tuple[Vector, Vector, Vector]
    about: int = 0  # 1 to 3; 0: its line is not given
    angle: float = 0.0
    reason: str = ""  # why it is not read


@dataclass
class SectionLayer:
    """A line of *SHELL SECTION, COMPOSITE; with an orientation in place of its angle."""

    thickness: float
    points: int
    material: str
    angle: float = 0.0
    orientation: str = ""


@dataclass
class Section:
    """*SOLID SECTION, *SHELL SECTION, *BEAM SECTION or *BEAM GENERAL SECTION."""

    kind: str
    elements: str
    material: str
    place: Place
    thickness: float = 0.0
    points: int = 5
    offset: float = 0.0
    is_nodal: bool = False  # shells have the thicknesses of their nodes
    distribution: str = ""  # of thicknesses of shells, by its name
    controls: str = ""  # *SECTION CONTROLS, by its name
    orientation: str = ""  # *ORIENTATION, by its name
    stack: str = ""  # STACK DIRECTION of SC8R
    layers: list[SectionLayer] = field(default_factory=list)
    area: float = 0.0  # of trusses
    shape: str = ""  # of beams, with dimensions and the direction n1
    sizes: list[float] = field(default_factory=list)
    toward: list[float] = field(default_factory=lambda: [0.0, 0.0, -1.0])
    cohesive: Block | None = None  # *COHESIVE SECTION
    general: Block | None = None  # *BEAM GENERAL SECTION, which has a material of its own
    added: list[Block] = field(default_factory=list)  # *BEAM ADDED INERTIA behind it

    @property
    def keyword(self) -> str:
        return f"{self.kind}{' GENERAL' if self.general else ''} SECTION"


@dataclass
class SpringSet:
    """*SPRING or *DASHPOT with the keys that it becomes."""

    keyword: str
    elements: str
    law: Deck
    place: Place


@dataclass
class Profile:
    """*SURFACE, TYPE=REVOLUTION, CYLINDER or SEGMENTS: words of its line with their numbers,
    in a plane of two directions.

    `first` and `axis` are the directions of the numbers of a point. A surface of revolution turns about `axis`, others
    go along the cross product of both.
    """

    place: Place
    kind: str = "REVOLUTION"
    pieces: list[tuple[str, list[float]]] = field(default_factory=list)
    origin: Vector = (0.0, 0.0, 0.0)
    first: Vector = (1.0, 0.0, 0.0)
    axis: Vector = (0.0, 1.0, 0.0)


@dataclass
class BodyCard:
    """A keyword that makes nodes rigid; names are empty where it has none."""

    keyword: str
    place: Place
    ref: str  # a node, or a set of one
    elements: str = ""
    nodes: list[str] = field(default_factory=list)
    surface: str = ""
    profile: str = ""  # an analytical surface
    equal: str = ""  # directions, where the nodes move equally instead
    # node or set, direction and factor, of an equation
    terms: list[tuple[str, int, float]] = field(default_factory=list)
    pinned: list[str] = field(default_factory=list)  # nodes whose rotations are free
    at_center: bool = False  # the reference node is moved to the centre
    held: str = ""  # directions that *KINEMATIC couples, where these are not all

    @property
    def is_constraint(self) -> bool:
        """Whether it is of displacements, and makes nothing rigid."""
        return bool(self.equal or self.terms)


@dataclass
class Scope:
    """What a part, the assembly, or a deck without parts defines. Names are in capitals."""

    nodes: dict[int, Vector] = field(default_factory=dict)
    elements: dict[int, tuple[str, tuple[int, ...]]] = field(default_factory=dict)
    node_sets: dict[str, list[int]] = field(default_factory=dict)
    element_sets: dict[str, list[int]] = field(default_factory=dict)
    surfaces: dict[str, list[Side]] = field(default_factory=dict)
    node_surfaces: dict[str, list[str]] = field(default_factory=dict)
    sections: list[Section] = field(default_factory=list)
    masses: list[tuple[str, float, Place]] = field(default_factory=list)
    springs: list[SpringSet] = field(default_factory=list)
    bodies: list[BodyCard] = field(default_factory=list)
    profiles: dict[str, Profile] = field(default_factory=dict)
    thicknesses: list[tuple[str, float, Place]] = field(default_factory=list)  # of a node or a set of nodes
    orientations: dict[str, Orientation] = field(default_factory=dict)
    distributions: dict[str, dict[int, float]] = field(default_factory=dict)  # values of elements; 0: of the others
    inertias: list[tuple[str, list[float], Place]] = field(default_factory=list)  # *ROTARY INERTIA
    transforms: list[tuple[str, Place]] = field(default_factory=list)  # sets of nodes with axes of their own
    place: Place | None = None
    origin: Vector = (0.0, 0.0, 0.0)  # of *SYSTEM
    axes: tuple[Vector, Vector, Vector] | None = None  # likewise; none: those of space
    sorted_ids: dict[str, list[int]] = field(default_factory=dict)
    node_lines: Lines = field(default_factory=Lines)  # of *NODE
    element_lines: Lines = field(default_factory=Lines)  # of *ELEMENT

    def sort(self, keyword: str) -> list[int]:
        """Ascending ids of what a set of *NSET or *ELSET may hold."""
        known = list(self.nodes) if keyword == "NSET" else list(self.elements)
        if len(self.sorted_ids.setdefault(keyword, [])) != len(known):
            self.sorted_ids[keyword] = sorted(known)
        return self.sorted_ids[keyword]


@dataclass
class Instance:
    """A part in its place."""

    name: str
    part: str
    place: Place
    move: Vector = (0.0, 0.0, 0.0)
    turn: tuple[Vector, Vector, float] | None = None  # two points of an axis, degrees
    shift: int = 0  # what is added to the ids
    largest: int = 0  # of its own ids
    own: Scope = field(default_factory=Scope)  # what stands between *INSTANCE and *END INSTANCE: a mesh of its own

    def put(self, x: Vector) -> Vector:
        """A point of the part in the assembly: moved, then turned."""
        p = (x[0] + self.move[0], x[1] + self.move[1], x[2] + self.move[2])
        return rotate(p, *self.turn) if self.turn else p


def rotate(p: Vector, a: Vector, b: Vector, degrees: float) -> Vector:
    """Rotates about the axis from a to b (Rodrigues)."""
    axis = [b[d] - a[d] for d in range(3)]
    length = math.sqrt(sum(c * c for c in axis)) or 1.0
    u = [c / length for c in axis]
    v = [p[d] - a[d] for d in range(3)]
    cosine, sine = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    along = sum(u[d] * v[d] for d in range(3)) * (1 - cosine)
    across = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
    return tuple(a[d] + v[d] * cosine + across[d] * sine + u[d] * along for d in range(3))  # type: ignore[return-value]


def keep_once(known: dict[int, T], lines: Lines, what: str, id: int, found: T, place: Place) -> None:
    """A node or an element; another one of its id that a line gives is an error.
    One that is made by rule may be given again."""
    if known.get(id, found) != found and (first := lines.find(id)):
        raise BadInput(place,
                       f"{what} {id} is defined twice, and differs (the first is at {first}): renumber or remove one")
    known[id] = found
    lines.note(place, id)


def read_elements(scope: Scope, block: Block, find: Callable[[str, Place], int] | None = None) -> None:
    """An element may go over several lines. find: of a node that another instance has."""
    kind = WITH_TEMPERATURE.get(block.option("TYPE"), block.option("TYPE"))

    def id_of(line: Line, index: int, is_node: bool) -> int:
        return find(line[1][index], block.at(line[0])) if find and is_node else block.id(line, index)

    counts = {**NODES_OF_OTHERS, **SOLIDS, **STRAINED, **RINGS, **SHELLS, **COHESIVE, **BEAMS, **SPRINGS}
    count: int = counts.get(kind, 0)
    lines = iter(block.lines)
    for line in lines:
        values = [id_of(line, i, i > 0) for i in range(len(line[1])) if line[1][i]]
        while values and len(values) - 1 < count:
            more = next(lines, None)
            if more is None:
                raise BadInput(block.at(line[0]),
                               f"element {values[0]} of *ELEMENT, TYPE={kind} has {len(values) - 1} nodes")
            values += [id_of(more, i, True) for i in range(len(more[1])) if more[1][i]]
        if not values:
            continue
        if kind in {**SOLIDS, **SHELLS, **COHESIVE} and len(values) - 1 > count:
            raise BadInput(block.at(line[0]), f"element {values[0]} of *ELEMENT, TYPE={kind} has {len(values) - 1} "
                                              f"nodes ({count} are expected): correct its lines")
        keep_once(scope.elements, scope.element_lines, "element", values[0], (kind, tuple(values[1:])),
                  block.at(line[0]))
        if "ELSET" in block.options:
            scope.element_sets.setdefault(block.option("ELSET"), []).append(values[0])


def read_set(scope: Scope, block: Block, sets: dict[str, list[int]],
             find: Callable[[str, Place], list[int]] | None = None) -> None:
    """*NSET and *ELSET: ids, names of sets, or GENERATE first, last, step.
    find: of what is not an id nor a set of the scope."""
    name = block.option("NSET" if block.keyword == "NSET" else "ELSET")
    if not name:
        raise BadInput(block.place, f"*{block.keyword} has no name: add it as an option")
    members = sets.setdefault(name, [])
    ids = scope.sort(block.keyword) if "GENERATE" in block.options else []
    if block.keyword == "NSET" and "ELSET" in block.options:
        members += list_corners(scope, block)
        return
    for line in block.lines:
        if "GENERATE" in block.options:
            first, last, step = block.integer(line, 0), block.integer(line, 1), abs(block.integer(line, 2, 1)) or 1
            found = ids[bisect_left(ids, first) : bisect_right(ids, last)]
            members += [id for id in found if (id - first) % step == 0]
            if len(members) > MOST_MEMBERS:
                raise BadInput(block.at(line[0]), f"set '{clip(name)}' has more than {MOST_MEMBERS} members")
            continue
        for text in filter(None, line[1]):
            id = parse_integer(text)
            word = text.strip('"').upper()
            if id is not None and not find:
                members.append(id)
            elif word in sets:
                members += sets[word]
            elif find:
                members += find(text, block.at(line[0]))
            else:
                raise BadInput(block.at(line[0]), missing(f"set '{clip(text)}'"))


def list_corners(scope: Scope, block: Block) -> list[int]:
    """Nodes of a set of elements."""
    elements = scope.element_sets.get(block.option("ELSET"))
    if elements is None:
        raise BadInput(block.place, missing(f"element set '{clip(block.option('ELSET'))}' in this part"))
    return list(dict.fromkeys(corner for id in elements if id in scope.elements for corner in scope.elements[id][1]))


def read_surface(scope: Scope, block: Block, ledger: Ledger) -> None:
    name = block.option("NAME")
    if block.option("TYPE") == "NODE":
        scope.node_surfaces[name] = [block.text(line, 0).strip('"').upper() for line in block.lines]
    elif block.option("TYPE") not in ("", "ELEMENT"):
        ledger.refuse("SURFACE.TYPE", block.place, f"a surface of type {clip(block.option('TYPE'))}", "it is left out")
    else:
        scope.surfaces[name] = [(block.text(line, 0).strip('"').upper(), block.text(line, 1).upper())
                                for line in block.lines]


def read_instance(block: Block) -> Instance:
    """Line 1 moves, line 2 turns about an axis."""
    found = Instance(block.option("NAME"), block.option("PART"), block.place)
    if block.lines:
        found.move = tuple(block.number(block.lines[0], i) for i in range(3))  # type: ignore[assignment]
    if len(block.lines) > 1:
        v = [block.number(block.lines[1], i) for i in range(7)]
        found.turn = ((v[0], v[1], v[2]), (v[3], v[4], v[5]), v[6])
    return found


def join(into: Scope, part: Scope, instance: Instance) -> None:
    """Adds an instance of a part, or the assembly (without name), to the mesh: ids raised, sets as INSTANCE.SET."""
    shift = instance.shift
    for id, x in part.nodes.items():
        into.nodes[id + shift] = instance.put(x)
    for id, (kind, corners) in part.elements.items():
        into.elements[id + shift] = (kind, tuple(corner + shift for corner in corners))
    for name, ids in part.node_sets.items():
        into.node_sets[qualify(name, instance)] = [id + shift for id in ids]
    for name, ids in part.element_sets.items():
        into.element_sets[qualify(name, instance)] = [id + shift for id in ids]
    for name, sides in part.surfaces.items():
        into.surfaces[qualify(name, instance)] = [(qualify(where, instance), label) for where, label in sides]
    for name, names in part.node_surfaces.items():
        into.node_surfaces[qualify(name, instance)] = [qualify(where, instance) for where in names]
    into.sections += [
        replace(section, elements=qualify(section.elements, instance),
                distribution=qualify(section.distribution, instance),
                orientation=name_orientation(section.orientation, part, instance),
                layers=[replace(layer, orientation=name_orientation(layer.orientation, part, instance))
                        for layer in section.layers])
        for section in part.sections
    ]  # fmt: skip
    into.orientations |= {qualify(name, instance): replace(found, axes=turn_axes(found.axes, instance))
                          for name, found in part.orientations.items()}
    into.springs += [replace(spring, elements=qualify(spring.elements, instance)) for spring in part.springs]
    for name, profile in part.profiles.items():
        into.profiles[qualify(name, instance)] = turn_profile(profile, instance)
    into.bodies += [
        replace(body, ref=qualify(body.ref, instance), elements=qualify(body.elements, instance),
                nodes=[qualify(name, instance) for name in body.nodes],
                pinned=[qualify(name, instance) for name in body.pinned], surface=qualify(body.surface, instance),
                profile=qualify(body.profile, instance))
        for body in part.bodies
    ]  # fmt: skip
    into.thicknesses += [(qualify(where, instance), thickness, place) for where, thickness, place in part.thicknesses]
    into.masses += [(qualify(name, instance), mass, place) for name, mass, place in part.masses]
    into.inertias += [(qualify(name, instance), values, place) for name, values, place in part.inertias]
    into.transforms += [(qualify(name, instance), place) for name, place in part.transforms]
    for name, values in part.distributions.items():
        into.distributions[qualify(name, instance)] = {id + shift if id else 0: value for id, value in values.items()}


def turn_profile(profile: Profile, instance: Instance) -> Profile:
    """A profile in the place of its instance."""
    ends = (tuple(o + a for o, a in zip(profile.origin, profile.axis)),
            tuple(o + a for o, a in zip(profile.origin, profile.first)))
    origin = instance.put(profile.origin)
    axis, first = (tuple(e - o for e, o in zip(instance.put(end), origin)) for end in ends)  # type: ignore[arg-type]
    return replace(profile, origin=origin, axis=axis, first=first)


def turn_axes(axes: tuple[Vector, Vector, Vector], instance: Instance) -> tuple[Vector, Vector, Vector]:
    """Directions of a part in its place."""
    start = instance.put((0.0, 0.0, 0.0))
    return tuple(tuple(p - q for p, q in zip(instance.put(axis), start)) for axis in axes)  # type: ignore[return-value]


def name_orientation(name: str, part: Scope, instance: Instance) -> str:
    """One of the part, or of the whole deck."""
    return qualify(name, instance) if name in part.orientations else name


def qualify(where: str, instance: Instance) -> str:
    """A name, or an id, as the whole mesh knows it."""
    return f"{instance.name}.{where}" if where and instance.name else where
