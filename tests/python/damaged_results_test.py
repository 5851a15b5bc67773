#!/usr/bin/env python3
"""Damaged results: whatever stands in a folder, the tools say in one message what is wrong with it, or show what they can."""

import argparse
import contextlib
import copy
import io
import json
import math
import os
import random
import shutil
import tempfile
import unittest
import warnings
from unittest import mock

from given import PERCUSS, require

require("h5py", "numpy", "matplotlib.figure")

import h5py
import numpy as np

import percuss  # noqa: E402
import sample_run  # noqa: E402
from percuss.plot.drawing import Plot  # noqa: E402
from percuss.plot.panels import choose_panels  # noqa: E402
from percuss.plot.series import Options, prepare_history  # noqa: E402
from percuss.report import page  # noqa: E402
from percuss.watch.rows import Rows  # noqa: E402
from percuss.watch.screen import make_line, make_screen  # noqa: E402

SETTINGS = ["output.history.forces=[{name: hit, contact: [block, all]}, {name: clamp, support: plate/x_min}]",
            "output.history.nodes=[{name: top, part: block, near: [0.01, 0.01, 0.02]}]", "title=Damage"]
TEXTS = ("summary.json", "columns.json", "history.csv", "ranks.csv", "run.lock")
VALUES = (None, [], {}, "x", "\x1b[2J", -1, 1e308, True, 10**40, [[]], {"a": None}, "9" * 400, -10**18, 0, "\ud800")
ROUNDS = int(os.environ.get("PERCUSS_DAMAGES", 8))


def show(folder, other):
    """What report, plot, watch and the Python module do with a folder, but for pictures."""
    options = argparse.Namespace(field=None, view=None, pictures=False, interactive=False, plot=[], x="time")
    text = page.make_page([percuss.Run(folder)], options)
    page.make_page([percuss.Run(other), percuss.Run(folder)], options)
    run = percuss.Run(folder)
    rows = Rows(os.path.join(folder, "history.csv"))
    rows.read()
    text += "".join(make_screen(run, rows, run.summary.get("end_time"), 3.0, (80, True))) + make_line(run, rows, 1.0, None)
    if run.has_history:
        history = run.history
        text += "".join(history.unit(name) + history.meaning(name) for name in [*history, *history.derived])
        shown = Plot([("a", run, prepare_history(run, Options()))], Options())
        panels = choose_panels([], [history])
        if panels:
            shown.draw_all(panels, (4, 4), run.title)
    if os.path.exists(os.path.join(folder, "ranks.csv")):
        text += str(run.ranks)
    return text


class OfARun(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = folder.name
        cls.good = sample_run.run(PERCUSS, folder.name, *[word for setting in SETTINGS for word in ("--set", setting)])

    def try_damage(self, damage, what, draws=False):
        """damage(folder) changes a copy; what came of it: the text that was shown, or the message. draws: also with Matplotlib, which
        takes most of the time."""
        bad = os.path.join(self.folder, "bad")
        shutil.rmtree(bad, ignore_errors=True)
        shutil.copytree(self.good, bad)
        damage(bad)
        with mock.patch("percuss.report.page.write_svg", return_value=""), warnings.catch_warnings(), \
                contextlib.redirect_stderr(io.StringIO()), np.errstate(all="ignore"), contextlib.ExitStack() as stack:
            if not draws:
                for name in ("draw_one", "draw_all"):
                    stack.enter_context(mock.patch.object(Plot, name))
            warnings.simplefilter("ignore")
            try:
                return show(bad, self.good)
            except percuss.NotResults as error:
                self.assertIn(bad, str(error), what)
                self.assertLess(len(str(error)), 2000, what)
                return str(error)
            except Exception as error:
                raise AssertionError(f"{what}: {type(error).__name__}: {error}") from error


def write(folder, name, data):
    with open(os.path.join(folder, name), "wb") as file:
        file.write(data)


def read(folder, name):
    with open(os.path.join(folder, name), "rb") as file:
        return file.read()


class Texts(OfARun):
    def test_undamaged_results_are_shown(self):
        self.assertIn("Damage", self.try_damage(lambda folder: None, "nothing"))

    def test_cut_and_changed_bytes(self):
        choose = random.Random(46)
        for name in TEXTS[:4]:
            data = read(self.good, name)
            for number in range(ROUNDS):
                changed = bytearray(data)
                kind, place = number % 4, choose.randrange(len(data))
                if kind == 0:
                    del changed[place:]
                elif kind == 1:
                    changed[place:place + 1] = bytes(choose.choices(b"\x00\xff\x1b,\"{}[]\n-e9", k=choose.randrange(1, 4)))
                elif kind == 2:
                    del changed[place : place + choose.randrange(1, 200)]
                else:
                    changed[place:place] = changed[choose.randrange(len(data)):][:200]
                self.try_damage(lambda folder: write(folder, name, bytes(changed)), f"{name}, round {number}")

    def test_what_is_no_file_or_no_text(self):
        for name in (*TEXTS, "fields.vtkhdf", "checkpoint.h5"):
            for number, damage in enumerate((lambda path: os.remove(path), lambda path: (os.remove(path), os.mkdir(path)),
                                             lambda path: (os.remove(path), os.mkfifo(path)), lambda path: (os.remove(path), os.symlink("/nowhere", path)),
                                             lambda path: open(path, "wb").close(), lambda path: (os.remove(path), os.symlink(path, path)))):
                def change(folder, name=name, damage=damage):
                    path = os.path.join(folder, name)
                    write(folder, name, b"") if not os.path.lexists(path) else None
                    damage(path)

                self.try_damage(change, f"{name}, damage {number}")
        for name in TEXTS:
            self.try_damage(lambda folder: write(folder, name, "gr\u00f6\u00dfe,\u00b5".encode("latin-1") * 9), f"{name} in Latin-1")


def list_paths(tree, path=()):
    """Paths of all values of a JSON tree."""
    items = tree.items() if isinstance(tree, dict) else enumerate(tree) if isinstance(tree, list) else ()
    for key, value in items:
        yield (*path, key)
        yield from list_paths(value, (*path, key))


class Json(OfARun):
    def test_values_of_other_types(self):
        choose = random.Random(47)
        for name in ("summary.json", "columns.json"):
            tree = json.loads(read(self.good, name))
            paths = list(list_paths(tree))
            for path in choose.sample(paths, min(len(paths), 5 * ROUNDS)):
                changed = copy.deepcopy(tree)
                place = changed
                for key in path[:-1]:
                    place = place[key]
                value = choose.choice((*VALUES, "gone"))
                if value == "gone":
                    del place[path[-1]]
                else:
                    place[path[-1]] = value
                self.try_damage(lambda folder: write(folder, name, json.dumps(changed).encode("utf-8", "surrogatepass")),
                                f"{name}, {'.'.join(map(str, path))} = {value!r}"[:200])

    def test_a_name_that_is_a_list(self):
        def change(folder):
            columns = json.loads(read(folder, "columns.json"))
            columns["columns"][3]["dimension"] = 5
            write(folder, "columns.json", json.dumps(columns).encode())

        self.assertIn("'columns.3.dimension' is not a text", self.try_damage(change, "a dimension that is a number"))


class Tables(OfARun):
    def change(self, work):
        def damage(folder):
            lines = [line.split(",") for line in read(folder, "history.csv").decode().splitlines()]
            lines = work(lines) or lines
            write(folder, "history.csv", "".join(",".join(line) + "\n" for line in lines).encode())

        return damage

    def test_without_each_column(self):
        names = read(self.good, "history.csv").decode().splitlines()[0].split(",")
        needed = ("time", "step", "dt", "kinetic", "momentum_y")
        for column, name in enumerate(names):
            if name not in needed and column % 5:
                continue
            found = self.try_damage(self.change(lambda lines: [line[:column] + line[column + 1:] for line in lines]), f"without {name}")
            if name in needed:
                self.assertIn(f"there is no column {name}", found)

    def test_columns_without_finite_values_and_times_that_stand_still(self):
        names = read(self.good, "history.csv").decode().splitlines()[0].split(",")
        trials = [(column, value) for column in range(len(names)) for value in ("nan", "inf", "1e308", "0", "5e-324")]
        for number, (column, value) in enumerate(random.Random(49).sample(trials, min(len(trials), 8 * ROUNDS))):
            def fill(lines):
                for line in lines[1:]:
                    line[column] = value

            self.try_damage(self.change(fill), f"{names[column]} is {value}", number % 8 == 0)
        for count in (0, 1, 2, 3):
            self.try_damage(self.change(lambda lines: lines[: 1 + count]), f"{count} rows")
        self.try_damage(self.change(lambda lines: lines[:1] + lines[:0:-1]), "rows backwards")
        self.try_damage(self.change(lambda lines: lines[:1]), "no row")

    def test_rows_that_are_none(self):
        found = self.try_damage(self.change(lambda lines: lines[:5] + [["1", "2"]] + lines[5:]), "a short row")
        self.assertIn("this is no row of", found)
        for value in ("", "one", "0x1p3", "1_000", "\u0663"):
            def put(lines):
                lines[4][2] = value

            self.try_damage(self.change(put), f"a value {value!r}")
        for heading in ('"', '"a', "time,time", "a\x00b", '"time","dt"'):
            self.try_damage(self.change(lambda lines: [[heading], *lines[1:]]), f"the heading {heading!r}")


class Frames(OfARun):
    def test_cut_and_changed_bytes(self):
        choose, data = random.Random(48), read(self.good, "fields.vtkhdf")
        for number in range(ROUNDS):
            changed = bytearray(data)
            if number % 3 == 0:
                del changed[choose.randrange(len(data)):]
            else:
                for _ in range(1 + number):
                    changed[choose.randrange(min(len(data), 20000))] ^= 1 << choose.randrange(8)
            self.try_damage(lambda folder: write(folder, "fields.vtkhdf", bytes(changed)), f"fields.vtkhdf, round {number}")

    def test_without_each_dataset_or_with_another(self):
        with h5py.File(os.path.join(self.good, "fields.vtkhdf"), "r") as file:
            names = []
            file.visit(names.append)
        trials = [(name, kind) for name in names for kind in ("gone", "empty", "text", "float", "large")]
        for name, kind in random.Random(50).sample(trials, min(len(trials), 10 * ROUNDS)):
            def damage(folder):
                with h5py.File(os.path.join(folder, "fields.vtkhdf"), "r+") as file:
                    old = file[name]
                    shape = old.shape if isinstance(old, h5py.Dataset) else (3,)
                    del file[name]
                    if kind == "empty":
                        file[name] = np.empty(0)
                    elif kind == "text":
                        file[name] = "text"
                    elif kind == "float":
                        file[name] = np.full(shape, math.nan)
                    elif kind == "large":
                        file[name] = np.full(shape, 10**15)

            self.try_damage(damage, f"{name} is {kind}")


if __name__ == "__main__":
    unittest.main()
