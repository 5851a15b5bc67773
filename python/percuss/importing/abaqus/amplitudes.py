"""*AMPLITUDE: values over time, each kind as straight lines between points."""

import math
from collections.abc import Callable
from dataclasses import dataclass

from ..curves import Points
from ..fields import clip
from ..ledger import BadInput, Place
from .lines import Block

PER_PERIOD, MOST_POINTS = 128, 20_000  # straight lines miss a sine by 3e-4 of its height
PER_STEP, PER_DECAY = 128, 32
KINDS = ("TABULAR", "SMOOTH STEP", "EQUALLY SPACED", "PERIODIC", "DECAY", "MODULATED")


@dataclass
class Amplitude:
    """Points of time and value; both ends are held. What is not read has a reason."""

    place: Place
    points: Points
    is_total: bool = False  # over the time of the run, not of the step
    is_absolute: bool = False  # it gives the values themselves, not factors
    reason: str = ""
    error: str = ""  # of the straight lines


def read_amplitude(block: Block, end: float) -> Amplitude:
    """end: the longest time that it may be asked for."""
    kind = block.option("DEFINITION") or "TABULAR"
    values = [block.number(line, i) for line in block.lines for i in range(len(line[1])) if line[1][i]]
    found = Amplitude(block.place, [], block.option("TIME") == "TOTAL TIME", block.option("VALUE") == "ABSOLUTE")
    if (block.option("TIME") not in ("", "STEP TIME", "TOTAL TIME")
            or block.option("VALUE") not in ("", "RELATIVE", "ABSOLUTE")):
        raise BadInput(block.place, f"TIME={clip(block.option('TIME'))} or VALUE={clip(block.option('VALUE'))} of "
                                    "*AMPLITUDE is not known: correct it")
    smoothing = block.number((block.place.line, [block.options.get("SMOOTH", "")]), 0)
    if kind not in KINDS:
        found.reason = f"of the kind {clip(kind)}"
    elif smoothing:
        found.reason = f"with SMOOTH={smoothing:g}"
    elif not values:
        raise BadInput(block.place, "*AMPLITUDE has no data line: add it")
    else:
        READERS[kind](found, block, values, end)
    return found


def read_tabular(found: Amplitude, block: Block, values: list[float], end: float) -> None:
    if len(values) % 2:
        raise BadInput(block.place, "*AMPLITUDE has a time without a value: correct its lines")
    found.points = list(zip(values[::2], values[1::2]))
    check_order(found.points, block.place)


def check_order(points: Points, place: Place) -> None:
    """Times ascend; two of them may be equal, for a step."""
    times = [x for x, _ in points]
    for before, after in zip(times, times[1:]):
        if after < before:
            raise BadInput(place,
                           f"the times of *AMPLITUDE do not ascend ({before:g}, then {after:g}): correct its lines")
    if any(a == b == c for a, b, c in zip(times, times[1:], times[2:])):
        raise BadInput(place, "*AMPLITUDE has three values at one time: remove one")


def read_smooth(found: Amplitude, block: Block, values: list[float], end: float) -> None:
    """Each step by 128 rows of 10 s^3 - 15 s^4 + 6 s^5."""
    read_tabular(found, block, values, end)
    rows = found.points[:1]
    for (t0, a0), (t1, a1) in zip(found.points, found.points[1:]):
        for i in range(1, PER_STEP + 1):
            s = i / PER_STEP
            rows.append((t0 + (t1 - t0) * s, a0 + (a1 - a0) * s**3 * (10 - 15 * s + 6 * s * s)))
    found.points, found.error = rows, f"a smooth step by {PER_STEP} rows"


def read_equal(found: Amplitude, block: Block, values: list[float], end: float) -> None:
    """Values at equal distances, from BEGIN on."""
    gap, begin = (block.number((block.place.line, [block.options.get(name, "")]), 0)
                  for name in ("FIXED INTERVAL", "BEGIN"))
    if gap <= 0:
        raise BadInput(block.place, "*AMPLITUDE, DEFINITION=EQUALLY SPACED needs a positive FIXED INTERVAL: add it")
    found.points = [(begin + gap * i, value) for i, value in enumerate(values)]


def sample(found: Amplitude, start: float, length: float, pieces: int, value: Callable[[float], float],
           before: float) -> None:
    """A curve from `start` on, by so many pieces; before it one value."""
    if pieces > MOST_POINTS:
        raise BadInput(found.place, f"this amplitude needs {pieces} rows until the end of the run "
                                    f"(at most {MOST_POINTS}): correct its frequency")
    found.points = [(min(start, 0.0) - 1.0, before), (start, before)] if start > 0 else []
    found.points += [(start + length * i / pieces, value(length * i / pieces)) for i in range(pieces + 1)]


def need(block: Block, values: list[float], count: int) -> list[float]:
    if len(values) < count:
        raise BadInput(block.place, f"*AMPLITUDE has {len(values)} values ({count} are needed): correct it")
    return values


def read_periodic(found: Amplitude, block: Block, values: list[float], end: float) -> None:
    """A0 + sum of A cos n w (t - t0) + B sin n w (t - t0)."""
    terms = int(need(block, values, 4)[0])
    frequency, start, base = values[1:4]
    pairs = list(zip(values[4::2], values[5::2]))
    if terms != len(pairs) or not terms or frequency <= 0:
        raise BadInput(block.place, f"*AMPLITUDE has {len(pairs)} pairs of coefficients for {terms} terms, "
                                    "or no frequency: correct it")
    length = max(end - start, 1e-3 / frequency)
    pieces = math.ceil(min(length * frequency * terms / (2 * math.pi), MOST_POINTS) * PER_PERIOD) + 1

    def value(t: float) -> float:
        return base + sum(a * math.cos(n * frequency * t) + b * math.sin(n * frequency * t)
                          for n, (a, b) in enumerate(pairs, 1))

    sample(found, start, length, pieces, value, base)
    found.error = f"a sum of sines by {PER_PERIOD} rows a period, within 3e-4 of their heights"


def read_modulated(found: Amplitude, block: Block, values: list[float], end: float) -> None:
    """A0 + A sin w1 (t - t0) sin w2 (t - t0)."""
    base, height, start, first, second = need(block, values, 5)[:5]
    length = max(end - start, 1e-9 * end)
    pieces = math.ceil(min(length * (abs(first) + abs(second)) / (2 * math.pi), MOST_POINTS) * PER_PERIOD) + 1
    sample(found, start, length, pieces, lambda t: base + height * math.sin(first * t) * math.sin(second * t), base)
    found.error = f"a product of sines by {PER_PERIOD} rows a period, within 3e-4 of its height"


def read_decay(found: Amplitude, block: Block, values: list[float], end: float) -> None:
    """A0 + A exp(-(t - t0) / td)."""
    base, height, start, decay = need(block, values, 4)[:4]
    if decay <= 0:
        raise BadInput(block.place, "the decay time of *AMPLITUDE is not positive: correct it")
    length = max(end - start, 1e-9 * end)
    pieces = math.ceil(min(length / decay, 40.0) * PER_DECAY) + 1
    sample(found, start, min(length, 40.0 * decay), pieces, lambda t: base + height * math.exp(-t / decay), base)
    found.points = [*found.points, (start + 41.0 * decay, base)] if length > 40.0 * decay else found.points
    found.error = f"an exponential by {PER_DECAY} rows a decay time, within 2e-4 of its height"


READERS: dict[str, Callable[[Amplitude, Block, list[float], float], None]] = {
    "TABULAR": read_tabular, "SMOOTH STEP": read_smooth, "EQUALLY SPACED": read_equal, "PERIODIC": read_periodic,
    "MODULATED": read_modulated, "DECAY": read_decay,
}  # fmt: skip
