"""The two scenes of the paper's Figures 7 to 10: which mesh at which number of ranks, in contact from the first steps. And
a third without halo and contact, as a control of the machine."""
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]


def tube_and_box(tube, box):
    return {"parts.container.tube.cells": tube, "parts.plate.box.cells": box}


def brick_and_rod(brick, rod):
    return {"parts.bricks.box.cells": brick, "parts.rod.cylinder.cells": rod}


# Cells of the scaled problems, as the README of each scene has them: ranks times 1890 or 1875 elements.
SCALED_CELLS = {
    "apart": {2**n: {"parts.tubes.array.count": [1, 1, 2**n]} for n in range(7)},
    "brick_wall": {
        1: brick_and_rod([2, 3, 2], [5, 10]),
        2: brick_and_rod([2, 6, 2], [5, 20]),
        4: brick_and_rod([4, 6, 2], [10, 10]),
        8: brick_and_rod([4, 6, 4], [10, 20]),
        16: brick_and_rod([4, 12, 4], [10, 40]),
        32: brick_and_rod([8, 12, 4], [10, 80]),
        64: brick_and_rod([8, 12, 8], [10, 160]),
    },
    "can_crush": {
        1: tube_and_box([3, 16, 34], [9, 9, 3]),
        2: tube_and_box([3, 16, 68], [18, 9, 3]),
        4: tube_and_box([3, 32, 68], [18, 18, 3]),
        8: tube_and_box([6, 32, 68], [18, 18, 6]),
        16: tube_and_box([6, 32, 136], [36, 18, 6]),
        32: tube_and_box([6, 64, 136], [36, 36, 6]),
        64: tube_and_box([12, 64, 136], [36, 36, 12]),
    },
}

# The plate of the can crush begins where it touches the rim, so that there is contact from the first step on; the rod of
# the brick wall arrives within three steps anyway, and its bricks touch from the start.
START_IN_CONTACT = {"apart": {}, "brick_wall": {}, "can_crush": {"parts.plate.at": [-0.26, 0, 0.4]}}

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
CONTROL_STEPS = 200


def list_series(scenes, kinds, modes):
    """Scene, kind and mode of each series of points. modes: empty for what each scene has by default."""
    series = [(CONTROL, "scaled", "when_due")] if CONTROL in scenes and "scaled" in kinds else []
    for scene in scenes:
        if scene != CONTROL:
            series += [(scene, kind, mode) for kind in kinds for mode in modes or DEFAULT_MODES[scene]]
    return series


def find_settings(scene, kind, mode, ranks, steps):
    """The --set options of a point as a dictionary."""
    settings = {"time.max_steps": CONTROL_STEPS if scene == CONTROL else steps}
    settings.update(START_IN_CONTACT[scene])
    settings.update(MODES[mode])
    if kind != "fixed":
        settings.update(SCALED_CELLS[scene][ranks])
    return settings


def write_deck(scene, folder):
    """The deck of a scene without its output, for timing."""
    own = ROOT / "perf" / "scaling" / f"{scene}.yaml"
    text = (own if own.exists() else ROOT / "inputs" / scene / "deck.yaml").read_text()
    deck = pathlib.Path(folder) / f"{scene}.yaml"
    deck.write_text(re.sub(r"^output:\n(?:[ #].*\n)*", "", text, flags=re.MULTILINE))
    return deck
