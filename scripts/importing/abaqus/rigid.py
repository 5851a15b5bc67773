"""*RIGID BODY: parts that are rigid, and what acts on their reference nodes."""

from ..ledger import Place
from ..model import Deck
from .deck import AbaqusDeck
from .lines import Block

TRANSLATIONS, ROTATIONS = ("x", "y", "z"), ("rx", "ry", "rz")


def read_rigid_body(deck: AbaqusDeck, block: Block) -> None:
    """The parts whose elements are all of ELSET."""
    name = block.option("ELSET")
    ids = set(deck.elements_of(name, block.place)) if name else set()
    parts = [part for part in deck.model.blocks if part.elements() and {id for id, _ in part.elements()} <= ids]
    covered = {id for part in parts for id, _ in part.elements()}
    if not parts or ids - covered:
        deck.ledger.refuse("RIGID BODY", block.place, "a rigid body that is no whole part with a section", "it deforms")
        return
    for part in parts:
        part.keys["rigid"] = {"body": parts[0].name} if len(parts) > 1 else {}
    for node in deck.nodes_of(block.option("REF NODE"), block.place) if block.option("REF NODE") else []:
        deck.bodies[node] = [part.name for part in parts]
    deck.ledger.translated("RIGID BODY", block.place, "rigid, with the mass of its elements")


def find_body(deck: AbaqusDeck, name: str, place: Place) -> list[str]:
    """Parts of the body whose reference node this is; none for other nodes."""
    nodes = deck.nodes_of(name, place)
    return deck.bodies.get(nodes[0], []) if len(nodes) == 1 and nodes[0] not in deck.used_nodes() else []


def move_body(deck: AbaqusDeck, parts: list[str], entry: Deck, place: Place) -> None:
    """A condition of a reference node becomes one of the body."""
    blocks = [part for part in deck.model.blocks if part.name in parts]
    if "fixed" in entry:
        held = blocks[0].keys["rigid"].setdefault("fixed", [])
        held += [d for d in entry["fixed"] if d not in held]
        deck.ledger.approximated("BOUNDARY.body", place, "rigid.fixed: of the mass centre, not of the reference node")
        return
    nodes = blocks[0].name if len(blocks) == 1 else deck.model.add_node_set("body", deck.model.nodes_of_blocks(b.id for b in blocks))
    deck.model.add("conditions", {"nodes": nodes, **entry})
    deck.driven.append((blocks[0].name, {d for values in entry.values() for d in values}, place))
    deck.ledger.translated("BOUNDARY", place, "conditions on the nodes of the body")


def check_turns(deck: AbaqusDeck) -> None:
    """A body whose nodes all move alike along an axis does not turn."""
    for name, moved, place in deck.driven:
        block = next(part for part in deck.model.blocks if part.name == name)
        keys = block.keys["rigid"]
        given = {*keys.get("fixed", []), *(d for other, more, _ in deck.driven if other == name for d in more)}
        axes = [d[-1] for d in moved if d in TRANSLATIONS]
        free = [turn for turn in ROTATIONS if any(turn[-1] != axis for axis in axes) and turn not in given]
        if free:
            deck.ledger.refuse("RIGID BODY.turns", place, "a rigid body that is moved along an axis and turns freely", "it does not turn")
        if "fixed" in keys:
            keys["fixed"] = [d for d in keys["fixed"] if d not in moved]
            if not keys["fixed"]:
                del keys["fixed"]


def finish_bodies(deck: AbaqusDeck) -> None:
    """`rigid: true` where there is nothing to add."""
    check_turns(deck)
    for part in deck.model.blocks:
        if part.keys.get("rigid") == {}:
            part.keys["rigid"] = True
