"""The interactive view as a piece of a page."""

import json
from collections.abc import Callable
from typing import Any

from percuss.report.markup import escape

from .surface import read_library, read_text, read_viewer

MISSING = "three.js is missing (scripts/install_dependencies --report installs libjs-three)"


def embed_view(about: dict[str, Any], data: str, sentence: str, note: Callable[[str], None]) -> str:
    """The view of a surface that is packed. note: takes a text for the user where there can be none."""
    library = read_library()
    if library is None:
        note(f"no interactive view: {MISSING}")
        return ("<p class=soft>The interactive view needs three.js "
                "(Debian's package libjs-three) where the report is written.</p>")
    texts = [text.replace("</script", "<\\/script") for text in (*library, read_viewer())]
    code = "".join(f"<script>{text}</script>" for text in texts)
    described = json.dumps(about).replace("<", "\\u003c")
    return (f"{read_text('view.html')}<p class=soft>{escape(sentence)}</p>"
            f"<script type='application/json' id=surface-about>{described}</script>"
            f"<script type='text/plain' id=surface-data>{data}</script>{code}")


def describe_view(about: dict[str, Any], frames: int, reduced_by: list[str]) -> str:
    """The sentence below a view. frames: how many the run has; reduced_by: what has been reduced."""
    counted = f"{about['frames']} of {frames} frames, {about['faces']:,} faces."
    return f"{counted} Reduced to fit into a page: {'; '.join(reduced_by)}." if reduced_by else counted
