"""*CONSTRAINED_NODE_SET and *CONSTRAINED_LINEAR_GLOBAL: nodes that move equally in some directions, and equations of displacements."""

from ..ledger import BadInput, missing
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
        if card.keyword.startswith("CONSTRAINED_LINEAR"):
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
    nodes = []
    while reader.skip_blank():
        row = reader.row("NID DOF COEF")
        node, direction, factor = row.integer("NID"), row.integer("DOF"), row.number("COEF")
        row.finish(deck.ledger)
        if node not in deck.nodes:
            raise BadInput(row.place, missing(f"node {node}"))
        if direction not in (1, 2, 3):
            deck.ledger.refuse(f"{card.keyword}.DOF", row.place, "an equation of rotations", LEFT_OUT)
            return
        nodes.append(node)
        if factor != 0:
            terms.append({"nodes": {"id": node}, "direction": "xyz"[direction - 1], "factor": factor})
    if not terms:
        raise BadInput(card.place, "the equation has no term (NID DOF COEF): add one")
    if list_rigid_nodes(deck) & set(nodes):
        deck.ledger.refuse(f"{card.keyword}.rigid", card.place, "an equation of nodes of rigid bodies", LEFT_OUT)
    elif not deck.used_nodes().issuperset(nodes):
        deck.ledger.refuse(f"{card.keyword}.free", card.place, "an equation of nodes without elements", LEFT_OUT)
    else:
        constraints = deck.model.deck.setdefault("constraints", {})
        constraints[deck.model.names.take(f"equation_{number or len(constraints) + 1}")] = {"equation": terms}
        deck.ledger.translated(card.keyword, card.place, "constraints")


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
            deck.ledger.refuse(f"{card.keyword}.rigid", row.place, "equal displacements of nodes of rigid bodies", LEFT_OUT)
            continue
        constraints = deck.model.deck.setdefault("constraints", {})
        name = deck.make_node_set(f"equal_{id or len(constraints) + 1}", nodes, row.place)
        if not name:
            deck.ledger.refuse(f"{card.keyword}.free", row.place, "equal displacements of nodes without elements", LEFT_OUT)
            continue
        constraints[name] = {"equal": list("".join(sorted(directions))), "nodes": name}
        deck.ledger.translated(card.keyword, row.place, "constraints")
