"""Where the executable of percuss is, for tools that call it."""

import os
import shutil

from .errors import NotResults


def find_program() -> str:
    """The one that has started this tool, of this checkout, of this installation, or in PATH."""
    root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
    for path in (os.environ.get("PERCUSS_PROGRAM"), os.path.join(root, "build/release/percuss"),
                 os.path.join(os.path.dirname(os.path.dirname(root)), "bin/percuss"), shutil.which("percuss")):
        if path and os.access(path, os.X_OK):
            return path
    raise NotResults("there is no percuss: build it "
                     "(scripts/build), or name it in the environment variable PERCUSS_PROGRAM")
