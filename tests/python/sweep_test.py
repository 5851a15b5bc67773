"""percuss sweep: sweep_test.py ROOT PERCUSS. Exit code 77 (skipped) without NumPy, h5py or Matplotlib; samples where SciPy is."""

import csv
import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest

from given import PERCUSS, ROOT, require

require("h5py", "matplotlib", "numpy")

import numpy as np

try:
    import scipy
except ImportError:
    scipy = None

from tool_command import call_tool  # noqa: E402
from percuss.sweep.designs import BadDesign, cross, parse_factor, read_designs, sample  # noqa: E402
from percuss.sweep.statistics import correlate, find_main_effect, place_inputs, rank  # noqa: E402

ENVIRONMENT = dict(os.environ, PERCUSS_PROGRAM=PERCUSS)
CUBE = """\
units: m, kg, s
time: {end: 1.0e-4}
parts:
  cube: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, material: steel}
materials:
  steel: {model: elastic, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0}
initial: [{part: cube, velocity: [2, 0, 0]}]
output: {history: {every: 1.0e-5}}
"""


class Designs(unittest.TestCase):
    def test_values_ranges_lists_and_keys_together(self):
        self.assertEqual(parse_factor("a.b=1, 2,3").values, ["1", "2", "3"])
        self.assertEqual(parse_factor("a=5..9:5").values, ["5", "6", "7", "8", "9"])
        self.assertEqual(parse_factor("a=1e3..1e6:4:log").values, ["1000", "10000", "100000", "1000000"])
        self.assertEqual(parse_factor("a=[8, 8],[16, 16]").values, ["[8, 8]", "[16, 16]"])
        self.assertEqual(parse_factor("a=-4..-2:3").values, ["-4", "-3", "-2"])
        (design,) = cross([parse_factor("a.x,b.x=7")])
        self.assertEqual(design.settings, ["a.x=7", "b.x=7"])
        self.assertEqual([str(d) for d in cross([parse_factor("a=1,2"), parse_factor("b=x,y")])], ["a=1, b=x", "a=1, b=y", "a=2, b=x", "a=2, b=y"])

    def test_wrong_ones_have_a_word(self):
        for text, words in (("a", "no key with values"), ("a=", "no key with values"), ("=3", "no key with values"), ("a=1,,2", "an empty value"), ("a=1,1", "a value twice"),
                            ("a=9..5:3", "LOW below HIGH"), ("a=-1..5:3:log", "must be above zero"), ("a=1..2:1", "the count must be 2 to"), ("a=1..2:x", "is no range"),
                            ("a=0..3:9:int", "fewer values than its count"), ("a b=1", "no key with values")):
            with self.assertRaisesRegex(BadDesign, words, msg=text):
                parse_factor(text)
        for factors, words in ((["a=1", "a=2"], "'a' varies twice"), (["a=1..2"], "a range without a count"), (["a=0..1:2000", "b=0..1:2000"], "more than 10000 designs")):
            with self.assertRaisesRegex(BadDesign, words, msg=factors):
                cross([parse_factor(text) for text in factors])

    @unittest.skipUnless(scipy, "SciPy is not here")
    def test_a_latin_hypercube_has_one_design_in_each_stratum(self):
        factors = [parse_factor("a=10..20"), parse_factor("b=1..1e4:log"), parse_factor("c=x,y"), parse_factor("n=1..4:int")]
        designs = sample(factors, "lhs:20", 3)
        a = np.array([float(d.inputs["a"]) for d in designs])
        self.assertEqual(sorted((2 * (a - 10)).astype(int)), list(range(20)))
        b = np.array([float(d.inputs["b"]) for d in designs])
        self.assertEqual(sorted((5 * np.log10(b)).astype(int)), list(range(20)))
        self.assertEqual([sum(d.inputs["c"] == word for d in designs) for word in "xy"], [10, 10])
        self.assertEqual([sum(d.inputs["n"] == word for d in designs) for word in "1234"], [5] * 4)
        self.assertEqual([d.inputs for d in sample(factors, "lhs:20", 3)], [d.inputs for d in designs])
        self.assertNotEqual([d.inputs for d in sample(factors, "lhs:20", 4)], [d.inputs for d in designs])
        sobol = np.array([float(d.inputs["a"]) for d in sample(factors[:2], "sobol:16")])
        self.assertEqual(sorted((1.6 * (sobol - 10)).astype(int)), list(range(16)))  # a net: one in each sixteenth
        with self.assertRaisesRegex(BadDesign, "neither lhs:N nor sobol:N"):
            sample(factors, "grid:3")

    def test_a_table_of_designs(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "designs.csv")
            for encoding, first in (("utf-8", "# of a test\n"), ("utf-8-sig", "# of a test\n"), ("utf-8-sig", "")):  # as spreadsheets write it
                with open(path, "w", encoding=encoding, newline="") as file:
                    file.write(first + 'a.b,"c,d"\r\n1,"[2, 3]"\r\n4,5\r\n')
                designs = read_designs(path)
                self.assertEqual([d.settings for d in designs], [["a.b=1", "c=[2, 3]", "d=[2, 3]"], ["a.b=4", "c=5", "d=5"]])


class Statistics(unittest.TestCase):
    def test_coefficients_and_effects_of_known_data(self):
        x = np.array([1.0, 2, 3, 4])
        self.assertAlmostEqual(correlate(x, np.array([2.0, 1, 4, 3])), 0.6)
        self.assertAlmostEqual(correlate(rank(x), rank(np.exp(x))), 1.0)
        self.assertTrue(np.isnan(correlate(x, np.ones(4))))
        self.assertEqual(list(rank(np.array([5.0, 1, 5, 9]))), [1.5, 0, 1.5, 3])
        self.assertEqual(find_main_effect(np.array([1.0, 2, 1, 2]), np.array([1.0, 10, 3, 30])), [(1, 2, 2), (2, 20, 2)])
        self.assertEqual([count for _, _, count in find_main_effect(np.arange(20.0), np.arange(20.0))], [4] * 5)
        six = np.array([3.0, 1, 6, 2, 5, 4])
        self.assertEqual(find_main_effect(six, 10 * six), [(1.5, 15, 2), (3.5, 35, 2), (5.5, 55, 2)])
        self.assertEqual(find_main_effect(six, 10 * six, is_alone=True), [(float(x), 10.0 * x, 1) for x in range(1, 7)])
        self.assertEqual(place_inputs(["b", "a", "b"])[1], ["b", "a"])


class Sweep(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        with open(os.path.join(self.folder, "cube.yaml"), "w", encoding="utf-8") as file:
            file.write(CUBE)

    def command(self, *words):
        return [sys.executable, "-m", "percuss", "sweep", "cube.yaml", *words]

    def sweep(self, *words, code=0):
        done = call_tool("sweep", "cube.yaml", *words, folder=self.folder, **ENVIRONMENT)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done

    def read(self, name="cube_sweep"):
        with open(os.path.join(self.folder, name, "sweep.csv"), encoding="utf-8") as file:
            self.assertTrue(file.readline().startswith("# Written by percuss sweep"))
            return list(csv.DictReader(file))

    def test_a_free_cube_has_the_energy_and_momentum_of_its_design(self):
        self.sweep("--vary", "materials.steel.density=1000,-5,2000", "--vary", "initial.0.velocity.0=1,3", "--output",
                   "energy = max(kinetic)", "--output", "momentum_x", "--output", "wide = first(kinetic) / 2", "--output", "mine [g] = last(kinetic) / first(kinetic)")
        rows = self.read()
        self.assertEqual([row["mine [g]"] for row in rows], ["1", "1", "", "", "1", "1"])
        self.assertEqual([row["state"] for row in rows], ["completed", "completed", "refused", "refused", "completed", "completed"])
        for row in rows:
            if row["state"] != "completed":
                self.assertIn("density", row["error"])
                continue
            density, speed = float(row["materials.steel.density"]), float(row["initial.0.velocity.0"])  # of a cubic metre
            self.assertAlmostEqual(float(row["energy [J]"]), density * speed**2 / 2, delta=1e-6 * density)
            self.assertAlmostEqual(float(row["wide [J]"]), density * speed**2 / 4, delta=1e-6 * density)
            for way in ("peak", "mean", "last"):
                self.assertAlmostEqual(float(row[f"momentum_x.{way} [kg\u00b7m/s]"]), density * speed, delta=1e-6 * density)
        with open(os.path.join(self.folder, "cube_sweep/sweep.html"), encoding="utf-8") as file:
            page = file.read()
        for words in ("4 completed", "2 refused", "Correlation", "<svg", "0.88 (0.89)"):
            self.assertTrue(words in page, words)

    def test_finished_designs_are_known_by_the_content_of_the_deck(self):
        self.sweep("--vary", "initial.0.velocity.0=1,3")
        stamps = {row["folder"]: os.stat(os.path.join(self.folder, "cube_sweep", row["folder"], "history.csv")).st_mtime_ns for row in self.read()}
        path = os.path.join(self.folder, "cube.yaml")
        with open(path, "w", encoding="utf-8") as file:
            file.write("# a comment\n" + CUBE.replace("1.0e-4", "0.1e-3"))  # the same content
        done = self.sweep("--vary", "initial.0.velocity.0=5,3.0,1")
        self.assertEqual(done.stdout.count("completed before"), 2)
        for row in self.read():
            if row["folder"] in stamps:
                self.assertEqual(os.stat(os.path.join(self.folder, "cube_sweep", row["folder"], "history.csv")).st_mtime_ns, stamps[row["folder"]])
        with open(path, "w", encoding="utf-8") as file:
            file.write(CUBE.replace("1e9", "2e9"))
        self.assertNotIn("before", self.sweep("--vary", "initial.0.velocity.0=1,3").stdout)

    def test_an_interrupt_leaves_checkpoints_that_the_same_command_goes_on_from(self):
        self.interrupt(signal.SIGINT)

    def test_a_sweep_in_the_background_ends_likewise(self):
        self.interrupt(signal.SIGTERM)

    def interrupt(self, sent):
        words = ("--vary", "initial.0.velocity.0=1,3", "--set", "time.end=4", "--set", "time.max_step=1e-5", "--set",
                 "output.history.every=1", "--output", "last(momentum_x)", "--jobs", "2")
        # As behind & in a script: SIGINT is ignored, and SIGTERM must not be.
        process = subprocess.Popen(self.command(*words), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, cwd=self.folder, env=ENVIRONMENT,
                                   preexec_fn=(lambda: signal.signal(signal.SIGINT, signal.SIG_IGN)) if sent == signal.SIGTERM else None)
        folder, end = os.path.join(self.folder, "cube_sweep"), time.monotonic() + 60
        while time.monotonic() < end and sum(os.path.exists(os.path.join(folder, name, "summary.json"))
                                             for name in (os.listdir(folder) if os.path.isdir(folder) else ())) < 2:
            time.sleep(0.02)
        process.send_signal(sent)
        error = process.communicate(timeout=100)[1]
        self.assertEqual(process.returncode, 130, error)
        states = [percuss_status(os.path.join(folder, name)) for name in os.listdir(folder)]
        self.assertEqual(states, ["interrupted"] * 2)
        self.sweep(*words, "--set", "time.max_steps=1", "--list")
        self.sweep(*words, "--only", "2")
        self.assertEqual(sorted(percuss_status(os.path.join(folder, name)) for name in os.listdir(folder)), ["completed", "interrupted"])
        self.sweep(*words)
        self.assertEqual([row["state"] for row in self.read()], ["completed"] * 2)

    def test_warnings_of_a_design_stand_in_table_page_and_terminal(self):
        """Osmium, the densest of metals, has 22 600 kg/m3."""
        words = ("--vary", "materials.steel.density=1000,50000,2000,60000", "--vary", "initial.0.velocity.0=1", "--set", "silence=[end_time, wave_speed]")
        for _ in ("run", "found again"):
            done = self.sweep(*words)
            self.assertEqual([row["warnings"] for row in self.read()], ["", "density", "", "density"])
            self.assertEqual(done.stdout.count("warnings: density)"), 2)
            self.assertIn("2 of 4 designs warn of density (design 2: density 50000 of material", done.stdout)
            with open(os.path.join(self.folder, "cube_sweep/sweep.html"), encoding="utf-8") as file:
                page = file.read()
            for text in ("4 completed, 2 with warnings", "<td>density</td>", "<td>2 of 4</td>", "<td>2, 4</td>", "density 50000 of material"):
                self.assertIn(text, page)

    def test_outputs_are_judged_before_the_first_run(self):
        for output, words, text in (("kinetik", (), "did you mean kinetic?"), ("kinetic + momentum_x", (), "different dimensions"),
                                    ("max(kinetic", (), "is no expression"), ("max(kinetic)", ("--set", "output.history=~"), "output.history")):
            done = self.sweep("--vary", "initial.0.velocity.0=1,2", "--output", output, *words, code=2)
            self.assertIn(text, done.stderr)
            self.assertEqual(os.listdir(os.path.join(self.folder, "cube_sweep")), [], output)

    def test_wrong_words_end_with_2_before_all_runs_are_made(self):
        for words, text in ((("--vary", "initial.0.velocity.0=1", "--output", "kinetik"), "did you mean kinetic?"),
                            (("--vary", "initial.0.velocity.0=1", "--output", "mex(kinetic)"), "did you mean max?"),
                            (("--vary", "materials.steel.densitty=1"), "did you mean 'density'?"),
                            (("--vary", "a=1..2"), "--sample"), ((), "nothing varies"), (("--designs", "none.csv"), "none.csv"),
                            (("--vary", "a=1", "--only", "2"), "there is no design 2")):
            self.assertIn(text, self.sweep(*words, code=2).stderr)

    def test_a_job_array_has_a_task_for_each_design(self):
        text = self.sweep("--vary", "initial.0.velocity.0=1,3,4", "--output", "max(kinetic)", "--threads", "4", "--job-array").stdout
        self.assertIn("#SBATCH --array=1-3\n", text)
        self.assertIn("#SBATCH --cpus-per-task=4\n", text)
        call = text.splitlines()[-1]
        self.assertIn("'max(kinetic)'", call)
        self.assertTrue(call.startswith("exec percuss sweep cube.yaml"))
        shell = call.replace("exec percuss sweep", f"exec '{sys.executable}' -m percuss sweep").replace("cube.yaml", f"'{self.folder}/cube.yaml'")
        for task in "132":
            done = subprocess.run(["bash", "-c", shell], capture_output=True, text=True, timeout=100, cwd=self.folder,
                                  env=dict(ENVIRONMENT, SLURM_ARRAY_TASK_ID=task, SLURM_CPUS_PER_TASK="1"))
            self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.sweep("--vary", "initial.0.velocity.0=1,3,4").stdout.count("completed before"), 3)

    @unittest.skipUnless(scipy, "SciPy is not here")
    def test_the_example_finds_the_parameters_behind_an_exact_curve(self):
        done = subprocess.run([sys.executable, os.path.join(ROOT, "inputs/calibration/calibrate.py"), os.path.join(self.folder, "fit")],
                              capture_output=True, text=True, timeout=500, env=ENVIRONMENT)
        self.assertEqual(done.returncode, 0, done.stderr)
        found = dict(line.split("=") for line in done.stdout.splitlines() if line.startswith("materials."))
        self.assertAlmostEqual(float(found["materials.steel.yield_stress"]) / 310e6, 1, delta=0.005)
        self.assertAlmostEqual(float(found["materials.steel.hardening_modulus"]) / 900e6, 1, delta=0.02)


def percuss_status(folder):
    from percuss.results.run import Run

    return Run(folder).status


if __name__ == "__main__":
    unittest.main()
