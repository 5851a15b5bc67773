"""`percuss check` on what was written; what it refuses becomes a refusal of the card that has made it."""

import os
import re
import subprocess
from typing import Any, NamedTuple

import yaml

from percuss.errors import NotResults
from percuss.program import find_program

from .ledger import Ledger, Place, Status
from .model import Model

ERROR = re.compile(r"^(?:(?P<file>[^\n]*?):(?:(?P<line>\d+):(?:(?P<column>\d+):)?)? )?error: (?P<text>.*)$",
                   re.MULTILINE)


class Verdict(NamedTuple):
    """How the check ended; its exit code is None where there is no program."""

    code: int | None
    output: str = ""
    errors: str = ""


def check_deck(deck: str, library: str) -> Verdict:
    """Runs the check. library: of user code, which the user of the import allows; empty: none."""
    try:
        program = find_program()
    except NotResults:
        return Verdict(None)
    done = subprocess.run([program, "check", deck, *(["--allow-library", library] if library else [])],
                          capture_output=True, text=True, errors="replace", check=False)
    return Verdict(done.returncode, done.stdout, done.stderr)


def refuse_checked(model: Model, ledger: Ledger, source: str, deck: str, verdict: Verdict) -> None:
    """An error of the check is a refusal of the card that made the entry at its place in the deck."""
    with open(deck, encoding="utf-8") as file:
        root = yaml.compose(file.read(), Loader=yaml.SafeLoader)  # type: ignore[no-untyped-call]
    found = list(ERROR.finditer(verdict.errors))
    for error in found:
        path: list[str | int] = []
        if error["file"] and os.path.basename(error["file"]) == os.path.basename(deck) and error["line"]:
            path = find_path(root, int(error["line"]), int(error["column"] or 1))
        card, place = find_card(model, ledger, path) or ("(model)", Place(source, 1))
        at = f" (at {'.'.join(map(str, path))} of the deck)" if path else ""
        ledger.note(card, Status.REFUSED, place, f"percuss check refuses what becomes of it{at}: {error['text']}")
    if not found:
        ledger.note("(model)", Status.REFUSED, Place(source, 1),
                    f"percuss check ends with exit code {verdict.code}: {verdict.errors.strip()[:500]}")


def find_card(model: Model, ledger: Ledger, path: list[str | int]) -> tuple[str, Place] | None:
    """The card of an entry; where it is known by its kind alone, the first of that kind in the report."""
    found = model.origins.find(path)
    if found is None:
        return None
    card, place = found
    if place is not None:
        return card, place
    rows = [entry for entry in ledger.entries.values() if entry.card.startswith(card)]
    if not rows:
        return None
    first = min(rows, key=lambda entry: entry.first)
    return first.card, first.first


def find_path(node: Any, line: int, column: int) -> list[str | int]:
    """Keys and numbers of the innermost entry at a place of a deck; lines and columns count from 1."""
    path: list[str | int] = []
    while not isinstance(node, yaml.ScalarNode) and node is not None:
        is_map = isinstance(node, yaml.MappingNode)
        children = ([(key.value, key, value) for key, value in node.value] if is_map
                    else [(i, item, item) for i, item in enumerate(node.value)])
        inside = [child for child in children if holds(child[1], child[2], line - 1, column - 1)]
        if not inside:
            break
        name, _, node = inside[0]
        path.append(name)
    return path


def holds(first: yaml.Node, last: yaml.Node, line: int, column: int) -> bool:
    start, end = first.start_mark, last.end_mark
    return (start.line, start.column) <= (line, column) < (end.line, end.column)
