"""*MAT_DAMAGE_3: Chaboche's law."""

from ...ledger import BadInput
from ...model import Deck
from ..cards import Card
from ..deck import KeywordDeck
from .shared import Use, add_rate, finish_lines, start_law


def damage_3(deck: KeywordDeck, card: Card, use: Use) -> Deck:
    """Isotropic hardening SIGY + HARDI / BETA (1 - exp(-BETA p)),
    and back stresses of the moduli HARDK and the rates GAMMA."""
    reader = card.reader()
    row, more = (reader.row("MID RO E PR SIGY HARDI BETA LCSS"),
                 reader.row("HARDK1 GAMMA1 HARDK2 GAMMA2 SRC SRP HARDK3 GAMMA3"))
    damage = reader.row("IDAMAGE IDS~output IDEP~output EPSD S T=1 DC=0.5 KHFLG")
    last = reader.row("HARDK4 GAMMA4 LCKH~unused NKH~unused")
    law = start_law(row, "chaboche") | {"yield_stress": row.positive("SIGY")}
    terms: dict[float, float] = {}
    for line, i in ((more, 1), (more, 2), (more, 3), (last, 4)):
        modulus, gamma = line.numbers(f"HARDK{i}", f"GAMMA{i}")
        if modulus < 0 or gamma < 0:
            line.fail(f"HARDK{i}" if modulus < 0 else f"GAMMA{i}",
                      "is a curve over the temperature, which percuss has not")
        if modulus > 0:
            terms[gamma] = terms.get(gamma, 0.0) + modulus
    law["back_stresses"] = [[gamma, terms[gamma]] for gamma in sorted(terms)]
    hardening, rate = row.numbers("HARDI", "BETA")
    law |= {"cyclic_stress": hardening / rate, "cyclic_rate": rate} if rate else {"hardening_modulus": hardening}
    if rate < 0 or hardening < 0 and (rate == 0 or law["yield_stress"] + hardening / rate <= 0):
        raise BadInput(row.place, "HARDI and BETA take all strength: correct them")
    add_rate(law, deck, more, ("SRC", "SRP"))
    if not terms:
        law = make_voce(law)
    if damage.number("IDAMAGE"):
        deck.ledger.refuse(f"{card.keyword}.IDAMAGE", damage.place,
                           "damage by the energy release rate", "nothing is damaged")
    damage.skip("EPSD", "S", "T", "DC")
    for line in (row, more, damage, last):
        line.finish(deck.ledger, "it is left out")
    finish_lines(deck, card, reader)
    return law


def make_voce(law: Deck) -> Deck:
    """Without back stresses."""
    del law["back_stresses"]
    return law | {"model": "voce_plasticity", "saturation_stress": law.pop("cyclic_stress", 0.0),
                  "saturation_rate": law.pop("cyclic_rate", 0.0)}


CYCLIC = {"DAMAGE_3": damage_3}
