"""The manual page and the completion of shells: manual_test.py ROOT PERCUSS."""

import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

from percuss.tools import start_tool

PERCUSS, ROOT = sys.argv.pop(), sys.argv.pop()
TOOLS = ("import", "plot", "report", "watch", "stop", "render", "view", "export", "sweep", "build-law")
COMMANDS = ("run", "check", "plan", "info", "schema", *TOOLS)


def ask(*words):
    return subprocess.run(words, capture_output=True, text=True, check=True, timeout=60).stdout


def help_of(command):
    return ask(*(start_tool(command) if command in TOOLS else [PERCUSS, command]), "--help")


def list_options(text):
    """--words at the head of a line of the list of options."""
    heads = [re.split(r"\s{2,}", line.strip())[0] for line in text.splitlines() if re.match(r"  -", line)]
    return sorted({word for head in heads for word in re.findall(r"--[a-z][a-z-]*", head)})


class Manual(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = folder.name
        subprocess.run([sys.executable, os.path.join(ROOT, "scripts/make_manual"), PERCUSS, cls.folder], check=True,
                       timeout=300)
        with open(os.path.join(cls.folder, "percuss.1"), encoding="utf-8") as file:
            cls.source = file.read()

    def section(self, command):
        """Of the manual page, as text."""
        text = self.source.split(f".SS percuss {command}\n", 1)[1].split("\n.SS ")[0]
        return re.sub(r"\\f[BIR]", "", text.replace("\\-", "-"))

    def test_has_every_option_of_every_command(self):
        for command in COMMANDS:
            options = list_options(help_of(command))
            self.assertIn("--help", options)
            for option in options:
                self.assertRegex(self.section(command), rf"(?m)^(-\w, )?{option}(,| |$)", f"{command} {option}")

    def test_comes_with_the_schema_of_decks(self):
        with open(os.path.join(self.folder, "percuss.schema.json"), encoding="utf-8") as file:
            schema = json.load(file)
        self.assertEqual(schema, json.loads(ask(PERCUSS, "schema")))
        self.assertIn("history", schema["properties"]["output"]["properties"])

    def test_explains_options_in_words(self):
        self.assertIn("Folder for the results (default: out/SCENE)", self.section("run"))
        self.assertIn("Filter all columns by a channel frequency class", self.section("plot"))
        self.assertIn("OMP_NUM_THREADS", self.source)
        self.assertIn(".SH EXIT STATUS", self.source)

    def test_is_read_without_a_warning(self):
        if not shutil.which("groff"):
            self.skipTest("no groff")
        done = subprocess.run(["groff", "-man", "-Tutf8", "-ww", os.path.join(self.folder, "percuss.1")],
                              capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("--restart", re.sub(r"\x1b\[\d*m|.\x08", "", done.stdout))

    def complete(self, *words):
        """What bash offers for the last word."""
        script = os.path.join(self.folder, "percuss.bash")
        code = 'source "$0"; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _percuss; printf "%s\\n" "${COMPREPLY[@]}"'
        done = subprocess.run(["bash", "-c", code, script, "percuss", *words], capture_output=True, text=True,
                              cwd=self.folder)
        self.assertEqual(done.stderr, "")
        return done.stdout.split("\n")[:-1] if done.stdout.strip() else []

    def test_completion_of_bash_is_valid(self):
        subprocess.run(["bash", "-n", os.path.join(self.folder, "percuss.bash")], check=True)

    def test_completion_of_zsh_is_valid(self):
        if not shutil.which("zsh"):
            self.skipTest("no zsh")
        subprocess.run(["zsh", "-n", os.path.join(self.folder, "_percuss")], check=True)

    def test_completes_commands(self):
        self.assertEqual(self.complete("re"), ["report", "render"])
        self.assertLessEqual(set(COMMANDS) | {"help", "version", "--version"}, set(self.complete("")))
        self.assertEqual(self.complete("help", "pl"), ["plan", "plot"])

    def test_completes_options_and_what_they_take(self):
        self.assertEqual(self.complete("run", "--re"), ["--restart"])
        self.assertEqual(self.complete("run", "deck.yaml", "--for"), ["--force"])
        self.assertEqual(self.complete("render", "--edges", ""), ["auto", "on", "off"])
        self.assertEqual(self.complete("plan", "--latency", ""), [])
        for command in COMMANDS:
            self.assertEqual(sorted(self.complete(command, "--")), list_options(help_of(command)), command)

    def test_completes_decks_and_folders(self):
        for name in ("ball.yaml", "wall.yml", "notes.txt", "two words.yaml"):
            open(os.path.join(self.folder, name), "w", encoding="utf-8").close()
        os.makedirs(os.path.join(self.folder, "out/ball"), exist_ok=True)
        self.assertEqual(self.complete("run", ""), ["ball.yaml", "out", "two words.yaml", "wall.yml"])
        self.assertEqual(self.complete("check", "b"), ["ball.yaml"])
        self.assertEqual(self.complete("report", "ou"), ["out"])
        self.assertEqual(self.complete("run", "ball.yaml", "--out", ""), ["out"])
        self.assertIn("notes.txt", self.complete("info", ""))


if __name__ == "__main__":
    unittest.main()
