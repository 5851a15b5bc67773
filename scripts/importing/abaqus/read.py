"""An Abaqus deck becomes a model: which keyword is read by what."""

from collections.abc import Callable

from ..ledger import BadInput, Ledger
from ..model import Model
from . import bodies, equations, heat, steps, surfaces
from .deck import AbaqusDeck, MaterialBlocks
from .lines import Block, BlockReader
from .masses import read_mass_scaling
from .mesh import BodyCard, Scope, read_elements, read_instance, read_nodes, read_set, read_surface
from .options import check_options
from .parts import add_masses, build_parts, choose_integration, place_instances, read_section
from .springs import add_springs, read_spring

Handler = Callable[[AbaqusDeck, Block], None]
IGNORED = {
    "PREPRINT": "output", "RESTART": "output", "NODE OUTPUT": "output", "ELEMENT OUTPUT": "output", "ENERGY OUTPUT": "output",
    "CONTACT OUTPUT": "output", "MONITOR": "output", "FILE OUTPUT": "output", "NODE PRINT": "output", "EL PRINT": "output",
    "NODE FILE": "output",
    "EL FILE": "output", "SECTION CONTROLS": "numerics", "CONTACT CONTROLS": "numerics", "CONTACT CONTROLS ASSIGNMENT": "numerics",
    "CONTACT": "what follows it says all", "END STEP": "the end of the step", "SURFACE BEHAVIOR": "contact is hard, and may part",
    "CONTACT FORMULATION": "contact works both ways", "DIAGNOSTICS": "output", "INTEGRATED OUTPUT": "output",
    "INCREMENTATION OUTPUT": "output",
    "ORIENTATION": "the laws that are read are isotropic", "DISTRIBUTION TABLE": "of distributions", "CONTACT INITIALIZATION DATA": "numerics",
}  # fmt: skip
MATERIAL_END = {"MATERIAL", "STEP", "BOUNDARY", "AMPLITUDE", "SURFACE INTERACTION", "INITIAL CONDITIONS", "PART", "ASSEMBLY", "NSET", "ELSET",
                "NODE", "ELEMENT", "SOLID SECTION", "SHELL SECTION", "BEAM SECTION", "SURFACE", "TIE", "CONTACT", "CONTACT PAIR", "INSTANCE",
                "END ASSEMBLY"}  # fmt: skip


class Reader:
    """Takes keywords one after the other; remembers in which part, material or interaction they stand."""

    def __init__(self, ledger: Ledger):
        self.deck = AbaqusDeck(ledger)
        self.flat, self.assembly = Scope(), Scope()
        self.scope = self.flat
        self.material: MaterialBlocks | None = None
        self.interaction = ""
        self.coupling: BodyCard | None = None
        self.waiting: list[Block] = []
        self.steps = 0

    def take(self, block: Block) -> None:
        keyword = block.keyword
        check_options(block, self.deck.ledger)
        if self.material and not (keyword in MATERIAL_END or keyword in METHODS or keyword in ACTIONS):
            self.material.parts.append(block)
            return
        self.material = None
        method = METHODS.get(keyword)
        if method:
            method(self, block)
        elif keyword in ACTIONS:
            self.waiting.append(block)
        elif keyword in IGNORED:
            self.deck.ledger.ignored(keyword, block.place, IGNORED[keyword])
        else:
            self.deck.ledger.refuse(keyword or "(blank)", block.place, "an unknown keyword", "it is left out")

    def heading(self, block: Block) -> None:
        self.deck.model.title = ", ".join(block.lines[0][1]) if block.lines else ""
        self.deck.ledger.translated("HEADING", block.place, "title")

    def begin_part(self, block: Block) -> None:
        self.scope = self.deck.parts.setdefault(block.option("NAME"), Scope(place=block.place))

    def begin_assembly(self, block: Block) -> None:
        self.scope = self.assembly

    def begin_instance(self, block: Block) -> None:
        self.deck.instances.append(read_instance(block))
        self.scope = self.deck.instances[-1].own

    def end(self, block: Block) -> None:
        self.scope = self.assembly if block.keyword == "END INSTANCE" else self.flat

    def nodes(self, block: Block) -> None:
        if block.option("SYSTEM") not in ("", "R"):
            raise BadInput(block.place, "nodes in cylindrical or spherical coordinates are not read: convert them to rectangular ones")
        read_nodes(self.scope, block)
        self.deck.ledger.translated("NODE", block.place, "nodes of the mesh")

    def elements(self, block: Block) -> None:
        self.scope.place = self.scope.place or block.place
        read_elements(self.scope, block)
        self.deck.ledger.translated(
            f"ELEMENT, TYPE={block.option('TYPE')}", block.place, "elements of the mesh, where a section has them"
        )

    def sets(self, block: Block) -> None:
        if self.scope is self.assembly:
            self.waiting.insert(0, block)  # instances are not in their places yet
            return
        read_set(self.scope, block, self.scope.node_sets if block.keyword == "NSET" else self.scope.element_sets)
        self.deck.ledger.translated(block.keyword, block.place, "a set of the mesh, where something uses it")

    def surface(self, block: Block) -> None:
        if block.option("TYPE") == "REVOLUTION":
            surfaces.read_profile(self.scope, block)
            self.deck.ledger.translated("SURFACE.REVOLUTION", block.place, "a wall, where a rigid body has it")
            return
        read_surface(self.scope, block, self.deck.ledger)
        self.deck.ledger.translated("SURFACE", block.place, "a side set, where something uses it")

    def section(self, block: Block) -> None:
        read_section(self.scope, block)

    def nodal_thickness(self, block: Block) -> None:
        for line in block.lines:
            self.scope.thicknesses.append((block.text(line, 0).upper(), block.number(line, 1), block.place))
        self.deck.ledger.translated("NODAL THICKNESS", block.place, "thickness of shells, where a section asks for it")

    def mass(self, block: Block) -> None:
        for line in block.lines[:1]:
            self.scope.masses.append((block.option("ELSET"), block.number(line, 0), block.place))

    def spring(self, block: Block) -> None:
        read_spring(self.scope, block, self.deck.ledger)

    def rigid_body(self, block: Block) -> None:
        bodies.read_rigid_body(self.scope, block, self.deck.ledger)

    def begin_coupling(self, block: Block) -> None:
        self.coupling = bodies.read_coupling(block)

    def kinematic(self, block: Block) -> None:
        bodies.read_kinematic(self.scope, self.coupling, block, self.deck.ledger)
        self.coupling = None

    def constraints(self, block: Block) -> None:
        bodies.read_constraints(self.scope, block, self.deck.ledger)

    def equations(self, block: Block) -> None:
        equations.read_equations(self.scope, block, self.deck.ledger)

    def begin_material(self, block: Block) -> None:
        self.material = MaterialBlocks(block.place)
        self.deck.materials[block.option("NAME")] = self.material

    def begin_interaction(self, block: Block) -> None:
        self.interaction = block.option("NAME")
        self.deck.frictions[self.interaction] = 0.0

    def friction(self, block: Block) -> None:
        if block.lines:
            self.deck.frictions[self.interaction] = block.number(block.lines[0], 0)
        if set(block.options) - {"TAUMAX", "SLIP TOLERANCE"} or "TAUMAX" in block.options:
            self.deck.ledger.refuse("FRICTION", block.place, "friction other than Coulomb's", "Coulomb's coefficient is used")
        self.deck.ledger.translated("FRICTION", block.place, "friction of contact")

    def amplitude(self, block: Block) -> None:
        steps.read_amplitude(self.deck, block)

    def begin_step(self, block: Block) -> None:
        self.steps += 1
        if self.steps > 1:
            self.deck.ledger.refuse(
                "STEP", block.place, "a second step", "its conditions and loads act from the start, and its time is added"
            )

    def dynamic(self, block: Block) -> None:
        if "EXPLICIT" not in block.options:
            self.deck.ledger.refuse("DYNAMIC", block.place, "an implicit step", "the run is explicit")
        if "SCALE FACTOR" in block.options:
            self.deck.step_scale = block.number((block.place.line, [block.options["SCALE FACTOR"]]), 0, 1.0)
        heat.read_procedure(self.deck, block)
        self.deck.end_time += max((block.number(line, 1) for line in block.lines[:1]), default=0.0)
        self.deck.ledger.translated("DYNAMIC", block.place, "time.end")

    def static(self, block: Block) -> None:
        self.deck.ledger.refuse(
            block.keyword, block.place, "a step that is not explicit dynamics", "the run is explicit, with its time"
        )
        self.deck.end_time += max((block.number(line, 1, 1.0) for line in block.lines[:1]), default=1.0)

    def viscosity(self, block: Block) -> None:
        line = block.lines[0] if block.lines else (0, [])
        viscosity = {"linear": block.number(line, 0, 0.06), "quadratic": block.number(line, 1, 1.2)}
        self.deck.model.deck.setdefault("elements", {})["bulk_viscosity"] = viscosity
        self.deck.ledger.translated("BULK VISCOSITY", block.place, "elements.bulk_viscosity")

    def output(self, block: Block) -> None:
        interval = block.option("TIME INTERVAL") or block.option("NUMBER INTERVAL")
        value = block.number((block.place.line, [interval]), 0) if interval else 0.0
        if "NUMBER INTERVAL" in block.options:
            value = -value
        if value:
            self.deck.model.deck.setdefault("intervals", {})["fields" if "FIELD" in block.options else "history"] = value
        self.deck.ledger.translated("OUTPUT", block.place, "output")


METHODS: dict[str, Callable[[Reader, Block], None]] = {
    "HEADING": Reader.heading, "PART": Reader.begin_part, "ASSEMBLY": Reader.begin_assembly, "INSTANCE": Reader.begin_instance,
    "END PART": Reader.end, "END ASSEMBLY": Reader.end, "END INSTANCE": Reader.end, "NODE": Reader.nodes, "ELEMENT": Reader.elements,
    "NSET": Reader.sets, "ELSET": Reader.sets, "SURFACE": Reader.surface, "SOLID SECTION": Reader.section, "SHELL SECTION": Reader.section, "BEAM SECTION": Reader.section,
    "NODAL THICKNESS": Reader.nodal_thickness,
    "RIGID BODY": Reader.rigid_body, "COUPLING": Reader.begin_coupling, "KINEMATIC": Reader.kinematic, "MPC": Reader.constraints, "EQUATION": Reader.equations,
    "MASS": Reader.mass, "SPRING": Reader.spring, "DASHPOT": Reader.spring,
    "MATERIAL": Reader.begin_material, "SURFACE INTERACTION": Reader.begin_interaction, "FRICTION": Reader.friction,
    "AMPLITUDE": Reader.amplitude, "STEP": Reader.begin_step, "DYNAMIC": Reader.dynamic, heat.CONDUCTING: Reader.dynamic, "STATIC": Reader.static, "FREQUENCY": Reader.static,
    "BULK VISCOSITY": Reader.viscosity, "OUTPUT": Reader.output,
}  # fmt: skip
ACTIONS: dict[str, Handler] = {
    "FIXED MASS SCALING": read_mass_scaling, "VARIABLE MASS SCALING": read_mass_scaling,
    "BOUNDARY": steps.read_boundary, "INITIAL CONDITIONS": steps.read_initial, "CLOAD": steps.read_node_force,
    "DLOAD": steps.read_distributed, "DSLOAD": steps.read_distributed, "TIE": steps.read_tie, "CONTACT PAIR": steps.read_contact_pair,
    "CONTACT INCLUSIONS": steps.read_inclusions, "CONTACT PROPERTY ASSIGNMENT": steps.read_property,
}  # fmt: skip


def read_abaqus_deck(path: str, ledger: Ledger) -> Model:
    """Reads a deck and what it includes. The ledger tells what became of it."""
    reader = Reader(ledger)
    for block in BlockReader(path, ledger).read():
        reader.take(block)
    deck = reader.deck
    deck.mesh = reader.flat
    place_instances(deck, reader.assembly)
    if deck.instances:
        deck.mesh.place = next(iter(deck.parts.values())).place
    read_assembly_sets(reader)
    if not deck.mesh.elements:
        raise BadInput(path, "the deck has no elements (percuss needs a mesh): include the mesh file")
    if deck.end_time <= 0:
        raise BadInput(path, "there is no step with a time (the run would have no end): add *DYNAMIC, EXPLICIT")
    deck.model.nodes = deck.mesh.nodes
    build_parts(deck)
    choose_integration(deck)
    bodies.build_bodies(deck)
    equations.add_equations(deck)
    apply(reader)
    finish(deck)
    return deck.model


def read_assembly_sets(reader: Reader) -> None:
    """Sets of the assembly name members of instances, by their ids there."""
    deck = reader.deck
    for block in [b for b in reader.waiting if b.keyword in ("NSET", "ELSET")][::-1]:
        sets = deck.mesh.node_sets if block.keyword == "NSET" else deck.mesh.element_sets
        part = next((i for i in deck.instances if i.name == block.option("INSTANCE")), None)
        prefix, shift = (part.name + ".", part.shift) if part else ("", 0)
        words = {text.upper() for line in block.lines for text in line[1]}
        found = {word: [id - shift for id in sets[prefix + word]] for word in words if prefix + word in sets}
        name = block.option(block.keyword)
        found.pop(name, None)
        read_set(deck.mesh, block, found, shift)
        sets.setdefault(name, []).extend(id + shift for id in found.get(name, []))
        deck.ledger.translated(block.keyword, block.place, "a set of the mesh, where something uses it")


def apply(reader: Reader) -> None:
    """What acts on the mesh."""
    for block in reader.waiting:
        if block.keyword in ACTIONS:
            try:
                ACTIONS[block.keyword](reader.deck, block)
            except ArithmeticError as error:
                raise BadInput(block.place, f"the numbers of *{block.keyword} are out of range ({error})") from None


def finish(deck: AbaqusDeck) -> None:
    """The sections that need all keywords."""
    add_masses(deck)
    bodies.finish_bodies(deck)
    add_springs(deck)
    steps.add_velocities(deck)
    heat.apply_temperatures(deck)
    steps.finish_contact(deck)
    intervals = deck.model.deck.pop("intervals", {})
    every = {name: -deck.end_time / value if value < 0 else value for name, value in intervals.items()}
    output: dict = {"history": {"every": max(every.get("history", float(f"{deck.end_time / 1000:.6g}")), deck.end_time / 1e6)}}
    if "fields" in every:
        output["fields"] = {"every": max(every["fields"], deck.end_time / 1e5), "write": ["velocity", "von_mises"]}
    deck.model.deck["output"] = output
    time = {"end": deck.end_time}
    if 0 < deck.step_scale < 1:
        time["step_scale"] = deck.step_scale
    deck.model.deck["time"] = time
