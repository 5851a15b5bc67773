"""Sets in all forms, boxes, systems and vectors: each names what moves or is pushed."""

from . import FIRST, LAST, Proof
from .pieces import CUBE_MASS, cube, curve, deck, force, hexahedron, node_set, part, shell, two_cubes, velocity

NODE_MASS = CUBE_MASS / 8
ONE = curve(7, (0, 1.0), (1, 1.0))


def moving(cards: str, count: int, start: str = "*INITIAL_VELOCITY\n5\n4.0\n", *, proves: str) -> Proof:
    """A set 5 of so many nodes of a cube that begins with 4 mm/s."""
    return Proof(proves, deck(cube(), cards, start), [("momentum_x", FIRST, 4.0 * count * NODE_MASS, 1e-9)], f"{count} of the eight nodes move")


def parts(cards: str, count: int, proves: str) -> Proof:
    """A set 5 of so many of three cubes that begins with 4 mm/s."""
    third = hexahedron(3, 21, (0.0, 0.0, 30.0), of=3) + part(3)
    return Proof(proves, deck(two_cubes(), third, cards, "*INITIAL_VELOCITY_GENERATION\n5,1,0,4.0,0,0\n0\n"),
                 [("momentum_x", FIRST, 4.0 * count * CUBE_MASS, 1e-9)], f"{count} of the three cubes move")  # fmt: skip


def pressed(cards: str, area: float, proves: str) -> Proof:
    """A set 5 of segments of a cube, by a pressure of 3 N/mm2 against their normals."""
    return Proof(proves, deck(cube(), cards, ONE, "*LOAD_SEGMENT_SET\n5,7,3.0\n"), [(force("z"), LAST, -3.0 * area, 1e-4)],
                 "pressure times area, against the normal of the nodes")  # fmt: skip


def pressed_shells(cards: str, area: float, proves: str) -> Proof:
    second = "*NODE\n11,20.0,0,0\n12,20.0,10.0,0\n*ELEMENT_SHELL\n2,2,2,11,12,3\n" + part(2)
    return Proof(proves, deck(shell(), second, cards, ONE, "*LOAD_SHELL_SET\n5,7,3.0\n"), [(force("z"), LAST, -3.0 * area, 1e-4)], "pressure times area")


def cut(cards: str, proves: str) -> Proof:
    """The force of a set 6 of solids on the held base of a cube: what of four loads of 2 N does not go into momentum."""
    held = node_set(5, 1, 2, 3, 4) + "*BOUNDARY_SPC_SET\n5,0,1,1,1\n" + node_set(8, 5, 6, 7, 8) + "*LOAD_NODE_SET\n8,3,7,2.0\n" + ONE
    section = "*DATABASE_CROSS_SECTION_SET_ID\n1,cut\n5,6\n"

    def error(h: dict[str, list[float]]) -> float:
        impulse = sum(f * (b - a) for f, a, b in zip(h["fz:cut"][1:], h["time"], h["time"][1:]))
        return (impulse + h["momentum_z"][-1]) / (h["time"][-1] - 0.5 * h["dt"][-1])

    return Proof(proves, deck(cube(), held, cards, section, end=5e-5), [(error, LAST, 8.0, 1e-6)], "the impulse of the section and the momentum are that of the loads")


TOP = "5,6,7,8"
BOX = "*DEFINE_BOX\n3,-1,11,-1,11,9,11\n"  # the upper four nodes
# x of the box is (1, 1, 0) / sqrt(2) from (10, 0, 0): only nodes 3 and 7 have x above 5 there
LOCAL_BOX = "*DEFINE_BOX_LOCAL\n3,5.0,99,-99,99,-99,99\n1,1,0,0,1,0\n10,0,0\n"
PROOFS = [
    moving("*SET_NODE\n5\n1,2,3\n", 3, proves="SET_NODE: SID"),
    moving("*SET_NODE_LIST\n5\n1,2,3\n", 3, proves="SET_NODE_LIST: SID; INITIAL_VELOCITY: NSID"),
    moving("*SET_NODE_LIST_GENERATE\n5\n1,2,4,7\n", 6, proves="SET_NODE_LIST_GENERATE: SID"),
    moving("*SET_NODE_LIST_GENERATE_INCREMENT\n5\n1,8,3\n", 3, proves="SET_NODE_LIST_GENERATE_INCREMENT: SID BBEG BEND INCR"),
    moving("*SET_NODE_GENERAL\n5\nNODE,1,2,3\nDNODE,2\n", 2, proves="SET_NODE_GENERAL: SID"),
    moving("*SET_NODE_GENERAL\n5\nALL\nDNODE,2\n", 7, proves="SET_NODE_GENERAL: SID"),
    moving(BOX.replace("\n3,", "\n2,50,60,50,60,50,60\n3,") + "*SET_NODE_GENERAL\n5\nBOX,3\n", 4, proves="DEFINE_BOX: BOXID"),
    moving(BOX + "*SET_NODE_GENERAL\n5\nBOX,3\n", 4, proves="SET_NODE_GENERAL: SID; DEFINE_BOX: BOXID XMN XMX YMN YMX ZMN ZMX"),
    moving(BOX + "*SET_NODE_GENERAL\n5\nPART,1\nDBOX,3\n", 4, proves="SET_NODE_GENERAL: SID"),
    moving(LOCAL_BOX + "*SET_NODE_GENERAL\n5\nBOX,3\n", 2,
           proves="DEFINE_BOX_LOCAL: BOXID XMN XMX YMN YMX ZMN ZMX XX YX ZX XV YV ZV CX CY CZ"),
    moving(node_set(6, 1, 2) + node_set(8, 2, 3) + "*SET_NODE_ADD\n5\n6,8\n", 3, proves="SET_NODE_ADD: SID"),
    moving("*SET_NODE_COLUMN\n5\n1,0.5\n2,0.5\n", 2, proves="SET_NODE_COLUMN: SID NID"),
    moving("*SET_NODE_LIST_COLLECT\n5\n1,2\n*SET_NODE_LIST_COLLECT\n5\n2,3\n", 3, proves="SET_NODE_LIST_COLLECT: SID"),
    moving(BOX, 4, start="*INITIAL_VELOCITY\n0,0,3\n4.0\n", proves="INITIAL_VELOCITY: BOXID"),
    Proof("SET_NODE_LIST", deck(cube(), "*SET_NODE_LIST\n5\n1,2,3,4,5,6,7,8,1\n"), refused="more than 8 ids"),
    Proof("SET_NODE_GENERAL: SID", deck(cube(), "*SET_NODE_GENERAL\n5\nSET_SHELL,1\n"), refused="SET_NODE_GENERAL.SET_SHELL"),
    parts("*SET_PART\n5\n1,3\n", 2, "SET_PART: SID"),
    parts("*SET_PART_LIST_GENERATE\n5\n2,9\n", 2, "SET_PART_LIST_GENERATE: SID"),
    parts("*SET_PART_GENERAL\n5\nALL\nDPART,2\n", 2, "SET_PART_GENERAL: SID"),
    parts("*DEFINE_BOX\n3,-1,11,-1,11,-1,22\n*SET_PART_GENERAL\n5\nBOX,3\n", 2, "SET_PART_GENERAL: SID"),
    parts("*SET_PART_ADD\n5\n6\n*SET_PART_LIST\n6\n1\n", 1, "SET_PART_ADD: SID; SET_PART_LIST: SID"),
    pressed(f"*SET_SEGMENT\n5\n{TOP}\n", 100.0, "SET_SEGMENT: SID N1 N2 N3 N4; LOAD_SEGMENT_SET"),
    pressed("*SET_SEGMENT_GENERAL\n5\nSEG,5,6,7,8\n", 100.0, "SET_SEGMENT_GENERAL: SID"),
    pressed("*SET_SEGMENT_GENERAL\n5\nPART,1\nDSEG,1,2,3,4\n", 100.0, "SET_SEGMENT_GENERAL: SID"),
    Proof("SET_SEGMENT_GENERAL: SID", deck(two_cubes(), "*SET_SEGMENT_GENERAL\n5\nALL\nDPART,2\nDSEG,5,6,7,8\n", ONE, "*LOAD_SEGMENT_SET\n5,7,3.0\n"),
          [(force("z"), LAST, 300.0, 1e-4)], "all faces of the first cube but its upper one push it up"),
    pressed_shells("*SET_SHELL\n5\n2\n", 100.0, "SET_SHELL: SID; LOAD_SHELL_SET"),
    pressed_shells("*SET_SHELL_LIST_GENERATE\n5\n1,9\n", 200.0, "SET_SHELL_LIST_GENERATE: SID"),
    pressed_shells("*SET_SHELL_GENERAL\n5\nPART,2\n", 100.0, "SET_SHELL_GENERAL: SID"),
    pressed_shells("*SET_SHELL_GENERAL\n5\nALL\nDELEM,1\n", 100.0, "SET_SHELL_GENERAL: SID"),
    pressed_shells("*DEFINE_BOX\n3,9,21,-1,11,-1,1\n*SET_SHELL_GENERAL\n5\nBOX,3\n", 100.0, "SET_SHELL_GENERAL: SID"),
    cut("*SET_SOLID\n6\n1\n", "SET_SOLID: SID; DATABASE_CROSS_SECTION_SET: NSID HSID"),
    cut("*SET_SOLID_GENERAL\n6\nPART,1\n", "SET_SOLID_GENERAL: SID"),
    cut("*SET_SOLID_LIST_GENERATE\n6\n1,7\n", "SET_SOLID_LIST_GENERATE: SID"),
    *(Proof(f"{card}; INITIAL_VELOCITY: ICID", deck(cube(), system, "*INITIAL_VELOCITY\n0,0,0,0,4\n1.0,2.0,3.0\n"),
            [("momentum_x", FIRST, -2.0 * CUBE_MASS, 1e-9), ("momentum_y", FIRST, 1.0 * CUBE_MASS, 1e-9), ("momentum_z", FIRST, 3.0 * CUBE_MASS, 1e-9)],
            "axes that are turned by 90 degrees about z: x is y, y is -x")
      for card, system in (
          ("DEFINE_COORDINATE_SYSTEM: CID XO YO ZO XL YL ZL XP YP ZP", "*DEFINE_COORDINATE_SYSTEM\n4,1,1,1,1,2,1\n0,2,1\n"),
          ("DEFINE_COORDINATE_VECTOR: CID XX YX ZX XV YV ZV", "*DEFINE_COORDINATE_VECTOR\n4,0,2,0,-1,1,0\n"),
          ("DEFINE_COORDINATE_NODES: CID N1 N2 N3", "*DEFINE_COORDINATE_NODES\n4,2,3,1\n"))),
    *(Proof(card, deck(cube(), system, "*INITIAL_VELOCITY\n0,0,0,0,4\n1.0,2.0,3.0\n"), refused="coordinate system 4")
      for card, system in (
          ("DEFINE_COORDINATE_SYSTEM: CIDL", "*DEFINE_COORDINATE_SYSTEM\n4,1,1,1,1,2,1,9\n0,2,1\n"),
          ("DEFINE_COORDINATE_VECTOR: NID", "*DEFINE_COORDINATE_VECTOR\n4,0,2,0,-1,1,0,3\n"),
          ("DEFINE_COORDINATE_NODES: FLAG", "*DEFINE_COORDINATE_NODES\n4,2,3,1,1\n"),
          ("DEFINE_COORDINATE_NODES: DIR", "*DEFINE_COORDINATE_NODES\n4,2,3,1,0,Y\n"))),
    Proof("DEFINE_VECTOR: CID", deck(cube(), "*SET_NODE_LIST_GENERATE\n5\n1,8\n*DEFINE_VECTOR\n2,0,0,0,0,0,1,4\n*BOUNDARY_PRESCRIBED_MOTION_SET\n5,4,0,7,6.0,2\n",
                                     "*DEFINE_COORDINATE_VECTOR\n4,0,2,0,-1,1,0\n", ONE), refused="no such vector in global axes"),
    Proof("DEFINE_COORDINATE_VECTOR", deck(cube(), "*DEFINE_COORDINATE_VECTOR\n4,0,2,0,0,1,0\n"), refused="along one line"),
    Proof("DEFINE_VECTOR: VID XT YT ZT XH YH ZH; BOUNDARY_PRESCRIBED_MOTION_SET: VID",
          deck(cube(), velocity(), "*SET_NODE_LIST_GENERATE\n5\n1,8\n*DEFINE_VECTOR\n2,1,1,1,1,1,-4\n*BOUNDARY_PRESCRIBED_MOTION_SET\n5,4,0,7,6.0,2\n", ONE),
          [("momentum_z", LAST, -6.0 * CUBE_MASS, 1e-6)], "6 mm/s along -z"),
]  # fmt: skip

UNKNOWN = "of elements that percuss does not have; a card that uses it is refused"
NOT_PHYSICS = {"SET_BOX": UNKNOWN, "SET_DISCRETE": UNKNOWN, "SET_TSHELL": UNKNOWN}
