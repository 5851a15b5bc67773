"""Cores and memory of this machine, and what a process of it takes."""

import os


def count_cores() -> int:
    """Cores that this process may use: affinity and the quota of a container both count,
    as in scripts/available_cores."""
    cores = len(os.sched_getaffinity(0))
    try:
        with open("/sys/fs/cgroup/cpu.max", encoding="ascii") as file:
            quota, period = file.read().split()
        return max(1, min(cores, -(-int(quota) // int(period))))
    except (OSError, ValueError):
        return cores


def find_free_memory() -> int | None:
    """Bytes that new processes may take, by the machine and by the limit of a container; None where it is not known."""
    free = _read_field("/proc/meminfo", "MemAvailable")
    try:
        with open("/sys/fs/cgroup/memory.max",
                  encoding="ascii") as limit, open("/sys/fs/cgroup/memory.current", encoding="ascii") as now:
            left = int(limit.read()) - int(now.read())
        return left if free is None else min(free, left)
    except (OSError, ValueError):  # "max": no limit
        return free


def find_memory(process: int) -> tuple[int, int]:
    """(bytes now, largest so far) of a process; zeros where it has ended."""
    path = f"/proc/{process}/status"
    return _read_field(path, "VmRSS") or 0, _read_field(path, "VmHWM") or 0


def _read_field(path: str, name: str) -> int | None:
    try:
        with open(path, encoding="ascii", errors="replace") as file:
            return next((1024 * int(line.split()[1]) for line in file if line.startswith(name + ":")), None)
    except (OSError, ValueError, IndexError):
        return None
