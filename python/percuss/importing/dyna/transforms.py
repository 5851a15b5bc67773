"""*DEFINE_TRANSFORMATION, *NODE_TRANSFORM and *INCLUDE_TRANSFORM: nodes that are moved;
files whose ids, nodes and units are changed."""

import math
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from ..fields import Row, clip
from ..ledger import BadInput, Ledger, missing
from ..model import Vector
from ..shapes import cross, normalise, subtract
from .dimensions import SAME as SAME_UNITS
from .dimensions import Factors, find_card, find_factor

if TYPE_CHECKING:
    from .cards import Card, Lines

Affine = tuple[tuple[Vector, Vector, Vector], Vector]  # x -> A x + b
SAME: Affine = (((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)), (0.0, 0.0, 0.0))
ROUND_OFF = 1e-9  # difference of products of rows that commute
# What holds no places, directions or speeds of its own, but in nodes.
MOVABLE = (
    "NODE", "ELEMENT_SOLID", "ELEMENT_TSHELL", "ELEMENT_SHELL", "ELEMENT_MASS", "ELEMENT_DISCRETE", "PART", "SECTION_",
    "MAT_", "EOS_", "SET_", "DEFINE_CURVE", "DEFINE_TABLE", "HOURGLASS", "CONTROL_", "DATABASE_", "CONTACT_", "TITLE",
    "CONSTRAINED_EXTRA_NODES", "CONSTRAINED_NODAL_RIGID_BODY",
)  # fmt: skip
# What has directions and speeds, but no places: it is as it stands where a file is not turned, scaled or mirrored.
DIRECTED = (
    "BOUNDARY_SPC", "BOUNDARY_PRESCRIBED_MOTION_", "LOAD_NODE_", "LOAD_SEGMENT", "LOAD_SHELL_", "LOAD_BODY_",
    "DAMPING_", "DEFINE_VECTOR", "INITIAL_VELOCITY_NODE", "INITIAL_VELOCITY_RIGID_BODY", "CONSTRAINED_NODE_SET",
    "CONSTRAINED_RIGID_BODIES", "CONSTRAINED_SPOTWELD", "CONSTRAINED_RIVET", "CONSTRAINED_JOINT_", "ELEMENT_BEAM",
)  # fmt: skip
# Whose fields with ids are all of SHIFTS, so that offsets reach what they define and what they refer to.
SHIFTED = (
    "NODE", "ELEMENT_SOLID", "ELEMENT_TSHELL", "ELEMENT_SHELL", "ELEMENT_BEAM", "ELEMENT_MASS", "ELEMENT_DISCRETE",
    "PART", "SECTION_", "MAT_", "EOS_", "SET_", "DEFINE_CURVE", "DEFINE_TABLE", "DEFINE_BOX", "DEFINE_VECTOR",
    "HOURGLASS", "CONTROL_", "TITLE", "CONSTRAINED_EXTRA_NODES", "CONSTRAINED_NODAL_RIGID_BODY", "CONSTRAINED_NODE_SET",
    "CONSTRAINED_RIGID_BODIES", "CONSTRAINED_SPOTWELD", "CONSTRAINED_RIVET", "CONSTRAINED_JOINT_", "BOUNDARY_SPC",
    "BOUNDARY_PRESCRIBED_MOTION_", "LOAD_NODE_", "LOAD_SEGMENT", "LOAD_SHELL_", "LOAD_BODY_", "DAMPING_PART_MASS",
    "INITIAL_VELOCITY_NODE", "INITIAL_VELOCITY_RIGID_BODY",
)  # fmt: skip
ALONE = ("INITIAL_VELOCITY",)  # without what else begins so
# Which offset of *INCLUDE_TRANSFORM a field gets, by its name; ID and N1 to N8 by their card.
SHIFTS = {
    **dict.fromkeys(("NID", "NID1", "NID2", "NID3", *(f"N{i}" for i in range(1, 9)), "PNODE"), "IDNOFF"),
    "EID": "IDEOFF", **dict.fromkeys(("PID", "PIDL", "PIDC", "PIDA", "PIDB"), "IDPOFF"),
    **dict.fromkeys(("MID", "MID1", "MID2", "EOSID"), "IDMOFF"), **dict.fromkeys(("SID", "NSID", "NSIDEX"), "IDSOFF"),
    **dict.fromkeys(("LCID", "LCIDDR", "LCSS", "LCSR", "LCD", "LCR", "TBID", "LCA", "LCB", "LCC", "LCS", "LCAB", "LCBC",
                     "LCCA", "LCIDPH", "LCIDT", "LCIDPS", "DLCIDPH", "DLCIDT", "DLCIDPS"), "IDFOFF"),
    **dict.fromkeys(("BOXID", "VID", "CID", "ICID", "CIDA", "CIDB"), "IDDOFF"),
    **dict.fromkeys(("SECID", "HGID"), "IDROFF"),
}  # fmt: skip
ID_OF_CARDS = {
    "CONSTRAINED_EXTRA_NODES_NODE": "IDNOFF", "CONSTRAINED_EXTRA_NODES_SET": "IDSOFF", "ELEMENT_MASS": "IDNOFF",
    "ELEMENT_MASS_NODE_SET": "IDSOFF", "ELEMENT_MASS_PART": "IDPOFF", "ELEMENT_MASS_PART_SET": "IDSOFF",
    "BOUNDARY_SPC_NODE": "IDNOFF", "BOUNDARY_SPC_SET": "IDSOFF", "BOUNDARY_SPC_SYMMETRY_PLANE": "IDPOFF",
    "BOUNDARY_SPC_SYMMETRY_PLANE_SET": "IDSOFF", "BOUNDARY_SPC_NODE_BIRTH_DEATH": "IDNOFF",
    "BOUNDARY_SPC_SET_BIRTH_DEATH": "IDSOFF", "BOUNDARY_PRESCRIBED_MOTION_NODE": "IDNOFF",
    "BOUNDARY_PRESCRIBED_MOTION_SET": "IDSOFF", "BOUNDARY_PRESCRIBED_MOTION_RIGID": "IDPOFF",
    "LOAD_NODE_POINT": "IDNOFF", "LOAD_NODE_SET": "IDSOFF", "LOAD_SEGMENT_SET": "IDSOFF", "LOAD_SHELL_SET": "IDSOFF",
    "LOAD_SHELL_ELEMENT": "IDEOFF", "DAMPING_PART_MASS": "IDPOFF", "DAMPING_PART_MASS_SET": "IDSOFF",
}  # fmt: skip


@dataclass
class FileChange:
    """What is done to a file that is included: offsets of ids, factors of units, a motion of its nodes."""

    offsets: dict[str, int] = field(default_factory=dict)
    factors: Factors = SAME_UNITS  # of mass, length, time
    transform: Affine = SAME

    def inside(self, outer: "FileChange") -> "FileChange":
        """This change of a file that is included by one with the other change."""
        names = {*self.offsets, *outer.offsets}
        offsets = {name: total for name in names if (total := self.offsets.get(name, 0) + outer.offsets.get(name, 0))}
        factors = tuple(a * b for a, b in zip(self.factors, outer.factors))
        return FileChange(offsets, factors, compose(outer.transform, self.transform))  # type: ignore[arg-type]

    def shift_of(self, card: str, name: str) -> int:
        """What is added to the id in a field."""
        if not self.offsets:
            return 0
        kind = SHIFTS.get(name) if name != "ID" else ID_OF_CARDS.get(card)
        return self.offsets.get(kind, 0) if kind else 0

    def factor_of(self, card: str, name: str) -> float:
        """Factor on the number of a field."""
        return find_factor(card, name, self.factors) if self.factors != SAME_UNITS else 1.0

    def move(self, x: Vector) -> Vector:
        """A node of the file in the axes and units of the model."""
        length = self.factors[1]
        return apply(self.transform, (x[0] * length, x[1] * length, x[2] * length))

    def mirrors(self) -> bool:
        rows = self.transform[0]
        turned = cross(rows[0], rows[1])
        return sum(turned[d] * rows[2][d] for d in range(3)) < 0

    def check(self, card: "Card", ledger: Ledger) -> None:
        """Refuses cards of the file with places, ids or numbers that are not changed with it."""
        kind = card.keyword
        is_directed = self.transform[0] == SAME[0] and (kind.startswith(DIRECTED) or kind in ALONE)
        # centres, axes and points
        has_places = any(word in kind for word in ("INERTIA", "SYMMETRY_PLANE", "SOLID_ORTHO"))
        if self.transform != SAME and (has_places or not (is_directed or kind.startswith(MOVABLE))):
            ledger.refuse(f"INCLUDE_TRANSFORM.{kind}", card.place, "a card in a file that is moved",
                          "it acts where it stands")
        if self.offsets and not kind.startswith(SHIFTED) and kind not in ALONE:
            ledger.refuse(f"INCLUDE_TRANSFORM.{kind}", card.place, "a card in a file whose ids get offsets",
                          "its ids stay as they are")
        if self.factors != SAME_UNITS and find_card(kind) is None:
            ledger.refuse(f"INCLUDE_TRANSFORM.{kind}", card.place, "a card in a file whose units are changed",
                          "its numbers stay as they are")


UNCHANGED = FileChange()


def apply(transform: Affine, x: Vector) -> Vector:
    rows, b = transform
    return tuple(sum(rows[i][j] * x[j] for j in range(3)) + b[i] for i in range(3))  # type: ignore[return-value]


def compose(outer: Affine, inner: Affine) -> Affine:
    """First the inner, then the outer."""
    a, c = outer[0], inner[0]
    rows = tuple(tuple(sum(a[i][k] * c[k][j] for k in range(3)) for j in range(3)) for i in range(3))
    return rows, apply(outer, inner[1])  # type: ignore[return-value]


def about(rows: tuple[Vector, Vector, Vector], point: Vector, goal: Vector | None = None) -> Affine:
    """A linear map about a point, which goes to the goal, or stays."""
    turned = apply((rows, (0.0, 0.0, 0.0)), point)
    return rows, subtract(goal or point, turned)


def rotate(axis: Vector, point: Vector, degrees: float) -> Affine:
    """About an axis through a point (Rodrigues)."""
    x, y, z = normalise(axis)
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    d = 1 - c
    rows = (
        (c + x * x * d, x * y * d - z * s, x * z * d + y * s),
        (y * x * d + z * s, c + y * y * d, y * z * d - x * s),
        (z * x * d - y * s, z * y * d + x * s, c + z * z * d),
    )
    return about(rows, point)


def mirror(point: Vector, normal: Vector) -> Affine:
    """Mirror image at a plane through a point."""
    n = normalise(normal)
    rows = tuple(tuple((1.0 if i == j else 0.0) - 2 * n[i] * n[j] for j in range(3)) for i in range(3))
    return about(rows, point)  # type: ignore[arg-type]


def find_axes(points: list[Vector]) -> list[Vector]:
    """Axes by an origin, a point on x and a point in the plane of x and y."""
    x, z = (normalise(subtract(points[1], points[0])),
            normalise(cross(subtract(points[1], points[0]), subtract(points[2], points[0]))))
    return [x, cross(z, x), z]


def place(points: list[Vector]) -> Affine:
    """Three points go where the axes of three others are."""
    old, new = find_axes(points[:3]), find_axes(points[3:])
    rows = tuple(tuple(sum(new[k][i] * old[k][j] for k in range(3)) for j in range(3)) for i in range(3))
    return about(rows, points[0], points[3])  # type: ignore[arg-type]


class Transformation:
    """*DEFINE_TRANSFORMATION: rows of which the last acts first.
    Nodes in them are those that are read before it is used."""

    def __init__(self, card: "Card"):
        self.place = card.place
        reader: Lines = card.reader()
        if card.has_title:
            reader.take()
        self.id = reader.row("TRANID").integer("TRANID")
        self._rows: list[tuple[Row, list[Row]]] = []
        while reader.skip_blank():
            row = reader.row("OPTION A1 A2 A3 A4 A5 A6 A7")
            more = [reader.row("M1 M2 M3 M4 M5 M6 M7 M8")
                    for _ in range(2 if row.text("OPTION").upper() == "MATRIX" else 0)]
            self._rows.append((row, more))

    def find(self, nodes: dict[int, Vector], ledger: Ledger) -> Affine:
        """What it does."""
        points: dict[int, Vector] = {}
        steps: list[Affine] = []
        for row, more in self._rows:
            if row.text("OPTION").upper() == "POINT":
                points[row.integer("A1")] = tuple(row.numbers("A2", "A3", "A4"))  # type: ignore[assignment]
            else:
                steps.append(make_step(row, more, points, nodes))
        total, reverse = SAME, SAME
        for step in steps:
            total, reverse = compose(total, step), compose(step, reverse)
        if differ(total, reverse):
            text = ("its rows do not commute: the last acts first, as in Ansys' PyDyna; "
                    "OpenRadioss lets the first act first")
            ledger.approximated("DEFINE_TRANSFORMATION.order", self.place, text)
        return total


def differ(a: Affine, b: Affine) -> bool:
    """Whether two maps are not the same, but for round-off."""
    pairs = [(a[0][i][j], b[0][i][j]) for i in range(3) for j in range(3)] + list(zip(a[1], b[1]))
    size = max(1.0, *(abs(x) for x in (*a[1], *b[1])))
    return any(abs(x - y) > ROUND_OFF * size for x, y in pairs)


def make_step(row: Row, more: list[Row], points: dict[int, Vector], nodes: dict[int, Vector]) -> Affine:
    """One row of a transformation."""
    option = row.text("OPTION").upper()
    a = row.numbers("A1", "A2", "A3", "A4", "A5", "A6", "A7")
    if option == "TRANSL":
        return SAME[0], (a[0], a[1], a[2])
    if option == "TRANSL2ND":
        way = subtract(find_point(row, "A2", {}, nodes), find_point(row, "A1", {}, nodes))
        unit = normalise(way)
        return SAME[0], (tuple(a[2] * c for c in unit) if a[2] else way)  # type: ignore[return-value]
    if option == "SCALE":
        s = [value or 1.0 for value in a[:3]]
        return ((s[0], 0.0, 0.0), (0.0, s[1], 0.0), (0.0, 0.0, s[2])), (0.0, 0.0, 0.0)
    if option == "ROTATE" and any(a[3:]) and any(a[:3]):
        return rotate((a[0], a[1], a[2]), (a[3], a[4], a[5]), a[6])
    if option == "ROTATE" and row.has("A3") and any(a[:2]) and not any(a[3:]):
        first, second = find_point(row, "A1", points, nodes), find_point(row, "A2", points, nodes)
        return rotate(check_way(row, subtract(second, first)), first, a[2])
    if option == "ROTATE3NA":
        first, second, center = (find_point(row, name, {}, nodes) for name in ("A1", "A2", "A3"))
        return rotate(check_way(row, subtract(second, first)), center, a[3])
    if option == "MIRROR":
        return mirror((a[0], a[1], a[2]), check_way(row, (a[3] - a[0], a[4] - a[1], a[5] - a[2])))
    if option in ("POS6P", "POS6N"):
        return place([find_point(row, f"A{i}", points if option == "POS6P" else {}, nodes if option == "POS6N" else {})
                      for i in range(1, 7)])
    if option == "MATRIX":
        m = [value for line in more for value in line.numbers(*(f"M{i}" for i in range(1, 9)))]
        return ((m[0], m[4], m[8]), (m[1], m[5], m[9]), (m[2], m[6], m[10])), (m[12], m[13], m[14])
    raise BadInput(row.place, f"{clip(option) or 'a blank row'} of *DEFINE_TRANSFORMATION is not read "
                              "(TRANSL, TRANSL2ND, SCALE, ROTATE, ROTATE3NA, "
                              "MIRROR, POINT, POS6P, POS6N and MATRIX are)")  # fmt: skip


def find_point(row: Row, name: str, points: dict[int, Vector], nodes: dict[int, Vector]) -> Vector:
    """A POINT of the transformation, or a node."""
    id = row.integer(name)
    if id in points:
        return points[id]
    if id not in nodes:
        raise BadInput(row.place, missing(f"point or node {id} before what is moved"))
    return nodes[id]


def check_way(row: Row, way: Vector) -> Vector:
    if not any(way):
        raise BadInput(row.place, f"two points of {row.text('OPTION').upper()} are at one place "
                                  "(they give no direction): correct one")
    return way


def read_include(card: "Card", known: dict[int, Transformation], nodes: dict[int, Vector],
                 ledger: Ledger) -> tuple[str, FileChange]:
    """The file of an *INCLUDE_TRANSFORM and what is done to it."""
    reader: Lines = card.reader()
    name = reader.text()
    ids, others = (reader.row("IDNOFF IDEOFF IDPOFF IDMOFF IDSOFF IDFOFF IDDOFF"),
                   reader.row("IDROFF PREFIX~label SUFFIX~label"))
    offsets = {kind: ids.integer(kind)
               for kind in ("IDNOFF", "IDEOFF", "IDPOFF", "IDMOFF", "IDSOFF", "IDFOFF", "IDDOFF")}
    offsets["IDROFF"] = others.integer("IDROFF")
    others.skip("PREFIX", "SUFFIX")
    units = reader.row("FCTMAS=1 FCTTIM=1 FCTLEN=1 FCTTEM=1 INCOUT1~output")
    factors = tuple(units.number(kind) or 1.0 for kind in ("FCTMAS", "FCTLEN", "FCTTIM"))
    units.finish(ledger, "temperatures stay as they are")
    last = reader.row("TRANID")
    id = last.integer("TRANID")
    if surplus := card.find_surplus():
        raise BadInput(card.at(surplus),
                       "a line that *INCLUDE_TRANSFORM does not have (TRANID is in its fifth): blank lines count")
    if id and id not in known:
        last.fail("TRANID", "there is no such *DEFINE_TRANSFORMATION before it")
    if min(factors) <= 0:
        raise BadInput(units.place, "a factor of units is below 0: correct it")
    transform = known[id].find(nodes, ledger) if id else SAME
    shifts = {kind: shift for kind, shift in offsets.items() if shift}
    return name, FileChange(shifts, factors, transform)  # type: ignore[arg-type]
