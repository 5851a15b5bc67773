"""All cards of a keyword deck and of the files that it includes, in their order."""

import os
import re
from collections.abc import Iterator

from ..fields import clip
from ..ledger import BadInput, Ledger, Place, missing
from ..model import Vector
from ..text_files import read_lines
from ..unique import Unique
from .cards import Card
from .cases import Cases, find_owner
from .parameter_cards import read_parameters
from .parameters import Parameters
from .transform_cards import Transformation, read_include
from .transforms import UNCHANGED, FileChange

MOST_OPEN, MOST_INCLUDED = 20, 1000
MOST_BYTES = 4 << 30
WIDTH_OF_SUFFIX = {"+": "long", "%": "i10", "-": "standard"}
WIDTH = {"standard": 0, "i10": 10, "long": 20}
OPTIONS = re.compile(r"_(TITLE|ID)(?=_|$)")


class CardReader:
    """All cards of a file and of those that it includes, in their order."""

    def __init__(self, path: str, ledger: Ledger, nodes: dict[int, Vector]):
        self._ledger, self._nodes = ledger, nodes  # nodes that are read so far
        self._folder = os.path.dirname(os.path.realpath(path))
        self._folders = [self._folder]
        self._main = path
        self._included: set[tuple[str, tuple[tuple[str, int], ...]]] = set()  # files with the offsets of their ids
        self._bytes = 0
        self.transformations: dict[int, Transformation] = {}
        self._ids = Unique()
        self._cases = Cases(ledger)

    def read(self) -> Iterator[Card]:
        self._included.add((os.path.realpath(self._main), ()))
        yield from self._read_file(self._main, self._main, Parameters(), 1)

    def _read_lines(self, path: str, place: "Place | str") -> list[str]:
        if not os.path.isfile(path):
            raise BadInput(place, f"{clip(path, 200)} is not a file: check the name")
        self._bytes += os.path.getsize(path)
        if self._bytes > MOST_BYTES:
            raise BadInput(place, "the files hold more than 4 GiB (the limit of the importer): divide the model")
        self._ledger.files.add(path)
        return read_lines(path, place)

    def _read_file(self, path: str, shown: str, parameters: Parameters, depth: int,
                   place: "Place | str" = "") -> Iterator[Card]:
        width = "standard"
        lines = self._read_lines(path, place or shown)
        if depth == 1:
            heads = (line.upper() for line in lines if line[:8].upper() == "*KEYWORD")
            self._cases.scan(lines, shown, 20 if find_width(next(heads, ""), "") == "long" else 10)
        for card in self._cut_cards(lines, shown, parameters):
            name, width_of_card = strip_width(card.keyword, width)
            card.keyword, card.least_width = name, WIDTH[width_of_card]
            if name == "END":
                return
            if self._cases.pass_bound(name, card.place):
                continue
            if not name.startswith("KEYWORD"):
                self._ledger.expect(OPTIONS.sub("", name), card.place,
                                    card.lines[-1][0] if card.lines else card.place.line)
            if not self._cases.acts(card.owner):
                self._ledger.ignored(f"CASE.{name}", card.place, "of a case that does not act")
            elif name == "KEYWORD" or name.startswith("KEYWORD_"):
                width = find_width(card.lines.pop(0)[1] if card.lines else "", width)
            elif name.startswith("INCLUDE"):
                yield from self._include(card, path, depth)
            elif name.startswith("DEFINE_TRANSFORMATION"):
                strip_options(card)
                if card.change is not UNCHANGED:
                    card.change.check(card.keyword, card.place, self._ledger)
                found = Transformation(card)
                self._ids.claim("*DEFINE_TRANSFORMATION", found.id, found.place)
                self.transformations[found.id] = found
                self._ledger.translated(card.keyword, card.place, "moves the files and nodes that name it")
            elif name.startswith("PARAMETER"):
                read_parameters(parameters, card, self._ledger)
            else:
                strip_options(card)
                if card.change is not UNCHANGED:
                    card.change.check(card.keyword, card.place, self._ledger)
                yield card

    def _cut_cards(self, lines: list[str], shown: str, parameters: Parameters) -> Iterator[Card]:
        card: Card | None = None
        for number, line in enumerate(lines, 1):
            if line.startswith("$"):
                continue
            if line.startswith("*"):
                if card:
                    yield card
                card = Card(find_keyword(line), Place(shown, number), 0, parameters.freeze(), owner=find_owner(line))
                if card.keyword.startswith("KEYWORD"):
                    card.lines.append((number, line.upper()))
            elif card:
                card.lines.append((number, line))
            elif line.strip():
                raise BadInput(Place(shown, number),
                               f"'{clip(line.strip())}' stands before any keyword (a deck begins with one): remove it")
        if card:
            yield card

    def _include(self, card: Card, path_of_file: str, depth: int) -> Iterator[Card]:
        if card.keyword == "INCLUDE_TRANSFORM":
            yield from self._include_moved(card, path_of_file, depth)
            return
        names = join_names(card)
        if card.keyword in ("INCLUDE_PATH", "INCLUDE_PATH_RELATIVE"):
            self._folders += [os.path.join(self._folder, name) for name in names]
            self._ledger.translated(card.keyword, card.place, "a folder in which files are sought")
            return
        if card.keyword != "INCLUDE":
            self._ledger.refuse(card.keyword, card.place, "the file is not read", "the file is left out")
            return
        for name in names:
            yield from self._read_included(name, card, path_of_file, depth)

    def _include_moved(self, card: Card, path_of_file: str, depth: int) -> Iterator[Card]:
        """*INCLUDE_TRANSFORM: the same file may come again if its ids get other offsets."""
        name, change = read_include(card, self.transformations, self._nodes, self._ledger)
        yield from self._read_included(name, card, path_of_file, depth, change)

    def _read_included(self, name: str, card: Card, path_of_file: str, depth: int,
                       change: FileChange = UNCHANGED) -> Iterator[Card]:
        """The cards of an included file."""
        path = self._find(name, card.place, os.path.dirname(os.path.realpath(path_of_file)))
        if depth >= MOST_OPEN or len(self._included) >= MOST_INCLUDED:
            raise BadInput(card.place, "files include each other too deeply, or in a loop: remove the loop")
        parameters = card.parameters.inner(change)
        key = (path, tuple(sorted(parameters.change.offsets.items())))
        if key in self._included:
            raise BadInput(card.place, f"'{clip(name)}' is included twice (with the same ids): "
                                       "remove one *INCLUDE, or give it other offsets")
        self._included.add(key)
        self._ledger.translated(card.keyword, card.place, "the file is read")
        shown = os.path.join(os.path.dirname(self._main), os.path.relpath(path, self._folder))
        yield from self._read_file(path, shown, parameters, depth + 1, card.place)

    def _find(self, name: str, place: Place, folder_of_file: str) -> str:
        """Beside the main file, in the folders of _PATH, or beside the file that includes."""
        name = name.replace("\\", "/")
        for folder in [*self._folders, folder_of_file]:
            path = os.path.realpath(os.path.join(folder, name)) if "\0" not in name else ""
            if not os.path.isfile(path):
                continue
            inside = os.path.commonpath([path, self._folder]) == self._folder
            if not inside and not self._ledger.allows("INCLUDE.outside"):
                raise BadInput(
                    place,
                    f"'{clip(name, 100)}' lies outside of the folder of the first file "
                    "(--allow INCLUDE.outside reads it, if you trust the deck)",
                )
            return path
        raise BadInput(place, missing(f"file '{clip(name, 100)}'"))


def join_names(card: Card) -> list[str]:
    """File names of an *INCLUDE: ` +` at the end of a line goes on in the next."""
    names: list[str] = []
    goes_on = False
    for _, line in card.lines:
        name = line.strip()
        if not name:
            continue
        if goes_on:
            names[-1] += name
        else:
            names.append(name)
        goes_on = names[-1].endswith(" +")
        if goes_on:
            names[-1] = names[-1][:-2]
    return names


def find_width(line: str, otherwise: str) -> str:
    """Width of fields that a *KEYWORD line asks for."""
    return "long" if "LONG=Y" in line else "i10" if "I10=Y" in line else otherwise


def find_keyword(line: str) -> str:
    """The keyword of a line in capitals, with its suffix of width, which may stand behind a blank.
    What else follows is a comment."""
    word, *more = re.split(r"[\s,]+", line[1:].strip(), maxsplit=2)
    return word.upper() + (more[0] if more and more[0] in WIDTH_OF_SUFFIX else "")


def strip_width(keyword: str, width: str) -> tuple[str, str]:
    """A keyword without its suffix of width, and the width of its fields."""
    if keyword[-1:] in WIDTH_OF_SUFFIX:
        return keyword[:-1], WIDTH_OF_SUFFIX[keyword[-1]]
    return keyword, width


def strip_options(card: Card) -> None:
    """Takes _TITLE and _ID out of the keyword, wherever they stand."""
    options = OPTIONS.findall(card.keyword)
    card.has_title, card.has_id = "TITLE" in options, "ID" in options
    card.keyword = OPTIONS.sub("", card.keyword)
