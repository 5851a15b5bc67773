"""Orthotropic laws: elastic, and plies of composites that fail."""

from dataclasses import dataclass

from ...fields import Row
from ...laminates import find_crack_energy, find_element_axes, find_size
from ...ledger import missing
from ...model import Deck, Vector
from ...shapes import cross
from ..cards import Card
from ..deck import KeywordDeck
from ..transforms import apply
from .shared import Use, finish_lines, set_failure

CONSTANTS = "MID RO EA EB EC PRBA PRCA PRCB"
OF_SHELLS = "MID RO EA EB EC~unused PRBA PRCA~unused PRCB~unused"
POINT = "XP~unused YP~unused ZP~unused A1 A2 A3"
VECTORS = "V1 V2 V3 D1 D2 D3"
NO_LIMIT = 1.0  # the largest strain that LS-DYNA takes for a limit
MOST_STEP = 0.1  # a TFAIL above is a share of the first step


def read_vector(card: Card, row: Row, names: str) -> Vector:
    """A direction in the axes of the model, of a file that may be turned."""
    rows = card.change.transform[0]
    return apply((rows, (0.0, 0.0, 0.0)), tuple(row.numbers(*names.split())))  # type: ignore[arg-type]


def find_system(deck: KeywordDeck, card: Card, row: Row) -> tuple[Vector, Vector, Vector]:
    """The axes of the system that AOPT below 0 names."""
    id = int(-row.number("AOPT")) + card.change.offsets.get("IDDOFF", 0)
    if id not in deck.systems:
        row.fail("AOPT", missing(f"system {id} of axes that is read"))
    return deck.systems[id]


def add_axes(deck: KeywordDeck, card: Card, use: Use, law: Deck, lines: tuple[Row, Row, Row], angle: float) -> None:
    """AOPT: directions of the axes at the start. lines: those with AOPT, with A and with V.
    angle: BETA or MANGLE, which turns axes 0 and 3 of shells."""
    options, point, vectors = lines
    if card.change.mirrors():
        deck.ledger.refuse(f"{card.keyword}.mirror", card.place,
                           "axes of a material in a file that is mirrored", "they are not mirrored")
    (add_shell_axes if use.is_shell else add_solid_axes)(deck, card, use, law, lines)
    if options.number("AOPT") not in (0, 3) or not use.is_shell:
        refuse_angle(deck, card, options, angle)
        angle = 0.0
    if use.is_shell:
        use.turn += turn_by_elements(deck, use, options, angle)
    for row, names in ((point, "A1 A2 A3"), (vectors, "V1 V2 V3 D1 D2 D3")):
        row.skip(*names.split())  # those that AOPT does not ask for


def refuse_angle(deck: KeywordDeck, card: Card, row: Row, angle: float) -> None:
    if angle:
        name = "MANGLE" if card.keyword == "MAT_ENHANCED_COMPOSITE_DAMAGE" else "BETA"
        deck.ledger.refuse(f"{card.keyword}.{name}", row.place,
                           f"{name} with AOPT = {row.number('AOPT'):g}, or of solids", "it turns nothing")


def add_shell_axes(deck: KeywordDeck, card: Card, use: Use, law: Deck, lines: tuple[Row, Row, Row]) -> None:
    """What of a direction lies in the plane of each shell, or the side from its first corner to its second."""
    options, point, vectors = lines
    option = options.number("AOPT")
    if option == 2:
        law["first_axis"] = list(read_vector(card, point, "A1 A2 A3"))
    elif option == 3:  # V x normal is V, turned by -90 degrees
        law["first_axis"] = list(read_vector(card, vectors, "V1 V2 V3"))
        use.turn = -90.0
    elif option < 0:
        law["first_axis"] = list(find_system(deck, card, options)[0])
    else:
        if option:
            deck.ledger.refuse(f"{card.keyword}.AOPT", options.place,
                               f"AOPT = {option:g}: axes around a point or an axis",
                               "axis 1 is the first side of each shell")
        law["axes"] = "elements"
        return
    if not any(law["first_axis"]):
        options.fail("AOPT", "the vector of its axis is zero")


def turn_by_elements(deck: KeywordDeck, use: Use, row: Row, angle: float) -> float:
    """The angle of *ELEMENT_SHELL_BETA in place of that of the material, or on top of other axes."""
    if use.has_systems:
        deck.ledger.refuse("ELEMENT_SHELL.MCID", use.place, "shells with systems of axes of their own",
                           "those of their material are used")
    angles = sorted(use.angles) or [0.0]
    if len(angles) > 1:
        text = f"BETA that differs between the shells of a part, from {angles[0]:g} to {angles[-1]:g}"
        deck.ledger.refuse("ELEMENT_SHELL.BETA", use.place, text, "that of their material is used")
        return angle
    if not angles[0]:
        return angle
    deck.ledger.translated("ELEMENT_SHELL.BETA", use.place, "angle of the plies of the part")
    return angles[0] if row.number("AOPT") in (0, 3) else angle + angles[0]


def add_solid_axes(deck: KeywordDeck, card: Card, use: Use, law: Deck, lines: tuple[Row, Row, Row]) -> None:
    options, point, vectors = lines
    option = options.number("AOPT")
    axes: tuple[Vector, Vector] | None = None
    if option == 2:
        axes = read_vector(card, point, "A1 A2 A3"), read_vector(card, vectors, "D1 D2 D3")
    elif option < 0:
        axes = find_system(deck, card, options)[:2]
    elif option == 0:
        axes = (find_own_axes(deck, use) if any(id in deck.solid_axes for id, _ in use.solids)
                else find_element_axes(deck.model, use.solids))
    if option and any(id in deck.solid_axes for id, _ in use.solids):
        deck.ledger.refuse(f"{card.keyword}.AOPT", options.place, f"AOPT = {option:g} beside *ELEMENT_SOLID_ORTHO",
                           "the axes are those of AOPT")
    if axes is None:
        text = "axes that differ between its elements" if option == 0 else f"AOPT = {option:g} of solids"
        deck.ledger.refuse(f"{card.keyword}.AOPT", options.place, text, "the axes are those of space")
        return
    law["first_axis"], law["second_axis"] = list(axes[0]), list(axes[1])


def find_own_axes(deck: KeywordDeck, use: Use) -> tuple[Vector, Vector] | None:
    """Axes of *ELEMENT_SOLID_ORTHO, where all elements have the same."""
    found = [deck.solid_axes.get(id) for id, _ in use.solids]
    axes = found[0]
    return axes if axes and all(other == axes for other in found) and any(cross(*axes)) else None


def read_constants(card: Card, row: Row, shear: Row, use: Use) -> Deck:
    """PRBA is nu_ba: the strain along a by a stress along b. percuss has nu_ab."""
    row.skip("MID")
    e = [row.positive("EA"), row.positive("EB")]
    is_plane = use.is_shell and card.keyword == "MAT_ENHANCED_COMPOSITE_DAMAGE"
    e.append(e[1] if is_plane or (use.is_shell and not row.number("EC")) else row.positive("EC"))
    ba, ca, cb = row.number("PRBA"), *((0.0, 0.0) if is_plane else row.numbers("PRCA", "PRCB"))
    return {
        "model": "orthotropic", "density": row.positive("RO"), "moduli": e,
        "poissons_ratios": [ba * e[0] / e[1], cb * e[1] / e[2], ca * e[0] / e[2]],
        "shear_moduli": [shear.positive("GAB"), shear.positive("GBC"), shear.positive("GCA")],
    }  # fmt: skip


def orthotropic_elastic(deck: KeywordDeck, card: Card, use: Use) -> Deck:
    reader = card.reader()
    row, shear = reader.row(CONSTANTS), reader.row("GAB GBC GCA AOPT G SIGF")
    point, vectors = reader.row(f"{POINT} MACF=1 IHIS"), reader.row(f"{VECTORS} BETA REF~absent")
    law = read_constants(card, row, shear, use)
    add_axes(deck, card, use, law, (shear, point, vectors), vectors.number("BETA"))
    for found in (row, shear, point, vectors):
        found.finish(deck.ledger, "it is left out")
    finish_lines(deck, card, reader)
    return law


def refuse_strengths(deck: KeywordDeck, card: Card, use: Use) -> bool:
    """Whether the law has no strengths, as of solids."""
    if use.is_shell:
        return False
    deck.ledger.refuse(f"{card.keyword}.solids", use.place,
                       "strengths of orthotropic solids (percuss has them for shells)", "they do not fail")
    return True


def composite_damage(deck: KeywordDeck, card: Card, use: Use) -> Deck:
    """*MAT_022: Chang and Chang's criteria; a strength of 0 is none."""
    reader = card.reader()
    row, shear = reader.row(CONSTANTS), reader.row("GAB GBC GCA KFAIL~solids AOPT MACF=1 ATRACK")
    point, vectors = reader.row(POINT), reader.row(f"{VECTORS} BETA")
    limits = reader.row("SC XT YT YC ALPH SN SYZ SZX")
    law = read_constants(card, row, shear, use)
    add_axes(deck, card, use, law, (shear, point, vectors), vectors.number("BETA"))
    sc, xt, yt, yc = limits.numbers("SC", "XT", "YT", "YC")
    if use.is_shell:
        limits.skip("SN", "SYZ", "SZX")
    if any((sc, xt, yt, yc)) and not refuse_strengths(deck, card, use):
        set_strengths(law, fibre_tension=xt, matrix_tension=yt, matrix_compression=yc, shear=sc,
                      shear_in_fibre_tension=1.0 if sc > 0 else 0.0)
        deck.ledger.approximated(card.keyword, card.place, "brittle plies by the criteria of Chang and Chang; "
                                                           "a broken fibre leaves the stiffness across it")
    for found in (row, shear, point, vectors, limits):
        found.finish(deck.ledger, "shear is linear until failure" if found is limits else "it is left out")
    finish_lines(deck, card, reader)
    return law


def set_strengths(law: Deck, **values: float) -> None:
    law.update({name: value for name, value in values.items() if value > 0})


@dataclass
class LimitLines:
    """The lines of *MAT_054 with strengths and what follows them."""

    vectors: Row  # DFAILM DFAILS
    failing: Row
    strengths: Row
    crash: Row
    residual: Row


def enhanced_composite_damage(deck: KeywordDeck, card: Card, use: Use) -> Deck:
    """*MAT_054 and 055: Chang and Chang's criteria, and strains up to which a stress stays."""
    reader = card.reader()
    row, shear = reader.row(OF_SHELLS if use.is_shell else CONSTANTS), reader.row("GAB GBC GCA KF~unused AOPT 2WAY TI")
    point = reader.row(f"{POINT} MANGLE")
    lines = LimitLines(
        reader.row(f"{VECTORS} DFAILM DFAILS"), reader.row("TFAIL ALPH SOFT=1 FBRT YCFAC=2 DFAILT DFAILC EFS"),
        reader.row("XC XT YC YT SC CRIT=54 BETA"), reader.row("PFL~unused EPSF EPSR~unused TSMD~unused SOFT2=1"),
        reader.row("SLIMT1 SLIMC1 SLIMT2 SLIMC2 SLIMS NCYRED~fading SOFTG=1"))  # fmt: skip
    rates = reader.row("LCXC LCXT LCYC LCYT LCSC DT~sampling")
    law = read_constants(card, row, shear, use)
    add_axes(deck, card, use, law, (shear, point, lines.vectors), point.number("MANGLE"))
    if use.is_shell or not any(lines.strengths.numbers("XC", "XT", "YC", "YT", "SC")):
        add_strengths(deck, card, use, law, lines)
        add_energies(deck, card, use, law, lines)
        add_end(deck, law, lines.failing)
        lines.vectors.finish(deck.ledger, "shear fails with the energy of the matrix")
        for found in (lines.failing, lines.strengths, lines.crash, lines.residual):
            found.finish(deck.ledger, "it is left out")
    else:
        refuse_strengths(deck, card, use)
    row.finish(deck.ledger)
    shear.finish(deck.ledger, "fibres lie along one axis")
    point.finish(deck.ledger, "it is left out")
    rates.finish(deck.ledger, "strengths do not depend on the rate")
    finish_lines(deck, card, reader)
    return law


def add_strengths(deck: KeywordDeck, card: Card, use: Use, law: Deck, lines: LimitLines) -> None:
    row = lines.strengths
    xc, xt, yc, yt, sc = row.numbers("XC", "XT", "YC", "YT", "SC")
    weight = row.number("BETA")
    if not 0 <= weight <= 1:
        row.fail("BETA", "a weight of the shear from 0 to 1 is expected")
    set_strengths(law, fibre_tension=xt, fibre_compression=xc, matrix_tension=yt, matrix_compression=yc, shear=sc,
                  shear_in_fibre_tension=weight)
    if row.number("CRIT") == 55 and yt > 0 and yc > 0:
        law["matrix_criterion"] = "tsai_wu"
    elif row.number("CRIT") == 55:
        row.fail("CRIT", "of 55 (Tsai and Wu) needs YT and YC")
    elif row.number("CRIT") != 54:
        deck.ledger.refuse(f"{card.keyword}.CRIT", row.place,
                           f"CRIT = {row.number('CRIT'):g}: another criterion of the matrix",
                           "that of Chang and Chang counts")
    if weight:
        deck.ledger.approximated(f"{card.keyword}.BETA", row.place,
                                 "BETA weighs the square of the shear over SC in the criterion of fibres in tension")
    if xc > 0 and yc > 0:
        lines.failing.skip("YCFAC")
        deck.ledger.approximated(f"{card.keyword}.YCFAC", lines.failing.place,
                                 "fibres keep their strength in compression when the matrix has failed, "
                                 "in place of YCFAC times YC")
    if use.is_shell:
        deck.ledger.approximated(card.keyword, card.place,
                                 "plies by the criteria of Chang and Chang, that of the matrix with CRIT of 55 by Tsai "
                                 "and Wu; an element is removed when the fibres of all plies have failed")
    if xt > 0 or xc > 0:
        set_failure(law, fibre_damage=1.0)


def add_energies(deck: KeywordDeck, card: Card, use: Use, law: Deck, lines: LimitLines) -> None:
    """Where DFAILT is given, a stress that has come to its strength stays, or falls to a share of it, until its strain
    is reached: in percuss it falls in a straight line over the same energy. Without it plies are brittle."""
    tension, compression = abs(lines.failing.number("DFAILT")), abs(lines.failing.number("DFAILC"))
    matrix = abs(lines.vectors.number("DFAILM"))
    if not tension:
        lines.residual.skip("SLIMT1", "SLIMC1", "SLIMT2", "SLIMC2")
        lines.vectors.skip("DFAILS")
        return
    size, (e1, e2, _) = find_size(deck.model, use.shells), law["moduli"]
    for name, modulus, strain, share in (
            ("fibre_tension", e1, tension, "SLIMT1"), ("fibre_compression", e1, compression, "SLIMC1"),
            ("matrix_tension", e2, matrix, "SLIMT2"), ("matrix_compression", e2, matrix, "SLIMC2")):  # fmt: skip
        rest = lines.residual.number(share) or 1.0
        if name in law:
            law[f"{name}_energy"] = find_crack_energy(law[name], modulus, strain or NO_LIMIT, rest, size)
    text = ("the stress falls in a straight line over the energy of a stress that stays until DFAILT, "
            f"DFAILC or DFAILM, in elements of the mean size {size:.4g}; a matrix that has failed leaves the fibres")
    deck.ledger.approximated(f"{card.keyword}.DFAILT", lines.failing.place, text)


def add_end(deck: KeywordDeck, law: Deck, row: Row) -> None:
    """TFAIL: the step below which an element is removed. SOFT needs it."""
    step = row.number("TFAIL")
    if 0 < step <= MOST_STEP:
        set_failure(law, step=step)
    elif step > MOST_STEP:
        deck.ledger.refuse(f"{row.card}.TFAIL", row.place,
                           f"TFAIL = {step:g}: a share of the first step", "it is left out")
    else:
        row.skip("SOFT")


def laminated_fabric(deck: KeywordDeck, card: Card, use: Use) -> None:
    """*MAT_058."""
    text = ("damage by the law of Matzenmiller, Lubliner and Taylor, which grows from the first load on to the strain "
            "E11T (percuss falls in a straight line behind the strength)")
    deck.ledger.refuse(card.keyword, card.place, text,
                       "the parts made of it are left out; *MAT_054 with the same strengths is read")


ORTHOTROPIC = {
    "ORTHOTROPIC_ELASTIC": orthotropic_elastic, "COMPOSITE_DAMAGE": composite_damage,
    "ENHANCED_COMPOSITE_DAMAGE": enhanced_composite_damage, "LAMINATED_COMPOSITE_FABRIC": laminated_fabric,
}  # fmt: skip
