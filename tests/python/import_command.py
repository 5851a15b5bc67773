"""`percuss import` in the process of a test: an interpreter of its own takes ten times as long as the import of a small deck."""

import contextlib
import io
import os
import sys
import traceback
from importlib.machinery import SourceFileLoader
from importlib.util import module_from_spec, spec_from_loader
from subprocess import CompletedProcess
from unittest.mock import patch


def load_command(root):
    """The script of the command as a module."""
    spec = spec_from_loader("percuss_import", SourceFileLoader("percuss_import", os.path.join(root, "scripts/import")))
    module = module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def call_command(command, words, folder):
    """Runs the command with the words in a folder. The check that it calls needs PERCUSS_PROGRAM in the environment."""
    output, errors, before = io.StringIO(), io.StringIO(), os.getcwd()
    os.chdir(folder)
    try:
        with patch.object(sys, "argv", ["import", *words]), contextlib.redirect_stdout(output), contextlib.redirect_stderr(errors):
            code = command.main()
    except SystemExit as end:  # of a wrong option
        code = end.code
    except Exception:  # noqa: BLE001  (any is a fault of the import, and ends it so)
        code = 1
        errors.write(traceback.format_exc())
    finally:
        os.chdir(before)
    return CompletedProcess(words, code, output.getvalue(), errors.getvalue())
