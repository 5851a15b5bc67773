"""Materials: one element whose nodes are all led, so that its strain is known, and the stress that the law has at it."""

import math

from . import LAST, MAX, MIN, Proof
from .pieces import CORNERS, CUBE_MASS, DENSITY, cube, curve, deck, elastic, node_set, rigid, shell, velocity

END = 1e-3
SHEAR, BULK = 80000.0, 170000.0  # of E = 207457.6, nu = 0.29661
YOUNG = 9 * BULK * SHEAR / (3 * BULK + SHEAR)
POISSON = (3 * BULK - 2 * SHEAR) / (6 * BULK + 2 * SHEAR)
E_NU = f"{YOUNG!r},{POISSON!r}"
FOLLOW = "*DATABASE_HISTORY_SOLID\n1\n*DATABASE_ELOUT\n1e-5\n"
ZZ, XX, ZX, MISES, PRESSURE, EPS = (f"element_1_{name}" for name in ("stress_zz", "stress_xx", "stress_zx", "von_mises", "pressure", "eps"))


def stretched(material, ratio, *more, path=(), rows=100):
    """A cube of 10 mm whose top moves along z, all else held, until its height is 10 * ratio. path: times and displacements instead."""
    points = path or ((0.0, 0.0), (END, 10.0 * (ratio - 1)))
    return led(material, points, 3, more, rows)


def sheared(material, angle, *more, points=()):
    """Simple shear: the top moves along x."""
    return led(material, points or ((0.0, 0.0), (END, 10.0 * angle)), 1, more)


def led(material, points, direction, more, rows=100):
    held = ",".join("0" if d == direction else "1" for d in (1, 2, 3))
    return deck(cube(material), node_set(1, 1, 2, 3, 4), node_set(2, 5, 6, 7, 8), "*BOUNDARY_SPC_SET\n1,0,1,1,1\n",
                f"*BOUNDARY_SPC_SET\n2,0,{held}\n", f"*BOUNDARY_PRESCRIBED_MOTION_SET\n2,{direction},2,7\n", curve(7, *points), FOLLOW, *more,
                end=END, rows=rows)  # fmt: skip


def stretched_shell(material, ratio, *more, rows=100):
    """A square shell of 10 mm that is stretched equally along x and y."""
    x, y = node_set(1, 2, 3), node_set(2, 3, 4)
    return deck(shell(1.0, material), x, y, "*BOUNDARY_SPC_NODE\n1,0,1,1,1,1,1,1\n2,0,0,1,1,1,1,1\n3,0,0,0,1,1,1,1\n4,0,1,0,1,1,1,1\n",
                "*BOUNDARY_PRESCRIBED_MOTION_SET\n1,1,2,7\n2,2,2,7\n", curve(7, (0.0, 0.0), (END, 10.0 * (ratio - 1))),
                "*DATABASE_HISTORY_SHELL\n1\n*DATABASE_ELOUT\n1e-5\n", *more, end=END, rows=rows)  # fmt: skip


def plastic_strain(strain, yield_stress, hardening, shear=SHEAR):
    """Uniaxial strain: the von Mises stress 2 G strain - 3 G p is the yield stress."""
    return (2 * shear * strain - yield_stress) / (3 * shear + hardening)


def strain_of_thinning(thinning):
    """Of a shell that yields at 300 and is stretched equally along both axes: its stress s = 300 + H p, with p = 2 (e - (1 - nu) / E s)."""
    slope = 1 + 2 * HARDENING * (1 - POISSON) / YOUNG
    share = (1 - 2 * POISSON) / YOUNG
    return (thinning / 2 + share * 300.0 / slope) / (1 - share * 2 * HARDENING / slope)


def mises(strain, yield_stress, hardening, shear=SHEAR):
    return yield_stress + hardening * plastic_strain(strain, yield_stress, hardening, shear)


def erosion_time(history):
    """When the element is gone; 0: it is not."""
    return next((time for time, count in zip(history["time"], history["eroded_elements"]) if count > 0), 0.0)


def time_of(ratio_end, strain):
    """When a cube that is stretched to ratio_end has a logarithmic strain."""
    return END * (math.exp(strain) - 1) / (ratio_end - 1)


UP = 1.02
STRAIN = math.log(UP)
HARDENING = YOUNG * 2000.0 / (YOUNG - 2000.0)  # of ETAN 2000
RATE = STRAIN / END  # its mean
STEP_OF_CUBE = 10.0 / math.sqrt((BULK + 4 / 3 * SHEAR) / DENSITY)


def reversed_kinematic():
    """von Mises stress after 2 % and back to 0, hardening kinematic."""
    first = plastic_strain(STRAIN, 300.0, HARDENING)
    top = 300.0 + HARDENING * first
    back = (2 * SHEAR * STRAIN - 2 * 300.0) / (3 * SHEAR + HARDENING)
    return top - 2 * SHEAR * STRAIN + 3 * SHEAR * back


def cowper(rate, c, p):
    return 1 + (2 / 3 * rate / c) ** (1 / p)


def m24(line_2="0", strains="", stresses="", fail="0", etan="2000.0", tdel="0"):
    return f"*MAT_PIECEWISE_LINEAR_PLASTICITY\n1,{DENSITY!r},{E_NU},300.0,{etan},{fail},{tdel}\n{line_2}\n{strains or '0'}\n{stresses or '0'}\n"


def table_stress(strain):
    """von Mises stress where the table goes from 300 at 0 to 400 at 0.05."""
    return mises(strain, 300.0, 2000.0)


STATE = "*EOS_LINEAR_POLYNOMIAL\n1,0.0,170000.0,40000.0,90000.0\n0.0,1.0\n"
WITH_STATE = ",1"


def state_cube(material, ratio, *more, rows=100, path=()):
    text = stretched(material, ratio, *more, rows=rows, path=path)
    return text.replace("*PART\npart_1\n1,1,1\n", "*PART\npart_1\n1,1,1,1\n")


CLOSED = ((0.0, 0.0), (END / 2, 10.0 * (UP - 1)), (END, 10.0 * (1 / UP - 1)))  # pulled, then pressed


def follow_adiabat(pressure, energy):
    """The pressure at V / V0 = 1 / UP, from 1 on by dE = -p dV; pressure(V / V0, energy per initial volume)."""
    count = 2000
    change = (1 / UP - 1) / count
    for i in range(count):
        at = 1 + i * change
        middle = energy - 0.5 * change * pressure(at, energy)
        energy -= change * pressure(at + 0.5 * change, middle)
    return pressure(1 / UP, energy)


def steinberg(volume, energy):
    """C 4.6e6, S1 1.5, S2 8, S3 9, GAMMA0 2, A 300, as published over mu."""
    mu = 1 / volume - 1
    below = 1 - 0.5 * mu - 8.0 * mu**2 / (mu + 1) - 9.0 * mu**3 / (mu + 1) ** 2
    return DENSITY * 4.6e6**2 * mu * (1 - 150.0 * mu**2) / below**2 + (2.0 + 300.0 * mu) * energy


def tabulated(volume, energy):
    """C from 0 to 3000 and T from 1 to 0.8 over ln(V) from 0 to -2 STRAIN; GAMA 0.5."""
    share = -math.log(volume) / (2 * STRAIN)
    return 3000.0 * share + 0.5 * (1 - 0.2 * share) * energy


def ten(*values):
    """Two lines of five fields of sixteen columns."""
    texts = [f"{value:16.9g}" for value in (*values, *[0.0] * (10 - len(values)))]
    return "".join(texts[:5]) + "\n" + "".join(texts[5:]) + "\n"


TABLES = ten(0.1, 0.0, -2 * STRAIN) + ten(-2e4, 0.0, 3000.0) + ten(1.0, 1.0, 0.8)


def polynomial(ratio):
    mu = 1 / ratio - 1
    return BULK * mu + 40000.0 * mu**2 + 90000.0 * mu**3


COOK_SHOCK = f"*MAT_JOHNSON_COOK\n1,{DENSITY!r},{SHEAR!r},0,0,0,1\n300.0,400.0,0.5,0.03,1.0,1e9,300.0,0.1\n0\n0\n*EOS_GRUNEISEN\n1,4.6e6,1.5,0,0,2.0\n1.0\n"
SHOCKED = [(lambda h: h[MISES][-1] / ((300.0 + 400.0 * h[EPS][-1] ** 0.5) * (1 + 0.03 * math.log(2 / 3 * RATE * 1.01 / 0.1))), LAST, 1.0, 5e-3),
           (PRESSURE, LAST, DENSITY * 4.6e6**2 * (UP - 1) * UP / (UP - 1.5 * (UP - 1)) ** 2, 2e-2)]  # fmt: skip
LINES = {
    "kinematic": lambda beta, line: f"*MAT_PLASTIC_KINEMATIC\n1,{DENSITY!r},{E_NU},300.0,2000.0,{beta}\n{line}\n",
}

METALS = [
    Proof("MAT_ELASTIC: RO E PR MID; PART: PID SECID MID; BOUNDARY_PRESCRIBED_MOTION_SET: NSID DOF VAD LCID; DATABASE_ELOUT",
          stretched(elastic(1, DENSITY, YOUNG, POISSON), 1.001),
          [(ZZ, LAST, (BULK + 4 / 3 * SHEAR) * 0.001, 2e-3), (XX, LAST, (BULK - 2 / 3 * SHEAR) * 0.001, 2e-3)],
          "uniaxial strain: K + 4/3 G along it, K - 2/3 G across it"),
    Proof("MAT_ELASTIC: E PR; ELEMENT_SHELL: EID PID N1 N2 N3 N4; SECTION_SHELL: T1",
          stretched_shell(elastic(1, DENSITY, YOUNG, POISSON), 1.01),
          [(XX, LAST, YOUNG / (1 - POISSON) * math.log(1.01), 2e-3)],
          "equal stretch in plane stress: E / (1 - nu)"),
    Proof("MAT_PLASTIC_KINEMATIC: MID RO E PR SIGY ETAN BETA",
          stretched(LINES["kinematic"]("1.0", "0"), UP),
          [(MISES, LAST, mises(STRAIN, 300.0, HARDENING), 2e-3), (EPS, LAST, plastic_strain(STRAIN, 300.0, HARDENING), 2e-3)],
          "2 G e - 3 G p = 300 + H p with H = E ETAN / (E - ETAN)"),
    Proof("MAT_PLASTIC_KINEMATIC: BETA",
          stretched(LINES["kinematic"]("0.0", "0"), 0, path=((0.0, 0.0), (END / 2, 0.2), (END, 0.0))),
          [(MISES, LAST, abs(reversed_kinematic()), 5e-3)],
          "after reversal it yields at twice the first yield stress below the largest stress"),
    Proof("MAT_PLASTIC_KINEMATIC: SRC SRP VP",
          stretched(f"*MAT_PLASTIC_KINEMATIC\n1,{DENSITY!r},{E_NU},300.0,0.0,1.0\n40.0,5.0,0.0,1.0\n", UP),
          [(MISES, LAST, 300.0 * cowper(RATE / 1.01, 40.0, 5.0), 4e-3)],
          "1 + (rate / C)^(1/P), the plastic rate is 2/3 of that of the strain"),
    Proof("MAT_PLASTIC_KINEMATIC: FS",
          stretched(LINES["kinematic"]("1.0", "0,0,0.008"), UP, rows=1000),
          [(erosion_time, LAST, time_of(UP, (0.008 * (3 * SHEAR + HARDENING) + 300.0) / (2 * SHEAR)), 1e-2)],
          "the plastic strain reaches 0.008"),
    Proof("MAT_PIECEWISE_LINEAR_PLASTICITY: MID RO E PR SIGY ETAN",
          stretched(m24(), UP), [(MISES, LAST, mises(STRAIN, 300.0, HARDENING), 2e-3)], "as of MAT_003"),
    Proof("MAT_PIECEWISE_LINEAR_PLASTICITY: A B C D E F G H",
          stretched(m24("0", "0.0,0.05", "300.0,400.0"), UP), [(MISES, LAST, table_stress(STRAIN), 2e-3)], "slope 2000 over plastic strain"),
    Proof("MAT_PIECEWISE_LINEAR_PLASTICITY: LCSS",
          stretched(m24("0,0,9"), UP, curve(9, (0.0, 300.0), (0.05, 400.0))), [(MISES, LAST, table_stress(STRAIN), 2e-3)], "the curve"),
    Proof("MAT_PIECEWISE_LINEAR_PLASTICITY: C P VP",
          stretched(m24("40.0,5.0,0,0,1", "0.0,0.05", "300.0,300.0"), UP),
          [(MISES, LAST, 300.0 * cowper(RATE / 1.01, 40.0, 5.0), 4e-3)], "as of MAT_003"),
    *[Proof("MAT_PIECEWISE_LINEAR_PLASTICITY: C P", stretched(m24(rates, "0.0,0.05", "300.0,400.0"), UP), [(MISES, LAST, table_stress(STRAIN), 2e-3)], "one constant alone: no dependence on the rate")
      for rates in ("40.0,0,0,0,1", "0,5.0,0,0,1")],
    Proof("MAT_PIECEWISE_LINEAR_PLASTICITY: FAIL",
          stretched(m24(fail="0.008"), UP, rows=1000),
          [(erosion_time, LAST, time_of(UP, (0.008 * (3 * SHEAR + HARDENING) + 300.0) / (2 * SHEAR)), 1e-2)], "the plastic strain reaches 0.008"),
    Proof("MAT_PIECEWISE_LINEAR_PLASTICITY: TDEL",
          stretched(m24(tdel=repr(1.01 * STEP_OF_CUBE)), UP), [("eroded_elements", LAST, 1.0, 0.0)], "the element allows less than TDEL"),
    Proof("MAT_PIECEWISE_LINEAR_PLASTICITY: FAIL", stretched(m24(fail="-0.008"), UP), refused="FAIL"),
    Proof("MAT_MODIFIED_PIECEWISE_LINEAR_PLASTICITY: MID RO E PR SIGY ETAN FAIL TDEL EPSMAJ",
          stretched(m24("0,0,0,0,0,0,0.012").replace("MAT_PIECE", "MAT_MODIFIED_PIECE"), UP, rows=1000),
          [(erosion_time, LAST, time_of(UP, 0.012), 1e-2)], "the largest strain reaches 0.012"),
    *[Proof("MAT_MODIFIED_PIECEWISE_LINEAR_PLASTICITY: EPSTHIN",
            stretched_shell(m24(f"0,0,0,0,0,{thinning}").replace("MAT_PIECE", "MAT_MODIFIED_PIECE"), UP, rows=1000),
            [(erosion_time, LAST, time_of(UP, strain_of_thinning(abs(thinning))), 1e-2)], "plane stress, equal along both axes: 2 (e - (1 - 2 nu) / E s) reaches EPSTHIN")
      for thinning in (0.02, -0.02)],
    Proof("MAT_MODIFIED_PIECEWISE_LINEAR_PLASTICITY: EPSTHIN",
          stretched(m24("0,0,0,0,0,0.002").replace("MAT_PIECE", "MAT_MODIFIED_PIECE"), UP), [(MISES, LAST, mises(STRAIN, 300.0, HARDENING), 3e-3)], "of shells alone"),
    Proof("MAT_PLASTICITY_WITH_DAMAGE: MID RO E PR SIGY ETAN EPPF EPPFR",
          stretched(f"*MAT_PLASTICITY_WITH_DAMAGE\n1,{DENSITY!r},{E_NU},300.0,2000.0,0.004\n0,0,0,0,0.02\n0\n0\n", UP),
          [(lambda h: h[MISES][-1] / ((300.0 + HARDENING * h[EPS][-1]) * (1 - (h[EPS][-1] - 0.004) / 0.016)), LAST, 1.0, 1e-2)],
          "the yield stress times 1 - damage, which grows from 0 at EPPF to 1 at EPPFR"),
    Proof("MAT_PLASTICITY_WITH_DAMAGE: LCDM",
          stretched(f"*MAT_PLASTICITY_WITH_DAMAGE\n1,{DENSITY!r},{E_NU},300.0,2000.0,0.004\n0,0,0,0,0.02,0,9\n", UP), refused="LCDM"),
    Proof("MAT_ISOTROPIC_ELASTIC_PLASTIC: MID RO G SIGY ETAN BULK",
          stretched(f"*MAT_ISOTROPIC_ELASTIC_PLASTIC\n1,{DENSITY!r},{SHEAR!r},300.0,2000.0,{BULK!r}\n", UP),
          [(MISES, LAST, mises(STRAIN, 300.0, 2000.0), 2e-3), (PRESSURE, LAST, -BULK * STRAIN, 2e-3)], "ETAN is over plastic strain"),
    Proof("MAT_ISOTROPIC_ELASTIC_FAILURE: MID RO G SIGY ETAN BULK EPF",
          stretched(f"*MAT_ISOTROPIC_ELASTIC_FAILURE\n1,{DENSITY!r},{SHEAR!r},300.0,2000.0,{BULK!r}\n0.008\n", UP, rows=1000),
          [(erosion_time, LAST, time_of(UP, (0.008 * (3 * SHEAR + 2000.0) + 300.0) / (2 * SHEAR)), 1e-2)], "the plastic strain reaches 0.008"),
    Proof("MAT_ISOTROPIC_ELASTIC_FAILURE: PRF",
          stretched(f"*MAT_ISOTROPIC_ELASTIC_FAILURE\n1,{DENSITY!r},{SHEAR!r},300.0,2000.0,{BULK!r}\n0,-2000.0\n", UP, rows=1000),
          [(erosion_time, LAST, time_of(UP, 2000.0 / BULK), 1e-2)], "the tension K e reaches 2000"),
    Proof("MAT_ISOTROPIC_ELASTIC_FAILURE: REM",
          stretched(f"*MAT_ISOTROPIC_ELASTIC_FAILURE\n1,{DENSITY!r},{SHEAR!r},300.0,2000.0,{BULK!r}\n0.008,0,1\n", UP), refused="REM"),
    Proof("MAT_ISOTROPIC_ELASTIC_FAILURE: TREM",
          stretched(f"*MAT_ISOTROPIC_ELASTIC_FAILURE\n1,{DENSITY!r},{SHEAR!r},300.0,2000.0,{BULK!r}\n0,0,0,{1.01 * STEP_OF_CUBE!r}\n", UP),
          [("eroded_elements", LAST, 1.0, 0.0)], "the element allows less than TREM"),
    Proof("MAT_POWER_LAW_PLASTICITY: MID RO E PR K N SIGY",
          stretched(f"*MAT_POWER_LAW_PLASTICITY\n1,{DENSITY!r},{E_NU},500.0,0.2\n300.0\n", UP),
          [(lambda h: h[MISES][-1] / (500.0 * ((300.0 / 500.0) ** 5 + h[EPS][-1]) ** 0.2), LAST, 1.0, 1e-2),
           (lambda h: h[MISES][-1] + 3 * SHEAR * h[EPS][-1], LAST, 2 * SHEAR * STRAIN, 2e-3)],
          "K (e0 + p)^N with K e0^N = SIGY; 2 G e - 3 G p"),
    Proof("MAT_POWER_LAW_PLASTICITY: SRC SRP EPSF VP",
          stretched(f"*MAT_POWER_LAW_PLASTICITY\n1,{DENSITY!r},{E_NU},500.0,0.01,40.0,5.0\n300.0,1,0.006\n", UP, rows=1000),
          [(erosion_time, LAST, time_of(UP, (0.006 * 3 * SHEAR + 500.0 * 0.006**0.01 * cowper(RATE / 1.01, 40.0, 5.0)) / (2 * SHEAR)), 2e-2)],
          "the plastic strain reaches EPSF; K p^N, scaled by the rate"),
    Proof("MAT_SIMPLIFIED_JOHNSON_COOK: MID RO E PR VP A B N C EPSO",
          stretched(f"*MAT_SIMPLIFIED_JOHNSON_COOK\n1,{DENSITY!r},{E_NU},1\n300.0,400.0,0.5,0.03,0,0,0,0.1\n", UP),
          [(lambda h: h[MISES][-1] / ((300.0 + 400.0 * h[EPS][-1] ** 0.5) * (1 + 0.03 * math.log(2 / 3 * RATE / 1.02 / 0.1))), LAST, 1.0, 3e-3)],
          "(A + B p^N) (1 + C ln(rate / EPSO))"),
    Proof("MAT_SIMPLIFIED_JOHNSON_COOK: PSFAIL",
          stretched(f"*MAT_SIMPLIFIED_JOHNSON_COOK\n1,{DENSITY!r},{E_NU}\n300.0,0.0,1.0,0.0,0.008\n", UP, rows=1000),
          [(erosion_time, LAST, time_of(UP, (0.008 * 3 * SHEAR + 300.0) / (2 * SHEAR)), 1e-2)], "the plastic strain reaches 0.008"),
    Proof("MAT_SIMPLIFIED_JOHNSON_COOK: SIGMAX SIGSAT", stretched(f"*MAT_SIMPLIFIED_JOHNSON_COOK\n1,{DENSITY!r},{E_NU}\n300.0,0,1,0,0,400.0,500.0\n", UP),
          refused="SIGMAX"),
    Proof("MAT_SPOTWELD: MID RO E PR SIGY EH EFAIL",
          stretched(f"*MAT_SPOTWELD\n1,{DENSITY!r},{E_NU},300.0,2000.0\n0.008\n", UP, rows=1000),
          [(erosion_time, LAST, time_of(UP, (0.008 * (3 * SHEAR + 2000.0) + 300.0) / (2 * SHEAR)), 1e-2)], "EH is over plastic strain"),
    Proof("MAT_SPOTWELD: DT", stretched(f"*MAT_SPOTWELD\n1,{DENSITY!r},{E_NU},300.0,2000.0,1e-5\n0\n", UP), refused="mass that is added to welds"),
    Proof("MAT_SPOTWELD: TFAIL", stretched(f"*MAT_SPOTWELD\n1,{DENSITY!r},{E_NU},300.0,2000.0,0,1e-4\n0\n", UP), refused="welds of solids that fail at a time"),
    Proof("MAT_SPOTWELD: NRR NRS NRT MRR MSS MTT", stretched(f"*MAT_SPOTWELD\n1,{DENSITY!r},{E_NU},300.0,2000.0\n0,5.0\n", UP), refused="NRR"),
    Proof("MAT_RIGID: RO", deck(cube(rigid()), velocity(100.0)), [("momentum_x", LAST, 100.0 * CUBE_MASS, 1e-6)], "mass of the part"),
]  # fmt: skip

STATES = [
    Proof("MAT_ELASTIC_PLASTIC_HYDRO: MID RO G SIGY EH; EOS_LINEAR_POLYNOMIAL: EOSID C0 C1 C2 C3; PART: EOSID",
          state_cube(f"*MAT_ELASTIC_PLASTIC_HYDRO\n1,{DENSITY!r},{SHEAR!r},300.0,2000.0\n0\n0\n0\n0\n{STATE}", 1 / UP),
          [(MISES, LAST, mises(STRAIN, 300.0, 2000.0), 3e-3), (PRESSURE, LAST, polynomial(1 / UP), 3e-3)], "C1 mu + C2 mu^2 + C3 mu^3"),
    Proof("MAT_ELASTIC_PLASTIC_HYDRO: FS",
          state_cube(f"*MAT_ELASTIC_PLASTIC_HYDRO\n1,{DENSITY!r},{SHEAR!r},300.0,2000.0,-9e9,0.008\n0\n0\n0\n0\n{STATE}", UP, "") ,
          [("eroded_elements", LAST, 1.0, 0.0)], "the plastic strain reaches 0.008; PC of -9e9 is none"),
    Proof("MAT_ELASTIC_PLASTIC_HYDRO: PC",
          state_cube(f"*MAT_ELASTIC_PLASTIC_HYDRO\n1,{DENSITY!r},{SHEAR!r},300.0,2000.0,-900.0\n0\n0\n0\n0\n{STATE}", UP),
          [(PRESSURE, LAST, -900.0, 1e-6), (MISES, LAST, mises(STRAIN, 300.0, 2000.0), 3e-3)], "tension stays at the cutoff, and the deviator goes on"),
    Proof("MAT_ELASTIC_PLASTIC_HYDRO: PC",
          state_cube(f"*MAT_ELASTIC_PLASTIC_HYDRO\n1,{DENSITY!r},{SHEAR!r},300.0,2000.0,-900.0\n0\n0\n0\n0\n{STATE.replace('90000.0', '90000.0,0.5')}", UP),
          [(PRESSURE, LAST, -900.0, 1e-6)], "likewise where the pressure depends on the energy"),
    Proof("MAT_JOHNSON_COOK: MID RO G A B N C EPSO VP; EOS_GRUNEISEN: EOSID C S1 GAMMA0", state_cube(COOK_SHOCK, 1 / UP), SHOCKED,
          "(A + B p^N) (1 + C ln(rate / EPSO)); Hugoniot pressure rho c^2 mu (1 + mu) / (1 - (S1 - 1) mu)^2, within the energy of 2 %"),
    *[Proof("CONTROL_TIMESTEP: DT2MS MS1ST", state_cube(COOK_SHOCK, 1 / UP, f"*CONTROL_TIMESTEP\n0,0.9,0,0,{-2 * STEP_OF_CUBE!r},0,0,{once}\n", rows=10),
            [*SHOCKED, ("dt", MAX, 1.8 * STEP_OF_CUBE, 5e-2)], "stress and pressure follow from the motion, whatever mass is added: (DT2MS / step)^2 of a cube's")
      for once in (0, 1)],
    Proof("MAT_JOHNSON_COOK: M TM TR CP",
          state_cube(f"*MAT_JOHNSON_COOK\n1,{DENSITY!r},{SHEAR!r}\n300.0,0,1.0,0,1.0,310.0,300.0\n4.6e8\n0\n*EOS_LINEAR_POLYNOMIAL\n1,0,{BULK!r}\n0,1\n", 1 / UP),
          [(lambda h: h[MISES][-1] / (300.0 * math.exp(-300.0 * h[EPS][-1] / (DENSITY * 4.6e8) / 10.0)), LAST, 1.0, 1e-2)],
          "plastic work heats: dT = stress dp / (rho CP), and the stress is A (1 - (T - TR) / (TM - TR))"),
    Proof("MAT_JOHNSON_COOK: E PR",
          stretched_shell(f"*MAT_JOHNSON_COOK\n1,{DENSITY!r},0,{E_NU}\n9e9,0,1.0,0,1.0,1500.0,300.0\n0\n0\n", 1.01),
          [(XX, LAST, YOUNG / (1 - POISSON) * math.log(1.01), 2e-3)], "elastic shells"),
    Proof("MAT_JOHNSON_COOK: DMODEL", state_cube(f"*MAT_JOHNSON_COOK\n1,{DENSITY!r},{SHEAR!r}\n300.0,0,1.0,0,1.0,310.0,300.0\n0\n0,0,0,0,0,0,0,1\n{STATE}", UP), refused="DMODEL"),
    Proof("MAT_NULL: MID RO; EOS_LINEAR_POLYNOMIAL: C4 C5 E0",
          state_cube(f"*MAT_NULL\n1,{DENSITY!r}\n*EOS_LINEAR_POLYNOMIAL\n1,0,{BULK!r},0,0,0.4,0.4\n50.0,1.0\n", 1 / UP),
          [(lambda h: h[PRESSURE][-1] / (BULK * (UP - 1) + 0.4 * UP * (50.0 + BULK * (UP - 1) ** 2 / 2 / UP)), LAST, 1.0, 1e-2)],
          "K mu + 0.4 (1 + mu) E, E from 50 by compression work"),
    Proof("MAT_NULL: PC", state_cube(f"*MAT_NULL\n1,{DENSITY!r},-5.0\n{STATE}", UP), [(PRESSURE, LAST, -5.0, 1e-6)], "tension stays at the cutoff"),
    *[Proof("MAT_NULL: PC", state_cube(f"*MAT_NULL\n1,{DENSITY!r},{cutoff}\n{STATE}", UP, path=CLOSED), [(PRESSURE, LAST, polynomial(1 / UP), 5e-3)],
            "a cavity closes where it has opened: C1 mu + C2 mu^2 + C3 mu^3 of the volume") for cutoff in (-5.0, -1e-6, -3000.0)],
    Proof("MAT_NULL: PC; EOS_GRUNEISEN: C S1", state_cube(f"*MAT_NULL\n1,{DENSITY!r},-5.0\n*EOS_GRUNEISEN\n1,4.6e6,1.5\n1.0\n", UP, path=CLOSED),
          [(PRESSURE, LAST, DENSITY * 4.6e6**2 * (1 - 1 / UP) / (1 - 1.5 * (1 - 1 / UP)) ** 2, 5e-3), (PRESSURE, MIN, -5.0, 1e-6)], "the Hugoniot, without energy"),
    Proof("MAT_NULL: PC; EOS_TABULATED: LCC", state_cube(f"*MAT_NULL\n1,{DENSITY!r},-5.0\n*EOS_TABULATED\n1,0,0,1.0,21\n", UP, curve(21, (-0.1, 3e4), (0.0, 0.0), (0.1, -2e4)), path=CLOSED),
          [(PRESSURE, LAST, 3e5 * math.log(UP), 3e-3), (PRESSURE, MIN, -5.0, 1e-6)], "the table above the cutoff"),
    Proof("MAT_NULL: PC", state_cube(f"*MAT_NULL\n1,{DENSITY!r},-5.0\n*EOS_GRUNEISEN\n1,4.6e6,1.5,0,0,2.0\n1.0\n", UP), [(PRESSURE, LAST, -5.0, 1e-6)],
          "likewise"),
    *[Proof(f"MAT_NULL: {name}", state_cube(f"*MAT_NULL\n1,{DENSITY!r},0,0,{limits}\n{STATE}", ratio, rows=1000),
            [(erosion_time, LAST, time_of(ratio, math.log(volume)), 1e-2)], "the element is gone at this volume over that at the start")
      for name, limits, ratio, volume in (("TEROD", "1.012,0.5", UP, 1.012), ("CEROD", "1.5,0.988", 1 / UP, 0.988))],
    *[Proof(f"MAT_NULL: {name}", state_cube(f"*MAT_NULL\n1,{DENSITY!r},0,0,{limits}\n{STATE}", UP), refused=name) for name, limits in (("TEROD", "0.9"), ("CEROD", "0,1.1"))],
    Proof("MAT_NULL: MU", state_cube(f"*MAT_NULL\n1,{DENSITY!r},0,0.01\n{STATE}", UP).replace("*BOUNDARY_PRESCRIBED_MOTION_SET\n2,3,2", "*BOUNDARY_PRESCRIBED_MOTION_SET\n2,1,2")
          .replace("2,0,1,1,0", "2,0,0,1,1"), [(ZX, LAST, 0.01 * 0.02 / END, 1e-3)], "MU times the rate of shear, 20/s"),
    Proof("MAT_ELASTIC_FLUID: CP", stretched(f"*MAT_ELASTIC_FLUID\n1,{DENSITY!r},{E_NU}\n0,1.0\n", UP), [(PRESSURE, LAST, -1.0, 1e-6)], "tension stays at CP"),
    Proof("MAT_ELASTIC_FLUID: MID RO K", stretched(f"*MAT_ELASTIC_FLUID\n1,{DENSITY!r},0,0,0,0,{BULK!r}\n", 1 / UP),
          [(PRESSURE, LAST, BULK * (UP - 1), 2e-3)], "K (V0 / V - 1)"),
    Proof("MAT_ELASTIC_FLUID: E PR", stretched(f"*MAT_ELASTIC_FLUID\n1,{DENSITY!r},{E_NU}\n", 1 / UP),
          [(PRESSURE, LAST, BULK * (UP - 1), 2e-3)], "K = E / (3 (1 - 2 nu)) where K is blank"),
    Proof("MAT_ELASTIC_FLUID: VC CP", stretched(f"*MAT_ELASTIC_FLUID\n1,{DENSITY!r},{E_NU}\n0.2,1.0\n", 1 / UP), refused="VC"),
    Proof("EOS_LINEAR_POLYNOMIAL: V0", state_cube(f"*MAT_NULL\n1,{DENSITY!r}\n*EOS_LINEAR_POLYNOMIAL\n1,0,{BULK!r}\n0,0.9\n", UP), refused="initial relative volume"),
    Proof("MAT_HIGH_EXPLOSIVE_BURN: MID RO D PCJ; EOS_JWL: EOSID A B R1 R2 OMEG E0 V0; INITIAL_DETONATION: X Y Z",
          deck(cube("*MAT_HIGH_EXPLOSIVE_BURN\n1,1.6e-9,7.0e6,2e4,2\n*EOS_JWL\n1,371000.0,3230.0,4.15,0.95,0.3,7000.0,1.0\n").replace("part_1\n1,1,1\n", "part_1\n1,1,1,1\n"),
               node_set(1, *range(1, 9)), "*BOUNDARY_SPC_SET\n1,0,1,1,1\n*INITIAL_DETONATION\n1,0,0,5.0,0\n", FOLLOW, end=1e-5),
          [(PRESSURE, LAST, 371000.0 * (1 - 0.3 / 4.15) * math.exp(-4.15) + 3230.0 * (1 - 0.3 / 0.95) * math.exp(-0.95) + 0.3 * 7000.0, 1e-3)],
          "burnt at its own volume; PCJ is of burning by compression"),
]  # fmt: skip


def relaxing(strain_rate):
    """Shear stress of a constant rate: GI g + (G0 - GI) rate / beta (1 - exp(-beta t))."""
    return 200.0 * strain_rate * END + 600.0 * strain_rate / 3000.0 * (1 - math.exp(-3000.0 * END))


FOAM = curve(9, (0.0, 0.0), (0.1, 2.0), (0.6, 3.0), (0.9, 20.0))


def moved(material, face, direction, distance, *more):
    """A cube of 10 mm whose lower nodes along an axis are held; those of the upper face move along a direction, held in the others."""
    ends = [[i for i, corner in enumerate(CORNERS, 1) if corner[face - 1] == side] for side in (0, 1)]
    held = ",".join("0" if d == direction else "1" for d in (1, 2, 3))
    return deck(cube(material), node_set(1, *ends[0]), node_set(2, *ends[1]), f"*BOUNDARY_SPC_SET\n1,0,1,1,1\n2,0,{held}\n*BOUNDARY_PRESCRIBED_MOTION_SET\n2,{direction},2,7\n",
                curve(7, (0.0, 0.0), (END, distance)), FOLLOW, *more, end=END)  # fmt: skip


def honey(word, curves="11,12,8,6,5,4,3", volume=0.1, more=""):
    """Laws of honeycomb with other numbers along each axis."""
    return (f"*MAT_{word}\n1,{DENSITY!r},2000.0,0.3,50.0,{volume}{more}\n{curves}\n1000.0,1200.0,1400.0,500.0,550.0,600.0,2\n0,0,0,1,0,0\n0,1,0\n"
            + curve(11, (0.0, 3.0), (1.0, 11.0)) + curve(12, (0.0, 4.0), (1.0, 14.0)) + curve(8, (0.0, 5.0), (1.0, 15.0))
            + curve(6, (0.0, 4.0), (1.0, 4.0)) + curve(5, (0.0, 4.5), (1.0, 4.5)) + curve(4, (0.0, 4.8), (1.0, 4.8)) + curve(3, (0.0, 4.2), (1.0, 4.2)))  # fmt: skip


XX_YY_ZZ, XY_YZ_ZX = (tuple(f"element_1_stress_{pair}" for pair in pairs) for pairs in (("xx", "yy", "zz"), ("xy", "yz", "zx")))
STRENGTHS = ((3.0, 8.0), (4.0, 10.0), (5.0, 10.0))  # and slopes over the crush or the strain
HONEYCOMBS = [
    row
    for word in ("HONEYCOMB", "MODIFIED_HONEYCOMB")
    for card in (f"MAT_{word}",)
    for row in (
        Proof(f"{card}: MID RO", deck(cube(honey(word)), velocity(3.0)), [("momentum_x", LAST, 3.0 * CUBE_MASS, 1e-9)], "its mass"),
        *[Proof(f"{card}: {name} AOPT A1 A2 A3 D1 D2 D3", moved(honey(word), axis, axis, -0.01), [(XX_YY_ZZ[axis - 1], LAST, modulus * math.log(0.999), 5e-3)], "elastic, without a Poisson effect")
          for axis, name, modulus in ((1, "EAAU", 1000.0), (2, "EBBU", 1200.0), (3, "ECCU", 1400.0))],
        *[Proof(f"{card}: {name}", moved(honey(word), face, direction, 0.04), [(XY_YZ_ZX[index], LAST, modulus * 0.004, 1e-2)], "elastic in shear")
          for index, (name, face, direction, modulus) in enumerate((("GABU", 2, 1, 500.0), ("GBCU", 3, 2, 550.0), ("GCAU", 3, 1, 600.0)))],
        *[Proof(f"{card}: {name}", moved(honey(word), face, direction, 0.12), [(XY_YZ_ZX[index], LAST, stress, 1e-2)], "the strength in shear")
          for index, (name, face, direction, stress) in enumerate((("LCAB", 2, 1, 4.5), ("LCBC", 3, 2, 4.8), ("LCCA", 3, 1, 4.2)))],
        Proof(f"{card}: LCS", moved(honey(word, "11,12,8,6"), 3, 1, 0.12), [(ZX, LAST, 4.0, 1e-2)], "of all shears"),
        Proof(f"{card}: MU", moved(honey(word, more=",0.3"), 3, 3, -3.5), [(ZZ, LAST, -8.5 if word == "HONEYCOMB" else -(5.0 - 10.0 * math.log(0.65)), 5e-3)], "a viscosity does nothing in slow compression"),
        Proof(f"{card}: E PR SIGY VF", moved(honey(word, volume=0.5), 3, 3, -5.5, "*CONTROL_TIMESTEP\n0,0.05\n"),
              [(MISES, LAST, 50.0, 1e-2), (PRESSURE, LAST, 2000.0 / (3 * 0.4) * math.log(0.5 / 0.45) + (10.0 if word == "HONEYCOMB" else 5.0 - 10.0 * math.log(0.5)) / 3, 2e-2)],
              "compacted at half of the volume, elastic and perfectly plastic from there; until then the pressure is a third of the strength along z"),
        Proof(f"{card}: MACF", moved(honey(word).replace("600.0,2\n", "600.0,2,3\n"), 3, 3, -3.5), refused="MACF"),
    )
]  # fmt: skip
HONEYCOMBS += [
    *[Proof(f"MAT_HONEYCOMB: {name}", moved(honey("HONEYCOMB"), axis, axis, -3.5), [(XX_YY_ZZ[axis - 1], LAST, -(a + b * 0.35), 5e-3)], "the strength at 1 - V = 0.35")
      for axis, (name, (a, b)) in enumerate(zip(("LCA", "LCB", "LCC"), STRENGTHS), 1)],
    *[Proof(f"MAT_MODIFIED_HONEYCOMB: {name}", moved(honey("MODIFIED_HONEYCOMB"), axis, axis, -3.5), [(XX_YY_ZZ[axis - 1], LAST, -(a - b * math.log(0.65)), 5e-3)], "the strength at the logarithmic strain")
      for axis, (name, (a, b)) in enumerate(zip(("LCA", "LCB", "LCC"), STRENGTHS), 1)],
    *[Proof("MAT_MODIFIED_HONEYCOMB: LCC; SECTION_SOLID: ELFORM", moved(honey("MODIFIED_HONEYCOMB"), 3, 3, -3.5).replace("*SECTION_SOLID\n1,1\n", f"*SECTION_SOLID\n1,{form}\n"),
            [(ZZ, LAST, -8.5, 5e-3)], "the strength at the engineering strain of a corotational element") for form in (0, 9)],
    Proof("MAT_MODIFIED_HONEYCOMB: LCS", moved(honey("MODIFIED_HONEYCOMB", "11,12,8"), 3, 3, -3.5), refused="changes with the shear strain"),
    Proof("MAT_MODIFIED_HONEYCOMB: LCA", moved(honey("MODIFIED_HONEYCOMB", "-11,12,8,6"), 3, 3, -3.5), refused="angle off the axis"),
    Proof("SECTION_SOLID: ELFORM", moved(honey("HONEYCOMB"), 3, 3, -3.5).replace("*SECTION_SOLID\n1,1\n", "*SECTION_SOLID\n1,9\n"), refused="formulation 9"),
]  # fmt: skip
HONEY = f"*MAT_HONEYCOMB\n1,{DENSITY!r},2000.0,0.3,50.0,0.1\n9,9,8\n1000.0,1000.0,1000.0,500.0,500.0,500.0,2\n0,0,0,1,0,0\n0,1,0\n"
LINKED = 1 + 3 / (5 * 4) + 99 / (175 * 4**2) + 513 / (875 * 4**3) + 42039 / (67375 * 4**4)  # mu0 / G of N = 4 links
OGDEN_TERMS = ((7.0, 3.0), (-2.0, -1.5), (0.4, 5.0), (1.0, 1.3), (0.3, 2.2), (-0.5, -3.0), (0.2, 4.0), (-0.1, -0.7))
OGDEN = f"*MAT_OGDEN_RUBBER\n1,{DENSITY!r},0.49,0\n{','.join(str(m) for m, _ in OGDEN_TERMS)}\n{','.join(str(a) for _, a in OGDEN_TERMS)}\n"
LONG = math.sqrt(0.8**2 + 4)  # l + 1 / l of the shear 0.8
RUBBER_TEST = curve(9, (-1.0, -48.0), (-0.8, -32.0), (0.0, 0.0), (1.0, 24.0), (4.0, 60.0))  # force over length, of a test piece 2 long and of area 4
EXACT_ZERO = "0.0,0.0\n"
NEARLY_ZERO = RUBBER_TEST.replace(EXACT_ZERO, "-2.7755576e-17,4.1e-10\n")  # a row at 0 as a program writes it
HYPER = f"*MAT_HYPERELASTIC_RUBBER\n1,{DENSITY!r},0.49,0\n"
SIMPLE = f"*MAT_SIMPLIFIED_RUBBER/FOAM\n1,{DENSITY!r},700.0,0.1\n2.0,2.0,2.0,9\n"
GENERAL = f"*MAT_GENERAL_VISCOELASTIC\n1,{DENSITY!r},900.0\n0\n200.0,0.0,1500.0,0.0\n600.0,3000.0,800.0,2000.0\n300.0,500.0\n"


def squeezed(material, ratio):
    """A cube whose height becomes 10 * ratio and whose volume stays."""
    side = ratio**-0.5
    moves = "".join(f"*BOUNDARY_PRESCRIBED_MOTION_NODE\n{n},{d},2,{6 + d}\n" for n, corner in enumerate(CORNERS, 1) for d in (1, 2, 3) if corner[d - 1])
    held = "".join(f"*BOUNDARY_SPC_NODE\n{n},0,{','.join('0' if c else '1' for c in corner)}\n" for n, corner in enumerate(CORNERS, 1))
    lead = [(t / 40 * END, 10 * (ratio ** (t / 40) - 1), 10 * (side ** (t / 40) - 1)) for t in range(41)]
    paths = [curve(7, *((t, u) for t, _, u in lead)), curve(8, *((t, u) for t, _, u in lead)), curve(10, *((t, u) for t, u, _ in lead))]
    return deck(cube(material), held, moves.replace(",2,9\n", ",2,10\n"), *paths, RUBBER_TEST, FOLLOW, end=END)


SOFT = [
    Proof("MAT_VISCOELASTIC: MID RO BULK G0 GI BETA", sheared(f"*MAT_VISCOELASTIC\n1,{DENSITY!r},2000.0,800.0,200.0,3000.0\n", 0.02),
          [(ZX, LAST, relaxing(20.0), 3e-3)], "GI + (G0 - GI) exp(-BETA t)"),
    Proof("MAT_BLATZ-KO_RUBBER: MID RO G", sheared(f"*MAT_BLATZ-KO_RUBBER\n1,{DENSITY!r},50.0\n", 0.02),
          [(ZX, LAST, 50.0 * 0.02, 3e-3)], "G times the angle"),
    Proof("MAT_MOONEY-RIVLIN_RUBBER: MID RO A B", sheared(f"*MAT_MOONEY-RIVLIN_RUBBER\n1,{DENSITY!r},0.49,20.0,5.0\n0\n", 0.02),
          [(ZX, LAST, 2 * 25.0 * 0.02, 3e-3)], "2 (A + B) times the angle"),
    Proof("MAT_MOONEY-RIVLIN_RUBBER: A B", sheared(f"*MAT_MOONEY-RIVLIN_RUBBER\n1,{DENSITY!r},0.49,20.0,-5.0\n0\n", 0.8),
          [(ZX, LAST, 2 * 15.0 * 0.8, 5e-3)], "a negative B: 2 (A + B) times the shear"),
    Proof("MAT_MOONEY-RIVLIN_RUBBER: PR", stretched(f"*MAT_MOONEY-RIVLIN_RUBBER\n1,{DENSITY!r},0.49,20.0,5.0\n0\n", 0.999),
          [(PRESSURE, LAST, 4 * 25.0 * 1.49 / (3 * 0.02) * 0.001, 5e-3)], "K = 2 G (1 + nu) / (3 (1 - 2 nu)), G = 2 (A + B)"),
    Proof("MAT_ARRUDA_BOYCE: MID RO G N", sheared(f"*MAT_ARRUDA_BOYCE\n1,{DENSITY!r},2000.0,20.0,4.0\n0\n", 0.02),
          [(ZX, LAST, 20.0 * LINKED * 0.02, 3e-3)], "the shear modulus of chains of N links"),
    Proof("MAT_ARRUDA_BOYCE: K", stretched(f"*MAT_ARRUDA_BOYCE\n1,{DENSITY!r},2000.0,20.0,4.0\n0\n", 0.999),
          [(PRESSURE, LAST, 2000.0 * 0.001, 5e-3)], "K times the strain"),
    Proof("MAT_ARRUDA_BOYCE: LCID NT", sheared(f"*MAT_ARRUDA_BOYCE\n1,{DENSITY!r},2000.0,20.0,4.0\n5\n", 0.02, curve(5, (0.0, 1.0), (1.0, 0.5))), refused="relaxes"),
    Proof("MAT_OGDEN_RUBBER: MID RO MU1 ALPHA1 " + " ".join(f"MU{i} ALPHA{i}" for i in range(2, 9)), sheared(OGDEN, 0.8),
          [(ZX, LAST, sum(mu * (0.5 * (0.8 + LONG)) ** a - mu * (0.5 * (LONG - 0.8)) ** a for mu, a in OGDEN_TERMS) / LONG, 5e-3)],
          "principal stretches l and 1 / l with l - 1 / l = 0.8: shear stress sum of mu (l^alpha - l^-alpha) / (l + 1 / l)"),
    Proof("MAT_HYPERELASTIC_RUBBER: MID RO C10 C01", sheared(HYPER + "20.0,5.0\n", 0.8), [(ZX, LAST, 2 * 25.0 * 0.8, 5e-3)], "2 (C10 + C01) times the shear"),
    Proof("MAT_HYPERELASTIC_RUBBER: C20 C30", sheared(HYPER + "20.0,0,0,6.0,0,2.0\n", 0.8),
          [(ZX, LAST, 2 * 0.8 * (20.0 + 2 * 6.0 * 0.64 + 3 * 2.0 * 0.64**2), 5e-3)], "I1 - 3 is the square of the shear: twice the slope of the energy over I1, times the shear"),
    Proof("MAT_HYPERELASTIC_RUBBER: PR", stretched(HYPER + "20.0,5.0\n", 0.999),
          [(PRESSURE, LAST, 4 * 25.0 * 1.49 / (3 * 0.02) * 0.001, 5e-3)], "K = 2 G (1 + nu) / (3 (1 - 2 nu)), G = 2 (C10 + C01)"),
    Proof("MAT_HYPERELASTIC_RUBBER: N", stretched(HYPER.replace("0.49,0", "0.49,2") + "1.0,1.0,1.0,9\n", 0.999), refused="N above 0"),
    Proof("MAT_HYPERELASTIC_RUBBER: C11 C02", stretched(HYPER + "20.0,5.0,1.0,0,2.0\n", 0.999), refused="I2 - 3"),
    Proof("MAT_HYPERELASTIC_RUBBER: GI BETAI", stretched(HYPER + "20.0,5.0\n3.0,100.0\n", 0.999), refused="relaxes"),
    Proof("MAT_HYPERELASTIC_RUBBER: G SIGF THERML", stretched(HYPER.replace("0.49,0", "0.49,0,0,3.0,0.2") + "20.0,5.0\n", 0.999), refused="SIGF"),
    Proof("MAT_OGDEN_RUBBER: PR", stretched(OGDEN, 0.999),
          [(PRESSURE, LAST, sum(mu * a for mu, a in OGDEN_TERMS) * 1.49 / (3 * 0.02) * 0.001, 5e-3)], "K = 2 G (1 + nu) / (3 (1 - 2 nu)), G half the sum of mu alpha"),
    Proof("MAT_OGDEN_RUBBER: N", stretched(OGDEN.replace("0.49,0", "0.49,2"), 0.999), refused="N above 0"),
    Proof("MAT_OGDEN_RUBBER: GI BETAI", stretched(OGDEN + "3.0,100.0\n", 0.999), refused="relaxes"),
    Proof("MAT_OGDEN_RUBBER: G SIGF", stretched(OGDEN.replace("0.49,0", "0.49,0,0,3.0,0.2"), 0.999), refused="SIGF"),
    Proof("MAT_SIMPLIFIED_RUBBER/FOAM: MID RO MU SGL SW ST TBID", squeezed(SIMPLE, 1.3),
          [(lambda h: (h[ZZ][-1] - h[XX][-1]) / 1.3, LAST, 6.0 * 0.6, 1e-2)], "half of the force at twice half of the change of length: the curve of the test"),
    Proof("MAT_SIMPLIFIED_RUBBER/FOAM: TBID", squeezed(SIMPLE, 0.7),
          [(lambda h: (h[ZZ][-1] - h[XX][-1]) / 0.7, LAST, -8.0 * 0.75, 1e-2)], "the curve in compression"),
    Proof("MAT_SIMPLIFIED_RUBBER/FOAM: TBID", squeezed(SIMPLE, 0.7).replace(RUBBER_TEST, NEARLY_ZERO),
          [(lambda h: (h[ZZ][-1] - h[XX][-1]) / 0.7, LAST, -8.0 * 0.75, 1e-2)], "a strain of round-off is 0"),
    Proof("MAT_SIMPLIFIED_RUBBER/FOAM: KM", stretched(SIMPLE, 0.999, RUBBER_TEST), [(PRESSURE, LAST, 700.0 * 0.001, 5e-3)], "KM times the strain"),
    Proof("MAT_SIMPLIFIED_RUBBER/FOAM: PR", stretched(SIMPLE.replace(",9\n", ",9,0,0,0,0.3\n"), 0.999, RUBBER_TEST), refused="compressible foam"),
    Proof("MAT_SIMPLIFIED_RUBBER/FOAM: G SIGF PRTEN", stretched(SIMPLE.replace("700.0,0.1", "700.0,0.1,3.0,0.2,0,0.3"), 0.999, RUBBER_TEST), refused="PRTEN"),
    Proof("MAT_SIMPLIFIED_RUBBER/FOAM: LCUNLD HU SHAPE", stretched(SIMPLE + "0,0.2,3.0\n", 0.999, RUBBER_TEST), refused="HU"),
    Proof("MAT_GENERAL_VISCOELASTIC: MID RO GI BETAI", sheared(GENERAL, 0.02),
          [(ZX, LAST, 0.02 * (200.0 + sum(g * (1 - math.exp(-b * END)) / (b * END) for g, b in ((600.0, 3000.0), (300.0, 500.0)))), 3e-3)],
          "the long-term modulus and two terms at a constant rate"),
    Proof("MAT_GENERAL_VISCOELASTIC: KI BETAKI", stretched(GENERAL, 1.001),
          [(PRESSURE, LAST, -0.001 * (1500.0 + 800.0 * (1 - math.exp(-2000.0 * END)) / (2000.0 * END)), 5e-3)], "terms of the bulk modulus, BULK counts no more"),
    Proof("MAT_GENERAL_VISCOELASTIC: BULK", stretched(GENERAL.replace(",1500.0,0.0", "").replace(",800.0,2000.0", ""), 1.001), [(PRESSURE, LAST, -0.001 * 900.0, 5e-3)], "BULK without terms KI"),
    Proof("MAT_GENERAL_VISCOELASTIC: LCID LCIDK", stretched(GENERAL.replace("\n0\n", "\n9\n"), 1.001, RUBBER_TEST), refused="fitted to a curve"),
    Proof("MAT_GENERAL_VISCOELASTIC: PCF EF A B", stretched(GENERAL.replace(",900.0", ",900.0,1.0,1,0,3.0,4.0"), 1.001), refused="PCF"),
    Proof("MAT_SOIL_AND_FOAM: MID RO G BULK A0 VCR LCID A B C D E F G H I J",
          stretched(f"*MAT_SOIL_AND_FOAM\n1,{DENSITY!r},800.0,2000.0,12.0,0,0,0\n0\n0.0,-0.1\n\n0.0,30.0\n\n", math.exp(-0.05)),
          [(PRESSURE, LAST, 15.0, 3e-3), (MISES, LAST, 6.0, 3e-3)], "half of the curve; J2 = A0 is a von Mises stress of sqrt(3 A0)"),
    Proof("MAT_LOW_DENSITY_FOAM: MID RO E LCID", stretched(f"*MAT_LOW_DENSITY_FOAM\n1,{DENSITY!r},20.0,9\n1.0\n", 0.65, FOAM),
          [(ZZ, LAST, -(2.0 + 0.25 / 0.5), 5e-3)], "nominal stress at the nominal strain 0.35, without a Poisson effect"),
    Proof("MAT_CRUSHABLE_FOAM: MID RO E LCID", stretched(f"*MAT_CRUSHABLE_FOAM\n1,{DENSITY!r},2000.0,0.0,9\n", 0.65, FOAM),
          [(ZZ, LAST, -(2.0 + 0.25 / 0.5), 5e-3)], "the curve at 1 - V = 0.35"),
    Proof("MAT_HONEYCOMB: MID RO E PR SIGY VF LCA LCB LCC EAAU EBBU ECCU GABU GBCU GCAU AOPT A1 A2 A3 D1 D2 D3",
          stretched(f"*MAT_HONEYCOMB\n1,{DENSITY!r},2000.0,0.3,50.0,0.1\n9,9,8\n1000.0,1000.0,1000.0,500.0,500.0,500.0,2\n0,0,0,1,0,0\n0,1,0\n", 0.65, FOAM,
                    curve(8, (0.0, 5.0), (1.0, 15.0))),
          [(ZZ, LAST, -(5.0 + 10.0 * 0.35), 5e-3)], "LCC at 1 - V = 0.35"),
    Proof("MAT_HONEYCOMB: TSEF SSEF",
          stretched(f"*MAT_HONEYCOMB\n1,{DENSITY!r},2000.0,0.3,50.0,0.1\n9\n1000.0,1000.0,1000.0,500.0,500.0,500.0,2\n0,0,0,1,0,0\n0,1,0,0.2,0.3\n", 0.65, FOAM), refused="TSEF"),
]  # fmt: skip


def eroding(first, second="0", material="", ratio=UP):
    return stretched((material or elastic(1, DENSITY, YOUNG, POISSON)) + f"*MAT_ADD_EROSION\n1,0,{first}\n{second}\n", ratio, rows=1000)


CURVES_OF_FAILURE = curve(17, (-1.0, 0.008), (2.0, 0.008)) + curve(18, (1.0, 0.5), (100.0, 0.5)) + curve(19, (-1.0, 0.0), (2.0, 0.008))


def gissmo(fields):
    return stretched(m24() + CURVES_OF_FAILURE + f"*MAT_ADD_DAMAGE_GISSMO\n1,,1\n{fields}\n", UP, rows=1000)


CURVES_OF_SOFTENING = curve(20, (-1.0, 0.02), (2.0, 0.02)) + curve(21, (-1.0, 0.004), (2.0, 0.004)) + curve(22, (1.0, 2.0), (100.0, 2.0)) + curve(23, (0.0, 2.0), (1e6, 2.0)) + curve(24, (-5.0, 2.0), (5.0, 2.0))


def softens(fields):
    return stretched(m24() + CURVES_OF_SOFTENING + f"*MAT_ADD_DAMAGE_GISSMO\n1,,1\n{fields}\n", UP, rows=1000)


def softened(failure, start, exponent, fade):
    """The von Mises stress at the end: its share ((D - D0) / (1 - D0))^fade is lost, D and D0 the plastic strain over that of failure, and another, to a power."""
    damage, first = (plastic_strain(STRAIN, 300.0, HARDENING) / failure) ** exponent, start**exponent
    return mises(STRAIN, 300.0, HARDENING) * (1 - ((damage - first) / (1 - first)) ** fade)


def diem(fields):
    """Shear strains: 0.004 at the ratio 2, which the cube has without pressure (25); 1 where it is negative (26)."""
    more = curve(25, (1.0, 0.02), (2.0, 0.004), (3.0, 0.002)) + curve(26, (-1.0, 1.0), (1.0, 0.004))
    return stretched(m24() + CURVES_OF_SOFTENING + more + f"*MAT_ADD_DAMAGE_DIEM\n{fields}\n", UP, rows=1000)


LAST_STRAIN = plastic_strain(STRAIN, 300.0, HARDENING)


def parted(share):
    """The von Mises stress at the end, of which a share is left."""
    return share * mises(STRAIN, 300.0, HARDENING)


STIFF = BULK + 4 / 3 * SHEAR
EROSION = [
    Proof("MAT_ADD_EROSION: MID SIGP1", eroding("0", "0,3000.0"), [(erosion_time, LAST, time_of(UP, 3000.0 / STIFF), 2e-2)], "the largest stress reaches 3000"),
    Proof("MAT_ADD_EROSION: MXEPS", eroding("0", "0,0,0,0.012"), [(erosion_time, LAST, time_of(UP, 0.012), 1e-2)], "the largest strain reaches 0.012"),
    Proof("MAT_ADD_EROSION: MNPRES", eroding("0", "-2000.0"), [(erosion_time, LAST, time_of(UP, 2000.0 / BULK), 2e-2)], "the tension reaches 2000"),
    Proof("MAT_ADD_EROSION: EFFEPS", eroding("0,0,-0.008", "0", m24()),
          [(erosion_time, LAST, time_of(UP, (0.008 * (3 * SHEAR + HARDENING) + 300.0) / (2 * SHEAR)), 1e-2)], "below 0: the plastic strain"),
    Proof("MAT_ADD_EROSION: EFFEPS", eroding("0,0,0.01", "0", m24()), [(erosion_time, LAST, time_of(UP, 0.01 * 1.5), 1e-2)],
          "above 0: the effective strain, 2/3 of a strain along z alone"),
    Proof("MAT_ADD_EROSION: EFFEPS", eroding("0,0,0.001", "0", m24()), refused="does not yield before it"),
    Proof("MAT_ADD_EROSION: FAILTM", eroding("0", "0,3000.0,0,0,0,0,0,1.0"), [(erosion_time, LAST, time_of(UP, 3000.0 / STIFF), 2e-2)],
          "a time behind the end is none"),
    Proof("MAT_ADD_EROSION: FAILTM", eroding("0", "0,0,0,0,0,0,0,1e-4"), refused="FAILTM"),
    Proof("MAT_ADD_EROSION: VOLEPS", eroding("0,0,0,0.012"), [(erosion_time, LAST, time_of(UP, 0.012), 1e-2)], "the logarithm of the volume, which is the strain along z"),
    Proof("MAT_ADD_EROSION: VOLEPS", eroding("0,0,0,-0.012", ratio=1 / UP), [(erosion_time, LAST, time_of(1 / UP, -0.012), 1e-2)], "below 0 in compression"),
    Proof("MAT_ADD_EROSION: VOLEPS", eroding("0,0,0,-0.012"), [("eroded_elements", LAST, 0.0, 0.0)], "which a tension does not reach"),
    Proof("MAT_ADD_EROSION: SIGP1", eroding("0", "0,-7.0"), refused="SIGP1"),
    Proof("MAT_ADD_EROSION: EFFEPS", eroding("0,0,0.1"), refused="EFFEPS"),
    *(Proof(proves, law, [(erosion_time, LAST, time_of(UP, (strain * (3 * SHEAR + HARDENING) + 300.0) / (2 * SHEAR)), 1e-2)], why) for proves, law, strain, why in (
        ("MAT_ADD_DAMAGE_GISSMO: MID DTYP LCSDG DMGEXP", gissmo("17,0,2,1.0"), 0.008, "the failure strain of all stress states is 0.008"),
        ("MAT_ADD_DAMAGE_GISSMO: DCRIT LCREGD", gissmo("17,0,1,1.0,1,18"), 0.004, "half of it for cubes of 10 mm"),
        ("MAT_ADD_EROSION: IDAM DMGTYP LCSDG DCRIT DMGEXP", eroding("0", "0\n1,1,17,0,2,1.0", m24() + CURVES_OF_FAILURE), 0.008, "IDAM of 1"),
        ("MAT_ADD_EROSION: LCREGD", eroding("0", "0\n1,1,17,0,2,1.0,1,18", m24() + CURVES_OF_FAILURE), 0.004, "half of it for cubes of 10 mm"),
    )),
    Proof("MAT_ADD_DAMAGE_GISSMO: DTYP", gissmo("17,0,2,1.0").replace("1,,1", "1,,0"), [(EPS, LAST, plastic_strain(STRAIN, 300.0, HARDENING), 2e-3)], "the damage is output alone: 0.008 is passed"),
    *(Proof(proves, law, [(MISES, LAST, value, 3e-3)], why) for proves, law, value, why in (
        ("MAT_ADD_DAMAGE_GISSMO: ECRIT DMGEXP FADEXP", softens("20,0.004,2,0,1.5"), softened(0.02, 0.2, 2, 1.5), "stress falls from the plastic strain 0.004 on"),
        ("MAT_ADD_DAMAGE_GISSMO: ECRIT", softens("20,-21,1"), softened(0.02, 0.2, 1, 1), "a curve, of one value"),
        ("MAT_ADD_DAMAGE_GISSMO: DCRIT DMGEXP", softens("20,0,2,0.09,1.5"), softened(0.02, 0.3, 2, 1.5), "from the damage 0.09 on"),
        ("MAT_ADD_DAMAGE_GISSMO: FADEXP", softens("20,0.004,1,0,-22"), softened(0.02, 0.2, 1, 2), "the exponent of cubes of 10 mm"),
        ("MAT_ADD_DAMAGE_GISSMO: LCSRS", softens("20,0.002,1\n23"), softened(0.04, 0.1, 1, 1), "twice the strains at any rate"),
        ("MAT_ADD_DAMAGE_GISSMO: LCSRS", softens("20,0,1,0.1\n-23"), softened(0.04, 0.1, 1, 1), "twice the failure strain"),
        ("MAT_ADD_EROSION: IDAM ECRIT DMGEXP FADEXP", eroding("0", "0\n1,1,20,0.004,2,0,1.5", m24() + CURVES_OF_SOFTENING), softened(0.02, 0.2, 2, 1.5), "likewise"),
        ("MAT_ADD_EROSION: DCRIT LCSRS", eroding("0", "0\n1,1,20,0,1,0.1\n0,0,0,23", m24() + CURVES_OF_SOFTENING), softened(0.04, 0.1, 1, 1), "likewise"),
    )),
    Proof("MAT_ADD_DAMAGE_GISSMO: LCSRS", softens("20,0.002,1\n-23"), refused="ECRIT does not have"),
    Proof("MAT_ADD_DAMAGE_GISSMO: LCSRS", softens("20,0.002,1\n24"), refused="logarithms of rates"),
    Proof("MAT_ADD_DAMAGE_GISSMO: DMGEXP", softens("20,0.002,-1"), refused="must not be negative"),
    Proof("MAT_ADD_DAMAGE_GISSMO: LCREGD", gissmo("17,0,2,1.0,1,-18"), refused="over size and triaxiality"),
    Proof("MAT_ADD_DAMAGE_GISSMO: SHRF", gissmo("17,0,2,1.0\n0,1"), refused="SHRF"),
    Proof("MAT_ADD_DAMAGE_GISSMO: LCSDG", gissmo("19,0,2,1.0"), refused="not positive"),
    Proof("MAT_ADD_EROSION: IDAM", eroding("0", "0\n-1,1,17,0,2,1.0", m24() + CURVES_OF_FAILURE), refused="other than GISSMO"),
    Proof("MAT_ADD_DAMAGE_GISSMO", stretched(elastic() + "*MAT_ADD_DAMAGE_GISSMO\n1,,1\n17\n", UP), refused="MAT_ADD_DAMAGE_GISSMO"),
    Proof("MAT_ADD_DAMAGE_GISSMO", stretched(elastic(1, DENSITY, YOUNG, POISSON) + "*MAT_ADD_DAMAGE_GISSMO\n1,,1\n17\n", 1.001),
          [(ZZ, LAST, STIFF * 0.001, 2e-3)], "without it the material is that of its own card", allow="MAT_ADD_DAMAGE_GISSMO"),
    *(Proof(proves, diem(fields), [(MISES, LAST, value, 3e-3)], why) for proves, fields, value, why in (
        ("MAT_ADD_DAMAGE_DIEM: MID NDIEMC DITYP P1 DETYP Q1", "1,1\n0,21\n0,0,0.2", parted(1 - (LAST_STRAIN - 0.004) / 0.02), "stress falls over 0.2 mm from the plastic strain 0.004 on"),
        ("MAT_ADD_DAMAGE_DIEM: DETYP Q1", "1,1\n0,21\n1,0,50.0", parted(1 - (LAST_STRAIN - 0.004) * 10.0 * (300.0 + HARDENING * 0.5 * (LAST_STRAIN + 0.004)) / 100.0), "over 50 N/mm, by the work of the whole stress"),
        ("MAT_ADD_DAMAGE_DIEM: DITYP P1 P2", "1,1\n1,25\n0,0,0.2", parted(1 - (LAST_STRAIN - 0.004) / 0.02), "by shear: the ratio 2 without P2"),
        ("MAT_ADD_DAMAGE_DIEM: NDIEMC", "1,2\n0,20\n0,0,0.2\n1,25\n0,0,0.2", parted(1 - (LAST_STRAIN - 0.004) / 0.02), "the first of two begins"),
        ("MAT_ADD_DAMAGE_DIEM: DCTYP", "1,1\n0,21\n0,-1,0.2", parted(1.0), "the damage is output alone"),
    )),
    Proof("MAT_ADD_DAMAGE_DIEM: P2", diem("1,1\n1,26,2.0\n0,0,0.2"), [(MISES, LAST, parted(1.0), 3e-3)], "a tension makes the ratio negative, where the failure strain is 1"),
    *(Proof(proves, diem(fields), refused=text) for proves, fields, text in (
        ("MAT_ADD_DAMAGE_DIEM: DITYP", "1,1\n2,21\n0,0,0.2", "DITYP of 2"),
        ("MAT_ADD_DAMAGE_DIEM: Q1", "1,1\n0,21\n0,0,-21", "grows by a table"),
        ("MAT_ADD_DAMAGE_DIEM: DCTYP", "1,2\n0,20\n0,1,0.2\n1,25\n0,1,0.2", "damages that multiply"),
        ("MAT_ADD_DAMAGE_DIEM: DETYP", "1,2\n0,20\n0,0,0.2\n1,25\n1,0,0.2", "grow differently"),
        ("MAT_ADD_DAMAGE_DIEM", "1,2\n0,20\n0,0,0.2\n0,21\n0,0,0.2", "two criteria of one kind"),
        ("MAT_ADD_DAMAGE_DIEM: DINIT", "1,1,1\n0,21\n0,0,0.2", "DINIT"),
    )),
    Proof("MAT_NONLOCAL", stretched(elastic() + "*MAT_NONLOCAL\n1\n", UP), refused="MAT_NONLOCAL"),
]  # fmt: skip

def m123(second, third="", fourth="", word="MAT_MODIFIED_PIECEWISE_LINEAR_PLASTICITY"):
    return f"*{word}\n1,{DENSITY!r},{E_NU},300.0,2000.0\n{second}\n{third or '0'}\n{fourth or '0'}\n"


def at_strain(strain):
    """When the plastic strain of a law without hardening beyond 2000 over plastic strain is reached."""
    return time_of(UP, (strain * (3 * SHEAR + HARDENING) + 300.0) / (2 * SHEAR))


def cook(damage, last="0"):
    return f"*MAT_JOHNSON_COOK\n1,{DENSITY!r},{SHEAR!r}\n300.0,0,1.0,0,1.0,1e9,300.0,1.0\n0,0,0,0,{damage}\n{last}\n*EOS_LINEAR_POLYNOMIAL\n1,0,{BULK!r}\n0,1\n"


def flat(strain):
    """When the plastic strain of a law without hardening is reached."""
    return time_of(UP, (strain * 3 * SHEAR + 300.0) / (2 * SHEAR))


HEATING = 300.0 / (DENSITY * 4.6e8) / 1000.0  # of the law below, a plastic strain: the share of the way to TM
HOT = (f"*MAT_JOHNSON_COOK\n1,{DENSITY!r},{SHEAR!r}\n300.0,0,1.0,0,1.0,1300.0,300.0,1.0\n4.6e8,0,0,0,0.006\n1000.0\n*EOS_LINEAR_POLYNOMIAL\n1,0,{BULK!r}\n0,1\n")


def bent(material, *more):
    """A shell of two layers that is bent about y and stretched along x, so that the upper layer gets a strain of 1.2 %, the lower one none."""
    curvature = 0.006 / (0.5 / math.sqrt(3))
    return deck(shell(1.0, material), "*BOUNDARY_SPC_NODE\n1,0,1,1,1,1,0,1\n4,0,1,1,1,1,0,1\n2,0,0,1,1,1,0,1\n3,0,0,1,1,1,0,1\n", node_set(1, 1, 4), node_set(2, 2, 3),
                "*BOUNDARY_PRESCRIBED_MOTION_SET\n2,1,0,7,0.06\n1,6,0,7," + f"{-5 * curvature:.6g}\n2,6,0,7,{5 * curvature:.6g}\n", curve(7, (0.0, 1 / END), (1.0, 1 / END)), *more, end=END)  # fmt: skip


LAYERS = [
    Proof(f"{card}: {name}", bent(material.format(layers)), [("eroded_elements", LAST, gone, 0.0)], "one of two layers reaches the limit")
    for card, name, material in (
        ("MAT_MODIFIED_PIECEWISE_LINEAR_PLASTICITY", "NUMINT", m123("0,0,0,0,0,0,0,{}").replace("300.0,2000.0\n", "300.0,2000.0,0.005\n")),
        ("MAT_PLASTICITY_WITH_DAMAGE", "NUMINT", m123("0,0,0,0,0.005,0,0,{}", word="MAT_PLASTICITY_WITH_DAMAGE").replace("300.0,2000.0\n", "300.0,2000.0,0.004\n")),
        ("MAT_JOHNSON_COOK", "NUMINT", f"*MAT_JOHNSON_COOK\n1,{DENSITY!r},{SHEAR!r},{E_NU}\n300.0,0,1.0,0,1.0,1e9,300.0,1.0\n0,0,0,0,0.005\n0,0,0,0,{{}}\n"),
        ("MAT_ADD_EROSION", "NUMFIP", elastic(1, DENSITY, YOUNG, POISSON) + "*MAT_ADD_EROSION\n1,0,0,0,0,0,{}\n0,1500.0\n"),
        ("MAT_ADD_DAMAGE_DIEM", "NUMFIP", m24() + curve(17, (-1.0, 0.004), (2.0, 0.004)) + "*MAT_ADD_DAMAGE_DIEM\n1,1,0,0,{}\n0,17\n0,0,0\n"),
        ("MAT_ADD_DAMAGE_GISSMO", "NUMFIP", m24() + curve(17, (-1.0, 0.004), (2.0, 0.004)) + "*MAT_ADD_DAMAGE_GISSMO\n1,,1,0,{}\n17,0,1,1.0\n"))
    for layers, gone in ((1, 1.0), (2, 0.0), (-50, 1.0), (-60, 0.0))
]  # fmt: skip
CONSTANT_RATE = [
    *[Proof(f"{word}: A B C D E F G H; {word}: LCSS C P VP", stretched(m123(second, third, fourth, word), UP, curve(9, (0.0, 300.0), (0.05, 400.0))),
            [(MISES, LAST, value, 4e-3)], why)
      for word, blank in (("MAT_MODIFIED_PIECEWISE_LINEAR_PLASTICITY", ""), ("MAT_PLASTICITY_WITH_DAMAGE", "1e20"))
      for second, third, fourth, value, why in (
          (f"0,0,0,0,{blank or 0}", "0.0,0.05", "300.0,400.0", table_stress(STRAIN), "the table"),
          (f"0,0,9,0,{blank or 0}", "", "", table_stress(STRAIN), "the curve"),
          (f"40.0,5.0,0,0,{blank or 1},1", "0.0,0.05", "300.0,300.0", 300.0 * cowper(RATE / 1.01, 40.0, 5.0), "scaled by the rate"))],
    Proof("MAT_PLASTICITY_WITH_DAMAGE: TDEL",
          stretched(f"*MAT_PLASTICITY_WITH_DAMAGE\n1,{DENSITY!r},{E_NU},300.0,2000.0,0,{1.01 * STEP_OF_CUBE!r}\n0,0,0,0,0.5\n", UP), [("eroded_elements", LAST, 1.0, 0.0)], "the element allows less than TDEL"),
    Proof("MAT_ELASTIC_PLASTIC_HYDRO: A B C D E F G H",
          state_cube(f"*MAT_ELASTIC_PLASTIC_HYDRO\n1,{DENSITY!r},{SHEAR!r}\n0.0,0.05\n0\n300.0,400.0\n0\n{STATE}", 1 / UP), [(MISES, LAST, table_stress(STRAIN), 3e-3)], "the table"),
    Proof("MAT_JOHNSON_COOK: D1", state_cube(cook("0.006"), UP, rows=1000), [(erosion_time, LAST, flat(0.006), 1e-2)], "the plastic strain reaches D1"),
    Proof("MAT_JOHNSON_COOK: D4", state_cube(cook("0.004,0,0,0.2"), UP, rows=1000), [(erosion_time, LAST, flat(0.004 * (1 + 0.2 * math.log(2 / 3 * RATE / 1.01))), 2e-2)], "D1 (1 + D4 ln rate)"),
    Proof("MAT_JOHNSON_COOK: D2", state_cube(cook("0.002,0.004,0"), UP, rows=1000), [(erosion_time, LAST, flat(0.006), 1e-2)], "D1 + D2 exp(0)"),
    Proof("MAT_JOHNSON_COOK: D5", state_cube(HOT, UP, rows=1000), [(erosion_time, LAST, flat(math.expm1(0.006 * 1000.0 * HEATING) / (1000.0 * HEATING)), 2e-2)],
          "the work p 300 / (rho CP) heats, and damage grows by dp / (D1 (1 + D5 T)), T over the 1000 degrees to TM: it is complete at ln(1 + D5 c p) / (D1 D5 c) = 1"),
    Proof("MAT_JOHNSON_COOK: EFMIN", state_cube(cook("0.006", "0,0,0,0.008"), UP, rows=1000), [(erosion_time, LAST, flat(0.008), 1e-2)], "not below EFMIN"),
    Proof("MAT_JOHNSON_COOK: EFMIN", state_cube(cook("0.002,0.004,1.5", "0,0,0,0.008"), UP), refused="EFMIN"),
    Proof("MAT_JOHNSON_COOK: D3", state_cube(cook("0.002,0.004,-1.5"), UP), refused="D3"),
    Proof("MAT_JOHNSON_COOK: EROD", state_cube(cook("0.006", "0,0,1"), UP), refused="not eroded"),
    Proof("MAT_JOHNSON_COOK: PC", state_cube(cook("0.006").replace("\n0,0,0,0,0.006", "\n0,-900.0,0,0,0.006"), UP), refused="tension cutoff"),
    Proof("MAT_JOHNSON_COOK: DTF", state_cube(f"*MAT_JOHNSON_COOK\n1,{DENSITY!r},{SHEAR!r},0,0,{1.01 * STEP_OF_CUBE!r}\n300.0\n0\n0\n*EOS_LINEAR_POLYNOMIAL\n1,0,{BULK!r}\n0,1\n", UP),
          [("eroded_elements", LAST, 1.0, 0.0)], "the element allows less than DTF"),
    Proof("EOS_LINEAR_POLYNOMIAL: C6", state_cube(f"*MAT_NULL\n1,{DENSITY!r}\n*EOS_LINEAR_POLYNOMIAL\n1,0,{BULK!r},0,0,0,0,300.0\n50.0,1.0\n", 1 / UP),
          [(lambda h: h[PRESSURE][-1] / (BULK * (UP - 1) + 300.0 * (UP - 1) ** 2 * (50.0 + BULK * (UP - 1) ** 2 / 2 / UP)), LAST, 1.0, 1e-2)], "C6 mu^2 E"),
    Proof("EOS_GRUNEISEN: E0", state_cube(f"*MAT_NULL\n1,{DENSITY!r}\n*EOS_GRUNEISEN\n1,4.6e6,0,0,0,2.0,0,50.0\n1.0\n", 1.0001),
          [(PRESSURE, LAST, 2.0 * 50.0 - DENSITY * 4.6e6**2 * 1e-4, 3e-2)], "GAMMA0 E0, less rho c^2 mu"),
    Proof("EOS_IDEAL_GAS: EOSID CV CP T0 V0", state_cube(f"*MAT_NULL\n1,{DENSITY!r}\n*EOS_IDEAL_GAS\n1,7e8,1e9,0,0,300.0\n", 0.9),
          [(PRESSURE, LAST, 3e8 * DENSITY * 300.0 * 0.9 ** (-10 / 7), 3e-3)], "(CP - CV) rho T0, compressed without loss of heat"),
    Proof("EOS_IDEAL_GAS: CL CQ VC0", state_cube(f"*MAT_NULL\n1,{DENSITY!r}\n*EOS_IDEAL_GAS\n1,7e8,1e9,0.1,0,300.0\n", 0.9), refused="CL"),
    Proof("EOS_IDEAL_GAS: ADIAB", state_cube(f"*MAT_NULL\n1,{DENSITY!r}\n*EOS_IDEAL_GAS\n1,7e8,1e9,0,0,300.0\n1\n", 0.9), refused="ADIAB"),
    Proof("EOS_GRUNEISEN: A S2 S3", state_cube(f"*MAT_NULL\n1,{DENSITY!r}\n*EOS_GRUNEISEN\n1,4.6e6,1.5,8.0,9.0,2.0,300.0,50.0\n1.0\n", 1 / UP),
          [(lambda h: h[PRESSURE][-1] / follow_adiabat(steinberg, 50.0), LAST, 1.0, 1e-2)],
          "the published pressure over mu; the energy by the work of compression"),
    Proof("EOS_TABULATED: EOSID GAMA E0 V0 " + " ".join(f"{name}{i}" for name in ("EV", "C", "T") for i in range(1, 11)),
          state_cube(f"*MAT_NULL\n1,{DENSITY!r}\n*EOS_TABULATED\n1,0.5,50.0,1.0\n" + TABLES, 1 / UP),
          [(lambda h: h[PRESSURE][-1] / follow_adiabat(tabulated, 50.0), LAST, 1.0, 2e-3)], "C + GAMA T E at ln(V), between two rows"),
    Proof("EOS_TABULATED: LCC", state_cube(f"*MAT_NULL\n1,{DENSITY!r}\n*EOS_TABULATED\n1,0,0,1.0,21\n", UP, curve(21, (0.0, 0.0))), refused="must have two values of C"),
    Proof("EOS_TABULATED: LCC LCT",
          state_cube(f"*MAT_NULL\n1,{DENSITY!r}\n*EOS_TABULATED\n1,0.5,50.0,1.0,21,22\n", 1 / UP,
                     curve(21, (-2 * STRAIN, 3000.0), (0.0, 0.0), (0.1, -2e4)) + curve(22, (-2 * STRAIN, 0.8), (0.0, 1.0))),
          [(lambda h: h[PRESSURE][-1] / follow_adiabat(tabulated, 50.0), LAST, 1.0, 2e-3)], "the curves, over ln(V)"),
    Proof("EOS_TABULATED: LCC", state_cube(f"*MAT_NULL\n1,{DENSITY!r}\n*EOS_TABULATED\n1,0.5,50.0,1.0,21\n", UP, curve(21, (-0.1, -3e4), (0.0, 0.0), (0.1, 2e4))),
          refused="falls over ln"),
    Proof("EOS_TABULATED: V0", state_cube(f"*MAT_NULL\n1,{DENSITY!r}\n*EOS_TABULATED\n1,0.5,50.0,0.9\n" + TABLES, UP), refused="initial relative volume"),
    Proof("EOS_GRUNEISEN: V0", state_cube(f"*MAT_NULL\n1,{DENSITY!r}\n*EOS_GRUNEISEN\n1,4.6e6,1.5,0,0,2.0\n0.9\n", UP), refused="initial relative volume"),
    Proof("MAT_SOIL_AND_FOAM: PC", stretched(f"*MAT_SOIL_AND_FOAM\n1,{DENSITY!r},800.0,2000.0,12.0,0,0,-7.0\n0\n0.0,-0.1\n\n0.0,30.0\n\n", UP),
          [(PRESSURE, LAST, -7.0, 2e-2)], "the tension stays at PC"),
    Proof("MAT_SOIL_AND_FOAM_FAILURE: PC", stretched(f"*MAT_SOIL_AND_FOAM_FAILURE\n1,{DENSITY!r},800.0,2000.0,12.0,0,0,-7.0\n0\n0.0,-0.1\n\n0.0,30.0\n\n", UP),
          [(PRESSURE, LAST, -7.0, 2e-2)], "the tension stays at PC"),
    Proof("MAT_SOIL_AND_FOAM_FAILURE: LCID", stretched(f"*MAT_SOIL_AND_FOAM_FAILURE\n1,{DENSITY!r},800.0,2000.0,12.0,0,0,0\n0,0,9\n", math.exp(-0.05), curve(9, (-0.1, 30.0), (0.0, 0.0))),
          [(PRESSURE, LAST, 15.0, 3e-3)], "half of the curve"),
    Proof("MAT_SOIL_AND_FOAM_FAILURE: MID RO G BULK A0 A B C D E F G H I J", stretched(f"*MAT_SOIL_AND_FOAM_FAILURE\n1,{DENSITY!r},800.0,2000.0,12.0,0,0,0\n0\n0.0,-0.1\n\n0.0,30.0\n\n", math.exp(-0.05)),
          [(PRESSURE, LAST, 15.0, 3e-3)], "half of the curve"),
    Proof("MAT_LOW_DENSITY_FOAM: HU SHAPE DAMP BVFLAG",
          stretched(f"*MAT_LOW_DENSITY_FOAM\n1,{DENSITY!r},20.0,9,0,0.2,0,0.1\n2.0\n", 0, FOAM, path=((0.0, 0.0), (END / 2, -3.5), (END, 0.0))),
          [(lambda h: max(abs(s) for s, t in zip(h[ZZ], h["time"]) if t > 0.95 * END), LAST, 0.0, 0.2)], "without stress again at its height; DAMP is a viscosity, and does nothing here"),
    Proof("MAT_LOW_DENSITY_FOAM: TC", stretched(f"*MAT_LOW_DENSITY_FOAM\n1,{DENSITY!r},20.0,9,0.5,0.2\n2.0\n", 1.3, FOAM), [(ZZ, LAST, 0.5, 5e-3)], "E times the strain is 6, above TC"),
    Proof("MAT_LOW_DENSITY_FOAM: FAIL", stretched(f"*MAT_LOW_DENSITY_FOAM\n1,{DENSITY!r},20.0,9,0.5\n1.0,1\n", 1.3, FOAM), [(ZZ, LAST, 0.0, 1e-2)], "no tension after TC"),
    Proof("MAT_LOW_DENSITY_FOAM: TC E", stretched(f"*MAT_LOW_DENSITY_FOAM\n1,{DENSITY!r},20.0,9,0.5\n1.0\n", 0.65, FOAM), [(ZZ, LAST, -2.5, 5e-3)], "the curve in compression, as without TC"),
    Proof("MAT_LOW_DENSITY_FOAM: TC FAIL", stretched(f"*MAT_LOW_DENSITY_FOAM\n1,{DENSITY!r},20.0,9,0.5\n1.0,2\n", 0.65, FOAM), refused="FAIL"),
    Proof("MAT_CRUSHABLE_FOAM: DAMP PR TSC", stretched(f"*MAT_CRUSHABLE_FOAM\n1,{DENSITY!r},2000.0,0.2,9,3.0,0.1\n", 0.65, FOAM),
          [(ZZ, LAST, -(2.0 + 0.25 / 0.5), 5e-3)], "the curve at 1 - V = 0.35: Poisson's ratio, the limit of tension and a viscosity do nothing in slow compression"),
    *[Proof("MAT_CRUSHABLE_FOAM: TSC", stretched(f"*MAT_CRUSHABLE_FOAM\n1,{DENSITY!r},2000.0,0.0,9,{limit!r}\n", 0.7, FOAM, path=((0.0, 0.0), (END / 2, -3.0), (END, 10.0 * (0.7 * back - 1)))),
            [(ZZ, LAST, stress, 2e-2)], "crushed to 1 - V = 0.3, where the curve has 2.4, and pulled back: elastic, up to TSC")
      for limit, back, stress in ((0.1, math.exp(0.0005), -2.4 + 2000.0 * 0.0005), (0.1, 1.03, 0.1), (0.0, 1.03, 0.0))],
    Proof("MAT_ADD_EROSION: EXCL", eroding("0", "0,3000.0").replace("*MAT_ADD_EROSION\n1,0,", "*MAT_ADD_EROSION\n1,3000.0,"), [(ZZ, LAST, STIFF * STRAIN / UP, 3e-3)],
          "a limit of EXCL is none"),
    Proof("MAT_ADD_EROSION: NCS", eroding("0,0,0,0,1.0,2.0", "0,3000.0,0,0.012"), refused="NCS"),
    Proof("MAT_ELASTIC: DA DB", stretched(f"*MAT_ELASTIC\n1,{DENSITY!r},{E_NU},0.1,0.1\n", 1.001), [(ZZ, LAST, STIFF * 0.001, 2e-3)], "damping of beams, which solids do not have"),
    Proof("MAT_HIGH_EXPLOSIVE_BURN: BETA", deck(cube("*MAT_HIGH_EXPLOSIVE_BURN\n1,1.6e-9,7.0e6,2e4,1\n*EOS_JWL\n1,371000.0,3230.0,4.15,0.95,0.3,7000.0,1.0\n").replace("part_1\n1,1,1\n", "part_1\n1,1,1,1\n"),
          "*INITIAL_DETONATION\n1,0,0,5.0,0\n"), refused="BETA"),
    Proof("MAT_RIGID: COUPLE", deck(cube("*MAT_RIGID\n1,7.8e-9,2.1e5,0.3,0,2\n0\n\n")), refused="COUPLE"),
]  # fmt: skip

PROOFS = METALS + STATES + SOFT + HONEYCOMBS + EROSION + LAYERS + CONSTANT_RATE

NOT_PHYSICS = {"MAT_ADD_DAMAGE_DIEM.DEPS": "how often the damage is advanced: percuss does so in each step"}
