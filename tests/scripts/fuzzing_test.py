"""What scripts/fuzz_scenes makes and measures, without the program: fuzzing_test.py.
Exit code 77 without NumPy or h5py."""

import random as randoms
import sys
import unittest

try:
    import h5py  # noqa: F401
    import numpy as np
except ImportError as error:
    print(f"skipped: {error}; scripts/install_dependencies --report installs what this test needs")
    sys.exit(77)

from fuzzing import comparing, drawing, families, geometry, scene, shapes, shrinking  # noqa: E402

CUBE = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], dtype=float)
CELL = np.arange(8)[None, :]


class CornerJacobians(unittest.TestCase):
    def test_those_of_a_unit_cube_are_one(self):
        np.testing.assert_array_equal(geometry.find_corner_jacobians(CUBE, CELL), np.ones((1, 8)))

    def test_a_corner_beyond_the_plane_of_its_neighbours_is_inverted(self):
        for corner in range(8):
            x = CUBE.copy()
            x[corner] += 0.7 * (1 - 2 * CUBE[corner])  # along the diagonal
            jacobians = geometry.find_corner_jacobians(x, CELL)[0]
            self.assertLess(jacobians[corner], 0)
            self.assertEqual((jacobians <= 0).sum(), 1)


class Depth(unittest.TestCase):
    def test_in_a_cube_it_is_the_distance_from_the_nearest_face(self):
        surface = geometry.Surface(CUBE, CELL, 0.0)
        points = np.array([[0.5, 0.5, 0.1], [0.3, 0.5, 0.6], [0.95, 0.9, 0.5], [1.1, 0.5, 0.5], [0.5, 0.5, -1e-9]])
        np.testing.assert_allclose(geometry.find_depths(points, surface, CUBE), [0.1, 0.3, 0.05, 0, 0], atol=1e-12)

    def test_of_a_shell_it_is_what_is_missing_of_half_the_thickness(self):
        x = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], dtype=float)
        surface = geometry.Surface(x, np.arange(4)[None, :], 0.05)
        points = np.array([[0.5, 0.5, 0.03], [0.4, 0.2, -0.04], [0.5, 0.5, 0.06]])
        np.testing.assert_allclose(geometry.find_depths(points, surface, x), [0.02, 0.01, 0], atol=1e-12)
        np.testing.assert_allclose(geometry.find_depths(points, surface, x, 0.02), [0.04, 0.03, 0.01], atol=1e-12)

    def test_an_edge_through_a_shell_is_found(self):
        x = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], dtype=float)
        surface = geometry.Surface(x, np.arange(4)[None, :], 0.05)
        starts = np.array([[0.5, 0.4, 0.3], [0.5, 0.4, 0.3], [2, 0.4, 0.3]])
        ends = np.array([[0.5, 0.4, -0.1], [0.5, 0.4, 0.1], [2, 0.4, -0.1]])
        self.assertEqual(list(geometry.find_crossings(starts, ends, surface, x)), [True, False, False])

    def test_a_cube_has_twelve_sharp_edges_and_one_cut_in_two_no_more_across_the_cut(self):
        self.assertEqual(len(geometry.Surface(CUBE, CELL, 0.0).edges), 12)
        x = np.vstack([CUBE, CUBE[4:] + [0, 0, 1]])
        two = np.array([[0, 1, 2, 3, 4, 5, 6, 7], [4, 5, 6, 7, 8, 9, 10, 11]])
        surface = geometry.Surface(x, two, 0.0)
        self.assertEqual((len(surface.faces), len(surface.edges)), (10, 16))


class Scenes(unittest.TestCase):
    def test_a_seed_always_makes_the_same_scene(self):
        for seed in range(1, 30):
            self.assertEqual(scene.write_deck(scene.make_scene(seed)), scene.write_deck(scene.make_scene(seed)))

    def test_bodies_are_apart_and_of_all_kinds(self):
        kinds = set()
        for seed in range(1, 60):
            parts = scene.make_scene(seed)["parts"]
            hulls = [scene.Hull(*shapes.find_hull(part)).moved(np.array(part["at"])) for part in parts.values()]
            for i, a in enumerate(hulls):
                self.assertTrue(all(a.gap_to(b) > 0 for b in hulls[i + 1 :]), f"seed {seed}")
            kinds |= {shapes.kind_of(part) for part in parts.values()}
        self.assertEqual(kinds, set(shapes.SOLIDS + shapes.SHELLS))


def make_map(**properties):
    return {"type": "object", "properties": properties}


NUMBER = {"type": "number", "minimum": 0, "maximum": 1}
# As percuss schema writes it, with few keys.
SCHEMA = make_map(
    time=make_map(end={"type": "number"}, step_scale={"type": "number"}, step_estimate={"enum": ["element", "global"]}),
    parts={"type": "object",
           "patternProperties": {"x": make_map(points={"type": "integer"}, bulk_viscosity=make_map(linear=NUMBER))}},
    contact=make_map(edges={"type": "boolean"}, restitution=NUMBER,
                     friction={"anyOf": [{"type": "number"}, make_map(default=NUMBER)]},
                     ties={"type": "array", "items": make_map(cohesive=make_map(plateau=NUMBER))}),
    elements=make_map(hourglass={"anyOf": [{"enum": ["viscous"]},
                                           make_map(kind={"enum": ["viscous"]}, coefficient=NUMBER)]}),
    erosion=make_map(free_nodes={"enum": ["keep", "remove"]}), audit=make_map(),
    start=make_map(relaxation=make_map(damping={"type": "number"})))


class Drawing(unittest.TestCase):
    def test_every_key_comes_but_those_that_the_scene_gives(self):
        drawn = {key for seed in range(40) for key in drawing.draw_keys(SCHEMA, "contact", randoms.Random(seed), 0.5)}
        self.assertEqual(drawn, {"edges", "restitution", "friction"})
        self.assertEqual(drawing.draw_keys(SCHEMA, "contact", randoms.Random(1), 0), {})

    def test_numbers_stay_within_their_range(self):
        for seed in range(40):
            drawn = drawing.draw_keys(SCHEMA, "contact.ties.N.cohesive", randoms.Random(seed), 1)
            self.assertTrue(0 < drawn["plateau"] < 1)

    def test_scenes_of_a_seed_are_the_same_and_have_every_family_and_connection(self):
        text = ""
        for seed in range(150):
            deck = scene.write_deck(families.make_scene(seed, SCHEMA)[0])
            self.assertEqual(deck, scene.write_deck(families.make_scene(seed, SCHEMA)[0]))
            text += deck
        for word in (*families.CUTS[2:], "thick_shell", "membrane", "plies", "line", "truss", "rigid: true", "springs",
                     "welds", "cohesive", "constraints", "rigid_sets", "embedded", "joints", "turn_springs",
                     "relaxation", "failure", "from: at", "until: at"):
            self.assertIn(word, text)


class Comparing(unittest.TestCase):
    def test_a_warning_that_is_lost_or_has_another_time_is_told(self):
        early, late = ({"rule": "missed_contact", "text": "a", "time": 1.0},
                       {"rule": "missed_contact", "text": "a", "time": 2.0})
        self.assertEqual(comparing.compare_warnings([early], [early, {"rule": "idle_ranks", "text": "b"}]), [])
        self.assertEqual(len(comparing.compare_warnings([], [early])), 1)
        self.assertEqual(len(comparing.compare_warnings([late], [early])), 2)

    def test_numbers_that_differ_in_the_sign_of_a_zero_differ(self):
        self.assertFalse(comparing._are_same(np.array([0.0]), np.array([-0.0])))
        self.assertTrue(comparing._are_same(np.array([np.nan]), np.array([np.nan])))


class Shrinking(unittest.TestCase):
    def test_what_the_failure_does_not_need_goes(self):
        deck = next(deck for deck in map(scene.make_scene, range(1, 200)) if len(deck["parts"]) > 5 and "walls" in deck)
        wanted = list(deck["parts"])[3]
        small = shrinking.shrink(deck, lambda smaller: wanted in smaller["parts"], most_runs=1000)
        self.assertEqual(list(small["parts"]), [wanted])
        self.assertEqual([entry["part"] for entry in small["initial"]], [wanted])
        self.assertNotIn("walls", small)
        self.assertIn(small["parts"][wanted]["material"], ("hard", "steel"))


if __name__ == "__main__":
    unittest.main()
