"""*DEFINE_TRANSFORMATION and *INCLUDE_TRANSFORM: how nodes are moved, and which files."""

from ..fields import Row, clip
from ..ledger import BadInput, Ledger, missing
from ..model import Vector
from ..shapes import normalise, subtract
from .cards import Card
from .transforms import SAME, Affine, FileChange, compose, mirror, place, rotate

ROUND_OFF = 1e-9  # of products of rows that commute


class Transformation:
    """*DEFINE_TRANSFORMATION: rows of which the last acts first.
    Nodes in them are those that are read before it is used."""

    def __init__(self, card: Card):
        self.place = card.place
        reader = card.reader()
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


def read_include(card: Card, known: dict[int, Transformation], nodes: dict[int, Vector],
                 ledger: Ledger) -> tuple[str, FileChange]:
    """The file of an *INCLUDE_TRANSFORM and what is done to it."""
    reader = card.reader()
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
