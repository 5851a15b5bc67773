"""What stands in summary.json (docs/output.md): every key of a summary has one type."""

from typing import Any

from ..files import NUMBER, OBJECT, TEXT, TEXT_OR_NULL, WHOLE, MapOf, Optional


def _numbers(*names: str) -> dict[str, str]:
    return {name: NUMBER for name in names}


SUMMARY: dict[str, Any] = {
    "status": TEXT, "error": TEXT, "version": TEXT, "backend": TEXT, "precision": TEXT,
    "warnings": Optional([{"rule": TEXT, "text": TEXT, "place": Optional(TEXT), "time": Optional(NUMBER),
                           "count": Optional(WHOLE)}]),
    "ranks": WHOLE, "threads": WHOLE, "elements": WHOLE, "nodes": WHOLE, "contact_nodes": WHOLE, "contact_faces": WHOLE,
    "steps": WHOLE,
    "time": NUMBER, "end_time": Optional(NUMBER), "ended_by": Optional(TEXT), "restart_changes": Optional([TEXT]),
    "sensors": Optional([{"sensor": TEXT, "time": NUMBER, "value": NUMBER}]),
    "dt": {**_numbers("min", "max", "last", "gain"), "element": WHOLE, "spring": TEXT, "approach": Optional(TEXT)},
    "mass": _numbers("added", "share", "in_run", "energy"),
    "relaxation": {"state": TEXT, "damped_steps": WHOLE,
                   **_numbers("kinetic_ratio", "scale", "frequency", "energy", "preload_error")},
    **_numbers("setup_s", "loop_s", "grind_ns"),
    "earlier": Optional({"runs": WHOLE, "steps": WHOLE, **_numbers("setup_s", "loop_s"), "phases_s": MapOf(NUMBER)}),
    "phases_s": MapOf(NUMBER), "skipped": MapOf(NUMBER),
    "energy": {**_numbers("initial", "kinetic", "internal", "hourglass", "viscous", "folding", "contact", "friction",
                          "damping", "external", "error"),
               "contact_taken": Optional(NUMBER), "largest": Optional(NUMBER)},
    "momentum": {"linear": [NUMBER, 3], "angular": [NUMBER, 3], **_numbers("linear_error", "angular_error")},
    "eroded": {"elements": WHOLE, **_numbers("mass", "energy", "vanished_mass")},
    "balance": _numbers("elements", "contact"), "messages": _numbers("count", "bytes"),
    "peak_bytes": WHOLE, "state_hash": TEXT,
    "deck": Optional({"file": TEXT, "settings": [TEXT], "values": OBJECT}),
}

COLUMNS: dict[str, Any] = {"units": Optional(TEXT_OR_NULL),
           "columns": [{"name": TEXT, "unit": Optional(TEXT_OR_NULL), "dimension": Optional(TEXT_OR_NULL),
                        "meaning": Optional(TEXT)}]}
