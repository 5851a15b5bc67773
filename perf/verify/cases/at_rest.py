"""Static answers by dynamic relaxation: thin shells, and solids other than hexahedra that hardly change their volume."""
import numpy as np

from bench import case


@case("relaxed_shells", "bending", "Dynamic relaxation of thin shells", quick=True)
def relaxed_shells(bench):
    """`start.relaxation` finds the state of rest at time 0. Morley's skew plate (*Skew Plates and Structures*, 1963) has an
    angle of 30 degrees, sides of 100 and a thickness of 1: nothing brings back the spins of its shells. Its middle sinks by
    0.408e-3 q L^4 / D. Four-node shells of 16 x 16 are within 7 %. The twisted beam of MacNeal and Harder (1985) has the
    deflection 5.424e-3 at its tip, within 1 % with 12 x 2 shells. Both are at rest after some thousand steps, as is written
    for `start.relaxation`: below 10 000 and 16 000."""
    plate = bench.run("""
time: {end: 1e-6}
parts: {plate: {shell_plate: {size: [100, 50], cells: [16, 16]}, thickness: 1, material: m}}
imperfections: [{nodes: plate, direction: x, mode: "y*tan(pi/3)"}]
materials: {m: {model: elastic, density: 1e-3, youngs_modulus: 1e7, poissons_ratio: 0.3}}
start: {relaxation: {tolerance: 1e-9}}
conditions:
  - {nodes: plate, fixed: [x, y]}
  - {nodes: plate/x_min, fixed: [z]}
  - {nodes: plate/x_max, fixed: [z]}
  - {nodes: plate/y_min, fixed: [z]}
  - {nodes: plate/y_max, fixed: [z]}
loads: {pressure: [{faces: plate/bottom, value: 0.1, direction: z}]}
output: {history: {every: 0, nodes: [{name: middle, near: [93.3, 25, 0]}]}}
""")
    exact = 0.408e-3 * 0.1 * 1e8 * 12 * (1 - 0.3**2) / 1e7
    bench.near("skew plate: deflection of the middle", plate.history.first("middle_z"), exact, relative=0.07)
    bench.below("skew plate: damped steps", plate.summary["relaxation"]["damped_steps"], 10000)
    beam = bench.run("""
time: {end: 1e-9}
parts: {beam: {shell_plate: {size: [12, 1.1], cells: [12, 2]}, at: [0, -0.55, 0], thickness: 0.32, material: m}}
imperfections:
  - {nodes: beam, direction: y, mode: "y*cos(pi/24*x)-y"}
  - {nodes: beam, direction: z, mode: "y*sin(pi/24*x)"}
materials: {m: {model: elastic, density: 1e-3, youngs_modulus: 29e6, poissons_ratio: 0.22}}
start: {relaxation: {tolerance: 1e-8}}
conditions: [{nodes: beam/x_min, fixed: [x, y, z, rx, ry, rz]}]
loads: {nodal: [{nodes: beam/x_max, force: {z: 0.33333333}}]}
output: {history: {every: 0, nodes: [{name: tip, near: [12, 0, 0]}]}}
""")
    bench.near("twisted beam: deflection of the tip", beam.history.first("tip_z"), 5.424e-3, relative=0.01)
    bench.below("twisted beam: damped steps", beam.summary["relaxation"]["damped_steps"], 16000)


@case("cooks_other_solids", "bending", "Cook's membrane of wedges, pyramids and tetrahedra")
def cooks_other_solids(bench):
    """The membrane of `cooks_membrane` (Poisson's ratio 0.4999, plane strain), with a load of 1 found at rest by
    `start.relaxation`: its corner moves by 0.0805. Averages over nodes keep wedges, pyramids and tetrahedra from locking, but
    their triangles of constant strain bend too stiffly: the deflection is within 20 % with 8 cells a side, and the error is less
    than 0.6 of that with 4 cells (theory_wedges.md, section 4). Wedges are within 5 % with 16. Without averages (`plain`) they
    are stiffer: shown, not judged."""
    rows = []
    for kind, more in (("wedges", ""), ("pyramids", ""), ("tetrahedra", ""),
                       ("wedges", "elements: {tetrahedra: plain}")):
        found = []
        for cells in (4, 8, 16) if kind == "wedges" and not more else (4, 8):
            h = bench.run("""
time: {end: 1e-3}
parts: {b: {box: {size: [48, 44, 2], cells: [$cells, $cells, 1]}, elements: $kind, material: m}}
imperfections: [{nodes: b, direction: y, mode: "44/48*x + y/44*(44 - 28*x/48) - y"}]
materials: {m: {model: elastic, density: 1e-3, youngs_modulus: 240.565, poissons_ratio: 0.4999}}
start: {relaxation: {tolerance: 1e-6}}
conditions:
  - {nodes: b/x_min, fixed: [x, y, z]}
  - {nodes: b, fixed: [z]}
loads: {pressure: [{faces: b/x_max, value: 0.0625, direction: y}]}
output: {history: {every: 0, nodes: [{name: a, near: [48, 60, 0]}]}}
$more
""", cells=cells, kind=kind, more=more).history
            found.append(h.first("a_y") - 60)
        if not more:
            bench.near(f"{kind}, 8 cells a side: deflection", found[1], 0.0805, relative=0.2)
            bench.below(f"{kind}: error with 8 cells over that with 4",
                        abs(0.0805 - found[1]) / abs(0.0805 - found[0]), 0.6)
        if len(found) > 2:
            bench.near(f"{kind}, 16 cells a side: deflection", found[2], 0.0805, relative=0.05)
        rows.append([kind + (", plain" if more else ""), *(f"{x:.4f}" for x in found), *([""] * (3 - len(found)))])
    bench.table(["elements", "4 x 4", "8 x 8", "16 x 16"], rows)


@case("tetrahedra_splits", "bending", "Cells cut into twelve, six and five tetrahedra: bent and pulled beams")
def tetrahedra_splits(bench):
    """A steel beam of 1 by 0.1 by 0.1 m, held at one end, bends under a shear stress of 0.1 MPa at the other: Timoshenko's beam
    moves by P L^3 / (3 E I) + P L / (k G A), k = 10 (1 + nu) / (12 + 11 nu). Of cubes cut into twelve or six tetrahedra, two
    through the beam are within 3 %, of those cut into five four are within 4 %: averages over nodes of few elements make them too soft.
    One cell through the beam is shown, not judged. A bar of 1 by 0.05 by 0.05 m without Poisson's
    ratio is pulled at one end by a stress s that begins suddenly: its end moves by 2 s L / E at the time 2 L / c and returns.
    With four cells through it and 80 along it, time is within 0.3 %, displacement within 3 %: bulk viscosity rounds the wave."""
    rows = []
    young, poisson, size, load = 200e9, 0.3, 0.1, 1e5
    force, inertia = load * size**2, size**4 / 12
    shear_stiffness = 10 * (1 + poisson) / (12 + 11 * poisson) * young / (2 * (1 + poisson)) * size**2
    bent = force / (3 * young * inertia) + force / shear_stiffness
    stress, speed = 1e6, (young / 7850)**0.5
    for kind in ("tetrahedra", "six_tetrahedra", "five_tetrahedra"):
        row = [kind]
        for cells in (1, 2, 4):
            run = bench.run("""
time: {end: 1e-5}
parts: {b: {box: {size: [1, 0.1, 0.1], cells: [$along, $cells, $cells]}, elements: $kind, material: m}}
materials: {m: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}
start: {relaxation: {tolerance: 1e-6}}
conditions: [{nodes: b/x_min, fixed: [x, y, z]}]
loads: {pressure: [{faces: b/x_max, value: 1e5, direction: z}]}
output: {history: {every: 0, nodes: [{name: a, near: [1, 0.1, 0.1]}]}}
""", along=10 * cells, cells=cells, kind=kind)
            found = run.history.first("a_z") - 0.1
            row.append(f"{100 * (found / bent - 1):+.1f} %")
            if cells == (4 if kind == "five_tetrahedra" else 2):
                bench.near(f"{kind}, {cells} cells through: deflection", found, bent,
                           relative=0.04 if cells == 4 else 0.03, unit="m")
        run = bench.run("""
time: {end: $end}
parts: {b: {box: {size: [1, 0.05, 0.05], cells: [80, 4, 4]}, elements: $kind, material: m}}
materials: {m: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0}}
conditions: [{nodes: b/x_min, fixed: [x]}]
loads: {pressure: [{faces: b/x_max, value: -1e6, direction: x}]}
output: {history: {every: 1e-6, nodes: [{name: a, near: [1, 0.025, 0.025]}]}}
""", end=3.9 / speed, kind=kind)
        t, moved, peak = run.history["time"], abs(run.history["a_x"] - 1), 2 * stress / young
        sides = np.flatnonzero((moved[:-1] - peak / 2) * (moved[1:] - peak / 2) < 0)
        times = [t[i] + (peak / 2 - moved[i]) / (moved[i + 1] - moved[i]) * (t[i + 1] - t[i])
                 for i in (sides[0], sides[-1])]
        bench.near(f"{kind}: time of the largest displacement", sum(times) / 2, 2 / speed, relative=3e-3, unit="s")
        bench.near(f"{kind}: largest displacement", float(moved.max()), peak, relative=0.03, unit="m")
        rows.append([*row, str(run.summary["steps"])])
    bench.table(["elements", "1 cell through", "2 cells", "4 cells", "steps of the bar"], rows)
