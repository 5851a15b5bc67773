"""What tests of pages need: percuss' modules, and which programs there are to look at a page."""

import base64
import os
import shutil
import subprocess
import sys
import zlib

from browsers import CHROMIUM
from given import PERCUSS  # noqa: F401  (for those who import it from here)

HAS_VTK = subprocess.run([sys.executable, "-c", "import vtkmodules.vtkRenderingOpenGL2, PIL"], capture_output=True).returncode == 0
HAS_DISPLAY = bool(os.environ.get("DISPLAY") or shutil.which("xvfb-run"))


def read_in_chromium(page, folder):
    """(document after its scripts, lines that they wrote to the console) of a page. folder: for what Chromium keeps."""
    done = subprocess.run([CHROMIUM, "--headless=new", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
                           "--enable-logging=stderr", "--v=0", f"--user-data-dir={folder}/chromium",
                           "--virtual-time-budget=20000", "--dump-dom", f"file://{page}"], capture_output=True, text=True,
                          timeout=200)
    return done.stdout, [line for line in done.stderr.splitlines() if "CONSOLE" in line]


def read_surface(about, text):
    """The arrays of a packed view, after the steps of unpack.js: corners, owners, parts, element_ids, node_ids, cells, cell_owners, places
    [frames][nodes][3], fields (a list of [frames][items]), visible and alive (where something fails), arrows."""
    import numpy as np

    data, at = zlib.decompress(base64.b64decode(text)), 0

    def take(kind, *shape):
        nonlocal at
        size = int(np.prod(shape)) * np.dtype(kind).itemsize
        at += size
        return np.frombuffer(data[at - size : at], kind).reshape(shape)

    def take_rows(kind, *shape):
        return np.cumsum(take(kind, *shape), axis=0, dtype=kind)

    faces, nodes, elements, volumes, frames = (about[name] for name in ("faces", "nodes", "elements", "volumes", "frames"))
    found = {"corners": take_rows(np.uint32, faces, 4), "owners": take_rows(np.uint32, faces), "parts": take(np.uint16, elements),
             "element_ids": take_rows(np.uint32, elements), "node_ids": take_rows(np.uint32, nodes), "cells": take_rows(np.uint32, volumes, 8),
             "cell_owners": take_rows(np.uint32, volumes)}
    bytes_ = take(np.uint8, frames, 2, 3 * nodes).astype(np.uint16)
    whole = np.cumsum(bytes_[:, 0] + 256 * bytes_[:, 1], axis=0, dtype=np.uint16)
    found["places"] = np.array(about["low"]) + np.array(about["scale"]) * whole.reshape(frames, nodes, 3)
    found["fields"] = [take_rows(np.uint8, frames, elements if field["place"] == "element" else nodes) for field in about["fields"]]
    if about["erodes"]:
        found["visible"], found["alive"] = take_rows(np.uint8, frames, faces), take_rows(np.uint8, frames, volumes)
    found["arrows"] = [(take(np.uint32, one["count"]), take(np.int16, frames, one["count"], 3)) for one in about["arrows"]]
    assert at == len(data), (at, len(data))
    return found
