"""percuss export: export_test.py ROOT PERCUSS. Exit code 77 (skipped) without NumPy or h5py; Exodus II where SciPy, .vtu where VTK is.

The d3plot files are read by a reader of this file, from the layout that Livermore Software publishes, and by nothing of percuss."""

import csv
import json
import os
import re
import subprocess
import tempfile
import unittest

from given import PERCUSS, require

require("h5py", "numpy")

import numpy as np

try:
    import scipy
except ImportError:
    scipy = None
try:
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
except ImportError:
    vtkXMLUnstructuredGridReader = None

import percuss  # noqa: E402
from tool_command import call_tool  # noqa: E402
from percuss.errors import NotResults  # noqa: E402
from percuss.export.selection import parse_frames  # noqa: E402

# Every kind of element; the block tears, the plate and the bar are pulled, the others fly.
DECK = """\
title: every kind of element
units: mm, kg, ms
time: {end: 4.0e-2}
parts:
  block:   {box: {size: [40, 10, 10], cells: [4, 1, 1]}, material: weak}
  wedge:   {box: {size: [10, 10, 10], cells: [1, 1, 1]}, elements: wedges, at: [0, 20, 0], material: steel}
  pyramid: {box: {size: [10, 10, 10], cells: [1, 1, 1]}, elements: pyramids, at: [0, 40, 0], material: steel}
  tet:     {box: {size: [10, 10, 10], cells: [1, 1, 1]}, elements: tetrahedra, at: [0, 60, 0], material: steel}
  plate:   {shell_plate: {size: [20, 20], cells: [2, 2]}, at: [0, 80, 0], thickness: 2, material: steel}
  bar:     {line: {from: [0, 110, 0], to: [30, 110, 0], cells: 3}, section: {rectangle: {size: [2, 4]}}, toward: y, material: steel}
materials:
  steel: {model: j2_plasticity, density: 7.85e-6, youngs_modulus: 200, poissons_ratio: 0.3, yield_stress: 0.4, hardening_modulus: 1}
  weak:  {model: j2_plasticity, density: 7.85e-6, youngs_modulus: 200, poissons_ratio: 0.3, yield_stress: 0.1, hardening_modulus: 0.1, failure: {plastic_strain: 0.05}}
initial:
  - {part: wedge, velocity: [1, 2, 3]}
  - {part: pyramid, velocity: [-4, 0, 0]}
  - {part: tet, velocity: [0, 5, 0]}
conditions:
  - {nodes: block/x_min, fixed: [x, y, z]}
  - {nodes: block/x_max, velocity: {x: 400}}
  - {nodes: plate/x_min, fixed: [x, y, z]}
  - {nodes: plate/x_max, velocity: {x: 20}}
  - {nodes: bar/start, fixed: [x, y, z]}
  - {nodes: bar/end, velocity: {x: 30}}
output:
  fields: {every: 1.0e-2, write: [velocity, stress, stress_bottom, stress_top, equivalent_plastic_strain, thickness, section_force, section_moment]}
  history: {every: 1.0e-3, parts: all}
"""
VOLUMES = {"block": 4000, "wedge": 1000, "pyramid": 1000, "tet": 1000}  # mm^3 at time 0


class Words:
    """Words of a file, one after the other."""

    def __init__(self, path):
        with open(path, "rb") as file:
            self.data, self.at = file.read(), 0

    def take(self, kind, count):
        values = np.frombuffer(self.data, kind, count, self.at)
        self.at += values.nbytes
        return values

    def integers(self, *shape):
        return self.take("<i4", int(np.prod(shape))).reshape(shape)

    def floats(self, *shape):
        return self.take("<f4", int(np.prod(shape))).reshape(shape)

    def text(self, words):
        return self.take(f"S{4 * words}", 1)[0].decode().rstrip()

    def expect_end(self):
        assert self.floats(1)[0] == -999999.0


class D3plot:
    """The published layout: control words (by their number), geometry, arbitrary numbers, titles of parts; states in d3plot01."""

    def __init__(self, folder):
        words = Words(os.path.join(folder, "d3plot"))
        control = Words(os.path.join(folder, "d3plot")).integers(64)
        self.title = words.text(10)
        assert control[11] == 1 and 900 < control[14:15].view("<f4")[0] < 1000 and control[15] == 4
        words.at = 4 * 64
        self.nodes, self.globals = int(control[16]), int(control[18])
        self.count = {"solid": int(control[23]), "beam": int(control[28]), "shell": int(control[31])}
        self.width = {"solid": int(control[27]), "beam": int(control[30]), "shell": int(control[33])}
        self.materials = [int(control[place]) for place in (24, 29, 32)]
        assert list(control[20:23]) == [1, 1, 0] and control[36] <= -10000
        self.layers = -int(control[36]) - 10000
        assert control[43] == control[44] == 1000 and control[45] != 1000
        assert self.width["solid"] == 7 and self.width["shell"] == 7 * self.layers + 4 * (control[46] == 1000)
        self.start = words.floats(self.nodes, 3)
        self.corners = {kind: words.integers(self.count[kind], width) for kind, width in (("solid", 9), ("beam", 6), ("shell", 5))}
        first, parts = words.at, int(control[51])
        head = words.integers(16)
        assert head[0] < 0 and list(head[5:9]) == [self.nodes, *(self.count[kind] for kind in ("solid", "beam", "shell"))]
        self.node_ids = words.integers(self.nodes)
        self.ids = {kind: words.integers(self.count[kind]) for kind in ("solid", "beam", "shell")}
        self.part_ids = words.integers(3, parts)[0]
        assert words.at - first == 4 * control[39]
        words.expect_end()
        assert list(words.integers(2)) == [90001, parts]
        self.names = {int(words.integers(1)[0]): words.text(18) for _ in range(parts)}
        self.states, states = [], Words(os.path.join(folder, "d3plot01"))
        while states.take("<f4", 1)[0] != -999999.0:
            states.at -= 4
            self.states.append(self.read_state(states))
        assert states.at == len(states.data)

    def read_state(self, words):
        state = {"time": float(words.floats(1)[0]), "globals": words.floats(self.globals), "x": words.floats(self.nodes, 3),
                 "v": words.floats(self.nodes, 3)}
        for kind in ("solid", "beam", "shell"):
            state[kind] = words.floats(self.count[kind], self.width[kind])
        state["alive"] = {kind: words.floats(self.count[kind]) for kind in ("solid", "shell", "beam")}
        return state

    def part_of(self, kind):
        return [self.names[int(part)] for part in self.corners[kind][:, -1]]


def find_volume(corners, x):
    """Of a solid with repeated nodes: six pyramids on the faces of the hexahedron, each of two triangles at the mean of its corners."""
    p = x[corners].astype(float)
    middle, total = p.mean(axis=0), 0.0
    for face in ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)):  # outward
        a, b, c, d = (p[corner] - middle for corner in face)
        total += (np.dot(np.cross(a, b), c) + np.dot(np.cross(a, c), d)) / 6
    return total


class Export(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        deck = os.path.join(folder.name, "deck.yaml")
        with open(deck, "w", encoding="utf-8") as file:
            file.write(DECK)
        cls.out = os.path.join(folder.name, "out")
        done = subprocess.run([PERCUSS, "run", deck, "--out", cls.out, "--quiet"], capture_output=True, text=True, timeout=120,
                              env=dict(os.environ, OMP_NUM_THREADS="1", OMP_PROC_BIND="false"))
        assert done.returncode == 0, done.stderr
        cls.run_ = percuss.read(cls.out)

    def export(self, *words, code=0):
        done = call_tool("export", self.out, *words)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done.stdout + done.stderr

    def path(self, name):
        return os.path.join(self.out, "export", name)

    def test_d3plot_is_read_by_its_published_layout(self):
        told = self.export("--format", "d3plot")
        self.assertNotIn("zeros", told)
        file, fields = D3plot(self.path("")), self.run_.fields
        self.assertEqual(file.title, "every kind of element")
        self.assertEqual(list(file.names.values()), ["block", "wedge", "pyramid", "tet", "plate", "bar"])
        self.assertEqual(file.count, {"solid": 4 + 2 + 6 + 12, "beam": 3, "shell": 4})
        self.assertEqual(file.materials, [4, 1, 1])
        self.assertEqual(len(file.states), len(fields.times))
        volumes = dict.fromkeys(VOLUMES, 0.0)
        for row, name in zip(file.corners["solid"], file.part_of("solid")):
            volume = find_volume(row[:8] - 1, file.start)
            self.assertGreater(volume, 0)
            volumes[name] += volume
        for name, volume in volumes.items():
            self.assertAlmostEqual(volume, VOLUMES[name], delta=1e-3 * VOLUMES[name], msg=name)
        first, last = file.states[0], file.states[-1]
        self.assertAlmostEqual(last["time"], fields.times[-1], delta=1e-7)
        flying = {"wedge": (1, 2, 3), "pyramid": (-4, 0, 0), "tet": (0, 5, 0)}
        for row, name in zip(file.corners["solid"], file.part_of("solid")):
            if name in flying:  # what flies moves by its velocity times the time
                nodes = row[:8] - 1
                np.testing.assert_allclose(last["v"][nodes], np.tile(flying[name], (8, 1)), atol=1e-5)
                np.testing.assert_allclose(last["x"][nodes] - first["x"][nodes], np.tile(np.multiply(flying[name], last["time"]), (8, 1)), atol=1e-4)
        self.assertAlmostEqual(first["globals"][2], first["globals"][0] + first["globals"][1], delta=1e-3)

    def test_d3plot_tells_stress_strain_and_what_has_failed(self):
        self.export("--format", "d3plot", "--frames", "-1", "--force")
        file, fields = D3plot(self.path("")), self.run_.fields
        (state,) = file.states
        place = {int(number): row for row, number in enumerate(fields.element_ids)}
        rows = {kind: [place[int(number)] for number in file.ids[kind]] for kind in file.ids}
        stress, strain = fields.data("stress", -1), fields.data("equivalent_plastic_strain", -1)
        np.testing.assert_allclose(state["solid"][:, :6], stress[rows["solid"]], rtol=1e-6, atol=1e-9)
        np.testing.assert_allclose(state["solid"][:, 6], strain[rows["solid"]], rtol=1e-6)
        for layer, name in enumerate(("stress", "stress_bottom", "stress_top")):
            np.testing.assert_allclose(state["shell"][:, 7 * layer : 7 * layer + 6], fields.data(name, -1)[rows["shell"]], rtol=1e-6, atol=1e-9)
        np.testing.assert_allclose(state["shell"][:, 21], fields.data("thickness", -1)[rows["shell"]], rtol=1e-6)
        self.assertGreater(np.abs(state["shell"][:, 0]).max(), 0.1)  # it yields
        np.testing.assert_allclose(state["beam"][:, 0], fields.data("section_force", -1)[rows["beam"], 0], rtol=1e-6)
        self.assertGreater(state["beam"][:, 0].max(), 0.4 * 2 * 4 * 0.99)  # kN: all of the section yields
        alive = fields.alive(-1)
        for kind in ("solid", "beam", "shell"):
            np.testing.assert_array_equal(state["alive"][kind] > 0, alive[rows[kind]])
            np.testing.assert_array_equal(state["alive"][kind][alive[rows[kind]]], file.corners[kind][alive[rows[kind]], -1])
        self.assertLess((state["alive"]["solid"] > 0).sum(), 24)  # the block has torn

    def test_what_a_run_lacks_is_told(self):
        told = self.export("--format", "d3plot", "--field", "velocity", "--force", "--frames", "0")
        for words in ("stress, equivalent_plastic_strain: not in the run", "forces of beams are zeros"):
            self.assertIn(words, told)
        self.assertNotIn("all three layers", told)
        self.assertIn("all three layers", self.export("--format", "d3plot", "--field", "stress", "--force", "--frames", "0"))

    def test_an_earlier_database_goes_whole_and_others_stay(self):
        folder = os.path.join(self.out, "family")
        self.export("--format", "d3plot", "--out", folder)
        with open(os.path.join(folder, "d3plot02"), "wb") as file:
            file.write(b"states of a longer run")
        self.export("--format", "d3plot", "--out", folder, "--frames", "0")
        self.assertEqual(sorted(os.listdir(folder)), ["d3plot", "d3plot01"])
        with open(os.path.join(folder, "d3plot"), "wb") as file:
            file.write(b"of LS-DYNA")
        self.assertIn("--force", self.export("--format", "d3plot", "--out", folder, code=2))

    @unittest.skipUnless(vtkXMLUnstructuredGridReader, "VTK is not here")
    def test_vtu_is_read_by_vtk(self):
        self.export("--format", "pvd", "--field", "velocity,stress", "--frames", "0..-1:2")
        with open(self.path("fields.pvd"), encoding="utf-8") as file:
            text = file.read()
        fields = self.run_.fields
        for frame in range(0, len(fields.times), 2):
            self.assertIn(f'timestep="{float(fields.times[frame])!r}" file="fields_{frame:04}.vtu"', text)
            reader = vtkXMLUnstructuredGridReader()
            reader.SetFileName(self.path(f"fields_{frame:04}.vtu"))
            reader.Update()
            grid = reader.GetOutput()
            np.testing.assert_array_equal(vtk_to_numpy(grid.GetPoints().GetData()), fields.positions(frame))
            np.testing.assert_array_equal(vtk_to_numpy(grid.GetCellData().GetArray("stress")), fields.data("stress", frame))
            np.testing.assert_array_equal(vtk_to_numpy(grid.GetPointData().GetArray("velocity")), fields.data("velocity", frame))
            self.assertEqual(sorted({grid.GetCellType(cell) for cell in range(grid.GetNumberOfCells())}), [3, 9, 10, 12, 13, 14])
            self.assertEqual(grid.GetFieldData().GetArray("TimeValue").GetValue(0), fields.times[frame])

    @unittest.skipUnless(scipy, "SciPy is not here")
    def test_exodus_is_read_by_its_own_library(self):
        self.export("--format", "exodus")
        done = subprocess.run([PERCUSS, "info", self.path("fields.e")], capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 0, done.stderr)
        for words in (f"times       {len(self.run_.fields.times)} steps, 0 to 0.04", "displacement, of nodes, 3 components", "stress, of elements, 6 components",
                      "block", "pyramid", "bar"):
            self.assertIn(words, done.stdout)

    def test_tables_have_a_row_for_each_node_and_element(self):
        self.export("--format", "csv", "--frames", "-1", "--field", "velocity,equivalent_plastic_strain")
        last = len(self.run_.fields.times) - 1
        with open(self.path(f"fields_nodes_{last:04}.csv"), encoding="utf-8") as file:
            self.assertIn("t = 0.04", file.readline())
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), self.run_.fields.nodes)
        np.testing.assert_array_equal([float(row["velocity_x [mm/ms]"]) for row in rows], self.run_.fields.data("velocity", -1)[:, 0])
        with open(self.path(f"fields_elements_{last:04}.csv"), encoding="utf-8") as file:
            file.readline()
            rows = list(csv.DictReader(file))
        self.assertEqual([row["part"] for row in rows].count("tet"), 12)

    def test_gltf_holds_surfaces_that_move(self):
        self.export("--format", "gltf", "--field", "velocity")
        with open(self.path("fields.glb"), "rb") as file:
            data = file.read()
        magic, version, size, length = np.frombuffer(data, "<u4", 4)
        self.assertEqual((magic, version, size), (0x46546C67, 2, len(data)))
        document, binary = json.loads(data[20 : 20 + length]), data[28 + length :]

        def read(number):
            accessor = document["accessors"][number]
            view = document["bufferViews"][accessor["bufferView"]]
            width = {"SCALAR": 1, "VEC3": 3}[accessor["type"]]
            kind = {5125: "<u4", 5126: "<f4"}[accessor["componentType"]]
            return np.frombuffer(binary, kind, accessor["count"] * width, view["byteOffset"]).reshape(-1, width)

        self.assertEqual([mesh["name"] for mesh in document["meshes"]], ["block", "wedge", "pyramid", "tet", "plate"])
        wedge = document["meshes"][1]["primitives"][0]
        start, corners = read(wedge["attributes"]["POSITION"]).astype(float), read(wedge["indices"]).reshape(-1, 3)
        a, b, c = (start[corners[:, k]] for k in range(3))
        self.assertAlmostEqual(float(np.sum(np.cross(a, b) * c)) / 6, 1e-6, delta=1e-10)  # m^3, closed, outward
        np.testing.assert_allclose(read(wedge["targets"][-1]["POSITION"]), np.tile([4e-5, 8e-5, 12e-5], (len(start), 1)), atol=1e-7)
        weights = read(document["animations"][0]["samplers"][0]["output"]).reshape(len(self.run_.fields.times), -1)
        np.testing.assert_array_equal(weights[-1], [0] * (weights.shape[1] - 1) + [1])

    def test_frames_are_chosen(self):
        self.assertEqual(parse_frames("0..-1:2,-1", 6), [0, 2, 4, 5])
        self.assertEqual(parse_frames("all", 3), [0, 1, 2])
        for text in ("6", "x", "0..9", "3..1", "", "1..2:0"):
            with self.assertRaisesRegex(NotResults, f"'{re.escape(text)}' names no frame", msg=text):
                parse_frames(text, 6)

    def test_wrong_words_have_a_clear_one(self):
        for words, text in ((("--field", "velocty"), "did you mean velocity?"), (("--frames", "99"), "there are"), (("--from", "rim"), "rim")):
            self.assertIn(text, self.export("--format", "vtu", *words, code=2))
        self.assertIn("one field", self.export("--format", "gltf", "--field", "velocity,stress", code=2))


if __name__ == "__main__":
    unittest.main()
