"""How the executable and Python start the tools of the package: tools_test.py ROOT PERCUSS."""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest

from percuss import tools

from given import PERCUSS, ROOT
TRAP = "raise SystemExit('this file is not of percuss')\n"


class Tools(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def call(self, *command, **environment):
        """An environment of nothing but the names that are given."""
        return subprocess.run(command, cwd=self.folder, capture_output=True, text=True, timeout=120, env=environment)

    def install(self):
        """The executable as it lies in an installation."""
        os.makedirs(os.path.join(self.folder, "usr/bin"))
        os.makedirs(os.path.join(self.folder, "usr/share/percuss"))
        os.symlink(os.path.join(ROOT, "python"), os.path.join(self.folder, "usr/share/percuss/python"))
        return shutil.copy(PERCUSS, os.path.join(self.folder, "usr/bin/percuss"))

    def write(self, name, text, mode=0o644):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        os.chmod(path, mode)
        return path

    def test_starts_with_an_empty_environment_in_checkout_and_installation(self):
        for program in (PERCUSS, self.install()):
            for words in (["plot", "--help"], ["help", "plot"]):
                done = self.call(program, *words)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.assertIn("Usage: percuss plot", done.stdout)
            self.assertIn("Usage: percuss check --report", self.call(program, "check", "--report", "--help").stdout)
            self.assertIn("Usage: percuss info", self.call(program, "info", "--forces", "--help").stdout)

    def test_says_what_it_misses_beside_an_executable_alone(self):
        alone = shutil.copy(PERCUSS, os.path.join(self.folder, "percuss"))
        done = self.call(alone, "plot", "--help")
        self.assertEqual(done.returncode, 2)
        self.assertIn("there is no Python package percuss, of which percuss plot is a tool", done.stderr)

    def test_takes_no_file_of_the_current_folder(self):
        for name in ("argparse.py", "percuss.py", "signal.py", "numpy.py"):
            self.write(name, TRAP)
        if sys.version_info < (3, 11):
            self.skipTest("Python 3.10 looks in the current folder")
        self.assertIn("Usage: percuss plot", self.call(PERCUSS, "plot", "--help", PERCUSS_PYTHON=sys.executable).stdout)

    def test_takes_the_interpreter_that_has_the_libraries(self):
        poor = "#!/bin/sh\ncase \"$*\" in *--lacks*) exit 255;; esac\necho poor\n"
        self.write("python3", poor, 0o755)
        done = self.call(PERCUSS, "stop", "--help", PATH=f"{self.folder}:/usr/bin:/bin")
        self.assertIn("Usage: percuss stop" if os.access("/usr/bin/python3", os.X_OK) else "poor", done.stdout)
        self.write("python3", poor.replace("255", "0"), 0o755)
        self.assertEqual(self.call(PERCUSS, "stop", "--help", PATH=f"{self.folder}:/usr/bin:/bin").stdout, "poor\n")

    def test_takes_the_interpreter_that_the_user_names(self):
        named = self.write("mine", "#!/bin/sh\necho mine \"$@\"\n", 0o755)
        self.assertEqual(self.call(PERCUSS, "view", "a b", PERCUSS_PYTHON=named).stdout, "mine -m percuss view a b\n")
        done = self.call(PERCUSS, "view", "ball", PERCUSS_PYTHON="nowhere")
        self.assertEqual(done.returncode, 4)
        self.assertIn("nowhere cannot be started (No such file or directory): install Python 3, or name it in PERCUSS_PYTHON", done.stderr)

    def test_holds_no_signal_back(self):
        """Ctrl-C ends a tool, as it does what the tool starts."""
        named = self.write("mine", "#!/bin/sh\ngrep SigBlk /proc/self/status\n", 0o755)
        self.assertEqual(int(self.call(PERCUSS, "watch", "ball", PERCUSS_PYTHON=named, PATH="/usr/bin:/bin").stdout.split()[1], 16), 0)

    def test_tells_its_tools_and_refuses_others(self):
        done = subprocess.run([sys.executable, "-m", "percuss", "nothing"], capture_output=True, text=True, timeout=60)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        for name in tools.TOOLS:
            self.assertIn(name, done.stderr)

    def test_every_tool_has_help_without_a_library_within_80_columns(self):
        for name in tools.TOOLS:
            done = subprocess.run([sys.executable, "-S", "-m", "percuss", name, "--help"], capture_output=True, text=True, timeout=60,
                                  env=dict(os.environ, COLUMNS="200"))
            self.assertEqual((done.returncode, done.stderr), (0, ""), name)
            self.assertLessEqual(max(map(len, done.stdout.splitlines())), 80, name)

    def test_counts_the_libraries_that_an_interpreter_lacks(self):
        count = [subprocess.run([sys.executable, "-S", "-m", "percuss", "--lacks", name], timeout=60).returncode for name in ("stop", "tables", "report")]
        self.assertEqual(count, [0, 32, 51])  # without site-packages: two, and three with three that are only wished for


if __name__ == "__main__":
    unittest.main()
