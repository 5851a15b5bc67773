"""Renders the fields of a percuss run: PNG frames and an animation. percuss render --help says how."""

import argparse
import math
import subprocess
from typing import NoReturn

from percuss.display import NoDisplay, open_display
from percuss.help_format import HelpFormatter
from percuss.libraries import MissingLibrary, require
from percuss.terminal import fail as end
from percuss.terminal import join_signed

WARNING_OF_PARAVIEW = (", which removes the package python3-paraview (on Debian 12 and 13 it and python3-vtk9 exclude "
                       "each other), or look at fields.xdmf2 with that ParaView")

NEEDS = ("h5py", "numpy", "PIL.Image", "vtkmodules.vtkRenderingOpenGL2")
EPILOG = """\
Writes DIR/frame_0000.png ... and DIR/animation.gif from DIR/fields.vtkhdf.
ParaView opens DIR/fields.xdmf2.

Examples:
  percuss render wall                               every frame, an animation
  percuss render wall --frame -1 --size 1920x1080   the last frame only
  percuss render wall --field velocity --range 0:200 --view 130:15
  percuss render wall --part-colors --clip y=0.5    parts apart, cut open
  percuss render wall --part rod --frame -1         the rod alone
  percuss render wall --follow rod --video mp4      the camera goes with the rod
  percuss render can --mirror                       by the deck's symmetry
  percuss render soft --beside stiff --frame -1     two runs in one picture
  percuss render wall --look-at 0:0:0.6 --zoom 3    three times as large

Exit codes:
  0    done
  2    a folder, a field or an option is wrong, a library is missing, or no
       picture can be written

Needs Python 3 with VTK 9, h5py, NumPy and Pillow, and Xvfb where there is no
display: scripts/install_dependencies --render installs all of it. On Debian 12
and 13 its python3-vtk9 and ParaView's python3-paraview exclude each other: apt
removes one to install the other. docs/output.md describes the pictures.
"""


def parse_arguments(words: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="percuss render", epilog=EPILOG, formatter_class=HelpFormatter,
        description="Draw pictures and an animation of the fields of a run.")
    add = parser.add_argument
    add("dir", metavar="DIR", help="the output folder of a run (or a fields.vtkhdf)")
    add("--out", metavar="FOLDER", help="where the pictures go (default: DIR); with one --frame also a FILE.png")
    add("--from", dest="fields", metavar="NAME",
        help="the frames of this entry of output.field_outputs, DIR/fields_NAME.vtkhdf; "
             "pictures are NAME_frame_0000.png ... (default: those of output.fields)")
    add("--field", metavar="NAME",
        help="field shown by the colours: a vector by its magnitude, a stress by von Mises' value; 'part', 'body', "
             "'chunk', 'fe_rank' and 'contact_rank' in a colour each (default: von_mises, else stress, else velocity)")
    add("--part-colors", action="store_true", help="one colour a part; the same as --field part")
    add("--units", metavar="SYSTEM", help="convert to a system of units, such as 'mm, kg, ms' (default: that of the "
                                          "deck); lengths and values of other options are in it, too")
    add("--range", metavar="LOW:HIGH", type=parse_pair,
        help="ends of the colour bar in the unit of the file "
             "(default: round numbers around those of all that is drawn, the same in all frames)")
    add("--map", default="heat", metavar="NAME",
        help="colour map: heat, viridis, inferno, cool-warm, grey (default: heat); -r behind the name reverses it")
    add("--view", metavar="AZIMUTH:ELEVATION", type=parse_pair, default=(-50.0, 22.0),
        help="where the camera stands, in degrees: from +x towards +y about z, and above the xy plane "
             "(default: -50:22)")
    add("--look-at", metavar="X:Y:Z", type=parse_point,
        help="the point in the middle of the picture (default: all is in view)")
    add("--zoom", metavar="FACTOR", type=parse_factor, default=1.0,
        help="magnification (default: 1)")
    add("--focus", choices=["run", "start"], default="run",
        help="what the camera frames: all that the run shows (default), or the scene as it starts")
    add("--part", metavar="NAME", action="append", help="draw this part only; several times, or NAME,NAME, for several")
    add("--clip", metavar="AXIS=VALUE", type=parse_clip,
        help="cut the bodies open, as they start, at this x, y or z, and take away the side where the camera stands; "
             "+x=VALUE takes away what is above, -x=VALUE what is below")
    add("--no-walls", action="store_true", help="do not draw rigid walls")
    add("--percentile", metavar="P", type=parse_percentile,
        help="the colour bar ends at this percentile of what is drawn, in the frame where it is largest; "
             "100 for all (default: 99, where the largest values are far above it)")
    add("--no-mark", dest="mark", action="store_false", help="do not mark the largest value")
    add("--follow", metavar="PART", nargs="?", const="moving",
        help="the camera follows this part, or without a name what moves most")
    add("--mirror", metavar="AXIS=VALUE", nargs="?", const="deck", action="append", type=parse_mirror,
        help="add the mirrored half at this plane; without a value at those of the deck's conditions with `symmetry`")
    add("--beside", metavar="DIR",
        help="the same frames of another run to the right, by time, with one range of colours")
    add("--video", choices=["mp4", "webm"], action="append", default=[], help="also a film; needs ffmpeg")
    add("--frame", metavar="N", type=parse_frames,
        help="only this frame, or those of N,N,...; -1 is the last (default: all, and an animation)")
    add("--size", metavar="WxH", type=parse_size, default=(1280, 720),
        help="size of the pictures in pixels (default: 1280x720)")
    add("--edges", choices=["auto", "on", "off"], default="auto",
        help="draw the edges of the elements (default: auto, which is on up to 60000 faces)")
    add("--fps", type=float, default=12.0, help="frames per second of the animation (default: 12)")
    add("-f", "--force", action="store_true", help="write over pictures that percuss render has not written")
    add("--fast", action="store_true", help="no ambient occlusion, less smoothing: about five times faster")
    return parser.parse_args(join_signed(words))


def parse_numbers(text: str, count: int, words: str) -> tuple[float, ...]:
    try:
        numbers = [float(word) for word in text.split(":")]
    except ValueError:
        numbers = []
    if len(numbers) != count or not all(map(math.isfinite, numbers)):
        raise argparse.ArgumentTypeError(f"'{text}' is not {words}")
    return tuple(numbers)


def parse_frames(text: str) -> list[int]:
    try:
        return [int(word) for word in text.split(",")]
    except ValueError:
        raise argparse.ArgumentTypeError(f"'{text}' is not a number of a frame, "
                                         "or several with commas between them") from None


def parse_pair(text: str) -> tuple[float, ...]:
    return parse_numbers(text, 2, "two numbers with a colon between them")


def parse_percentile(text: str) -> float:
    (percentile,) = parse_numbers(text, 1, "a number")
    if not 50 <= percentile <= 100:
        raise argparse.ArgumentTypeError(f"'{text}' is not a percentile of 50 to 100")
    return percentile


def parse_mirror(text: str) -> tuple[int, float] | str:
    """'deck', or (axis, value) of 'y=0'."""
    if text == "deck":
        return text
    side, axis, value = parse_clip(text)
    if side:
        raise argparse.ArgumentTypeError(f"'{text}' is not x=VALUE, y=VALUE or z=VALUE")
    return axis, value


def parse_point(text: str) -> tuple[float, ...]:
    return parse_numbers(text, 3, "three numbers with colons between them")


def parse_factor(text: str) -> float:
    (factor,) = parse_numbers(text, 1, "a number")
    if not 0.01 <= factor <= 1000:
        raise argparse.ArgumentTypeError(f"'{text}' is not a factor of 0.01 to 1000")
    return factor


def parse_size(text: str) -> tuple[int, int]:
    try:
        width, height = (int(word) for word in text.lower().split("x"))
    except ValueError:
        width = height = 0
    if not (64 <= width <= 8192 and 64 <= height <= 8192):
        raise argparse.ArgumentTypeError(f"'{text}' is not a size of 64x64 to 8192x8192")
    return width, height


def parse_clip(text: str) -> tuple[str, int, float]:
    """(side, axis, value): side is '+', '-' or empty."""
    side, axis, value = "", *text.partition("=")[::2]
    if axis[:1] in ("+", "-"):
        side, axis = axis[0], axis[1:]
    try:
        return side, ("x", "y", "z").index(axis), float(value)
    except ValueError:
        raise argparse.ArgumentTypeError(f"'{text}' is not x=VALUE, y=VALUE or z=VALUE, "
                                         "with + or - before it or not") from None


def fail(message: object) -> NoReturn:
    end("render", message)


def is_installed(package: str) -> bool:
    """Whether Debian's package is installed; False where there is no dpkg."""
    try:
        asked = subprocess.run(["dpkg-query", "-W", "-f", "${db:Status-Status}", package],
                               capture_output=True, text=True, check=False)
    except OSError:
        return False
    return asked.stdout == "installed"


def require_vtk() -> None:
    try:
        require("pictures need", NEEDS, "--render")
    except MissingLibrary as error:
        fail(f"{error}{WARNING_OF_PARAVIEW * is_installed('python3-paraview')}")


def main(words: list[str]) -> None:
    arguments = parse_arguments(words)
    require_vtk()
    from percuss.errors import NotResults
    from percuss.render.pictures import render
    from percuss.render.selection import BadChoice
    from percuss.results.units import BadUnits

    try:
        with open_display():
            render(arguments)
    except (NoDisplay, NotResults, BadChoice, BadUnits) as error:
        fail(error)
    except OSError as error:
        fail(f"cannot write pictures ({error})")
