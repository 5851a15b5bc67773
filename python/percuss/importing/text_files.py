"""Text files of other programs, and words that are written almost like known ones."""

import difflib
from collections.abc import Iterable

from .fields import clip
from .ledger import BadInput, Place

MARK = b"\xef\xbb\xbf"  # byte order mark of UTF-8
WIDE_MARKS = (b"\xff\xfe", b"\xfe\xff")  # of UTF-16


def read_lines(path: str, place: "Place | str") -> list[str]:
    """Lines of a text in UTF-8 or an encoding of one byte a character, whatever its line ends are."""
    with open(path, "rb") as file:
        data = file.read()
    if data.startswith(WIDE_MARKS) or data[1:40:2].count(0) > 10:
        raise BadInput(place, "the file is text in UTF-16 (two bytes a character): save it as UTF-8 or ASCII")
    text = data.removeprefix(MARK).decode("utf-8", "replace")
    if "\r" in text:
        text = text.replace("\r\n", "\n").replace("\r", "\n")
    return text.split("\n")


def find_similar(word: str, known: Iterable[str]) -> str:
    """The known word that a misspelt one is nearest to; empty where none is near."""
    found = difflib.get_close_matches(word, list(known), 1, 0.85)
    return found[0] if found and found[0] != word else ""


def suggest(word: str, known: Iterable[str]) -> str:
    """The reason in a message that a keyword is not known: ' (did you mean *X?)', or nothing."""
    found = find_similar(word, known)
    return f" (did you mean *{found}?)" if found else ""


def suggest_place(wanted: str, unknown: "Iterable[tuple[str, Place]]") -> str:
    """What to do where a keyword is missing: add it, or correct the unknown one that is written almost like it."""
    for word, place in unknown:
        if difflib.SequenceMatcher(None, word, wanted).ratio() >= 0.85:
            return f"did you mean *{clip(word)} in line {place.line}?"
    return ""
