"""Keywords that percuss knows, and which options of them are read, or harmless: any other is refused."""

from ..fields import clip
from ..ledger import Ledger
from ..text_files import find_similar
from .lines import Block

OF_STEP = "AMPLITUDE OP"
SHORTEST = 4  # letters of a keyword that is shortened
OF_SET = "GENERATE INSTANCE INTERNAL UNSORTED ELSET"
KNOWN = {
    "NODE": "NSET SYSTEM INPUT",
    "NGEN": "NSET LINE SYSTEM",
    "NFILL": "NSET",
    "NCOPY": "CHANGE_NUMBER OLD_SET NEW_SET SHIFT",
    "NMAP": "NSET TYPE",
    "ELGEN": "ELSET",
    "ELCOPY": "ELEMENT_SHIFT OLD_SET SHIFT_NODES NEW_SET",
    "SYSTEM": "",
    "TRANSFORM": "NSET TYPE",
    "ELEMENT": "TYPE ELSET INPUT",
    "NSET": f"NSET {OF_SET}",
    "ELSET": OF_SET,
    "SURFACE": "NAME TYPE INTERNAL",
    "SOLID SECTION": "ELSET MATERIAL CONTROLS ORIENTATION COMPOSITE STACK_DIRECTION SYMMETRIC LAYUP",
    "COHESIVE SECTION": "ELSET MATERIAL RESPONSE THICKNESS CONTROLS ORIENTATION STACK_DIRECTION",
    "BEAM SECTION": "ELSET MATERIAL SECTION CONTROLS TEMPERATURE",
    "BEAM GENERAL SECTION": "ELSET SECTION DENSITY POISSON",
    "BEAM ADDED INERTIA": "",
    "SHELL SECTION": "ELSET MATERIAL CONTROLS OFFSET SECTION_INTEGRATION ORIENTATION NODAL_THICKNESS SHELL_THICKNESS "
                     "COMPOSITE SYMMETRIC LAYUP TEMPERATURE POISSON STACK_DIRECTION",
    "MEMBRANE SECTION": "ELSET MATERIAL CONTROLS ORIENTATION",
    "SECTION CONTROLS": "NAME HOURGLASS ELEMENT_DELETION MAX_DEGRADATION DISTORTION_CONTROL LENGTH_RATIO "
                        "KINEMATIC_SPLIT SECOND_ORDER_ACCURACY",
    "DISTRIBUTION": "NAME LOCATION TABLE INPUT",
    "NODAL THICKNESS": "",
    "ORIENTATION": "NAME SYSTEM DEFINITION LOCAL_DIRECTIONS",
    "MASS": "ELSET",
    "ROTARY INERTIA": "ELSET",
    "RIGID BODY": "REF_NODE ELSET TIE_NSET PIN_NSET POSITION ISOTHERMAL ANALYTICAL_SURFACE",
    "COUPLING": "CONSTRAINT_NAME REF_NODE SURFACE",
    "KINEMATIC": "",
    "MPC": "",
    "EQUATION": "",
    "EMBEDDED ELEMENT": "HOST_ELSET EXTERIOR_TOLERANCE",
    "DAMPING": "ALPHA BETA",
    "SPRING": "ELSET NONLINEAR",
    "DASHPOT": "ELSET NONLINEAR",
    "MATERIAL": "NAME",
    "USER MATERIAL": "CONSTANTS TYPE UNSYMM HYBRID_FORMULATION",
    "DEPVAR": "DELETE",
    "CHARACTERISTIC LENGTH": "DEFINITION COMPONENTS PROPERTIES",
    "USER DEFINED FIELD": "PROPERTIES",
    "PARAMETER TABLE TYPE": "NAME PARAMETERS",
    "PARAMETER TABLE": "TYPE LABEL",
    "TABLE COLLECTION": "NAME",
    "DENSITY": "",
    "ELASTIC": "TYPE MODULI",
    "PLASTIC": "HARDENING PROPERTIES RATE DATA_TYPE DATATYPE NUMBER_BACKSTRESSES",
    "CYCLIC HARDENING": "PARAMETERS",
    "POROUS METAL PLASTICITY": "RELATIVE_DENSITY",
    "VOID NUCLEATION": "",
    "POROUS FAILURE CRITERIA": "",
    "POTENTIAL": "",
    "RATE DEPENDENT": "TYPE",
    "EOS": "TYPE",
    "HYPERELASTIC": "MOONEY-RIVLIN NEO_HOOKE YEOH ARRUDA-BOYCE OGDEN POLYNOMIAL REDUCED_POLYNOMIAL N TEST_DATA_INPUT "
                    "MODULI",
    "HYPERFOAM": "N POISSON TEST_DATA_INPUT MODULI",
    "VISCOELASTIC": "TIME",
    "DAMAGE INITIATION": "CRITERION ALPHA KS",
    "DAMAGE EVOLUTION": "TYPE SOFTENING DEGRADATION MIXED_MODE_BEHAVIOR POWER",
    "COHESIVE BEHAVIOR": "ELIGIBILITY TYPE REPEATED_CONTACTS",
    "SHEAR FAILURE": "TYPE ELEMENT_DELETION",
    "TENSILE FAILURE": "ELEMENT_DELETION",
    "AMPLITUDE": "NAME DEFINITION TIME VALUE SMOOTH FIXED_INTERVAL BEGIN INPUT",
    "STEP": "NAME NLGEOM",
    "BOUNDARY": f"TYPE {OF_STEP}",
    "INITIAL CONDITIONS": "TYPE VARIABLE",
    "CLOAD": f"FOLLOWER {OF_STEP}",
    "DLOAD": f"FOLLOWER CONSTANT_RESULTANT {OF_STEP}",
    "DSLOAD": f"FOLLOWER CONSTANT_RESULTANT {OF_STEP}",
    "TIE": "NAME ADJUST POSITION_TOLERANCE TYPE NO_ROTATION",
    "SURFACE INTERACTION": "NAME",
    "FRICTION": "TAUMAX EXPONENTIAL_DECAY ROUGH",
    "CONTACT": "OP",
    "CONTACT PAIR": "INTERACTION CPSET TYPE OP",
    "CONTACT INCLUSIONS": "ALL_EXTERIOR",
    "CONTACT EXCLUSIONS": "",
    "CONTACT PROPERTY ASSIGNMENT": "",
    "SURFACE PROPERTY ASSIGNMENT": "PROPERTY",
    "DYNAMIC": "EXPLICIT ADIABATIC SCALE_FACTOR",
    "DYNAMIC TEMPERATURE-DISPLACEMENT": "EXPLICIT SCALE_FACTOR",
    "FIXED MASS SCALING": "ELSET FACTOR DT TYPE",
    "VARIABLE MASS SCALING": "ELSET DT TYPE FREQUENCY NUMBER_INTERVAL",
    "SURFACE BEHAVIOR": "PRESSURE-OVERCLOSURE",
    "CONTACT INITIALIZATION DATA": "NAME SEARCH_ABOVE SEARCH_BELOW",
}
OWN_STEP = "numerics: percuss chooses a stable step"
OF_STANDARD = "numerics of implicit steps, which an explicit one does not have"
ENFORCED = ("the stiffness or the constraint that enforces contact: percuss corrects velocities, "
            "and has springs of its own stiffness between sheets, or everywhere if contact.enforcement is penalty")
SEARCHED = "how contact is searched for and followed: percuss searches in its own way"
SMOOTHED = "how rates and their tables are smoothed: percuss takes the rate of the step, and the tables as they are"
ADAPTIVE = "of adaptive meshes, which percuss does not have"
# Options that are no physics, with the reason for which they are ignored, whatever they say.
NUMERICS: dict[str, dict[str, str]] = {
    "STEP": dict.fromkeys(("INC", "CONVERT SDI", "EXTRAPOLATION", "SOLVER", "UNSYMM"), OF_STANDARD),
    "DYNAMIC": {
        **dict.fromkeys(("ELEMENT BY ELEMENT", "DIRECT USER CONTROL",
                         "FIXED TIME INCREMENTATION", "IMPROVED DT METHOD"), OWN_STEP),
        **dict.fromkeys(("ALPHA", "APPLICATION", "BETA", "GAMMA", "DIRECT", "HAFTOL", "HALFINC SCALE FACTOR", "IMPACT",
                         "INITIAL", "NOHAF", "SINGULAR MASS", "TIME INTEGRATOR"), OF_STANDARD),
    },
    "DYNAMIC TEMPERATURE-DISPLACEMENT": dict.fromkeys(("ELEMENT BY ELEMENT", "DIRECT USER CONTROL",
                                                       "FIXED TIME INCREMENTATION", "IMPROVED DT METHOD"), OWN_STEP),
    "MATERIAL": dict.fromkeys(("RTOL", "SRATE FACTOR", "STRAIN RATE REGULARIZATION"), SMOOTHED),
    "SECTION CONTROLS": {"DRILL STIFFNESS": "stiffness against drilling rotations: percuss has its own"},
    "FRICTION": dict.fromkeys(("SLIP TOLERANCE", "ELASTIC SLIP", "LAGRANGE", "SHEAR TRACTION SLOPE"),
                              "how sticking is enforced: what sticks does not slip in percuss"),
    "SURFACE INTERACTION": {"UNSYMM": OF_STANDARD},
    "SURFACE BEHAVIOR": dict.fromkeys(("PENALTY", "AUGMENTED LAGRANGE", "DIRECT"), ENFORCED),
    "CONTACT PAIR": {
        "MECHANICAL CONSTRAINT": ENFORCED, "WEIGHT": "contact works both ways",
        **dict.fromkeys(("EXTENSION ZONE", "GEOMETRIC CORRECTION", "HCRIT", "SMALL SLIDING", "SMOOTH",
                         "SUPPLEMENTARY CONSTRAINTS", "TRACKING"), SEARCHED),
    },
    "BOUNDARY": {"REGION TYPE": ADAPTIVE}, "CLOAD": {"REGION TYPE": ADAPTIVE}, "DLOAD": {"REGION TYPE": ADAPTIVE},
    "DSLOAD": {"REGION TYPE": ADAPTIVE},
    "EMBEDDED ELEMENT": {"ROUNDOFF TOLERANCE": "weights of nodes below it: percuss keeps them"},
}  # fmt: skip
# Options of output: they say what is written, and where, but change no physics.
OF_OUTPUT = {
    "OUTPUT": "FIELD HISTORY DIAGNOSTICS FREQUENCY MODE_LIST NAME NUMBER_INTERVAL OP TIME_INTERVAL TIME_MARKS "
              "TIME_POINTS VARIABLE FILTER SENSOR",
    "NODE OUTPUT": "NSET VARIABLE EXTERIOR TRACER_SET SENSOR ELSET",
    "ELEMENT OUTPUT": "ELSET VARIABLE DIRECTIONS POSITION EXTERIOR ALLSECTIONPTS REBAR TRACER_SET SENSOR NSET",
    "CONTACT OUTPUT": "NSET VARIABLE SURFACE SECOND_SURFACE MASTER SLAVE CPSET GENERAL_CONTACT",
    "ENERGY OUTPUT": "ELSET VARIABLE PER_ELEMENT_SET PER_SECTION",
}
# Values that mean the default, or change nothing that percuss has.
DEFAULTS = {
    ("HYPERELASTIC", "N"): {"", "1", "2", "3", "4", "5", "6"},
    ("HYPERELASTIC", "MODULI"): {"", "INSTANTANEOUS", "LONG TERM"},
    ("HYPERFOAM", "N"): {"", "1", "2", "3", "4", "5", "6"},
    ("HYPERFOAM", "MODULI"): {"", "INSTANTANEOUS", "LONG TERM"},
    ("ELASTIC", "MODULI"): {"", "INSTANTANEOUS", "LONG TERM"},
    ("SHELL SECTION", "POISSON"): {"", "MATERIAL"},
    ("COHESIVE SECTION", "STACK_DIRECTION"): {"", "3"},
    ("RIGID BODY", "ISOTHERMAL"): {"", "NO"},
    ("RIGID BODY", "POSITION"): {"", "INPUT", "CENTER OF MASS"},
    ("SURFACE BEHAVIOR", "PRESSURE-OVERCLOSURE"): {"", "HARD"},
    ("CONTACT PAIR", "OP"): {"", "ADD", "DELETE"},
    ("CONTACT PAIR", "TYPE"): {"", "SURFACE TO SURFACE", "NODE TO SURFACE"},
    ("CONTACT", "OP"): {"", "NEW", "MOD"},
    ("TIE", "TYPE"): {"", "SURFACE TO SURFACE", "NODE TO SURFACE"},
}
OF_MATERIALS = (  # what may follow *MATERIAL
    "ACOUSTIC MEDIUM|ANNEAL TEMPERATURE|BRITTLE CRACKING|BRITTLE FAILURE|BRITTLE SHEAR|CAP HARDENING|CAP PLASTICITY|"
    "CHARACTERISTIC LENGTH|CLAY HARDENING|CLAY PLASTICITY|COMPOSITE MODIFIER|CONCRETE COMPRESSION DAMAGE|"
    "CONCRETE COMPRESSION HARDENING|CONCRETE DAMAGED PLASTICITY|CONCRETE TENSION DAMAGE|CONCRETE TENSION STIFFENING|"
    "CONDUCTIVITY|CREEP|CRUSHABLE FOAM|CRUSHABLE FOAM HARDENING|CYCLIC HARDENING|DAMAGE EVOLUTION|DAMAGE INITIATION|"
    "DAMAGE STABILIZATION|DAMPING|DENSITY|DEPVAR|DETONATION POINT|DRUCKER PRAGER|DRUCKER PRAGER HARDENING|ELASTIC|EOS|"
    "EOS COMPACTION|EOS SHEAR|EXPANSION|EXTREME VALUE|FABRIC|FAIL STRAIN|FAIL STRESS|GAS SPECIFIC HEAT|HYPERELASTIC|"
    "HYPERFOAM|HYSTERESIS|INELASTIC HEAT FRACTION|LATENT HEAT|LOADING DATA|LOW DENSITY FOAM|MOHR COULOMB|MOHR COULOMB "
    "HARDENING|MULLINS EFFECT|NO COMPRESSION|NO TENSION|PLANAR TEST DATA|PLASTIC|POROUS FAILURE CRITERIA|POROUS "
    "METAL PLASTICITY|POTENTIAL|RATE DEPENDENT|SHEAR FAILURE|SHEAR TEST DATA|SIMPLE SHEAR TEST DATA|SPECIFIC HEAT|"
    "SUPERELASTIC|TENSILE FAILURE|TENSION CUTOFF|TRS|UNIAXIAL|UNIAXIAL TEST DATA|BIAXIAL TEST DATA|VOLUMETRIC TEST "
    "DATA|UNLOADING DATA|USER DEFINED FIELD|USER MATERIAL|USER OUTPUT VARIABLES|VISCOELASTIC|VISCOUS|VOID NUCLEATION"
).split("|")
# What is lost with some of those that are refused: of keywords, and of all that begin so with a blank behind.
LOST = {
    "FASTENER": "point connections, without which the surfaces part",
    "DISTRIBUTING": "a coupling that spreads what acts on its reference node",
    "CONNECTOR": "connectors between nodes",
    "SHELL TO SOLID COUPLING": "the edge of a shell on a solid, which then parts from it",
    "COHESIVE": "cohesive bonds",
    "FLUID": "a fluid in a cavity and its pressure",
    "REBAR": "bars of reinforcement",
    "PRE-TENSION SECTION": "the preload of a bolt",
    "NONSTRUCTURAL MASS": "mass without stiffness",
}


def describe_lost(keyword: str) -> str:
    """What a keyword that is refused would have done, or its name."""
    return next((text for name, text in LOST.items() if keyword == name or keyword.startswith(name + " ")),
                f"*{keyword}")


OTHERS = (  # that are refused; so that blanks in them and misspelt words are found
    "CAPACITY|ADAPTIVE MESH|ADAPTIVE MESH CONTROLS|ANNEAL|BUCKLE|CFLUX|CFILM|CLEARANCE|CO-SIMULATION|CO-SIMULATION "
    "CONTROLS|CO-SIMULATION REGION|CONNECTOR BEHAVIOR|CONNECTOR DAMAGE EVOLUTION|CONNECTOR DAMAGE INITIATION|"
    "CONNECTOR DAMPING|CONNECTOR ELASTICITY|CONNECTOR FAILURE|CONNECTOR FRICTION|CONNECTOR HARDENING|CONNECTOR LOAD|"
    "CONNECTOR LOCK|CONNECTOR MOTION|CONNECTOR PLASTICITY|CONNECTOR POTENTIAL|CONNECTOR SECTION|CONNECTOR STOP|CONTACT "
    "CLEARANCE|CONTACT CLEARANCE ASSIGNMENT|CONTACT DAMPING|CONTACT STABILIZATION|CONTACT INTERFERENCE|DISPLAY BODY|"
    "DISTRIBUTING|DISTRIBUTING COUPLING|DRAG CHAIN|EULERIAN BOUNDARY|EULERIAN SECTION|FASTENER|FASTENER PROPERTY|FIELD|"
    "FLUID BEHAVIOR|FLUID CAVITY|FLUID DENSITY|FLUID EXCHANGE|FLUID INFLATOR|FOUNDATION|GAP CONDUCTANCE|"
    "GAP HEAT GENERATION|GASKET SECTION|GEOSTATIC|HEAT TRANSFER|HOURGLASS STIFFNESS|IMPERFECTION|IMPORT|INCIDENT WAVE|"
    "INCIDENT WAVE INTERACTION|INCIDENT WAVE INTERACTION PROPERTY|INERTIA RELIEF|INTERACTION PROPERTY|MASS ADJUST|"
    "MASSLESS SHELL|MODEL CHANGE|MOLECULAR WEIGHT|NMAP|NONSTRUCTURAL MASS|PARTICLE GENERATOR|PERIODIC MEDIA|"
    "POST OUTPUT|PRE-TENSION SECTION|PREDEFINED FIELD|PRESSURE PENETRATION|PROPERTY TABLE|PROPERTY TABLE TYPE|REBAR|"
    "REBAR LAYER|RELEASE|RESPONSE SPECTRUM|SHELL GENERAL SECTION|SHELL TO SOLID COUPLING|STEADY STATE DYNAMICS|"
    "SUBMODEL|SURFACE FLAW|SURFACE SECTION|SURFACE SMOOTHING|TEMPERATURE|UEL PROPERTY|USER ELEMENT|VISCO|WAVE"
).split("|")


def squeeze(word: str) -> str:
    return word.replace(" ", "").replace("_", "")


def complete_keyword(block: Block, known: dict[str, str]) -> None:
    """Blanks in keywords do not count: *ENDSTEP. A keyword may be shortened as long as one alone begins so.
    known: by the word without blanks."""
    word = squeeze(block.keyword)
    fits = [full for full in known if full.startswith(word)] if word not in known and len(word) >= SHORTEST else []
    block.keyword = known[fits[0]] if len(fits) == 1 else known.get(word, block.keyword)


def check_options(block: Block, ledger: Ledger) -> None:
    """Refuses what is not known of a keyword."""
    known = KNOWN.get(block.keyword, OF_OUTPUT.get(block.keyword))
    if known is None:
        return
    words, numerics = {word.replace("_", " ") for word in known.split()}, NUMERICS.get(block.keyword, {})
    complete_names(block, words | numerics.keys())
    for name in block.options:
        values = DEFAULTS.get((block.keyword, name))
        if name in numerics:
            ledger.ignored(f"{block.keyword}.{name}", block.place, numerics[name])
        elif name not in words or (values and " ".join(block.option(name).split()) not in values):
            ledger.refuse(
                f"{block.keyword}.{clip(name)}",
                block.place,
                "the option "
                f"{clip(name)}={clip(block.options[name])}{suggest_option(name, words) if name not in words else ''}",
                "it is left out",
            )


def suggest_option(name: str, words: set[str]) -> str:
    """The reason in a message that an option is not known: the one that it is written almost like."""
    found = find_similar(name, sorted(words))
    return f" (did you mean {found}?)" if found else ""


def complete_names(block: Block, words: set[str]) -> None:
    """Blanks do not count; and options may be shortened as long as one alone begins so, as GEN for GENERATE."""
    squeezed = {squeeze(word): word for word in words}
    for name in list(block.options):
        fits = [word for word in words if squeeze(word).startswith(squeeze(name))]
        full = squeezed.get(squeeze(name)) or (fits[0] if len(name) >= 3 and len(fits) == 1 else "")
        if full and full != name:
            block.options[full] = block.options.pop(name)
