"""*INITIAL_AXIAL_FORCE_BEAM and *INITIAL_STRESS_SECTION: preloads of bolts, which percuss reaches before time 0."""

from dataclasses import dataclass

from ..curves import Points
from ..fields import Row
from ..ledger import BadInput, Place, missing
from ..model import Block, Deck, Model, Vector
from ..shapes import cross, dot, make_vector, normalise, subtract
from .cards import Card
from .deck import KeywordDeck

RELAXED = ("a preload reached in damped steps before time 0, in place of the rise of the curve; "
           "gravity acts in them, so hold what nothing supports (start.relaxation.hold)")
HELD = 0.01  # of its largest value: what a curve may change by after it is reached


@dataclass
class Plane:
    """A section of the output by a plane."""

    parts: int  # *SET_PART; 0: all
    point: Vector
    normal: Vector
    radius: float  # 0: no limit
    edges: tuple[float, float]  # of the rectangle that limits it, whose corner is the point; 0: no limit
    place: Place
    card: str = ""
    title: str = ""
    is_local: bool = False  # forces along axes that move
    along: Vector = (0.0, 0.0, 0.0)  # the first edge of the rectangle

    @property
    def is_limited(self) -> bool:
        return self.radius > 0 or any(self.edges)

    def holds(self, x: Vector) -> bool:
        """Whether a point lies within its limits, along the normal."""
        way = subtract(x, self.point)
        flat = subtract(way, tuple(dot(way, self.normal) * n for n in self.normal))  # type: ignore[arg-type]
        if self.radius > 0:
            return dot(flat, flat) <= self.radius**2
        sides = (self.along, cross(self.normal, self.along))
        return all(not length or 0 <= dot(flat, side) <= length for side, length in zip(sides, self.edges))


def read_axial_force(deck: KeywordDeck, card: Card) -> None:
    """BSID LCID SCALE: kept until the parts are built, which these beams divide."""
    reader = card.reader()
    while reader.skip_blank():
        row = reader.row("BSID LCID SCALE=1 KBEND")
        if row.integer("KBEND"):
            deck.ledger.refuse("INITIAL_AXIAL_FORCE_BEAM.KBEND", row.place, "KBEND keeps the bending stiffness",
                               "the beams have that of their section")
        deck.bolts.append(row)


def mark_bolts(deck: KeywordDeck) -> None:
    """The preload of each beam. Call once all sets are known, before beams become blocks."""
    known = set(deck.list_elements("BEAM"))
    for index, row in enumerate(deck.bolts):
        members = deck.list_members("BEAM", row.integer("BSID"), row.place)
        deck.used.add(("BEAM", row.integer("BSID")))
        found = [id for id in members if id in known]
        if len(found) < len(members):
            deck.ledger.refuse("INITIAL_AXIAL_FORCE_BEAM.BSID", row.place,
                               "beams that are not in the mesh", "they are left out")
        for id in found:
            if deck.bolt_of_beam.setdefault(id, index) != index:
                deck.ledger.refuse("INITIAL_AXIAL_FORCE_BEAM.twice", row.place,
                                   f"beam {id} has two preloads", "the first counts")


def add_preloads(deck: KeywordDeck) -> None:
    """A preload for each part of beams that has one."""
    for index, row in enumerate(deck.bolts):
        force = find_held_value(deck, "INITIAL_AXIAL_FORCE_BEAM", row)
        blocks = [block for block in deck.model.blocks if deck.bolt_of_block.get(block.id) == index]
        if not blocks:
            deck.ledger.refuse("INITIAL_AXIAL_FORCE_BEAM.BSID", row.place, "beams that are not in the model",
                               "the preload is left out")
        for block in blocks if force else []:
            add_preload(deck.model, block, {"force": force})
            deck.ledger.approximated("INITIAL_AXIAL_FORCE_BEAM", row.place, RELAXED)
        if not force:
            deck.ledger.ignored("INITIAL_AXIAL_FORCE_BEAM", row.place, "a force of 0")


def add_preload(model: Model, block: Block, keys: Deck) -> None:
    start = model.deck.setdefault("start", {})
    start.setdefault("relaxation", {})
    start.setdefault("preload", {})[model.names.take(f"preload_{block.name}")] = {"part": block.name, **keys}


def find_held_value(deck: KeywordDeck, card: str, row: Row) -> float:
    """The largest value of a curve, which it holds. Told where it does not."""
    points = deck.material_curve(row.integer("LCID"), row.place, "time", "force" if card.endswith("BEAM") else "stress")
    value = max((y for _, y in points), key=abs)
    if not holds(points, value):
        deck.ledger.refuse(f"{card}.LCID", row.place, "a curve that leaves its largest value",
                           "that value is the preload, and free after time 0")
    return value * (row.or_default("SCALE", 1.0) if card.endswith("BEAM") else 1.0)


def holds(points: Points, value: float) -> bool:
    """Once reached, the value stays, or the curve ends at 0, which releases the bolt in LS-DYNA too."""
    first = next(i for i, (_, y) in enumerate(points) if y == value)
    later = [y for _, y in points[first:]]
    while len(later) > 1 and later[-1] == 0:
        later.pop()
    return all(abs(y - value) <= HELD * abs(value) for y in later)


def read_plane(deck: KeywordDeck, card: Card) -> None:
    """*DATABASE_CROSS_SECTION_PLANE: a section of the output, to which a preload may refer."""
    reader = card.reader()
    head_row = reader.row("CSID TITLE~label", (10, 70)) if card.has_id else None
    id = head_row.integer("CSID") if head_row else -len(deck.planes) - 1
    title = (head_row.text("TITLE") if head_row else "") or f"section_{abs(id)}"
    row, more = reader.row("PSID XCT YCT ZCT XCH YCH ZCH RADIUS"), reader.row("XHEV YHEV ZHEV LENL LENM ID ITYPE")
    tail, head = (make_vector(row.numbers(f"XC{end}", f"YC{end}", f"ZC{end}")) for end in "TH")
    line = subtract(head, tail)
    if dot(line, line) <= 0:
        row.fail("XCH", "a point ahead of the first is expected: it gives the normal")
    edges = (more.number("LENL"), more.number("LENM"))
    plane = Plane(row.integer("PSID"), tail, normalise(line), row.number("RADIUS"), edges, row.place)
    if any(edges):
        edge = subtract(make_vector(more.numbers("XHEV", "YHEV", "ZHEV")), tail)
        across = subtract(edge, make_vector(dot(edge, plane.normal) * n for n in plane.normal))
        if dot(across, across) <= 0:
            more.fail("XHEV", "a point beside the normal is expected: it gives the first edge of the rectangle")
        plane.along = normalise(across)
    plane.card, plane.title, plane.is_local = card.keyword, title, bool(more.integer("ID"))
    deck.ids.claim("*DATABASE_CROSS_SECTION", id, plane.place)
    deck.planes[id] = plane


def read_section_stress(deck: KeywordDeck, card: Card) -> None:
    """*INITIAL_STRESS_SECTION: the stress of a plane section, times its area."""
    reader = card.reader()
    while reader.skip_blank():
        row = reader.row("ISSID CSID LCID PSID VID IZSHEAR ISTIFF")
        row.skip("ISSID")
        plane = deck.planes.get(row.integer("CSID"), deck.planes.get(-row.integer("CSID")))
        if row.integer("IZSHEAR") or row.integer("ISTIFF"):
            deck.ledger.refuse("INITIAL_STRESS_SECTION.IZSHEAR", row.place, "IZSHEAR or ISTIFF",
                               "shear stresses stay free")
        if plane is None:
            deck.ledger.refuse("INITIAL_STRESS_SECTION.CSID", row.place,
                               "a section that is no *DATABASE_CROSS_SECTION_PLANE", "the preload is left out")
        else:
            check_normal(deck, row, plane)
            tighten_plane(deck, row, plane)


def check_normal(deck: KeywordDeck, row: Row, plane: Plane) -> None:
    """VID gives the normal in place of the plane."""
    id = row.integer("VID")
    if not id:
        return
    if id not in deck.vectors:
        raise BadInput(row.place, missing(f"*DEFINE_VECTOR {id}"))
    if abs(dot(normalise(deck.vectors[id]), plane.normal)) < 1 - 1e-6:
        deck.ledger.refuse("INITIAL_STRESS_SECTION.VID", row.place, "VID: a normal other than that of the plane",
                           "the plane's own normal is used")


def tighten_plane(deck: KeywordDeck, row: Row, plane: Plane) -> None:
    """A preload for each part of solids that the plane cuts."""
    stress = find_held_value(deck, "INITIAL_STRESS_SECTION", row)
    set_id = row.integer("PSID") or plane.parts
    parts = deck.list_members("PART", set_id, row.place) if set_id else list(deck.parts)
    deck.used.add(("PART", set_id))
    found = False
    for block in deck.model.blocks:
        polygons = ([cut_solid([deck.nodes[n] for n in corners], plane) for _, corners in block.solids]
                    if block.part in parts else [])
        polygons = [polygon for polygon in polygons if polygon]
        if not polygons or not stress:
            continue
        if not all(is_inside(point, plane) for polygon in polygons for point in polygon) or any(plane.edges):
            deck.ledger.refuse("DATABASE_CROSS_SECTION_PLANE.RADIUS", plane.place,
                               "a preload of a plane with limits, "
                               f"which cuts part '{block.name}' beyond them or may do so", "it takes the whole part")
        area = sum(hull_area(polygon, plane.normal) for polygon in polygons)
        add_preload(deck.model, block,
                    {"point": list(plane.point), "normal": list(plane.normal), "force": float(f"{stress * area:.9g}")})
        deck.ledger.approximated("INITIAL_STRESS_SECTION", row.place, RELAXED + "; the stress times the area at time 0")
        found = True
    if not found and stress:
        deck.ledger.refuse("INITIAL_STRESS_SECTION.PSID", row.place, "a section that cuts no solids",
                           "the preload is left out")


def is_inside(point: Vector, plane: Plane) -> bool:
    away = subtract(point, plane.point)
    return plane.radius <= 0 or dot(away, away) <= (1.001 * plane.radius) ** 2


def cut_solid(corners: list[Vector], plane: Plane) -> list[Vector]:
    """Where lines between the corners of a convex solid meet the plane: their hull is the section."""
    heights = [dot(subtract(x, plane.point), plane.normal) for x in corners]
    points = []
    for i, a in enumerate(heights):
        for j, b in enumerate(heights):
            if a < 0 <= b:
                share = a / (a - b)
                points.append(tuple(corners[i][k] + share * (corners[j][k] - corners[i][k]) for k in range(3)))
    return points  # type: ignore[return-value]


def hull_area(points: list[Vector], normal: Vector) -> float:
    """Area of the hull of points in a plane (Andrew's monotone chain)."""
    axis = min(range(3), key=lambda k: abs(normal[k]))
    u = normalise(cross(normal, tuple(1.0 if k == axis else 0.0 for k in range(3))))  # type: ignore[arg-type]
    v = cross(normal, u)
    flat = sorted({(dot(p, u), dot(p, v)) for p in points})
    chain: list[tuple[float, float]] = []
    for side in (flat, flat[::-1]):
        first = len(chain)
        for p in side:
            while len(chain) >= first + 2 and turn(chain[-2], chain[-1], p) <= 0:
                chain.pop()
            chain.append(p)
        chain.pop()
    return 0.5 * abs(sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(chain, chain[1:] + chain[:1])))


def turn(a: tuple[float, float], b: tuple[float, float], c: tuple[float, float]) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
