"""Thickness, points and plies of parts of shells, and of continuum shells."""

from ..fields import clip
from ..laminates import MOST_POINTS, add_plies, find_difference, reduce_points
from ..ledger import BadInput
from ..model import Block as Part
from ..model import Deck
from .deck import AbaqusDeck
from .mesh import Section
from .orientations import read_angles


def add_thick_keys(deck: AbaqusDeck, section: Section, part: Part, has_plies: bool) -> bool:
    """`integration` of continuum shells; False if they are left out."""
    if has_plies:
        deck.ledger.refuse("SHELL SECTION.COMPOSITE", section.place, "layers of several materials or angles in SC8R",
                           "its elements are left out")
        deck.left_elements |= {id for id, _ in part.solids}
        for id, _ in part.solids:
            deck.blocks_of_elements.pop(id, None)
        return False
    if section.offset:
        deck.ledger.refuse("SHELL SECTION.OFFSET", section.place,
                           "an offset of SC8R, whose nodes are the bottom and the top", "it is 0")
    points = 3 if section.points <= 3 else 5
    across = {"": "third", "1": "first", "2": "second", "3": "third"}.get(section.stack)
    if across is None:
        deck.ledger.refuse("SHELL SECTION.STACK DIRECTION", section.place,
                           f"the stack direction {section.stack}", "it is 3")
    part.keys["integration"] = ({"kind": "thick_shell", "points": points}
                                | ({"across": across} if across not in (None, "third") else {}))
    text = (f"thick shells with 2x2 columns of {points} Gauss points for one column of {section.points}; "
            "the thickness is that of the nodes")
    deck.ledger.approximated("ELEMENT.SC8R", section.place, text)
    return True


def average_thicknesses(deck: AbaqusDeck, section: Section, part: Part) -> None:
    """Each shell has the mean of its corners; a node that *NODAL THICKNESS does not name has none."""
    of_nodes: dict[int, float] = {}
    for name, thickness, place in deck.mesh.thicknesses:
        of_nodes.update(dict.fromkeys(deck.nodes_of(name, place), thickness))
    for id, corners in part.shells:
        values = [of_nodes.get(node, 0.0) for node in corners]
        if min(values) <= 0:
            raise BadInput(section.place, f"shell {id} has a node without a thickness, which its section asks for")
        part.thicknesses[id] = values[0] if len(set(values)) == 1 else sum(values) / len(values)
    deck.ledger.approximated("NODAL THICKNESS", section.place, "each shell has the mean thickness of its corners")
    unite_thicknesses(deck, section, part)


def distribute_thicknesses(deck: AbaqusDeck, section: Section, part: Part) -> None:
    """Each shell has its own of *DISTRIBUTION."""
    values = deck.resolve(deck.mesh.distributions, section.distribution, section.place, "distribution")
    for id, _ in part.shells:
        value = values.get(id, values.get(0, 0.0))
        if value <= 0:
            raise BadInput(section.place, f"the thickness of shell {id} in *DISTRIBUTION {clip(section.distribution)} "
                                          f"is {value:g} (it must be positive): correct it")
        part.thicknesses[id] = value
    deck.ledger.translated("SHELL SECTION.SHELL THICKNESS", section.place, "thickness of each shell in the mesh")
    unite_thicknesses(deck, section, part)


def unite_thicknesses(deck: AbaqusDeck, section: Section, part: Part) -> None:
    """One thickness where all are the same."""
    part.thickness = max(part.thicknesses.values())
    if len(set(part.thicknesses.values())) == 1:
        part.thicknesses = {}
    elif section.offset:
        deck.ledger.refuse("SHELL SECTION.OFFSET", section.place,
                           "an offset of shells that differ in thickness", "it is left out")
        section.offset = 0.0


def add_shell_keys(deck: AbaqusDeck, section: Section, part: Part) -> None:
    if section.thickness <= 0 and not section.is_nodal and not section.distribution:
        raise BadInput(section.place, f"the thickness of this shell section is {section.thickness:g} "
                                      "(it must be positive): correct it")
    part.thickness = section.thickness
    if section.is_nodal:
        average_thicknesses(deck, section, part)
    if section.distribution:
        distribute_thicknesses(deck, section, part)
    if "integration" in part.keys:  # a membrane
        text = ("one membrane of percuss, whose thickness follows the strain by the material, "
                "not by POISSON of the section")
        deck.ledger.approximated(section.keyword, section.place, text)
        return
    part.keys["points"] = min(max(section.points, 1), 16)
    if section.offset:
        part.keys["reference"] = {0.5: "top", -0.5: "bottom"}.get(section.offset, section.offset * part.thickness)
    deck.ledger.approximated(section.keyword, section.place,
                             "Gauss points; percuss' one shell, whose thickness follows the strain")


def lay_up(deck: AbaqusDeck, section: Section, part: Part, found: "dict[str, tuple[str, Deck]]") -> None:
    """Plies of a part, and the material from whose axes their angles count."""
    if part.thicknesses:
        deck.ledger.refuse("SHELL SECTION.COMPOSITE", section.place, "layers of shells that differ in thickness",
                           "all have the sum of their layers")
        part.thicknesses = {}
    part.thickness = section.thickness
    part.layers = reduce_points(deck.ledger, "SHELL SECTION.COMPOSITE", section.place, read_angles(deck, section))
    laws = dict(found)
    if find_difference(part.layers, laws) == "failure":  # type: ignore[arg-type]
        deck.ledger.refuse("SHELL SECTION.COMPOSITE", section.place, "layers whose materials fail in different ways",
                           "the failure of one of them counts for all")
    name, law = add_plies(part, part.layers, laws, {})  # type: ignore[arg-type]
    part.keys.pop("points", None)
    part.keys = {"material": name, **{key: value for key, value in part.keys.items() if key != "material"}}
    if any(has_points(one) for _, one in found.values()):
        part.keys["points"] = max(1,
                                  min(max(layer.points for layer in section.layers), MOST_POINTS // len(part.layers)))
    deck.ledger.approximated("SHELL SECTION.COMPOSITE", section.place,
                             "plies with Gauss points, two where they do not yield: they bend as laminate theory says")


def has_points(law: Deck) -> bool:
    """Whether more points through a ply give more of it: it yields."""
    return law["model"] not in ("orthotropic", "elastic")
