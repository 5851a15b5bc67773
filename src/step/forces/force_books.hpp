#pragma once
// The forces that a deck names in output.history.forces: means over the time between two rows of the history.
//
// Each step adds its impulses, as they change the momentum of the nodes in it, to exact sums. A row tells these sums
// over the time since the last row: no peak between rows is lost, and the column times the time between rows adds up to
// the momentum that was exchanged, to round-off. The first row, at time 0, has zeros.

#include <array>
#include <vector>

#include "src/contact/contact_stage.hpp"
#include "src/step/forces/force_sources.hpp"
#include "src/step/model/action.hpp"

namespace percuss {

class ForceBooks : public Action {
 public:
  /// Collective. Throws InputError with the deck's place, the same on all ranks, for a support without held nodes and a
  /// section that cuts no element. reactions: of each step on the rigid bodies, empty without. deck, contact
  /// and reactions outlive this.
  ForceBooks(const Deck& deck, const ChunkedMesh& chunked, const Model& model, ContactStage& contact,
             const std::vector<Wrench>& reactions);

  /// Books forces of supports and sections.
  void book_motion(State& state, const StepTimes& times) override;

  void set_switches(State& state) override { renew_supports(state); }
  void drop_vanished(State& state) override { renew_supports(state); }

  /// Sections need the places at n.
  bool comes_between() const override { return !sections_.empty(); }
  double bound_component(const State& /*state*/, double predicted) const override { return predicted; }

  /// A force that the checkpoint does not have begins with nothing at resume().
  void archive(CheckpointArchive& archive, State& state) override;
  void resume(const State& state) override;

  std::vector<HistoryColumn> list_columns() const override;
  /// Means since the last row.
  void append_values(const State& state, std::vector<double>& row) override;

  /// Whether each force of the deck has been other than 0 in a row so far, those before a restart included.
  const std::vector<unsigned char>& has_acted() const { return has_acted_; }

 private:
  void renew_supports(const State& state);
  std::array<ExactSum, 6>& find_sums(std::size_t force);
  ContactImpulse take_sums(std::size_t force);

  const Deck& deck_;
  const Communicator ranks_;
  ContactStage& contact_;
  const std::vector<Wrench>& reactions_;
  std::vector<SupportForce> supports_;
  std::vector<SectionForce> sections_;
  std::vector<std::array<ExactSum, 6>> sums_;  // of the supports, then of the sections; this rank's share
  std::vector<double> since_;                  // [forces of the deck] when each began, or was last in a row
  std::vector<unsigned char> has_acted_;       // [forces of the deck]
};

}  // namespace percuss
