#!/usr/bin/env python3
"""Expressions over columns, and the rating of a curve against a test, against closed forms. Needs no run."""

import os
import tempfile
import unittest

from given import require

require("matplotlib", "numpy")

import numpy as np

from percuss import NotResults  # noqa: E402
from percuss.results.expressions import BadExpression, evaluate, is_expression  # noqa: E402
from percuss.results.history import History  # noqa: E402
from percuss.results.rating import find_share_inside, rate_signals  # noqa: E402
from percuss.results.units import Units  # noqa: E402
from percuss.plot.measured import Measured  # noqa: E402
from percuss.plot.series import Options, add_expressions, make_curve  # noqa: E402

ROWS = 2001
TIME = np.linspace(0, 0.02, ROWS)
CRUSH = 0.05 * np.sin(80 * TIME)  # of the node `top`, against a spring of 2e6 N/m
COLUMNS = {"time": TIME, "dt": np.full(ROWS, TIME[1]), "fx:hit": 0.3 * TIME, "fy:hit": 0.4 * TIME, "fz:hit": 1.2 * TIME,
           "wall_force_x": 0 * TIME, "wall_force_y": 0 * TIME, "wall_force_z": 2e6 * CRUSH, "top_x": 0 * TIME, "top_y": 3 + 0 * TIME,
           "top_z": -CRUSH, "base_x": 4 + 0 * TIME, "base_y": 0 * TIME, "base_z": -CRUSH, "mass:a b": 2 + 0 * TIME}
DIMENSIONS = {"time": "time", "wall_force_z": "force", "wall_force_x": "force", "wall_force_y": "force", "mass:a b": "mass"}
DIMENSIONS |= {f"{node}_{axis}": "length" for node in ("top", "base") for axis in "xyz"}


def make_history():
    return History(list(COLUMNS), np.stack(list(COLUMNS.values()), axis=1), Units("mm, t, s"), {name: {"dimension": value} for name, value in DIMENSIONS.items()})


class Expressions(unittest.TestCase):
    def value(self, text):
        return evaluate(make_history(), text)[0]

    def test_have_the_values_of_mechanics(self):
        work = 0.5 * 2e6 * CRUSH**2  # of a spring
        for text, right in (("integral(wall_force_z, -top_z)", work), ("integral(wall_force_z, change(-top_z))", work),
                            ("derivative(top_z)", -4 * np.cos(80 * TIME)), ("resultant('hit')", 1.3 * TIME), ("resultant(hit)", 1.3 * TIME),
                            ("norm(fx:hit, fy:hit)", 0.5 * TIME), ("resultant('wall_force') / 2e6", CRUSH), ("distance('top', 'base')", 5 + 0 * TIME),
                            ("sqrt(fx:hit**2 + fy:hit**2) * 2 - 1", TIME - 1), ("{mass:a b} * 3", 6 + 0 * TIME), ("max(fx:hit)", 0.006 + 0 * TIME),
                            ("max(fx:hit, 0.003)", np.maximum(0.3 * TIME, 0.003)), ("mean(fx:hit)", 0.003 + 0 * TIME), ("first(top_y) + last(fx:hit)", 3.006 + 0 * TIME),
                            ("integral(time)", TIME**2 / 2), ("-abs(-time)", -TIME), ("1e3", 1000 + 0 * TIME), ("exp(log(2)) + sin(0)", 2 + 0 * TIME)):
            np.testing.assert_allclose(self.value(text), right, rtol=1e-5, atol=1e-5 * np.abs(right).max(), err_msg=text)

    def test_a_filter_within_is_that_of_the_standard(self):
        from percuss.results.filters import filter_cfc

        np.testing.assert_allclose(self.value("cfc(wall_force_z, 600)"), filter_cfc(COLUMNS["wall_force_z"], TIME[1], 600), rtol=1e-9, atol=1e-6)

    def test_dimensions_follow(self):
        history = make_history()
        for text, unit in (("integral(wall_force_z, top_z)", "mJ"), ("derivative(top_z)", "mm/s"), ("wall_force_z / {mass:a b}", "mm/s\u00b2"),
                           ("wall_force_z / change(top_z)", "t/s\u00b2"), ("sqrt(top_z * base_z)", "mm"), ("top_z / base_z", ""), ("top_z**3", "mm\u00b3")):
            history.add("it", *evaluate(history, text))
            self.assertEqual(history.unit("it"), unit, text)
        self.assertIsNone(evaluate(history, "fx:hit + 1")[1])  # its dimension is not known

    def test_a_label_may_name_the_unit(self):
        history = make_history()
        self.assertEqual(add_expressions(["pull [g] = wall_force_z / {mass:a b} / 9810", "plain = top_y / 2"], [history], Options()), ["pull", "plain"])
        self.assertEqual((history.unit("pull"), history.unit("plain")), ("g", "mm"))
        np.testing.assert_allclose(history["pull"], 1e6 * CRUSH / 9810)

    def test_no_label_stands_beside_a_number_in_another_unit(self):
        """The motion in SI units, and g of the standard: whatever units the deck has and whatever are shown."""
        speed, pull = 4.0 * np.cos(80 * TIME), 1000 * CRUSH  # m/s; m/s2 of 1e6 N/m and a tonne
        right = {"speed [m/s] = derivative(top_z)": ("m/s", -1e-3 * speed), "pace [km/h] = 2 * derivative(top_z)": ("km/h", -7.2e-3 * speed),
                 "pull [g] = wall_force_z / {mass:a b}": ("g", pull / 9.80665), "own [g] = wall_force_z / {mass:a b} / 9810": ("g", pull / 9.81),
                 "half [kN] = (wall_force_z + 3) / 2": ("kN", (1e3 * CRUSH + 1.5e-3)), "hit [kN] = max(wall_force_z) / 1e3": ("kN", 2e3 * CRUSH.max()),
                 "ratio [%] = 100 * top_y / first(top_y)": ("%", 100.0), "stress [MPa] = wall_force_z / 400": ("MPa", 5e3 * CRUSH)}
        for system in (None, "m, kg, s", "mm, kg, ms", "in, lbf s2/in, s"):
            for word, (unit, values) in right.items():
                history, options = make_history(), Options()
                history = history.in_units(Units(system)) if system else history
                (name,) = add_expressions([word], [history], options)
                self.assertEqual(history.unit(name), unit, word)
                np.testing.assert_allclose(history[name], values + 0 * TIME, rtol=2e-6, atol=2e-6 * np.abs(values).max(), err_msg=f"{word} {system}")
                stays = system and word.startswith("stress")  # its number has a unit that nothing tells
                self.assertEqual(len(options.notes), 1 if stays else 0, options.notes)

    def test_numbers_of_an_expression_are_in_the_units_of_the_deck(self):
        history = make_history().in_units(Units("m, kg, s"))
        add_expressions(["late = top_y + 5", "more = late * 2"], [history], Options())  # 5 mm
        np.testing.assert_allclose(history["late"], 0.008)
        np.testing.assert_allclose(history["more"], 0.016)

    def test_a_label_with_the_wrong_unit_loses_it_and_says_so(self):
        for word, unit in (("pull [g] = wall_force_z / {mass:a b} / 9.81", "mm/s\u00b2"), ("way [N] = top_z", "mm"), ("hit [kN] = wall_force_z / 50", "N")):
            history, options = make_history(), Options()
            (name,) = add_expressions([word], [history], options)
            self.assertEqual(history.unit(name), unit)
            self.assertIn("the label loses its unit", options.notes[0])

    def test_wrong_ones_are_refused_with_the_nearest_name(self):
        for text, words in (("wall_forc_z * 2", "there is no column 'wall_forc_z'; did you mean wall_force_z?"), ("fx:hot + 1", "did you mean fx:hit?"),
                            ("intgral(time)", "did you mean integral?"), ("wall_force_z + top_z", "different dimensions"), ("exp(top_z)", "no dimension"),
                            ("__import__('os').system('true')", "it may have numbers"), ("time.real", "it may have"), ("[time]", "it may have"),
                            ("(lambda: 1)()", "it may have"), ("time if 1 else 2", "it may have"), ("2**time", "a power must be a number"), ("9**9**9", "a power"),
                            ("cfc(time, 61)", "CFC 61"), ("integral()", "integral() takes 1 to 2"), ("time +", "is no expression"), ("(" * 300 + "1" + ")" * 300, ""),
                            ("1+" * 900 + "1", "nested too deep"), ("x" * 3000, "too long"), ("resultant('top_q')", "no three columns"), ("'a'", "it may have"), ("", "is no")):
            with self.assertRaises(BadExpression) as caught:
                self.value(text)
            self.assertIn(words, str(caught.exception))
            self.assertLess(len(str(caught.exception)), 1000)

    def test_are_told_from_columns_and_patterns(self):
        names = list(COLUMNS)
        for text, truth in (("time", False), ("fx:hit", False), ("f?:hit", False), ("kinetic,internal", False), ("time*2", True), ("abs(time)", True), ("energies", False)):
            self.assertEqual(is_expression(text, names), truth, text)

    def test_become_columns_filtered_before_and_after(self):
        noise = COLUMNS["wall_force_z"] + 1e4 * np.sin(2 * np.pi * 3e4 * TIME)
        history = History([*COLUMNS, "raw"], np.stack([*COLUMNS.values(), noise], axis=1), Units("mm, t, s"))
        words = add_expressions(["crush = raw * 1", "time"], [history], Options(channel_class=600))
        self.assertEqual(words, ["crush", "time"])
        self.assertLess(np.abs(history["crush"] - COLUMNS["wall_force_z"])[50:-50].max(), 200)
        add_expressions(["late = raw * 1"], [history], Options())
        x, late = make_curve(history, "late", Options(class_after=600, x="top_z"))
        self.assertLess(np.abs(late - COLUMNS["wall_force_z"])[50:-50].max(), 200)
        np.testing.assert_allclose(x, COLUMNS["top_z"], atol=1e-9)


class Rating(unittest.TestCase):
    """ISO/TS 18571: of curves for which each part has a closed form."""

    def setUp(self):
        self.t = np.linspace(0, 1, 1001)
        self.y = np.exp(-(((self.t - 0.5) / 0.08) ** 2))

    def test_of_the_same_curve_is_one(self):
        self.assertEqual(set(rate_signals(self.y, self.y, 1e-3).values()), {1.0})

    def test_a_shift_costs_phase_alone_besides_the_corridor(self):
        found = rate_signals(self.y, np.interp(self.t - 0.05, self.t, self.y), 1e-3)
        self.assertAlmostEqual(found["phase"], 1 - 0.05 / 0.2, delta=1e-3)
        self.assertGreater(min(found["magnitude"], found["slope"]), 0.999)

    def test_a_factor_costs_slope_by_its_share(self):
        found = rate_signals(self.y, 1.2 * self.y, 1e-3)
        self.assertAlmostEqual(found["slope"], 1 - 0.2 / 2, places=6)
        self.assertEqual(found["phase"], 1)
        self.assertGreaterEqual(found["magnitude"], 1 - 0.2 / 0.5)

    def test_an_offset_has_the_score_of_its_place_in_the_corridor(self):
        found = rate_signals(np.sin(20 * self.t) / np.sin(20 * self.t).max(), np.sin(20 * self.t) / np.sin(20 * self.t).max() + 0.2, 1e-3)
        size = np.abs(np.sin(20 * self.t) / np.sin(20 * self.t).max()).max()
        self.assertAlmostEqual(found["corridor"], ((0.5 * size - 0.2) / (0.45 * size)) ** 2, places=6)
        total = 0.4 * found["corridor"] + 0.2 * (found["phase"] + found["magnitude"] + found["slope"])
        self.assertAlmostEqual(found["rating"], total, places=12)

    def test_a_share_of_a_corridor(self):
        self.assertEqual(find_share_inside(np.zeros(4), np.ones(4), np.array([-1, 0, 0.5, 2])), 0.5)


class Tests(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = os.path.join(folder.name, "test.csv")

    def read(self, text):
        with open(self.path, "w", encoding="utf-8") as file:
            file.write(text)
        return Measured(self.path)

    def test_columns_by_place_or_by_name(self):
        self.assertEqual(self.read("0,1\n1,2\n").y.tolist(), [1, 2])
        found = self.read("# a test\nlow; high; x; y\n-1; 1; 0; 0.5\n-2;2;1;0.25\n")
        self.assertEqual((found.x.tolist(), found.y.tolist(), found.low.tolist(), found.high.tolist()), ([0, 1], [0.5, 0.25], [-1, -2], [1, 2]))

    def test_wrong_files_are_refused_with_the_line(self):
        for text, words in (("", "two rows"), ("0,1\n", "two rows"), ("0,1\n1,2\nx,y\n", "test.csv:3: this is no row of numbers"), ("0,1\n1\n", "test.csv:2"),
                            ("0,nan\n1,2\n", "test.csv:1"), ("0\n1\n", "two columns"), ("0,1,2\n1,2,3\n", "two columns")):
            with self.assertRaises(NotResults) as caught:
                self.read(text)
            self.assertIn(words, str(caught.exception))


if __name__ == "__main__":
    unittest.main()
