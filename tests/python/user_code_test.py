"""What code of users gets and may call (model: user): axes, elements, lengths, routines, tables: user_code_test.py ROOT PERCUSS [MPIEXEC ...].

Exit code 77 (skipped) without a compiler of C or without NumPy.
"""

import math
import os
import unittest

from law_runs import MPIEXEC, UNIAXIAL, LawTest, need, np, write_cube

need("cc")

# Elastic with the stiffness `c` of normal strains and the shear moduli `g`, by the rate of J sigma. BODY is what it does more for a point.
LAW = """
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>
TOP
static double det(const double* u, int n) {
  return u[0] * (u[n] * u[2 * n] - u[4 * n] * u[4 * n]) - u[3 * n] * (u[3 * n] * u[2 * n] - u[4 * n] * u[5 * n]) + u[5 * n] * (u[3 * n] * u[4 * n] - u[n] * u[5 * n]);
}
void vumat_(const int* block, const int* ndir, const int* nshr, const int* states, const int* fields, const int* count,
            const int* info, const double* step_time, const double* total_time, const double* dt, const char* name,
            const double* places, const double* length, const double* props, const double* density, const double* strain,
            const double* spin, const double* t0, const double* u0, const double* f0, const double* q0, const double* stress,
            const double* state, const double* e0, const double* d0, const double* t1, const double* u1, const double* f1,
            const double* q1, double* out, double* next, double* e1, double* d1) {
  const int n = block[0];
  for (int i = 0; i < n; ++i) {
    const double *e = strain + i, before = det(u0 + i, n), after = det(u1 + i, n);
    const double c[3][3] = {{props[0], props[3], props[5]}, {props[3], props[1], props[4]}, {props[5], props[4], props[2]}};
    for (int k = 0; k < 6; ++k) {
      const double own = k < 3 ? c[k][0] * e[0] + c[k][1] * e[n] + c[k][2] * e[2 * n] : 2 * props[3 + k] * e[k * n];
      out[k * n + i] = stress[k * n + i] + (own - (after - before) * stress[k * n + i]) / after;
    }
    BODY
  }
}
"""
# Moduli, Poisson's ratios and shear moduli of a ply.
E1, E2, E3, N12, N23, N13, G12, G23, G13 = 140e9, 12e9, 9e9, 0.3, 0.4, 0.25, 5e9, 3e9, 4e9
COMPLIANCE = np.array([[1 / E1, -N12 / E1, -N13 / E1], [-N12 / E1, 1 / E2, -N23 / E2], [-N13 / E1, -N23 / E2, 1 / E3]])
C = np.linalg.inv(COMPLIANCE)
CONSTANTS = [C[0, 0], C[1, 1], C[2, 2], C[0, 1], C[1, 2], C[0, 2], G12, G23, G13]
MODULUS = 1e9  # of the laws that are alike in all directions
ALIKE = [MODULUS, MODULUS, MODULUS, 0, 0, 0, MODULUS / 2, MODULUS / 2, MODULUS / 2]


def user(constants=None, more=""):
    return f"model: user, density: 1600, vumat: law.so, constants: {[float(value) for value in constants or CONSTANTS]}{more}"


class UserCode(LawTest):
    def compile(self, body="", top=""):
        self.compile_text(LAW.replace("BODY", body).replace("TOP", top))

    def test_axes_under_stretch_and_turn_are_those_of_our_own_law(self):
        self.compile()
        axes = ", first_axis: [0.6, 0.8, 0.3], second_axis: [-0.2, 1, 0.1]"
        ours = (f"model: orthotropic, density: 1600, moduli: [{E1}, {E2}, {E3}], poissons_ratios: [{N12}, {N23}, {N13}], shear_moduli: [{G12}, {G23}, {G13}]{axes}")
        motion = ["{nodes: cube/z_min, fixed: [x, y, z]}", "{nodes: cube/z_max, velocity: {x: 500, z: 100, y: -100}}"]
        found = [self.run_deck(write_cube(law, 2e-3, motion), "--set", "time.max_step=1e-5", out=name)[0] for name, law in (("user", user(more=axes)), ("ours", ours))]
        largest = np.max(np.abs(found[1]["all_stress_zx"]))
        self.assertGreater(largest, 1e9)
        for name in ("xx", "yy", "zz", "xy", "yz", "zx"):
            np.testing.assert_allclose(found[0][f"all_stress_{name}"], found[1][f"all_stress_{name}"], rtol=0, atol=1e-8 * largest, err_msg=name)

    def test_a_ply_at_an_angle_has_the_stiffness_of_its_transformation(self):
        # Jones, Mechanics of Composite Materials, 2nd edition, equation 2.80, with the stiffness of no strain across.
        self.compile()
        c, s = math.cos(math.radians(30)), math.sin(math.radians(30))
        rows, book = self.run_deck(write_cube(user(more=f", first_axis: [{c}, {s}, 0]"), 1e-6, UNIAXIAL), "--set", "time.max_step=1e-7")
        strain = math.log(1 + 100 * rows["time"][-1])
        right = {"xx": c**4 * C[0, 0] + 2 * c * c * s * s * (C[0, 1] + 2 * G12) + s**4 * C[1, 1],
                 "yy": c * c * s * s * (C[0, 0] + C[1, 1] - 4 * G12) + (c**4 + s**4) * C[0, 1],
                 "xy": c**3 * s * (C[0, 0] - C[0, 1] - 2 * G12) + c * s**3 * (C[0, 1] - C[1, 1] + 2 * G12)}
        for name, modulus in right.items():
            self.assertLess(abs(rows[f"all_stress_{name}"][-1] / (modulus * strain) - 1), 1e-3, name)

    def test_first_step_is_that_of_the_stiffest_axis(self):
        self.compile()
        hold = ["{nodes: cube/x_min, fixed: [x]}"]
        steps = [self.run_deck(write_cube(user(more=axis), 1e-4, hold), out=f"out_{i}")[0]["time"][1]
                 for i, axis in enumerate(("", ", first_axis: [0, 1, 0], second_axis: [1, 0, 0]", ", first_axis: [0, 0, 1]"))]
        self.assertTrue(math.isclose(steps[0], steps[1], rel_tol=1e-4) and math.isclose(steps[0], steps[2], rel_tol=1e-4), steps)
        swapped = self.run_deck(write_cube(user([C[1, 1], C[0, 0], C[2, 2], C[0, 1], C[0, 2], C[1, 2], G12, G13, G23]), 1e-4, hold), out="swapped")[0]["time"][1]
        self.assertTrue(math.isclose(steps[0], swapped, rel_tol=0.1), (steps, swapped))

    def test_wrong_axes_are_refused(self):
        self.compile()
        done = self.call(write_cube(user(more=", first_axis: [1, 0, 0], second_axis: [2, 0, 0]"), 1e-4, UNIAXIAL), command="check")
        self.assertEqual((done.returncode, "zero or parallel" in done.stderr), (2, True), done.stderr)

    def test_elements_and_lengths_reach_the_code(self):
        self.compile("next[i] = block[4 + i], next[n + i] = block[1] + block[2] + block[3], next[2 * n + i] = length[i] / cbrt(after), next[3 * n + i] = info[4];")
        deck = write_cube(user(ALIKE, ", state_variables: 4"), 1e-3, UNIAXIAL, cells=2).replace("id: 1", "id: 5").replace("size: [1, 1, 1]", "size: [1, 2, 4]")
        for points in ("one_point", "full"):
            rows, _ = self.run_deck(deck.replace("elements: {bulk", f"elements: {{integration: {points}, bulk"))
            self.assertEqual([rows[f"all_state_{i}"][-1] for i in (1, 2, 4)], [5.0, 3.0, 0.0])
            self.assertGreater(np.ptp(rows["all_stress_xx"]), 1e5)
            np.testing.assert_allclose(rows["all_state_3"][1:], 1, rtol=1e-12)  # over the edge of a cube of V / V(0)

    def test_places_are_those_of_the_points_as_they_move(self):
        # A cube that is pulled to 1 + 100 t along x: its middle, or its points at 1/2 -+ 1/(2 sqrt 3), of which the record has the mean.
        self.compile("for (int k = 0; k < 3; ++k) next[k * n + i] = places[k * n + i], next[(3 + k) * n + i] = (places[k * n + i] - 0.5) * (places[k * n + i] - 0.5);")
        square = {"one_point": 0, "full": 1 / 12, "thick_shell": 1 / 12}
        for points, law in ((points, user(ALIKE, ", state_variables: 6")) for points in square):
            deck = write_cube(law, 1e-3, UNIAXIAL).replace("elements: {bulk", f"elements: {{integration: {points}, bulk")
            rows, _ = self.run_deck(deck)
            stretch = 1 + 100 * rows["time"][1:]
            np.testing.assert_allclose(rows["all_state_1"][1:], 0.5 * stretch, rtol=1e-12)
            for i in (2, 3):
                np.testing.assert_allclose(rows[f"all_state_{i}"][1:], 0.5, rtol=1e-12)
            np.testing.assert_allclose(rows["all_state_4"][1:], square[points] * stretch**2 + (0.5 * stretch - 0.5) ** 2, rtol=1e-12)
            np.testing.assert_allclose(rows["all_state_5"][1:], square[points], rtol=1e-12, atol=1e-15)
        for shape in ("tetrahedra", "wedges", "pyramids"):  # those of a cube have its middle as their mean
            deck = write_cube(user(ALIKE, ", state_variables: 6"), 1e-3, ["{nodes: cube, velocity: {x: 100, y: 20, z: -30}}"])
            deck = deck.replace("material: m}", f"elements: {shape}, material: m}}")
            rows, _ = self.run_deck(deck)
            moved = [np.ptp(rows[f"all_state_{i}"][1:]) for i in (1, 2, 3)]
            np.testing.assert_allclose(moved, np.array([100, 20, 30]) * np.ptp(rows["time"][1:]), rtol=1e-9)

    def test_places_and_spins_have_the_same_bits_over_a_restart(self):
        self.compile("for (int k = 0; k < 3; ++k) next[k * n + i] = places[k * n + i], next[(3 + k) * n + i] += spin[k * n + i];")
        deck = write_cube(user(ALIKE, ", state_variables: 6"), 1e-3, ["{nodes: cube/x_min, fixed: [x, y, z]}"], cells=3,
                          more="initial: [{nodes: cube/x_max, velocity: [-100, 50, 0]}]\n")
        self.check_bits(deck)

    def test_the_spin_beyond_the_frame_is_that_of_simple_shear(self):
        # Dienes, Acta Mechanica 32 (1979): with x = X + g Y the frame has turned by atan(g / 2) clockwise, the material by the spin g / 2.
        self.compile("for (int k = 0; k < 3; ++k) next[k * n + i] += spin[k * n + i];")
        motion = ["{nodes: cube, fixed: [y, z]}", "{nodes: cube/y_min, fixed: [x]}", "{nodes: cube/y_max, velocity: {x: 100}}"]
        for axes, component in (("", 3), (", first_axis: [0, 0, 1], second_axis: [1, 0, 0]", 1)):
            for points in ("one_point", "full"):
                deck = write_cube(user(ALIKE, ", state_variables: 3" + axes), 1e-2, motion).replace("elements: {bulk", f"elements: {{integration: {points}, bulk")
                rows, _ = self.run_deck(deck, "--set", "time.max_step=2e-5")
                half = 50 * rows["time"][-1]
                self.assertLess(abs(rows[f"all_state_{component}"][-1] - (math.atan(half) - half)), 2e-5)
                self.assertLess(max(abs(rows[f"all_state_{i}"][-1]) for i in (1, 2, 3) if i != component), 1e-9)
        turned = ["{nodes: cube/z_min, fixed: [x, y, z]}"]  # what turns rigidly has none
        rows, _ = self.run_deck(write_cube(user(ALIKE, ", state_variables: 3"), 1e-4, turned))
        self.assertEqual([rows[f"all_state_{i}"][-1] for i in (1, 2, 3)], [0.0, 0.0, 0.0])

    def test_times_are_those_of_the_steps_of_the_analysis(self):
        self.compile("next[i] = *step_time, next[n + i] = *total_time;", """
        void vexternaldb_(const int* moment, int* i, const int* ni, double* r, const int* nr) {
          FILE* out = fopen("told.txt", "a");
          fprintf(out, "%d %d %.17g %.17g\\n", *moment, i[2], r[0], r[1]);
          fclose(out);
        }
        """)
        deck = write_cube(user(ALIKE, ", state_variables: 2, step_starts: [3e-4, 7e-4]"), 1e-3, UNIAXIAL)
        rows, _ = self.run_deck(deck, "--set", "time.max_step=1.1e-5")
        time = rows["time"][1:]
        start = np.where(time > 7e-4, 7e-4, np.where(time > 3e-4, 3e-4, 0))
        np.testing.assert_allclose(rows["all_state_1"][1:], time - start, rtol=1e-12)
        np.testing.assert_allclose(rows["all_state_2"][1:], time, rtol=0, atol=0)
        told = np.loadtxt(os.path.join(self.folder, "told.txt"))
        ends = told[told[:, 0] == 4]
        np.testing.assert_array_equal(ends[:, 2], time)
        np.testing.assert_array_equal(ends[:, 1], 1 + (time > 3e-4) + (time > 7e-4))
        np.testing.assert_allclose(ends[:, 3], time - start, rtol=1e-12)
        for wrong in ("[7e-4, 3e-4]", "[0]"):
            done = self.call(deck.replace("[3e-4, 7e-4]", wrong), command="check")
            self.assertEqual((done.returncode, "step_starts" in done.stderr), (2, True), done.stderr)

    LENGTHS = """
    void vucharlength_(const int* n, const int* fields, const int* count, const int* components, const int* dimensions, const int* corners, const int* states,
                       const int* section, const int* layer, const int* point, const int* kind, const int* element, const double* t, const double* s, const double* dt,
                       const char* name, const double* place, const double* x, const double* direct, const double* turn, const double* props, const double* field,
                       const double* state, double* length) {
      double least[3], most[3];
      for (int k = 0; k < 3; ++k) {
        least[k] = 1e30, most[k] = -1e30;
        for (int c = 0; c < *corners; ++c) {
          const double at = x[c] * direct[3 * k] + x[c + *corners] * direct[3 * k + 1] + x[c + 2 * *corners] * direct[3 * k + 2];
          if (at < least[k]) least[k] = at;
          if (at > most[k]) most[k] = at;
        }
      }
      length[1] = most[0] - least[0], length[2] = props[0] * (most[1] - least[1]), length[3] = *element + 10 * kind[0] + 100 * *count + 1000 * *states, length[4] = state[1], length[5] = place[2];
    }
    """

    def test_lengths_of_vucharlength_reach_the_code(self):
        self.compile("for (int k = 0; k < 6; ++k) next[k * n + i] = length[k * n + i];", self.LENGTHS)
        law = user(ALIKE, ", state_variables: 6, start_states: [0, 7], characteristic_lengths: 6, length_constants: [3], first_axis: [0, 1, 0], second_axis: [0, 0, 1]")
        deck = write_cube(law, 1e-3, UNIAXIAL).replace("size: [1, 1, 1]", "size: [1, 2, 4]")
        rows, book = self.run_deck(deck)
        self.assertEqual([round(float(rows[f"all_state_{i}"][-1]), 9) for i in range(1, 7)], [2.0, 2.0, 12.0, 6161.0, 7.0, 2.0])
        self.assertEqual(self.continue_run(deck, steps=3), book["state_hash"])
        self.compile()
        done = self.call(deck, command="check")
        self.assertEqual((done.returncode, "no entry vucharlength_" in done.stderr), (2, True), done.stderr)
        self.compile("", self.LENGTHS.replace("length[4] = state[1]", "length[4] = NAN"))
        done = self.call(deck, "--quiet", "--force", "--out", "out")
        self.assertEqual((done.returncode, "tells a length of nan" in done.stderr), (2, True), done.stderr)

    MOMENTS = """
    void vgetjobname_(char*, int*, size_t);
    void vgetoutdir_(char*, int*, size_t);
    void vgetrank_(int*);
    void vgetnumcpus_(int*);
    long smaintarraycreate_(const int*, const int*, const int*);
    long smaintarrayaccess_(const int*);
    int smaintarraysize_(const int*);
    void vexternaldb_(const int* moment, int* i, const int* ni, double* r, const int* nr) {
      const int id = 3, size = 2, value = 5;
      char job[81], folder[257];
      int job_length, folder_length, rank, ranks;
      if (*moment == 0) smaintarraycreate_(&id, &size, &value);
      int* kept = (int*)smaintarrayaccess_(&id);
      if (*moment == 4) kept[1] += 1;
      if (*moment != 0 && *moment != 6) { EACH return; }
      vgetjobname_(job, &job_length, 80), vgetoutdir_(folder, &folder_length, 256), vgetrank_(&rank), vgetnumcpus_(&ranks);
      char file[400];
      sprintf(file, "told_%d.txt", rank);
      FILE* out = fopen(file, "a");
      fprintf(out, "%d %d %d %d %.*s %s %d %d %d\\n", *moment, i[0], i[1], i[3], job_length, job, strrchr((folder[folder_length] = 0, folder), '/') + 1, ranks, kept[1], smaintarraysize_(&id));
      fclose(out);
    }
    """

    def test_vexternaldb_is_called_at_its_moments_and_finds_the_run(self):
        self.compile("", self.MOMENTS.replace("EACH", ""))
        _, book = self.run_deck(write_cube(user(ALIKE), 1e-3, UNIAXIAL))
        self.assertEqual(self.read("told_0.txt"), f"0 8 1 0 deck out 1 5 2\n6 8 1 {book['steps']} deck out 1 {5 + book['steps']} 2\n")
        if MPIEXEC:
            self.run_deck(write_cube(user(ALIKE), 1e-3, UNIAXIAL, cells=4), out="ranks", launcher=[*MPIEXEC, "2"])
            self.assertEqual(self.read("told_1.txt").splitlines()[0], "0 125 64 0 deck ranks 2 5 2")

    def test_vexternaldb_may_ask_for_the_end(self):
        self.compile("", self.MOMENTS.replace("EACH", "if (*moment == 4 && i[3] == 3) i[4] = 2;"))
        done = self.call(write_cube(user(ALIKE), 1e-2, UNIAXIAL), "--quiet", "--out", "out", "--set", "time.max_step=1e-5")
        self.assertEqual((done.returncode, "asks for the end of the run" in done.stderr), (130, True), done.stderr)
        self.assertTrue(os.path.exists(os.path.join(self.folder, "out", "checkpoint.h5")))

    def test_code_ends_the_run_with_the_name_of_its_library(self):
        exits = {"xplb_exit_();": "XPLB_EXIT", "xit_();": "XIT",
                 'const int bad = -3, twos[1] = {2}; const double halves[1] = {0.5}; xplb_abqerr_(&bad, "it is %I and %R and %S", twos, halves, "word    ", 22, 8);': "it is 2 and 0.5 and word"}
        top = "void xplb_exit_(void); void xit_(void); void xplb_abqerr_(const int*, const char*, const int*, const double*, const char*, size_t, size_t);"
        for statement, words in exits.items():
            self.compile(f"if (*total_time > 1e-4) {{ {statement} }}", top)
            for launcher in [(), *([[*MPIEXEC, "2"]] if MPIEXEC else [])]:
                done = self.call(write_cube(user(ALIKE), 1e-3, UNIAXIAL, cells=4), "--quiet", "--force", "--out", "out", launcher=launcher)
                self.assertEqual((done.returncode, words in done.stderr, "the code of law.so has ended the run" in done.stderr), (3, True, True), done.stderr)
                self.assertFalse([name for name in os.listdir(os.path.join(self.folder, "out")) if "lock" in name])

    def test_messages_are_printed_some_times(self):
        self.compile('const int kind = -1; const int zero = 0; const double none = 0; xplb_abqerr_(&kind, "mind the gap", &zero, &none, "", 12, 0);',
                     "void xplb_abqerr_(const int*, const char*, const int*, const double*, const char*, size_t, size_t);")
        done = self.call(write_cube(user(ALIKE), 1e-3, UNIAXIAL), "--quiet", "--out", "out")
        self.assertEqual((done.returncode, done.stderr.count("warning: law.so: mind the gap"), done.stderr.count("not printed again")), (0, 5, 1), done.stderr)

    TABLES = """
    void settablecollection_(const char*, int*, size_t);
    void querytablecollectionsize_(int*, int*);
    void querytablecollectionnames_(char*, const int*, size_t);
    void queryparametertable_(const char*, int*, int*, int*, size_t);
    void getparametertable_(const char*, const int*, int*, int*, double*, char*, int*, size_t, size_t);
    void getparametertablerow_(const char*, const int*, const int*, int*, int*, double*, char*, int*, size_t, size_t);
    """

    def test_tables_reach_the_code(self):
        self.compile("""
          int error, wrong, columns, rows, kinds[3], integers[6], sizes[4]; double numbers[6]; char words[480], names[160]; const int second = 2, two = 2;
          querytablecollectionsize_(sizes, &error), querytablecollectionnames_(names, &two, 80);
          settablecollection_("none", &wrong, 4), settablecollection_("second  ", &error, 8), queryparametertable_("T", &columns, &rows, &error, 1);
          getparametertable_("T", &columns, kinds, integers, numbers, words, &error, 1, 80);
          next[i] = sizes[0], next[n + i] = 100 * columns + 10 * rows + wrong, next[2 * n + i] = integers[3], next[3 * n + i] = numbers[1], next[4 * n + i] = !memcmp(words + 5 * 80, "WORD ", 5), next[5 * n + i] = kinds[0] + 10 * kinds[1] + 100 * kinds[2];
          getparametertablerow_("T", &second, &columns, kinds, integers, numbers, words, &error, 1, 80);
          next[6 * n + i] = numbers[1] + (memcmp(names, "first ", 6) ? 100 : 0);
        """, self.TABLES)
        deck = write_cube(user(ALIKE, ", state_variables: 7, parameter_tables: t.csv"), 1e-3, UNIAXIAL)
        self.write("t.csv", "collection,first\ncollection,second\ntable,T,integer,float,string\nrow,1,2.5,A\nrow,-4,1e3,WORD\n")
        rows, _ = self.run_deck(deck)
        self.assertEqual([rows[f"all_state_{i}"][-1] for i in range(1, 8)], [2.0, 321.0, -4.0, 2.5, 1.0, 321.0, 1000.0])
        for text, words in (("row,1\n", "none of a table"), ("collection,a\ntable,T,word\n", "the kind 'word'"), ("collection,a\ntable,T,integer\nrow,1,2\n", "a row of 2 values"),
                            ("collection,a\ntable,T,float\nrow,x\n", "the value 'x'")):
            self.write("t.csv", text)
            done = self.call(deck, command="check")
            self.assertEqual((done.returncode, words in done.stderr, "t.csv:" in done.stderr), (2, True, True), done.stderr)


if __name__ == "__main__":
    unittest.main()
