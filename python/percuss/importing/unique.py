"""Ids and names that a deck gives once, and where it gives them."""

from array import array
from collections.abc import Iterator

from .fields import clip
from .ledger import BadInput, Place


class Unique:
    """The definitions of a deck, each by its kind and its id or name.
    A second one is an error: nobody knows which of them counts."""

    def __init__(self) -> None:
        self._first: dict[tuple[str, "int | str", int], Place] = {}

    def claim(self, what: str, id: "int | str", place: Place, within: int = 0) -> None:
        """Notes a definition. what: its kind, in the plural; within: of what holds names of its own, such as a part."""
        first = self._first.get((what, id, within))
        if first is None:
            self._first[what, id, within] = place
            return
        words = ("ids", "renumber") if isinstance(id, int) else ("names", "rename")
        shown = id if isinstance(id, int) else f"'{clip(id)}'"
        raise BadInput(place, f"there are two {what} {shown} ({words[0]} must be unique; the first is at {first}): "
                              f"{words[1]} or remove one")

    def claim_only(self, what: str, place: Place) -> None:
        """Notes what a deck has once. what: in the singular and plural."""
        if (first := self._first.setdefault((what, 0, 0), place)) is not place:
            raise BadInput(place, f"there are two {what} (one can hold; the first is at {first}): remove one")


class Lines:
    """The line of each node or element of a mesh, in little memory: who asks for one is about to end with an error."""

    def __init__(self) -> None:
        self._of_files: dict[str, array[int]] = {}

    def note(self, place: Place, id: int) -> None:
        lines = self._of_files.setdefault(place.file, array("q"))
        lines.append(id)
        lines.append(place.line)

    def find(self, id: int) -> Place | None:
        """The first that is noted."""
        return next(self._list_places(id), None)

    def refuse_repeated(self, what: str) -> None:
        """An error where an id is noted twice. what: their kind, in the plural."""
        ids = [id for lines in self._of_files.values() for id in lines[::2]]
        if len(set(ids)) == len(ids):
            return
        seen: set[int] = set()
        repeated = next(id for id in ids if id in seen or seen.add(id))  # type: ignore[func-returns-value]
        first, second, *_ = self._list_places(repeated)
        raise BadInput(second, f"there are two {what} {repeated} (ids must be unique; the first is at {first}): "
                               "renumber or remove one")

    def _list_places(self, id: int) -> Iterator[Place]:
        for file, lines in self._of_files.items():
            yield from (Place(file, lines[index + 1]) for index in range(0, len(lines), 2) if lines[index] == id)
