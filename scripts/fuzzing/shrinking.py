"""Makes a failing scene smaller as long as it fails in the same way."""

import copy

from .scene import MATERIALS
from .shapes import kind_of

MOST_RUNS = 80


def shrink(deck, still_fails, most_runs=MOST_RUNS):
    """The smallest deck that was found. still_fails: of a deck, whether it fails as the first one did."""
    runs, shortest = 0, deck["time"]["end"] / 100
    found = True
    while found and runs < most_runs:
        found = False
        for smaller in _propose(deck, shortest):
            if runs >= most_runs:
                break
            runs += 1
            if still_fails(smaller):
                deck, found = smaller, True
                break
    return deck


def _propose(deck, shortest):
    """Smaller decks, the boldest first."""
    names = list(deck["parts"])
    half = len(names) // 2
    if half > 1:
        yield from (_without(deck, some) for some in (names[:half], names[half:]))
    if len(names) > 1:
        yield from (_without(deck, [name]) for name in names)
    for name, part in deck["parts"].items():
        if "array" in part and max(part["array"]["count"]) > 1:
            yield _changed(deck, name,
                           array={**part["array"], "count": [max(1, n // 2) for n in part["array"]["count"]]})
    for share in (0.5, 0.8):
        if share * deck["time"]["end"] >= shortest:
            yield {**deck, "time": {**deck["time"], "end": float(f"{share * deck['time']['end']:.3g}")}}
    for key in ("walls", "elements"):
        if key in deck:
            yield {other: value for other, value in deck.items() if other != key}
    for key in ("friction", "enforcement"):
        if key in deck["contact"]:
            yield {**deck, "contact": {other: value for other, value in deck["contact"].items() if other != key}}
    if any("angular_velocity" in entry for entry in deck["initial"]):
        plain = [{key: value for key, value in entry.items() if key != "angular_velocity"} for entry in deck["initial"]]
        yield {**deck, "initial": plain}
    yield from _propose_parts(deck)


def _propose_parts(deck):
    for name, part in deck["parts"].items():
        for simple in ("hard", "steel"):
            if part["material"] not in ("hard", simple):
                changed = _changed(deck, name, material=simple)
                used = {entry["material"] for entry in changed["parts"].values()}
                yield {**changed, "materials": {key: MATERIALS[key] for key in MATERIALS if key in used}}
        kind = kind_of(part)
        cells = part[kind]["cells"]
        least = {"cylinder": [3, 1], "tube": [1, 6, 1], "sphere": 4, "shell_tube": [8, 1], "shell_sphere": 2}
        low = least.get(kind, [1] * (len(cells) if isinstance(cells, list) else 1))
        coarser = max(low, cells // 2) if isinstance(cells, int) else [max(a, n // 2) for a, n in zip(low, cells)]
        if coarser != cells:
            yield _changed(deck, name, **{kind: {**part[kind], "cells": coarser}})


def _changed(deck, name, **values):
    return {**deck, "parts": {**deck["parts"], name: {**deck["parts"][name], **values}}}


def _without(deck, names):
    smaller = copy.deepcopy(deck)
    for name in names:
        del smaller["parts"][name]
    smaller["initial"] = [entry for entry in smaller["initial"] if entry["part"] not in names]
    used = {part["material"] for part in smaller["parts"].values()}
    smaller["materials"] = {name: value for name, value in smaller["materials"].items() if name in used}
    return smaller
