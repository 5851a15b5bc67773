"""Elements and sets of the assembly, which name members of instances by their ids there."""

from ..fields import clip
from ..ledger import BadInput, Place
from .deck import AbaqusDeck
from .lines import Block
from .mesh import Scope, read_elements, read_set


def read_assembly(deck: AbaqusDeck, waiting: list[Block]) -> None:
    """waiting: keywords of the assembly, some of them others."""
    if not deck.instances:  # all of it is in the mesh as it stands
        deck.mesh.place = deck.mesh.place or deck.assembly.place
    for block in [b for b in waiting if b.keyword in ("NSET", "ELSET", "ELEMENT")]:
        if block.keyword == "ELEMENT":
            read_assembly_elements(deck, block)
        else:
            read_assembly_set(deck, block)
            deck.ledger.translated(block.keyword, block.place, "a set of the mesh, where something uses it")
    for sets in (deck.mesh.node_sets, deck.mesh.element_sets):
        for name, ids in sets.items():  # what a set names twice is one member
            sets[name] = list(dict.fromkeys(ids))
    deck.transformed = {node for name, place in deck.mesh.transforms for node in deck.nodes_of(name, place)}


def read_assembly_elements(deck: AbaqusDeck, block: Block) -> None:
    shift = deck.whole_assembly.shift if deck.whole_assembly else 0
    found = Scope()
    read_elements(found, block, lambda name, place: deck.nodes_of(name, place)[0])
    for id, (kind, corners) in found.elements.items():
        deck.mesh.elements[id + shift] = (kind, corners)
    for name, ids in found.element_sets.items():
        deck.mesh.element_sets.setdefault(name, []).extend(id + shift for id in ids)


def read_assembly_set(deck: AbaqusDeck, block: Block) -> None:
    """Ids and names are those of INSTANCE, or of the assembly, where they may stand as INSTANCE.ID."""
    is_nodes = block.keyword == "NSET"
    sets = deck.mesh.node_sets if is_nodes else deck.mesh.element_sets
    instance = next((i for i in deck.instances if i.name == block.option("INSTANCE")), None)
    if block.option("INSTANCE") and instance is None:
        raise BadInput(block.place, f"there is no instance '{clip(block.option('INSTANCE'))}' "
                                    "(this card refers to it): add it, or correct the name")
    name = block.option(block.keyword)
    if "GENERATE" in block.options or is_nodes and "ELSET" in block.options:
        whole = deck.whole_assembly
        chosen = instance or whole
        own = deck.scope_of(chosen) if chosen else deck.mesh
        found: dict[str, list[int]] = {}
        read_set(own, block, found)
        shift = (instance or whole).shift if instance or whole else 0  # type: ignore[union-attr]
        sets.setdefault(name, []).extend(id + shift for id in found[name])
        return

    def find(word: str, place: Place) -> list[int]:
        full = f"{instance.name}.{word.strip(chr(34))}" if instance else word
        return deck.nodes_of(full, place) if is_nodes else deck.elements_of(full, place)

    own_names: dict[str, list[int]] = {} if instance else sets
    read_set(deck.mesh, block, own_names, find)
    if instance:
        sets.setdefault(name, []).extend(own_names[name])
