"""Runs a scene in ways that must not change a bit, and says what differs:
layouts, restarts, and work that is skipped."""

import csv
import json
import os
import random as randoms
import re
import shutil
import tempfile

import h5py
import numpy as np

from .families import make_scene
from .scene import write_deck

# Each gives up work that a run leaves out or finds in another way.
# The search changes how many pairs are candidates, and nothing else.
SWITCHES = ("elements.skip_resting=false", "contact.reuse_search=false", "contact.search=points_in_box",
            "contact.rebalance=always")
LAYOUTS = {"1x1": dict(ranks=1), "1x2": dict(ranks=1, threads=2), "2x1": dict(ranks=2), "3x1": dict(ranks=3)}
# Keys of summary.json that may differ (docs/output.md), and what says how a run came to its end.
OWN_KEYS = {"ranks", "threads", "setup_s", "loop_s", "grind_ns", "phases_s", "skipped", "balance", "messages",
            "decomposition", "peak_bytes", "deck", "restart_changes", "earlier"}
OWN_WARNINGS = {"idle_ranks", "crowded_cores", "lost_frames", "oversubscribed"}
MOST_DRAWS = 8


class Scenes:
    """Scenes by the schema of a program."""

    def __init__(self, program):
        self.program = program
        self.schema = json.loads(program.call("schema"))

    def make(self, seed):
        return make_scene(seed, self.schema)


def compare_scene(program, scenes, seed, most_ranks=3):
    """({kind: what}, figures, deck). A draw that the program refuses as wrong input is replaced by the next one."""
    folder = tempfile.mkdtemp(prefix="percuss_bits_")
    try:
        for draw in range(MOST_DRAWS):
            deck, steps = scenes.make(f"{seed}/{draw}")
            path = os.path.join(folder, "deck.yaml")
            with open(path, "w", encoding="utf-8") as file:
                file.write(write_deck(deck))
            base = Run(program, path, os.path.join(folder, "base"))
            if base.code != 2:
                failures = Comparison(program, path, folder, base, randoms.Random(seed), most_ranks).find_failures()
                return failures, {"draw": draw, "steps": base.steps, "rests": base.rests, "code": base.code}, deck
        return {}, {"draw": MOST_DRAWS, "refused": 1}, None
    finally:
        shutil.rmtree(folder, ignore_errors=True)


class Run:
    """A run and what must be the same of all."""

    def __init__(self, program, path, out, *options, **place):
        self.out = out
        self.code, self.text = program.run(path, out, *options, **place)
        self.summary = {}
        summary = os.path.join(out, "summary.json")
        if os.path.exists(summary):
            with open(summary, encoding="utf-8") as file:
                self.summary = json.load(file)
        self.steps = self.summary.get("steps", 0)
        self.rests = self.summary.get("skipped", {}).get("chunk_updates", 0)

    def list_differences(self, other, own_columns=()):
        """own_columns: of the history, that may differ."""
        if self.code != other.code:
            return [f"exit code {other.code} is {self.code}: {self.text[-400:]}"]
        found = []
        if self.find_error() != other.find_error():
            found.append(f"error '{other.find_error()}' is '{self.find_error()}'")
        found += [f"{key} {other.summary.get(key)} is {self.summary.get(key)}"
                  for key in sorted({*self.summary, *other.summary})
                  if key not in OWN_KEYS | {"warnings", "error"} and self.summary.get(key) != other.summary.get(key)]
        found += compare_warnings(self.summary.get("warnings", []), other.summary.get("warnings", []))
        return found + compare_history(self.out, other.out, own_columns) + compare_fields(self.out, other.out)

    def find_error(self):
        """Without the paths of files."""
        return re.sub(r"\S*/", "", self.summary.get("error", ""))


class Comparison:
    def __init__(self, program, path, folder, base, random, most_ranks):
        self.program, self.path, self.folder, self.base, self.random = program, path, folder, base, random
        self.layouts = {name: place for name, place in LAYOUTS.items() if place["ranks"] <= most_ranks}

    def run(self, name, *options, **place):
        return Run(self.program, self.path, os.path.join(self.folder, name), *options, **place)

    def find_failures(self):
        if self.base.code not in (0, 3):
            return {"run": f"exit code {self.base.code}: {self.base.text[-600:]}"}
        failures = {}
        for name, place in self.layouts.items():
            if name != "1x1":
                self._note(failures, name, self.run(name, **place))
        with open(self.path, encoding="utf-8") as file:
            sections = file.read()
        switches = [switch for switch in SWITCHES if "contact:" in sections or not switch.startswith("contact")]
        self._note(failures, "switches", self.run("switches", *_set(switches), **self._draw_place()), {"candidates"})
        if "switches" in failures:
            for switch in switches:
                self._note(failures, switch, self.run(switch.partition("=")[0], *_set([switch])), {"candidates"})
        if self.base.code == 0 and self.base.steps > 1:
            self._restart(failures)
        return failures

    def _restart(self, failures):
        """From a random step, each piece on some layout."""
        step = self.random.randint(1, self.base.steps - 1)
        name, first, second = f"restart at step {step}", self._draw_place(), self._draw_place()
        begun = self.run("restart", *_set([f"time.max_steps={step}"]), **first)
        if begun.code != 0:
            failures[name] = f"the first piece ends with {begun.code}: {begun.text[-400:]}"
            return
        checkpoint = os.path.join(begun.out, "checkpoint.h5")
        self._note(failures, name, self.run("restart", "--restart", checkpoint, "--force", **second))

    def _draw_place(self):
        return self.layouts[self.random.choice(sorted(self.layouts))]

    def _note(self, failures, name, run, own_columns=()):
        if differences := run.list_differences(self.base, own_columns):
            failures[name] = "; ".join(differences)[:1500]


def _set(settings):
    return [word for setting in settings for word in ("--set", setting)]


def compare_warnings(now, wanted):
    def key(warning):
        return tuple(str(warning.get(name)) for name in ("rule", "place", "text", "time", "count"))

    now, wanted = ({key(warning) for warning in warnings if warning["rule"] not in OWN_WARNINGS}
                   for warnings in (now, wanted))
    return [*(f"warning lost: {warning}" for warning in sorted(wanted - now)),
            *(f"warning only here: {warning}" for warning in sorted(now - wanted))]


def compare_history(now, wanted, own_columns):
    tables = []
    for folder in (now, wanted):
        path = os.path.join(folder, "history.csv")
        if os.path.exists(path):
            with open(path, encoding="utf-8", newline="") as file:
                tables.append(list(csv.reader(file)))
    if len(tables) < 2:
        return ["history.csv is missing"] if tables else []
    names = tables[1][0]
    for i, (row, expected) in enumerate(zip(*tables)):
        if differing := [name for name, a, b in zip(names, row, expected) if a != b and name not in own_columns]:
            return [f"history.csv: {', '.join(differing[:6])} in row {i}"]
    return [] if len(tables[0]) == len(tables[1]) else [f"history.csv: {len(tables[1])} rows are {len(tables[0])}"]


def compare_fields(now, wanted):
    names = [os.path.join(folder, "fields.vtkhdf") for folder in (now, wanted)]
    if not all(os.path.exists(name) for name in names):
        return []
    with h5py.File(names[0]) as a, h5py.File(names[1]) as b:
        return _compare_groups(a, b)


def _compare_groups(now, wanted):
    lists = []
    for file in (now, wanted):
        names = []
        file.visititems(lambda name, item, names=names: names.append(name) if isinstance(item, h5py.Dataset) else None)
        lists.append(sorted(names))
    if lists[0] != lists[1]:
        return ["fields.vtkhdf has other data sets"]
    return [f"fields.vtkhdf: {name} differs" for name in lists[0] if not _are_same(now[name][()], wanted[name][()])][:3]


def _are_same(a, b):
    a, b = np.asarray(a), np.asarray(b)
    return a.shape == b.shape and a.dtype == b.dtype and a.tobytes() == b.tobytes()
