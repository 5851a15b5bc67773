"""Cohesive elements between solids: cohesive ties of the faces below and above them."""

import math
from collections.abc import Iterable

from .ledger import Ledger, Place
from .model import Deck, Model
from .solids import FACES

LEFT_OUT = "they are left out"  # what happens to the elements where that is allowed
REACH = 1.01  # of the thickness of a layer, within which its nodes find the other side
Elements = Iterable[tuple[int, tuple[int, ...]]]


def add_layer(model: Model, ledger: Ledger, wish: str, elements: Elements, law: Deck, place: Place) -> bool:
    """Ties the solids on both sides of a layer. elements: (id, corners), those of the face below first; corners named more than
    once are of wedges. wish: what the sides may be called. Returns whether the layer is there; else the ledger says why not."""
    below, above, gap = [], [], 0.0
    for _, corners in elements:
        half = len(corners) // 2
        below.append(tuple(dict.fromkeys(corners[:half])))
        above.append(tuple(dict.fromkeys(corners[half:])))
        gap = max([gap, *(math.dist(model.nodes[a], model.nodes[b]) for a, b in zip(corners, corners[half:]))])
    fault = find_fault(model, below, above)
    if fault:
        ledger.refuse("ELEMENT.cohesive", place, fault, LEFT_OUT)
        return False
    tie: Deck = {}
    for side, faces in (("a", below), ("b", above)):
        name = model.names.take(f"{wish}_{'below' if side == 'a' else 'above'}")
        model.side_sets[name] = faces
        tie[side] = name
    if gap > 0:
        tie["distance"] = REACH * gap
    model.deck.setdefault("contact", {}).setdefault("ties", []).append(tie | {"cohesive": law})
    text = "contact.ties with cohesive between the solids on both sides: a point of glue at each node below; the mass of the layer is left out"
    ledger.approximated("ELEMENT.cohesive", place, text)
    return True


def find_fault(model: Model, below: list[tuple[int, ...]], above: list[tuple[int, ...]]) -> str:
    """Why a layer is no tie of solids; empty: it is."""
    known = {frozenset(corners[i] for i in face) for block in model.blocks for _, corners in block.solids for face in FACES[len(corners)]}
    if any(len(faces) < 3 for faces in (*below, *above)):
        return "cohesive elements without area"
    if any(frozenset(face) not in known for face in (*below, *above)):
        return "cohesive elements whose faces are not those of solids on both sides"
    if {node for face in below for node in face} & {node for face in above for node in face}:
        return "cohesive elements that end in a node of both sides"
    return ""


def find_energy_fault(law: Deck) -> str:
    """In which direction the energy of a law is less than what it has stored at its strength; empty: in none."""
    for of in ("normal", "shear"):
        if law[f"{of}_energy"] <= 0.5 * law[f"{of}_strength"] ** 2 / law[f"{of}_stiffness"]:
            return of
    return ""
