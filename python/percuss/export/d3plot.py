"""The state database of LS-DYNA (d3plot), as LS-PrePost, META and lasso-python read it.

Source of the layout: LS-DYNA Database, Binary Output Files (Livermore Software Technology), section State Database.
Words have four bytes, little-endian; text has four characters a word. The file d3plot holds control words, geometry,
numbers and names of parts; d3plot01, d3plot02 ... hold states. Each ends with the word -999999.0."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from percuss.results.arrays import Array
from percuss.results.history import History

from ..files import make_mark
from ..results.expressions import clip
from .selection import Selection

END = np.array([-999999.0], "<f4").tobytes()
LARGEST_FILE = 1 << 30  # bytes, of one file of states; a state is never cut
LAYERS = 3  # of shells: middle, inner (bottom) and outer (top) surface
SOLIDS, SHELLS, BEAMS = "solids", "shells", "beams"
KINDS = {12: SOLIDS, 13: SOLIDS, 14: SOLIDS, 10: SOLIDS, 9: SHELLS, 5: SHELLS, 3: BEAMS}
# Corners of VTK's cells in the places of a card of LS-DYNA.
CORNERS = {12: (0, 1, 2, 3, 4, 5, 6, 7), 13: (0, 1, 4, 3, 2, 2, 5, 5), 14: (0, 1, 2, 3, 4, 4, 4, 4),
           10: (0, 1, 2, 3, 3, 3, 3, 3), 9: (0, 1, 2, 3), 5: (0, 1, 2, 2), 3: (0, 1)}
TITLE_WORDS = 18
GLOBALS = 6
MOST_ID = 2**31 - 1
VERSION = 960.0  # of the layout; readers know byte order and size of words by a number from 900 to 1000 there
# Fields that have a place in the file; of beams the components of a section.
PLACES = ("displacement", "velocity", "stress", "stress_bottom", "stress_top", "equivalent_plastic_strain", "thickness",
          "alive", "section_force", "section_moment")


def list_left_out(selection: Selection) -> list[str]:
    """Fields that the format has no place for."""
    return [name for name in selection.names if name not in PLACES]


def list_zeros(selection: Selection) -> list[str]:
    """What the format always has, and the run did not write."""
    return [name for name in ("velocity", "stress", "equivalent_plastic_strain") if name not in selection.names]


class Database:
    """The files of a selection. history: for energies; None where there is none."""

    def __init__(self, selection: Selection, history: History | None = None) -> None:
        self.selection, self.history = selection, history
        fields = self.fields = selection.fields
        ids, self.are_renumbered = _make_ids(fields.node_ids)
        self.nodes = np.argsort(ids, kind="stable")  # node numbers of the file ascend
        self.node_ids = ids[self.nodes]
        self.place = np.empty(fields.nodes, dtype=np.int64)
        self.place[self.nodes] = np.arange(1, fields.nodes + 1)
        kinds = np.array([KINDS[kind] for kind in fields.kinds.tolist()]) if fields.elements else np.empty(0, "U6")
        ids, renumbered = _make_ids(fields.element_ids)
        self.are_renumbered |= renumbered
        self.elements, self.element_ids = {}, {}
        for kind in (SOLIDS, BEAMS, SHELLS):
            chosen = np.flatnonzero(kinds == kind)
            self.elements[kind] = chosen[np.argsort(ids[chosen], kind="stable")]
            self.element_ids[kind] = ids[self.elements[kind]]
        self.parts = len(fields.part_names)
        self.has_thickness = "thickness" in selection.names and len(self.elements[SHELLS]) > 0

    def write_geometry(self) -> bytes:
        """Bytes of the file d3plot."""
        pieces = [self._write_control(), _floats(self.fields.positions(0)[self.nodes])]
        pieces += [self._write_corners(kind) for kind in (SOLIDS, BEAMS, SHELLS)]
        pieces += [self._write_numbers(), END, _integers([90001, self.parts])]
        for number, name in enumerate(self.fields.part_names, 1):
            pieces += [_integers([number]), _text(name, TITLE_WORDS)]
        # VTK's reader takes the names of parts for the first list
        return b"".join([*pieces, _integers([90000]), _text(make_mark("export"), TITLE_WORDS), END])

    def write_states(self) -> Iterator[tuple[str, bytes]]:
        """(name of a file, its bytes), one after the other."""
        number, pieces, size = 1, list[bytes](), 0
        for frame in self.selection.frames:
            state = self._write_state(frame)
            if pieces and size + len(state) > LARGEST_FILE:
                yield f"d3plot{number:02}", b"".join([*pieces, END])
                number, pieces, size = number + 1, [], 0
            pieces.append(state)
            size += len(state)
        yield f"d3plot{number:02}", b"".join([*pieces, END])

    def _count_words(self, kind: str) -> int:
        if kind == SOLIDS:
            return 7
        return 6 if kind == BEAMS else LAYERS * 7 + 4 * self.has_thickness

    def _write_control(self) -> bytes:
        """64 words. 1000 says that a quantity is there, 999 that it is not."""
        words = np.zeros(64, "<i4")
        words[:10] = np.frombuffer(_text(self.selection.title, 10), "<i4")
        words[11], words[12] = 1, 0  # file type: state database
        words[13:14] = np.frombuffer(b"R12 ", "<i4")
        words[14:15] = np.array([VERSION], "<f4").view("<i4")
        # three dimensions with whole connectivity; code of LS-DYNA
        words[15], words[16], words[17] = 4, self.fields.nodes, 6
        words[18] = GLOBALS + 7 * self.parts
        words[20:23] = 1, 1, 0  # positions, velocities, no accelerations
        for at, kind in ((23, SOLIDS), (28, BEAMS), (31, SHELLS)):
            words[at] = len(self.elements[kind])
            words[at + 1] = len(np.unique(self.fields.part[self.elements[kind]]))
            words[27 if kind == SOLIDS else at + 2] = self._count_words(kind)
        words[36] = -(10000 + LAYERS)  # with a word for each element that tells deletion
        words[39] = self._count_numbers()
        words[43:47] = 1000, 1000, 999, 1000 if self.has_thickness else 999
        words[51] = self.parts
        return words.tobytes()

    def _write_corners(self, kind: str) -> bytes:
        elements, kinds = self.elements[kind], self.fields.kinds
        width = {SOLIDS: 9, BEAMS: 6, SHELLS: 5}[kind]
        rows = np.zeros((len(elements), width), "<i4")
        corners, offsets = self.fields.root["Connectivity"][:], self.fields.root["Offsets"][: self.fields.elements]
        for type_, places in CORNERS.items():
            chosen = kinds[elements] == type_
            if not chosen.any():
                continue
            nodes = self.place[corners[offsets[elements[chosen]][:, None] + np.array(places)]]
            rows[chosen, : len(places)] = nodes
            if kind == BEAMS:
                rows[chosen, 2] = nodes[:, 0]  # no node of orientation
        rows[:, -1] = self.fields.part[elements] + 1
        return rows.tobytes()

    def _count_numbers(self) -> int:
        return 16 + self.fields.nodes + self.fields.elements + 3 * self.parts

    def _write_numbers(self) -> bytes:
        """Ids of nodes, elements and parts; a negative first word says that parts have ids, too."""
        counts = [self.fields.nodes, *(len(self.elements[kind]) for kind in (SOLIDS, BEAMS, SHELLS)), 0]
        starts = np.cumsum([1, *counts])
        parts = np.arange(1, self.parts + 1)
        first = starts[5] + self.parts * np.arange(3)
        head = [-starts[0], *starts[1:5], *counts, *first, self.parts, 0, self.parts]
        lists = [self.node_ids, *(self.element_ids[kind] for kind in (SOLIDS, BEAMS, SHELLS)), parts, parts, parts]
        return _integers(head) + b"".join(_integers(values) for values in lists)

    # --- states -------------------------------------------------------------------------------------------------------

    def _write_state(self, frame: int) -> bytes:
        pieces = [_floats(self._find_globals(frame)), _floats(self.fields.positions(frame)[self.nodes]),
                  _floats(self._read("velocity", frame, 3)[self.nodes])]
        stress, strain = self._read("stress", frame, 6), self._read("equivalent_plastic_strain", frame, 1)
        solids, beams, shells = (self.elements[kind] for kind in (SOLIDS, BEAMS, SHELLS))
        pieces.append(_floats(np.column_stack([stress[solids], strain[solids]])))
        force, moment = self._read("section_force", frame, 3), self._read("section_moment", frame, 3)
        pieces.append(_floats(np.column_stack([force[beams], moment[beams][:, [1, 2, 0]]])))
        layers = [stress, *(self._read(name, frame, 6) if name in self.selection.names else stress
                            for name in ("stress_bottom", "stress_top"))]
        columns = [column for layer in layers for column in (layer[shells], strain[shells])]
        if self.has_thickness:
            columns += [self._read("thickness", frame, 1)[shells], np.zeros((len(shells), 3))]
        pieces.append(_floats(np.column_stack(columns)))
        alive = self.fields.alive(frame)
        pieces += [_floats(np.where(alive[chosen], self.fields.part[chosen] + 1, 0))
                   for chosen in (solids, shells, beams)]
        return b"".join(pieces)

    def _read(self, name: str, frame: int, width: int) -> Array:
        if name not in self.selection.names:
            count = self.fields.nodes if name == "velocity" else self.fields.elements
            return np.zeros((count, width))
        return np.asarray(self.selection.data(name, frame), dtype=float).reshape(-1, width)

    def _find_globals(self, frame: int) -> list[float]:
        """Time; kinetic, internal and total energy, mean velocity (not known: 0); the same two energies of each part,
        then its velocity, mass and hourglass energy."""
        time = float(self.fields.times[frame])
        kinetic, internal = self._at(time, "kinetic"), self._at(time, "internal")
        by_part = [[self._at(time, f"{column}:{name}") for name in self.fields.part_names]
                   for column in ("internal", "kinetic")]
        rest = [[0.0] * (3 * self.parts), *([self._at(time, f"{column}:{name}") for name in self.fields.part_names]
                                            for column in ("mass", "hourglass"))]
        return [time, kinetic, internal, kinetic + internal, 0, 0, 0,
                *(value for values in (*by_part, *rest) for value in values)]

    def _at(self, time: float, column: str) -> float:
        return (self.history.at(time, column)
                if self.history is not None and column in self.history and len(self.history) else 0.0)


def describe(database: Database) -> list[str]:
    """What the user should know about the files, a text each."""
    left_out = []
    if left := list_left_out(database.selection):
        left_out.append(f"d3plot has no place for {clip(', '.join(left))}: left out")
    if zeros := list_zeros(database.selection):
        left_out.append(f"{', '.join(zeros)}: not in the run (output.fields.write of the deck), or not chosen; "
                        "zeros stand for it")
    shells = len(database.elements[SHELLS]) > 0
    if (shells and "stress" in database.selection.names
            and not {"stress_bottom", "stress_top"} <= set(database.selection.names)):
        left_out.append("stress_bottom and stress_top are not in the run: all three layers of shells have the mean "
                        "stress, without bending")
    if len(database.elements[BEAMS]) and not {"section_force", "section_moment"} <= set(database.selection.names):
        left_out.append("section_force and section_moment are not in the run: forces of beams are zeros")
    if database.are_renumbered:
        left_out.append("ids are not unique, or not positive: nodes and elements are numbered from 1")
    return left_out


def _make_ids(ids: Array) -> tuple[Array, bool]:
    """The ids of the mesh where a file can have them, else numbers from 1; and whether they are new."""
    ids = np.asarray(ids, dtype=np.int64)
    if len(ids) and (ids.min() < 1 or ids.max() > MOST_ID or len(np.unique(ids)) < len(ids)):
        return np.arange(1, len(ids) + 1), True
    return ids, False


def _integers(values: Any) -> bytes:
    return np.asarray(values, dtype="<i4").tobytes()


def _floats(values: Any) -> bytes:
    return np.asarray(values, dtype="<f4").tobytes()


def _text(text: str, words: int) -> bytes:
    return text.encode("ascii", "replace")[: 4 * words].ljust(4 * words)
