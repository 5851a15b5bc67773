"""Instances stand in one mesh."""

from ..fields import MOST_ID, clip
from ..ledger import BadInput, Place, missing
from .deck import AbaqusDeck
from .mesh import Instance, Scope, join

MOST_NODES = 20_000_000


def place_instances(deck: AbaqusDeck, assembly: Scope) -> None:
    """All instances and the assembly in one mesh: the ids of the first are kept, those of others raised above them."""
    for instance in deck.instances:
        part = deck.parts.get(instance.part)
        if part is None:
            raise BadInput(instance.place, missing(f"part '{clip(instance.part)}'"))
        own = max([*part.nodes, *part.elements, *instance.own.nodes, *instance.own.elements, 0])
        place_one(deck, instance, own)
        if len(deck.mesh.nodes) + len(part.nodes) + len(instance.own.nodes) > MOST_NODES:
            raise BadInput(instance.place, "the instances have more than 20 million nodes (the limit of the importer): "
                                           "import fewer instances")
        join(deck.mesh, part, instance)
        join(deck.mesh, instance.own, instance)
        deck.ledger.translated("INSTANCE", instance.place, "a part in its place")
    whole = Instance("", "", assembly.place or Place("", 0))
    if deck.instances:
        place_one(deck, whole, max([*assembly.nodes, *deck.assembly_elements, 0]))
    deck.whole_assembly = whole
    join(deck.mesh, assembly, whole)


def place_one(deck: AbaqusDeck, instance: Instance, largest: int) -> None:
    """Chooses what is added to ids: the least number,
    with as many zeros as its own ids have digits, above those before."""
    instance.largest = largest
    highest = max([*deck.mesh.nodes, *deck.mesh.elements, 0])
    if not highest or not largest:
        return
    unit = 10 ** len(str(largest))
    instance.shift = -(-highest // unit) * unit
    if instance.shift + largest > MOST_ID:
        raise BadInput(instance.place, f"the ids go beyond {MOST_ID} with those of this instance "
                                       "(the limit of the importer): renumber its part")
    what = f"instance {clip(instance.name)}" if instance.name else "nodes and elements of the assembly"
    deck.ledger.approximated("INSTANCE", instance.place, f"ids of {what} are raised by {instance.shift}")
