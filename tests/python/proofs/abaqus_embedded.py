"""Elements in others."""

from . import LAST, Proof
from .pieces import CUBE_MASS, DENSITY, abaqus, abaqus_cube

AREA, LENGTH, SPEED = 40.0, 4.0, 1000.0  # of a bar along x about the middle of the cube
BAR_MASS = DENSITY * AREA * LENGTH
BAR = f"*NODE, NSET=ends\n21, 3., 5., {{0}}\n22, 7., 5., {{0}}\n*ELEMENT, TYPE=T3D2, ELSET=bar\n9, 21, 22\n*SOLID SECTION, ELSET=bar, MATERIAL=steel\n{AREA!r},\n"
MOVES = f"*INITIAL CONDITIONS, TYPE=VELOCITY\nends, 3, {SPEED!r}\n"


def hold(embedded: str, more: str = "", z: float = 5.0) -> str:
    """The bar moves along z in a cube at rest."""
    return abaqus(abaqus_cube(), BAR.format(z), more, embedded, MOVES, step="*OUTPUT, HISTORY, TIME INTERVAL=1e-7\n*ENERGY OUTPUT, ELSET=cube\nALLKE\n*ENERGY OUTPUT, ELSET=bar\nALLKE\n")


SHARES = [("momentum_z:CUBE", LAST, BAR_MASS * SPEED * CUBE_MASS / (CUBE_MASS + BAR_MASS), 1e-9)]

PROOFS = [
    Proof("EMBEDDED ELEMENT: HOST_ELSET", hold("*EMBEDDED ELEMENT, HOST ELSET=cube\nbar,\n"), SHARES, "cube and bar go on as one: both nodes and all corners are alike"),
    Proof("EMBEDDED ELEMENT", hold("*EMBEDDED ELEMENT\nbar,\n"), SHARES, "without HOST ELSET all solids are hosts"),
    Proof("EMBEDDED ELEMENT: EXTERIOR_TOLERANCE", hold("*EMBEDDED ELEMENT, HOST ELSET=cube, EXTERIOR TOLERANCE=0.2\nbar,\n", z=11.0),
          [("momentum_z", LAST, BAR_MASS * SPEED, 1e-9), (lambda h: h["momentum_z:BAR"][-1] < 0.999 * BAR_MASS * SPEED, LAST, True, 0.0)],
          "a bar outside by 0.1 of the cube is held"),
    Proof("EMBEDDED ELEMENT", hold("*EMBEDDED ELEMENT, HOST ELSET=cube\nnone,\n"), refused="there is no element set"),
    Proof("EMBEDDED ELEMENT: HOST_ELSET", hold("*EMBEDDED ELEMENT, HOST ELSET=bar\nbar,\n"), refused="embedded elements or hosts without elements"),
    Proof("EMBEDDED ELEMENT", hold("*EMBEDDED ELEMENT, HOST ELSET=cube\nbar,\n", "*NODE\n99, 5., 5., 15.\n*RIGID BODY, REF NODE=99, ELSET=cube\n"), refused="elements in rigid bodies"),
]  # fmt: skip
