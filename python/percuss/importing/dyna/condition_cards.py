"""*BOUNDARY_SPC, *CONSTRAINED_GLOBAL, TC and RC of *NODE: what holds nodes, and through them rigid bodies."""

import math

from ..fields import Row
from ..ledger import Place
from ..model import Deck
from .bodies import find_point, list_card_nodes, name_nodes, sort_nodes
from .body_holds import hold_points
from .cards import Card
from .deck import KeywordDeck
from .windows import Window, switch

AXES = ("x", "y", "z")
CODES = {0: (), 1: ("x",), 2: ("y",), 3: ("z",), 4: ("x", "y"), 5: ("y", "z"), 6: ("x", "z"), 7: AXES}
SHELL_REACH = 0.2  # from a plane of symmetry, by default
DIRECTIONS = {1: "x", 2: "y", 3: "z", 5: "rx", 6: "ry", 7: "rz"}


def add_fixed(deck: KeywordDeck, name: str, directions: list[str], nodes: list[int],
              window: Deck | None = None) -> None:
    """A condition; rotations only where one of the nodes has shells or beams. window: its `from` and `until`."""
    turning = deck.turning_nodes()
    if not any(node in turning for node in nodes):
        directions = [d for d in directions if d in AXES]
    if directions:
        deck.model.add("conditions", {"nodes": name, "fixed": directions, **(window or {})})


def apply_fixed_nodes(deck: KeywordDeck) -> None:
    """TC and RC of *NODE."""
    place = deck.fixed_place
    for (tc, rc), nodes in sorted(deck.fixed_nodes.items()):
        found = sort_nodes(deck, nodes, place)  # type: ignore[arg-type]
        directions = [*CODES[tc], *("r" + axis for axis in CODES[rc])]
        hold_bodies(deck, found.of_bodies, dict.fromkeys(directions), place, "NODE.TC")  # type: ignore[arg-type]
        label = "".join(CODES[tc]) + ("_r" + "".join(CODES[rc]) if rc else "")
        name = deck.make_node_set(f"fixed_{label}", found.free, place)  # type: ignore[arg-type]
        if name:
            add_fixed(deck, name, directions, deck.model.node_sets[name])


def hold_bodies(deck: KeywordDeck, of_bodies: dict[str, list[int]], directions: dict[str, Deck | None], place: Place,
                card: str) -> None:
    """Holds or moves the bodies that nodes belong to."""
    for body, nodes in of_bodies.items():
        hold_points(deck, body, [find_point(deck, node) for node in nodes], directions, place, card)


def refuse_lost(deck: KeywordDeck, card: str, lost: list[int], place: Place, what: str) -> None:
    """Nodes without elements that belong to no rigid body."""
    if lost:
        deck.ledger.refuse(f"{card}.free", place,
                           f"{what} on node {lost[0]}, which has no element and belongs to no rigid body",
                           "it is left out")


def axis_of_system(deck: KeywordDeck, id: int) -> list[int] | None:
    """The axis of space that each axis of a system is, for those that lie along space. None for others."""
    axes = []
    for axis in deck.systems.get(id, ()):
        along = [d for d in range(3) if abs(abs(axis[d]) - 1) < 1e-9]
        if not along:
            return None
        axes.append(along[0])
    return axes if len(axes) == 3 else None


def read_plane(deck: KeywordDeck, card: Card) -> None:
    """*CONSTRAINED_GLOBAL: all nodes within TOL of a plane across DIR, through a point."""
    reader = card.reader()
    while reader.skip_blank():
        row = reader.row("TC RC DIR X Y Z TOL")
        tc, rc, d = row.integer("TC"), row.integer("RC"), row.integer("DIR") - 1
        if not (0 <= tc <= 7 and 0 <= rc <= 7 and 0 <= d <= 2):
            row.fail("DIR", "codes from 0 to 7 and a direction from 1 to 3 are expected")
        place, reach = row.numbers("X", "Y", "Z")[d], row.number("TOL")
        if reach <= 0:
            row.fail("TOL", "percuss needs a distance above 0")
        nodes = [node for node in deck.used_nodes() if abs(deck.nodes[node][d] - place) <= reach]
        found, directions = sort_nodes(deck, nodes, row.place), [*CODES[tc], *("r" + axis for axis in CODES[rc])]
        hold_bodies(deck, found.of_bodies, dict.fromkeys(directions), row.place, card.keyword)
        name = deck.make_node_set(f"plane_{AXES[d]}", found.free, row.place)
        if name:
            add_fixed(deck, name, directions, deck.model.node_sets[name])
            deck.ledger.translated(card.keyword, row.place, "conditions: fixed, of the nodes on the plane")
        elif not nodes:
            deck.ledger.ignored(card.keyword, row.place, "no node lies on the plane")


def read_symmetry_plane(deck: KeywordDeck, card: Card) -> None:
    """*BOUNDARY_SPC_SYMMETRY_PLANE, _SET: nodes of parts within TOL of a plane stay in it,
    and turn about its normal alone."""
    reader = card.reader()
    while reader.skip_blank():
        row = reader.row("IDSP~label ID X Y Z VX VY VZ")
        reach = reader.row("TOL").number("TOL")
        default = SHELL_REACH * card.change.factor_of(card.keyword, "TOL")
        normal, id = row.numbers("VX", "VY", "VZ"), row.integer("ID")
        across = [d for d in range(3) if abs(normal[d]) > (1 - 1e-9) * math.hypot(*normal)]
        parts = deck.list_members("PART", id, row.place) if card.keyword.endswith("_SET") else [id]
        is_solid = any(deck.elements[part].solids
                       for part in parts if deck.find_part(part, row.place) and part in deck.elements)
        if not any(normal):
            row.fail("VX", "the normal of the plane has no direction")
        if not across:
            deck.ledger.refuse(f"{card.keyword}.VX", row.place,
                               "a plane of symmetry across none of the axes of space", "it is left out")
            continue
        if reach <= 0 and is_solid:
            deck.ledger.refuse(f"{card.keyword}.TOL", row.place,
                               "solids without TOL, whose default is that of shells", "it is 0.2")
        distance = row.numbers("X", "Y", "Z")[across[0]]
        nodes = dict.fromkeys(node for part in parts for node in deck.nodes_of_part(part))
        hold_plane(deck, row, across[0], [node for node in nodes if abs(deck.nodes[node][across[0]] - distance)
                                          <= (reach if reach > 0 else default)])


def hold_plane(deck: KeywordDeck, row: Row, axis: int, nodes: list[int]) -> None:
    """Nodes on a plane of symmetry across an axis."""
    found = sort_nodes(deck, nodes, row.place)
    directions = [AXES[axis], *(f"r{a}" for a in AXES if a != AXES[axis])]
    hold_bodies(deck, found.of_bodies, dict.fromkeys(directions), row.place, row.card)
    name = deck.make_node_set(f"symmetry_{AXES[axis]}", found.free, row.place)
    if name:
        add_fixed(deck, name, directions, deck.model.node_sets[name])
        deck.ledger.translated(row.card, row.place, "conditions: fixed, of the nodes on the plane")
    elif not nodes:
        deck.ledger.ignored(f"{row.card}.none", row.place, "no node of its parts lies on the plane")


def find_factors(deck: KeywordDeck, row: Row, direction: str) -> dict[str, float]:
    """A direction of the system CID as directions of space, each with its share."""
    id = row.integer("CID")
    if not id:
        return {direction: 1.0}
    if id not in deck.systems:
        row.fail("CID", "there is no such system of fixed axes")
    axis = deck.systems[id][AXES.index(direction[-1])]
    return {direction[:-1] + AXES[d]: axis[d] for d in range(3) if abs(axis[d]) > 1e-9}


def read_spc(deck: KeywordDeck, card: Card) -> None:
    """*BOUNDARY_SPC_NODE and _SET."""
    options = set(card.keyword.removeprefix("BOUNDARY_SPC").split("_")) - {""}
    if options - {"NODE", "SET", "BIRTH", "DEATH"} or not options & {"NODE", "SET"}:
        deck.ledger.refuse(card.keyword, card.place, "this form of the card", "it is left out")
        return
    reader = card.reader()
    while reader.next_card():
        if card.has_id:
            reader.take()
        row = reader.row("ID CID X Y Z RX RY RZ")
        window: Deck = {}
        if "BIRTH" in options:
            times = reader.row("BIRTH DEATH=1e20")
            death = times.number("DEATH")
            window = switch(deck, Window(max(times.number("BIRTH"), 0.0), death if 0 < death < deck.end_time else None))
        apply_spc(deck, card, row, "SET" in options, window)


def apply_spc(deck: KeywordDeck, card: Card, row: Row, is_set: bool, window: Deck) -> None:
    directions = [d for d in ("x", "y", "z", "rx", "ry", "rz") if row.integer(d.upper())]
    if not directions:
        deck.ledger.ignored(f"{card.keyword}.none", row.place, "it holds no direction")
        return
    system = row.integer("CID")
    axes = axis_of_system(deck, system) if system else [0, 1, 2]
    if axes is None:
        if set(directions) & set(AXES) == set(AXES) and len(directions) in (3, 6):
            axes = [0, 1, 2]  # all directions of any system
        else:
            deck.ledger.refuse(
                "BOUNDARY_SPC.CID", row.place, f"fixed directions in coordinate system {system}",
                "the condition is left out"
            )
            return
    turned = [("r" if d.startswith("r") else "") + AXES[axes[AXES.index(d[-1])]] for d in directions]
    id = row.integer("ID")
    found = sort_nodes(deck, list_card_nodes(deck, id, is_set, row.place), row.place)
    refuse_lost(deck, card.keyword, found.lost, row.place, "a support")
    held = {d: {"velocity": {d: 0.0}, **window} if window else None for d in turned}
    hold_bodies(deck, found.of_bodies, held, row.place, card.keyword)
    if found.free:
        name = name_nodes(deck, id, is_set, found.free, row.place)
        add_fixed(deck, name, turned, deck.model.node_sets[name], window)
        deck.ledger.translated(card.keyword, row.place, "conditions: fixed")
