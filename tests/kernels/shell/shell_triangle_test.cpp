// Triangles: quadrilaterals whose third corner stands twice.

#include <gtest/gtest.h>

#include <cstring>

#include "tests/kernels/shell/random_shell.hpp"

namespace percuss::test::shell_triangle_test {

namespace {

constexpr double thickness = 0.01;
const ElasticLayer soft{find_plane_elasticity(1e6, 0.25)};

/// Corners in the unit square, so that no angle is below some 15 degrees, turned and moved in space.
ShellCorners make_random_triangle(Random& random) {
  const Vec axis = (1 / std::sqrt(3.0)) * Vec{1, 1, -1};
  const double angle = 3 * random();
  const auto place = [&](double x, double y) {
    return rotate(axis, angle, Vec{x + 0.15 * random(), y + 0.15 * random(), 0}) + Vec{3, -2, 5};
  };
  return make_triangle(place(0, 0), place(1, 0), place(0.4, 0.9));
}

ShellCorners random_triangle_field(Random& random) {
  const auto u = [&] { return random_vector(random, 1); };
  return make_triangle(u(), u(), u());
}

constexpr std::size_t rate_count = sizeof(ShellRates<double>) / sizeof(double);
using RateList = std::array<double, rate_count>;

RateList list_rates(const ShellRates<double>& rates) {
  RateList list;
  std::memcpy(list.data(), &rates, sizeof rates);
  return list;
}

ShellRates<double> find_rates(const ShellCorners& x, const ShellCorners& v, const ShellCorners& w) {
  const auto g = find_shell_geometry(find_differences(x), find_shapes(x));
  const Vec turned[4] = {g.frame * w[0], g.frame * w[1], g.frame * w[2], g.frame * w[3]};
  return find_shell_rates(g, turn(g.frame, find_differences(v)), turned, find_shapes(x));
}

/// Velocity and angular velocity of a point.
struct Field {
  Vec velocity, rotation;
};

/// w = (kxx x^2 + kyy y^2) / 2 + kxy x y, normals stay normals.
Field bend(const Vec& x, double kxx, double kyy, double kxy) {
  return {{0, 0, (kxx * x.x * x.x + kyy * x.y * x.y) / 2 + kxy * x.x * x.y},
          {kxy * x.x + kyy * x.y, -(kxx * x.x + kxy * x.y), 0}};
}

}  // namespace

TEST(ShellTriangle, RigidMotionGivesNoRates) {
  Random random(1);
  for (int trial = 0; trial < 100; ++trial) {
    const ShellCorners x = make_random_triangle(random);
    const Vec velocity = random_vector(random, 1), spin = random_vector(random, 1);
    ShellCorners v;
    for (std::size_t i = 0; i < 4; ++i) v[i] = velocity + cross(spin, x[i]);
    for (const double rate : list_rates(find_rates(x, v, {spin, spin, spin, spin}))) EXPECT_NEAR(rate, 0, 1e-13);
  }
}

TEST(ShellTriangle, TurningAboutItsNormalDrillsAndNothingElse) {
  Random random(2);
  const ShellCorners x = make_random_triangle(random);
  const Vec area = cross(x[1] - x[0], x[2] - x[0]), normal = 1 / norm(area) * area;
  const double turn[3] = {random(), random(), random()};
  auto rates = find_rates(x, {}, make_triangle(turn[0] * normal, turn[1] * normal, turn[2] * normal));
  const double mean = (turn[0] + turn[1] + turn[2]) / 3;
  EXPECT_NEAR(rates.drilling, mean, 1e-14);
  double beyond = 0;  // mean square of what the corners turn beyond the mean, whatever fields say it
  for (const double t : turn) beyond += (t - mean) * (t - mean) / 3;
  EXPECT_NEAR(std::pow(rates.corner_drilling[0], 2) + std::pow(rates.corner_drilling[1], 2), beyond, 1e-14);
  rates.drilling = rates.corner_drilling[0] = rates.corner_drilling[1] = 0;
  for (const double rate : list_rates(rates)) EXPECT_NEAR(rate, 0, 1e-14);
}

TEST(ShellTriangle, CornersDrillAgainstTheirMeanWithALittleStiffness) {
  const ShellCorners x = make_triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  TestShell<ElasticLayer> shell(soft, 3, x, thickness, 1);
  const double dt = 1e-6, stiffness = 0.01 * (1e6 / 2.5) * thickness * 0.5 / 3;  // of each corner, beyond the mean
  const Vec one{0, 0, 1}, none{0, 0, 0};
  const auto result = shell.advance(x, {}, make_triangle(one, -1.0 * one, none), dt);
  const Vec third = shell.moment[2] + shell.moment[3];
  EXPECT_NEAR(shell.moment[0].z / (stiffness * dt), 1, 1e-12);
  EXPECT_NEAR(shell.moment[1].z / (stiffness * dt), -1, 1e-12);
  EXPECT_NEAR(third.z / (stiffness * dt), 0, 1e-12);
  EXPECT_NEAR(result.work.hourglass / (stiffness * dt * dt), 1, 1e-12);  // two corners, half each
}

TEST(ShellTriangle, ParaboloidsGiveTheirCurvatureAndNoShearButWhatTurnsAround) {
  Random random(3);
  for (int trial = 0; trial < 20; ++trial) {
    const auto near = [&](double x, double y) { return Vec{x + 0.2 * random(), y + 0.2 * random(), 0}; };
    const ShellCorners x = make_triangle(near(0, 0), near(1, 0), near(0.4, 1));
    const double kxx = 0.3, kyy = -0.7, kxy = 0.4;
    ShellCorners v, w;
    for (std::size_t i = 0; i < 4; ++i) {
      const Field field = bend(x[i], kxx, kyy, kxy);
      v[i] = field.velocity;
      w[i] = field.rotation;
    }
    const auto rates = find_rates(x, v, w);
    const auto g = find_shell_geometry(find_differences(x), find_shapes(x));
    const double c = g.frame.row[0].x, s = g.frame.row[0].y;
    EXPECT_NEAR(rates.curvature[0], -(c * c * kxx + s * s * kyy + 2 * c * s * kxy), 1e-13);
    EXPECT_NEAR(rates.curvature[1], -(s * s * kxx + c * c * kyy - 2 * c * s * kxy), 1e-13);
    EXPECT_NEAR(rates.curvature[2], -2 * (c * s * (kyy - kxx) + (c * c - s * s) * kxy), 1e-13);
    for (const double shear : {rates.shear[0], rates.shear[1], rates.shear_hourglass[0], rates.shear_hourglass[1]})
      EXPECT_NEAR(shear, 0, 1e-13);
  }
}

TEST(ShellTriangle, ShearOfItsEdgesIsReproducedWhicheverCornerComesFirst) {
  // A field of shear that is constant, and one that turns around the middle: g(x) = a + b e3 x (x - middle), given to
  // the edges by deflections and rotations about the edges' normals alone.
  Random random(4);
  for (int trial = 0; trial < 20; ++trial) {
    const ShellCorners x = make_triangle({0, 0, 0}, {1 + 0.2 * random(), 0.2 * random(), 0}, {0.4, 0.9, 0});
    const Vec a{random(), random(), 0}, middle = (1.0 / 3) * (x[0] + x[1] + x[2]);
    const double b = random();
    ShellCorners w;  // directors' rates beta = w x e3 are the field itself
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec beta = a + b * cross(Vec{0, 0, 1}, x[i] - middle);
      w[i] = cross(Vec{0, 0, 1}, beta);
    }
    for (std::size_t first = 0; first < 3; ++first) {
      const auto at = [&](const ShellCorners& u) {
        return make_triangle(u[first], u[(first + 1) % 3], u[(first + 2) % 3]);
      };
      const ShellCorners corners = at(x);
      const auto rates = find_rates(corners, {}, at(w));
      const auto g = find_shell_geometry(find_differences(corners), find_shapes(corners));
      const Vec shear = transpose_times(g.frame, Vec{rates.shear[0], rates.shear[1], 0});
      EXPECT_NEAR(norm(shear - a), 0, 1e-14);
      EXPECT_NEAR(rates.shear_hourglass[0], b * g.area, 1e-14);  // half of the integral around the edges, 2 b A
    }
  }
}

TEST(ShellTriangle, ForcesAreTheTransposeOfTheRatesAndAddUpToNothing) {
  Random random(5);
  for (int trial = 0; trial < 50; ++trial) {
    const ShellCorners x = make_random_triangle(random), v = random_triangle_field(random),
                       w = random_triangle_field(random);
    RateList list;
    for (double& value : list) value = random();
    ShellRates<double> on;
    std::memcpy(&on, list.data(), sizeof on);
    Vec f[4], m[4];
    find_shell_forces(find_shell_geometry(find_differences(x), find_shapes(x)), on, f, m, find_shapes(x));
    const RateList rates = list_rates(find_rates(x, v, w));
    double power = 0;
    for (std::size_t k = 0; k < rate_count; ++k) power += rates[k] * list[k];
    EXPECT_NEAR(find_power({f[0], f[1], f[2], f[3]}, {m[0], m[1], m[2], m[3]}, v, w), power, 1e-12);
    Vec force{0, 0, 0}, moment{0, 0, 0};
    for (std::size_t i = 0; i < 4; ++i) {
      force = force + f[i];
      moment = moment + m[i] + cross(x[i], f[i]);
    }
    EXPECT_LT(norm(force), 1e-13);
    EXPECT_LT(norm(moment), 1e-12);
  }
}

TEST(ShellTriangle, HasNoModesButRigidOnes) {
  // Rank of the rates over all motions of the three corners: three strains, three curvatures, two shears, what
  // turns around, and three of turning about the normal. Gram and Schmidt over the columns.
  Random random(6);
  const ShellCorners x = make_random_triangle(random);
  std::vector<RateList> basis;
  for (std::size_t j = 0; j < 18; ++j) {
    ShellCorners v{}, w{};
    Vec unit{j % 3 == 0 ? 1.0 : 0, j % 3 == 1 ? 1.0 : 0, j % 3 == 2 ? 1.0 : 0};
    (j < 9 ? v : w)[j / 3 % 3] = unit;
    v[3] = v[2];
    w[3] = w[2];
    RateList column = list_rates(find_rates(x, v, w));
    const auto product = [](const RateList& a, const RateList& b) {
      double sum = 0;
      for (std::size_t k = 0; k < rate_count; ++k) sum += a[k] * b[k];
      return sum;
    };
    for (const RateList& before : basis) {
      const double along = product(column, before);
      for (std::size_t k = 0; k < rate_count; ++k) column[k] -= along * before[k];
    }
    const double size = std::sqrt(product(column, column));
    if (size < 1e-10) continue;
    for (double& value : column) value /= size;
    basis.push_back(column);
  }
  EXPECT_EQ(basis.size(), 12U);
}

namespace {

const Vec patch_nodes[8] = {{0, 0, 0},       {0.24, 0, 0},    {0.24, 0.12, 0}, {0, 0.12, 0},
                            {0.04, 0.02, 0}, {0.18, 0.03, 0}, {0.16, 0.08, 0}, {0.08, 0.08, 0}};
/// The five quadrilaterals of MacNeal and Harder (1985), four of them halved; the middle one stays.
constexpr std::size_t patch_elements[9][4] = {{0, 1, 5, 5}, {0, 5, 4, 4}, {1, 2, 6, 6}, {1, 6, 5, 5}, {2, 3, 6, 6},
                                              {3, 7, 6, 6}, {3, 0, 7, 7}, {0, 4, 7, 7}, {4, 5, 6, 7}};

struct Patch {
  double left_force = 0, left_moment = 0;  // at inner nodes
  double force = 0, moment = 0;            // largest of an element
};

template <class FindField>
Patch load_patch(const FindField& find_field) {
  constexpr double dt = 1e-16;  // so small that the patch keeps its shape
  Vec force[8] = {}, moment[8] = {};
  Patch patch;
  for (const auto& element : patch_elements) {
    ShellCorners x, v, w;
    for (std::size_t i = 0; i < 4; ++i) {
      x[i] = patch_nodes[element[i]];
      const Field field = find_field(x[i]);
      v[i] = field.velocity;
      w[i] = field.rotation;
    }
    TestShell<ElasticLayer> shell(soft, 2, x, 0.001, 1);
    shell.advance(move(x, v, dt), v, w, dt);
    for (std::size_t i = 0; i < 4; ++i) {
      force[element[i]] = force[element[i]] + shell.force[i];
      moment[element[i]] = moment[element[i]] + shell.moment[i];
      patch.force = std::max(patch.force, norm(shell.force[i]));
      patch.moment = std::max(patch.moment, norm(shell.moment[i]));
    }
  }
  for (int n = 4; n < 8; ++n) {
    patch.left_force = std::max(patch.left_force, norm(force[n]));
    patch.left_moment = std::max(patch.left_moment, norm(moment[n]));
  }
  return patch;
}

}  // namespace

TEST(ShellTriangle, MembranePatchIsExactWithAQuadrilateralAmongThem) {
  const Patch patch = load_patch([](const Vec& x) {
    return Field{{1e-3 * (x.x + x.y / 2), 1e-3 * (x.y + x.x / 2), 0}, {0, 0, 0}};
  });
  EXPECT_GT(patch.force, 0);
  EXPECT_LT(patch.left_force, 1e-12 * patch.force);
  EXPECT_LT(patch.left_moment, 1e-12 * patch.force * thickness);
}

TEST(ShellTriangle, BendingAndTwistPatchesAreExactWithAQuadrilateralAmongThem) {
  for (const auto& k :
       {std::array{1.0, 0.0, 0.0}, std::array{0.0, 1.0, 0.0}, std::array{0.0, 0.0, 1.0}, std::array{1.0, 1.0, 0.5}}) {
    const Patch patch = load_patch([&](const Vec& x) { return bend(x, k[0], k[1], k[2]); });
    EXPECT_GT(patch.moment, 0);
    // Round-off of the transverse shear, as in shell_patch_test.cpp.
    EXPECT_LT(patch.left_moment, 1e-10 * patch.moment);
    EXPECT_LT(patch.left_force, 1e-9 * patch.moment / 0.12);
  }
}

TEST(ShellTriangle, KeepsMostOfItsShearWhereItIsThickAndLittleWhereItIsThin) {
  // w = gamma x without rotation on half of the unit square: edges 1, 1 and the root of 2.
  const double gamma = 1e-3, dt = 1e-12, mean_square = 4.0 / 3;
  const ShellCorners x = make_triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  ShellCorners v;
  for (std::size_t i = 0; i < 4; ++i) v[i] = {0, 0, gamma * x[i].x};
  for (const double t : {1.0, 0.1, 0.01}) {
    TestShell<ElasticLayer> shell(soft, 2, x, t, 1);
    shell.advance(move(x, v, dt), v, {}, dt);
    // Its power is stress times rate times volume.
    const double stress = 5.0 / 6.0 * (1e6 / 2.5) * gamma * dt * t * t / (t * t + 0.1 * mean_square);
    EXPECT_NEAR(shell.force[1].z / (stress * t * 0.5 * 1), 1, 1e-9) << t;
  }
}

TEST(ShellTriangle, QuadrilateralsAmongTrianglesHaveTheSameBits) {
  using Lanes = Pack<double>;
  constexpr int width = pack_size<double>;
  Random random(7);
  ShellCorners x[width], v[width], w[width];
  std::vector<TestShell<ElasticLayer>> alone;
  for (int lane = 0; lane < width; ++lane) {
    x[lane] = lane % 2 == 1 ? make_random_triangle(random) : make_quad(random, 1, 1.4, 0.2, 0.1);
    v[lane] = lane % 2 == 1 ? random_triangle_field(random) : random_field(random, 1);
    w[lane] = lane % 2 == 1 ? random_triangle_field(random) : random_field(random, 1);
    alone.emplace_back(soft, 3, x[lane], thickness, 1);
  }
  const auto gather = [&](const ShellCorners(&u)[width], Vector3<Lanes>(&packs)[4]) {
    for (std::size_t i = 0; i < 4; ++i) {
      alignas(64) double c[3][width];
      for (int lane = 0; lane < width; ++lane) {
        c[0][lane] = u[lane][i].x;
        c[1][lane] = u[lane][i].y;
        c[2][lane] = u[lane][i].z;
      }
      packs[i] = {load_pack(c[0]), load_pack(c[1]), load_pack(c[2])};
    }
  };
  Vector3<Lanes> px[4], pv[4], pw[4], force[4], moment[4];
  gather(x, px);
  gather(v, pv);
  gather(w, pw);
  alignas(64) double repeated[width], mass[width], gyration[width];
  for (int lane = 0; lane < width; ++lane) {
    repeated[lane] = lane % 2;
    mass[lane] = alone[static_cast<std::size_t>(lane)].state.mass;
    gyration[lane] = alone[static_cast<std::size_t>(lane)].state.gyration_square;
  }
  ShellState<Lanes> state{};
  for (auto* value : {&state.shear[0], &state.shear[1], &state.membrane_hourglass[0], &state.membrane_hourglass[1],
                      &state.bending_hourglass[0], &state.bending_hourglass[1], &state.shear_hourglass[0],
                      &state.shear_hourglass[1], &state.drilling})
    *value = Lanes(0.0);
  state.mass = load_pack(mass);
  state.gyration_square = load_pack(gyration);
  state.thickness = Lanes(thickness);
  std::array<Lanes, 9> layers;
  layers.fill(Lanes(0.0));
  const auto is_triangle = load_pack(repeated) > Lanes(0.5);
  const double dt = 1e-3;
  const CornerMotion<Lanes> motion{percuss::find_differences(px), percuss::find_differences(pv), pw, Lanes(dt)};
  const auto result = advance_shell4(alone[0].par, motion, {state, layers.data()}, {force, moment}, WholeLayers{},
                                     MixedShapes<std::remove_const_t<decltype(is_triangle)>>{is_triangle});
  const auto lane_of = [](const Lanes& pack, int lane) {
    alignas(64) double values[width];
    store_pack(values, pack);
    return values[lane];
  };
  for (int lane = 0; lane < width; ++lane) {
    auto& shell = alone[static_cast<std::size_t>(lane)];
    Vec f[4], m[4];
    const Vec spins[4] = {w[lane][0], w[lane][1], w[lane][2], w[lane][3]};
    ShellResult<double> expected{};
    const auto dx = find_differences(x[lane]), dv = find_differences(v[lane]);
    const CornerMotion<double> alone_motion{dx, dv, spins, dt};
    const StoredShell<double> stored{shell.state, shell.layers.data()};
    if (lane % 2 == 0) {
      expected = advance_shell4(shell.par, alone_motion, stored, {f, m});
    } else {
      expected = advance_shell4(shell.par, alone_motion, stored, {f, m}, WholeLayers{}, MixedShapes<bool>{true});
    }
    EXPECT_EQ(lane_of(result.stable_step, lane), expected.stable_step);
    EXPECT_EQ(lane_of(result.work.internal, lane), expected.work.internal);
    EXPECT_EQ(lane_of(result.size, lane), expected.size);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(lane_of(force[i].x, lane), f[i].x);
      EXPECT_EQ(lane_of(force[i].z, lane), f[i].z);
      EXPECT_EQ(lane_of(moment[i].y, lane), m[i].y);
      EXPECT_EQ(lane_of(moment[i].z, lane), m[i].z);
    }
  }
}

}  // namespace percuss::test::shell_triangle_test
