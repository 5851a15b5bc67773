// Fields of user code: what VGETVRM tells, and what VUSDFLD leaves.

#include "kernels/material/user/user_fields.hpp"

#include <cmath>
#include <cstddef>

#include <gtest/gtest.h>

#include "kernels/material/laws/neo_hookean.hpp"
#include "kernels/material/user/export_law.hpp"
#include "kernels/material/user/library_law.hpp"
#include "kernels/material/user/user_law.hpp"
#include "tests/kernels/material/samples.hpp"

namespace percuss::test::user_fields_test {
namespace {

/// What a user would bring: St. Venant and Kirchhoff's law as a VUMAT, of the increments of strain. PROPS: lambda, mu;
/// STATEV: strain along x, which only grows.
void sample_vumat(const int* points, const int*, const int*, const int*, const int*, const int*, const int*,
                  const double*, const double*, const double*, const char*, const double*, const double*,
                  const double* constant, const double*, const double* strain, const double*, const double*,
                  const double*, const double*, const double*, const double* stress_old, const double* state_old,
                  const double*, const double*, const double*, const double*, const double*, const double*,
                  double* stress_new, double* state_new, double*, double*, std::size_t) {
  const int n = *points;
  for (int i = 0; i < n; ++i) {
    const double volume = strain[i] + strain[n + i] + strain[2 * n + i];
    for (int k = 0; k < 6; ++k)
      stress_new[k * n + i] =
          stress_old[k * n + i] + (k < 3 ? constant[0] * volume : 0) + 2 * constant[1] * strain[k * n + i];
    state_new[i] = state_old[i] + (strain[i] > 0 ? strain[i] : 0);
  }
}

UserLaw make_user_law() {
  static int outside = 0;
  UserLaw law;
  law.code = {sample_vumat, sample_density, &outside};
  law.constants = {2, {6e9, 4e9}};
  law.states = 1;
  return law;
}

LibraryLaw make_library_law() {
  static const LawLibrary library = ExportedLaw<NeoHookean>::list();
  static const NeoHookean law{3e6, 0.4};
  static int outside = 0;
  return {{&library, &law, &outside}};
}

[[maybe_unused]] const bool has_samples =
    provide_sample<UserLaw>(make_user_law()) && provide_sample<LibraryLaw>(make_library_law());

/// ln U of principal stretches 0.5, 1.25 and 3 along axes that are turned by 0.4 about z and then by 0.9 about x:
/// the sum of ln(u) n n over them (Ogden, Non-Linear Elastic Deformations, section 2.2.7).
TEST(UserFields, LogarithmOfAStretchIsThatOfItsPrincipalStretches) {
  const double c = std::cos(0.4), s = std::sin(0.4), d = std::cos(0.9), t = std::sin(0.9);
  const double n[3][3] = {{c, d * s, t * s}, {-s, d * c, t * c}, {0, -t, d}}, stretch[3] = {0.5, 1.25, 3};
  double u[3][3] = {}, log_u[3][3] = {};
  for (int i = 0; i < 3; ++i) {
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) {
        u[a][b] += stretch[i] * n[i][a] * n[i][b];
        log_u[a][b] += std::log(stretch[i]) * n[i][a] * n[i][b];
      }
    }
  }
  const Symmetric3<double> e = find_logarithm(Symmetric3<double>{u[0][0], u[1][1], u[2][2], u[0][1], u[1][2], u[2][0]});
  EXPECT_NEAR(e.xx, log_u[0][0], 1e-14);
  EXPECT_NEAR(e.yy, log_u[1][1], 1e-14);
  EXPECT_NEAR(e.zz, log_u[2][2], 1e-14);
  EXPECT_NEAR(e.xy, log_u[0][1], 1e-14);
  EXPECT_NEAR(e.yz, log_u[1][2], 1e-14);
  EXPECT_NEAR(e.zx, log_u[2][0], 1e-14);
}

/// The first field counts steps by a state variable, which it doubles; the second is the first of the constants.
void sample_vusdfld(const int* points, const int*, const int*, const int*, const int*, const int*, const int*,
                    const int*, const int*, const int*, const double*, const double*, const double*, const char*,
                    const double*, const double*, const double*, const double*, const double* constant, double*,
                    double* state_new, double* field, std::size_t) {
  const int n = *points;
  for (int i = 0; i < n; ++i) {
    state_new[i] = 2 * state_new[i] + 1;
    field[i] = state_new[i];
    field[n + i] = constant[0];
  }
}

TEST(UserFields, StatesAndFieldsGoFromVusdfldToTheLaw) {
  UserLaw law = sample<UserLaw>();
  law.code.vusdfld = sample_vusdfld;
  law.fields = 2;
  law.field_constants = {1, {7}};
  PointStep<double> step{};
  double history[UserLaw::history_count] = {};
  law.start(history);
  step.history = history;
  step.density = sample_density;
  for (const double right : {1.0, 3.0, 7.0}) {
    step.motion.dt = 1e-6;
    step.motion.volume_ratio = 1;
    step.motion.change = {0, 1};
    law.update(step);
    EXPECT_EQ(history[law.first_state()], right);  // the sample law adds the strain, which is 0
    EXPECT_EQ(history[law.first_field()], right);
    EXPECT_EQ(history[law.first_field() + 1], 7);
  }
  EXPECT_EQ(asked_points, nullptr);
}

}  // namespace
}  // namespace percuss::test::user_fields_test
