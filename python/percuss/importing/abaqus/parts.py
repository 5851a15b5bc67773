"""Sections become parts with their elements, materials, damping and control of hourglass modes; masses at points."""

from collections import Counter

from ..fields import clip
from ..laws import NOT_DAMPED, has_axes, takes_stiffness_damping
from ..ledger import BadInput, Place, missing
from ..model import FLUID_HOURGLASS
from ..model import Block as Part
from ..model import Deck
from ..solids import NAMES, collapse
from .beams import add_beam_keys, read_general_law
from .bodies import add_reference_masses
from .cohesive import bond_solids
from .damage import LEAST_DEGRADATION
from .deck import AbaqusDeck
from .heat import keep_shells
from .materials import find, translate_material
from .mesh import BEAMS, MEMBRANES, PLANES, POINTS, RIGID, SHELLS, SOLIDS, SPRINGS, THICK_SHELL, Section
from .orientations import orient
from .planes import take_plane
from .plies import refuse_solids
from .rigid_shells import build_rigid_parts
from .shell_keys import add_shell_keys, add_thick_keys, lay_up


def build_parts(deck: AbaqusDeck) -> None:
    """A part for each section."""
    made: dict[str, Deck | None] = {}
    for number, section in enumerate(deck.mesh.sections, 1):
        if section.cohesive:
            continue
        found = find_laws(deck, section, made)
        main = found.get(section.material) if found else None
        if found and section.layers and not one_layer(deck, section, found):
            if section.kind == "SHELL":
                build_part(deck, section, number, "", found[section.layers[0].material][1], found)
                continue
            deck.ledger.refuse(f"{section.keyword}.COMPOSITE", section.place, "layers of several materials or angles",
                               "its elements are left out")
            main = None
        if main:
            build_part(deck, section, number, *main, {})
        else:
            deck.left_elements |= set(deck.elements_of(section.elements, section.place))
    build_rigid_parts(deck)
    for section in deck.mesh.sections:
        if section.cohesive:
            bond_solids(deck, section, section.cohesive)
    without = deck.blocks_of_elements.keys() | deck.left_elements
    left = [id for id, (kind, _) in deck.mesh.elements.items() if id not in without and kind not in (*POINTS, *SPRINGS)]
    if left and deck.mesh.place and not deck.has_lost_section:
        kinds = sorted({deck.mesh.elements[id][0] for id in left})
        deck.ledger.refuse(
            "ELEMENT.left",
            deck.mesh.place,
            f"{len(left)} elements of {', '.join(kinds)[:60]} without a section that is read",
            "they are left out",
        )


def find_laws(deck: AbaqusDeck, section: Section, made: dict[str, Deck | None]) -> "dict[str, tuple[str, Deck]] | None":
    """Names and laws of the materials of a section, by their names there; None where one is refused.
    made: those of sections before."""
    found: dict[str, tuple[str, Deck]] = {}
    for material in dict.fromkeys([layer.material for layer in section.layers] or [section.material]):
        if material not in made:
            made[material] = (read_general_law(section) if section.general
                              else translate_material(deck, material, section.place))
        law = made[material]
        if law is None or not may_be_used(deck, section, material, law):
            return None
        if has_axes(law) or law["model"] == "user":
            law = orient(deck, section, law)
        if section.kind in ("SHELL", "MEMBRANE"):
            law = keep_shells(deck, law, section.place)
        found[material] = (name_law(deck, material, law), law)
    return found


def name_law(deck: AbaqusDeck, material: str, law: Deck) -> str:
    """Its name in the deck; a name of its own for each of its axes."""
    for name in deck.names_of_laws.setdefault(material, []):
        if deck.model.materials[name] == law:
            return name
    name = deck.model.names.take(material, "material")
    deck.names_of_laws[material].append(name)
    deck.model.materials[name] = law
    return name


def may_be_used(deck: AbaqusDeck, section: Section, material: str, law: Deck) -> bool:
    """Axes in rings, and solids of plies, are refused."""
    if (has_axes(law) or (law["model"] == "user" and section.orientation)) and deck.is_ring:
        deck.ledger.refuse(f"{section.kind} SECTION.axisymmetric", section.place,
                           "axes of a material in axisymmetric elements", "they are those of space")
    if not has_axes(law) or section.kind in ("SHELL", "MEMBRANE"):
        return True
    if section.kind != "SOLID":
        deck.ledger.refuse(f"{section.kind} SECTION.MATERIAL", section.place,
                           "beams of an orthotropic material", "they are left out")
        return False
    return law["model"] != "orthotropic" or not refuse_solids(deck, section, material, law)


def one_layer(deck: AbaqusDeck, section: Section, found: "dict[str, tuple[str, Deck]]") -> bool:
    """Whether all layers are the same: of one material, and without angles where it has axes."""
    if len(found) > 1:
        return False
    _, law = next(iter(found.values()))
    if has_axes(law) and any(layer.angle or layer.orientation for layer in section.layers):
        return False
    section.layers = []
    deck.ledger.translated(f"{section.keyword}.COMPOSITE", section.place, "layers of one material are one layer")
    return True


def build_part(deck: AbaqusDeck, section: Section, number: int, material: str, law: Deck,
               plies: "dict[str, tuple[str, Deck]]") -> None:
    """plies: laws of its layers, where these differ."""
    wish = section.elements.rpartition(".")[0] or section.elements
    part = Part(
        number, number, deck.model.names.take(wish, "part"), section.place, density=law["density"],
        keys={"material": material}
    )
    for id in deck.elements_of(section.elements, section.place):
        if id not in deck.mesh.elements:
            raise BadInput(section.place, missing(f"element {id}"))
        kind, corners = deck.mesh.elements[id]
        if id in deck.blocks_of_elements:
            raise BadInput(section.place, f"element {id} has two sections: remove it from one of the element sets")
        sort_element(deck, section, part, id, kind, corners)
        for corner in corners:
            if corner not in deck.mesh.nodes:
                raise BadInput(section.place, missing(f"node {corner}, of element {id}"))
    if part.shells:
        add_shell_keys(deck, section, part)
    if part.solids and section.kind == "SHELL" and not add_thick_keys(deck, section, part, bool(plies)):
        return
    if part.shells and plies:
        lay_up(deck, section, part, plies)
    if sum(1 for elements in (part.solids, part.shells, part.beams) if elements) > 1:
        raise BadInput(section.place, "this section has solids, shells or beams together (a part has one kind): "
                                      "divide its element set")
    if part.beams and not add_beam_keys(deck, section, part, law):
        return
    if part.elements():
        add_damping(deck, section, part, law)
        deck.model.blocks.append(part)
        add_controls(deck, section, part)
        deck.ledger.translated(section.keyword, section.place, "a part")


def is_fluid(deck: AbaqusDeck, part: Part) -> bool:
    return bool(deck.model.materials[part.keys["material"]]["model"] == "fluid")


def add_controls(deck: AbaqusDeck, section: Section, part: Part) -> None:
    """Hourglass control of hexahedra, and factors of viscosity, of *SECTION CONTROLS.
    A fluid that is to be viscous has the control of percuss."""
    if not section.controls:
        return
    block = deck.controls.get(section.controls)
    if block is None:
        raise BadInput(section.place, missing(f"*SECTION CONTROLS '{clip(section.controls)}'"))
    kind = block.option("HOURGLASS")
    ours = {"ENHANCED": "assumed_strain", "STIFFNESS": "stiffness", "RELAX STIFFNESS": "stiffness",
            "COMBINED": "stiffness", "VISCOUS": "viscous"}
    if kind and kind not in ours:
        raise BadInput(block.place, f"HOURGLASS={clip(kind)} of *SECTION CONTROLS is not known: correct it")
    line = block.lines[0] if block.lines else (block.place.line, [])
    if block.option("ELEMENT DELETION") == "NO" and "failure" in deck.model.materials[part.keys["material"]]:
        deck.ledger.refuse("SECTION CONTROLS.ELEMENT DELETION", block.place,
                           "failed elements that stay", "they are removed")
    most = block.option("MAX DEGRADATION")
    if (most and block.number((block.place.line, [most]), 0) < LEAST_DEGRADATION
            and "failure" in deck.model.materials[part.keys["material"]]):
        deck.ledger.refuse("SECTION CONTROLS.MAX DEGRADATION", block.place,
                           "failed elements that keep a part of their stiffness", "they keep none")
    if kind and part.solids and section.kind == "SHELL":
        deck.ledger.ignored("SECTION CONTROLS.HOURGLASS", block.place, "thick shells have no hourglass modes")
    elif kind and part.solids and any(len(set(corners)) == 8 for _, corners in part.solids):
        if ours[kind] != "viscous" or not is_fluid(deck, part):
            part.keys["hourglass"] = ours[kind]
        deck.ledger.approximated("SECTION CONTROLS", block.place,
                                 "hourglass control of its kind, with the coefficient of percuss")
    factors = [block.number(line, i, 1.0) for i in range(5)]
    if factors[:3] != [1.0, 1.0, 1.0]:
        deck.ledger.approximated("SECTION CONTROLS.scale", block.place,
                                 "factors of hourglass control are left out: percuss has coefficients of its own")
    if part.solids and factors[3:] != [1.0, 1.0]:
        part.keys["bulk_viscosity"] = {"linear": 0.06 * factors[3], "quadratic": 1.2 * factors[4]}
        deck.ledger.translated("SECTION CONTROLS", block.place, "bulk_viscosity of the part")


def add_damping(deck: AbaqusDeck, section: Section, part: Part, law: Deck) -> None:
    """ALPHA and BETA of *DAMPING of the material."""
    if part.layers:
        for name in {layer.material for layer in section.layers}:
            if damping := find(deck.materials[name], "DAMPING"):
                deck.ledger.refuse("DAMPING.layers", damping.place, "damping of a layer", "its part has none")
        return
    block = None if section.general else find(deck.materials[section.material.upper()], "DAMPING")
    if block is None:
        return
    line = (block.place.line, [block.options.get(name, "") for name in ("ALPHA", "BETA")])
    alpha, beta = block.number(line, 0), block.number(line, 1)
    if min(alpha, beta) < 0:
        raise BadInput(block.place, "the damping is negative (it would add energy): correct ALPHA or BETA")
    if alpha > 0:
        deck.model.add("damping", {"nodes": part.name, "coefficient": alpha})
        deck.ledger.translated("DAMPING.ALPHA", block.place, "damping of the nodes of the part")
    if beta > 0 and not takes_stiffness_damping(part, law):
        deck.ledger.refuse("DAMPING.BETA", block.place, NOT_DAMPED, "their part has none")
    elif beta > 0:
        part.keys["stiffness_damping"] = beta
        deck.ledger.translated("DAMPING.BETA", block.place, "stiffness_damping of the part")


def sort_element(deck: AbaqusDeck, section: Section, part: Part, id: int, kind: str, corners: tuple[int, ...]) -> None:
    """A solid, a shell or a beam; anything else is refused."""
    if kind in BEAMS and (kind == "T3D2") == (section.kind == "SOLID"):
        if len(corners) > 2:
            deck.ledger.refuse("ELEMENT.B31", section.place, "beams with a node that turns the section",
                               "n1 of the section is used")
        part.beams.append((id, corners[:2]))
    elif (kind in SHELLS and kind not in RIGID and len(corners) == SHELLS[kind]
          and (kind in PLANES) == (section.kind == "SOLID")):
        if kind in PLANES:
            take_plane(deck, section, part, kind)
        if kind in MEMBRANES:
            part.keys["integration"] = "membrane"
            deck.ledger.translated(f"ELEMENT.{kind}", section.place,
                                   "integration: membrane of the part, with one point in the plane")
        part.shells.append((id, corners))
    elif kind == THICK_SHELL and section.kind == "SHELL" and len(set(corners)) == len(corners):
        part.solids.append((id, corners))
    elif kind in SOLIDS and kind != THICK_SHELL and len(set(corners)) == SOLIDS[kind]:
        part.solids.append((id, corners))
        deck.blocks_of_elements[id] = len(deck.model.blocks)
        if SOLIDS[kind] == 10:
            deck.ledger.approximated(f"ELEMENT.{kind}", section.place,
                                     "tetrahedra of ten nodes are cut into eight of four")
        if SOLIDS[kind] != 8:  # have one point, whatever hexahedra have
            return
        integration = "full" if kind == "C3D8" else "one_point"
        counts = deck.integrations.setdefault(len(deck.model.blocks), Counter())
        counts[integration] += 1
    elif SOLIDS.get(kind) == 8 and kind != THICK_SHELL and (solid := collapse(list(corners))) is not None:
        part.solids.append((id, solid))
        deck.ledger.translated("ELEMENT.degenerate", section.place,
                               f"hexahedra with collapsed edges are {NAMES[len(solid)]}")
    else:
        how = (" whose corners fall together in another way than those of wedges, pyramids and tetrahedra"
               if kind in SOLIDS else "")
        if kind == THICK_SHELL:
            how = " with another section than one of shells, or with a node twice"
        deck.ledger.refuse(f"ELEMENT.{kind}", section.place,
                           f"elements {kind or 'without TYPE'}{how}", "they are left out")
        deck.left_elements.add(id)
        return
    deck.blocks_of_elements[id] = len(deck.model.blocks)


def choose_integration(deck: AbaqusDeck) -> None:
    """The integration of most hexahedra for the scene, others by part."""
    if not deck.integrations:
        return
    total: Counter[str] = sum(deck.integrations.values(), Counter())
    chosen = total.most_common(1)[0][0]
    if chosen == "full":
        deck.model.deck.setdefault("elements", {})["integration"] = "full"
    for block, counts in deck.integrations.items():
        kind = counts.most_common(1)[0][0]
        if len(counts) > 1:
            deck.ledger.refuse(
                "ELEMENT.mixed", deck.model.blocks[block].place, "C3D8 and C3D8R in one section",
                f"all of the part are {kind}"
            )
        part = deck.model.blocks[block]
        if kind != chosen:
            part.keys["integration"] = kind
            if chosen == "full" and is_fluid(deck, part):
                part.keys.setdefault("hourglass", dict(FLUID_HOURGLASS))
        if kind == "full" and part.keys.pop("hourglass", "") and deck.controls:
            deck.ledger.ignored("SECTION CONTROLS.HOURGLASS", part.place,
                                "hexahedra of eight points have no hourglass modes")


def add_masses(deck: AbaqusDeck) -> None:
    """*MASS and *ROTARY INERTIA on elements of the types MASS and ROTARYI."""
    for name, mass, place in deck.mesh.masses:
        nodes = list_points(deck, name, place)
        if mass < 0:
            raise BadInput(place, "the mass is negative: correct *MASS")
        nodes = add_reference_masses(deck, nodes, {"mass": mass}, place) if mass > 0 else []
        used = [node for node in nodes if node in deck.used_nodes()]
        if len(used) < len(nodes):
            deck.ledger.refuse("MASS", place, "masses on nodes without elements", "they are left out")
        if used and mass > 0:
            set_name = deck.model.add_node_set(f"mass_{name.rpartition('.')[2]}", used)
            deck.model.add("added_mass", {"nodes": set_name, "mass": mass * len(used), "spread": "evenly"})
            deck.ledger.translated("MASS", place, "added_mass")
    for name, values, place in deck.mesh.inertias:
        xx, yy, zz, xy, xz, yz = values
        left = add_reference_masses(deck, list_points(deck, name, place), {"inertia": [xx, yy, zz, xy, yz, xz]}, place)
        if left:
            deck.ledger.refuse("ROTARY INERTIA", place, "rotary inertia of nodes of no rigid body", "it is left out")


def list_points(deck: AbaqusDeck, name: str, place: Place) -> list[int]:
    """Nodes of elements of one node."""
    return [deck.mesh.elements[id][1][0] for id in deck.elements_of(name, place) if deck.mesh.elements[id][1]]
