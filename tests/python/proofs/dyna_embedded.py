"""Bars in solids."""

from . import LAST, Proof
from .pieces import CUBE_MASS, DENSITY, cube, deck, elastic, node_set, nodes, part, rigid

AREA, LENGTH, SPEED = 40.0, 4.0, 1000.0  # of a bar along x about the middle of the cube
BAR_MASS = DENSITY * AREA * LENGTH
BAR = nodes((21, 3.0, 5.0, 5.0), (22, 7.0, 5.0, 5.0)) + "*ELEMENT_BEAM\n9,2,21,22,0\n" + part(2, 2, 2) + f"*SECTION_BEAM\n2,3\n{AREA!r}\n" + elastic(2)
MOVES = node_set(6, 21, 22) + f"*INITIAL_VELOCITY\n6\n0,0,{SPEED!r}\n"
PARTS = "*SET_PART_LIST\n7\n1\n*SET_PART_LIST\n8\n2\n*DATABASE_MATSUM\n1e-7\n"


def hold(*cards: str, solid: str = "") -> str:
    """The bar moves along z in a cube at rest."""
    return deck(solid or cube(), BAR, MOVES, *cards, PARTS)


def shares() -> list:
    """Both nodes and all corners are alike: cube and bar go on as one."""
    return [("momentum_z:part_1", LAST, BAR_MASS * SPEED * CUBE_MASS / (CUBE_MASS + BAR_MASS), 1e-9)]


BEAM = "*CONSTRAINED_BEAM_IN_SOLID\n2,1,1,1{}\n0{}\n"
LAGRANGE = "*CONSTRAINED_LAGRANGE_IN_SOLID\n2,1,1,1,0,{}\n0{}\n0\n"

PROOFS = [
    Proof("CONSTRAINED_BEAM_IN_SOLID: BSID SSID BSTYP SSTYP", hold(BEAM.format("", "")), shares(), "the bar takes the cube along: a common velocity"),
    Proof("CONSTRAINED_BEAM_IN_SOLID: BSID SSID BSTYP SSTYP", hold("*CONSTRAINED_BEAM_IN_SOLID_ID\n5,bars\n8,7\n0\n"), shares(), "of sets of parts"),
    Proof("CONSTRAINED_BEAM_IN_SOLID: NCOUP", hold(BEAM.format(",0,0,4", "")), shares(), "points between nodes of a bar are not needed"),
    Proof("CONSTRAINED_BEAM_IN_SOLID: START END", hold(BEAM.format("", ",1e20")), shares(), "it never ends"),
    Proof("CONSTRAINED_BEAM_IN_SOLID_PENALTY", hold("*CONSTRAINED_BEAM_IN_SOLID_PENALTY\n2,1,1,1\n0\n"), shares(), "the bond is perfect"),
    Proof("CONSTRAINED_BEAM_IN_SOLID: START", hold("*CONSTRAINED_BEAM_IN_SOLID\n2,1,1,1\n1e-6\n"), refused="START"),
    Proof("CONSTRAINED_BEAM_IN_SOLID: END", hold(BEAM.format("", ",5e-6")), refused="END"),
    Proof("CONSTRAINED_BEAM_IN_SOLID: CDIR", hold(BEAM.format(",0,0,0,1", "")), refused="slide along their axes"),
    Proof("CONSTRAINED_BEAM_IN_SOLID: BSTYP", hold("*CONSTRAINED_BEAM_IN_SOLID\n2,1,2,1\n0\n"), refused="other than parts"),
    Proof("CONSTRAINED_BEAM_IN_SOLID: SSTYP", hold("*CONSTRAINED_BEAM_IN_SOLID\n2,1,1,2\n0\n"), refused="other than parts"),
    Proof("CONSTRAINED_BEAM_IN_SOLID: SSID", hold("*CONSTRAINED_BEAM_IN_SOLID\n2,2,1,1\n0\n"), refused="bars or solids without elements"),
    Proof("CONSTRAINED_BEAM_IN_SOLID", hold(BEAM.format("", ""), solid=cube(rigid(1))), refused="rigid"),
    Proof("CONSTRAINED_LAGRANGE_IN_SOLID: LSTRSID ALESID LSTRSTYP ALESTYP CTYPE", hold(LAGRANGE.format(2, "")), shares(), "the bar takes the cube along"),
    Proof("CONSTRAINED_LAGRANGE_IN_SOLID: LSTRSID ALESID LSTRSTYP ALESTYP", hold("*CONSTRAINED_LAGRANGE_IN_SOLID\n8,7\n0\n0\n"), shares(), "of sets of parts; CTYPE is 2 if blank"),
    Proof("CONSTRAINED_LAGRANGE_IN_SOLID: START END", hold(LAGRANGE.format(2, ",1e20")), shares(), "it never ends"),
    Proof("CONSTRAINED_LAGRANGE_IN_SOLID: END", hold(LAGRANGE.format(2, ",5e-6")), refused="END"),
    Proof("CONSTRAINED_LAGRANGE_IN_SOLID: CTYPE", hold(LAGRANGE.format(4, "")), refused="a coupling with a fluid"),
    Proof("CONSTRAINED_LAGRANGE_IN_SOLID: LSTRSTYP", hold("*CONSTRAINED_LAGRANGE_IN_SOLID\n2,1,2,1\n0\n0\n"), refused="other than parts"),
]  # fmt: skip
