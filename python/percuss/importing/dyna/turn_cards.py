"""DOF 9, 10 and 11 of *BOUNDARY_PRESCRIBED_MOTION: nodes that turn about an axis of space through a place."""

import math

from ..curves import Points, integrate, interpolate, order_points
from ..fields import Row
from ..model import Deck
from .bodies import sort_nodes
from .condition_cards import AXES, refuse_lost
from .deck import KeywordDeck
from .windows import Window, switch

CARD = "BOUNDARY_PRESCRIBED_MOTION"
FINEST = math.radians(0.5)  # between two rows of a table
MOST_ROWS = 200_000  # of all tables of a card


def list_angles(deck: KeywordDeck, row: Row) -> Points | None:
    """The angle over time from time 0 to the end of the run, in steps that show an arc; None: refused."""
    kind = row.integer("VAD")
    curve, scale = deck.curve(row.integer("LCID"), row.place, "time", "none" if kind else "rate"), row.number("SF") or 1.0
    curve.is_of_time = True
    points = [(x, scale * y) for x, y in order_points(curve.points)]
    if curve.expression or curve.relaxation == 1 or kind not in (0, 2) or row.number("BIRTH") > 0 or len(points) < 2:
        deck.ledger.refuse(f"{CARD}.VAD", row.place, f"DOF {row.integer('DOF')} with VAD {kind}, BIRTH or this curve", "the motion is left out")
        return None
    angles = integrate(points) if kind == 0 else points
    start, end = interpolate(angles, 0.0), deck.end_time
    if kind == 2 and start:
        deck.ledger.refuse(f"{CARD}.LCID", row.place, "an angle that is not 0 at time 0", "the motion is left out")
        return None
    times = sorted({0.0, end, *(x for x, _ in angles if 0 < x < end)})
    rows: Points = []
    for first, last in zip(times, times[1:], strict=False):
        a, b = interpolate(angles, first) - start, interpolate(angles, last) - start
        count = max(1, math.ceil(abs(b - a) / FINEST))
        rows += [(first + (last - first) * i / count, a + (b - a) * i / count) for i in range(count)]
    return [*rows, (end, interpolate(angles, end) - start)]


def apply_turn(deck: KeywordDeck, row: Row, more: Row, card: str, nodes: list[int]) -> None:
    """A displacement in two directions of each node: it stays at its distance from the axis."""
    axis = row.integer("DOF") - 9
    if axis not in (0, 1, 2):
        deck.ledger.refuse(f"{CARD}.DOF", row.place, f"DOF {row.integer('DOF')} with VAD {row.integer('VAD')}", "the motion is left out")
        return
    first, second = (axis + 1) % 3, (axis + 2) % 3
    middle = more.numbers("OFFSET1", "OFFSET2")
    death = row.number("DEATH")
    angles = list_angles(deck, row)
    row.finish(deck.ledger)
    more.finish(deck.ledger)
    found = sort_nodes(deck, nodes, row.place)
    refuse_lost(deck, card, found.lost, row.place, "a motion")
    if angles is None:
        return
    if found.of_bodies or len(found.free) * len(angles) > MOST_ROWS:
        deck.ledger.refuse(f"{CARD}.DOF", row.place, f"DOF {row.integer('DOF')} of nodes of rigid bodies, or of so many nodes", "the motion is left out")
        return
    window = switch(deck, Window(0.0, death if 0 < death < deck.end_time else None))
    for node in found.free:
        x, y = deck.nodes[node][first] - middle[0], deck.nodes[node][second] - middle[1]
        motion: Deck = {
            AXES[first]: {"table": [[time, x * (math.cos(angle) - 1) - y * math.sin(angle)] for time, angle in angles]},
            AXES[second]: {"table": [[time, y * (math.cos(angle) - 1) + x * math.sin(angle)] for time, angle in angles]},
        }
        name = deck.single_nodes.get(node) or deck.make_node_set(f"node_{node}", [node], row.place)
        deck.single_nodes[node] = name
        deck.model.add("conditions", {"nodes": name, "displacement": motion, **window})
    deck.ledger.translated(CARD, row.place, "displacements of each node along its arc")
