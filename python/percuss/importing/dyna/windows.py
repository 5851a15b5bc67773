"""Birth and death: sensors of times, which switch conditions and loads.
A motion that begins where another ends continues it."""

from dataclasses import dataclass

from ..curves import Curve, Points, differentiate, interpolate, order_points
from ..ledger import Place
from ..model import Deck
from .deck import KeywordDeck


@dataclass
class Window:
    """When a motion acts; end: None is the end of the run."""

    start: float = 0.0
    end: float | None = None


def name_sensor(deck: KeywordDeck, time: float) -> str:
    """The sensor of a time."""
    sensors: dict[str, Deck] = deck.model.deck.setdefault("sensors", {})
    for name, sensor in sensors.items():
        if sensor == {"time": time}:
            return name
    name = deck.model.names.take(f"time_{len(sensors) + 1}", "time")
    sensors[name] = {"time": time}
    return name


def acts_in_run(deck: KeywordDeck, curve: Curve, place: Place) -> bool:
    """Whether a motion is one of the run: with SIDR 1 its curve acts in a dynamic relaxation before it alone."""
    if curve.relaxation == 1:
        deck.ledger.refuse("BOUNDARY_PRESCRIBED_MOTION.LCID", place,
                           "a motion by a curve with SIDR = 1, of dynamic relaxation alone", "the motion is left out")
        return False
    curve.is_of_time = True
    return True


def switch(deck: KeywordDeck, window: Window) -> Deck:
    """`from` and `until` of what acts in a window."""
    keys: Deck = {"from": name_sensor(deck, window.start)} if window.start > 0 else {}
    return keys | ({"until": name_sensor(deck, window.end)} if window.end is not None else {})


def add_motion(deck: KeywordDeck, target: Deck, motion: Deck) -> None:
    """A condition of nodes or of a body; or one that is there goes on with it."""
    for entry in deck.model.deck.get("conditions", []):
        if {key: entry[key] for key in ("nodes", "body") if key in entry} == target:
            for first, second in ((entry, motion), (motion, entry)):
                joined = join_motions(deck, first, second)
                if joined:
                    entry.clear()
                    entry.update({**target, **joined})
                    return
    deck.model.add("conditions", {**target, **motion})


def join_motions(deck: KeywordDeck, first: Deck, second: Deck) -> Deck | None:
    """A velocity over the time of both, where the second begins as the first ends,
    in the same direction; None otherwise."""
    if "until" not in first or first["until"] != second.get("from"):
        return None
    sensors: dict[str, Deck] = deck.model.deck["sensors"]
    times = [sensors[first["from"]]["time"] if "from" in first else 0.0, sensors[first["until"]]["time"]]
    times.append(sensors[second["until"]]["time"] if "until" in second else deck.end_time)
    directions, rows = set(), []
    for motion, start, end in ((first, *times[:2]), (second, *times[1:])):
        values = motion.get("velocity") or motion.get("displacement") or {}
        points = list_velocities(motion, start, end) if len(values) == 1 else None
        if points is None:
            return None
        directions |= set(values)
        rows += points
    if len(directions) > 1:
        return None
    ends = {key: motion[key] for motion, key in ((first, "from"), (second, "until")) if key in motion}
    return {"velocity": {directions.pop(): {"table": [list(row) for row in order_points(rows)]}}, **ends}


def list_velocities(motion: Deck, start: float, end: float) -> Points | None:
    """Velocities of a motion in one direction from one time to another; None of an expression."""
    (value,) = (motion.get("velocity") or motion["displacement"]).values()
    if isinstance(value, dict) and "table" not in value:
        return None
    points = [(x, y) for x, y in value["table"]] if isinstance(value, dict) else [(start, value), (end, value)]
    if "displacement" in motion:
        points = differentiate(points)
    return [(start, interpolate(points, start)), *((x, y) for x, y in points if start < x < end),
            (end, interpolate(points, end))]
