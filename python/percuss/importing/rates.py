"""Curves for several strain rates, and factors over the rate, as a table of percuss. Where the user asks for it, they
become Cowper and Symonds' law instead: 1 + (rate / C)^(1 / P).
"""

import math

from .curves import MOST_MATERIAL_ROWS, Points, interpolate, thin_rows
from .ledger import BadInput, Ledger, Place
from .model import Deck

SAMPLES = 9  # plastic strains at which a fit is compared
STEPS = 4  # rates between two of the table, by which it is compared too
BEYOND = 10.0  # how far beyond the rates it is compared
USUAL_EXPONENT = 5.0  # of steel, where one rate alone is given
MOST_RATES, MOST_ROWS = 12, 240  # of percuss' table
Curves = list[tuple[float, Points]]  # rates ascending
Factors = list[tuple[float, float]]  # rate, factor of the stress


def find_share(low: float, high: float, rate: float, logarithmic: bool) -> float:
    return math.log(rate / low) / math.log(high / low) if logarithmic else (rate - low) / (high - low)


def find_stress(curves: Curves, p: float, rate: float, logarithmic: bool) -> float:
    """As the law of percuss: between the rates straight over the rate or its logarithm, beyond them constant."""
    if rate <= curves[0][0]:
        return interpolate(curves[0][1], p)
    for (low, first), (high, second) in zip(curves, curves[1:]):
        if rate <= high:
            share = find_share(low, high, rate, logarithmic)
            return interpolate(first, p) * (1 - share) + interpolate(second, p) * share
    return interpolate(curves[-1][1], p)


def scale_curve(base: Points, factors: Points) -> Curves:
    """The curve times a factor at each rate."""
    return [(rate, [(p, factor * stress) for p, stress in base]) for rate, factor in factors]


def order_curves(place: Place, curves: Curves) -> Curves:
    """Curves in the order of their rates."""
    curves = sorted(curves, key=lambda curve: curve[0])
    for (low, _), (high, _) in zip(curves, curves[1:]):
        if high == low:
            raise BadInput(place, f"two curves are for the rate {high:g} (rates must differ): remove one")
    if curves[0][0] < 0:
        raise BadInput(place, f"a curve is for the rate {curves[0][0]:g} (rates must not be negative): correct it")
    if any(stress <= 0 for _, points in curves for _, stress in points):
        raise BadInput(place, "a yield stress of a curve is not positive (percuss needs one at each rate): correct it")
    return curves


def add_rates(ledger: Ledger, place: Place, law: Deck, curves: Curves, key: str, logarithmic: bool = False) -> None:
    """Gives a law that yields the curves of all rates, ascending; without kinematic hardening."""
    for name in ("yield_stress", "hardening_modulus", "kinematic_share", "hardening"):
        law.pop(name, None)
    if ledger.fits_rates:
        add_fit(ledger, place, law, curves, key, logarithmic)
        return
    curves, error = thin_curves(curves, logarithmic)
    if error > 1e-12:
        ledger.approximated(
            key, place, f"curves become {len(curves)} with {sum(len(rows) for _, rows in curves)} rows in all, "
                        f"within {error:.2g} of the largest stress"
        )
    law |= {"model": "rate_table_plasticity",
            "hardening_at_rates": [[rate, [list(row) for row in rows]] for rate, rows in curves]}
    if logarithmic:
        law["rate_interpolation"] = "logarithmic"


def thin_curves(curves: Curves, logarithmic: bool) -> tuple[Curves, float]:
    """At most as many rates and rows as percuss takes, and the largest error as a share of the largest stress.

    The rate between two others whose absence changes the stress least is removed first.
    """
    kept = list(curves)
    while len(kept) > MOST_RATES:
        del kept[min(range(1, len(kept) - 1), key=lambda k: measure_absence(kept, k, logarithmic))]
    left, rows = MOST_ROWS, {}
    # what short ones leave goes to long ones
    for done, k in enumerate(sorted(range(len(kept)), key=lambda k: len(kept[k][1]))):
        rows[k] = thin_rows(kept[k][1], left // (len(kept) - done))[0]
        left -= len(rows[k])
    kept = [(rate, rows[k]) for k, (rate, _) in enumerate(kept)]
    largest = max(stress for _, points in curves for _, stress in points)
    return (kept, max(abs(find_stress(kept, p, rate, logarithmic) - stress) for rate, points in curves
                      for p, stress in points) / largest)


def measure_absence(curves: Curves, k: int, logarithmic: bool) -> float:
    """The largest change of the stress on curve k without it."""
    rate, points = curves[k]
    return max(abs(find_stress([curves[k - 1], curves[k + 1]], p, rate, logarithmic) - stress) for p, stress in points)


# --- the fit


def fit_cowper_symonds(factors: Factors) -> tuple[float, float] | None:
    """C and P by least squares over logarithms; None where the stress does not grow."""
    rows = [(math.log(rate), math.log(factor - 1)) for rate, factor in factors if rate > 0 and factor > 1 + 1e-9]
    if not rows:
        return None
    x, y = (sum(row[i] for row in rows) / len(rows) for i in (0, 1))
    spread = sum((row[0] - x) ** 2 for row in rows)
    slope = sum((row[0] - x) * (row[1] - y) for row in rows) / spread if spread > 0 else 1 / USUAL_EXPONENT
    if slope <= 0:
        return None
    return math.exp(x - y / slope), 1 / slope


def scale_stress(law: "tuple[float, float] | None", rate: float) -> float:
    return float(1 + (rate / law[0]) ** (1 / law[1]) if law and rate > 0 else 1.0)


def find_common_strains(curves: Curves) -> list[float]:
    """Plastic strains that all curves have."""
    first, last = max(points[0][0] for _, points in curves), min(points[-1][0] for _, points in curves)
    return [first + max(last - first, 0.0) * i / (SAMPLES - 1) for i in range(SAMPLES)]


def list_compared_rates(curves: Curves) -> list[float]:
    """The rates, some between each two of them, and some beyond."""
    rates = [rate for rate, _ in curves if rate > 0]
    spans = [(rates[0] / BEYOND, rates[0]), *zip(rates, rates[1:]), (rates[-1], BEYOND * rates[-1])]
    return rates + [low * (high / low) ** (i / STEPS) for low, high in spans for i in range(STEPS + 1)]


def measure_fit(curves: Curves, law: "tuple[float, float] | None", logarithmic: bool) -> tuple[float, float]:
    """The largest error of the law, as a share of the table's stress, and the rate where it is."""
    errors = []
    for rate in list_compared_rates(curves):
        for p in find_common_strains(curves):
            exact = find_stress(curves, p, rate, logarithmic)
            errors.append((abs(scale_stress(law, rate) * interpolate(curves[0][1], p) / exact - 1), rate))
    return max(errors)


def add_fit(ledger: Ledger, place: Place, law: Deck, curves: Curves, key: str, logarithmic: bool) -> None:
    """The curve of the lowest rate with Cowper and Symonds' factors."""
    base, strains = curves[0][1], find_common_strains(curves)
    means = [(rate, sum(interpolate(points, p) / interpolate(base, p) for p in strains) / SAMPLES)
             for rate, points in curves[1:]]
    found = fit_cowper_symonds(means)
    error, rate = measure_fit(curves, found, logarithmic)
    text = (f"Cowper and Symonds with C = {found[0]:.4g} and P = {found[1]:.4g}" if found
            else "the stress does not depend on the rate")
    ledger.approximated(
        key, place, f"{text}, as asked for: {100 * error:.2g} % off the table at {rate:.4g}, "
                    "the worst from a tenth of its lowest rate to ten times its highest"
    )
    law |= {"model": "tabulated_plasticity", "hardening": [list(row) for row in thin_rows(base, MOST_MATERIAL_ROWS)[0]]}
    if found:
        law["cowper_symonds_rate"], law["cowper_symonds_exponent"] = found
