"""What is known of a scene before it runs: `percuss check --json` and a few steps in a temporary folder."""

import json
import math
import os
import re
import subprocess
from collections.abc import Iterable
from typing import Any

import percuss
from percuss.results.deck import Deck
from percuss.results.fields import Fields
from percuss.results.run import Run

FIRST_STEPS = 10
LONGER_RUN = 2.0      # seconds that the second run shall take
MOST_STEPS = 2000     # of it
FIELDS_HERE = ("velocity",)  # that the drawing needs
ALWAYS_WRITTEN = ("displacement", "alive")
ROW_GROWTH = 1.15     # factor on a row of the history: the first ones hold many zeros


class Refused(Exception):
    """percuss has refused the deck, or failed. Attributes: text, code."""

    def __init__(self, text: str, code: int) -> None:
        super().__init__(text)
        self.text, self.code = text, code


class Trial:
    """Attributes: scene (of check --json), error (of a deck that refuses overlap, else empty), run (of the first steps,
    or None), run_error, program."""

    def __init__(self, program: str, deck: str, options: Iterable[str], folder: str) -> None:
        self.program, self.deck, self.options, self.folder = program, deck, list(options), folder
        self.error = self.run_error = ""
        self.run: Run | None = None
        self._steps_measured, self._step_time = 0, 0.0
        self._check()
        self._run_steps()

    def _call(self, *words: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run([self.program, *words], capture_output=True, text=True, errors="replace", timeout=3600,
                              check=False)

    def _check(self) -> None:
        done = self._call("check", self.deck, "--json", *self.options)
        if done.returncode == 2 and "overlap" in done.stderr:  # such a scene is what one wants to see
            self.error = done.stderr.strip()
            self.options += ["--set", "contact.overlap=accept"]
            done = self._call("check", self.deck, "--json", *self.options)
        if done.returncode != 0:
            raise Refused(self.error or done.stderr.strip(), done.returncode)
        self.scene = json.loads(done.stdout)

    def _run_steps(self) -> None:
        first = self._run(FIRST_STEPS, "first")
        if first is None or first.status != "completed":
            return
        seconds = _loop_time(first)
        self._steps_measured, self._step_time = first.summary["steps"], seconds / max(1, first.summary["steps"])
        wanted = int(min(MOST_STEPS, LONGER_RUN / max(self._step_time, 1e-6), self.scene["steps"]))
        if wanted < 2 * FIRST_STEPS:
            return
        longer = self._run(wanted, "longer")
        if longer is not None and longer.status == "completed" and longer.summary["steps"] > first.summary["steps"]:
            self.run = longer
            self._steps_measured = longer.summary["steps"] - first.summary["steps"]
            self._step_time = (_loop_time(longer) - seconds) / self._steps_measured
            if not self._step_time > 0:  # other programs have slowed the first run down
                self._step_time = _loop_time(longer) / longer.summary["steps"]

    def _run(self, steps: int, name: str) -> Run | None:
        """A run of some steps, or None if not even a frame of it was written."""
        out = os.path.join(self.folder, name)
        done = self._call("run", self.deck, "--out", out, "--quiet", "--force", *self.options, *self._settings(steps))
        if done.returncode != 0:
            self.run_error = done.stderr.strip() or f"the run ended with exit code {done.returncode}"
        try:
            run = percuss.Run(out)
        except percuss.NotResults:
            return None
        if run.has_fields and self.run is None:
            self.run = run
        return run

    def _settings(self, steps: int) -> list[str]:
        """Frames of the start and the end alone, with what the drawing needs; a row for each step."""
        output = self.wanted_output
        end = self.scene["end"]
        names = []
        for fields in [output.get("fields") or {}, *_field_outputs(output).values()]:
            names += [name for name in fields.get("write") or [] if name not in names]
        names += [name for name in FIELDS_HERE if name not in names]
        settings = [f"time.max_steps={steps}", f"output.fields={{every: {end!r}, write: [{', '.join(names)}]}}"]
        if "field_outputs" in output:
            settings.append("output.field_outputs={}")
        if "history" in output:
            settings.append("output.history.every=0")
        return [word for setting in settings for word in ("--set", setting)]

    @property
    def wanted_output(self) -> dict[str, Any]:
        """The deck's `output`, with what --set changes."""
        return Deck(self.scene["values"]).get_map("output")

    # --- what follows -------------------------------------------------------------------------------------------------

    @property
    def step_time(self) -> float:
        """Seconds per step, output left out; 0 where nothing was measured."""
        return self._step_time

    @property
    def steps_measured(self) -> int:
        return self._steps_measured

    def predict(self) -> list[tuple[str, str, str]]:
        """[(what, value, how it comes about)], of what is known."""
        scene, rows = self.scene, []
        steps = scene["steps"]
        rows.append(("steps", f"{steps:,.0f}", "time.end over the first step; deformation makes steps shorter"))
        if self.step_time and self.run is not None:
            summary = self.run.summary
            cores = summary["ranks"] * summary["threads"]
            rows.append(("run time", format_seconds(steps * self.step_time),
                         f"{1e3 * self.step_time:.3g} ms per step, measured over {self.steps_measured} steps on "
                         f"{cores} core{'s' * (cores != 1)}{self.describe_load()}; more contact makes steps longer"))
            rows.append(("memory", format_bytes(summary["peak_bytes"]), "largest so far, of one rank"))
        for name, size, how in self.find_sizes():
            rows.append((name, format_bytes(size), how))
        return rows

    def describe_load(self) -> str:
        """That other programs disturb the measurement, where they do."""
        load, cores = os.getloadavg()[0], os.cpu_count() or 1
        return f" while other programs used this machine (load {load:.1f}, {cores} cores)" if load > 1.5 * cores else ""

    def find_sizes(self) -> list[tuple[str, float, str]]:
        """[(file, bytes, how many of what)] that a whole run writes."""
        output, end, sizes = self.wanted_output, self.scene["end"], list[tuple[str, float, str]]()
        if self.run is not None and self.run.has_fields:
            sizes += self._find_sizes_of_fields(self.run.fields, output, end)
        every = _number((output.get("history") or {}).get("every"))
        if "history" in output and self.run is not None and self.run.has_history:
            rows = self.scene["steps"] if not every else min(self.scene["steps"], end / every)
            size = _find_row_size(os.path.join(self.run.folder, "history.csv"))
            sizes.append(("history", (rows + 1) * size, f"{rows + 1:,.0f} rows of {size:.0f} bytes"))
        path = os.path.join(self.run.folder, "checkpoint.h5") if self.run is not None else ""
        wanted = output.get("checkpoint") or {}
        several = "every" in wanted or "wall" in wanted
        if os.path.exists(path) and (several or wanted.get("at_end", True)):
            sizes.append(("checkpoints", (1 + several) * os.path.getsize(path),
                          "the last two" if several else "that of the end"))
        return sizes

    def _find_sizes_of_fields(self, fields: Fields, output: dict[str, Any], end: float) -> list[tuple[str, float, str]]:
        shown = {of["name"]: (of["nodes"], of["elements"]) for of in self.scene["field_outputs"]}
        wanted: dict[str, tuple[dict[str, Any], tuple[int, int] | None]]
        wanted = {"fields": (output.get("fields") or {}, None)}
        wanted.update({f"fields_{name}": (of, shown.get(name)) for name, of in _field_outputs(output).items()})
        sizes: list[tuple[str, float, str]] = []
        for name, (of, items) in wanted.items():
            every = _number(of.get("every"))
            if not every:
                continue
            frames = math.floor(end / every * (1 + 1e-12)) + 1
            frames += end / every > frames - 1 + 1e-9
            formats = of.get("format") or "vtkhdf"
            size = find_frame_size(fields, of.get("write") or [], items)
            size *= len(formats) if isinstance(formats, list) else 1
            sizes.append((name, frames * size, f"{frames:,} frames of {format_bytes(size)}"))
        return sizes


def _field_outputs(output: dict[str, Any]) -> dict[str, dict[str, Any]]:
    """The entries of output.field_outputs by their names."""
    entries = output.get("field_outputs")
    return {name: of for name, of in entries.items() if isinstance(of, dict)} if isinstance(entries, dict) else {}


def _number(value: Any) -> float:
    try:
        return float(value)
    except (TypeError, ValueError):
        return 0.0


def _loop_time(run: Run) -> float:
    return max(0.0, float((run.summary["loop_s"] or 0) - run.summary["phases_s"].get("output", 0)))


def find_frame_size(fields: Fields, wanted: Iterable[str], shown: tuple[int, int] | None = None) -> int:
    """Bytes of a frame with these fields: what the file holds of each node and element, points included. shown: nodes
    and elements, where they are not those of the file."""
    nodes, elements = shown or (fields.nodes, fields.elements)
    size = 24 * nodes
    for group, items in (("PointData", nodes), ("CellData", elements)):
        for name, data in fields.root[group].items():
            if name in wanted or name in ALWAYS_WRITTEN:
                size += items * data.dtype.itemsize * int(math.prod(data.shape[1:]))
    return size


def _find_row_size(path: str) -> float:
    with open(path, "rb") as file:
        rows = file.read().splitlines()[1:]
    return ROW_GROWTH * len(rows[-1]) + 1 if rows else 0


def format_bytes(size: float) -> str:
    for unit in ("bytes", "kB", "MB", "GB"):
        if size < 1000 or unit == "GB":
            return f"{size:.3g} {unit}" if unit != "bytes" else f"{size:.0f} bytes"
        size /= 1000
    return ""


def format_seconds(seconds: float) -> str:
    if seconds < 1:
        return "less than 1 s"
    for limit, length, unit in ((90, 1, "s"), (5400, 60, "min"), (172800, 3600, "h")):
        if seconds < limit:
            return f"{seconds / length:.2g} {unit}" if seconds < 10 * length else f"{seconds / length:.0f} {unit}"
    return f"{seconds / 86400:.2g} days"


def split_messages(text: str) -> list[str]:
    """Messages of percuss, a text each: a message begins with a place or with 'percuss:'."""
    found: list[str] = []
    for line in text.splitlines():
        if re.match(r"(\S.*:\d+:\d+|percuss|--set \S+): ", line) or not found:
            found.append(line)
        else:
            found[-1] += "\n" + line
    return found
