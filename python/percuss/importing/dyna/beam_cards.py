"""*ELEMENT_BEAM and *SECTION_BEAM: beams and trusses."""

from ..fields import Row
from ..ledger import BadInput, missing
from ..model import Block, Deck, Vector
from ..shapes import cross, dot, normalise, section_area, subtract
from .cards import Card, Lines
from .deck import BeamElement, KeywordDeck, PartCard
from .mesh_cards import EIGHTS, ELEMENT_FIELDS, elements_of, to_id

LEFT_OUT = "these beams are left out"
MOST_DIRECTIONS = 64  # parts that one *PART may become by how its sections are turned


def read_beams(deck: KeywordDeck, card: Card) -> None:
    """EID PID N1 N2 N3 RT1 RR1 RT2 RR2 LOCAL."""
    options = card.keyword.split("_")[2:]
    if set(options) - {"ORIENTATION", "PID"}:
        deck.ledger.refuse(card.keyword, card.place, "this form of beam elements", "these elements are left out")
        return
    reader = card.reader()
    while reader.skip_blank():
        line = reader.take()
        texts = card.split(line, EIGHTS, ELEMENT_FIELDS) + [""] * 10
        id, part = to_id(card, line[0], texts[0], "EID"), to_id(card, line[0], texts[1], "PID")
        ends = (to_id(card, line[0], texts[2], "N1"), to_id(card, line[0], texts[3], "N2"))
        third = to_id(card, line[0], texts[4], "N3", True)
        if ends[0] == ends[1]:
            raise BadInput(card.at(line[0]), f"beam {id} has the same node at both ends: correct it")
        if any(text not in ("", "0") for text in texts[5:9]):
            deck.ledger.refuse("ELEMENT_BEAM.RT1", card.at(line[0]), "released ends of beams",
                               "the ends stay connected")
        if "PID" in options:
            reader.take()
            deck.ledger.approximated(card.keyword, card.place, "spot welds hold the nearest of the parts that their "
                                                               "contact names, and not PID1 and PID2")
        deck.element_lines["beams"].note(card.at(line[0]), id)
        toward = read_toward(reader) if "ORIENTATION" in options else None
        elements_of(deck, part, card.at(line[0])).beams.append(BeamElement(id, ends, third, toward))
    deck.ledger.translated(card.keyword, card.place, "elements of the mesh, ids kept")


def read_toward(reader: Lines) -> Vector | None:
    """The line VX VY VZ of _ORIENTATION; None where all are 0."""
    vector = tuple(reader.row("VX VY VZ").numbers("VX", "VY", "VZ"))
    return vector if any(vector) else None  # type: ignore[return-value]


def translate_beam_section(deck: KeywordDeck, card: Card) -> Deck | None:
    """The section of a part. None where it is refused."""
    reader = card.reader()
    row = reader.row("SECID ELFORM=1 SHRF QR CST SCOOR NSM NAUPD")
    form = row.integer("ELFORM") or 1
    kind = row.integer("CST")
    if row.number("QR") < 0 and form == 1:
        return make_ruled(deck, row)
    if row.number("QR") < 0 and not deck.ledger.refuse("SECTION_BEAM.QR", row.place,
                                                       f"a rule of integration with formulation {form}",
                                                       "the section of the card is used"):
        return None
    row.skip("SECID", "SHRF", "QR", "NSM")
    row.finish(deck.ledger, "it is left out")
    if form == 1:
        return make_shape(deck, reader, kind)
    if form == 9:
        return make_weld(deck, reader)
    if form == 2:
        return make_general(deck, reader)
    if form == 3:
        more = reader.row("A RAMPT STRESS")
        area = more.positive("A")
        more.finish(deck.ledger, "it begins without a stress")
        deck.ledger.translated(card.keyword, row.place, "trusses")
        return {"truss": {"area": area}}
    deck.ledger.refuse("SECTION_BEAM.ELFORM", row.place,
                       f"formulation {form} of beams (1, 2, 3 and 9 are read)", LEFT_OUT)
    return None


# ICST of *INTEGRATION_BEAM.
SHAPES = ("points", "I", "channel", "angle", "T", "box", "Z", "trapezoid", "circle", "tube", "I 2", "rectangle",
          "cross", "H", "T 2", "I 3", "channel 2", "channel 3", "T 3", "box 2", "hexagon", "hat", "hat 2")  # fmt: skip


def read_rules(deck: KeywordDeck, card: Card) -> None:
    """*INTEGRATION_BEAM: rules of integration, which sections name by -IRID."""
    reader = card.reader()
    while reader.skip_blank():
        row = reader.row("IRID NIP RA ICST K~unused")
        shape, points = row.integer("ICST"), row.integer("NIP")
        row.skip("RA", "K")
        deck.ids.claim("*INTEGRATION_BEAM", row.integer("IRID"), row.place)
        deck.rules[row.integer("IRID")] = (row,
                                           reader.row("D1 D2 D3 D4 SREF TREF D5~unused D6~unused") if shape else None)
        for _ in range(points if reader else 0):
            reader.take()


def make_ruled(deck: KeywordDeck, section: Row) -> Deck | None:
    """The section of a rule: one of the standard shapes whose middle is their centroid."""
    id = -section.integer("QR")
    if id not in deck.rules:
        raise BadInput(section.place, missing(f"*INTEGRATION_BEAM {id}, of section {section.integer('SECID')}"))
    row, sizes = deck.rules[id]
    shape = row.integer("ICST")
    name = SHAPES[shape] if 0 <= shape < len(SHAPES) else "unknown shape"
    if row.integer("NIP") or sizes is None or name not in ("circle", "tube", "rectangle", "I", "box"):
        what = "points of its own" if sizes is None or row.integer("NIP") else f"the shape of ICST {shape} ({name})"
        deck.ledger.refuse("INTEGRATION_BEAM.ICST", row.place,
                           f"a section of beams with {what}: circle, tube, rectangle, box and I are read", LEFT_OUT)
        return None
    first, second = sizes.numbers("D1", "D2")
    if any(sizes.numbers("SREF", "TREF")):
        deck.ledger.refuse("INTEGRATION_BEAM.SREF", sizes.place,
                           "nodes that are not in the middle of the section", "they are")
    section.skip("SECID", "SHRF", "QR", "CST", "NSM")
    section.finish(deck.ledger, "it is left out")
    if name in ("I", "box"):
        return make_walls(deck, row, sizes, name)
    sizes.skip("D3", "D4")
    deck.ledger.translated("INTEGRATION_BEAM", row.place, f"section: {name}")
    for field in ("D1",) if name == "circle" else ("D1", "D2"):
        sizes.positive(field)
    if name == "tube" and second >= first:
        sizes.fail("D2", f"it must be below D1, the outer radius, which is {first:g}")
    if name == "rectangle":
        return {"rectangle": {"size": [first, second]}}
    return ({"round": {"radius": first}} if name == "circle"
            else {"tube": {"outer_radius": first, "inner_radius": second}})


def make_walls(deck: KeywordDeck, row: Row, sizes: Row, name: str) -> Deck:
    """An I or a box: width along s, thickness of its flanges, depth along t, thickness of its web or webs."""
    width, flange, depth, web = sizes.numbers("D1", "D2", "D3", "D4")
    webs = 1 if name == "I" else 2
    for field in ("D1", "D2", "D3", "D4"):
        sizes.positive(field)
    if 2 * flange >= depth or webs * web >= width:
        sizes.fail("D1", "a width, the thickness of flanges, "
                         "a depth above two of them and the thickness of webs are expected")
    if name == "box" and flange == web:
        deck.ledger.translated("INTEGRATION_BEAM", row.place, "section: box")
        return {"box": {"size": [width, depth], "wall": flange}}
    if name == "I":
        deck.ledger.translated("INTEGRATION_BEAM", row.place, "section: i_shape")
        return {"i_shape": {"size": [width, depth], "flange": flange, "web": web}}
    high = depth - 2 * flange
    across = [(2 * web, high), (width, 2 * flange)]  # breadth along s, height along t
    about_s = (width * depth**3 - (width - 2 * web) * high**3) / 12
    about_t = (2 * flange * width**3 + high * (width**3 - (width - 2 * web) ** 3)) / 12
    torsion = 2 * ((width - web) * (depth - flange)) ** 2 / ((width - web) / flange + (depth - flange) / web)
    text = "section: general constants of a box with thin walls; shear in flanges along s, in webs along t"
    deck.ledger.approximated("INTEGRATION_BEAM", row.place, text)
    return {
        "general": {"area": sum(a * b for a, b in across), "inertia_y": about_s, "inertia_z": about_t,
                    "torsion": torsion, "shear_area_y": 2 * width * flange * 5 / 6, "shear_area_z": 2 * web * depth}
    }  # fmt: skip


def make_weld(deck: KeywordDeck, reader: Lines) -> Deck | None:
    """ELFORM 9, a spot weld: a tube whatever CST says."""
    more = reader.row("TS1 TS2 TT1 TT2 PRINT~output UNUSED~unused ITOFF")
    if more.integer("ITOFF"):
        deck.ledger.refuse("SECTION_BEAM.ITOFF", more.place,
                           "spot welds that turn freely about their axis", "they resist torsion")
    return make_widths(deck, more, 1)


def make_shape(deck: KeywordDeck, reader: Lines, kind: int) -> Deck | None:
    """CST 0: a rectangle TS by TT; 1: a tube of these diameters."""
    return make_widths(deck, reader.row("TS1 TS2 TT1 TT2 NSLOC NTLOC ITORM"), kind)


def make_widths(deck: KeywordDeck, more: Row, kind: int) -> Deck | None:
    """The section of the widths of a row."""
    s, s2, t, t2 = more.numbers("TS1", "TS2", "TT1", "TT2")
    more.finish(deck.ledger, "the nodes are in the middle of the section")
    if (s2 and s2 != s) or (t2 and t2 != t):
        deck.ledger.refuse("SECTION_BEAM.TS2", more.place, "sections that differ between the ends",
                           "those of the first node are used")
    more.positive("TS1")
    if kind == 0:
        more.positive("TT1")
    elif kind == 1 and more.not_negative("TT1") >= s:
        more.fail("TT1", f"it must be below TS1, the outer diameter, which is {s:g}")
    deck.ledger.approximated(
        "SECTION_BEAM", more.place, "percuss has one beam: one point along it, normal stress in fibres, elastic shear "
                                    "(factor 5/6 or 9/10) and torque"
    )
    if kind == 0:
        return {"rectangle": {"size": [s, t]}}
    if kind == 1:
        return {"tube": {"outer_radius": s / 2, "inner_radius": t / 2}} if t > 0 else {"round": {"radius": s / 2}}
    deck.ledger.refuse("SECTION_BEAM.CST", more.place, f"cross section type {kind}", LEFT_OUT)
    return None


def make_general(deck: KeywordDeck, reader: Lines) -> Deck:
    """A ISS ITT J SA: resultants. s is y of percuss."""
    more = reader.row("A ISS ITT J SA IST ITORM SAT")
    area, iss, itt, j, shear, across = more.numbers("A", "ISS", "ITT", "J", "SA", "SAT")
    more.finish(deck.ledger, "it is left out")
    for field in ("A", "ISS", "ITT"):
        more.positive(field)
    for field in ("J", "SA", "SAT"):
        more.not_negative(field)
    shear = shear if shear > 0 else area * 5 / 6
    across = across if across > 0 else shear
    deck.ledger.approximated("SECTION_BEAM", more.place, "shear areas of SA and SAT, or 5/6 of A; J of 0 is ISS + ITT")
    return {
        "general": {"area": area, "inertia_y": iss, "inertia_z": itt, "torsion": j if j > 0 else iss + itt,
                    "shear_area_y": shear, "shear_area_z": across}
    }  # fmt: skip


def width_of_section(section: Deck) -> float:
    """Diameter with which a beam of LS-DYNA touches: the first width of ELFORM 1 and 9,
    the root of the area of 2 and 3."""
    if "round" in section:
        return float(2 * section["round"]["radius"])
    if "tube" in section:
        return float(2 * section["tube"]["outer_radius"])
    if "i_shape" in section:
        return float(section_area(section) ** 0.5)
    if "general" in section or "truss" in section:
        return float((section["general"] if "general" in section else section["truss"])["area"] ** 0.5)
    return float(next(iter(section.values()))["size"][0])


def has_axes(section: Deck) -> bool:
    """As percuss judges whether it matters how a section is turned."""
    general = section.get("general")
    return (bool({"rectangle", "box", "i_shape"} & section.keys())
            or (general is not None and general["inertia_y"] != general["inertia_z"]))


def divide_beams(deck: KeywordDeck, part: PartCard, beams: list[BeamElement], name: str, next_id: int) -> list[Block]:
    """A block for each direction in which y of the section points, and for each preload."""
    section = translate_beam_section(deck, deck.sections[part.section])
    if section is None:
        return []
    area = section_area(section)
    if area <= 0:
        raise BadInput(part.place, f"the section of part {part.id} is too small for a number of its area: correct it")
    per_length = (deck.sections[part.section].reader().row("SECID ELFORM=1 SHRF QR CST SCOOR NSM NAUPD")
                  .not_negative("NSM"))
    if per_length > 0:
        deck.ledger.translated("SECTION_BEAM.NSM", part.place,
                               "a higher density in a material of its own, rotary inertia too")
    groups: dict[tuple[tuple[float, ...], int], list[tuple[int, tuple[int, ...]]]] = {}
    for beam in beams:
        toward = find_direction(deck, part, beam) if has_axes(section) else ()
        groups.setdefault((toward, deck.bolt_of_beam.get(beam.id, -1)), []).append((beam.id, beam.ends))
    if len(groups) > MOST_DIRECTIONS:
        raise BadInput(part.place, f"the beams of part {part.id} are turned or preloaded in {len(groups)} ways "
                                   f"(at most {MOST_DIRECTIONS})")
    blocks = []
    for index, ((toward, bolt), members) in enumerate(sorted(groups.items(), key=lambda item: -len(item[1]))):
        keys: Deck = {"section": section, **({"toward": list(toward)} if toward else {})}
        own_name = name if index == 0 else deck.model.names.take(f"{name}_d{index + 1}", "part")
        id = part.id if index == 0 else next_id + index - 1
        block = Block(id, part.id, own_name, part.place, beams=members, keys=keys)
        block.more_density = per_length / area
        blocks.append(block)
        if bolt >= 0:
            deck.bolt_of_block[id] = bolt
    if len({toward for toward, _ in groups}) > 1:
        deck.ledger.approximated("ELEMENT_BEAM.N3", part.place, "a part for each direction of N3")
    return blocks


def find_direction(deck: KeywordDeck, part: PartCard, beam: BeamElement) -> tuple[float, ...]:
    """Direction from the first node to N3, across the beam, to six digits."""
    for node in beam.ends if beam.toward else (*beam.ends, beam.third):
        if node not in deck.nodes:
            raise BadInput(part.place, missing(f"node {node}, of beam {beam.id} (N3 says how its section is turned)"))
    start = deck.nodes[beam.ends[0]]
    axis, to_third = (normalise(subtract(deck.nodes[beam.ends[1]], start)),
                      beam.toward or subtract(deck.nodes[beam.third], start))
    across = cross(cross(axis, to_third), axis)
    if dot(across, across) <= 1e-12 * dot(to_third, to_third):
        raise BadInput(part.place,
                       f"{'the orientation' if beam.toward else 'N3'} of beam {beam.id} lies along the beam")
    return tuple(round(c, 6) + 0.0 for c in normalise(across))
