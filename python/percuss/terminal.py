"""Text on its way to a terminal: the one place that cleans it, and the errors of all tools."""

import sys
import unicodedata
from typing import Any, NoReturn, TextIO

KEPT = "\n\t"  # in texts of several lines


def clean(text: object, kept: str = "") -> str:
    """The text with what a terminal obeys instead of showing it (control characters, marks that turn the direction of
    writing) as \\x1b or \\u202e, as percuss itself prints it."""
    return "".join(c if c in kept or not _is_order(c) else _name(c) for c in str(text))


def _is_order(c: str) -> bool:
    return unicodedata.category(c) in ("Cc", "Cf", "Cs", "Zl", "Zp")


def _name(c: str) -> str:
    return f"\\x{ord(c):02x}" if ord(c) < 256 else f"\\u{ord(c):04x}"


def print_text(text: object, stream: TextIO | None = None, **how: Any) -> None:
    """Prints cleaned text; what the terminal's encoding lacks becomes a question mark."""
    stream = stream or sys.stdout
    shown, encoding = clean(text, KEPT), getattr(stream, "encoding", None) or "ascii"
    print(shown.encode(encoding, "replace").decode(encoding), file=stream, **how)


def join_signed(words: list[str]) -> list[str]:
    """argparse takes '-50:22' and '-x=0' for options: such a word is joined to the option before it."""
    joined: list[str] = []
    for word in words:
        signed = len(word) > 1 and word[0] == "-" and (word[1].isdigit() or word[1] in ".xyz")
        if signed and joined and joined[-1].startswith("--") and "=" not in joined[-1]:
            joined[-1] += "=" + word
        else:
            joined.append(word)
    return joined


def fail(tool: str, message: object, code: int = 2) -> NoReturn:
    """Ends the program with 'TOOL: error: MESSAGE'."""
    print_text(f"{tool}: error: {message}", sys.stderr)
    sys.exit(code)
