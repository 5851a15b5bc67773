"""The velocity with which an acceleration of *BOUNDARY begins: from the initial conditions,
or from what moved the node in the steps before."""

from ..curves import differentiate, order_points
from ..shapes import cross, subtract
from .deck import AXES, AbaqusDeck, RigidGroup
from .followers import list_leaders
from .timeline import DISPLACEMENT, FIXED, Window, interpolate_steps

Speed = float | None  # None: not known


class Speeds:
    """Speeds of nodes and reference nodes in directions, at the start of a step."""

    def __init__(self, deck: AbaqusDeck, start: float):
        self._deck, self._start = deck, start
        self._groups = {node: group for group in deck.groups for node in group.nodes} | deck.group_of_ref
        self._of_groups: dict[int, list[Speed]] = {}
        self._leaders = list_leaders(deck)

    def find(self, node: int, way: str) -> Speed:
        if self._start > 0:
            return find_last(self._deck.motions.windows.get((node, way), []), self._start)
        index, group = AXES.index(way), self._groups.get(node)
        if group is not None:
            speeds = self._find_group(group)
            return speeds[index] if node in group.refs or speeds[3:] == [0.0] * 3 else None
        following = self._leaders.get(node)
        if following and node not in self._deck.velocities:
            return common([self.find(other, way) for other in following.nodes])
        return self._find_node(node, index)

    def _find_node(self, node: int, index: int) -> Speed:
        """Speed by the initial conditions of nodes alone; of several rotating velocities the last one counts."""
        rotation = next((row for row in reversed(self._deck.rotations) if node in row.nodes), None)
        if rotation is None:
            return self._deck.velocities.get(node, [0.0] * 3)[index] if index < 3 else 0.0
        if index >= 3:
            return rotation.spin[index - 3]
        return (rotation.velocity[index]
                + cross(rotation.spin, subtract(self._deck.mesh.nodes[node], rotation.center))[index])

    def _find_group(self, group: RigidGroup) -> list[Speed]:
        """Speed of a body: that of its reference node counts before those of its nodes, which must agree."""
        key = id(group)
        if key not in self._of_groups:
            of_refs = [self._deck.body_velocities[node] for node in group.refs if node in self._deck.body_velocities]
            if of_refs and any(row.nodes & group.nodes for row in self._deck.rotations):
                self._of_groups[key] = [None] * 6
            elif of_refs:
                self._of_groups[key] = [common([velocity[i] for velocity in of_refs]) for i in range(6)]
            else:
                moved: list[Speed] = [common([self._find_node(node, i) for node in group.nodes]) for i in range(3)]
                turns: Speed = None if None in moved else 0.0
                self._of_groups[key] = [*moved, turns, turns, turns]
        return self._of_groups[key]


def common(speeds: list[Speed]) -> Speed:
    """The one that all have; of none it is 0."""
    found = set(speeds)
    return None if len(found) > 1 else found.pop() if found else 0.0


def find_last(windows: list[Window], time: float) -> Speed:
    """The velocity at the end of what acted up to a time. A displacement has the slope of its last straight line."""
    before = [window for window in windows if window.start < time <= window.end]
    if not before:
        return None
    action = before[-1].action
    if action.kind == FIXED or not action.points:
        return 0.0
    if action.is_sampled and action.kind == DISPLACEMENT:
        return None
    points = order_points(list(action.points))
    return interpolate_steps(differentiate(points) if action.kind == DISPLACEMENT else points, time)
