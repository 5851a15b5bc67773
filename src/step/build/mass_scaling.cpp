#include "src/step/build/mass_scaling.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comm/all_reduce.hpp"
#include "comm/exact_reduction.hpp"
#include "kernels/core/host_copy.hpp"
#include "src/error.hpp"
#include "src/step/beams/build_beams.hpp"
#include "src/step/build/chunks/build_shells.hpp"
#include "src/step/model/element_records.hpp"
#include "src/step/model/state.hpp"
#include "src/step/model/whole_mesh.hpp"

namespace percuss {
namespace {

bool is_asked_for(const Deck& deck) {
  return deck.time.mass_scaling || std::any_of(deck.parts.begin(), deck.parts.end(),
                                               [](const PartDeck& part) { return part.mass_scaling.has_value(); });
}

/// Other laws of solids take the change of volume from the density, which is not the material's own where mass is
/// added.
void refuse_other_laws(const Deck& deck, const ElementBlock& block, const MassScalingDeck& request) {
  if (!find_topology(block.topology).is_solid()) return;
  const auto part = static_cast<std::size_t>(block.part);
  const MaterialDeck& material = deck.materials[static_cast<std::size_t>(block.material)];
  const std::string& model = material.law.model;
  if ((model == "elastic" || model == "j2_plasticity") && !material.equation_of_state) return;
  throw InputError(
      fmt::format("{}: error: mass scaling of part '{}', whose material '{}' is {}{} (its law derives the volume from "
                  "the density): do not scale its mass, or use elastic or j2_plasticity without an equation of state",
                  deck.where(request.place), deck.parts[part].name, material.name, model,
                  material.equation_of_state ? " with an equation of state" : ""));
}

/// Step bound of each hexahedron, wedge and pyramid at rest in its first shape; of others 0.
std::vector<double> find_solid_bounds(const Model& model, const std::vector<double>& element_mass) {
  Model resting = model;
  resting.has_rotations = resting.has_beams =
      false;  // what shells and beams need beside follows from the scaled masses
  resting.element_mass = to_view("percuss::unscaled_mass", element_mass);
  resting.start_velocity = Rows3<double>("percuss::rest", static_cast<std::size_t>(model.node_count));
  const State state = make_initial_state(resting);
  StepWatch watch;
  watch.bound = Array<Real>("percuss::element_bounds", model.chunks.corner_slots.extent(0) / 8);
  watch.reference = watch.bound;
  watch.growth = Array<double>("percuss::growth", static_cast<std::size_t>(model.chunks.count));
  for (const HexBlocks& blocks : {model.sending_blocks, model.blocks}) {
    advance_elements(ExecSpace(), model.chunks, blocks, {state.x, state.v, 0, false, 0, watch}, state.chunk_fields());
  }
  for (const OnePointBlocks& blocks : {model.sending_one_point_blocks, model.one_point_blocks}) {
    advance_one_points(ExecSpace(), model.chunks, blocks, {state.x, state.v, 0, false, 0, watch}, state.chunk_fields());
  }
  const auto lanes = to_host(watch.bound);
  const HostChunks chunks(model.chunks);
  std::vector<double> bounds(element_mass.size());
  for (int c = 0; c < chunks.count; ++c) {
    for (int i = 0; i < count_elements(chunks, c); ++i)
      bounds[static_cast<std::size_t>(find_element(chunks, c, i))] = lanes(number_lane(chunks, c, i));
  }
  return bounds;
}

struct Least {
  double bound = INFINITY;
  std::int64_t scaled = 0, all = 0;
};

/// What a part gets, before it is added up over ranks.
struct PartShare {
  ExactSum mass, added;
  Least least;
};

void take_element(const MassScalingDeck& request, double bound, double& mass, PartShare& share) {
  ++share.least.all;
  share.mass.add(mass);
  share.least.bound = std::min(share.least.bound, bound);
  if (!(bound > 0 && bound < request.step)) return;  // one without volume is told elsewhere
  const double ratio = request.step / bound;
  const double scaled = ratio * ratio * mass;
  share.added.add(scaled - mass);
  ++share.least.scaled;
  mass = scaled;
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

/// What the nodes of an entry have together before, and how many they are.
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
  for (const ElementBlock& block : chunked.mesh.elements.blocks) {
    if (const auto* request = deck.find_mass_scaling(static_cast<std::size_t>(block.part)))
      refuse_other_laws(deck, block, *request);
  }
  std::vector<double> bounds = find_solid_bounds(model, element_mass);
  const std::vector<double> of_shells = find_shell_bounds(deck, chunked.mesh, element_mass);
  for (std::size_t e = 0; e < bounds.size(); ++e) bounds[e] = std::max(bounds[e], of_shells[e]);
  set_beam_bounds(deck, chunked.mesh, element_mass, bounds);
  std::vector<PartShare> shares(deck.parts.size());
  for (std::size_t e = 0; e < element_mass.size(); ++e) {
    const auto part = static_cast<std::size_t>(chunked.mesh.part_of(e));
    const MassScalingDeck* request = deck.find_mass_scaling(part);
    if (request != nullptr) take_element(*request, bounds[e], element_mass[e], shares[part]);
  }
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
