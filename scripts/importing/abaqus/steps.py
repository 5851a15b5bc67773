"""Conditions, loads, contact and output of the model and its step."""

from ..curves import Curve, make_time_value, order_points
from ..fields import clip
from ..ledger import Place
from ..model import Deck
from .bodies import hold_reference
from .deck import AbaqusDeck
from .heat import read_temperature
from .lines import Block
from .stresses import read_hardening, read_stresses
from .surfaces import is_profile

AXES = ("x", "y", "z", "rx", "ry", "rz")
NAMED = {"ENCASTRE": AXES, "PINNED": AXES[:3], "XSYMM": ("x", "ry", "rz"), "YSYMM": ("y", "rx", "rz"), "ZSYMM": ("z", "rx", "ry"),
         "XASYMM": ("y", "z", "rx"), "YASYMM": ("x", "z", "ry"), "ZASYMM": ("x", "y", "rz")}  # fmt: skip
INSTEAD = "it is left out"


def read_amplitude(deck: AbaqusDeck, block: Block) -> None:
    """TABULAR and SMOOTH STEP."""
    kind, name = block.option("DEFINITION") or "TABULAR", block.option("NAME")
    values = [block.number(line, i) for line in block.lines for i in range(len(line[1])) if line[1][i]]
    points = list(zip(values[::2], values[1::2]))
    if kind not in ("TABULAR", "SMOOTH STEP") or not points:
        deck.ledger.ignored("AMPLITUDE", block.place, f"of the kind {kind}, not read; what uses it is refused")
        return
    curve = Curve(block.place, order_points(points))
    if kind == "SMOOTH STEP":
        curve.points = smooth(curve.points)
        deck.ledger.approximated("AMPLITUDE", block.place, "a smooth step by 16 rows")
    deck.amplitudes[name] = curve
    deck.ledger.translated("AMPLITUDE", block.place, "a table where something uses it")


def smooth(points: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Each step by 16 rows of 10 s^3 - 15 s^4 + 6 s^5."""
    rows = [points[0]]
    for (t0, a0), (t1, a1) in zip(points, points[1:]):
        for i in range(1, 17):
            s = i / 16
            rows.append((t0 + (t1 - t0) * s, a0 + (a1 - a0) * s**3 * (10 - 15 * s + 6 * s * s)))
    return rows


def time_value(deck: AbaqusDeck, block: Block, value: float) -> "float | Deck":
    """A value over time. Without an amplitude it acts at once; amplitudes hold their ends."""
    curve = deck.amplitude(block.option("AMPLITUDE"), block.place)
    if curve is None:
        return value
    (first, start), (last, end) = curve.points[0], curve.points[-1]
    held = [(min(first, 0.0), start), *curve.points[first <= 0 :], (max(last, deck.end_time) * 1.01, end)]
    return make_time_value(Curve(curve.place, order_points(held)), value, deck.end_time)


def read_boundary(deck: AbaqusDeck, block: Block) -> None:
    """set, ENCASTRE; or set, first, last, value, of displacements or velocities."""
    for line in block.lines:
        word = block.text(line, 1).upper()
        if word in NAMED:
            directions, value = list(NAMED[word]), 0.0
        else:
            first = block.integer(line, 1, 1)
            last = block.integer(line, 2, first) or first
            if not 1 <= first <= last <= 6:
                deck.ledger.refuse("BOUNDARY.dof", block.at(line[0]), f"directions {first} to {last}, beyond 1 to 6", "these are left out")
            directions, value = [AXES[i - 1] for i in range(max(first, 1), min(last, 6) + 1)], block.number(line, 3)
        if hold_references(deck, block, line, directions, value):
            continue
        name = deck.node_set_name(block.text(line, 0), block.at(line[0]))
        if not name:
            deck.ledger.ignored("BOUNDARY", block.at(line[0]), "its nodes have no element")
        else:
            add_condition(deck, block, line, name, directions, value)


def add_condition(
    deck: AbaqusDeck, block: Block, line: tuple[int, list[str]], name: str, directions: list[str], value: float
) -> None:
    turning = deck.model.turning_nodes()
    if not any(node in turning for node in deck.model.node_sets[name]):
        directions = [d for d in directions if d in AXES[:3]]
    entry = make_motion(deck, block, line, directions, value) if directions else None
    if entry:
        deck.model.add("conditions", {"nodes": name, **entry})
        deck.ledger.translated("BOUNDARY", block.at(line[0]), "conditions")


def make_motion(deck: AbaqusDeck, block: Block, line: tuple[int, list[str]], directions: list[str], value: float) -> Deck | None:
    """What a condition does in some directions; None where it is refused."""
    kind = block.option("TYPE") or "DISPLACEMENT"
    if value == 0:
        return {"fixed": directions}
    if kind == "VELOCITY":
        return {"velocity": {d: time_value(deck, block, value) for d in directions}}
    if kind == "DISPLACEMENT" and "AMPLITUDE" in block.options and not any(d.startswith("r") for d in directions):
        return {"displacement": {d: time_value(deck, block, value) for d in directions}}
    deck.ledger.refuse(
        "BOUNDARY.TYPE",
        block.at(line[0]),
        f"a {kind.lower()} of {', '.join(directions)}, or without an amplitude",
        "it is left out",
    )
    return None


def hold_references(deck: AbaqusDeck, block: Block, line: tuple[int, list[str]], directions: list[str], value: float) -> bool:
    """Conditions on reference nodes of rigid bodies act on these. Whether no other node is left."""
    nodes = deck.nodes_of(block.text(line, 0), block.at(line[0]))
    if not any(node in deck.group_of_ref for node in nodes):
        return False
    for direction in directions:
        motion = make_motion(deck, block, line, [direction], value)
        if motion:
            hold_reference(deck, nodes, [direction], None if "fixed" in motion else motion)
    deck.ledger.translated("BOUNDARY", block.at(line[0]), "what holds a rigid body")
    return all(node in deck.group_of_ref for node in nodes)


def read_initial(deck: AbaqusDeck, block: Block) -> None:
    """set, dof, velocity."""
    if block.option("TYPE") == "TEMPERATURE":
        read_temperature(deck, block)
        return
    if block.option("TYPE") == "STRESS":
        read_stresses(deck, block)
        return
    if block.option("TYPE") == "HARDENING":
        read_hardening(deck, block)
        return
    if block.option("TYPE") != "VELOCITY":
        deck.ledger.refuse("INITIAL CONDITIONS", block.place, f"initial conditions of type {clip(block.option('TYPE'))}", INSTEAD)
        return
    for line in block.lines:
        dof, value = block.integer(line, 1), block.number(line, 2)
        if dof not in (1, 2, 3):
            deck.ledger.refuse("INITIAL CONDITIONS.dof", block.at(line[0]), "an initial rotational velocity of nodes", INSTEAD)
            continue
        nodes = deck.nodes_of(block.text(line, 0), block.at(line[0]))
        for node in {n for ref in nodes for n in (deck.group_of_ref[ref].nodes if ref in deck.group_of_ref else [ref])}:
            deck.velocities.setdefault(node, [0.0, 0.0, 0.0])[dof - 1] = value
    deck.ledger.translated("INITIAL CONDITIONS", block.place, "initial: velocity")


def add_velocities(deck: AbaqusDeck) -> None:
    """A node set for each velocity."""
    groups: dict[tuple[float, ...], list[int]] = {}
    for node, velocity in deck.velocities.items():
        moved = [node] if node in deck.used_nodes() else []
        if node in deck.group_of_ref:
            moved = sorted(deck.group_of_ref[node].nodes)
        groups.setdefault(tuple(velocity), []).extend(moved)
    for index, (of_group, members) in enumerate(groups.items(), 1):
        nodes = list(dict.fromkeys(members))
        if not nodes:
            continue
        is_all = len(nodes) == len(deck.used_nodes())
        entry: Deck = {} if is_all else {"nodes": name_nodes(deck, nodes, f"moving_{index}")}
        deck.model.add("initial", {**entry, "velocity": list(of_group)})


def name_nodes(deck: AbaqusDeck, nodes: list[int], wish: str) -> str:
    """The part that has just these nodes, or a set."""
    wanted = set(nodes)
    for block in deck.model.blocks:
        if deck.model.nodes_of_blocks([block.id]) == wanted:
            return block.name
    return deck.model.add_node_set(wish, nodes)


def read_node_force(deck: AbaqusDeck, block: Block) -> None:
    """*CLOAD: node or set, dof, magnitude."""
    if "FOLLOWER" in block.options:
        deck.ledger.refuse("CLOAD.FOLLOWER", block.place, "follower forces", INSTEAD)
        return
    for line in block.lines:
        name, dof = deck.node_set_name(block.text(line, 0), block.at(line[0])), block.integer(line, 1)
        if not name or not 1 <= dof <= 6:
            deck.ledger.refuse(
                "CLOAD.dof", block.at(line[0]), f"a load on direction {dof} of '{clip(block.text(line, 0))}'", INSTEAD
            )
            continue
        kind = "force" if dof <= 3 else "moment"
        value = time_value(deck, block, block.number(line, 2))
        deck.model.deck.setdefault("loads", {}).setdefault("nodal", []).append({"nodes": name, kind: {AXES[(dof - 1) % 3]: value}})
        deck.ledger.translated("CLOAD", block.at(line[0]), "loads.nodal")


def read_distributed(deck: AbaqusDeck, block: Block) -> None:
    """*DLOAD with GRAV, *DSLOAD with P."""
    for line in block.lines:
        label_at = 1
        label = block.text(line, label_at).upper()
        if label == "GRAV" and "AMPLITUDE" not in block.options:
            size, axis = block.number(line, 2), [block.number(line, i) for i in (3, 4, 5)]
            gravity = deck.model.deck.setdefault("loads", {}).setdefault("gravity", [0.0, 0.0, 0.0])
            for d in range(3):
                gravity[d] += size * axis[d]
            deck.ledger.approximated("DLOAD", block.at(line[0]), "gravity acts on all parts")
        elif block.keyword == "DSLOAD" and label == "P":
            name = deck.surface_name(block.text(line, 0), block.at(line[0]), of_contact=False)
            if name:
                value = time_value(deck, block, block.number(line, 2))
                deck.model.deck.setdefault("loads", {}).setdefault("pressure", []).append({"faces": name, "value": value})
                deck.ledger.translated("DSLOAD", block.at(line[0]), "loads.pressure")
        else:
            deck.ledger.refuse(
                f"{block.keyword}.{label or 'blank'}", block.at(line[0]), f"a distributed load {clip(label)}", INSTEAD
            )


def read_tie(deck: AbaqusDeck, block: Block) -> None:
    """slave, master."""
    for line in block.lines:
        place = block.at(line[0])
        slave, master = block.text(line, 0), block.text(line, 1)
        if slave.upper() in deck.mesh.node_surfaces:
            nodes = [
                n for name in deck.mesh.node_surfaces[slave.upper()] for n in deck.nodes_of(name, place) if n in deck.used_nodes()
            ]
            a = deck.model.add_node_set(slave, nodes) if nodes else ""
        else:
            a = deck.surface_name(slave, place, of_contact=True)
        b = deck.surface_name(master, place, of_contact=True)
        if not a or not b:
            deck.ledger.refuse("TIE", place, "a tie with a surface without elements", INSTEAD)
            continue
        entry: Deck = {"a": a, "b": b}
        if block.option("POSITION TOLERANCE"):
            entry["distance"] = block.number((line[0], [block.option("POSITION TOLERANCE")]), 0)
        if deck.ledger.allows("TIE.empty"):  # found by the run, which knows the reach
            entry["empty"] = "ignore"
            deck.ledger.approximated("TIE.empty", place, "a tie in reach of nothing is told by the run, and ignored")
        deck.model.deck.setdefault("contact", {}).setdefault("ties", []).append(entry)
        deck.ledger.approximated("TIE", place, "contact.ties: gaps stay as they are")


def read_contact_pair(deck: AbaqusDeck, block: Block) -> None:
    friction = deck.frictions.get(block.option("INTERACTION"), 0.0)
    for line in block.lines:
        place = block.at(line[0])
        if is_profile(deck, block.text(line, 1)):
            note_wall_pair(deck, block.text(line, 0), block.text(line, 1), place, friction)
            continue
        a = deck.surface_name(block.text(line, 0), place, of_contact=True)
        b = deck.surface_name(block.text(line, 1), place, of_contact=True) if block.text(line, 1) else a
        if a and b:
            deck.pairs.append({"a": a, "b": b, "friction": friction})
            deck.ledger.translated("CONTACT PAIR", place, "contact.surfaces")
        else:
            deck.ledger.ignored("CONTACT PAIR", place, "one of its surfaces has no element")


def note_wall_pair(deck: AbaqusDeck, nodes: str, wall: str, place: Place, friction: float) -> None:
    """A surface before an analytical one."""
    name = deck.surface_name(nodes, place, of_contact=True)
    if name:
        deck.wall_pairs.append((wall.strip().strip('"').upper(), name, friction))
        deck.ledger.translated("CONTACT PAIR", place, "walls.N.nodes")


def read_inclusions(deck: AbaqusDeck, block: Block) -> None:
    """*CONTACT INCLUSIONS: everything, or pairs."""
    if "ALL EXTERIOR" in block.options:
        deck.whole = deck.whole or {"a": "all", "b": "all", "friction": 0.0}
        deck.ledger.translated("CONTACT INCLUSIONS", block.place, "contact.surfaces: all")
        return
    read_contact_pair(deck, block)


def read_property(deck: AbaqusDeck, block: Block) -> None:
    """*CONTACT PROPERTY ASSIGNMENT: blank, blank, interaction for all."""
    for line in block.lines:
        friction = deck.frictions.get(block.text(line, 2).upper(), 0.0)
        if not block.text(line, 0) and not block.text(line, 1):
            deck.whole = {"a": "all", "b": "all", "friction": friction}
            deck.ledger.translated(block.keyword, block.at(line[0]), "contact.friction")
        else:
            assign_friction(deck, block, (block.text(line, 0), block.text(line, 1)), block.at(line[0]), friction)


def assign_friction(deck: AbaqusDeck, block: Block, names: tuple[str, str], place: Place, friction: float) -> None:
    """That of two surfaces, or of everything with one. The last that names both counts in Abaqus, the first here."""
    if not names[1]:
        deck.ledger.refuse(block.keyword, place, "a friction of one surface, in general contact", "that of all is used")
        return
    sides = [deck.surface_name(name, place, of_contact=True) for name in reversed(names) if name]
    if not all(sides):
        deck.ledger.ignored(block.keyword, place, "one of its surfaces has no element")
        return
    row = dict(zip("ab", sides))
    others = [r for r in deck.pair_frictions if {r["a"], r.get("b")} != {row["a"], row.get("b")}]
    deck.pair_frictions = [{**row, "friction": friction}, *others]
    deck.ledger.translated(block.keyword, place, "contact.friction.pairs")


def finish_contact(deck: AbaqusDeck) -> None:
    section = deck.model.deck.setdefault("contact", {})
    if deck.whole and not deck.pairs:
        section["surfaces"] = "all"
        if deck.whole["friction"]:
            section["friction"] = deck.whole["friction"]
    elif deck.pairs:
        section["surfaces"] = deck.pairs + ([deck.whole] if deck.whole else [])
    elif "ties" in section:
        section["surfaces"] = "none"
    else:
        del deck.model.deck["contact"]
    if deck.pair_frictions and deck.model.deck.get("contact") and section["surfaces"] != "none":
        section["friction"] = {"default": section.get("friction", 0.0), "pairs": deck.pair_frictions}
