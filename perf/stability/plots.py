"""Figures of docs/stability.md, as SVG."""
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
matplotlib.rcParams["svg.hashsalt"] = "percuss"  # the same file for the same numbers
matplotlib.rcParams["svg.fonttype"] = "none"
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
from images import shrink  # noqa: E402
from scenes import MESH_STEP, OFF  # noqa: E402

COLORS = {"assumed strain": "#0b6fb8", "stiffness": "#d1495b", "viscous": "#e09f3e", "full": "#3c8d53",
          MESH_STEP: "#444444"}
VERDICTS = {"good": "#3c8d53", "coarse": "#e6c229", "named": "#5b8fd6", "hang": "#8b1e3f", "crash": "#000000"}


def save(figure, path):
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, metadata={"Date": None}, bbox_inches="tight")
    shrink(path)
    plt.close(figure)


def draw_map(elements, meshes, path):
    """Bound over truth by family of shapes: the range and the median of each kind of element."""
    figure, panels = plt.subplots(1, 2, figsize=(11, 3.8), sharey=True)
    for axes, rows, title in zip(panels, (elements, meshes), ("single elements", "meshes of 27 elements")):
        rows = [row for row in rows if row["damping"] == "none"]
        families = list(dict.fromkeys(row["family"] for row in rows))
        kinds = list(dict.fromkeys(row["kind"] for row in rows))
        for i, kind in enumerate(kinds):
            for j, family in enumerate(families):
                ratio = [row["ratio"] for row in rows if row["kind"] == kind and row["family"] == family]
                x = j + 0.18 * (i - (len(kinds) - 1) / 2)
                axes.plot([x, x], [min(ratio), max(ratio)], color=COLORS[kind], lw=4, solid_capstyle="butt", alpha=0.55,
                          label=kind if j == 0 else None)
                axes.plot(x, np.median(ratio), "_", color=COLORS[kind], ms=9, mew=2.5)
        axes.axhline(1, color="k", lw=0.8)
        axes.set_xticks(range(len(families)), families, rotation=25, ha="right", fontsize=8)
        axes.set_title(title, fontsize=9)
        axes.grid(axis="y", alpha=0.3)
    panels[0].set_ylabel("step bound / critical step")
    panels[0].set_ylim(0.5, 1.03)
    panels[0].legend(ncol=2, fontsize=8, loc="lower left")
    figure.subplots_adjust(wspace=0.05)
    save(figure, path)


def draw_margins(rows, path):
    """The largest stable share of the bound of each scene, by kind of element."""
    scenes = list(dict.fromkeys(row["scene"] for row in rows))
    kinds = list(dict.fromkeys(row["kind"] for row in rows))
    figure, axes = plt.subplots(figsize=(8.5, 0.42 * len(scenes) + 1.2))
    for row in rows:
        if row["contact"] not in ("", OFF):
            continue
        y = scenes.index(row["scene"]) + 0.16 * (kinds.index(row["kind"]) - (len(kinds) - 1) / 2)
        axes.plot(row["largest"], y, "o" if row["is_limit"] else ">", color=COLORS[row["kind"]], ms=5,
                  fillstyle="full" if row["contact"] == "" else "none")
    for i, kind in enumerate(kinds):
        axes.plot([], [], "o", color=COLORS[kind], label=kind, ms=5)
    axes.plot([], [], "o", color="k", fillstyle="none", label="without contact", ms=5)
    axes.axvline(1, color="k", lw=1)
    axes.axvline(0.9, color="k", lw=1, ls="--")
    axes.text(0.9, -0.75, "default 0.9 ", ha="right", fontsize=8)
    axes.text(1.0, -0.75, " bound", ha="left", fontsize=8)
    axes.set_yticks(range(len(scenes)), scenes)
    axes.invert_yaxis()
    axes.set_ylim(len(scenes) - 0.4, -1.1)
    axes.set_xlabel("largest stable step / step bound")
    axes.set_xlim(0.6, 2.6)
    axes.grid(axis="x", alpha=0.3)
    axes.legend(fontsize=8, ncol=len(kinds) + 1, loc="upper center", bbox_to_anchor=(0.5, -0.5 / len(scenes) - 0.06))
    save(figure, path)


def draw_drift(rows, path):
    """Energy error over a million steps."""
    figure, axes = plt.subplots(figsize=(8.5, 3.4))
    styles = dict(zip(dict.fromkeys(row["run"] for row in rows),
                      ("-", "--", "-.", ":", (0, (1, 3)), (0, (5, 1, 1, 1, 1, 1)))))
    for row in rows:
        if "curve" not in row:
            continue
        error = np.abs(np.array(row["curve"]["energy_error"]))
        axes.semilogy(row["curve"]["step"], np.maximum(error, 1e-16), linestyle=styles[row["run"]],
                      color=COLORS[row["kind"]], lw=1, label=f"{row['run']}, {row['kind']}")
    axes.set_xlabel("step")
    axes.set_ylabel("energy error")
    axes.grid(alpha=0.3)
    axes.legend(fontsize=7, loc="center left", bbox_to_anchor=(1.01, 0.5))
    save(figure, path)


def draw_impacts(rows, path):
    """How each impact ends: a row a case, a column a speed."""
    kinds = list(dict.fromkeys(row["kind"] for row in rows))
    cases = list(dict.fromkeys((row["target"], row["material"]) for row in rows))
    speeds = sorted({row["speed"] for row in rows})
    figure, panels = plt.subplots(1, len(kinds), figsize=(2.3 * len(kinds) + 1.6, 0.32 * len(cases) + 1.3), sharey=True,
                                  squeeze=False)
    for panel, kind in zip(panels[0], kinds):
        for row in rows:
            if row["kind"] != kind:
                continue
            x, y = speeds.index(row["speed"]), cases.index((row["target"], row["material"]))
            panel.add_patch(plt.Rectangle((x - 0.47, y - 0.46), 0.94, 0.92, color=VERDICTS[row["verdict"]], lw=0))
        panel.set_xlim(-0.5, len(speeds) - 0.5)
        panel.set_ylim(len(cases) - 0.5, -0.5)
        panel.set_xticks(range(len(speeds)), [f"{speed:g}" for speed in speeds], fontsize=7, rotation=60)
        panel.set_title(kind, fontsize=9)
        panel.set_xlabel("speed / wave speed", fontsize=8)
    panels[0][0].set_yticks(range(len(cases)), [f"{target}, {material}" for target, material in cases], fontsize=8)
    names = {"good": "done, energy within 1 %", "coarse": "done, energy off by 1 to 10 % or internal energy negative",
             "named": "stopped, cause named", "hang": "hang", "crash": "crash"}
    found = [verdict for verdict in VERDICTS if any(row["verdict"] == verdict for row in rows)]
    figure.legend([plt.Rectangle((0, 0), 1, 1, color=VERDICTS[v]) for v in found], [names[v] for v in found],
                  fontsize=8, ncol=len(found), loc="lower center", bbox_to_anchor=(0.5, -0.12))
    save(figure, path)
