"""*EQUATION of two terms, *MPC PIN and TIE: nodes that move equally in some directions."""

from ..ledger import BadInput, Ledger
from ..model import Deck
from .bodies import WAYS
from .deck import AbaqusDeck
from .followers import note_equal
from .lines import Block
from .mesh import BodyCard, Scope

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
            width = min(4, count - len(terms), max(1, len([word for word in line[1] if word]) // 3))  # CAE writes one in a line
            terms += [(block.text(line, 3 * i), block.integer(line, 3 * i + 1), block.number(line, 3 * i + 2)) for i in range(width)]
            if len(terms) == count:
                break
        else:
            raise BadInput(block.at(head[0]), "*EQUATION ends before its last term: correct it")
        add_equation(scope, terms, block, head[0], ledger)


def add_equation(scope: Scope, terms: list[tuple[str, int, float]], block: Block, number: int, ledger: Ledger) -> None:
    """Equal displacements; equations of the same nodes are one constraint."""
    place = block.at(number)
    is_equal = len(terms) == 2 and terms[0][1] == terms[1][1] and 1 <= terms[0][1] <= 3 and terms[0][2] == -terms[1][2] != 0
    if not is_equal:
        ledger.refuse("EQUATION", place, "an equation other than that of two equal displacements", LEFT_OUT)
        return
    (first, direction, _), (second, _, _) = terms
    for card in scope.bodies:
        if card.keyword == "EQUATION" and card.nodes == [first] and card.ref == second:
            card.equal = "".join(sorted({*card.equal, WAYS[direction - 1]}))
            return
    scope.bodies.append(BodyCard("EQUATION", place, second, nodes=[first], equal=WAYS[direction - 1]))


def add_equations(deck: AbaqusDeck) -> None:
    """An entry of `constraints` for each."""
    rigid = {node for group in deck.groups for node in group.nodes}
    rigid |= deck.model.nodes_of_blocks([block.id for block in deck.model.blocks if "rigid" in block.keys])
    turning = deck.model.turning_nodes()
    for card in deck.mesh.bodies:
        if not card.equal:
            continue
        first, second = (deck.nodes_of(name, card.place) for name in (card.nodes[0], card.ref))
        nodes = {*first, *second}
        if deck.is_ring and card.equal != "y":
            deck.ledger.refuse(f"{card.keyword}.axisymmetric", card.place, "equal radial displacements of axisymmetric elements", LEFT_OUT)
        if rigid & nodes:
            deck.ledger.refuse(f"{card.keyword}.rigid", card.place, "equal displacements of nodes of rigid bodies", LEFT_OUT)
        elif note_equal(deck, card, first, second):
            continue
        elif not deck.used_nodes().issuperset(nodes):
            deck.ledger.refuse(f"{card.keyword}.free", card.place, "equal displacements of nodes without elements", LEFT_OUT)
        else:
            if card.keyword == "MPC.TIE" and turning & nodes:
                deck.ledger.refuse(card.keyword, card.place, "equal rotations of nodes", "their displacements alone are equal")
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
        deck.ledger.approximated(card.keyword, card.place, "constraints: counterparts of two sets are found by their places, not by their order")
    else:
        deck.ledger.refuse(card.keyword, card.place, "equal displacements of sets of different sizes", LEFT_OUT)
        return
    constraints[name] = entry
    deck.ledger.translated(card.keyword, card.place, "constraints")
