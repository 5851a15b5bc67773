"""Reads the sample run (write_sample_run.cpp) with VTK's reader and through the XDMF index, and compares every number.

usage: read_with_vtk.py FOLDER. Exit code 77 (skipped) if VTK or h5py is not installed.
"""

import os
import sys
import unittest
import xml.etree.ElementTree as xml

try:
    import h5py
    import numpy as np
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOHDF import vtkHDFReader
except ImportError as error:
    print(f"skipped: {error}; scripts/install_dependencies --render installs what this test needs")
    sys.exit(77)

FOLDER = sys.argv.pop()
FRAMES = 3
CELLS = 2


def time_of(frame):
    return 0.1 * frame


def reference_nodes():
    """Positions of the sample at time 0, written down apart from sample_run.hpp."""
    n = CELLS + 1
    z, y, x = np.meshgrid(np.arange(n), np.arange(n), np.arange(n), indexing="ij")
    cube = np.column_stack([x.ravel(), y.ravel(), z.ravel()]).astype(float)
    return np.vstack([cube, cube + [10, 0, 0]])


def expected(frame):
    x = reference_nodes()
    elements = np.arange(2 * CELLS**3)
    t = time_of(frame)
    points = np.column_stack([x[:, 0] + t * x[:, 1], x[:, 1] + t / 3, x[:, 2] - t * t])
    return {
        "points": points,
        "displacement": points - x,
        "velocity": np.column_stack([x[:, 1] + frame, np.full(len(x), 1 / 3), np.full(len(x), -2 * t)]),
        "stress": 100 * frame + elements[:, None] + 0.1 * np.arange(6)[None, :],
        "von_mises": 1e6 * frame + elements / 7,
        "flag": (500 + 3 * elements + frame) % 2,
        "node_id": 1000 - np.arange(len(x)),
        "element_id": 500 + 3 * elements,
        "part": elements // CELLS**3,
    }


class FirstStepInVtk(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        reader = vtkHDFReader()
        reader.SetFileName(os.path.join(FOLDER, "fields.vtkhdf"))
        reader.Update()
        cls.grid = reader.GetOutputDataObject(0)

    def test_has_hexahedra_of_positive_volume(self):
        self.assertEqual(self.grid.GetNumberOfCells(), 2 * CELLS**3)
        for cell in range(self.grid.GetNumberOfCells()):
            self.assertEqual(self.grid.GetCellType(cell), 12)
            ids = self.grid.GetCell(cell).GetPointIds()
            corner = [np.array(self.grid.GetPoint(ids.GetId(i))) for i in (0, 1, 3, 4)]
            volume = np.dot(np.cross(corner[1] - corner[0], corner[2] - corner[0]), corner[3] - corner[0])
            self.assertAlmostEqual(volume, 1.0)

    def test_has_points_and_fields_of_the_first_frame(self):
        wanted = expected(0)
        points = vtk_to_numpy(self.grid.GetPoints().GetData())
        self.assertEqual(points.dtype, np.float64)
        np.testing.assert_array_equal(points, wanted.pop("points"))
        for name, values in wanted.items():
            data = self.grid.GetPointData() if len(values) == len(points) else self.grid.GetCellData()
            np.testing.assert_array_equal(vtk_to_numpy(data.GetArray(name)), values, err_msg=name)


class Xdmf(unittest.TestCase):
    """What the two indexes have in common."""

    def resolve(self, item):
        """The numbers that a DataItem means."""
        if item.get("ItemType") == "HyperSlab":
            choice, source = item.findall("DataItem")
            start, stride, count = np.array(choice.text.split(), dtype=int).reshape(3, -1)
            everything = self.resolve(source)
            part = everything[tuple(slice(a, a + s * n, s) for a, s, n in zip(start, stride, count))]
            self.assertEqual(part.shape, shape_of(item))
            return part
        file, path = item.text.strip().split(":", 1)
        with h5py.File(os.path.join(FOLDER, file), "r") as data:
            values = data[path][...]
        self.assertEqual(values.shape, shape_of(item))
        self.assertEqual(values.dtype.itemsize, int(item.get("Precision")))
        self.assertEqual(values.dtype.kind, {"Float": "f", "Int": "i", "UChar": "u"}[item.get("NumberType")])
        return values


class EveryStepThroughXdmf(Xdmf):
    @classmethod
    def setUpClass(cls):
        cls.domain = xml.parse(os.path.join(FOLDER, "fields.xdmf")).getroot().find("Domain")
        cls.steps = cls.domain.find("Grid").findall("Grid")

    def test_lists_every_time(self):
        times = [float(step.find("Time").get("Value")) for step in self.steps]
        self.assertEqual(times, [time_of(frame) for frame in range(FRAMES)])

    def test_has_every_number_of_every_frame(self):
        for frame, step in enumerate(self.steps):
            wanted = expected(frame)
            np.testing.assert_array_equal(self.resolve(step.find("Geometry/DataItem")), wanted.pop("points"))
            found = {a.get("Name"): a for a in step.findall("Attribute")}
            self.assertEqual(set(found), set(wanted))
            for name, values in wanted.items():
                np.testing.assert_array_equal(self.resolve(found[name].find("DataItem")), values, err_msg=name)
                self.assertEqual(found[name].get("Center"), "Node" if len(values) == 54 else "Cell")

    def test_has_the_cells(self):
        for step in self.steps:
            corners = self.resolve(step.find("Topology/DataItem")).reshape(-1, 8)
            self.assertEqual(len(corners), int(step.find("Topology").get("NumberOfElements")))
            x = reference_nodes()
            np.testing.assert_array_equal(x[corners[:, 6]] - x[corners[:, 0]], np.ones((len(corners), 3)))

    def test_names_title_units_and_parts(self):
        words = {i.get("Name"): i.get("Value") for i in self.domain.findall("Information")}
        self.assertEqual(words["title"], "A sample & its <title>")
        self.assertEqual(words["units"], "m, kg, s")
        self.assertEqual(words["part 1"], 'right <&"> one')


class EveryPartThroughXdmf2(Xdmf):
    @classmethod
    def setUpClass(cls):
        domain = xml.parse(os.path.join(FOLDER, "fields.xdmf2")).getroot().find("Domain")
        cls.scene = domain.find("Grid")
        cls.parts = cls.scene.findall("Grid")

    def test_has_a_block_for_each_part_with_its_name_and_every_time(self):
        self.assertEqual(self.scene.get("CollectionType"), "Spatial")
        self.assertEqual([part.get("Name") for part in self.parts], ["left", 'right <&"> one'])
        for part in self.parts:
            self.assertEqual(part.get("CollectionType"), "Temporal")
            times = [float(step.find("Time").get("Value")) for step in part.findall("Grid")]
            self.assertEqual(times, [time_of(frame) for frame in range(FRAMES)])

    def test_has_every_number_of_the_part_in_every_frame(self):
        units = {"displacement": "m", "velocity": "m/s", "von_mises": "Pa"}
        units.update({f"stress_{axes}": "Pa" for axes in ("xx", "yy", "zz", "xy", "yz", "zx")})
        for number, part in enumerate(self.parts):
            for frame, step in enumerate(part.findall("Grid")):
                wanted = {name: np.split(values, 2)[number] for name, values in expected(frame).items()}
                stress = wanted.pop("stress")
                wanted.update({f"stress_{axes}": stress[:, [c]]
                               for c, axes in enumerate(("xx", "yy", "zz", "xy", "yz", "zx"))})
                points = self.resolve(step.find("Geometry/DataItem"))
                np.testing.assert_array_equal(points, wanted.pop("points"))
                found = {a.get("Name"): a for a in step.findall("Attribute")}
                names = {name: name + (f" [{units[name]}]" if name in units else "") for name in wanted}
                self.assertEqual(set(found), set(names.values()))
                for name, values in wanted.items():
                    np.testing.assert_array_equal(self.resolve(found[names[name]].find("DataItem")), values,
                                                  err_msg=name)

    def test_has_the_cells_by_the_nodes_of_the_part(self):
        for part in self.parts:
            for step in part.findall("Grid"):
                topology = step.find("Topology")
                corners = self.resolve(topology.find("DataItem")).reshape(-1, 8) - int(topology.get("BaseOffset", 0))
                self.assertEqual(len(corners), int(topology.get("NumberOfElements")))
                x = reference_nodes()[: (CELLS + 1) ** 3]
                np.testing.assert_array_equal(x[corners[:, 6]] - x[corners[:, 0]], np.ones((CELLS**3, 3)))


def shape_of(item):
    return tuple(int(word) for word in item.get("Dimensions").split())


if __name__ == "__main__":
    unittest.main()
