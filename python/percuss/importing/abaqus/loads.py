"""*CLOAD, *DLOAD, *DSLOAD: forces, pressures and gravity, in each step."""

from collections.abc import Callable
from typing import Any

from ..fields import clip
from ..ledger import BadInput, Place
from ..model import Deck
from .axisymmetric import SHARE, refuse_in_ring, share_force
from .conditions import refuse_other_axes
from .deck import AXES, AbaqusDeck, Following
from .followers import list_leaders
from .lines import Block, Line
from .planes import list_edges, write_traction
from .timeline import LOAD, Action, join_loads, values_of

LEFT_OUT, ENDS = "it is left out", "OP=NEW ends what acted before"
BODY_FORCES = {"BX": 0, "BY": 1, "BZ": 2}

Writer = Callable[[float | Deck], None]  # of a load, by its values over the run


def renew(deck: AbaqusDeck, block: Block) -> None:
    """OP=NEW ends the loads of this kind of the steps before."""
    if block.option("OP") == "NEW" and (block.keyword, block.step) not in deck.renewed:
        deck.loads.stop([target for target in deck.loads.windows if target[0] == block.keyword],
                        deck.step_of(block).start)
        deck.renewed.add((block.keyword, block.step))
    if block.option("OP") == "NEW" and not block.lines:
        deck.ledger.translated(block.keyword, block.place, ENDS)


def act(deck: AbaqusDeck, block: Block, line: Line, key: tuple[Any, ...], value: float, emit: Writer) -> None:
    """Lets a load act from this step on, in place of the same load of a step before; several of one step add up."""
    place = block.at(line[0])
    points = deck.values_in_step(block, place, value)
    if points is None:
        return
    start = deck.step_of(block).start
    number = 0
    while any(window.start == start for window in deck.loads.windows.get((block.keyword, *key, number), [])):
        number += 1
    target = (block.keyword, *key, number)
    deck.keywords_of_lines[place] = block.keyword
    deck.loads.act(target, Action(LOAD, start, tuple(points), place))
    deck.load_writers.setdefault(target, emit)


def finish_loads(deck: AbaqusDeck) -> None:
    """Each load with its values over the run."""
    for target, emit in deck.load_writers.items():
        windows = deck.loads.windows.get(target)
        if windows:
            place = windows[0].action.place
            emit(values_of(join_loads(windows, deck.end_time), place, deck.end_time))


def list_loads(deck: AbaqusDeck, kind: str) -> list[Deck]:
    loads: list[Deck] = deck.model.deck.setdefault("loads", {}).setdefault(kind, [])
    return loads


def read_node_force(deck: AbaqusDeck, block: Block) -> None:
    """*CLOAD: node or set, dof, magnitude."""
    renew(deck, block)
    if "FOLLOWER" in block.options:
        deck.ledger.refuse("CLOAD.FOLLOWER", block.place, "follower forces", LEFT_OUT)
        return
    for line in block.lines:
        name, place, dof = block.text(line, 0), block.at(line[0]), block.integer(line, 1)
        nodes = deck.nodes_of(name, place)
        if not 1 <= dof <= 6:
            deck.ledger.refuse("CLOAD.dof", place, f"a load on direction {dof} of '{clip(name)}'", LEFT_OUT)
            continue
        refuse_other_axes(deck, nodes, place)
        refs = [node for node in nodes if node in deck.group_of_ref]
        free = [node for node in nodes if node not in deck.group_of_ref]
        used = [node for node in free if node in deck.used_nodes()]
        share = SHARE if deck.is_ring else 1.0
        leaders = list_leaders(deck)
        for leader in [node for node in free if node in leaders]:
            act(deck, block, line, (f"node {leader}", dof), share * block.number(line, 2),
                write_led_load(deck, leaders[leader], dof, place))
        if len(used) < len([node for node in free if node not in leaders]):
            deck.ledger.refuse("CLOAD.free", place,
                               f"a load on nodes without elements ('{clip(name)}')", "these have no load")
        for ref in refs:
            act(deck, block, line, (f"node {ref}", dof), share * block.number(line, 2),
                write_body_load(deck, ref, dof, place))
        if used and deck.is_ring:
            if dof > 2:
                deck.ledger.refuse("CLOAD.dof", place, f"a load on direction {dof} of axisymmetric elements", LEFT_OUT)
            for number, (group, direction, factor) in enumerate(share_force(deck, used, dof)):
                act(deck, block, line, (name.upper(), dof, number), factor * block.number(line, 2),
                    write_ring_load(deck, name, group, direction, place))
        elif used:
            share = 0.5 if any(node in deck.twins for node in used) else 1.0  # of both planes of plane strain
            act(deck, block, line, (name.upper(), dof), share * block.number(line, 2),
                write_node_load(deck, name, used, dof, place))


def write_node_load(deck: AbaqusDeck, name: str, nodes: list[int], dof: int, place: Place) -> Writer:
    def write(value: "float | Deck") -> None:
        if dof > 3 and not set(nodes) <= deck.model.turning_nodes():
            deck.ledger.refuse("CLOAD.moment", place,
                               f"a moment on nodes that have no rotations ('{clip(name)}')", LEFT_OUT)
            return
        kind = "force" if dof <= 3 else "moment"
        given = deck.node_set_name(name, place)
        list_loads(deck, "nodal").append({"nodes": given, kind: {AXES[(dof - 1) % 3]: value}})
        deck.ledger.translated("CLOAD", place, "loads.nodal")

    return write


def write_ring_load(deck: AbaqusDeck, name: str, nodes: list[int], direction: str, place: Place) -> Writer:
    def write(value: "float | Deck") -> None:
        list_loads(deck, "nodal").append({"nodes": deck.model.add_node_set(name, nodes), "force": {direction: value}})
        deck.ledger.translated("CLOAD", place, "loads.nodal: the share of the sector in the force on the ring")

    return write


def write_led_load(deck: AbaqusDeck, following: Following, dof: int, place: Place) -> Writer:
    """A force on a node without elements acts on those that move equally with it: on one of them."""

    def write(value: "float | Deck") -> None:
        if (AXES[dof - 1] not in following.ways[:3] or dof > 3
                or (following.nodes[0], AXES[dof - 1]) in deck.motions.windows):
            deck.ledger.refuse("CLOAD.led", place, "a load on a node without elements, "
                                                   "along a direction in which no nodes move with it freely", LEFT_OUT)
            return
        name = deck.model.add_node_set("led", following.nodes[:1])
        list_loads(deck, "nodal").append({"nodes": name, "force": {AXES[dof - 1]: value}})
        deck.ledger.translated("CLOAD", place, "loads.nodal of one of the nodes that have the same motion")

    return write


def write_body_load(deck: AbaqusDeck, ref: int, dof: int, place: Place) -> Writer:
    def write(value: "float | Deck") -> None:
        group = deck.group_of_ref[ref]
        if not group.name:
            deck.ledger.refuse("CLOAD.wall", place,
                               "a load on an analytical surface that is held or moved", "it has no effect")
            return
        kind = "force" if dof <= 3 else "moment"
        at = {"at": list(deck.mesh.nodes[ref])} if dof <= 3 and not group.moves_ref else {}
        list_loads(deck, "nodal").append({"body": group.name, **at, kind: {AXES[(dof - 1) % 3]: value}})
        deck.ledger.translated("CLOAD", place, "loads.nodal on a body, at its reference node")

    return write


def read_distributed(deck: AbaqusDeck, block: Block) -> None:
    """*DLOAD of elements, *DSLOAD of surfaces."""
    renew(deck, block)
    for line in block.lines:
        label = block.text(line, 1).upper()
        if label == "GRAV":
            read_gravity(deck, block, line)
        elif block.keyword == "DSLOAD" and label in ("P", "TRVEC"):
            read_surface_load(deck, block, line, label)
        elif block.keyword == "DLOAD" and label[:1] == "P" and label[1:] in ("", "1", "2", "3", "4", "5", "6"):
            read_element_pressure(deck, block, line, label)
        elif block.keyword == "DLOAD" and label[:5] == "TRVEC" and label[5:] in ("", "1", "2", "3", "4", "5", "6"):
            read_element_pressure(deck, block, line, "P" + label[5:], read_direction(deck, block, line))
        elif block.keyword == "DLOAD" and label in BODY_FORCES:
            read_body_force(deck, block, line, BODY_FORCES[label])
        else:
            key = f"{block.keyword}.{clip(label) or 'blank'}"
            deck.ledger.refuse(key, block.at(line[0]), f"a distributed load {clip(label)}", LEFT_OUT)


def covers_all(deck: AbaqusDeck, name: str, place: Place) -> bool:
    """Whether a load on elements is one on the whole mesh."""
    if not name:
        return True
    ids = set(deck.elements_of(name, place))
    return all(id in ids for block in deck.model.blocks for id, _ in block.elements())


def add_gravity(deck: AbaqusDeck, block: Block, line: Line, size: float, axis: list[float], what: str) -> None:
    def write_one(direction: int) -> Writer:
        def write(value: "float | Deck") -> None:
            gravity = deck.model.deck.setdefault("loads", {}).setdefault("gravity", [0.0, 0.0, 0.0])
            if isinstance(gravity[direction], dict) or isinstance(value, dict) and gravity[direction] != 0:
                raise BadInput(block.at(line[0]),
                               "two accelerations along one axis, of which one changes (percuss has one): add them up")
            gravity[direction] = value if isinstance(value, dict) else gravity[direction] + value
            deck.ledger.translated(block.keyword, block.at(line[0]), what)

        return write

    for direction in range(3):
        if axis[direction] and direction != 1:
            refuse_in_ring(deck, f"{block.keyword}.axis", block.at(line[0]), "an acceleration across the axis")
        if axis[direction]:
            key = (block.text(line, 1).upper(), block.text(line, 0).upper(), direction)
            act(deck, block, line, key, size * axis[direction], write_one(direction))


def read_gravity(deck: AbaqusDeck, block: Block, line: Line) -> None:
    """Acceleration and its direction."""
    axis = [block.number(line, i) for i in (3, 4, 5)]
    length = sum(a * a for a in axis) ** 0.5
    if length <= 0:
        raise BadInput(block.at(line[0]), "the direction of gravity is zero: correct it")
    if not covers_all(deck, block.text(line, 0), block.at(line[0])):
        deck.ledger.refuse("DLOAD.GRAV", block.at(line[0]), "gravity on some of the elements", "it acts on all of them")
    note_gravity(deck, block, block.text(line, 0).upper(), [a / length for a in axis], block.at(line[0]))
    add_gravity(deck, block, line, block.number(line, 2), [a / length for a in axis], "loads.gravity")
    if block.text(line, 0):
        spare_masses(deck, block, line, [block.number(line, 2) * a / length for a in axis])


def spare_masses(deck: AbaqusDeck, block: Block, line: Line, acceleration: list[float]) -> None:
    """Gravity of percuss pulls at each mass.
    Loads hold up the point masses that are not among the elements of the card."""
    inside = set(deck.elements_of(block.text(line, 0), block.at(line[0])))
    for name, mass, place in deck.mesh.masses:
        nodes = [deck.mesh.elements[id][1][0]
                 for id in deck.elements_of(name, place) if id not in inside and deck.mesh.elements[id][1]]
        for node in (node for node in nodes if node in deck.used_nodes() or node in deck.group_of_ref):
            for dof in (dof for dof in (1, 2, 3) if acceleration[dof - 1] and mass):
                write = (write_body_load(deck, node, dof, block.at(line[0])) if node in deck.group_of_ref
                         else write_mass_load(deck, node, dof, block.at(line[0])))
                act(deck, block, line, ("mass", block.text(line, 0).upper(), name, node, dof),
                    -mass * acceleration[dof - 1], write)


def write_mass_load(deck: AbaqusDeck, node: int, dof: int, place: Place) -> Writer:
    def write(value: "float | Deck") -> None:
        list_loads(deck, "nodal").append({"nodes": deck.model.add_node_set(f"mass_{node}", [node]),
                                          "force": {AXES[dof - 1]: value}})
        deck.ledger.translated("DLOAD", place,
                               "loads.nodal against the gravity on a mass that is not among the elements of the card")

    return write


def note_gravity(deck: AbaqusDeck, block: Block, name: str, axis: list[float], place: Place) -> None:
    """Without OP=NEW a gravity modifies that of a step before:
    along another direction it is not said what becomes of the latter."""
    step, before = deck.gravities.get(name, (block.step, axis))
    is_renewed = any(("DLOAD", later) in deck.renewed for later in range(step + 1, block.step + 1))
    pairs = zip(axis, before[1:] + before[:1], axis[1:] + axis[:1], before)
    if step < block.step and not is_renewed and max(abs(a * b - c * d) for a, b, c, d in pairs) > 1e-9:
        text = "gravity along another direction than in a step before, without OP=NEW, which would end that"
        deck.ledger.refuse("DLOAD.GRAV", place, text, "both act")
    deck.gravities[name] = (block.step, axis)


def read_body_force(deck: AbaqusDeck, block: Block, line: Line, direction: int) -> None:
    """A force per volume: of one density it is an acceleration."""
    densities = {part.density for part in deck.model.blocks}
    if not covers_all(deck, block.text(line, 0), block.at(line[0])) or len(densities) != 1 or deck.mesh.masses:
        text = "a force per volume on some of the elements, or on several densities or masses"
        deck.ledger.refuse(f"DLOAD.{block.text(line, 1).upper()}", block.at(line[0]), text, LEFT_OUT)
        return
    axis = [float(d == direction) for d in range(3)]
    add_gravity(deck, block, line, block.number(line, 2) / densities.pop(), axis,
                "loads.gravity: the force per volume over the density")


def read_direction(deck: AbaqusDeck, block: Block, line: Line) -> list[float]:
    """Direction of a traction, which percuss lets act on the area at the start."""
    direction = [block.number(line, i) for i in (3, 4, 5)]
    if not any(direction):
        raise BadInput(block.at(line[0]), "the direction of the traction is zero: correct it")
    refuse_in_ring(deck, f"{block.keyword}.TRVEC", block.at(line[0]), "a traction on faces")
    if block.option("FOLLOWER") != "NO":
        deck.ledger.approximated(f"{block.keyword}.TRVEC", block.at(line[0]),
                                 "a traction in a fixed direction: it does not turn with its surface")
    if block.option("CONSTANT RESULTANT") != "YES":
        deck.ledger.approximated(f"{block.keyword}.CONSTANT RESULTANT", block.at(line[0]),
                                 "a traction acts on the area at the start")
    return direction


def read_element_pressure(deck: AbaqusDeck, block: Block, line: Line, label: str,
                          direction: list[float] | None = None) -> None:
    """P of shells pushes along their normal, P1 to P6 of solids into the face; with a direction it is a traction."""
    place = block.at(line[0])
    name = deck.add_faces(block.text(line, 0), label, place)
    if not name:
        deck.ledger.refuse(f"DLOAD.{clip(label)}", place, "a pressure on elements without such a face", LEFT_OUT)
        return
    add_pressure(deck, block, line, name, direction)


def read_surface_load(deck: AbaqusDeck, block: Block, line: Line, label: str) -> None:
    place = block.at(line[0])
    areas = list_edges(deck, block.text(line, 0), place)
    if areas is not None:
        read_edge_load(deck, block, line, areas)
        return
    name = deck.surface_name(block.text(line, 0), place, of_contact=False)
    if not name:
        deck.ledger.ignored(block.keyword, place, "its surface has no element")
        return
    add_pressure(deck, block, line, name, read_direction(deck, block, line) if label == "TRVEC" else None)


def read_edge_load(deck: AbaqusDeck, block: Block, line: Line, areas: dict[int, float]) -> None:
    """Reads a load on edges of plane elements, with the area at each node."""
    label, place = block.text(line, 1).upper(), block.at(line[0])
    if label != "TRVEC":
        deck.ledger.refuse("DSLOAD.plane", place,
                           "a pressure on edges of plane elements, which turns with them", LEFT_OUT)
        return
    name = f"edge_{block.text(line, 0).rpartition('.')[2]}"
    writer = write_traction(
        deck, name, areas, read_direction(deck, block, line),
        lambda: deck.ledger.translated(block.keyword, place, "loads.nodal of the nodes of edges"))
    act(deck, block, line, (label, block.text(line, 0).upper()), block.number(line, 2), writer)


def add_pressure(deck: AbaqusDeck, block: Block, line: Line, name: str, direction: list[float] | None) -> None:
    def write(value: "float | Deck") -> None:
        entry: Deck = {"faces": name, "value": value}
        if direction:
            entry["direction"] = direction
        list_loads(deck, "pressure").append(entry)
        deck.ledger.translated(block.keyword, block.at(line[0]), "loads.pressure")

    act(deck, block, line, (block.text(line, 1).upper(), block.text(line, 0).upper()), block.number(line, 2), write)
