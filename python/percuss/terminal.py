"""Text on its way to a terminal: the one place that cleans it, and the errors of all tools."""

import sys
import unicodedata

KEPT = "\n\t"  # in texts of several lines


def clean(text, kept=""):
    """The text with what a terminal obeys instead of showing it (control characters, marks that turn the direction of writing) as
    \\x1b or \\u202e, as percuss itself prints it."""
    return "".join(c if c in kept or not _is_order(c) else _name(c) for c in str(text))


def _is_order(c):
    return unicodedata.category(c) in ("Cc", "Cf", "Cs", "Zl", "Zp")


def _name(c):
    return f"\\x{ord(c):02x}" if ord(c) < 256 else f"\\u{ord(c):04x}"


def tell(text, stream=None, **how):
    """Prints cleaned text; what the terminal's encoding lacks becomes a question mark."""
    stream = stream or sys.stdout
    shown, encoding = clean(text, KEPT), getattr(stream, "encoding", None) or "ascii"
    print(shown.encode(encoding, "replace").decode(encoding), file=stream, **how)


def fail(tool, message, code=2):
    """Ends the program with 'TOOL: error: MESSAGE'."""
    tell(f"{tool}: error: {message}", sys.stderr)
    sys.exit(code)
