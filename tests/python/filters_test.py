"""Filters of SAE J211 and resampling: filters_test.py ROOT PERCUSS. Exit code 77 (skipped) without NumPy."""

import math
import unittest

from given import require

require("numpy")

import numpy as np

from percuss.results.filters import CLASSES, filter_cfc, find_coefficients, find_cutoff, resample  # noqa: E402


def standard_loss(frequency, channel_class):
    """Decibels that the standard's filter takes away: Butterworth's two poles at 2.0775 times the class, applied twice."""
    return -10 * math.log10((1 + (frequency / (2.0775 * channel_class)) ** 4) ** 2)


def measure_loss(frequency, channel_class, interval):
    """The same of filter_cfc, by the amplitude of a long sine in its middle."""
    time = np.arange(0, 60 / frequency, interval)
    filtered = filter_cfc(np.sin(2 * np.pi * frequency * time), interval, channel_class)
    middle = (time > 20 / frequency) & (time < 40 / frequency)
    waves = np.column_stack([np.sin(2 * np.pi * frequency * time), np.cos(2 * np.pi * frequency * time)])[middle]
    sine, cosine = np.linalg.lstsq(waves, filtered[middle], rcond=None)[0]
    return 20 * math.log10(math.hypot(sine, cosine)), math.degrees(math.atan2(cosine, sine))


class Cfc(unittest.TestCase):
    def test_has_the_frequency_response_of_the_standard(self):
        for channel_class in CLASSES:
            interval = 1 / (200 * find_cutoff(channel_class))  # where the bilinear transform bends frequencies by less than 0.1 dB
            for share in (0.05, 0.2, 0.5, 1, 1.5, 2, 3, 4):
                frequency = share * find_cutoff(channel_class)
                loss, phase = measure_loss(frequency, channel_class, interval)
                self.assertAlmostEqual(loss, standard_loss(frequency, channel_class), delta=0.1, msg=(channel_class, share))
                self.assertAlmostEqual(phase, 0, delta=0.01, msg="no phase is shifted")

    def test_stays_in_the_corridor_of_the_standard(self):
        for channel_class in CLASSES:
            interval = 1 / (20 * find_cutoff(channel_class))
            for frequency, low, high in ((0.1 * channel_class, -0.5, 0.5), (channel_class, -1, 0.5),
                                         (channel_class / 0.6, -4, 0.5), (2 / 0.6 * channel_class, -40, -9)):
                loss, _ = measure_loss(frequency, channel_class, interval)
                self.assertTrue(low <= loss <= high, (channel_class, frequency, loss))

    def test_takes_three_decibels_away_at_its_cutoff(self):
        self.assertAlmostEqual(standard_loss(find_cutoff(180), 180), -3.01, delta=0.01)
        self.assertEqual([round(find_cutoff(c)) for c in CLASSES], [100, 300, 1000, 1667])

    def test_has_the_coefficients_of_the_standard(self):
        # CFC 600 at 10 kHz: wd = 2 pi 600 2.0775 = 7832.0, wa = tan(wd T / 2) = 0.412757.
        wa = math.tan(2 * math.pi * 600 * 2.0775 * 1e-4 / 2)
        (a0, a1, a2), (b1, b2) = find_coefficients(600, 1e-4)
        below = 1 + math.sqrt(2) * wa + wa**2
        self.assertAlmostEqual(a0, wa**2 / below)
        self.assertEqual((a1, a2), (2 * a0, a0))
        self.assertAlmostEqual(b1, -2 * (wa**2 - 1) / below)
        self.assertAlmostEqual(b2, (-1 + math.sqrt(2) * wa - wa**2) / below)
        self.assertAlmostEqual(a0 + a1 + a2 + b1 + b2, 1, msg="a constant passes")

    def test_leaves_constants_and_ramps_as_they_are(self):
        time = np.arange(4000) * 1e-5
        # The recursion amplifies round-off by 1 / wa^2, here 65 000.
        np.testing.assert_allclose(filter_cfc(np.full(4000, 7.0), 1e-5, 60), 7, rtol=1e-10)
        np.testing.assert_allclose(filter_cfc(3 - 200 * time, 1e-5, 600), 3 - 200 * time, atol=1e-6)

    def test_answers_an_impulse_evenly_to_both_sides_and_keeps_its_area(self):
        impulse = np.zeros(20001)
        impulse[10000] = 5
        answer = filter_cfc(impulse, 1e-5, 180)
        np.testing.assert_allclose(answer, answer[::-1], atol=1e-14)
        self.assertAlmostEqual(answer.sum(), 5, places=10)
        self.assertEqual(int(np.argmax(answer)), 10000)

    def test_is_the_recursion_of_the_standard(self):
        random = np.random.default_rng(2)
        signal = np.concatenate([np.zeros(3000), random.normal(size=200), np.zeros(3000)])
        (a0, a1, a2), (b1, b2) = find_coefficients(1000, 1e-5)

        def run(x):
            y = np.zeros_like(x)
            for t in range(2, len(x)):
                y[t] = a0 * x[t] + a1 * x[t - 1] + a2 * x[t - 2] + b1 * y[t - 1] + b2 * y[t - 2]
            return y

        np.testing.assert_allclose(filter_cfc(signal, 1e-5, 1000), run(run(signal)[::-1])[::-1], atol=1e-13)

    def test_takes_columns_and_short_signals(self):
        two = filter_cfc(np.array([[1.0, 2.0]] * 50), 1e-5, 60)
        np.testing.assert_allclose(two, [[1, 2]] * 50, rtol=1e-10)
        for count in (0, 1, 2, 3):
            self.assertEqual(len(filter_cfc(np.ones(count), 1e-5, 60)), count)

    def test_refuses_what_it_cannot_do(self):
        with self.assertRaisesRegex(ValueError, "no class CFC 500"):
            filter_cfc([1, 2, 3], 1e-5, 500)
        with self.assertRaisesRegex(ValueError, "too far apart for CFC 1000"):
            filter_cfc([1, 2, 3], 1e-3, 1000)


class Resample(unittest.TestCase):
    def test_meets_both_ends_in_equal_steps(self):
        times = np.array([0, 1.0, 1.5, 4])
        equal, values = resample(times, 3 * times - 1)
        np.testing.assert_allclose(np.diff(equal), 4 / 3)
        np.testing.assert_allclose(values, 3 * equal - 1)
        self.assertEqual((equal[0], equal[-1]), (0, 4))

    def test_takes_a_step_that_is_given(self):
        times = np.linspace(1, 2, 11)
        equal, values = resample(times, np.column_stack([times, -times]), 0.25)
        np.testing.assert_allclose(equal, [1, 1.25, 1.5, 1.75, 2])
        np.testing.assert_allclose(values, np.column_stack([equal, -equal]))
        equal, _ = resample(times, times, 0.3)
        np.testing.assert_allclose(equal, [1, 1.3, 1.6, 1.9])

    def test_refuses_times_that_do_not_rise(self):
        with self.assertRaisesRegex(ValueError, "must rise"):
            resample([0, 1, 1], [0, 0, 0])


if __name__ == "__main__":
    unittest.main()
