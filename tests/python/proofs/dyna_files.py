"""Files that are included, moved, renumbered and converted; parameters; titles and widths of keywords; cases."""

from . import ALL, FIRST, LAST, Proof
from .pieces import CUBE_MASS, DENSITY, cube, curve, deck, elastic, force, hexahedron, node_set, nodes, part, solid_section, velocity

PLACED = "*DATABASE_HISTORY_NODE\n2\n"  # (10, 0, 0) of a cube
BLOCK = "*KEYWORD\n" + hexahedron() + part() + solid_section() + elastic() + "*END\n"
CENTER = {"part.k": BLOCK}
MOVING = "*INITIAL_VELOCITY_GENERATION\n101,2,0,7.0,0,0\n0\n"  # of part 101


def moved(rows: str, *more: str) -> str:
    """A cube in a file of its own that is moved by the rows of a transformation, turning about its node 2."""
    include = "*INCLUDE_TRANSFORM\npart.k\n0\n0\n1,1,1\n5\n"
    return deck(f"*DEFINE_TRANSFORMATION\n5\n{rows}", include, *more, PLACED, velocity(1.0))


def at(x: float, y: float, z: float):
    return [(f"node_2_{axis}", FIRST, value, 1e-9) for axis, value in zip("xyz", (x, y, z))]


def twice(offsets: str, row: str = "1,1,1") -> str:
    """A cube of a file that is included as it is, and again with offsets and factors, 30 mm higher."""
    again = f"*DEFINE_TRANSFORMATION\n5\nTRANSL,0,0,30\n*INCLUDE_TRANSFORM\npart.k\n{offsets}\n{row}\n5\n"
    return deck("*INCLUDE\npart.k\n", again, MOVING)


TRANSLATE = "DEFINE_TRANSFORMATION: TRANID OPTION A1 A2 A3 A4 A5 A6 A7; INCLUDE_TRANSFORM: TRANID"
CASES = deck("*CASE\n       101 slow\nMEMORY=20M\n1,3\n*CASE\n       102 fast\n\n         2\n*CASE\n       103\n", cube(), velocity(2.0), "*CASE_BEGIN_1\n", velocity(3.0), "*CASE_END_1\n*CASE_BEGIN_2\n",
             velocity(5.0), "*CASE_END_2\n", velocity(8.0).replace("VELOCITY", "VELOCITY CID=3"))  # fmt: skip

PROOFS = [
    Proof(TRANSLATE, moved("TRANSL,1,2,3\n"), at(11, 2, 3), "(10, 0, 0) + (1, 2, 3)", files=CENTER),
    Proof(TRANSLATE, moved("SCALE,2,3,4\n"), at(20, 0, 0), "(2 10, 0, 0)", files=CENTER),
    Proof(TRANSLATE, moved("ROTATE,0,0,2,0,10,0,90\n"), at(10, 20, 0), "about (0, 10, 0): (10, -10) turns to (10, 10)", files=CENTER),
    Proof(TRANSLATE, moved("POINT,1,0,10,0\nPOINT,2,0,10,5\nROTATE,1,2,90\n"), at(10, 20, 0), "the same by two points", files=CENTER),
    Proof(TRANSLATE, moved("MIRROR,4,0,0,7,0,0\n"), at(-2, 0, 0), "at the plane x = 4; the element stays right-handed", files=CENTER),
    Proof(TRANSLATE, moved("POINT,1,0,0,0\nPOINT,2,1,0,0\nPOINT,3,0,1,0\nPOINT,4,1,1,1\nPOINT,5,1,2,1\nPOINT,6,0,1,1\nPOS6P,1,2,3,4,5,6\n"),
          at(1, 11, 1), "x goes to y, the origin to (1, 1, 1)", files=CENTER),
    Proof(TRANSLATE.replace("A7;", "A7 M1 M2 M3 M4 M5 M6 M7 M8;"), moved("MATRIX\n0,1,0,0,-1,0,0,0\n0,0,1,0,5,6,7,1\n"), at(5, 16, 7),
          "row vectors: (10, 0, 0, 1) M = (5, 10 + 6, 7)", files=CENTER),
    Proof(TRANSLATE, moved("TRANSL,0,0,5\nROTATE,0,0,1,0,0,0,90\n"), at(0, 10, 5), "these commute", files=CENTER),
    Proof(TRANSLATE, moved("TRANSL,5,0,0\nROTATE,0,0,1,0,0,0,90\n"), at(5, 10, 0), "the last acts first: it turns, then goes by 5", files=CENTER),
    Proof(TRANSLATE + "; NODE_TRANSFORM: TRSID NSID IMMED",
          deck(cube(), nodes((21, 0.0, 0.0, 0.0), (22, 0.0, 4.0, 0.0)), "*DEFINE_TRANSFORMATION\n5\nTRANSL2ND,21,22,2\n",
               "*SET_NODE_LIST_GENERATE\n1\n1,8\n*NODE_TRANSFORM\n5,1\n", PLACED),
          at(10, 2, 0), "by 2 along y"),
    Proof("INCLUDE; INCLUDE_TRANSFORM: IDNOFF IDEOFF IDPOFF IDMOFF IDSOFF IDFOFF IDDOFF IDROFF", twice("100,100,100,100,0,0,0\n100"),
          [("momentum_x", ALL, 7.0 * CUBE_MASS, 1e-9)], "two cubes of one file; part 101 moves", files=CENTER),
    Proof("INCLUDE_TRANSFORM: TRANID", moved("TRANSL,0,0,30\n").replace("part.k\n", "part.k\n\n"), refused="TRANID is in its fifth", files={"part.k": BLOCK}),
    *(Proof("INCLUDE_TRANSFORM: IDNOFF IDSOFF IDFOFF", twice("100,100,100,100,100,100,100\n100").replace(MOVING, ""), rights, why,
            files={"part.k": BLOCK.replace("*END", node_set(4, 5, 6, 7, 8) + curve(7, (0, 1.0), (1, 1.0)) + cards + "*END")})
      for cards, rights, why in (
          ("*LOAD_NODE_SET\n4,3,7,2.0\n", [(force("z"), LAST, 2 * 4 * 2.0, 1e-6)], "the loads of both files"),
          ("*LOAD_NODE_POINT\n3,3,7,2.0\n", [(force("z"), LAST, 2 * 2.0, 1e-6)], "on one node of each"),
          ("*LOAD_SEGMENT\n7,2.0,0,5,6,7,8\n", [(force("z"), LAST, 2 * -200.0, 1e-4)], "on a face of each"),
          ("*INITIAL_VELOCITY_NODE\n3,0.0,0.0,5.0\n", [("momentum_z", FIRST, 2 * 5.0 * CUBE_MASS / 8, 1e-9)], "one node of each starts with 5 mm/s"),
          ("*INITIAL_VELOCITY\n4\n0.0,0.0,5.0\n", [("momentum_z", FIRST, 2 * 5.0 * CUBE_MASS / 2, 1e-9)], "four nodes of each start with 5 mm/s"))),
    Proof("INCLUDE_TRANSFORM: FCTMAS FCTTIM FCTLEN FCTTEM", twice("100,100,100,100,0,0,0\n100", "1e-3,1e-3,1e-1,1.0").replace("TRANSL,0,0,30", "TRANSL,0,0,20"),
          [("momentum_x", ALL, 7.0 * CUBE_MASS * 1e-3, 1e-9)], "density and volume in other units: mass times 1e-3", files=CENTER),
    Proof("INCLUDE_TRANSFORM", moved("ROTATE,0,0,1,0,0,0,90\n"), refused="LOAD_BODY_Z",
          files={"part.k": BLOCK.replace("*END", "*LOAD_BODY_Z\n7,1.0\n*DEFINE_CURVE\n7\n0,1\n1,1\n*END")}),
    Proof("INCLUDE_TRANSFORM", moved("TRANSL,1,2,3\n"), refused="PART_INERTIA",
          files={"part.k": BLOCK.replace("*PART\npart_1\n1,1,1\n", "*PART_INERTIA\npart_1\n1,1,1\n5.0,5.0,5.0,1e-5\n1.0,0,0,1.0,0,1.0\n0\n").replace("MAT_ELASTIC", "MAT_RIGID")}),
    Proof("INCLUDE_TRANSFORM: FCTTEM", twice("100,100,100,100,0,0,0\n100", "1,1,1,CtoK"), refused="FCTTEM", files=CENTER),
    Proof("INCLUDE_TRANSFORM: FCTMAS FCTTIM FCTLEN", twice("100,100,100,100,0,0,0\n100", "1e-3,1e-3,1e-1").replace("TRANSL,0,0,30", "TRANSL,0,0,20"), refused="SENSOR_DEFINE_NODE",
          files={"part.k": BLOCK.replace("*END", "*SENSOR_DEFINE_NODE\n1,1,2,X,0\n*END")}),
    Proof("PARAMETER", deck("*PARAMETER\nRrho,7.8e-9,Ipart,1\n", cube(elastic().replace(repr(DENSITY), "&rho")), velocity(2.0)),
          [("momentum_x", ALL, 2.0 * CUBE_MASS, 1e-9)], "density by its name"),
    Proof("PARAMETER_TYPE", deck("*PARAMETER_TYPE\nImat,1,MID\n", cube(elastic().replace("ELASTIC\n1", "ELASTIC\n&mat")), velocity(2.0)),
          [("momentum_x", ALL, 2.0 * CUBE_MASS, 1e-9)], "a value with the kind of id that it is"),
    Proof("PARAMETER_LOCAL", deck("*PARAMETER\nRv,2.0\n*INCLUDE\nlocal.k\n", cube(), "*INITIAL_VELOCITY\n0\n&v\n"),
          [("momentum_x", ALL, 2.0 * CUBE_MASS, 1e-9)], "of one file alone", files={"local.k": "*KEYWORD\n*PARAMETER_LOCAL\nRv,9.0\n"}),
    Proof("PARAMETER_EXPRESSION", deck("*PARAMETER_EXPRESSION\nRrho,7.8e-9/4*2**2\n", cube(elastic().replace(repr(DENSITY), "&rho")), velocity(2.0)),
          [("momentum_x", ALL, 2.0 * CUBE_MASS, 1e-9)], "an expression"),
    Proof("KEYWORD: LONG; INITIAL_VELOCITY: VX",
          deck(cube(), f"*INITIAL_VELOCITY +\n{0:20d}\n{100.0:20.1f}{20.0:20.1f}\n"),
          [("momentum_x", ALL, 100.0 * CUBE_MASS, 1e-9), ("momentum_y", ALL, 20.0 * CUBE_MASS, 1e-9)],
          "fields of 20 columns by a suffix behind a blank"),
    Proof("KEYWORD: LONG; INITIAL_VELOCITY: VX",
          deck(cube(), f"*INITIAL_VELOCITY -\n{0:10d}\n{100.0:10.1f}{20.0:10.1f}\n").replace("*KEYWORD", "*KEYWORD LONG=Y"),
          [("momentum_x", ALL, 100.0 * CUBE_MASS, 1e-9), ("momentum_y", ALL, 20.0 * CUBE_MASS, 1e-9)],
          "fields of 10 columns in a deck of 20"),
    Proof("INITIAL_VELOCITY: VX", deck(cube(), "*INITIAL_VELOCITY\n0\n       2.0\t      3.0\n"), refused="a tab stands in a line of columns"),
    Proof("KEYWORD; INITIAL_VELOCITY: VX", deck(cube().replace("part_1", "part\t1"), "*INITIAL_VELOCITY\n0\t\n2.0,\t3.0\n"), [("momentum_y", ALL, 3.0 * CUBE_MASS, 1e-9)],
          "tabs in titles, between commas and behind all fields"),
    Proof("KEYWORD", b"\xef\xbb\xbf" + deck(cube(), velocity(3.0)).encode(), [("momentum_x", ALL, 3.0 * CUBE_MASS, 1e-9)], "behind a byte order mark"),
    Proof("KEYWORD", deck(cube(), velocity(3.0)).replace("\n", "\r").encode(), [("momentum_x", ALL, 3.0 * CUBE_MASS, 1e-9)], "lines that end with CR"),
    Proof("KEYWORD", deck(cube(), velocity(3.0)).encode("utf-16"), refused="UTF-16"),
    Proof("CASE: TITLE; INITIAL_VELOCITY: VX",
          deck(cube(), "*CASE_BEGIN_1\n", velocity(3.0), "*CASE_END_1\n*CASE_BEGIN_2\n*TITLE\nother\n*PARAMETER\nRv,5.0\n", velocity(5.0), "*CASE_END_2\n"),
          [("momentum_x", ALL, 3.0 * CUBE_MASS, 1e-9)], "the first case acts", allow="CASE"),
    *(Proof("CASE; INITIAL_VELOCITY: VX", CASES, [("momentum_x", ALL, total * CUBE_MASS, 1e-9)], why, case=case) for case, total, why in
      (("101", 8.0, "inner cases 1 and 3 act, the later velocity counts"), ("102", 5.0, "inner case 2 acts"), ("103", 2.0, "no inner case acts: what is outside does"))),
    Proof("CASE", CASES, refused="--case N imports one: 101 slow, 102 fast, 103"),
    Proof("CASE", CASES, refused="there is no case 7 (there are 101", case="7"),
    Proof("CASE; INITIAL_VELOCITY: VX", deck(cube(), "*CASE_BEGIN_1\n", velocity(3.0), "*CASE_END_1\n"), [("momentum_x", ALL, 3.0 * CUBE_MASS, 1e-9)], "the only case acts"),
    Proof("CONTROL_TERMINATION", deck(cube()).replace("TERMINATION", "TERMINATON"), refused="did you mean *CONTROL_TERMINATON in line 2?"),
    Proof("PART: TITLE", deck(cube().replace("part_1", "null"), velocity(3.0)), [("momentum_x", ALL, 3.0 * CUBE_MASS, 1e-9)], "a name is a name"),
    *(Proof("PART: TITLE", deck(cube().replace("part_1", name), velocity(3.0)), [("momentum_x", FIRST, 3.0 * CUBE_MASS, 1e-9)], "a name is a name")
      for name in ("no", "1e5", "&a", " *a", "a: b", "\x1b[31mred")),
    Proof("RIGIDWALL_PLANAR: TITLE", deck(cube(), "*RIGIDWALL_PLANAR_ID\n1,R&D wall\n0\n0,0,-1,0,0,0\n", velocity(3.0)),
          [("momentum_x", FIRST, 3.0 * CUBE_MASS, 1e-9)], "'&' in a heading is no parameter"),
    Proof("NODE", deck(cube(), "*NODE_MERGE\n1\n"), refused="NODE_MERGE"),
    Proof("MAT_ADD_DAMAGE_GISSMO", deck(cube(), "*MAT_ADD_DAMAGE_GISSMO\n1,,1\n17\n"), refused="MAT_ADD_DAMAGE_GISSMO"),
    Proof("LOAD_NODE_SET_ONCE", deck(cube(), "*LOAD_NODE_SET_ONCE\n1,3,7,2.0\n"), refused="option ONCE"),
    Proof("INITIAL_VELOCITY_GENERATION_START_TIME", deck(cube(), "*INITIAL_VELOCITY_GENERATION_START_TIME\n1e-6\n"), refused="option START_TIME"),
]  # fmt: skip

NOT_PHYSICS = {"TITLE": "a name"}
