"""A scene from a seed: bodies that strike each other, as a deck that is a tree of dictionaries."""

import math
import random as randoms

import numpy as np

from .shapes import (SHELLS, SOLIDS, count_elements, find_hull, find_shortest_edge, make_body, rounded)

FASTEST = 2000.0  # m/s
WAVE_SHARE = 0.35  # of the slowest wave speed: beyond it the laws of the materials lose their meaning
MOST_WORK = 5e5  # elements x steps of a run
MOST_STEPS = 600

_METAL = {"youngs_modulus": 200e9, "poissons_ratio": 0.3, "density": 7850.0}
MATERIALS = {
    "steel": {"model": "j2_plasticity", **_METAL, "yield_stress": 400e6, "hardening_modulus": 1e9},
    "hard": {"model": "elastic", **_METAL},
    "light": {"model": "elastic", "density": 2700.0, "youngs_modulus": 70e9, "poissons_ratio": 0.33},
    "copper": {"model": "j2_plasticity", "density": 8930.0, "youngs_modulus": 117e9, "poissons_ratio": 0.35,
               "yield_stress": 100e6, "hardening_modulus": 300e6},
    "iron": {"model": "johnson_cook", "density": 7890.0, "youngs_modulus": 207e9, "poissons_ratio": 0.29, "a": 175e6,
             "b": 380e6, "n": 0.32, "c": 0.06, "m": 0.55, "specific_heat": 452.0, "melt_temperature": 1811.0},
    "alloy": {"model": "voce_plasticity", "density": 2700.0, "youngs_modulus": 70e9, "poissons_ratio": 0.33,
              "yield_stress": 150e6, "saturation_stress": 100e6, "saturation_rate": 20.0, "hardening_modulus": 200e6},
    "nylon": {"model": "elastic", "density": 1150.0, "youngs_modulus": 3e9, "poissons_ratio": 0.4},
    "rubber": {"model": "neo_hookean", "density": 1100.0, "youngs_modulus": 20e6, "poissons_ratio": 0.45},
    "rubber_mr": {"model": "mooney_rivlin", "density": 1100.0, "c10": 1e6, "c01": 0.3e6, "bulk_modulus": 50e6},
    "foam": {"model": "low_density_foam", "density": 80.0, "youngs_modulus": 5e6,
             "compression": [[0, 0], [0.05, 0.2e6], [0.6, 0.3e6], [0.8, 2e6]]},
    "soil": {"model": "soil_and_foam", "density": 1800.0, "shear_modulus": 50e6, "unloading_bulk_modulus": 500e6,
             "a0": 1e8, "a1": 5e3, "a2": 0.1, "compaction": [[0, 0], [0.05, 5e6], [0.2, 60e6]]},
}
SHELL_MATERIALS = ("steel", "hard", "light", "copper", "iron", "alloy", "nylon")


def find_wave_speed(material):
    """Of dilatational waves, at the start."""
    if material["model"] == "mooney_rivlin":
        shear = 2 * (material["c10"] + material["c01"])
        modulus = material["bulk_modulus"] + 4 / 3 * shear
    elif material["model"] == "soil_and_foam":
        modulus = material["unloading_bulk_modulus"] + 4 / 3 * material["shear_modulus"]
    else:
        nu, young = material.get("poissons_ratio", 0.0), material["youngs_modulus"]
        modulus = young * (1 - nu) / ((1 + nu) * (1 - 2 * nu))
    return math.sqrt(modulus / material["density"])


def make_scene(seed):
    """The deck of a seed."""
    random = randoms.Random(seed)
    size = random.choice([0.01, 0.1, 1.0])
    parts = _make_parts(random, size)
    used = {part["material"]: MATERIALS[part["material"]] for part in parts.values()}
    slowest = min(find_wave_speed(material) for material in used.values())
    fastest = min(FASTEST, WAVE_SHARE * slowest)
    speed = rounded(math.exp(random.uniform(math.log(min(5, 0.1 * fastest)), math.log(fastest))))
    end = _find_end(random, parts, used, size, speed)
    initial = _place(random, parts, speed, gap=0.05 * speed * end)
    deck = {"title": f"Random scene {seed}", "units": "m, kg, s", "time": {"end": end}, "parts": parts,
            "materials": used, "initial": initial, "contact": _make_contact(random)}
    if random.random() < 0.1:
        deck["elements"] = {"hourglass": "stiffness"}
    if random.random() < 0.2:
        deck["walls"] = [_make_wall(random, parts, 0.05 * speed * end)]
    return deck


def _make_parts(random, size):
    draw = random.random()
    if draw < 0.06:
        return _make_wall_of_bricks(random, size)
    count = (random.choice([2, 2, 2, 3]) if draw < 0.75 else random.randint(4, 8) if draw < 0.94
             else random.randint(9, 30))
    fineness = (3, 7) if count < 4 else (2, 4) if count < 9 else (1.5, 2.5)
    parts = {}
    for i in range(count):
        kind = random.choice(SOLIDS + SHELLS if random.random() < 0.5 else SOLIDS)
        edge = size / random.uniform(*fineness)
        part = make_body(random, kind, size, edge)
        part["material"] = random.choice(SHELL_MATERIALS if kind in SHELLS else tuple(MATERIALS))
        parts[f"{kind}_{i}"] = part
    return parts


def _make_wall_of_bricks(random, size):
    """Up to 500 bodies in a staggered wall, and one that strikes it."""
    count = [random.randint(1, 3), random.randint(2, 12), random.randint(2, 12)]
    brick = [rounded(size * share) for share in (0.4, 0.3, 0.2)]
    cells = random.choice([1, 2]) if count[0] * count[1] * count[2] < 60 else 1
    material = random.choice(("steel", "light", "nylon", "copper"))
    wall = {"box": {"size": brick, "cells": [cells] * 3}, "array": {"count": count, "pitch": brick, "stagger": 0.5},
            "material": material}
    rod = make_body(random, random.choice(SOLIDS), size, size / 3)
    rod["material"] = random.choice(("steel", "hard", "copper"))
    return {"wall": wall, "rod": rod}


def _find_end(random, parts, materials, size, speed):
    """A share of the time in which a body passes its own size, within the number of steps."""
    step = min(0.8 * find_shortest_edge(part) / find_wave_speed(materials[part["material"]]) for part in parts.values())
    elements = sum(count_elements(part) for part in parts.values())
    most = min(MOST_STEPS, max(60, MOST_WORK / elements))
    return rounded(min(random.uniform(0.3, 1.0) * size / speed, most * step))


class Hull:
    """How far a body reaches along many directions, at its own origin and moved."""

    def __init__(self, points, radius):
        along = _DIRECTIONS @ points.T
        self.points, self.radius, self.middle = points, radius, points.mean(axis=0)
        self.most, self.least = along.max(axis=1) + radius, along.min(axis=1) - radius

    def moved(self, at):
        hull = object.__new__(Hull)
        shift = _DIRECTIONS @ at
        hull.points, hull.radius, hull.middle = self.points + at, self.radius, self.middle + at
        hull.most, hull.least = self.most + shift, self.least + shift
        return hull

    def gap_to(self, other):
        """The widest of the gaps along the directions, negative where none parts the two."""
        return (other.least - self.most).max()


def _place(random, parts, speed, gap):
    """Puts each part beside one that has its place, without overlap.
    Returns the initial velocities, towards each other."""
    hulls, initial = [], []
    for name, part in parts.items():
        hull = Hull(*find_hull(part))
        at, toward = -hull.middle, np.zeros(3)
        if hulls:
            at, toward = _find_place(random, hulls, hull, gap)
        hulls.append(hull.moved(at))
        part["at"] = [rounded(float(value), 6) for value in at]
        velocity = (speed * toward
                    + 0.1 * speed * np.array([random.gauss(0, 1) for _ in range(3)]) * (random.random() < 0.5))
        entry = {"part": name, "velocity": [rounded(float(value)) for value in velocity]}
        if random.random() < 0.2:
            extent = float(np.ptp(hull.points, axis=0).max() + 2 * hull.radius)
            entry["angular_velocity"] = [rounded(random.uniform(-0.3, 0.3) * speed / extent) for _ in range(3)]
        initial.append(entry)
    return initial


def _find_place(random, hulls, hull, gap):
    """Where the body is `gap` away from the first one in its way, and the direction in which that lies."""
    while True:
        direction = np.array([random.gauss(0, 1) for _ in range(3)])
        direction /= np.linalg.norm(direction)
        if random.random() < 0.3:  # square on
            axis = np.argmax(abs(direction))
            direction = np.eye(3)[axis] * np.sign(direction[axis])
        target = hulls[random.randrange(len(hulls))]
        side = np.array([random.gauss(0, 0.1) for _ in range(3)]) * np.ptp(target.points, axis=0)
        start = hull.moved(target.middle - hull.middle + side)
        far = (float((target.points @ direction).max() - (start.points @ direction).min()) + target.radius
               + hull.radius + 2 * gap)
        if not _is_free(hulls, start.moved(far * direction), gap):
            continue
        near = 0.0
        for _ in range(25):
            middle = 0.5 * (near + far)
            near, far = (near, middle) if _is_free(hulls, start.moved(middle * direction), gap) else (middle, far)
        return start.middle - hull.middle + far * direction, -direction


def _is_free(hulls, hull, gap):
    return all(other.gap_to(hull) > gap for other in hulls)


def _make_directions(count=400):
    """Fibonacci's points on a sphere, and the axes."""
    k = np.arange(count) + 0.5
    polar, turn = np.arccos(1 - 2 * k / count), math.pi * (1 + 5**0.5) * k
    points = np.column_stack([np.sin(polar) * np.cos(turn), np.sin(polar) * np.sin(turn), np.cos(polar)])
    return np.vstack([points, np.eye(3), -np.eye(3)])


_DIRECTIONS = _make_directions()


def _make_contact(random):
    contact = {"surfaces": "all"}
    if random.random() < 0.5:
        contact["friction"] = rounded(random.uniform(0.1, 0.6))
    enforcement = random.choice(["kinematic"] * 3 + ["penalty", "lagrange"])
    if enforcement != "kinematic":
        contact["enforcement"] = enforcement
    return contact


def _make_wall(random, parts, gap):
    normal = random.choice([[1, 0, 0], [0, 1, 0], [0, 0, 1]])
    lowest = min(((points + part["at"]) @ np.array(normal)).min() - radius
                 for part in parts.values() for points, radius in [find_hull(part)])
    return {"point": [rounded(n * (lowest - gap), 6) for n in normal], "normal": normal,
            "friction": rounded(random.uniform(0, 0.5))}


def write_deck(deck):
    """The deck as YAML: a line for each part, material and entry."""
    lines = []
    for key, value in deck.items():
        if key in ("parts", "materials"):
            lines += [f"{key}:"] + [f"  {name}: {_flow(entry)}" for name, entry in value.items()]
        elif isinstance(value, list):
            lines += [f"{key}:"] + [f"  - {_flow(entry)}" for entry in value]
        else:
            lines.append(f"{key}: {_flow(value)}")
    return "\n".join(lines) + "\n"


def _flow(value):
    if isinstance(value, dict):
        return "{" + ", ".join(f"{key}: {_flow(entry)}" for key, entry in value.items()) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_flow(entry) for entry in value) + "]"
    return str(value).lower() if isinstance(value, bool) else str(value)
