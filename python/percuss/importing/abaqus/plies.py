"""*ELASTIC with three planes of symmetry, and Hashin's criteria of plies."""

from ..fields import clip
from ..ledger import BadInput
from ..model import Deck
from .deck import AbaqusDeck
from .lines import Block
from .mesh import Section

COUNTS = {"LAMINA": 6, "ENGINEERING CONSTANTS": 9, "ORTHOTROPIC": 9}  # constants of a row
PER_LINE = 8
ENERGIES = ("fibre_tension_energy", "fibre_compression_energy", "matrix_tension_energy", "matrix_compression_energy")


def read_constants(deck: AbaqusDeck, block: Block) -> Deck:
    """An orthotropic law by its moduli, or by its stiffness."""
    kind = block.option("TYPE")
    values = read_row(deck, block, COUNTS[kind])
    if kind == "LAMINA":
        e1, e2, nu12, g12, g13, g23 = values
        law = make_law([e1, e2, e2], [nu12, 0.0, 0.0], [g12, g23, g13])
    elif kind == "ENGINEERING CONSTANTS":
        e1, e2, e3, nu12, nu13, nu23, g12, g13, g23 = values
        law = make_law([e1, e2, e3], [nu12, nu23, nu13], [g12, g23, g13])
    else:
        law = invert(block, values)
    if min(*law["moduli"], *law["shear_moduli"]) <= 0:
        raise BadInput(block.place, f"a modulus of *ELASTIC, TYPE={kind} is not positive: correct it")
    deck.ledger.translated(f"ELASTIC, TYPE={kind}", block.place, "orthotropic")
    return law


def make_law(moduli: list[float], ratios: list[float], shear: list[float]) -> Deck:
    return {"model": "orthotropic", "moduli": moduli, "poissons_ratios": ratios, "shear_moduli": shear}


def read_row(deck: AbaqusDeck, block: Block, count: int) -> list[float]:
    """The constants of the first temperature; eight stand in a line."""
    lines = [line for line in block.lines if any(line[1])]
    needed = -(-count // PER_LINE)
    if len(lines) < needed:
        raise BadInput(block.place, f"*ELASTIC, TYPE={clip(block.option('TYPE'))} needs {count} constants, "
                                    "eight in a line: add them")
    if len(lines) > needed:
        deck.ledger.refuse("ELASTIC", block.place, "moduli that depend on the temperature", "the first row is used")
    return [block.number(lines[i // PER_LINE], i % PER_LINE) for i in range(count)]


def invert(block: Block, values: list[float]) -> Deck:
    """Moduli and ratios from the stiffness D1111 D1122 D2222 D1133 D2233 D3333 D1212 D1313 D2323."""
    a, d, b, e, f, c, g12, g13, g23 = values
    determinant = a * (b * c - f * f) - d * (d * c - f * e) + e * (d * f - b * e)
    cofactors = (b * c - f * f, a * c - e * e, a * b - d * d)
    if determinant <= 0 or min(cofactors) <= 0:
        raise BadInput(block.place, "the stiffness of *ELASTIC, TYPE=ORTHOTROPIC is of no stable material: correct it")
    s11, s22, _ = (value / determinant for value in cofactors)
    s12, s13, s23 = (e * f - d * c) / determinant, (d * f - e * b) / determinant, (d * e - a * f) / determinant
    return make_law([determinant / value for value in cofactors], [-s12 / s11, -s23 / s22, -s13 / s11], [g12, g23, g13])


def refuse_solids(deck: AbaqusDeck, section: Section, material: str, law: Deck) -> bool:
    """Whether solids of a ply are refused: its elasticity is of a plane, or it has strengths."""
    elastic = next(block for block in deck.materials[material.upper()].parts if block.keyword == "ELASTIC")
    if elastic.option("TYPE") == "LAMINA":
        deck.ledger.refuse("ELASTIC.LAMINA", section.place,
                           "solids with the elasticity of a plane, TYPE=LAMINA", "they are left out")
        return True
    if "failure" in law:
        deck.ledger.refuse("DAMAGE INITIATION.solids", section.place,
                           "Hashin's criteria of solids (percuss has them for shells)", "they are left out")
        return True
    return False


def add_hashin(deck: AbaqusDeck, law: Deck, start: Block, ends: list[Block]) -> bool:
    """XT XC YT YC SL ST, and an energy of the cracks of each kind. Returns whether elements are removed."""
    lines, more = ([line for line in block.lines if any(line[1])] for block in (start, ends[0]))
    if law["model"] != "orthotropic":
        raise BadInput(start.place,
                       "Hashin's criteria need an *ELASTIC with fibres: add TYPE=LAMINA or ENGINEERING CONSTANTS")
    if (ends[0].option("TYPE") != "ENERGY" or ends[0].option("SOFTENING") not in ("", "LINEAR") or len(lines) != 1
            or len(more) != 1):
        deck.ledger.refuse("DAMAGE EVOLUTION", ends[0].place,
                           "Hashin's criteria with damage other than by four energies, or for several temperatures",
                           "there is no failure")
        return False
    strengths = [start.number(lines[0], i) for i in range(6)]
    energies = [ends[0].number(more[0], i) for i in range(4)]
    if min(strengths) <= 0 or min(energies) < 0:
        raise BadInput(start.place,
                       "a strength of Hashin's criteria is not positive, or an energy negative: correct it")
    share = start.number((start.place.line, [start.options.get("ALPHA", "")]), 0)
    names = ("fibre_tension", "fibre_compression", "matrix_tension", "matrix_compression", "shear", "transverse_shear")
    law.update(zip(names, strengths))
    law.update({"shear_in_fibre_tension": share} if share else {})
    law.update({name: value for name, value in zip(ENERGIES, energies) if value})
    deck.ledger.translated("DAMAGE INITIATION", start.place, "strengths of plies by Hashin's criteria; an element is "
                                                             "removed when the fibres of all plies have failed")
    deck.ledger.approximated("DAMAGE EVOLUTION", ends[0].place, "energies of cracks: each mode by its own load, "
                                                                "over the length of the element across the crack")
    return True
