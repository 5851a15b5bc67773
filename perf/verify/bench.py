"""What a case of verification is, and what it works with: runs, checks, tables and figures."""
import dataclasses
import math
import shutil
from typing import Callable

import numpy as np

import runs


@dataclasses.dataclass
class Case:
    """A problem with a known answer. work(bench) runs it and says what it measured."""
    name: str
    group: str
    title: str
    text: str      # the problem, its answer and where that comes from, why the tolerances are what they are
    work: Callable
    quick: bool    # also in the quick selection


CASES = []


def case(name, group, title, quick=False):
    """Enters a function into the list of cases; its doc string tells the reader what is computed."""

    def enter(work):
        lines = [line.strip() for line in (work.__doc__ or "").strip().splitlines()]
        CASES.append(Case(name, group, title, "\n".join(lines), work, quick))
        return work

    return enter


class CaseFailed(Exception):
    """The rest of a case has no meaning; the failed check is in its results."""


def observed_order(sizes, errors):
    """Slope of log(error) over log(size) by least squares."""
    return float(np.polyfit(np.log(sizes), np.log(np.abs(errors)), 1)[0])


class Bench:
    """The workplace of one case."""

    def __init__(self, options, name):
        self.options, self.name, self.quick = options, name, options.quick
        self.folder = options.out / "work" / name
        self.checks, self.tables, self.figures, self.notes = [], [], [], []
        self.count, self.cpu = 0, 0.0

    # --- runs ---

    def try_run(self, template, ranks=1, libraries=(), **values):
        """Runs whatever the exit code. libraries: laws of users that the deck may load."""
        self.count += 1
        run = runs.start(self.options, self.folder / str(self.count), runs.fill(template, **values), ranks,
                         libraries=libraries)
        self.cpu += run.cpu
        return run

    def run(self, template, ranks=1, libraries=(), **values):
        """Runs a deck that has to complete."""
        run = self.try_run(template, ranks, libraries, **values)
        if run.code != 0:
            self.equal("exit code", run.code, 0)
            self.note("The run ended with: " + run.errors[-600:])
            raise CaseFailed
        return run

    def accepts(self, template, **values):
        """Whether percuss knows all keys and values of a deck."""
        deck = runs.fill(template, **values)
        return runs.start(self.options, self.folder / "accepts", deck, command="check").code == 0

    def file(self, name):
        """Path of a file of this case that no run removes."""
        folder = self.folder / "files"
        folder.mkdir(parents=True, exist_ok=True)
        return folder / name

    def clean(self):
        if not self.options.keep:
            shutil.rmtree(self.folder, ignore_errors=True)

    # --- checks ---

    def _enter(self, quantity, measured, exact, error, limit, passed, unit):
        def plain(value):
            return value if isinstance(value, (str, int, type(None))) and not isinstance(value, bool) else float(value)

        self.checks.append({"quantity": quantity, "measured": plain(measured), "exact": plain(exact),
                            "error": error, "limit": limit, "passed": bool(passed), "unit": unit})

    def near(self, quantity, measured, exact, relative=None, absolute=None, unit=""):
        """measured within a share of |exact|, or within an absolute error, of exact."""
        difference = measured - exact
        if relative is not None:
            error = difference / abs(exact)
            self._enter(quantity, measured, exact, f"{100 * error:+.3g} %", f"{100 * relative:.3g} %",
                        abs(error) <= relative, unit)
        else:
            self._enter(quantity, measured, exact, f"{difference:+.2g}", f"{absolute:.2g}",
                        abs(difference) <= absolute, unit)

    def below(self, quantity, measured, limit, unit=""):
        self._enter(quantity, measured, None, "", f"< {limit:.4g}", measured < limit, unit)

    def above(self, quantity, measured, limit, unit=""):
        self._enter(quantity, measured, None, "", f"> {limit:.4g}", measured > limit, unit)

    def equal(self, quantity, measured, exact):
        self._enter(quantity, measured, exact, "", "equal", measured == exact, "")

    def closed(self, run, energy, which="", momentum=1e-12):
        """A scene with nothing from outside: momentum to round-off, energy within a share, at every row."""
        prefix = which + ": " if which else ""
        self.below(prefix + "linear momentum, relative change", run.summary["momentum"]["linear_error"], momentum)
        self.below(prefix + "angular momentum, relative change", run.summary["momentum"]["angular_error"], momentum)
        self.below(prefix + "energy balance, largest error", run.history.largest("energy_error"), energy)

    # --- what the page shows besides ---

    def table(self, heading, rows, caption=""):
        self.tables.append({"heading": heading, "rows": [[str(cell) for cell in row] for row in rows],
                            "caption": caption})

    def note(self, text):
        """Text under the tables, without the folder of this machine."""
        self.notes.append(text.replace(str(self.folder) + "/", ""))

    def figure(self, caption, draw, width=6.4, height=3.2):
        """draw(axes) fills a figure, which goes to the page with its caption."""
        import plots
        name = f"{self.name}{'_' + str(len(self.figures) + 1) if self.figures else ''}.svg"
        plots.save(self.options.out / "figures" / name, draw, width, height)
        self.figures.append({"file": name, "caption": caption})

    def results(self):
        return {"name": self.name, "checks": self.checks, "tables": self.tables, "figures": self.figures,
                "notes": self.notes, "runs": self.count, "cpu": self.cpu}


def thin(x, y, most=400):
    """At most `most` points of a curve, for small figures."""
    step = max(1, math.ceil(len(x) / most))
    return np.asarray(x)[::step], np.asarray(y)[::step]
