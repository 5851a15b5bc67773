"""*DATABASE_...: what is written, and when."""

from typing import Any

from .. import laws
from ..model import Block, Deck
from ..shapes import dot, make_vector, subtract
from .cards import Card, read_ids
from .deck import KeywordDeck
from .preload_cards import Plane
from .weld_cards import list_rigid_nodes

FIELDS = ["velocity", "von_mises"]
MOST_POINTS = 200  # followed nodes and elements, each a group of columns
MOST_FORCES = 32  # of contact and walls
MOST_FRAMES = 100000
# Files whose values are columns of the history, with what asks for them or where they always are.
ASCII = {
    "NODOUT": "followed nodes", "ELOUT": "followed elements", "GLSTAT": "energies of the scene",
    "MATSUM": "energies of parts", "RCFORC": "forces of contact", "SPCFORC": "forces of supports",
    "BNDOUT": "forces of supports", "RWFORC": "forces of walls", "SECFORC": "forces of sections",
    "SLEOUT": "work of contact by pairs", "DEFORC": "spring_force of each spring", "JNTFORC": "joint_fx of each joint",
    "SWFORC": "weld_normal and weld_shear of each weld", "RBDOUT": "body_x of each rigid body",
}  # fmt: skip
# Files of what the deck may not have: sections of the deck of percuss, and what they hold.
OF_SECTIONS = {"RWFORC": (("walls",), "rigid wall"), "DEFORC": (("springs", "turn_springs"), "spring"),
               "JNTFORC": (("joints",), "joint"), "SWFORC": (("welds",), "weld")}


def read_database(deck: KeywordDeck, card: Card) -> None:
    """Intervals of fields and history."""
    deck.output.place = card.place
    name = card.keyword.removeprefix("DATABASE_")
    if name == "BINARY_D3PLOT":
        read_frames(deck, card)
    elif name in ASCII:
        row = card.reader().row("DT BINARY~output LCUR~output IOOPT~output=1")
        step = row.number("DT")
        deck.output.asked[name] = card.place
        if step > 0:
            deck.output.rows = min(deck.output.rows or step, step)
        elif row.integer("LCUR"):
            deck.ledger.approximated(f"{card.keyword}.LCUR", card.place,
                                     "an interval that varies in time: the shortest of the others, "
                                     "or a thousandth of the run")
    elif name == "CROSS_SECTION_SET":
        read_section(deck, card)
    elif name.startswith("HISTORY_"):
        read_points(deck, card, name.removeprefix("HISTORY_"))
    else:
        deck.ledger.ignored(card.keyword, card.place, "output")


def read_sensor(deck: KeywordDeck, card: Card) -> None:
    deck.sensors.append(card)


def finish_sensors(deck: KeywordDeck) -> None:
    """A sensor that nothing listens to is output."""
    acts = any(not card.keyword.startswith("SENSOR_DEFINE_") for card in deck.sensors)
    for card in deck.sensors:
        if acts:
            deck.ledger.refuse(card.keyword, card.place, "sensors that switch something", "they switch nothing")
        else:
            deck.ledger.ignored(card.keyword, card.place, "a sensor that switches nothing")


def read_frames(deck: KeywordDeck, card: Card) -> None:
    reader = card.reader()
    row, more = reader.row("DT LCDT~output BEAM~output NPLTC PSETID~output"), reader.row("IOOPT~output")
    count, step = row.integer("NPLTC"), row.number("DT")
    if count > 0 and deck.end_time > 0:
        step = deck.end_time / count
    if step > 0:
        deck.output.frames = max(step, deck.end_time / MOST_FRAMES)
        if deck.output.frames > step:
            deck.ledger.approximated(f"{card.keyword}.DT", row.place, f"{MOST_FRAMES} frames at most")
    more.finish(deck.ledger)
    deck.ledger.translated(card.keyword, card.place, "output.fields.every")


def read_section(deck: KeywordDeck, card: Card) -> None:
    """A section by sets: the force of elements on nodes."""
    reader = card.reader()
    wish = reader.row("CSID~label TITLE~label", (10, 70)).text("TITLE") if card.has_id else ""
    row = reader.row("NSID HSID BSID SSID TSID DSID ID ITYPE")
    if row.integer("BSID") or row.integer("TSID") or row.integer("DSID"):
        deck.ledger.ignored(card.keyword, card.place, "a section through beams, thick shells or discrete elements, "
                                                      "which percuss has by planes alone")
        return
    kinds = [(kind, row.integer(field)) for kind, field in (("SOLID", "HSID"), ("SHELL", "SSID"))]
    elements = [deck.element_set_name(kind, id, card.place) for kind, id in kinds if id]
    nodes = deck.node_set_name(row.integer("NSID"), card.place)
    known = [name for name in elements if name]
    if not nodes or not known:
        deck.ledger.ignored(card.keyword, card.place, "a section without elements or nodes")
        return
    name = deck.model.names.take(wish or f"section_{row.integer('NSID')}")
    deck.sections_by_sets.append({"name": name, "section": {"nodes": nodes, "elements": known}})
    text = "output.history.forces, moments about the mean of the nodes at time 0"
    if row.integer("ID"):
        deck.ledger.approximated(card.keyword, card.place, text + "; along global axes")
    else:
        deck.ledger.translated(card.keyword, card.place, text)


def add_planes(deck: KeywordDeck) -> None:
    """Sections by planes: an entry where the plane cuts one part or all of them, else one for each part."""
    for plane in deck.planes.values():
        parts = deck.list_members("PART", plane.parts, plane.place) if plane.parts else list(deck.parts)
        cut = [block for block in deck.model.blocks if is_cut(deck, block, plane)]
        asked = [block for block in cut if block.part in parts]
        if plane.parts:
            deck.used.add(("PART", plane.parts))
        if not asked:
            deck.ledger.ignored(plane.card, plane.place, "a plane that cuts no element")
            continue
        if plane.is_limited:
            add_limited_plane(deck, plane, asked)
            continue
        section: dict[str, Any] = {"point": list(plane.point), "normal": list(plane.normal)}
        names: list[str | None] = [None] if len(asked) == len(cut) else [block.name for block in asked]
        for part in names:
            name = deck.model.names.take(plane.title if part is None else f"{plane.title}_{part}")
            deck.sections_by_sets.append({"name": name,
                                          "section": section if part is None else {"part": part, **section}})
        text = "output.history.forces of a section"
        if len(names) > 1:
            deck.ledger.approximated(plane.card, plane.place, text + "; one for each part that it cuts")
        elif plane.is_local:
            deck.ledger.approximated(plane.card, plane.place, text + "; along global axes")
        else:
            deck.ledger.translated(plane.card, plane.place, text)


def add_limited_plane(deck: KeywordDeck, plane: Plane, blocks: list[Block]) -> None:
    """A section by sets: the elements that the plane cuts within its limits, and their nodes behind it."""
    cut: dict[str, list[int]] = {"SOLID": [], "SHELL": []}
    behind, others = set[int](), 0
    for block in blocks:
        for id, corners in block.elements():
            heights = {node: dot(subtract(deck.nodes[node], plane.point), plane.normal) for node in corners}
            middle = make_vector(sum(deck.nodes[node][d] for node in corners) / len(corners) for d in range(3))
            if not min(heights.values()) < 0 < max(heights.values()) or not plane.holds(middle):
                continue
            if block.beams:
                others += 1
                continue
            cut["SOLID" if block.solids else "SHELL"].append(id)
            behind |= {node for node, height in heights.items() if height < 0}
    if not behind or others:
        text = ("a plane with limits that cuts beams, which percuss has by planes without limits" if others
                else "a plane that cuts no element within its limits")
        deck.ledger.ignored(plane.card, plane.place, f"{text}: it is not written")
        return
    names = [deck.model.names.take(f"{plane.title}_elements") for ids in cut.values() if ids]
    deck.model.element_sets |= dict(zip(names, [(kind, sorted(ids)) for kind, ids in cut.items() if ids]))
    nodes = deck.model.add_node_set(f"{plane.title}_nodes", behind)
    section = {"name": deck.model.names.take(plane.title), "section": {"nodes": nodes, "elements": names},
               "about": list(plane.point)}
    deck.sections_by_sets.append(section)
    deck.ledger.approximated(plane.card, plane.place, "output.history.forces of the elements that the plane cuts at "
                                                      "time 0, whose middle lies within its limits; along global axes")


def is_cut(deck: KeywordDeck, block: Block, plane: Plane) -> bool:
    """Whether an element has corners on both sides."""
    heights: dict[int, float] = {}
    for _, corners in block.elements():
        for node in corners:
            if node not in heights:
                heights[node] = dot(subtract(deck.nodes[node], plane.point), plane.normal)
    return any(min(heights[n] for n in corners) < 0 < max(heights[n] for n in corners)
               for _, corners in block.elements())


def read_points(deck: KeywordDeck, card: Card, name: str) -> None:
    """Nodes and elements to follow, by ids or by sets."""
    kind, deck.output.history_place = name.split("_")[0], card.place
    if kind == "DISCRETE":
        deck.ledger.ignored(card.keyword, card.place, "the history has the force of each spring")
        return
    if kind not in ("NODE", "SHELL", "SOLID", "BEAM"):
        deck.ledger.ignored(card.keyword, card.place, "output of what percuss does not have")
        return
    if "LOCAL" in name:
        deck.ledger.approximated(card.keyword, card.place, "output.history.nodes, along global axes")
        if not card.has_id:
            ids = [card.row(line, "ID CID~output REF~output HFO~output").integer("ID")
                   for line in card.lines if line[1].strip()]
            if "SET" in name:
                ids = [member for id in ids for member in deck.list_members(kind, id, card.place)]
            deck.output.nodes.extend(ids)
            return
    if card.has_id:
        ids = [card.row(line, "ID TITLE", (10, 70)).integer("ID") for line in card.lines if line[1].strip()]
    else:
        ids = read_ids(card.reader())
    if kind in ("SHELL", "BEAM") and "SET" not in name:
        shift = deck.shell_shift if kind == "SHELL" else deck.beam_shift
        ids = [id + shift for id in ids]
    if "SET" in name:
        ids = [member for id in ids for member in deck.list_members(kind, id, card.place)]
    (deck.output.nodes if kind == "NODE" else deck.output.elements).extend(ids)
    deck.ledger.translated(card.keyword, card.place, "output.history.nodes, elements")


def read_accelerometers(deck: KeywordDeck, card: Card) -> None:
    """*ELEMENT_SEATBELT_ACCELEROMETER: a node, and the axes of three. What is measured needs no element."""
    reader = card.reader()
    while reader.skip_blank():
        row = reader.row("SBACID NID1 NID2 NID3 IGRAV INTOPT MASS")
        nodes = [row.integer(field) for field in ("NID1", "NID2", "NID3")]
        gravity, way, mass = row.integer("IGRAV"), row.integer("INTOPT"), row.number("MASS")
        if gravity not in (0, 1):
            deck.ledger.refuse(f"{card.keyword}.IGRAV", row.place,
                               "gravity that is removed by direction or curve", "it is kept")
        if way:
            text = "output.history.accelerometers"
            deck.ledger.translated(card.keyword, row.place, text)
        else:
            text = "output.history.accelerometers; the velocity change is that along the moving axes, as of INTOPT = 1"
            deck.ledger.approximated(card.keyword, row.place, text)
        if mass:  # in equal shares
            deck.masses += [(node, mass / 3, row.place) for node in nodes]
        deck.output.accelerometers.append((row.integer("SBACID"), nodes, gravity == 1, row.place))


def add_accelerometers(deck: KeywordDeck, history: Deck) -> None:
    """Their nodes are followed, too."""
    used, found = deck.used_nodes(), []
    followed = {entry["id"]: entry["name"] for entry in history.get("nodes", [])}
    for id, nodes, no_gravity, place in deck.output.accelerometers:
        if len(set(nodes)) < 3 or not used.issuperset(nodes):
            deck.ledger.refuse("ELEMENT_SEATBELT_ACCELEROMETER.nodes", place,
                               "nodes without elements, or twice", "it is left out")
            continue
        for node in nodes:
            if node not in followed:
                followed[node] = f"node_{node}"
                history.setdefault("nodes", []).append({"name": followed[node], "id": node})
        one: Deck = {"name": deck.model.names.take(f"accelerometer_{id}"), "nodes": [followed[node] for node in nodes]}
        found.append(one | ({"gravity": "remove"} if no_gravity else {}))
    if found:
        history["accelerometers"] = found


def finish_output(deck: KeywordDeck) -> None:
    """The section of output."""
    output: Deck = {}
    found = deck.output
    if found.frames > 0:
        plastic = any(laws.has(law, "has_plastic_strain") for law in deck.model.materials.values())
        output["fields"] = {"every": found.frames, "write": FIELDS + (["equivalent_plastic_strain"] if plastic else [])}
    welds = list_spot_welds(deck) if "SWFORC" in found.asked else []
    found.elements += welds
    history: Deck = {"every": found.rows or float(f"{deck.end_time / 1000:.6g}")}
    add_points(deck, history)
    add_accelerometers(deck, history)
    if "MATSUM" in found.asked:
        history["parts"] = "all"
    pairs = pair_forces(deck) if "RCFORC" in found.asked else []
    note_files(deck, bool(pairs or deck.forces), bool(welds))
    limited = list(deck.forces)
    if "RWFORC" in found.asked:
        limited += [{"name": f"force_{wall['name']}", "wall": wall["name"]}
                    for wall in deck.model.deck.get("walls", [])]
    limited += pairs
    if len(limited) > MOST_FORCES:
        card = next((f"DATABASE_{name}" for name in ("RCFORC", "RWFORC") if name in found.asked),
                    "CONTACT_FORCE_TRANSDUCER")
        deck.ledger.approximated(f"{card}.most", found.asked.get(card.removeprefix("DATABASE_"), found.place),
                                 f"the first {MOST_FORCES} of {len(limited)} forces of contact and walls")
    forces = limited[:MOST_FORCES]
    forces += list_supports(deck)
    add_planes(deck)
    forces += deck.sections_by_sets
    if forces:
        history["forces"] = forces
    output["history"] = history
    deck.model.deck["output"] = output


def list_spot_welds(deck: KeywordDeck) -> list[int]:
    """Beams of *MAT_SPOTWELD. Solids of it have no force in the history."""
    blocks = [block for block in deck.model.blocks
              if deck.materials[deck.parts[block.part].material].keyword.startswith("MAT_SPOTWELD")]
    if any(block.solids for block in blocks):
        deck.ledger.ignored("DATABASE_SWFORC.solids", deck.output.asked["SWFORC"],
                            "forces of spot welds of solids are not written")
    return [id for block in blocks for id, _ in block.beams]


def note_files(deck: KeywordDeck, has_pairs: bool, has_weld_beams: bool) -> None:
    """What becomes of each file with columns of the history. has_pairs: forces of contact are written.
    has_weld_beams: spot welds are followed."""
    for name, place in deck.output.asked.items():
        sections, what = OF_SECTIONS.get(name, ((), ""))
        if name == "SWFORC" and has_weld_beams:
            deck.ledger.translated("DATABASE_SWFORC", place, "output.history.elements: axial_force, "
                                                             "shear_y and shear_z of each beam that is a spot weld")
        elif sections and not any(deck.model.deck.get(section) for section in sections):
            deck.ledger.ignored(f"DATABASE_{name}", place, f"the model has no {what}, so no force is written")
        elif name == "RCFORC" and not has_pairs:
            deck.ledger.ignored(f"DATABASE_{name}", place, describe_no_pair(deck))
        else:
            deck.ledger.translated(f"DATABASE_{name}", place,
                                   f"output.history, all at the shortest interval: {ASCII[name]}")


def describe_no_pair(deck: KeywordDeck) -> str:
    """Why no force of contact is written."""
    if not deck.contacts:
        return ("the model has no contact but ties, so no force of contact is written" if "contact" in deck.model.deck
                else "the model has no contact, so no force is written")
    return ("no force of contact is written: a surface with itself, or with everything, has no two sides "
            "(*CONTACT_FORCE_TRANSDUCER, or contact of two parts, gives a force)")


def list_supports(deck: KeywordDeck) -> list[Deck]:
    """SPCFORC: the force on held nodes that nothing drives. BNDOUT: on driven nodes, and on each driven rigid body."""
    asked, rigid = deck.output.asked, list_rigid_nodes(deck)
    held, driven, bodies = set[int](), set[int](), dict[str, None]()
    for entry in deck.model.deck.get("conditions", []):
        nodes = nodes_of_name(deck, entry["nodes"]) if "nodes" in entry else set()
        if "fixed" in entry or "symmetry" in entry:
            held |= nodes - rigid
            continue
        driven |= nodes - rigid
        of_nodes = {deck.bodies_of_nodes[node] for node in nodes & rigid if node in deck.bodies_of_nodes}
        bodies.update(dict.fromkeys([entry["body"]] if "body" in entry else sorted(of_nodes)))
    forces: list[Deck] = []
    if "SPCFORC" in asked:
        if held - driven:
            is_all = not driven and not rigid
            forces.append({"name": "supports",
                           "support": "all" if is_all else deck.model.add_node_set("supports", held - driven)})
        if not held - driven or held & driven:
            text = (f"without the {len(held & driven)} held nodes that are driven in another direction: BNDOUT has "
                    "these" if held - driven else "no node is held but those that are driven, or of rigid bodies")
            deck.ledger.ignored("DATABASE_SPCFORC.supports", asked["SPCFORC"], text)
    if "BNDOUT" in asked:
        forces += [{"name": "driven", "support": deck.model.add_node_set("driven", driven)}] if driven else []
        forces += [{"name": f"driven_{body}", "support": name}
                   for body in list(bodies)[:MOST_FORCES] if (name := name_body_nodes(deck, body))]
        if not driven and not bodies:
            deck.ledger.ignored("DATABASE_BNDOUT.motions", asked["BNDOUT"], "no node and no rigid body is driven")
    return forces


def name_body_nodes(deck: KeywordDeck, body: str) -> str:
    """The set of all nodes of a rigid body; empty: it has none in the mesh."""
    nodes = {node for node, name in deck.bodies_of_nodes.items() if name == body} & deck.used_nodes()
    return deck.model.add_node_set(f"driven_{body}", nodes) if nodes else ""


def nodes_of_name(deck: KeywordDeck, selector: "str | Deck") -> set[int]:
    """Nodes of a selector; of one with limits those of what it limits."""
    name = selector if isinstance(selector, str) else selector.get("name", "all")
    if name in deck.model.node_sets:
        return set(deck.model.node_sets[name])
    if name in deck.model.block_sets:
        return deck.model.nodes_of_blocks(deck.model.block_sets[name])
    found = deck.model.nodes_of_blocks(block.id for block in deck.model.blocks if block.name == name)
    return found or deck.used_nodes()


def pair_forces(deck: KeywordDeck) -> list[Deck]:
    """Forces of pairs of parts and surfaces."""
    names = {block.name for block in deck.model.blocks} | set(deck.model.block_sets)
    names |= set(deck.model.side_sets) | set(deck.model.element_sets)
    members = {name: [b.name for b in deck.model.blocks if b.id in ids] for name, ids in deck.model.block_sets.items()}
    forces = []
    for contact in deck.contacts:
        a, b = contact["a"], contact["b"]
        if a in names and b in names and a != b and not set(members.get(a, [a])) & set(members.get(b, [b])):
            name = deck.model.names.take(f"force_{contact['title'] or a}")
            forces.append({"name": name, "contact": [members.get(a, a), members.get(b, b)]})
    return forces


def add_points(deck: KeywordDeck, history: Deck) -> None:
    """Followed nodes and elements, by the user's ids."""
    used = deck.used_nodes()
    written = {id for block in deck.model.blocks for id, _ in block.elements()}
    for key, ids, known in (("nodes", deck.output.nodes, used), ("elements", deck.output.elements, written)):
        wanted = list(dict.fromkeys(ids))
        kept = [id for id in wanted if id in known]
        if len(kept) < len(wanted):
            deck.ledger.ignored(f"DATABASE_HISTORY.{key}", deck.output.history_place,
                                f"{len(wanted) - len(kept)} {key} to follow that no element of the model has")
        if len(kept) > MOST_POINTS:
            deck.ledger.approximated(f"DATABASE_HISTORY.{key}", deck.output.history_place,
                                     f"the first {MOST_POINTS} of {len(kept)} {key} to follow")
            kept = kept[:MOST_POINTS]
        if kept:
            history[key] = [{"name": f"{key[:-1]}_{id}", "id": id} for id in kept]
