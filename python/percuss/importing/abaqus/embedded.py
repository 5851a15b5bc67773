"""*EMBEDDED ELEMENT: nodes of elements that keep their places in solids."""

from ..ledger import Place
from ..model import Block as Elements
from ..model import Deck
from .deck import AbaqusDeck
from .lines import Block

LEFT_OUT = "it is left out"


def read_embedded(deck: AbaqusDeck, block: Block) -> None:
    """Lines of sets of elements; their hosts are those of HOST ELSET, or all solids."""
    name = block.option("HOST ELSET")
    hosts = (blocks_of(deck, deck.elements_of(name, block.place), block.place) if name
             else [part for part in deck.model.blocks if part.solids])
    solids = [part for part in hosts if part.solids]
    words = [word for line in block.lines for word in line[1] if word]
    bars = {id for word in words for id in deck.elements_of(word, block.place) if id in deck.blocks_of_elements}
    if not bars or not solids:
        deck.ledger.refuse("EMBEDDED ELEMENT.empty", block.place,
                           "embedded elements or hosts without elements", LEFT_OUT)
        return
    own = {deck.blocks_of_elements[id] for id in bars}
    if not name:
        solids = [part for part in solids if part not in [deck.model.blocks[index] for index in own]]
    nodes = {node for id in bars for node in deck.mesh.elements[id][1]}
    rigid = {node for group in deck.groups for node in group.nodes}
    if rigid & nodes or any("rigid" in part.keys for part in solids):
        deck.ledger.refuse("EMBEDDED ELEMENT.rigid", block.place, "elements in rigid bodies, or rigid ones", LEFT_OUT)
        return
    parts = [deck.model.blocks[index] for index in sorted(own)]
    is_whole = all({id for id, _ in part.elements()} <= bars for part in parts)
    names = [part.name for part in parts] if is_whole else [deck.model.add_node_set(words[0], nodes)]
    entries = deck.model.deck.setdefault("embedded", {})
    for of_nodes in names:
        entry: Deck = {"nodes": of_nodes, "in": [part.name for part in solids]}
        if block.option("EXTERIOR TOLERANCE"):
            entry["tolerance"] = block.number((block.place.line, [block.option("EXTERIOR TOLERANCE")]), 0)
        entries[deck.model.names.take(f"embedded_{len(entries) + 1}")] = entry
    deck.ledger.translated("EMBEDDED ELEMENT", block.place, "embedded")


def blocks_of(deck: AbaqusDeck, ids: list[int], place: Place) -> list[Elements]:
    """Whole parts."""
    known = {id for id in ids if id in deck.blocks_of_elements}
    parts = [deck.model.blocks[index] for index in sorted({deck.blocks_of_elements[id] for id in known})]
    if any(not {id for id, _ in part.elements()} <= known for part in parts):
        deck.ledger.approximated("EMBEDDED ELEMENT.HOST ELSET", place, "all solids of the parts of the host elements")
    return parts
