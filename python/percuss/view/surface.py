"""The surface over time for the interactive view: quantised, packed and compressed."""

import base64
import os
import zlib

import numpy as np

from percuss.render import colors
from percuss.render.ranges import choose_bar, find_ends
from percuss.render.skin import exterior_faces
from percuss.results.units import choose_unit, format_time

THREE = os.environ.get("PERCUSS_THREE", "/usr/share/javascript/three")  # Debian's libjs-three
LIBRARY = ("three.min.js", "examples/js/controls/OrbitControls.js")
MOST_FRAMES = 60
LARGEST_PACK = 1_900_000  # bytes, compressed
STEPS = 65535  # of a coordinate over the box of the run


def read_library():
    """The text of the library, or None where it is not installed."""
    try:
        texts = []
        for name in LIBRARY:
            with open(os.path.join(THREE, name), encoding="utf-8") as file:
                texts.append(file.read())
        return texts
    except OSError:
        return None


def read_viewer():
    """The text of what shows a surface with the library."""
    with open(os.path.join(os.path.dirname(os.path.realpath(__file__)), "viewer.js"), encoding="utf-8") as file:
        return file.read()


def pack_surface(fields, name, frames=None, more=(), largest=LARGEST_PACK, kept=None):
    """What viewer.js takes: (description, text of base 64), with as many frames as fit. None where not even two do, or not
    those that are given. more: names of further fields to choose from. largest: bytes, compressed. kept [elements]: which are shown."""
    names = [name, *more]
    if frames is not None:
        description, pack = _pack(fields, names, np.asarray(frames), kept)
        return (description, base64.b64encode(pack).decode("ascii")) if len(pack) <= largest else None
    count = len(fields.times)
    wanted = min(count, MOST_FRAMES)
    while True:
        frames = np.unique(np.round(np.linspace(0, count - 1, wanted)).astype(int))
        description, pack = _pack(fields, names, frames, kept)
        if len(pack) <= largest:
            return description, base64.b64encode(pack).decode("ascii")
        if wanted <= 2:
            return None
        wanted = max(2, min(wanted - 1, int(wanted * 0.9 * largest / len(pack))))


def _find_faces(fields, frames, kept):
    """Every face that is outside in some frame [faces][4], its element, and [frames][faces] whether it is seen then."""
    faces, owners, seen, numbers = [], [], [], {}
    last = None
    for frame in frames:
        alive = fields.alive(frame) if kept is None else fields.alive(frame) & kept
        if last is None or not np.array_equal(alive, last):
            last = alive
            found, elements = exterior_faces(fields.hexahedra, alive)
            now = []
            for corners, element in zip(found.tolist(), elements.tolist()):
                key = (*corners, element)
                if key not in numbers:
                    numbers[key] = len(faces)
                    faces.append(corners)
                    owners.append(element)
                now.append(numbers[key])
        seen.append(now)
    visible = np.zeros((len(frames), len(faces)), dtype=np.uint8)
    for row, now in enumerate(seen):
        visible[row, now] = 1
    return np.array(faces).reshape(-1, 4), np.array(owners, dtype=int), visible


def _pack(fields, names, frames, kept):
    faces, owners, visible = _find_faces(fields, frames, kept)
    nodes, corners = np.unique(faces, return_inverse=True)
    corners = corners.reshape(-1, 4)
    places = np.nan_to_num(np.stack([fields.positions(frame)[nodes] for frame in frames]))
    low, high = places.min(axis=(0, 1)), places.max(axis=(0, 1))
    scale = np.where(high > low, high - low, 1.0)
    whole = np.round((places - low) / scale * STEPS).astype(np.uint16)
    erodes = bool((visible != visible[0]).any())
    description = {
        "nodes": len(nodes), "faces": len(faces), "frames": len(frames), "low": low.tolist(), "scale": (scale / STEPS).tolist(),
        "erodes": erodes, "parts": fields.part_names,
        "partColors": [colors.PART_COLORS[i % len(colors.PART_COLORS)] for i in range(len(fields.part_names))],
        "times": [format_time(fields.times[f], fields.times[-1], fields.time_unit) for f in frames],
        "numbers": [int(f) for f in frames],
    }
    shades = []
    for name in names:
        place = fields.names()[name]
        values = [fields.values(name, frame)[owners if place == "element" else nodes] for frame in frames]
        one = {"place": place}
        shades.append(_add_shades(one, fields, name, values))
        description.setdefault("fields", []).append(one)
    description.update(description["fields"][0])
    pieces = [corners.astype(np.uint32), fields.part[owners].astype(np.uint8)]
    pieces += [_find_differences(whole), *shades] + ([visible] if erodes else [])
    return description, zlib.compress(b"".join(piece.tobytes() for piece in pieces), 9)


def _find_differences(whole):
    """Bytes of the first frame and of the changes to each next one: all low bytes of a frame, then all high ones, which are
    mostly zeros."""
    changes = np.concatenate([whole[:1], whole[1:] - whole[:-1]])
    flat = changes.reshape(len(whole), -1)
    return np.concatenate([(flat & 255).astype(np.uint8), (flat >> 8).astype(np.uint8)], axis=1)


def _add_shades(description, fields, name, values):
    """[frames][items] the field in 254 steps between the ends of the bar; 255: no number."""
    low, high, labels = choose_bar(find_ends(values))
    unit, factor = choose_unit(fields.unit_of(name), max(abs(low), abs(high)))
    label = colors.label_of(name) + (f" [{unit}]" if unit else "")
    description.update(label=label, labels=[f"{x * factor:.4g}" for x in np.linspace(low, high, labels)], map=colors.MAPS["heat"])
    share = (np.stack(values) - low) / (high - low)
    return np.where(np.isfinite(share), np.round(np.clip(share, 0, 1) * 254), 255).astype(np.uint8)
