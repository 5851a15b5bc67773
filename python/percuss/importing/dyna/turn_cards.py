"""DOF 9, 10 and 11 of *BOUNDARY_PRESCRIBED_MOTION: nodes that turn about an axis of space through a place."""

from ..curves import Curve, differentiate, make_time_value, order_points
from ..fields import Row
from ..model import Deck
from .bodies import name_nodes, sort_nodes
from .condition_cards import AXES, refuse_lost
from .deck import KeywordDeck
from .windows import Window, acts_in_run, switch

CARD = "BOUNDARY_PRESCRIBED_MOTION"
FIRST_TURN = 9  # DOF of a turn about x


def find_rate(deck: KeywordDeck, row: Row, birth: float) -> "float | Deck | None":
    """The angular velocity over time; None: refused."""
    kind = row.integer("VAD")
    curve, scale = (deck.curve(row.integer("LCID"), row.place, "time", "none" if kind else "rate"),
                    row.number("SF") or 1.0)
    if not acts_in_run(deck, curve, row.place):
        return None
    points = [(x, scale * y) for x, y in order_points(curve.points)]
    if curve.expression or kind not in (0, 2) or len(points) < 2:
        deck.ledger.refuse(f"{CARD}.VAD", row.place,
                           f"DOF {row.integer('DOF')} with VAD {kind}, or of this curve", "the motion is left out")
        return None
    if kind == 2 and points[0][1]:
        deck.ledger.refuse(f"{CARD}.LCID", row.place,
                           "an angle that is not 0 where its curve begins", "the motion is left out")
        return None
    if kind == 2:
        deck.ledger.approximated(f"{CARD}.VAD", row.place,
                                 "the slope of the angle as an angular velocity; the angle stays where its curve ends")
        points = differentiate(points)
    return make_time_value(Curve(curve.place, points), 1.0, deck.end_time, birth)


def apply_turn(deck: KeywordDeck, row: Row, more: Row, card: str, nodes: list[int], is_set: bool) -> None:
    """A turn of nodes, which stay at their distance from the axis."""
    axis = row.integer("DOF") - FIRST_TURN
    if axis not in (0, 1, 2):
        deck.ledger.refuse(f"{CARD}.DOF", row.place,
                           f"DOF {row.integer('DOF')} with VAD {row.integer('VAD')}", "the motion is left out")
        return
    through = [0.0, 0.0, 0.0]
    through[(axis + 1) % 3], through[(axis + 2) % 3] = more.numbers("OFFSET1", "OFFSET2")
    birth, death = max(row.number("BIRTH"), 0.0), row.number("DEATH")
    rate = find_rate(deck, row, birth)
    row.finish(deck.ledger)
    more.finish(deck.ledger)
    found = sort_nodes(deck, nodes, row.place)
    refuse_lost(deck, card, found.lost, row.place, "a motion")
    if rate is None:
        return
    if found.of_bodies:
        deck.ledger.refuse(f"{CARD}.DOF", row.place, f"DOF {row.integer('DOF')} of nodes of rigid bodies",
                           "their motion is left out")
    if not found.free:
        return
    window = switch(deck, Window(birth, death if 0 < death < deck.end_time else None))
    name = name_nodes(deck, row.integer("ID"), is_set, found.free, row.place)
    turn: Deck = {"axis": AXES[axis], "through": through, "angular_velocity": rate}
    deck.model.add("conditions", {"nodes": name, "turn": turn, **window})
    deck.ledger.translated(CARD, row.place, "conditions: turn")
