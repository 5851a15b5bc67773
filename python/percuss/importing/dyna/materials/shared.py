"""What the translations of materials share."""

from dataclasses import dataclass, field

from ...curves import Points, order_points, thin_rows
from ...fields import Row
from ...ledger import Place
from ...model import Deck
from ..cards import Card, Lines
from ..deck import KeywordDeck
from ..dimensions import scale

FAR = 1.0  # plastic strain by which a table goes on with its last slope
COROTATIONAL = {9}  # ELFORM of solids of *MAT_MODIFIED_HONEYCOMB, beside 0
NEVER = 1e15  # a specific heat, a melting point, a failure strain that nothing reaches
Elements = list[tuple[int, tuple[int, ...]]]


@dataclass
class Use:
    """How a part uses a material."""

    is_shell: bool
    state: Card | None
    place: Place
    points: int
    is_beam: bool = False
    has_used_state: bool = False
    density: float = 0.0
    is_corotational: bool = False  # ELFORM 0 and 9 of solids of *MAT_MODIFIED_HONEYCOMB
    shells: Elements = field(default_factory=list)
    solids: Elements = field(default_factory=list)
    angles: set[float] = field(default_factory=set)  # of axes, that shells have themselves
    has_systems: bool = False  # likewise: systems of axes
    turn: float = 0.0  # degrees from the axes of the law to those of the material


def tangent_to_hardening(row: Row, youngs: float, tangent: float) -> float:
    """Slope of the yield stress over plastic strain from that of the stress over strain."""
    if tangent >= youngs:
        row.fail("ETAN", "must be below Young's modulus")
    return max(youngs * tangent / (youngs - tangent), 0.0)


def elastic_from_shear_and_bulk(shear: float, bulk: float) -> Deck:
    """Young's modulus and Poisson's ratio."""
    return {
        "youngs_modulus": 9 * bulk * shear / (3 * bulk + shear),
        "poissons_ratio": (3 * bulk - 2 * shear) / (6 * bulk + 2 * shear),
    }


def clean_curve(points: Points) -> Points:
    """A yield stress over plastic strain, from 0 on."""
    points = [(x, y) for x, y in order_points(points) if x >= 0 and y > 0]
    if points and points[0][0] > 0:
        points[0] = (0.0, points[0][1])
    return points


def extend_curve(rows: Points) -> Points:
    """It goes on with its last slope, as far as its stress is positive."""
    if len(rows) < 2:
        return rows
    (x0, y0), (x1, y1) = rows[-2:]
    slope = (y1 - y0) / (x1 - x0)
    far = y1 + FAR * slope
    if slope == 0:
        return rows
    return [*rows, (x1 + FAR, far) if far > 0 else (x1 + 0.99 * y1 / -slope, 0.01 * y1)]


def make_hardening(deck: KeywordDeck, points: Points, card: str, place: Place) -> list[list[float]]:
    """A table of yield stress over plastic strain, which goes on with its last slope."""
    points = clean_curve(points)
    if not points:
        return []
    rows, error = thin_rows(points, 31)
    if error > 1e-12:
        deck.ledger.approximated(
            f"{card}.curve", place, f"{len(points)} rows become {len(rows)}, within {error:.2g} of the largest stress"
        )
    return [list(row) for row in extend_curve(rows)]


def read_points(reader: Lines, layout_x: str, layout_y: str, lines: int = 1) -> Points:
    """Points from lines of abscissae and as many of ordinates; those behind the last abscissa are left out."""
    xs = [value for row in [reader.row(layout_x) for _ in range(lines)] for value in row.numbers(*layout_x.split())]
    ys = [value for row in [reader.row(layout_y) for _ in range(lines)] for value in row.numbers(*layout_y.split())]
    points = list(zip(xs, scale_stresses(reader, ys)))
    while points and points[-1] == (0.0, 0.0):
        points.pop()
    return points


def scale_stresses(reader: Lines, values: list[float]) -> list[float]:
    """Numbers of rows whose fields have the names of those of strains, in the units of the model."""
    factor = scale("stress", reader.card.change.factors)
    return [factor * value for value in values]


def finish_lines(deck: KeywordDeck, card: Card, reader: Lines) -> None:
    """Refuses lines that no field was read of, if they hold anything but zeros."""
    while reader.skip_blank():
        line = reader.take()
        if any(text.strip("0.+-eE") for text in card.split(line, (10,) * 8)):
            deck.ledger.refuse(f"{card.keyword}.lines", card.at(line[0]),
                               "a data line that is not read", "it is left out")


def add_rate(law: Deck, deck: KeywordDeck, row: Row, names: tuple[str, str]) -> bool:
    """Cowper and Symonds' dependence on the rate, by two constants of these names; False: there is none."""
    values = row.numbers(*names)
    if min(values) > 0:
        law["cowper_symonds_rate"], law["cowper_symonds_exponent"] = values
        return True
    given = [name for name, value in zip(names, values) if value]
    if given:
        other = next((name for name in names if name not in given), "")
        text = f"{given[0]} without {other}" if other else f"{names[0]} or {names[1]} below 0"
        deck.ledger.ignored(f"{row.card}.{given[0]}", row.place, f"{text}: Cowper and Symonds' law needs both above 0, "
                                                                 "so the stress does not depend on the rate")
    return False


def note_rate(deck: KeywordDeck, row: Row) -> None:
    """The rate that counts."""
    if row.number("VP") != 1:
        deck.ledger.approximated(f"{row.card}.VP", row.place, "the rate of plastic strain counts, as with VP=1")


def read_layers(law: Deck, row: Row, use: Use, name: str = "NUMINT") -> None:
    """How many points through the thickness must fail; below 0 their share in percent; 0: all of them."""
    count = row.number(name)
    if use.is_shell and count and "failure" in law:
        share = count / use.points if count > 0 else -count / 100
        if share < 1:
            law["failure"]["layers"] = share


def limit_tension(deck: KeywordDeck, row: Row, law: Deck, bulk: float, stays: bool = True) -> None:
    """PC: a limit of tension that does not fail the element; stays: the pressure stays level there.
    One beyond the bulk modulus is never reached, and is written for none."""
    limit = row.number("PC")
    if limit >= 0:
        return
    if -limit >= bulk > 0:
        deck.ledger.ignored(f"{row.card}.PC", row.place, "a tension beyond the bulk modulus, which nothing reaches")
    elif stays and "equation_of_state" in law:
        law["equation_of_state"]["least_pressure"] = limit
    elif deck.ledger.refuse(f"{row.card}.PC", row.place, "a tension cutoff without failure", "the element fails at it"):
        set_failure(law, pressure=-limit)


def note_viscosity(deck: KeywordDeck, row: Row, name: str) -> None:
    """A viscosity of foams, whose place the bulk viscosity of percuss takes."""
    if row.number(name):
        deck.ledger.approximated(f"{row.card}.{name}", row.place,
                                 "the bulk viscosity of percuss in place of this viscosity")


def find_bulk_modulus(law: Deck) -> float:
    """Bulk modulus from Young's modulus."""
    return float(law["youngs_modulus"] / (3 * (1 - 2 * law["poissons_ratio"])))


def set_failure(law: Deck, **limits: float) -> None:
    """Criteria of failure; 0 and what nothing reaches mean none.
    Of two limits of one kind the one that is reached first counts: each acts by itself."""
    for name, value in limits.items():
        if 0 < value < NEVER:
            known = law.setdefault("failure", {})
            known[name] = (max if name == "volume_below" else min)(known.get(name, value), value)


def set_layers(deck: KeywordDeck, law: Deck, row: Row, use: Use, own: float | None) -> None:
    """NUMFIP: how many points of a shell must fail, or below 0 their share in percent.
    own: the share that the law has for its own criteria."""
    count = row.number("NUMFIP") or 1
    share = min(count / use.points if count > 0 else -count / 100, 1.0)
    if own is not None and own != share:
        text = f"NUMFIP: {share:.3g} of the points must fail, and {own:.3g} by the law's own criteria"
        deck.ledger.refuse(f"{row.card}.NUMFIP", row.place, text, "the smaller share counts for both")
        share = min(own, share)
    if share < 1:
        law["failure"]["layers"] = share


def start_law(row: Row, model: str) -> Deck:
    """The keys that laws of metals have."""
    row.skip("MID")
    return {"model": model, "density": row.positive("RO"), "youngs_modulus": row.positive("E"),
            "poissons_ratio": row.number("PR")}
