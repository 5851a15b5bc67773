// Bending, in the linear limit: free beams of one and two elements through the thickness, and Cook's membrane with a
// nearly incompressible material.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include "tests/verification/support/linear_model.hpp"
#include "tests/verification/support/mapped_mesh.hpp"

namespace percuss::test::bending_test {
namespace {

constexpr double length = 20;

/// Half of a beam of thickness 1 (y) and length 20 (z), cut along its middle (x = 0). `skew`: the cross-sections
/// between elements lean by this angle to and fro.
testing_mesh::WrittenMesh make_beam(int through, int along, double half_width, int across, double skew) {
  return make_mapped_box({across, through, along}, [=](const Vec3& u) {
    const auto section = static_cast<int>(std::lround(u[2] * along));
    const bool inside = section > 0 && section < along;
    const double lean = inside ? (section % 2 == 0 ? 1 : -1) * std::tan(skew) * (u[1] - 0.5) : 0;
    return Vec3{half_width * u[0], u[1] - 0.5, length * (u[2] - 0.5) + lean};
  });
}

double dot(const std::vector<double>& a, const std::vector<double>& b, const std::vector<double>& weight) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += weight[i] * a[i] * b[i];
  return sum;
}

/// Lowest natural frequency squared of a free beam: inverse iteration on what is orthogonal to the rigid motions.
template <HexKind Kind>
double find_lowest(const testing_mesh::WrittenMesh& mesh, double coefficient) {
  LinearModel model(mesh);
  const std::size_t count = 3 * mesh.nodes.size();
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) model.held[3 * n] = mesh.nodes[n][0] == 0;
  const double shift = 1e-3;  // of the order of the answer
  BandedMatrix k = model.assemble<Kind>({}, coefficient, shift);
  k.factorise();
  std::vector<std::vector<double>> rigid(3, std::vector<double>(count));
  std::vector<double> u(count);
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    const Vec3& p = mesh.nodes[n];
    rigid[0][3 * n + 1] = rigid[1][3 * n + 2] = 1;
    rigid[2][3 * n + 1] = p[2], rigid[2][3 * n + 2] = -p[1];
    u[3 * n + 1] = p[2] * p[2];
  }
  const auto remove_rigid = [&] {
    for (int twice = 0; twice < 2; ++twice) {
      for (const auto& r : rigid) {
        const double share = dot(u, r, model.mass) / dot(r, r, model.mass);
        for (std::size_t i = 0; i < count; ++i) u[i] -= share * r[i];
      }
    }
  };
  double value = 0;
  for (int n = 0; n < 30; ++n) {
    remove_rigid();
    const double size = std::sqrt(dot(u, u, model.mass));
    for (std::size_t i = 0; i < count; ++i) u[i] *= model.mass[i] / size;
    std::vector<double> next = k.solve(u);
    for (std::size_t i = 0; i < count; ++i) u[i] /= model.mass[i];
    value = 1 / dot(u, next, model.mass) - shift;
    u = next;
  }
  return value;
}

/// Vertical deflection of the upper corner of Cook's membrane (48 wide, 44 and 16 high, E 240.565, load 100, plane
/// strain).
template <HexKind Kind>
double find_cook_deflection(int n, double poisson, double coefficient) {
  const auto mesh = make_mapped_box({1, n, n}, [](const Vec3& u) {
    const double low = 44 * u[2], high = 44 + 16 * u[2];
    return Vec3{u[0], low + u[1] * (high - low), 48 * u[2]};
  });
  LinearModel model(mesh);
  std::vector<double> load(3 * mesh.nodes.size());
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    const Vec3& p = mesh.nodes[i];
    model.held[3 * i] = 1;
    if (p[2] == 0) model.held[3 * i + 1] = model.held[3 * i + 2] = 1;
    const bool corner = p[1] == 44 || p[1] == 60;
    if (p[2] == 48) load[3 * i + 1] = 100.0 / n * (corner ? 0.25 : 0.5);
  }
  BandedMatrix k = model.assemble<Kind>({240.565, poisson, 1}, coefficient, 0);
  k.factorise();
  return k.solve(load)[3 * mesh.nodes.size() - 2];
}

/// First free frequency squared of Timoshenko's beam of this shape, with E = rho = 1, Poisson's ratio 0.3 and the shear
/// coefficient 10 (1 + nu) / (12 + 11 nu) of Cowper (J. Appl. Mech. 33, 1966): the root of the determinant of its
/// boundary conditions, from the four equations integrated along the beam. 1.8 % below (4.73004 / L)^4 / 12.
constexpr double exact = 2.5608162e-4;

/// Errors of the first bending frequency (%), by mesh.
struct BendingErrors {
  double one = 0, two = 0;            // cubes, one and two through the thickness
  double long_one = 0, long_two = 0;  // four times as long as thick
  double skew_one = 0;                // cubes whose cross-sections lean by 10 degrees to and fro
};

template <HexKind Kind>
BendingErrors find_bending_errors(double coefficient) {
  const auto error = [&](int through, int along, double width, double skew) {
    const double found = find_lowest<Kind>(make_beam(through, along, width, 1, skew), coefficient);
    return 100 * (std::sqrt(found / exact) - 1);
  };
  return {error(1, 20, 1, 0), error(2, 40, 0.5, 0), error(1, 5, 1, 0), error(2, 10, 0.5, 0),
          error(1, 20, 1, std::numbers::pi / 18)};
}

}  // namespace

TEST(Bending, AFineMeshHasTheFrequencyOfTimoshenkosBeam) {
  const double fine = find_lowest<HexKind::assumed_strain>(make_beam(8, 160, 1, 4, 0), 0);
  EXPECT_NEAR(std::sqrt(fine / exact), 1, 2e-4);
}

TEST(Bending, FrequenciesOfCoarseBeams) {
  std::map<std::string, BendingErrors> errors;
  for_each_choice([&](auto kind, double coefficient, const char* name) {
    const BendingErrors e = find_bending_errors<decltype(kind)::value>(coefficient);
    fmt::print("{:15} {:8.2f} {:8.2f} {:8.2f} {:8.2f} {:8.2f}\n", name, e.one, e.two, e.long_one, e.long_two,
               e.skew_one);
    errors[name] = e;
  });
  // The stabilisation has the exact bending stiffness of a brick; what is left is the lattice along the beam.
  const BendingErrors& assumed = errors.at("assumed_strain");
  EXPECT_LT(std::abs(assumed.one), 1.6);
  EXPECT_LT(std::abs(assumed.two), 0.4);
  EXPECT_LT(std::abs(assumed.long_one), 9.6);
  EXPECT_LT(std::abs(assumed.long_two), 2.6);
  EXPECT_LT(std::abs(assumed.skew_one), 6.6);
  // Linear shape functions shear when they bend, the more the longer they are.
  EXPECT_GT(errors.at("full").long_one, 100);
  EXPECT_LT(std::abs(errors.at("full").two), 1);
  // The 1981 control has no length of its own: far too soft in cubes, too stiff in long elements.
  EXPECT_LT(errors.at("stiffness 0.05").one, -35);
  EXPECT_GT(errors.at("stiffness 0.05").long_one, 50);
}

TEST(CooksMembrane, DoesNotLockWhenNearlyIncompressible) {
  for_each_choice([&](auto kind, double coefficient, const char* name) {
    constexpr HexKind K = decltype(kind)::value;
    std::map<double, std::array<double, 2>> shares;  // of the limit, with 4 and 16 elements along a side
    for (const auto& [poisson, limit] : {std::pair{0.3333, 9.38}, std::pair{0.499, 8.06}, std::pair{0.4999, 8.05}}) {
      shares[poisson] = {find_cook_deflection<K>(4, poisson, coefficient) / limit,
                         find_cook_deflection<K>(16, poisson, coefficient) / limit};
      fmt::print("{:15} Poisson's ratio {}: {:.3f} {:.3f} of the limit\n", name, poisson, shares[poisson][0],
                 shares[poisson][1]);
    }
    // Where volume locks, the share falls towards nothing with 1 / (1 - 2 nu); here it stays.
    EXPECT_NEAR(shares[0.4999][0], shares[0.3333][0], 0.08) << name;
    EXPECT_NEAR(shares[0.4999][1], shares[0.3333][1], 0.01) << name;
    EXPECT_NEAR(shares[0.4999][1], shares[0.499][1], 0.001) << name;
    // Known from independent implementations, to three digits.
    if (K == HexKind::assumed_strain) {
      EXPECT_GT(shares[0.4999][0], 7.315 / 8.05);
      EXPECT_GT(shares[0.4999][1], 7.895 / 8.05);
    } else if (K == HexKind::full) {
      EXPECT_GT(shares[0.4999][0], 6.795 / 8.05);
      EXPECT_GT(shares[0.4999][1], 7.885 / 8.05);
    }
  });
}

}  // namespace percuss::test::bending_test
