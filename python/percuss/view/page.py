"""The page of percuss view: the surface alone, with all that the viewer can do."""

from percuss.render.colors import CATEGORIES
from percuss.render.mirrors import find_symmetry
from percuss.render.selection import check_field, choose_parts
from percuss.report.markup import escape
from percuss.report.page import wrap_page
from percuss.report.pictures import choose_field
from percuss.results.fields import Fields
from percuss.results.run import Run
from percuss.terminal import print_text

from .embed import MISSING, describe_view, embed_view
from .reduce import pack_view
from .surface import read_library

LARGEST = 40_000_000  # bytes, compressed: 54 MB in the page
MOST_FIELDS = 6


def make_view_page(run: Run, wanted: str | None, parts: list[str] | None) -> tuple[str, list[str]]:
    """(the page, how it is reduced)."""
    if read_library() is None:
        raise ValueError(MISSING)
    fields = run.fields
    names, left = _choose_fields(fields, wanted)
    about, data, reduced_by = pack_view(fields, names, LARGEST, choose_parts(fields, parts))
    about["symmetry"] = find_symmetry(fields, run.deck)
    sentence = describe_view(about, len(fields.times), reduced_by)
    if left:
        reduced_by.append(f"{', '.join(left)} left out ({MOST_FIELDS} fields at most; --field names them)")
        sentence += f" {reduced_by[-1][0].upper()}{reduced_by[-1][1:]}."
    view = embed_view(about, data, sentence, lambda text: print_text(f"view: {text}"))
    return wrap_page(run.title, f"<h1>{escape(run.title)}</h1>{view}", "view"), reduced_by


def _choose_fields(fields: Fields, wanted: str | None) -> tuple[list[str], list[str]]:
    """(names, names that are left out)."""
    known = {name: place for name, place in fields.names().items() if name not in CATEGORIES}
    if wanted:
        names = list(dict.fromkeys(name.strip() for name in wanted.split(",")))
        for name in names:
            check_field(fields, name)
        return names, []
    first = choose_field(fields)
    names = [first, *(name for name in sorted(known) if name not in (first, "alive"))]
    return names[:MOST_FIELDS], names[MOST_FIELDS:]
