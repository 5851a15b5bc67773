"""What a test of this folder is given: NAME_test.py ROOT PERCUSS [WORD...], as ctest calls it. By pytest, which gives it nothing, this
checkout and PERCUSS_PROGRAM or build/release/percuss."""

import importlib
import os
import shutil
import sys
import unittest
from pathlib import Path

IS_PYTEST = "pytest" in sys.modules


def read_words() -> tuple[str, str, list[str]]:
    """(checkout, program, further words): these are taken from sys.argv, where unittest would look for names of tests."""
    if IS_PYTEST:
        root = str(Path(__file__).resolve().parents[2])
        return root, os.environ.get("PERCUSS_PROGRAM") or os.path.join(root, "build/release/percuss"), []
    root, percuss, *words = sys.argv[1:]
    del sys.argv[1:]
    return os.path.abspath(root), os.path.abspath(percuss), words


def skip(reason: str) -> None:
    """Ends the test: with exit code 77, as ctest expects, or as pytest does."""
    if IS_PYTEST:
        raise unittest.SkipTest(reason)
    print(f"skipped: {reason}")
    sys.exit(77)


def require(*modules: str) -> None:
    """Skips the test where one of these modules cannot be imported."""
    for module in modules:
        try:
            importlib.import_module(module)
        except ImportError as error:
            skip(f"{error}; scripts/install_dependencies --report installs what this test needs")


ROOT, PERCUSS, WORDS = read_words()
MPIEXEC = WORDS or [shutil.which("mpiexec") or "mpiexec", "--oversubscribe", "-n"]  # the number of ranks follows
