"""The command: reads, writes, reports, checks."""

import argparse
import os
import sys

from . import earlier, proof, report, units
from .abaqus.read import read_abaqus_deck
from .deck_text import clean, write_deck
from .dyna.read import read_keyword_deck
from .ledger import BadInput, Ledger
from .mesh_text import write_mesh
from .model import Model

DECK, MESH = "deck.yaml", "mesh.k"
REPORTS = ["import_report.md", earlier.REPORT]
KEYWORD_ENDINGS, ABAQUS_ENDINGS = (".k", ".key", ".dyn", ".k.txt"), (".inp",)


def choose_reader(path: str):
    """By the extension, then by the first keyword."""
    name = path.lower()
    if name.endswith(ABAQUS_ENDINGS):
        return lambda ledger: read_abaqus_deck(path, ledger)
    if name.endswith(KEYWORD_ENDINGS):
        return lambda ledger: read_keyword_deck(path, ledger)
    with open(path, "rb") as file:
        head = file.read(4096)
    if b"*KEYWORD" in head.upper():
        return lambda ledger: read_keyword_deck(path, ledger)
    raise BadInput(clean(path), "not a keyword deck and not an Abaqus deck (by its ending and its first lines): name it .k, .key, .dyn or .inp")


def make_ledger(patterns: list[str]) -> Ledger:
    words = [word.strip().lstrip("*").upper() if word.strip() != "*" else "ALL" for text in patterns for word in text.split(",")]
    return Ledger(allowed=[word for word in words if word])


def import_model(arguments: argparse.Namespace) -> int:
    """Returns the exit code."""
    if not os.path.isfile(arguments.model):
        raise BadInput(clean(arguments.model), "is not a file: check the name")
    earlier.refuse_to_overwrite(arguments, [DECK, MESH], set())
    ledger = make_ledger(arguments.allow)
    try:
        model = choose_reader(arguments.model)(ledger)
    except BadInput as error:
        if error.is_missing and ledger.list_refused():  # what is refused is what is missing
            os.makedirs(arguments.out, exist_ok=True)
            write_reports(arguments, ledger, [], "")
            return tell_refused(arguments, ledger)
        print_refused(ledger)
        raise
    refused = ledger.list_refused()
    if not refused and not model.blocks:
        raise BadInput(clean(arguments.model), "no part is left to run (every part was left out): read import_report.md and allow less")
    earlier.refuse_to_overwrite(arguments, [DECK, MESH, *model.tables], ledger.files)
    for name in REPORTS:
        earlier.refuse_source(os.path.join(arguments.out, name), arguments.model, ledger.files)
    summary = report.summarise(model, [units.describe(model, arguments.units)])
    os.makedirs(arguments.out, exist_ok=True)
    deck = "" if refused else write_files(arguments, model)  # before what is printed, whose reader may end
    write_reports(arguments, ledger, summary, deck)
    if not arguments.quiet:
        report.print_table(ledger)
    tell_unused(ledger)
    return tell_refused(arguments, ledger) if refused else tell_deck(arguments, deck, summary)


def tell_unused(ledger: Ledger) -> None:
    """What the user allows and the deck does not have."""
    for pattern in ledger.allowed:
        if pattern not in ledger.used_patterns and pattern != "ALL":
            print(f"percuss import: --allow {clean(pattern)} fits nothing that is refused", file=sys.stderr)


def write_reports(arguments: argparse.Namespace, ledger: Ledger, summary: list[str], deck: str) -> None:
    """deck: the file just written; empty: none, and one of an earlier import stays."""
    report.write_report(os.path.join(arguments.out, "import_report.md"), arguments.model, ledger, summary)
    report.write_json(os.path.join(arguments.out, earlier.REPORT), arguments.model, ledger, summary, earlier.find_mark(deck) or earlier.read_mark(arguments.out))


def tell_refused(arguments: argparse.Namespace, ledger: Ledger) -> int:
    """Tells what is refused, and that no deck is written."""
    print_refused(ledger)
    print(
        f"percuss import: no deck is written; {os.path.join(arguments.out, 'import_report.md')} lists every card", file=sys.stderr
    )
    return 2


def print_refused(ledger: Ledger) -> None:
    """An error for each row that is refused."""
    for entry in ledger.list_refused():
        more = f" (and {entry.count - 1} more)" if entry.count > 1 else ""
        print(f"{clean(str(entry.first))}: error: *{clean(entry.card)}: {clean(entry.text)}{more}", file=sys.stderr)


def write_files(arguments: argparse.Namespace, model: Model) -> str:
    """Writes the deck and its mesh. Returns the name of the deck."""
    deck = os.path.join(arguments.out, DECK)
    try:
        text = write_deck(model, os.path.basename(arguments.model), MESH, arguments.units)
    except OverflowError as error:
        raise BadInput(clean(arguments.model), str(error)) from None
    write_mesh(model, os.path.join(arguments.out, MESH))
    for name, lines in model.tables.items():
        with open(os.path.join(arguments.out, name), "w", encoding="utf-8", newline="\n") as file:
            file.writelines(f"{line}\n" for line in lines)
    with open(deck, "w", encoding="utf-8", newline="\n") as file:
        file.write(text)
    return deck


def tell_deck(arguments: argparse.Namespace, deck: str, summary: list[str]) -> int:
    """Tells what was written, and checks it."""
    for line in summary:
        print(clean(line))
    print(f"percuss import: {clean(deck)}", flush=True)
    if not arguments.check:
        return 0
    code = proof.check_deck(deck)
    if code is None:
        print("percuss import: percuss is not found, so the deck is not checked", file=sys.stderr)
        return 0
    return code
