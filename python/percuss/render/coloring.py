"""What the colours of a picture mean: the field, its range over the frames drawn,
its table and the title of the bar."""

import argparse
from collections.abc import Sequence

import numpy as np

from percuss.results.arrays import Array
from percuss.results.fields import Fields
from percuss.results.units import choose_unit

from . import colors
from .ranges import choose_bar, find_ends, find_typical_ends
from .selection import BadChoice, check_field
from .skin import Skin

LABELS_OF_A_GIVEN_RANGE = 5


class Coloring:
    """Attributes: name, place (node or element), lut, categories (0:
    a colour bar), and of a bar title, labels, note."""

    def __init__(self, fields: Fields, arguments: argparse.Namespace, kept: Array, frames: Sequence[int]) -> None:
        self.fields = fields
        self.kept = kept
        names = fields.names()
        wanted = "part" if arguments.part_colors else arguments.field
        self.name = wanted or next((n for n in ("von_mises", "stress", "velocity") if n in names), "part")
        check_field(fields, self.name)
        self.place = names[self.name]
        self.factor, self.unit = 1.0, ""
        self.title: str | None = None
        self.categories = 0
        if self.name in colors.CATEGORIES:
            self.categories = int(max(fields.values(self.name, frame).max() for frame in range(len(fields.times)))) + 1
            self.lut = colors.make_category_lut(self.categories)
        else:
            self._make_bar(arguments, frames)

    def _drawn_values(self, frame: int) -> Array:
        """The field of the elements that are drawn and alive, or of their nodes."""
        drawn = self.kept & self.fields.alive(frame)
        values = self.fields.values(self.name, frame)
        return np.asarray(values[drawn if self.place == "element" else np.unique(self.fields.hexahedra[drawn])])

    def _make_bar(self, arguments: argparse.Namespace, frames: Sequence[int]) -> None:
        ends = find_ends(self._drawn_values(frame) for frame in frames)
        typical = find_typical_ends((self._drawn_values(frame) for frame in frames),
                                    getattr(arguments, "percentile", None))
        low, high, self.labels = choose_bar(typical)
        if arguments.range:
            (low, high), self.labels = arguments.range, LABELS_OF_A_GIVEN_RANGE
        if not high > low:
            raise BadChoice(f"the range {low:g}:{high:g} is empty")
        unit, self.factor = choose_unit(self.fields.unit_of(self.name), max(abs(low), abs(high)))
        self.unit, self.ends = unit, (low, high)
        name = arguments.map.removesuffix("-r")
        if name not in colors.MAPS:
            raise BadChoice(f"there is no colour map '{arguments.map}' (there are {', '.join(colors.MAPS)})")
        self.lut = colors.make_lut(name, low * self.factor, high * self.factor, arguments.map.endswith("-r"))
        self.title = colors.label_of(self.name) + (f"\n[{unit}]" if unit else "")
        self.note = ""
        if ends and (ends[0] < low or ends[1] > high):
            self.note = f"data: {ends[0] * self.factor:.3g} to {ends[1] * self.factor:.3g}"

    def choose_values(self, frame: int, skin: Skin) -> tuple[str, Array]:
        """'node' with a number for each point of the skin, or 'element' with one for each polygon: its element's, or,
        of a category of nodes, the highest of its corners'."""
        values = self.fields.values(self.name, frame) * self.factor
        if self.place == "element":
            return "element", values[skin.owners]
        if self.categories:
            return "element", skin.highest_of_corners(values)
        return "node", skin.at_points(values)

    def legend(self) -> list[tuple[int, str]]:
        """[(number of the colour, name)] of what is drawn; of bodies and chunks there are too many to name."""
        if self.name == "part":
            return [(p, self.fields.part_names[p]) for p in np.unique(self.fields.part[self.kept])]
        if self.name.endswith("_rank"):
            return [(rank, f"rank {rank}") for rank in range(self.categories)]
        return []
