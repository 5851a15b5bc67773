"""From the arguments of scripts/render to files: which frames, which colours, PNG and GIF."""

import io
import os
import sys

import numpy as np
from percuss.fields import Fields
from percuss.files import check_target, make_mark, write_file
from percuss.terminal import clean, tell
from percuss.units import format_time
from PIL import Image, PngImagePlugin

from . import colors
from .camera import place_camera, sample_positions
from .coloring import Coloring
from .plates import span_walls
from .scene import Scene, Surface
from .selection import BadChoice, choose_elements
from .skin import Skin

MOST_FACES_WITH_EDGES = 60_000
MOST_LEGEND_ENTRIES = 12
ANIMATION_WIDTH = 800
MARGINS = (0.03, 0.13, 0.05, 0.09)  # left, right (colour bar), bottom, top (title)


def render(arguments):
    fields = Fields(arguments.dir, arguments.fields)
    frames = choose_frames(fields, arguments.frame)
    kept, cut = choose_elements(fields, arguments)
    coloring = Coloring(fields, arguments, kept, frames)
    surface = Surface(Skin(fields.hexahedra, kept, cut))
    scene, walls = make_scene(fields, arguments, surface, coloring, frames)
    clock = scene.add_text("", 0.03, 0.035, 0.03)
    folder = arguments.out or os.path.dirname(os.path.abspath(fields.path))
    os.makedirs(folder, exist_ok=True)
    prefix = f"{arguments.fields}_" if arguments.fields else ""
    paths = {frame: os.path.join(folder, f"{prefix}frame_{frame:04d}.png") for frame in frames}
    animation = os.path.join(folder, f"{prefix}animation.gif") if arguments.frame is None and len(frames) > 1 else None
    for path in [*paths.values(), *[animation] * bool(animation)]:
        check_target(path, "render", arguments.force)
    images = []
    live = sys.stdout.isatty()
    alive = kept
    for frame in frames:
        now = kept & fields.alive(frame)
        if not np.array_equal(now, alive):
            alive = now
            surface.choose(Skin(fields.hexahedra, alive, cut))
        surface.move(fields.positions(frame))
        scene.place_walls(walls.span(frame))
        surface.color(*coloring.choose_values(frame, surface.skin))
        clock.SetInput(format_time(fields.times[frame], fields.times[-1], fields.time_unit))
        image = Image.fromarray(scene.draw()).resize(arguments.size, Image.Resampling.LANCZOS)
        write_file(paths[frame], encode_picture(image), "render", arguments.force)
        images.append(shrink(image))
        if live or frame == frames[-1]:
            print(f"{chr(13) if live else ''}render: {clean(paths[frame])}", end="", flush=True)
    print()
    if animation:
        write_file(animation, encode_animation(images, arguments.fps), "render", arguments.force)
        tell(f"render: {animation}")


def encode_picture(image):
    """A PNG with the mark of percuss render."""
    about, stream = PngImagePlugin.PngInfo(), io.BytesIO()
    about.add_text("Software", make_mark("render"))
    image.save(stream, "PNG", pnginfo=about)
    return stream.getvalue()


def choose_frames(fields, wanted):
    """Numbers of the frames that are wanted, from 0 and rising; all by default."""
    count = len(fields.times)
    for frame in wanted or ():
        if not -count <= frame < count:
            raise BadChoice(f"there is no frame {frame} (the file has {count}, numbered from 0; -1 is the last)")
    return sorted({frame % count for frame in wanted or range(count)})


class Walls:
    """The plates of rigid walls; one that stands between the camera and the bodies is seen through."""

    def __init__(self, fields, points, camera):
        self._fields, self._points, self._camera = fields, points, camera

    def span(self, frame):
        """[(plates [k][4][3], whether it is seen from behind)] of each at the time of a frame."""
        return [(plates, plane is not None and (self._camera - plane[0]) @ plane[1] < 0)
                for plates, plane in span_walls(self._fields, frame, self._points)]


class NoWalls:
    def span(self, frame):
        return []


def make_scene(fields, arguments, surface, coloring, frames, marks=np.empty((0, 3))):
    """The scene with its walls as in the first of the frames, and the walls. marks: points [n][3] that are to be in view, besides
    the bodies."""
    edges = arguments.edges == "on" or (
        arguments.edges == "auto" and surface.mesh.GetNumberOfPolys() <= MOST_FACES_WITH_EDGES)
    scene = Scene(surface, coloring.lut, arguments.size, 1 if arguments.fast else 2, edges)
    nodes = surface.skin.nodes()
    points = sample_positions(fields, nodes, range(len(fields.times)) if arguments.focus == "run" else [0])
    shown = np.concatenate([points, *[marks] * max(1, len(points) // 400)]) if len(marks) else points
    aspect = arguments.size[0] / arguments.size[1]
    position, target, up = place_camera(shown, *arguments.view, aspect, MARGINS, arguments.look_at)
    walls = NoWalls() if arguments.no_walls else Walls(fields, points, position)
    scene.place_walls(walls.span(frames[0]))
    ends = [plates.reshape(-1, 3) for frame in {frames[0], frames[-1]} for plates, _ in walls.span(frame)]
    scene.look(position, target, up, arguments.zoom, np.concatenate([shown, *ends]))
    if not arguments.fast:
        start = fields.positions(0)
        diagonal = np.linalg.norm(np.ptp(start[nodes], axis=0))
        cell = np.median(np.linalg.norm(start[fields.hexahedra[:, 0]] - start[fields.hexahedra[:, 6]], axis=1)) / 3**0.5
        scene.shade(diagonal, cell)
    scene.add_text(fields.title, 0.03, 0.93, 0.034)
    if coloring.title is not None:
        scene.add_color_bar(coloring.lut, coloring.title, coloring.labels, coloring.note)
    else:
        for row, (number, name) in enumerate(coloring.legend()[:MOST_LEGEND_ENTRIES]):
            scene.add_legend_entry(row, colors.part_color(number), name)
    return scene, walls


def shrink(image):
    width = min(ANIMATION_WIDTH, image.width)
    return image.resize((width, round(image.height * width / image.width)), Image.Resampling.LANCZOS)


def encode_animation(images, fps):
    """A GIF with one palette for all frames, so that still areas do not flicker and compress well."""
    width, height = images[0].size
    strip = Image.new("RGB", (width, height * 3))
    for row, index in enumerate((0, len(images) // 2, len(images) - 1)):
        strip.paste(images[index], (0, row * height))
    palette = strip.quantize(256, method=Image.Quantize.MEDIANCUT)
    frames = [im.quantize(palette=palette, dither=Image.Dither.NONE) for im in images]
    durations = [round(1000 / fps)] * (len(frames) - 1) + [1200]  # rest on the last one
    stream = io.BytesIO()
    frames[0].save(stream, "GIF", save_all=True, append_images=frames[1:], duration=durations, loop=0, optimize=False,
                   comment=make_mark("render").encode())
    return stream.getvalue()
