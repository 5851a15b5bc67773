"""Which options of keywords are read, or harmless: any other is refused."""

from ..fields import clip
from ..ledger import Ledger
from .lines import Block

OF_STEP = "AMPLITUDE OP"
OF_NUMERICS = "ELEMENT_BY_ELEMENT DIRECT_USER_CONTROL FIXED_TIME_INCREMENTATION IMPROVED_DT_METHOD"
KNOWN = {
    "NODE": "NSET SYSTEM INPUT",
    "ELEMENT": "TYPE ELSET INPUT",
    "NSET": "NSET GENERATE INSTANCE INTERNAL UNSORTED ELSET",
    "ELSET": "ELSET GENERATE INSTANCE INTERNAL UNSORTED",
    "SURFACE": "NAME TYPE INTERNAL",
    "SOLID SECTION": "ELSET MATERIAL CONTROLS ORIENTATION",
    "BEAM SECTION": "ELSET MATERIAL SECTION",
    "SHELL SECTION": "ELSET MATERIAL CONTROLS OFFSET SECTION_INTEGRATION ORIENTATION NODAL_THICKNESS",
    "NODAL THICKNESS": "",
    "MASS": "ELSET",
    "RIGID BODY": "REF_NODE ELSET TIE_NSET PIN_NSET POSITION ISOTHERMAL ANALYTICAL_SURFACE",
    "COUPLING": "CONSTRAINT_NAME REF_NODE SURFACE",
    "KINEMATIC": "",
    "MPC": "",
    "EQUATION": "",
    "DAMPING": "ALPHA BETA",
    "SPRING": "ELSET NONLINEAR",
    "DASHPOT": "ELSET NONLINEAR",
    "MATERIAL": "NAME",
    "DENSITY": "",
    "ELASTIC": "TYPE",
    "PLASTIC": "HARDENING RATE",
    "RATE DEPENDENT": "TYPE",
    "EOS": "TYPE",
    "HYPERELASTIC": "MOONEY-RIVLIN NEO_HOOKE POLYNOMIAL N TEST_DATA_INPUT",
    "AMPLITUDE": "NAME DEFINITION TIME",
    "BOUNDARY": f"TYPE {OF_STEP}",
    "INITIAL CONDITIONS": "TYPE",
    "CLOAD": f"FOLLOWER {OF_STEP}",
    "DLOAD": OF_STEP,
    "DSLOAD": OF_STEP,
    "TIE": "NAME ADJUST POSITION_TOLERANCE TYPE",
    "CONTACT PAIR": "INTERACTION MECHANICAL_CONSTRAINT CPSET WEIGHT TYPE",
    "CONTACT INCLUSIONS": "ALL_EXTERIOR",
    "CONTACT PROPERTY ASSIGNMENT": "",
    "DYNAMIC": f"EXPLICIT ADIABATIC SCALE_FACTOR {OF_NUMERICS}",
    "DYNAMIC TEMPERATURE-DISPLACEMENT": f"EXPLICIT SCALE_FACTOR {OF_NUMERICS}",
    "FIXED MASS SCALING": "DT TYPE",
    "VARIABLE MASS SCALING": "DT TYPE FREQUENCY",
    "SURFACE BEHAVIOR": "PRESSURE-OVERCLOSURE",
}
# Values that mean the default.
BELOW = {"BELOW MIN", "UNIFORM"}
DEFAULTS = {
    ("FIXED MASS SCALING", "TYPE"): BELOW,
    ("VARIABLE MASS SCALING", "TYPE"): BELOW,
    ("HYPERELASTIC", "N"): {"", "1"},
    ("RIGID BODY", "ISOTHERMAL"): {"", "NO"},
    ("SURFACE BEHAVIOR", "PRESSURE-OVERCLOSURE"): {"", "HARD"},
    ("AMPLITUDE", "TIME"): {"", "STEP TIME"},
}


def check_options(block: Block, ledger: Ledger) -> None:
    """Refuses what is not known of a keyword."""
    known = KNOWN.get(block.keyword)
    if known is None:
        return
    if "MASS SCALING" in block.keyword and "ELSET" in block.options:
        return  # refused as a whole
    words = {word.replace("_", " ") for word in known.split()}
    complete_names(block, words)
    numerics = {word.replace("_", " ") for word in OF_NUMERICS.split()}
    for name in block.options:
        if block.keyword.startswith("DYNAMIC") and name in numerics:
            ledger.ignored(f"DYNAMIC.{name}", block.place, "numerics: percuss chooses a stable step")
        values = DEFAULTS.get((block.keyword, name))
        if name not in words or (values and block.option(name) not in values):
            ledger.refuse(
                f"{block.keyword}.{clip(name)}",
                block.place,
                f"the option {clip(name)}={clip(block.options[name])}",
                "it is left out",
            )
    if block.option("OP") == "NEW":
        ledger.refuse(f"{block.keyword}.OP", block.place, "OP=NEW, which ends what acted before", "what acted before goes on")


def complete_names(block: Block, words: set[str]) -> None:
    """Options may be shortened as long as one alone begins so, as GEN for GENERATE."""
    for name in list(block.options):
        fits = [word for word in words if word.startswith(name)]
        if name not in words and len(name) >= 3 and len(fits) == 1:
            block.options[fits[0]] = block.options.pop(name)
