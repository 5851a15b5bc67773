"""Sheets that do not bend: membranes under pressure, cloth that wrinkles."""
import numpy as np
from scipy import integrate, optimize

import meshes
import plots
from bench import case, thin


def solve_hencky(nu):
    """B in the middle of Hencky's membrane and its deflection over a (p a / E t)^(1/3)."""

    def rates(r, y):
        return [y[1], -8 / y[0]**2 - 3 * y[1] / r, 2 * r / y[0]]

    def shoot(middle):
        r = 1e-4  # B = b - r^2 / b^2 + ... begins, for the equation divides by r
        return integrate.solve_ivp(rates, (r, 1), [middle - r * r / middle**2, -2 * r / middle**2, r * r / middle],
                                   rtol=1e-10, atol=1e-12).y[:, -1]

    def miss(middle):
        end = shoot(middle)
        return end[1] + (1 - nu) * end[0]

    middle = optimize.brentq(miss, 1.3, 3)
    return middle, shoot(middle)[2]


@case("membrane_circle", "shells", "A round membrane under pressure", quick=True)
def membrane_circle(bench):
    """A flat, round membrane is held at its rim and bulges under pressure: Hencky's solution (1915) for small strains, with the
    radial force E t / 4 q^(2/3) B(r / a), q = p a / (E t), B^2 (B'' + 3 B' / r) + 8 = 0 and B' + (1 - nu) B = 0 at the rim. For nu = 0.3 it
    has B(0) = 1.724 and the deflection 0.653 a q^(1/3) (Fichter, NASA TP-3658, 1997). Here q = 1e-5. A quarter is computed, at rest after
    dynamic relaxation, of an isotropic law and of fabric with nu = 0.2. The tolerance is 0.5 %."""
    young, thickness, pressure = 1e6, 1e-3, 0.01
    q = pressure / (young * thickness)
    for law, nu in (("elastic", 0.3), ("fabric", 0.2)):
        middle, deflection = solve_hencky(nu)
        text = (f"model: elastic, youngs_modulus: {young}, poissons_ratio: {nu}" if law == "elastic" else
            f"model: fabric, warp_modulus: {young}, weft_modulus: {young}, shear_modulus: {young / (2 + 2 * nu)}, "
            f"warp_poissons_ratio: {nu}, no_compression: true")
        for n in (4, 8):
            mesh = meshes.write_exodus(bench.file(f"disc_{n}.exo"), *meshes.make_quarter_disc(n))
            rim = meshes.each_node([p for p in meshes.make_quarter_disc(n)[0]
                                    if np.hypot(p[0], p[1]) > 1 - 1e-9], lambda _: "fixed: [x, y, z]")
            run = bench.run("""
title: A round membrane bulges
time: {end: 1e-6}
parts: {disc: {exodus: {file: $mesh}, thickness: $thickness, material: skin, integration: membrane}}
materials: {skin: {$law, density: 1}}
conditions:
  - {nodes: {inside: [[0, 0, 0], [0, 1, 0]]}, fixed: [x]}
  - {nodes: {inside: [[0, 0, 0], [1, 0, 0]]}, fixed: [y]}
$rim
loads: {pressure: [{faces: disc/bottom, value: $pressure}]}
start: {relaxation: {}}
output: {history: {every: 0, nodes: [{name: n, near: [0, 0, 0]}], elements: [{name: e, near: [0, 0, 0]}]}}
""", mesh=mesh, thickness=thickness, law=text, rim=rim, pressure=pressure)
            found = [abs(run.history.first("n_z")) / np.cbrt(q),
                     run.history.first("e_stress_xx") / (young / 4 * np.cbrt(q * q))]
            name = f"{law}, {n} elements along the radius"
            bench.near(f"{name}: deflection", found[0], deflection, relative=5e-3)
            bench.near(f"{name}: force in the middle, B", found[1], middle, relative=5e-3)


@case("membrane_sphere", "shells", "A spherical membrane swings under pressure", quick=True)
def membrane_sphere(bench):
    """Pressure p acts at once inside a ball of film (R = 2, t = 0.01, E = 1e5, nu = 0.3). It breathes: u = p R^2 (1 - nu) / (2 E t)
    (1 - cos w t) with w^2 = 2 E / (rho R^2 (1 - nu)), so that after half a period the stress is p R / t, twice that at rest. Twelve elements
    along an edge of the cube that the mesh is made of. The tolerance is 1 %."""
    radius, thickness, young, nu, density, pressure = 2.0, 0.01, 1e5, 0.3, 2.0, 0.5
    frequency = np.sqrt(2 * young / (density * radius**2 * (1 - nu)))
    run = bench.run("""
title: A spherical membrane swings
time: {end: $end}
parts: {ball: {shell_sphere: {radius: $radius, cells: 12}, thickness: $thickness, material: skin, integration: membrane}}
materials: {skin: {model: elastic, density: $density, youngs_modulus: $young, poissons_ratio: $nu}}
loads: {pressure: [{faces: ball/inner, value: $pressure}]}
output: {history: {every: 0, elements: [{name: e, near: [2, 0, 0]}], nodes: [{name: n, near: [2, 0, 0]}]}}
""", end=2.3 * np.pi / frequency, radius=radius, thickness=thickness, density=density, young=young, nu=nu, pressure=pressure)
    h, half = run.history, np.pi / frequency
    at_rest = pressure * radius**2 * (1 - nu) / (2 * young * thickness)
    bench.near("displacement after half a period", 1e3 * (h.at(half, "n_x") - radius), 2e3 * at_rest, relative=0.01,
               unit="1e-3")
    bench.near("stress after half a period", h.at(half, "e_stress_yy"), pressure * radius / thickness, relative=0.01)
    back = h["n_x"][h["time"] > half]
    bench.near("period", float(h["time"][h["time"] > half][np.argmin(back)]), 2 * half, relative=0.01)
    bench.below("energy balance, largest error", h.largest("energy_error"), 1e-3)


@case("membrane_strip", "shells", "A strip under pressure is an arc", quick=True)
def membrane_strip(bench):
    """A strip of length 1 that is held at both ends and does not contract across (nu = 0) bulges to an arc of a circle: the force N = p R, and the
    arc is exp(N / (E t)) long, as the law is linear in the logarithmic strain. The rise is 0.04, 0.08 and 0.18 of the length, with 20
    elements along it, which are a polygon. The tolerance is 0.3 %."""
    young, thickness = 1e6, 1e-3
    for pressure in (1, 10, 100):

        def miss(radius, pressure=pressure):
            return 2 * radius * np.arcsin(0.5 / radius) - np.exp(pressure * radius / (young * thickness))

        radius = optimize.brentq(miss, 0.5000001, 100)
        rise = radius - np.sqrt(radius**2 - 0.25)
        h = bench.run("""
title: A strip bulges
time: {end: 1e-6}
parts: {strip: {shell_plate: {size: [1, 0.05], cells: [20, 1]}, thickness: $thickness, material: skin, integration: membrane}}
materials: {skin: {model: elastic, density: 1, youngs_modulus: $young, poissons_ratio: 0}}
conditions: [{nodes: strip, fixed: [y]}, {nodes: strip/x_min, fixed: [x, z]}, {nodes: strip/x_max, fixed: [x, z]}]
loads: {pressure: [{faces: strip/bottom, value: $pressure}]}
start: {relaxation: {}}
output: {history: {every: 0, nodes: [{name: n, near: [0.5, 0, 0]}], elements: [{name: e, near: [0.5, 0, 0]}]}}
""", thickness=thickness, young=young, pressure=pressure).history
        bench.near(f"pressure {pressure}: rise", abs(h.first("n_z")), rise, relative=3e-3)
        bench.near(f"pressure {pressure}: stress", h.first("e_stress_xx"), pressure * radius / thickness, relative=3e-3)


CLOTH = ("model: fabric, density: 1e-3, warp_modulus: 200, weft_modulus: 200, shear_modulus: 80, "
         "warp_poissons_ratio: 0.25, no_compression: true")
SHEAR = "{{table: [[0, 0], [0.5, {0}], [0.75, {0}], [1, 0]]}}"


@case("fabric_shear", "shells", "A sheet of fabric is sheared without compression", quick=True)
def fabric_shear(bench):
    """A square of cloth is sheared by g = 0.625 between two sides that keep their distance. Without compression an isotropic sheet is a
    tension field: the stress E e along the larger principal direction of Green's strain [[0, g / 2], [g / 2, g^2 / 2]], whose value is e
    (Reissner 1938), carried to the sheared sheet by F S F^T. The energy is E e^2 / 2 by volume. A mesh of 4 x 4 whose inner nodes are
    moved at random by up to 0.3 of a cell, its sides move with the shear. The tolerance is 1e-5."""
    points, quads = meshes.make_surface((4, 4), lambda u, v: (u, v, 0 * u), 0.3)
    mesh = meshes.write_exodus(bench.file("sheet.exo"), points, quads)
    sides = [p for p in points if p[0] in (0, 1) and 0 < p[1] < 1]
    h = bench.run("""
title: Cloth is sheared
time: {end: 2}
parts: {cloth: {exodus: {file: $mesh}, thickness: 0.1, material: m, integration: membrane}}
materials: {m: {$cloth, compression_share: 0}}
conditions:
  - {nodes: cloth, fixed: [z]}
  - {nodes: {inside: [[0, 0, 0], [1, 0, 0]]}, fixed: [x, y]}
  - {nodes: {inside: [[0, 1, 0], [1, 1, 0]]}, velocity: {x: $top, y: 0}}
$sides
damping: [{coefficient: 30}]
output: {history: {every: 0.01, elements: [{name: e, near: [0.5, 0.5, 0]}], nodes: [{name: n, near: [0, 1, 0]}]}}
""", mesh=mesh, cloth=CLOTH, sides=meshes.each_node(sides, lambda n: f"velocity: {{x: {SHEAR.format(repr(sides[n][1]))}, y: 0}}"), top=SHEAR.format(1.0)).history
    g = h.last("n_x")
    half, e12 = 0.25 * g * g, 0.5 * g
    size = np.hypot(half, e12)
    principal = half + size
    direction = np.array([e12, principal]) / np.hypot(e12, principal)
    force = (np.array([[1, g], [0, 1]]) @ (200 * principal * np.outer(direction, direction))
             @ np.array([[1, g], [0, 1]]).T)
    bench.near("shear", g, 0.625, absolute=1e-3)
    for name, exact in (("xx", force[0, 0]), ("yy", force[1, 1]), ("xy", force[0, 1])):
        bench.near(f"stress {name}", h.last(f"e_stress_{name}"), exact, relative=1e-5)
    bench.near("energy", h.last("internal"), 0.1 * 100 * principal**2, relative=1e-5)


@case("fabric_bending", "shells", "A stretched sheet of fabric bends and wrinkles")
def fabric_bending(bench):
    """A sheet under the tension P is bent in its plane by the moment M. From M = P H / 6 on its compressed side wrinkles: the band b of
    its width H has b / H = 3 M / (P H) - 1/2, and the curvature k is E t H^2 k / (2 P) = 1 / (1 - b / H)^2 (Stein and Hedgepeth, NASA TN
    D-813, 1961). A sheet of 2 x 1 in 16 x 10 elements, whose inner nodes are moved at random by up to 0.3 of a cell, is turned at its ends and comes to rest. The
    curvature of the theory from the measured P and M is compared with that of the ends. The tolerance is 1 %; strains are 0.1 %."""
    young, nu, thickness, height, length = 1000.0, 0.3, 0.01, 1.0, 2.0
    mesh = meshes.write_exodus(bench.file("strip.exo"), *meshes.make_surface(
        (16, 10), lambda u, v: (length * u, height * (v - 0.5), 0 * u), 0.3))
    rows, curve = [], []
    for turn in (0.5, 2.0, 4.0, 8.0):
        strain, curvature = 1e-3, 1e-3 * turn
        ends = "\n".join(f"  - {{nodes: {{inside: [[{x}, {y!r}, 0], [{x}, {y!r}, 0]]}}, velocity: {{x: {{table: [[0, "
                         f"{s * 0.5 * length * (strain + curvature * y)!r}], [1, "
                         f"{s * 0.5 * length * (strain + curvature * y)!r}], [1.001, 0]]}}}}}}"
                         for x, s in ((0.0, -1), (length, 1)) for y in np.linspace(-0.5, 0.5, 11).tolist())
        run = bench.run("""
title: A sheet is stretched and bent
time: {end: 4}
parts: {sheet: {exodus: {file: $mesh}, thickness: $thickness, material: m, integration: membrane}}
materials: {m: {model: fabric, density: 1e-1, warp_modulus: $young, weft_modulus: $young, shear_modulus: $shear, warp_poissons_ratio: $nu, no_compression: true, compression_share: 1e-4}}
conditions:
  - {nodes: sheet, fixed: [z]}
  - {nodes: {inside: [[0, 0, 0], [0, 0, 0]]}, fixed: [y]}
$ends
damping: [{coefficient: 20}]
output: {history: {every: 0.01, forces: [{name: f, support: {inside: [[2, -1, 0], [2, 1, 0]]}, about: [2, 0, 0]}]}}
""", mesh=mesh, thickness=thickness, young=young, shear=young / (2 + 2 * nu), nu=nu, ends=ends)
        force, moment = run.history.mean(3.5, 4, "fx:f"), -run.history.mean(3.5, 4, "mz:f")
        ratio = moment / (force * height)
        theory = 6 * ratio if ratio < 1 / 6 else 1 / (1.5 - 3 * ratio)**2
        measured = young * thickness * height**2 * curvature / (2 * force)
        name = f"end turn {1e3 * curvature * length / 2:g}e-3"
        bench.near(f"{name}: curvature, E t H^2 k / (2 P)", measured, theory, relative=0.01)
        rows.append([name, f"{ratio:.4f}", f"{max(0, 3 * ratio - 0.5):.3f}", f"{measured:.4f}", f"{theory:.4f}"])
        curve.append((ratio, measured))
    bench.table(["ends", "M / (P H)", "wrinkled share", "curvature", "theory"], rows)

    def draw(axes):
        low, high = np.linspace(0, 1 / 6, 2), np.linspace(1 / 6, 0.42, 100)
        axes.plot(np.r_[low, high], np.r_[6 * low, 1 / (1.5 - 3 * high)**2], label="Stein and Hedgepeth", **plots.EXACT)
        axes.plot(*zip(*curve), "o", label="16 x 10 elements")
        axes.set(xlabel="M / (P H)", ylabel="E t H^2 k / (2 P)")
        axes.legend()

    bench.figure("Curvature of the sheet over its moment.", draw)


@case("fabric_bag", "shells", "A round bag of cloth is inflated")
def fabric_bag(bench):
    """Two round sheets of the radius r, joined at their rims, are inflated. Their cloth does not stretch and wrinkles along its parallels:
    the radius falls to 0.7627 r, and the bag is 0.5991 as high as wide, 0.9139 r (Paulsen, Am. Math. Monthly 101, 1994; W. Taylor 1919). A
    quarter of one sheet is inflated from flat, with p r / (E t) = 1e-4. The
    tolerance is 3 % with 8 elements along the radius and 1.5 % with 12: the rim folds within one ring of elements."""
    rows = []
    for n, within in ((8, 0.03), (12, 0.015)):
        points, quads = meshes.make_quarter_disc(n)
        mesh = meshes.write_exodus(bench.file(f"bag_{n}.exo"), points, quads)
        rim = meshes.each_node([p for p in points if np.hypot(p[0], p[1]) > 1 - 1e-9], lambda _: "fixed: [z]")
        run = bench.run("""
title: A bag is inflated
time: {end: $end}
parts: {bag: {exodus: {file: $mesh}, thickness: 0.01, material: m, integration: membrane}}
materials: {m: {model: fabric, density: 1, warp_modulus: 1e6, weft_modulus: 1e6, shear_modulus: 0.5e6, no_compression: true, compression_share: 0}}
conditions:
  - {nodes: {inside: [[0, 0, 0], [0, 1, 0]]}, fixed: [x]}
  - {nodes: {inside: [[0, 0, 0], [1, 0, 0]]}, fixed: [y]}
$rim
loads: {pressure: [{faces: bag/top, value: {table: [[0, 0], [0.1, -1], [10, -1]]}}]}
damping: [{coefficient: 10}]
output: {history: {every: 1e-2, nodes: [{name: top, near: [0, 0, 0]}, {name: side, near: [1, 0, 0]}, {name: front, near: [0, 1, 0]}, {name: slant, near: [0.7071, 0.7071, 0]}]}}
""", mesh=mesh, rim=rim, end=1.2)
        h = run.history
        width = np.mean([h.last("side_x"), h.last("front_y"), np.hypot(h.last("slant_x"), h.last("slant_y"))])
        name = f"{n} elements along the radius"
        bench.near(f"{name}: radius", float(width), 0.7627, relative=within)
        bench.near(f"{name}: height", 2 * abs(h.last("top_z")), 0.9139, relative=within)
        rows.append([name, f"{h.last('side_x'):.4f}", f"{np.hypot(h.last('slant_x'), h.last('slant_y')):.4f}",
                     f"{2 * abs(h.last('top_z')):.4f}"])
    bench.table(["mesh", "radius along an axis", "at 45 degrees", "height"], rows)
