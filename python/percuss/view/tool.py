"""Writes the interactive view of a percuss run as one page. percuss view --help says how."""

import argparse
import os
from typing import NoReturn

from percuss.help_format import HelpFormatter
from percuss.libraries import require
from percuss.terminal import fail as end

NEEDS = ("numpy", "h5py", "matplotlib")
EPILOG = """\
The page is one HTML file that needs no network. The mouse turns and zooms the
surface. The page can:
  - play the run, choose the field, scale the deformation
  - show the outline at the start, rigid walls, arrows of vectors
  - mirror by the deck's symmetry, cut with a plane, hide parts
  - show the largest value, and the value under the pointer (to one 254th of
    the bar)
The key h lists the keys. Without WebGL the page draws plain pictures.

A surface that is too large is reduced, in this order: fewer arrows, no inside
of solids, fewer frames, only parts that move, fewer elements. The page and the
command say so.

Examples:
  percuss view ball                               writes ball/view.html
  percuss view ball --field von_mises,velocity --part plate

Exit codes:
  0    done
  2    a folder, a field or an option is wrong, or a library is missing
  4    the page cannot be written

Needs Python 3 with NumPy, h5py and Matplotlib, and three.js:
scripts/install_dependencies --report installs them.
docs/results.md describes the page.
"""


def parse_arguments(words: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="percuss view", epilog=EPILOG, formatter_class=HelpFormatter,
        description="Write the surface of a run over time as an interactive page.")
    add = parser.add_argument
    add("dir", metavar="DIR", help="the output folder of a run, complete or under way")
    add("--out", metavar="FILE", help="the page (default: view.html in DIR)")
    add("--from", dest="fields", metavar="NAME", help="of this entry of output.field_outputs (default: output.fields)")
    add("--field", metavar="NAMES", help="fields to choose from, with commas between them (default: all, six at most)")
    add("--part", metavar="NAME", action="append", help="these parts only; several times, or NAME,NAME")
    add("--units", metavar="SYSTEM",
        help="convert to a system of units, such as 'mm, kg, ms' (default: that of the deck)")
    add("-f", "--force", action="store_true",
        help="write over a file that percuss view has not written; never over results of a run")
    return parser.parse_args(words)


def fail(message: object, code: int = 2) -> NoReturn:
    end("view", message, code)


def main(words: list[str]) -> None:
    arguments = parse_arguments(words)
    require("the view needs", NEEDS)
    import percuss
    from percuss.files import check_target, write_file
    from percuss.render.selection import BadChoice
    from percuss.results.converted import convert_run
    from percuss.terminal import print_text
    from percuss.view.page import make_view_page

    try:
        run = convert_run(percuss.Run(arguments.dir, arguments.fields), arguments.units)
        path = arguments.out or os.path.join(run.folder, "view.html")
        check_target(path, "view", arguments.force)
        page, notes = make_view_page(run, arguments.field, arguments.part)
        write_file(path, page, "view", arguments.force)
    except (percuss.NotResults, BadChoice, ValueError) as error:
        fail(error)
    except OSError as error:
        fail(f"cannot write the view ({error})", 4)
    for text in notes:
        print_text(f"view: {text}")
    print_text(f"view: {path} ({os.path.getsize(path) / 1e6:.2g} MB)")
