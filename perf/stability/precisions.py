"""Single precision beside double: what drifts over many steps, and scenes at their step bound."""
import numpy as np

from long_runs import run_long, summarise
from runs import run_deck
from scenes import FREE_SCENES, KINDS, LONG_BAR, LONG_SPIN, fill, write_elements

DEFAULT = next(iter(KINDS))
SHARES = (0.9, 1.0)


def measure_scene(percuss, work, name, share):
    """Largest energy error of a free scene at a share of its step bound."""
    deck, _ = FREE_SCENES[name]
    deck = fill(deck).replace("time: {", f"time: {{step_scale: {share!r}, ", 1)
    result = run_deck(percuss, deck + write_elements(DEFAULT) + "output: {history: {every: 0}}\n", work, 300)
    errors = np.abs(result.history.get("energy_error", np.zeros(0)))
    return {"scene": name, "share": share, "code": result.code, "error": result.error,
            "steps": result.summary.get("steps", 0), "energy_error": float(np.max(errors, initial=0))}


def measure_precisions(programs, work, steps, report):
    """programs: by the name of their precision."""
    long_runs, scenes = [], []
    for precision, percuss in programs.items():
        for name, deck, linear, quadratic in (("bar, no viscosity", LONG_BAR, 0.0, 0.0),
                                              ("spin, no viscosity", LONG_SPIN, 0.0, 0.0),
                                              ("spin", LONG_SPIN, 0.06, 1.2)):
            row = {**summarise(name, DEFAULT, steps, run_long(percuss, work, deck, DEFAULT, steps, linear, quadratic)),
                   "precision": precision}
            row.pop("curve", None)
            long_runs.append(row)
            report(f"{precision}, {name}: {row['steps']} steps, "
                   + (f"energy error {row['energy_error']:.1e}" if row["code"] == 0 else row["error"]))
        for name in FREE_SCENES:
            for share in SHARES:
                scenes.append({**measure_scene(percuss, work, name, share), "precision": precision})
                report(f"{precision}, {name} at {share}: exit code {scenes[-1]['code']}, "
                       f"energy error {scenes[-1]['energy_error']:.1e}")
    return {"long_runs": long_runs, "scenes": scenes}
