"""The name that a user may have meant."""

from __future__ import annotations

import difflib
from collections.abc import Iterable

ALIKE, A_LITTLE, SHORTEST_PIECE = 0.75, 0.5, 3


def find_nearest(word: str, names: Iterable[str]) -> str | None:
    """A name with few other letters, else the shortest that has the word in it,
    else one that is a little like it; None."""
    names = list(names)
    if near := difflib.get_close_matches(word, names, 1, ALIKE):
        return near[0]
    if inside := [name for name in names if len(word) >= SHORTEST_PIECE and word.lower() in name.lower()]:
        return min(inside, key=len)
    return next(iter(difflib.get_close_matches(word, names, 1, A_LITTLE)), None)


def suggest(word: str, names: Iterable[str], otherwise: str = "") -> str:
    """'; did you mean x?', or what is said otherwise."""
    near = find_nearest(word, names)
    return f"; did you mean {near}?" if near else otherwise
