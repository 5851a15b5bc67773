"""Runs designs of a deck and shows how results depend on them. percuss sweep --help says how."""

from __future__ import annotations

import argparse
import os
import signal
import subprocess
import sys
from typing import TYPE_CHECKING, Any, NoReturn

from percuss.help_format import HelpFormatter
from percuss.libraries import require
from percuss.terminal import fail as end
from percuss.tools import start_tool

if TYPE_CHECKING:
    from percuss.sweep.designs import Design
    from percuss.sweep.outputs import Output
    from percuss.sweep.study import Result

NEEDS = ("numpy", "h5py", "matplotlib")
WISHES = ("scipy",)  # of --sample
EPILOG = """\
Each --vary names a key of the deck, as --set does, and its values:
  parts.wall.thickness=1e-3,2e-3            these values
  materials.steel.yield_stress=2e8..6e8:5   five values at equal distances;
                                            :log for equal ratios, :int for
                                            whole numbers
  initial.0.velocity.2=-80..-40             a range, for --sample
  parts.a.thickness,parts.b.thickness=1,2   both together
Without --sample every combination is run. --designs reads them from a CSV file:
keys in its heading, a design in each line.

Each --output is a column of history.csv or an expression of columns, as percuss
plot has them, with a label or not. What is one number (max, min, mean, first,
last) gives one column; else there are LABEL.peak, LABEL.mean and LABEL.last.
By default: the largest resultant of each force, and the energies at the end.

A finished design is not run again: it is known by the values of its deck and by
the files that the deck names. An interrupt stops the runs with checkpoints; the
same command continues. A design that is refused or fails is a row of the table.

Examples:
  percuss sweep tube.yaml --vary parts.tube.thickness=1e-3,2e-3,3e-3 \\
                          --output 'crush = mean(fz:crush)'
  percuss sweep tube.yaml --vary a.b=5..9 --vary c=1..2 --sample lhs:40
  percuss sweep tube.yaml --designs designs.csv --out study
  percuss sweep tube.yaml --vary a.b=5..9:20 --threads 8 --job-array > sweep.sh

Exit codes:
  0    the table is written
  2    an option, the deck or an expression is wrong, or a library is missing
  3    no design has completed
  130  interrupted

Needs Python 3 with NumPy, h5py and Matplotlib, --sample SciPy too:
scripts/install_dependencies --report installs them.
docs/sweep.md describes sweeps.
"""


def parse_arguments(words: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="percuss sweep", epilog=EPILOG, formatter_class=HelpFormatter,
        description="Run a deck with many values, and compare the results in a table and a page.")
    add = parser.add_argument
    add("deck", metavar="DECK", help="the deck")
    add("--vary", metavar="KEY=VALUES", action="append", default=[], help="a key and its values; may be repeated")
    add("--sample", metavar="KIND:N", help="N designs by a Latin hypercube (lhs:N) or by Sobol's sequence (sobol:N)")
    add("--seed", metavar="NUMBER", type=int, default=0, help="another sample of the same kind (default: 0)")
    add("--designs", metavar="FILE", help="designs of a CSV file, in place of --vary")
    add("-s", "--set", metavar="KEY=VALUE", action="append", default=[],
        help="a value for all designs; may be repeated")
    add("--allow-library", metavar="FILE", action="append", default=[],
        help="load this library with a law of yours; may be repeated")
    add("--output", metavar="EXPRESSION", action="append", default=[],
        help="a column of the table: a column of the history, or an expression; may be repeated")
    add("--out", metavar="DIR", help="folder of runs, table and page (default: NAME_sweep in the current folder)")
    add("-j", "--jobs", metavar="N", type=parse_count, default=0,
        help="runs at once (default: as cores and memory allow)")
    add("--threads", metavar="N", type=parse_count, default=0,
        help="threads of each run (default: the share of its cores)")
    add("--only", metavar="N", type=parse_count, help="run only design N, and write no table (a task of a job array)")
    add("--job-array", action="store_true", help="run nothing: print a job array of Slurm, a task for each design")
    add("--list", action="store_true", help="run nothing: list the designs")
    add("--reports", action="store_true", help="write report.html of each completed run, which the page links to")
    add("--retry", action="store_true", help="run designs again that have failed")
    add("-f", "--force", action="store_true", help="write over a table or page that percuss sweep has not written")
    return parser.parse_args(words, argparse.Namespace(words=words))


def parse_count(text: str) -> int:
    if not text.isdigit() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"'{text}' is no number from 1 up")
    return int(text)


def fail(message: object, code: int = 2) -> NoReturn:
    end("sweep", message, code)


def choose_designs(arguments: argparse.Namespace) -> list[Design]:
    from percuss.sweep import designs

    if arguments.designs:
        if arguments.vary or arguments.sample:
            raise designs.BadDesign("--designs stands alone: it has the values of --vary and --sample")
        return designs.read_designs(arguments.designs)
    if not arguments.vary:
        raise designs.BadDesign("nothing varies: give --vary KEY=VALUES, or --designs FILE")
    factors = [designs.parse_factor(text) for text in arguments.vary]
    if not arguments.sample:
        return designs.cross(factors)
    return designs.sample(factors, arguments.sample, arguments.seed)


class Teller:
    """Tells of each design that has ended, with its warnings.
    Stops before the first run where outputs cannot be computed of its history."""

    def __init__(self, count: int, outputs: list[Output]) -> None:
        self.count, self.outputs, self.ended = count, outputs, 0

    def judge(self, scene: dict[str, Any]) -> None:
        from percuss.sweep.outputs import judge_outputs
        from percuss.terminal import print_text

        judge_outputs(self.outputs, scene)
        for output in self.outputs:
            if output.note:
                print_text(f"sweep: {output.note}", sys.stderr)

    def follow(self, result: Result) -> None:
        from percuss.sweep.table import name_rules
        from percuss.terminal import print_text

        self.ended += 1
        words = f"{result.state} before" if result.was_there else result.state
        notes = ([result.error] * bool(result.error)
                 + [f"warnings: {name_rules(result.warnings)}"] * bool(result.warnings))
        print_text(f"sweep: {self.ended}/{self.count} {words}: {result.design}"
                   + (f" ({'; '.join(notes)})" if notes else ""), flush=True)


def write_results(arguments: argparse.Namespace, folder: str, results: list[Result], outputs: list[Output]) -> None:
    from percuss.files import write_file
    from percuss.sweep.page import make_page
    from percuss.sweep.table import Table
    from percuss.terminal import print_text

    if arguments.reports:
        for result in results:
            if result.state == "completed":
                write_report(result.folder)
    table = Table(results, outputs, folder)
    links = {row.number: f"{row.folder}/report.html" for row in table.rows if row.folder and
             os.path.exists(os.path.join(folder, row.folder, "report.html"))}
    csv, page = (os.path.join(folder, name) for name in ("sweep.csv", "sweep.html"))
    write_file(csv, table.write_csv(), "sweep", arguments.force)
    write_file(page, make_page(os.path.basename(arguments.deck), table, links), "sweep", arguments.force)
    for rule, numbers, text in table.list_warned():
        print_text(f"sweep: {len(numbers)} of {len(table.rows)} designs warn of {rule} (design {numbers[0]}: {text})")
    print_text(f"sweep: {csv}, {page}")
    if not any(row.state == "completed" for row in table.rows):
        fail("no design has completed", 3)


def write_report(folder: str) -> None:
    """A report that is newer than the run stays."""
    report, summary = (os.path.join(folder, name) for name in ("report.html", "summary.json"))
    if os.path.exists(report) and os.path.getmtime(report) >= os.path.getmtime(summary):
        return
    done = subprocess.run([*start_tool("report"), folder], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        from percuss.terminal import print_text

        print_text(f"sweep: no report of {folder}: {done.stderr.strip()[-300:]}", sys.stderr)


def sweep(arguments: argparse.Namespace) -> None:
    from percuss.sweep.cluster import write_job_array
    from percuss.sweep.outputs import Output
    from percuss.sweep.study import Study
    from percuss.terminal import print_text

    designs, outputs = choose_designs(arguments), [Output(text) for text in arguments.output]
    path, _ = os.path.splitext(os.path.abspath(arguments.deck))
    name = os.path.basename(os.path.dirname(path) if os.path.basename(path) == "deck" else path)
    folder = arguments.out or f"{name}_sweep"
    if arguments.list:
        for design in designs:
            print_text(f"{design.number}: {design}")
        return
    if arguments.job_array:
        words = [word for word in arguments.words if word != "--job-array"]
        print(write_job_array(["percuss", "sweep", *words], len(designs), arguments.jobs, arguments.threads or 1),
              end="")
        return
    if arguments.only:
        if arguments.only > len(designs):
            fail(f"there is no design {arguments.only} (there are {len(designs)})")
        designs = [designs[arguments.only - 1]]
    teller = Teller(len(designs), outputs)
    study = Study(arguments.deck, folder, arguments.set, arguments.jobs, arguments.threads, arguments.retry,
                  teller.follow, arguments.allow_library, teller.judge)
    print_text(f"sweep: {len(designs)} design{'s' * (len(designs) > 1)} of {arguments.deck} into {folder}", flush=True)
    results = study.run(designs)
    if all(result.state == "refused" for result in results):
        fail(f"every design is refused: {results[0].error}")
    if arguments.only:
        if results[0].state != "completed":
            fail(f"design {arguments.only} is {results[0].state} ({results[0].error})", 3)
        return
    write_results(arguments, folder, results, outputs)


def main(words: list[str]) -> None:
    arguments = parse_arguments(words)
    require("sweeps need", (*NEEDS, *(WISHES if arguments.sample else ())))
    from percuss import NotResults

    # SIGINT may be ignored, as shells have it for what runs behind &
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        sweep(arguments)
    except (NotResults, ValueError) as error:
        fail(error)
    except KeyboardInterrupt:
        fail("interrupted: the same command goes on from here", 130)
    except OSError as error:
        fail(f"cannot write the results ({error})", 4)
