"""What tests of pages need: percuss' modules, and which programs there are to look at a page."""

import os
import shutil
import subprocess
import sys

PERCUSS, ROOT = sys.argv.pop(), sys.argv.pop()

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-headless-shell") or shutil.which("google-chrome")
HAS_VTK = subprocess.run([sys.executable, "-c", "import vtkmodules.vtkRenderingOpenGL2, PIL"], capture_output=True).returncode == 0
HAS_DISPLAY = bool(os.environ.get("DISPLAY") or shutil.which("xvfb-run"))


def read_in_chromium(page, folder):
    """(document after its scripts, lines that they wrote to the console) of a page. folder: for what Chromium keeps."""
    done = subprocess.run([CHROMIUM, "--headless=new", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
                           "--enable-logging=stderr", "--v=0", f"--user-data-dir={folder}/chromium",
                           "--virtual-time-budget=20000", "--dump-dom", f"file://{page}"], capture_output=True, text=True,
                          timeout=200)
    return done.stdout, [line for line in done.stderr.splitlines() if "CONSOLE" in line]
