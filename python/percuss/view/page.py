"""The page of percuss view: the surface alone, with all that the viewer can do."""

import difflib

import numpy as np

from percuss.render.colors import CATEGORIES
from percuss.render.selection import choose_parts
from percuss.report.markup import escape
from percuss.report.page import embed_view, wrap_page
from percuss.report.pictures import choose_field

from .surface import pack_surface, read_library

LARGEST = 40_000_000  # bytes, compressed: 54 MB in the page
MOST_FIELDS = 6
MOVING = 0.01  # of the size of the scene: parts whose nodes go less far are left out where all does not fit


def make_view_page(run, wanted, parts):
    """(the page, what is told of it)."""
    if read_library() is None:
        raise ValueError("three.js is missing: run scripts/install_dependencies --report (Debian: libjs-three)")
    fields, notes = run.fields, []
    names, left = _choose_fields(fields, wanted)
    if left:
        notes.append(f"{', '.join(left)} left out ({MOST_FIELDS} fields at most; --field names them)")
    kept = choose_parts(fields, parts)
    packed = pack_surface(fields, names[0], None, names[1:], LARGEST, kept)
    if packed is None:
        kept &= _find_moving(fields, kept)
        notes.append("the surface is large: parts that do not move are left out")
        packed = pack_surface(fields, names[0], None, names[1:], LARGEST, kept)
    if packed is None:
        packed = pack_surface(fields, names[0], [len(fields.times) - 1], (), 10 * LARGEST, kept)
        notes.append("the surface is very large: the last frame alone is shown, with one field")
    if packed is None:
        raise ValueError("the surface is too large for a page: choose parts with --part, or open fields.xdmf2 with ParaView")
    about, data = packed
    about["tools"] = True
    if about["frames"] < len(fields.times):
        notes.append(f"{about['frames']} of {len(fields.times)} frames")
    sentence = f"{about['frames']} of {len(fields.times)} frames, {about['faces']:,} faces. " + "; ".join(notes)
    return wrap_page(run.title, f"<h1>{escape(run.title)}</h1>" + embed_view(about, data, sentence), "view"), notes


def _choose_fields(fields, wanted):
    """(names, names that are left out)."""
    known = {name: place for name, place in fields.names().items() if name not in CATEGORIES}
    if wanted:
        names = [name.strip() for name in wanted.split(",")]
        for name in names:
            if name not in fields.names():
                near = difflib.get_close_matches(name, known, 1, 0.5)
                raise ValueError(f"there is no field '{name}' in {fields.path}" + (f"; did you mean {near[0]}?" if near else "")
                                 + f" (it has {', '.join(sorted(fields.names()))})")
        return names, []
    first = choose_field(fields)
    names = [first, *(name for name in sorted(known) if name not in (first, "alive"))]
    return names[:MOST_FIELDS], names[MOST_FIELDS:]


def _find_moving(fields, kept):
    """[elements] of parts of which some node moves."""
    way = np.linalg.norm(fields.positions(-1) - fields.positions(0), axis=1)
    size = np.linalg.norm(np.ptp(fields.positions(0), axis=0))
    moves = (np.nan_to_num(way) > MOVING * size)[fields.hexahedra].any(axis=1)
    moving = np.zeros(fields.elements, dtype=bool)
    for part in np.unique(fields.part[kept]):
        moving[fields.part == part] = moves[fields.part == part].any()
    return moving if moving.any() else np.ones(fields.elements, dtype=bool)
