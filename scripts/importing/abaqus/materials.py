"""*MATERIAL: which law of percuss it becomes."""

import math

from ..curves import order_points, thin_rows
from ..ledger import BadInput, Place, missing
from ..model import Deck
from ..rates import choose_rate, compare_curves
from .deck import AbaqusDeck, MaterialBlocks
from .heat import take_heat
from .lines import Block

INSTEAD = "it is left out"
NEVER = 1e15
HARMLESS = {"DEPVAR"}


def find(material: MaterialBlocks, keyword: str) -> Block | None:
    return next((block for block in material.parts if block.keyword == keyword), None)


def require_line(block: Block) -> tuple[int, list[str]]:
    if not block.lines:
        raise BadInput(block.place, f"*{block.keyword} has no data line: add it")
    return block.lines[0]


def translate_material(deck: AbaqusDeck, name: str, place: Place) -> Deck | None:
    """None where it is left out or refused."""
    material = deck.materials.get(name.upper())
    if material is None:
        raise BadInput(place, missing(f"material '{name}'"))
    density = find(material, "DENSITY")
    if density is None:
        raise BadInput(material.place, f"material {name} has no *DENSITY (a dynamic run needs mass): add it")
    law = translate_law(deck, name, material)
    if law is None:
        return None
    law = {"model": law.pop("model"), "density": density.number(require_line(density), 0), **law}
    if law["density"] <= 0:
        raise BadInput(density.place, "the density is not positive: correct *DENSITY")
    heat = take_heat(deck, law, material.parts)
    for block in material.parts:
        if block.keyword not in READ and block.keyword not in heat:
            instead = "there is none" if block.keyword in HARMLESS else INSTEAD
            deck.ledger.refuse(block.keyword, block.place, f"*{block.keyword} of a material", instead)
    deck.ledger.translated("MATERIAL", material.place, law["model"])
    return law


def translate_law(deck: AbaqusDeck, name: str, material: MaterialBlocks) -> Deck | None:
    elastic, rubber = find(material, "ELASTIC"), find(material, "HYPERELASTIC")
    if rubber:
        return translate_rubber(deck, rubber)
    if elastic is None or elastic.option("TYPE") not in ("", "ISOTROPIC"):
        place = elastic.place if elastic else material.place
        deck.ledger.refuse(
            "MATERIAL", place, f"material {name} is not of isotropic elasticity", "the parts made of it are left out"
        )
        return None
    line = require_line(elastic)
    law: Deck = {"model": "elastic", "youngs_modulus": elastic.number(line, 0), "poissons_ratio": elastic.number(line, 1)}
    if len(elastic.lines) > 1:
        deck.ledger.refuse("ELASTIC", elastic.place, "temperature-dependent moduli", "the first row is used")
    plastic = find(material, "PLASTIC")
    if plastic:
        add_plastic(deck, law, plastic)
        add_rate(deck, law, find(material, "RATE DEPENDENT"))
        add_rate_tables(deck, law, [block for block in material.parts if block.keyword == "PLASTIC"])
    state = find(material, "EOS")
    if state:
        add_state(deck, law, state)
    return law


def add_plastic(deck: AbaqusDeck, law: Deck, block: Block) -> None:
    """A table, Johnson and Cook's law, or kinematic hardening."""
    kind = block.option("HARDENING")
    line = require_line(block)
    if kind == "JOHNSON COOK":
        a, b, n, m, melt, room = (block.number(line, i) for i in range(6))
        law |= {"model": "johnson_cook", "a": a, "b": b, "n": n or 1.0, "m": m or 1.0,
                "melt_temperature": melt if melt > room else room + NEVER, "room_temperature": room, "start_temperature": room,
                "specific_heat": NEVER}  # fmt: skip
        deck.ledger.translated("PLASTIC", block.place, "johnson_cook; heat needs an ADIABATIC step and *INELASTIC HEAT FRACTION")
        return
    points = [(block.number(row, 1), block.number(row, 0)) for row in take_rows(deck, block)]
    if kind == "KINEMATIC" and len(points) > 1:
        (x0, y0), (x1, y1) = points[:2]
        law |= {
            "model": "combined_hardening",
            "yield_stress": y0,
            "hardening_modulus": (y1 - y0) / (x1 - x0) if x1 > x0 else 0.0,
            "kinematic_share": 1.0,
        }
        return
    if kind not in ("", "ISOTROPIC", "KINEMATIC"):
        deck.ledger.refuse("PLASTIC.HARDENING", block.place, f"hardening of type {kind}", "isotropic hardening is used")
    ascending = order_points([p for i, p in enumerate(points) if i == 0 or p[0] > points[i - 1][0]])
    if len(ascending) == 1:
        law |= {"model": "j2_plasticity", "yield_stress": ascending[0][1]}
        return
    rows, error = thin_rows(ascending)
    if error > 1e-12:
        deck.ledger.approximated(
            "PLASTIC", block.place, f"{len(points)} rows become {len(rows)}, within {error:.2g} of the largest stress"
        )
    law |= {"model": "tabulated_plasticity", "hardening": [list(row) for row in rows]}


def take_rows(deck: AbaqusDeck, block: Block) -> list[tuple[int, list[str]]]:
    """Rows of the first temperature."""
    rows = [row for row in block.lines if block.number(row, 2) == block.number(block.lines[0], 2)]
    if len(rows) < len(block.lines):
        deck.ledger.refuse("PLASTIC.TEMPERATURE", block.place, "a table for several temperatures", "that of the first one is used")
    return rows


def add_rate(deck: AbaqusDeck, law: Deck, block: Block | None) -> None:
    """Cowper and Symonds' power law, or C and the rate of Johnson and Cook's."""
    if block is None:
        return
    line = require_line(block)
    kind = block.option("TYPE") or "POWER LAW"
    if kind == "JOHNSON COOK" and law["model"] == "johnson_cook":
        law |= {"c": block.number(line, 0), "reference_rate": block.number(line, 1) or 1.0}
    elif kind == "POWER LAW" and law["model"] != "johnson_cook":
        if law["model"] == "j2_plasticity":
            law |= {"model": "combined_hardening", "kinematic_share": 0.0}
        law |= {"cowper_symonds_rate": block.number(line, 0), "cowper_symonds_exponent": block.number(line, 1) or 1.0}
    else:
        deck.ledger.refuse("RATE DEPENDENT", block.place, f"a dependence on the rate of the kind {kind}", "there is none")


def add_rate_tables(deck: AbaqusDeck, law: Deck, blocks: list[Block]) -> None:
    """*PLASTIC, RATE=: a table for each rate. The first one is that of the law."""
    if len(blocks) == 1 and "RATE" in blocks[0].options:
        deck.ledger.refuse("PLASTIC.RATE", blocks[0].place, "a table for one rate alone", "it is used at all rates")
    if len(blocks) < 2 or law["model"] == "johnson_cook":
        return
    tables = []
    for block in blocks:
        rate = block.number((block.place.line, [block.options.get("RATE", "")]), 0)
        tables.append((rate, order_points([(block.number(row, 1), block.number(row, 0)) for row in take_rows(deck, block)])))
    if any(not points for _, points in tables):
        raise BadInput(blocks[0].place, "*PLASTIC has no data line: add it")
    keys = choose_rate(deck.ledger, blocks[1].place, compare_curves(tables), "PLASTIC.RATE", "tables for several rates")
    if keys and law["model"] == "j2_plasticity":
        law |= {"model": "combined_hardening", "kinematic_share": 0.0}
    law |= keys or {}


def add_state(deck: AbaqusDeck, law: Deck, block: Block) -> None:
    line = require_line(block)
    if block.option("TYPE") != "USUP":
        deck.ledger.refuse("EOS", block.place, f"an equation of state of type {block.option('TYPE')}", "the law alone is used")
        return
    law["equation_of_state"] = {"kind": "mie_grueneisen", "sound_speed": block.number(line, 0), "slope": block.number(line, 1),
                                "grueneisen": block.number(line, 2)}  # fmt: skip


def translate_rubber(deck: AbaqusDeck, block: Block) -> Deck | None:
    """NEO HOOKE or MOONEY-RIVLIN with constants: K = 2 / D1."""
    line = require_line(block)
    is_mooney, is_neo = bool({"MOONEY-RIVLIN", "POLYNOMIAL"} & set(block.options)), "NEO HOOKE" in block.options
    c10, c01, d1 = block.number(line, 0), block.number(line, 1) if is_mooney else 0.0, block.number(line, 2 if is_mooney else 1)
    if (
        not (is_mooney or is_neo)
        or "TEST DATA INPUT" in block.options
        or not (c10 > 0 and c01 >= 0 and d1 > 0)
        or math.isinf(2 / d1)
    ):
        deck.ledger.refuse(
            "HYPERELASTIC", block.place, "rubber without constants C10, C01 and D1 above 0", "the parts made of it are left out"
        )
        return None
    deck.ledger.approximated(
        "HYPERELASTIC", block.place, "the same constants and bulk modulus 2 / D1, with percuss' term of volume"
    )
    return {"model": "mooney_rivlin", "c10": c10, "c01": c01, "bulk_modulus": 2 / d1}


READ = {"DAMPING", "DENSITY", "ELASTIC", "PLASTIC", "RATE DEPENDENT", "EOS", "HYPERELASTIC"}
