"""Laws of one's own in C++ (percuss build-law, model: library): build_law_test.py ROOT PERCUSS [MPIEXEC ...].

Exit code 77 (skipped) without NumPy.
"""

import os
import shutil
import subprocess
import unittest

from law_runs import PERCUSS, ROOT, UNIAXIAL, LawTest, np, write_cube

import percuss

GENT = os.path.join(ROOT, "inputs", "user_law", "gent.hpp")
LAWS = os.path.join(ROOT, "kernels", "material", "laws")
MU, LIMIT, BULK = 1e6, 2.0, 1e7
RUBBER = f"model: library, density: 1100, law: law.so, constants: {{shear_modulus: {MU}, limit: {LIMIT}, bulk_modulus: {BULK}}}"
TABLE = "[[0, 200e6], [0.1, 300e6], [0.5, 400e6]]"
STEEL = f"density: 7850, {{}}youngs_modulus: 200e9, poissons_ratio: 0.3, hardening: {TABLE}"
OURS = "model: tabulated_plasticity, " + STEEL.format("")
OWN = "model: library, law: law.so, " + STEEL.format("constants: {") + "}"
# A law with every kind of constant, whose stress is E times the strain, E = number * table(count) * (word ? 2 : 1) + vector.z.
KINDS = """
#include "kernels/material/elastic.hpp"
#include "kernels/material/material_key.hpp"
#include "kernels/material/material_table.hpp"
#include "kernels/material/point_step.hpp"
struct Kinds {
  static constexpr const char* name = "kinds";
  using Constants = Kinds;
  double number = 0, vector[3] = {0, 0, 0};
  int count = 0;
  bool word = false;
  percuss::MaterialTable table;
  static constexpr auto keys() {
    using namespace percuss;
    return std::array{need("number", &Kinds::number, KeyRange::positive, "pressure", ""), may("count", &Kinds::count, 5, ""),
                      may("word", &Kinds::word, "single", "double", ""), may("vector", &Kinds::vector, KeyRange::any, "pressure", ""),
                      need("table", &Kinds::table, KeyRange::not_negative, "-", "")};
  }
  static constexpr int history_count = 2;
  double modulus() const { return number * table(double(count)).y * (word ? 2 : 1) + vector[2]; }
  percuss::LameConstants moduli() const { return {0, modulus() / 2}; }
  template <class T>
  void update(percuss::PointStep<T>& step) const {
    step.stress = step.stress + T(modulus()) * step.motion.de;
    step.history[0] = step.history[0] + step.motion.de.xx;
    BODY
  }
};
"""


class LawsOfLibraries(LawTest):
    def build(self, source, *options, out="law.so"):
        return subprocess.run([PERCUSS, "build-law", source, "--out", out, *options], cwd=self.folder, capture_output=True, text=True, check=False)

    def build_well(self, source, **how):
        done = self.build(source, **how)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_rubber_of_the_example_has_its_closed_form(self):
        self.build_well(GENT)
        rows, summary = self.run_deck(write_cube(RUBBER, 1e-2, UNIAXIAL))
        stretch = 1 + 100 * rows["time"]
        square = stretch ** (-2 / 3) * stretch**2
        first = stretch ** (-2 / 3) * (stretch**2 + 2)
        self.assertGreater(first[-1] - 3, 0.3 * LIMIT)  # where the chains stiffen
        shear = MU * LIMIT / (LIMIT - (first - 3)) / stretch * (square - first / 3)
        exact = shear + BULK * (stretch - 1)
        np.testing.assert_allclose(rows["all_stress_xx"], exact, rtol=0, atol=2e-3 * np.max(exact))
        np.testing.assert_allclose(rows["all_stress_yy"], -shear / 2 + BULK * (stretch - 1), rtol=0, atol=2e-3 * np.max(exact))
        self.assertLess(abs(summary["energy"]["error"]), 1e-3)

    def test_a_law_of_percuss_gives_the_same_from_a_library(self):
        shutil.copy(os.path.join(LAWS, "tabulated_plasticity.hpp"), os.path.join(self.folder, "own.hpp"))
        self.build_well("own.hpp")
        motion = ["{nodes: cube/z_min, fixed: [x, y, z]}", "{nodes: cube/z_max, velocity: {x: 20, z: 5, y: 0}}"]
        own = self.run_deck(write_cube(OWN, 2e-2, motion, cells=2), out="own")
        ours = self.run_deck(write_cube(OURS, 2e-2, motion, cells=2), out="ours")
        self.assertEqual(own[1]["state_hash"], ours[1]["state_hash"])
        self.assertGreater(ours[0]["all_eps"][-1], 0.1)
        np.testing.assert_array_equal(own[0]["all_eps"], ours[0]["all_eps"])
        np.testing.assert_array_equal(own[0]["all_state_1"], ours[0]["all_eps"])

    def test_rubber_of_percuss_keeps_its_energy_from_a_library(self):
        # Full integration takes the stress of a law that stores energy by another rule.
        shutil.copy(os.path.join(LAWS, "yeoh.hpp"), os.path.join(self.folder, "own.hpp"))
        self.build_well("own.hpp")
        constants = "c10: 0.4e6, c20: -0.02e6, c30: 0.01e6, bulk_modulus: 20e6"
        hashes = []
        for law in (f"model: yeoh, {constants}", f"model: library, law: law.so, constants: {{{constants}}}"):
            deck = write_cube(law + ", density: 1000", 5e-2, ["{nodes: cube/z_min, fixed: [x, y, z]}", "{nodes: cube/z_max, velocity: {x: 20, z: 5, y: 0}}"], cells=2)
            hashes.append(self.run_deck(deck.replace("elements: {", "elements: {integration: full, "))[1]["state_hash"])
        self.assertEqual(*hashes)

    def test_failure_fields_ranks_and_restart(self):
        shutil.copy(os.path.join(LAWS, "tabulated_plasticity.hpp"), os.path.join(self.folder, "own.hpp"))
        self.build_well("own.hpp")
        more = "initial: [{nodes: cube/x_max, velocity: [-150, 20, 0]}]\n"
        deck = write_cube(OWN + ", failure: {plastic_strain: 0.03}", 1.5e-3, ["{nodes: cube/x_min, fixed: [x, y, z]}"], cells=4, more=more)
        deck = deck.replace("output: {", "output: {fields: {every: 5e-4, write: [state_variable_1, equivalent_plastic_strain, state_variable_72]}, ")
        self.assertGreater(self.check_bits(deck)["eroded"]["elements"], 0)
        fields = percuss.read(os.path.join(self.folder, "whole")).fields
        state, strain = fields.values("state_variable_1", -1), fields.values("equivalent_plastic_strain", -1)
        self.assertGreater(np.max(strain), 0.02)
        np.testing.assert_array_equal(state, strain)
        self.assertEqual(np.max(np.abs(fields.values("state_variable_72", -1))), 0)

    def test_every_kind_of_constant_arrives(self):
        self.build_well(self.write("kinds.hpp", KINDS.replace("BODY", "")))
        constants = "number: 1e9, count: 2, word: double, vector: [0, 0, 5e8], table: [[0, 1], [4, 3]]"
        law = f"model: library, density: 1000, law: law.so, constants: {{{constants}}}"
        rows, _ = self.run_deck(write_cube(law, 1e-4, UNIAXIAL))
        strain = np.log(1 + 100 * rows["time"])
        modulus = 1e9 * 2 * 2 + 5e8
        np.testing.assert_allclose(rows["all_stress_xx"], modulus * strain, rtol=0, atol=1e-4 * modulus * strain[-1])
        np.testing.assert_allclose(rows["all_state_1"], strain, rtol=0, atol=1e-4 * strain[-1])
        for wrong, words in ((constants.replace("number: 1e9, ", ""), "constants.number of this law is missing"),
                             (constants.replace("1e9", "-1e9"), "must be positive"), (constants.replace("count: 2", "count: 7"), "an integer from 0 to 5"),
                             (constants.replace("double", "triple"), "single or double"), (constants.replace("[0, 0, 5e8]", "3"), "it is three numbers"),
                             (constants + ", more: 1", "is unknown: it has"), (constants + ", numbr: 1", "did you mean 'number'?"),
                             (constants.replace("[4, 3]", "[4, -3]"), "zero or positive"),
                             (constants.replace("[4, 3]", "[0, 3]"), "rows must ascend")):
            done = self.call(write_cube(law.replace(constants, wrong), 1e-4, UNIAXIAL), command="check")
            self.assertEqual((done.returncode, words in done.stderr, "deck.yaml:3:" in done.stderr), (2, True, True), done.stderr)

    def test_a_law_that_gives_no_number_or_writes_outside_ends_the_run_with_its_name(self):
        constants = "number: 1e9, table: [[0, 1]]"
        law = f"model: library, density: 1000, law: law.so, constants: {{{constants}}}"
        late = "if (step.motion.time > 1e-3) "
        for body, words in ((late + "step.stress.xx = T(0) / T(0);", "its law is that of the library"),
                            (late + "step.history[2] = T(1);", "has written outside its arrays")):
            self.build_well(self.write("kinds.hpp", KINDS.replace("BODY", body)))
            done = self.call(write_cube(law, 2e-3, UNIAXIAL), "--quiet", "--force", "--out", "out")
            self.assertEqual((done.returncode, words in done.stderr), (3, True), done.stderr)

    def test_no_deck_loads_a_library_by_itself_and_none_of_another_kind(self):
        self.build_well(GENT)
        deck = write_cube(RUBBER, 1e-4, UNIAXIAL)
        done = self.call(deck, allow=())
        self.assertEqual((done.returncode, "add --allow-library" in done.stderr), (2, True), done.stderr)
        done = self.call(deck.replace(f"bulk_modulus: {BULK}", "bulk_modulus: 1e5"), command="check")
        self.assertEqual((done.returncode, "a bulk_modulus that is not above its shear_modulus" in done.stderr), (2, True), done.stderr)
        self.write("other.cpp", "int other() { return 1; }")
        subprocess.run(["c++", "-shared", "-fPIC", "-o", "law.so", "other.cpp"], cwd=self.folder, check=True)
        done = self.call(deck)
        self.assertEqual((done.returncode, "no entry percuss_law" in done.stderr), (2, True), done.stderr)
        self.write("other.cpp", 'struct Layout { int version; unsigned long sizes[3]; int lanes; };\n'
                                'extern "C" const void* percuss_law() { static Layout other{0, {0, 0, 0}, 0}; return &other; }')
        subprocess.run(["c++", "-shared", "-fPIC", "-o", "law.so", "other.cpp"], cwd=self.folder, check=True)
        done = self.call(deck)
        self.assertEqual((done.returncode, "made for another percuss" in done.stderr), (2, True), done.stderr)

    def test_headers_that_are_no_law_are_refused(self):
        for text, words in (("struct A {};", "no struct with keys()"), (None, "cannot read"),
                            ("struct A { static int keys(); };\nstruct B { static int keys(); };", "name its struct with --law"),
                            (KINDS.replace("BODY", "nonsense"), "does not compile"),
                            (KINDS.replace("BODY", "").replace("history_count = 2", "history_count = 1025"), "at most 1024 numbers a point")):
            source = "none.hpp" if text is None else self.write("law.hpp", text)
            done = self.build(source)
            self.assertEqual((done.returncode, words in done.stderr), (2, True), done.stderr)
        self.assertFalse(os.path.exists(os.path.join(self.folder, "law.so")))
        done = self.build(self.write("law.hpp", KINDS.replace("BODY", "")), "--law", "Kinds; int x")
        self.assertEqual((done.returncode, "not the name of a struct" in done.stderr), (2, True), done.stderr)


if __name__ == "__main__":
    unittest.main()
