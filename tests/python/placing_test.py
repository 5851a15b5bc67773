"""Parts that a deck places, mirrors, repeats, welds and joins, and books of walls and parts: placing_test.py ROOT PERCUSS [MPIEXEC ...].

Each test runs a deck and compares with a value that follows from it. Exit code 77 (skipped) without NumPy.
"""

import json
import math
import os
import re
import subprocess
import tempfile
import unittest

from given import MPIEXEC, PERCUSS, require

require("numpy")

import numpy as np

import percuss  # noqa: E402

STEEL = "materials: {steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}\n"
FLOOR = "walls: [{name: floor, point: [0, 0, 0], normal: z}]\n"
SHORT = "time: {end: 1.0e-9}\n"
EXACT = 1e-12  # difference of lengths near 1: a few roundings


def follow(**ids):
    """Nodes by their ids in the history, every step."""
    nodes = ", ".join(f"{{name: {name}, id: {id}}}" for name, id in ids.items())
    return f"output: {{history: {{every: 0, nodes: [{nodes}]}}}}\n"


class Scenes(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def write(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    def call(self, command, deck, *options, launcher=()):
        return subprocess.run([*launcher, PERCUSS, command, self.write("deck.yaml", deck), *options], capture_output=True, text=True,
                              timeout=300, env=dict(os.environ, OMP_NUM_THREADS="1", OMP_PROC_BIND="false"))

    def check(self, deck):
        done = self.call("check", deck)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout + done.stderr

    def refused(self, deck):
        done = self.call("check", deck)
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        return done.stderr

    def run_deck(self, deck, name="out", launcher=()):
        out = os.path.join(self.folder, name)
        done = self.call("run", deck, "--out", out, "--force", launcher=launcher)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.log = done.stderr
        return out

    def history(self, deck, name="out"):
        return percuss.read(self.run_deck(deck, name)).history

    def start(self, deck, *nodes):
        """Places of followed nodes at time 0."""
        history = self.history(deck)
        return [np.array([history[f"{node}_{axis}"][0] for axis in "xyz"]) for node in nodes]

    @staticmethod
    def hash_of(out):
        with open(os.path.join(out, "summary.json"), encoding="utf-8") as file:
            return json.load(file)["state_hash"]


class Place(Scenes):
    # Nodes of the box count along x first: 3 is its corner at x_max, y_min, z_min, 14 its middle.
    BOX = "parts: {box: {box: {size: [0.1, 0.2, 0.3], cells: [2, 2, 2]}, at: [5, 6, 7], material: steel}}\n" + STEEL + SHORT + FLOOR

    def place(self, lowest, clearance=1e-3):
        return f"place: [{{parts: [box], direction: -z, lowest: {lowest}, rest_on: {{wall: floor, clearance: {clearance}}}}}]\n"

    def test_a_box_on_its_corner_has_its_centre_above_it_and_the_gap(self):
        corner, centre = self.start(self.BOX + self.place("{corner: [1, -1, -1]}") + follow(corner=3, centre=14), "corner", "centre")
        self.assertAlmostEqual(corner[2], 1e-3, delta=EXACT)
        self.assertLess(np.abs(centre - corner)[:2].max(), EXACT)
        self.assertAlmostEqual(centre[2] - corner[2], math.sqrt(0.05**2 + 0.1**2 + 0.15**2), delta=EXACT)

    def test_a_box_on_its_edge_has_the_edge_level(self):
        # The edge along x at y_min, z_min has the nodes 1 and 3.
        first, last, centre = self.start(self.BOX + self.place("{edge: [0, -1, -1]}") + follow(a=1, b=3, centre=14), "a", "b", "centre")
        self.assertAlmostEqual(first[2], 1e-3, delta=EXACT)
        self.assertAlmostEqual(last[2], 1e-3, delta=EXACT)
        self.assertLess(np.abs(centre - (first + last) / 2)[:2].max(), EXACT)
        self.assertAlmostEqual(centre[2] - first[2], math.hypot(0.1, 0.15), delta=EXACT)

    def test_a_named_side_may_be_lowest(self):
        for lowest in ("{face: [0, 1, 0]}", "{face: box/y_max}"):
            with self.subTest(lowest=lowest):
                places = self.start(self.BOX + self.place(lowest, 0.25) + follow(a=7, b=9, c=27, centre=14), "a", "b", "c", "centre")
                for place in places[:3]:
                    self.assertAlmostEqual(place[2], 0.25, delta=EXACT)
                self.assertAlmostEqual(places[3][2], 0.35, delta=EXACT)

    def test_without_an_orientation_parts_only_move_along_gravity(self):
        deck = self.BOX.replace("1.0e-9", "1.0e-5") + "place: [{parts: [box], rest_on: {wall: floor}}]\nloads: {gravity: [0, 0, -9.81]}\n" + follow(a=1)
        place, = self.start(deck, "a")
        self.assertEqual(list(place[:2]), [5, 6])
        self.assertAlmostEqual(place[2], 0, delta=EXACT)

    def test_check_prints_where_the_box_went(self):
        text = self.check(self.BOX + self.place("{face: [0, 1, 0]}", 0.25))
        self.assertRegex(text, r"place: part 'box' turned by 90 degrees about \[-1, 0, 0\].* moved by \[0, 0, -6\.8\]: gap 0\.25 to wall 'floor'")

    def test_the_thickness_of_shells_counts_where_the_wall_sees_it(self):
        plate = "parts: {plate: {shell_plate: {size: [1, 1], cells: [2, 2]}, thickness: 0.02, at: [0, 0, 3], material: steel}}\n"
        for seen, height in (("included", 0.11), ("ignored", 0.1)):
            wall = f"walls: [{{name: floor, normal: z, thickness: {seen}}}]\n"
            deck = plate + STEEL + SHORT + wall + "place: [{parts: [plate], direction: -z, rest_on: {wall: floor, clearance: 0.1}}]\n"
            place, = self.start(deck + follow(a=1), "a")
            self.assertAlmostEqual(place[2], height, delta=EXACT)

    def test_a_round_wall_has_the_clearance_in_the_direction_of_its_normal(self):
        # The corner [-0.5, -0.5] of a plate meets a sphere of radius 1 about the origin where the plate is at 3/4 of its height.
        wall = "walls: [{name: floor, point: [0, 0, 0], sphere: {radius: 1}}]\n"
        plate = "parts: {plate: {shell_plate: {size: [1, 1], cells: [1, 1]}, thickness: 0.02, at: [-0.5, -0.5, 3], material: steel}}\n"
        deck = plate + STEEL + SHORT + wall + "place: [{parts: [plate], direction: -z, rest_on: {wall: floor, clearance: 0.25}}]\n"
        place, = self.start(deck + follow(a=1), "a")
        self.assertAlmostEqual(np.linalg.norm(place), 1.25, delta=EXACT)

    def test_crossing_edges_stop_parts(self):
        # The ridge of a turned block runs along y at x = z = sqrt(1/2), the lowest edge of the box along x: only these edges meet.
        parts = ("parts:\n  box: {box: {size: [0.1, 0.2, 0.3], cells: [2, 2, 2]}, at: [0.66, 0.02, 7], material: steel}\n"
                 "  block: {box: {size: [1, 4, 1], cells: [1, 2, 1]}, at: [0, -2, 0], rotate: [{axis: y, angle: 45}], material: steel}\n")
        deck = parts + STEEL + SHORT + ("place: [{parts: [box], direction: -z, lowest: {edge: [0, -1, -1]}, "
                                        "rest_on: {part: block, clearance: 0.004}}]\n") + follow(a=1, b=3)
        for place in self.start(deck, "a", "b"):
            self.assertAlmostEqual(place[2], math.sqrt(0.5) + 0.004, delta=EXACT)

    def test_shells_rest_on_a_part_by_half_of_both_thicknesses(self):
        parts = ("parts:\n  lid: {shell_plate: {size: [1, 1], cells: [2, 2]}, thickness: 0.02, at: [0, 0, 3], material: steel}\n"
                 "  table: {shell_plate: {size: [4, 4], cells: [3, 3]}, thickness: 0.06, at: [-1, -1, 1], material: steel}\n")
        deck = parts + STEEL + SHORT + "place: [{parts: [lid], direction: -z, rest_on: {part: table, clearance: 0.5}}]\n"
        place, = self.start(deck + follow(a=1), "a")
        self.assertAlmostEqual(place[2], 1 + 0.01 + 0.03 + 0.5, delta=EXACT)

    def test_ranks_give_the_same_bits(self):
        if not MPIEXEC:
            self.skipTest("no MPI")
        mesh = self.write("mesh.inp", "*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n5,0,0,1\n6,1,0,1\n7,1,1,1\n8,0,1,1\n"
                                      "*ELEMENT,TYPE=C3D8R,ELSET=E\n1,1,2,3,4,5,6,7,8\n")
        deck = self.BOX.replace("parts: {box", f"parts: {{cube: {{mesh: {{file: {mesh}}}, at: [0, 0, 30], material: steel}}, box")
        deck = deck.replace("parts: [box]", "parts: [box, cube]") + self.place("{corner: [1, -1, -1]}")
        deck = deck.replace("place: [", "place: [{parts: [cube], direction: [1, 2, -30], rest_on: {wall: floor, clearance: 0.1}}, ")
        self.assertEqual(self.hash_of(self.run_deck(deck, "one")), self.hash_of(self.run_deck(deck, "two", [*MPIEXEC, "2"])))

    def test_wrong_names_get_the_nearest(self):
        self.assertIn("did you mean 'floor'?", self.refused(self.BOX + self.place("{corner: [1, 1, 1]}").replace("wall: floor", "wall: flor")))
        self.assertIn("did you mean 'box'?", self.refused(self.BOX + self.place("{corner: [1, 1, 1]}").replace("[box]", "[bax]")))
        self.assertIn("each -1 or 1", self.refused(self.BOX + self.place("{corner: [1, 0, 1]}")))
        self.assertIn("no direction", self.refused(self.BOX + self.place("{corner: [1, 1, 1]}").replace("direction: -z, ", "")))
        self.assertIn("do not meet wall 'floor'", self.refused(self.BOX + self.place("{corner: [1, 1, 1]}").replace("direction: -z", "direction: z")))


class Images(Scenes):
    # A hexahedron with a shell on a side of it, a tetrahedron, a wedge and a pyramid apart.
    MESH = ("*NODE\n1,1,0,0\n2,2,0,0\n3,2,1,0\n4,1,1,0\n5,1,0,1\n6,2,0,1\n7,2,1,1\n8,1,1,1\n"
            "11,1,0,4\n12,2,0,4\n13,1,1,4\n14,1,0,5\n21,1,0,7\n22,2,0,7\n23,1,1,7\n24,1,0,8\n25,2,0,8\n26,1,1,8\n"
            "31,1,0,10\n32,2,0,10\n33,2,1,10\n34,1,1,10\n35,1.5,0.5,11\n41,1,0,13\n42,2,0,13\n43,2,1,13\n44,1,1,13\n"
            "*ELEMENT,TYPE=C3D8R,ELSET=HEX\n1,1,2,3,4,5,6,7,8\n*ELEMENT,TYPE=C3D4,ELSET=TET\n2,11,12,13,14\n"
            "*ELEMENT,TYPE=C3D6,ELSET=WEDGE\n3,21,22,23,24,25,26\n*ELEMENT,TYPE=C3D5,ELSET=PYRAMID\n4,31,32,33,34,35\n"
            "*ELEMENT,TYPE=S4R,ELSET=SHELL\n5,41,42,43,44\n*NSET,NSET=FOOT\n1,4,11,21,24,31,34,41,44\n*SURFACE,NAME=SIDE\n1,S5\n")

    def parts(self, *blocks):
        mesh = self.write("mesh.inp", self.MESH)
        return "parts:\n" + "".join(
            f"  {block.lower()}: {{mesh: {{file: {mesh}, blocks: [{block}]}}, material: steel{', thickness: 0.1' if block == 'SHELL' else ''}}}\n"
            for block in blocks)

    def test_mirror_images_move_as_mirror_images(self):
        names = ["hex", "tet", "wedge", "pyramid", "shell"]
        feet = "".join(f"  - {{nodes: {name}{suffix}/FOOT, fixed: [x, y, z]}}\n" for name in names for suffix in ("", "_mirror"))
        starts = "".join(f"  - {{part: {name}{suffix}, velocity: [{speed}, 30, 20]}}\n"
                         for name in names[:4] for suffix, speed in (("", 50), ("_mirror", -50)))
        deck = (self.parts(*(name.upper() for name in names)) + STEEL + "time: {end: 1.0e-3}\n"
                f"mirror: [{{parts: [{', '.join(names)}], normal: [1, 0, 0], point: [0.25, 0, 0]}}]\n"
                "loads: {pressure: [{faces: shell/top, value: 1.0e6}, {faces: shell_mirror/top, value: 1.0e6}]}\n"
                f"conditions:\n{feet}initial:\n{starts}output: {{history: {{every: 1.0e-4, motion: all}}}}\n")
        history = self.history(deck)
        for name in names:
            size = max(np.abs(history[f"mean_displacement_{axis}:{name}"]).max() for axis in "xyz")
            self.assertGreater(size, 1e-5)
            for axis in "xyz":
                column = np.array(history[f"mean_displacement_{axis}:{name}"])
                image = np.array(history[f"mean_displacement_{axis}:{name}_mirror"])
                self.assertLess(np.abs(image - (-1 if axis == "x" else 1) * column).max(), 1e-9 * size, f"{name} {axis}")
        # The shell is pushed against its normal, which a mirror across x leaves as it is: up.
        self.assertLess(history["mean_displacement_z:shell"][-1], 0)
        self.assertLess(history["mean_displacement_z:shell_mirror"][-1], 0)

    def test_a_side_set_goes_with_its_part(self):
        # Side 5 of the hexahedron has the nodes 3, 4, 8, 7 (y = 1): pressure there pushes it towards -y, and its image towards +y.
        deck = (self.parts("HEX") + STEEL + "time: {end: 1.0e-3}\nmirror: [{parts: [hex], normal: y, point: [0, 3, 0], suffix: _far}]\n"
                "loads: {pressure: [{faces: hex_far/SIDE, value: 1.0e6}]}\noutput: {history: {every: 0, motion: [hex_far]}}\n")
        history = self.history(deck)
        side = np.array(history["mean_velocity_y:hex_far"])
        # A force of 1e6 on a mass of 7850.
        step = np.array(history["dt"])[-1]
        self.assertAlmostEqual(side[-1], 1e6 / 7850 * (history["time"][-1] - step / 2), delta=1e-3 * abs(side[-1]))

    def test_patterns_stand_where_they_must(self):
        box = "parts: {bolt: {box: {size: [0.1, 0.1, 0.1], cells: [1, 1, 1]}, at: [1, 0, 0], material: steel}}\n" + STEEL + SHORT
        nodes = "output: {history: {every: 0, nodes: [{name: n, near: [9, 9, 9], part: %s}]}}\n"
        deck = box + "pattern: [{parts: [bolt], circular: {count: 4, axis: z}}]\n"
        # The node of bolt_2 that is nearest to x = y = 9 is the image of (1.1, 0, 0.1): (0, 1.1, 0.1).
        place, = self.start(deck + nodes % "bolt_2", "n")
        self.assertEqual([round(x, 14) for x in place], [0, 1.1, 0.1])
        deck = box + "pattern: [{parts: [bolt], linear: {count: 3, step: [0, 0.5, 0.25]}}]\n"
        place, = self.start(deck + nodes % "bolt_3", "n")
        self.assertLess(np.abs(place - [1.1, 1.1, 0.6]).max(), EXACT)
        self.assertIn("did you mean 'bolt'?", self.refused(deck.replace("[bolt]", "[bold]")))
        twice = deck.replace("pattern: [", "pattern: [{parts: [bolt], linear: {count: 2, step: [1, 0, 0]}}, ")
        self.assertIn("has one already", self.refused(twice))

    def test_copies_of_parts_of_one_mesh_share_its_nodes(self):
        mesh = self.write("two.inp", "*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n5,0,0,1\n6,1,0,1\n7,1,1,1\n8,0,1,1\n"
                                     "9,2,0,0\n10,2,1,0\n11,2,0,1\n12,2,1,1\n*ELEMENT,TYPE=C3D8R,ELSET=A\n1,1,2,3,4,5,6,7,8\n"
                                     "*ELEMENT,TYPE=C3D8R,ELSET=B\n2,2,9,10,3,6,11,12,7\n")
        deck = (f"parts: {{a: {{mesh: {{file: {mesh}, blocks: [A]}}, material: steel}}, b: {{mesh: {{file: {mesh}, blocks: [B]}}, material: steel}}}}\n"
                + STEEL + SHORT + "mirror: [{parts: [a, b], normal: z, point: [0, 0, -1]}]\n")
        text = self.check(deck)
        self.assertIn("'a' and 'b' share 4 nodes", text)
        self.assertIn("'a_mirror' and 'b_mirror' share 4 nodes", text)


class Joins(Scenes):
    PARTS = ("parts:\n  a: {box: {size: [1, 1, 1], cells: [2, 2, 2]}, material: steel}\n"
             "  b: {box: {size: [1, 1, 1], cells: [2, 2, 2]}, at: [0, 0, 1.0001], material: steel}\n") + STEEL + SHORT

    def test_what_is_joined_is_told(self):
        deck = self.PARTS + "join: [{parts: [a, b], tolerance: 1.0e-3}]\n"
        self.assertRegex(self.check(deck), r"'a' and 'b' share 9 nodes \(merged from up to 0\.0001 apart\)")
        self.run_deck(deck)
        self.assertRegex(self.log, r"'a' and 'b' share 9 nodes \(merged from up to 0\.0001 apart\)")

    def test_sides_limit_what_is_joined(self):
        deck = self.PARTS + "join: [{parts: [a, b], tolerance: 1.0e-3, sides: [a/x_min]}]\n"
        self.assertIn("'a' and 'b' share 3 nodes", self.check(deck))
        self.assertIn("did you mean", self.refused(deck.replace("a/x_min", "a/x_mni")))
        self.assertIn("which join.0.parts does not name", self.refused(deck.replace("a/x_min", "c/x_min")))


class Welds(Scenes):
    PLATES = ("parts:\n  low: {shell_plate: {size: [0.5, 0.1], cells: [25, 5]}, thickness: 0.001, material: steel}\n"
              "  high: {shell_plate: {size: [0.5, 0.1], cells: [23, 6]}, at: [0, 0, 0.002], thickness: 0.001, material: steel}\n"
              + STEEL + "time: {end: 2.0e-5}\ninitial: [{part: high, velocity: [0, 0, 10]}]\n")

    def weld(self, keys):
        return self.PLATES + f"welds: {{spots: {{between: [low, high], {keys}}}}}\n"

    def test_a_row_and_a_table_are_the_places_one_by_one(self):
        # A length of 0.4 at a pitch of 0.15 at most: three spaces.
        at = ", ".join(f"[{(0.05 * (3 - i) + 0.45 * i) / 3!r}, {(0.05 * (3 - i) + 0.05 * i) / 3!r}, {(0.001 * (3 - i) + 0.001 * i) / 3!r}]"
                       for i in range(4))
        listed = self.hash_of(self.run_deck(self.weld(f"at: [{at}], radius: 0.005"), "listed"))
        row = self.weld("from: [0.05, 0.05, 0.001], to: [0.45, 0.05, 0.001], pitch: 0.15, radius: 0.005")
        self.assertEqual(self.hash_of(self.run_deck(row, "row")), listed)
        self.assertIn("weld 'spots': 4 of them", self.check(row))
        lines = "\n".join(line.strip(" []") + ", 0.01" for line in at.split("], "))
        table = self.write("spots.csv", "\ufeffx, y, z, diameter\n# spots\n\n" + lines + "\n")
        self.assertEqual(self.hash_of(self.run_deck(self.weld(f"file: {table}"), "table")), listed)

    XMCF = """<?xml version="1.0" encoding="UTF-8"?>
<!-- a <connection_0d> in a remark -->
<xmcf xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance">
  <version>3.0.0</version> <date>2020-01-01</date> <units length="%s" mass="kg"/>
  <appdata><tool><connection_group/><loc>7 7 7</loc></tool></appdata>
  <connection_group id="1">
    <connected_to><part index="1" label="PART_1" pname="low" pid="11"/><part index="2" label="high"/></connected_to>
    <connection_list>
      <connection_0d label="a"><spotweld diameter="%s"/><loc> %s </loc><appdata><loc>9 9 9</loc></appdata></connection_0d>
      <connection_0d><loc>%s</loc><spotweld/></connection_0d>
      <connection_0d><rivet shaft_diameter="4"/><loc>0 0 0</loc></connection_0d>
      <connection_1d><loc_list><loc v="1">0 0 0</loc></loc_list><seamweld/></connection_1d>
    </connection_list>
  </connection_group>
  <connection_group id="2">
    <connected_to><assy index="1"><part pid="11"/><part label="roof"/></assy></connected_to>
    <connection_list><connection_0d><spotweld/><loc>8 8 8</loc></connection_0d></connection_list>
  </connection_group>
</xmcf>
"""

    def in_metres(self, keys):
        return "units: m, kg, s\n" + self.weld(keys)

    def test_a_master_connection_file_has_the_places_of_its_parts(self):
        listed = self.hash_of(self.run_deck(self.weld("at: [[0.0625, 0.05, 0.001], [0.25, 0.05, 0.001]], radius: 0.005"), "two"))
        metres = self.write("body.xmcf", self.XMCF % ("m", "0.01", "0.0625 0.05 0.001", "0.25\n 0.05 1e-3"))
        self.assertEqual(self.hash_of(self.run_deck(self.in_metres(f"file: {metres}, radius: 0.005"), "metres")), listed)
        text = self.check(self.in_metres(f"file: {metres}, radius: 0.005"))
        self.assertIn("weld 'spots': 2 of them", text)
        self.assertIn("1 of kind rivet, 1 of kind seamweld", text)
        millimetres = self.write("body.xml", self.XMCF % ("mm", "10", "62.5 50 1", "250 50 1"))
        self.assertEqual(self.hash_of(self.run_deck(self.in_metres(f"file: {millimetres}, radius: 0.005"), "millimetres")), listed)
        self.assertIn("has no radius for line 10 of", self.refused(self.in_metres(f"file: {millimetres}")))
        self.assertIn("give units", self.refused(self.weld(f"file: {metres}, radius: 0.005")))

    def test_master_connection_files_are_hostile_until_checked(self):
        good = self.XMCF % ("m", "0.01", "0.0625 0.05 0.001", "0.25 0.05 0.001")
        for old, new, told in (("</xmcf>", "", "ends within <xmcf>"), ("<xmcf ", "<mcf ", "the file begins with <mcf>"), ('"m"', '"cubit"', "'cubit' of length"),
                               ("0.0625 0.05 0.001", "0.0625 0.05", "three numbers"), ("0.0625 0.05 0.001", "0.0625 0.05 0.001 1", "three numbers"),
                               ("0.0625 0.05 0.001", "0.0625 0.05 nan", ":9: error: <loc>"), ('"0.01"', '"-1"', ":9: error: diameter"),
                               ("<loc>0.25 0.05 0.001</loc>", "", ":10: error: a spot weld has no <loc>"),
                               ('"low"', '"lower"', "no group of"), ('"low"', '"lower"', "did you mean 'lower'"),
                               ("<spotweld", "<screw", "no spot weld between 'low' and 'high'"), ("<!--", "<![CDATA[", "is not read")):
            with self.subTest(new=new):
                self.assertIn(told, self.refused(self.in_metres(f"file: {self.write('bad.xmcf', good.replace(old, new))}, radius: 0.005")))
        for other in ("<VTKFile/>", "<", "<>", "<xmcf/>", "<xmcf><connection_group/></xmcf>", "<?xml?>"):
            with self.subTest(other=other):
                self.refused(self.in_metres(f"file: {self.write('bad.xmcf', other)}, radius: 0.005"))

    def test_a_row_that_leaves_a_plate_is_refused_with_its_place(self):
        text = self.refused(self.weld("from: [0.05, 0.05, 0.001], to: [0.85, 0.05, 0.001], pitch: 0.4, radius: 0.005"))
        self.assertIn("at [0.85, 0.05, 0.001]", text)

    def test_tables_are_hostile_until_checked(self):
        for content, told in (("1,2\n", "the row has 2 values"), ("1,2,x\n", "value 3 of the row must be"), ("", "there are no welds"),
                              ("x,y,z\n1,2,nan\n", ":2: error: value 3"), ("0.1,0.05,0.001,-1\n", "diameter is not positive"),
                              ("0.1,0.05,0.001\n", "has no radius for line 1"), ("0.9,0.05,0.001,0.01\n", "[0.9, 0.05, 0.001], line 1 of")):
            with self.subTest(content=content):
                self.assertIn(told, self.refused(self.weld(f"file: {self.write('bad.csv', content)}")))

    def test_usual_mistakes_are_told(self):
        self.assertIn("pitch is missing", self.refused(self.weld("from: [0, 0, 0], to: [1, 0, 0], radius: 0.005")))
        self.assertIn("in several ways", self.refused(self.weld("from: [0, 0, 0], to: [1, 0, 0], pitch: 1, at: [0, 0, 0], radius: 0.005")))
        self.assertIn("would have", self.refused(self.weld("from: [0, 0, 0], to: [1, 0, 0], pitch: 1.0e-9, radius: 0.005")))
        self.assertIn("radius is missing", self.refused(self.weld("from: [0, 0, 0], to: [1, 0, 0], pitch: 0.5")))


class Books(Scenes):
    WALL = ("parts: {box: {box: {size: [0.1, 0.1, 0.1], cells: [2, 2, 2]}, at: [0, 0, -0.101], material: steel}}\n" + STEEL +
            "time: {end: 3.0e-4}\nwalls: [{name: ram, point: [0, 0, 0.001], normal: -z, mass: 20, start_speed: 30}]\n"
            "output: {history: {every: 0, parts: all, forces: [{name: ram, wall: ram}]}}\n")

    def test_the_energy_of_a_wall_with_a_mass_is_kinetic(self):
        out = self.run_deck(self.WALL)
        history = percuss.read(out).history
        speed, kinetic = np.array(history["wall_speed:ram"]), np.array(history["kinetic"])
        self.assertAlmostEqual(kinetic[0], 0.5 * 20 * 30**2, delta=1e-9 * 9000)
        self.assertLess(speed[-1], 25)
        parts = np.array(history["kinetic:box"])
        self.assertLess(np.abs(kinetic - parts - 0.5 * 20 * speed**2).max(), 1e-9 * 9000)
        self.assertEqual(np.abs(np.array(history["external"])).max(), 0)
        self.assertLess(np.abs(np.array(history["energy_error"])).max(), 1e-3)

    def test_info_prints_the_impulse_of_the_wall(self):
        out = self.run_deck(self.WALL)
        speed = np.array(percuss.read(out).history["wall_speed:ram"])
        done = subprocess.run([PERCUSS, "info", out, "--forces"], capture_output=True, text=True, timeout=120)
        self.assertEqual(done.returncode, 0, done.stderr)
        row = next(line for line in done.stdout.splitlines() if re.match(r"\s*ram\b", line))
        impulse = 20 * (30 - speed[-1])
        numbers = [float(word) for word in re.findall(r"[-+]?\d+\.?\d*(?:e[-+]?\d+)?", row)]
        self.assertTrue(any(abs(abs(number) / impulse - 1) < 1e-3 for number in numbers), f"{impulse} in {row}")

    def test_mean_motion_in_free_fall_is_that_of_every_node(self):
        deck = ("parts: {box: {box: {size: [0.1, 0.2, 0.3], cells: [2, 3, 4]}, material: steel},\n"
                "  lump: {sphere: {radius: 0.1, cells: 4}, at: [1, 0, 0], material: steel, rigid: true}}\n" + STEEL +
                "time: {end: 2.0e-4}\nloads: {gravity: [1, -2, -9.81]}\ninitial: [{nodes: all, velocity: [3, 0, 1]}]\n"
                "output: {history: {every: 0, motion: all, nodes: [{name: n, id: 1}]}}\n")
        history = self.history(deck)
        time, step = np.array(history["time"]), np.array(history["dt"])
        for axis, speed, g in (("x", 3, 1), ("y", 0, -2), ("z", 1, -9.81)):
            node = np.array(history[f"n_{axis}"])
            for part in ("box", "lump"):
                way = np.array(history[f"mean_displacement_{axis}:{part}"])
                self.assertLess(np.abs(way - (node - node[0])).max(), 1e-12)
                self.assertLess(np.abs(way - (speed * time + g * time**2 / 2)).max(), 1e-12)
                velocity = np.array(history[f"mean_velocity_{axis}:{part}"])
                self.assertLess(np.abs(velocity[1:] - (speed + g * (time - step / 2))[1:]).max(), 1e-12)
        self.assertIn("did you mean 'box'?", self.refused(deck.replace("motion: all", "motion: [bux]")))


if __name__ == "__main__":
    unittest.main()
