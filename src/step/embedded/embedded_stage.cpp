#include "src/step/embedded/embedded_stage.hpp"

#include "comm/all_reduce.hpp"
#include "src/index.hpp"
#include "src/output/checkpoint/checkpoint_archive.hpp"
#include "src/step/model/whole_mesh.hpp"

namespace percuss {
namespace {

/// The differences that may be left, as a share of the largest speed.
constexpr ConstraintLimits limits_of_embedded{1e-15, 200};

}  // namespace

EmbeddedStage::EmbeddedStage(const ChunkedMesh& chunked, const Model& model)
    : chunked_(chunked),
      model_(model),
      keeps_work_(!model.constraints.any()),
      rows_(model, model.embedded),
      outcomes_(3 * model.embedded.nodes.size()),
      system_(limits_of_embedded),
      velocity_(model.embedded.nodes.size()),
      inverse_(model.embedded.nodes.size()) {
  for (const EmbeddedNode& embedded : model.embedded.embedded) {
    std::vector<ConstraintTerm> terms = {{embedded.node, 1}};
    for (std::size_t i = 0; i < at(embedded.corner_count); ++i)
      terms.push_back({embedded.corners[i], -embedded.weights[i]});
    system_.add_row(terms);
  }
}

void EmbeddedStage::solve_direction(std::size_t k) {
  for (std::size_t n = 0; n < inverse_.size(); ++n) {
    inverse_[n] = rows_.value(n, NodeRow::inverse_mass + k);
    velocity_[n] = rows_.value(n, NodeRow::velocity + k);
  }
  system_.solve(velocity_, inverse_, {});
  for (std::size_t n = 0; n < inverse_.size(); ++n) {
    const double impulse = system_.impulses()[n];
    outcomes_[3 * n + k] = {velocity_[n] + inverse_[n] * impulse, impulse};
  }
}

void EmbeddedStage::follow_contact(State& state, const StepTimes& /*times*/, const ContactReport* /*contact*/) {
  rows_.gather(state);
  for (std::size_t k = 0; k < 3; ++k) solve_direction(k);
  book_joined_work(rows_, outcomes_, state);
  give_joined_motion(model_.embedded, outcomes_, state);
}

/// Nodes are free from when their solid, or what holds themselves, has died.
void EmbeddedStage::drop_vanished(State& state) {
  rows_.gather(state);
  const ErodedMesh& eroded = chunked_.mesh.eroded;
  std::vector<int> is_dead(system_.count(), 0);
  for (std::size_t i = 0; i < is_dead.size(); ++i) {
    const EmbeddedNode& embedded = model_.embedded.embedded[i];
    const int element = find_local_element(chunked_, embedded.element);
    if (element >= 0 && eroded.any && at(element) < eroded.dead.size()) is_dead[i] = eroded.dead[at(element)];
  }
  all_reduce(model_.ranks, Reduce::largest, is_dead);
  for (std::size_t i = 0; i < is_dead.size(); ++i)
    system_.set_loose(i, is_dead[i] != 0 || !(rows_.value(model_.embedded.embedded[i].node, NodeRow::mass) > 0));
}

void EmbeddedStage::archive(CheckpointArchive& archive, State& state) {
  if (keeps_work_) archive.number("books/equal_work", state.books.equal_work);
}

std::vector<HistoryColumn> EmbeddedStage::list_columns() const {
  if (!keeps_work_) return {};
  return {equal_work_column()};
}

void EmbeddedStage::append_values(const State& state, std::vector<double>& row) {
  if (keeps_work_) row.push_back(state.books.equal_work);
}

}  // namespace percuss
