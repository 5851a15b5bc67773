"""Waves that a surface guides: the speed of the first mode of a cylinder and of Rayleigh's wave."""
import numpy as np

import meshes
import plots
from bench import case, thin

NU_BAR, NU_HALF_SPACE = 0.3, 0.25


def find_pochhammer_chree(frequency, nu, radius=1.0):
    """Phase speed over sqrt(E / rho) of the first longitudinal mode of a cylinder: the root of Pochhammer's equation that
    continues c = 1 from low frequencies on. frequency in rad per radius over sqrt(E / rho), ascending."""
    from scipy.optimize import brentq
    from scipy.special import jv

    shear = np.sqrt(1 / (2 * (1 + nu)))
    pressure = np.sqrt((1 - nu) / ((1 + nu) * (1 - 2 * nu)))

    def residual(speed, w):
        k = w / speed
        p, q = np.sqrt(complex((w / pressure)**2 - k**2)), np.sqrt(complex((w / shear)**2 - k**2))
        value = (2 * p / radius * (q**2 + k**2) * jv(1, p * radius) * jv(1, q * radius)
                 - (q**2 - k**2)**2 * jv(0, p * radius) * jv(1, q * radius)
                 - 4 * k**2 * p * q * jv(1, p * radius) * jv(0, q * radius))
        return (value / q).real  # q is real below; p is imaginary, and the whole is even in it

    speeds, guess = [], 1 - 1e-9
    for w in np.linspace(0.02, frequency[-1], 200):
        trial = guess
        while residual(trial, w) * residual(guess + 1e-7, w) > 0:
            trial -= 5e-4
        guess = brentq(residual, trial, min(guess + 1e-7, 1 - 1e-12), args=(w,), xtol=1e-13) if trial < guess else guess
        speeds.append((w, guess))
    speeds = np.array(speeds)
    return np.interp(frequency, speeds[:, 0], speeds[:, 1])


def find_spectrum(times, values, frequencies):
    """Fourier integrals of a signal that begins and ends at rest."""
    return np.array([np.trapz(values * np.exp(1j * w * times), times) for w in frequencies])


def find_velocity_spectrum(history, name, frequencies, middle=None, half=None):
    """Of a column of places; with a middle and half a width only what passes then, under a window that falls off smoothly."""
    t = np.linspace(0, history["time"][-1], 4000)
    velocity = np.gradient(np.interp(t, history["time"], history[name]), t)
    if half:
        velocity = velocity * np.where(abs(t - middle) < half, np.cos(0.5 * np.pi * (t - middle) / half)**2, 0)
    return find_spectrum(t, velocity, frequencies)


def find_phase_speed(spectra, distance, frequencies, speed_guess=1.0):
    """From the phases at two places; the frequencies ascend in small steps from one at which the guess gives the phase within half a turn."""
    phase = np.unwrap(np.angle(spectra[1] / spectra[0]))
    phase -= 2 * np.pi * np.round(phase[0] / (2 * np.pi) - frequencies[0] * distance / speed_guess / (2 * np.pi))
    return frequencies * distance / phase


BAR = """
title: A pulse goes along a cylinder
time: {end: $end}
parts: {bar: {exodus: {file: $mesh}, material: m}}
materials: {m: {model: elastic, density: 1, youngs_modulus: 1, poissons_ratio: 0.3}}
elements: {bulk_viscosity: {linear: 0, quadratic: 0}}
conditions:
  - {nodes: {name: bar, inside: [[0, -9, -9], [0, 9, 999]]}, symmetry: x}
  - {nodes: {name: bar, inside: [[-9, 0, -9], [9, 0, 999]]}, symmetry: y}
loads: {nodal: [
$push
]}
output: {history: {every: 0, nodes: [{name: near, near: [0, 0, $near]}, {name: far, near: [0, 0, $far]}]}}
"""


def push_end(points, corners, pulse):
    """Loads of a uniform pressure on the end z = 0: a force on each node by its share of the area."""
    faces = corners[:, :4]
    a, b, c, d = (points[faces[:, i]] for i in range(4))
    area = 0.5 * np.linalg.norm(np.cross(c - a, d - b), axis=1)
    ends = np.all(np.abs(points[faces][:, :, 2]) < 1e-9, axis=1)
    share = np.zeros(len(points))
    np.add.at(share, faces[ends].ravel(), np.repeat(area[ends] / 4, 4))
    lines = []
    for n in np.flatnonzero(share):
        place = ", ".join(repr(float(x)) for x in points[n])
        lines.append(f'  {{nodes: {{inside: [[{place}], [{place}]]}}, '
                     f'force: {{z: {{expression: "{share[n]!r} * {pulse}"}}}}}}')
    return ",\n".join(lines)


@case("hopkinson_bar", "waves", "Dispersion in a Hopkinson bar")
def hopkinson_bar(bench):
    """A short pulse of pressure on the end of a cylinder spreads, because short waves are slower than sqrt(E / rho):
    lateral inertia holds them back. Pochhammer (1876) and Chree (1889) solved the equations of elasticity for the
    cylinder exactly. The first root of their equation (Bancroft, *Phys. Rev.* 59, 1941) is the answer for Poisson's
    ratio 0.3.

    The phase speed comes from the phases of the axial velocity on the axis, 12 and 20 radii from the end, in a bar of
    62 radii, so long that nothing comes back in time. The pulse excites waves down to two radii long, below the
    frequency of the second mode. A wave of wave number k is slowed by (k h)^2 / 24 on linear elements with lumped
    mass, the most where the step gives nothing back: by 0.15 % at most with 24 elements across. Lumped masses lie
    farther out and add to lateral inertia, h^2 / 1.5 of its share. The tolerance is 0.25 % for waves of 5 radii and
    more, 0.5 % for shorter ones."""
    listed = np.array([0.4, 0.8, 1.2, 1.6, 1.8])
    frequencies = np.linspace(0.05, 1.8, 176)
    exact, curves, errors = find_pochhammer_chree(frequencies, NU_BAR), [], []
    for across in (12, 16) if bench.quick else (16, 24):
        along = round(62 * across / 2)
        points, corners = meshes.quarter_cylinder(bench, 1.0, 62.0, across, along)
        path = meshes.write_exodus(bench.file(f"bar_{across}.exo"), points, corners)
        h = bench.run(BAR, end=95.0, mesh=path, near=12.0, far=20.0,
                      push=push_end(points, corners, "1e-4 * (t - 9) * exp(-(t - 9)^2 / 5.78)")).history
        speed = find_phase_speed([find_velocity_spectrum(h, name, frequencies) for name in ("near_z", "far_z")], 8.0,
                                 frequencies)
        curves.append((f"{across} elements across", speed))
        errors.append(np.interp(listed, frequencies, speed / exact - 1))
    for w, error in zip(listed, errors[-1]):
        c = float(np.interp(w, frequencies, exact))
        bench.near(f"speed of waves of {2 * np.pi * c / w:.1f} radii over sqrt(E / rho)", c * (1 + float(error)), c,
                   relative=0.0025 if w < 1.4 else 0.005)
    bench.table(["length over radius", "exact", *(f"error, {name}" for name, _ in curves)],
                [[f"{2 * np.pi * np.interp(w, frequencies, exact) / w:.2f}", f"{np.interp(w, frequencies, exact):.5f}",
                  *(f"{100 * e[i]:+.3f} %" for e in errors)] for i, w in enumerate(listed)])

    def draw(axes):
        ratio = frequencies / exact / (2 * np.pi)
        axes.plot(ratio, exact, label="Pochhammer and Chree", **plots.EXACT)
        for name, speed in curves:
            axes.plot(*thin(ratio, speed, 100), label=name)
        axes.set(xlabel="radius over wave length", ylabel="phase speed over sqrt(E / rho)", ylim=(0.7, 1.02))
        axes.legend()

    bench.figure("Phase speed in the bar.", draw)


HALF_SPACE = """
title: A line load strikes a half-space
time: {end: $end}
parts: {earth: {box: {size: [$length, $depth, $cell], cells: [$along, $down, 1]}, at: [0, $bottom, 0], material: m}}
materials: {m: {model: elastic, density: 1, youngs_modulus: 2.5, poissons_ratio: 0.25}}
elements: {bulk_viscosity: {linear: 0, quadratic: 0}}
conditions:
  - {nodes: all, fixed: [z]}
  - {nodes: earth/x_min, symmetry: x}
  - {nodes: earth/y_min, fixed: [y]}
loads: {nodal: [{nodes: {inside: [[0, 0, -9], [0, 0, 9]]}, force: {y: {expression: "-1e-4 * $cell * (1 - 2 * (pi * (t - 1.5))^2) * exp(-(pi * (t - 1.5))^2)"}}}]}
output: {history: {every: 0, nodes: [{name: near, near: [$near, 0, 0]}, {name: far, near: [$far, 0, 0]}]}}
"""


@case("rayleigh_wave", "waves", "Rayleigh's wave on a half-space")
def rayleigh_wave(bench):
    """A line load strikes a half-space (plane strain, Poisson's ratio 0.25, shear speed 1). Far away Rayleigh's wave
    is left on the surface. It keeps its shape, and its speed is the root of Rayleigh's equation, 0.91940 shear
    speeds. Nodes on the surface move on ellipses whose axes, along the surface over normal to it, are as 0.68125.

    Phases of the normal velocity 7 and 11 wave lengths away give the speed, and amplitudes the axes of the ellipse,
    at the frequency 1 of the load's pulse. Body waves run ahead and fade as the distance to the power 3/2; a window
    of 3 periods leaves them out. Linear elements are 20 to a wave length; a wave along their rows is slowed by (k
    h)^2 / 24 = 0.4 %. The tolerance is 0.5 % for the speed and 1 % for the ellipse, to which the decay with depth
    adds its error. The error must fall with the size."""
    speed = float(np.sqrt(2 - 2 / np.sqrt(3)))  # the root for nu = 1/4
    p, q = np.sqrt(1 - speed**2 / 3), np.sqrt(1 - speed**2)
    ratio = float(abs((1 - 2 * p * q / (1 + q**2)) / (p - 2 * p / (1 + q**2))))
    near, far = 7 * speed, 11 * speed
    frequencies = 2 * np.pi * np.linspace(0.5, 1.5, 101)
    rows = []
    for a_wave in (14, 20) if bench.quick else (14, 20):
        along, down = round(16 / speed * a_wave), round(12 / speed * a_wave)
        cell = near / (7 * a_wave)
        h = bench.run(HALF_SPACE, end=14.5, cell=cell, along=along, down=down, length=along * cell, depth=down * cell,
                      bottom=-down * cell, near=near, far=far).history
        spectra = {name: find_velocity_spectrum(h, name, frequencies, 1.5 + (7 if "near" in name else 11), 1.5)
                   for name in ("near_y", "far_y", "far_x")}
        phase = find_phase_speed([spectra["near_y"], spectra["far_y"]], far - near, frequencies, speed)
        rows.append((a_wave, float(phase[50]), float(abs(spectra["far_x"][50] / spectra["far_y"][50]))))
    bench.near("speed over the shear speed", rows[-1][1], speed, relative=0.005)
    bench.near("axes of the ellipse", rows[-1][2], ratio, relative=0.01)
    bench.below("error of the speed on the fine mesh over that on the coarse one",
                abs((rows[1][1] - speed) / (rows[0][1] - speed)), 0.7)
    bench.table(["elements to a wave length", "speed", "error", "axes", "error"],
                [[n, f"{c:.5f}", f"{100 * (c / speed - 1):+.3f} %", f"{a:.4f}", f"{100 * (a / ratio - 1):+.2f} %"]
                 for n, c, a in rows])

    def draw(axes):
        for name, place in (("near", near), ("far", far)):
            shift = place / speed
            axes.plot(*thin(h["time"] - shift, 1e5 * h[f"{name}_y"], 300),
                      label=f"{place / speed:.0f} wave lengths away")
        axes.set(xlabel="time since Rayleigh's wave started from the load", ylabel="normal displacement [1e-5]",
                 xlim=(-4, 4))
        axes.legend()

    bench.figure("The wave passes two points of the surface.", draw)
