// One hexahedron of every material, stretched, sheared and turned, against the material as a point in the frame that
// does not turn. The element is judged by its corner forces.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernels/element/element_chunks.hpp"
#include "tests/kernels/element/random_element.hpp"
#include "tests/kernels/material/pairings.hpp"
#include "tests/kernels/material/point_driver.hpp"

namespace percuss::test::one_element_test {
namespace {

/// Where a step leads: F = turn stretch.
struct PathStep {
  Matrix3<double> turn;
  Symmetric3<double> stretch;
  double dt;
};

Symmetric3<double> find_stretch(double t) {
  const Symmetric3<double> one{1, 1, 1, 0, 0, 0}, first{0.08, -0.05, 0.03, 0.04, -0.03, 0.02},
      then{-0.10, -0.06, -0.02, -0.01, 0.03, -0.02};
  return one + std::sin(2.2 * t) * first + t * t * then;  // it swells by 2 %, then shrinks to 0.87
}

/// About (2, -1, 2) / 3, by Rodrigues' formula.
Matrix3<double> turn_by(double angle) {
  const Vector3<double> n{2.0 / 3, -1.0 / 3, 2.0 / 3};
  const Matrix3<double> w{{{0, -n.z, n.y}, {n.z, 0, -n.x}, {-n.y, n.x, 0}}};
  return identity_matrix<double>() + std::sin(angle) * w + (1 - std::cos(angle)) * (w * w);
}

/// Deforms and turns by turns, four times each; 200 steps.
std::vector<PathStep> make_path_by_turns() {
  std::vector<PathStep> path{{identity_matrix<double>(), find_stretch(0), 0}};
  for (int leg = 0; leg < 4; ++leg) {
    for (int i = 1; i <= 25; ++i) path.push_back({turn_by(0.2 * leg), find_stretch((25 * leg + i) / 100.0), 1e-3});
    const Symmetric3<double> held = path.back().stretch;
    for (int i = 1; i <= 25; ++i) path.push_back({turn_by(0.2 * (leg + i / 25.0)), held, 1e-3});
  }
  return path;
}

/// Both at once.
std::vector<PathStep> make_path_at_once(int steps) {
  std::vector<PathStep> path{{identity_matrix<double>(), find_stretch(0), 0}};
  for (int i = 1; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    path.push_back({turn_by(1.2 * t), find_stretch(t), 0.1 / steps});
  }
  return path;
}

LameConstants find_reference(const CalledMaterial& material) { return material.reference; }
template <class Law>
LameConstants find_reference(const Law& law) {
  return law.moduli();
}

template <HexKind Kind>
void start(const CalledMaterial& material, HexState<double, CalledMaterial, Kind>& state) {
  double history[CalledMaterial::history_count];
  const double center[3] = {0, 0, 0};
  start_history(material, history, center);
  for (int p = 0; p < hex_points<Kind>; ++p) state.history.store(p, history, material.count_history());
}
template <class Law, class State>
void start(const Law&, State&) {}

/// A distorted brick whose corners are led along x = F X. Bulk viscosity is off: points have none.
template <class Material, HexKind Kind>
class Element {
 public:
  explicit Element(const Material& material) {
    par_.material = material;
    const LameConstants reference = find_reference(material);
    par_.lambda = reference.lambda, par_.mu = reference.mu;
    par_.viscosity = {0, 0};
    Random random(11);
    x_ = start_ = make_element(random, 1, 0.8, 1.2, 0.1);
    volume_ = find_volume_gradient(find_modes(start_)).volume;
    state = make_state<Material, Kind>(sample_density * volume_);
    start(material, state);
  }

  void advance(const PathStep& to) {
    const Corners before = x_;
    x_ = apply(to.turn * full(to.stretch), start_);
    Corners v{};
    for (int i = 0; i < 8 && to.dt > 0; ++i) {
      v.x[i] = (x_.x[i] - before.x[i]) / to.dt;
      v.y[i] = (x_.y[i] - before.y[i]) / to.dt;
      v.z[i] = (x_.z[i] - before.z[i]) / to.dt;
    }
    par_.time += to.dt;
    double f[3][8];
    const auto result = advance_hex8(par_, find_modes(x_), find_modes(v), to.dt, state, {f[0], f[1], f[2]});
    energy += result.work.internal / volume_;
    // sum of f x = V sigma for a uniform stress, turned back by what the path has turned it
    Matrix3<double> moment{};
    for (int i = 0; i < 8; ++i) {
      for (int k = 0; k < 3; ++k) {
        moment.row[k] = moment.row[k] + f[k][i] * Vector3<double>{x_.x[i], x_.y[i], x_.z[i]};
      }
    }
    const double now = volume_ * determinant(full(to.stretch));
    stress = pull_back(to.turn, (1 / now) * symmetric_part(moment));
  }

  HexState<double, Material, Kind> state;
  Symmetric3<double> stress{};
  double energy = 0;  // internal, per volume at the start

 private:
  SolidParameters<Material> par_;
  Corners start_{}, x_{};
  double volume_ = 0;
};

/// Leads a point along the stretch alone: the midpoint rule for a body that does not turn.
template <class Law>
class UnturnedPoint : public Point<Law> {
 public:
  using Point<Law>::Point;

  void advance(const PathStep& to) {
    const Matrix3<double> sum = full(to.stretch + last_), change = full(to.stretch) - full(last_);
    const Symmetric3<double> before = this->stress, de = symmetric_part(2.0 * (change * inverse(sum)));
    const double volume_before = determinant(full(last_)), volume = determinant(full(to.stretch));
    this->log_volume = std::log(volume) - trace(de);
    if (is_of_kirchhoff) this->stress = volume_before * this->stress;
    Point<Law>::advance(de, to.dt);
    if (is_of_kirchhoff) this->stress = (1 / volume) * this->stress;
    energy += 0.5 * determinant(0.5 * sum) * contract(before + this->stress, de);
    last_ = to.stretch;
  }

  double energy = 0;
  bool is_of_kirchhoff = false;  // the rate of the law is that of J sigma

 private:
  Symmetric3<double> last_{1, 1, 1, 0, 0, 0};
};

/// Largest differences along a path, as shares of the largest value.
struct Difference {
  double stress = 0, energy = 0, history = 0;
};

/// Largest size and largest difference of something along a path.
struct Extent {
  double size = 0, difference = 0;
  void add(double one_size, double one_difference) {
    size = std::max(size, one_size);
    difference = one_difference <= difference ? difference : one_difference;  // keeps what is not a number
  }
  double find_share() const { return size > 0 ? difference / size : difference; }
};

template <class Material, HexKind Kind, class Law>
Difference follow(const Material& material, UnturnedPoint<Law> point, const std::vector<PathStep>& path) {
  Element<Material, Kind> element(material);
  Extent stress, energy, history[CalledMaterial::history_count];
  for (const PathStep& to : path) {
    element.advance(to);
    point.advance(to);
    stress.add(largest_difference(point.stress, {}), largest_difference(element.stress, point.stress));
    energy.add(std::abs(point.energy), std::abs(element.energy - point.energy));
    if constexpr (is_called<Material>) {
      for (int i = 0; i < material.count_history(); ++i) {
        const auto& values = element.state.history.value[i];
        for (const double value : values)
          history[i].add(std::abs(point.history[i]), std::abs(value - point.history[i]));
      }
    }
  }
  EXPECT_GT(stress.size, 1e-4 * point.modulus);
  EXPECT_GT(energy.size, 0);
  Difference out{stress.find_share(), energy.find_share()};
  for (const Extent& one : history) out.history = std::max(out.history, one.find_share());
  return out;
}

template <class Pair>
auto make_point() {
  using Law = typename Pair::Law;
  if constexpr (std::is_void_v<typename Pair::State>) {
    return UnturnedPoint<Law>(make_sample_law<Law>(), sample_density);
  } else {
    return UnturnedPoint<Law>(make_sample_law<Law>(), sample_density, sample<typename Pair::State>());
  }
}

/// Calls f(difference, kind) for an element of each kind that calls the material, and for one that it is compiled into.
template <class Pair, class F>
void for_each_element(const std::vector<PathStep>& path, const F& f) {
  const auto point = make_point<Pair>();
  const CalledMaterial called = point.material;
  f(follow<CalledMaterial, HexKind::assumed_strain>(called, point, path), "assumed_strain");
  f(follow<CalledMaterial, HexKind::stiffness>(called, point, path), "stiffness");
  f(follow<CalledMaterial, HexKind::viscous>(called, point, path), "viscous");
  f(follow<CalledMaterial, HexKind::full>(called, point, path), "full");
  if constexpr (is_compiled_in<typename Pair::Law> && std::is_void_v<typename Pair::State>) {
    using Law = typename Pair::Law;
    auto compiled = point;
    compiled.is_of_kirchhoff = std::is_same_v<Law, Elastic>;
    f(follow<Law, HexKind::assumed_strain>(make_sample_law<Law>(), compiled, path), "compiled in");
    f(follow<Law, HexKind::full>(make_sample_law<Law>(), compiled, path), "compiled in, full");
  }
}

template <class... Pair>
testing::Types<Pair...> make_types(TypeList<Pair...>);

template <class Pair>
class OneElement : public testing::Test {};
TYPED_TEST_SUITE(OneElement, decltype(make_types(Pairings())));

}  // namespace

TYPED_TEST(OneElement, DeformedAndTurnedByTurnsIsThePointThatDoesNotTurn) {
  for_each_element<TypeParam>(make_path_by_turns(), [](const Difference& d, const char* kind) {
    EXPECT_LT(d.stress, 1e-11) << kind;
    EXPECT_LT(d.energy, 1e-11) << kind;
    EXPECT_LT(d.history, 1e-9) << kind;  // the modulus of Tillotson is a difference over 1e-6: 1e-10
  });
}

TYPED_TEST(OneElement, DeformedAsItTurnsIsThePointToSecondOrder) {
  // Stress: what a step turns the strain by, 0.012, times the square of its strain, 2e-3, a hundred times over 0.1.
  // Energy: the volume at mid-step is cos^2 of half that angle too small.
  constexpr double half_turn = 0.006;
  std::vector<Difference> coarse;
  for_each_element<TypeParam>(make_path_at_once(50), [&](const Difference& d, const char*) { coarse.push_back(d); });
  std::size_t i = 0;
  for_each_element<TypeParam>(make_path_at_once(100), [&](const Difference& d, const char* kind) {
    EXPECT_LT(d.stress, 1e-6) << kind;
    EXPECT_NEAR(d.energy, half_turn * half_turn, 0.01 * half_turn * half_turn) << kind;
    EXPECT_LT(d.stress, coarse[i].stress / 3 + 1e-11) << kind;
    EXPECT_LT(d.energy, coarse[i].energy / 3) << kind;
    ++i;
  });
}

}  // namespace percuss::test::one_element_test
