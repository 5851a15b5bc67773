"""*BOUNDARY_...: fixed and prescribed motion of nodes."""

from ..curves import Curve, differentiate, integrate, make_time_value, order_points
from ..fields import Row
from ..ledger import Place
from ..model import Deck
from .cards import Card
from .deck import KeywordDeck

AXES = ("x", "y", "z")
CODES = {0: (), 1: ("x",), 2: ("y",), 3: ("z",), 4: ("x", "y"), 5: ("y", "z"), 6: ("x", "z"), 7: AXES}
DIRECTIONS = {1: "x", 2: "y", 3: "z", 5: "rx", 6: "ry", 7: "rz"}


def add_fixed(deck: KeywordDeck, name: str, directions: list[str], nodes: list[int]) -> None:
    """A condition; rotations only where one of the nodes has shells or beams."""
    turning = deck.turning_nodes()
    if not any(node in turning for node in nodes):
        directions = [d for d in directions if d in AXES]
    if directions:
        deck.model.add("conditions", {"nodes": name, "fixed": directions})


def apply_fixed_nodes(deck: KeywordDeck) -> None:
    """TC and RC of *NODE."""
    rigid = deck.rigid_nodes()
    for (tc, rc), nodes in sorted(deck.fixed_nodes.items()):
        nodes = [node for node in nodes if node not in rigid]  # as in LS-DYNA
        directions = [*CODES[tc], *("r" + axis for axis in CODES[rc])]
        label = "".join(CODES[tc]) + ("_r" + "".join(CODES[rc]) if rc else "")
        name = deck.make_node_set(f"fixed_{label}", nodes, deck.fixed_place)  # type: ignore[arg-type]
        if name:
            add_fixed(deck, name, directions, deck.model.node_sets[name])


def axis_of_system(deck: KeywordDeck, id: int) -> list[int] | None:
    """Which axis of space each axis of a system is, for those that lie along space. None for others."""
    axes = []
    for axis in deck.systems.get(id, ()):
        along = [d for d in range(3) if abs(abs(axis[d]) - 1) < 1e-9]
        if not along:
            return None
        axes.append(along[0])
    return axes if len(axes) == 3 else None


def read_plane(deck: KeywordDeck, card: Card) -> None:
    """*CONSTRAINED_GLOBAL: all nodes within TOL of a plane across DIR, through a point."""
    reader = card.reader()
    while reader.skip_blank():
        row = reader.row("TC RC DIR X Y Z TOL")
        tc, rc, d = row.integer("TC"), row.integer("RC"), row.integer("DIR") - 1
        if not (0 <= tc <= 7 and 0 <= rc <= 7 and 0 <= d <= 2):
            row.fail("DIR", "codes from 0 to 7 and a direction from 1 to 3 are expected")
        place, reach = row.numbers("X", "Y", "Z")[d], row.number("TOL")
        if reach <= 0:
            row.fail("TOL", "percuss needs a distance above 0")
        nodes = [node for node in deck.used_nodes() if abs(deck.nodes[node][d] - place) <= reach]
        name = deck.make_node_set(f"plane_{AXES[d]}", nodes, row.place)
        name = without_rigid(deck, name, card, row.place) if name else ""
        if name:
            add_fixed(deck, name, [*CODES[tc], *("r" + axis for axis in CODES[rc])], deck.model.node_sets[name])
            deck.ledger.translated(card.keyword, row.place, "conditions: fixed, of the nodes on the plane")
        else:
            deck.ledger.ignored(card.keyword, row.place, "no node lies on the plane")


def turn_direction(deck: KeywordDeck, row: Row, direction: str) -> tuple[str, float]:
    """A direction of the system CID as a direction of space, with its sign."""
    id = row.integer("CID")
    if not id:
        return direction, 1.0
    if id not in deck.systems:
        row.fail("CID", "there is no such system")
    axis = deck.systems[id][AXES.index(direction[-1])]
    for d in range(3):
        if abs(abs(axis[d]) - 1) < 1e-9:
            return direction[:-1] + AXES[d], 1.0 if axis[d] > 0 else -1.0
    deck.ledger.refuse(f"{row.card}.CID", row.place, f"coordinate system {id}, whose axes are not the global ones", "the global axes are used")
    return direction, 1.0


def read_spc(deck: KeywordDeck, card: Card) -> None:
    """*BOUNDARY_SPC_NODE and _SET."""
    options = set(card.keyword.removeprefix("BOUNDARY_SPC").split("_")) - {""}
    if options - {"NODE", "SET", "BIRTH", "DEATH"} or not options & {"NODE", "SET"}:
        deck.ledger.refuse(card.keyword, card.place, "this form of the card", "it is left out")
        return
    reader = card.reader()
    while reader.skip_blank():
        if card.has_id:
            reader.take()
        row = reader.row("ID CID X Y Z RX RY RZ")
        if "BIRTH" in options:
            window = reader.row("BIRTH DEATH=1e20")
            if window.number("BIRTH") > 0 or window.number("DEATH") < deck.end_time:
                deck.ledger.refuse("BOUNDARY_SPC.BIRTH", window.place, "a condition with a birth or death time", "it acts during the whole run")
        apply_spc(deck, card, row, "SET" in options)


def apply_spc(deck: KeywordDeck, card: Card, row: Row, is_set: bool) -> None:
    directions = [d for d in ("x", "y", "z", "rx", "ry", "rz") if row.integer(d.upper())]
    if not directions:
        deck.ledger.ignored(f"{card.keyword}.none", row.place, "it holds no direction")
        return
    system = row.integer("CID")
    axes = axis_of_system(deck, system) if system else [0, 1, 2]
    if axes is None:
        if set(directions) & set(AXES) == set(AXES) and len(directions) in (3, 6):
            axes = [0, 1, 2]  # all directions of any system
        else:
            deck.ledger.refuse(
                "BOUNDARY_SPC.CID", row.place, f"fixed directions in coordinate system {system}", "the condition is left out"
            )
            return
    turned = [("r" if d.startswith("r") else "") + AXES[axes[AXES.index(d[-1])]] for d in directions]
    name = nodes_of(deck, row.integer("ID"), is_set, row.place)
    if name is None:
        deck.ledger.ignored(card.keyword, row.place, "its nodes have no element")
        return
    name = without_rigid(deck, name, card, row.place)
    if name:
        add_fixed(deck, name, turned, deck.model.node_sets[name])
        deck.ledger.translated(card.keyword, row.place, "conditions: fixed")


def without_rigid(deck: KeywordDeck, name: str, card: Card, place: Place) -> str:
    """The set, or what of it lies on no rigid part: conditions on nodes do not act on rigid bodies."""
    rigid, members = deck.rigid_nodes(), deck.model.node_sets[name]
    rest = [node for node in members if node not in rigid]
    if len(rest) == len(members):
        return name
    deck.ledger.ignored(f"{card.keyword}.rigid", place, "no effect on nodes of rigid parts")
    return deck.make_node_set(f"{name}_free", rest, place)


def nodes_of(deck: KeywordDeck, id: int, is_set: bool, place: Place) -> str | None:
    """Name of a node set, or of a set of one node."""
    if is_set:
        return deck.node_set_name(id, place)
    name = deck.single_nodes.get(id) or deck.make_node_set(f"node_{id}", [id], place)
    if name:
        deck.single_nodes[id] = name
    return name or None


def read_motion(deck: KeywordDeck, card: Card) -> None:
    """*BOUNDARY_PRESCRIBED_MOTION_NODE and _SET."""
    form = card.keyword.removeprefix("BOUNDARY_PRESCRIBED_MOTION_")
    if form not in ("NODE", "SET"):
        deck.ledger.refuse(card.keyword, card.place, "this form of the card", "it is left out")
        return
    reader = card.reader()
    while reader.skip_blank():
        if card.has_id:
            reader.take()
        row = reader.row("ID DOF VAD LCID SF=1 VID DEATH=1e28 BIRTH")
        if abs(row.integer("DOF")) in (9, 10, 11) or row.integer("VAD") == 4:
            reader.take()
        apply_motion(deck, card, row, form == "SET")


def apply_motion(deck: KeywordDeck, card: Card, row: Row, is_set: bool) -> None:
    found = find_direction(deck, row)
    if found is None:
        deck.ledger.refuse(
            "BOUNDARY_PRESCRIBED_MOTION.DOF", row.place, "motion along a direction that is not a global axis", "it is left out"
        )
        return
    direction, sign = found
    name = nodes_of(deck, row.integer("ID"), is_set, row.place)
    if name is None:
        deck.ledger.ignored(card.keyword, row.place, "its nodes have no element")
        return
    name = without_rigid(deck, name, card, row.place)
    motion = make_motion(deck, row, direction, sign)
    if motion and name:
        deck.model.add("conditions", {"nodes": name, **motion})
        deck.ledger.translated(card.keyword, row.place, "conditions: velocity or displacement")


def find_direction(deck: KeywordDeck, row: Row) -> tuple[str, float] | None:
    """Direction of a motion along an axis, and its sign. DOF 4 and 8 are along a vector."""
    dof, vector = row.integer("DOF"), row.integer("VID")
    if dof in DIRECTIONS:
        return DIRECTIONS[dof], 1.0
    axis = deck.vectors.get(vector, (0.0, 0.0, 0.0))
    along = [d for d in range(3) if abs(abs(axis[d]) - 1) < 1e-9]
    if abs(dof) in (4, 8) and along:
        return ("r" if abs(dof) == 8 else "") + AXES[along[0]], axis[along[0]]
    return None


def make_motion(deck: KeywordDeck, row: Row, direction: str, sign: float) -> Deck | None:
    """A condition of percuss without its nodes: velocity, displacement, or the integral of an acceleration."""
    birth, death = row.numbers("BIRTH", "DEATH")
    if birth > 0 or 0 < death < deck.end_time:
        deck.ledger.refuse("BOUNDARY_PRESCRIBED_MOTION.DEATH", row.place, "motion with a birth or death time", "it acts during the whole run")
    kind, scale = row.integer("VAD"), (row.number("SF") or 1.0) * sign
    curve = deck.curve(row.integer("LCID"), row.place)
    if kind == 1 and curve.points:
        curve = Curve(curve.place, order_points(integrate(order_points(curve.points))))
        deck.ledger.approximated("BOUNDARY_PRESCRIBED_MOTION.VAD", row.place, "the integral of the acceleration as a velocity")
    elif kind == 2 and direction.startswith("r") and len(curve.points) > 1:
        curve, kind = Curve(curve.place, differentiate(order_points(curve.points))), 0
        deck.ledger.approximated("BOUNDARY_PRESCRIBED_MOTION.VAD", row.place, "the slope of the angle as an angular velocity")
    elif kind not in (0, 2) or (kind == 2 and direction.startswith("r")):
        deck.ledger.refuse(
            "BOUNDARY_PRESCRIBED_MOTION.VAD", row.place, f"VAD {kind} in direction {direction}", "the motion is left out"
        )
        return None
    value = make_time_value(curve, scale, deck.end_time)
    return {"displacement" if kind == 2 else "velocity": {direction: value}}
