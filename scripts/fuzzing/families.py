"""A scene from a seed for comparisons of bits: small bodies of every family of elements, joined in every way, that
rest, are struck, held, driven or loaded, with keys that are drawn from the schema of decks."""

import random as randoms

from .drawing import draw_keys
from .scene import MATERIALS
from .shapes import rounded

_METAL = {"density": 7850.0, "youngs_modulus": 200e9, "poissons_ratio": 0.3}
LAWS = {
    **{name: MATERIALS[name]
       for name in ("steel", "hard", "light", "copper", "iron", "alloy", "nylon", "rubber", "foam", "soil")},
    "brittle": {"model": "j2_plasticity", **_METAL, "yield_stress": 200e6, "hardening_modulus": 1e9,
                "failure": {"plastic_strain": 2e-3, "fade_steps": 5}},
    "torn": {"model": "j2_plasticity", **_METAL, "yield_stress": 100e6, "hardening_modulus": 5e8,
             "failure": {"johnson_cook": {"d1": 0.005}, "evolution": {"displacement": 1e-4}, "inverted": True}},
    "lead": {"model": "viscoelastic", "density": 8000.0, "bulk_modulus": 40e9, "long_term_shear_modulus": 5e9,
             "relaxation": [[1e-5, 10e9], [1e-4, 5e9]]},
    "cyclic": {"model": "chaboche", **_METAL, "yield_stress": 100e6, "back_stresses": [[20, 2e9], [200, 20e9]]},
    "moved": {"model": "combined_hardening", **_METAL, "yield_stress": 100e6, "hardening_modulus": 2e9,
              "kinematic_share": 0.5},
    "voids": {"model": "gurson", **_METAL, "hardening": [[0, 200e6], [1, 600e6]], "void_fraction": 0.02},
    "wood": {"model": "orthotropic", "density": 1600.0, "moduli": [140e9, 10e9, 10e9],
             "poissons_ratios": [0.3, 0.4, 0.3], "shear_moduli": [5e9, 3.5e9, 5e9]},
    "cloth": {"model": "fabric", "density": 1400.0, "warp_modulus": 30e9, "weft_modulus": 20e9, "shear_modulus": 2e8,
              "no_compression": True, "failure": {"principal_strain": 0.05}},
    "water": {"model": "fluid", "density": 1000.0, "equation_of_state": {"kind": "linear", "bulk_modulus": 2.2e9}},
}
METALS = ("steel", "hard", "light", "copper", "iron", "alloy", "brittle", "torn", "cyclic", "moved")
OF_SOLIDS = METALS + ("nylon", "rubber", "foam", "soil", "lead", "voids", "wood", "water")
CUTS = ("hexahedra", "hexahedra", "tetrahedra", "six_tetrahedra", "five_tetrahedra", "wedges", "pyramids")
WIDTH, HEIGHT, PITCH = 0.1, 0.04, 0.3  # of a body; between stacks
STEP = 2.5e-6  # about that of a body


class Body:
    """A part, and the names of what others use of it: its nodes below and above, its ends,
    its faces below and above."""

    def __init__(self, name, below, above, start, end, faces=None):
        self.name, self.below, self.above, self.start, self.end = (name, *(f"{name}/{side}"
                                                                           for side in (below, above, start, end)))
        self.faces = [f"{name}/{side}" for side in faces or (below, above)]
        self.is_shell = self.is_beam = self.is_rigid = False
        self.top = 0.0


class Scene:
    """The deck as it grows."""

    def __init__(self, random, schema, share):
        self.random, self.schema, self.share = random, schema, share
        self.deck = {"units": "m, kg, s", "time": {}, "parts": {}, "materials": {}}
        self.striker_count = 0

    def add(self, section, entry, name=None):
        if name is None:
            self.deck.setdefault(section, []).append(entry)
        else:
            self.deck.setdefault(section, {})[name] = entry

    def draw(self, path, share=None):
        return draw_keys(self.schema, path, self.random, self.share if share is None else share)

    def draw_part(self, keys):
        return {key: value for key, value in self.draw("parts.NAME").items() if key in keys}

    def add_part(self, name, part, laws):
        law = self.random.choice(laws)
        self.deck["materials"][law] = LAWS[law]
        self.deck["parts"][name] = {**part, "material": law}

    def add_solid(self, name, at, size, cells):
        """size: of its three sides."""
        random = self.random
        part = {"box": {"size": size, "cells": cells}, "at": at}
        cut = random.choice(CUTS)
        if cut != "hexahedra":
            part["elements"] = cut
        elif random.random() < 0.4:
            part["integration"] = random.choice(["full", "thick_shell"])
        laws = METALS if part.get("integration") == "thick_shell" else OF_SOLIDS
        part.update(self.draw_part(["bulk_viscosity", *(["stiffness_damping"] if cut == "hexahedra" else []),
                                    *(["hourglass"] if cut == "hexahedra" and "integration" not in part else [])]))
        self.add_part(name, part, laws)
        body = Body(name, "z_min", "z_max", "x_min", "x_max")
        if random.random() < 0.1:
            self.deck["parts"][name]["rigid"] = body.is_rigid = True
        body.top = at[2] + size[2]
        return body

    def add_plate(self, name, at, cells):
        random = self.random
        part = {"shell_plate": {"size": [WIDTH, WIDTH], "cells": cells}, "at": at}
        laws = METALS + ("wood",)
        if random.random() < 0.25:
            part["integration"] = "membrane"
            laws = METALS + ("cloth", "wood")
        if random.random() < 0.15:
            part["plies"] = [{"thickness": 5e-4, "angle": angle} for angle in (0, 90, 45)[: random.randint(1, 3)]]
        else:
            part["thickness"] = random.choice([5e-4, 1e-3, 4e-3])
        part.update(self.draw_part([*([] if "plies" in part else ["points"]),
                                    *([] if part.get("integration") == "membrane"
                                      else ["shell_hourglass", "reference"])]))
        self.add_part(name, part, laws)
        body = Body(name, "y_min", "y_max", "x_min", "x_max", ("bottom", "top"))
        body.is_shell, body.top = True, at[2] + 2e-3
        return body

    def add_beam(self, name, start, end, cells):
        random = self.random
        section = random.choice([{"round": {"radius": 0.004}}, {"truss": {"area": 3e-5}},
                                 {"rectangle": {"size": [0.006, 0.01]}},
                                 {"tube": {"outer_radius": 0.006, "inner_radius": 0.004}},
                                 {"box": {"size": [0.008, 0.012], "wall": 0.001}}])
        part = {"line": {"from": start, "to": end, "cells": cells}, "section": section}
        if "rectangle" in section or "box" in section:
            part["toward"] = [0.3, 0.5, 1]
        self.add_part(name, part, ("steel", "hard", "copper", "cyclic", "moved", "iron"))
        body = Body(name, "start", "end", "start", "end")
        body.is_beam, body.top = True, max(start[2], end[2]) + 0.01
        return body


def make_scene(seed, schema):
    """The deck of a seed, and how many steps it has at most."""
    random = randoms.Random(seed)
    scene = Scene(random, schema, random.choice([0, 0.15, 0.15, 0.3]))
    scene.deck["title"] = f"Random bits {seed}"
    for i in range(random.choice([1, 1, 2, 2, 3])):
        random.choice(_STACKS)(scene, PITCH * i, f"s{i}_")
    steps = random.randint(40, 110)
    _add_everywhere(scene, steps)
    return scene.deck, steps


def _stack_bodies(scene, x, name):
    """One body on another, or beside it, with one of the connections between them."""
    random = scene.random
    cells = [random.choice([2, 3, 4, 6]), random.choice([2, 3, 5]), random.randint(1, 2)]
    is_plate = random.random() < 0.3
    lower = (scene.add_plate(name + "low", [x, 0, 0], cells[:2]) if is_plate
             else scene.add_solid(name + "low", [x, 0, 0], [WIDTH, WIDTH, HEIGHT], cells))
    ground, link = 0 if is_plate else HEIGHT, random.choice(list(_LINKS))
    gap = {"none": random.choice([0, 5e-4, 0.01]), "join": 0}.get(link, random.choice([0, 5e-4]))
    at = [x, 0, ground + gap]
    kind = random.random()
    if link != "join" and kind < 0.5:
        cells = [random.randint(2, 4), random.randint(2, 3), random.randint(1, 2)]
    upper = (scene.add_plate(name + "high", at, cells[:2]) if kind > 0.7 and not is_plate
             else scene.add_solid(name + "high", at, [WIDTH, WIDTH, HEIGHT], cells))
    _LINKS[link](scene, lower, upper)
    _hold(scene, lower)
    _load(scene, random.choice([lower, upper]))
    _strike(scene, x, upper)


def _stack_frame(scene, x, name):
    """Beams that carry a plate or stand in a block."""
    random = scene.random
    post = scene.add_beam(name + "post", [x, 0, -0.1], [x, 0, 0], random.randint(1, 4))
    plate = scene.add_plate(name + "roof", [x, 0, 0], [random.randint(2, 4)] * 2)
    bar = scene.add_beam(name + "bar", [x, 0, 0], [x + WIDTH, 0, 0],
                         scene.deck["parts"][plate.name]["shell_plate"]["cells"][0])
    scene.add("join", {"parts": [post.name, plate.name, bar.name], "tolerance": 1e-6})
    scene.add("conditions", {"nodes": post.start, "fixed": ["x", "y", "z"]})
    if random.random() < 0.5:
        scene.add("conditions", {"nodes": plate.end, "fixed": ["x", "y", "z", "rx", "ry", "rz"]})
    _load(scene, random.choice([plate, bar]))
    _strike(scene, x, plate)


def _stack_embedded(scene, x, name):
    random = scene.random
    block = scene.add_solid(name + "block", [x, 0, 0], [WIDTH, WIDTH, HEIGHT], [3, 3, 2])
    bar = scene.add_beam(name + "bar", [x - 0.01, 0.05, 0.02], [x + 0.11, 0.05, 0.02], random.randint(3, 8))
    scene.deck["parts"][block.name].pop("rigid", None)
    scene.add("embedded", {"nodes": bar.name, "in": block.name}, name + "bars")
    _hold(scene, block)
    _load(scene, random.choice([block, bar]))
    _strike(scene, x, block)


def _stack_joints(scene, x, name):
    """Rigid bodies on joints, with a spring that turns, and a body that deforms below them."""
    random = scene.random
    arms = []
    for i in range(random.randint(2, 3)):
        arm = name + f"arm{i}"
        scene.add_part(arm, {"box": {"size": [0.05, 0.02, 0.02], "cells": [2, 1, 1]}, "at": [x + 0.05 * i, 0.04, 0.1],
                             "rigid": True},
                       ("hard", "steel"))
        arms.append(arm)
    for i, pair in enumerate(zip(arms, arms[1:])):
        place = [x + 0.05 * (i + 1), 0.05, 0.11]
        kind = random.choice([{"kind": "spherical"}, {"kind": "revolute", "axis": "y"},
                              {"kind": "revolute", "axis": "z"}])
        scene.add("joints", {**kind, "bodies": list(pair), "at": place}, name + f"joint{i}")
        if random.random() < 0.4:
            spring = random.choice([{"stiffness": 500}, {"friction": 20, "hold_stiffness": 1e4},
                                    {"stiffness": 100, "damping": 0.1}])
            scene.add("turn_springs", {"bodies": list(pair), "axes": ["y", "z"], "x": spring}, name + f"turn{i}")
    if random.random() < 0.6:
        scene.add("joints", {"kind": "spherical", "bodies": [arms[0]], "at": [x, 0.05, 0.11]}, name + "ground")
    if random.random() < 0.7:
        scene.add("initial", {"part": arms[-1], "velocity": [0, 0, -random.choice([1, 30])]})
    below = scene.add_solid(name + "below", [x, 0, 0.05], [WIDTH, WIDTH, HEIGHT], [2, 2, 1])
    _hold(scene, below)
    _load(scene, below)


_STACKS = (_stack_bodies, _stack_bodies, _stack_bodies, _stack_frame, _stack_embedded, _stack_joints)


def _join(scene, lower, upper):
    scene.add("join", {"parts": [lower.name, upper.name], "tolerance": 1e-6})


def _get_contact(scene):
    return scene.deck.setdefault("contact", {"surfaces": "all"})


def _tie(scene, lower, upper):
    random = scene.random
    tie = {"a": upper.faces[0], "b": lower.faces[1], "distance": 0.004}
    if random.random() < 0.4:
        tie["failure"] = {"normal": 1e7, "shear": 1e7}
    if random.random() < 0.3:
        tie["sticks"] = "on_contact"
    _switch(scene, tie, 0.3)
    _get_contact(scene).setdefault("ties", []).append(tie)


def _glue(scene, lower, upper):
    cohesive = {"normal_stiffness": 1e12, "normal_strength": 1e7, "shear_strength": 2e7, "normal_energy": 200,
                "shear_energy": 500}
    cohesive.update(scene.draw("contact.ties.N.cohesive"))
    _get_contact(scene).setdefault("ties", []).append({"a": upper.faces[0], "b": lower.faces[1], "distance": 0.004,
                                                       "cohesive": cohesive})


def _spring(scene, lower, upper):
    random = scene.random
    spring = {"between": [lower.end, upper.end], "stiffness": 1e6, "damping": random.choice([10, 1e3]),
              "acts": random.choice(["both", "tension", "compression"])}
    if random.random() < 0.3:
        spring["rest_length"] = random.choice([0, 0.02, 0.06])
    if random.random() < 0.3:
        spring["failure"] = {"elongation": 1e-4}
    scene.add("springs", spring, upper.name + "_spring")


def _weld(scene, lower, upper):
    weld = {"between": [lower.end, upper.end]}
    if scene.random.random() < 0.4:
        weld["failure"] = scene.random.choice([{"normal": 1e3, "shear": 1e3}, {"time": 1e-4}])
    scene.add("welds", weld, upper.name + "_weld")


def _constrain(scene, lower, upper):
    random = scene.random
    for body in (lower, upper):
        scene.deck["parts"][body.name].pop("rigid", None)
    if random.random() < 0.5:
        entry = {"equal": random.choice([["z"], ["x", "z"]]), "nodes": upper.end}
    else:
        entry = {"equation": [{"nodes": lower.end, "direction": "y", "factor": 1},
                              {"nodes": upper.end, "direction": "y", "factor": -1}]}
    scene.add("constraints", entry, upper.name + "_rows")


def _rigid_set(scene, lower, upper):
    scene.add("rigid_sets", {"nodes": scene.random.choice([upper.end, lower.start])}, upper.name + "_set")


_LINKS = {"none": lambda scene, lower, upper: None, "join": _join, "tie": _tie, "glue": _glue, "spring": _spring,
          "weld": _weld, "constraint": _constrain, "set": _rigid_set}


def _switch(scene, entry, share):
    """Lets sensors switch an entry on or off."""
    random = scene.random
    if random.random() > share:
        return
    for key in random.choice([["from"], ["until"], ["from", "until"]]):
        name = f"at{len(scene.deck.get('sensors', {}))}"
        time = STEP * (random.randint(5, 20) if key == "from" else random.randint(20, 50))
        scene.add("sensors", {"time": rounded(time)}, name)
        entry[key] = name


def _hold(scene, body):
    random = scene.random
    if random.random() < 0.5 and not body.is_rigid:
        entry = {"nodes": body.below, "fixed": random.choice([["x", "y", "z"], ["z"], ["x", "z"]])}
        _switch(scene, entry, 0.1)
        scene.add("conditions", entry)
    if random.random() < 0.15 and not body.is_rigid:
        move = random.choice([{"velocity": {"x": random.choice([0, 3])}},
                              {"displacement": {"x": {"expression": "10 * t"}}},
                              {"velocity": {"y": {"table": [[0, 0], [3e-5, 0], [6e-5, 5], [9e-5, 0]]}}}])
        entry = {"nodes": body.end, **move}
        _switch(scene, entry, 0.2)
        scene.add("conditions", entry)
    if random.random() < 0.15:
        scene.add("walls",
                  {"point": [0, 0, -2e-4], "normal": "z", "friction": random.choice([0, 0.3]), "nodes": body.name})


def _load(scene, body):
    random = scene.random
    if body.is_rigid:
        return
    if random.random() < 0.2 and not body.is_beam:
        value = random.choice([1e6, {"table": [[0, 0], [4e-5, 0], [8e-5, 1e7]]}, {"expression": "1e6 * sin(1e5 * t)"}])
        load = {"faces": body.faces[1], "value": value}
        _switch(scene, load, 0.2)
        scene.deck.setdefault("loads", {}).setdefault("pressure", []).append(load)
    if random.random() < 0.15:
        load = {"nodes": body.end, "force": {"z": random.choice([100, {"table": [[0, 0], [5e-5, 0], [6e-5, 1e3]]}])}}
        _switch(scene, load, 0.2)
        scene.deck.setdefault("loads", {}).setdefault("nodal", []).append(load)


def _strike(scene, x, body):
    """A ball or a block that arrives after some steps."""
    random = scene.random
    if random.random() < 0.3:
        return
    name, speed = body.name + "_striker", random.choice([2, 20, 100, 300])
    way = max(2e-4, speed * STEP * random.choice([2, 20, 40]))
    radius, y = 0.02, rounded(random.uniform(0.02, 0.08))
    if random.random() < 0.6:
        part = {"sphere": {"radius": radius, "cells": random.choice([3, 4])},
                "at": [rounded(x + random.uniform(0.02, 0.08), 4), y, rounded(body.top + way + radius, 6)]}
    else:
        part = {"box": {"size": [radius] * 3, "cells": [random.randint(1, 2)] * 3},
                "at": [rounded(x + 0.04, 4), y, rounded(body.top + way, 6)]}
    if random.random() < 0.3:
        part["elements"] = "tetrahedra"
    if random.random() < 0.2:
        part["rigid"] = True
    scene.add_part(name, part, ("hard", "steel", "light"))
    scene.add("initial", {"part": name, "velocity": [0, random.choice([0, 5]), -speed]})
    _get_contact(scene)


def _add_everywhere(scene, steps):
    random, deck = scene.random, scene.deck
    deck["time"] = {"end": rounded(STEP * steps * random.choice([0.5, 1, 1.5])), "max_steps": steps,
                    **scene.draw("time")}
    if random.random() < 0.1:
        deck["time"]["mass_scaling"] = {"step": random.choice([2e-6, 4e-6]), "max_added": 200,
                                        **random.choice([{}, {"every": 1}, {"every": 7}])}
    if "contact" in deck or random.random() < 0.5:
        _get_contact(scene).update(scene.draw("contact"))
    for section in ("elements", "erosion", "audit"):
        if drawn := scene.draw(section):
            deck[section] = drawn
    if random.random() < 0.15:
        deck.setdefault("loads", {})["gravity"] = [0, 0,
                                                   random.choice([-9.81, -1e5, {"expression": "-1e4 * sin(1e5 * t)"}])]
    if random.random() < 0.1:
        scene.add("damping", {"coefficient": random.choice([0, 100, {"table": [[0, 0], [5e-5, 0], [6e-5, 1e4]]}])})
    if random.random() < 0.3:
        strikers = [entry["part"] for entry in deck.get("initial", [])]
        deck["start"] = {"relaxation": {"tolerance": 0.5, "max_steps": random.choice([20, 60]), "unsettled": "warn",
                                        "ramp": random.choice([0, 10]), **scene.draw("start.relaxation")}}
        if strikers and random.random() < 0.8:
            deck["start"]["relaxation"]["hold"] = strikers
    end = deck["time"]["end"]
    deck["output"] = {"history": {"every": 0, "parts": "all"}, "checkpoint": {"every": 10 * end},
                      "fields": {"every": rounded(end / random.choice([2, 5])), "write": ["velocity", "stress"]}}
