"""Laws of users (model: user), compiled from Fortran and C: user_law_test.py ROOT PERCUSS [MPIEXEC ...].

Exit code 77 (skipped) without a compiler of either language or without NumPy.
"""

import math
import os
import subprocess
import unittest

from law_runs import EXAMPLE, PERCUSS, UNIAXIAL, LawTest, need, np, write_cube

need("gfortran", "cc")

E, NU, DENSITY = 3e6, 0.45, 1100.0
MU, LAMBDA = E / (2 * (1 + NU)), E * NU / ((1 + NU) * (1 - 2 * NU))
USER = f"model: user, density: {DENSITY}, vumat: law.so, constants: [{E}, {NU}], state_variables: 1"
OURS = f"model: neo_hookean, density: {DENSITY}, youngs_modulus: {E}, poissons_ratio: {NU}"

# A law in C; BODY is what it does for each of the n points.
C_LAW = """
#include <math.h>
void vumat_(const int* points, const int* ndir, const int* nshr, const int* states, const int* fields, const int* count,
            const int* anneal, const double* step_time, const double* total_time, const double* dt, const char* name,
            const double* places, const double* length, const double* props, const double* density, const double* strain,
            const double* spin, const double* t0, const double* u0, const double* f0, const double* q0, const double* stress,
            const double* state, const double* e0, const double* d0, const double* t1, const double* u1, const double* f1,
            const double* q1, double* out, double* next, double* e1, double* d1) {
  const int n = *points;
  for (int i = 0; i < n; ++i) {
    const double trace = strain[i] + strain[n + i] + strain[2 * n + i];
    for (int k = 0; k < 6; ++k)
      out[k * n + i] = stress[k * n + i] + (k < 3 ? props[0] * trace : 0) + 2 * props[1] * strain[k * n + i];
    BODY
  }
}
"""

# J2 plasticity with linear hardening, and the rate of Cowper and Symonds where it is positive, by a radial return. Constants:
# Lame's, yield stress, slope, rate, exponent; the state is the equivalent plastic strain.
PLASTIC = """
    const double mean = (out[i] + out[n + i] + out[2 * n + i]) / 3, mu = props[1];
    double square = 0;
    for (int k = 0; k < 6; ++k) {
      const double s = out[k * n + i] - (k < 3 ? mean : 0);
      square += (k < 3 ? 1 : 2) * s * s;
    }
    const double trial = sqrt(1.5 * square), p = state[i];
    if (trial > props[2] + props[3] * p) {
      double low = 0, high = trial / (3 * mu);
      for (int round = 0; round < 60; ++round) {
        const double dp = 0.5 * (low + high), rate = props[4] > 0 ? pow(dp / *dt / props[4], 1 / props[5]) : 0;
        if (trial - 3 * mu * dp > (props[2] + props[3] * (p + dp)) * (1 + rate)) low = dp; else high = dp;
      }
      next[i] = p + low;
      for (int k = 0; k < 6; ++k) {
        const double m = k < 3 ? mean : 0;
        out[k * n + i] = m + (1 - 3 * mu * low / trial) * (out[k * n + i] - m);
      }
    }
"""
STEEL_MU, STEEL_LAMBDA = 200e9 / 2.6, 200e9 * 0.3 / (1.3 * 0.4)
STEEL = "density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: 3e8, hardening_modulus: 1e9"


def name_metals(rate, exponent):
    """A metal as user code, and as our own law."""
    ours = f"model: combined_hardening, kinematic_share: 0, {STEEL}" + (f", cowper_symonds_rate: {rate}, cowper_symonds_exponent: {exponent}" if rate else "")
    return (f"model: user, density: 7850, vumat: law.so, constants: [{STEEL_LAMBDA}, {STEEL_MU}, 3e8, 1e9, {rate}, {exponent}], state_variables: 1", ours)


class UserLaws(LawTest):
    def compile_fortran(self, name="neo_hookean.f"):
        self.compile_file(os.path.join(EXAMPLE, name), "-O2", "-I", EXAMPLE, compiler="gfortran")

    def compile_c(self, body, text=C_LAW):
        self.compile_text(text.replace("BODY", body))

    def test_rubber_in_fortran_has_its_closed_form(self):
        self.compile_fortran()
        rows, _ = self.run_deck(write_cube(USER, 2e-3, UNIAXIAL))
        stretch = 1 + 100 * rows["time"]
        for name, exact in (("all_stress_xx", (MU * (stretch**2 - 1) + LAMBDA * np.log(stretch)) / stretch),
                            ("all_stress_yy", LAMBDA * np.log(stretch) / stretch)):
            self.assertGreater(np.max(exact), 0.3e6)
            np.testing.assert_allclose(rows[name], exact, rtol=0, atol=2e-3 * np.max(exact))

    def test_shear_and_turn_are_those_of_our_own_law(self):
        self.compile_fortran()
        motion = ["{nodes: cube/z_min, fixed: [x, y, z]}", "{nodes: cube/z_max, velocity: {x: 20, z: 5, y: 0}}"]
        same = ("--set", "time.max_step=1e-4")
        user, book = self.run_deck(write_cube(USER, 2e-2, motion), *same, out="user")
        ours, _ = self.run_deck(write_cube(OURS, 2e-2, motion), *same, out="ours")
        largest = np.max(np.abs(ours["all_stress_zx"]))
        self.assertGreater(largest, 1e5)
        for name in ("all_stress_xx", "all_stress_zz", "all_stress_zx"):
            np.testing.assert_allclose(user[name], ours[name], rtol=0, atol=1e-9 * largest, err_msg=name)
        self.assertLess(abs(book["energy"]["error"]), 1e-3)

    def test_metals_flow_as_our_own_laws_do(self):
        # A shear of 1 with a stretch, in which the frame turns by half a right angle.
        self.compile_c(PLASTIC)
        motion = ["{nodes: cube/z_min, fixed: [x, y, z]}", "{nodes: cube/z_max, velocity: {x: 500, z: 100, y: 0}}"]
        for rate, exponent in ((0, 1), (6500.0, 4.0)):
            user, ours = (self.run_deck(write_cube(law, 2e-3, motion), "--set", "time.max_step=1e-5", out=f"out_{i}")[0] for i, law in enumerate(name_metals(rate, exponent)))
            for name in ("all_stress_xx", "all_stress_zz", "all_stress_zx", "all_von_mises"):
                np.testing.assert_allclose(user[name], ours[name], rtol=0, atol=1e-6 * np.max(ours["all_von_mises"]), err_msg=name)
            np.testing.assert_allclose(user["all_state_1"], ours["all_eps"], rtol=0, atol=1e-6)

    def test_stored_hourglass_forces_relax_where_the_code_flows(self):
        # A block that is upset by a third on a rough floor: without relaxation it stores ten times as much in hourglass modes.
        self.compile_c(PLASTIC)
        more = "initial: [{nodes: cube, velocity: [0, 0, -250]}]\n"
        user, ours = (self.run_deck(write_cube(law, 2.5e-3, ["{nodes: cube/z_min, fixed: [x, y, z]}"], cells=4, more=more), out=f"out_{i}")[0] for i, law in enumerate(name_metals(0, 1)))
        self.assertGreater(np.max(ours["all_eps"]), 0.1)
        np.testing.assert_allclose(user["all_state_1"][-1], ours["all_eps"][-1], rtol=0.02)
        self.assertLess(user["hourglass"][-1], 2 * ours["hourglass"][-1])
        for name in ("internal", "kinetic"):
            np.testing.assert_allclose(np.interp(ours["time"], user["time"], user[name]), ours[name], rtol=0, atol=0.02 * np.max(ours[name]), err_msg=name)

    def test_first_step_is_that_of_the_law(self):
        self.compile_c("")
        user = f"model: user, density: 7850, vumat: law.so, constants: [{200e9 * 0.3 / (1.3 * 0.4)}, {200e9 / 2.6}]"
        ours = "model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3"
        steps = [self.run_deck(write_cube(law, 1e-4, ["{nodes: cube/x_min, fixed: [x]}"]), out=name)[0]["time"][1]
                 for name, law in (("user", user), ("ours", ours))]
        self.assertTrue(math.isclose(steps[0], steps[1], rel_tol=1e-5), steps)

    def test_state_variables_are_kept_over_ranks_and_restarts(self):
        # The law softens with its state, so that the forces depend on what is kept.
        self.compile_c("next[i] = state[i] + fabs(trace); for (int k = 0; k < 6; ++k) out[k * n + i] *= 1 - 1e-3 * next[i];")
        law = f"model: user, density: 1000, vumat: law.so, constants: [{LAMBDA}, {MU}], state_variables: 1"
        deck = write_cube(law, 4e-2, ["{nodes: cube/x_min, fixed: [x, y, z]}"], cells=4,
                          more="initial: [{nodes: cube/x_max, velocity: [-5, 1, 0]}]\n")
        self.check_bits(deck)

    def test_code_that_is_no_solid_is_refused_with_its_place(self):
        for body in ("for (int k = 0; k < 6; ++k) out[k * n + i] = 0;", "out[i] = NAN;", "out[i] = -out[i];", "next[n] = 1;"):
            self.compile_c(body)
            done = self.call(write_cube(USER, 1e-3, UNIAXIAL), command="check")
            self.assertEqual((done.returncode, "deck.yaml:3" in done.stderr, "no law of a solid" in done.stderr), (2, True, True), done.stderr)

    def test_code_may_divide_by_the_step_and_use_the_density(self):
        # A pressure of the density, and a stress of the rate, which is 0 at no rate.
        self.compile_c("const double p = 1e9 * (density[i] / props[2] - 1); const double shear = 2 * props[1];\n"
                       "for (int k = 0; k < 6; ++k) out[k * n + i] = (k < 3 ? -p - shear / 3 * trace : 0) + shear * strain[k * n + i] / *dt * 1e-6"
                       " + (k < 3 ? shear / 3 * trace - shear / 3 * trace / *dt * 1e-6 : 0);")
        law = f"model: user, density: 2000, vumat: law.so, constants: [0, {MU}, 2000]"
        rows, _ = self.run_deck(write_cube(law, 1e-4, UNIAXIAL), "--set", "time.max_step=1e-6")
        stretch = 1 + 100 * rows["time"][-1]
        mean = (rows["all_stress_xx"][-1] + 2 * rows["all_stress_yy"][-1]) / 3
        self.assertLess(abs(mean / (-1e9 * (1 / stretch - 1)) - 1), 0.01)

    def test_sweep_and_preview_take_the_library(self):
        self.compile_fortran()
        deck = write_cube(USER, 1e-4, UNIAXIAL)
        done = self.call(deck, "--vary", "materials.m.constants.0=1e6,2e6", "--output", "max(all_stress_xx)", "--out", "study", command="sweep")
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(os.path.join(self.folder, "study", "sweep.csv"), encoding="utf-8") as file:
            self.assertEqual(file.read().count("completed"), 2)
        done = self.call(deck, "--report", "--no-pictures", "--no-view", "--out", "page.html", command="check")
        self.assertEqual((done.returncode, os.path.exists(os.path.join(self.folder, "page.html"))), (0, True), done.stderr)

    def test_a_state_variable_deletes_elements(self):
        # The law deletes points whose strain along x has reached 0.1: at 1e-3, of the half that is stretched.
        self.compile_c("next[i] = state[i] + strain[i]; if (next[i] > 0.1) next[n + i] = 0;")
        law = f"model: user, density: 1000, vumat: law.so, constants: [{LAMBDA}, {MU}], state_variables: 2, delete_variable: 2"
        motion = ["{nodes: cube, fixed: [y, z]}", "{nodes: cube/x_min, fixed: [x]}", "{nodes: cube/x_max, velocity: {x: 100}}"]
        rows, _ = self.run_deck(write_cube(law, 2e-3, motion), "--set", "time.max_step=1e-5")
        alive = rows["all_stress_xx"] != 0
        last = rows["time"][np.max(np.nonzero(alive))]
        self.assertTrue(math.isclose(last, (math.exp(0.1) - 1) / 100, abs_tol=3e-5), last)
        np.testing.assert_allclose(rows["all_state_1"][alive], np.log(1 + 100 * rows["time"][alive]), rtol=0, atol=1e-4)
        wrong = self.call(write_cube(law.replace("delete_variable: 2", "delete_variable: 3"), 2e-3, motion))
        self.assertEqual((wrong.returncode, "raise state_variables" in wrong.stderr), (2, True), wrong.stderr)

    def test_hundreds_of_state_variables_are_kept_over_restarts(self):
        # State i grows by i times the strain, and the last one softens the law.
        self.compile_c("for (int s = 0; s < *states; ++s) next[s * n + i] = state[s * n + i] + (s + 1) * trace;\n"
                       "for (int k = 0; k < 6; ++k) out[k * n + i] *= 1 - 1e-4 * fabs(next[(*states - 1) * n + i]);")
        law = f"model: user, density: 1000, vumat: law.so, constants: [{LAMBDA}, {MU}], state_variables: 1000"
        more = "initial: [{nodes: cube/x_max, velocity: [-5, 1, 0]}]\n"
        deck = write_cube(law, 4e-2, ["{nodes: cube/x_min, fixed: [x, y, z]}"], cells=2, more=more).replace("output: {", "output: {fields: {every: 1, write: [state_variable_72]}, ")
        rows, book = self.run_deck(deck, out="whole")
        np.testing.assert_allclose(rows["all_state_1000"], 1000 * rows["all_state_1"], rtol=1e-9, atol=1e-12)
        self.assertGreater(np.max(np.abs(rows["all_state_1"])), 1e-3)
        self.assertEqual(self.continue_run(deck), book["state_hash"])
        wrong = self.call(deck.replace("state_variables: 1000", "state_variables: 1001"))
        self.assertEqual((wrong.returncode, "must be at most 1000" in wrong.stderr), (2, True), wrong.stderr)

    def test_state_variables_begin_with_those_of_the_deck(self):
        self.compile_c("next[n + i] = state[n + i] + 1;")
        law = f"model: user, density: 1000, vumat: law.so, constants: [{LAMBDA}, {MU}], state_variables: 3, start_states: [0.5, 7]"
        rows, _ = self.run_deck(write_cube(law, 1e-3, UNIAXIAL), "--set", "time.max_steps=5", "--set", "time.max_step=1e-6")
        self.assertEqual([rows[f"all_state_{i}"][-1] for i in (1, 2, 3)], [0.5, 12.0, 0.0])
        wrong = self.call(write_cube(law.replace("variables: 3", "variables: 1"), 1e-3, UNIAXIAL))
        self.assertEqual((wrong.returncode, "more start_states than state_variables" in wrong.stderr), (2, True), wrong.stderr)

    def test_temperatures_reach_the_code_and_its_inelastic_energy_heats(self):
        # Moduli times the temperature at the start, and a constant power of 5e4 by mass. Half of it heats: 50 degrees a second.
        self.compile_c("for (int k = 0; k < 6; ++k) out[k * n + i] = stress[k * n + i] + t0[i] * (out[k * n + i] - stress[k * n + i]);\nd1[i] = d0[i] + 5e4 * *dt;")
        law = f"model: user, density: 1000, vumat: law.so, constants: [{LAMBDA}, {MU}], start_temperature: 2, specific_heat: 500, heating_share: 0.5"
        rows, _ = self.run_deck(write_cube(law, 1e-4, UNIAXIAL), "--set", "time.max_step=1e-6")
        np.testing.assert_allclose(rows["all_temperature"], 2 + 50 * rows["time"], rtol=1e-12)
        np.testing.assert_allclose(rows["all_stress_xx"][-1], 2 * (LAMBDA + 2 * MU) * math.log(1.01), rtol=5e-3)
        held = ["{nodes: cube, fixed: [x, y, z]}"]
        rows, _ = self.run_deck(write_cube(law + ", thermal_expansion: 1e-2", 1e-4, held), "--set", "time.max_step=1e-6")
        np.testing.assert_allclose(rows["all_stress_yy"][-1], -2 * (3 * LAMBDA + 2 * MU) * 1e-2 * (50 * 1e-4), rtol=2e-2)
        cold = self.call(write_cube(law.replace("specific_heat: 500, heating_share: 0.5", "thermal_expansion: 1e-5"), 1e-4, held))
        self.assertEqual((cold.returncode, "no specific_heat" in cold.stderr), (2, True), cold.stderr)

    def test_hardening_in_fortran_has_its_closed_form(self):
        # A stretch at a constant rate that keeps the volume: Y = Y0(p) exp(-(k / span) Y0's integral), k = share / (rho cp), with m = 1.
        self.compile_fortran("johnson_cook.f")
        a, b, power, c, melt, room, share, capacity, density, young = 200e6, 400e6, 0.5, 0.02, 800.0, 300.0, 0.9, 50.0, 8000.0, 200e9
        law = (f"model: user_hardening, density: {density}, youngs_modulus: {young}, poissons_ratio: 0.3, vuhard: law.so, state_variables: 1, "
               f"constants: [{a}, {b}, {power}, {c}, 1, {melt}, {room}, 10], start_temperature: {room}, specific_heat: {capacity}")
        motion = ["{nodes: cube/x_min, fixed: [x]}", "{nodes: cube/y_min, fixed: [y]}", "{nodes: cube/z_min, fixed: [z]}",
                  *(f"{{nodes: cube/{axis}_max, displacement: {{{axis}: {{expression: \"exp({rate} * t) - 1\"}}}}}}" for axis, rate in (("x", 100), ("y", -50), ("z", -50)))]
        rows, _ = self.run_deck(write_cube(law, 3e-3, motion), "--set", "time.max_step=2e-6")
        stress = rows["all_stress_xx"] - rows["all_stress_yy"]
        plastic = 100 * rows["time"] - stress / (3 * young / 2.6)
        faster = 1 + c * math.log(10)
        work = faster * (a * plastic + b * plastic ** (power + 1) / (power + 1))
        colder = np.exp(-share / (density * capacity) / (melt - room) * work)
        exact = faster * (a + b * plastic**power) * colder
        late = rows["time"] > 1e-4
        self.assertLess(colder[-1], 0.7)
        np.testing.assert_allclose(stress[late], exact[late], rtol=5e-3)
        np.testing.assert_allclose(rows["all_temperature"][late], room + (melt - room) * (1 - colder[late]), rtol=5e-3)
        np.testing.assert_allclose(rows["all_state_1"][late], (rows["all_temperature"][late] - room) / (melt - room), rtol=1e-9)
        ours = law[law.index("youngs_modulus"):law.index(", vuhard")]
        ours = f"model: johnson_cook, density: {density}, {ours}, a: {a}, b: {b}, n: {power}, c: {c}, melt_temperature: {melt}, room_temperature: {room}, reference_rate: 10, start_temperature: {room}, specific_heat: {capacity}"
        same, _ = self.run_deck(write_cube(ours, 3e-3, motion), "--set", "time.max_step=2e-6", out="ours")
        np.testing.assert_allclose(stress[late], (same["all_stress_xx"] - same["all_stress_yy"])[late], rtol=1e-3)

    def test_plastic_work_heats_a_unit_of_mass(self):
        # Pulled along x to twice the volume, held across, perfectly plastic: J sigma dp / rho0 with dp = (2/3) dJ / J from the yield on.
        self.compile_fortran("johnson_cook.f")
        law = ("model: user_hardening, density: 8000, youngs_modulus: 200e9, poissons_ratio: 0.3, vuhard: law.so, state_variables: 1, "
               "constants: [1e8, 0, 1, 0, 1, 1e9, 300, 1], start_temperature: 300, specific_heat: 400, heating_share: 1")
        motion = ["{nodes: cube, fixed: [y, z]}", "{nodes: cube/x_min, fixed: [x]}", "{nodes: cube/x_max, velocity: {x: 100}}"]
        rows, _ = self.run_deck(write_cube(law, 1e-2, motion))
        right = 2 / 3 * 1e8 * (2 - math.exp(0.5 * 1e8 * 2.6 / 200e9)) / (8000 * 400)
        self.assertLess(abs((rows["all_temperature"][-1] - 300) / right - 1), 2e-3)

    def test_hardening_has_the_same_bits_over_ranks_and_restarts(self):
        self.compile_fortran("johnson_cook.f")
        law = ("model: user_hardening, density: 8000, youngs_modulus: 200e9, poissons_ratio: 0.3, vuhard: law.so, state_variables: 1, "
               "constants: [2e8, 4e8, 0.5, 0.02, 1, 800, 300, 10], start_temperature: 300, specific_heat: 50, thermal_expansion: 1e-5, failure: {plastic_strain: 0.3}")
        deck = write_cube(law, 2e-3, ["{nodes: cube/x_min, fixed: [x, y, z]}"], cells=4, more="initial: [{nodes: cube/x_max, velocity: [-300, 50, 0]}]\n")
        self.check_bits(deck)

    def test_hardening_that_is_none_is_refused_with_its_place(self):
        self.compile_fortran("johnson_cook.f")
        law = ("model: user_hardening, density: 8000, youngs_modulus: 200e9, poissons_ratio: 0.3, vuhard: law.so, "
               "constants: [2e8, 4e8, 0.5, 0.02, 1, 800, 300, 10], start_temperature: 300")
        for old, new, words in (("[2e8,", "[-2e8,", "is no yield stress"), ("start_temperature: 300", "start_temperature: 900", "is no yield stress"),
                                ("vuhard: law.so", "vumat: law.so", "a key of model user"),
                                ("start_temperature: 300", "failure: {johnson_cook: {d1: 1, d5: 1}}", "give melt_temperature"),
                                ("start_temperature: 300", "equation_of_state: {kind: linear, bulk_modulus: 1e9}", "does not take")):
            done = self.call(write_cube(law.replace(old, new), 1e-3, UNIAXIAL), "--quiet", "--force", "--out", "out")
            self.assertEqual((done.returncode, words in done.stderr, "deck.yaml:3" in done.stderr), (2, True, True), done.stderr)
        shells = write_cube(law, 1e-3, ["{nodes: cube, fixed: [x]}"]).replace("box: {size: [1, 1, 1], cells: [1, 1, 1]}", "shell_plate: {size: [1, 1], cells: [1, 1]}, thickness: 0.1")
        done = self.call(shells, command="check")
        self.assertEqual((done.returncode, "shells support" in done.stderr), (2, True), done.stderr)
        self.compile_fortran()
        done = self.call(write_cube(law, 1e-3, UNIAXIAL))
        self.assertEqual((done.returncode, "no entry vuhard_" in done.stderr), (2, True), done.stderr)

    def test_no_deck_loads_a_library_by_itself(self):
        self.compile_c("", C_LAW + '\n#include <stdio.h>\n__attribute__((constructor)) static void begin(void) { fclose(fopen("ran", "w")); }\n')
        deck = write_cube(USER, 1e-3, UNIAXIAL)
        for command in ("check", "run", "plan"):
            done = self.call(deck, *(["--ranks", "2"] if command == "plan" else []), command=command, allow=())
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn("add --allow-library", done.stderr)
            self.assertIn("deck.yaml:3", done.stderr)
        self.assertFalse(os.path.exists(os.path.join(self.folder, "ran")))
        self.run_deck(deck)
        os.remove(os.path.join(self.folder, "ran"))  # that the library begins so is no accident
        done = self.call(deck, "--restart", "out/checkpoint.h5", "--out", "again", allow=())
        self.assertEqual((done.returncode, os.path.exists(os.path.join(self.folder, "ran"))), (2, False), done.stderr)

    def test_libraries_that_are_no_law_are_refused(self):
        deck = write_cube(USER, 1e-3, UNIAXIAL)
        self.compile_c("", "int other(void) { return 1; }")
        done = self.call(deck)
        self.assertEqual((done.returncode, "no entry vumat_" in done.stderr), (2, True), done.stderr)
        with open(os.path.join(self.folder, "law.so"), "w", encoding="utf-8") as file:
            file.write("no library")
        done = self.call(deck)
        self.assertEqual((done.returncode, "law.so" in done.stderr), (2, True), done.stderr)

    def test_a_law_that_gives_no_number_ends_the_run_with_its_name(self):
        self.compile_c("if (*total_time > 1e-4) out[i] = NAN;")
        done = self.call(write_cube(USER, 1e-3, UNIAXIAL), "--quiet", "--out", "out")
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("its law is that of the library", done.stderr)

    def test_a_law_that_writes_outside_its_arrays_ends_the_run_with_its_name(self):
        for body in ("if (*total_time > 1e-4) out[6 * n] = 1;", "if (*total_time > 1e-4) next[n] = 1;"):
            self.compile_c(body)
            done = self.call(write_cube(USER, 1e-3, UNIAXIAL), "--quiet", "--force", "--out", "out")
            self.assertEqual(done.returncode, 3, done.stderr)
            self.assertIn("has written outside its arrays", done.stderr)

    def test_import_takes_user_material_with_a_library_alone(self):
        self.compile_fortran()
        corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
        nodes = "".join(f"{i}, {x}., {y}., {z}.\n" for i, (x, y, z) in enumerate(corners, 1))
        deck = (f"*NODE, NSET=all\n{nodes}*ELEMENT, TYPE=C3D8R, ELSET=cube\n1, 1, 2, 3, 4, 5, 6, 7, 8\n"
                f"*SOLID SECTION, ELSET=cube, MATERIAL=rubber\n*MATERIAL, NAME=rubber\n*DENSITY\n{DENSITY}\n"
                f"*USER MATERIAL, CONSTANTS=2\n{E}, {NU}\n*DEPVAR\n1,\n*NSET, NSET=left\n1, 4, 5, 8\n*NSET, NSET=right\n2, 3, 6, 7\n"
                "*BOUNDARY\nall, 2, 3\nleft, 1, 1\n*STEP\n*DYNAMIC, EXPLICIT\n, 2e-3\n*BOUNDARY, TYPE=VELOCITY\nright, 1, 1, 100.\n"
                "*ELSET, ELSET=one\n1,\n*OUTPUT, HISTORY, TIME INTERVAL=1e-5\n*ELEMENT OUTPUT, ELSET=one\nS\n*END STEP\n")
        with open(os.path.join(self.folder, "model.inp"), "w", encoding="utf-8") as file:
            file.write(deck)

        def take(*options):
            return subprocess.run([PERCUSS, "import", "model.inp", "--out", "model", "--force", *options], cwd=self.folder,
                                  capture_output=True, text=True, check=False)

        for wrong, word in ((deck.replace("CONSTANTS=2", "CONSTANTS=²"), "is not a number"),
                            (deck.replace("*DEPVAR", "*DEPVAR, DELETE=2"), "is none of 1 state variables"),
                            (deck.replace("CONSTANTS=2", "CONSTANTS=2, TYPE=THERMAL"), "of the type THERMAL"),
                            (deck.replace("*DEPVAR\n1,", "*DEPVAR\n1001,"), "at most 200 and 1000")):
            with open(os.path.join(self.folder, "model.inp"), "w", encoding="utf-8") as file:
                file.write(wrong)
            refused = take("--allow-library", "law.so")
            self.assertEqual((refused.returncode, word in refused.stderr), (2, True), refused.stderr)
        with open(os.path.join(self.folder, "model.inp"), "w", encoding="utf-8") as file:
            file.write(deck)
        refused = take()
        self.assertEqual(refused.returncode, 2, refused.stderr)
        self.assertIn("add --allow-library", refused.stderr)
        with open(os.path.join(self.folder, "model.inp"), "w", encoding="utf-8") as file:
            file.write(deck.replace("CONSTANTS=2", "CONST=24").replace(f"{NU}\n", f"{NU}\n1., 2.,\n, , ,\n").replace("*STEP", "*INITIAL CONDITIONS, TYPE=SOLUTION\ncube, 0.\n*STEP", 1))
        done = take("--allow-library", "law.so")
        self.assertEqual(done.returncode, 0, done.stderr)
        run = subprocess.run([PERCUSS, "run", "model/deck.yaml", "--quiet", "--allow-library", "law.so", "--out", "out"], cwd=self.folder,
                             capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, 0, run.stderr)
        with open(os.path.join(self.folder, "out", "history.csv"), encoding="utf-8") as file:
            names = file.readline().strip().split(",")
        table = np.loadtxt(os.path.join(self.folder, "out", "history.csv"), delimiter=",", skiprows=1)
        stress = [i for i, name in enumerate(names) if name.split(" ")[0].endswith("_xx")]
        self.assertEqual(len(stress), 1, names)
        stretch = 1 + 100 * table[-1, 0]
        exact = (MU * (stretch**2 - 1) + LAMBDA * math.log(stretch)) / stretch
        self.assertLess(abs(table[-1, stress[0]] / exact - 1), 5e-3)


if __name__ == "__main__":
    unittest.main()
