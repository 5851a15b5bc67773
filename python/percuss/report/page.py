"""The page: sections of one run, or of a comparison, in one HTML file that needs nothing else."""

import os
import sys
import time
from typing import Any

from percuss.files import make_mark
from percuss.plot.drawing import Plot, write_svg
from percuss.plot.panels import choose_panels, list_panels
from percuss.plot.series import Options
from percuss.render.colors import CATEGORIES, label_of
from percuss.render.mirrors import find_symmetry
from percuss.render.selection import check_field
from percuss.results.fields import Fields
from percuss.results.history import History
from percuss.results.run import Run, label_runs
from percuss.results.units import choose_time_unit, choose_unit, format_time
from percuss.terminal import print_text
from percuss.view.embed import describe_view, embed_view
from percuss.view.reduce import pack_view

from . import comparison, scene
from .answers import make_answers
from .curves import make_curves
from .findings import find_findings, find_peaks
from .forces import make_balance_table, make_forces_table
from .markup import escape, make_table, show_value, with_unit
from .motion import make_motion_table
from .pictures import Worst, choose_field, differ, draw_pictures, find_range
from .signals import make_accelerometers_table
from .welds import make_welds_table

HERE = os.path.dirname(os.path.realpath(__file__))
MORE_PANELS = ("contact_pairs", "kinetic_by_part", "internal_by_part", "erosion")


def note(text: str) -> None:
    print_text(f"report: {text}", sys.stderr)


def make_page(runs: list[Run], options: Any) -> str:
    """The text of the page. options: field, view, pictures, interactive, plot, x, units."""
    labels = label_runs(runs)
    title = runs[0].title if len(runs) == 1 else "Comparison: " + ", ".join(labels)
    parts = [f"<h1>{escape(title)}</h1>", _make_subtitle(runs)]
    sections = []
    if len(runs) > 1:
        sections.append(("compared", "Differences", _make_comparison(runs, labels)))
    first = "".join(f"<h3>{escape(label)}</h3>" * (len(runs) > 1) + _list_findings(run)
                    for label, run in zip(labels, runs))
    if len(runs) == 1:
        sections.append(("short", "In short", make_answers(runs[0], find_findings(runs[0]))))
    chosen = [(run, label) for run, label in zip(runs, labels) if run.has_history and len(run.history)]
    if options.plot and not chosen:
        raise ValueError("there is no history to plot from (output.history of the deck)")
    sections.append(("curves", "Chosen curves",
                     make_curves([run for run, _ in chosen], [label for _, label in chosen], options.plot, options.x)))
    sections.append(("first", "What to look at first", first))
    sections.append(("pictures", "Start, worst and end", _make_pictures(runs, labels, options)))
    sections.append(("surface", "Interactive view" + (f": {labels[0]}" if len(runs) > 1 else ""),
                     _make_view(runs[0], options)))
    sections.append(("plots", "Over time", _make_plots(runs, labels)))
    sections.append(("run", "What was run",
                     "".join(_make_scene(run, label, len(runs) > 1) for run, label in zip(runs, labels))))
    if len(runs) == 1 and runs[0].summary:
        sections.append(("cost", "What it cost", scene.make_cost_section(runs[0].summary)))
    facts = scene.make_facts(runs[0]) if len(runs) == 1 else ""
    return wrap_page(title, "".join(parts) + join_sections(sections, facts))


def join_sections(sections: list[tuple[str, str, str]], facts: str = "") -> str:
    """Links to the sections, the boxes of facts, and the sections: (name, heading, text);
    those without text left out."""
    sections = [section for section in sections if section[2]]
    links = "".join(f"<a href='#{name}'>{escape(heading)}</a>" for name, heading, _ in sections)
    shown = "".join(f"<section id={name}><h2>{escape(heading)}</h2>{text}</section>"
                    for name, heading, text in sections)
    return f"<nav>{links}</nav>{facts}{shown}"


def wrap_page(title: str, body: str, tool: str = "report") -> str:
    with open(os.path.join(HERE, "style.css"), encoding="utf-8") as file:
        style = file.read()
    return ("<!DOCTYPE html>\n<html lang=en><head><meta charset=utf-8>"
            "<meta name=viewport content='width=device-width, initial-scale=1'><link rel=icon href='data:,'>"
            f"<meta name=generator content='{make_mark(tool)}'><title>{escape(title)}</title><style>{style}</style>"
            f"</head><body>{body}</body></html>\n")


def _make_subtitle(runs: list[Run]) -> str:
    folders = ", ".join(os.path.abspath(run.folder) for run in runs)
    system = runs[0].units.text if runs[0].units else ""
    units = f" Units of the deck: {system}." if system else " The deck names no units."
    others = list(dict.fromkeys(run.original.units.text for run in runs if hasattr(run, "original")))
    if others:
        units = (f" Units: {system}. "
                 f"Deck, materials and texts of warnings have those of the deck: {'; '.join(others)}.")
    return (f"<p class=soft>{escape(folders)}. "
            f"Written {time.strftime('%Y-%m-%d %H:%M UTC', time.gmtime())}.{escape(units)}</p>")


def _list_findings(run: Run) -> str:
    items = "".join(f"<li class={finding.level}>{escape(finding.text)}</li>" for finding in find_findings(run))
    return f"<ul class=findings>{items}</ul>"


# --- pictures and view ------------------------------------------------------------------------------------------------


def _make_pictures(runs: list[Run], labels: list[str], options: Any) -> str:
    """Pictures of each run with fields; runs that show one field share the range of its colours."""
    drawn = [(run, label) for run, label in zip(runs, labels) if run.has_fields]
    names = [_choose_field(run.fields, options.field) for run, _ in drawn]
    worsts = [None if name in CATEGORIES else Worst(run.fields, name) for (run, _), name in zip(drawn, names)]
    frames = [[0, *([] if worst is None else [worst.frame]), len(run.fields.times) - 1]
              for (run, _), worst in zip(drawn, worsts)]
    shared = None
    if options.pictures and len(set(names)) == 1 and names[0] not in CATEGORIES:
        shared = find_range([run.fields for run, _ in drawn], names[0], frames)
    text = ""
    for (run, label), name, worst, chosen in zip(drawn, names, worsts, frames):
        text += (f"<h3>{escape(label)}</h3>" * (len(runs) > 1)
                 + _show_pictures(run.fields, name, worst, chosen, options, shared))
    if len(drawn) < len(runs):
        text += "<p class=soft>There are no fields to draw (output.fields of the deck).</p>"
    return text


def _choose_field(fields: Fields, wanted: str | None) -> str:
    name = choose_field(fields, wanted)
    check_field(fields, name)
    return name


def _show_pictures(fields: Fields, name: str, worst: Worst | None, frames: list[int], options: Any,
                   shared: str | None) -> str:
    """worst: None of a field whose largest value says nothing, such as the number of the part."""
    extreme = sentence = ""
    if worst is not None:
        unit, factor = choose_unit(fields.unit_of(name), abs(worst.value))
        extreme = f"largest {label_of(name)}: {show_value(worst.value * factor, unit)} in {worst.text}"
        sentence = f"<p>{escape(extreme[0].upper() + extreme[1:])}, frame {worst.frame}.</p>"
    if not options.pictures:
        return sentence
    alone = {}
    try:
        pictures = draw_pictures(fields, name, frames, {"view": options.view, "range": shared, "units": options.units})
        if worst is not None and worst.part:
            alone = draw_pictures(fields, name, [worst.frame],
                                  {"view": options.view, "range": shared, "units": options.units, "part": worst.part})
    except RuntimeError as error:
        note(f"no pictures: {error}")
        return f"<p class=soft>There are no pictures: {escape(error)}</p>{sentence}"
    labels = ("start", "end") if worst is None else ("start", "worst", "end")
    shown = ""
    for frame in dict.fromkeys(frames):
        words = " and ".join(word for word, other in zip(labels, frames) if other == frame)
        clock = format_time(fields.times[frame], fields.times[-1], fields.time_unit)
        is_worst = worst is not None and frame == worst.frame
        text = f"{words.capitalize()}: {clock}, frame {frame}" + (f"; {extreme}" if is_worst else "")
        shown += _show_picture(pictures[frame], text)
        if worst is not None and frame in alone and differ(pictures[frame], alone[frame]):
            shown += _show_picture(alone[frame], f"The same without other parts: {worst.part}")
    return f"<div class=pictures>{shown}</div>"


def _show_picture(picture: str, text: str) -> str:
    return (f"<figure><img alt='{escape(text)}' src='data:image/jpeg;base64,{picture}'>"
            f"<figcaption>{escape(text)}</figcaption></figure>")


def _make_view(run: Run, options: Any) -> str:
    if not run.has_fields or not options.interactive:
        return ""
    about, data, reduced_by = pack_view(run.fields, [choose_field(run.fields, options.field)])
    about["symmetry"] = find_symmetry(run.fields, run.deck)
    return embed_view(about, data, describe_view(about, len(run.fields.times), reduced_by), note)


# --- plots and tables -------------------------------------------------------------------------------------------------


def _histories(runs: list[Run]) -> list[History]:
    """Histories in the units of the first run."""
    units = runs[0].units
    return [run.history.in_units(units) if units and run.units and run.units.text != units.text else run.history
            for run in runs]


def _make_plots(runs: list[Run], labels: list[str]) -> str:
    shown = [(run, label) for run, label in zip(runs, labels) if run.has_history and len(run.history) > 1]
    if not shown:
        return "<p class=soft>There is no history to draw (output.history of the deck).</p>"
    histories = _histories([run for run, _ in shown])
    plot = Plot([(label, run, history) for (run, label), history in zip(shown, histories)], Options())
    panels = choose_panels([], histories)
    known = list_panels(histories)
    panels += [known[name] for name in MORE_PANELS if name in known and known[name] not in panels]
    figures = "".join(f"<figure>{write_svg(plot.draw_one(panel))}</figure>" for panel in panels)
    marks = plot.list_marks()
    text = ""
    if marks:
        rows = [(number, f"{moment * plot.x_factor:.4g} {plot.x_unit}".rstrip(), words)
                for number, (moment, words) in enumerate(marks, 1)]
        text = "<h3>Warnings in the plots</h3>" + make_table(("mark", "time", "rule and place"), rows)
    if len(runs) == 1:
        text += (make_forces_table(runs[0]) + make_accelerometers_table(runs[0]) + make_welds_table(runs[0])
                 + make_motion_table(runs[0]) + make_balance_table(runs[0]) + _make_peaks(runs[0]))
    return f"<div class=plots>{figures}</div>{text}"


def _make_peaks(run: Run) -> str:
    history = run.history
    rows = []
    unit, factor = choose_time_unit(history.unit("time"), float(history["time"][-1]) if len(history) else 0)
    for name, high, high_time, low, low_time in find_peaks(history):
        rows.append((name, history.label(name), with_unit(float(high), history.unit(name)),
                     f"{high_time * factor:.4g} {unit}", with_unit(float(low), history.unit(name)),
                     f"{low_time * factor:.4g} {unit}"))
    heading = ("column", "meaning", "largest", "at", "least", "at")
    return "<h3>Largest and least values of rows</h3>" + make_table(heading, rows, (2, 3, 4, 5)) if rows else ""


def _make_scene(run: Run, label: str, several: bool) -> str:
    text = f"<h3>{escape(label)}</h3>" * several + scene.make_parts_table(run)
    if several:
        return text
    return (text + scene.make_relaxation_table(run) + scene.make_materials_table(run.deck)
            + scene.make_loads_table(run.deck) + scene.make_deck_section(run.deck))


def _make_comparison(runs: list[Run], labels: list[str]) -> str:
    text = comparison.make_bits_text(runs)
    if all(run.summary for run in runs):
        text += comparison.make_summary_table(runs, labels)
    if all(run.has_history for run in runs):
        text += comparison.make_history_table(runs, _histories(runs), labels)
    return text + comparison.make_deck_difference(runs, labels)
