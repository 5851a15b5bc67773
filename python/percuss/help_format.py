"""How --help of all tools looks: as that of the program's own commands, within 80 columns."""

import argparse
import shutil
from typing import Any

WIDTH = 80
HEADINGS = {"positional arguments": "Positionals", "options": "Options", "optional arguments": "Options"}


class HelpFormatter(argparse.RawDescriptionHelpFormatter):
    def __init__(self, prog: str) -> None:
        super().__init__(prog, width=min(WIDTH, shutil.get_terminal_size().columns))

    def add_usage(self, usage: str | None, actions: Any, groups: Any, prefix: str | None = None) -> None:
        super().add_usage(usage, actions, groups, prefix or "Usage: ")

    def start_section(self, heading: str | None) -> None:
        super().start_section(HEADINGS.get(heading or "", heading))

    def _get_help_string(self, action: argparse.Action) -> str | None:
        if action.dest == "help":
            return "Print this help"
        return action.help and action.help[0].upper() + action.help[1:]
