"""Refusals: one cause, one message; what shows once others are allowed comes with them."""

from . import Proof
from .pieces import abaqus, abaqus_cube, cube, curve, deck, hexahedron, node_set, part, shell, square, elastic, shell_section

LEANING = (
    "*ELEMENT_MASS\n1,3,1e-6\n", node_set(5, 1, 2), "*LOAD_NODE_SET\n5,3,7,1.0\n*SET_SEGMENT\n6\n1,2,3,4\n*LOAD_SEGMENT_SET\n6,7,1.0\n",
    curve(7, (0, 1.0), (1, 1.0)), "*CONSTRAINED_NODAL_RIGID_BODY\n9,0,5\n*CONSTRAINED_SPOTWELD\n1,2\n",
)  # fmt: skip
SECOND = "*ELEMENT, TYPE={}, ELSET=second\n2, {}\n"  # beside the cube
LAMINA = "*MATERIAL, NAME=ply\n*DENSITY\n1e-9\n*ELASTIC, TYPE=ANISOTROPIC\n1e5, 1e4, 0.3, 5e3, 5e3, 5e3\n"
PLIES = "".join(f"*SHELL SECTION, ELSET={name}, MATERIAL=ply\n1.\n" for name in ("second", "third"))
PROOFS = [
    Proof("ELEMENT: TYPE", abaqus(abaqus_cube(), SECOND.format("CPEG4R", "1, 2, 6, 5"), "*SOLID SECTION, ELSET=second, MATERIAL=steel\n,\n"), refused="elements CPEG4R", messages=1),
    Proof("COHESIVE SECTION", abaqus(abaqus_cube(), SECOND.format("COH3D8", "1, 2, 3, 4, 5, 6, 7, 8"), "*COHESIVE SECTION, ELSET=second, MATERIAL=steel\n1.\n"),
          refused="*COHESIVE SECTION", messages=1),
    Proof("SHELL SECTION: MATERIAL", abaqus(abaqus_cube(), SECOND.format("S4R", "1, 2, 3, 4"), "*ELEMENT, TYPE=S4R, ELSET=third\n3, 5, 6, 7, 8\n", PLIES, LAMINA),
          refused="ANISOTROPIC", messages=1),
    Proof("ELEMENT", abaqus(abaqus_cube(), SECOND.format("S4R", "1, 2, 3, 4")), refused="1 elements of S4R without a section", messages=1),
    Proof("SHELL SECTION", abaqus(abaqus_cube(), SECOND.format("S4R", "1, 2, 3, 4\n3, 1, 2, 3, 4"), "*SHELL SECTION, ELSET=second, MATERIAL=steel\n1.\n"),
          refused="*SHELL SECTION: percuss check refuses what becomes of it (at parts.SECOND of the deck)", messages=1),
    Proof("SECTION_SHELL: ELFORM", deck(shell().replace("1,2,1.0,2", "1,12,1.0,2"), *LEANING), refused="SECTION_SHELL.ELFORM", messages=2),
    Proof("SECTION_SHELL", deck(shell().replace("SECTION_SHELL", "SECTION_SHEL"), *LEANING), refused="SECTION_SHEL", messages=1),
    Proof("MAT_ELASTIC", deck(shell().replace("MAT_ELASTIC", "MAT_ELASTICS"), *LEANING), refused="did you mean *MAT_ELASTIC?", messages=1),
    Proof("ELEMENT_SHELL", deck(square().replace("ELEMENT_SHELL", "ELEMENT_SHELL_DOF"), part(), shell_section(), elastic(), *LEANING),
          refused="ELEMENT_SHELL_DOF", messages=1),
    Proof("MAT_NULL", deck(cube("*MAT_NULL\n1,7.8e-9\n*EOS_TABULATED_COMPACTION\n1,0,0\n").replace("*PART\npart_1\n1,1,1", "*PART\npart_1\n1,1,1,1")), refused="EOS_TABULATED_COMPACTION", messages=1),
    Proof("MAT_SPOTWELD", deck(cube(), hexahedron(2, 11, (0.0, 0.0, 11.0), of=2), part(2, 1, 2), "*MAT_SPOTWELD_DAMAGE-FAILURE\n2,7.8e-9,2.1e5,0.3,300.0\n0,5.0,5.0\n0,1\n*CONTACT_SPOTWELD\n2,1,3,3\n\n\n"),
          refused="MAT_SPOTWELD_DAMAGE-FAILURE", messages=1),
    Proof("SENSOR_SWITCH", deck(shell(), "*SENSOR_DEFINE_NODE\n1,1,2,X,0\n*SENSOR_SWITCH\n1,SENSOR\n"), refused="SENSOR_SWITCH"),
    Proof("ELEMENT", abaqus(abaqus_cube()).replace("1, 1, 2, 3, 4", "2, 3, 4\n1, 1, 2, 3, 4"), refused="has 11 nodes (8 are expected)"),
    Proof("ELEMENT", abaqus(abaqus_cube()) + "* , x\n", refused="has no keyword"),
    Proof("STEP", abaqus(abaqus_cube()) + "*STEP\n*DLOAD\n, GRAV, 9810., 0., 0., -1.\n*END STEP\n", refused="a step without a procedure"),
]  # fmt: skip
