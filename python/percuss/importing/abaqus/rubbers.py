"""*HYPERELASTIC and *HYPERFOAM with constants."""

import math

from ..laws import make_mooney_rivlin
from ..ledger import BadInput
from ..model import Deck
from .deck import AbaqusDeck
from .lines import Block, Line, require_line

USUAL_BULK = 20.0  # bulk over shear modulus of rubber without D1, in Abaqus/Explicit


def refuse_test_data(deck: AbaqusDeck, block: Block) -> bool:
    """Rubber and foam that Abaqus fits to tests have no constants, and so no data line."""
    if not {"TEST DATA INPUT", "MARLOW"} & block.options.keys():
        return False
    text = "constants fitted to test data: give those that Abaqus has found, which its .dat file lists"
    deck.ledger.refuse(block.keyword, block.place, text, "the parts made of it are left out")
    return True


def translate_rubber(deck: AbaqusDeck, block: Block) -> Deck | None:
    """NEO HOOKE, MOONEY-RIVLIN, YEOH, ARRUDA-BOYCE or OGDEN with constants: K = 2 / D1."""
    if refuse_test_data(deck, block):
        return None
    found = read_rubber(block, require_line(block))
    if found is None:
        order = f" (N={block.option('N')})" if block.option("N") else ""
        text = (f"rubber{order} that is not NEO HOOKE, MOONEY-RIVLIN, YEOH, ARRUDA-BOYCE "
                "(constants, the first and the shear modulus above 0) or OGDEN (constants, D1 alone)")
        deck.ledger.refuse("HYPERELASTIC", block.place, text, "the parts made of it are left out")
        return None
    law, shear, d1 = found
    if len(block.lines) > count_lines(block):
        deck.ledger.refuse("HYPERELASTIC.TEMPERATURE", block.place,
                           "constants that depend on the temperature", "the first row is used")
    law["bulk_modulus"] = 2 / d1 if d1 > 0 else USUAL_BULK * shear
    if math.isinf(law["bulk_modulus"]):
        raise BadInput(block.place, "D1 of *HYPERELASTIC is too small: correct it")
    text = ("the same constants and bulk modulus 2 / D1" if d1 > 0
            else f"bulk modulus of {USUAL_BULK:g} shear moduli, as D1 is 0")
    deck.ledger.approximated("HYPERELASTIC", block.place, f"{law['model']}: {text}, with percuss' term of volume")
    return law


def count_terms(block: Block) -> int:
    """N of OGDEN and of *HYPERFOAM."""
    text = block.option("N")
    return int(text) if text in ("1", "2", "3", "4", "5", "6") else 0 if text else 1


def count_lines(block: Block) -> int:
    """Lines of one temperature, of 8 values each: three constants for each term, and the temperature."""
    has_terms = "OGDEN" in block.options or block.keyword == "HYPERFOAM"
    return -(-(3 * count_terms(block) + 1) // 8) if has_terms else 1


def read_terms(block: Block) -> tuple[list[list[float]], list[float]] | None:
    """Rows (alpha, 2 mu / alpha) of percuss, and the third constants; None where they are not those of an energy."""
    count = count_terms(block)
    values = [block.number(line, i) for line in block.lines[: count_lines(block)] for i in range(8)]
    terms: dict[float, float] = {}
    for mu, alpha in zip(values[0 : 2 * count : 2], values[1 : 2 * count : 2]):
        if alpha == 0:
            return None
        terms[alpha] = terms.get(alpha, 0.0) + 2 * mu / alpha
    if sum(alpha * mu for alpha, mu in terms.items()) <= 0:
        return None
    return [[alpha, terms[alpha]] for alpha in sorted(terms)], values[2 * count : 3 * count]


def translate_hyperfoam(deck: AbaqusDeck, block: Block) -> Deck | None:
    """Constants with one Poisson's ratio."""
    if refuse_test_data(deck, block):
        return None
    require_line(block)
    found = None if "POISSON" in block.options else read_terms(block)
    if found is None or len(set(found[1])) > 1 or not -1 / 3 < found[1][0] < 0.5:
        text = "foam that is not of constants with exponents other than 0 and one Poisson's ratio for all terms"
        deck.ledger.refuse("HYPERFOAM", block.place, text, "the parts made of it are left out")
        return None
    if len(block.lines) > count_lines(block):
        deck.ledger.refuse("HYPERFOAM.TEMPERATURE", block.place,
                           "constants that depend on the temperature", "the first row is used")
    deck.ledger.translated("HYPERFOAM", block.place, "hyperfoam")
    return {"model": "hyperfoam", "terms": found[0], "poissons_ratio": found[1][0]}


def read_rubber(block: Block, line: Line) -> tuple[Deck, float, float] | None:
    """The law without its bulk modulus, its shear modulus, D1; None where percuss has no such law."""
    if "OGDEN" in block.options:
        found = read_terms(block)
        if found is None or min(found[1]) < 0 or any(found[1][1:]):
            return None
        return {"model": "ogden", "terms": found[0]}, 0.5 * sum(alpha * mu for alpha, mu in found[0]), found[1][0]
    values = [block.number(line, i) for i in range(6)]
    if values[0] <= 0:
        return None
    if "ARRUDA-BOYCE" in block.options:
        mu, locking, d = values[:3]
        if locking <= 1 or d < 0:
            return None
        terms = ((1 / 2, 1), (1 / 20, 2), (11 / 1050, 3), (19 / 7000, 4), (519 / 673750, 5))
        shear = 2 * mu * sum(i * c * 3 ** (i - 1) / locking ** (2 * i - 2) for c, i in terms)
        return {"model": "arruda_boyce", "mu": mu, "locking_stretch": locking}, shear, d
    order = block.option("N")
    if "YEOH" in block.options or ("REDUCED POLYNOMIAL" in block.options and order in ("2", "3")):
        count = 2 if order == "2" and "YEOH" not in block.options else 3
        d1, *others = values[count : 2 * count]
        if d1 < 0 or any(others):
            return None
        return ({"model": "yeoh", "c10": values[0], "c20": values[1], "c30": values[2] if count == 3 else 0.0},
                2 * values[0], d1)
    if order not in ("", "1"):
        return None
    # the default
    is_mooney = ("MOONEY-RIVLIN" in block.options or "POLYNOMIAL" in block.options
                 or not block.options.keys() - {"N", "MODULI"})
    if not is_mooney and not {"NEO HOOKE", "REDUCED POLYNOMIAL"} & block.options.keys():
        return None
    c01, d1 = values[1] if is_mooney else 0.0, values[2 if is_mooney else 1]
    if c01 <= -values[0] or d1 < 0:
        return None
    return make_mooney_rivlin(values[0], c01), 2 * (values[0] + c01), d1
