"""*EQUATION, *MPC PIN and TIE: nodes that move equally in some directions, and linear equations of displacements."""

from collections.abc import Sequence

from ..ledger import BadInput, Ledger
from ..model import Deck, Vector
from .bodies import WAYS
from .deck import AbaqusDeck
from .followers import note_equal
from .lines import Block
from .mesh import BodyCard, Scope
from .timeline import DISPLACEMENT, FIXED, Window, is_whole, join_displacements, values_of

LEFT_OUT = "its nodes are free"


def read_equations(scope: Scope, block: Block, ledger: Ledger) -> None:
    """A line with the number of terms, then terms of node or set, direction and factor, up to four in a line."""
    lines = iter(block.lines)
    for head in lines:
        count = block.integer(head, 0)
        if count < 1:
            raise BadInput(block.at(head[0]), "*EQUATION has no number of terms: correct it")
        terms: list[tuple[str, int, float]] = []
        for line in lines:
            # CAE writes one in a line
            width = min(4, count - len(terms), max(1, len([word for word in line[1] if word]) // 3))
            terms += [(block.text(line, 3 * i), block.integer(line, 3 * i + 1), block.number(line, 3 * i + 2))
                      for i in range(width)]
            if len(terms) == count:
                break
        else:
            raise BadInput(block.at(head[0]), "*EQUATION ends before its last term: correct it")
        add_equation(scope, terms, block, head[0], ledger)


def add_equation(scope: Scope, terms: list[tuple[str, int, float]], block: Block, number: int, ledger: Ledger) -> None:
    """Equal displacements of the same nodes are one constraint."""
    place = block.at(number)
    if any(direction not in (1, 2, 3) for _, direction, _ in terms):
        ledger.refuse("EQUATION", place, "an equation of rotations or other unknowns than displacements", LEFT_OUT)
        return
    is_equal = len(terms) == 2 and terms[0][1] == terms[1][1] and terms[0][2] == -terms[1][2] != 0
    if not is_equal:
        scope.bodies.append(BodyCard("EQUATION", place, terms[0][0], terms=[term for term in terms if term[2] != 0]))
        return
    (first, direction, _), (second, _, _) = terms
    for card in scope.bodies:
        if card.keyword == "EQUATION" and card.nodes == [first] and card.ref == second:
            card.equal = "".join(sorted({*card.equal, WAYS[direction - 1]}))
            return
    scope.bodies.append(BodyCard("EQUATION", place, second, nodes=[first], equal=WAYS[direction - 1]))


def add_equations(deck: AbaqusDeck) -> None:
    """An entry of `constraints` for each, or one for each line of nodes of an equation."""
    rigid = {node for group in deck.groups for node in group.nodes}
    rigid |= deck.model.nodes_of_blocks([block.id for block in deck.model.blocks if "rigid" in block.keys])
    turning = deck.model.turning_nodes()
    for card in deck.mesh.bodies:
        if card.terms:
            add_general(deck, card, rigid)
        if not card.equal:
            continue
        first, second = (deck.nodes_of(name, card.place) for name in (card.nodes[0], card.ref))
        nodes = {*first, *second}
        if deck.is_ring and card.equal != "y":
            deck.ledger.refuse(f"{card.keyword}.axisymmetric", card.place,
                               "equal radial displacements of axisymmetric elements", LEFT_OUT)
        if rigid & nodes:
            deck.ledger.refuse(f"{card.keyword}.rigid", card.place,
                               "equal displacements of nodes of rigid bodies", LEFT_OUT)
        elif note_equal(deck, card, first, second):
            continue
        elif not deck.used_nodes().issuperset(nodes):
            deck.ledger.refuse(f"{card.keyword}.free", card.place,
                               "equal displacements of nodes without elements", LEFT_OUT)
        else:
            if card.keyword == "MPC.TIE" and turning & nodes:
                deck.ledger.refuse(card.keyword, card.place, "equal rotations of nodes",
                                   "their displacements alone are equal")
            add_constraint(deck, card, first, second)


def add_constraint(deck: AbaqusDeck, card: BodyCard, first: list[int], second: list[int]) -> None:
    constraints = deck.model.deck.setdefault("constraints", {})
    entry: Deck = {"equal": list(card.equal)}
    name = deck.model.names.take(f"equal_{len(constraints) + 1}")
    if len(first) == len(second) == 1:
        entry["between"] = [{"id": first[0]}, {"id": second[0]}]
    elif len(second) == 1:
        entry["nodes"] = deck.model.add_node_set(f"{name}_nodes", [*first, *second])
    elif len(first) == len(second):
        entry["between"] = [deck.model.add_node_set(f"{name}_{i}", nodes) for i, nodes in ((1, first), (2, second))]
        deck.ledger.approximated(card.keyword, card.place,
                                 "constraints: counterparts of two sets are found by their places, not by their order")
    else:
        deck.ledger.refuse(card.keyword, card.place, "equal displacements of sets of different sizes", LEFT_OUT)
        return
    constraints[name] = entry
    deck.ledger.translated(card.keyword, card.place, "constraints")


def add_general(deck: AbaqusDeck, card: BodyCard, rigid: set[int]) -> None:
    """An equation of any terms. A node without elements takes part where its motion is prescribed."""
    sides = [deck.nodes_of(name, card.place) for name, _, _ in card.terms]
    nodes = {node for side in sides for node in side}
    if deck.is_ring:
        deck.ledger.refuse("EQUATION.axisymmetric", card.place, "an equation of axisymmetric elements", LEFT_OUT)
    elif any(len(side) not in (1, len(sides[0])) for side in sides):
        deck.ledger.refuse("EQUATION", card.place, "an equation of sets of different sizes", LEFT_OUT)
    elif rigid & nodes:
        deck.ledger.refuse("EQUATION.rigid", card.place, "an equation of nodes of rigid bodies", LEFT_OUT)
    elif deck.used_nodes().issuperset(nodes):
        keep_general(deck, card, sides)
    else:
        deck.leaders |= nodes - deck.used_nodes()
        deck.driven_equations.append((card, sides))


def add_driven(deck: AbaqusDeck) -> None:
    """Equations of nodes without elements, once the motions of these are known."""
    for card, sides in deck.driven_equations:
        keep_general(deck, card, sides)
    for target in [target for target in deck.motions.windows if target[0] in deck.leaders]:
        deck.motions.windows.pop(target)


def keep_general(deck: AbaqusDeck, card: BodyCard, sides: list[list[int]]) -> None:
    used = deck.used_nodes()
    terms, points = [], None
    for side, (_, direction, factor) in zip(sides, card.terms, strict=True):
        if used.issuperset(side):
            terms.append((side, "xyz"[direction - 1], factor))
            continue
        windows = deck.motions.windows.get((side[0], "xyz"[direction - 1]), []) if len(side) == 1 else []
        kinds = {window.action.kind for window in windows}
        if (not windows or not is_whole(windows, deck.end_time) or not kinds <= {FIXED, DISPLACEMENT}
                or (kinds != {FIXED} and points)):
            deck.ledger.refuse("EQUATION.free", card.place,
                               "an equation of a node without elements, unless its displacement is prescribed, "
                               "of one such node alone", LEFT_OUT)
            return
        if kinds != {FIXED}:
            points = find_sum(windows, factor)
    if not terms:
        deck.ledger.refuse("EQUATION.free", card.place, "an equation of nodes without elements", LEFT_OUT)
        return
    add_entries(deck, card, terms, None if points is None else values_of(points, card.place, deck.end_time))


def find_sum(windows: list[Window], factor: float) -> list[tuple[float, float]]:
    """What the other terms have as sum."""
    return [(time, -factor * value) for time, value in join_displacements(windows)]


def add_entries(deck: AbaqusDeck, card: BodyCard, terms: list[tuple[list[int], str, float]],
                total: "float | Deck | None") -> None:
    """One entry where each node of the first term has the node of the same row as its counterpart by
    place; otherwise one a row."""
    constraints = deck.model.deck.setdefault("constraints", {})
    count = max(len(side) for side, _, _ in terms)
    longest = next(side for side, _, _ in terms if len(side) == count)
    terms = sorted(terms, key=lambda term: len(term[0]) != count)  # a term of all nodes is the first
    name = deck.model.names.take(f"equation_{len(constraints) + 1}")
    if count > 1 and all(len(side) == 1 or are_counterparts(deck.model.nodes, longest, side) for side, _, _ in terms):
        constraints[name] = make_entry(
            [({"id": side[0]} if len(side) == 1 else deck.model.add_node_set(f"{name}_{i}", side), way, factor)
             for i, (side, way, factor) in enumerate(terms)], total)  # fmt: skip
    else:
        for row in range(count):
            of_row = [({"id": side[row % len(side)]}, way, factor) for side, way, factor in terms]
            constraints[name if count == 1 else deck.model.names.take(f"{name}_{row + 1}")] = make_entry(of_row, total)
    deck.ledger.translated("EQUATION", card.place, "constraints")


def make_entry(terms: "Sequence[tuple[str | Deck, str, float]]", total: "float | Deck | None") -> Deck:
    entry: Deck = {"equation": [{"nodes": nodes, "direction": way, "factor": factor} for nodes, way, factor in terms]}
    return entry if total is None else {**entry, "sum": total}


def are_counterparts(places: dict[int, Vector], first: list[int], second: list[int]) -> bool:
    """Whether each node lies where its counterpart and the mean places of both let expect it, and so is found again."""
    if len(set(first)) < len(first) or len(set(second)) < len(second):
        return False
    means = [[sum(places[node][k] for node in nodes) / len(nodes) for k in range(3)] for nodes in (first, second)]
    shift = [b - a for a, b in zip(*means, strict=True)]
    size = max(abs(places[node][k] - means[0][k]) for node in first for k in range(3)) or 1.0
    return all(abs(places[b][k] - places[a][k] - shift[k]) < 1e-4 * size / len(first)
               for a, b in zip(first, second, strict=True) for k in range(3))
