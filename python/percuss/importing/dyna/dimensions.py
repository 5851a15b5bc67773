"""Dimensions of the fields of cards: what FCTMAS, FCTLEN and FCTTIM of *INCLUDE_TRANSFORM do to them."""

import math
from functools import cache

from .materials.names import name_law

Factors = tuple[float, float, float]  # of mass, length, time
SAME: Factors = (1.0, 1.0, 1.0)
# Powers of mass, length and time.
POWERS = {
    "none": (0, 0, 0), "mass": (1, 0, 0), "length": (0, 1, 0), "time": (0, 0, 1), "rate": (0, 0, -1),
    "speed": (0, 1, -1), "acceleration": (0, 1, -2), "density": (1, -3, 0), "stress": (1, -1, -2),
    "stress2": (2, -2, -4), "force": (1, 1, -2), "moment": (1, 2, -2), "stiffness": (1, 0, -2), "damping": (1, 0, -1),
    "inertia": (1, 2, 0), "area": (0, 2, 0), "area2": (0, 4, 0), "heat": (0, 2, -2), "viscosity": (1, -1, -1),
    "per_area": (1, -2, 0), "foundation": (1, -2, -2), "per_length": (1, -1, 0), "rate_of_angle": (0, 0, -1),
    "angular_acceleration": (0, 0, -2),
}  # fmt: skip
METAL = "density: RO; stress: E SIGY ETAN"
BODY = ("length: XC YC ZC XL YL ZL XLIP YLIP ZLIP; mass: TM; inertia: IXX IXY IXZ IYY IYZ IZZ; speed: VTX VTY VTZ; "
        "rate: VRX VRY VRZ")
PLY = "density: RO; stress: EA EB EC GAB GBC GCA"
SPEEDS = "speed: VX VY VZ VXE VYE VZE; rate: VXR VYR VZR VXRE VYRE VZRE"
WALL = ("length: OFFSET XT YT ZT XH YH ZH XHEV YHEV ZHEV LENL LENM RADCYL LENCYL RADSPH; time: BIRTH DEATH; "
        "mass: MASS; speed: V0 WVEL")
# Fields with a dimension. A card counts for those whose names go on with '_', but laws; a field that it does not name
# has no dimension. Curves and rows of tables get that of the field that refers to them.
FIELDS: dict[str, str] = {
    **dict.fromkeys(("TITLE", "NODE", "ELEMENT_SOLID", "ELEMENT_TSHELL", "ELEMENT_PLOTEL", "INITIAL_TEMPERATURE",
                     "SECTION_SOLID", "SECTION_TSHELL", "HOURGLASS", "SET", "CONTROL", "DATABASE", "DEFINE_CURVE",
                     "DEFINE_TABLE", "DEFINE_TABLE_2D", "DEFINE_VECTOR", "DEFINE_COORDINATE_NODES",
                     "DEFINE_COORDINATE_VECTOR", "CONSTRAINED_EXTRA_NODES", "CONSTRAINED_JOINT",
                     "CONSTRAINED_RIGID_BODIES", "DEFORMABLE_TO_RIGID", "LOAD_BODY", "LOAD_NODE", "LOAD_RIGID_BODY",
                     "DAMPING_PART_MASS", "INITIAL_AXIAL_FORCE_BEAM", "INITIAL_STRESS_SECTION", "ELEMENT_BEAM",
                     "SECTION_DISCRETE", "MAT_SPRING_NONLINEAR_ELASTIC"), ""),
    "NODE_MERGE_TOLERANCE": "length: TOLR",
    "PART_CONTACT": "length: OPTT; stress: VC",
    "TERMINATION_NODE": "length: MAXC MINC", "TERMINATION_BODY": "length: MAXC MINC",
    "ELEMENT_SHELL": "length: T1 T2 T3 T4 OFFSET",
    "ELEMENT_MASS": "mass: MASS ADDMASS FINMASS",
    "ELEMENT_DISCRETE": "length: OFFSET",
    "ELEMENT_SEATBELT_ACCELEROMETER": "mass: MASS",
    "PART_COMPOSITE": "length: THICK1 THICK2 OPTT; per_area: MAREA; stress: VC",
    "PART": BODY, "CONSTRAINED_NODAL_RIGID_BODY": BODY,
    "SECTION_SHELL": "length: T1 T2 T3 T4; per_area: MAREA",
    "INTEGRATION_BEAM": "length: D1 D2 D3 D4 D5 D6",
    "SECTION_BEAM": "length: TS1 TS2 TT1 TT2; area: A SA SAT; area2: ISS ITT IST J; per_length: NSM; time: RAMPT; "
                    "stress: STRESS",
    "DEFINE_CURVE_SMOOTH": "length: DIST; time: TSTART TEND TRISE; speed: VMAX",
    "CONTROL_TERMINATION": "time: ENDTIM", "CONTROL_TIMESTEP": "time: DTINIT TSLIMT DT2MS DT2MSF",
    **dict.fromkeys(("DATABASE_BINARY_D3PLOT", "DATABASE_GLSTAT", "DATABASE_MATSUM", "DATABASE_RCFORC",
                     "DATABASE_RWFORC", "DATABASE_NODOUT", "DATABASE_ELOUT", "DATABASE_SPCFORC", "DATABASE_BNDOUT",
                     "DATABASE_SECFORC", "DATABASE_DEFORC", "DATABASE_JNTFORC", "DATABASE_RBDOUT", "DATABASE_SWFORC",
                     "DATABASE_SLEOUT"), "time: DT"),
    "DATABASE_CROSS_SECTION_PLANE": "length: XCT YCT ZCT XCH YCH ZCH RADIUS XHEV YHEV ZHEV LENL LENM",
    "DEFINE_BOX": "length: XMN XMX YMN YMX ZMN ZMX CX CY CZ",
    "DEFINE_COORDINATE_SYSTEM": "length: XO YO ZO XL YL ZL XP YP ZP",
    "CONSTRAINED_JOINT_STIFFNESS_GENERALIZED": "moment: ESPH FMPH EST FMT ESPS FMPS",
    "CONSTRAINED_JOINT_SCREW": "length: PARM R1",
    "BOUNDARY_SPC": "time: BIRTH DEATH", "BOUNDARY_SPC_SYMMETRY_PLANE": "length: X Y Z TOL",
    "BOUNDARY_PRESCRIBED_MOTION": "time: BIRTH DEATH; length: OFFSET1 OFFSET2",
    "CONSTRAINED_SPOTWELD": "force: SN SS; time: TF", "CONSTRAINED_RIVET": "time: TF",
    "CONSTRAINED_NODE_SET": "time: TF",
    "CONSTRAINED_GENERALIZED_WELD_SPOT": "force: SN SS; time: TFAIL WINDOW", "CONSTRAINED_GLOBAL": "length: X Y Z TOL",
    "INITIAL_VELOCITY": SPEEDS, "INITIAL_VELOCITY_NODE": SPEEDS, "INITIAL_VELOCITY_RIGID_BODY": SPEEDS,
    "INITIAL_VELOCITY_GENERATION": "rate: OMEGA; speed: VX VY VZ; length: XC YC ZC",
    "INITIAL_STRESS_SHELL": "stress: SIGXX SIGYY SIGZZ SIGXY SIGYZ SIGZX",
    "INITIAL_STRESS_SOLID": "stress: SIGXX SIGYY SIGZZ SIGXY SIGYZ SIGZX",
    "INITIAL_DETONATION": "length: X Y Z; time: LT",
    "LOAD_GRAVITY_PART": "acceleration: ACCEL", "LOAD_SEGMENT": "time: AT", "LOAD_SHELL": "time: AT",
    "DAMPING_GLOBAL": "rate: VALDMP", "DAMPING_PART_STIFFNESS": "time: COEF",
    "RIGIDWALL_PLANAR": WALL, "RIGIDWALL_GEOMETRIC": WALL,
    "CONTACT": "time: BT DT; length: SST MST; stress: VC NFLS SFLS; stiffness: ERATEN ERATES; foundation: CN",
    "MAT_ELASTIC": METAL, "MAT_RIGID": METAL, "MAT_PLASTIC_KINEMATIC": METAL + "; rate: SRC",
    "MAT_ELASTIC_FLUID": METAL + " K CP", "MAT_NULL": "density: RO; stress: PC; viscosity: MU",
    "MAT_VISCOELASTIC": "density: RO; stress: BULK G0 GI; rate: BETA",
    "MAT_BLATZ-KO_RUBBER": "density: RO; stress: G", "MAT_MOONEY-RIVLIN_RUBBER": "density: RO; stress: A B",
    "MAT_ARRUDA_BOYCE": "density: RO; stress: K G",
    "MAT_HYPERELASTIC_RUBBER": "density: RO; stress: G SIGF C10 C01 C11 C20 C02 C30 GI; rate: BETAI",
    "MAT_OGDEN_RUBBER": "density: RO; stress: G SIGF MU1 MU2 MU3 MU4 MU5 MU6 MU7 MU8 GI; rate: BETAI",
    "MAT_COHESIVE_MIXED_MODE": "foundation: EN ET; stiffness: GIC GIIC; stress: T S; length: UND UTD",
    "MAT_SIMPLIFIED_RUBBER/FOAM": "density: RO; stress: KM G SIGF; length: SGL SW ST",
    "MAT_GENERAL_VISCOELASTIC": "density: RO; stress: BULK GI KI; rate: BETAI BETAKI",
    **dict.fromkeys(("MAT_SOIL_AND_FOAM", "MAT_SOIL_AND_FOAM_FAILURE"),
                    "density: RO; stress: G BULK A1 PC; stress2: A0"),
    **dict.fromkeys(("MAT_HONEYCOMB", "MAT_MODIFIED_HONEYCOMB"), METAL + " EAAU EBBU ECCU GABU GBCU GCAU"),
    "MAT_LOW_DENSITY_FOAM": METAL + " TC ED", "MAT_FU_CHANG_FOAM": METAL + " TC; rate: MINR MAXR",
    "MAT_CRUSHABLE_FOAM": METAL + " TSC",
    **dict.fromkeys(("MAT_PIECEWISE_LINEAR_PLASTICITY", "MAT_MODIFIED_PIECEWISE_LINEAR_PLASTICITY",
                     "MAT_PLASTICITY_WITH_DAMAGE"), METAL + "; rate: C; time: TDEL"),
    "MAT_POWER_LAW_PLASTICITY": METAL + " K; rate: SRC", "MAT_GURSON": METAL + "; length: L1 L2 L3 L4",
    "MAT_DAMAGE_3": "density: RO; stress: E SIGY HARDI HARDK1 HARDK2 HARDK3 HARDK4 S; rate: SRC",
    **dict.fromkeys(("MAT_ISOTROPIC_ELASTIC_PLASTIC", "MAT_ISOTROPIC_ELASTIC_FAILURE"),
                    METAL + " G BULK PRF; time: TREM"),
    "MAT_ELASTIC_PLASTIC_HYDRO": "density: RO; stress: G SIGY EH PC",
    "MAT_JOHNSON_COOK": "density: RO; stress: G E A B PC; time: DTF; rate: EPSO; heat: CP",
    "MAT_SIMPLIFIED_JOHNSON_COOK": "density: RO; stress: E A B SIGMAX SIGSAT; rate: EPSO",
    "MAT_SPOTWELD": METAL + " EH; time: DT TFAIL; force: NRR NRS NRT; moment: MRR MSS MTT",
    "MAT_HIGH_EXPLOSIVE_BURN": "density: RO; speed: D; stress: PCJ K G SIGY",
    "MAT_FABRIC": "density: RO; stress: EA EB GAB EL; time: RGBRTH", "MAT_ORTHOTROPIC_ELASTIC": PLY + " G SIGF",
    "MAT_COMPOSITE_DAMAGE": PLY + " SC XT YT YC SN SYZ SZX",
    "MAT_ENHANCED_COMPOSITE_DAMAGE": PLY + " XC XT YC YT SC; time: TFAIL",
    "MAT_3-PARAMETER_BARLAT": "density: RO; stress: E P1; rate: C", "MAT_HILL_3R": "density: RO; stress: E P1",
    "MAT_TRANSVERSELY_ANISOTROPIC_ELASTIC_PLASTIC": METAL,
    "MAT_SPRING_ELASTIC": "stiffness: K", "MAT_DAMPER_VISCOUS": "damping: DC",
    "MAT_ADD_EROSION": "stress: MXPRES MNPRES SIGP1 SIGVM SIGTH; time: FAILTM",
    "EOS_LINEAR_POLYNOMIAL": "stress: C0 C1 C2 C3 E0", "EOS_GRUNEISEN": "speed: C; stress: E0",
    "EOS_IDEAL_GAS": "heat: CV CP", "EOS_JWL": "stress: A B E0",
    "EOS_TABULATED": "stress: E0 C1 C2 C3 C4 C5 C6 C7 C8 C9 C10",
}  # fmt: skip
NUMBERED_STATES = {1: "LINEAR_POLYNOMIAL", 2: "JWL", 4: "GRUNEISEN", 9: "TABULATED", 12: "IDEAL_GAS"}
EXACT = ("MAT_", "EOS_")
DIMENSIONS = {
    card: {field: kind.strip() for part in text.split(";") if part.strip() for kind, _, fields in [part.partition(":")]
           for field in fields.split()}
    for card, text in FIELDS.items()
}  # fmt: skip


@cache
def find_card(keyword: str) -> str | None:
    """The card of the table that a keyword is a form of; None: of none."""
    if keyword.startswith("MAT_"):
        keyword = f"MAT_{name_law(keyword)}".removesuffix("_LOG_INTERPOLATION")
    number = keyword.removeprefix("EOS_")
    if keyword.startswith("EOS_") and number.isdigit() and int(number[:4]) in NUMBERED_STATES:
        keyword = f"EOS_{NUMBERED_STATES[int(number[:4])]}"
    if keyword in DIMENSIONS or keyword.startswith(EXACT):
        return keyword if keyword in DIMENSIONS else None
    words = keyword.split("_")
    return next((name for count in range(len(words) - 1, 0, -1) if (name := "_".join(words[:count])) in DIMENSIONS),
                None)


def scale(kind: str, factors: Factors) -> float:
    """Factor on a number of a dimension."""
    return math.prod(factor**power for factor, power in zip(factors, POWERS[kind]))


def find_factor(keyword: str, field: str, factors: Factors) -> float:
    """Factor on a field of a card."""
    card = find_card(keyword)
    return scale(DIMENSIONS[card].get(field, "none"), factors) if card else 1.0
