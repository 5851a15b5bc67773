"""An Abaqus deck becomes a model: which keyword is read by what."""

from collections.abc import Callable
from typing import TypeVar

from ..fields import clip
from ..ledger import BadInput, Ledger, Place, Status
from ..model import Model
from ..text_files import suggest, suggest_place
from . import bodies, conditions, contact, equations, general_contact, generators, heat, initial, loads, outputs
from .amplitudes import read_amplitude
from .assembly import read_assembly
from .axisymmetric import hold_rings, turn_rings
from .block_reader import BlockReader
from .cohesive import add_layers
from .damage import finish_failure
from .deck import AbaqusDeck, MaterialBlocks
from .embedded import read_embedded
from .instances import place_instances
from .lines import Block
from .masses import read_mass_scaling
from .mesh import BodyCard, Scope, read_elements, read_instance, read_set, read_surface
from .options import OF_MATERIALS, OTHERS, check_options, complete_keyword, describe_lost, squeeze
from .orientations import read_orientation
from .parts import add_masses, build_parts, choose_integration
from .plane_strain import extrude, hold_layers
from .planes import hold_planes
from .section_cards import read_distribution, read_section, read_transverse_shear
from .springs import add_springs, read_spring
from .surfaces import KINDS, read_profile
from .tables import TABLES, finish_tables
from .timeline import StepTime
from .unused import last_line, note_definitions
from .user_code import apply_states, note_fields

T = TypeVar("T")

Handler = Callable[[AbaqusDeck, Block], None]
ROUGH = 100.0  # coefficient of friction without slip
OF_PRINTING = "output that is printed or kept for a restart, not physics"
IGNORED = {
    **dict.fromkeys(("PREPRINT", "MONITOR", "FILE OUTPUT", "NODE PRINT", "EL PRINT", "ENERGY PRINT", "CONTACT PRINT",
                     "NODE FILE", "EL FILE", "ENERGY FILE", "CONTACT FILE", "DIAGNOSTICS", "FILTER", "TIME POINTS",
                     "FILE FORMAT", "PRINT", "CONSTRAINT CONTROLS", "PREFERENCE", "VALIDATE", "INCREMENTATION OUTPUT"),
                    OF_PRINTING),
    "CONTACT CONTROLS": "numerics of contact: percuss has its own",
    "CONTACT CONTROLS ASSIGNMENT": "numerics of contact: percuss has its own",
    "END STEP": "the end of the step", "SURFACE BEHAVIOR": "contact is hard, and may part",
    "CONTACT FORMULATION": "contact works both ways",
    "CONTACT INITIALIZATION ASSIGNMENT": "overlaps at the start stay without force",
    "CONTACT INITIALIZATION DATA": "overlaps at the start stay without force",
    "DISTRIBUTION TABLE": "units of distributions", "CONSTRAINT": "a name",
    "PHYSICAL CONSTANTS": "constants of radiation and of gases: the laws that are read have none",
}  # fmt: skip


# Where what follows belongs.
FRAMES = {
    "PART": "its mesh and sets, where an instance has it", "ASSEMBLY": "the instances with their sets",
    "END PART": "the end of the part", "END ASSEMBLY": "the end of the assembly",
    "END INSTANCE": "the end of the instance", "STEP": "when what it holds acts",
}  # fmt: skip


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
        self.amplitudes: list[Block] = []
        self.requests: list[outputs.Request] = []
        self.steps: list[Place] = []
        self.unknown: list[tuple[str, Place]] = []

    def take(self, block: Block) -> None:
        complete_keyword(block, KEYWORDS)
        keyword, block.step = block.keyword, len(self.steps)
        self.deck.ledger.expect(clip(keyword), block.place, last_line(block))
        if keyword in FRAMES:
            self.deck.ledger.note(keyword, Status.IGNORED if keyword.startswith("END") else Status.TRANSLATED,
                                  block.place, FRAMES[keyword])
        check_options(block, self.deck.ledger)
        if keyword in OF_MATERIALS and self.material:
            self.material.parts.append(block)
            return
        self.material = self.material if keyword in OF_MATERIALS else None
        self.deck.parameter_tables.is_open &= keyword in TABLES
        method = METHODS.get(keyword)
        if method:
            method(self, block)
        elif keyword in ACTIONS:
            self.waiting.append(block)
        elif keyword in outputs.FOLLOWERS:
            self.request(block)
        elif keyword in IGNORED:
            self.deck.ledger.ignored(keyword, block.place, IGNORED[keyword])
        else:
            self.refuse(block)

    def refuse(self, block: Block) -> None:
        """A keyword that is known and not read, or one that is not known."""
        if block.keyword in OTHERS or block.keyword in OF_MATERIALS:
            is_allowed = self.deck.ledger.refuse(block.keyword, block.place, describe_lost(block.keyword),
                                                 "it is left out")
            self.deck.has_lost_section |= block.keyword.endswith(" SECTION") and not is_allowed
            return
        self.unknown.append((clip(block.keyword), block.place))
        text = f"an unknown keyword{suggest(block.keyword, KEYWORDS.values())}"
        self.deck.ledger.refuse(clip(block.keyword) or "(blank)", block.place, text, "it is left out")

    def heading(self, block: Block) -> None:
        self.deck.model.title = ", ".join(block.lines[0][1]) if block.lines else ""
        self.deck.ledger.translated("HEADING", block.place, "title")

    def claim(self, what: str, block: Block, of_scope: bool = False) -> None:
        """The name of a block, which no other one of its kind has; of_scope: in its part."""
        self.deck.names.claim(what, block.option("NAME"), block.place, id(self.scope) if of_scope else 0)

    def begin_part(self, block: Block) -> None:
        self.claim("parts", block)
        self.scope = self.deck.parts.setdefault(block.option("NAME"), Scope(place=block.place))

    def begin_assembly(self, block: Block) -> None:
        self.scope = self.assembly
        self.assembly.place, self.deck.assembly_name = block.place, block.option("NAME")

    def begin_instance(self, block: Block) -> None:
        self.claim("instances", block)
        self.deck.instances.append(read_instance(block))
        self.scope = self.deck.instances[-1].own

    def end(self, block: Block) -> None:
        self.scope = self.assembly if block.keyword == "END INSTANCE" else self.flat

    def nodes(self, block: Block) -> None:
        generators.read_nodes(self.scope, block)
        self.deck.ledger.translated("NODE", block.place, "nodes of the mesh")

    def generate(self, block: Block) -> None:
        generators.GENERATORS[block.keyword](self.scope, block)
        self.deck.ledger.translated(block.keyword, block.place, "nodes and elements of the mesh")

    def elements(self, block: Block) -> None:
        self.scope.place = self.scope.place or block.place
        if self.scope is self.assembly:
            self.waiting.append(block)  # its nodes may be those of instances
            self.deck.assembly_elements += [block.id(line, 0) for line in block.lines]
        else:
            read_elements(self.scope, block)
        self.deck.ledger.translated(
            f"ELEMENT, TYPE={clip(block.option('TYPE'))}", block.place, "elements of the mesh, where a section has them"
        )

    def sets(self, block: Block) -> None:
        if self.scope is self.assembly:
            self.waiting.append(block)  # instances are not in their places yet
            return
        read_set(self.scope, block, self.scope.node_sets if block.keyword == "NSET" else self.scope.element_sets)
        self.deck.ledger.translated(block.keyword, block.place, "a set of the mesh, where something uses it")

    def transform(self, block: Block) -> None:
        for line in block.lines[:1]:
            if ([block.number(line, i) for i in range(6)] != [1.0, 0.0, 0.0, 0.0, 1.0, 0.0]
                    or block.option("TYPE") not in ("", "R")):
                self.scope.transforms.append((block.option("NSET"), block.place))
                return
        self.deck.ledger.ignored("TRANSFORM", block.place, "its axes are those of space")

    def surface(self, block: Block) -> None:
        self.claim("surfaces", block, of_scope=True)
        if block.option("TYPE") in KINDS:
            read_profile(self.scope, block)
            self.deck.ledger.translated(f"SURFACE.{block.option('TYPE')}", block.place,
                                        "a wall or a rigid part, where a rigid body has it")
            return
        read_surface(self.scope, block, self.deck.ledger)
        self.deck.ledger.translated("SURFACE", block.place, "a side set, where something uses it")

    def section(self, block: Block) -> None:
        read_section(self.scope, block)

    def added_inertia(self, block: Block) -> None:
        """*BEAM ADDED INERTIA of the section before it."""
        if not self.scope.sections or self.scope.sections[-1].kind != "BEAM":
            raise BadInput(block.place, "*BEAM ADDED INERTIA stands behind no section of beams: move it there")
        self.scope.sections[-1].added.append(block)

    def controls(self, block: Block) -> None:
        self.claim("*SECTION CONTROLS", block)
        self.deck.controls[block.option("NAME")] = block

    def distribution(self, block: Block) -> None:
        self.claim("distributions", block, of_scope=True)
        read_distribution(self.scope, block, self.deck.ledger)

    def orientation(self, block: Block) -> None:
        self.claim("orientations", block, of_scope=True)
        read_orientation(self.scope, block)
        self.deck.ledger.translated("ORIENTATION", block.place,
                                    "axes of orthotropic materials and of user code; isotropic ones have none")

    def parameter_table(self, block: Block) -> None:
        TABLES[block.keyword](self.deck, block)

    def nodal_thickness(self, block: Block) -> None:
        for line in block.lines:
            self.scope.thicknesses.append((block.text(line, 0).upper(), block.number(line, 1), block.place))
        self.deck.ledger.translated("NODAL THICKNESS", block.place, "thickness of shells, where a section asks for it")

    def mass(self, block: Block) -> None:
        for line in block.lines[:1]:
            self.scope.masses.append((block.option("ELSET"), block.number(line, 0), block.place))

    def inertia(self, block: Block) -> None:
        for line in block.lines[:1]:
            self.scope.inertias.append((block.option("ELSET"), [block.number(line, i) for i in range(6)], block.place))

    def spring(self, block: Block) -> None:
        read_spring(self.scope, block, self.deck.ledger)

    def rigid_body(self, block: Block) -> None:
        bodies.read_rigid_body(self.scope, block, self.deck.ledger)

    def begin_coupling(self, block: Block) -> None:
        self.coupling = bodies.read_coupling(block)

    def kinematic(self, block: Block) -> None:
        bodies.read_kinematic(self.scope, self.coupling, block, self.deck.ledger)
        self.coupling = None
        self.deck.ledger.translated("KINEMATIC", block.place, "directions of the coupling before it")

    def constraints(self, block: Block) -> None:
        bodies.read_constraints(self.scope, block, self.deck.ledger)

    def equations(self, block: Block) -> None:
        equations.read_equations(self.scope, block, self.deck.ledger)

    def begin_material(self, block: Block) -> None:
        if not block.option("NAME"):
            raise BadInput(block.place, "*MATERIAL has no name: add NAME=")
        self.claim("materials", block)
        self.material = MaterialBlocks(block.place)
        self.deck.materials[block.option("NAME")] = self.material

    def begin_interaction(self, block: Block) -> None:
        self.claim("surface interactions", block)
        self.interaction = block.option("NAME")
        self.deck.frictions[self.interaction] = 0.0
        self.deck.interactions[self.interaction] = [block]

    def friction(self, block: Block) -> None:
        lines = [line for line in block.lines if any(line[1])]
        if not self.interaction:
            raise BadInput(block.place, "*FRICTION stands behind no *SURFACE INTERACTION: correct the order")
        self.deck.names.claim("*FRICTION of surface interaction", self.interaction, block.place)
        if lines:
            self.deck.frictions[self.interaction] = block.number(lines[0], 0)
        if "ROUGH" in block.options:
            self.deck.frictions[self.interaction] = ROUGH
            self.deck.ledger.approximated("FRICTION.ROUGH", block.place,
                                          f"a coefficient of {ROUGH:g}: what touches does not slip")
        if "TAUMAX" in block.options:
            self.deck.ledger.refuse("FRICTION.TAUMAX", block.place,
                                    "a largest shear stress of friction", "friction has no limit")
        if "EXPONENTIAL DECAY" in block.options:
            self.deck.ledger.refuse("FRICTION.EXPONENTIAL DECAY", block.place, "friction that falls with the speed",
                                    "the static coefficient is used")
        elif len(lines) > 1 or lines and any(lines[0][1][1:]):
            self.deck.ledger.refuse("FRICTION.table", block.place,
                                    "friction that depends on speed, pressure or temperature",
                                    "the first coefficient is used")
        self.deck.interactions[self.interaction].append(block)

    def glue(self, block: Block) -> None:
        """Glue of the surface interaction before it."""
        if self.interaction:
            self.deck.glues.setdefault(self.interaction.upper(), []).append(block)
            self.deck.interactions[self.interaction].append(block)
        else:
            self.refuse(block)

    def amplitude(self, block: Block) -> None:
        if not block.option("NAME"):
            raise BadInput(block.place, "*AMPLITUDE has no name: add NAME=")
        self.claim("amplitudes", block)
        self.amplitudes.append(block)

    def begin_step(self, block: Block) -> None:
        self.steps.append(block.place)
        if block.option("NLGEOM") == "NO":
            self.deck.ledger.approximated("STEP.NLGEOM", block.place,
                                          "displacements may be large, whatever NLGEOM says")

    def dynamic(self, block: Block) -> None:
        if "EXPLICIT" not in block.options:
            self.deck.ledger.refuse("DYNAMIC", block.place, "an implicit step", "the run is explicit")
        if "SCALE FACTOR" in block.options:
            self.deck.step_scale = block.number((block.place.line, [block.options["SCALE FACTOR"]]), 0, 1.0)
        heat.read_procedure(self.deck, block)
        self.add_time(block, max((block.number(line, 1) for line in block.lines[:1]), default=0.0))
        self.deck.ledger.translated(block.keyword, block.place, "time.end")

    def restart(self, block: Block) -> None:
        if "READ" in block.options:
            raise BadInput(block.place, "*RESTART, READ goes on from the results of another job, "
                                        "which percuss does not read: add these steps to the deck of that job")
        self.deck.ledger.ignored("RESTART", block.place, OF_PRINTING)

    def static(self, block: Block) -> None:
        self.deck.ledger.refuse(
            block.keyword, block.place, "a step that is not explicit dynamics", "the run is explicit, with its time"
        )
        self.add_time(block, max((block.number(line, 1, 1.0) for line in block.lines[:1]), default=1.0))

    def add_time(self, block: Block, length: float) -> None:
        """The step follows those before."""
        steps = self.deck.steps
        if not self.steps or len(steps) == len(self.steps):
            raise BadInput(block.place,
                           f"*{block.keyword} stands outside of a *STEP, or is the second of one: correct it")
        if length <= 0:
            raise BadInput(block.place, f"the step has no time (the second number behind *{block.keyword}): add it")
        steps.append(StepTime(block.place, self.deck.end_time, length))

    def viscosity(self, block: Block) -> None:
        line = block.lines[0] if block.lines else (0, [])
        viscosity = {"linear": block.number(line, 0, 0.06), "quadratic": block.number(line, 1, 1.2)}
        before = self.deck.model.deck.setdefault("elements", {}).setdefault("bulk_viscosity", viscosity)
        if before != viscosity:
            self.deck.ledger.refuse("BULK VISCOSITY.step", block.place, "bulk viscosity that changes from step to step",
                                    "that of the first is used")
        self.deck.ledger.translated("BULK VISCOSITY", block.place, "elements.bulk_viscosity")

    def output(self, block: Block) -> None:
        if not {"FIELD", "HISTORY"} & block.options.keys():
            self.deck.ledger.ignored("OUTPUT", block.place, OF_PRINTING)
        self.requests.append(outputs.Request(block))

    def request(self, block: Block) -> None:
        """A keyword that follows *OUTPUT."""
        if self.requests:
            self.requests[-1].followers.append(block)
        else:
            self.deck.ledger.ignored(block.keyword, block.place, "it stands behind no *OUTPUT")


METHODS: dict[str, Callable[[Reader, Block], None]] = {
    "HEADING": Reader.heading, "PART": Reader.begin_part, "ASSEMBLY": Reader.begin_assembly,
    "INSTANCE": Reader.begin_instance, "END PART": Reader.end, "END ASSEMBLY": Reader.end, "END INSTANCE": Reader.end,
    "NODE": Reader.nodes, "ELEMENT": Reader.elements, **dict.fromkeys(generators.GENERATORS, Reader.generate),
    "TRANSFORM": Reader.transform, "NSET": Reader.sets, "ELSET": Reader.sets, "SURFACE": Reader.surface,
    "SOLID SECTION": Reader.section, "SHELL SECTION": Reader.section, "BEAM SECTION": Reader.section,
    "BEAM GENERAL SECTION": Reader.section, "BEAM ADDED INERTIA": Reader.added_inertia,
    "MEMBRANE SECTION": Reader.section, "COHESIVE SECTION": Reader.section, "SECTION CONTROLS": Reader.controls,
    "DISTRIBUTION": Reader.distribution, "NODAL THICKNESS": Reader.nodal_thickness, "ORIENTATION": Reader.orientation,
    **dict.fromkeys(TABLES, Reader.parameter_table), "RIGID BODY": Reader.rigid_body, "COUPLING": Reader.begin_coupling,
    "KINEMATIC": Reader.kinematic, "MPC": Reader.constraints, "EQUATION": Reader.equations, "MASS": Reader.mass,
    "ROTARY INERTIA": Reader.inertia, "SPRING": Reader.spring, "DASHPOT": Reader.spring,
    "MATERIAL": Reader.begin_material, "SURFACE INTERACTION": Reader.begin_interaction, "FRICTION": Reader.friction,
    **dict.fromkeys(("COHESIVE BEHAVIOR", "DAMAGE INITIATION", "DAMAGE EVOLUTION"), Reader.glue),
    "AMPLITUDE": Reader.amplitude, "STEP": Reader.begin_step, "DYNAMIC": Reader.dynamic,
    heat.CONDUCTING: Reader.dynamic, "STATIC": Reader.static, "FREQUENCY": Reader.static, "RESTART": Reader.restart,
    "BULK VISCOSITY": Reader.viscosity, "OUTPUT": Reader.output,
}  # fmt: skip
ACTIONS: dict[str, Handler] = {
    "FIXED MASS SCALING": read_mass_scaling, "VARIABLE MASS SCALING": read_mass_scaling,
    "TRANSVERSE SHEAR": read_transverse_shear, "TRANSVERSE SHEAR STIFFNESS": read_transverse_shear,
    "INITIAL CONDITIONS": initial.read_initial, "BOUNDARY": conditions.read_boundary, "CLOAD": loads.read_node_force,
    "DLOAD": loads.read_distributed, "DSLOAD": loads.read_distributed, "TIE": contact.read_tie,
    "EMBEDDED ELEMENT": read_embedded, "CONTACT PAIR": contact.read_contact_pair,
    "CONTACT": general_contact.read_start, "CONTACT INCLUSIONS": general_contact.read_inclusions,
    "CONTACT EXCLUSIONS": general_contact.read_exclusions, "CONTACT PROPERTY ASSIGNMENT": general_contact.read_property,
    "SURFACE PROPERTY ASSIGNMENT": contact.read_surface_property,
}  # fmt: skip
KEYWORDS = {
    squeeze(word): word
    for word in (*METHODS, *ACTIONS, *IGNORED, *outputs.FOLLOWERS, *OF_MATERIALS, *OTHERS, "INCLUDE", "PARAMETER")
}


def read_abaqus_deck(path: str, ledger: Ledger) -> Model:
    """Reads a deck and what it includes. The ledger gets what became of it."""
    reader = Reader(ledger)
    for block in BlockReader(path, ledger).read():
        guard(ledger, block, reader.take)
    ledger.stop_at_faults()
    deck = reader.deck
    deck.mesh, deck.assembly = reader.flat, reader.assembly
    place_instances(deck, reader.assembly)
    if deck.instances:
        deck.mesh.place = next(iter(deck.parts.values())).place
    read_assembly(deck, reader.waiting)
    if not deck.mesh.elements:
        raise BadInput(clip(path, 200), "the deck has no elements (percuss needs a mesh): include the mesh file")
    if deck.end_time <= 0:
        hint = suggest_place("DYNAMIC", reader.unknown)
        raise BadInput(clip(path, 200),
                       f"there is no step with a time (the run would have no end): {hint or 'add *DYNAMIC, EXPLICIT'}")
    extrude(deck)
    turn_rings(deck)
    deck.model.nodes = deck.mesh.nodes
    heat.note_temperatures(deck, reader.waiting)
    note_fields(deck, reader.waiting)
    build_parts(deck)
    choose_integration(deck)
    finish_failure(deck)
    bodies.build_bodies(deck)
    equations.add_equations(deck)
    kinds = {section.place: section.keyword for section in deck.mesh.sections}
    for part in deck.model.blocks:
        origin = kinds.get(part.place, "ELEMENT"), part.place
        deck.model.origins.cards["parts", part.name] = origin
        deck.model.origins.cards["materials", part.keys["material"]] = origin
    deck.model.origins.note(deck.model, "RIGID BODY", None)
    apply(reader)
    finish(reader)
    note_definitions(deck)
    ledger.note_silent()
    return deck.model


def apply(reader: Reader) -> None:
    """What acts on the mesh."""
    deck = reader.deck
    deck.motions.end = deck.loads.end = deck.end_time
    for block in reader.amplitudes:
        guard(deck.ledger, block, lambda block: add_amplitude(deck, block))
    deck.ledger.stop_at_faults()
    acting = [block for block in reader.waiting if block.keyword in ACTIONS]
    # velocities come before what changes them
    for block in sorted(acting, key=lambda block: block.keyword != "INITIAL CONDITIONS"):
        guard(deck.ledger, block, lambda block: ACTIONS[block.keyword](deck, block))
        deck.model.origins.note(deck.model, block.keyword, block.place)
    deck.ledger.stop_at_faults()


def add_amplitude(deck: AbaqusDeck, block: Block) -> None:
    deck.amplitudes[block.option("NAME")] = read_amplitude(block, deck.end_time)
    deck.ledger.translated("AMPLITUDE", block.place, "a table where something uses it")


def guard(ledger: Ledger, block: Block, act: Callable[[Block], None]) -> None:
    """Reads a block. Where it cannot be read the others still are, so that all faults come at once."""
    try:
        act(block)
    except ArithmeticError as error:
        ledger.note_fault(BadInput(block.place, f"the numbers of *{block.keyword} are out of range ({error})"))
    except BadInput as error:
        ledger.note_fault(error)


def finish(reader: Reader) -> None:
    """The sections that need all keywords."""
    deck = reader.deck
    for function, keyword in (
        (add_masses, "MASS"), (conditions.finish_conditions, "BOUNDARY"), (bodies.finish_bodies, "RIGID BODY"),
        (loads.finish_loads, "CLOAD"),
        (add_springs, "SPRING"), (initial.add_velocities, "INITIAL CONDITIONS"), (apply_states, "INITIAL CONDITIONS"),
        (finish_tables, "TABLE COLLECTION"),
        (heat.apply_temperatures, "INITIAL CONDITIONS"),
        (heat.check_conduction, heat.CONDUCTING),
        (hold_planes, "SOLID SECTION"), (hold_layers, "SOLID SECTION"), (hold_rings, "SOLID SECTION"),
        (add_layers, "COHESIVE SECTION"), (general_contact.finish_contact, "CONTACT"),
    ):  # fmt: skip
        function(deck)
        deck.model.origins.note(deck.model, keyword, None)
    outputs.add_outputs(deck, reader.requests)
    time = {"end": deck.end_time}
    if 0 < deck.step_scale < 1:
        time["step_scale"] = deck.step_scale
    deck.model.deck["time"] = time
