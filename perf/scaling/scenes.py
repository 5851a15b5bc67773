"""The two scenes of the paper's Figures 7 to 10: which mesh at which number of ranks, in contact from the first steps.
And a third without halo and contact, as a control of the machine."""
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]


# Elements of a rank in the scaled problems, by the name of their size, and the numbers of ranks of a size (empty: all).
SIZES = {"1900": [], "10000": [1, 8, 64], "30000": [1, 4, 16]}

# Cells of the scaled problems on one rank: a brick and the rod (across, along); the container and the plate; a tube.
CELLS = {
    "brick_wall": {"1900": ([2, 3, 2], [5, 10]), "10000": ([4, 4, 4], [9, 17]), "30000": ([6, 6, 5], [13, 28])},
    "can_crush": {"1900": ([3, 16, 34], [9, 9, 3]), "10000": ([5, 28, 62], [16, 16, 5]),
                  "30000": ([8, 40, 81], [23, 23, 8])},
    "apart": {"1900": [3, 16, 39], "10000": [5, 28, 71], "30000": [8, 40, 94]},
}


def double(cells, axes, doublings):
    """Cells after so many doublings of the directions that axes lists, one after the other."""
    cells = list(cells)
    for i in range(doublings):
        cells[axes[i % len(axes)]] *= 2
    return cells


def find_cells(scene, size, doublings):
    """The cells of a scaled problem on 2^doublings ranks, as the README of each scene has them."""
    own = CELLS[scene][size]
    if scene == "brick_wall":
        across, along = own[1]
        rod = [across, along * 2**doublings] if doublings < 2 else [2 * across, along * 2**(doublings - 2)]
        return {"parts.bricks.box.cells": double(own[0], [1, 0, 2], doublings), "parts.rod.cylinder.cells": rod}
    if scene == "can_crush":
        return {"parts.container.tube.cells": double(own[0], [2, 1, 0], doublings),
                "parts.plate.box.cells": double(own[1], [0, 1, 2], doublings)}
    return {"parts.tubes.tube.cells": own, "parts.tubes.array.count": [1, 1, 2**doublings]}


# The plate of the can crush begins where it touches the rim, so that there is contact from the first step on; the rod
# of the brick wall arrives within three steps anyway, and its bricks touch from the start.
START_IN_CONTACT = {"apart": {}, "brick_wall": {}, "can_crush": {"parts.plate.at": [-0.26, 0, 0.4]}}

# Velocities at the start in place of those of the scene: everything moves, and the wall is pressed together. What rests
# is skipped, and the first steps of a fine mesh would leave most ranks without work.
EVERYTHING_MOVES = {
    "brick_wall": "initial: [{part: rod, velocity: [200, 0, 0]}, {part: bricks, radial_velocity: "
                  "{speed: -10, center: [0.05, 0.73, 0.63], axis: x}}]",
    "can_crush": "initial: [{part: plate, velocity: [0, 0, -120]}, {part: container, velocity: [0, 0, -10]}]",
}

# How contact is divided and searched: "every_step" as in the paper, "when_due" as percuss does by itself.
MODES = {
    "every_step": {"contact.reuse_search": "false", "contact.rebalance": "always"},
    "when_due": {},
}


# One mesh for all numbers of ranks; as many elements per rank; the meshes of "scaled", each on one rank.
KINDS = ["fixed", "scaled", "whole"]

# Steps of the brick wall take long: all bricks are in contact.
DEFAULT_MODES = {"brick_wall": ["when_due"], "can_crush": ["every_step", "when_due"]}

# The control has no contact and costs little.
CONTROL = "apart"
CONTROL_FACTOR = 10  # as many times the steps of the others


def list_series(scenes, kinds, modes, sizes):
    """Scene, kind, mode and size of each series of points. modes: empty for what each scene has by default."""
    series = [(CONTROL, "scaled", "when_due", size) for size in sizes if CONTROL in scenes and "scaled" in kinds]
    for scene in scenes:
        if scene == CONTROL:
            continue
        for size in sizes:
            for kind in kinds:
                if size == "1900":  # the paper's problems, in every mode
                    series += [(scene, kind, mode, size) for mode in modes or DEFAULT_MODES[scene]]
                elif kind != "fixed":
                    series.append((scene, kind, "when_due", size))
    return series


def find_settings(scene, kind, mode, size, ranks, steps):
    """The --set options of a run of so many steps as a dictionary."""
    settings = {"time.max_steps": steps * CONTROL_FACTOR if scene == CONTROL else steps,
                "output.checkpoint.at_end": "false"}
    settings.update(START_IN_CONTACT[scene])
    settings.update(MODES[mode])
    if kind != "fixed":
        settings.update(find_cells(scene, size, ranks.bit_length() - 1))
    return settings


def write_deck(scene, folder):
    """The deck of a scene for timing: without its output, and moving in all its elements."""
    own = ROOT / "perf" / "scaling" / f"{scene}.yaml"
    text = (own if own.exists() else ROOT / "inputs" / scene / "deck.yaml").read_text()
    deck = pathlib.Path(folder) / f"{scene}.yaml"
    text = re.sub(r"^output:\n(?:[ #].*\n)*", "", text, flags=re.MULTILINE)
    deck.write_text(re.sub(r"^initial: .*$", EVERYTHING_MOVES.get(scene, r"\g<0>"), text, flags=re.MULTILINE))
    return deck
