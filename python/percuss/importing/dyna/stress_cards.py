"""*INITIAL_STRESS_SHELL and _SOLID: tables of start.fields."""

import math
from collections.abc import Iterator

from ..fields import Row
from ..laws import takes_plastic_strain, takes_stress
from ..ledger import Place
from ..model import Block
from .cards import Card, Lines
from .deck import KeywordDeck

STRESS = ("SIGXX", "SIGYY", "SIGZZ", "SIGXY", "SIGYZ", "SIGZX")
QUANTITIES = "stress_xx,stress_yy,stress_zz,stress_xy,stress_yz,stress_zx,equivalent_plastic_strain"
MOST_LINES = 10**6  # of one element
SAME_POINT = 1e-4  # distance of places across a shell, from -1 to 1

Values = list[float]
Points = list[tuple[float, Values]]  # the place across a shell, and what is there


def mean(rows: list[Values]) -> Values:
    return [math.fsum(column) / len(rows) for column in zip(*rows, strict=True)]


def write(values: Values) -> str:
    return ",".join(repr(value) for value in values)


def read_stresses(deck: KeywordDeck, card: Card) -> None:
    """A first line for each element, then one for each of its points."""
    if card.keyword not in ("INITIAL_STRESS_SHELL", "INITIAL_STRESS_SOLID"):
        deck.ledger.refuse(card.keyword, card.place, "stresses of sets or of other elements",
                           "they begin without stress")
        return
    of_shells = card.keyword == "INITIAL_STRESS_SHELL"
    shift = deck.shell_shift if of_shells else 0
    blocks = {id: block for block in deck.model.blocks for id, _ in (block.shells if of_shells else block.solids)}
    ten_nodes = {id for block in deck.model.blocks
                 for id, corners in block.solids if len(corners) == 10 and not of_shells}
    reader = card.reader()
    while reader.skip_blank():
        row = reader.row("EID NPLANE NTHICK NHISV NTENSR LARGE NTHINT NTHHSV" if of_shells
                         else "EID NINT NHISV LARGE IVEFLG IALEGP NTHINT NTHHSV")
        if has_other_lines(deck, card, row, of_shells):
            return
        points = read_points(reader, row, of_shells)
        id = row.integer("EID") + shift
        row.finish(deck.ledger)
        if id not in blocks:
            deck.ledger.refuse(f"{card.keyword}.EID", row.place,
                               "stresses of elements that are not in the mesh", "they are left out")
        elif id in ten_nodes:
            if has_values(points):
                deck.ledger.refuse(f"{card.keyword}.ten_nodes", row.place, "stresses of tetrahedra of ten nodes",
                                   "they begin without stress")
        elif may_begin_so(deck, card, row.place, points, blocks[id]):
            if of_shells:
                add_shell(deck, id, points, blocks[id])
            else:
                add_solid(deck, card, row.place, id, points)
    deck.ledger.translated(card.keyword, card.place, "start.fields: a table of stresses and plastic strains")


def has_values(points: Points) -> bool:
    return any(any(values) for _, values in points)


def may_begin_so(deck: KeywordDeck, card: Card, place: Place, points: Points, block: Block) -> bool:
    """Whether an element has a row; its plastic strains become 0 where its law has none."""
    if not takes_stress(deck.model, block):
        if has_values(points):
            deck.ledger.refuse(
                f"{card.keyword}.material", place,
                "stresses of rigid parts, or of a law whose stress does not grow in increments",
                "they begin without stress and plastic strain",
            )  # fmt: skip
        return False
    if not takes_plastic_strain(deck.model, block):
        if any(values[6] for _, values in points):
            deck.ledger.refuse(f"{card.keyword}.EPS", place, "plastic strains of a law without them",
                               "they begin without plastic strain")
        for _, values in points:
            values[6] = 0.0
    return True


def has_other_lines(deck: KeywordDeck, card: Card, row: Row, of_shells: bool) -> bool:
    """Refuses forms whose lines are others."""
    for name in ("LARGE", "NHISV", *(["NTENSR"] if of_shells else []), "NTHINT", "NTHHSV"):
        if row.integer(name):
            deck.ledger.refuse(f"{card.keyword}.{name}", row.place, f"{name} is {row.integer(name)}",
                               "the rest of the card is left out")
            return True
    return False


def read_points(reader: Lines, row: Row, of_shells: bool) -> Points:
    """The place across the shell, and stresses and plastic strain there."""
    names = ("NPLANE", "NTHICK") if of_shells else ("NINT",)
    count = math.prod(max(row.integer(name), 1) for name in names)
    if count > MOST_LINES:
        row.fail(names[-1], f"at most {MOST_LINES} points are read")
    points = []
    for _ in range(count):
        line = reader.row("T SIGXX SIGYY SIGZZ SIGXY SIGYZ SIGZX EPS" if of_shells
                          else "SIGXX SIGYY SIGZZ SIGXY SIGYZ SIGZX EPS")
        points.append((line.number("T") if of_shells else 0.0, line.numbers(*STRESS, "EPS")))
    return points


def add_solid(deck: KeywordDeck, card: Card, place: Place, id: int, points: Points) -> None:
    values = mean([values for _, values in points])
    deck.model.add_start_rows("solid_stresses.csv", f"element,{QUANTITIES}", {id: [f"{id},{write(values)}"]})
    if len(points) > 1:
        deck.ledger.approximated(f"{card.keyword}.NINT", place, "the mean of all points of an element")


def add_shell(deck: KeywordDeck, id: int, points: Points, block: Block) -> None:
    """A row for each layer, between and beyond the points of the card along straight lines."""
    levels = merge_levels(points)
    places = find_gauss_points(block.keys.get("points", 1))
    rows = [f"{id},{layer},{write(interpolate(levels, place))}" for layer, place in enumerate(places, 1)]
    deck.model.add_start_rows("shell_stresses.csv", f"element,layer,{QUANTITIES}", {id: rows})
    if len(levels) > 1 and not fits(levels, places):
        deck.ledger.approximated("INITIAL_STRESS_SHELL.T", block.place,
                                 "stresses of the layers from straight lines between the points of the card")


def merge_levels(points: Points) -> Points:
    """Points from bottom to top; points of one place across are one."""
    levels: list[tuple[float, list[Values]]] = []
    for place, values in sorted(points, key=lambda point: point[0]):
        if not levels or place - levels[-1][0] > SAME_POINT:
            levels.append((place, []))
        levels[-1][1].append(values)
    return [(place, mean(rows)) for place, rows in levels]


def fits(levels: Points, places: list[float]) -> bool:
    return len(levels) == len(places) and all(abs(a - b) < SAME_POINT for (a, _), b in zip(levels, places, strict=True))


def interpolate(levels: Points, place: float) -> Values:
    """Stresses go on beyond the outer points; a plastic strain does not fall below 0."""
    if len(levels) == 1 or abs(place - levels[0][0]) < SAME_POINT:
        return levels[0][1]
    for (low, below), (high, above) in zip(levels, levels[1:], strict=False):
        if place < high - SAME_POINT or high == levels[-1][0]:
            share = (place - low) / (high - low)
            if abs(place - high) < SAME_POINT:
                share = 1.0
            values = [a + share * (b - a) for a, b in zip(below, above, strict=True)]
            return [*values[:6], max(values[6], 0.0)]
    return levels[-1][1]


def find_gauss_points(count: int) -> list[float]:
    """Places of the Gauss-Legendre rule from -1 to 1, as percuss has them across a shell."""
    return sorted(_roots(count))


def _roots(count: int) -> Iterator[float]:
    for i in range(count):
        z = math.cos(math.pi * (i + 0.75) / (count + 0.5))
        for _ in range(50):
            before, value = 0.0, 1.0
            for j in range(count):
                before, value = value, ((2 * j + 1) * z * value - j * before) / (j + 1)
            slope = count * (z * value - before) / (z * z - 1)
            z -= value / slope
        yield 0.0 if 2 * i + 1 == count else z
