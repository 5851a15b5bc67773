"""Tables of numbers in text files (history.csv, ranks.csv), with Python alone."""

import csv

from ..errors import NotResults
from ..files import read_text


def read_lines(path: str) -> tuple[list[str], list[str]]:
    """(names of the columns, complete lines below them). A run that goes on may have written half of a last line."""
    text = read_text(path)
    lines = text[: text.rfind("\n") + 1].split("\n")[:-1]
    if not lines:
        raise NotResults(f"{path}: there is no heading in it (the run has only begun, or it is no table)")
    return read_heading(path, lines[0]), [line for line in lines[1:] if line]


def read_heading(path: str, line: str) -> list[str]:
    """Names of the columns, each of which there is once."""
    try:
        names = next(csv.reader([line]))
    except csv.Error as error:
        raise NotResults(f"{path}: its heading cannot be read ({error})") from error
    if not all(names) or len(set(names)) != len(names):
        raise NotResults(f"{path}: a column has no name, or two have one")
    return names


def parse_row(line: str, count: int) -> list[float] | None:
    """The numbers of a line; None if there are not so many, or one is none."""
    try:
        row = [float(word) for word in line.split(",")]
    except ValueError:
        return None
    return row if len(row) == count else None


def read_rows(path: str, last: int | None = None) -> tuple[list[str], list[list[float]]]:
    """(names, rows of floats); only the `last` so many rows where asked for."""
    names, lines = read_lines(path)
    if last is not None:
        lines = lines[-last:]
    rows = []
    for line in lines:
        row = parse_row(line, len(names))
        if row is None:
            raise NotResults(f"{path}: this is no row of {len(names)} numbers: '{line[:60]}'")
        rows.append(row)
    return names, rows
