"""*BOUNDARY_PRESCRIBED_MOTION_NODE and _SET:
what a row of *BOUNDARY_PRESCRIBED_MOTION says of the velocity over time, and when it acts."""

from ..curves import Curve, Points, differentiate, integrate, make_time_value, order_points
from ..fields import Row
from ..ledger import BadInput, Place
from ..model import Deck
from .bodies import list_card_nodes, name_nodes, sort_nodes
from .cards import Card
from .condition_cards import AXES, hold_bodies, refuse_lost
from .deck import KeywordDeck
from .starting import find_body_start, find_node_start
from .turn_cards import apply_turn
from .windows import Window, acts_in_run, add_motion, switch

CARD = "BOUNDARY_PRESCRIBED_MOTION"
VELOCITY, ACCELERATION, DISPLACEMENT = 0, 1, 2
LAYOUT = "ID DOF VAD LCID SF=1 VID DEATH=1e28 BIRTH"
MORE = "OFFSET1 OFFSET2 LRB NODE1 NODE2"


def find_window(deck: KeywordDeck, row: Row) -> Window:
    birth, death = row.numbers("BIRTH", "DEATH")
    return Window(max(birth, 0.0), death if 0 < death < deck.end_time else None)


def list_values(deck: KeywordDeck, row: Row, curve: Curve, start: float | None) -> Points | None:
    """Velocity over the time since BIRTH, where it follows from a table; None: refused.
    start: the velocity at time 0; None: not known."""
    kind, points = row.integer("VAD"), order_points(curve.points)
    if kind == DISPLACEMENT:
        deck.ledger.approximated(f"{CARD}.VAD", row.place,
                                 "the slope of the displacement, or of the angle, as a velocity")
        return differentiate(points)
    if start is None or row.number("BIRTH") > 0:
        why = ("an acceleration that begins later, from a velocity that is not known" if start is not None
               else "an acceleration of nodes whose velocity at the start is not known")
        deck.ledger.refuse(f"{CARD}.VAD", row.place, why, "the motion is left out")
        return None
    deck.ledger.approximated(f"{CARD}.VAD", row.place,
                             "the initial velocity and the integral of the acceleration, as a velocity")
    # Before its first point and behind its last one a curve is 0: the velocity stays.
    return [(time, start + value) for time, value in order_points(integrate(points))]


def name_dimension(kind: int, turns: bool) -> str:
    """Dimension of a curve of VAD kind."""
    names = {VELOCITY: ("speed", "rate"), ACCELERATION: ("acceleration", "angular_acceleration")}
    return names.get(kind, ("length", "none"))[turns]


def make_motion(deck: KeywordDeck, row: Row, direction: str, sign: float, start: float | None = 0.0) -> Deck | None:
    """A condition of percuss without what it acts on. start: velocity at time 0 in the direction; None: not known."""
    kind, birth = row.integer("VAD"), max(row.number("BIRTH"), 0.0)
    turns = direction.startswith("r")
    found = deck.curve(row.integer("LCID"), row.place, "time", name_dimension(kind, turns))
    if not acts_in_run(deck, found, row.place):
        return None
    scale = (row.number("SF") or 1.0) * sign
    curve = Curve(found.place, [(x, scale * y) for x, y in found.points],
                  found.expression and f"{scale!r} * ({found.expression})")
    if (kind not in (VELOCITY, ACCELERATION, DISPLACEMENT)
            or (curve.expression and (kind == ACCELERATION or (turns and kind == DISPLACEMENT) or birth))):
        deck.ledger.refuse(f"{CARD}.VAD", row.place,
                           f"VAD {kind} in direction {direction}, of this curve", "the motion is left out")
        return None
    window = switch(deck, find_window(deck, row))
    if kind == DISPLACEMENT and not turns and not birth:
        return make_displacement(deck, row, curve, direction, window)
    if kind == VELOCITY:
        return {"velocity": {direction: make_time_value(curve, 1.0, deck.end_time, birth)}, **window}
    if len(curve.points) < 2:
        raise BadInput(row.place, f"curve {row.integer('LCID')} has one point (VAD {kind} needs two): add a point")
    points = list_values(deck, row, curve, start)
    if points is None:
        return None
    if kind == DISPLACEMENT:
        value = make_time_value(Curve(curve.place, points), 1.0, deck.end_time, birth)
    else:
        value = make_time_value(Curve(curve.place, hold_ends(points, deck.end_time)), 1.0, deck.end_time)
    return {"velocity": {direction: value}, **window}


def hold_ends(points: Points, end: float) -> Points:
    """The points with their end values held before and behind them."""
    first, last = points[0], points[-1]
    return [*([(0.0, first[1])] if first[0] > 0 else []), *points, *([(end, last[1])] if last[0] < end else [])]


def make_displacement(deck: KeywordDeck, row: Row, curve: Curve, direction: str, window: Deck) -> Deck | None:
    """A displacement begins at 0, and stays where its curve ends."""
    points = order_points(curve.points)
    if points and points[-1][0] < deck.end_time and points[-1][1] != 0:
        deck.ledger.approximated(f"{CARD}.LCID", row.place, "a displacement stays where its curve ends")
        points = hold_ends(points, deck.end_time)
    if points and points[0][0] > 0 and points[0][1] == 0:
        points = [(0.0, 0.0), *points]
    value = make_time_value(Curve(curve.place, points, curve.expression), 1.0, deck.end_time)
    rows = value["table"] if isinstance(value, dict) and "table" in value else [[0.0, value]]
    if not curve.expression and rows[0][1] != 0:
        deck.ledger.refuse(f"{CARD}.LCID", row.place,
                           "a displacement that is not 0 at time 0", "the motion is left out")
        return None
    return {"displacement": {direction: value}, **window}


def find_directions(deck: KeywordDeck, row: Row) -> dict[str, float] | None:
    """Directions of space in which a motion acts, with their factors; None: it is refused.
    DOF 4 and 8 are along a vector."""
    dof, vid = row.integer("DOF"), row.integer("VID")
    if 1 <= dof <= 3 or 5 <= dof <= 7:
        prefix, k = ("", dof - 1) if dof <= 3 else ("r", dof - 5)
        if vid >= 0:
            return {prefix + AXES[k]: 1.0}
        if -vid not in deck.systems:
            row.fail("VID", "there is no such system of fixed axes")
        axis = deck.systems[-vid][k]
    elif abs(dof) in (4, 8):
        prefix = "" if abs(dof) == 4 else "r"
        if vid not in deck.vectors:
            row.fail("VID", "there is no such vector in global axes")
        axis = deck.vectors[vid]
    else:
        return None
    factors = {prefix + AXES[d]: axis[d] for d in range(3) if abs(axis[d]) > 1e-9}
    if dof < 0:  # what is across the vector is held
        return {prefix + AXES[d]: axis[d] for d in range(3)}
    if len(factors) > 1:
        problem = f"a motion along a direction that is no axis of space, in which DOF is {dof}"
        is_allowed = deck.ledger.refuse(f"{CARD}.DOF", row.place, problem,
                                        "what is across it is held, as with DOF below 0")
        return {prefix + AXES[d]: axis[d] for d in range(3)} if is_allowed else {}
    return factors


def list_motions(deck: KeywordDeck, row: Row, start: dict[str, float] | None) -> list[tuple[str, Deck]]:
    """What a row moves: directions with their conditions. start: velocity at time 0 by direction; None: not known."""
    factors = find_directions(deck, row)
    if factors is None:
        deck.ledger.refuse(f"{CARD}.DOF", row.place, f"DOF {row.integer('DOF')}", "the motion is left out")
        return []
    motions = []
    for direction, factor in factors.items():
        before = None if start is None else start.get(direction)
        motion = (make_motion(deck, row, direction, factor, before) if factor
                  else {"velocity": {direction: 0.0}, **switch(deck, find_window(deck, row))})
        if motion:
            motions.append((direction, motion))
    return motions


def read_motion(deck: KeywordDeck, card: Card) -> None:
    """*BOUNDARY_PRESCRIBED_MOTION_NODE and _SET."""
    form = card.keyword.removeprefix(CARD + "_")
    if form not in ("NODE", "SET"):
        deck.ledger.refuse(card.keyword, card.place, "this form of the card", "it is left out")
        return
    reader = card.reader()
    while reader.next_card():
        if card.has_id:
            reader.take()
        row = reader.row(LAYOUT)
        if abs(row.integer("DOF")) in (9, 10, 11) or row.integer("VAD") == 4:
            more = reader.row(MORE)
            apply_turn(deck, row, more, card.keyword,
                       list_card_nodes(deck, row.integer("ID"), form == "SET", row.place), form == "SET")
            continue
        apply_motion(deck, card, row, form == "SET")


def apply_motion(deck: KeywordDeck, card: Card, row: Row, is_set: bool) -> None:
    """Conditions on nodes, apart by their velocity at the start if they accelerate;
    and on the bodies that nodes belong to."""
    id = row.integer("ID")
    found = sort_nodes(deck, list_card_nodes(deck, id, is_set, row.place), row.place)
    refuse_lost(deck, card.keyword, found.lost, row.place, "a motion")
    for body, nodes in found.of_bodies.items():
        for direction, motion in list_motions(deck, row, find_body_start(deck, body)):
            hold_bodies(deck, {body: nodes}, {direction: motion}, row.place, CARD)
    if not found.free:
        return
    if row.integer("VAD") != ACCELERATION:
        add_motions(deck, name_nodes(deck, id, is_set, found.free, row.place), list_motions(deck, row, {}), row.place)
        return
    groups: dict[tuple[tuple[str, float], ...] | None, list[int]] = {}
    for node in found.free:
        start = find_node_start(deck, node)
        key = None if start is None else tuple(start.items())
        groups.setdefault(key, []).append(node)
    for key, nodes in groups.items():
        start = None if key is None else dict(key)
        name = (name_nodes(deck, id, is_set, found.free, row.place) if len(groups) == 1
                else deck.make_node_set(f"accelerated_{id}", nodes, row.place))
        add_motions(deck, name, list_motions(deck, row, start), row.place)


def add_motions(deck: KeywordDeck, name: str, motions: list[tuple[str, Deck]], place: Place) -> None:
    for _, motion in motions:
        add_motion(deck, {"nodes": name}, motion)
    if motions:
        deck.ledger.translated(CARD, place, "conditions: velocity or displacement")
