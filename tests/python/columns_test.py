"""docs/output.md says of each column of history.csv what columns.json says: columns_test.py ROOT PERCUSS. Exit code 77 without NumPy.

Four small runs have every column that there is. A row of the page begins with the words of columns.json, without names and axes,
and its unit is the dimension there. No row is of a column that no run has.
"""

import os
import re
import subprocess
import tempfile
import unittest

from given import PERCUSS, ROOT, require

require("numpy")

import percuss  # noqa: E402

DECKS = {
    "erosion": """\
units: m, kg, s
time: {end: 1, max_steps: 2}
parts:
  a: {shell_plate: {size: [1, 1], cells: [1, 1]}, thickness: 0.1, material: tough, mass_scaling: {step: 1e-9, every: 1}}
  beam: {line: {from: [3, 0, 0], to: [4, 0, 0], cells: 1}, section: {round: {radius: 0.1}}, material: hard}
materials:
  tough: {model: elastic, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0.3, failure: {principal_strain: 0.5}}
  hard: {model: elastic, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0.3}
erosion: {free_nodes: remove}
damping: [{coefficient: 1}]
initial: [{part: a, velocity: [1, 0, 0]}]
contact: {surfaces: all, enforcement: penalty}
output: {history: {parts: all, elements: [{name: rib, part: beam, near: [3, 0, 0]}]}}
""",
    "impact": """\
units: m, kg, s
time: {end: 1, max_steps: 2}
parts:
  a: {box: {size: [1, 1, 1], cells: [1, 2, 1]}, material: metal}
  b: {box: {size: [1, 1, 1], cells: [1, 2, 1]}, at: [0, 0, 2], material: hard}
  c: {box: {size: [1, 1, 1], cells: [1, 2, 1]}, at: [0, 0, 3.1], material: hard}
  d: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, at: [0, 0, 10], material: water}
materials:
  metal: {model: johnson_cook, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0.3, a: 1e7, b: 1e7, n: 1, c: 0.01, m: 1,
          specific_heat: 400, melt_temperature: 1000, equation_of_state: {kind: mie_grueneisen, sound_speed: 1000, slope: 1.5, grueneisen: 2}}
  hard: {model: elastic, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0.3}
  water: {model: fluid, density: 1000, equation_of_state: {kind: linear, bulk_modulus: 1e6}}
  porous: {model: gurson, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0.3, hardening: [[0, 1e7]]}
initial: [{part: a, velocity: [0, 0, 1]}]
conditions: [{nodes: b/z_max, fixed: [x, y, z]}]
contact:
  surfaces: [[a, b], [b, b]]
  enforcement: lagrange
  ties:
    - {a: b/z_min, b: a/z_max, distance: 1.1, failure: {normal: 1e12}}
    - {a: c/z_min, b: b/z_max, distance: 0.2, cohesive: {normal_stiffness: 1e9, normal_strength: 1e6, shear_strength: 1e6, normal_energy: 1e6, shear_energy: 1e6}}
walls: [{name: floor, point: [0, 0, -1], normal: z, mass: 10}]
springs: {link: {between: [{near: [0, 0, 1]}, {near: [0, 0, 2]}], stiffness: 1000, damping: 1}}
welds: {spot: {between: [{near: [1, 1, 1]}, {near: [1, 1, 2]}], normal: z}}
constraints:
  level: {equal: [x, y, z], between: [{near: [0, 0, 1]}, {near: [0, 0, 2]}]}
  lever: {equation: [{nodes: {near: [0, 0, 1]}, direction: x, factor: 2}, {nodes: {near: [0, 0, 2]}, direction: y, factor: 1}]}
output:
  history:
    nodes: [{name: tip, near: [0, 0, 0]}, {name: tap, near: [1, 0, 0]}, {name: top, near: [0, 0, 1]}]
    elements: [{name: core, near: [0, 0, 0]}]
    accelerometers: [{name: chest, nodes: [tip, tap, top]}]
    forces: [{name: hit, contact: [a, b]}, {name: foot, support: b/z_max}]
""",
    "rigid": """\
units: m, kg, s
time: {end: 1, max_steps: 2}
parts:
  a: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, material: hard, rigid: true}
  b: {box: {size: [1, 1, 1], cells: [1, 1, 1]}, at: [0, 0, 2], material: hard, rigid: true}
materials: {hard: {model: elastic, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0.3}}
joints: {hinge: {kind: revolute, bodies: [a, b], at: [0, 0, 1.5], axis: x}}
turn_springs: {twist: {bodies: [a, b], x: {stiffness: 1}, y: {damping: 1}, z: {friction: 1, hold_stiffness: 1}}}
initial: [{part: a, velocity: [0, 0, 1]}, {part: b, velocity: [0, 0, 1]}]
sensors: {soon: {value: kinetic, rises_above: 1e9}}
output: {history: {motion: all}}
""",
    "blocks": """\
units: m, kg, s
time: {end: 1, max_steps: 2}
parts: {bar: {mesh: {file: bar.k}, material: hard}}
materials: {hard: {model: elastic, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0.3, failure: {principal_strain: 0.5}}}
elements: {resist_folding: true}
output: {history: {parts: all, blocks: [bar/first, second]}}
""",
}
MESH = """\
*KEYWORD
*NODE
1,0,0,0
2,1,0,0
3,1,1,0
4,0,1,0
5,0,0,1
6,1,0,1
7,1,1,1
8,0,1,1
9,0,0,2
10,1,0,2
11,1,1,2
12,0,1,2
*PART
first
1,
*PART
second
2,
*ELEMENT_SOLID
1,1,1,2,3,4,5,6,7,8
2,2,5,6,7,8,9,10,11,12
*END
"""
DIMENSIONS = {"temperature": ("temperature",), "moment": ("moment", "energy")}  # a moment has the dimension of an energy


def read_page():
    """{column with NAME: (meaning, unit)} of the tables."""
    with open(os.path.join(ROOT, "docs/output.md"), encoding="utf-8") as file:
        text = file.read()
    rows = {}
    for line in text[text.index("\n## history.csv") : text.index("\n## checkpoint.h5")].splitlines():
        if line.startswith("| `"):
            names, meaning, unit = (cell.strip() for cell in line.strip("|").split("|"))
            names = re.findall(r"`([^`]+)`", names)
            first = names[0]
            stem = re.sub(r"_[a-z]+(:NAME)?$", "", first)
            rows.update({stem + name + (re.search("(:NAME)?$", first)[0]) if name.startswith("_") else name: (meaning, unit) for name in names})
    return rows


def generalise(name):
    """'kinetic:NAME' of 'kinetic:a', 'NAME_vx' of 'tip_vx'."""
    name = re.sub(r"^(contact|friction):.*", r"\1:A:B", name)
    name = re.sub(r"^(?!contact:|friction:)(\w+):.+", r"\1:NAME", name)
    return re.sub(r"^(tip|tap|top|core|rib)_", "NAME_", name)


def shorten(words):
    """'force' of "force in x of 'hit'": without its owner and its axis."""
    words = re.sub(r" of (part |block |pair |wall |spring |turn spring |weld |constraint |sensor |joint |accelerometer |rigid body )?'[^']*'", "", words)
    return re.sub(r" (in [xyz]|about [xyz]|along [xyz]|q[0-3]|xx|yy|zz|xy|yz|zx)$", "", words)


class Columns(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.histories = []
        with open(os.path.join(folder.name, "bar.k"), "w", encoding="utf-8") as file:
            file.write(MESH)
        for name, deck in DECKS.items():
            path, out = os.path.join(folder.name, name + ".yaml"), os.path.join(folder.name, name)
            with open(path, "w", encoding="utf-8") as file:
                file.write(deck)
            done = subprocess.run([PERCUSS, "run", path, "--out", out, "--quiet"], capture_output=True, text=True, timeout=120,
                                  env=dict(os.environ, OMP_NUM_THREADS="1", OMP_PROC_BIND="false"))
            if done.returncode != 0:
                raise RuntimeError(f"{name}: exit code {done.returncode}: {done.stderr}")
            cls.histories.append(percuss.read(out).history)
        cls.page = read_page()

    def test_every_column_has_a_row_with_its_words_and_its_dimension(self):
        for history in self.histories:
            for name in history:
                self.assertIn(generalise(name), self.page, name)
                meaning, unit = self.page[generalise(name)]
                self.assertTrue(meaning.startswith(shorten(history.label(name))), f"{name}: '{history.label(name)}' is not '{meaning}'")
                self.assertIn(history.dimension(name), DIMENSIONS.get(unit, (unit,)), name)

    def test_every_row_is_of_a_column(self):
        written = {generalise(name) for history in self.histories for name in history}
        of_libraries = {"NAME_state_1", "NAME_state_2"}  # build_law_test has them
        self.assertEqual(sorted(set(self.page) - written - of_libraries), [])

    def test_every_column_has_words_that_no_other_has(self):
        for history in self.histories:
            words = [history.label(name) for name in history]
            self.assertEqual(sorted({word for word in words if words.count(word) > 1}), [])


if __name__ == "__main__":
    unittest.main()
