// A beam of two nodes: balance, step bound, sections and fibres, and lines of beams against exact answers.

#include "kernels/beam/beam_step.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace percuss::test::beam2_test {
namespace {

using V = Vector3<double>;
using Ends = BeamEnds<double>;

constexpr double pi = std::numbers::pi;

class Random {
 public:
  double number(double low = -1, double high = 1) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  V vector() { return {number(), number(), number()}; }

 private:
  std::mt19937 engine_{7};
};

BeamFrame<double> make_frame(Random& random) {
  return find_beam_frame<double>({random.vector(), random.vector()}, random.vector());
}

BeamForces<double> make_forces(Random& random) {
  return {random.number(), random.number(), random.number(), random.number(), random.number(), random.number()};
}

double find_power(const BeamForces<double>& f, const BeamRates<double>& r) {
  return f.normal * r.stretch + f.shear_y * r.shear_y + f.shear_z * r.shear_z + f.torque * r.twist +
         f.moment_y * r.curvature_y + f.moment_z * r.curvature_z;
}

}  // namespace

TEST(Beam2, DoesNotFeelRigidMotion) {
  Random random;
  for (int i = 0; i < 100; ++i) {
    const Ends place{random.vector(), random.vector()};
    const BeamFrame<double> frame = find_beam_frame<double>(place, random.vector());
    const V velocity = random.vector(), spin = random.vector();
    const BeamRates<double> rates = find_beam_rates<double>(
        frame, {velocity + cross(spin, place.first), velocity + cross(spin, place.second)}, {spin, spin});
    for (const double rate :
         {rates.stretch, rates.shear_y, rates.shear_z, rates.twist, rates.curvature_y, rates.curvature_z})
      EXPECT_NEAR(rate, 0, 1e-12 / frame.length);
  }
}

TEST(Beam2, IsInBalanceAndHasThePowerOfItsSection) {
  Random random;
  for (int i = 0; i < 100; ++i) {
    const BeamFrame<double> frame = make_frame(random);
    const BeamForces<double> forces = make_forces(random);
    const BeamNodalForces<double> on = find_beam_nodal_forces(frame, forces);
    const V left = on.moment.first + on.moment.second + cross(frame.length * frame.e1, on.force_on_second);
    EXPECT_NEAR(norm(left), 0, 1e-14);
    const Ends velocity{random.vector(), random.vector()}, spin{random.vector(), random.vector()};
    const double power = dot(on.force_on_second, velocity.second - velocity.first) + dot(on.moment.first, spin.first) +
                         dot(on.moment.second, spin.second);
    EXPECT_NEAR(power, frame.length * find_power(forces, find_beam_rates<double>(frame, velocity, spin)), 1e-13);
  }
}

namespace {

using Unknowns = std::array<double, 12>;  // velocities of both nodes, then spins

/// Forces of a velocity for an elastic section, over masses and inertias.
Unknowns apply(const BeamFrame<double>& frame, const BeamStiffness& k, double mass, double inertia, const Unknowns& u) {
  const auto at = [&](std::size_t i) { return V{u[3 * i], u[3 * i + 1], u[3 * i + 2]}; };
  const BeamForces<double> f = add_elastic({}, k, find_beam_rates<double>(frame, {at(0), at(1)}, {at(2), at(3)}));
  const BeamNodalForces<double> on = find_beam_nodal_forces(frame, f);
  const V parts[4] = {(-2 / mass) * on.force_on_second, (2 / mass) * on.force_on_second,
                      (1 / inertia) * on.moment.first, (1 / inertia) * on.moment.second};
  Unknowns result{};
  for (std::size_t i = 0; i < 4; ++i) {
    result[3 * i] = parts[i].x;
    result[3 * i + 1] = parts[i].y;
    result[3 * i + 2] = parts[i].z;
  }
  return result;
}

/// The largest eigenvalue from below: Rayleigh's quotient in the masses after a power iteration.
double find_largest(const BeamFrame<double>& frame, const BeamStiffness& k, double mass, double inertia,
                    Random& random) {
  Unknowns u{};
  for (double& x : u) x = random.number();
  double largest = 0;
  for (int n = 0; n < 1000; ++n) {
    const Unknowns next = apply(frame, k, mass, inertia, u);
    double product = 0, square = 0, size = 0;
    for (std::size_t i = 0; i < u.size(); ++i) {
      const double m = i < 6 ? mass / 2 : inertia;
      product += m * u[i] * next[i];
      square += m * u[i] * u[i];
      size = std::max(size, std::fabs(next[i]));
    }
    largest = product / square;
    for (std::size_t i = 0; i < u.size(); ++i) u[i] = next[i] / size;
  }
  return largest;
}

}  // namespace

TEST(Beam2, StepBoundIsTheLargestEigenvalue) {
  Random random;
  const auto size = [&] { return std::exp(random.number(-2, 2)); };
  for (int i = 0; i < 200; ++i) {
    const BeamFrame<double> frame = make_frame(random);
    const BeamStiffness k{size(), size(), size(), size(), size(), size()};
    const double mass = size(), inertia = size() * mass * frame.length * frame.length;
    const double bound = find_beam_eigenvalue(k, mass, {inertia, inertia}, frame.length);
    const double found = find_largest(frame, k, mass, inertia, random);
    EXPECT_LE(found, bound * (1 + 1e-10));
    EXPECT_GE(found, bound * (1 - 0.01));  // two eigenvalues that lie close converge slowly
  }
}

TEST(Beam2, RotaryInertiaLeavesTheStepOfTheAxialWave) {
  for (const BeamSection& s : {make_round(1), make_tube(1, 0.9), make_rectangle(1, 3), make_box(2, 1, 0.1)}) {
    for (const double length : {0.1, 1.0, 10.0, 100.0}) {
      const BeamStiffness k = find_beam_stiffness(s, 200, 200 / 2.6);
      const double mass = 7.8 * s.area * length, axial = 4 * k.axial / (mass * length);
      const double across = find_beam_inertia(k, mass, length), about = mass / 2 * find_polar_moment(s) / s.area;
      EXPECT_NEAR(find_beam_eigenvalue(k, mass, {across, across}, length), axial, 1e-14 * axial);
      EXPECT_NEAR(find_beam_eigenvalue(k, mass, {across, about}, length), axial, 1e-14 * axial);  // J <= I_y + I_z
    }
  }
}

TEST(BeamSection, HasTheConstantsOfBooks) {
  const BeamSection round = make_round(2), tube = make_tube(2, 0), square = make_rectangle(3, 3),
                    box = make_box(3, 3, 1.5);
  EXPECT_DOUBLE_EQ(round.area, 4 * pi);
  EXPECT_DOUBLE_EQ(round.inertia_y, 4 * pi);
  EXPECT_DOUBLE_EQ(round.torsion, 8 * pi);
  EXPECT_DOUBLE_EQ(tube.inertia_z, round.inertia_z);
  EXPECT_NEAR(square.torsion, 0.1406 * 81, 1e-3 * 81);  // Timoshenko and Goodier, table in section 109
  EXPECT_DOUBLE_EQ(make_rectangle(2, 3).inertia_y, 2 * 27.0 / 12);
  EXPECT_DOUBLE_EQ(box.area, square.area);
  EXPECT_DOUBLE_EQ(box.inertia_y, square.inertia_y);
}

namespace {

/// A line of equal elastic beams along x, its first node clamped, moved by central differences.
class Line {
 public:
  Line(int count, double length, const BeamSection& section, double young, double shear, double density) {
    const double size = length / count, mass = density * section.area * size;
    parameters_.stiffness = find_beam_stiffness(section, young, shear);
    parameters_.area = section.area;
    parameters_.bends = true;
    BeamState state;
    state.mass = mass;
    state.gyration_square = 2 * find_beam_inertia(parameters_.stiffness, 1, size);
    parameters_.polar_square = state.gyration_square;
    state.e2 = {0, 1, 0};
    elements_.assign(static_cast<std::size_t>(count), state);
    step_ = 0.9 * find_beam_step(parameters_, state, size);
    const double inertia = 0.5 * mass * state.gyration_square;
    for (int n = 0; n <= count; ++n) {
      Node node;
      node.x = {size * n, 0, 0};
      node.mass = n == 0 || n == count ? mass / 2 : mass;
      node.inertia = n == 0 || n == count ? inertia : 2 * inertia;
      nodes_.push_back(node);
    }
  }

  struct Node {
    V x{}, v{}, w{}, force{}, moment{}, load{}, torque{};
    double mass = 0, inertia = 0;
  };

  std::vector<Node>& nodes() { return nodes_; }
  Node& last() { return nodes_.back(); }
  double step() const { return step_; }
  const BeamForces<double>& forces(std::size_t element) const { return elements_[element].forces; }
  const V& axis(std::size_t element) const { return elements_[element].e2; }
  double work() const { return work_; }
  bool is_clamped = true;
  double damping = 0;  // share of the velocity that a step takes

  void advance() {
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
      Node& node = nodes_[n];
      node.v = (1 - damping) * node.v + (step_ / node.mass) * (node.load + node.force);
      node.w = (1 - damping) * node.w + (step_ / node.inertia) * (node.torque + node.moment);
      if (n == 0 && is_clamped) node.v = node.w = {0, 0, 0};
      node.x = node.x + step_ * node.v;
      node.force = node.moment = {0, 0, 0};
    }
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      Node &a = nodes_[e], &b = nodes_[e + 1];
      const BeamResult result =
          advance_beam(parameters_, {{a.x, b.x}, {a.v, b.v}, {a.w, b.w}, step_}, elements_[e], nullptr);
      work_ += result.work;
      a.force = a.force + result.on.force_on_second;
      b.force = b.force - result.on.force_on_second;
      a.moment = a.moment - result.on.moment.first;
      b.moment = b.moment - result.on.moment.second;
    }
  }

 private:
  BeamParameters parameters_;
  double step_ = 0, work_ = 0;
  std::vector<Node> nodes_;
  std::vector<BeamState> elements_;
};

constexpr double young = 200, shear = 80, density = 1;

}  // namespace

// Each element bends by the moment at its middle.
TEST(BeamLine, BendsAsALineOfOnePointElements) {
  const BeamSection section = make_rectangle(0.1, 0.2);
  for (const int count : {1, 4, 10}) {
    Line line(count, 2, section, young, shear, density);
    const double load = 1e-6;
    line.last().load = {0, 0, load};
    line.damping = 2 * line.step() * 0.35 * std::sqrt(young * section.inertia_y / (section.area * density));
    for (int n = 0; n < 12000; ++n) line.advance();
    const double tip = load * (8 / (3 * young * section.inertia_y) * (1 - 1.0 / (4 * count * count)) +
                               2 / (shear * section.shear_area_z));
    EXPECT_NEAR(line.last().x.z, tip, 1e-5 * tip) << count;
  }
}

TEST(BeamLine, TwistsByItsTorque) {
  const BeamSection section = make_round(0.1);
  Line line(5, 2, section, young, shear, density);
  line.last().torque = {1e-4, 0, 0};
  line.damping = 0.02;
  double angle = 0;
  for (int n = 0; n < 6000; ++n) {
    line.advance();
    angle += line.step() * line.last().w.x;
  }
  EXPECT_NEAR(angle, 1e-4 * 2 / (shear * section.torsion), 1e-6 * angle);
}

// A moment of 2 pi E I / L bends the line into a closed polygon: every element turns by the same angle.
TEST(BeamLine, RollsUpIntoACircle) {
  const BeamSection section = make_rectangle(0.02, 0.02);
  const int count = 12, steps = 40000;
  Line line(count, 1, section, young, shear, density);
  line.damping = 0.02;
  const double whole = 2 * pi * young * section.inertia_z;
  for (int n = 0; n < steps; ++n) {
    line.last().torque = {0, 0, whole * std::min(1.0, 2.0 * n / steps)};
    line.advance();
  }
  EXPECT_NEAR(norm(line.last().x), 0, 2e-2);
  const auto& middle = line.nodes()[count / 2].x;
  EXPECT_NEAR(norm(middle), 1 / pi, 1e-2);  // the diameter; of a polygon of 12 sides 1.2 % more
  EXPECT_NEAR(line.forces(3).moment_z, whole, 1e-4 * whole);
}

// The far end is free, and the wave is on its way: E A v / c behind its front.
TEST(BeamLine, CarriesAnAxialWave) {
  const BeamSection section = make_round(0.1);
  Line line(200, 1, section, young, shear, density);
  const double c = std::sqrt(young / density);
  line.is_clamped = false;
  for (double t = 0; t < 0.5 / c; t += line.step()) {
    line.nodes().front().v = {0.01, 0, 0};
    line.nodes().front().force = {0, 0, 0};
    line.advance();
  }
  double mean = 0;
  for (std::size_t e = 10; e < 60; ++e) mean += line.forces(e).normal / 50;
  EXPECT_NEAR(mean, -young * section.area * 0.01 / c, 0.01 * young * section.area * 0.01 / c);
  EXPECT_NEAR(line.forces(150).normal, 0, 1e-6);
}

// A free line spins about z a hundred times: length, spin and shape stay.
TEST(BeamLine, SpinsFreely) {
  const BeamSection section = make_rectangle(0.05, 0.02);
  Line line(4, 1, section, young, shear, density);
  line.is_clamped = false;
  const double spin = 0.01;
  for (auto& node : line.nodes()) {
    node.w = {0, 0, spin};
    node.v = cross(node.w, node.x - V{0.5, 0, 0});
  }
  const auto steps = static_cast<int>(10 * 2 * pi / (spin * line.step()));
  for (int n = 0; n < steps; ++n) line.advance();
  const V across = line.last().x - line.nodes().front().x;
  EXPECT_NEAR(norm(across), 1, 1e-5);
  EXPECT_NEAR(line.last().w.z, spin, 1e-3 * spin);
  EXPECT_NEAR(line.last().x.z, 0, 1e-12);
  const double angle = spin * line.step() * steps;
  EXPECT_NEAR(std::cos(angle) * across.x + std::sin(angle) * across.y, 1, 1e-3);
}

// About its own axis and across: the axes of the section follow. A turn of each is a rotation of all.
TEST(BeamLine, KeepsItsAxesInAnySpin) {
  const BeamSection section = make_rectangle(0.05, 0.02);
  Line line(2, 1, section, young, shear, density);
  line.is_clamped = false;
  const V spin{0.03, 0.01, 0.02};
  for (auto& node : line.nodes()) {
    node.w = spin;
    node.v = cross(node.w, node.x - V{0.5, 0, 0});
  }
  // The moment of a spin that is not about a main axis turns it; a few turns of the start of the step are compared.
  V e2{0, 1, 0};
  for (int n = 0; n < 200; ++n) {
    line.advance();
    e2 = turn_by_spin(e2, line.nodes()[1].w, line.step());
  }
  EXPECT_NEAR(norm(line.axis(0) - e2), 0, 1e-6);
  EXPECT_NEAR(norm(line.axis(1)), 1, 1e-14);
}

// A truss: its force and work under a stretch, nothing for turns.
TEST(Truss, StretchesByItsLogarithmAndTurnsFreely) {
  BeamParameters parameters;
  parameters.stiffness.axial = 6;
  BeamState state;
  state.mass = 2;
  const int steps = 2000;
  const double dt = 1.0 / steps;
  double x = 1, work = 0;
  BeamResult result;
  for (int n = 0; n < steps; ++n) {
    x += 0.5 * dt;
    result = advance_beam(parameters, {{{0, 0, 0}, {0, x, 0}}, {{0, 0, 0}, {0, 0.5, 0}}, {}, dt}, state, nullptr);
    work += result.work;
  }
  EXPECT_NEAR(state.forces.normal, 6 * std::log(1.5), 1e-7);
  EXPECT_NEAR(result.on.force_on_second.y, 6 * std::log(1.5), 1e-7);
  EXPECT_NEAR(work, 6 * (1.5 * std::log(1.5) - 0.5), 1e-6);  // integral of E A ln x
  EXPECT_NEAR(result.stable_step, 2 / std::sqrt(4 * 6 / (2 * 1.5)), 1e-12);
  const double before = state.forces.normal;
  advance_beam(parameters, {{{0, 0, 0}, {0.3, 1.4, 0.2}}, {{1, 2, 3}, {1, 2, 3}}, {}, dt}, state, nullptr);
  EXPECT_NEAR(state.forces.normal, before, 1e-12);
}

namespace {

double sum_fibres(const BeamFibres& fibres, double (*of)(const BeamFibre&)) {
  double sum = 0;
  for (int i = 0; i < fibres.count; ++i) sum += fibres.fibre[i].area * of(fibres.fibre[i]);
  return sum;
}

}  // namespace

TEST(BeamFibres, HaveAreaAndMomentsOfTheirSections) {
  const struct {
    BeamSection section;
    BeamFibres fibres;
  } cases[] = {{make_rectangle(2, 3), list_rectangle_fibres(2, 3)},
               {make_box(2, 3, 0.3), list_box_fibres(2, 3, 0.3)},
               {make_i_shape(2, 3, 0.3, 0.2), list_i_shape_fibres(2, 3, 0.3, 0.2)},
               {make_round(1.5), list_ring_fibres<3>(1.5, 0)},
               {make_tube(1.5, 1.2), list_ring_fibres<2>(1.5, 1.2)}};
  for (const auto& [section, fibres] : cases) {
    EXPECT_LE(fibres.count, most_beam_fibres);
    EXPECT_NEAR(sum_fibres(fibres, [](const BeamFibre&) { return 1.0; }), section.area, 1e-13);
    EXPECT_NEAR(sum_fibres(fibres, [](const BeamFibre& f) { return f.z * f.z; }), section.inertia_y, 1e-13);
    EXPECT_NEAR(sum_fibres(fibres, [](const BeamFibre& f) { return f.y * f.y; }), section.inertia_z, 1e-13);
    for (const auto of : {+[](const BeamFibre& f) { return f.y; }, +[](const BeamFibre& f) { return f.z; },
                          +[](const BeamFibre& f) { return f.y * f.z; }})
      EXPECT_NEAR(sum_fibres(fibres, of), 0, 1e-14);
  }
}

// The moment at which all of the section yields, over the yield stress.
TEST(BeamFibres, HaveThePlasticModulusOfTheirSections) {
  const auto about_y = [](const BeamFibres& fibres) {
    return sum_fibres(fibres, [](const BeamFibre& f) { return std::fabs(f.z); });
  };
  EXPECT_NEAR(about_y(list_rectangle_fibres(2, 3)), 2 * 9.0 / 4, 1e-13);
  EXPECT_NEAR(about_y(list_box_fibres(2, 3, 0.3)), 2 * 9.0 / 4 - 1.4 * 2.4 * 2.4 / 4, 1e-13);
  EXPECT_NEAR(about_y(list_i_shape_fibres(2, 3, 0.3, 0.2)), 2 * 9.0 / 4 - 1.8 * 2.4 * 2.4 / 4, 1e-13);
  EXPECT_NEAR(about_y(list_ring_fibres<3>(1.5, 0)), 4.0 / 3 * std::pow(1.5, 3), 0.013 * 4.5);
  EXPECT_NEAR(about_y(list_ring_fibres<2>(1.5, 1.2)), 4.0 / 3 * (std::pow(1.5, 3) - std::pow(1.2, 3)), 0.013 * 2.2);
}

TEST(BeamFibres, HardenAlongTheTangent) {
  const FibreLaw law{200, 2, 50};
  FibreState state;
  for (int n = 0; n < 100; ++n) state = law.advance(state, 1e-3);
  EXPECT_NEAR(state.stress, 2 + (0.1 - 0.01) * 200 * 50 / 250, 1e-12);  // tangent E H / (E + H)
  EXPECT_NEAR(state.plastic_strain, (state.stress - 2) / 50, 1e-12);
}

TEST(BeamLimits, SquaresAddUpAndCompressionDoesNotCount) {
  BeamLimits limits;
  EXPECT_EQ(find_beam_load(limits, {1e300, 1, 1, 1, 1, 1}), 0);
  limits.axial = 2;
  limits.shear_y = 4;
  limits.shear_z = 5;
  limits.torque = 10;
  limits.moment_y = 20;
  limits.moment_z = 50;
  EXPECT_DOUBLE_EQ(find_beam_load(limits, {1, -2, 1, 5, -4, 5}), 0.25 + 0.25 + 0.04 + 0.25 + 0.04 + 0.01);
  EXPECT_EQ(find_beam_load(limits, {-100, 0, 0, 0, 0, 0}), 0);
}

}  // namespace percuss::test::beam2_test
