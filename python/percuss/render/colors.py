"""Colour maps, colours of parts, and what a field is called on the bar."""

from typing import Any

import numpy as np

# Colours at equal distances, light to dark or along the map; interpolated in Lab.
# viridis and inferno: of matplotlib (CC0).
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

LABELS = {"stress": "von Mises stress", "von_mises": "von Mises stress", "velocity": "speed"}


def rgb(color: str) -> tuple[float, float, float]:
    """'#rrggbb' as three numbers of 0 to 1."""
    red, green, blue = (int(color[i : i + 2], 16) / 255 for i in (1, 3, 5))
    return red, green, blue


def make_lut(name: str, low: float, high: float, reverse: bool = False) -> Any:
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


def part_color(number: int) -> tuple[float, float, float]:
    return rgb(PART_COLORS[number % len(PART_COLORS)])


def make_category_lut(count: int) -> Any:
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


def label_of(field: str) -> str:
    return LABELS.get(field, field.replace("_", " "))
