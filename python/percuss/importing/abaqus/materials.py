"""*MATERIAL: which law of percuss it becomes."""

from ..curves import order_points, thin_rows
from ..fields import clip
from ..laws import hardens_isotropically
from ..ledger import BadInput, Place, missing
from ..model import Deck
from ..rates import add_rates, order_curves, scale_curve
from . import user_code
from .cyclic import add_combined
from .damage import take_failure
from .deck import AbaqusDeck, MaterialBlocks
from .heat import take_heat
from .lines import Block, Line, require_line
from .one_temperature import settle_temperature
from .plies import COUNTS, read_constants
from .rubbers import translate_hyperfoam, translate_rubber
from .voids import add_voids

INSTEAD = "it is left out"
NEVER = 1e15
MOST_RELAXATIONS = 6
OF_OUTPUT = {"DEPVAR", "USER OUTPUT VARIABLES"}
SEVERAL = {"PLASTIC", "DAMAGE INITIATION", "DAMAGE EVOLUTION"}


def find(material: MaterialBlocks, keyword: str) -> Block | None:
    return next((block for block in material.parts if block.keyword == keyword), None)


def density_lines(material: MaterialBlocks) -> list[Line]:
    block = find(material, "DENSITY")
    return block.lines if block else []


def translate_material(deck: AbaqusDeck, name: str, place: Place) -> Deck | None:
    """None where it is left out or refused."""
    material = deck.materials.get(name.upper())
    if material is None:
        raise BadInput(place, missing(f"material '{clip(name)}'"))
    deck.used_materials.add(name.upper())
    material = settle_temperature(deck, name, material)
    density = find(material, "DENSITY")
    if density is None:
        raise BadInput(material.place, f"material {clip(name)} has no *DENSITY (a dynamic run needs mass): add it")
    law = translate_law(deck, name, material)
    if law is None:
        return None
    law = {"model": law.pop("model"), "density": density.number(require_line(density), 0), **law}
    if law["density"] <= 0:
        raise BadInput(density.place, "the density is not positive: correct *DENSITY")
    done = add_voids(deck, law, material)
    done |= take_heat(deck, law, material.parts) | take_failure(deck, law, material.parts) | READ
    refuse_several(material)
    for block in material.parts:
        if block.keyword in OF_OUTPUT and not (block.keyword == "DEPVAR" and user_code.is_user_code(material)):
            what = ("names of output variables" if user_code.is_user_code(material)
                    else "variables of user code, of which there is none")
            deck.ledger.ignored(block.keyword, block.place, what)
        elif block.keyword == "CHARACTERISTIC LENGTH" and law["model"] == "user":
            user_code.add_lengths(deck, law, block)
        elif block.keyword == "USER DEFINED FIELD" and law["model"] in user_code.LAWS:
            user_code.add_fields(deck, law, block)
        elif block.keyword not in done:
            deck.ledger.refuse(block.keyword, block.place, f"*{block.keyword} of a material", INSTEAD)
    deck.ledger.translated("MATERIAL", material.place, law["model"])
    return law


def refuse_several(material: MaterialBlocks) -> None:
    """A keyword that stands twice: which one counts is not known."""
    seen: dict[str, Block] = {}
    for block in material.parts:
        if block.keyword in seen and block.keyword not in SEVERAL:
            text = (f"*{block.keyword} stands twice in one material (also in line {seen[block.keyword].place.line}): "
                    "remove one, or add *MATERIAL")
            raise BadInput(block.place, text)
        seen[block.keyword] = block


def translate_law(deck: AbaqusDeck, name: str, material: MaterialBlocks) -> Deck | None:
    elastic, rubber, foam = find(material, "ELASTIC"), find(material, "HYPERELASTIC"), find(material, "HYPERFOAM")
    state = find(material, "EOS")
    user = find(material, "USER MATERIAL")
    if user:
        return user_code.translate_user_code(deck, name, user, find(material, "DEPVAR"))
    relaxing = find(material, "VISCOELASTIC")
    if (rubber or foam) and relaxing:
        deck.ledger.refuse("VISCOELASTIC.rubber", relaxing.place, "viscoelasticity of rubber and of foam",
                           "the material does not relax")
    if rubber:
        return translate_rubber(deck, rubber)
    if foam:
        return translate_hyperfoam(deck, foam)
    if state and (elastic is None or elastic.option("TYPE") == "SHEAR"):
        return translate_fluid(deck, material, state, elastic)
    if elastic and elastic.option("TYPE") in COUNTS:
        for block in [block for block in material.parts
                      if block.keyword in ("PLASTIC", "VISCOELASTIC", "EOS", "RATE DEPENDENT")]:
            deck.ledger.refuse(f"{block.keyword}.orthotropic", block.place,
                               f"*{block.keyword} with orthotropic elasticity", INSTEAD)
        return read_constants(deck, elastic)
    if elastic is None or elastic.option("TYPE") not in ("", "ISOTROPIC"):
        place = elastic.place if elastic else material.place
        what = (f"elasticity of the type {clip(elastic.option('TYPE'))}" if elastic
                else "no *ELASTIC, *HYPERELASTIC or *EOS that is read")
        deck.ledger.refuse("MATERIAL", place, f"material {clip(name)} has {what}", "the parts made of it are left out")
        return None
    line = require_line(elastic)
    law: Deck = {"model": "elastic", "youngs_modulus": elastic.number(line, 0),
                 "poissons_ratio": elastic.number(line, 1)}
    if len(elastic.lines) > 1 or len(density_lines(material)) > 1:
        deck.ledger.refuse("ELASTIC", elastic.place,
                           "moduli or a density that depend on the temperature", "the first row is used")
    plastic = find(material, "PLASTIC")
    if plastic and user_code.is_user_hardening(plastic):
        return add_user_hardening(deck, name, law, plastic, material)
    if plastic:
        add_plastic(deck, law, plastic, find(material, "CYCLIC HARDENING"))
        add_rate(deck, law, find(material, "RATE DEPENDENT"))
        add_rate_tables(deck, law, [block for block in material.parts if block.keyword == "PLASTIC"])
    add_potential(deck, law, find(material, "POTENTIAL"), state)
    if state:
        add_state(deck, law, state)
    if relaxing:
        return relax(deck, law, elastic, relaxing)
    return law


def add_user_hardening(deck: AbaqusDeck, name: str, law: Deck, plastic: Block, material: MaterialBlocks) -> Deck | None:
    """*PLASTIC, HARDENING=USER: the code knows the rate; nothing else changes the yield stress."""
    for keyword in ("RATE DEPENDENT", "POTENTIAL", "EOS", "VISCOELASTIC"):
        block = find(material, keyword)
        if block:
            deck.ledger.refuse(f"{keyword}.user", block.place, f"*{keyword} with hardening by user code", INSTEAD)
    return user_code.translate_hardening(deck, name, law, plastic, find(material, "DEPVAR"))


def add_potential(deck: AbaqusDeck, law: Deck, block: Block | None, state: Block | None) -> None:
    """*POTENTIAL: R11 R22 R33 R12 R13 R23, yield stresses over that of *PLASTIC."""
    if block is None:
        return
    lines = [line for line in block.lines if any(line[1])]
    if not lines:
        raise BadInput(block.place, "*POTENTIAL has no data line: add six ratios")
    ratios = [block.number(lines[0], i) for i in range(6)]
    if min(ratios) <= 0:
        raise BadInput(block.at(lines[0][0]), "a ratio of *POTENTIAL is not positive: correct it")
    if len(lines) > 1:
        deck.ledger.refuse("POTENTIAL.TEMPERATURE", block.place,
                           "ratios that depend on the temperature", "the first row is used")
    if all(ratio == 1 for ratio in ratios):
        deck.ledger.ignored("POTENTIAL", block.place, "all ratios are 1: the yield of von Mises")
        return
    rows = law.get("hardening") or [[0.0, law.get("yield_stress", 0.0)]]
    if not hardens_isotropically(law) or law.get("hardening_modulus") or state:
        deck.ledger.refuse("POTENTIAL", block.place,
                           "ratios of yield stress with another law than a table of isotropic hardening, or with *EOS",
                           "it yields alike in all directions")
        return
    for key in ("yield_stress", "kinematic_share", "hardening_modulus"):
        law.pop(key, None)
    law |= {"model": "anisotropic_plasticity", "hardening": rows, "yield_ratios": ratios[:3],
            "shear_yield_ratios": [ratios[3], ratios[5], ratios[4]]}
    deck.ledger.translated("POTENTIAL", block.place, "yield_ratios of anisotropic_plasticity")


def translate_fluid(deck: AbaqusDeck, material: MaterialBlocks, state: Block, shear: Block | None) -> Deck:
    """An equation of state alone, or with a shear modulus:
    then Young's modulus follows from it and the speed of sound."""
    law: Deck = {"model": "fluid"}
    if shear is None:
        if find(material, "PLASTIC"):
            raise BadInput(state.place, "*PLASTIC with *EOS needs *ELASTIC, TYPE=SHEAR: add it")
    else:
        line, density = require_line(shear), find(material, "DENSITY")
        g = shear.number(line, 0)
        k = (density.number(require_line(density), 0) if density else 0.0) * state.number(require_line(state), 0) ** 2
        if g <= 0 or k <= 0:
            raise BadInput(shear.place, "the shear modulus, density or speed of sound is not positive: correct it")
        law = {"model": "elastic", "youngs_modulus": 9 * k * g / (3 * k + g),
               "poissons_ratio": (3 * k - 2 * g) / (6 * k + 2 * g)}
        for block in [find(material, "PLASTIC")]:
            if block:
                add_plastic(deck, law, block)
                add_rate(deck, law, find(material, "RATE DEPENDENT"))
        if law["model"] == "elastic":
            law |= {"model": "j2_plasticity", "yield_stress": NEVER}
    add_state(deck, law, state)
    return law


def relax(deck: AbaqusDeck, law: Deck, elastic: Block, block: Block) -> Deck | None:
    """Prony's series of the shear modulus and the bulk modulus."""
    rows = [(block.number(line, 0), block.number(line, 1), block.number(line, 2))
            for line in block.lines if any(line[1])]
    if (block.option("TIME") != "PRONY" or not 1 <= len(rows) <= MOST_RELAXATIONS or law["model"] != "elastic"
            or "equation_of_state" in law):
        text = "viscoelasticity other than up to six terms of Prony's series of the moduli of *ELASTIC"
        deck.ledger.refuse("VISCOELASTIC", block.place, text, "the material does not relax")
        return law
    shares = [sum(row[i] for row in rows) for i in (0, 1)]
    if (max(shares) >= 1 or max(shares) <= 0 or min(min(row) for row in rows) < 0
            or min(time for _, _, time in rows) <= 0):
        raise BadInput(block.place, "the shares of *VISCOELASTIC must be 0 or more and less than 1 together, "
                                    "times positive: correct them")
    e, nu = law["youngs_modulus"], law["poissons_ratio"]
    is_instantaneous = elastic.option("MODULI") == "INSTANTANEOUS"
    g, k = (value if is_instantaneous else value / (1 - share)
            for value, share in zip((e / (2 * (1 + nu)), e / (3 * (1 - 2 * nu))), shares))
    deck.ledger.translated("VISCOELASTIC", block.place, "viscoelastic")
    made: Deck = {"model": "viscoelastic", "bulk_modulus": k * (1 - shares[1]),
                  "long_term_shear_modulus": g * (1 - shares[0])}
    for name, i, start in (("relaxation", 0, g), ("bulk_relaxation", 1, k)):
        terms: dict[float, float] = {}
        for row in rows:
            if row[i]:
                terms[row[2]] = terms.get(row[2], 0.0) + start * row[i]
        if terms:
            made[name] = [[time, terms[time]] for time in sorted(terms)]
    return made


def add_plastic(deck: AbaqusDeck, law: Deck, block: Block, cyclic: Block | None = None) -> None:
    """A table, Johnson and Cook's law, kinematic hardening, or both kinds of hardening."""
    kind = block.option("HARDENING")
    line = require_line(block)
    if kind == "JOHNSON COOK":
        a, b, melt, room = (block.number(line, i) for i in (0, 1, 4, 5))
        n = require_positive(block, line, 2, "n") if b else block.number(line, 2) or 1.0
        m = require_positive(block, line, 3, "m") if melt > room else block.number(line, 3) or 1.0
        law |= {"model": "johnson_cook", "a": a, "b": b, "n": n, "m": m,
                "melt_temperature": melt if melt > room else room + NEVER, "room_temperature": room,
                "start_temperature": room, "specific_heat": NEVER}  # fmt: skip
        deck.ledger.translated("PLASTIC", block.place,
                               "johnson_cook; heat needs an ADIABATIC step and *INELASTIC HEAT FRACTION")
        return
    if user_code.is_user_hardening(block):  # its lines are constants of a subroutine
        deck.ledger.refuse("PLASTIC.HARDENING", block.place, "hardening by a subroutine of the user beside *EOS",
                           "the material is elastic")
        return
    if kind == "COMBINED":
        add_combined(deck, law, block, cyclic)
        return
    if cyclic:
        deck.ledger.refuse("CYCLIC HARDENING", cyclic.place, "*CYCLIC HARDENING without HARDENING=COMBINED", INSTEAD)
    if kind not in ("", "ISOTROPIC", "KINEMATIC"):
        deck.ledger.refuse("PLASTIC.HARDENING", block.place, f"hardening of type {clip(kind)}",
                           "isotropic hardening is used")
    points = [(block.number(row, 1), block.number(row, 0)) for row in take_rows(deck, block)]
    check_strains(block, points)
    if kind == "KINEMATIC" and len(points) > 1:
        (x0, y0), (x1, y1) = points[:2]
        law |= {
            "model": "combined_hardening",
            "yield_stress": y0,
            "hardening_modulus": (y1 - y0) / (x1 - x0) if x1 > x0 else 0.0,
            "kinematic_share": 1.0,
        }
        return
    ascending = order_points(points)
    if len(ascending) == 1:
        law |= {"model": "j2_plasticity", "yield_stress": ascending[0][1]}
        return
    rows, error = thin_rows(ascending)
    if error > 1e-12:
        deck.ledger.approximated(
            "PLASTIC", block.place, f"{len(points)} rows become {len(rows)}, within {error:.2g} of the largest stress"
        )
    law |= {"model": "tabulated_plasticity", "hardening": [list(row) for row in rows]}


def check_strains(block: Block, points: list[tuple[float, float]]) -> None:
    """Plastic strains begin with 0 and ascend."""
    if points[0][0] != 0:
        raise BadInput(block.at(require_line(block)[0]),
                       f"the first plastic strain is {points[0][0]:g} (it must be 0, at the yield stress): correct it")
    for line, (before, after) in zip(block.lines[1:], zip(points, points[1:])):
        if after[0] <= before[0]:
            raise BadInput(block.at(line[0]),
                           f"plastic strains do not ascend ({before[0]:g}, then {after[0]:g}): correct the table")
    if min(stress for _, stress in points) <= 0:
        raise BadInput(block.place, "a yield stress of *PLASTIC is not positive: correct it")


def take_rows(deck: AbaqusDeck, block: Block) -> list[Line]:
    """Rows of the first temperature."""
    rows = [row for row in block.lines if block.number(row, 2) == block.number(block.lines[0], 2)]
    if len(rows) < len(block.lines):
        deck.ledger.refuse("PLASTIC.TEMPERATURE", block.place, "a table for several temperatures",
                           "that of the first one is used")
    return rows


def add_rate(deck: AbaqusDeck, law: Deck, block: Block | None) -> None:
    """Cowper and Symonds' power law, or C and the rate of Johnson and Cook's."""
    if block is None:
        return
    line = require_line(block)
    kind = block.option("TYPE") or "POWER LAW"
    if kind != "YIELD RATIO" and len(block.lines) > 1:
        deck.ledger.refuse("RATE DEPENDENT.TEMPERATURE", block.place, "constants for several temperatures",
                           "those of the first row are used")
    if kind == "JOHNSON COOK" and law["model"] == "johnson_cook":
        if not block.text(line, 0):
            raise BadInput(block.at(line[0]), "C of *RATE DEPENDENT, TYPE=JOHNSON COOK is blank (it has no default): "
                                              "give it, or remove the keyword")
        if block.number(line, 0):
            law |= {"c": block.number(line, 0),
                    "reference_rate": require_positive(block, line, 1, "the reference rate")}
    elif kind == "POWER LAW" and law["model"] != "johnson_cook":
        if law["model"] == "j2_plasticity":
            law |= {"model": "combined_hardening", "kinematic_share": 0.0}
        law |= {"cowper_symonds_rate": require_positive(block, line, 0, "D"),
                "cowper_symonds_exponent": require_positive(block, line, 1, "n")}
    elif kind == "YIELD RATIO" and law["model"] in ("j2_plasticity", "tabulated_plasticity"):
        base = [(row[0], row[1]) for row in law["hardening"]] if "hardening" in law else [(0.0, law["yield_stress"])]
        factors = [(block.number(row, 1), block.number(row, 0)) for row in block.lines]
        add_rates(deck.ledger, block.place, law, order_curves(block.place, scale_curve(base, factors)),
                  "RATE DEPENDENT")
    else:
        deck.ledger.refuse("RATE DEPENDENT", block.place,
                           f"a dependence on the rate of the kind {kind}", "there is none")


def require_positive(block: Block, line: Line, index: int, name: str) -> float:
    """A constant of a law that has no default."""
    value = block.number(line, index)
    if value <= 0:
        given = f"is {value:g}" if block.text(line, index) else "is blank"
        option = "HARDENING" if block.keyword == "PLASTIC" else "TYPE"
        kind = f"*{block.keyword}, {option}={block.option(option) or 'POWER LAW'}"
        raise BadInput(block.at(line[0]), f"{name} of {kind} {given} (it must be positive, and has no default): "
                                          "correct it, or remove the keyword")
    return value


def add_rate_tables(deck: AbaqusDeck, law: Deck, blocks: list[Block]) -> None:
    """*PLASTIC, RATE=: a table for each rate. The first one is that of the law."""
    if len(blocks) == 1 and "RATE" in blocks[0].options:
        deck.ledger.refuse("PLASTIC.RATE", blocks[0].place, "a table for one rate alone", "it is used at all rates")
    if len(blocks) < 2 or law["model"] == "johnson_cook":
        return
    if law["model"] == "combined_hardening":
        deck.ledger.refuse("PLASTIC.RATE", blocks[1].place, "kinematic hardening for several rates",
                           "that of the first rate is used")
        return
    tables = []
    for block in blocks:
        rate = block.number((block.place.line, [block.options.get("RATE", "")]), 0)
        tables.append((rate,
                       order_points([(block.number(row, 1), block.number(row, 0)) for row in take_rows(deck, block)])))
    if any(not points for _, points in tables):
        raise BadInput(blocks[0].place, "*PLASTIC has no data line: add it")
    add_rates(deck.ledger, blocks[1].place, law, order_curves(blocks[1].place, tables), "PLASTIC.RATE")


def add_state(deck: AbaqusDeck, law: Deck, block: Block) -> None:
    line = require_line(block)
    if block.option("TYPE") != "USUP":
        deck.ledger.refuse("EOS", block.place,
                           f"an equation of state of type {block.option('TYPE')}", "the law alone is used")
        return
    law["equation_of_state"] = {"kind": "mie_grueneisen", "sound_speed": block.number(line, 0),
                                "slope": block.number(line, 1), "grueneisen": block.number(line, 2)}  # fmt: skip


READ = {"DAMPING", "DENSITY", "ELASTIC", "PLASTIC", "RATE DEPENDENT", "EOS", "HYPERELASTIC", "HYPERFOAM",
        "VISCOELASTIC", "USER MATERIAL", "DEPVAR", "POTENTIAL", "CYCLIC HARDENING"}
