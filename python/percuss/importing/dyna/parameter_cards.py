"""*PARAMETER and *PARAMETER_EXPRESSION: how parameters get their values."""

from ..fields import clip, parse_real
from ..ledger import BadInput, Ledger
from .cards import Card
from .parameters import Parameters, Value, evaluate


def read_parameters(parameters: Parameters, card: Card, ledger: Ledger) -> None:
    """Reads a *PARAMETER card."""
    words = card.keyword.split("_")[1:]
    if words == ["DUPLICATION"]:
        ledger.ignored(card.keyword, card.place, "a second value of a parameter is an error here")
        return
    if any(word not in ("EXPRESSION", "LOCAL", "MUTABLE", "GLOBAL", "TYPE") for word in words):
        ledger.refuse(card.keyword, card.place, "this form of parameters")
        return
    scope = parameters if "LOCAL" in words else parameters.root()
    pairs = _read_expressions(parameters, card) if "EXPRESSION" in words else _read_values(card)
    for number, word, value in pairs:
        scope.define(word, value, card.at(number), "MUTABLE" in words)
        ledger.translated(card.keyword, card.place, "values are put in place")


def _read_values(card: Card) -> list[tuple[int, str, Value]]:
    pairs: list[tuple[int, str, Value]] = []
    for line in card.lines:
        texts = card.split(line, (10,) * 8)
        texts = texts[:2] if "TYPE" in card.keyword else texts  # behind the value stands what it is an id of
        for word, text in zip(texts[::2], texts[1::2]):
            if not word:
                continue
            value: Value | None = text if word[:1] in "cC" else parse_real(text)
            if value is None:
                raise BadInput(card.at(line[0]),
                               f"the value of {clip(word)} is '{clip(text)}' (a number is expected)")
            pairs.append((line[0], word, value))
    return pairs


def _read_expressions(parameters: Parameters, card: Card) -> list[tuple[int, str, Value]]:
    pairs: list[tuple[int, str, Value]] = []
    for number, line in card.lines:
        if not line.strip():
            continue
        word, _, text = (
            line.partition(",")
            if "," in line[:11]
            else (line[: max(10, card.least_width)], "", line[max(10, card.least_width) :])
        )
        value = evaluate(text.strip(), parameters, card.at(number))
        scope = parameters if "LOCAL" in card.keyword else parameters.root()
        scope.define(word.strip(), value, card.at(number), "MUTABLE" in card.keyword)
        pairs.append((number, word.strip(), value))
    return pairs
