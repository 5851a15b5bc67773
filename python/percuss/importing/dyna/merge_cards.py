"""*NODE_MERGE_SET and *NODE_MERGE_TOLERANCE: nodes of sets that lie at one place become one."""

import math
from collections.abc import Callable
from dataclasses import replace
from itertools import product

from ..model import Vector
from .cards import Card
from .deck import Elements, KeywordDeck
from .joint_cards import find_extent

CARD = "NODE_MERGE_SET"
# Tolerance where none is given, as a share of the extent of the model over the cube root of its number of nodes.
USUAL = 1e-5


def read_merged_sets(deck: KeywordDeck, card: Card) -> None:
    """An id of a set on each line."""
    reader = card.reader()
    while reader.skip_blank():
        deck.merged_sets.append(reader.row("NSID"))


def read_merge_tolerance(deck: KeywordDeck, card: Card) -> None:
    row = card.reader().row("TOLR")
    deck.merge_tolerance = row.positive("TOLR")
    deck.ledger.translated(card.keyword, card.place, "the distance of nodes that become one")


def merge_nodes(deck: KeywordDeck) -> None:
    """Merges nodes within the tolerance: the one with the lowest id stays.
    Elements and sets get it in place of the others, which are gone."""
    for row in deck.merged_sets:
        members = [node for node in deck.list_members("NODE", row.integer("NSID"), row.place) if node in deck.nodes]
        tolerance = deck.merge_tolerance or USUAL * find_extent(deck) / len(deck.nodes) ** (1 / 3)
        merged = find_merged(deck, sorted(members), tolerance)
        for node in merged:
            del deck.nodes[node]
        deck.forget_sorted()
        for elements in deck.elements.values():
            rename_corners(elements, lambda node, merged=merged: merged.get(node, node))  # type: ignore[misc]
        for (kind, _), found in deck.sets.items():
            if kind == "NODE":
                found.ids = list(dict.fromkeys(merged.get(node, node) for node in found.ids))
            found.segments = [tuple(merged.get(node, node) for node in face) for face in found.segments]
        text = f"{len(merged)} nodes are one with others within {tolerance:.3g}"
        if deck.merge_tolerance:
            deck.ledger.translated(CARD, row.place, text)
        else:
            deck.ledger.approximated(CARD, row.place, text + ", a tolerance of percuss")


def find_merged(deck: KeywordDeck, nodes: list[int], tolerance: float) -> dict[int, int]:
    """The node that stays in place of each that is gone."""
    merged: dict[int, int] = {}
    kept: dict[tuple[int, ...], list[int]] = {}
    for node in nodes:
        place = deck.nodes[node]
        cell = find_cell(place, tolerance)
        near = (other for step in product((-1, 0, 1), repeat=3)
                for other in kept.get(tuple(c + s for c, s in zip(cell, step)), ()))
        found = min((other for other in near if math.dist(place, deck.nodes[other]) <= tolerance), default=None)
        if found is None:
            kept.setdefault(cell, []).append(node)
        else:
            merged[node] = found
    return merged


def find_cell(place: Vector, size: float) -> tuple[int, ...]:
    return tuple(math.floor(c / size) for c in place)


def rename_corners(elements: Elements, name: Callable[[int], int]) -> None:
    elements.solids = [(id, tuple(map(name, corners))) for id, corners in elements.solids]
    elements.shells = [replace(shell, corners=tuple(map(name, shell.corners))) for shell in elements.shells]
    elements.beams = [replace(beam, ends=tuple(map(name, beam.ends)), third=name(beam.third))
                      for beam in elements.beams]
