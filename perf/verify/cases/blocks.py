"""Rigid blocks that rock, roll, topple and stand, against the laws of rigid bodies."""
import numpy as np

import plots
from bench import case, thin

G = 9.81


def integrate(motion, start, stop):
    """Path of an equation of motion until stop(t, y) rises through zero; (times, states)."""
    from scipy.integrate import solve_ivp
    stop.terminal, stop.direction = True, 1
    path = solve_ivp(motion, (0, 100), start, events=stop, rtol=1e-10, atol=1e-12, max_step=0.01)
    return path.t, path.y


def follow_rocking(alpha, radius, start, impacts):
    """Angle over time of a rocking block from rest at an angle, after Housner; times of the impacts, amplitudes after them."""
    kappa = 3 * G / (4 * radius)  # m g R / I about a corner
    ratio = 1 - 1.5 * np.sin(alpha)**2  # of the angular velocities across an impact
    times, angles, hits, peaks, angle, rate, now, side = [], [], [], [], start, 0.0, 0.0, 1
    for _ in range(impacts + 1):
        t, y = integrate(lambda _, s: [s[1], -kappa * np.sin(alpha - s[0])],
                         [angle, rate], lambda t, s: -s[0] if t > 0 else -1)
        times.append(now + t)
        angles.append(side * y[0])
        peaks.append(float(np.max(y[0])))
        now += t[-1]
        hits.append(now)
        angle, rate, side = 0.0, -ratio * y[1][-1], -side
    return np.concatenate(times), np.concatenate(angles), hits, peaks


def turn_box(mass, size, angle=0.0):
    """Inertia of a box, turned about y, as a deck takes it."""
    x, y, z = size
    c, s = np.cos(angle), np.sin(angle)
    turn = np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
    tensor = turn @ np.diag([y * y + z * z, x * x + z * z, x * x + y * y]) @ turn.T * mass / 12
    return "[" + ", ".join(repr(float(tensor[k])) for k in ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0))) + "]"


@case("rocking_block", "rigid", "Rocking of a rigid block", quick=True)
def rocking_block(bench):
    """A rigid block of 0.2 x 0.6 m, tilted by 8 of the 18.4 degrees at which it would fall, is let go on a floor that
    it cannot slide on. It turns about one corner until it stands, and goes on about the other. Housner (*Bull. Seism.
    Soc. Am.* 53, 1963): angular momentum about the new corner is kept, so that an impact multiplies the angular
    velocity by 1 - 3/2 sin^2 a = 0.85, a the angle of the diagonal. Between impacts it is a pendulum upside down,
    integrated here to 1e-10. Judged are the times of the impacts and the largest angles between them. Contact acts
    within a step of 2e-4 s, in which an angular velocity changes by g dt / R, 0.1 to 0.5 % of those at the impacts;
    hence 0.5 % for times and 2 % for angles, whose errors of four impacts add up and go with the square of the
    velocity."""
    alpha, radius, start = np.arctan2(0.1, 0.3), np.hypot(0.1, 0.3), np.radians(8)
    h = bench.run("""
title: A block rocks
time: {end: 2.5, max_step: 2e-4}
parts: {block: {box: {size: [0.2, 0.4, 0.6], cells: [1, 1, 1]}, rotate: [{axis: y, angle: 8, center: [0.2, 0, 0]}], material: m, rigid: {mass: 48, inertia: $inertia}}}
materials: {m: {model: elastic, density: 1000, youngs_modulus: 1e7, poissons_ratio: 0.3}}
loads: {gravity: [0, 0, -9.81]}
walls: [{normal: z, friction: 10}]
contact: {surfaces: none}
output: {history: {every: 1e-3, nodes: [{name: left, near: [0, 0, 0]}, {name: right, near: [0.2, 0, 0]}]}}
""", inertia=turn_box(48.0, (0.2, 0.4, 0.6), start)).history
    tilt = np.arctan2(h["left_z"] - h["right_z"], h["right_x"] - h["left_x"])
    times, angles, hits, peaks = follow_rocking(alpha, radius, start, 4)
    i = np.flatnonzero(np.sign(tilt[1:]) != np.sign(tilt[:-1]))[:4]
    found = h["time"][i] - tilt[i] * (h["time"][i + 1] - h["time"][i]) / (tilt[i + 1] - tilt[i])
    for n in range(4):
        bench.near(f"time of impact {n + 1}", float(found[n]), hits[n], relative=0.005, unit="s")
        if n:
            swing = abs(tilt[(h["time"] > found[n - 1]) & (h["time"] < found[n])]).max()
            bench.near(f"largest angle after impact {n}", float(np.degrees(swing)), float(np.degrees(peaks[n])),
                       relative=0.02, unit="degrees")

    def draw(axes):
        axes.plot(times, np.degrees(angles), label="Housner", **plots.EXACT)
        axes.plot(*thin(h["time"], np.degrees(tilt)), label="percuss")
        axes.set(xlabel="time [s]", ylabel="angle [degrees]", xlim=(0, 2.5))
        axes.legend()

    bench.figure("The rocking block.", draw)


def follow_wheel(sides, inertia, slope, start, steps):
    """Times of the impacts of a prism (radius 1, mass 1) that rolls down from face to face, and angular velocities after them."""
    about_corner, half = inertia + 1, np.pi / sides
    ratio = (inertia + np.cos(2 * half)) / about_corner
    now, rate, times, rates = 0.0, start, [], []
    for _ in range(steps):
        t, y = integrate(lambda _, s: [s[1], G / about_corner * np.sin(s[0] + slope)],
                         [-half, rate], lambda _, s: s[0] - half)
        now, rate = now + t[-1], ratio * y[1][-1]
        times.append(now)
        rates.append(rate)
    return np.array(times), np.array(rates)


@case("rolling_prism", "rigid", "Rolling of a twelve-sided prism", quick=True)
def rolling_prism(bench):
    """A rigid prism of twelve sides rolls down a slope of 6 degrees on which it cannot slide. It turns about one edge
    until the next one strikes. Angular momentum about that edge is kept: with I = m R^2 / 2 the angular velocity
    becomes (I + m R^2 cos 30) / (I + m R^2) = 0.911 of what it was (the wheel without a rim: McGeer, *Int. J.
    Robotics Res.* 9, 1990). Weight brings back what the impacts take, and the prism comes to roll at a steady speed.
    Between impacts it is a pendulum upside down, integrated to 1e-10. Judged are the times of impacts 1, 5, 10 and
    15, and the angular velocity after the last of them. An impact falls within a step of 2e-4 s, of which a face
    takes 1300: 0.5 % for times and 1 % for the velocity."""
    sides, inertia, slope, start = 12, 0.5, np.radians(6), 1.0
    apothem = float(np.cos(np.pi / sides))
    h = bench.run("""
title: A prism rolls down
time: {end: 6, max_step: 2e-4}
parts: {wheel: {tube: {inner_radius: 0.5, outer_radius: 1, length: 0.5, cells: [1, 12, 1]}, axis: y, rotate: [{axis: y, angle: 15}], at: [0, 0, $apothem], material: m, rigid: {mass: 1, center: [0, 0.25, $apothem], inertia: [0.4, 0.5, 0.4, 0, 0, 0]}}}
materials: {m: {model: elastic, density: 1000, youngs_modulus: 1e7, poissons_ratio: 0.3}}
initial: [{part: wheel, angular_velocity: [0, 1, 0], center: [$lead, 0, 0]}]
loads: {gravity: [$gx, 0, $gz]}
walls: [{normal: z, friction: 10}]
contact: {surfaces: none}
output: {history: {every: 1e-3, nodes: [{name: n, near: [$lead, 0, 0]}]}}
""", apothem=apothem, lead=float(np.sin(np.pi / sides)), gx=float(G * np.sin(slope)), gz=float(-G * np.cos(slope))).history
    times, rates = follow_wheel(sides, inertia, slope, start, 18)
    spin = h["body_wy:wheel"]
    jumps = np.flatnonzero(spin[1:] < 0.96 * spin[:-1]) + 1  # a row after an impact
    jumps = jumps[np.concatenate([[True], np.diff(jumps) > 5])]
    found = h["time"][jumps] - 5e-4
    for n in (1, 5, 10, 15):
        bench.near(f"time of impact {n}", float(found[n - 1]), float(times[n - 1]), relative=0.005, unit="s")
    bench.near("angular velocity after impact 15", float(spin[jumps[14] + 1]), float(rates[14]), relative=0.01,
               unit="rad/s")
    ratio = (inertia + np.cos(2 * np.pi / sides)) / (inertia + 1)
    gain = 4 * G * np.sin(np.pi / sides) * np.sin(slope) / (inertia + 1)
    bench.note(f"In the end it would be {np.sqrt(ratio**2 / (1 - ratio**2) * gain):.4f} rad/s.")

    def draw(axes):
        axes.plot(*thin(h["time"], spin), label="percuss")
        axes.plot(times, rates, "o", color="black", markersize=3, label="exact, after the impacts")
        axes.set(xlabel="time [s]", ylabel="angular velocity [rad/s]")
        axes.legend()

    bench.figure("The prism comes to roll at a steady speed.", draw)


def lean(angle, pitch, height, depth):
    """Angle of a domino that leans on one that has turned by an angle, and how it grows with that."""
    sine = (pitch * np.cos(angle) - depth) / height
    return angle + np.arcsin(sine), 1 - pitch * np.sin(angle) / height / np.sqrt(1 - sine**2)


def follow_dominoes(count, pitch, height, depth, start):
    """Times at which each domino but the first is struck, after van Leeuwen, without friction between them: a fallen row has
    one degree of freedom, the angle of its head; an impact keeps the momentum along it."""
    about_edge = (height**2 + depth**2) / 3  # inertia over mass

    def sum_up(angle, members):
        """Angles and their growths, of the head and of those that lean on it."""
        growth, pairs = 1.0, [(angle, 1.0)]
        for _ in range(members - 1):
            angle, of_next = lean(angle, pitch, height, depth)
            growth *= of_next
            pairs.append((angle, growth))
        return pairs

    def energy(angle, members):
        return sum(G / 2 * (height * np.cos(a) + depth * np.sin(a)) for a, _ in sum_up(angle, members))

    struck = np.arcsin((pitch - depth) / height)
    rate, now, times = start, 0.0, []
    for members in range(1, count):
        mesh = struck * (1 - np.cos(np.linspace(0, np.pi, 400))) / 2
        inertia = np.array([about_edge * sum(g**2 for _, g in sum_up(a, members)) for a in mesh])
        height_lost = energy(0.0, members) - np.array([energy(a, members) for a in mesh])
        speed = np.sqrt((inertia[0] * rate**2 + 2 * height_lost) / inertia)
        now += float(np.trapz(1 / speed, mesh))
        times.append(now)
        momentum = sum(g**2 for _, g in sum_up(struck, members)) * lean(0.0, pitch, height, depth)[1]
        total = sum(g**2 for _, g in sum_up(0.0, members + 1))
        rate = momentum * speed[-1] / total
    return np.array(times)


@case("dominoes", "rigid", "Successive toppling of a row of blocks")
def dominoes(bench):
    """Twelve rigid dominoes, 48 mm high and 7.5 mm thick, stand 24 mm apart. They cannot slide on the floor, and
    there is no friction between them. Each one falls against the next and leans on it from then on. Van Leeuwen (*Am.
    J. Phys.* 78, 2010): the row that has fallen has one degree of freedom, the angle of its head, since the upper
    edge of each slides down the face of the next. Its energy is kept between impacts, and an impact keeps the
    momentum along it. The front comes to run at a steady speed. Judged are the times at which the fifth, ninth and
    last one are struck and the speed over the last four. A step is 4e-5 s, 1/500 of the time from one to the next: 1
    %."""
    count, pitch, height, depth, start = 12, 0.024, 0.048, 0.0075, 6.0
    width = 0.024
    inertia = turn_box(1.0, (depth, width, height))
    parts = "\n".join(f"  d{n}: {{box: {{size: [{depth}, {width}, {height}], cells: [1, 2, 1]}}, at: [{pitch * n!r}, "
                      f"0, 0], material: m, rigid: {{mass: 1, inertia: {inertia}}}}}"
                      for n in range(count))
    nodes = ", ".join(f"{{name: d{n}, part: d{n}, near: [{pitch * n!r}, 0, {height}]}}" for n in range(count))
    exact = follow_dominoes(count, pitch, height, depth, start)
    h = bench.run("""
title: Dominoes
time: {end: $end, max_step: 4e-5}
parts:
$parts
materials: {m: {model: elastic, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0.3}}
initial: [{part: d0, angular_velocity: [0, $start, 0], center: [$depth, 0, 0]}]
loads: {gravity: [0, 0, -9.81]}
walls: [{normal: z, friction: 10}]
contact: {surfaces: all}
output: {history: {every: 2e-4, nodes: [$nodes]}}
""", end=float(1.03 * exact[-1]), parts=parts, nodes=nodes, start=start, depth=depth).history
    found = []
    for n in range(1, count):
        turned = (h[f"d{n}_x"] - pitch * n) / height
        start = np.argmax(turned > 1e-3)
        found.append(float(np.interp(1e-3, turned[start - 1:start + 1], h["time"][start - 1:start + 1]))
                     if turned.max() > 1e-3 else float("nan"))
    found = np.array(found)
    for n in (4, 8, 11):
        bench.near(f"time at which domino {n + 1} is struck", found[n - 1], float(exact[n - 1]),
                   relative=0.01, unit="s")
    speed, wanted = (float(4 * pitch / (t[-1] - t[-5])) for t in (found, exact))
    bench.near("speed of the front over the last four", speed, wanted, relative=0.01, unit="m/s")
    bench.note(f"That is {speed / np.sqrt(G * height):.3f} of sqrt(g H).")
    bench.below("energy balance, largest error", h.largest("energy_error"), 1e-3)

    def draw(axes):
        number = np.arange(1, count)
        axes.plot(exact, number, label="van Leeuwen", **plots.EXACT)
        axes.plot(found, number, "o", markersize=3, label="percuss")
        axes.set(xlabel="time [s]", ylabel="dominoes struck")
        axes.legend()

    bench.figure("The front runs along the row.", draw)


def stands(blocks, thickness):
    """Whether forces on the corners of the joints can carry a half circle of blocks of mean radius 1 (no tension, no sliding)."""
    from scipy.optimize import linprog
    mass, center = shape_block(blocks, thickness)
    matrix, weight = [], []
    for block in range(blocks):
        angle = np.pi * (block + 0.5) / blocks
        middle = center * np.array([np.cos(angle), np.sin(angle)])
        rows = np.zeros((3, 3 * (blocks + 1)))
        for joint, sign in ((block, 1), (block + 1, -1)):
            a = np.pi * joint / blocks
            outward, along = np.array([np.cos(a), np.sin(a)]), np.array([-np.sin(a), np.cos(a)])
            for k, (radius, force) in enumerate(((1 - thickness / 2, along), (1 + thickness / 2, along), (1, outward))):
                arm = radius * outward - middle
                rows[:, 3 * joint + k] = sign * np.array([force[0], force[1], arm[0] * force[1] - arm[1] * force[0]])
        matrix.extend(rows)
        weight.extend([0, mass, 0])
    bounds = [(0, None), (0, None), (None, None)] * (blocks + 1)
    return linprog(np.zeros(3 * (blocks + 1)), A_eq=np.array(matrix), b_eq=weight, bounds=bounds).status == 0


def shape_block(blocks, thickness):
    """Area of a block, a trapezoid, and how far its centre is from that of the arch."""
    half = np.pi / blocks / 2
    low, high = (1 - thickness / 2) * np.cos(half), (1 + thickness / 2) * np.cos(half)
    area = np.tan(half) * (high**2 - low**2)
    return float(area), float(2 / 3 * np.tan(half) * (high**3 - low**3) / area)


def find_least_thickness(blocks):
    low, high = 0.05, 0.2
    while high - low > 1e-5:
        middle = (low + high) / 2
        low, high = (low, middle) if stands(blocks, middle) else (middle, high)
    return high


def write_arch(blocks, thickness, end, depth=0.3):
    """Every other block is less deep, so that nodes of one joint are not all on edges of the other side."""
    area, center = shape_block(blocks, thickness)
    parts = []
    for n in range(blocks):
        turn, angle = 180.0 * (n + 1) / blocks, np.pi * (n + 0.5) / blocks
        y = depth if n % 2 else 0.8 * depth
        place = [float(center * np.cos(angle)), 0.0, float(center * np.sin(angle))]
        parts.append(f"  b{n}: {{tube: {{inner_radius: {1 - thickness / 2!r}, outer_radius: {1 + thickness / 2!r}, "
                     f"length: {y!r}, cells: [1, 3, 1], arc: {180.0 / blocks!r}}}, axis: y, rotate: [{{axis: y, "
                     f"angle: {-turn!r}}}], at: [0, {-y / 2!r}, 0], material: m, "
                     f"rigid: {{mass: {1000 * area * depth!r}, center: {place}}}}}")
    return f"""
title: An arch of {blocks} blocks
time: {{end: {end}, max_step: 5e-4}}
parts:
""" + "\n".join(parts) + """
materials: {m: {model: elastic, density: 1000, youngs_modulus: 1e9, poissons_ratio: 0.2}}
loads: {gravity: [0, 0, -9.81]}
walls: [{normal: z, friction: 1}]
contact: {surfaces: all, friction: 1$enforcement}
output: {history: {every: 1e-2, nodes: [{name: crown, near: [0, 0, 1]}]}}
"""


@case("arch", "rigid", "Stability of a semicircular arch of blocks")
def arch(bench):
    """A half circle of sixteen rigid blocks stands between walls of friction 1, without tension in its joints.
    Milankovitch (1907) and Heyman (*Int. J. Mech. Sci.* 11, 1969) found the least thickness at which a line of thrust
    finds room in it: 0.1075 of the mean radius for many blocks. For sixteen a linear programme of the forces on the
    corners of the joints gives 0.10708. An arch 5 % thicker must stand. One 5 % thinner must fall: hinges open at the
    crown, the haunches and the springings. Standing is a crown that sinks by less than 1e-4 of the radius in 0.5 s,
    in which it would fall by 1.2 free."""
    least = find_least_thickness(16)
    bench.near("least thickness of sixteen blocks over the mean radius", least, 0.1075, relative=0.01)
    curves = []
    for name, share in (("5 % thicker", 1.05), ("5 % thinner", 0.95)):
        run = bench.run(write_arch(16, share * least, 0.5), enforcement="")
        h = run.history
        sunk = h["crown_z"][0] - h["crown_z"]
        if share > 1:
            bench.below(f"{name}: the crown sinks, over the radius", float(np.abs(sunk).max()), 1e-4)
        else:
            bench.above(f"{name}: the crown sinks, over the radius", float(sunk[-1]), 1e-2)
        curves.append((name, h["time"], sunk))

    def draw(axes):
        for name, times, sunk in curves:
            axes.plot(times, np.maximum(np.abs(sunk), 1e-9), label=name)
        axes.set(xlabel="time [s]", ylabel="way of the crown over the radius", yscale="log")
        axes.legend()

    bench.figure("The crowns of two arches.", draw)
