"""A run: its output folder, of which each file is read when it is first asked for."""

from __future__ import annotations

import os
from functools import cached_property
from typing import TYPE_CHECKING, Any

from ..errors import NoFrames, NotResults
from ..files import load_json
from .columns import read_units
from .deck import Deck, find_deck
from .lock import is_active
from .shapes import SUMMARY
from .units import Units, find_units

if TYPE_CHECKING:
    from .fields import Fields
    from .history import History


def read(*folders: str | os.PathLike[str]) -> Any:
    """The run of an output folder; of several folders a list of runs."""
    runs = [Run(folder) for folder in folders]
    return runs[0] if len(runs) == 1 else runs


def describe_limit(status: str, summary: dict[str, Any]) -> str:
    """'stopped by time.max_steps at 2.9 % of time.end', or by a sensor;
    empty where the run came to its end or did not complete."""
    time, end = summary.get("time") or 0, summary.get("end_time") or 0  # older summaries have no end
    if status != "completed" or not time < end * (1 - 1e-9):
        return ""
    if sensor := summary.get("ended_by"):
        return f"ended by sensor '{sensor}' at t = {time:.6g}, {100 * time / end:.2g} % of time.end"
    return f"stopped by time.max_steps at {100 * time / end:.2g} % of time.end"


def label_runs(runs: list[Run]) -> list[str]:
    """The name of each, or its folder where several have one name."""
    names = [run.name for run in runs]
    return [run.name if names.count(run.name) == 1 else run.folder for run in runs]


class Run:
    """Attributes: folder, name, and, each read when it is first asked for: summary, warnings, status, deck, units,
    history, fields, field_outputs. reload() forgets what has been read, so that a run that goes on can be followed."""

    def __init__(self, folder: str | os.PathLike[str], fields: str | None = None) -> None:
        """fields: the name of an entry of output.field_outputs, whose file `fields` is then."""
        folder = os.fspath(folder)
        self.folder = folder if os.path.isdir(folder) else os.path.dirname(folder) or "."
        self._fields_name = fields
        if not os.path.isdir(self.folder) or not (self._has("summary.json") or self._has("history.csv") or
                                                  self._has("fields.vtkhdf") or self._has("run.lock") or
                                                  self._has_outputs()):
            raise NotResults(f"{folder}: there are no results of percuss "
                             "(no summary.json, history.csv or fields.vtkhdf)")

    def _has(self, name: str) -> bool:
        return os.path.exists(os.path.join(self.folder, name))

    def _has_outputs(self) -> bool:
        return any(file.startswith("fields_") and file.endswith(".vtkhdf") for file in os.listdir(self.folder))

    @property
    def name(self) -> str:
        return os.path.basename(os.path.abspath(self.folder))

    def reload(self) -> Run:
        for name in ("summary", "deck", "units", "history", "fields", "field_outputs"):
            self.__dict__.pop(name, None)
        return self

    @cached_property
    def summary(self) -> dict[str, Any]:
        """summary.json as dictionaries; empty where a run has written none yet."""
        path = os.path.join(self.folder, "summary.json")
        found: dict[str, Any] = load_json(path, SUMMARY) if os.path.lexists(path) else {}
        return found

    @property
    def warnings(self) -> list[dict[str, Any]]:
        """A dictionary each: rule, text, place, time, count."""
        return list(self.summary.get("warnings", []))

    @property
    def status(self) -> str:
        """completed, failed, interrupted, running; killed: the summary says running, but no run is here; starting: it
        has only begun."""
        if is_active(self.folder):
            return "running" if self.summary else "starting"
        known = self.summary.get("status")
        return "killed" if known in (None, "running") else str(known)

    @property
    def step_limit(self) -> str:
        return describe_limit(self.status, self.summary)

    @cached_property
    def deck(self) -> Deck:
        return find_deck(self.summary, self.folder)

    @cached_property
    def units(self) -> Units | None:
        """The Units of the deck, or None where it has none."""
        if known := read_units(self.folder):
            return find_units(known)
        if fields := self._find_fields():
            return find_units(fields.units)
        return find_units(str(self.deck.get("units") or ""))

    @property
    def title(self) -> str:
        fields = None if self.deck.get("title") else self._find_fields()
        return str(self.deck.get("title") or (fields.title if fields else "") or self.name)

    def _find_fields(self) -> Fields | None:
        """Where they are a help alone: None where there are none, or damaged ones."""
        try:
            return self.fields if self.has_fields else None
        except NotResults:
            return None

    @cached_property
    def history(self) -> History:
        from .history import read_history

        path = os.path.join(self.folder, "history.csv")
        if not os.path.exists(path):
            raise NotResults(f"{path}: there is no such file (a run writes it where its deck has output.history)")
        return read_history(path, self.units, self.folder)

    @property
    def has_history(self) -> bool:
        return self._has("history.csv")

    @cached_property
    def fields(self) -> Fields:
        from .fields import Fields

        return Fields(self.folder, self._fields_name)

    @cached_property
    def field_outputs(self) -> dict[str, Fields]:
        """The Fields of each entry of output.field_outputs that has a file with a frame, by its name."""
        from .fields import Fields, list_outputs

        found = {}
        for name in list_outputs(self.folder):
            try:
                found[name] = Fields(self.folder, name)
            except NoFrames:  # a run that has just begun
                pass
            except NotResults:
                if not is_active(self.folder):  # which may be writing this file
                    raise
        return found

    @property
    def has_fields(self) -> bool:
        try:
            file = f"fields_{self._fields_name}.vtkhdf" if self._fields_name else "fields.vtkhdf"
            return self._has(file) and self.fields is not None
        except (ImportError, NoFrames):
            return False
        except NotResults:
            if not is_active(self.folder):  # which may be writing it
                raise
            return False

    @property
    def ranks(self) -> list[dict[str, float]]:
        """ranks.csv: a dictionary a rank."""
        from .table import read_rows

        names, rows = read_rows(os.path.join(self.folder, "ranks.csv"))
        return [dict(zip(names, row)) for row in rows]
