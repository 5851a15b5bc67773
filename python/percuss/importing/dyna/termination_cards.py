"""*TERMINATION_...: what ends the run before ENDTIM. The sensors of percuss look at rows of the history."""

from ..fields import Row, parse_integer
from ..ledger import BadInput, Place, missing
from ..model import Deck
from .cards import Card
from .deck import KeywordDeck

AXES = {1: "x", 2: "y", 3: "z"}
NO_LIMIT = 1e21
OF_SENSOR = "part of the sensor that ends the run"
GOES_ON = "; the run goes on to ENDTIM, and is the same until then"
LEVELS = {"GT": "rises_above", "LT": "falls_below"}


def read_node_limit(deck: KeywordDeck, card: Card) -> None:
    """*TERMINATION_NODE: a coordinate of a node reaches MAXC or MINC."""
    reader = card.reader()
    while reader.skip_blank():
        row = reader.row("NID STOP MAXC MINC")
        node, axis = row.integer("NID"), row.integer("STOP")
        if node not in deck.nodes:
            raise BadInput(row.place, missing(f"node {node}"))
        if axis in AXES:
            end_at_limits(deck, row, {"value": f"{follow(deck, node, row.place)}_{AXES[axis]}"})
        else:
            row.skip("MAXC", "MINC")
            deck.ledger.approximated(
                "TERMINATION_NODE.STOP", row.place,
                ("a force of contact on a node ends no run" if axis == 4 else f"STOP {axis} ends no run") + GOES_ON)


def read_body_limit(deck: KeywordDeck, card: Card) -> None:
    """*TERMINATION_BODY: a displacement of the mass centre of a rigid part reaches MAXC or MINC."""
    reader = card.reader()
    while reader.skip_blank():
        row = reader.row("PID STOP MAXC MINC")
        part, axis = row.integer("PID"), row.integer("STOP")
        deck.find_part(part, row.place)
        nodes = deck.nodes_of_part(part)
        body = next((deck.bodies_of_nodes[node] for node in nodes if node in deck.bodies_of_nodes), "")
        if axis in AXES and body:
            end_at_limits(deck, row, {"value": f"body_{AXES[axis]}:{body}", "from_start": True})
        else:
            row.skip("MAXC", "MINC")
            problem = "a displacement in any direction" if body else "a part that is not rigid"
            deck.ledger.approximated("TERMINATION_BODY.STOP", row.place, f"{problem} ends no run{GOES_ON}")


def read_other_end(deck: KeywordDeck, card: Card) -> None:
    """*TERMINATION_CONTACT, _CURVE, _DELETED_SHELLS and others."""
    deck.ledger.approximated(card.keyword, card.place, f"this event ends no run{GOES_ON}")


def end_at_limits(deck: KeywordDeck, row: Row, value: Deck) -> None:
    """MAXC and MINC, of which 0 is none."""
    for field, level, none in (("MAXC", "rises_above", NO_LIMIT), ("MINC", "falls_below", -NO_LIMIT)):
        limit = row.number(field)
        if limit and abs(limit) < abs(none):
            end_at(deck, row.card, row.place, {**value, level: limit})


def end_at(deck: KeywordDeck, card: str, place: Place, sensor: Deck) -> None:
    """The run ends by this sensor."""
    time = deck.model.deck["time"]
    if "until" in time:
        deck.ledger.approximated(f"{card}.several", place,
                                 "of several events the first one of the deck alone ends the run")
        return
    time["until"] = deck.model.names.take("stop")
    deck.model.deck.setdefault("sensors", {})[time["until"]] = sensor
    deck.ledger.approximated(card, place, "time.until of a sensor, which looks at rows of the history")


def follow(deck: KeywordDeck, node: int, place: Place) -> str:
    """A node of the history, ahead of others: their number is limited."""
    if node not in deck.used_nodes():
        raise BadInput(place, f"node {node} has no element (percuss follows nodes of elements): choose one that has")
    deck.output.nodes.insert(0, node)
    return f"node_{node}"


def read_sensor_end(deck: KeywordDeck, card: Card) -> None:
    """*TERMINATION_SENSOR: a switch of a time, or of a node."""
    reader = card.reader()
    while reader.skip_blank():
        row = reader.row("SWID")
        wanted = row.integer("SWID")
        found = find_card(deck, "SENSOR_SWITCH", wanted)
        if found is None:
            raise BadInput(row.place, missing(f"*SENSOR_SWITCH {wanted}"))
        switch = found.reader().row("SWITID~label TYPE SENSID LOGIC VALUE FILTRID TIMWIN")
        switch.skip("SWITID")
        deck.sensors.remove(found)
        deck.ledger.translated(found.keyword, found.place, OF_SENSOR)
        sensor = make_sensor(deck, switch)
        switch.finish(deck.ledger, "the value itself counts")
        if sensor:
            end_at(deck, "TERMINATION_SENSOR", row.place, sensor)
        else:
            deck.ledger.approximated("TERMINATION_SENSOR", row.place,
                                     "a sensor of another kind than of the time, "
                                     f"or of places and velocities of nodes, ends no run{GOES_ON}")


def find_card(deck: KeywordDeck, keyword: str, id: int) -> Card | None:
    """The card of sensors with this id, which is its first field."""
    return next((card for card in deck.sensors if card.keyword.startswith(keyword) and find_id(card) == id), None)


def find_id(card: Card) -> int | None:
    return parse_integer(card.split(card.lines[0], (10,))[0]) if card.lines else None


def make_sensor(deck: KeywordDeck, switch: Row) -> Deck | None:
    """A sensor of percuss; None where it has no such one."""
    logic, kind = switch.text("LOGIC").upper(), switch.text("TYPE").upper()
    if kind.startswith("T"):
        switch.skip("SENSID")
        return {"time": max(switch.number("VALUE"), 0.0)} if logic == "GT" else None
    id = switch.integer("SENSID")
    found = find_card(deck, "SENSOR_DEFINE_", id)
    if found is None:
        raise BadInput(switch.place, missing(f"sensor {id}"))
    deck.sensors.remove(found)
    deck.ledger.translated(found.keyword, found.place, OF_SENSOR)
    level = {LEVELS[logic]: switch.number("VALUE")} if logic in LEVELS else None
    if found.keyword != "SENSOR_DEFINE_NODE" or level is None:
        return None
    row = found.reader().row("SENSID~label NODE1 NODE2 VID UNUSED~unused CTYPE")
    first, second, axis, what = (row.integer("NODE1"), row.integer("NODE2"), row.text("VID").lower(),
                                 row.text("CTYPE").upper())
    if second and what.startswith("COOR") and axis in ("", "0"):
        return {"distance": [follow(deck, node, row.place) for node in (first, second)], **level}
    if second or axis not in AXES.values() or not what.startswith(("COOR", "VEL")):
        return None
    return {"value": f"{follow(deck, first, row.place)}_{'v' if what[0] == 'V' else ''}{axis}", **level}
