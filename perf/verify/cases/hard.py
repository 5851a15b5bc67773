"""Hard scenes: each completes, or ends with a named error and its exit code; on one rank and on four alike."""
import numpy as np

import meshes
from bench import case

SOLIDS = """
materials:
  metal: {model: j2_plasticity, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, yield_stress: 400e6, hardening_modulus: 1e9}
  elastic: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}
  soft: {model: elastic, density: 1000, youngs_modulus: 1e7, poissons_ratio: 0.3}
"""


def survive(bench, template, code=0, words=(), energy=0.01, which="", **values):
    """Runs a scene on one and on four ranks: the same end, the same bits. Returns the run on one."""
    prefix = which + ": " if which else ""
    text = template if "materials:" in template else template + SOLIDS
    one, four = bench.try_run(text, 1, **values), bench.try_run(text, 4, **values)
    bench.equal(prefix + "exit code", one.code, code)
    bench.equal(prefix + "exit code on 4 ranks", four.code, code)
    if one.code != code:
        bench.note(f"{prefix}`{one.errors[-400:]}`")
    if code == 0 and one.code == 0:
        bench.equal(prefix + "state_hash on 4 ranks and on 1", four.summary.get("state_hash", "none"),
                    one.summary["state_hash"])
        bench.equal(prefix + "history.csv on 4 ranks, every byte", "same" if one.history_bytes == four.history_bytes
                    else "other", "same")
        if energy:
            bench.below(prefix + "energy balance, largest error", one.history.largest("energy_error"), energy)
    elif one.code:
        bench.equal(prefix + "message on 4 ranks",
                    "same" if last_line(one) == last_line(four) else last_line(four), "same")
        for word in words:
            bench.equal(prefix + f"message names '{word}'", word in one.errors, True)
        bench.note(f"{prefix}`{last_line(one)}`")
    return one


def last_line(run):
    """The message of a failed run without the folder of this case."""
    lines = [line for line in run.errors.splitlines() if "error" in line]
    return (lines[0] if lines else "none").split(str(run.folder.parent) + "/")[-1].replace("|", "/")


@case("box_of_spheres", "hard", "Crushing of a box of spheres")
def box_of_spheres(bench):
    """125 elastic-plastic balls of 32 elements in a rigid box, its lid driven down by 40 % of its height at 50 m/s (1 % of
    the speed of sound); friction 0.2. Enforcement may leave 1 % of an edge. The balls of the middle column must stay
    one above the other under the lid, none through its neighbour: their middles at least half a radius apart."""
    run = survive(bench, """
title: Crushed box of spheres
time: {end: 8e-4}
parts:
  balls: {sphere: {radius: 0.01, cells: 4}, array: {count: [5, 5, 5], pitch: [0.02, 0.02, 0.02]}, at: [0.01, 0.01, 0.01], material: metal}
  lid: {box: {size: [0.1, 0.1, 0.01], cells: [5, 5, 1]}, at: [0, 0, 0.1], material: elastic}
walls:
  - {normal: z, friction: 0.2}
  - {normal: x, friction: 0.2, nodes: balls}
  - {normal: -x, point: [0.1, 0, 0], friction: 0.2, nodes: balls}
  - {normal: y, friction: 0.2, nodes: balls}
  - {normal: -y, point: [0, 0.1, 0], friction: 0.2, nodes: balls}
conditions:
  - {nodes: lid, fixed: [x, y]}
  - {nodes: lid, velocity: {z: -50}}
contact: {surfaces: all, friction: 0.2}
output: {history: {every: 1e-6, nodes: [$nodes]}}
""", nodes=", ".join(f"{{name: ball{i}, near: [0.05, 0.05, {0.01 + 0.02 * i:.2f}], part: balls}}" for i in range(5)) + ", {name: lid, near: [0.04, 0.04, 0.1]}")
    if run.code == 0:
        h = run.history
        heights = [h.last(f"ball{i}_z") for i in range(5)]
        touching = h["contacts"] > 0
        bench.above("interactions, largest", h.largest("contacts"), 1000)
        bench.above("way of the lid", h.first("lid_z") - h.last("lid_z"), 0.0399, "m")
        bench.below("penetration that enforcement left, over an edge", h.largest("residual"), 1e-2)
        bench.above("middle of the lowest ball over the floor", heights[0], 0.0, "m")
        bench.above("smallest distance of neighbours in the middle column", min(np.diff(heights)), 0.005, "m")
        bench.above("way of the lid over the middle of the highest ball", h.last("lid_z") - heights[-1], 0.0, "m")
        bench.above("work of the lid", h.last("external"), 0.0, "J")
        bench.below("work of friction", h.last("friction"), 0.0, "J")


@case("crossed_cubes", "hard", "Two rotated cubes pressed edge to edge")
def crossed_cubes(bench):
    """Two cubes meet with crossed edges, one rotated by 45 degrees about x, the other about y, at 2 m/s: only their edges
    touch. They must rebound. If the edges had passed, the cubes would still approach."""
    run = survive(bench, """
title: Two cubes edge to edge
time: {end: 4e-4}
parts:
  low: {box: {size: [0.1, 0.1, 0.1], cells: [4, 4, 4]}, rotate: [{axis: x, angle: 45, center: [0.05, 0.05, 0.05]}], at: [0, 0, -0.0708], material: elastic}
  high: {box: {size: [0.1, 0.1, 0.1], cells: [4, 4, 4]}, rotate: [{axis: y, angle: 45, center: [0.05, 0.05, 0.05]}], at: [0.003, 0.005, 0.0708], material: elastic}
initial: [{part: low, velocity: [0, 0, 1]}, {part: high, velocity: [0, 0, -1]}]
contact: {surfaces: all}
output: {history: {every: 1e-6, nodes: [{name: low, near: [0.05, 0.05, -0.0208], part: low}, {name: high, near: [0.053, 0.055, 0.1208], part: high}]}}
""", energy=1e-3)
    if run.code == 0:
        h = run.history
        bench.above("speed of parting at the end", h.mean(3e-4, 4e-4, "high_vz") - h.mean(3e-4, 4e-4, "low_vz"),
                    0.0, "m/s")
        bench.above("distance of the middles at the end", h.last("high_z") - h.last("low_z"), 0.14, "m")


@case("folding_plate", "hard", "Self-contact of a folding plate")
def folding_plate(bench):
    """A steel plate, two elements thick, whose ends approach at 100 m/s each from 0.2 m to 0.04 m. It buckles and folds
    until its own surfaces come into contact."""
    run = survive(bench, """
title: Folding plate
time: {end: 8e-4}
parts: {plate: {box: {size: [0.2, 0.04, 0.003], cells: [80, 8, 2]}, at: [-0.1, 0, 0], material: metal}}
initial: [{nodes: {inside: [[-0.03, -1, -1], [0.03, 1, 1]]}, velocity: [0, 0, 5]}]
conditions:
  - {nodes: plate/x_min, fixed: [y, z]}
  - {nodes: plate/x_max, fixed: [y, z]}
  - {nodes: plate/x_min, velocity: {x: 100}}
  - {nodes: plate/x_max, velocity: {x: -100}}
contact: {surfaces: all, friction: 0.2}
output: {history: {every: 1e-6}}
""")
    if run.code == 0:
        bench.above("interactions of the plate with itself", run.history.largest("contacts"), 0)


OVERLAP = """
title: Blocks that overlap at the start
time: {end: $end}
parts:
  low: {box: {size: [0.1, 0.1, 0.1], cells: [4, 4, 4]}, material: elastic}
  high: {box: {size: [0.06, 0.06, 0.06], cells: [3, 3, 3]}, at: [0.013, 0.017, $z], material: elastic}
contact: {surfaces: all, overlap: $treatment}
output: {history: {every: 1e-6, nodes: [{name: low, near: [0.05, 0.05, 0.1], part: low}, {name: high, near: [0.033, 0.037, $z], part: high}]}}
"""


@case("overlap", "hard", "Bodies that overlap at the start")
def overlap(bench):
    """A block overlaps another by 2, 20 and 60 % of an element's edge (20 mm), both at rest. Accepted overlap is the new
    reference: nothing may move. Pushed out, the blocks separate slowly: the faces at the speed that removes a thousandth
    of the overlap a step, the bodies at twice that. At most half of the overlap is left at the end."""
    for share in 0.02, 0.2, 0.6:
        z = 0.1 - share * 0.02
        run = survive(bench, OVERLAP, z=z, end=2e-4, treatment="accept", which=f"{100 * share:.0f} %, accepted",
                      energy=None)
        if run.code == 0:
            bench.below(f"{100 * share:.0f} %, accepted: kinetic energy that comes of it",
                        run.history.largest("kinetic"), 1e-12, "J")
    run = survive(bench, OVERLAP, z=0.1 - 0.02 * 0.02, end=12e-4, treatment="push_out", which="2 %, pushed out",
                  energy=None)
    if run.code == 0:
        # a face that moves at u pushes a free body up to 2 u by its waves
        mass, u = 7850 * np.array([0.1**3, 0.06**3]), 4e-7 / run.summary["dt"]["min"]
        bench.below("2 %, pushed out: kinetic energy that comes of it", run.history.largest("kinetic"),
                    0.5 * mass[0] * mass[1] / mass.sum() * (2 * u)**2, "J")
        h = run.history
        bench.above("2 %, pushed out: kinetic energy at the end", h.last("kinetic"), 0.0, "J")
        depth = h["low_z"] - h["high_z"]
        bench.near("2 %, pushed out: overlap at the start", 1e3 * depth[0], 0.4, absolute=1e-12, unit="mm")
        bench.below("2 %, pushed out: overlap at the end over that at the start", depth[-1] / depth[0], 0.5)


NODE_ON_EDGE = """
title: A node exactly on an edge
time: {end: 3e-4}
parts:
  plate: {box: {size: [0.12, 0.12, 0.03], cells: [4, 4, 1]}, at: [-0.06, -0.06, -0.03], material: elastic}
  block: {box: {size: [0.03, 0.03, 0.03], cells: [1, 1, 1]}, rotate: [{axis: z, angle: 45}, {axis: [1, -1, 0], angle: $tilt}], at: [$x, $y, 0.0001], material: elastic}
initial: [{part: block, velocity: [0, 0, -5]}]
contact: {surfaces: all}
output: {history: {every: 1e-6, nodes: [$nodes]}}
"""


@case("node_on_edge", "hard", "A node exactly on an edge or a corner")
def node_on_edge(bench):
    """A cube falls corner first onto a free plate of 4 x 4 elements at 5 m/s. It hits a corner of four faces exactly, the
    edge of two, and the corner and rim of the plate. Nothing passes and nothing is lost. The clearance is the height of
    the cube's corner over the plate at that place. Beside the plate it is more by the slope of the cube's edges, 1 /
    sqrt 2 of the way out. A cube that passed would have -1.4 mm at the end; one that rebounded or slid off has a
    positive clearance. On the way it may miss 1 % of an element's edge, 0.3 mm. On the rim neither the node nor the
    edges beside it have a face under them for long, and it sinks by half of that before the edges hold it."""
    places = ("inner corner", 0, 0, (0, 0), (0, 0)), ("inner edge", 0.015, 0, (0, 0), (0.03, 0)), \
        ("outer corner", 0.06, 0.06, (0.06, 0.06), (0.06, 0.06)), ("outer edge", 0.06, 0.015, (0.06, 0), (0.06, 0.03))
    for name, x, y, a, b in places:
        run = survive(bench, NODE_ON_EDGE, which=name, x=float(x), y=float(y), tilt=54.735610317245346, energy=1e-3,
                      nodes=f"{{name: tip, near: [{x}, {y}, 0.0001], part: block}}, {{name: a, near: [{a[0]}, {a[1]}, "
                            f"0], part: plate}}, {{name: b, near: [{b[0]}, {b[1]}, 0], part: plate}}")
        if run.code == 0:
            bench.above(f"{name}: interactions", run.history.largest("contacts"), 0)
            bench.below(f"{name}: linear momentum, relative change", run.summary["momentum"]["linear_error"], 1e-12)
            clearance = find_clearance(run.history)
            bench.above(f"{name}: smallest clearance", 1e3 * clearance.min(), -0.3, "mm")
            bench.above(f"{name}: clearance at the end", 1e3 * clearance[-1], 0.1, "mm")


def find_clearance(h):
    """Of the tip over the plate, whose top is the mean of two nodes there and whose rim they start from."""
    out = [np.maximum(h[f"tip_{axis}"] - np.maximum(h[f"a_{axis}"], h[f"b_{axis}"]), 0) if h[f"a_{axis}"][0] > 0.059
           else 0 for axis in "xy"]
    return h["tip_z"] - (h["a_z"] + h["b_z"]) / 2 + np.sqrt(0.5) * np.hypot(*out)


@case("glued_meshes", "hard", "Coincident faces of separate meshes")
def glued_meshes(bench):
    """Eight cubes share coincident faces, edges and corners without being joined. Flying together and spinning, they must
    not affect each other; hit on a side, they transmit the impulse. (Free cubes that spin together separate, as each
    flies on along its tangent. In a turn of 0.06 this is small: 0.04 mm.)"""
    template = """
title: Coincident faces
time: {end: $end}
parts:
  cubes: {box: {size: [0.05, 0.05, 0.05], cells: [3, 3, 3]}, array: {count: [2, 2, 2], pitch: [0.05, 0.05, 0.05]}, at: [-0.05, -0.05, -0.05], material: elastic}
$other
initial: [{part: cubes, velocity: [30, 20, 10], angular_velocity: [$spin]}]
contact: {surfaces: all, friction: 0.3}
output: {history: {every: 1e-6}}
"""
    for which, spin, energy in ("flying", "0, 0, 0", 1e-12), ("flying and spinning", "20, 30, 60", 1e-9):
        run = survive(bench, template, which=which, end=1e-3, other="", spin=spin, energy=energy)
        if run.code == 0:
            h = run.history
            bench.near(f"{which}: contact energy over kinetic", h.largest("contact") / h.first("kinetic"), 0,
                       absolute=0.0)
            bench.near(f"{which}: interactions", h.largest("contacts"), 0, absolute=0.0)
            bench.above(f"{which}: pairs that the search has found", h.largest("candidates"), 0)
            bench.below(f"{which}: angular momentum, relative change", run.summary["momentum"]["angular_error"], 1e-12)
    run = survive(bench, template, which="hit", end=3e-4, energy=1e-3, spin="0, 0, 0",
                  other="  hammer: {box: {size: [0.05, 0.1, 0.1], cells: [2, 4, 4]}, at: [0.0501, -0.05, -0.05], "
                        "material: elastic}")
    if run.code == 0:
        bench.above("hit: interactions", run.history.largest("contacts"), 0)


@case("corner_crush", "hard", "A cube crushed on its corner")
def corner_crush(bench):
    """An elastic-plastic cube of 6 x 6 x 6 elements hits a rigid wall on its corner at 5, 10 and 20 % of the speed of
    sound. The corner is crushed flat; the run must reach its end with a closed energy balance."""
    for share in 0.05, 0.1, 0.2:
        survive(bench, """
title: Corner crush
time: {end: $end}
parts: {cube: {box: {size: [0.1, 0.1, 0.1], cells: [6, 6, 6]}, rotate: [{axis: z, angle: 45}, {axis: [1, -1, 0], angle: 54.735610317245346}], at: [0, 0, 0.0001], material: metal}}
initial: [{part: cube, velocity: [0, 0, -$speed]}]
walls: [{normal: z}]
contact: {surfaces: all}
output: {history: {every: 1e-6}}
""", which=f"{100 * share:.0f} %", end=0.06 / (share * 5048), speed=share * 5048.0)


@case("bad_input", "hard", "Wrong input is refused")
def bad_input(bench):
    """No density, no size, elements without volume and inverted elements are refused with exit code 2 and the place,
    before anything is computed."""
    good = "box: {size: [1, 1, 1], cells: [1, 1, 1]}"
    points, corners = meshes.make_box((1, 1, 1), (2, 1, 1))
    flat = np.array(points)
    flat[np.isclose(flat[:, 0], 0.5), 0] = 0
    inverted = corners[:, [4, 5, 6, 7, 0, 1, 2, 3]]
    files = {name: meshes.write_exodus(bench.file(f"{name}.exo"), p, c)
             for name, p, c in (("flat", flat, corners), ("inverted", points, inverted))}
    for name, shape, density, word in (
            ("density 0", good, "0", "density"), ("density -1", good, "-1", "density"),
            ("size 0", "box: {size: [1, 0, 1], cells: [1, 1, 1]}", "1", "size"),
            ("no volume", f"exodus: {{file: {files['flat']}}}", "1", "element 1"),
            ("inside out", f"exodus: {{file: {files['inverted']}}}", "1", "element 1")):
        survive(bench, """
time: {end: 1}
parts: {a: {$shape, material: m}}
materials:
  m: {model: elastic, density: $density, youngs_modulus: 1, poissons_ratio: 0}
""", code=2, words=["deck.yaml:", word], which=name, shape=shape, density=density)


@case("ten_wave_speeds", "hard", "Impact at ten times the speed of sound")
def ten_wave_speeds(bench):
    """A ball hits a plate at 50 km/s. Without erosion or an equation of state no valid result is possible: the run must
    end with exit code 3 and name the element."""
    survive(bench, """
title: Ten wave speeds
time: {end: 1e-5}
parts:
  ball: {sphere: {radius: 0.01, cells: 6}, at: [0, 0, 0.0101], material: $material}
  plate: {box: {size: [0.06, 0.06, 0.006], cells: [12, 12, 3]}, at: [-0.03, -0.03, -0.006], material: $material}
initial: [{part: ball, velocity: [0, 0, -50000]}]
contact: {surfaces: all}
output: {history: {every: 1e-7}}
""", code=3, words=["element"], material="metal")


@case("driven_inversion", "hard", "An element driven to inversion")
def driven_inversion(bench):
    """The top of a block is driven through its bottom. The run ends with exit code 3 and names the element and a remedy."""
    survive(bench, """
title: Driven to inversion
time: {end: 1e-3}
parts: {block: {box: {size: [0.1, 0.1, 0.1], cells: [2, 2, 2]}, material: $material}}
conditions:
  - {nodes: block, fixed: [x, y]}
  - {nodes: block/z_min, fixed: [z]}
  - {nodes: block/z_max, displacement: {z: {expression: "-0.15 * t / 1e-3"}}}
output: {history: {every: 1e-6}}
""", code=3, words=["element"], material="metal")
