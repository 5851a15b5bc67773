"""percuss view: view_test.py ROOT PERCUSS. Exit code 77 (skipped) without NumPy, h5py, Matplotlib or three.js. Pictures are compared in
Chromium and Firefox, each where it is; Firefox needs xvfb-run for WebGL."""

import base64
import json
import os
import re
import sys
import tempfile
import unittest
from collections import Counter

from given import require

require("h5py", "matplotlib", "numpy", "PIL")

import numpy as np

from browsers import CHROMIUM, FIREFOX, XVFB, Chromium, Firefox  # noqa: E402
from page_tools import PERCUSS, read_surface  # noqa: E402
import percuss  # noqa: E402
import sample_run  # noqa: E402
from tool_command import call_tool  # noqa: E402
from percuss.render.selection import BadChoice, check_field  # noqa: E402
from percuss.view.coarse import merge_nodes  # noqa: E402
from percuss.view.reduce import FEWEST_FRAMES, pack_view  # noqa: E402
from percuss.view.surface import read_library  # noqa: E402

if read_library() is None:
    print("skipped: three.js is not here; scripts/install_dependencies --report installs it")
    sys.exit(77)

# Half of the scene of sample_run, whose other half is behind a plane of symmetry at x = 0.
HALF = ["parts.block.at=[0, 0, 0.0012]", "parts.plate.at=[0, -0.02, 0]", "parts.plate.shell_plate.size=[0.04, 0.06]",
        "parts.block.box.cells=[4, 4, 4]", "conditions=[{nodes: block/x_min, symmetry: x}, {nodes: plate/x_min, symmetry: x}]"]
SAME = 3.0  # mean difference of two pictures, of 255, that differ by the rasterizer only


def find_rows(ids, wanted):
    order = np.argsort(ids)
    rows = order[np.searchsorted(ids, wanted, sorter=order)]
    np.testing.assert_array_equal(ids[rows], wanted)
    return rows


class OfARun(unittest.TestCase):
    options: list = []

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        cls.addClassCleanup(cls.folder.cleanup)
        words = [word for option in cls.options for word in ("--set", option)]
        cls.out = sample_run.run(PERCUSS, cls.folder.name, *words)
        cls.run_ = percuss.read(cls.out)

    @classmethod
    def make(cls, *words, code=0):
        done = call_tool("view", cls.out, *words)
        assert done.returncode == code, done.stdout + done.stderr
        return done.stdout + done.stderr

    @classmethod
    def read(cls):
        with open(os.path.join(cls.out, "view.html"), encoding="utf-8") as file:
            text = file.read()
        about = json.loads(re.search(r"id=surface-about>(.*?)</script>", text, re.DOTALL)[1])
        return text, about, read_surface(about, re.search(r"id=surface-data>(.*?)</script>", text, re.DOTALL)[1])


class Page(OfARun):
    def test_holds_each_field_of_each_frame(self):
        self.make("--field", "von_mises,velocity")
        text, about, data = self.read()
        self.assertNotRegex(text, r"(src|href)=['\"]https?:")
        self.assertEqual([field["place"] for field in about["fields"]], ["element", "node"])
        fields = self.run_.fields
        self.assertEqual(about["frames"], len(fields.times))
        nodes = find_rows(fields.node_ids, data["node_ids"])
        speed = about["fields"][1]
        for frame in range(about["frames"]):  # to one 254th of the bar
            wanted = np.clip(fields.values("velocity", frame)[nodes], speed["low"], speed["high"])
            read = speed["low"] + (speed["high"] - speed["low"]) * data["fields"][1][frame] / 254
            np.testing.assert_allclose(read, wanted, atol=0.51 * (speed["high"] - speed["low"]) / 254)

    def test_tells_the_largest_value_of_each_frame_and_its_place(self):
        self.make("--field", "von_mises")
        _, about, _ = self.read()
        fields = self.run_.fields
        for frame, told in enumerate(about["fields"][0]["largest"]):
            values = fields.values("von_mises", frame)
            if not values.any():
                self.assertIsNone(told)
                continue
            self.assertAlmostEqual(float(told["value"]) * 1e6 / values.max(), 1, delta=1e-3)
            element = int(told["of"].split()[1])
            self.assertEqual(values[fields.element_ids == element], values.max())
            corners = np.unique(fields.hexahedra[fields.element_ids == element])
            np.testing.assert_allclose(told["now"], fields.positions(frame)[corners].mean(axis=0), atol=1e-7)

    def test_arrows_are_the_vectors(self):
        self.make()
        _, about, data = self.read()
        number = next(i for i, one in enumerate(about["arrows"]) if one["name"] == "velocity")
        (nodes, vectors), described = data["arrows"][number], about["arrows"][number]
        rows = find_rows(self.run_.fields.node_ids, data["node_ids"][nodes])
        for frame in range(about["frames"]):
            wanted = self.run_.fields.data("velocity", frame)[rows]
            np.testing.assert_allclose(vectors[frame] / 32767 * described["longest"], wanted, atol=1e-4 * described["longest"])

    def test_wrong_words_have_the_nearest_name(self):
        self.assertIn("did you mean velocity?", self.make("--field", "velocty", code=2))
        self.assertIn("did you mean plate?", self.make("--part", "plat", code=2))
        self.assertIn("it has block, plate", self.make("--part", "rim", code=2))
        self.assertIn("did you mean equivalent_plastic_strain?", self.make("--field", "plastic", code=2))
        with self.assertRaisesRegex(BadChoice, "did you mean von_mises"):
            check_field(self.run_.fields, "vonmises")
        with open(os.path.join(self.out, "mine.html"), "w", encoding="utf-8") as file:
            file.write("mine")
        self.assertIn("--force", self.make("--out", os.path.join(self.out, "mine.html"), code=2))


class Walls(OfARun):
    """A floor of the scene, a plane that rises with 20 m/s from below it, and a sphere."""

    options = ["walls=[{point: [0, 0, -0.002], normal: z}, {point: [0, 0, -0.02], normal: z, speed: 20}, {sphere: {radius: 0.01}, point: [0.02, 0, -0.05]}]"]

    def test_stand_where_the_deck_has_them_and_move_with_their_speed(self):
        self.make()
        _, about, _ = self.read()
        floor, rising, ball = about["walls"]
        size = np.linalg.norm(np.array(about["scale"]) * 65535)
        for wall, height in ((floor, -0.002), (rising, -0.02)):
            self.assertEqual(wall["normal"], [0, 0, 1])
            plate = np.reshape(wall["plates"], (4, 3))
            np.testing.assert_allclose(plate[:, 2], height, atol=1e-3 * size)
            self.assertTrue((plate.min(axis=0)[:2] < about["low"][:2]).all())
            self.assertTrue((plate.max(axis=0)[:2] > (np.array(about["low"]) + 65535 * np.array(about["scale"]))[:2]).all())
        self.assertEqual((floor["moves"], ball["moves"]), ([], []))
        self.assertEqual(len(rising["moves"]), about["frames"])
        np.testing.assert_allclose(rising["moves"], [[0, 0, 20 * time] for time in self.run_.fields.times], atol=1e-9)
        self.assertNotIn("normal", ball)
        radius = np.linalg.norm(np.reshape(ball["plates"], (-1, 3)) - [0.02, 0, -0.05], axis=1)
        np.testing.assert_allclose(radius, 0.01, rtol=0.01)


class Large(OfARun):
    """A surface that does not fit."""

    options = ["parts.plate.shell_plate.cells=[24, 24]", "parts.block.box.cells=[8, 8, 8]", "output.fields.every=5e-6", "walls=[]"]

    def pack(self, share):
        whole = len(base64.b64decode(pack_view(self.run_.fields, ["von_mises"])[1]))
        about, text, told = pack_view(self.run_.fields, ["von_mises"], int(share * whole))
        self.assertLessEqual(len(base64.b64decode(text)), int(share * whole))
        read_surface(about, text)
        return about, " ".join(told)

    def test_loses_arrows_then_sections_then_frames_then_nodes_and_says_so(self):
        count = len(self.run_.fields.times)
        about, told = self.pack(1)
        self.assertEqual((told, about["volumes"] > 0, about["frames"]), ("", True, count))
        about, told = self.pack(0.6)
        self.assertEqual((told, about["volumes"] > 0, about["frames"]), ("", True, count))
        self.assertLessEqual(max(one["count"] for one in about["arrows"]), 300)
        about, told = self.pack(0.4)
        self.assertEqual((about["volumes"], about["open"], about["frames"]), (0, True, count))
        self.assertIn("leaves solids open", told)
        about, told = self.pack(0.3)
        self.assertIn(f"{about['frames']} of {count} frames", told)
        about, told = self.pack(0.2)
        self.assertGreaterEqual(about["frames"], FEWEST_FRAMES)
        self.assertIn("coarser", told)
        self.assertIn(f"{about['faces']} faces are left", told)

    def test_parts_that_stand_still_go_first(self):
        fields = self.run_.fields
        still = fields.positions
        plate = np.unique(fields.hexahedra[fields.part == fields.part_names.index("plate")])

        def positions(frame):
            now = still(frame).copy()
            now[plate] = still(0)[plate]
            return now

        fields.positions = positions
        self.addCleanup(delattr, fields, "positions")
        about, told = self.pack(0.15)
        self.assertIn("parts that do not move are left out (plate)", told)


class Coarse(unittest.TestCase):
    def test_a_closed_surface_stays_closed(self):
        """Of a cube of 8x8x8 elements: each edge is one of two faces, before and after."""
        index = np.arange(9**3).reshape(9, 9, 9)
        places = np.stack(np.meshgrid(*[np.arange(9.0)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
        faces = []
        for axis in range(3):
            for end in (0, 8):
                sheet = np.take(index, end, axis)
                quads = np.stack([sheet[:-1, :-1], sheet[1:, :-1], sheet[1:, 1:], sheet[:-1, 1:]], axis=-1).reshape(-1, 4)
                faces.append(quads)
        corners = np.concatenate(faces)
        visible = np.zeros((2, len(corners)), dtype=np.uint8)
        visible[0] = visible[1, ::7] = 1
        self.assertEqual(self.count_edges(corners), {2})
        merged, owners, seen = merge_nodes(places, 2.01, corners, np.arange(len(corners)), np.zeros(len(corners), int), visible)
        self.assertEqual(self.count_edges(merged), {2})
        self.assertLess(len(merged), len(corners) / 3)
        self.assertEqual(len(owners), len(merged))
        self.assertTrue(seen[0].all() and seen[1].any())
        self.assertTrue(set(merged.reshape(-1)) <= set(corners.reshape(-1)))

    def count_edges(self, corners):
        edges = Counter(tuple(sorted((a, b))) for face in corners for a, b in zip(face, np.roll(face, -1)) if a != b)
        return set(edges.values())


def picture_tests(make_browser):
    """The class of tests in one browser."""

    class Pictures(OfARun):
        options = HALF

        @classmethod
        def setUpClass(cls):
            super().setUpClass()
            cls.make("--field", "von_mises,velocity")
            cls.browser = make_browser(cls.folder.name)
            cls.addClassCleanup(cls.browser.close)

        def setUp(self):
            self.browser.show(os.path.join(self.out, "view.html"))
            self.do("press('w');")  # without rigid walls

        def do(self, script):
            return self.browser.run("const box = document.getElementById('view'), find = name => box.querySelector(name), viewer = box.viewer;"
                                    "const set = (name, value) => { find(name).value = value;"
                                    "find(name).dispatchEvent(new Event(find(name).tagName === 'SELECT' ? 'change' : 'input')); };"
                                    "const press = key => window.dispatchEvent(new KeyboardEvent('keydown', {key}));" + script)

        def look(self, script):
            self.do(script)
            return self.browser.canvas()

        def assertSame(self, one, other, most=SAME):
            self.assertLess(np.abs(one - other).mean(), most)

        def point(self):
            """The text of the first point from the left, at half height, that has one."""
            return self.do("const canvas = viewer.canvas, frame = canvas.getBoundingClientRect();"
                           "for (let x = 0.02; x < 1; x += 0.01) { canvas.dispatchEvent(new PointerEvent('pointermove', {clientX: frame.left + x * frame.width,"
                           "clientY: frame.top + 0.5 * frame.height})); if (find('.value').textContent) return find('.value').textContent; } return '';")

        def test_shows_fields_values_and_what_keys_do(self):
            last = len(self.run_.fields.times) - 1
            self.assertIn("von Mises", self.do("return find('.bar-title').textContent"))
            self.assertRegex(self.point(), r"^(block|plate), element \d+: (at least )?[\d.e+-]+ [MG]Pa$")
            self.assertIn(f"(frame {last})", self.do("return find('.clock').textContent"))
            self.do("press('f'); press('ArrowRight');")
            self.assertIn("speed", self.do("return find('.bar-title').textContent"))
            self.assertRegex(self.point(), r"^(block|plate), node \d+: (at least )?[\d.e+-]+ m/s$")
            self.assertIn("(frame 0)", self.do("return find('.clock').textContent"))
            self.do("press('End'); press('ArrowLeft'); press('h');")
            self.assertIn(f"(frame {last - 1})", self.do("return find('.clock').textContent"))
            self.assertIn("next field", self.do("return find('.keys').hidden ? '' : find('.keys').textContent"))

        def test_the_bar_ends_where_the_user_wants(self):
            self.do("viewer.choose(viewer.about.frames - 1);")
            labels = "return [...find('.bar-labels').children].map(one => +one.textContent)"
            end = "find('.bar-{}').value = {}; find('.bar-{}').dispatchEvent(new Event('change'));"
            largest = float(self.do("return viewer.about.fields[0].largest[viewer.state.frame].value"))
            whole, bar = self.look("press('d');"), self.do(labels)
            own = self.look("press('r');")
            ends = self.do(labels)
            self.assertLess(0, ends[-1])
            self.assertLessEqual(ends[-1], min(1.01 * largest, 0.99 * bar[-1]))
            self.assertGreater(np.abs(own - whole).mean(), 0.1)
            typed = self.look(end.format("high", 2 * ends[-1], "high") + end.format("low", 0, "low"))
            self.assertEqual(self.do(labels)[::4], [0, float(f"{2 * ends[-1]:.4g}")])
            self.assertGreater(np.abs(own - typed).mean(), 0.1)
            self.do(end.format("high", -5, "high"))
            self.assertEqual(self.do(labels)[-1], float(f"{2 * ends[-1]:.4g}"), "ends in the wrong order change nothing")
            self.assertSame(self.look("press('r');"), whole, 1e-9)
            self.assertEqual(self.do(labels), bar)

        def test_no_deformation_is_the_start(self):
            start = self.look("press('p'); viewer.choose(0);")
            end = self.look("press('End');")
            self.assertGreater(np.abs(start - end).mean(), 1)
            self.assertSame(start, self.look("set('.swell', 0);"), 1e-9)

        def test_the_mirror_of_the_decks_symmetry_makes_a_symmetric_picture(self):
            self.assertEqual(self.do("return viewer.about.symmetry"), [[0, 0]])
            half = self.look("press('p'); press('e'); set('.mirror', 1); press('y');")
            middle = np.abs(half - half[:, ::-1]).mean(axis=2)
            self.assertLess((middle > 60).mean(), 0.005)  # lights come from one side
            outer = np.flatnonzero((half.min(axis=2) < 250).any(axis=0))
            self.assertAlmostEqual(outer[0], half.shape[1] - 1 - outer[-1], delta=2)
            self.assertGreater(np.ptp(outer), 0.5 * half.shape[1])

        def test_rigid_walls_are_drawn_and_seen_through_from_behind(self):
            """At a place of the floor beside the bodies, which cover no pixel there."""
            at = ("const plate = viewer.about.walls[0].plates, corner = [0, 1, 2].map(i => 0.97 * plate[i] + 0.03 * plate[6 + i]);"
                     "const spot = project(viewer, viewer.surface.show(corner, corner, 1)); const scale = viewer.canvas.width / viewer.canvas.clientWidth;"
                     "return [Math.round(scale * spot.y), Math.round(scale * spot.x)];")
            pixel = ("const project = (viewer, point) => { viewer.camera.updateMatrixWorld(); const s = point.clone().project(viewer.camera);"
                     "return {x: (s.x + 1) / 2 * viewer.canvas.clientWidth, y: (1 - s.y) / 2 * viewer.canvas.clientHeight}; };" + at)
            for elevation, least, most in ((40, 90, 212), (-40, 213, 252)):
                without = self.look(f"viewer.look(-50, {elevation});")
                shown = self.look("press('w');")
                row, column = self.do(pixel)
                self.assertTrue(0 <= row < shown.shape[0] and 0 <= column < shown.shape[1])
                self.assertEqual(without[row, column].min(), 255)
                self.assertTrue(least <= shown[row, column].mean() <= most, shown[row, column])
                self.assertGreater((shown.min(axis=2) < 250).mean(), (without.min(axis=2) < 250).mean() + 0.05)
                self.do("press('w');")

        def test_a_part_that_is_hidden_is_not_drawn(self):
            both = self.look("press('p'); press('e');")
            alone = self.look("find('.parts input').click();")  # the block
            part = np.array([int(self.do("return viewer.about.partColors[1]")[i : i + 2], 16) for i in (1, 3, 5)])
            ink = alone[alone.min(axis=2) < 250]
            self.assertLess(len(ink), (both.min(axis=2) < 250).sum())
            shares = ink / ink.sum(axis=1, keepdims=True) - part / part.sum()  # of any light the same share of red
            self.assertLess(np.quantile(np.abs(shares), 0.98), 0.03)  # edges are mixed with the white behind them

    return Pictures


def webgl_tests(make_browser):
    class WebGL(picture_tests(make_browser)):
        def test_a_section_is_filled_and_shows_the_part(self):
            """The block, seen along y, is a square of 20 mm at the start."""
            self.do("press('p'); press('e'); press('Home'); press('y'); find('.parts').querySelectorAll('input')[1].click(); set('.cut', 'y');")
            whole = self.browser.canvas()
            rows, columns = np.nonzero((whole.min(axis=2) < 250) & (whole[:, :, 2] > whole[:, :, 0]))  # without the frame of the plane
            height, width = np.ptp(rows) + 1, np.ptp(columns) + 1
            inside = whole[rows.min() + 4 : rows.max() - 4, columns.min() + 4 : columns.max() - 4]
            self.assertLess(inside.std(axis=(0, 1)).max(), 2)
            self.assertAlmostEqual(height / width, 1, delta=0.05)
            self.do("press('p');")
            self.assertRegex(self.point(), r"^block, element \d+: ")

        def test_light_does_not_depend_on_the_unit_of_length(self):
            small = self.look("press('p'); press('e'); press('d');")
            large = self.look("const {camera, controls} = viewer; for (const copy of viewer.copies) { copy.scale.multiplyScalar(1000); copy.updateMatrixWorld(); }"
                              "camera.far *= 1000; camera.near *= 1000; camera.updateProjectionMatrix();"
                              "camera.position.multiplyScalar(1000); controls.target.multiplyScalar(1000); controls.update();")
            self.assertSame(small, large, 0.5)

        def test_a_cut_takes_away_one_side(self):
            self.do("press('p'); press('e'); press('z');")
            whole = self.look("set('.cut', 'x'); set('.cut-place', 0); press('i');")
            none = self.look("press('i');")
            half = self.look("set('.cut-place', 0.5);")
            ink = [int((picture.min(axis=2) < 250).sum()) for picture in (whole, none, half)]
            self.assertLess(min(ink[:2]), 0.2 * max(ink[:2]))
            self.assertAlmostEqual(ink[2] / max(ink[:2]), 0.5, delta=0.1)

        def test_arrows_and_outline_are_drawn(self):
            plain = self.look("press('p'); press('e');")
            arrows = self.look("press('a'); press('a');")
            self.assertIn("longest arrow", self.do("return find('.arrow-note').textContent"))
            self.assertGreater(np.abs(plain - arrows).mean(), 0.05)
            outlined = self.look("set('.arrows', ''); press('o');")
            blue = (np.abs(outlined - [0x1F, 0x6F, 0xB2]).max(axis=2) < 30).sum()
            self.assertGreater(blue, 50)

        def test_the_handle_moves_the_cut_and_not_the_camera(self):
            self.do("set('.cut', 'x'); viewer.drawNow();")
            before = self.do("return [viewer.camera.position.toArray(), +find('.cut-place').value]")
            self.do("const mark = box.querySelector('.handle').getBoundingClientRect(), canvas = viewer.canvas, x = mark.left + 8, y = mark.top + 8;"
                    "canvas.setPointerCapture = () => {};"
                    "const send = (kind, to) => canvas.dispatchEvent(new PointerEvent(kind, {clientX: to[0], clientY: to[1], buttons: 1, pointerId: 1}));"
                    "send('pointerdown', [x, y]); canvas.dispatchEvent(new MouseEvent('mousedown', {clientX: x, clientY: y, button: 0}));"
                    "document.dispatchEvent(new MouseEvent('mousemove', {clientX: x + 60, clientY: y})); send('pointermove', [x + 60, y]); send('pointerup', [x + 60, y]);")
            after = self.do("return [viewer.camera.position.toArray(), +find('.cut-place').value]")
            self.assertEqual(before[0], after[0])
            self.assertGreater(abs(after[1] - before[1]), 0.05)

    return WebGL


@unittest.skipUnless(CHROMIUM, "Chromium is not here")
class InChromium(webgl_tests(Chromium) if CHROMIUM else object):
    def tearDown(self):
        self.assertEqual(self.browser.errors(), [])

    def touch(self, kind, *points):
        self.browser.call("Input.dispatchTouchEvent", type=kind, touchPoints=[{"x": x, "y": y, "id": i} for i, (x, y) in enumerate(points)])

    def test_a_finger_turns_two_zoom_and_a_tap_tells_a_value(self):
        self.browser.call("Emulation.setTouchEmulationEnabled", enabled=True, maxTouchPoints=2)
        self.addCleanup(self.browser.call, "Emulation.setTouchEmulationEnabled", enabled=False)
        frame = self.do("const f = viewer.canvas.getBoundingClientRect(); return [f.left, f.top, f.width, f.height]")
        x, y = frame[0] + frame[2] / 2, frame[1] + frame[3] / 2
        where = "const p = viewer.camera.position.clone().sub(viewer.controls.target); return [p.length(), Math.atan2(p.y, p.x)]"
        before = self.do(where)
        self.touch("touchStart", (x, y))
        self.touch("touchMove", (x + 20, y))
        self.touch("touchMove", (x + 80, y))
        self.touch("touchEnd")
        turned = self.do(where)
        self.assertAlmostEqual(turned[0] / before[0], 1, places=6)
        self.assertGreater(abs(turned[1] - before[1]), 0.1)
        self.touch("touchStart", (x - 40, y), (x + 40, y))
        self.touch("touchMove", (x - 60, y), (x + 60, y))
        self.touch("touchMove", (x - 120, y), (x + 120, y))
        self.touch("touchEnd")
        self.assertLess(self.do(where)[0], 0.7 * turned[0])
        self.do("press('d');")
        self.touch("touchStart", (x, y))
        self.touch("touchEnd")
        self.assertRegex(self.do("return find('.value').textContent"), r"^(block|plate), element")


@unittest.skipUnless(FIREFOX and XVFB, "Firefox or xvfb-run is not here")
class InFirefox(webgl_tests(Firefox) if FIREFOX and XVFB else object):
    @unittest.skipUnless(CHROMIUM, "Chromium is not here")
    def test_the_picture_is_that_of_chromium(self):
        size = "viewer.renderer.setPixelRatio(1); viewer.renderer.setSize(800, 450, false); viewer.camera.aspect = 16 / 9; viewer.camera.updateProjectionMatrix(); press('d');"
        scripts = (size, "set('.cut', 'y');", "set('.cut', ''); set('.mirror', 1); set('.swell', 3); press('f');")
        here = [self.look(script) for script in scripts]
        with Chromium(tempfile.mkdtemp(dir=self.folder.name)) as other:
            other.show(os.path.join(self.out, "view.html"))
            self.browser, mine = other, self.browser
            self.do("press('w');")
            there = [self.look(script) for script in scripts]
            self.browser = mine
        for one, two in zip(here, there):
            self.assertSame(one, two)


def make_plain(folder):
    return Firefox(folder, display=False) if FIREFOX else Chromium(folder, "--disable-3d-apis")


@unittest.skipUnless(FIREFOX or CHROMIUM, "neither Firefox nor Chromium is here")
class WithoutWebGL(picture_tests(make_plain) if FIREFOX or CHROMIUM else object):
    def test_says_so_and_draws_the_same(self):
        self.assertIn("no WebGL", self.do("return find('.note').textContent"))
        for tool in (".outline", ".arrows", ".mark"):
            self.assertEqual(self.do(f"return getComputedStyle(find('{tool}').parentElement).display"), "none")
        if not CHROMIUM:
            self.skipTest("Chromium is not here")
        here = self.look("viewer.painter.setSize(800, 450); viewer.camera.aspect = 16 / 9; viewer.camera.updateProjectionMatrix(); press('d'); press('e'); press('e');")
        with Chromium(tempfile.mkdtemp(dir=self.folder.name)) as other:
            other.show(os.path.join(self.out, "view.html"))
            self.browser, mine = other, self.browser
            self.do("press('w');")
            there = self.look("viewer.renderer.setSize(800, 450, false); viewer.camera.aspect = 16 / 9; viewer.camera.updateProjectionMatrix(); press('d');")
            self.browser = mine
        ink = [picture.min(axis=2) < 250 for picture in (here, there)]
        self.assertGreater((ink[0] & ink[1]).sum() / (ink[0] | ink[1]).sum(), 0.98)
        self.assertSame(here, there)


if __name__ == "__main__":
    unittest.main()
