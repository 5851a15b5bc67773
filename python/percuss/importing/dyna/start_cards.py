"""*INITIAL_VELOCITY...: velocities at time 0."""

from ..fields import Row
from ..ledger import Place
from ..model import Deck, Vector
from ..shapes import cross, normalise, subtract
from .bodies import find_body_name, find_lead
from .cards import Card
from .deck import KeywordDeck
from .materials.shared import NEVER


def add_velocity(deck: KeywordDeck, name: str, motion: Deck) -> None:
    """An entry of `initial`; an empty name means all."""
    deck.model.add("initial", {"nodes": name, **motion} if name else motion)


def turn_vector(deck: KeywordDeck, row: Row, vector: list[float]) -> list[float]:
    """A vector of the system ICID in the axes of space."""
    id = row.integer("ICID")
    if not id or not any(vector):
        return vector
    if id not in deck.systems:
        deck.ledger.refuse(f"{row.card}.ICID", row.place, f"the coordinate system {id}, which is not read",
                           "the axes of space are used")
        return vector
    axes = deck.systems[id]
    return [sum(vector[i] * axes[i][d] for i in range(3)) for d in range(3)]


def read_initial_velocity(deck: KeywordDeck, card: Card) -> None:
    """*INITIAL_VELOCITY: a node set, or all nodes, but those exempted."""
    reader = card.reader()
    while reader.next_card(of_lines=True):
        row = reader.row("NSID NSIDEX BOXID IRIGID ICID")
        motion = reader.row("VX VY VZ VXR VYR VZR")
        exempt = reader.row("VXE VYE VZE VXRE VYRE VZRE") if row.integer("NSIDEX") else None
        apply_initial_velocity(deck, card, row, motion, exempt)


def apply_initial_velocity(deck: KeywordDeck, card: Card, row: Row, motion: Row, exempt: Row | None) -> None:
    velocity = turn_vector(deck, row, motion.numbers("VX", "VY", "VZ"))
    id, box = row.integer("NSID"), row.integer("BOXID")
    name: str | None = deck.node_set_name(id, row.place) if id else ""
    if box:
        inside = set(deck.nodes_of_box(box, row.place))
        members = deck.list_members("NODE", id, row.place) if id else list(deck.nodes)
        name = deck.make_node_set(f"box_{box}", [node for node in members if node in inside], row.place) or None
    overwrite_bodies(deck, row, motion, velocity, box)
    motion.finish(deck.ledger, "nodes do not turn at the start")
    row.finish(deck.ledger)
    if name is None:
        deck.ledger.ignored(card.keyword, row.place, "it names nodes without elements alone, which have no mass")
        return
    add_velocity(deck, name, {"velocity": velocity})
    if exempt:
        other = deck.node_set_name(row.integer("NSIDEX"), row.place)
        if other:
            add_velocity(deck, other, {"velocity": turn_vector(deck, row, exempt.numbers("VXE", "VYE", "VZE"))})
        exempt.finish(deck.ledger, "nodes do not turn at the start")
    deck.ledger.translated(card.keyword, row.place, "initial: velocity")


def overwrite_bodies(deck: KeywordDeck, row: Row, motion: Row, velocity: list[float], box: int) -> None:
    """IRIGID: bodies whose cards with inertia give another velocity get this one. It says nothing of other bodies."""
    which, spin = (row.integer("IRIGID"),
                   turn_vector(deck, row, motion.numbers("VXR", "VYR", "VZR")) if row.integer("IRIGID") else [])
    if not which or not deck.started_bodies:
        return
    names = (set(deck.started_bodies) if which < 0
             else {deck.body_names.get(find_lead(deck, id), "") for id in deck.list_members("PART", which, row.place)})
    for name, entry in deck.started_bodies.items():
        if name not in names:
            continue
        center: Vector = tuple(deck.body_centers[name])  # type: ignore[assignment]
        if box and which != -2 and not deck.find_box(box, row.place).holds(center):
            continue
        entry |= {"velocity": velocity} | ({"angular_velocity": spin} if any(spin) else {})
        if not any(spin):
            entry.pop("angular_velocity", None)


def read_node_velocities(deck: KeywordDeck, card: Card) -> None:
    """*INITIAL_VELOCITY_NODE: gathered by velocity, since many nodes may have the same."""
    groups: dict[tuple[float, ...], list[int]] = {}
    for line in card.lines:
        if not line[1].strip():
            continue
        row = card.row(line, "NID VX VY VZ VXR VYR VZR ICID")
        groups.setdefault(tuple(turn_vector(deck, row, row.numbers("VX", "VY", "VZ"))), []).append(row.integer("NID"))
        row.finish(deck.ledger, "it is left out")
    for index, (velocity, nodes) in enumerate(groups.items(), 1):
        name = deck.make_node_set(f"moving_{index}", nodes, card.place)
        if name:
            add_velocity(deck, name, {"velocity": list(velocity)})
    deck.ledger.translated(card.keyword, card.place, "initial: velocity, a node set for each velocity")


def read_generation(deck: KeywordDeck, card: Card) -> None:
    """*INITIAL_VELOCITY_GENERATION: velocity and spin of parts or nodes."""
    reader = card.reader()
    while reader.next_card(of_lines=True):
        row = reader.row("ID STYP=1 OMEGA VX VY VZ IVATN ICID")
        axis = reader.row("XC YC ZC NX NY NZ PHASE IRIGID")
        names = find_generated(deck, row)
        motion = make_spin(deck, row, axis)
        if axis.integer("PHASE") and deck.model.deck.get("start", {}):  # else nothing deforms before time 0
            deck.ledger.refuse(f"{card.keyword}.PHASE", axis.place,
                               "PHASE is 1: velocities on the mesh that a relaxation deforms",
                               "they are those of the mesh as given")
        if axis.integer("IRIGID") or row.integer("IVATN"):
            start_constrained(deck, row, axis, motion)
        row.finish(deck.ledger)
        axis.finish(deck.ledger)
        for name in names:
            add_velocity(deck, name, motion)
        if names:
            deck.ledger.translated(card.keyword, row.place, "initial: velocity and angular_velocity")
        else:
            deck.ledger.ignored(card.keyword, row.place, "it names what has no element, and no mass")


def start_constrained(deck: KeywordDeck, row: Row, axis: Row, motion: Deck) -> None:
    """IRIGID: bodies whose cards with inertia give another velocity get this one.
    IVATN: bodies get it as a whole, with what they are merged with."""
    id, kind = row.integer("ID"), row.integer("STYP")
    if id and kind == 3:
        return
    parts = list(deck.rigid) if not id else [id] if kind == 2 else deck.list_members("PART", id, row.place)
    bodies = [name for part in parts if part in deck.rigid and (name := deck.body_names.get(find_lead(deck, part)))]
    for name in dict.fromkeys(bodies):
        if name in deck.started_bodies:
            if axis.integer("IRIGID"):
                move_center(motion, deck.body_centers[name], deck.started_bodies[name])
        elif row.integer("IVATN"):
            add_velocity(deck, deck.make_node_set(f"body_{name}", [node for node, body in deck.bodies_of_nodes.items()
                                                                   if body == name], row.place), motion)


def move_center(motion: Deck, center: list[float], entry: Deck) -> None:
    """The velocity of a mass centre in a field of velocity and spin."""
    spin, velocity = motion.get("angular_velocity", [0.0] * 3), motion["velocity"]
    turned = cross(tuple(spin), subtract(tuple(center), tuple(motion.get("center", center))))  # type: ignore[arg-type]
    entry |= {"velocity": [a + b for a, b in zip(velocity, turned, strict=True)], "angular_velocity": list(spin)}


def find_generated(deck: KeywordDeck, row: Row) -> list[str]:
    """Names of what starts to move; an empty name for all."""
    id, kind = row.integer("ID"), row.integer("STYP")
    if not id:
        return [""]
    if kind == 2:
        deck.find_part(id, row.place)
        return deck.part_names([id])
    if kind == 3:
        name = deck.node_set_name(id, row.place)
    elif kind == 1:
        return deck.part_names(deck.list_members("PART", id, row.place))
    else:
        row.fail("STYP", "1, 2 or 3 is expected")
    return [name] if name else []


def make_spin(deck: KeywordDeck, row: Row, axis: Row) -> Deck:
    """Velocity, and the spin about an axis through a point."""
    motion: Deck = {"velocity": turn_vector(deck, row, row.numbers("VX", "VY", "VZ"))}
    omega, center = row.number("OMEGA"), axis.numbers("XC", "YC", "ZC")
    direction = tuple(axis.numbers("NX", "NY", "NZ"))
    if omega:
        if direction[0] == -999:
            direction, center = direction_of_nodes(deck, axis), list(deck.nodes[axis.integer("NY")])
        else:
            direction = tuple(turn_vector(deck, row, list(direction)))
        unit = normalise(direction)  # type: ignore[arg-type]
        if unit == (0.0, 0.0, 0.0):
            axis.fail("NX", "an axis is expected")
        motion |= {"angular_velocity": [omega * n for n in unit], "center": center}
    return motion


def direction_of_nodes(deck: KeywordDeck, axis: Row) -> tuple[float, ...]:
    """NX is -999: the axis runs from node NY to node NZ."""
    first, second = axis.integer("NY"), axis.integer("NZ")
    for name, node in (("NY", first), ("NZ", second)):
        if node not in deck.nodes:
            axis.fail(name, "there is no such node")
    return subtract(deck.nodes[second], deck.nodes[first])


def read_rigid_velocity(deck: KeywordDeck, card: Card) -> None:
    """*INITIAL_VELOCITY_RIGID_BODY: velocity of the mass centre of a body, merged ones included, and spin.
    It counts more than all others."""
    for line in card.lines:
        if not line[1].strip():
            continue
        row = card.row(line, "PID VX VY VZ VXR VYR VZR ICID")
        entry: Deck = {"velocity": turn_vector(deck, row, row.numbers("VX", "VY", "VZ"))}
        spin = turn_vector(deck, row, row.numbers("VXR", "VYR", "VZR"))
        if any(spin):
            entry["angular_velocity"] = spin
        id = row.integer("PID")
        row.finish(deck.ledger)
        body = find_body_name(deck, id, row.place)
        if body:
            deck.model.add("initial", {"body": body, **entry})
            deck.ledger.translated(card.keyword, row.place, "initial: velocity and angular_velocity of the body")
        else:
            deck.ledger.refuse(card.keyword, row.place,
                               f"the velocity of part {id}, which is no rigid body with elements", "it is left out")


def read_temperature(deck: KeywordDeck, card: Card) -> None:
    """*INITIAL_TEMPERATURE_: it counts where a law depends on it."""
    if any(law.get("melt_temperature", NEVER) < NEVER for law in deck.model.materials.values()):
        deck.ledger.refuse(card.keyword, card.place, "temperatures of nodes",
                           "parts start at the room temperature of their law")
    else:
        deck.ledger.ignored(card.keyword, card.place, "no law of the deck depends on the temperature")


def add_masses(deck: KeywordDeck) -> None:
    """*ELEMENT_MASS: masses of nodes, a set for each value; of nodes without elements, on their rigid bodies."""
    groups: dict[float, list[int]] = {}
    place: Place | None = None
    used = deck.used_nodes()
    for node, mass, place in deck.masses:
        if node in used:
            groups.setdefault(mass, []).append(node)
        elif node in deck.bodies_of_nodes:
            add_body_mass(deck, node, mass, place)
        else:
            deck.ledger.refuse("ELEMENT_MASS.free", place,
                               f"a mass on node {node}, which has no element and belongs to no rigid body",
                               "it is left out")
    for index, (mass, nodes) in enumerate(groups.items(), 1):
        name = deck.make_node_set(f"mass_{index}", nodes, place)
        if mass > 0:
            deck.model.add("added_mass", {"nodes": name, "mass": len(nodes) * mass, "spread": "evenly"})
    if place:
        deck.ledger.translated("ELEMENT_MASS", place, "added_mass")


def add_body_mass(deck: KeywordDeck, node: int, mass: float, place: Place) -> None:
    """A mass at a point of a body: `rigid_sets` with a node that is of the body already."""
    body = deck.bodies_of_nodes[node]
    if mass <= 0:
        return
    if node in deck.center_nodes:
        deck.ledger.refuse("ELEMENT_MASS.PNODE", place,
                           f"a mass on node {node}, which is at the mass centre of a body that it changes",
                           "it is left out")
        return
    own = next(n for n in sorted(deck.used_nodes()) if deck.bodies_of_nodes.get(n) == body)
    name = deck.make_node_set(f"mass_at_{node}", [own], place)
    deck.model.deck.setdefault("rigid_sets", {})[name] = {"nodes": name, "body": body, "mass": mass,
                                                          "center": list(deck.nodes[node])}
