"""Tables of numbers in text files (history.csv, ranks.csv), with Python alone."""

import csv

from .errors import NotResults


def read_lines(path):
    """(names of the columns, complete lines below them). A run that goes on may have written half of a last line."""
    try:
        with open(path, encoding="utf-8", errors="replace", newline="") as file:
            text = file.read()
    except OSError as error:
        raise NotResults(f"{path}: cannot be read ({error.strerror})") from error
    lines = text[: text.rfind("\n") + 1].split("\n")[:-1]
    if not lines:
        raise NotResults(f"{path}: there is no heading in it (the run has only begun, or it is no table)")
    names = next(csv.reader(lines[:1]))
    if len(set(names)) != len(names):
        raise NotResults(f"{path}: two columns have one name")
    return names, [line for line in lines[1:] if line]


def read_rows(path, last=None):
    """(names, rows of floats); only the `last` so many rows where asked for."""
    names, lines = read_lines(path)
    if last is not None:
        lines = lines[-last:]
    try:
        rows = [[float(word) for word in line.split(",")] for line in lines]
    except ValueError as error:
        raise NotResults(f"{path}: there is no number ({error})") from error
    return names, [row for row in rows if len(row) == len(names)]
