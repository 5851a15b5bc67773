"""Designs: which values the keys of a deck have in each run."""

import csv
import itertools
import math
import re
from collections.abc import Iterable, Mapping, Sequence

from ..errors import NotResults
from ..files import read_text

MOST_DESIGNS = 10000
SAMPLES = ("lhs", "sobol")
_RANGE = re.compile(r"([^:\s]+?)\.\.([^:\s]+)((?::[a-z0-9]+)*)")


class BadDesign(ValueError):
    """A design cannot be made; str() is a message for the user."""


class Factor:
    """Keys of the deck that have one value together. values: texts; empty of a range, which a sample fills. low, high:
    of a range; is_log: its logarithm is evenly spread; is_whole: it has whole numbers alone."""

    def __init__(self, name: str, values: Iterable[str] = (), low: float = 0.0, high: float = 0.0, is_log: bool = False,
                 is_whole: bool = False) -> None:
        self.name, self.values = name, list(values)
        self.low, self.high, self.is_log, self.is_whole = low, high, is_log, is_whole

    def place(self, share: float) -> str:
        """The value at a share, from 0 up to 1, of the way through the factor."""
        if self.values:
            return self.values[min(int(share * len(self.values)), len(self.values) - 1)]
        if self.is_whole:  # each number has the same width
            return str(min(int(self.low + share * (self.high - self.low + 1)), int(self.high)))
        value = self.low * (self.high / self.low) ** share if self.is_log else self.low + share * (self.high - self.low)
        return f"{value:.10g}"


class Design:
    """number: from 1. inputs: {factor: text of its value}."""

    def __init__(self, number: int, inputs: dict[str, str]) -> None:
        self.number, self.inputs = number, inputs

    @property
    def settings(self) -> list[str]:
        """What --set takes."""
        return [f"{key}={value}" for name, value in self.inputs.items() for key in split_outside(name)]

    def __str__(self) -> str:
        return ", ".join(f"{name}={value}" for name, value in self.inputs.items())


def split_outside(text: str, separator: str = ",") -> list[str]:
    """Pieces between separators that stand in no bracket and in no quotes: ['[8, 8]', '3'] of '[8, 8],3'."""
    pieces, depth, quote, start = [], 0, "", 0
    for place, c in enumerate(text):
        if quote:
            quote = "" if c == quote else quote
        elif c in "'\"":
            quote = c
        elif c in "[{(":
            depth += 1
        elif c in "]})":
            depth -= 1
        elif c == separator and depth == 0:
            pieces.append(text[start:place])
            start = place + 1
    return [piece.strip() for piece in [*pieces, text[start:]]]


def parse_factor(text: str) -> Factor:
    """'a.b=1,2,3', 'a.b=5..9:5' (evenly spaced), 'a.b=1e3..1e6:4:log', 'a.b=5..9' (a range, for samples),
    'a.b,c.d=1,2' (together)."""
    name, equals, words = text.partition("=")
    keys = [key.strip() for key in name.split(",")]
    if not equals or not words.strip() or not all(re.fullmatch(r"[\w.-]+", key) for key in keys):
        raise BadDesign(f"--vary '{text}' is no key with values: write key=1,2,3 or key=LOW..HIGH:COUNT")
    name = ",".join(keys)
    if match := _RANGE.fullmatch(words.strip()):
        return _parse_range(name, text, match)
    values = split_outside(words)
    if not all(values):
        raise BadDesign(f"--vary '{text}' has an empty value")
    if len(set(values)) < len(values):
        raise BadDesign(f"--vary '{text}' has a value twice")
    return Factor(name, values)


def _parse_range(name: str, text: str, match: re.Match[str]) -> Factor:
    try:
        low, high = float(match[1]), float(match[2])
    except ValueError:
        raise BadDesign(f"--vary '{text}' is no range of numbers: write key=LOW..HIGH:COUNT") from None
    words = match[3].split(":")[1:]
    is_log, is_whole = "log" in words, "int" in words
    counts = [word for word in words if word not in ("log", "int")]
    if (not (math.isfinite(low) and math.isfinite(high) and low < high) or len(counts) > 1
            or any(not count.isdigit() for count in counts)):
        raise BadDesign(f"--vary '{text}' is no range (LOW below HIGH, then :COUNT, :log or :int)")
    if is_log and low <= 0:
        raise BadDesign(f"--vary '{text}': a logarithmic range must be above zero")
    if is_whole and not (low.is_integer() and high.is_integer()):
        raise BadDesign(f"--vary '{text}': the ends of a range of whole numbers must be whole")
    factor = Factor(name, (), low, high, is_log, is_whole)
    if counts:
        count = int(counts[0])
        if not 2 <= count <= MOST_DESIGNS:
            raise BadDesign(f"--vary '{text}': the count must be 2 to {MOST_DESIGNS}")
        factor.values = [_round(factor, place / (count - 1)) for place in range(count)]
        if len(set(factor.values)) < count:
            raise BadDesign(f"--vary '{text}' has fewer values than its count")
    return factor


def _round(factor: Factor, share: float) -> str:
    if factor.is_whole:
        return str(round(factor.low + share * (factor.high - factor.low)))
    if factor.is_log:
        return f"{factor.low * (factor.high / factor.low) ** share:.10g}"
    return f"{factor.low + share * (factor.high - factor.low):.10g}"


def check_names(names: Iterable[str]) -> None:
    keys = [key for name in names for key in name.split(",")]
    if twice := next((key for key in keys if keys.count(key) > 1), None):
        raise BadDesign(f"'{twice}' varies twice")


def cross(factors: Sequence[Factor]) -> list[Design]:
    """Every combination of the values; the last factor varies fastest."""
    check_names([factor.name for factor in factors])
    if no_values := next((factor for factor in factors if not factor.values), None):
        raise BadDesign(f"'{no_values.name}' has a range without a count: add :COUNT, or --sample lhs:N")
    if math.prod(len(factor.values) for factor in factors) > MOST_DESIGNS:
        raise BadDesign(f"these are more than {MOST_DESIGNS} designs: use --sample lhs:N")
    names = [factor.name for factor in factors]
    return [Design(number, dict(zip(names, values)))
            for number, values in enumerate(itertools.product(*(factor.values for factor in factors)), 1)]


def parse_sample(text: str) -> tuple[str, int]:
    """'lhs:20' or 'sobol:16'."""
    kind, _, count = text.partition(":")
    if kind not in SAMPLES or not count.isdigit() or not 1 <= int(count) <= MOST_DESIGNS:
        raise BadDesign(f"--sample '{text}' is neither lhs:N nor sobol:N (1 to {MOST_DESIGNS})")
    return kind, int(count)


def sample(factors: Sequence[Factor], text: str, seed: int = 0) -> list[Design]:
    """A Latin hypercube, or Sobol's sequence (scrambled; it fills best with a power of two of designs). Of a list of
    values each has the same share."""
    from scipy.stats import qmc

    check_names([factor.name for factor in factors])
    kind, count = parse_sample(text)
    if kind == "lhs":
        shares = qmc.LatinHypercube(len(factors), seed=seed).random(count)
    else:
        shares = qmc.Sobol(len(factors), scramble=True, seed=seed).random_base2(max(0, count - 1).bit_length())[:count]
    return [Design(number, {factor.name: factor.place(float(share)) for factor, share in zip(factors, row)})
            for number, row in enumerate(shares, 1)]


def read_designs(path: str) -> list[Design]:
    """The designs of a CSV file: keys in the heading, a design in each line. Lines that begin with # are left out."""
    lines = [line for line in read_text(path).splitlines() if line.strip() and not line.lstrip().startswith("#")]
    try:
        rows = [[cell.strip() for cell in row] for row in csv.reader(lines, skipinitialspace=True)]
    except csv.Error as error:
        raise NotResults(f"{path}: this is no table ({error})") from error
    if len(rows) < 2:
        raise NotResults(f"{path}: there is no design in it "
                         "(a heading with keys of the deck and a line for each design are needed)")
    names = rows[0]
    if wrong := next((name for name in names if not re.fullmatch(r"[\w.-]+(,[\w.-]+)*", name)), None):
        raise NotResults(f"{path}: '{wrong}' in its heading is no key of a deck")
    check_names(names)
    if len(rows) - 1 > MOST_DESIGNS:
        raise NotResults(f"{path}: these are more than {MOST_DESIGNS} designs")
    for number, row in enumerate(rows[1:], 1):
        if len(row) != len(names) or not all(row):
            raise NotResults(f"{path}: design {number} does not have {len(names)} values")
    return [Design(number, dict(zip(names, row))) for number, row in enumerate(rows[1:], 1)]


def make_designs(values: Mapping[str, Iterable[object]]) -> list[Design]:
    """Every combination of {key: list of values}, for use from Python."""
    return cross([Factor(name, [str(value) for value in choices]) for name, choices in values.items()])
