#!/usr/bin/env python3
"""What goes in is what a page says, nothing is overwritten, and a run goes on from its end: by the command line."""

import json
import os
import shutil
import subprocess
import tempfile
import threading
import time
import unittest

from given import PERCUSS, require

require("h5py", "matplotlib")

from tool_command import call_tool  # noqa: E402

SCENE = """\
title: Two blocks meet
time: {end: 1.0e-5}
parts:
  one: {box: {size: [0.01, 0.01, 0.01], cells: [2, 2, 2]}, material: soft}
  two: {box: {size: [0.01, 0.01, 0.01], cells: [2, 2, 2]}, at: [0.002, 0, 0.01001], material: soft}
materials: {soft: {model: j2_plasticity, density: 1100, youngs_modulus: 1e9, poissons_ratio: 0.3, yield_stress: 1e7, hardening_modulus: 1e7}}
initial: [{part: two, velocity: [0, 0, -40]}]
contact: {surfaces: all, friction: 0.2}
output: {fields: {every: 0.5e-5, write: [velocity]}, history: {every: 0}}
"""


class OfAFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.put("scene.yaml", SCENE)

    def put(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)

    def path(self, *names):
        return os.path.join(self.folder, *names)

    def read(self, *names):
        with open(self.path(*names), encoding="utf-8", errors="replace") as file:
            return file.read()

    def call(self, *words, code=0):
        """Standard error and output."""
        environment = dict(os.environ, OMP_NUM_THREADS="1", OMP_PROC_BIND="false", PERCUSS_PROGRAM=PERCUSS)
        command = [PERCUSS, *words]
        done = subprocess.run(command, cwd=self.folder, capture_output=True, text=True, timeout=250, env=environment, errors="replace")
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertNotIn("Traceback", done.stderr)
        return done.stderr + done.stdout

    def run_scene(self, deck, out, *words, code=0):
        return self.call("run", deck, "--out", out, "-q", *words, code=code)

    def tool(self, name, *words, code=0):
        done = call_tool(name, *words, folder=self.folder, PERCUSS_PROGRAM=PERCUSS, OMP_NUM_THREADS="1")
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertNotIn("Traceback", done.stderr)
        return done.stderr + done.stdout

    def find_hash(self, folder):
        return json.loads(self.read(folder, "summary.json"))["state_hash"]


class Pages(OfAFolder):
    def test_say_what_was_run_whatever_the_file_of_the_deck_says(self):
        self.run_scene("scene.yaml", "a", "--set", "materials.soft.youngs_modulus=2e9")
        self.run_scene("a/run_deck.yaml", "b")  # whose comments tell of the run before
        self.tool("report", "a", "--no-pictures", "--no-view")
        self.tool("report", "b", "--no-pictures", "--no-view")
        self.assertIn("youngs_modulus 2e+09", self.read("a", "report.html"))
        self.assertIn("--set materials.soft.youngs_modulus=2e9", self.read("a", "report.html"))
        self.assertIn("youngs_modulus 1e+09", self.read("b", "report.html"))
        self.assertNotIn("2e+09", self.read("b", "report.html"))
        self.put("scene.yaml", "changed: since\n")
        self.put("b/run_deck.yaml", "time: {end: 7}\ntitle: another\n")
        self.assertIn("of 1e-05", self.tool("watch", "b"))
        self.assertIn("Two blocks meet", self.tool("watch", "b"))
        deck = json.loads(self.read("a", "summary.json"))["deck"]
        self.assertEqual(deck["values"]["materials"]["soft"]["youngs_modulus"], 2e9)
        self.assertEqual((deck["file"], deck["settings"]), ("scene.yaml", ["materials.soft.youngs_modulus=2e9"]))

    def test_of_a_scene_before_it_runs_have_what_is_set(self):
        self.call("check", "scene.yaml", "--report", "--no-pictures", "--no-view", "--set", "materials.soft.density=1250", "--out", "page.html")
        self.assertIn("density 1250", self.read("page.html"))


class Overwriting(OfAFolder):
    def setUp(self):
        super().setUp()
        self.run_scene("scene.yaml", "a")

    def test_results_and_files_of_others_stay(self):
        summary = self.read("a", "summary.json")
        self.put("mine.html", "mine")
        self.put("mine.svg", "mine")
        pages = ("--no-pictures", "--no-view")
        for words in (("report", "a", *pages), ("plot", "a"), ("preview", "scene.yaml", *pages)):
            for more in ((), ("--force",)):
                self.assertIn("a result of a run", self.tool(*words, *more, "--out", "a/summary.json" if words[0] != "plot" else "a/fields.xdmf2", code=2)
                              if words[0] != "plot" else "a result of a run")
            name = "mine.svg" if words[0] == "plot" else "mine.html"
            self.assertIn("is there already", self.tool(*words, "--out", name, code=2))
            self.assertEqual(self.read(name), "mine")
        self.assertEqual(self.read("a", "summary.json"), summary)
        self.tool("report", "a", *pages, "--out", "mine.html", "--force")
        self.tool("report", "a", *pages, "--out", "mine.html")  # it is its own now
        self.assertIn("is there already", self.call("check", "scene.yaml", "--report", *pages, "--out", "mine.html", code=2))
        self.assertIn("is there already", self.tool("report", "a", *pages, "--out", "scene.yaml", code=2))
        self.assertEqual(self.read("scene.yaml"), SCENE)

    def test_links_are_not_followed(self):
        self.put("victim", "precious")
        for tool, name in (("report", "a/report.html"), ("plot", "a/plot.png")):
            os.symlink(self.path("victim"), self.path(name))
            self.assertIn("this is a link", self.tool(tool, "a", *(["--no-pictures", "--no-view"] if tool == "report" else []), code=2))
        self.assertEqual(self.read("victim"), "precious")
        self.assertTrue(os.path.islink(self.path("a/report.html")))

    def test_plots_and_pages_are_made_again(self):
        for _ in range(2):
            self.tool("plot", "a", "energies")
            self.tool("report", "a", "--no-pictures", "--no-view")
        self.assertEqual([name for name in os.listdir(self.path("a")) if name.endswith(".tmp")], [])

    def test_folders_that_are_none(self):
        os.mkdir(self.path("empty"))
        os.mkdir(self.path("latin"))
        with open(self.path("latin", "summary.json"), "wb") as file:
            file.write("{\"status\": \"gr\u00f6\u00dfe\"".encode("latin-1"))
        for tool in ("report", "plot", "watch", "stop"):
            for folder in ("empty", "latin", "nowhere", "scene.yaml"):
                words = self.tool(tool, folder, code=2)
                self.assertEqual(len(words.strip().splitlines()), 1, words)


class AtTheEnd(OfAFolder):
    def test_a_run_goes_on_from_its_end(self):
        self.run_scene("scene.yaml", "a")
        self.assertIn("t = 1e-05", self.call("info", "a/checkpoint.h5"))
        shutil.copytree(self.path("a"), self.path("b"))
        self.call("run", "scene.yaml", "-q", "--restart", "a", "--set", "time.end=2e-5")
        self.run_scene("scene.yaml", "c", "--restart", "b/checkpoint.h5", "--set", "time.end=2e-5")
        self.assertEqual(self.find_hash("a"), self.find_hash("c"))
        last = [float(word) for word in self.read("a", "history.csv").splitlines()[-1].split(",")]
        self.assertAlmostEqual(last[0], 2e-5)
        self.assertEqual(self.read("a", "history.csv").splitlines()[-1], self.read("c", "history.csv").splitlines()[-1])

    def test_after_a_number_of_steps_it_has_the_bits_of_one_run(self):
        far = ("--set", "time.end=1", "--set", "output.history.every=1e-6", "--set", "output.fields.every=1e-5")
        self.run_scene("scene.yaml", "a", *far, "--set", "time.max_steps=40")
        self.call("run", "scene.yaml", "-q", "--restart", "a", *far, "--set", "time.max_steps=90")
        self.run_scene("scene.yaml", "whole", *far, "--set", "time.max_steps=90")
        self.assertEqual(self.find_hash("a"), self.find_hash("whole"))
        self.assertEqual(self.read("a", "history.csv"), self.read("whole", "history.csv"))

    def test_a_run_of_which_nothing_is_left_is_told(self):
        self.run_scene("scene.yaml", "a")
        told = self.call("run", "scene.yaml", "--restart", "a/checkpoint.h5", "--out", "b")
        self.assertRegex(told, r"nothing is left to compute \(the checkpoint is of t = 1e-05 and step [0-9]+, the end of this run\): raise time.end")
        told = self.call("run", "scene.yaml", "--restart", "a/checkpoint.h5", "--out", "c", "--set", "time.end=2e-5")
        self.assertNotIn("nothing is left", told)

    def test_it_is_told_with_its_size_and_can_be_left_out(self):
        told = self.call("run", "scene.yaml", "--out", "a")
        self.assertRegex(told, r"checkpoint: a/checkpoint.h5, [0-9.]+ MB, of the end: a later time.end and --restart continue the run")
        told = self.call("run", "scene.yaml", "--out", "b", "--set", "output.checkpoint={at_end: false}")
        self.assertNotIn("checkpoint", told)
        self.assertFalse(os.path.exists(self.path("b", "checkpoint.h5")))
        self.call("run", "scene.yaml", "--out", "c", "--set", "output.checkpoint={at_end: false, every: 0.4e-5}")
        self.assertNotIn("t = 1e-05", self.call("info", "c/checkpoint.h5"))

    def test_no_link_at_the_name_of_the_next_checkpoint_is_followed(self):
        self.put("victim", "precious\n")
        os.mkdir(self.path("a"))
        over = threading.Event()

        def put_links():
            while not over.is_set():
                link = self.path("a", "link")
                try:
                    os.symlink(self.path("victim"), link)
                    os.replace(link, self.path("a", "checkpoint.h5.tmp"))
                except OSError:
                    pass
                time.sleep(0.0005)

        thread = threading.Thread(target=put_links)
        thread.start()
        try:
            command = [PERCUSS, "run", "scene.yaml", "--out", "a", "-q", "--force", "--set", "time.end=2e-4", "--set", "output.checkpoint.every=2e-6"]
            done = subprocess.run(command, cwd=self.folder, capture_output=True, text=True, timeout=120, env=dict(os.environ, OMP_NUM_THREADS="1"))
        finally:
            over.set()
            thread.join()
        self.assertIn(done.returncode, (0, 4), done.stderr)  # 4: it says that its file was taken away
        self.assertEqual(self.read("victim"), "precious\n")


NODES = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1, 2)]
ELEMENTS = [(1, 2, 5, 4, 7, 8, 11, 10), (2, 3, 6, 5, 8, 9, 12, 11)]
DECK = """\
time: {{end: 1e-2, max_steps: 5}}
parts: {{p: {{mesh: {{file: {file}}}, material: m}}}}
materials: {{m: {{model: elastic, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0.3}}}}
initial: [{{part: p, velocity: [1, 0, 0]}}]
conditions: [{{nodes: p/{set}, fixed: [x]}}]
"""


def write_keywords(held, name):
    lines = ["*KEYWORD", "*NODE", *(f"{i},{x},{y},{z}" for i, (x, y, z) in enumerate(NODES, 1)), "*PART", "body", "1,1,1",
             "*ELEMENT_SOLID", *(f"{i},1," + ",".join(map(str, e)) for i, e in enumerate(ELEMENTS, 1)),
             "*SET_NODE_LIST_TITLE", name, "7", ",".join(map(str, held)), "*END"]
    return "m.k", "\n".join(lines) + "\n"


def write_abaqus(held, name):
    lines = ["*NODE", *(f"{i},{x},{y},{z}" for i, (x, y, z) in enumerate(NODES, 1)), "*ELEMENT, TYPE=C3D8, ELSET=body",
             *(f"{i}," + ",".join(map(str, e)) for i, e in enumerate(ELEMENTS, 1)), f"*NSET, NSET={name}", ",".join(map(str, held))]
    return "m.inp", "\n".join(lines) + "\n"


def write_gmsh(held, name):
    """Points of a physical group."""
    nodes = [f"{i} {x} {y} {z}" for i, (x, y, z) in enumerate(NODES, 1)]
    elements = [f"{i} 15 2 7 {i} {node}" for i, node in enumerate(held, 1)]
    elements += [f"{len(held) + i} 5 2 1 1 " + " ".join(map(str, e)) for i, e in enumerate(ELEMENTS, 1)]
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", "2", f'0 7 "{name}"', '3 1 "body"', "$EndPhysicalNames",
             "$Nodes", str(len(nodes)), *nodes, "$EndNodes", "$Elements", str(len(elements)), *elements, "$EndElements"]
    return "m.msh", "\n".join(lines) + "\n"


class Meshes(OfAFolder):
    def test_a_restart_with_a_changed_mesh_is_refused_and_says_what_changed(self):
        for write in (write_keywords, write_abaqus, write_gmsh):
            with self.subTest(write.__name__):
                file, text = write((1, 4, 7, 10), "held")
                self.put(file, text)
                self.put("deck.yaml", DECK.format(file=file, set="held"))
                shutil.rmtree(self.path("a"), ignore_errors=True)
                self.run_scene("deck.yaml", "a")
                for held, count in (((3, 6, 9, 12), "other ones, as many as in the checkpoint (4)"), ((1, 4, 7), "3 (4 in the checkpoint)")):
                    self.put(file, write(held, "held")[1])
                    told = self.restart(2)
                    self.assertRegex(told, r"deck\.yaml: error: the mesh differs from that of a/checkpoint\.h5")
                    self.assertIn(f"node set 'p/held': {count}", told)
                self.put(file, text)
                self.restart(0)

    def restart(self, code):
        shutil.rmtree(self.path("b"), ignore_errors=True)
        return self.run_scene("deck.yaml", "b", "--restart", "a/checkpoint.h5", "--set", "time.max_steps=9", code=code)

    def test_places_ids_sets_and_names_that_no_key_uses_count(self):
        file, text = write_keywords((1, 4, 7, 10), "held")
        extra = text.replace("*END", "*SET_NODE_LIST_TITLE\nspare\n8\n2,5\n*SET_SOLID_TITLE\nfirst\n9\n1\n*END")
        self.put(file, extra)
        self.put("deck.yaml", DECK.format(file=file, set="held"))
        self.run_scene("deck.yaml", "a")
        changes = [("spare\n8\n2,5", "spare\n8\n2,6", "node set 'p/spare'"), ("spare\n8", "unused\n8", "node set 'p/spare' (2) is gone"),
                   ("first\n9\n1", "first\n9\n2", "side set 'p/first'"), ("3,2,0,0", "3,2.5,0,0", "nodes: other ones"),
                   ("\n2,1,2,3,6,5", "\n5,1,2,3,6,5", "elements of part 'p'")]
        for old, new, words in changes:
            self.assertEqual(extra.count(old), 1, old)
            self.put(file, extra.replace(old, new))
            self.assertIn(words, self.restart(2))
        self.put(file, "$ a comment\n" + extra)
        self.restart(0)


if __name__ == "__main__":
    unittest.main()
