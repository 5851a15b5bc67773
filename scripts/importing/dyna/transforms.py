"""*DEFINE_TRANSFORMATION and *INCLUDE_TRANSFORM: files whose nodes are moved, turned or scaled."""

import math
from typing import TYPE_CHECKING

from ..fields import clip
from ..ledger import BadInput, Ledger
from ..model import Vector

if TYPE_CHECKING:
    from .cards import Card, Lines

Affine = tuple[tuple[Vector, Vector, Vector], Vector]  # x -> A x + b
SAME: Affine = (((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)), (0.0, 0.0, 0.0))
# What holds no places, directions or speeds of its own, but in nodes.
MOVABLE = (
    "NODE",
    "ELEMENT_SOLID",
    "ELEMENT_SHELL",
    "ELEMENT_MASS",
    "PART",
    "SECTION_",
    "MAT_",
    "EOS_",
    "SET_",
    "DEFINE_CURVE",
    "DEFINE_TABLE",
    "HOURGLASS",
    "CONTROL_",
    "DATABASE_",
    "CONTACT_",
    "TITLE",
    "CONSTRAINED_EXTRA_NODES",
)


def apply(transform: Affine, x: Vector) -> Vector:
    rows, b = transform
    return tuple(sum(rows[i][j] * x[j] for j in range(3)) + b[i] for i in range(3))  # type: ignore[return-value]


def compose(outer: Affine, inner: Affine) -> Affine:
    """First the inner, then the outer."""
    a, c = outer[0], inner[0]
    rows = tuple(tuple(sum(a[i][k] * c[k][j] for k in range(3)) for j in range(3)) for i in range(3))
    return rows, apply(outer, inner[1])  # type: ignore[return-value]


def rotation(axis: Vector, point: Vector, degrees: float) -> Affine:
    """About an axis through a point (Rodrigues)."""
    length = math.sqrt(sum(c * c for c in axis))
    x, y, z = (c / length for c in axis)
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    d = 1 - c
    rows = (
        (c + x * x * d, x * y * d - z * s, x * z * d + y * s),
        (y * x * d + z * s, c + y * y * d, y * z * d - x * s),
        (z * x * d - y * s, z * y * d + x * s, c + z * z * d),
    )
    turned = apply((rows, (0.0, 0.0, 0.0)), point)
    return rows, (point[0] - turned[0], point[1] - turned[1], point[2] - turned[2])


def read_transformation(card: "Card") -> tuple[int, Affine]:
    """TRANID, then rows of which the last acts first."""
    reader = card.reader()
    if card.has_title:
        reader.take()
    id = reader.row("TRANID").integer("TRANID")
    transform = SAME
    while reader.skip_blank():
        row = reader.row("OPTION A1 A2 A3 A4 A5 A6 A7")
        option = row.text("OPTION").upper()
        a = row.numbers("A1", "A2", "A3", "A4", "A5", "A6", "A7")
        if option == "TRANSL":
            step: Affine = (SAME[0], (a[0], a[1], a[2]))
        elif option == "SCALE":
            s = [value or 1.0 for value in a[:3]]
            step = (((s[0], 0.0, 0.0), (0.0, s[1], 0.0), (0.0, 0.0, s[2])), (0.0, 0.0, 0.0))
        elif option == "ROTATE" and any(a[:3]) and row.has("A7"):
            step = rotation((a[0], a[1], a[2]), (a[3], a[4], a[5]), a[6])
        else:
            raise BadInput(row.place, f"{clip(option) or 'a blank row'} of *DEFINE_TRANSFORMATION is not read (TRANSL, SCALE and ROTATE "
                                      "with an axis, a point and an angle are)")  # fmt: skip
        transform = compose(transform, step)
    return id, transform


def read_include(card: "Card", known: dict[int, Affine], ledger: Ledger) -> tuple[str, Affine]:
    """The file of an *INCLUDE_TRANSFORM and what is done to it. Offsets of ids and factors of units are refused."""
    reader: Lines = card.reader()
    name = reader.text()
    rows = [
        reader.row("IDNOFF IDEOFF IDPOFF IDMOFF IDSOFF IDFOFF IDDOFF"),
        reader.row("IDROFF PREFIX SUFFIX"),
        reader.row("FCTMAS=1 FCTTIM=1 FCTLEN=1 FCTTEM~ INCOUT1~"),
    ]
    for row in rows:
        row.finish(ledger, "ids and numbers stay as they are")
    last = reader.row("TRANID")
    id = last.integer("TRANID")
    if id and id not in known:
        last.fail("TRANID", "there is no such *DEFINE_TRANSFORMATION before it")
    return name, known.get(id, SAME)


def check_card(card: "Card", ledger: Ledger) -> None:
    """Cards of a file that is moved must hold no places of their own."""
    if card.transform is not SAME and not card.keyword.startswith(MOVABLE):
        ledger.refuse(f"INCLUDE_TRANSFORM.{card.keyword}", card.place, "a card in a file that is moved", "it acts where it stands")
