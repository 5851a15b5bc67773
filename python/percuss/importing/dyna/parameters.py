"""Values by name that stand in fields, and expressions of them."""

import copy
import math
import re
from bisect import bisect_right
from collections.abc import Callable

from ..fields import clip, parse_real
from ..ledger import BadInput, Place, missing
from .transforms import UNCHANGED, FileChange

NAME = re.compile(r"&([A-Za-z_][A-Za-z0-9_]*)")
TOKEN = re.compile(r"\s*(?:(\d+\.?\d*(?:[eEdD][+-]?\d{1,4})?|\.\d+(?:[eEdD][+-]?\d{1,4})?)|&?([A-Za-z_]\w*)|(\*\*|"
                   r"[-+*/^(),]))")
OPERATION = re.compile(r"\w[-+*/(]")  # &end*0.99 in a field
MOST_DEPTH = 60
FUNCTIONS: dict[str, Callable[..., float | int]] = {
    "abs": abs, "sqrt": math.sqrt, "exp": math.exp, "log": math.log, "log10": math.log10, "sin": math.sin,
    "cos": math.cos, "tan": math.tan, "asin": math.asin, "acos": math.acos, "atan": math.atan, "sinh": math.sinh,
    "cosh": math.cosh, "tanh": math.tanh, "int": int, "aint": lambda x: float(int(x)),
    "nint": lambda x: int(math.floor(x + 0.5)), "float": float, "ceil": math.ceil, "floor": math.floor,
    "sign": lambda a, b: math.copysign(a, b), "atan2": math.atan2, "min": min, "max": max, "mod": math.fmod,
}  # fmt: skip
Value = float | int | str


class Parameters:
    """Values by name, in capitals. Those of _LOCAL are known in one file and those that it includes.
    A file also has what is done to it."""

    def __init__(self, outer: "Parameters | None" = None, change: FileChange = UNCHANGED):
        self._outer = outer
        self._values: dict[str, list[tuple[int, Value]]] = {}  # with their numbers, ascending
        self._count: list[int] = outer._count if outer else [0]  # of all values that are given
        self._known = math.inf  # the number of the last value that is known
        self.change = change

    def inner(self, change: FileChange = UNCHANGED) -> "Parameters":
        return Parameters(self, change.inside(self.change) if change is not UNCHANGED else self.change)

    def freeze(self) -> "Parameters":
        """As they are now: a card has the values that stand before it, whenever it is read."""
        frozen = copy.copy(self)
        frozen._known = self._count[0]
        return frozen

    def find(self, name: str, place: Place) -> Value:
        scope: Parameters | None = self
        while scope:
            values = scope._values.get(name.upper(), [])
            before = bisect_right(values, self._known, key=lambda pair: pair[0])
            if before:
                return values[before - 1][1]
            scope = scope._outer
        raise BadInput(place, missing(f"parameter &{clip(name)}"))

    def replace(self, text: str, place: Place) -> str:
        """A field with the values of its parameters."""
        words = text.replace(" ", "")
        if words.startswith(("<", "&<")):
            return str(evaluate(words.strip("&<>"), self, place))
        if OPERATION.search(words):
            return str(evaluate(words, self, place))
        value = NAME.sub(lambda found: str(self.find(found.group(1), place)), words)
        return value[2:] if value.startswith("--") else value
    def root(self) -> "Parameters":
        return self._outer.root() if self._outer else self

    def define(self, word: str, value: Value, place: Place, is_mutable: bool) -> None:
        kind, name = word[:1].upper(), word[1:].strip().upper()
        if kind not in ("R", "I", "C") or not name:
            raise BadInput(place, f"'{clip(word)}' is no parameter (R, I or C and its name are expected)")
        values = self._values.setdefault(name, [])
        if values and not is_mutable and values[-1][1] != value:
            raise BadInput(place, f"parameter {clip(name)} has a value already: remove one definition")
        if kind == "C" or isinstance(value, str):
            value = str(value)
        else:
            value = int(value) if kind == "I" else float(value)
        if not values or values[-1][1] != value:
            self._count[0] += 1
            values.append((self._count[0], value))


def evaluate(text: str, parameters: Parameters, place: Place) -> float | int:
    """Value of an expression: integers divide as in Fortran."""
    try:
        value = Expression(text, parameters, place).value()
        is_finite = not isinstance(value, complex) and math.isfinite(value)
    except (ArithmeticError, ValueError, TypeError) as error:
        raise BadInput(place, f"'{clip(text)}' has no value ({error})") from None
    if not is_finite:
        raise BadInput(place, f"'{clip(text)}' has no value")
    return value


class Expression:
    """Recursive descent over + - * / ** ( ) and functions."""

    def __init__(self, text: str, parameters: Parameters, place: Place):
        self._text, self._parameters, self._place = text, parameters, place
        self._tokens = self._cut(text)
        self._next = self._depth = 0

    def _fail(self, text: str) -> BadInput:
        return BadInput(self._place, f"the expression '{clip(self._text)}' {text}")

    def _cut(self, text: str) -> list[tuple[str, str, str]]:
        tokens, first, text = [], 0, text.strip()
        while first < len(text):
            found = TOKEN.match(text, first)
            if not found:
                raise self._fail(f"has '{clip(text[first:], 5)}', which is not understood")
            tokens.append((found[1] or "", found[2] or "", found[3] or ""))
            first = found.end()
        return tokens

    def _take(self, *symbols: str) -> str:
        if self._next < len(self._tokens) and self._tokens[self._next][2] in symbols and self._tokens[self._next][2]:
            self._next += 1
            return self._tokens[self._next - 1][2]
        return ""

    def value(self) -> float | int:
        value = self._sum()
        if self._next < len(self._tokens):
            raise self._fail("goes on behind its end")
        return value

    def _sum(self) -> float | int:
        self._depth += 1
        if self._depth > MOST_DEPTH:
            raise self._fail("has too many brackets")
        value = self._product()
        while sign := self._take("+", "-"):
            value = value + self._product() if sign == "+" else value - self._product()
        self._depth -= 1
        return value

    def _product(self) -> float | int:
        value = self._signed()
        while sign := self._take("*", "/"):
            other = self._signed()
            if sign == "*":
                value = value * other
            elif isinstance(value, int) and isinstance(other, int):
                value = int(value / other)
            else:
                value = value / other
        return value

    def _signed(self) -> float | int:
        sign = 1
        while word := self._take("-", "+"):
            sign = -sign if word == "-" else sign
        return sign * self._power()

    def _power(self) -> float | int:
        base = self._atom()
        if not self._take("**", "^"):
            return base
        self._depth += 1
        if self._depth > MOST_DEPTH:
            raise self._fail("has too many powers")
        exponent = self._signed()
        self._depth -= 1
        if isinstance(base, int) and isinstance(exponent, int) and 0 <= exponent <= 60:
            return int(float(base) ** exponent) if abs(float(base) ** exponent) > 2**53 else base**exponent
        value = float(base) ** exponent
        if isinstance(value, complex):
            raise self._fail("has a root of a negative number")
        return value

    def _atom(self) -> float | int:
        if self._take("("):
            value = self._sum()
            if not self._take(")"):
                raise self._fail("lacks a bracket")
            return value
        if self._next >= len(self._tokens):
            raise self._fail("ends too early")
        number, name, symbol = self._tokens[self._next]
        self._next += 1
        if number:
            return int(number) if number.isdigit() and len(number) < 16 else float(parse_real(number) or 0.0)
        if symbol:
            raise self._fail(f"has '{symbol}' in a wrong place")
        if self._take("("):
            return self._call(name.lower())
        return self._constant(name)

    def _constant(self, name: str) -> float | int:
        if name.lower() == "pi":
            return math.pi
        value = self._parameters.find(name, self._place)
        if isinstance(value, str):
            raise self._fail(f"has &{clip(name)}, which is a text")
        return value

    def _call(self, name: str) -> float | int:
        arguments = [self._sum()]
        while self._take(","):
            arguments.append(self._sum())
        if not self._take(")"):
            raise self._fail("lacks a bracket")
        if name not in FUNCTIONS:
            raise self._fail(f"has {clip(name)}(), which is not known")
        return FUNCTIONS[name](*arguments)
