"""run.lock: whether a run writes into a folder now (docs/output.md, "One run at a time")."""

import os
import time

SILENT_AFTER = 60  # seconds without a touch (one is due every ten) after which a run elsewhere counts as ended


def read_lock(folder: str) -> dict[str, str]:
    """The entries of run.lock; empty if there is none."""
    path = os.path.join(folder, "run.lock")
    if not os.path.isfile(path):  # a pipe would be waited for
        return {}
    try:
        with open(path, encoding="utf-8", errors="replace") as file:
            pairs = (line.rstrip("\n").partition(": ") for line in file)
            return {key: value for key, _, value in pairs}
    except OSError:
        return {}


def is_active(folder: str) -> bool:
    """Whether the run of the lock goes on, as far as this machine can see."""
    lock = read_lock(folder)
    if not lock:
        return False
    if lock.get("boot") == _read("/proc/sys/kernel/random/boot_id") and lock.get("pid_namespace") == _own_namespace():
        return _find_start(lock.get("process", "")) == lock.get("process_start")
    try:
        return time.time() - os.stat(os.path.join(folder, "run.lock")).st_mtime < SILENT_AFTER
    except OSError:
        return False


def _read(path: str) -> str:
    try:
        with open(path, encoding="ascii", errors="replace") as file:
            return file.read().strip()
    except OSError:
        return ""


def _own_namespace() -> str:
    try:
        return os.readlink("/proc/self/ns/pid")
    except OSError:
        return ""


def _find_start(process: str) -> str:
    """The start time of a process as the system counts it; empty if there is none. A zombie has ended."""
    words = _read(f"/proc/{process}/stat").rpartition(")")[2].split()
    return words[19] if len(words) > 19 and words[0] != "Z" else ""
