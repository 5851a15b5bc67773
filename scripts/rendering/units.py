"""Units: what stands behind a number on a picture. percuss writes the units of fields and times into the file."""

import math

PREFIXES = [(1e9, "G"), (1e6, "M"), (1e3, "k"), (1, ""), (1e-3, "m"), (1e-6, "\u00b5"), (1e-9, "n")]
PREFIXED = ("Pa", "N")  # units that take a prefix to suit the numbers; others stay as the deck has them


def choose_unit(unit, largest):
    """The unit to show and the factor that turns the file's numbers into it: ('MPa', 1e-6) of 'Pa' and 3e8."""
    if unit not in PREFIXED or not largest > 0:
        return unit, 1.0
    size, prefix = _choose_prefix(largest)
    return prefix + unit, 1.0 / size


def format_time(time, end, unit):
    """The time of a frame, in a unit that suits the whole run when that of the file is seconds."""
    if unit != "s":
        return f"t = {time:.4g} {unit}".rstrip()
    size, prefix = _choose_prefix(end)
    digits = max(0, 2 - math.floor(math.log10(end / size))) if end > 0 else 2
    return f"t = {time / size:.{digits}f} {prefix}s"


def _choose_prefix(largest):
    return next((p for p in PREFIXES if largest >= 0.999 * p[0]), (1, ""))
