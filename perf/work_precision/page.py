"""The section of docs/notes_performance.md: a figure and a table a scene, and the choice that is best in each."""
import pathlib
import shutil

import numpy as np

import plots

BEGIN = "<!-- work-precision: written by perf/work_precision/run -->"
END = "<!-- work-precision: end -->"


def group(points):
    """Points by choice, coarsest first."""
    curves = {}
    for point in points:
        curves.setdefault(point.choice, []).append(point)
    return {choice: sorted(curve, key=lambda point: point.elements) for choice, curve in curves.items()}


def find_time(curve, error):
    """Seconds that a choice needs for an error: along the straight line through its points in log-log. None: its slope
    says nothing (a single mesh, or errors that do not fall) and no mesh of it is as good."""
    seconds, errors = np.array([p.seconds for p in curve]), np.array([p.error for p in curve])
    good = seconds[errors <= error]
    if len(curve) < 2 or np.any(errors <= 0):
        return float(good.min()) if len(good) else None
    slope, start = np.polyfit(np.log(errors), np.log(seconds), 1)
    if slope >= 0:
        return float(good.min()) if len(good) else None
    return float(np.exp(start + slope * np.log(error)))


def compare(points):
    """The error that all are compared at, the middle one of the default's; seconds for it by choice, fewest first."""
    curves = group(points)
    errors = sorted(point.error for point in curves["default"])
    error = errors[len(errors) // 2]
    times = {choice: find_time(curve, error) for choice, curve in curves.items()}
    known = sorted((seconds, choice) for choice, seconds in times.items() if seconds is not None)
    return error, known, [choice for choice, seconds in times.items() if seconds is None]


def draw_scene(options, name, scene, points):
    def draw(axes):
        for i, (choice, curve) in enumerate(group(points).items()):
            style = {"color": "black", "linewidth": 2} if choice == "default" else {"color": f"C{i}"}
            axes.loglog([p.seconds for p in curve], [p.error for p in curve], "o-", markersize=3, label=choice, **style)
        axes.set(xlabel="run time [s], one core", ylabel="relative error")
        axes.legend(fontsize=7)

    plots.save(options.out / "figures" / f"work_precision_{name}.svg", draw, 6.0, 3.4)


def write_scene(name, scene, points):
    error, known, unknown = compare(points)
    text = f"### {scene.title}\n\nThe error is that of {scene.error}.\n\n"
    text += f"![{scene.title}: error against run time](images/performance/work_precision_{name}.svg)\n\n"
    text += "| choice | mesh | elements | steps | run time [s] | error |\n|---|---|---|---|---|---|\n"
    for choice, curve in group(points).items():
        for p in curve:
            text += f"| {choice} | {p.mesh} | {p.elements} | {p.steps} | {p.seconds:.2f} | {p.error:.2e} |\n"
    default = dict((choice, seconds) for seconds, choice in known).get("default")
    text += f"\nRun time for an error of {error:.1e}:\n\n| choice | run time [s] |\n|---|---|\n"
    text += "".join(f"| {choice} | {seconds:.2g} |\n" for seconds, choice in known) + "\n"
    if unknown:
        text += f"No such error with: {', '.join(unknown)}. "
    text += f"**Best: {known[0][1]}**"
    if default and known[0][1] != "default":
        text += f", {default / known[0][0]:.1f} times faster than the default"
    return text + ".\n\n"


def write_section(options, scenes, measured):
    """Writes the figures beside the page and the text between its marks; everything else of the page stays."""
    page = pathlib.Path(options.page)
    images = page.parent / "images" / "performance"
    images.mkdir(parents=True, exist_ok=True)
    text = ""
    for name, points in measured.items():
        draw_scene(options, name, scenes[name], points)
        shutil.copyfile(options.out / "figures" / f"work_precision_{name}.svg", images / f"work_precision_{name}.svg")
        text += write_scene(name, scenes[name], points)
    old = page.read_text() if page.exists() else f"# Performance\n\n## Error against run time\n\n{BEGIN}\n{END}\n"
    if BEGIN not in old or END not in old:
        raise SystemExit(
            f"work_precision: error: {page} has lost the marks between which the section stands: {BEGIN} {END}")
    head, rest = old.split(BEGIN, 1)
    tail = rest.split(END, 1)[1]
    page.parent.mkdir(parents=True, exist_ok=True)
    page.write_text(f"{head}{BEGIN}\n\n{text}{END}{tail}")
