"""Rolled sheet in plane stress, for rows of metals: Hill 1948, and Barlat and Lian 1989, integrated in small steps."""

import math
from collections.abc import Callable, Sequence

Surface = Callable[[float, float, float], float]  # the equivalent stress of s11, s22, s12


def hill(f: float, g: float, h: float, n: float) -> Surface:
    return lambda a, b, t: math.sqrt((g + h) * a * a - 2 * h * a * b + (f + h) * b * b + 2 * n * t * t)


def hill_by_strain(r0: float, r45: float, r90: float) -> Surface:
    return hill(r0 / (r90 * (1 + r0)), 1 / (1 + r0), r0 / (1 + r0), (r0 + r90) * (1 + 2 * r45) / (2 * r90 * (1 + r0)))


def hill_by_stress(r11: float, r22: float, r33: float, r12: float) -> Surface:
    a, b, c = r11**-2, r22**-2, r33**-2
    return hill((b + c - a) / 2, (c + a - b) / 2, (a + b - c) / 2, 1.5 / r12**2)


def barlat(c: float, h: float, p: float, m: float) -> Surface:
    def surface(x: float, y: float, t: float) -> float:
        k, q = (x + h * y) / 2, math.hypot((x - h * y) / 2, p * t)
        return float((((2 - c) * (abs(k + q) ** m + abs(k - q) ** m) + c * (2 * q) ** m) / 2) ** (1 / m))

    return surface


def normal(surface: Surface, s: Sequence[float]) -> list[float]:
    d, found = 1e-6 * max(map(abs, s)), []
    for k in range(3):
        high, low = list(s), list(s)
        high[k] += d
        low[k] -= d
        found.append((surface(*high) - surface(*low)) / (2 * d))
    return found


def barlat_by_strain(r0: float, r45: float, r90: float, m: float) -> Surface:
    x, y = r0 / (1 + r0), r90 / (1 + r90)
    low, high = 0.01, 100.0
    for _ in range(100):
        p = math.sqrt(low * high)
        e1, e2, shear = normal(barlat(2 * math.sqrt(x * y), math.sqrt(x / y), p, m), (0.5, 0.5, 0.5))
        low, high = (p, high) if shear / (2 * (e1 + e2)) - 0.5 < r45 else (low, p)
    return barlat(2 * math.sqrt(x * y), math.sqrt(x / y), p, m)


def strain(surface: Surface, hardening: Callable[[float], float], modulus: float, nu: float, e: Sequence[float], degrees: float, rate: Callable[[float], float] = lambda dp: 1.0, steps: int = 800) -> float:
    """Work per volume of a sheet that gets the strains xx, yy, 2 xy, with axis 1 at an angle to x. rate: factor of the stress by the plastic strain of a step
    over that of the whole time."""
    c, t = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    own = (c * c * e[0] + t * t * e[1] + c * t * e[2], t * t * e[0] + c * c * e[1] - c * t * e[2], 2 * c * t * (e[1] - e[0]) + (c * c - t * t) * e[2])
    de = [part / steps for part in own]

    def multiply(v: Sequence[float]) -> list[float]:
        k = modulus / (1 - nu * nu)
        return [k * (v[0] + nu * v[1]), k * (v[1] + nu * v[0]), k * (1 - nu) / 2 * v[2]]

    s, p, work = [0.0, 0.0, 0.0], 0.0, 0.0
    for _ in range(steps):
        trial = [a + b for a, b in zip(s, multiply(de))]
        if surface(*trial) > hardening(p):
            back = multiply(normal(surface, trial))
            low, high = 0.0, surface(*trial) / surface(*back)
            for _ in range(50):
                dp = 0.5 * (low + high)
                is_above = surface(*(a - dp * b for a, b in zip(trial, back))) > rate(dp * steps) * hardening(p + dp)
                low, high = (dp, high) if is_above else (low, dp)
            trial, p = [a - low * b for a, b in zip(trial, back)], p + low
        work += sum(0.5 * (a + b) * d for a, b, d in zip(s, trial, de))
        s = trial
    return work
