"""percuss import: what it refuses comes at once and can be allowed as it is typed; it needs no program: import_refusals_test.py ROOT PERCUSS."""

import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest

from given import PERCUSS, ROOT
from import_command import call_command
from proofs.pieces import abaqus, abaqus_cube, cube, deck, node_set, velocity

from percuss.importing.abaqus.lines import Block
from percuss.importing.abaqus.options import KNOWN, NUMERICS, check_options
from percuss.importing.laws import TRAITS, write_traits
from percuss.importing.ledger import Ledger, Place, Status, type_pattern

os.environ |= {"OMP_NUM_THREADS": "1", "PERCUSS_PROGRAM": PERCUSS}


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def call(self, text, *options):
        name = "deck.k" if text.startswith("*KEYWORD") else "deck.inp"
        with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
            file.write(text)
        return call_command([name, "--out", "m", "--quiet", "--force", *options], self.folder)


class Refusals(Case):
    def test_faults_of_all_cards_come_at_once(self):
        text = deck(cube(), "*INITIAL_VELOCITY\n0\nfast\n", "*LOAD_NODE_SET\n4,3,77,2.0\n", node_set(4, 1, 2), "*BOUNDARY_SPC_SET\n4,0,x\n")
        done = self.call(text)
        self.assertEqual(done.returncode, 2)
        for word in ("VX of *INITIAL_VELOCITY", "X of *BOUNDARY_SPC_SET"):
            self.assertIn(word, done.stderr)
        both = abaqus(abaqus_cube(), "*AMPLITUDE, NAME=a\n0., q\n*AMPLITUDE, NAME=b\n0., r\n")
        self.assertEqual(re.findall("'([qr])' in .AMPLITUDE", self.call(both).stderr.replace("\n", " ")), ["r", "q"])

    def test_what_shows_once_others_are_allowed_is_told_with_them(self):
        """Everything refused is in one message: with all of its options the import passes, or refuses nothing that it can allow."""
        text = abaqus(abaqus_cube(), "*NODE\n9, 6., 5., 35.\n*RIGID BODY, REF NODE=9, ELSET=cube, ISOTHERMAL=YES\n",
                      step="*BOUNDARY, TYPE=VELOCITY\n9, 3, 3, 100.\n*CLOAD, FOLLOWER\n8, 1, 2.\n")  # fmt: skip
        first = self.call(text)
        self.assertEqual(first.returncode, 2)
        typed = re.findall(r"use --allow (.*?); then", first.stderr)
        self.assertEqual(len(typed), 3)
        second = self.call(text, *(word for option in typed for word in ("--allow", *shlex.split(option))))
        self.assertEqual((second.returncode, "fits nothing" in second.stderr), (0, False), second.stderr)

    def test_check_is_among_them(self):
        """The check refuses two motions of one body; the importer refuses the option beside it."""
        body = "*NODE\n9, 5., 5., 15.\n*RIGID BODY, REF NODE=9, ELSET=cube, ISOTHERMAL=YES\n"
        text = abaqus(abaqus_cube(), body, step="*BOUNDARY\n9, 1, 6\n*BOUNDARY, TYPE=VELOCITY\n1, 1, 1, 5.\n")
        done = self.call(text)
        self.assertEqual(done.returncode, 2)
        self.assertIn("RIGID BODY.ISOTHERMAL", done.stderr)
        self.assertRegex(done.stderr, r"\*BOUNDARY: percuss check refuses")

    def test_options_are_typed_as_a_shell_takes_them(self):
        for key in ("MAT_RIGID", "RIGID BODY.POSITION", "ELEMENT, TYPE=C3D8I", "A[1]*?"):
            words = shlex.split(f"--allow {type_pattern(key)}")
            self.assertEqual(len(words), 2)
            ledger = Ledger(allowed=[word.strip().upper() for word in words[1].split(",")])
            self.assertTrue(ledger.allows(key), key)


class Numerics(unittest.TestCase):
    def test_each_option_is_ignored_with_its_reason(self):
        for keyword, options in NUMERICS.items():
            self.assertIn(keyword, KNOWN)
            for name, reason in options.items():
                ledger = Ledger()
                check_options(Block(keyword, {name: "7"}, Place("deck.inp", 3)), ledger)
                self.assertEqual([(entry.card, entry.status, entry.text) for entry in ledger.list_rows()], [(f"{keyword}.{name}", Status.IGNORED, reason)])


class Alone(Case):
    def test_laws_are_those_of_the_program(self):
        schema = subprocess.run([PERCUSS, "schema"], capture_output=True, text=True, check=True).stdout
        with open(os.path.join(ROOT, "python/percuss/importing", TRAITS), encoding="utf-8") as file:
            self.assertEqual(file.read(), write_traits(schema), "percuss schema | PYTHONPATH=python python3 -m percuss.importing.laws writes it anew")

    def test_the_package_imports_without_the_program(self):
        shutil.copytree(os.path.join(ROOT, "python/percuss"), os.path.join(self.folder, "lib/percuss"), ignore=shutil.ignore_patterns("__pycache__"))
        with open(os.path.join(self.folder, "deck.k"), "w", encoding="utf-8") as file:
            file.write(deck(cube("*MAT_PLASTIC_KINEMATIC\n1,7.8e-9,2.1e5,0.3,300.0,2000.0\n"), velocity(1.0), "*DAMPING_PART_STIFFNESS\n1,-1e-7\n"))
        environment = {"PATH": "/nowhere", "PYTHONPATH": os.path.join(self.folder, "lib")}
        done = subprocess.run([sys.executable, "-B", "-m", "percuss", "import", "deck.k", "--out", "m", "--quiet"], cwd=self.folder, env=environment, capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, "the deck is not checked" in done.stderr), (0, True), done.stderr)
        self.assertTrue(os.path.isfile(os.path.join(self.folder, "m/deck.yaml")))

    def test_what_the_importer_chooses_gives_no_warning(self):
        scaled = abaqus(abaqus_cube(), step="*FIXED MASS SCALING, DT=1e-5, TYPE=BELOW MIN\n*CLOAD\nall, 1, 0.5\n")
        cold = abaqus(abaqus_cube().replace("0.3\n", "0.3\n*PLASTIC, HARDENING=JOHNSON COOK\n300., 400., 0.5, 1., 1500., 300.\n"), step="*CLOAD\nall, 1, 0.5\n")
        plane = ("*NODE, NSET=all\n1, 0., 0.\n2, 10., 0.\n3, 10., 10.\n4, 0., 10.\n*ELEMENT, TYPE=CPS4R, ELSET=sheet\n1, 1, 2, 3, 4\n*SOLID SECTION, ELSET=sheet, MATERIAL=steel\n1.,\n"
                 "*MATERIAL, NAME=steel\n*DENSITY\n7.8e-9\n*ELASTIC\n2.1e5, 0.3\n*PLASTIC\n300., 0.\n400., 0.2\n")
        plate = ("*NODE\n1, 0., 0., 0.\n2, 10., 0., 0.\n3, 10., 10., 0.\n4, 0., 10., 0.\n9, 5., 5., 0.\n*ELEMENT, TYPE=R3D4, ELSET=plate\n1, 1, 2, 3, 4\n*RIGID BODY, REF NODE=9, ELSET=plate\n"
                 "*ELEMENT, TYPE=MASS, ELSET=m\n2, 9\n*MASS, ELSET=m\n2e-6,\n*ELEMENT, TYPE=ROTARYI, ELSET=r\n3, 9\n*ROTARY INERTIA, ELSET=r\n1e-5, 2e-5, 3e-5\n")
        rules = "mass_scaling|specific_heat|shell_points|unit_system"
        for text in (scaled, cold, abaqus(plane, step="*CLOAD\nall, 1, 0.5\n"), abaqus(plate, step="*CLOAD\n9, 3, 4.\n")):
            done = self.call(text)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertNotRegex(done.stdout + done.stderr, rf"\[({rules})\]")
        real = abaqus(abaqus_cube().replace("210000.0", "2.1e11"), step="*CLOAD\nall, 1, 0.5\n")  # Pa beside t/mm^3
        self.assertIn("[unit_system]", (done := self.call(real)).stdout + done.stderr)

    def test_a_report_names_what_the_import_has_changed(self):
        try:
            import percuss
            from percuss.report.answers import list_changes_of_import
        except ImportError as error:
            self.skipTest(str(error))
        text = deck(cube(), velocity(1.0), "*RIGIDWALL_PLANAR_ORTHO\n0\n0,0,-5,0,0,1\n0.1,0.2,0,0,0,0,0\n1,0,0\n")
        self.assertEqual(self.call(text, "--allow", "all").returncode, 0)
        subprocess.run([PERCUSS, "run", "m/deck.yaml", "--out", "r", "--quiet"], cwd=self.folder, check=True, capture_output=True)
        before = os.getcwd()
        os.chdir(self.folder)
        try:
            changes = list_changes_of_import(percuss.read("r"))
        finally:
            os.chdir(before)
        self.assertIn("*RIGIDWALL_PLANAR_ORTHO", changes[0])


if __name__ == "__main__":
    unittest.main()
