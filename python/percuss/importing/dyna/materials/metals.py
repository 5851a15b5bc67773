"""Laws of metals."""

import math

from ...curves import MOST_MATERIAL_ROWS, Points, interpolate, thin_rows
from ...fields import Row
from ...ledger import BadInput
from ...model import Deck
from ...rates import MOST_ROWS, Curves, add_rates, order_curves, scale_curve
from ..cards import Card
from ..deck import KeywordDeck
from ..dimensions import SAME, scale
from .shared import (
    FAR,
    NEVER,
    Use,
    add_rate,
    clean_curve,
    elastic_from_shear_and_bulk,
    extend_curve,
    finish_lines,
    limit_tension,
    make_hardening,
    note_rate,
    read_layers,
    read_points,
    set_failure,
    start_law,
    tangent_to_hardening,
)
from .states import initial_bulk_modulus, translate_state

EIGHT = " ".join("ABCDEFGH")
SOFTENING = 8  # rows of a table that falls


def add_state(deck: KeywordDeck, law: Deck, use: Use) -> None:
    state = translate_state(deck, use)
    if state:
        law["equation_of_state"] = state


def plastic_kinematic(deck: KeywordDeck, card: Card, use: Use) -> Deck:
    reader = card.reader()
    row, more = reader.row("MID RO E PR SIGY ETAN BETA"), reader.row("SRC SRP FS VP")
    law = start_law(row, "combined_hardening")
    hardening = tangent_to_hardening(row, law["youngs_modulus"], row.number("ETAN"))
    law |= {"yield_stress": row.positive("SIGY"), "hardening_modulus": hardening}
    isotropic_share = row.number("BETA")
    if hardening == 0 or isotropic_share == 1:
        law["kinematic_share"] = 0.0
    else:
        law["kinematic_share"] = min(max(1 - isotropic_share, 0.0), 1.0)
    if add_rate(law, deck, more, ("SRC", "SRP")):
        note_rate(deck, more)
    if law["kinematic_share"] == 0 and "cowper_symonds_rate" not in law:
        del law["kinematic_share"]
        law["model"] = "j2_plasticity"
    set_failure(law, plastic_strain=more.number("FS"))
    row.finish(deck.ledger)
    more.skip("VP")
    more.finish(deck.ledger)
    finish_lines(deck, card, reader)
    return law


def list_curves(deck: KeywordDeck, more: Row, id: int) -> tuple[Curves, bool]:
    """The curves of a table, which go on with their last slope. Rates are logarithms where the first is negative: then,
    and with _LOG_INTERPOLATION, stresses are straight over the logarithm of the rate.
    """
    rows = deck.tables[id]
    is_log, unit = rows[0][0] < 0, scale("rate", deck.units_of_tables.get(id, SAME))
    curves = []
    for value, curve in rows:
        points = clean_curve(deck.material_curve(curve, more.place, "none", "stress"))
        if not points:
            raise BadInput(more.place, f"curve {curve} has no stress above 0 at a plastic strain: give it rows")
        curves.append((unit * (math.exp(min(value, 700.0)) if is_log else value), extend_curve(points)))
    return order_curves(more.place, curves), is_log


def add_table(deck: KeywordDeck, card: Card, more: Row, law: Deck, id: int) -> None:
    """LCSS is a table of curves; C, P, LCSR, EPS and ES then count no more."""
    curves, is_log = list_curves(deck, more, id)
    if any(more.number(name) for name in ("C", "P", "LCSR")):
        deck.ledger.ignored(f"{card.keyword}.C", more.place,
                            "C, P and LCSR beside a table of rates: the table counts alone")
    if card.row(card.lines[0], "MID").integer("MID") in deck.logarithmic_materials:
        if curves[0][0] > 0:
            is_log = True
        elif not deck.ledger.refuse(f"{card.keyword}.table", more.place, "a rate of 0 (it has no logarithm)",
                                    "stresses are straight over the rate"):
            return
    if len(curves) == 1:
        law |= {"model": "tabulated_plasticity",
                "hardening": make_hardening(deck, curves[0][1], card.keyword, more.place)}
        return
    add_rates(deck.ledger, more.place, law, curves, f"{card.keyword}.table", is_log)
    note_rate(deck, more)


def add_scaled(deck: KeywordDeck, card: Card, more: Row, law: Deck, points: Points) -> None:
    """LCSR: a factor of the yield stress over the rate."""
    factors = [(rate, factor)
               for rate, factor in deck.material_curve(abs(more.integer("LCSR")), more.place, "rate", "none")
               if rate >= 0]
    base = extend_curve(clean_curve(points))
    if not base:
        stress, slope = law["yield_stress"], law["hardening_modulus"]
        base = [(0.0, stress), (FAR, stress + slope * FAR)] if slope else [(0.0, stress)]
    if not factors:
        raise BadInput(more.place, "the curve LCSR has no rate of 0 or more: give it rows")
    add_rates(deck.ledger, more.place, law, order_curves(more.place, scale_curve(base, factors)),
              f"{card.keyword}.LCSR")
    note_rate(deck, more)


def add_hardening(deck: KeywordDeck, card: Card, row: Row, more: Row, law: Deck, points: Points) -> None:
    """The hardening of *MAT_024 and 123, LCSS before EPS and ES before ETAN, and how it depends on the rate."""
    id = more.integer("LCSS")
    if id and id in deck.tables:
        add_table(deck, card, more, law, id)
        return
    if id:
        points = deck.material_curve(id, more.place, "none", "stress")
    table = make_hardening(deck, points, card.keyword, more.place)
    if table:
        law["hardening"] = table
    else:
        hardening = tangent_to_hardening(row, law["youngs_modulus"], row.number("ETAN"))
        law |= {
            "model": "combined_hardening",
            "yield_stress": row.positive("SIGY"),
            "hardening_modulus": hardening,
            "kinematic_share": 0.0,
        }
    if more.integer("LCSR"):
        if any(more.numbers("C", "P")):
            deck.ledger.ignored(f"{card.keyword}.C", more.place, "C and P beside LCSR: the curve counts alone")
        add_scaled(deck, card, more, law, points)
        return
    if add_rate(law, deck, more, ("C", "P")):
        note_rate(deck, more)
    if law["model"] == "combined_hardening" and "cowper_symonds_rate" not in law:
        law["model"] = "j2_plasticity"
        del law["kinematic_share"]


def piecewise_linear(deck: KeywordDeck, card: Card, use: Use) -> Deck | None:
    """*MAT_PIECEWISE_LINEAR_PLASTICITY and its modified form."""
    reader = card.reader()
    row = reader.row("MID RO E PR SIGY ETAN FAIL TDEL")
    is_modified = card.keyword.startswith("MAT_MODIFIED")
    more = reader.row("C P LCSS LCSR VP " + ("EPSTHIN EPSMAJ NUMINT" if is_modified else "UNUSED~unused RFILTF~unused"))
    points = read_points(reader, EIGHT, EIGHT)
    law = start_law(row, "tabulated_plasticity")
    row.skip("SIGY", "ETAN")
    more.skip("VP", "C", "P", "LCSR")
    add_hardening(deck, card, row, more, law, points)
    set_failure(law, plastic_strain=row.number("FAIL"), step=row.number("TDEL"))
    if row.number("FAIL") < 0:
        deck.ledger.refuse(f"{card.keyword}.FAIL", row.place, "failure by a subroutine or a curve", "nothing fails")
    if is_modified:
        read_modified(deck, card, law, more, use)
    row.finish(deck.ledger)
    more.finish(deck.ledger, "it is left out")
    finish_lines(deck, card, reader)
    return law


def read_modified(deck: KeywordDeck, card: Card, law: Deck, more: Row, use: Use) -> None:
    """Failure of *MAT_123 by the largest strain, by thinning, and by so many layers."""
    strain = more.number("EPSMAJ")
    set_failure(law, principal_strain=abs(strain))
    if strain < 0:
        deck.ledger.approximated(f"{card.keyword}.EPSMAJ", more.place, "the largest strain is not filtered")
    thinning = more.number("EPSTHIN")
    if use.is_shell and thinning > 0:
        set_failure(law, thinning=thinning)
    elif use.is_shell:
        set_failure(law, mean_thinning=-thinning)
    if use.is_shell and thinning:
        deck.ledger.approximated(f"{card.keyword}.EPSTHIN", more.place,
                                 "a logarithmic strain, of the layers or (below 0) of the whole thickness")
    read_layers(law, more, use)


def damaged(deck: KeywordDeck, card: Card, use: Use) -> Deck | None:
    """*MAT_PLASTICITY_WITH_DAMAGE: the stress falls in proportion to the damage,
    which grows from 0 at EPPF to 1 at EPPFR."""
    reader = card.reader()
    row = reader.row("MID RO E PR SIGY ETAN EPPF=1e12 TDEL")
    more = reader.row("C P LCSS LCSR EPPFR=1e14 VP LCDM NUMINT")
    points = read_points(reader, EIGHT, EIGHT)
    law = start_law(row, "tabulated_plasticity")
    row.skip("SIGY", "ETAN")
    more.skip("VP", "C", "P", "LCSR")
    add_hardening(deck, card, row, more, law, points)
    start, end = row.number("EPPF"), more.number("EPPFR")
    if 0 < end < NEVER:
        soften_law(law, start, end)
    if 0 < start < end < NEVER:
        deck.ledger.approximated(f"{card.keyword}.EPPF", row.place, "the table falls from EPPF to EPPFR, as the damage "
                                                                    "has it; unloading keeps Young's modulus")
    set_failure(law, plastic_strain=end, step=row.number("TDEL"))
    read_layers(law, more, use)
    row.finish(deck.ledger)
    more.finish(deck.ledger, "the damage grows in proportion to the plastic strain")
    finish_lines(deck, card, reader)
    return law


def soften_law(law: Deck, start: float, end: float) -> None:
    """The curve of the law, or those of all rates, and a bilinear one as a table."""
    if law["model"] == "rate_table_plasticity":
        most = MOST_ROWS // len(law["hardening_at_rates"])
        law["hardening_at_rates"] = [[rate, soften(rows, start, end, most)] for rate, rows in law["hardening_at_rates"]]
        return
    if "yield_stress" in law:
        stress, slope = law.pop("yield_stress"), law.pop("hardening_modulus")
        law.pop("kinematic_share", None)
        law |= {"model": "tabulated_plasticity", "hardening": [[0.0, stress], [2.0, stress + 2.0 * slope]]}
    law["hardening"] = soften(law["hardening"], start, end)


def soften(table: list[list[float]], start: float, end: float, most: int = MOST_MATERIAL_ROWS) -> list[list[float]]:
    """A hardening table whose stress falls to nothing between two plastic strains."""
    start = min(start, end)
    rows = [row for row in table if row[0] < start]
    strains = [start + (end - start) * i / SOFTENING for i in range(SOFTENING)]
    undamaged = [(x, y) for x, y in table]
    rows += [[p, interpolate(undamaged, p) * max(1 - (p - start) / (end - start), 0.01)] for p in strains]
    rows.append([end, 0.01 * interpolate(undamaged, end)])
    return [list(row) for row in thin_rows([(x, y) for x, y in rows], most)[0]]


RESULTANTS = {"NRR": "axial", "NRS": "shear_y", "NRT": "shear_z", "MRR": "torque", "MSS": "moment_y", "MTT": "moment_z"}


def spot_weld(deck: KeywordDeck, card: Card, use: Use) -> Deck:
    """*MAT_SPOTWELD of beams, which fail by the forces of their section, by plastic strain or at a time, and of solids,
    which fail by plastic strain."""
    reader = card.reader()
    row = reader.row("MID RO E PR SIGY EH DT TFAIL")
    more = reader.row("EFAIL NRR NRS NRT MRR MSS MTT NF~output")
    law = start_law(row, "j2_plasticity")
    law |= {"yield_stress": row.positive("SIGY"), "hardening_modulus": max(row.number("EH"), 0.0)}
    if use.is_beam:
        limit_weld(deck, card, law, row, more)
    else:
        set_failure(law, plastic_strain=more.number("EFAIL"))
    if row.number("DT"):
        deck.ledger.refuse(f"{card.keyword}.DT", row.place, "mass that is added to welds for their step",
                           "no mass is added, and the step may be short")
    if not use.is_beam and 0 < row.number("TFAIL") < deck.end_time:
        deck.ledger.refuse(f"{card.keyword}.TFAIL", row.place, "welds of solids that fail at a time", "they do not")
    row.skip("TFAIL")
    row.finish(deck.ledger)
    more.finish(deck.ledger, "welds do not fail by it")
    finish_lines(deck, card, reader)
    return law


def limit_weld(deck: KeywordDeck, card: Card, law: Deck, row: Row, more: Row) -> None:
    """The sum of the squares of the forces over NRR to MTT reaches 1. A weld is round: it has no axes s and t."""
    limits = {ours: more.number(name) for name, ours in RESULTANTS.items()}
    if min(limits.values()) < 0:
        deck.ledger.refuse(f"{card.keyword}.NRR", more.place,
                           "limits of welds that depend on the rate", "there is none")
    limits = {name: value for name, value in limits.items() if 0 < value < NEVER}
    for pair in (("shear_y", "shear_z"), ("moment_y", "moment_z")):
        both = [limits.get(name, 0.0) for name in pair]
        if both[0] == both[1]:
            continue
        deck.ledger.refuse(f"{card.keyword}.{'NRS' if pair[0] == 'shear_y' else 'MSS'}", more.place,
                           "limits of welds that differ between the axes s and t", "both are the smaller one")
        limits |= dict.fromkeys(pair, min(value for value in both if value > 0))
    if limits:
        law.setdefault("failure", {})["resultants"] = limits
    set_failure(law, time=row.number("TFAIL"), plastic_strain=more.number("EFAIL"))


def shear_and_bulk(deck: KeywordDeck, card: Card, use: Use) -> Deck | None:
    """*MAT_ISOTROPIC_ELASTIC_PLASTIC and _FAILURE: the hardening modulus is over plastic strain."""
    reader = card.reader()
    row = reader.row("MID RO G SIGY ETAN BULK")
    row.skip("MID")
    law: Deck = {
        "model": "j2_plasticity",
        "density": row.positive("RO"),
        **elastic_from_shear_and_bulk(row.positive("G"), row.positive("BULK")),
    }
    law |= {"yield_stress": row.positive("SIGY"), "hardening_modulus": max(row.number("ETAN"), 0.0)}
    if card.keyword.endswith("FAILURE"):
        more = reader.row("EPF PRF REM TREM")
        set_failure(law, plastic_strain=more.number("EPF"), pressure=-more.number("PRF"), step=more.number("TREM"))
        if "failure" in law and more.integer("REM"):
            deck.ledger.refuse(
                f"{card.keyword}.REM", more.place, "failed elements that continue as a fluid",
                "failed elements are eroded"
            )
    row.finish(deck.ledger)
    finish_lines(deck, card, reader)
    return law


def elastic_plastic_hydro(deck: KeywordDeck, card: Card, use: Use) -> Deck | None:
    """*MAT_ELASTIC_PLASTIC_HYDRO with an equation of state."""
    reader = card.reader()
    row = reader.row("MID RO G SIGY EH PC FS CHARL~absent")
    points = read_points(reader, EIGHT, EIGHT, 2)
    row.skip("MID")
    state = translate_state(deck, use)
    if state is None or state["kind"] == "jwl":
        deck.ledger.refuse(
            f"{card.keyword}.EOSID", use.place, "a law that needs an equation of state",
            "the parts made of it are left out"
        )
        return None
    density = row.positive("RO")
    moduli = elastic_from_shear_and_bulk(row.positive("G"), initial_bulk_modulus(state, density))
    law: Deck = {"model": "j2_plasticity", "density": density, **moduli, "equation_of_state": state}
    table = make_hardening(deck, points, card.keyword, row.place)
    row.skip("SIGY", "EH")
    if table:
        law |= {"model": "tabulated_plasticity", "hardening": table}
    else:
        law |= {
            "yield_stress": row.number("SIGY") or 1e-12 * moduli["youngs_modulus"],
            "hardening_modulus": max(row.number("EH"), 0.0),
        }
    set_failure(law, plastic_strain=row.number("FS"))
    limit_tension(deck, row, law, initial_bulk_modulus(state, density))
    row.finish(deck.ledger)
    finish_lines(deck, card, reader)
    return law


def power_law(deck: KeywordDeck, card: Card, use: Use) -> Deck:
    """Y = K (e0 + p)^N, sampled more densely near zero."""
    reader = card.reader()
    row, more = reader.row("MID RO E PR K N SRC SRP"), reader.row("SIGY VP EPSF")
    law = start_law(row, "tabulated_plasticity")
    strength, exponent, start = row.positive("K"), row.positive("N"), more.number("SIGY")
    if start > 0.02:
        offset = (start / strength) ** (1 / exponent)
    else:
        offset = start or (law["youngs_modulus"] / strength) ** (1 / (exponent - 1))
    strains = [2.0 * (i / 30) ** 3 for i in range(31)]
    law["hardening"] = [[p, strength * (offset + p) ** exponent] for p in strains]
    if start > 0.02:
        law["hardening"][0][1] = start  # the offset may be too small for a number
    deck.ledger.approximated(card.keyword, card.place, "the power law by 31 rows up to a plastic strain of 2")
    if add_rate(law, deck, row, ("SRC", "SRP")):
        note_rate(deck, more)
    more.skip("VP")
    set_failure(law, plastic_strain=more.number("EPSF"))
    row.finish(deck.ledger)
    more.finish(deck.ledger)
    return law


METALS = {
    "PLASTIC_KINEMATIC": plastic_kinematic, "PIECEWISE_LINEAR_PLASTICITY": piecewise_linear,
    "MODIFIED_PIECEWISE_LINEAR_PLASTICITY": piecewise_linear, "ISOTROPIC_ELASTIC_PLASTIC": shear_and_bulk,
    "ISOTROPIC_ELASTIC_FAILURE": shear_and_bulk, "ELASTIC_PLASTIC_HYDRO": elastic_plastic_hydro,
    "PLASTICITY_WITH_DAMAGE": damaged, "SPOTWELD": spot_weld, "POWER_LAW_PLASTICITY": power_law,
}  # fmt: skip
