"""Pieces of decks for the table of proofs: mm, t, s; steel, so a cube of 10 mm has the mass 7.8e-6 t."""

Triple = tuple[float, float, float]

DENSITY, YOUNG, POISSON = 7.8e-9, 2.1e5, 0.3
CUBE_MASS = DENSITY * 1000.0
CORNERS = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))


def deck(*cards: str, end: float = 1e-5, rows: int = 100) -> str:
    """A deck of cards, with its end and its history."""
    return f"*KEYWORD\n*CONTROL_TERMINATION\n{end!r}\n*DATABASE_GLSTAT\n{end / rows:.6g}\n{''.join(cards)}*END\n"


def nodes(*rows: tuple[float, ...]) -> str:
    """(id, x, y, z, TC, RC), the last two where they are given."""
    return "*NODE\n" + "".join(",".join(map(repr, row)) + "\n" for row in rows)


def elastic(id: int = 1, density: float = DENSITY, young: float = YOUNG, poisson: float = POISSON) -> str:
    return f"*MAT_ELASTIC\n{id},{density!r},{young!r},{poisson!r}\n"


def rigid(id: int = 1, *held: int) -> str:
    """*MAT_RIGID; held: CMO, CON1, CON2."""
    return f"*MAT_RIGID\n{id},{DENSITY!r},{YOUNG!r},{POISSON!r}\n{','.join(map(str, held)) or '0'}\n\n"


def part(id: int = 1, section: int = 1, material: int = 1, more: str = "") -> str:
    """*PART; more: further fields with their comma in front."""
    return f"*PART\npart_{id}\n{id},{section},{material}{more}\n"


def solid_section(id: int = 1, form: int = 1) -> str:
    return f"*SECTION_SOLID\n{id},{form}\n"


def shell_section(id: int = 1, thickness: float = 1.0, more: str = "") -> str:
    return f"*SECTION_SHELL\n{id},2,1.0,2\n{thickness!r},{thickness!r},{thickness!r},{thickness!r}{more}\n"


def hexahedron(id: int = 1, first: int = 1, at: Triple = (0.0, 0.0, 0.0), size: Triple = (10.0, 10.0, 10.0), of: int = 1) -> str:
    """A block with nodes of its own, from the id `first`: 1 2 3 4 below, 5 6 7 8 above, around z."""
    corners = nodes(*((first + i, *(at[d] + size[d] * c[d] for d in range(3))) for i, c in enumerate(CORNERS)))
    return corners + f"*ELEMENT_SOLID\n{id},{of},{','.join(str(first + i) for i in range(8))}\n"


def square(id: int = 1, first: int = 1, at: Triple = (0.0, 0.0, 0.0), size: float = 10.0, of: int = 1) -> str:
    """A shell in the plane x y with nodes of its own, from the id `first`."""
    corners = nodes(*((first + i, at[0] + size * c[0], at[1] + size * c[1], at[2]) for i, c in enumerate(CORNERS[:4])))
    return corners + f"*ELEMENT_SHELL\n{id},{of},{first},{first + 1},{first + 2},{first + 3}\n"


def cube(material: str = "") -> str:
    """Part 1: a cube of 10 mm, nodes 1 to 8, of elastic steel if no card of material 1 is given."""
    return hexahedron() + part() + solid_section() + (material or elastic())


def two_cubes(gap: float = 1.0) -> str:
    """Parts 1 and 2: the second cube, nodes 11 to 18, lies above the first."""
    return cube() + hexahedron(2, 11, (0.0, 0.0, 10.0 + gap), of=2) + part(2)


def shell(thickness: float = 1.0, material: str = "", more: str = "") -> str:
    """Part 1: a square shell of 10 mm, nodes 1 to 4."""
    return square() + part() + shell_section(1, thickness, more) + (material or elastic())


def curve(id: int, *points: tuple[float, float], more: str = "") -> str:
    """*DEFINE_CURVE; more: further fields of its first line with their comma in front."""
    return f"*DEFINE_CURVE\n{id}{more}\n" + "".join(f"{x!r},{y!r}\n" for x, y in points)


def force(axis: str):
    """The mean force on all nodes of a model that starts at rest: its momentum is that half a step before the row."""
    return lambda h: h[f"momentum_{axis}"][-1] / (h["time"][-1] - 0.5 * h["dt"][-1])


def returned(history: dict[str, list[float]]) -> float:
    """The largest share of the kinetic energy that comes back."""
    kinetic = history["kinetic"]
    return max(0.0, *(b - a for a, b in zip(kinetic, kinetic[1:]))) / kinetic[0]


def node_set(id: int, *ids: int) -> str:
    return f"*SET_NODE_LIST\n{id}\n{','.join(map(str, ids))}\n"


def velocity(x: float = 0.0, y: float = 0.0, z: float = 0.0) -> str:
    """Of all nodes."""
    return f"*INITIAL_VELOCITY\n0\n{x!r},{y!r},{z!r}\n"


# --- Abaqus


def abaqus(*keywords: str, end: float = 1e-5, step: str = "") -> str:
    """A deck without parts; step: what stands in its step."""
    return (f"*HEADING\nproof\n{''.join(keywords)}*STEP\n*DYNAMIC, EXPLICIT\n, {end!r}\n{step}*OUTPUT, HISTORY, TIME INTERVAL={end / 100!r}\n"
            "*END STEP\n")  # fmt: skip


def abaqus_cube(section: bool = True) -> str:
    """Nodes 1 to 8 of a cube of 10 mm of elastic steel; sets `all` of nodes and `cube` of its element."""
    rows = "".join(f"{i}, {10.0 * x}, {10.0 * y}, {10.0 * z}\n" for i, (x, y, z) in enumerate(CORNERS, 1))
    steel = f"*SOLID SECTION, ELSET=cube, MATERIAL=steel\n*MATERIAL, NAME=steel\n*DENSITY\n{DENSITY!r}\n*ELASTIC\n{YOUNG!r}, {POISSON!r}\n"
    return f"*NODE, NSET=all\n{rows}*ELEMENT, TYPE=C3D8R, ELSET=cube\n1, 1, 2, 3, 4, 5, 6, 7, 8\n{steel if section else ''}"
