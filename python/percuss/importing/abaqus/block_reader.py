"""All keywords of an Abaqus deck and of the files that it includes."""

import os
from collections.abc import Iterable, Iterator

from ..fields import clip
from ..ledger import BadInput, Ledger, Place, missing
from ..text_files import read_lines
from .lines import Block, Line
from .parameters import Parameters

MOST_OPEN, MOST_INCLUDED, SIZE_OF_NONE = 20, 2 << 30, 1 << 20  # files; bytes; what an empty file counts as


class BlockReader:
    """All keywords of a file and of those that it includes."""

    def __init__(self, path: str, ledger: Ledger):
        self._main, self._ledger = path, ledger
        self._folder = os.path.dirname(os.path.realpath(path))
        self._included = 0
        self._parameters = Parameters()

    def read(self) -> Iterator[Block]:
        """Data lines of an included file, and those behind its *INCLUDE,
        go on with the keyword that stands before it."""
        held: Block | None = None
        for block in self._read_file(self._main, self._main, 1):
            if block.keyword:
                if held:
                    yield held
                held = block
            elif held:
                held.lines += [(block.place.line, words) for _, words in block.lines]
            else:
                words = ", ".join(block.lines[0][1])
                raise BadInput(block.at(block.lines[0][0]),
                               f"'{clip(words)}' stands before any keyword (a deck begins with one): remove it")
        if held:
            yield held

    def _read_file(self, path: str, shown: str, depth: int) -> Iterator[Block]:
        for block in self._cut(path, shown):
            if block.keyword == "INCLUDE":
                yield from self._include(block, depth)
            elif block.keyword == "PARAMETER":
                self._parameters.read(block)
                self._ledger.translated("PARAMETER", block.place, "values are put in place")
            else:
                if "INPUT" in block.options:
                    block.lines += self._read_data(block)
                yield block

    def _cut(self, path: str, shown: str) -> Iterator[Block]:
        texts = read_lines(path, shown)
        block: Block | None = None
        for number, text in join_lines(texts):
            if "<" in text and not (block and block.keyword == "PARAMETER" and text[0] != "*"):
                text = self._parameters.put_in(text, Place(shown, number))
            if text.startswith("*"):
                if block:
                    yield block
                block = Block(*split_keyword(text), place=Place(shown, number))
                if not block.keyword:
                    raise BadInput(block.place, f"'{clip(text)}' has no keyword (one is expected behind '*'): "
                                                "name it, or remove the line")
            elif block:
                block.lines.append((number, [word.strip() for word in text.split(",")]))
            else:
                block = Block("", {}, Place(shown, number),
                              lines=[(number, [word.strip() for word in text.split(",")])])
        if block:
            yield block

    def _find(self, name: str, place: Place) -> str:
        path = os.path.realpath(os.path.join(self._folder, name.replace("\\", "/"))) if "\0" not in name else ""
        if not name or not os.path.isfile(path):
            raise BadInput(place, missing(f"file '{clip(name, 100)}'"))
        if os.path.commonpath([path, self._folder]) != self._folder and not self._ledger.allows("INCLUDE.outside"):
            raise BadInput(place, f"'{clip(name, 100)}' lies outside of the folder of the first file "
                                  "(--allow INCLUDE.outside reads it, if you trust the deck)")  # fmt: skip
        self._included += os.path.getsize(path) + SIZE_OF_NONE
        if self._included > MOST_INCLUDED:
            raise BadInput(place, f"the included files have more than {MOST_INCLUDED >> 30} GiB in all "
                                  "(the limit of the importer): divide the deck")
        self._ledger.files.add(path)
        return path

    def _include(self, block: Block, depth: int) -> Iterator[Block]:
        if depth >= MOST_OPEN:
            raise BadInput(block.place, "files include each other too deeply: remove the loop")
        path = self._find(block.options.get("INPUT", ""), block.place)
        self._ledger.translated("INCLUDE", block.place, "the file is read")
        shown = os.path.join(os.path.dirname(self._main), os.path.relpath(path, self._folder))
        for found in self._read_file(path, shown, depth + 1):
            yield found if found.keyword else Block("", {}, block.place, lines=found.lines)
        if block.lines:
            yield Block("", {}, block.place, lines=block.lines)

    def _read_data(self, block: Block) -> list[Line]:
        """Data lines of a file of their own."""
        path = self._find(block.options["INPUT"], block.place)
        lines = [(block.place.line, [word.strip() for word in text.split(",")])
                 for text in read_lines(path, block.place)]
        return [line for line in lines if any(line[1]) and not line[1][0].startswith("*")]


def join_lines(texts: Iterable[str]) -> Iterator[tuple[int, str]]:
    """Lines without comments; of a keyword that ends with a comma the next one is a part."""
    head, start = "", 0
    for number, raw in enumerate(texts, 1):
        text = raw.strip()
        if not text or text.startswith("**"):
            continue
        if not text.startswith("*") and head.endswith(","):
            head += text
            continue
        if head:
            yield start, head
        head, start = (text, number) if text.startswith("*") else ("", 0)
        if not head:
            yield number, text
    if head:
        yield start, head


def split_keyword(text: str) -> tuple[str, dict[str, str]]:
    """`*ELEMENT, TYPE=S4R, ELSET=a` as its name and options."""
    words = [word.strip() for word in text[1:].split(",")]
    options = {}
    for word in words[1:]:
        name, _, value = word.partition("=")
        if name.strip():
            options[" ".join(name.upper().split())] = value.strip().strip('"')
    return " ".join(words[0].upper().split()), options
