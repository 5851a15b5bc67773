"""*USER MATERIAL: code of the user (VUMAT), in a library that the command line names."""

from ..fields import clip, parse_integer
from ..ledger import BadInput
from ..model import Deck
from .deck import AbaqusDeck, MaterialBlocks
from .lines import Block

MOST_CONSTANTS, MOST_STATES = 200, 64


def translate_user_code(deck: AbaqusDeck, name: str, user: Block, states: Block | None) -> Deck | None:
    """The law of a compiled VUMAT. states: *DEPVAR, if there is one."""
    ledger = deck.ledger
    if not ledger.user_code:
        text = f"material {clip(name)} is user code (no library has it): compile the VUMAT (docs/user_laws.md) and add --allow-library FILE"
        ledger.refuse("USER MATERIAL", user.place, text, "the parts made of it are left out")
        return None
    if user.option("TYPE") not in ("", "MECHANICAL"):
        ledger.refuse("USER MATERIAL.TYPE", user.place, f"user code of the type {clip(user.option('TYPE'))}", "it is taken as mechanical")
    constants = read_constants(user)
    wanted = parse_integer(user.option("CONSTANTS"))
    if wanted is None:
        raise BadInput(user.place, f"CONSTANTS={clip(user.option('CONSTANTS'))} of *USER MATERIAL is not a number: correct it")
    if 0 <= wanted - len(constants) <= 8:  # blanks at the end of the last line are zeros
        constants += [0.0] * (wanted - len(constants))
    count = 0
    if states is not None and states.lines:
        count = states.integer(states.lines[0], 0)
    if wanted != len(constants):
        raise BadInput(user.place, f"*USER MATERIAL has {len(constants)} constants (CONSTANTS={wanted}): correct one of them")
    if len(constants) > MOST_CONSTANTS or not 0 <= count <= MOST_STATES:
        text = f"material {clip(name)} has {len(constants)} constants and {count} state variables (at most {MOST_CONSTANTS} and {MOST_STATES})"
        ledger.refuse("USER MATERIAL", user.place, text, "the parts made of it are left out")
        return None
    law: Deck = {"model": "user", "vumat": ledger.user_code, "vumat_name": name.upper()}
    if constants:
        law["constants"] = constants
    if count:
        law["state_variables"] = count
    if states is not None and states.option("DELETE"):
        law["delete_variable"] = read_deletion(states, count)
    ledger.translated("USER MATERIAL", user.place, f"user, of the library {ledger.user_code}")
    if states is not None:
        ledger.translated("DEPVAR", states.place, "state_variables")
    return law


def read_constants(user: Block) -> list[float]:
    """Eight a line: what a line lacks is 0, but for the last one, where a comma may follow the last constant."""
    constants = [user.number(line, i) for line in user.lines for i in range(8)]
    last = user.lines[-1][1][:8] if user.lines else []
    while last and not last[-1]:
        last = last[:-1]
    return constants[: len(constants) - 8 + len(last)] if constants else []


def read_deletion(states: Block, count: int) -> int:
    """Which state variable deletes elements."""
    number = parse_integer(states.option("DELETE"))
    if number is None or not 1 <= number <= count:
        raise BadInput(states.place, f"DELETE={clip(states.option('DELETE'))} of *DEPVAR is none of {count} state variables: correct it")
    return number


def has_user_code(deck: AbaqusDeck) -> bool:
    """Whether a part has a law of user code."""
    return any(law["model"] == "user" for law in deck.model.materials.values())


def is_user_code(material: MaterialBlocks) -> bool:
    return any(block.keyword == "USER MATERIAL" for block in material.parts)
