"""Ranges, units and the side of a cut, as percuss render finds them.

Exit code 77 (skipped) if NumPy is not installed.
"""

import sys
import unittest

try:
    import numpy as np
except ImportError as error:
    print(f"skipped: {error}; scripts/install_dependencies --render installs what this test needs")
    sys.exit(77)

from percuss.results.units import choose_unit, format_time  # noqa: E402
from percuss.render.largest import find_largest  # noqa: E402
from percuss.render.plates import mirror_walls, span_round_wall, span_wall  # noqa: E402
from percuss.render.ranges import choose_bar, find_ends, find_typical_ends  # noqa: E402
from percuss.render.selection import Cut, faces_camera  # noqa: E402
from percuss.render.skin import Skin  # noqa: E402


class Wall(unittest.TestCase):
    points = np.array([[0.0, 0, 0], [1, 2, 3]])
    up = np.array([0.0, 0, 1])

    def test_without_an_end_lies_under_all_points(self):
        plate = span_wall(np.array([5.0, 5, -1]), self.up, None, self.points)
        self.assertTrue((plate.min(axis=0)[:2] < 0).all() and (plate.max(axis=0)[:2] > [1, 2]).all())
        np.testing.assert_allclose(plate[:, 2], -1, atol=0.01)

    def test_that_ends_is_its_rectangle(self):
        edges = np.array([[2.0, 0, 0], [0, 3, 0]])
        plate = span_wall(np.array([5.0, 5, -1]), self.up, edges, self.points)
        np.testing.assert_array_equal(plate[:, :2], [[5, 5], [7, 5], [7, 8], [5, 8]])
        np.testing.assert_allclose(plate[:, 2], -1, atol=0.01)

    def mirror(self, plates, plane, *planes):
        return [image for image, _ in mirror_walls([(plates, plane)], planes) if image is not None]

    def test_has_an_image_in_each_mirrored_copy(self):
        normal = np.array([-0.8, 0, 0.6])
        plate = span_wall(np.array([1.0, 0, 0]), normal, None, np.array([[-1.0, -2, 0], [1, 2, 3]]))[np.newaxis]
        walls = mirror_walls([(plate, (np.array([1.0, 0, 0]), normal))], [(0, 0.0), (1, 0.0)])
        # it is its own image across y
        self.assertEqual([image is None for image, _ in walls], [False, False, True, True])
        image, (point, turned) = walls[1]
        np.testing.assert_allclose(turned, [0.8, 0, 0.6])
        np.testing.assert_allclose(point, [-1, 0, 0])
        np.testing.assert_allclose((image - point) @ turned, (plate - [1, 0, 0]) @ normal, atol=1e-12)

    def test_has_no_image_where_it_stands(self):
        floor = span_wall(np.array([0.0, 0, 0]), self.up, None, np.array([[-1.0, -2, 0], [1, 2, 3]]))[np.newaxis]
        self.assertEqual(len(self.mirror(floor, (np.zeros(3), self.up), (0, 0.0), (1, 0.0))), 1)
        ball = span_round_wall(np.array([0.0, 3, 0]), None, 1.0, None, self.points)
        self.assertEqual(len(self.mirror(ball, None, (0, 0.0))), 1)
        images = self.mirror(ball, None, (1, 0.5))
        np.testing.assert_allclose(images[1].reshape(-1, 3).mean(axis=0), [0, -2, 0], atol=0.05)
        edges = np.array([[2.0, 0, 0], [0, 3, 0]])
        plate = span_wall(np.array([5.0, 5, -1]), self.up, edges, self.points)[np.newaxis]
        images = self.mirror(plate, (np.array([5.0, 5, -1]), self.up), (0, 5.0))
        np.testing.assert_allclose(sorted(images[1][0, :, 0]), [3, 3, 5, 5])


class Largest(unittest.TestCase):
    def test_is_none_of_a_field_of_zeros(self):
        class Fields:
            hexahedra = np.array([[0, 1, 2, 3, 4, 5, 6, 7]])

            def __init__(self, *values):
                self.all = np.array(values)

            def names(self):
                return {"f": "element" if len(self.all) == 1 else "node"}

            def values(self, name, frame):
                return self.all

        drawn = np.array([True])
        self.assertEqual(find_largest(Fields(*[0.0] * 8), "f", 0, drawn), (None, 0.0))
        self.assertEqual(find_largest(Fields(*[-1.0] * 7, np.nan), "f", 0, drawn), (0, -1.0))
        self.assertEqual(find_largest(Fields(np.nan), "f", 0, drawn), (None, 0.0))


class Bar(unittest.TestCase):
    def check(self, ends, bar):
        low, high, labels = choose_bar(ends)
        self.assertAlmostEqual(low, bar[0])
        self.assertAlmostEqual(high, bar[1])
        self.assertEqual(labels, bar[2])

    def test_ends_at_round_numbers_just_around_the_data(self):
        self.check((0, 0.031), (0, 0.035, 8))
        self.check((0, 0.03), (0, 0.03, 7))
        self.check((0, 1.02), (0, 1.2, 7))
        self.check((0, 200), (0, 200, 5))
        self.check((7850, 7950), (7850, 7950, 5))

    def test_follows_what_one_element_in_a_thousand_has(self):
        strain = np.zeros(2000)
        strain[:2] = 0.02, 0.03
        self.check(find_ends([np.zeros(2000), strain]), (0, 0.03, 7))

    def test_begins_at_zero_where_that_is_near_and_is_centred_between_signs(self):
        self.check((10, 100), (0, 100, 5))
        self.check((-100, -10), (-100, 0, 5))
        self.check((-60, 100), (-100, 100, 5))
        self.check((-1, 100), (-20, 100, 7))

    def test_of_one_number_and_its_round_off_has_zero_at_the_other_end(self):
        self.check((200, 200 + 1e-10), (0, 200, 5))
        self.check((-3, -3), (-3, 0, 7))

    def test_of_zeros_or_nothing_goes_to_one(self):
        self.check((0, 0), (0, 1, 5))
        self.check(None, (0, 1, 5))

    def test_covers_any_data_with_four_to_seven_steps(self):
        random = np.random.default_rng(1)
        for low, high in np.sort(random.normal(size=(300, 2)) * 10.0 ** random.integers(-30, 30, size=(300, 1))):
            first, last, labels = choose_bar((low, high))
            slack = 1e-8 * (last - first)
            self.assertTrue(first <= low + slack and high - slack <= last, (low, high))
            self.assertTrue(5 <= labels <= 8, (low, high))

    def test_data_are_those_of_all_frames_without_what_is_not_finite(self):
        self.assertEqual(find_ends([np.array([0, np.nan, 2]), np.array([-np.inf, 1, 3])]), (0, 3))
        self.assertIsNone(find_ends([np.array([np.nan])]))
        self.assertIsNone(find_ends([]))

    def test_one_peak_does_not_leave_the_rest_pale(self):
        body = np.linspace(0, 1, 2001)
        low, high = find_typical_ends([body, np.append(body, 50.0)])
        self.assertEqual(low, 0)
        self.assertAlmostEqual(high, 1, delta=0.02)
        self.assertEqual(find_typical_ends([np.append(body, 1.2)]), (0, 1.2))  # not far above
        # few that are more than small
        self.assertEqual(find_typical_ends([np.append(np.zeros(2000), [1.0, 2.0])]), (0, 2))
        self.assertEqual(find_typical_ends([body], 100), (0, 1))
        self.assertAlmostEqual(find_typical_ends([body, body / 2], 90)[1], 0.9)
        self.assertEqual(find_typical_ends([-body]), (-1, 0))
        self.assertIsNone(find_typical_ends([np.array([np.nan])]))


class Units(unittest.TestCase):
    def test_take_a_prefix_that_suits_the_numbers(self):
        self.assertEqual(choose_unit("Pa", 3e8), ("MPa", 1e-6))
        self.assertEqual(choose_unit("N", 2e3), ("kN", 1e-3))
        self.assertEqual(choose_unit("mJ", 1e7), ("kJ", 1e-6))
        self.assertEqual(choose_unit("mJ", 20), ("mJ", 1))
        self.assertEqual(choose_unit("Pa", 0), ("Pa", 1))

    def test_stay_where_they_are_those_of_the_system(self):
        self.assertEqual(choose_unit("GPa", 0.25), ("GPa", 1))
        self.assertEqual(choose_unit("mm/ms", 5000), ("mm/ms", 1))
        self.assertEqual(choose_unit("", 5000), ("", 1))

    def test_of_time_are_shown_where_one_is_named(self):
        self.assertEqual(format_time(0.002, 0.005, "s"), "t = 2.00 ms")
        self.assertEqual(format_time(2, 5, "ms"), "t = 2 ms")
        self.assertEqual(format_time(0.05, 1, ""), "t = 0.05")
        self.assertEqual(format_time(0, 0, "s"), "t = 0.00 s")


class Box:
    """A mesh of cells of 0.5 x 1 x 1 from the origin, 2 x 3 x 2 of them,
    and a shell across it at y = 4, as Fields has it."""

    def __init__(self):
        z, y, x = np.meshgrid(np.arange(3), np.arange(4), np.arange(3), indexing="ij")
        nodes = np.column_stack([0.5 * x.ravel(), y.ravel(), z.ravel()])
        first = np.array([i + 3 * j + 12 * k for k in range(2) for j in range(3) for i in range(2)])
        self.hexahedra = first[:, None] + [0, 1, 4, 3, 12, 13, 16, 15]
        shell = len(nodes) + np.array([[0, 1, 2, 3] * 2])
        self.nodes = np.vstack([nodes, [[0, 4, 0], [1, 4, 0], [1, 4, 1], [0, 4, 1]]])
        self.hexahedra = np.vstack([self.hexahedra, shell])
        self.elements = len(self.hexahedra)

    def positions(self, frame):
        return self.nodes


def polygons(skin, points):
    return [points[skin.corners[a:b]] for a, b in zip(skin.offsets, skin.offsets[1:])]


def area_vectors(faces):
    return np.array([sum(np.cross(f[i] - f[0], f[i + 1] - f[0]) for i in range(1, len(f) - 1)) / 2 for f in faces])


class SkinOfACutMesh(unittest.TestCase):
    def skin(self, clip, solids=True, shells=False):
        self.box = Box()
        drawn = np.full(self.box.elements, solids)
        drawn[-1] = shells
        cut = Cut(self.box, clip, (0, 0)) if clip else None
        return Skin(self.box.hexahedra, drawn & cut.keeps if cut else drawn, cut)

    def volume(self, skin, points):
        faces = polygons(skin, points)
        return sum(area @ face[0] for area, face in zip(area_vectors(faces), faces)) / 3

    def test_is_closed_outward_and_holds_the_volume_that_stays(self):
        for clip, volume in ((None, 6), (("+", 0, 0.3), 1.8), (("-", 0, 0.3), 4.2), (("+", 1, 1.0), 2),
                             (("-", 1, 1.0), 4),
                             (("+", 2, 1.9), 5.7), (("-", 2, 2.0), 0)):
            skin = self.skin(clip)
            points = skin.at_points(self.box.nodes)
            np.testing.assert_allclose(area_vectors(polygons(skin, points)).reshape(-1, 3).sum(axis=0), 0, atol=1e-12)
            self.assertAlmostEqual(self.volume(skin, points), volume, msg=str(clip))

    def test_stays_in_the_material_as_it_deforms(self):
        skin = self.skin(("+", 0, 0.3))
        turned = self.box.nodes @ np.array([[0, 1, 0.5], [-2, 0, 0], [0, 0, 1]])  # determinant 2
        self.assertAlmostEqual(self.volume(skin, skin.at_points(turned)), 2 * 1.8)

    def test_has_a_section_for_each_element_that_is_cut(self):
        skin = self.skin(("+", 0, 0.3))
        faces = polygons(skin, skin.at_points(self.box.nodes))
        sections = [owner for owner, face in zip(skin.owners, faces) if np.allclose(face[:, 0], 0.3)]
        self.assertEqual(sorted(sections), [0, 2, 4, 6, 8, 10])

    def test_of_shells_ends_at_the_plane(self):
        skin = self.skin(("+", 0, 0.3), solids=False, shells=True)
        areas = area_vectors(polygons(skin, skin.at_points(self.box.nodes)))
        self.assertAlmostEqual(np.linalg.norm(areas, axis=1).sum(), 0.3)

    def test_takes_numbers_of_nodes_from_the_nearer_end(self):
        skin = self.skin(("+", 0, 0.3))
        highest = skin.highest_of_corners(np.where(self.box.nodes[:, 0] > 0.4, 7, 1))
        faces = polygons(skin, skin.at_points(self.box.nodes))
        for value, face in zip(highest, faces):  # 0.3 is nearer to 0.5 than to 0
            self.assertEqual(value, 7 if face[:, 0].max() > 0.2 else 1)


class SideOfACut(unittest.TestCase):
    def test_is_that_of_the_camera(self):
        self.assertTrue(faces_camera(0, (0, 0)))
        self.assertFalse(faces_camera(0, (180, 0)))
        self.assertFalse(faces_camera(1, (-90, 10)))
        self.assertTrue(faces_camera(1, (75, 5)))
        self.assertTrue(faces_camera(2, (30, 20)))
        self.assertFalse(faces_camera(2, (30, -20)))

    def test_is_above_where_the_camera_looks_along_it(self):
        self.assertTrue(faces_camera(0, (-90, 10)))
        self.assertTrue(faces_camera(0, (90, 10)))
        self.assertTrue(faces_camera(2, (30, 0)))


if __name__ == "__main__":
    unittest.main()
