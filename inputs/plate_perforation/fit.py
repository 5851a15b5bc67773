#!/usr/bin/env python3
"""Fits the curve of Lambert and Jonas, v_residual = a (v^p - v_limit^p)^(1/p), to the table of a sweep: fit.py SWEEP.CSV M_PROJECTILE M_PLUG

a = M / (M + m) is that of Recht and Ipson: the plug leaves with the projectile. v_limit and p are fitted. Writes fit.png beside the table.
"""

import csv
import os
import sys

import matplotlib
import numpy as np
from scipy.optimize import least_squares

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402


def read_table(path):
    """Velocities before and after, of the completed designs."""
    with open(path, encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    inputs = "initial.0.velocity.2"
    (output,) = [name for name in rows[0] if name.startswith("v_residual")]
    done = [row for row in rows if row["state"] == "completed"]
    return np.array([[float(row[inputs]), float(row[output])] for row in done]).T


def find_residual(v, a, limit, p):
    """Zero where the plate holds."""
    ratio = np.minimum(limit / v, 1.0)
    return a * v * (1.0 - ratio**p) ** (1.0 / p)


def fit(v, residual, a):
    through = residual > 0
    start = [0.5 * (v[~through].max() + v[through].min()) if (~through).any() else 0.9 * v.min(), 2.0]
    found = least_squares(lambda x: find_residual(v[through], a, *x) - residual[through], start, bounds=([1e-9, 1.0], [v[through].min(), 10.0]))
    return found.x


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    mass, plug = float(sys.argv[2]), float(sys.argv[3])
    a = mass / (mass + plug)
    v, residual = read_table(sys.argv[1])
    limit, p = fit(v, residual, a)
    print(f"a = {a:.3f}, limit velocity {limit:.1f} m/s, p = {p:.2f}")
    line = np.linspace(min(v.min(), 0.9 * limit), v.max(), 400)
    plt.figure(figsize=(6.4, 4))
    plt.plot(line, find_residual(line, a, limit, p), label=f"fit: limit {limit:.0f} m/s, a = {a:.3f}, p = {p:.2f}")
    plt.plot(line, find_residual(line, a, limit, 2.0), "--", label="Recht and Ipson: p = 2")
    plt.plot(v, np.maximum(residual, 0.0), "o", label="runs")
    plt.xlabel("velocity before the plate [m/s]")
    plt.ylabel("residual velocity [m/s]")
    plt.legend()
    plt.grid(alpha=0.3)
    plt.savefig(os.path.join(os.path.dirname(os.path.abspath(sys.argv[1])), "fit.png"), dpi=120, bbox_inches="tight")


if __name__ == "__main__":
    main()
