#!/usr/bin/env python3
"""Fits yield stress and hardening modulus of deck.yaml to the curve of test.csv: calibrate.py [FOLDER OF THE RUNS].

Needs SciPy, the Python package percuss (or PYTHONPATH=python), and percuss built or in PATH.
Runs that are in the folder already are not run again."""

import os
import sys

import numpy as np
from scipy.optimize import least_squares

from percuss.sweep import Study, make_designs

HERE = os.path.dirname(os.path.realpath(__file__))
KEYS = ("materials.steel.yield_stress", "materials.steel.hardening_modulus")
START, LOW, HIGH = (200e6, 400e6), (100e6, 50e6), (800e6, 5e9)
PLASTIC = 2e-4  # m: below it the force is elastic and tells nothing about the hardening


def main():
    test = np.loadtxt(os.path.join(HERE, "test.csv"), delimiter=",", skiprows=2)
    test = test[test[:, 0] >= PLASTIC]
    study = Study(os.path.join(HERE, "deck.yaml"), sys.argv[1] if len(sys.argv) > 1 else "calibration")

    def find_errors(shares):
        """Difference of the forces over the largest one, at the displacements of the test. shares: of START."""
        values = [float(f"{share * start:.6g}") for share, start in zip(shares, START)]
        (result,) = study.run(make_designs({key: [value] for key, value in zip(KEYS, values)}))
        if result.state != "completed":
            sys.exit(f"calibrate: {result.design} is {result.state}: {result.error}")
        history = result.run.history
        displacement = history["grip_x"] - history["grip_x"][0]
        middle = 0.5 * (displacement[1:] + displacement[:-1])  # forces are means between rows
        return (np.interp(test[:, 0], middle, history["fx:grip"][1:]) - test[:, 1]) / test[:, 1].max()

    found = least_squares(find_errors, np.ones(2), bounds=(np.divide(LOW, START), np.divide(HIGH, START)), diff_step=0.02, xtol=1e-4, ftol=1e-5)
    for key, share, start in zip(KEYS, found.x, START):
        print(f"{key}={share * start:.4g}")
    print(f"error of the force, root mean square: {100 * np.sqrt(np.mean(found.fun**2)):.2g} % after {found.nfev} iterations")


if __name__ == "__main__":
    main()
