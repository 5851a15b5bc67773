"""What was run: facts, parts, materials, deck."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from percuss.render.colors import PART_COLORS
from percuss.results.arrays import Array
from percuss.results.deck import Deck
from percuss.results.run import Run
from percuss.results.units import choose_time_unit
from percuss.watch.screen import format_duration

from .markup import Markup, escape, fold, format_number, make_filled_table, make_table, show_deck, show_value, with_unit

KINDS = ("beams", "triangles", "quadrilaterals", "tetrahedra", "pyramids", "wedges", "hexahedra")


def unit_of(run: Run, quantity: str) -> str:
    return run.units.name_of(quantity) if run.units else ""


def make_facts(run: Run) -> str:
    """The boxes at the top."""
    summary = run.summary
    if not summary:
        return ""
    unit, factor = choose_time_unit(unit_of(run, "time"), summary["time"])
    loop = (summary["loop_s"] or 0) + ((summary.get("earlier") or {}).get("loop_s") or 0)
    facts = [
        (run.status, "status"),
        (show_value(summary["time"] * factor, unit), "simulated time"),
        (f"{summary['steps']:,}", "steps"),
        (f"{summary['elements']:,}", "elements"),
        (f"{summary['contact_faces']:,}", "contact faces"),
        (f"{loop:.3g} s" if loop < 60 else format_duration(loop),
         f"computing time, {summary['ranks']} x {summary['threads']} cores"),
        (f"{summary['energy']['error'] or 0:.2g}", "energy error"),
        (Markup(f"<span class=mono>{escape(summary['state_hash'] or '-')}</span>"), "state hash"),
    ]
    cells = "".join(f"<div><b>{value if isinstance(value, Markup) else escape(value)}</b><span>{escape(name)}</span>"
                    "</div>"
                    for value, name in facts)
    return f"<div class=facts>{cells}</div>"


def make_parts_table(run: Run) -> str:
    if not run.has_fields:
        return "<p class=soft>There are no fields (output.fields), so that the mesh is not shown.</p>"
    fields, length = run.fields, unit_of(run, "length")
    start = fields.positions(0)
    kinds = np.array([find_kind(corners.tolist()) for corners in fields.hexahedra])
    rows = []
    for number, name in enumerate(fields.part_names):
        mine = fields.part == number
        if not mine.any():
            continue
        points = start[np.unique(fields.hexahedra[mine])]
        counts = ", ".join(f"{int((kinds[mine] == kind).sum()):,} {KINDS[kind]}" for kind in np.unique(kinds[mine]))
        size = " x ".join(f"{x:.4g}" for x in np.ptp(points, axis=0))
        mass = ""
        if run.has_history and len(run.history) and f"mass:{name}" in run.history:
            mass = with_unit(float(run.history[f"mass:{name}"][0]), unit_of(run, "mass"))
        swatch = f"<i class=swatch style='background:{PART_COLORS[number % len(PART_COLORS)]}'></i>"
        rows.append((Markup(swatch + escape(name)), counts, f"{len(points):,}", with_unit(size, length),
                     mass, run.deck.get(f"parts.{name}.material", "")))
    heading = ("part", "elements", "nodes", "size at the start", "mass", "material")
    return make_filled_table(heading, rows, numbers=(2,))


def find_kind(corners: Array) -> int:
    """Place of a cell among KINDS, from its padded form."""
    different = len(set(corners))
    if corners[0] == corners[4]:
        return different - 2
    return {4: 3, 5: 4, 6: 5}.get(different, 6)


def make_materials_table(deck: Deck) -> str:
    materials = deck.get_map("materials")
    if not materials:
        return ""
    rows = [(name, values.get("model", ""),
             format_number({key: value for key, value in values.items() if key != "model"}))
            for name, values in materials.items() if isinstance(values, dict)]
    return "<h3>Materials</h3>" + make_table(("material", "model", "constants, in the units of the deck"), rows)


def make_loads_table(deck: Deck) -> str:
    """What moves, holds and touches."""
    rows = []
    for key in ("imperfections", "added_mass", "initial", "conditions", "loads", "gravity", "walls", "contact", "ties",
                "elements", "mass_scaling"):
        value = deck.get(key)
        for item in value if isinstance(value, list) else [value] if value is not None else []:
            rows.append((key, format_number(item)))
    return "<h3>Motion, supports, contact</h3>" + make_table(("key", "value"), rows) if rows else ""


def make_relaxation_table(run: Run) -> str:
    """What the damped steps before time 0 did."""
    relaxation = run.summary.get("relaxation") or {}
    if not relaxation.get("state"):
        return ""
    energy = unit_of(run, "energy")
    tolerance = run.deck.get("start.relaxation.tolerance", 1e-6)
    frequency = unit_of(run, "frequency")
    rows = [("state", relaxation["state"]), ("damped steps", f"{relaxation['damped_steps']:,}"),
            ("residual: kinetic energy over the scale",
             f"{relaxation['kinetic_ratio']:.3g} (tolerance {format_number(tolerance)})"),
            ("scale of the energy", show_value(relaxation["scale"], energy)),
            ("lowest frequency", show_value(relaxation["frequency"], frequency)),
            ("energy held at time 0", show_value(relaxation["energy"], energy))]
    preloads = run.deck.get_map("start.preload")
    for name, preload in preloads.items():
        if isinstance(preload, dict):
            rows.append((f"preload {name} of {preload.get('part', '')}",
                         with_unit(preload.get("force", ""), unit_of(getattr(run, "original", run), "force"))))
    if preloads:
        rows.append(("largest error of a preload", f"{relaxation['preload_error']:.2g} of its force"))
    return "<h3>Relaxation before time 0</h3>" + make_table(None, rows)


def make_deck_section(deck: Deck) -> str:
    """The values that were run; comments of the file are not among them."""
    if not deck:
        return ("<p class=soft>The deck is not known: neither summary.json nor a checkpoint has it "
                "(runs of older versions do not keep it).</p>")
    settings = f", with {', '.join(f'--set {setting}' for setting in deck.settings)}" if deck.settings else ""
    return fold(f"Deck as it was run: {deck.file or 'values of the checkpoint'}{settings}", show_deck(deck.text))


def flatten(tree: Mapping[str, Any], prefix: str = "") -> list[tuple[str, Any]]:
    """[('time.end', 0.1) ...] of a tree of dictionaries; lists stay whole."""
    rows = []
    for key, value in tree.items():
        if isinstance(value, dict):
            rows += flatten(value, f"{prefix}{key}.")
        else:
            rows.append((prefix + str(key), value))
    return rows


def make_cost_section(summary: dict[str, Any]) -> str:
    """Where the time went, and what was skipped."""
    loop = summary["loop_s"] or 1
    phases = [(name.replace("_", " "), f"{seconds:.3g} s", f"{100 * seconds / loop:.1f} %")
              for name, seconds in sorted(summary["phases_s"].items(), key=lambda item: float(-item[1])) if seconds > 0]
    skipped = [(name.replace("_", " "), f"{100 * share:.1f} %") for name, share in summary["skipped"].items()]
    rows = [("set-up, loop", f"{summary['setup_s']:.3g} s, {summary['loop_s']:.3g} s")]
    earlier = summary.get("earlier") or {"runs": 0}
    if earlier["runs"]:
        seconds = f"{earlier['setup_s']:.3g} s, {earlier['loop_s']:.3g} s"
        rows.append(("runs before the restart", f"{earlier['runs']}, {earlier['steps']} steps; {seconds}"))
    rows += [
        ("per element and step", f"{summary['grind_ns']:.4g} ns of core time"),
        ("largest memory of a rank", f"{summary['peak_bytes'] / 1e6:.4g} MB"),
        ("busiest rank over the mean",
         f"elements {summary['balance']['elements']:.3g}, contact {summary['balance']['contact']:.3g}"),
        ("messages per step and rank", f"{summary['messages']['count']:.3g}, {summary['messages']['bytes']:.4g} bytes"),
        ("program", f"percuss {summary['version']}, {summary['backend']}, {summary['precision']}")]
    return ("<div class=columns><div><h3>Work of the loop</h3>"
            + make_table(("phase", "time", "share"), phases, (1, 2)) +
            "</div><div><h3>Work that was not needed, and skipped</h3>" + make_table(("work", "share"), skipped, (1,)) +
            "</div><div><h3>Run</h3>" + make_table(None, rows) + "</div></div>")
