"""*FIXED MASS SCALING and *VARIABLE MASS SCALING: factors of mass, and a least time step."""

from ..fields import clip
from ..ledger import BadInput
from ..model import Block as Part
from ..model import Deck
from .deck import AbaqusDeck
from .lines import Block

MOST_ADDED = 1e6  # a share of the mass of a part: there is no limit in Abaqus
EVERY = 10  # steps between two checks, where the deck does not say


def read_mass_scaling(deck: AbaqusDeck, block: Block) -> None:
    """Mass scaling of a set of elements or of all: it becomes that of whole parts."""
    line = (block.place.line, [block.options.get(name, "") for name in ("FACTOR", "DT")])
    factor, step = block.number(line, 0), block.number(line, 1)
    if min(factor, step) < 0 or factor == step == 0:
        raise BadInput(block.place, f"*{block.keyword} has no positive FACTOR or DT: add one")
    what = (block.keyword, *sorted((name, value.upper()) for name, value in block.options.items()))
    if what in deck.scaled:
        deck.ledger.ignored(f"{block.keyword}.again", block.place, "it goes on as in the step before")
        return
    deck.scaled.add(what)
    if block.step > 1:
        deck.ledger.refuse(f"{block.keyword}.step", block.place,
                           "mass scaling that begins in a later step", "it acts from the start")
    kind = block.option("TYPE") or "UNIFORM"
    if step and kind not in ("BELOW MIN", "UNIFORM"):
        deck.ledger.refuse(f"{block.keyword}.TYPE", block.place,
                           f"mass scaling of the type {clip(kind)}, which takes mass away too", "mass is added alone")
    elif step and kind == "UNIFORM":
        deck.ledger.approximated(f"{block.keyword}.TYPE", block.place,
                                 "TYPE=UNIFORM scales all elements alike: percuss those below DT alone, with less mass")
    parts = list_parts(deck, block)
    if factor and factor != 1:
        scale_density(deck, block, parts, factor)
    if step:
        set_step(deck, block, parts, step)


def list_parts(deck: AbaqusDeck, block: Block) -> list[Part]:
    """Parts whose elements are all in the set."""
    name = block.option("ELSET")
    if not name:
        return list(deck.model.blocks)
    wanted = set(deck.elements_of(name, block.place))
    touched = [part for part in deck.model.blocks if any(id in wanted for id, _ in part.elements())]
    if any(id not in wanted for part in touched for id, _ in part.elements()):
        deck.ledger.refuse(f"{block.keyword}.ELSET", block.place, "mass scaling of some elements of a part",
                           "all of the part are scaled")
    return touched


def scale_density(deck: AbaqusDeck, block: Block, parts: list[Part], factor: float) -> None:
    """A material of its own, with more density, for the parts that are scaled."""
    materials = deck.model.materials
    copies: dict[str, str] = {}
    for part in parts:
        for keys in list_users(part):
            name = keys["material"]
            if name not in copies:
                copies[name] = deck.model.names.take(f"{name}_scaled", "material")
                materials[copies[name]] = add_weight(materials[name], factor)
            keys["material"] = copies[name]
        part.density *= factor
    used = {keys["material"] for part in deck.model.blocks for keys in list_users(part)}
    for name in [name for name in materials if name not in used]:
        del materials[name]
    deck.ledger.approximated(f"{block.keyword}.FACTOR", block.place,
                             "FACTOR: the density of the parts times the factor, which counts in gravity too")


def list_users(part: Part) -> list[Deck]:
    """The part, and those of its plies that name a material."""
    return [part.keys, *(ply for ply in part.keys.get("plies", []) if "material" in ply)]


def add_weight(law: Deck, factor: float) -> Deck:
    """A law of more density whose stress and temperature follow from its motion as before:
    what is by mass goes with the density."""
    heavy = {**law, "density": law["density"] * factor}
    if "specific_heat" in law:
        heavy["specific_heat"] = law["specific_heat"] / factor
    state = law.get("equation_of_state", {})
    if "sound_speed" in state:
        heavy["equation_of_state"] = {**state, "sound_speed": state["sound_speed"] / factor**0.5}
    return heavy


def set_step(deck: AbaqusDeck, block: Block, parts: list[Part], step: float) -> None:
    frequency = block.integer((block.place.line, [block.options.get("FREQUENCY", "")]), 0, EVERY)
    every = {"every": max(frequency, 1)} if block.keyword.startswith("VARIABLE") else {}
    for part in parts:
        if "rigid" not in part.keys:
            part.keys["mass_scaling"] = {"step": step, "max_added": MOST_ADDED, **every}
    deck.ledger.approximated(block.keyword, block.place,
                             "mass_scaling of each part, without a limit: DT is that of percuss' bound of an element; "
                             "the run says at its start how much mass that adds")
