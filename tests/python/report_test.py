"""percuss report: report_test.py ROOT PERCUSS. Exit code 77 (skipped) without NumPy, h5py or Matplotlib.

Pictures are tested where VTK is, the interactive view where three.js is, and the page in Chromium where that is.
"""

import base64
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from html.parser import HTMLParser
from types import SimpleNamespace

from given import require

require("h5py", "matplotlib", "numpy")

import h5py
import numpy as np

from page_tools import CHROMIUM, HAS_DISPLAY, HAS_VTK, PERCUSS, read_in_chromium, read_surface  # noqa: E402
import percuss  # noqa: E402
import sample_run  # noqa: E402
from tool_command import call_tool  # noqa: E402
from percuss.results.converted import OF_SUMMARY, convert_run  # noqa: E402
from percuss.results.deck import Deck  # noqa: E402
from percuss.results.history import History  # noqa: E402
from percuss.results.units import BadUnits, Units  # noqa: E402
from percuss.report.answers import (find_peaks_of_forces, is_resolved, judge_trust, list_changes, list_changes_for_forces,  # noqa: E402
                               suggest_forces, describe_events, describe_forces, describe_relaxation)
from percuss.report.comparison import compare_numbers, find_history_differences  # noqa: E402
from percuss.report.findings import BAD, GOOD, LOOK, find_findings  # noqa: E402
from percuss.report.forces import find_balances, find_force, find_impulse, find_momentum_balances, list_forces, make_balance_table  # noqa: E402
from percuss.report.markup import show_deck  # noqa: E402
from percuss.report.motion import find_motions  # noqa: E402
from percuss.report.pictures import Worst, differ  # noqa: E402
from percuss.report.scene import flatten, make_relaxation_table  # noqa: E402
from percuss.report.signals import find_filtered_peak, make_accelerometers_table  # noqa: E402
from percuss.view.reduce import pack_view
from percuss.view.surface import read_library  # noqa: E402
from percuss.report.welds import find_use, make_welds_table, describe_welds  # noqa: E402



class Page(HTMLParser):
    """Checks that elements are closed in their order, and keeps ids and addresses."""

    VOID = {"meta", "link", "img", "input", "br", "use", "path", "rect"}

    def __init__(self, text):
        super().__init__()
        self.open, self.faults, self.ids, self.addresses = [], [], [], []
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        if "id" in values and "svg" not in self.open:
            self.ids.append(values["id"])
        self.addresses += [values[key] for key in ("src", "href", "xlink:href") if key in values]
        if tag not in self.VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attributes):
        if tag in self.VOID or "svg" in self.open:
            self.addresses += [value for key, value in attributes if key in ("src", "href", "xlink:href")]

    def handle_endtag(self, tag):
        if tag in self.VOID:
            return
        if not self.open or self.open.pop() != tag:
            self.faults.append(tag)


def change_summary(folder, change):
    path = os.path.join(folder, "summary.json")
    with open(path, encoding="utf-8") as file:
        summary = json.load(file)
    change(summary)
    with open(path, "w", encoding="utf-8") as file:
        json.dump(summary, file)


class OfARun(unittest.TestCase):
    """What both classes below share: a run, and copies of its results."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.out = sample_run.run(PERCUSS, cls.folder.name)
        cls.deck = os.path.join(cls.folder.name, "deck.yaml")

    def copy(self, name):
        folder = os.path.join(self.folder.name, name)
        shutil.copytree(self.out, folder)
        return folder


class Report(OfARun):
    def report(self, *arguments, **environment):
        if not environment:
            return call_tool("report", *arguments)
        return subprocess.run([sys.executable, "-m", "percuss", "report", *arguments], capture_output=True, text=True, timeout=250,
                              env=dict(os.environ, **environment))

    def make(self, *arguments, **environment):
        path = os.path.join(self.folder.name, "page.html")
        done = self.report(*arguments, "--out", path, **environment)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(path, encoding="utf-8") as file:
            return file.read()

    def check(self, text):
        """The page is whole and takes nothing from elsewhere."""
        page = Page(text)
        self.assertEqual((page.faults, page.open), ([], []))
        self.assertEqual(len(set(page.ids)), len(page.ids), page.ids)
        outside = [a for a in page.addresses if not a.startswith(("#", "data:"))]
        self.assertEqual(outside, [])
        self.assertLess(len(text), 5e6)

    def expect(self, text, *words):
        for word in words:
            self.assertTrue(word in text, word)

    def test_is_one_page_about_the_run(self):
        text = self.make(self.out, "--no-pictures")
        self.check(text)
        self.expect(text, "A block falls on a plate &amp; &lt;wall&gt;", percuss.read(self.out).summary["state_hash"],
                    "16 quadrilaterals", "8 hexahedra", "j2_plasticity", "[hourglass_energy]", "yield_stress: 400000000.0",
                    "controlled by block", "force of the rigid walls in z", "Largest von Mises stress", "Largest and least values")
        self.assertNotIn("<wall>", text)
        if read_library():
            self.expect(text, "OrbitControls", "id=surface-data")

    def test_converts_to_the_units_that_are_asked_for(self):
        """The deck is in m, kg, s: 50 m/s are 50000 mm/s, 0.0628 kg are 6.28e-5 t, and a joule is 1000 mJ."""
        text = self.make(self.out, "--no-pictures", "--units", "mm, t, s", "--plot", "last(kinetic)")
        self.check(text)
        self.expect(text, "Units: mm, t, s.", "those of the deck: m, kg, s", "20 x 20 x 20 mm", "6.28e-05 t", "mean velocity from 5e+04 to", "mm/s",
                    "kinetic energy went from 78.5 J", "youngs_modulus 2e+11")
        run = percuss.read(self.out)
        converted = convert_run(run, "mm, t, s")
        for frame in range(len(run.fields.times)):
            np.testing.assert_allclose(converted.fields.positions(frame), 1e3 * run.fields.positions(frame), rtol=1e-15)
            np.testing.assert_allclose(converted.fields.values("von_mises", frame), 1e-6 * run.fields.values("von_mises", frame), rtol=1e-12)
        self.assertEqual([converted.fields.unit_of(name) for name in ("von_mises", "velocity", "equivalent_plastic_strain")], ["MPa", "mm/s", ""])
        self.assertEqual(converted.fields.walls_at(0)[0][0].tolist(), [0, 0, -2])
        self.assertAlmostEqual(converted.summary["energy"]["kinetic"], 1e3 * run.summary["energy"]["kinetic"])
        self.assertAlmostEqual(converted.summary["momentum"]["linear"][2], run.summary["momentum"]["linear"][2])
        self.assertEqual(converted.summary["energy"]["error"], run.summary["energy"]["error"])
        self.assertEqual(converted.summary["time"], run.summary["time"])
        fast = convert_run(run, "mm, kg, ms")
        self.assertAlmostEqual(fast.fields.times[-1], 1e3 * run.fields.times[-1])
        self.assertAlmostEqual(fast.warnings[0]["time"], 1e3 * run.warnings[0]["time"])
        self.assertIs(convert_run(run, "m, kg, s"), run)

    def test_summaries_have_no_key_with_a_dimension_that_is_not_converted(self):
        run = percuss.read(self.out)
        known = set(OF_SUMMARY)
        here = {key for key, value in flatten(run.summary) if isinstance(value, float) or isinstance(value, list) and value and isinstance(value[0], float)}
        without = {"grind_ns", "setup_s", "loop_s", "earlier.setup_s", "earlier.loop_s", "mass.share", "dt.gain", "relaxation.kinetic_ratio", "relaxation.preload_error", "energy.error",
                   "momentum.linear_error", "momentum.angular_error", "peak_bytes"}
        others = {key for key in here if not key.startswith(("phases_s.", "earlier.phases_s.", "skipped.", "balance.", "messages.", "decomposition.", "deck."))}
        self.assertEqual(others - without - known, set())
        self.assertEqual(known - here, set())

    def test_refuses_units_that_it_cannot_convert_to(self):
        done = self.report(self.out, "--units", "mm")
        self.assertEqual((done.returncode, "is no system of units" in done.stderr), (2, True), done.stderr)
        with self.assertRaisesRegex(BadUnits, "the deck names no units"):
            convert_run(SimpleNamespace(folder="out", units=None), "mm, kg, ms")

    def test_shows_pictures_of_start_worst_and_end(self):
        if not (HAS_VTK and HAS_DISPLAY):
            self.skipTest("no VTK or no display")
        text = self.make(self.out, "--no-view", "--field", "velocity", "--view", "-30:10")
        self.check(text)
        pictures = [base64.b64decode(p) for p in re.findall(r"data:image/jpeg;base64,([^']+)'", text)]
        self.assertIn(len(pictures), (2, 3))  # the worst may be the start or the end
        self.assertTrue(all(p[:2] == b"\xff\xd8" for p in pictures))
        self.assertNotEqual(pictures[0], pictures[-1])
        self.assertRegex(text, r"(?i)worst( and end)?: t = [\d.]+ \S+, frame \d+; largest speed: [\d.]+ m/s in node \d+")

    def test_names_no_worst_frame_of_the_number_of_the_part(self):
        text = self.make(self.out, "--no-view", "--no-pictures", "--field", "part")
        self.assertNotIn("argest part", text)

    def test_shows_the_worst_part_alone_where_others_hide_it(self):
        if not (HAS_VTK and HAS_DISPLAY):
            self.skipTest("no VTK or no display")
        text = self.make(self.out, "--no-view", "--field", "von_mises", "--view", "-30:10")
        worst = Worst(percuss.read(self.out).fields, "von_mises")
        self.assertIn(worst.part, ("block", "plate"))
        self.assertIn(f"The same without other parts: {worst.part}", text)
        pictures = re.findall(r"data:image/jpeg;base64,([^']+)'", text)
        self.assertTrue(differ(pictures[-2], pictures[-1]))
        self.assertFalse(differ(pictures[0], pictures[0]))

    def test_begins_with_the_curves_and_numbers_that_are_asked_for(self):
        text = self.make(self.out, "--no-pictures", "--no-view", "--plot", "lost = first(kinetic) - last(kinetic)", "--plot", "momentum_?",
                         "--plot", "speed of <it> = sqrt(2 * kinetic / 0.0628 / 1)", "--x", "change(time)")
        kinetic = percuss.read(self.out).history["kinetic"]
        start = text.index("id=curves")
        self.assertLess(text.index("id=short"), start)
        self.assertLess(start, text.index("id=first"))
        section = text[start : text.index("id=first")]
        self.assertIn(f"{kinetic[0] - kinetic[-1]:.6g} J", section)
        self.assertEqual(section.count("<figure>"), 2)
        self.assertIn("peed of &lt;it&gt;", section)
        self.assertNotIn("id=curves", self.make(self.out, "--no-pictures", "--no-view"))
        for words, near in (("--plot kinetik", "did you mean kinetic?"), ("--plot mex(kinetic)", "did you mean max?"),
                            ("--plot kinetic --x tyme", "did you mean time?")):
            done = self.report(self.out, "--no-pictures", "--no-view", *words.split(), "--out", os.path.join(self.folder.name, "none.html"))
            self.assertEqual(done.returncode, 2)
            self.assertIn(near, done.stderr)

    def test_says_what_is_missing_and_goes_on(self):
        old = self.copy("old")
        change_summary(old, lambda summary: summary.pop("deck"))
        text = self.make(old, "--no-pictures", PERCUSS_THREE="/nowhere")
        self.check(text)
        self.expect(text, "needs three.js", "values of the checkpoint")
        bare = self.copy("bare")
        for name in ("fields.vtkhdf", "history.csv", "checkpoint.h5", "checkpoint_previous.h5", "run_deck.yaml"):
            os.remove(os.path.join(bare, name))
        change_summary(bare, lambda summary: summary.pop("deck"))
        text = self.make(bare)
        self.check(text)
        self.expect(text, "There are no fields", "There is no history", "The deck is not known")
        done = self.report(self.out, "--field", "colour", "--no-view")
        self.assertEqual(done.returncode, 2)
        self.assertIn("there is no field 'colour'", done.stderr)
        self.assertEqual(self.report(self.folder.name).returncode, 2)

    def test_compares_runs(self):
        same, other = self.copy("same"), os.path.join(self.folder.name, "softer")
        if not os.path.exists(other):
            sample_run.run(PERCUSS, self.folder.name, "--set", "materials.steel.yield_stress=200e6", name="softer")
        text = self.make(self.out, same, "--no-pictures", "--no-view")
        self.check(text)
        self.expect(text, "Same bits", "All results in summary.json are equal", "Every column is equal")
        text = self.make(self.out, other, "--no-pictures", "--no-view")
        self.check(text)
        self.expect(text, "Other bits", "energy.internal", "History: softer against out",
                    "yield_stress: 200000000.0")

    def test_tells_forces_and_balances(self):
        out = os.path.join(self.folder.name, "forces")
        if not os.path.exists(out):
            forces = "[{name: hit, contact: [block, all]}, {name: back, contact: [plate, block]}, {name: clamp, support: plate/x_min}]"
            sample_run.run(PERCUSS, self.folder.name, "--set", f"output.history.forces={forces}", name="forces")
        text = self.make(out, "--no-pictures", "--no-view")
        self.check(text)
        self.expect(text, "largest resultant", "largest area", "largest pressure", "contact block and all", "support plate/x_min", "impulse of hit", "in balance",
                    "work of contact by all pairs", "momentum z of all parts")
        history = percuss.read(out).history
        self.expect(text, f"{np.nanmax(history['area:hit']):.4g}", f"{np.nanmax(history['pressure:hit']):.4g}")
        self.assertEqual(list_forces(history), ["hit", "back", "clamp"])
        size = np.linalg.norm(find_force(history, "hit"), axis=1)
        peak = next(peak for peak in find_peaks_of_forces(percuss.read(out)) if peak[0] == "hit")
        self.assertEqual(peak, ("hit", "contact block and all", size.max(), history["time"][size.argmax()], True))
        self.expect(text, "In short", "hit (contact block and all)", "mean since the row before", "Motion of parts")
        change = history["momentum_z:block"][-1] - history["momentum_z:block"][0]
        self.assertAlmostEqual(find_impulse(history, "hit")[2] / change, 1, places=10)  # nothing else acts on the block
        self.assertLess(max(difference for _, _, _, difference, _ in find_balances(history)), 1e-10)

    def test_blocks_are_no_further_parts(self):
        history = History(["time", "kinetic", "kinetic:bar", "kinetic:core"], [[0, 2, 2, 1], [1, 3, 3, 1]],
                          sidecar={"kinetic:core": {"meaning": "kinetic energy of block 'core'"}})
        self.assertEqual([difference for _, _, _, difference, _ in find_balances(history)], [0])

    def test_says_where_histories_part(self):
        same, other = self.copy("bytes"), self.copy("parted")
        path = os.path.join(other, "history.csv")
        with open(path, encoding="utf-8") as file:
            rows = file.read().splitlines()
        values = rows[3].split(",")
        values[rows[0].split(",").index("kinetic")] = "1"
        rows[3] = ",".join(values)
        with open(path, "w", encoding="utf-8") as file:
            file.write("\n".join(rows) + "\n")
        text = self.make(self.out, same, other, "--no-pictures", "--no-view")
        self.expect(text, "history.csv of " + same + " has the same bytes", f"{other} differs first in row 3, at t = {values[0]}, in kinetic.")

    def test_reads_in_chromium_without_an_error(self):
        if not CHROMIUM or not read_library():
            self.skipTest("no Chromium or no three.js")
        self.make(self.out, "--no-pictures")
        page = os.path.join(self.folder.name, "page.html")
        text, console = read_in_chromium(page, self.folder.name)
        self.assertEqual(console, [])
        self.assertIn('data-ready="yes"', text)
        self.assertIn("Drag turns", text)


class Findings(OfARun):
    """Of summaries that were changed."""

    def find(self, change):
        name = f"changed{self.id()}{len(os.listdir(self.folder.name))}"
        folder = self.copy(name)
        change_summary(folder, change)
        return find_findings(percuss.read(folder))

    def level_of(self, findings, words):
        return next(finding.level for finding in findings if words in finding.text)

    def test_are_good_where_all_is_well(self):
        def calm(summary):
            summary["energy"].update(hourglass=0, error=1e-9, contact=0)
            summary["warnings"] = []

        levels = {finding.level for finding in self.find(calm) if "still changes" not in finding.text}
        self.assertEqual(levels, {GOOD})

    def test_say_why_a_large_share_of_little_energy_is_good(self):
        def rest(summary):
            summary["energy"].update(internal=2e-4 * summary["energy"]["initial"], hourglass=1e-4 * summary["energy"]["initial"])

        findings = self.find(rest)
        self.assertEqual(self.level_of(findings, "Hourglass energy is 50 %"), GOOD)
        self.assertEqual(self.level_of(findings, "but below 0.1 % of the largest energy"), GOOD)

    def test_judge_what_is_beyond_a_limit(self):
        def spoil(summary):
            summary["energy"].update(error=0.02, contact=0.1 * summary["energy"]["initial"])
            summary["momentum"]["linear_error"] = 1e-3
            summary["dt"]["min"] = summary["dt"]["max"] / 20
            summary["mass"]["share"] = 0.5
            summary["eroded"]["elements"] = 6

        findings = self.find(spoil)
        for words in ("Energy is balanced to 0.02", "Normal contact has added 10 %", "Linear momentum is balanced to 0.001",
                      "The step went from", "Mass scaling added 50 %", "6 elements (25 %) failed", "Warning [hourglass_energy]"):
            self.assertEqual(self.level_of(findings, words), LOOK, words)
        self.assertFalse(any(finding.text.startswith("Hourglass energy is") for finding in findings))  # the warning says it
        self.assertEqual(self.level_of(self.find(lambda summary: summary["warnings"].clear()), "Hourglass energy is"), LOOK)
        self.assertEqual(findings[-1].level, GOOD)
        lossy = self.find(lambda summary: summary["energy"].update(contact=-0.1 * summary["energy"]["initial"]))
        self.assertEqual(self.level_of(lossy, "Normal contact has taken 10 %"), LOOK)
        findings = self.find(lambda summary: summary["energy"].update(error=0.5))
        self.assertEqual(self.level_of(findings, "Energy is balanced"), BAD)
        self.assertEqual(findings[0].level, BAD)

    def test_do_not_call_lost_what_springs_of_contact_hold(self):
        folder = self.copy("springs")
        path = os.path.join(folder, "history.csv")
        with open(path, encoding="utf-8") as file:
            rows = file.read().splitlines()
        stored = 0.1 * percuss.read(folder).summary["energy"]["initial"]
        place = rows[0].split(",").index("contact_stored")
        for i, row in enumerate(rows[1:], 1):
            cells = row.split(",")
            rows[i] = ",".join([*cells[:place], repr(stored), *cells[place + 1:]])
        with open(path, "w", encoding="utf-8") as file:
            file.write("\n".join([*rows, ""]))
        change_summary(folder, lambda summary: summary["energy"].update(contact=-stored))
        run = percuss.read(folder)
        self.assertFalse(any("Normal contact has" in finding.text for finding in find_findings(run)))
        text = " ".join(describe_events(run))
        self.assertIn("springs of contact", text)
        self.assertNotIn("in normal contact", text)

    def test_lead_to_a_verdict_and_to_what_to_change(self):
        def spoil(summary):
            summary["energy"].update(error=0.02, hourglass=0)
            summary["warnings"] = [{"rule": "friction", "text": "mu is 3 (rubber has 1.5): check it", "place": "deck.yaml:3:4"}]

        run = percuss.read(self.out)
        findings = self.find(spoil)
        self.assertRegex(judge_trust(run, findings), r"^With care: .* \d points? below")
        self.assertIn("Check it (friction, deck.yaml:3:4).", list_changes(findings))
        self.assertIn("Find the time at which energy_error of the history grows, and lower time.step_scale.", list_changes(findings))
        self.assertRegex(judge_trust(run, self.find(lambda summary: summary.update(status="failed", error="it burst."))), "^No: The run failed: it burst.")
        calm = [finding for finding in findings if finding.level == GOOD]
        self.assertRegex(judge_trust(run, calm), "^As far as balances show, yes")
        self.assertEqual(list_changes(calm), [])

    def test_tell_where_the_energy_went_and_which_forces_to_ask_for(self):
        run = percuss.read(self.out)
        start, end = (run.history["kinetic"][row] for row in (0, -1))
        self.assertIn(f"In 200 \u00b5s the kinetic energy went from {start:.4g} J to {end:.4g} J.", describe_events(run)[0])
        self.assertIn("every: 1e-06\n    forces:\n      - {name: force_on_block, contact: [block, all]}\n      - {name: support_0, support: plate/x_min}\n",
                      suggest_forces(run))
        self.assertEqual([(peak[0], peak[-1]) for peak in find_peaks_of_forces(run)], [("wall_force", False)])

    def test_name_all_that_the_energy_became(self):
        def lose(summary):  # in contact, what the motion at the end has less
            energy = summary["energy"]
            energy.update(contact=energy["contact"] - 0.25 * energy["kinetic"], kinetic=0.75 * energy["kinetic"])

        folder = self.copy("lost")
        change_summary(folder, lose)
        run = percuss.read(folder)
        text = next(text for text in describe_events(run) if "kinetic energy went" in text)
        size = {"J": 1, "mJ": 1e-3, "kJ": 1e3}
        energies = [float(number) * size[unit] for number, unit in re.findall(r"([\d.]+) (m?k?J)\b", text)]
        start, others = energies[0], energies[1:]
        self.assertIn("lost in normal contact", text)
        self.assertAlmostEqual(sum(others), start, delta=0.005 * start)

    def test_tell_how_each_part_moved(self):
        run = percuss.read(self.out)
        block = next(motion for motion in find_motions(run.fields) if motion.part == "block")
        nodes = np.unique(run.fields.hexahedra[run.fields.part == run.fields.part_names.index("block")])
        np.testing.assert_allclose(block.moved, (run.fields.positions(-1) - run.fields.positions(0))[nodes].mean(axis=0))
        self.assertEqual(block.speeds[0], 50)
        text = next(text for text in describe_events(run) if text.startswith("block: "))
        self.assertIn(f"moved {1e3 * np.linalg.norm(block.moved):.4g} mm along -z; ", text)
        self.assertIn(f"mean velocity from 50 to {block.speeds[1]:.4g} m/s", text)

    def test_tell_the_shape_of_a_part_without_its_rotation(self):
        fields = SimpleNamespace(part_names=["rod", "wire"], part=np.array([0, 1]), names=lambda: {}, alive=lambda frame: np.ones(2, dtype=bool),
                                 hexahedra=np.array([[0, 1, 2, 3, 4, 5, 6, 7], [8, 9, 9, 9, 8, 9, 9, 9]]))
        box = np.array([[x, y, z] for x in (0, 3) for y in (0, 2) for z in (0, 1)], dtype=float)
        wire = np.array([[0, 0, 5], [1, 0, 5]], dtype=float)
        turn = np.array([[0.8, -0.6, 0], [0.6, 0.8, 0], [0, 0, 1]])  # by 36.87 degrees about z
        fields.positions = lambda frame: np.concatenate([(box * [1.5, 1, 1]) @ turn.T + [7, 0, 0] if frame else box, wire])
        rod, wire = find_motions(fields)
        self.assertAlmostEqual(rod.turned, np.degrees(np.arccos(0.8)), places=9)
        np.testing.assert_allclose(rod.start, [3, 2, 1])
        np.testing.assert_allclose(rod.end, [4.5, 2, 1], atol=1e-12)
        self.assertEqual((wire.turned, rod.speeds), (0, None))

    def test_balance_a_rigid_body_with_the_mass_that_the_deck_gives(self):
        deck = {"parts": {"ram": {"rigid": {"mass": 300, "body": "sled"}}, "tube": {}, "base": {"rigid": True}},
                "rigid_sets": {"rim": {"nodes": "tube/x_min"}}, "output": {"history": {"forces": [{"name": "hit", "contact": ["ram", "all"]}]}}}
        names = ["time", "fx:hit", "fy:hit", "fz:hit", "momentum_x:ram", "momentum_y:ram", "momentum_z:ram", "kinetic", "kinetic:ram", "kinetic:tube"]
        table = np.array([[0, 0, 0, 0, 0, 0, -3000, 15000, 15000, 0], [2, 0, 0, 150, 0, 0, -2700, 12650, 12150, 500]], dtype=float)
        run = SimpleNamespace(history=History(names, table), deck=Deck(deck))
        self.assertEqual(find_momentum_balances(run), [("hit", 300, 300, 0, "in balance")])
        self.assertRegex(make_balance_table(run), "kinetic of all parts.*in balance")
        # Masses of sets are in no part.
        deck["rigid_sets"]["rim"]["mass"] = 20
        table[1, 6] = -2720
        self.assertEqual([words for *_, words in find_momentum_balances(run)], ["the rest is of supports, loads and masses of rigid_sets"])
        self.assertNotIn("kinetic of all parts", make_balance_table(run))

    def test_tell_whether_rows_resolve_a_peak(self):
        def is_shown(force):
            table = np.column_stack([np.arange(len(force)), force, np.zeros((len(force), 2))])
            return is_resolved(History(["time", "fx:hit", "fy:hit", "fz:hit"], table), "hit")

        self.assertTrue(is_shown([0, 5, 8, 6, 0]))
        self.assertFalse(is_shown([0, 8, 6, 5, 0]))
        self.assertFalse(is_shown([0, 5, 8, 3, 0]))
        self.assertTrue(is_shown([0, 5, 8]))

    def test_of_forces_lead_to_what_to_change(self):
        out = sample_run.run(PERCUSS, self.folder.name, "--set", "output.history.forces=[{name: hit, contact: [block, plate]}]", name="hit")
        with open(os.path.join(out, "history.csv"), encoding="utf-8") as file:
            names, *rows = (line.split(",") for line in file.read().splitlines())
        for row, force in zip(rows, [0] * (len(rows) - 4) + [9, 2, 2, 2]):
            for axis in "xyz":
                row[names.index(f"f{axis}:hit")] = str(force if axis == "z" else 0)
        with open(os.path.join(out, "history.csv"), "w", encoding="utf-8") as file:
            file.write("\n".join(",".join(row) for row in [names, *rows]) + "\n")
        run = percuss.read(out)
        rows_more_often, to_the_end = list_changes_for_forces(run)
        self.assertIn("Write rows more often (output.history.every)", rows_more_often)
        self.assertIn("hit still acts", to_the_end)
        self.assertIn("2 N in the last row: it still acts.", describe_forces(run)[0])
        self.assertIn("its true height is larger", describe_forces(run)[-1])
        self.assertEqual(list_changes_for_forces(percuss.read(self.out)), [])

    def test_tell_how_a_run_ended(self):
        findings = self.find(lambda summary: summary.update(status="failed", error="element 3 is inverted."))
        self.assertIn("element 3 is inverted", findings[0].text)
        self.assertEqual(self.find(lambda summary: summary.update(status="running"))[0].level, BAD)  # it was killed

    def test_tell_that_the_number_of_steps_has_ended_the_run(self):
        folder = self.copy("short")
        change_summary(folder, lambda summary: summary.update(time=0.029 * summary["end_time"]))
        run, text = percuss.read(folder), "The run was stopped by time.max_steps at 2.9 % of time.end."
        self.assertEqual(self.level_of(find_findings(run), text), LOOK)
        self.assertEqual(describe_events(run)[0], text)
        self.assertIn("Raise time.max_steps or leave it out, and run to the end.", list_changes(find_findings(run)))
        change_summary(folder, lambda summary: summary.pop("end_time"))  # as older versions wrote it
        self.assertEqual(percuss.read(folder).step_limit, "")


class Surface(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.out = sample_run.run(PERCUSS, folder.name)

    def test_has_every_outer_face_in_its_place_and_colour(self):
        fields = percuss.read(self.out).fields
        about, text, told = pack_view(fields, ["von_mises"])
        self.assertEqual((about["faces"], told), (24 + 16, []))
        found = read_surface(about, text)
        points = fields.positions(-1)
        distance = np.linalg.norm(found["places"][-1][found["corners"]].reshape(-1, 1, 3) - points[None], axis=2).min(axis=1)
        self.assertLess(distance.max(), 2 * np.linalg.norm(about["scale"]))
        self.assertFalse(about["erodes"])
        shades = found["fields"][0]
        self.assertTrue(shades.max() <= 254 and shades[-1].max() > 20)

    def test_leaves_out_elements_that_have_failed(self):
        with h5py.File(os.path.join(self.out, "fields.vtkhdf"), "r+") as file:
            root = file["VTKHDF"]
            frames, elements = int(root["Steps"].attrs["NSteps"]), int(root["NumberOfCells"][0])
            alive = np.ones((frames, elements), dtype=np.uint8)
            alive[-1, 0] = 0
            root["CellData/alive"] = alive.reshape(-1)
            root["Steps/CellDataOffsets/alive"] = elements * np.arange(frames)
        fields = percuss.read(self.out).fields
        about, text, _ = pack_view(fields, ["von_mises"])
        self.assertTrue(about["erodes"])
        self.assertEqual(about["faces"], 40 + 3)  # the corner's neighbours show a face each
        visible = read_surface(about, text)["visible"].astype(int)
        self.assertEqual([int(v) for v in visible.sum(axis=1)[[0, -1]]], [40, 40])
        self.assertEqual(Worst(fields, "part").frame, 0)


def make_history(columns, units="m, kg, s"):
    """A history of columns by name."""
    dimensions = {"time": "time", "local_a": "acceleration", "weld_": "force"}
    sidecar = {name: {"dimension": next((value for key, value in dimensions.items() if name.startswith(key)), "-")} for name in columns}
    return History(list(columns), np.stack(list(columns.values()), axis=1), Units(units) if units else None, sidecar)


def make_run(history, deck=None, summary=None):
    return SimpleNamespace(history=history, has_history=True, deck=Deck(deck or {}), units=history.units, summary=summary or {"time": 1.0})


class Signals(unittest.TestCase):
    def make_signal(self, units="m, kg, s"):
        time = np.linspace(0, 0.1, 5001)
        slow, fast = 100 * np.sin(2 * np.pi * 20 * time), 500 * np.sin(2 * np.pi * 5000 * time)
        return make_history({"time": time, "local_ax:chest": slow + fast, "local_ay:chest": 0 * time, "local_az:chest": 0.5 * slow}, units)

    def test_peaks_are_those_behind_the_filter(self):
        peak, time, parts = find_filtered_peak(self.make_signal(), "chest")
        self.assertAlmostEqual(peak, 100 * 1.25**0.5, delta=0.5)
        self.assertLess(min(abs(time - top) for top in (0.0125, 0.0375, 0.0625, 0.0875)), 5e-4)
        self.assertAlmostEqual(parts[2], 50, delta=0.3)
        table = make_accelerometers_table(make_run(self.make_signal()))
        for text in ("<td>chest</td>", "CFC 180", "<td class=number>11.4"):  # in g
            self.assertIn(text, table)
        self.assertIn("<td class=number>577.7 m/s²</td></tr>", table)  # without filter

    def test_an_end_within_a_vibration_gives_no_peak_and_an_impact_at_time_0_keeps_its_own(self):
        time = np.linspace(0, 0.02, 2001)
        vibration = 500 * np.sin(2 * np.pi * 5025 * time)  # it ends at its largest value
        columns = {"time": time, **{f"local_a{axis}:chest": 0 * time for axis in "yz"}}
        peak, _, _ = find_filtered_peak(make_history({**columns, "local_ax:chest": vibration}), "chest")
        self.assertLess(peak, 20)  # of half a wave that nothing follows
        pulse = np.where(time < 0.01, 100 * np.sin(np.pi * time / 0.01), 0)
        peak, when, _ = find_filtered_peak(make_history({**columns, "local_ax:chest": pulse}), "chest")
        self.assertAlmostEqual(peak, 100, delta=3)
        self.assertAlmostEqual(when, 0.005, delta=2e-4)

    def test_what_cannot_be_filtered_is_told(self):
        self.assertIn("chest: the deck names no units", make_accelerometers_table(make_run(self.make_signal(units=None))))
        time = np.linspace(0, 0.1, 11)
        coarse = make_history({"time": time, **{f"local_a{axis}:chest": time for axis in "xyz"}})
        self.assertIn("chest: samples every 0.01 s are too far apart for CFC 180", make_accelerometers_table(make_run(coarse)))
        self.assertEqual(make_accelerometers_table(make_run(make_history({"time": time}))), "")


class Welds(unittest.TestCase):
    def make(self, failed=2, **more):
        time = np.linspace(0, 1, 6)
        forces = {"seam_1": ([0, 3, 4, 0, 0, 0], [0, 1, 0, 0, 0, 0]), "seam_2": ([0, 1, 2, 3, 0, 0], [0, 5, 5, 5, 0, 0]),
                  "seam_3": ([0, 3.2, 1, 1, 1, 1], [0, 0, 0, 0, 0, 0]), "seam_4": ([0, 0, 0.4, 0, 0.4, 0.1], [0] * 6), **more}
        columns = {"time": time, "welds_failed": np.array([0, 0, 0, min(failed, 1), failed, failed], dtype=float)}
        for name, (normal, shear) in forces.items():
            columns[f"weld_normal:{name}"], columns[f"weld_shear:{name}"] = np.array(normal, dtype=float), np.array(shear, dtype=float)
        return make_run(make_history(columns), {"welds": {"seam": {"failure": {"normal": 4, "shear": 6}}}})

    def test_that_failed_and_those_near_to_it_are_told(self):
        texts = describe_welds(self.make(), lambda run, time: f"{time:g} s")
        self.assertEqual(texts[0], "2 welds failed, the first by t = 0.6 s (seam_1), the last by t = 0.8 s (seam_2).")
        self.assertEqual(texts[1], "Of the welds that hold, seam_3 came nearest to its failure: 0.64 of it at t = 0.2 s.")
        table = make_welds_table(self.make())
        self.assertIn("<td>seam_2</td><td>failed</td>", table)
        self.assertIn("<td>seam_3</td><td>holds</td>", table)
        self.assertNotIn("seam_4", table)

    def test_without_force_at_the_end_is_not_failed(self):
        run = self.make(seam_5=([0, 3.9, 0, 0, 0, 0], [0] * 6))  # the count does not rise when its force ends
        self.assertEqual(describe_welds(run, lambda run, time: f"{time:g} s")[0],
                         "2 welds failed, the first by t = 0.6 s (seam_1), the last by t = 0.8 s (seam_2).")  # fmt: skip
        self.assertIn("<td>seam_5</td><td>without force at the end</td>", make_welds_table(run))

    def test_no_more_have_failed_than_are_counted(self):
        texts, table = describe_welds(self.make(failed=1), lambda run, time: f"{time:g} s"), make_welds_table(self.make(failed=1))
        self.assertEqual(texts[0], "1 weld failed, the first by t = 0.6 s (seam_2).")  # which came nearer
        self.assertIn("<td>seam_2</td><td>failed</td>", table)
        self.assertIn("<td>seam_1</td><td>without force at the end</td>", table)
        table = make_welds_table(self.make(failed=0))
        self.assertIn("<td>seam_1</td><td>without force at the end</td>", table)
        self.assertNotIn("<td>failed</td>", table)

    def test_that_fail_without_columns_are_counted(self):
        self.assertIn("1 more have failed that have no columns", make_welds_table(self.make(failed=3)))

    def test_exponents_are_those_of_the_deck(self):
        self.assertAlmostEqual(float(find_use({"normal": 4, "normal_exponent": 1, "shear": 5}, np.array([-2.0]), np.array([2.0]))[0]), 0.5 + 0.16)
        self.assertIsNone(find_use({"time": 1}, np.array([1.0]), np.array([1.0])))

    def test_nothing_is_told_of_a_run_without_welds(self):
        run = make_run(make_history({"time": np.linspace(0, 1, 3)}))
        self.assertEqual((describe_welds(run, None), make_welds_table(run)), ([], ""))


class Relaxation(unittest.TestCase):
    SUMMARY = {"time": 1.0, "relaxation": {"state": "settled", "damped_steps": 4310, "kinetic_ratio": 8e-7, "scale": 2.0, "frequency": 300.0,
                                           "energy": 1.5, "preload_error": 2e-5, "contact_stored": 0.0}}
    DECK = {"start": {"relaxation": {}, "preload": {"bolt": {"part": "shank", "force": 4e4}}}}

    def test_is_told_with_its_residual_and_preloads(self):
        run = make_run(make_history({"time": np.linspace(0, 1, 3)}), self.DECK, self.SUMMARY)
        self.assertEqual(describe_relaxation(run), ["Before time 0 the relaxation settled in 4,310 steps, with 8e-07 of the energy left as motion; "
                                                "preloads are reached to 2e-05 of their forces."])
        table = make_relaxation_table(run)
        for text in ("<td>damped steps</td><td>4,310</td>", "8e-07 (tolerance 1e-06)", "preload bolt of shank", "40000 N", "2e-05 of its force"):
            self.assertIn(text, table)

    def test_is_not_told_where_there_is_none(self):
        run = make_run(make_history({"time": np.linspace(0, 1, 3)}), {}, {"relaxation": {"state": ""}})
        self.assertEqual((describe_relaxation(run), make_relaxation_table(run)), ([], ""))


class Pieces(unittest.TestCase):
    def test_a_deck_keeps_its_text_and_dims_its_comments(self):
        text = show_deck("# first\na: 'no # comment' # yes <b>\nb: x#y\n")
        self.assertIn("<span class=comment># first</span>", text)
        self.assertIn("a: &#x27;no # comment&#x27; <span class=comment># yes &lt;b&gt;</span>", text)
        self.assertIn("b: x#y", text)

    def test_numbers_are_compared_with_the_first(self):
        self.assertEqual(compare_numbers([2.0, 2.0, 2.5]), ["", "+25 %"])
        self.assertEqual(compare_numbers([0, 3]), ["+3"])
        self.assertEqual(compare_numbers(["completed", "failed"]), ["differs"])
        self.assertEqual(compare_numbers([3, 4], is_name=True), ["differs"])

    def test_histories_are_compared_at_the_times_of_the_first(self):
        from percuss.results.history import History

        first = History(["time", "kinetic"], [[0, 4], [1, 2], [2, 0]])
        other = History(["time", "kinetic"], [[0, 4], [2, 2]])
        self.assertEqual(find_history_differences(first, other), [("kinetic", 0.5, 2.0, 0.5)])

    def test_forces_and_energies_come_before_counts_and_noise(self):
        from percuss.results.history import History

        dimensions = {"residual": "1", "folding": "energy", "kinetic": "energy", "core_x": "length", "fx:hit": "force", "momentum_x": "momentum"}
        names = ["time", *dimensions]
        first = History(names, [[0, 1, 1e-20, 4, 1, 8, 2]], sidecar={name: {"dimension": value} for name, value in dimensions.items()})
        other = History(names, [[0, 3, 9e-20, 5, 2, 9, 3]])
        self.assertEqual([name for name, *_ in find_history_differences(first, other)],
                         ["kinetic", "fx:hit", "core_x", "momentum_x", "residual", "folding"])

    def test_a_component_that_is_round_off_is_measured_by_the_whole_vector(self):
        from percuss.results.history import History

        names = ["time", "momentum_x", "momentum_y", "momentum_z"]
        first, other = History(names, [[0, 8, 1e-15, 0]]), History(names, [[0, 8, -1e-15, 0]])
        self.assertEqual(find_history_differences(first, other)[0], ("momentum_y", 2.5e-16, 0.0, 2.5e-16))


if __name__ == "__main__":
    unittest.main()
