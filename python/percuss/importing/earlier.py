"""An earlier import in the folder: what it wrote may have been edited since."""

import argparse
import hashlib
import os

from percuss.errors import NotResults
from percuss.files import TEXT, load_json
from percuss.terminal import clean

from .ledger import BadInput

REPORT = "import_report.json"


def find_mark(path: str) -> str:
    """A digest of a file; empty of none."""
    if not path:
        return ""
    with open(path, "rb") as file:
        return hashlib.sha256(file.read()).hexdigest()


def refuse_to_overwrite(arguments: argparse.Namespace, names: list[str], sources: set[str]) -> None:
    """Refuses files that are there, unless --force is given;
    those that the model is read from (sources) in any case."""
    for name in names:
        path = os.path.join(arguments.out, name)
        if not os.path.lexists(path):
            continue
        refuse_source(path, arguments.model, sources)
        if not arguments.force:
            raise BadInput(clean(path), f"{describe_loss(path, name, arguments.out)} (an import overwrites nothing "
                                        "without --force): choose another folder with --out, or give --force")


def refuse_source(path: str, model: str, sources: set[str]) -> None:
    """Refuses a file to write that the model is read from, and what is no file."""
    refuse_no_file(path)
    if not os.path.exists(path):
        return
    if os.path.samefile(path, model):
        raise BadInput(clean(path), "this is the model itself (the import would write its mesh or deck here): "
                                    "choose another folder with --out")
    if any(os.path.exists(source) and os.path.samefile(path, source) for source in sources):
        raise BadInput(clean(path), "this is a file that the model includes (the import would write over it): "
                                    "choose another folder with --out")


def describe_loss(path: str, name: str, folder: str) -> str:
    """What would be gone."""
    written = read_mark(folder)
    if name == "deck.yaml" and os.path.isfile(path):
        if written and find_mark(path) != written:
            return "this deck was edited after its import, and the edits would be lost"
        if not written:
            return "there is a deck already, which would be lost"
    return f"there is a {name} {'of an earlier import' if written else 'already'}, which would be lost"


def read_mark(folder: str) -> str:
    """Mark of the deck as the last import wrote it;
    empty if that is not known, as of a report that no import has written."""
    try:
        mark: str = load_json(os.path.join(folder, REPORT), {"deck_sha256": TEXT})["deck_sha256"]
    except NotResults:
        return ""
    return mark if len(mark) == hashlib.sha256().digest_size * 2 else ""


def refuse_no_file(path: str) -> None:
    """Refuses what is there and is no regular file: a pipe would wait for a reader, a device would be written to."""
    if os.path.lexists(path) and not os.path.isfile(path):
        raise BadInput(clean(path),
                       "this is not a regular file (the import would write here): choose another folder with --out")
