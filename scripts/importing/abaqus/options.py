"""Which options of keywords are read, or harmless: any other is refused."""

from ..fields import clip
from ..ledger import Ledger
from .lines import Block

OF_STEP = "AMPLITUDE OP"
KNOWN = {
    "NODE": "NSET SYSTEM INPUT",
    "ELEMENT": "TYPE ELSET INPUT",
    "NSET": "NSET GENERATE INSTANCE INTERNAL UNSORTED ELSET",
    "ELSET": "ELSET GENERATE INSTANCE INTERNAL UNSORTED",
    "SURFACE": "NAME TYPE INTERNAL",
    "SOLID SECTION": "ELSET MATERIAL CONTROLS ORIENTATION",
    "BEAM SECTION": "ELSET MATERIAL SECTION",
    "SHELL SECTION": "ELSET MATERIAL CONTROLS OFFSET SECTION_INTEGRATION ORIENTATION",
    "MASS": "ELSET",
    "RIGID BODY": "REF_NODE ELSET TIE_NSET PIN_NSET",
    "COUPLING": "CONSTRAINT_NAME REF_NODE SURFACE",
    "KINEMATIC": "",
    "MPC": "",
    "SPRING": "ELSET NONLINEAR",
    "DASHPOT": "ELSET NONLINEAR",
    "MATERIAL": "NAME",
    "DENSITY": "",
    "ELASTIC": "TYPE",
    "PLASTIC": "HARDENING RATE",
    "RATE DEPENDENT": "TYPE",
    "EOS": "TYPE",
    "HYPERELASTIC": "MOONEY-RIVLIN NEO_HOOKE TEST_DATA_INPUT",
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
    "DYNAMIC": "EXPLICIT ELEMENT_BY_ELEMENT SCALE_FACTOR",
    "SURFACE BEHAVIOR": "PRESSURE-OVERCLOSURE",
}
# Values that mean the default.
DEFAULTS = {("SURFACE BEHAVIOR", "PRESSURE-OVERCLOSURE"): {"", "HARD"}, ("AMPLITUDE", "TIME"): {"", "STEP TIME"}}


def check_options(block: Block, ledger: Ledger) -> None:
    """Refuses what is not known of a keyword."""
    known = KNOWN.get(block.keyword)
    if known is None:
        return
    words = {word.replace("_", " ") for word in known.split()}
    for name in block.options:
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
