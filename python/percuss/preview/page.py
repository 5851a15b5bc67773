"""A page about a scene before it runs: the drawing, what it weighs and costs, and what percuss check warns of."""

import base64
import io
import json
import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable
from typing import Any

import numpy as np

from percuss.render.colors import PART_COLORS
from percuss.report.findings import BAD, GOOD, LOOK, Finding, find_contact_loss
from percuss.report.markup import Markup, escape, format_number, make_table, show_value, with_unit
from percuss.report.page import join_sections, note, wrap_page
from percuss.report.scene import make_deck_section, make_loads_table, make_materials_table
from percuss.results.arrays import Array
from percuss.results.deck import Deck
from percuss.results.fields import Fields
from percuss.results.units import find_units
from percuss.view.embed import embed_view
from percuss.view.reduce import pack_view

from .marks import Layer, color_of, make_layers
from .trial import Trial, format_bytes, format_seconds, split_messages

VIEWS = ("-50:22", "130:-12")
QUALITY = 88
OF_THE_END = ("hourglass_energy", "energy_error", "element_energy")  # rules that judge a whole run, not its first steps
MUCH_MEMORY, MUCH_DISK = 0.8, 0.8  # share of what there is


class Preview:
    """The page of a Trial. options: pictures, interactive, both truths."""

    def __init__(self, trial: Trial, options: Any) -> None:
        self.trial, self.scene, self.options = trial, trial.scene, options
        self.units = find_units(self.scene["units"])
        self.deck = Deck(self.scene["values"], trial.deck)
        self.fields = trial.run.fields if trial.run is not None and trial.run.has_fields else None
        self.layers = make_layers(self.scene, self.fields, _span_walls(self.fields)) if self.fields else []

    def unit(self, quantity: str) -> str:
        return self.units.name_of(quantity) if self.units else ""

    def make_page(self) -> str:
        title = "Before the run: " + (self.scene["title"] or os.path.basename(self.trial.deck))
        sections = [("first", "What to look at first", self._list_findings()),
                    ("pictures", "The scene at time 0", self._make_pictures()),
                    ("surface", "Interactive view", self._make_view()),
                    ("parts", "Parts: mass and step", self._make_parts()),
                    ("cost", "What the run will cost", self._make_costs()),
                    ("sets", "Sets, conditions, loads, walls", self._make_selections()),
                    ("contact", "Overlaps, gaps, joints", self._make_contact()),
                    ("deck", "Materials and deck", make_materials_table(self.deck) + make_loads_table(self.deck)
                     + make_deck_section(self.deck))]
        units = f" Units of the deck: {self.units.text}." if self.units else " The deck names no units."
        head = f"<h1>{escape(title)}</h1><p class=soft>{escape(self.trial.deck)}.{escape(units)}</p>"
        return wrap_page(title, head + join_sections(sections, self._make_facts()), "check")

    # --- numbers ------------------------------------------------------------------------------------------------------

    def _make_facts(self) -> str:
        scene, trial = self.scene, self.trial
        size = " x ".join(f"{high - low:.3g}" for low, high in zip(scene["low"], scene["high"]))
        facts = [(show_value(scene["total_mass"], self.unit("mass")), "mass"),
                 (with_unit(size, self.unit("length")), "extent"),
                 (f"{scene['elements']:,}", "elements"), (f"{scene['bodies']:,}", "bodies"),
                 (show_value(scene["first_step"], self.unit("time")), "first step"),
                 (f"{scene['steps']:,.0f}", "steps, predicted")]
        if trial.step_time and trial.run is not None:
            facts += [(format_seconds(scene["steps"] * trial.step_time), "run time, predicted"),
                      (format_bytes(trial.run.summary["peak_bytes"]), "memory")]
        sizes = trial.find_sizes()
        if sizes:
            facts.append((format_bytes(sum(size for _, size, _ in sizes)), "disk, predicted"))
        return "<div class=facts>" + "".join(f"<div><b>{escape(value)}</b><span>{escape(name)}</span></div>"
                                             for value, name in facts) + "</div>"

    def _make_parts(self) -> str:
        least = min((part["step"] for part in self.scene["parts"] if part["step"]), default=None)
        rows: list[tuple[object, ...]] = []
        for number, part in enumerate(self.scene["parts"]):
            swatch = f"<i class=swatch style='background:{PART_COLORS[number % len(PART_COLORS)]}'></i>"
            step = show_value(part["step"], self.unit("time")) if part["step"] else "-"
            if part["step"] == least:
                step = Markup(f"<b>{escape(step)}</b>")
            rows.append((Markup(swatch + escape(part["name"])), part["material"], f"{part['elements']:,}",
                         f"{part['nodes']:,}", show_value(part["mass"], self.unit("mass"), 5), step,
                         part["controlling_element"]))
        total = show_value(self.scene["mass"], self.unit("mass"), 5)
        rows.append(("all", "", f"{self.scene['elements']:,}", f"{self.scene['nodes']:,}", total,
                     show_value(self.scene["first_step"], self.unit("time")),
                     self.scene["controlling_element"]))
        heading = ("part", "material", "elements", "nodes", "mass", "step", "controlled by")
        low, high = self.scene["low"], self.scene["high"]
        box = ", ".join(f"{axis} {low[i]:.6g} to {high[i]:.6g}" for i, axis in enumerate("xyz"))
        given = ""
        if abs(self.scene["total_mass"] - self.scene["mass"]) > 1e-12 * self.scene["mass"]:
            total = show_value(self.scene["total_mass"], self.unit("mass"), 5)
            given = ("<p class=soft>Masses are those of elements. "
                     f"With what the deck adds, or gives to rigid bodies, the scene has {escape(total)}.</p>")
        return (make_table(heading, rows, (2, 3, 4, 5)) + given
                + f"<p class=soft>Extent: {escape(with_unit(box, self.unit('length')))}.</p>")

    def _make_costs(self) -> str:
        rows = self.trial.predict()
        text = make_table(("what", "predicted", "from"), rows)
        if not self.trial.step_time:
            text += "<p class=soft>No step could be measured, so that time and memory are not known.</p>"
        return text

    # --- judgements ---------------------------------------------------------------------------------------------------

    def _list_findings(self) -> str:
        found = [Finding(BAD, text) for text in split_messages(self.trial.error)]
        found += [Finding(BAD, "The first steps fail: " + text) for text in split_messages(self.trial.run_error)[:3]]
        known = {(w["rule"], w["place"], w["text"]) for w in self.scene["warnings"]}
        found += [Finding(LOOK, _describe(warning)) for warning in self.scene["warnings"]]
        later = self.trial.run.warnings if self.trial.run is not None else []
        found += [Finding(LOOK, _describe(warning) + " In the first steps.") for warning in later
                  if (warning["rule"], warning["place"], warning["text"]) not in known and warning["time"] > 0
                  and warning["rule"] not in OF_THE_END]
        if self.trial.run is not None and self.trial.run.status == "completed":
            found += [Finding(LOOK, finding.text + " In the first steps.", finding.remedy)
                      for finding in find_contact_loss(self.trial.run)]
        found += self._judge_resources() + self._judge_overlap()
        if all(finding.level == GOOD for finding in found):
            found.append(Finding(GOOD, "No errors in the deck or its meshes, and no warnings."))
        order = {BAD: 0, LOOK: 1, GOOD: 2}
        items = "".join(f"<li class={f.level}>{escape(f.text)}</li>"
                        for f in sorted(found, key=lambda f: order[f.level]))
        return f"<ul class=findings>{items}</ul>"

    def _judge_resources(self) -> list[Finding]:
        found = []
        if self.trial.step_time and self.trial.run is not None:
            total = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
            if self.trial.run.summary["peak_bytes"] > MUCH_MEMORY * total:
                found.append(Finding(LOOK,
                                     f"The run needs most of the memory of this machine ({format_bytes(total)})."))
        disk = sum(size for _, size, _ in self.trial.find_sizes())
        free = shutil.disk_usage(os.getcwd()).free
        if disk > MUCH_DISK * free:
            found.append(
                Finding(LOOK, f"The output takes {format_bytes(disk)}; {format_bytes(free)} are free in this folder."))
        return found

    def _judge_overlap(self) -> list[Finding]:
        overlap = self.scene["overlap"]
        count = len(overlap["nodes"])
        if not count and not overlap["edge_pairs"] and overlap["crossings"]:
            return [Finding(LOOK,
                            "Parts cross at the start; where their edges go through faces is red in the drawing.")]
        if not count and not overlap["edge_pairs"]:
            return [Finding(GOOD, "No surfaces overlap at the start.")] if self.scene["contact_faces"] else []
        deepest = show_value(max(overlap["deepest"], overlap["deepest_edges"]), self.unit("length"), 3)
        edges = f", {overlap['edge_pairs']} pairs of edges" if overlap["edge_pairs"] else ""
        deep = f" {overlap['too_deep']} nodes are deeper than contact can hold." if overlap["too_deep"] else ""
        return [Finding(LOOK, f"Surfaces overlap at the start: {count} nodes{edges}, the deepest by {deepest}; "
                              f"they are red in the drawing.{deep}")]

    # --- tables -------------------------------------------------------------------------------------------------------

    def _make_selections(self) -> str:
        rows = []
        for item in self.scene["selections"]:
            swatch = Markup(f"<i class=swatch style='background:{color_of(item['what'])}'></i>{escape(item['key'])}")
            rows.append((swatch, item["what"], item["where"], f"{item['count']:,}", item["place"]))
        text = make_table(("key", "what", "set", "nodes", "place"), rows, (3,)) if rows else ""
        walls = [(wall["name"] or f"walls.{number}", wall["shape"], format_number(wall["point"]), _describe_wall(wall),
                  format_number(wall["friction"]), wall["place"]) for number, wall in enumerate(self.scene["walls"])]
        if walls:
            text += "<h3>Rigid walls</h3>" + make_table(("wall", "shape", "point", "form", "friction", "place"), walls)
        return text or "<p class=soft>The deck has no set, condition, load or wall.</p>"

    def _make_contact(self) -> str:
        overlap, unit = self.scene["overlap"], self.unit("length")

        def length(value: float) -> str:
            return show_value(value, unit)

        text = ""
        if overlap["parts"]:
            overlaps = [(p["part"], p["inside"], f"{p['nodes']:,}", length(p["deepest"])) for p in overlap["parts"]]
            text += "<h3>Overlaps</h3>" + make_table(("nodes of", "inside", "nodes", "deepest"), overlaps, (2, 3))
        if overlap["crossings"]:
            meaning = {"now": "yes", "later": "later", "never": "no"}
            crossings = [(c["part"], c["other"], f"{len(c['places']):,}", length(c["depth"]), format_number(c["at"]),
                          meaning[c["contact"]])
                         for c in sorted(overlap["crossings"], key=lambda crossing: float(-crossing["depth"]))]
            text += "<h3>Parts that cross</h3>" + make_table(("part", "other", "edges", "depth", "at", "contact"),
                                                             crossings, (2, 3))
        if overlap["gaps"]:
            gaps = sorted(overlap["gaps"], key=lambda gap: float(gap["gap"]))
            near = [(g["part"], g["other"], _describe_gap(g["gap"], length)) for g in gaps[:40]]
            text += "<h3>Smallest gaps</h3>" + make_table(("part", "other", "gap"), near, (2,))
            text += "<p class=soft>Only parts within reach of each other, about an element, are listed.</p>"
        notes = self.scene["joints"] + [line for line in self.scene["notes"] if not line.startswith("smallest gaps")]
        if notes:
            text += "<h3>Notes</h3><ul>" + "".join(f"<li>{escape(line)}</li>" for line in notes) + "</ul>"
        return text or "<p class=soft>Nothing overlaps, and no two parts are near each other.</p>"

    # --- drawings -----------------------------------------------------------------------------------------------------

    def _make_pictures(self) -> str:
        if self.fields is None:
            return "<p class=soft>There is no drawing, since no step could be started.</p>"
        legend = "".join(f"<span><i class=swatch style='background:{layer.color}'></i>{escape(layer.name)}</span>"
                         for layer in self.layers if layer.shown)
        legend = f"<p class=legend>{legend}</p>" if legend else ""
        left_out = [layer.name for layer in self.layers if not layer.shown]
        if left_out:
            legend += ("<p class=soft>Left out, "
                       f"since their marks would hide the bodies: {escape('; '.join(left_out))}.</p>")
        if not self.options.pictures:
            return legend
        try:
            pictures = draw_pictures(self.fields, self.layers)
        except (RuntimeError, OSError, subprocess.SubprocessError) as error:
            note(f"no pictures: {error}")
            return f"<p class=soft>There are no pictures: {escape(error)}</p>{legend}"
        shown = ""
        for view, picture in zip(VIEWS, pictures):
            azimuth, elevation = view.split(":")
            shown += (f"<figure><img alt='The scene from {view}' src='data:image/jpeg;base64,{picture}'>"
                      "<figcaption>Seen from azimuth ")
            shown += f"{azimuth}, elevation {elevation} degrees.</figcaption></figure>"
        return f"{legend}<div class=pictures>{shown}</div>"

    def _make_view(self) -> str:
        if self.fields is None or not self.options.interactive:
            return ""
        about, data, reduced_by = pack_view(self.fields, ["velocity"], frames=[0])
        about.update(still=True, byPart=True, layers=[_describe_layer(layer) for layer in self.layers])
        reduced = f" Reduced to fit into a page: {'; '.join(reduced_by)}." if reduced_by else ""
        return embed_view(about, data, f"{about['faces']:,} faces. Untick a part or a mark to hide it.{reduced}", note)


def _span_walls(fields: Fields) -> list[Array]:
    from percuss.render.plates import span_walls

    return [plate for plates, _ in span_walls(fields, 0, fields.positions(0)) for plate in plates]


def _describe_layer(layer: Layer) -> dict[str, Any]:
    places = np.asarray(layer.places, dtype=float)
    return {"name": layer.name, "color": layer.color, "kind": layer.kind, "shown": layer.shown, "top": layer.on_top,
            "places": [float(f"{x:.6g}") for x in places.reshape(-1)]}


def _describe(warning: dict[str, Any]) -> str:
    place = f"{warning['place']}: " if warning["place"] else ""
    return f"Warning [{warning['rule']}] {place}{warning['text']}."


def draw_pictures(fields: Fields, layers: list[Layer]) -> list[str]:
    """JPEG as text of base 64, a picture a view. RuntimeError with the reason if there are none."""
    from PIL import Image

    with tempfile.TemporaryDirectory() as folder:
        arrays = {str(number): layer.places for number, layer in enumerate(layers)}
        about = [{"kind": layer.kind, "color": layer.color, "shown": layer.shown, "on_top": layer.on_top}
                 for layer in layers]
        path = os.path.join(folder, "layers.npz")
        np.savez(path, layers=json.dumps(about), **arrays)
        command = [sys.executable, "-m", "percuss.preview.draw_marks", fields.path, path, folder, *VIEWS]
        done = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=900, check=False)
        if done.returncode != 0:
            raise RuntimeError(done.stderr.strip().splitlines()[-1] if done.stderr.strip() else "VTK could not draw")
        found = []
        for number in range(len(VIEWS)):
            stream = io.BytesIO()
            with Image.open(os.path.join(folder, f"view_{number}.png")) as image:
                image.convert("RGB").save(stream, "JPEG", quality=QUALITY, optimize=True)
            found.append(base64.b64encode(stream.getvalue()).decode("ascii"))
        return found


def _describe_gap(gap: float, length: Callable[[float], str]) -> str:
    return "they touch" if gap == 0 else length(gap) + (" (they overlap)" if gap < 0 else "")


def _describe_wall(wall: dict[str, Any]) -> str:
    if wall["shape"] == "plane":
        return f"normal {format_number(wall['normal'])}"
    text = f"radius {format_number(wall['radius'])}"
    if wall["shape"] == "cylinder":
        text += f", axis {format_number(wall['axis'])}"
        text += ", without ends" if wall["length"] is None else f", length {format_number(wall['length'])}"
    return text
