"""Writes docs/verification.md from the results of all cases."""
import pathlib
import shutil

from features import list_features

GROUPS = {
    "exact": "Mass, patch, rotation",
    "waves": "Waves in bars",
    "impact": "Impact of bars and balls",
    "closed": "Closed scenes: momentum and energy",
    "friction": "Friction",
    "rigid": "Rigid blocks",
    "plastic": "Plastic flow",
    "shocks": "Shocks",
    "failure": "Failure and erosion",
    "shells": "Shells",
    "bending": "Bending and near-incompressible material",
    "paper": "The scenes of the parallel-contact paper",
    "hard": "Hard scenes",
}

VERDICTS = {True: "ok", False: "**OUTSIDE**"}


def make_table(heading, rows):
    lines = ["| " + " | ".join(heading) + " |", "|" + "---|" * len(heading)]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join(lines) + "\n"


def show(value, unit=""):
    if value is None:
        return ""
    if isinstance(value, float):
        text = f"{value:.6g}"
    else:
        text = str(value)
    return f"{text} {unit}".strip()


def count_passed(result):
    return sum(check["passed"] for check in result["checks"])


def is_right(result):
    return bool(result["checks"]) and count_passed(result) == len(result["checks"])


def make_anchor(title):
    return "".join(c for c in title.lower().replace(" ", "-") if c.isalnum() or c in "-_")


def make_link(case):
    return f"[{case.title}](#{make_anchor(case.title)})"


def write_features(cases, results):
    rows = list_features(cases, results, make_link)
    return "## By feature\n\nThe error of one quantity at a stated mesh; the case has the others.\n\n" + \
        make_table(["feature", "quantity and mesh", "error", "case"], rows)


def write_overview(cases, results):
    rows = []
    for case in cases:
        result = results.get(case.name)
        link = make_link(case)
        if result is None:
            rows.append([link, "`" + case.name + "`", "", "not run", ""])
        else:
            rows.append([link, "`" + case.name + "`", f"{count_passed(result)} of {len(result['checks'])}",
                         VERDICTS[is_right(result)], f"{result['cpu']:.1f}"])
    return make_table(["case", "name", "within tolerance", "verdict", "run time [s]"], rows)


def write_case(case, result, images):
    text = f"### {case.title}\n\n{case.text}\n\n"
    if result is None:
        return text + "Not run.\n\n"
    rows = [[c["quantity"], show(c["measured"], c["unit"]), show(c["exact"], c["unit"]), c["error"], c["limit"],
             VERDICTS[c["passed"]]] for c in result["checks"]]
    text += make_table(["quantity", "measured", "exact", "error", "tolerance", "verdict"], rows) + "\n"
    for table in result["tables"]:
        text += (table["caption"] + "\n\n" if table["caption"] else "")
        text += make_table(table["heading"], table["rows"]) + "\n"
    for note in result["notes"]:
        text += note + "\n\n"
    for figure in result["figures"]:
        text += f"![{figure['caption']}]({images}/{figure['file']})\n\n*{figure['caption']}*\n\n"
    return text + f"`perf/verify/run --only {case.name}`: {result['runs']} runs, {result['cpu']:.1f} s.\n\n"


def write_page(options, cases, results):
    """Writes the page and copies the figures beside it. Returns the names of cases that are not right."""
    page = pathlib.Path(options.page)
    images = page.parent / "images" / "verification"
    images.mkdir(parents=True, exist_ok=True)
    known = {figure["file"] for result in results.values() for figure in result["figures"]}
    for old in images.glob("*.svg"):
        if old.name not in known:
            old.unlink()
    for name in sorted(known):
        source = options.out / "figures" / name
        if source.exists():
            shutil.copyfile(source, images / name)
    here = pathlib.Path(__file__).parent
    wrong = [case.name for case in cases if case.name in results and not is_right(results[case.name])]
    measured = [result for result in results.values()]
    text = (here / "introduction.md").read_text() + "\n"
    text += f"{sum(count_passed(r) for r in measured)} of {sum(len(r['checks']) for r in measured)} quantities of "
    text += f"{len(measured)} cases are within their tolerances"
    text += f"; outside: {', '.join('`' + name + '`' for name in wrong)}.\n\n" if wrong else ".\n\n"
    text += write_features(cases, results) + "\n"
    text += (here / "running.md").read_text() + "\n"
    text += write_overview(cases, results) + "\n"
    text += f"All together: {sum(r['runs'] for r in measured)} runs, {sum(r['cpu'] for r in measured) / 60:.1f} minutes.\n\n"
    text += (here / "public_models.md").read_text() + "\n"
    for group, title in GROUPS.items():
        text += f"## {title}\n\n"
        for case in cases:
            if case.group == group:
                text += write_case(case, results.get(case.name), "images/verification")
    text += (here / "open_points.md").read_text()
    page.parent.mkdir(parents=True, exist_ok=True)
    page.write_text(text.rstrip() + "\n")
    return wrong
