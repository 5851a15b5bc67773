"""Expressions over the columns of a history: force over displacement, resultants, absorbed energy.

Python's own parser reads them, and only what stands below is computed: numbers, columns, + - * / ** ( ) and the
functions of FUNCTIONS. Dimensions follow, so that units are known."""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Iterable
from typing import Any, NoReturn

import numpy as np

from ..nearest import suggest
from .arrays import Array
from .history import History
from .units import Powers, find_powers

MOST_CHARACTERS, MOST_DEPTH, LARGEST_POWER = 2000, 60, 100
PLAIN: Powers = (0, 0, 0)


class BadExpression(ValueError):
    """An expression cannot be computed; str() is a message for the user."""


class Value:
    """An array [rows] or a number with its dimension.
    powers: of length, mass and time; None where the dimension is not known."""

    def __init__(self, values: Any, powers: Powers | None = PLAIN) -> None:
        self.values, self.powers = values, powers

    def combine(self, other: Value, values: Any, sign: int) -> Value:
        """The product (sign 1) or the quotient (-1)."""
        if self.powers is None or other.powers is None:
            return Value(values, None)
        return Value(values, tuple(a + sign * b for a, b in zip(self.powers, other.powers)))

    def is_plain(self) -> bool:
        return self.powers in (PLAIN, None)


def compute(history: History, text: str) -> Value:
    """The Value, with an array [rows] or one number. BadExpression with the reason."""
    tree, columns = _parse(text, history.everything)
    with np.errstate(all="ignore"):
        return _Reader(history, columns, text).read(tree, 0)


def spread(values: Any, rows: int) -> Array:
    """[rows] of a number or of an array."""
    return np.broadcast_to(np.asarray(values, dtype=float), (rows,)).copy()


def evaluate(history: History, text: str) -> tuple[Array, Powers | None]:
    """(values [rows], powers of length, mass and time, or None). BadExpression with the reason."""
    value = compute(history, text)
    return spread(value.values, len(history)), value.powers


def split_label(text: str) -> tuple[str, str]:
    """('crush', 'max(a)') of 'crush = max(a)'; the text twice where there is no label."""
    label, equals, rest = text.partition("=")
    if not equals or not label.strip():
        label, rest = text, text
    return label.strip(), rest.strip()


def split_unit(label: str) -> tuple[str, str | None]:
    """('acceleration', 'g') of 'acceleration [g]':
    the unit that a label gives what an expression makes; None: it gives none."""
    given = re.fullmatch(r"(.*\S)\s*\[([^\[\]]*)\]", label)
    return (given[1], given[2].strip()) if given else (label, None)


def clip(text: str) -> str:
    return text if len(text) <= 80 else text[:77] + "..."


def is_expression(text: str, names: Iterable[str]) -> bool:
    """Whether a text is more than the name of a column, and could be computed."""
    if text in names:
        return False
    try:
        tree, columns = _parse(text, names)
    except BadExpression:
        return False
    return not isinstance(tree, (ast.Name, ast.Constant, ast.Tuple))


def find_multiplier(text: str, names: Iterable[str]) -> float | None:
    """What the numbers of an expression multiply its columns by: 1e-3 of 'max(a) / 1000'. None where its terms differ
    by more than a half or a mean makes them."""
    return _multiply(_parse(text, names)[0])


def _multiply(node: ast.expr) -> float | None:
    if isinstance(node, ast.Constant):
        return abs(float(node.value)) if isinstance(node.value, (int, float)) else 1.0
    if isinstance(node, ast.UnaryOp):
        return _multiply(node.operand)
    if isinstance(node, ast.BinOp):
        return _multiply_two(node, _multiply(node.left), _multiply(node.right))
    if not isinstance(node, ast.Call) or not isinstance(node.func, ast.Name) or not node.args:
        return 1.0
    name, factors = node.func.id, [_multiply(argument) for argument in node.args]
    first = factors[0]
    if first is None or name in ("resultant", "distance", "exp", "log", "sin", "cos", "tan"):
        return first and 1.0
    if name == "sqrt":
        return float(first**0.5)
    if name in ("integral", "derivative") and len(factors) > 1:
        return factors[1] and (first * factors[1] if name == "integral" else first / factors[1])
    return (first if name == "cfc"
            else _agree_on_factor([x for x, node in zip(factors, node.args) if not isinstance(node, ast.Constant)]))


def _multiply_two(node: ast.BinOp, left: float | None, right: float | None) -> float | None:
    if isinstance(node.op, (ast.Add, ast.Sub)):
        return _agree_on_factor([x for x, term in ((left, node.left), (right, node.right))
                                 if not isinstance(term, ast.Constant)])
    if left is None or right is None:
        return None
    if isinstance(node.op, ast.Pow):
        try:
            return left**right if left else None
        except OverflowError:
            return None
    return left * right if isinstance(node.op, ast.Mult) else left / right if right else None


def _agree_on_factor(factors: list[float | None]) -> float | None:
    """Common factor of terms that are added."""
    known = [factor for factor in factors if factor]
    return (known[0] if known and len(known) == len(factors) and max(known) <= 5 * min(known)
            else None if factors else 1.0)


def check_syntax(text: str, names: Iterable[str]) -> None:
    """BadExpression where a text has signs of an expression, and cannot be computed."""
    if re.search(r"[()+'\"]|\s[-*/]|[-*/]\s", text):
        _parse(text, names)


def _parse(text: str, names: Iterable[str]) -> tuple[ast.expr, dict[str, str]]:
    """The tree, with names of Python in place of columns, and what they stand for. Names of columns may hold signs that
    Python does not know (fx:hit, f_x:a/b): the longest that is there counts; any may stand in braces."""
    if len(text) > MOST_CHARACTERS:
        raise BadExpression(f"the expression is too long ({len(text)} characters, {MOST_CHARACTERS} at most)")
    columns: dict[str, str] = {}

    def stand_in(name: str) -> str:
        return columns.setdefault(name, f"column_{len(columns)}_")

    def replace(match: re.Match[str]) -> str:
        if match[1] is not None:
            return stand_in(match[1].strip())
        word = match[0]
        return stand_in(word) if word in known or ":" in word and word[0] not in "'\"" else word

    known = set(names)
    odd = sorted((name for name in known if not name.isidentifier()), key=len, reverse=True)
    pattern = "|".join([r"\{([^{}]*)\}", r"'[^']*'", r'"[^"]*"', *(re.escape(name) + r"(?![\w:])" for name in odd),
                        r"[A-Za-z_]\w*(?::[\w./-]*\w)?"])
    try:
        tree = ast.parse(re.sub(pattern, replace, text).strip(), mode="eval").body
    except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
        raise BadExpression(f"'{clip(text)}' is no expression ({getattr(error, 'msg', None) or error})") from None
    return tree, {placeholder: name for name, placeholder in columns.items()}


class _Reader:
    """Computes a tree."""

    def __init__(self, history: History, columns: dict[str, str], text: str) -> None:
        self.history, self.columns, self.text = history, columns, text

    def fail(self, why: str) -> NoReturn:
        raise BadExpression(f"'{clip(self.text)}': {why}")

    def read(self, node: ast.expr, depth: int) -> Value:
        if depth > MOST_DEPTH:
            self.fail("it is nested too deep")
        if isinstance(node, ast.Constant) and isinstance(node.value, (int, float)) and not isinstance(node.value, bool):
            return Value(float(node.value))
        if isinstance(node, ast.Name):
            return self.column(self.columns.get(node.id, node.id))
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, (ast.USub, ast.UAdd)):
            value = self.read(node.operand, depth + 1)
            return Value(-value.values if isinstance(node.op, ast.USub) else value.values, value.powers)
        if isinstance(node, ast.BinOp):
            return self.operate(node, depth)
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and not node.keywords:
            return self.call(node.func.id, node.args, depth)
        return self.fail("it may have numbers, columns, + - * / ** ( ) and functions: " + ", ".join(FUNCTIONS))

    def column(self, name: str) -> Value:
        names = self.history.everything
        if name not in names:
            self.fail(f"there is no column '{name}'" + suggest(name, names, f" (there are {', '.join(names)})"))
        return Value(self.history[name], find_powers(self.history.dimension(name)))

    def operate(self, node: ast.BinOp, depth: int) -> Value:
        left, right = self.read(node.left, depth + 1), self.read(node.right, depth + 1)
        a, b = left.values, right.values
        if isinstance(node.op, (ast.Add, ast.Sub)):
            return Value(a + b if isinstance(node.op, ast.Add) else a - b, self.agree(left, right))
        if isinstance(node.op, ast.Mult):
            return left.combine(right, a * b, 1)
        if isinstance(node.op, ast.Div):
            return left.combine(right, np.divide(a, b), -1)
        if isinstance(node.op, ast.Pow):
            if np.ndim(b) or not abs(b) <= LARGEST_POWER or not right.is_plain():
                self.fail("a power must be a number")
            powers = left.powers and tuple(_whole(p * b) for p in left.powers)
            return Value(np.power(np.asarray(a, dtype=float), b), powers)
        return self.fail("it may have + - * / **")

    def agree(self, *values: Value) -> Powers | None:
        """The dimension of a sum. Numbers are of any."""
        found = {value.powers for value in values if not (np.ndim(value.values) == 0 and value.powers == PLAIN)}
        if None in found:
            return None
        if len(found) > 1:
            self.fail("what is added or compared has different dimensions")
        return found.pop() if found else PLAIN

    def call(self, name: str, arguments: list[ast.expr], depth: int) -> Value:
        if name not in FUNCTIONS:
            self.fail(f"there is no function '{name}'"
                      + suggest(name, FUNCTIONS, f" (there are {', '.join(FUNCTIONS)})"))
        function, least, most, takes_names = FUNCTIONS[name]
        if not least <= len(arguments) <= most:
            self.fail(f"{name}() takes {least if least == most else f'{least} to {most}'} argument{'s' * (most != 1)}")
        if takes_names:
            return function(self, *[self.name_of(argument) for argument in arguments])
        return function(self, *[self.read(argument, depth + 1) for argument in arguments])

    def name_of(self, node: ast.expr) -> str:
        """A text in quotes, or a name."""
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            return node.value
        if isinstance(node, ast.Name):
            return self.columns.get(node.id, node.id)
        return self.fail("a name is needed here, such as 'hit'")

    def rows(self, value: Value) -> Array:
        return np.broadcast_to(np.asarray(value.values, dtype=float), (len(self.history),))

    @property
    def time(self) -> Value:
        return Value(self.history["time"], find_powers("time"))


def _whole(power: float) -> float:
    return int(power) if float(power).is_integer() else power


def _keep(function: Callable[[Array], Any]) -> Callable[[_Reader, Value], Value]:
    """A function whose result has the dimension of its argument."""
    return lambda reader, value: Value(function(reader.rows(value)), value.powers)


def _plain(function: Callable[[Array], Any]) -> Callable[[_Reader, Value], Value]:
    def compute(reader: _Reader, value: Value) -> Value:
        if not value.is_plain():
            reader.fail("an argument must have no dimension: divide it by its unit, such as 1 m")
        return Value(function(np.asarray(value.values, dtype=float)))

    return compute


def _root(reader: _Reader, value: Value) -> Value:
    return Value(np.sqrt(value.values), value.powers and tuple(_whole(p / 2) for p in value.powers))


def _extreme(of_two: Callable[[Any, Any], Any], of_rows: Callable[[Array], Any]) -> Callable[..., Value]:
    def compute(reader: _Reader, first: Value, second: Value | None = None) -> Value:
        if second is None:
            return Value(float(of_rows(reader.rows(first))), first.powers)
        return Value(of_two(first.values, second.values), reader.agree(first, second))

    return compute


def _integral(reader: _Reader, value: Value, over: Value | None = None) -> Value:
    """Integral from the first row on, by the trapezoidal rule."""
    over = over or reader.time
    y, x = reader.rows(value), reader.rows(over)
    steps = 0.5 * (y[1:] + y[:-1]) * np.diff(x)
    return value.combine(over, np.concatenate([[0.0], np.cumsum(steps)])[: len(y)], 1)


def _derivative(reader: _Reader, value: Value, over: Value | None = None) -> Value:
    """Derivative by the slopes to both neighbours, of second order for rows at unequal distances."""
    over = over or reader.time
    y, x = reader.rows(value), reader.rows(over)
    if len(y) < 2:
        reader.fail("a derivative needs two rows")
    return value.combine(over, np.gradient(y, x, edge_order=2 if len(y) > 2 else 1), -1)


def _mean(reader: _Reader, value: Value) -> Value:
    """Over time."""
    y, t = reader.rows(value), reader.history["time"]
    span = t[-1] - t[0] if len(t) else 0
    return Value(float(np.sum(0.5 * (y[1:] + y[:-1]) * np.diff(t)) / span) if span > 0 else float(np.mean(y)),
                 value.powers)


def _norm(reader: _Reader, *values: Value) -> Value:
    return Value(np.sqrt(sum(np.square(value.values) for value in values)), reader.agree(*values))


def _resultant(reader: _Reader, name: str) -> Value:
    """resultant('hit'): of fx:hit, fy:hit, fz:hit; resultant('m:hit') of mx:hit ...; of a column with an axis at its
    end (wall_force, momentum, top_v) likewise."""
    head, colon, tail = name.partition(":")
    trials = [f"f%s:{name}", f"{head}%s:{tail}" if colon else f"{name}_%s", f"{name}%s"]
    for trial in trials:
        if all(trial % axis in reader.history for axis in "xyz"):
            return _norm(reader, *[reader.column(trial % axis) for axis in "xyz"])
    known = [x.replace("fx:", "", 1).removesuffix("_x")
             for x in reader.history.everything if x.startswith("fx:") or x.endswith("_x")]
    return reader.fail(f"there are no three columns of a resultant '{name}', "
                       f"such as fx:{name} or {name}_x{suggest(name, known)}")


def _distance(reader: _Reader, one: str, other: str) -> Value:
    """Distance of two history nodes."""
    gaps = []
    for axis in "xyz":
        a, b = reader.column(f"{one}_{axis}"), reader.column(f"{other}_{axis}")
        gaps.append(Value(a.values - b.values, reader.agree(a, b)))
    return _norm(reader, *gaps)


def _filter(reader: _Reader, value: Value, channel_class: Value) -> Value:
    """CFC of SAE J211; rows are resampled to equal steps and back."""
    from .filters import filter_cfc, resample

    if np.ndim(channel_class.values):
        reader.fail("the class of a filter is a number")
    seconds = reader.history.units.time[1] if reader.history.units else 1.0
    try:
        time, values = resample(reader.history["time"], reader.rows(value))
        values = filter_cfc(values, (time[1] - time[0]) * seconds, int(channel_class.values))
    except ValueError as error:
        reader.fail(str(error))
    return Value(np.interp(reader.history["time"], time, values), value.powers)


# name: (function, least and largest number of arguments, whether these are names)
FUNCTIONS: dict[str, tuple[Callable[..., Value], int, int, bool]] = {
    "abs": (_keep(np.abs), 1, 1, False), "sqrt": (_root, 1, 1, False), "exp": (_plain(np.exp), 1, 1, False),
    "log": (_plain(np.log), 1, 1, False), "sin": (_plain(np.sin), 1, 1, False), "cos": (_plain(np.cos), 1, 1, False),
    "tan": (_plain(np.tan), 1, 1, False), "max": (_extreme(np.maximum, np.nanmax), 1, 2, False),
    "min": (_extreme(np.minimum, np.nanmin), 1, 2, False), "first": (_keep(lambda y: float(y[0])), 1, 1, False),
    "last": (_keep(lambda y: float(y[-1])), 1, 1, False), "change": (_keep(lambda y: y - y[0]), 1, 1, False),
    "mean": (_mean, 1, 1, False), "integral": (_integral, 1, 2, False), "derivative": (_derivative, 1, 2, False),
    "norm": (_norm, 1, 6, False), "resultant": (_resultant, 1, 1, True), "distance": (_distance, 2, 2, True),
    "cfc": (_filter, 2, 2, False),
}
