"""GISSMO: *MAT_ADD_DAMAGE_GISSMO, and *MAT_ADD_EROSION with IDAM of 1.
Failure strains over the triaxiality, and stress that falls before."""

from ... import laws
from ...curves import thin_rows
from ...fields import Row
from ...ledger import BadInput
from ...model import Deck
from ..cards import Lines
from ..deck import KeywordDeck
from .shared import Use, finish_lines, set_layers

FIELDS = "LCSDG ECRIT DMGEXP=1 DCRIT FADEXP=1 LCREGD"


def add_gissmo(deck: KeywordDeck, material: int, law: Deck, use: Use) -> None:
    """Adds what *MAT_ADD_DAMAGE_GISSMO gives to the law of the material."""
    card = deck.gissmos.get(material)
    if card is None:
        return
    reader = card.reader()
    if card.has_title:
        reader.take()
    row = reader.row("MID unused DTYP REFSZ~output NUMFIP=1")
    row.skip("MID")
    damage = reader.row(FIELDS + " INSTF")
    more = reader.row("LCSRS SHRF BIAXF LCDLIM MIDFAIL HISVN SOFT LP2BI")
    if row.number("DTYP") == 0:
        deck.ledger.ignored(card.keyword, card.place, "DTYP of 0: the damage is output alone")
        return
    if row.number("DTYP") != 1:
        deck.ledger.refuse(f"{card.keyword}.DTYP", row.place,
                           "damage by another quantity than the plastic strain", "it is left out")
        return
    if add_failure_strains(deck, law, damage, use):
        add_rates(deck, law, more)
        if use.is_shell:
            set_layers(deck, law, row, use, None)
        deck.ledger.translated(card.keyword, card.place, "failure by the damage of the material")
    for line in (row, damage, more):
        line.finish(deck.ledger)
    finish_lines(deck, card, reader)


def add_idam(deck: KeywordDeck, law: Deck, reader: Lines, use: Use) -> None:
    """The third and fourth line of *MAT_ADD_EROSION: IDAM of 1 is GISSMO."""
    if not reader.skip_blank():
        return
    row = reader.row("IDAM DMGTYP " + FIELDS)
    kind = row.number("IDAM")
    if kind and (kind != 1 or row.number("DMGTYP") != 1):
        row.skip("DMGTYP", *(field.partition("=")[0] for field in FIELDS.split()))
        deck.ledger.refuse("MAT_ADD_EROSION.IDAM", row.place,
                           "damage other than GISSMO (IDAM of 1) that ends in failure (DMGTYP of 1)", "it is left out")
        return
    has_damage = bool(kind) and add_failure_strains(deck, law, row, use)
    row.finish(deck.ledger)
    if reader.skip_blank():
        more = reader.row("SIZFLG REFSZ~output NAHSV~output LCSRS SHRF BIAXF LCDLIM MIDFAIL")
        if has_damage:
            add_rates(deck, law, more)
        more.finish(deck.ledger)


def add_failure_strains(deck: KeywordDeck, law: Deck, row: Row, use: Use) -> bool:
    """Adds `triaxiality` and `size`; returns whether there is such a damage."""
    what = "no LCSDG of a curve" if row.number("LCSDG") <= 0 else "damage of beams" if use.is_beam else ""
    if not laws.has(law, "has_plastic_strain"):
        what = "damage of a law without plastic strain"
    elif "johnson_cook" in law.get("failure", {}) or "size" in law.get("failure", {}):
        what = "damage of a law that has a damage of its own"
    if what:
        row.skip(*(field.partition("=")[0] for field in FIELDS.split()))
        deck.ledger.refuse(row.card, row.place, what, "it is left out")
        return False
    failure: Deck = {"triaxiality": make_rows(deck, row, "LCSDG")}
    row.skip("DMGEXP", "FADEXP")  # without a coupling a power of the sum of strains is 1 where the sum is
    coupling = read_coupling(deck, row)
    if coupling:
        failure["coupling"] = coupling
    if row.number("LCREGD") < 0:
        deck.ledger.refuse(f"{row.card}.LCREGD", row.place, "factors over size and triaxiality", "there are none")
    elif row.number("LCREGD"):
        failure["size"] = make_rows(deck, row, "LCREGD", "length")
    law["failure"] = {**law.get("failure", {}), **failure}
    return True


def read_coupling(deck: KeywordDeck, row: Row) -> Deck:
    """How the stress falls before failure: from the critical strain ECRIT, or from the damage DCRIT on."""
    coupling: Deck = {}
    start = row.number("ECRIT")
    if start < 0:
        coupling["strain"] = make_rows(deck, row, "ECRIT")
    elif start > 0:
        coupling["strain"] = [[0.0, start]]
    elif 0 <= row.number("DCRIT") < 1:
        coupling["damage"] = row.number("DCRIT")
    if not coupling:
        return {}
    if row.number("DMGEXP") < 0:
        row.fail("DMGEXP", "must not be negative")
    coupling["damage_exponent"] = row.number("DMGEXP") or 1.0
    if row.number("FADEXP") < 0:
        coupling["exponent_of_size"] = make_rows(deck, row, "FADEXP", "length")
    else:
        coupling["exponent"] = row.number("FADEXP") or 1.0
    return coupling


def add_rates(deck: KeywordDeck, law: Deck, row: Row) -> None:
    """LCSRS: factors of the strains over the plastic strain rate; below 0 not of ECRIT."""
    number = row.number("LCSRS")
    if not number:
        return
    if number < 0 and law["failure"].get("coupling", {}).get("strain"):
        deck.ledger.refuse(f"{row.card}.LCSRS", row.place,
                           "factors of a rate that ECRIT does not have", "there are none")
        return
    rows = make_rows(deck, row, "LCSRS", "rate")
    if rows[0][0] < 0:
        deck.ledger.refuse(f"{row.card}.LCSRS", row.place, "logarithms of rates", "there are no factors")
        return
    law["failure"]["rate"] = rows


def find_curve(row: Row, name: str) -> int:
    """The id of a curve, which some fields give with a minus."""
    return int(abs(int(row.number(name))) + (row.change.shift_of(row.card, "LCID") if row.change else 0))


def make_rows(deck: KeywordDeck, row: Row, name: str, across: str = "none") -> list[list[float]]:
    """The rows of a curve."""
    points = deck.material_curve(find_curve(row, name), row.place, across, "none")
    if min(y for _, y in points) <= 0:
        raise BadInput(row.place, f"{name} of *{row.card} is a curve with a value that is not positive: correct it")
    rows, error = thin_rows(points)
    if error > 0:
        deck.ledger.approximated(f"{row.card}.{name}", row.place,
                                 f"a curve of {len(points)} rows by {len(rows)}, within {100 * error:.2g} %")
    return [list(point) for point in rows]
