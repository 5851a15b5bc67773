"""Birth and death: sensors of times, which switch conditions and loads."""

from dataclasses import dataclass

from ..model import Deck
from .deck import KeywordDeck


@dataclass
class Window:
    """When a motion acts; end: None is the end of the run."""

    start: float = 0.0
    end: float | None = None


def name_sensor(deck: KeywordDeck, time: float) -> str:
    """The sensor of a time."""
    sensors = deck.model.deck.setdefault("sensors", {})
    for name, sensor in sensors.items():
        if sensor == {"time": time}:
            return name
    name = deck.model.names.take(f"time_{len(sensors) + 1}", "time")
    sensors[name] = {"time": time}
    return name


def switch(deck: KeywordDeck, window: Window) -> Deck:
    """`from` and `until` of what acts in a window."""
    keys: Deck = {"from": name_sensor(deck, window.start)} if window.start > 0 else {}
    return keys | ({"until": name_sensor(deck, window.end)} if window.end is not None else {})
