"""Contact of shells with an offset: percuss has both sides at half the thickness from the mesh,
Abaqus from the middle surface."""

from ..ledger import Place
from ..model import Block as Part
from .deck import AbaqusDeck


def report_offsets(deck: AbaqusDeck) -> None:
    """A row for each part of shells with an offset that something touches: where its sides lie in Abaqus."""
    is_general = (not any("friction" in pair for pair in deck.pairs)
                  and all(friction is None for _, _, friction in deck.wall_pairs))
    if deck.contact_ignores_offsets and is_general:
        return
    names = list_touching(deck)
    for part in deck.model.blocks:
        reference, thickness = part.keys.get("reference", 0.0), part.thickness or 0.0
        height = {"top": 0.5 * thickness, "bottom": -0.5 * thickness}.get(reference, reference)
        if height and names and ("all" in names or any(covers(deck, name, part) for name in names)):
            text = (f"contact: both sides lie at half the thickness, {0.5 * thickness:g}, from the mesh; "
                    f"in Abaqus they lie {abs(height):g} further {'against' if height > 0 else 'along'} the normal")
            deck.ledger.approximated("SHELL SECTION.OFFSET", part.place or Place("", 0), text)


def list_touching(deck: AbaqusDeck) -> set[str]:
    """Names of parts, sets and surfaces in contact, and of what walls stop; `all` is everything."""
    surfaces = deck.model.deck.get("contact", {}).get("surfaces", [])
    names = {"all"} if surfaces == "all" else {pair[side] for pair in surfaces if surfaces != "none" for side in "ab"}
    for wall in deck.model.deck.get("walls", []):
        names.update(wall.get("nodes", ["all"]))
    return names


def covers(deck: AbaqusDeck, name: str, part: Part) -> bool:
    """Whether a name has shells of a part."""
    model = deck.model
    if name in model.side_sets:
        faces = {frozenset(face) for face in model.side_sets[name]}
        return any(frozenset(corners) in faces for _, corners in part.shells)
    if name in model.node_sets:
        return not model.nodes_of_blocks([part.id]).isdisjoint(model.node_sets[name])
    return part.id in model.block_sets.get(name, []) or name == part.name
