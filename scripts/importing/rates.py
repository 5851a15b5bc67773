"""Curves for several strain rates, and factors over the rate, as Cowper and Symonds' law: 1 + (rate / C)^(1 / P)."""

import math

from .curves import Points, interpolate
from .ledger import Ledger, Place
from .model import Deck

SAMPLES = 9  # plastic strains at which curves are compared
CLOSE = 0.05  # error that is no more than an approximation
USUAL_EXPONENT = 5.0  # of steel, where one rate alone is given
Factors = list[tuple[float, float]]  # rate, factor of the stress


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
    return 1 + (rate / law[0]) ** (1 / law[1]) if law and rate > 0 else 1.0


def compare_curves(curves: list[tuple[float, Points]]) -> list[tuple[float, list[float]]]:
    """For each rate but the lowest the stresses over those of the lowest, at plastic strains that all curves have."""
    base = curves[0][1]
    first, last = max(points[0][0] for _, points in curves), min(points[-1][0] for _, points in curves)
    strains = [first + max(last - first, 0.0) * i / (SAMPLES - 1) for i in range(SAMPLES)]
    found = []
    for rate, points in curves[1:]:
        pairs = [(interpolate(base, p), interpolate(points, p)) for p in strains]
        found.append((rate, [high / low for low, high in pairs if low > 0]))
    return [(rate, ratios) for rate, ratios in found if ratios]


def choose_rate(ledger: Ledger, place: Place, ratios: list[tuple[float, list[float]]], key: str, what: str) -> Deck | None:
    """Keys of the law that fits best. None where the user does not allow it."""
    found = fit_cowper_symonds([(rate, sum(values) / len(values)) for rate, values in ratios])
    errors = [abs(scale_stress(found, rate) / value - 1) for rate, values in ratios for value in values if value > 0]
    error = max(errors, default=0.0)
    text = f"Cowper and Symonds with C = {found[0]:.4g} and P = {found[1]:.4g}" if found else "the stress does not depend on the rate"
    text += f", within {100 * error:.2g} %"
    if error <= CLOSE:
        ledger.approximated(key, place, f"{what}: {text}")
    elif not ledger.refuse(key, place, what, text):
        return None
    return {"cowper_symonds_rate": found[0], "cowper_symonds_exponent": found[1]} if found else {}
