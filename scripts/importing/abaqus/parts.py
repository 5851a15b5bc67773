"""Sections become parts; instances stand in one mesh."""

from collections import Counter

from ..fields import MOST_ID
from ..ledger import BadInput, missing
from ..model import Block as Part
from ..model import NOT_DAMPED, Deck, takes_stiffness_damping
from .bodies import add_reference_masses
from .beams import add_beam_keys, read_beam_section
from .deck import AbaqusDeck
from .lines import Block
from .materials import find, translate_material
from ..solids import NAMES, collapse
from .mesh import BEAMS, SHELLS, SOLIDS, SPRINGS, Scope, Section, join

MOST_NODES = 20_000_000


def read_section(scope: Scope, block: Block) -> None:
    """*SOLID SECTION, *SHELL SECTION and *BEAM SECTION."""
    section = Section(block.keyword.split()[0], block.option("ELSET"), block.option("MATERIAL"), block.place)
    if section.kind == "SHELL" and block.lines:
        section.thickness, section.points = block.number(block.lines[0], 0), block.integer(block.lines[0], 1, 5)
        section.is_nodal = "NODAL THICKNESS" in block.options
        offset = block.option("OFFSET")
        section.offset = {"SPOS": 0.5, "SNEG": -0.5}.get(offset, 0.0)
        if offset and offset not in ("SPOS", "SNEG"):
            section.offset = block.number((block.place.line, [offset]), 0)
    if section.kind == "SOLID" and block.lines:
        section.area = block.number(block.lines[0], 0)
    if section.kind == "BEAM":
        read_beam_section(section, block)
    scope.sections.append(section)


def place_instances(deck: AbaqusDeck, assembly: Scope) -> None:
    """All instances in one mesh: the ids of one alone are kept, those of others raised."""
    for index, instance in enumerate(deck.instances):
        part = deck.parts.get(instance.part)
        if part is None:
            raise BadInput(instance.place, missing(f"part '{instance.part}'"))
        if index > 0:
            highest = max([*deck.mesh.nodes, *deck.mesh.elements, 1])
            if highest > MOST_ID // 100:
                raise BadInput(
                    instance.place, f"the ids of the instances before go up to {highest}, which leaves no room for others"
                )
            instance.shift = 10 ** len(str(highest))
            deck.ledger.approximated("INSTANCE", instance.place, f"ids of instance {instance.name} are raised by {instance.shift}")
        if len(deck.mesh.nodes) + len(part.nodes) + len(instance.own.nodes) > MOST_NODES:
            raise BadInput(instance.place, "the instances have more than 20 million nodes (the limit of the importer): import fewer instances")
        join(deck.mesh, part, instance)
        join(deck.mesh, instance.own, instance)
        deck.ledger.translated("INSTANCE", instance.place, "a part in its place")
    for id, x in assembly.nodes.items():  # reference points
        deck.mesh.nodes.setdefault(id, x)
    for name, table in (("node_sets", assembly.node_sets), ("element_sets", assembly.element_sets), ("surfaces", assembly.surfaces),
                        ("node_surfaces", assembly.node_surfaces)):  # fmt: skip
        getattr(deck.mesh, name).update(table)
    deck.mesh.bodies += assembly.bodies
    deck.mesh.profiles |= assembly.profiles


def build_parts(deck: AbaqusDeck) -> None:
    """A part for each section."""
    made: dict[str, tuple[str, Deck] | None] = {}
    for number, section in enumerate(deck.mesh.sections, 1):
        name = section.material
        if name not in made:
            law = translate_material(deck, name, section.place)
            made[name] = (deck.model.names.take(name, "material"), law) if law else None
            if law:
                deck.model.materials[made[name][0]] = law  # type: ignore[index]
        if made[name]:
            build_part(deck, section, number, *made[name])  # type: ignore[misc]
    left = [id for id, (kind, _) in deck.mesh.elements.items() if id not in deck.blocks_of_elements and kind not in ("MASS", *SPRINGS)]
    if left and deck.mesh.place:
        kinds = sorted({deck.mesh.elements[id][0] for id in left})
        deck.ledger.refuse(
            "ELEMENT.left",
            deck.mesh.place,
            f"{len(left)} elements of {', '.join(kinds)[:60]} without a section that is read",
            "they are left out",
        )


def build_part(deck: AbaqusDeck, section: Section, number: int, material: str, law: Deck) -> None:
    wish = section.elements.rpartition(".")[0] or section.elements
    part = Part(
        number, number, deck.model.names.take(wish, "part"), section.place, density=law["density"], keys={"material": material}
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
    if sum(1 for elements in (part.solids, part.shells, part.beams) if elements) > 1:
        raise BadInput(section.place, "this section has solids, shells or beams together (a part has one kind): divide its element set")
    if part.beams and not add_beam_keys(deck, section, part, law):
        return
    if part.elements():
        add_damping(deck, section, part, law)
        deck.model.blocks.append(part)
        deck.ledger.translated(f"{section.kind} SECTION", section.place, "a part")


def add_damping(deck: AbaqusDeck, section: Section, part: Part, law: Deck) -> None:
    """ALPHA and BETA of *DAMPING of the material."""
    block = find(deck.materials[section.material.upper()], "DAMPING")
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
            deck.ledger.refuse("ELEMENT.B31", section.place, "beams with a node that turns the section", "n1 of the section is used")
        part.beams.append((id, corners[:2]))
    elif kind in SHELLS and len(corners) == SHELLS[kind]:
        part.shells.append((id, corners))
    elif kind in SOLIDS and len(set(corners)) == SOLIDS[kind]:
        part.solids.append((id, corners))
        deck.blocks_of_elements[id] = len(deck.model.blocks)
        if SOLIDS[kind] == 10:
            deck.ledger.approximated(f"ELEMENT.{kind}", section.place, "tetrahedra of ten nodes are cut into eight of four")
        if SOLIDS[kind] != 8:  # have one point, whatever hexahedra have
            return
        integration = "full" if kind == "C3D8" else "one_point"
        counts = deck.integrations.setdefault(len(deck.model.blocks), Counter())
        counts[integration] += 1
    elif SOLIDS.get(kind) == 8 and (solid := collapse(list(corners))) is not None:
        part.solids.append((id, solid))
        deck.ledger.translated("ELEMENT.degenerate", section.place, f"hexahedra with collapsed edges are {NAMES[len(solid)]}")
    else:
        deck.ledger.refuse(
            f"ELEMENT.{kind}", section.place, f"elements {kind or 'without TYPE'}", "they are left out"
        )
        return
    deck.blocks_of_elements[id] = len(deck.model.blocks)


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
    part.thickness = max(part.thicknesses.values())
    deck.ledger.approximated("NODAL THICKNESS", section.place, "each shell has the mean thickness of its corners")
    if len(set(part.thicknesses.values())) == 1:
        part.thicknesses = {}
    elif section.offset:
        deck.ledger.refuse("SHELL SECTION.OFFSET", section.place, "an offset of shells that differ in thickness", "it is left out")
        section.offset = 0.0


def add_shell_keys(deck: AbaqusDeck, section: Section, part: Part) -> None:
    if section.thickness <= 0 and not section.is_nodal:
        raise BadInput(section.place, "the thickness of this shell section is not positive: correct it")
    part.thickness = section.thickness
    if section.is_nodal:
        average_thicknesses(deck, section, part)
    part.keys["points"] = min(max(section.points, 1), 16)
    if section.offset:
        part.keys["reference"] = {0.5: "top", -0.5: "bottom"}.get(section.offset, section.offset * part.thickness)
    deck.ledger.approximated("SHELL SECTION", section.place, "Gauss points; percuss' one shell, whose thickness follows the strain")


def choose_integration(deck: AbaqusDeck) -> None:
    """The integration of most hexahedra for the scene, others by part."""
    if not deck.integrations:
        return
    total = sum(deck.integrations.values(), Counter())
    chosen = total.most_common(1)[0][0]
    if chosen == "full":
        deck.model.deck.setdefault("elements", {})["integration"] = "full"
    for block, counts in deck.integrations.items():
        kind = counts.most_common(1)[0][0]
        if len(counts) > 1:
            deck.ledger.refuse(
                "ELEMENT.mixed", deck.model.blocks[block].place, "C3D8 and C3D8R in one section", f"all of the part are {kind}"
            )
        if kind != chosen:
            deck.model.blocks[block].keys["integration"] = kind


def add_masses(deck: AbaqusDeck) -> None:
    """*MASS on elements of the type MASS."""
    for name, mass, place in deck.mesh.masses:
        nodes = [deck.mesh.elements[id][1][0] for id in deck.elements_of(name, place) if deck.mesh.elements[id][1]]
        nodes = add_reference_masses(deck, nodes, mass) if mass > 0 else nodes
        used = [node for node in nodes if node in deck.used_nodes()]
        if len(used) < len(nodes):
            deck.ledger.refuse("MASS", place, "masses on nodes without elements", "they are left out")
        if used and mass > 0:
            set_name = deck.model.add_node_set(f"mass_{name.rpartition('.')[2]}", used)
            deck.model.add("added_mass", {"nodes": set_name, "mass": mass * len(used), "spread": "evenly"})
            deck.ledger.translated("MASS", place, "added_mass")
