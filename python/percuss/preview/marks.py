"""What a drawing of a scene before its run shows beside the bodies: velocities, sets, walls, overlaps, gaps."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from percuss.render.skin import exterior_faces
from percuss.results.arrays import Array
from percuss.results.fields import Fields

RED = "#d92d20"
ARROW = "#111827"
WALL = "#98a2b3"
COLORS = {"initial velocity": "#111827", "fixed": "#1f4e9c", "symmetry": "#0e9384", "velocity": "#c2410c",
          "displacement": "#c2410c", "pressure": "#7a3ea8", "load": "#c11574", "added mass": "#7a5c1e",
          "tied": "#3b7c0f", "contact": "#667085"}
ARROW_LENGTH = 0.14   # of the fastest node, as a share of the scene's diagonal
MOST_ARROWS = 24
CELLS_ACROSS = 3      # in which arrows are thinned, across the box of a part
LAYER = 0.01          # within which nodes are equally far behind, as a share of the diagonal
MOST_PAIRS = 4_000_000
MOST_GAPS = 12
MOSTLY = 0.5


@dataclass
class Layer:
    """points [n][3]; segments [m][2][3] with heads if they are arrows; plates [k][4][3]."""
    name: str
    color: str
    kind: str  # points, arrows, lines, plates
    places: Array
    shown: bool = True
    on_top: bool = False
    details: dict[str, Any] = field(default_factory=dict)


def make_layers(scene: dict[str, Any], fields: Fields, plates: Any) -> list[Layer]:
    """All layers of a scene. scene: of `percuss check --json`; fields: its first frame; plates [k][4][3] of walls."""
    places = fields.positions(0)
    layers = []
    if (arrows := find_arrows(fields, places)) is not None:
        layers.append(Layer("initial velocities", ARROW, "arrows", arrows, on_top=True))
    if len(plates):
        layers.append(Layer("rigid walls", WALL, "plates", np.asarray(plates)))
    for selection in scene["selections"]:
        if selection["what"] == "initial velocity":
            continue
        name = f"{selection['key']}: {selection['what']}"
        shown = not selection["what"].startswith("contact") and not _covers_parts(selection, fields)
        layers.append(Layer(name, color_of(selection["what"]), "points", places[selection["nodes"]], shown=shown))
    if scene["overlap"]["nodes"]:
        layers.append(Layer("overlap at the start", RED, "points", places[scene["overlap"]["nodes"]], on_top=True))
    for crossing in scene["overlap"]["crossings"]:
        layers.append(Layer(f"{crossing['part']} crosses {crossing['other']}", RED, "points",
                            np.array(crossing["places"]), on_top=True))
    gaps = find_gap_lines(scene, fields, places)
    if len(gaps):
        layers.append(Layer("smallest gaps", RED, "lines", gaps, on_top=True))
    return layers


def _covers_parts(selection: dict[str, Any], fields: Fields) -> bool:
    """Whether it has most nodes of the parts in which it has any: marks would hide the bodies."""
    chosen = np.zeros(fields.nodes, dtype=bool)
    chosen[selection["nodes"]] = True
    parts = np.unique(fields.part[chosen[fields.hexahedra].any(axis=1)])
    return bool(selection["count"] > MOSTLY * len(np.unique(fields.hexahedra[np.isin(fields.part, parts)])))


def color_of(what: str) -> str:
    return next((color for start, color in COLORS.items() if what.startswith(start)), "#475467")


def find_arrows(fields: Fields, places: Array) -> Array | None:
    """[n][2][3] tails and tips of the velocities at time 0, each as long as its speed; the tip at the node. None: all
    is at rest. Nodes at the rear of what moves are taken, evenly thinned."""
    velocity = fields.data("velocity", 0)
    speed = np.linalg.norm(velocity, axis=1)
    top = float(speed.max(initial=0))
    if not top > 0:
        return None
    diagonal = float(np.linalg.norm(np.ptp(places, axis=0)))
    faces, owners = exterior_faces(fields.hexahedra, np.ones(fields.elements, dtype=bool))
    chosen = []
    moving = [part for part in range(len(fields.part_names))
              if (speed[fields.hexahedra[fields.part == part]] > 1e-3 * top).any()]
    for part in moving:
        nodes = np.unique(np.asarray(faces)[fields.part[owners] == part])
        nodes = nodes[speed[nodes] > 1e-3 * top]
        if len(nodes):
            chosen.append(_thin(places[nodes], velocity[nodes], nodes, max(1, MOST_ARROWS // len(moving)), diagonal))
    if not chosen:
        return None
    nodes = np.concatenate(chosen)
    length = ARROW_LENGTH * diagonal / top
    return np.asarray(np.stack([places[nodes] - length * velocity[nodes], places[nodes]], axis=1))


def _thin(places: Array, velocities: Array, nodes: Array, count: int, diagonal: float) -> Array:
    """About `count` nodes: at the rear of each cell across the mean motion, in its middle;
    of a spin one of each cell of space."""
    mean = velocities.mean(axis=0)
    size = np.linalg.norm(mean)
    spins = size < 0.5 * np.linalg.norm(velocities, axis=1).mean()
    direction = np.zeros(3) if spins else mean / size
    along = places @ direction
    behind = np.floor((along - along.min()) / (LAYER * diagonal))
    across = places - along[:, None] * direction
    across -= across.min(axis=0)
    extent = max(float(across.max()), 1e-300)
    cells = CELLS_ACROSS if extent > ARROW_LENGTH * diagonal else 1  # a thin rod has one arrow
    while True:
        grid = np.floor(across / extent * (cells - 1e-6))
        middle = (grid + 0.5) * extent / cells if cells > 1 else across.max(axis=0) / 2
        from_middle = np.round(np.linalg.norm(across - middle, axis=1) / extent, 6)
        order = np.lexsort((nodes, from_middle, behind, grid[:, 2], grid[:, 1], grid[:, 0]))
        first = np.ones(len(order), dtype=bool)
        first[1:] = (np.diff(grid[order], axis=0) != 0).any(axis=1)
        found = nodes[order[first]]
        if len(found) <= count or cells == 1:
            return np.asarray(found[:count])
        cells -= 1


def find_gap_lines(scene: dict[str, Any], fields: Fields, places: Array) -> Array:
    """[n][2][3]: where two parts are closest, from node to node. Parts that touch, or overlap, have none."""
    lines = []
    gaps = sorted((gap for gap in scene["overlap"]["gaps"] if gap["gap"] > 0 and gap["part"] != gap["other"]),
                  key=lambda gap: float(gap["gap"]))
    numbers = {name: number for number, name in enumerate(fields.part_names)}
    for gap in gaps[:MOST_GAPS]:
        if gap["part"] in numbers and gap["other"] in numbers:
            lines.append(_find_closest(*(places[np.unique(fields.hexahedra[fields.part == numbers[gap[key]]])]
                                         for key in ("part", "other"))))
    return np.array(lines).reshape(-1, 2, 3)


def _find_closest(first: Array, second: Array) -> Array:
    """The closest pair of two sets of points, of those near the other's box."""
    first, second = _near(first, second), _near(second, first)
    step = max(1, len(first) * len(second) // MOST_PAIRS)
    second = second[::step]
    least, best = np.inf, np.empty((0, 3))
    for start in range(0, len(first), 500):
        piece = first[start : start + 500]
        square = ((piece[:, None] - second[None]) ** 2).sum(axis=2)
        at = np.unravel_index(int(np.argmin(square)), square.shape)
        if square[at] < least:
            least, best = square[at], np.stack([piece[at[0]], second[at[1]]])
    return best


def _near(points: Array, others: Array) -> Array:
    """The part of `points` that is closest to the box of the others: at most 2000."""
    outside = np.maximum(np.maximum(others.min(axis=0) - points, points - others.max(axis=0)), 0)
    order = np.argsort((outside**2).sum(axis=1), kind="stable")
    return np.asarray(points[order[:2000]])
