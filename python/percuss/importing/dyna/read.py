"""A keyword deck becomes a model: which card is read by what, and in which order."""

from collections.abc import Callable
from dataclasses import dataclass, field

from ..fields import clip
from ..ledger import BadInput, Ledger, Place, missing
from ..model import Block, Model
from ..text_files import suggest, suggest_place
from . import condition_cards as conditions
from . import motion_cards as motions
from . import rigid_cards as rigid
from . import start_cards as start
from .beam_cards import read_beams, read_rules
from .body_holds import apply_body_holds
from .card_reader import CardReader
from .cards import Card
from .composite_cards import read_composite
from .constraint_cards import add_node_sets, read_node_sets
from .contact_cards import finish_contacts, read_contact, read_defaults
from .control_cards import (  # fmt: skip
    apply_relaxation,
    apply_timestep,
    apply_viscosity,
    check_shells,
    is_known_control,
    read_general_hourglass,
    read_other_control,
    read_rigid_control,
    read_shell_control,
    read_solid_control,
    read_solution,
    read_termination,
)
from .curve_cards import check_relaxation, read_curve, read_other_curve, read_smooth_curve, read_table
from .damping_cards import read_damping
from .database_names import KEYWORDS as DATABASES
from .deck import Handler, KeywordDeck
from .element_settings import read_hourglass, translate_hourglass, translate_integration, translate_shell_hourglass
from .embedded_cards import read_bars_in_solids, read_beams_in_solids
from .forms import OPTIONS, find_form, list_keywords
from .joint_cards import add_joints, add_nodal_bodies, read_joints, read_nodal_body
from .load_cards import (
    apply_part_gravity,
    read_blast,
    read_blast_segments,
    read_body_force,
    read_body_load,
    read_node_load,
    read_part_gravity,
    read_segment_load,
)
from .mass_cards import add_masses_of_sets, read_masses
from .materials.choice import build_materials, note_unused, read_material, read_state
from .materials.skins import add_skin_masses
from .merge_cards import merge_nodes, read_merge_tolerance, read_merged_sets
from .mesh_cards import (
    OTHERS,
    apply_node_transforms,
    read_node_transform,
    read_nodes,
    read_other_elements,
    read_shells,
    read_solids,
    read_thick_shells,
)
from .output_cards import ASCII, finish_output, finish_sensors, read_accelerometers, read_database, read_sensor
from .part_cards import build_blocks, read_parts, read_section
from .preload_cards import add_preloads, read_axial_force, read_plane, read_section_stress
from .set_cards import read_box, read_set, read_system, read_vector, resolve_segments
from .spring_cards import add_springs, note_spring_materials, read_springs
from .starting import balance_bodies
from .stress_cards import read_stresses
from .termination_cards import read_body_limit, read_node_limit, read_other_end, read_sensor_end
from .turn_spring_cards import add_turn_springs, read_turn_springs
from .unused import note_definitions
from .wall_cards import read_wall
from .weld_cards import add_welds, read_welds


def read_title(deck: KeywordDeck, card: Card) -> None:
    deck.model.title = " ".join(text.strip() for _, text in card.lines[:1])
    deck.ledger.translated("TITLE", card.place, "title")


def read_detonation(deck: KeywordDeck, card: Card) -> None:
    reader = card.reader()
    while reader.skip_blank():
        row = reader.row("PID X Y Z LT MMGSET")
        part, point = row.integer("PID"), tuple(row.numbers("X", "Y", "Z"))
        if part < 0:
            deck.ledger.refuse("INITIAL_DETONATION.PID", row.place,
                               f"PID is {part}, a boundary of acoustic elements", "it is left out")
            continue
        row.finish(deck.ledger, "it detonates at time 0")
        deck.detonations.append((part, point, row.place))  # type: ignore[arg-type]
        deck.ledger.translated(card.keyword, row.place, "a point of detonation, where the law of a part has one")


# Read at once. forms.py has what may follow a name.
DEFINITIONS: dict[str, Handler] = {
    "TITLE": read_title, "NODE": read_nodes, "NODE_TRANSFORM": read_node_transform, "NODE_MERGE_SET": read_merged_sets,
    "NODE_MERGE_TOLERANCE": read_merge_tolerance, "ELEMENT_SOLID": read_solids, "ELEMENT_TSHELL": read_thick_shells,
    "ELEMENT_SHELL": read_shells, "ELEMENT_MASS": read_masses, "ELEMENT_DISCRETE": read_springs,
    "ELEMENT_BEAM": read_beams, "INTEGRATION_BEAM": read_rules, "ELEMENT_SEATBELT_ACCELEROMETER": read_accelerometers,
    "ELEMENT_": read_other_elements, "PART": read_parts, "PART_COMPOSITE": read_composite, "SECTION_": read_section,
    "HOURGLASS": read_hourglass, "MAT_": read_material, "EOS_": read_state,
    **{name: read_set for name in OPTIONS if name.startswith("SET_")}, "DEFINE_CURVE": read_curve,
    "DEFINE_CURVE_SMOOTH": read_smooth_curve, "DEFINE_CURVE_": read_other_curve, "DEFINE_FUNCTION": read_other_curve,
    "DEFINE_TABLE": read_table, "DEFINE_BOX": read_box, "DEFINE_COORDINATE_": read_system, "DEFINE_VECTOR": read_vector,
    "CONTROL_TERMINATION": read_termination, "CONTROL_CONTACT": read_defaults, "CONTROL_SHELL": read_shell_control,
    "CONTROL_SOLID": read_solid_control, "CONTROL_RIGID": read_rigid_control, "CONTROL_SOLUTION": read_solution,
    "CONTROL_HOURGLASS": read_general_hourglass, "BOUNDARY_PRESCRIBED_MOTION_RIGID": rigid.read_rigid_motion,
    "DEFORMABLE_TO_RIGID": rigid.read_switched, "CONSTRAINED_EXTRA_NODES_": rigid.read_extra_nodes,
    "CONSTRAINED_RIGID_BODIES": rigid.read_merged, "CONSTRAINED_NODAL_RIGID_BODY": read_nodal_body,
    "CONSTRAINED_JOINT_": read_joints, "CONSTRAINED_JOINT_STIFFNESS_GENERALIZED": read_turn_springs,
    "CONSTRAINED_NODE_SET": read_node_sets, "CONSTRAINED_LINEAR": read_node_sets,
    "CONSTRAINED_LINEAR_GLOBAL": read_node_sets, "CONSTRAINED_SPOTWELD": read_welds, "CONSTRAINED_RIVET": read_welds,
    "CONSTRAINED_GENERALIZED_WELD": read_welds, "INITIAL_DETONATION": read_detonation, "SENSOR_": read_sensor,
    "INITIAL_AXIAL_FORCE_BEAM": read_axial_force, "DATABASE_CROSS_SECTION_PLANE": read_plane,
}  # fmt: skip
# Applied in this order, once all definitions and the parts are known.
ACTIONS: dict[str, Handler] = {
    "CONTROL_TIMESTEP": apply_timestep, "CONTROL_BULK_VISCOSITY": apply_viscosity, "CONTROL_CHECK_SHELL": check_shells,
    "CONTROL_DYNAMIC_RELAXATION": apply_relaxation, "CONTROL_DAMPING": apply_relaxation, "CONTROL_": read_other_control,
    "CONSTRAINED_BEAM_IN_SOLID": read_beams_in_solids, "CONSTRAINED_LAGRANGE_IN_SOLID": read_bars_in_solids,
    "CONSTRAINED_GLOBAL": conditions.read_plane, "BOUNDARY_SPC": conditions.read_spc,
    "BOUNDARY_SPC_SYMMETRY_PLANE": conditions.read_symmetry_plane, "INITIAL_VELOCITY": start.read_initial_velocity,
    "INITIAL_VELOCITY_GENERATION": start.read_generation, "INITIAL_VELOCITY_RIGID_BODY": start.read_rigid_velocity,
    "INITIAL_VELOCITY_NODE": start.read_node_velocities, "BOUNDARY_PRESCRIBED_MOTION": motions.read_motion,
    "INITIAL_STRESS_": read_stresses, "INITIAL_STRESS_SECTION": read_section_stress, "INITIAL_TEMPERATURE_":
    start.read_temperature, "LOAD_BLAST": read_blast, "LOAD_BODY_": read_body_load, "LOAD_NODE_": read_node_load,
    "LOAD_SEGMENT": read_segment_load, "LOAD_SHELL_": read_segment_load, "LOAD_GRAVITY_PART": read_part_gravity,
    "LOAD_BLAST_SEGMENT": read_blast_segments, "LOAD_RIGID_BODY": read_body_force, "DAMPING_": read_damping,
    "RIGIDWALL_": read_wall, "CONTACT_": read_contact, "DATABASE_": read_database, "TERMINATION_NODE": read_node_limit,
    "TERMINATION_BODY": read_body_limit, "TERMINATION_SENSOR": read_sensor_end, "TERMINATION_": read_other_end,
}  # fmt: skip
# Cards of which the last one counts, as in LS-DYNA.
# They wait for it: DEFINITIONS of them are read behind all others.
OF_LAST = (
    "CONTROL_TERMINATION", "CONTROL_CONTACT", "CONTROL_SHELL", "CONTROL_SOLID", "CONTROL_RIGID", "CONTROL_SOLUTION",
    "CONTROL_HOURGLASS", "CONTROL_TIMESTEP", "CONTROL_BULK_VISCOSITY", "CONTROL_DYNAMIC_RELAXATION", "CONTROL_DAMPING",
    "DATABASE_BINARY_D3PLOT", *(f"DATABASE_{name}" for name in ASCII),
)  # fmt: skip
# names of one card
SAME_CARD = {"CONTROL_DAMPING": "CONTROL_DYNAMIC_RELAXATION", "CONTROL_HOURGLASS_936": "CONTROL_HOURGLASS"}
OTHER_ELEMENTS = tuple(f"ELEMENT_{kind}" for kind in OTHERS)
# Harmless whatever they say.
LISTENED = "what refers to it is refused by its own name"
IGNORED = {
    "COMMENT": "a comment", "CONTROL_STRUCTURED": "output", "CONTROL_STRUCTURED_TERM": "output",
    "CONTROL_NONLOCAL": "storage", "INTERFACE_COMPONENT_FILE": "output", "INTERFACE_COMPONENT_NODE": "output",
    "INTERFACE_COMPONENT_SEGMENT": "output", "INTERFACE_SPRINGBACK_LSDYNA": "output at the end of the run",
    "INTERFACE_SPRINGBACK_NASTRAN": "output at the end of the run", "INTERFACE_SPRINGBACK_NIKE3D":
    "output at the end of the run", "INTERFACE_SPRINGBACK_EXCLUDE": "output at the end of the run",
    "DEFINE_PLANE": LISTENED, "DEFINE_REGION": LISTENED, "DEFINE_SD_ORIENTATION": LISTENED, "DEFINE_FRICTION": LISTENED,
    "DEFINE_STOCHASTIC_VARIATION": LISTENED, "DEFINE_FILTER": LISTENED, "DEFINE_CONNECTION_PROPERTIES": LISTENED,
    "DEFINE_SPOTWELD_FAILURE": LISTENED, "DEFINE_SPOTWELD_RUPTURE_STRESS": LISTENED, "DEFINE_CONTACT_VOLUME": LISTENED,
    "DEFINE_GROUND_MOTION": LISTENED, "RIGIDWALL_FORCE_TRANSDUCER": "output; percuss writes the force of each wall",
    **{f"INITIAL_STRAIN_{kind}": "strains of an earlier stage, which are written and change no stress"
       for kind in ("SHELL", "SHELL_SET", "SOLID", "SOLID_SET", "TSHELL")},
}  # fmt: skip
# Cards that modify a material: left out, they leave nothing. They are refused by their own names,
# and not as another material.
MODIFIERS = ("MAT_ADD_", "MAT_NONLOCAL")
MODIFIERS_READ = ("MAT_ADD_EROSION", "MAT_ADD_DAMAGE_GISSMO", "MAT_ADD_DAMAGE_DIEM")  # when more is known


def find_handler(table: dict[str, Handler], keyword: str) -> str | None:
    """The name in a table of which the keyword is a form."""
    return find_form(table, keyword)[0]


@dataclass
class Waiting:
    """Cards that are read when all definitions are known."""

    actions: list[tuple[int, Card, Handler]] = field(default_factory=list)
    last: dict[str, Card] = field(default_factory=dict)  # of OF_LAST, by the keyword

    def keep_last(self, deck: KeywordDeck, card: Card) -> None:
        keyword = SAME_CARD.get(card.keyword, card.keyword)
        if keyword in self.last:
            first = self.last.pop(keyword)
            deck.ledger.ignored(first.keyword, first.place,
                                f"of several of these cards the last one counts, which is at {card.place}")
        self.last[keyword] = card

    def take_last(self, deck: KeywordDeck) -> None:
        """Reads the definitions among them; actions wait on."""
        for card in self.last.values():
            name = find_handler(DEFINITIONS | ACTIONS, card.keyword) or ""
            if name in DEFINITIONS:
                apply(deck, card, DEFINITIONS[name])
            else:
                self.add(name, card)

    def add(self, name: str, card: Card) -> None:
        self.actions.append((list(ACTIONS).index(name), card, ACTIONS[name]))


def is_unknown(name: str | None, keyword: str) -> bool:
    """Whether a keyword begins as known ones do, and is none of them."""
    known = {"CONTROL_": is_known_control, "ELEMENT_": lambda word: word.startswith(OTHER_ELEMENTS),
             "DATABASE_": DATABASES.__contains__}
    return name in known and not known[name](keyword)


def sort_card(deck: KeywordDeck, card: Card, waiting: Waiting) -> None:
    """Reads a definition, keeps an action for later, refuses what is not known."""
    keyword = card.keyword
    name, option = find_form([*DEFINITIONS, *ACTIONS], keyword)
    if keyword in IGNORED:
        deck.ledger.ignored(keyword, card.place, IGNORED[keyword])
    elif "PGP" in keyword or keyword.startswith("--"):
        raise BadInput(card.place, "an encrypted block cannot be read: ask its author for the plain text")
    elif keyword.startswith(MODIFIERS) and keyword not in MODIFIERS_READ:
        deck.ledger.refuse(keyword, card.place, "what it adds to a material", "the material is as it is without it")
    elif is_unknown(name, keyword):
        refuse_unknown(deck, card)
    elif SAME_CARD.get(keyword, keyword) in OF_LAST:
        waiting.keep_last(deck, card)
    elif name in DEFINITIONS:
        apply(deck, card, DEFINITIONS[name])
    elif name:
        waiting.add(name, card)
    elif option:
        deck.unknown.append((keyword, card.place))
        text = f"the option {clip(option)}, with which the card means something else{suggest(keyword, list_keywords())}"
        deck.ledger.refuse(keyword, card.place, text, "the card is left out")
    else:
        refuse_unknown(deck, card)


def refuse_unknown(deck: KeywordDeck, card: Card) -> None:
    """A card that is not known, or misspelt."""
    deck.unknown.append((card.keyword, card.place))
    deck.ledger.refuse(card.keyword or "(blank)", card.place,
                       f"an unknown card{suggest(card.keyword, [*list_keywords(), *sorted(DATABASES)])}",
                       "it is left out")


def apply(deck: KeywordDeck, card: Card, handler: Handler) -> None:
    """Numbers that are finite alone may have no finite quotient or power."""
    try:
        handler(deck, card)
    except ArithmeticError as error:
        deck.ledger.note_fault(BadInput(card.place, f"the numbers of *{card.keyword} are out of range ({error})"))
        return
    except BadInput as error:
        deck.ledger.note_fault(error)
        return
    surplus = card.find_surplus() if card.keyword not in MODIFIERS_READ else 0
    if surplus and not deck.ledger.refuses_in(card.place, surplus):
        deck.ledger.refuse(f"{card.keyword}.lines", card.at(surplus),
                           "a line that the card does not have", "it is left out")
    deck.model.origins.note(deck.model, card.keyword, card.place)


def read_keyword_deck(path: str, ledger: Ledger) -> Model:
    """Reads a deck and what it includes. The ledger gets what became of it."""
    deck = KeywordDeck(ledger)
    waiting = Waiting()
    reader = CardReader(path, ledger, deck.nodes)
    deck.transformations = reader.transformations
    for card in reader.read():
        sort_card(deck, card, waiting)
    waiting.take_last(deck)
    ledger.stop_at_faults()
    if not deck.elements:
        raise BadInput(path, "the deck has no elements that percuss reads: "
                             f"{find_misspelt(deck, 'ELEMENT_SOLID', 'ELEMENT_SHELL') or 'include the mesh file'}",
                       follows=True)
    if deck.end_time <= 0:
        raise BadInput(path, "there is no *CONTROL_TERMINATION with a time (the run would have no end): "
                             f"{find_misspelt(deck, 'CONTROL_TERMINATION') or 'add one'}")
    try:
        build(deck)
    except ArithmeticError as error:
        raise BadInput(path, f"the numbers of a part, its section or its material are out of range ({error})") from None
    ledger.lost_parts = not {id for id, found in deck.elements.items() if found.solids or found.shells or found.beams
                             or found.others} <= {b.part for b in deck.model.blocks}
    for _, card, handler in sorted(waiting.actions, key=lambda item: item[0]):
        apply(deck, card, handler)
    ledger.stop_at_faults()
    finish(deck)
    note_definitions(deck)
    ledger.note_silent()
    return deck.model


def find_misspelt(deck: KeywordDeck, *keywords: str) -> str:
    """The unknown keyword that may be meant by one that is missing."""
    return next((text for keyword in keywords if (text := suggest_place(keyword, deck.unknown))), "")


def build(deck: KeywordDeck) -> None:
    """Parts with their materials."""
    check_corners(deck)
    apply_node_transforms(deck)
    merge_nodes(deck)
    resolve_segments(deck)
    build_blocks(deck)
    note_spring_materials(deck)
    build_materials(deck)
    rigid.mark_rigid_parts(deck)
    translate_integration(deck)
    translate_hourglass(deck, deck.general_hourglass)
    translate_shell_hourglass(deck, deck.general_hourglass)
    for block in deck.model.blocks:
        deck.model.origins.cards["parts", block.name] = ("PART", block.place)
        deck.model.origins.cards["materials", block.keys["material"]] = material_card(deck, block)
    deck.model.origins.note(deck.model, "PART", None)
    add_nodal_bodies(deck)
    deck.model.origins.note(deck.model, "CONSTRAINED_NODAL_RIGID_BODY", None)
    rigid.find_all_bodies(deck)
    conditions.apply_fixed_nodes(deck)
    deck.model.origins.note(deck.model, "NODE", deck.fixed_place)


def material_card(deck: KeywordDeck, block: Block) -> tuple[str, Place]:
    card = deck.materials[deck.parts[block.part].material]
    return card.keyword, card.place


def check_corners(deck: KeywordDeck) -> None:
    """Every corner is a node, and every element has an id of its own."""
    for what, lines in deck.element_lines.items():
        lines.refuse_repeated(what)
    for elements in deck.elements.values():
        shells = ((shell.id, shell.corners) for shell in elements.shells)
        for id, corners in [*elements.solids, *shells, *((beam.id, beam.ends) for beam in elements.beams)]:
            for node in corners:
                if node not in deck.nodes:
                    raise BadInput(elements.place, missing(f"node {node}, of element {id}"))


def finish(deck: KeywordDeck) -> None:
    """What needs all cards."""
    place = next(iter(deck.parts.values())).place
    for function, card in LAST:
        try:
            function(deck)
        except ArithmeticError as error:
            raise BadInput(place, f"the numbers of *{card} are out of range ({error})") from None
        deck.model.origins.note(deck.model, card, None)


def keep_sets(deck: KeywordDeck) -> None:
    """Sets that nothing uses are written too, so that a user finds them by name."""
    for (kind, id), card in deck.sets.items():
        if (kind, id) in deck.used or kind not in ("NODE", "PART"):
            continue
        if kind == "NODE":
            used = deck.used_nodes()
            members = [node for node in deck.list_members(kind, id, card.place) if node in used]
            if members:
                deck.model.add_node_set(card.title or f"nodes_{id}", members)
        else:
            deck.part_set_name(id, card.place)


# What needs all cards, with the cards that it is of.
LAST: tuple[tuple[Callable[[KeywordDeck], None], str], ...] = (
    (add_preloads, "INITIAL_"), (apply_part_gravity, "LOAD_GRAVITY_PART"),
    (rigid.apply_rigid_motions, "BOUNDARY_PRESCRIBED_MOTION_RIGID"),
    (rigid.apply_extra_nodes, "CONSTRAINED_EXTRA_NODES"),
    (balance_bodies, "INITIAL_VELOCITY"), (apply_body_holds, "BOUNDARY_"),
    (add_joints, "CONSTRAINED_JOINT"), (add_turn_springs, "CONSTRAINED_JOINT_STIFFNESS_GENERALIZED"),
    (start.add_masses, "ELEMENT_MASS"), (add_skin_masses, "MAT_NULL"), (add_masses_of_sets, "ELEMENT_MASS"),
    (add_springs, "ELEMENT_DISCRETE"), (add_welds, "CONSTRAINED_"), (add_node_sets, "CONSTRAINED_"),
    (finish_contacts, "CONTACT_"), (finish_output, "DATABASE_"), (finish_sensors, "SENSOR_"),
    (check_relaxation, "DEFINE_CURVE"),
    (keep_sets, "SET_"), (note_unused, "DEFINE_CURVE"),
)  # fmt: skip
