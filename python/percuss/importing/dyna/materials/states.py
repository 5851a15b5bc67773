"""*EOS_...: equations of state."""

from ...fields import Row
from ...model import Deck
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
    if row.number("E0"):
        state["start_energy"] = row.number("E0")
    check_volume(deck, more, "V0")
    row.finish(deck.ledger, "it is taken as 0")
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
    state: Deck = {"kind": "ideal_gas", "gamma": pressure_heat / heat, "start_energy": use.density * heat * row.positive("T0")}
    row.finish(deck.ledger, "specific heats are constant")
    more.finish(deck.ledger, "the gas heats by the work of compression, as with ADIAB=0")
    return state


def jwl(deck: KeywordDeck, use: Use) -> Deck:
    row = use.state.reader().row("EOSID A B R1 R2 OMEG E0 V0")  # type: ignore[union-attr]
    check_volume(deck, row, "V0")
    values = row.numbers("A", "B", "R1", "R2", "OMEG")
    return {"kind": "jwl", **dict(zip(("a", "b", "r1", "r2", "omega"), values)), "energy": row.positive("E0")}


STATES = {"EOS_LINEAR_POLYNOMIAL": linear_polynomial, "EOS_001": linear_polynomial, "EOS_1": linear_polynomial,
          "EOS_GRUNEISEN": grueneisen, "EOS_004": grueneisen, "EOS_4": grueneisen,
          "EOS_IDEAL_GAS": ideal_gas, "EOS_012": ideal_gas, "EOS_12": ideal_gas, "EOS_JWL": jwl, "EOS_002": jwl, "EOS_2": jwl}  # fmt: skip


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
    if state["kind"] == "mie_grueneisen":
        return density * state["sound_speed"] ** 2
    return state.get("c1", 0.0)
