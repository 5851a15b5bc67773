"""User code: a VUHARD and a VUMAT in C, which the test compiles and allows."""

import math

from . import LAST, Proof
from .abaqus_materials import BULK, ELASTIC, END, HEATED, SHEAR, driven, plastic_work, strain, stretched, time_of
from .pieces import DENSITY

# PROPS: yield stress, its slope over the plastic strain, the temperature at which it is 0 (0: never), the strain that deletes.
# STATEV: the first one deletes; the second of three, or the last of more than a hundred, scales the yield by 1 plus itself.
VUHARD = """
void vuhard_(const int* points, const int* element, const int* point, const int* layer, const int* section, const int* anneal,
             const double* step_time, const double* total_time, const double* dt, const char* name, const int* states, const int* fields,
             const int* count, const double* props, const double* t0, const double* t1, const double* f0, const double* f1, const double* state,
             const double* p, const double* rate, double* yield, double* by_t, double* by_p, double* next) {
  const int n = *points;
  for (int i = 0; i < n; ++i) {
    const double soft = *count > 2 && props[2] > 0 ? 1 - t1[i] / props[2] : 1;
    yield[i] = (props[0] + props[1] * p[i]) * soft;
    by_t[i] = *count > 2 && props[2] > 0 ? -(props[0] + props[1] * p[i]) / props[2] : 0;
    by_p[i] = props[1] * soft;
    by_p[n + i] = 0;
    if (*states == 3) yield[i] *= 1 + state[n + i];
    if (*states > 100) yield[i] = props[0] * (1 + state[(*states - 1) * n + i]), next[(*states - 1) * n + i] = p[i];
    if (*count > 3 && p[i] > props[3]) next[i] = 0;
  }
}
"""
# Elastic; PROPS: lambda and mu of one degree. It reports the mean of both stresses over the strain as inelastic energy.
VUMAT = """
void vumat_(const int* points, const int* ndir, const int* nshr, const int* states, const int* fields, const int* count,
            const int* anneal, const double* step_time, const double* total_time, const double* dt, const char* name,
            const double* places, const double* length, const double* props, const double* density, const double* strain,
            const double* spin, const double* t0, const double* u0, const double* f0, const double* q0, const double* stress,
            const double* state, const double* e0, const double* d0, const double* t1, const double* u1, const double* f1,
            const double* q1, double* out, double* next, double* e1, double* d1) {
  const int n = *points;
  for (int i = 0; i < n; ++i) {
    const double trace = strain[i] + strain[n + i] + strain[2 * n + i];
    double work = 0;
    for (int k = 0; k < 6; ++k) {
      out[k * n + i] = stress[k * n + i] + t0[i] * ((k < 3 ? props[0] * trace : 0) + 2 * props[1] * strain[k * n + i]);
      work += (k < 3 ? 0.5 : 1) * (stress[k * n + i] + out[k * n + i]) * strain[k * n + i];
    }
    d1[i] = d0[i] + work / density[i];
  }
}
"""
# What both have: the head of a VUMAT that is elastic with lambda and mu times FACTOR, and adds MORE to the stress along axis 1.
ELASTIC_CODE = """
#include <string.h>
TOP
void vumat_(const int* points, const int* ndir, const int* nshr, const int* states, const int* fields, const int* count,
            const int* anneal, const double* step_time, const double* total_time, const double* dt, const char* name,
            const double* places, const double* length, const double* props, const double* density, const double* strain,
            const double* spin, const double* t0, const double* u0, const double* f0, const double* q0, const double* stress,
            const double* state, const double* e0, const double* d0, const double* t1, const double* u1, const double* f1,
            const double* q1, double* out, double* next, double* e1, double* d1) {
  const int n = *points;
  for (int i = 0; i < n; ++i) {
    const double trace = strain[i] + strain[n + i] + strain[2 * n + i];
    double factor = 1;
    FACTOR
    for (int k = 0; k < 6; ++k) out[k * n + i] = stress[k * n + i] + factor * ((k < 3 ? props[0] * trace : 0) + 2 * props[1] * strain[k * n + i]);
    if (*count > 2) out[i] += props[2] * strain[i];
  }
}
"""


def elastic_code(factor: str = "", top: str = "") -> str:
    return ELASTIC_CODE.replace("FACTOR", factor).replace("TOP", top)


# The last length is the first of its own constants times the extent along axis 1.
LENGTHS = elastic_code("factor = length[(LAST - 1) * n + i];", """
void vucharlength_(const int* n, const int* fields, const int* count, const int* components, const int* dimensions, const int* corners, const int* states,
                   const int* section, const int* layer, const int* point, const int* kind, const int* element, const double* t, const double* s, const double* dt,
                   const char* name, const double* place, const double* x, const double* direct, const double* turn, const double* props, const double* field,
                   const double* state, double* length) {
  for (int c = 0; c < *corners; ++c)
    if (x[c] * direct[0] > length[*components - 1]) length[*components - 1] = x[c] * direct[0];
  length[*components - 1] *= props[*count - 1];
}
""")
TABLES = elastic_code("""
    int error, columns, rows, kinds[2], integers[4]; double numbers[4]; char words[320];
    settablecollection_("OTHERS", &error, 6), queryparametertable_("SCALE", &columns, &rows, &error, 5);
    getparametertable_("SCALE", &columns, kinds, integers, numbers, words, &error, 5, 80);
    if (columns == 2 && rows == 2 && !memcmp(words + 160, "SOFT ", 5)) factor = numbers[3];
""", """
void settablecollection_(const char*, int*, size_t);
void queryparametertable_(const char*, int*, int*, int*, size_t);
void getparametertable_(const char*, const int*, int*, int*, double*, char*, int*, size_t, size_t);
""")
# The last field is the last of the constants of VUSDFLD, and scales the moduli.
FIELDS = elastic_code("factor = q1[(*fields - 1) * n + i];", """
void vusdfld_(const int* n, const int* states, const int* fields, const int* count, const int* ndir, const int* nshr, const int* element, const int* point,
              const int* layer, const int* section, const double* s, const double* t, const double* dt, const char* name, const double* place, const double* direct,
              const double* turn, const double* length, const double* props, const double* old, double* next, double* field) {
  for (int i = 0; i < *n; ++i) field[(*fields - 1) * *n + i] = props[*count - 1];
}
""")
LAMBDA = BULK - 2 / 3 * SHEAR
LAW = f"*USER MATERIAL, CONSTANTS=2\n{LAMBDA!r}, {SHEAR!r}\n"
HARDENING = "*PLASTIC, HARDENING=USER, PROPERTIES="
ADIABATIC = ", ADIABATIC"


def start(degrees: float) -> str:
    return f"*INITIAL CONDITIONS, TYPE=TEMPERATURE\nall, {degrees!r}\n"


def erased(states: str) -> list:
    """The element is deleted at a plastic strain of 0.04."""
    t = time_of(0.04)
    return [stretched(ELASTIC + HARDENING + "4\n300., 0., 0., 0.04\n" + states, 0.1), [("eroded_elements", 0.95 * t, 0.0, 1e-9), ("eroded_elements", 1.05 * t, 1.0, 1e-9)]]


# The yield stress is 300 (1 + p), of the step before.
OF_STATES = plastic_work(300.0, 300.0)
# ds = 3 mu T de and rho c dT = s de: T = cosh(k e), k^2 = 3 mu / (rho c).
CAPACITY = 1e10
WARM = math.cosh(math.sqrt(3 * SHEAR / (DENSITY * CAPACITY)) * strain())

EXTRA = 300000.0
ALONG_ONE = f"*USER MATERIAL, CONSTANTS=3\n{LAMBDA!r}, {SHEAR!r}, {EXTRA!r}\n"
TABLE = ("*PARAMETER TABLE TYPE, NAME=PAIRS, PARAMETERS=2\nSTRING\nFLOAT\n*TABLE COLLECTION, NAME=FIRST\n*PARAMETER TABLE, TYPE=PAIRS, LABEL=SCALE\nsoft, 3.\n"
         "*TABLE COLLECTION, NAME=OTHERS\n*PARAMETER TABLE, TYPE=PAIRS, LABEL=SCALE\nhard, 2.\nsoft, 0.5\n*PARAMETER TABLE, TYPE=PAIRS, LABEL=LAST\nsoft, 9.\n")


def turned(x: float, y: float, orientation: str) -> str:
    """A cube whose law is stiffer along axis 1."""
    return driven(ALONG_ONE, x, y, 0.0, before=orientation).replace("MATERIAL=m\n", "MATERIAL=m, ORIENTATION=o\n")


def energy(modulus: float) -> list:
    return [("internal", LAST, 1000 * 0.5 * modulus * 1e-8, 1e-2)]


PLANE = BULK + 4 / 3 * SHEAR
ALONG_Y = "*ORIENTATION, NAME=o\n0., 1., 0., -1., 0., 0.\n"
OWN = "*CHARACTERISTIC LENGTH, DEFINITION=USER, COMPONENTS=3, PROPERTIES=1\n0.3,\n"
FIELD = "*USER DEFINED FIELD, PROPERTIES=2\n7., 0.4\n"
AGAIN = f"*STEP\n*DYNAMIC, EXPLICIT\n, {END!r}\n*END STEP\n"
AT_START = "*INITIAL CONDITIONS, TYPE=FIELD, VARIABLE=3\nall, 0.\n"

PROOFS = [
    Proof("USER MATERIAL: CONSTANTS", driven(LAW, 1e-4, 0.0, 0.0) + AGAIN, energy(6 * PLANE), "moduli are threefold where stepTime has begun anew",
          code=elastic_code("if (*step_time < *total_time) factor = 3;")),
    Proof("USER DEFINED FIELD: PROPERTIES", driven(LAW + FIELD, 1e-4, 0.0, 0.0), energy(0.4 * PLANE), "the field is 0.4, which scales the moduli", code=FIELDS),
    Proof("INITIAL CONDITIONS: TYPE VARIABLE", driven(LAW + FIELD, 1e-4, 0.0, 0.0, before=AT_START), energy(0.4 * PLANE), "the third of three fields", code=FIELDS),
    Proof("INITIAL CONDITIONS: TYPE", driven(LAW + FIELD, 1e-4, 0.0, 0.0, before=AT_START.replace("0.", "1.")), refused="a field at the start other than 0", code=FIELDS),
    Proof("INITIAL CONDITIONS: VARIABLE", driven(LAW + FIELD, 1e-4, 0.0, 0.0, before=AT_START.replace("=3", "=17")), refused="17 fields", code=FIELDS),
    Proof("USER DEFINED FIELD: PROPERTIES", driven(LAW + FIELD.replace("=2", "=1"), 1e-4, 0.0, 0.0), refused="2 constants (PROPERTIES=1)", code=FIELDS),
    Proof("USER DEFINED FIELD", driven(LAW + FIELD, 1e-4, 0.0, 0.0), refused="no entry vusdfld_", code=elastic_code()),
    Proof("USER DEFINED FIELD", stretched(ELASTIC + "*USER DEFINED FIELD\n"), refused="*USER DEFINED FIELD of a material"),
    Proof("ELASTIC", stretched(ELASTIC.replace("*ELASTIC", "*ELASTIC, DEPENDENCIES=1")), refused="DEPENDENCIES"),
    Proof("SOLID SECTION: ORIENTATION; ORIENTATION: NAME", turned(0.0, 1e-4, ALONG_Y), energy(PLANE + EXTRA), "axis 1 is y, along which the code is stiffer", code=elastic_code()),
    Proof("ORIENTATION: NAME", turned(1e-4, 0.0, ALONG_Y), energy(PLANE), "x is axis 2", code=elastic_code()),
    Proof("ORIENTATION: NAME", turned(1e-4, 0.0, ALONG_Y + "3, 90.\n"), energy(PLANE + EXTRA), "turned by 90 degrees about axis 3 axis 1 is -x", code=elastic_code()),
    Proof("CHARACTERISTIC LENGTH: DEFINITION COMPONENTS PROPERTIES", driven(LAW + OWN, 1e-4, 0.0, 0.0), energy(3 * PLANE),
          "0.3 times the 10 mm of the cube", code=LENGTHS.replace("LAST", "3")),
    Proof("CHARACTERISTIC LENGTH: DEFINITION", driven(LAW + "*CHARACTERISTIC LENGTH, DEFINITION=GEOMETRIC MEAN\n", 1e-4, 0.0, 0.0), energy(10 * PLANE),
          "the edge of a cube of 1000 mm3", code=LENGTHS.replace("LAST", "1")),
    Proof("CHARACTERISTIC LENGTH: COMPONENTS", driven(LAW + OWN.replace("=3", "=13"), 1e-4, 0.0, 0.0), refused="13 characteristic lengths (at most 12)", code=LENGTHS.replace("LAST", "3")),
    Proof("CHARACTERISTIC LENGTH: COMPONENTS", driven(LAW + OWN.replace("=3", "=none"), 1e-4, 0.0, 0.0), refused="is not a positive number", code=LENGTHS.replace("LAST", "3")),
    Proof("CHARACTERISTIC LENGTH: DEFINITION", driven(LAW + OWN, 1e-4, 0.0, 0.0), refused="no entry vucharlength_", code=elastic_code()),
    Proof("CHARACTERISTIC LENGTH: DEFINITION", stretched(ELASTIC + OWN), refused="*CHARACTERISTIC LENGTH of a material"),
    Proof("PARAMETER TABLE TYPE: NAME PARAMETERS; TABLE COLLECTION: NAME; PARAMETER TABLE: TYPE LABEL", driven(LAW, 1e-4, 0.0, 0.0, before=TABLE), energy(0.5 * PLANE),
          "moduli times the number of SOFT in the table SCALE of OTHERS", code=TABLES),
    Proof("PARAMETER TABLE TYPE: PARAMETERS", driven(LAW, 1e-4, 0.0, 0.0, before=TABLE.replace("PARAMETERS=2", "PARAMETERS=3")), refused="2 kinds of columns (PARAMETERS=3)", code=TABLES),
    Proof("PARAMETER TABLE TYPE", driven(LAW, 1e-4, 0.0, 0.0, before=TABLE.replace("FLOAT", "FLOAT, x, 7.")), refused="a default of a parameter table", code=TABLES),
    Proof("PARAMETER TABLE TYPE", driven(LAW, 1e-4, 0.0, 0.0, before=TABLE.replace("FLOAT", "COLOUR")), refused="none of INTEGER, FLOAT and STRING", code=TABLES),
    Proof("PARAMETER TABLE: TYPE", driven(LAW, 1e-4, 0.0, 0.0, before=TABLE.replace("NAME=PAIRS", "NAME=OTHER")), refused="there is no *PARAMETER TABLE TYPE, NAME=PAIRS", code=TABLES),
    Proof("PARAMETER TABLE", driven(LAW, 1e-4, 0.0, 0.0, before=TABLE.replace("soft, 3.", "soft, 3., 4.")), refused="has 3 values for 2 columns", code=TABLES),
    Proof("PARAMETER TABLE", driven(LAW, 1e-4, 0.0, 0.0, before=TABLE.replace("soft, 3.", "soft, red")), refused="is not a number of the kind float", code=TABLES),
    Proof("PARAMETER TABLE", driven(LAW, 1e-4, 0.0, 0.0, before=TABLE.replace("*TABLE COLLECTION, NAME=FIRST\n", "")), refused="outside of a *TABLE COLLECTION", code=TABLES),
    Proof("PLASTIC: HARDENING PROPERTIES; DEPVAR", stretched(ELASTIC + HARDENING + "2\n300., 2000.\n*DEPVAR\n1,\n"), [("internal", LAST, plastic_work(300.0, 2000.0), 1e-2)],
          "300 and a slope of 2000 MPa", code=VUHARD),
    Proof("PLASTIC: PROPERTIES", stretched(ELASTIC + HARDENING + "3\n300., 2000.\n"), [("internal", LAST, plastic_work(300.0, 2000.0), 1e-2)], "a blank is 0", code=VUHARD),
    Proof("PLASTIC: PROPERTIES", stretched(ELASTIC + HARDENING + "20\n300., 2000.\n"), refused="2 constants (PROPERTIES=20)", code=VUHARD),
    Proof("PLASTIC: PROPERTIES", stretched(ELASTIC + "*PLASTIC, HARDENING=USER\n300., 2000.\n"), refused="is not a number", code=VUHARD),
    Proof("PLASTIC: HARDENING PROPERTIES", stretched(ELASTIC + HARDENING + "1\n300.\n"), refused="no library has it"),
    Proof("PLASTIC: HARDENING", stretched(ELASTIC + HARDENING + "2\n300., 0.\n*RATE DEPENDENT, TYPE=POWER LAW\n40., 5.\n"), refused="*RATE DEPENDENT with hardening by user code", code=VUHARD),
    Proof("PLASTIC: HARDENING", stretched(ELASTIC + HARDENING + "2\n300., 0.\n"), refused="no entry vuhard_", code=VUMAT),
    Proof("DEPVAR: DELETE", *erased("*DEPVAR, DELETE=1\n3,\n"), "the first of them is 0 at a strain of 0.04", code=VUHARD),
    Proof("DEPVAR", stretched(ELASTIC + HARDENING + "2\n300., 0.\n*DEPVAR\n500,\n"), [("internal", LAST, OF_STATES, 2e-2)], "the last of 500 has the plastic strain of the step before", code=VUHARD),
    Proof("DEPVAR", stretched(ELASTIC + HARDENING + "2\n300., 0.\n*DEPVAR\n1001,\n"), refused="at most 200 and 1000", code=VUHARD),
    Proof("DYNAMIC: ADIABATIC; INELASTIC HEAT FRACTION; SPECIFIC HEAT",
          stretched(ELASTIC + HARDENING + "3\n300., 0., 100.\n*INELASTIC HEAT FRACTION\n1.,\n*SPECIFIC HEAT\n1e7,\n", dynamic=ADIABATIC), HEATED,
          "sigma = 300 (1 - T / 100) and rho c dT = sigma dp", code=VUHARD),
    Proof("INITIAL CONDITIONS: TYPE", stretched(ELASTIC + HARDENING + "3\n300., 0., 100.\n", before=start(50.0)), [("internal", LAST, plastic_work(150.0), 1e-2)],
          "sigma = 300 (1 - T / 100) at 50 degrees", code=VUHARD),
    Proof("INITIAL CONDITIONS: TYPE; USER MATERIAL: CONSTANTS", driven(LAW, 1e-4, 0.0, 0.0, before=start(2.0)), [("internal", LAST, 2 * 1000 * 0.5 * (BULK + 4 / 3 * SHEAR) * 1e-8, 1e-2)],
          "moduli times the temperature", code=VUMAT),
    Proof("INITIAL CONDITIONS: TYPE", stretched(ELASTIC + HARDENING + "1\n300.\n*DEPVAR\n3,\n", before="*INITIAL CONDITIONS, TYPE=SOLUTION\ncube, , 0.5\n"), [("internal", LAST, plastic_work(450.0), 1e-2)],
          "SOLUTION: the second state variable is 0.5", code=VUHARD),
    Proof("INELASTIC HEAT FRACTION; SPECIFIC HEAT", stretched(LAW + f"*INELASTIC HEAT FRACTION\n1.,\n*SPECIFIC HEAT\n{CAPACITY!r},\n", before=start(1.0), dynamic=ADIABATIC),
          [("internal", LAST, 1000 * DENSITY * CAPACITY * (WARM - 1), 2e-2)], "the work heats, and the moduli follow the temperature", code=VUMAT),
]  # fmt: skip
