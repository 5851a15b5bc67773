"""Reads fields.exo of the sample run (write_sample_run.cpp) with VTK's Exodus reader and compares every number.

usage: read_exodus.py FOLDER. Exit code 77 (skipped) if VTK or h5py is not installed.
"""

import os
import sys
import unittest

try:
    import h5py
    import numpy as np
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet
    from vtkmodules.vtkIOExodus import vtkExodusIIReader
except ImportError as error:
    print(f"skipped: {error}; scripts/install_dependencies --render installs what this test needs")
    sys.exit(77)

FOLDER = sys.argv.pop()
PATH = os.path.join(FOLDER, "fields.exo")
FRAMES = 3
CELLS = 2
PER_CUBE = CELLS**3


def cube():
    n = CELLS + 1
    z, y, x = np.meshgrid(np.arange(n), np.arange(n), np.arange(n), indexing="ij")
    return np.column_stack([x.ravel(), y.ravel(), z.ravel()]).astype(float)


def stress_of(frame):
    return 100 * frame + np.arange(2 * PER_CUBE)[:, None] + 0.1 * np.arange(6)[None, :]


class Vtk(unittest.TestCase):
    def setUp(self):
        self.reader = vtkExodusIIReader()
        self.reader.SetFileName(PATH)
        self.reader.UpdateInformation()
        self.reader.SetApplyDisplacements(False)
        self.reader.GenerateGlobalNodeIdArrayOn()
        self.reader.GenerateGlobalElementIdArrayOn()
        for kind in (self.reader.NODAL, self.reader.ELEM_BLOCK):
            for i in range(self.reader.GetNumberOfObjectArrays(kind)):
                self.reader.SetObjectArrayStatus(kind, self.reader.GetObjectArrayName(kind, i), 1)

    def blocks(self, frame):
        self.reader.SetTimeStep(frame)
        self.reader.Update()
        self.assertEqual(self.reader.GetErrorCode(), 0)
        found = self.reader.GetOutput().GetBlock(0)
        return [found.GetBlock(i) for i in range(found.GetNumberOfBlocks())]

    def test_has_every_frame_and_the_title(self):
        self.assertEqual(self.reader.GetNumberOfTimeSteps(), FRAMES)
        self.assertEqual(self.reader.GetTitle(), "A sample & its <title>")
        with h5py.File(PATH, "r") as file:
            np.testing.assert_array_equal(file["time_whole"][:], [0.1 * frame for frame in range(FRAMES)])
            np.testing.assert_array_equal(file["vals_glo_var"][:, 0], [0, 10, 20])

    def test_has_a_block_for_each_part_with_its_hexahedra(self):
        self.assertEqual([self.reader.GetObjectName(self.reader.ELEM_BLOCK, i).split(" Size")[0] for i in range(2)],
                         ["left", 'right <&"> one'])
        for block in self.blocks(0):
            self.assertEqual(block.GetNumberOfCells(), PER_CUBE)
            for cell in range(PER_CUBE):
                self.assertEqual(block.GetCellType(cell), 12)
                ids = block.GetCell(cell).GetPointIds()
                corner = [np.array(block.GetPoint(ids.GetId(i))) for i in (0, 1, 3, 4)]
                volume = np.dot(np.cross(corner[1] - corner[0], corner[2] - corner[0]), corner[3] - corner[0])
                self.assertAlmostEqual(volume, 1.0)

    def test_has_every_number_of_every_frame(self):
        for frame in range(FRAMES):
            t = 0.1 * frame
            for part, block in enumerate(self.blocks(frame)):
                x = vtk_to_numpy(block.GetPoints().GetData())
                x0 = {tuple(p): i for i, p in enumerate(cube() + [10 * part, 0, 0])}
                order = [x0[tuple(p)] for p in np.round(x, 12)]
                self.assertEqual(sorted(order), list(range(len(x0))))
                nodes = {block.GetPointData().GetArrayName(i)
                         .rstrip("_"): vtk_to_numpy(block.GetPointData().GetArray(i))
                         for i in range(block.GetPointData().GetNumberOfArrays())}
                np.testing.assert_allclose(
                    nodes["displacement"], np.column_stack([t * x[:, 1], 0 * x[:, 0] + t / 3, 0 * x[:, 0] - t * t]),
                    atol=1e-15)
                np.testing.assert_array_equal(
                    nodes["velocity"],
                    np.column_stack([x[:, 1] + frame, np.full(len(x), 1 / 3), np.full(len(x), -2 * t)]))
                first = part * len(x0)
                np.testing.assert_array_equal(nodes["GlobalNodeId"], 1000 - first - np.array(order))
                cells = {block.GetCellData().GetArrayName(i).rstrip("_"): vtk_to_numpy(block.GetCellData().GetArray(i))
                         for i in range(block.GetCellData().GetNumberOfArrays())}
                mine = np.arange(part * PER_CUBE, (part + 1) * PER_CUBE)
                np.testing.assert_array_equal(cells["von_mises"], 1e6 * frame + mine / 7)
                np.testing.assert_array_equal(cells["flag"], (500 + 3 * mine + frame) % 2)
                np.testing.assert_array_equal(cells["GlobalElementId"], 500 + 3 * mine)

    def test_has_the_sets_of_the_mesh(self):
        for kind in (self.reader.NODE_SET, self.reader.SIDE_SET):
            self.assertEqual(self.reader.GetNumberOfObjects(kind), 1)
            self.assertEqual(self.reader.GetObjectName(kind, 0).split(" Size")[0].split(" ID")[0], "left/floor")
            self.reader.SetObjectStatus(kind, 0, 1)
        self.reader.SetTimeStep(0)
        self.reader.Update()
        self.assertEqual(self.reader.GetErrorCode(), 0)
        sets = {}
        for i in range(self.reader.GetOutput().GetNumberOfBlocks()):
            group = self.reader.GetOutput().GetBlock(i)
            name = self.reader.GetOutput().GetMetaData(i).Get(vtkCompositeDataSet.NAME())
            if group is not None and group.GetNumberOfBlocks() > 0:
                sets[name] = group.GetBlock(0)
        floor = cube()[: (CELLS + 1) ** 2]
        nodes = vtk_to_numpy(sets["Node Sets"].GetPoints().GetData())
        self.assertEqual({tuple(p) for p in nodes}, {tuple(p) for p in floor})
        faces = sets["Side Sets"]
        self.assertEqual(faces.GetNumberOfCells(), CELLS**2)
        corners = vtk_to_numpy(faces.GetPoints().GetData())
        for cell in range(CELLS**2):
            ids = faces.GetCell(cell).GetPointIds()
            face = np.array([corners[ids.GetId(i)] for i in range(4)])
            np.testing.assert_array_equal(face[:, 2], 0)
            self.assertEqual(np.cross(face[1] - face[0], face[2] - face[1])[2], -1)  # outward

    def test_has_the_tensor_by_its_components(self):
        with h5py.File(PATH, "r") as file:
            names = [b"".join(row).rstrip(b"\0").decode() for row in file["name_elem_var"][:]]
            self.assertEqual(names, ["stress_xx", "stress_yy", "stress_zz", "stress_xy", "stress_yz", "stress_zx",
                                     "von_mises", "flag"])
            np.testing.assert_array_equal(file["elem_var_tab"][:], np.ones((2, 8)))
            for frame in range(FRAMES):
                for component in range(6):
                    found = [file[f"vals_elem_var{component + 1}eb{block}"][frame] for block in (1, 2)]
                    np.testing.assert_array_equal(np.concatenate(found), stress_of(frame)[:, component])


if __name__ == "__main__":
    unittest.main()
