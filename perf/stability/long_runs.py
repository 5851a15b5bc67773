"""A million steps of a bar, a spin and a pile: what drifts."""
import numpy as np

from runs import run_deck
from scenes import LAGRANGE, LONG_BAR, LONG_PILE, LONG_SPIN, PENALTY, fill, write_elements

ROWS = 250


def run_long(percuss, work, deck, kind, steps, linear, quadratic):
    """First a few steps, which tell how long a step is, then all."""
    elements = write_elements(kind, linear, quadratic)
    first = run_deck(percuss, fill(deck, steps=20, every=1.0) + elements, work, 60)
    if first.code != 0:
        raise RuntimeError(first.error)
    every = first.summary["dt"]["last"] * steps / ROWS
    return run_deck(percuss, fill(deck, steps=steps, every=every) + elements, work, 1800)


def summarise(name, kind, steps, result):
    h, s = result.history, result.summary
    if result.code != 0:
        return {"run": name, "kind": kind, "code": result.code, "error": result.error, "steps": s.get("steps", 0)}
    total = h["kinetic"] + h["internal"] + h["hourglass"]
    angular = np.stack([h["angular_x"], h["angular_y"], h["angular_z"]])
    row = {"run": name, "kind": kind, "code": 0, "steps": s["steps"], "seconds": result.seconds,
           "periods_time": s["time"], "energy_error": float(np.max(np.abs(h["energy_error"]))),
           "linear_error": s["momentum"]["linear_error"], "angular_error": s["momentum"]["angular_error"],
           "half": float(np.max(np.abs(h["energy_error"][: len(total) // 2]))),
           "curve": {"step": h["step"].tolist(), "energy_error": h["energy_error"].tolist()}}
    if name.startswith("spin"):
        drift = np.linalg.norm(angular - angular[:, :1], axis=0) / np.linalg.norm(angular[:, 0])
        row["angular_drift"] = float(np.max(drift))
    if "top_z" in h:
        sink = h["top_z"] - h["top_z"][len(total) // 4]
        row["top_drift"] = float(sink[-1] / 0.06)
        row["slip"] = float(np.hypot(h["top_x"][-1] - h["top_x"][0], h["top_y"][-1] - h["top_y"][0]) / 0.06)
        row["kinetic_late"] = float(np.max(h["kinetic"][len(total) // 2:]))
        row["settled"] = float(np.max(np.abs(h["external"])))
        row["curve"]["kinetic"] = h["kinetic"].tolist()
    return row


def measure_long_runs(percuss, work, kinds, steps, pile_steps, report):
    rows = []
    piles = [(name, LONG_PILE.replace("contact: {", "contact: {" + keys), pile_steps, 0.06, 1.2)
             for name, keys in (("pile of three", ""), ("pile, lagrange", LAGRANGE + ", "),
                                ("pile, penalty", PENALTY + ", "))]
    for kind in kinds:
        for name, deck, count, linear, quadratic in (
                ("bar, no viscosity", LONG_BAR, steps, 0.0, 0.0), ("spin, no viscosity", LONG_SPIN, steps, 0.0, 0.0),
                ("spin", LONG_SPIN, steps, 0.06, 1.2), *piles):
            if not name.endswith("no viscosity") and kind != kinds[0]:
                continue
            row = summarise(name, kind, count, run_long(percuss, work, deck, kind, count, linear, quadratic))
            rows.append(row)
            report(f"long run, {name}, {kind}: {row['steps']} steps, " +
                   (f"energy error {row['energy_error']:.1e}, {row['seconds']:.0f} s" if row["code"] == 0
                    else row["error"]))
    return rows
