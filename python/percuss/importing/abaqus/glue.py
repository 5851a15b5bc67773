"""*COHESIVE BEHAVIOR of a surface interaction, with *DAMAGE INITIATION and *DAMAGE EVOLUTION: cohesive ties."""

from ..fields import clip
from ..ledger import Place
from ..model import Deck
from .damage import need_line
from .deck import AbaqusDeck
from .lines import Block

NEVER_TIED = "the surfaces touch and are not bonded"
CLOSE = 1e-9  # relative difference of values that are equal


def add_glue(deck: AbaqusDeck, block: Block, names: tuple[str, str], interaction: str, place: Place) -> None:
    """The bonds of an interaction that general contact gives to two surfaces."""
    blocks = deck.glues.get(interaction.upper(), [])
    if not blocks:
        return
    if block.step > 1:
        deck.ledger.refuse("COHESIVE BEHAVIOR.step", place, "bonds that begin in a later step", NEVER_TIED)
        return
    if not all(names):
        deck.ledger.refuse("COHESIVE BEHAVIOR.surfaces", place, "bonds of everything that touches, instead of two named surfaces", NEVER_TIED)
        return
    sides = [deck.surface_name(name, place, of_contact=True) for name in names]
    law = read_law(deck, blocks)
    if law and all(sides):
        deck.model.deck.setdefault("contact", {}).setdefault("ties", []).append({"a": sides[0], "b": sides[1], "cohesive": law})
        deck.ledger.translated("COHESIVE BEHAVIOR", place, "contact.ties with cohesive")


def refuse_glue(deck: AbaqusDeck, interaction: str, place: Place) -> None:
    """Bonds of a contact pair, which Abaqus/Explicit does not have."""
    if deck.glues.get(interaction.upper()):
        deck.ledger.refuse("COHESIVE BEHAVIOR.pair", place, "bonds of a contact pair instead of general contact", NEVER_TIED)


def read_law(deck: AbaqusDeck, blocks: list[Block]) -> Deck:
    """Keys of a cohesive tie; empty: refused."""
    found = {block.keyword: block for block in blocks}
    for keyword in ("COHESIVE BEHAVIOR", "DAMAGE INITIATION", "DAMAGE EVOLUTION"):
        if keyword not in found or not any(any(line[1]) for line in found[keyword].lines):
            what = "bonds with the stiffness of the penalty method" if keyword == "COHESIVE BEHAVIOR" else f"bonds without the data of *{keyword}"
            deck.ledger.refuse(f"COHESIVE BEHAVIOR.{keyword}", blocks[0].place, what, NEVER_TIED)
            return {}
    behavior, start, end = found["COHESIVE BEHAVIOR"], found["DAMAGE INITIATION"], found["DAMAGE EVOLUTION"]
    faults = [fault for fault in (find_fault_of_bonds(behavior), find_fault_of_damage(start, end)) if fault]
    for place, what in faults:
        deck.ledger.refuse("COHESIVE BEHAVIOR.damage", place, what, NEVER_TIED)
    if faults or not note_contacts(deck, behavior):
        return {}
    rows = [[block.number(need_line(block), i) for i in range(3)] for block in (behavior, start, end)]
    for block, row in zip((behavior, start, end), rows):
        if has_one_value(block):
            row[1] = row[2] = row[0]
        if min(row) <= 0 or abs(row[1] - row[2]) > CLOSE * row[1]:
            deck.ledger.refuse("COHESIVE BEHAVIOR.directions", block.place, f"values of *{block.keyword} that differ in both directions of shear, or are not positive", NEVER_TIED)
            return {}
    (k_n, k_s, _), (t_n, t_s, _), (g_n, g_s, _) = rows
    if abs(k_n - k_s) > CLOSE * k_n:
        text = "bonds whose stiffnesses in tension and shear differ: mixes have another effective separation"
        if not deck.ledger.refuse("COHESIVE BEHAVIOR.mix", behavior.place, text, "mixes spend the energy at their share of shear"):
            return {}
    if g_n <= 0.5 * t_n**2 / k_n or g_s <= 0.5 * t_s**2 / k_s:
        deck.ledger.refuse("COHESIVE BEHAVIOR.energy", end.place, "bonds that have stored more than their energy at their strength", NEVER_TIED)
        return {}
    return {
        "normal_stiffness": k_n, "shear_stiffness": k_s, "normal_strength": t_n, "shear_strength": t_s, "normal_energy": g_n, "shear_energy": g_s, **read_mix(end),
    }  # fmt: skip


def has_one_value(block: Block) -> bool:
    """An energy that is that of all mixes."""
    return block.keyword == "DAMAGE EVOLUTION" and block.option("MIXED MODE BEHAVIOR") in ("", "TABULAR")


def read_mix(end: Block) -> Deck:
    if has_one_value(end):
        return {}
    mix = "power_law" if end.option("MIXED MODE BEHAVIOR") == "POWER LAW" else "benzeggagh_kenane"
    return {"mix": mix, "exponent": end.number((end.place.line, [end.option("POWER")]), 0)}


def note_contacts(deck: AbaqusDeck, behavior: Block) -> bool:
    """Which nodes are bonded: those that touch at the start."""
    if behavior.option("ELIGIBILITY") == "ORIGINAL CONTACTS":
        return True
    text = "bonds of nodes that come into contact later"
    return deck.ledger.refuse("COHESIVE BEHAVIOR.ELIGIBILITY", behavior.place, text, "those that touch at the start are bonded")


def find_fault_of_bonds(behavior: Block) -> tuple[Place, str] | None:
    if behavior.option("TYPE") not in ("", "UNCOUPLED"):
        return behavior.place, f"bonds with TYPE={clip(behavior.option('TYPE'))}"
    if behavior.option("REPEATED CONTACTS") or "REPEATED CONTACTS" in behavior.options:
        return behavior.place, "bonds that heal at every contact"
    return None


def find_fault_of_damage(start: Block, end: Block) -> tuple[Place, str] | None:
    if start.option("CRITERION") != "QUADS":
        return start.place, f"damage of bonds by the criterion {clip(start.option('CRITERION')) or 'MAXS'}"
    if end.option("TYPE") != "ENERGY" or end.option("SOFTENING") not in ("", "LINEAR"):
        return end.place, "damage of bonds that is not linear, or not given by an energy"
    lines = [line for line in end.lines if any(line[1])]
    mix = end.option("MIXED MODE BEHAVIOR")
    if mix not in ("", "TABULAR", "BK", "POWER LAW") or mix in ("", "TABULAR") and len(lines) > 1:
        return end.place, "damage of bonds by a table of mixes"
    if mix in ("BK", "POWER LAW") and not end.option("POWER"):
        return end.place, "damage of bonds by a law of mixes without POWER"
    return None
