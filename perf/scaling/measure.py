"""Runs a point (a scene on a number of ranks) and reads what it leaves."""
import json
import os
import pathlib
import statistics
import subprocess
import sys
from typing import NamedTuple

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


class Run(NamedTuple):
    summary: dict
    ranks: list  # a row a rank, of the whole run
    mpi: list  # a row a rank of MPI calls, empty if they were not counted


def read_run(out):
    counts = out / "mpi_counts.csv"
    return Run(json.loads((out / "summary.json").read_text()), read_table(out / "ranks.csv"),
               read_table(counts) if counts.exists() else [])


def subtract(rows, before):
    return [{name: value - first[name] for name, value in row.items()} for row, first in zip(rows, before)]


def make_start(run):
    """As if of no steps: nothing is subtracted."""
    def clear(rows):
        return [dict.fromkeys(row, 0) for row in rows]

    return Run({**run.summary, "steps": 0}, clear(run.ranks), clear(run.mpi))


def compare(run, before):
    """What the steps between the ends of two runs of one point take, per step: microseconds of work a rank, messages,
    bytes. Start, first search and the look for missed contact at the end are in both."""
    summary, steps = run.summary, run.summary["steps"] - before.summary["steps"]

    def count(name):
        done = [one.summary["steps"] * (1 - one.summary["skipped"][name]) for one in (run, before)]
        return (done[0] - done[1]) / steps

    point = {"elements": summary["elements"], "steps": steps, "ranks": summary["ranks"],
             "contact_points": summary["contact_nodes"] + summary["contact_faces"],
             "searches": count("searches"), "rebalances": count("rebalances"),
             "element_imbalance": summary["balance"]["elements"],
             "contact_imbalance": summary["decomposition"]["worst_imbalance"],
             "ghost_faces": summary["decomposition"]["ghost_faces"] / max(1, summary["contact_faces"]),
             "rounds_per_cut": summary["decomposition"]["rounds_per_cut"], "state_hash": summary["state_hash"]}
    rows, mpi = subtract(run.ranks, before.ranks), subtract(run.mpi, before.mpi)

    def note(name, values):
        point[name + "_mean"], point[name + "_max"] = statistics.fmean(values), max(values)

    def spent(row, phases):
        return 1e6 / steps * sum(row["compute_" + phase] for phase in phases)

    note("fe_us", [spent(row, FE_PHASES) for row in rows])
    note("contact_us", [spent(row, CONTACT_PHASES) for row in rows])
    for phase in PHASES:
        point[phase + "_us"] = statistics.fmean(spent(row, [phase]) for row in rows)
    for name in "halo_messages", "halo_bytes", "contact_messages", "contact_bytes":  # ranks.csv has them per step
        totals = [[row[name] * one.summary["steps"] for row in one.ranks] for one in (run, before)]
        note(name, [(last - first) / steps for last, first in zip(*totals)])
    for name in ("messages", "bytes", "collectives", "hops") if mpi else ():
        point["mpi_" + name] = max(row[name] for row in mpi) / steps
    return point


def run_point(options, deck, series, ranks):
    """The medians of several runs of one point. Kind "whole": the mesh of so many ranks, on one."""
    scene, kind, mode, size = series
    repeats = options.repeats if ranks <= options.repeat_up_to else 1
    used_ranks = 1 if kind == "whole" else ranks

    def run_to(step):
        settings = find_settings(scene, kind, mode, size, ranks, step)
        return [run for _ in range(repeats) for run in run_copies(options, deck, used_ranks, settings)]

    whole = run_to(options.after + options.steps)
    befores = run_to(options.after) if options.after > 0 else [make_start(run) for run in whole]
    runs = [compare(run, before) for run, before in zip(whole, befores)]
    if len({run["state_hash"] for run in runs}) > 1:
        sys.exit(f"scaling: error: runs of {scene} on {ranks} ranks differ in their last state")
    point = {"scene": scene, "kind": kind, "mode": mode, "size": size}
    for name, value in runs[0].items():
        point[name] = value if isinstance(value, str) else statistics.median(run[name] for run in runs)
    point["ranks"] = ranks
    return point
