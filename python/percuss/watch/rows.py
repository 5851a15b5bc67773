"""Rows of history.csv as they come."""

import os

from percuss.results.table import parse_row, read_heading


class Rows:
    """Attributes: names, columns {name: list of numbers}. read() takes what has been added since."""

    def __init__(self, path: str) -> None:
        self.path = path
        self._start_over(None)

    def _start_over(self, identity: int | None) -> None:
        self.names: list[str] = []
        self.columns: dict[str, list[float]] = {}
        self._place, self._identity = 0, identity

    def __len__(self) -> int:
        return len(self.columns[self.names[0]]) if self.names else 0

    def last(self, name: str) -> float | None:
        """The last value of a column; None if there is none."""
        return self.columns[name][-1] if self.columns.get(name) else None

    def read(self) -> bool:
        """Whether there are new rows. A file that was replaced or cut, as by a restart, is read from its start."""
        if not os.path.isfile(self.path):  # a pipe would be waited for
            return False
        try:
            with open(self.path, encoding="utf-8", errors="replace", newline="") as file:
                now = os.fstat(file.fileno())
                if now.st_ino != self._identity or now.st_size < self._place:
                    self._start_over(now.st_ino)
                file.seek(self._place)
                text = file.read()
                whole = text[: text.rfind("\n") + 1]
                self._place += len(whole.encode("utf-8", "replace"))
        except OSError:
            return False
        return self._take(whole.split("\n")[:-1])

    def _take(self, lines: list[str]) -> bool:
        if lines and not self.names:
            self.names = read_heading(self.path, lines[0])
            self.columns = {name: [] for name in self.names}
            lines = lines[1:]
        taken = False
        for line in lines:
            if (values := parse_row(line, len(self.names))) is not None:
                taken = True
                for name, value in zip(self.names, values):
                    self.columns[name].append(value)
        return taken
