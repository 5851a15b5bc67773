"""Field outputs of regions, by the whole program: field_outputs_test.py ROOT PERCUSS [MPIEXEC...]. MPIEXEC ends with the option that
takes the number of ranks. Exit code 77 (skipped) without NumPy or h5py."""

import glob
import os
import subprocess
import tempfile
import unittest

from given import MPIEXEC, PERCUSS, require

require("h5py", "numpy")

import h5py
import numpy as np

import percuss  # noqa: E402

# Two blocks that share nodes, of which one is torn, and a plate that the other hits.
DECK = """\
title: A torn bar
units: m, kg, s
time: {end: 2.0e-5, max_step: 1.0e-7}
parts:
  left: {box: {size: [0.01, 0.004, 0.004], cells: [10, 4, 4]}, material: soft}
  right: {box: {size: [0.01, 0.004, 0.004], cells: [10, 4, 4]}, at: [0.01, 0, 0], material: brittle}
  plate: {shell_plate: {size: [0.02, 0.02], cells: [6, 6]}, at: [-0.005, -0.008, -0.0008], thickness: 0.001, material: soft}
materials:
  soft: {model: j2_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: 400e6, hardening_modulus: 1e9}
  brittle: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, failure: {principal_stress: 1.2e9, fade_steps: 3}}
join: true
initial: [{part: left, velocity: [-60, 0, -40]}, {part: right, velocity: [60, 0, -40]}]
contact: {surfaces: all}
output:
  fields: {every: 2.0e-6, write: [velocity, contact_force, contact_pressure, mass, stress, von_mises, equivalent_plastic_strain,
    damage, thickness, body, chunk]}
  field_outputs:
    torn: {elements: right, every: 2.0e-6, write: [velocity, contact_force, contact_pressure, mass, stress, equivalent_plastic_strain,
      damage, thickness, body, chunk], format: [vtkhdf, exodus]}
    skin: {faces: [left/x_min, plate], every: 4.0e-6, write: [velocity, von_mises, thickness, chunk], format: [vtkhdf, exodus]}
    hull: {faces: all, every: 1.0e-5, write: [contact_pressure]}
    often: {every: 1.0e-6}
  history: {every: 1.0e-6}
  checkpoint: {every: 1.0e-6}
"""
OUTPUTS = ("torn", "skin", "hull", "often")


class FieldOutputs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.out = cls.run_percuss("one")

    @classmethod
    def path(cls, name):
        return os.path.join(cls.folder.name, name)

    @classmethod
    def call(cls, *words, ranks=1):
        start = [*MPIEXEC, str(ranks)] if ranks > 1 else []
        return subprocess.run([*start, PERCUSS, *words], capture_output=True, text=True, timeout=300,
                              env=dict(os.environ, OMP_NUM_THREADS="1", OMP_PROC_BIND="false"))

    @classmethod
    def run_percuss(cls, name, *options, ranks=1, deck=DECK, code=0):
        with open(cls.path("deck.yaml"), "w", encoding="utf-8") as file:
            file.write(deck)
        done = cls.call("run", cls.path("deck.yaml"), "--out", cls.path(name), "--quiet", *options, ranks=ranks)
        if done.returncode != code:
            raise AssertionError(f"exit code {done.returncode}: {done.stderr}")
        return cls.path(name)

    def check(self, deck):
        with open(self.path("wrong.yaml"), "w", encoding="utf-8") as file:
            file.write(deck)
        done = self.call("check", self.path("wrong.yaml"))
        return done.returncode, done.stderr

    def test_values_are_those_of_the_main_file_bit_by_bit(self):
        run = percuss.read(self.out)
        self.assertEqual(sorted(run.field_outputs), sorted(OUTPUTS))
        whole = run.fields
        place = {number: i for i, number in enumerate(whole.node_ids)}
        element = {number: i for i, number in enumerate(whole.element_ids)}
        self.assertLess(whole.alive(-1).sum(), whole.elements)  # something has torn
        for name, fields in run.field_outputs.items():
            nodes = [place[number] for number in fields.node_ids]
            elements = [element[number] for number in fields.element_ids]
            common = [(i, list(whole.times).index(t)) for i, t in enumerate(fields.times) if t in whole.times]
            self.assertGreaterEqual(len(common), 3)
            self.assertEqual([fields.part_names[p] for p in fields.part], [whole.part_names[p] for p in whole.part[elements]])
            for own, main in common:
                self.assertEqual(fields.steps[own], whole.steps[main])
                np.testing.assert_array_equal(fields.positions(own), whole.positions(main)[nodes])
                for field, where in fields.names().items():
                    if field != "part":
                        chosen = nodes if where == "node" else elements
                        np.testing.assert_array_equal(fields.data(field, own), whole.data(field, main)[chosen], f"{name} {field}")

    def test_regions_have_the_elements_and_nodes_that_the_deck_names(self):
        outputs = percuss.read(self.out).field_outputs
        self.assertEqual((outputs["torn"].elements, outputs["torn"].nodes), (160, 11 * 25))
        self.assertEqual((outputs["skin"].elements, outputs["skin"].nodes), (16 + 36, 25 + 49))
        self.assertEqual(outputs["hull"].elements, 2 * (2 * 16 + 4 * 40) - 2 * 16 + 36)
        self.assertEqual([len(cell) for cell in outputs["skin"].cells()], [4] * 52)
        self.assertEqual(outputs["skin"].part_names, ["left", "plate"])
        for name, frames in (("torn", 11), ("skin", 6), ("hull", 3), ("often", 21)):
            self.assertEqual(len(outputs[name].times), frames, name)

    def test_vtk_and_exodus_read_them(self):
        try:
            from vtkmodules.vtkIOHDF import vtkHDFReader
        except ImportError:
            self.skipTest("no VTK")
        for name in OUTPUTS:
            reader = vtkHDFReader()
            reader.SetFileName(os.path.join(self.out, f"fields_{name}.vtkhdf"))
            reader.Update()
            fields = percuss.read(self.out).field_outputs[name]
            grid = reader.GetOutput()
            self.assertEqual((grid.GetNumberOfPoints(), grid.GetNumberOfCells()), (fields.nodes, fields.elements), name)
            self.assertEqual(grid.GetBounds()[:2], (fields.positions(0)[:, 0].min(), fields.positions(0)[:, 0].max()))
        for name in ("torn", "skin"):
            fields = percuss.read(self.out).field_outputs[name]
            with h5py.File(os.path.join(self.out, f"fields_{name}.exo"), "r") as file:
                np.testing.assert_array_equal(file["time_whole"][:], fields.times)
                self.assertEqual(len(np.unique(file["elem_num_map"][:])), fields.elements)
                np.testing.assert_array_equal(file["vals_nod_var1"][-1], fields.data("displacement", -1)[:, 0])
                if name == "torn":
                    np.testing.assert_array_equal(file["elem_num_map"][:], fields.element_ids)

    def test_indexes_lead_to_their_own_file(self):
        for name in OUTPUTS:
            with open(os.path.join(self.out, f"fields_{name}.xdmf2"), encoding="utf-8") as file:
                text = file.read()
            self.assertIn(f"fields_{name}.vtkhdf:", text)
            self.assertNotIn("fields.vtkhdf:", text)

    def compare(self, one, other):
        names = sorted(os.path.basename(path) for path in glob.glob(os.path.join(one, "fields*")))
        self.assertEqual(len(names), 3 * 5 + 2)
        self.assertEqual(names, sorted(os.path.basename(path) for path in glob.glob(os.path.join(other, "fields*"))))
        for name in names:
            a, b = os.path.join(one, name), os.path.join(other, name)
            if name.endswith((".xdmf", ".xdmf2")):
                with open(a, "rb") as left, open(b, "rb") as right:
                    self.assertEqual(left.read(), right.read(), name)
                continue
            found, expected = _read_datasets(b), _read_datasets(a)
            self.assertEqual(sorted(found), sorted(expected), name)
            for dataset in expected:
                self.assertEqual(found[dataset], expected[dataset], f"{name}: {dataset}")

    def test_files_are_the_same_on_any_number_of_ranks(self):
        if not MPIEXEC:
            self.skipTest("no mpirun")
        for ranks in (2, 3):
            self.compare(self.out, self.run_percuss(f"ranks{ranks}", ranks=ranks))

    def test_a_restart_cuts_what_is_behind_the_checkpoint_and_goes_on(self):
        stopped = self.run_percuss("stopped", "--set", "time.max_steps=130")
        again = self.run_percuss("stopped", "--restart", os.path.join(stopped, "checkpoint.h5"), ranks=3 if MPIEXEC else 1)
        self.compare(self.out, again)

    def test_an_output_may_begin_and_end_with_a_restart(self):
        stopped = self.run_percuss("changed", "--set", "time.max_steps=100", "--set", "output.field_outputs={}")
        self.run_percuss("changed", "--restart", os.path.join(stopped, "checkpoint.h5"))
        fields = percuss.read(stopped).field_outputs["often"]
        self.assertGreater(fields.steps[0], 100)
        np.testing.assert_array_equal(fields.times, percuss.read(self.out).field_outputs["often"].times[-len(fields.times):])

    def test_frames_that_a_shorter_run_would_lose_are_named(self):
        full = self.run_percuss("lost")
        done = self.call("run", self.path("deck.yaml"), "--restart", os.path.join(full, "checkpoint_previous.h5"), "--quiet",
                         "--out", full, "--set", "output.field_outputs.often.every=1.0e-5")
        self.assertEqual(done.returncode, 2)
        self.assertIn("of fields_often.vtkhdf up to t = 2e-05", done.stderr)

    def test_force_removes_the_files_of_all_outputs(self):
        full = self.run_percuss("forced")
        done = self.call("run", self.path("deck.yaml"), "--out", full, "--quiet", "--set", "output.field_outputs={}")
        self.assertEqual(done.returncode, 2)
        self.run_percuss("forced", "--force", "--set", "output.field_outputs={}")
        self.assertEqual(glob.glob(os.path.join(full, "fields_*")), [])

    def test_force_leaves_the_files_of_others_and_keeps_what_the_deck_reads(self):
        full = self.run_percuss("mine", "--set", "time.max_steps=20")
        mine = os.path.join(full, "fields_mine.exo")
        with open(mine, "w", encoding="utf-8") as file:
            file.write("not of percuss")
        self.run_percuss("mine", "--force", "--set", "time.max_steps=10")
        self.assertTrue(os.path.exists(mine))
        source = os.path.join(full, "fields_torn.exo")
        done = self.call("run", self.path("deck.yaml"), "--out", full, "--quiet", "--force", "--set", f"start.fields=[{{file: {source}}}]")
        self.assertEqual(done.returncode, 2)
        self.assertIn("--force would remove this file of start.fields", done.stderr)
        self.assertTrue(os.path.exists(source))

    def test_a_restart_in_place_with_another_region_is_refused(self):
        stopped = self.run_percuss("region", "--set", "time.max_steps=100")
        done = self.call("run", self.path("deck.yaml"), "--restart", os.path.join(stopped, "checkpoint.h5"), "--quiet",
                         "--set", "output.field_outputs.torn.elements=left")
        self.assertEqual(done.returncode, 2)
        self.assertIn("field output 'torn' shows other elements than in the run of the checkpoint", done.stderr)

    def test_info_and_check_list_them(self):
        text = self.call("info", self.out).stdout
        for name in OUTPUTS:
            self.assertIn(f"fields_{name}.vtkhdf", text)
        text = self.call("check", self.path("deck.yaml")).stdout
        self.assertIn("11 frames of field output 'torn' (160 elements, 275 nodes)", text)

    def test_what_is_unknown_or_empty_is_refused_at_its_place(self):
        for old, new, place, message in (
                ("elements: right", "elements: rigth", "18:22", "unknown part 'rigth' in field output 'torn' (did you mean 'right'?)"),
                ("left/x_min", "left/x_mni", "20:20", "part 'left' has no side 'x_mni'"),
                ("{faces: all", "{faces: {name: left, inside: [[9, 9, 9], [10, 10, 10]]}", "21:19", "no exterior faces"),
                ("elements: right", "elements: right/x_min", "18:22", "no elements")):
            code, text = self.check(DECK.replace(old, new))
            self.assertEqual(code, 2)
            self.assertIn(f"wrong.yaml:{place}", text, message)
            self.assertIn(message, text)


def _read_datasets(path):
    found = {}

    def visit(name, item):
        if isinstance(item, h5py.Dataset) and item.dtype.kind not in "O":
            found[name] = (item.shape, str(item.dtype), item[()].tobytes())

    with h5py.File(path, "r") as file:
        file.visititems(visit)
    return found


if __name__ == "__main__":
    unittest.main()
