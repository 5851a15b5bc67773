"""Dry friction that sticks and slips: springs, belts and fits against closed answers."""
import numpy as np

import choices
import meshes
import plots
from bench import case, thin

G = 9.81

SLIDER = """
title: A block on a spring
time: {end: $end, max_step: 5e-4}
parts:
  block: {box: {size: [0.2, 0.2, 0.1], cells: [2, 2, 1]}, at: [0, 0, 0], material: m, rigid: {mass: 1}}
  anchor: {box: {size: [0.1, 0.1, 0.1], cells: [2, 2, 2]}, at: [$anchor, 0.05, 0], material: m, rigid: true}
  $floor
materials: {m: {model: elastic, density: 1000, youngs_modulus: 1e7, poissons_ratio: 0.3}}
springs: {spring: {between: [{near: [0.2, 0.1, 0], part: block}, {near: [$anchor, 0.1, 0], part: anchor}], stiffness: 100, rest_length: $rest}}
conditions:
  - {nodes: anchor, velocity: {x: $speed, y: 0, z: 0}}
  $held
loads: {gravity: [0, 0, -9.81]}
$surface
output: {history: {every: 1e-3, nodes: [{name: n, near: [0, 0.1, 0], part: block}]}}
"""

ON_WALL = {"floor": "", "held": "", "surface": "walls: [{normal: z, friction: 0.3}]\ncontact: {surfaces: none}"}


def put_on_plate(enforcement):
    return {"floor": "plate: {box: {size: [2, 1, 0.1], cells: [9, 5, 1]}, at: [-1, -0.4, -0.1], material: m, "
                     "rigid: true}",
            "held": "- {nodes: plate, fixed: [x, y, z]}",
            "surface": "contact: {surfaces: [[block, plate]], friction: 0.3" + enforcement + "}"}


def follow_oscillator(start, share, frequency, times):
    """Place of a block on a spring with dry friction: start, where it begins at rest; share: friction over stiffness, half
    of what each half period takes."""
    place, half = np.empty_like(times), np.pi / frequency
    for i, t in enumerate(times):
        x, n = start, int(t / half)
        for _ in range(n):
            if abs(x) <= share:
                break
            x = -np.sign(x) * (abs(x) - 2 * share)
        else:
            if abs(x) > share:
                center = np.sign(x) * share
                x = center + (x - center) * np.cos(frequency * (t - n * half))
        place[i] = x
    return place


@case("spring_slider", "friction", "Friction: stick and slip of a block on a spring")
def spring_slider(bench):
    """A rigid block of 1 kg on a floor with friction 0.3 is held by a spring of 100 N/m, w = 10 rad/s; d = mu m g /
    k.

    Swinging: it starts 0.2 m from rest. Each half period pi / w takes 2 d from the amplitude, and the block sticks
    where it stops within d of rest. Exactly: -0.1411, 0.0823, -0.0234 m, for good after three half periods.

    Dragged: the end of the spring moves at V = 0.05 m/s. The block sticks until the spring has stretched by d, at d /
    V, and then moves as V (s - sin(w s) / w), s since then: it comes to rest for an instant every period 2 pi / w,
    and does not stay.

    On a rigid wall, and on a rigid plate by every enforcement. Motion starts and stops within a step of 5e-4 s, at
    which the acceleration jumps: places are within 1e-4 m, half a per cent of the last swing, where the block stops
    and when it is dragged, and within 1e-3 m on the way of the swing (a step at its largest speed). Lagrange
    multipliers get 1e-3 m for all: nine nodes hold where three would, and the solution does not converge in a
    third to a half of the steps (docs/limits.md). A block that sticks creeps by less than the iteration may leave
    of one step: 1e-2 g dt^2, 2.5e-8 m."""
    share, curves, dragged, rows = 0.3 * G / 100, [], [], []
    surfaces = {"wall": ON_WALL,
                **{name: put_on_plate(text) for name, text in choices.list_enforcements(bench).items()}}
    for name, surface in surfaces.items():
        allowed = 1e-3 if name == "lagrange" else 1e-4
        h = bench.run(SLIDER, end=2.0, anchor=1.0, rest=0.6, speed=0, **surface).history
        swing = 0.2 - h["n_x"] + h["n_x"][0]
        exact = follow_oscillator(0.2, share, 10.0, h["time"])
        late = h["time"] > 1.2
        found = [float(swing[-1]), float(np.abs(swing - exact).max()), float(np.ptp(swing[late]))]
        bench.near(f"{name}: where the swinging block stops", found[0], float(exact[-1]), absolute=allowed, unit="m")
        bench.near(f"{name}: largest distance from the exact swing", found[1], 0, absolute=10 * allowed, unit="m")
        bench.near(f"{name}: work of friction", h.last("friction"), -0.5 * 100 * (0.04 - float(exact[-1])**2),
                   relative=2e-3, unit="J")
        bench.below(f"{name}: it sticks: creep in 0.8 s", found[2], 2.5e-8, unit="m")
        curves.append((name, h["time"], swing))
        h = bench.run(SLIDER, end=2.5, anchor=1.0, rest=0.8, speed=0.05, **surface).history
        since = h["time"] - share / 0.05
        way = np.where(since > 0, 0.05 * (since - np.sin(10 * since) / 10), 0)
        moved = h["n_x"] - h["n_x"][0]
        found.append(float(np.abs(moved - way).max()))
        bench.near(f"{name}: largest distance from the exact path when dragged", found[3], 0,
                   absolute=allowed, unit="m")
        rows.append([name, *(f"{1e3 * x:.4g}" for x in found)])
        dragged.append((name, h["time"], moved))
    bench.table(["contact", "stops at [mm]", "largest distance, swing [mm]", "creep in 0.8 s [mm]",
                 "largest distance, dragged [mm]"], rows)

    def draw(axes):
        t = np.linspace(0, 2, 300)
        axes.plot(t, follow_oscillator(0.2, share, 10.0, t), label="exact", **plots.EXACT)
        for name, times, swing in curves:
            axes.plot(*thin(times, swing, 200), label=name)
        axes.set(xlabel="time [s]", ylabel="elongation of the spring [m]")
        axes.legend()

    bench.figure("The swinging block.", draw)

    def draw_dragged(axes):
        axes.plot(*thin(h["time"], way, 300), label="exact", **plots.EXACT)
        for name, times, moved in dragged:
            axes.plot(*thin(times, moved, 200), label=name)
        axes.set(xlabel="time [s]", ylabel="way of the block [m]")
        axes.legend()

    bench.figure("The dragged block.", draw_dragged)


def wrap_belt(bench, radius, thickness, straight, along):
    """Shells of a belt half around a drum at the origin (axis z), with straight ends down to y = -straight."""
    arc = np.pi * (radius + thickness / 2)
    total = arc + 2 * straight

    def place(u, v):
        s = u * total - straight
        angle = np.clip(s / arc, 0, 1) * np.pi
        x, y = (radius + thickness / 2) * np.cos(angle), (radius + thickness / 2) * np.sin(angle)
        return -x, y + np.minimum(s, 0) + np.minimum(arc - s, 0), 0.01 * v

    return meshes.write_exodus(bench.file("belt.exo"), *meshes.make_surface((along, 1), place))


BELT = """
title: A belt on a drum that turns
time: {end: $end}
parts:
  drum: {tube: {inner_radius: 0.08, outer_radius: 0.1, length: 0.02, cells: [1, 360, 1]}, at: [0, 0, -0.005], material: m, rigid: true}
  belt: {exodus: {file: $mesh}, material: m, thickness: 0.001$damping}
materials: {m: {model: elastic, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0}}
conditions:
  - {nodes: drum, velocity: {x: 0, y: 0, z: 0, rx: 0, ry: 0, rz: -20}}
  - {nodes: {name: belt, inside: [[-1, -0.1001, -1], [-0.05, -0.0999, 1]]}, fixed: [x, y, z]}
  - {nodes: belt, fixed: [z, rx, ry]}
loads: {nodal: [{nodes: {name: belt, inside: [[0.05, -0.1001, -1], [1, -0.0999, 1]]}, force: {y: {expression: "t < 0.004 ? -5 * (1 - cos(pi * t / 0.004)) : -10"}}}]}
contact: {surfaces: [[belt, drum]], friction: $mu, edges: false}
output: {history: {every: 1e-5, forces: [{name: held, support: {name: belt, inside: [[-1, -0.1001, -1], [-0.05, -0.0999, 1]]}}]}}
"""


@case("capstan", "friction", "Friction: a belt on a drum")
def capstan(bench):
    """A belt of shells lies half around a rigid drum of 360 faces that turns under it. One end is held, the other is
    pulled with 20 N. Friction holds the pull back: the forces of the ends are as exp(mu pi) (Euler 1769, Eytelwein
    1808). Contact acts on the mesh, the middle of the belt, so that its thickness does not enter.

    The pull grows over 4 ms. A wave takes 0.5 ms along the belt and rings on; the force of the support is a mean from
    5 to 11 ms under a window. Bumps of the drum (4 um) change the tension by 0.1 %, and the ringing leaves some per
    mille: the tolerance is 1 %. Without damping the belt flutters later, by friction (docs/limits.md): longer runs have a
    `stiffness_damping` of 1e-6 s, a fifth of the step, and are judged from 20 to 50 ms too."""
    rows, mesh = [], wrap_belt(bench, 0.1, 0.001, 0.1, 102)
    for mu, end, damping in ((0.2, 0.011, ""), (0.1, 0.011, ""), (0.2, 0.05, ", stiffness_damping: 1e-6"),
                             (0.4, 0.05, ", stiffness_damping: 1e-6")):
        exact = float(np.exp(mu * np.pi))
        h = bench.run(BELT, mesh=mesh, mu=mu, end=end, damping=damping).history
        name = f"friction {mu}{', damped' if damping else ''}"
        bench.near(f"{name}: force of the held end over the pull", -h.steady(0.005, 0.011, "fy:held") / 20, exact,
                   relative=0.01)
        if damping:
            bench.near(f"{name}: the same from 20 to 50 ms", -h.steady(0.02, 0.05, "fy:held") / 20, exact,
                       relative=0.01)
        rows.append((name, h["time"], -h["fy:held"] / 20, exact))

    def draw(axes):
        for name, times, ratio, exact in rows:
            axes.plot(*thin(1e3 * times, ratio, 300), label=name, linewidth=0.8)
            axes.axhline(exact, **plots.EXACT)
        axes.set(xlabel="time [ms]", ylabel="force of the held end over 20 N")
        axes.legend()

    bench.figure("The held end of the belt; dashed: exp(mu pi).", draw)


FIT = """
title: A ring shrunk on a ring
time: {end: 1.2e-3}
parts:
  inner: {tube: {inner_radius: 0.02, outer_radius: $outer, length: 0.002, cells: [8, $inner_cells, 1], arc: 90}, material: steel}
  outer: {tube: {inner_radius: 0.04, outer_radius: 0.06, length: 0.002, cells: [8, $outer_cells, 1], arc: 90}, material: steel}
materials: {steel: {model: elastic, density: 7850, youngs_modulus: 210e9, poissons_ratio: 0.3}}
conditions:
  - {nodes: all, fixed: [z]}
  - {nodes: inner/first, symmetry: y}
  - {nodes: outer/first, symmetry: y}
  - {nodes: inner/last, symmetry: x}
  - {nodes: outer/last, symmetry: x}
contact: {surfaces: [[inner, outer]], overlap: push_out, edges: false$enforcement}
output: {history: {every: 5e-7, elements: [$elements]}}
"""


def find_turn(cells):
    """Angle of the middle of the element beside 45 degrees."""
    return float(np.pi / 2 * (cells // 2 + 0.5) / cells)


def list_spots(middles, outer_cells):
    """Elements of both rings to follow."""
    spots = []
    for i, r in enumerate(middles):
        turn = find_turn(48 if i < 8 else outer_cells)
        spots.append(f"{{name: e{i}, part: "
                     f"{'inner' if i < 8 else 'outer'}, near: [{r * np.cos(turn)!r}, {r * np.sin(turn)!r}, 0.001]}}")
    return ", ".join(spots)


def average_stress(history, element, cells):
    """Radial and hoop stress over 20 periods."""
    xx, yy, xy = (history.steady(2e-4, 1.2e-3, f"e{element}_stress_{name}") for name in ("xx", "yy", "xy"))
    c, s = np.cos(find_turn(cells)), np.sin(find_turn(cells))
    return c * c * xx + s * s * yy + 2 * s * c * xy, s * s * xx + c * c * yy - 2 * s * c * xy


def find_lame(pressure, inner, bore, outer, radius, is_inner):
    """Radial and hoop stress of rings that press on each other at the bore."""
    if is_inner:
        return [-pressure * bore**2 / (bore**2 - inner**2) * (1 + sign * inner**2 / radius**2) for sign in (-1, 1)]
    return [pressure * bore**2 / (outer**2 - bore**2) * (1 + sign * outer**2 / radius**2) for sign in (-1, 1)]


@case("shrink_fit", "friction", "Shrink fit of two rings")
def shrink_fit(bench):
    """A steel ring of radii 20 and 40.04 mm sits in one of 40 and 60 mm. `overlap: push_out` takes the overlap out.
    Lame's thick tubes (1852), in plane strain with E' = E / (1 - nu^2), then press on each other with p = 54.1 MPa: p
    b / E' [(c^2 + b^2) / (c^2 - b^2) + (b^2 + a^2) / (b^2 - a^2)] = overlap. Radial and hoop stress follow at every
    radius.

    Nothing damps the rings. They breathe about this state with a period of some 50 us, and a mean over 20 periods
    under a window leaves it. Both quarters have 48 elements around and 8 through. A strain of 0.1 % and the polygons
    change the answer by as much, an element's mean stress differs from that at its middle by (h / r)^2 / 2 of itself,
    0.8 % at the hole. The tolerance is 1 % of the largest stress. In another run the outer ring has 36 around, so
    that nodes do not match. Then corners of the inner polygon reach up to 9.5 um beyond the faces of the outer one,
    on top of the overlap. Stress is between that of the mean overlap of the polygons (42.8 um), which soft rings
    would see, and that of the largest (49.5 um), which hard ones see; these are hard, since bending a face by 5 um
    takes some GPa. It is judged at the hole, which averages over corners, with 1 % on either side."""
    inner, bore, outer = 0.02, 0.04, 0.06
    modulus = 210e9 / 0.91
    middles = [0.02 + 0.0025 * (i + 0.5) for i in range(16)]
    curves = []
    for name, cells in (("matching nodes", 48), ("other nodes", 36)):
        sagitta = [bore * (1 - np.cos(np.pi / 4 / n)) for n in (48, cells)]
        overlap = 4e-5 + 2 / 3 * (sagitta[1] - sagitta[0])
        pressure = overlap * modulus / bore / ((outer**2 + bore**2) / (outer**2 - bore**2)
                                               + (bore**2 + inner**2) / (bore**2 - inner**2))
        h = bench.run(FIT, outer=bore + 4e-5, inner_cells=48, outer_cells=cells, elements=list_spots(middles, cells),
                      enforcement="").history
        table = np.array([[r, *average_stress(h, i, 48 if i < 8 else cells),
                           *find_lame(pressure, inner, bore, outer, r, i < 8)] for i, r in enumerate(middles)])
        largest = abs(table[:, 3:]).max()
        if cells == 48:
            bench.near(f"{name}: hoop stress at the hole", 1e-6 * table[0, 2], 1e-6 * table[0, 4], relative=0.01,
                       unit="MPa")
            bench.near(f"{name}: hoop stress of the outer ring at the joint", 1e-6 * table[8, 2], 1e-6 * table[8, 4],
                       relative=0.01, unit="MPa")
            for kind, column in (("radial", 1), ("hoop", 2)):
                bench.below(f"{name}: largest error of {kind} stress over the largest",
                            abs(table[:, column] - table[:, column + 2]).max() / largest, 0.01)
        else:
            share = table[0, 2] / table[0, 4]
            bench.above(f"{name}: hoop stress at the hole over that of the mean overlap", share, 0.99)
            bench.below(f"{name}: hoop stress at the hole over that of the mean overlap", share,
                        1.01 * (4e-5 + sagitta[1]) / overlap)
        bench.below(f"{name}: energy balance, largest error", h.largest("energy_error"), 1e-3)
        curves.append((name, table))

    def draw(axes):
        table = curves[0][1]
        for part in (slice(0, 8), slice(8, 16)):
            axes.plot(1e3 * table[part, 0], 1e-6 * table[part, 3], **plots.EXACT)
            axes.plot(1e3 * table[part, 0], 1e-6 * table[part, 4], **plots.EXACT)
        for (name, table), mark in zip(curves, "o+"):
            axes.plot(1e3 * table[:, 0], 1e-6 * table[:, 1], mark, color="C0", label=f"radial, {name}")
            axes.plot(1e3 * table[:, 0], 1e-6 * table[:, 2], mark, color="C1", label=f"hoop, {name}")
        axes.set(xlabel="radius [mm]", ylabel="stress [MPa]")
        axes.legend()

    bench.figure("Stress in the two rings; dashed: Lame.", draw)
