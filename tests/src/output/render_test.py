"""Renders the sample run with percuss render and looks at the pictures: render_test.py FOLDER.

Exit code 77 (skipped) if what percuss render needs is not installed.
"""

import contextlib
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from unittest.mock import patch

try:
    import h5py  # noqa: F401
    import numpy as np
    import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
    from PIL import Image

    from percuss.display import OTHER, open_display
except ImportError as error:
    print(f"skipped: {error}; scripts/install_dependencies --render installs what this test needs")
    sys.exit(77)
if not shutil.which("Xvfb") and not os.environ.get("DISPLAY"):
    print("skipped: no display and no Xvfb; scripts/install_dependencies --render installs one")
    sys.exit(77)

FOLDER = sys.argv.pop()
RENDER = [sys.executable, "-m", "percuss", "render"]


def is_dark_red(picture):
    """Where the colour is near that of the high end of the default map."""
    return (picture[..., 0] < 120) & (picture[..., 0] > picture[..., 1] + 20)


class Render(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        """One display for all pictures but those of the test that lets percuss render make its own."""
        with contextlib.ExitStack() as stack:
            display = stack.enter_context(open_display())
            stack.enter_context(patch.dict(os.environ, {OTHER: display}))
            cls.addClassCleanup(stack.pop_all().close)

    def setUp(self):
        self.out = tempfile.TemporaryDirectory()
        self.addCleanup(self.out.cleanup)

    def render(self, *arguments, folder=FOLDER, walls=False, env=None):
        if not walls:
            arguments = (*arguments, "--no-walls")
        return subprocess.run([*RENDER, folder, "--out", self.out.name, "--size", "320x180", "--fast", *arguments],
                              capture_output=True, text=True, timeout=120, env=env)

    def draw(self, *arguments, frame=0, mark=False, **options):
        """The picture of one frame, without colour bar and legend."""
        done = self.render("--frame", str(frame), "--edges", "off", *["--no-mark"] * (not mark), *arguments, **options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.picture(f"frame_{frame:04d}.png")[:, :270]

    def change_stress(self, change):
        """A copy of the sample whose von Mises stress is change(frame, elements)."""
        folder = os.path.join(self.out.name, "changed")
        shutil.copytree(FOLDER, folder)
        with h5py.File(os.path.join(folder, "fields.vtkhdf"), "r+") as file:
            elements = int(file["VTKHDF/NumberOfCells"][0])
            for frame in range(3):
                file["VTKHDF/CellData/von_mises"][frame * elements : (frame + 1) * elements] = change(
                    frame, np.arange(elements))
        return folder

    def picture(self, name):
        with Image.open(os.path.join(self.out.name, name)) as image:
            return np.asarray(image.convert("RGB")).astype(int)

    def test_one_picture_has_the_name_that_is_given(self):
        done = self.render("--frame", "-1", "--out", os.path.join(self.out.name, "last.png"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.picture("last.png").shape, (180, 320, 3))
        for name, words in (("all.png", "choose one with --frame"), ("film.mp4", "neither a folder nor a .png")):
            done = self.render("--out", os.path.join(self.out.name, name))
            self.assertEqual(done.returncode, 2)
            self.assertIn(words, done.stderr)
        self.assertEqual(os.listdir(self.out.name), ["last.png"])

    def test_makes_every_frame_and_an_animation_that_move(self):
        alone = {name: value for name, value in os.environ.items() if name not in (OTHER, "DISPLAY", "XAUTHORITY")}
        done = self.render(env=alone)
        self.assertEqual(done.returncode, 0, done.stderr)
        frames = [self.picture(f"frame_{i:04d}.png") for i in range(3)]
        for frame in frames:
            self.assertEqual(frame.shape, (180, 320, 3))
            self.assertTrue((frame[0, 0] == 255).all(), "the background is white")
            covered = (frame.min(axis=2) < 250).mean()
            self.assertTrue(0.03 < covered < 0.9, f"{covered} of the picture is covered")
        self.assertFalse((frames[0] == frames[2]).all())
        with Image.open(os.path.join(self.out.name, "animation.gif")) as animation:
            self.assertEqual(animation.n_frames, 3)

    def test_makes_the_frames_that_are_named_without_an_animation(self):
        done = self.render("--frame", "-1,0")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(sorted(os.listdir(self.out.name)), ["frame_0000.png", "frame_0002.png"])
        done = self.render("--frame", "0,7")
        self.assertIn("there is no frame 7", done.stderr)
        self.assertIn("'a,1' is not a number of a frame", self.render("--frame", "a,1").stderr)

    def test_colors_each_face_by_the_rank_of_its_nodes(self):
        folder = os.path.join(self.out.name, "with_ranks")
        shutil.copytree(FOLDER, folder)
        with h5py.File(os.path.join(folder, "fields.vtkhdf"), "r+") as file:
            nodes = int(file["VTKHDF/NumberOfPoints"][0])
            file["VTKHDF/PointData/contact_rank"] = np.repeat([-1.0, 1.0], nodes // 2)  # the left cube has none
            file["VTKHDF/Steps/PointDataOffsets/contact_rank"] = np.zeros(3, dtype=int)
        done = self.render("--edges", "off", "--field", "contact_rank", "--frame", "0", "--view", "-90:10",
                           folder=folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        picture = self.picture("frame_0000.png")
        self.assertTrue((picture[:, 270:].max(axis=2) - picture[:, 270:].min(axis=2) > 20).any(), "there is a legend")
        scene = picture[:, :270]
        drawn = scene.min(axis=2) < 235
        colored = drawn & (scene[:, :, 0] > scene[:, :, 2] + 25)  # rank 1 is reddish
        middle = np.flatnonzero(drawn.any(axis=0)).mean()
        columns = np.flatnonzero(colored.any(axis=0))
        self.assertTrue(colored.sum() > 0.2 * drawn.sum())
        self.assertTrue((columns > middle).all(), "the left cube is grey, and nothing is in between")

    def test_colors_by_part_in_one_frame(self):
        done = self.render("--part-colors", "--frame", "-1", "--view", "-60:10")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(os.listdir(self.out.name), ["frame_0002.png"])
        picture = self.picture("frame_0002.png")[:, :270].reshape(-1, 3)  # without the legend
        blueish = (picture[:, 2] > picture[:, 0] + 15).any()
        reddish = (picture[:, 0] > picture[:, 2] + 15).any()
        self.assertTrue(blueish and reddish, "both parts are in view, each in its colour")

    def test_cuts_the_mesh_open(self):
        def reddish():
            picture = self.picture("frame_0000.png")[:, :270]  # without the legend
            return (picture[..., 0] > picture[..., 2] + 40).any()

        self.render("--part-colors", "--frame", "0")
        self.assertTrue(reddish(), "the right cube is in view")
        done = self.render("--part-colors", "--frame", "0", "--clip", "x=5")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertFalse(reddish(), "the right cube is gone")

    def test_cuts_away_the_side_that_hides_the_inside(self):
        folder = self.change_stress(lambda frame, element: element // 2 % 2)  # 1 in the half with y > 1
        for view, half in (("-90:10", "--clip=y=1"), ("90:10", "--clip=-y=1")):
            picture = self.draw("--field", "von_mises", "--view", view, half, folder=folder)
            self.assertTrue(is_dark_red(picture).any(), "the other half is in view")
        for view, half in (("90:10", "--clip=y=1"), ("-90:10", "--clip=+y=1")):
            picture = self.draw("--field", "von_mises", "--view", view, half, folder=folder)
            self.assertFalse(is_dark_red(picture).any(), "only the half with zeros is left")

    def test_shows_what_one_element_alone_has(self):
        folder = self.change_stress(lambda frame, element: np.where(element == 13, 0.03, 0))
        picture = self.draw("--field", "von_mises", folder=folder)
        self.assertTrue(is_dark_red(picture).any(), "its colour is that of the end of the bar")

    def test_has_one_range_for_all_frames_drawn(self):
        folder = self.change_stress(lambda frame, element: np.where(element == 13, 0.01 * (1 + 9 * frame), 0))
        self.assertTrue(is_dark_red(self.draw("--field", "von_mises", folder=folder)).any(), "alone it has its own")
        self.assertEqual(self.render("--field", "von_mises", folder=folder).returncode, 0)
        first, last = (self.picture(f"frame_{frame:04d}.png") for frame in (0, 2))
        np.testing.assert_array_equal(first[:, 285:], last[:, 285:], "the bar")
        self.assertFalse(is_dark_red(first[:, :270]).any())
        self.assertTrue(is_dark_red(last[:, :270]).any())

    def test_tells_and_marks_the_largest_value(self):
        folder = self.change_stress(lambda frame, element: np.where(element == 13, 0.03 * (1 + frame), 0.01))
        with h5py.File(os.path.join(folder, "fields.vtkhdf")) as file:
            number = int(file["VTKHDF/CellData/element_id"][13])
        done = self.render("--field", "von_mises", "--frame", "0,2", folder=folder)
        self.assertIn("largest von Mises stress 90 mPa", done.stdout)
        self.assertIn(f"element {number} of part", done.stdout)
        self.assertIn("frame 2", done.stdout)
        marked, plain = (self.draw("--field", "von_mises", folder=folder, mark=mark) for mark in (True, False))
        self.assertTrue((marked != plain).any())

    def test_draws_the_mirrored_half(self):
        def count_columns(picture):
            drawn = np.flatnonzero((picture.min(axis=2) < 245).any(axis=0))
            return (picture.min(axis=2) < 245).sum(axis=0)[drawn[0] : drawn[-1] + 1]

        options = ("--view", "-90:0", "--part-colors")  # x to the right
        with h5py.File(os.path.join(FOLDER, "fields.vtkhdf")) as file:
            low = float(file["VTKHDF/Points"][: int(file["VTKHDF/NumberOfPoints"][0]), 0].min())
        half = count_columns(self.draw(*options)[40:-25])
        whole = count_columns(self.draw(*options, "--mirror", f"x={low}")[40:-25])
        middle = len(whole) // 2
        self.assertAlmostEqual(whole[:middle].sum() / whole[-middle:].sum(), 1, delta=0.1)  # in perspective
        self.assertGreater(len(whole) / whole.max(), 1.6 * len(half) / half.max(), "it is twice as wide")
        picture = self.draw(*options, "--mirror", f"x={low}")[40:-25].astype(float)
        drawn = picture.min(axis=2) < 245
        first, last = np.flatnonzero(drawn.any(axis=0))[[0, -1]]
        left, right = (picture[:, side][drawn[:, side]].mean()
                       for side in (slice(0, (first + last) // 2), slice((first + last) // 2, None)))
        self.assertAlmostEqual(left / right, 1, delta=0.25, msg="the mirrored half is lit from outside")
        done = self.render("--frame", "0", "--mirror")
        self.assertEqual(done.returncode, 2)
        self.assertIn("--mirror y=0", done.stderr)

    def test_the_camera_follows_what_moves(self):
        def find_change(*options):
            middles = []
            for frame in (0, 2):
                drawn = np.argwhere(self.draw("--part-colors", *options, frame=frame)[40:-25].min(axis=2) < 245)
                middles.append(drawn.mean(axis=0))
            return np.linalg.norm(middles[1] - middles[0])

        with h5py.File(os.path.join(FOLDER, "fields.vtkhdf")) as file:
            name = file["percuss/part_names"][0].decode()
        self.assertLess(find_change("--part", name, "--follow", name), 0.5 * find_change("--part", name))
        done = self.render("--frame", "0", "--follow", "nobody")
        self.assertEqual(done.returncode, 2)
        self.assertIn(name, done.stderr)

    def test_draws_two_runs_beside_each_other(self):
        folder = self.change_stress(lambda frame, element: np.full(len(element), 0.5 + frame))
        done = self.render("--frame", "1", "--field", "von_mises", "--beside", folder, "--no-mark")
        self.assertEqual(done.returncode, 0, done.stderr)
        picture = self.picture("frame_0001.png")
        self.assertEqual(picture.shape, (180, 320, 3))
        left, right = picture[30:-25, :130], picture[30:-25, 160:290]
        self.assertTrue((left.min(axis=2) < 245).any() and (right.min(axis=2) < 245).any())
        np.testing.assert_array_equal(picture[40:120, 142:160], picture[40:120, 302:320], "one bar")

    @unittest.skipUnless(shutil.which("ffmpeg"), "ffmpeg is not here")
    def test_makes_films(self):
        self.assertEqual(self.render("--video", "mp4", "--video", "webm", "--fps", "5").returncode, 0)
        for name, head in (("animation.mp4", b"ftyp"), ("animation.webm", b"webm")):
            with open(os.path.join(self.out.name, name), "rb") as file:
                self.assertIn(head, file.read(64))
        self.assertEqual(self.render("--video", "mp4", "--video", "webm").returncode, 0, "they have the mark")

    def test_takes_a_range_that_is_given(self):
        folder = self.change_stress(lambda frame, element: np.where(element == 13, 0.03, 0))
        picture = self.draw("--field", "von_mises", "--range", "0:1", folder=folder)
        self.assertFalse(is_dark_red(picture).any())

    def test_draws_the_parts_that_are_named(self):
        def blueish(picture):
            return (picture[..., 2] > picture[..., 0] + 15).any()

        def reddish(picture):
            return (picture[..., 0] > picture[..., 2] + 40).any()

        left = self.draw("--part-colors", "--part", "left")
        self.assertTrue(blueish(left) and not reddish(left))
        right = self.draw("--part-colors", "--part", 'right <&"> one')
        self.assertTrue(reddish(right) and not blueish(right))
        both = self.draw("--part-colors", "--part", 'left,right <&"> one')
        self.assertTrue(reddish(both) and blueish(both))
        done = self.render("--part", "middle")
        self.assertEqual(done.returncode, 2)
        self.assertIn("there is no part 'middle'", done.stderr)
        self.assertIn('it has left, right <&"> one', done.stderr)

    def test_looks_at_a_point_as_large_as_asked_for(self):
        def columns(*arguments):
            drawn = self.draw("--part", "left", "--view", "-90:0", *arguments).min(axis=2) < 250
            return np.flatnonzero(drawn[30:160].any(axis=0))

        middle = ("--look-at", "1:1:1")
        small, large = columns(*middle, "--zoom", "0.25"), columns(*middle, "--zoom", "0.5")
        self.assertAlmostEqual(len(large) / len(small), 2, delta=0.1)
        self.assertAlmostEqual(large.mean(), 160, delta=1.5)  # the middle of the whole picture
        self.assertLess(columns("--look-at", "2:1:1", "--zoom", "0.5").mean(), 160 - len(large) / 4)

    def test_draws_rigid_walls(self):
        def covered(picture):
            return (picture.min(axis=2) < 250).mean()

        without, front = self.draw("--view", "-50:22"), self.draw("--view", "-50:22", walls=True)
        self.assertGreater(covered(front), covered(without) + 0.1)
        behind = self.draw("--view", "-50:-22", "--part-colors", walls=True)
        self.assertTrue((behind[..., 2] > behind[..., 0] + 10).any(), "bodies are seen through a wall before them")

    def test_draws_cylinders_and_spheres(self):
        def covered(picture):
            return (picture.min(axis=2) < 250).mean()

        folder = os.path.join(self.out.name, "round")
        shutil.copytree(FOLDER, folder)
        view = ("--view", "-90:0")
        plain = covered(self.draw(*view, folder=folder))
        with h5py.File(os.path.join(folder, "fields.vtkhdf"), "r+") as file:
            places = file["VTKHDF/Points"][:]
            middle, size = places.mean(axis=0), np.ptp(places, axis=0).max()
            for name in ("walls", "moving_walls", "wall_edges", "moving_wall_edges"):
                file["percuss"].pop(name, None)
            file["percuss/round_walls"] = [[*middle, 0, 0, 0, size, 0, 0, 0, 0]]
        ball = covered(self.draw(*view, walls=True, folder=folder))
        self.assertGreater(ball, plain + 0.1)
        with h5py.File(os.path.join(folder, "fields.vtkhdf"), "r+") as file:
            file["percuss/round_walls"][0, 3:8] = [1, 0, 0, 0.1 * size, 0.3 * size]
        self.assertGreater(ball, covered(self.draw(*view, walls=True, folder=folder)) + 0.05)

    def test_says_that_paraview_has_removed_vtk(self):
        fakes = os.path.join(self.out.name, "fakes")
        os.mkdir(fakes)
        with open(os.path.join(fakes, "h5py.py"), "w", encoding="utf-8") as file:
            file.write("raise ImportError('gone')\n")
        for status in ("installed", "not-installed"):
            with open(os.path.join(fakes, "dpkg-query"), "w", encoding="utf-8") as file:
                file.write(f"#!/bin/sh\nprintf {status}\n")
            os.chmod(file.name, 0o755)
            environment = dict(os.environ, PYTHONPATH=f"{fakes}:{os.environ['PYTHONPATH']}",
                               PATH=fakes + ":" + os.environ["PATH"])
            done = subprocess.run([*RENDER, FOLDER], capture_output=True, text=True, timeout=120, env=environment)
            self.assertEqual(done.returncode, 2)
            self.assertIn("run scripts/install_dependencies --render", done.stderr)
            self.assertEqual("removes the package python3-paraview" in done.stderr, status == "installed")

    def test_names_the_fields_there_are_when_one_is_unknown(self):
        done = self.render("--field", "temperature")
        self.assertEqual(done.returncode, 2)
        self.assertIn("there is no field 'temperature'", done.stderr)
        self.assertIn("von_mises", done.stderr)

    def test_refuses_a_folder_without_fields(self):
        done = subprocess.run([*RENDER, self.out.name], capture_output=True, text=True, timeout=120)
        self.assertEqual(done.returncode, 2)
        self.assertIn("fields.vtkhdf: there is no such file (a run writes it", done.stderr)

    def test_refuses_a_file_that_is_no_fields_file(self):
        other = os.path.join(self.out.name, "fields.vtkhdf")
        with open(other, "w", encoding="utf-8") as file:
            file.write("a letter\n")
        done = subprocess.run([*RENDER, other], capture_output=True, text=True, timeout=120)
        self.assertEqual(done.returncode, 2)
        self.assertIn("fields.vtkhdf: this is no fields file of percuss", done.stderr)


if __name__ == "__main__":
    unittest.main()
