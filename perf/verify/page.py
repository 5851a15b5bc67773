"""Writes docs/verification.md, the errors by feature, and docs/verification/, a page a group of cases, from all results."""
import pathlib
import re
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


def make_link(case, folder="", text=""):
    return f"[{text or case.title}]({folder}{case.group}.md#{make_anchor(case.title)})"


def write_features(cases, results, folder):
    rows = list_features(cases, results, lambda case, text: make_link(case, folder, text))
    return ("## By feature\n\nErrors of single quantities at stated meshes; "
            "the cases behind the links have the others.\n\n" +
        make_table(["feature", "quantity and mesh: error"], rows))


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
    text = f"## {case.title}\n\n{case.text}\n\n"
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


def count_all(results):
    """A sentence: how many quantities of how many cases are right, and which cases are not."""
    wrong = [f"`{name}`" for name, result in results.items() if not is_right(result)]
    passed, checks = (sum(count(r) for r in results.values()) for count in (count_passed, lambda r: len(r["checks"])))
    outside = f"; outside: {', '.join(wrong)}" if wrong else ""
    return f"{passed} of {checks} quantities of {len(results)} cases are within their tolerances{outside}.\n\n"


def write_groups(cases, results, folder):
    """The list of pages, with what each holds."""
    rows = []
    for group, title in GROUPS.items():
        members = [case for case in cases if case.group == group]
        measured = [results[case.name] for case in members if case.name in results]
        left = f", {len(members) - len(measured)} not run" if len(measured) < len(members) else ""
        rows.append([f"[{title}]({folder}{group}.md)", f"{sum(map(is_right, measured))} of {len(measured)}{left}"])
    return "## Pages\n\n" + make_table(["cases", "within tolerance"], rows)


def move_links(text):
    """A page that is written as if it lay in docs, for a folder below: its links to pages get `../`."""
    return re.sub(r"\]\((?!https?:|#|\.\./)([^)]*\.md)", r"](../\1", text)


def write_all_cases(here, cases, results):
    text = (here / "running.md").read_text() + "\n" + write_overview(cases, results) + "\n"
    runs, seconds = (sum(r[key] for r in results.values()) for key in ("runs", "cpu"))
    return text + f"All together: {runs} runs, {seconds / 60:.1f} minutes.\n"


def copy_figures(options, results, images):
    """Copies the figures of all results beside the page; those that no case has any more go."""
    images.mkdir(parents=True, exist_ok=True)
    known = {figure["file"] for result in results.values() for figure in result["figures"]}
    for old in images.glob("*.svg"):
        if old.name not in known:
            old.unlink()
    for name in sorted(known):
        source = options.out / "figures" / name
        if source.exists():
            shutil.copyfile(source, images / name)


def write_page(options, cases, results):
    """Writes the pages and copies the figures beside them. Returns the names of cases that are not right."""
    page = pathlib.Path(options.page)
    here, below = pathlib.Path(__file__).parent, page.with_suffix("")
    below.mkdir(parents=True, exist_ok=True)
    copy_figures(options, results, page.parent / "images" / "verification")
    results = {case.name: results[case.name] for case in cases if case.name in results}
    folder = below.name + "/"
    text = (here / "introduction.md").read_text() + "\n" + count_all(results)
    page.write_text(text + write_features(cases, results, folder) + "\n" + write_groups(cases, results, folder))
    for old in below.glob("*.md"):
        old.unlink()
    (below / "cases.md").write_text(write_all_cases(here, cases, results))
    for name in ("public_models.md", "open_points.md"):
        (below / name).write_text(move_links((here / name).read_text().rstrip() + "\n"))
    for group, title in GROUPS.items():
        members = [write_case(case, results.get(case.name), "../images/verification")
                   for case in cases if case.group == group]
        (below / f"{group}.md").write_text(f"# {title}\n\n" + move_links("".join(members)).rstrip() + "\n")
    return [name for name, result in results.items() if not is_right(result)]
