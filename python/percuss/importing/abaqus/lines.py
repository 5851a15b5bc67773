"""Keywords of Abaqus decks with their options and data lines."""

from dataclasses import dataclass, field

from ..fields import MOST_ID, clip, parse_integer, parse_real
from ..ledger import BadInput, Place

Line = tuple[int, list[str]]  # its number and its words


@dataclass
class Block:
    """A keyword with its options and its data lines."""

    keyword: str  # in capitals, one blank between words
    options: dict[str, str]  # names in capitals; a flag is ""
    place: Place
    step: int = 0  # in which it stands; 0: before the first
    lines: list[Line] = field(default_factory=list)

    def at(self, number: int) -> Place:
        return Place(self.place.file, number)

    def option(self, name: str) -> str:
        """A value of an option in capitals, empty where it is not given."""
        return self.options.get(name, "").upper()

    def number(self, line: Line, index: int, default: float = 0.0) -> float:
        """A number of a data line; a default where it is blank."""
        text = line[1][index] if index < len(line[1]) else ""
        value = parse_real(text) if text else default
        if value is None:
            raise BadInput(self.at(line[0]), f"'{clip(text)}' in *{self.keyword} is not a number: correct it")
        return value

    def integer(self, line: Line, index: int, default: int = 0) -> int:
        text = line[1][index] if index < len(line[1]) else ""
        value = parse_integer(text) if text else default
        if value is None:
            raise BadInput(self.at(line[0]), f"'{clip(text)}' in *{self.keyword} is not an integer: correct it")
        return value

    def id(self, line: Line, index: int) -> int:
        value = self.integer(line, index)
        if not 1 <= value <= MOST_ID:
            raise BadInput(self.at(line[0]), f"'{value}' in *{self.keyword} is not an id (1 to 10^15): correct it")
        return value

    def text(self, line: Line, index: int) -> str:
        return line[1][index] if index < len(line[1]) else ""


def require_line(block: Block) -> Line:
    if not block.lines:
        raise BadInput(block.place, f"*{block.keyword} has no data line: add it")
    return block.lines[0]
