#include "src/step/mass/mass_scaling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comm/all_reduce.hpp"
#include "comm/exact_reduction.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/error.hpp"
#include "src/step/elements/build_beams.hpp"
#include "src/step/elements/build_shells.hpp"
#include "src/step/elements/element_stage.hpp"
#include "src/step/model/element_bounds.hpp"
#include "src/step/model/state.hpp"
#include "src/step/model/whole_mesh.hpp"

namespace percuss {
namespace {

bool is_asked_for(const Deck& deck) {
  return deck.time.mass_scaling || std::any_of(deck.parts.begin(), deck.parts.end(),
                                               [](const PartDeck& part) { return part.mass_scaling.has_value(); });
}

/// Step bounds of solids at rest in their first shape.
class SolidBounds {
 public:
  /// The model outlives this. Collective.
  explicit SolidBounds(const Model& model) : resting_(without_others(model)), elements_(resting_) {
    resting_.start_velocity = Rows3<double>("percuss::rest", static_cast<std::size_t>(model.node_count));
  }

  /// Mass that each element needs; 0 for shells and beams. Collective.
  std::vector<double> find(const std::vector<double>& element_mass) {
    resting_.element_mass = to_view("percuss::mass_of_bounds", element_mass);
    const State state = make_initial_state(resting_);
    const ElementBounds bounds(resting_);
    const ElementMotion motion{state.x, state.v, 0, false, 0, bounds.watch};
    elements_.prepare(state, motion);
    elements_.advance(state, *resting_.sending, motion);
    elements_.advance(state, *resting_.others, motion);
    return bounds.list();
  }

 private:
  /// Copy of the model without rotations and other data: what shells and beams need follows from the scaled masses.
  static Model without_others(Model model) {
    model.has_rotations = model.has_beams = model.damps_stiffness = false;
    model.stiffness_damping = {};
    return model;
  }

  Model resting_;
  ElementStage elements_;
};

/// The mass that an element needs for the wanted step.
double find_wanted_mass(double step, double bound, double mass) {
  if (!(bound > 0 && bound < step)) return mass;  // one without volume is reported elsewhere
  const double ratio = step / bound;
  return ratio * ratio * mass;
}

/// Where solids share the mass of their nodes, an element that is given mass still lacks what it has to share: it is
/// given more until its bound is the step. masses: in and out. Collective.
void give_shared_mass(const Deck& deck, const ChunkedMesh& chunked, const Communicator& ranks, SolidBounds& solids,
                      std::vector<double>& masses) {
  constexpr int most_passes = 100;
  constexpr double tolerance = 1e-6;  // share of the step
  for (int pass = 0; pass < most_passes; ++pass) {
    const std::vector<double> bounds = solids.find(masses);
    int lacking = 0;
    for (std::size_t e = 0; e < masses.size(); ++e) {
      const MassScalingDeck* request = deck.find_mass_scaling(static_cast<std::size_t>(chunked.mesh.part_of(e)));
      if (request == nullptr || !(bounds[e] < request->step * (1 - tolerance))) continue;
      const double wanted = find_wanted_mass(request->step, bounds[e], masses[e]);
      lacking += wanted > masses[e] ? 1 : 0;
      masses[e] = wanted;
    }
    all_reduce(ranks, Reduce::sum, lacking);
    if (lacking == 0) return;
  }
}

struct Least {
  double bound = INFINITY;
  std::int64_t scaled = 0, all = 0;
};

/// Mass of a part, before it is added up over ranks.
struct PartShare {
  ExactSum mass, added;
  Least least;
};

/// bound, before: without scaling; mass: with it.
void take_element(double bound, double before, double mass, PartShare& share) {
  ++share.least.all;
  share.mass.add(before);
  share.least.bound = std::min(share.least.bound, bound);
  if (mass == before) return;
  share.added.add(mass - before);
  ++share.least.scaled;
}

AddedMass sum_over_ranks(const Communicator& ranks, const std::string& part, PartShare& share) {
  ExactSum sums[] = {share.mass, share.added};
  percuss::sum_over_ranks(ranks, sums);
  std::int64_t counts[] = {share.least.scaled, share.least.all};
  double bound = share.least.bound;
  all_reduce(ranks, Reduce::sum, counts);
  all_reduce(ranks, Reduce::least, bound);
  return {part, counts[0], counts[1], sums[0].round(), sums[1].round(), bound};
}

void check_limit(const Deck& deck, const MassScalingDeck& request, const AddedMass& part) {
  if (part.added <= request.max_added * part.mass) return;
  throw InputError(
      fmt::format("{}: error: a step of {:g} adds {:.3g} of its mass to part '{}' (more than max_added = {:g}; {} of "
                  "its {} elements have bounds below the step, the least {:.4g}): lower the step, make the mesh "
                  "coarser there, or raise max_added",
                  deck.where(request.place), request.step, part.added / part.mass, part.part, request.max_added,
                  part.scaled, part.elements, part.least_bound));
}

/// Mass and number of the nodes of an entry, before masses are added.
struct NodeTotal {
  double mass = 0;
  std::int64_t count = 0;
};

NodeTotal find_node_total(const ChunkedMesh& chunked, const Model& model, const std::vector<int>& nodes,
                          const std::vector<double>& mass) {
  ExactSum sums[1];
  NodeTotal total;
  for (const int n : nodes) {
    if (!owns_node(chunked, n)) continue;
    sums[0].add(mass[static_cast<std::size_t>(n)]);
    ++total.count;
  }
  sum_over_ranks(model.ranks, sums);
  all_reduce(model.ranks, Reduce::sum, total.count);
  total.mass = sums[0].round();
  return total;
}

}  // namespace

void scale_masses(const Deck& deck, const ChunkedMesh& chunked, std::vector<double>& element_mass, Model& model) {
  if (!is_asked_for(deck)) return;
  SolidBounds solids(model);
  std::vector<double> bounds = solids.find(element_mass);
  const std::vector<double> of_shells = find_shell_bounds(deck, chunked.mesh, element_mass);
  for (std::size_t e = 0; e < bounds.size(); ++e) bounds[e] = std::max(bounds[e], of_shells[e]);
  set_beam_bounds(deck, chunked.mesh, element_mass, bounds);
  const std::vector<double> before = element_mass;
  for (std::size_t e = 0; e < element_mass.size(); ++e) {
    const MassScalingDeck* request = deck.find_mass_scaling(static_cast<std::size_t>(chunked.mesh.part_of(e)));
    if (request != nullptr) element_mass[e] = find_wanted_mass(request->step, bounds[e], element_mass[e]);
  }
  if (model.mixes_solids) give_shared_mass(deck, chunked, model.ranks, solids, element_mass);
  std::vector<PartShare> shares(deck.parts.size());
  for (std::size_t e = 0; e < element_mass.size(); ++e)
    take_element(bounds[e], before[e], element_mass[e], shares[static_cast<std::size_t>(chunked.mesh.part_of(e))]);
  for (std::size_t p = 0; p < shares.size(); ++p) {
    const MassScalingDeck* request = deck.find_mass_scaling(p);
    if (request == nullptr) continue;
    model.added_masses.push_back(sum_over_ranks(model.ranks, deck.parts[p].name, shares[p]));
    check_limit(deck, *request, model.added_masses.back());
  }
}

std::vector<std::string> describe_added_masses(const Model& model) {
  std::vector<std::string> lines;
  double added = 0;
  for (const AddedMass& part : model.added_masses) {
    added += part.added;
    lines.push_back(fmt::format("mass scaling of part '{}': {:.4g} added to {:.4g} ({:.2g} %), to {} of {} elements",
                                part.part, part.added, part.mass, 100 * part.added / part.mass, part.scaled,
                                part.elements));
  }
  if (lines.empty()) return lines;
  lines.push_back(fmt::format("mass scaling in all: {:.4g} added to {:.4g} ({:.2g} %)", added, model.total_mass - added,
                              100 * added / (model.total_mass - added)));
  return lines;
}

void add_deck_masses(const Deck& deck, const ChunkedMesh& chunked, std::vector<double>& mass, Model& model) {
  if (deck.added_masses.empty()) return;
  const std::vector<double> of_elements = mass;
  std::vector<double> extra(mass.size(), 0);
  for (const AddedMassDeck& added : deck.added_masses) {
    const std::vector<int> nodes = select_nodes(chunked.mesh, deck, added.where);
    const NodeTotal total = find_node_total(chunked, model, nodes, of_elements);
    const bool evenly = added.spread == AddedMassDeck::Spread::evenly;
    for (const int node : nodes) {
      const auto n = static_cast<std::size_t>(node);
      extra[n] += evenly ? added.mass / static_cast<double>(total.count) : added.mass * (of_elements[n] / total.mass);
    }
    const std::string& name = added.where.name;
    model.mass_notes.push_back(fmt::format("added mass of {}: {:g} on {} nodes, {}, which have {:.4g} of their own",
                                           name.empty() ? "all nodes" : "'" + name + "'", added.mass, total.count,
                                           evenly ? "evenly" : "by their mass", total.mass));
  }
  for (std::size_t n = 0; n < mass.size(); ++n) mass[n] = of_elements[n] + extra[n];
  model.extra_mass = to_view("percuss::extra_mass", extra);
}

}  // namespace percuss
