"""Analytical rigid surfaces: cylinders and spheres become walls, moved as their reference node."""

from dataclasses import dataclass

from ..curves import Curve, differentiate, make_time_value
from ..ledger import BadInput, Place
from ..model import Deck
from ..shapes import normalise
from .deck import AbaqusDeck, RigidGroup
from .lines import Block
from .mesh import BodyCard, Profile, Scope

CARD = "RIGID BODY.ANALYTICAL SURFACE"
LEFT_OUT = "it is left out"
NEAR = 1e-6  # of a radius


def read_profile(scope: Scope, block: Block) -> None:
    """*SURFACE, TYPE=REVOLUTION: START r, z; LINE r, z; CIRCL r, z, and the centre. The axis is y of the part."""
    profile = Profile(block.place)
    for line in block.lines:
        word = block.text(line, 0).upper()
        if word not in ("START", "LINE", "CIRCL"):
            profile.pieces.append(("OTHER", []))
            continue
        count = 4 if word == "CIRCL" else 2
        profile.pieces.append((word, [block.number(line, i) for i in range(1, count + 1)]))
    scope.profiles[block.option("NAME")] = profile


@dataclass
class Shape:
    """A cylinder from its lower end on, or a sphere, in the axes of the part."""

    radius: float
    height: float  # of its lower end, or of its centre
    length: float = 0.0  # 0: a sphere


def find_shape(profile: Profile) -> Shape | None:
    """A line along the axis, or arcs around one point of it, with bodies outside: on the left from piece to piece."""
    words = [word for word, _ in profile.pieces]
    if not words or words[0] != "START" or len(words) < 2:
        return None
    r, z = profile.pieces[0][1]
    if words[1:] == ["LINE"]:
        end_r, end_z = profile.pieces[1][1]
        is_straight = abs(end_r - r) <= NEAR * abs(r)
        return Shape(r, end_z, z - end_z) if r > 0 and is_straight and end_z < z else None
    if set(words[1:]) != {"CIRCL"}:
        return None
    center = profile.pieces[1][1][3]
    radius = (r * r + (z - center) ** 2) ** 0.5
    last = z
    for end_r, end_z, center_r, center_z in (numbers for _, numbers in profile.pieces[1:]):
        is_round = abs((end_r**2 + (end_z - center) ** 2) ** 0.5 - radius) <= NEAR * radius
        if not is_round or abs(center_r) > NEAR * radius or abs(center_z - center) > NEAR * radius or end_z >= last:
            return None
        last = end_z
    return Shape(radius, center)


def add_wall(deck: AbaqusDeck, card: BodyCard) -> None:
    """Notes the wall; finish_walls writes it once it is known how it moves."""
    profile = deck.resolve(deck.mesh.profiles, card.profile, card.place, "analytical surface")
    shape = find_shape(profile)
    if shape is None:
        deck.ledger.refuse(CARD, card.place, "an analytical surface that is no cylinder or sphere from outside", LEFT_OUT)
        return
    axis = normalise(profile.axis)
    point = [o + shape.height * a for o, a in zip(profile.origin, axis)]
    wall: Deck = {"name": deck.model.names.take(card.profile.replace(".", "_"), "wall"), "point": point}
    if shape.length:
        wall["cylinder"] = {"axis": list(axis), "radius": shape.radius, "length": shape.length}
    else:
        wall["sphere"] = {"radius": shape.radius}
    wall["thickness"] = "seen"
    group = RigidGroup(card.place, set(), set(deck.nodes_of(card.ref, card.place)) if card.ref else set(), wall=wall)
    group.profile = card.profile.upper()
    deck.groups.append(group)
    deck.group_of_ref |= dict.fromkeys(group.refs, group)


def is_profile(deck: AbaqusDeck, name: str) -> bool:
    name = name.strip().strip('"').upper()
    return any(key == name or key.endswith("." + name) for key in deck.mesh.profiles)


def finish_wall(deck: AbaqusDeck, group: RigidGroup) -> None:
    """A wall whose reference node is held in all directions, or moved in one of them."""
    moved = [(d, motion) for d, (_, motion) in group.held.items() if motion is not None]
    is_held = set(group.held) >= {"x", "y", "z", "rx", "ry", "rz"} and len(moved) <= 1
    if not is_held or any(d.startswith("r") for d, _ in moved):
        deck.ledger.refuse(CARD, group.place, "an analytical surface that is free, turns, or moves in several directions", LEFT_OUT)
        return
    wall = group.wall or {}
    friction = choose_contact(deck, group, wall)
    if friction is None:
        deck.ledger.ignored(CARD, group.place, "contact does not name it")
        return
    if friction:
        wall["friction"] = friction
    for direction, motion in moved:
        wall["direction"] = direction
        wall["speed"] = motion["velocity"][direction] if "velocity" in motion else find_speed(deck, motion["displacement"][direction], group.place)
    deck.model.add("walls", wall)
    deck.ledger.translated(CARD, group.place, "walls: a cylinder or a sphere that stops nodes, at half the thickness of shells")


def choose_contact(deck: AbaqusDeck, group: RigidGroup, wall: Deck) -> float | None:
    """Friction, and the nodes of pairs; None: the wall touches nothing."""
    for name, other, friction in deck.wall_pairs:
        if group.profile == name or group.profile.endswith("." + name):
            wall.setdefault("nodes", []).append(other)
            wall["friction"] = friction
    if "nodes" in wall:
        return wall.pop("friction")
    return deck.whole["friction"] if deck.whole else None


def find_speed(deck: AbaqusDeck, way: Deck, place: Place) -> "float | Deck":
    """The slope of a displacement."""
    if not isinstance(way, dict) or "table" not in way:
        raise BadInput(place, "the displacement of an analytical surface needs an amplitude")
    rows = [(row[0], row[1]) for row in way["table"]]
    deck.ledger.approximated(CARD, place, "the slope of the displacement as a speed")
    return make_time_value(Curve(place, differentiate(rows)), 1.0, deck.end_time)
