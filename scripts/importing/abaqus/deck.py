"""An Abaqus deck in memory: its mesh, and what its keywords define by name."""

from collections import Counter
from dataclasses import dataclass, field

from ..curves import Curve
from ..fields import clip, parse_integer
from ..ledger import BadInput, Ledger, Place, missing
from ..model import Deck, Model
from .lines import Block
from .mesh import SIDES, SOLIDS, Instance, Scope


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
    held: dict[str, tuple[int, Deck | None]] = field(default_factory=dict)  # by direction: reference node, motion or rest
    wall: Deck | None = None  # of an analytical surface, by its name
    profile: str = ""


class AbaqusDeck:
    """All definitions, and the model that they become."""

    def __init__(self, ledger: Ledger):
        self.ledger, self.model = ledger, Model()
        self.mesh = Scope()
        self.parts: dict[str, Scope] = {}
        self.instances: list[Instance] = []
        self.materials: dict[str, MaterialBlocks] = {}
        self.amplitudes: dict[str, Curve] = {}
        self.frictions: dict[str, float] = {}  # of *SURFACE INTERACTION
        self.velocities: dict[int, list[float]] = {}  # of nodes at the start
        self.temperatures: dict[int, float] = {}  # likewise
        self.temperature_place: Place | None = None  # the last card of them
        self.pairs: list[Deck] = []
        self.wall_pairs: list[tuple[str, str, float]] = []  # analytical surface, what it stops, friction
        self.whole: Deck | None = None  # contact of everything
        self.end_time = 0.0
        self.step_scale = 0.0  # 0: percuss' own
        self.heats = False  # plastic work changes temperatures
        self.integrations: dict[int, Counter[str]] = {}  # of the hexahedra of a block, by its index
        self.pair_frictions: list[Deck] = []  # rows of contact.friction.pairs
        self.blocks_of_elements: dict[int, int] = {}  # element: index of its block
        self.groups: list[RigidGroup] = []
        self.group_of_ref: dict[int, RigidGroup] = {}
        self._names: dict[tuple[str, str], str] = {}
        self._used: set[int] | None = None

    # --- references

    def resolve(self, table: dict, name: str, place: Place, what: str):
        """What a name means: NAME, or INSTANCE.NAME where one instance alone has it."""
        name = name.strip().strip('"').upper()
        if name in table:
            return table[name]
        fits = [key for key in table if key.endswith("." + name)]
        if len(fits) == 1:
            return table[fits[0]]
        if not fits:
            raise BadInput(place, missing(f"{what} '{clip(name)}'"))
        raise BadInput(place, f"'{clip(name)}' may be one of {len(fits)} {what}s (several instances have it): write INSTANCE.NAME")

    def list_ids(self, table: dict, known: dict, name: str, place: Place, what: str) -> list[int]:
        """Ids of a set, or one id, also as INSTANCE.ID."""
        instance, _, label = name.rpartition(".")
        id = parse_integer(label)
        if id is None:
            return self.resolve(table, name, place, what)
        shift = next((i.shift for i in self.instances if i.name == instance.upper()), 0)
        if id + shift not in known:
            raise BadInput(place, missing(f"{what} or id {clip(name)}"))
        return [id + shift]

    def nodes_of(self, name: str, place: Place) -> list[int]:
        return self.list_ids(self.mesh.node_sets, self.mesh.nodes, name, place, "node set")

    def elements_of(self, name: str, place: Place) -> list[int]:
        return self.list_ids(self.mesh.element_sets, self.mesh.elements, name, place, "element set")

    def amplitude(self, name: str, place: Place) -> Curve | None:
        if not name:
            return None
        if name not in self.amplitudes:
            raise BadInput(place, missing(f"amplitude '{clip(name)}', or it is of a kind that is not read"))
        return self.amplitudes[name]

    # --- names in the deck of percuss

    def used_nodes(self) -> set[int]:
        if self._used is None:
            self._used = self.model.used_nodes()
        return self._used

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

    def nodes_of_surface(self, name: str, place: Place) -> set[int]:
        """Nodes of a surface of faces of elements, or of nodes."""
        if name.upper() in self.mesh.node_surfaces:
            return {node for word in self.mesh.node_surfaces[name.upper()] for node in self.nodes_of(word, place)}
        nodes: set[int] = set()
        for where, label in self.resolve(self.mesh.surfaces, name, place, "surface"):
            for id in self.elements_of(where, place):
                if id in self.blocks_of_elements and label:
                    nodes.update(node for face in self._list_faces(id, label, place, False) for node in face)
                elif id in self.blocks_of_elements:
                    nodes.update(self.mesh.elements[id][1])
        return nodes

    def _make_surface(self, name: str, place: Place, of_contact: bool) -> str:
        sides = self.resolve(self.mesh.surfaces, name, place, "surface")
        if sides and all(not label for _, label in sides):
            ids = [id for where, _ in sides for id in self.elements_of(where, place) if id in self.blocks_of_elements]
            return self._name_elements(name, ids)
        faces = [face for where, label in sides for id in self.elements_of(where, place) if id in self.blocks_of_elements
                 for face in self._list_faces(id, label, place, of_contact)]  # fmt: skip
        if not faces:
            return ""
        taken = self.model.names.take(name)
        self.model.side_sets[taken] = faces
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
        if not kind.startswith("C3D"):
            both = [corners, corners[::-1]]
            if of_contact or label not in ("SPOS", "SNEG", "S1", "S2"):
                return both
            return both[:1] if label in ("SPOS", "S2") else both[1:]
        table = SIDES.get(len(corners), ())
        number = int(label[1:]) if label[:1] in ("S", "P") and label[1:].isdigit() and len(label) == 2 else 0
        if not 1 <= number <= len(table):
            raise BadInput(place, f"element {id} has no face '{clip(label)}'")
        face = tuple(dict.fromkeys(corners[i] for i in table[number - 1]))  # of a hexahedron with collapsed edges once
        return [face] if len(face) >= 3 else []
