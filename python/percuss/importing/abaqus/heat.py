"""Temperatures: of Johnson and Cook's law and of user code, heated by plastic work without conduction."""

import math
from itertools import combinations

from ..laws import has
from ..ledger import Place
from ..model import Block as ModelBlock
from ..model import Deck
from .deck import AbaqusDeck
from .lines import Block

CONDUCTING = "DYNAMIC TEMPERATURE-DISPLACEMENT"
KEYWORDS = ("INELASTIC HEAT FRACTION", "SPECIFIC HEAT", "CONDUCTIVITY", "EXPANSION")
# diffusivity times the time of the run, over the square of an edge: a quarter of it, which no mesh resolves
MOST_DIFFUSION = 0.0625
NO_STEP = "no temperature changes: the step is not ADIABATIC"


def read_procedure(deck: AbaqusDeck, block: Block) -> None:
    """Whether plastic work heats, and what of the heat is not computed."""
    if block.keyword == CONDUCTING:
        deck.conducting_place = deck.conducting_place or block.place
    deck.heats = deck.heats or block.keyword == CONDUCTING or "ADIABATIC" in block.options


def take_heat(deck: AbaqusDeck, law: Deck, blocks: list[Block]) -> set[str]:
    """Keys of heating of a material; returns the keywords that are done with."""
    found = {block.keyword: block for block in blocks if block.keyword in KEYWORDS}
    share, capacity = found.get("INELASTIC HEAT FRACTION"), found.get("SPECIFIC HEAT")
    is_warm = has(law, "has_temperature")
    gets_warm = is_warm and share is not None and capacity is not None
    for keyword, block in found.items():
        if not deck.heats:
            deck.ledger.ignored(keyword, block.place, NO_STEP)
        elif keyword == "CONDUCTIVITY":
            deck.ledger.ignored(keyword, block.place, "the report says of the step that heat is not conducted")
        elif keyword == "EXPANSION":
            add_expansion(deck, law, block, gets_warm)
        elif is_warm:
            deck.ledger.translated(keyword, block.place, f"specific_heat and heating_share of {law['model']}")
        else:
            deck.ledger.ignored(keyword, block.place, "the law does not depend on the temperature")
    if deck.heats and is_warm and share and capacity and share.lines and capacity.lines:
        law |= {"specific_heat": capacity.number(capacity.lines[0], 0),
                "heating_share": share.number(share.lines[0], 0, 0.9)}
        law["start_temperature"] = 0.0  # of Abaqus, where *INITIAL CONDITIONS gives none
        if law["model"] == "user":
            text = "the heat of the inelastic energy that the VUMAT reports (enerInelasNew), at the end of a step"
            deck.ledger.approximated("INELASTIC HEAT FRACTION", share.place, text)
    return set(found)


def add_expansion(deck: AbaqusDeck, law: Deck, block: Block, gets_warm: bool) -> None:
    """*EXPANSION: one coefficient, from the temperature at the start on."""
    if block.option("TYPE") not in ("", "ISO") or len(block.lines) != 1 or "USER" in block.options:
        deck.ledger.refuse("EXPANSION", block.place,
                           "thermal expansion by a table, by directions or by user code", "there is none")
    elif not gets_warm:
        deck.ledger.ignored("EXPANSION", block.place,
                            "no temperature changes: the material has no plastic work that heats")
    elif "equation_of_state" in law:
        deck.ledger.refuse("EXPANSION", block.place, "thermal expansion beside *EOS", "there is none")
    elif block.number(block.lines[0], 0) < 0:
        deck.ledger.refuse("EXPANSION", block.place,
                           "a material that shrinks where it gets warm", "there is no expansion")
    else:
        law["thermal_expansion"] = block.number(block.lines[0], 0)
        deck.ledger.translated("EXPANSION", block.place, "thermal_expansion")


def keep_shells(deck: AbaqusDeck, law: Deck, place: Place) -> Deck:
    """The law of shells, which do not expand."""
    if not law.get("thermal_expansion"):
        return law
    deck.ledger.refuse("EXPANSION.shells", place, "thermal expansion of shells", "they do not expand")
    return {key: value for key, value in law.items() if key != "thermal_expansion"}


def check_conduction(deck: AbaqusDeck) -> None:
    """Conduction is left out where heat hardly moves in the time of the run; otherwise it is refused."""
    place = deck.conducting_place
    if place is None:
        return
    shares = [share for material, names in deck.names_of_laws.items()
              for share in find_diffusion(deck, material, set(names))]
    worst = max(shares, default=0.0)
    if worst == 0:
        deck.ledger.ignored(CONDUCTING, place, "no heat moves from element to element that changes a stress")
    elif worst <= MOST_DIFFUSION:
        text = (f"each point keeps its heat: it would move by {math.sqrt(worst):.2g} of the shortest edge "
                "(the root of diffusivity times time)")
        deck.ledger.approximated(CONDUCTING, place, text)
    else:
        what = (f"conduction of heat, which moves by {math.sqrt(worst):.2g} of the shortest edge in the time of the "
                f"run (up to {math.sqrt(MOST_DIFFUSION):g} it is left out)")
        deck.ledger.refuse(CONDUCTING, place, what, "plastic work heats each point alone, as with ADIABATIC")


def find_diffusion(deck: AbaqusDeck, material: str, names: set[str]) -> list[float]:
    """Fourier numbers of the parts of a material, by the time of the run and the shortest edge."""
    parts = deck.materials[material.upper()].parts if material.upper() in deck.materials else []
    values = {block.keyword: [block.number(line, 0) for line in block.lines] for block in parts}
    conductivity = max(values.get("CONDUCTIVITY", []), default=0.0)
    capacity = min(values.get("SPECIFIC HEAT", []), default=0.0) * min(values.get("DENSITY", []), default=0.0)
    has_one_element = sum(len(part.elements()) for part in deck.model.blocks) == 1  # which has one temperature
    if conductivity <= 0 or has_one_element:
        return []
    laws = deck.model.materials
    of_material = [part for part in deck.model.blocks
                   if part.keys["material"] in names and has(laws[part.keys["material"]], "has_temperature")]
    if capacity <= 0:
        return [math.inf for _ in of_material]
    return [conductivity / capacity * deck.end_time / find_shortest_edge(deck, part) ** 2 for part in of_material]


def find_shortest_edge(deck: AbaqusDeck, part: ModelBlock) -> float:
    """The least distance of two corners of an element that are apart."""
    lengths = (math.dist(deck.mesh.nodes[a], deck.mesh.nodes[b]) for _, corners in part.elements()
               for a, b in combinations(corners, 2))
    return min((length for length in lengths if length > 0), default=math.inf)


def note_temperatures(deck: AbaqusDeck, blocks: list[Block]) -> None:
    """Temperatures of nodes, before the materials are made."""
    for block in blocks:
        if block.keyword == "INITIAL CONDITIONS" and block.option("TYPE") == "TEMPERATURE":
            read_temperature(deck, block)


def read_temperature(deck: AbaqusDeck, block: Block) -> None:
    """*INITIAL CONDITIONS, TYPE=TEMPERATURE: of nodes; apply_temperatures() does the rest."""
    for line in block.lines:
        value = block.number(line, 1)
        deck.temperatures.update(dict.fromkeys(deck.nodes_of(block.text(line, 0), block.at(line[0])), value))
    deck.temperature_place = block.place


def apply_temperatures(deck: AbaqusDeck) -> None:
    """One temperature is that of the laws; several are a table, of each element the mean of its nodes."""
    place = deck.temperature_place
    if place is None:
        return
    materials = deck.model.materials
    warm = [block for block in deck.model.blocks if has(materials[block.keys["material"]], "has_temperature")]
    nodes = {node for block in warm for _, corners in block.elements() for node in corners}
    values = {deck.temperatures.get(node, 0.0) for node in nodes}  # 0 in Abaqus where none is given
    if not warm:
        deck.ledger.ignored("INITIAL CONDITIONS", place, "a temperature, on which no law depends")
        return
    for block in warm:
        law = materials[block.keys["material"]]
        # of 0 user code keeps none
        lowest = min(values) if law["model"] == "johnson_cook" else min(values) or max(values)
        law["start_temperature"] = limit_temperature(deck, law, lowest, place)
    models = sorted({materials[block.keys["material"]]["model"] for block in warm})
    deck.ledger.translated("INITIAL CONDITIONS", place, f"start_temperature of {', '.join(models)}")
    if len(values) > 1:
        add_element_temperatures(deck, warm, place)


def limit_temperature(deck: AbaqusDeck, law: Deck, value: float, place: Place) -> float:
    """A law begins below its melting temperature: otherwise with the temperature of its constants."""
    melt = law.get("melt_temperature", math.inf)  # user code gives none
    if value < melt:
        return value
    deck.ledger.refuse(
        "INITIAL CONDITIONS.melt", place, f"a temperature of {value:g}, where johnson_cook melts at {melt:g}",
        "these elements begin with the transition temperature",
    )  # fmt: skip
    return float(law["room_temperature"])


def add_element_temperatures(deck: AbaqusDeck, warm: list[ModelBlock], place: Place) -> None:
    rows: dict[int, list[str]] = {}
    for block in warm:
        for id, corners in block.elements():
            if len(corners) == 10:
                deck.ledger.refuse(
                    "INITIAL CONDITIONS.ten_nodes", place, "temperatures that differ, of tetrahedra of ten nodes",
                    "that of the material is used"
                )
                continue
            value = math.fsum(deck.temperatures.get(node, 0.0) for node in corners) / len(corners)
            value = limit_temperature(deck, deck.model.materials[block.keys["material"]], value, place)
            rows[id] = [f"{id},{value!r}"]
    if rows:
        deck.model.add_start_rows("temperatures.csv", "element,temperature", rows)
        deck.ledger.approximated("INITIAL CONDITIONS.several", place,
                                 "start.fields: of each element the mean of its nodes")
