"""*SPRING and *DASHPOT on elements between two nodes."""

from typing import Any

from ..ledger import BadInput, Ledger
from ..model import Deck
from .deck import AbaqusDeck
from .lines import Block
from .mesh import SPRINGS, Scope, SpringSet


def read_spring(scope: Scope, block: Block, ledger: Ledger) -> None:
    """*SPRING: a stiffness, or with NONLINEAR rows of force and elongation; *DASHPOT: a damping."""
    lines = [line for line in block.lines if any(line[1])]
    nonlinear = "NONLINEAR" in block.options
    if nonlinear and block.keyword == "DASHPOT":
        ledger.refuse("DASHPOT.NONLINEAR", block.place, "nonlinear dampers", "they are left out")
        return
    if not lines:
        raise BadInput(block.place, f"*{block.keyword} has no value: add its data line")
    if nonlinear:
        law: dict[str, Any] = {"table": make_table(block,
                                                   [(block.number(line, 1), block.number(line, 0)) for line in lines])}
    else:
        law = {"stiffness" if block.keyword == "SPRING" else "damping": block.number(lines[0], 0)}
    scope.springs.append(SpringSet(block.keyword, block.option("ELSET"), law, block.place))


def make_table(block: Block, rows: list[tuple[float, float]]) -> list[list[float]]:
    """Rows of elongation and force; the force stays as it is beyond them."""
    if len(rows) < 2 or any(a[0] >= b[0] for a, b in zip(rows, rows[1:])):
        raise BadInput(block.place, f"*{block.keyword} needs two rows or more, with elongations that ascend")
    width = rows[-1][0] - rows[0][0]
    ends = [(rows[0][0] - width, rows[0][1]), (rows[-1][0] + width, rows[-1][1])]
    return [list(row) for row in (ends[0], *rows, ends[1])]


def add_springs(deck: AbaqusDeck) -> None:
    """An entry of `springs` for each element."""
    for spring in deck.mesh.springs:
        if any(isinstance(value, float) and value <= 0 for value in spring.law.values()):
            deck.ledger.ignored(spring.keyword, spring.place, "it has no force")
            continue
        for id in deck.elements_of(spring.elements, spring.place):
            add_spring(deck, spring, id)
        deck.ledger.translated(spring.keyword, spring.place, "springs: one for each element")


def add_spring(deck: AbaqusDeck, spring: SpringSet, id: int) -> None:
    kind, nodes = deck.mesh.elements.get(id, ("", ()))
    if kind not in SPRINGS or len(nodes) != 2:
        deck.ledger.refuse(f"ELEMENT.{kind}", spring.place,
                           "springs other than SPRINGA and DASHPOTA", "they are left out")
    elif nodes[0] == nodes[1]:
        raise BadInput(spring.place, f"both ends of element {id} are node {nodes[0]}: correct it")
    elif not deck.used_nodes().issuperset(nodes):
        deck.ledger.refuse(spring.keyword, spring.place, "springs to nodes without elements", "they are left out")
    else:
        entry: Deck = {"between": [{"id": node} for node in nodes], **spring.law}
        deck.model.deck.setdefault("springs", {})[deck.model.names.take(f"spring_{id}")] = entry
