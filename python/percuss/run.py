"""A run: its output folder, of which each file is read when it is first asked for."""

import json
import os
from functools import cached_property

from .columns import read_units
from .deck import find_deck
from .errors import NotResults
from .lock import is_active
from .units import find_units


def read(*folders):
    """The run of an output folder; of several folders a list of runs."""
    runs = [Run(folder) for folder in folders]
    return runs[0] if len(runs) == 1 else runs


class Run:
    """Attributes: folder, name, and, each read when it is first asked for: summary, warnings, status, deck, units, history,
    fields, field_outputs. reload() forgets what has been read, so that a run that goes on can be followed."""

    def __init__(self, folder, deck=None, fields=None):
        """deck: the file of the deck, where the folder does not lead to it. fields: the name of an entry of
        output.field_outputs, whose file `fields` is then."""
        folder = os.fspath(folder)
        self.folder = folder if os.path.isdir(folder) else os.path.dirname(folder) or "."
        self._deck_file, self._fields_name = deck, fields
        if not os.path.isdir(self.folder) or not (self._has("summary.json") or self._has("history.csv") or
                                                  self._has("fields.vtkhdf") or self._has("run.lock") or
                                                  self._has_outputs()):
            raise NotResults(f"{folder}: there are no results of percuss (no summary.json, history.csv or fields.vtkhdf)")

    def _has(self, name):
        return os.path.exists(os.path.join(self.folder, name))

    def _has_outputs(self):
        return any(file.startswith("fields_") and file.endswith(".vtkhdf") for file in os.listdir(self.folder))

    @property
    def name(self):
        return os.path.basename(os.path.abspath(self.folder))

    def reload(self):
        known = bool(self.__dict__.get("deck"))  # a deck stays as it is; the lock that led to it goes with the end of the run
        for name in ("summary", "units", "history", "fields", "field_outputs") + ("deck",) * (not known):
            self.__dict__.pop(name, None)
        return self

    @cached_property
    def summary(self):
        """summary.json as dictionaries; empty where a run has written none yet."""
        path = os.path.join(self.folder, "summary.json")
        if not os.path.exists(path):
            return {}
        try:
            with open(path, encoding="utf-8") as file:
                return json.load(file)
        except (OSError, ValueError) as error:
            raise NotResults(f"{path}: this is no summary of percuss ({error})") from error

    @property
    def warnings(self):
        """A dictionary each: rule, text, place, time, count."""
        return self.summary.get("warnings", [])

    @property
    def status(self):
        """completed, failed, interrupted, running; killed: the summary says running, but no run is here; starting: it has
        only begun."""
        if is_active(self.folder):
            return "running" if self.summary else "starting"
        return {"running": "killed", None: "killed"}.get(self.summary.get("status"), self.summary.get("status"))

    @property
    def step_limit(self):
        """'stopped by time.max_steps at 2.9 % of time.end', or by a sensor; empty where the run came to its end or did not
        complete."""
        time, end = self.summary.get("time") or 0, self.summary.get("end_time") or 0  # older summaries have no end
        if self.status != "completed" or not time < end * (1 - 1e-9):
            return ""
        if sensor := self.summary.get("ended_by"):
            return f"ended by sensor '{sensor}' at t = {time:.6g}, {100 * time / end:.2g} % of time.end"
        return f"stopped by time.max_steps at {100 * time / end:.2g} % of time.end"

    @cached_property
    def deck(self):
        return find_deck(self.folder, self._deck_file)

    @cached_property
    def units(self):
        """The Units of the deck, or None where it has none."""
        if known := read_units(self.folder):
            return find_units(known)
        if self.has_fields:
            return find_units(self.fields.units)
        return find_units(self.deck.get("units", ""))

    @property
    def title(self):
        return self.deck.get("title") or (self.fields.title if self.has_fields else "") or self.name

    @cached_property
    def history(self):
        from .history import read_history

        path = os.path.join(self.folder, "history.csv")
        if not os.path.exists(path):
            raise NotResults(f"{path}: there is no such file (a run writes it where its deck has output.history)")
        return read_history(path, self.units, self.folder)

    @property
    def has_history(self):
        return self._has("history.csv")

    @cached_property
    def fields(self):
        from .fields import Fields

        return Fields(self.folder, self._fields_name)

    @cached_property
    def field_outputs(self):
        """The Fields of each entry of output.field_outputs that has a file with a frame, by its name."""
        from .fields import Fields, list_outputs

        found = {}
        for name in list_outputs(self.folder):
            try:
                found[name] = Fields(self.folder, name)
            except NotResults:  # a run that has just begun
                pass
        return found

    @property
    def has_fields(self):
        try:
            file = f"fields_{self._fields_name}.vtkhdf" if self._fields_name else "fields.vtkhdf"
            return self._has(file) and self.fields is not None
        except (ImportError, NotResults):
            return False

    @property
    def ranks(self):
        """ranks.csv: a dictionary a rank."""
        from .table import read_rows

        names, rows = read_rows(os.path.join(self.folder, "ranks.csv"))
        return [dict(zip(names, row)) for row in rows]
