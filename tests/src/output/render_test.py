"""Renders the sample run with scripts/render and looks at the pictures: render_test.py SCRIPT FOLDER.

Exit code 77 (skipped) if what scripts/render needs is not installed.
"""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest

try:
    import h5py  # noqa: F401
    import numpy as np
    import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
    from PIL import Image
except ImportError as error:
    print(f"skipped: {error}; scripts/install_dependencies --render installs what this test needs")
    sys.exit(77)
if not (shutil.which("xvfb-run") and shutil.which("xauth")) and not os.environ.get("DISPLAY"):
    print("skipped: no display and no Xvfb; scripts/install_dependencies --render installs one")
    sys.exit(77)

SCRIPT, FOLDER = sys.argv[1:3]
del sys.argv[1:3]


class Render(unittest.TestCase):
    def setUp(self):
        self.out = tempfile.TemporaryDirectory()
        self.addCleanup(self.out.cleanup)

    def render(self, *arguments):
        return subprocess.run([SCRIPT, FOLDER, "--out", self.out.name, "--size", "320x180", "--fast", *arguments],
                              capture_output=True, text=True, timeout=120)

    def picture(self, name):
        with Image.open(os.path.join(self.out.name, name)) as image:
            return np.asarray(image.convert("RGB")).astype(int)

    def test_makes_every_frame_and_an_animation_that_move(self):
        done = self.render()
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

    def test_colors_each_face_by_the_rank_of_its_nodes(self):
        folder = os.path.join(self.out.name, "with_ranks")
        shutil.copytree(FOLDER, folder)
        with h5py.File(os.path.join(folder, "fields.vtkhdf"), "r+") as file:
            nodes = int(file["VTKHDF/NumberOfPoints"][0])
            file["VTKHDF/PointData/contact_rank"] = np.repeat([-1.0, 1.0], nodes // 2)  # the left cube has none
            file["VTKHDF/Steps/PointDataOffsets/contact_rank"] = np.zeros(3, dtype=int)
        done = subprocess.run([SCRIPT, folder, "--out", self.out.name, "--size", "320x180", "--fast", "--edges", "off",
                               "--field", "contact_rank", "--frame", "0", "--view", "-90:10"],
                              capture_output=True, text=True, timeout=120)
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

    def test_names_the_fields_there_are_when_one_is_unknown(self):
        done = self.render("--field", "temperature")
        self.assertEqual(done.returncode, 2)
        self.assertIn("there is no field 'temperature'", done.stderr)
        self.assertIn("von_mises", done.stderr)

    def test_refuses_a_folder_without_fields(self):
        done = subprocess.run([SCRIPT, self.out.name], capture_output=True, text=True, timeout=120)
        self.assertEqual(done.returncode, 2)
        self.assertIn("fields.vtkhdf: there is no such file (a run writes it", done.stderr)

    def test_refuses_a_file_that_is_no_fields_file(self):
        other = os.path.join(self.out.name, "fields.vtkhdf")
        with open(other, "w", encoding="utf-8") as file:
            file.write("a letter\n")
        done = subprocess.run([SCRIPT, other], capture_output=True, text=True, timeout=120)
        self.assertEqual(done.returncode, 2)
        self.assertIn("fields.vtkhdf: this is no fields file of percuss", done.stderr)


if __name__ == "__main__":
    unittest.main()
