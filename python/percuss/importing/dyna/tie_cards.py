"""Contacts that tie their sides: whole, until a stress is reached, or as glue."""

from ..model import Deck
from .contact_sides import INSTEAD, Contact, list_side_parts, nodes_of_side, side_name
from .deck import KeywordDeck
from .reaches import find_reach
from .windows import Window, switch

TURNS = ("TIED_SHELL_EDGE", "SPOTWELD")  # ties that hold rotations, too
GLUES = {9, 11}  # OPTION of a tie with a traction-separation law
STICKS = {1, 3}  # OPTION of a tie: nodes that come into contact later stick too; with 1 they never let go
BY_TABLE = -9999  # DT: BT is a curve of births and deaths


def describe_breaking(contact: Contact) -> tuple[str, str]:
    """What a tie does that percuss lacks, and what is done instead."""
    option = find_option(contact)
    if option == 4:
        return ("OPTION 4: nodes that are held along the normal and slide with friction",
                "they are held in all directions, and do not fail")
    return f"ties that fail{f' by the rule of OPTION {option}' if option else ''}", "they do not fail"


def find_times(deck: KeywordDeck, contact: Contact) -> Deck:
    """`from` and `until` of a pair: of negative times the size counts, DT < 0 takes it out of a relaxation."""
    birth, death = contact.law.numbers("BT", "DT")
    if death == BY_TABLE:
        deck.ledger.refuse("CONTACT.DT", contact.place, "contact with several births and deaths by a table",
                           "it acts during the whole run")
        return {}
    if death < 0 and "relaxation" in deck.model.deck.get("start", {}):
        deck.ledger.refuse("CONTACT.DT", contact.place,
                           "contact that does not act in dynamic relaxation", "it acts as at time 0")
    birth, death = abs(birth), abs(death)
    return switch(deck, Window(birth, death if 0 < death < deck.end_time else None))


def find_option(contact: Contact) -> int:
    """OPTION of a tie that breaks, by its own card; 0: of another tie."""
    return contact.failure.integer("OPTION") if contact.failure and "AUTOMATIC" in contact.keyword else 0


def find_strengths(contact: Contact) -> Deck:
    """Strengths of a tie that breaks where (tension / NFLS)^2 + (shear / SFLS)^2 reaches 1; empty: of no such tie."""
    row = contact.failure
    if row is None or ("AUTOMATIC" in contact.keyword and find_option(contact) not in (2, 3)):
        return {}
    return {key: row.number(name) for key, name in (("normal", "NFLS"), ("shear", "SFLS")) if row.number(name) > 0}


def find_glue(contact: Contact) -> Deck:
    """OPTION 9 and 11: the law of *MAT_138 between the surfaces."""
    assert contact.failure is not None
    row = contact.failure
    stiffness, ratio, power = row.number("CN"), row.number("CT2CN") or 1.0, row.number("PARAM")
    return {
        "normal_stiffness": stiffness, "shear_stiffness": ratio * stiffness, "normal_strength": row.number("NFLS"),
        "shear_strength": row.number("SFLS"), "normal_energy": row.number("ERATEN"), "shear_energy":
        row.number("ERATES"), "mix": "power_law" if power > 0 else "benzeggagh_kenane", "exponent": abs(power),
    }  # fmt: skip


def find_glue_fault(deck: KeywordDeck, contact: Contact) -> str:
    """What of a law of glue percuss lacks; empty: nothing."""
    option, glue = f"OPTION {find_option(contact)}", find_glue(contact)
    if find_times(deck, contact):
        return f"{option}: glue with BT or DT"
    if glue["normal_stiffness"] <= 0:
        return f"{option} without CN: glue with the stiffness of the penalty method"
    if glue["exponent"] == 0:
        return f"{option} without PARAM: glue without a law of the mix"
    missing = [key for key in ("NFLS", "SFLS", "ERATEN", "ERATES", "CT2CN")
               if contact.failure and contact.failure.number(key) < (0.0 if key == "CT2CN" else 1e-300)]
    if missing:
        return f"{option} with {missing[0]} that is not positive: glue whose values are curves, or none"
    for of in ("normal", "shear"):
        if glue[f"{of}_energy"] <= 0.5 * glue[f"{of}_strength"] ** 2 / glue[f"{of}_stiffness"]:
            return f"{option}: glue that has stored more than its energy in {of} direction when it reaches its strength"
    return ""


def tied_name(deck: KeywordDeck, contact: Contact) -> str | None:
    """Side a of a tie: of parts with beams their nodes, since beams have no faces."""
    parts = list_side_parts(deck, contact, "S") or []
    if contact.sides.integer("SSTYP") in (2, 3) and any(block.beams and block.part in parts
                                                        for block in deck.model.blocks):
        return deck.make_node_set(f"tied_{contact.sides.integer('SSID')}", sorted(nodes_of_side(deck, contact)),
                                  contact.place) or None
    return side_name(deck, contact, "S", for_tie=True)


def tie(deck: KeywordDeck, contact: Contact, is_glue: bool = False) -> None:
    a, b = tied_name(deck, contact), side_name(deck, contact, "M")
    thicknesses = contact.scale.numbers("SST", "MST")
    contact.law.skip("FS", "FD")
    times, option = find_times(deck, contact), find_option(contact)
    strengths = find_strengths(contact)
    if option == 1 and contact.failure:
        contact.failure.skip("NFLS", "SFLS")
    for row in (contact.sides, contact.law, contact.scale,
                contact.failure if strengths or is_glue or option == 1 else None):
        if row is not None:
            row.finish(deck.ledger)
    if not a or not b:
        deck.ledger.refuse(contact.keyword, contact.place, "a tie without two named sides", INSTEAD)
        return
    entry: Deck = {"a": a, "b": b, **times}
    reach = find_reach(deck, nodes_of_side(deck, contact), nodes_of_side(deck, contact, "M"), thicknesses)
    if reach:
        entry["distance"] = reach
    if (contact.keyword.removeprefix("CONTACT_").startswith(TURNS)
            and nodes_of_side(deck, contact) & deck.model.turning_nodes()):
        entry["rotations"] = True
    if strengths:
        entry["failure"] = strengths
    if is_glue:
        entry["cohesive"] = find_glue(contact)
    if option in STICKS:
        entry["sticks"] = "on_contact"
    if deck.ledger.allows("CONTACT_TIED.empty"):  # found by the run, which knows the reach
        entry["empty"] = "ignore"
        deck.ledger.approximated("CONTACT_TIED.empty", contact.place,
                                 "a tie in reach of nothing is reported by the run, and ignored")
    deck.model.deck.setdefault("contact", {}).setdefault("ties", []).append(entry)
    deck.ledger.approximated(
        contact.keyword, contact.place,
        "contact.ties: gaps stay as they are; the reach is 0.6 of both thicknesses, or percuss' if that is larger"
    )
