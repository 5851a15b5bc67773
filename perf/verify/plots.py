"""Figures of the page: small vector graphics, the same bytes for the same numbers."""
import pathlib
import sys

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1]))
from images import shrink  # noqa: E402

plt.rcParams.update({
    "svg.fonttype": "none", "svg.hashsalt": "percuss", "font.size": 9, "axes.grid": True, "grid.alpha": 0.3,
    "axes.spines.top": False, "axes.spines.right": False, "legend.frameon": False, "lines.linewidth": 1.3,
    "path.simplify_threshold": 0.5,
})
EXACT = {"color": "black", "linewidth": 0.9, "linestyle": "--"}


def save(path, draw, width, height):
    path.parent.mkdir(parents=True, exist_ok=True)
    figure, axes = plt.subplots(figsize=(width, height))
    draw(axes)
    figure.tight_layout()
    figure.savefig(path, metadata={"Date": None}, facecolor="white")
    shrink(path)
    figure.savefig(path.with_suffix(".png"), dpi=80, facecolor="white")
    plt.close(figure)
