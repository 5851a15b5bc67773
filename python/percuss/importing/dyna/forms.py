"""The option words that each keyword may have. Any other word refuses the card: with it, its lines mean something else.

A name of the table is the beginning of a keyword, as DEFINITIONS and ACTIONS of read.py have it; its options follow in
any order, with '_' between. A name that ends with '_' needs at least one of them. "A B | C D": A or B must follow,
once, then C and D may. _TITLE and _ID are taken off before.
ANY: the handler of the name knows all that may follow, and refuses the rest by name.
"""

import re
from collections.abc import Iterable
from functools import cache

ANY = "*"

SET_FORMS = "LIST GENERATE INCREMENT GENERAL ADD COLUMN COLLECT"
OPTIONS: dict[str, str] = {
    "TITLE": "",
    "NODE": "",
    "NODE_TRANSFORM": "",
    "NODE_MERGE_SET": "",
    "NODE_MERGE_TOLERANCE": "",
    "ELEMENT_SOLID": "ORTHO",
    "ELEMENT_TSHELL": "",
    "ELEMENT_SHELL": "THICKNESS BETA MCID OFFSET",
    "ELEMENT_MASS": "NODE_SET PART PART_SET",
    "ELEMENT_DISCRETE": "",
    "ELEMENT_BEAM": "ORIENTATION PID",
    "INTEGRATION_BEAM": "",
    "ELEMENT_SEATBELT_ACCELEROMETER": "",
    "ELEMENT_": ANY,
    "PART_COMPOSITE": "LONG CONTACT",
    "PART": "INERTIA REPOSITION CONTACT PRINT ATTACHMENT_NODES",
    "SECTION_": "SOLID SHELL BEAM DISCRETE TSHELL SEATBELT SPH POINT_SOURCE POINT_SOURCE_MIXTURE ALE1D ALE2D FPD | "
                "EFG MISC THERMAL XFEM AISC SPG PERI LAMINATE",
    "HOURGLASS": "",
    "MAT_": ANY,
    "EOS_": ANY,
    **{f"SET_{kind}": SET_FORMS
       for kind in ("NODE", "PART", "SEGMENT", "SHELL", "SOLID", "BEAM", "DISCRETE", "TSHELL", "BOX")},
    "DEFINE_CURVE": "",
    "DEFINE_CURVE_SMOOTH": "",
    "DEFINE_CURVE_": ANY,
    "DEFINE_FUNCTION": ANY,
    "DEFINE_TABLE": "2D",
    "DEFINE_BOX": "LOCAL",
    "DEFINE_COORDINATE_": ANY,
    "DEFINE_VECTOR": "",
    "CONTROL_TERMINATION": "",
    "CONTROL_HOURGLASS": "936",
    "CONTROL_CONTACT": "",
    "CONTROL_SHELL": "",
    "CONTROL_SOLID": "",
    "CONTROL_RIGID": "",
    "CONTROL_SOLUTION": "",
    "CONTROL_TIMESTEP": "",
    "CONTROL_BULK_VISCOSITY": "",
    "CONTROL_CHECK_SHELL": "",
    "CONTROL_DYNAMIC_RELAXATION": "",
    "CONTROL_DAMPING": "",
    "CONTROL_": ANY,
    "BOUNDARY_PRESCRIBED_MOTION_RIGID": "",
    "BOUNDARY_PRESCRIBED_MOTION": "NODE SET",
    "BOUNDARY_SPC": "NODE SET BIRTH_DEATH",
    "BOUNDARY_SPC_SYMMETRY_PLANE": "SET",
    "DEFORMABLE_TO_RIGID": "",
    "CONSTRAINED_EXTRA_NODES_": "NODE SET",
    "CONSTRAINED_RIGID_BODIES": "",
    "CONSTRAINED_NODAL_RIGID_BODY": "SPC INERTIA",
    "CONSTRAINED_JOINT_": ANY,
    "CONSTRAINED_JOINT_STIFFNESS_GENERALIZED": "",
    "CONSTRAINED_NODE_SET": "",
    "CONSTRAINED_LINEAR": "",
    "CONSTRAINED_LINEAR_GLOBAL": "",
    "CONSTRAINED_SPOTWELD": "",
    "CONSTRAINED_RIVET": "",
    "CONSTRAINED_GENERALIZED_WELD": ANY,
    "CONSTRAINED_GLOBAL": "",
    "CONSTRAINED_BEAM_IN_SOLID": "PENALTY",
    "CONSTRAINED_LAGRANGE_IN_SOLID": "",
    "INITIAL_DETONATION": "",
    "INITIAL_AXIAL_FORCE_BEAM": "",
    "INITIAL_VELOCITY": "",
    "INITIAL_VELOCITY_GENERATION": "",
    "INITIAL_VELOCITY_RIGID_BODY": "",
    "INITIAL_VELOCITY_NODE": "",
    "INITIAL_STRESS_": ANY,
    "INITIAL_STRESS_SECTION": "",
    "INITIAL_TEMPERATURE_": "NODE SET",
    "LOAD_BODY_": ANY,
    "LOAD_NODE_": "POINT SET",
    "LOAD_SEGMENT": "SET",
    "LOAD_SHELL_": "SET ELEMENT",
    "LOAD_GRAVITY_PART": "SET",
    "LOAD_RIGID_BODY": "",
    "LOAD_BLAST": "ENHANCED",
    "LOAD_BLAST_SEGMENT": "SET",
    "DAMPING_": ANY,
    "RIGIDWALL_": ANY,
    "CONTACT_": ANY,
    "DATABASE_CROSS_SECTION_PLANE": "",
    "DATABASE_": ANY,
    "SENSOR_": ANY,
    "TERMINATION_NODE": "",
    "TERMINATION_BODY": "",
    "TERMINATION_SENSOR": "",
    "TERMINATION_": "CONTACT CURVE DELETED_SHELLS DELETED_SHELLS_SET DELETED_SOLIDS DELETED_SOLIDS_SET",
}  # fmt: skip


@cache
def compile_options(name: str) -> "re.Pattern[str] | None":
    """What may follow a name; None for anything."""
    if OPTIONS[name] == ANY:
        return None
    first, bar, rest = OPTIONS[name].partition("|")
    return re.compile((f"({make_words(first)})?" if bar else f"({make_words(first)})*") + f"({make_words(rest)})*")


def make_words(text: str) -> str:
    """One of the words with its '_', which ends there."""
    words = sorted(text.split(), key=len, reverse=True)
    return rf"_(?:{'|'.join(map(re.escape, words))})(?=_|\Z)" if words else r"(?!)"


def find_form(names: Iterable[str], keyword: str) -> tuple[str | None, str]:
    """The longest of the names of which the keyword is a form. If it is of none: the name that it begins with, and the
    option that is not in the list."""
    unknown: tuple[str, str] | None = None
    for name in sorted(names, key=len, reverse=True):
        base = name.rstrip("_")
        if not (keyword == base or keyword.startswith(base + "_")):
            continue
        rest, options = keyword[len(base) :], compile_options(name)
        if options is None:
            if rest or not name.endswith("_"):
                return name, ""
            continue
        found = options.match(rest)
        end = found.end() if found else 0
        if end == len(rest) and (rest or not name.endswith("_")):
            return name, ""
        unknown = unknown or (base, rest[end:].strip("_"))
    return None, (unknown[1] if unknown else "")


@cache
def list_keywords() -> tuple[str, ...]:
    """All that can be written out: for words that are misspelt."""
    found = [name.rstrip("_") for name in OPTIONS]
    for name, words in OPTIONS.items():
        found += [f"{name.rstrip('_')}_{word}" for word in words.partition("|")[0].split() if words != ANY]
    return tuple(dict.fromkeys(found))
