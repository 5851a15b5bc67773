"""From the arguments of percuss render to files: which frames, which colours, PNG and GIF."""

from __future__ import annotations

import argparse
import io
import os
import sys
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from PIL import Image, PngImagePlugin

from percuss.files import check_target, make_mark, write_file
from percuss.results.arrays import Array
from percuss.results.converted import convert_fields
from percuss.results.deck import Deck
from percuss.results.fields import Fields
from percuss.results.run import Run
from percuss.results.units import format_time
from percuss.terminal import clean, print_text

from . import colors
from .camera import place_camera, sample_positions
from .coloring import Coloring
from .following import Following
from .largest import Largest, format_value
from .mirrors import Planes, choose_planes, list_copies, reflect
from .plates import mirror_walls, span_walls
from .scene import Scene, Surface
from .selection import BadChoice, choose_elements
from .skin import Skin
from .video import check_ffmpeg, encode_video

MOST_FACES_WITH_EDGES = 60_000
MOST_LEGEND_ENTRIES = 12
ANIMATION_WIDTH = 800
MARGINS = (0.03, 0.13, 0.05, 0.09)  # left, right (colour bar), bottom, top (title)


def render(arguments: argparse.Namespace) -> None:
    frames, shots = prepare(arguments)
    paths, films = choose_paths(arguments, frames, os.path.dirname(os.path.abspath(shots[0].fields.path)))
    for path in [*paths.values(), *films.values()]:
        check_target(path, "render", arguments.force)
    images = []
    live = sys.stdout.isatty()
    for frame in frames:
        image = join([shot.draw(frame) for shot in shots])
        write_file(paths[frame], encode_picture(image), "render", arguments.force)
        images.append(image if arguments.video else shrink(image))
        if live or frame == frames[-1]:
            print(f"{chr(13) if live else ''}render: {clean(paths[frame])}", end="", flush=True)
    print()
    for words in filter(None, (shot.describe_largest() for shot in shots)):
        print_text(f"render: {words}")
    for kind, path in films.items():
        film = (encode_animation([shrink(image) for image in images], arguments.fps) if kind == "gif"
                else encode_video(images, arguments.fps, kind))
        write_file(path, film, "render", arguments.force)
        print_text(f"render: {path}")


def choose_paths(arguments: argparse.Namespace, frames: list[int],
                 folder: str) -> tuple[dict[int, str], dict[str, str]]:
    """({frame: path of its picture}, {"gif": path, ...}), in --out or else in the folder of the run;
    --out FILE.png is the one picture."""
    out = arguments.out or folder
    if is_picture(out):
        if len(frames) != 1:
            raise BadChoice(f"--out {out} is one picture, and there are {len(frames)} frames: choose one with --frame, "
                            "or give a folder")
        return {frames[0]: out}, {}
    os.makedirs(out, exist_ok=True)
    prefix = f"{arguments.fields}_" if arguments.fields else ""
    is_film = arguments.frame is None and len(frames) > 1
    kinds = ["gif", *dict.fromkeys(arguments.video)] if is_film else []
    return ({frame: os.path.join(out, f"{prefix}frame_{frame:04d}.png") for frame in frames},
            {kind: os.path.join(out, f"{prefix}animation.{kind}") for kind in kinds})


def is_picture(out: str) -> bool:
    """Whether --out names a file; pictures of another kind are refused."""
    ending = os.path.splitext(out)[1].lower()
    if os.path.isdir(out) or ending not in (".png", ".gif", ".jpg", ".jpeg", ".svg", ".mp4", ".webm"):
        return False
    if ending != ".png":
        raise BadChoice(f"--out {out} is neither a folder nor a .png: a picture is a PNG, "
                        "and films go into a folder (--video)")
    return True


def prepare(arguments: argparse.Namespace) -> tuple[list[int], list[Shot]]:
    """(frames, shots): one shot of the run, or two beside each other with one range of colours."""
    if arguments.video:
        check_ffmpeg()
    fields = convert_fields(Fields(arguments.dir, arguments.fields), arguments.units)
    frames = choose_frames(fields, arguments.frame)
    if not arguments.beside:
        return frames, [Shot(fields, arguments, frames)]
    other = convert_fields(Fields(arguments.beside, arguments.fields), arguments.units)
    pairs = [(fields, frames, {frame: frame for frame in frames})]
    nearest = {frame: int(np.argmin(np.abs(other.times - fields.times[frame]))) for frame in frames}
    pairs.append((other, sorted(set(nearest.values())), nearest))
    width, height = arguments.size
    halves = argparse.Namespace(**{**vars(arguments), "size": (max(64, width // 2), height)})
    if not halves.range:
        bars = [Coloring(of, halves, choose_elements(of, halves)[0], drawn) for of, drawn, _ in pairs]
        if all(bar.title is not None for bar in bars):
            halves.range = (min(bar.ends[0] for bar in bars), max(bar.ends[1] for bar in bars))
    boxes = [_find_box(of, halves) for of, _, _ in pairs]
    return (frames, [Shot(of, halves, drawn, frame_of, box, _name(of))
                     for (of, drawn, frame_of), box in zip(pairs, boxes[::-1])])


def _name(fields: Fields) -> str:
    return os.path.basename(os.path.dirname(os.path.abspath(fields.path)))


def _find_box(fields: Fields, arguments: argparse.Namespace) -> Array:
    """The corners of what a run shows."""
    nodes = np.unique(fields.hexahedra[choose_elements(fields, arguments)[0]])
    points = sample_positions(fields, nodes, range(len(fields.times)) if arguments.focus == "run" else [0])
    low, high = np.quantile(points, [0.0005, 0.9995], axis=0)
    return np.array([[(low, high)[i][0], (low, high)[j][1], (low, high)[k][2]] for i in (0, 1) for j in (0, 1)
                     for k in (0, 1)])


def join(images: list[Any]) -> Any:
    if len(images) == 1:
        return images[0]
    whole = Image.new("RGB", (sum(image.width for image in images), images[0].height))
    left = 0
    for image in images:
        whole.paste(image, (left, 0))
        left += image.width
    return whole


class Shot:
    """The pictures of a run. frame_of: the frame of this run for a frame of the first; box: points that are to be in
    view, too. title: in place of that of the deck. largest: (value, words, frame) of what has been drawn, or None."""

    def __init__(self, fields: Fields, arguments: argparse.Namespace, frames: list[int], frame_of: dict[int, int]
                 | None = None, box: Array = np.empty((0, 3)), title: str | None = None) -> None:
        self.fields, self.arguments, self.frame_of = fields, arguments, frame_of
        self.largest: tuple[float, str, int] | None = None
        self.kept, self.cut = choose_elements(fields, arguments)
        self.coloring = Coloring(fields, arguments, self.kept, frames)
        self.surface = Surface(Skin(fields.hexahedra, self.kept, self.cut))
        self.following = Following(fields, arguments.follow, self.surface.skin.nodes(), frames)
        self.planes = choose_planes(fields, arguments.mirror, find_deck_of(fields) if arguments.mirror else Deck())
        extras = Extras(self.following, self.planes, title)
        self.scene, self.walls = make_scene(fields, arguments, self.surface, self.coloring, frames, box, extras)
        self.clock = self.scene.add_text("", 0.03, 0.035, 0.03)
        self.alive = self.kept

    def draw(self, frame: int) -> Any:
        frame = self.frame_of[frame] if self.frame_of else frame
        fields, surface, scene = self.fields, self.surface, self.scene
        now = self.kept & fields.alive(frame)
        if not np.array_equal(now, self.alive):
            self.alive = now
            surface.choose(Skin(fields.hexahedra, now, self.cut))
        surface.move(fields.positions(frame))
        scene.place_walls(self.walls.span(frame))
        surface.color(*self.coloring.choose_values(frame, surface.skin))
        self.clock.SetInput(format_time(fields.times[frame], fields.times[-1], fields.time_unit))
        if self.following.is_on:
            scene.shift_camera(self.following.shift(frame))
        if self.coloring.title is not None and self.arguments.mark:
            self._mark(frame)
        return Image.fromarray(scene.draw()).resize(self.arguments.size, Image.Resampling.LANCZOS)

    def _mark(self, frame: int) -> None:
        found = Largest(self.fields, self.coloring, frame, self.alive)
        self.scene.mark(found.point, f"max {format_value(found.value, self.coloring)}" if found.point is not None
                        else "", self.planes)
        if found.point is not None and (self.largest is None or found.value > self.largest[0]):
            self.largest = (found.value, found.text, frame)

    def describe_largest(self) -> str:
        """Empty where nothing was marked."""
        if self.largest is None:
            return ""
        value, words, frame = self.largest
        where = f"{_name(self.fields)}: " if self.frame_of else ""
        return (f"{where}largest {colors.label_of(self.coloring.name)} {format_value(value, self.coloring)} in "
                f"{words}, frame {frame}")


def find_deck_of(fields: Fields) -> Deck:
    return Run(os.path.dirname(os.path.abspath(fields.path))).deck


class Extras:
    """What make_scene can do besides: a camera that follows, planes of mirrors, another title."""

    def __init__(self, following: Following | None = None, planes: Planes = (), title: str | None = None) -> None:
        self.shift = following.shift if following is not None and following.is_on else None
        self.planes, self.title = planes, title


def encode_picture(image: Any) -> bytes:
    """A PNG with the mark of percuss render."""
    about, stream = PngImagePlugin.PngInfo(), io.BytesIO()
    about.add_text("Software", make_mark("render"))
    image.save(stream, "PNG", pnginfo=about)
    return stream.getvalue()


def choose_frames(fields: Fields, wanted: Iterable[int] | None) -> list[int]:
    """Numbers of the frames that are wanted, from 0 and rising; all by default."""
    count = len(fields.times)
    for frame in wanted or ():
        if not -count <= frame < count:
            raise BadChoice(f"there is no frame {frame} (the file has {count}, numbered from 0; -1 is the last)")
    return sorted({frame % count for frame in wanted or range(count)})


class Walls:
    """The plates of rigid walls and of their mirrored images;
    one that stands between the camera and the bodies is seen through."""

    def __init__(self, fields: Fields, points: Array, camera: Array, planes: Planes) -> None:
        self._fields, self._points, self._camera, self._planes = fields, points, camera, planes

    def span(self, frame: int) -> list[tuple[Array | None, bool]]:
        """[(plates [k][4][3], whether it is seen from behind)] of each at the time of a frame;
        None for plates: it is not drawn."""
        walls = mirror_walls(span_walls(self._fields, frame, self._points), self._planes)
        return [(plates, plane is not None and bool((self._camera - plane[0]) @ plane[1] < 0))
                for plates, plane in walls]


class NoWalls:
    def span(self, frame: int) -> list[tuple[Array | None, bool]]:
        return []


def make_scene(fields: Fields, arguments: argparse.Namespace, surface: Surface, coloring: Coloring,
               frames: Sequence[int], marks: Array = np.empty((0, 3)),
               extras: Extras | None = None) -> tuple[Scene, Walls | NoWalls]:
    """The scene with its walls as in the first of the frames, and the walls. marks: points [n][3] that are to be in
    view, besides the bodies."""
    edges = arguments.edges == "on" or (
        arguments.edges == "auto" and surface.mesh.GetNumberOfPolys() <= MOST_FACES_WITH_EDGES)
    scene = Scene(surface, coloring.lut, arguments.size, 1 if arguments.fast else 2, edges)
    extras = extras or Extras()
    scene.add_copies(list_copies(extras.planes))
    nodes = surface.skin.nodes()
    points = sample_positions(fields, nodes, range(len(fields.times)) if arguments.focus == "run" else [0],
                              shift=extras.shift)
    points = reflect(points, extras.planes)
    shown = np.concatenate([points, *[marks] * max(1, len(points) // 400)]) if len(marks) else points
    aspect = arguments.size[0] / arguments.size[1]
    azimuth, elevation = arguments.view
    position, target, up = place_camera(shown, azimuth, elevation, aspect, MARGINS, arguments.look_at)
    walls: Walls | NoWalls = NoWalls() if arguments.no_walls else Walls(fields, points, position, extras.planes)
    scene.place_walls(walls.span(frames[0]))
    ends = [plates.reshape(-1, 3) for frame in {frames[0], frames[-1]}
            for plates, _ in walls.span(frame) if plates is not None]
    scene.aim(position, target, up, arguments.zoom, np.concatenate([shown, *ends]))
    if not arguments.fast:
        start = fields.positions(0)
        diagonal = float(np.linalg.norm(np.ptp(start[nodes], axis=0)))
        cell = np.median(np.linalg.norm(start[fields.hexahedra[:, 0]] - start[fields.hexahedra[:, 6]], axis=1)) / 3**0.5
        scene.shade(diagonal, cell)
    scene.add_text(extras.title or fields.title, 0.03, 0.93, 0.034)
    if coloring.title is not None:
        scene.add_color_bar(coloring.lut, coloring.title, coloring.labels, coloring.note)
    else:
        for row, (number, name) in enumerate(coloring.legend()[:MOST_LEGEND_ENTRIES]):
            scene.add_legend_entry(row, colors.part_color(number), name)
    return scene, walls


def shrink(image: Any) -> Any:
    width = min(ANIMATION_WIDTH, image.width)
    return image.resize((width, round(image.height * width / image.width)), Image.Resampling.LANCZOS)


def encode_animation(images: list[Any], fps: float) -> bytes:
    """A GIF with one palette for all frames, so that still areas do not flicker and compress well."""
    width, height = images[0].size
    strip: Any = Image.new("RGB", (width, height * 3))
    for row, index in enumerate((0, len(images) // 2, len(images) - 1)):
        strip.paste(images[index], (0, row * height))
    palette = strip.quantize(256, method=Image.Quantize.MEDIANCUT)
    frames = [im.quantize(palette=palette, dither=Image.Dither.NONE) for im in images]
    durations = [round(1000 / fps)] * (len(frames) - 1) + [1200]  # rest on the last one
    stream = io.BytesIO()
    frames[0].save(stream, "GIF", save_all=True, append_images=frames[1:], duration=durations, loop=0, optimize=False,
                   comment=make_mark("render").encode())
    return stream.getvalue()
