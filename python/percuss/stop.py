"""Asks an active percuss run to stop, or for a frame or checkpoint. percuss stop --help says how."""

import argparse
import os
import time
from collections.abc import Callable
from typing import NoReturn

from percuss.files import FRAME_ENDINGS
from percuss.help_format import HelpFormatter
from percuss.terminal import fail as end

EPILOG = """\
The run ends after its current step. It first writes its results and a
checkpoint, with which percuss run DECK --restart DIR continues it. The request
is a file, DIR/stop, DIR/frame or DIR/checkpoint. The run takes it within a
quarter of a second, or after its current step if that takes longer. A request
during the start of a run takes effect after its first step. It works from any
machine that has the folder.

A frame is written only if the deck has output.fields, a row only if it has
output.history and no sensors: sensors are evaluated at rows, and a requested
frame must not change the run.

Examples:
  percuss stop wall                 end the run with a checkpoint
  percuss stop wall --frame         write a frame and a row now; continue
  percuss stop wall --checkpoint    write a checkpoint now; continue

Exit codes:
  0    the run has taken the request (or was asked, with --no-wait)
  2    there is no active run in DIR
  4    the request could not be written, or was not taken in time

Needs Python 3 alone. docs/results.md describes requests.
"""


def parse_arguments(words: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="percuss stop", epilog=EPILOG, formatter_class=HelpFormatter,
        description="Stop an active run with a checkpoint, or request a frame or a checkpoint.")
    add = parser.add_argument
    add("dir", metavar="DIR", help="the output folder of the run")
    add("--frame", action="store_true",
        help="do not stop: write a frame of fields and a row of the history (with sensors: no row)")
    add("--checkpoint", action="store_true", help="do not stop: write a checkpoint")
    add("--no-wait", action="store_true", help="do not wait until the run has taken the request")
    add("--timeout", metavar="SECONDS", type=float, default=60.0, help="how long to wait for this (default: 60)")
    return parser.parse_args(words)


def ask(folder: str, name: str) -> str:
    """Makes the file of a request; its path."""
    path = os.path.join(folder, name)
    try:
        with open(path, "a", encoding="ascii"):
            os.utime(path)  # a file that is older than the run is no request to it
            return path
    except OSError as error:
        fail(f"cannot write {path} ({error.strerror})", 4)


def wait(folder: str, path: str, seconds: float, is_active: Callable[[str], bool]) -> bool:
    """Whether the run takes the request; fails if it ends before."""
    end = time.monotonic() + seconds
    while os.path.exists(path):
        if not is_active(folder):
            os.unlink(path)
            fail(f"the run in {folder} ended before it took the request")
        if time.monotonic() >= end:
            return False
        time.sleep(0.1)
    return True


def is_fields_file(name: str) -> bool:
    """Whether a run writes frames into a file of this name: fields.vtkhdf, fields_NAME.exo."""
    stem, ending = os.path.splitext(name)
    return ending in FRAME_ENDINGS and (stem == "fields" or stem.startswith("fields_"))


def describe_frame(folder: str) -> str:
    """What a run writes that is asked for a frame, by the files that it has."""
    def has(name: str) -> bool:
        return os.path.exists(os.path.join(folder, name))

    if any(is_fields_file(name) for name in os.listdir(folder)):
        return "a frame"
    why = "(the deck has no output.fields)"
    from percuss.results.columns import has_sensors

    return (f"a row of the history without a frame {why}" if has("history.csv") and not has_sensors(folder)
            else f"no frame {why}")


def fail(message: object, code: int = 2) -> NoReturn:
    end("stop", message, code)


def main(words: list[str]) -> None:
    arguments = parse_arguments(words)
    from percuss.results.lock import is_active

    folder = arguments.dir
    if not os.path.isdir(folder):
        fail(f"there is no folder {folder} (the output folder of a run is needed)")
    if not is_active(folder):
        fail(f"there is no active run in {folder} (percuss info {folder} describes what is there)")
    names = [name for name in ("frame", "checkpoint") if getattr(arguments, name)] or ["stop"]
    paths = [ask(folder, name) for name in names]
    try:
        if not arguments.no_wait and not all(wait(folder, path, arguments.timeout, is_active) for path in paths):
            fail(f"the run in {folder} has not taken the request within {arguments.timeout:g} s; it stays there", 4)
    except KeyboardInterrupt:
        print(f"stop: {' and '.join(paths)} stay there for the run")
        return
    if not arguments.no_wait:
        what = {"frame": describe_frame(folder), "checkpoint": "a checkpoint"}
        print(f"stop: the run in {folder} "
              f"{'stops' if names == ['stop'] else 'writes ' + ' and '.join(what[name] for name in names)}")
