"""Shows a percuss run in the terminal until it ends. percuss watch --help says how."""

from __future__ import annotations

import argparse
import os
import shutil
import sys
import time
from typing import TYPE_CHECKING

from percuss.help_format import HelpFormatter
from percuss.terminal import fail

if TYPE_CHECKING:
    from percuss.results.run import Run

EXIT_CODES = {"completed": 0, "failed": 3, "killed": 4, "interrupted": 130}
LINES_EVERY = 10.0  # seconds between lines where the output is no terminal

EPILOG = """\
Shows the progress, and energies, their error, the time step and contacts as
sparklines from the start to now; warnings once the run has ended. It may start
and stop at any time, in another terminal, over ssh, or on another machine that
has the folder. Where the output is no terminal it writes a line every ten
seconds, and the view at the end.

It reads these files of DIR, and never the deck's own file:
  history.csv     the values
  summary.json    status, end time, warnings, and the deck as it was run
  columns.json    units
  run.lock        whether the run is active
  checkpoint.h5, fields.vtkhdf    the deck, title and units, where the files
                  above do not have them

Examples:
  percuss watch wall                          until the run ends
  percuss watch wall --once                   the state now
  ssh cluster percuss watch scratch/wall
  percuss watch wall && percuss report wall   a report when it is complete

Exit codes:
  0    the run is completed; also after --once or Ctrl-C
  2    the folder or an option is wrong
  3    the run failed
  4    the run was killed
  130  the run was interrupted

Needs Python 3 alone. docs/results.md describes the view.
"""


def parse_arguments(words: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="percuss watch", epilog=EPILOG, formatter_class=HelpFormatter,
        description="Follow a run in the terminal until it ends.")
    add = parser.add_argument
    add("dir", metavar="DIR", help="the output folder of a run, under way or complete")
    add("--once", action="store_true", help="show the state once and end")
    add("--interval", metavar="SECONDS", type=float, default=1.0, help="seconds between updates (default: 1)")
    add("--plain", action="store_true", help="letters only: no signs beyond ASCII")
    return parser.parse_args(words)


def is_plain(arguments: argparse.Namespace) -> bool:
    return arguments.plain or "utf" not in (sys.stdout.encoding or "").lower()


class Watch:
    """Looks at the run and writes what it sees."""

    def __init__(self, run: Run, arguments: argparse.Namespace) -> None:
        from percuss.watch.rows import Rows

        self.run, self.arguments = run, arguments
        self.rows = Rows(os.path.join(run.folder, "history.csv"))
        self.live = sys.stdout.isatty() and not arguments.once
        self.height = 0
        self.end: float | None = None
        self.first: tuple[float, float] | None = None  # clock and simulated time of the first update that found a row
        self.last_line = 0.0

    def update(self) -> str:
        """The status now; reads the files again."""
        self.run.reload()
        status = self.run.status  # before the rows: none can be missed after the end
        self.rows.read()
        if self.end is None:
            self.end = self.run.summary.get("end_time")
        if self.first is None and (now := self.rows.last("time")) is not None:
            self.first = time.monotonic(), now
        return status

    def estimate_left(self) -> float | None:
        """Seconds to the end at the speed since the first look."""
        now = self.rows.last("time")
        if self.first is None or not self.end or now is None:
            return None
        clock, done = time.monotonic() - self.first[0], now - self.first[1]
        return clock * max(0.0, self.end - now) / done if clock > 2 and done > 0 else None

    def show(self, is_last: bool) -> None:
        from percuss.terminal import print_text
        from percuss.watch.screen import make_line, make_screen

        if self.live or is_last:
            width = shutil.get_terminal_size((100, 24)).columns
            lines = make_screen(self.run, self.rows, self.end, self.estimate_left(), (width, is_plain(self.arguments)))
            up = f"\x1b[{self.height}A\x1b[J" if self.live and self.height else ""
            print(up + "\n".join(lines), flush=True)
            self.height = len(lines)
        elif time.monotonic() - self.last_line >= LINES_EVERY:
            print_text(make_line(self.run, self.rows, self.end, self.estimate_left()), flush=True)
            self.last_line = time.monotonic()


def main(words: list[str]) -> None:
    arguments = parse_arguments(words)
    import percuss

    try:
        watch = Watch(percuss.Run(arguments.dir), arguments)
        while True:
            status = watch.update()
            ended = status in EXIT_CODES
            watch.show(ended or arguments.once)
            if ended or arguments.once:
                sys.exit(0 if arguments.once else EXIT_CODES[status])
            time.sleep(max(0.05, arguments.interval))
    except KeyboardInterrupt:
        print()
    except (percuss.NotResults, OSError) as error:
        fail("watch", error)
