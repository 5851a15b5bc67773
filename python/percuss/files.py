"""Files of the tools: the one place that loads JSON and checks it, and the one that writes."""

import json
import os
import secrets
from collections.abc import Iterable
from typing import Any

from .errors import NotResults

MARK = "Written by percuss "  # in every file that a tool writes and may replace
MOST_JSON = 256 << 20  # bytes
MARKED_BYTES = 65536  # at both ends of a file, where its mark stands

# What runs write. No tool replaces such a file, with --force neither.
_RESULTS = ("summary.json", "history.csv", "columns.json", "ranks.csv", "run_deck.yaml", "run.lock", "checkpoint.h5",
            "checkpoint_previous.h5")
FRAME_ENDINGS = (".vtkhdf", ".exo")  # of what frame_formats() of src/output writes
_RESULT_ENDINGS = (*FRAME_ENDINGS, ".xdmf", ".xdmf2")


class Refused(NotResults):
    """A file is not overwritten; str() is a message for the user."""


# --- reading ----------------------------------------------------------------------------------------------------------


def read_text(path: str | os.PathLike[str]) -> str:
    """The text of a regular file, without a byte order mark; bytes that are no UTF-8 become U+FFFD."""
    try:
        if os.path.exists(path) and not os.path.isfile(path):
            raise NotResults(f"{path}: this is no regular file")
        with open(path, encoding="utf-8-sig", errors="replace", newline="") as file:
            return file.read()
    except (OSError, ValueError) as error:  # ValueError: a zero byte in the name
        raise NotResults(f"{path}: cannot be read ({getattr(error, 'strerror', None) or error})") from error


def load_json(path: str, shape: Any = None) -> Any:
    """The content of a JSON file, checked against a shape (see find_fault), with NaN for numbers that are null."""
    try:
        if os.path.isfile(path) and os.path.getsize(path) > MOST_JSON:
            raise NotResults(f"{path}: this is too large for what it is to be ({os.path.getsize(path)} bytes)")
        content = json.loads(read_text(path))
    except (OSError, ValueError, RecursionError) as error:
        raise NotResults(f"{path}: this is no JSON ({error or 'too deep'})") from error
    if shape is not None and (problem := find_fault(content, shape)):
        raise NotResults(f"{path}: this was not written by percuss, or is damaged ({problem})")
    return content if shape is None else restore_numbers(content, shape)


class Optional:
    """A value that may be absent."""

    def __init__(self, shape: Any) -> None:
        self.shape = shape


class MapOf:
    """An object whose values all have one shape."""

    def __init__(self, shape: Any) -> None:
        self.shape = shape


WHOLE, TEXT, ANY, OBJECT = "a whole number", "a text", "anything", "an object"
NUMBER, TEXT_OR_NULL = "a number or null", "a text or null"  # JSON has no numbers that are not finite: they are null
_TYPES: dict[str, Any] = {WHOLE: int, TEXT: str, NUMBER: (int, float, type(None)), TEXT_OR_NULL: (str, type(None)),
                          OBJECT: dict}


def find_fault(content: Any, shape: Any, place: str = "") -> str:
    """What of the content does not have its shape; empty if all has. A shape is a name of _TYPES, ANY, [shape of the
    items], [shape, number of items], MapOf, or {key: shape}, which lets other keys be; values may be Optional."""
    where = f"'{place}'" if place else "it"
    if shape == ANY:
        return ""
    if isinstance(shape, str):
        good = isinstance(content, _TYPES[shape]) and not isinstance(content, bool)
        return "" if good and not _is_absurd(content) else f"{where} is not {shape}"
    if isinstance(shape, list):
        if not isinstance(content, list) or (len(shape) > 1 and len(content) != shape[1]):
            return f"{where} is not a list" + (f" of {shape[1]}" if len(shape) > 1 else "")
        return next((fault for i, item in enumerate(content)
                     if (fault := find_fault(item, shape[0], f"{place}.{i}".lstrip(".")))), "")
    if not isinstance(content, dict):
        return f"{where} is not an object"
    wanted_by_key = {key: shape.shape for key in content} if isinstance(shape, MapOf) else shape
    for key, wanted in wanted_by_key.items():
        path = f"{place}.{key}".lstrip(".")
        if key not in content:
            if not isinstance(wanted, Optional):
                return f"'{path}' is missing"
            continue
        if fault := find_fault(content[key], wanted.shape if isinstance(wanted, Optional) else wanted, path):
            return fault
    return ""


def restore_numbers(content: Any, shape: Any) -> Any:
    """The content with NaN where null stands for a number."""
    if isinstance(shape, Optional):
        return restore_numbers(content, shape.shape)
    if shape == NUMBER:
        return float("nan") if content is None else content
    if isinstance(shape, list):
        return [restore_numbers(item, shape[0]) for item in content]
    if isinstance(shape, MapOf):
        return {key: restore_numbers(value, shape.shape) for key, value in content.items()}
    if isinstance(shape, dict):
        return {key: restore_numbers(value, shape[key]) if key in shape else value for key, value in content.items()}
    return content


def _is_absurd(content: Any) -> bool:
    """Whole numbers that no float holds."""
    return isinstance(content, int) and abs(content) > 1 << 63


# --- writing ----------------------------------------------------------------------------------------------------------


def make_mark(tool: str) -> str:
    """The text that a file has in its head or at its end, by which it is known as one of this tool."""
    return MARK + tool


def check_target(path: str | os.PathLike[str], tool: str, force: bool = False) -> None:
    """Throws Refused unless the tool may write there: nothing is there, or its own earlier file, or with `force` a file
    that is no result of a run."""
    path = os.fspath(path)
    if os.path.islink(path):
        raise Refused(f"{path}: this is a link, which is never followed: remove it, or choose another name with --out")
    if not os.path.lexists(path):
        return
    if not os.path.isfile(path):
        raise Refused(f"{path}: this is no regular file: choose another name with --out")
    name = os.path.basename(path)
    if name in _RESULTS or name.endswith(_RESULT_ENDINGS):
        raise Refused(f"{path}: this is a result of a run (no tool overwrites one): choose another name with --out")
    if not force and not _has_mark(path, tool):
        raise Refused(f"{path}: this file is there already (percuss {tool} has not written it): "
                      "choose another name with --out, or "
                      "give --force")


def write_file(path: str | os.PathLike[str], content: str | bytes | Iterable[str | bytes], tool: str,
               force: bool = False) -> None:
    """Writes a text, bytes, or texts that follow each other, all or nothing: into a new file beside it, which takes its
    place at once. A link is never followed. Throws Refused (see check_target) and OSError."""
    path = os.fspath(path)
    check_target(path, tool, force)
    pieces: Iterable[str | bytes] = [content] if isinstance(content, (str, bytes)) else content
    temporary = f"{path}.{secrets.token_hex(6)}.tmp"
    descriptor = os.open(temporary, os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_NOFOLLOW", 0), 0o666)
    try:
        with os.fdopen(descriptor, "wb") as file:
            file.writelines(piece.encode("utf-8", "replace") if isinstance(piece, str) else piece for piece in pieces)
        os.replace(temporary, path)  # a link that was put there meanwhile is replaced itself
    except BaseException:
        os.unlink(temporary)
        raise


def _has_mark(path: str, tool: str) -> bool:
    mark = make_mark(tool).encode()
    try:
        with open(path, "rb") as file:
            head = file.read(MARKED_BYTES)
            file.seek(max(0, os.fstat(file.fileno()).st_size - MARKED_BYTES))
            return mark in head or mark in file.read(MARKED_BYTES)
    except OSError:
        return False
