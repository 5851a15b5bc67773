"""Ranges, units and the side of a cut, as scripts/rendering finds them: rendering_test.py SCRIPTS.

Exit code 77 (skipped) if NumPy is not installed.
"""

import sys
import unittest

try:
    import numpy as np
except ImportError as error:
    print(f"skipped: {error}; scripts/install_dependencies --render installs what this test needs")
    sys.exit(77)

sys.path.insert(0, sys.argv.pop())
from rendering.ranges import choose_bar, find_ends  # noqa: E402
from rendering.selection import faces_camera  # noqa: E402
from rendering.units import choose_unit, format_time  # noqa: E402


class Bar(unittest.TestCase):
    def check(self, ends, bar):
        low, high, labels = choose_bar(ends)
        self.assertAlmostEqual(low, bar[0])
        self.assertAlmostEqual(high, bar[1])
        self.assertEqual(labels, bar[2])

    def test_ends_at_round_numbers_just_around_the_data(self):
        self.check((0, 0.031), (0, 0.035, 8))
        self.check((0, 0.03), (0, 0.03, 7))
        self.check((0, 1.02), (0, 1.2, 7))
        self.check((0, 200), (0, 200, 5))
        self.check((7850, 7950), (7850, 7950, 5))

    def test_follows_what_one_element_in_a_thousand_has(self):
        strain = np.zeros(2000)
        strain[:2] = 0.02, 0.03
        self.check(find_ends([np.zeros(2000), strain]), (0, 0.03, 7))

    def test_begins_at_zero_where_that_is_near_and_is_centred_between_signs(self):
        self.check((10, 100), (0, 100, 5))
        self.check((-100, -10), (-100, 0, 5))
        self.check((-60, 100), (-100, 100, 5))
        self.check((-1, 100), (-20, 100, 7))

    def test_of_one_number_and_its_round_off_has_zero_at_the_other_end(self):
        self.check((200, 200 + 1e-10), (0, 200, 5))
        self.check((-3, -3), (-3, 0, 7))

    def test_of_zeros_or_nothing_goes_to_one(self):
        self.check((0, 0), (0, 1, 5))
        self.check(None, (0, 1, 5))

    def test_covers_any_data_with_four_to_seven_steps(self):
        random = np.random.default_rng(1)
        for low, high in np.sort(random.normal(size=(300, 2)) * 10.0 ** random.integers(-30, 30, size=(300, 1))):
            first, last, labels = choose_bar((low, high))
            slack = 1e-8 * (last - first)
            self.assertTrue(first <= low + slack and high - slack <= last, (low, high))
            self.assertTrue(5 <= labels <= 8, (low, high))

    def test_data_are_those_of_all_frames_without_what_is_not_finite(self):
        self.assertEqual(find_ends([np.array([0, np.nan, 2]), np.array([-np.inf, 1, 3])]), (0, 3))
        self.assertIsNone(find_ends([np.array([np.nan])]))
        self.assertIsNone(find_ends([]))


class Units(unittest.TestCase):
    def test_take_a_prefix_that_suits_the_numbers(self):
        self.assertEqual(choose_unit("Pa", 3e8), ("MPa", 1e-6))
        self.assertEqual(choose_unit("N", 2e3), ("kN", 1e-3))
        self.assertEqual(choose_unit("Pa", 0), ("Pa", 1))

    def test_stay_where_they_are_those_of_the_system(self):
        self.assertEqual(choose_unit("GPa", 0.25), ("GPa", 1))
        self.assertEqual(choose_unit("mm/ms", 5000), ("mm/ms", 1))
        self.assertEqual(choose_unit("", 5000), ("", 1))

    def test_of_time_are_shown_where_one_is_named(self):
        self.assertEqual(format_time(0.002, 0.005, "m, kg, s"), "t = 2.00 ms")
        self.assertEqual(format_time(2, 5, "mm, kg, ms"), "t = 2 ms")
        self.assertEqual(format_time(0.05, 1, "inch and pound"), "t = 0.05")
        self.assertEqual(format_time(0.05, 1, ""), "t = 0.05")
        self.assertEqual(format_time(0, 0, "m, kg, s"), "t = 0.00 s")


class Cut(unittest.TestCase):
    def test_takes_away_the_side_of_the_camera(self):
        self.assertTrue(faces_camera(0, (0, 0)))
        self.assertFalse(faces_camera(0, (180, 0)))
        self.assertFalse(faces_camera(1, (-90, 10)))
        self.assertTrue(faces_camera(1, (75, 5)))
        self.assertTrue(faces_camera(2, (30, 20)))
        self.assertFalse(faces_camera(2, (30, -20)))

    def test_takes_away_what_lies_above_where_the_camera_looks_along_it(self):
        self.assertTrue(faces_camera(0, (-90, 10)))
        self.assertTrue(faces_camera(0, (90, 10)))
        self.assertTrue(faces_camera(2, (30, 0)))


if __name__ == "__main__":
    unittest.main()
