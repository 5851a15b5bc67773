"""*CONTROL_...: end, time step, viscosity."""

from ..fields import Row
from ..model import Deck
from .cards import Card
from .deck import KeywordDeck

HARMLESS = {
    "ACCURACY": "numerics", "OUTPUT": "output", "SOLUTION": "numerics", "CPU": "time limit",
    "PARALLEL": "percuss has the same bits on any ranks",
    "ENERGY": "percuss books all energies", "MPP": "decomposition", "SHELL": "percuss has one shell, whose thickness follows the strain",
    "SOLID": "numerics", "CONTACT": "numerics of the penalty method", "UNITS": "a text; --units says it", "RIGID": "of rigid bodies",
    "SUBCYCLE": "numerics", "REMESHING": "of adaptivity", "CHECK": "output", "DEBUG": "output", "REFINE": "of adaptivity",
    "PORE": "of soil water", "STAGED": "of stages", "FORMING": "of forming",
}  # fmt: skip
WITHOUT = {
    "IMPLICIT": "the run is explicit", "ADAPTIVE": "the mesh stays as it is", "ADAPSTEP": "the mesh stays as it is",
    "THERMAL": "there is no heat conduction", "ALE": "meshes are Lagrangian",
    "SPH": "there are no particles", "COUPLING": "there is no other program", "EXPLOSIVE_SHADOW": "burning goes on straight lines",
}  # fmt: skip


def read_termination(deck: KeywordDeck, card: Card) -> None:
    row = card.reader().row("ENDTIM ENDCYC DTMIN ENDENG ENDMAS NOSOL~")
    deck.end_time = row.positive("ENDTIM")
    time = deck.model.deck.setdefault("time", {})
    time["end"] = deck.end_time
    if row.integer("ENDCYC") > 0:
        time["max_steps"] = row.integer("ENDCYC")
    if 0 < row.number("DTMIN") < 1:
        time["collapse_ratio"] = row.number("DTMIN")
    row.skip("ENDENG", "ENDMAS")
    row.finish(deck.ledger)
    deck.ledger.translated(card.keyword, card.place, "time.end, max_steps, collapse_ratio")


def apply_timestep(deck: KeywordDeck, card: Card) -> None:
    row = card.reader().row("DTINIT~ TSSFAC ISDO~ TSLIMT~ DT2MS LCTM~ ERODE MS1ST")
    factor = row.number("TSSFAC") or 0.9
    if factor > 1:
        row.fail("TSSFAC", "above 1 no run is stable")
    deck.model.deck.setdefault("time", {})["step_scale"] = factor
    step = row.number("DT2MS")
    if step:
        scale_masses(deck, card, abs(step), bool(row.integer("MS1ST")), row)
    row.skip("MS1ST")
    if row.integer("ERODE") and deck.model.deck["time"].get("collapse_ratio", 0) == 0:
        row.skip("ERODE")
        deck.ledger.ignored("CONTROL_TIMESTEP.ERODE", card.place, "no effect without DTMIN of *CONTROL_TERMINATION")
    row.finish(deck.ledger, "it is left out")
    deck.ledger.translated(card.keyword, card.place, "time.step_scale")


def scale_masses(deck: KeywordDeck, card: Card, step: float, once: bool, row: Row) -> None:
    """Mass scaling of the parts that percuss can scale."""
    left: set[str] = set()
    for block in deck.model.blocks:
        if block.part in deck.rigid:
            continue
        law = deck.model.materials[block.keys["material"]]
        if block.solids and (law["model"] not in ("elastic", "j2_plasticity") or "equation_of_state" in law):
            left.add(law["model"])
            continue
        block.keys["mass_scaling"] = {"step": step, "max_added": 1.0, **({} if once else {"every": 10})}
    if left:
        deck.ledger.refuse(
            "CONTROL_TIMESTEP.DT2MS", row.place, f"mass scaling of solids of {', '.join(sorted(left))}", "these get no mass"
        )
    text = "mass_scaling of each part, at most its own mass"
    if row.number("DT2MS") > 0:
        text += "; no element loses mass"
    deck.ledger.approximated("CONTROL_TIMESTEP.DT2MS", row.place, text)


def apply_viscosity(deck: KeywordDeck, card: Card) -> None:
    row = card.reader().row("Q1=1.5 Q2=0.06 TYPE~ BTYPE~ TSTYPE~")
    viscosity: Deck = {"linear": row.number("Q2"), "quadratic": max(row.number("Q1"), 0.0) ** 0.5}
    deck.model.deck.setdefault("elements", {})["bulk_viscosity"] = viscosity
    row.finish(deck.ledger)
    deck.ledger.approximated(card.keyword, card.place, "linear = Q2, quadratic = sqrt(Q1), of shells too")


def apply_relaxation(deck: KeywordDeck, card: Card) -> None:
    """Explicit dynamic relaxation. DRFCTR, EDTTL and DRTERM steer a damping that percuss finds by itself."""
    row = card.reader().row("NRCYCK=250 DRTOL=0.001 DRFCTR=0.995 DRTERM TSSFDR IRELAL EDTTL=0.04 IDRFLG")
    flag, tolerance = row.integer("IDRFLG"), row.number("DRTOL") or 0.001
    row.skip("NRCYCK", "DRFCTR", "DRTERM", "TSSFDR", "IRELAL", "EDTTL")
    row.finish(deck.ledger)
    if flag <= 0:
        deck.ledger.ignored(card.keyword, card.place, "IDRFLG does not switch it on")
    elif flag > 1:
        deck.ledger.refuse("CONTROL_DYNAMIC_RELAXATION.IDRFLG", row.place, f"IDRFLG is {flag}", "the run starts without relaxation")
    else:
        deck.model.deck["start"] = {"relaxation": {"tolerance": min(tolerance, 0.1)}}
        deck.ledger.approximated(
            card.keyword, card.place, "start.relaxation: loads have their values at time 0; the damping follows the lowest frequency"
        )


def read_general_hourglass(deck: KeywordDeck, card: Card) -> None:
    deck.general_hourglass = card.reader().row("IHQ=1 QH=0.1")


def is_known_control(keyword: str) -> bool:
    """Whether a control without a counterpart is known; another one may be misspelt."""
    return keyword.removeprefix("CONTROL_").startswith((*HARMLESS, *WITHOUT))


def read_other_control(deck: KeywordDeck, card: Card) -> None:
    """Controls without a counterpart."""
    words = card.keyword.removeprefix("CONTROL_")
    for name, text in HARMLESS.items():
        if words.startswith(name):
            deck.ledger.ignored(card.keyword, card.place, text)
            return
    instead = next((text for name, text in WITHOUT.items() if words.startswith(name)), "it is left out")
    deck.ledger.refuse(card.keyword, card.place, "this control", instead)
