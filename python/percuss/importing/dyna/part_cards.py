"""*PART and *SECTION_...: the parts of the deck, and their elements as blocks."""

from ..ledger import BadInput, missing
from ..model import Block
from .beam_cards import divide_beams
from .cards import Card, Lines
from .contact_cards import note_decay
from .deck import Elements, KeywordDeck, PartCard
from .preload_cards import mark_bolts
from .rigid_cards import read_inertia
from .shell_sections import SHELL_LINE, divide_shells, translate_layup, translate_shell_section

OTHER_SECTIONS = {"SEATBELT", "SPH", "POINT", "ALE1D", "ALE2D", "FPD", "IGA"}
READ_SECTIONS = ("SOLID", "SHELL", "DISCRETE", "BEAM", "TSHELL")
PART_LINES = {"INERTIA": "", "REPOSITION": "CMSN MDEP MOVOPT", "CONTACT": "", "PRINT": "PRBF~output",
              "ATTACHMENT_NODES": "ANSID~implicit"}


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
        deck.ids.claim("parts", id, row.place)
        part = PartCard(id, title, row.place, row.integer("SECID"), row.integer("MID"), row.integer("EOSID"),
                        row.integer("HGID"))
        row.finish(deck.ledger)
        part.is_adaptive = row.number("ADPOPT") != 0
        deck.parts[id] = part
        read_part_options(deck, reader, part, options)
        deck.ledger.translated(card.keyword, row.place, "a part for each thickness, its blocks share nodes with others")


def read_part_options(deck: KeywordDeck, reader: Lines, part: PartCard, options: list[str]) -> None:
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
        deck.ledger.refuse(card.keyword, card.place, f"an option of sections: {kind.split('_', 1)[1]}",
                           "the section is read without it")
        kind = kind.split("_")[0]
        card.keyword = f"SECTION_{kind}"
    if kind.split("_")[0] not in OTHER_SECTIONS and kind not in READ_SECTIONS:
        deck.ledger.refuse(card.keyword, card.place, "an unknown kind of sections", "it is left out")
        return
    if kind not in READ_SECTIONS:
        deck.ledger.ignored(card.keyword, card.place, "a section of elements that percuss does not have")
        return
    reader = card.reader()
    while reader.next_card(of_lines=True):
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
        deck.ids.claim("sections", row.integer("SECID"), row.place)
        deck.sections[row.integer("SECID")] = Card(card.keyword, row.place, card.least_width, card.parameters,
                                                   lines=lines)


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
    """Raises the ids of shells where solids have some of them, and of beams likewise: ids of elements are of one kind
    in percuss."""
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
    deck.ledger.approximated("ELEMENT_BEAM.EID", place,
                             f"ids are raised by {shift}, since other elements have some of them too")


def divide_part(deck: KeywordDeck, part: PartCard, elements: Elements, next_id: int) -> list[Block]:
    """The blocks of a part, without its material."""
    name = deck.model.names.take(part.title or f"part_{part.id}", "part")
    if part.layup:
        if elements.solids or elements.beams:
            raise BadInput(part.place, f"part {part.id} of *PART_COMPOSITE has elements other than shells: correct its "
                                       "id, or divide the part")
        found = translate_layup(deck, part, part.layup, elements.shells)
        return divide_shells(deck, part, elements.shells, found, name, next_id) if found else []
    section = deck.sections.get(part.section)
    if section is None:
        raise BadInput(part.place, missing(f"section {part.section}, of part {part.id}"))
    is_beam = section.keyword.startswith("SECTION_BEAM")
    if elements.beams:
        if elements.solids or elements.shells or not is_beam:
            raise BadInput(part.place, f"part {part.id} has beams, but its section or other elements are of another "
                                       "kind: correct its SECID, or divide the part")
        return divide_beams(deck, part, elements.beams, name, next_id)
    if not elements.shells:
        return [Block(part.id, part.id, name, part.place, solids=elements.solids)]
    if elements.solids or not section.keyword.startswith("SECTION_SHELL"):
        raise BadInput(part.place, f"part {part.id} has shells, but its section or other elements are of solids: "
                                   "correct its SECID, or divide the part")
    found = translate_shell_section(deck, part, section)
    if found is None:
        return []
    return divide_shells(deck, part, elements.shells, found, name, next_id)
