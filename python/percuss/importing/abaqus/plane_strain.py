"""Elements of plane strain: hexahedra and wedges with one layer, as thick as their section says,
whose nodes stay in their planes."""

from ..ledger import Place
from .deck import AbaqusDeck
from .mesh import BEAMS, PLANES, POINTS, RIGID, SHELLS, SPRINGS, STRAINED

OTHERS = {*BEAMS, *POINTS, *SPRINGS, *SHELLS} - {*PLANES, *RIGID}


def extrude(deck: AbaqusDeck) -> None:
    """Gives each node of such an element a twin, which all sets and surfaces with the node have too."""
    mesh = deck.mesh
    thicknesses = list_thicknesses(deck)
    flat = deck.list_flat(STRAINED)
    if not flat:
        return
    raised = 10 ** len(str(max(mesh.nodes)))
    for id, (kind, corners) in flat.items():
        if id not in thicknesses:
            continue
        thickness, place = thicknesses[id]
        for node in corners:
            x, y, z = mesh.nodes[node]
            twin = (x, y, z + thickness)
            if mesh.nodes.setdefault(node + raised, twin) != twin:
                deck.ledger.refuse(f"ELEMENT.{kind}", place,
                                   "elements of plane strain that share nodes and differ in thickness",
                                   "they have that of the first of them")
            deck.twins[node] = node + raised
        mesh.elements[id] = (kind, (*corners, *(node + raised for node in corners)))
        deck.ledger.approximated(f"ELEMENT.{kind}", place,
                                 "plane strain: solids with one layer along z, whose nodes stay in their planes")
    refuse_others(deck)


def list_thicknesses(deck: AbaqusDeck) -> dict[int, tuple[float, Place]]:
    """The data line of *SOLID SECTION, 1 where it is blank, by element."""
    found: dict[int, tuple[float, Place]] = {}
    for section in deck.mesh.sections:
        if section.kind == "SOLID":
            ids = [id for id in deck.elements_of(section.elements, section.place)
                   if deck.mesh.elements.get(id, ("",))[0] in STRAINED]
            found.update(dict.fromkeys(ids, (section.area or 1.0, section.place)))
    return found


def refuse_others(deck: AbaqusDeck) -> None:
    """What hangs on one of the two nodes alone would pull it out of its plane."""
    for kind, corners in deck.mesh.elements.values():
        if kind in OTHERS and any(corner in deck.twins for corner in corners) and deck.mesh.place:
            deck.ledger.refuse("ELEMENT.plane_strain", deck.mesh.place, f"elements {kind} on nodes of plane strain",
                               "they act on one of the two planes of nodes")


def hold_layers(deck: AbaqusDeck) -> None:
    """Nodes of plane strain do not move along z."""
    for part in deck.model.blocks if not deck.is_ring else ():
        nodes = {node for _, corners in part.solids for node in corners}
        if nodes & deck.twins.keys() and "rigid" not in part.keys:
            deck.model.add("conditions", {"nodes": part.name, "fixed": ["z"]})
