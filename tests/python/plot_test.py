"""percuss plot: plot_test.py ROOT PERCUSS. Exit code 77 (skipped) without NumPy, h5py or Matplotlib."""

import os
import re
import shlex
import signal
import subprocess
import tempfile
import unittest

from given import PERCUSS, require

require("h5py", "matplotlib.image", "numpy")

import matplotlib.image
import numpy as np

import percuss  # noqa: E402
import sample_run  # noqa: E402
from tool_command import call_tool  # noqa: E402
from percuss.results.history import History  # noqa: E402
from percuss.plot.panels import BadChoice, choose_panels, list_panels  # noqa: E402
from percuss.plot.series import Options, find_controlling_parts, make_curve, thin  # noqa: E402


class Plot(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.out = sample_run.run(PERCUSS, cls.folder.name)
        cls.run_ = percuss.read(cls.out)

    def plot(self, *arguments):
        return call_tool("plot", *arguments)

    def test_writes_png_and_svg_without_an_argument_more(self):
        done = self.plot(self.out)
        self.assertEqual(done.returncode, 0, done.stderr)
        picture = matplotlib.image.imread(os.path.join(self.out, "plot.png"))
        self.assertGreater((picture[..., :3].min(axis=2) < 0.9).mean(), 0.01)
        with open(os.path.join(self.out, "plot.svg"), encoding="utf-8") as file:
            text = file.read()
        for words in ("A block falls on a plate &amp; &lt;wall&gt;", "kinetic energy", "orce of the rigid walls in z", "controlled by block",
                      "time [\u00b5s]", "[J]", "[kg\u00b7m/s]", "N]", "[10\u207b"):
            self.assertTrue(words in text, words)
        for warning in self.run_.warnings:
            self.assertIn(warning["rule"], done.stdout)

    def test_labels_of_the_abscissa_do_not_touch(self):
        from percuss.plot.drawing import Plot as Drawing

        run = percuss.Run(self.out)
        for end in (2e-4, 2e-3, 0.0163, 0.25, 123456.0):
            time = np.linspace(0, end, 50)
            history = History(["time", "kinetic", "internal", "hourglass"], np.column_stack([time, time, time**2, time**3]))
            figure = Drawing([("run", run, history)], Options()).draw_all(choose_panels(["energies"] * 4, [history]), None)
            figure.canvas.draw()
            for axes in figure.axes:
                boxes = [label.get_window_extent() for label in axes.get_xticklabels() if label.get_text()]
                self.assertGreater(len(boxes), 3)
                for left, right in zip(boxes, boxes[1:]):
                    self.assertLess(left.x1 + 3, right.x0, f"labels of a time of {end}")

    def test_glue_has_panels_of_its_own(self):
        time = np.linspace(0, 1, 50)
        names = ["time", "kinetic", "internal", "glue_work", "glue_dissipated", "glue_failed"]
        history = History(names, np.column_stack([time, time, time, time, time**2, time]))
        panels = {panel.name: panel.columns for panel in choose_panels([], [history])}
        self.assertEqual((panels["glue"], panels["glue_failure"]), (["glue_work", "glue_dissipated"], ["glue_failed"]))

    def test_curves_that_coincide_are_drawn_once(self):
        from percuss.plot.drawing import Plot as Drawing

        time = np.linspace(0, 1, 50)
        table = np.column_stack([time, time, time**2, time**2 * (1 + 1e-12), -(time**2), np.zeros(50), np.zeros(50)])
        history = History(["time", "dt", "fx:a", "fx:b", "fx:c", "fx:d", "fx:e"], table)
        run = percuss.Run(self.out)
        for words, lines in (("fx:a,fx:b,fx:c", 2), ("fx:d,fx:e", 2), ("fx:a,fx:c", 2)):
            figure = Drawing([("run", run, history)], Options()).draw_one(choose_panels([words], [history])[0])
            self.assertEqual(len([line for line in figure.axes[0].lines if len(line.get_xdata()) == 50]), lines, words)
            texts = [text.get_text() for text in figure.axes[0].get_legend().get_texts()]
            self.assertEqual(len(texts), lines)
        self.assertNotIn("fx:b", texts)

    def test_panels_show_what_is_large_and_accelerations(self):
        names = ["time", "dt", "fx:hit", "fy:hit", "fz:hit", "tip_x", "tip_vx"]
        table = np.array([[0, 0, 0, 0, 0, 0, 1], [1, 1, 2, 100, 0.5, 0, 5], [2, 1, 0, 9, 0, 0, 9]], dtype=float)
        history = History(names, table, None, {name: {"dimension": "force"} for name in names[2:5]})
        panels = list_panels([history])
        self.assertEqual(panels["forces"].columns, ["fx:hit", "fy:hit"])  # the third is below a hundredth of the largest
        self.assertEqual(panels["accelerations"].columns, ["tip_ax"])
        self.assertEqual(choose_panels(["tip_a?"], [history])[0].columns, ["tip_ax"])

    def test_accelerometers_are_accelerations(self):
        names = ["time", "dt", "local_ax:chest", "local_dvx:chest", "tip_x", "tip_vx"]
        table = np.array([[0, 0, 0, 0, 0, 1], [1, 1, 2, 2, 0, 5]], dtype=float)
        sidecar = {"local_ax:chest": {"dimension": "length time^-2"}, "local_dvx:chest": {"dimension": "length time^-1"}}
        history = History(names, table, None, sidecar)
        self.assertEqual(list_panels([history])["accelerations"].columns, ["local_ax:chest", "tip_ax"])
        self.assertEqual(history.derived, ["tip_ax"])

    def test_draws_two_runs_filtered_and_in_other_units(self):
        path = os.path.join(self.folder.name, "two.svg")
        other = sample_run.run(PERCUSS, self.folder.name, "--set", "time.max_steps=100", name="short")
        done = self.plot(self.out, other, "energies", "dt", "--cfc", "1000", "--units", "mm, kg, ms", "--out", path)
        self.assertIn("shorter than one period of the cut-off frequency of CFC 1000", done.stderr)  # 0.2 ms of 0.6 ms
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(path, encoding="utf-8") as file:
            text = file.read()
        for words in (">short<", ">out<", "CFC 1000", "time [ms]"):
            self.assertTrue(words in text, words)

    def test_round_off_is_drawn_as_a_flat_curve(self):
        from percuss.plot.drawing import Plot as Drawing

        for last, flat in ((2 + 1e-13, True), (2.1, False)):
            history = History(["time", "momentum_x"], [[0, 2], [1, 2 - 1e-13], [2, last]])
            panel = list_panels([history])["momentum"]
            low, high = Drawing([("a", self.run_, history)], Options()).draw_one(panel).axes[0].get_ylim()
            self.assertEqual(high - low > 0.3, flat, (low, high))

    def test_draws_expressions_over_any_column(self):
        path = os.path.join(self.folder.name, "over.svg")
        done = self.plot(self.out, "loss = kinetic - first(kinetic)", "--x", "integral(wall_force_z)", "--out", path)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(path, encoding="utf-8") as file:
            text = file.read()
        for words in ("Loss", "integral(wall_force_z) [", "[J]"):
            self.assertTrue(words in text, words)

    def test_names_and_units_of_a_user_stand_as_they_are(self):
        path = os.path.join(self.folder.name, "named.svg")
        done = self.plot(self.out, "--x", "step", "mine [J] = 1e6 * kinetic", 'norm(kinetic, internal)', "--out", path, "kinetic * 1e6")
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(path, encoding="utf-8") as file:
            text = file.read()
        for words in (">Mine<", ">[J]<", ">norm(kinetic, internal)<", ">Kinetic * 1e6<", ">[MJ]<"):
            self.assertIn(words, text)

    def test_writes_what_it_draws_as_a_table(self):
        path = os.path.join(self.folder.name, "curves.csv")
        self.assertEqual(self.plot(self.out, "kinetic + internal", "--out", path).returncode, 0)
        with open(path, encoding="utf-8") as file:
            lines = file.read().splitlines()
        self.assertEqual(lines[1], "time [s],kinetic + internal [J]")
        history = self.run_.history
        np.testing.assert_array_equal(np.array([line.split(",") for line in lines[2:]], dtype=float),
                                      np.column_stack([history["time"], history["kinetic"] + history["internal"]]))

    def test_rates_runs_against_a_test(self):
        path, history = os.path.join(self.folder.name, "test.csv"), self.run_.history
        with open(path, "w", encoding="utf-8") as file:
            file.writelines(f"{float(t)!r},{float(y)!r},{float(y) - 1!r},{float(y) + 1!r}\n" for t, y in zip(history["time"], history["kinetic"]))
        done = self.plot(self.out, "kinetic", "--test", path, "--out", os.path.join(self.folder.name, "rated.png"))
        self.assertIn("rating 1.000 of 1 by ISO/TS 18571", done.stdout)
        self.assertIn("100 % of its points are within the corridor", done.stdout)
        self.assertIn("--test is for one curve", self.plot(self.out, "--test", path).stderr)

    def test_info_prints_tables_of_energies_and_forces(self):
        done = subprocess.run([PERCUSS, "info", self.out, "--energies", "--forces"], capture_output=True, text=True, timeout=120)
        self.assertEqual(done.returncode, 0, done.stderr)
        history = self.run_.history
        self.assertRegex(done.stdout, rf"kinetic +{history['kinetic'][0]:.5g} +{history['kinetic'][-1]:.5g} ")
        self.assertRegex(done.stdout, r"kinetic:block +\S")
        size = np.linalg.norm([history[f"wall_force_{axis}"] for axis in "xyz"], axis=0)
        self.assertRegex(done.stdout, "wall_force +all walls +" + re.escape(f"{size.max():.5g}") + " +" + re.escape(f"{history['time'][size.argmax()]:.5g}") + " +~")

    def test_lists_columns_with_units(self):
        done = self.plot(self.out, "--list")
        self.assertRegex(done.stdout, r"kinetic +J +kinetic energy")

    def test_ends_silently_with_what_reads_its_output(self):
        reader, writer = os.pipe()
        os.close(reader)
        for arguments in (["plot", self.out, "--list"], ["plot", "--help"], ["watch", self.out], ["import", "--help"]):
            done = subprocess.run([PERCUSS, *arguments], stdout=writer, stderr=subprocess.PIPE, text=True, timeout=120)
            self.assertEqual(done.returncode, -signal.SIGPIPE, arguments)
            self.assertEqual(done.stderr, "", arguments)
        os.close(writer)

    def test_examples_of_the_help_name_columns_that_a_run_has(self):
        done = self.plot("--help")
        self.assertTrue(done.stdout.startswith("Usage: percuss plot "), done.stdout)
        examples = done.stdout.split("Examples:\n")[1].split("\n\n")[0]
        columns = ["time", "wall_force_z", *(f"f{axis}:impact" for axis in "xyz"), *self.run_.history]
        history = History(columns, np.ones((3, len(columns))))
        for line in examples.splitlines():
            words = shlex.split(re.split(r"\s{2,}", line.strip())[0])[2:]
            options = next((i for i, word in enumerate(words) if word.startswith("--")), len(words))
            choose_panels([word for word in words[:options] if word not in ("ball", "ball_fine", "can", "box")], [history])

    def test_says_what_is_wrong(self):
        for arguments, words in (((self.out, "kinetics"), "there is no column 'kinetics'"), (("nowhere",), "no folder among nowhere"),
                                 ((self.out, "kinetics"), "did you mean kinetic? (percuss plot DIR --list shows all)"),
                                 ((self.out, "kinetic +"), "'kinetic +' is no expression"),
                                 ((self.out, "integral(kinetic, time"), "'integral(kinetic, time' is no expression"),
                                 ((self.out, "kinetic", "--x", "max(time"), "'max(time' is no expression"),
                                 ((self.out, "--out", "curve.pdf"), ".png, .svg or .csv, not .pdf"),
                                 ((self.out, "--units", "m, stone, s"), "'m, stone, s' is no system of units"),
                                 ((self.folder.name,), "there are no results of percuss")):
            done = self.plot(*arguments)
            self.assertEqual(done.returncode, 2)
            self.assertIn(words, done.stderr)

    def test_panels_are_chosen_by_name_column_pattern_and_list(self):
        histories = [self.run_.history]
        energies, kinetic, by_part, two, column = choose_panels(["energies", "kinetic", "kinetic:*", "dt,step", "=contact"], histories)
        self.assertEqual(energies.columns[:2], ["kinetic", "internal"])
        self.assertEqual((kinetic.title, kinetic.columns), ("kinetic", ["kinetic"]))
        self.assertEqual(by_part.columns, ["kinetic:block", "kinetic:plate"])
        self.assertEqual(two.columns[0], "dt")
        self.assertEqual(column.columns, ["contact"])
        self.assertNotIn("erosion", list_panels(histories))
        with self.assertRaisesRegex(BadChoice, "nothing:"):
            choose_panels(["nothing:*"], histories)

    def test_curves_are_filtered_and_cut(self):
        history = self.run_.history
        time, values = make_curve(history, "kinetic", Options(channel_class=1000))
        wanted = percuss.filter_cfc(percuss.resample(history["time"], history["kinetic"])[1], time[1] - time[0], 1000)
        np.testing.assert_array_equal(values, wanted)
        time, _ = make_curve(history, "kinetic", Options(start=1e-5, end=2e-5))
        self.assertTrue(time[0] >= 1e-5 and time[-1] <= 2e-5 and len(time) > 5)
        self.assertEqual(make_curve(history, "dt", Options())[0][0], history["time"][1])

    def test_thinning_keeps_both_ends_and_every_peak(self):
        time = np.arange(100_000.0)
        values = np.zeros(100_000)
        values[[777, 54_321]] = 5, -7
        fewer_times, fewer = thin(time, values)
        self.assertLessEqual(len(fewer), 2010)
        self.assertEqual((fewer.max(), fewer.min()), (5, -7))
        self.assertEqual(fewer_times[int(np.argmin(fewer))], 54_321)
        self.assertEqual((fewer_times[0], fewer_times[-1]), (0, 99_999))

    def test_the_controlling_part_is_that_of_the_element(self):
        parts, names = find_controlling_parts(self.run_, self.run_.history)
        fields = self.run_.fields
        for row in (0, -1):
            element = list(fields.element_ids).index(int(self.run_.history["dt_element"][row]))
            self.assertEqual(parts[row], fields.part[element])
        self.assertEqual(names, ["block", "plate"])


if __name__ == "__main__":
    unittest.main()
