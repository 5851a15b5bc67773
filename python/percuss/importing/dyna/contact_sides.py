"""What the two sides of a contact name: parts, surfaces, nodes and beams."""

from dataclasses import dataclass

from ..fields import Row
from ..ledger import Place
from ..model import Block
from .deck import KeywordDeck

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


def list_side_parts(deck: KeywordDeck, contact: Contact, side: str) -> list[int] | None:
    """Parts that a side names, solids in place of their skins; None where it names something else."""
    parts = list_named_parts(deck, contact, side)
    return None if parts is None else deck.without_skins(parts)


def list_named_parts(deck: KeywordDeck, contact: Contact, side: str) -> list[int] | None:
    id, kind = contact.sides.integer(side + "SID"), contact.sides.integer(side + "STYP")
    if kind == 5 or (kind in (0, 2) and id == 0):
        return list(deck.parts)
    if kind == 2:
        return deck.list_members("PART", id, contact.place)
    if kind == 3:
        return [id]
    if kind == 4:
        nodes = set(deck.list_members("NODE", id, contact.place))
        return [part for part in deck.parts if not nodes.isdisjoint(deck.nodes_of_part(part))]
    if kind == 6:
        gone = set(deck.list_members("PART", id, contact.place))
        return [part for part in deck.parts if part not in gone]
    return None


def list_side_beams(deck: KeywordDeck, contact: Contact, side: str) -> list[Block]:
    """Blocks of beams of a side; of a side by nodes those that have them, whole.
    Spot welds lie within what they hold together, and touch nothing."""
    parts = list_side_parts(deck, contact, side)
    blocks = [block for block in deck.model.blocks if block.beams and parts is not None and block.part in parts]
    welds = [block for block in blocks
             if deck.materials[deck.parts[block.part].material].keyword.startswith("MAT_SPOTWELD")]
    if welds:
        deck.ledger.approximated(f"{contact.keyword}.beams", contact.place, "beams of *MAT_SPOTWELD touch nothing")
    return [block for block in blocks if block not in welds]


def side_name(deck: KeywordDeck, contact: Contact, side: str, for_tie: bool = False) -> str | None:
    """The surface of a side: an empty name for all, None for nothing."""
    id, kind, place = contact.sides.integer(side + "SID"), contact.sides.integer(side + "STYP"), contact.place
    if kind == 5 or (kind in (0, 2) and id == 0):
        return None if all(block.beams for block in deck.model.blocks) else ""
    if kind == 0:
        return deck.segment_set_name(id, place)
    if kind == 1:
        if refuse_skins(deck, id, place):
            return None
        return deck.element_set_name("SHELL", id, place)
    if kind == 2:
        parts = deck.list_members("PART", id, place)
        if not deck.skins.keys() & set(parts) and not any(block.beams and block.part in parts
                                                          for block in deck.model.blocks):
            return deck.part_set_name(id, place)
        deck.used.add(("PART", id))
        return deck.name_blocks(without_beams(deck, deck.without_skins(parts)), f"surface_{id}") or None
    if kind == 3:
        deck.find_part(id, place)
        return deck.name_blocks(without_beams(deck, deck.without_skins([id])), f"surface_{id}") or None
    if kind == 4 and for_tie:
        return deck.node_set_name(id, place)
    if kind == 4:
        return surface_of_nodes(deck, id, place)
    if kind == 6:
        gone = set(deck.list_members("PART", id, place))
        return deck.name_blocks(without_beams(deck, [part for part in deck.parts if part not in gone]),
                                f"all_but_{id}") or None
    deck.ledger.refuse("CONTACT.SSTYP", place, f"a surface of type {kind}", "it is left out")
    return None


def refuse_skins(deck: KeywordDeck, id: int, place: Place) -> bool:
    """Whether a set of shells has some of a skin: they are no elements of percuss."""
    gone = {shell.id for part in deck.skins for shell in deck.elements[part].shells}
    is_of_skin = not gone.isdisjoint(deck.list_members("SHELL", id, place))
    if is_of_skin:
        deck.ledger.refuse("CONTACT.SSTYP", place, "a set of shells of *MAT_NULL on solids "
                                                   "(percuss takes the solids, by parts): name their part", INSTEAD)
    return is_of_skin


def without_beams(deck: KeywordDeck, parts: list[int]) -> list[int]:
    beams = {block.part for block in deck.model.blocks if block.beams}
    return [part for part in parts if part not in beams]


def name_whole(deck: KeywordDeck, name: str | None) -> str | None:
    """An empty name for a set of all parts that can touch."""
    count = sum(1 for block in deck.model.blocks if not block.beams)
    return "" if name and len(deck.model.block_sets.get(name, [])) == count else name


def surface_of_nodes(deck: KeywordDeck, id: int, place: Place) -> str | None:
    """The parts that have the nodes of a set."""
    nodes = set(deck.list_members("NODE", id, place))
    parts = without_beams(deck, [part for part in deck.parts if not nodes.isdisjoint(deck.nodes_of_part(part))])
    deck.used.add(("NODE", id))
    deck.ledger.approximated("CONTACT.SSTYP", place, "the whole surface of the parts that have the nodes of the set")
    return deck.name_blocks(parts, f"surface_of_nodes_{id}") or None


def nodes_of_side(deck: KeywordDeck, contact: Contact, side: str = "S") -> set[int]:
    """Nodes of a side of a tie."""
    id, kind = contact.sides.integer(side + "SID"), contact.sides.integer(side + "STYP")
    if kind == 4:
        return set(deck.list_members("NODE", id, contact.place))
    if kind == 0 and id:
        return {node for face in deck.find_set("SEGMENT", id, contact.place).segments for node in face}
    parts = list_side_parts(deck, contact, side)
    return deck.model.nodes_of_blocks(deck.blocks_of(parts)) if parts is not None else set()


def name_parts(deck: KeywordDeck, contact: Contact, side: str) -> list[str]:
    """Parts of a side that is one part or a set of them; none of another side."""
    kind, id = contact.sides.integer(side + "STYP"), contact.sides.integer(side + "SID")
    return deck.part_names([id] if kind == 3
                           else deck.list_members("PART", id, contact.place) if kind == 2 and id else [])
