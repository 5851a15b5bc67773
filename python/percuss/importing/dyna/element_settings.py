"""Settings of elements, those of most of them for the scene, others by part:
integration, hourglass control and viscosity."""

from collections import Counter

from ..fields import Row
from ..ledger import BadInput, missing
from ..model import FLUID_HOURGLASS, Block, Deck
from .cards import Card
from .deck import KeywordDeck
from .materials.shared import COROTATIONAL

THICK_LINE = "SECID ELFORM=1 SHRF=1 NIP=2 PROPT~output QR ICOMP TSHEAR"
THICK_FORMS, ONE_COLUMN = {1, 2, 3, 5, 6, 7}, {1, 5, 6, 7}
FULL_SHELLS = {6, 7, 11, 16, -16, 18, 20, 21, 26}  # integrated at several points in the plane
ONE_POINT, FULL = {1}, {-2, -1, 2, 3, 18}
TETRAHEDRA_FORMS = {10, 13, 16, 17}  # the last two of ten nodes
WEDGE_FORMS = {15, 115}
FLUIDS = (str(FLUID_HOURGLASS["kind"]), float(FLUID_HOURGLASS["coefficient"]))
HOURGLASS_KINDS = {1: "viscous", 2: "viscous", 3: "viscous", 4: "stiffness", 5: "stiffness", 8: "assumed_strain"}


def read_hourglass(deck: KeywordDeck, card: Card) -> None:
    reader = card.reader()
    while reader.next_card():
        if card.has_title:
            reader.take()
        row = reader.row("HGID IHQ=1 QM=0.1 IBQ~unused Q1=1.5 Q2=0.06 QB~shells QW~shells")
        deck.ids.claim("*HOURGLASS", row.integer("HGID"), row.place)
        deck.hourglass[row.integer("HGID")] = row


def count_hexahedra(deck: KeywordDeck) -> list[tuple[Block, int]]:
    """Blocks of solids that are computed, with the number of their hexahedra."""
    blocks = [block for block in deck.model.blocks if block.solids and block.part not in deck.rigid]
    return [(block, sum(1 for _, corners in block.solids if len(corners) == 8)) for block in blocks]


def translate_integration(deck: KeywordDeck) -> None:
    """ELFORM of all solids."""
    counts: Counter[str] = Counter()
    kinds: dict[int, str] = {}
    for block, count in count_hexahedra(deck):
        section = deck.sections[deck.parts[block.part].section]
        if is_thick(deck, block, section):
            block.keys["integration"] = translate_thick_section(deck, section)
            continue
        row = section.reader().row("SECID ELFORM=1 AET A B C COHOFF~absent GASKETT~absent")
        form = row.integer("ELFORM") or 1
        row.skip("SECID")
        row.finish(deck.ledger)
        is_corotational = (form in COROTATIONAL
                           and deck.materials[deck.parts[block.part].material].keyword == "MAT_MODIFIED_HONEYCOMB")
        kind = "one_point" if is_corotational else judge_solid_form(deck, form, row)
        if count:
            kinds[block.id] = kind
            counts[kind] += count
        deck.ledger.translated(section.keyword, row.place, "integration, of the elements or of the part")
    if not counts:
        return
    chosen = counts.most_common(1)[0][0]
    for block in deck.model.blocks:
        if kinds.get(block.id, chosen) != chosen:
            block.keys["integration"] = kinds[block.id]
    if chosen != "one_point":
        deck.model.deck.setdefault("elements", {})["integration"] = chosen


def is_thick(deck: KeywordDeck, block: Block, section: Card) -> bool:
    """Whether the hexahedra of a part are thick shells; elements and section must agree."""
    has_section = section.keyword.startswith("SECTION_TSHELL")
    if has_section != deck.elements[block.part].is_thick:
        elements, needed = (("*ELEMENT_SOLID", "*SECTION_SOLID") if has_section
                            else ("*ELEMENT_TSHELL", "*SECTION_TSHELL"))
        raise BadInput(block.place,
                       f"part {block.part} has {elements} and a section of another kind: give it a {needed}")
    return has_section


def translate_thick_section(deck: KeywordDeck, section: Card) -> Deck:
    """`integration` of the part of a *SECTION_TSHELL."""
    row = section.reader().row(THICK_LINE)
    form, points = row.integer("ELFORM") or 1, abs(int(row.number("NIP"))) or 2
    row.skip("SECID")
    if form not in THICK_FORMS:
        deck.ledger.refuse("SECTION_TSHELL.ELFORM", row.place, f"formulation {form} of thick shells",
                           "that of percuss is used")
    if row.number("SHRF") not in (0.0, 1.0):
        deck.ledger.approximated("SECTION_TSHELL.SHRF", row.place, "the transverse shear keeps the factor 1")
    if row.number("QR") < 0:
        deck.ledger.refuse("SECTION_TSHELL.QR", row.place,
                           "a rule of integration of the user's", "Gauss points are used")
    if row.integer("ICOMP"):
        deck.ledger.refuse("SECTION_TSHELL.ICOMP", row.place, "angles of plies in thick shells", "they have none")
    if row.integer("TSHEAR"):
        deck.ledger.approximated("SECTION_TSHELL.TSHEAR", row.place,
                                 "transverse shear is the same across the thickness as the strains say")
    row.finish(deck.ledger)
    chosen = 3 if points <= 3 else 5
    text = f"thick shells with 2x2 columns of {chosen} Gauss points"
    if points != chosen or form in ONE_COLUMN:
        text += f" for formulation {form} with {points}"
    deck.ledger.approximated("SECTION_TSHELL.NIP", row.place, text)
    deck.ledger.translated("SECTION_TSHELL", row.place, "integration of the part")
    return {"kind": "thick_shell", "points": chosen}


def judge_solid_form(deck: KeywordDeck, form: int, row: Row) -> str:
    """Integration in percuss of an ELFORM."""
    if form in ONE_POINT or form in TETRAHEDRA_FORMS:
        return "one_point"
    if form in WEDGE_FORMS:
        deck.ledger.approximated("SECTION_SOLID.ELFORM", row.place, "wedges of one point with two hourglass modes")
        return "one_point"
    if form in FULL:
        deck.ledger.approximated("SECTION_SOLID.ELFORM", row.place,
                                 "2x2x2 points with mean dilatation for fully integrated solids")
        return "full"
    deck.ledger.refuse("SECTION_SOLID.ELFORM", row.place, f"formulation {form} of solids",
                       "one-point hexahedra are used")
    return "one_point"


def translate_hourglass(deck: KeywordDeck, general: Row | None) -> None:
    """Hourglass control of the parts whose hexahedra have one point."""
    all_full = "integration" in deck.model.deck.get("elements", {})
    counts: Counter[tuple[str, float]] = Counter()
    chosen_by: list[tuple[Block, tuple[str, float]]] = []
    for block, count in count_hexahedra(deck):
        row = find_hourglass(deck, block, general)
        if not count or block.keys.get("integration", "full" if all_full else "one_point") != "one_point":
            if row:
                deck.ledger.approximated(row.card, row.place, "2x2x2 points and other solids have no coefficient")
            continue
        key = judge_hourglass(row, deck.model.materials[block.keys["material"]])
        if row or key != FLUIDS:
            counts[key] += count
        chosen_by.append((block, key))
        text = key[0] + (f" with {key[1]}" if key[0] != "assumed_strain" else "")
        card = row.card if row else "HOURGLASS (none)"
        deck.ledger.approximated(card, row.place if row else block.place, f"the hourglass control becomes {text}")
    chosen = counts.most_common(1)[0][0] if counts and not all_full else ("assumed_strain", 0.0)
    if chosen[0] != "assumed_strain":
        deck.model.deck.setdefault("elements", {})["hourglass"] = {"kind": chosen[0], "coefficient": chosen[1]}
    is_left_to_fluids = not all_full and chosen[0] == "assumed_strain"  # percuss's own default
    for block, key in chosen_by:
        if key != chosen and not (is_left_to_fluids and key == FLUIDS):
            block.keys["hourglass"] = key[0] if key[0] == "assumed_strain" else {"kind": key[0], "coefficient": key[1]}


def translate_shell_hourglass(deck: KeywordDeck, general: Row | None) -> None:
    """The coefficient of *HOURGLASS as the share of the stiffness of shells against hourglass modes and drilling."""
    for block in deck.model.blocks:
        if not block.shells or block.part in deck.rigid:
            continue
        row = deck.hourglass.get(deck.parts[block.part].hourglass, general)
        part = deck.parts[block.part]
        section = deck.sections.get(part.section)
        line = part.layup.row if part.layup else section.reader().row("SECID ELFORM=2") if section else None
        if not row or not line:
            continue
        name = "QM" if row.card == "HOURGLASS" else "QH"
        form = line.integer("ELFORM") or deck.shell_form
        if form in FULL_SHELLS or row.integer("IHQ") == 8:
            text = "shells without hourglass modes, or with all of their stiffness: so have those of percuss"
            deck.ledger.ignored(f"{row.card}.{name}", row.place, text)
            continue
        block.keys["shell_hourglass"] = min(abs(row.number(name)) or 0.1, 1.0)
        text = f"shell_hourglass of the part: {name} is the share of the stiffness of the material"
        viscous = "; viscous forces (IHQ 1 to 3) become elastic ones" if (row.integer("IHQ") or 1) < 4 else ""
        deck.ledger.approximated(f"{row.card}.{name}", row.place, text + viscous)


def find_hourglass(deck: KeywordDeck, block: Block, general: Row | None) -> Row | None:
    """*HOURGLASS of a part, or *CONTROL_HOURGLASS. The former also gives the part its bulk viscosity."""
    id = deck.parts[block.part].hourglass
    if not id:
        return general
    if id not in deck.hourglass:
        raise BadInput(deck.parts[block.part].place, missing(f"*HOURGLASS {id}"))
    row = deck.hourglass[id]
    quadratic, linear = row.number("Q1") or 1.5, row.number("Q2") or 0.06
    if (quadratic, linear) != (1.5, 0.06):
        block.keys["bulk_viscosity"] = {"linear": linear, "quadratic": max(quadratic, 0.0) ** 0.5}
        deck.ledger.approximated("HOURGLASS.Q1", row.place,
                                 "bulk_viscosity of the part: linear = Q2, quadratic = sqrt(Q1)")
    return row


def judge_hourglass(row: Row | None, law: Deck) -> tuple[str, float]:
    """Kind and coefficient of percuss. Where the deck says nothing, percuss has its own default too;
    but a fluid does not resist, as by default in LS-DYNA."""
    if row is None:
        return FLUIDS if law["model"] == "fluid" else ("assumed_strain", 0.0)
    kind = HOURGLASS_KINDS.get(row.integer("IHQ") or 1, "assumed_strain")
    coefficient = row.number("QM" if row.card == "HOURGLASS" else "QH") or 0.1
    return kind, 0.0 if kind == "assumed_strain" else min(abs(coefficient), 1.0)
