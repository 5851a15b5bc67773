"""percuss watch and percuss stop: watch_test.py ROOT PERCUSS."""

import os
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
from types import SimpleNamespace

from given import PERCUSS
import sample_run  # noqa: E402
from percuss.results.deck import Deck  # noqa: E402
from percuss.watch.rows import Rows  # noqa: E402
from percuss.watch.screen import format_duration, list_curves, make_progress, make_sparkline, name_limit  # noqa: E402


class Watch(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.out = sample_run.run(PERCUSS, cls.folder.name)

    def watch(self, *arguments):
        return subprocess.run([sys.executable, "-S", "-B", "-m", "percuss", "watch", *arguments], capture_output=True,
                              text=True, timeout=120, env=dict(os.environ, PYTHONIOENCODING="utf-8", COLUMNS="100"))

    def copy(self, status):
        folder = os.path.join(self.folder.name, status)
        shutil.copytree(self.out, folder)
        path = os.path.join(folder, "summary.json")
        with open(path, encoding="utf-8") as file:
            text = file.read().replace('"completed"', f'"{status}"')
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return folder

    def test_shows_a_run_that_has_ended_with_python_alone(self):
        done = self.watch(self.out)
        self.assertEqual(done.returncode, 0, done.stderr)
        for words in ("[completed]", "100.0 %", "of 0.0002", "kinetic", "energy error", "\u2588", "limits the step",
                      "[hourglass_energy]"):
            self.assertIn(words, done.stdout)
        self.assertLessEqual(max(map(len, done.stdout.splitlines())), 100)

    def test_says_that_the_number_of_steps_has_ended_it(self):
        out = sample_run.run(PERCUSS, self.folder.name, "--set", "time.max_steps=2", name="short")
        self.assertRegex(self.watch(out).stdout, r"\[completed, stopped by time.max_steps at [0-9.]+ % of time.end\]")

    def test_is_plain_where_the_terminal_is(self):
        done = self.watch(self.out, "--plain")
        self.assertTrue(done.stdout.isascii())

    def test_ends_with_the_code_of_the_run(self):
        for status, code in (("failed", 3), ("interrupted", 130), ("running", 4)):  # running without a run was killed
            self.assertEqual(self.watch(self.copy(status)).returncode, code, status)
        self.assertEqual(self.watch(os.path.join(self.folder.name, "failed"), "--once").returncode, 0)
        done = self.watch(os.path.join(self.folder.name, "nowhere"))
        self.assertEqual(done.returncode, 2)
        self.assertIn("there are no results of percuss", done.stderr)

    def test_ends_when_a_run_that_goes_on_ends(self):
        out = os.path.join(self.folder.name, "live")
        deck = os.path.join(self.folder.name, "deck.yaml")
        run = subprocess.Popen([PERCUSS, "run", deck, "--out", out, "--quiet"], stderr=subprocess.DEVNULL,
                               env=dict(os.environ, OMP_NUM_THREADS="1"))
        self.addCleanup(run.wait)
        while run.poll() is None and not os.path.exists(os.path.join(out, "summary.json")):
            pass
        done = self.watch(out, "--interval", "0.1")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("[completed]", done.stdout)


class RowsThatGrow(unittest.TestCase):
    def test_are_read_once_each_and_whole(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "history.csv")
            rows = Rows(path)
            self.assertFalse(rows.read())
            with open(path, "w", encoding="utf-8") as file:
                file.write('time,"a,b"\n0,1\n0.5,')
                file.flush()
                self.assertTrue(rows.read())
                self.assertEqual(rows.columns, {"time": [0], "a,b": [1]})
                file.write("2\n1,nan\n")
                file.flush()
                self.assertTrue(rows.read())
                self.assertFalse(rows.read())
            self.assertEqual(rows.columns["time"], [0, 0.5, 1])
            with open(path, "w", encoding="utf-8") as file:
                file.write("time,c\n7,8\n")
            self.assertTrue(rows.read())
            self.assertEqual(rows.columns, {"time": [7], "c": [8]})


class Screen(unittest.TestCase):
    def test_sparklines_go_from_the_least_to_the_largest(self):
        self.assertEqual(make_sparkline([0, 1, 2, 3, 4, 5, 6, 7], 8, "01234567"), "01234567")
        self.assertEqual(make_sparkline([0] * 50 + [9] + [0] * 49, 10, "01"), "0000010000")
        self.assertEqual(make_sparkline([3, 3], 10, "01"), "00")
        self.assertEqual(make_sparkline([0, float("nan"), 7], 3, "01"), "0x1")
        self.assertEqual(make_sparkline([float("inf")], 3), "")

    def test_progress_and_times(self):
        self.assertEqual(make_progress(0.5, 1, 10, True), "#####-----  50.0 %")
        self.assertEqual(make_progress(0.5, None, 10, True), "")
        self.assertEqual([format_duration(s) for s in (59.9, 61, 7260)], ["59 s", "1 min 01 s", "2 h 01 min"])

    def test_shows_the_magnitude_of_forces(self):
        rows = Rows("")
        rows.names = ["time", "fx:hit", "fy:hit", "fz:hit"]
        rows.columns = {"time": [0, 1], "fx:hit": [0, 3], "fy:hit": [0, -4], "fz:hit": [0, 12]}
        self.assertEqual(list_curves(rows)[-1], ("fx:hit", "|f| hit", [0, 13]))

    def test_names_what_limits_the_step(self):
        rows = Rows("")
        rows.names = ["dt_element", "dt_spring", "spring_force:a_1", "spring_elongation:a_1", "spring_force:b"]
        run = SimpleNamespace(deck=Deck({"springs": {"a": {}, "b": {}, "many": {}}}))
        for number, text in ((0, "element 7"), (1, "spring 'a_1'"), (2, "spring 'b'"), (-3, "a spring of 'many'"), (-4, "a spring")):
            rows.columns = {"dt_element": [7], "dt_spring": [number]}
            self.assertEqual(name_limit(run, rows), text + " limits the step")
        rows.columns = {"dt_element": [7]}
        self.assertEqual(name_limit(run, rows), "element 7 limits the step")
        rows.columns = {"dt_element": [0], "dt_spring": [0]}
        self.assertEqual(name_limit(run, rows), "the approach of bodies limits the step")
        rows.columns = {}
        self.assertEqual(name_limit(run, rows), "")


class Stop(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def stop(self, *arguments):
        return subprocess.run([sys.executable, "-S", "-B", "-m", "percuss", "stop", *arguments], capture_output=True,
                              text=True, timeout=120)

    def start(self, *settings):
        """A run that only a request ends."""
        deck, out = os.path.join(self.folder, "deck.yaml"), os.path.join(self.folder, "out")
        with open(deck, "w", encoding="utf-8") as file:
            file.write(sample_run.DECK.format(units="m, kg, s").replace("velocity: [0, 0, -50]", "velocity: [0, 0, 0.001]"))
        run = subprocess.Popen([PERCUSS, "run", deck, "--out", out, "--quiet", "--set", "time.end=1e6", "--set", "output.fields.every=1e6",
                                "--set", "output.history.every=1e6", "--set", "output.checkpoint.every=1e6", *(word for setting in settings for word in ("--set", setting))],
                               stderr=subprocess.DEVNULL,
                               env=dict(os.environ, OMP_NUM_THREADS="1", OMP_PROC_BIND="false"))
        self.addCleanup(lambda: run.poll() is None and (run.kill(), run.wait()))
        while not os.path.exists(os.path.join(out, "summary.json")) and run.poll() is None:
            time.sleep(0.01)
        return run, out

    def test_asks_an_active_run_for_a_frame_and_ends_it(self):
        run, out = self.start()
        done = self.stop(out, "--frame", "--checkpoint")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("writes a frame and a checkpoint", done.stdout)
        self.assertIsNone(run.poll())
        done = self.stop(out)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(run.wait(timeout=60), 130)
        for name in ("checkpoint.h5", "checkpoint_previous.h5"):
            self.assertTrue(os.path.exists(os.path.join(out, name)), name)
        with open(os.path.join(out, "history.csv"), encoding="utf-8") as file:
            self.assertEqual(len(file.readlines()), 4)  # heading, start, the frame's row, the end
        self.assertEqual(set(os.listdir(out)) & {"stop", "frame", "checkpoint"}, set())

    def test_says_which_of_frame_and_row_a_run_does_not_write(self):
        for settings, words, rows in ((["output={history: {every: 1e6}}"], "writes a row of the history without a frame (the deck has no", 4),
                                      (["sensors={late: {time: 1e6}}"], "writes a frame\n", 3),
                                      (["output={history: {every: 1e6}}", "sensors={late: {time: 1e6}}"], "writes no frame (the deck has no", 3)):
            run, out = self.start(*settings)
            self.assertIn(words, self.stop(out, "--frame").stdout)
            self.assertEqual(self.stop(out).returncode, 0)
            self.assertEqual(run.wait(timeout=60), 130)
            with open(os.path.join(out, "history.csv"), encoding="utf-8") as file:
                self.assertEqual(len(file.readlines()), rows)
            shutil.rmtree(out)

    def test_says_that_there_is_no_run(self):
        out = sample_run.run(PERCUSS, self.folder)
        for folder, words in ((out, "there is no active run in"), (out + "/nowhere", "there is no folder")):
            done = self.stop(folder)
            self.assertEqual(done.returncode, 2)
            self.assertIn(words, done.stderr)
        self.assertFalse(os.path.exists(os.path.join(out, "stop")))


if __name__ == "__main__":
    unittest.main()
