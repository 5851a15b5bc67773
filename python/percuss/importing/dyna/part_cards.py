"""*PART, *SECTION_..., *HOURGLASS: what the parts of the deck are made of."""

from collections import Counter
from dataclasses import dataclass, field

from ..fields import Row
from ..laminates import MOST_POINTS as MOST_POINTS_OF_PLIES
from ..laminates import gauss_shares, reduce_points
from ..ledger import BadInput, missing
from ..model import Block, Deck, Layer
from .beam_cards import divide_beams
from .cards import Card, Lines
from .contact_cards import note_decay
from .deck import Element, Elements, KeywordDeck, Layup, PartCard
from .materials.names import name_law
from .materials.orthotropic import ORTHOTROPIC
from .materials.shared import COROTATIONAL
from .preload_cards import mark_bolts
from .rigid_cards import read_inertia

OTHER_SECTIONS = {"SEATBELT", "SPH", "POINT", "ALE1D", "ALE2D", "FPD", "IGA"}
READ_SECTIONS = ("SOLID", "SHELL", "DISCRETE", "BEAM", "TSHELL")
THICK_LINE = "SECID ELFORM=1 SHRF=1 NIP=2 PROPT~output QR ICOMP TSHEAR"
THICK_FORMS, ONE_COLUMN = {1, 2, 3, 5, 6, 7}, {1, 5, 6, 7}
SHELL_LINE = "SECID ELFORM SHRF NIP=2 PROPT~output QR ICOMP SETYP~absent"
MOST_POINTS = 16  # through the thickness of a shell
MOST_THICKNESSES = 64  # parts that one *PART may become by the thickness of its elements
SHELL_FORMS = {1, 2, 3, 4, 6, 7, 8, 10, 11, 16, -16, 17, 18, 20, 21, 25, 26}
MEMBRANE_FORMS = {5, 9}  # Belytschko-Tsay, and integrated at several points in the plane
FULL_SHELLS = {6, 7, 11, 16, -16, 18, 20, 21, 26}  # integrated at several points in the plane
ONE_POINT, FULL = {1}, {-2, -1, 2, 3, 18}
TETRAHEDRA_FORMS = {10, 13, 16, 17}  # the last two of ten nodes
WEDGE_FORMS = {15, 115}
HOURGLASS_KINDS = {1: "viscous", 2: "viscous", 3: "viscous", 4: "stiffness", 5: "stiffness", 8: "assumed_strain"}
PART_LINES = {"INERTIA": "", "REPOSITION": "CMSN MDEP MOVOPT", "CONTACT": "", "PRINT": "PRBF~output", "ATTACHMENT_NODES": "ANSID~implicit"}


def read_parts(deck: KeywordDeck, card: Card) -> None:
    """A title, then PID SECID MID EOSID HGID GRAV ADPOPT TMID, for each part."""
    options = [word for word in PART_LINES if f"_{word}" in card.keyword]
    if "".join(sorted(card.keyword.removeprefix("PART"))) != "".join(sorted("".join(f"_{word}" for word in options))):
        deck.ledger.refuse(card.keyword, card.place, "this form of parts", "it is left out")
        return
    reader = card.reader()
    while reader.holds_more():
        title = reader.text()
        row = reader.row("PID SECID MID EOSID HGID GRAV~absent ADPOPT~adaptive TMID~thermal")
        id = row.integer("PID")
        if id < 1:
            row.fail("PID", "an id is expected")
        if id in deck.parts:
            raise BadInput(row.place, f"there are two parts {id} (ids must be unique): renumber one")
        part = PartCard(id, title, row.place, row.integer("SECID"), row.integer("MID"), row.integer("EOSID"), row.integer("HGID"))
        row.finish(deck.ledger)
        part.is_adaptive = row.number("ADPOPT") != 0
        deck.parts[id] = part
        read_part_options(deck, card, reader, part, options)
        deck.ledger.translated(card.keyword, row.place, "a part for each thickness, its blocks share nodes with others")


def read_part_options(deck: KeywordDeck, card: Card, reader: Lines, part: PartCard, options: list[str]) -> None:
    """Further lines of a part."""
    for option in options:
        if option == "CONTACT":
            row = reader.row("FS FD DC VC OPTT SFT=1 SSF~penalty CPARM8~absent")
            part.friction = row.number("FS") if row.has("FS") else None
            note_decay(deck, row, "PART_CONTACT")
            row.card = "PART_CONTACT"
            part.contact_thickness = row.number("OPTT")
            row.finish(deck.ledger, "it is left out")
            continue
        if option == "INERTIA":
            read_inertia(deck, reader, part)
            continue
        line = reader.row(PART_LINES[option])
        line.finish(deck.ledger, "the part stays where it is")


def read_section(deck: KeywordDeck, card: Card) -> None:
    """Sections by id: cards of their own. A keyword may be followed by several."""
    kind = card.keyword.removeprefix("SECTION_")
    if kind.split("_")[0] in ("SOLID", "SHELL", "DISCRETE", "BEAM") and "_" in kind:
        deck.ledger.refuse(card.keyword, card.place, f"an option of sections: {kind.split('_', 1)[1]}", "the section is read without it")
        kind = kind.split("_")[0]
        card.keyword = f"SECTION_{kind}"
    if kind.split("_")[0] not in OTHER_SECTIONS and kind not in READ_SECTIONS:
        deck.ledger.refuse(card.keyword, card.place, "an unknown kind of sections", "it is left out")
        return
    if kind not in READ_SECTIONS:
        deck.ledger.ignored(card.keyword, card.place, "a section of elements that percuss does not have")
        return
    reader = card.reader()
    while reader.skip_blank():
        if card.has_title:
            reader.take()
        lines = [reader.take()]
        row = card.row(lines[0], "SECID" if kind == "DISCRETE" else "SECID ELFORM")
        if kind != "DISCRETE" and 100 < row.integer("ELFORM") < 106:  # a user's element has lines of its own
            lines += [reader.take() for _ in range(len(card.lines)) if reader]
        elif kind in ("DISCRETE", "BEAM") and reader:
            lines.append(reader.take())
        elif kind in ("SHELL", "TSHELL"):
            if kind == "SHELL":
                lines.append(reader.take())
            layers = card.row(lines[0], SHELL_LINE)
            count = int(layers.number("NIP"))
            if layers.integer("ICOMP"):
                lines += [reader.take() for _ in range(min(-(-count // 8), 100))]
        deck.sections[row.integer("SECID")] = Card(card.keyword, row.place, card.least_width, card.parameters, lines=lines)


def read_hourglass(deck: KeywordDeck, card: Card) -> None:
    reader = card.reader()
    while reader.skip_blank():
        if card.has_title:
            reader.take()
        row = reader.row("HGID IHQ=1 QM=0.1 IBQ~unused Q1=1.5 Q2=0.06 QB~shells QW~shells")
        deck.hourglass[row.integer("HGID")] = row


@dataclass
class ShellSection:
    """What a *SECTION_SHELL says."""

    corners: list[float]  # thickness at each
    points: int
    reference: float  # height of the mesh over the middle, in half thicknesses
    per_area: float = 0.0  # mass beside that of the material
    layers: list[Layer] = field(default_factory=list)
    is_membrane: bool = False

    def make_keys(self) -> Deck:
        """Of the part, but for its offset."""
        if self.is_membrane:
            return {"integration": "membrane"}
        return {} if self.layers else {"points": self.points}

    def thickness_of(self, shell: Element) -> float:
        """The mean of the corners, where the shell does not say it itself."""
        if shell.thickness or len(set(self.corners)) == 1:
            return shell.thickness or self.corners[0]
        count = len(set(shell.corners))
        return sum(self.corners[:count]) / count


def takes_form(deck: KeywordDeck, row: Row, card: str) -> bool:
    """Whether shells of an ELFORM become that of percuss."""
    form = row.integer("ELFORM") or deck.shell_form
    return form in SHELL_FORMS | MEMBRANE_FORMS or deck.ledger.refuse(
        f"{card}.ELFORM", row.place, f"formulation {form} (percuss has no plane or axisymmetric elements)", "the shell of percuss is used"
    )


def make_membrane(deck: KeywordDeck, section: ShellSection, row: Row, card: str) -> ShellSection:
    """The section as one of membranes, if its ELFORM says so."""
    section.is_membrane = (row.integer("ELFORM") or deck.shell_form) in MEMBRANE_FORMS
    if section.is_membrane:
        deck.ledger.translated(f"{card}.ELFORM", row.place, "integration: membrane of the part, with one point in the plane")
        if section.reference:
            deck.ledger.ignored(f"{card}.NLOC", row.place, "a membrane does not bend, wherever its mesh lies")
            section.reference = 0.0
    return section


def translate_layup(deck: KeywordDeck, part: PartCard, layup: Layup, shells: list[Element]) -> ShellSection | None:
    """*PART_COMPOSITE as a section."""
    row = layup.row
    if not takes_form(deck, row, "PART_COMPOSITE"):
        return None
    if any(shell.thickness and shell.thickness != layup.thickness for shell in shells):
        deck.ledger.refuse("ELEMENT_SHELL_THICKNESS", part.place, "shells of *PART_COMPOSITE with another thickness than its plies", "that of the plies counts")
    for shell in shells:
        shell.thickness = None
    row.skip("PID", "SHRF")
    per_area = max(row.number("MAREA"), 0.0)
    section = ShellSection([layup.thickness] * 4, 2, row.number("NLOC"), per_area, reduce_points(deck.ledger, "PART_COMPOSITE", part.place, layup.layers))
    refuse_offset_contact(deck, section.reference, row)
    row.finish(deck.ledger)
    text = "plies with two Gauss points each, so that they bend as laminate theory says; transverse shear by the energy of its stresses, in place of SHRF"
    deck.ledger.approximated("PART_COMPOSITE", part.place, text)
    return make_membrane(deck, section, row, "PART_COMPOSITE")


def refuse_offset_contact(deck: KeywordDeck, reference: float, row: Row) -> None:
    if reference and deck.contact_at_offset:
        deck.ledger.refuse("CONTROL_SHELL.CNTCO", row.place, "CNTCO: contact at the surfaces of shells with an offset", "they touch at half their thickness from the mesh")


def read_angles(deck: KeywordDeck, part: PartCard, row: Row, reader: Lines) -> list[Layer]:
    """ICOMP: the angle at each integration point, as plies whose thicknesses are its weights. Isotropic laws have no angles."""
    count = abs(row.integer("NIP")) or 2
    material = deck.materials.get(part.material)
    if not row.integer("ICOMP") or material is None or name_law(material.keyword) not in ORTHOTROPIC:
        return []
    if count > MOST_POINTS_OF_PLIES:
        row.fail("NIP", f"at most {MOST_POINTS_OF_PLIES} angles are read")
    angles: list[float] = []
    while len(angles) < count:
        angles += reader.row("B1 B2 B3 B4 B5 B6 B7 B8").numbers(*(f"B{i}" for i in range(1, 9)))
    ends = 0.5 / (count - 1) if count > 1 else 1.0
    shares = [ends if i in (0, count - 1) else 2 * ends for i in range(count)] if row.integer("QR") == 1 else gauss_shares(count)
    text = "plies as thick as the weights of the points of integration, with Gauss points of their own"
    deck.ledger.approximated("SECTION_SHELL.ICOMP", row.place, text)
    return [Layer(part.material, share, angle) for share, angle in zip(shares, angles)]


def translate_shell_section(deck: KeywordDeck, part: PartCard, card: Card) -> ShellSection | None:
    """None where the section is refused."""
    reader = card.reader()
    row = reader.row(SHELL_LINE)
    more = reader.row("T1 T2 T3 T4 NLOC MAREA IDOF~absent EDGSET~absent")
    layers = read_angles(deck, part, row, reader)
    if not takes_form(deck, row, "SECTION_SHELL"):
        return None
    first = more.number("T1")
    corners = [value if value > 0 else first for value in more.numbers("T1", "T2", "T3", "T4")]
    if len(set(corners)) > 1:
        deck.ledger.approximated("SECTION_SHELL.T2", more.place, "thickness that differs between the corners: each shell has the mean of its corners")
    points = abs(row.integer("NIP")) or 2
    if points > MOST_POINTS and not layers:
        deck.ledger.approximated("SECTION_SHELL.NIP", row.place, f"{MOST_POINTS} points through the thickness in place of {points}")
    if row.integer("QR") < 0:
        deck.ledger.refuse("SECTION_SHELL.QR", row.place, "a rule of integration of the user's", "Gauss points are used")
    elif row.integer("QR"):
        deck.ledger.approximated("SECTION_SHELL.QR", row.place, "Gauss points in place of the trapezoidal rule")
    row.skip("SECID", "SHRF", "ICOMP")
    row.finish(deck.ledger)
    reference = more.number("NLOC")
    refuse_offset_contact(deck, reference, row)
    per_area = max(more.number("MAREA"), 0.0)
    if per_area:
        deck.ledger.translated("SECTION_SHELL.MAREA", more.place, "a higher density in a material of its own")
    more.finish(deck.ledger)
    deck.ledger.approximated(
        card.keyword,
        row.place,
        "percuss has one shell: four nodes, one point in the plane, physical stabilisation, "
        "shear factor 5/6, Gauss points, thickness that follows the strain",
    )
    section = ShellSection(corners, min(points, MOST_POINTS), reference, per_area, layers)
    return make_membrane(deck, section, row, "SECTION_SHELL")


def build_blocks(deck: KeywordDeck) -> None:
    """All elements as blocks of the model, a block for each part and thickness."""
    separate_ids(deck)
    mark_bolts(deck)
    next_id = max(deck.parts, default=0) + 1
    for id, elements in deck.elements.items():
        part = deck.parts.get(id)
        if part is None:
            raise BadInput(elements.place, missing(f"part {id}"))
        if not elements.solids and not elements.shells and not elements.beams:
            continue
        for block in divide_part(deck, part, elements, next_id):
            next_id = max(next_id, block.id + 1)
            deck.model.blocks.append(block)
            deck.names_of_parts.setdefault(id, []).append(block.name)
    for id, part in deck.parts.items():
        if id not in deck.elements:
            deck.ledger.ignored("PART", part.place, "no element is of this part")


def separate_ids(deck: KeywordDeck) -> None:
    """Raises the ids of shells where solids have some of them, and of beams likewise: ids of elements are of one kind in
    percuss."""
    separate_beams(deck)
    solids = {id for elements in deck.elements.values() for id, _ in elements.solids}
    shells = [shell for elements in deck.elements.values() for shell in elements.shells]
    if not solids or solids.isdisjoint(shell.id for shell in shells):
        return
    deck.shell_shift = 10 ** len(str(max(solids)))
    for shell in shells:
        shell.id += deck.shell_shift
    place = next(elements.place for elements in deck.elements.values() if elements.shells)
    deck.ledger.approximated(
        "ELEMENT_SHELL.EID", place, f"ids are raised by {deck.shell_shift}, since solids have some of them too"
    )


def separate_beams(deck: KeywordDeck) -> None:
    """Raises the ids of beams above those of all others where some are the same."""
    beams = [beam for elements in deck.elements.values() for beam in elements.beams]
    others = {id for elements in deck.elements.values() for id, _ in elements.solids}
    others |= {shell.id for elements in deck.elements.values() for shell in elements.shells}
    if not others or others.isdisjoint(beam.id for beam in beams):
        return
    shift = 10 ** (len(str(max(others))) + 1)  # shells may be raised too
    deck.beam_shift = shift
    for beam in beams:
        beam.id += shift
    place = next(elements.place for elements in deck.elements.values() if elements.beams)
    deck.ledger.approximated("ELEMENT_BEAM.EID", place, f"ids are raised by {shift}, since other elements have some of them too")


def divide_part(deck: KeywordDeck, part: PartCard, elements: Elements, next_id: int) -> list[Block]:
    """The blocks of a part, without its material."""
    name = deck.model.names.take(part.title or f"part_{part.id}", "part")
    if part.layup:
        if elements.solids or elements.beams:
            raise BadInput(part.place, f"part {part.id} of *PART_COMPOSITE has elements other than shells: correct its id, or divide the part")
        found = translate_layup(deck, part, part.layup, elements.shells)
        return divide_shells(deck, part, elements.shells, found, name, next_id) if found else []
    section = deck.sections.get(part.section)
    if section is None:
        raise BadInput(part.place, missing(f"section {part.section}, of part {part.id}"))
    is_beam = section.keyword.startswith("SECTION_BEAM")
    if elements.beams:
        if elements.solids or elements.shells or not is_beam:
            raise BadInput(part.place, f"part {part.id} has beams, but its section or other elements are of another kind: correct its SECID, or divide the part")
        return divide_beams(deck, part, elements.beams, name, next_id)
    if not elements.shells:
        return [Block(part.id, part.id, name, part.place, solids=elements.solids)]
    if elements.solids or not section.keyword.startswith("SECTION_SHELL"):
        raise BadInput(part.place, f"part {part.id} has shells, but its section or other elements are of solids: correct its SECID, or divide the part")
    found = translate_shell_section(deck, part, section)
    if found is None:
        return []
    return divide_shells(deck, part, elements.shells, found, name, next_id)


def divide_shells(
    deck: KeywordDeck, part: PartCard, shells: list[Element], section: ShellSection, name: str, next_id: int
) -> list[Block]:
    """A block, or blocks of equal thickness where the mesh is not the middle surface."""
    groups: dict[float, list[tuple[int, tuple[int, ...]]]] = {}
    for shell in shells:
        groups.setdefault(section.thickness_of(shell), []).append((shell.id, shell.corners))
    if min(groups) <= 0:
        raise BadInput(part.place, f"part {part.id} has shells without thickness: give T1 in its *SECTION_SHELL")
    if len(groups) > 1 and not section.reference and not section.per_area and not section.layers:
        return [mark_axes(make_block_of_thicknesses(deck, part, groups, section, name), shells)]
    if len(groups) > MOST_THICKNESSES:
        groups = round_thicknesses(deck, part, groups)
    blocks = []
    for index, (thickness, members) in enumerate(sorted(groups.items(), key=lambda item: -len(item[1]))):
        keys = section.make_keys()
        if section.reference:
            named = {1.0: "top", -1.0: "bottom"}.get(section.reference)
            keys["reference"] = named or 0.5 * section.reference * thickness
        own_name = name if index == 0 else deck.model.names.take(f"{name}_t{index + 1}", "part")
        id = part.id if index == 0 else next_id + index - 1
        block = Block(id, part.id, own_name, part.place, shells=members, thickness=thickness, keys=keys)
        block.more_density = section.per_area / thickness
        block.layers = list(section.layers)
        blocks.append(mark_axes(block, shells))
    if len(blocks) > 1:
        deck.ledger.approximated("ELEMENT_SHELL_THICKNESS", part.place, "a part for each thickness")
    return blocks


def mark_axes(block: Block, shells: list[Element]) -> Block:
    """Notes which axes of materials the shells of a part have themselves."""
    block.angles, block.has_systems = {shell.angle for shell in shells}, any(shell.system for shell in shells)
    return block


def make_block_of_thicknesses(
    deck: KeywordDeck, part: PartCard, groups: dict[float, list], section: ShellSection, name: str
) -> Block:
    """All shells of a part, each with its thickness in the mesh file."""
    members = sorted(member for group in groups.values() for member in group)
    thicknesses = {id: thickness for thickness, group in groups.items() for id, _ in group}
    deck.ledger.translated("ELEMENT_SHELL_THICKNESS", part.place, "thickness of each shell, from the mesh file")
    block = Block(part.id, part.id, name, part.place, shells=members, thickness=max(groups), keys=section.make_keys())
    block.thicknesses = thicknesses
    return block


def round_thicknesses(deck: KeywordDeck, part: PartCard, groups: dict) -> dict:
    """As many different thicknesses as parts can be made of."""
    low, high = min(groups), max(groups)
    step = (high - low) / (MOST_THICKNESSES - 1)
    rounded: dict[float, list] = {}
    for thickness, members in groups.items():
        rounded.setdefault(low + step * round((thickness - low) / step), []).extend(members)
    deck.ledger.approximated(
        "ELEMENT_SHELL_THICKNESS", part.place, f"{len(groups)} thicknesses are rounded to {len(rounded)}, by at most {step / 2:.3g}"
    )
    return rounded


# --- settings of elements: those of most of them for the scene, others by part


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
        is_corotational = form in COROTATIONAL and deck.materials[deck.parts[block.part].material].keyword == "MAT_MODIFIED_HONEYCOMB"
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
        elements, needed = ("*ELEMENT_SOLID", "*SECTION_SOLID") if has_section else ("*ELEMENT_TSHELL", "*SECTION_TSHELL")
        raise BadInput(block.place, f"part {block.part} has {elements} and a section of another kind: give it a {needed}")
    return has_section


def translate_thick_section(deck: KeywordDeck, section: Card) -> Deck:
    """`integration` of the part of a *SECTION_TSHELL."""
    row = section.reader().row(THICK_LINE)
    form, points = row.integer("ELFORM") or 1, abs(int(row.number("NIP"))) or 2
    row.skip("SECID")
    if form not in THICK_FORMS:
        deck.ledger.refuse("SECTION_TSHELL.ELFORM", row.place, f"formulation {form} of thick shells", "that of percuss is used")
    if row.number("SHRF") not in (0.0, 1.0):
        deck.ledger.approximated("SECTION_TSHELL.SHRF", row.place, "the transverse shear keeps the factor 1")
    if row.number("QR") < 0:
        deck.ledger.refuse("SECTION_TSHELL.QR", row.place, "a rule of integration of the user's", "Gauss points are used")
    if row.integer("ICOMP"):
        deck.ledger.refuse("SECTION_TSHELL.ICOMP", row.place, "angles of plies in thick shells", "they have none")
    if row.integer("TSHEAR"):
        deck.ledger.approximated("SECTION_TSHELL.TSHEAR", row.place, "transverse shear is the same across the thickness as the strains say")
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
        deck.ledger.approximated("SECTION_SOLID.ELFORM", row.place, "2x2x2 points with mean dilatation for fully integrated solids")
        return "full"
    deck.ledger.refuse("SECTION_SOLID.ELFORM", row.place, f"formulation {form} of solids", "one-point hexahedra are used")
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
        counts[key] += count
        chosen_by.append((block, key))
        text = key[0] + (f" with {key[1]}" if key[0] != "assumed_strain" else "")
        card = "HOURGLASS" if general or deck.hourglass else "HOURGLASS (none)"
        deck.ledger.approximated(card, row.place if row else block.place, f"the hourglass control becomes {text}")
    chosen = counts.most_common(1)[0][0] if counts and not all_full else ("assumed_strain", 0.0)
    if chosen[0] != "assumed_strain":
        deck.model.deck.setdefault("elements", {})["hourglass"] = {"kind": chosen[0], "coefficient": chosen[1]}
    for block, key in chosen_by:
        if key != chosen:
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
        deck.ledger.approximated("HOURGLASS.Q1", row.place, "bulk_viscosity of the part: linear = Q2, quadratic = sqrt(Q1)")
    return row


def judge_hourglass(row: Row | None, law: Deck) -> tuple[str, float]:
    """Kind and coefficient of percuss. Where the deck says nothing, percuss has its own default too; but a fluid does not resist, as by default in LS-DYNA."""
    if row is None:
        return ("viscous", 0.1) if law["model"] == "fluid" else ("assumed_strain", 0.0)
    kind = HOURGLASS_KINDS.get(row.integer("IHQ") or 1, "assumed_strain")
    coefficient = row.number("QM" if row.card == "HOURGLASS" else "QH") or 0.1
    return kind, 0.0 if kind == "assumed_strain" else min(abs(coefficient), 1.0)
