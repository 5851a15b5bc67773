"""The deck of a run as data: the values that were run, with what --set changed in them.
No tool reads the deck's file again."""

import json
import os
import re
from collections.abc import Iterable
from typing import Any

from ..errors import NotResults


class Deck:
    """Attributes: values (a tree of dictionaries and lists; empty where nothing is known), file (that it was read
    from), settings (the arguments of --set, which the values have already)."""

    def __init__(self, values: Any = None, file: str = "", settings: Iterable[str] = ()) -> None:
        self.values: dict[str, Any] = values if isinstance(values, dict) else {}
        self.file, self.settings = file, list(settings)

    def __bool__(self) -> bool:
        return bool(self.values)

    def get(self, path: str, default: Any = None) -> Any:
        """A value by its path, such as 'time.end' or 'initial.0.velocity'."""
        found: Any = self.values
        for word in path.split("."):
            try:
                found = found[int(word)] if isinstance(found, list) else found[word]
            except (KeyError, IndexError, TypeError, ValueError):
                return default
        return found

    def get_map(self, path: str) -> dict[str, Any]:
        """A value where a map is expected: {} if there is none."""
        found = self.get(path)
        return found if isinstance(found, dict) else {}

    def get_list(self, path: str) -> list[Any]:
        found = self.get(path)
        return found if isinstance(found, list) else []

    @property
    def text(self) -> str:
        """The values as YAML, without the comments that the file may have."""
        return write_yaml(self.values) if self.values else ""


def find_deck(summary: dict[str, Any], folder: str) -> Deck:
    """The deck of summary.json; where that has none, the one of the checkpoint."""
    known = summary.get("deck")
    if known:
        return Deck(known["values"], known["file"], known["settings"])
    return _read_checkpoint(os.path.join(folder, "checkpoint.h5"))


def _read_checkpoint(path: str) -> Deck:
    if not os.path.isfile(path):
        return Deck()
    try:
        import h5py

        with h5py.File(path, "r") as file:
            data = file["percuss_checkpoint/values"]
            return Deck(json.loads(bytes(data[:]).decode("utf-8", "replace")))
    except (ImportError, OSError, KeyError, TypeError, ValueError, RuntimeError, RecursionError, NotResults):
        return Deck()


# --- YAML -------------------------------------------------------------------------------------------------------------

WIDTH = 120  # of a line with a map or a list in it
_PLAIN = re.compile(r"[A-Za-z_][A-Za-z0-9_./+-]*( [A-Za-z0-9_./+-]+)*")
_WORDS = ("true", "false", "null", "yes", "no", "on", "off", "nan", "inf", "y", "n")


def write_yaml(values: dict[str, Any], indent: str = "") -> str:
    """A tree of dictionaries and lists as YAML that percuss reads back to the same values."""
    return "".join(_write_entry(key, value, indent) for key, value in values.items())


def _write_entry(key: str, value: Any, indent: str) -> str:
    short = f"{indent}{_write_word(key)}: {_write_flow(value)}"
    if len(short) <= WIDTH or not value or not isinstance(value, (dict, list)):
        return short + "\n"
    head = f"{indent}{_write_word(key)}:\n"
    if isinstance(value, dict):
        return head + write_yaml(value, indent + "  ")
    return head + "".join(f"{indent}  - {_write_flow(item)}\n" for item in value)


def _write_flow(value: Any) -> str:
    if isinstance(value, dict):
        return "{" + ", ".join(f"{_write_word(key)}: {_write_flow(item)}" for key, item in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(_write_flow(item) for item in value) + "]"
    if value is None or isinstance(value, bool):
        return json.dumps(value)
    return _write_word(value) if isinstance(value, str) else repr(value)


def _write_word(value: Any) -> str:
    """A text: plain where nobody could take it for anything else, else in quotes, which JSON and YAML share."""
    text = str(value)
    return text if _PLAIN.fullmatch(text) and text.lower() not in _WORDS else json.dumps(text)
