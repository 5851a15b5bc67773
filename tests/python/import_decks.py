"""Keyword decks for the tests of percuss import: small, and each card by the rules of the manual."""

_HEAD = """\
*KEYWORD
*TITLE
a block and a plate
*CONTROL_TERMINATION
$   endtim    endcyc     dtmin
   1.0E-04         0      0.01
*CONTROL_TIMESTEP
       0.0      0.67
"""

BLOCK_NODES = """\
*NODE
$    nid               x               y               z      tc      rc
       1             0.0             0.0             0.0       7       7
       2             1.0             0.0             0.0       3       0
       3             1.0             1.0             0.0
       4             0.0             1.0             0.0
      11             0.0             0.0             1.0
      12             1.0             0.0             1.0
      13             1.0             1.0             1.0
      14             0.0             1.0             1.0
"""

# One cube in two lines, as older decks have it.
BLOCK = (
    BLOCK_NODES
    + """\
*ELEMENT_SOLID
$    eid     pid
     500       3
$     n1      n2      n3      n4      n5      n6      n7      n8
       1       2       3       4      11      12      13      14
*PART
block of steel
$      pid     secid       mid     eosid      hgid
         3         3         3         0         0
*SECTION_SOLID
         3         1
*MAT_ELASTIC_TITLE
steel
$      mid        ro         e        pr
         3    7850.0    2.0e11       0.3
"""
)

# A quadrilateral and a triangle over it, with a gap.
PLATE = """\
*NODE
      21             0.0             0.0             1.2
      22             1.0             0.0             1.2
      23             1.0             1.0             1.2
      24             0.0             1.0             1.2
      25             2.0             0.5             1.2
*ELEMENT_SHELL
     500       8      21      22      23      24
     501       8      22      25      23      23
*PART
plate
         8         8         8
*SECTION_SHELL
$    secid    elform      shrf       nip
         8        16    0.8333         5
$       t1        t2        t3        t4      nloc
       0.1       0.1       0.1       0.1       1.0
*MAT_PIECEWISE_LINEAR_PLASTICITY
$      mid        ro         e        pr      sigy      etan      fail
         8    7850.0    2.0e11       0.3     3.0e8       0.0       0.4
$        c         p      lcss
      40.0       5.0         9
$ eps and es
       0.0
       0.0
*DEFINE_CURVE
$     lcid      sidr       sfa       sfo      offa      offo
         9         0       0.5     1.0e6       0.0      10.0
                 0.0               290.0
                 0.2               390.0
                 0.4               410.0
"""

CONDITIONS = """\
*SET_NODE_LIST_TITLE
the right edge
        60
        22        23
*BOUNDARY_SPC_SET
$     nsid       cid      dofx      dofy      dofz     dofrx     dofry     dofrz
        60         0         0         1         0         1         0         0
*BOUNDARY_PRESCRIBED_MOTION_NODE
$      nid       dof       vad      lcid        sf
        25         3         0        61      -2.0
*DEFINE_CURVE
        61
                 0.0                 0.0
             5.0e-05                 1.0
             6.0e-05                 1.0
*INITIAL_VELOCITY
$     nsid    nsidex
         0        60
$       vx        vy        vz
       0.0       0.0      -5.0
       1.0       0.0       0.0
*LOAD_BODY_Z
        62      9.81
*DEFINE_CURVE
        62
                 0.0                 1.0
                 1.0                 1.0
*LOAD_SEGMENT
$     lcid        sf        at        n1        n2        n3        n4
        62     1.0e5       0.0        11        12        13        14
*LOAD_NODE_SET
        60         1        61     100.0
"""

CONTACTS = """\
*SET_PART_LIST
        70
         3         8
*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID
$      cid
        71everything
$     ssid      msid     sstyp     mstyp
        70         0         2         0
$       fs        fd        dc
      0.15       0.1      10.0

*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE
         3         8         3         3
       0.3

*RIGIDWALL_PLANAR_ID
        72floor
         0         0         0       0.0
       0.0       0.0      -0.1       0.0       0.0       0.9       0.1
"""

OUTPUT = """\
*DATABASE_BINARY_D3PLOT
   1.0E-05
*DATABASE_MATSUM
   1.0E-06
*DATABASE_RWFORC
   2.0E-06
*DATABASE_HISTORY_NODE
        25         1
*DATABASE_EXTENT_BINARY
         0         0         3
*CONTROL_ENERGY
         2         2
*END
what follows is not read
"""

FULL = _HEAD + BLOCK + PLATE + CONDITIONS + CONTACTS + OUTPUT
SMALL = _HEAD + BLOCK + "*END\n"
# A quadrilateral that is bent, by two points in the plane and two across, and a block that is stretched.
STRESSED = FULL.replace(
    "*END",
    """\
*INITIAL_STRESS_SHELL
$      eid    nplane    nthick     nhisv    ntensr     large
       500         2         2
$        t     sigxx     sigyy     sigzz     sigxy     sigyz     sigzx       eps
      -1.0    -9.0e6       0.0       0.0       0.0       0.0       0.0       0.0
       1.0     9.0e6       0.0       0.0       0.0       0.0       0.0      0.02
      -1.0   -11.0e6       0.0       0.0       0.0       0.0       0.0       0.0
       1.0    11.0e6       0.0       0.0       0.0       0.0       0.0      0.02
*INITIAL_STRESS_SOLID
       500         1
       0.0       0.0     5.0e6     1.0e6       0.0       0.0
*END""",
)


# A bolt of two beams with a force, one without, and a stress of a section through the block.
BOLTS = SMALL.replace(
    "*END",
    "*NODE\n31,3,0,0\n32,3,0,1\n33,3,0,2\n34,3,0,3\n*ELEMENT_BEAM\n71,7,31,32,0\n72,7,32,33,0\n73,7,33,34,0\n"
    "*PART\nbolt\n7,7,3\n*SECTION_BEAM\n7,1,1.0,2,1\n0.02,0.02,0.0,0.0\n*SET_BEAM\n6\n71,72\n"
    "*INITIAL_AXIAL_FORCE_BEAM\n6,9,2.0\n*DEFINE_CURVE\n9\n0.0,0.0\n1.0,2.0e4\n2.0,2.0e4\n"
    "*DATABASE_CROSS_SECTION_PLANE_ID\n4,through the block\n0,0.5,0.5,0.25,0.5,0.5,1.0,0.0\n1.0,0.5,0.25,0.0,0.0\n"
    "*INITIAL_STRESS_SECTION\n5,4,8,0\n*DEFINE_CURVE\n8\n0.0,0.0\n1.0,5.0e6\n*END",
)


# The block between a cylinder, a sphere and a plane that move; its cube is a tetrahedron of ten nodes.
ROUND_WALLS = SMALL.replace(
    "*END",
    "*RIGIDWALL_GEOMETRIC_CYLINDER_MOTION_DISPLAY_ID\n7,pole\n0,0,0\n5,0,-2,5,0,3,0.2\n0.4,2.5\n9,0,0,3,4\n,1e-9,1e-4,0.3\n"
    "*RIGIDWALL_GEOMETRIC_SPHERE\n0\n0,0,9\n1.5\n"
    "*RIGIDWALL_GEOMETRIC_FLAT_MOTION\n0\n0,0,8,0,0,7\n1,0,8,6,5\n9,1,0,0,1\n"
    "*DEFINE_CURVE\n9\n0.0,2.0\n1.0,4.0\n*END",
)
TEN_NODES = SMALL.replace(
    "*ELEMENT_SOLID",
    "*NODE\n101,0.5,0,0\n102,1,0.5,0\n103,0.5,0.5,0\n104,0,0,0.5\n105,0.5,0,0.5\n106,0.5,0.5,0.5\n*ELEMENT_SOLID",
).replace("       1       2       3       4      11      12      13      14\n", "1,2,3,11,101,102,103,104,105,106\n")


def make_block(material: str, state: str = "", shells: bool = False) -> str:
    """A deck of one element of a material 1, with an equation of state 2 if there is a card of it."""
    element = (
        "*ELEMENT_SHELL\n5,1,1,2,3,4\n*SECTION_SHELL\n1,2\n0.1,0.1,0.1,0.1\n"
        if shells
        else ("*ELEMENT_SOLID\n5,1,1,2,3,4,11,12,13,14\n*SECTION_SOLID\n1,1\n")
    )
    part = f"*PART\npart\n1,1,1,{2 if state else 0}\n"
    return _HEAD + BLOCK_NODES + element + part + material + state + "*END\n"


LINEAR = "*EOS_LINEAR_POLYNOMIAL\n2,0.0,1.6e11,0.0,0.0,0.0,0.0,0.0\n0.0,1.0\n"
GRUNEISEN = "*EOS_GRUNEISEN\n2,3940.0,1.489,0.0,0.0,2.02,0.0,0.0\n1.0\n"
JWL = "*EOS_JWL\n2,6.1e11,1.3e10,4.5,1.4,0.25,9.0e9,1.0\n"
CURVE = "*DEFINE_CURVE\n7\n0.0,1.0e6\n0.5,2.0e6\n0.9,9.0e6\n"

# Name of a law in percuss, cards, equation of state, whether for shells.
LAWS = {
    "kinematic": (
        "combined_hardening",
        "*MAT_PLASTIC_KINEMATIC\n1,7850.0,2.0e11,0.3,3.0e8,1.0e9,0.25\n40.0,5.0,0.3,1.0\n",
        "",
        True,
    ),
    "isotropic": ("j2_plasticity", "*MAT_003\n1,7850.0,2.0e11,0.3,3.0e8,1.0e9,1.0\n0.0\n", "", False),
    "table": ("tabulated_plasticity", "*MAT_024\n1,7850.0,2.0e11,0.3,1.0,1.0,1e21\n0,0,0\n0,0.1,0.3\n3e8,4e8,4.5e8\n", "", True),
    "modified": ("j2_plasticity", "*MAT_123\n1,7850.0,2.0e11,0.3,3.0e8,1.0e9,0.3\n0,0,0,0,0,0,0.4,1\n0\n0\n", "", True),
    "shear": ("j2_plasticity", "*MAT_ISOTROPIC_ELASTIC_PLASTIC\n1,7850.0,8.0e10,3.0e8,1.0e9,1.6e11\n", "", False),
    "shear_failure": ("j2_plasticity", "*MAT_013\n1,7850.0,8.0e10,3.0e8,1.0e9,1.6e11\n0.4,-1e9,0\n", "", False),
    "hydro": ("j2_plasticity", "*MAT_ELASTIC_PLASTIC_HYDRO\n1,7850.0,8.0e10,3.0e8,1.0e9,0.0,0.5\n0\n0\n0\n0\n", LINEAR, False),
    "johnson_cook": ("johnson_cook", "*MAT_JOHNSON_COOK\n1,8960.0,4.6e10,1.2e11,0.35\n9.0e7,2.92e8,0.31,0.025,1.09,1356.0,293.0,1.0\n"
                     "383.0,0.0,2.0,0.0,0.54,4.89,3.03,0.014\n1.12\n", GRUNEISEN, False),  # fmt: skip
    "simplified": (
        "johnson_cook",
        "*MAT_SIMPLIFIED_JOHNSON_COOK\n1,7850.0,2.0e11,0.3\n3.0e8,4.0e8,0.3,0.01,0.5,1e28,1e28,1e-3\n",
        "",
        True,
    ),
    "power": ("tabulated_plasticity", "*MAT_POWER_LAW_PLASTICITY\n1,7850.0,2.0e11,0.3,6.0e8,0.2\n3.0e8\n", "", True),
    "soil": (
        "soil_and_foam",
        "*MAT_SOIL_AND_FOAM\n1,1800.0,3.0e7,1.0e9,3.0e10,0.0,0.0,-1e3\n0.0\n0,-0.05,-0.1\n0\n0,1e6,5e6\n0\n",
        "",
        False,
    ),
    "viscous": ("viscoelastic", "*MAT_VISCOELASTIC\n1,1200.0,2.0e9,5.0e7,1.0e7,100.0\n", "", False),
    "blatz": ("neo_hookean", "*MAT_BLATZ-KO_RUBBER\n1,1200.0,1.0e6\n", "", False),
    "mooney": ("mooney_rivlin", "*MAT_MOONEY-RIVLIN_RUBBER\n1,1200.0,0.49,5.0e5,1.0e5\n0\n", "", False),
    "foam": ("low_density_foam", CURVE + "*MAT_LOW_DENSITY_FOAM\n1,60.0,1.0e7,7,1e20,0.1\n5.0\n", "", False),
    "crushable": ("honeycomb", CURVE + "*MAT_CRUSHABLE_FOAM\n1,60.0,1.0e7,0.0,7,1e5,0.1\n", "", False),
    "honeycomb": (
        "honeycomb",
        CURVE + "*MAT_HONEYCOMB\n1,80.0,7.0e10,0.33,2.0e8,0.1\n7,0,0,0\n1e9,3e8,3e8,4e8,4e8,2e8,2.0\n0,0,0,1,0,0\n0,1,0\n",
        "",
        False,
    ),
    "fluid": ("fluid", "*MAT_NULL\n1,1000.0\n", GRUNEISEN, False),
    "elastic_fluid": ("fluid", "*MAT_ELASTIC_FLUID\n1,1000.0,0,0,0,0,2.2e9\n0\n", "", False),
    "explosive": (
        "fluid",
        "*MAT_HIGH_EXPLOSIVE_BURN\n1,1630.0,6930.0,2.1e10\n*INITIAL_DETONATION\n1,0.5,0.5,0.0,0.0\n",
        JWL,
        False,
    ),
}

PARAMETERS = (
    _HEAD.replace(
        "*CONTROL_TERM",
        """*PARAMETER
R   rho,   7850.0, I   five, 5
R    e0    2.0e11
*PARAMETER_EXPRESSION
Rhalf      0.5*(&rho+rho*0)/(1+sqrt(4.0)-2)
Ithird     &five/3
*CONTROL_TERM""",
    )
    + BLOCK.replace("    7850.0    2.0e11", "     &half       &e0")
    + "*END\n"
)

WIDE = (
    """\
*KEYWORD LONG=Y
*CONTROL_TERMINATION
              1.0e-4
*NODE
"""
    + "".join(
        f"{i:20d}{x:20.6f}{y:20.6f}{z:20.6f}\n"
        for i, (x, y, z) in enumerate(
            ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)), 900000000001
        )
    )
    + """\
*ELEMENT_SOLID-
   77700       1
"""
    + "*ELEMENT_SOLID+\n"
    + f"{123456789012:20d}{1:20d}"
    + "".join(f"{900000000000 + i:20d}" for i in range(1, 9))
    + """
*PART+
wide
                   1                   1                   1
*SECTION_SOLID
                   1                   1
*MAT_ELASTIC
                   1              7850.0              2.0e11                 0.3
*END
"""
)
WIDE = WIDE.replace("*ELEMENT_SOLID-\n   77700       1\n", "")

RIGID = (
    _HEAD
    + BLOCK.replace("*MAT_ELASTIC_TITLE\nsteel\n", "*MAT_RIGID\n").replace(
        "       0.3\n", "       0.3\n       1.0       4.0       7.0\n\n"
    )
    + """\
*BOUNDARY_PRESCRIBED_MOTION_RIGID
         3         3         0        61       1.0
*DEFINE_CURVE
        61
                 0.0                 0.0
             5.0e-05                 1.0
*NODE
      99             0.5             0.5             2.0
*END
"""
)

_CORNERS = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))

# A second block apart from the first, of the same material.
TWO_PARTS = (
    _HEAD
    + BLOCK
    + "*NODE\n"
    + "".join(
        f"{31 + i},{3.0 + x},{1.0 * y},{1.0 * z}\n"
        for i, (x, y, z) in enumerate(_CORNERS)
    )
    + "*ELEMENT_SOLID\n600,4,31,32,33,34,35,36,37,38\n*PART\nsecond\n4,4,3\n*SECTION_SOLID\n4,1\n*END\n"
)
TWO_RIGID = TWO_PARTS.replace("*MAT_ELASTIC_TITLE\nsteel\n", "*MAT_RIGID\n").replace("       0.3\n", "       0.3\n1.0,0,0\n\n")

# A hinge between two rigid blocks, at nodes without elements; a ball joint from one to two nodes of a block that deforms.
JOINTED = (
    TWO_RIGID.replace("*END\n", "")
    + "*NODE\n101,2.0,0.5,0.5\n102,2.0,0.5,0.5\n103,2.0,0.5,1.5\n104,2.0,0.5,1.5\n105,4.0,1.0,1.0\n106,4.0,1.0,1.0\n"
    + "".join(f"{131 + i},{5.0 + x},{1.0 * y},{1.0 * z}\n" for i, (x, y, z) in enumerate(_CORNERS))
    + "*ELEMENT_SOLID\n700,5,131,132,133,134,135,136,137,138\n*PART\nsoft\n5,4,8\n*MAT_ELASTIC\n8,7850.0,2.0e11,0.3\n"
    + "*SET_NODE_LIST\n11\n101,103\n*SET_NODE_LIST\n12\n102,104,105,131\n*SET_NODE_LIST\n13\n132,133,106\n"
    + "*CONSTRAINED_EXTRA_NODES_SET\n3,11\n*CONSTRAINED_EXTRA_NODES_SET\n4,12\n"
    + "*CONSTRAINED_NODAL_RIGID_BODY_TITLE\nhub\n20,0,13\n"
    + "*CONSTRAINED_JOINT_REVOLUTE_ID\n7,hinge\n101,102,103,104,0,0,1.0\n*CONSTRAINED_JOINT_SPHERICAL\n105,106\n*END\n"
)

FORMS = (
    _HEAD
    + BLOCK
    + PLATE
    + """\
*SET_NODE_LIST_GENERATE
1
1,999999999999
*SET_NODE_GENERAL
2
PART,8
DNODE,25
*SET_SHELL_LIST
3
500,501
*SET_SEGMENT
4
11,12,13,14
21,22,23,24
*DEFINE_BOX
5,-1,3,-1,3,1.1,1.3
*DEFINE_VECTOR
6,0,0,0,0,0,-2
*SET_PART_LIST_GENERATE
7
1,9
*ELEMENT_SEATBELT_ACCELEROMETER
1,1,2,4,1,1
*ELEMENT_MASS
1,3,2.5
2,4,2.5
*BOUNDARY_PRESCRIBED_MOTION_SET_ID
1,push
2,4,2,8,0.5,6
*DEFINE_CURVE
8
0,0
1,1
*INITIAL_VELOCITY_GENERATION
8,2,100.0,1.0,0.0,0.0
0.5,0.5,0.0,0.0,0.0,2.0
*INITIAL_VELOCITY_NODE
1,0.0,0.0,7.0
*LOAD_SHELL_SET
3,8,1e4
*LOAD_SEGMENT_SET
4,8,1e4
*CONTACT_TIED_NODES_TO_SURFACE_OFFSET
2,3,4,3
0
1,1,-0.5,-0.5
*CONTACT_AUTOMATIC_NODES_TO_SURFACE
2,3,4,3
0.2
0
*CONTACT_FORCE_TRANSDUCER_PENALTY
8,0,3
0
0
*HOURGLASS
1,4,0.05
*CONTROL_BULK_VISCOSITY
1.44,0.06
*DATABASE_RCFORC
1e-6
*DATABASE_HISTORY_SHELL
501
*END
"""
)

# Springs and dampers between the corners of the plate and the block.
SPRINGS = (
    _HEAD
    + BLOCK
    + PLATE
    + """\
*ELEMENT_DISCRETE
    9001      20       1      21
    9002      20       2      22       0             2.5
    9003      21       3      23
    9004      22       4      24
*PART
springs
20,20,20
*PART
dampers
21,20,21
*PART
straps
22,20,22
*SECTION_DISCRETE
20,0
0,0
*MAT_SPRING_ELASTIC
20,1000.0
*MAT_S02
21,3.5
*MAT_SPRING_NONLINEAR_ELASTIC
22,23
*DEFINE_CURVE
23
0,0
0.1,50
0.2,80
*END
"""
)

ABAQUS = """\
*HEADING
a plate of shells falls on a block
** one part of solids, one of shells, each with an instance
*PART, NAME=Block
*NODE
1, 0., 0., 0.
2, 1., 0., 0.
3, 1., 1., 0.
4, 0., 1., 0.
5, 0., 0., 1.
6, 1., 0., 1.
7, 1., 1., 1.
8, 0., 1., 1.
*ELEMENT, TYPE=C3D8R, ELSET=all
1, 1, 2, 3, 4, 5, 6,
7, 8
*NSET, NSET=foot, GENERATE
1, 4, 1
*SURFACE, NAME=top
all, S2
*SOLID SECTION, ELSET=all, MATERIAL=steel
,
*END PART
*PART, NAME=plate
*NODE, NSET=every
1, 0., 0., 0.
2, 1., 0., 0.
3, 1., 1., 0.
4, 0., 1., 0.
5, 2., 0.5, 0.
*ELEMENT, TYPE=S4R, ELSET=quads
10, 1, 2, 3, 4
*ELEMENT, TYPE=S3R, ELSET=tris
11, 2, 5, 3
*ELSET, ELSET=shell
quads, tris
*SURFACE, NAME=lower
shell, SNEG
*SHELL SECTION, ELSET=shell, MATERIAL=soft, OFFSET=SNEG
0.1, 5
*END PART
*ASSEMBLY, NAME=assembly
*INSTANCE, NAME=block-1, PART=block
*END INSTANCE
*INSTANCE, NAME=plate-1, PART=plate
0., 0., 1.2
0., 0., 1.2, 0., 0., 2.2, 90.
*END INSTANCE
*NSET, NSET=tip, INSTANCE=plate-1
5,
*SURFACE, NAME=both
plate-1.shell,
*END ASSEMBLY
*AMPLITUDE, NAME=ramp
0., 0., 5.e-5, 1.
*MATERIAL, NAME=steel
*DENSITY
7850.,
*ELASTIC
2.e11, 0.3
*MATERIAL, NAME=Soft
*DENSITY
2700.,
*ELASTIC
7.e10, 0.33
*PLASTIC
1.e8, 0.
1.5e8, 0.2
*RATE DEPENDENT, TYPE=POWER LAW
6500., 4.
*SURFACE INTERACTION, NAME=rough
*FRICTION
0.25,
*BOUNDARY
block-1.foot, ENCASTRE
*INITIAL CONDITIONS, TYPE=VELOCITY
plate-1.every, 3, -10.
*STEP
*DYNAMIC, EXPLICIT
, 1.e-4
*BULK VISCOSITY
0.06, 1.2
*BOUNDARY, TYPE=VELOCITY, AMPLITUDE=ramp
tip, 1, 1, 2.
*DLOAD
, GRAV, 9.81, 0., 0., -1.
*DSLOAD
block-1.top, P, 1.e5
*CLOAD
tip, 2, 50.
*CONTACT
*CONTACT INCLUSIONS, ALL EXTERIOR
*CONTACT PROPERTY ASSIGNMENT
 , , rough
*OUTPUT, FIELD, NUMBER INTERVAL=10
*NODE OUTPUT
U,
*END STEP
"""

# The block is rigid, and turns about a reference node; nodes of the plate are coupled, and beams of *MPC are one body.
# Stresses and plastic strains at the start.
ABAQUS_STRESSED = ABAQUS.replace(
    "*STEP\n",
    """\
*INITIAL CONDITIONS, TYPE=STRESS
block-1.all, 1., 2., 3., 4., 5., 6.
*INITIAL CONDITIONS, TYPE=HARDENING
plate-1.shell, 0.01
*STEP
""",
)
ABAQUS_BODIES = (
    ABAQUS.replace("*END ASSEMBLY\n", "*NODE\n900, 0.5, 0.5, -1.\n901, 0., 0., 3.\n*NSET, NSET=pair, INSTANCE=plate-1\n1, 4\n"
                   "*SURFACE, TYPE=NODE, NAME=coupled\npair,\n*RIGID BODY, REF NODE=900, ELSET=block-1.all\n"
                   "*COUPLING, CONSTRAINT NAME=c, REF NODE=901, SURFACE=coupled\n*KINEMATIC\n*END ASSEMBLY\n")
    .replace("block-1.foot, ENCASTRE", "900, 1, 5\n901, ENCASTRE")
)  # fmt: skip

# A roller above the plate, an analytical surface, that comes down.
ABAQUS_ROLLER = (
    ABAQUS.replace("*ASSEMBLY, NAME=assembly\n", "*PART, NAME=roll\n*END PART\n*ASSEMBLY, NAME=assembly\n")
    .replace("*NSET, NSET=tip,", "*INSTANCE, NAME=roll-1, PART=roll\n0.5, 0., 2.\n0.5, 0., 2., 0.5, 0., 3., 90.\n*NODE\n1, 0., 0., 0.\n"
             "*NSET, NSET=ref\n1,\n*SURFACE, TYPE=REVOLUTION, NAME=skin\nSTART, 0.5, 2.\n LINE, 0.5, -1.\n"
             "*RIGID BODY, REF NODE=ref, ANALYTICAL SURFACE=skin\n*END INSTANCE\n*NSET, NSET=tip,", 1)
    .replace("block-1.foot, ENCASTRE\n", "block-1.foot, ENCASTRE\nroll-1.ref, 1, 2\nroll-1.ref, 4, 6\n")
    .replace("tip, 1, 1, 2.\n", "tip, 1, 1, 2.\nroll-1.ref, 3, 3, -4.\n")
)  # fmt: skip

# A frame: a rectangle, a tube, resultants, and a truss.
BEAMS = (
    _HEAD
    + BLOCK
    + """\
*NODE
      31             0.0             0.0             0.0
      32             0.0             0.0             2.0
      33             2.0             0.0             2.0
      34             2.0             0.0             0.0
      39             0.0             5.0             0.0
      40             0.0             5.0             2.0
      41             2.0             5.0             2.0
*ELEMENT_BEAM
       1      21      31      32      39
       2      21      32      33      40
       3      21      33      34      41
     500      22      31      33       0
       5      23      31      34       0
       6      24      32      34       0
*PART
posts
        21        21         3
*PART
tie
        22        22         3
*PART
sill
        23        23         3
*PART
brace
        24        24         3
*SECTION_BEAM
        21         1       1.0         2         0
      0.02      0.02      0.05      0.05
        22         3
    0.0001
        23         1       1.0         2         1
      0.04      0.04      0.03      0.03
        24         2
     0.001    1.0e-7    1.0e-7    2.0e-7    8.0e-4
*BOUNDARY_SPC_NODE
        31         0         1         1         1         1         1         1
*END
"""
)

ABAQUS_BEAMS = """\
*HEADING
a frame
*NODE
1, 0., 0., 0.
2, 0., 0., 1.
3, 1., 0., 1.
*ELEMENT, TYPE=B31, ELSET=posts
1, 1, 2
2, 2, 3
*ELEMENT, TYPE=T3D2, ELSET=tie
3, 1, 3
*BEAM SECTION, ELSET=posts, MATERIAL=steel, SECTION=RECT
0.02, 0.04
0., 1., 0.
*SOLID SECTION, ELSET=tie, MATERIAL=steel
1e-4
*MATERIAL, NAME=steel
*DENSITY
7850.
*ELASTIC
2e11, 0.3
*BOUNDARY
1, 1, 6
*STEP
*DYNAMIC, EXPLICIT
, 1e-3
*CLOAD
3, 1, 100.
*END STEP
"""

CUBE = """*NODE
1, 0., 0., 0.
2, 1., 0., 0.
3, 1., 1., 0.
4, 0., 1., 0.
5, 0., 0., 1.
6, 1., 0., 1.
7, 1., 1., 1.
8, 0., 1., 1.
9, 0.5, 0.5, 2.
*ELEMENT, TYPE=C3D8R, ELSET=cube
1, 1, 2, 3, 4, 5, 6, 7, 8
*NSET, NSET=all, GEN
1, 8, 1
*SOLID SECTION, ELSET=cube, MATERIAL=steel
"""
# A cube that is rigid, with a reference node above it.
ABAQUS_RIGID = CUBE + """*MATERIAL, NAME=steel
*DENSITY
7850.
*ELASTIC
2e11, 0.3
*RIGID BODY, REF NODE=9, ELSET=cube
*STEP
*DYNAMIC, EXPLICIT, DIRECT USER CONTROL
1e-6, 1e-4
*BOUNDARY
9, 1, 2
9, 4, 6
*BOUNDARY, TYPE=VELOCITY
9, 3, 3, -2.
*END STEP
"""
# Yield stresses 2 and 3 times as high at the rates 10 and 20.
ABAQUS_RATES = CUBE + """*MATERIAL, NAME=steel
*DENSITY
7850.
*ELASTIC
2e11, 0.3
*PLASTIC
2e8, 0.
3e8, 0.5
*PLASTIC, RATE=10.
4e8, 0.
6e8, 0.5
*PLASTIC, RATE=20.
6e8, 0.
9e8, 0.5
*STEP
*DYNAMIC, EXPLICIT
, 1e-4
*BOUNDARY, TYPE=VELOCITY
all, 3, 3, -2.
*END STEP
"""
