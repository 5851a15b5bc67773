"""*EOS_...: equations of state."""

from ...curves import Points, order_points
from ...fields import Row
from ...model import Deck
from ..cards import Lines
from ..deck import KeywordDeck
from .shared import Use


def check_volume(deck: KeywordDeck, row: Row, name: str) -> None:
    """The relative volume at the start."""
    if row.number(name) not in (0, 1):
        deck.ledger.refuse(f"{row.card}.V0", row.place, "an initial relative volume other than 1", "1 is used")


def linear_polynomial(deck: KeywordDeck, use: Use) -> Deck:
    reader = use.state.reader()  # type: ignore[union-attr]
    row, more = reader.row("EOSID C0 C1 C2 C3 C4 C5 C6"), reader.row("E0 V0")
    check_volume(deck, more, "V0")
    state: Deck = {"kind": "polynomial"}
    for number in range(7):
        value = row.number(f"C{number}")
        if value or number == 1:
            state[f"c{number}"] = value
    if more.number("E0"):
        state["start_energy"] = more.number("E0")
    return state


def grueneisen(deck: KeywordDeck, use: Use) -> Deck:
    reader = use.state.reader()  # type: ignore[union-attr]
    row, more = reader.row("EOSID C S1 S2 S3 GAMMA0 A E0"), reader.row("V0 UNUSED~unused LCID")
    row.skip("EOSID")
    state: Deck = {
        "kind": "mie_grueneisen",
        "sound_speed": row.positive("C"),
        "slope": row.number("S1"),
        "grueneisen": row.number("GAMMA0"),
    }
    for field, key in (("E0", "start_energy"), ("S2", "slope_2"), ("S3", "slope_3"), ("A", "grueneisen_slope")):
        if row.number(field):
            state[key] = row.number(field)
    check_volume(deck, more, "V0")
    more.finish(deck.ledger)
    return state


def ideal_gas(deck: KeywordDeck, use: Use) -> Deck:
    """Constant specific heats; the energy at the start is that of T0."""
    reader = use.state.reader()  # type: ignore[union-attr]
    row, more = reader.row("EOSID CV CP CL CQ T0 V0 VC0"), reader.row("ADIAB")
    row.skip("EOSID")
    heat, pressure_heat = row.positive("CV"), row.positive("CP")
    if pressure_heat <= heat:
        row.fail("CP", "must be above CV")
    check_volume(deck, row, "V0")
    state: Deck = {"kind": "ideal_gas", "gamma": pressure_heat / heat,
                   "start_energy": use.density * heat * row.positive("T0")}
    row.finish(deck.ledger, "specific heats are constant")
    more.finish(deck.ledger, "the gas heats by the work of compression, as with ADIAB=0")
    return state


def tabulated(deck: KeywordDeck, use: Use) -> Deck:
    """Curves over ln(V / V0), or two cards each of five values: ln(V / V0), C, T."""
    reader = use.state.reader()  # type: ignore[union-attr]
    row = reader.row("EOSID GAMA E0 V0 LCC LCT")
    row.skip("EOSID")
    check_volume(deck, row, "V0")
    curves = {"cold": row.integer("LCC"), "heat": row.integer("LCT")}
    if any(curves.values()):
        up = {"cold": "stress", "heat": "none"}
        tables = {key: order_points(deck.material_curve(id, row.place, "none", up[key]))
                  for key, id in curves.items() if id}
    else:
        tables = read_tables(reader)
    if not tables.get("cold"):
        row.fail("LCC", "must name the curve of C where LCT names one")
    state: Deck = {"kind": "tabulated"}
    for key, points in tables.items():
        if key == "cold" or row.number("GAMA"):
            state[key] = [list(point) for point in points]
    for field, key in (("GAMA", "gamma"), ("E0", "start_energy")):
        if row.number(field):
            state[key] = row.number(field)
    if len(state["cold"]) < 2:
        row.fail("LCC", "must have two values of C or more")
    if any(y1 <= y2 for (_, y1), (_, y2) in zip(state["cold"], state["cold"][1:])):
        row.fail("LCC", "must give a pressure that falls over ln(V / V0), the natural logarithm of the relative volume")
    return state


def read_tables(reader: Lines) -> dict[str, Points]:
    """Ten values of each, in lines of five fields of sixteen columns; zeros at the end are none."""
    columns = {}
    for name in ("EV", "C", "T"):
        rows = [reader.row(" ".join(f"{name}{i}" for i in range(first, first + 5)), (16,) * 5) for first in (1, 6)]
        columns[name] = [row.number(f"{name}{5 * k + i}") for k, row in enumerate(rows) for i in range(1, 6)]
    points = list(zip(columns["EV"], columns["C"], columns["T"]))
    while len(points) > 1 and points[-1] == (0, 0, 0):
        points.pop()
    points.sort()
    return {"cold": [(x, c) for x, c, _ in points], "heat": [(x, t) for x, _, t in points]}


def jwl(deck: KeywordDeck, use: Use) -> Deck:
    row = use.state.reader().row("EOSID A B R1 R2 OMEG E0 V0")  # type: ignore[union-attr]
    check_volume(deck, row, "V0")
    values = row.numbers("A", "B", "R1", "R2", "OMEG")
    return {"kind": "jwl", **dict(zip(("a", "b", "r1", "r2", "omega"), values)), "energy": row.positive("E0")}


STATES = {"EOS_LINEAR_POLYNOMIAL": linear_polynomial, "EOS_001": linear_polynomial, "EOS_1": linear_polynomial,
          "EOS_GRUNEISEN": grueneisen, "EOS_004": grueneisen, "EOS_4": grueneisen, "EOS_IDEAL_GAS": ideal_gas,
          "EOS_012": ideal_gas, "EOS_12": ideal_gas, "EOS_JWL": jwl, "EOS_002": jwl, "EOS_2": jwl,
          "EOS_TABULATED": tabulated, "EOS_009": tabulated, "EOS_9": tabulated}  # fmt: skip


def translate_state(deck: KeywordDeck, use: Use) -> Deck | None:
    """The equation of state of a part; None without one, or where it is refused."""
    if use.state is None:
        return None
    use.has_used_state = True
    translate = STATES.get(use.state.keyword)
    if translate is None:
        deck.ledger.refuse(
            use.state.keyword,
            use.state.place,
            "this equation of state",
            "the law is used without it, or the part is left out",
        )
        return None
    state = translate(deck, use)
    deck.ledger.translated(use.state.keyword, use.state.place, state["kind"])
    return state


def initial_bulk_modulus(state: Deck, density: float) -> float:
    """Slope of pressure over compression at the start."""
    if state["kind"] == "linear":
        return float(state["bulk_modulus"])
    if state["kind"] == "mie_grueneisen":
        return float(density * state["sound_speed"] ** 2)
    if state["kind"] == "tabulated":
        rows = state["cold"]
        (x0, y0), (x1, y1) = next((pair for pair in zip(rows, rows[1:]) if pair[1][0] > 0), (rows[-2], rows[-1]))
        return float((y0 - y1) / (x1 - x0))
    return state.get("c1", 0.0)
