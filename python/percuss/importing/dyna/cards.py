"""Cards of keyword decks: fields in columns or between commas."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import accumulate

from ..fields import Row, clip, describe_columns, find_cut_number, parse_integer, shift_hint
from ..ledger import BadInput, Place
from .parameters import Parameters
from .transforms import UNCHANGED, FileChange

HEADING = 70  # columns of a text


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
