"""Colour maps, ranges and units: from a field's numbers to what the colour bar says."""

import math
import re

import numpy as np

# Colours at equal distances, light to dark or along the map; interpolated in Lab. viridis and inferno: of matplotlib (CC0).
MAPS = {
    "heat": ["#e9e6df", "#f6dfa4", "#f9b95c", "#ef7f3c", "#cf4631", "#93203d", "#4d1240"],
    "viridis": ["#440154", "#443983", "#31688e", "#21918c", "#35b779", "#90d743", "#fde725"],
    "inferno": ["#000004", "#320a5e", "#781c6d", "#bc3754", "#ed6925", "#fbb61a", "#fcffa4"],
    "cool-warm": ["#3b4cc0", "#7b9ff9", "#c0d4f5", "#dddcdc", "#f6bfa6", "#e7745b", "#b40426"],
    "grey": ["#f0f0f0", "#303030"],
}

CATEGORIES = {"part", "body", "chunk", "fe_rank", "contact_rank"}  # numbers that only tell things apart

# Colours of parts: distinct, none of them shouting.
PART_COLORS = ["#6f8fb0", "#c98a6b", "#8aa879", "#b3a06a", "#9b85ad", "#7fa9a6", "#c0788a", "#8d8d8d"]

# Powers of length, mass and time in the fields that percuss writes.
DIMENSIONS = {
    "displacement": (1, 0, 0),
    "velocity": (1, 0, -1),
    "mass": (0, 1, 0),
    "contact_force": (1, 1, -2),
    "stress": (-1, 1, -2),
    "von_mises": (-1, 1, -2),
    "pressure": (-1, 1, -2),
}
LABELS = {"stress": "von Mises stress", "von_mises": "von Mises stress", "velocity": "speed"}
SI_NAMES = {(-1, 1, -2): "Pa", (1, 1, -2): "N"}
PREFIXES = [(1e9, "G"), (1e6, "M"), (1e3, "k"), (1, ""), (1e-3, "m"), (1e-6, "\u00b5"), (1e-9, "n")]
SUPERSCRIPTS = str.maketrans("-0123456789", "\u207b\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079")


def rgb(color):
    """'#rrggbb' as three numbers of 0 to 1."""
    return tuple(int(color[i : i + 2], 16) / 255 for i in (1, 3, 5))


def make_lut(name, low, high, reverse=False):
    """A lookup table over [low, high]; numbers that are not finite are magenta, so that they cannot be missed."""
    from vtkmodules.vtkCommonCore import vtkLookupTable
    from vtkmodules.vtkRenderingCore import vtkColorTransferFunction

    colors = MAPS[name][::-1] if reverse else MAPS[name]
    curve = vtkColorTransferFunction()
    curve.SetColorSpaceToLab()
    for place, color in zip(np.linspace(0, 1, len(colors)), colors):
        curve.AddRGBPoint(place, *rgb(color))
    lut = vtkLookupTable()
    lut.SetNumberOfTableValues(256)
    for i in range(256):
        lut.SetTableValue(i, *curve.GetColor(i / 255), 1)
    lut.SetNanColor(1, 0, 1, 1)
    lut.SetRange(low, high)
    return lut


def part_color(number):
    return rgb(PART_COLORS[number % len(PART_COLORS)])


def make_category_lut(count):
    """One colour for each of 0, 1, ..., count - 1; grey for what belongs to none (-1)."""
    from vtkmodules.vtkCommonCore import vtkLookupTable

    lut = vtkLookupTable()
    lut.SetNumberOfTableValues(count)
    for number in range(count):
        lut.SetTableValue(number, *part_color(number), 1)
    lut.SetBelowRangeColor(*rgb("#d9d9d9"), 1)
    lut.UseBelowRangeColorOn()
    lut.SetRange(0, max(1, count - 1))
    return lut


def robust_range(samples):
    """From the numbers of all frames the range to show: zero if that is near, and without the most extreme 0.5 % at each end."""
    finite = np.concatenate([s[np.isfinite(s)] for s in samples]) if samples else np.empty(0)
    if not finite.size:
        return 0.0, 1.0
    low, high = np.quantile(finite, [0.005, 0.995])
    if low >= 0 and low < 0.3 * high:
        low = 0.0
    elif low < 0 < high and min(-low, high) > 0.2 * max(-low, high):
        high = max(-low, high)
        low = -high
    if high <= low:
        high = low + (abs(low) or 1.0)
    return _round_outward(low, high)


def _round_outward(low, high):
    """The nearest round numbers outside, so that the ends of the colour bar can be read."""
    step = 10 ** math.floor(math.log10(high - low)) / 2
    return math.floor(low / step + 1e-9) * step, math.ceil(high / step - 1e-9) * step


TIMES = ("s", "ms", "us", "\u00b5s", "ns", "min")


def parse_units(text):
    """'m, kg, s' as [length, mass, time], also where time stands elsewhere; None if the deck's words are others."""
    words = re.split(r"[,\s]+", text.strip()) if text else []
    if len(words) == 3 and sum(word in TIMES for word in words) == 1:
        time = next(word for word in words if word in TIMES)
        return [word for word in words if word != time] + [time]
    return words if len(words) == 3 else None


def choose_unit(field, units, largest):
    """The unit of a field and the factor that turns the file's numbers into it: ('MPa', 1e-6)."""
    powers, base = DIMENSIONS.get(field), parse_units(units)
    if powers is None or base is None:
        return "", 1.0
    if base == ["m", "kg", "s"] and powers in SI_NAMES:
        size, prefix = next((p for p in PREFIXES if largest >= 0.999 * p[0]), (1, ""))
        return prefix + SI_NAMES[powers], 1.0 / size
    if [w.lower() for w in base] in (["mm", "t", "s"], ["mm", "tonne", "s"], ["mm", "g", "ms"]) and powers == (-1, 1, -2):
        return "MPa", 1.0
    over = [_power(u, p) for u, p in zip(base, powers) if p > 0]
    under = [_power(u, -p) for u, p in zip(base, powers) if p < 0]
    if not under:
        return "\u00b7".join(over), 1.0
    below = "\u00b7".join(under)
    return f"{chr(0xb7).join(over) or '1'}/{f'({below})' if len(under) > 1 else below}", 1.0


def _power(unit, power):
    return unit if power == 1 else unit + str(power).translate(SUPERSCRIPTS)


def format_time(time, end, units):
    """The time of a frame, in a unit that suits the whole run when the deck's is seconds."""
    base = parse_units(units)
    if base is None or base[2] != "s":
        return f"t = {time:.4g}" + (f" {base[2]}" if base else "")
    size, prefix = next((p for p in PREFIXES if end >= 0.999 * p[0]), (1, ""))
    digits = max(0, 3 - math.floor(math.log10(max(end / size, 1e-30))) - 1)
    return f"t = {time / size:.{digits}f} {prefix}s"


def label_of(field):
    return LABELS.get(field, field.replace("_", " "))
