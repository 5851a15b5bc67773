"""Writes one page about a percuss run, or a comparison of runs. percuss report --help says how."""

import argparse
import os
from typing import NoReturn

from percuss.help_format import HelpFormatter
from percuss.libraries import require
from percuss.terminal import fail as end
from percuss.terminal import join_signed

NEEDS = ("numpy", "h5py", "matplotlib")
WISHES = ("vtkmodules.vtkRenderingOpenGL2", "PIL.Image", "yaml")
EPILOG = """\
The page is one HTML file that needs no network and no other file. It has:
  - what to look at first
  - pictures of the start, of the end, and of the frame with the largest value
  - the surface over time, to turn with the mouse
  - plots with the warnings marked
  - the deck with parts and materials, and what the run cost
With several folders it compares them: bit-identity, numbers, curves and decks.

The deck is the one that was run, with the changes of --set: the run keeps it in
summary.json and in its checkpoint.

Examples:
  percuss report ball                             writes ball/report.html
  percuss report ball --field velocity            colours show the speed
  percuss report ball ball_fine --out finer.html  a comparison
  percuss report box --plot 'crush = resultant("crush")' --x 'change(-sled_z)'
  percuss report ball --units 'mm, kg, ms'        all values in kN, GPa and J
  percuss report out/* --no-pictures --no-view    no VTK needed

Exit codes:
  0    done
  2    a folder, a field or an option is wrong, a library is missing, or the
       page cannot be written

Needs Python 3 with NumPy, h5py, Matplotlib and YAML, and for pictures and view
VTK 9, Pillow, Xvfb and three.js: scripts/install_dependencies --report installs
all of it. Where VTK or three.js is missing, the page says so.
docs/results.md describes the page.
"""


def parse_arguments(words: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="percuss report", epilog=EPILOG, formatter_class=HelpFormatter,
        description="Write one page about a run, or a comparison of several runs.")
    add = parser.add_argument
    add("dirs", metavar="DIR", nargs="+", help="output folders of runs, complete or under way")
    add("--out", metavar="FILE", help="the page (default: report.html in the first DIR; of several comparison.html)")
    add("-f", "--force", action="store_true",
        help="write over a file that percuss report has not written; never over results of a run")
    add("--from", dest="fields", metavar="NAME",
        help="pictures and view of this entry of output.field_outputs (default: of output.fields)")
    add("--field", metavar="NAME", help="field shown by the colours (default: von_mises, stress, "
                                        "equivalent_plastic_strain or velocity, the first that is there)")
    add("--view", metavar="AZIMUTH:ELEVATION", help="where the camera of the pictures stands, as in percuss render")
    add("--units", metavar="SYSTEM",
        help="convert to a system of units, such as 'mm, kg, ms' (default: that of the deck)")
    add("--plot", metavar="WHAT", action="append", default=[],
        help="a curve or a number for the top of the page: a column, a panel or an expression, as in percuss plot; "
             "may be repeated")
    add("--x", metavar="COLUMN", default="time",
        help="the abscissa of these curves: a column or an expression (default: time)")
    add("--no-pictures", dest="pictures", action="store_false", help="leave the pictures out (they need VTK)")
    add("--no-view", dest="interactive", action="store_false",
        help="leave the interactive view out (it takes about 2 MB)")
    return parser.parse_intermixed_args(join_signed(words))


def fail(message: object) -> NoReturn:
    end("report", message)


def main(words: list[str]) -> None:
    arguments = parse_arguments(words)
    require("reports need", NEEDS)
    import percuss
    from percuss.files import check_target, write_file
    from percuss.plot.panels import BadChoice
    from percuss.report.page import make_page
    from percuss.results.converted import convert_run
    from percuss.terminal import print_text

    try:
        runs = [percuss.Run(folder, arguments.fields) for folder in arguments.dirs]
        for run in runs if arguments.fields else ():
            _ = run.fields  # refuses a name that is not there
        runs = [convert_run(run, arguments.units) for run in runs]
        name = "report.html" if len(runs) == 1 else "comparison.html"
        path = arguments.out or os.path.join(runs[0].folder, name)
        check_target(path, "report", arguments.force)
        write_file(path, make_page(runs, arguments), "report", arguments.force)
    except (percuss.NotResults, BadChoice, ValueError) as error:
        fail(error)
    except OSError as error:
        fail(f"cannot write the report ({error})")
    print_text(f"report: {path} ({os.path.getsize(path) / 1e6:.2g} MB)")
