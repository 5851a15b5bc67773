"""Runs a scene and says what fails: kinds of failures, each with its numbers."""

import copy
import os
import shutil
import subprocess
import tempfile

from .measures import measure
from .scene import find_wave_speed, write_deck

MOMENTUM = 1e-10  # relative: round-off
GAIN = 1e-4  # of the initial energy
DEPTH = 0.01  # of an element; of nodes, up to SLOW of the wave speed and without penalty springs
# the same beyond, of penalty springs, and of edges: those of smooth surfaces are not checked with each other
DEEP = 0.1
SLOW = 0.05
FRAMES = 12
STEPS_BEYOND = 10  # times as many steps as planned end a run
MOST_SECONDS = 120


class Program:
    """The program and how to start it on several ranks."""

    def __init__(self, percuss, mpirun, settings=()):
        """settings: 'key=value' that every run gets by --set."""
        self.percuss, self.mpirun = percuss, mpirun
        self.settings = [word for setting in settings for word in ("--set", setting)]

    def run(self, deck, out, *options, ranks=1, threads=1):
        words = [*(self.mpirun + [str(ranks)] if ranks > 1 else []), self.percuss, "run", deck, "--out", out, "--quiet",
                 *self.settings, *options]
        environment = dict(os.environ, OMP_NUM_THREADS=str(threads), OMP_PROC_BIND="false", OMP_WAIT_POLICY="passive",
                           OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                           OMPI_MCA_mpi_yield_when_idle="1", OPENBLAS_NUM_THREADS="1")
        try:
            done = subprocess.run(words, capture_output=True, text=True, env=environment, timeout=MOST_SECONDS)
        except subprocess.TimeoutExpired:
            return None, f"no end within {MOST_SECONDS} s"
        return done.returncode, done.stderr.strip()

    def call(self, *words):
        """What a command of the program prints."""
        return subprocess.run([self.percuss, *words], capture_output=True, text=True, check=True,
                              timeout=MOST_SECONDS).stdout


def judge(program, deck, with_bits=True):
    """({kind: what and how much}, figures).
    Kinds: run, end, momentum, gain, depth, inverted, ranks, threads, restart."""
    folder = tempfile.mkdtemp(prefix="percuss_fuzz_")
    try:
        return _judge_in(program, deck, folder, with_bits)
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def add_output(deck):
    """The deck with the output and the end that a judgement needs."""
    deck = copy.deepcopy(deck)
    end = deck["time"]["end"]
    deck["time"]["max_steps"] = max(1000, STEPS_BEYOND * count_steps(deck))
    deck["output"] = {"fields": {"every": end / FRAMES, "write": ["body"]}, "history": {"every": end / 100},
                      "checkpoint": {"every": 0.5 * end}}
    return deck


def count_steps(deck):
    """As many as the mesh needs at the start, about."""
    from .shapes import find_shortest_edge

    return int(deck["time"]["end"]
               / min(0.5 * find_shortest_edge(part) / find_wave_speed(deck["materials"][part["material"]])
                     for part in deck["parts"].values())) + 1


def _judge_in(program, deck, folder, with_bits):
    path, out = os.path.join(folder, "deck.yaml"), os.path.join(folder, "out")
    with open(path, "w", encoding="utf-8") as file:
        file.write(write_deck(add_output(deck)))
    code, text = program.run(path, out)
    if code in (None, 2, 4) or not os.path.exists(os.path.join(out, "summary.json")):
        return {"run": f"exit code {code}: {text[-600:]}"}, {}
    figures = measure(out, deck)
    failures = {}
    if code != 0:
        failures["run"] = (f"exit code {code} at {figures['time'] / deck['time']['end']:.2f} of the time: "
                           f"{_find_error(text)}")
    elif figures["time"] < deck["time"]["end"] * (1 - 1e-9):
        failures["end"] = f"{figures['time'] / deck['time']['end']:.2f} of the time after {figures['steps']} steps"
    _judge_figures(deck, figures, failures)
    if with_bits and code == 0:
        _judge_bits(program, path, out, figures["state_hash"], failures)
    return failures, figures


def _judge_figures(deck, figures, failures):
    deepest = find_deepest_allowed(deck)
    if not figures["momentum"] <= MOMENTUM:
        failures["momentum"] = f"error {figures['momentum']:.2g}"
    if not figures["contact_gain"] <= GAIN:
        failures["gain"] = f"contact gave {figures['contact_gain']:.2g} of the initial energy"
    if figures["node_depth"] > deepest or figures["edge_depth"] > DEEP:
        failures["depth"] = f"node {figures['node_depth']:.3f}, edge {figures['edge_depth']:.3f} of an element"
    if figures["inverted"]:
        failures["inverted"] = f"{figures['inverted']} corners"


def find_deepest_allowed(deck):
    """Of nodes, in elements."""
    slowest = min(find_wave_speed(material) for material in deck["materials"].values())
    speeds = sorted(sum(v**2 for v in entry["velocity"]) ** 0.5 for entry in deck["initial"])
    is_fast = sum(speeds[-2:]) > SLOW * slowest
    return DEEP if is_fast or deck["contact"].get("enforcement") == "penalty" else DEPTH


def _judge_bits(program, path, out, wanted, failures):
    places = {"ranks": dict(ranks=2), "threads": dict(threads=2)}
    for kind, place in places.items():
        _compare(program, kind, wanted, failures, path, f"{out}_{kind}", **place)
    middle = os.path.join(out, "checkpoint_previous.h5")
    if os.path.exists(middle):
        _compare(program, "restart", wanted, failures, path, f"{out}_restart", "--restart", middle)


def _compare(program, kind, wanted, failures, path, out, *options, **place):
    import percuss

    code, text = program.run(path, out, *options, **place)
    found = percuss.read(out).summary.get("state_hash") if code == 0 else f"exit code {code}: {text[-300:]}"
    if found != wanted:
        failures[kind] = f"state_hash {wanted} is {found}"


def _find_error(text):
    lines = [line for line in text.splitlines() if "error:" in line]
    return (lines or text.splitlines() or ["no message"])[0][:300]
