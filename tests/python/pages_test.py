"""Commands in the pages: pages_test.py ROOT PERCUSS. Every option of `percuss NAME ...` in a line of a page is one that NAME has."""

import os
import re
import subprocess
import unittest
from functools import lru_cache
from pathlib import Path

import given
from given import PERCUSS

ROOT = Path(given.ROOT)
COMMANDS = ("build-law", "check", "export", "import", "info", "plan", "plot", "render", "report", "run", "schema", "stop", "sweep", "view", "watch")
CALL = re.compile(rf"\bpercuss ({'|'.join(COMMANDS)})\b([^`#|;]*)")
OPTION = re.compile(r"(?<!\S)(--[a-z][a-z-]*|-[a-z])(?=[\s=]|$)")


@lru_cache(None)
def list_options(name):
    done = subprocess.run([PERCUSS, name, "--help"], capture_output=True, text=True, timeout=60, env=dict(os.environ, COLUMNS="200"))
    assert done.returncode == 0, done.stderr
    return set(re.findall(r"(?<![\w-])--?[a-z][a-z-]*", done.stdout))


def list_calls(text):
    """(command, its options) of each call in a page; a line that ends in a backslash goes on."""
    for match in CALL.finditer(text.replace("\\\n", " ").replace("\n", " \n")):
        for option in OPTION.findall(match[2].split("\n")[0]):
            yield match[1], option


class Pages(unittest.TestCase):
    def test_name_options_that_there_are(self):
        pages = [ROOT / "README.md", *ROOT.glob("docs/**/*.md"), *ROOT.glob("inputs/*/README.md")]
        faults, count = [], 0
        for page in pages:
            for name, option in list_calls(page.read_text(encoding="utf-8")):
                count += 1
                if option not in list_options(name):
                    faults.append(f"{page.relative_to(ROOT)}: percuss {name} {option}")
        self.assertEqual(faults, [])
        self.assertGreater(count, 100)

    def test_units_of_info_without_a_table_are_refused(self):
        done = subprocess.run([PERCUSS, "info", str(ROOT), "--units", "mm, kg, ms"], capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 2)
        self.assertIn("--units: has no effect without --energies or --forces", done.stderr)

    def test_finds_an_option_that_is_not_there(self):
        calls = list(list_calls("    percuss plot rubber --x a \\\n      --y plate_z   # --z\n"))
        self.assertEqual(calls, [("plot", "--x"), ("plot", "--y")])
        self.assertNotIn("--y", list_options("plot"))


if __name__ == "__main__":
    unittest.main()
