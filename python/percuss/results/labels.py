"""Labels of expressions and the units that they name: no label stands beside a number in another unit.

An expression is computed of the history in the units of the deck, in which its numbers are meant, whatever units are
shown: 9810 is an acceleration of mm and s. What it makes is converted by its dimension, or stays as its label says."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from .expressions import clip, compute, find_multiplier, split_label, split_unit
from .history import History
from .units import Powers, Units, is_unit, measure_unit

NEAR = 5.0  # times: numbers of a formula are either a conversion, or a half or a mean


@dataclass
class Labelled:
    """What an expression makes: values [rows] or a number, in the units of the history that it was read for."""

    name: str
    values: Any
    deck_values: Any  # in the units of the deck
    powers: Powers | None  # of length, mass and time; None: the dimension is not known, or the label names the unit
    unit: str | None  # the label's unit; None: what follows from the powers
    note: str = ""  # what the user is told of its unit


def read_labelled(history: History, word: str, source: Any = None) -> Labelled:
    """word: an expression, with a label or not. source: the columns in the units of the deck, where they are not those
    of the history. BadExpression where it cannot be computed."""
    label, text = split_label(word)
    name, given = split_unit(label) if label != text else (label, None)
    deck = history.of_deck
    value = compute(deck if source is None else source, text)
    factor, unit, note = 1.0, None, ""
    if given is not None:
        factor, unit, note = settle_unit(given, value.powers, find_multiplier(text, deck.everything), deck.units)
    values = value.values * factor
    powers = value.powers if unit is None else None
    if history is deck or deck.units is None or history.units is None:
        return Labelled(name, values, values, powers, unit, note and f"'{clip(label)}': {note}")
    if powers is not None:
        shown = values * (deck.units.size_of(powers) / history.units.size_of(powers))
        return Labelled(name, shown, values, powers, unit, note and f"'{clip(label)}': {note}")
    is_number = value.powers is not None and not any(value.powers)
    if not is_number and (unit is None or measure_unit(unit, value.powers) is None):
        note = ("its unit does not follow from its columns, so that it stays in the units of the deck "
                f"({deck.units.text})")
    return Labelled(name, values, values, None, unit, note and f"'{clip(label)}': {note}")


def settle_unit(given: str, powers: Powers | None, multiplier: float | None,
                units: Units | None) -> tuple[float, str | None, str]:
    """What to multiply by so that numbers of a formula are in the unit that its label names, that unit, and why it is
    not the one that was given. multiplier: what the numbers in the formula multiply its columns by; None: it is not
    known. A label whose unit is none of the dimension of the columns stands where the formula has numbers,
    which then have a dimension of their own."""
    size = measure_unit(given, powers)
    if units is None or powers is None:
        return 1.0, given, ""
    if size is None:
        own = units.name_of_powers(powers)
        if multiplier != 1 or not own or not is_unit(given):
            return 1.0, given, ""
        return 1.0, None, f"its columns make {own}, and not {given}, so that the label loses its unit: correct it"
    wanted = units.size_of(powers) / size
    if math.isclose(wanted, 1, rel_tol=1e-9):
        return 1.0, given, ""
    if multiplier and _are_near(multiplier, wanted) and abs(math.log(multiplier / wanted)) <= abs(math.log(multiplier)):
        return 1.0, given, ""  # the formula has converted
    if multiplier and _are_near(multiplier, 1):
        return wanted, given, ""
    own = units.name_of_powers(powers)
    return (1.0, None, (f"its numbers do not turn {own} into {given} "
                        f"(that is a factor of {wanted:.6g}), so that the label loses its "
                        "unit: leave the factor out, and percuss converts to that unit"))


def _are_near(a: float, b: float) -> bool:
    return 1 / NEAR <= a / b <= NEAR
