"""*OUTPUT and the requests that follow it: fields and history of percuss."""

from collections.abc import Callable
from dataclasses import dataclass, field

from ..fields import clip, parse_integer
from ..laws import has
from ..model import Deck
from .deck import AbaqusDeck, RigidGroup
from .followers import list_leaders
from .lines import Block

FIELDS = {  # of a variable, or of its letters
    "V": "velocity", "S": "stress", "MISES": "von_mises", "MISESMAX": "von_mises", "MISESONLY": "von_mises",
    "PRESS": "pressure",
    "PRESSONLY": "pressure", "PEEQ": "equivalent_plastic_strain", "PEEQMAX": "equivalent_plastic_strain",
    "TEMP": "temperature", "VVF": "void_fraction",
    "STATUS": "alive", "SDEG": "damage", "DUCTCRT": "damage", "JCCRT": "damage", "SHRCRT": "damage", "DMICRT": "damage",
    "STH": "thickness",
    "ENER": "internal_energy", "ELEN": "internal_energy", "SENER": "internal_energy", "CSTRESS": "contact_pressure",
    "CPRESS": "contact_pressure",
    "CFORCE": "contact_force", "CNORMF": "contact_force", "CSHEARF": "contact_force", "SF": "section_force",
    "SM": "section_moment",
}  # fmt: skip
ALWAYS = {"U": "displacement is always written", "UT": "displacement is always written",
          "COORD": "places are always written"}
PRESELECT = {"field": ("S", "PEEQ", "V", "CSTRESS"), "history": ()}
OF_NODES = ("U", "UT", "UR", "V", "VT", "VR", "A", "AT", "AR", "COORD", "COOR")
OF_SUPPORTS = ("RF", "RM", "RT")
OF_CONTACT = ("CFN", "CFS", "CFT", "CFORCE", "CMN", "CMS", "CMT", "CNORMF", "CSHEARF")
OF_ELEMENTS = ("S", "MISES", "PRESS", "PEEQ", "E", "LE", "ENER", "TEMP")
MOST_FOLLOWED, MOST_FORCES, MOST_STATES, MOST_STATE_FIELDS = 100, 32, 50, 72
LOST = "percuss has no such output: it is not written"
NOT_HELD = "nothing holds these nodes, so there is no force"


@dataclass
class Request:
    """*OUTPUT with the keywords that follow it."""

    block: Block
    followers: list[Block] = field(default_factory=list)

    @property
    def is_field(self) -> bool:
        return "FIELD" in self.block.options


def strip(word: str) -> str:
    """The letters of a variable: S11 and RF3 as S and RF."""
    return word.upper().rstrip("0123456789")


def list_words(request: Request, block: Block) -> list[str]:
    """Variables, without those of VARIABLE=PRESELECT or ALL."""
    return [word.upper() for line in block.lines for word in line[1] if word]


def add_outputs(deck: AbaqusDeck, requests: list[Request]) -> None:
    """Sections of `output`."""
    history: Deck = {"every": choose_every(deck, [r for r in requests if not r.is_field], deck.end_time / 1000,
                                           deck.end_time / 1e6)}
    deck.model.deck["output"] = {"history": history}
    writer = Writer(deck, history)
    asked = [r for r in requests if r.is_field]
    if asked:
        every = choose_every(deck, asked, deck.end_time / 20, deck.end_time / 1e5)
        deck.model.deck["output"]["fields"] = {"every": every, "write": writer.fields}
    for request in requests:
        deck.ledger.translated("OUTPUT", request.block.place, "output.fields" if request.is_field else "output.history")
        if request.block.option("VARIABLE") in ("PRESELECT", "ALL") and request.is_field:
            for word in PRESELECT["field"]:
                writer.write_field(word, request.block)
            if request.block.option("VARIABLE") == "ALL":
                deck.ledger.approximated("OUTPUT.VARIABLE", request.block.place,
                                         "VARIABLE=ALL: the fields of PRESELECT")
        for block in request.followers:
            HANDLERS.get(block.keyword, Writer.lose)(writer, request, block)
            deck.model.origins.note(deck.model, block.keyword, block.place)
    if asked and not writer.fields:
        writer.fields.append("velocity")
    for key in [key for key, value in history.items() if value == []]:
        del history[key]


def choose_every(deck: AbaqusDeck, requests: list[Request], default: float, least: float) -> float:
    """The smallest interval of all steps that is asked for."""
    found = []
    for request in requests:
        block, length = request.block, deck.step_of(request.block).length
        line = (block.place.line, [block.options.get(name, "") for name in ("TIME INTERVAL", "NUMBER INTERVAL")])
        interval, number = block.number(line, 0), block.number(line, 1)
        if interval > 0 or number > 0:
            found.append(interval if interval > 0 else length / number)
    return max(float(f"{min(found, default=default):.12g}"), least)


class Writer:
    """Adds what requests ask for; each thing once."""

    def __init__(self, deck: AbaqusDeck, history: Deck):
        self.deck, self.history = deck, history
        self.fields: list[str] = []
        self._done: set[tuple[str, ...]] = set()

    # --- fields

    def write_field(self, word: str, block: Block) -> None:
        name = FIELDS.get(word) or FIELDS.get(strip(word))
        if strip(word) == "SDV" and (states := self._list_states(word)):
            self.fields += [state for state in states if state not in self.fields]
            self.deck.ledger.translated(block.keyword, block.place, f"output.fields: {', '.join(states[:3])}")
        elif word in ALWAYS or strip(word) in ALWAYS:
            self.deck.ledger.translated(block.keyword, block.place, ALWAYS.get(word) or ALWAYS[strip(word)])
        elif name is None or not self._has(name):
            self.deck.ledger.ignored(f"{block.keyword}.{clip(word)}", block.place, LOST)
        else:
            for name_of_field in (name, "von_mises") if name == "stress" else (name,):
                if name_of_field not in self.fields:
                    self.fields.append(name_of_field)
            self.deck.ledger.translated(block.keyword, block.place, f"output.fields: {name}")

    def _list_states(self, word: str) -> list[str]:
        """State variables of user code: SDV3, or all of them, at most the first MOST_STATES."""
        count = max((law.get("state_variables", 0) for law in self.deck.model.materials.values()), default=0)
        number = parse_integer(word[3:]) or 0
        wanted = range(number, number + 1) if number else range(1, min(count, MOST_STATES) + 1)
        return [f"state_variable_{i}" for i in wanted if i <= min(count, MOST_STATE_FIELDS)]

    def _has(self, name: str) -> bool:
        """Whether the model has what a field is of."""
        blocks, laws = self.deck.model.blocks, self.deck.model.materials.values()
        needs = {
            "thickness": any(b.shells for b in blocks), "section_force": any(b.beams for b in blocks), "section_moment":
            any(b.beams for b in blocks), "temperature": any(has(law, "has_temperature") for law in laws),
            "void_fraction": any(has(law, "has_void_fraction") for law in laws),
            "damage": any("failure" in law for law in laws),
            "alive": any("failure" in law or "delete_variable" in law for law in laws),
            "contact_force": "contact" in self.deck.model.deck, "contact_pressure": "contact" in self.deck.model.deck,
        }  # fmt: skip
        return needs.get(name, True)

    # --- history

    def read_nodes(self, request: Request, block: Block) -> None:
        """Places and velocities of nodes, and forces of supports."""
        words = list_words(request, block)
        if request.is_field:
            for word in words or ("U", "V"):
                self.write_field(word, block)
            return
        name = block.option("NSET")
        for word in words:
            if strip(word) in OF_SUPPORTS:
                self._add_support(name, block)
            elif strip(word) in OF_NODES:
                self._add_nodes(name, block)
            else:
                self.deck.ledger.ignored(f"{block.keyword}.{clip(word)}", block.place, LOST)

    def _once(self, *key: str) -> bool:
        if key in self._done:
            return False
        self._done.add(key)
        return True

    def _add_nodes(self, name: str, block: Block) -> None:
        if not name or not self._once("nodes", name):
            return
        leaders = list_leaders(self.deck)
        ids = [leaders[id].nodes[0] if id in leaders else id for id in self.deck.nodes_of(name, block.place)]
        bodies = [self.deck.group_of_ref[id]
                  for id in ids if id in self.deck.group_of_ref and id not in self.deck.used_nodes()]
        if bodies:
            self.deck.ledger.translated(block.keyword, block.place, "columns of the mass centre of its rigid body in "
                                                                    "the history (body_x:NAME and so on)")
        of_second_plane = set(self.deck.twins.values())  # of plane strain, which move as the first
        ids = [id for id in ids if id in self.deck.used_nodes() and id not in of_second_plane]
        if len(ids) > MOST_FOLLOWED:
            self.deck.ledger.approximated(block.keyword, block.place, f"the first {MOST_FOLLOWED} of {len(ids)} nodes")
        for id in ids[:MOST_FOLLOWED]:
            wish = name if len(ids) == 1 else f"{name}_{id}"
            self.history.setdefault("nodes", []).append(
                {"name": self.deck.model.names.take(wish.replace(".", "_"), "node"), "id": id})
        if ids:
            self.deck.ledger.translated(block.keyword, block.place, "output.history.nodes")

    def _lead(self, name: str, block: Block) -> list[int]:
        """Nodes of a set; for one without elements those that move as it does."""
        leaders = list_leaders(self.deck)
        found = self.deck.nodes_of(name, block.place)
        return [node for id in found for node in (leaders[id].nodes if id in leaders else [id])]

    def _name_held(self, name: str, ids: list[int], block: Block) -> str:
        """The set of a name, or of the nodes that follow its node."""
        if set(ids) <= set(self.deck.nodes_of(name, block.place)):
            return self.deck.node_set_name(name, block.place)
        return self.deck.model.add_node_set(f"held_{name}".replace(".", "_"), ids)

    def _add_support(self, name: str, block: Block) -> None:
        """Force of what holds a set, or the bodies and walls of reference nodes."""
        if not name or not self._once("support", name):
            return
        ids = self._lead(name, block)
        groups = {id: self.deck.group_of_ref[id] for id in ids if id in self.deck.group_of_ref}
        for id, group in groups.items():
            self._add_body_support(name if len(ids) == 1 else f"{name}_{id}", id, group, block)
        rest = [id for id in ids if id not in groups]
        if rest and not self._holds_some(rest):
            self.deck.ledger.ignored(f"{block.keyword}.RF", block.place, NOT_HELD)
        elif rest:
            selector = (self._name_held(name, rest, block) if not groups
                        else self.deck.model.add_node_set(f"held_{name}".replace(".", "_"), rest))
            self._add_force(f"force_{name}", {"support": selector}, block)

    def _holds_some(self, ids: list[int]) -> bool:
        """Whether a condition of the deck holds or moves one of these nodes: a rotation only where a node has one."""
        wanted, turning = set(ids) & self.deck.used_nodes(), self.deck.model.turning_nodes()
        return any(node in wanted and (way in ("x", "y", "z") or node in turning)
                   for node, way in self.deck.motions.windows)

    def _add_body_support(self, name: str, ref: int, group: RigidGroup, block: Block) -> None:
        """What holds or moves the body or the wall of a reference node; moments are about its place at time 0."""
        wall = group.wall["name"] if group.wall else None
        if wall and any(entry.get("name") == wall for entry in self.deck.model.deck.get("walls", [])):
            self._add_force(f"force_{name}", {"wall": wall}, block)
        elif group.joint:
            self.deck.ledger.translated(block.keyword, block.place, f"joint_fx:{group.joint} and so on of the history, "
                                                                    "which the joint at the node always has")
        elif not (group.held or group.spells) or not group.nodes:
            self.deck.ledger.ignored(f"{block.keyword}.RF", block.place, NOT_HELD)
        else:
            nodes = self.deck.model.add_node_set(f"held_{name}".replace(".", "_"), group.nodes)
            self._add_force(f"force_{name}", {"support": nodes, "about": list(self.deck.mesh.nodes[ref])}, block)
            if any(motion is not None for way, (_, motion) in group.held.items() if way in ("x", "y", "z")):
                self.deck.ledger.approximated(f"{block.keyword}.RM", block.place,
                                              "moments are about the place of the reference node at time 0")

    def _add_force(self, wish: str, what: Deck, block: Block) -> None:
        forces = self.history.setdefault("forces", [])
        if (len([f for f in forces if "contact" in f or "wall" in f]) >= MOST_FORCES
                and not {"support", "section"} & what.keys()):
            self.deck.ledger.ignored(f"{block.keyword}.many", block.place,
                                     f"percuss has at most {MOST_FORCES} forces of contact")
            return
        forces.append({"name": self.deck.model.names.take(wish.replace(".", "_"), "force"), **what})
        self.deck.ledger.translated(block.keyword, block.place, "output.history.forces")

    def read_elements(self, request: Request, block: Block) -> None:
        words = list_words(request, block)
        if request.is_field:
            for word in words or ("S", "PEEQ"):
                self.write_field(word, block)
            return
        name = block.option("ELSET")
        lost = [word for word in words if strip(word) not in OF_ELEMENTS or strip(word) in ("E", "LE")]
        for word in lost:
            self.deck.ledger.ignored(f"{block.keyword}.{clip(word)}", block.place, LOST)
        if not name or len(lost) == len(words) or not self._once("elements", name):
            return
        ids = [id for id in self.deck.elements_of(name, block.place) if id in self.deck.blocks_of_elements]
        if len(ids) > MOST_FOLLOWED:
            self.deck.ledger.approximated(block.keyword, block.place,
                                          f"the first {MOST_FOLLOWED} of {len(ids)} elements")
        for id in ids[:MOST_FOLLOWED]:
            wish = name if len(ids) == 1 else f"{name}_{id}"
            self.history.setdefault("elements", []).append(
                {"name": self.deck.model.names.take(wish.replace(".", "_"), "element"), "id": id})
        self.deck.ledger.translated(block.keyword, block.place, "output.history.elements")

    def read_energies(self, request: Request, block: Block) -> None:
        """Energies of the whole are always in the history; those of a set where it is a part."""
        name = block.option("ELSET")
        if not name:
            self.deck.ledger.translated(block.keyword, block.place, "energies are always in the history")
            return
        wanted = set(self.deck.elements_of(name, block.place))
        parts = [part.name for part in self.deck.model.blocks if {id for id, _ in part.elements()} <= wanted]
        if (not parts or sum(len(part.elements()) for part in self.deck.model.blocks if part.name in parts)
                < len(wanted & self.deck.blocks_of_elements.keys())):
            self.deck.ledger.ignored(f"{block.keyword}.ELSET", block.place,
                                     "energies of a set that is not whole parts are not written")
            return
        known = self.history.setdefault("parts", [])
        known += [part for part in parts if part not in known]
        self.deck.ledger.translated(block.keyword, block.place, "output.history.parts")

    def read_contact(self, request: Request, block: Block) -> None:
        words = list_words(request, block)
        if request.is_field:
            for word in words or ("CSTRESS",):
                self.write_field(word, block)
            return
        for word in words:
            if strip(word) not in OF_CONTACT:
                self.deck.ledger.ignored(f"{block.keyword}.{clip(word)}", block.place, LOST)
        if ((not words or any(strip(word) in OF_CONTACT for word in words))
                and self._once("contact", block.option("SURFACE"), block.option("SECOND SURFACE"))):
            self._add_contact(block)

    def _add_contact(self, block: Block) -> None:
        """Forces of two surfaces, of one, of each pair, or of each part with all others."""
        deck, names = (self.deck,
                       [block.option(word)
                        for word in ("SURFACE", "SECOND SURFACE", "MASTER", "SLAVE", "NSET") if block.option(word)])
        pairs: list[tuple[str, str]] = []
        if names and not any(deck.is_of_nodes(name) for name in names[:2]):
            sides = [deck.surface_name(name, block.place, of_contact=True) for name in names[:2]]
            pairs = [(sides[0], sides[1] if len(sides) > 1 else "all")] if all(sides) else []
        elif not names:
            pairs = [(a, b) for a, b in deck.contact_names.values()]
            if deck.is_whole or not (pairs or deck.wall_pairs):
                pairs += [(part.name, "all") for part in deck.model.blocks]
        if "surfaces" not in deck.model.deck.get("contact", {}) and not deck.model.deck.get("walls"):
            deck.ledger.ignored(block.keyword, block.place, "nothing touches, so there is no force of contact")
            return
        for a, b in pairs if deck.model.deck.get("contact", {}).get("surfaces", "none") != "none" else []:
            if a != b:
                self._add_force(f"contact_{a}_{b}" if b != "all" else f"contact_{a}", {"contact": [a, b]}, block)
        for wall in deck.model.deck.get("walls", []) if not names else []:
            if self._once("wall", wall["name"]):
                self._add_force(f"contact_{wall['name']}", {"wall": wall["name"]}, block)

    def lose(self, request: Request, block: Block) -> None:
        self.deck.ledger.ignored(block.keyword, block.place, LOST)


HANDLERS: dict[str, Callable[[Writer, Request, Block], None]] = {
    "NODE OUTPUT": Writer.read_nodes, "ELEMENT OUTPUT": Writer.read_elements, "ENERGY OUTPUT": Writer.read_energies,
    "CONTACT OUTPUT": Writer.read_contact,
}  # fmt: skip
FOLLOWERS = {*HANDLERS, "INTEGRATED OUTPUT", "INCREMENTATION OUTPUT", "RADIATION OUTPUT", "SURFACE OUTPUT",
             "MODAL OUTPUT"}
