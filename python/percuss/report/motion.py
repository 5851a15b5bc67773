"""How each part moved and changed its shape, from the first frame to the last."""

from dataclasses import dataclass

import numpy as np

from percuss.results.arrays import Array
from percuss.results.fields import Fields
from percuss.results.run import Run
from percuss.results.units import choose_unit

from .markup import make_filled_table

SMALL_MOTION = 1e-3   # share of the size of the scene: a part that moves less stays where it is
SMALL_STRETCH = 0.02  # change of an extent that is put in words
MOST_PARTS = 4        # that sentences name
ALONG = 0.95          # cosine from which a motion is along an axis
SMALL_TURN = 5        # degrees; smaller turns are not put in words
FLAT = 1e-6           # second over first singular value: the nodes are on a line, whose turn about itself is not known


@dataclass
class Motion:
    """The motion of the nodes of a part that belong to active elements of the last frame. Means over these nodes."""

    part: str
    moved: Array  # displacement
    speeds: tuple[float, float] | None  # magnitudes of the mean velocity in both frames; None without the field
    turned: float  # degrees, of the rotation that fits best
    start: Array  # extents along x, y, z
    end: Array  # the same after this rotation is undone, so that a rigid part keeps its extents
    lost: int  # elements that have failed


def find_motions(fields: Fields) -> list[Motion]:
    first, last = fields.positions(0), fields.positions(-1)
    alive, velocities = fields.alive(-1), None
    if "velocity" in fields.names():
        velocities = fields.data("velocity", 0), fields.data("velocity", -1)
    found = []
    for number, name in enumerate(fields.part_names):
        mine = fields.part == number
        nodes = np.unique(fields.hexahedra[mine & alive])
        if not len(nodes) or not np.isfinite(last[nodes]).all():
            continue
        turned, back = _undo_rotation(first[nodes], last[nodes])
        speeds = None
        if velocities:
            before, after = (float(np.linalg.norm(v[nodes].mean(axis=0))) for v in velocities)
            speeds = before, after
        found.append(Motion(name, (last[nodes] - first[nodes]).mean(axis=0), speeds, turned,
                            np.ptp(first[nodes], axis=0), np.ptp(back, axis=0), int((mine & ~alive).sum())))
    return found


def _undo_rotation(first: Array, last: Array) -> tuple[float, Array]:
    """(degrees, the last positions turned back about their mean): the rotation of least squares (Kabsch 1976)."""
    a, b = first - first.mean(axis=0), last - last.mean(axis=0)
    left, size, right = np.linalg.svd(a.T @ b)
    if not size[1] > FLAT * size[0]:
        return 0.0, last
    sign = np.diag([1, 1, np.linalg.det(left @ right)])
    rotation = left @ sign @ right  # of a row vector, from the first to the last
    cosine = np.clip((np.trace(rotation) - 1) / 2, -1, 1)
    return float(np.degrees(np.arccos(cosine))), b @ rotation.T


def describe_motions(run: Run) -> list[str]:
    """Sentences: where the parts went that moved most, and what became shorter or longer."""
    if not run.has_fields or len(run.fields.times) < 2:
        return []
    size = float(np.linalg.norm(np.ptp(run.fields.positions(0), axis=0)))
    length, velocity = (run.units.name_of(quantity) if run.units else "" for quantity in ("length", "velocity"))
    sentences = []
    for motion in sorted(find_motions(run.fields), key=lambda motion: -np.linalg.norm(motion.moved)):
        texts = [*_tell_path(motion, length, size), *_tell_turn(motion), *_tell_speeds(motion, velocity),
                 *_tell_shape(motion, length)]
        if texts and _has_changed(motion, size):
            sentences.append(f"{motion.part}: {'; '.join(texts)}.")
    more = f"The table of parts has {len(sentences) - MOST_PARTS} more." if len(sentences) > MOST_PARTS else ""
    return sentences[:MOST_PARTS] + [more] * bool(more)


def _has_changed(motion: Motion, size: float) -> bool:
    return bool(np.linalg.norm(motion.moved) > SMALL_MOTION * size or _list_stretched(motion))


def _tell_path(motion: Motion, unit: str, size: float) -> list[str]:
    distance = float(np.linalg.norm(motion.moved))
    if distance <= SMALL_MOTION * size:
        return []
    axis = int(np.argmax(np.abs(motion.moved)))
    way = ""
    if abs(motion.moved[axis]) > ALONG * distance:
        way = f" along {'-' if motion.moved[axis] < 0 else ''}{'xyz'[axis]}"
    return [f"moved {show_length(distance, unit)}{way}"]


def _tell_turn(motion: Motion) -> list[str]:
    return [f"turned by {motion.turned:.3g} degrees"] if motion.turned > SMALL_TURN else []


def _tell_speeds(motion: Motion, unit: str) -> list[str]:
    if motion.speeds is None or not max(motion.speeds) > 0:
        return []
    return [f"mean velocity from {motion.speeds[0]:.4g} to {motion.speeds[1]:.4g} {unit}".rstrip()]


def _list_stretched(motion: Motion) -> list[int]:
    longest = motion.start.max()
    return [axis for axis in range(3) if motion.start[axis] > SMALL_STRETCH * longest
            and abs(motion.end[axis] / motion.start[axis] - 1) > SMALL_STRETCH]


def _tell_shape(motion: Motion, unit: str) -> list[str]:
    """The extent that has changed most."""
    axes = _list_stretched(motion)
    if not axes:
        return []
    axis = max(axes, key=lambda k: float(abs(motion.end[k] - motion.start[k])))
    ratio = motion.end[axis] / motion.start[axis]
    change = f"{ratio:.3g} times as long" if ratio > 3 else f"{100 * (ratio - 1):+.3g} %"  # bodies that fly apart
    return [f"extent along {'xyz'[axis]} from {show_length(motion.start[axis], unit)} to "
            f"{show_length(motion.end[axis], unit)} ({change})"]


def show_length(value: float, unit: str) -> str:
    """'39.1 mm' of 0.0391 m; in the unit of the deck where that is not m."""
    if unit == "m" and 1e-4 <= abs(value) < 0.5:
        return f"{1e3 * value:.4g} mm"
    shown, factor = choose_unit(unit, abs(value))
    return f"{value * factor:.4g} {shown}".rstrip()


def make_motion_table(run: Run) -> str:
    """A row for each part."""
    if not run.has_fields or len(run.fields.times) < 2:
        return ""
    length, velocity = (run.units.name_of(quantity) if run.units else "" for quantity in ("length", "velocity"))
    rows = []
    for motion in find_motions(run.fields):
        moved = "(" + ", ".join(f"{x:.4g}" for x in motion.moved) + ")"
        speeds = [f"{speed:.4g}" for speed in motion.speeds] if motion.speeds else ["", ""]
        rows.append((motion.part, moved, f"{motion.turned:.3g}", *speeds,
                     *(" x ".join(f"{x:.4g}" for x in size) for size in (motion.start, motion.end)),
                     f"{motion.lost:,}" if motion.lost else ""))
    in_unit, in_speed = (f" [{unit}]" if unit else "" for unit in (length, velocity))
    heading = ("part", f"mean displacement{in_unit}", "rotation [degrees]", f"mean speed, start{in_speed}", "end",
               f"extents, start{in_unit}", "end", "elements lost")
    if not rows:
        return ""
    return ("<h3>Motion of parts</h3>" + make_filled_table(heading, rows)
            + "<p class=soft>From the first frame to the last. Means over the nodes of active elements; extents along "
              "x, y and z, those at the end without the mean rotation. Speeds are magnitudes of the mean velocity.</p>")
