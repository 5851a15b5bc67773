"""The command: reads, writes, reports, checks."""

import argparse
import os
import shutil
import sys
import tempfile
from collections.abc import Callable

from percuss.files import write_file
from percuss.terminal import clean

from . import earlier, proof, report, units
from .abaqus.read import read_abaqus_deck
from .deck_text import write_deck
from .dyna.read import read_keyword_deck
from .ledger import BadInput, Ledger
from .mesh_text import write_mesh
from .model import Model

DECK, MESH = "deck.yaml", "mesh.k"
REPORTS = ["import_report.md", earlier.REPORT]
KEYWORD_ENDINGS, ABAQUS_ENDINGS = (".k", ".key", ".dyn", ".k.txt"), (".inp",)


def choose_reader(path: str) -> Callable[[Ledger], Model]:
    """Chooses by the extension, then by the first keyword."""
    name = path.lower()
    if name.endswith(ABAQUS_ENDINGS):
        return lambda ledger: read_abaqus_deck(path, refuse_case(path, ledger))
    if name.endswith(KEYWORD_ENDINGS):
        return lambda ledger: read_keyword_deck(path, ledger)
    with open(path, "rb") as file:
        head = file.read(4096)
    if b"*KEYWORD" in head.upper():
        return lambda ledger: read_keyword_deck(path, ledger)
    raise BadInput(clean(path), "not a keyword deck and not an Abaqus deck (by its ending and its first lines): "
                                "name it .k, .key, .dyn or .inp")


def refuse_case(path: str, ledger: Ledger) -> Ledger:
    if ledger.case:
        raise BadInput(clean(path), "--case is for decks of LS-DYNA with *CASE (this is one of Abaqus): leave it out")
    return ledger


def make_ledger(patterns: list[str], fits_rates: bool, case: str = "", library: str = "") -> Ledger:
    words = [word.strip().lstrip("*").upper() if word.strip() != "*" else "ALL" for text in patterns
             for word in text.split(",")]
    return Ledger(allowed=[word for word in words if word], fits_rates=fits_rates, case=case.strip(),
                  user_code=os.path.abspath(library) if library else "")


def import_model(arguments: argparse.Namespace) -> int:
    """Returns the exit code."""
    if not os.path.isfile(arguments.model):
        raise BadInput(clean(arguments.model), "is not a file: check the name")
    if arguments.allow_library and not os.path.isfile(arguments.allow_library):
        raise BadInput(clean(arguments.allow_library), "--allow-library is no file: compile the code first")
    earlier.refuse_to_overwrite(arguments, [DECK, MESH], set())
    ledger = make_ledger(arguments.allow, arguments.fit_rates, arguments.case, arguments.allow_library)
    try:
        model = choose_reader(arguments.model)(ledger)
        if ledger.list_refused():
            add_later_refusals(arguments, ledger)
    except BadInput as error:
        if error.is_missing and ledger.list_refused():  # what is refused is what is missing
            os.makedirs(arguments.out, exist_ok=True)
            write_reports(arguments, ledger, [], "")
            return print_refused(arguments, ledger)
        print_errors(ledger)
        raise
    refused = ledger.list_refused()
    if not refused and not model.blocks:
        raise BadInput(clean(arguments.model),
                       "no part is left to run (every part was left out): read import_report.md and allow less")
    earlier.refuse_to_overwrite(arguments, [DECK, MESH, *model.tables], ledger.files)
    for name in REPORTS:
        earlier.refuse_source(os.path.join(arguments.out, name), arguments.model, ledger.files)
    if model.units and arguments.units and model.units != arguments.units:
        raise BadInput(clean(arguments.model), f"a blast of the model is in {model.units} (--units says "
                                               f"{arguments.units}): leave --units out, or correct UNIT of the blast")
    arguments.units = arguments.units or model.units
    summary = report.summarise(model, [units.describe(model, arguments.units)])
    os.makedirs(arguments.out, exist_ok=True)
    verdict = proof.Verdict(0) if refused else write_checked(arguments, ledger, model)
    refused = ledger.list_refused()
    deck = "" if refused or verdict.code else os.path.join(arguments.out, DECK)
    write_reports(arguments, ledger, summary, deck)
    if not arguments.quiet:
        report.print_table(ledger)
    print_unused(ledger)
    return print_refused(arguments, ledger) if refused else print_deck(deck, summary, verdict)


def add_later_refusals(arguments: argparse.Namespace, ledger: Ledger) -> None:
    """Reads the model once more as if all that is refused were allowed, and checks what it becomes:
    the user gets all refusals at once."""
    trial = make_ledger(arguments.allow, arguments.fit_rates, arguments.case, arguments.allow_library)
    trial.presumes = True
    try:
        model = choose_reader(arguments.model)(trial)
        if model.blocks and all("--allow " in entry.text for entry in trial.list_refused()):  # nothing is missing in it
            with tempfile.TemporaryDirectory(prefix="percuss_import_") as folder:
                write_files(arguments, model, folder)
                check_written(arguments, trial, model, folder)
    except BadInput:
        return  # what is refused may be what is missing
    ledger.add_later(trial)


def print_unused(ledger: Ledger) -> None:
    """What the user allows and the deck does not have."""
    for pattern in ledger.allowed:
        if pattern not in ledger.used_patterns and pattern != "ALL":
            print(f"percuss import: --allow {clean(pattern)} fits nothing that is refused", file=sys.stderr)


def write_reports(arguments: argparse.Namespace, ledger: Ledger, summary: list[str], deck: str) -> None:
    """deck: the file just written; empty: none, and one of an earlier import stays."""
    report.write_report(os.path.join(arguments.out, "import_report.md"), arguments.model, ledger, summary)
    report.write_json(os.path.join(arguments.out, earlier.REPORT), arguments.model, ledger, summary,
                      earlier.find_mark(deck) or earlier.read_mark(arguments.out))


def print_refused(arguments: argparse.Namespace, ledger: Ledger) -> int:
    """What is refused, and that no deck is written."""
    print_errors(ledger)
    print(
        f"percuss import: no deck is written; {os.path.join(arguments.out, 'import_report.md')} lists every card",
        file=sys.stderr
    )
    return 2


def print_errors(ledger: Ledger) -> None:
    """An error for each row that is refused, and for each card that cannot be read."""
    for fault in ledger.faults:
        print(clean(str(fault)), file=sys.stderr)
    for entry in ledger.list_refused():
        more = f" (and {entry.count - 1} more)" if entry.count > 1 else ""
        print(f"{clean(str(entry.first))}: error: *{clean(entry.card)}: {clean(entry.text)}{more}", file=sys.stderr)


def write_checked(arguments: argparse.Namespace, ledger: Ledger, model: Model) -> proof.Verdict:
    """Writes deck, mesh and tables to a folder of their own, checks them there,
    and moves them to their places if they pass."""
    folder = tempfile.mkdtemp(prefix=".import_", dir=arguments.out.rstrip("/") or "/")
    try:
        names = write_files(arguments, model, folder)
        verdict = check_written(arguments, ledger, model, folder)
        if not verdict.code:
            for name in names:
                os.replace(os.path.join(folder, name), os.path.join(arguments.out, name))
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    return verdict


def check_written(arguments: argparse.Namespace, ledger: Ledger, model: Model, folder: str) -> proof.Verdict:
    """Checks the deck of a folder that is to be moved, unless the user wants no check. Its errors become refusals."""
    deck, place = os.path.join(folder, DECK), arguments.out.rstrip("/") or "/"
    verdict = proof.check_deck(deck, ledger.user_code) if arguments.check else proof.Verdict(0)
    verdict = verdict._replace(output=verdict.output.replace(folder, place),
                               errors=verdict.errors.replace(folder, place))
    if verdict.code == 2:
        proof.refuse_checked(model, ledger, arguments.model, deck, verdict)
    return verdict


def write_files(arguments: argparse.Namespace, model: Model, folder: str) -> list[str]:
    """Writes the mesh, its tables and the deck. Returns their names."""
    try:
        text = write_deck(model, os.path.basename(arguments.model), MESH, arguments.units)
    except OverflowError as error:
        raise BadInput(clean(arguments.model), str(error)) from None
    write_mesh(model, os.path.join(folder, MESH))
    tables = {name: "".join(f"{line}\n" for line in lines) for name, lines in model.tables.items()}
    for name, content in {**tables, DECK: text}.items():
        write_file(os.path.join(folder, name), content, "import", force=True)
    return [MESH, *tables, DECK]


def print_deck(deck: str, summary: list[str], verdict: proof.Verdict) -> int:
    """What was written, and what the check says."""
    for line in summary:
        print(clean(line))
    if deck:
        print(f"percuss import: {clean(deck)}", flush=True)
    print(verdict.output, end="", flush=True)
    print(verdict.errors, end="", file=sys.stderr)
    if verdict.code is None:
        print("percuss import: percuss is not found, so the deck is not checked", file=sys.stderr)
    return verdict.code or 0
