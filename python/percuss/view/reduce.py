"""How a surface comes to fit into a page: what is left out, in which order, and what is said of it."""

from collections.abc import Callable, Iterable, Sequence
from typing import Any

import numpy as np

from percuss.render.skin import are_lines
from percuss.results.arrays import Array
from percuss.results.fields import Fields

from .arrows import list_vectors
from .shape import FEWER_ARROWS, Content
from .surface import MOST_VOLUMES, Packed, encode, pack

MOST_FRAMES = 60
FEWEST_FRAMES = 24  # before anything else is left out
LARGEST_PACK = 1_900_000  # bytes, compressed, in a report
MOVING = 0.01  # share of the size of the scene: parts whose nodes go less far are left out where all does not fit
COARSEST = 15  # sides of a cube of the grid along the diagonal of the scene


def pack_view(fields: Fields, names: Iterable[str], largest: int = LARGEST_PACK, kept: Array | None = None,
              frames: Sequence[int] | None = None) -> tuple[dict[str, Any], str, list[str]]:
    """(description, text of base 64, sentences of what has been reduced), as much as fits: first arrows are left out,
    then sections of solids, then frames, then parts that do not move, then nodes are merged,
    then more frames. frames: these alone."""
    kept = np.ones(fields.elements, dtype=bool) if kept is None else kept
    chosen = _spread(fields, MOST_FRAMES) if frames is None else np.asarray(frames)
    solids = int((kept & ~are_lines(fields.hexahedra) & (fields.hexahedra[:, 0] != fields.hexahedra[:, 4])).sum())
    content = Content(list(names), chosen, kept, tuple(list_vectors(fields)), 0 < solids <= MOST_VOLUMES)
    packed = pack(fields, content)
    steps: list[Callable[[Fields, Content, Packed, int], tuple[Content, Packed]]] = [
        _with_fewer_arrows, _without_volumes, _with_fewer_frames, _with_what_moves, _merged, _with_two_frames]
    for step in steps:
        if len(packed[1]) <= largest:
            break
        content, packed = step(fields, content, packed, largest)
    about, text = encode(packed)
    about["open"] = bool(solids and not content.volumes)
    return about, text, _tell(fields, content, about, solids, kept, frames is not None)


def _with_fewer_arrows(fields: Fields, content: Content, packed: Packed, largest: int) -> tuple[Content, Packed]:
    content = content.but(arrows=FEWER_ARROWS)
    return content, pack(fields, content)


def _without_volumes(fields: Fields, content: Content, packed: Packed, largest: int) -> tuple[Content, Packed]:
    if not content.volumes:
        return content, packed
    content = content.but(volumes=False)
    return content, pack(fields, content)


def _with_fewer_frames(fields: Fields, content: Content, packed: Packed, largest: int,
                       fewest: int = FEWEST_FRAMES) -> tuple[Content, Packed]:
    wanted = len(content.frames)
    while wanted > fewest and len(packed[1]) > largest:
        wanted = max(fewest, min(wanted - 1, int(wanted * 0.9 * largest / len(packed[1]))))
        chosen = np.unique(np.round(np.linspace(0, len(content.frames) - 1, wanted)).astype(int))
        content = content.but(frames=content.frames[chosen])
        packed = pack(fields, content)
    return content, packed


def _with_what_moves(fields: Fields, content: Content, packed: Packed, largest: int) -> tuple[Content, Packed]:
    moving = content.kept & _find_moving(fields, content.kept)
    if np.array_equal(moving, content.kept):
        return content, packed
    content = content.but(kept=moving)
    return content, pack(fields, content)


def _merged(fields: Fields, content: Content, packed: Packed, largest: int) -> tuple[Content, Packed]:
    start = fields.positions(0)
    diagonal = float(np.linalg.norm(np.ptp(start, axis=0)))
    side = find_edge(fields, content.kept)
    while len(packed[1]) > largest and side < diagonal / COARSEST:
        side *= max(1.3, 1.05 * (len(packed[1]) / largest) ** 0.5)
        content = content.but(merge=side)
        packed = pack(fields, content)
    return content, packed


def _with_two_frames(fields: Fields, content: Content, packed: Packed, largest: int) -> tuple[Content, Packed]:
    return _with_fewer_frames(fields, content, packed, largest, 2)


def find_edge(fields: Fields, kept: Array) -> float:
    """The median length of an edge."""
    start, corners = fields.positions(0), fields.hexahedra[kept]
    length = np.linalg.norm(start[corners[:, 0]] - start[corners[:, 1]], axis=1)
    return float(np.median(length[length > 0])) if (length > 0).any() else 1.0


def _spread(fields: Fields, wanted: int) -> Array:
    count = len(fields.times)
    return np.asarray(np.unique(np.round(np.linspace(0, count - 1, min(count, wanted))).astype(int)))


def _find_moving(fields: Fields, kept: Array) -> Array:
    """[elements] of parts of which some node moves."""
    way = np.linalg.norm(fields.positions(-1) - fields.positions(0), axis=1)
    size = np.linalg.norm(np.ptp(fields.positions(0), axis=0))
    moves = (np.nan_to_num(way) > MOVING * size)[fields.hexahedra].any(axis=1)
    moving = np.zeros(fields.elements, dtype=bool)
    for part in np.unique(fields.part[kept]):
        moving[fields.part == part] = moves[fields.part == part].any()
    return moving if (moving & kept).any() else np.ones(fields.elements, dtype=bool)


def _tell(fields: Fields, content: Content, about: dict[str, Any], solids: int, kept: Array, given: bool) -> list[str]:
    reduced_by = []
    if len(content.frames) < len(fields.times) and not given:
        reduced_by.append(f"{len(content.frames)} of {len(fields.times)} frames")
    if not np.array_equal(content.kept, kept):
        names = [fields.part_names[part] for part in np.unique(fields.part[kept & ~content.kept])]
        reduced_by.append(f"parts that do not move are left out ({', '.join(names)})")
    if content.merge:
        reduced_by.append(f"the surface is coarser: nodes within {content.merge:.3g} of each other are one, "
                          f"{about['faces']:,} faces are left")
    if solids and not content.volumes:
        reduced_by.append("a cut leaves solids open: what is inside does not fit")
    return reduced_by
