"""Runs a recipe of docs as it is written, and compares its numbers with formulas: recipes_test.py ROOT PERCUSS [NAME...].

Indented blocks are commands, run in order in a new folder that has `inputs`. A line that ends in `# exit code N` must end with N. Lines of
the ```text block below must be in what they print; numbers may differ by 2 %. In a table of `quantity | by formula | run` the
formula is computed here and the run is read. Exit code 77 (skipped) where a tool of the recipe is missing.
"""

import csv
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

from given import PERCUSS, ROOT, WORDS, require, skip

require("h5py", "matplotlib", "numpy", "vtkmodules.vtkRenderingOpenGL2", "yaml", "scipy.signal")

import h5py
import numpy as np
from scipy.signal import butter, filtfilt

if not shutil.which("Xvfb") and not os.environ.get("DISPLAY"):
    skip("no display and no Xvfb; scripts/install_dependencies --report installs one")

NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")


def list_blocks(page):
    """(kind, lines) of the page, in order: `commands` and `text`."""
    blocks: list[tuple[str, list[str]]] = []
    body: list[str] = []
    fence, before = None, ""
    for line in page.splitlines():
        if fence is not None:
            if line.startswith("```"):
                if fence == "text":
                    blocks.append(("text", body))
                fence = None
            else:
                body.append(line)
        elif line.startswith("```"):
            fence, body = line[3:], []
        elif line.startswith("    "):
            if not blocks or blocks[-1][0] != "commands" or not before.startswith("    "):
                blocks.append(("commands", []))
            blocks[-1][1].append(line[4:])
        before = line
    return blocks


def is_said(line, printed):
    """Whether a line of the page is in the output: the words as they are, numbers within 2 %."""
    words = [re.escape(word) for word in re.split(r"\s+", NUMBER.sub("@", line.strip()))]
    pattern = r"\s+".join(words).replace("@", "(" + NUMBER.pattern + ")")
    wanted = [float(number) for number in NUMBER.findall(line)]
    return any(all(abs(float(a) - b) <= 0.02 * abs(b) for a, b in zip(found.groups(), wanted)) for found in re.finditer(pattern, printed))


def read_table(page):
    """{quantity: [number by formula, number of the run]} of the recipe's table; None where a cell has no number."""
    rows, inside = {}, False
    for line in page.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if cells == ["quantity", "by formula", "run"]:
            inside = True
        elif not line.startswith("|"):
            inside = False
        elif inside and not set(line) <= set("|-: "):
            numbers = [NUMBER.search(cell) for cell in cells[1:]]
            rows[cells[0]] = [float(number.group()) if number else None for number in numbers]
    return rows


class History:
    def __init__(self, folder):
        with open(os.path.join(folder, "history.csv"), encoding="utf-8") as file:
            rows = list(csv.reader(file))
        self.names, self.rows = rows[0], np.array(rows[1:], dtype=float)

    def __getitem__(self, name):
        return self.rows[:, self.names.index(name)]


class Recipe(unittest.TestCase):
    """Runs the page once, for all tests of a recipe."""

    __test__ = False  # it has no page: pytest runs its subclasses alone
    name = ""

    def __init_subclass__(cls):
        cls.__test__ = True

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = folder.name
        os.symlink(os.path.join(ROOT, "inputs"), os.path.join(cls.folder, "inputs"))
        cls.page = cls.read_page()
        cls.table = read_table(cls.page)
        cls.unsaid, printed = [], ""
        for kind, lines in list_blocks(cls.page):
            if kind == "commands":
                printed = cls.run_lines(lines)
            else:
                cls.unsaid += [line for line in lines if line.strip() and not is_said(line, printed)]

    @classmethod
    def read_page(cls):
        with open(os.path.join(ROOT, f"docs/recipe_{cls.name}.md"), encoding="utf-8") as file:
            return file.read()

    @classmethod
    def run_lines(cls, lines):
        """What the lines print, each run by its own in the folder where the one before it ended."""
        path = os.pathsep.join([os.path.dirname(PERCUSS), os.path.dirname(sys.executable), os.environ["PATH"]])
        environment = dict(os.environ, PATH=path, PERCUSS_PYTHON=sys.executable)
        printed = []
        for line in "\n".join(lines).replace("\\\n", " ").split("\n"):
            script = f'cd "$(cat "$0/place" 2>/dev/null || echo "$0")"\n{line}\ncode=$?; pwd > "$0/place"; exit $code'
            done = subprocess.run(["bash", "-c", script, cls.folder], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=500,
                                  env=environment)
            code = re.search(r"# exit code (\d+)$", line)
            if done.returncode != (int(code.group(1)) if code else 0):
                raise AssertionError(f"exit code {done.returncode}: {line}\n{done.stdout}")
            printed.append(done.stdout)
        return "".join(printed)

    def place(self, *path):
        with open(os.path.join(self.folder, "place"), encoding="utf-8") as file:
            return os.path.join(file.read().strip(), *path)

    def compare(self, quantity, formula, run, within):
        """The page has what the formula gives, rounded, and what the run gives; both agree within a share."""
        self.assertIn(quantity, self.table)
        on_page, of_run = self.table[quantity]
        self.assertLess(abs(on_page / formula - 1), 0.006, f"{quantity}: the formula gives {formula:g}")
        if of_run is not None:
            self.assertLess(abs(run / formula - 1), within, f"{quantity}: the run gives {run:g}, the formula {formula:g}")
            self.assertLess(abs(of_run / run - 1), 0.02, f"{quantity}: the run gives {run:g}")

    def test_every_line_of_output_is_as_written(self):
        self.assertEqual(self.unsaid, [])

    def test_pictures_of_the_page_are_there(self):
        for picture in re.findall(r"!\[[^]]*\]\(([^)]+)\)", self.page):
            self.assertTrue(os.path.exists(os.path.join(ROOT, "docs", picture)), picture)


class Ballistic(Recipe):
    """Recht and Ipson: v_r = M / (M + m) sqrt(v^2 - v_limit^2)."""

    name = "ballistic"

    def read_sweep(self):
        with open(self.place("sweep/sweep.csv"), encoding="utf-8") as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
        return {float(row["initial.0.velocity.2"]): float(row["v_residual [mm/ms]"]) for row in rows}

    def test_residual_velocities(self):
        mass, plug = 7.85e-3 * np.pi * 5**2 * 20, 2.7e-3 * np.pi * 5**2 * 4
        a = mass / (mass + plug)
        of_run = 4 * History(self.place("v200"))["mass:projectile"][0]
        self.compare("mass M of the projectile", mass, of_run, 0.01)  # a polygon of 20 sides
        self.compare("a, with a plug of 0.848 g", a, None, 0)
        seen = self.read_sweep()
        self.assertLess(seen[120], 0, "it rebounds")
        self.assertGreater(seen[140], 0)
        limit = 138.6
        for v, within in ((350, 0.04), (160, 0.02)):
            name = next(quantity for quantity in self.table if quantity.startswith(f"residual velocity at {v} m/s"))
            self.compare(name, a * np.sqrt(v**2 - limit**2), seen[v], within)

    def test_balances(self):
        history = History(self.place("v200"))
        self.assertLess(abs(history["energy_error"]).max(), 1e-4)
        self.assertLess(history["hourglass"][-1], 0.1 * history["internal"][-1])
        momentum = history["momentum_z:projectile"][0] - history["momentum_z:projectile"][-1]
        impulse = -np.sum(history["fz:impact"][1:] * np.diff(history["time"]))
        self.assertLess(abs(impulse / momentum - 1), 0.01)


class BoltedJoint(Recipe):
    """The faying surface of n bolts slips at mu n F."""

    name = "bolted_joint"

    def test_slip_load(self):
        history, mu, preload = History(self.place("slip")), 0.2, 20e3
        begin = history["time"] < 4e-5
        bolts = history["fz:bolt_1"] + history["fz:bolt_2"]
        self.compare("force of both bolts at the start, 2 x 20 kN", 2 * preload / 1e3, bolts[begin][5:].max() / 1e3, 0.005)
        name = "friction of the faying surface as it slips, mu n F_preload"
        self.compare(name, mu * 2 * preload / 1e3, -history["fx:faying"].min() / 1e3, 0.08)
        slips = history["time"] > 2.5e-4
        used = np.hypot(history["fx:faying"], history["fy:faying"])[slips] / history["fz:faying"][slips]
        self.compare("friction used, mu", mu, used.mean(), 0.005)
        pull = history["fx:pull"][slips].mean()
        self.compare("pull at the end, 2 mu n F with F = 18.3 kN", 2 * mu * 2 * 18.3, pull / 1e3, 0.04)
        self.assertLess(abs(pull / (2 * mu * bolts[slips].mean()) - 1), 0.04)

    def test_balances(self):
        history = History(self.place("slip"))
        self.assertLess(abs(history["energy_error"]).max(), 1e-6)
        self.assertLess(history["hourglass"][-1], 0.1 * history["internal"][-1])


class Drop(Recipe):
    """The impulse of the floor is the change of momentum; its peak is near that of a half-sine."""

    name = "drop"

    def test_impulse(self):
        history = History(self.place("fall"))
        mass = 1.05e-9 * 2.5 * 2 * (120 * 80 + 120 * 40 + 80 * 40) + 2.5e-9 * 80 * 50 * 15
        v, time = np.sqrt(2 * 9810 * 1000), history["time"]
        self.compare("momentum before, m sqrt(2 g h)", mass * v, -history["momentum_z"][0], 0.001)
        impulse = np.sum(history["fz:floor"][1:] * np.diff(time))
        name = "impulse of the floor, m (v + v') + m g t with v' = 2373 mm/s"
        self.compare(name, mass * (v + 2373 + 9810 * time[-1]), impulse, 0.005)
        touching = time[history["fz:floor"] > 0]
        self.assertAlmostEqual(1e3 * (touching[-1] - touching[0]), 1.096, delta=0.02)
        peak = np.pi / 2 * mass * (v + 2373 + 9810 * time[-1]) / 1.096e-3
        self.compare("peak force, of a half-sine over T = 1.096 ms", peak / 1e3, history["fz:floor"].max() / 1e3, 0.06)
        even = np.arange(time[0], time[-1], 2e-6)  # CFC 1000 of SAE J211: a Butterworth filter of two poles, forwards and backwards
        acceleration = np.gradient(np.interp(even, time, history["sensor_vz"]), even)
        felt = filtfilt(*butter(2, 2.0775 * 1000, fs=1 / 2e-6), acceleration).max()
        self.compare("peak acceleration, of that force over the mass", peak / mass / 9810, felt / 9810, 0.08)

    def test_balances_and_orientation(self):
        history = History(self.place("fall"))
        self.assertLess(abs(history["energy_error"]).max(), 1e-4)
        self.assertLess(history["hourglass"][-1], 0.1 * history["internal"][-1])
        with h5py.File(self.place("fall/fields.vtkhdf")) as file:
            points = file["VTKHDF/Points"][: int(file["VTKHDF/NumberOfPoints"][0])]
        housing, battery = 1.05e-9 * 2.5 * 35200, 2.5e-9 * 60000
        center = (housing * np.array([60, 40, 20]) + battery * np.array([60, 40, 8.9])) / (housing + battery)  # in the file, from the corner
        lowest = points[points[:, 2].argmin()]
        self.assertAlmostEqual(lowest[2], 1.25 + 0.05, delta=1e-6)
        top = points[np.linalg.norm(points - lowest, axis=1).argmax()]  # the opposite corner, at (120, 80, 40) of the file
        cosine = center @ [120, 80, 40] / np.linalg.norm(center) / np.linalg.norm([120, 80, 40])
        self.assertAlmostEqual((top - lowest)[2] / np.linalg.norm(top - lowest), cosine, delta=1e-6, msg="the centre stands above the corner")


class CrashBox(Recipe):
    """Abramowicz and Jones: the mean force of progressive folding."""

    name = "crash_box"

    def test_mean_force_and_energy(self):
        history = History(self.place("box"))
        way, speed = history["wall_displacement:barrier"], history["wall_speed:barrier"]
        force, mass = -history["fz:barrier"], 200.0
        mean = np.sum((force[1:] + force[:-1]) / 2 * np.diff(way)) / way[-1]
        formula = 52.22 * (60 / 2) ** (1 / 3) * 300 * 2**2 / 4
        self.compare("mean crush force, of c = 60 mm, t = 2 mm, s0 = 300 MPa", formula / 1e3, mean / 1e3, 0.1)
        lost = mass / 2 * (10**2 - (speed[-1] / 1e3) ** 2) / 1e3
        (name,) = [quantity for quantity in self.table if quantity.startswith("energy that the barrier has lost")]
        self.compare(name, lost, mean * way[-1] / 1e6, 0.005)
        impulse = np.sum(force[1:] * np.diff(history["time"]))
        (name,) = [quantity for quantity in self.table if quantity.startswith("impulse of the barrier")]
        self.compare(name, mass * (10 - speed[-1] / 1e3), impulse, 0.005)

    def test_balances(self):
        history = History(self.place("box"))
        self.assertLess(abs(history["energy_error"]).max(), 1e-4)
        self.assertLess(history["hourglass"][-1], 0.05 * history["internal"][-1])
        self.assertLess(history["added_mass"][-1], 0.2 * history["mass:crash_box"][0])


class FirstRun(Recipe):
    """The deck and the commands of the README."""

    name = "first_run"

    @classmethod
    def read_page(cls):
        with open(os.path.join(ROOT, "README.md"), encoding="utf-8") as file:
            section = file.read().split("## A deck of your own\n")[1].split("\n## ")[0]
        with open(os.path.join(cls.folder, "ball.yaml"), "w", encoding="utf-8") as file:
            file.write(section.split("```yaml\n")[1].split("```")[0])
        os.mkdir(os.path.join(cls.folder, "build"))
        os.symlink(os.path.dirname(PERCUSS), os.path.join(cls.folder, "build/release"))
        return section

    def test_pictures_of_the_page_are_there(self):
        for picture in re.findall(r"!\[[^]]*\]\(([^)]+)\)", self.page):
            self.assertTrue(os.path.exists(os.path.join(ROOT, picture)), picture)

    def test_the_force_is_a_pulse_that_one_would_show(self):
        history = History(self.place("ball"))
        force, time = history["fz:impact"], history["time"]
        impulse = np.sum(force[1:] * np.diff(time))
        momentum = history["momentum_z:ball"]
        self.assertLess(abs(impulse / (momentum[-1] - momentum[0]) - 1), 0.01)
        self.assertEqual(force[-1], 0, "the ball has left the plate")
        level = force[(time > 5e-5) & (time < 4e-4)]
        self.assertLess(np.std(np.diff(level)), 0.05 * level.mean(), "no saw-tooth")
        self.assertLess(level.max(), 1.4 * level.mean())


RECIPES = {recipe.name: recipe for recipe in (FirstRun, CrashBox, Drop, Ballistic, BoltedJoint)}


def load_tests(loader, _tests, _pattern):
    return unittest.TestSuite(loader.loadTestsFromTestCase(RECIPES[name]) for name in WORDS or RECIPES)


if __name__ == "__main__":
    unittest.main()
