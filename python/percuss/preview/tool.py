"""Writes one page about a percuss scene before it runs. percuss check --report --help says how."""

import argparse
import os
import signal
import sys
import tempfile
from typing import NoReturn

from percuss.help_format import HelpFormatter
from percuss.libraries import require

NEEDS = ("numpy", "h5py", "matplotlib")
WISHES = ("vtkmodules.vtkRenderingOpenGL2", "PIL.Image")
EPILOG = """\
percuss check DECK --report is this program. It calls percuss check and runs a
few steps in a temporary folder, which take some seconds. The page shows the
bodies by part, with sets, conditions, walls, initial velocities as arrows, and
overlaps and gaps in red. It lists mass, extent, step by part, predicted steps,
run time, memory and disk, and all warnings of percuss check.

Examples:
  percuss check --report deck.yaml      writes SCENE_check.html here
  percuss check deck.yaml --report --out before.html \\
                --set 'parts.rod.cylinder.cells=[16, 64]'

Exit codes:
  0    done
  2    the deck, a mesh or the command is wrong (a page is written only for
       overlap that the deck refuses)
  4    the system failed

Needs what percuss report needs: scripts/install_dependencies --report.
docs/results.md describes the page.
"""


def parse_arguments(words: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="percuss check --report", epilog=EPILOG, formatter_class=HelpFormatter,
        description="Write a page about a scene before it runs.")
    add = parser.add_argument
    add("deck", metavar="DECK", help="the deck (YAML)")
    add("--report", action="store_true", help="write the page (what this program does)")
    add("-o", "--out", metavar="FILE", help="the page (default: SCENE_check.html)")
    add("-f", "--force", action="store_true",
        help="write over a file that percuss check has not written; never over results of a run")
    add("-s", "--set", metavar="KEY=VALUE", action="append", default=[],
        help="change a value of the deck; may be repeated")
    add("--allow-external", action="store_true", help="let HDF5 files (meshes) take data from other files")
    add("--allow-library", metavar="FILE", action="append", default=[],
        help="load this library with a law of yours; may be repeated")
    add("--no-pictures", dest="pictures", action="store_false", help="leave the pictures out (they need VTK)")
    add("--no-view", dest="interactive", action="store_false",
        help="leave the interactive view out (it takes about 1 MB)")
    return parser.parse_args(words)


def fail(message: object, code: int = 2) -> NoReturn:
    from percuss.terminal import print_text

    print_text(message, sys.stderr)
    sys.exit(code)


def name_page(deck: str) -> str:
    """SCENE_check.html: the deck's name, or the name of its folder if it is called deck.yaml,
    as of the results of a run."""
    name = os.path.splitext(os.path.basename(deck))[0]
    if name == "deck":
        name = os.path.basename(os.path.dirname(os.path.abspath(deck))) or name
    return f"{name}_check.html"


def main(words: list[str]) -> None:
    arguments = parse_arguments(words)
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(130))  # so that the temporary folder goes
    require("the page needs", NEEDS)
    from percuss import NotResults
    from percuss.files import check_target, write_file
    from percuss.preview.page import Preview
    from percuss.preview.trial import Refused, Trial
    from percuss.program import find_program
    from percuss.terminal import print_text

    options = [word for setting in arguments.set for word in ("--set", setting)]
    options += ["--allow-external"] * arguments.allow_external
    options += [word for library in arguments.allow_library for word in ("--allow-library", library)]
    path = arguments.out or name_page(arguments.deck)
    try:
        check_target(path, "check", arguments.force)
        with tempfile.TemporaryDirectory(prefix="percuss_check_") as folder:
            trial = Trial(find_program(), arguments.deck, options, folder)
            text = Preview(trial, arguments).make_page()
        write_file(path, text, "check", arguments.force)
    except NotResults as error:
        fail(f"percuss check --report: error: {error}")
    except Refused as error:
        fail(error.text, error.code)
    except KeyboardInterrupt:
        fail("percuss check --report: interrupted", 130)
    except OSError as error:
        fail(f"percuss check --report: error: the page cannot be written ({error})", 4)
    print_text(f"check: {path} ({os.path.getsize(path) / 1e6:.2g} MB)")
    if trial.error:
        fail(trial.error)
