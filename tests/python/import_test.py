"""percuss import: import_test.py ROOT PERCUSS."""

import json
import math
import os
import re
import subprocess
import sys
import tempfile
import unittest

import yaml

from given import PERCUSS, ROOT
import import_decks as decks  # noqa: E402
from import_command import call_command  # noqa: E402
from percuss.importing.abaqus.read import read_abaqus_deck  # noqa: E402
from percuss.importing.curves import Curve, integrate, make_time_value, thin_rows  # noqa: E402
from percuss.importing.deck_text import ORDER, format_section, write_deck  # noqa: E402
from percuss.importing.dyna.parameters import Parameters, evaluate  # noqa: E402
from percuss.importing.dyna.read import read_keyword_deck  # noqa: E402
from percuss.importing.fields import parse_integer, parse_real  # noqa: E402
from percuss.importing.ledger import BadInput, Ledger, Place, Status  # noqa: E402
from percuss.importing.mesh_text import list_blocks  # noqa: E402
from percuss.importing.proof import find_card, find_path  # noqa: E402
from percuss.importing.shapes import solid_volume, tet_volume  # noqa: E402
from percuss.importing.solids import collapse  # noqa: E402
from percuss.program import find_program  # noqa: E402

os.environ |= {"OMP_NUM_THREADS": "1", "OMP_PROC_BIND": "false", "PERCUSS_PROGRAM": PERCUSS}
HERE = Place("deck.k", 1)
PROGRAM_SCENE = """\
parts: {block: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, material: steel}}
materials: {steel: {model: elastic, density: 7850, youngs_modulus: 2e11, poissons_ratio: 0.3}}
"""


class InFolder(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(lambda: __import__("shutil").rmtree(self.folder))

    def write(self, text, name="deck.k"):
        path = os.path.join(self.folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    def read(self, text, *allowed):
        """The model of a deck and its ledger."""
        ledger = Ledger(allowed=[word.upper() for word in allowed])
        return read_keyword_deck(self.write(text), ledger), ledger

    def read_abaqus(self, text, *allowed):
        ledger = Ledger(allowed=[word.upper() for word in allowed])
        return read_abaqus_deck(self.write(text, "deck.inp"), ledger), ledger

    def refusals(self, text, *allowed):
        return {entry.card: f"{entry.first}: {entry.text}" for entry in self.read(text, *allowed)[1].list_refused()}

    def accept(self, text, name="deck.k"):
        """The whole way: imported, and its deck checked by the program."""
        for words in (("import", self.write(text, name), "--out", "accepted", "--force"), ("check", "accepted/deck.yaml")):
            done = self.percuss(*words)
            self.assertEqual(done.returncode, 0, done.stderr)

    def fails(self, text, *words):
        with self.assertRaises(BadInput) as caught:
            self.read(text)
        for word in words:
            self.assertIn(word, str(caught.exception))

    def percuss(self, *words):
        if words[0] == "import":
            return call_command(words[1:], self.folder)
        return subprocess.run([PERCUSS, *words], capture_output=True, text=True, timeout=300, cwd=self.folder, check=False)


class Numbers(unittest.TestCase):
    def test_are_those_of_fortran(self):
        for text, value in (("1.5-10", 1.5e-10), ("1D3", 1e3), (".5", 0.5), ("2.", 2.0), ("+1.e+2", 100.0), ("-3", -3.0)):
            self.assertEqual(parse_real(text), value)
        for text in ("", "nan", "inf", "1e999", "1,5", "0x10", "1_000", "--1", "1e", "\u0661"):
            self.assertIsNone(parse_real(text), text)
        self.assertEqual([parse_integer(text) for text in ("7", "2.", "-3", "1.5", "9" * 30, "a")], [7, 2, -3, None, None, None])

    def test_expressions_divide_integers_as_fortran_does(self):
        parameters = Parameters()
        for text, value in (
            ("7/2", 3),
            ("-7/2", -3),
            ("7/2.", 3.5),
            ("2**3**2", 512),
            ("-2**2", -4),
            ("max(1,2.5)*2", 5.0),
            ("mod(7,4)", 3),
        ):
            self.assertEqual(evaluate(text, parameters, HERE), value, text)
        for text, words in (
            ("1/0", "no value .division by zero"), ("(1", "lacks a bracket"), ("1+", "ends too early"), ("sqrt(-1)", "no value .math domain"), ("(-8)**0.5", "a root of a negative"),
            ("a", "'a'|there is no parameter"), ("1e308*10", "has no value"), ("f(1)", "has f.., which is not known"), ("(" * 100 + "1" + ")" * 100, "too many brackets"), ("", "ends too early"),
        ):
            with self.assertRaisesRegex(BadInput, words, msg=text):
                evaluate(text, parameters, HERE)


class Curves(unittest.TestCase):
    def test_are_zero_behind_their_end(self):
        table = make_time_value(Curve(HERE, [(0.0, 1.0), (1.0, 3.0)]), 2.0, 10.0)["table"]
        self.assertEqual(table[:2], [[0.0, 2.0], [1.0, 6.0]])
        self.assertEqual(table[-1], [10.0, 0.0])
        self.assertEqual(make_time_value(Curve(HERE, [(0.0, 5.0), (20.0, 5.0)]), 2.0, 10.0), 10.0)

    def test_integral_of_a_line_is_a_parabola(self):
        for time, value in integrate([(0.0, 0.0), (2.0, 4.0)]):
            self.assertAlmostEqual(value, time * time)

    def test_thinning_tells_its_error(self):
        points = [(i / 100, (i / 100) ** 0.5) for i in range(101)]
        rows, error = thin_rows(points)
        self.assertEqual(len(rows), 32)
        self.assertLess(error, 0.01)
        self.assertEqual(thin_rows(points[:20]), (points[:20], 0.0))


class Texts(InFolder):
    """deck.yaml is what YAML libraries, and percuss, read back."""

    NAMES = ("null", "no", "on", "y", "1e5", "nan", ".inf", "0x10", "~", "&a", "*a", "- a", "a: b", "a #b", "[a", "true", "2001-01-01", "'", '"', "=")

    def test_names_are_read_back_as_they_are(self):
        for name in self.NAMES:
            self.assertEqual(yaml.safe_load(format_section("title", name)), {"title": name})
            self.assertEqual(yaml.safe_load(format_section("parts", {name: {"material": name}})), {"parts": {name: {"material": name}}})

    def test_the_program_reads_titles_back(self):
        for name in self.NAMES:
            deck = self.write(f"{format_section('title', name)}time: {{end: 1e-6}}\n" + PROGRAM_SCENE, "scene.yaml")
            done = self.percuss("check", deck, "--json")
            self.assertEqual((done.returncode, json.loads(done.stdout)["title"] if done.returncode == 0 else done.stderr), (0, name))

    def test_numbers_are_those_of_the_model(self):
        values = [1e5, 1.0, 0.1, 1e-300, -2.5e20, 3, True, 123456.0, -0.0]
        self.assertEqual(format_section("a", values), "a: [1e5, 1, 0.1, 1e-300, -2.5e20, 3, true, 123456, 0]\n")
        self.assertRaises(OverflowError, format_section, "a", math.inf)

    def test_what_has_no_place_in_the_deck_is_an_error(self):
        model = self.read(decks.SMALL)[0]
        model.deck["dampers"] = [{"factor": 1.0}]
        self.assertRaisesRegex(RuntimeError, "dampers", write_deck, model, "deck.k", "mesh.k", "")
        for value in (None, object()):
            model.deck["dampers"], model.deck["damping"] = [], [{"factor": value}]
            del model.deck["dampers"]
            self.assertRaises(yaml.representer.RepresenterError, write_deck, model, "deck.k", "mesh.k", "")

    def test_every_section_of_a_deck_has_its_place(self):
        with open(os.path.join(ROOT, "docs/deck.md"), encoding="utf-8") as file:
            sections = set(re.findall(r"^\| `([a-z_]+)` \|", file.read(), re.MULTILINE))
        self.assertEqual(sections - set(ORDER), {"title", "units"})
        self.assertEqual(set(ORDER) - sections, set())

    def test_a_long_entry_has_a_line_for_each_of_its_entries(self):
        springs = {"a": {"between": [{"id": 1}, {"id": 2}], "table": [[0.0, float(i)] for i in range(30)]}}
        text = format_section("springs", springs)
        self.assertEqual(yaml.safe_load(text), {"springs": springs})
        self.assertLess(max(map(len, text.splitlines())), 130)


class Origins(InFolder):
    """What the check refuses is a refusal of the card that made the entry."""

    def test_an_entry_has_its_card(self):
        model, ledger = self.read(decks.FULL)
        for path, card in ((["conditions", 2, "fixed"], "BOUNDARY_SPC_SET"), (["loads", "nodal", 0], "LOAD_NODE_SET"), (["walls", 0], "RIGIDWALL_PLANAR"),
                           (["parts", "plate", "points"], "PART"), (["materials", "steel"], "MAT_ELASTIC"), (["time", "step_scale"], "CONTROL_TIMESTEP")):  # fmt: skip
            found = find_card(model, ledger, path)
            self.assertEqual(found and found[0], card, path)
        self.assertEqual(find_card(model, ledger, ["contact", "surfaces", 0])[0].split("_")[0], "CONTACT")

    def test_a_place_is_found_in_the_deck(self):
        root = yaml.compose("time: {end: 1}\nloads:\n  nodal:\n    - {nodes: a}\n    - {nodes: b, force: {x: 1}}\n", Loader=yaml.SafeLoader)
        self.assertEqual(find_path(root, 5, 26), ["loads", "nodal", 1, "force", "x"])
        self.assertEqual(find_path(root, 4, 9), ["loads", "nodal", 0, "nodes"])

    def test_a_refused_deck_is_not_left_behind(self):
        fake = os.path.join(self.folder, "percuss")
        with open(fake, "w", encoding="utf-8") as file:
            file.write(f'#!/bin/sh\n[ "$1" = schema ] && exec "{find_program()}" schema\n')
            file.write('n=$(grep -n wall_force "$2" | head -1 | cut -d: -f1)\necho "$2:$n:3: error: it moves" >&2\nexit 2\n')
        os.chmod(fake, 0o755)
        text = self.write(decks.FULL.replace("72floor", "72wall_force"))
        done = subprocess.run([sys.executable, "-m", "percuss", "import", text, "--out", os.path.join(self.folder, "out"), "--quiet"],
                              capture_output=True, text=True, env=dict(os.environ, PERCUSS_PROGRAM=fake), check=False)  # fmt: skip
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr, r"deck.k:\d+: error: \*RIGIDWALL_PLANAR: percuss check refuses what becomes of it \(at walls of the deck\): it moves")
        self.assertEqual(sorted(os.listdir(os.path.join(self.folder, "out"))), ["import_report.json", "import_report.md"])


class Shapes(unittest.TestCase):
    def test_volume_of_a_twisted_hexahedron_does_not_depend_on_its_diagonals(self):
        cube = [(0, 0, 0), (2, 0, 0), (2, 1, 0), (0, 1, 0), (0, 0, 3), (2, 0, 3), (2, 1, 3), (0, 1, 3)]
        self.assertAlmostEqual(solid_volume([tuple(map(float, x)) for x in cube]), 6.0)
        cube[6] = (2.5, 1.2, 3.4)
        turned = [cube[i] for i in (1, 2, 3, 0, 5, 6, 7, 4)]
        self.assertAlmostEqual(solid_volume(cube), solid_volume(turned))

    def test_collapsed_hexahedra_are_solids_whatever_their_numbering(self):
        places = {1: (0, 0, 0), 2: (1, 0, 0), 3: (1, 1, 0), 4: (0, 1, 0), 5: (0, 0, 1), 6: (1, 0, 1), 7: (0.5, 0.5, 1)}
        same = (  # quarter turns about two axes: with them a hexahedron has all its numberings
            (0, 1, 2, 3, 4, 5, 6, 7), (1, 2, 3, 0, 5, 6, 7, 4), (2, 3, 0, 1, 6, 7, 4, 5), (4, 0, 3, 7, 5, 1, 2, 6),
            (3, 2, 6, 7, 0, 1, 5, 4), (7, 6, 5, 4, 3, 2, 1, 0))  # fmt: skip
        for corners, count, volume in (((1, 2, 3, 4, 5, 6, 6, 5), 6, 0.5), ((1, 2, 3, 4, 7, 7, 7, 7), 5, 1 / 3),
                                       ((1, 2, 3, 3, 5, 5, 5, 5), 4, 1 / 6), ((1, 2, 3, 5, 5, 5, 5, 5), 4, 1 / 6)):  # fmt: skip
            for order in same:
                solid = collapse([corners[i] for i in order])
                self.assertEqual(len(solid), count)
                x = [places[node] for node in solid]
                self.assertAlmostEqual(solid_volume(x), volume)
                self.assertGreater(tet_volume(x[0], x[1], x[2] if count != 5 else x[3], x[3] if count != 5 else x[4]), 0)
        self.assertIsNone(collapse([1, 1, 2, 3, 4, 5, 6, 7]))


class Mesh(InFolder):
    def test_ids_are_kept_in_all_widths_and_lines(self):
        model, _ = self.read(decks.WIDE)
        self.assertEqual(model.blocks[0].solids, [(123456789012, tuple(range(900000000001, 900000000009)))])
        model, _ = self.read(decks.SMALL)
        self.assertEqual(model.blocks[0].solids, [(500, (1, 2, 3, 4, 11, 12, 13, 14))])
        commas = decks.SMALL.replace("       1       2       3       4      11      12      13      14\n", "1,2,3,4,11,12,13,14\n")
        self.assertEqual(self.read(commas)[0].blocks[0].solids, model.blocks[0].solids)
        self.assertEqual(self.read(decks.SMALL.lower())[0].blocks[0].solids, model.blocks[0].solids)

    def test_ids_of_shells_that_solids_have_are_raised(self):
        model, ledger = self.read(decks.FULL)
        self.assertEqual([id for id, _ in model.blocks[1].shells], [1500, 1501])
        self.assertIn("ELEMENT_SHELL.EID", {e.card for e in ledger.list_rows() if e.status is Status.APPROXIMATED})

    def test_constraints_of_nodes_become_conditions(self):
        model, _ = self.read(decks.SMALL)
        self.assertEqual(
            model.deck["conditions"], [{"nodes": "fixed_z", "fixed": ["z"]}, {"nodes": "fixed_xyz_rxyz", "fixed": ["x", "y", "z"]}]
        )
        self.assertEqual(model.node_sets["fixed_z"], [2])

    def test_elements_of_other_shapes_are_refused_with_their_line(self):
        other = decks.SMALL.replace("      11      12      13      14\n", "      11      11      13      14\n")
        self.assertIn("deck.k:21", self.refusals(other)["ELEMENT_SOLID.degenerate"])
        belt = decks.SMALL.replace("*END", "*ELEMENT_SEATBELT\n7,3,1,2,3\n*END")
        self.assertIn("ELEMENT_SEATBELT", self.refusals(belt))
        self.assertEqual(self.refusals(belt, "element_*"), {})

    def test_beams_become_parts_with_sections(self):
        model, ledger = self.read(decks.BEAMS)
        self.assertEqual(ledger.list_refused(), [])
        blocks = {block.name: block for block in model.blocks if block.beams}
        self.assertEqual(blocks["posts"].keys["section"], {"rectangle": {"size": [0.02, 0.05]}})
        self.assertEqual(blocks["posts"].keys["toward"], [0.0, 1.0, 0.0])
        self.assertEqual(len(blocks["posts"].beams), 3)
        self.assertEqual(blocks["tie"].keys["section"], {"truss": {"area": 1e-4}})
        self.assertEqual(blocks["tie"].beams, [(10500, (31, 33))])  # a solid has the id
        self.assertEqual(blocks["sill"].keys["section"], {"tube": {"outer_radius": 0.02, "inner_radius": 0.015}})
        general = blocks["brace"].keys["section"]["general"]
        self.assertEqual((general["inertia_y"], general["shear_area_y"]), (1e-7, 8e-4))
        self.assertEqual(model.deck["conditions"][-1]["fixed"], ["x", "y", "z", "rx", "ry", "rz"])

    def test_beams_are_checked_by_the_program(self):
        self.accept(decks.BEAMS)
        self.accept(decks.ABAQUS_BEAMS, "frame.inp")

    def test_beams_turned_in_two_ways_become_two_parts(self):
        model, _ = self.read(decks.BEAMS.replace("       3      21      33      34      41", "       3      21      33      34      31"))
        self.assertEqual([block.name for block in model.blocks if block.part == 21], ["posts", "posts_d2"])

    def test_what_beams_do_not_have_is_refused(self):
        for old, new, card in (("        21         1       1.0", "        21         6       1.0", "SECTION_BEAM.ELFORM"),
                               ("      0.02      0.02", "      0.02      0.03", "SECTION_BEAM.TS2"),
                               ("       5      23      31      34       0", "       5      23      31      34       0       1", "ELEMENT_BEAM.RT1")):
            self.assertIn(card, self.refusals(decks.BEAMS.replace(old, new)))
        self.fails(decks.BEAMS.replace("       3      21      33      34      41", "       3      21      33      34       0"), "there is no node 0", "N3")

    def test_beams_of_abaqus(self):
        model, ledger = self.read_abaqus(decks.ABAQUS_BEAMS)
        self.assertEqual(ledger.list_refused(), [])
        self.assertEqual(model.blocks[0].keys["section"], {"rectangle": {"size": [0.02, 0.04]}})
        self.assertEqual(model.blocks[0].keys["toward"], [0.0, 1.0, 0.0])
        self.assertEqual(model.blocks[1].keys["section"], {"truss": {"area": 1e-4}})
        self.assertIn("BEAM SECTION.SECTION", {e.card for e in self.read_abaqus(decks.ABAQUS_BEAMS.replace("RECT", "L"))[1].list_refused()})

    def test_tetrahedra_are_known_by_their_collapsed_edges(self):
        plain = "       1       2       3       4      11      12      13      14\n"
        for corners in ("1,2,3,11,11,11,11,11\n", "1,2,3,3,11,11,11,11\n"):
            path = self.write(decks.SMALL.replace(plain, corners))
            model = read_keyword_deck(path, Ledger())
            self.assertEqual(model.blocks[0].solids, [(500, (1, 2, 3, 11))])
            self.assertIn("500,3,1,2,3,11,11,11,11,11", list(list_blocks(model)))

    def test_wedges_and_pyramids_are_known_by_their_collapsed_edges(self):
        plain = "       1       2       3       4      11      12      13      14\n"
        for corners, line in (("1,2,3,4,11,11,14,14\n", "500,3,1,2,3,4,11,11,14,14"), ("1,2,3,4,11,11,11,11\n", "500,3,1,2,3,4,11,11,11,11")):
            path = self.write(decks.SMALL.replace(plain, corners))
            model = read_keyword_deck(path, Ledger())
            nodes = next(text for text in list_blocks(model) if text.startswith("500,")).split(",")[2:]
            self.assertEqual(set(nodes), set(line.split(",")[2:]))
            self.assertEqual(len(model.blocks[0].solids[0][1]), len(set(nodes)))
            result = self.percuss("import", path, "--out", "solids", "--force", "--units", "m, kg, s", "--allow", "all")
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertIn("The deck and its meshes can be run", result.stdout)

    def test_tetrahedra_are_checked_by_the_program(self):
        plain = "       1       2       3       4      11      12      13      14\n"
        for corners in ("1,2,3,11,11,11,11,11\n", "1,2,3,3,11,11,11,11\n"):
            result = self.percuss("import", self.write(decks.SMALL.replace(plain, corners)), "--out", "tets", "--force", "--units", "m, kg, s", "--allow", "all")
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertIn("The deck and its meshes can be run", result.stdout)

    def test_tetrahedra_of_ten_nodes_are_cut_by_the_program(self):
        path = self.write(decks.TEN_NODES)
        ledger = Ledger(allowed=["ALL"])
        model = read_keyword_deck(path, ledger)
        self.assertEqual(model.blocks[0].solids, [(500, (1, 2, 3, 11, *range(101, 107)))])
        self.assertIn("ELEMENT_SOLID.ten_nodes", {e.card for e in ledger.list_rows()})
        x = [model.nodes[node] for node in model.blocks[0].solids[0][1]]
        self.assertAlmostEqual(solid_volume(x), tet_volume(*x[:4]), 12)
        self.assertIn("500,3,", list(list_blocks(model)))
        result = self.percuss("import", path, "--out", "ten", "--units", "m, kg, s", "--allow", "all")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("tetrahedra of ten nodes, cut into eight of four: 1 into 8", result.stdout)

    def test_thickness_of_elements_makes_parts(self):
        shells = "*ELEMENT_SHELL_THICKNESS\n500,8,21,22,23,24\n0.1,0.1,0.1,0.1\n501,8,22,25,23,23\n0.2,0.2,0.2\n"
        start, _, rest = decks.PLATE.partition("*ELEMENT_SHELL")
        model, _ = self.read(decks._HEAD + start + shells + rest[rest.index("*PART") :])
        self.assertEqual([(b.name, b.thickness, len(b.shells)) for b in model.blocks], [("plate", 0.1, 1), ("plate_t2", 0.2, 1)])

    def test_thickness_of_elements_is_that_of_the_mesh_file_where_the_mesh_is_the_middle(self):
        shells = "*ELEMENT_SHELL_THICKNESS\n500,8,21,22,23,24\n0.1,0.1,0.1,0.1\n501,8,22,25,23,23\n0.2,0.2,0.2\n"
        start, _, rest = decks.PLATE.partition("*ELEMENT_SHELL")
        text = decks._HEAD + start + shells + rest[rest.index("*PART") :].replace("0.1       1.0", "0.1       0.0")
        model, ledger = self.read(text)
        self.assertEqual([(b.name, b.thicknesses) for b in model.blocks], [("plate", {500: 0.1, 501: 0.2})])
        self.assertIn("ELEMENT_SHELL_THICKNESS", [entry.card for entry in ledger.list_rows() if entry.status == Status.TRANSLATED])
        lines = list(list_blocks(model))
        self.assertEqual(lines[lines.index("500,8,21,22,23,24") + 1], "0.1,0.1,0.1,0.1")
        done = self.percuss("import", self.write(text), "--out", "thick", "--units", "m, kg, s", "--allow", "all")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        with open(os.path.join(self.folder, "thick", "deck.yaml"), encoding="utf-8") as file:
            self.assertIn("thickness: {file: true}", file.read())

    def test_what_does_not_fit_together_is_an_error_with_its_place(self):
        self.fails(
            decks.SMALL.replace("*SECTION_SOLID\n         3", "*SECTION_SOLID\n         4"), "deck.k:27", "there is no section 3"
        )
        self.fails(
            decks.SMALL.replace("      11             0.0", "      10             0.0"), "there is no node 11, of element 500"
        )
        self.fails(decks.SMALL.replace("7850.0", "7850,0"), "deck.k:33", "are the columns of its line shifted?")
        self.fails("*KEYWORD\n*NODE\n1,0,0\n*END\n", "no elements")
        self.fails(decks.SMALL.replace("1.0E-04", "       "), "ENDTIM")


class Files(InFolder):
    def test_includes_are_read_beside_the_main_file(self):
        self.write("*NODE\n99,0,0,9\n", "parts/more.k")
        self.write("*PARAMETER\nR   rho,7850.0\n", "values.k")
        model, _ = self.read(
            decks.SMALL.replace("    7850.0", "      &rho").replace("*TITLE", "*INCLUDE\nparts/mo +\nre.k\nvalues.k\n*TITLE")
        )
        self.assertIn(99, model.nodes)
        self.assertEqual(model.materials["steel"]["density"], 7850)

    def test_loops_and_files_elsewhere_are_refused(self):
        self.write("*INCLUDE\nb.k\n", "a.k")
        self.write("*INCLUDE\na.k\n", "b.k")
        self.fails("*KEYWORD\n*INCLUDE\na.k\n", "included twice")
        self.fails("*KEYWORD\n*INCLUDE\nnone.k\n", "deck.k:2: error: there is no file 'none.k'")
        self.fails("*KEYWORD\n*INCLUDE\n/etc/hostname\n", "outside")
        self.fails("*KEYWORD\n*INCLUDE\ndeck.k\n", "included twice")

    def test_files_outside_are_opened_only_where_that_is_allowed_by_name(self):
        outside = self.write(decks.SMALL, "outside.k")
        inside = self.write(f"*KEYWORD\n*INCLUDE\n{outside}\n*END\n", "folder/deck.k")
        for patterns in ("all", "ALL", "*", "INCLUDE*", "INCLUDE.*", "INCLUDE.OUTSID?"):
            result = self.percuss("import", inside, "--out", "out", "--allow", patterns)
            self.assertEqual(result.returncode, 2, patterns)
            self.assertIn("lies outside of the folder", result.stderr)
        result = self.percuss("import", inside, "--out", "out", "--units", "m, kg, s", "--allow", "include.outside", "--no-check")
        self.assertEqual(result.returncode, 0, result.stderr)

    def test_files_are_moved_and_turned(self):
        nodes = decks.BLOCK_NODES
        self.write("*KEYWORD\n" + nodes, "nodes.k")
        deck = decks.SMALL.replace(
            nodes,
            """\
*DEFINE_TRANSFORMATION
$ the last row acts first
1
TRANSL,0,0,5
ROTATE,0,0,2,0,0,0,90
*INCLUDE_TRANSFORM
nodes.k
0
0
1,1,1
1
""",
        )
        x = self.read(deck)[0].nodes[2]
        for found, expected in zip(x, (0.0, 1.0, 5.0)):
            self.assertAlmostEqual(found, expected)
        self.fails(deck.replace("nodes.k\n0\n", "nodes.k\n100\n"), "there is no node 1, of element 500")
        self.fails(deck.replace("1,1,1\n1\n", "1,1,1\n2\n"), "no such *DEFINE_TRANSFORMATION")
        self.write("*KEYWORD\n" + nodes + "*LOAD_BODY_Z\n1\n", "nodes.k")
        curve = "*DEFINE_CURVE\n1\n0,1\n9,1\n*END"
        self.assertIn("INCLUDE_TRANSFORM.LOAD_BODY_Z", self.refusals(deck.replace("*END", curve), "LOAD_BODY*"))

    def test_parameters_and_expressions_are_put_in_place(self):
        steel = self.read(decks.PARAMETERS)[0].materials["steel"]
        self.assertEqual((steel["density"], steel["youngs_modulus"]), (3925.0, 2e11))
        self.fails(decks.PARAMETERS.replace("&e0", "&e9"), "there is no parameter &e9")


class Laws(InFolder):
    def test_every_law_is_the_one_that_percuss_has_and_is_accepted(self):
        parts, materials = {}, {}
        for index, (name, (law, _, _, shells)) in enumerate(decks.LAWS.items()):
            materials[name] = self.keys(name)
            self.assertEqual(materials[name]["model"], law)
            shape = (
                {"shell_plate": {"size": [1, 1], "cells": [1, 1]}, "thickness": 0.1}
                if shells
                else {"box": {"size": [1, 1, 1], "cells": [1, 1, 1]}}
            )
            parts[name] = {**shape, "at": [2 * index, 0, 0], "material": name}
        sections = {"time": {"end": 1e-5}, "parts": parts, "materials": materials}
        deck = self.write("".join(format_section(key, value) + "\n" for key, value in sections.items()), "laws.yaml")
        done = self.percuss("check", deck)
        self.assertEqual(done.returncode, 0, done.stderr)

    def law(self, name, *allowed):
        _, cards, state, shells = decks.LAWS[name]
        return self.read(decks.make_block(cards, state, shells), *allowed)[0].materials

    def keys(self, name):
        return next(iter(self.law(name).values()))

    def test_tangents_become_slopes_over_plastic_strain(self):
        kinematic = self.keys("kinematic")
        self.assertAlmostEqual(kinematic["hardening_modulus"], 2e11 * 1e9 / (2e11 - 1e9))
        self.assertEqual(kinematic["kinematic_share"], 0.75)
        self.assertEqual((kinematic["cowper_symonds_rate"], kinematic["cowper_symonds_exponent"]), (40, 5))
        self.assertEqual(kinematic["failure"], {"plastic_strain": 0.3})
        self.assertEqual(self.keys("shear")["hardening_modulus"], 1e9)  # it is over plastic strain already
        self.assertAlmostEqual(self.keys("shear")["youngs_modulus"], 9 * 1.6e11 * 8e10 / (3 * 1.6e11 + 8e10))

    def test_curves_go_on_with_their_last_slope(self):
        table = self.keys("table")["hardening"]
        self.assertEqual(table[:3], [[0.0, 3e8], [0.1, 4e8], [0.3, 4.5e8]])
        self.assertAlmostEqual(table[3][1], 4.5e8 + (table[3][0] - 0.3) * 2.5e8)

    def test_curves_are_scaled_and_shifted(self):
        plate = self.read(decks.FULL)[0].materials["material_8"]
        self.assertEqual(plate["hardening"][:3], [[0.0, 3e8], [0.1, 4e8], [0.2, 4.2e8]])

    def test_johnson_cook_takes_shear_and_bulk_moduli_and_turns_d3(self):
        law = self.keys("johnson_cook")
        bulk = law["youngs_modulus"] / (3 * (1 - 2 * law["poissons_ratio"]))
        self.assertAlmostEqual(bulk / (8960 * 3940**2), 1)
        self.assertAlmostEqual(law["youngs_modulus"] / (2 * (1 + law["poissons_ratio"])) / 4.6e10, 1)
        self.assertEqual(law["failure"]["johnson_cook"]["d3"], -3.03)
        _, cards, state, _ = decks.LAWS["johnson_cook"]
        self.assertIn("MAT_JOHNSON_COOK.D3", self.refusals(decks.make_block(cards.replace("3.03", "-3.03"), state)))
        (brittle,) = self.read(decks.make_block(cards.replace("0.014\n", "-0.014\n"), state))[0].materials.values()
        self.assertEqual(brittle["failure"]["johnson_cook"]["d4"], -0.014)

    def test_other_laws_and_fields_are_refused(self):
        text = decks.make_block("*MAT_SAMP-1\n1,1e3\n")
        self.assertIn("deck.k:27", self.refusals(text)["MAT_SAMP-1"])
        self.assertIn("EOS_TABULATED_COMPACTION", self.refusals(decks.make_block("*MAT_NULL\n1,1000.0\n", "*EOS_TABULATED_COMPACTION\n2,0.0\n")))
        self.assertIn("MAT_MOONEY-RIVLIN_RUBBER.shells", self.refusals(decks.make_block(decks.LAWS["mooney"][1], "", True)))

    def test_power_law_is_sampled(self):
        rows = self.keys("power")["hardening"]
        offset = (3e8 / 6e8) ** (1 / 0.2)
        for strain, stress in rows:
            self.assertAlmostEqual(stress / (6e8 * (offset + strain) ** 0.2), 1)


class Scene(InFolder):
    def test_a_deck_with_everything_is_accepted(self):
        done = self.percuss("import", self.write(decks.FULL), "--out", "out", "--units", "m, kg, s")
        self.assertEqual(done.returncode, 0, done.stderr)
        for words in (
            "*CONTACT_AUTOMATIC_SINGLE_SURFACE",
            "mass: 9027.5",
            "1 quadrilaterals, 1 triangles",
            "ids kept",
            "units: m, kg, s",
        ):
            self.assertIn(words, done.stdout)
        with open(os.path.join(self.folder, "out/import_report.json"), encoding="utf-8") as file:
            cards = {entry["card"]: entry for entry in json.load(file)["cards"]}
        self.assertEqual(cards["CONTROL_ENERGY"]["outcome"], "ignored")
        self.assertEqual(cards["LOAD_BODY_Z"]["line"], 87)
        with open(os.path.join(self.folder, "out/import_report.md"), encoding="utf-8") as file:
            self.assertIn("| `*LOAD_BODY_Z` |", file.read())

    def test_conditions_loads_and_starts(self):
        deck = self.read(decks.FULL)[0].deck
        self.assertEqual(deck["initial"], [{"velocity": [0, 0, -5]}, {"nodes": "the_right_edge", "velocity": [1, 0, 0]}])
        self.assertEqual(deck["loads"]["gravity"], [0, 0, -9.81])
        self.assertEqual(deck["loads"]["pressure"][0]["value"], 1e5)
        self.assertIn({"nodes": "the_right_edge", "fixed": ["y", "rx"]}, deck["conditions"])
        motion = deck["conditions"][-1]["velocity"]["z"]["table"]
        self.assertEqual(motion[:3], [[0.0, 0.0], [5e-5, -2.0], [6e-5, -2.0]])
        self.assertEqual(motion[-1], [1e-4, 0.0])
        self.assertEqual(deck["walls"], [{"name": "floor", "point": [0, 0, -0.1], "normal": [0, 0, 1], "friction": 0.1}])
        pairs = deck["contact"]["surfaces"]
        self.assertEqual([(p["a"], p["b"], p["friction"]) for p in pairs], [("block_of_steel", "plate", 0.3), ("all", "all", 0.15)])
        self.assertEqual(deck["time"], {"end": 1e-4, "collapse_ratio": 0.01, "step_scale": 0.67})

    def test_dynamic_relaxation(self):
        for flag, wanted, outcome in ((1, {"relaxation": {"tolerance": 1e-4}}, "approximated"), (0, None, "ignored"), (5, None, "refused")):
            text = decks.FULL.replace("*END", f"*CONTROL_DYNAMIC_RELAXATION\n250,1.0e-4,0.995,,,,,{flag}\n*END")
            model, ledger = self.read(text)
            self.assertEqual(model.deck.get("start"), wanted)
            entries = [e for e in ledger.entries.values() if e.card.startswith("CONTROL_DYNAMIC_RELAXATION")]
            self.assertEqual([e.status.value for e in entries], [outcome])

    def test_temperatures_count_where_a_law_depends_on_them(self):
        card = "*INITIAL_TEMPERATURE_SET\n0,400.0\n*END"
        self.assertEqual(self.refusals(decks.FULL.replace("*END", card)), {})
        for law, refused in (("johnson_cook", ["INITIAL_TEMPERATURE_SET"]), ("simplified", [])):
            _, cards, state, shells = decks.LAWS[law]
            self.assertEqual(list(self.refusals(decks.make_block(cards, state, shells).replace("*END", card))), refused)

    def test_stresses_become_tables(self):
        model, ledger = self.read(decks.STRESSED)
        self.assertEqual(model.deck["start"], {"fields": [{"file": "shell_stresses.csv"}, {"file": "solid_stresses.csv"}]})
        self.assertEqual(model.tables["solid_stresses.csv"][1:], ["500,0.0,0.0,5000000.0,1000000.0,0.0,0.0,0.0"])
        rows = [[float(cell) for cell in line.split(",")] for line in model.tables["shell_stresses.csv"][1:]]
        self.assertEqual([row[:2] for row in rows], [[1500, layer] for layer in range(1, 6)])  # solids have 500
        for row, place in zip(rows, (-0.906179845938664, -0.538469310105683, 0, 0.538469310105683, 0.906179845938664)):
            self.assertAlmostEqual(row[2], 10e6 * place, delta=1e-6)
            self.assertAlmostEqual(row[8], 0.01 * (1 + place), delta=1e-15)
        self.assertIn("INITIAL_STRESS_SHELL.T", [e.card for e in ledger.entries.values() if e.status.value == "approximated"])
        self.accept(decks.STRESSED)

    def test_forces_of_bolts_become_preloads(self):
        model, ledger = self.read(decks.BOLTS)
        start = model.deck["start"]
        self.assertEqual(start["relaxation"], {})
        bolts = start["preload"]["preload_bolt"]
        self.assertEqual(bolts, {"part": "bolt", "force": 40e3})
        self.assertEqual([id for b in model.blocks if b.name == "bolt" for id, _ in b.beams], [71, 72])
        self.assertEqual([id for b in model.blocks if b.name == "bolt_d2" for id, _ in b.beams], [73])
        cut = start["preload"]["preload_block_of_steel"]
        self.assertEqual((cut["part"], cut["point"], cut["normal"]), ("block_of_steel", [0.5, 0.5, 0.25], [0.0, 0.0, 1.0]))
        self.assertAlmostEqual(cut["force"], 5e6 * 1.0, delta=1)  # the block has a section of 1
        told = [entry.card for entry in ledger.entries.values() if entry.status is Status.APPROXIMATED]
        self.assertIn("INITIAL_AXIAL_FORCE_BEAM", told)
        self.assertIn("INITIAL_STRESS_SECTION", told)
        self.assertNotIn("ELEMENT_BEAM.N3", told)
        self.accept(decks.BOLTS)

    def test_a_deck_with_preloads_tells_that_nothing_is_held(self):
        gravity = "*LOAD_BODY_Z\n12,1.0\n*DEFINE_CURVE\n12\n0.0,9.81\n1.0,9.81\n*END"
        for text, told in ((decks.BOLTS.replace("*END", gravity), "Gravity acts in them, and the conditions of the deck act; nothing is held beyond them.\n# start.relaxation.hold is empty: name there"),
                           (decks.BOLTS, "No load acts in them, and the conditions of the deck act; nothing is held beyond them.\nstart:")):
            model, _ = self.read(text)
            written = write_deck(model, "deck.k", "mesh.k", "")
            self.assertIn(f"# Preloads are reached in damped steps before time 0. {told}", written)
        self.accept(decks.BOLTS.replace("*END", gravity))
        self.assertNotIn("# Preloads", write_deck(self.read(decks.SMALL)[0], "deck.k", "mesh.k", ""))

    def test_forces_of_bolts_that_are_refused(self):
        for old, new, name in (
            ("2.0,2.0e4\n", "2.0,1.0e4\n", "INITIAL_AXIAL_FORCE_BEAM.LCID"),
            ("6,9,2.0\n", "6,9,2.0,1\n", "INITIAL_AXIAL_FORCE_BEAM.KBEND"),
            ("6\n71,72\n", "6\n71,79\n", "INITIAL_AXIAL_FORCE_BEAM.BSID"),
            ("5,4,8,0\n", "5,5,8,0\n", "INITIAL_STRESS_SECTION.CSID"),
            (",1.0,0.0\n", ",1.0,0.3\n", "DATABASE_CROSS_SECTION_PLANE.RADIUS"),
            ("0,0.5,0.5,0.25,0.5,0.5,1.0", "0,0.5,0.5,9.25,0.5,0.5,9.9", "INITIAL_STRESS_SECTION.PSID"),
        ):
            text = decks.BOLTS.replace(old, new)
            self.assertNotEqual(text, decks.BOLTS, old)
            self.assertEqual(list(self.refusals(text)), [name])
            self.assertEqual(self.refusals(text, name), {})
        # A curve that ends at 0 releases the bolt, as percuss does at time 0.
        self.assertEqual(self.refusals(decks.BOLTS.replace("2.0,2.0e4\n", "2.0,2.0e4\n2.1,0.0\n")), {})
        self.fails(decks.BOLTS.replace("6,9,2.0", "6,77,2.0"), "curve 77")
        self.fails(decks.BOLTS.replace("6,9,2.0", "66,9,2.0"), "*SET_BEAM 66")

    def test_stresses_that_are_refused(self):
        for old, new, name in (
            ("       500         2         2", "       500         2         2         0         0         1", "SHELL.LARGE"),
            ("       500         2         2", "       500         2         2         3", "SHELL.NHISV"),
            ("       500         1\n       0.0", "       777         1\n       0.0", "SOLID.EID"),
            ("*INITIAL_STRESS_SOLID", "*INITIAL_STRESS_SOLID_SET", "SOLID_SET"),
        ):
            text = decks.STRESSED.replace(old, new)
            self.assertNotEqual(text, decks.STRESSED)
            self.assertEqual(list(self.refusals(text)), [f"INITIAL_STRESS_{name}"])

    def test_stresses_that_a_law_cannot_begin_with_are_refused(self):
        card = "*INITIAL_STRESS_SOLID\n5,1\n0.0,0.0,{s},0.0,0.0,0.0,{p}\n*END"
        name = "INITIAL_STRESS_SOLID"
        for law, s, p, refused, row in (
            ("hydro", "5.0e6", "0.0", "material", None),
            ("viscous", "5.0e6", "0.0", "material", None),
            ("blatz", "5.0e6", "0.0", "material", None),
            ("blatz", "0.0", "0.0", None, None),
            ("isotropic", "5.0e6", "0.01", None, "5,0.0,0.0,5000000.0,0.0,0.0,0.0,0.01"),
        ):
            _, cards, state, shells = decks.LAWS[law]
            text = decks.make_block(cards, state, shells).replace("*END", card.format(s=s, p=p))
            self.assertEqual(list(self.refusals(text)), [f"{name}.{refused}"] if refused else [])
            model, _ = self.read(text, f"{name}.*")
            self.assertEqual(model.tables.get("solid_stresses.csv", [None, None])[1], row)
        rigid = decks.make_block("*MAT_RIGID\n1,7850.0,2.0e11,0.3\n0\n0\n").replace("*END", card.format(s="1.0", p="0.0"))
        self.assertEqual(list(self.refusals(rigid)), [f"{name}.material"])
        elastic = decks.make_block("*MAT_ELASTIC\n1,7850.0,2.0e11,0.3\n").replace("*END", card.format(s="1.0", p="0.01"))
        self.assertEqual(list(self.refusals(elastic)), [f"{name}.EPS"])
        self.assertEqual(self.read(elastic, f"{name}.EPS")[0].tables["solid_stresses.csv"][1], "5,0.0,0.0,1.0,0.0,0.0,0.0,0.0")

        ten = decks.TEN_NODES.replace("*END", card.format(s="1.0", p="0.0").replace("5,1", "500,1"))
        self.assertEqual(list(self.refusals(ten)), [f"{name}.ten_nodes"])

    def test_of_two_stresses_of_an_element_the_later_counts(self):
        again = "*INITIAL_STRESS_SOLID\n500,1\n1.0,2.0,3.0,4.0,5.0,6.0\n*INITIAL_STRESS_SHELL\n500,1,1\n0.0,7.0\n*END"
        text = decks.STRESSED.replace("*END", again)
        tables = self.read(text)[0].tables
        self.assertEqual(tables["solid_stresses.csv"][1:], ["500,1.0,2.0,3.0,4.0,5.0,6.0,0.0"])
        self.assertEqual(tables["shell_stresses.csv"][1:], [f"1500,{layer},7.0,0.0,0.0,0.0,0.0,0.0,0.0" for layer in range(1, 6)])
        self.accept(text)

    def test_forms_of_sets_ties_and_spins(self):
        model, _ = self.read(decks.FORMS)
        self.assertEqual(model.node_sets["nodes_2"], [21, 22, 23, 24])
        tie = model.deck["contact"]["ties"][0]
        self.assertEqual((tie["a"], tie["b"]), ("nodes_2", "block_of_steel"))
        self.assertAlmostEqual(tie["distance"], 0.6 - 0.1 / 2)  # percuss measures from the surface of the shells
        edge, _ = self.read(decks.FORMS.replace("TIED_NODES_TO_SURFACE_OFFSET", "TIED_SHELL_EDGE_TO_SURFACE_OFFSET"))
        self.assertEqual(edge.deck["contact"]["ties"][0]["rotations"], True)
        self.assertEqual(
            model.deck["initial"][0],
            {"nodes": "plate", "velocity": [1, 0, 0], "angular_velocity": [0, 0, 100], "center": [0.5, 0.5, 0]},
        )
        self.assertEqual(model.deck["added_mass"], [{"nodes": "mass_1", "mass": 5.0, "spread": "evenly"}])
        push = next(c for c in model.deck["conditions"] if "displacement" in c)
        self.assertEqual(push["displacement"]["z"]["table"][-1], [1e-4, -5e-5])  # along a vector that points down
        self.assertEqual(model.side_sets["pressed_shell_set"], [(21, 22, 23, 24), (22, 25, 23)])
        self.assertEqual(model.deck["elements"]["bulk_viscosity"]["quadratic"], 1.2)

    def test_sets_by_steps(self):
        card = "*INITIAL_VELOCITY_NODE\n1,"
        stepped = decks.FORMS.replace(card, "*SET_NODE_LIST_GENERATE_INCREMENT\n77\n21,24,3\n1,3,1\n*INITIAL_VELOCITY\n77\n0,0,3.0\n*INITIAL_VELOCITY_NODE\n1,")
        self.assertEqual(self.read(stepped)[0].node_sets["nodes_77"], [1, 2, 3, 21, 24])
        self.fails(decks.FORMS.replace("*INITIAL_VELOCITY_NODE\n1,", "*SET_NODE_LIST_GENERATE_INCREMENT\n77\n1,3,-1\n*INITIAL_VELOCITY_NODE\n1,"), "INCR", "a positive step")
        self.fails(decks.FORMS.replace("*INITIAL_VELOCITY_NODE\n1,0.0", "*INITIAL_VELOCITY_NODE\n1,0 0.0"), "columns of its line shifted")
        shifted = decks.SMALL.replace("       2             1.0", "        2            1.0 ").replace("       1       2       3       4", "        1       2       3       4")
        self.fails(shifted.replace("        2            1.0 ", "       2             1.0"), "node of *ELEMENT_SOLID", "columns of its line shifted")
        self.fails(shifted, "Y of *NODE is cut (column 40 ends a field of 16")
        self.fails(decks.FORMS.replace("*INITIAL_VELOCITY_NODE\n1,", "*SET_NODE_LIST\n        78\n         10        20\n*INITIAL_VELOCITY_NODE\n1,"), "column 10 ends a field of 10 and cuts '10'")
        self.fails(decks.FORMS.replace("*INITIAL_VELOCITY_NODE\n1,", "*INITIAL_VELOCITY\n         1\n   0    3 \n*INITIAL_VELOCITY_NODE\n1,"), "VX of *INITIAL_VELOCITY", "columns 1 to 10 are one field, and hold '0 ")
        self.assertNotIn("empty", self.read(decks.FORMS)[0].deck["contact"]["ties"][0])
        for allowed in ("all", "CONTACT_TIED.*"):
            self.assertEqual(self.read(decks.FORMS, allowed)[0].deck["contact"]["ties"][0]["empty"], "ignore")

    def test_velocities_of_a_system_are_turned(self):
        turned = "*DEFINE_COORDINATE_VECTOR\n5,0.6,0.8,0.0,0.0,1.0,0.0\n*INITIAL_VELOCITY_GENERATION\n8,2,{spin},10.0,5.0,2.0,0,5\n"
        text = decks.FORMS.replace("*INITIAL_VELOCITY_GENERATION\n8,2,100.0,1.0,0.0,0.0\n", turned.format(spin=0))
        for found, exact in zip(self.read(text)[0].deck["initial"][0]["velocity"], (6 - 4, 8 + 3, 2)):
            self.assertAlmostEqual(found, exact, 12)
        other = turned.format(spin=0).replace("2.0,0,5", "2.0,0,6")
        self.assertIn("INITIAL_VELOCITY_GENERATION.ICID", self.refusals(decks.FORMS.replace("*INITIAL_VELOCITY_GENERATION\n8,2,100.0,1.0,0.0,0.0\n", other)))

    def test_springs_and_dampers(self):
        model, ledger = self.read(decks.SPRINGS)
        self.assertEqual(ledger.list_refused(), [])
        self.assertEqual(
            model.deck["springs"],
            {
                "spring_9001": {"between": [{"id": 1}, {"id": 21}], "stiffness": 1000},
                "spring_9002": {"between": [{"id": 2}, {"id": 22}], "stiffness": 2500},
                "spring_9003": {"between": [{"id": 3}, {"id": 23}], "damping": 3.5},
                "spring_9004": {"between": [{"id": 4}, {"id": 24}], "table": [[0, 0], [0.1, 50], [0.2, 80]]},
            },
        )
        done = self.percuss("import", self.write(decks.SPRINGS), "--out", "sprung", "--units", "m, kg, s")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_springs_that_are_refused(self):
        to_ground = decks.SPRINGS.replace("    9001      20       1      21", "    9001      20       1       0")
        self.assertEqual(list(self.refusals(to_ground)), ["ELEMENT_DISCRETE.ground"])
        along_axis = decks.SPRINGS.replace("      22       0             2.5", "      22       7             2.5")
        self.assertEqual(list(self.refusals(along_axis)), ["ELEMENT_DISCRETE.VID"])
        turning = decks.SPRINGS.replace("*SECTION_DISCRETE\n20,0", "*SECTION_DISCRETE\n20,1")
        self.assertEqual(list(self.refusals(turning)), ["SECTION_DISCRETE.DRO"])
        self.fails(decks.SPRINGS.replace("       4      24", "       4    8888"), "deck.k:", "there is no node 8888")

    def test_spot_welds(self):
        cards = (
            "*CONSTRAINED_SPOTWELD\n11,21,5.0e3,2.0e3,2.0,1.5,1e20,1e20\n*CONSTRAINED_SPOTWELD_ID\n7\n12,22,5.0e3,0,1,1,2e-5\n"
            "*CONSTRAINED_RIVET\n13,23\n*SET_NODE_LIST\n70\n14,24\n*CONSTRAINED_GENERALIZED_WELD_SPOT\n70\n1e20,1e20,4.0e3,3.0e3,2,2\n*END"
        )
        text = decks.SMALL.replace("*END", decks.PLATE + cards)
        model, ledger = self.read(text)
        self.assertEqual(ledger.list_refused(), [])
        self.assertEqual(
            model.deck["welds"],
            {
                "weld_1": {"between": [{"id": 11}, {"id": 21}], "failure": {"normal": 5e3, "shear": 2e3, "shear_exponent": 1.5}},
                "weld_7": {"between": [{"id": 12}, {"id": 22}], "failure": {"normal": 5e3, "normal_exponent": 1, "time": 2e-5}},
                "weld_3": {"between": [{"id": 13}, {"id": 23}]},
                "weld_4": {"between": [{"id": 14}, {"id": 24}], "failure": {"normal": 4e3, "shear": 3e3}},
            },
        )
        done = self.percuss("import", self.write(text), "--out", "welded", "--units", "m, kg, s")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_nodes_that_move_equally(self):
        cards = "*SET_NODE_LIST\n70\n14,24\n*CONSTRAINED_NODE_SET\n70,6\n*CONSTRAINED_NODE_SET_ID\n9\n70,7,1e20\n*END"
        text = decks.SMALL.replace("*END", decks.PLATE + cards)
        model, ledger = self.read(text)
        self.assertEqual(ledger.list_refused(), [])
        self.assertEqual(
            model.deck["constraints"],
            {"equal_1": {"equal": ["x", "z"], "nodes": "equal_1"}, "equal_9": {"equal": ["x", "y", "z"], "nodes": "equal_9"}},
        )
        self.assertEqual(model.node_sets["equal_1"], [14, 24])
        done = self.percuss("import", self.write(text), "--out", "equal", "--units", "m, kg, s")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertEqual(list(self.refusals(text.replace("70,6", "70,6,2e-5"))), ["CONSTRAINED_NODE_SET.TF"])
        self.fails(text.replace("70,6", "70,8"), "DOF is 8 (1 to 7 are directions)")

    def test_damping_in_proportion_to_stiffness(self):
        text = decks.SMALL.replace("*END", "*DAMPING_PART_STIFFNESS\n3,-1e-7\n*END")
        model, ledger = self.read(text)
        self.assertEqual(ledger.list_refused(), [])
        self.assertEqual([block.keys.get("stiffness_damping") for block in model.blocks], [1e-7])
        done = self.percuss("import", self.write(text), "--out", "damped", "--units", "m, kg, s")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_spot_welds_that_are_refused(self):
        text = decks.SMALL.replace("*END", decks.PLATE + "*CONSTRAINED_SPOTWELD\n11,21,5.0e3,2.0e3,2,2,0,0.3\n*END")
        self.assertEqual(list(self.refusals(text)), ["CONSTRAINED_SPOTWELD.EP"])
        self.fails(text.replace("11,21", "11,8888"), "deck.k:", "there is no node 8888")
        self.fails(text.replace("11,21", "11,11"), "both nodes of a weld are 11")
        butt = text.replace("*CONSTRAINED_SPOTWELD\n11,21,5.0e3,2.0e3,2,2,0,0.3", "*CONSTRAINED_GENERALIZED_WELD_BUTT\n70")
        self.assertEqual(list(self.refusals(butt)), ["CONSTRAINED_GENERALIZED_WELD_BUTT"])

    def test_a_smooth_curve_covers_its_distance(self):
        curve = "*DEFINE_CURVE_SMOOTH\n5,0,1.0,0.0,0,1e-5,2e4\n*BOUNDARY_PRESCRIBED_MOTION_NODE\n11,3,0,5,1.0\n*END"
        value = self.read(decks.SMALL.replace("*END", curve))[0].deck["conditions"][-1]["velocity"]["z"]["expression"]
        for words in ("(t <= 0.0 || t >= 6e-05) ? 0", "20000.0 * (1 - cos(pi * (t - 0.0) / 1e-05)) / 2"):  # 1.0 = 2e4 (6e-5 - 1e-5)
            self.assertIn(words, value)

    def test_pressure_on_a_solid_follows_the_order_of_the_nodes(self):
        inward = decks.FULL.replace(
            "        11        12        13        14\n*LOAD_NODE", "        14        13        12        11\n*LOAD_NODE"
        )
        self.assertEqual(self.read(inward)[0].deck["loads"]["pressure"][0]["value"], -1e5)

    def test_a_rigid_part_whose_motion_is_given_is_exact(self):
        model = self.read(decks.RIGID)[0]
        self.assertEqual(model.blocks[0].keys["rigid"], {"fixed": ["x", "y", "rx", "ry", "rz"]})
        self.assertEqual(model.deck["conditions"][0]["velocity"]["z"]["table"][1], [5e-5, 1.0])
        self.assertEqual(len(model.deck["conditions"]), 1)
        self.accept(decks.RIGID)
        turning = decks.RIGID.replace("       1.0       4.0       7.0", "       1.0       4.0       0.0")
        self.assertEqual(self.read(turning)[0].blocks[0].keys["rigid"], {"fixed": ["x", "y"]})

    def test_free_rigid_parts_are_bodies_of_one_part_or_of_several(self):
        self.assertIs(self.read(decks.TWO_RIGID)[0].blocks[0].keys["rigid"], True)
        merged = decks.TWO_RIGID.replace("*END", "*CONSTRAINED_RIGID_BODIES\n3,4\n*END")
        keys = [block.keys["rigid"] for block in self.read(merged)[0].blocks]
        self.assertEqual(keys, [{"body": "block_of_steel"}] * 2)
        self.accept(merged)
        self.assertIn("CONSTRAINED_RIGID_BODIES", self.refusals(decks.TWO_PARTS.replace("*END", "*CONSTRAINED_RIGID_BODIES\n3,4\n*END")))

    def test_mass_and_inertia_of_a_part_replace_those_of_its_mesh(self):
        text = decks.TWO_RIGID.replace("*PART\nsecond\n4,4,3\n", "*PART_INERTIA\nsecond\n4,4,3\n"
                                       "3.5,0.5,0.5,1e4\n2e3,1.0,3.0,2.1e3,2.0,2.2e3\n0.0,0.0,-3.0,0.0,0.0,7.0\n")  # fmt: skip
        model = self.read(text)[0]
        self.assertEqual(
            model.blocks[1].keys["rigid"],
            {"mass": 1e4, "center": [3.5, 0.5, 0.5], "inertia": [2e3, 2.1e3, 2.2e3, 1.0, 2.0, 3.0]},
        )
        self.assertEqual(
            model.deck["initial"],
            [{"body": "second", "velocity": [0, 0, -3], "angular_velocity": [0, 0, 7]}],
        )
        self.accept(text)
        self.assertIn("PART_INERTIA", self.refusals(text.replace("*MAT_RIGID\n", "*MAT_ELASTIC\n").replace("0.3\n1.0,0,0\n\n", "0.3\n")))

    def test_joints_and_nodes_that_move_with_bodies(self):
        model = self.read(decks.JOINTED)[0]
        self.assertEqual(model.deck["rigid_sets"], {"hub": {"nodes": "hub"}, "extra_4": {"nodes": "extra_4", "body": "second"}})
        self.assertEqual(model.node_sets["extra_4"], [131])
        self.assertEqual(model.node_sets["hub"], [132, 133])
        self.assertEqual(
            model.deck["joints"],
            {
                "hinge": {"kind": "revolute", "bodies": ["block_of_steel", "second"], "at": [2, 0.5, 0.5], "axis": [0, 0, 1]},
                "joint_105": {"kind": "spherical", "bodies": ["second", "hub"], "at": [4, 1, 1]},
            },
        )
        self.accept(decks.JOINTED)
        held = decks.JOINTED.replace("BODY_TITLE\nhub\n20,0,13\n", "BODY_SPC_TITLE\nhub\n20,0,13\n1,3,4\n")
        self.assertEqual(self.read(held)[0].deck["rigid_sets"]["hub"], {"nodes": "hub", "fixed": ["z", "rx", "ry"]})

    def test_joints_that_are_none_are_refused(self):
        def refusals(old, new):
            return self.refusals(decks.JOINTED.replace(old, new))

        revolute, spherical = "CONSTRAINED_JOINT_REVOLUTE", "CONSTRAINED_JOINT_SPHERICAL"
        self.assertIn("not at one place", refusals("104,2.0,0.5,1.5", "104,2.0,0.5,1.6")[revolute])
        self.assertIn("node 101 of the joint is on no rigid body", refusals("11\n101,103", "11\n103")[revolute])
        self.assertIn("within one rigid body", refusals("*CONSTRAINED_EXTRA_NODES_SET\n3,11", "*CONSTRAINED_EXTRA_NODES_SET\n4,11")[revolute])
        self.assertIn("no direction", refusals("101,102,103,104", "101,102,101,102")[revolute])
        self.assertIn(spherical + ".N3", refusals("105,106", "105,106,107"))
        self.assertIn("CONSTRAINED_JOINT_GEARS", refusals(spherical, "CONSTRAINED_JOINT_GEARS"))
        self.assertIn("CONSTRAINED_NODAL_RIGID_BODY.DRFLAG", refusals("20,0,13", "20,0,13,0,0,1"))
        self.assertIn("CONSTRAINED_NODAL_RIGID_BODY_SPC.CMO", refusals("BODY_TITLE\nhub\n20,0,13\n", "BODY_SPC_TITLE\nhub\n20,0,13\n-1,1,1\n"))
        self.fails(decks.JOINTED.replace("105,106", "105,999"), "there is no node 999")

    def test_sensors_matter_where_something_listens(self):
        card = "*SENSOR_DEFINE_FORCE\n1,RWALL,2,X,,0\n*END"
        model, ledger = self.read(decks.SMALL.replace("*END", card))
        self.assertEqual(ledger.list_refused(), [])
        self.assertIn("SENSOR_DEFINE_FORCE", {e.card for e in ledger.list_rows() if e.status is Status.IGNORED})
        refused = self.refusals(decks.SMALL.replace("*END", "*SENSOR_CONTROL\n1,TIMER\n" + card))
        self.assertEqual(set(refused), {"SENSOR_CONTROL", "SENSOR_DEFINE_FORCE"})

    def test_walls_are_cylinders_and_spheres(self):
        model, ledger = self.read(decks.ROUND_WALLS)
        self.assertEqual(ledger.list_refused(), [])
        pole, ball, floor = model.deck["walls"]
        self.assertEqual(pole["name"], "pole")
        self.assertEqual(pole["cylinder"], {"axis": [0, 0, 1], "radius": 0.4, "length": 2.5})
        self.assertEqual((pole["direction"], pole["friction"]), ([0, 0.6, 0.8], 0.2))
        self.assertNotIn("normal", pole)
        self.assertEqual(pole["speed"]["table"][0], [0, 2])
        self.assertEqual((ball["sphere"], ball["point"]), ({"radius": 1.5}, [0, 0, 9]))
        self.assertEqual(floor["rectangle"]["size"], [6, 5])
        # the way 2 + 2 t along z, against the normal -z
        self.assertEqual({y for _, y in floor["speed"]["table"]} if isinstance(floor["speed"], dict) else {floor["speed"]}, {-2})
        for wrong in ("GEOMETRIC_PRISM", "GEOMETRIC_CYLINDER_INTERIOR", "GEOMETRIC_CYLINDER_DEFORM"):
            ledger = self.read(decks.SMALL.replace("*END", f"*RIGIDWALL_{wrong}\n0\n0,0,9\n1\n*END"))[1]
            self.assertEqual([e.card for e in ledger.list_refused()], [f"RIGIDWALL_{wrong}"])
        self.accept(decks.ROUND_WALLS)

    def test_walls_end_and_give_way(self):
        card = "*RIGIDWALL_PLANAR_FINITE_MOVING_ID\n5,ram\n0\n-1,-1,3,-1,-1,0,0.2\n4,-1,0,6.0,5.0\n500.0,12.0\n*END"
        wall = self.read(decks.SMALL.replace("*END", card))[0].deck["walls"][0]
        self.assertEqual(wall["rectangle"], {"along": [1, 0, 0], "size": [6, 5]})
        self.assertEqual((wall["mass"], wall["start_speed"], wall["normal"]), (500, 12, [0, 0, -1]))
        self.accept(decks.SMALL.replace("*END", card))
        self.assertIn("RIGIDWALL_PLANAR_MOVING", self.refusals(decks.TWO_RIGID.replace("*END", card)))
        one_length = card.replace("6.0,5.0", "6.0,0.0")
        self.assertIn("RIGIDWALL_PLANAR_FINITE", self.refusals(decks.SMALL.replace("*END", one_length)))

    def test_damping_in_proportion_to_mass_is_that_of_parts_or_of_all(self):
        cards = "*DAMPING_PART_MASS\n3,9,40.0\n*DAMPING_GLOBAL\n0,5.0\n*DEFINE_CURVE\n9\n0,1\n2e-5,1\n3e-5,0\n1,0\n*END"
        deck = decks.SMALL.replace("*END", cards)
        of_all, of_part = self.read(deck)[0].deck["damping"]
        self.assertEqual(of_all, {"coefficient": 5.0})
        self.assertEqual(of_part["coefficient"]["table"][:3], [[0, 40], [2e-5, 40], [3e-5, 0]])
        self.accept(deck)
        with self.assertRaisesRegex(BadInput, "would add energy"):
            self.read(decks.SMALL.replace("*END", "*DAMPING_GLOBAL\n0,-5.0\n*END"))

    def test_gravity_follows_its_curve(self):
        cards = "*LOAD_BODY_Z\n9,9.81\n*LOAD_BODY_X\n9,2\n*DEFINE_CURVE\n9\n0,0\n2e-5,1\n1,1\n*END"
        deck = decks.SMALL.replace("*END", cards)
        gravity = self.read(deck)[0].deck["loads"]["gravity"]
        self.assertEqual(gravity[1], 0)
        self.assertEqual(gravity[0]["table"][:2], [[0, 0], [2e-5, -2]])
        self.assertEqual(gravity[2]["table"][:2], [[0, 0], [2e-5, -9.81]])
        self.accept(deck)

    def test_settings_of_a_part_stay_with_it(self):
        text = decks.TWO_PARTS.replace("4,4,3\n", "4,4,3,0,9\n").replace("*END", "*HOURGLASS\n9,4,0.03,0,1.0,0.1\n*END")
        model = self.read(text)[0]
        self.assertNotIn("elements", model.deck)
        self.assertEqual(model.blocks[1].keys["hourglass"], {"kind": "stiffness", "coefficient": 0.03})
        self.assertEqual(model.blocks[1].keys["bulk_viscosity"], {"linear": 0.1, "quadratic": 1.0})
        self.accept(text)
        full = text.replace("*SECTION_SOLID\n4,1\n", "*SECTION_SOLID\n4,2\n")
        self.assertEqual(self.read(full)[0].blocks[1].keys["integration"], "full")
        self.assertNotIn("hourglass", self.read(full)[0].blocks[1].keys)
        self.accept(full)

    def test_a_fluid_has_the_hourglass_control_of_percuss(self):
        text = decks.TWO_PARTS.replace("4,4,3\n", "4,4,8\n").replace("*END", "*MAT_ELASTIC_FLUID\n8,1000.0,0,0,0,0,2.2e9\n0\n*END")
        model = self.read(text)[0]
        self.assertNotIn("elements", model.deck)
        self.assertNotIn("hourglass", model.blocks[1].keys)
        self.accept(text)
        solid = text.replace("*END", "*CONTROL_HOURGLASS\n4,0.03\n*HOURGLASS\n9,1,1e-4\n*END").replace("4,4,8\n", "4,4,8,0,9\n")
        self.assertEqual(self.read(solid)[0].blocks[1].keys["hourglass"], {"kind": "viscous", "coefficient": 1e-4})
        self.accept(solid)

    def test_hourglass_control_of_shells_is_a_share_of_their_stiffness(self):
        text = decks.FORMS.replace("*PART\nplate\n         8         8         8\n", "*PART\nplate\n8,8,8,0,19\n")
        text = text.replace("*END", "*HOURGLASS\n19,4,0.02\n*END")
        full = self.read(text)[0]  # ELFORM 16 has no hourglass modes
        self.assertTrue(all("shell_hourglass" not in block.keys for block in full.blocks))
        model, ledger = self.read(text.replace("         8        16    0.8333", "         8         2    0.8333"))
        self.assertEqual([block.keys["shell_hourglass"] for block in model.blocks if block.shells], [0.02])
        told = [row for row in ledger.list_rows() if row.card == "HOURGLASS.QM"]
        self.assertEqual([row.status for row in told], [Status.APPROXIMATED])

    def test_friction_of_parts_becomes_rows(self):
        text = decks.TWO_PARTS.replace("*PART\nsecond\n4,4,3\n", "*PART_CONTACT\nsecond\n4,4,3\n0.4\n")
        text = text.replace("*END", "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n-1.0\n0\n*END")
        self.assertEqual(
            self.read(text)[0].deck["contact"],
            {"surfaces": "all", "friction": {"default": 0.0, "pairs": [{"a": "second", "friction": 0.4}]}},
        )
        self.accept(text)


class Strictness(InFolder):
    def test_nothing_is_dropped_silently(self):
        for card, key in (("*CONSTRAINED_INTERPOLATION\n1,2\n", "CONSTRAINED_INTERPOLATION"), ("*SOMETHING_NEW\n1\n", "SOMETHING_NEW"),
                          ("*CONTROL_IMPLICIT_GENERAL\n1\n", "CONTROL_IMPLICIT_GENERAL"), ("*DAMPING_PART_STIFFNESS\n3,0.1\n", "DAMPING_PART_STIFFNESS.COEF"),
                          ("*DAMPING_GLOBAL\n0,1.0,1,0,0\n", "DAMPING_GLOBAL.STX"),
                          ("*RIGIDWALL_PLANAR_ORTHO\n0\n0,0,-1,0,0,1\n0\n0\n", "RIGIDWALL_PLANAR_ORTHO"),
                          ("*INCLUDE_STAMPED_PART\nx.k\n", "INCLUDE_STAMPED_PART"),
                          ("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK\n3,3,3,3\n0\n0\n4\n", "CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK"),
                          ("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0\n0.1,0,0,0,0,0,7,-9999\n0\n", "CONTACT.DT")):  # fmt: skip
            with self.subTest(key):
                self.assertIn(key, self.refusals(decks.SMALL.replace("*END", card + "*END")))

    def test_a_refusal_ends_with_its_place_and_code_2_and_writes_no_deck(self):
        path = self.write(decks.SMALL.replace("*END", "*CONSTRAINED_INTERPOLATION\n1,2\n*END"))
        done = self.percuss("import", path, "--out", "out")
        self.assertEqual(done.returncode, 2)
        self.assertIn("deck.k:34: error: *CONSTRAINED_INTERPOLATION", done.stderr)
        for line in filter(lambda line: "error: *" in line, done.stderr.splitlines()):  # problem (reason): what to do; then what follows
            self.assertRegex(line, r"error: \*[A-Z_.]+: .+ \(.+\): change or remove it, or use --allow [A-Z_.]+; then .+")
        self.assertFalse(os.path.exists(os.path.join(self.folder, "out/deck.yaml")))
        self.assertTrue(os.path.exists(os.path.join(self.folder, "out/import_report.md")))
        done = self.percuss("import", path, "--out", "out", "--allow", "constrained_*,nothing")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("--allow NOTHING fits nothing", done.stderr)
        self.assertIn("left out or approximated, as you allow", done.stdout)

    def test_an_edited_deck_is_overwritten_with_force_alone(self):
        path, deck = self.write(decks.SMALL), os.path.join(self.folder, "out/deck.yaml")
        again = ("import", path, "--out", "out", "--no-check", "--quiet")
        self.assertEqual(self.percuss(*again).returncode, 0)
        done = self.percuss(*again)
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stderr, "out/deck.yaml: error: there is a deck.yaml of an earlier import, which would be lost (an import overwrites "
                                      "nothing without --force): choose another folder with --out, or give --force\n")
        with open(deck, "a", encoding="utf-8") as file:
            file.write("# edited\n")
        done = self.percuss(*again)
        self.assertEqual(done.returncode, 2)
        self.assertIn("out/deck.yaml: error: this deck was edited after its import, and the edits would be lost (", done.stderr)
        with open(deck, encoding="utf-8") as file:
            self.assertTrue(file.read().endswith("# edited\n"))
        self.assertEqual(self.percuss(*again, "--force").returncode, 0)
        with open(deck, encoding="utf-8") as file:
            self.assertNotIn("# edited", file.read())

    def test_a_deck_beside_which_nothing_tells_of_its_import_is_kept(self):
        self.write("time: {end: 1}\n", "out/deck.yaml")
        done = self.percuss("import", self.write(decks.SMALL), "--out", "out")
        self.assertEqual(done.returncode, 2)
        self.assertIn("out/deck.yaml: error: there is a deck already, which would be lost (", done.stderr)
        self.assertEqual(os.listdir(os.path.join(self.folder, "out")), ["deck.yaml"])

    def test_a_mesh_is_not_written_over_the_model(self):
        self.write(decks.SMALL, "mesh.k")
        done = self.percuss("import", "mesh.k", "--out", ".", "--force")
        self.assertEqual(done.returncode, 2)
        self.assertIn("mesh.k: error: this is the model itself (", done.stderr)
        with open(os.path.join(self.folder, "mesh.k"), encoding="utf-8") as file:
            self.assertEqual(file.read(), decks.SMALL)

    def test_no_file_of_the_model_is_written_over(self):
        nodes, rest = decks.SMALL.index("*NODE"), decks.SMALL.index("*", decks.SMALL.index("*NODE") + 1)
        part = "*KEYWORD\n" + decks.SMALL[nodes:rest]
        for name in ("mesh.k", "deck.yaml", "import_report.md"):
            main, included = self.write(decks.SMALL[:nodes] + f"*INCLUDE\n{name}\n" + decks.SMALL[rest:], f"{name}_of/main.k"), f"{name}_of/{name}"
            self.write(part, included)
            done = self.percuss("import", main, "--out", f"{name}_of", "--force", "--no-check")
            self.assertEqual(done.returncode, 2, done.stdout)
            self.assertIn(f"{included}: error: this is a file that the model includes (", done.stderr)
            with open(os.path.join(self.folder, included), encoding="utf-8") as file:
                self.assertEqual(file.read(), part)
            self.assertEqual(sorted(os.listdir(os.path.dirname(main))), sorted(["main.k", name]))
        main = self.write(decks.ABAQUS + "*INCLUDE, INPUT=mesh.k\n", "abaqus/main.inp")
        self.write("** nothing\n", "abaqus/mesh.k")
        done = self.percuss("import", main, "--out", "abaqus", "--force", "--no-check")
        self.assertIn("abaqus/mesh.k: error: this is a file that the model includes (", done.stderr)

    def test_a_file_is_of_an_earlier_import_where_the_report_says_so(self):
        path = self.write(decks.SMALL)
        self.write("mine\n", "out/mesh.k")
        done = self.percuss("import", path, "--out", "out")
        self.assertIn("out/mesh.k: error: there is a mesh.k already, which would be lost (", done.stderr)
        self.assertEqual(self.percuss("import", path, "--out", "out", "--no-check", "--force").returncode, 0)
        os.remove(os.path.join(self.folder, "out/deck.yaml"))
        done = self.percuss("import", path, "--out", "out")
        self.assertIn("out/mesh.k: error: there is a mesh.k of an earlier import, which would be lost (", done.stderr)

    def test_a_report_that_no_import_wrote_proves_nothing(self):
        path, report = self.write(decks.SMALL), os.path.join(self.folder, "out/import_report.json")
        self.write("mine\n", "out/mesh.k")
        refused = "out/mesh.k: error: there is a mesh.k already, which would be lost ("
        for text in ("[" * 200000, '{"deck_sha256": 1}', "[]", '{"deck_sha256": "' + "0" * (65 << 20) + '"}'):
            self.write(text, "out/import_report.json")
            done = self.percuss("import", path, "--out", "out")
            self.assertEqual((done.returncode, done.stderr[: len(refused)]), (2, refused))
        os.remove(report)
        os.mkfifo(report)
        done = subprocess.run([PERCUSS, "import", path, "--out", "out"], capture_output=True, text=True, cwd=self.folder, timeout=60, check=False)
        self.assertEqual((done.returncode, done.stderr[: len(refused)]), (2, refused))
        done = subprocess.run([PERCUSS, "import", path, "--out", "out", "--force"], capture_output=True, text=True, cwd=self.folder, timeout=60, check=False)
        self.assertEqual(done.returncode, 2)
        self.assertIn("out/import_report.json: error: this is not a regular file (", done.stderr)

    def test_units_are_hinted_at_and_not_assumed(self):
        done = self.percuss("import", self.write(decks.SMALL), "--out", "out")
        self.assertIn("would fit 'm, kg, s'", done.stdout)
        with open(os.path.join(self.folder, "out/deck.yaml"), encoding="utf-8") as file:
            self.assertNotIn("units:", file.read())

    def test_wrong_words_end_with_code_2(self):
        self.assertEqual(self.percuss("import", "none.k", "--out", "out").returncode, 2)
        self.assertEqual(self.percuss("import", self.write("x", "a.txt"), "--out", "out").returncode, 2)
        self.assertEqual(self.percuss("import", self.write(decks.SMALL)).returncode, 2)


class Abaqus(InFolder):
    def test_tetrahedra_stand_beside_hexahedra_of_either_integration(self):
        for kind in ("C3D8", "C3D8R"):
            text = decks.ABAQUS.replace("TYPE=C3D8R", f"TYPE={kind}").replace(
                "*NSET, NSET=foot", "*NODE\n9, 0., 0., 2.\n*ELEMENT, TYPE=C3D4, ELSET=all\n2, 5, 6, 8, 9\n*NSET, NSET=foot"
            )
            path = os.path.join(self.folder, "deck.inp")
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
            model = read_abaqus_deck(path, Ledger(allowed=["ALL"]))
            self.assertIn(4, [len(corners) for block in model.blocks for _, corners in block.solids])
            self.assertEqual(model.deck.get("elements", {}).get("integration", "one_point"), "full" if kind == "C3D8" else "one_point")

    def test_analytical_surfaces_are_walls(self):
        model, ledger = self.read_abaqus(decks.ABAQUS_ROLLER)
        self.assertEqual(ledger.list_refused(), [])
        (wall,) = model.deck["walls"]
        self.assertEqual(wall["cylinder"]["radius"], 0.5)
        self.assertEqual(wall["cylinder"]["length"], 3)
        for found, exact in zip((*wall["cylinder"]["axis"], *wall["point"]), (-1, 0, 0, 1.5, 0, 2)):
            self.assertAlmostEqual(found, exact, 12)
        self.assertEqual((wall["friction"], wall["thickness"], wall["direction"]), (0.25, "included", "z"))
        self.assertEqual([round(x, 9) for x in wall["speed"]["table"][-1]], [1e-4, -4])
        self.accept(decks.ABAQUS_ROLLER, "deck.inp")
        ball = "START, 0., 2.\n CIRCL, 0.5, 1.5, 0., 1.5\n CIRCL, 0., 1., 0., 1.5\n"
        line = "START, 0.5, 2.\n LINE, 0.5, -1.\n"
        sphere = self.read_abaqus(decks.ABAQUS_ROLLER.replace(line, ball))[0].deck["walls"][0]
        self.assertAlmostEqual(sphere["sphere"]["radius"], 0.5)
        self.assertAlmostEqual(sphere["point"][0], 0.5 - 1.5)
        for old, new in ((line, "START, 0.5, -1.\n LINE, 0.5, 2.\n"), (line, "START, 0.5, 2.\n LINE, 0.7, -1.\n"),
                         ("roll-1.ref, 1, 2\n", ""), ("roll-1.ref, 4, 6\n", "roll-1.ref, 4, 5\n")):  # fmt: skip
            model, ledger = self.read_abaqus(decks.ABAQUS_ROLLER.replace(old, new))  # from inside, a cone, or free: rigid shells
            self.assertEqual((ledger.list_refused(), model.deck.get("walls")), ([], None))
            self.assertTrue(model.blocks[-1].keys["rigid"])
            self.assertEqual(len(model.blocks[-1].shells), 48 * 20)

    def test_tetrahedra_of_ten_nodes_keep_their_nodes_and_faces(self):
        corners = {5: (0, 0, 1), 6: (1, 0, 1), 8: (0, 1, 1), 9: (0, 0, 2)}
        edges = ((5, 6), (6, 8), (8, 5), (5, 9), (6, 9), (8, 9))
        nodes = "".join(
            f"{21 + i}, {', '.join(str(0.5 * (a + b)) for a, b in zip(corners[first], corners[second]))}\n" for i, (first, second) in enumerate(edges)
        )
        for kind in ("C3D10", "C3D10M"):
            text = decks.ABAQUS.replace(
                "*NSET, NSET=foot", f"*NODE\n9, 0., 0., 2.\n{nodes}*ELEMENT, TYPE={kind}, ELSET=all\n2, 5, 6, 8, 9, 21, 22, 23, 24,\n25, 26\n"
                "*SURFACE, NAME=slope\n2, S3\n*NSET, NSET=foot", 1)  # fmt: skip
            model, ledger = self.read_abaqus(text)
            self.assertIn((5, 6, 8, 9, *range(21, 27)), [corners for block in model.blocks for _, corners in block.solids])
            self.assertIn(f"ELEMENT.{kind}", {e.card for e in ledger.list_rows()})

    def test_wedges_and_pyramids_are_solids_of_one_point(self):
        for kind, corners in (("C3D6", "5, 6, 8, 9, 10, 11"), ("C3D5", "5, 6, 7, 8, 9"), ("C3D8", "5, 6, 7, 8, 9, 9, 9, 9")):
            text = decks.ABAQUS.replace(
                "*NSET, NSET=foot", "*NODE\n9, 0., 0., 2.\n10, 1., 0., 2.\n11, 0., 1., 2.\n"
                f"*ELEMENT, TYPE={kind}, ELSET=all\n2, {corners}\n*NSET, NSET=foot", 1)  # fmt: skip
            model, ledger = self.read_abaqus(text)
            counts = [len(found) for block in model.blocks for _, found in block.solids]
            self.assertIn(6 if kind == "C3D6" else 5, counts)
            self.assertFalse([e.card for e in ledger.list_refused() if e.card.startswith("ELEMENT")])
            if kind == "C3D6":  # the others cover the top of the block, on which the deck has a pressure
                self.accept(text, "deck.inp")

    def test_integration_is_of_each_section(self):
        text = decks.ABAQUS.replace("*NSET, NSET=foot", "*NODE\n" + "".join(
            f"{i + 20}, {x}., {y}., {z + 5}.\n" for i, (x, y, z) in enumerate(
                ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))))
            + "*ELEMENT, TYPE=C3D8, ELSET=stiff\n2, 20, 21, 22, 23, 24, 25, 26, 27\n*NSET, NSET=foot", 1).replace(
            "*END PART", "*SOLID SECTION, ELSET=stiff, MATERIAL=steel\n,\n*END PART", 1)  # fmt: skip
        model = self.read_abaqus(text)[0]
        self.assertNotIn("elements", {k: v for k, v in model.deck.items() if "integration" in v})
        self.assertEqual([block.keys.get("integration") for block in model.blocks], [None, "full", None])
        self.accept(text, "deck.inp")

    def test_friction_of_two_surfaces_is_theirs(self):
        row = "\nblock-1.top, plate-1.lower, slick\n"
        text = decks.ABAQUS.replace("*BOUNDARY\n", "*SURFACE INTERACTION, NAME=slick\n*FRICTION\n0.05,\n*BOUNDARY\n", 1)
        text = text.replace("*CONTACT PROPERTY ASSIGNMENT\n", "*CONTACT PROPERTY ASSIGNMENT" + row, 1)
        friction = self.read_abaqus(text)[0].deck["contact"]["friction"]
        self.assertEqual(friction["default"], 0.25)
        self.assertEqual([r["friction"] for r in friction["pairs"]], [0.05])
        self.accept(text, "deck.inp")

    def test_thickness_of_nodes_is_averaged(self):
        text = decks.ABAQUS.replace(
            "MATERIAL=soft, OFFSET=SNEG\n0.1, 5\n",
            "MATERIAL=soft, NODAL THICKNESS\n0.1, 5\n*NODAL THICKNESS\n1, 0.1\n2, 0.3\n3, 0.3\n4, 0.1\n5, 0.3\n", 1)  # fmt: skip
        model, ledger = self.read_abaqus(text)
        block = next(block for block in model.blocks if block.shells)
        self.assertEqual(ledger.list_refused(), [])
        self.assertEqual([round(block.thicknesses[id], 12) for id, _ in block.shells], [0.2, 0.3])
        missing = text.replace("4, 0.1\n5, 0.3\n", "", 1)
        with self.assertRaisesRegex(BadInput, "has a node without a thickness"):
            self.read_abaqus(missing)
        self.accept(text, "deck.inp")

    def test_plastic_work_heats_where_the_step_is_adiabatic(self):
        law = "*PLASTIC, HARDENING=JOHNSON COOK\n1.e8, 6.e7, 0.3, 1.1, 900., 25.\n*SPECIFIC HEAT\n875.,\n*INELASTIC HEAT FRACTION\n0.8,\n*CONDUCTIVITY\n200.,\n"
        cold = decks.ABAQUS.replace("*PLASTIC\n1.e8, 0.\n1.5e8, 0.2\n*RATE DEPENDENT, TYPE=POWER LAW\n6500., 4.\n", law)
        start = "*INITIAL CONDITIONS, TYPE=TEMPERATURE\nblock-1.whole, 40.\nplate-1.every, 40.\n*STEP\n"
        warm = cold.replace("*STEP\n", start).replace("*NSET, NSET=foot", "*NSET, NSET=whole, ELSET=all\n*NSET, NSET=foot")
        adiabatic = warm.replace("*DYNAMIC, EXPLICIT", "*DYNAMIC, EXPLICIT, ADIABATIC")
        coupled = warm.replace("*DYNAMIC, EXPLICIT", "*DYNAMIC TEMPERATURE-DISPLACEMENT, EXPLICIT").replace("C3D8R", "C3D8RT")
        for text, found, refused in (
            (cold, (1e15, None, 25), set()),
            (cold.replace("*DYNAMIC, EXPLICIT", "*DYNAMIC, EXPLICIT, ADIABATIC"), (875, 0.8, 0), set()),
            (adiabatic, (875, 0.8, 40), set()),
            (coupled, (875, 0.8, 40), set()),
            (coupled.replace("*CONDUCTIVITY\n200.", "*CONDUCTIVITY\n2e9"), (875, 0.8, 40), {"DYNAMIC TEMPERATURE-DISPLACEMENT"}),
            (adiabatic.replace("plate-1.every, 40.", "plate-1.every, 50."), (875, 0.8, 50), set()),
        ):
            model, ledger = self.read_abaqus(text)
            self.assertEqual({entry.card for entry in ledger.list_refused()}, refused)
            (law,) = (law for law in model.materials.values() if law["model"] == "johnson_cook")
            self.assertEqual(tuple(law.get(key) for key in ("specific_heat", "heating_share", "start_temperature")), found)
        self.accept(adiabatic, "deck.inp")
        several = adiabatic.replace("plate-1.every, 40.\n", "plate-1.every, 40.\ntip, 70.\n")
        model, _ = self.read_abaqus(several)
        rows = [row.split(",") for row in model.tables["temperatures.csv"]]
        self.assertEqual(rows[0], ["element", "temperature"])
        self.assertEqual(sorted(float(row[1]) for row in rows[1:]), [40.0, 50.0])  # the triangle has the tip
        self.accept(several, "deck.inp")
        for text, found in ((adiabatic.replace(", 40.", ", 900."), [25.0]), (several.replace("tip, 70.", "tip, 9000."), [40.0])):
            _, ledger = self.read_abaqus(text)
            self.assertEqual({entry.card for entry in ledger.list_refused()}, {"INITIAL CONDITIONS.melt"})
            model, ledger = self.read_abaqus(text, "INITIAL CONDITIONS.melt")
            self.assertEqual(ledger.list_refused(), [])
            self.assertEqual([law["start_temperature"] for law in model.materials.values() if law["model"] == "johnson_cook"], found)
            temperatures = [float(row.split(",")[1]) for row in model.tables.get("temperatures.csv", [])[1:]]
            self.assertEqual(sorted(set(temperatures)), [25.0, 40.0] if temperatures else [])

    def test_stresses_and_plastic_strains_of_abaqus_become_tables(self):
        text = decks.ABAQUS_STRESSED
        model, _ = self.read_abaqus(text)
        self.assertEqual(model.deck["start"], {"fields": [{"file": "stresses.csv"}, {"file": "plastic_strains.csv"}]})
        self.assertEqual([row.partition(",")[2] for row in model.tables["stresses.csv"][1:]], ["1.0,2.0,3.0,4.0,6.0,5.0"])
        self.assertEqual([row.partition(",")[2] for row in model.tables["plastic_strains.csv"][1:]], ["0.01", "0.01"])
        self.accept(text, "deck.inp")
        for old, new, name in (
            ("block-1.all, 1.", "plate-1.shell, 1.", "elements"),
            ("shell, 0.01", "shell, 0.01, 1.e6", "back_stress"),
        ):
            _, ledger = self.read_abaqus(text.replace(old, new))
            self.assertEqual({entry.card for entry in ledger.list_refused()}, {f"INITIAL CONDITIONS.{name}"})

    def test_stresses_that_elements_of_abaqus_cannot_begin_with_are_refused(self):
        def with_stress(text, extra=""):
            return text.replace("*STEP\n", f"*INITIAL CONDITIONS, TYPE=STRESS\nblock-1.all, 1., 2., 3., 4., 5., 6.\n{extra}*STEP\n")

        strain = "*INITIAL CONDITIONS, TYPE=HARDENING\nblock-1.all, 0.01\n"
        rubber = decks.ABAQUS.replace("7850.,\n*ELASTIC\n2.e11, 0.3\n", "1200.,\n*HYPERELASTIC, NEO HOOKE\n1.e6, 1.e-8\n")
        self.assertNotEqual(rubber, decks.ABAQUS)
        for text, refused in (
            (with_stress(decks.ABAQUS_BODIES), 1), (with_stress(rubber), 1), (with_stress(decks.ABAQUS), 0),
            (with_stress(decks.ABAQUS, strain), 1), (with_stress(decks.ABAQUS_BODIES).replace("1., 2., 3., 4., 5., 6.", "0., 0., 0., 0., 0., 0."), 0),
        ):  # fmt: skip
            _, ledger = self.read_abaqus(text)
            self.assertEqual([entry.card for entry in ledger.list_refused()], ["INITIAL CONDITIONS.material"] * refused)

    def test_of_two_stresses_of_abaqus_the_later_counts(self):
        again = "*INITIAL CONDITIONS, TYPE=STRESS\nblock-1.all, 2., 2., 2., 2., 2., 2.\n*STEP\n"
        text = decks.ABAQUS_STRESSED.replace("*STEP\n", again)
        model, _ = self.read_abaqus(text)
        self.assertEqual([row.partition(",")[2] for row in model.tables["stresses.csv"][1:]], ["2.0,2.0,2.0,2.0,2.0,2.0"])
        self.accept(text, "deck.inp")

    def test_a_deck_with_instances_is_accepted(self):
        done = self.percuss("import", self.write(decks.ABAQUS, "deck.inp"), "--out", "out")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("mass: 8255", done.stdout)

    def test_springs_and_dampers(self):
        lines = """*ELEMENT, TYPE=SPRINGA, ELSET=soft
7, 1, 7
8, 2, 8
*ELEMENT, TYPE=DASHPOTA, ELSET=oil
9, 1, 7
*SPRING, ELSET=soft

1000.
*DASHPOT, ELSET=oil
,
3.5
"""
        text = decks.ABAQUS.replace("*NSET, NSET=foot", lines + "*NSET, NSET=foot")
        model, ledger = self.read_abaqus(text)
        self.assertEqual(ledger.list_refused(), [])
        springs = {"spring_7": {"between": [{"id": 1}, {"id": 7}], "stiffness": 1000}}
        springs["spring_8"] = {"between": [{"id": 2}, {"id": 8}], "stiffness": 1000}
        springs["spring_9"] = {"between": [{"id": 1}, {"id": 7}], "damping": 3.5}
        self.assertEqual(model.deck["springs"], springs)
        done = self.percuss("import", self.write(text, "deck.inp"), "--out", "out")
        self.assertEqual(done.returncode, 0, done.stderr)
        tabled = text.replace("*SPRING, ELSET=soft\n\n1000.", "*SPRING, ELSET=soft, NONLINEAR\n\n-2., -1.\n4., 1.")
        table = [[-3, -2], [-1, -2], [1, 4], [3, 4]]  # flat beyond its ends
        self.assertEqual(self.read_abaqus(tabled)[0].deck["springs"]["spring_7"]["table"], table)

    def test_instances_are_moved_then_turned(self):
        model, _ = self.read_abaqus(decks.ABAQUS)
        for found, expected in zip(model.nodes[105], (-0.5, 2.0, 1.2)):
            self.assertAlmostEqual(found, expected)
        self.assertEqual(model.node_sets["tip"], [105])
        self.assertEqual(model.blocks[1].shells, [(110, (101, 102, 103, 104)), (111, (102, 105, 103))])

    def test_sections_materials_and_loads(self):
        model, _ = self.read_abaqus(decks.ABAQUS)
        self.assertEqual(model.blocks[1].keys, {"material": "SOFT", "points": 5, "reference": "bottom"})
        self.assertEqual(model.materials["SOFT"]["hardening"], [[0, 1e8], [0.2, 1.5e8]])
        self.assertEqual(model.deck["loads"]["gravity"], [0, 0, -9.81])
        self.assertEqual(model.side_sets["block-1_top"], [(5, 8, 7, 6)])
        self.assertEqual(model.deck["contact"], {"surfaces": "all", "friction": 0.25})
        self.assertEqual(model.deck["initial"], [{"nodes": "PLATE-1", "velocity": [0, 0, -10]}])
        self.assertEqual(model.deck["conditions"][1]["velocity"]["x"]["table"], [[0, 0], [5e-5, 2], [1e-4, 2]])

    def test_bodies_are_held_at_their_reference_nodes(self):
        model, _ = self.read_abaqus(decks.ABAQUS_BODIES)
        self.assertIs(model.blocks[0].keys["rigid"], True)
        name = model.blocks[0].name
        self.assertEqual(model.deck["joints"], {"held_1": {"kind": "revolute", "bodies": [name], "at": [0.5, 0.5, -1], "axis": "z"}})
        self.assertEqual(
            model.deck["rigid_sets"], {"rigid_2": {"nodes": "rigid_2", "fixed": ["x", "y", "z", "rx", "ry", "rz"]}}
        )
        self.assertEqual(model.node_sets["rigid_2"], [101, 104])
        self.accept(decks.ABAQUS_BODIES, "deck.inp")
        pinned = self.read_abaqus(decks.ABAQUS_BODIES.replace("900, 1, 5", "900, PINNED"))[0].deck["joints"]["held_1"]
        self.assertEqual(pinned, {"kind": "spherical", "bodies": [name], "at": [0.5, 0.5, -1]})

    def test_constraints_by_nodes_are_one_body_where_they_meet(self):
        lines = "*MPC\nBEAM, plate-1.1, plate-1.4\nBEAM, plate-1.4, plate-1.5\n*END ASSEMBLY\n"
        model, _ = self.read_abaqus(decks.ABAQUS.replace("*END ASSEMBLY\n", lines))
        self.assertEqual(model.deck["rigid_sets"], {"rigid_1": {"nodes": "rigid_1"}})
        self.assertEqual(model.node_sets["rigid_1"], [101, 104, 105])

    def test_equations_of_two_terms_are_constraints(self):
        lines = (
            "*EQUATION\n2\nplate-1.1, 1, 1., plate-1.4, 1, -1.\n2\nplate-1.1, 3, 2., plate-1.4, 3, -2.\n"
            "*MPC\nPIN, plate-1.2, plate-1.5\n*END ASSEMBLY\n"
        )
        text = decks.ABAQUS.replace("*END ASSEMBLY\n", lines)
        self.assertEqual(
            self.read_abaqus(text)[0].deck["constraints"],
            {
                "equal_1": {"equal": ["x", "z"], "between": [{"id": 101}, {"id": 104}]},
                "equal_2": {"equal": ["x", "y", "z"], "between": [{"id": 102}, {"id": 105}]},
            },
        )
        self.accept(text, "deck.inp")
        for old, new in (("1, 1., plate", "1, 1.5, plate"), ("3, -2.", "2, -2."), ("2\nplate-1.1, 1", "3\nplate-1.1, 1")):
            with self.subTest(new):
                changed = text.replace(old, new).replace("1, -1.\n2", "1, -1., plate-1.2, 1, 1.\n2" if new[0] == "3" else "1, -1.\n2")
                model, ledger = self.read_abaqus(changed)
                self.assertEqual(ledger.list_refused(), [])
                self.assertEqual([len(entry["equation"]) for entry in model.deck["constraints"].values() if "equation" in entry], [3 if new[0] == "3" else 2])
                self.accept(changed, "deck.inp")

    def test_damping_of_a_material(self):
        text = decks.ABAQUS.replace("*DENSITY\n", "*DAMPING, ALPHA=20., BETA=1e-7\n*DENSITY\n")
        model, _ = self.read_abaqus(text)
        self.assertEqual([block.keys.get("stiffness_damping") for block in model.blocks], [1e-7, 1e-7])
        self.assertEqual(model.deck["damping"], [{"nodes": block.name, "coefficient": 20} for block in model.blocks])
        self.accept(text, "deck.inp")

    def test_bodies_that_are_free_in_part_are_refused(self):
        for old, new, key in (("900, 1, 5", "900, 1, 4", "BOUNDARY.reference"), ("*KINEMATIC\n*END", "*KINEMATIC\n1, 3\n*NODE\n902, 0., 0., 4.\n*COUPLING, CONSTRAINT NAME=d, REF NODE=902, SURFACE=coupled\n*KINEMATIC\n1, 3\n*END", "KINEMATIC.free"),
                              ("*KINEMATIC\n", "*DISTRIBUTING\n", "DISTRIBUTING"), ("ELSET=block-1.all", "PIN NSET=plate-1.every", "RIGID BODY.PIN NSET"),
                              ("*KINEMATIC\n", "*KINEMATIC\n*MPC\nLINK, plate-1.1, plate-1.4\n", "MPC.LINK")):  # fmt: skip
            with self.subTest(key):
                refused = {entry.card for entry in self.read_abaqus(decks.ABAQUS_BODIES.replace(old, new))[1].list_refused()}
                self.assertIn(key, refused)

    def test_other_content_is_refused(self):
        for old, new, key in (("*DYNAMIC, EXPLICIT", "*STATIC", "STATIC"), ("C3D8R", "C3D8P", "ELEMENT.C3D8P"),
                              ("*BULK VISCOSITY", "*CONNECTOR BEHAVIOR", "CONNECTOR BEHAVIOR"), ("TYPE=POWER LAW", "TYPE=USER", "RATE DEPENDENT"),
                              ("*PLASTIC\n", "*PLASTIC, RATE=1.\n", "PLASTIC.RATE"), ("1.5e8, 0.2\n", "1.5e8, 0.2\n5.e7, 0.1, 300.\n9.e7, 0.2, 300.\n", "PLASTIC.TEMPERATURE"),
                              ("foot, ENCASTRE\n", "foot, 11, 11, 20.\n", "BOUNDARY.dof")):  # fmt: skip
            with self.subTest(key):
                refused = {entry.card for entry in self.read_abaqus(decks.ABAQUS.replace(old, new))[1].list_refused()}
                self.assertIn(key, refused)


class Tube(InFolder):
    def test_the_imported_tube_is_the_one_written_by_hand(self):
        scene = os.path.join(ROOT, "inputs/keyword_tube")
        done = self.percuss("import", os.path.join(scene, "tube.k"), "--out", "tube", "--units", "mm, t, s")
        self.assertEqual(done.returncode, 0, done.stderr)
        hashes, summaries = set(), []
        for deck, out in ((os.path.join(self.folder, "tube/deck.yaml"), "imported"), (os.path.join(scene, "deck.yaml"), "hand")):
            done = self.percuss("run", deck, "--out", out, "--quiet", "--set", "time.end=4e-4")
            self.assertEqual(done.returncode, 0, done.stderr)
            with open(os.path.join(self.folder, out, "summary.json"), encoding="utf-8") as file:
                summaries.append(json.load(file))
            hashes.add(summaries[-1]["state_hash"])
        self.assertEqual(len(hashes), 1)
        for summary in summaries:
            self.assertLess(abs(summary["energy"]["error"]), 1e-5)
            self.assertLess(summary["momentum"]["linear_error"], 1e-12)
            # 20.25 kg on the cap and 0.201 kg of steel at 12 m/s, before the wall takes some of it
            self.assertAlmostEqual(summary["energy"]["initial"] / (0.5 * (0.02025 + 2.0097e-4) * 12000**2), 1, 4)


if __name__ == "__main__":
    unittest.main()
