"""*MAT_...: which law of percuss a material becomes, for the parts that use it."""

from collections.abc import Callable
from dataclasses import replace

from ... import laws
from ...laminates import add_plies, find_difference
from ...ledger import BadInput, missing
from ...model import Block, Deck, Layer
from ...text_files import suggest
from ..cards import Card
from ..deck import KeywordDeck, PartCard
from .cohesive import FORMS as COHESIVE_FORMS
from .cohesive import LAW as COHESIVE_LAW
from .cohesive import bond_solids
from .crushable import CRUSHABLE
from .cyclic import CYCLIC
from .diem import add_diem
from .elastic import ELASTIC
from .erosion import add_erosion
from .fabric import FABRIC, make_membrane
from .foam_rates import FOAM_RATES
from .gissmo import add_gissmo
from .johnson import JOHNSON
from .metals import METALS
from .names import SPRINGS, name_law
from .orthotropic import ORTHOTROPIC
from .rigid import translate_rigid
from .rolled import ROLLED
from .rubber import RUBBER
from .shared import COROTATIONAL, Use
from .skins import cover
from .voids import VOIDS

ADDITIONS = ("MAT_ADD_", "MAT_NONLOCAL")  # cards that repeat the id of their material
LOG_OPTION = "_LOG_INTERPOLATION"
LINES = {"SPRING_ELASTIC": 1, "DAMPER_VISCOUS": 1, "SPRING_NONLINEAR_ELASTIC": 1, "ELASTIC": 1, "PLASTIC_KINEMATIC": 2,
         "RIGID": 3, "NULL": 1, "ORTHOTROPIC_ELASTIC": 4, "COMPOSITE_DAMAGE": 5, "PIECEWISE_LINEAR_PLASTICITY": 4,
         "VISCOELASTIC": 1, "HILL_3R": 5, "TRANSVERSELY_ANISOTROPIC_ELASTIC_PLASTIC": 1, COHESIVE_LAW: 2}
LAWS: dict[str, Callable[[KeywordDeck, Card, Use], Deck | None]] = {
    **ELASTIC, **METALS, **JOHNSON, **CRUSHABLE, **FOAM_RATES, **ORTHOTROPIC, **FABRIC, **ROLLED, **RUBBER, **CYCLIC,
    **VOIDS}


def read_material(deck: KeywordDeck, card: Card) -> None:
    """Materials by id; a keyword may be followed by several of fixed length."""
    if card.keyword.startswith("MAT_THERMAL"):
        deck.ledger.refuse(card.keyword, card.place, "heat conduction", "it is left out")
        return
    card.keyword = "MAT_" + name_law(card.keyword)
    kinds = {"MAT_ADD_EROSION": deck.erosions, "MAT_ADD_DAMAGE_GISSMO": deck.gissmos, "MAT_ADD_DAMAGE_DIEM": deck.diems}
    read = next((cards for name, cards in kinds.items() if card.keyword.startswith(name)), None)
    if card.keyword.startswith(ADDITIONS) and read is None:
        deck.additions.append(card)
        return
    if read is not None:
        reader = card.reader()
        if card.has_title:
            reader.take()
        row = card.row(reader.take(), "MID")
        deck.ids.claim(f"*{card.keyword} of material", row.integer("MID"), row.place)
        read[row.integer("MID")] = card
        return
    is_logarithmic = card.keyword == f"MAT_PIECEWISE_LINEAR_PLASTICITY{LOG_OPTION}"
    card.keyword = card.keyword.removesuffix(LOG_OPTION) if is_logarithmic else card.keyword
    reader, count = card.reader(), LINES.get(name_law(card.keyword), 0)
    while reader.next_card(of_lines=True):
        title = reader.text() if card.has_title else ""
        lines = [reader.take()]
        while reader and (not count or len(lines) < count):
            lines.append(reader.take())
        id = card.row(lines[0], "MID").integer("MID")
        deck.ids.claim("materials", id, card.at(lines[0][0]))
        deck.material_titles[id] = title
        if is_logarithmic:
            deck.logarithmic_materials.add(id)
        deck.materials[id] = Card(card.keyword, card.at(lines[0][0]), card.least_width, card.parameters, lines=lines)


def refuse_additions(deck: KeywordDeck) -> None:
    """Cards that add to a material of their id: percuss has those of *MAT_ADD_EROSION,
    *MAT_ADD_DAMAGE_GISSMO and *MAT_ADD_DAMAGE_DIEM."""
    for card in deck.additions:
        reader = card.reader()
        if card.has_title:
            reader.take()
        id = reader.row("MID").integer("MID")
        if ("material", id) in deck.used:
            deck.ledger.refuse(card.keyword, card.place, f"what it adds to material {id}",
                               "the material is that of its own card alone")
        else:
            deck.ledger.ignored(card.keyword, card.place, f"no element is of material {id}")
    for id, card in [*deck.erosions.items(), *deck.gissmos.items(), *deck.diems.items()]:
        if ("material", id) not in deck.used:
            deck.ledger.ignored(card.keyword, card.place, f"no element is of material {id}")


def read_state(deck: KeywordDeck, card: Card) -> None:
    """*EOS_... by id."""
    reader = card.reader()
    if card.has_title:
        reader.take()
    lines = [reader.take()]
    while reader:
        lines.append(reader.take())
    found = Card(card.keyword, card.at(lines[0][0]), card.least_width, card.parameters, lines=lines)
    row = found.row(lines[0], "EOSID")
    deck.ids.claim("equations of state", row.integer("EOSID"), row.place)
    deck.states[row.integer("EOSID")] = found


def build_materials(deck: KeywordDeck) -> None:
    """The material of each block. Blocks whose material is left out go out of the model."""
    made: dict[tuple[int, int, int, float, int], tuple[str, Deck] | None] = {}
    kept: list[Block] = []
    layers: list[tuple[PartCard, Block]] = []
    for block in deck.model.blocks:
        part = deck.parts[block.part]
        if block.solids and read_form(deck, part) in COHESIVE_FORMS:
            deck.names_of_parts[block.part].remove(block.name)
            layers.append((part, block))
            continue
        key = (part.material, part.state, block.part, block.more_density, block.keys.get("points", 1))
        if block.layers or key not in made:
            made[key] = lay_up(deck, part, block) if block.layers else make_material(deck, part, block)
        if made[key]:
            name, law = made[key]  # type: ignore[misc]
            block.keys = {"material": name, **block.keys}
            make_membrane(deck, block, law)
            if not block.layers:
                block.density = law["density"]
                turn_axes(deck, part, block, name, law)
            kept.append(block)
        else:
            deck.names_of_parts[block.part].remove(block.name)
    deck.model.blocks[:] = kept
    for part, block in layers:
        bond_solids(deck, part, block)
    refuse_additions(deck)
    for id, card in deck.materials.items():
        if ("material", id) not in deck.used:
            deck.ledger.ignored(card.keyword, card.place, "no element is of this material")
    for card in deck.states.values():
        if not any(deck.states.get(part.state) is card for part in deck.parts.values()):
            deck.ledger.ignored(card.keyword, card.place, "no part has this equation of state")


def lay_up(deck: KeywordDeck, part: PartCard, block: Block) -> "tuple[str, Deck] | None":
    """The material of a part with plies, which get theirs."""
    made = {layer.material: make_material(deck, replace(part, material=int(layer.material)), block)
            for layer in block.layers}
    laws = {id: found for id, found in made.items() if found}
    if len(laws) < len(made):
        return None
    difference = find_difference(block.layers, laws)
    if difference:
        text = f"plies whose materials differ in their {difference}" + (" (AOPT)" if difference == "axes" else "")
        deck.ledger.refuse("PART_COMPOSITE.MID1", part.place, text, f"the {difference} of one of them counts for all")
    turns = {id: deck.turns.get((int(id), block.id), 0.0) for id in laws}
    return add_plies(block, block.layers, laws, turns)


def turn_axes(deck: KeywordDeck, part: PartCard, block: Block, name: str, law: Deck) -> None:
    """An angle of the axes of a part without layers makes it one ply."""
    turn = deck.turns.get((part.material, block.id), 0.0)
    if not turn:
        return
    if block.thicknesses:
        text = "an angle of axes (BETA, or AOPT = 3) in a part whose shells differ in thickness"
        deck.ledger.refuse(f"{deck.materials[part.material].keyword}.BETA", part.place, text, "it turns nothing")
        return
    block.layers = [Layer(part.material, 1.0)]
    add_plies(block, block.layers, {part.material: (name, law)}, {part.material: turn})


def make_material(deck: KeywordDeck, part: PartCard, block: Block) -> "tuple[str, Deck] | None":
    """Name and keys of a material for a part; None where it is left out or refused."""
    card = deck.materials.get(part.material)
    if card is None:
        raise BadInput(part.place, missing(f"material {part.material}, of part {part.id}"))
    deck.used.add(("material", part.material))
    use = Use(bool(block.shells), find_state(deck, part), part.place, len(block.layers) or block.keys.get("points", 1),
              bool(block.beams))
    use.is_corotational = bool(block.solids) and read_form(deck, part) in (0, *COROTATIONAL)
    use.density = card.row(card.lines[0], "MID RO").number("RO")
    use.shells, use.solids, use.angles, use.has_systems = block.shells, block.solids, block.angles, block.has_systems
    law_name = name_law(card.keyword)
    if law_name == "RIGID":
        law = translate_rigid(deck, card)
    elif law_name == "NULL" and (use.is_shell or use.is_beam) and not use.state and cover(deck, block, use.density):
        return None
    elif law_name in LAWS:
        law = translate(deck, card, use, LAWS[law_name])
    else:
        deck.ledger.refuse(
            card.keyword, card.place,
            f"this material law{suggest(card.keyword, [f'MAT_{name}' for name in (*LAWS, *SPRINGS.values())])}",
            "the parts made of it are left out")
        return None
    if law is None or not may_be_used(deck, card, law, use, block):
        return None
    if use.state and not use.has_used_state and "equation_of_state" not in law:
        deck.ledger.refuse(f"{card.keyword}.EOSID", part.place,
                           "an equation of state with this law", "the law alone is used")
    deck.turns[part.material, block.id] = use.turn
    add_erosion(deck, part.material, law, use)
    add_gissmo(deck, part.material, law, use)
    add_diem(deck, part.material, law, use)
    invert_when_asked(deck, part, law, use)
    if law["model"] == "skin" and law.pop("failure", None):
        deck.ledger.refuse(f"{card.keyword}.failure", use.place,
                           "shells without strength that fail (percuss keeps a skin)", "they stay")
    if use.is_beam and "failure" in law:
        keep_limits_of_beams(deck, card, law, use)
    law["density"] += block.more_density
    deck.ledger.translated(card.keyword, card.place, law["model"])
    same = next((name for name in deck.names_of_laws.get(part.material, []) if deck.model.materials[name] == law), None)
    if same:
        return same, law
    name = deck.model.names.take(deck.material_titles[part.material] or f"material_{part.material}", "material")
    deck.model.materials[name] = law
    deck.model.origins.cards["materials", name] = (card.keyword, card.place)
    deck.names_of_laws.setdefault(part.material, []).append(name)
    return name, law


def read_form(deck: KeywordDeck, part: PartCard) -> int:
    """ELFORM of solids."""
    return deck.sections[part.section].reader().row("SECID ELFORM").integer("ELFORM")


def invert_when_asked(deck: KeywordDeck, part: PartCard, law: Deck, use: Use) -> None:
    """NFAIL1 of *CONTROL_SHELL and PSFAIL of *CONTROL_SOLID: what has folded over is eroded."""
    if law_name_is_rigid(deck, part) or use.is_beam or law["model"] == "skin":
        return
    asked = deck.erodes_folded_shells if use.is_shell else deck.eroded_when_inverted != 0
    set_id = deck.folded_shells if use.is_shell else deck.eroded_when_inverted
    if asked and (not set_id or part.id in deck.list_members("PART", set_id, part.place)):
        law.setdefault("failure", {})["inverted"] = True


def law_name_is_rigid(deck: KeywordDeck, part: PartCard) -> bool:
    return name_law(deck.materials[part.material].keyword) == "RIGID"


def translate(deck: KeywordDeck, card: Card, use: Use,
              law: Callable[[KeywordDeck, Card, Use], Deck | None]) -> Deck | None:
    """Numbers that are finite alone may have no finite quotient or power."""
    try:
        return law(deck, card, use)
    except ArithmeticError as error:
        raise BadInput(card.place, f"the numbers of *{card.keyword} are out of range ({error})") from None


def keep_limits_of_beams(deck: KeywordDeck, card: Card, law: Deck, use: Use) -> None:
    """Beams fail by the forces of their section, by plastic strain or at a time, and by nothing else."""
    limits = law.pop("failure")
    kept = {name: limits[name] for name in ("resultants", "time", "plastic_strain", "layers") if name in limits}
    if kept.keys() - {"layers"}:
        law["failure"] = kept
    if limits.keys() - kept.keys():
        deck.ledger.refuse(f"{card.keyword}.beams", use.place,
                           "beams that fail by stress, a largest strain or their step", "they do not")


def may_be_used(deck: KeywordDeck, card: Card, law: Deck, use: Use, block: Block) -> bool:
    """Whether shells, or beams, take the law."""
    if use.is_beam:
        return may_be_of_beams(deck, card, law, use)
    if law["model"] == "fabric" and (not use.is_shell or block.layers):
        text = "fabric of solids, or in layers of shells (percuss has it for membranes of one layer)"
        deck.ledger.refuse(f"{card.keyword}.solids", use.place, text, "the parts made of it are left out")
        return False
    if not use.is_shell or laws.has(law, "is_of_shells") or law["model"] == "fabric":
        return True
    deck.ledger.refuse(
        f"{card.keyword}.shells",
        use.place,
        f"shells of the material model {law['model']} (percuss has it for solids)",
        "the parts made of it are left out",
    )
    return False


def may_be_of_beams(deck: KeywordDeck, card: Card, law: Deck, use: Use) -> bool:
    """Whether beams take the law; without what they do not have, where that is allowed."""
    if not laws.takes_beams(law):
        deck.ledger.refuse(
            f"{card.keyword}.beams", use.place, f"beams of the material model {law['model']}",
            "the parts made of it are left out"
        )
        return False
    return True


def find_state(deck: KeywordDeck, part: PartCard) -> Card | None:
    if not part.state:
        return None
    if part.state not in deck.states:
        raise BadInput(part.place, missing(f"equation of state {part.state}, of part {part.id}"))
    return deck.states[part.state]


def note_unused(deck: KeywordDeck) -> None:
    """Curves that nothing uses."""
    for id, curve in deck.curves.items():
        if ("curve", id) not in deck.used:
            deck.ledger.ignored("DEFINE_CURVE", curve.place, "nothing that is translated uses it")
