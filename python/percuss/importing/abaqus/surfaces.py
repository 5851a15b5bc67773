"""Analytical rigid surfaces: planes, cylinders and spheres become walls where they can, other profiles rigid shells."""

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from ..curves import Curve, differentiate, make_time_value
from ..ledger import BadInput, Place
from ..model import Deck, Vector
from ..shapes import cross, dot, make_vector, normalise, subtract
from .deck import AXES, AbaqusDeck, RigidGroup
from .lines import Block
from .mesh import BodyCard, Profile, Scope
from .rigid_shells import add_rigid_shells

CARD = "RIGID BODY.ANALYTICAL SURFACE"
KINDS = ("REVOLUTION", "CYLINDER", "SEGMENTS")
WORDS = {"START": 2, "LINE": 2, "CIRCL": 4, "PARAB": 4}
LEFT_OUT = "it is left out"
NEAR = 1e-6  # share of a radius
AROUND, ALONG, PER_ARC = 48, 20, math.radians(5.0)  # rigid shells around an axis, along a line, and of an arc


def read_profile(scope: Scope, block: Block) -> None:
    """START; LINE to a point; CIRCL to a point, and the centre; PARAB by a point to another.
    Axes first, outside of parts."""
    profile = Profile(block.place, block.option("TYPE"))
    axes: list[float] = []
    for line in block.lines:
        word = block.text(line, 0).upper()
        if word in WORDS:
            profile.pieces.append((word, [block.number(line, i) for i in range(1, WORDS[word] + 1)]))
        elif not profile.pieces and len(axes) < 9:
            axes += [block.number(line, i) for i in range(len(line[1])) if line[1][i]]
        else:
            raise BadInput(block.at(line[0]),
                           "START, LINE, CIRCL or PARAB is expected in a line of *SURFACE: correct it")
    if not profile.pieces or profile.pieces[0][0] != "START" or len(profile.pieces) < 2:
        raise BadInput(block.place, "the profile of this *SURFACE has no START, or nothing behind it: correct it")
    if axes:
        set_axes(profile, axes)
    scope.profiles[block.option("NAME")] = profile


def set_axes(profile: Profile, values: list[float]) -> None:
    """Origin and a point of the axis of revolution."""
    if profile.kind != "REVOLUTION":
        raise BadInput(profile.place, "a surface swept along a generator outside of a part "
                                      "(the sense of its axes is not known): define it in a part, by x and y")
    if len(values) != 6:
        raise BadInput(profile.place,
                       f"the axis of this *SURFACE has {len(values)} numbers (6 are expected): correct it")
    profile.origin = (values[0], values[1], values[2])
    far = normalise(subtract((values[3], values[4], values[5]), profile.origin))
    if not any(far):
        raise BadInput(profile.place, "the axis of this *SURFACE has no direction: correct it")
    other = min(((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)), key=lambda e: abs(dot(e, far)))
    profile.axis, profile.first = far, normalise(cross(far, other))


@dataclass
class Shape:
    """A wall: keys of the deck, and the direction in which a plane may move."""

    keys: Deck
    normal: Vector | None = None


def find_shape(deck: AbaqusDeck, profile: Profile) -> Shape | None:
    """Bodies are outside: on the left from piece to piece. None where the profile is no wall of percuss."""
    axis, first = normalise(profile.axis), normalise(profile.first)

    def put(r: float, z: float) -> list[float]:
        return [o + r * f + z * a for o, f, a in zip(profile.origin, first, axis)]

    if profile.kind != "REVOLUTION":
        return find_plane(deck, profile, put)
    words = [word for word, _ in profile.pieces]
    r, z = profile.pieces[0][1]
    if words[1:] == ["LINE"]:
        end_r, end_z = profile.pieces[1][1]
        # nodes of the sector have x or z as their radius
        if deck.is_ring and end_z == z and min(r, end_r) <= NEAR * max(r, end_r):
            normal = make_vector(a if end_r > r else -a for a in axis)
            rectangle = {"along": list(first), "size": [2 * max(r, end_r)] * 2}
            return Shape({"point": put(0.0, z), "normal": list(normal), "rectangle": rectangle}, normal)
        if not (r > 0 and abs(end_r - r) <= NEAR * abs(r) and end_z < z):
            return None
        return Shape({"point": put(0.0, end_z), "cylinder": {"axis": list(axis), "radius": r, "length": z - end_z}})
    if set(words[1:]) != {"CIRCL"}:
        return None
    center = profile.pieces[1][1][3]
    radius = math.hypot(r, z - center)
    last = z
    for end_r, end_z, center_r, center_z in (numbers for _, numbers in profile.pieces[1:]):
        is_round = abs(math.hypot(end_r, end_z - center) - radius) <= NEAR * radius
        if not is_round or abs(center_r) > NEAR * radius or abs(center_z - center) > NEAR * radius or end_z >= last:
            return None
        last = end_z
    return Shape({"point": put(0.0, center), "sphere": {"radius": radius}})


def find_plane(deck: AbaqusDeck, profile: Profile, put: Callable[..., list[float]]) -> Shape | None:
    """One straight line: a strip, without end along its generator."""
    if [word for word, _ in profile.pieces] != ["START", "LINE"]:
        return None
    start, end = put(*profile.pieces[0][1]), put(*profile.pieces[1][1])
    along = subtract(tuple(end), tuple(start))  # type: ignore[arg-type]
    length = math.hypot(*along)
    if length <= 0:
        raise BadInput(profile.place, "the line of this *SURFACE has no length: correct it")
    generator = cross(normalise(profile.first), normalise(profile.axis))
    normal = cross(generator, normalise(along))  # on the left of the line
    side = cross(normal, normalise(along))
    width = 4 * find_extent(deck)
    point = [s - 0.5 * width * v for s, v in zip(start, side)]
    return Shape({"point": point, "normal": list(normal),
                  "rectangle": {"along": list(normalise(along)), "size": [length, width]}}, normal)


def find_extent(deck: AbaqusDeck) -> float:
    """The diagonal of the model."""
    points = [deck.mesh.nodes[node] for node in deck.used_nodes()] or [(0.0, 0.0, 0.0)]  # none: every part was left out
    return math.dist([min(p[d] for p in points) for d in range(3)], [max(p[d] for p in points) for d in range(3)])


def add_wall(deck: AbaqusDeck, card: BodyCard) -> None:
    """Notes the wall; finish_wall writes it once it is known how it moves."""
    deck.resolve(deck.mesh.profiles, card.profile, card.place, "analytical surface")
    wall: Deck = {"name": deck.model.names.take(card.profile.replace(".", "_"), "wall")}
    group = RigidGroup(card.place, set(), set(deck.nodes_of(card.ref, card.place)) if card.ref else set(),
                       wall=wall, card=card)
    group.profile, group.at_center = card.profile.upper(), card.at_center
    deck.groups.append(group)
    deck.group_of_ref |= dict.fromkeys(group.refs, group)


def is_profile(deck: AbaqusDeck, name: str) -> bool:
    name = name.strip().strip('"').upper()
    return bool(name) and any(key == name or key.endswith("." + name) for key in deck.mesh.profiles)


def finish_wall(deck: AbaqusDeck, group: RigidGroup) -> None:
    """A wall whose reference node is held in all directions, or moved in one of them;
    anything else is a body of rigid shells."""
    assert group.card is not None  # a group of a wall is made from its card
    profile = deck.resolve(deck.mesh.profiles, group.card.profile, group.place, "analytical surface")
    wall: dict[str, Any] = group.wall or {}
    friction = choose_contact(deck, group, wall)
    if friction is None:
        deck.ledger.ignored(CARD, group.place, "contact does not name it")
        return
    shape = find_shape(deck, profile)
    moved = [(d, motion) for d, (_, motion) in group.held.items() if motion is not None]
    if shape is None or not moves_as_wall(group, shape, moved):
        add_shells(deck, group, profile, friction)
        return
    wall |= {**shape.keys, "thickness": "included"}
    if friction:
        wall["friction"] = friction
    for direction, motion in moved:
        sign = shape.normal["xyz".index(direction)] if shape.normal else 1.0
        if not shape.normal:
            wall["direction"] = direction
        wall["speed"] = scale(find_speed(deck, motion, direction, group.place), sign)
    deck.model.add("walls", wall)
    deck.ledger.translated(CARD, group.place,
                           "walls: a strip, a cylinder or a sphere that stops nodes, at half the thickness of shells")


def moves_as_wall(group: RigidGroup, shape: Shape, moved: list[tuple[str, Deck]]) -> bool:
    """Held, but for one direction: of a plane that of its normal."""
    if not set(group.held) >= set(AXES) or len(moved) > 1 or any(d.startswith("r") for d, _ in moved):
        return False
    return not (moved and shape.normal) or abs(shape.normal["xyz".index(moved[0][0])]) > 1 - NEAR


def scale(value: "float | Deck", factor: float) -> "float | Deck":
    """A value over time in the other direction."""
    sign = 1.0 if factor > 0 else -1.0
    return {"table": [[t, sign * v] for t, v in value["table"]]} if isinstance(value, dict) else sign * value


def choose_contact(deck: AbaqusDeck, group: RigidGroup, wall: Deck) -> float | None:
    """Friction, and the nodes of pairs; None: the wall touches nothing."""
    found: float | None = None
    for name, other, friction in deck.wall_pairs:
        if group.profile == name or group.profile.endswith("." + name):
            wall.setdefault("nodes", []).append(other)
            found = deck.whole_friction if friction is None else friction
    return found if found is not None or not deck.is_whole else deck.whole_friction


def find_speed(deck: AbaqusDeck, motion: Deck, direction: str, place: Place) -> "float | Deck":
    """A velocity, or the slope of a displacement."""
    if "velocity" in motion:
        speed: "float | Deck" = motion["velocity"][direction]
        return speed
    way = motion["displacement"][direction]
    if not isinstance(way, dict):
        return 0.0
    rows = [(row[0], row[1]) for row in way["table"]]
    deck.ledger.approximated(CARD, place, "the slope of the displacement as a speed")
    return make_time_value(Curve(place, differentiate(rows)), 1.0, deck.end_time)


# --- rigid shells


@dataclass
class Mesh:
    """Points and shells of a surface, from the next free ids on."""

    deck: AbaqusDeck
    next_node: int
    shells: list[tuple[int, ...]] = field(default_factory=list)

    def add(self, x: Vector) -> int:
        self.deck.mesh.nodes[self.next_node] = x
        self.next_node += 1
        return self.next_node - 1


def list_points(profile: Profile) -> list[tuple[float, float]]:
    """The profile as a line of points."""
    points: list[tuple[float, float]] = [(profile.pieces[0][1][0], profile.pieces[0][1][1])]
    for word, v in profile.pieces[1:]:
        x, y = points[-1]
        if word == "LINE":
            points += [(x + (v[0] - x) * i / ALONG, y + (v[1] - y) * i / ALONG) for i in range(1, ALONG + 1)]
        elif word == "CIRCL":
            radius, start = math.hypot(x - v[2], y - v[3]), math.atan2(y - v[3], x - v[2])
            # less than half a turn
            turn = (math.atan2(v[1] - v[3], v[0] - v[2]) - start + math.pi) % (2 * math.pi) - math.pi
            pieces = max(1, math.ceil(abs(turn) / PER_ARC))
            points += [(v[2] + radius * math.cos(start + turn * i / pieces),
                        v[3] + radius * math.sin(start + turn * i / pieces)) for i in range(1, pieces)]
            points.append((v[0], v[1]))
        else:  # a parabola through a point half way
            for i in range(1, ALONG + 1):
                s = i / ALONG
                a, b, c = (1 - s) * (1 - 2 * s), 4 * s * (1 - s), s * (2 * s - 1)
                points.append((a * x + b * v[0] + c * v[2], a * y + b * v[1] + c * v[3]))
    return points


def add_shells(deck: AbaqusDeck, group: RigidGroup, profile: Profile, friction: float) -> None:
    """The surface as a rigid part, which touches on both of its sides."""
    mesh = Mesh(deck, max(deck.mesh.nodes) + 1)
    (sweep_around if profile.kind == "REVOLUTION" else sweep_along)(deck, mesh, profile)
    first = max([*deck.mesh.elements, 0]) + 1
    shells = [(first + i, corners) for i, corners in enumerate(mesh.shells)]
    others = (group.wall or {}).get("nodes", [])
    part = add_rigid_shells(deck, group.profile, group.place, shells, (group.wall or {}).get("name", ""))
    deck.forget_used()
    part.keys["rigid"] = True
    group.name, group.nodes, group.wall = part.name, deck.model.nodes_of_blocks([part.id]), None
    for other in others:
        if other in deck.model.node_sets:
            deck.ledger.refuse("CONTACT PAIR.nodes", group.place,
                               "contact of a surface of nodes with an analytical surface of this form", LEFT_OUT)
        else:
            deck.pairs.append({"a": part.name, "b": other, "friction": friction})
            deck.contact_names[(group.profile, other)] = (other, part.name)
    deck.ledger.approximated(CARD, group.place, f"rigid shells: arcs by pieces of 5 degrees, {AROUND} around an axis; "
                                                "they touch on both sides")


def sweep_around(deck: AbaqusDeck, mesh: Mesh, profile: Profile) -> None:
    axis, first = normalise(profile.axis), normalise(profile.first)
    second = cross(axis, first)
    rings: list[list[int]] = []
    for r, z in list_points(profile):
        at = [o + z * a for o, a in zip(profile.origin, axis)]
        if abs(r) <= 1e-9 * max(abs(z), 1e-300) or r == 0:
            rings.append([mesh.add((at[0], at[1], at[2]))] * AROUND)
            continue
        ring = []
        for i in range(AROUND):
            c, s = r * math.cos(2 * math.pi * i / AROUND), r * math.sin(2 * math.pi * i / AROUND)
            ring.append(mesh.add(make_vector(p + c * f + s * g for p, f, g in zip(at, first, second))))
        rings.append(ring)
    for below, above in zip(rings, rings[1:]):
        for i in range(AROUND):
            j = (i + 1) % AROUND
            corners = tuple(dict.fromkeys((below[i], below[j], above[j], above[i])))
            if len(corners) >= 3:
                mesh.shells.append(corners)


def sweep_along(deck: AbaqusDeck, mesh: Mesh, profile: Profile) -> None:
    """Along the generator as far as the model goes, and half of that beyond its ends."""
    axis, first = normalise(profile.axis), normalise(profile.first)
    generator = cross(first, axis)
    ways = [dot(subtract(deck.mesh.nodes[node], profile.origin), generator) for node in deck.used_nodes()]
    low, high = min(ways, default=0.0), max(ways, default=0.0)
    margin = 0.5 * max(high - low, 0.1 * find_extent(deck))
    rows: list[list[int]] = []
    for x, y in list_points(profile):
        row = []
        for i in range(ALONG + 1):
            s = low - margin + (high - low + 2 * margin) * i / ALONG
            axes = zip(profile.origin, first, axis, generator)
            row.append(mesh.add(make_vector(o + x * f + y * a + s * g for o, f, a, g in axes)))
        rows.append(row)
    for below, above in zip(rows, rows[1:]):
        mesh.shells += [(below[i], below[i + 1], above[i + 1], above[i]) for i in range(ALONG)]
