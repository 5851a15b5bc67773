"""*CONTROL_...: end, time step, viscosity."""

import math

from ..fields import Row
from ..model import Block, Deck, Vector
from ..shapes import dot, shell_area, solid_volume, subtract
from ..solids import FACES
from .cards import Card
from .deck import KeywordDeck
from .materials.states import initial_bulk_modulus

# Whatever their fields say.
HARMLESS = {
    "ACCURACY": "numerics", "OUTPUT": "output", "CPU": "time limit",
    "PARALLEL": "percuss has the same bits on any ranks", "ENERGY": "percuss books all energies",
    "UNITS": "a text; --units says it", "SUBCYCLE": "numerics", "CHECK": "output", "DEBUG": "output", "LSDA": "output",
    "REQUIRE_REVISION": "of the program", "PORE_FLUID": "of soil water, which no element has",
    "DISCRETE_ELEMENT": "of particles, which are refused", "FORMING_OUTPUT": "output",
    "FORMING_MAXID": "numbers of elements", "PZELECTRIC": "of electric fields, which no material has",
}  # fmt: skip
WITHOUT = {
    "IMPLICIT": "the run is explicit", "ADAPTIVE": "the mesh stays as it is", "ADAPT": "the mesh stays as it is",
    "ADAPSTEP": "the mesh stays as it is", "REFINE": "the mesh stays as it is", "REMESHING": "the mesh stays as it is",
    "COARSEN": "the mesh stays as it is", "THERMAL": "there is no heat conduction", "ALE": "meshes are Lagrangian",
    "STAGED": "all parts act from the start", "SPH": "there are no particles", "COUPLING": "there is no other program",
    "EXPLOSIVE_SHADOW": "burning goes on straight lines",
    "FORMING": "parts stay where the deck has them, and nothing is added to it",
    "MAT": "the failure of all materials acts", "START": "the run begins at time 0",
}  # fmt: skip
NO_LIMIT = 1e6  # times its mass that a part may get by mass scaling: LS-DYNA has no limit


def read_termination(deck: KeywordDeck, card: Card) -> None:
    row = card.reader().row("ENDTIM ENDCYC DTMIN ENDENG ENDMAS=1e8 NOSOL")
    deck.end_time = row.positive("ENDTIM")
    time = deck.model.deck.setdefault("time", {})
    time["end"] = deck.end_time
    if row.integer("ENDCYC") > 0:
        time["max_steps"] = row.integer("ENDCYC")
    if 0 < row.number("DTMIN") < 1:
        time["collapse_ratio"] = row.number("DTMIN")
    if row.number("ENDENG") > 0:
        deck.model.deck["audit"] = {"max_energy_error": row.number("ENDENG") / 100}
        deck.ledger.approximated("CONTROL_TERMINATION.ENDENG", card.place,
                                 "audit.max_energy_error; the run ends with exit code 3")
    deck.most_added_mass = row.number("ENDMAS") / 100
    if row.number("ENDMAS") < 0:
        deck.ledger.refuse("CONTROL_TERMINATION.ENDMAS", card.place,
                           "a limit of added mass by a curve", "there is no limit")
    if row.integer("NOSOL"):
        deck.ledger.ignored("CONTROL_TERMINATION.NOSOL", card.place, "percuss check ends before the first step")
    row.finish(deck.ledger)
    deck.ledger.translated(card.keyword, card.place, "time.end, max_steps, collapse_ratio")


def apply_timestep(deck: KeywordDeck, card: Card) -> None:
    reader = card.reader()
    row = reader.row("DTINIT~step TSSFAC ISDO~step TSLIMT DT2MS LCTM ERODE MS1ST")
    more = reader.row("DT2MSF DT2MSLC IMSCL UNUSED~unused UNUSED~unused RMSCL~unused EMSCL IHDO~step")
    factor = row.number("TSSFAC") or 0.9
    if factor > 1:
        row.fail("TSSFAC", "above 1 no run is stable")
    if factor < 0:
        deck.ledger.refuse("CONTROL_TIMESTEP.TSSFAC", card.place,
                           "a factor on the step that varies in time", "it is 0.9")
        factor = 0.9
    deck.model.deck.setdefault("time", {})["step_scale"] = factor
    limit_step(deck, row)
    if row.number("TSLIMT") > 0:
        deck.ledger.refuse("CONTROL_TIMESTEP.TSLIMT", card.place,
                           "TSLIMT: shells that get softer where their step is short", "they keep their stiffness")
    step = row.number("DT2MS")
    if step:
        more.skip("DT2MSF")  # of no effect beside DT2MS
        scale_masses(deck, abs(step), bool(row.integer("MS1ST")), row)
    if more.integer("IMSCL"):
        deck.ledger.refuse("CONTROL_TIMESTEP.IMSCL", card.place, "IMSCL: selective mass scaling",
                           "mass counts in all motions")
    share_gravity(deck, more, bool(step))
    row.skip("MS1ST")
    erode_short_steps(deck, card, row.integer("ERODE"))
    row.finish(deck.ledger, "it is left out")
    more.finish(deck.ledger, "it is left out")
    deck.ledger.translated(card.keyword, card.place, "time.step_scale")


def share_gravity(deck: KeywordDeck, more: Row, is_scaled: bool) -> None:
    """EMSCL: the share of the added mass on which gravity acts; in percuss it is all of it."""
    if is_scaled and more.number("EMSCL") not in (0.0, 1.0):
        text = f"EMSCL: gravity on {more.number('EMSCL'):g} of the added mass"
        deck.ledger.refuse("CONTROL_TIMESTEP.EMSCL", more.place, text, "gravity acts on all of it")
    more.skip("EMSCL")


def erode_short_steps(deck: KeywordDeck, card: Card, code: int) -> None:
    """ERODE with DTMIN: solids (1),
    shells (10) or both (11) are eroded where they allow less than DTMIN of the first step."""
    time = deck.model.deck["time"]
    if not code:
        return
    if time.get("collapse_ratio", 0) == 0:
        deck.ledger.ignored("CONTROL_TIMESTEP.ERODE", card.place, "no effect without DTMIN of *CONTROL_TERMINATION")
        return
    blocks = [block for block in deck.model.blocks if block.part not in deck.rigid and not block.beams]
    laws = {block.id: deck.model.materials[block.keys["material"]] for block in blocks}
    steps = [find_first_step(deck.nodes, block, laws[block.id]) for block in blocks]
    first = min((step for step in steps if step is not None), default=0.0)
    if None in steps or not math.isfinite(first):
        deck.ledger.refuse("CONTROL_TIMESTEP.ERODE", card.place, "ERODE: elements that are eroded where their step is "
                                                                 "below DTMIN, beside laws without Young's modulus",
                           "the run ends there")
        return
    least = time["step_scale"] * time["collapse_ratio"] * first
    for block in blocks:
        if code % 10 == 1 if block.solids else code // 10 % 10 == 1:
            law = laws[block.id]
            law["failure"] = {**law.get("failure", {}), "step": max(law.get("failure", {}).get("step", 0.0), least),
                              "inverted": True}
    time["collapse_ratio"] = min(1e-4, 0.1 * time["collapse_ratio"])
    deck.ledger.approximated("CONTROL_TIMESTEP.ERODE", card.place,
                             f"failure.step of {least:.4g}: DTMIN of the least step at the start by LS-DYNA's rule, "
                             "up to 1.6 times that of percuss; and failure.inverted")


def find_first_step(nodes: dict[int, Vector], block: Block, law: Deck) -> float | None:
    """The least step of its elements: volume over the largest face, or area over the longest edge,
    by the speed of sound; None: it is not known."""
    stiffness = find_wave_stiffness(block, law)
    if stiffness is None:
        return None
    lengths = (find_length([nodes[n] for n in corners]) for _, corners in block.solids) if block.solids else (
        find_width([nodes[n] for n in dict.fromkeys(corners)]) for _, corners in block.shells)  # fmt: skip
    return min(lengths, default=0.0) * (law["density"] / stiffness) ** 0.5 if stiffness > 0 else math.inf


def find_wave_stiffness(block: Block, law: Deck) -> float | None:
    """Density times the square of the speed of sound at the start;
    0 of a gas that is cold, None of other laws without Young's modulus."""
    if law["model"] == "fluid":
        return initial_bulk_modulus(law["equation_of_state"], law["density"])
    if "youngs_modulus" not in law:
        return None
    young, poisson = law["youngs_modulus"], law.get("poissons_ratio", 0.0)
    if block.solids:
        return float(young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson)))
    return float(young / (1 - poisson**2))


def find_length(x: list[Vector]) -> float:
    """Characteristic length of a solid."""
    areas = [shell_area([x[i] for i in face]) for face in FACES[len(x)]] if len(x) in FACES else []
    return solid_volume(x) / max(areas) if areas else 0.0


def find_width(x: list[Vector]) -> float:
    """Characteristic length of a shell."""
    edges = [subtract(a, b) for a, b in zip(x, x[1:] + x[:1])]
    return float(shell_area(x) / max(dot(edge, edge) ** 0.5 for edge in edges))


def limit_step(deck: KeywordDeck, row: Row) -> None:
    """LCTM: an upper bound of the step, which percuss has as a number."""
    if not row.integer("LCTM"):
        return
    points = deck.material_curve(row.integer("LCTM"), row.place, "time", "time")
    least = min((y for _, y in points), default=0.0)
    if least > 0:
        deck.model.deck["time"]["max_step"] = least
        deck.ledger.approximated("CONTROL_TIMESTEP.LCTM", row.place, "time.max_step: the least value of the curve")


def scale_masses(deck: KeywordDeck, step: float, once: bool, row: Row) -> None:
    """Mass scaling of the parts that limit the step."""
    most = min(deck.most_added_mass, NO_LIMIT) if deck.most_added_mass > 0 else NO_LIMIT
    held = deck.held_as_bodies()
    for block in deck.model.blocks:
        if block.part in deck.rigid:
            continue
        again = {} if once or held else {"every": 10}
        block.keys["mass_scaling"] = {"step": step, "max_added": most, **again}
    text = ("mass_scaling of each part, without a limit; the run says at its start how much mass that adds; "
            "gravity acts on it too")
    if row.number("DT2MS") > 0:
        text += "; no element loses mass"
    if held and not once:
        text += "; beside nodal rigid bodies at the start alone, as with MS1ST"
    deck.ledger.approximated("CONTROL_TIMESTEP.DT2MS", row.place, text)


def apply_viscosity(deck: KeywordDeck, card: Card) -> None:
    row = card.reader().row("Q1=1.5 Q2=0.06 TYPE~shells BTYPE~shells TSTYPE~shells")
    viscosity: Deck = {"linear": row.number("Q2"), "quadratic": max(row.number("Q1"), 0.0) ** 0.5}
    deck.model.deck.setdefault("elements", {})["bulk_viscosity"] = viscosity
    row.finish(deck.ledger)
    deck.ledger.approximated(card.keyword, card.place, "linear = Q2, quadratic = sqrt(Q1), of shells too")


def check_shells(deck: KeywordDeck, card: Card) -> None:
    """*CONTROL_CHECK_SHELL: limits of what LS-DYNA reports, but for the elements that it changes."""
    reader = card.reader()
    while reader.skip_blank():
        row = reader.row("PSID~output IFAUTO CONVEX~output ADPT~adaptive ARATIO~output ANGLE~output SMIN~output")
        row.finish(deck.ledger, "bad elements stay as they are")
    deck.ledger.ignored(card.keyword, card.place, "percuss check reports bad elements")


def apply_relaxation(deck: KeywordDeck, card: Card) -> None:
    """Explicit dynamic relaxation; *CONTROL_DAMPING is another name of the card.
    DRFCTR, EDTTL and DRTERM steer a damping that percuss finds by itself."""
    row = card.reader().row("NRCYCK~damping=250 DRTOL=0.001 DRFCTR~damping=0.995 DRTERM~damping TSSFDR~damping "
                            "IRELAL~damping EDTTL~damping=0.04 IDRFLG")
    flag, tolerance = row.integer("IDRFLG"), row.number("DRTOL") or 0.001
    row.finish(deck.ledger)
    if flag <= 0:
        deck.ledger.ignored(card.keyword, card.place, "IDRFLG does not switch it on")
    elif flag > 1:
        deck.ledger.refuse("CONTROL_DYNAMIC_RELAXATION.IDRFLG", row.place, f"IDRFLG is {flag}",
                           "the run starts without relaxation")
    else:
        deck.model.deck["start"] = {"relaxation": {"tolerance": min(tolerance, 0.1)}}
        deck.ledger.approximated(
            card.keyword, card.place,
            "start.relaxation: loads have their values at time 0; the damping follows the lowest frequency"
        )


def read_general_hourglass(deck: KeywordDeck, card: Card) -> None:
    deck.general_hourglass = card.reader().row("IHQ=1 QH=0.1")


def is_known_control(keyword: str) -> bool:
    """Whether a control without a counterpart is known; another one may be misspelt."""
    words = keyword.removeprefix("CONTROL_")
    return words in HARMLESS or words.startswith(("MPP_", *WITHOUT))


def read_shell_control(deck: KeywordDeck, card: Card) -> None:
    """*CONTROL_SHELL: percuss has one shell; what is left is the failure of distorted elements."""
    reader = card.reader()
    rows = [
        reader.row(
            "WRPANG~output=20 ESORT~shells IRNXX~shells=-1 ISTUPD THEORY=2 BWC~shells=2 MITER~shells=1 PROJ~shells"),
        reader.row("ROTASCL=1 INTGRD LAMSHT~shells CSTYP6~shells=1 THSHEL~thermal"),
        reader.row("PSTUPD SIDT4TU~shells CNTCO ITSFLG~shells IRQUAD~shells=3 W_MODE STRETCH ICRQ~shells"),
        reader.row("NFAIL1 NFAIL4 PSNFAIL KEEPCS~shells DELFR DRCPSID~shells DRCPRM~shells=1 INTPERR~output"),
        reader.row("DRCMTH~shells LISPSID NLOCDT~shells ISWSHL~shells"),
    ]
    first, second, third, fourth, _ = rows
    deck.shell_form = first.integer("THEORY")
    deck.contact_at_offset = deck.contact_at_offset or third.integer("CNTCO") != 0
    if first.integer("ISTUPD") == 0 or third.integer("PSTUPD"):
        deck.ledger.approximated("CONTROL_SHELL.ISTUPD", first.place,
                                 "the thickness of all shells follows their strain")
    if second.integer("INTGRD"):
        deck.ledger.approximated("CONTROL_SHELL.INTGRD", second.place, "Gauss points in place of Lobatto's")
    if any(fourth.numbers("NFAIL1", "NFAIL4")):
        deck.erodes_folded_shells, deck.folded_shells = True, fourth.integer("PSNFAIL")
        deck.ledger.approximated("CONTROL_SHELL.NFAIL1", fourth.place,
                                 "failure.inverted of shells, "
                                 "all or those of PSNFAIL: one with a corner that has folded over is eroded")
    fourth.skip("PSNFAIL")  # of effect with these, and with W_MODE, alone
    for row in rows:
        row.finish(deck.ledger, "it is left out")
    deck.ledger.approximated(card.keyword, card.place, "percuss has one shell, whose thickness follows the strain")


def read_solid_control(deck: KeywordDeck, card: Card) -> None:
    """*CONTROL_SOLID: numerics, but for the nodes of tetrahedra and what negative volumes do."""
    reader = card.reader()
    row = reader.row(
        "ESORT~solids FMATRX~solids NIPTETS~solids=4 SWLOCL~solids=1 PSFAIL T10JTOL~solids ICOH~solids TET13K~implicit")
    names = " ".join(f"PM{i}" for i in range(1, 11))
    order = reader.row(names, (8,) * 10)
    more = reader.row("TET13V~solids RINRT~solids COHEQC")
    given = order.numbers(*names.split())
    if given not in ([float(i) for i in range(1, 11)], [0.0] * 10):
        wrong = next((i for i, value in enumerate(given, 1) if value not in (0.0, i)),
                     next(i for i, value in enumerate(given, 1) if value))
        deck.ledger.refuse("CONTROL_SOLID.PM1", order.place,
                           f"another order of the nodes of tetrahedra (PM{wrong} is {given[wrong - 1]:g})",
                           "the usual order is read")
    order.skip(*names.split())
    if row.integer("PSFAIL"):
        deck.eroded_when_inverted = row.integer("PSFAIL")
        deck.ledger.approximated("CONTROL_SOLID.PSFAIL", row.place, "failure.inverted of these parts")
    if more.integer("COHEQC") % 10 == 2:
        deck.ledger.refuse("CONTROL_SOLID.COHEQC", more.place,
                           "COHEQC: cohesive elements of poor shape are deleted at the start", "they are kept")
    more.skip("COHEQC")  # other values are about messages
    for found in (row, more):
        found.finish(deck.ledger, "it is left out")
    deck.ledger.ignored(card.keyword, card.place, "numerics of solids")


def read_rigid_control(deck: KeywordDeck, card: Card) -> None:
    """*CONTROL_RIGID: numerics of joints and flexible bodies, but for stiffness and damping of all joints."""
    reader = card.reader()
    row = reader.row(
        "LMF~joints JNTF~joints ORTHMD~joints PARTM~joints SPARSE~joints METALF~joints PLOTEL~output RBSMS~joints")
    more = reader.row("NORBIC~joints GJADSTF GJADVSC TJADSTF TJADVSC RCVLR2D~joints")
    for found in (row, more):
        found.finish(deck.ledger, "joints have none")
    deck.ledger.ignored(card.keyword, card.place, "numerics of joints")


def read_solution(deck: KeywordDeck, card: Card) -> None:
    """*CONTROL_SOLUTION: SOLN asks for heat conduction."""
    row = card.reader().row(
        "SOLN NLQ~solver ISNAN~solver LCINT~solver=100 LCACC~solver NCDCF~solver=1 NOCOPY~solver CRVP~solver")
    if row.integer("SOLN"):
        deck.ledger.refuse("CONTROL_SOLUTION.SOLN", row.place, "a thermal solution", "there is no heat conduction")
    row.finish(deck.ledger)
    deck.ledger.ignored(card.keyword, card.place, "numerics")


def read_other_control(deck: KeywordDeck, card: Card) -> None:
    """Controls without a counterpart."""
    words = card.keyword.removeprefix("CONTROL_")
    text = "decomposition" if words.startswith("MPP_") else HARMLESS.get(words)
    if words == "ADAPTIVE" and not any(part.is_adaptive for part in deck.parts.values()):
        text = "no part has ADPOPT"
    if text:
        deck.ledger.ignored(card.keyword, card.place, text)
        return
    found = [name for name in WITHOUT if words == name or words.startswith(f"{name}_")]
    instead = WITHOUT[max(found, key=len)] if found else "it is left out"
    deck.ledger.refuse(card.keyword, card.place, "this control", instead)
