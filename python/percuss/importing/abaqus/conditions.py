"""*BOUNDARY: nodes that are held or moved, in each step."""

from dataclasses import dataclass, replace

from ..curves import integrate, order_points
from ..fields import clip
from ..ledger import Place
from ..model import Deck
from .axisymmetric import hold_bodies, split_turned
from .deck import AXES, AbaqusDeck, RigidGroup
from .equations import add_driven
from .followers import follow, list_leaders
from .lines import Block, Line
from .speeds import Speeds
from .timeline import DISPLACEMENT, FIXED, VELOCITY, Action, Target, Window, is_whole, make_motion, split_groups

NAMED = {"ENCASTRE": AXES, "PINNED": AXES[:3], "XSYMM": ("x", "ry", "rz"), "YSYMM": ("y", "rx", "rz"),
         "ZSYMM": ("z", "rx", "ry"), "XASYMM": ("y", "z", "rx"), "YASYMM": ("x", "z", "ry"),
         "ZASYMM": ("x", "y", "rz")}  # fmt: skip
KINDS = ("DISPLACEMENT", "VELOCITY", "ACCELERATION")
LEFT_OUT = "it is left out"
MOST_SPEEDS = 20  # from which an acceleration of one line may begin



@dataclass
class ConditionLine:
    """A line of *BOUNDARY: what it does in which directions."""

    name: str
    nodes: list[int]
    directions: list[str]
    action: Action
    has_all: bool = True  # the nodes of its name that are moved at all


def read_boundary(deck: AbaqusDeck, block: Block) -> None:
    """set, ENCASTRE; or set, first, last, value, of displacements or velocities."""
    if block.option("OP") == "NEW" and ("BOUNDARY", block.step) not in deck.renewed:
        deck.motions.stop(list(deck.motions.windows), deck.step_of(block).start)
        deck.renewed.add(("BOUNDARY", block.step))
    if block.option("OP") == "NEW" and not block.lines:
        deck.ledger.translated("BOUNDARY", block.place, "OP=NEW ends what acted before")
    for line in block.lines:
        word = block.text(line, 1).upper()
        if word in NAMED:
            directions, value = list(NAMED[word]), 0.0
        elif block.text(line, 1) and not block.text(line, 1).strip("+-").isdigit() and "." not in block.text(line, 1):
            deck.ledger.refuse("BOUNDARY.type", block.at(line[0]), f"a condition of the kind {clip(word)}", LEFT_OUT)
            continue
        else:
            first = block.integer(line, 1, 1)
            last = block.integer(line, 2, first) or first
            if not 1 <= first <= last <= 6:
                deck.ledger.refuse("BOUNDARY.dof", block.at(line[0]),
                                   f"directions {first} to {last}, beyond 1 to 6", "these are left out")
            directions, value = [AXES[i - 1] for i in range(max(first, 1), min(last, 6) + 1)], block.number(line, 3)
        act(deck, block, line, directions, value)


def act(deck: AbaqusDeck, block: Block, line: Line, directions: list[str], value: float) -> None:
    """Notes what a line does from its step on."""
    place = block.at(line[0])
    name = block.text(line, 0)
    moving = deck.group_of_ref.keys() | list_leaders(deck).keys() | deck.leaders
    nodes = [node for node in deck.nodes_of(name, place) if node in deck.used_nodes() or node in moving]
    if not nodes:
        deck.ledger.ignored("BOUNDARY", place, "its nodes have no element")
        return
    refuse_other_axes(deck, nodes, place)
    action = make_action(deck, block, place, value)
    if action is None:
        return
    deck.keywords_of_lines[place] = block.keyword
    for group, ways in split_turned(deck, nodes, directions):
        if block.option("TYPE") == "ACCELERATION":
            accelerate(deck, action, name, group, ways)
        else:
            add_action(deck, ConditionLine(name, group, ways, action))


def add_action(deck: AbaqusDeck, line: ConditionLine) -> None:
    for node in line.nodes:
        for direction in line.directions:
            deck.motions.act((node, direction), line.action)
    deck.condition_lines.append(line)


def accelerate(deck: AbaqusDeck, rise: Action, name: str, nodes: list[int], ways: list[str]) -> None:
    """Adds what the velocity rises by to that at the start of the step, of which each value has a line of its own."""
    speeds = Speeds(deck, rise.start)
    groups: dict[tuple[float, tuple[str, ...]], list[int]] = {}
    for node in nodes:
        of_node: dict[float, list[str]] = {}
        for way in ways:
            speed = speeds.find(node, way)
            if speed is None:
                why = ("an acceleration that begins later, from a velocity that is not known" if rise.start > 0
                       else "an acceleration of nodes whose velocity at the start is not known")
                deck.ledger.refuse("BOUNDARY.TYPE", rise.place, why, LEFT_OUT)
                return
            of_node.setdefault(speed, []).append(way)
        for speed, its_ways in of_node.items():
            groups.setdefault((speed, tuple(its_ways)), []).append(node)
    if len({speed for speed, _ in groups}) > MOST_SPEEDS:
        deck.ledger.refuse("BOUNDARY.TYPE", rise.place, "an acceleration of nodes that begin with more than "
                                                        f"{MOST_SPEEDS} different velocities", LEFT_OUT)
        return
    for (speed, same_ways), members in groups.items():
        action = replace(rise, points=tuple((x, y + speed) for x, y in rise.points))
        add_action(deck, ConditionLine(name, members, list(same_ways), action, len(members) == len(nodes)))


def refuse_other_axes(deck: AbaqusDeck, nodes: list[int], place: Place) -> None:
    """Directions in a system of *TRANSFORM."""
    if any(node in deck.transformed for node in nodes):
        deck.ledger.refuse("TRANSFORM", place, "conditions or loads along the axes of *TRANSFORM",
                           "they act along the axes of space")


def make_action(deck: AbaqusDeck, block: Block, place: Place, value: float) -> Action | None:
    """What a line does; None where it is refused. Of an acceleration by how much the velocity rises."""
    kind = block.option("TYPE") or "DISPLACEMENT"
    start = deck.step_of(block).start
    amplitude = deck.amplitude(block.option("AMPLITUDE"), place)
    if kind not in KINDS:
        deck.ledger.refuse("BOUNDARY.TYPE", place, f"a condition of type {clip(kind)}", LEFT_OUT)
        return None
    if value == 0 and not (amplitude and amplitude.is_absolute) and kind != "ACCELERATION":
        return Action(FIXED, start, (), place)
    if kind == "DISPLACEMENT" and amplitude is None:
        deck.ledger.approximated(
            "BOUNDARY.value", place,
            "a displacement without an amplitude: its nodes are held, as Abaqus/Explicit ignores the jump"
        )
        return Action(FIXED, start, (), place)
    points = deck.values_in_step(block, place, value)
    if points is None:
        return None
    if kind == "ACCELERATION":
        points = integrate(order_points(points))
    elif kind == "DISPLACEMENT" and points[0][1] != 0:
        deck.ledger.approximated("BOUNDARY.jump", place,
                                 "a displacement that begins with a jump: the jump is left out, as in Abaqus/Explicit")
    return Action(DISPLACEMENT if kind == "DISPLACEMENT" else VELOCITY, start, tuple(points), place,
                  bool(amplitude and amplitude.error))


def finish_conditions(deck: AbaqusDeck) -> None:
    """Conditions of nodes; those of reference nodes are noted with their bodies."""
    hold_references(deck)
    follow(deck)
    add_driven(deck)
    turning = deck.model.turning_nodes()
    done: set[Target] = set()
    for line in deck.condition_lines:
        add_line(deck, line, turning, done)
    rest: dict[Target, list[int]] = {}
    for target, windows in deck.motions.windows.items():
        node, direction = target
        if target in done or node in deck.group_of_ref or direction.startswith("r") and node not in turning:
            continue
        rest.setdefault((direction, *((w.start, w.end, id(w.action)) for w in windows)), []).append(node)
    for key, nodes in rest.items():
        add_changing(deck, key[0], deck.motions.windows[(nodes[0], key[0])], nodes)


def add_line(deck: AbaqusDeck, line: ConditionLine, turning: set[int], done: set[Target]) -> None:
    """Entries of what acts through the whole run as its line says."""
    place = line.action.place
    groups: dict[tuple[int, ...], list[str]] = {}
    free = [node for node in line.nodes if node not in deck.group_of_ref]
    for direction in line.directions:
        if direction.startswith("r") and not any(node in turning for node in free):
            continue
        nodes = tuple(node for node in free if acts_alone(deck, line.action, (node, direction)))
        if nodes:
            groups.setdefault(nodes, []).append(direction)
            done |= {(node, direction) for node in nodes}
    for nodes, directions in groups.items():
        name = (deck.node_set_name(line.name, place) if line.has_all and len(nodes) == len(line.nodes)
                and not deck.is_ring else deck.model.add_node_set(line.name, nodes))
        window = [Window(line.action, 0.0, deck.end_time)]
        motions = [make_motion(window, deck.end_time, direction) for direction in directions]
        deck.model.add("conditions", {"nodes": name, **join_motions(motions)})
        deck.ledger.translated("BOUNDARY", place, "conditions")


def acts_alone(deck: AbaqusDeck, action: Action, target: Target) -> bool:
    windows = deck.motions.windows.get(target, [])
    if len(windows) != 1 or not is_whole(windows, deck.end_time):
        return False
    found = windows[0].action
    return found is action or found.kind == FIXED == action.kind


def join_motions(motions: list[Deck]) -> Deck:
    """One kind in several directions."""
    kind = next(iter(motions[0]))
    if kind == "fixed":
        return {kind: [direction for motion in motions for direction in motion[kind]]}
    return {kind: {direction: value for motion in motions for direction, value in motion[kind].items()}}


def add_changing(deck: AbaqusDeck, direction: str, windows: list[Window], nodes: list[int]) -> None:
    """What changes from step to step: one motion, which a sensor begins or ends."""
    place = windows[0].action.place
    groups = split_groups(windows)
    if len(groups) > 1:
        deck.ledger.refuse("BOUNDARY.steps", place, "a condition that ends and begins again", "it ends for good")
    entry: Deck = {"nodes": deck.model.add_node_set(f"held_{direction}", nodes),
                   **make_spell(deck, groups[0], direction)}
    deck.model.add("conditions", entry)
    deck.ledger.translated("BOUNDARY", place, "conditions, over the steps")


def make_spell(deck: AbaqusDeck, windows: list[Window], direction: str) -> Deck:
    """Windows without a gap, which a sensor begins or ends."""
    entry = make_motion(windows, deck.end_time, direction)
    if windows[0].start > 0:
        entry["from"] = deck.sensor_at(windows[0].start)
    if windows[-1].end < deck.end_time:
        entry["until"] = deck.sensor_at(windows[-1].end)
    return entry


def hold_for_steps(deck: AbaqusDeck, group: RigidGroup, direction: str, windows: list[Window]) -> None:
    """A body that is held or moved in some of the steps alone."""
    place, spells = windows[0].action.place, split_groups(windows)
    if group.wall or len(spells) > 1:
        what = ("a wall that is held or moved in some of the steps alone" if group.wall
                else "a condition that ends and begins again")
        deck.ledger.refuse("BOUNDARY.steps", place, what, LEFT_OUT if group.wall else "it ends for good")
    if not group.wall:
        group.spells[direction] = make_spell(deck, spells[0], direction)
        deck.ledger.translated("BOUNDARY", place, "conditions of a rigid body, over the steps")


def hold_references(deck: AbaqusDeck) -> None:
    """What acts on reference nodes acts on their bodies."""
    for (node, direction), windows in deck.motions.windows.items():
        group = deck.group_of_ref.get(node)
        if group is None:
            continue
        place = windows[0].action.place
        if group.held.get(direction, (node, None))[0] != node or direction in group.spells:
            deck.ledger.refuse("BOUNDARY.references", place, "two reference nodes of one body that are held or moved",
                               "the last of them counts")
        if not is_whole(windows, deck.end_time):
            hold_for_steps(deck, group, direction, windows)
            continue
        motion = make_motion(windows, deck.end_time, direction)
        group.held[direction] = (node, None if "fixed" in motion else motion)
        deck.ledger.translated("BOUNDARY", place, "what holds a rigid body")
    hold_bodies(deck)
