"""*CONSTRAINED_NODE_SET, *CONSTRAINED_LINEAR and _LINEAR_GLOBAL: nodes that move equally in some directions,
and equations of displacements."""

from ..fields import Row
from ..ledger import BadInput, Place, missing
from .cards import Card
from .deck import KeywordDeck
from .materials.rigid import DIRECTIONS
from .weld_cards import NEVER, list_rigid_nodes

LEFT_OUT = "its nodes are free"


def read_node_sets(deck: KeywordDeck, card: Card) -> None:
    """Kept until all nodes are known."""
    deck.equal_sets.append(card)


def add_node_sets(deck: KeywordDeck) -> None:
    for card in deck.equal_sets:
        if card.keyword == "CONSTRAINED_LINEAR":
            add_old_equations(deck, card)
        elif card.keyword == "CONSTRAINED_LINEAR_GLOBAL":
            add_equation(deck, card)
        else:
            add_node_set(deck, card)


def add_equation(deck: KeywordDeck, card: Card) -> None:
    """LCID, then NID DOF COEF of each term up to the next keyword."""
    reader = card.reader()
    head = reader.row("LCID")
    number = head.integer("LCID")
    head.finish(deck.ledger)
    terms = []
    while reader.skip_blank():
        row = reader.row("NID DOF COEF")
        terms.append((row, row.integer("NID"), row.integer("DOF"), row.number("COEF")))
        row.finish(deck.ledger)
    write_equation(deck, card, card.place, terms, number)


def add_old_equations(deck: KeywordDeck, card: Card) -> None:
    """NUM, then as many lines of a node, a 1 for each of its directions that takes part, and their factor;
    as often as there are lines."""
    reader = card.reader()
    while reader.skip_blank():
        head = reader.row("NUM")
        terms = []
        for _ in range(head.integer("NUM")):
            if not reader.skip_blank():
                head.fail("NUM", "there are fewer lines of nodes")
            row = reader.row("NID DOFX DOFY DOFZ DOFRX DOFRY DOFRZ COEF")
            ways = [row.number(f"DOF{way}") for way in ("X", "Y", "Z", "RX", "RY", "RZ")]
            if any(way not in (0, 1) for way in ways):
                row.fail("DOFX",
                         "1 for a direction that takes part, else 0, is expected in the second to seventh field")
            terms += [(row, row.integer("NID"), direction, row.number("COEF"))
                      for direction, way in enumerate(ways, 1) if way]
        head.finish(deck.ledger)
        write_equation(deck, card, head.place, terms)


def write_equation(deck: KeywordDeck, card: Card, place: Place, terms: list[tuple[Row, int, int, float]],
                   number: int = 0) -> None:
    """terms: row, node, direction from 1 on, factor."""
    for row, node, _, _ in terms:
        if node not in deck.nodes:
            raise BadInput(row.place, missing(f"node {node}"))
    turn = next((row for row, _, direction, _ in terms if direction not in (1, 2, 3)), None)
    nodes = [node for _, node, _, _ in terms]
    equation = [{"nodes": {"id": node}, "direction": "xyz"[direction - 1], "factor": factor}
                for _, node, direction, factor in terms if factor != 0 and not turn]
    if turn:
        deck.ledger.refuse(f"{card.keyword}.{'DOFRX' if turn.knows('DOFRX') else 'DOF'}", turn.place,
                           "an equation of rotations", LEFT_OUT)
    elif not equation:
        raise BadInput(place, "the equation has no term (a node, its direction and a factor): add one")
    elif list_rigid_nodes(deck) & set(nodes):
        deck.ledger.refuse(f"{card.keyword}.rigid", place, "an equation of nodes of rigid bodies", LEFT_OUT)
    elif not deck.used_nodes().issuperset(nodes):
        deck.ledger.refuse(f"{card.keyword}.free", place, "an equation of nodes without elements", LEFT_OUT)
    else:
        constraints = deck.model.deck.setdefault("constraints", {})
        constraints[deck.model.names.take(f"equation_{number or len(constraints) + 1}")] = {"equation": equation}
        deck.ledger.translated(card.keyword, place, "constraints")


def add_node_set(deck: KeywordDeck, card: Card) -> None:
    """NSID DOF TF; with _ID a line before."""
    reader = card.reader()
    while reader.next_card():
        id = reader.row("CNSID").integer("CNSID") if card.has_id else 0
        row = reader.row("NSID DOF TF")
        directions = DIRECTIONS.get(row.integer("DOF"), "")
        if not directions:
            raise BadInput(row.place, f"DOF is {row.integer('DOF')} (1 to 7 are directions): correct it")
        if 0 < row.number("TF") < NEVER:
            deck.ledger.refuse(f"{card.keyword}.TF", row.place, "a constraint that fails at a time", "it does not fail")
        nodes = list(deck.list_members("NODE", row.integer("NSID"), row.place))
        row.finish(deck.ledger)
        if list_rigid_nodes(deck) & set(nodes):
            deck.ledger.refuse(f"{card.keyword}.rigid", row.place,
                               "equal displacements of nodes of rigid bodies", LEFT_OUT)
            continue
        constraints = deck.model.deck.setdefault("constraints", {})
        name = deck.make_node_set(f"equal_{id or len(constraints) + 1}", nodes, row.place)
        if not name:
            deck.ledger.refuse(f"{card.keyword}.free", row.place,
                               "equal displacements of nodes without elements", LEFT_OUT)
            continue
        constraints[name] = {"equal": list("".join(sorted(directions))), "nodes": name}
        deck.ledger.translated(card.keyword, row.place, "constraints")
