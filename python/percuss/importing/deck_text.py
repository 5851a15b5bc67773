"""A deck of percuss as text, written by PyYAML: one line an entry of a section."""

import io
import math
import re
from typing import Any

import yaml

from percuss.terminal import clean

from .model import Deck, Model
from .own_values import list_silenced

WIDTH = 110  # at which a line of flow style goes on in the next
LONGEST = 1 << 30  # of what is not broken
ORDER = (
    "time",
    "parts",
    "mirror",
    "pattern",
    "place",
    "materials",
    "elements",
    "imperfections",
    "added_mass",
    "rigid_sets",
    "springs",
    "welds",
    "constraints",
    "embedded",
    "joints",
    "turn_springs",
    "join",
    "initial",
    "start",
    "sensors",
    "conditions",
    "loads",
    "damping",
    "walls",
    "contact",
    "erosion",
    "output",
    "audit",
    "silence",
)
FLOAT, INTEGER, TEXT = (f"tag:yaml.org,2002:{kind}" for kind in ("float", "int", "str"))


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


class Dumper(yaml.SafeDumper):
    """Numbers in their shortest form; the rest as the library writes it.
    What it does not know, None included, is an error."""

    def ignore_aliases(self, data: Any) -> bool:
        return True

    def write_number(self, value: float) -> yaml.Node:
        text = format_number(value)
        return self.represent_scalar(FLOAT if "." in text or "e" in text else INTEGER, text)

    def write_text(self, value: str) -> yaml.Node:
        return self.represent_scalar(TEXT, "".join(c if c.isprintable() else " " for c in value))

    def refuse_none(self, _: None) -> yaml.Node:
        raise yaml.representer.RepresenterError("None stands in the deck")


for kind, writer in ((float, Dumper.write_number), (int, Dumper.write_number), (str, Dumper.write_text),
                     (tuple, Dumper.represent_list), (type(None), Dumper.refuse_none)):  # fmt: skip
    Dumper.add_representer(kind, writer)  # type: ignore[arg-type]
# What YAML 1.2 and percuss take for a number: 1e5 is written plain as a number, and quoted as a text.
NUMBER = re.compile(r"[-+]?((\.\d+|\d+\.?\d*)([eE][-+]?\d+)?|nan|inf)\Z", re.IGNORECASE)
Dumper.add_implicit_resolver(FLOAT, NUMBER, list("-+.0123456789nNiI"))  # type: ignore[no-untyped-call]


def dump(entry: Any, width: int = WIDTH) -> str:
    """A map or a list of one entry, which is in flow style."""
    dumper = Dumper(io.StringIO(), sort_keys=False)
    node = dumper.represent_data(entry)
    node.flow_style = False  # type: ignore[attr-defined]
    for child in node.value:
        for part in child if isinstance(child, tuple) else (child,):
            part.flow_style = True
    return str(yaml.serialize(node, Dumper=Dumper, width=width, allow_unicode=True))


def holds_maps(value: Any) -> bool:
    return isinstance(value, (list, tuple)) and any(isinstance(item, dict) for item in value)


def format_entry(name: str, value: Any) -> str:
    """An entry of a map on one line; where that is too long, a line for each of its own entries."""
    line = dump({name: value})
    if line.count("\n") == 1:
        return line
    head = dump({name: 0}).removesuffix(" 0\n") + "\n"
    if isinstance(value, dict) and any(holds_maps(item) or isinstance(item, dict) for item in value.values()):
        return head + "".join(indent(format_entry(key, item)) for key, item in value.items())
    return head + "".join(indent(dump([item])) for item in value) if holds_maps(value) else line


def indent(text: str) -> str:
    return "".join("  " + line for line in text.splitlines(keepends=True))


def format_section(name: str, value: Any) -> str:
    """A section: one line an entry, or one line where it is a short map."""
    if isinstance(value, dict) and name in ("parts", "materials"):
        return f"{name}:\n" + "".join(indent(format_entry(key, item)) for key, item in value.items())
    if holds_maps(value):
        return f"{name}:\n" + "".join(indent(dump([item])) for item in value)
    line = dump({name: value})
    if not isinstance(value, dict) or line.count("\n") == 1:
        return line
    return f"{name}:\n" + "".join(indent(format_entry(key, item)) for key, item in value.items())


def make_parts(model: Model, mesh_file: str) -> Deck:
    """The parts, all of one mesh file."""
    parts: Deck = {}
    for block in model.blocks:
        entry: Deck = {"mesh": {"file": mesh_file, "blocks": [block.name]}}
        if block.thickness is not None and "plies" not in block.keys:
            entry["thickness"] = {"file": True} if block.thicknesses else block.thickness
        parts[block.name] = {**entry, **block.keys}
    return parts


def list_start_remarks(deck: Deck) -> list[str]:
    """Comments: what preloads move before time 0, and that nothing is held for them."""
    if "preload" not in deck.get("start", {}):
        return []
    loads = deck.get("loads", {})
    forces = f"{'Gravity acts' if 'gravity' in loads else 'Loads act'} in them" if loads else "No load acts in them"
    held = ("the conditions of the deck act; nothing is held beyond them" if deck.get("conditions")
            else "no condition holds the model")
    lines = [f"# Preloads are reached in damped steps before time 0. {forces}, and {held}."]
    if loads:
        lines.append("# start.relaxation.hold is empty: name there the parts or nodes that would fall or fly, "
                     "such as relaxation: {hold: [PART]}.")
    return lines


def write_deck(model: Model, source: str, mesh_file: str, units: str) -> str:
    """The text of deck.yaml, with every section of the model."""
    sections: Deck = {**model.deck, "silence": list_silenced(model), "parts": make_parts(model, mesh_file),
                      "materials": model.materials}
    unknown = sorted(set(sections) - set(ORDER))
    if unknown:
        raise RuntimeError(f"the importer has no place in the deck for the section {', '.join(unknown)}")
    texts = [f"# From {clean(source)} by percuss import; import_report.md says what became of each card.\n"]
    if model.title:
        texts.append(dump({"title": model.title[:200]}, LONGEST))
    if units:
        texts.append(dump({"units": units}, LONGEST))
    for name in ORDER:
        if name == "start":
            texts += [line + "\n" for line in list_start_remarks(model.deck)]
        if sections.get(name):
            texts.append(format_section(name, sections[name]))
    return "".join(texts)
