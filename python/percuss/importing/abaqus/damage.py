"""*DAMAGE INITIATION with *DAMAGE EVOLUTION, *SHEAR FAILURE and *TENSILE FAILURE: failure of elements."""

import math
from collections.abc import Callable
from typing import Any

from .. import laws
from ..curves import interpolate
from ..fields import clip
from ..ledger import BadInput
from ..model import Deck
from ..shapes import shell_area, solid_volume
from .deck import AbaqusDeck
from .lines import Block
from .plies import add_hashin

KEYWORDS = ("DAMAGE INITIATION", "DAMAGE EVOLUTION", "SHEAR FAILURE", "TENSILE FAILURE")
CLOSE = 0.1  # error of a fitted curve of failure strains that is an approximation
LEAST_DEGRADATION = 0.9  # of *SECTION CONTROLS: above it what stays of the stiffness does not count
NEVER_FAILS = "there is no failure"
Curve = list[tuple[float, float]]  # mean stress over von Mises, plastic strain


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
    if {"plastic_strain", "johnson_cook"} & failure.keys() and not laws.has(law, "has_plastic_strain"):
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
    """An element fails where its damage is complete: after its start by the displacement of *DAMAGE EVOLUTION."""
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


def read_strains(deck: AbaqusDeck, block: Block, sign: float) -> Deck:
    """Rows of plastic strain and ratio of stresses: one strain, or a curve of Johnson and Cook. sign: that of the ratio."""
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
    keys, error = fit_johnson(curve)
    text = f"Johnson and Cook's curve with d1 = {keys['d1']:.4g}, d2 = {keys['d2']:.4g} and d3 = {keys['d3']:.4g}, within {100 * error:.2g} %"
    if error <= CLOSE:
        deck.ledger.approximated(block.keyword, block.place, f"failure strains by {text}")
    elif not deck.ledger.refuse(f"{block.keyword}.table", block.place, "a table of failure strains far from an exponential curve", text):
        return {}
    return {"johnson_cook": keys}


def fit_johnson(curve: Curve) -> tuple[Deck, float]:
    """d1 + d2 exp(d3 ratio) that has the least largest error, as a share of the strain; d1 and d2 are not negative."""
    first, last = curve[0][0], curve[-1][0]
    places = [first + (last - first) * i / 40 for i in range(41)]
    strains = [interpolate(curve, x) for x in places]
    best: tuple[float, float, float, float] = (math.inf, 0.0, 0.0, 0.0)
    for i in range(1, 61):
        for d3 in (-0.15 * i, 0.15 * i):
            shape = [math.exp(d3 * x) for x in places]
            weights = [1 / s for s in strains]
            d1, d2 = solve_two(weights, [w * e for w, e in zip(weights, shape)])
            error = max(abs((d1 + d2 * e) / s - 1) for e, s in zip(shape, strains))
            best = min(best, (error, d1, d2, d3))
    return {"d1": best[1], "d2": best[2], "d3": best[3]}, best[0]


def solve_two(a: list[float], b: list[float]) -> tuple[float, float]:
    """Least squares of x a + y b = 1, x and y not negative."""
    aa, ab, bb = (sum(p * q for p, q in zip(u, v)) for u, v in ((a, a), (a, b), (b, b)))
    sa, sb = sum(a), sum(b)
    determinant = aa * bb - ab * ab
    x = (sa * bb - sb * ab) / determinant if determinant > 1e-12 * aa * bb else -1.0
    y = (sb * aa - sa * ab) / determinant if determinant > 1e-12 * aa * bb else -1.0
    if x >= 0 and y >= 0:
        return x, y
    return (sa / aa, 0.0) if y < 0 <= x or sb <= 0 else (0.0, sb / bb)


def finish_failure(deck: AbaqusDeck) -> None:
    """The strain over which damage grows: the displacement of *DAMAGE EVOLUTION over the size of the elements."""
    for name, law in deck.model.materials.items():
        block = law.get("failure", {}).pop("evolution", None)
        if block is None:
            continue
        size = find_size(deck, name)
        way = find_way(deck, law, block)
        if way is None or size <= 0:
            del law["failure"]
            continue
        more = way / size
        law["failure"] = {**law["failure"]}
        if "plastic_strain" in law["failure"]:
            law["failure"]["plastic_strain"] += more
        else:
            law["failure"]["johnson_cook"] = {**law["failure"]["johnson_cook"], "d1": law["failure"]["johnson_cook"]["d1"] + more}
        deck.ledger.approximated(
            "DAMAGE EVOLUTION", block.place,
            f"an element keeps its stress and fails {more:.4g} of plastic strain after the damage starts: {way:.4g} over the mean size {size:.4g}",
        )  # fmt: skip


def find_way(deck: AbaqusDeck, law: Deck, block: Block) -> float | None:
    """The plastic displacement until failure; of an energy that of a stress that falls linearly from the yield stress."""
    kind, line = block.option("TYPE"), need_line(block)
    if kind not in ("DISPLACEMENT", "ENERGY") or len([row for row in block.lines if any(row[1])]) > 1 or block.option("SOFTENING") == "TABULAR":
        deck.ledger.refuse("DAMAGE EVOLUTION", block.place, f"damage that grows by {clip(kind) or 'nothing'}, or by a table", NEVER_FAILS)
        return None
    value = block.number(line, 0)
    if value < 0:
        raise BadInput(block.place, "the displacement or energy of *DAMAGE EVOLUTION is negative: correct it")
    if kind == "DISPLACEMENT":
        return value
    stress: Any = law.get("yield_stress") or law.get("a") or max((row[1] for row in law.get("hardening", [])), default=0.0)
    return 2 * value / stress if stress > 0 else 0.0


def find_size(deck: AbaqusDeck, material: str) -> float:
    """The mean edge of the elements of a material."""
    nodes = deck.model.nodes
    sizes: list[float] = []
    measures: tuple[tuple[str, Callable], ...] = (("solids", lambda x: solid_volume(x) ** (1 / 3)), ("shells", lambda x: shell_area(x) ** 0.5))
    for block in deck.model.blocks:
        if block.keys["material"] == material:
            for kind, measure in measures:
                sizes += [measure([nodes[n] for n in corners[:8] if len(corners) != 10 or n in corners[:4]]) for _, corners in getattr(block, kind)]
    return math.fsum(sizes) / len(sizes) if sizes else 0.0
