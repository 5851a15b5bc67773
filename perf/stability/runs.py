"""Starts the program and the tool on decks, one thread each, and reads what they leave."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import time

import numpy as np

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "python"))
from percuss.results.table import read_rows  # noqa: E402

ENVIRONMENT = {**os.environ, "OMP_NUM_THREADS": "1", "OMP_PROC_BIND": "false"}


class Result:
    """Outcome of one run: exit code (None: stopped at the time limit), what it said, summary, history by column, seconds."""


def run_deck(percuss, deck, work, limit):
    """Runs the text of a deck in a folder of its own under `work`, which is deleted again."""
    folder = pathlib.Path(work) / "run"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    (folder / "deck.yaml").write_text(deck)
    result = Result()
    begin = time.monotonic()
    try:
        done = subprocess.run([percuss, "run", str(folder / "deck.yaml"), "--out", str(folder / "out"), "--quiet"],
                              capture_output=True, text=True, timeout=limit, env=ENVIRONMENT)
        result.code, result.error = done.returncode, done.stderr.strip()
    except subprocess.TimeoutExpired:
        result.code, result.error = None, f"not done in {limit} s"
    result.seconds = time.monotonic() - begin
    summary, history = folder / "out" / "summary.json", folder / "out" / "history.csv"
    result.summary = json.loads(summary.read_text()) if summary.exists() else {}
    if result.summary.get("status") == "running":  # it was killed
        result.summary = {}
    result.history = read_history(history) if history.exists() else {}
    shutil.rmtree(folder)
    return result


def read_history(path):
    names, rows = read_rows(path)
    table = np.array(rows).reshape(len(rows), len(names))
    return {name: table[:, i] for i, name in enumerate(names)}


def search_scale(tool, deck, work, low, high, tolerance, noise):
    """The trials of stability_tool search."""
    path = pathlib.Path(work) / "search.yaml"
    path.write_text(deck)
    done = subprocess.run([*tool, "search", str(path), repr(low), repr(high), repr(tolerance), repr(noise)],
                          capture_output=True, text=True, env=ENVIRONMENT, check=False)
    if done.returncode != 0:
        raise RuntimeError(f"{done.stderr.strip()} (exit code {done.returncode})\n{deck}")
    return [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]
