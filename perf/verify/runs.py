"""Starts percuss on a deck and reads what it leaves."""
import json
import os
import pathlib
import resource
import shutil
import string
import subprocess
import sys
import time

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "python"))
import percuss.results.history  # noqa: E402


def fill(template, **values):
    """A deck: the template with $name replaced. Numbers keep all their digits."""

    def text(value):
        return repr(float(value)) if isinstance(value, (float, np.floating)) else str(value)

    return string.Template(template).substitute({name: text(value) for name, value in values.items()})


class History(dict):
    """history.csv, an array a column, with what measurements ask of it."""

    def at(self, time, column):
        """Value at a time, linear between rows."""
        return float(np.interp(time, self["time"], self[column]))

    def mean(self, start, end, column):
        """Time average from start to end."""
        inside = (self["time"] >= start) & (self["time"] <= end)
        t, y = self["time"][inside], self[column][inside]
        return float(np.trapz(y, t) / (t[-1] - t[0]))

    def steady(self, start, end, column):
        """Mean from start to end under a window of Hann, in which ringing of many periods cancels."""
        inside = (self["time"] >= start) & (self["time"] <= end)
        t, y = self["time"][inside], self[column][inside]
        weight = 1 - np.cos(2 * np.pi * (t - t[0]) / (t[-1] - t[0]))
        return float(np.trapz(weight * y, t) / np.trapz(weight, t))

    def time_of_rise(self, column, level):
        """First time at which the column rises through the level, linear between rows."""
        y, t = self[column], self["time"]
        i = int(np.flatnonzero((y[:-1] < level) & (y[1:] >= level))[0])
        return float(t[i] + (t[i + 1] - t[i]) * (level - y[i]) / (y[i + 1] - y[i]))

    def last(self, column):
        return float(self[column][-1])

    def first(self, column):
        return float(self[column][0])

    def largest(self, column):
        """The largest magnitude."""
        return float(np.max(np.abs(self[column])))


def read_history(path):
    table = percuss.results.history.read_history(path)
    return History((name, table[name]) for name in table)


class Frames:
    """Fields of a run: positions, corners of elements, node and element fields by frame."""

    def __init__(self, path):
        from percuss.results.fields import Fields
        self.fields = Fields(path)
        self.times, self.count = self.fields.times, len(self.fields.times)
        self.num_nodes, self.num_elements = self.fields.nodes, self.fields.elements
        self.corners, self.part = self.fields.hexahedra, self.fields.part

    def points(self, frame=-1):
        return self.fields.positions(frame)

    def node(self, name, frame=-1):
        return self.fields.data(name, frame)

    def element(self, name, frame=-1):
        return self.fields.data(name, frame)

    def nodes_of_part(self, part):
        return np.unique(self.corners[self.part == part])


class Run:
    """One run: exit code, standard error, seconds (wall and CPU of all ranks), summary, history, frames."""

    def __init__(self, folder, code, errors, seconds, cpu):
        self.folder, self.code, self.errors, self.seconds, self.cpu = folder, code, errors, seconds, cpu
        summary, history = folder / "summary.json", folder / "history.csv"
        self.summary = json.loads(summary.read_text()) if summary.exists() else {}
        self.history = read_history(history) if history.exists() else History()

    @property
    def frames(self):
        return Frames(self.folder / "fields.vtkhdf")

    @property
    def history_bytes(self):
        file = self.folder / "history.csv"
        return file.read_bytes() if file.exists() else b""


def start(options, folder, deck, ranks=1, command="run", libraries=()):
    """Runs the deck in the folder on so many ranks of one thread; waits for its end. libraries: what it may load."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    path = folder / "deck.yaml"
    path.write_text(deck)
    results = folder / "results"
    words = [str(pathlib.Path(options.percuss).resolve()), command, str(path)]
    if command == "run":
        words += ["--quiet", "--force", "--out", str(results)]
    words += [word for library in libraries for word in ("--allow-library", str(library))]
    if ranks > 1:
        words = options.mpirun.split() + ["-n", str(ranks)] + words
    environment = dict(os.environ, OMP_NUM_THREADS="1", OMP_PROC_BIND="false", OMP_WAIT_POLICY="passive",
                       OMPI_MCA_mpi_yield_when_idle="1")
    before, begin = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    try:
        done = subprocess.run(words, env=environment, stdin=subprocess.DEVNULL, capture_output=True, text=True,
                              errors="replace", timeout=options.limit)
        code, errors = done.returncode, done.stderr
    except subprocess.TimeoutExpired:
        code, errors = None, f"still running after {options.limit} s"
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return Run(results, code, errors.strip(), time.monotonic() - begin, cpu)
