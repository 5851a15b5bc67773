"""The table of proofs of percuss import: what each translated card and field gives in a run.

A row is a smallest deck (one to eight elements) and what its run must give by mechanics, never by an earlier result of percuss.
import_proofs_test.py imports each deck as the command does, runs what was written, and compares history.csv and summary.json.

HOW TO ADD A ROW. Go to the module of the family (dyna_loads.py, abaqus_loads.py, ...; a new module is found by its name), and add

    Proof("LOAD_NODE_SET: NSID DOF LCID SF; DEFINE_CURVE: SFA",
          deck(cube(), "*SET_NODE_LIST\\n1\\n5,6,7,8\\n*LOAD_NODE_SET\\n1,3,7,2.0\\n", curve(7, (0, 1), (1, 1)), end=1e-5),
          [("momentum_z", LAST, 4 * 2.0 * 1e-5, 1e-6)],
          "four nodes with 2 N each push for 1e-5 s")

- `proves`: the cards that would give other numbers if they were read wrongly, each with its fields that do. Cards are named without
  _TITLE and _ID. Of Abaqus: the keyword with its options, such as "CLOAD: AMPLITUDE".
- `deck`: from pieces.py. Fields are separated by commas; units are mm, t, s (steel 7.8e-9, so a cube of 10 mm has 7.8e-6 t).
- `rights`: (what, when, value, tolerance). What is a column of history.csv, or a function of the history: lambda h: h["momentum_x"][-1].
  When is FIRST, LAST, MAX, MIN, LARGEST (of magnitude), ALL (each row), or a time. The tolerance is relative; absolute where value is 0.
  Have a value that no other reading of the card gives: numbers that differ from 0, 1 and from each other.
- `why`: the mechanics of the value in a line.
- `refused`: for a row of what must be refused: words of the message, such as the name of the field. It has no rights. `messages`: how many.
- `fails`: for a row whose run must end with exit code 3: words of its message, beside or in place of rights.
- `allow`: patterns for --allow. `case`: for --case. `files`: further files of the deck, by name.
- `code`: user code in C, which is compiled and allowed; without a compiler the row is not tried.

A row of a keyword deck runs once more with its deck in a file of *INCLUDE_TRANSFORM in other units, and must give the same values. A field with
a dimension therefore stands in python/percuss/importing/dyna/dimensions.py; a card that is not there is refused in such a file.

WHAT MUST HAVE A ROW (import_proofs_test.py asks the importer, there is no list by hand):
- each name of DEFINITIONS and ACTIONS of dyna/read.py, each keyword of abaqus/read.py and each of its options in KNOWN, but what
  NOT_PHYSICS of a module explains: {"TITLE": "a name"}, {"NSET.INTERNAL": "hides it in a user interface"};
- each field of each layout that a deck of the table reaches; a row for one of several cards that are read by one function is enough. A field
  that no row names is set to 1, 2 and 7, one after the other, in such a
  deck: the import must refuse each, and name the field, unless its layout has a reason: `NAME~output`. Reasons are the keys of
  REASONS in python/percuss/importing/fields.py: add one there if none fits. A bare `NAME~` is one that nobody has audited.
"""

import importlib
import os
import pkgutil
from collections.abc import Callable
from dataclasses import dataclass, field

FIRST, LAST, MAX, MIN, LARGEST, ALL = "first", "last", "max", "min", "largest", "all"

History = dict[str, list[float]]
Right = tuple[str | Callable[[History], float | list[float]], str | float, float, float]


@dataclass
class Proof:
    """A row of the table."""

    proves: str
    deck: str | bytes
    rights: list[Right] = field(default_factory=list)
    why: str = ""
    refused: str = ""
    fails: str = ""  # words of the error with which the run ends
    messages: int = 0  # how many refusals there are; 0: any number
    allow: str = ""
    case: str = ""
    files: dict[str, str] = field(default_factory=dict)
    code: str = ""
    family: str = ""

    def list_proven(self) -> list[str]:
        """CARD and CARD.FIELD."""
        names: list[str] = []
        for text in self.proves.split(";"):
            card, _, fields = text.partition(":")
            names += [card.strip(), *(f"{card.strip()}.{name}" for name in fields.split())]
        return names

    def is_abaqus(self) -> bool:
        return isinstance(self.deck, str) and not self.deck.lstrip().upper().startswith("*KEYWORD")


def load() -> tuple[list[Proof], dict[str, str]]:
    """All rows, and all NOT_PHYSICS, of the modules of this folder."""
    proofs: list[Proof] = []
    explained: dict[str, str] = {}
    for found in pkgutil.iter_modules([os.path.dirname(__file__)]):
        module = importlib.import_module(f"{__name__}.{found.name}")
        for proof in getattr(module, "PROOFS", []):
            proof.family = found.name
            proofs.append(proof)
        explained |= getattr(module, "NOT_PHYSICS", {})
    return proofs, explained
