"""*CONTACT: general contact, whose parts and friction may change with a step."""

from itertools import combinations_with_replacement

from ..ledger import NO_SPRINGS, BadInput, Place
from ..model import Deck
from . import glue
from .contact import add_pair, end_pair, name_side
from .deck import AbaqusDeck, General
from .lines import Block
from .shell_offsets import report_offsets
from .surfaces import is_profile

MOST_PAIRS = 500
CHANGES = "it is that of the whole run"


def refuse_change(deck: AbaqusDeck, block: Block, what: str) -> None:
    """Refuses changes of what percuss has for the whole run alone."""
    deck.ledger.refuse(f"{block.keyword}.step", block.place, f"{what} that changes with a step", CHANGES)


def find_open(deck: AbaqusDeck) -> General | None:
    """General contact of everything that no step has ended."""
    return deck.generals[-1] if deck.generals and deck.generals[-1].end is None else None


def read_start(deck: AbaqusDeck, block: Block) -> None:
    """OP=NEW: the general contact of the steps before ends."""
    start = deck.step_of(block).start
    deck.ledger.translated(block.keyword, block.place, "contact.surfaces")
    if block.option("OP") != "NEW" or start == 0:
        return
    if deck.excluded or deck.pair_frictions:
        refuse_change(deck, block, "general contact with exclusions, or with frictions of pairs,")
    general = find_open(deck)
    if general:
        general.end = start
    for pair in [pair for pair in deck.pairs if "friction" not in pair and "until" not in pair]:
        end_pair(deck, pair, start)
    deck.whole_friction = 0.0


def read_inclusions(deck: AbaqusDeck, block: Block) -> None:
    """*CONTACT INCLUSIONS: everything, or pairs."""
    if "ALL EXTERIOR" in block.options:
        include_all(deck, block)
        deck.ledger.translated(block.keyword, block.place, "contact.surfaces: all")
        return
    for line in block.lines:
        first, second = block.text(line, 0), block.text(line, 1)
        if first:  # alone it touches itself
            add_pair(deck, block, (line[0], [first, "" if second.upper() == first.upper() else second]), None)
            continue
        if second:
            deck.ledger.refuse("CONTACT INCLUSIONS.exterior", block.at(line[0]),
                               "contact of one surface with everything", "everything touches everything")
        include_all(deck, block)


def include_all(deck: AbaqusDeck, block: Block) -> None:
    if find_open(deck) is None:
        deck.generals.append(General(deck.step_of(block).start, None, deck.whole_friction, block.place))


def read_exclusions(deck: AbaqusDeck, block: Block) -> None:
    """*CONTACT EXCLUSIONS: pairs of general contact that do not touch; one alone does not touch itself."""
    parts = {part.name for part in deck.model.blocks}
    general, start = find_open(deck), deck.step_of(block).start
    is_late = start > 0 and (general is None or general.start < start or len(deck.generals) > 1)
    for line in block.lines:
        place = block.at(line[0])
        names = [block.text(line, 0), block.text(line, 1)]
        if not any(names):
            continue
        sides = [name_side(deck, block, name, place) for name in names if name]
        if not all(sides):
            deck.ledger.ignored(block.keyword, place, "its surfaces have no element")
        elif not parts.issuperset(sides):
            deck.ledger.refuse(block.keyword, place, "an exclusion of surfaces that are not whole parts", "they touch")
        elif is_late:
            deck.ledger.refuse(f"{block.keyword}.step", place, "an exclusion that begins in a later step", "they touch")
        else:
            deck.excluded += [frozenset(sides)] if names[0] else [frozenset({sides[0], part}) for part in parts]
            deck.ledger.translated(block.keyword, place, "contact.surfaces without these pairs of parts")


def read_property(deck: AbaqusDeck, block: Block) -> None:
    """*CONTACT PROPERTY ASSIGNMENT: blank, blank, interaction for all."""
    for line in block.lines:
        place = block.at(line[0])
        if not any(line[1]):
            continue
        friction = deck.friction(block.text(line, 2), place)
        glue.add_glue(deck, block, (block.text(line, 0), block.text(line, 1)), block.text(line, 2), place)
        if not block.text(line, 0) and not block.text(line, 1):
            change_friction(deck, block, friction)
            deck.ledger.translated(block.keyword, place, "contact.friction")
        else:
            assign_friction(deck, block, (block.text(line, 0), block.text(line, 1)), place, friction)


def change_friction(deck: AbaqusDeck, block: Block, friction: float) -> None:
    """Changes the friction of everything, from the step of the block on."""
    start, general = deck.step_of(block).start, find_open(deck)
    if (start > 0 and friction != deck.whole_friction
            and any("friction" not in pair and pair.get("from") != deck.sensor_at(start) for pair in deck.pairs)):
        refuse_change(deck, block, "friction of the surfaces of general contact")
        return
    deck.whole_friction = friction
    if general and general.start < start and general.friction != friction:
        general.end = start
        deck.generals.append(General(start, None, friction, block.place))
    elif general:
        general.friction = friction


def assign_friction(deck: AbaqusDeck, block: Block, names: tuple[str, str], place: Place, friction: float) -> None:
    """Friction of two surfaces, or of one with all. The last that names both counts in Abaqus, the first here."""
    if not names[1]:  # of the first one with itself
        names = (names[0], names[0])
    if any(is_profile(deck, name) for name in names if name):
        deck.ledger.refuse(block.keyword, place,
                           "a friction of one pair with an analytical surface", "that of all is used")
        return
    sides = [deck.surface_name(name, place, of_contact=True) for name in reversed(names) if name]
    if not all(sides):
        deck.ledger.ignored(block.keyword, place, "one of its surfaces has no element")
        return
    row: Deck = dict(zip("ab", sides))
    same = [r for r in deck.pair_frictions if {r["a"], r.get("b")} == {row["a"], row.get("b")}]
    started = any(general.start < deck.step_of(block).start for general in deck.generals)
    if started and same != [{**row, "friction": friction}]:
        refuse_change(deck, block, "friction of two surfaces")
        return
    deck.pair_frictions = [{**row, "friction": friction}, *(r for r in deck.pair_frictions if r not in same)]
    deck.ledger.translated(block.keyword, place, "contact.friction.pairs")


def list_rest(deck: AbaqusDeck) -> list[Deck]:
    """General contact as pairs of parts, without those that are excluded."""
    names = [part.name for part in deck.model.blocks]
    pairs = [pair for pair in combinations_with_replacement(names, 2) if frozenset(pair) not in deck.excluded]
    if len(pairs) > MOST_PAIRS:
        raise BadInput(deck.steps[0].place, f"general contact with exclusions makes {len(pairs)} pairs of parts "
                                            f"(at most {MOST_PAIRS}): name the pairs that touch")
    return [{"a": a, "b": b} for a, b in pairs]


def join_generals(deck: AbaqusDeck) -> list[General]:
    """Without those of no length; those of one friction, one behind the other, as one."""
    joined: list[General] = []
    for general in deck.generals:
        if general.end is not None and general.end <= general.start:
            continue
        if joined and joined[-1].end == general.start and joined[-1].friction == general.friction:
            joined[-1].end = general.end
        else:
            joined.append(general)
    return joined


def list_general_pairs(deck: AbaqusDeck, generals: list[General]) -> list[Deck]:
    """Pairs in place of `all`, where there are others or it changes with a step."""
    rest = list_rest(deck) if deck.excluded else [{"a": "all", "b": "all"}]
    if len(generals) == 1 and generals[0].start == 0 and generals[0].end is None:
        return rest if deck.pairs or deck.excluded else []
    place = generals[-1].place
    if deck.wall_pairs or any(group.profile for group in deck.groups):
        deck.ledger.refuse("CONTACT.step", place,
                           "general contact with an analytical surface that changes with a step", CHANGES)
    windows = []
    for general in generals:
        times: Deck = (({"from": deck.sensor_at(general.start)} if general.start > 0 else {})
                       | ({"until": deck.sensor_at(general.end)} if general.end is not None else {}))
        windows += [{**pair, "friction": general.friction, **times} for pair in rest]
    return windows


def include_beams(deck: AbaqusDeck, section: Deck, place: Place) -> None:
    """Beams and trusses are among all surfaces, unless they lie in solids."""
    embedded = {entry["nodes"] for entry in deck.model.deck.get("embedded", {}).values()}
    if any(part.beams and part.name not in embedded for part in deck.model.blocks):
        section["beams"] = True
        deck.ledger.approximated("CONTACT INCLUSIONS.beams", place,
                                 "contact.beams: beams touch as round bars, of a rectangle or a box with its area")


def finish_contact(deck: AbaqusDeck) -> None:
    section = deck.model.deck.setdefault("contact", {})
    generals = join_generals(deck)
    pairs = deck.pairs + (list_general_pairs(deck, generals) if generals else [])
    if generals or pairs:
        section["surfaces"] = pairs or "all"
        if generals:
            include_beams(deck, section, generals[0].place)
            deck.ledger.approximated("CONTACT.stiffness", generals[0].place, f"the penalty method: {NO_SPRINGS}")
        if deck.whole_friction and not all("friction" in pair for pair in pairs or [{}]):
            section["friction"] = deck.whole_friction
    elif "ties" in section:
        section["surfaces"] = "none"
    else:
        del deck.model.deck["contact"]
    if deck.pair_frictions and deck.model.deck.get("contact") and section["surfaces"] != "none":
        section["friction"] = {"default": section.get("friction", 0.0), "pairs": deck.pair_frictions}
    refuse_ring_friction(deck, section)
    report_offsets(deck)


def refuse_ring_friction(deck: AbaqusDeck, section: Deck) -> None:
    """The flat faces of a sector are pressed by more than its share of the ring, where they face outward."""
    has_friction = section.get("friction") or any(pair.get("friction") for pair in deck.pairs)
    if deck.is_ring and section.get("surfaces", "none") != "none" and has_friction:
        deck.ledger.refuse("FRICTION.axisymmetric", deck.steps[0].place, "friction between axisymmetric elements",
                           "it is up to 1.4 times as large")
