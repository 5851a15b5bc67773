"""Laws of users: a VUMAT, a VUHARD and a law in C++, against built-in laws and closed forms."""
import subprocess

import numpy as np

from bench import case
from runs import ROOT
from cases.rubber import find_force, pull

EXAMPLES = ROOT / "inputs" / "user_law"


def compile_fortran(bench, name):
    """A shared library of a subroutine for Abaqus, as docs/user_laws.md says."""
    library = bench.file(f"{name}.so")
    subprocess.run(["gfortran", "-O2", "-shared", "-fPIC", "-I", str(EXAMPLES), "-o", str(library),
                    str(EXAMPLES / f"{name}.f")], check=True)
    return library


TWIST = """
title: A bar of rubber is thrown, bends and twists
units: m, kg, s
time: {end: 0.01, max_step: 2e-5}
parts: {bar: {box: {size: [0.04, 0.04, 0.2], cells: [3, 3, 12]}, integration: full, material: m}}
materials: {m: {density: 1100, $law}}
conditions: [{nodes: bar/z_min, fixed: [x, y, z]}]
initial: [{part: bar, velocity: [0, 8, 0], angular_velocity: [0, 0, 150], center: [0.02, 0.02, 0]}]
output: {history: {every: 0, nodes: [{name: tip, near: [0.04, 0.04, 0.2]}]}}
"""

BAR = """
title: A copper bar strikes a wall
units: m, kg, s
time: {end: 6e-5, max_step: 1.5e-8}
parts: {bar: {cylinder: {radius: 0.0032, length: 0.0324, cells: [8, 32]}, material: m}}
materials: {m: {density: 8960, youngs_modulus: 124e9, poissons_ratio: 0.34, $law}}
walls: [{normal: z}]
initial: [{part: bar, velocity: [0, 0, -190]}]
output: {history: {every: 1e-6, nodes: [{name: foot, near: [0.0032, 0, 0]}, {name: end, near: [0, 0, 0.0324]}], elements: [{name: e, near: [0, 0, 0]}]}}
"""

SOFT = """
title: A cube whose stiffness falls with the strain
units: m, kg, s
time: {end: 2e-3, max_step: 2e-6}
parts: {cube: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, material: m}}
materials: {m: {model: user, density: 1000, vumat: $library, constants: [2e9, 0.25], state_variables: 2, delete_variable: 1, field_variables: 1, field_constants: [0.2, 0.15]}}
elements: {bulk_viscosity: {linear: 0, quadratic: 0}}
conditions: [{nodes: cube, fixed: [y, z]}, {nodes: cube/x_min, fixed: x}, {nodes: cube/x_max, velocity: {x: 100}}]
output: {history: {every: 0, elements: [{name: e, id: 1}]}}
"""


@case("user_laws", "plastic", "Laws of users: VUMAT, VUHARD, VUSDFLD and C++")
def user_laws(bench):
    """The examples of inputs/user_law are compiled and run. The VUMAT of neo-Hookean rubber is compared with the built-in law, in a
    clamped bar of fully integrated elements that bends and twists far, after 10 ms: 0.2 %. The VUHARD of Johnson and Cook is compared with the built-in law in a Taylor bar of
    copper: 0.02 %. A VUSDFLD beside a VUMAT takes stiffness away, M (1 - e / 0.2) by the logarithmic strain e, and deletes at 0.15: M (e - e^2 / 0.4) within 0.1 %, the strain within 1 %.
    Gent's rubber in C++ is compared with its energy (Gent 1996), as the built-in rubbers are: 0.1 %."""
    library = compile_fortran(bench, "neo_hookean")
    user = bench.run(TWIST, law=f"model: user, vumat: {library}, constants: [3e6, 0.45], state_variables: 1",
                     libraries=[library])
    own = bench.run(TWIST, law="model: neo_hookean, youngs_modulus: 3e6, poissons_ratio: 0.45")
    for axis in "xyz":
        bench.near(f"VUMAT: place of the tip, {axis}", user.history.last(f"tip_{axis}"),
                   own.history.last(f"tip_{axis}"), relative=2e-3, unit="m")
    bench.near("VUMAT: internal energy", user.history.last("internal"), own.history.last("internal"),
               relative=2e-3, unit="J")
    library = compile_fortran(bench, "johnson_cook")
    user = bench.run(BAR, law=f"model: user_hardening, vuhard: {library}, constants: [90e6, 292e6, 0.31, 0.025, 1.09, "
                              "1356, 293, 1], start_temperature: 293, specific_heat: 383", libraries=[library])
    own = bench.run(BAR,
                    law="model: johnson_cook, a: 90e6, b: 292e6, n: 0.31, c: 0.025, m: 1.09, melt_temperature: 1356, "
                        "start_temperature: 293, room_temperature: 293, reference_rate: 1, specific_heat: 383")
    for name, column in (("radius of the foot", "foot_x"), ("length", "end_z"), ("strain in the foot", "e_eps"),
                         ("temperature in the foot", "e_temperature")):
        bench.near(f"VUHARD: {name}", user.history.last(column), own.history.last(column), relative=2e-4)
    bench.table(["", "run time of the user's law [s]", "of the built-in law [s]"],
                [["Taylor bar", f"{user.cpu:.1f}", f"{own.cpu:.1f}"]])
    library = compile_fortran(bench, "softening")
    h = bench.run(SOFT, library=library, libraries=[library]).history
    strain, modulus = np.log(1 + 100 * h["time"]), 2e9 * (1 - 0.25) / ((1 + 0.25) * (1 - 0.5))
    last = int(np.max(np.flatnonzero(h["e_stress_xx"])))
    bench.near("VUSDFLD: stress before the deletion", float(h["e_stress_xx"][last]),
               modulus * (strain[last] - strain[last]**2 / 0.4), relative=1e-3, unit="Pa")
    bench.near("VUSDFLD: strain of the deletion", float(strain[last]), 0.15, relative=1e-2)
    library = bench.file("gent.so")
    subprocess.run([str(bench.options.percuss), "build-law", str(EXAMPLES / "gent.hpp"), "--out", str(library)],
                   check=True, capture_output=True)
    law = f"model: library, law: {library}, constants: {{shear_modulus: 0.4, limit: 40, bulk_modulus: 100}}"

    def gent(b):
        return -0.4 * 40 / 2 * np.log(1 - (np.sum(b**2) - 3) / 40)

    for mode, stretch in (("tension", 5.0), ("two directions", 3.0), ("pure shear", 4.0)):
        bench.near(f"C++, Gent: {mode} to {stretch:g}", pull(bench, law, stretch, mode, libraries=[library]),
                   find_force(gent, stretch, mode), relative=1e-3, unit="MPa")
