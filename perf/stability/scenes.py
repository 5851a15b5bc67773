"""Decks of the studies: small scenes of every kind, in units in which steel is steel."""

STEEL = "{model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}"
SOFT_STEEL = ("{model: j2_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: 400e6, "
              "hardening_modulus: 1e9}")
COPPER = ("{model: j2_plasticity, density: 8930, youngs_modulus: 117e9, poissons_ratio: 0.35, yield_stress: 400e6, "
          "hardening_modulus: 100e6}")
RUBBER = "{model: elastic, density: 1100, youngs_modulus: 10e6, poissons_ratio: 0.499}"
STEEL_SPEED = (200e9 * 0.7 / (1.3 * 0.4) / 7850) ** 0.5  # dilatational waves

# Element choices: name -> keys of the deck's section `elements`. The first is the default.
KINDS = {
    "assumed strain": "hourglass: {kind: assumed_strain}",
    "stiffness": "hourglass: {kind: stiffness}",
    "viscous": "hourglass: {kind: viscous}",
    "full": "integration: full",
}

MESH_STEP = "step of the mesh"  # the default element, by the steps that the mesh allows
OFF = "off"
LAGRANGE, PENALTY = "enforcement: lagrange", "enforcement: penalty"
CONTACTS = ["", LAGRANGE, PENALTY, OFF]  # keys that choose the enforcement; the empty one is the default


def write_elements(kind, linear=0.06, quadratic=1.2):
    return f"elements: {{{KINDS[kind]}, bulk_viscosity: {{linear: {linear!r}, quadratic: {quadratic!r}}}}}\n"


# --- scenes of the blow-up searches: name -> (deck without elements, noise, what it shows)

BAR = """
time: {end: 1.0e-3}
parts: {bar: {box: {size: [0.2, 0.02, 0.02], cells: [20, 2, 2]}, material: steel}}
materials: {steel: STEEL}
initial: [{velocity: [1, 0, 0]}]
conditions: [{nodes: bar/x_min, fixed: [x, y, z]}]
"""
BALL = """
time: {end: 4.0e-4}
parts: {ball: {sphere: {radius: 0.05, cells: 6}, material: steel}}
materials: {steel: STEEL}
initial: [{velocity: [1, 0, 0], angular_velocity: [0, 50, 0]}]
"""
PLATE = """
time: {end: 8.0e-4}
parts: {plate: {box: {size: [0.2, 0.2, 0.004], cells: [8, 8, 2]}, material: steel}}
materials: {steel: STEEL}
initial: [{velocity: [0, 0, 1]}]
conditions: [{nodes: plate/x_min, fixed: [x, y, z]}]
"""
SOFT_BLOCK = """
time: {end: 1.0e-2}
parts: {block: {box: {size: [0.1, 0.1, 0.1], cells: [5, 5, 5]}, material: rubber}}
materials: {rubber: RUBBER}
initial: [{velocity: [0.1, 0, 0]}]
conditions: [{nodes: block/x_min, fixed: [x, y, z]}]
"""
SPIN = """
time: {end: 0.02}
parts: {block: {box: {size: [0.4, 0.2, 0.1], cells: [8, 4, 2]}, material: steel}}
materials: {steel: STEEL}
initial: [{angular_velocity: [1, 628.32, 1]}]
"""
TAYLOR_BAR = """
time: {end: 60.0e-6}
parts: {bar: {cylinder: {radius: 3.2e-3, length: 32.4e-3, cells: [4, 20]}, material: copper}}
materials: {copper: COPPER}
initial: [{velocity: [0, 0, -227]}]
conditions: [{nodes: bar/start, fixed: [z]}]
"""
PRESSED = """
time: {end: 1.0e-3}
parts:
  lower: {box: {size: [0.1, 0.1, 0.1], cells: [4, 4, 4]}, material: steel}
  upper: {box: {size: [0.1, 0.1, 0.1], cells: [3, 3, 3]}, at: [0.01, 0.005, 0.1], material: steel}
materials: {steel: STEEL}
conditions: [{nodes: lower/z_min, fixed: [x, y, z]}]
loads: {pressure: [{faces: upper/z_max, value: 50e6}]}
contact: {friction: 0.3}
"""
EQUAL_PRESSED = PRESSED.replace("[3, 3, 3]", "[4, 4, 4]").replace("[0.01, 0.005, 0.1]", "[0, 0, 0.1]")
LIGHT_ON_HEAVY = PRESSED.replace("at: [0.01, 0.005, 0.1], material: steel",
                                 "at: [0.01, 0.005, 0.1], material: foam").replace(
                                     "{steel: STEEL}", "{steel: STEEL, foam: {model: elastic, density: 50, "
                                                       "youngs_modulus: 1.2e9, poissons_ratio: 0.2}}").replace(
                                                       "50e6", "1e6")
BARS = """
time: {end: 3.0e-4}
parts:
  left:  {box: {size: [0.2, 0.02, 0.02], cells: [20, 2, 2]}, material: steel}
  right: {box: {size: [0.2, 0.02, 0.02], cells: [20, 2, 2]}, at: [0.2001, 0, 0], material: steel}
materials: {steel: STEEL}
initial: [{part: left, velocity: [10, 0, 0]}]
contact: {surfaces: [[left/x_max, right/x_min]]}
"""
PILE = """
time: {end: 4.0e-3}
parts: {bricks: {box: {size: [0.2, 0.1, 0.06], cells: [4, 2, 2]}, array: {count: [1, 2, 3], pitch: [0.2, 0.1, 0.06], stagger: 0.25}, material: brick}}
materials: {brick: {model: elastic, density: 2000, youngs_modulus: 15e9, poissons_ratio: 0.2}}
loads: {gravity: [0, 0, -9.81]}
walls: [{normal: z, friction: 0.6}]
contact: {friction: 0.6}
"""
BALL_ON_PLATE = """
time: {end: 3.0e-4}
parts:
  ball:  {sphere: {radius: 0.02, cells: 6}, at: [0, 0, 0.0241], material: steel}
  plate: {box: {size: [0.12, 0.12, 0.004], cells: [12, 12, 2]}, at: [-0.06, -0.06, 0], material: steel}
materials: {steel: SOFT_STEEL}
initial: [{part: ball, velocity: [0, 0, -60]}]
conditions: [{nodes: plate/x_min, fixed: [x, y, z]}, {nodes: plate/x_max, fixed: [x, y, z]}]
contact: {friction: 0.2}
"""

# name: (deck, velocity of the noise)
FREE_SCENES = {
    "bar, elastic waves": (BAR, 0.01),
    "ball, distorted mesh": (BALL, 0.01),
    "plate, aspect 12": (PLATE, 0.01),
    "block, Poisson 0.499": (SOFT_BLOCK, 0.001),
    "spinning block": (SPIN, 0.01),
    "Taylor bar": (TAYLOR_BAR, 0),
}
CONTACT_SCENES = {
    "blocks pressed, equal mesh": (EQUAL_PRESSED, 0.001),
    "blocks pressed, other mesh": (PRESSED, 0.001),
    "light block on a heavy one": (LIGHT_ON_HEAVY, 0.001),
    "bars collide": (BARS, 0.001),
    "pile of bricks at rest": (PILE, 0.0001),
    "ball strikes a plate": (BALL_ON_PLATE, 0.01),
}


def fill(deck, **values):
    """The deck with its materials, and with $NAME replaced."""
    for name, text in (("SOFT_STEEL", SOFT_STEEL), ("STEEL", STEEL), ("COPPER", COPPER), ("RUBBER", RUBBER)):
        deck = deck.replace(f": {name}", f": {text}")
    for name, value in values.items():
        deck = deck.replace(f"${name}", value if isinstance(value, str) else repr(value))
    return deck


# --- a million steps

LONG_BAR = """
time: {end: 1.0e3, max_steps: $steps}
parts: {bar: {box: {size: [0.08, 0.01, 0.01], cells: [8, 1, 1]}, material: steel}}
materials: {steel: STEEL}
initial: [{velocity: [1, 0, 0.5]}]
conditions: [{nodes: bar/x_min, fixed: [x, y, z]}]
output: {history: {every: $every}}
"""
LONG_SPIN = """
time: {end: 1.0e3, max_steps: $steps}
parts: {block: {box: {size: [0.4, 0.2, 0.1], cells: [4, 2, 1]}, material: steel}}
materials: {steel: STEEL}
initial: [{angular_velocity: [1, 628.32, 1]}]
output: {history: {every: $every}}
"""
LONG_PILE = """
time: {end: 1.0e3, max_steps: $steps}
parts: {bricks: {box: {size: [0.2, 0.1, 0.06], cells: [2, 1, 1]}, array: {count: [1, 1, 3], pitch: [0.2, 0.1, 0.06]}, material: brick}}
materials: {brick: {model: elastic, density: 2000, youngs_modulus: 15e9, poissons_ratio: 0.2}}
loads: {gravity: [0, 0, -9.81]}
walls: [{normal: z, friction: 0.6}]
contact: {friction: 0.6}
output: {history: {every: $every, nodes: [{name: top, near: [0, 0, 0.18]}]}}
"""

# --- impact speeds

IMPACT_PARTS = {
    "wall, face": ("block: {box: {size: [0.1, 0.1, 0.1], cells: [4, 4, 4]}, at: [0, 0, 0.001], material: m}",
                   "walls: [{normal: z}]\ncontact: {}\n"),
    "wall, corner": ("block: {box: {size: [0.1, 0.1, 0.1], cells: [4, 4, 4]}, at: [-0.05, -0.05, -0.05], rotate: "
                     "[{axis: z, angle: 45, center: [0.05, 0.05, 0.05]}, {axis: x, angle: 54.7356, center: [0.05, "
                     "0.05, 0.05]}], material: m}", "walls: [{normal: z, point: [0, 0, -0.0876]}]\ncontact: {}\n"),
    "block, face": ("block: {box: {size: [0.1, 0.1, 0.1], cells: [4, 4, 4]}, at: [0.012, 0.007, 0.001], material: "
                    "m}\n  other: {box: {size: [0.1, 0.1, 0.1], cells: [4, 4, 4]}, at: [0, 0, -0.1], material: m}",
                    "contact: {}\n"),
    "block, corner": ("block: {box: {size: [0.1, 0.1, 0.1], cells: [4, 4, 4]}, at: [-0.05, -0.05, -0.05], "
                      "rotate: [{axis: z, angle: 45, center: [0.05, 0.05, 0.05]}, {axis: x, angle: 54.7356, "
                      "center: [0.05, 0.05, 0.05]}], material: m}\n  other: {box: {size: [0.1, 0.1, 0.1], cells: [4, "
                      "4, 4]}, at: [-0.045, -0.052, -0.1876], material: m}",
                      "contact: {}\n"),
}
IMPACT_SPEEDS = (0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0)


def write_impact(target, material, speed):
    """A block of 0.1 m arrives at `speed` wave speeds;
    the run lasts until waves and the block have crossed it twice."""
    parts, contact = IMPACT_PARTS[target]
    end = 0.2 / STEEL_SPEED + 0.2 / (STEEL_SPEED * max(speed, 0.1))
    return fill(f"time: {{end: {end!r}}}\nparts:\n  {parts}\nmaterials: {{m: {material}}}\n"
                f"initial: [{{part: block, velocity: [0, 0, {-speed * STEEL_SPEED!r}]}}]\n{contact}"
                f"output: {{history: {{every: {end / 40!r}}}}}\n")
