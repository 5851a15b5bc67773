"""In short: what happened, how large the largest force was and when,
whether the run can be trusted, and what to change."""

import math
import os
import re

import numpy as np

from percuss.errors import NotResults
from percuss.files import TEXT, load_json
from percuss.results.arrays import Array
from percuss.results.deck import Deck
from percuss.results.history import History
from percuss.results.run import Run
from percuss.results.units import choose_time_unit, choose_unit

from .findings import BAD, GOOD, Finding, find_energy_in_contact_springs
from .forces import describe_kind, find_force, find_impulse, list_forces
from .markup import escape, show_deck
from .motion import describe_motions
from .welds import describe_welds

MOST_CHANGES = 6
UNRESOLVED = 0.5  # share of a peak: a row beside it below this does not show the rise or the fall
STILL_LOADED = 0.1  # share of a peak: a larger force in the last row is reported
PERIODS = 10  # of the cut-off frequency of CFC 1000, from which a filter is suggested
REFINE = "Nothing that this run shows. Repeat it with smaller elements and compare both runs: percuss report DIR DIR2."


def make_answers(run: Run, findings: list[Finding]) -> str:
    """Four questions and their answers, as far as the files have them."""
    changes = [*list_changes_of_import(run), *list_changes(findings), *list_changes_for_forces(run)]
    rows = [("What happened?", [escape(text) for text in describe_events(run)]),
            ("Largest force, and when?", describe_forces(run)),
            ("May I trust it?", [escape(judge_trust(run, findings))]),
            ("What would I change?", [escape(text) for text in changes or [REFINE]])]
    return ("<dl class=answers>"
            + "".join(f"<dt>{escape(question)}</dt><dd>{''.join(f'<div>{text}</div>' for text in texts)}</dd>"
                      for question, texts in rows if texts) + "</dl>")


def show(run: Run, value: float, quantity: str) -> str:
    """'442.7 J'; in kJ or mJ where that reads better."""
    unit, factor = choose_unit(run.units.name_of(quantity) if run.units else "", abs(value))
    return f"{value * factor:.4g} {unit}".rstrip()


def show_time(run: Run, value: float) -> str:
    end = run.summary.get("time") or (float(run.history["time"][-1]) if run.has_history and len(run.history) else 0.0)
    unit, factor = choose_time_unit(run.units.name_of("time") if run.units else "", end)
    return f"{value * factor:.4g} {unit}".rstrip()


def describe_events(run: Run) -> list[str]:
    """Where the energy went, in sentences."""
    energy = run.summary.get("energy")
    if not energy or math.isnan(energy["kinetic"]) or run.status in ("running", "starting", "killed"):
        return []
    start = float(run.history["kinetic"][0]) if run.has_history and len(run.history) else energy["initial"]
    text = (f"In {show_time(run, run.summary['time'])} the kinetic energy went from {show(run, start, 'energy')} to "
            f"{show(run, energy['kinetic'], 'energy')}. ")
    stored = find_energy_in_contact_springs(run)
    contact = energy["contact"] + stored
    shares = [("internal energy", energy["internal"]), ("hourglass energy", energy["hourglass"]),
              ("bulk viscosity", energy["viscous"]),
              ("folding energy", energy.get("folding", 0)), ("eroded elements", run.summary["eroded"]["energy"]),
              ("friction", -energy["friction"]), ("damping", -energy["damping"]),
              ("springs of contact", stored),
              ("added by normal contact" if contact > 0 else "lost in normal contact", abs(contact))]
    largest = max(abs(value) for value in (start, energy["kinetic"], energy["internal"], energy["external"]))
    parts = [f"{name} {show(run, value, 'energy')}" for name, value in shares if value and abs(value) > 1e-3 * largest]
    text += f"At the end: {', '.join(parts)}." if parts else ""
    if energy["external"] and abs(energy["external"]) > 1e-3 * largest:
        text += f" Loads, gravity and prescribed motion did the work {show(run, energy['external'], 'energy')}."
    limit = [f"The run was {run.step_limit}."] if run.step_limit else []
    return [*describe_relaxation(run), *limit, text, *describe_motions(run), *describe_erosion(run),
            *describe_welds(run, show_time), *describe_ties(run)]


def describe_relaxation(run: Run) -> list[str]:
    """How the run came to its state at time 0."""
    relaxation = run.summary.get("relaxation") or {}
    if not relaxation.get("state"):
        return []
    preloads = run.deck.get_map("start.preload")
    reached = f"; preloads are reached to {relaxation['preload_error']:.2g} of their forces" if preloads else ""
    return [f"Before time 0 the relaxation {'settled' if relaxation['state'] == 'settled' else 'did not settle'} in "
            f"{relaxation['damped_steps']:,} steps, "
            f"with {relaxation['kinetic_ratio']:.2g} of the energy left as motion{reached}."]


def describe_ties(run: Run) -> list[str]:
    """How many nodes of ties have let go, and by when the first."""
    if not run.has_history or "failed_ties" not in run.history or not len(run.history):
        return []
    counts = np.asarray(run.history["failed_ties"])
    if not counts[-1] > 0:
        return []
    first = run.history["time"][int(np.argmax(counts > 0))]
    return [f"{int(counts[-1]):,} tied nodes have failed, the first by t = {show_time(run, first)}."]


def describe_erosion(run: Run) -> list[str]:
    count = run.summary["eroded"]["elements"]
    if not count:
        return []
    first = ""
    if run.has_history and "eroded_elements" in run.history:
        row = int(np.argmax(run.history["eroded_elements"] > 0))
        first = (f", the first by t = {show_time(run, run.history['time'][row])}"
                 if run.history["eroded_elements"][row] > 0 else "")
    return [f"{count:,} of {run.summary['elements']:,} elements failed{first}."]


def find_peaks_of_forces(run: Run) -> list[tuple[str, str, float, float, bool]]:
    """[(name, what it is, largest magnitude, its time, whether a mean between rows)]: means before values of one step,
    then the largest first."""
    history, found = run.history, []
    for name in list_forces(history):
        found.append((name, describe_kind(run, name),
                      *_find_peak(history, np.linalg.norm(find_force(history, name), axis=1)), True))
    if "wall_force_x" in history and not any(kind.startswith("wall ") for _, kind, *_ in found):
        size = np.linalg.norm([history[f"wall_force_{axis}"] for axis in "xyz"], axis=0)
        found.append(("wall_force", "all walls", *_find_peak(history, size), False))
    for name in (column[len("joint_fx:") :] for column in history if column.startswith("joint_fx:")):
        size = np.linalg.norm([history[f"joint_f{axis}:{name}"] for axis in "xyz"], axis=0)
        found.append((name, "joint", *_find_peak(history, size), False))
    for name in (column[len("spring_force:") :] for column in history if column.startswith("spring_force:")):
        found.append((name, "spring", *_find_peak(history, np.abs(history[f"spring_force:{name}"])), False))
    for name in (column[len("weld_normal:") :] for column in history if column.startswith("weld_normal:")):
        size = np.hypot(history[f"weld_normal:{name}"], history[f"weld_shear:{name}"])
        found.append((name, "weld", *_find_peak(history, size), False))
    return sorted((peak for peak in found if peak[2] > 0), key=lambda peak: (not peak[-1], -peak[2]))


def is_resolved(history: History, name: str) -> bool:
    """Whether the rows beside the largest one of a force show its rise and its fall; one at the end has no fall yet."""
    size = np.linalg.norm(find_force(history, name), axis=1)
    top = int(np.argmax(np.where(np.isfinite(size), size, 0)))
    beside = size[max(top - 1, 0) : top + 2]
    return not beside.min() < UNRESOLVED * size[top]


def _find_peak(history: History, size: Array) -> tuple[float, float]:
    size = np.where(np.isfinite(size), size, 0)
    top = int(np.argmax(size))
    return float(size[top]), float(history["time"][top])


def describe_forces(run: Run) -> list[str]:
    """The largest forces, or what the deck needs to have them."""
    if not run.has_history or len(run.history) < 2:
        return [escape("There is no history. Add to the deck:") + show_deck(suggest_forces(run))]
    peaks = find_peaks_of_forces(run)
    texts = []
    for name, kind, value, time, is_mean in peaks[:4]:
        meaning = "mean since the row before" if is_mean else "value of one step"
        text = (f"{name}{f' ({kind})' if kind else ''}: {show(run, value, 'force')} at t = "
                f"{show_time(run, time)}, {meaning}.")
        if is_mean:
            mean = np.linalg.norm(find_impulse(run.history, name)) / (run.history["time"][-1] - run.history["time"][0])
            text += f" Mean over the whole run {show(run, mean, 'force')}."
            last = float(np.linalg.norm(find_force(run.history, name)[-1]))
            text += (f" {show(run, last, 'force')} in the last row: it still acts."
                     if last > STILL_LOADED * value else "")
        texts.append(escape(text))
    if not any(is_mean for *_, is_mean in peaks) and not list_forces(run.history):
        texts.append(escape("The history has no forces of contact, supports or sections. "
                            "For forces whose integral is exact, add to the deck:")
                     + show_deck(suggest_forces(run)))
    if peaks and peaks[0][-1]:
        rows = float(np.median(np.diff(run.history["time"])))
        unit, factor = choose_time_unit(run.units.name_of("time") if run.units else "", rows)
        text = f"Rows are {f'{rows * factor:.3g} {unit}'.rstrip()} apart; a shorter peak is averaged."
        if not is_resolved(run.history, peaks[0][0]):
            text += (f" The peak of {peaks[0][0]} rises or falls by more than half from one row to the next: its true "
                     "height is larger.")
        if run.units and (run.history["time"][-1] - run.history["time"][0]) * run.units.time[1] > PERIODS * 0.6 / 1000:
            text += f" To compare with a filtered test signal: percuss plot DIR 'f?:{peaks[0][0]}' --cfc 1000."
        texts.append(escape(text))
    return texts or [escape("All forces of the history are zero.")]


def list_changes_of_import(run: Run) -> list[str]:
    """What percuss import has left out or changed of another program's deck, as its report beside the deck says:
    first what the user has allowed."""
    path = os.path.join(os.path.dirname(run.deck.file), "import_report.json")
    if not run.deck.file or not os.path.isfile(path):
        return []
    try:
        cards = load_json(path, {"cards": [{"card": TEXT, "outcome": TEXT, "how": TEXT}]})["cards"]
    except NotResults:
        return []
    found = [f"Put back what the import has left out, if it matters: *{card['card']} ({card['how']})."
             for card in cards if card["outcome"] == "left out"]
    count = sum(card["outcome"] == "approximated" for card in cards)
    if count:
        names = ", ".join(dict.fromkeys(f"*{card['card']}" for card in cards if card["outcome"] == "approximated"))
        found.append(f"Read what the import has approximated (import_report.md): {shorten(names)}.")
    return found[:MOST_CHANGES]


def shorten(text: str, most: int = 160) -> str:
    return text if len(text) <= most else text[:most].rpartition(",")[0] + " and others"


def list_changes_for_forces(run: Run) -> list[str]:
    """For the largest force that is a mean between rows: rows that show its peak, and a run to its end."""
    peaks = find_peaks_of_forces(run) if run.has_history and len(run.history) > 1 else []
    if not peaks or not peaks[0][-1]:
        return []
    name, kind, value, *_ = peaks[0]
    found = []
    if not is_resolved(run.history, name):
        found.append(f"Write rows more often (output.history.every): they do not show the whole peak of {name}.")
    last = float(np.linalg.norm(find_force(run.history, name)[-1]))
    if last > STILL_LOADED * value and not kind.startswith(("support", "section")):
        found.append(f"Raise time.end if the event should come to its end: {name} still acts. "
                     "A later peak may be larger.")
    return found


def suggest_forces(run: Run) -> str:
    """Lines of a deck: contact of the parts that move at the start, walls with names, supports."""
    deck, rows = run.deck, []
    moving = [entry.get("part") or entry.get("nodes") for entry in deck.get_list("initial") if isinstance(entry, dict)]
    parts = list(deck.get_map("parts"))
    for together in _group_by_motion(deck, [name for name in moving if name in parts]) or [parts[:1]]:
        rows.append(f"{{name: force_on_{'_and_'.join(together)}, contact: "
                    f"[{together[0] if len(together) == 1 else '[' + ', '.join(together) + ']'}, all]}}")
    for wall in deck.get_list("walls"):
        if isinstance(wall, dict) and wall.get("name"):
            rows.append(f"{{name: on_{wall['name']}, wall: {wall['name']}}}")
    for number, entry in enumerate(deck.get_list("conditions")):
        if isinstance(entry, dict) and isinstance(entry.get("nodes"), str) and "fixed" in entry:
            rows.append(f"{{name: support_{number}, support: {entry['nodes']}}}")
    rows = list(dict.fromkeys(rows))[:4]
    every = deck.get("output.history.every")
    head = "output:\n  history:\n" + (f"    every: {every}\n" if every else "")
    return (head + "    forces:\n"
            + "".join(f"      - {row}\n" for row in rows or ["{name: force, contact: [PART, all]}"]))


def _group_by_motion(deck: Deck, parts: list[str]) -> list[list[str]]:
    """Parts with the same entry of initial but for their names: pieces of one body, most likely."""
    groups: dict[str, list[str]] = {}
    for entry in deck.get_list("initial"):
        name = (entry.get("part") or entry.get("nodes")) if isinstance(entry, dict) else None
        if name in parts:
            groups.setdefault(repr({key: value for key, value in entry.items() if key not in ("part", "nodes")}),
                              []).append(name)
    return [list(dict.fromkeys(group)) for group in groups.values()]


def judge_trust(run: Run, findings: list[Finding]) -> str:
    """A verdict by the findings, the worst first."""
    count = {level: sum(finding.level == level for finding in findings) for level in ("bad", "look")}
    if count[BAD]:
        return f"No: {_first(findings, BAD)}"
    energy = run.summary.get("energy", {})
    sums = (f"energy is balanced to {abs(energy['error']):.2g}" if not math.isnan(energy.get("error", math.nan))
            else "there are no balances yet")
    if count["look"]:
        points = "1 point" if count["look"] == 1 else f"{count['look']} points"
        return f"With care: {sums}, but {points} below need{'s' if count['look'] == 1 else ''} a look first."
    return (f"As far as balances show, yes: {sums}, and no limit is exceeded. "
            "Balances do not show errors of the mesh or of material data: "
            "compare with a finer mesh or a test.")


def _first(findings: list[Finding], level: str) -> str:
    return next((finding.text for finding in findings if finding.level == level), "")


def list_changes(findings: list[Finding]) -> list[str]:
    """What to do about each finding that is not good, once each."""
    found = []
    for finding in findings:
        if finding.level != GOOD and finding.remedy:
            text = finding.remedy[:1].upper() + finding.remedy[1:].rstrip(".") + "."
            found.append(re.sub(r"\s+", " ", text))
    return list(dict.fromkeys(found))[:MOST_CHANGES]
