"""Writes docs/stability.md from the results of the studies."""
import pathlib
import re

import numpy as np

import plots
from scenes import FREE_SCENES, KINDS, LAGRANGE, OFF, PENALTY

DEFAULT = next(iter(KINDS))
HERE = pathlib.Path(__file__).resolve().parent


class Page:
    """The page being written: a dictionary of texts by name, and what is wrong."""

    def __init__(self, images):
        self.images, self.texts, self.wrong = images, {}, []


def table(heading, rows):
    lines = ["| " + " | ".join(heading) + " |", "|" + "---|" * len(heading)]
    return "\n".join(lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows])


def spread(values):
    return f"{np.min(values):.2f} {np.median(values):.2f} {np.max(values):.3f}"


def unique(rows, key):
    return list(dict.fromkeys(row[key] for row in rows))


# --- the map

def tell_map(page, stored, study):
    rows = stored["results"]["rows"]
    kinds, families = unique(rows, "kind"), unique(rows, "family")
    body = []
    for family in families:
        for damping in unique(rows, "damping"):
            cells = [[r["ratio"] for r in rows if (r["family"], r["damping"], r["kind"]) == (family, damping, kind)]
                     for kind in kinds]
            if study == "elements" and damping != "none" and family not in ("rods", "distorted"):
                continue
            body.append([family, damping, *(spread(values) for values in cells)])
    for damping in unique(rows, "damping"):
        body.append(["**all**", damping,
                     *(f"**{spread([r['ratio'] for r in rows if (r['damping'], r['kind']) == (damping, kind)])}**"
                       for kind in kinds)])
    page.texts[study] = table(["shapes", "viscosity", *kinds], body)
    above = [row for row in rows if row["ratio"] > 1 + 1e-8]
    for row in above[:5]:
        page.wrong.append(f"{study}: the bound exceeds the critical step by the factor {row['ratio']:.6f} "
                          f"({row['kind']}, damping {row['damping']}, {row['family']} {row['parameter']}, "
                          f"Poisson {row['poisson']})")
    page.texts[f"{study}_count"] = f"{len(rows)}"
    page.texts[f"{study}_above"] = "none" if not above else f"**{len(above)}**"
    checks = stored["results"]["checks"]
    page.texts[f"{study}_checks"] = (f"asymmetry of the measured matrices at most {checks['asymmetry']:.0e} of their "
                                     f"largest entry, residual of the eigenvectors at most {checks['residual']:.0e}")
    if study == "elements":
        page.texts["radius"] = (f"its spectral radius is at most 1 + {max(checks['below'] - 1, 0):.0e} at 0.999 of the "
                                f"critical step and at least {checks['above']:.3f} at 1.001 of it")


def tell_poisson(page, stored):
    rows = [r for r in stored["results"]["rows"] if r["damping"] == "none"]
    kinds = unique(rows, "kind")
    page.texts["poisson"] = table(
        ["Poisson's ratio", *kinds],
        [[nu, *(spread([r["ratio"] for r in rows if (r["poisson"], r["kind"]) == (nu, kind)]) for kind in kinds)]
         for nu in unique(rows, "poisson")])


def tell_estimates(page, elements, meshes):
    """Other estimates, over the same critical steps."""
    names = {"ratio": "the bound of percuss", "guaranteed": "V / (c sqrt(2 B:B))", "over_face": "V / (c largest face)",
             "edge": "shortest edge / c"}
    body = []
    for what, stored in (("single elements", elements), ("meshes", meshes)):
        rows = [r for r in stored["results"]["rows"] if r["damping"] == "none"]
        kinds = unique(rows, "kind")
        for name, words in names.items():
            body.append([words, what, *(spread([r[name] for r in rows if r["kind"] == kind]) for kind in kinds)])
    page.texts["estimates"] = table(["estimate", "of", *kinds], body)


def tell_global(page, stored):
    """How much longer than the bound a step from the whole mesh's largest frequency would be."""
    rows = stored["results"]["rows"]
    kinds = unique(rows, "kind")
    body = []
    for family in unique(rows, "family"):
        for parameter in unique([r for r in rows if r["family"] == family and r["parameter"] not in (2, 5, 20, 50)],
                                "parameter"):
            chosen = [r for r in rows
                      if (r["family"], r["parameter"], r["damping"], r["poisson"]) == (family, parameter, "none", 0.3)]
            body.append([family, f"{parameter:g}", *(
                f"{np.mean([1 / r['ratio'] for r in chosen if r['kind'] == kind]):.2f} "
                f"({np.mean([1 / r['guaranteed'] for r in chosen if r['kind'] == kind]):.2f})" for kind in kinds)])
    page.texts["global"] = table(["shapes", "parameter", *kinds], body)


# --- shells

def tell_shells(page, stored):
    rows = stored["results"]
    page.texts["shells"] = table(
        ["shapes", "elements", "of these concave or crossed", "smallest", "1 % are below", "median", "largest"],
        [[r["family"], r["count"], r["concave"] or "", f"{r['least']:.2f}", f"{r['percentile']:.2f}",
          f"{r['median']:.2f}", f"{r['largest']:.3f}"] for r in rows])
    page.texts["shells_count"] = f"{sum(r['count'] for r in rows)}"
    page.texts["shells_above"] = "none" if all(r["largest"] <= 1 + 1e-6 for r in rows) else "**some**"
    for r in rows:
        if r["largest"] > 1 + 1e-6:
            page.wrong.append(f"shells: the bound exceeds the critical step by the factor {r['largest']:.6f} "
                              f"({r['family']})")


# --- blow-ups

def show_error(value):
    return "-" if value is None else f"{value:.1e}"


def tell_margins(page, free, contact):
    rows = [*(free or {"results": []})["results"], *(contact or {"results": []})["results"]]
    kinds = unique(rows, "kind")
    body = []
    names = {"": "kinematic", LAGRANGE: "lagrange", PENALTY: "penalty", OFF: "none"}
    for scene, keys in dict.fromkeys((r["scene"], r["contact"]) for r in rows):
        cells = []
        for kind in kinds:
            found = [r for r in rows if (r["scene"], r["contact"], r["kind"]) == (scene, keys, kind)]
            cells.append(f"{'' if found[0]['is_limit'] else '>= '}{found[0]['largest']:.2f}" if found else "-")
        here = [r for r in rows if (r["scene"], r["contact"]) == (scene, keys)]
        errors = {kind: max((r["energy_error"] or 0 for r in here if r["kind"] == kind), default=None)
                  for kind in kinds}
        worst = max(errors, key=lambda kind: errors[kind] or 0)
        ends = sorted({r["outcome"] for r in here if r["outcome"]})
        body.append([scene, "" if scene in FREE_SCENES else names.get(keys, keys), *cells, show_error(errors[DEFAULT]),
                     f"{show_error(errors[worst])} ({worst})", "; ".join(ends)])
    page.texts["margins"] = table(["scene", "contact", *kinds, f"energy error at 0.9, {DEFAULT}", "worst", "ended by"],
                                  body)
    default = [r for r in rows if r["kind"] == kinds[0] and r["contact"] == ""]
    lowest = min(default, key=lambda r: r["largest"])
    page.texts["lowest_margin"] = f"{lowest['largest']:.2f} ({lowest['scene']})"
    for row in rows:
        if row["largest"] < 0.9 and row["contact"] != OFF:
            page.wrong.append(f"{row['scene']} with {row['kind']}{' and ' + row['contact'] if row['contact'] else ''} "
                              f"is stable only up to {row['largest']:.2f} of the bound ({row['outcome']})")
    plots.draw_margins(rows, page.images / "margins.svg")


# --- long runs

def tell_long_runs(page, stored):
    body = []
    for r in stored["results"]:
        if r["code"] != 0:
            body.append([r["run"], r["kind"], r["steps"], f"exit code {r['code']}: {r['error'][:160]}", "", "", ""])
            page.wrong.append(f"long run {r['run']} with {r['kind']}: exit code {r['code']}")
            continue
        moved = ("" if "top_drift" not in r
                 else (f"top moves {r['top_drift']:.0e}, slips {r['slip']:.0e} of a brick's height; kinetic energy in "
                       f"the second half at most {r['kinetic_late'] / r['settled']:.0e} of gravity's work"))
        body.append([r["run"], r["kind"], r["steps"], f"{r['half']:.1e}", f"{r['energy_error']:.1e}",
                     f"{r['angular_drift']:.0e}" if "angular_drift" in r else "", moved])
    done = [r for r in stored["results"] if r["code"] == 0 and r["kind"] == DEFAULT]
    page.texts["drift"] = f"{max(r['energy_error'] for r in done if 'penalty' not in r['run']):.0e}"
    page.texts["drift_penalty"] = f"{max((r['energy_error'] for r in done if 'penalty' in r['run']), default=0):.0e}"
    page.texts["long_runs"] = table(["run", "element", "steps",
                                     "largest energy error, first half", "whole run", "angular momentum", "rest"], body)
    plots.draw_drift(stored["results"], page.images / "drift.svg")


# --- precisions

def tell_precisions(page, stored):
    results = stored["results"]
    precisions = unique(results["long_runs"], "precision")

    def find(rows, **keys):
        return next(r for r in rows if all(r[key] == value for key, value in keys.items()))

    def tell(row, key="energy_error"):
        return f"{row[key]:.1e}" if row["code"] == 0 else f"exit code {row['code']}: {row['error'][:100]}"

    body = []
    for run in unique(results["long_runs"], "run"):
        rows = [find(results["long_runs"], run=run, precision=precision) for precision in precisions]
        angular = [f"{r['angular_drift']:.0e}" if "angular_drift" in r else "" for r in rows]
        body.append([run, rows[0]["steps"], *map(tell, rows), *angular])
    page.texts["precision_runs"] = table(["run", "steps", *(f"energy error, {p}" for p in precisions),
                                          *(f"angular momentum, {p}" for p in precisions)], body)
    body = []
    for scene in unique(results["scenes"], "scene"):
        body.append([scene, *(tell(find(results["scenes"], scene=scene, share=share, precision=precision))
                              for share in unique(results["scenes"], "share") for precision in precisions)])
    page.texts["precision_scenes"] = table(["scene",
                                            *(f"{share:g}, {precision}" for share in unique(results["scenes"], "share")
                                              for precision in precisions)], body)
    for r in [*results["long_runs"], *results["scenes"]]:
        if r["code"] != 0 or r["energy_error"] > 0.01:
            page.wrong.append(f"{r['precision']}, {r.get('run', r.get('scene'))}: {tell(r)}")


# --- impacts

def tell_impacts(page, stored):
    rows = stored["results"]
    kinds = unique(rows, "kind")
    body = []
    for speed in unique(rows, "speed"):
        cells = []
        for kind in kinds:
            found = [r for r in rows if (r["speed"], r["kind"]) == (speed, kind)]
            counts = {verdict: sum(r["verdict"] == verdict for r in found) for verdict in plots.VERDICTS}
            done = [r["energy_error"] for r in found if r["code"] == 0]
            cells.append(f"{counts['good']} + {counts['coarse']} completed, {counts['named']} stopped" +
                         (f"; energy {max(done):.0e}" if done else ""))
        body.append([f"{speed:g}", *cells])
    page.texts["impacts"] = table(["speed", *kinds], body)
    bad = [r for r in rows if r["verdict"] in ("hang", "crash")]
    for r in bad:
        page.wrong.append(f"impact {r['target']}, {r['material']}, {r['speed']:g} wave speeds, "
                          f"{r['kind']}: {r['verdict']} {r['error'][:200]}")
    done = [r for r in rows if r["code"] == 0]
    page.texts["impact_count"] = f"{len(rows)}"
    page.texts["impact_bad"] = "none crashes and none hangs" if not bad else f"**{len(bad)} crash or hang**"
    page.texts["impact_momentum"] = (f"linear momentum is conserved to {max(r['linear_error'] for r in done):.0e}, "
                                     f"angular momentum to {max(r['angular_error'] for r in done):.0e}") if done else ""
    page.texts["impact_kinds"] = ", ".join(
        f"{sum(r['kind'] == kind for r in done)} with {kind}" for kind in kinds) + f" of {len(rows) // len(kinds)} each"
    below = [r for r in done if r["lowest_internal"] < -0.01]
    page.texts["impact_internal"] = (
        f"In {len(below)} of the {len(done)} completed runs, "
        f"at {min(r['speed'] for r in below):g} wave speeds and more, the internal energy falls below zero, "
        f"to {min(r['lowest_internal'] for r in below):.2f} of the kinetic energy at worst"
        if below else f"In none of the {len(done)} completed runs does the internal energy fall below zero")
    messages = {}
    for r in rows:
        if r["verdict"] == "named":
            kind_of = next((words for key, words in REASONS.items() if key in r["error"]), r["error"][:80])
            messages[kind_of] = messages.get(kind_of, 0) + 1
    page.texts["impact_messages"] = "; ".join(
        f"{words}: {count}" for words, count in sorted(messages.items(), key=lambda m: -m[1])) or "none stopped"
    thrown = sum(find_distance(r["error"]) > 10 for r in rows if r["verdict"] == "named")
    page.texts["impact_thrown"] = (
        f"In {thrown} of these runs the named element is far away from the scene: the iteration of contact between "
        "elements crushed to "
        "slivers diverged in that step, and its impulses accelerated nodes without bound." if thrown else "")
    plots.draw_impacts(rows, page.images / "impacts.svg")


def find_distance(message):
    """Largest coordinate of the place that a message names [m]; the scenes are smaller than one."""
    place = re.search(r"at \(([^)]*)\)", message)
    return max(abs(float(x)) for x in place.group(1).split(",")) if place else 0.0


REASONS = {"has inverted": "an element has inverted", "no stable step": "an element has inverted at one of its points",
           "energy balance": "the energy balance is off", "collapsed": "the time step has collapsed"}


def write_page(docs, stored):
    """stability.md and images/stability in `docs`. Returns what must not be."""
    page = Page(docs / "images" / "stability")
    for study in ("elements", "meshes"):
        if study in stored:
            tell_map(page, stored[study], study)
    if "elements" in stored:
        tell_poisson(page, stored["elements"])
    if "elements" in stored and "meshes" in stored:
        tell_estimates(page, stored["elements"], stored["meshes"])
        tell_global(page, stored["meshes"])
        plots.draw_map(stored["elements"]["results"]["rows"], stored["meshes"]["results"]["rows"],
                       page.images / "map.svg")
    if "shells" in stored:
        tell_shells(page, stored["shells"])
    if "blow_ups" in stored or "contact" in stored:
        tell_margins(page, stored.get("blow_ups"), stored.get("contact"))
    if "long_runs" in stored:
        tell_long_runs(page, stored["long_runs"])
    if "precisions" in stored:
        tell_precisions(page, stored["precisions"])
    if "impacts" in stored:
        tell_impacts(page, stored["impacts"])
    page.texts["seconds"] = ", ".join(f"{name} {study['seconds']:.0f} s" for name, study in stored.items())
    text = (HERE / "page.md").read_text()
    for name, value in page.texts.items():
        text = text.replace(f"<<{name}>>", value)
    text = re.sub("<<[a-z_]+>>", "*(not measured)*", text)
    docs.mkdir(parents=True, exist_ok=True)
    (docs / "stability.md").write_text(text)
    return page.wrong
