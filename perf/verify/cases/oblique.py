"""Balls that meet with friction: partial slip in the contact circle."""
import numpy as np

import meshes
import plots
from bench import case
from cases.balls import NU, RADIUS, STEEL, YOUNG, find_hertz

SHEAR = YOUNG / (2 * (1 + NU))


def spread_shear(radius, places, compliance=1.0):
    """Tangential displacement at the places (distances from the middle) under a shear stress sqrt(1 - r^2 / radius^2) on a circle of
    a half-space, the mean over directions (Johnson, Contact Mechanics, 3.7). compliance: (2 - nu) / G, summed over the bodies."""
    r = np.maximum(np.asarray(places, dtype=float), 1e-300)
    share = np.minimum(radius / r, 1)
    outside = (2 * radius**2 - r**2) * np.arcsin(share) + radius * r * np.sqrt(1 - share**2)
    return compliance / (8 * radius) * np.where(r < radius, np.pi / 2 * (2 * radius**2 - r**2), outside)


class SlippingCircle:
    """Shear stress in a contact circle that grows and shrinks, on rings of one width: each ring sticks or slips (Maw, Barber and
    Fawcett). Stress is a sum of sqrt(1 - r^2 / a_i^2) over the rings' outer radii a_i."""

    def __init__(self, rings, largest, compliance, friction):
        self.radii = largest * np.arange(1, rings + 1) / rings
        self.middles = self.radii - 0.5 * self.radii[0]
        self.stress = np.sqrt(np.maximum(0, 1 - (self.middles[:, None] / self.radii[None, :])**2))
        self.shift = np.stack([spread_shear(a, self.middles, compliance) for a in self.radii], axis=1)
        self.friction, self.displacement, self.force = friction, np.zeros(rings), 0.0

    def move(self, rings, normal, step):
        """The bodies move by a step across each other while so many rings touch under the normal force. Returns the force that holds them back."""
        if rings == 0:
            self.displacement, self.force = np.zeros_like(self.displacement), 0.0
            return 0.0
        limit = self.friction * 1.5 * normal / (np.pi * self.radii[rings - 1]**2) * self.stress[:rings, rings - 1]
        slips = np.zeros(rings)  # sign of the slip, 0 where the ring sticks
        for _ in range(60):
            rows = np.where(slips[:, None] == 0, self.shift[:rings, :rings], self.stress[:rings, :rings])
            shares = np.linalg.solve(rows, np.where(slips == 0, self.displacement[:rings] + step, slips * limit))
            stress, way = (self.stress[:rings, :rings] @ shares,
                           step - (self.shift[:rings, :rings] @ shares - self.displacement[:rings]))
            wanted = np.where(slips == 0, np.where(np.abs(stress) > limit * (1 + 1e-9), np.sign(stress), 0),
                              np.where(slips * way < 0, 0, slips))
            if np.array_equal(wanted, slips):
                break
            slips = wanted
        self.displacement = self.shift[:, :rings] @ shares
        self.force = float(2 / 3 * np.pi * np.sum(shares * self.radii[:rings]**2))
        return self.force


def follow_oblique_impact(masses, speeds, friction, rings=120):
    """Relative tangential speed after the impact of two like bodies. masses: that of the relative motion along the normal and across;
    speeds: likewise before. The normal force is that of Hertz for two balls."""
    from scipy.integrate import solve_ivp
    modulus, curvature = 0.5 * YOUNG / (1 - NU**2), RADIUS / 2
    depth, _, time = find_hertz(modulus, curvature, masses[0], speeds[0])
    k = 4 / 3 * modulus * np.sqrt(curvature)
    half = solve_ivp(lambda _, y: [y[1], -k * max(y[0], 0)**1.5 / masses[0]], (0, time / 2), [0, speeds[0]], rtol=1e-10,
                     atol=1e-16, dense_output=True).sol
    circle = SlippingCircle(rings, np.sqrt(curvature * depth), 2 * (2 - NU) / SHEAR, friction)
    grid = np.linspace(0, time / 2, 40001)
    reached = np.interp(circle.radii[:-1]**2 / curvature, half(grid)[0], grid)  # when the circle grows to each ring
    times = np.concatenate([[0], reached, [time / 2], time - reached[::-1], [time]])
    count = np.concatenate([np.arange(rings + 1), np.arange(rings - 1, -1, -1)])
    rate, forces = speeds[1], []
    for n in range(1, len(times)):
        span = times[n] - times[n - 1]
        normal = k * (circle.radii[count[n] - 1]**2 / curvature)**1.5 if count[n] else 0.0
        before = circle.force
        guess = rate - before * span / masses[1] / 2
        force = circle.move(count[n], normal, span * guess)
        rate -= 0.5 * span * (before + force) / masses[1]
        forces.append((times[n], force, normal))
    return rate, np.array(forces)


def half_ball(bench, across, share):
    """A half (y >= 0) of a ball, its cells drawn together at the lowest point, as a file."""
    points, corners = meshes.keep(*meshes.generate(bench,
                                                   f"sphere: {{radius: 1, cells: {across}}}"), lambda x, y, z: y > 0)
    points = RADIUS * meshes.draw_together(points, share)
    points[np.abs(points) < 1e-12 * RADIUS] = 0
    return meshes.write_exodus(bench.file(f"half_{across}.exo"), points, corners)


OBLIQUE = """
title: Two balls meet at an angle
time: {end: $end}
parts:
  low: {exodus: {file: $low}, rotate: [{axis: x, angle: 180}, {axis: z, angle: 180}], at: [0, 0, -0.0100001], material: steel}
  high: {exodus: {file: $high}, at: [0, 0, 0.0100001], material: steel}
initial: [{part: high, velocity: [$across, 0, $down]}, {part: low, velocity: [$back, 0, $up]}]
conditions:
  - {nodes: {inside: [[-1, -1e-9, -1], [1, 1e-9, 1]]}, symmetry: y}
contact: {surfaces: [[low, high]], friction: $friction$enforcement}
output: {fields: {every: $end, write: [velocity, mass]}, history: {every: 2e-7}}
""" + STEEL


def find_rigid_motion(frames, frame, part):
    """Mass, inertia about y, place of the centre, its velocity and the spin about y of a whole ball, of which a half is there."""
    nodes = frames.nodes_of_part(part)
    mass, points, velocity = (2 * frames.node("mass", 0)[nodes], frames.points(frame)[nodes],
                              frames.node("velocity", frame)[nodes])
    total = mass.sum()
    center, mean = (mass @ points) / total, (mass @ velocity) / total
    arm, rate = points - center, velocity - mean
    inertia = float(mass @ (arm[:, 0]**2 + arm[:, 2]**2))
    return (float(total), inertia, center, mean,
            float(mass @ (arm[:, 2] * rate[:, 0] - arm[:, 0] * rate[:, 2])) / inertia)


def measure_oblique_impact(frames):
    """Masses of the relative motion along and across, relative speeds before and after, at the point where the balls touch."""
    start = [find_rigid_motion(frames, 0, p) for p in (0, 1)]
    end = [find_rigid_motion(frames, -1, p) for p in (0, 1)]
    arms = [-body[2][2] for body in start]
    slip = [[body[3][0] + body[4] * arm for body, arm in zip(bodies, arms)] for bodies in (start, end)]
    masses = (1 / sum(1 / body[0] for body in start),
              1 / sum(1 / body[0] + arm**2 / body[1] for body, arm in zip(start, arms)))
    normal = [bodies[0][3][2] - bodies[1][3][2] for bodies in (start, end)]
    return masses, normal, [pair[0] - pair[1] for pair in slip]


@case("maw_impact", "friction", "Friction: oblique impact of two balls")
def maw_impact(bench):
    """Two like steel balls meet with a speed along the normal (3 m/s) and one across. Maw, Barber and Fawcett (*Wear* 38,
    1976) found how the points of contact rebound: while Hertz's circle grows and shrinks, its middle sticks and its rim
    slips, and the tangential spring of the circle may throw the balls back. In the units psi = 2 (1 - nu) / (mu (2 -
    nu)) V / v_n (V: speed of the points of contact across each other) and for nu = 0.3, the circle of whole balls sticks
    at first if psi < 1, and slips throughout if psi > 4.76: then 5.76 is taken off. The answer in between is their
    method, with 120 rings; 240 rings change psi by 0.007 at most.

    Halves of the balls are meshed, with 5 elements across the largest radius of contact (0.5 mm). Large facets at
    their far sides cut off much: masses and inertias in the answer are those of the meshes, as in `hertz_balls`. The
    tangential motion takes part with 1 / (1 / m + R^2 / I) of a ball, R the height of its centre; less than 5.76 is
    taken off then. Half-spaces are the limit of a small circle: the body of a ball, whose radius is 20 times that of the
    circle, yields besides, and vibration takes 1 % of the speed across at full slip (the impulse of friction is mu times
    that along the normal). The tolerance is 0.1, 2 % of the impulse of friction that slips throughout."""
    scale = 2 * (1 - NU) / (2 - NU)
    friction, speed, meshed, curves = 0.2, 3.0, [], []
    for across in (12,) if bench.quick else (16,):
        path, rows, before = half_ball(bench, across, 0.85), [], bench.cpu
        for psi in (1.0, 4.0) if bench.quick else (0.5, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0):
            slide = psi * friction * speed / scale
            run = bench.run(OBLIQUE, low=path, high=path, end=5.5e-5, across=-0.5 * slide, back=0.5 * slide,
                            down=-0.5 * speed, up=0.5 * speed, friction=friction, enforcement="")
            masses, normal, slip = measure_oblique_impact(run.frames)
            after, _ = follow_oblique_impact(masses, (speed, slip[0]), friction)
            to_psi = scale / (friction * speed)
            rows.append((slip[0] * to_psi, after * to_psi, slip[1] * to_psi, -normal[1] / normal[0],
                         run.history.largest("energy_error")))
        meshed.append((across, run.summary["elements"], max(abs(row[2] - row[1]) for row in rows), bench.cpu - before))
        curves.append((across, rows, masses))
    for row in rows:
        bench.near(f"psi after the impact, {row[0]:.2f} before", row[2], row[1], absolute=0.1)
    bench.above("restitution along the normal, least", min(row[3] for row in rows), 0.98)
    bench.below("energy balance, largest error", max(row[4] for row in rows), 1e-3)
    bench.table(["psi before", "after, exact", "after, measured", "difference", "restitution along the normal"],
                [[f"{a:.3f}", f"{b:.3f}", f"{c:.3f}", f"{c - b:+.3f}", f"{d:.4f}"] for a, b, c, d, _ in rows])
    bench.table(["elements across", "elements", "largest error of psi", "time of all impacts [s]"],
                [[n, e, f"{error:.3f}", f"{seconds:.1f}"] for n, e, error, seconds in meshed])

    def draw(axes):
        before = np.linspace(0.2, 6.5, 22)
        for across, rows, masses in curves:
            after = [follow_oblique_impact(masses, (speed, x / to_psi), friction, 60)[0] * to_psi for x in before]
            axes.plot(before, after, **plots.EXACT)
            axes.plot([row[0] for row in rows], [row[2] for row in rows], "o", label=f"{across} elements across")
        axes.set(xlabel="psi before the impact", ylabel="psi after")
        axes.legend()

    bench.figure("Speed of the points of contact across each other, before and after; "
                 "dashed: Maw, Barber and Fawcett with the masses of the mesh.", draw)
