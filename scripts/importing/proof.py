"""`percuss check` on what was written."""

import os
import shutil
import subprocess

from libraries import SCRIPTS


def find_program() -> str | None:
    """The program that called this script, or the one of this checkout or installation, or of PATH."""
    root = os.path.dirname(SCRIPTS)
    places = [
        os.environ.get("PERCUSS_PROGRAM", ""),
        os.path.join(root, "build/release/percuss"),
        os.path.join(root, "../../bin/percuss"),
    ]
    return next((place for place in places if place and os.access(place, os.X_OK)), shutil.which("percuss"))


def check_deck(deck: str) -> int | None:
    """Runs the check, whose output goes to the terminal. Its exit code, None where there is no program."""
    program = find_program()
    if program is None:
        return None
    return subprocess.run([program, "check", deck], check=False).returncode
