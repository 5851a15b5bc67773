#include "src/app/reports/plan_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "src/mesh/decomposition/element_costs.hpp"

namespace percuss {
namespace {

// Memory of a run, from the peaks of runs (docs/plan.md): the program with its libraries, and what each element and
// each contact node or face adds; on several ranks contact keeps the decomposition, its copies and its messages too.
constexpr double program_bytes = 30e6, element_bytes = 900, contact_bytes_alone = 1200, contact_bytes_on_ranks = 3000;

struct Cost {
  double messages = 0, bytes = 0;
};

void add(const PlannedTraffic& traffic, double times, Cost& cost) {
  cost.messages += times * traffic.messages;
  cost.bytes += times * traffic.bytes;
}

/// Shells and beams swap moments besides forces.
Cost find_halo_cost(const RankPlan& rank, const StepPattern& pattern) {
  const double swaps = pattern.has_rotations ? 2 : 1;
  return {swaps * static_cast<double>(rank.neighbours), swaps * static_cast<double>(rank.bytes_sent())};
}

bool has_contact(const StepPattern& pattern) { return pattern.has_pairs || pattern.has_walls; }

/// Whether there are rows to enforce.
bool has_rows(const StepPattern& pattern) { return has_contact(pattern) && pattern.has_contacts; }

double find_steps_per_search(const StepPattern& pattern, const PlanFigures& figures) {
  return pattern.reuses_search ? figures.steps_per_search : 1;
}

/// Passes of the enforcement: the first guess and the iterations.
double count_passes(const PlanFigures& figures) { return figures.iterations + 1; }

Cost find_contact_cost(const RankPlan& mesh, const ContactRankPlan& contact, const StepPattern& pattern,
                       const PlanFigures& figures) {
  Cost cost;
  if (!has_contact(pattern)) return cost;
  add(contact.search, 1 / find_steps_per_search(pattern, figures), cost);
  add(contact.step, 1, cost);
  add(contact.pass, count_passes(figures), cost);
  // Velocities and impulses of shared nodes from their owners to the copies.
  if (!contact.is_touched) return cost;
  cost.messages += mesh.copy_receivers;
  cost.bytes += 2.0 * static_cast<double>(mesh.copies_sent * halo_slot_bytes);
  return cost;
}

double find_seconds(const Cost& cost, const PlanFigures& figures) {
  return cost.messages * figures.latency + cost.bytes / figures.bandwidth;
}

Spread find_spread(int ranks, const std::function<double(std::size_t)>& find) {
  Spread spread{find(0), 0, find(0)};
  for (std::size_t r = 0; r < static_cast<std::size_t>(ranks); ++r) {
    const double value = find(r);
    spread.least = std::min(spread.least, value);
    spread.most = std::max(spread.most, value);
    spread.mean += value / ranks;
  }
  return spread;
}

}  // namespace

StepPattern find_step_pattern(const Deck& deck, const ContactPlanner& contact) {
  const bool has_rotations = std::any_of(deck.parts.begin(), deck.parts.end(), [](const PartDeck& part) {
    return part.has_thickness() || (part.section && bends(*part.section));
  });
  return {deck.gravity.any(),        contact.points() > 0, !deck.walls.empty(),
          deck.contact.reuse_search, has_rotations,        contact.contacts() > 0};
}

double count_steps(const TimeDeck& time, double first_step) {
  const double to_end = std::ceil(time.end / first_step);
  return time.max_steps ? std::min(to_end, static_cast<double>(*time.max_steps)) : to_end;
}

double count_reductions(const StepPattern& pattern, const PlanFigures& figures) {
  double count = 1;                  // the step, failures and stops
  if (pattern.has_gravity) ++count;  // momentum
  if (!has_contact(pattern)) return count;
  ++count;                                                 // who has rows and touches foreign nodes
  if (has_rows(pattern)) count += 1 + figures.iterations;  // each iteration; what was done
  if (!pattern.has_pairs) return count;
  // A search: largest motion with the mean edge, places beside the cuts, which parts are reached, and pairs.
  count += 4 / find_steps_per_search(pattern, figures);
  return pattern.reuses_search ? count + 1 : count;  // whether the pairs of the last one still hold, in each step
}

RankSpreads find_spreads(const RanksPlan& plan, const StepPattern& pattern, const PlanFigures& figures) {
  const std::vector<RankPlan>& mesh = plan.mesh.ranks;
  const std::vector<ContactRankPlan>& contact = plan.contact.ranks;
  const auto spread = [&](const std::function<double(std::size_t)>& find) { return find_spread(plan.ranks, find); };
  const auto number = [](auto value) { return static_cast<double>(value); };
  const auto contact_cost = [&](std::size_t r) { return find_contact_cost(mesh[r], contact[r], pattern, figures); };
  const double contact_point_bytes = plan.ranks == 1 ? contact_bytes_alone : contact_bytes_on_ranks;
  RankSpreads spreads;
  spreads.chunks = spread([&](std::size_t r) { return number(mesh[r].chunks); });
  spreads.elements = spread([&](std::size_t r) { return number(mesh[r].elements); });
  spreads.work = spread([&](std::size_t r) { return number(mesh[r].work) / hexahedron_cost; });
  spreads.shared_nodes = spread([&](std::size_t r) { return number(mesh[r].shared_nodes); });
  spreads.neighbours = spread([&](std::size_t r) { return number(mesh[r].neighbours); });
  spreads.halo_messages = spread([&](std::size_t r) { return find_halo_cost(mesh[r], pattern).messages; });
  spreads.halo_bytes = spread([&](std::size_t r) { return find_halo_cost(mesh[r], pattern).bytes; });
  spreads.contact_points = spread([&](std::size_t r) { return number(contact[r].points()); });
  spreads.contacts = spread([&](std::size_t r) { return number(contact[r].contacts); });
  spreads.contact_messages = spread([&](std::size_t r) { return contact_cost(r).messages; });
  spreads.contact_bytes = spread([&](std::size_t r) { return contact_cost(r).bytes; });
  spreads.memory = spread([&](std::size_t r) {
    return program_bytes + element_bytes * number(mesh[r].elements) +
           contact_point_bytes * number(contact[r].nodes + contact[r].faces_here);
  });
  return spreads;
}

StepEstimate estimate_step(const RanksPlan& plan, const StepPattern& pattern, const PlanFigures& figures) {
  const auto slowest = [&](const std::function<double(std::size_t)>& find) {
    return find_spread(plan.ranks, find).most;
  };
  const RankSpreads spreads = find_spreads(plan, pattern, figures);
  const auto compute = [&](double work, double points) {
    return 1e-9 * (work * figures.element_ns + points * figures.contact_node_ns);
  };
  StepEstimate step;
  step.computing = compute(spreads.work.most, spreads.contact_points.most);
  if (plan.ranks == 1) return step;
  step.halo =
      slowest([&](std::size_t r) { return find_seconds(find_halo_cost(plan.mesh.ranks[r], pattern), figures); });
  step.contact = slowest([&](std::size_t r) {
    return find_seconds(find_contact_cost(plan.mesh.ranks[r], plan.contact.ranks[r], pattern, figures), figures);
  });
  step.reductions = count_reductions(pattern, figures) * std::ceil(std::log2(plan.ranks)) * figures.latency;
  step.efficiency = compute(spreads.work.mean, spreads.contact_points.mean) / step.step();
  return step;
}

}  // namespace percuss
