"""What tests of laws of one's own have in common: the words of TEST ROOT PERCUSS [MPIEXEC ...], compilers, and a cube whose nodes follow
conditions, run with the library law.so.

Exit code 77 (skipped) without NumPy or a compiler that a test needs.
"""

import json
import os
import shutil
import subprocess
import tempfile
import unittest

from given import MPIEXEC, PERCUSS, ROOT, require, skip

require("numpy")

import numpy as np

EXAMPLE = os.path.join(ROOT, "inputs", "user_law")
UNIAXIAL = ["{nodes: cube, fixed: [y, z]}", "{nodes: cube/x_min, fixed: [x]}", "{nodes: cube/x_max, velocity: {x: 100}}"]


def need(*compilers):
    missing = [name for name in compilers if not shutil.which(name)]
    if missing:
        skip(f"no {' and no '.join(missing)}; scripts/install_dependencies --ci installs them")


def write_cube(law, end, motion, cells=1, more=""):
    """A cube of 1 x 1 x 1 m whose nodes follow `motion`, each a condition."""
    conditions = "\n".join(f"  - {line}" for line in motion)
    return (f"time: {{end: {end}}}\nparts: {{cube: {{box: {{size: [1, 1, 1], cells: [{cells}, {cells}, {cells}]}}, material: m}}}}\n"
            f"materials: {{m: {{{law}}}}}\nelements: {{bulk_viscosity: {{linear: 0, quadratic: 0}}}}\nconditions:\n{conditions}\n"
            "output: {history: {every: 0, elements: [{name: all, id: 1}]}}\n" + more)


class LawTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def write(self, name, text):
        with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
            file.write(text)
        return name

    def read(self, *path):
        with open(os.path.join(self.folder, *path), encoding="utf-8") as file:
            return file.read()

    def compile_file(self, source, *options, compiler="cc"):
        """law.so."""
        subprocess.run([compiler, "-shared", "-fPIC", *options, "-o", "law.so", source], cwd=self.folder, check=True)

    def compile_text(self, text):
        """Of C."""
        self.compile_file(self.write("law.c", text), "-O1")

    def call(self, deck, *options, command="run", allow=("--allow-library", "law.so"), launcher=()):
        self.write("deck.yaml", deck)
        return subprocess.run([*launcher, PERCUSS, command, "deck.yaml", *allow, *options], cwd=self.folder, capture_output=True,
                              text=True, check=False)

    def run_deck(self, deck, *options, out="out", **how):
        done = self.call(deck, "--quiet", "--force", "--out", out, *options, **how)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(os.path.join(self.folder, out, "history.csv"), encoding="utf-8") as file:
            names = [name.split(" ")[0] for name in file.readline().strip().split(",")]
        table = np.loadtxt(os.path.join(self.folder, out, "history.csv"), delimiter=",", skiprows=1, ndmin=2)
        return {name: table[:, i] for i, name in enumerate(names)}, json.loads(self.read(out, "summary.json"))

    def continue_run(self, deck, steps=20):
        """The hash of a run that is stopped after some steps and continued; its results are in `again`."""
        self.run_deck(deck, "--set", f"time.max_steps={steps}", out="half")
        done = self.call(deck, "--quiet", "--restart", "half/checkpoint.h5", "--force", "--out", "again")
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(self.read("again", "summary.json"))["state_hash"]

    def check_bits(self, deck):
        """A run, in `whole`, has the bits of one that is continued, and of one on two ranks; returns its summary."""
        summary = self.run_deck(deck, out="whole")[1]
        self.assertEqual(self.continue_run(deck), summary["state_hash"])
        if MPIEXEC:
            self.assertEqual(self.run_deck(deck, out="ranks", launcher=[*MPIEXEC, "2"])[1]["state_hash"], summary["state_hash"])
        return summary
