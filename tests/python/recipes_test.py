"""Runs a recipe of docs as it is written, and compares its numbers with formulas: recipes_test.py NAME ROOT PERCUSS.

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

try:
    import h5py  # noqa: F401
    import matplotlib  # noqa: F401
    import numpy as np
    import scipy  # noqa: F401
    import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
    import yaml  # noqa: F401
except ImportError as error:
    print(f"skipped: {error}; scripts/install_dependencies --report installs what this test needs")
    sys.exit(77)
if not shutil.which("Xvfb") and not os.environ.get("DISPLAY"):
    print("skipped: no display and no Xvfb; scripts/install_dependencies --report installs one")
    sys.exit(77)

PERCUSS, ROOT, NAME = sys.argv.pop(), sys.argv.pop(), sys.argv.pop()
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

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = folder.name
        os.symlink(os.path.join(ROOT, "inputs"), os.path.join(cls.folder, "inputs"))
        with open(os.path.join(ROOT, f"docs/recipe_{NAME}.md"), encoding="utf-8") as file:
            cls.page = file.read()
        cls.table = read_table(cls.page)
        cls.unsaid, printed = [], ""
        for kind, lines in list_blocks(cls.page):
            if kind == "commands":
                printed = cls.run_lines(lines)
            else:
                cls.unsaid += [line for line in lines if line.strip() and not is_said(line, printed)]

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


RECIPES = {"ballistic": Ballistic}


def load_tests(loader, _tests, _pattern):
    return loader.loadTestsFromTestCase(RECIPES[NAME])


if __name__ == "__main__":
    unittest.main()
