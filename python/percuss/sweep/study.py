"""Runs the designs of a deck beside each other, each once: a finished run is known again by the deck that was run.

A design has its folder by the content of its deck: the values that `percuss check --json` gives, with --set applied,
and the files that they name. So a run that is there is found again whatever the order or the number of designs,
and another deck never takes its place."""

from __future__ import annotations

import hashlib
import json
import os
import signal
import subprocess
import tempfile
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any

from ..errors import NotResults
from ..program import find_program
from ..results.lock import is_active
from ..results.run import Run
from .designs import Design
from .machine import count_cores, find_free_memory, find_memory

DIGITS = 12  # of the digest in the name of a folder
SPARE = 1.2  # free memory over the estimate of a run
ELEMENTS_A_THREAD = 1000  # as a run chooses its threads
PAUSE = 0.02  # seconds between two checks of the runs
PATIENCE = 60  # seconds that interrupted runs have for their checkpoint
READ_AT_ONCE = 1 << 20


class Result:
    """What became of a design. state: completed, failed, refused, interrupted, elsewhere (another process runs it),
    waiting. run: a Run, or None; was_there: it had been finished before."""

    def __init__(self, design: Design, state: str = "waiting", folder: str = "", error: str = "",
                 was_there: bool = False) -> None:
        self.design, self.state, self.folder, self.error, self.was_there = design, state, folder, error, was_there

    @property
    def run(self) -> Run | None:
        return (Run(self.folder)
                if self.folder and os.path.isdir(self.folder) and self.state in ("completed", "failed") else None)

    @property
    def warnings(self) -> list[dict[str, Any]]:
        """The warnings of its run, as summary.json has them."""
        return self.run.warnings if self.run else []


class Study:
    """deck: its path. folder: where the runs go. settings: what --set gives all designs. jobs, threads: 0 for as many
    as cores and memory allow. retry: whether failed runs are run again. follow(result): called when a design has ended.
    judge(scene): called with what percuss check --json says of the first design, before anything runs;
    an exception of it ends the study."""

    def __init__(self, deck: str | os.PathLike[str], folder: str | os.PathLike[str], settings: Iterable[str] = (),
                 jobs: int = 0, threads: int = 0, retry: bool = False, follow: Callable[[Result], None] | None = None,
                 libraries: Iterable[str] = (), judge: Callable[[dict[str, Any]], None] | None = None) -> None:
        self.deck, self.folder, self.settings = os.fspath(deck), os.fspath(folder), list(settings)
        self.libraries = list(libraries)  # with laws of the user, which may be loaded
        self.jobs, self.threads, self.retry, self.follow = jobs, threads, retry, follow
        self.judge = judge
        self.program, self.cores = find_program(), count_cores()
        self.peak = 0  # bytes that the largest run so far has taken
        if not os.path.isfile(self.deck):
            raise NotResults(f"{deck}: there is no such deck")

    def run(self, designs: Sequence[Design]) -> list[Result]:
        """Results in the order of the designs.
        A KeyboardInterrupt passes through after the runs have written their checkpoints."""
        os.makedirs(self.folder, exist_ok=True)
        results, waiting, active = dict[int, Result](), list(designs), list[_Work]()
        try:
            while waiting or active:
                while waiting and self._may_start(active):
                    active.append(_Work(self, waiting.pop(0), self._share(len(waiting) + 1, len(active))))
                for work in [work for work in active if work.advance()]:
                    active.remove(work)
                    results[work.design.number] = work.result
                    self.peak = max(self.peak, work.peak)
                    if self.follow:
                        self.follow(work.result)
                time.sleep(PAUSE)
        finally:
            _stop(active)
        return [results[design.number] for design in designs]

    def _may_start(self, active: list[_Work]) -> bool:
        """By cores first, then by memory: what is free must hold what the active runs may still take, and one more.
        What a run takes is known when the first one has begun to step."""
        if not active:
            return True
        if len(active) >= (self.jobs or self.cores // max(1, self.threads) or 1):
            return False
        now = [find_memory(work.process.pid) for work in active]
        peak = max(self.peak, *(most for _, most in now))
        if self.jobs:
            return True
        if not self.peak and not any(work.has_begun() for work in active):
            return False
        free = find_free_memory()
        return free is None or free > SPARE * peak + sum(max(0, peak - held) for held, _ in now)

    def _share(self, left: int, active: int) -> int:
        """Threads of the next run: the cores by as many runs as there will be at once."""
        at_once = min(self.jobs or self.cores, left + active)
        free = find_free_memory()
        if self.peak and free is not None and not self.jobs:
            at_once = max(1, min(at_once, active + int(free / (SPARE * self.peak))))
        return max(1, self.cores // at_once)


def digest_deck(values: dict[str, Any], deck: str) -> str:
    """A hexadecimal number of the values and of the files that they name, wherever the deck lies."""
    folder, digest = os.path.dirname(os.path.abspath(deck)), hashlib.sha256()
    digest.update(json.dumps(_unify(values), sort_keys=True, separators=(",", ":")).encode())
    for path in sorted(set(_list_files(values, folder))):
        digest.update(b"\0")
        with open(path, "rb") as file:
            while piece := file.read(READ_AT_ONCE):
                digest.update(piece)
    return digest.hexdigest()


def _unify(values: Any) -> Any:
    """The same with equal numbers written equally: 3 of 3.0."""
    if isinstance(values, dict):
        return {key: _unify(value) for key, value in values.items()}
    if isinstance(values, list):
        return [_unify(value) for value in values]
    return int(values) if isinstance(values, float) and values.is_integer() else values


def _list_files(values: Any, folder: str) -> Iterator[str]:
    for key, value in values.items() if isinstance(values, dict) else enumerate(values):
        if isinstance(value, (dict, list)):
            yield from _list_files(value, folder)
        elif key == "file" and isinstance(value, str) and os.path.isfile(os.path.join(folder, value)):
            yield os.path.join(folder, value)


class _Work:
    """A design under way: first its check, then its run. result: when advance() has said that it has ended."""

    def __init__(self, study: Study, design: Design, threads: int) -> None:
        self.study, self.design, self.share, self.threads = study, design, threads, 1
        self.result, self.peak, self.folder, self.is_restart = Result(design), 0, "", False
        self._start("check", study.deck, "--json", *self._settings())
        self.next: Callable[[int, str, str], None] = self._end_check

    def _settings(self) -> list[str]:
        allowed = [word for library in self.study.libraries for word in ("--allow-library", library)]
        return [*allowed,
                *(word for setting in [*self.study.settings, *self.design.settings] for word in ("--set", setting))]

    def _start(self, *words: str) -> None:
        """In a group of its own: a Ctrl-C at the terminal reaches this process alone, which passes it on."""
        environment = dict(os.environ, OMP_NUM_THREADS=str(self.threads), OMP_PROC_BIND="false")
        self.out, self.errors = tempfile.TemporaryFile(), tempfile.TemporaryFile()
        self.process = subprocess.Popen([self.study.program, *words], stdin=subprocess.DEVNULL, stdout=self.out,
                                        stderr=self.errors, env=environment, start_new_session=True)

    def advance(self) -> bool:
        """Whether it has ended."""
        if self.folder:
            self.peak = max(self.peak, find_memory(self.process.pid)[1])
        code = self.process.poll()
        if code is None:
            return False
        self.out.seek(0)
        self.errors.seek(0)
        out, errors = (file.read().decode("utf-8", "replace") for file in (self.out, self.errors))
        self.out.close()
        self.errors.close()
        self.next(code, out, errors)
        return self.result.state != "waiting"

    def has_begun(self) -> bool:
        """Whether the run steps: it holds what it will hold."""
        return bool(self.folder) and os.path.exists(os.path.join(self.folder, "summary.json"))

    def _finish(self, state: str, error: str = "", was_there: bool = False) -> None:
        self.result = Result(self.design, state, self.folder, error, was_there)

    def _end_check(self, code: int, out: str, errors: str) -> None:
        if code != 0:
            self._finish("refused" if code == 2 else "failed", _find_reason(errors, code))
            return
        try:
            scene = json.loads(out)
            values, elements = scene["values"], scene["elements"]
        except (ValueError, KeyError) as error:
            self._finish("failed", f"percuss check gives no values ({error})")
            return
        if self.study.judge:
            self.study.judge(scene)
            self.study.judge = None
        self.threads = self.study.threads or max(1, min(self.share, elements // ELEMENTS_A_THREAD))
        self.folder = os.path.join(self.study.folder, f"run_{digest_deck(values, self.study.deck)[:DIGITS]}")
        self._start_run(values)

    def _start_run(self, values: dict[str, Any]) -> None:
        status = _find_status(self.folder, values)
        if status == "running":
            self._finish("elsewhere", "another process runs it now")
            return
        if status == "completed" or status == "failed" and not self.study.retry:
            self._finish(status, Run(self.folder).summary.get("error", ""), True)
            return
        if status in ("interrupted", "killed") and os.path.exists(os.path.join(self.folder, "checkpoint.h5")):
            self.is_restart = True
            self._start("run", self.study.deck, "--quiet", *self._settings(), "--restart", self.folder)
        else:
            self._start("run", self.study.deck, "--quiet", *self._settings(), "--out", self.folder, "--force")
        self.next = self._end_run

    def _end_run(self, code: int, _out: str, errors: str) -> None:
        if code == 2 and self.is_restart:  # the checkpoint is no good: from the start
            self.is_restart = False
            self._start("run", self.study.deck, "--quiet", *self._settings(), "--out", self.folder, "--force")
            return
        states = {0: "completed", 2: "refused", 130: "interrupted"}
        self._finish(states.get(code, "failed"), "" if code == 0 else _find_reason(errors, code))


def _find_status(folder: str, values: dict[str, Any]) -> str:
    """The status of the run in a folder; empty if there is none of this deck."""
    try:
        if is_active(folder):
            return "running"
        run = Run(folder)
        return run.status if run.summary.get("deck", {}).get("values") == values else ""
    except NotResults:
        return ""


def _find_reason(errors: str, code: int) -> str:
    """The last error that percuss has printed, in a line."""
    lines = [line.strip() for line in errors.splitlines() if line.strip()]
    found = [line for line in lines if "error:" in line] or lines[-1:]
    return found[0] if found else f"exit code {code}"


def _stop(active: list[_Work]) -> None:
    """Runs write a checkpoint and end; those that take too long are killed. What is left resumes."""
    for work in active:
        if work.process.poll() is None:
            work.process.send_signal(signal.SIGINT)
    end = time.monotonic() + PATIENCE
    try:
        for work in active:
            work.process.wait(max(0.1, end - time.monotonic()))
    except (subprocess.TimeoutExpired, KeyboardInterrupt):
        for work in active:
            work.process.kill()
            work.process.wait()
