"""*USER MATERIAL, *PLASTIC, HARDENING=USER and *USER DEFINED FIELD: code of the user (VUMAT, VUHARD, VUSDFLD),
in a library that the command line names."""

from ..fields import clip, parse_integer
from ..ledger import BadInput
from ..model import Deck
from .deck import AbaqusDeck, MaterialBlocks
from .lines import Block

MOST_CONSTANTS, MOST_STATES, MOST_LENGTHS, MOST_FIELDS = 200, 1000, 12, 16
LAWS = ("user", "user_hardening")
LEFT_OUT = "the parts made of it are left out"


def translate_user_code(deck: AbaqusDeck, name: str, user: Block, states: Block | None) -> Deck | None:
    """The law of a compiled VUMAT. states: *DEPVAR, if there is one."""
    ledger = deck.ledger
    if not ledger.user_code:
        text = (f"material {clip(name)} is user code (no library has it): "
                "compile the VUMAT (docs/user_laws.md) and add --allow-library FILE")
        ledger.refuse("USER MATERIAL", user.place, text, LEFT_OUT)
        return None
    if user.option("TYPE") not in ("", "MECHANICAL"):
        ledger.refuse("USER MATERIAL.TYPE", user.place, f"user code of the type {clip(user.option('TYPE'))}",
                      "it is taken as mechanical")
    law: Deck = {"model": "user", "vumat": ledger.user_code, "vumat_name": name.upper()}
    return law if add_arrays(deck, name, law, user, states) else None


def add_lengths(deck: AbaqusDeck, law: Deck, block: Block) -> None:
    """*CHARACTERISTIC LENGTH of user code: those of VUCHARLENGTH, or that of the volume, which is percuss' own."""
    if block.option("DEFINITION") not in ("", "GEOMETRIC MEAN", "USER"):
        raise BadInput(block.place, f"DEFINITION={clip(block.option('DEFINITION'))} of *{block.keyword} is neither "
                                    "GEOMETRIC MEAN nor USER: correct it")
    if block.option("DEFINITION") != "USER":
        deck.ledger.translated(block.keyword, block.place, "the length that user code gets anyway")
        return
    count = parse_integer(block.option("COMPONENTS") or "1")
    if count is None or count < 1:
        raise BadInput(block.place, f"COMPONENTS={clip(block.option('COMPONENTS'))} of *{block.keyword} is not a "
                                    "positive number: correct it")
    if count > MOST_LENGTHS:
        deck.ledger.refuse("CHARACTERISTIC LENGTH.COMPONENTS", block.place,
                           f"{count} characteristic lengths (at most {MOST_LENGTHS})", f"there are {MOST_LENGTHS}")
    law["characteristic_lengths"] = min(count, MOST_LENGTHS)
    constants = read_constants(block)
    if constants:
        law["length_constants"] = constants
    deck.ledger.approximated(block.keyword, block.place, "VUCHARLENGTH of the library is called once, at the start")


def note_fields(deck: AbaqusDeck, blocks: list[Block]) -> None:
    """How many fields there are, before the materials are made: the largest number of one that is given."""
    for block in blocks:
        if block.keyword == "INITIAL CONDITIONS" and block.option("TYPE") == "FIELD":
            deck.field_count = max(deck.field_count, parse_integer(block.option("VARIABLE") or "1") or 1)


def add_fields(deck: AbaqusDeck, law: Deck, block: Block) -> None:
    """*USER DEFINED FIELD beside user code: VUSDFLD of the same library."""
    constants, wanted = read_constants(block), parse_integer(block.option("PROPERTIES") or "0")
    if wanted is None or not 0 <= wanted - len(constants) <= 8:
        raise BadInput(block.place, f"*{block.keyword} has {len(constants)} constants "
                                    f"(PROPERTIES={clip(block.option('PROPERTIES'))}): correct one of them")
    constants += [0.0] * (wanted - len(constants))
    if len(constants) > MOST_CONSTANTS or deck.field_count > MOST_FIELDS:
        text = (f"{deck.field_count} fields and {len(constants)} constants of VUSDFLD "
                f"(at most {MOST_FIELDS} and {MOST_CONSTANTS})")
        deck.ledger.refuse(block.keyword, block.place, text, "VUSDFLD is not called")
        return
    law["field_variables"] = deck.field_count
    if constants:
        law["field_constants"] = constants
    deck.ledger.translated(block.keyword, block.place,
                           f"field_variables: VUSDFLD of the library sets {deck.field_count}")


def read_field(deck: AbaqusDeck, block: Block) -> None:
    """*INITIAL CONDITIONS, TYPE=FIELD: values of nodes before VUSDFLD sets those of the points."""
    if any(block.number(line, i) for line in block.lines for i in range(1, 8)):
        deck.ledger.refuse("INITIAL CONDITIONS.FIELD", block.place,
                           "a field at the start other than 0", "fields begin with 0")
    else:
        deck.ledger.ignored("INITIAL CONDITIONS.FIELD", block.place, "fields begin with 0 anyway")


def translate_hardening(deck: AbaqusDeck, name: str, law: Deck, plastic: Block, states: Block | None) -> Deck | None:
    """The law of a compiled VUHARD. law: that of *ELASTIC."""
    ledger = deck.ledger
    if not ledger.user_code:
        text = ("hardening by a subroutine of the user (no library has it): "
                "compile the VUHARD (docs/user_laws.md) and add --allow-library FILE")
        ledger.refuse("PLASTIC.HARDENING", plastic.place, text, "the material is elastic")
        return law
    elastic = {key: law[key] for key in ("youngs_modulus", "poissons_ratio")}
    made: Deck = {"model": "user_hardening", **elastic, "vuhard": ledger.user_code, "vuhard_name": name.upper()}
    return made if add_arrays(deck, name, made, plastic, states) else None


def add_arrays(deck: AbaqusDeck, name: str, law: Deck, user: Block, states: Block | None) -> bool:
    """PROPS and STATEV; False where there are too many."""
    option = "CONSTANTS" if user.keyword == "USER MATERIAL" else "PROPERTIES"
    constants = read_constants(user)
    wanted = parse_integer(user.option(option))
    if wanted is None:
        raise BadInput(user.place,
                       f"{option}={clip(user.option(option))} of *{user.keyword} is not a number: correct it")
    if 0 <= wanted - len(constants) <= 8:  # blanks at the end of the last line are zeros
        constants += [0.0] * (wanted - len(constants))
    count = 0
    if states is not None and states.lines:
        count = states.integer(states.lines[0], 0)
    if wanted != len(constants):
        raise BadInput(user.place,
                       f"*{user.keyword} has {len(constants)} constants ({option}={wanted}): correct one of them")
    if len(constants) > MOST_CONSTANTS or not 0 <= count <= MOST_STATES:
        text = (f"material {clip(name)} has {len(constants)} constants and {count} state variables "
                f"(at most {MOST_CONSTANTS} and {MOST_STATES})")
        deck.ledger.refuse(user.keyword, user.place, text, LEFT_OUT)
        return False
    if constants:
        law["constants"] = constants
    if len(deck.steps) > 1:
        law["step_starts"] = [step.start for step in deck.steps[1:]]
    if count:
        law["state_variables"] = count
    if states is not None and states.option("DELETE"):
        law["delete_variable"] = read_deletion(states, count)
    deck.ledger.translated(user.keyword, user.place, f"{law['model']}, of the library {deck.ledger.user_code}")
    if states is not None:
        deck.ledger.translated("DEPVAR", states.place, "state_variables")
    return True


def read_constants(user: Block) -> list[float]:
    """Eight a line: what a line lacks is 0, but for the last one, where a comma may follow the last constant."""
    constants = [user.number(line, i) for line in user.lines for i in range(8)]
    last = user.lines[-1][1][:8] if user.lines else []
    while last and not last[-1]:
        last = last[:-1]
    return constants[: len(constants) - 8 + len(last)] if constants else []


def read_deletion(states: Block, count: int) -> int:
    """The state variable that deletes elements."""
    number = parse_integer(states.option("DELETE"))
    if number is None or not 1 <= number <= count:
        raise BadInput(states.place, f"DELETE={clip(states.option('DELETE'))} of *DEPVAR is none of {count} state "
                                     "variables: correct it")
    return number


def read_solution(deck: AbaqusDeck, block: Block) -> None:
    """*INITIAL CONDITIONS, TYPE=SOLUTION: state variables of user code, seven behind the name of the elements,
    eight in each line that follows."""
    if not has_user_code(deck):
        deck.ledger.ignored("INITIAL CONDITIONS.SOLUTION", block.place,
                            "state variables of user code: the laws that are read have none")
        return
    laws, lines = deck.model.materials, iter(block.lines)
    for line in lines:
        place = block.at(line[0])
        elements = [id for id in deck.elements_of(block.text(line, 0), place) if id in deck.blocks_of_elements]
        used = [laws[deck.model.blocks[deck.blocks_of_elements[id]].keys["material"]] for id in elements]
        count = max((law.get("state_variables", 0) for law in used if law["model"] in LAWS), default=0)
        values = [block.number(line, i) for i in range(1, 8)]
        while len(values) < count and (more := next(lines, None)) is not None:
            values += [block.number(more, i) for i in range(8)]
        deck.states.update(dict.fromkeys(elements, tuple(values[:count])))
        if any(values[count:]):
            deck.ledger.ignored("INITIAL CONDITIONS.SOLUTION", place,
                                f"more state variables at the start than the {count} of *DEPVAR")
    deck.states_place = block.place


def apply_states(deck: AbaqusDeck) -> None:
    """Each part with other state variables at the start gets a material of its own."""
    place, laws = deck.states_place, deck.model.materials
    if place is None:
        return
    begun: dict[str, tuple[float, ...]] = {}  # by material
    for part in deck.model.blocks:
        name = part.keys["material"]
        if laws[name]["model"] not in LAWS:
            continue
        found = {strip_zeros(deck.states.get(id, ())) for id, _ in part.elements()}
        if len(found) > 1 or len(max(found, default=())) > MOST_CONSTANTS:
            text = f"state variables of user code at the start that differ within a part, or more than {MOST_CONSTANTS}"
            deck.ledger.refuse("INITIAL CONDITIONS.SOLUTION", place, text, "they begin with 0")
            found = {()}
        values = next(iter(found), ())
        if begun.setdefault(name, values) != values:
            part.keys["material"] = own = find_twin(deck, name, begun, values)
            begun[own] = values
        law = laws[part.keys["material"]]
        if values:
            law["start_states"] = list(values)
    deck.ledger.translated("INITIAL CONDITIONS", place, "start_states")


def find_twin(deck: AbaqusDeck, name: str, begun: dict[str, tuple[float, ...]], values: tuple[float, ...]) -> str:
    """A material like `name` that begins with these values."""
    laws = deck.model.materials
    like = {key: value for key, value in laws[name].items() if key != "start_states"}
    for other, law in laws.items():
        if begun.get(other) == values and {key: value for key, value in law.items() if key != "start_states"} == like:
            return other
    twin = deck.model.names.take(name, "material")
    laws[twin] = like
    for names in deck.names_of_laws.values():
        if name in names:
            names.append(twin)
    return twin


def strip_zeros(values: tuple[float, ...]) -> tuple[float, ...]:
    last = max((i for i, value in enumerate(values, 1) if value), default=0)
    return values[:last]


def has_user_code(deck: AbaqusDeck) -> bool:
    """Whether a part has a law of user code."""
    return any(law["model"] in LAWS for law in deck.model.materials.values())


def is_user_hardening(block: Block) -> bool:
    return block.keyword == "PLASTIC" and block.option("HARDENING") == "USER"


def is_user_code(material: MaterialBlocks) -> bool:
    return any(block.keyword == "USER MATERIAL" or is_user_hardening(block) for block in material.parts)
