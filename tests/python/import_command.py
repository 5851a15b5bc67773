"""`percuss import` in the process of a test: an interpreter of its own takes ten times as long as the import of a small deck."""

import contextlib
import io
import os
import traceback
from subprocess import CompletedProcess

from percuss.importing import tool


def call_command(words, folder):
    """Runs the command with the words in a folder. The check that it calls needs PERCUSS_PROGRAM in the environment."""
    output, errors, before = io.StringIO(), io.StringIO(), os.getcwd()
    os.chdir(folder)
    try:
        with contextlib.redirect_stdout(output), contextlib.redirect_stderr(errors):
            code = tool.main(words)
    except SystemExit as end:  # of a wrong option
        code = end.code
    except Exception:  # noqa: BLE001  (any is a fault of the import, and ends it so)
        code = 1
        errors.write(traceback.format_exc())
    finally:
        os.chdir(before)
    return CompletedProcess(words, code, output.getvalue(), errors.getvalue())
