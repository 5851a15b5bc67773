"""*MAT_RIGID: the parts made of it are rigid bodies."""

from ...fields import Row
from ...model import Deck
from ..cards import Card
from ..deck import KeywordDeck, RigidPart

AXES = ("x", "y", "z")
DIRECTIONS = {0: "", 1: "x", 2: "y", 3: "z", 4: "xy", 5: "yz", 6: "zx", 7: "xyz"}


def read_law(row: Row) -> Deck:
    """Density, and the stiffness of contact."""
    row.skip("MID")
    return {
        "model": "elastic",
        "density": row.positive("RO"),
        "youngs_modulus": row.positive("E"),
        "poissons_ratio": row.number("PR"),
    }


def read_local_limits(deck: KeywordDeck, limits: Row) -> list[str] | None:
    """CMO is -1: CON1 is a system, CON2 six digits for its directions; None where its axes are none of space."""
    axes = []
    for axis in deck.systems.get(limits.integer("CON1"), ()):
        axes += [AXES[d] for d in range(3) if abs(abs(axis[d]) - 1) < 1e-9]
    digits = f"{limits.integer('CON2'):06d}"
    if set(digits) - {"0", "1"} or len(digits) != 6:
        limits.fail("CON2", "six digits of 0 and 1 are expected")
    if digits in ("111111", "111000", "000111", "000000"):  # the same in any system
        axes = list(AXES)
    if len(axes) != 3:
        return None
    names = [*axes, *(f"r{axis}" for axis in axes)]
    return [name for name, digit in zip(names, digits, strict=True) if digit == "1"]


def translate_rigid(deck: KeywordDeck, card: Card) -> Deck | None:
    """The law of its elements, of which mass and stiffness count. Notes its parts and what holds them."""
    reader = card.reader()
    row, limits = reader.row("MID RO E PR N~absent COUPLE M~absent ALIAS~label"), reader.row("CMO CON1 CON2")
    law, id = read_law(row), row.integer("MID")
    row.finish(deck.ledger, "the body is coupled to no other program")
    held: list[str] = []
    if limits.number("CMO") == 1:
        held = [*DIRECTIONS.get(limits.integer("CON1"), ""),
                *("r" + d for d in DIRECTIONS.get(limits.integer("CON2"), ""))]
    elif limits.number("CMO"):
        local = read_local_limits(deck, limits) if limits.number("CMO") == -1 else None
        if local is None:
            deck.ledger.refuse("MAT_RIGID.CMO", limits.place,
                               "a rigid body with constraints along axes that are none of space, or at a point",
                               "it is free")
        held = local or []
    for part in deck.parts.values():
        if part.material == id and deck.names_of_parts.get(part.id):
            deck.rigid[part.id] = RigidPart(held)
    row.finish(deck.ledger, "it is not coupled")
    deck.ledger.translated("MAT_RIGID", card.place, "parts.NAME.rigid")
    return law
