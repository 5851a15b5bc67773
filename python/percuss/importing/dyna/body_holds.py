"""What holds or moves rigid bodies: supports and motions at their nodes, with or without elements,
and of their mass centres."""

import math
from collections.abc import Iterable
from dataclasses import dataclass

from ..ledger import Place
from ..model import Deck, Vector
from ..shapes import cross, dot, normalise, subtract
from .deck import KeywordDeck
from .windows import join_motions

AXES = ("x", "y", "z")
FREEDOMS = (*AXES, "rx", "ry", "rz")
SMALL = 1e-6  # components of a row of length 1: round-off

Six = tuple[float, ...]  # velocity of a reference point, and spin


@dataclass
class Hold:
    """A direction in which a point of a body is held or moved."""

    point: Vector | None  # None: the mass centre
    direction: str  # x, y, z, rx, ry, rz
    motion: Deck | None  # a condition without what it acts on; None: rest
    place: Place
    card: str


class Rows:
    """An orthonormal basis of what some conditions fix of six velocities."""

    def __init__(self) -> None:
        self.basis: list[Six] = []

    def reduce(self, row: Six) -> Six:
        for known in self.basis:
            share = sum(a * b for a, b in zip(row, known, strict=True))
            row = tuple(a - share * b for a, b in zip(row, known, strict=True))
        return row

    def add(self, row: Six) -> None:
        rest = self.reduce(self.reduce(row))
        size = math.hypot(*rest)
        if size > SMALL:
            self.basis.append(tuple(a / size for a in rest))

    def fixes(self, k: int) -> bool:
        return math.hypot(*self.reduce(tuple(1.0 if i == k else 0.0 for i in range(6)))) < SMALL


def make_row(hold: Hold, reference: Vector, size: float) -> Six:
    """The velocity that a hold fixes, with lengths in shares of a size."""
    k = FREEDOMS.index(hold.direction)
    row = [0.0] * 6
    row[k] = 1.0
    if k < 3 and hold.point:
        arm = tuple(a / size for a in subtract(hold.point, reference))
        for d in range(3):  # (w x r) . e = w . (r x e)
            row[3 + d] = cross(arm, tuple(1.0 if i == k else 0.0 for i in range(3)))[d]  # type: ignore[arg-type]
    length = math.hypot(*row)
    return tuple(value / length for value in row)


def apply_body_holds(deck: KeywordDeck) -> None:
    """Conditions of bodies and joints to the ground, from all that the cards hold of each body."""
    for body, holds in deck.body_holds.items():
        BodyHolds(deck, body, holds).apply()


class BodyHolds:
    """All that holds one body."""

    def __init__(self, deck: KeywordDeck, body: str, holds: list[Hold]):
        self.deck, self.body, self.holds = deck, body, holds
        points = [hold.point for hold in holds if hold.point]
        self.reference: Vector = points[0] if points else (0.0, 0.0, 0.0)
        self.size = max((math.dist(self.reference, point) for point in points), default=0.0) or 1.0

    def apply(self) -> None:
        rows = Rows()
        for direction in self.deck.held_of_body.get(self.body, []):
            rows.add(make_row(Hold(None, direction, None, self.holds[0].place, ""), self.reference, self.size))
        for hold in self.holds:
            rows.add(make_row(hold, self.reference, self.size))
        fixed = [name for k, name in enumerate(FREEDOMS) if rows.fixes(k)]
        if len(fixed) == len(rows.basis) and self.knows_center(fixed):
            self.add_conditions(fixed)
        elif not self.add_joint(rows):
            self.hold_center()

    def knows_center(self, fixed: list[str]) -> bool:
        """Whether what is said of the points holds of the mass centre too:
        the body does not turn about the other axes."""
        for hold in self.holds:
            if hold.point and hold.direction in AXES:
                others = [f"r{axis}" for axis in AXES if axis != hold.direction]
                if not set(others) <= set(fixed):
                    return False
        return True

    def add_conditions(self, fixed: list[str]) -> None:
        """Adds conditions of the directions that are held: rest, or their motion, which counts more than rest."""
        ledger, already = self.deck.ledger, set(self.deck.held_of_body.get(self.body, []))
        moving = [hold for hold in self.holds if hold.motion]
        moved = {hold.direction for hold in moving}
        rest = [name for name in fixed if name not in moved | already]
        if rest:
            self.deck.model.add("conditions", {"body": self.body, "fixed": rest})
        found: dict[str, Deck] = {}
        read: list[tuple[str, Deck]] = []
        for hold in moving:
            motion, known = hold.motion or {}, found.get(hold.direction)
            if (hold.direction, motion) in read:
                continue
            read.append((hold.direction, motion))
            joined = (motion if known is None
                      else join_motions(self.deck, known, motion) or join_motions(self.deck, motion, known))
            if hold.direction in already or joined is None:
                ledger.refuse(f"{hold.card}.two", hold.place,
                              f"a second condition on direction {hold.direction} of a rigid body", "it is left out")
            else:
                found[hold.direction] = joined
        for motion in found.values():
            self.deck.model.add("conditions", {"body": self.body, **motion})
        for hold in self.holds:
            if not hold.motion and hold.direction in moved:
                ledger.approximated(f"{hold.card}.moved", hold.place,
                                    "where a rigid body is held and moved in one direction, the motion counts")
            else:
                ledger.translated(hold.card, hold.place, "conditions of the rigid body")

    def add_joint(self, rows: Rows) -> bool:
        """A body that turns about a point or an axis which is held: a joint to the ground. False: it is none."""
        points = [hold.point for hold in self.holds if hold.direction in AXES]
        if (any(hold.motion or not hold.point for hold in self.holds) or not points
                or self.deck.held_of_body.get(self.body)):
            return False
        entry: Deck | None = None
        if len(rows.basis) == 3 and len(set(points)) == 1 and len(points) >= 3:
            entry = {"kind": "spherical", "bodies": [self.body], "at": list(points[0])}  # type: ignore[arg-type]
        elif len(rows.basis) == 5 and (hinge := self.find_hinge(rows)):
            entry = {"kind": "revolute", "bodies": [self.body], "at": list(hinge[0]), "axis": list(hinge[1])}
        if entry is None:
            return False
        name = self.deck.model.names.take(f"support_{self.body}", "joint")
        self.deck.model.deck.setdefault("joints", {})[name] = entry
        for hold in self.holds:
            self.deck.ledger.translated(hold.card, hold.place, "a joint of the rigid body to the ground")
        return True

    def find_hinge(self, rows: Rows) -> tuple[Vector, Vector] | None:
        """A point and the direction of the axis about which a body may turn; None: it moves in another way."""
        free = max((rows.reduce(tuple(1.0 if i == k else 0.0 for i in range(6))) for k in range(6)),
                   key=lambda row: math.hypot(*row))
        spin: Vector = (free[3], free[4], free[5])
        velocity: Vector = (free[0] * self.size, free[1] * self.size, free[2] * self.size)
        square = dot(spin, spin)
        if square < SMALL * SMALL or abs(dot(spin, velocity)) > SMALL * self.size:
            return None
        arm = cross(spin, velocity)  # from the reference to the axis
        point = tuple(a + b / square for a, b in zip(self.reference, arm, strict=True))
        return point, normalise(spin)  # type: ignore[return-value]

    def hold_center(self) -> None:
        """What no joint and no condition of percuss says of points: supports act on the mass centre,
        as LS-DYNA has them; motions are refused."""
        directions = list(dict.fromkeys(hold.direction for hold in self.holds))
        moving = [hold for hold in self.holds if hold.motion and hold.point and hold.direction in AXES]
        problem = "a motion of a point of a rigid body about which it may turn"
        if moving and not self.deck.ledger.refuse(f"{moving[0].card}.body", moving[0].place, problem,
                                                  "it acts on the mass centre"):
            return
        if not moving:
            self.deck.ledger.approximated(f"{self.holds[0].card}.body", self.holds[0].place,
                                          "supports at points of a rigid body act on its mass centre")
        self.add_conditions(directions)


def hold_points(deck: KeywordDeck, body: str, points: Iterable[Vector | None], directions: dict[str, Deck | None],
                place: Place, card: str) -> None:
    """Notes that points of a body are held (None) or moved in some directions."""
    for point in points:
        for direction, motion in directions.items():
            deck.body_holds.setdefault(body, []).append(Hold(point, direction, motion, place, card))
