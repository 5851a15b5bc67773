"""Runs a point (a scene on a number of ranks) and reads what it leaves."""
import json
import os
import pathlib
import statistics
import subprocess
import sys

from scenes import find_settings

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "python"))
from percuss.results.table import read_rows  # noqa: E402

FE_PHASES = ["internal_force", "halo", "integrate", "reduce"]
CONTACT_PHASES = ["contact_rcb", "contact_search", "contact_check", "contact_enforce"]
PHASES = FE_PHASES + CONTACT_PHASES


def read_table(path):
    """Rows of a CSV file of numbers, as dictionaries."""
    names, rows = read_rows(path)
    return [dict(zip(names, row)) for row in rows]


def count_cores():
    return len(os.sched_getaffinity(0))


def make_command(options, deck, out, ranks, settings):
    command = [options.percuss, "run", str(deck), "--quiet", "--force", "--out", str(out)]
    for key, value in settings.items():
        command += ["--set", f"{key}={value}"]
    if ranks == 1:
        return command
    return options.mpirun.split() + ["-n", str(ranks)] + command


def start_run(options, deck, out, ranks, settings):
    environment = dict(os.environ, OMP_NUM_THREADS="1", OMP_WAIT_POLICY="passive", OMP_PROC_BIND="false")
    if ranks > count_cores():
        environment["OMPI_MCA_mpi_yield_when_idle"] = "1"
    if options.count_mpi:
        environment.update(LD_PRELOAD=options.count_mpi, PERCUSS_MPI_COUNTS=str(out / "mpi_counts.csv"))
    return subprocess.Popen(make_command(options, deck, out, ranks, settings), env=environment,
                            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)


def run_copies(options, deck, ranks, settings):
    """Runs as many copies at once as keep all cores busy, for a core alone is quicker than one beside others."""
    folders = [pathlib.Path(options.work) / f"run_{copy}" for copy in range(max(1, count_cores() // ranks))]
    processes = [start_run(options, deck, folder, ranks, settings) for folder in folders]
    errors = [process.communicate()[1] for process in processes]
    for process, error in zip(processes, errors):
        if process.returncode != 0:
            sys.exit(f"scaling: error: exit code {process.returncode} of: {' '.join(process.args)}\n{error}")
    return [read_run(folder) for folder in folders]


def read_run(out):
    """What one run says, per step: microseconds of work a rank, messages, bytes."""
    summary = json.loads((out / "summary.json").read_text())
    rows = read_table(out / "ranks.csv")
    steps = summary["steps"]
    run = {"elements": summary["elements"], "steps": steps, "ranks": summary["ranks"],
           "contact_points": summary["contact_nodes"] + summary["contact_faces"],
           "searches": 1 - summary["skipped"]["searches"], "rebalances": 1 - summary["skipped"]["rebalances"],
           "element_imbalance": summary["balance"]["elements"],
           "contact_imbalance": summary["decomposition"]["worst_imbalance"],
           "ghost_faces": summary["decomposition"]["ghost_faces"] / max(1, summary["contact_faces"]),
           "rounds_per_cut": summary["decomposition"]["rounds_per_cut"], "state_hash": summary["state_hash"]}

    def note(name, values):
        run[name + "_mean"], run[name + "_max"] = statistics.fmean(values), max(values)

    def spent(row, phases):
        return 1e6 / steps * sum(row["compute_" + phase] for phase in phases)

    note("fe_us", [spent(row, FE_PHASES) for row in rows])
    note("contact_us", [spent(row, CONTACT_PHASES) for row in rows])
    for phase in PHASES:
        run[phase + "_us"] = statistics.fmean(spent(row, [phase]) for row in rows)
    for part in "halo", "contact":
        note(part + "_messages", [row[part + "_messages"] for row in rows])
        note(part + "_bytes", [row[part + "_bytes"] for row in rows])
    if (out / "mpi_counts.csv").exists():
        for name in "messages", "bytes", "collectives", "hops":
            run["mpi_" + name] = max(row[name] for row in read_table(out / "mpi_counts.csv")) / steps
    return run


def run_point(options, deck, series, ranks):
    """The medians of several runs of one point. Kind "whole": the mesh of so many ranks, on one."""
    scene, kind, mode, size = series
    settings = find_settings(scene, kind, mode, size, ranks, options.steps)
    repeats = options.repeats if ranks <= options.repeat_up_to else 1
    used_ranks = 1 if kind == "whole" else ranks
    runs = [run for _ in range(repeats) for run in run_copies(options, deck, used_ranks, settings)]
    if len({run["state_hash"] for run in runs}) > 1:
        sys.exit(f"scaling: error: runs of {scene} on {ranks} ranks differ in their last state")
    point = {"scene": scene, "kind": kind, "mode": mode, "size": size}
    for name, value in runs[0].items():
        point[name] = value if isinstance(value, str) else statistics.median(run[name] for run in runs)
    point["ranks"] = ranks
    return point
