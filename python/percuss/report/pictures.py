"""Pictures of the start, the worst frame and the end, drawn by percuss render."""

import base64
import io
import os
import subprocess
import tempfile

import numpy as np

from percuss.render.ranges import choose_bar, find_ends
from percuss.results.fields import Fields
from percuss.tools import start_tool

SIZE = "960x540"
SAME_PICTURE = 0.5  # mean difference of colours, of 255, up to which two pictures are the same
QUALITY = 88  # of JPEG: about 60 kB a picture


def choose_field(fields: Fields, wanted: str | None = None) -> str:
    """What colours show, where the user names nothing."""
    names = fields.names()
    first = ("von_mises", "stress", "equivalent_plastic_strain", "velocity")
    return wanted if wanted else next((name for name in first if name in names), "part")


class Worst:
    """The frame in which a field is largest. Attributes: frame, value, item (index), place (node or element), part (its
    name, where another part may hide it; else empty), text."""

    def __init__(self, fields: Fields, name: str) -> None:
        self.frame, self.value, self.item, self.place = 0, -np.inf, 0, fields.names()[name]
        for frame in range(len(fields.times)):
            values = fields.values(name, frame)
            if self.place == "element":
                values = np.where(fields.alive(frame), values, -np.inf)
            values = np.where(np.isfinite(values), values, -np.inf)
            item = int(np.argmax(values))
            if values[item] > self.value:
                self.frame, self.value, self.item = frame, float(values[item]), item
        ids = fields.element_ids if self.place == "element" else fields.node_ids
        name = fields.part_names[fields.part[self.item]] if self.place == "element" else ""
        self.part = name if len(set(fields.part)) > 1 and "," not in name else ""
        self.text = f"{self.place} {ids[self.item]}" + (f" of part '{name}'" if name else "")


def find_range(runs_fields: list[Fields], name: str, frames_of: list[list[int]]) -> str | None:
    """'LOW:HIGH' of the colours of several runs: of what their pictures show.
    None of one run, whose range percuss render finds."""
    if len(runs_fields) < 2:
        return None
    values = []
    for fields, frames in zip(runs_fields, frames_of):
        for frame in set(frames):
            found = fields.values(name, frame)
            values.append(found[fields.alive(frame)] if fields.names()[name] == "element" else found)
    low, high, _ = choose_bar(find_ends(values))
    return f"{float(low)!r}:{float(high)!r}"


def draw_pictures(fields: Fields, name: str, frames: list[int], options: dict[str, str | None]) -> dict[int, str]:
    """{frame: JPEG as text of base 64}, all with one range of colours. options: view, range,
    units and part, each None or a text. RuntimeError with the reason if there are none."""
    with tempfile.TemporaryDirectory() as folder:
        command = [*start_tool("render"), fields.path, "--out", folder, "--size", SIZE, "--field", name,
                   "--frame", ",".join(map(str, sorted(set(frames))))]
        command += [f"--{key}={value}" for key, value in options.items() if value]
        done = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=900)
        if done.returncode != 0:
            raise RuntimeError(done.stderr.strip().splitlines()[-1] if done.stderr.strip() else "percuss render failed")
        return {frame: _encode(os.path.join(folder, f"frame_{frame:04d}.png")) for frame in set(frames)}


def differ(one: str, other: str) -> bool:
    """Whether two pictures of draw_pictures show different things: more than round-off of their colours."""
    from PIL import Image

    values = [np.asarray(Image.open(io.BytesIO(base64.b64decode(text))), dtype=float) for text in (one, other)]
    return values[0].shape != values[1].shape or float(np.abs(values[0] - values[1]).mean()) > SAME_PICTURE


def _encode(path: str) -> str:
    from PIL import Image

    stream = io.BytesIO()
    with Image.open(path) as image:
        image.convert("RGB").save(stream, "JPEG", quality=QUALITY, optimize=True)
    return base64.b64encode(stream.getvalue()).decode("ascii")
