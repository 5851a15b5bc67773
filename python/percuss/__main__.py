"""python3 -m percuss NAME ...: a tool of percuss. The executable starts its tools so."""

import signal
import sys

from .libraries import MissingLibrary
from .terminal import fail
from .tools import TOOLS, count_missing, load_tool

USAGE = f"""\
Usage: python3 -m percuss TOOL ...   (python3 -m percuss TOOL --help says more)
Tools:
{' '.join(TOOLS)}"""


def main(words: list[str]) -> int | None:
    """--lacks TOOL: how many libraries of a tool this interpreter lacks, as exit code;
    the executable chooses an interpreter by it."""
    if hasattr(signal, "SIGPIPE"):
        # ends silently, as programs of the shell do: percuss plot DIR --list | head
        signal.signal(signal.SIGPIPE, signal.SIG_DFL)
    if len(words) == 2 and words[0] == "--lacks" and words[1] in TOOLS:
        return count_missing(words[1])
    if not words or words[0] not in TOOLS:
        asks = words[:1] in (["--help"], ["-h"])
        print(USAGE, file=sys.stdout if asks else sys.stderr)
        return 0 if asks else 2
    try:
        code: int | None = load_tool(words[0]).main(words[1:])
        return code
    except MissingLibrary as error:
        names = {"import": "percuss import", "preview": "percuss check --report", "tables": "info"}
        fail(names.get(words[0], words[0]), error)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
