"""*PART_COMPOSITE: parts of shells with plies."""

from ..ledger import BadInput
from ..model import Layer
from .cards import Card, Lines
from .deck import KeywordDeck, Layup, PartCard

LAYERS = "MID1 THICK1 B1 TMID1~thermal MID2 THICK2 B2 TMID2~thermal"
LONG_LAYER = "MID1 THICK1 B1 TMID1~thermal PLYID1~label SHRFAC1=1"
MOST_LAYERS = 1000


def read_composite(deck: KeywordDeck, card: Card) -> None:
    """A title, PID ELFORM SHRF NLOC MAREA HGID ADPOPT THSHEL, then the plies from the bottom."""
    reader = card.reader()
    title = reader.text()
    row = reader.row("PID ELFORM SHRF=1 NLOC MAREA HGID ADPOPT~adaptive THSHEL~thermal")
    id = row.integer("PID")
    if id < 1:
        row.fail("PID", "an id is expected")
    deck.ids.claim("parts", id, row.place)
    part = PartCard(id, title, row.place, 0, 0, 0, row.integer("HGID"))
    if "_CONTACT" in card.keyword:
        read_contact(deck, reader, part)
    plies = read_plies(deck, reader, "_LONG" in card.keyword)
    if not plies:
        raise BadInput(row.place, f"part {id} has no ply with a material and a thickness: add MID1 and THICK1")
    thickness = sum(thick for _, thick, _ in plies)
    part.material = plies[0][0]
    part.layup = Layup(row, thickness, [Layer(material, thick / thickness, angle) for material, thick, angle in plies])
    deck.parts[id] = part
    deck.ledger.translated(card.keyword, row.place, "a part with plies")


def read_contact(deck: KeywordDeck, reader: Lines, part: PartCard) -> None:
    row = reader.row("FS FD DC VC OPTT SFT=1 SSF~penalty")
    part.friction = row.number("FS") if row.has("FS") else None
    part.contact_thickness = row.number("OPTT")
    row.finish(deck.ledger, "it is left out")


def read_plies(deck: KeywordDeck, reader: Lines, is_long: bool) -> list[tuple[int, float, float]]:
    """Material, thickness and angle of each."""
    plies: list[tuple[int, float, float]] = []
    while reader.skip_blank():
        row = reader.row(LONG_LAYER if is_long else LAYERS)
        for place in ("1",) if is_long else ("1", "2"):
            material, thick, angle = row.integer(f"MID{place}"), row.number(f"THICK{place}"), row.number(f"B{place}")
            if material and thick > 0:
                plies.append((material, thick, angle))
            elif material or thick:
                row.fail(f"THICK{place}" if material else f"MID{place}",
                         "a ply needs a material and a positive thickness")
        row.finish(deck.ledger)
        if len(plies) > MOST_LAYERS:
            raise BadInput(row.place,
                           f"the part has more than {MOST_LAYERS} plies (the limit of the importer): join equal ones")
    return plies
