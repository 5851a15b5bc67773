"""What to look at first: a judgement of a run from its summary and its history. Limits are those of docs/checks.md."""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from percuss.results.extremes import find_size, find_top
from percuss.results.history import History
from percuss.results.run import Run

GOOD, LOOK, BAD = "good", "look", "bad"

ENERGY_ERROR = 0.01      # above: look; above ten times as much the run stops by default
HOURGLASS_SHARE = 0.1    # of the internal energy
SMALL_ENERGY = 1e-3      # share of the largest energy: hourglass energy below it does not count
CONTACT_SHARE = 0.01     # of the largest energy, of what contact may add
CONTACT_LOSS = 0.05      # the same, lost in normal contact
MOMENTUM_ERROR = 1e-9    # round-off lies far below
STEP_FALL = 0.1          # least over largest step
ADDED_MASS = 0.01        # share of mass that scaling adds
PENETRATION = 0.05       # that enforcement leaves, of the edge of a face
ROUND_OFF = 1e-9         # share of the largest force: components below it are not listed
STILL_CHANGING = 0.01    # change of the internal energy in the last twentieth of the run, of the largest energy


@dataclass
class Finding:
    level: str
    text: str
    remedy: str = ""  # what to do about it


def find_findings(run: Run) -> list[Finding]:
    """The worst first."""
    summary = run.summary
    found = [_judge_status(run)]
    if summary:
        found += [_describe_warning(run, warning) for warning in run.warnings]
        found += (_judge_energies(run, summary) + _judge_momentum(summary) + _judge_steps(run, summary)
                  + _judge_losses(run, summary))
    if run.has_history and len(run.history) > 1:
        found += _judge_history(run.history)
    order = {BAD: 0, LOOK: 1, GOOD: 2}
    return sorted(found, key=lambda finding: order[finding.level])


def _judge_status(run: Run) -> Finding:
    texts = {
        "completed": _judge_end(run),
        "failed": (BAD, f"The run failed: {run.summary.get('error', '')} What follows holds up to then.",
                   _find_remedy(run.summary.get("error", ""))),
        "interrupted": (LOOK, "The run was interrupted; it can be continued with --restart.",
                        "continue it with --restart DIR/checkpoint.h5"),
        "running": (LOOK, "The run is under way: numbers are those so far."),
        "starting": (LOOK, "The run has only begun."),
        "killed": (BAD,
                   "The run was killed, or could not write its end: there are only numbers of its history and fields."),
    }
    return Finding(*texts.get(run.status, (LOOK, f"The run says '{run.status}'.")))


def _judge_end(run: Run) -> tuple[str, ...]:
    if not run.step_limit:
        return GOOD, "The run is complete."
    if run.summary.get("ended_by"):
        return GOOD, f"The run was {run.step_limit}."
    return LOOK, f"The run was {run.step_limit}.", "raise time.max_steps or leave it out, and run to the end"


def _describe_warning(run: Run, warning: dict[str, Any]) -> Finding:
    place = f"{warning['place']}: " if warning.get("place") else ""
    when = (f" First at t = {warning['time']:.4g}{_unit(run, 'time')}" if warning.get("time")
            else " Known before the first step")
    often = f", {warning['count']} times." if warning.get("count", 1) > 1 else "."
    return Finding(LOOK, f"Warning [{warning['rule']}] {place}{warning['text']}.{when}{often}",
                   _find_remedy(warning["text"], warning))


def _find_remedy(message: str, warning: dict[str, Any] | None = None) -> str:
    """What follows "problem (reason): ", and the rule and place that it belongs to."""
    remedy = message.rpartition("): ")[2] if "): " in message else ""
    about = ", ".join(text for text in (warning["rule"], warning.get("place")) if text) if warning else ""
    return f"{remedy} ({about})" if remedy and about else remedy


def find_energy_in_contact_springs(run: Run) -> float:
    """At the end, of penalty contact: contact has taken it, but gives it back."""
    return (float(run.history["contact_stored"][-1])
            if run.has_history and len(run.history) and "contact_stored" in run.history else 0.0)


def _judge_energies(run: Run, summary: dict[str, Any]) -> list[Finding]:
    energy = summary["energy"]
    error = energy["error"]
    if math.isnan(error) or summary["status"] == "running":
        return []
    largest = max(abs(energy[name]) for name in ("initial", "kinetic", "internal", "external"))
    level = GOOD if abs(error) < ENERGY_ERROR else LOOK if abs(error) < 10 * ENERGY_ERROR else BAD
    found = [Finding(level, f"Energy is balanced to {abs(error):.2g} of the largest energy (limit {ENERGY_ERROR:g}).",
                     "find the time at which energy_error of the history grows, and lower time.step_scale")]
    if largest > 0 and energy["internal"] > 1e-6 * largest:
        share = energy["hourglass"] / energy["internal"]
        is_small = share < HOURGLASS_SHARE or energy["hourglass"] < SMALL_ENERGY * largest
        advice = "."
        if is_small and not share < HOURGLASS_SHARE:
            advice = f", but below {100 * SMALL_ENERGY:g} % of the largest energy: it does not count."
        if is_small or not _has_warning(summary, "hourglass_energy"):  # the warning says it with the part
            found.append(Finding(GOOD if is_small else LOOK, f"Hourglass energy is {100 * share:.3g} % of the internal "
                                                             f"energy (limit {100 * HOURGLASS_SHARE:g} %){advice}",
                                 "use smaller elements, or with hexahedra elements: {integration: full}"))
    lost = -energy["contact"] - find_energy_in_contact_springs(run)
    if largest > 0 and -lost > CONTACT_SHARE * largest:
        found.append(Finding(LOOK, f"Normal contact has added {100 * -lost / largest:.3g} % of the largest energy: "
                                   "look at overlaps at the start.",
                                   "remove overlaps at the start, or set contact.overlap: push_out"))
    return found + find_contact_loss(run)


def find_contact_loss(run: Run) -> list[Finding]:
    """A Finding where normal contact has taken more than is usual, in a list."""
    energy = run.summary["energy"]
    largest = max(abs(energy[name]) for name in ("initial", "kinetic", "internal", "external"))
    lost = -energy["contact"] - find_energy_in_contact_springs(run)
    if not lost > CONTACT_LOSS * largest:
        return []
    return [Finding(LOOK, f"Normal contact has taken {100 * lost / largest:.3g} % of the largest energy: bodies "
                          "rebound the more slowly.",
                    "use smaller elements where bodies that deform meet, or contact.enforcement: penalty, "
                    "and check contact.restitution of rigid ones")]


def _has_warning(summary: dict[str, Any], rule: str) -> bool:
    return any(warning.get("rule") == rule for warning in summary.get("warnings", []))


def _judge_momentum(summary: dict[str, Any]) -> list[Finding]:
    found = []
    for name in ("linear", "angular"):
        error = summary["momentum"][f"{name}_error"]
        if not math.isnan(error) and summary["status"] != "running":
            level = GOOD if error < MOMENTUM_ERROR else LOOK
            found.append(
                Finding(level, f"{name.capitalize()} momentum is balanced to {error:.2g}.",
                        "look for the step at which momentum changes, and report it: only round-off should be left"))
    return found


def _judge_steps(run: Run, summary: dict[str, Any]) -> list[Finding]:
    dt = summary["dt"]
    if not summary["steps"] or not dt["max"]:
        return []
    where = f"element {dt['element']}"
    part = find_part_of_element(run, dt["element"])
    where += f" of part '{part}'" if part else ""
    if dt.get("spring"):
        where = f"spring '{dt['spring']}'"
    where = dt.get("approach") or where
    text = (f"The step went from {dt['max']:.4g} down to {dt['min']:.4g}{_unit(run, 'time')}; "
            f"{where} limits the last one.")
    found = [Finding(GOOD if dt["min"] > STEP_FALL * dt["max"] else LOOK, text,
                     f"look at {where} in the last frame; "
                     "failure criteria, mass scaling or other elements there keep the step")]
    if summary["mass"]["share"] > ADDED_MASS:
        found.append(Finding(LOOK, f"Mass scaling added {100 * summary['mass']['share']:.3g} % of the mass.",
                             "lower the step of mass_scaling, and see whether forces change"))
    return found


def find_part_of_element(run: Run, element: int) -> str:
    """The name of the part of an element by its id; empty without fields."""
    if not run.has_fields:
        return ""
    place = np.flatnonzero(run.fields.element_ids == element)
    return str(run.fields.part_names[run.fields.part[place[0]]]) if len(place) else ""


def _unit(run: Run, quantity: str) -> str:
    return f" {run.units.name_of(quantity)}" if run.units else ""


def _judge_losses(run: Run, summary: dict[str, Any]) -> list[Finding]:
    eroded = summary["eroded"]
    if not eroded["elements"]:
        return []
    share = 100 * eroded["elements"] / max(1, summary["elements"])
    return [Finding(LOOK, f"{eroded['elements']} elements ({share:.3g} %) failed and were removed, with a mass of "
                          f"{eroded['mass']:.4g}{_unit(run, 'mass')} and an energy of "
                          f"{eroded['energy']:.4g}{_unit(run, 'energy')}.",
                    "repeat with smaller elements: what fails depends on their size")]


def _judge_history(history: History) -> list[Finding]:
    found = []
    if "residual" in history:
        worst = find_top(history["residual"])
        value = history["residual"][worst]
        if value > PENETRATION:
            found.append(Finding(LOOK, f"Contact left a penetration of {100 * value:.3g} % of a face's edge at t = "
                                       f"{history['time'][worst]:.4g}.", "lower contact.tolerance or time.step_scale"))
    time, internal = history["time"], history["internal"]
    largest = max(find_size(history[name]) for name in ("kinetic", "internal"))
    late = internal[time >= time[-1] - 0.05 * (time[-1] - time[0])]
    if largest > 0 and len(late) > 1 and abs(late[-1] - late[0]) > STILL_CHANGING * largest:
        found.append(Finding(LOOK, "The internal energy still changes at the end by more than 1 % of the largest "
                                   "energy in a twentieth of the run: the event may not be over.",
                             "raise time.end, and continue with --restart"))
    return found


def find_peaks(history: History) -> list[tuple[str, float, float, float, float]]:
    """[(column, largest value, its time, least value, its time)] of what has a dimension of force,
    of contacts and energies."""
    rows, forces = [], [name for name in history if history.dimension(name) == "force"]
    largest = max((find_size(history[name]) for name in forces if len(history) and np.isfinite(history[name]).any()),
                  default=0.0)
    for name in history:
        wanted = name in forces or name in ("kinetic", "internal", "contacts", "residual")
        if name in forces and np.isfinite(history[name]).any() and not find_size(history[name]) > ROUND_OFF * largest:
            continue
        if not wanted or not len(history) or not np.isfinite(history[name]).any() or not history[name].any():
            continue
        high, low = find_top(history[name]), find_top(-history[name])
        rows.append((name, history[name][high], history["time"][high], history[name][low], history["time"][low]))
    return rows
