"""Impacts from 0.01 to 10 wave speeds: how each ends."""
import numpy as np

from runs import run_deck
from scenes import IMPACT_PARTS, SOFT_STEEL, STEEL, write_elements, write_impact

MATERIALS = {"elastic": STEEL, "plastic": SOFT_STEEL}
FINE = 0.01  # energy error, and negative internal energy, up to which a completed run is called good


def judge(result):
    """good, coarse (completed, but energy is off by more than FINE),
    named (exit code 3 with a message), hang, crash."""
    if result.code is None:
        return "hang"
    if result.code == 3 and result.error:
        return "named"
    if result.code != 0:
        return "crash"
    errors = np.abs(result.history["energy_error"])
    return "good" if np.max(errors) <= FINE and find_lowest_internal(result) > -FINE else "coarse"


def find_lowest_internal(result):
    """Internal energy over the largest kinetic energy, where it is least:
    below 0 the law of the material makes energy."""
    h = result.history
    if "internal" not in h or len(h["internal"]) == 0:
        return 0.0
    return float(np.nanmin(h["internal"]) / np.nanmax(h["kinetic"]))


def measure_impacts(percuss, work, kinds, speeds, limit, report):
    rows = []
    for kind in kinds:
        for target in IMPACT_PARTS:
            for material, law in MATERIALS.items():
                for speed in speeds:
                    result = run_deck(percuss, write_impact(target, law, speed) + write_elements(kind), work, limit)
                    error = result.history.get("energy_error")
                    rows.append({
                        "kind": kind, "target": target, "material": material, "speed": speed, "verdict": judge(result),
                        "code": result.code, "error": result.error.splitlines()[-1] if result.error else "",
                        "steps": result.summary.get("steps"), "seconds": result.seconds,
                        "energy_error": float(np.nanmax(np.abs(error))) if error is not None and len(error) else None,
                        "lowest_internal": find_lowest_internal(result),
                        "linear_error": result.summary.get("momentum", {}).get("linear_error"),
                        "angular_error": result.summary.get("momentum", {}).get("angular_error")})
                ended = [row["verdict"] for row in rows[-len(speeds):]]
                report(f"impact, {kind}, {target}, {material}: {' '.join(ended)}")
    return rows

