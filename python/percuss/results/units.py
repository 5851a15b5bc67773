"""Units: the systems that a deck can name, and the unit of each quantity in them.
The table is that of src/deck/units.cpp."""

import math
import re

Powers = tuple[float, ...]  # of length, mass and time

INCH, FOOT, POUND, POUND_FORCE = 0.0254, 0.3048, 0.45359237, 4.4482216152605  # NIST Special Publication 811, appendix B

LENGTHS: dict[str, float] = {"m": 1, "mm": 1e-3, "cm": 1e-2, "um": 1e-6, "\u00b5m": 1e-6, "km": 1e3, "in": INCH,
                             "ft": FOOT}
MASSES: dict[str, float] = {"kg": 1, "t": 1e3, "g": 1e-3, "mg": 1e-6, "lb": POUND, "lbf s2/in": POUND_FORCE / INCH,
          "lbf s2/ft": POUND_FORCE / FOOT, "slug": POUND_FORCE / FOOT}
TIMES: dict[str, float] = {"s": 1, "ms": 1e-3, "us": 1e-6, "\u00b5s": 1e-6, "ns": 1e-9}
SHOWN = {"um": "\u00b5m", "us": "\u00b5s", "lbf s2/in": "lbf\u00b7s\u00b2/in", "lbf s2/ft": "lbf\u00b7s\u00b2/ft"}

# Powers of length, mass and time in each quantity that docs/output.md names.
DIMENSIONS: dict[str, Powers] = {
    "-": (0, 0, 0), "length": (1, 0, 0), "mass": (0, 1, 0), "time": (0, 0, 1), "velocity": (1, 0, -1),
    "acceleration": (1, 0, -2), "frequency": (0, 0, -1), "force": (1, 1, -2), "pressure": (-1, 1, -2),
    "energy": (2, 1, -2), "momentum": (1, 1, -1), "angular momentum": (2, 1, -1), "moment": (2, 1, -2),
    "area": (2, 0, 0), "density": (-3, 1, 0), "temperature": (0, 0, 0),
}
NAMED: list[tuple[str, str, float, bool]] = [
    ("force", "N", 1, True), ("force", "lbf", POUND_FORCE, False), ("force", "dyn", 1e-5, False),
    ("pressure", "Pa", 1, True), ("pressure", "Mbar", 1e11, False), ("pressure", "psi", POUND_FORCE / INCH**2, False),
    ("pressure", "psf", POUND_FORCE / FOOT**2, False), ("energy", "J", 1, True), ("energy", "erg", 1e-7, False),
    ("energy", "in\u00b7lbf", POUND_FORCE * INCH, False), ("energy", "ft\u00b7lbf", POUND_FORCE * FOOT, False),
]
OWN_PREFIXES: list[tuple[str, float]] = [("", 1), ("k", 1e3), ("M", 1e6), ("G", 1e9), ("T", 1e12), ("m", 1e-3),
                                         ("\u00b5", 1e-6), ("n", 1e-9)]

# What labels may name besides.
MORE_UNITS: dict[str, tuple[float, str]] = {"Hz": (1, "frequency"), "bar": (1e5, "pressure"), "min": (60, "time"),
                                            "h": (3600, "time")}
GRAVITY = 9.80665  # [m/s2] what g is of an acceleration

PREFIXES: list[tuple[float, str]] = [(1e9, "G"), (1e6, "M"), (1e3, "k"), (1, ""), (1e-3, "m"), (1e-6, "\u00b5"),
                                     (1e-9, "n")]
# Units whose prefix suits the numbers, and what they are without one; others stay as the deck has them.
PREFIXED = {"Pa": ("Pa", 1.0), "N": ("N", 1.0), "J": ("J", 1.0), "mJ": ("J", 1e-3), "kJ": ("J", 1e3)}


def find_powers(quantity: str | None) -> Powers | None:
    """Powers of length, mass and time in a quantity, by its name or as a product: 'energy', 'mass length^2 / time^2',
    'mass length^2 time^-2', '1'. None if it is not known."""
    if not quantity or quantity in DIMENSIONS:
        return DIMENSIONS[quantity] if quantity else None
    if quantity == "1":
        return DIMENSIONS["-"]
    total: list[float] = [0, 0, 0]
    for sign, side in zip((1, -1), quantity.replace("(", " ").replace(")", " ").split("/", 1)):
        for word in side.split():
            name, _, power = word.partition("^")
            if name not in DIMENSIONS or not (power or "1").removeprefix("-").isdigit():
                return None
            total = [t + sign * int(power or 1) * p for t, p in zip(total, DIMENSIONS[name])]
    return tuple(total)


def _expect_powers(quantity: str) -> Powers:
    powers = find_powers(quantity)
    if powers is None:
        raise ValueError(f"the dimension of '{quantity}' is not known")
    return powers


def name_quantity(quantity: str) -> str:
    """'energy' of 'mass length^2 time^-2', '-' of '1'; the text itself where no name is usual."""
    powers = find_powers(quantity)
    if quantity in DIMENSIONS or powers is None:
        return quantity
    return next((name for name, known in DIMENSIONS.items() if known == powers), quantity)


class BadUnits(ValueError):
    """A system of units that is not known, or no units to convert from."""


class Units:
    """A system of units: that of 'mm, kg, ms'.
    Attributes: text, and length, mass and time, each a name and its size in SI."""

    def __init__(self, text: str) -> None:
        """BadUnits if the text names no length, mass and time that are known."""
        words = [_make_plain(word) for word in ("m, kg, s" if text == "SI" else text).split(",")]
        tables = (LENGTHS, MASSES, TIMES)
        if len(words) not in (3, 4) or any(word not in table for word, table in zip(words, tables)):
            raise BadUnits(f"'{text}' is no system of units (a length, a mass and a time, such as 'mm, kg, ms')")
        self.text = ", ".join(words)
        self.length, self.mass, self.time = ((SHOWN.get(word, word), table[word]) for word, table in zip(words, tables))
        self.temperature = words[3] if len(words) == 4 else ""

    def in_si(self, quantity: str) -> float:
        """What one of a quantity is in SI: 1e9 of 'pressure' in mm, kg, ms. 1 of a temperature."""
        return self.size_of(_expect_powers(quantity))

    def size_of(self, powers: Powers) -> float:
        """What one of a quantity with these powers of length, mass and time is in SI."""
        return float(math.prod(unit[1] ** power for unit, power in zip((self.length, self.mass, self.time), powers)))

    def name_of(self, quantity: str) -> str:
        """The unit of a quantity: 'GPa' of 'pressure' in mm, kg, ms; empty of a number without a dimension."""
        if quantity == "temperature":
            return self.temperature
        if quantity == "moment":  # as a force at an arm, not as the energy of the same dimension
            return f"{self.name_of('force')}\u00b7{self.length[0]}"
        size, powers = self.in_si(quantity), _expect_powers(quantity)
        for named, name, in_si, takes_prefixes in NAMED:
            for prefix, factor in OWN_PREFIXES if takes_prefixes else OWN_PREFIXES[:1]:
                if DIMENSIONS[named] == powers and math.isclose(size, in_si * factor, rel_tol=1e-9):
                    return prefix + name
        return self._write_product(powers)

    def name_of_powers(self, powers: Powers) -> str:
        """The unit of a product of powers of length, mass and time."""
        named = next((name for name, known in DIMENSIONS.items()
                      if known == tuple(powers) and name not in ("temperature", "-")), None)
        return self.name_of(named) if named else self._write_product(powers)

    def _write_product(self, powers: Powers) -> str:
        above: list[str] = []
        below: list[str] = []
        for (name, _), power in zip((self.mass, self.length, self.time), (powers[1], powers[0], powers[2])):
            if power:
                base = f"({name})" if "/" in name and abs(power) > 1 else name
                whole = int(abs(power)) if float(power).is_integer() else 0
                raised = base + {1: "", 2: "\u00b2", 3: "\u00b3"}.get(whole, f"^{abs(power)}")
                (above if power > 0 else below).append(raised)
        if not below:
            return "\u00b7".join(above)
        under = "\u00b7".join(below)
        return ("\u00b7".join(above) or "1") + "/" + (f"({under})" if len(below) > 1 else under)


def measure_unit(text: str, powers: Powers | None) -> float | None:
    """The size in SI of a unit such as 'kN', 'km/h', 'mm/s^2', or 'g' of an acceleration; None where it is not known,
    or has other powers of length, mass and time."""
    if powers == DIMENSIONS["acceleration"] and text in ("g", "G"):
        return GRAVITY
    known = _read_product(text)
    return known[0] if known and powers is not None and known[1] == tuple(powers) else None


def is_unit(text: str) -> bool:
    """Whether it is such a unit, of whatever dimension."""
    return _read_product(text) is not None


def _read_product(text: str) -> tuple[float, Powers] | None:
    size, found = 1.0, [0.0, 0.0, 0.0]
    above, *below = text.replace("\u00b2", "2").replace("\u00b3", "3").split("/")
    for sign, side in ((1, above), *((-1, side) for side in below)):
        for word in re.split(r"[\s*()\u00b7]+", side.strip(" ()")):
            match = re.fullmatch(r"([A-Za-z\u00b5]+)\^?(-?\d)?", word)
            known = _find_base(match[1]) if match else (1.0, DIMENSIONS["-"]) if word == "1" else None
            if known is None:
                return None
            power = sign * int(match[2] or 1 if match else 1)
            size *= known[0] ** power
            found = [total + power * own for total, own in zip(found, known[1])]
    return size, tuple(found)


def _find_base(word: str) -> tuple[float, Powers] | None:
    for quantity, table in (("length", LENGTHS), ("mass", MASSES), ("time", TIMES)):
        if word in table:
            return table[word], DIMENSIONS[quantity]
    units = [*NAMED, *((quantity, name, size, name == "Hz") for name, (size, quantity) in MORE_UNITS.items())]
    for quantity, name, size, takes_prefixes in units:
        for prefix, factor in OWN_PREFIXES if takes_prefixes else OWN_PREFIXES[:1]:
            if word == prefix + name:
                return size * factor, DIMENSIONS[quantity]
    return None


def find_units(text: str | None) -> Units | None:
    """The system that a text names, or None."""
    try:
        return Units(text) if text else None
    except ValueError:
        return None


def _make_plain(text: str) -> str:
    """'lbf s2/in' of 'lbf s^2/in', 'lbf*s\u00b2/in' and 'lbf-s2/in'."""
    text = text.replace("\u00b2", "2").replace("\u00b7", " ").replace("^", "")
    return re.sub(r"[*\- \t]+", " ", text).strip()


def choose_unit(unit: str, largest: float) -> tuple[str, float]:
    """The unit to show and the factor that turns the file's numbers into it: ('MPa', 1e-6) of 'Pa' and 3e8."""
    if unit not in PREFIXED or not largest > 0:
        return unit, 1.0
    plain, factor = PREFIXED[unit]
    size, prefix = _choose_prefix(largest * factor)
    return prefix + plain, factor / size


def choose_time_unit(unit: str, end: float) -> tuple[str, float]:
    """Unit of times that go up to `end`: ('ms', 1e3) of 's' and 0.005."""
    if unit != "s" or not end > 0:
        return unit, 1.0
    size, prefix = _choose_prefix(min(end, 1))  # no kiloseconds
    return prefix + unit, 1.0 / size


def format_time(time: float, end: float, unit: str) -> str:
    """The time of a frame, in a unit that suits the whole run when that of the file is seconds."""
    if unit != "s":
        return f"t = {time:.4g} {unit}".rstrip()
    size, prefix = _choose_prefix(end)
    digits = max(0, 2 - math.floor(math.log10(end / size))) if end > 0 else 2
    return f"t = {time / size:.{digits}f} {prefix}s"


def _choose_prefix(largest: float) -> tuple[float, str]:
    return next((p for p in PREFIXES if largest >= 0.999 * p[0]), (1, ""))
