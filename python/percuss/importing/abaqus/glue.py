"""*COHESIVE BEHAVIOR of a surface interaction, with *DAMAGE INITIATION and *DAMAGE EVOLUTION: cohesive ties."""

from dataclasses import dataclass

from ..cohesive_layers import find_energy_fault
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
        deck.ledger.refuse("COHESIVE BEHAVIOR.surfaces", place,
                           "bonds of everything that touches, instead of two named surfaces", NEVER_TIED)
        return
    sides = [deck.surface_name(name, place, of_contact=True) for name in names]
    law = read_law(deck, Bonds("COHESIVE BEHAVIOR", blocks[0].place, blocks, "COHESIVE BEHAVIOR", NEVER_TIED))
    if law and all(sides):
        deck.model.deck.setdefault("contact", {}).setdefault("ties", []).append(
            {"a": sides[0], "b": sides[1], "cohesive": law})
        deck.ledger.translated("COHESIVE BEHAVIOR", place, "contact.ties with cohesive")


def refuse_glue(deck: AbaqusDeck, interaction: str, place: Place) -> None:
    """Bonds of a contact pair, which Abaqus/Explicit does not have."""
    if deck.glues.get(interaction.upper()):
        deck.ledger.refuse("COHESIVE BEHAVIOR.pair", place,
                           "bonds of a contact pair instead of general contact", NEVER_TIED)


@dataclass
class Bonds:
    """What gives a cohesive law: of a surface interaction, or of the material of cohesive elements."""

    card: str
    place: Place
    blocks: list[Block]
    stiffness: str  # the keyword of the stiffnesses
    instead: str  # what is so where a refusal is allowed
    thickness: float = 1.0  # over which the stiffnesses are moduli

    def find(self, keyword: str) -> Block | None:
        """The last block of a keyword that has data."""
        found = [block for block in self.blocks
                 if block.keyword == keyword and any(any(line[1]) for line in block.lines)]
        return found[-1] if found else None


def read_law(deck: AbaqusDeck, bonds: Bonds) -> Deck:
    """Keys of a cohesive tie; empty: refused."""
    behavior, start, end = (bonds.find(keyword)
                            for keyword in (bonds.stiffness, "DAMAGE INITIATION", "DAMAGE EVOLUTION"))
    if not (behavior and start and end):
        lacks = next(word for word, block in ((bonds.stiffness, behavior), ("DAMAGE INITIATION", start),
                                              ("DAMAGE EVOLUTION", end)) if not block)
        what = ("bonds with the stiffness of the penalty method" if lacks == "COHESIVE BEHAVIOR"
                else f"bonds without the data of *{lacks}")
        deck.ledger.refuse(f"{bonds.card}.{lacks}", bonds.place, what, bonds.instead)
        return {}
    faults = [fault for fault in (find_fault_of_bonds(behavior), find_fault_of_damage(start, end)) if fault]
    for place, what in faults:
        deck.ledger.refuse(f"{bonds.card}.damage", place, what, bonds.instead)
    if faults or behavior.keyword == "COHESIVE BEHAVIOR" and not note_contacts(deck, behavior):
        return {}
    rows = [[block.number(need_line(block), i) for i in range(3)] for block in (behavior, start, end)]
    for block, row in zip((behavior, start, end), rows):
        if has_one_value(block):
            row[1] = row[2] = row[0]
        if min(row) <= 0 or abs(row[1] - row[2]) > CLOSE * row[1]:
            deck.ledger.refuse(f"{bonds.card}.directions", block.place,
                               f"values of *{block.keyword} that differ in both directions of shear, "
                               "or are not positive", bonds.instead)
            return {}
    (k_n, k_s, _), (t_n, t_s, _), (g_n, g_s, _) = rows
    if abs(k_n - k_s) > CLOSE * k_n:
        text = "bonds whose stiffnesses in tension and shear differ: mixes have another effective separation"
        if not deck.ledger.refuse(f"{bonds.card}.mix", behavior.place, text,
                                  "mixes spend the energy at their share of shear"):
            return {}
    k_n, k_s = k_n / bonds.thickness, k_s / bonds.thickness
    if end.option("TYPE") == "DISPLACEMENT":
        if abs(t_n - t_s) > CLOSE * t_n and not deck.ledger.refuse(
                f"{bonds.card}.mix", end.place, "one displacement of failure for strengths that differ",
                "mixes spend the energy at their share of shear"):
            return {}
        g_n, g_s = 0.5 * t_n * (g_n + t_n / k_n), 0.5 * t_s * (g_s + t_s / k_s)
    law: Deck = {"normal_stiffness": k_n, "shear_stiffness": k_s, "normal_strength": t_n, "shear_strength": t_s,
                 "normal_energy": g_n, "shear_energy": g_s, **read_mix(end)}
    if start.option("CRITERION") == "MAXS":
        law["onset"] = "maximum"
    if end.option("SOFTENING") == "EXPONENTIAL":
        law["softening"] = "exponential"
    if find_energy_fault(law):
        deck.ledger.refuse(f"{bonds.card}.energy", end.place,
                           "bonds that have stored more than their energy at their strength", bonds.instead)
        return {}
    return law


def has_one_value(block: Block) -> bool:
    """An energy or a displacement that is that of all mixes."""
    return (block.keyword == "DAMAGE EVOLUTION"
            and block.option("MIXED MODE BEHAVIOR") in ("", "MODE INDEPENDENT", "TABULAR"))


def read_mix(end: Block) -> Deck:
    if has_one_value(end):
        return {}
    mix = "power_law" if end.option("MIXED MODE BEHAVIOR") == "POWER LAW" else "benzeggagh_kenane"
    return {"mix": mix, "exponent": end.number((end.place.line, [end.option("POWER")]), 0)}


def note_contacts(deck: AbaqusDeck, behavior: Block) -> bool:
    """The nodes that are bonded: those that touch at the start."""
    if behavior.option("ELIGIBILITY") == "ORIGINAL CONTACTS":
        return True
    text = "bonds of nodes that come into contact later"
    return deck.ledger.refuse("COHESIVE BEHAVIOR.ELIGIBILITY", behavior.place, text,
                              "those that touch at the start are bonded")


def find_fault_of_bonds(behavior: Block) -> tuple[Place, str] | None:
    if behavior.keyword == "ELASTIC" and behavior.option("TYPE") != "TRACTION":
        return behavior.place, "*ELASTIC of cohesive elements without TYPE=TRACTION"
    if behavior.keyword == "COHESIVE BEHAVIOR" and behavior.option("TYPE") not in ("", "UNCOUPLED"):
        return behavior.place, f"bonds with TYPE={clip(behavior.option('TYPE'))}"
    if behavior.option("REPEATED CONTACTS") or "REPEATED CONTACTS" in behavior.options:
        return behavior.place, "bonds that heal at every contact"
    return None


def find_fault_of_damage(start: Block, end: Block) -> tuple[Place, str] | None:
    if start.option("CRITERION") not in ("QUADS", "MAXS"):
        return start.place, f"damage of bonds by the criterion {clip(start.option('CRITERION')) or 'that is not given'}"
    softenings = ("", "LINEAR", "EXPONENTIAL") if end.option("TYPE") == "ENERGY" else ("", "LINEAR")
    if end.option("TYPE") not in ("ENERGY", "DISPLACEMENT") or end.option("SOFTENING") not in softenings:
        return (end.place, "damage of bonds by a table, by an exponential of the displacement, "
                           "or given by neither an energy nor a displacement")
    lines = [line for line in end.lines if any(line[1])]
    mix = end.option("MIXED MODE BEHAVIOR")
    if mix not in ("", "MODE INDEPENDENT", "TABULAR", "BK", "POWER LAW") or has_one_value(end) and len(lines) > 1:
        return end.place, "damage of bonds by a table of mixes"
    if end.option("TYPE") == "DISPLACEMENT" and not has_one_value(end):
        return end.place, "a displacement of failure that depends on the mix"
    if mix in ("BK", "POWER LAW") and not end.option("POWER"):
        return end.place, "damage of bonds by a law of mixes without POWER"
    return None
