"""*CASE: one deck for several runs, of which one is imported."""

import re

from ..fields import clip, parse_integer
from ..ledger import BadInput, Ledger, Place

BOUND = re.compile(r"CASE_(BEGIN|END)_(\d{1,9})\Z")
OWNER = re.compile(r"\sCID\s*=\s*(\d{1,9})\b", re.IGNORECASE)


def find_owner(line: str) -> int:
    """The inner case whose alone the card of this keyword line is, as *TITLE CID=2 says; 0: of all."""
    found = OWNER.search(line)
    return int(found[1]) if found else 0


class Cases:
    """The cards that act: those outside of all inner cases, and those of the inner cases that the chosen *CASE names.

    A deck without *CASE, but with inner cases: each of them is a case of its own.
    One case acts by itself; of several --case names one.
    """

    def __init__(self, ledger: Ledger):
        self._ledger = ledger
        self._cases: dict[int, tuple[str, set[int]]] = {}  # title, inner cases
        self._acting: set[int] | None = None
        self._open: list[int] = []  # inner cases around what is read

    def scan(self, lines: list[str], shown: str, width: int) -> None:
        """All cases of the main file, since what stands before them may be of one."""
        inner: dict[int, int] = {}  # and the line where it is first named
        for number, line in enumerate(lines, 1):
            word = line[1:].split(maxsplit=1)[0].upper() if line[:1] == "*" and line[1:].strip() else ""
            if word == "CASE":
                self._add(lines, number, shown, width)
            bound = BOUND.match(word)
            if word and (id := int(bound[2]) if bound else find_owner(line)):
                inner.setdefault(id, number)
        named = bool(self._cases)
        if not named:
            self._cases = {id: ("", {id}) for id in sorted(inner)}
        if self._cases:
            first = (next((n for n, line in enumerate(lines, 1) if line.upper().startswith("*CASE")), 0)
                     or min(inner.values()))
            self._choose(Place(shown, first))
        elif self._ledger.case:
            raise BadInput(shown,
                           f"there is no case {clip(self._ledger.case)} (the file has no *CASE): leave --case out")

    def _add(self, lines: list[str], number: int, shown: str, width: int) -> None:
        """CASEID JOBID, then commands of the program, then ids of inner cases."""
        rows = []
        for line in lines[number:]:
            if line.startswith("*"):
                break
            if not line.startswith("$"):
                rows.append(line)
        id = parse_integer(rows[0][:width].strip()) if rows and rows[0].strip() else None
        if id is None or id <= 0:
            raise BadInput(Place(shown, number),
                           "CASEID of *CASE is missing (a positive whole number is expected): add it")
        if id in self._cases:
            raise BadInput(Place(shown, number), f"there are two cases {id} (ids must be unique): renumber one")
        words = [word for row in rows[2:]
                 for word in (row.split(",") if "," in row else re.findall(f".{{1,{width}}}", row))]
        self._cases[id] = (clip(rows[0][width:].strip()),
                           {value for word in words if (value := parse_integer(word.strip()))})

    def _choose(self, place: Place) -> None:
        listed = ", ".join(f"{id} {title}".strip() for id, (title, _) in self._cases.items())
        asked = parse_integer(self._ledger.case)
        if self._ledger.case and asked not in self._cases:
            raise BadInput(place, f"there is no case {clip(self._ledger.case)} (there are {clip(listed, 200)}): "
                                  "correct --case")
        first = next(iter(self._cases))
        if asked is None and len(self._cases) > 1:
            self._ledger.refuse("CASE", place, f"several cases, of which --case N imports one: {clip(listed, 200)} "
                                               "(LS-DYNA runs them one after the other)", f"case {first} acts")
        chosen = first if asked is None else asked
        self._acting = self._cases[chosen][1]
        self._ledger.translated("CASE", place,
                                f"the cards of case {clip(f'{chosen} {self._cases[chosen][0]}'.strip())} act, "
                                "and those of none")

    def pass_bound(self, keyword: str, place: Place) -> bool:
        """Notes where an inner case begins or ends; whether the keyword is of *CASE."""
        if keyword == "CASE":
            return True
        bound = BOUND.match(keyword)
        if not bound:
            return False
        id = int(bound[2])
        if bound[1] == "BEGIN":
            self._open.append(id)
        elif id not in self._open:
            raise BadInput(place, f"inner case {id} ends, and did not begin: correct the number")
        else:
            self._open.remove(id)
        if self._acting is None:  # of an included file alone
            self._ledger.refuse("CASE", place, "cases in an included file, and none in the first", "all of them act")
        return True

    def acts(self, owner: int) -> bool:
        """Whether a card acts that stands here, and is of the inner case `owner` alone."""
        around = [*self._open, *([owner] if owner else [])]
        return self._acting is None or self._acting.issuperset(around)
