#include "kernels/element/hex8/plastic_bending.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/kernels/element/random_element.hpp"

namespace percuss::test::plastic_bending_test {
namespace {

/// Axial force and moment of a plate over their limits.
struct Section {
  double n = 0, m = 0;
};

/// The steady state of an ideally plastic plate that is stretched by `ratio` times what bending strains its surface;
/// steps of `size` elastic limits. along: whether the stress of bending is along that of the centre, or across it.
Section flow_steadily(double ratio, bool along, double size) {
  Section s;
  for (int i = 0; i < static_cast<int>(100 / size); ++i) {
    const double n = s.n + ratio * size, share = n > 1 ? 1 / n : 1;
    const double m = s.m + (n > 1 ? 0.1 : 1) * 2.0 / 3 * size;  // rate_share() of the element
    const double loading = share * share * n * n;
    const SectionState<double> state{{}, {share, 1, loading}, 0};
    const SectionYield<double> yield = return_section(state, along ? m : 0, along ? 0 : m * m);
    s = {share * n * yield.centre, m * (along ? yield.along : yield.across)};
  }
  return s;
}

}  // namespace

TEST(PlasticBending, NeutralAxisSettlesWhereTheStrainsVanish) {
  // Stress changes its sign at ratio * h / 2 from the middle: n = ratio, m = 1 - n^2.
  for (const double ratio : {0.2, 0.5, 0.8}) {
    for (const double size : {0.001, 0.005}) {
      const Section s = flow_steadily(ratio, true, size);
      EXPECT_NEAR(s.n, ratio, 0.02) << ratio << " " << size;  // one step of Newton's method
      EXPECT_NEAR(s.m, 1 - ratio * ratio, 0.02) << ratio << " " << size;
    }
  }
}

TEST(PlasticBending, PlateThatFlowsThroughoutHasLittleMoment) {
  for (const double ratio : {1.5, 4.0}) {
    const Section s = flow_steadily(ratio, true, 0.005);
    EXPECT_NEAR(s.n, 1, 0.01) << ratio;
    EXPECT_LT(s.m, 0.06) << ratio;
  }
}

TEST(PlasticBending, StressesAcrossEachOtherStayOnTheirCircle) {
  for (const double ratio : {0.0, 0.5, 1.0}) {
    const Section s = flow_steadily(ratio, false, 0.01);
    EXPECT_LT(s.n * s.n + s.m * s.m, 1.01) << ratio;
    EXPECT_GT(s.n * s.n + s.m * s.m, 0.9) << ratio;
  }
  EXPECT_NEAR(flow_steadily(0, false, 0.01).m, 1, 1e-3);
}

TEST(PlasticBending, BentCubeHasTheLimitMomentOfAPlateStrip) {
  // Plane strain: a moment of (2 / sqrt(3)) Y h^2 / 4 for a unit of width, and a mean plastic strain of k h / (2
  // sqrt(3)).
  for (const double poisson : {0.0, 0.3, 0.49}) {
    const double young = 1, yield = 1e-3, step = 1e-6, curvature = 0.04;
    const J2Plasticity law = J2Plasticity::make({young, poisson, yield, 0});
    const SolidParameters<J2Plasticity> par{law, law.lambda, law.mu, 0, {0, 0}};
    Random random(1);
    const Corners cube = make_element(random, 1, 1, 1, 0);
    Corners bending{};
    for (int i = 0; i < 8; ++i) bending.x[i] = cube.x[i] * cube.z[i];
    auto state = make_state<J2Plasticity, HexKind::assumed_strain>(1.0);
    const VectorModes<double> a = find_modes(cube), v = find_modes(bending);
    double work = 0, moment = 0;
    for (int i = 0; i < static_cast<int>(curvature / (20 * step)); ++i) {
      Corners f{};
      advance_hex8(par, a, v, 20 * step, state, {f.x, f.y, f.z});
      moment = 0;
      for (int k = 0; k < 8; ++k) moment += f.x[k] * bending.x[k];
      work += moment * 20 * step;
    }
    const double limit = yield / (2 * std::sqrt(3.0));
    EXPECT_NEAR(moment / limit, 1, 0.01) << poisson;
    EXPECT_GT(work, 0);
    EXPECT_LT(norm(Vector3<double>{state.stress.xx, state.stress.yy, state.stress.zz}), 1e-6 * yield) << poisson;
    const double elastic = limit / (young / (1 - poisson * poisson) / 12);
    EXPECT_NEAR(state.history.value[0][0] / ((curvature - elastic) / (2 * std::sqrt(3.0))), 1, 0.05) << poisson;
  }
}

}  // namespace percuss::test::plastic_bending_test
