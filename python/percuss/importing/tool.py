"""Turns decks of other programs into decks of percuss. percuss import --help says how."""

import argparse
import sys

from percuss.help_format import HelpFormatter
from percuss.libraries import require

NEEDS = ("yaml",)
EPILOG = """\
MODEL is an LS-DYNA keyword deck (.k, .key, .dyn, with the files that it
includes) or an Abaqus deck (.inp) of an explicit analysis. DIR gets:
  deck.yaml          what percuss runs, readable, to be edited
  mesh.k             nodes, elements and sets with the ids of the deck
  import_report.md   what became of every card; import_report.json is the same
                     for programs
percuss check then checks the deck, unless --no-check is given. Its errors are
reported for the card that made the entry.

Nothing is dropped silently. A card, an option or a field that changes physics
and has no counterpart is refused with its place. All refusals are listed
together, and no deck is written. The message says what --allow would do
instead, card by card:
  --allow MAT_RIGID                accept what the message offers for *MAT_RIGID
  --allow 'CONTACT.*,HOURGLASS*'   patterns, several with commas
  --allow all                      accept every documented approximation; read
                                   the report

If the folder holds an imported deck, nothing is changed unless --force is
given: deck.yaml may have been edited since.

Examples:
  percuss import car.k --out car --units 'mm, t, s'
  percuss run car/deck.yaml

Exit codes:
  0    done
  2    the deck or an option is wrong, or percuss check refuses the result
  4    a file cannot be written

Needs Python 3.10 with PyYAML. docs/import.md has the table of cards.
"""


def parse_arguments(words: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="percuss import",
        epilog=EPILOG,
        formatter_class=HelpFormatter,
        description="Convert an LS-DYNA or Abaqus model to a deck.",
    )
    add = parser.add_argument
    add("model", metavar="MODEL", help="the model, of LS-DYNA or Abaqus")
    add("--out", metavar="DIR", required=True, help="folder for the percuss deck; created if needed")
    add("--units", metavar="SYSTEM", default="",
        help="units of the deck, such as 'mm, t, s'; never guessed, nothing is converted")
    add("--allow", metavar="CARDS", action="append", default=[],
        help="cards or fields that may be left out or approximated")
    add("--fit-rates", action="store_true",
        help="fit Cowper and Symonds' law to tables of strain rates; the report gives its error")
    add("--case", metavar="N", default="", help="which *CASE of an LS-DYNA deck with several is imported")
    add("--allow-library", metavar="FILE", default="",
        help="the compiled code of *USER MATERIAL; percuss check loads it")
    add("--force", action="store_true", help="overwrite the deck of an earlier import, edits included")
    add("--no-check", dest="check", action="store_false", help="do not run percuss check")
    add("--quiet", action="store_true", help="print no table; import_report.md has it")
    return parser.parse_args(words)


def main(words: list[str]) -> int:
    arguments = parse_arguments(words)
    require("decks are written with", NEEDS, "")
    from percuss.errors import NotResults
    from percuss.importing.command import import_model
    from percuss.importing.ledger import BadInput
    from percuss.terminal import clean

    try:
        return import_model(arguments)
    except (BadInput, NotResults) as error:
        print(clean(str(error)), file=sys.stderr)
        return 2
    except OSError as error:
        print(f"percuss import: error: {clean(str(error))}", file=sys.stderr)
        return 4
