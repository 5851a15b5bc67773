"""*CONTACT_...: pairs of surfaces and ties."""

from dataclasses import dataclass

from ..fields import Row
from ..ledger import Place
from ..model import Deck
from .cards import Card, Lines
from .deck import KeywordDeck

EXTRA_LINES = {"ERODING": 1, "TIEBREAK": 1, "FAILURE": 1, "THERMAL": 1, "DRAWBEAD": 1}
BREAKS = {"AUTOMATIC": "OPTION NFLS SFLS PARAM~ ERATEN ERATES CT2CN CN", "TIEBREAK": "NFLS SFLS TBLCID THKOFF~"}
INSTEAD = "it is left out"


@dataclass
class Contact:
    """The three mandatory cards."""

    keyword: str
    title: str
    sides: Row
    law: Row
    scale: Row
    failure: Row | None = None  # of a tie that breaks by stress

    @property
    def place(self) -> Place:
        return self.sides.place


def read_contact(deck: KeywordDeck, card: Card) -> None:
    """One contact: its mandatory cards, then the optional ones."""
    reader = card.reader()
    if not reader.skip_blank():
        return
    translate_contact(deck, card, read_cards(deck, card, reader, card.keyword.split("_")))
    read_optional(deck, card, reader)


def read_cards(deck: KeywordDeck, card: Card, reader: Lines, words: list[str]) -> Contact:
    title = ""
    if card.has_id or card.has_title:
        head = reader.row("CID HEADING", (10, 70))
        title = head.text("HEADING") or f"contact_{head.integer('CID')}"
    if "MPP" in words:
        reader.take()
        if reader.peek().startswith("&"):
            reader.take()
    sides = reader.row("SSID MSID SSTYP MSTYP SBOXID MBOXID SPR~ MPR~")
    law = reader.row("FS FD DC VC VDC~ PENCHK~ BT DT=1e20")
    scale = reader.row("SFS~ SFM~ SST MST SFST=1 SFMT=1 FSF=1 VSF~")
    failure = None
    for word, count in EXTRA_LINES.items():
        for _ in range(count if word in words and reader else 0):
            if word == "TIEBREAK" and "SURFACE" in words:
                failure = reader.row(BREAKS["AUTOMATIC" if "AUTOMATIC" in words else "TIEBREAK"])
            else:
                reader.take()
    return Contact(card.keyword, title, sides, law, scale, failure)


def read_optional(deck: KeywordDeck, card: Card, reader: Lines) -> None:
    """Cards A to G: the penalty method and its exceptions, which percuss does not use."""
    rest = []
    while reader:
        rest.append(reader.take())
    if any(text.strip("0. ") for _, text in rest):
        deck.ledger.ignored(
            f"{card.keyword.split('_')[0]} cards A-G",
            card.at(rest[0][0]),
            "numerics of the penalty method; percuss corrects velocities instead",
        )


def translate_contact(deck: KeywordDeck, card: Card, contact: Contact) -> None:
    name = card.keyword
    if "FORCE_TRANSDUCER" in name:
        transduce(deck, contact)
    elif find_strengths(contact):
        if "AUTOMATIC" in name:  # contact goes on where the tie has failed
            add_pairs(deck, contact, is_single=False)
        tie(deck, contact)
    elif "TIEBREAK" in name or "TIED" in name and "FAILURE" in name:
        if deck.ledger.refuse(name, contact.place, "ties that fail", "they do not fail"):
            tie(deck, contact)
    elif "TIED" in name or "SPOTWELD" in name:
        tie(deck, contact)
    elif "INTERIOR" in name:
        deck.model.deck.setdefault("elements", {})["resist_folding"] = True
        deck.ledger.approximated(name, contact.place, "elements.resist_folding, of all solids")
    elif any(word in name for word in ("2D", "DRAWBEAD", "ENTITY", "RIGID", "1D", "GUIDED", "SLIDING", "GEBOD", "COUPLING")):
        deck.ledger.refuse(name, contact.place, "this kind of contact", INSTEAD)
    elif "SINGLE_SURFACE" in name or "GENERAL" in name or "AIRBAG" in name:
        add_pairs(deck, contact, is_single=True)
    else:
        add_pairs(deck, contact, is_single=False)


def side_name(deck: KeywordDeck, contact: Contact, side: str, for_tie: bool = False) -> str | None:
    """The surface of a side: an empty name for all, None for nothing."""
    id, kind, place = contact.sides.integer(side + "SID"), contact.sides.integer(side + "STYP"), contact.place
    if kind == 5 or (kind in (0, 2) and id == 0):
        return ""
    if kind == 0:
        return deck.segment_set_name(id, place)
    if kind in (1, 2):
        return deck.element_set_name("SHELL", id, place) if kind == 1 else deck.part_set_name(id, place)
    if kind == 3:
        deck.find_part(id, place)
        return deck.name_blocks([id], f"surface_{id}") or None
    if kind == 4 and for_tie:
        return deck.node_set_name(id, place)
    if kind == 4:
        return surface_of_nodes(deck, id, place)
    if kind == 6:
        gone = set(deck.list_members("PART", id, place))
        return deck.name_blocks([part for part in deck.parts if part not in gone], f"all_but_{id}") or None
    deck.ledger.refuse("CONTACT.SSTYP", place, f"a surface of type {kind}", "it is left out")
    return None


def name_whole(deck: KeywordDeck, name: str | None) -> str | None:
    """An empty name for a set of all parts."""
    return "" if name and len(deck.model.block_sets.get(name, [])) == len(deck.model.blocks) else name


def surface_of_nodes(deck: KeywordDeck, id: int, place: Place) -> str | None:
    """The parts that have the nodes of a set."""
    nodes = set(deck.list_members("NODE", id, place))
    parts = [part for part in deck.parts if not nodes.isdisjoint(deck.nodes_of_part(part))]
    deck.used.add(("NODE", id))
    deck.ledger.approximated("CONTACT.SSTYP", place, "the whole surface of the parts that have the nodes of the set")
    return deck.name_blocks(parts, f"surface_of_nodes_{id}") or None


def find_friction(deck: KeywordDeck, contact: Contact) -> float:
    """Coulomb's coefficient: the static one, where both differ."""
    static, dynamic, decay = contact.law.numbers("FS", "FD", "DC")
    factor = contact.scale.number("FSF") or 1.0
    if static == -1:
        deck.friction_by_part = True
        deck.ledger.approximated("CONTACT.FS", contact.place, "contact.friction.pairs: of two parts that differ, the larger FS")
        if factor != 1:
            deck.ledger.refuse("CONTACT.FSF", contact.place, f"friction of parts scaled by {factor:g}", "parts keep their FS")
        static = 0.0
    elif static in (2, -2):
        static = 0.0
        deck.ledger.refuse("CONTACT.FS", contact.place, "friction by a table", "there is no friction")
    elif static != dynamic and decay > 0:
        deck.ledger.approximated("CONTACT.FD", contact.place, "the static coefficient at all speeds")
    return static * factor


def check_fields(deck: KeywordDeck, contact: Contact) -> None:
    """What else the cards say."""
    if contact.law.number("BT") > 0 or 0 < contact.law.number("DT") < deck.end_time:
        deck.ledger.refuse("CONTACT.BT", contact.place, "contact with a birth or death time", "it acts during the whole run")
    if contact.sides.integer("SBOXID") or contact.sides.integer("MBOXID"):
        deck.ledger.refuse("CONTACT.SBOXID", contact.place, "contact in a box", "it acts everywhere")
    if any(v < 0 or v > 0 for v in contact.scale.numbers("SST", "MST")):
        deck.ledger.refuse(
            "CONTACT.SST",
            contact.place,
            "a thickness of contact other than that of the shells",
            "shells touch at half their own thickness",
        )
    if set(contact.scale.numbers("SFST", "SFMT")) - {0.0, 1.0}:
        deck.ledger.refuse(
            "CONTACT.SFST", contact.place, "a factor on the thickness of contact", "shells touch at half their own thickness"
        )
    if contact.law.number("VC"):
        deck.ledger.refuse("CONTACT.VC", contact.place, "a limit on the friction stress", "there is no limit")
    contact.law.finish(deck.ledger)
    for row in (contact.sides, contact.scale):
        row.finish(deck.ledger)


def add_pairs(deck: KeywordDeck, contact: Contact, is_single: bool) -> None:
    """A pair of a surface with itself, or of two surfaces."""
    contact.sides.skip("MSID", "MSTYP")
    a = name_whole(deck, side_name(deck, contact, "S"))
    b = a if is_single else name_whole(deck, side_name(deck, contact, "M"))
    by_part = contact.law.number("FS") == -1
    friction = find_friction(deck, contact)
    check_fields(deck, contact)
    if a is None or b is None:
        deck.ledger.ignored(contact.keyword, contact.place, "one of its sides has no element")
        return
    deck.contacts.append({"a": a or "all", "b": b or "all", "friction": friction, "title": contact.title, "by_part": by_part})
    text = "contact.surfaces: a surface with itself" if is_single else "contact.surfaces: a pair, both ways"
    if "AUTOMATIC" in contact.keyword or "ERODING" in contact.keyword:
        deck.ledger.translated(contact.keyword, contact.place, text)
    else:
        deck.ledger.approximated(contact.keyword, contact.place, text + ", both faces of shells, at half their thickness")


def find_strengths(contact: Contact) -> Deck:
    """Of a tie that breaks where (tension / NFLS)^2 + (shear stress / SFLS)^2 reaches 1; empty: of no such tie."""
    row = contact.failure
    if row is None or ("AUTOMATIC" in contact.keyword and row.integer("OPTION") not in (2, 3)):
        return {}
    return {key: row.number(name) for key, name in (("normal", "NFLS"), ("shear", "SFLS")) if row.number(name) > 0}


def nodes_of_side(deck: KeywordDeck, contact: Contact) -> set[int]:
    """Nodes of side a of a tie: of a node set, or of parts."""
    id, kind = contact.sides.integer("SSID"), contact.sides.integer("SSTYP")
    if kind == 4:
        return set(deck.list_members("NODE", id, contact.place))
    if kind in (2, 3):
        return deck.model.nodes_of_blocks([id] if kind == 3 else deck.list_members("PART", id, contact.place))
    return set()


def tie(deck: KeywordDeck, contact: Contact) -> None:
    if contact.law.number("BT") > 0:
        deck.ledger.refuse(
            "CONTACT_TIED.BT", contact.place, "a tie that begins during the run", "the surfaces are in contact, not tied"
        )
        add_pairs(deck, contact, is_single=False)
        return
    a, b = side_name(deck, contact, "S", for_tie=True), side_name(deck, contact, "M")
    thicknesses = contact.scale.numbers("SST", "MST")
    contact.law.skip("FS", "FD")
    if 0 < contact.law.number("DT") < deck.end_time:
        deck.ledger.refuse("CONTACT.BT", contact.place, "a tie with a birth or death time", "it acts during the whole run")
    strengths = find_strengths(contact)
    for row in (contact.sides, contact.law, contact.scale, *([contact.failure] if strengths else [])):
        row.finish(deck.ledger)
    if not a or not b:
        deck.ledger.refuse(contact.keyword, contact.place, "a tie without two named sides", INSTEAD)
        return
    entry: Deck = {"a": a, "b": b}
    reach = 0.6 * sum(abs(t) for t in thicknesses)
    if reach:
        entry["distance"] = reach
    if "SHELL_EDGE" in contact.keyword and nodes_of_side(deck, contact) & deck.model.turning_nodes():
        entry["rotations"] = True
    if strengths:
        entry["failure"] = strengths
    if deck.ledger.allows("CONTACT_TIED.empty"):  # found by the run, which knows the reach
        entry["empty"] = "ignore"
        deck.ledger.approximated("CONTACT_TIED.empty", contact.place, "a tie in reach of nothing is told by the run, and ignored")
    deck.model.deck.setdefault("contact", {}).setdefault("ties", []).append(entry)
    deck.ledger.approximated(
        contact.keyword, contact.place, "contact.ties: gaps stay as they are; the reach is percuss', or 0.6 (SST + MST)"
    )


def transduce(deck: KeywordDeck, contact: Contact) -> None:
    """A force transducer: the force of contact on parts."""
    kind, id = contact.sides.integer("SSTYP"), contact.sides.integer("SSID")
    parts = [id] if kind == 3 else deck.list_members("PART", id, contact.place) if kind == 2 and id else []
    names = deck.part_names(parts)
    if names and contact.sides.integer("MSID") == 0:
        deck.forces.append({"name": deck.model.names.take(contact.title or "force"), "contact": [names, "all"]})
        deck.ledger.translated(contact.keyword, contact.place, "output.history.forces")
    else:
        deck.ledger.ignored(contact.keyword, contact.place, "output of a force, of surfaces that percuss cannot name")


def make_pair(contact: dict) -> Deck:
    """A pair of contact.surfaces; without a coefficient where those of its parts count."""
    pair = {"a": contact["a"], "b": contact["b"]}
    return pair if contact["by_part"] else {**pair, "friction": contact["friction"]}


def finish_contacts(deck: KeywordDeck) -> None:
    """The section of contact. Pairs come before all surfaces, since the first that names a node has its friction."""
    section = deck.model.deck.setdefault("contact", {})
    pairs = [c for c in deck.contacts if c["a"] != "all" or c["b"] != "all"]
    general = [c for c in deck.contacts if c not in pairs]
    if general and not pairs:
        section["surfaces"] = "all"
        if general[0]["friction"]:
            section["friction"] = general[0]["friction"]
    elif deck.contacts:
        section["surfaces"] = [make_pair(c) for c in pairs + general[:1]]
    elif "ties" in section:
        section["surfaces"] = "none"
    else:
        del deck.model.deck["contact"]
    if deck.friction_by_part and "surfaces" in section:
        add_frictions(deck, section)
    if len({c["friction"] for c in general}) > 1:
        place = next(iter(deck.parts.values())).place
        deck.ledger.approximated("CONTACT", place, "several contacts of everything: the friction of the first")


def add_frictions(deck: KeywordDeck, section: Deck) -> None:
    """FS of *PART_CONTACT. Rows count in their order, so that the larger of two parts comes first."""
    given = [part for part in deck.parts.values() if part.friction]
    rows = [
        {"a": name, "friction": part.friction}
        for part in sorted(given, key=lambda part: -(part.friction or 0.0))
        for name in deck.part_names([part.id])
    ]
    if rows:
        section["friction"] = {"default": section.get("friction", 0.0), "pairs": rows}
