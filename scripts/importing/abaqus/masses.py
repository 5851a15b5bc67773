"""*FIXED MASS SCALING and *VARIABLE MASS SCALING: a least time step."""

from .deck import AbaqusDeck
from .lines import Block

SCALED = ("elastic", "j2_plasticity")  # laws of solids whose mass percuss scales


def read_mass_scaling(deck: AbaqusDeck, block: Block) -> None:
    """Mass scaling of all parts that percuss can scale."""
    step = block.number((block.place.line, [block.options.get("DT", "")]), 0)
    if "ELSET" in block.options or step <= 0:
        deck.ledger.refuse(block.keyword, block.place, "mass scaling of a set of elements, or without DT", "no mass is added")
        return
    left = set()
    for part in deck.model.blocks:
        law = deck.model.materials[part.keys["material"]]
        if part.solids and (law["model"] not in SCALED or "equation_of_state" in law):
            left.add(law["model"])
        elif "rigid" not in part.keys:
            every = {"every": 10} if block.keyword.startswith("VARIABLE") else {}
            part.keys["mass_scaling"] = {"step": step, "max_added": 1.0, **every}
    if left:
        laws = ", ".join(sorted(left))
        deck.ledger.refuse(f"{block.keyword}.law", block.place, f"mass scaling of solids of {laws}", "these get no mass")
    deck.ledger.approximated(block.keyword, block.place, "mass_scaling of each part, at most its own mass")
