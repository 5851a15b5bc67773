"""A keyword deck in memory: what its cards define, by id, before it is applied."""

import math
from bisect import bisect_left, bisect_right
from collections import Counter
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field, replace
from typing import Any

from ..curves import Curve, Points, order_points
from ..fields import Row
from ..ledger import BadInput, Ledger, Place, missing
from ..model import Deck, Layer, Model, Vector
from ..shapes import FaceOwners, dot, subtract
from ..solids import FACES
from ..unique import Lines, Unique
from .cards import Card
from .dimensions import SAME, Factors, scale
from .output import Output

MOST_SETS = 200  # that one set may be made of


@dataclass
class SetCard:
    """A set as its cards give it. GENERATE ranges and sets of sets wait until all members are known."""

    kind: str  # NODE, PART, SEGMENT, SHELL, SOLID
    id: int
    title: str
    place: Place
    ids: list[int] = field(default_factory=list)
    ranges: list[tuple[int, int]] = field(default_factory=list)
    sets: list[int] = field(default_factory=list)
    segments: list[tuple[int, ...]] = field(default_factory=list)
    options: list[tuple[str, list[int]]] = field(default_factory=list)  # of _GENERAL


@dataclass
class PartCard:
    """*PART with its section, material and further cards by id."""

    id: int
    title: str
    place: Place
    section: int
    material: int
    state: int
    hourglass: int
    friction: float | None = None
    contact_thickness: float = 0.0  # OPTT
    is_adaptive: bool = False  # ADPOPT
    inertia: Deck | None = None  # of *PART_INERTIA: mass, center, inertia
    motion: Deck = field(default_factory=dict)  # likewise: velocity, angular_velocity
    layup: "Layup | None" = None  # of *PART_COMPOSITE


@dataclass
class Layup:
    """What *PART_COMPOSITE says in place of a section: its first row, and the plies from the bottom."""

    row: Row
    thickness: float
    layers: list[Layer]


@dataclass
class Element:
    """An element that is not a plain hexahedron, or a shell."""

    id: int
    corners: tuple[int, ...]
    thickness: float | None = None
    angle: float = 0.0  # of axes of the material; 0: none
    system: int = 0  # of axes; 0: none


@dataclass
class BeamElement:
    """A beam with the node that says how its section is turned; 0: none. A vector stands in for the node."""

    id: int
    ends: tuple[int, ...]
    third: int
    toward: Vector | None = None


@dataclass
class SpringElement:
    """A spring or damper between two nodes; 0 is the ground."""

    id: int
    part: int
    nodes: tuple[int, int]
    scale: float
    place: Place


@dataclass
class NodalBody:
    """*CONSTRAINED_NODAL_RIGID_BODY: a set of nodes that is a body."""

    id: int
    nodes: int  # *SET_NODE
    title: str
    held: list[str]
    place: Place
    card: str
    center_node: int = 0  # PNODE, which LS-DYNA moves to the mass centre
    inertia: Deck | None = None  # of _INERTIA: mass, center, inertia
    motion: Deck = field(default_factory=dict)  # likewise: velocity, angular_velocity
    name: str = ""  # in the deck of percuss; empty: left out


@dataclass
class PartGravity:
    """*LOAD_GRAVITY_PART: the acceleration of some parts along an axis."""

    card: Card
    place: Place
    parts: set[int]
    axis: str
    curve: int
    acceleration: float


@dataclass
class ExtraNodes:
    """*CONSTRAINED_EXTRA_NODES: a node or a set that joins a rigid part."""

    kind: str  # NODE or SET
    id: int
    adds_mass: bool  # IFLAG: to that of *PART_INERTIA
    place: Place


@dataclass
class JointCard:
    """A joint by pairs of coincident nodes."""

    card: str
    id: int
    title: str
    nodes: list[int]
    place: Place
    lead: float = 0.0  # of a screw: way of a turn


@dataclass
class TurnSpringCard:
    """*CONSTRAINED_JOINT_STIFFNESS_GENERALIZED: its bodies and axes, and the lines of its laws."""

    title: str
    row: Row
    curves: Row
    holds: Row
    stops: Row


@dataclass
class Elements:
    """Elements of one part."""

    place: Place
    solids: list[tuple[int, tuple[int, ...]]] = field(default_factory=list)
    shells: list[Element] = field(default_factory=list)
    beams: list[BeamElement] = field(default_factory=list)
    others: set[str] = field(default_factory=set)
    is_thick: bool = False  # has solids of *ELEMENT_TSHELL


SPACE: tuple[Vector, Vector, Vector] = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))


@dataclass
class Box:
    """*DEFINE_BOX: limits along axes from an origin."""

    limits: list[float]  # low, high of each axis
    axes: tuple[Vector, Vector, Vector]
    origin: Vector

    def holds(self, x: Vector) -> bool:
        way = subtract(x, self.origin)
        return all(self.limits[2 * d] <= dot(way, self.axes[d]) <= self.limits[2 * d + 1] for d in range(3))


def pick(ids: list[int], ranges: list[tuple[int, int]]) -> list[int]:
    """The ascending ids that lie in any of the ranges, each once."""
    picked: list[int] = []
    reached = 0
    for first, last in sorted(ranges):
        start, end = max(bisect_left(ids, first), reached), bisect_right(ids, last)
        picked += ids[start:end]
        reached = max(reached, end)
    return picked


@dataclass
class RigidPart:
    """What holds a rigid part: x, y, z, rx, ry, rz."""

    held: list[str] = field(default_factory=list)


class KeywordDeck:
    """All definitions, and the model that they become."""

    def __init__(self, ledger: Ledger):
        self.ledger, self.model = ledger, Model()
        self.nodes: dict[int, Vector] = self.model.nodes
        self.ids, self.node_lines = Unique(), Lines()
        self.element_lines = {"solids": Lines(), "thick shells": Lines(), "shells": Lines(), "beams": Lines()}
        self.fixed_nodes: dict[tuple[int, int], list[int]] = {}
        self.fixed_place: Place | None = None
        self.elements: dict[int, Elements] = {}
        self.parts: dict[int, PartCard] = {}
        self.sets: dict[tuple[str, int], SetCard] = {}
        self.curves: dict[int, Curve] = {}
        self.converted_curves: dict[tuple[int, str, str], Curve] = {}  # of files in other units, by what their rows are
        self.sections: dict[int, Card] = {}
        self.materials: dict[int, Card] = {}
        self.material_titles: dict[int, str] = {}
        # degrees from the axes of a law to those of its material, by material and block
        self.turns: dict[tuple[int, int], float] = {}
        self.names_of_laws: dict[int, list[str]] = {}  # in the deck of percuss: one for each way in which parts use it
        self.logarithmic_materials: set[int] = set()  # with the option _LOG_INTERPOLATION
        self.states: dict[int, Card] = {}
        self.hourglass: dict[int, Row] = {}
        self.transformations: dict[int, Any] = {}  # *DEFINE_TRANSFORMATION
        self.node_transforms: list[Row] = []
        self.boxes: dict[int, Box] = {}
        self.systems: dict[int, tuple[Vector, Vector, Vector]] = {}
        # at the start, of those that move with nodes
        self.moving_systems: dict[int, tuple[Vector, Vector, Vector]] = {}
        self.vectors: dict[int, Vector] = {}
        self.erosions: dict[int, Card] = {}
        self.gissmos: dict[int, Card] = {}
        self.diems: dict[int, Card] = {}
        self.additions: list[Card] = []  # other cards that add to a material
        self.tables: dict[int, list[tuple[float, int]]] = {}  # values, such as rates, with their curves
        self.units_of_tables: dict[int, Factors] = {}
        self.unknown: list[tuple[str, Place]] = []  # cards that may be misspelt
        self.usual_friction = 0.0  # SFRIC of *CONTROL_CONTACT
        self.most_added_mass = 0.0  # ENDMAS: as a share; 0: no limit
        self.shell_form = 2  # THEORY: where a section says nothing
        self.keeps_eroded_nodes = False  # ENMASS
        self.contact_control: Place | None = None  # *CONTROL_CONTACT; None: the deck has none
        self.contact_at_offset = False  # CNTCO: contact of shells whose mesh is not their middle
        # of *ELEMENT_SOLID_ORTHO: a, and d in the plane of a and b
        self.solid_axes: dict[int, tuple[Vector, Vector]] = {}
        self.erodes_folded_shells = False  # NFAIL1, NFAIL4
        self.folded_shells = 0  # PSNFAIL: a set of the parts for which they count; 0: all
        self.eroded_when_inverted = 0  # PSFAIL: a set of parts
        self.detonations: list[tuple[int, Vector, Place]] = []  # part or 0 for all, point
        self.masses: list[tuple[int, float, Place]] = []  # node, mass
        self.rules: dict[int, tuple[Row, Row | None]] = {}  # *INTEGRATION_BEAM: its first two lines
        self.skins: dict[int, list[Any]] = {}  # materials.skins.Skin, by the part whose shells they are
        self.masses_of_sets: list[Row] = []  # of sets of nodes, of parts
        self.springs: list[SpringElement] = []
        self.part_of_spring: set[int] = set()
        self.welds: list[Card] = []
        self.equal_sets: list[Card] = []
        self.bolts: list[Row] = []  # of *INITIAL_AXIAL_FORCE_BEAM
        self.bolt_of_beam: dict[int, int] = {}  # place in `bolts` of beams that have a preload
        self.bolt_of_block: dict[int, int] = {}
        self.planes: dict[int, Any] = {}  # of *DATABASE_CROSS_SECTION_PLANE; of those without an id minus their number
        self.rigid_ends: set[int] = set()  # nodes that no weld can have
        self.shell_shift = 0  # what is added to the ids of shells
        self.beam_shift = 0  # likewise
        self.end_time = 0.0
        self.general_hourglass: Row | None = None
        self.waiting_table: list[tuple[int, float]] = []  # table and value of curves that are still to come
        self.output = Output()
        self.sensors: list[Card] = []
        self.friction_by_part = False  # whether a contact takes FS of its parts
        self.contacts: list[Deck] = []  # a, b, friction, title
        self.forces: list[Deck] = []  # entries of output.history.forces
        self.sections_by_sets: list[Deck] = []  # likewise, of which there may be any number
        self.single_nodes: dict[int, str] = {}  # sets of one node
        self._used_nodes: set[int] | None = None
        self._shell_nodes: set[int] | None = None
        self._turning_nodes: set[int] | None = None
        self.names_of_parts: dict[int, list[str]] = {}  # in the deck: one name a thickness
        self.rigid: dict[int, RigidPart] = {}  # parts that are rigid
        self.merged: dict[int, tuple[int, Place]] = {}  # rigid parts that belong to the body of another
        self.updated_bodies: dict[int, Place] = {}  # IFLAG of *CONSTRAINED_RIGID_BODIES, by the part that leads
        self.rigid_motions: dict[int, list[Row]] = {}  # *BOUNDARY_PRESCRIBED_MOTION_RIGID by part
        self.extra_nodes: dict[int, list[ExtraNodes]] = {}  # of rigid parts
        self.bodies_of_nodes: dict[int, str] = {}  # names of bodies in the deck of percuss, once they are known
        self.part_gravity: list[PartGravity] = []
        # *DEFORMABLE_TO_RIGID: part or set, whether a set, part that leads
        self.switched: list[tuple[int, bool, int, Place]] = []
        # nodes that are mass centres, with what gets their places
        self.center_rows: list[tuple[int, Row, list[float]]] = []
        self.center_nodes: set[int] = set()  # PNODE of nodal rigid bodies
        self.body_holds: dict[str, list[Any]] = {}  # body_holds.Hold, by the name of the body
        self.held_of_body: dict[str, list[str]] = {}  # directions that `fixed` of a body has
        self.body_centers: dict[str, list[float]] = {}  # of cards with the inertia of a body
        self.body_places: dict[str, Place] = {}
        self.started_bodies: dict[str, Deck] = {}  # entries of `initial` of cards with the inertia of a body
        self.start_members: dict[str, set[int]] = {}  # nodes of the names in `initial`
        self.nodal_bodies: dict[int, NodalBody] = {}
        self.joints: list[JointCard] = []
        self.turn_springs: list[TurnSpringCard] = []
        self.merged_sets: list[Row] = []
        self.merge_tolerance = 0.0  # 0: none is given
        self.blasts: dict[int, Deck] = {}  # entries `blast` of loads.pressure, by id
        self.body_names: dict[int, str] = {}  # in the deck of percuss, by the part that leads the body
        self.used: set[tuple[str, int]] = set()
        self._names_of_sets: dict[tuple[str, int, bool], str] = {}
        self._sorted: dict[str, list[int]] = {}  # ids by kind

    # --- references

    def curve(self, id: int, place: Place, across: str, up: str) -> Curve:
        """A curve, whose abscissae and ordinates have these dimensions."""
        if id not in self.curves:
            raise BadInput(place, missing(f"curve {id}"))
        self.used.add(("curve", id))
        found, span = self.curves[id], self.end_time if across == "time" else math.inf
        if found.units == SAME:
            if found.rows and span < math.inf:
                found.points = order_points(found.rows, span)
            return found
        key = (id, across, up)
        if key not in self.converted_curves:
            x, y = scale(across, found.units), scale(up, found.units)
            self.converted_curves[key] = replace(
                found, points=order_points([(a * x, b * y) for a, b in found.rows], span), units=SAME)
        return self.converted_curves[key]

    def material_curve(self, id: int, place: Place, across: str, up: str) -> Points:
        curve = self.curve(id, place, across, up)
        if not curve.points:
            raise BadInput(place, f"curve {id} is a function of time (a table is needed here): give it rows")
        return curve.points

    def find_set(self, kind: str, id: int, place: Place) -> SetCard:
        if (kind, id) not in self.sets:
            raise BadInput(place, missing(f"*SET_{kind} {id}"))
        return self.sets[kind, id]

    def find_part(self, id: int, place: Place) -> PartCard:
        if id not in self.parts:
            raise BadInput(place, missing(f"part {id}"))
        return self.parts[id]

    # --- members of sets

    def list_members(self, kind: str, id: int, place: Place, seen: set[int] | None = None) -> list[int]:
        """Ids of nodes, parts or elements of a set, those of its sets included."""
        seen = seen if seen is not None else set()
        seen.add(id)
        if len(seen) > MOST_SETS:
            raise BadInput(place, f"*SET_{kind} {id} is the last of more than {MOST_SETS} sets of sets")
        found = self.find_set(kind, id, place)
        shift = {"SHELL": self.shell_shift, "BEAM": self.beam_shift}.get(kind, 0)
        ids = [i + shift for i in found.ids]
        if found.ranges:
            ids += pick(self._sort_known(kind), [(first + shift, last + shift) for first, last in found.ranges])
        for inner in found.sets:
            if inner not in seen:
                ids += self.list_members(kind, inner, found.place, seen)
        for option, values in found.options:
            ids = self._apply_option(kind, ids, option, values, found.place)
        return list(dict.fromkeys(ids))

    def _sort_known(self, kind: str) -> list[int]:
        """All ids of a kind."""
        if kind not in self._sorted:
            known = (list(self.nodes) if kind == "NODE" else list(self.parts) if kind == "PART"
                     else self.list_elements(kind))
            self._sorted[kind] = sorted(known)
        return self._sorted[kind]

    def forget_sorted(self) -> None:
        """After nodes have gone."""
        self._sorted.clear()

    def list_elements(self, kind: str) -> list[int]:
        if kind == "SHELL":
            return [element.id for part in self.elements.values() for element in part.shells]
        if kind == "BEAM":
            return [beam.id for part in self.elements.values() for beam in part.beams]
        return [id for part in self.elements.values() for id, _ in part.solids]

    def _apply_option(self, kind: str, ids: list[int], option: str, values: list[int], place: Place) -> list[int]:
        """Members of a kind by one line of a _GENERAL set; set_cards.py lets no other option through."""
        removes = option.startswith("D")
        option = option.removeprefix("D")
        shift = {"SHELL": self.shell_shift, "BEAM": self.beam_shift}.get(kind, 0)
        if option == "ALL":
            more = self._sort_known(kind)
        elif option == "PART" and kind == "NODE":
            more = [node for part in values for node in self.nodes_of_part(part)]
        elif option == "PART" and kind != "PART":
            more = [id for part in values for id, _ in self.elements_of_part(kind, part)]
        elif option == "BOX":
            inside = {node for box in values for node in self.nodes_of_box(box, place)}
            more = list(inside) if kind == "NODE" else self._list_inside(kind, inside)
        else:
            more = [id + shift for id in values]
        gone = set(more) if removes else set()
        return [i for i in ids if i not in gone] if removes else ids + more

    def _list_inside(self, kind: str, inside: set[int]) -> list[int]:
        """Elements, or parts, of which all nodes are among these."""
        if kind == "PART":
            return [part for part in self.parts if (nodes := self.nodes_of_part(part)) and inside.issuperset(nodes)]
        return [id for part in self.elements
                for id, corners in self.elements_of_part(kind, part) if inside.issuperset(corners)]

    def nodes_of_part(self, id: int) -> list[int]:
        found = self.elements.get(id)
        if not found:
            return []
        corners = [c for _, nodes in found.solids for c in nodes] + [c for e in found.shells for c in e.corners]
        corners += [c for beam in found.beams for c in beam.ends]
        return list(dict.fromkeys(corners))

    def find_box(self, id: int, place: Place) -> Box:
        if id not in self.boxes:
            raise BadInput(place, missing(f"*DEFINE_BOX {id}"))
        return self.boxes[id]

    def nodes_of_box(self, id: int, place: Place) -> list[int]:
        box = self.find_box(id, place)
        return [node for node, x in self.nodes.items() if box.holds(x)]

    def elements_of_part(self, kind: str, part: int) -> list[tuple[int, tuple[int, ...]]]:
        """Ids and corners of the elements of a kind."""
        found = self.elements.get(part)
        if not found:
            return []
        if kind == "SOLID":
            return list(found.solids)
        return ([(shell.id, shell.corners) for shell in found.shells] if kind == "SHELL"
                else [(beam.id, beam.ends) for beam in found.beams])

    def faces_of_part(self, part: int) -> list[tuple[int, ...]]:
        """Shells, and those faces of solids that no other solid of the part has, outward."""
        faces = [tuple(corners[i] for i in face) for _, corners in self.elements_of_part("SOLID", part)
                 for face in FACES[4 if len(corners) == 10 else len(corners)]]
        counts = Counter(frozenset(face) for face in faces)
        return ([corners for _, corners in self.elements_of_part("SHELL", part)]
                + [face for face in faces if counts[frozenset(face)] == 1])

    # --- names in the deck of percuss

    def part_names(self, ids: Iterable[int]) -> list[str]:
        """Names of all blocks of these parts that are in the model."""
        return [name for id in ids for name in self.names_of_parts.get(id, [])]

    def blocks_of(self, parts: Iterable[int]) -> list[int]:
        wanted = set(parts)
        return [block.id for block in self.model.blocks if block.part in wanted]

    def without_skins(self, parts: Iterable[int]) -> list[int]:
        """Parts that touch: the solids in place of the skins on them."""
        found: dict[int, None] = {}
        for part in parts:
            found.update(dict.fromkeys(solid for skin in self.skins[part] for solid in skin.solids)
                         if part in self.skins else {part: None})
        return list(found)

    def held_as_bodies(self) -> bool:
        """Whether rigid bodies have nodes of elements that deform: beside them percuss adds mass at the start alone."""
        if self.nodal_bodies or self.extra_nodes:
            return True
        soft = [block.id for block in self.model.blocks if block.part not in self.rigid]
        return not self.rigid_nodes().isdisjoint(self.model.nodes_of_blocks(soft))

    def rigid_nodes(self) -> set[int]:
        """Nodes of rigid parts."""
        return self.model.nodes_of_blocks(self.blocks_of(self.rigid)) if self.rigid else set()

    def node_set_name(self, id: int, place: Place) -> str | None:
        """Name of a set of nodes in the deck. None if no node of it has an element."""
        key = ("NODE", id, False)
        if key not in self._names_of_sets:
            card = self.find_set("NODE", id, place)
            self._names_of_sets[key] = self.make_node_set(card.title or f"nodes_{id}",
                                                          self.list_members("NODE", id, place), place)
        self.used.add(("NODE", id))
        return self._names_of_sets[key] or None

    def make_node_set(self, wish: str, nodes: Iterable[int], place: Place) -> str:
        """A set of those of the nodes that have an element; an empty name if there is none."""
        nodes = list(nodes)
        for node in nodes:
            if node not in self.nodes:
                raise BadInput(place, missing(f"node {node}"))
        used = self.used_nodes()
        kept = [node for node in nodes if node in used]
        return self.model.add_node_set(wish, kept) if kept else ""

    def used_nodes(self) -> set[int]:
        if self._used_nodes is None:
            self._used_nodes = self.model.used_nodes()
        return self._used_nodes

    def shell_nodes(self) -> set[int]:
        if self._shell_nodes is None:
            self._shell_nodes = self.model.shell_nodes()
        return self._shell_nodes

    def turning_nodes(self) -> set[int]:
        if self._turning_nodes is None:
            self._turning_nodes = self.model.turning_nodes()
        return self._turning_nodes

    def segment_set_name(self, id: int, place: Place) -> str | None:
        """A surface of contact: of shells both faces. None if no face is of an element."""
        key = ("SEGMENT", id, True)
        if key not in self._names_of_sets:
            card = self.find_set("SEGMENT", id, place)
            owners = FaceOwners(self.model, {node for face in card.segments for node in face})
            signs = [(face, owners.find_sign(face)) for face in card.segments]
            faces = [face for face, sign in signs if sign is not None]
            if len(faces) < len(signs):
                self.ledger.refuse("SET_SEGMENT.free", card.place,
                                   "segments that are not a face of any element", "they are left out")
            faces += [face[::-1] for face in faces if all(node in self.shell_nodes() for node in face)]
            name = self.model.names.take(card.title or f"sides_{id}") if faces else ""
            if name:
                self.model.side_sets[name] = faces
            self._names_of_sets[key] = name
        self.used.add(("SEGMENT", id))
        return self._names_of_sets[key] or None

    def part_set_name(self, id: int, place: Place) -> str | None:
        """Name of a set of parts; the name of the part where it is one block. None if it is empty."""
        key = ("PART", id, False)
        if key not in self._names_of_sets:
            card = self.find_set("PART", id, place)
            self._names_of_sets[key] = self.name_blocks(self.list_members("PART", id, place),
                                                        card.title or f"parts_{id}")
        self.used.add(("PART", id))
        return self._names_of_sets[key] or None

    def name_blocks(self, parts: Iterable[int], wish: str) -> str:
        """One name for the blocks of these parts; empty if there is none."""
        blocks = self.blocks_of(parts)
        if len(blocks) == 1:
            return next(block.name for block in self.model.blocks if block.id == blocks[0])
        if not blocks:
            return ""
        for name, members in self.model.block_sets.items():
            if members == blocks:
                return name
        name = self.model.names.take(wish)
        self.model.block_sets[name] = blocks
        return name

    def element_set_name(self, kind: str, id: int, place: Place) -> str | None:
        key = (kind, id, False)
        if key not in self._names_of_sets:
            card = self.find_set(kind, id, place)
            members = set(self.list_members(kind, id, place))
            written = {e for b in self.model.blocks for e, _ in (b.shells if kind == "SHELL" else b.solids)}
            name = self.model.names.take(card.title or f"elements_{id}") if members & written else ""
            if name:
                self.model.element_sets[name] = (kind, sorted(members & written))
            self._names_of_sets[key] = name
        self.used.add((kind, id))
        return self._names_of_sets[key] or None


Handler = Callable[[KeywordDeck, Card], None]
