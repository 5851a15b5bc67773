"""*DAMAGE INITIATION with *DAMAGE EVOLUTION, *SHEAR FAILURE and *TENSILE FAILURE: failure of elements."""

from dataclasses import dataclass

from .. import laws
from ..curves import MOST_MATERIAL_ROWS, Points, interpolate, order_points, thin_rows
from ..fields import clip
from ..ledger import BadInput
from ..model import Deck
from .deck import AbaqusDeck
from .lines import Block, Line
from .plies import add_hashin

KEYWORDS = ("DAMAGE INITIATION", "DAMAGE EVOLUTION", "SHEAR FAILURE", "TENSILE FAILURE")
LEAST_DEGRADATION = 0.9  # MAXIMUM DEGRADATION of *SECTION CONTROLS: above it what stays of the stiffness does not count
NEVER_FAILS = "there is no failure"
RAPID_FALL = 6.0  # exponent of softening by an energy: what is left at the end of it is 0.25 % of the force
LEAST_EXPONENT, MOST_EXPONENT = 1e-3, 100.0  # of failure.evolution.exponent
ALIKE = 1e-3  # factors of a rate that count as one


def take_failure(deck: AbaqusDeck, law: Deck, blocks: list[Block]) -> set[str]:
    """Keys of failure of a material; returns the keywords that are done with."""
    found = {keyword: [block for block in blocks if block.keyword == keyword] for keyword in KEYWORDS}
    failure: Deck = {}
    if found["DAMAGE INITIATION"]:
        add_damage(deck, law, failure, pair_criteria(deck, blocks))
    for block in found["SHEAR FAILURE"]:
        is_johnson = block.option("TYPE") == "JOHNSON COOK"
        failure |= read_johnson(block) if is_johnson else read_strains(deck, block, -1.0)
        deck.ledger.translated("SHEAR FAILURE", block.place, "failure of an element")
    for block in found["TENSILE FAILURE"]:
        failure["pressure"] = abs(block.number(need_line(block), 0))
        deck.ledger.translated("TENSILE FAILURE", block.place, "failure at a mean tension")
    if staying := next((block for block in blocks if block.option("ELEMENT DELETION") == "NO"), None):
        deck.ledger.refuse(f"{staying.keyword}.ELEMENT DELETION", staying.place,
                           "failed elements that stay", "they are removed")
    if ({"plastic_strain", "johnson_cook", "triaxiality", "shear"} & failure.keys()
            and not laws.has(law, "has_plastic_strain")):
        place = (found["DAMAGE INITIATION"] or found["SHEAR FAILURE"])[0].place
        raise BadInput(
            place, "failure at a plastic strain of a material that does not yield: add *PLASTIC or remove the failure")
    if failure:
        law["failure"] = failure
    return {keyword for keyword, several in found.items() if several}


def need_line(block: Block) -> Line:
    lines = [line for line in block.lines if any(line[1])]
    if not lines:
        raise BadInput(block.place, f"*{block.keyword} has no data line: add it")
    return lines[0]


@dataclass
class Criterion:
    """A start of damage with the data of its evolution."""

    start: Block
    end: Block

    @property
    def kind(self) -> str:
        return self.start.option("CRITERION")


def pair_criteria(deck: AbaqusDeck, blocks: list[Block]) -> list[Criterion]:
    """Each *DAMAGE INITIATION with the *DAMAGE EVOLUTION behind it."""
    pairs: list[Criterion] = []
    start: Block | None = None
    for block in [*blocks, None]:
        if block is not None and block.keyword == "DAMAGE EVOLUTION" and start is not None:
            pairs.append(Criterion(start, block))
            start = None
        if block is None or block.keyword == "DAMAGE INITIATION":
            if start is not None:
                deck.ledger.ignored("DAMAGE INITIATION", start.place, "without *DAMAGE EVOLUTION it is output alone")
            start = block
    return pairs


def add_damage(deck: AbaqusDeck, law: Deck, failure: Deck, pairs: list[Criterion]) -> None:
    """The start of damage; finish_failure() adds how it grows."""
    if not pairs:
        return
    start, end = pairs[0].start, pairs[0].end
    if any(pair.end.option("MIXED MODE BEHAVIOR") or pair.end.option("POWER") for pair in pairs):
        deck.ledger.refuse("DAMAGE EVOLUTION.MIXED MODE BEHAVIOR", start.place,
                           "damage of a material by a mix of modes", NEVER_FAILS)
        return
    if pairs[0].kind == "HASHIN" and len(pairs) == 1:
        failure |= {"fibre_damage": 1.0} if add_hashin(deck, law, start, [end]) else {}
        return
    criteria: Deck = {}
    for pair in pairs:
        keys = read_criterion(deck, law, pair.start)
        if keys is None:
            return
        clash = sorted(criteria.keys() & keys.keys())
        if clash:
            deck.ledger.refuse("DAMAGE INITIATION", pair.start.place,
                               f"several criteria of damage in a material that both need {' and '.join(clash)}",
                               NEVER_FAILS)
            return
        criteria |= keys
    if {"johnson_cook", "triaxiality"} <= criteria.keys():
        deck.ledger.refuse("DAMAGE INITIATION", start.place,
                           "several criteria of damage in a material, DUCTILE by a table beside JOHNSON COOK",
                           NEVER_FAILS)
        return
    if len(pairs) > 1 and (len({describe(pair.end) for pair in pairs}) > 1
                           or any(pair.end.option("DEGRADATION") == "MULTIPLICATIVE" for pair in pairs)):
        deck.ledger.refuse("DAMAGE EVOLUTION", start.place,
                           "several criteria of damage that evolve differently, or whose damages multiply", NEVER_FAILS)
        return
    failure |= criteria | {"evolution": end}  # for finish_failure, which knows the elements
    deck.ledger.translated("DAMAGE INITIATION", start.place, "failure of an element")


def describe(block: Block) -> tuple[object, ...]:
    """What two evolutions of damage have in common if they are equal."""
    rows = tuple(tuple(block.number(row, i) for i in range(3)) for row in block.lines if any(row[1]))
    return block.option("TYPE"), block.option("SOFTENING") or "LINEAR", rows


def read_criterion(deck: AbaqusDeck, law: Deck, start: Block) -> Deck | None:
    """Keys of one start of damage; None: refused."""
    if start.option("CRITERION") == "DUCTILE":
        return read_strains(deck, start, 1.0)
    if start.option("CRITERION") == "SHEAR":
        return read_shear(deck, start)
    if start.option("CRITERION") != "JOHNSON COOK":
        deck.ledger.refuse("DAMAGE INITIATION", start.place,
                           f"damage by the criterion {clip(start.option('CRITERION'))}", NEVER_FAILS)
        return None
    if law["model"] == "user_hardening":
        add_melting(law, start)
    return read_johnson(start)


def read_shear(deck: AbaqusDeck, block: Block) -> Deck:
    """Failure strains over the ratio of von Mises stress and pressure to the largest shear stress."""
    curve, rates = read_curve(deck, block, 1.0)
    shear: Deck = {"strain": [list(row) for row in curve]}
    factor = block.option("KS")
    if factor:
        shear["pressure_factor"] = block.number((block.place.line, [factor]), 0)
    return {"shear": shear} | rates


def read_johnson(block: Block) -> Deck:
    """d3 with the other sign than in Johnson and Cook's paper."""
    line = need_line(block)
    d1, d2, d3, d4, d5 = (block.number(line, i) for i in range(5))
    keys: Deck = {"d1": d1, "d2": d2, "d3": -d3, "d4": d4, "d5": d5}
    if block.number(line, 7):
        keys["reference_rate"] = block.number(line, 7)
    return {"johnson_cook": keys}


def add_melting(law: Deck, block: Block) -> None:
    """The temperatures of the criterion, which user code does not give."""
    melt, room = (block.number(need_line(block), i) for i in (5, 6))
    if melt > room:
        law |= {"room_temperature": room, "melt_temperature": melt}


def read_strains(deck: AbaqusDeck, block: Block, sign: float) -> Deck:
    """Rows of plastic strain and ratio of stresses: one strain, or a table. sign: that of the ratio."""
    table, rates = read_curve(deck, block, sign)
    if not rates and len({strain for _, strain in table}) == 1:
        return {"plastic_strain": table[0][1]}
    return {"triaxiality": [list(row) for row in table]} | rates


def read_curve(deck: AbaqusDeck, block: Block, sign: float) -> tuple[Points, Deck]:
    """Failure strains over a ratio of stresses, and the key of their factors over the rate."""
    need_line(block)
    rows = [line for line in block.lines if any(line[1])]
    first = block.number(rows[0], 3)
    if any(block.number(row, 3) != first for row in rows):
        deck.ledger.refuse(f"{block.keyword}.TEMPERATURE", block.place,
                           "failure strains that depend on the temperature", "those of the first are used")
        rows = [row for row in rows if block.number(row, 3) == first]
    if min(block.number(row, 0) for row in rows) <= 0:
        raise BadInput(block.place, f"a plastic strain of *{block.keyword} is not positive: correct it")
    curves: dict[float, Points] = {}
    for row in rows:
        curves.setdefault(block.number(row, 2), []).append((sign * block.number(row, 1), block.number(row, 0)))
    rates = sorted(curves)
    factors = [find_factor(sorted(curves[rates[0]]), sorted(curves[rate])) for rate in rates]
    keys: Deck = {"rate": [[rate, factor] for rate, factor in zip(rates, factors)]} if len(rates) > 1 else {}
    if None in factors or len(rates) > MOST_MATERIAL_ROWS:
        deck.ledger.refuse(f"{block.keyword}.RATE", block.place,
                           "failure strains whose ratio at two rates is not the same everywhere",
                           "those of the first rate are used")
        keys = {}
    table, error = thin_rows(order_points(sorted(curves[rates[0]])))
    if error > 0:
        deck.ledger.approximated(block.keyword, block.place,
                                 f"{len(table)} rows of a table of failure strains in place of "
                                 f"{len(curves[rates[0]])}, within {100 * error:.2g} %")
    return table, keys


def find_factor(first: Points, other: Points) -> float | None:
    """Factor between the strains of one rate and those of the first; None: not by one factor."""
    factors = [interpolate(other, x) / interpolate(first, x) for x, _ in [*first, *other]]
    return sum(factors) / len(factors) if max(factors) - min(factors) <= ALIKE * max(factors) else None


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
            deck.ledger.refuse("DAMAGE EVOLUTION.beams", block.place,
                               "damage of beams that evolves", "they fail at its start")
            evolution = {}
        if evolution:
            law["failure"]["evolution"] = evolution


def read_evolution(deck: AbaqusDeck, block: Block) -> Deck | None:
    """Keys of failure.evolution; empty: elements fail at the start of damage. None: refused."""
    kind, line = block.option("TYPE"), need_line(block)
    softening = block.option("SOFTENING") or "LINEAR"
    if softening == "TABULAR" and kind == "DISPLACEMENT":
        return read_lost_force(deck, block)
    if (kind not in ("DISPLACEMENT", "ENERGY") or softening not in ("LINEAR", "EXPONENTIAL")
            or len([row for row in block.lines if any(row[1])]) > 1):
        deck.ledger.refuse("DAMAGE EVOLUTION", block.place,
                           f"damage that grows by {clip(kind) or 'nothing'} {softening}, or depends on more",
                           NEVER_FAILS)
        return None
    value = block.number(line, 0)
    if value < 0:
        raise BadInput(block.place, "the displacement or energy of *DAMAGE EVOLUTION is negative: correct it")
    if value == 0:
        return {}
    keys: Deck = {kind.lower(): value}
    if kind == "ENERGY" and softening == "EXPONENTIAL":
        keys["exponent"] = RAPID_FALL
        deck.ledger.approximated("DAMAGE EVOLUTION.SOFTENING", block.place,
                                 "failure.evolution: exp(-w / G) of the work w as an exponential that ends, "
                                 f"with the exponent {RAPID_FALL:g}; within 0.5 % of the stress")
    elif kind == "ENERGY":
        deck.ledger.approximated("DAMAGE EVOLUTION", block.place,
                                 "failure.evolution: the energy by the stress of each moment, "
                                 "where Abaqus takes that at the start of damage")
    elif softening == "EXPONENTIAL":
        exponent = block.number(line, 1)
        if not 0 <= exponent <= MOST_EXPONENT:
            deck.ledger.refuse("DAMAGE EVOLUTION.SOFTENING", block.place,
                               f"an exponent of softening of {exponent:g}, not from 0 to {MOST_EXPONENT:g}",
                               "it falls along a straight line")
        elif exponent >= LEAST_EXPONENT:
            keys["exponent"] = exponent
    if kind == "DISPLACEMENT":
        deck.ledger.translated("DAMAGE EVOLUTION", block.place, "failure.evolution")
    return keys


def read_lost_force(deck: AbaqusDeck, block: Block) -> Deck | None:
    """Rows of damage and displacement."""
    rows = [line for line in block.lines if any(line[1])]
    points = [(block.number(row, 1), block.number(row, 0)) for row in rows]
    if (any(block.number(row, 2) for row in rows) or points != sorted(points) or points[0] != (0.0, 0.0)
            or points[-1][1] != 1 or points[-1][0] <= 0):
        deck.ledger.refuse("DAMAGE EVOLUTION.SOFTENING", block.place,
                           "a table of damage that does not rise from 0 at no displacement to 1, or depends on more",
                           NEVER_FAILS)
        return None
    if any(y < before for (_, before), (_, y) in zip(points, points[1:])):
        raise BadInput(block.place, "the damage of *DAMAGE EVOLUTION falls: correct it")
    last = points[-1][0]
    table, error = thin_rows(order_points([(x / last, y) for x, y in points]))
    if error > 0:
        deck.ledger.approximated("DAMAGE EVOLUTION", block.place, f"{len(table)} rows of a table of damage in place of "
                                                                  f"{len(points)}, within {100 * error:.2g} %")
    deck.ledger.translated("DAMAGE EVOLUTION", block.place, "failure.evolution")
    return {"displacement": last, "table": [list(row) for row in table]}
