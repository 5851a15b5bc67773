"""*CONSTRAINED_NODE_SET: nodes that move equally in some directions."""

from ..ledger import BadInput
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
        add_node_set(deck, card)


def add_node_set(deck: KeywordDeck, card: Card) -> None:
    """NSID DOF TF; with _ID a line before."""
    reader = card.reader()
    while reader.skip_blank():
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
