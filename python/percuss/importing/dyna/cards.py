"""Cards of keyword decks: files and what they include, comments, fields in columns or between commas."""

import os
import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import accumulate

from ..fields import Row, clip, describe_columns, find_cut_number, parse_integer, shift_hint
from ..ledger import BadInput, Ledger, Place, missing
from ..model import Vector
from ..text_files import read_lines
from ..unique import Unique
from .cases import Cases, find_owner
from .parameters import Parameters
from .transforms import UNCHANGED, FileChange, Transformation, read_include

MOST_OPEN, MOST_INCLUDED = 20, 1000
MOST_BYTES = 4 << 30
WIDTH_OF_SUFFIX = {"+": "long", "%": "i10", "-": "standard"}
HEADING = 70  # columns of a text
WIDTH = {"standard": 0, "i10": 10, "long": 20}
OPTIONS = re.compile(r"_(TITLE|ID)(?=_|$)")


@dataclass
class Card:
    """A keyword with the lines up to the next one, without comments."""

    keyword: str  # in capitals, without star, suffix of width, _TITLE and _ID
    place: Place
    least_width: int
    parameters: Parameters
    has_title: bool = False
    has_id: bool = False
    owner: int = 0  # the inner case whose alone it is
    lines: list[tuple[int, str]] = field(default_factory=list)
    reached: int = 0  # lines that were read

    @property
    def change(self) -> FileChange:
        """What is done to the file that holds it."""
        return self.parameters.change

    def at(self, number: int) -> Place:
        return Place(self.place.file, number)

    def split(self, line: tuple[int, str], widths: tuple[int, ...], names: Sequence[str] = ()) -> list[str]:
        """The fields of a line, parameters replaced. names: of those that count, for messages; empty: all count."""
        number, text = line
        if "," in text:
            texts = [word.strip() for word in text.split(",")]
        else:
            if "\t" in text:
                self._refuse_tab(line, widths)
            texts, first = [], 0
            for index, width in enumerate(widths):
                width = max(width, self.least_width)
                texts.append(text[first : first + width].strip())
                first += width
                if (text[first - 1 : first] > " " and text[first : first + 1] > " " and width < HEADING
                        and (index < len(names) or not names)):
                    self._refuse_cut(line, first, widths, names[index] if names else "")
        if "&" in text:
            texts = [self._replace(word, number, widths[i] if i < len(widths) else 0) if "&" in word else word
                     for i, word in enumerate(texts)]
        return texts

    def _refuse_cut(self, line: tuple[int, str], border: int, widths: tuple[int, ...], name: str) -> None:
        """A number over the end of its column, also where each half of it reads as one.
        name: of the field; empty: not known."""
        borders = list(accumulate(max(width, self.least_width) for width in widths))
        word = find_cut_number(line[1], border, borders)
        if word:
            field = f"{name} of *{self.keyword}" if name else f"a field of *{self.keyword}"
            width = border - max((b for b in borders if b < border), default=0)
            raise BadInput(self.at(line[0]), f"{field} is cut (column {border} ends a field of {width} and cuts "
                                             f"'{clip(word)}'): shift it, or write commas")

    def _refuse_tab(self, line: tuple[int, str], widths: tuple[int, ...]) -> None:
        """A tab before the end of the fields, headings apart: nobody sees which column follows it."""
        end = sum(max(width, self.least_width) for width in widths if width < HEADING)
        if "\t" in line[1].rstrip()[:end]:
            raise BadInput(self.at(line[0]), "a tab stands in a line of columns "
                                             "(LS-DYNA takes it as one, an editor as several): write blanks or commas")

    def _replace(self, word: str, number: int, width: int) -> str:
        """A field with its parameters put in place; in a heading '&' may be a character like others."""
        try:
            return self.parameters.replace(word, self.at(number))
        except BadInput:
            if width < HEADING:
                raise
            return word

    def row(self, line: tuple[int, str], layout: str, widths: tuple[int, ...] = (10,) * 8) -> Row:
        """A line as named fields."""
        row = Row(self.keyword, self.at(line[0]), layout,
                  self.split(line, widths, [word.partition("=")[0].partition("~")[0] for word in layout.split()]))
        if "," not in line[1]:
            row.columns = lambda index: self.describe_columns(line[1], widths, index)
        if self.change is not UNCHANGED:
            row.change = self.change
        return row

    def describe_columns(self, text: str, widths: tuple[int, ...], index: int) -> str:
        """What is wrong with the columns of a field; an empty text where nothing is."""
        real = [max(width, self.least_width) for width in widths[: index + 1]]
        return describe_columns(text, sum(real[:-1]), real[-1]) if index < len(widths) else ""

    def reader(self) -> "Lines":
        return Lines(self)

    def find_surplus(self) -> int:
        """The first line with something other than zeros behind those that were read;
        0: none, or the card has not been read."""
        rest = self.lines[self.reached :] if self.reached else []
        return next((number for number, text in rest if text.replace(",", " ").strip("0. \t\r")), 0)


class Lines:
    """Takes the lines of a card one after the other. A missing line is a line of blanks."""

    def __init__(self, card: Card):
        self.card, self._next = card, 0

    def __bool__(self) -> bool:
        return self._next < len(self.card.lines)

    def take(self) -> tuple[int, str]:
        if not self:
            last = self.card.lines[-1][0] if self.card.lines else self.card.place.line
            self._next += 1
            return last, ""
        self._next += 1
        self.card.reached = max(self.card.reached, self._next)
        return self.card.lines[self._next - 1]

    def peek(self) -> str:
        return self.card.lines[self._next][1] if self else ""

    def text(self) -> str:
        return self.take()[1].strip()

    def row(self, layout: str, widths: tuple[int, ...] = (10,) * 8) -> Row:
        return self.card.row(self.take(), layout, widths)

    def holds_more(self) -> bool:
        """Whether a line with something is left; passes over none."""
        return any(self.card.lines[index][1].strip() for index in range(self._next, len(self.card.lines)))

    def next_card(self, of_lines: bool = False) -> bool:
        """Whether a card follows. Where a card has a title or an id, or several lines (of_lines), its first line is the
        next one, also a blank one: that is a line of defaults.
        Blank lines between cards of a single line define nothing, and are passed over."""
        return self.holds_more() if self.card.has_title or self.card.has_id or of_lines else self.skip_blank()

    def skip_blank(self) -> bool:
        """Passes over empty lines; whether there is one with something."""
        while self and not self.peek().strip():
            self._next += 1
        return bool(self)


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
                    card.change.check(card, self._ledger)
                found = Transformation(card)
                self._ids.claim("*DEFINE_TRANSFORMATION", found.id, found.place)
                self.transformations[found.id] = found
                self._ledger.translated(card.keyword, card.place, "moves the files and nodes that name it")
            elif name.startswith("PARAMETER"):
                parameters.read(card, self._ledger)
            else:
                strip_options(card)
                if card.change is not UNCHANGED:
                    card.change.check(card, self._ledger)
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


def read_ids(lines: Lines, per_line: int = 8, field: str = "") -> list[int]:
    """All ids of the lines that are left, zeros left out.
    field: the name of a field with ids of their kind, for offsets."""
    ids: list[int] = []
    card = lines.card
    shift = card.change.shift_of(card.keyword, field)
    while lines:
        line = lines.take()
        texts = card.split(line, (10,) * per_line)
        if any(parse_integer(text) for text in texts[per_line:]):
            raise BadInput(card.at(line[0]), f"a line of *{card.keyword} has more than {per_line} ids "
                                             "(no more are read): put the others on the next line")
        for index, text in enumerate(texts[:per_line]):
            value = parse_integer(text) if text else 0
            if value is None:
                hint = "" if "," in line[1] else card.describe_columns(line[1], (10,) * per_line, index)
                raise BadInput(card.at(line[0]), f"'{clip(text)}' in *{card.keyword} is not an "
                                                 f"integer{hint or shift_hint(text)}: correct it")
            if value:
                ids.append(value + shift)
    return ids


Handler = Callable[..., None]
