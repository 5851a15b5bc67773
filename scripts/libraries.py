"""Python libraries of the scripts beside this file: where they are found, and what to do where they are missing."""

import importlib
import os
import signal
import sys

SCRIPTS = os.path.dirname(os.path.realpath(__file__))
SYSTEM_PYTHON = "/usr/bin/python3"  # Debian's packages belong to this one, whatever python3 is first in PATH
REEXECUTED = "PERCUSS_RENDER_REEXECUTED"


def describe_install(option, packages):
    """What to do where a library is missing: an installation of percuss has no script for it."""
    script = os.path.join(SCRIPTS, "install_dependencies")
    return f"run scripts/install_dependencies {option}".rstrip() if os.path.exists(script) else f"install {packages} (names of Debian)"


def end_with_reader():
    """Ends silently, as programs of the shell do, where what reads the output has ended: percuss plot DIR --list | head."""
    if hasattr(signal, "SIGPIPE"):
        signal.signal(signal.SIGPIPE, signal.SIG_DFL)


def find_readers():
    """Makes `import percuss` and the packages of this folder find what lies in this checkout."""
    sys.dont_write_bytecode = True
    for folder in (SCRIPTS, os.path.join(os.path.dirname(SCRIPTS), "python")):
        if folder not in sys.path:
            sys.path.insert(0, folder)


def fail(tool, message, code=2):
    """Ends the program with an error of the tool."""
    find_readers()
    from percuss import terminal

    terminal.fail(tool, message, code)


def find_libraries(modules):
    """Continues in the system's Python if this one lacks one of the modules. An ImportError where that one does, too."""
    try:
        for module in modules:
            importlib.import_module(module)
    except ImportError:
        if os.access(SYSTEM_PYTHON, os.X_OK) and os.environ.get(REEXECUTED) != "python":
            os.environ[REEXECUTED] = "python"
            os.execv(SYSTEM_PYTHON, [SYSTEM_PYTHON, *sys.argv])
        raise
