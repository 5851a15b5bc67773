"""*ELEMENT_DISCRETE with its sections and materials: springs and dampers between two nodes."""

from ..ledger import BadInput, Place, missing
from ..model import Deck
from .cards import Card
from .deck import KeywordDeck, PartCard, SpringElement
from .mesh_cards import elements_of

LEFT_OUT = "these springs are left out"


def read_springs(deck: KeywordDeck, card: Card) -> None:
    """EID PID N1 N2 VID S PF OFFSET."""
    if card.keyword != "ELEMENT_DISCRETE":
        deck.ledger.refuse(card.keyword, card.place, "this form of springs", LEFT_OUT)
        return
    for line in card.lines:
        if not line[1].strip():
            continue
        row = card.row(line, "EID PID N1 N2 VID S=1 PF~output OFFSET", (8, 8, 8, 8, 8, 16, 8, 16))
        id, part, first, second = (row.integer(name) for name in ("EID", "PID", "N1", "N2"))
        scale = row.number("S") or 1.0
        row.finish(deck.ledger, "the axis of the two nodes, and their distance, are used")
        elements_of(deck, part, row.place)
        deck.springs.append(SpringElement(id, part, (first, second), scale, row.place))
        deck.part_of_spring.add(part)


def note_spring_materials(deck: KeywordDeck) -> None:
    """Materials that springs use."""
    for part in deck.part_of_spring:
        if part in deck.parts:
            deck.used.add(("material", deck.parts[part].material))


def is_translated_section(deck: KeywordDeck, part: PartCard) -> bool:
    """Whether the section of springs says nothing that percuss does not have."""
    card = deck.sections.get(part.section)
    if card is None:
        raise BadInput(part.place, missing(f"section {part.section}, of part {part.id}"))
    reader = card.reader()
    row = reader.row("SECID DRO KD V0~unused CL FD")
    if row.integer("DRO") and not deck.ledger.refuse("SECTION_DISCRETE.DRO", row.place, "torsional springs", LEFT_OUT):
        return False
    row.skip("SECID", "DRO")
    row.finish(deck.ledger, "it is left out")
    if reader:
        limits = reader.row("CDL TDL")
        limits.finish(deck.ledger, "there is no limit of the deflection")
    deck.ledger.translated(card.keyword, row.place, "springs between nodes")
    return not row.integer("DRO")


def make_law(deck: KeywordDeck, part: PartCard) -> Deck | None:
    """Keys of a spring of this part; None where its law is refused."""
    card = deck.materials.get(part.material)
    if card is None:
        raise BadInput(part.place, missing(f"material {part.material}, of part {part.id}"))
    name = card.keyword.removeprefix("MAT_")
    reader = card.reader()
    if name == "SPRING_ELASTIC":
        row = reader.row("MID K")
        law: Deck = {"stiffness": row.positive("K")}
    elif name == "DAMPER_VISCOUS":
        row = reader.row("MID DC")
        law = {"damping": row.positive("DC")}
    elif name == "SPRING_NONLINEAR_ELASTIC":
        row = reader.row("MID LCD LCR")
        points = deck.material_curve(row.integer("LCD"), row.place, "length", "force")
        if len(points) < 2:
            row.fail("LCD", "a curve of two points or more is expected")
        law = {"table": [list(point) for point in points]}
    else:
        deck.ledger.refuse(card.keyword, card.place, "this law of springs", LEFT_OUT)
        return None
    row.skip("MID")
    row.finish(deck.ledger, "the force does not depend on the rate")
    deck.ledger.translated(card.keyword, card.place, "springs: " + ", ".join(law))
    return law


def scale_law(law: Deck, scale: float) -> Deck:
    """Forces times the factor of an element."""
    if scale == 1.0:
        return law
    return {
        key: [[row[0], scale * row[1]] for row in value] if key == "table" else scale * value
        for key, value in law.items()
    }


def add_springs(deck: KeywordDeck) -> None:
    """An entry of `springs` for each element."""
    laws: dict[int, Deck | None] = {}
    used = deck.used_nodes()
    for spring in deck.springs:
        if spring.part not in laws:
            part = deck.find_part(spring.part, spring.place)
            laws[spring.part] = make_law(deck, part) if is_translated_section(deck, part) else None
        law = laws[spring.part]
        if law is None or not has_ends(deck, spring.nodes, used, spring.place):
            continue
        if spring.scale < 0:
            deck.ledger.refuse("ELEMENT_DISCRETE.S", spring.place, "a spring with a negative factor", LEFT_OUT)
            continue
        ends = [{"id": node} for node in spring.nodes]
        springs = deck.model.deck.setdefault("springs", {})
        springs[deck.model.names.take(f"spring_{spring.id}")] = {"between": ends, **scale_law(law, spring.scale)}
        deck.ledger.translated("ELEMENT_DISCRETE", spring.place, "springs: one for each element")


def has_ends(deck: KeywordDeck, nodes: tuple[int, int], used: set[int], place: Place) -> bool:
    """Whether both ends are nodes of elements that are written."""
    for node in nodes:
        if node and node not in deck.nodes:
            raise BadInput(place, missing(f"node {node}"))
    if nodes[0] and nodes[0] == nodes[1]:
        raise BadInput(place, f"both ends of a spring are node {nodes[0]}: correct it")
    if 0 in nodes:
        deck.ledger.refuse("ELEMENT_DISCRETE.ground", place, "springs to the ground", LEFT_OUT)
    elif not used.issuperset(nodes):
        deck.ledger.refuse("ELEMENT_DISCRETE.free", place, "springs to nodes without elements", LEFT_OUT)
    else:
        return True
    return False
