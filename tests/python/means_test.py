"""Forces of history.csv as means between rows do not alias: means_test.py ROOT PERCUSS. Exit code 77 (skipped) without NumPy.

One element swings on its foot: a sine of one known frequency. Rows further apart than half its period cannot show it. Values at
the rows would show a slow wave of the full amplitude that is not there; means over the time between rows show it weakened by
sin(pi f T) / (pi f T), the response of a mean over T.
"""

import math
import os
import subprocess
import tempfile
import unittest

from given import PERCUSS, require

require("numpy")

import numpy as np

import percuss  # noqa: E402

STEP = 4e-5
DECK = """\
units: m, kg, s
time: {end: 0.2, max_step: 4.0e-5}
parts: {rod: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, material: spring}}
materials: {spring: {model: elastic, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0}}
elements: {bulk_viscosity: {linear: 0, quadratic: 0}}
initial: [{nodes: rod/x_max, velocity: [1.0e-4, 0, 0]}]
conditions:
  - {nodes: rod/x_min, fixed: [x]}
  - {nodes: rod, fixed: [y, z]}
output: {history: {every: 0, forces: [{name: foot, support: rod/x_min}]}}
"""
# Half of the mass, 500 kg, on a spring of E A / L = 1e9 N/m.
OMEGA = math.sqrt(1e9 / 500)
FREQUENCY = OMEGA / (2 * math.pi)  # 225 Hz: a period is 111 steps
AMPLITUDE = 500 * 1e-4 * OMEGA     # momentum times omega [N]


def fit_amplitude(times, values, frequency):
    """Of the sine of this frequency that fits best; a row may be any time apart from the next."""
    phase = 2 * np.pi * frequency * times
    waves = np.column_stack([np.sin(phase), np.cos(phase), np.ones(len(times))])
    sine, cosine, _ = np.linalg.lstsq(waves, values, rcond=None)[0]
    return math.hypot(sine, cosine)


def list_intervals(times):
    """Between the velocities of rows: they begin at time 0, and are half a step earlier than the time from then on."""
    return np.diff(np.concatenate([[times[0] + STEP / 2], times[1:]]))


class Means(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = folder.name
        with open(os.path.join(cls.folder, "deck.yaml"), "w", encoding="utf-8") as file:
            file.write(DECK)
        cls.time, cls.force = cls.run_scene("every")

    @classmethod
    def run_scene(cls, name, *options):
        out = os.path.join(cls.folder, name)
        subprocess.run([PERCUSS, "run", os.path.join(cls.folder, "deck.yaml"), "--out", out, "--quiet", "--force", *options], check=True,
                       timeout=120, env=dict(os.environ, OMP_NUM_THREADS="1", OMP_PROC_BIND="false"))
        history = percuss.read(out).history
        return np.array(history["time"]), np.array(history["fx:foot"])

    def run_rows(self, steps):
        return self.run_scene(f"rows{steps}", "--set", f"output.history.every={steps * STEP!r}")

    def test_the_scene_is_a_sine_of_the_known_frequency(self):
        self.assertAlmostEqual(fit_amplitude(self.time[1:] - STEP / 2, self.force[1:], FREQUENCY) / AMPLITUDE, 1, delta=0.01)

    def test_a_row_is_the_mean_of_the_steps_since_the_one_before(self):
        times, means = self.run_rows(122)
        impulse = np.concatenate([[0], np.cumsum(self.force[1:] * list_intervals(self.time))])
        exact = np.diff(np.interp(times, self.time, impulse)) / list_intervals(times)
        np.testing.assert_allclose(means[1:], exact, atol=1e-9 * AMPLITUDE)

    def test_a_spectrum_of_rows_shows_what_a_mean_lets_through_and_no_slow_wave(self):
        # 28: a quarter of the period. 122 and 300: 1.1 and 2.7 periods, so that the sine is above half the frequency of rows.
        for steps, is_seen in ((28, True), (122, False), (300, False)):
            times, means = self.run_rows(steps)
            length = np.diff(times).mean()
            passes = abs(math.sin(math.pi * FREQUENCY * length) / (math.pi * FREQUENCY * length))
            middles = (times[1:] + times[:-1]) / 2
            found = fit_amplitude(middles, means[1:], FREQUENCY) / AMPLITUDE
            self.assertAlmostEqual(found, passes, delta=0.025, msg=steps)  # few rows: the fit is that good
            self.assertEqual(passes > 0.5, is_seen)
            # At these times the values of single steps have the full amplitude: this is what would alias.
            values = np.interp(times[1:], self.time[1:] - STEP / 2, self.force[1:])
            self.assertGreater(fit_amplitude(times[1:], values, FREQUENCY) / AMPLITUDE, 0.95)
            if not is_seen:
                self.assertLess(np.abs(means[1:]).max() / AMPLITUDE, 0.15)
                self.assertGreater(np.abs(values).max() / AMPLITUDE, 0.9)


if __name__ == "__main__":
    unittest.main()
