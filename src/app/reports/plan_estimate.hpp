#pragma once
// How long a step would take on many ranks, from a plan of its decompositions and a few figures of the machine: the
// numbers of `percuss plan`. docs/plan.md has the formula.

#include <cstdint>
#include <vector>

#include "src/app/process/command_line.hpp"
#include "src/contact/plan/plan_contact.hpp"
#include "src/deck/deck.hpp"
#include "src/mesh/decomposition/plan_decomposition.hpp"

namespace percuss {

/// The parts of a step that determine its messages.
struct StepPattern {
  bool has_gravity = false;
  bool has_pairs = false;  // surfaces that may touch
  bool has_walls = false;
  bool reuses_search = true;
  bool has_rotations = false;
  bool has_contacts = true;  // where surfaces or walls may touch, whether some do
};

StepPattern find_step_pattern(const Deck& deck, const ContactPlanner& contact);

/// The plan for one number of ranks.
struct RanksPlan {
  int ranks = 1;
  DecompositionPlan mesh;
  ContactPlan contact;
};

/// Values of all ranks.
struct Spread {
  double least = 0, mean = 0, most = 0;
  double imbalance() const { return mean > 0 ? most / mean : 1; }
};

/// Loads and messages of the ranks in a step; messages and bytes are means over the steps between two searches.
struct RankSpreads {
  Spread chunks, elements, work, shared_nodes, neighbours, halo_messages, halo_bytes;
  Spread contact_points, contacts, contact_messages, contact_bytes, memory;  // work [hexahedra]; memory [byte]
};

/// Times of a step [s].
struct StepEstimate {
  double computing = 0, halo = 0, contact = 0, reductions = 0;
  double efficiency = 1;  // time of one rank over that of all of them together
  double step() const { return computing + halo + contact + reductions; }
};

/// Steps to the end of the deck, if all are as long as the first one [time unit of the deck], or what max_steps allows.
double count_steps(const TimeDeck& time, double first_step);

/// Reductions over all ranks in a step, a mean over the steps between two searches.
double count_reductions(const StepPattern& pattern, const PlanFigures& figures);

RankSpreads find_spreads(const RanksPlan& plan, const StepPattern& pattern, const PlanFigures& figures);

StepEstimate estimate_step(const RanksPlan& plan, const StepPattern& pattern, const PlanFigures& figures);

}  // namespace percuss
