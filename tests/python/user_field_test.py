"""Fields that code of users sets (field_variables: VUSDFLD and VGETVRM) beside a VUMAT or a VUHARD: user_field_test.py ROOT PERCUSS [MPIEXEC ...].

Exit code 77 (skipped) without a compiler of Fortran or without NumPy.
"""

import math
import unittest

from law_runs import EXAMPLE, UNIAXIAL, LawTest, need, np, write_cube

need("gfortran")

FIELDS = """
      subroutine vusdfld(
     1  nblock, nstatev, nfieldv, nprops, ndir, nshr,
     2  jElemUid, kIntPt, kLayer, kSecPt,
     3  stepTime, totalTime, dt, cmname,
     4  coordMp, direct, T, charLength, props,
     5  stateOld, stateNew, field)
      include 'vaba_param.inc'
      dimension props(nprops), jElemUid(nblock), coordMp(nblock,*),
     1  direct(nblock,3,3), T(nblock,3,3), charLength(nblock),
     2  stateOld(nblock,nstatev), stateNew(nblock,nstatev),
     3  field(nblock,nfieldv)
      character*80 cmname
      character*3 cData(maxblk*6)
      dimension rData(nblock,6), jData(maxblk*6)
      BODY
      return
      end
"""
# Elastic with lambda and mu, times 1 minus the first field if there is one.
LAW = """
      subroutine vumat(
     1  nblock, ndir, nshr, nstatev, nfieldv, nprops, lanneal,
     2  stepTime, totalTime, dt, cmname, coordMp, charLength,
     3  props, density, strainInc, relSpinInc,
     4  tempOld, stretchOld, defgradOld, fieldOld,
     5  stressOld, stateOld, enerInternOld, enerInelasOld,
     6  tempNew, stretchNew, defgradNew, fieldNew,
     7  stressNew, stateNew, enerInternNew, enerInelasNew)
      include 'vaba_param.inc'
      dimension props(nprops), strainInc(nblock,6),
     1  fieldOld(nblock,nfieldv), fieldNew(nblock,nfieldv),
     2  stressOld(nblock,6), stateOld(nblock,nstatev),
     3  stressNew(nblock,6), stateNew(nblock,nstatev)
      character*80 cmname
      do k = 1, nblock
        f = 1.d0
        if (nfieldv .gt. 0) f = 1.d0 - fieldNew(k,1)
        tr = strainInc(k,1) + strainInc(k,2) + strainInc(k,3)
        do i = 1, 6
          a = 2.d0 * props(2) * strainInc(k,i)
          if (i .le. 3) a = a + props(1) * tr
          stressNew(k,i) = stressOld(k,i) + f * a
        end do
        BODY
      end do
      return
      end
"""
# A yield stress of props(1) times 1 minus the first field.
HARDENING = """
      subroutine vuhard(
     1  nblock, jElem, kIntPt, kLayer, kSecPt,
     2  lAnneal, stepTime, totalTime, dt, cmname,
     3  nstatev, nfieldv, nprops,
     4  props, tempOld, tempNew, fieldOld, fieldNew,
     5  stateOld, eqps, eqpsRate,
     6  yield, dyieldDtemp, dyieldDeqps, stateNew)
      include 'vaba_param.inc'
      dimension props(nprops), fieldOld(nblock,nfieldv),
     1  fieldNew(nblock,nfieldv), eqps(nblock), yield(nblock),
     2  dyieldDtemp(nblock), dyieldDeqps(nblock,2),
     3  stateOld(nblock,nstatev), stateNew(nblock,nstatev)
      character*80 cmname
      do k = 1, nblock
        yield(k) = props(1) * (1.d0 - fieldNew(k,1))
        dyieldDtemp(k) = 0.d0
        dyieldDeqps(k,1) = 0.d0
        dyieldDeqps(k,2) = 0.d0
      end do
      return
      end
"""
LAMBDA, MU = 2e9, 1e9
STIFFNESS = LAMBDA + 2 * MU
GET = "jStatus = 1\n      call vgetvrm('{}', rData, jData, cData, jStatus)\n      "
# The stiffness falls with the strain along x, which the second state variable adds up where it grows; the first one deletes beyond props(2).
DAMAGE = GET.format("LE") + """
      do k = 1, nblock
        stateNew(k,2) = max(stateOld(k,2), rData(k,1))
        if (stateNew(k,2) .gt. props(2)) stateNew(k,1) = 0.d0
        field(k,1) = min(stateNew(k,2) / props(1), 1.d0)
      end do
"""


def user(more="", fields=1):
    return f"model: user, density: 1600, vumat: law.so, constants: [{LAMBDA}, {MU}], field_variables: {fields}{more}"


def hard(more=""):
    return f"model: user_hardening, density: 7850, youngs_modulus: 200e9, poissons_ratio: 0.3, vuhard: law.so, constants: [3e8], field_variables: 1{more}"


SOFTENING = ", state_variables: 2, delete_variable: 1, field_constants: [0.2, 0.1]"


def shoot(law):
    """A cube of 4 x 4 x 4 elements that is held at one side and moves at the other."""
    more = "initial: [{nodes: cube/x_max, velocity: [100, 10, 0]}]\n"
    return write_cube(law, 2e-3, ["{nodes: cube/x_min, fixed: [x, y, z]}"], cells=4, more=more)


class UserFields(LawTest):
    def compile(self, fields, law=LAW, body=""):
        source = self.write("law.f", law.replace("BODY", body) + (FIELDS.replace("BODY", fields) if fields else ""))
        self.compile_file(source, "-O1", "-ffixed-line-length-none", "-I", EXAMPLE, compiler="gfortran")

    def test_stiffness_falls_with_the_strain_and_deletes(self):
        # ds = (lambda + 2 mu) (1 - e / 0.2) de up to a strain of 0.1, where the point is deleted.
        self.compile(DAMAGE)
        rows, _ = self.run_deck(write_cube(user(SOFTENING), 2e-3, UNIAXIAL), "--set", "time.max_step=2e-6")
        e = np.log(1 + 100 * rows["time"])
        exact = STIFFNESS * (e - e * e / 0.4)
        alive = rows["all_stress_xx"] != 0
        last = np.max(np.nonzero(alive))
        self.assertLess(abs(e[last] - 0.1), 1e-3)
        np.testing.assert_allclose(rows["all_stress_xx"][alive], exact[alive], rtol=0, atol=2e-3 * np.max(exact[alive]))
        np.testing.assert_allclose(rows["all_state_2"][1 : last + 1], e[:last], rtol=0, atol=1e-9)  # at the start of the step

    def test_fields_and_states_are_kept_over_ranks_and_restarts(self):
        # The field of the step before softens, too, so that it must be kept.
        self.compile(DAMAGE, body="if (nfieldv .gt. 0) stressNew(k,2) = stressNew(k,2) * (1.d0 - 0.01d0 * fieldOld(k,1))")
        self.check_bits(shoot(user(SOFTENING)))
        # A VUHARD sees the strain since the start and the field: LE, and a field that VUSDFLD adds up in a state variable.
        self.compile(DAMAGE, law=HARDENING.replace("fieldNew(k,1))", "fieldOld(k,1))"))
        self.check_bits(shoot(hard(SOFTENING)))

    def test_vgetvrm_tells_strain_and_stress_by_the_axes_that_turn(self):
        # Simple shear of F = 1 + g ex ez: U of the polar decomposition, its logarithm by NumPy; axes 1, 2 in the plane of x and z at 30 degrees.
        self.compile(GET.format("LE") + """
      do k = 1, nblock
        do i = 1, 6
          stateNew(k,i) = rData(k,i)
        end do
      end do
      call vgetvrm('s', rData, jData, cData, jStatus)
      do k = 1, nblock
        do i = 1, 6
          stateNew(k,6+i) = rData(k,i)
        end do
      end do
      """, body="do i = 1, 6\n          stateNew(k,12+i) = stressOld(k,i)\n        end do")
        c, s = math.cos(math.radians(30)), math.sin(math.radians(30))
        motion = ["{nodes: cube/z_min, fixed: [x, y, z]}", "{nodes: cube/z_max, velocity: {x: 500, y: 0, z: 0}}"]
        law = user(f", state_variables: 18, first_axis: [{c}, 0, {s}], second_axis: [{-s}, 0, {c}]")
        rows, _ = self.run_deck(write_cube(law, 2e-3, motion), "--set", "time.max_step=1e-6")
        f = np.eye(3)
        f[0, 2] = 500 * rows["time"][-2]
        self.assertGreater(f[0, 2], 0.9)
        values, vectors = np.linalg.eigh(f.T @ f)
        strain = vectors @ np.diag(0.5 * np.log(values)) @ vectors.T
        axes = np.array([[c, 0, s], [-s, 0, c], [0, -1, 0]])
        own = axes @ strain @ axes.T
        for i, (a, b) in enumerate(((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0)), 1):
            self.assertLess(abs(rows[f"all_state_{i}"][-1] - own[a, b]), 1e-3, (i, own))
            self.assertEqual(rows[f"all_state_{6 + i}"][-1], rows[f"all_state_{12 + i}"][-1])
        self.assertGreater(abs(own[0, 1]), 0.1)

    def test_what_the_code_gets(self):
        # Elements, places, axes, lengths, temperature, constants, fields of the step before, and state variables of VUSDFLD in the VUMAT.
        self.compile(GET.format("TEMP") + """
      do k = 1, nblock
        stateNew(k,1) = jElemUid(k)
        stateNew(k,2) = coordMp(k,1) + 10.d0*coordMp(k,2) + 100.d0*coordMp(k,3)
        stateNew(k,3) = direct(k,2,1) + 10.d0*direct(k,3,2) + 100.d0*direct(k,1,3) + 1000.d0*T(k,3,3)
        stateNew(k,4) = charLength(k)
        stateNew(k,5) = rData(k,1) + jStatus
        stateNew(k,6) = props(2) + nprops + nfieldv + ndir + nshr
        stateNew(k,7) = stateOld(k,7) + 1.d0
        field(k,1) = 0.d0
        field(k,2) = field(k,2) + stateNew(k,7)
      end do
      """, body="stateNew(k,8) = stateOld(k,7) + 1000.d0 * fieldOld(k,2) + 1000000.d0 * fieldNew(k,2)")
        law = user(", state_variables: 8, field_constants: [1, 70], start_temperature: 20, first_axis: [0, 1, 0], second_axis: [0, 0, 1]", fields=2)
        deck = write_cube(law, 1e-3, UNIAXIAL, cells=2).replace("id: 1", "id: 5").replace("size: [1, 1, 1]", "size: [1, 2, 4]")
        rows, _ = self.run_deck(deck, "--set", "time.max_steps=7", "--set", "time.max_step=1e-6")
        got = [round(float(rows[f"all_state_{i}"][-1]), 6) for i in range(1, 9)]
        self.assertEqual(got[0], 5.0)
        self.assertLess(abs(got[1] - (0.25 + 10 * 0.5 + 100 * 3.0)), 1e-3)  # the fifth of eight cubes lies in the upper half, and hardly moves
        self.assertEqual(got[2], 1 + 10 + 100 + 1000)
        self.assertLess(abs(got[3] - 1.0), 1e-3)
        self.assertEqual(got[4:7], [20.0, 70.0 + 2 + 2 + 3 + 3, 7.0])
        self.assertEqual(got[7], 7 + 6000 + 7000000)

    def test_other_quantities_are_refused_by_name(self):
        self.compile(GET.format("EVF") + "do k = 1, nblock\n        field(k,1) = 0.d0\n        stateNew(k,1) = jStatus\n      end do\n")
        done = self.call(write_cube(user(", state_variables: 1"), 1e-3, UNIAXIAL), "--quiet", "--force", "--out", "out")
        self.assertEqual((done.returncode, done.stderr.count("VGETVRM has no EVF here")), (0, 1), done.stderr)
        # PEEQ is that of a VUHARD, and outside of VUSDFLD there is nothing.
        self.compile(GET.format("PEEQ") + "if (jStatus .ne. 0) call xplb_exit\n")
        done = self.call(write_cube(user(), 1e-3, UNIAXIAL), "--quiet", "--force", "--out", "out")
        self.assertEqual((done.returncode, "VGETVRM has no PEEQ here" in done.stderr, "XPLB_EXIT" in done.stderr), (3, True, True), done.stderr)
        self.compile("", body="call vgetvrm('S', strainInc, lanneal, cmname, jStatus)")
        done = self.call(write_cube(user(fields=0), 1e-3, UNIAXIAL), "--quiet", "--force", "--out", "out")
        self.assertEqual((done.returncode, done.stderr.count("answers in a VUSDFLD alone")), (0, 1), done.stderr)

    def test_yield_falls_with_the_plastic_strain_and_deletes(self):
        # Uniaxial strain: the flow stress is 3e8 (1 - p / 0.2), and the point is deleted at p = 0.05. LE is that of the motion.
        body = GET.format("PEEQ") + """
      do k = 1, nblock
        field(k,1) = min(rData(k,1) / 0.2d0, 0.9d0)
        stateNew(k,2) = rData(k,1)
        if (rData(k,1) .gt. 0.05d0) stateNew(k,1) = 0.d0
      end do
      call vgetvrm('LE', rData, jData, cData, jStatus)
      do k = 1, nblock
        stateNew(k,3) = rData(k,1)
      end do
"""
        self.compile(body, law=HARDENING)
        rows, _ = self.run_deck(write_cube(hard(", state_variables: 3, delete_variable: 1"), 2e-3, UNIAXIAL), "--set", "time.max_step=2e-6")
        alive = rows["all_stress_xx"] != 0
        flows = alive & (rows["all_eps"] > 1e-3)
        last = np.max(np.nonzero(alive))
        self.assertLess(abs(rows["all_eps"][last] - 0.05), 1e-3)
        np.testing.assert_allclose(rows["all_von_mises"][flows], 3e8 * (1 - rows["all_eps"][flows] / 0.2), rtol=0, atol=2e6)
        np.testing.assert_allclose(rows["all_state_3"][1 : last + 1], np.log(1 + 100 * rows["time"][:last]), rtol=0, atol=1e-9)

    def test_wrong_decks_and_code_are_refused(self):
        self.compile("")
        done = self.call(write_cube(user(), 1e-3, UNIAXIAL), command="check")
        self.assertEqual((done.returncode, "deck.yaml:3" in done.stderr, "it has no entry vusdfld_" in done.stderr), (2, True, True), done.stderr)
        done = self.call(write_cube(user(", field_constants: [1]", fields=0), 1e-3, UNIAXIAL), command="check")
        self.assertEqual((done.returncode, "field_constants and no field_variables" in done.stderr), (2, True), done.stderr)
        done = self.call(write_cube(user(fields=17), 1e-3, UNIAXIAL), command="check")
        self.assertEqual((done.returncode, "at most 16" in done.stderr), (2, True), done.stderr)
        for body in ("field(1,nfieldv+1) = 1.d0", "stateNew(1,nstatev+1) = 1.d0"):
            self.compile(body)
            done = self.call(write_cube(user(), 1e-3, UNIAXIAL), command="check")
            self.assertEqual((done.returncode, "writes outside its arrays" in done.stderr), (2, True), done.stderr)

    def test_a_vusdfld_without_field_variables_is_not_called(self):
        self.compile("call xplb_exit")
        self.run_deck(write_cube(user(fields=0), 1e-4, UNIAXIAL))


if __name__ == "__main__":
    unittest.main()
