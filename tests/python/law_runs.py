"""What tests of laws of one's own have in common: a cube whose nodes follow conditions, run with the library law.so."""

import json
import os
import subprocess
import tempfile
import unittest

import numpy as np

UNIAXIAL = ["{nodes: cube, fixed: [y, z]}", "{nodes: cube/x_min, fixed: [x]}", "{nodes: cube/x_max, velocity: {x: 100}}"]


def write_cube(law, end, motion, cells=1, more=""):
    """A cube of 1 x 1 x 1 m whose nodes follow `motion`, each a condition."""
    conditions = "\n".join(f"  - {line}" for line in motion)
    return (f"time: {{end: {end}}}\nparts: {{cube: {{box: {{size: [1, 1, 1], cells: [{cells}, {cells}, {cells}]}}, material: m}}}}\n"
            f"materials: {{m: {{{law}}}}}\nelements: {{bulk_viscosity: {{linear: 0, quadratic: 0}}}}\nconditions:\n{conditions}\n"
            "output: {history: {every: 0, elements: [{name: all, id: 1}]}}\n" + more)


class LawTest(unittest.TestCase):
    PERCUSS = ""  # the executable

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def write(self, name, text):
        with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
            file.write(text)
        return name

    def call(self, deck, *options, command="run", allow=("--allow-library", "law.so"), launcher=()):
        self.write("deck.yaml", deck)
        return subprocess.run([*launcher, self.PERCUSS, command, "deck.yaml", *allow, *options], cwd=self.folder, capture_output=True,
                              text=True, check=False)

    def run_deck(self, deck, *options, out="out", **how):
        done = self.call(deck, "--quiet", "--force", "--out", out, *options, **how)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(os.path.join(self.folder, out, "history.csv"), encoding="utf-8") as file:
            names = [name.split(" ")[0] for name in file.readline().strip().split(",")]
        table = np.loadtxt(os.path.join(self.folder, out, "history.csv"), delimiter=",", skiprows=1, ndmin=2)
        with open(os.path.join(self.folder, out, "summary.json"), encoding="utf-8") as file:
            summary = json.load(file)
        return {name: table[:, i] for i, name in enumerate(names)}, summary
