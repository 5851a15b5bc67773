"""A cap pressed on a like cap and pushed sideways: the ring of slip of Cattaneo and Mindlin."""
import numpy as np

import meshes
import plots
from bench import case, thin

YOUNG, NU, RADIUS = 200e9, 0.3, 0.2
SHEAR, PLANE = YOUNG / (2 * (1 + NU)), YOUNG / (1 - NU**2) / 2  # G; E* of two like bodies
CONTACT, NEAR = 1e-3, 8e-3  # radius of contact aimed at, distance of the held sides [m]
START, EVEN = 4e-5, 5e-5  # the push begins; its speed is constant from here on [s]
SPEED = 0.0474  # of the push [m/s]

PRESSED = """
title: Two caps pressed together and pushed sideways
time: {end: $end}
parts:
  low: {exodus: {file: $low}, rotate: [{axis: y, angle: 180}], material: steel}
  high: {exodus: {file: $high}, material: steel}
materials: {steel: {model: elastic, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3}}
conditions:
  - {nodes: {inside: [[-1, 0, -1], [1, 0, 1]]}, symmetry: y}
$held
contact: {surfaces: [[low, high]], friction: $friction}
damping: [{coefficient: 2e5}]
output:
  fields: {every: 5e-6, write: [contact_force]}
  history: {every: 1e-7, forces: [{name: touch, contact: [high, low]}]}
"""
PRESS = "t < 3e-5 ? -4.7e-6 * (1 - cos(pi * t / 3e-5)) : -9.4e-6"
PUSH = (f"t < {START} ? 0 : (t < {EVEN} ? {SPEED} * (t - {START})^2 / {2 * (EVEN - START)} : {SPEED} * "
        f"(t - {(START + EVEN) / 2}))")


def find_push(t):
    """Way of the push at times [m]."""
    eased = SPEED * (t - START)**2 / (2 * (EVEN - START))
    return np.where(t < START, 0, np.where(t < EVEN, eased, SPEED * (t - (START + EVEN) / 2)))


def grade(reach, far, cell, ratio):
    """Places from 0 to far: equal cells up to reach, then growing by the ratio."""
    near = np.linspace(0, reach, int(round(reach / cell)) + 1)
    count = int(np.ceil(np.log1p((far - reach) * (ratio - 1) / cell) / np.log(ratio)))
    steps = ratio ** np.arange(1, count + 1)
    return np.concatenate([near, reach + (far - reach) * np.cumsum(steps) / steps.sum()])


def make_cap(bench, far, cells):
    """Half (y >= 0) of a block above z = 0 whose lower side is a paraboloid; so many elements on the radius of contact."""
    cell = CONTACT / cells
    side, up = grade(1.25 * CONTACT, far, cell, 1.3), grade(cell, far, cell, 1.25)
    axes = [np.concatenate([-side[:0:-1], side]), side, up]
    _, corners = meshes.make_box([1, 1, 1], [len(a) - 1 for a in axes])
    z, y, x = (a.ravel() for a in np.meshgrid(axes[2], axes[1], axes[0], indexing="ij"))
    points = np.stack([x, y, z + (1 - z / far) * (x**2 + y**2) / (2 * RADIUS)], axis=1)
    return meshes.write_exodus(bench.file(f"cap_{far}_{cells}.exo"), points, corners)


def hold_far_sides(far):
    """Conditions of the far sides: those of the upper body move, those of the lower one are held."""
    e, lines = 1e-9, []
    moved = f'displacement: {{x: {{expression: "{PUSH}"}}, z: {{expression: "{PRESS}"}}}}'
    for part, z, motion in (("high", [far - e, far + e], moved), ("low", [-far - e, e - far], "fixed: [x, z]")):
        sides = [[[-far - e, -1, -1], [e - far, 1, 1]], [[far - e, -1, -1], [far + e, 1, 1]],
                 [[e - far, far - e, -1], [far - e, far + e, 1]], [[e - far, -1, z[0]], [far - e, far - e, z[1]]]]
        lines += [f"  - {{nodes: {{name: {part}, inside: {inside}}}, {motion}}}" for inside in sides]
    return "\n".join(lines)


def push_caps(bench, far, friction, end, low=6):
    """The run, the normal force (a mean) and the tangential force over the rows, both of whole bodies. low: elements of the lower one on the radius of contact."""
    run = bench.run(PRESSED, low=make_cap(bench, far, low), high=make_cap(bench, far, 6), held=hold_far_sides(far),
                    friction=friction, end=end)
    h = run.history
    return run, 2 * h.mean(EVEN, end, "fz:touch"), 2 * np.abs(h["fx:touch"])


def find_radius(force):
    """Radius of contact by Hertz; two like bodies of this radius."""
    return (3 * force * (RADIUS / 2) / (4 * PLANE))**(1 / 3)


def find_compliance(force):
    """Tangential way over force where nothing slips."""
    return (2 - NU) / (4 * SHEAR * find_radius(force))


def measure_compliance(bench, far):
    """The same of bodies whose sides are held at this distance, over that of half-spaces; the compliance; the force."""
    run, normal, side = push_caps(bench, far, 10, 8e-5)
    late = run.history["time"] > 5.5e-5
    slope = np.polyfit(side[late], find_push(run.history["time"][late]), 1)[0]
    return slope / find_compliance(normal), slope, normal


def measure_rings(run, frame, friction):
    """Radii of the sticking circle and of the contact, from second moments of mu n - q and of n on the upper nodes. Share of the friction that acts."""
    frames = run.frames
    nodes = frames.nodes_of_part(1)
    force, place = frames.node("contact_force", frame)[nodes], frames.points(0)[nodes]
    normal, side, square = np.abs(force[:, 2]), np.abs(force[:, 0]), place[:, 0]**2 + place[:, 1]**2
    left = np.where(normal > 0, friction * normal - side, 0)
    share = side.sum() / (friction * normal.sum())
    return np.sqrt(2.5 * max(0, left @ square) / left.sum()), np.sqrt(2.5 * (normal @ square) / normal.sum()), share


@case("partial_slip", "friction", "Friction: partial slip of two caps")
def partial_slip(bench):
    """Two like steel caps (R = 0.2 m, 200 GPa, 0.3) are pressed together with N and pushed sideways by T below mu N, mu =
    0.3. Slip begins at the rim of the contact (radius a) and leaves a circle of radius c that sticks (Cattaneo 1938;
    Mindlin, *J. Appl. Mech.* 16, 1949; Johnson, *Contact Mechanics*, section 7.2):

        way = 3 mu N (2 - nu) / (8 G a) [1 - (1 - T / (mu N))^(2/3)],      c / a = (1 - T / (mu N))^(1/3)

    The way is that of one body's far points against the other's; each moves half of it against the contact. The
    solution takes traction along the push alone. Like bodies do not couple normal and tangential motion.

    Half of each body is a block with a paraboloid as its end, six elements on the contact radius, five of the lower body
    in a last run, so that nodes do not match. Its far sides are
    held, or moved: 9.4 um inward, then sideways. Held sides at 8 a make the bodies stiffer, in proportion to a over their
    distance, by the same compliance with slip and without. It is measured with friction of 10, where all sticks, at 8
    and 16 a. The limit of half-spaces from both must be the formula's within 3 % (the mesh: a sixth of a is the ring of
    one element). The compliance of the bodies is then taken off the way. What slips must agree within 1 % of the
    largest way, and c / a within 0.03, a fifth of an element, as long as the circle has three elements on its radius (T up
    to 0.8 mu N). N may change by 0.1 %.

    Radii are those of second moments: of the nodal forces n, and of mu n - q, which is left of the friction. For
    Hertz's pressure and for Mindlin's traction each is sqrt(2/5) of its radius."""
    friction = 0.3
    near, far = (measure_compliance(bench, d) for d in (NEAR, 2 * NEAR))
    along = [find_radius(m[2]) / d for m, d in ((near, NEAR), (far, 2 * NEAR))]
    limit = (far[0] * along[0] - near[0] * along[1]) / (along[0] - along[1])
    bench.near("way over force without slip, half-spaces, over the formula", limit, 1.0, relative=0.03)

    curves, rings = [], {}
    for which, low in (("like meshes", 6), ("unlike meshes", 5)):
        run, normal, side = push_caps(bench, NEAR, friction, 1.2e-4, low)
        h, largest = run.history, 1.5 * friction * normal * find_compliance(normal)
        local = find_push(h["time"]) - (near[1] - find_compliance(normal)) * side
        share = np.minimum(side / (friction * normal), 1)
        exact = largest * (1 - (1 - share)**(2 / 3))
        judged = (share > 0.2) & (share < 0.95)
        bench.near(f"{which}: largest error of the way for T from 0.2 to 0.95 mu N, over the largest way",
                   float(np.abs(local - exact)[judged].max() / largest), 0, absolute=0.01)
        bench.near(f"{which}: largest T over mu N", float(side[h["time"] > 1.15e-4].mean() / (friction * normal)), 1.0,
                   relative=0.01)
        bench.near(f"{which}: largest change of N over N", float(np.abs(2 * h["fz:touch"][judged] / normal - 1).max()),
                   0, absolute=1e-3)
        measured = [measure_rings(run, frame, friction)
                    for frame in range(run.frames.count) if run.frames.times[frame] > EVEN]
        rings[which] = [ring for ring in measured if ring[2] < 0.95]
        bench.near(f"{which}: radius of contact", 1e3 * rings[which][0][1], 1e3 * find_radius(normal),
                   relative=0.02, unit="mm")
        for wanted in (0.3, 0.6, 0.8):
            stuck, touching, acts = min(rings[which], key=lambda ring: abs(ring[2] - wanted))
            bench.near(f"{which}: c / a where T is {acts:.2f} mu N", stuck / touching, (1 - acts)**(1 / 3),
                       absolute=0.03)
        bench.below(f"{which}: energy balance, largest error", h.largest("energy_error"), 1e-3)
        pushed = (h["time"] > START) & (share < 0.999)
        curves.append((which, 1e6 * local[pushed], share[pushed], 1e6 * exact[pushed]))
    bench.table(["sides held at", "way over force without slip, over the formula", "N [N]"],
                [[f"{1 / a:.1f} a", f"{m[0]:.4f}", f"{m[2]:.1f}"] for a, m in zip(along, (near, far))])

    def draw(axes):
        for (which, way, share, exact), mark in zip(curves, ".+"):
            axes.plot(*thin(way, share, 60), mark, label=which)
        axes.plot(exact, share, label="Mindlin", **plots.EXACT)
        axes.set(xlabel="way [um]", ylabel="T over mu N")
        axes.legend()

    bench.figure("Tangential force over the way of the bodies, without the compliance of their sides.", draw)

    def draw_rings(axes):
        acts = np.linspace(0, 1, 200)
        axes.plot(acts, (1 - acts)**(1 / 3), label="Mindlin", **plots.EXACT)
        for (which, found), mark in zip(rings.items(), "o+"):
            axes.plot([ring[2] for ring in found], [ring[0] / ring[1] for ring in found], mark, label=which)
        axes.set(xlabel="T over mu N", ylabel="c / a")
        axes.legend()

    bench.figure("Radius of the circle that sticks.", draw_rings)
