"""Columns of history.csv: dimension and meaning, after docs/output.md, or after columns.json where a run has written it."""

import json
import os
import re

SCENE = {
    "time": ("time", "time of the row"),
    "step": ("-", "number of the step"),
    "dt": ("time", "time step"),
    "dt_element": ("-", "element that limits the next step"),
    "kinetic": ("energy", "kinetic energy"),
    "internal": ("energy", "internal energy"),
    "hourglass": ("energy", "hourglass energy"),
    "viscous": ("energy", "bulk viscosity"),
    "damping": ("energy", "damping in proportion to mass"),
    "folding": ("energy", "resistance to folding"),
    "contact": ("energy", "work of normal contact"),
    "friction": ("energy", "work of friction"),
    "external": ("energy", "external work"),
    "energy_error": ("-", "energy error"),
    "contacts": ("-", "interactions in force"),
    "candidates": ("-", "candidate pairs"),
    "iterations": ("-", "contact iterations"),
    "residual": ("-", "penetration left / face edge"),
    "complementarity": ("-", "deviation from the conditions of contact"),
    "contact_stored": ("energy", "energy in contact springs"),
    "eroded_elements": ("-", "eroded elements"),
    "eroded_mass": ("mass", "eroded mass"),
    "eroded_energy": ("energy", "energy of eroded elements"),
    "vanished_mass": ("mass", "mass of removed nodes"),
    "added_mass": ("mass", "mass that scaling has added"),
    "added_energy": ("energy", "kinetic energy of added mass"),
    "mass": ("mass", "mass"),
}
SCENE.update({f"momentum_{axis}": ("momentum", f"momentum {axis}") for axis in "xyz"})
SCENE.update({f"angular_{axis}": ("angular momentum", f"angular momentum {axis}") for axis in "xyz"})
SCENE.update({f"wall_force_{axis}": ("force", f"force of the walls {axis}") for axis in "xyz"})
SCENE.update({"wall_displacement": ("length", "displacement of the wall along its normal"),
              "wall_speed": ("velocity", "speed of the wall along its normal")})
SCENE.update({f"f{axis}": ("force", f"force {axis}") for axis in "xyz"})
SCENE.update({f"m{axis}": ("moment", f"moment {axis}") for axis in "xyz"})
SCENE.update({f"body_{axis}": ("length", f"mass centre {axis}") for axis in "xyz"})
SCENE.update({f"body_v{axis}": ("velocity", f"velocity {axis} of the mass centre") for axis in "xyz"})
SCENE.update({f"body_q{k}": ("-", f"orientation, unit quaternion {k}") for k in range(4)})
SCENE.update({f"body_w{axis}": ("frequency", f"angular velocity {axis}") for axis in "xyz"})
SCENE.update({"body_kinetic": ("energy", "kinetic energy of the body")})
SCENE.update({f"joint_f{axis}": ("force", f"joint force {axis}") for axis in "xyz"})
SCENE.update({f"joint_m{axis}": ("moment", f"joint moment {axis}") for axis in "xyz"})
SCENE.update({"spring_work": ("energy", "energy of springs"), "damper_work": ("energy", "energy that dampers took")})
SCENE.update({"dt_spring": ("-", "spring that limits the next step")})
SCENE.update({"weld_work": ("energy", "work of welds"), "welds_failed": ("-", "welds that have failed")})
SCENE.update({"weld_normal": ("force", "normal force of the weld"), "weld_shear": ("force", "shear force of the weld")})
SCENE.update({"spring_force": ("force", "force of the spring"), "spring_elongation": ("length", "elongation")})
SCENE.update({"normal": ("force", "normal force"), "tangential": ("force", "friction force"),
              "area": ("area", "area of contact"), "pressure": ("pressure", "largest contact pressure of a node")})

# Of followed nodes and elements: what stands behind NAME.
FOLLOWED = [
    (r"_([xyz])", "length", "position {0} of {name}"),
    (r"_v([xyz])", "velocity", "velocity {0} of {name}"),
    (r"_stress_(xx|yy|zz|xy|yz|zx)", "pressure", "stress {0} of {name}"),
    (r"_pressure", "pressure", "pressure of {name}"),
    (r"_von_mises", "pressure", "von Mises stress of {name}"),
    (r"_eps", "-", "equivalent plastic strain of {name}"),
    (r"_temperature", "temperature", "temperature of {name}"),
    (r"_energy", "pressure", "internal energy per volume of {name}"),
]


def describe(name):
    """(dimension, meaning) of a column by its name; dimension None: not known."""
    if name in SCENE:
        return SCENE[name]
    base, colon, owner = name.partition(":")
    if colon and base in SCENE:
        dimension, meaning = SCENE[base]
        return dimension, f"{meaning}, {owner}"
    for pattern, dimension, meaning in FOLLOWED[::-1]:
        match = re.fullmatch("(.+)" + pattern, name)
        if match:
            return dimension, meaning.format(*match.groups()[1:], name=match[1])
    return None, name.replace("_", " ")


def read_sidecar(folder):
    """{column: {name, unit, dimension, meaning}} of columns.json; empty where a run has written none."""
    return {entry["name"]: entry for entry in _read_file(folder).get("columns", []) if "name" in entry}


def read_units(folder):
    """The units of the deck as columns.json has them; empty if it has none."""
    return _read_file(folder).get("units") or ""


def _read_file(folder):
    try:
        with open(os.path.join(folder, "columns.json"), encoding="utf-8") as file:
            found = json.load(file)
    except (OSError, ValueError):
        return {}
    return found if isinstance(found, dict) else {"columns": found}
