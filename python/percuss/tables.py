"""Prints tables of energies and forces of a percuss run. percuss info --help says how."""

import argparse
import os
from typing import NoReturn

from percuss.help_format import HelpFormatter
from percuss.libraries import require
from percuss.terminal import fail as end

NEEDS = ("numpy", "h5py")
EPILOG = """\
percuss info DIR --energies and --forces are this program. They read
history.csv:
  --energies   of the scene, then of each part or block that the history has:
               first, last, smallest and largest value, with their times
  --forces     of contact, walls, supports, sections, joints, springs and welds:
               largest resultant and its time, impulse, mean, last value

Examples:
  percuss info ball --energies
  percuss info ball --energies --forces --units 'mm, kg, ms'

Exit codes:
  0    done
  2    a folder or an option is wrong, or a library is missing

Needs Python 3 with NumPy and h5py. docs/results.md describes the tables.
"""


def parse_arguments(words: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="percuss info", epilog=EPILOG, formatter_class=HelpFormatter,
        description="Print tables of the history of a run.")
    add = parser.add_argument
    add("dir", metavar="DIR", help="the output folder of a run, complete or under way")
    add("--energies", action="store_true", help="energies of the scene, of parts and of blocks")
    add("--forces", action="store_true", help="peaks and impulses of forces")
    add("--units", metavar="SYSTEM",
        help="convert to a system of units, such as 'mm, kg, ms' (default: that of the deck)")
    return parser.parse_args(words)


def fail(message: object) -> NoReturn:
    end("info", message)


def main(words: list[str]) -> None:
    arguments = parse_arguments(words)
    require("tables need", NEEDS)
    from percuss import NotResults, Run
    from percuss.report.tables import list_energies, list_forces_in_rows, write_table
    from percuss.results.units import Units
    from percuss.terminal import print_text

    try:
        run = Run(arguments.dir)
        history = run.history.in_units(Units(arguments.units)) if arguments.units else run.history
        if not len(history):
            fail(f"{os.path.join(run.folder, 'history.csv')}: there is no row in it yet")
        for wanted, title, make in ((arguments.energies, "energies", list_energies),
                                    (arguments.forces, "forces", list_forces_in_rows)):
            if wanted:
                heading, rows = make(run, history)
                unit = history.unit("time")
                print_text(f"{run.folder}: {title}, "
                           f"{len(history)} rows to t = {history['time'][-1]:.6g}{f' {unit}' if unit else ''}")
                print_text(write_table(heading, rows) if rows
                           else f"  the history has no {title} (output.history of the deck)")
    except (NotResults, ValueError) as error:
        fail(error)
