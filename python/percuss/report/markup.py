"""Pieces of HTML; every text of a run is escaped here."""

import html
import re
from collections.abc import Collection, Iterable, Sequence
from typing import Any


def escape(text: object) -> str:
    return html.escape(str(text), quote=True)


def make_table(heading: Sequence[str] | None, rows: Iterable[Sequence[object]], numbers: Collection[int] = ()) -> str:
    """heading: texts, or None. numbers: columns that stand at the right. Cells are texts, or Markup as it is."""
    def cell(tag: str, column: int, value: object) -> str:
        text = value if isinstance(value, Markup) else escape(value)
        return f"<{tag}{' class=number' if column in numbers else ''}>{text}</{tag}>"

    def row(tag: str, values: Sequence[object]) -> str:
        return "<tr>" + "".join(cell(tag, column, value) for column, value in enumerate(values)) + "</tr>"

    head = row("th", heading) if heading else ""
    return f"<table>{head}{''.join(row('td', values) for values in rows)}</table>"


def make_filled_table(heading: Sequence[str], rows: Sequence[Sequence[object]], numbers: Collection[int] = ()) -> str:
    """The same without columns in which no row has anything."""
    kept = [column for column in range(len(heading)) if any(row[column] for row in rows)]
    return make_table([heading[c] for c in kept], [[row[c] for c in kept] for row in rows], numbers)


class Markup(str):
    """A text that is HTML already."""


def fold(title: str, content: str) -> str:
    return f"<details><summary>{escape(title)}</summary>{content}</details>"


def show_deck(text: str) -> str:
    """YAML with its comments in grey."""
    lines = []
    for line in text.splitlines():
        match = re.match(r"""((?:[^#'"]|'[^']*'|"[^"]*"|(?<=\S)#)*)(#.*)?$""", line)
        before, comment = (match[1], match[2]) if match else (line, None)
        lines.append(escape(before) + (f"<span class=comment>{escape(comment)}</span>" if comment else ""))
    return "<pre>" + "\n".join(lines) + "</pre>"


def format_number(value: Any) -> str:
    """Six digits at most; lists and texts as they are."""
    if isinstance(value, bool) or value is None:
        return {True: "yes", False: "no", None: "-"}[value]
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, (list, tuple)):
        return "(" + ", ".join(format_number(item) for item in value) + ")"
    if isinstance(value, dict):
        return ", ".join(f"{key} {format_number(item)}" for key, item in value.items())
    return str(value)


def show_value(value: float, unit: str, digits: int = 4) -> str:
    """A number of a few digits with its unit."""
    return with_unit(float(f"{value:.{digits}g}"), unit)


def with_unit(value: Any, unit: str) -> str:
    return f"{format_number(value)} {unit}".rstrip()
