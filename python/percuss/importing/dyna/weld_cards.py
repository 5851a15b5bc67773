"""*CONSTRAINED_SPOTWELD, _RIVET and _GENERALIZED_WELD_SPOT: pairs of nodes that move as one until they fail."""

from ..fields import Row
from ..ledger import BadInput, Place
from ..model import Deck
from .cards import Card, Lines
from .deck import KeywordDeck

LEFT_OUT = "these welds are left out"
NEVER = 1e19  # LS-DYNA's defaults of what never fails are above this


def read_welds(deck: KeywordDeck, card: Card) -> None:
    """Kept until all nodes are known."""
    deck.welds.append(card)


def add_welds(deck: KeywordDeck) -> None:
    deck.rigid_ends = list_rigid_nodes(deck) if deck.welds else set()
    for card in deck.welds:
        keyword = card.keyword
        if keyword in ("CONSTRAINED_SPOTWELD", "CONSTRAINED_RIVET"):
            add_pairs(deck, card)
        elif keyword == "CONSTRAINED_GENERALIZED_WELD_SPOT":
            add_general(deck, card)
        else:
            deck.ledger.refuse(keyword, card.place, "this form of welds is not read", LEFT_OUT)


def add_pairs(deck: KeywordDeck, card: Card) -> None:
    """N1 N2 SN SS N M TF EP, of a rivet N1 N2 TF; with _ID a line before."""
    is_rivet = "RIVET" in card.keyword
    reader = card.reader()
    while reader.next_card():
        id = read_id(reader) if card.has_id else 0
        row = reader.row("N1 N2 TF" if is_rivet else "N1 N2 SN SS N M TF EP")
        failure: Deck = {} if is_rivet else read_strengths(row)
        add_time(row, "TF", failure)
        if not is_rivet:
            refuse_strain(deck, row, "EP")
        nodes = (row.integer("N1"), row.integer("N2"))
        row.finish(deck.ledger)
        add_weld(deck, nodes, failure, row.place, id)
        deck.ledger.translated(card.keyword, row.place, "welds: one for each pair")


def add_general(deck: KeywordDeck, card: Card) -> None:
    """NSID CID FILTER WINDOW NPR NPRT, then TFAIL EPSF SN SS N M: the nodes of a set, by pairs."""
    reader = card.reader()
    while reader.next_card(of_lines=True):
        id = read_id(reader) if card.has_id else 0
        row = reader.row("NSID CID FILTER WINDOW NPR~absent NPRT~output")
        if row.integer("CID"):
            deck.ledger.refuse(f"{card.keyword}.CID", row.place, "axes of its own",
                               "the normal is the line between its nodes")
        limits = reader.row("TFAIL EPSF SN SS N M")
        set_id = row.integer("NSID")
        row.finish(deck.ledger, "forces are not filtered")
        failure = read_strengths(limits)
        add_time(limits, "TFAIL", failure)
        refuse_strain(deck, limits, "EPSF")
        limits.finish(deck.ledger)
        nodes = list(deck.list_members("NODE", set_id, row.place))
        if len(nodes) < 2:
            raise BadInput(row.place, f"set {set_id} of a weld has fewer than two nodes")
        if len(nodes) > 2:
            deck.ledger.approximated(card.keyword, row.place, "welds: each node of the set with the next one")
        else:
            deck.ledger.translated(card.keyword, row.place, "welds: one for each pair")
        for first, second in zip(nodes, nodes[1:]):
            add_weld(deck, (first, second), dict(failure), row.place, id)


def read_id(reader: Lines) -> int:
    return reader.row("WID").integer("WID")


def read_strengths(row: Row) -> Deck:
    """Strengths that are reached, with their exponents."""
    failure: Deck = {}
    for field, exponent, key in (("SN", "N", "normal"), ("SS", "M", "shear")):
        strength, power = row.number(field), row.number(exponent)
        if not 0 < strength < NEVER:
            continue
        failure[key] = strength
        if power > 0 and power != 2:
            failure[f"{key}_exponent"] = power
        elif power <= 0:
            failure[f"{key}_exponent"] = 1.0
    return failure


def add_time(row: Row, field: str, failure: Deck) -> None:
    time = row.number(field)
    if 0 < time < NEVER:
        failure["time"] = time


def refuse_strain(deck: KeywordDeck, row: Row, field: str) -> None:
    if 0 < row.number(field) < NEVER:
        deck.ledger.refuse(f"{row.card}.{field}", row.place,
                           "failure by plastic strain beside the weld", "strengths alone count")


def add_weld(deck: KeywordDeck, nodes: tuple[int, int], failure: Deck, place: Place, id: int) -> None:
    for node in nodes:
        if node not in deck.nodes:
            raise BadInput(place, f"there is no node {node}")
    if nodes[0] == nodes[1]:
        raise BadInput(place, f"both nodes of a weld are {nodes[0]}")
    if deck.rigid_ends & set(nodes):
        deck.ledger.refuse("CONSTRAINED_SPOTWELD.rigid", place, "welds of nodes of rigid bodies", LEFT_OUT)
        return
    if not deck.used_nodes().issuperset(nodes):
        deck.ledger.refuse("CONSTRAINED_SPOTWELD.free", place, "welds of nodes without elements", LEFT_OUT)
        return
    entry: Deck = {"between": [{"id": node} for node in nodes]}
    strengths = {"normal", "shear"} & failure.keys()
    if strengths and deck.nodes[nodes[0]] == deck.nodes[nodes[1]]:
        deck.ledger.refuse(
            "CONSTRAINED_SPOTWELD.line", place,
            "strengths of a weld of nodes at one place, which has no normal", "it holds"
        )
        failure = {key: value for key, value in failure.items() if key == "time"}
    if failure:
        entry["failure"] = failure
    welds = deck.model.deck.setdefault("welds", {})
    welds[deck.model.names.take(f"weld_{id or len(welds) + 1}")] = entry


def list_rigid_nodes(deck: KeywordDeck) -> set[int]:
    """Nodes of rigid parts and of rigid sets."""
    found = set(deck.rigid_nodes())
    for entry in deck.model.deck.get("rigid_sets", {}).values():
        found.update(deck.model.node_sets.get(entry["nodes"], []))
    return found
