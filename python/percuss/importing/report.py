"""What became of every card, and what the model is, for the terminal and for import_report.md."""

import json

from percuss.files import write_file
from percuss.terminal import clean

from .ledger import Entry, Ledger, Status
from .model import Model
from .shapes import measure_block
from .solids import NAMES

WIDTH = 118
TOLD = {Status.REFUSED: "refused: nothing is written", Status.LEFT_OUT: "left out or approximated, as you allow",
        Status.APPROXIMATED: "approximated", Status.IGNORED: "ignored, harmless",
        Status.TRANSLATED: "translated"}  # fmt: skip


def shorten(text: str, most: int) -> str:
    return text if len(text) <= most else text[: most - 3] + "..."


def list_rows(ledger: Ledger) -> list[tuple[Entry, str]]:
    return [(entry, f"{clean(entry.first.file).rsplit('/', 1)[-1]}:{entry.first.line}"
             + (f" and {entry.count - 1} more" if entry.count > 1 else ""))
            for entry in ledger.list_rows()]  # fmt: skip


def print_table(ledger: Ledger) -> None:
    """One line a row on the terminal, outcomes apart."""
    rows = list_rows(ledger)
    width = min(max((len(entry.card) for entry, _ in rows), default=0), 44)
    last = None
    for entry, place in rows:
        if entry.status is not last:
            print(f"{TOLD[entry.status]}:")
            last = entry.status
        text = f"  *{shorten(clean(entry.card), width):{width}}  {clean(entry.text)}"
        print(f"{shorten(text, WIDTH - len(place) - 2)}  {place}")


def summarise(model: Model, notes: list[str]) -> list[str]:
    """Mass, extent, centre, parts, counts, ids, and what the units may be."""
    nodes = model.used_nodes()
    solids = [len(corners) for block in model.blocks for _, corners in block.solids]
    others = "".join(f", {solids.count(n)} {NAMES[n]}" for n in (10, 6, 5, 4) if n in solids)
    shells = [corners for block in model.blocks for _, corners in block.shells]
    beams = sum(len(block.beams) for block in model.blocks)
    triangles = sum(1 for corners in shells if len(corners) == 3)
    lines = [f"nodes: {len(nodes)}, ids {min(nodes)} to {max(nodes)}, kept" if nodes else "nodes: none",
             f"elements: {len(solids)} solids{f' ({others[2:]} among them)' if others else ''}, "
             f"{len(shells) - triangles} quadrilaterals, {triangles} triangles"
             + (f", {beams} beams" if beams else "") + ", ids kept"]  # fmt: skip
    if len(model.nodes) > len(nodes):
        lines.append(f"nodes without elements: {len(model.nodes) - len(nodes)}, left out of the mesh and of sets")
    if nodes:
        lines += measure(model, nodes)
    return lines + notes


def measure(model: Model, nodes: set[int]) -> list[str]:
    low = [min(model.nodes[node][d] for node in nodes) for d in range(3)]
    high = [max(model.nodes[node][d] for node in nodes) for d in range(3)]
    total, moment, lines = 0.0, [0.0, 0.0, 0.0], []
    for block in model.blocks:
        mass, of_block = measure_block(model, block)
        total += mass
        moment = [a + b for a, b in zip(moment, of_block)]
        count = len(block.elements())
        lines.append(f"part {block.name}: id {block.part}, {count} elements, {block.keys['material']}, mass {mass:.6g}")
    center = [m / total if total else 0.0 for m in moment]
    texts = [", ".join(f"{x:.6g}" for x in v) for v in (low, high, center)]
    return [f"extent: {texts[0]} to {texts[1]}", f"mass: {total:.6g}, centre {texts[2]}", *lines]


def write_report(path: str, source: str, ledger: Ledger, summary: list[str]) -> None:
    """import_report.md beside the deck."""
    lines = [f"# What became of {clean(source)}", ""]
    for status in Status:
        rows = [(entry, place) for entry, place in list_rows(ledger) if entry.status is status]
        if rows:
            lines += [f"## {TOLD[status].capitalize()}", "", "| card | how | where |", "|---|---|---|"]
            lines += [f"| `*{escape(entry.card)}` | {escape(entry.text)} | {escape(place)} |" for entry, place in rows]
            lines.append("")
    lines += ["## The model", "", *(f"- {escape(line)}" for line in summary)]
    write_file(path, "\n".join(lines) + "\n", "import", force=True)


def escape(text: str) -> str:
    return clean(text).replace("|", "\\|").replace("<", "&lt;")


def write_json(path: str, source: str, ledger: Ledger, summary: list[str], mark: str) -> None:
    """The report for programs. mark: of the deck as written (earlier.py); empty: none is written."""
    cards = [{"card": entry.card, "outcome": entry.status.value, "how": entry.text, "file": entry.first.file,
              "line": entry.first.line, "count": entry.count} for entry in ledger.list_rows()]  # fmt: skip
    content = {"source": source, "cards": cards, "model": summary, "deck_sha256": mark}
    write_file(path, json.dumps(content, indent=1) + "\n", "import", force=True)
