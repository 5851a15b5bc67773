"""The tools of percuss: what `python3 -m percuss NAME`, and so `percuss NAME` of the executable, starts.

A tool is a module with main(words), which returns an exit code or None. NEEDS are the libraries without which it ends,
WISHES those without which a part of its work is left out.
A module loads none of them before it has read its words: --help needs Python alone."""

import importlib
import importlib.util
import sys
from types import ModuleType

TOOLS = {
    "import": "percuss.importing.tool",
    "plot": "percuss.plot.tool",
    "report": "percuss.report.tool",
    "watch": "percuss.watch.tool",
    "stop": "percuss.stop",
    "render": "percuss.render.tool",
    "view": "percuss.view.tool",
    "export": "percuss.export.tool",
    "sweep": "percuss.sweep.tool",
    "build-law": "percuss.build_law",
    "preview": "percuss.preview.tool",  # percuss check --report
    "tables": "percuss.tables",  # percuss info --energies, --forces
}


def load_tool(name: str) -> ModuleType:
    return importlib.import_module(TOOLS[name])


def count_missing(name: str) -> int:
    """How many libraries this interpreter lacks of those that a tool can use.
    One that it needs counts as 16 of the others."""
    tool = load_tool(name)
    needs, wishes = getattr(tool, "NEEDS", ()), getattr(tool, "WISHES", ())
    return 16 * sum(not is_there(library) for library in needs) + sum(not is_there(library) for library in wishes)


def start_tool(name: str) -> list[str]:
    """The words that start a tool as a program of its own, in this interpreter."""
    return [sys.executable, "-m", "percuss", name]


def is_there(library: str) -> bool:
    """Whether a library can be found, which is faster than to load it."""
    try:
        return importlib.util.find_spec(library) is not None
    except ImportError:
        return False
