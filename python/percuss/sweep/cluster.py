"""A job array of Slurm that runs a design in each task."""

import shlex


def write_job_array(words: list[str], count: int, at_once: int, threads: int) -> str:
    """words: the command, without --job-array.
    The table follows when the same command is called after the array has ended."""
    command = shlex.join(words)
    lines = ["#!/bin/bash", "#SBATCH --job-name=percuss_sweep",
             f"#SBATCH --array=1-{count}" + (f"%{at_once}" if at_once else ""),
             "#SBATCH --ntasks=1", f"#SBATCH --cpus-per-task={threads}", "#SBATCH --output=percuss_sweep_%a.log",
             "# Save this text as sweep.sh, then: sbatch sweep.sh. "
             "All nodes must see the deck and the folder of the results.",
             "# After the array has ended, this command makes the table (finished designs are not run again):",
             f"#   {command}",
             f'exec {command} --only "$SLURM_ARRAY_TASK_ID" --jobs 1 --threads "$SLURM_CPUS_PER_TASK"']
    return "\n".join(lines) + "\n"
