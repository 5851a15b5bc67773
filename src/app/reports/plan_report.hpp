#pragma once
// A plan in words: the answer of `percuss plan`. docs/plan.md explains every line.

#include <string>
#include <vector>

#include "src/app/reports/plan_estimate.hpp"

namespace percuss {

/// Input of the plan, the same for any number of ranks.
struct PlannedScene {
  const Deck& deck;
  std::int64_t elements = 0, nodes = 0, chunks = 0, contact_nodes = 0, contact_faces = 0;
  std::int64_t contacts = 0;  // that are planned for
  double first_step = 0;      // time unit of the deck, above zero
  StepPattern pattern;
};

/// A table with a column for each plan, and warnings below.
std::string format_plan(const PlannedScene& scene, const PlanFigures& figures, const std::vector<RanksPlan>& plans);

}  // namespace percuss
