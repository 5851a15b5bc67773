"""Classical laminate theory and Hashin's criteria, for rows of composites (Jones, Mechanics of Composite Materials, chapters 2 and 4; Hashin 1980)."""

import math
from collections.abc import Sequence

Matrix = list[list[float]]
Ply = tuple[float, float, "Constants"]  # thickness, angle in degrees
Constants = tuple[float, float, float, float]  # E1, E2, nu12, G12


def reduce(constants: Constants, degrees: float) -> Matrix:
    """Stiffness of plane stress of a ply whose fibres are at an angle."""
    e1, e2, nu12, g12 = constants
    over = 1 / (1 - nu12 * nu12 * e2 / e1)
    q11, q22, q12, q66 = e1 * over, e2 * over, nu12 * e2 * over, g12
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    mixed = q12 + 2 * q66
    q = [[q11 * c**4 + 2 * mixed * c**2 * s**2 + q22 * s**4, (q11 + q22 - 4 * q66) * c**2 * s**2 + q12 * (c**4 + s**4), 0.0],
         [0.0, q11 * s**4 + 2 * mixed * c**2 * s**2 + q22 * c**4, 0.0],
         [0.0, 0.0, (q11 + q22 - 2 * q12 - 2 * q66) * c**2 * s**2 + q66 * (c**4 + s**4)]]  # fmt: skip
    q[0][2] = (q11 - q12 - 2 * q66) * s * c**3 + (q12 - q22 + 2 * q66) * s**3 * c
    q[1][2] = (q11 - q12 - 2 * q66) * s**3 * c + (q12 - q22 + 2 * q66) * s * c**3
    q[1][0], q[2][0], q[2][1] = q[0][1], q[0][2], q[1][2]
    return q


def find_energy(plies: Sequence[Ply], strain: Sequence[float], curvature: float, area: float = 100.0, middle: float = 0.0) -> float:
    """Of a plate with strains xx, yy, xy of its reference surface and a curvature xx: area (e A e / 2 + e B k + k D k / 2).

    middle: height of the middle over the reference surface.
    """
    bottom, energy = middle - 0.5 * sum(ply[0] for ply in plies), 0.0
    for thickness, angle, constants in plies:
        q, top = reduce(constants, angle), bottom + thickness
        a, b, d = thickness, (top**2 - bottom**2) / 2, (top**3 - bottom**3) / 3
        k = (curvature, 0.0, 0.0)
        energy += sum(q[i][j] * (a * strain[i] * strain[j] / 2 + b * strain[i] * k[j] + d * k[i] * k[j] / 2) for i in range(3) for j in range(3))
        bottom = top
    return area * energy


def find_load(s1: float, s2: float, t: float, xt: float, xc: float, yt: float, yc: float, s: float, st: float, share: float) -> float:
    """The factor on a stress at which the first of the criteria is met."""

    def most(r: float) -> float:
        a, b, shear = r * s1, r * s2, (r * t / s) ** 2
        fibre = (a / xt) ** 2 + share * shear if a > 0 else (a / xc) ** 2
        matrix = (b / yt) ** 2 + shear if b >= 0 else (b / (2 * st)) ** 2 + ((yc / (2 * st)) ** 2 - 1) * b / yc + shear
        return max(fibre, matrix)

    low, high = 0.0, 1e9
    for _ in range(200):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if most(middle) < 1 else (low, middle)
    return low
