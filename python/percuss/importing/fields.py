"""Numbers of fixed and free fields, and rows of named fields that know which of them were read."""

import math
import re
from collections.abc import Callable
from typing import Any, NoReturn

from .ledger import BadInput, Ledger, Place

MOST_ID = 10**15
_REAL = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eEdD][+-]?\d{1,4}|[+-]\d{1,4})?\Z", re.ASCII)
_EXPONENT = re.compile(r"(?<=[\d.])([+-])")


def parse_real(text: str) -> float | None:
    """A number as Fortran writes it: 1.5-10 and 1d3 too. None for anything else, and for what is not finite."""
    if not _REAL.match(text):
        return None
    text = text.replace("d", "e").replace("D", "e")
    if "e" not in text and "E" not in text:
        text = _EXPONENT.sub(r"e\1", text)
    value = float(text)
    return value if math.isfinite(value) else None


def parse_integer(text: str) -> int | None:
    """A whole number, also as '2.' or '2.0'. None for anything else."""
    if len(text) < 20 and (text.isdigit() or (text[:1] in "+-" and text[1:].isdigit())) and text.isascii():
        return int(text)
    value = parse_real(text)
    return int(value) if value is not None and value == int(value) and abs(value) <= MOST_ID else None


# Why a field does not change physics, as `NAME~output` in a layout says. The report shows the text.
REASONS = {
    "": "numerics or output, not physics",
    "output": "what is written, not what is computed",
    "label": "a name or a number that nothing refers to",
    "search": "how contact is searched for: percuss searches in its own way",
    "step": "how the time step is chosen: percuss chooses a stable one",
    "solver": "of another solver than that of structures",
    "implicit": "of implicit analyses",
    "thermal": "of thermal analyses",
    "adaptive": "of adaptive meshes",
    "relaxation": "of dynamic relaxation alone",
    "unused": "not used by LS-DYNA with these options",
    "averaging": "how a rate is averaged over time: percuss takes that of the step",
    "sampling": "how LS-DYNA samples curves again: percuss keeps their rows",
    "damping": "how dynamic relaxation is steered: percuss finds its damping and its end by itself",
    "shells": "numerics of shells: percuss has one shell",
    "solids": "numerics of solids: percuss has its own",
    "joints": "how joints and rigid bodies are solved: joints of percuss are exact",
    "isotropic": "directions, which isotropic materials do not see",
    "fading": "in how many steps a stress falls to zero: percuss takes some 50",
    "absent": "of elements or bodies that percuss does not have",
    "storage": "how data are stored",
    "attribute": "of members of a set, which only cards use that are refused",
    "default": "the defaults of what another card gives",
    "penalty": "of the penalty method, its stiffness and search: percuss corrects velocities, pushes "
               "sheets apart by springs of its own, and holds joints and walls without springs",
}


class Row:
    """Named fields of one line.

    The layout is words: `NAME` (0 or blank by default), `NAME=2` (another default) and `NAME~output` (without physics
    whatever it is, for a reason of REASONS).
    finish() reports each field that has another value than its default and was not asked for.
    """

    change: Any = None  # of the file that holds it: offsets of ids, factors of units
    columns: Callable[[int], str] = staticmethod(lambda index: "")  # what is wrong with the columns of a field

    def __init__(self, card: str, place: Place, layout: str, texts: list[str]):
        self.card, self.place = card, place
        self._texts: dict[str, str] = {}
        self._defaults: dict[str, str] = {}
        self._reasons: dict[str, str] = {}
        self._read: set[str] = set()
        for index, word in enumerate(layout.split()):
            name, _, default = word.partition("=")
            if "~" in name:
                name, _, reason = name.partition("~")
                self._reasons[name] = REASONS[reason]
            self._defaults[name] = default or "0"
            self._texts[name] = texts[index] if index < len(texts) else ""

    def text(self, name: str) -> str:
        self._read.add(name)
        return self._texts[name]

    def knows(self, name: str) -> bool:
        """Whether its layout has the field."""
        return name in self._texts

    def has(self, name: str) -> bool:
        """Whether the field is not blank."""
        return self._texts[name] != ""

    def number(self, name: str) -> float:
        """The field as a number; its default where it is blank."""
        value = self._parse(name, parse_real, "a number")
        return float(value * self.change.factor_of(self.card, name) if self.change else value)

    def integer(self, name: str) -> int:
        """The field as a whole number; its default where it is blank."""
        value = int(self._parse(name, parse_integer, "a whole number"))
        return int(value + self.change.shift_of(self.card, name) if self.change and value > 0 else value)

    def numbers(self, *names: str) -> list[float]:
        return [self.number(name) for name in names]

    def raw(self, name: str) -> float:
        """The number as it is written, in the units of its file."""
        return self._parse(name, parse_real, "a number")

    def positive(self, name: str) -> float:
        """A number that must be above 0."""
        value = self.number(name)
        if value <= 0:
            self.fail(name, "must be positive")
        return value

    def not_negative(self, name: str) -> float:
        """A number that must be 0 or more."""
        value = self.number(name)
        if value < 0:
            self.fail(name, "must not be negative")
        return value

    def or_default(self, name: str, default: float) -> float:
        """The field as a number, where 0 means a default too."""
        return self.number(name) or default

    def fail(self, name: str, text: str) -> NoReturn:
        raise BadInput(self.place,
                       f"{name} of *{self.card} is '{clip(self._texts[name]) or self._defaults[name]}' ({text})")

    def skip(self, *names: str) -> None:
        """Marks fields as read."""
        self._read.update(names)

    def finish(self, ledger: Ledger, instead: str = "its default is used") -> None:
        """Reports what differs from its default and was not asked for."""
        for name, text in self._texts.items():
            if name in self._read or text == "":
                continue
            value, default = parse_real(text), float(self._defaults[name])
            if value in (default, 0.0):
                continue
            shown = f"{name} is {clip(text)}"
            if name in self._reasons:
                ledger.ignored(f"{self.card}.{name}", self.place, self._reasons[name])
            else:
                ledger.refuse(f"{self.card}.{name}", self.place, shown, instead)

    def _parse(self, name: str, parse: Callable[[str], float | None], wanted: str) -> float:
        self._read.add(name)
        text = self._texts[name]
        if text == "":
            return float(self._defaults[name])
        value = parse(text)
        if value is None:
            self.fail(name, f"{wanted} is expected{self.columns(list(self._texts).index(name)) or shift_hint(text)}")
        return value


def shift_hint(text: str) -> str:
    """What to add to a message on a field of fixed width that is blank, or that the end of a column has cut."""
    return "; are the columns of its line shifted?" if not text.strip() or " " in text.strip() else ""


def describe_columns(line: str, first: int, width: int) -> str:
    """What to add to a message on a field of fixed width that has no number:
    which of its columns cut a word, or hold two."""
    last = min(first + width, len(line))
    for border in (first, last):
        if 0 < border < len(line) and not line[border - 1].isspace() and not line[border].isspace():
            start = len(line[:border]) - len(line[:border].split()[-1])
            word = line[start:].split()[0]
            return f"; column {border} ends a field of {width} and cuts '{clip(word)}': shift it"
    if len(line[first:last].split()) > 1:
        return (f"; columns {first + 1} to {first + width} are one field, "
                f"and hold '{clip(line[first:last].strip())}': shift it")
    return ""


def find_cut_number(line: str, border: int, borders: list[int]) -> str:
    """The number that the end of a column cuts: characters on both sides of it that are one number. Whole numbers that
    fill their columns stand side by side, also behind a number that ends its own, and are none.
    Neither are those of a line whose fields all begin with their columns."""
    start = len(line[:border]) - len(line[:border].split()[-1])
    word = line[start:].split()[0]
    if parse_real(word) is None:
        return ""
    first = min(b for b in borders if b > start)  # the end of the column in which it begins
    fills = start + len(word) in borders and line[first : start + len(word)].isdigit()
    begins_all = all(line[a : a + 1] > " " for a, b in zip([0, *borders], borders) if line[a:b].strip())
    is_whole = word.lstrip("+-").isdigit()
    return "" if fills and (is_whole or start not in (0, *borders)) or is_whole and begins_all else word


def clip(text: str, most: int = 40) -> str:
    """A field as messages show it: printable, and not too long."""
    shown = "".join(c if c.isprintable() else "?" for c in text)
    return shown if len(shown) <= most else shown[:most] + "..."
