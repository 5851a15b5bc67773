"""An Abaqus deck in memory: its mesh, and what its keywords define by name."""

from collections import Counter
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, field
from typing import Any, TypeVar

from ..cohesive_layers import Layer
from ..curves import Points
from ..fields import clip, parse_integer
from ..ledger import BadInput, Ledger, Place, missing
from ..model import Deck, Model, Vector
from ..unique import Unique
from .amplitudes import Amplitude
from .lines import Block
from .mesh import PLANES, RINGS, SHELLS, SIDES, SOLIDS, STRAINED, BodyCard, Instance, Scope
from .timeline import StepTime, Target, Timeline, shift_points

AXES = ("x", "y", "z", "rx", "ry", "rz")
T = TypeVar("T")
FLAT = {**STRAINED, **RINGS}  # elements in a plane, with their corners there


@dataclass
class MaterialBlocks:
    """*MATERIAL with the keywords that follow it."""

    place: Place
    parts: list[Block] = field(default_factory=list)


@dataclass
class RigidGroup:
    """Nodes that move as one."""

    place: Place
    nodes: set[int]  # that have elements
    refs: set[int]  # reference nodes, with elements or without
    name: str = ""  # of the body
    keys: Deck = field(default_factory=dict)  # of the part or the set, where `fixed` belongs
    # by direction: reference node, motion or rest
    held: dict[str, tuple[int, Deck | None]] = field(default_factory=dict)
    spells: dict[str, Deck] = field(default_factory=dict)  # by direction: a motion or rest from one step to another
    at_center: bool = False  # the reference node is the centre
    moves_ref: bool = False  # POSITION=CENTER OF MASS: it goes there from its place
    rigid_keys: Deck = field(default_factory=dict)  # mass, centre and inertia at the reference node
    joint: str = ""  # to the ground, which holds the reference node
    wall: Deck | None = None  # of an analytical surface, by its name
    card: BodyCard | None = None  # of such a surface
    profile: str = ""


@dataclass
class Rotation:
    """A velocity and a spin of nodes at the start."""

    nodes: set[int]
    velocity: Vector
    spin: Vector
    center: Vector


@dataclass
class General:
    """General contact of everything from one time to another; end: None is the end of the run."""

    start: float
    end: float | None
    friction: float
    place: Place


@dataclass
class Following:
    """The directions in which nodes have the motion of their leader."""

    card: BodyCard
    leader: int
    nodes: list[int]
    ways: list[str]
    has_arms: bool = False  # its turns would move them too


@dataclass
class ParameterTables:
    """*PARAMETER TABLE of the whole deck."""

    kinds: dict[str, list[str]] = field(default_factory=dict)  # of columns, by *PARAMETER TABLE TYPE
    lines: list[str] = field(default_factory=list)  # of the file
    places: list[Place] = field(default_factory=list)  # of the collections
    is_open: bool = False  # whether the keyword before belongs to a collection


class AbaqusDeck:
    """All definitions, and the model that they become."""

    def __init__(self, ledger: Ledger):
        self.ledger, self.model, self.names = ledger, Model(), Unique()
        self.mesh = Scope()
        self.parts: dict[str, Scope] = {}
        self.assembly = Scope()
        self.assembly_name = ""
        self.left_elements: set[int] = set()  # whose kind, section or material is refused
        self.layers: list[Layer] = []  # of cohesive elements
        self.has_lost_section = False  # a keyword of a section is refused
        self.rigid_material = ""  # of elements without a section
        self.controls: dict[str, Block] = {}  # *SECTION CONTROLS
        self.parameter_tables = ParameterTables()
        self.instances: list[Instance] = []
        self.whole_assembly: Instance | None = None  # as an instance without name
        # ids of its elements, which are read when the instances are in their places
        self.assembly_elements: list[int] = []
        self.materials: dict[str, MaterialBlocks] = {}
        # in the deck of percuss: one for each way in which sections use a material
        self.names_of_laws: dict[str, list[str]] = {}
        self.amplitudes: dict[str, Amplitude] = {}
        self.steps: list[StepTime] = []
        self.motions, self.loads = Timeline(0.0), Timeline(0.0)
        self.scaled: set[tuple[object, ...]] = set()  # keywords of mass scaling with their options
        self.keywords_of_lines: dict[Place, str] = {}  # of what acts in a step
        self.renewed: set[tuple[str, int]] = set()  # keyword and step of OP=NEW
        self.gravities: dict[str, tuple[int, list[float]]] = {}  # by the element set: step and direction
        self.condition_lines: list[Any] = []
        self.load_writers: dict[Target, Callable[[float | Deck], None]] = {}
        self.transformed: set[int] = set()  # nodes of *TRANSFORM
        self.frictions: dict[str, float] = {}  # of *SURFACE INTERACTION
        self.interactions: dict[str, list[Block]] = {}  # *SURFACE INTERACTION with its friction and bonds
        self.used_interactions: set[str] = set()  # that contact names
        self.used_materials: set[str] = set()  # that sections name
        self.glues: dict[str, list[Block]] = {}  # likewise, of bonds
        self.velocities: dict[int, list[float]] = {}  # of nodes at the start
        self.rotations: list[Rotation] = []  # likewise
        self.body_velocities: dict[int, list[float]] = {}  # of reference nodes: of translation, and of rotation
        self.temperatures: dict[int, float] = {}  # likewise
        self.temperature_place: Place | None = None  # the last card of them
        self.pairs: list[Deck] = []
        self.wall_pairs: list[tuple[str, str, float | None]] = []  # analytical surface, what it stops, friction
        self.generals: list[General] = []  # everything touches everything, one after the other
        self.whole_friction = 0.0  # of general contact, at the last step that is read
        self.excluded: list[frozenset[str]] = []  # pairs of parts
        self.contact_ignores_offsets = False  # OFFSET FRACTION 0: general contact of all shells is about their mesh
        # surfaces of pairs, as this deck and as percuss call them
        self.contact_names: dict[tuple[str, str], tuple[str, str]] = {}
        self.step_scale = 0.0  # 0: percuss' own
        self.states: dict[int, tuple[float, ...]] = {}  # of user code at the start, by element
        self.states_place: Place | None = None
        self.field_count = 1  # of a VUSDFLD
        self.twins: dict[int, int] = {}  # of nodes of plane strain and of rotational symmetry: those of the other plane
        self.followings: list[Following] = []  # nodes with the motion of a node without elements
        self.leaders: set[int] = set()  # nodes without elements whose displacements are in equations
        self.driven_equations: list[tuple[BodyCard, list[list[int]]]] = []  # these, with the nodes of each term
        self.is_ring = False  # its elements are of rotational symmetry
        self.on_axis: set[int] = set()  # nodes on the axis of symmetry, and their twins
        self.turned: set[int] = set()  # twins of rotational symmetry, whose radius is along z
        self.heats = False  # plastic work changes temperatures
        self.conducting_place: Place | None = None  # of a step that conducts heat
        self.integrations: dict[int, Counter[str]] = {}  # of the hexahedra of a block, by its index
        self.pair_frictions: list[Deck] = []  # rows of contact.friction.pairs
        self.blocks_of_elements: dict[int, int] = {}  # element: index of its block
        self.groups: list[RigidGroup] = []
        self.group_of_ref: dict[int, RigidGroup] = {}
        self._names: dict[tuple[object, ...], str] = {}
        self._used: set[int] | None = None

    @property
    def is_whole(self) -> bool:
        """Whether everything touches everything at some time."""
        return bool(self.generals)

    @property
    def end_time(self) -> float:
        return self.steps[-1].end if self.steps else 0.0

    # --- references

    def scope_of(self, instance: Instance) -> Scope:
        """What an instance, or the assembly, has under its own ids."""
        if instance is self.whole_assembly:
            return self.assembly
        part, own = self.parts[instance.part], instance.own
        if not own.nodes and not own.elements:
            return part
        sets = {**part.element_sets, **own.element_sets}
        return Scope(nodes={**part.nodes, **own.nodes}, elements={**part.elements, **own.elements}, element_sets=sets)

    def tidy(self, name: str) -> str:
        """A name in capitals; blanks around points and the name of the assembly in front do not count."""
        words = [word.strip() for word in name.strip().strip('"').upper().split(".")]
        return ".".join(words[1:] if len(words) > 1 and words[0] == self.assembly_name else words)

    def resolve(self, table: dict[str, T], name: str, place: Place, what: str) -> T:
        """What a name means: NAME, or INSTANCE.NAME where one instance alone has it."""
        name = self.tidy(name)
        if name in table:
            return table[name]
        fits = [key for key in table if key.endswith("." + name)]
        if len(fits) == 1:
            return table[fits[0]]
        if not fits:
            raise BadInput(place, missing(f"{what} '{clip(name)}'"))
        raise BadInput(place, f"'{clip(name)}' may be one of {len(fits)} {what}s (several instances have it): "
                              "write INSTANCE.NAME")

    def list_ids(self, table: dict[str, list[int]], known: Collection[int], name: str, place: Place,
                 what: str) -> list[int]:
        """Ids of a set, or one id: of the assembly, or as INSTANCE.ID."""
        instance, _, label = self.tidy(name).rpartition(".")
        id = parse_integer(label)
        if id is None:
            return self.resolve(table, name, place, what)
        if not self.instances and not instance:
            fits, id = [0], id if id in known else 0
        else:
            fits = [i.shift for i in (*self.instances, self.whole_assembly)
                    if i and i.name == instance.upper() and id <= i.largest]
        if not fits or id + fits[0] not in known:
            raise BadInput(place, missing(f"{what} or id {clip(name)}"))
        return [id + fits[0]]

    def nodes_of(self, name: str, place: Place) -> list[int]:
        nodes = self.list_ids(self.mesh.node_sets, self.mesh.nodes, name, place, "node set")
        return nodes + [self.twins[node] for node in nodes if node in self.twins] if self.twins else nodes

    def list_flat(self, kinds: Mapping[str, int]) -> dict[int, tuple[str, tuple[int, ...]]]:
        """Elements of these kinds, of which solids are made."""
        found = {id: element for id, element in self.mesh.elements.items() if element[0] in kinds}
        for id, (_, corners) in found.items():
            for corner in corners:
                if corner not in self.mesh.nodes:
                    raise BadInput(self.mesh.place or Place("", 0), missing(f"node {corner}, of element {id}"))
        return found

    def elements_of(self, name: str, place: Place) -> list[int]:
        return self.list_ids(self.mesh.element_sets, self.mesh.elements, name, place, "element set")

    # --- steps and values over time

    def step_of(self, block: Block) -> StepTime:
        """The step of a keyword; what stands before all steps acts from the first one on."""
        if max(block.step, 1) > len(self.steps):
            raise BadInput(block.place, f"*{block.keyword} acts in a step without a procedure: add *DYNAMIC, "
                                        "EXPLICIT behind its *STEP")
        return self.steps[max(block.step, 1) - 1]

    def amplitude(self, name: str, place: Place) -> Amplitude | None:
        if not name:
            return None
        if name not in self.amplitudes:
            raise BadInput(place, missing(f"amplitude '{clip(name)}'"))
        return self.amplitudes[name]

    def values_in_step(self, block: Block, place: Place, value: float) -> Points | None:
        """A value over the time of the run, from the step of its keyword on; None where its amplitude is refused."""
        step = self.step_of(block)
        curve = self.amplitude(block.option("AMPLITUDE"), place)
        if curve is None:
            return [(step.start, value), (self.end_time * 1.01, value)]
        if curve.reason:
            self.ledger.refuse("AMPLITUDE", curve.place, f"an amplitude {curve.reason}", "what it acts on is left out")
            return None
        if curve.error:
            self.ledger.approximated("AMPLITUDE", curve.place, curve.error)
        points = shift_points(curve.points, step, curve.is_total, self.end_time)
        return [(x, y if curve.is_absolute else y * value) for x, y in points]

    def sensor_at(self, time: float) -> str:
        """A sensor that acts at the end of a step."""
        sensors: dict[str, Deck] = self.model.deck.setdefault("sensors", {})
        for name, keys in sensors.items():
            if keys == {"time": time}:
                return name
        name = self.model.names.take(f"step_{len(sensors) + 2}")
        sensors[name] = {"time": time}
        return name

    def friction(self, name: str, place: Place) -> float:
        """Coefficient of friction of a *SURFACE INTERACTION."""
        if name.upper() not in self.frictions:
            raise BadInput(place, missing(f"*SURFACE INTERACTION '{clip(name)}'"))
        self.used_interactions.add(name.upper())
        return self.frictions[name.upper()]

    # --- names in the deck of percuss

    def used_nodes(self) -> set[int]:
        if self._used is None:
            self._used = self.model.used_nodes()
        return self._used

    def forget_used(self) -> None:
        """Elements were added."""
        self._used = None

    def node_set_name(self, name: str, place: Place) -> str:
        """Empty where no node of it has an element."""
        key = ("nodes", name.upper())
        if key not in self._names:
            kept = [node for node in self.nodes_of(name, place) if node in self.used_nodes()]
            wish = name if parse_integer(name) is None else f"node_{name}"
            self._names[key] = self.model.add_node_set(wish, kept) if kept else ""
        return self._names[key]

    def surface_name(self, name: str, place: Place, of_contact: bool) -> str:
        """A side set, or the parts of a surface that is all free faces; of contact both faces of shells."""
        key = ("contact" if of_contact else "surface", name.upper())
        if key not in self._names:
            self._names[key] = self._make_surface(name, place, of_contact)
        return self._names[key]

    def is_of_nodes(self, name: str) -> bool:
        """Whether a surface has nodes or edges alone."""
        if self.find_node_surface(name) is not None:
            return True
        sides = self.mesh.surfaces.get(self.tidy(name), [])
        return bool(sides) and all(is_edge(label) for _, label in sides)

    def find_node_surface(self, name: str) -> list[str] | None:
        name = self.tidy(name)
        fits = [key for key in self.mesh.node_surfaces if key == name or key.endswith("." + name)]
        return self.mesh.node_surfaces[fits[0]] if len(fits) == 1 or name in fits else None

    def nodes_of_surface(self, name: str, place: Place) -> set[int]:
        """Nodes of a surface of faces or edges of elements, or of nodes."""
        words = self.find_node_surface(name)
        if words is not None:
            return {node for word in words for node in self.nodes_of(word, place)}
        nodes: set[int] = set()
        for where, label in self.resolve(self.mesh.surfaces, name, place, "surface"):
            for id in self.elements_of(where, place):
                if id not in self.blocks_of_elements:
                    continue
                kind, corners = self.mesh.elements[id]
                if is_edge(label) or kind in PLANES and label[1:] in ("1", "2", "3", "4"):
                    first = (int(label[1]) - 1) % len(corners)
                    nodes |= {corners[first], corners[(first + 1) % len(corners)]}
                elif label:
                    nodes.update(node for face in self._list_faces(id, label, place, False) for node in face)
                else:
                    nodes.update(corners)
        return nodes

    def all_nodes_of_surface(self, name: str, place: Place) -> set[int]:
        """Nodes of a surface, of elements without a part too."""
        if self.find_node_surface(name) is not None:
            return self.nodes_of_surface(name, place)
        sides = self.resolve(self.mesh.surfaces, name, place, "surface")
        found = [(id, label) for where, label in sides if not is_edge(label)
                 for id in self.elements_of(where, place) if id in self.mesh.elements]
        return {node for id, label in found
                for face in (self._list_faces(id, label, place, False) if label else [self.mesh.elements[id][1]])
                for node in face}

    def list_faces(self, name: str, place: Place) -> list[tuple[int, ...]]:
        """Faces of solids of a surface."""
        if self.find_node_surface(name) is not None:
            nodes = self.nodes_of_surface(name, place)
            return [face for id in self.blocks_of_elements
                    for face in self._list_all_faces(id) if nodes.issuperset(face)]
        sides = self.resolve(self.mesh.surfaces, name, place, "surface")
        found = [(id, label) for where, label in sides for id in self.elements_of(where, place)
                 if id in self.blocks_of_elements and self.mesh.elements[id][0] in SOLIDS]
        whole = [face for id, label in found if not label for face in self._list_all_faces(id)]
        counts = Counter(frozenset(face) for face in whole)
        free = [face for face in whole if counts[frozenset(face)] == 1]
        return free + [face for id, label in found if label for face in self._list_faces(id, label, place, False)]

    def faces_of_nodes(self, name: str, place: Place) -> str:
        """A side set of the faces whose corners are all of a surface of nodes; empty: there are none."""
        key = ("faces of", name.upper())
        if key not in self._names:
            nodes = self.nodes_of_surface(name, place)
            faces = [face for id in self.blocks_of_elements
                     for face in self._list_all_faces(id) if nodes.issuperset(face)]
            self._names[key] = self.model.names.take(name) if faces else ""
            if faces:
                self.model.side_sets[self._names[key]] = faces
        return self._names[key]

    def _list_all_faces(self, id: int) -> list[tuple[int, ...]]:
        kind, corners = self.mesh.elements[id]
        if kind in SHELLS:
            return [corners, corners[::-1]]
        faces = ([tuple(dict.fromkeys(corners[i] for i in face)) for face in SIDES.get(len(corners), ())]
                 if kind in SOLIDS else [])
        return [face for face in faces if len(face) >= 3]

    def add_faces(self, name: str, label: str, place: Place) -> str:
        """A side set of the faces that *DLOAD names; empty: there are none. P of a shell pushes along its normal."""
        key = ("faces", name.upper(), label)
        if key not in self._names:
            ids = [id for id in self.elements_of(name, place) if id in self.blocks_of_elements]
            faces: list[tuple[int, ...]] = []
            for id in ids:
                is_solid = self.mesh.elements[id][0] in SOLIDS
                if is_solid == (label != "P") and self.mesh.elements[id][0] in (*SOLIDS, *SHELLS):
                    faces += self._list_faces(id, label if is_solid else "SNEG", place, False)
            self._names[key] = self.model.names.take(f"{name}_{label}", "faces") if faces else ""
            if faces:
                self.model.side_sets[self._names[key]] = faces
        return self._names[key]

    def _make_surface(self, name: str, place: Place, of_contact: bool) -> str:
        sides = self.resolve(self.mesh.surfaces, name, place, "surface")
        if sides and all(not label for _, label in sides):
            ids = [id for where, _ in sides for id in self.elements_of(where, place) if id in self.blocks_of_elements]
            return self._name_elements(name, ids)
        faces = [face for where, label in sides
                 for id in self.elements_of(where, place) if id in self.blocks_of_elements
                 for face in self._list_faces(id, label, place, of_contact)]  # fmt: skip
        if not faces:
            return ""
        taken = self.model.names.take(name)
        self.model.side_sets[taken] = list(dict.fromkeys(faces))
        return taken

    def _name_elements(self, name: str, ids: list[int]) -> str:
        """The name of a block, or of a set of elements."""
        wanted = set(ids)
        for block in self.model.blocks:
            if wanted == {id for id, _ in block.elements()}:
                return block.name
        if not ids:
            return ""
        kind = "SOLID" if self.mesh.elements[ids[0]][0] in SOLIDS else "SHELL"
        taken = self.model.names.take(name)
        self.model.element_sets[taken] = (kind, sorted(wanted))
        return taken

    def _list_faces(self, id: int, label: str, place: Place, of_contact: bool) -> list[tuple[int, ...]]:
        kind, corners = self.mesh.elements[id]
        if kind in PLANES:
            self.ledger.refuse("SURFACE.plane", place,
                               "a surface of plane elements, whose faces are edges", "it is left out")
            return []
        if not kind.startswith(("C3D", "COH3D")) and kind not in FLAT:
            both = [corners, corners[::-1]]
            if of_contact or label not in ("SPOS", "SNEG", "S1", "S2"):
                return both
            return both[:1] if label in ("SPOS", "S2") else both[1:]
        table = SIDES.get(len(corners), ())
        number = int(label[1:]) if label[:1] in ("S", "P") and label[1:].isdigit() and len(label) == 2 else 0
        number += 1 if (kind, number) == ("CAX3", 3) else 0  # its third corner stands twice
        # behind the faces of its planes
        number += 2 if kind in FLAT and 1 <= number <= FLAT[kind] + (kind == "CAX3") else 0
        if not 1 <= number <= len(table):
            raise BadInput(place, f"element {id} has no face '{clip(label)}'")
        face = tuple(dict.fromkeys(corners[i] for i in table[number - 1]))  # of a hexahedron with collapsed edges once
        return [face] if len(face) >= 3 else []


def is_edge(label: str) -> bool:
    """E1 to E4 of shells."""
    return len(label) == 2 and label[0] == "E" and label[1] in "1234"
