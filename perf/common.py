"""Whole scenes as benchmarks: what is run, and what one run says."""
import json
import os
import pathlib
import resource
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]

# Deck, settings of a full run, settings of a quick one. Few steps of many elements: a start is not what is measured.
SCENES = {
    "block": ("perf/block/deck.yaml", {"time.max_steps": 200}, {"time.max_steps": 60}),
    "block_stiffness": ("perf/block/deck.yaml", {"time.max_steps": 200, "elements.hourglass": "stiffness"},
                        {"time.max_steps": 60}),
    "block_full": ("perf/block/deck.yaml", {"time.max_steps": 80, "elements.integration": "full"},
                   {"time.max_steps": 25}),
    "wave_into_rest": ("perf/wave_into_rest/deck.yaml", {"time.max_steps": 300}, {"time.max_steps": 100}),
    "brick_wall": ("inputs/brick_wall/deck.yaml", {"time.max_steps": 400}, {"time.max_steps": 60}),
    "brick_wall_early": ("inputs/brick_wall/deck.yaml", {"time.max_steps": 60, "parts.rod.at": "[-0.83, 0.73, 0.63]"},
                         {"time.max_steps": 20}),
    "can_crush": ("inputs/can_crush/deck.yaml", {"time.max_steps": 1500}, {"time.max_steps": 400}),
    "taylor_bar": ("inputs/taylor_bar/deck.yaml", {"time.max_steps": 1500}, {"time.max_steps": 400}),
    "sphere_drop": ("inputs/elastic_sphere_drop/deck.yaml", {}, {"time.max_steps": 300}),
    "can_crush_shells": ("inputs/can_crush_shells/deck.yaml", {"time.max_steps": 1500}, {"time.max_steps": 400}),
    "square_tube_crush": ("inputs/square_tube_crush/deck.yaml", {"time.max_steps": 1000}, {"time.max_steps": 300}),
    "container_drop": ("inputs/container_drop/deck.yaml", {"time.max_steps": 200}, {"time.max_steps": 60}),
    "rock_blast": ("inputs/rock_blast/deck.yaml", {"time.max_steps": 150}, {"time.max_steps": 40}),
    "crushed_block": ("perf/crushed_block/deck.yaml", {}, {"time.max_steps": 1500}),
    "soft_stack": ("perf/soft_stack/deck.yaml", {}, {"time.max_steps": 800}),
    "stacked_sheets": ("perf/stacked_sheets/deck.yaml", {}, {"time.max_steps": 300}),
    "rod_through_plates": ("inputs/rod_through_plates/deck.yaml", {"time.max_steps": 1500}, {"time.max_steps": 500}),
}
CONTACT = ["contact_rcb", "contact_search", "contact_check", "contact_enforce"]


def find_settings(scene, quick):
    _, full, short = SCENES[scene]
    return dict(full, **short) if quick else full


AT_END = ["--set", "output.checkpoint.at_end=false"]  # writing a checkpoint is no part of a step


def time_command(command, environment):
    """The finished process and the processor time of its user code."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    done = subprocess.run(command, env=environment, stdin=subprocess.DEVNULL, capture_output=True, text=True,
                          errors="replace")
    return done, resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def run_scene(percuss, scene, quick, folder, threads=1, ranks=1, mpirun=""):
    """One run; its summary, with the processor time of its user code as user_s:
    that of the whole run, its start included."""
    shutil.rmtree(folder, ignore_errors=True)
    command = [str(percuss), "run", str(ROOT / SCENES[scene][0]), "--quiet", "--force", "--out", str(folder)]
    for key, value in find_settings(scene, quick).items():
        command += ["--set", f"{key}={value}"]
    if ranks > 1:
        command = mpirun.split() + ["-n", str(ranks)] + command
    environment = dict(os.environ, OMP_NUM_THREADS=str(threads), OMP_PROC_BIND="false")
    done, user_s = time_command(command + AT_END, environment)
    if done.returncode == 2 and "unknown key 'at_end'" in done.stderr:  # an older program, which writes none
        done, user_s = time_command(command, environment)
    if done.returncode != 0:
        sys.exit(f"{pathlib.Path(sys.argv[0]).name}: error: exit code {done.returncode} of: "
                 f"{' '.join(command)}\n{done.stderr}")
    return dict(json.loads((pathlib.Path(folder) / "summary.json").read_text()), user_s=user_s)


def grind(summary):
    """Nanoseconds of a core per element and step, over the whole loop."""
    return 1e9 * summary["loop_s"] * summary["threads"] * summary["ranks"] / (summary["elements"] * summary["steps"])


def grind_beside_others(summary):
    """Times by processor time: other work on the machine takes none of it, but the start of the run counts."""
    return 1e9 * summary["user_s"] / (summary["elements"] * summary["steps"])


def contact_share(summary):
    return sum(summary["phases_s"][phase] for phase in CONTACT) / summary["loop_s"]
