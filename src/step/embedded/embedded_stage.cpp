#include "src/step/embedded/embedded_stage.hpp"

#include <algorithm>
#include <cmath>

#include "comm/all_reduce.hpp"
#include "src/index.hpp"
#include "src/output/checkpoint/checkpoint_archive.hpp"
#include "src/step/model/whole_mesh.hpp"

namespace percuss {
namespace {

/// The differences that may be left, as a share of the largest speed.
constexpr double settled_share = 1e-15;
constexpr int most_turns = 200;

double dot_all(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace

EmbeddedStage::EmbeddedStage(const ChunkedMesh& chunked, const Model& model)
    : chunked_(chunked),
      model_(model),
      rows_(model.embedded.nodes.size() * NodeRow::count),
      outcomes_(3 * model.embedded.nodes.size()),
      is_loose_(model.embedded.embedded.size(), 0),
      inverse_(model.embedded.nodes.size()),
      impulse_(model.embedded.nodes.size()),
      moved_(model.embedded.nodes.size()),
      diagonal_(model.embedded.embedded.size()),
      missing_(diagonal_.size()),
      search_(diagonal_.size()),
      applied_(diagonal_.size()),
      found_(diagonal_.size()),
      own_rows_("percuss::embedded_rows", model.embedded.owned_node.extent(0), NodeRow::count) {}

void EmbeddedStage::gather(const State& state) {
  gather_nodes(model_, state, {model_.embedded.owned_node, model_.embedded.owned_place}, own_rows_, rows_);
}

/// Of a node's value less that of its place in the solid.
double EmbeddedStage::find_difference(std::size_t row, const std::vector<double>& of_nodes) const {
  const EmbeddedNode& embedded = model_.embedded.embedded[row];
  const double own = of_nodes[at(embedded.node)];
  double difference = 0;  // corner by corner, so that equal ones leave nothing
  for (std::size_t i = 0; i < at(embedded.corner_count); ++i)
    difference += embedded.weights[i] * (own - of_nodes[at(embedded.corners[i])]);
  return difference;
}

/// An impulse to a node, and what is opposite to the corners.
void EmbeddedStage::push(std::size_t row, double impulse, std::vector<double>& of_nodes) const {
  const EmbeddedNode& embedded = model_.embedded.embedded[row];
  of_nodes[at(embedded.node)] += impulse;
  for (std::size_t i = 0; i < at(embedded.corner_count); ++i)
    of_nodes[at(embedded.corners[i])] -= embedded.weights[i] * impulse;
}

/// Differences without the constraint, and the diagonal of the system; 0: nothing can move.
void EmbeddedStage::start_direction(std::size_t k) {
  for (std::size_t n = 0; n < inverse_.size(); ++n) {
    inverse_[n] = value(static_cast<int>(n), NodeRow::inverse_mass + k);
    moved_[n] = value(static_cast<int>(n), NodeRow::velocity + k);
    impulse_[n] = 0;
  }
  for (std::size_t i = 0; i < diagonal_.size(); ++i) {
    const EmbeddedNode& embedded = model_.embedded.embedded[i];
    diagonal_[i] = missing_[i] = found_[i] = 0;
    if (is_loose_[i] != 0) continue;
    diagonal_[i] = inverse_[at(embedded.node)];
    for (std::size_t c = 0; c < at(embedded.corner_count); ++c)
      diagonal_[i] += embedded.weights[c] * embedded.weights[c] * inverse_[at(embedded.corners[c])];
    if (diagonal_[i] > 0) missing_[i] = -find_difference(i, moved_);
  }
}

/// Impulses p of the rows B of all nodes with B (v + M^-1 B^T p) = 0: conjugate gradients on B M^-1 B^T, scaled by its
/// diagonal (Saad, Iterative Methods for Sparse Linear Systems, 2003, algorithm 9.1).
void EmbeddedStage::solve_direction(std::size_t k) {
  start_direction(k);
  double speed = 0;
  for (const double v : moved_) speed = std::max(speed, std::abs(v));
  const auto largest = [](const std::vector<double>& all) {
    double most = 0;
    for (const double one : all) most = std::max(most, std::abs(one));
    return most;
  };
  const auto scale = [&](std::size_t i) { return diagonal_[i] > 0 ? missing_[i] / diagonal_[i] : 0; };
  std::fill(search_.begin(), search_.end(), 0);
  double before = 0;
  for (int turn = 0; turn < most_turns && largest(missing_) > settled_share * speed; ++turn) {
    double now = 0;
    for (std::size_t i = 0; i < missing_.size(); ++i) now += missing_[i] * scale(i);
    for (std::size_t i = 0; i < missing_.size(); ++i)
      search_[i] = scale(i) + (before > 0 ? now / before : 0) * search_[i];
    before = now;
    std::fill(moved_.begin(), moved_.end(), 0);
    for (std::size_t i = 0; i < search_.size(); ++i) push(i, search_[i], moved_);
    for (std::size_t n = 0; n < moved_.size(); ++n) moved_[n] *= inverse_[n];
    for (std::size_t i = 0; i < search_.size(); ++i) applied_[i] = diagonal_[i] > 0 ? find_difference(i, moved_) : 0;
    const double curvature = dot_all(search_, applied_);
    if (!(curvature > 0)) break;
    const double step = now / curvature;
    for (std::size_t i = 0; i < search_.size(); ++i) {
      found_[i] += step * search_[i];
      missing_[i] -= step * applied_[i];
    }
  }
  take_outcomes(k);
}

void EmbeddedStage::take_outcomes(std::size_t k) {
  for (std::size_t i = 0; i < found_.size(); ++i)
    if (found_[i] != 0) push(i, found_[i], impulse_);
  for (std::size_t n = 0; n < impulse_.size(); ++n) {
    const double velocity = value(static_cast<int>(n), NodeRow::velocity + k);
    outcomes_[3 * n + k] = {velocity + inverse_[n] * impulse_[n], impulse_[n]};
  }
}

void EmbeddedStage::follow_contact(State& state, const StepTimes& /*times*/, const ContactReport* /*contact*/) {
  gather(state);
  for (std::size_t k = 0; k < 3; ++k) solve_direction(k);
  book_joined_work(rows_, outcomes_, state);
  give_joined_motion(model_.embedded, outcomes_, state);
}

/// Nodes are free from when their solid, or what holds themselves, has died.
void EmbeddedStage::drop_vanished(State& state) {
  gather(state);
  const ErodedMesh& eroded = chunked_.mesh.eroded;
  std::vector<int> is_dead(is_loose_.size(), 0);
  for (std::size_t i = 0; i < is_dead.size(); ++i) {
    const EmbeddedNode& embedded = model_.embedded.embedded[i];
    const int element = find_local_element(chunked_, embedded.element);
    if (element >= 0 && eroded.any && at(element) < eroded.dead.size()) is_dead[i] = eroded.dead[at(element)];
  }
  all_reduce(model_.ranks, Reduce::largest, is_dead);
  for (std::size_t i = 0; i < is_dead.size(); ++i)
    is_loose_[i] = is_dead[i] != 0 || !(value(model_.embedded.embedded[i].node, NodeRow::mass) > 0) ? 1 : 0;
}

void EmbeddedStage::archive(CheckpointArchive& archive, State& state) {
  if (!model_.constraints.any()) archive.number("books/equal_work", state.books.equal_work);
}

}  // namespace percuss
