"""Sections, *HOURGLASS and rules of integration that no part uses, and those of which their parts say nothing."""

from collections.abc import Iterator

from ..ledger import Place
from .deck import KeywordDeck

OF_PARTS = "what its parts are made of"


def note_definitions(deck: KeywordDeck) -> None:
    """An entry for each definition without one."""
    for card, place, last, fate in list_definitions(deck):
        if fate:
            deck.ledger.ignored(card, place, fate)
        elif not deck.ledger.tells_of(place, last):
            deck.ledger.translated(card, place, OF_PARTS)


def list_definitions(deck: KeywordDeck) -> Iterator[tuple[str, Place, int, str]]:
    """Keyword, first and last line, and why it is without effect; empty: parts with elements use it."""
    parts = deck.parts.values()
    sections = {part.section: part.id in deck.elements
                for part in sorted(parts, key=lambda part: part.id in deck.elements)}
    controls = {part.hourglass: part.id in deck.elements
                for part in sorted(parts, key=lambda part: part.id in deck.elements)}
    for id, section in deck.sections.items():
        yield section.keyword, section.place, section.lines[-1][0], judge(sections.get(id))
    for id, row in deck.hourglass.items():
        fate = judge(controls.get(id))
        if not fate and not deck.ledger.tells_of(row.place, row.place.line):
            fate = "its parts have no elements with hourglass modes"
        yield row.card, row.place, row.place.line, fate
    for row, sizes in deck.rules.values():
        last = sizes.place.line if sizes else row.place.line
        yield row.card, row.place, last, "" if deck.ledger.tells_of(row.place, last) else "no section of beams uses it"
    for id, material in deck.materials.items():
        if ("material", id) in deck.used:
            yield material.keyword, material.place, material.lines[-1][0], ""


def judge(has_elements: bool | None) -> str:
    """Why a definition is without effect. has_elements: of a part that uses it; None: no part does."""
    return ("no part uses it" if has_elements is None else "" if has_elements
            else "no element is of the parts that use it")
