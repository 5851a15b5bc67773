"""From the arguments of scripts/render to files: which frames, which colours, PNG and GIF."""

import os
import sys

import numpy as np
from PIL import Image

from . import colors
from .camera import place_camera, sample_positions
from .fields import FieldsFile, exterior_faces
from .scene import Scene, Surface

MOST_FACES_WITH_EDGES = 60_000
MOST_LEGEND_ENTRIES = 12
ANIMATION_WIDTH = 800
MARGINS = (0.03, 0.13, 0.05, 0.09)  # left, right (colour bar), bottom, top (title)


class BadChoice(Exception):
    """An argument does not fit the file; str() is a message for the user."""


def render(arguments):
    fields = FieldsFile(arguments.dir)
    frames = choose_frames(fields, arguments.frame)
    coloring = Coloring(fields, arguments)
    kept = choose_elements(fields, arguments.clip)
    faces, owners = exterior_faces(fields.hexahedra, kept)
    surface = Surface(faces)
    scene = make_scene(fields, arguments, surface, coloring)
    clock = scene.add_text("", 0.03, 0.035, 0.03)
    folder = arguments.out or os.path.dirname(os.path.abspath(fields.path))
    os.makedirs(folder, exist_ok=True)
    images = []
    live = sys.stdout.isatty()
    alive = kept
    for frame in frames:
        now = kept & fields.alive(frame)
        if not np.array_equal(now, alive):
            alive = now
            faces, owners = exterior_faces(fields.hexahedra, alive)
            surface.choose(faces)
        surface.move(fields.positions(frame))
        surface.color(*coloring.choose_values(frame, surface.nodes, faces, owners))
        clock.SetInput(colors.format_time(fields.times[frame], fields.times[-1], fields.units))
        image = Image.fromarray(scene.draw()).resize(arguments.size, Image.Resampling.LANCZOS)
        path = os.path.join(folder, f"frame_{frame:04d}.png")
        image.save(path)
        images.append(shrink(image))
        if live or frame == frames[-1]:
            print(f"{chr(13) if live else ''}render: {path}", end="", flush=True)
    print()
    if len(images) > 1:
        path = os.path.join(folder, "animation.gif")
        write_animation(path, images, arguments.fps)
        print(f"render: {path}")


def choose_frames(fields, frame):
    count = len(fields.times)
    if frame is None:
        return list(range(count))
    if not -count <= frame < count:
        raise BadChoice(f"there is no frame {frame} (the file has {count}, numbered from 0; -1 is the last)")
    return [frame % count]


def choose_elements(fields, clip):
    if clip is None:
        return np.ones(fields.elements, dtype=bool)
    axis, value = clip
    centers = fields.positions(0)[fields.hexahedra, axis].mean(axis=1)
    kept = centers <= value
    if not kept.any():
        raise BadChoice(f"nothing is left of the mesh below {'xyz'[axis]} = {value:g} (it starts at {centers.min():g})")
    return kept


class Coloring:
    """What the colours mean: the field, where it lives, its table and the title of the bar."""

    def __init__(self, fields, arguments):
        self.fields = fields
        names = fields.names()
        wanted = "part" if arguments.part_colors else arguments.field
        self.name = wanted or next((n for n in ("von_mises", "stress", "velocity") if n in names), "part")
        if self.name not in names:
            raise BadChoice(f"there is no field '{self.name}' in {fields.path} (it has {', '.join(sorted(names))})")
        self.place = names[self.name]
        self.factor, self.title = 1.0, None
        self.categories = 0
        if self.name in colors.CATEGORIES:
            self.categories = int(max(values.max() for values in self._samples())) + 1
            self.lut = colors.make_category_lut(self.categories)
        else:
            self._make_bar(arguments)

    def _samples(self):
        """The field in some frames of the run, the first among them."""
        for frame in range(0, len(self.fields.times), max(1, len(self.fields.times) // 40)):
            yield self.fields.values(self.name, frame)

    def _make_bar(self, arguments):
        low, high = arguments.range or colors.robust_range(list(self._samples()))
        if not high > low:
            raise BadChoice(f"the range {low:g}:{high:g} is empty")
        unit, self.factor = colors.choose_unit(self.name, self.fields.units, max(abs(low), abs(high)))
        name = arguments.map.removesuffix("-r")
        if name not in colors.MAPS:
            raise BadChoice(f"there is no colour map '{arguments.map}' (there are {', '.join(colors.MAPS)})")
        self.lut = colors.make_lut(name, low * self.factor, high * self.factor, arguments.map.endswith("-r"))
        self.title = colors.label_of(self.name) + (f"\n[{unit}]" if unit else "")

    def choose_values(self, frame, nodes, faces, owners):
        """'node' with a number for each of `nodes`, or 'element' with one for each face: its element's, or, of a category
        of nodes, which has nothing in between, the highest of its corners'."""
        values = self.fields.values(self.name, frame) * self.factor
        if self.place == "element":
            return "element", values[owners]
        if self.categories:
            return "element", values[faces].max(axis=1)
        return "node", values[nodes]


def make_scene(fields, arguments, surface, coloring):
    edges = arguments.edges == "on" or (
        arguments.edges == "auto" and surface.mesh.GetNumberOfPolys() <= MOST_FACES_WITH_EDGES)
    scene = Scene(surface, coloring.lut, arguments.size, 1 if arguments.fast else 2, edges)
    all_frames = range(len(fields.times)) if arguments.focus == "run" else [0]
    points = sample_positions(fields, surface.nodes, all_frames)
    aspect = arguments.size[0] / arguments.size[1]
    position, target, up = place_camera(points, *arguments.view, aspect, arguments.zoom, MARGINS)
    scene.look(position, target, up, points)
    if not arguments.fast:
        start = fields.positions(0)
        diagonal = np.linalg.norm(np.ptp(start[surface.nodes], axis=0))
        cell = np.median(np.linalg.norm(start[fields.hexahedra[:, 0]] - start[fields.hexahedra[:, 6]], axis=1)) / 3**0.5
        scene.shade(diagonal, cell)
    scene.add_text(fields.title, 0.03, 0.93, 0.034)
    if coloring.title is not None:
        scene.add_color_bar(coloring.lut, coloring.title)
    else:
        for row, name in enumerate(legend_names(fields, coloring)[:MOST_LEGEND_ENTRIES]):
            scene.add_legend_entry(row, colors.part_color(row), name)
    return scene


def legend_names(fields, coloring):
    """What the colours stand for; of bodies and chunks there are too many to name."""
    if coloring.name == "part":
        return fields.part_names
    return [f"rank {r}" for r in range(coloring.categories)] if coloring.name.endswith("_rank") else []


def shrink(image):
    width = min(ANIMATION_WIDTH, image.width)
    return image.resize((width, round(image.height * width / image.width)), Image.Resampling.LANCZOS)


def write_animation(path, images, fps):
    """A GIF with one palette for all frames, so that still areas do not flicker and compress well."""
    width, height = images[0].size
    strip = Image.new("RGB", (width, height * 3))
    for row, index in enumerate((0, len(images) // 2, len(images) - 1)):
        strip.paste(images[index], (0, row * height))
    palette = strip.quantize(256, method=Image.Quantize.MEDIANCUT)
    frames = [im.quantize(palette=palette, dither=Image.Dither.NONE) for im in images]
    durations = [round(1000 / fps)] * (len(frames) - 1) + [1200]  # rest on the last one
    frames[0].save(path, save_all=True, append_images=frames[1:], duration=durations, loop=0, optimize=False)
