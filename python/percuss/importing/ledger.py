"""What became of every card: translated, approximated, ignored or refused."""

import fnmatch
import re
import shlex
from dataclasses import dataclass, field
from enum import Enum
from typing import NamedTuple

NAMED_ALONE = ("INCLUDE.outside",)  # not in --allow all
SILENT = "nothing comes of it: no card that is translated refers to it, or what it refers to is left out"
ELSEWHERE = ("no row of its own: nothing that is translated refers to it, "
             "or its effect is in another row of this keyword")
NO_COUNTERPART = "percuss has no counterpart"
# what became of those of a deck
NO_SPRINGS = ("percuss corrects velocities, and has springs of its own stiffness between sheets alone; "
              "contact.enforcement: penalty has them everywhere")
MOST_FAULTS = 20  # after which reading stops


class Place(NamedTuple):
    """A line of a file, as messages show it."""

    file: str
    line: int

    def __str__(self) -> str:
        return f"{self.file}:{self.line}"


REFERRED = "(this card refers to it)"
# What a refusal says of what has no elements: where parts were refused it follows from that, and is not reported.
FOLLOWS = ("without elements", "no element", "not in the mesh", "with elements", "any element",
           "without two named sides")


class BadInput(Exception):
    """A file that cannot be read on; the message begins with its place."""

    def __init__(self, place: "Place | str", text: str, follows: bool = False):
        super().__init__(f"{place}: error: {text}")
        self.is_missing = follows or REFERRED in text  # it is not reported where what is refused may be what is missing


def missing(what: str) -> str:
    """The text of BadInput where a card refers to what is not there."""
    return f"there is no {what} {REFERRED}: add it, or correct the name or id"


def type_pattern(key: str) -> str:
    """A key as it is typed behind --allow: commas part patterns, and the shell parts words."""
    return shlex.quote(re.sub(r"[,*?\[\]]", "?", key))


class Status(Enum):
    """Order of the report: what hurts most comes first."""

    REFUSED = "refused"
    LEFT_OUT = "left out"
    APPROXIMATED = "approximated"
    IGNORED = "ignored"
    TRANSLATED = "translated"


@dataclass
class Entry:
    """One row of the report: all cards of one kind with one outcome."""

    card: str
    status: Status
    text: str
    first: Place
    count: int = 1
    follows: bool = False  # it may be that something lost its parts


@dataclass
class Ledger:
    """Gathers entries. What a user allows by a pattern is left out or approximated instead of refused."""

    allowed: list[str] = field(default_factory=list)
    fits_rates: bool = False  # whether tables of strain rates become a fitted law
    case: str = ""  # which *CASE is imported
    user_code: str = ""  # library of the user's VUMAT, which may be loaded
    entries: dict[tuple[str, Status, str], Entry] = field(default_factory=dict)
    used_patterns: set[str] = field(default_factory=set)
    files: set[str] = field(default_factory=set)  # that the model is read from
    lost_parts: bool = False  # elements of the model are not in the deck
    presumes: bool = False  # refusals are noted, and reading goes on as if the user had allowed them
    faults: list[BadInput] = field(default_factory=list)  # of cards that cannot be read, while the others still are
    cards: list[tuple[str, Place, int]] = field(default_factory=list)  # all that are read, with their last lines
    reported_lines: dict[str, bytearray] = field(default_factory=dict)  # by file: lines that an entry is about

    def expect(self, card: str, place: Place, last: int) -> None:
        """A card of the deck, which the report must name. last: its last line."""
        self.cards.append((card, place, last))

    def tells_of(self, first: Place, last: int) -> bool:
        """Whether an entry is about one of these lines."""
        return 1 in self.reported_lines.get(first.file, b"")[first.line : last + 1]

    def note_silent(self) -> None:
        """Cards of which no entry was made at their own lines."""
        order = list(Status)
        found: dict[str, Status] = {}  # the worst outcome of a keyword
        for entry in self.entries.values():
            name = re.split("[.,]", entry.card)[0]
            found[name] = min(found.get(name, entry.status), entry.status, key=order.index)
        for card, place, last in self.cards:
            if self.tells_of(place, last) or found.get(card) is Status.REFUSED:
                continue
            self.note(card, found.get(card, Status.IGNORED), place, ELSEWHERE if card in found else SILENT)

    def note(self, card: str, status: Status, place: Place, text: str) -> None:
        """Adds one card to its row."""
        lines = self.reported_lines.setdefault(place.file, bytearray())
        lines.extend(bytes(max(place.line + 1 - len(lines), 0)))
        lines[place.line] = 1
        key = (card, status, text)
        if key in self.entries:
            self.entries[key].count += 1
        else:
            self.entries[key] = Entry(card, status, text, place)

    def translated(self, card: str, place: Place, text: str) -> None:
        self.note(card, Status.TRANSLATED, place, text)

    def approximated(self, card: str, place: Place, text: str) -> None:
        self.note(card, Status.APPROXIMATED, place, text)

    def ignored(self, card: str, place: Place, text: str) -> None:
        self.note(card, Status.IGNORED, place, text)

    def allows(self, key: str) -> bool:
        """Whether a pattern of the user covers the key.
        What reads other files of the user must be named: no pattern covers it."""
        if key in NAMED_ALONE:
            self.used_patterns |= {key.upper()} & set(self.allowed)
            return key.upper() in self.allowed
        for pattern in self.allowed:
            if pattern == "ALL" or fnmatch.fnmatchcase(key.upper(), pattern):
                self.used_patterns.add(pattern)
                return True
        return False

    def refuse(self, key: str, place: Place, problem: str, instead: str = "") -> bool:
        """Refuses a card or a field, unless the user allows what percuss does instead. Returns whether that is so."""
        if instead and self.allows(key):
            self.note(key, Status.LEFT_OUT, place, f"{problem}: {instead}")
            return True
        reason = "" if problem.endswith(")") else f" ({NO_COUNTERPART})"
        remedy = (f"change or remove it, or use --allow {type_pattern(key)}; then {instead}" if instead
                  else "change or remove it")
        text = f"{problem}{reason}: {remedy}"
        self.note(key, Status.REFUSED, place, text)
        self.entries[key, Status.REFUSED, text].follows = any(word in problem for word in FOLLOWS)
        return self.presumes and bool(instead)

    def note_fault(self, error: BadInput) -> None:
        """A card that cannot be read.
        What it defines may be what others miss: only faults of their own are kept of them."""
        if not (self.faults and error.is_missing):
            self.faults.append(error)
        if len(self.faults) == MOST_FAULTS:
            self.stop_at_faults()

    def stop_at_faults(self) -> None:
        """Raises the first fault, and leaves the others in the list."""
        if self.faults:
            raise self.faults.pop(0)

    def add_later(self, trial: "Ledger") -> None:
        """Refusals that show once others are allowed."""
        for entry in trial.list_refused():
            if not entry.follows:
                self.entries.setdefault((entry.card, Status.REFUSED, entry.text), entry)

    def refuses_in(self, first: Place, last: int) -> bool:
        """Whether a refusal stands in these lines of a file."""
        places = (entry.first for entry in self.entries.values() if entry.status is Status.REFUSED)
        return any(place.file == first.file and first.line <= place.line <= last for place in places)

    def list_rows(self) -> list[Entry]:
        """All rows, by outcome, then by card."""
        order = list(Status)
        causes = (self.lost_parts
                  and any(entry.status is Status.REFUSED and not entry.follows for entry in self.entries.values()))
        entries = [entry for entry in self.entries.values()
                   if not (causes and entry.follows and entry.status is Status.REFUSED)]
        return sorted(entries, key=lambda e: (order.index(e.status), e.card, e.first))

    def list_refused(self) -> list[Entry]:
        return [entry for entry in self.list_rows() if entry.status is Status.REFUSED]
