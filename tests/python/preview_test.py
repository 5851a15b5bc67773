"""percuss check --report and --json: preview_test.py ROOT PERCUSS. Exit code 77 (skipped) without NumPy, h5py, Matplotlib, YAML.

Pictures are tested where VTK is, the interactive view where three.js is, and the page in Chromium where that is.
"""

import base64
import json
import os
import re
import subprocess
import tempfile
import unittest

from given import require

require("h5py", "matplotlib", "numpy", "yaml")

import numpy as np

from page_tools import CHROMIUM, HAS_DISPLAY, HAS_VTK, PERCUSS, read_in_chromium  # noqa: E402
import percuss  # noqa: E402
import sample_run  # noqa: E402
from percuss.preview.marks import find_arrows, find_gap_lines, make_layers  # noqa: E402
from percuss.view.surface import read_library  # noqa: E402
from percuss.preview.trial import Trial, find_frame_size, format_bytes, format_seconds, split_messages  # noqa: E402

ENVIRONMENT = dict(os.environ, OMP_NUM_THREADS="1", OMP_PROC_BIND="false", PERCUSS_PROGRAM=PERCUSS)


class OfADeck(unittest.TestCase):
    """A block of 8 elements lies 0.2 mm above the upper face of a plate of 16 shells, and moves down at 50 m/s."""

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = folder.name
        cls.deck = os.path.join(cls.folder, "deck.yaml")
        with open(cls.deck, "w", encoding="utf-8") as file:
            file.write(sample_run.DECK.format(units="m, kg, s"))

    def call(self, *words):
        return subprocess.run([PERCUSS, *words], capture_output=True, text=True, timeout=250, env=ENVIRONMENT, cwd=self.folder)


class Json(OfADeck):
    def check(self, *options):
        done = self.call("check", self.deck, "--json", *options)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return json.loads(done.stdout)

    def test_tells_parts_with_mass_and_step(self):
        scene = self.check()
        block, plate = scene["parts"]
        self.assertEqual((block["name"], block["material"], block["elements"], block["nodes"]), ("block", "steel", 8, 27))
        self.assertAlmostEqual(block["mass"], 7850 * 0.02**3, places=12)
        self.assertAlmostEqual(plate["mass"], 7850 * 0.06**2 * 0.002, places=12)
        self.assertAlmostEqual(scene["mass"], block["mass"] + plate["mass"], places=12)
        self.assertAlmostEqual(scene["total_mass"], scene["mass"], places=12)
        heavy = self.check("--set", "added_mass=[{nodes: block, mass: 0.05}]")
        self.assertAlmostEqual(heavy["total_mass"], scene["mass"] + 0.05, places=12)
        self.assertEqual(scene["first_step"], min(block["step"], plate["step"]))
        self.assertRegex(block["controlling_element"], r"element \d+ of part 'block'")
        self.assertIn("'block'" if block["step"] < plate["step"] else "'plate'", scene["controlling_element"])
        self.assertEqual(scene["steps"], np.ceil(2e-4 / scene["first_step"]))
        np.testing.assert_allclose((scene["low"], scene["high"]), ((-0.02, -0.02, 0), (0.04, 0.04, 0.0212)), atol=1e-12)

    def test_resolves_what_the_deck_selects(self):
        scene = self.check()
        rows = {item["key"]: item for item in scene["selections"]}
        self.assertEqual(rows["initial.0"]["count"], 27)
        held = rows["conditions.0"]
        self.assertEqual((held["what"], held["where"], held["count"]), ("fixed x, y, z", "plate/x_min", 5))
        self.assertRegex(held["place"], r"deck\.yaml:11:\d+$")
        self.assertEqual(scene["walls"][0]["normal"], [0, 0, 1])
        out = sample_run.run(PERCUSS, self.folder, "--set", "time.max_steps=1")
        places = percuss.read(out).fields.positions(0)[held["nodes"]]
        np.testing.assert_allclose(places[:, 0], -0.02)
        self.assertEqual(len(places), 5)

    def test_tells_gaps_and_overlap(self):
        scene = self.check()
        self.assertEqual(scene["overlap"]["nodes"], [])
        gap = next(g for g in scene["overlap"]["gaps"] if g["part"] != g["other"])
        self.assertAlmostEqual(gap["gap"], 0.0002, places=12)
        overlap = self.check("--set", "parts.block.at=[0, 0, 0.0009]")["overlap"]
        self.assertGreater(len(overlap["nodes"]), 0)
        self.assertAlmostEqual(overlap["deepest"], 0.0001, places=12)
        self.assertEqual({p["part"] for p in overlap["parts"]} | {p["inside"] for p in overlap["parts"]}, {"block", "plate"})

    def test_tells_parts_that_cross(self):
        scene = self.check("--set", "parts.block.at=[0, 0, -0.006]")  # 20 mm high, so that 6 mm are below the middle of the plate
        (crossing,) = scene["overlap"]["crossings"]
        self.assertEqual((crossing["part"], crossing["other"], crossing["contact"]), ("block", "plate", "now"))
        self.assertAlmostEqual(crossing["depth"], 0.006, places=12)
        self.assertAlmostEqual(crossing["at"][2], -0.006, places=12)
        np.testing.assert_allclose(np.array(crossing["places"])[:, 2], 0, atol=1e-12)
        gap = next(g for g in scene["overlap"]["gaps"] if g["part"] != g["other"])
        self.assertAlmostEqual(gap["gap"], -0.006, places=12)
        self.assertIn("crossing_parts", {warning["rule"] for warning in scene["warnings"]})

    def test_has_the_warnings_of_the_text(self):
        options = ("--set", "parts.plate.thickness=0.05", "--set", "contact.friction=3")
        scene, text = self.check(*options), self.call("check", self.deck, *options).stdout
        self.assertGreaterEqual({w["rule"] for w in scene["warnings"]}, {"friction", "shell_thickness"})
        for warning in scene["warnings"]:
            self.assertIn(f"[{warning['rule']}]", text)

    def test_refuses_ranks_and_wrong_decks(self):
        done = self.call("check", self.deck, "--json", "--set", "parts.block.material=stel")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("stel", done.stderr)


class Page(OfADeck):
    def make(self, *options, code=0):
        page = os.path.join(self.folder, "page.html")
        if os.path.exists(page):
            os.remove(page)
        done = self.call("check", self.deck, "--report", "--out", page, *options)
        self.assertEqual(done.returncode, code, done.stderr)
        if not os.path.exists(page):
            return "", done
        with open(page, encoding="utf-8") as file:
            return file.read(), done

    def expect(self, text, *words):
        for word in words:
            self.assertTrue(word in text, word)

    def test_tells_what_a_run_would_be(self):
        text, _ = self.make("--set", "contact.friction=3")
        self.expect(text, "Before the run: A block falls on a plate &amp; &lt;wall&gt;", "steps, predicted", "run time", "memory",
                    "11 frames of", "fixed x, y, z", "plate/x_min", "deck.yaml:11:", "Rigid walls", "Smallest gaps", "[friction]",
                    "--set contact.friction", "initial velocities", "controlled by", "youngs_modulus", "checkpoints")
        self.assertNotIn("<wall>", text)
        self.assertLess(len(text), 5e6)
        outside = [a for a in re.findall(r"(?:src|href)=['\"]([^'\"]+)", text.split("<script")[0]) if not a.startswith(("#", "data:"))]
        self.assertEqual(outside, [])
        if read_library():
            self.expect(text, '"kind": "arrows"', '"kind": "plates"', '"name": "conditions.0: fixed x, y, z"')
        if HAS_VTK and HAS_DISPLAY:
            pictures = [base64.b64decode(p) for p in re.findall(r"data:image/jpeg;base64,([^']+)'", text)]
            self.assertEqual(len(pictures), 2)
            self.assertTrue(all(p[:2] == b"\xff\xd8" for p in pictures))

    def test_writes_beside_the_caller_by_default_and_leaves_nothing_else(self):
        before = set(os.listdir(self.folder))
        done = self.call("check", "--report", self.deck)
        self.assertEqual(done.returncode, 0, done.stderr)
        new = set(os.listdir(self.folder)) - before
        self.assertEqual(new, {f"{os.path.basename(self.folder)}_check.html"})
        os.remove(os.path.join(self.folder, new.pop()))

    def test_draws_overlap_that_the_deck_refuses_and_fails(self):
        text, done = self.make("--set", "contact.overlap=refuse", "--set", "parts.block.at=[0, 0, 0.0009]", code=2)
        self.expect(text, "overlap at the start", "class=bad", "<h3>Overlaps</h3>")
        self.assertIn("overlap", done.stderr)

    def test_draws_parts_that_cross(self):
        text, _ = self.make("--set", "parts.block.at=[0, 0, -0.006]")
        self.expect(text, "<h3>Parts that cross</h3>", "[crossing_parts]", "-0.006 m (they overlap)", "block crosses plate")

    def test_says_what_check_says_of_a_wrong_deck(self):
        text, done = self.make("--set", "parts.block.material=stel", code=2)
        self.assertEqual(text, "")
        self.assertEqual(done.stderr.strip(), self.call("check", self.deck, "--set", "parts.block.material=stel").stderr.strip())

    def test_reads_in_chromium_without_an_error(self):
        if not CHROMIUM or not read_library():
            self.skipTest("no Chromium or no three.js")
        self.make("--set", "parts.block.at=[0, 0, 0.0009]")
        text, console = read_in_chromium(os.path.join(self.folder, "page.html"), self.folder)
        self.assertEqual(console, [])
        self.assertIn('data-ready="yes"', text)
        self.expect(text.split("layers")[1], "overlap at the start", "rigid walls")


class Predictions(OfADeck):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        os.environ.update(OMP_NUM_THREADS="1", OMP_PROC_BIND="false")
        cls.trial = Trial(PERCUSS, cls.deck, [], os.path.join(cls.folder, "trial"))

    def test_sizes_are_those_of_a_whole_run(self):
        out = sample_run.run(PERCUSS, self.folder)
        fields = percuss.read(out).fields
        names = ["velocity", "von_mises", "equivalent_plastic_strain"]
        sizes = {name: (size, how) for name, size, how in self.trial.find_sizes()}
        self.assertTrue(sizes["fields"][1].startswith(f"{len(fields.times)} frames"), sizes)
        # Points, displacement and velocity: three numbers of a node each; two numbers of an element.
        frame = 8 * (3 * 3 * fields.nodes + 2 * fields.elements)
        self.assertEqual(find_frame_size(fields, names), frame)
        self.assertEqual(sizes["fields"][0], len(fields.times) * frame)
        measured = os.path.getsize(os.path.join(out, "history.csv"))
        self.assertTrue(0.5 < sizes["history"][0] / measured < 2, (sizes, measured))
        measured = sum(os.path.getsize(os.path.join(out, name)) for name in ("checkpoint.h5", "checkpoint_previous.h5"))
        self.assertAlmostEqual(sizes["checkpoints"][0] / measured, 1, delta=0.1)

    def test_arrows_are_behind_what_moves(self):
        fields = self.trial.run.fields
        places = fields.positions(0)
        arrows = find_arrows(fields, places)
        along = arrows[:, 1] - arrows[:, 0]
        np.testing.assert_allclose(along[:, :2], 0, atol=1e-15)
        self.assertTrue((along[:, 2] < 0).all())
        np.testing.assert_allclose(arrows[:, 1, 2], 0.0212)  # the upper face of the block, which moves down
        layers = {layer.name: layer for layer in make_layers(self.trial.scene, fields, np.zeros((1, 4, 3)))}
        self.assertEqual(len(layers["conditions.0: fixed x, y, z"].places), 5)

    def test_a_gap_is_drawn_where_parts_are_closest(self):
        fields = self.trial.run.fields
        line = find_gap_lines(self.trial.scene, fields, fields.positions(0))[0]
        self.assertEqual(sorted(line[:, 2]), [0, 0.0012])

    def test_numbers_are_written_for_readers(self):
        self.assertEqual([format_bytes(x) for x in (999, 1500, 2.5e6, 4e12)], ["999 bytes", "1.5 kB", "2.5 MB", "4e+03 GB"])
        self.assertEqual([format_seconds(x) for x in (0.1, 42, 600, 7200, 2e6)], ["less than 1 s", "42 s", "10 min", "2 h", "23 days"])
        text = "deck.yaml:1:2: error: this\n  goes on\ndeck.yaml:3:4: error: that"
        self.assertEqual(split_messages(text), ["deck.yaml:1:2: error: this\n  goes on", "deck.yaml:3:4: error: that"])


if __name__ == "__main__":
    unittest.main()
