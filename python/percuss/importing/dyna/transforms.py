"""Maps of space, and what is done to an included file: its nodes are moved, its ids, nodes and units changed."""

import math
from dataclasses import dataclass, field

from ..ledger import Ledger, Place
from ..model import Vector
from ..shapes import cross, normalise, subtract
from .dimensions import SAME as SAME_UNITS
from .dimensions import Factors, find_card, find_factor

Affine = tuple[tuple[Vector, Vector, Vector], Vector]  # x -> A x + b
SAME: Affine = (((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)), (0.0, 0.0, 0.0))
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
# The offset of *INCLUDE_TRANSFORM that a field gets, by its name; ID and N1 to N8 by their card.
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

    def check(self, kind: str, place: Place, ledger: Ledger) -> None:
        """Refuses cards of the file with places, ids or numbers that are not changed with it."""
        is_directed = self.transform[0] == SAME[0] and (kind.startswith(DIRECTED) or kind in ALONE)
        # centres, axes and points
        has_places = any(word in kind for word in ("INERTIA", "SYMMETRY_PLANE", "SOLID_ORTHO"))
        if self.transform != SAME and (has_places or not (is_directed or kind.startswith(MOVABLE))):
            ledger.refuse(f"INCLUDE_TRANSFORM.{kind}", place, "a card in a file that is moved",
                          "it acts where it stands")
        if self.offsets and not kind.startswith(SHIFTED) and kind not in ALONE:
            ledger.refuse(f"INCLUDE_TRANSFORM.{kind}", place, "a card in a file whose ids get offsets",
                          "its ids stay as they are")
        if self.factors != SAME_UNITS and find_card(kind) is None:
            ledger.refuse(f"INCLUDE_TRANSFORM.{kind}", place, "a card in a file whose units are changed",
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
