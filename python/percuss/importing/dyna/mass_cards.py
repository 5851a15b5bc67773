"""*ELEMENT_MASS: nonstructural masses of nodes, of sets of nodes and of parts."""

from ..fields import Row
from ..ledger import BadInput
from ..shapes import measure_block
from .cards import Card
from .deck import KeywordDeck
from .start_cards import add_body_mass


def read_masses(deck: KeywordDeck, card: Card) -> None:
    """EID ID MASS, of a node or a set of nodes; _PART has the masses of parts."""
    for line in card.lines:
        if not line[1].strip():
            continue
        if "PART" in card.keyword:
            row = card.row(line, "ID ADDMASS FINMASS LCID MWD", (8, 16, 16, 8, 8))
            deck.masses_of_sets.append(row)
            continue
        row = card.row(line, "EID~label ID MASS PID~label", (8, 8, 16, 8))
        if card.keyword.endswith("NODE_SET"):
            deck.masses_of_sets.append(row)
        else:
            deck.masses.append((row.integer("ID"), row.number("MASS"), row.place))
            row.finish(deck.ledger)


def add_masses_of_sets(deck: KeywordDeck) -> None:
    """An entry of `added_mass` for each set of nodes, part or set of parts."""
    for row in deck.masses_of_sets:
        if row.card == "ELEMENT_MASS_NODE_SET":
            add_to_nodes(deck, row)
        else:
            add_to_parts(deck, row)


def add_to_nodes(deck: KeywordDeck, row: Row) -> None:
    """MASS is that of all nodes, divided equally."""
    name, mass = deck.node_set_name(row.integer("ID"), row.place), row.number("MASS")
    row.finish(deck.ledger)
    members, used = deck.list_members("NODE", row.integer("ID"), row.place), deck.used_nodes()
    kept = [node for node in members if node in used]
    bare = [node for node in members if node not in used]
    for node in bare:
        if node in deck.bodies_of_nodes:
            add_body_mass(deck, node, mass / len(members), row.place)
    if any(node not in deck.bodies_of_nodes for node in bare):
        deck.ledger.refuse("ELEMENT_MASS_NODE_SET.free", row.place,
                           "masses on nodes without elements that belong to no rigid body", "their share is left out")
    if name and mass > 0:
        deck.model.add("added_mass", {"nodes": name, "mass": mass * len(kept) / len(members), "spread": "evenly"})
    deck.ledger.translated(row.card, row.place, "added_mass, equal shares of the nodes")


def add_to_parts(deck: KeywordDeck, row: Row) -> None:
    """ADDMASS, or what FINMASS lacks, by area;
    by mass, which is the same where parts have one thickness and density."""
    id, added, final = row.integer("ID"), row.number("ADDMASS"), row.number("FINMASS")
    is_set = row.card.endswith("SET")
    parts = deck.list_members("PART", id, row.place) if is_set else [deck.find_part(id, row.place).id]
    if row.integer("LCID"):
        deck.ledger.refuse(f"{row.card}.LCID", row.place, "a mass that changes over time", "it is constant")
    by_mass = row.integer("MWD") == 1 or not is_set
    row.finish(deck.ledger)
    blocks = [block for block in deck.model.blocks if block.part in parts]
    own = sum(measure_block(deck.model, block)[0] for block in blocks)
    if final and (added or final < own):
        raise BadInput(row.place, f"FINMASS of *{row.card} is {final:g} beside ADDMASS or below the mass {own:g} of "
                                  "the elements: correct one")
    mass = final - own if final else added
    name = deck.make_node_set(f"massed_{id}",
                              sorted(deck.model.nodes_of_blocks(block.id for block in blocks)), row.place)
    if not name or mass <= 0:
        deck.ledger.ignored(row.card, row.place, "it adds no mass, or its parts have no elements")
        return
    deck.model.add("added_mass", {"nodes": name, "mass": mass})
    text = "added_mass, in proportion to the mass of the nodes"
    if by_mass and len({(block.thickness, block.density) for block in blocks}) == 1:
        deck.ledger.translated(row.card, row.place, text)
    else:
        deck.ledger.approximated(row.card, row.place, text + " instead of their area")
