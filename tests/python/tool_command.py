"""`python3 -m percuss NAME ...` in a fork of a test, which has loaded the libraries already: an interpreter of its own takes a second for them."""

import contextlib
import importlib
import os
import pkgutil
import sys
import tempfile
import traceback
from subprocess import CompletedProcess

import percuss
from percuss.__main__ import main


def load_libraries():
    """All modules of percuss, with what they import; a tool says itself which library it misses."""
    for module in pkgutil.walk_packages(percuss.__path__, "percuss."):
        with contextlib.suppress(ImportError):
            importlib.import_module(module.name)


def call_tool(*words, folder=None, **environment):
    """Runs a tool in a folder, with these variables in its environment."""
    with tempfile.TemporaryFile() as output, tempfile.TemporaryFile() as errors:
        sys.stdout.flush()
        sys.stderr.flush()
        child = os.fork()
        if child == 0:
            run_in_child(words, output.fileno(), errors.fileno(), folder, environment)
        code = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
        texts = []
        for file in (output, errors):
            file.seek(0)
            texts.append(file.read().decode(errors="replace"))
        return CompletedProcess(words, code, *texts)


def run_in_child(words, output, errors, folder, environment):
    """Never returns: the test goes on in its parent."""
    code = 1
    try:
        os.dup2(output, 1)
        os.dup2(errors, 2)
        sys.stdout, sys.stderr = (open(number, "w", encoding="utf-8", closefd=False) for number in (1, 2))  # pytest has others
        sys.argv = ["percuss", *words]
        os.environ.update(environment)
        os.chdir(folder or ".")
        code = main(list(words))
    except SystemExit as end:  # of a tool that says what is wrong
        code = end.code
    except BaseException:  # noqa: BLE001  (any is a fault of the tool, and ends it so)
        traceback.print_exc()
    finally:
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(code or 0)


load_libraries()
