"""Nodes that move as a node without elements in some directions:
*EQUATION, *MPC PIN, and *COUPLING that leaves directions free."""

from ..ledger import Place
from .deck import AXES, AbaqusDeck, Following
from .mesh import BodyCard
from .timeline import FIXED, Window, is_whole

TURNS = AXES[3:]


def is_partial(deck: AbaqusDeck, card: BodyCard) -> bool:
    """Whether a coupling leaves directions of its nodes free that they have."""
    return bool(card.held) and (not card.held.startswith("123")
                                or bool(deck.model.turning_nodes() & deck.nodes_of_surface(card.surface, card.place)))


def note_couplings(deck: AbaqusDeck) -> None:
    """Couplings with free directions, whose reference nodes have no element."""
    for card in deck.mesh.bodies:
        if card.profile or card.is_constraint or not is_partial(deck, card):
            continue
        leader = deck.nodes_of(card.ref, card.place)[0]
        nodes = sorted(deck.nodes_of_surface(card.surface, card.place) & deck.used_nodes() - {leader})
        if leader in deck.used_nodes() or not nodes:
            refuse_coupling(deck, card.place)
            continue
        deck.followings.append(Following(card, leader, nodes, [AXES[int(digit) - 1] for digit in card.held], True))


def refuse_coupling(deck: AbaqusDeck, place: Place) -> None:
    deck.ledger.refuse("KINEMATIC.free", place, "a coupling that leaves directions free, unless its reference node has "
                                                "no element and does not turn", "its nodes are free")


def note_equal(deck: AbaqusDeck, card: BodyCard, first: list[int], second: list[int]) -> bool:
    """Nodes that move equally with one node without elements; False: there is no such node."""
    for nodes, leader in ((first, second), (second, first)):
        if len(leader) == 1 and leader[0] not in deck.used_nodes() and deck.used_nodes().issuperset(nodes):
            deck.followings.append(Following(card, leader[0], nodes, list(card.equal)))
            return True
    return False


def list_leaders(deck: AbaqusDeck) -> dict[int, Following]:
    return {following.leader: following for following in deck.followings}


def follow(deck: AbaqusDeck) -> None:
    """Nodes get the motion of their leader; where it has none they move equally."""
    for following in deck.followings:
        windows = deck.motions.windows
        own = {way: windows.get((following.leader, way), []) for way in AXES}
        if following.has_arms and not all(is_held(own[turn], deck.end_time) for turn in TURNS):
            refuse_coupling(deck, following.card.place)
            continue
        for way in following.ways:
            if own[way]:
                move(deck, following, way, own[way])
        free = [way for way in following.ways if way in AXES[:3] and not own[way]]
        if free and len(following.nodes) > 1:
            constraints = deck.model.deck.setdefault("constraints", {})
            name = deck.model.names.take(f"equal_{len(constraints) + 1}")
            constraints[name] = {"equal": free, "nodes": deck.model.add_node_set(f"{name}_nodes", following.nodes)}
        deck.ledger.translated(following.card.keyword, following.card.place,
                               "its nodes have the motion of the node without elements, "
                               "or move equally where it is free")
    for leader in list_leaders(deck):
        for way in AXES:
            deck.motions.windows.pop((leader, way), None)


def is_held(windows: list[Window], end: float) -> bool:
    return bool(windows) and is_whole(windows, end) and all(window.action.kind == FIXED for window in windows)


def move(deck: AbaqusDeck, following: Following, way: str, windows: list[Window]) -> None:
    """What is prescribed at the leader;
    of another condition of a node in this direction it is not said which counts."""
    for node in following.nodes:
        before = deck.motions.windows.get((node, way))
        if before and not (is_held(before, deck.end_time) and is_held(windows, deck.end_time)):
            card = following.card
            deck.ledger.refuse(f"{card.keyword}.both", card.place,
                               "nodes with a condition of their own in a direction in which they follow another node",
                               "that of the other node counts")
        deck.motions.windows[(node, way)] = windows
