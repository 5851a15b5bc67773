#include "src/step/joints/joint_rows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "src/step/rigid/inertia.hpp"

namespace percuss {
namespace {

using Vector = Vector3<double>;

Joint make_joint() {
  Joint joint;
  joint.keeps_axis = true;
  joint.ends[0] = {0, {1, 0, 0}, {0, 0, 1}};
  joint.ends[1] = {1, {-1, 0, 0}, {0, 0, 1}};
  joint.length = 0.5;
  return joint;
}

/// Two bodies at (-1, 0, 0) and (1, 0, 0), whose joint is at the origin.
std::vector<RigidState> make_bodies() {
  std::vector<RigidState> bodies(2);
  bodies[0].center = {-1, 0, 0};
  bodies[1].center = {1, 0, 0};
  return bodies;
}

// Turns about the axis change no gap; one about x by an angle changes that of a side by its sine times the length.
TEST(JointRows, MeasureTheAngleBetweenTheAxes) {
  const Joint joint = make_joint();
  const auto now = make_bodies();
  const JointFrame frame = find_joint_frame(joint, now);
  auto next = now;
  next[0].orientation = turn(now[0].orientation, {0, 0, std::tan(0.1)});
  auto changes = find_gap_changes(joint, frame, now, next, 1);
  EXPECT_NEAR(changes[3], 0, 1e-16);
  EXPECT_NEAR(changes[4], 0, 1e-16);
  next[0].orientation = turn(now[0].orientation, {std::tan(0.1), 0, 0});
  changes = find_gap_changes(joint, frame, now, next, 1);
  EXPECT_NEAR(std::hypot(changes[3], changes[4]), 0.5 * std::sin(0.2), 1e-15);
}

/// A joint of each kind, whose first axis is z and whose second one, or turn, is x.
Joint make_joint(JointDeck::Kind kind) {
  const JointTraits& traits = find_traits(kind);
  Joint joint = make_joint();
  joint.point = traits.point;
  joint.keeps_axis = traits.keeps_axis;
  joint.keeps_turn = traits.keeps_turn;
  joint.ends[0].turn = {0, 0, 1};
  joint.ends[1].turn = {1, 0, 0};
  if (traits.keeps_axis) joint.ends[0].turn = {0, 1, 0};
  if (traits.has_lead()) {
    joint.ends[1].turn = {-1, 0, 0};
    joint.lead = 0.3 / (2 * std::numbers::pi);
  }
  return joint;
}

/// Bodies whose points have slid along z, and across it, as far as the kind lets them: a screw by a whole turn.
std::vector<RigidState> make_slid_bodies(JointDeck::Kind kind) {
  std::vector<RigidState> bodies = make_bodies();
  const JointTraits::Point point = find_traits(kind).point;
  if (point == JointTraits::Point::across) bodies[1].center = {1, 0, 0.3};
  if (point == JointTraits::Point::along) bodies[1].center = {1.2, -0.4, 0};
  return bodies;
}

class JointRowsOfAKind : public testing::TestWithParam<JointDeck::Kind> {};

std::string name_kind(const testing::TestParamInfo<JointDeck::Kind>& info) { return find_traits(info.param).word; }

INSTANTIATE_TEST_SUITE_P(Kinds, JointRowsOfAKind,
                         testing::Values(JointDeck::Kind::spherical, JointDeck::Kind::revolute,
                                         JointDeck::Kind::cylindrical, JointDeck::Kind::translational,
                                         JointDeck::Kind::planar, JointDeck::Kind::universal, JointDeck::Kind::fixed,
                                         JointDeck::Kind::screw),
                         name_kind);

// Six less the degrees of freedom that the kind leaves.
TEST_P(JointRowsOfAKind, AreAsManyAsItTakes) {
  constexpr int count[] = {3, 5, 4, 5, 3, 4, 6, 5};
  EXPECT_EQ(count_rows(make_joint(GetParam())), count[static_cast<std::size_t>(GetParam())]);
}

// The change of a gap is its rate times the step, to first order; also where the point has slid.
TEST_P(JointRowsOfAKind, RatesAreTheDerivativesOfGaps) {
  const Joint joint = make_joint(GetParam());
  const auto now = make_slid_bodies(GetParam());
  const JointFrame frame = find_joint_frame(joint, now);
  for (const double gap : frame.gap) EXPECT_NEAR(gap, 0, 1e-15);
  std::vector<JointRow> rows;
  add_joint_rows(joint, frame, now, rows);
  auto next = now;
  constexpr double dt = 1e-6;
  for (std::size_t b = 0; b < 2; ++b) {
    const double k = static_cast<double>(b) + 1;
    next[b].velocity = {1 * k, 2, 3 - k};
    next[b].spin = {4, 5 - 2 * k, 6 * k};
    next[b].orientation = turn(now[b].orientation, (0.5 * dt) * next[b].spin);
  }
  const auto changes = find_gap_changes(joint, frame, now, next, dt);
  const std::vector<double> rates = find_gap_rates(rows, next);
  for (std::size_t r = 0; r < rates.size(); ++r) EXPECT_NEAR(changes[r] / dt, rates[r], 1e-4) << r;
}

// The rows push both bodies oppositely at one point: no momentum is made.
TEST_P(JointRowsOfAKind, AreOppositeAtOnePoint) {
  std::vector<JointRow> rows;
  const auto bodies = make_slid_bodies(GetParam());
  const Joint joint = make_joint(GetParam());
  add_joint_rows(joint, find_joint_frame(joint, bodies), bodies, rows);
  for (const JointRow& row : rows) {
    Vector linear{0, 0, 0}, angular{0, 0, 0};  // about the origin
    for (std::size_t e = 0; e < 2; ++e) {
      linear = linear + row.unit[e].impulse;
      angular = angular + cross(bodies[e].center, row.unit[e].impulse) + row.unit[e].moment;
    }
    EXPECT_EQ(norm(linear), 0);
    EXPECT_NEAR(norm(angular), 0, 1e-15);
  }
}

// A unit impulse at the end of a rod moves it by 1 / m + r^2 / I there.
TEST(JointRows, MobilitiesAreThoseOfBothBodies) {
  Joint joint = make_joint();
  joint.keeps_axis = false;
  const auto bodies = make_bodies();
  std::vector<JointRow> rows;
  add_joint_rows(joint, find_joint_frame(joint, bodies), bodies, rows);
  const BodyResponse light{bodies[0].center, {0.5, 0.5, 0.5}, {1, 4, 4, 0, 0, 0}},
      heavy{bodies[1].center, {0.1, 0.1, 0.1}, {1, 0.25, 0.25, 0, 0, 0}};
  const std::vector<double> a = find_mobilities(rows, {light, heavy});
  EXPECT_DOUBLE_EQ(a[0], 0.5 + 0.1);
  EXPECT_DOUBLE_EQ(a[4], 0.5 + 4 + 0.1 + 0.25);
  EXPECT_DOUBLE_EQ(a[1], 0);
}

// Two masses of 1 at a distance of 2: 2 across; a thousandth of the sum of second moments, 2, about the line.
TEST(InertiaOfALine, HasAShareAboutTheLine) {
  const Symmetric3<double> i = to_inertia_of_line({2, 0, 0, 0, 0, 0});
  EXPECT_NEAR(i.xx, 2e-3, 1e-15);
  EXPECT_NEAR(i.yy, 2, 1e-15);
  EXPECT_NEAR(i.zz, 2, 1e-15);
  const Symmetric3<double> of_plane = to_inertia_of_line({2, 0.1, 0, 0, 0, 0});
  EXPECT_EQ(of_plane.xx, 0.1);  // as it is
}

}  // namespace
}  // namespace percuss
