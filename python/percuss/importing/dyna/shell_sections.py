"""*SECTION_SHELL and *PART_COMPOSITE: thickness, points and plies of shells, and the parts that differ in thickness."""

from dataclasses import dataclass, field

from ..fields import Row
from ..laminates import MOST_POINTS as MOST_POINTS_OF_PLIES
from ..laminates import gauss_shares, reduce_points
from ..ledger import BadInput, Place
from ..model import Block, Deck, Layer
from .cards import Card, Lines
from .deck import Element, KeywordDeck, Layup, PartCard
from .materials.names import name_law
from .materials.orthotropic import ORTHOTROPIC

SHELL_LINE = "SECID ELFORM SHRF NIP=2 PROPT~output QR ICOMP SETYP~absent"
MOST_POINTS = 16  # through the thickness of a shell
MOST_THICKNESSES = 64  # parts that one *PART may become by the thickness of its elements
SHELL_FORMS = {1, 2, 3, 4, 6, 7, 8, 10, 11, 16, -16, 17, 18, 20, 21, 25, 26}
MEMBRANE_FORMS = {5, 9}  # Belytschko-Tsay, and integrated at several points in the plane
Thicknesses = dict[float, list[tuple[int, tuple[int, ...]]]]  # shells by their thickness: ids and corners


@dataclass
class ShellSection:
    """What a *SECTION_SHELL says."""

    corners: list[float]  # thickness at each
    points: int
    reference: float  # height of the mesh over the middle, in half thicknesses
    per_area: float = 0.0  # mass beside that of the material
    layers: list[Layer] = field(default_factory=list)
    is_membrane: bool = False
    place: Place | None = None  # of the line with the thicknesses

    def make_keys(self) -> Deck:
        """Keys of the part, but for its offset."""
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
        f"{card}.ELFORM", row.place, f"formulation {form} (percuss has no plane or axisymmetric elements)",
        "the shell of percuss is used"
    )


def make_membrane(deck: KeywordDeck, section: ShellSection, row: Row, card: str) -> ShellSection:
    """The section as one of membranes, if its ELFORM says so."""
    section.is_membrane = (row.integer("ELFORM") or deck.shell_form) in MEMBRANE_FORMS
    if section.is_membrane:
        deck.ledger.translated(f"{card}.ELFORM", row.place,
                               "integration: membrane of the part, with one point in the plane")
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
        deck.ledger.refuse("ELEMENT_SHELL_THICKNESS", part.place,
                           "shells of *PART_COMPOSITE with another thickness than its plies",
                           "that of the plies counts")
    for shell in shells:
        shell.thickness = None
    row.skip("PID", "SHRF")
    per_area = max(row.number("MAREA"), 0.0)
    section = ShellSection([layup.thickness] * 4, 2, row.number("NLOC"), per_area,
                           reduce_points(deck.ledger, "PART_COMPOSITE", part.place, layup.layers))
    refuse_offset_contact(deck, section.reference, row)
    row.finish(deck.ledger)
    text = ("plies with two Gauss points each, so that they bend as laminate theory says; "
            "transverse shear by the energy of its stresses, in place of SHRF")
    deck.ledger.approximated("PART_COMPOSITE", part.place, text)
    return make_membrane(deck, section, row, "PART_COMPOSITE")


def refuse_offset_contact(deck: KeywordDeck, reference: float, row: Row) -> None:
    if reference and deck.contact_at_offset:
        deck.ledger.refuse("CONTROL_SHELL.CNTCO", row.place,
                           f"CNTCO: contact at the surfaces of shells whose middle lies {0.5 * abs(reference):g} of "
                           "their thickness off the mesh", "they touch at half their thickness from the mesh")


def read_angles(deck: KeywordDeck, part: PartCard, row: Row, reader: Lines) -> list[Layer]:
    """ICOMP: the angle at each integration point, as plies whose thicknesses are its weights.
    Isotropic laws have no angles."""
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
    shares = ([ends if i in (0, count - 1) else 2 * ends for i in range(count)] if row.integer("QR") == 1
              else gauss_shares(count))
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
    corners = read_thicknesses(more)
    if len(set(corners)) > 1:
        deck.ledger.approximated("SECTION_SHELL.T2", more.place,
                                 "thickness that differs between the corners: each shell has the mean of its corners")
    points = abs(row.integer("NIP")) or 2
    if points > MOST_POINTS and not layers:
        deck.ledger.approximated("SECTION_SHELL.NIP", row.place,
                                 f"{MOST_POINTS} points through the thickness in place of {points}")
    if row.integer("QR") < 0:
        deck.ledger.refuse("SECTION_SHELL.QR", row.place,
                           "a rule of integration of the user's", "Gauss points are used")
    elif row.integer("QR"):
        deck.ledger.approximated("SECTION_SHELL.QR", row.place, "Gauss points in place of the trapezoidal rule")
    row.skip("SECID", "SHRF", "ICOMP")
    row.finish(deck.ledger)
    reference = more.number("NLOC")
    refuse_offset_contact(deck, reference, row)
    per_area = more.not_negative("MAREA")
    if per_area:
        deck.ledger.translated("SECTION_SHELL.MAREA", more.place, "a higher density in a material of its own")
    more.finish(deck.ledger)
    deck.ledger.approximated(
        card.keyword,
        row.place,
        "percuss has one shell: four nodes, one point in the plane, physical stabilisation, "
        "shear factor 5/6, Gauss points, thickness that follows the strain",
    )
    section = ShellSection(corners, min(points, MOST_POINTS), reference, per_area, layers, place=more.place)
    return make_membrane(deck, section, row, "SECTION_SHELL")


def read_thicknesses(row: Row) -> list[float]:
    """T1 to T4: a corner without one has that of the first."""
    first, *others = row.numbers("T1", "T2", "T3", "T4")
    for name in ("T1", "T2", "T3", "T4"):
        if row.number(name) < 0:
            row.fail(name, "must be positive")
    return [first, *(value or first for value in others)]


def divide_shells(
    deck: KeywordDeck, part: PartCard, shells: list[Element], section: ShellSection, name: str, next_id: int
) -> list[Block]:
    """A block, or blocks of equal thickness where the mesh is not the middle surface."""
    groups: Thicknesses = {}
    for shell in shells:
        groups.setdefault(section.thickness_of(shell), []).append((shell.id, shell.corners))
    if min(groups) <= 0:
        raise BadInput(section.place or part.place, f"T1 is 0 or blank in the section of part {part.id} "
                                                    "(shells need a thickness): give T1 in its *SECTION_SHELL")
    if len(groups) > 1 and not section.reference and not section.per_area and not section.layers:
        deck.ledger.translated(name_thickness(shells), part.place, "thickness of each shell, from the mesh file")
        return [mark_axes(make_block_of_thicknesses(part, groups, section, name), shells)]
    if len(groups) > MOST_THICKNESSES:
        groups = round_thicknesses(deck, part, groups, name_thickness(shells))
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
        deck.ledger.approximated(name_thickness(shells), part.place, "a part for each thickness")
    return blocks


def mark_axes(block: Block, shells: list[Element]) -> Block:
    """Notes which axes of materials the shells of a part have themselves."""
    block.angles, block.has_systems = {shell.angle for shell in shells}, any(shell.system for shell in shells)
    return block


def name_thickness(shells: list[Element]) -> str:
    """The card that gives shells of a part different thicknesses."""
    return "ELEMENT_SHELL_THICKNESS" if any(shell.thickness for shell in shells) else "SECTION_SHELL.T2"


def make_block_of_thicknesses(part: PartCard, groups: Thicknesses, section: ShellSection, name: str) -> Block:
    """All shells of a part, each with its thickness in the mesh file."""
    members = sorted(member for group in groups.values() for member in group)
    thicknesses = {id: thickness for thickness, group in groups.items() for id, _ in group}
    block = Block(part.id, part.id, name, part.place, shells=members, thickness=max(groups), keys=section.make_keys())
    block.thicknesses = thicknesses
    return block


def round_thicknesses(deck: KeywordDeck, part: PartCard, groups: Thicknesses, card: str) -> Thicknesses:
    """As many different thicknesses as parts can be made of."""
    low, high = min(groups), max(groups)
    step = (high - low) / (MOST_THICKNESSES - 1)
    rounded: Thicknesses = {}
    for thickness, members in groups.items():
        rounded.setdefault(low + step * round((thickness - low) / step), []).extend(members)
    deck.ledger.approximated(
        card, part.place, f"{len(groups)} thicknesses are rounded to {len(rounded)}, by at most {step / 2:.3g}"
    )
    return rounded
