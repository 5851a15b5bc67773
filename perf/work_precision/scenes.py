"""The scenes: what is run, over which meshes and choices, and what the error is."""
import pathlib
import re
from typing import Callable, NamedTuple

import numpy as np

import runs
from cases.balls import NU, RADIUS as BALL_RADIUS, YOUNG, drop_on_wall, find_hertz
from cases.plastic import LENGTH, RADIUS, measure_taylor, run_taylor
from cases.waves import SPEED, VIBRATING, sum_series

INPUTS = pathlib.Path(__file__).resolve().parents[2] / "inputs"

DEFAULT = "default"
ELEMENTS = {DEFAULT: "", "stiffness": "hourglass: stiffness", "viscous": "hourglass: viscous",
            "full": "integration: full"}
STEPS = {"step_scale 0.5": 0.5}
SINGLE = "single precision"
GLOBAL = "global step"


class Point(NamedTuple):
    scene: str
    choice: str
    mesh: str
    elements: int
    steps: int
    seconds: float
    error: float


class Scene(NamedTuple):
    title: str
    measure: Callable
    error: str  # what it is the error of


class Place:
    """Where a scene is run: what the meshes of the verification ask for, and times."""

    def __init__(self, options, name):
        self.options, self.name, self.quick = options, name, options.quick
        self.folder = options.out / "work" / name

    def run(self, template, ranks=1, percuss=None, **values):
        """The fastest of some runs."""
        options = self.options
        best = None
        for _ in range(options.repeats):
            program, options.percuss = options.percuss, percuss or options.percuss
            run = runs.start(options, self.folder / "run", runs.fill(template, **values), ranks)
            options.percuss = program
            if run.code != 0:
                raise RuntimeError(f"{self.name}: exit code {run.code}: {run.errors[-600:]}")
            if best is None or run.summary["loop_s"] < best.summary["loop_s"]:
                best = run
        return best

    def file(self, name):
        folder = self.folder / "files"
        folder.mkdir(parents=True, exist_ok=True)
        return folder / name

    def clean(self):
        import shutil
        shutil.rmtree(self.folder, ignore_errors=True)

    def point(self, choice, mesh, run, error):
        summary = run.summary
        print(f"          {self.name}, {choice}, {mesh}: {summary['loop_s']:.2f} s, error {error:.2e}", flush=True)
        return Point(self.name, choice, str(mesh), summary["elements"], summary["steps"], summary["loop_s"],
                     float(error))


class WithSingle:
    """A place where runs are those of the program in single precision."""

    def __init__(self, place):
        self._place = place

    def __getattr__(self, name):
        return getattr(self._place, name)

    def run(self, template, ranks=1, **values):
        return self._place.run(template, ranks, percuss=self._place.options.single, **values)


class WithGlobalStep:
    """A place where decks take their steps from the whole mesh."""

    def __init__(self, place):
        self._place = place

    def __getattr__(self, name):
        return getattr(self._place, name)

    def run(self, template, ranks=1, **values):
        if "time: {" not in template:
            raise RuntimeError(f"{self.name}: the deck has no 'time: {{'")
        return self._place.run(template.replace("time: {", "time: {step_estimate: global, ", 1), ranks, **values)


def list_variants(place, choices):
    """(name, what the choice says, place to run it at)."""
    variants = [(name, says, place) for name, says in choices.items()]
    variants.append((GLOBAL, choices[DEFAULT], WithGlobalStep(place)))
    if place.options.single:
        variants.append((SINGLE, choices[DEFAULT], WithSingle(place)))
    return variants


def measure_bar_wave(place):
    """The end of a bar that is stopped at its other end, against the series, over one period."""
    period = 4 / SPEED
    points = []
    kinds = ({name: (says, 0.9) for name, says in ELEMENTS.items()}
             | {name: ("", scale) for name, scale in STEPS.items()})
    for name, (says, scale), where in list_variants(place, kinds):
        for cells in (25, 50) if place.quick else (25, 50, 100, 200, 400):
            deck = VIBRATING.replace("elements: {", f"elements: {{{says}, " if says else "elements: {")
            run = where.run(deck, end=period, scale=scale, step=1.0, width=1 / cells, cells=cells, every=period / 400,
                            initial="  - {part: bar, velocity: [1, 0, 0]}")
            error = run.history["end_x"] - 1 - sum_series(1.0, run.history["time"])
            points.append(where.point(name, cells, run,
                                      np.sqrt(np.trapz(error**2, run.history["time"]) / period) * SPEED))
    return points


def measure_taylor_bar(place):
    """Length and foot radius of the copper bar, the larger of both relative errors."""
    points = []
    for name, says, where in list_variants(place, ELEMENTS):
        for n in (1, 2) if place.quick else (2, 3, 4, 6):
            run = run_taylor(where, n, says)
            m = measure_taylor(run)
            points.append(where.point(name, f"n = {n}", run,
                                      max(abs(m["length"] / LENGTH - 1), abs(m["axis"] / RADIUS - 1))))
    return points


def measure_hertz_drop(place):
    """Largest force and time of contact of a ball on a rigid wall, the larger of both relative errors."""
    speed, points = 1.0, []
    for name, says, where in list_variants(place, ELEMENTS):
        for across, share in ((12, 0.7), (16, 0.75)) if place.quick else ((12, 0.7), (18, 0.76), (24, 0.8), (32, 0.84)):
            run = drop_on_wall(where, across, share, says)
            h = run.history
            mass = -4 * h.first("momentum_z") / speed
            _, force, duration = find_hertz(YOUNG / (1 - NU**2), BALL_RADIUS, mass, speed)
            touching = h["time"][h["contacts"] > 0]
            error = max(abs(4 * h["wall_force_z"].max() / force - 1), abs((touching[-1] - touching[0]) / duration - 1))
            points.append(where.point(name, f"{across} across", run, error))
    return points


def read_deck(scene, end, replacements):
    """A deck of inputs/ with another end, another mesh and only the history as output."""
    text = (INPUTS / scene / "deck.yaml").read_text()
    text = "\n".join(line for line in text.splitlines() if "fields:" not in line) + "\n"
    text = re.sub(r"end: [0-9.e+-]+", f"end: {end}", text)
    for old, new in replacements.items():
        if old not in text:
            raise RuntimeError(f"{scene}: the deck has no '{old}'")
        text = text.replace(old, new)
    return text


def measure_against_finest(place, scene, end, meshes_of, finest, choices, quantities):
    """Largest difference of some quantities of the run to the finest run's, relative to the finest's."""

    def run_mesh(where, cells, text):
        elements, contact = choices[text]
        replacements = dict(cells)
        replacements["contact: {surfaces: all"] = "contact: {" + contact + "surfaces: all"
        deck = read_deck(scene, end, replacements) + (f"elements: {{{elements}}}\n" if elements else "")
        return where.run(deck.replace("$", "$$"))

    reference = quantities(run_mesh(place, finest, DEFAULT))
    points = []
    for name, _, where in list_variants(place, {name: name for name in choices}):
        for label, cells in meshes_of.items():
            run = run_mesh(where, cells, name if name in choices else DEFAULT)
            error = max(abs(a - b) / abs(b) for a, b in zip(quantities(run), reference))
            points.append(where.point(name, label, run, error))
    return points


CONTACT_CHOICES = {
    DEFAULT: ("", ""),
    "stiffness": ("hourglass: stiffness", ""),
    "viscous": ("hourglass: viscous", ""),
    "full": ("integration: full", ""),
    "lagrange": ("", "enforcement: lagrange, "),
    "penalty": ("", "enforcement: penalty, "),
    "no edges": ("", "edges: false, "),
}


def measure_brick_wall(place):
    """Energies that the rod's impact has left as motion, spent in friction and brought into the rod after 0.5 ms."""

    def cells(rod, brick):
        return {"cells: [5, 40]": f"cells: {rod}", "cells: [3, 6, 3]": f"cells: {brick}"}

    wanted = {"2 x 4 x 2": cells([4, 26], [2, 4, 2]), "3 x 6 x 3": cells([5, 40], [3, 6, 3])}
    finest = cells([8, 66], [5, 10, 5])
    if place.quick:
        wanted, finest = {"1 x 2 x 1": cells([3, 13], [1, 2, 1])}, wanted["2 x 4 x 2"]

    def quantities(run):
        energy = run.summary["energy"]
        return energy["kinetic"], energy["friction"], energy["internal"]

    return measure_against_finest(place, "brick_wall", "5.0e-4", wanted, finest, CONTACT_CHOICES, quantities)


def measure_can_crush(place):
    """Energies that the plate has lost, and that the container has taken, after 1 ms."""

    def cells(tube, plate):
        return {"cells: [3, 28, 76]": f"cells: {tube}", "cells: [16, 16, 3]": f"cells: {plate}"}

    wanted = {"2 x 19 x 50": cells([2, 19, 50], [11, 11, 2]), "3 x 28 x 76": cells([3, 28, 76], [16, 16, 3]),
              "4 x 38 x 100": cells([4, 38, 100], [22, 22, 4])}
    finest = cells([5, 56, 152], [24, 24, 5])
    if place.quick:
        wanted, finest = {"1 x 14 x 38": cells([1, 14, 38], [8, 8, 2])}, wanted["2 x 19 x 50"]

    def quantities(run):
        energy = run.summary["energy"]
        return run.history.first("kinetic") - energy["kinetic"], energy["internal"]

    return measure_against_finest(place, "can_crush", "1.0e-3", wanted, finest, CONTACT_CHOICES, quantities)


SCENES = {
    "bar_wave": Scene("A wave in a bar", measure_bar_wave,
                      "the end's displacement over one period (L2, over V L / c), against the series"),
    "taylor_bar": Scene("Taylor bar", measure_taylor_bar,
                        "length or foot radius, whichever is larger, against the references"),
    "hertz_drop": Scene("Hertz drop", measure_hertz_drop,
                        "largest force or time of contact, whichever is larger, against Hertz"),
    "brick_wall": Scene("Brick wall, first 0.5 ms", measure_brick_wall,
                        "kinetic energy, friction or internal energy, whichever is largest, "
                        "against the scene's own run with 250 elements a brick"),
    "can_crush": Scene("Can crush, first 1 ms", measure_can_crush,
                       "energy that the plate lost or the parts took, whichever is larger, "
                       "against the scene's own run with 42 560 elements in the container"),
}
