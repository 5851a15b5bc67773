#pragma once
// The moving walls of a scene in the history. Contact moves them.

#include "src/contact/contact_stage.hpp"
#include "src/step/model/action.hpp"

namespace percuss {

class WallMotions : public Action {
 public:
  /// Both outlive this.
  WallMotions(const Deck& deck, const ContactStage& contact) : deck_(deck), contact_(contact) {}

  bool comes_between() const override { return false; }
  std::vector<HistoryColumn> list_columns() const override;
  void append_values(const State& state, std::vector<double>& row) override;

 private:
  const Deck& deck_;
  const ContactStage& contact_;
};

}  // namespace percuss
