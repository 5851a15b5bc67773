"""*PARAMETER: names with values, which stand as <name> in other lines."""

import ast
import math
import operator
import re
from collections.abc import Callable

from ..fields import clip
from ..ledger import BadInput, Place, missing
from .lines import Block

Value = float | int | str
MOST_POWER, LONGEST = 1000.0, 1000  # so that a deck cannot ask for numbers without end
NAME = re.compile(r"<\s*([A-Za-z_]\w*)\s*>")
FUNCTIONS: dict[str, Callable[..., float | int]] = {
    "abs": abs, "acos": math.acos, "asin": math.asin, "atan": math.atan, "cos": math.cos, "exp": math.exp,
    "float": float, "int": int, "log": math.log, "log10": math.log10, "max": max, "min": min,
    "pow": lambda a, b: power(a, b), "round": round, "sin": math.sin, "sqrt": math.sqrt, "tan": math.tan,
}  # fmt: skip
OPERATORS: dict[type, Callable[..., float | int]] = {
    ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul, ast.Div: operator.truediv,
    ast.FloorDiv: operator.floordiv, ast.Mod: operator.mod, ast.Pow: lambda a, b: power(a, b), ast.USub: operator.neg,
    ast.UAdd: operator.pos,
}  # fmt: skip


def power(base: float, exponent: float) -> float:
    return math.pow(base, exponent) if abs(exponent) < MOST_POWER else math.nan


class Parameters:
    """Values by name; names have no case."""

    def __init__(self) -> None:
        self._values: dict[str, Value] = {}

    def read(self, block: Block) -> None:
        """Lines of the form name = expression, in Python's syntax."""
        for number, words in block.lines:
            place = block.at(number)
            text = ", ".join(words).partition("#")[0].strip()
            name, is_given, expression = (word.strip() for word in text.partition("="))
            if not text:
                continue
            if not is_given or not name.isidentifier():
                raise BadInput(place, f"'{clip(text)}' is no parameter (name = value is expected): correct it")
            self._values[name.upper()] = self._evaluate(expression, place)

    def put_in(self, text: str, place: Place) -> str:
        """A line with the values in place of <names>."""
        return NAME.sub(lambda found: show(self._find(found.group(1), place)), text)

    def _find(self, name: str, place: Place) -> Value:
        if name.upper() not in self._values:
            raise BadInput(place, missing(f"parameter '{clip(name)}'"))
        return self._values[name.upper()]

    def _evaluate(self, text: str, place: Place) -> Value:
        try:
            tree = ast.parse(text[:LONGEST], mode="eval").body
            value = self._reduce(tree, place)
            if not isinstance(value, str) and not math.isfinite(value):
                raise ValueError("it has no bounds")
        except (SyntaxError, ArithmeticError, ValueError, TypeError, RecursionError, MemoryError) as error:
            raise BadInput(place,
                           f"'{clip(text)}' has no value ({clip(str(error), 80)}): correct the expression") from None
        return value

    def _reduce(self, node: ast.AST, place: Place) -> Value:
        if isinstance(node, ast.Constant) and isinstance(node.value, (int, float, str)):
            return node.value if not isinstance(node.value, int) else limit(node.value)
        if isinstance(node, ast.Name):
            return self._find(node.id, place)
        if isinstance(node, ast.UnaryOp) and type(node.op) in OPERATORS:
            return OPERATORS[type(node.op)](self._number(node.operand, place))
        if isinstance(node, ast.BinOp) and type(node.op) in OPERATORS:
            return OPERATORS[type(node.op)](self._number(node.left, place), self._number(node.right, place))
        if (isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id.lower() in FUNCTIONS
                and not node.keywords):
            return FUNCTIONS[node.func.id.lower()](*(self._number(value, place) for value in node.args))
        raise ValueError("only numbers, parameters, + - * / % ** and functions of one name are read")

    def _number(self, node: ast.AST, place: Place) -> float | int:
        value = self._reduce(node, place)
        if isinstance(value, str):
            raise ValueError("a text stands in a formula")
        return limit(value) if isinstance(value, int) else value


def limit(value: int) -> int:
    if abs(value) > 10**18:
        raise ValueError("an integer is too large")
    return value


def show(value: Value) -> str:
    return value if isinstance(value, str) else repr(value)
