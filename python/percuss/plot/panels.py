"""What is plotted: panels of columns, by default or by what the user asks for."""

import fnmatch
from collections.abc import Iterable
from dataclasses import dataclass, field

from percuss.nearest import suggest
from percuss.results.expressions import check_syntax
from percuss.results.extremes import find_size
from percuss.results.history import History

ENERGIES = ("kinetic", "internal", "hourglass", "viscous", "folding", "contact", "friction", "damping", "external",
            "contact_stored", "eroded_energy")
FORCES = ("wall_force_x", "wall_force_y", "wall_force_z")
SMALL_FORCE = 0.01  # share of the largest force: smaller columns are left out of the panel of forces
MOST_NAMES = 40  # of columns in a message
MOST_CURVES = 12  # of a panel that was chosen by a pattern or by default


class BadChoice(Exception):
    """There is no such column; str() is a message for the user."""


@dataclass
class Panel:
    name: str
    title: str
    columns: list[str] = field(default_factory=list)
    colored_by_part: bool = False  # a curve of the time step: by the part of the element that controls it


def list_panels(histories: list[History]) -> dict[str, Panel]:
    """Every panel for which some run has columns, by name, in the order in which they are shown."""
    names = list(dict.fromkeys(name for history in histories for name in history.everything))

    def moves(name: str) -> bool:
        return any(name in history and history[name].any() for history in histories)

    def among(wanted: Iterable[str], always: Iterable[str] = ()) -> list[str]:
        return [name for name in wanted if name in names and (name in always or moves(name))]

    forces = (list(FORCES)
              + [n for n in names if n not in FORCES and any(n in h and h.dimension(n) == "force" for h in histories)])
    accelerations = [n for n in names
                     if any(n in h and h.dimension(n) == "acceleration" for h in histories) and moves(n)]
    forces = _leave_out_small(among(forces), histories)
    panels = [
        Panel("energies", "Energies", among(ENERGIES, ("kinetic", "internal"))),
        Panel("energy_error", "Energy error", among(("energy_error",), ("energy_error",))),
        Panel("momentum", "Linear momentum", among([f"momentum_{axis}" for axis in "xyz"], ("momentum_x",))),
        Panel("forces", "Forces" if len(forces) > 1 else "", forces[:MOST_CURVES]),  # a single curve has no legend
        Panel("accelerations", "Accelerations" if len(accelerations) > 1 else "", accelerations[:MOST_CURVES]),
        Panel("step", "Time step", among(("dt",), ("dt",)), colored_by_part=True),
        Panel("contact", "Active contacts", among(("contacts",))),
        Panel("iterations", "Iterations of contact enforcement", among(("iterations",))),
        Panel("penetration", "Penetration that contact leaves, over the edge of a face", among(("residual",))),
        Panel("contact_pairs", "Work of contact by pair",
              [n for n in names if n.startswith(("contact:", "friction:")) and moves(n)][:MOST_CURVES]),
        Panel("kinetic_by_part", "Kinetic energy by part",
              [n for n in names if n.startswith("kinetic:")][:MOST_CURVES]),
        Panel("internal_by_part",
              "Internal energy by part", [n for n in names if n.startswith("internal:")][:MOST_CURVES]),
        Panel("glue", "Energy of glue", among(("glue_work", "glue_dissipated"))),
        Panel("glue_failure", "Failed area of glue", among(("glue_failed",))),
        Panel("erosion", "Eroded elements", among(("eroded_elements",))),
        Panel("angular", "Angular momentum", among([f"angular_{axis}" for axis in "xyz"])),
    ]
    return {panel.name: panel for panel in panels if panel.columns}


def _leave_out_small(names: list[str], histories: list[History]) -> list[str]:
    """Without columns far below the largest: they would be lines at zero."""
    def find_largest(name: str) -> float:
        return max(find_size(h[name]) for h in histories if name in h)

    largest = {name: find_largest(name) for name in names}
    least = SMALL_FORCE * max(largest.values(), default=0)
    return [name for name in names if not largest[name] < least]


DEFAULT = ("energies", "energy_error", "momentum", "forces", "accelerations", "step", "contact", "penetration", "glue",
           "glue_failure", "erosion")


def choose_panels(words: list[str], histories: list[History]) -> list[Panel]:
    """A panel for each word: a name of list_panels, a column, a pattern such as 'kinetic:*', or several of these with
    commas between them, drawn over each other. '=contact' is the column where a panel has its name.
    Without words the default."""
    known = list_panels(histories)
    if not words:
        return [known[name] for name in DEFAULT if name in known]
    names = list(dict.fromkeys(name for history in histories for name in history.everything))
    return [known[word] if word in known else _choose_columns(word.removeprefix("="), names, known) for word in words]


def choose_columns(word: str, histories: list[History]) -> list[str]:
    """The columns of a word; BadChoice where there are none."""
    return _choose_columns(word, list(dict.fromkeys(name for history in histories for name in history.everything)),
                           {}).columns


def _hint(word: str, names: list[str], known: dict[str, Panel]) -> str:
    if hint := suggest(word, [*names, *known]):
        return f"{hint} (percuss plot DIR --list shows all)"
    panels = f"panels: {', '.join(known)}; " if known else ""
    rest = ", ...; percuss plot DIR --list shows all" if len(names) > MOST_NAMES else ""
    return f" and no folder of this name ({panels}columns: {', '.join(names[:MOST_NAMES])}{rest})"


def _choose_columns(word: str, names: list[str], known: dict[str, Panel]) -> Panel:
    columns = []
    for part in [word] if word in names else word.split(","):
        found = ([part] if part in names
                 else fnmatch.filter(names, part) or (known[part].columns if part in known else []))
        if not found:
            check_syntax(word, names)
            raise BadChoice(f"there is no column '{part}'{_hint(part, names, known)}")
        columns += found
    columns = list(dict.fromkeys(columns))
    return Panel(word, columns[0] if len(columns) == 1 else "", columns, columns == ["dt"])
