"""*CONTACT_...: their names and fields, pairs of surfaces, and friction; tie_cards.py has ties."""

from dataclasses import replace

from ..fields import REASONS, Row
from ..ledger import NO_SPRINGS
from ..model import Block, Deck
from .beam_cards import width_of_section
from .cards import Card, Lines
from .contact_sides import INSTEAD, Contact, list_side_beams, list_side_parts, name_parts, name_whole, side_name
from .deck import KeywordDeck
from .tie_cards import GLUES, STICKS, describe_breaking, find_glue_fault, find_option, find_strengths, find_times, tie

SINGLE, PAIR, TIE, INTERIOR, TRANSDUCER = "single", "pair", "tie", "interior", "transducer"
# What the name of a contact begins with, behind CONTACT_, and what it is.
FAMILIES = {
    "AUTOMATIC_SINGLE_SURFACE": SINGLE, "AUTOMATIC_GENERAL": SINGLE, "SINGLE_SURFACE": SINGLE,
    "AIRBAG_SINGLE_SURFACE": SINGLE, "ERODING_SINGLE_SURFACE": SINGLE, "AUTOMATIC_SURFACE_TO_SURFACE": PAIR,
    "AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE": PAIR, "AUTOMATIC_NODES_TO_SURFACE": PAIR,
    "AUTOMATIC_BEAMS_TO_SURFACE": PAIR, "SURFACE_TO_SURFACE": PAIR, "ONE_WAY_SURFACE_TO_SURFACE": PAIR,
    "NODES_TO_SURFACE": PAIR, "ERODING_SURFACE_TO_SURFACE": PAIR, "ERODING_NODES_TO_SURFACE": PAIR,
    "FORMING_SURFACE_TO_SURFACE": PAIR, "FORMING_ONE_WAY_SURFACE_TO_SURFACE": PAIR, "FORMING_NODES_TO_SURFACE": PAIR,
    "CONSTRAINT_SURFACE_TO_SURFACE": PAIR, "CONSTRAINT_NODES_TO_SURFACE": PAIR, "TIEBREAK_SURFACE_TO_SURFACE": TIE,
    "TIEBREAK_NODES_TO_SURFACE": TIE, "TIED_SURFACE_TO_SURFACE": TIE, "TIED_NODES_TO_SURFACE": TIE,
    "TIED_SHELL_EDGE_TO_SURFACE": TIE, "TIED_SHELL_EDGE_TO_SOLID": TIE, "SPOTWELD": TIE,
    "AUTOMATIC_SURFACE_TO_SURFACE_MORTAR_TIED": TIE, "INTERIOR": INTERIOR, "FORCE_TRANSDUCER": TRANSDUCER,
}  # fmt: skip
# Options behind it: lines behind the three cards; what is lost, and what is done instead, where percuss lacks it.
OPTIONS: dict[str, tuple[int, str, str]] = {
    "MPP": (0, "", ""), "MORTAR": (0, "", ""), "SMOOTH": (0, "", ""), "OFFSET": (0, "", ""), "BEAM_OFFSET": (0, "", ""),
    "CONSTRAINED_OFFSET": (0, "", ""), "PENALTY": (0, "", ""), "TIEBREAK": (1, "", ""), "FAILURE": (0, "", ""),
    "THERMAL": (1, "", ""),
    "INTERIOR": (0, "", ""), "ONLY": (0, "", ""), "WITH_TORSION": (0, "", ""),
    "CONSTRAINT": (0, "", ""), "EDGEONLY": (0, "contact of edges alone", "faces touch too"),
    "ORTHO_FRICTION": (4, "friction that depends on the direction", "FS acts in all directions"),
    "THERMAL_FRICTION": (2, "friction that depends on the temperature", "FS acts at all temperatures"),
    "LUBRICATION": (1, "lubrication of the surfaces", "FS acts alone"),
    "COMPOSITE": (1, "friction and bond of composites", "FS acts alone"),
    "INTERFERENCE": (1, "surfaces that overlap at the start and press each other apart",
                     "they stay without force until they approach further"),
    "CONTRACTION_JOINT": (1, "a contraction joint", "it is contact without it"),
    "DAMPING": (1, "a tie with damping", "it has none"),
    "USER": (1, "a tie by a subroutine of the user", "it does not fail"),
    "TIED": (1, "surfaces that are tied where they are close", "they touch, and are not tied"),
    "TIED_WELD": (2, "surfaces that are tied where they are hot", "they touch, and are not tied"),
}  # fmt: skip
# Ties have no friction, and reach as far as SST and MST say; transducers are output.
LAW_OF = {
    TIE: "FS~unused FD~unused DC~unused VC~unused VDC~penalty PENCHK~search BT DT=1e20",
    TRANSDUCER: "FS~unused FD~unused DC~unused VC~unused VDC~unused PENCHK~unused BT~output DT~output=1e20",
}
SCALE_OF = {
    TIE: "SFS~penalty=1 SFM~penalty=1 SST MST SFST~unused=1 SFMT~unused=1 FSF~unused=1 VSF~unused=1",
    TRANSDUCER: "SFS~unused SFM~unused SST~unused MST~unused SFST~unused SFMT~unused FSF~unused VSF~unused",
}
BREAKS = {"AUTOMATIC": "OPTION NFLS SFLS PARAM ERATEN ERATES CT2CN CN", "TIEBREAK": "NFLS SFLS TBLCID THKOFF"}
# Optional cards A to G.
OPTIONAL = (
    "SOFT~penalty SOFSCL~penalty=0.1 LCIDAB MAXPAR~search=1.025 SBOPT~penalty=2 DEPTH~search=2 BSORT~search "
    "FRCFRQ~step=1",
    "PENMAX~penalty THKOPT~penalty SHLTHK~penalty SNLOG~penalty ISYM~penalty I2D3D~penalty SLDTHK SLDSTF~penalty",
    "IGAP~penalty=1 IGNORE~penalty DPRFAC~penalty DTSTIF~penalty EDGEK~penalty UNUSED~unused FLANGL~penalty "
    "CIDRCF~output",
    "Q2TRI~penalty DTPCHK~output SFNBR~penalty FNLSCL~penalty DNLSCL~penalty TCSO~penalty TIEDID~penalty "
    "SHLEDG~penalty",
    "SHAREC~penalty CPARM8~penalty IPBACK~penalty SRNDE~penalty FRICSF~penalty=1 ICOR FTORQ REGION",
    "PSTIFF~penalty IGNROFF UNUSED~unused FSTOL~penalty=2 BINR2D~absent SSFTYP~penalty SWTPR~penalty TETFAC~penalty",
    "UNUSED~unused SHLOFF",
)


def split_name(keyword: str) -> tuple[str, list[str]] | None:
    """Family and options of a contact; None where a word of its name is none of them."""
    words = keyword.removeprefix("CONTACT_").split("_")
    leading = [word for word in words if word != "MPP"]  # it may stand anywhere
    for count in range(len(leading), 0, -1):
        family = "_".join(leading[:count])
        if family in FAMILIES:
            options = match_options(leading[count:])
            return None if options is None else (family, options + ["MPP"] * ("MPP" in words))
    return None


def match_options(words: list[str]) -> list[str] | None:
    """Words as options, the longest first; None where one is no option."""
    found: list[str] = []
    while words:
        count = next((n for n in (2, 1) if len(words) >= n and "_".join(words[:n]) in OPTIONS), 0)
        if not count:
            return None
        found.append("_".join(words[:count]))
        words = words[count:]
    return found


def read_contact(deck: KeywordDeck, card: Card) -> None:
    """One contact: its mandatory cards, then the optional ones."""
    name = split_name(card.keyword)
    if name is None:
        deck.ledger.refuse(card.keyword, card.place, "this kind of contact", INSTEAD)
        return
    family, options = name
    if FAMILIES[family] == INTERIOR:
        deck.model.deck.setdefault("elements", {})["resist_folding"] = True
        deck.ledger.approximated(card.keyword, card.place, "elements.resist_folding, of all solids")
        return
    kinds = {TIE: "CONTACT_TIED", TRANSDUCER: "CONTACT_FORCE_TRANSDUCER"}
    reader = replace(card, keyword=kinds.get(FAMILIES[family], "CONTACT")).reader()  # what its fields are called
    if not reader:
        deck.ledger.ignored(card.keyword, card.place, "it has no lines")
        return
    contact = read_cards(card, reader, family, options)
    lost = [(option, *OPTIONS[option][1:]) for option in options if OPTIONS[option][1]]
    if all([deck.ledger.refuse(f"{card.keyword}", contact.place, problem, instead) for _, problem, instead in lost]):
        translate_contact(deck, contact, family, options)
    read_optional(deck, reader)


def read_cards(card: Card, reader: Lines, family: str, options: list[str]) -> Contact:
    title = ""
    if card.has_id or card.has_title:
        head = reader.row("CID HEADING", (10, 70))
        title, id = head.text("HEADING"), head.integer("CID")
        title = title or (f"contact_{id}" if id else "")
    if "MPP" in options:
        reader.take()
        if reader.peek().startswith("&"):
            reader.take()
    sides = reader.row("SSID MSID SSTYP MSTYP SBOXID MBOXID SPR~output MPR~output")
    law = reader.row(LAW_OF.get(FAMILIES[family], "FS FD DC VC VDC~penalty PENCHK~search BT DT=1e20"))
    scale = reader.row(SCALE_OF.get(FAMILIES[family],
                                    "SFS~penalty=1 SFM~penalty=1 SST MST SFST=1 SFMT=1 FSF=1 VSF~penalty=1"))
    failure, lines = None, sum(OPTIONS[option][0] for option in options if option != "TIEBREAK")
    if family.startswith(("ERODING", "CONSTRAINT")):
        lines += 1
    if breaks_by_stress(family, options):
        failure = reader.row(BREAKS["AUTOMATIC" if family.startswith("AUTOMATIC") else "TIEBREAK"])
    elif family.startswith("TIEBREAK") or "TIEBREAK" in options:
        lines += 1
    for _ in range(lines):
        if reader:
            reader.take()
    return Contact(card.keyword, title, sides, law, scale, failure)


def breaks_by_stress(family: str, options: list[str]) -> bool:
    """Whether a tie of surfaces has the strengths NFLS and SFLS. Those of nodes are forces."""
    is_of_surfaces = family.endswith("SURFACE_TO_SURFACE") and FAMILIES[family] in (PAIR, TIE)
    return is_of_surfaces and (family.startswith("TIEBREAK") or "TIEBREAK" in options)


def read_optional(deck: KeywordDeck, reader: Lines) -> None:
    """Cards A to G: the penalty method and its exceptions."""
    for layout in OPTIONAL:
        if not reader:
            return
        row = reader.row(layout)
        row.finish(deck.ledger, "it is left out")


def translate_contact(deck: KeywordDeck, contact: Contact, family: str, options: list[str]) -> None:
    name, kind = contact.keyword, FAMILIES[family]
    breaks = family.startswith("TIEBREAK") or "TIEBREAK" in options or "FAILURE" in options
    if kind == TRANSDUCER:
        transduce(deck, contact)
    elif find_option(contact) in GLUES:
        problem = find_glue_fault(deck, contact)
        if not problem and "ONLY" not in options:
            add_pairs(deck, contact, False, options)
        if not problem or deck.ledger.refuse(name, contact.place, problem, "it is a tie that does not fail"):
            tie(deck, contact, is_glue=not problem)
    elif find_strengths(contact) or find_option(contact) == 1:
        # contact goes on where the tie has failed, or is not yet
        if "ONLY" not in options or find_option(contact) in STICKS:
            add_pairs(deck, contact, False, options)
        tie(deck, contact)
    elif breaks:
        if deck.ledger.refuse(name, contact.place, *describe_breaking(contact)):
            tie(deck, contact)
    elif kind == TIE:
        tie(deck, contact)
    else:
        add_pairs(deck, contact, kind == SINGLE, options)


def set_contact_radius(deck: KeywordDeck, contact: Contact, side: str, block: Block) -> None:
    """Beams touch as circles.
    Their diameter is SST or OPTT, else TS1 of ELFORM 1 and 9, or the root of the area of 2 and 3, times SFST."""
    section: Deck = block.keys["section"]
    width = abs(contact.scale.number(f"{side}ST")) or deck.parts[block.part].contact_thickness
    if not width:
        width = width_of_section(section) * (contact.scale.number(f"SF{side}T") or 1.0)
    radius, own = block.keys.get("contact_radius"), 0.5 * width
    if radius is not None and radius != own:
        text = (f"a contact thickness of the beams of part {block.part} of {2 * own:g}, "
                f"which is {2 * radius:g} in another contact")
        deck.ledger.refuse(f"CONTACT.{side}ST", contact.place, text, "that of the first contact acts in all")
        return
    block.keys["contact_radius"] = own


def list_beam_pairs(deck: KeywordDeck, contact: Contact, sides: str, names: list[str | None],
                    options: list[str]) -> list[tuple[str, str]]:
    """Pairs with beams. sides: of the contact; names: the surfaces beside them.
    Where each is long, as in _GENERAL, beams touch each other, too."""
    beams = [list_side_beams(deck, contact, side) for side in sides]
    for side, blocks in zip(sides, beams):
        for block in blocks:
            set_contact_radius(deck, contact, side, block)
    others, of_others = names[-1], beams[-1]
    pairs = [(block.name, others or "all") for block in beams[0] if others is not None]
    if len(sides) > 1:
        pairs += [(names[0] or "all", block.name) for block in of_others if names[0] is not None]
    if "AUTOMATIC_GENERAL" in contact.keyword or "MORTAR" in options:
        pairs += [(a.name, b.name) for i, a in enumerate(beams[0])
                  for b in (beams[0][i:] if len(sides) == 1 else of_others)]
    elif beams[0] and of_others:
        text = ("beams touch surfaces and edges, not each other, "
                "as in LS-DYNA but for nodes of beams: *CONTACT_AUTOMATIC_GENERAL has them")
        deck.ledger.approximated(f"{contact.keyword}.beams", contact.place, text)
    return pairs


def find_friction(deck: KeywordDeck, contact: Contact) -> float:
    """Coulomb's coefficient: the static one, where both differ."""
    static = contact.law.number("FS")
    factor = contact.scale.number("FSF") or 1.0
    if static == -1:
        deck.friction_by_part = True
        deck.ledger.approximated("CONTACT.FS", contact.place,
                                 "contact.friction.pairs: of two parts that differ, the larger FS")
        if factor != 1:
            deck.ledger.refuse("CONTACT.FSF", contact.place,
                               f"friction of parts scaled by {factor:g}", "parts keep their FS")
        contact.law.skip("FD", "DC")
        return 0.0
    if static in (2, -2):
        deck.ledger.refuse("CONTACT.FS", contact.place, "friction by a table", "there is no friction")
        contact.law.skip("FD", "DC")
        return 0.0
    note_decay(deck, contact.law, "CONTACT")
    return static * factor


def note_decay(deck: KeywordDeck, row: Row, card: str) -> None:
    """mu = FD + (FS - FD) exp(-DC v): FS where DC is 0."""
    static, dynamic, decay = row.numbers("FS", "FD", "DC")
    if static != dynamic and decay > 0:
        deck.ledger.approximated(f"{card}.FD", row.place, "the static coefficient at all speeds")


def check_fields(deck: KeywordDeck, contact: Contact) -> None:
    """What else the cards say."""
    if contact.sides.integer("SBOXID") or contact.sides.integer("MBOXID"):
        deck.ledger.refuse("CONTACT.SBOXID", contact.place, "contact in a box", "it acts everywhere")
    for side, sign in (("S", "S"), ("M", "M")):
        check_thickness(deck, contact, side, f"{sign}ST", f"SF{sign}T")
    if contact.law.number("VC"):
        deck.ledger.refuse("CONTACT.VC", contact.place, "a limit on the friction stress", "there is no limit")
    if contact.law.number("VDC"):
        deck.ledger.approximated("CONTACT.VDC", contact.place,
                                 "percuss' contact has no springs to damp: an impact is not elastic within a node")
    contact.law.finish(deck.ledger)
    for row in (contact.sides, contact.scale):
        row.finish(deck.ledger)


def check_thickness(deck: KeywordDeck, contact: Contact, side: str, field: str, factor_field: str) -> None:
    """SST and SFST are those of shells; of solids they do nothing."""
    value, factor = contact.scale.number(field), contact.scale.number(factor_field)
    parts = list_side_parts(deck, contact, side)
    shells = [block for block in deck.model.blocks if block.shells and (parts is None or block.part in parts)]
    found = {t for block in shells
             for t in ([block.thickness] if not block.thicknesses else block.thicknesses.values())}
    if value and found - {abs(value)}:
        deck.ledger.refuse(
            f"CONTACT.{field}", contact.place, "a thickness of contact other than that of the shells",
            "shells touch at half their own thickness"
        )
    if factor not in (0.0, 1.0) and not value and shells:
        deck.ledger.refuse(
            f"CONTACT.{factor_field}", contact.place, "a factor on the thickness of contact",
            "shells touch at half their own thickness"
        )


def add_pairs(deck: KeywordDeck, contact: Contact, is_single: bool, options: list[str]) -> None:
    """A pair of a surface with itself, or of two surfaces, and pairs with beams."""
    contact.sides.skip("MSID", "MSTYP")
    a = name_whole(deck, side_name(deck, contact, "S"))
    b = a if is_single else name_whole(deck, side_name(deck, contact, "M"))
    pairs = [] if a is None or b is None else [(a or "all", b or "all")]
    pairs += list_beam_pairs(deck, contact, "S" if is_single else "SM", [a] if is_single else [a, b], options)
    by_part = contact.law.number("FS") == -1
    friction = find_friction(deck, contact)
    times = find_times(deck, contact)
    check_fields(deck, contact)
    if not pairs:
        deck.ledger.ignored(contact.keyword, contact.place, "one of its sides has no element")
        return
    for one, other in pairs:
        deck.contacts.append({"a": one, "b": other, "friction": friction, "title": contact.title, "by_part": by_part,
                              "times": times, "place": contact.place})
    text = "contact.surfaces: a surface with itself" if is_single else "contact.surfaces: a pair, both ways"
    if "INTERIOR" in options:
        deck.ledger.approximated(f"{contact.keyword}.INTERIOR", contact.place,
                                 "edges inside shells touch other edges where they fold by 10 degrees")
    if "AUTOMATIC" in contact.keyword or "ERODING" in contact.keyword:
        deck.ledger.translated(contact.keyword, contact.place, text)
    else:
        deck.ledger.approximated(contact.keyword, contact.place,
                                 text + ", both faces of shells, at half their thickness")


def transduce(deck: KeywordDeck, contact: Contact) -> None:
    """A force transducer: the force of contact on parts, by all others or by those of side M."""
    if contact.sides.integer("SBOXID") or contact.sides.integer("MBOXID"):
        deck.ledger.refuse("CONTACT_FORCE_TRANSDUCER.SBOXID", contact.place, "a force in a box",
                           "it is that of the whole side")
    names, others = (name_parts(deck, contact, "S"),
                     name_parts(deck, contact, "M") if contact.sides.integer("MSID") else "all")
    if names and others:
        deck.forces.append({"name": deck.model.names.take(contact.title or "force"), "contact": [names, others]})
        deck.ledger.translated(contact.keyword, contact.place, "output.history.forces")
    else:
        deck.ledger.ignored(contact.keyword, contact.place, "output of a force, of surfaces that percuss cannot name")


def make_pair(contact: Deck) -> Deck:
    """A pair of contact.surfaces; without a coefficient where those of its parts count."""
    pair = {"a": contact["a"], "b": contact["b"], **contact["times"]}
    return pair if contact["by_part"] else {**pair, "friction": contact["friction"]}


def read_defaults(deck: KeywordDeck, card: Card) -> None:
    """*CONTROL_CONTACT: what counts where a contact has FS = -1 or nothing else says it."""
    reader = card.reader()
    first = reader.row("SLSFAC~penalty=0.1 RWPNAL~penalty ISLCHK~search=1 SHLTHK~penalty PENOPT~penalty=1 "
                       "THKCHG~penalty ORIEN~penalty=1 ENMASS")
    second = reader.row(
        "USRSTR~storage USRFRC NSBCS~search INTERM~search XPENE~penalty=4 SSTHK~penalty ECDT~step TIEDPRJ~penalty")
    third = reader.row("SFRIC DFRIC EDC VFC TH TH_SF PEN_SF~penalty PTSCL~penalty=1")
    fourth = reader.row(
        "IGNORE~penalty FRCENG~output SKIPRWG~output OUTSEG~output SPOTSTP~penalty SPOTDEL SPOTHIN DIR_TIE~penalty")
    fifth = reader.row("ISYM~penalty NSEROD~penalty RWGAPS~penalty=1 RWGDTH~penalty RWKSF~implicit=1 ICOV~penalty "
                       "SWRADF~penalty ITHOFF~thermal")
    sixth = reader.row(
        "SHLEDG~penalty PSTIFF~penalty ITHCNT~thermal TDCNOF~penalty FTALL~output UNUSED~unused SHLTRW IGACTC~absent")
    deck.usual_friction = max(third.number("SFRIC"), 0.0)
    if third.number("SFRIC") != third.number("DFRIC") and third.number("EDC") > 0:
        deck.ledger.approximated("CONTROL_CONTACT.DFRIC", third.place, "the static coefficient at all speeds")
    third.skip("DFRIC", "EDC")
    if third.number("TH_SF") not in (0.0, 1.0):
        deck.ledger.refuse("CONTROL_CONTACT.TH_SF", third.place, "TH_SF: a factor on the thickness of contact",
                           "shells touch at half their own thickness")
    if any(fourth.numbers("SPOTDEL", "SPOTHIN")):
        text = "spot welds: where the thickness of contact overlaps it is without force, and a tie ends with its face"
        deck.ledger.approximated("CONTROL_CONTACT.SPOTHIN", fourth.place, text)
    if first.integer("ENMASS") == 1:
        deck.ledger.approximated("CONTROL_CONTACT.ENMASS", first.place, "nodes of eroded shells stay in contact, too")
    deck.keeps_eroded_nodes, deck.contact_control = first.integer("ENMASS") > 0, first.place
    for row in (first, second, third, fourth, fifth, sixth):
        row.finish(deck.ledger, "it is left out")
    if deck.usual_friction:
        deck.ledger.translated(card.keyword, card.place,
                               "contact.friction.default of parts without their own, where FS is -1")
    else:
        deck.ledger.ignored(card.keyword, card.place, REASONS["penalty"])


def check_part_thicknesses(deck: KeywordDeck) -> None:
    """OPTT of *PART_CONTACT: shells touch at half their own thickness; of beams it is the diameter."""
    for block in deck.model.blocks:
        wanted = deck.parts[block.part].contact_thickness
        own = set(block.thicknesses.values()) or {block.thickness or 0.0}
        if wanted and deck.contacts and (block.solids or (block.shells and own != {wanted})):
            text = (f"a thickness of contact of {wanted:g}, "
                    f"which its {'solids' if block.solids else 'shells'} do not have")
            deck.ledger.refuse("PART_CONTACT.OPTT", deck.parts[block.part].place, text,
                               "parts touch at half the thickness of their shells")


def finish_contacts(deck: KeywordDeck) -> None:
    """The section of contact. Pairs come before all surfaces, since the first that names a node has its friction."""
    check_part_thicknesses(deck)
    section = deck.model.deck.setdefault("contact", {})
    pairs = [c for c in deck.contacts if c["a"] != "all" or c["b"] != "all"]
    general = [c for c in deck.contacts if c not in pairs]
    general = [c for c in general if not c["times"]] or general
    if general and not pairs and not general[0]["times"]:
        section["surfaces"] = "all"
        if general[0]["friction"] and not general[0]["by_part"]:
            section["friction"] = general[0]["friction"]
    elif deck.contacts:
        section["surfaces"] = [make_pair(c)
                               for c in pairs + (general if general and general[0]["times"] else general[:1])]
    elif "ties" in section:
        section["surfaces"] = "none"
    else:
        del deck.model.deck["contact"]
    if deck.contacts:
        deck.ledger.approximated("CONTACT.stiffness", deck.contacts[0]["place"],
                                 f"SFS, SFM, SOFT, SOFSCL, SLSFAC and the like: {NO_SPRINGS}")
    if deck.friction_by_part and "surfaces" in section:
        add_frictions(deck, section)
    remove_eroded_nodes(deck)
    if len({c["friction"] for c in general}) > 1:
        deck.ledger.approximated("CONTACT", general[1]["place"],
                                 "several contacts of everything: the friction of the first")


def remove_eroded_nodes(deck: KeywordDeck) -> None:
    """ENMASS 0: nodes whose elements are all eroded go out of the calculation.
    Otherwise they stay, as percuss has it."""
    fails = any("failure" in law for law in deck.model.materials.values())
    if fails and deck.contacts and not deck.keeps_eroded_nodes:
        deck.model.deck["erosion"] = {"free_nodes": "remove"}
        if deck.contact_control:
            deck.ledger.translated("CONTROL_CONTACT.ENMASS", deck.contact_control,
                                   "erosion.free_nodes: remove, as ENMASS 0 has it")
        else:
            deck.ledger.translated("CONTROL_CONTACT (none)", deck.contacts[0]["place"],
                                   "erosion.free_nodes: remove, as ENMASS 0 has it, the default")


def add_frictions(deck: KeywordDeck, section: Deck) -> None:
    """FS of *PART_CONTACT, and SFRIC of *CONTROL_CONTACT of the other parts.
    Of two parts the larger counts: rows are tried in their order."""
    given = sorted((part for part in deck.parts.values() if part.friction is not None),
                   key=lambda part: -(part.friction or 0.0))
    rows: list[Deck] = []
    for index, part in enumerate(given):
        for name in deck.part_names([part.id]):
            if part.friction >= deck.usual_friction:  # type: ignore[operator]
                rows.append({"a": name, "friction": part.friction})
            else:
                others = [other for later in given[index:] for other in deck.part_names([later.id])]
                rows += [{"a": name, "b": other, "friction": part.friction} for other in others]
    if rows:
        section["friction"] = {"default": deck.usual_friction, "pairs": rows}
    elif deck.usual_friction:
        section["friction"] = deck.usual_friction
