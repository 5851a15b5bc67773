"""User code: a VUHARD and a VUMAT in C, which the test compiles and allows."""

import math

from . import LAST, Proof
from .abaqus_materials import BULK, ELASTIC, HEATED, SHEAR, driven, plastic_work, strain, stretched, time_of
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

PROOFS = [
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
