"""A small run of percuss for the tests beside this file: a block falls on a plate of shells and a rigid wall lies below."""

import os
import subprocess

DECK = """\
# A block falls on a plate.
title: A block falls on a plate & <wall>
units: {units}
time: {{end: 2.0e-4}}
parts:
  block: {{box: {{size: [0.02, 0.02, 0.02], cells: [2, 2, 2]}}, at: [0, 0, 0.0012], material: steel}}
  plate: {{shell_plate: {{size: [0.06, 0.06], cells: [4, 4]}}, at: [-0.02, -0.02, 0], thickness: 0.002, material: steel}}
materials:
  steel: {{model: j2_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: 400e6, hardening_modulus: 1e9}}
initial: [{{part: block, velocity: [0, 0, -50]}}]
conditions: [{{nodes: plate/x_min, fixed: [x, y, z]}}]
contact: {{surfaces: all, friction: 0.1}}
walls: [{{point: [0, 0, -0.002], normal: z}}]
output:
  fields: {{every: 2.0e-5, write: [velocity, von_mises, equivalent_plastic_strain]}}
  history: {{every: 1.0e-6, parts: all}}
  checkpoint: {{every: 1.0e-4}}
"""


def run(percuss, folder, *options, units="m, kg, s", name="out"):
    """Runs the deck in a folder; the folder of its results."""
    deck = os.path.join(folder, "deck.yaml")
    with open(deck, "w", encoding="utf-8") as file:
        file.write(DECK.format(units=units))
    out = os.path.join(folder, name)
    done = subprocess.run([percuss, "run", deck, "--out", out, "--quiet", *options], capture_output=True, text=True, timeout=120,
                          env=dict(os.environ, OMP_NUM_THREADS="1", OMP_PROC_BIND="false"))
    if done.returncode != 0:
        raise RuntimeError(f"exit code {done.returncode}: {done.stderr}")
    return out
