"""percuss view: view_test.py ROOT PERCUSS. Exit code 77 (skipped) without NumPy, h5py, Matplotlib or three.js; in Chromium where that is."""

import base64
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest
import zlib

try:
    import h5py  # noqa: F401
    import matplotlib  # noqa: F401
    import numpy as np
except ImportError as error:
    print(f"skipped: {error}; scripts/install_dependencies --report installs what this test needs")
    sys.exit(77)

from page_tools import CHROMIUM, PERCUSS, read_in_chromium  # noqa: E402
import percuss  # noqa: E402
import sample_run  # noqa: E402
from percuss.view import page as view  # noqa: E402
from percuss.view.surface import read_library  # noqa: E402

if read_library() is None:
    print("skipped: three.js is not here; scripts/install_dependencies --report installs it")
    sys.exit(77)

# What a user does, then what stands on the page: a value under the pointer in the middle of the canvas, another field, keys.
ACTIONS = """<script>
const wait = setInterval(() => {
  const box = document.getElementById('view');
  if (box.dataset.ready !== 'yes') return;
  clearInterval(wait);
  const canvas = box.querySelector('canvas'), find = name => box.querySelector(name), seen = [];
  const frame = canvas.getBoundingClientRect();
  const point = () => {
    for (let x = 0.1; x < 0.9; x += 0.02) {
      canvas.dispatchEvent(new PointerEvent('pointermove', {clientX: frame.left + x * frame.width, clientY: frame.top + 0.5 * frame.height}));
      if (find('.value').textContent) return;
    }
  };
  point();
  seen.push(find('.bar-title').textContent, find('.value').textContent, find('.clock').textContent);
  find('.fields').value = '1';
  find('.fields').dispatchEvent(new Event('change'));
  window.dispatchEvent(new KeyboardEvent('keydown', {key: 'ArrowRight'}));
  find('.swell').value = '3';
  find('.swell').dispatchEvent(new Event('input'));
  find('.outline').click();
  find('.mirror').value = '0-';
  find('.mirror').dispatchEvent(new Event('change'));
  point();
  seen.push(find('.bar-title').textContent, find('.value').textContent, find('.clock').textContent, find('.factor').textContent);
  box.dataset.seen = JSON.stringify(seen);
}, 50);
</script>"""


class View(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.out = sample_run.run(PERCUSS, cls.folder.name)
        cls.run_ = percuss.read(cls.out)

    def make(self, *words, code=0):
        done = subprocess.run([sys.executable, "-m", "percuss", "view", self.out, *words], capture_output=True, text=True, timeout=200)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done.stdout + done.stderr

    def read(self):
        with open(os.path.join(self.out, "view.html"), encoding="utf-8") as file:
            text = file.read()
        about = json.loads(re.search(r"id=surface-about>(.*?)</script>", text, re.DOTALL)[1])
        data = zlib.decompress(base64.b64decode(re.search(r"id=surface-data>(.*?)</script>", text, re.DOTALL)[1]))
        return text, about, data

    def test_holds_each_field_of_each_frame(self):
        self.make("--field", "von_mises,velocity")
        text, about, data = self.read()
        self.assertNotRegex(text, r"(src|href)=['\"]https?:")
        self.assertEqual([field["place"] for field in about["fields"]], ["element", "node"])
        self.assertEqual(about["frames"], len(self.run_.fields.times))
        sizes = 17 * about["faces"] + about["frames"] * (6 * about["nodes"] + about["faces"] + about["nodes"]) + about["erodes"] * about["frames"] * about["faces"]
        self.assertEqual(len(data), sizes)
        speeds = np.frombuffer(data[-about["frames"] * about["nodes"] :], np.uint8).reshape(about["frames"], -1)
        high = float(about["fields"][1]["labels"][-1])
        nodes = np.unique(self.run_.fields.hexahedra)
        for frame in (0, -1):  # to one 254th of the range
            largest = self.run_.fields.values("velocity", frame)[nodes].max()
            self.assertAlmostEqual(speeds[frame].max() / 254 * high, largest, delta=high / 200)

    def test_a_large_surface_loses_frames_and_then_what_stands_still_and_says_so(self):
        whole = view.LARGEST
        self.addCleanup(setattr, view, "LARGEST", whole)
        self.make()
        size = len(base64.b64decode(re.search(r"id=surface-data>(.*?)</script>", self.read()[0], re.DOTALL)[1]))
        view.LARGEST = size * 2 // 3
        _, notes = view.make_view_page(self.run_, None, None)
        self.assertRegex(" ".join(notes), rf"\d+ of {len(self.run_.fields.times)} frames")
        view.LARGEST = size // 11
        _, notes = view.make_view_page(self.run_, None, None)
        self.assertIn("the surface is", " ".join(notes))

    def test_wrong_words_have_a_clear_one(self):
        self.assertIn("did you mean velocity?", self.make("--field", "velocty", code=2))
        self.assertIn("it has block, plate", self.make("--part", "rim", code=2))
        with open(os.path.join(self.out, "mine.html"), "w", encoding="utf-8") as file:
            file.write("mine")
        self.assertIn("--force", self.make("--out", os.path.join(self.out, "mine.html"), code=2))

    @unittest.skipUnless(CHROMIUM, "Chromium is not here")
    def test_a_browser_shows_fields_values_and_what_keys_do(self):
        self.make("--field", "von_mises,velocity")
        path = os.path.join(self.folder.name, "acted.html")
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.read()[0].replace("</body>", ACTIONS + "</body>"))
        document, console = read_in_chromium(path, self.folder.name)
        self.assertEqual([line for line in console if "rror" in line], [])
        seen = json.loads(re.search(r'data-seen="(.*?)"', document)[1].replace("&quot;", '"'))
        last = len(self.run_.fields.times) - 1
        self.assertIn("von Mises", seen[0])
        self.assertRegex(seen[1], r"^(block|plate): [\d.e+-]+$")
        self.assertIn(f"(frame {last})", seen[2])
        self.assertIn("speed", seen[3])
        self.assertRegex(seen[4], r"^(block|plate): [\d.e+-]+$")
        self.assertIn("(frame 0)", seen[5])
        self.assertEqual(seen[6], "3")


if __name__ == "__main__":
    unittest.main()
