"""Layers of cohesive elements: the energy that they spend, by the laws of mixes, times 100 mm^2."""

import math

from . import LAST, Proof
from .abaqus_bodies import ENERGIES, QUADS, bond_energy, two
from .dyna_contacts import CN, CT2CN, glue_energy
from .pieces import abaqus, deck, elastic, hexahedron, part, rigid, solid_section

LAYER = "*ELEMENT, TYPE=COH3D8, ELSET=glue\n3, 5, 6, 7, 8, 11, 12, 13, 14\n"
SECTION = "*COHESIVE SECTION, ELSET=glue, MATERIAL=adhesive, RESPONSE=TRACTION SEPARATION\n{}\n"
MODULI = "*MATERIAL, NAME=adhesive\n*DENSITY\n1e-9\n*ELASTIC, TYPE=TRACTION\n{}\n"
STIFF = MODULI.format("2e4, 2e4, 2e4")
WEDGES = "*ELEMENT, TYPE=COH3D6, ELSET=glue\n3, 5, 6, 7, 11, 12, 13\n4, 5, 7, 8, 11, 13, 14\n"


def drawn(adhesive: str, vx: float, vz: float, section: str = SECTION.format(""), layer: str = LAYER, gap: float = 0.0, before: str = "") -> str:
    """b is drawn off a, to which a layer of cohesive elements joins it."""
    moves = f"*BOUNDARY\nna, 1, 3\nnb, 2, 2\n*BOUNDARY, TYPE=VELOCITY\nnb, 1, 1, {vx!r}\nnb, 3, 3, {vz!r}\n"
    return abaqus(two(gap), layer, section, adhesive, before, end=1e-3, step=moves)


def apart(surface: str = "glue, S1", of_solid: str = "sa", width: float = 10.0) -> str:
    """A layer of two elements with nodes of its own, tied to both cubes."""
    rows = "".join(f"{first + i}, {x}, {y}, {z}\n" for first, z in ((21, 10.0), (31, 10.2)) for i, (x, y) in enumerate((x, y) for y in (0.0, 10.0) for x in (0.0, width / 2, width)))
    elements = "*ELEMENT, TYPE=COH3D8, ELSET=glue\n3, 21, 22, 25, 24, 31, 32, 35, 34\n4, 22, 23, 26, 25, 32, 33, 36, 35\n"
    ties = f"*SURFACE, NAME=below\n{surface}\n*SURFACE, NAME=above\nglue, S2\n*SURFACE, NAME=whole\na,\n*TIE, NAME=one\nbelow, {of_solid}\n*TIE, NAME=other\nsb, above\n"
    return f"*NODE\n{rows}{elements}{ties}"


def opened(law: str, vx: float, vz: float, form: int = 19, gap: float = 0.0, layer: str = "*ELEMENT_SOLID\n3,3,5,6,7,8,11,12,13,14\n", more: str = "") -> str:
    """A rigid cube is moved off a held one, 0.05 mm at most, by which a layer of cohesive elements lies."""
    floor = hexahedron() + part() + solid_section() + rigid(1, 1, 7, 7)
    moves = "".join(f"*BOUNDARY_PRESCRIBED_MOTION_RIGID\n2,{dof},0,{curve},1.0\n*DEFINE_CURVE\n{curve}\n0,{v!r}\n1.0,{v!r}\n"
                    for dof, curve, v in ((1, 7, vx), (3, 8, vz)))  # fmt: skip
    above = hexahedron(2, 11, (0.0, 0.0, 10.0 + gap), of=2) + part(2, 1, 2) + rigid(2, 1, 0, 7)
    step = "*CONTROL_TIMESTEP\n0,0.9,0,0,0,9\n*DEFINE_CURVE\n9\n0,2e-8\n1.0,2e-8\n"
    return deck(floor, above, layer, part(3, 3, 3), solid_section(3, form), law, moves, step, more, end=1e-5, rows=200)


def mixed(power: float, first: str = f"3,1e-9,0,1,{CN},{CN * CT2CN},0.3,0.9", second: str = "30.0,50.0") -> str:
    return f"*MAT_COHESIVE_MIXED_MODE\n{first}\n{power!r},{second}\n"



OF_SECTION = "COHESIVE SECTION: ELSET MATERIAL RESPONSE"
OF_LAW = "MAT_COHESIVE_MIXED_MODE: MID EN ET GIC GIIC XMU T S; SECTION_SOLID: ELFORM"
BK, POWER = ENERGIES.format("BK", 1.7), ENERGIES.format("POWER LAW", 2.0)
LIMIT = [("glue_work", LAST, 100 * 0.5 * 30.0 * (0.02 + 30.0 / 2e4), 2e-3)]
MAXS = QUADS.replace("QUADS", "MAXS")
# At slides and openings of 0.999 of 50 / 2e4 and 30 / 2e4, in 1e-3 s.
UNDAMAGED = [("glue_dissipated", LAST, 0.0, 1e-12), ("glue_work", LAST, 100 * 0.5 * 2e4 * 0.999**2 * 2.5e-3**2 * (1 + 0.6**2), 1e-2)]
SOFT = "*DAMAGE EVOLUTION, TYPE=ENERGY, SOFTENING=EXPONENTIAL\n0.3,\n"
ONSET, WHOLE = 0.5 * 30.0**2 / 2e4, 0.5 * 2e4 * 0.005**2
SHARE = math.exp(-(WHOLE - ONSET) / (0.3 - ONSET))
SPENT = 100 * (ONSET + (0.3 - ONSET) * (1 - SHARE) - SHARE * WHOLE)
NOT_PHYSICS = {
    "MAT_COHESIVE_MIXED_MODE.RO": "the mass of the layer is left out; the report says so",
    "MAT_COHESIVE_MIXED_MODE.ROFLG": "likewise",
    "MAT_COHESIVE_MIXED_MODE.INTFAIL": "each node of the layer lets go by itself; the report says so",
    "COHESIVE SECTION.STACK DIRECTION": "3, the default, or refused",
}
PROOFS = [
    Proof(OF_SECTION + "; ELEMENT: TYPE", drawn(STIFF + QUADS + BK, 40.0, 30.0), [("glue_work", LAST, bond_energy(4.0, 3.0, bk=1.7), 2e-3), ("glue_failed", LAST, 100.0, 1e-9)],
          "a layer of COH3D8 between two cubes that are drawn apart: the energy by Benzeggagh and Kenane"),
    Proof(OF_SECTION, drawn(STIFF + QUADS + POWER, 40.0, 30.0), [("glue_work", LAST, bond_energy(4.0, 3.0, power=2.0), 2e-3)], "likewise by the power law"),
    Proof(OF_SECTION, drawn(MODULI.format("1e4, 1e4, 1e4") + QUADS + BK, 40.0, 30.0, SECTION.format("0.5")), [("glue_work", LAST, bond_energy(4.0, 3.0, bk=1.7), 2e-3)],
          "moduli over a thickness of 0.5"),
    Proof(OF_SECTION, drawn(MODULI.format("1e3, 1e3, 1e3") + QUADS.replace("50.", "30.") + "*DAMAGE EVOLUTION, TYPE=ENERGY\n0.9,\n", 0.0, 10.0, SECTION.format("0.5")),
          [(lambda h: h["glue_work"][-1], LAST, 100 * 0.5 * 2e3 * 0.01**2, 2e-3)], "half of the moduli over 0.5: what an elastic layer stores at 0.01 mm"),
    Proof(OF_SECTION + " THICKNESS", drawn(STIFF + QUADS + BK, 40.0, 30.0, SECTION.replace("TRACTION SEPARATION", "TRACTION SEPARATION, THICKNESS=SPECIFIED, STACK DIRECTION=3").format("1.,"), gap=0.5),
          [("glue_work", LAST, bond_energy(4.0, 3.0, bk=1.7), 2e-3)], "a layer of 0.5 mm in the mesh"),
    Proof(OF_SECTION + "; ELEMENT: TYPE", drawn(STIFF + QUADS + BK, 0.0, 30.0, layer=WEDGES), refused="faces are not those of solids"),
    Proof(OF_SECTION + "; TIE: NAME; ELEMENT: TYPE", drawn(STIFF + QUADS + BK, 40.0, 30.0, layer=apart(), gap=0.2), [("glue_work", LAST, bond_energy(4.0, 3.0, bk=1.7), 2e-3)],
          "a layer with nodes of its own, to which both cubes are tied"),
    Proof(OF_SECTION + "; TIE: NAME", drawn(STIFF + QUADS + BK, 40.0, 30.0, layer=apart(of_solid="whole"), gap=0.2), [("glue_work", LAST, bond_energy(4.0, 3.0, bk=1.7), 2e-3)],
          "of a whole cube the face at the layer"),
    Proof(OF_SECTION + "; TIE: NAME", drawn(STIFF + QUADS + BK, 40.0, 30.0, layer=apart(width=6.0), gap=0.2), refused="an area of 60, which lie at faces of solids with"),
    Proof(OF_SECTION + "; TIE: NAME", drawn(STIFF + QUADS + BK, 40.0, 30.0, layer=apart(surface="glue,"), gap=0.2), refused="a tie with a surface without elements"),
    Proof(OF_SECTION + "; DAMAGE EVOLUTION: TYPE", drawn(STIFF + QUADS.replace("50.", "30.") + "*DAMAGE EVOLUTION, TYPE=DISPLACEMENT\n0.02,\n", 40.0, 30.0), LIMIT,
          "a displacement from the start of damage to failure, the same for all mixes"),
    Proof(OF_SECTION + "; DAMAGE EVOLUTION: TYPE", drawn(STIFF + QUADS + "*DAMAGE EVOLUTION, TYPE=DISPLACEMENT\n0.02,\n", 40.0, 30.0), refused="strengths that differ"),
    Proof(OF_SECTION + "; DAMAGE INITIATION: CRITERION", drawn(STIFF + MAXS + BK, 40.0, 30.0), [("glue_work", LAST, bond_energy(4.0, 3.0, bk=1.7), 2e-3)], "the energy is that of the mix by any criterion"),
    Proof(OF_SECTION + "; DAMAGE INITIATION: CRITERION", drawn(STIFF + MAXS + BK, 0.999 * 2.5, 0.999 * 1.5), UNDAMAGED, "by MAXS both tractions stay below their strengths"),
    Proof(OF_SECTION + "; DAMAGE EVOLUTION: SOFTENING", drawn(STIFF + QUADS + SOFT, 0.0, 5.0), [("glue_dissipated", LAST, SPENT, 2e-3)], "exponential softening: (1 - exp(-(e - e0) / (G - e0))) of G - e0, less what is stored"),
    Proof(OF_SECTION + "; DAMAGE EVOLUTION: SOFTENING", drawn(STIFF + QUADS + SOFT.replace("ENERGY", "DISPLACEMENT"), 0.0, 5.0), refused="an exponential of the displacement"),
    Proof(OF_SECTION, drawn(STIFF + QUADS + BK, 0.0, 50.0, SECTION.replace("TRACTION SEPARATION", "CONTINUUM").format("1.,")), refused="RESPONSE=CONTINUUM"),
    Proof(OF_SECTION + " THICKNESS", drawn(STIFF + QUADS + BK, 0.0, 50.0, SECTION.replace("SEPARATION", "SEPARATION, THICKNESS=GEOMETRY").format("")), refused="THICKNESS=GEOMETRY"),
    Proof(OF_SECTION + " CONTROLS", drawn(STIFF + QUADS + BK, 0.0, 50.0, SECTION.replace("SEPARATION", "SEPARATION, CONTROLS=c").format(""), before="*SECTION CONTROLS, NAME=c, ELEMENT DELETION=NO\n1.,\n"),
          refused="that stay when their energy is spent"),
    Proof(OF_SECTION + " CONTROLS", drawn(STIFF + QUADS + BK, 0.0, 50.0, SECTION.replace("SEPARATION", "SEPARATION, CONTROLS=c").format(""), before="*SECTION CONTROLS, NAME=c, MAX DEGRADATION=0.5\n1.,\n"),
          refused="that stay when their energy is spent"),
    Proof(OF_SECTION + " ORIENTATION CONTROLS", drawn(STIFF + QUADS + BK, 0.0, 50.0, SECTION.replace("SEPARATION", "SEPARATION, CONTROLS=c, ORIENTATION=o").format(""), before="*ORIENTATION, NAME=o\n1., 0., 0., 0., 1., 0.\n*SECTION CONTROLS, NAME=c, ELEMENT DELETION=YES\n1.,\n"),
          [("glue_work", LAST, 30.0, 2e-3)], "the directions of shear have the same values"),
    Proof(OF_SECTION, drawn(STIFF.replace(", TYPE=TRACTION", "").replace("2e4, 2e4, 2e4", "2e4, 0.3") + QUADS + BK, 0.0, 50.0), refused="without TYPE=TRACTION"),
    Proof(OF_SECTION, drawn(STIFF + QUADS, 0.0, 50.0), refused="bonds without the data of *DAMAGE EVOLUTION"),
    Proof(OF_SECTION, drawn(STIFF + QUADS + BK + "*EXPANSION\n1e-5,\n", 0.0, 50.0), refused="*EXPANSION of the material of cohesive elements"),
    Proof(OF_LAW, opened(mixed(-1.7), 3000.0, 4000.0), [("glue_work", LAST, glue_energy(3000.0, 4000.0, bk=1.7), 2e-3), ("glue_failed", LAST, 100.0, 1e-9)],
          "a layer of ELFORM 19 between two rigid cubes: the energy by Benzeggagh and Kenane"),
    Proof(OF_LAW, opened(mixed(1.5), 3000.0, 4000.0), [("glue_work", LAST, glue_energy(3000.0, 4000.0, power=1.5), 2e-3)], "likewise by the power law"),
    Proof(OF_LAW, opened(mixed(1.5), 3000.0, 4000.0, gap=0.4), [("glue_work", LAST, glue_energy(3000.0, 4000.0, power=1.5), 2e-3)], "a layer of 0.4 mm in the mesh"),
    Proof("MAT_COHESIVE_MIXED_MODE: UND UTD", opened(mixed(1.5, second="0,0,0.02,0.036"), 3000.0, 4000.0), [("glue_work", LAST, glue_energy(3000.0, 4000.0, power=1.5), 2e-3)], "strengths by the separations of failure"),
    Proof("MAT_COHESIVE_MIXED_MODE: GAMMA", opened(mixed(-1.7, second="30.0,50.0,0,0,1.0"), 3000.0, 4000.0), [("glue_work", LAST, glue_energy(3000.0, 4000.0, bk=1.7), 2e-3)], "the default"),
    Proof("MAT_COHESIVE_MIXED_MODE: GAMMA", opened(mixed(-1.7, second="30.0,50.0,0,0,2.0"), 3000.0, 4000.0), refused="GAMMA = 2"),
    Proof("MAT_COHESIVE_MIXED_MODE: T", opened(mixed(-1.7, second="-9,50.0"), 3000.0, 4000.0), refused="a strength that depends on the size"),
    Proof("MAT_COHESIVE_MIXED_MODE: XMU", opened(mixed(0.0), 3000.0, 4000.0), refused="the exponent of the mix is expected"),
    Proof("MAT_COHESIVE_MIXED_MODE: GIC", opened(mixed(1.5, f"3,1e-9,0,1,{CN},{CN},0.01,0.9"), 3000.0, 4000.0), refused="more than its energy in normal direction"),
    Proof("SECTION_SOLID: ELFORM", opened(elastic(3), 3000.0, 4000.0), refused="cohesive elements of *MAT_ELASTIC"),
    Proof("SECTION_SOLID: ELFORM", opened(mixed(1.5), 3000.0, 4000.0, layer="*ELEMENT_SOLID\n3,3,1,2,3,5,11,12,13,14\n"), refused="faces are not those of solids"),
    Proof("SECTION_SOLID: ELFORM; MAT_COHESIVE_MIXED_MODE: XMU", opened(mixed(1.5), 3000.0, 4000.0, more="*CONTACT_AUTOMATIC_SINGLE_SURFACE\n1,0,2\n0.1\n\n*SET_PART_LIST\n1\n1,2,3\n"),
          [("glue_work", LAST, glue_energy(3000.0, 4000.0, power=1.5), 2e-3)], "in a set of parts in contact"),
]  # fmt: skip
