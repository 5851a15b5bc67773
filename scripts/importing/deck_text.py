"""A deck of percuss as text."""

import math
import re
from typing import Any

from .model import Deck, Model

WIDTH = 120
ORDER = (
    "time",
    "parts",
    "materials",
    "elements",
    "added_mass",
    "rigid_sets",
    "springs",
    "welds",
    "constraints",
    "joints",
    "initial",
    "start",
    "conditions",
    "loads",
    "walls",
    "contact",
    "output",
    "audit",
)
BREAK = re.compile(r", (?=[\[{]|[A-Za-z_0-9]+:)|(?<=[A-Za-z_]), (?=[A-Za-z_])")  # before an item or a key, never within a row
PLAIN = re.compile(r"[A-Za-z][A-Za-z0-9_/-]*\Z")
WORDS_OF_YAML = {"true", "false", "yes", "no", "on", "off", "null"}


def format_number(value: float) -> str:
    """The shortest text that is the same double."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int):
        return str(value)
    if not math.isfinite(value):
        raise OverflowError("a number of the deck has no bounds")
    text = repr(float(value) + 0.0)  # no -0
    mantissa, _, exponent = text.partition("e")
    if exponent:
        return f"{mantissa}e{int(exponent)}"
    text = text.removesuffix(".0")
    digits = text.lstrip("-").rstrip("0")
    if len(text) < 6 or len(text.lstrip("-")) - len(digits) < 4 or not digits:
        return text
    sign, power = "-" if text[0] == "-" else "", len(text.lstrip("-")) - 1
    return f"{sign}{digits[0]}{'.' * (len(digits) > 1)}{digits[1:]}e{power}"


def format_text(value: str) -> str:
    """A word as it is, anything else in quotes."""
    if PLAIN.match(value) and value.lower() not in WORDS_OF_YAML:
        return value
    shown = "".join(c if c.isprintable() else " " for c in value)
    return '"' + shown.replace("\\", "\\\\").replace('"', '\\"') + '"'


def format_flow(value: Any) -> str:
    """A value on one line."""
    if isinstance(value, dict):
        return "{" + ", ".join(f"{key}: {format_flow(item)}" for key, item in value.items()) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(format_flow, value)) + "]"
    return format_text(value) if isinstance(value, str) else format_number(value)


def wrap(text: str, indent: str) -> str:
    """Breaks a long line of flow style behind commas."""
    lines: list[str] = []
    while len(text) > WIDTH:
        places = [found.start() for found in BREAK.finditer(text, 0, WIDTH) if text.count('"', 0, found.start()) % 2 == 0]
        at = max(places, default=0)
        if at <= len(indent):
            break
        lines.append(text[: at + 1])
        text = indent + text[at + 2 :]
    return "\n".join([*lines, text])


def format_section(name: str, value: Any) -> str:
    """A section: one line an entry."""
    if isinstance(value, list):
        return f"{name}:\n" + "\n".join(wrap(f"  - {format_flow(item)}", "     ") for item in value)
    if isinstance(value, dict) and len(format_flow(value)) + len(name) > WIDTH - 4 or name in ("parts", "materials"):
        return f"{name}:\n" + "\n".join(format_entry(key, item) for key, item in value.items())
    return wrap(f"{name}: {format_flow(value)}", "  ")


def format_entry(key: str, item: Any) -> str:
    """An entry of a section that is a map; lists in it get a line an entry."""
    if isinstance(item, list) and item and isinstance(item[0], dict):
        return f"  {key}:\n" + "\n".join(wrap(f"    - {format_flow(entry)}", "       ") for entry in item)
    if isinstance(item, dict) and any(isinstance(v, list) and v and isinstance(v[0], dict) for v in item.values()):
        return f"  {key}:\n" + "\n".join("  " + format_entry(k, v).replace("\n", "\n  ") for k, v in item.items())
    return wrap(f"  {key}: {format_flow(item)}", "      ")


def make_parts(model: Model, mesh_file: str) -> Deck:
    """The parts, all of one mesh file."""
    parts: Deck = {}
    for block in model.blocks:
        entry: Deck = {"mesh": {"file": mesh_file, "blocks": [block.name]}}
        if block.thickness is not None:
            entry["thickness"] = {"file": True} if block.thicknesses else block.thickness
        parts[block.name] = {**entry, **block.keys}
    return parts


def list_start_remarks(deck: Deck) -> list[str]:
    """Comments: what preloads move before time 0, and that nothing is held for them."""
    if "preload" not in deck.get("start", {}):
        return []
    loads = deck.get("loads", {})
    forces = f"{'Gravity acts' if 'gravity' in loads else 'Loads act'} in them" if loads else "No load acts in them"
    held = "the conditions of the deck act; nothing is held beyond them" if deck.get("conditions") else "no condition holds the model"
    lines = [f"# Preloads are reached in damped steps before time 0. {forces}, and {held}."]
    if loads:
        lines.append("# start.relaxation.hold is empty: name there the parts or nodes that would fall or fly, such as relaxation: {hold: [PART]}.")
    return lines


def write_deck(model: Model, source: str, mesh_file: str, units: str) -> str:
    """The text of deck.yaml."""
    lines = [f"# From {clean(source)} by percuss import; import_report.md tells what became of each card."]
    if model.title:
        lines.append(f"title: {format_text(model.title[:200])}")
    if units:
        lines.append(f"units: {units}")
    sections = {**model.deck, "parts": make_parts(model, mesh_file), "materials": model.materials}
    for name in ORDER:
        if name == "start":
            lines += list_start_remarks(model.deck)
        if sections.get(name):
            lines.append(format_section(name, sections[name]))
    return "\n".join(lines) + "\n"


def clean(text: str) -> str:
    return "".join(c if c.isprintable() else "?" for c in text)
