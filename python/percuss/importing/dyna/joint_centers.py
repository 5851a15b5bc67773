"""Bodies that joints let turn while they are held across the axis: they can turn about their mass centres alone,
which therefore lie on the axis."""

import math

from ..model import Block, Deck, Vector
from ..shapes import dot, make_vector, measure_block, normalise, subtract
from .deck import JointCard, KeywordDeck

AXES = ("x", "y", "z")
TURNING = ("revolute", "cylindrical", "screw")
ROUND_OFF = 1e-9  # share of the extent of the model
MOST_OFF = 0.01  # likewise: farther off it is another mechanism


def center_bodies(deck: KeywordDeck, joint: JointCard, entry: Deck, extent: float) -> str:
    """Puts the centres of bodies that are held across the axis on it. Why they cannot turn; empty: they can."""
    axis = normalise(make_vector(entry["axis"])) if entry["kind"] in TURNING else (0.0, 0.0, 0.0)
    k = max(range(3), key=lambda d: abs(axis[d]))
    held = {body: find_held(deck, body) for body in entry["bodies"]}
    if abs(axis[k]) < 1 - ROUND_OFF or not all(set(AXES) - {AXES[k]} <= directions for directions in held.values()):
        return ""
    for body in (body for body in held if f"r{AXES[k]}" not in find_fixed(deck, body)):
        blocks = list_blocks(deck, body)
        center = deck.body_centers.get(body) or find_center(deck, blocks)
        if not blocks or center is None:
            continue
        way = subtract(tuple(center), tuple(entry["at"]))  # type: ignore[arg-type]
        on_axis = tuple(p + dot(way, axis) * a for p, a in zip(entry["at"], axis, strict=True))
        off = math.dist(center, on_axis)
        if off > MOST_OFF * extent:
            return (f"a joint whose axis is {off:.3g} off the mass centre of '{body}', which is held across it "
                    "(it cannot turn)")
        if off > ROUND_OFF * extent:
            text = (f"the mass centre of '{body}', which is held across the axis, lies on the axis, "
                    f"and not {off:.3g} off it")
            deck.ledger.approximated(f"{joint.card}.center", joint.place, text)
        rigid = blocks[0].keys["rigid"]
        blocks[0].keys["rigid"] = {**(rigid if isinstance(rigid, dict) else {}), "center": list(on_axis)}
    return ""


def find_held(deck: KeywordDeck, body: str) -> set[str]:
    """Directions of a body that cards hold or move."""
    held = set(deck.held_of_body.get(body, []))
    for condition in deck.model.deck.get("conditions", []):
        if condition.get("body") == body:
            held.update(condition.get("fixed", []), condition.get("velocity", {}), condition.get("displacement", {}))
    return held


def find_fixed(deck: KeywordDeck, body: str) -> set[str]:
    """Directions in which a body never moves; one that is driven turns."""
    conditions = [condition for condition in deck.model.deck.get("conditions", []) if condition.get("body") == body]
    return {*deck.held_of_body.get(body, []),
            *(direction for condition in conditions for direction in condition.get("fixed", []))}


def list_blocks(deck: KeywordDeck, body: str) -> list[Block]:
    """Blocks of a body of rigid parts, of which the first gives its name; none of a body of nodes."""
    found = [block for block in deck.model.blocks if block.name == body and block.keys.get("rigid")]
    others = [block for block in deck.model.blocks
              if isinstance(block.keys.get("rigid"), dict) and block.keys["rigid"].get("body") == body]
    return found + [block for block in others if block not in found]


def find_center(deck: KeywordDeck, blocks: list[Block]) -> Vector | None:
    """Mass centre of the elements."""
    measures = [measure_block(deck.model, block) for block in blocks]
    mass = sum(own for own, _ in measures)
    return (sum(m[0] for _, m in measures) / mass, sum(m[1] for _, m in measures) / mass,
            sum(m[2] for _, m in measures) / mass) if mass > 0 else None
