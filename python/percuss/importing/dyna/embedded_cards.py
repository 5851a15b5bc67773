"""*CONSTRAINED_BEAM_IN_SOLID, and *CONSTRAINED_LAGRANGE_IN_SOLID with CTYPE 2:
nodes of bars keep their places in solids."""

from ..fields import Row
from ..ledger import Place
from ..model import Block
from .cards import Card
from .deck import KeywordDeck
from .weld_cards import NEVER

INSTEAD = "they are held in all directions"
LEFT_OUT = "it is left out"


def read_beams_in_solids(deck: KeywordDeck, card: Card) -> None:
    """BSID SSID BSTYP SSTYP - - NCOUP CDIR, then START END - AXFOR - PSSF - XINT; with _ID a line before."""
    reader = card.reader()
    while reader.next_card(of_lines=True):
        if card.has_id or card.has_title:
            reader.row("COUPID~label TITLE~label", (10, 70)).skip("TITLE")
        row = reader.row("BSID SSID BSTYP SSTYP UNUSED1~unused UNUSED2~unused NCOUP CDIR")
        more = reader.row("START END UNUSED3~unused AXFOR UNUSED4~unused PSSF~penalty=0.1 UNUSED5~unused XINT")
        if row.integer("CDIR"):
            deck.ledger.refuse(f"{card.keyword}.CDIR", row.place, "bars that slide along their axes", INSTEAD)
        if row.integer("NCOUP"):
            deck.ledger.approximated(f"{card.keyword}.NCOUP", row.place,
                                     "the nodes of the bars alone are held, not points between them")
        refuse_times(deck, card, more)
        bars = list_blocks(deck, row.integer("BSID"), row.integer("BSTYP"), row.place)
        add_embedded(deck, card, bars,
                     list_blocks(deck, row.integer("SSID"), row.integer("SSTYP"), row.place), row.place)
        row.finish(deck.ledger)
        more.finish(deck.ledger, "the bond is perfect")


def read_bars_in_solids(deck: KeywordDeck, card: Card) -> None:
    """LSTRSID ALESID LSTRSTYP ALESTYP NQUAD CTYPE DIREC MCOUP, START END and what other couplings have;
    with _ID a line before."""
    reader = card.reader()
    while reader.next_card(of_lines=True):
        if card.has_id or card.has_title:
            reader.row("COUPID~label TITLE~label", (10, 70)).skip("TITLE")
        row = reader.row("LSTRSID ALESID LSTRSTYP ALESTYP NQUAD~penalty CTYPE=2 DIREC~penalty=1 MCOUP~penalty")
        more = reader.row(
            "START END PFAC~penalty=0.1 FRIC~unused FRCMIN~unused=0.5 NORM~unused NORMTYP~unused DAMP~unused")
        reader.row("CQ~unused HMIN~unused HMAX~unused ILEAK~unused PLEAK~unused=0.01 LCIDPOR~unused NVENT~unused "
                   "BLOCKAGE~unused").finish(deck.ledger)
        if reader.holds_more() and not card.has_id:
            reader.row("IBOXID IPENCHK~output INTFORC~output IALESOF~unused LAGMUL~unused PFACMM~penalty "
                       "THKF~unused").finish(deck.ledger)
        kind = row.integer("CTYPE")
        if kind not in (0, 2):
            deck.ledger.refuse(f"{card.keyword}.CTYPE", row.place,
                               f"CTYPE {kind}, a coupling with a fluid (2 holds bars in solids)", LEFT_OUT)
            continue
        refuse_times(deck, card, more)
        bars = list_blocks(deck, row.integer("LSTRSID"), row.integer("LSTRSTYP"), row.place)
        add_embedded(deck, card, bars,
                     list_blocks(deck, row.integer("ALESID"), row.integer("ALESTYP"), row.place), row.place)
        row.finish(deck.ledger)
        more.finish(deck.ledger)


def refuse_times(deck: KeywordDeck, card: Card, row: Row) -> None:
    for name in ("START", "END"):
        if 0 < row.number(name) < NEVER:
            deck.ledger.refuse(f"{card.keyword}.{name}", row.place, "a coupling that begins or ends at a time",
                               "it acts from the start to the end of the run")


def list_blocks(deck: KeywordDeck, id: int, kind: int, place: Place) -> list[Block] | None:
    """Blocks of a set of parts or a part; None: of something else."""
    if kind not in (0, 1):
        return None
    if kind == 1:
        deck.find_part(id, place)
    parts = set(deck.list_members("PART", id, place)) if kind == 0 else {id}
    if kind == 0:
        deck.used.add(("PART", id))
    return [block for block in deck.model.blocks if block.part in parts]


def add_embedded(deck: KeywordDeck, card: Card, bars: list[Block] | None, hosts: list[Block] | None,
                 place: Place) -> None:
    """An entry for each part of bars."""
    if bars is None or hosts is None:
        deck.ledger.refuse(f"{card.keyword}.BSTYP", place,
                           "bars or solids other than parts and sets of parts", LEFT_OUT)
        return
    solids = [block for block in hosts if block.solids]
    if not bars or not solids:
        deck.ledger.refuse(f"{card.keyword}.empty", place, "bars or solids without elements", LEFT_OUT)
        return
    if any("rigid" in block.keys for block in bars + solids):
        deck.ledger.refuse(f"{card.keyword}.rigid", place, "bars in rigid bodies, or rigid bars", LEFT_OUT)
        return
    entries = deck.model.deck.setdefault("embedded", {})
    for block in bars:
        name = deck.model.names.take(f"in_solids_{len(entries) + 1}")
        entries[name] = {"nodes": block.name, "in": [solid.name for solid in solids]}
    deck.ledger.translated(card.keyword, place, "embedded")
