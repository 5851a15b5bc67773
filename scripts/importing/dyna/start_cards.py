"""*INITIAL_VELOCITY...: velocities at time 0."""

from ..fields import Row
from ..ledger import Place
from ..model import Deck
from ..shapes import normalise, subtract
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
        deck.ledger.refuse(f"{row.card}.ICID", row.place, f"the coordinate system {id}, which is not read", "the axes of space are used")
        return vector
    axes = deck.systems[id]
    return [sum(vector[i] * axes[i][d] for i in range(3)) for d in range(3)]


def read_initial_velocity(deck: KeywordDeck, card: Card) -> None:
    """*INITIAL_VELOCITY: a node set, or all nodes, but those exempted."""
    reader = card.reader()
    while reader.skip_blank():
        row = reader.row("NSID NSIDEX BOXID IRIGID~ ICID")
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
    motion.finish(deck.ledger, "nodes do not turn at the start")
    row.finish(deck.ledger)
    if name is None:
        deck.ledger.ignored(card.keyword, row.place, "its nodes have no element")
        return
    add_velocity(deck, name, {"velocity": velocity})
    if exempt:
        other = deck.node_set_name(row.integer("NSIDEX"), row.place)
        if other:
            add_velocity(deck, other, {"velocity": turn_vector(deck, row, exempt.numbers("VXE", "VYE", "VZE"))})
        exempt.finish(deck.ledger, "nodes do not turn at the start")
    deck.ledger.translated(card.keyword, row.place, "initial: velocity")


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
    while reader.skip_blank():
        row = reader.row("ID STYP=1 OMEGA VX VY VZ IVATN~ ICID")
        axis = reader.row("XC YC ZC NX NY NZ PHASE IRIGID~")
        names = find_generated(deck, row)
        motion = make_spin(deck, row, axis)
        row.finish(deck.ledger)
        axis.finish(deck.ledger, "the velocity acts at time 0")
        for name in names:
            add_velocity(deck, name, motion)
        if names:
            deck.ledger.translated(card.keyword, row.place, "initial: velocity and angular_velocity")
        else:
            deck.ledger.ignored(card.keyword, row.place, "what it names has no element")


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
    if omega and row.integer("ICID"):
        deck.ledger.refuse(f"{row.card}.ICID", row.place, "a spin in a coordinate system", "its axis is one of space")
    if omega:
        if direction[0] == -999:
            direction = direction_of_nodes(deck, axis)
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
    """*INITIAL_VELOCITY_RIGID_BODY: velocity of the centre, and spin."""
    for line in card.lines:
        if not line[1].strip():
            continue
        row = card.row(line, "PID VX VY VZ VXR VYR VZR ICID")
        id = row.integer("PID")
        deck.find_part(id, row.place)
        motion: Deck = {"velocity": turn_vector(deck, row, row.numbers("VX", "VY", "VZ"))}
        spin = turn_vector(deck, row, row.numbers("VXR", "VYR", "VZR"))
        if any(spin):
            motion["angular_velocity"] = spin
        row.finish(deck.ledger)
        for name in deck.part_names([id]):
            add_velocity(deck, name, motion)
        deck.ledger.translated(card.keyword, row.place, "initial: velocity and angular_velocity")


def read_temperature(deck: KeywordDeck, card: Card) -> None:
    """*INITIAL_TEMPERATURE_: it counts where a law depends on it."""
    if any(law.get("melt_temperature", NEVER) < NEVER for law in deck.model.materials.values()):
        deck.ledger.refuse(card.keyword, card.place, "temperatures of nodes", "parts start at the room temperature of their law")
    else:
        deck.ledger.ignored(card.keyword, card.place, "no law of the deck depends on the temperature")


def add_masses(deck: KeywordDeck) -> None:
    """*ELEMENT_MASS: masses of nodes, a set for each value."""
    groups: dict[float, list[int]] = {}
    place: Place | None = None
    for node, mass, place in deck.masses:
        groups.setdefault(mass, []).append(node)
    used = deck.used_nodes()
    for index, (mass, nodes) in enumerate(groups.items(), 1):
        name = deck.make_node_set(f"mass_{index}", nodes, place)  # type: ignore[arg-type]
        if len([node for node in nodes if node in used]) < len(nodes):
            deck.ledger.refuse("ELEMENT_MASS.free", place, "masses on nodes without elements", "they are left out")  # type: ignore[arg-type]
        if name and mass > 0:
            total = sum(1 for node in nodes if node in used) * mass
            deck.model.add("added_mass", {"nodes": name, "mass": total, "spread": "evenly"})
    if place:
        deck.ledger.translated("ELEMENT_MASS", place, "added_mass")
