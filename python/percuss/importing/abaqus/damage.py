"""*DAMAGE INITIATION with *DAMAGE EVOLUTION, *SHEAR FAILURE and *TENSILE FAILURE: failure of elements."""

from .. import laws
from ..curves import order_points, thin_rows
from ..fields import clip
from ..ledger import BadInput
from ..model import Deck
from .deck import AbaqusDeck
from .lines import Block
from .plies import add_hashin

KEYWORDS = ("DAMAGE INITIATION", "DAMAGE EVOLUTION", "SHEAR FAILURE", "TENSILE FAILURE")
LEAST_DEGRADATION = 0.9  # of *SECTION CONTROLS: above it what stays of the stiffness does not count
NEVER_FAILS = "there is no failure"


def take_failure(deck: AbaqusDeck, name: str, law: Deck, blocks: list[Block]) -> set[str]:
    """Keys of failure of a material; returns the keywords that are done with."""
    found = {keyword: [block for block in blocks if block.keyword == keyword] for keyword in KEYWORDS}
    failure: Deck = {}
    if found["DAMAGE INITIATION"]:
        add_damage(deck, law, failure, found["DAMAGE INITIATION"], found["DAMAGE EVOLUTION"])
    for block in found["SHEAR FAILURE"]:
        is_johnson = block.option("TYPE") == "JOHNSON COOK"
        failure |= read_johnson(block) if is_johnson else read_strains(deck, block, -1.0)
        deck.ledger.translated("SHEAR FAILURE", block.place, "failure of an element")
    for block in found["TENSILE FAILURE"]:
        failure["pressure"] = abs(block.number(need_line(block), 0))
        deck.ledger.translated("TENSILE FAILURE", block.place, "failure at a mean tension")
    if any(block.option("ELEMENT DELETION") == "NO" for block in blocks):
        deck.ledger.refuse("SHEAR FAILURE.ELEMENT DELETION", blocks[0].place, "failed elements that stay", "they are removed")
    if {"plastic_strain", "johnson_cook", "triaxiality"} & failure.keys() and not laws.has(law, "has_plastic_strain"):
        place = (found["DAMAGE INITIATION"] or found["SHEAR FAILURE"])[0].place
        raise BadInput(place, "failure at a plastic strain of a material that does not yield: add *PLASTIC or remove the failure")
    if failure:
        law["failure"] = failure
    return {keyword for keyword, several in found.items() if several}


def need_line(block: Block) -> tuple[int, list[str]]:
    lines = [line for line in block.lines if any(line[1])]
    if not lines:
        raise BadInput(block.place, f"*{block.keyword} has no data line: add it")
    return lines[0]


def add_damage(deck: AbaqusDeck, law: Deck, failure: Deck, starts: list[Block], ends: list[Block]) -> None:
    """The start of damage; finish_failure() adds how it grows."""
    start = starts[0]
    if not ends:
        deck.ledger.ignored("DAMAGE INITIATION", start.place, "without *DAMAGE EVOLUTION it is output alone")
        return
    if any(end.option("MIXED MODE BEHAVIOR") or end.option("POWER") for end in ends):
        deck.ledger.refuse("DAMAGE EVOLUTION.MIXED MODE BEHAVIOR", start.place, "damage of a material by a mix of modes", NEVER_FAILS)
        return
    kinds = {"DUCTILE": lambda: read_strains(deck, start, 1.0), "JOHNSON COOK": lambda: read_johnson(start)}
    kind = start.option("CRITERION")
    if kind == "HASHIN" and len(starts) == 1:
        failure |= {"fibre_damage": 1.0} if add_hashin(deck, law, start, ends) else {}
        return
    if kind not in kinds or len(starts) > 1:
        what = f"damage by the criterion {clip(kind)}" if len(starts) == 1 else "several criteria of damage in a material"
        deck.ledger.refuse("DAMAGE INITIATION", start.place, what, NEVER_FAILS)
        return
    failure |= kinds[kind]()
    if kind == "JOHNSON COOK" and law["model"] == "user_hardening":
        add_melting(law, start)
    if failure:
        failure["evolution"] = ends[0]  # for finish_failure, which knows the elements
        deck.ledger.translated("DAMAGE INITIATION", start.place, "failure of an element")


def read_johnson(block: Block) -> Deck:
    """d3 with the other sign than in Johnson and Cook's paper."""
    line = need_line(block)
    d1, d2, d3, d4, d5 = (block.number(line, i) for i in range(5))
    keys: Deck = {"d1": d1, "d2": d2, "d3": -d3, "d4": d4, "d5": d5}
    if block.number(line, 7):
        keys["reference_rate"] = block.number(line, 7)
    return {"johnson_cook": keys}


def add_melting(law: Deck, block: Block) -> None:
    """The temperatures of the criterion, which user code does not tell."""
    melt, room = (block.number(need_line(block), i) for i in (5, 6))
    if melt > room:
        law |= {"room_temperature": room, "melt_temperature": melt}


def read_strains(deck: AbaqusDeck, block: Block, sign: float) -> Deck:
    """Rows of plastic strain and ratio of stresses: one strain, or a table. sign: that of the ratio."""
    need_line(block)
    rows = [line for line in block.lines if any(line[1])]
    for column, what in ((2, "the rate"), (3, "the temperature")):
        first = block.number(rows[0], column)
        if any(block.number(row, column) != first for row in rows):
            key = f"{block.keyword}.{'RATE' if column == 2 else 'TEMPERATURE'}"
            deck.ledger.refuse(key, block.place, f"failure strains that depend on {what}", "those of the first are used")
            rows = [row for row in rows if block.number(row, column) == first]
    curve = sorted((sign * block.number(row, 1), block.number(row, 0)) for row in rows)
    if min(strain for _, strain in curve) <= 0:
        raise BadInput(block.place, f"a plastic strain of *{block.keyword} is not positive: correct it")
    if len({strain for _, strain in curve}) == 1:
        return {"plastic_strain": curve[0][1]}
    table, error = thin_rows(order_points(curve))
    if error > 0:
        deck.ledger.approximated(block.keyword, block.place, f"{len(table)} rows of a table of failure strains in place of {len(curve)}, within {100 * error:.2g} %")
    return {"triaxiality": [list(row) for row in table]}


def finish_failure(deck: AbaqusDeck) -> None:
    """How an element loses its force: the displacement or energy of *DAMAGE EVOLUTION."""
    for name, law in deck.model.materials.items():
        block = law.get("failure", {}).pop("evolution", None)
        if block is None:
            continue
        law["failure"] = {**law["failure"]}
        evolution = read_evolution(deck, block)
        if evolution is None:
            del law["failure"]
            continue
        if evolution and any(part.beams and part.keys["material"] == name for part in deck.model.blocks):
            deck.ledger.refuse("DAMAGE EVOLUTION.beams", block.place, "damage of beams that evolves", "they fail at its start")
            evolution = {}
        if evolution:
            law["failure"]["evolution"] = evolution


def read_evolution(deck: AbaqusDeck, block: Block) -> Deck | None:
    """Keys of failure.evolution; empty: elements fail at the start of damage. None: refused."""
    kind, line = block.option("TYPE"), need_line(block)
    if kind not in ("DISPLACEMENT", "ENERGY") or len([row for row in block.lines if any(row[1])]) > 1 or block.option("SOFTENING") == "TABULAR":
        deck.ledger.refuse("DAMAGE EVOLUTION", block.place, f"damage that grows by {clip(kind) or 'nothing'}, or by a table", NEVER_FAILS)
        return None
    value = block.number(line, 0)
    if value < 0:
        raise BadInput(block.place, "the displacement or energy of *DAMAGE EVOLUTION is negative: correct it")
    if block.option("SOFTENING") == "EXPONENTIAL":
        deck.ledger.refuse("DAMAGE EVOLUTION.SOFTENING", block.place, "stress that falls exponentially", "it falls along a straight line")
    if value == 0:
        return {}
    if kind == "ENERGY":
        deck.ledger.approximated("DAMAGE EVOLUTION", block.place, "failure.evolution: the energy by the stress of each moment, where Abaqus takes that at the start of damage")
    else:
        deck.ledger.translated("DAMAGE EVOLUTION", block.place, "failure.evolution")
    return {kind.lower(): value}
